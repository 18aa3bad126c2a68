"""Transients of a gas generator: acceleration, starting, and a governed rotor on a free turbine."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.machines.turboshaft import (
    AIR,
    HEATING_VALUE,
    HOTTEST,
    STANDARD_PRESSURE,
    STANDARD_TEMPERATURE,
    EngineState,
    Gas,
    Inlet,
    Turboshaft,
    compressed_to,
    enthalpy,
    first_exit,
    state_at,
    temperature_of,
)

# ----------------------------------------------------------------------------------------------------------------------
# A gas generator that spools up and down, and the fuel control that keeps it within its limits.
# ----------------------------------------------------------------------------------------------------------------------


_ROUNDS = 60
_SETTLED = 1e-11
"""Difference of a fuel flow that is met, over the rated one [-]."""


class FuelControl(NamedTuple):
    """How fuel follows a demanded speed of the gas generator, and what bounds it."""

    gain: float
    """Fuel over speed error [kg/s/(rad/s)]."""
    integral: float
    """Fuel over the error's integral [kg/s/rad]."""
    time: float
    """Of the metering valve τ [s]."""
    highest_speed: float
    """N1 that it never demands more than [rad/s]."""
    hottest: float
    """T_45 that the fuel is cut back to [K]."""
    accelerating: float
    """Highest fuel over p_3 [kg/(s Pa)]: keeps the compressor from surge."""
    decelerating: float
    """Lowest [kg/(s Pa)]: keeps the fire."""


class SpoolStep(NamedTuple):
    """An engine after a step of time."""

    speed: float
    """N1 [rad/s]."""
    fuel: float
    """That flows [kg/s]."""
    integral: float
    """Of the speed error [rad]."""
    state: EngineState
    """At its start."""


class Spooled(NamedTuple):
    """Histories of a gas generator, shape (steps + 1,)."""

    time: Floats
    """[s]"""
    speed: Floats
    """N1 [rad/s]."""
    fuel: Floats
    """[kg/s]"""
    power: Floats
    """Of the power turbine [W]."""
    between: Floats
    """T_45 [K]."""
    fuel_over_pressure: Floats
    """Fuel over p_3 [kg/(s Pa)]."""


def fuelled(engine: Turboshaft, inlet: Inlet, speed: float, fuel: float, near: float) -> EngineState:
    """Return an engine with a speed and a fuel flow, from a temperature near that of its burner.

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].
        fuel: Fuel flow [kg/s].
        near: T_4 near its own [K].

    Source: secants over T_4.

    Raises:
        ValueError: The gas would be hotter than 2000 K.
    """
    hot, other = near, near * 1.01
    state = state_at(engine, inlet, speed, hot)
    for _ in range(_ROUNDS):
        if abs(state.fuel_flow - fuel) <= _SETTLED * engine.rated.fuel_flow:
            return state
        there = state_at(engine, inlet, speed, other)
        slope = (there.fuel_flow - state.fuel_flow) / (other - hot)
        hot, state = other, there
        other = min(max(hot - (state.fuel_flow - fuel) / slope, 300.0), HOTTEST)
        if other == hot:
            break
    if abs(state.fuel_flow - fuel) > 1e-6 * engine.rated.fuel_flow:
        raise ValueError(f"{fuel:.4g} kg/s at N1 = {speed:.4g} rad/s would burn beyond {HOTTEST:g} K")
    return state


def limited_fuel(control: FuelControl, state: EngineState, inlet: Inlet, asked: float) -> float:
    """Return the fuel that a control lets through [kg/s].

    Args:
        control: Its limits.
        state: Of the engine.
        inlet: The air before it.
        asked: Fuel that its governor asks for [kg/s].

    Source: schedules of fuel over p_3 for acceleration and deceleration; T_45 limit by the slope of its heat.
    """
    pressure = inlet.pressure * state.pressure_ratio
    slope = (state.between - inlet.temperature) / state.fuel_flow  # of T_45 over fuel, to first order
    cool = state.fuel_flow + (control.hottest - state.between) / slope
    highest = min(control.accelerating * pressure, cool)
    return max(min(asked, highest), control.decelerating * pressure)


