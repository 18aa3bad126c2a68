"""A gas generator that spools up and down, and the fuel control that keeps it within its limits."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.power.turboshaft import HOTTEST, EngineState, Inlet, Turboshaft, state_at

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
    rows = [_row(0.0, inlet, now)]
    for k in range(count):
        now = stepped(engine, control, inlet, now, demanded=demand((k + 0.5) * step), step=step)
        rows.append(_row((k + 1) * step, inlet, now))
    return Spooled(*np.array(rows).T)


def _row(time: float, inlet: Inlet, now: SpoolStep) -> tuple[float, ...]:
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
