"""Aircraft in many intervals at once: the thrust that their paths need, and the blade angle that gives it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import Polar, polar
from gearwright.arrays import Bools, Floats, Ints
from gearwright.lanes import rebound
from gearwright.mission.moments import (
    LARGEST_LIFT,
    SQUEEZED_ROUNDS,
    Attitude,
    Course,
    Stretch,
    forces,
    friction_of,
    polar_of,
)
from gearwright.mission.together.charts import angle_along, governs_along, power_and_thrust, squeezed_along
from gearwright.units import GRAVITY

_POLAR = rebound(polar)
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
