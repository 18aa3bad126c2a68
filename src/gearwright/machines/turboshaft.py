"""Turboshaft engine with gas generator and power turbine: gas properties, equilibrium and exhaust."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, Floats
from gearwright.elementwise import Values, functions

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
    rows, columns = _neighbours(deck.altitude, day.altitude, "m"), _neighbours(deck.mach, day.mach, "Mach")
    return [(a * b, deck.lines[i][j]) for a, i in rows for b, j in columns if a * b]


def _neighbours(axis: Sequence[float], at: float, unit: str) -> list[tuple[float, int]]:
    low, high = axis[0], axis[-1]
    slack = 1e-9 * (high - low)
    if not low - slack <= at <= high + slack:
        raise ValueError(f"the deck holds {low:g} to {high:g} {unit}, and {at:.4g} {unit} is flown")
    if len(axis) == 1:
        return [(1.0, 0)]
    k = min(max(bisect_right(axis, at), 1), len(axis) - 1)
    part = min(max((at - axis[k - 1]) / (axis[k] - axis[k - 1]), 0.0), 1.0)
    return [(1.0 - part, k - 1), (part, k)]


# ----------------------------------------------------------------------------------------------------------------------
# Air and the gas that burnt kerosene makes of it: heat capacity, enthalpy and entropy over temperature.
# ----------------------------------------------------------------------------------------------------------------------


Terms = tuple[Values, ...]
REFERENCE = 298.15
"""Temperature of the enthalpies' zero, and of the heating value [K]."""
GAS_CONSTANT = 287.05
"""R of air and of its products with kerosene, which differ by less than 1e-6 [J/(kg K)]; Walsh and Fletcher, F3.22."""
_AIR = (
    0.992313e3, 0.236688e3, -1.852148e3, 6.083152e3, -8.893933e3, 7.097112e3, -3.234725e3, 0.794571e3, -0.081873e3,
)  # fmt: skip
_BURNT = (-0.718874e3, 8.747481e3, -15.863157e3, 17.254096e3, -10.233795e3, 3.081778e3, -0.361112e3, -0.003919e3, 0.0)
"""Coefficients of c_p over powers of T/1000 K [J/(kg K)]."""
_TOLERANCE = 1e-13
"""Part of a temperature to which an inverse is found [-]."""
_MOST_GAS_ROUNDS = 60


class Gas(NamedTuple):
    """What flows through a turbine."""

    fuel_ratio: Values = 0.0
    """Burnt fuel over dry air f [-]."""

    @property
    def burnt(self) -> Values:
        """f/(1 + f): how much of the products' coefficients counts [-]."""
        return self.fuel_ratio / (1.0 + self.fuel_ratio)


AIR = Gas()
"""Dry air."""


def _coefficients(gas: Gas) -> tuple[Terms, Terms, Values, Terms]:
    """Return those of c_p, of its integral, of ln T and of the rest of ∫ c_p dT/T, the highest power first."""
    return _polynomials(gas) if isinstance(gas.fuel_ratio, np.ndarray) else _known_coefficients(gas)


@lru_cache(maxsize=256)
def _known_coefficients(gas: Gas) -> tuple[Terms, Terms, float, Terms]:
    return _polynomials(gas)


def _polynomials(gas: Gas) -> tuple[Terms, Terms, Values, Terms]:
    capacity = tuple(a + gas.burnt * b for a, b in zip(_AIR, _BURNT, strict=True))
    integral = tuple(1e3 * value / (k + 1) for k, value in enumerate(capacity))
    rest = tuple(value / k for k, value in enumerate(capacity) if k)
    return capacity[::-1], integral[::-1], capacity[0], rest[::-1]


def _horner(terms: Terms, part: Values) -> Values:
    total: Values = 0.0
    for term in terms:
        total = total * part + term
    return total


def heat_capacity(gas: Gas, temperature: Values) -> Values:
    """Return c_p of air or of burnt gas [J/(kg K)].

    Args:
        gas: The gas.
        temperature: T [K].

    Source: Walsh and Fletcher, Gas Turbine Performance (2004), F3.23 and F3.24.

    Valid for: 200 to 2000 K, f up to 0.05; a little below 200 K the polynomial goes on smoothly.

    >>> round(heat_capacity(AIR, 300.0), 1)
    1003.9
    """
    return _horner(_coefficients(gas)[0], temperature / 1000.0)


