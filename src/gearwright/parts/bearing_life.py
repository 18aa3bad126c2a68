"""Life of rolling bearings by ISO 281: basic, for a reliability, modified for oil and dirt; and of several together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.parts.rolling_bearing import BearingKind
from gearwright.units import RPM

MILLION = 1e6
"""Turns of one unit of rating life [-]."""
LARGEST_MODIFICATION = 50.0
"""a_ISO above which the standard does not go [-] (ISO 281:2007, 9.3.3)."""

_RELIABILITY = (0.90, 0.95, 0.96, 0.97, 0.98, 0.99, 0.995, 0.999)
_LIFE_SHARE = (1.0, 0.64, 0.55, 0.47, 0.37, 0.25, 0.175, 0.093)


class _Modification(NamedTuple):
    """Constants of a_ISO = 0.1 (1 − (a − b/κ^c)^d (e_C C_u/P)^f)^−g."""

    clean: float
    film: tuple[float, float]
    """b below and above κ = 0.4."""
    inner: float
    outer: float
    last: float


_BALL = _Modification(2.5671, (2.2649, 1.9987), 0.83, 1.0 / 3.0, 9.3)
_ROLLER = _Modification(1.5859, (1.3993, 1.2348), 1.0, 0.4, 9.185)
_FILM_EXPONENTS = ((0.4, 0.054381), (1.0, 0.19087), (4.0, 0.071739))
"""Greatest κ of each range and its exponent c (ISO 281:2007, eqs (31)-(36))."""


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


def life_exponent(kind: BearingKind) -> float:
    """Return the exponent p of L_10 = (C/P)^p [-].

    Args:
        kind: Of bearing [-].

    Source: ISO 281:2007, 5.3 and 7.3: 3 for point contact, 10/3 for line contact.
    """
    return 3.0 if kind.is_ball else 10.0 / 3.0


def basic_life(rating: float, load: float, kind: BearingKind) -> float:
    """Return the basic rating life L_10 that 90 % of the bearings reach [10⁶ turns].

    Args:
        rating: C [N].
        load: P [N].
        kind: Of bearing [-].

    Source: ISO 281:2007, eqs (5) and (21).

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

    >>> round(life_time(125.0, 1500 * RPM) / 3600.0)
    1389
    """
    return life * MILLION * 2.0 * math.pi / abs(speed) if speed else math.inf


def rating_for_life(load: float, life: float, kind: BearingKind) -> float:
    """Return the dynamic rating that a wanted life asks for [N].

    Args:
        load: P [N].
        life: L_10 [10⁶ turns].
        kind: Of bearing [-].

    Source: ISO 281:2007, eqs (5) and (21) solved for C.
    """
    return load * math.pow(life, 1.0 / life_exponent(kind))


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


def reference_viscosity(speed: float, pitch_diameter: float) -> float:
    """Return the viscosity ν_1 that parts the surfaces well enough [m²/s].

    Args:
        speed: [rad/s].
        pitch_diameter: D_pw [m].

    Source: ISO 281:2007, eqs (28) and (29): 45000 n^-0.83 D_pw^-0.5, from 1000 rpm 4500 n^-0.5 D_pw^-0.5 (mm²/s, mm).

    >>> round(1e6 * reference_viscosity(3000 * RPM, 0.0725), 3)
    9.649
    """
    rpm, diameter = abs(speed) / RPM, 1e3 * pitch_diameter
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
    if viscosity_ratio < 0.1:
        message = f"κ = {viscosity_ratio:.3g} is below 0.1, where ISO 281 gives no life; take a thicker oil"
        raise DesignError([Problem("viscosity_ratio", message)])
    law, kappa = (_BALL if kind.is_ball else _ROLLER), min(viscosity_ratio, 4.0)
    exponent = next(each for greatest, each in _FILM_EXPONENTS if kappa <= greatest)
    film = law.clean - law.film[kappa >= _FILM_EXPONENTS[0][0]] / kappa**exponent
    rest = 1.0 - film**law.inner * clean_share**law.outer
    if rest <= 0.0:
        return LARGEST_MODIFICATION
    return min(0.1 * math.pow(rest, -law.last), LARGEST_MODIFICATION)


def weibull_slope(kind: BearingKind) -> float:
    """Return the slope of the lives' scatter [-].

    Args:
        kind: Of bearing [-].

    Source: ISO/TR 1281-1:2021: 10/9 for point contact, 9/8 for line contact.
    """
    return 10.0 / 9.0 if kind.is_ball else 9.0 / 8.0


def system_life(lives: Sequence[float], slope: float = 10.0 / 9.0) -> float:
    """Return the life that 90 % of a set of bearings reach with none of them failed; unit as given.

    Args:
        lives: L_10 of every bearing, all in one unit of time [any].
        slope: Weibull slope e of all of them [-].

    Source: product of Weibull's survival laws: (Σ L^-e)^(-1/e) (Harris 2001, eq. 18.214).
    """
    return float(np.sum(np.asarray(lives, dtype=float) ** -slope) ** (-1.0 / slope))
