"""The log of a flight whose intervals were all found at once."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError
from gearwright.mission.collect import Flown, Log
from gearwright.mission.gearbox import Point
from gearwright.mission.history import History
from gearwright.mission.together.deck import Deck, deck_of, is_free
from gearwright.mission.together.flight import Together, flown_together
from gearwright.mission.together.gearbox import box_of


class Reached(NamedTuple):
    """How far a flight comes."""

    place: int
    """Of the first interval that cannot be flown, or is too near to that to tell; above 0."""
    point: Point
    """Of the interval before it."""
    charge: float
    """At its start [-]."""
    burnt: float
    """Fuel of all engines until then [kg]."""


def log_at_once(flown: Flown) -> Log | Reached | None:
    """Return the log of a flight, or how far it comes; None where its intervals have to be flown one after the other.

    That is where a plan, a rotorcraft's trim or temperatures lead from one to the next, where a train has clutches,
    or where something cannot be flown: one by one tells where, and why.

    Args:
        flown: Gearbox, propeller, mission and machines.
    """
    box = box_of(flown.gearbox) if is_free(flown.mission) else None
    if box is None:
        return None
    try:
        deck = deck_of([flown])
    except DesignError:  # one by one it is told where
        return None
    found = flown_together(box, flown.blades, flown.supply, deck)
    if found is None:
        return None
    if found.fails.any():
        return reached(deck, found, 0)
    return Log(deck.course.phase, history_of(deck, found), found.point, found.powers, found.battery.ends[0], ())


def reached(deck: Deck, found: Together, flight: int) -> Reached | None:
    """Return how far a flight comes; None where that is not known: at its start, and with cells that remember more.

    Args:
        deck: What was asked.
        found: What it got.
        flight: Its number in the deck; one of its intervals fails.
    """
    lanes = deck.flights[flight]
    place = int(np.argmax(found.fails[lanes]))
    if not place or found.battery.temperature is not None:
        return None
    flew = slice(lanes.start, lanes.start + place)
    point = Point(*(column[flew][-1] for column in found.point))
    burnt = float((found.burnt.fuel_flow[flew] * deck.course.duration[flew] * deck.engines[flew]).sum())
    return Reached(place, point, float(found.battery.charge[flew][-1]), burnt)


def history_of(deck: Deck, found: Together) -> History[Floats]:
    """Return what is recorded of all intervals of a deck.

    Args:
        deck: What was asked.
        found: What it got.
    """
    course, battery, burnt = deck.course, found.battery, found.burnt
    friction: dict[str, Any] = dict(zip(("bearing", "windage", "churning"), found.friction, strict=True))
    none: Any = None
    return History(
        time=course.time,
        duration=course.duration,
        altitude=course.altitude,
        true_airspeed=course.true_airspeed,
        mach=course.mach,
        air_temperature=np.asarray(course.air.temperature),
        air_density=np.asarray(course.air.density),
        propeller_speed=course.propeller_speed,
        propeller_gain=course.propeller_gain,
        propeller_power=found.work,
        **found.performance._asdict(),
        electric_share=found.share,
        fuel_flow=burnt.fuel_flow,
        turbine_power=burnt.power,
        turbine_available=burnt.available,
        air_flow=np.asarray(burnt.exhaust.air_flow),
        exhaust_temperature=np.asarray(burnt.exhaust.temperature),
        exhaust_heat=burnt.heat,
        casing_heat=np.asarray(burnt.exhaust.casing),
        battery_power=battery.open_power,
        battery_current=battery.current,
        battery_voltage=battery.voltage,
        state_of_charge=battery.charge,
        battery_temperature=battery.temperature if battery.temperature is not None else none,
        winding_temperature=none,
        mesh_loss=found.mesh_loss,
        **{f"{origin}_loss": loss for origin, loss in friction.items()},
        oil_temperature=none,
        gears_temperature=none,
        bearings_temperature=none,
        housing_temperature=none,
        gearbox_heat=found.mesh_loss + sum(friction.values()),
        motor_loss=found.motor_loss,
        battery_loss=battery.loss,
        spin_up=found.spin_up,
    )
