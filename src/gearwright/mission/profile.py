"""A mission cut into intervals: where the aircraft is in the middle of each, and what it asks of the gearbox."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import Air, air_along, true_along
from gearwright.arrays import Bools, Floats, Ints
from gearwright.errors import DesignError, Problem
from gearwright.mission.path import Path, Paths
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


class Course(NamedTuple):
    """The middles of all intervals of a mission, in their order: `Moment` with arrays of shape (n,)."""

    phase: tuple[str, ...]
    starts_phase: Bools
    time: Floats
    duration: Floats
    altitude: Floats
    air: Air
    """Its fields are arrays."""
    true_airspeed: Floats
    acceleration: Floats
    climb: Floats
    propeller_speed: Floats
    propeller_gain: Floats
    power: Floats
    """NaN where pitch or thrust set it [W]."""

    @property
    def mach(self) -> Floats:
        """Flight Mach numbers [-]."""
        return self.true_airspeed / self.air.sound_speed

    def at(self, kept: Ints) -> Course:
        """Return some intervals.

        Args:
            kept: Their numbers.
        """
        air: Any = [np.asarray(column)[kept] for column in self.air]
        columns: dict[str, Any] = {name: getattr(self, name)[kept] for name in _COLUMNS}
        return Course(phase=tuple(self.phase[k] for k in kept.tolist()), air=Air(*air), **columns)

    def moments(self) -> Iterator[Moment]:
        """Yield the intervals one by one."""
        air = map(Air, *(np.asarray(column).tolist() for column in self.air))
        columns = [column.tolist() for column in (self.starts_phase, self.time, self.duration, self.altitude)]
        rest = [column.tolist() for column in self[6:-1]]
        power = [None if math.isnan(value) else value for value in self.power.tolist()]
        yield from map(Moment, self.phase, *columns, air, *rest, power)


_COLUMNS = tuple(name for name in Course._fields if name not in ("phase", "air"))


class _Before(NamedTuple):
    """Where the phase before ended."""

    clock: float
    """From the start of the mission [s]."""
    altitude: float
    """[m]"""
    speed: float
    """Of the propeller [rad/s]."""


def moments(mission: Mission, paths: Paths | None = None) -> Iterator[Moment]:
    """Yield the intervals of a mission in their order.

    Args:
        mission: As read.
        paths: Of the phases that an aircraft flies; left out: none.

    Raises:
        DesignError: A speed that is supersonic where it is flown; with the phase.
    """
    yield from course_of(mission, paths).moments()


def course_of(mission: Mission, paths: Paths | None = None) -> Course:
    """Return all intervals of a mission.

    Args:
        mission: As read.
        paths: Of the phases that an aircraft flies; left out: none.

    Raises:
        DesignError: A speed that is supersonic where it is flown; with the phase.
    """
    first = next(iter(mission.phases.values()))
    altitude = first.altitude if first.from_altitude is None else first.from_altitude
    before, stretches = _Before(0.0, altitude, first.propeller_speed), list[Course]()
    for name, phase in mission.phases.items():
        if paths and name in paths:
            duration = paths[name].duration
            stretches.append(_on_path(mission, name, paths[name], before))
        else:
            duration = phase_duration(phase, before.altitude)
            stretches.append(_stretch(mission, name, duration, before))
        before = _Before(before.clock + duration, phase.altitude, ramped(phase, duration, before.speed))
    return joined(stretches)


def joined(courses: Sequence[Course]) -> Course:
    """Return courses one after the other; their times stay as they are.

    Args:
        courses: At least one.
    """
    air: Any = [np.concatenate(column) for column in zip(*(course.air for course in courses), strict=True)]
    columns: dict[str, Any] = {name: np.concatenate([getattr(course, name) for course in courses]) for name in _COLUMNS}
    return Course(phase=tuple(chain.from_iterable(course.phase for course in courses)), air=Air(*air), **columns)


def phase_duration(phase: Phase, altitude: float) -> float:
    """Return how long a phase takes [s].

    Args:
        phase: As read.
        altitude: At its start [m].
    """
    if phase.duration is not None:
        return phase.duration
    return (phase.altitude - altitude) / (phase.rate_of_climb or math.nan)


def edges(duration: float, ramp: float, step: float) -> list[float]:
    """Cut a phase so that no interval is longer than a step, and the end of the ramp is a cut [s].

    Args:
        duration: Of the phase [s].
        ramp: In which the propeller comes to its speed [s].
        step: Longest interval [s].
    """
    middle = min(ramp, duration)
    times = [0.0]
    for start, end in ((0.0, middle), (middle, duration)):
        count = max(math.ceil((end - start) / step - 1e-9), 1) if end > start else 0
        times += [start + (end - start) * k / count for k in range(1, count + 1)]
    return times


def ramped(phase: Phase, time: Any, before: float) -> Any:
    """Return the propeller's speed in a phase [rad/s].

    Args:
        phase: With its speed and ramp.
        time: From its start [s].
        before: Speed at its start [rad/s].
    """
    part = np.minimum(time / phase.ramp, 1.0)
    return before + (phase.propeller_speed - before) * part


def _on_path(mission: Mission, name: str, path: Path, before: _Before) -> Course:
    """Return the intervals of an aircraft's path."""
    phase, count = mission.phases[name], len(path.stages)
    times, heights, airspeeds = np.array(path.nodes).T
    altitude, duration, speeds = 0.5 * (heights[:-1] + heights[1:]), np.diff(times), ramped(phase, times, before.speed)
    return Course(
        phase=(name,) * count,
        starts_phase=times[:-1] == 0.0,
        time=before.clock + 0.5 * (times[:-1] + times[1:]),
        duration=duration,
        altitude=altitude,
        air=air_along(altitude, mission.isa_offset_k),
        true_airspeed=0.5 * (airspeeds[:-1] + airspeeds[1:]),
        acceleration=np.diff(airspeeds) / duration,
        climb=np.diff(heights) / duration,
        propeller_speed=0.5 * (speeds[:-1] + speeds[1:]),
        propeller_gain=np.diff(speeds),
        power=np.full(count, math.nan if phase.power is None else phase.power),
    )


