"""Faults and slams: short circuit of a motor, failure of an engine, pitch run-away, slam of the power lever, strike.

What every event shares is in `curves`; changes that a pilot or a gust makes are in `events`.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace

import numpy as np

from gearwright.dynamics import System
from gearwright.errors import DesignError, Problem, near
from gearwright.machines import Winding, short_circuit_torque
from gearwright.mission.supply import Supply
from gearwright.mission.windows.background import Background, Curve, changed_stage, flown_phase
from gearwright.mission.windows.curves import LAGS, blended, lagged, until, value_at
from gearwright.mission.windows.spools import spooled
from gearwright.spec import WindowRules

POINTS_PER_CYCLE = 32
"""Points of a short circuit's torque in one electric cycle: straight lines between them are off by 5e-3 of it."""
MOST_POINTS = 20_000
"""Of a short circuit's torque [-]."""
BEYOND = 3.2
"""Pitch command that is finer than every stop [rad]."""
SOON = 1e-3
"""Time in which the overspeed governor takes over [s]."""


def failing(supply: Supply, rules: WindowRules, at: str) -> str:
    """Return the machine that fails.

    Args:
        supply: Machines of the gearbox.
        rules: What happens.
        at: Path of the window.

    Raises:
        DesignError: The design has none of its kind, none of this name, or several.
    """
    short = rules.event == "motor-short-circuit"
    kind, machines = ("motor", supply.motors) if short else ("turbine", supply.engines)
    return _named(kind, machines, rules, at)


def _named(kind: str, machines: Collection[str], rules: WindowRules, at: str) -> str:
    if not machines:
        message = f"{rules.event}, but the design has no {kind}; choose another event, or a design with one"
        raise DesignError([Problem(f"{at}.event", message)])
    if rules.machine is None and len(machines) > 1:
        message = f"{rules.event} without machine, and the design has {', '.join(sorted(machines))}; name one"
        raise DesignError([Problem(f"{at}.machine", message)])
    if rules.machine is not None and rules.machine not in machines:
        message = f"no such {kind}: {rules.machine}; {near(rules.machine, machines)}"
        raise DesignError([Problem(f"{at}.machine", message)])
    return rules.machine or next(iter(machines))


def freewheels(back: Background, rules: WindowRules) -> dict[str, float]:
    """Return the overrunning clutches that let an engine go when it fails, with what they carry at first [N m].

    Args:
        back: What goes on.
        rules: What happens.
    """
    if rules.event != "engine-out":
        return {}
    name, train = failing(back.supply, rules, "windows"), back.flight.sizing.train
    return {
        joint.name: value_at(back.torques[name], 0.0)
        for joint in train.joints
        if joint.overrunning and joint.driving == train.machines[name]
    }


def winding_of(back: Background, rules: WindowRules, name: str) -> Winding:
    """Return the motor's winding; a resistance that is not given follows from its copper loss.

    Args:
        back: What goes on.
        rules: With E, L and p.
        name: Of the motor.

    Source: 3 R I² = k_c T² with T Ω_r = 3 E I, hence R = 3 k_c E²/Ω_r²; an estimate, as k_c itself is one where the
        mission does not state the shares of the motor's losses.
    """
    rated = back.flight.sizing.design.motors[name].speed
    emf, copper = rules.back_emf_v or 0.0, back.supply.motors[name].copper
    resistance = 3.0 * copper * (emf / rated) ** 2 if rules.resistance_ohm is None else rules.resistance_ohm
    return Winding(emf, (rules.inductance_mh or 0.0) * 1e-3, resistance, rules.pole_pairs or 1, rated)


