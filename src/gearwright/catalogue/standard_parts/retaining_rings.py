"""Retaining rings for shafts of DIN 471, normal type: grooves, and what their grooves bear."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.units import Force, Length

GROOVE_STRESS = 200e6 / 1.2
"""Pressure that the collar of a groove bears at a yield strength of 200 N/mm² [Pa]: F_N/A_N of DIN 471, to 2 %."""
COLLAR = 3.0
"""Shaft beyond a groove over the depth of the groove, at least: n/t of DIN 471 [-]."""


@dataclass(frozen=True)
class RetainingRing:
    """A ring with the groove that it sits in."""

    shaft: Length
    """d_1 [m]."""
    groove: Length
    """d_2 [m]."""
    groove_width: Length
    """m [m]."""
    thickness: Length
    """s [m]."""

    @property
    def designation(self) -> str:
        """Such as ``DIN 471 - 30 x 1.5``."""
        return f"DIN 471 - {1e3 * self.shaft:g} x {1e3 * self.thickness:g}"

    @property
    def room(self) -> Length:
        """What groove and collar take along the shaft, m + n [m]."""
        return self.groove_width + COLLAR * (self.shaft - self.groove) / 2.0

    @property
    def capacity(self) -> Force:
        """F_N, what the groove bears at a yield strength of 200 N/mm²; stronger shafts bear more, rings too [N]."""
        return GROOVE_STRESS * math.pi / 4.0 * (self.shaft**2 - self.groove**2)


@cache
def retaining_rings() -> tuple[RetainingRing, ...]:
    """Return the rings of DIN 471 for 8 to 100 mm.

    Source: DIN 471:2011, d_1, d_2, m, s, as two public tables have them alike.
    """
    return tuple(
        RetainingRing(*(float(value) / 1e3 for value in row.values())) for row in data_rows("retaining_rings.csv")
    )


def retaining_ring(shaft: float) -> RetainingRing | None:
    """Return the ring of a shaft; None where the standard has none of this diameter.

    Args:
        shaft: d_1 [m].

    >>> ring = retaining_ring(0.019)
    >>> ring.designation, round(ring.capacity)
    ('DIN 471 - 19 x 1.2', 4843)
    """
    return next((ring for ring in retaining_rings() if abs(ring.shaft - shaft) < 1e-6), None)