def _stretch(mission: Mission, name: str, duration: float, before: _Before) -> Course:
    """Return the intervals of a phase."""
    phase, cuts = mission.phases[name], np.array(edges(duration, mission.phases[name].ramp, mission.step))
    start, end = cuts[:-1], cuts[1:]
    part, count = 0.5 * (start + end) / duration, len(start)
    altitude = before.altitude + (phase.altitude - before.altitude) * part
    airspeeds = _true_airspeeds(mission, name, before, cuts / duration)
    speeds = ramped(phase, cuts, before.speed)
    power = np.full(count, math.nan if phase.power is None else phase.power)
    if phase.power is not None and phase.end_power is not None:
        power += (phase.end_power - phase.power) * part
    return Course(
        phase=(name,) * count,
        starts_phase=start == 0.0,
        time=before.clock + 0.5 * (start + end),
        duration=end - start,
        altitude=altitude,
        air=air_along(altitude, mission.isa_offset_k),
        true_airspeed=_true_airspeeds(mission, name, before, part),
        acceleration=np.diff(airspeeds) / (end - start),
        climb=np.full(count, (phase.altitude - before.altitude) / duration),
        propeller_speed=0.5 * (speeds[:-1] + speeds[1:]),
        propeller_gain=np.diff(speeds),
        power=power,
    )


def _true_airspeeds(mission: Mission, name: str, before: _Before, part: Floats) -> Floats:
    """Return the true airspeed at parts of a phase [m/s]."""
    phase = mission.phases[name]

    def air(at: Floats) -> Air:
        return air_along(before.altitude + (phase.altitude - before.altitude) * at, mission.isa_offset_k)

    try:
        if phase.from_tas is None and phase.from_cas is None:
            return _by_law(phase, air(part))
        ends = air(np.array([0.0, 1.0]))
        calibrated = true_along(np.full(2, phase.from_cas or 0.0), ends)[0]
        first, last = phase.from_tas if phase.from_tas is not None else calibrated, _by_law(phase, ends)[1]
        return np.asarray(first + (last - first) * part)
    except DesignError as error:
        raise DesignError([Problem(f"phases.{name}", problem.message) for problem in error.problems]) from None


def _by_law(phase: Phase, air: Air) -> Floats:
    along = np.ones_like(air.temperature)
    if phase.mach is not None:
        return np.asarray(phase.mach * air.sound_speed)
    return phase.tas * along if phase.tas is not None else true_along((phase.cas or 0.0) * along, air)