def enthalpy(gas: Gas, temperature: Values) -> Values:
    """Return the enthalpy over that at 298.15 K [J/kg].

    Args:
        gas: The gas.
        temperature: T [K].

    Source: integral of `heat_capacity`, term by term.
    """
    terms, part, zero = _coefficients(gas)[1], temperature / 1000.0, REFERENCE / 1000.0
    return _horner(terms, part) * part - _horner(terms, zero) * zero


def entropy(gas: Gas, temperature: float) -> float:
    """Return the part of the entropy that depends on temperature, φ = ∫ c_p dT/T [J/(kg K)].

    Args:
        gas: The gas.
        temperature: T [K].

    Source: integral of `heat_capacity` over T, term by term; Walsh and Fletcher, F3.28.
    """
    _, _, first, rest = _coefficients(gas)
    part = temperature / 1000.0
    return float(first * math.log(part) + _horner(rest, part) * part)


def temperature_of(gas: Gas, wanted: Values) -> Values:
    """Return the temperature at which a gas has an enthalpy [K].

    Args:
        gas: The gas.
        wanted: h over that at 298.15 K [J/kg].

    Source: Newton's method on `enthalpy`, whose slope is `heat_capacity`.

    >>> round(temperature_of(AIR, enthalpy(AIR, 700.0)), 9)
    700.0
    """
    temperature = REFERENCE + wanted / 1050.0
    if isinstance(wanted, np.ndarray):
        return _temperatures(gas, wanted, temperature)
    for _ in range(_MOST_GAS_ROUNDS):
        step = (wanted - enthalpy(gas, temperature)) / heat_capacity(gas, temperature)
        temperature += step
        if abs(step) <= _TOLERANCE * temperature:
            break
    return temperature


def _temperatures(gas: Gas, wanted: Floats, temperature: Floats) -> Floats:
    """Return the temperatures from first guesses: each stops where it would stop alone."""
    capacity, integral, *_ = _coefficients(gas)
    zero, going = REFERENCE / 1000.0, np.ones(len(wanted), bool)
    held = _horner(integral, zero) * zero
    for _ in range(_MOST_GAS_ROUNDS):
        part = temperature / 1000.0
        step = (wanted - (_horner(integral, part) * part - held)) / _horner(capacity, part)
        temperature = np.where(going, temperature + step, temperature)
        going = going & (np.abs(step) > _TOLERANCE * temperature)
        if not going.any():
            break
    return temperature


def isentropic(gas: Gas, temperature: float, ratio: float) -> float:
    """Return the temperature behind a change of pressure without loss [K].

    Args:
        gas: The gas.
        temperature: T before it [K].
        ratio: Pressure after over pressure before [-].

    Source: φ(T_2) = φ(T_1) + R ln(p_2/p_1); Newton's method.
    """
    wanted = entropy(gas, temperature) + GAS_CONSTANT * math.log(ratio)
    found = temperature * math.pow(ratio, 0.28)
    for _ in range(_MOST_GAS_ROUNDS):
        step = (wanted - entropy(gas, found)) * found / heat_capacity(gas, found)
        found += step
        if abs(step) <= _TOLERANCE * found:
            break
    return found


# ----------------------------------------------------------------------------------------------------------------------
# A turboshaft engine of two spools: gas generator and power turbine, by its components in every state.
# ----------------------------------------------------------------------------------------------------------------------


STANDARD_TEMPERATURE, STANDARD_PRESSURE = 288.15, 101325.0
"""Of the standard sea level [K]; [Pa]."""
HOTTEST = 2000.0
"""Of what the gas properties hold for [K]."""
_MOST_ROUNDS = 200
_SETTLED = 1e-13
"""Change of what is iterated, over itself [-]."""


