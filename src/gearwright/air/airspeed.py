"""Calibrated airspeed, true airspeed and Mach number, with the compressibility of the pitot tube."""

from __future__ import annotations

import math

from gearwright.air.atmosphere import (
    GAS_CONSTANT,
    HEAT_RATIO,
    SEA_LEVEL_PRESSURE,
    SEA_LEVEL_TEMPERATURE,
    Air,
)
from gearwright.errors import DesignError, Problem

SEA_LEVEL_SOUND_SPEED = math.sqrt(HEAT_RATIO * GAS_CONSTANT * SEA_LEVEL_TEMPERATURE)
"""a_0 [m/s]."""
_POWER = HEAT_RATIO / (HEAT_RATIO - 1.0)


def impact_pressure_ratio(mach: float) -> float:
    """Return the impact pressure of a pitot tube over the static pressure, q_c/p [-].

    Args:
        mach: Mach number M, below 1 [-].

    Source: Saint-Venant: (1 + (κ-1)/2 M²)^(κ/(κ-1)) - 1.
    """
    return float((1.0 + 0.5 * (HEAT_RATIO - 1.0) * mach**2) ** _POWER - 1.0)


def mach_of_impact(ratio: float) -> float:
    """Return the Mach number at which a pitot tube sees an impact pressure [-].

    Args:
        ratio: q_c/p [-].

    Source: Saint-Venant's equation solved for M.
    """
    return math.sqrt(2.0 / (HEAT_RATIO - 1.0) * ((ratio + 1.0) ** (1.0 / _POWER) - 1.0))


def stagnation_ratios(air: Air, mach: float) -> tuple[float, float]:
    """Return θ_t and δ_t: stagnation temperature and pressure over those of the standard sea level [-].

    Args:
        air: Where it is flown.
        mach: Flight Mach number M [-].

    Source: isentropic stagnation of a perfect gas, κ = 1.4.

    >>> from gearwright.air import air_at
    >>> stagnation_ratios(air_at(0.0), 0.0)
    (1.0, 1.0)
    """
    theta = air.temperature / SEA_LEVEL_TEMPERATURE * (1.0 + 0.5 * (HEAT_RATIO - 1.0) * mach**2)
    return theta, air.pressure / SEA_LEVEL_PRESSURE * (1.0 + impact_pressure_ratio(mach))


def true_of_calibrated(calibrated: float, air: Air) -> float:
    """Return the true airspeed of a calibrated one [m/s].

    The airspeed indicator turns the impact pressure into the speed that gives it at sea level; the same impact
    pressure over the thinner static one gives the Mach number here.

    Args:
        calibrated: CAS [m/s].
        air: Where it is flown.

    Source: Saint-Venant's equation at sea level and at altitude; Pulvirenti 2023, eqs 4.1 and 4.2, take an
        incompressible root after a compressible rise, which holds at taxi speed only.

    Raises:
        DesignError: Mach 1 or above.

    >>> from gearwright.air import air_at
    >>> knot = 1852.0 / 3600.0
    >>> round(true_of_calibrated(170.0 * knot, air_at(1500 * 0.3048)) / knot, 2)
    173.71
    """
    rise = impact_pressure_ratio(_subsonic(calibrated / SEA_LEVEL_SOUND_SPEED)) * SEA_LEVEL_PRESSURE
    return _subsonic(mach_of_impact(rise / air.pressure)) * air.sound_speed


def calibrated_of_true(true: float, air: Air) -> float:
    """Return the calibrated airspeed of a true one [m/s].

    Args:
        true: TAS [m/s].
        air: Where it is flown.

    Source: Saint-Venant's equation at altitude and at sea level.

    Raises:
        DesignError: Mach 1 or above.

    >>> from gearwright.air import air_at
    >>> knot = 1852.0 / 3600.0
    >>> round(calibrated_of_true(313.0 * knot, air_at(25000 * 0.3048)) / knot, 2)
    213.87
    """
    rise = impact_pressure_ratio(_subsonic(true / air.sound_speed)) * air.pressure
    return mach_of_impact(rise / SEA_LEVEL_PRESSURE) * SEA_LEVEL_SOUND_SPEED


def _subsonic(mach: float) -> float:
    if not 0.0 <= mach < 1.0:
        raise DesignError([Problem("speed", f"Mach {mach:.3g}; the pitot equation holds below 1: fly slower or lower")])
    return mach
