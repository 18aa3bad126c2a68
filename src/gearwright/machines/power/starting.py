"""A gas generator from rest to idle: cranked by a starter, lit, and on its own, below the speeds at which it chokes."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.gas_turbine import HEATING_VALUE
from gearwright.machines.power.gases import AIR, Gas, enthalpy, temperature_of
from gearwright.machines.power.turboshaft import (
    HOTTEST,
    STANDARD_PRESSURE,
    STANDARD_TEMPERATURE,
    Inlet,
    Turboshaft,
    compressed_to,
    first_exit,
)

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
    return (1.0 / rated.mechanical - 1.0) * rated.air_flow * rise / rated.speed


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
