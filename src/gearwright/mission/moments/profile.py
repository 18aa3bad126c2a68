"""A mission cut into intervals: all phases of all missions at once, but those that an aircraft flies on its path."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import Air, air_along, true_along
from gearwright.arrays import Floats, Ints
from gearwright.errors import DesignError, Problem
from gearwright.mission.moments.course import Course, Moment, air_of, joined
from gearwright.mission.moments.path import Path, Paths
from gearwright.spec import Mission, Phase

_ROUNDING = 1e-9
"""Part of a step that is none [-]."""


class _Before(NamedTuple):
    """Where the phase before ended."""

    clock: float
    """From the start of the mission [s]."""
    altitude: float
    """[m]"""
    speed: float
    """Of the propeller [rad/s]."""


class Stretch(NamedTuple):
    """A phase of a mission."""

    mission: Mission
    name: str
    before: _Before
    path: Path | None
    """Where an aircraft flies it."""

    @property
    def phase(self) -> Phase:
        """As read."""
        return self.mission.phases[self.name]

    @property
    def duration(self) -> float:
        """[s]"""
        return self.path.duration if self.path else phase_duration(self.phase, self.before.altitude)


def moments(mission: Mission, paths: Paths | None = None) -> Iterator[Moment]:
    """Yield the intervals of a mission in their order.

    Args:
        mission: As read.
        paths: Of the phases that an aircraft flies; left out: none.

    Raises:
        DesignError: A speed that is supersonic where it is flown; with the phase.
    """
    yield from laid_out(stretches_of(mission, paths))[0].moments()


def stretches_of(mission: Mission, paths: Paths | None = None) -> list[Stretch]:
    """Return the phases of a mission one after the other.

    Args:
        mission: As read.
        paths: Of the phases that an aircraft flies; left out: none.
    """
    first = next(iter(mission.phases.values()))
    altitude = first.altitude if first.from_altitude is None else first.from_altitude
    before, stretches = _Before(0.0, altitude, first.propeller_speed), list[Stretch]()
    for name, phase in mission.phases.items():
        stretches.append(stretch := Stretch(mission, name, before, (paths or {}).get(name)))
        duration = stretch.duration
        before = _Before(before.clock + duration, phase.altitude, ramped(phase, duration, before.speed))
    return stretches


def laid_out(stretches: Sequence[Stretch]) -> tuple[Course, list[int]]:
    """Return the intervals of phases, of one mission or of many, and how many each phase has.

    Args:
        stretches: One after the other.

    Raises:
        DesignError: A speed that is supersonic where it is flown; with the phase.
    """
    courses, counts = list[Course](), list[int]()
    for flies, group in groupby(stretches, key=lambda stretch: stretch.path is not None):
        for together in [[stretch] for stretch in group] if flies else [list(group)]:
            course, count = _on_path(together[0]) if flies else _laid(together)
            courses.append(course)
            counts += count
    return (courses[0] if len(courses) == 1 else joined(courses)), counts


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
    times: list[float] = _cuts(*(np.array([value]) for value in (duration, ramp, step)))[0].tolist()
    return times


def _cuts(duration: Floats, ramp: Floats, step: Floats) -> tuple[Floats, Ints]:
    """Return the ends of the intervals of phases, their starts with them [s], and how many intervals each has."""
    middle = np.minimum(ramp, duration)
    rising, level = (
        np.where(span > 0.0, np.maximum(np.ceil(span / step - _ROUNDING), 1.0), 0.0).astype(int)
        for span in (middle, duration - middle)
    )
    count = rising + level
    first = np.cumsum(count + 1) - count - 1
    place = np.arange(count.sum() + len(count)) - np.repeat(first, count + 1)
    middle, rest, rising, level = (np.repeat(of, count + 1) for of in (middle, duration - middle, rising, level))
    cuts = np.where(
        place <= rising,
        middle * place / np.maximum(rising, 1),
        middle + rest * (place - rising) / np.maximum(level, 1),
    )
    return cuts, count


def ramped(phase: Phase, time: Any, before: float) -> Any:
    """Return the propeller's speed in a phase [rad/s].

    Args:
        phase: With its speed and ramp.
        time: From its start [s].
        before: Speed at its start [rad/s].
    """
    return _between(before, phase.propeller_speed, np.minimum(time / phase.ramp, 1.0))


def _between(start: Any, end: Any, part: Any) -> Any:
    return start + (end - start) * part


def _on_path(stretch: Stretch) -> tuple[Course, list[int]]:
    """Return the intervals of an aircraft's path."""
    path, before, phase = stretch.path, stretch.before, stretch.phase
    assert path is not None  # `laid_out`
    count = len(path.stages)
    times, heights, airspeeds = np.array(path.nodes).T
    altitude, duration, speeds = 0.5 * (heights[:-1] + heights[1:]), np.diff(times), ramped(phase, times, before.speed)
    course = Course(
        phase=(stretch.name,) * count,
        starts_phase=times[:-1] == 0.0,
        time=before.clock + 0.5 * (times[:-1] + times[1:]),
        duration=duration,
        altitude=altitude,
        air=air_along(altitude, stretch.mission.isa_offset_k),
        true_airspeed=0.5 * (airspeeds[:-1] + airspeeds[1:]),
        acceleration=np.diff(airspeeds) / duration,
        climb=np.diff(heights) / duration,
        propeller_speed=0.5 * (speeds[:-1] + speeds[1:]),
        propeller_gain=np.diff(speeds),
        power=np.full(count, math.nan if phase.power is None else phase.power),
    )
    return course, [count]


