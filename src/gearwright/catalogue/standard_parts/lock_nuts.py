"""Lock nuts for shafts, series KM of DIN 981, with their lock washers MB of DIN 5406, and what their threads bear."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.standard_parts.thread_ends import CORE, NUT_CORE
from gearwright.catalogue.tables import data_rows
from gearwright.units import Force, Length, Mass

YIELD = 200e6
"""Yield strength of a nut at least [Pa]: that for which DIN 471 tells what grooves bear; makers tell none."""
EVEN = 0.5
"""Mean over largest load of the turns of a nut's thread [-], an assumption: the first turn takes the most."""


@dataclass(frozen=True)
class LockNut:
    """A nut with the washer that locks it in a slot of the shaft."""

    thread: Length
    """d [m]."""
    pitch: Length
    """P [m]."""
    face: Length
    """Outer diameter of the face that presses, d_1 [m]."""
    outer: Length
    """[m]"""
    width: Length
    """B [m]."""
    mass: Mass
    """Of the nut [kg]."""
    washer_outer: Length
    """Over its tabs before they are bent [m]."""
    washer: Length
    """Thickness of the washer [m]."""
    washer_mass: Mass
    """[kg]"""

    @property
    def designation(self) -> str:
        """Such as ``KM 6 with MB 6``."""
        size = next(k for k, nut in enumerate(lock_nuts()) if nut == self)
        return f"KM {size} with MB {size}"

    @property
    def cut(self) -> str:
        """Its thread, such as ``M30 x 1.5``."""
        return f"M{1e3 * self.thread:g} x {1e3 * self.pitch:g}"

    @property
    def core(self) -> Length:
        """Core diameter of the shaft's thread, d − 1.2269 P (ISO 68-1) [m]."""
        return self.thread - CORE * self.pitch

    @property
    def bore(self) -> Length:
        """What it can be slid over, D_1 = d − 1.0825 P (ISO 724) [m]."""
        return self.thread - NUT_CORE * self.pitch

    @property
    def room(self) -> Length:
        """What washer, nut and one turn of thread beyond it take along the shaft [m]."""
        return self.washer + self.width + self.pitch

    @property
    def capacity(self) -> Force:
        """What its thread bears before it is sheared off at the yield strength of the nut [N].

        F = ½ · 0.6 R_e · 7/8 π d (B − P): threads of the nut sheared at their major diameter, where 7/8 of a turn is
        metal (ISO 68-1), a turn of it run out, half of the rest borne evenly.
        """
        return EVEN * 0.6 * YIELD * 0.875 * math.pi * self.thread * (self.width - self.pitch)


@cache
def lock_nuts() -> tuple[LockNut, ...]:
    """Return the nuts KM 0 to KM 20, for threads of 10 to 100 mm, in order.

    Source: NKE, general catalogue, pp. 1004 and 1014; IBB prints the same diameters and widths.
    """
    return tuple(_nut({name: float(cell) for name, cell in row.items()}) for row in data_rows("lock_nuts.csv"))


def _nut(row: dict[str, float]) -> LockNut:
    lengths = ("thread", "pitch", "face", "outer", "width", "washer_outer", "washer")
    return LockNut(
        **{name: row[f"{name}_mm"] / 1e3 for name in lengths},
        mass=row["mass_kg"],
        washer_mass=row["washer_mass_g"] / 1e3,
    )


def lock_nut(thread: float) -> LockNut | None:
    """Return the nut of a thread; None where the series has none of this diameter.

    Args:
        thread: d [m].

    >>> nut = lock_nut(0.030)
    >>> nut.designation, nut.cut, round(nut.capacity)
    ('KM 6 with MB 6', 'M30 x 1.5', 27214)
    """
    return next((nut for nut in lock_nuts() if abs(nut.thread - thread) < 1e-6), None)
