"""What an inspector measures: span over teeth, and distance over balls or pins."""

from __future__ import annotations

import math

from gearwright.errors import DesignError, Problem
from gearwright.parts.gears.cylindrical_gear import CylindricalGear
from gearwright.parts.gears.involute import involute, involute_angle


def span_measurement(gear: CylindricalGear, spanned: int) -> float:
    """Return the span measurement (base tangent length) over a number of teeth of an external gear.

    Args:
        gear: External gear.
        spanned: Number of teeth between the anvils k [-].

    Returns:
        W_k [m], nominal, without backlash allowance.

    Source: ISO 21771:2007, W_k = m_n cos α_n [(k − 0.5) π + z inv α_t + 2 x tan α_n].

    >>> round(1e3 * span_measurement(CylindricalGear(20, 1e-3, 0.01), 3), 4)
    7.6604
    """
    if gear.side < 0:
        raise DesignError([Problem("teeth", f"{gear.teeth} given; measure an internal gear between balls instead")])
    angle = gear.rack.pressure_angle
    pitches = (spanned - 0.5) * math.pi + gear.teeth * involute(gear.transverse_pressure_angle)
    return gear.module * math.cos(angle) * (pitches + 2.0 * gear.profile_shift * math.tan(angle))


def spanned_teeth(gear: CylindricalGear) -> int:
    """Return the number of teeth to span so that the anvils touch near the middle of the flank.

    Args:
        gear: External gear.

    Source: the base tangent length whose half meets the cylinder of diameter d + 2 x m_n (ISO 21771:2007); where two
        numbers are as near, the smaller, as tables of spans have it (27 teeth of 20 degrees: 3).

    >>> spanned_teeth(CylindricalGear(20, 1e-3, 0.01)), spanned_teeth(CylindricalGear(27, 1e-3, 0.01))
    (3, 3)
    """
    middle = gear.pitch_radius + gear.profile_shift * gear.module
    length = 2.0 * math.sqrt(max(middle**2 - gear.base_radius**2, 0.0)) / math.cos(gear.base_helix_angle)
    pitches = (length - span_measurement(gear, 1)) / (math.pi * gear.module * math.cos(gear.rack.pressure_angle))
    return max(2, math.ceil(round(pitches, 9) + 0.5))


def ball_measurement(gear: CylindricalGear, diameter: float) -> float:
    """Return the distance over two balls in opposite tooth spaces; between them for an internal gear.

    Args:
        gear: External or internal gear.
        diameter: Diameter of the balls D_M [m].

    Returns:
        M_dK [m], nominal, without backlash allowance.

    Source: ISO 21771:2007, inv α_Kt = ± D_M/(|z| m_n cos α_n) + inv α_t ∓ (π − 4 x tan α_n)/(2 |z|), upper signs for
        external gears; cos(π/2z) for odd numbers of teeth.
    """
    teeth, angle = abs(gear.teeth), gear.rack.pressure_angle
    ball = diameter / (teeth * gear.module * math.cos(angle))
    half_space = (math.pi - 4.0 * gear.profile_shift * math.tan(angle)) / (2.0 * teeth)
    centre = involute_angle(involute(gear.transverse_pressure_angle) + gear.side * (ball - half_space))
    across = 2.0 * gear.base_radius / math.cos(centre)
    across *= math.cos(0.5 * math.pi / teeth) if teeth % 2 else 1.0
    return across + gear.side * diameter
