"""What flight asks of one propeller, and what the propeller makes of the power that reaches it."""

from __future__ import annotations

import math

from gearwright.catalogue import compressed
from gearwright.errors import DesignError, Problem
from gearwright.machines import PropellerMap, angle_for_power, angle_for_thrust, coefficients
from gearwright.mission.gearbox import Gearbox
from gearwright.mission.profile import Moment
from gearwright.spec import Mission, Phase
from gearwright.units import GRAVITY

LARGEST_LIFT = 10.0
"""Lift coefficient that no wing has, whatever its flaps [-]: beyond it a phase is no flight."""
_ROUNDS = 8
"""Rounds in which the factor of compressibility settles: it hardly changes with the thrust [-]."""


def propeller_power(
    chart: PropellerMap | None, gearbox: Gearbox, mission: Mission, *, now: tuple[Moment, float]
) -> float | None:
    """Return the power of the propeller's shaft [W], or None where the machines' power is given.

    Args:
        chart: Map of the propeller; None: powers are schedules.
        gearbox: With the propeller's diameter.
        mission: With phases and aircraft.
        now: The moment, and the fuel that all engines have burnt so far [kg].

    Raises:
        DesignError: Pitch or thrust lie outside the map.
    """
    moment, burnt = now
    phase = mission.phases[moment.phase]
    if moment.power is not None or chart is None:
        return None
    advance = diameter, turns, ratio = _advance(gearbox, moment)
    angle = phase.pitch
    if angle is None:
        thrust = _needed_thrust(mission, moment, phase, burnt) / (moment.air.density * turns**2 * diameter**4)
        angle = angle_for_thrust(chart, ratio, _incompressible(mission.propeller_map, moment, advance, thrust))
    return coefficients(chart, ratio, angle).power * moment.air.density * turns**3 * diameter**5


def _advance(gearbox: Gearbox, moment: Moment) -> tuple[float, float, float]:
    """Return diameter [m], turns per second [1/s] and advance ratio [-]."""
    diameter = gearbox.sizing.design.propellers[gearbox.propeller].diameter
    turns = moment.propeller_speed / (2.0 * math.pi)
    return diameter, turns, moment.true_airspeed / (turns * diameter)


def _needed_thrust(mission: Mission, moment: Moment, phase: Phase, burnt: float) -> float:
    """Return the thrust of one propeller in steady flight: (D + m g sin γ)/engines with D = q S (C_D0 + k C_L²)."""
    aircraft = mission.aircraft
    if aircraft is None:  # `mission_problems` refuses it
        raise DesignError([Problem("aircraft", "a phase needs a thrust; give an [aircraft]")])
    weight = (aircraft.mass - burnt) * GRAVITY
    dynamic = 0.5 * moment.air.density * moment.true_airspeed**2 * aircraft.wing_area
    _refuse_no_flight(moment, burnt, (aircraft.mass, weight, dynamic))
    slope = moment.climb / moment.true_airspeed
    lift = weight * math.sqrt(1.0 - slope**2) / dynamic
    drag_force = dynamic * (aircraft.zero_lift_drag + aircraft.induced_drag * lift**2)
    return (drag_force + weight * slope) / (phase.engines or mission.engines)


def _refuse_no_flight(moment: Moment, burnt: float, held: tuple[float, float, float]) -> None:
    """Refuse what no wing does: aircraft mass [kg], its weight now [N] and what a lift coefficient of 1 bears [N]."""
    mass, weight, dynamic = held
    if weight <= 0.0:
        message = f"{burnt:.4g} kg of fuel are burnt, and the aircraft has {mass:.4g} kg; give its mass, or fly shorter"
        raise DesignError([Problem("aircraft.mass", message)])
    if weight > LARGEST_LIFT * dynamic:
        message = (
            f"at {moment.true_airspeed:.3g} m/s no wing bears {weight / 1e3:.4g} kN; fly faster, or give power or pitch"
        )
        raise DesignError([Problem("aircraft", message)])
    if abs(moment.climb) > moment.true_airspeed:
        message = f"climbs {moment.climb:.3g} m/s at {moment.true_airspeed:.3g} m/s; fly faster, or climb slower"
        raise DesignError([Problem("aircraft", message)])


def _incompressible(name: str, moment: Moment, advance: tuple[float, float, float], thrust: float) -> float:
    """Return the C_T of the map that compressibility brings down to a thrust coefficient."""
    estimate = thrust
    for _ in range(_ROUNDS):
        estimate = thrust / _factor(name, moment, advance, estimate)
    return estimate


def _factor(name: str, moment: Moment, advance: tuple[float, float, float], thrust: float) -> float:
    diameter, turns, ratio = advance
    tip_mach = math.pi * turns * diameter / moment.air.sound_speed
    return compressed(name, ratio, thrust, mach=moment.mach, tip_mach=tip_mach)


def performed(
    chart: tuple[str, PropellerMap | None], gearbox: Gearbox, moment: Moment, work: float
) -> dict[str, float]:
    """Return where the aircraft is and what its propeller does with a power.

    Args:
        chart: Name and map of the propeller; None: powers are schedules.
        gearbox: With the propeller's diameter.
        moment: Where it is flown.
        work: Power that reaches the propeller [W].

    Raises:
        DesignError: The power lies outside the map, or the Mach number outside its charts.
    """
    name, table = chart
    return {
        "time": moment.time,
        "duration": moment.duration,
        "altitude": moment.altitude,
        "true_airspeed": moment.true_airspeed,
        "mach": moment.mach,
        "air_temperature": moment.air.temperature,
        "air_density": moment.air.density,
        "propeller_speed": moment.propeller_speed,
        "propeller_power": work,
        "advance_ratio": _advance(gearbox, moment)[2],
        **(_pulled(name, table, gearbox, moment, work) if table is not None else {}),
    }


def _pulled(name: str, chart: PropellerMap, gearbox: Gearbox, moment: Moment, work: float) -> dict[str, float]:
    density, advance = moment.air.density, _advance(gearbox, moment)
    diameter, turns, ratio = advance
    angle = angle_for_power(chart, ratio, work / (density * turns**3 * diameter**5))
    thrust = coefficients(chart, ratio, angle).thrust
    factor = _factor(name, moment, advance, thrust)
    return {"pitch": angle, "compressibility": factor, "thrust": factor * thrust * density * turns**2 * diameter**4}