def short_circuited(back: Background, rules: WindowRules) -> Background:
    """Return a background in which a motor's phases are short-circuited, its speed that at the window's start.

    Args:
        back: What goes on.
        rules: What happens.
    """
    name = failing(back.supply, rules, "windows")
    winding = winding_of(back, rules, name)
    before = value_at(back.torques[name], rules.event_at)
    speed = back.flight.machines[name].speed[back.interval] * value_at(back.speed, rules.event_at)
    speed = abs(float(speed)) / float(back.flight.history.propeller_speed[back.interval])
    cycle = 2.0 * math.pi / (winding.pole_pairs * speed)
    left = rules.duration - rules.event_at
    rings = LAGS * winding.inductance / winding.resistance if winding.resistance else left
    count = min(max(2, math.ceil(min(rings, left) / cycle * POINTS_PER_CYCLE)), MOST_POINTS)
    time = np.linspace(0.0, min(rings, left), count + 1)
    torque = short_circuit_torque(winding, speed, before=before, time=time)
    curve = [*until(back.torques[name], rules), *zip((rules.event_at + time).tolist(), torque.tolist(), strict=True)]
    return replace(back, torques={**back.torques, name: curve}, limits=False)


def engine_out(back: Background, rules: WindowRules) -> Background:
    """Return a background in which a turbine's torque dies with its time constant.

    Args:
        back: What goes on.
        rules: What happens.
    """
    name = failing(back.supply, rules, "windows")
    return replace(back, torques={**back.torques, name: lagged(back.torques[name], 0.0, rules)})


def slammed(back: Background, rules: WindowRules) -> Background:
    """Return a background in which all machines go to another power: turbines by their lag, motors within `over`.

    Args:
        back: What goes on.
        rules: What happens.
    """
    phase = flown_phase(back.flight, back.interval)
    parts = back.supply.parts(phase)
    powers = {name: parts.get(name, 0.0) * (rules.power or 0.0) for name in back.gearbox.machines}
    after = changed_stage(back, rules, phase, powers)
    return replace(
        back,
        torques={
            name: _sped_up(back, rules, name, (powers[name], after.torques[name]))
            if name in back.supply.engines
            else blended(curve, [(0.0, after.torques[name])], rules)
            for name, curve in back.torques.items()
        },
        resistances={
            shaft: blended(curve, [(0.0, after.resistances[shaft])], rules) for shaft, curve in back.resistances.items()
        },
    )


def _sped_up(back: Background, rules: WindowRules, name: str, end: tuple[float, float]) -> Curve:
    """Return a turbine's torque until a power [W] and a torque [N m], by its lag or by its gas generator."""
    if rules.lag is None and back.flight.mission.engine.spool is not None:
        return spooled(back, rules, name, power=end[0], torque=end[1])
    return lagged(back.torques[name], end[1], rules)


def struck(back: Background, rules: WindowRules) -> Background:
    """Return a background in which the propeller strikes: a torque that rises within `over` and lasts.

    Args:
        back: What goes on.
        rules: What happens.

    Source: T = J ω/t for a stop in the time t, J of everything that turns, at the propeller.
    """
    speed = value_at(back.speed, rules.event_at)
    torque = rules.strike_torque or back.gearbox.inertia * speed / (rules.stop_time or math.inf)
    start, end = rules.event_at, rules.event_at + (rules.lasts or 0.0)
    rise = min(rules.over, 0.5 * (end - start))
    return replace(back, strike=[(start, 0.0), (start + rise, -torque), (end - rise, -torque), (end, 0.0)])


def runaway(back: Background, rules: WindowRules) -> Background:
    """Return a background in which the pitch runs to its fine stop, as fast as its actuator moves.

    Args:
        back: What goes on.
        rules: What happens.
    """
    share = rules.overspeed or 1.0
    held = blended(back.speed, [(time, share * value) for time, value in back.speed], rules)
    return replace(back, pitch=[(rules.event_at, 0.0), (rules.event_at + SOON, -BEYOND)], held_speed=held)


def caught(back: Background, rules: WindowRules, system: System) -> Background | None:
    """Return a background in which the overspeed governor takes the pitch over; None where nothing reaches its speed.

    Args:
        back: With a pitch that runs away.
        rules: What happens.
        system: With the speed profile of the run-away.
    """
    profile, limit = system.arrays.profile, rules.overspeed or 1.0
    over = np.flatnonzero(profile.factor >= limit * profile.factor[0])
    if back.held_speed is None or not len(over):
        return None
    time = float(profile.time[over[0]])
    return replace(back, pitch=[*back.pitch, (time, -BEYOND), (time + SOON, 0.0)])