def spool(
    engine: Turboshaft,
    control: FuelControl,
    inlet: Inlet,
    *,
    start: SpoolStep,
    demand: Callable[[float], float],
    times: tuple[float, float],
) -> Spooled:
    """Return how a gas generator follows a demanded speed.

    Args:
        engine: The engine.
        control: Its fuel control.
        inlet: The air before it.
        start: Speed, fuel and integral to begin with.
        demand: Time [s] -> demanded N1 [rad/s].
        times: Duration and step [s].

    Source: J N1 dN1/dt = P_turbine - P_compressor, by the midpoint rule; valve of first order, exact over a step.
    """
    duration, step = times
    count, now = round(duration / step), start
    rows = [_spool_row(0.0, inlet, now)]
    for k in range(count):
        now = stepped(engine, control, inlet, now, demanded=demand((k + 0.5) * step), step=step)
        rows.append(_spool_row((k + 1) * step, inlet, now))
    return Spooled(*np.array(rows).T)


def _spool_row(time: float, inlet: Inlet, now: SpoolStep) -> tuple[float, ...]:
    state = now.state
    pressure = inlet.pressure * state.pressure_ratio
    return (time, now.speed, now.fuel, state.power, state.between, now.fuel / pressure)


def stepped(
    engine: Turboshaft, control: FuelControl, inlet: Inlet, now: SpoolStep, *, demanded: float, step: float
) -> SpoolStep:
    """Return a gas generator after a step of time.

    Args:
        engine: The engine.
        control: Its fuel control.
        inlet: The air before it.
        now: As it is.
        demanded: N1 [rad/s].
        step: [s].

    Source: midpoint rule; valve of first order, exact over a step; the integral rests at a limit.
    """
    inertia = engine.rated.inertia
    error = min(demanded, control.highest_speed) - now.speed
    asked = control.gain * error + control.integral * (now.integral + error * step)
    let = limited_fuel(control, now.state, inlet, asked)
    summed = now.integral + error * step if let == asked else now.integral  # no winding up at a limit
    half = let + (now.fuel - let) * math.exp(-0.5 * step / control.time)
    fuel = let + (now.fuel - let) * math.exp(-step / control.time)
    middle = now.speed + 0.5 * step * now.state.surplus / (inertia * now.speed)
    between = fuelled(engine, inlet, middle, half, now.state.turbine_inlet)
    speed = now.speed + step * between.surplus / (inertia * middle)
    return SpoolStep(speed, fuel, summed, fuelled(engine, inlet, speed, fuel, between.turbine_inlet))


def at_rest(engine: Turboshaft, inlet: Inlet, speed: float, state: EngineState, control: FuelControl) -> SpoolStep:
    """Return a step with which an engine stays as it is.

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].
        state: At rest there.
        control: Whose integral holds the fuel.
    """
    near = fuelled(engine, inlet, speed, state.fuel_flow, state.turbine_inlet)
    return SpoolStep(speed, state.fuel_flow, state.fuel_flow / control.integral, near)


def time_constant(engine: Turboshaft, inlet: Inlet, speed: float, state: EngineState) -> float:
    """Return the time in which a gas generator at rest follows a small step of fuel to 63 % [s].

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].
        state: At rest there.

    Source: τ = -J N1/(dP_surplus/dN1) at constant fuel: the linear limit of the spool.
    """
    step = 1e-4 * speed
    up, down = (
        fuelled(engine, inlet, speed + sign * step, state.fuel_flow, state.turbine_inlet).surplus
        for sign in (1.0, -1.0)
    )
    return -engine.rated.inertia * speed * 2.0 * step / (up - down)


# ----------------------------------------------------------------------------------------------------------------------
# A gas generator from rest to idle: cranked by a starter, lit, and on its own, below the speeds at which it chokes.
# ----------------------------------------------------------------------------------------------------------------------


CHOKED = 0.54
"""p_45/p_4 up to which a nozzle row chokes [-]; of a perfect gas with κ = 1.33."""
LEAN = 0.1
"""Fuel that lights, and that keeps the fire, over that of the schedule [-]; an assumption."""
VALVE = 0.3
"""In which fuel follows its schedule while it starts [s]; an assumption."""
_LEAST_FLOW = 1e-6
"""Of the rated flow [-]."""


