"""How oil and dirt change the life of a rolling bearing: the factor a_ISO of ISO 281."""

from __future__ import annotations

import math
from enum import Enum
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.parts.bearings.rolling_bearing import BearingKind
from gearwright.units import RPM

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
