"""Equivalent loads of rolling bearings: factors e, X, Y of ISO 281 and X_0, Y_0 of ISO 76, mean load of a spectrum.

Two tables give the factors of a deep groove ball bearing: ISO 281:2007 over f_0 F_a/C_0, and the older
ISO/R 281:1962 over F_a/C_0, which textbooks print. Both are read by linear interpolation, and beyond their ends they
keep their last value.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.errors import DesignError, Problem


class LoadFactors(NamedTuple):
    """What turns radial and axial force into one equivalent load."""

    limit: float
    """e: F_a/F_r up to which the axial force weighs as in the low branch [-]."""
    radial: float
    """X beyond the limit [-]."""
    axial: float
    """Y beyond the limit [-]."""
    axial_low: float = 0.0
    """Y up to the limit, where X is 1 [-]."""


class StaticFactors(NamedTuple):
    """What turns radial and axial force into one static equivalent load."""

    radial: float
    """X_0 [-]."""
    axial: float
    """Y_0 [-]."""


class FactorTable(NamedTuple):
    """e and Y of a deep groove ball bearing over its relative axial load; X is 0.56."""

    relative_load: tuple[float, ...]
    """f_0 F_a/C_0, or F_a/C_0 for ISO/R 281 [-]."""
    limit: tuple[float, ...]
    """e [-]."""
    axial: tuple[float, ...]
    """Y [-]."""


ISO281_2007 = FactorTable(
    (0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89),
    (0.19, 0.22, 0.26, 0.28, 0.30, 0.34, 0.38, 0.42, 0.44),
    (2.30, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.00),
)
"""ISO 281:2007, table 3, normal clearance; relative load f_0 F_a/C_0r."""
ISO_R281_1962 = FactorTable(
    (0.025, 0.04, 0.07, 0.13, 0.25, 0.5),
    (0.22, 0.24, 0.27, 0.31, 0.37, 0.44),
    (2.0, 1.8, 1.6, 1.4, 1.2, 1.0),
)
"""ISO/R 281:1962, as German textbooks print it; relative load F_a/C_0r."""

FOUR_POINT = LoadFactors(0.95, 0.60, 1.07, 0.66)
"""Four-point contact, α = 35°: ISO 281:2007, table 3, double row."""
FOUR_POINT_STATIC = StaticFactors(1.0, 0.58)
"""Four-point contact, α = 35°: ISO 76:2006, table 2, double row."""
DEEP_GROOVE_STATIC = StaticFactors(0.6, 0.5)
"""ISO 76:2006, table 2."""


def deep_groove_factors(relative_load: float, table: FactorTable = ISO281_2007) -> LoadFactors:
    """Return e, X and Y of a deep groove ball bearing.

    Args:
        relative_load: f_0 F_a/C_0 for `ISO281_2007`, F_a/C_0 for the others [-].
        table: Which one to read [-].

    Source: ISO 281:2007, table 3, linear interpolation.

    >>> round(deep_groove_factors(0.355, ISO_R281_1962).limit, 4)  # as the Colibri report reads it
    0.3994
    """
    loads = table.relative_load
    if not loads[0] < relative_load < loads[-1]:
        end = -1 if relative_load >= loads[-1] else 0
        return LoadFactors(table.limit[end], 0.56, table.axial[end])
    right = bisect_right(loads, relative_load)
    beyond, step = relative_load - loads[right - 1], loads[right] - loads[right - 1]
    limit, axial = (
        (column[right] - column[right - 1]) / step * beyond + column[right - 1] for column in (table.limit, table.axial)
    )
    return LoadFactors(limit, 0.56, axial)


def taper_factors(contact_angle: float) -> LoadFactors:
    """Return e, X and Y of a single row taper roller bearing.

    Args:
        contact_angle: α [rad].

    Source: ISO 281:2007, table 8: e = 1.5 tan α, X = 0.4, Y = 0.4 cot α.
    """
    return LoadFactors(1.5 * math.tan(contact_angle), 0.4, 0.4 / math.tan(contact_angle))


def taper_static_factors(contact_angle: float) -> StaticFactors:
    """Return X_0 and Y_0 of a single row taper roller bearing.

    Args:
        contact_angle: α [rad].

    Source: ISO 76:2006, table 5: X_0 = 0.5, Y_0 = 0.22 cot α.
    """
    return StaticFactors(0.5, 0.22 / math.tan(contact_angle))


def equivalent_load(radial: float, axial: float, factors: LoadFactors) -> float:
    """Return the dynamic equivalent load P [N].

    Args:
        radial: F_r [N].
        axial: F_a, its sign does not count [N].
        factors: e, X and Y [-].

    Source: ISO 281:2007, 5.2 and 7.2.
    """
    along = abs(axial)
    if along <= factors.limit * radial:
        return radial + factors.axial_low * along
    return factors.radial * radial + factors.axial * along


def static_equivalent_load(radial: float, axial: float, factors: StaticFactors) -> float:
    """Return the static equivalent load P_0 [N].

    Args:
        radial: F_r [N].
        axial: F_a, its sign does not count [N].
        factors: X_0 and Y_0 [-].

    Source: ISO 76:2006, 5.2 and 7.2: the larger of X_0 F_r + Y_0 F_a and F_r.
    """
    return max(factors.radial * radial + factors.axial * abs(axial), radial)


def static_safety(rating: float, load: float) -> float:
    """Return the static safety factor s_0 [-].

    Args:
        rating: C_0 [N].
        load: P_0 [N].

    Source: ISO 76:2006, clause 9: C_0/P_0, at least 1 for balls and 1.5 for rollers in smooth running.

    Raises:
        DesignError: If nothing loads the bearing.
    """
    if load <= 0.0:
        raise DesignError([Problem("load", f"{load:g} N given; a safety needs a load above 0 N")])
    return rating / load


def mean_load(loads: Sequence[float], turns: Sequence[float], exponent: float = 3.0) -> float:
    """Return the constant load that tires a bearing as a spectrum of loads does [N].

    Args:
        loads: Equivalent loads of the spectrum [N].
        turns: Turns, or their shares, at each load [-].
        exponent: p of the life, 3 for balls and 10/3 for rollers [-].

    Source: Palmgren 1924, linear damage: (Σ P^p N / Σ N)^(1/p).

    Raises:
        DesignError: If the spectrum does not turn.
    """
    weights = np.asarray(turns, dtype=float)
    total = weights.sum()
    if weights.min(initial=0.0) < 0.0 or total <= 0.0:
        raise DesignError([Problem("turns", f"{list(turns)} given; none is below 0, and some are above")])
    return float((np.asarray(loads, dtype=float) ** exponent @ weights / total) ** (1.0 / exponent))


def taper_pair_thrusts(
    radial: tuple[float, float], axial: float, factors: tuple[LoadFactors, LoadFactors]
) -> tuple[float, float]:
    """Return the axial forces in two taper roller bearings that hold one shaft [N].

    Each bearing turns part of its radial load into thrust, F_r/(2 Y), towards its own open side. The one that is pushed
    together bears what is left over; the other keeps its own thrust. Neither is preloaded.

    Args:
        radial: F_r of both [N].
        axial: External force on the shaft, positive if it pushes the first together [N].
        factors: Of both [-].

    Source: induced thrust F_r/(2 Y) with ISO 281:2007, table 8; equilibrium along the shaft.
    """
    thrusts = [force / (2.0 * factor.axial) for force, factor in zip(radial, factors, strict=True)]
    return max(thrusts[0], thrusts[1] + axial), max(thrusts[1], thrusts[0] - axial)
