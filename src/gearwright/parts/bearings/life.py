"""Life of rolling bearings by ISO 281: basic, for a reliability, of several together, and by the load of every ball."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.parts.bearings.rolling_bearing import BearingGeometry, BearingKind

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
