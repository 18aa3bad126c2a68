"""Phases whose path is stated: rate or angle of climb, speed, time or distance; the thrust follows from them."""

from __future__ import annotations

import math
from collections.abc import Callable

from gearwright.air import air_at
from gearwright.errors import DesignError, Problem
from gearwright.mission.moments import Node, Path, edges, speed_by_law
from gearwright.spec import Mission, Phase

LEAST = 4
"""Intervals of a climb at an angle, at least [-]."""


def stated_path(mission: Mission, phase: Phase, start: Node) -> Path:
    """Return the path of a phase that states it.

    Args:
        mission: With its steps and air.
        phase: The phase.
        start: Where the phase before ended, and at which speed.

    Raises:
        DesignError: A speed that is not flown where it is asked.
    """

    def speed(altitude: float) -> float:
        return speed_by_law(phase, air_at(altitude, mission.isa_offset_k))

    if phase.kind == "speed-change":
        nodes = _changing(mission, phase, start, speed(start.altitude))
    elif phase.path_angle is not None:
        nodes = _inclined(mission, phase, start.altitude, speed)
    else:
        duration = _duration(phase, start.altitude, speed)
        times = edges(duration, phase.ramp, mission.step)
        climb = (phase.altitude - start.altitude) / duration
        heights = [start.altitude + climb * time for time in times[:-1]] + [phase.altitude]
        nodes = [Node(time, height, speed(height)) for time, height in zip(times, heights, strict=True)]
    stage = "roll" if phase.kind == "taxi" else "flight"
    return Path(tuple(nodes), (stage,) * (len(nodes) - 1))


def _duration(phase: Phase, altitude: float, speed: Callable[[float], float]) -> float:
    if phase.duration is not None:
        return phase.duration
    if phase.distance is not None:
        flown = speed(altitude)
        if flown <= 0.0:
            raise DesignError([Problem("speed", f"{flown:g} m/s never flies a distance; fly faster")])
        return phase.distance / flown
    return (phase.altitude - altitude) / (phase.rate_of_climb or math.nan)


def _changing(mission: Mission, phase: Phase, start: Node, speed: float) -> list[Node]:
    """Return the nodes of a steady change of speed on the level."""
    duration = phase.duration or math.nan
    times = edges(duration, phase.ramp, mission.step)
    return [Node(time, start.altitude, start.speed + (speed - start.speed) * time / duration) for time in times]


def _inclined(mission: Mission, phase: Phase, altitude: float, speed: Callable[[float], float]) -> list[Node]:
    """Return the nodes of a path at an angle, whose speed of climb follows the airspeed."""
    slope, rise = math.sin(phase.path_angle or math.nan), phase.altitude - altitude
    longest = abs(rise / slope) / min(speed(altitude), speed(phase.altitude))
    count = max(math.ceil(longest / mission.step), LEAST)
    nodes = [Node(0.0, altitude, speed(altitude))]
    for k in range(1, count + 1):
        height = altitude + rise * k / count if k < count else phase.altitude
        flown, last = speed(height), nodes[-1]
        time = last.time + (height - last.altitude) / (slope * 0.5 * (flown + last.speed))
        nodes.append(Node(time, height, flown))
    return nodes
