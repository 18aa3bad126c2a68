"""All intervals of a flight at once, or of many flights: what each asks of gearbox, machines and battery."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.machines import MachMap
from gearwright.mission.endurance import bounds_of
from gearwright.mission.gearbox import Drag, Point
from gearwright.mission.moments import Blades, Performance
from gearwright.mission.supply import Supply
from gearwright.mission.together.airscrew import asked_power, performance_along
from gearwright.mission.together.deck import Deck
from gearwright.mission.together.following import Flying, followed
from gearwright.mission.together.gearbox import Box, node_speeds
from gearwright.mission.together.plant import (
    Burnt,
    Discharged,
    burnt_along,
    discharged,
    dragged_along,
    electric_along,
)
from gearwright.mission.together.rounds import ROUNDS, Asked, given_powers
from gearwright.mission.together.runs import shortened, spread


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
