"""What flight asks of one propeller, and what the propeller makes of the power that reaches it."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.catalogue import compressed
from gearwright.errors import DesignError, Problem
from gearwright.machines import PropellerMap, angle_for_power, angle_for_thrust, coefficients
from gearwright.mission.profile import Moment
from gearwright.spec import Mission, Phase
from gearwright.units import GRAVITY

LARGEST_LIFT = 10.0
"""Lift coefficient that no wing has, whatever its flaps [-]: beyond it a phase is no flight."""
_ROUNDS = 8
"""Rounds in which the factor of compressibility settles: it hardly changes with the thrust [-]."""


class Blades(NamedTuple):
    """The propeller of one gearbox."""

    map_name: str
    """Shipped map, file, or none."""
    chart: PropellerMap | None
    """None where powers are schedules."""
    diameter: float
    """[m]"""


class Advance(NamedTuple):
    """How a propeller screws through the air."""

    diameter: float
    """[m]"""
    turns: float
    """Per second [1/s]."""
    ratio: float
    """J = V/(n D) [-]."""


class Performance(NamedTuple):
    """What a propeller does with a power."""

    advance_ratio: float
    """[-]"""
    pitch: float | None = None
    """[rad]; like the others None where powers are schedules."""
    compressibility: float | None = None
    """Factor on the thrust [-]."""
    thrust: float | None = None
    """[N]"""


class Borne(NamedTuple):
    """What the wing has to bear."""

    mass: float
    """Of the aircraft at the start [kg]."""
    burnt: float
    """By all engines so far [kg]."""
    reference: float
    """What a lift coefficient of 1 bears: q S [N]."""

    @property
    def weight(self) -> float:
        """Now [N]."""
        return (self.mass - self.burnt) * GRAVITY


def propeller_power(blades: Blades, mission: Mission, moment: Moment, *, burnt: float) -> float | None:
    """Return the power of the propeller's shaft [W], or None where the machines' power is given.

    Args:
        blades: The propeller.
        mission: With phases and aircraft.
        moment: Where it is flown.
        burnt: Fuel that all engines have burnt so far [kg].

    Raises:
        DesignError: Pitch or thrust lie outside the map.
    """
    phase, chart = mission.phases[moment.phase], blades.chart
    if moment.power is not None or chart is None:
        return None
    advance = diameter, turns, ratio = _advance(blades, moment)
    angle = phase.pitch
    if angle is None:
        thrust = _needed_thrust(mission, moment, phase, burnt) / (moment.air.density * turns**2 * diameter**4)
        angle = angle_for_thrust(chart, ratio, _incompressible(blades.map_name, moment, advance, thrust))
    return coefficients(chart, ratio, angle).power * moment.air.density * turns**3 * diameter**5


def _advance(blades: Blades, moment: Moment) -> Advance:
    turns = moment.propeller_speed / (2.0 * math.pi)
    return Advance(blades.diameter, turns, moment.true_airspeed / (turns * blades.diameter))


def _needed_thrust(mission: Mission, moment: Moment, phase: Phase, burnt: float) -> float:
    """Return the thrust of one propeller: (D + m g sin γ + m dV/dt)/engines with D = q S (C_D0 + k C_L²)."""
    aircraft = mission.aircraft
    if aircraft is None:  # `mission_problems` refuses it
        raise DesignError([Problem("aircraft", "a phase needs a thrust; give an [aircraft]")])
    dynamic = 0.5 * moment.air.density * moment.true_airspeed**2 * aircraft.wing_area
    borne = Borne(aircraft.mass, burnt, dynamic)
    _refuse_no_flight(moment, borne)
    weight = borne.weight
    slope = moment.climb / moment.true_airspeed
    lift = weight * math.sqrt(1.0 - slope**2) / dynamic
    drag_force = dynamic * (aircraft.zero_lift_drag + aircraft.induced_drag * lift**2)
    return (drag_force + weight * (slope + moment.acceleration / GRAVITY)) / (phase.engines or mission.engines)


def _refuse_no_flight(moment: Moment, borne: Borne) -> None:
    """Refuse what no wing does."""
    if borne.weight <= 0.0:
        message = (
            f"{borne.burnt:.4g} kg of fuel are burnt, and the aircraft has {borne.mass:.4g} kg; give its mass, or fly"
            " shorter"
        )
        raise DesignError([Problem("aircraft.mass", message)])
    if borne.weight > LARGEST_LIFT * borne.reference:
        message = (
            f"at {moment.true_airspeed:.3g} m/s no wing bears {borne.weight / 1e3:.4g} kN; fly faster, or give power"
            " or pitch"
        )
        raise DesignError([Problem("aircraft", message)])
    if abs(moment.climb) > moment.true_airspeed:
        message = f"climbs {moment.climb:.3g} m/s at {moment.true_airspeed:.3g} m/s; fly faster, or climb slower"
        raise DesignError([Problem("aircraft", message)])


def _incompressible(name: str, moment: Moment, advance: Advance, thrust: float) -> float:
    """Return the C_T of the map that compressibility brings down to a thrust coefficient."""
    estimate = thrust
    for _ in range(_ROUNDS):
        estimate = thrust / _factor(name, moment, advance, estimate)
    return estimate


def _factor(name: str, moment: Moment, advance: Advance, thrust: float) -> float:
    tip_mach = math.pi * advance.turns * advance.diameter / moment.air.sound_speed
    return compressed(name, advance.ratio, thrust, mach=moment.mach, tip_mach=tip_mach)


def performed(blades: Blades, moment: Moment, work: float) -> Performance:
    """Return what a propeller does with a power.

    Args:
        blades: The propeller.
        moment: Where it is flown.
        work: Power that reaches the propeller [W].

    Raises:
        DesignError: The power lies outside the map, or the Mach number outside its charts.
    """
    density, advance = moment.air.density, _advance(blades, moment)
    if blades.chart is None:
        return Performance(advance.ratio)
    diameter, turns, ratio = advance
    angle = angle_for_power(blades.chart, ratio, work / (density * turns**3 * diameter**5))
    thrust = coefficients(blades.chart, ratio, angle).thrust
    factor = _factor(blades.map_name, moment, advance, thrust)
    return Performance(ratio, angle, factor, factor * thrust * density * turns**2 * diameter**4)
