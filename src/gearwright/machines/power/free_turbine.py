"""A rotor on a free turbine, whose speed N2 a governor holds by asking the gas generator for speed."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.power.spools import FuelControl, SpoolStep, stepped
from gearwright.machines.power.turboshaft import EngineState, Inlet, Turboshaft


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
    rows = [_row(engine, 0.0, now, rotor=rotor, load=load(0.0, rotor), governor=governor)]
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
        rows.append(_row(engine, time + step, now, rotor=rotor, load=load(time + step, rotor), governor=governor))
    return Held(*np.array(rows).T)


def _gain(engine: Turboshaft, now: SpoolStep, *, rotor: float, load: float, governor: RotorGovernor) -> float:
    """Return dω/dt at a speed [rad/s] under a load [N m], in rad/s²."""
    return (turbine_torque(engine, now.state, rotor, governor.speed) - load) / governor.inertia


def _row(
    engine: Turboshaft, time: float, now: SpoolStep, *, rotor: float, load: float, governor: RotorGovernor
) -> tuple[float, ...]:
    torque = turbine_torque(engine, now.state, rotor, governor.speed)
    return (time, rotor, now.speed, now.fuel, torque, load, now.state.between)
