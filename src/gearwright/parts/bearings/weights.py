"""What the parts of a rolling bearing weigh: rings, rolling elements and cage, as cylinders and spheres."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.parts.bearings.rolling_bearing import BearingGeometry

STEEL_DENSITY = 7850.0
"""Of rings and cages [kg/m³]."""
CERAMIC_DENSITY = 3200.0
"""Of silicon nitride rollers, Si3N4 [kg/m³]."""
CERAMIC_MODULUS, CERAMIC_POISSON = 310e9, 0.27
"""Elastic constants of silicon nitride [Pa, -]."""
STEEL_MODULUS, STEEL_POISSON = 206e9, 0.3
"""Elastic constants of bearing steel [Pa, -]."""
CAGE_SHARE = 0.4
"""Part of the room that rolling elements leave between the raceways which a cage takes, an assumption [-]."""


class RollingWeights(NamedTuple):
    """What each part of a rolling bearing weighs [kg]."""

    inner_ring: float
    """0 where the shaft is the raceway."""
    outer_ring: float
    """0 where the bore around is the raceway."""
    elements: float
    cage: float

    @property
    def total(self) -> float:
        """All together [kg]."""
        return sum(self)


def rolling_weights(
    inside: BearingGeometry, bore: float, outer_diameter: float, width: float, *, density: float = STEEL_DENSITY
) -> RollingWeights:
    """Return what the parts of a bearing weigh.

    Args:
        inside: Its rolling elements.
        bore: d [m].
        outer_diameter: D [m].
        width: Of the rings [m].
        density: Of the rolling elements [kg/m³].

    Source: cylinders between d, D_pw − D_w, D_pw + D_w and D; a cage that takes `CAGE_SHARE` of what is left between.
    """
    inner, outer = inside.pitch_diameter - inside.diameter, inside.pitch_diameter + inside.diameter
    length = inside.diameter if inside.kind.is_ball else inside.roller_length
    one = (2.0 / 3.0 if inside.kind.is_ball else 1.0) * math.pi / 4.0 * inside.diameter**2 * length
    elements = inside.elements * one * (inside.rows if not inside.kind.is_ball else 1)
    between = math.pi / 4.0 * (outer**2 - inner**2) * length * (inside.rows if not inside.kind.is_ball else 1)
    return RollingWeights(
        inner_ring=STEEL_DENSITY * math.pi / 4.0 * max(inner**2 - bore**2, 0.0) * width,
        outer_ring=STEEL_DENSITY * math.pi / 4.0 * max(outer_diameter**2 - outer**2, 0.0) * width,
        elements=density * elements,
        cage=STEEL_DENSITY * CAGE_SHARE * (between - elements),
    )


def turning_inertia(weights: RollingWeights, inside: BearingGeometry, outer_diameter: float) -> float:
    """Return the inertia of what turns when the outer ring does, at its speed [kg m²].

    Args:
        weights: Of the bearing's parts.
        inside: Its rolling elements.
        outer_diameter: D [m].

    Source: annulus of the outer ring, and a ring of elements and cage at D_pw that turns at (1 + γ)/2 of its speed.
    """
    outer = inside.pitch_diameter + inside.diameter
    ring = weights.outer_ring * (outer_diameter**2 + outer**2) / 8.0
    share = (1.0 + inside.curvature_ratio) / 2.0
    return ring + (weights.elements + weights.cage) * (inside.pitch_diameter / 2.0) ** 2 * share**2


def ceramic_share() -> float:
    """Return the load of a ceramic roller on steel over that of a steel one at the same pressure [-].

    Stiffer rollers press harder: so much less load gives the same pressure, and here it is taken for the same life.
    ISO 20056-1 takes ratings of hybrid bearings as of steel ones: this is on the safe side.

    Source: Hertz, line contact: p² ∝ Q/(1/E'_1 + 1/E'_2), with E' = E/(1 − ν²).

    >>> round(ceramic_share(), 2)
    0.84
    """
    steel = (1.0 - STEEL_POISSON**2) / STEEL_MODULUS
    return (steel + (1.0 - CERAMIC_POISSON**2) / CERAMIC_MODULUS) / (2.0 * steel)
