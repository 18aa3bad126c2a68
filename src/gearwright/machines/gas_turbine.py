"""A free-turbine engine in flight: power that is left at altitude, fuel that it burns, limits that it keeps."""

from __future__ import annotations

from typing import NamedTuple

HEATING_VALUE = 42.8e6
"""Least net heat of combustion of Jet A-1 [J/kg]; ASTM D1655."""


class Engine(NamedTuple):
    """What the mission knows of an engine."""

    rated_power: float
    """Flat rating: what gearbox and shaft may carry [W]."""
    thermal_power: float
    """What the core gives at sea level on a standard day without the flat rating [W]."""
    rated_torque: float
    """Torque limit of its shaft [N m]."""
    fuel_per_energy: float
    """Specific fuel consumption at the thermal power [kg/J]."""
    idle_fuel: float
    """Part of the fuel flow that burns without any power, 0.1 to 0.3 [-]."""
    temperature_exponent: float
    """n of P ∝ δ_t θ_t^n up to θ_t = 1, where the speed of the gas generator limits [-]."""
    hot_exponent: float
    """n beyond it, where the temperature of its turbine does [-]."""

    def rated(self, factor: float) -> Engine:
        """Return the engine at another rating: core, flat rating and torque limit times a factor.

        Args:
            factor: Of a contingency rating, above 1 [-].
        """
        power, core, torque = self.rated_power, self.thermal_power, self.rated_torque
        return self._replace(rated_power=factor * power, thermal_power=factor * core, rated_torque=factor * torque)


class PowerLimits(NamedTuple):
    """What bounds the power of an engine; the least one counts."""

    core: float
    """What its core gives in this air [W]."""
    rating: float
    """Flat rating [W]."""
    torque: float
    """Torque limit at this speed [W]."""


def power_limits(engine: Engine, theta: float, delta: float, speed: float) -> PowerLimits:
    """Return what bounds the power of an engine [W].

    Args:
        engine: The engine.
        theta: Stagnation temperature over that of the standard sea level θ_t [-].
        delta: Stagnation pressure, likewise δ_t [-].
        speed: Of its output shaft [rad/s].

    Source: P = P_0 δ_t min(θ_t, 1)^n max(θ_t, 1)^n_hot, fitted to engines by their components, which N1 of the design
        point limits below 15 °C and T_45 of it above (`benchmarks/temperature_lapse.py`); at most the flat rating and
        the torque limit.

    Valid for: -20 to 40 K off the standard day up to 6 km, within some per cent; docs/theory/power.md.
    """
    lapse = min(theta, 1.0) ** engine.temperature_exponent * max(theta, 1.0) ** engine.hot_exponent
    return PowerLimits(engine.thermal_power * delta * lapse, engine.rated_power, engine.rated_torque * speed)


def fuel_flow(engine: Engine, theta: float, delta: float, power: float) -> float:
    """Return the fuel that an engine burns [kg/s].

    Args:
        engine: The engine.
        theta: Stagnation temperature over that of the standard sea level θ_t [-].
        delta: Stagnation pressure, likewise δ_t [-].
        power: At its output shaft [W].

    Source: Willans line: idle fuel, which falls with δ_t √θ_t as the core's air does, and a part ∝ power.
    """
    idle = engine.idle_fuel * engine.thermal_power * delta * theta**0.5
    return float(engine.fuel_per_energy * (idle + (1.0 - engine.idle_fuel) * power))
