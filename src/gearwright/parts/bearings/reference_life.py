"""Life of a ball bearing under the loads of its single balls: the basic reference rating life of ISO/TS 16281."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gearwright.parts.bearings.rolling_bearing import BearingGeometry

Array = NDArray[np.float64]


def basic_reference_life(geometry: BearingGeometry, rating: float, force: Array) -> float:
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
