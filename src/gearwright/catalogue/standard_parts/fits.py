"""Limits and fits of ISO 286 for seats on shafts, and the tolerance classes that bearing seats usually take."""

from __future__ import annotations

from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.errors import DesignError, Problem, near
from gearwright.parts.bearings import BearingKind
from gearwright.units import Length

SMALLEST, LARGEST = 0.006, 3.150
"""Sizes that the table covers: above the first, up to the second [m]."""
LARGEST_M6 = 0.100
"""Bore of roller bearings up to which m6 is usual, n6 above [m]."""
SEAT_SOURCE = "rotating load on the inner ring, normal load: DIN 5425-1"
"""Where the tolerance classes of bearing seats come from."""


@cache
def _ranges() -> tuple[dict[str, float], ...]:
    """Return the table of ISO 286-1: ranges in mm, grades and lower deviations in µm."""
    return tuple({name: float(value) for name, value in row.items()} for row in data_rows("limits_and_fits.csv"))


def _range(diameter: float) -> dict[str, float]:
    for row in _ranges():
        if row["over_mm"] < 1e3 * diameter <= row["to_mm"] + 1e-9:
            return row
    message = f"{1e3 * diameter:.4g} mm given; the table holds above 6 up to 3150 mm"
    raise DesignError([Problem("diameter", message)])


def standard_tolerance(diameter: float, grade: int) -> Length:
    """Return the width of a standard tolerance grade [m] (ISO 286-1:2010, table 1).

    Args:
        diameter: Nominal size [m].
        grade: Of IT5 to IT11 [-].

    Raises:
        DesignError: If the table has no such size or grade.

    >>> round(1e6 * standard_tolerance(0.060, 6))
    19
    """
    return 1e-6 * _entry(_range(diameter), f"IT{grade}_um")


def shaft_limits(diameter: float, tolerance_class: str) -> tuple[Length, Length]:
    """Return lower and upper limit deviation of a shaft [m] (ISO 286-1:2010, tables 1 and 5).

    Args:
        diameter: Nominal size [m].
        tolerance_class: Such as ``k6``; letters h, k, m, n and p, with grades 5 to 7 for k.

    Raises:
        DesignError: If the table has no such size or class.

    Source: p up to 180 mm: Narayana, Kannaiah, Venkata Reddy, Machine Drawing, table 15.2; above 500 mm: DME, Mold
        Bases & Plates 2020, table 5; between them from memory, IT7 and 4 to 5 µm more as beside it.

    >>> tuple(round(1e6 * limit) for limit in shaft_limits(0.060, "m6"))
    (11, 30)
    """
    letter, row = tolerance_class[:1], _range(diameter)
    width = 1e-6 * _entry(row, f"IT{tolerance_class[1:]}_um")
    if letter == "h":
        return -width, 0.0
    low = 1e-6 * _entry(row, f"{letter}_um")
    return low, low + width


def _entry(row: dict[str, float], name: str) -> float:
    if name not in row:
        known = [column.removesuffix("_um") for column in row if column.endswith("_um")]
        raise DesignError([Problem("tolerance", f"the table has no {name.removesuffix('_um')}; {near(name, known)}")])
    return row[name]


def seat_tolerance(kind: BearingKind, bore: float) -> str:
    """Return the usual tolerance class of a shaft under an inner ring that turns with its load.

    Args:
        kind: Of the bearing.
        bore: d [m].

    Returns:
        k6 for balls; m6 for rollers, n6 above 100 mm (`SEAT_SOURCE`).
    """
    if kind.is_ball:
        return "k6"
    return "m6" if bore <= LARGEST_M6 + 1e-9 else "n6"
