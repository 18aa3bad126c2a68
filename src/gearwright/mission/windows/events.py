"""Events: what a window changes of the mission that goes on in it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.mission.windows.background import Background, Curve, changed_stage
from gearwright.mission.windows.curves import blended, stepped, value_at
from gearwright.mission.windows.faults import engine_out, runaway, short_circuited, slammed, struck
from gearwright.mission.windows.stop import stopped
from gearwright.spec import WindowRules

GUST_POINTS = 48
"""Points of a 1-cos gust: straight lines between them are off by 1e-3 of it."""


def changed(back: Background, rules: WindowRules) -> Background:
    """Return a background with the window's event in it.

    Args:
        back: What goes on.
        rules: What happens.

    Raises:
        DesignError: A mode change needs a machine that the design lacks.
    """
    match rules.event:
        case "motor-cut":
            return _scaled(back, rules, set(back.supply.motors))
        case "turbine-cut":
            return _scaled(back, rules, set(back.supply.engines))
        case "mode-change":
            return _other_mode(back, rules)
        case "pitch-step":
            return replace(back, pitch=stepped([(0.0, 0.0)], rules, rules.pitch_step or 0.0))
        case "speed-step":
            return replace(back, speed=stepped(back.speed, rules, rules.speed_step or 0.0))
        case "gust":
            return replace(back, airspeed=_gust(back.airspeed, rules))
        case "clutch-engagement":
            return _joining(back, rules)
        case "motor-short-circuit":
            return short_circuited(back, rules)
        case "engine-out":
            return engine_out(back, rules)
        case "pitch-runaway":
            return runaway(back, rules)
        case "power-slam":
            return slammed(back, rules)
        case "propeller-strike":
            return struck(back, rules)
        case "sudden-stop":
            return stopped(back, rules)
        case _:
            return back


def _scaled(back: Background, rules: WindowRules, machines: set[str]) -> Background:
    """Return a background in which machines stop."""
    if not machines:
        message = f"{rules.event}, but the design has no such machine; choose another event"
        raise DesignError([Problem("windows", message)])
    torques = {
        name: blended(curve, [(0.0, 0.0)], rules) if name in machines else curve for name, curve in back.torques.items()
    }
    return replace(back, torques=torques)


def _other_mode(back: Background, rules: WindowRules) -> Background:
    """Return a background in which other machines share the power, or another one."""
    phase = back.flight.mission.phases[back.phase].model_copy(
        update={"mode": rules.mode, "electric_share": rules.electric_share}
    )
    before = sum(float(machine.power[back.interval]) for machine in back.flight.machines.values())
    power = before if rules.power is None else rules.power
    parts = back.supply.parts(phase)
    powers = {name: parts.get(name, 0.0) * power for name in back.gearbox.machines}
    after = changed_stage(back, rules, phase, powers)
    return replace(
        back,
        torques={name: blended(curve, [(0.0, after.torques[name])], rules) for name, curve in back.torques.items()},
        resistances={
            shaft: blended(curve, [(0.0, after.resistances[shaft])], rules) for shaft, curve in back.resistances.items()
        },
    )


def _gust(airspeed: Curve, rules: WindowRules) -> Curve:
    top = rules.gust or 0.0
    if rules.gust_shape == "step":
        return stepped(airspeed, rules, top)
    times = rules.event_at + np.linspace(0.0, rules.over, GUST_POINTS + 1)
    inside = [
        (float(time), value_at(airspeed, float(time)) + 0.5 * top * (1.0 - math.cos(2.0 * math.pi * k / GUST_POINTS)))
        for k, time in enumerate(times)
    ]
    outside = [(time, value) for time, value in airspeed if not times[0] <= time <= times[-1]]
    return sorted([*outside, *inside])


def _joining(back: Background, rules: WindowRules) -> Background:
    """Return a background in which the machine before a clutch gives nothing until the event."""
    joint = next((clutch for clutch in back.flight.sizing.train.joints if clutch.name == rules.clutch), None)
    train = back.flight.sizing.train
    torques = {
        name: blended([(0.0, 0.0)], curve, rules) if joint and train.machines[name] == joint.driving else curve
        for name, curve in back.torques.items()
    }
    return replace(back, torques=torques)
