"""Basic and modified rating life of rolling bearings by ISO 281, and equivalent loads."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple

import numpy as np

from gearwright.base import RPM, DesignError, Floats, Problem
from gearwright.parts.bearings.rolling_bearing import BearingGeometry, BearingKind

# ----------------------------------------------------------------------------------------------------------------------
# Equivalent loads of rolling bearings: factors e, X, Y of ISO 281 and X_0, Y_0 of ISO 76, mean load of a spectrum.
#
# Two tables give the factors of a deep groove ball bearing: ISO 281:2007 over f_0 F_a/C_0, and the older
# ISO/R 281:1962 over F_a/C_0, which textbooks print. Both are read by linear interpolation, and beyond their ends they
# keep their last value.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Life of rolling bearings by ISO 281: basic, for a reliability, of several together, and by the load of every ball.
# ----------------------------------------------------------------------------------------------------------------------


MILLION = 1e6
"""Turns of one unit of rating life [-]."""
_RELIABILITY = (0.90, 0.95, 0.96, 0.97, 0.98, 0.99, 0.995, 0.999)
_LIFE_SHARE = (1.0, 0.64, 0.55, 0.47, 0.37, 0.25, 0.175, 0.093)


def life_exponent(kind: BearingKind) -> float:
    """Return the exponent p of L_10 = (C/P)^p [-].

    Args:
        kind: Of bearing [-].

    Source: ISO 281:2007, 5.3 and 7.3: 3 for point contact, 10/3 for line contact.
    """
    return 3.0 if kind.is_ball else 10.0 / 3.0


def pair_factor(kind: BearingKind, count: int) -> float:
    """Return the dynamic rating of equal bearings side by side over that of one [-].

    Args:
        kind: Of bearing [-].
        count: i, of the bearings that share the load [-].

    Source: ISO 281:2007, 5.1.2 and 7.1.2: i^0.7 of ball and i^(7/9) of roller bearings.

    >>> round(pair_factor(BearingKind.CYLINDRICAL, 2), 4)
    1.7145
    """
    return math.pow(count, 0.7 if kind.is_ball else 7.0 / 9.0)


def basic_life(rating: float, load: float, kind: BearingKind) -> float:
    """Return the basic rating life L_10 that 90 % of the bearings reach [10⁶ turns].

    Args:
        rating: C [N].
        load: P [N].
        kind: Of bearing [-].

    Source: ISO 281:2007, 5.3 and 7.3: (C/P)^p.

    Raises:
        DesignError: If nothing loads the bearing.

    >>> basic_life(30e3, 6e3, BearingKind.DEEP_GROOVE)
    125.0
    """
    if load <= 0.0:
        raise DesignError([Problem("load", f"{load:g} N given; a rating life needs a load above 0 N")])
    return math.pow(rating / load, life_exponent(kind))


def life_time(life: float, speed: float) -> float:
    """Return a life in seconds of running [s].

    Args:
        life: [10⁶ turns].
        speed: Of one ring against the other, its sign does not count [rad/s].

    Source: L/ω.

    >>> from gearwright.units import RPM
    >>> round(life_time(125.0, 1500 * RPM) / 3600.0)
    1389
    """
    return life * MILLION * 2.0 * math.pi / abs(speed) if speed else math.inf


def reliability_factor(reliability: float) -> float:
    """Return the share a_1 of the rating life that a given part of the bearings reaches [-].

    Args:
        reliability: Part that survives, 0.90 to 0.999 [-].

    Source: ISO 281:2007, table 12, linear in between.

    Raises:
        DesignError: If the standard gives no value.

    >>> reliability_factor(0.99)
    0.25
    """
    if not _RELIABILITY[0] <= reliability <= _RELIABILITY[-1]:
        message = f"{reliability:g} given; allowed: {_RELIABILITY[0]:g} to {_RELIABILITY[-1]:g}"
        raise DesignError([Problem("reliability", message)])
    return float(np.interp(reliability, _RELIABILITY, _LIFE_SHARE))


def weibull_slope(kind: BearingKind) -> float:
    """Return the slope of the lives' scatter [-].

    Args:
        kind: Of bearing [-].

    Source: ISO/TR 1281-1:2021: 10/9 for point contact, 9/8 for line contact.
    """
    return 10.0 / 9.0 if kind.is_ball else 9.0 / 8.0


def system_life(lives: Sequence[float], slope: float | Sequence[float] = 10.0 / 9.0) -> float:
    """Return the life that 90 % of a set of bearings reach with none of them failed; unit as given.

    Args:
        lives: L_10 of every bearing, all in one unit of time [any].
        slope: Weibull slope e of all of them, or of each [-].

    Source: product of Weibull's survival laws: Σ (L/L_i)^e_i = 1 (Harris, Rolling Bearing Analysis).

    >>> round(system_life([1000.0, 1000.0], 1.0))
    500
    """
    single, slopes = np.broadcast_arrays(np.asarray(lives, dtype=float), np.asarray(slope, dtype=float))
    life = float(single.min())  # Newton from above, where the sum is at least 1
    if math.isinf(life):
        return life
    for _ in range(100):
        parts = (life / single) ** slopes
        step = math.log(parts.sum()) * parts.sum() / float(parts @ slopes)
        life *= math.exp(-step)
        if abs(step) < 1e-14:
            break
    return life


def basic_reference_life(geometry: BearingGeometry, rating: float, force: Floats) -> float:
    """Return the basic reference rating life L_10r under a given share of the balls [10⁶ turns of the inner ring].

    Args:
        geometry: Rolling elements and grooves [m].
        rating: C_r [N].
        force: Loads of the balls [N], (Z,).

    Source: ISO/TS 16281:2008, eqs (19)-(20) and (25)-(29), inner ring turning.
    """
    gamma, count = geometry.curvature_ratio, geometry.elements
    rings = 1.044 * ((1.0 - gamma) / (1.0 + gamma)) ** 1.72 * geometry.conformity_ratio**0.41
    ball = rating / (count * math.cos(geometry.contact_angle) ** 0.7 * geometry.rows**0.7)
    inner = ball / 0.407 * (1.0 + rings ** (10.0 / 3.0)) ** 0.3
    outer = ball / 0.389 * (1.0 + rings ** (-10.0 / 3.0)) ** 0.3
    on_inner = np.mean(force**3) ** (1.0 / 3.0)
    on_outer = np.mean(force ** (10.0 / 3.0)) ** 0.3
    return float(((on_inner / inner) ** (10.0 / 3.0) + (on_outer / outer) ** (10.0 / 3.0)) ** -0.9)


# ----------------------------------------------------------------------------------------------------------------------
# How oil and dirt change the life of a rolling bearing: the factor a_ISO of ISO 281.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST_MODIFICATION = 50.0
"""a_ISO above which the standard does not go [-] (ISO 281:2007, 9.3.3)."""


class _Modification(NamedTuple):
    """Constants of a_ISO = 0.1 (1 − (a − b/κ^c)^d (e_C C_u/P)^f)^−g."""

    clean: float
    film: tuple[float, float]
    """b below and above κ = 0.4."""
    inner: float
    outer: float
    last: float


THINNEST = 0.1
"""Least viscosity ratio κ for which ISO 281 gives a life [-]."""
_BALL = _Modification(2.5671, (2.2649, 1.9987), 0.83, 1.0 / 3.0, 9.3)
_ROLLER = _Modification(1.5859, (1.3993, 1.2348), 1.0, 0.4, 9.185)
_FILM_EXPONENTS = ((0.4, 0.054381), (1.0, 0.19087), (math.inf, 0.071739))
"""Greatest κ of each range and its exponent c (ISO 281:2007, eqs (31)-(36)); from 4 on κ counts as 4."""


class Cleanliness(Enum):
    """Contamination factor e_C for mean diameters below 100 mm and from there on: middle of ISO 281:2007, table 13."""

    EXTREME = (1.0, 1.0)
    """Particles as thin as the oil film: laboratory."""
    HIGH = (0.7, 0.85)
    """Oil through a very fine filter; bearings greased for life and sealed."""
    NORMAL = (0.55, 0.7)
    """Oil through a fine filter; greased for life and shielded."""
    SLIGHT = (0.4, 0.5)
    """Slightly dirty oil."""
    TYPICAL = (0.2, 0.3)
    """No seals, wear from other parts, coarse filters."""
    SEVERE = (0.05, 0.05)
    """Dirty surroundings, poor seals."""


class OilFilter(Enum):
    """Circulating oil by its filter: constants of e_C = a κ^0.68 D_pw^0.55 (1 − b/D_pw^(1/3)); ISO 281:2007, A.4."""

    BETA_6_200 = (0.0864, 0.5663)
    """β_6(c) = 200, oil -/13/10 by ISO 4406."""
    BETA_12_200 = (0.0432, 0.9987)
    """β_12(c) = 200, oil -/15/12."""
    BETA_25_75 = (0.0288, 1.6329)
    """β_25(c) ≥ 75, oil -/17/14."""
    BETA_40_75 = (0.0216, 2.3362)
    """β_40(c) ≥ 75, oil -/19/16."""


def reference_viscosity(speed: float, pitch_diameter: float) -> float:
    """Return the viscosity ν_1 that parts the surfaces well enough [m²/s].

    Args:
        speed: [rad/s].
        pitch_diameter: D_pw [m].

    Source: ISO 281:2007, 9.3: 45000 n^-0.83 D_pw^-0.5, from 1000 rpm 4500 n^-0.5 D_pw^-0.5 (mm²/s, mm).

    Raises:
        DesignError: If the bearing stands still: no film forms then.

    >>> round(1e6 * reference_viscosity(3000 * RPM, 0.0725), 3)
    9.649
    """
    rpm, diameter = abs(speed) / RPM, 1e3 * pitch_diameter
    if rpm == 0.0:
        raise DesignError([Problem("speed", "0 rpm given; no oil film forms in a bearing at rest")])
    law = 45000.0 * math.pow(rpm, -0.83) if rpm < 1000.0 else 4500.0 / math.sqrt(rpm)
    return 1e-6 * law / math.sqrt(diameter)


def contamination_factor(oil_filter: OilFilter, viscosity_ratio: float, pitch_diameter: float) -> float:
    """Return the contamination factor e_C of circulating oil [-].

    Args:
        oil_filter: Of the circuit [-].
        viscosity_ratio: κ [-].
        pitch_diameter: D_pw [m].

    Source: ISO 281:2007, annex A.4.
    """
    slope, coarse = oil_filter.value
    diameter = 1e3 * pitch_diameter
    film = min(slope * math.pow(viscosity_ratio, 0.68) * math.pow(diameter, 0.55), 1.0)
    return max(film * (1.0 - coarse / math.cbrt(diameter)), 0.0)


def cleanliness_factor(cleanliness: Cleanliness, pitch_diameter: float) -> float:
    """Return the contamination factor e_C for a word about how clean the bearing is [-].

    Args:
        cleanliness: [-].
        pitch_diameter: D_pw [m].

    Source: ISO 281:2007, table 13.
    """
    small, large = cleanliness.value
    return small if pitch_diameter < 0.1 else large


def life_modification(clean_share: float, viscosity_ratio: float, kind: BearingKind) -> float:
    """Return the life modification factor a_ISO [-].

    Args:
        clean_share: e_C C_u / P [-].
        viscosity_ratio: κ = ν/ν_1; above 4 it counts as 4 [-].
        kind: Of bearing [-].

    Source: ISO 281:2007, 9.3.3, eqs (31)-(36).

    Valid for: κ ≥ 0.1 and a_ISO ≤ 50.

    Raises:
        DesignError: If the oil is too thin for the standard.
    """
    if viscosity_ratio < THINNEST:
        message = f"κ = {viscosity_ratio:.3g} is below 0.1, where ISO 281 gives no life; take a thicker oil"
        raise DesignError([Problem("viscosity_ratio", message)])
    law, kappa = (_BALL if kind.is_ball else _ROLLER), min(viscosity_ratio, 4.0)
    exponent = next(c for greatest, c in _FILM_EXPONENTS if kappa <= greatest)
    film = law.clean - law.film[kappa >= _FILM_EXPONENTS[0][0]] / kappa**exponent
    remainder = 1.0 - film**law.inner * clean_share**law.outer
    if remainder <= 0.0:
        return LARGEST_MODIFICATION
    return min(0.1 * math.pow(remainder, -law.last), LARGEST_MODIFICATION)
