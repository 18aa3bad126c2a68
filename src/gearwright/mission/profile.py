"""A mission cut into intervals: where the aircraft is in the middle of each, and what it asks of the gearbox."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from gearwright.air import Air, air_at, true_of_calibrated
from gearwright.errors import DesignError, Problem
from gearwright.spec import Mission, Phase


class Moment(NamedTuple):
    """The middle of one interval."""

    phase: str
    """Name of its phase."""
    starts_phase: bool
    """True for the first interval of a phase."""
    time: float
    """Of its middle, from the start of the mission [s]."""
    duration: float
    """[s]"""
    altitude: float
    """[m]"""
    air: Air
    """Around the aircraft."""
    true_airspeed: float
    """[m/s]"""
    acceleration: float
    """Change of the true airspeed along the path [m/s²]."""
    climb: float
    """Rate of climb [m/s]."""
    propeller_speed: float
    """Mean of the interval [rad/s]."""
    propeller_gain: float
    """Change of the propeller's speed over the interval [rad/s]."""
    power: float | None
    """Asked of all machines of one gearbox [W]; None where pitch or thrust set it."""

    @property
    def mach(self) -> float:
        """Flight Mach number [-]."""
        return self.true_airspeed / self.air.sound_speed


class _Cut(NamedTuple):
    """One interval of a phase, from the phase's start."""

    start: float
    """[s]"""
    end: float
    """[s]"""
    duration: float
    """Of the phase [s]."""


class _Before(NamedTuple):
    """Where the phase before ended."""

    clock: float
    """From the start of the mission [s]."""
    altitude: float
    """[m]"""
    speed: float
    """Of the propeller [rad/s]."""


def moments(mission: Mission) -> Iterator[Moment]:
    """Yield the intervals of a mission in their order.

    Args:
        mission: As read.

    Raises:
        DesignError: A speed that is supersonic where it is flown; with the phase.
    """
    first = next(iter(mission.phases.values()))
    altitude = first.altitude if first.from_altitude is None else first.from_altitude
    before = _Before(0.0, altitude, first.propeller_speed)
    for name, phase in mission.phases.items():
        duration = phase_duration(phase, before.altitude)
        edges = _edges(duration, phase.ramp, mission.step)
        for start, end in pairwise(edges):
            yield _moment(mission, name, _Cut(start, end, duration), before)
        before = _Before(before.clock + duration, phase.altitude, _ramped(phase, duration, before.speed))


def phase_duration(phase: Phase, altitude: float) -> float:
    """Return how long a phase takes [s].

    Args:
        phase: As read.
        altitude: At its start [m].
    """
    if phase.duration is not None:
        return phase.duration
    return (phase.altitude - altitude) / (phase.rate_of_climb or math.nan)


def _edges(duration: float, ramp: float, step: float) -> list[float]:
    """Cut a phase so that no interval is longer than a step, and the end of the ramp is a cut."""
    middle = min(ramp, duration)
    edges = [0.0]
    for start, end in ((0.0, middle), (middle, duration)):
        count = max(math.ceil((end - start) / step - 1e-9), 1) if end > start else 0
        edges += [start + (end - start) * k / count for k in range(1, count + 1)]
    return edges


def _ramped(phase: Phase, time: float, before: float) -> float:
    return before + (phase.propeller_speed - before) * min(time / phase.ramp, 1.0)


def _moment(mission: Mission, name: str, cut: _Cut, before: _Before) -> Moment:
    phase, (start, end, duration) = mission.phases[name], cut
    part = 0.5 * (start + end) / duration
    altitude = before.altitude + (phase.altitude - before.altitude) * part
    air = air_at(altitude, mission.isa_offset_k)
    airspeeds = [_true_airspeed(mission, name, before, time / duration) for time in (start, end)]
    speeds = [_ramped(phase, time, before.speed) for time in (start, end)]
    power = phase.power
    if power is not None and phase.end_power is not None:
        power += (phase.end_power - power) * part
    return Moment(
        phase=name,
        starts_phase=start == 0.0,
        time=before.clock + 0.5 * (start + end),
        duration=end - start,
        altitude=altitude,
        air=air,
        true_airspeed=_true_airspeed(mission, name, before, part),
        acceleration=(airspeeds[1] - airspeeds[0]) / (end - start),
        climb=(phase.altitude - before.altitude) / duration,
        propeller_speed=0.5 * sum(speeds),
        propeller_gain=speeds[1] - speeds[0],
        power=power,
    )


def _true_airspeed(mission: Mission, name: str, before: _Before, part: float) -> float:
    """Return the true airspeed at a part of a phase [m/s]."""
    phase = mission.phases[name]

    def air(at: float) -> Air:
        return air_at(before.altitude + (phase.altitude - before.altitude) * at, mission.isa_offset_k)

    try:
        if phase.from_tas is None and phase.from_cas is None:
            return _by_law(phase, air(part))
        first = phase.from_tas if phase.from_tas is not None else true_of_calibrated(phase.from_cas or 0.0, air(0.0))
        return first + (_by_law(phase, air(1.0)) - first) * part
    except DesignError as error:
        raise DesignError([Problem(f"phases.{name}", problem.message) for problem in error.problems]) from None


def _by_law(phase: Phase, air: Air) -> float:
    if phase.mach is not None:
        return phase.mach * air.sound_speed
    return phase.tas if phase.tas is not None else true_of_calibrated(phase.cas or 0.0, air)
