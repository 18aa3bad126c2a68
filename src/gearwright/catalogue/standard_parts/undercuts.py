"""Undercuts of form F at the shoulders of shafts whose seat and face are ground: DIN 509."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.errors import DesignError, Problem
from gearwright.units import Length

NEAR = 1e-9
"""Diameters that differ by less are the same [m]."""


@dataclass(frozen=True)
class Undercut:
    """An undercut of form F: it goes below the seat, and behind the face."""

    over: Length
    """Seats above this diameter have it [m]."""
    to: Length
    """And up to this [m]."""
    radius: Length
    """r [m]."""
    depth: Length
    """t_1, below the seat [m]."""
    width: Length
    """f, along the seat [m]."""
    face_depth: Length
    """t_2, behind the face [m]."""

    @property
    def designation(self) -> str:
        """Such as ``DIN 509 - F 1.2 x 0.2``."""
        return f"DIN 509 - F {1e3 * self.radius:g} x {1e3 * self.depth:g}"


@cache
def undercuts() -> tuple[Undercut, ...]:
    """Return the undercuts for seats of 1.6 mm up, of the preferred radii.

    Source: DIN 509:1998, form F, r of series 1, for parts with increased fatigue strength, up to 18 mm those of usual
        stress, as an extract for teaching has them (Scribd 415623829). Up to 18 mm depth and width are also those of
        HEIDENHAIN, CNC PILOT 4290, user's manual, 11.1.3, whose radii above are the smaller ones for usual stress.
    """
    return tuple(Undercut(*(float(value) / 1e3 for value in row.values())) for row in data_rows("undercuts.csv"))


def undercut(seat: float) -> Undercut:
    """Return the undercut of a seat.

    Args:
        seat: Diameter d_1 [m].

    Raises:
        DesignError: If the standard has none of this diameter.

    >>> undercut(0.045).designation, undercut(0.060).designation
    ('DIN 509 - F 1.2 x 0.2', 'DIN 509 - F 1.6 x 0.3')
    """
    found = next((each for each in undercuts() if each.over < seat - NEAR <= each.to), None)
    if found is None:
        message = f"DIN 509 has no undercut for seats of {1e3 * seat:g} mm; above 1.6 and up to 1000 mm are, or fillets"
        raise DesignError([Problem("shafting.shoulders", message)])
    return found
