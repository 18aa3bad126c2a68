"""What the intervals of one flight, or of many, ask of a gearbox: courses one after the other, with modes as arrays."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.mission.collect import Flown
from gearwright.mission.moments import Course, laid_out, stretches_of
from gearwright.mission.strategies import has_plan
from gearwright.mission.together.craft import Craft, craft_of
from gearwright.mission.together.shared import Strategies, strategies_of
from gearwright.spec import Mission, Phase, engine_out


class Deck(NamedTuple):
    """All intervals of some flights; arrays have one entry for each."""

    missions: tuple[Mission, ...]
    course: Course
    flights: tuple[slice, ...]
    """Which intervals are whose."""
    parts: Mapping[str, Floats]
    """Machine -> part of the power of all machines [-]."""
    driven: Mapping[str, Bools]
    """Machine -> where it has a part."""
    pitch: Floats
    """That is held; NaN: none [rad]."""
    rating: Floats
    """Of the turbines over the usual one [-]."""
    engines: Floats
    """Of the aircraft that run [-]."""
    craft: Craft | None
    """The aircraft; None where no interval is asked for a thrust."""
    strategies: Strategies | None
    """Rules by which machines divide the power; None where no interval has one."""

    @property
    def first(self) -> Bools:
        """Where a flight begins."""
        starts = np.zeros(len(self.pitch), bool)
        starts[[lanes.start for lanes in self.flights]] = True
        return starts

    @property
    def follows(self) -> bool:
        """Whether what intervals ask follows from those before them."""
        return self.craft is not None or self.strategies is not None

    def at(self, kept: Ints) -> Deck:
        """Return the deck of some intervals, of every flight at least one; none follows from those before it.

        Args:
            kept: Their numbers, rising.
        """
        ends = np.searchsorted(kept, [0, *(lanes.stop for lanes in self.flights)]).tolist()
        return Deck(
            self.missions,
            self.course.at(kept),
            tuple(slice(start, end) for start, end in pairwise(ends)),
            {name: part[kept] for name, part in self.parts.items()},
            {name: driven[kept] for name, driven in self.driven.items()},
            self.pitch[kept],
            self.rating[kept],
            self.engines[kept],
            None,
            None,
        )


def is_free(mission: Mission) -> bool:
    """Tell whether intervals of a mission can be loaded whatever happened before, but for charge, fuel and rules.

    Args:
        mission: As read.
    """
    warm = mission.oil.network is not None or mission.motor.heat is not None
    given = all(phase.power is not None or phase.pitch is not None for phase in mission.phases.values())
    flown = mission.aircraft is not None and mission.rotorcraft is None
    return (given or flown) and not warm and not has_plan(mission) and mission.engine.deck is None


def deck_of(all_flown: Sequence[Flown]) -> Deck:
    """Return what the intervals of flights ask.

    Args:
        all_flown: With the same machines and missions for which `is_free` holds.

    Raises:
        DesignError: A phase asks for a machine that there is not, or is supersonic.
    """
    supply, missions = all_flown[0].supply, [flown.mission for flown in all_flown]
    whole = [stretches_of(flown.mission, flown.paths) for flown in all_flown]
    stretches = [stretch for flight in whole for stretch in flight]
    course, counts = laid_out(stretches)
    ends = np.cumsum([0, *counts])[np.cumsum([0, *map(len, whole)])].tolist()
    asked = [supply.parts(stretch.phase) for stretch in stretches]
    names = (*supply.engines, *supply.motors)
    engines = [float(stretch.phase.engines or stretch.mission.engines) for stretch in stretches]
    return Deck(
        missions=tuple(missions),
        course=course,
        flights=tuple(slice(start, end) for start, end in pairwise(ends)),
        parts={name: np.repeat([parts.get(name, 0.0) for parts in asked], counts) for name in names},
        driven={name: np.repeat([name in parts for parts in asked], counts) for name in names},
        pitch=np.repeat([_pitch(stretch.phase) for stretch in stretches], counts),
        rating=np.repeat([_rating(stretch.mission, stretch.phase) for stretch in stretches], counts),
        engines=np.repeat(engines, counts),
        craft=craft_of(stretches, counts),
        strategies=strategies_of(supply, stretches, counts),
    )


def _pitch(phase: Phase) -> float:
    return math.nan if phase.pitch is None else phase.pitch


def _rating(mission: Mission, phase: Phase) -> float:
    return mission.engine.contingency if engine_out(mission, phase) else 1.0
