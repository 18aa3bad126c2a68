"""Centre holes with a thread in the ends of shafts, DIN 332-2, and what a screw in them holds by its preload."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.units import Force, Length

PROOF_STRESS = ((16e-3, 580e6), (math.inf, 600e6))
"""Largest diameter [m] and proof stress S_p [Pa] of screws of class 8.8 (ISO 898-1)."""
PRELOAD = 0.7
"""Preload over what the proof stress bears [-]: usual for tightening by torque, an assumption."""


@dataclass(frozen=True)
class CentreHole:
    """A centre hole of form D with the thread of a screw."""

    over: Length
    """Ends of shafts above this diameter have it [m]."""
    to: Length
    """And up to this [m]."""
    thread: Length
    """d [m]."""
    pitch: Length
    """P [m]."""

    @property
    def designation(self) -> str:
        """Such as ``DIN 332 - D M12``."""
        return f"DIN 332 - D {self.screw}"

    @property
    def screw(self) -> str:
        """Such as ``M12``."""
        return f"M{1e3 * self.thread:g}"

    @property
    def preload(self) -> Force:
        """What a screw of class 8.8 clamps with, above which an end plate would part from the shaft [N].

        A_s = π/4 (d − 0.9382 P)², ISO 898-1.
        """
        area = math.pi / 4.0 * (self.thread - 0.9382 * self.pitch) ** 2
        return PRELOAD * area * next(stress for largest, stress in PROOF_STRESS if self.thread <= largest)


@cache
def centre_holes() -> tuple[CentreHole, ...]:
    """Return the centre holes for ends of 7 to 130 mm.

    Source: DIN 332-2:1983, form D. From 16 to 50 mm as Siemens prints them for ends of shafts (Flender gear units,
        catalogue MD 31.1, 2016, p. 7/2); thinner and thicker ends go on as those of electric motors usually do, for
        which no source was found.
    """
    return tuple(CentreHole(*(float(value) / 1e3 for value in row.values())) for row in data_rows("centre_holes.csv"))


def centre_hole(end: float) -> CentreHole | None:
    """Return the centre hole of a shaft's end; None of one thinner or thicker than the standard has.

    Args:
        end: Diameter [m].

    >>> centre_hole(0.038).designation, round(centre_hole(0.038).preload)  # 84.3 mm² of M12
    ('DIN 332 - D M12', 34212)
    """
    return next((hole for hole in centre_holes() if hole.over < end <= hole.to), None)
