"""Standard atmosphere, airspeeds and Mach number, and the drag polar of an aircraft."""

import math
from typing import NamedTuple

import numpy as np

from gearwright.elementwise import Values, functions, plain
from gearwright.errors import DesignError, Problem, refuse
from gearwright.units import FOOT, GRAVITY

# ----------------------------------------------------------------------------------------------------------------------
# The International Standard Atmosphere from sea level to 20 km, with a temperature offset.
# ----------------------------------------------------------------------------------------------------------------------


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
    """State of still air at one altitude, or at many."""

    temperature: Values
    """T [K]."""
    pressure: Values
    """p [Pa]."""
    density: Values
    """ρ [kg/m³]."""
    sound_speed: Values
    """a [m/s]."""


def air_at(altitude: Values, offset: Values = 0.0) -> Air:
    """Return the state of the air at a pressure altitude.

    The offset warms the air at every pressure, and leaves the pressure at a pressure altitude as it is: this is what
    "ISA + 15" means on a performance chart.

    Args:
        altitude: Geopotential pressure altitude H, one or shape (n,) [m].
        offset: Temperature above the standard one, likewise [K].

    Source: ISO 2533:1975, equations for the layers of -6.5 K/km and 0 K/km.

    Valid for: 0 to 20 km.

    Raises:
        DesignError: An altitude outside the two layers, or an offset that leaves no temperature.

    >>> round(air_at(5000.0).pressure, 1)
    54019.9
    """
    if isinstance(altitude, np.ndarray):
        _check(float(altitude.min()), float(np.min(offset)))
        _check(float(altitude.max()), float(np.max(offset)))
    else:
        _check(altitude, offset)
    temperature, pressure = standard_temperature(altitude) + offset, standard_pressure(altitude)
    density = pressure / (GAS_CONSTANT * temperature)
    return Air(temperature, pressure, density, sound_speed(temperature))


def _check(altitude: float, offset: float) -> None:
    """Refuse what the standard atmosphere does not reach."""
    problems = []
    if not 0.0 <= altitude <= CEILING:
        message = f"{altitude:g} m; the standard atmosphere is given from 0 to {CEILING:g} m"
        problems.append(Problem("altitude", message))
    if not -100.0 <= offset <= 100.0:
        problems.append(Problem("isa_offset", f"{offset:g} K from the standard atmosphere; give -100 to 100 K"))
    refuse(problems)


def sound_speed(temperature: Values) -> Values:
    """Return the speed of sound in air [m/s].

    Args:
        temperature: T [K].

    Source: ISO 2533:1975: a² = κ R T.
    """
    return functions(temperature).sqrt(HEAT_RATIO * GAS_CONSTANT * temperature)


def standard_temperature(altitude: Values) -> Values:
    """Return the temperature of the standard atmosphere [K].

    Args:
        altitude: Geopotential altitude H [m].

    Source: ISO 2533:1975.

    Valid for: 0 to 20 km; not checked.

    >>> round(standard_temperature(11000.0), 2)
    216.65
    """
    return SEA_LEVEL_TEMPERATURE - LAPSE_RATE * functions(altitude).min(altitude, TROPOPAUSE)


def standard_pressure(altitude: Values) -> Values:
    """Return the pressure of the standard atmosphere [Pa].

    Args:
        altitude: Geopotential altitude H [m].

    Source: ISO 2533:1975: p_0 (T/T_0)^(g/(L R)) in the troposphere, exponential above it.

    Valid for: 0 to 20 km; not checked.

    >>> round(standard_pressure(20000.0), 2)
    5474.88
    """
    of, temperature = functions(altitude), standard_temperature(altitude)
    pressure = SEA_LEVEL_PRESSURE * of.pow(temperature / SEA_LEVEL_TEMPERATURE, _EXPONENT)
    above = of.max(altitude - TROPOPAUSE, 0.0)
    return pressure * of.exp(-GRAVITY * above / (GAS_CONSTANT * _STRATOSPHERE_TEMPERATURE))


