"""The intervals of a mission: where the aircraft is in the middle of each, and what it asks of the gearbox."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import Air
from gearwright.arrays import Bools, Floats, Ints


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
        columns: dict[str, Any] = {name: getattr(self, name)[kept] for name in _COLUMNS}
        return Course(phase=tuple(self.phase[k] for k in kept.tolist()), air=air_of(self.air, kept), **columns)

    def moments(self) -> Iterator[Moment]:
        """Yield the intervals one by one."""
        air = map(Air, *(np.asarray(column).tolist() for column in self.air))
        columns = [column.tolist() for column in (self.starts_phase, self.time, self.duration, self.altitude)]
        rest = [column.tolist() for column in self[6:-1]]
        power = [None if math.isnan(value) else value for value in self.power.tolist()]
        yield from map(Moment, self.phase, *columns, air, *rest, power)


_COLUMNS = tuple(name for name in Course._fields if name not in ("phase", "air"))


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