class Rated(NamedTuple):
    """A turboshaft engine at its design point, at sea level on a standard day without speed."""

    power: float
    """P of the power turbine [W]."""
    fuel_flow: float
    """m_f [kg/s]."""
    air_flow: float
    """m_a [kg/s]."""
    pressure_ratio: float
    """p_3/p_2 [-]."""
    compressor: float
    """Isentropic efficiency [-]."""
    turbine: float
    """Isentropic efficiency of the turbine of the gas generator [-]."""
    combustion: float = 0.995
    """Part of the fuel that burns [-]."""
    burner_loss: float = 0.04
    """Part of the pressure that the burner takes [-]."""
    exit_ratio: float = 1.04
    """Pressure behind the power turbine over that of the air [-]."""
    mechanical: float = 0.99
    """Of the gas generator's shaft [-]."""
    casing_loss: float = 0.0
    """Part of the fuel's heat that leaves through the casing of the burner [-]."""
    inertia: float = 0.06
    """Of the gas generator [kg m²]."""
    speed: float = 4000.0
    """Of the gas generator N1 [rad/s]."""
    work_exponent: float = 2.0
    """n of ΔT_c/T_2 ∝ (N1/√T_2)^n: 2 for a constant work coefficient."""
    fall: float = 1.0
    """k of η_c = η_0 (1 - k (1 - N1/√T_2)²), the corrected speed over the rated one [-]."""


class Turboshaft(NamedTuple):
    """An engine with what its design point fixes."""

    rated: Rated
    gas_nozzle: float
    """m √T/p of the first turbine, choked [kg √K/(s Pa)]."""
    power_nozzle: float
    """The same of the power turbine over √(1 - (p_5/p_45)²)."""
    power_efficiency: float
    """Isentropic, of the power turbine at its design point [-]."""
    rise: float
    """(T_3 - T_2)/T_2 at the design point [-]."""
    expansion: float
    """p_4/p_45 of the first turbine [-]."""
    drop: float
    """Δh_0 of the ideal power turbine at its design point [J/kg]."""


class Inlet(NamedTuple):
    """The air before an engine."""

    temperature: float
    """T_2, stagnation [K]."""
    pressure: float
    """p_2, stagnation [Pa]."""
    ambient: float
    """p_0, static [Pa]."""


class EngineState(NamedTuple):
    """An engine at one instant: flows, temperatures, powers, every one by its own component."""

    air_flow: float
    """[kg/s]"""
    fuel_flow: float
    """[kg/s]"""
    compressor_exit: float
    """T_3 [K]."""
    turbine_inlet: float
    """T_4 [K]."""
    between: float
    """T_45, between the turbines: what a temperature limit watches [K]."""
    exhaust: float
    """T_5 behind the power turbine [K]."""
    pressure_ratio: float
    """p_3/p_2 [-]."""
    compressor_power: float
    """Into the air [W]."""
    turbine_power: float
    """Of the first turbine, on its shaft [W]."""
    power: float
    """Of the power turbine [W]."""
    casing: float
    """Heat through casing and bearings [W]."""
    unburnt: float
    """Heat of fuel that did not burn [W]."""

    @property
    def surplus(self) -> float:
        """What accelerates the gas generator [W]."""
        return self.turbine_power - self.compressor_power


def _compressed(rated: Rated, temperature: float, ratio: float) -> float:
    """Return T_3 [K]."""
    ideal = enthalpy(AIR, isentropic(AIR, temperature, ratio)) - enthalpy(AIR, temperature)
    return float(temperature_of(AIR, enthalpy(AIR, temperature) + ideal / rated.compressor))


def _ratio(rated: Rated, part: float, temperature: float, exit_temperature: float) -> float:
    """Return p_3/p_2 that a rise of temperature gives at a part of the corrected speed [-]."""
    efficiency = rated.compressor * (1.0 - rated.fall * (1.0 - part) ** 2)
    work = efficiency * (enthalpy(AIR, exit_temperature) - enthalpy(AIR, temperature))
    ideal = temperature_of(AIR, enthalpy(AIR, temperature) + work)
    return math.exp((entropy(AIR, ideal) - entropy(AIR, temperature)) / GAS_CONSTANT)


