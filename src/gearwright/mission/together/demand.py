"""Required thrust and power of many intervals as arrays: mission profile, aircraft and propeller."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import Polar
from gearwright.arrays import Bools, Floats, Ints
from gearwright.lanes import rebound
from gearwright.machines import PropellerMap
from gearwright.mission import thrust as forces
from gearwright.mission.intervals import Flown
from gearwright.mission.profile import Course, Stretch, laid_out, stretches_of
from gearwright.mission.strategies import has_plan
from gearwright.mission.thrust import (
    LARGEST_LIFT,
    SQUEEZED_ROUNDS,
    Attitude,
    Blades,
    Performance,
    friction_of,
    polar_of,
)
from gearwright.mission.together.plant import (
    Strategies,
    angle_along,
    governs_along,
    power_and_thrust,
    squeezed_along,
    strategies_of,
)
from gearwright.spec import Mission, Phase, engine_out
from gearwright.units import GRAVITY

# ----------------------------------------------------------------------------------------------------------------------
# Aircraft in many intervals at once: the thrust that their paths need, and the blade angle that gives it.
# ----------------------------------------------------------------------------------------------------------------------


_POLAR = rebound(sys.modules[Polar.__module__])
_FORCES = rebound(
    forces,
    dynamic_force=_POLAR.dynamic_force,
    drag_force=_POLAR.drag_force,
    polar_of=lambda craft, _: craft.polar,
    friction_of=lambda craft, _: craft.friction,
)


class Craft(NamedTuple):
    """Aircraft of intervals, shape (n,) each; mass is NaN where power or pitch are given."""

    mass: Floats
    """At the start of the flight [kg]."""
    fuel: Floats
    """On board; infinite where a mission does not say it [kg]."""
    area: Floats
    zero_lift: Floats
    induced: Floats
    friction: Floats
    roll_lift: Floats
    """Lift coefficient on the wheels [-]."""
    highest_lift: Floats
    """NaN where an aircraft does not say it [-]."""
    rolls: Floats
    """1 on the wheels, 0 in flight."""
    plain: Floats
    """1 where a phase has no kind."""

    @property
    def polar(self) -> Polar:
        """With flaps and gear; fields of shape (n,)."""
        columns: Any = (self.area, self.zero_lift, self.induced)
        return Polar(*columns)

    @property
    def asks(self) -> Bools:
        """Where a thrust is asked."""
        return ~np.isnan(self.mass)

    def at(self, lanes: Ints) -> Craft:
        """Return the aircraft of some intervals.

        Args:
            lanes: Which.
        """
        return Craft(*(column[lanes] for column in self))


def craft_of(stretches: Sequence[Stretch], counts: Sequence[int]) -> Craft | None:
    """Return the aircraft of all intervals; None where none is asked for a thrust.

    Args:
        stretches: The phases of all flights.
        counts: Intervals of each.
    """
    rows = [_row(stretch) for stretch in stretches]
    if all(math.isnan(row[0]) for row in rows):
        return None
    return Craft(*np.repeat(np.array(rows), counts, axis=0).T.copy())


def _row(stretch: Stretch) -> tuple[float, ...]:
    phase, aircraft = stretch.phase, stretch.mission.aircraft
    if aircraft is None or phase.power is not None or phase.pitch is not None:
        return (math.nan,) * len(Craft._fields)
    plain, drag = phase.kind is None, polar_of(aircraft, phase)
    flaps = None if plain else aircraft.flaps(forces.setting_of(phase))
    return (
        aircraft.mass,
        math.inf if aircraft.fuel is None else aircraft.fuel,
        drag.area,
        aircraft.zero_lift_drag + phase.extra_drag if plain else drag.zero_lift,
        drag.induced,
        friction_of(aircraft, phase),
        aircraft.roll_lift,
        math.nan if flaps is None else flaps.highest_lift,
        float(phase.kind == "taxi"),
        float(plain),
    )


def needed_thrust(craft: Craft, course: Course, burnt: Floats) -> tuple[Floats, Bools]:
    """Return the thrust of all propellers that paths need, shape (n,) [N], and where nothing flies so.

    Args:
        craft: The aircraft.
        course: Where they are.
        burnt: Fuel of all engines so far, shape (n,) [kg].

    Source: `path_thrust`.
    """
    speed, mass = course.true_airspeed, craft.mass - burnt
    slope = np.where(speed == 0.0, 0.0, course.climb / np.where(speed == 0.0, 1.0, speed))
    at = Attitude(course.air, speed, slope, craft.rolls)  # type: ignore[arg-type]
    weight, reference = mass * GRAVITY, _POLAR.dynamic_force(craft.polar, course.air, speed)
    stalls = (craft.rolls == 0.0) & (weight > reference * craft.highest_lift)
    unborne = (craft.plain == 1.0) & ((weight > LARGEST_LIFT * reference) | (np.abs(course.climb) > speed))
    thrust = _FORCES.path_thrust(craft, None, mass, at, course.acceleration)
    return thrust, stalls | unborne | (mass <= 0.0) | (burnt > craft.fuel)


def angle_for_thrusts(blades: Any, course: Course, craft: Craft, thrust: Floats) -> tuple[Floats, Floats, Bools]:
    """Return the blade angles that give thrusts [rad], the powers that they take [W], and what lies outside.

    Args:
        blades: The propeller, with a map.
        course: Where it is flown.
        craft: The aircraft.
        thrust: Of one propeller, shape (n,) [N].

    Source: `wanted_of`.
    """
    chart, turns = blades.chart, course.propeller_speed / (2.0 * math.pi)
    ratio, tips = course.true_airspeed / (turns * blades.diameter), math.pi * turns * blades.diameter
    wanted = thrust / (course.air.density * turns**2 * blades.diameter**4)
    estimate, outside = wanted, np.zeros(len(wanted), bool)
    for _ in range(SQUEEZED_ROUNDS):
        mach, tip_mach = course.mach, tips / course.air.sound_speed
        factor = squeezed_along(blades.map_name, ratio, estimate, mach=mach, tip_mach=tip_mach)
        better, outside = wanted / factor.value, factor.outside
        if np.array_equal(better, estimate):
            break
        estimate = better
    angle = angle_along(chart, ratio, estimate, chart.thrust)
    taken, _, left = power_and_thrust(chart, ratio, angle.value)
    ungoverned = (craft.rolls == 0.0) & ~governs_along(chart, ratio, angle.value)
    power = taken * course.air.density * turns**3 * blades.diameter**5
    return angle.value, power, outside | angle.outside | left | ungoverned


# ----------------------------------------------------------------------------------------------------------------------
# What the intervals of one flight, or of many, ask of a gearbox: courses one after the other, with modes as arrays.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# The propeller in many intervals at once: the power that a held pitch takes, and what it makes of a power.
# ----------------------------------------------------------------------------------------------------------------------


def asked_power(blades: Blades, course: Course, pitch: Floats) -> tuple[Floats, Bools]:
    """Return the power of the propeller's shaft [W], NaN where the machines' power is given, and what lies outside.

    Args:
        blades: The propeller.
        course: Where it is flown.
        pitch: That is held, NaN where none is, shape (n,) [rad].

    Source: `wanted_of`.
    """
    power, outside = np.full(len(pitch), math.nan), np.zeros(len(pitch), bool)
    if blades.chart is None:
        return power, outside
    assert isinstance(blades.chart, PropellerMap)  # maps over the Mach number are flown alone
    held = np.isnan(course.power) & ~np.isnan(pitch)
    if held.any():
        turns, ratio = _turning(blades, course)
        taken, _, left = power_and_thrust(blades.chart, ratio[held], pitch[held])
        power[held] = taken * course.air.density[held] * turns[held] ** 3 * blades.diameter**5  # type: ignore[index]
        outside[held] = left
    return power, outside


def performance_along(blades: Blades, course: Course, work: Floats, *, pitch: Floats) -> tuple[Performance, Bools]:
    """Return what a propeller does with its powers, fields of shape (n,), and where its charts do not reach.

    Args:
        blades: The propeller.
        course: Where it is flown.
        work: Powers that reach it, shape (n,) [W].
        pitch: That is held, NaN where none is, shape (n,) [rad].

    Source: `performed`.
    """
    turns, ratio = _turning(blades, course)
    density, sound = course.air.density, course.air.sound_speed
    if blades.chart is None:
        return Performance(ratio), np.zeros(len(work), bool)  # type: ignore[arg-type]
    assert isinstance(blades.chart, PropellerMap)  # as above
    taken = work / (density * turns**3 * blades.diameter**5)
    governed, held = angle_along(blades.chart, ratio, taken, blades.chart.power), np.isnan(course.power)
    angle = np.where(held, pitch, governed.value)
    _, thrust, left = power_and_thrust(blades.chart, ratio, angle)
    tips = math.pi * turns * blades.diameter / sound
    factor = squeezed_along(blades.map_name, ratio, thrust, mach=course.mach, tip_mach=tips)
    force = factor.value * thrust * density * turns**2 * blades.diameter**4
    outside = (governed.outside & ~held) | left | factor.outside
    return Performance(ratio, angle, factor.value, force), outside  # type: ignore[arg-type]


def _turning(blades: Blades, course: Course) -> tuple[Floats, Floats]:
    """Return turns per second [1/s] and advance ratio [-]."""
    turns = course.propeller_speed / (2.0 * math.pi)
    return turns, course.true_airspeed / (turns * blades.diameter)