class Starter(NamedTuple):
    """What turns a gas generator until it turns itself, and the fuel that lights it."""

    torque: float
    """At rest, on the shaft of the gas generator [N m]."""
    free: float
    """N1 at which it falls to nothing, linearly [rad/s]."""
    cut: float
    """N1 at which it is switched off [rad/s]."""
    light: float
    """N1 at which fuel flows [rad/s]."""
    accelerating: float
    """Fuel over p_3 [kg/(s Pa)]."""
    hottest: float
    """T_45 to which the fuel is cut back [K]."""


class Cranked(NamedTuple):
    """A gas generator at one instant of its start; its power turbine stands."""

    air_flow: float
    """[kg/s]"""
    pressure_ratio: float
    """p_3/p_2 [-]."""
    between: float
    """T_45 [K]."""
    turbine: float
    """Of the gas on its turbine [W]."""
    compressor: float
    """Into the air [W]."""
    friction: float
    """[W]"""

    @property
    def surplus(self) -> float:
        """What accelerates it, beside the starter [W]."""
        return self.turbine - self.compressor - self.friction


class Start(NamedTuple):
    """Histories of a start, shape (steps + 1,)."""

    time: Floats
    """[s]"""
    speed: Floats
    """N1 [rad/s]."""
    fuel: Floats
    """[kg/s]"""
    between: Floats
    """T_45 [K]."""
    starter: Floats
    """Power of the starter [W]."""
    surplus: Floats
    """Of turbine over compressor and friction [W]."""


def cranked(engine: Turboshaft, inlet: Inlet, speed: float, fuel: float) -> Cranked:
    """Return a gas generator at any speed, choked or not.

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].
        fuel: Fuel flow; 0: it is cranked cold [kg/s].

    Source: as `state_at`, with a first nozzle by the ellipse φ = √(1 - ((r - r_c)/(1 - r_c))²) below its choking, r =
        p_45/p_4; losses of pressure with the square of the flow; power turbine by Stodola's ellipse, p_45² = p_5² +
        m² T_45/k². Friction is a torque, that of the design point.

    Valid for: orders of magnitude; a compressor's efficiency far below its map is 1 - (1 - N1/N1_0)² of the rated one.

    Raises:
        ValueError: So much fuel in so little air burns beyond 2000 K.
    """
    from scipy.optimize import brentq

    rated = engine.rated
    t3, ratio = compressed_to(engine, inlet, speed)
    flow0 = rated.air_flow + rated.fuel_flow

    def through(air: float) -> tuple[float, float, float, float]:
        """Return the flow that the first nozzle passes less that of this air [kg/s], T_4, T_45 and the flow."""
        flow, gas = air + fuel, Gas(rated.combustion * fuel / air)
        heat = (rated.combustion - rated.casing_loss) * fuel * HEATING_VALUE
        t4 = temperature_of(gas, (air * enthalpy(AIR, t3) + heat) / flow)
        thick = (flow / flow0) ** 2
        p4 = inlet.pressure * ratio * (1.0 - rated.burner_loss * thick / _squared(engine, inlet, ratio))
        behind = inlet.ambient * (1.0 + (rated.exit_ratio - 1.0) * thick * (STANDARD_PRESSURE / inlet.ambient) ** 2)
        t45 = t4
        for _ in range(4):
            p45 = math.sqrt(behind**2 + flow**2 * t45 / engine.power_nozzle**2)
            t45 = first_exit(engine, gas, t4, max(p4 / p45, 1.0))
        above = min(max((min(p45 / p4, 1.0) - CHOKED) / (1.0 - CHOKED), 0.0), 1.0)
        passed = engine.gas_nozzle * p4 / math.sqrt(t4) * math.sqrt(1.0 - above**2)
        return passed - flow, t4, t45, flow

    low, high = max(_LEAST_FLOW * flow0, fuel / 0.055), 1.5 * flow0
    if fuel and through(low)[1] > HOTTEST:
        low = float(brentq(lambda air: through(air)[1] - HOTTEST, low, high))
    if through(low)[0] < 0.0:
        raise ValueError(f"{fuel:.4g} kg/s at {speed / rated.speed:.3f} of N1 burn beyond {HOTTEST:g} K")
    air = float(brentq(lambda at: through(at)[0], low, high, xtol=1e-10 * flow0, rtol=1e-12))
    _, t4, t45, flow = through(air)
    gas = Gas(rated.combustion * fuel / air)
    work = flow * (enthalpy(gas, t4) - enthalpy(gas, t45))
    compressor = air * (enthalpy(AIR, t3) - enthalpy(AIR, inlet.temperature))
    return Cranked(air, ratio, t45, work, compressor, friction_torque(engine) * speed)


