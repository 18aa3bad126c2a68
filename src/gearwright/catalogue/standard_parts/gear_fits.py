"""Fits of gears: tooth thicknesses by DIN 3967, centre distances by DIN 3964, as designs and drawings name them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

from gearwright.catalogue.standard_parts.fits import standard_tolerance
from gearwright.catalogue.tables import data_rows
from gearwright.errors import DesignError, Problem
from gearwright.units import Length

SERIES = ("a", "ab", "b", "bc", "c", "cd", "d", "e", "f", "g", "h")
"""Series of upper allowances, the thinnest teeth first (DIN 3967:1978, table 1)."""
TOLERANCES = tuple(range(21, 31))
"""Series of tolerances of tooth thickness, the finest first (DIN 3967:1978, table 2)."""
THICKNESS_FITS: Mapping[str, tuple[str, int]] = MappingProxyType(
    {f"{series}{tolerance}": (series, tolerance) for series in SERIES for tolerance in TOLERANCES}
)
"""Fit as it is written, such as ``cd25`` -> its two series."""
CENTRE_FITS: Mapping[str, int] = MappingProxyType({f"js{grade}": grade for grade in range(5, 12)})
"""Fit of a centre distance as it is written -> grade of ISO 286 (DIN 3964:1980)."""


@cache
def _ranges() -> tuple[dict[str, float], ...]:
    """Return DIN 3967's tables: ranges of reference diameters in mm, allowances and tolerances in µm."""
    return tuple({name: float(value) for name, value in row.items()} for row in data_rows("tooth_thickness.csv"))


def thickness_allowances(diameter: float, fit: str) -> tuple[Length, Length]:
    """Return lower and upper allowance of the normal tooth thickness, E_sni and E_sns [m].

    Args:
        diameter: Reference diameter d [m].
        fit: Such as ``cd25``.

    Raises:
        DesignError: If the tables do not reach so far.

    Source: DIN 3967:1978, tables 1 and 2; E_sni = E_sns − T_sn.

    >>> low, high = thickness_allowances(0.100, "cd27")
    >>> round(1e6 * low), round(1e6 * high)
    (-170, -70)
    """
    series, tolerance = THICKNESS_FITS[fit]
    for row in _ranges():
        if 1e3 * diameter <= row["to_mm"] + 1e-9:
            upper = 1e-6 * row[f"{series}_um"]
            return upper - 1e-6 * row[f"T{tolerance}_um"], upper
    message = f"{diameter:.4g} m given; tooth thickness allowances (DIN 3967) hold up to 10 m"
    raise DesignError([Problem("diameter", message)])


def centre_allowance(distance: float, fit: str) -> Length:
    """Return by how much a centre distance may be larger or smaller, A_a [m].

    Args:
        distance: a_w [m].
        fit: Such as ``js7``.

    Source: DIN 3964:1980: half the standard tolerance of ISO 286-1 to either side.

    >>> round(1e6 * centre_allowance(0.052, "js7"))
    15
    """
    return 0.5 * standard_tolerance(distance, CENTRE_FITS[fit])