def engine_of(rated: Rated) -> Turboshaft:
    """Return an engine that meets its design point: nozzles, expansion and the power turbine's efficiency follow.

    Args:
        rated: The design point.

    Source: gas-generator balance and choked nozzles; Saravanamuttoo et al., Gas Turbine Theory, ch. 3 and 9.

    Raises:
        ValueError: The design point cannot be: the power turbine would need an efficiency above 1.
    """
    inlet = Inlet(STANDARD_TEMPERATURE, STANDARD_PRESSURE, STANDARD_PRESSURE)
    t3 = _compressed(rated, inlet.temperature, rated.pressure_ratio)
    gas, flow = Gas(rated.combustion * rated.fuel_flow / rated.air_flow), rated.air_flow + rated.fuel_flow
    heat = (rated.combustion - rated.casing_loss) * rated.fuel_flow * HEATING_VALUE
    t4 = temperature_of(gas, (rated.air_flow * enthalpy(AIR, t3) + heat) / flow)
    p4 = inlet.pressure * rated.pressure_ratio * (1.0 - rated.burner_loss)
    needed = rated.air_flow * (enthalpy(AIR, t3) - enthalpy(AIR, inlet.temperature)) / rated.mechanical
    t45 = temperature_of(gas, enthalpy(gas, t4) - needed / flow)
    ideal = temperature_of(gas, enthalpy(gas, t4) - needed / flow / rated.turbine)
    expansion = math.exp((entropy(gas, t4) - entropy(gas, ideal)) / GAS_CONSTANT)
    p45 = p4 / expansion
    last = isentropic(gas, t45, rated.exit_ratio * inlet.ambient / p45)
    drop = enthalpy(gas, t45) - enthalpy(gas, last)
    return Turboshaft(
        rated,
        flow * math.sqrt(t4) / p4,
        flow * math.sqrt(t45) / p45 / math.sqrt(1.0 - (rated.exit_ratio * inlet.ambient / p45) ** 2),
        rated.power / flow / drop,
        (t3 - inlet.temperature) / inlet.temperature,
        expansion,
        drop,
    )


def state_at(engine: Turboshaft, inlet: Inlet, speed: float, hot: float) -> EngineState:
    """Return an engine with a speed of its gas generator and a temperature behind its burner, at rest or not.

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].
        hot: T_4 [K].

    Source: compressor of constant work coefficient, ΔT_c/T_2 ∝ (N1/√T_2)^n, and efficiency; choked first nozzle;
        power turbine by Stodola's ellipse, m √T/p ∝ √(1 - (p_5/p_45)²), which sets the expansion before it; burner by
        enthalpy (Saravanamuttoo et al., Gas Turbine Theory, ch. 9).

    Valid for: a first nozzle that chokes, p_4 above about twice p_45; a power turbine at its rated speed.
    """
    rated = engine.rated
    t3, ratio = compressed_to(engine, inlet, speed)
    p4 = inlet.pressure * ratio * (1.0 - rated.burner_loss)
    fuel_ratio = _fuel_ratio(rated, t3, hot)
    air = engine.gas_nozzle * p4 / math.sqrt(hot) / (1.0 + fuel_ratio)
    return _expanded(engine, inlet, (air, fuel_ratio, t3, hot), ratio=ratio, pressure=p4)


def compressed_to(engine: Turboshaft, inlet: Inlet, speed: float) -> tuple[float, float]:
    """Return T_3 [K] and p_3/p_2 [-] of a compressor.

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].
    """
    rated = engine.rated
    part = speed / rated.speed * math.sqrt(STANDARD_TEMPERATURE / inlet.temperature)
    t3 = inlet.temperature * (1.0 + engine.rise * part**rated.work_exponent)
    return t3, _ratio(rated, part, inlet.temperature, t3)


def _fuel_ratio(rated: Rated, cold: float, hot: float) -> float:
    """Return fuel over air that heats a burner's gas to a temperature [-]."""
    heat, before = (rated.combustion - rated.casing_loss) * HEATING_VALUE, enthalpy(AIR, cold)
    ratio = 0.0
    for _ in range(_MOST_ROUNDS):
        after = enthalpy(Gas(rated.combustion * ratio), hot)
        found = (after - before) / (heat - after)
        if abs(found - ratio) <= _SETTLED:
            break
        ratio = found
    return float(found)


