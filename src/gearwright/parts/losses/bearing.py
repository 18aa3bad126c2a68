"""Friction of rolling bearings."""

from __future__ import annotations

import math

from gearwright.units import RPM

CYLINDRICAL_ROLLER_FRICTION = 0.0011
"""μ of a cylindrical roller bearing with cage [-]; SKF rolling bearings catalogue, constant-coefficient estimate."""

LEAST_PRODUCT = 2000.0
"""ν n as which a smaller one counts in Palmgren's idle torque [mm²/(s min)]."""


def bearing_torque_constant(load: float, bore: float, friction: float = CYLINDRICAL_ROLLER_FRICTION) -> float:
    """Return the friction torque of a bearing by a constant coefficient [N m].

    Args:
        load: Equivalent load P [N].
        bore: d [m].
        friction: μ [-].

    Source: SKF rolling bearings catalogue: M = 0.5 μ P d.

    Valid for: load about a tenth of the dynamic rating, good lubrication, medium speed.

    >>> round(bearing_torque_constant(1000.0, 0.1), 3)
    0.055
    """
    return 0.5 * friction * load * bore


def bearing_torque_palmgren(
    load: float, mean_diameter: float, speed: float, *, viscosity: float, oil_factor: float, load_factor: float
) -> float:
    """Return the friction torque of a bearing as a part by the oil and a part by the load [N m].

    Args:
        load: Deciding load P_1 [N].
        mean_diameter: d_m [m].
        speed: Of the inner against the outer ring [rad/s].
        viscosity: Kinematic viscosity at the oil's temperature ν [m²/s].
        oil_factor: f_0 of the bearing's type and lubrication [-].
        load_factor: f_1 of the bearing's type and load [-].

    Source: Palmgren (1957), as in ISO/TR 14179-2:2001: M_0 = 1e-7 f_0 (ν n)^(2/3) d_m³, with ν n at least 2000, and
        M_1 = f_1 P_1 d_m, in mm, N mm, mm²/s and 1/min.

    >>> round(bearing_torque_palmgren(5000.0, 0.065, 157.08, viscosity=40e-6, oil_factor=2.0, load_factor=3e-4), 3)
    0.182
    """
    product = max(viscosity * 1e6 * abs(speed) / RPM, LEAST_PRODUCT) if speed else 0.0
    diameter = mean_diameter * 1e3
    idle = 1e-7 * oil_factor * math.pow(product, 2.0 / 3.0) * diameter**3
    return 1e-3 * (idle + load_factor * load * diameter)
