"""Available power and fuel flow of a free-turbine engine in flight, by formula or by engine deck."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from typing import NamedTuple

from gearwright.elementwise import Values

# ----------------------------------------------------------------------------------------------------------------------
# A free-turbine engine in flight: power that is left at altitude, fuel that it burns, limits that it keeps.
# ----------------------------------------------------------------------------------------------------------------------


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

    core: Values
    """What its core gives in this air [W]."""
    rating: Values
    """Flat rating [W]."""
    torque: Values
    """Torque limit at this speed [W]."""


def power_limits(engine: Engine, theta: Values, delta: Values, speed: Values) -> PowerLimits:
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
    hot = 1.0 * (theta > 1.0)  # no branch, so that arrays pass
    up_to, beyond = (1.0 - hot) * theta + hot, hot * theta + (1.0 - hot)
    lapse = up_to**engine.temperature_exponent * beyond**engine.hot_exponent
    return PowerLimits(engine.thermal_power * delta * lapse, engine.rated_power, engine.rated_torque * speed)


def fuel_flow(engine: Engine, theta: Values, delta: Values, power: Values) -> Values:
    """Return the fuel that an engine burns [kg/s].

    Args:
        engine: The engine.
        theta: Stagnation temperature over that of the standard sea level θ_t [-].
        delta: Stagnation pressure, likewise δ_t [-].
        power: At its output shaft [W].

    Source: Willans line: idle fuel, which falls with δ_t √θ_t as the core's air does, and a part ∝ power.
    """
    idle = engine.idle_fuel * engine.thermal_power * delta * theta**0.5
    return engine.fuel_per_energy * (idle + (1.0 - engine.idle_fuel) * power)


# ----------------------------------------------------------------------------------------------------------------------
# An engine by a deck: power and fuel over altitude, Mach number and lever, as makers and engine programs print it.
# ----------------------------------------------------------------------------------------------------------------------


class DeckLine(NamedTuple):
    """What an engine does at one altitude and Mach number, corrected to the standard sea level."""

    power: tuple[float, ...]
    """P/(δ_t √θ_t), rising [W]."""
    fuel: tuple[float, ...]
    """m_f/(δ_t √θ_t) [kg/s]."""


class EngineDeck(NamedTuple):
    """Power and fuel of an engine over a grid of altitudes and Mach numbers, on a standard day."""

    altitude: tuple[float, ...]
    """Rising [m]."""
    mach: tuple[float, ...]
    """Rising [-]."""
    lines: tuple[tuple[DeckLine, ...], ...]
    """Altitude, Mach -> line."""

    @property
    def reference(self) -> tuple[float, float]:
        """Highest power at the lowest altitude and Mach number, corrected [W], and its fuel [kg/s]."""
        line = self.lines[0][0]
        return line.power[-1], line.fuel[-1]

    def scaled(self, factor: float) -> EngineDeck:
        """Return the deck of an engine that is alike and larger or smaller.

        Args:
            factor: Of power and fuel [-].
        """
        lines = tuple(
            tuple(DeckLine(tuple(factor * p for p in one.power), tuple(factor * f for f in one.fuel)) for one in row)
            for row in self.lines
        )
        return self._replace(lines=lines)


class Day(NamedTuple):
    """Where a deck is read, and the air there."""

    altitude: float
    """Pressure altitude [m]."""
    mach: float
    """[-]"""
    theta: float
    """Stagnation temperature over that of the standard sea level θ_t [-]."""
    delta: float
    """Stagnation pressure, likewise δ_t [-]."""
    warmer: float
    """θ_t over that of a standard day [-]."""


def deck_limit(deck: EngineDeck, day: Day, lapse: float) -> float:
    """Return the power that an engine has at most [W].

    Args:
        deck: Of the engine.
        day: Where.
        lapse: What the day leaves of the power on a standard day, at one pressure [-].

    Source: corrected power between the four nodes around, times δ_t √θ_t of a standard day and the day's lapse.

    Raises:
        ValueError: Altitude or Mach number are outside the deck.
    """
    top = sum(weight * line.power[-1] for weight, line in _around(deck, day))
    return float(top * day.delta * math.sqrt(day.theta / day.warmer) * lapse)


def deck_fuel(deck: EngineDeck, day: Day, power: float) -> float:
    """Return the fuel that an engine burns [kg/s].

    Args:
        deck: Of the engine.
        day: Where.
        power: At its shaft [W].

    Source: at the same part of each node's highest corrected power, linear between the lever's positions, and on by
        the first two of them below; times δ_t √θ_t.

    Raises:
        ValueError: Altitude or Mach number are outside the deck.
    """
    around, factor = _around(deck, day), day.delta * math.sqrt(day.theta)
    part = power / factor / sum(weight * line.power[-1] for weight, line in around)
    return factor * sum(weight * max(_fuel(line, part * line.power[-1]), 0.0) for weight, line in around)


def _fuel(line: DeckLine, power: float) -> float:
    """Return corrected fuel at a corrected power [kg/s], on straight lines through the nodes."""
    k = min(max(bisect_right(line.power, power), 1), len(line.power) - 1)
    slope = (line.fuel[k] - line.fuel[k - 1]) / (line.power[k] - line.power[k - 1])
    return line.fuel[k - 1] + slope * (power - line.power[k - 1])


def _around(deck: EngineDeck, day: Day) -> list[tuple[float, DeckLine]]:
    """Return weights and lines of the nodes around a place."""
    rows, columns = _between(deck.altitude, day.altitude, "m"), _between(deck.mach, day.mach, "Mach")
    return [(a * b, deck.lines[i][j]) for a, i in rows for b, j in columns if a * b]


def _between(axis: Sequence[float], at: float, unit: str) -> list[tuple[float, int]]:
    low, high = axis[0], axis[-1]
    slack = 1e-9 * (high - low)
    if not low - slack <= at <= high + slack:
        raise ValueError(f"the deck holds {low:g} to {high:g} {unit}, and {at:.4g} {unit} is flown")
    if len(axis) == 1:
        return [(1.0, 0)]
    k = min(max(bisect_right(axis, at), 1), len(axis) - 1)
    part = min(max((at - axis[k - 1]) / (axis[k] - axis[k - 1]), 0.0), 1.0)
    return [(1.0 - part, k - 1), (part, k)]
