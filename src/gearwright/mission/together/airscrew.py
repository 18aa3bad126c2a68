"""The propeller in many intervals at once: the power that a held pitch takes, and what it makes of a power."""

from __future__ import annotations

import math

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.machines import PropellerMap
from gearwright.mission.moments import Blades, Course, Performance
from gearwright.mission.together.charts import angle_along, power_and_thrust, squeezed_along


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