def _laid(stretches: Sequence[Stretch]) -> tuple[Course, list[int]]:
    """Return the intervals of phases that no aircraft flies, all at once."""
    phases, before = [stretch.phase for stretch in stretches], [stretch.before for stretch in stretches]
    duration, ramp = np.array([stretch.duration for stretch in stretches]), np.array([phase.ramp for phase in phases])
    cuts, count = _cuts(duration, ramp, np.array([stretch.mission.step for stretch in stretches]))
    whose, own = (np.repeat(np.arange(len(count)), many) for many in (count + 1, count))
    ends = np.cumsum(count + 1) - 1
    first, last = np.delete(np.arange(len(cuts)), ends), np.delete(np.arange(len(cuts)), ends - count)
    start, end = cuts[first], cuts[last]
    part = 0.5 * (start + end) / duration[own]
    low, high = np.array([old.altitude for old in before]), np.array([phase.altitude for phase in phases])
    at = np.concatenate([cuts / duration[whose], part])
    altitude, air, airspeeds = _flown(stretches, (low, high), np.concatenate([whose, own]), at)
    asked = np.array([phase.propeller_speed for phase in phases])[whose]
    speeds = _between(np.array([old.speed for old in before])[whose], asked, np.minimum(cuts / ramp[whose], 1.0))
    power, end_power = np.array([_powers(phase) for phase in phases]).T
    middle = slice(len(cuts), None)
    course = Course(
        phase=tuple(stretches[k].name for k in own.tolist()),
        starts_phase=start == 0.0,
        time=np.array([old.clock for old in before])[own] + 0.5 * (start + end),
        duration=end - start,
        altitude=altitude[middle],
        air=air_of(air, middle),
        true_airspeed=airspeeds[middle],
        acceleration=(airspeeds[last] - airspeeds[first]) / (end - start),
        climb=((high - low) / duration)[own],
        propeller_speed=0.5 * (speeds[first] + speeds[last]),
        propeller_gain=speeds[last] - speeds[first],
        power=_between(power[own], end_power[own], part),
    )
    return course, count.tolist()


def _powers(phase: Phase) -> tuple[float, float]:
    """Return the power at start and end of a phase [W]; NaN where pitch or thrust set it."""
    power = math.nan if phase.power is None else phase.power
    return power, power if phase.end_power is None else phase.end_power


def _flown(
    stretches: Sequence[Stretch], heights: tuple[Floats, Floats], whose: Ints, part: Floats
) -> tuple[Floats, Air, Floats]:
    """Return altitude [m], air and true airspeed [m/s] at parts of phases, whose each is."""
    low, high = heights
    altitude = _between(low[whose], high[whose], part)
    offset = np.array([stretch.mission.isa_offset_k for stretch in stretches])[whose]
    try:
        air = air_along(altitude, offset)
        airspeeds = _by_law(stretches, whose, air)
        for k, stretch in enumerate(stretches):
            if stretch.phase.from_tas is not None or stretch.phase.from_cas is not None:
                airspeeds[whose == k] = _between(*_ends(stretch, heights[0][k], heights[1][k]), part[whose == k])
    except DesignError as error:
        if len(stretches) > 1:  # the first of them that cannot be flown says so
            for stretch in stretches:
                _laid([stretch])
        problems = [Problem(f"phases.{stretches[0].name}", problem.message) for problem in error.problems]
        raise DesignError(problems) from None
    return altitude, air, airspeeds


def _by_law(stretches: Sequence[Stretch], whose: Ints, air: Air) -> Floats:
    """Return the true airspeeds of phases by Mach number, true or calibrated airspeed [m/s]."""
    laws = np.array([(phase.mach, phase.tas, phase.cas) for phase in (stretch.phase for stretch in stretches)], float)
    mach, true, calibrated = laws[whose].T
    airspeeds: Floats = np.where(np.isnan(mach), true, mach * air.sound_speed)
    rest = np.flatnonzero(np.isnan(airspeeds))
    if len(rest):
        airspeeds[rest] = true_along(np.nan_to_num(calibrated[rest]), air_of(air, rest))
    return airspeeds


def _ends(stretch: Stretch, low: float, high: float) -> tuple[float, float]:
    """Return the true airspeeds at start and end of a phase that is given both [m/s]."""
    phase, air = stretch.phase, air_along(np.array([low, high]), stretch.mission.isa_offset_k)
    first = true_along(np.full(2, phase.from_cas or 0.0), air)[0] if phase.from_tas is None else phase.from_tas
    return float(first), float(_by_law([stretch], np.zeros(2, int), air)[1])
