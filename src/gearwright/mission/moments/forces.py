"""Forces on the aircraft: drag with flaps and gear, friction of its wheels, and the thrust that a path needs."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.air import Air, Polar, drag_force, dynamic_force, stall_speed
from gearwright.errors import DesignError, Problem
from gearwright.mission.moments.course import Moment
from gearwright.spec import Aircraft, Phase
from gearwright.spec.missions import Setting
from gearwright.units import GRAVITY, apart

USUAL_FLAPS: dict[str | None, Setting] = {"take-off": "take-off", "approach": "landing", "landing": "landing"}
"""Kind of phase -> setting of flaps and gear where the phase does not say it."""


class Attitude(NamedTuple):
    """Where an aircraft is on its path, and how it moves."""

    air: Air
    speed: float
    """True airspeed [m/s]."""
    slope: float
    """sin γ of the path [-]."""
    rolls: float
    """Part of the weight that the wing leaves to the wheels, which they bear [-]; 0 in flight."""


def polar_of(aircraft: Aircraft, phase: Phase) -> Polar:
    """Return the drag polar with the flaps, the gear and the extra drag of a phase.

    Args:
        aircraft: Of the mission.
        phase: With its kind.
    """
    flaps = aircraft.flaps(setting_of(phase))
    extra = (flaps.extra_drag if flaps is not None else 0.0) + phase.extra_drag
    return Polar(aircraft.wing_area, aircraft.zero_lift_drag + extra, aircraft.induced)


def setting_of(phase: Phase) -> Setting:
    """Return how flaps and gear stand in a phase.

    Args:
        phase: With its kind.
    """
    return phase.flaps or USUAL_FLAPS.get(phase.kind, "clean")


def friction_of(aircraft: Aircraft, phase: Phase) -> float:
    """Return μ of the wheels in a phase on the ground [-].

    Args:
        aircraft: Of the mission.
        phase: With its kind.
    """
    return aircraft.braking_friction if phase.kind == "landing" else aircraft.rolling_friction


def resistance(aircraft: Aircraft, phase: Phase, weight: float, at: Attitude) -> float:
    """Return what holds the aircraft back: drag, and friction of wheels that bear what the wing does not [N].

    Args:
        aircraft: Of the mission.
        phase: With its kind.
        weight: m g [N].
        at: Where it is.

    Source: D = q S (C_D0 + k C_L²), L = m g cos γ in flight; μ (m g − L) on the wheels.
    """
    polar = polar_of(aircraft, phase)
    reference = dynamic_force(polar, at.air, at.speed)
    flown = weight * math.sqrt(max(1.0 - at.slope**2, 0.0))
    rolled = min(aircraft.roll_lift * reference, flown)
    lift = at.rolls * rolled + (1.0 - at.rolls) * flown
    return drag_force(polar, reference, lift) + friction_of(aircraft, phase) * (flown - lift)


def lowest_speed(aircraft: Aircraft, phase: Phase, air: Air, weight: float) -> float | None:
    """Return the stall speed in a phase [m/s]; None where the aircraft does not say its highest lift.

    Args:
        aircraft: Of the mission.
        phase: With its kind.
        air: Where it is flown.
        weight: m g [N].
    """
    flaps = aircraft.flaps(setting_of(phase))
    return None if flaps is None else stall_speed(polar_of(aircraft, phase), air, weight, flaps.highest_lift)


def stated_thrust(aircraft: Aircraft, phase: Phase, moment: Moment, mass: float) -> float:
    """Return the thrust of all propellers that a stated path needs [N].

    Args:
        aircraft: Of the mission.
        phase: Of the moment.
        moment: Where it is flown.
        mass: Of the aircraft now [kg].

    Source: `path_thrust`.
    """
    slope = moment.climb / moment.true_airspeed if moment.true_airspeed else 0.0
    at = Attitude(moment.air, moment.true_airspeed, slope, 1.0 if phase.kind == "taxi" else 0.0)
    refuse_stall(aircraft, phase, mass * GRAVITY, at)
    return path_thrust(aircraft, phase, mass, at, moment.acceleration)


def path_thrust(aircraft: Aircraft, phase: Phase, mass: float, at: Attitude, acceleration: float) -> float:
    """Return the thrust of all propellers that holds an aircraft on a path [N].

    Args:
        aircraft: Of the mission.
        phase: With its kind.
        mass: Of the aircraft now [kg].
        at: Where it is.
        acceleration: dV/dt [m/s²].

    Source: T = D + μ (m g − L) + m g sin γ + m dV/dt.
    """
    weight = mass * GRAVITY
    return resistance(aircraft, phase, weight, at) + weight * at.slope + mass * acceleration


def refuse_stall(aircraft: Aircraft, phase: Phase, weight: float, at: Attitude) -> None:
    """Refuse a flight below the stall.

    Args:
        aircraft: Of the mission.
        phase: With its kind.
        weight: m g [N].
        at: Where it is.
    """
    lowest = None if at.rolls else lowest_speed(aircraft, phase, at.air, weight)
    if lowest is not None and at.speed < lowest:
        speed, stall = apart(at.speed, lowest, "velocity")
        message = (
            f"flies {speed}, and stalls below {stall} with flaps {setting_of(phase)!r}; fly faster, lighter, or with"
            " other flaps"
        )
        raise DesignError([Problem("aircraft", message)])
