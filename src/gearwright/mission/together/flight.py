"""All intervals of a flight at once, or of many flights: what each asks of gearbox, machines and battery."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.mission.endurance import bounds_of
from gearwright.mission.gearbox import Drag, Point
from gearwright.mission.loading import TRIAL_POWER
from gearwright.mission.supply import Supply
from gearwright.mission.thrust import Blades, Performance
from gearwright.mission.together.airscrew import asked_power, performance_along
from gearwright.mission.together.deck import Deck
from gearwright.mission.together.gearbox import (
    Box,
    Idle,
    balanced,
    drag_of,
    idle_of,
    machine_powers,
    mesh_loss_of,
    node_speeds,
    point_of,
    stage_losses,
)
from gearwright.mission.together.plant import (
    Burnt,
    Discharged,
    burnt_along,
    discharged,
    dragged_along,
    motors_along,
)
from gearwright.train import Loads

_SETTLED = 1e-13
"""Change of a part that is lost below which rounds have settled [-]."""
_ROUNDS = 6
"""Every one leaves some 0.002 of the error of the one before, which begins with all losses, about 0.01."""


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


class _Asked(NamedTuple):
    """What is given to every round."""

    box: Box
    deck: Deck
    supply: Supply
    wanted: Floats
    """Power of the propeller's shaft; NaN: of the machines [W]."""
    spin_up: Floats
    dragged: Floats
    idle: Idle
    parts: Floats
    """Of the machines, in the order of a point's powers, shape (n, machines) [-]."""


def flown_together(box: Box, blades: Blades, supply: Supply, deck: Deck) -> Together | None:
    """Return what all intervals ask and get; None where the gearbox loses too much to be solved so.

    Args:
        box: The gearbox.
        blades: The propeller.
        supply: The machines.
        deck: What is asked.

    Source: the losses of an interval are those of the loads of the one before; where a phase starts they are found
        twice. Rounds over all intervals end where nothing changes, which is where one after the other leads.
    """
    course = deck.course
    wanted, outside = asked_power(blades, course, deck.pitch)
    spin_up = box.gearbox.inertia * course.propeller_speed * course.propeller_gain / course.duration
    speeds = _machine_speeds(box, course.propeller_speed)
    dragged = dragged_along(supply, deck.driven, speeds)
    none = np.zeros(len(wanted))
    parts = np.stack([deck.parts.get(name, none) for name in box.gearbox.machines], axis=1)
    asked = _Asked(box, deck, supply, wanted, spin_up, dragged, idle_of(box, course.propeller_speed), parts)
    settled = _settled(asked)
    if settled is None:
        return None
    point, friction, fails = settled
    lost = point.mesh_losses.sum(axis=1)
    work = point.machine_powers.sum(axis=1) - lost
    carried = sum(friction) + dragged + spin_up
    powers = {name: point.machine_powers[:, k] + parts[:, k] * carried for k, name in enumerate(box.gearbox.machines)}
    performance, left = performance_along(blades, course, work, pitch=deck.pitch)
    burnt = burnt_along(supply, course, powers, speeds, deck.rating)
    heat, weak = motors_along(supply, powers, speeds)
    electric = sum((powers[name] for name in supply.motors), none) + heat
    starts = [mission.battery.start_charge if mission.battery else 0.0 for mission in deck.missions]
    battery = discharged(supply.pack, starts, deck.flights, power=electric, course=course)
    fails = fails | outside | left | burnt.weak | weak | battery.faulty | _passed(box, supply, (powers, speeds))
    share = sum((deck.parts[name] for name in supply.motors), none)
    return Together(
        point, friction, powers, work, lost, heat + dragged, spin_up, share, performance, burnt, battery, fails
    )


def _machine_speeds(box: Box, propeller_speed: Floats) -> dict[str, Floats]:
    speeds, train = node_speeds(box, propeller_speed), box.gearbox.sizing.train
    return {name: np.abs(speeds[train.machines[name]]) for name in box.gearbox.machines}


def _settled(asked: _Asked) -> tuple[Point, Drag, Bools] | None:
    """Return points, drag, and where the machines' power only spins the train up."""
    deck, first = asked.deck, asked.deck.first
    again = deck.course.starts_phase | first
    everywhere = np.ones(len(first), bool)
    lost = np.zeros((len(first), len(asked.box.stages)))
    met: _Met | None = None
    change = lost[:, 0]
    for _ in range(_ROUNDS):  # always as many: a flight is the same whatever others it is found with
        before = np.where(first[:, None], 0.0, np.roll(lost, 1, axis=0))
        met = _met(asked, before, everywhere)
        twice = None if met is None else _met(asked, _losses(asked, met, everywhere)[again], again)
        if met is None or twice is None:
            return None
        met = _replaced(met, twice, again)
        anew = _losses(asked, met, everywhere)
        change, lost = np.abs(anew - lost).max(axis=1), anew
    assert met is not None  # there are rounds
    point, friction, short = _loaded(asked, met)
    return point, friction, short | (change > _SETTLED)


class _Met(NamedTuple):
    """Loads in balance."""

    loads: Loads
    speeds: Floats
    powers: Floats
    short: Bools
    """Where power only spins the train up."""


def _replaced(met: _Met, other: _Met, lanes: Bools) -> _Met:
    """Return loads of which some are others."""
    for column, values in zip((*met.loads, *met[1:]), (*other.loads, *other[1:]), strict=True):
        column[lanes] = values
    return met


def _met(asked: _Asked, lost: Floats, lanes: Bools) -> _Met | None:
    """Return the loads under which propeller or machines have their power."""
    box, speed = asked.box, asked.deck.course.propeller_speed[lanes]
    wanted, given = asked.wanted[lanes], asked.deck.course.power[lanes]
    trial = np.where(wanted < 0.0, -TRIAL_POWER, TRIAL_POWER)
    powers = machine_powers(box, asked.parts[lanes], trial)
    found = balanced(box, powers, speed, lost)
    if found is None:
        return None
    loads, speeds = found
    work = powers.sum(axis=1) - mesh_loss_of(box, loads, speeds).sum(axis=1)
    by_work = ~np.isnan(wanted)
    factor = np.where(by_work, wanted / np.where(work == 0.0, 1.0, work), 0.0)
    short = np.zeros(len(wanted), bool)
    if not by_work.all():
        full = given / TRIAL_POWER
        torques = np.where(by_work, 0.0, full)[:, None] * loads.first / _counts(box)
        idle = Idle(*(column[lanes] for column in asked.idle))
        left = given - asked.spin_up[lanes] - sum(drag_of(box, torques, speed, idle)) - asked.dragged[lanes]
        short = ~by_work & (left <= 0.0)
        factor = np.where(by_work, factor, left / TRIAL_POWER)
    scaled = Loads(*(column * (factor[:, None] if column.ndim == 2 else factor) for column in loads))
    return _Met(scaled, speeds, powers * factor[:, None], short)


def _counts(box: Box) -> Floats:
    return np.array([float(row.count) for row in box.gearbox.sizing.train.meshes])


def _losses(asked: _Asked, met: _Met, lanes: Bools) -> Floats:
    """Return what the teeth of each stage then lose [-]."""
    torques = met.loads.first / _counts(asked.box)
    return stage_losses(asked.box, torques, asked.deck.course.propeller_speed[lanes])


def _loaded(asked: _Asked, met: _Met) -> tuple[Point, Drag, Bools]:
    point = point_of(asked.box, met.loads, met.speeds, met.powers)
    friction = drag_of(asked.box, point.mesh_torques, asked.deck.course.propeller_speed, asked.idle)
    return point, friction, met.short


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
