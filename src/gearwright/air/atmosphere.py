"""The International Standard Atmosphere from sea level to 20 km, with a temperature offset."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import Problem, refuse
from gearwright.units import FOOT, GRAVITY

SEA_LEVEL_TEMPERATURE = 288.15
"""T_0 [K]; ISO 2533:1975."""
SEA_LEVEL_PRESSURE = 101_325.0
"""p_0 [Pa]; ISO 2533:1975."""
LAPSE_RATE = 0.0065
"""-dT/dH of the troposphere [K/m]; ISO 2533:1975."""
TROPOPAUSE = 11_000.0
"""Geopotential altitude where the temperature stops falling [m]; ISO 2533:1975."""
CEILING = 20_000.0
"""Top of the isothermal layer, where this model ends [m]; ISO 2533:1975."""
GAS_CONSTANT = 287.05287
"""Specific gas constant of air R [J/(kg K)]; ISO 2533:1975."""
HEAT_RATIO = 1.4
"""κ of air [-]; ISO 2533:1975."""

_EXPONENT = GRAVITY / (LAPSE_RATE * GAS_CONSTANT)
_STRATOSPHERE_TEMPERATURE = SEA_LEVEL_TEMPERATURE - LAPSE_RATE * TROPOPAUSE


class Air(NamedTuple):
    """State of still air at one altitude."""

    temperature: float
    """T [K]."""
    pressure: float
    """p [Pa]."""
    density: float
    """ρ [kg/m³]."""
    sound_speed: float
    """a [m/s]."""


def air_at(altitude: float, offset: float = 0.0) -> Air:
    """Return the state of the air at a pressure altitude.

    The offset warms the air at every pressure, and leaves the pressure at a pressure altitude as it is: this is what
    "ISA + 15" means on a performance chart.

    Args:
        altitude: Geopotential pressure altitude H [m].
        offset: Temperature above the standard one [K].

    Source: ISO 2533:1975, equations for the layers of -6.5 K/km and 0 K/km.

    Valid for: 0 to 20 km.

    Raises:
        DesignError: An altitude outside the two layers, or an offset that leaves no temperature.

    >>> round(air_at(5000.0).pressure, 1)
    54019.9
    """
    check_air(altitude, offset)
    return _state(altitude, offset)


def check_air(altitude: float, offset: float) -> None:
    """Refuse what the standard atmosphere does not reach.

    Args:
        altitude: Geopotential pressure altitude [m].
        offset: Temperature above the standard one [K].

    Raises:
        DesignError: As `air_at`.
    """
    problems = []
    if not 0.0 <= altitude <= CEILING:
        message = f"{altitude:g} m; the standard atmosphere is given from 0 to {CEILING:g} m"
        problems.append(Problem("altitude", message))
    if not -100.0 <= offset <= 100.0:
        problems.append(Problem("isa_offset", f"{offset:g} K from the standard atmosphere; give -100 to 100 K"))
    refuse(problems)


def _state(altitude: float, offset: float) -> Air:
    temperature, pressure = standard_temperature(altitude) + offset, standard_pressure(altitude)
    density = pressure / (GAS_CONSTANT * temperature)
    return Air(temperature, pressure, density, sound_speed(temperature))


def sound_speed(temperature: float) -> float:
    """Return the speed of sound in air [m/s].

    Args:
        temperature: T [K].

    Source: ISO 2533:1975: a² = κ R T.
    """
    return math.sqrt(HEAT_RATIO * GAS_CONSTANT * temperature)


def standard_temperature(altitude: float) -> float:
    """Return the temperature of the standard atmosphere [K].

    Args:
        altitude: Geopotential altitude H [m].

    Source: ISO 2533:1975.

    Valid for: 0 to 20 km; not checked, so that a compiled kernel can use it.

    >>> round(standard_temperature(11000.0), 2)
    216.65
    """
    return SEA_LEVEL_TEMPERATURE - LAPSE_RATE * min(altitude, TROPOPAUSE)


def standard_pressure(altitude: float) -> float:
    """Return the pressure of the standard atmosphere [Pa].

    Args:
        altitude: Geopotential altitude H [m].

    Source: ISO 2533:1975: p_0 (T/T_0)^(g/(L R)) in the troposphere, exponential above it.

    Valid for: 0 to 20 km; not checked, so that a compiled kernel can use it.

    >>> round(standard_pressure(20000.0), 2)
    5474.88
    """
    temperature = SEA_LEVEL_TEMPERATURE - LAPSE_RATE * min(altitude, TROPOPAUSE)
    pressure = SEA_LEVEL_PRESSURE * math.pow(temperature / SEA_LEVEL_TEMPERATURE, _EXPONENT)
    above = max(altitude - TROPOPAUSE, 0.0)
    return pressure * math.exp(-GRAVITY * above / (GAS_CONSTANT * _STRATOSPHERE_TEMPERATURE))


def height(altitude: float) -> str:
    """Return an altitude as pilots and as engineers write it.

    Args:
        altitude: [m].

    >>> height(3048.0)
    '10000 ft (3048 m)'
    """
    return f"{altitude / FOOT:.0f} ft ({altitude:.0f} m)"
