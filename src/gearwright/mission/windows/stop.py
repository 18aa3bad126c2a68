"""Sudden stop: the propeller or a machine seizes, or a brake is put on, and everything that turns comes to rest."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from gearwright.catalogue import ALL_STATES, propeller_map
from gearwright.dynamics.model import MachineDrive
from gearwright.errors import DesignError, Problem, near
from gearwright.machines import PropellerMap
from gearwright.mission.windows.background import Background, Brake
from gearwright.mission.windows.curves import blended, lagged, value_at
from gearwright.spec import WindowRules

CREEP = 0.01
"""Part of the speed below which a brake's torque falls with it, so that it does not change its sense by steps [-]."""
STEADY = 1e-3
"""Time in which that speed may fade at the fastest: the rigid pass has such steps [s]."""
RESTS = 2.0
"""Times that part of the speed which counts as rest [-]."""


def seized(rules: WindowRules, propeller: str, machines: Mapping[str, object]) -> str:
    """Return what comes to a stop: the propeller, or the machine that is named.

    Args:
        rules: What happens.
        propeller: Its name.
        machines: Turbines, motors and others of the design by name.

    Raises:
        DesignError: There is no such machine.
    """
    if rules.machine is not None and rules.machine not in (propeller, *machines):
        message = f"no such machine: {rules.machine}; {near(rules.machine, [propeller, *machines])}"
        raise DesignError([Problem("windows", message)])
    return rules.machine or propeller


def stopped(back: Background, rules: WindowRules) -> Background:
    """Return a background in which something seizes; machines go on, or fail by the event's time constant.

    Args:
        back: What goes on.
        rules: What happens.

    Source: T = J ω/t for a stop in the time t, J of everything that turns at the shaft that is held; Coulomb friction,
        which holds what it has stopped.
    """
    name = seized(rules, back.gearbox.propeller, back.flight.machines)
    ahead = value_at(back.speed, rules.event_at)
    speed = ahead * turning(back, name)
    whole = back.gearbox.inertia * (ahead / speed) ** 2
    torque = rules.brake_torque or whole * speed / (rules.stop_time or 1.0)
    takes = whole * speed / torque
    creep = max(CREEP, STEADY / takes)
    end = rules.event_at + min(rules.over, 0.5 * takes)
    curve = [(rules.event_at, 0.0), (end, -torque), (end + 1e-6, -torque / creep)]
    torques = {
        machine: blended(known, [(0.0, 0.0)], rules)
        if machine == name
        else known
        if rules.lag is None
        else lagged(known, 0.0, rules)
        for machine, known in back.torques.items()
    }
    fading = rules.model_copy(update={"over": takes})
    return replace(
        back,
        torques=torques,
        resistances={shaft: blended(known, [(0.0, 0.0)], fading) for shaft, known in back.resistances.items()},
        brake=Brake(name, torque, curve, speed, creep),
    )


def turning(back: Background, name: str) -> float:
    """Return the speed of a machine over that of the propeller [-].

    Args:
        back: What goes on.
        name: Of the machine, or of the propeller.
    """
    if name not in back.flight.machines:
        return 1.0
    speeds = back.flight.machines[name].speed, back.flight.history.propeller_speed
    return abs(float(speeds[0][back.interval])) / float(speeds[1][back.interval])


def brake_drive(brake: Brake) -> MachineDrive:
    """Return the law of a brake: a constant torque against the speed, which fades with it at the very end.

    Args:
        brake: That holds a shaft.
    """
    return MachineDrive("brake", brake.machine, brake.curve, brake.speed, -1.0, brake.torque)


def stream_map(name: str, chart: PropellerMap) -> PropellerMap:
    """Return a map of blades that come to rest in a stream: of a shipped one that in all states.

    Args:
        name: Of the mission's map.
        chart: That map.
    """
    full = f"{name}-all-states"
    return propeller_map(full) if full in ALL_STATES else chart


def rest_time(time: np.ndarray, speed: np.ndarray, creep: float) -> float | None:
    """Return when a speed has come to rest [s]; None where it has not.

    Args:
        time: Middles of bins, shape (n,) [s].
        speed: Means in them, shape (n,) [rad/s].
        creep: Part of the speed at the start below which a brake's torque fades [-].
    """
    moving = np.flatnonzero(np.abs(speed) > RESTS * creep * abs(float(speed[0])))
    if not len(moving):
        return float(time[0])
    return float(time[moving[-1] + 1]) if moving[-1] + 1 < len(time) else None
