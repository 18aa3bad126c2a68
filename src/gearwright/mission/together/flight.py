"""Analysis of whole flights as arrays: iteration over all intervals, flight log and many missions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import stagnation_along
from gearwright.arrays import Bools, Floats
from gearwright.errors import DesignError
from gearwright.machines import MachMap
from gearwright.mission.flight import Flight, History
from gearwright.mission.gearbox import Drag, Point
from gearwright.mission.intervals import Flown, Log, collect
from gearwright.mission.strategies import AGREED, Demand
from gearwright.mission.supply import Supply, bounds_of
from gearwright.mission.thrust import Blades, Performance
from gearwright.mission.together.demand import (
    Deck,
    angle_for_thrusts,
    asked_power,
    deck_of,
    is_free,
    needed_thrust,
    performance_along,
)
from gearwright.mission.together.gearbox import (
    ROUNDS,
    Asked,
    Balanced,
    Box,
    balanced_rounds,
    box_of,
    given_powers,
    no_losses,
    node_speeds,
    shortened,
    spread,
)
from gearwright.mission.together.plant import (
    Burnt,
    Charging,
    Discharged,
    available_along,
    burnt_along,
    discharged,
    dragged_along,
    electric_along,
    fuel_along,
)

# ----------------------------------------------------------------------------------------------------------------------
# Rounds over all intervals at once, in which what follows from the intervals before agrees: fuel, losses, shares.
# ----------------------------------------------------------------------------------------------------------------------


_MOST = 24
"""Most rounds: fuel that is wrong by a part of the mass makes later fuel wrong by less than its part of all fuel."""
_SAME = 1e-13
"""Change of the fuel that is burnt, over the mass at the start, below which rounds have settled [-]."""


class Guess(NamedTuple):
    """What a round takes from the one before, shape (n, ...)."""

    burnt: Floats
    """Fuel of all engines before each interval [kg]."""
    lost: Floats
    """Part that teeth of each stage lose [-]."""
    share: Floats
    """Motors' part of the machines' power, where a strategy sets it [-]."""


class Followed(NamedTuple):
    """Intervals in agreement with those before them."""

    found: Balanced
    asked: Asked
    """Of the gearbox, with the parts of machines."""
    pitch: Floats
    """Blade angles that are held or give a thrust; NaN: none [rad]."""
    fails: Bools
    """What cannot be flown, or has not settled."""


class Flying(NamedTuple):
    """With what flights are flown."""

    box: Box
    blades: Blades
    supply: Supply
    deck: Deck
    speeds: dict[str, Floats]
    """Machine -> speed without sign, shape (n,) [rad/s]."""


def followed(flying: Flying, asked: Asked) -> Followed | None:
    """Return intervals in agreement with those before them; None where the gearbox loses too much to be solved so.

    Args:
        flying: With what is flown.
        asked: Of the gearbox; powers that follow from a thrust, and parts by strategies, are found here.

    Source: an interval's mass is what fuel before it has left, and its share what its strategy makes of its power and
        of the charge before it. Every round takes fuel, losses and shares of the round before; what is wrong begins
        later each time. A flight keeps that with which it settled: it is the same whatever others it is found with.
    """
    box, _, supply, deck, _ = flying
    if deck.craft is None and deck.strategies is None:
        free = balanced_rounds(box, asked)
        return None if free is None else Followed(free, asked, deck.pitch, free.short | ~free.settled)
    count = len(deck.pitch)
    whose = np.repeat(np.arange(len(deck.flights)), [lanes.stop - lanes.start for lanes in deck.flights])
    heavy = np.array([mission.aircraft.mass if mission.aircraft else np.inf for mission in deck.missions])[whose]
    ratios = stagnation_along(deck.course.air, deck.course.mach)
    begun = deck.strategies.begun() if deck.strategies else np.zeros(count)
    guess, round_ = Guess(np.zeros(count), no_losses(box, count), begun), None
    going = np.ones(count, bool)
    for _ in range(_MOST):
        round_ = _round(flying, asked, guess)
        if round_ is None:
            return None
        powers = given_powers(box.gearbox.machines, round_.asked, round_.found)
        burnt = _before(deck, fuel_along(supply, ratios, powers) * deck.course.duration * deck.engines)
        share = _shares(flying, powers, guess.share)
        moved = (np.abs(burnt - guess.burnt) > _SAME * heavy) | (np.abs(share - guess.share) > AGREED)
        going = (np.bincount(whose, moved | ~round_.found.settled) > 0.0)[whose]
        if not going.any():
            break
        guess = Guess(
            np.where(going, burnt, guess.burnt),
            np.where(going[:, None], round_.found.lost, guess.lost),
            np.where(going, share, guess.share),
        )
    return None if round_ is None else round_._replace(fails=round_.fails | going)


def _round(flying: Flying, asked: Asked, guess: Guess) -> Followed | None:
    box, blades, supply, deck, speeds = flying
    pitch, fails = deck.pitch, np.zeros(len(deck.pitch), bool)
    if deck.craft is not None:
        rows, pitch, wanted = np.flatnonzero(deck.craft.asks), pitch.copy(), asked.wanted.copy()
        craft, course = deck.craft.at(rows), deck.course.at(rows)
        thrust, unflown = needed_thrust(craft, course, guess.burnt[rows])
        pitch[rows], wanted[rows], outside = angle_for_thrusts(blades, course, craft, thrust / deck.engines[rows])
        fails[rows] = unflown | outside
        asked = asked._replace(wanted=wanted)
    if deck.strategies is not None:
        parts, none = deck.strategies.parts(deck.parts, guess.share), np.zeros(len(pitch))
        driven = {name: np.where(deck.strategies.follows, parts[name] != 0.0, on) for name, on in deck.driven.items()}
        columns = [parts.get(name, none) for name in box.gearbox.machines]
        asked = asked._replace(parts=np.stack(columns, axis=1), dragged=dragged_along(supply, driven, speeds))
    found = balanced_rounds(box, asked, guess.lost)
    return None if found is None else Followed(found, asked, pitch, fails | found.short)


def _shares(flying: Flying, powers: dict[str, Floats], share: Floats) -> Floats:
    """Return the motors' part of the machines' power by their strategies; as it is where there are none [-]."""
    _, _, supply, deck, speeds = flying
    if deck.strategies is None:
        return share
    power = sum((powers[name] for name in (*supply.engines, *supply.motors)), np.zeros(len(share)))
    available = available_along(supply, deck.course, speeds, deck.rating, deck.strategies.working)
    columns: Any = (power, available, power, deck.course.duration)
    demand = Demand(*columns)
    share = deck.strategies.shares(demand)
    if supply.pack is not None and deck.strategies.charging:
        bus, air = electric_along(supply, powers, speeds)[0], np.asarray(deck.course.air.temperature)
        for lanes, mission in zip(deck.flights, deck.missions, strict=True):
            start = supply.pack.start(mission.battery.start_charge if mission.battery else 0.0)
            deck.strategies.charged(supply, demand, start, Charging(lanes, bus, air, speeds, share))
    return share


def _before(deck: Deck, spent: Floats) -> Floats:
    """Return what every flight has spent before each interval, of what each spends."""
    sums = np.zeros(len(spent))
    for lanes in deck.flights:
        sums[lanes.start + 1 : lanes.stop] = np.cumsum(spent[lanes.start : lanes.stop - 1])
    return sums


# ----------------------------------------------------------------------------------------------------------------------
# All intervals of a flight at once, or of many flights: what each asks of gearbox, machines and battery.
# ----------------------------------------------------------------------------------------------------------------------


class Together(NamedTuple):
    """What intervals ask and get; arrays have a first axis of n."""

    point: Point
    friction: Drag
    powers: dict[str, Floats]
    """Machine -> power into the train, with drag and spin-up [W]."""
    work: Floats
    """Power of the propeller's shaft [W]."""
    mesh_loss: Floats
    motor_loss: Floats
    """With those that are dragged [W]."""
    spin_up: Floats
    share: Floats
    """Motors' part [-]."""
    performance: Performance
    burnt: Burnt
    battery: Discharged
    fails: Bools
    """Where something cannot be flown, or is too near to that to tell."""