def _squared(engine: Turboshaft, inlet: Inlet, ratio: float) -> float:
    """Return (p_3/p_3,0)², which the flow's square is over for a corrected flow [-]."""
    return (inlet.pressure * ratio / (STANDARD_PRESSURE * engine.rated.pressure_ratio)) ** 2


def friction_torque(engine: Turboshaft) -> float:
    """Return the torque of bearings and seals of a gas generator [N m].

    Args:
        engine: Whose mechanical efficiency tells it at the design point.
    """
    rated = engine.rated
    rise = enthalpy(AIR, STANDARD_TEMPERATURE * (1.0 + engine.rise)) - enthalpy(AIR, STANDARD_TEMPERATURE)
    return float((1.0 / rated.mechanical - 1.0) * rated.air_flow * rise / rated.speed)


def started(engine: Turboshaft, starter: Starter, inlet: Inlet, *, idle: float, times: tuple[float, float]) -> Start:
    """Return how an engine starts, until idle or until time is over.

    Args:
        engine: The engine.
        starter: What cranks and lights it.
        inlet: The air before it.
        idle: N1 at which it has started [rad/s].
        times: Longest duration and step [s].

    Source: J N1 dN1/dt = P_starter + P_turbine - P_compressor - P_friction by Heun's rule on the energy of the rotor;
        fuel by its schedule over p_3, cut back in proportion to the heat beyond T_45's limit.
    """
    (longest, step), inertia = times, engine.rated.inertia
    speed, fuel = 1e-3 * engine.rated.speed, 0.0
    rows = list[tuple[float, ...]]()
    for k in range(round(longest / step) + 1):
        now = cranked(engine, inlet, speed, fuel)
        power = starting_power(starter, speed)
        rows.append((k * step, speed, fuel, now.between, power, now.surplus))
        if speed >= idle:
            break
        energy = 0.5 * inertia * speed**2
        first = math.sqrt(2.0 * max(energy + step * (power + now.surplus), 0.0) / inertia)
        there = cranked(engine, inlet, max(first, 1e-3 * engine.rated.speed), fuel)
        gained = 0.5 * step * (power + now.surplus + starting_power(starter, first) + there.surplus)
        speed = max(math.sqrt(2.0 * max(energy + gained, 0.0) / inertia), 1e-3 * engine.rated.speed)
        fuel = _lit(starter, inlet, there, (speed, fuel), step)
    return Start(*np.array(rows).T)


def starting_power(starter: Starter, speed: float) -> float:
    """Return the power of a starter [W].

    Args:
        starter: The starter.
        speed: N1 [rad/s].
    """
    return starter.torque * max(1.0 - speed / starter.free, 0.0) * speed if speed < starter.cut else 0.0


def _lit(starter: Starter, inlet: Inlet, now: Cranked, at: tuple[float, float], step: float) -> float:
    """Return the fuel of the next step [kg/s], at a speed [rad/s] and a fuel flow [kg/s]."""
    speed, fuel = at
    if speed < starter.light:
        return 0.0
    most = starter.accelerating * inlet.pressure * now.pressure_ratio
    if not fuel:
        return LEAN * most
    heat = now.between - inlet.temperature
    wanted = min(most, fuel * (1.0 + (starter.hottest - now.between) / heat))
    return max(fuel + (wanted - fuel) * -math.expm1(-step / VALVE), LEAN * most)


# ----------------------------------------------------------------------------------------------------------------------
# A rotor on a free turbine, whose speed N2 a governor holds by asking the gas generator for speed.
# ----------------------------------------------------------------------------------------------------------------------