def height(altitude: float) -> str:
    """Return an altitude as pilots and as engineers write it.

    Args:
        altitude: [m].

    >>> height(3048.0)
    '10000 ft (3048 m)'
    """
    return f"{altitude / FOOT:.0f} ft ({altitude:.0f} m)"


# ----------------------------------------------------------------------------------------------------------------------
# Calibrated airspeed, true airspeed and Mach number, with the compressibility of the pitot tube.
# ----------------------------------------------------------------------------------------------------------------------


SEA_LEVEL_SOUND_SPEED = math.sqrt(HEAT_RATIO * GAS_CONSTANT * SEA_LEVEL_TEMPERATURE)
"""a_0 [m/s]."""
_POWER = HEAT_RATIO / (HEAT_RATIO - 1.0)


def impact_pressure_ratio(mach: Values) -> Values:
    """Return the impact pressure of a pitot tube over the static pressure, q_c/p [-].

    Args:
        mach: Mach number M, below 1 [-].

    Source: Saint-Venant: (1 + (κ-1)/2 M²)^(κ/(κ-1)) - 1.
    """
    return (1.0 + 0.5 * (HEAT_RATIO - 1.0) * plain(mach) ** 2) ** _POWER - 1.0


def mach_of_impact(ratio: Values) -> Values:
    """Return the Mach number at which a pitot tube sees an impact pressure [-].

    Args:
        ratio: q_c/p [-].

    Source: Saint-Venant's equation solved for M.
    """
    return functions(ratio).sqrt(2.0 / (HEAT_RATIO - 1.0) * ((ratio + 1.0) ** (1.0 / _POWER) - 1.0))


def stagnation_ratios(air: Air, mach: Values) -> tuple[Values, Values]:
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


def true_of_calibrated(calibrated: Values, air: Air) -> Values:
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


def calibrated_of_true(true: Values, air: Air) -> Values:
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


def _subsonic(mach: Values) -> Values:
    """Return Mach numbers that a pitot tube measures; of many, the least and the largest are looked at."""
    for value in (mach.min(), mach.max()) if isinstance(mach, np.ndarray) else (mach,):
        if not 0.0 <= value < 1.0:
            message = f"Mach {value:.3g}; the pitot equation holds below 1: fly slower or lower"
            raise DesignError([Problem("speed", message)])
    return mach


# ----------------------------------------------------------------------------------------------------------------------
# What the air does to an aircraft: a parabolic drag polar, and the speed below which no wing bears.
# ----------------------------------------------------------------------------------------------------------------------


class Polar(NamedTuple):
    """A parabolic drag polar C_D = C_D0 + k C_L²."""

    area: Values
    """Reference area S [m²]."""
    zero_lift: Values
    """C_D0, with flaps and gear [-]."""
    induced: Values
    """k [-]."""


def dynamic_force(polar: Polar, air: Air, speed: Values) -> Values:
    """Return what a coefficient of 1 bears, q S [N].

    Args:
        polar: With the area.
        air: Where it is flown.
        speed: True airspeed [m/s].

    Source: definition of the coefficients: q = ρ V²/2.
    """
    return 0.5 * air.density * speed**2 * polar.area


def drag_force(polar: Polar, reference: Values, lift: Values) -> Values:
    """Return the drag of a lift [N].

    Args:
        polar: Of the aircraft.
        reference: q S [N]; 0 at rest, where nothing lifts.
        lift: [N].

    Source: D = q S (C_D0 + k C_L²).

    >>> round(drag_force(Polar(27.308, 0.022, 0.0464), 100e3, 40e3))  # 100 kN · (0.022 + 0.0464 · 0.4²)
    2942
    """
    lifts = reference != 0.0  # no branch, so that arrays pass
    return reference * polar.zero_lift + polar.induced * (lifts * lift) ** 2 / (reference + (1.0 - lifts))


def stall_speed(polar: Polar, air: Air, weight: float, highest: float) -> float:
    """Return the true airspeed at which the wing just bears a weight [m/s].

    Args:
        polar: With the area.
        air: Where it is flown.
        weight: [N].
        highest: C_L at the stall [-].

    Source: m g = ρ V²/2 S C_Lmax.
    """
    return math.sqrt(2.0 * weight / (air.density * polar.area * highest))
