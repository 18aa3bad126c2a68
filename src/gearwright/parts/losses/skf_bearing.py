"""Friction torque of rolling bearings by SKF's model: rolling and sliding, by the film that the oil makes."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.parts.bearings import BearingKind, taper_factors
from gearwright.units import RPM

OIL_JET = 3e-8
"""K_rs of a low oil bath or an oil jet [-]."""
BOUNDARY_FRICTION, STARTING_FRICTION = 0.12, 0.15
"""μ_bl in motion and at rest [-]."""
FULL_FILM_FRICTION = {BearingKind.CYLINDRICAL: 0.02, BearingKind.TAPER: 0.002}
"""μ_EHL by kind; of ball bearings in mineral oil 0.05 [-]."""
_BALL_FRICTION = 0.05
_GEOMETRY = {
    BearingKind.DEEP_GROOVE: 3.1, BearingKind.FOUR_POINT: 3.1, BearingKind.CYLINDRICAL: 5.1, BearingKind.TAPER: 6.0,
}  # fmt: skip
"""K_Z [-]."""


class SeriesFriction(NamedTuple):
    """What a series of bearings loses, as its makers fit it."""

    oil_factor: float
    """f_0 and f_0r [-]."""
    load_factor: float
    """f_1 and f_1r [-]."""
    rolling: tuple[float, float, float]
    """R_1, R_2, R_3 in mm, N and 1/min."""
    sliding: tuple[float, float, float]
    """S_1, S_2, S_3 in mm, N and 1/min."""


class RunningBearing(NamedTuple):
    """A bearing under load."""

    kind: BearingKind
    bore: float
    """d [m]."""
    outer_diameter: float
    """D [m]."""
    static_rating: float
    """C_0 [N]."""
    contact_angle: float
    """α, of taper bearings [rad]."""
    radial: float
    """F_r [N]."""
    axial: float
    """F_a [N]."""


def bearing_torque_skf(
    bearing: RunningBearing, friction: SeriesFriction, speed: float, *, viscosity: float, replenishment: float = OIL_JET
) -> float:
    """Return the friction torque of a bearing without seals by its rolling and its sliding [N m].

    Args:
        bearing: Under load.
        friction: Of its series.
        speed: Of the inner against the outer ring [rad/s].
        viscosity: Kinematic viscosity at the oil's temperature ν [m²/s].
        replenishment: K_rs [-]; 6e-8 for grease and oil-air.

    Source: SKF, The SKF model for calculating the frictional moment: φ_ish φ_rs G_rr (ν n)^0.6 + G_sl μ_sl, in mm, N,
        1/min and mm²/s, with constants by series.

    Valid for: mineral oil, normal clearance; without the drag of an oil bath and without seals.
    """
    turns, oil = abs(speed) / RPM, viscosity * 1e6
    mean = 1e3 * (bearing.bore + bearing.outer_diameter) / 2.0
    rolling = _rolling(bearing, friction, mean, turns) * math.pow(oil * turns, 0.6)
    heated = 1.0 / (1.0 + 1.84e-9 * math.pow(turns * mean, 1.28) * math.pow(oil, 0.64))
    sides = 1e3 * (bearing.outer_diameter - bearing.bore), 1e3 * (bearing.outer_diameter + bearing.bore)
    starved = math.exp(-replenishment * oil * turns * sides[1] * math.sqrt(_GEOMETRY[bearing.kind] / (2.0 * sides[0])))
    slides = _sliding(bearing, friction, mean, turns) * _sliding_friction(bearing.kind, oil * turns, mean)
    return 1e-3 * (heated * starved * rolling + slides)


def _sliding_friction(kind: BearingKind, product: float, mean: float) -> float:
    """Return μ_sl between boundary lubrication and a full film [-]."""
    boundary = math.exp(-2.6e-8 * math.pow(product, 1.4) * mean)
    dry = BOUNDARY_FRICTION if product else STARTING_FRICTION
    return boundary * dry + (1.0 - boundary) * FULL_FILM_FRICTION.get(kind, _BALL_FRICTION)


def _rolling(bearing: RunningBearing, friction: SeriesFriction, mean: float, turns: float) -> float:
    """Return G_rr."""
    first, second, third = friction.rolling
    radial, axial = abs(bearing.radial), abs(bearing.axial)
    if bearing.kind is BearingKind.CYLINDRICAL:
        return first * math.pow(mean, 2.41) * math.pow(radial, 0.31)
    if bearing.kind is BearingKind.TAPER:
        return first * math.pow(mean, 2.38) * math.pow(radial + second * _slope(bearing) * axial, 0.31)
    if bearing.kind is BearingKind.FOUR_POINT:
        return first * math.pow(mean, 1.97) * math.pow(radial + third * mean**4 * turns**2 + second * axial, 0.54)
    pushed = second / math.sin(_loaded_angle(bearing)) * axial if axial else 0.0
    return first * math.pow(mean, 1.96) * math.pow(radial + pushed, 0.54)


def _sliding(bearing: RunningBearing, friction: SeriesFriction, mean: float, turns: float) -> float:
    """Return G_sl."""
    first, second, third = friction.sliding
    radial, axial = abs(bearing.radial), abs(bearing.axial)
    if bearing.kind is BearingKind.CYLINDRICAL:
        return first * math.pow(mean, 0.9) * axial + second * mean * radial
    if bearing.kind is BearingKind.TAPER:
        return first * math.pow(mean, 0.82) * (radial + second * _slope(bearing) * axial)
    if bearing.kind is BearingKind.FOUR_POINT:
        flung = radial + third * mean**4 * turns**2
        return first * math.pow(mean, 0.26) * (math.pow(flung, 4.0 / 3.0) + second * math.pow(axial, 4.0 / 3.0))
    if not axial:
        return first * math.pow(mean, -0.26) * math.pow(radial, 5.0 / 3.0)
    pushed = second * math.pow(mean, 1.5) / math.sin(_loaded_angle(bearing)) * axial**4
    return first * math.pow(mean, -0.145) * math.pow(radial**5 + pushed, 1.0 / 3.0)


def _slope(bearing: RunningBearing) -> float:
    """Return Y of a taper bearing [-]."""
    return taper_factors(bearing.contact_angle).axial


def _loaded_angle(bearing: RunningBearing) -> float:
    """Return the contact angle α_F of a deep groove bearing under thrust [rad]."""
    return math.radians(24.6 * math.pow(abs(bearing.axial) / bearing.static_rating, 0.24))