def flown_together(box: Box, blades: Blades, supply: Supply, deck: Deck) -> Together | None:
    """Return what all intervals ask and get; None where the gearbox loses too much to be solved so, or
    the propeller has maps over the Mach number.

    Args:
        box: The gearbox.
        blades: The propeller.
        supply: The machines.
        deck: What is asked.

    Source: `mission.fly`, over all intervals; those that are asked what the one before is asked get what it gets, as
        soon as rounds would have settled.
    """
    if isinstance(blades.chart, MachMap):
        return None
    short, source = shortened(deck, ROUNDS)
    course, machines = short.course, box.gearbox.machines
    speeds = _machine_speeds(box, course.propeller_speed)
    asked, outside = _asked(box, blades, supply, short)
    settled = followed(Flying(box, blades, supply, short, speeds), asked)
    if settled is None:
        return None
    found, asked, pitch, fails = settled
    point = found.point
    lost = point.mesh_losses.sum(axis=1)
    work = point.machine_powers.sum(axis=1) - lost
    powers = given_powers(machines, asked, found)
    performance, left = performance_along(blades, course, work, pitch=pitch)
    burnt = burnt_along(supply, course, powers, speeds, short.rating)
    electric, heat, weak = electric_along(supply, powers, speeds)
    fails = fails | outside | left | burnt.weak | weak | np.isnan(work) | _passed(box, supply, (powers, speeds))
    share = sum((asked.parts[:, machines.index(name)] for name in supply.motors), np.zeros(len(work)))
    starts = [mission.battery.start_charge if mission.battery else 0.0 for mission in deck.missions]
    battery = discharged(supply.pack, starts, deck.flights, power=electric[source], course=deck.course)
    columns = (point, found.friction, powers, work, lost, heat + asked.dragged, asked.spin_up, share, performance)
    everywhere: tuple[Any, ...] = (*spread((*columns, burnt), source), battery, fails[source] | battery.faulty)
    return Together(*everywhere)


