"""Friction of radial shaft seals."""

from __future__ import annotations

import math

from gearwright.units import CELSIUS, RPM

VITON, NITRILE = 3.737e-3, 2.429e-3
"""Torque over shaft diameter by material of the lip [N m/mm] (ISO/TR 14179-1:2001)."""
LEAST_OIL_FACTOR = 0.5 * 76.9
"""Factor at which Linke's line is held [W min/mm² 1e-7]: half of that of ISO/TR 14179-2; an assumption."""


def seal_power_14179_1(diameter: float, speed: float, *, torque_per_mm: float = VITON) -> float:
    """Return what a shaft seal loses by ISO/TR 14179-1 [W].

    Args:
        diameter: Of the shaft [m].
        speed: [rad/s].
        torque_per_mm: Of the lip's material [N m/mm].

    Source: ISO/TR 14179-1:2001: T = 3.737e-3 D for Viton, 2.429e-3 D for nitrile, in N m and mm.

    >>> round(seal_power_14179_1(0.04, 157.08), 1)
    23.5
    """
    return torque_per_mm * 1e3 * diameter * abs(speed)


def seal_power_14179_2(diameter: float, speed: float) -> float:
    """Return what a shaft seal loses by ISO/TR 14179-2 [W].

    Args:
        diameter: Of the shaft d [m].
        speed: [rad/s].

    Source: ISO/TR 14179-2:2001: 7.69e-6 d² n with mm and 1/min.

    >>> round(seal_power_14179_2(0.04, 157.08), 2)
    18.46
    """
    return 7.69e-6 * (1e3 * diameter) ** 2 * abs(speed) / RPM


def seal_power_oil(diameter: float, speed: float, *, temperature: float, viscosity_40: float) -> float:
    """Return what a shaft seal loses by its oil [W].

    Args:
        diameter: Of the shaft d [m].
        speed: [rad/s].
        temperature: Of the oil sump θ [K].
        viscosity_40: Kinematic viscosity at 40 °C [m²/s].

    Source: Linke (1996), as makers of seals (Simrit) have it: (145 - 1.6 θ + 350 lg lg(ν_40 + 0.8)) d² n 1e-7, θ in °C,
        mm²/s, mm and 1/min.

    Valid for: factors from half of that of ISO/TR 14179-2 on; the line falls through zero where oil is hot or thin, and
        is held there, which is an assumption: no seal runs without friction.

    >>> round(seal_power_oil(0.04, 157.08, temperature=423.15, viscosity_40=26e-6), 2)  # half of 18.46 W
    9.23
    """
    factor = max(seal_oil_factor(temperature, viscosity_40), LEAST_OIL_FACTOR)
    return 1e-7 * factor * (1e3 * diameter) ** 2 * abs(speed) / RPM


def seal_oil_factor(temperature: float, viscosity_40: float) -> float:
    """Return the factor of Linke's line, wherever it leads [W min/mm² 1e-7].

    Args:
        temperature: Of the oil sump θ [K].
        viscosity_40: Kinematic viscosity at 40 °C [m²/s].

    Source: `seal_power_oil`.
    """
    return 145.0 - 1.6 * (temperature - CELSIUS) + 350.0 * math.log10(math.log10(viscosity_40 * 1e6 + 0.8))