def _expanded(
    engine: Turboshaft, inlet: Inlet, burner: tuple[float, float, float, float], *, ratio: float, pressure: float
) -> EngineState:
    rated, (air, fuel_ratio, t3, t4) = engine.rated, burner
    gas, fuel = Gas(rated.combustion * fuel_ratio), air * fuel_ratio
    flow, behind = air + fuel, rated.exit_ratio * inlet.ambient
    p45 = _between(engine, gas, (t4, pressure, flow), behind)
    t45 = first_exit(engine, gas, t4, pressure / p45)
    last = isentropic(gas, t45, min(behind / p45, 1.0))
    drop = _turbine_work(engine, enthalpy(gas, t45) - enthalpy(gas, last))
    first = flow * (enthalpy(gas, t4) - enthalpy(gas, t45))
    rubbed = (1.0 - rated.mechanical) * first
    return EngineState(
        air_flow=air,
        fuel_flow=fuel,
        compressor_exit=t3,
        turbine_inlet=t4,
        between=t45,
        exhaust=temperature_of(gas, enthalpy(gas, t45) - drop),
        pressure_ratio=ratio,
        compressor_power=air * (enthalpy(AIR, t3) - enthalpy(AIR, inlet.temperature)),
        turbine_power=first - rubbed,
        power=flow * drop,
        casing=rated.casing_loss * fuel * HEATING_VALUE + rubbed,
        unburnt=(1.0 - rated.combustion) * fuel * HEATING_VALUE,
    )


def _turbine_work(engine: Turboshaft, ideal: float) -> float:
    """Return what the power turbine takes from its gas at its rated speed [J/kg].

    Source: torque falls linearly with speed, so that η = η_0 x (2 - x) over x = (u/c)/(u/c)_0 with c = √(2 Δh); at one
        speed x = √(Δh_0/Δh), and the work η_0 (2 √(Δh_0 Δh) - Δh_0). Gas that is too slow for its blades is stirred.
    """
    return engine.power_efficiency * (2.0 * math.sqrt(engine.drop * max(ideal, 0.0)) - engine.drop)


def first_exit(engine: Turboshaft, gas: Gas, hot: float, expansion: float) -> float:
    """Return T_45 behind the first turbine [K].

    Args:
        engine: The engine.
        gas: That expands.
        hot: T_4 [K].
        expansion: p_4/p_45 [-].
    """
    ideal = enthalpy(gas, hot) - enthalpy(gas, isentropic(gas, hot, 1.0 / expansion))
    return float(temperature_of(gas, enthalpy(gas, hot) - engine.rated.turbine * ideal))


def _between(engine: Turboshaft, gas: Gas, nozzle: tuple[float, float, float], behind: float) -> float:
    """Return p_45 at which the power turbine passes the flow of the first nozzle [Pa].

    Source: p_45² = p_5² + m² T_45/k² from Stodola's ellipse, with T_45 behind an expansion to p_45; secants.
    """
    hot, pressure, flow = nozzle
    if pressure <= behind:
        return max(pressure, 1.0001 * behind)

    def after(between: float) -> float:
        cold = first_exit(engine, gas, hot, max(pressure / between, 1.0))
        return min(math.sqrt(behind**2 + flow**2 * cold / engine.power_nozzle**2), pressure)

    last = min(max(pressure / engine.expansion, behind), pressure)
    now = after(last)
    wrong = now - last
    for _ in range(_MOST_ROUNDS):
        if abs(wrong) <= _SETTLED * now:
            break
        then = after(now) - now
        slope = (then - wrong) / (now - last)
        last, wrong, now = now, then, now - then / slope
    return now


def leaving(state: EngineState) -> float:
    """Return the enthalpy that leaves with the gas over that at 298.15 K, by its state [W].

    Args:
        state: Of the engine.
    """
    burnt = state.fuel_flow - state.unburnt / HEATING_VALUE
    return float((state.air_flow + state.fuel_flow) * enthalpy(Gas(burnt / state.air_flow), state.exhaust))