def _asked(box: Box, blades: Blades, supply: Supply, deck: Deck) -> tuple[Asked, Bools]:
    """Return what is asked of the gearbox, and where a held pitch is outside its map."""
    course, none = deck.course, np.zeros(len(deck.pitch))
    wanted, outside = asked_power(blades, course, deck.pitch)
    spin_up = box.gearbox.inertia * course.propeller_speed * course.propeller_gain / course.duration
    dragged = dragged_along(supply, deck.driven, _machine_speeds(box, course.propeller_speed))
    parts = np.stack([deck.parts.get(name, none) for name in box.gearbox.machines], axis=1)
    begins = deck.first, course.starts_phase
    return Asked(*begins, wanted, course.power, course.propeller_speed, spin_up, dragged, parts), outside


def _machine_speeds(box: Box, propeller_speed: Floats) -> dict[str, Floats]:
    speeds, train = node_speeds(box, propeller_speed), box.gearbox.sizing.train
    return {name: np.abs(speeds[train.machines[name]]) for name in box.gearbox.machines}


def _passed(box: Box, supply: Supply, machines: tuple[dict[str, Floats], dict[str, Floats]]) -> Bools:
    """Tell where a limit of a machine is passed, for however short a time."""
    powers, speeds = machines
    bounds = bounds_of(box.gearbox.sizing.design.machines, supply.ratings)
    passed = np.zeros(len(next(iter(powers.values()))), bool)
    for bound in bounds:
        value: Any = np.abs(powers[bound.machine])
        value = value if bound.name == "power" else value / speeds[bound.machine]
        passed |= value > bound.value
    return passed


# ----------------------------------------------------------------------------------------------------------------------
# The log of a flight whose intervals were all found at once.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Many flights of one gearbox together: missions that differ by numbers.
# ----------------------------------------------------------------------------------------------------------------------


def flights_together(all_flown: Sequence[Flown]) -> list[Flight | Reached | None]:
    """Return the flight of each, or how far it comes; None where it has to be flown alone.

    Args:
        all_flown: With the same gearbox, machines and propeller; their missions differ in numbers.
    """
    gearbox, blades, _, supply, _ = all_flown[0]
    box = box_of(gearbox)
    free = [k for k, flown in enumerate(all_flown) if is_free(flown.mission)]
    found: list[Flight | Reached | None] = [None] * len(all_flown)
    if box is None or not free:
        return found
    try:
        deck = deck_of([all_flown[k] for k in free])
    except DesignError:  # one that has no course is told why alone, and does not slow the others down
        if len(all_flown) == 1:
            return found
        half = len(all_flown) // 2
        return flights_together(all_flown[:half]) + flights_together(all_flown[half:])
    whole = flown_together(box, blades, supply, deck)
    if whole is None:
        return found
    history = history_of(deck, whole)
    for place, k in enumerate(free):
        lanes = deck.flights[place]
        fails = bool(whole.fails[lanes].any())
        found[k] = reached(deck, whole, place) if fails else collect(all_flown[k], _log(deck, whole, place, history))
    return found


def _log(deck: Deck, whole: Together, place: int, history: History[Floats]) -> Log:
    """Return the log of one flight."""
    lanes = deck.flights[place]
    columns: dict[str, Any] = {
        field.name: None if (values := getattr(history, field.name)) is None else values[lanes]
        for field in fields(History)
    }
    return Log(
        phase=deck.course.phase[lanes],
        history=History(**columns),
        point=Point(*(column[lanes] for column in whole.point)),
        powers={name: power[lanes] for name, power in whole.powers.items()},
        end=whole.battery.ends[place],
        warm=(),
    )
