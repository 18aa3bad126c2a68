"""Mission profile: phases in intervals, operating points and the flight path of an aircraft."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain, groupby, pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import Air, air_at, true_of_calibrated
from gearwright.base import Bools, DesignError, Floats, Ints, Problem
from gearwright.spec import Mission, Phase

# ----------------------------------------------------------------------------------------------------------------------
# The intervals of a mission: where the aircraft is in the middle of each, and what it asks of the gearbox.
# ----------------------------------------------------------------------------------------------------------------------


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
        return float(self.true_airspeed / self.air.sound_speed)


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
        return np.asarray(self.true_airspeed / self.air.sound_speed)

    def at(self, kept: Ints) -> Course:
        """Return some intervals.

        Args:
            kept: Their numbers.
        """
        columns: dict[str, Any] = {name: getattr(self, name)[kept] for name in _COLUMNS}
        return Course(phase=tuple(self.phase[k] for k in kept.tolist()), air=air_of(self.air, kept), **columns)

    def moment(self, k: int) -> Moment:
        """Return one interval.

        Args:
            k: Its number.
        """
        return next(self.at(np.array([k])).moments())

    def moments(self) -> Iterator[Moment]:
        """Yield the intervals one by one."""
        air = map(Air, *(np.asarray(column).tolist() for column in self.air))
        columns = [column.tolist() for column in (self.starts_phase, self.time, self.duration, self.altitude)]
        rest = [column.tolist() for column in self[6:-1]]
        power = [None if math.isnan(value) else value for value in self.power.tolist()]
        yield from map(Moment, self.phase, *columns, air, *rest, power)


_COLUMNS = tuple(name for name in Course._fields if name not in ("phase", "air"))


class Doubt(NamedTuple):
    """Intervals that a law refuses, and its words."""

    where: Bools
    """Shape (n,)."""
    words: Callable[[int], None]
    """Raises what is wrong with an interval, if anything is: the law itself, asked for this one alone."""


def joined(courses: Sequence[Course]) -> Course:
    """Return courses one after the other; their times stay as they are.

    Args:
        courses: At least one.
    """
    air: Any = [np.concatenate(column) for column in zip(*(course.air for course in courses), strict=True)]
    columns: dict[str, Any] = {name: np.concatenate([getattr(course, name) for course in courses]) for name in _COLUMNS}
    return Course(phase=tuple(chain.from_iterable(course.phase for course in courses)), air=Air(*air), **columns)


def air_of(air: Air, lanes: Any) -> Air:
    """Return the air of some intervals.

    Args:
        air: Of all; its fields are arrays.
        lanes: Which.
    """
    columns: Any = [np.asarray(column)[lanes] for column in air]
    return Air(*columns)


# ----------------------------------------------------------------------------------------------------------------------
# The path of an aircraft through a phase: where it is at the ends of every interval.
# ----------------------------------------------------------------------------------------------------------------------


class Node(NamedTuple):
    """End of an interval."""

    time: float
    """From the start of the phase [s]."""
    altitude: float
    """[m]"""
    speed: float
    """True airspeed [m/s]."""


class Energy(NamedTuple):
    """Where the energy of a path that follows from its thrust went; books of the integration, not of its nodes."""

    thrust: float
    """Work of all propellers [J]."""
    drag: float
    """Of the air and the wheels [J]."""
    carried: float
    """Height and speed of the fuel that was burnt [J]."""
    gained: float
    """Height and speed of the aircraft at the end, less those at the start [J]."""

    @property
    def residual(self) -> float:
        """What is missing, as a part of the work of the propellers [-]."""
        return abs(self.thrust - self.drag - self.carried - self.gained) / max(abs(self.thrust), abs(self.drag))


class Leg(NamedTuple):
    """One interval of a path."""

    start: Node
    end: Node
    stage: str
    """What the aircraft does: roll, rotation, flight."""

    @property
    def duration(self) -> float:
        """[s]"""
        return self.end.time - self.start.time


class Path(NamedTuple):
    """A phase as an aircraft flies it."""

    nodes: tuple[Node, ...]
    """In their order; the first is its start."""
    stages: tuple[str, ...]
    """Of each interval."""
    energy: Energy | None = None
    """None where the path is stated, and thrust follows from it."""

    @property
    def duration(self) -> float:
        """[s]"""
        return self.nodes[-1].time

    @property
    def legs(self) -> Iterator[Leg]:
        """Its intervals."""
        for (start, end), stage in zip(pairwise(self.nodes), self.stages, strict=True):
            yield Leg(start, end, stage)

    def distance(self, stage: str | None = None) -> float:
        """Return how far it leads through the air [m].

        Args:
            stage: Of these intervals only; left out: of all.
        """
        legs = (leg for leg in self.legs if stage in (None, leg.stage))
        return sum(0.5 * (leg.start.speed + leg.end.speed) * leg.duration for leg in legs)


def speed_by_law(phase: Phase, air: Air) -> float:
    """Return the true airspeed that a phase states [m/s]; of a calibrated one and a Mach number the slower.

    Args:
        phase: With its speeds.
        air: Where it is flown.
    """
    stated = [] if phase.mach is None else [phase.mach * air.sound_speed]
    if phase.tas is not None:
        stated.append(phase.tas)
    if phase.cas is not None:
        stated.append(true_of_calibrated(phase.cas, air))
    return float(min(stated))


Paths = Mapping[str, Path]
"""Phase -> its path, where an aircraft flies it."""


# ----------------------------------------------------------------------------------------------------------------------
# A mission cut into intervals: all phases of all missions at once, but those that an aircraft flies on its path.
# ----------------------------------------------------------------------------------------------------------------------


_ROUNDING = 1e-9
"""Part of a step that is none [-]."""


class _PhaseEnd(NamedTuple):
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
    before: _PhaseEnd
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
    before, stretches = _PhaseEnd(0.0, altitude, first.propeller_speed), list[Stretch]()
    for name, phase in mission.phases.items():
        stretches.append(stretch := Stretch(mission, name, before, (paths or {}).get(name)))
        duration = stretch.duration
        before = _PhaseEnd(before.clock + duration, phase.altitude, ramped(phase, duration, before.speed))
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
        air=air_at(altitude, stretch.mission.isa_offset_k),
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
        air = air_at(altitude, offset)
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
        airspeeds[rest] = true_of_calibrated(np.nan_to_num(calibrated[rest]), air_of(air, rest))
    return airspeeds


def _ends(stretch: Stretch, low: float, high: float) -> tuple[float, float]:
    """Return the true airspeeds at start and end of a phase that is given both [m/s]."""
    phase, air = stretch.phase, air_at(np.array([low, high]), stretch.mission.isa_offset_k)
    first = true_of_calibrated(np.full(2, phase.from_cas or 0.0), air)[0] if phase.from_tas is None else phase.from_tas
    return float(first), float(_by_law([stretch], np.zeros(2, int), air)[1])


# ----------------------------------------------------------------------------------------------------------------------
# Intervals that are asked what the one before is asked: the first few of a run are computed and speak for the rest.
# ----------------------------------------------------------------------------------------------------------------------


class Runs(NamedTuple):
    """Which intervals are computed."""

    kept: Ints
    """Their numbers, rising."""
    source: Ints
    """Of every interval, the place among the kept of the one that speaks for it."""


def runs_of(columns: Iterable[Any], starts: Bools, depth: int) -> Runs:
    """Return which intervals are computed: of a run of equal ones the first few.

    Args:
        columns: What intervals are asked; equal bits are equal.
        starts: Where a run starts in any case, shape (n,).
        depth: How many of a run: what one takes over from the one before has settled by then.
    """
    fresh = starts.copy()
    for column in columns:
        bits = column.view(f"u{column.itemsize}")
        fresh[1:] |= bits[1:] != bits[:-1]
    places = np.arange(len(fresh))
    kept = places - np.maximum.accumulate(np.where(fresh, places, 0)) < depth
    return Runs(np.flatnonzero(kept), np.cumsum(kept) - 1)


def spread(found: Any, source: Ints) -> Any:
    """Return what all intervals get from what those get that speak for them.

    Args:
        found: Arrays with a first axis of what is kept, in records and mappings; what is none stays.
        source: Of every interval, the place of the one that speaks for it.
    """
    if isinstance(found, np.ndarray):
        return found[source]
    if isinstance(found, dict):
        return {name: spread(value, source) for name, value in found.items()}
    if isinstance(found, tuple):
        values = [spread(value, source) for value in found]
        return type(found)(*values) if hasattr(found, "_fields") else tuple(values)
    return found