def entering(state: EngineState, inlet: Inlet) -> float:
    """Return the enthalpy that enters with air and fuel [W].

    Args:
        state: Of the engine.
        inlet: The air before it.
    """
    return float(state.air_flow * enthalpy(AIR, inlet.temperature) + state.fuel_flow * HEATING_VALUE)


# ----------------------------------------------------------------------------------------------------------------------
# What a turboshaft does at rest at a speed, and at rest with a power.
# ----------------------------------------------------------------------------------------------------------------------


def steady_state(engine: Turboshaft, inlet: Inlet, speed: float) -> EngineState:
    """Return an engine at rest at a speed of its gas generator: the heat that holds it.

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].

    Source: P_turbine = P_compressor, over T_4.

    Raises:
        ValueError: No heat holds it: beyond its ceiling or its speeds.
    """

    from scipy.optimize import brentq

    def surplus(hot: float) -> float:
        return state_at(engine, inlet, speed, hot).surplus

    low = state_at(engine, inlet, speed, HOTTEST).compressor_exit + 1.0
    if surplus(HOTTEST) < 0.0 or surplus(low) > 0.0:
        raise ValueError(f"no gas up to {HOTTEST:g} K holds {speed / engine.rated.speed:.3f} of N1")
    return state_at(engine, inlet, speed, float(brentq(surplus, low, HOTTEST, xtol=1e-9, rtol=1e-14)))


def state_for(engine: Turboshaft, inlet: Inlet, power: float, guess: tuple[float, float]) -> tuple[float, EngineState]:
    """Return the speed of the gas generator at which an engine at rest gives a power [rad/s], and its state.

    Args:
        engine: The engine.
        inlet: The air before it.
        power: Of the power turbine [W].
        guess: Speed [rad/s] and T_4 [K] near it.

    Source: Newton's method on surplus and power, over N1 and T_4.

    Raises:
        ValueError: It cannot give the power at rest.
    """
    scale = np.array([engine.rated.speed, 1000.0])

    def missing(at: Floats) -> Floats:
        if not (0.2 < at[0] < 1.6 and 0.3 < at[1] < 1e-3 * HOTTEST):
            raise ValueError(f"{power / 1e3:.4g} kW are beyond what it gives at rest in this air")
        state = state_at(engine, inlet, *(at * scale))
        return np.array([state.surplus, state.power - power]) / engine.rated.power

    at = np.array(guess) / scale
    wrong = missing(at)
    for _ in range(40):
        if np.max(np.abs(wrong)) <= 1e-12:
            break
        slopes = np.column_stack([(missing(at + step) - wrong) / 1e-6 for step in 1e-6 * np.eye(2)])
        step = -np.linalg.solve(slopes, wrong)
        at = at + step * min(1.0, 0.15 / float(np.max(np.abs(step))))
        wrong = missing(at)
    return float(at[0] * scale[0]), state_at(engine, inlet, *(at * scale))


# ----------------------------------------------------------------------------------------------------------------------
# What leaves a turbine beside its shaft: exhaust, by flow and temperature, and heat through the casing.
# ----------------------------------------------------------------------------------------------------------------------


class Breathing(NamedTuple):
    """How much air a turbine breathes that is known by its fuel flow alone, and what heats its surroundings."""

    air_flow: float
    """At its thermal power, at sea level on a standard day [kg/s]."""
    idle_air: float
    """Part of it that flows without power [-]."""
    casing_loss: float
    """Part of the fuel's heat that leaves through casing and oil [-]."""


class Exhaust(NamedTuple):
    """The state of what leaves one turbine, or several whose gas mixes."""

    air_flow: Values = 0.0
    """[kg/s]"""
    fuel_flow: Values = 0.0
    """[kg/s]"""
    temperature: Values = 0.0
    """Stagnation temperature of the gas [K]; of one that is off, that of the air."""
    casing: Values = 0.0
    """Heat through the casing [W]."""