class RotorGovernor(NamedTuple):
    """A rotor with all that turns with it, at the power turbine's shaft, and its governor."""

    inertia: float
    """[kg m²]"""
    speed: float
    """N2 that is held, at which the engine's power is told [rad/s]."""
    gain: float
    """N1 asked for an error of N2 [-]."""
    integral: float
    """N1 asked for the error's integral [1/s]; 0: a governor with droop."""
    highest: float = math.inf
    """N2 from which on no N1 is asked for, so that the least fuel flows [rad/s]."""


class Held(NamedTuple):
    """Histories of a rotor and its gas generator, shape (steps + 1,)."""

    time: Floats
    """[s]"""
    rotor: Floats
    """N2 [rad/s]."""
    speed: Floats
    """N1 [rad/s]."""
    fuel: Floats
    """[kg/s]"""
    torque: Floats
    """Of the power turbine [N m]."""
    load: Floats
    """That the rotor takes [N m]."""
    between: Floats
    """T_45 [K]."""


def turbine_torque(engine: Turboshaft, state: EngineState, rotor: float, speed: float) -> float:
    """Return the torque of a free turbine off the speed at which its power is told [N m].

    Args:
        engine: The engine.
        state: Of its gas, with its power at that speed.
        rotor: Speed of the turbine [rad/s].
        speed: At which the power is told [rad/s].

    Source: η = η_0 x (2 - x) with x ∝ ω/√Δh: T = (P + m η_0 Δh_0 (1 - ω/ω_0))/ω_0, which at the design point is P/ω_0
        (2 - ω/ω_0), the slope 1 of turbines in windows; slower gas falls off more steeply.
    """
    flow = state.air_flow + state.fuel_flow
    caught = flow * engine.power_efficiency * engine.drop
    return (state.power + caught * (1.0 - rotor / speed)) / speed


def held_rotor(
    engine: Turboshaft,
    control: FuelControl,
    governor: RotorGovernor,
    inlet: Inlet,
    *,
    start: SpoolStep,
    load: Callable[[float, float], float],
    times: tuple[float, float],
) -> Held:
    """Return how a governor on N2 holds a rotor whose load changes.

    Args:
        engine: The engine.
        control: Of the gas generator's fuel.
        governor: The rotor with its governor.
        inlet: The air before the engine.
        start: The gas generator to begin with; the rotor turns at the speed that is held.
        load: Time [s], N2 [rad/s] -> torque that the rotor takes [N m].
        times: Duration and step [s].

    Source: J dω/dt = T(P, ω) - Q(t, ω) by Heun's rule; the governor asks for N1 = N1_0 + K_p e + K_i ∫e dt with
        e = ω_0 - ω, which the fuel control follows within its limits (`spool`); the integral rests while it is beyond
        the highest N1. Beyond the highest N2 it asks for none.
    """
    duration, step = times
    now, rotor, summed, base = start, governor.speed, 0.0, start.speed
    rows = [_rotor_row(engine, 0.0, now, rotor=rotor, load=load(0.0, rotor), governor=governor)]
    for k in range(round(duration / step)):
        time, error = k * step, governor.speed - rotor
        wanted = base + governor.gain * error + governor.integral * (summed + error * step)
        if wanted < control.highest_speed:
            summed += error * step
        if rotor >= governor.highest:
            wanted = 0.0
        then = stepped(engine, control, inlet, now, demanded=wanted, step=step)
        first = _gain(engine, now, rotor=rotor, load=load(time, rotor), governor=governor)
        ahead = rotor + first * step
        second = _gain(engine, then, rotor=ahead, load=load(time + step, ahead), governor=governor)
        now, rotor = then, rotor + 0.5 * step * (first + second)
        rows.append(_rotor_row(engine, time + step, now, rotor=rotor, load=load(time + step, rotor), governor=governor))
    return Held(*np.array(rows).T)


def _gain(engine: Turboshaft, now: SpoolStep, *, rotor: float, load: float, governor: RotorGovernor) -> float:
    """Return dω/dt at a speed [rad/s] under a load [N m], in rad/s²."""
    return (turbine_torque(engine, now.state, rotor, governor.speed) - load) / governor.inertia


def _rotor_row(
    engine: Turboshaft, time: float, now: SpoolStep, *, rotor: float, load: float, governor: RotorGovernor
) -> tuple[float, ...]:
    torque = turbine_torque(engine, now.state, rotor, governor.speed)
    return (time, rotor, now.speed, now.fuel, torque, load, now.state.between)
