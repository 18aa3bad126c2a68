"""What oil and oil mist cost, and the oil that carries the heat away."""

from __future__ import annotations

import math

OIL_DENSITY = 950.0
"""Of a turbine oil [kg/m³]."""
TURBINE_OIL = (26e-6, 5e-6)
"""Kinematic viscosity of a 5 cSt turbine oil at 40 °C and 100 °C [m²/s], typical of a MIL-PRF-23699 oil."""
_ARRANGEMENT = 0.2
"""A_g of ISO/TR 14179-1 [-]."""
LEAST_HELIX = math.radians(10.0)
"""Helix angle as which a smaller one counts in churning [rad]."""
LEAST_MODULE = 1.0
"""Module below which the roughness of the teeth is held [mm]."""


def windage_power(radius: float, face_width: float, speed: float, *, viscosity: float) -> float:
    """Return the windage of one gear in the oil mist of a dry-sump gearbox [W].

    Args:
        radius: Pitch radius R [m].
        face_width: F [m].
        speed: [rad/s].
        viscosity: Dynamic viscosity of the oil μ_0 [Pa s].

    Source: Anderson and Loewenthal, NASA TP-1622 (1980): 2.82e-7 (1 + 2.3 F/R) n^2.8 R^4.6 (0.028 μ_0 + 0.019)^0.2 kW
        with n in 1/min and μ_0 in mPa s.
    """
    turns = abs(speed) * 30.0 / math.pi
    mist = math.pow(0.028 * viscosity * 1e3 + 0.019, 0.2)
    return 1e3 * 2.82e-7 * (1.0 + 2.3 * face_width / radius) * math.pow(turns, 2.8) * math.pow(radius, 4.6) * mist


def windage_power_dawson(
    diameter: float, face_width: float, speed: float, *, module: float, enclosure: float = 1.0
) -> float:
    """Return the windage of one gear in air [W].

    Args:
        diameter: Root diameter D [m].
        face_width: F [m].
        speed: [rad/s].
        module: M [m].
        enclosure: λ, 1 in the open, about 0.6 to 0.7 in a housing [-].

    Source: Dawson (1984): n^2.9 (0.16 D^3.9 + D^2.9 F^0.75 M^1.15) Φ λ 1e-20 kW with n in 1/min, lengths in mm, Φ = 1
        for air without oil.

    Valid for: large spur gears in air; oil mist is denser.
    """
    turns, wide, broad, teeth = abs(speed) * 30.0 / math.pi, 1e3 * diameter, 1e3 * face_width, 1e3 * module
    surfaces = 0.16 * wide**3.9 + wide**2.9 * broad**0.75 * teeth**1.15
    return float(1e3 * 1e-20 * enclosure * turns**2.9 * surfaces)


def churning_power(
    diameter: float, face_width: float, speed: float, *, viscosity: float, dip: float, module: float,
    helix_angle: float = 0.0,
) -> float:  # fmt: skip
    """Return the churning of one gear, its teeth and both its sides, in an oil bath [W].

    Args:
        diameter: D [m].
        face_width: b [m].
        speed: [rad/s].
        viscosity: Kinematic viscosity at the oil's temperature ν [m²/s].
        dip: f_g: 0 out of the oil, 1 fully in it [-].
        module: Transverse module m_t [m].
        helix_angle: β, taken as 10° at least [rad].

    Source: ISO/TR 14179-1:2001: f_g ν n³ D^4.7 (7.37 b R_f/√tan β + 1.474 D)/(A_g 1e26) kW with the teeth's roughness
        R_f = 7.93 - 4.648/m_t and A_g = 0.2, in mm²/s, 1/min and mm.
    """
    turns, wide = abs(speed) * 30.0 / math.pi, diameter * 1e3
    teeth = (7.93 - 4.648 / max(module * 1e3, LEAST_MODULE)) / math.sqrt(math.tan(max(helix_angle, LEAST_HELIX)))
    surfaces = 7.37 * face_width * 1e3 * teeth + 1.474 * wide
    return 1e3 * dip * viscosity * 1e6 * turns**3 * math.pow(wide, 4.7) * surfaces / (_ARRANGEMENT * 1e26)


def oil_flow(heat: float, rise: float, *, density: float = OIL_DENSITY, heat_capacity: float = 2000.0) -> float:
    """Return the oil flow that carries heat away [m³/s].

    Args:
        heat: [W].
        rise: Of the oil's temperature through the gearbox [K].
        density: [kg/m³]; a turbine oil at 100 °C.
        heat_capacity: [J/(kg K)]; the same.

    Source: heat balance, Q = P/(ρ c ΔT).
    """
    return heat / (density * heat_capacity * rise)


def cooler_conductance(heat: float, oil_temperature: float, air_temperature: float) -> float:
    """Return the conductance U A that an oil cooler needs [W/K].

    Args:
        heat: [W].
        oil_temperature: Mean of the oil in the cooler [K].
        air_temperature: Mean of the cooling air [K].

    Source: heat balance with mean temperatures.
    """
    return heat / (oil_temperature - air_temperature)


def oil_viscosity(temperature: float, grade: tuple[float, float] = TURBINE_OIL) -> float:
    """Return the kinematic viscosity of an oil [m²/s].

    Args:
        temperature: Of the oil [K].
        grade: Its kinematic viscosity at 40 °C and at 100 °C [m²/s]; a 5 cSt turbine oil.

    Source: Walther's equation (ASTM D341) through 5.0 mm²/s at 100 °C and 26 mm²/s at 40 °C, typical of a
        MIL-PRF-23699 oil.

    >>> round(oil_viscosity(373.15) * 1e6, 2)
    5.0
    """
    warm, hot = (_walther(viscosity * 1e6) for viscosity in grade)
    slope = (warm - hot) / math.log10(373.15 / 313.15)
    at = warm - slope * math.log10(temperature / 313.15)
    return float((10.0 ** (10.0**at) - 0.7) * 1e-6)


def _walther(viscosity: float) -> float:
    """lg lg (ν + 0.7) with ν in mm²/s."""
    return math.log10(math.log10(viscosity + 0.7))