def air_flow(breathing: Breathing, theta: Values, delta: Values, part: Values) -> Values:
    """Return the air that a turbine breathes [kg/s].

    Args:
        breathing: The turbine.
        theta: Stagnation temperature over that of the standard sea level θ_t [-].
        delta: Stagnation pressure, likewise δ_t [-].
        part: Power over what its core gives in this air [-].

    Source: m = m_0 δ_t θ_t^-1/2 (i + (1 - i) P/P_core): choked turbine; linear in power as an assumption.
    """
    of = functions(theta)
    return breathing.air_flow * delta / of.sqrt(theta) * (breathing.idle_air + (1.0 - breathing.idle_air) * part)


def exhaust_of(breathing: Breathing, air: Floats, inlet: Floats, *, fuel: Floats, power: Floats) -> Exhaust:
    """Return the states in which a turbine's gas must leave it, fields of shape (n,); of one that is off, the air's.

    Args:
        breathing: The turbine.
        air: Its air flow, shape (n,) [kg/s].
        inlet: Stagnation temperature of the air, shape (n,) [K].
        fuel: Fuel flow, shape (n,) [kg/s].
        power: At its shaft, shape (n,) [W].

    Source: steady energy of the engine: (m_a + m_f) h(T, f) = m_a h(T_0) + m_f H - P - Q_casing, solved for T.
    """
    runs, state = fuel > 0.0, Exhaust(np.zeros(len(air)), np.zeros(len(air)), inlet.copy(), np.zeros(len(air)))
    if runs.any():
        air, inlet, fuel, power = air[runs], inlet[runs], fuel[runs], power[runs]
        casing = breathing.casing_loss * fuel * HEATING_VALUE
        left = air * enthalpy(AIR, inlet) + fuel * HEATING_VALUE - power - casing
        burning = Exhaust(air, fuel, temperature_of(Gas(fuel / air), left / (air + fuel)), casing)
        for column, values in zip(state, burning, strict=True):
            column[runs] = values
    return state


def mixed(flows: Sequence[Exhaust]) -> Exhaust:
    """Return the gas of several turbines mixed into one, by those that run together; fields of shape (n,).

    Args:
        flows: Of every turbine, at least one.

    Source: conservation of mass and enthalpy.
    """
    if len(flows) == 1:
        return flows[0]
    state = Exhaust(*(column.copy() for column in flows[0]))
    runs = np.stack([flow.fuel_flow > 0.0 for flow in flows])
    for pattern in np.unique(runs, axis=1).T:
        lanes = (runs == pattern[:, None]).all(axis=0)
        running = [_some(flow, lanes) for flow, on in zip(flows, pattern, strict=True) if on]
        if running:
            for column, values in zip(state, _joined(running), strict=True):
                column[lanes] = values
    return state


def _some(flow: Exhaust, lanes: Bools) -> Exhaust:
    return Exhaust(*(column[lanes] for column in flow))


def _joined(running: Sequence[Exhaust]) -> Exhaust:
    if len(running) == 1:
        return running[0]
    air, fuel = sum(flow.air_flow for flow in running), sum(flow.fuel_flow for flow in running)
    carried = sum((gas.air_flow + gas.fuel_flow) * enthalpy(_gas(gas), gas.temperature) for gas in running)
    warm = temperature_of(Gas(fuel / air), carried / (air + fuel))
    return Exhaust(air, fuel, warm, sum(flow.casing for flow in running))


def exhaust_heat(exhaust: Exhaust, inlet: Floats) -> Floats:
    """Return what the exhaust carries away over what the air brought, by their states alone, shape (n,) [W].

    Args:
        exhaust: Flows and temperature, fields of shape (n,).
        inlet: Stagnation temperature of the air, shape (n,) [K].

    Source: (m_a + m_f) h(T, f) - m_a h(T_0).
    """
    runs, heat = exhaust.fuel_flow > 0.0, np.zeros(len(inlet))
    if runs.any():
        burning = _some(exhaust, runs)
        away = (burning.air_flow + burning.fuel_flow) * enthalpy(_gas(burning), burning.temperature)
        heat[runs] = away - burning.air_flow * enthalpy(AIR, inlet[runs])
    return heat


def _gas(exhaust: Exhaust) -> Gas:
    return Gas(exhaust.fuel_flow / exhaust.air_flow)
