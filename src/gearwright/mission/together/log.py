"""The log of a flight whose intervals were all found at once."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwright.arrays import Floats
from gearwright.mission.collect import Flown, Log
from gearwright.mission.history import History
from gearwright.mission.together.deck import Deck, deck_of, is_free
from gearwright.mission.together.flight import Together, flown_together
from gearwright.mission.together.gearbox import box_of


def log_at_once(flown: Flown) -> Log | None:
    """Return the log of a flight; None where its intervals have to be flown one after the other.

    That is where a strategy, an aircraft's mass or temperatures lead from one to the next, where a train has clutches,
    or where something cannot be flown: one by one tells where, and why.

    Args:
        flown: Gearbox, propeller, mission and machines.
    """
    gearbox, blades, mission, supply, paths = flown
    box = box_of(gearbox) if is_free(mission) and not paths else None
    if box is None:
        return None
    deck = deck_of(supply, [mission])
    found = flown_together(box, blades, supply, deck)
    if found is None or found.fails.any():
        return None
    return Log(deck.course.phase, history_of(deck, found), found.point, found.powers, found.battery.ends[0], ())


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
