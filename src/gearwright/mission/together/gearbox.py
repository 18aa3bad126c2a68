"""Gearbox operating points of many intervals as arrays, and iteration of their loads and tooth losses."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.lanes import rebound
from gearwright.mission.gearbox import Drag, Gearbox, Point
from gearwright.mission.intervals import TRIAL_POWER
from gearwright.mission.together.demand import Deck
from gearwright.parts import losses
from gearwright.parts.losses import MeshDuty, MeshLaw
from gearwright.sizing import losses as bodies
from gearwright.sizing.bearing_seats import seat_forces_along
from gearwright.spec import GROUND, Drive
from gearwright.train import Loads, along, asked_speeds, can_be_along
from gearwright.train.balance import Turn

# ----------------------------------------------------------------------------------------------------------------------
# The gearbox under many loads at once: operating points, the losses of teeth, and what takes power beside them.
# ----------------------------------------------------------------------------------------------------------------------


_LOSSES = rebound(losses)
_POWERS = ("churning_power", "windage_power", "windage_power_dawson", "seal_power_14179_1", "seal_power_14179_2",
           "seal_power_oil")  # fmt: skip
_BODIES = rebound(bodies, **{name: getattr(_LOSSES, name) for name in _POWERS})
BEYOND_LAWS = (MeshLaw.ANDERSON_LOEWENTHAL,)
"""Losses of teeth that are summed along a path, one load at a time."""


class Box(NamedTuple):
    """A gearbox with what its way of turning fixes."""

    gearbox: Gearbox
    turn: Turn
    speeds: Floats
    """Of the nodes over that of the propeller, shape (nodes,) [-]."""
    node: int
    """Of the propeller."""
    stages: tuple[str, ...]
    """That have meshes."""
    stage_of: Floats
    """Part of each mesh in the mean of its stage, shape (stages, meshes) [-]."""
    machines: tuple[int, ...]
    """Nodes of the machines without the propeller."""


def box_of(gearbox: Gearbox) -> Box | None:
    """Return a gearbox ready for many loads at once; None where its losses or its train need one at a time.

    Args:
        gearbox: Ready to fly.
    """
    sizing, train, oil_ = gearbox.sizing, gearbox.sizing.train, gearbox.oil
    films = any(seat.runs_on is not None and seat.runs_on.journal is not None for seat in gearbox.seats)
    if oil_.bearings != "constant" or films or oil_.friction in BEYOND_LAWS or gearbox.demand:
        return None
    if train.joints or train.dampers:
        return None
    asked = asked_speeds(sizing.design, {gearbox.propeller: Drive(speed=1.0)})
    senses = gearbox.turning.senses
    signed = {name: abs(speed) * senses[train.machines[name]] for name, speed in asked.items()}
    turn, node = gearbox.turning.turn(signed, []), train.column[train.machines[gearbox.propeller]]
    if not can_be_along(turn, node):
        return None
    stages = tuple(dict.fromkeys(row.stage for row in train.meshes))
    shares = np.array([[float(row.stage == stage) for row in train.meshes] for stage in stages])
    machines = tuple(train.column[train.machines[name]] for name in gearbox.machines)
    return Box(gearbox, turn, turn.speeds, node, stages, shares / shares.sum(axis=1, keepdims=True), machines)


def node_speeds(box: Box, propeller_speed: Floats) -> dict[str, Floats]:
    """Return node -> speed under every load, of the ground too, shape (n,) [rad/s].

    Args:
        box: The gearbox.
        propeller_speed: Under every load, shape (n,) [rad/s].
    """
    nodes = box.gearbox.sizing.train.nodes
    return {
        **{node: ratio * propeller_speed for node, ratio in zip(nodes, box.speeds.tolist(), strict=True)},
        GROUND: np.zeros(1),
    }


def machine_powers(box: Box, parts: Floats, power: Floats) -> Floats:
    """Return what the machines without the propeller give, those that take their part among them, shape (n, machines).

    Args:
        box: The gearbox.
        parts: Of the power that machines give, shape (n, machines) [-].
        power: That they give together, shape (n,) [W].
    """
    given = parts * power[:, None]
    taken = np.array([box.gearbox.taken.get(name, 0.0) for name in box.gearbox.machines])
    takes = np.array([name in box.gearbox.taken for name in box.gearbox.machines])
    total = np.abs(np.where(takes, 0.0, given).sum(axis=1))
    return np.where(takes & (parts == 0.0), taken * total[:, None], given)


def balanced(box: Box, powers: Floats, propeller_speed: Floats, lost: Floats) -> tuple[Loads, Floats] | None:
    """Return what the train carries, and the speeds of its nodes, shape (n, nodes) [rad/s].

    Args:
        box: The gearbox.
        powers: Of the machines, shape (n, machines) [W].
        propeller_speed: Shape (n,) [rad/s].
        lost: Part that the meshes of each stage lose, shape (n, stages) [-].
    """
    speeds = box.speeds * propeller_speed[:, None]
    applied = np.zeros_like(speeds)
    for k, node in enumerate(box.machines):
        applied[:, node] += np.where(powers[:, k] == 0.0, 0.0, powers[:, k] / speeds[:, node])
    part = lost[:, [box.stages.index(row.stage) for row in box.gearbox.sizing.train.meshes]]
    loads = along(box.turn, box.node, part, applied)
    return None if loads is None else (loads, speeds)


def stage_losses(box: Box, mesh_torques: Floats, propeller_speed: Floats) -> Floats:
    """Return the part that the meshes of each stage lose, shape (n, stages) [-].

    Args:
        box: The gearbox.
        mesh_torques: On gear a of one mesh of each row, shape (n, meshes) [N m].
        propeller_speed: Shape (n,) [rad/s].
    """
    gearbox, speeds = box.gearbox, node_speeds(box, propeller_speed)
    teeth, parts = gearbox.teeth, np.zeros_like(mesh_torques)
    for k, row in enumerate(gearbox.sizing.train.meshes):
        contact, radius, width = teeth.contacts[k], teeth.radii[k], teeth.widths[k]
        normal = np.abs(mesh_torques[:, k]) / (radius * np.cos(contact.pressure_angle))
        velocity = (speeds[row.nodes[0]] - speeds[row.nodes[2]]) * radius
        duty = MeshDuty(normal / width, float(width), velocity)
        oil_state = gearbox.oil.on_teeth(row.stage)
        parts[:, k] = _LOSSES.mesh_loss_part(contact, duty, oil_state, law=gearbox.oil.friction)
    return np.stack([(parts * share).sum(axis=1) for share in box.stage_of], axis=1)


class Idle(NamedTuple):
    """What takes power whatever is carried, shape (n,) each [W]."""

    windage: Floats
    churning: Floats
    seals: Floats


def idle_of(box: Box, propeller_speed: Floats) -> Idle:
    """Return what takes power whatever is carried.

    Args:
        box: The gearbox.
        propeller_speed: Shape (n,) [rad/s].
    """
    gearbox, speeds = box.gearbox, node_speeds(box, propeller_speed)
    rows = [*_BODIES.gear_losses(gearbox.sizing, speeds, gearbox.oil)]
    rows += [*_BODIES.seal_losses(gearbox.sizing, speeds, gearbox.oil)]
    total = {origin: np.zeros(len(propeller_speed)) for origin in ("windage", "churning", "seals")}
    for row in rows:
        total[row.origin] = total[row.origin] + row.power
    return Idle(**total)


def drag_of(box: Box, mesh_torques: Floats, propeller_speed: Floats, idle: Idle) -> Drag:
    """Return what bearings, windage and churning take, shape (n,) each [W].

    Args:
        box: The gearbox.
        mesh_torques: On gear a of one mesh of each row, shape (n, meshes) [N m].
        propeller_speed: Shape (n,) [rad/s].
        idle: From `idle_of`.
    """
    speeds, rubbing = node_speeds(box, propeller_speed), np.zeros(len(propeller_speed))
    for seat in box.gearbox.seats:
        radial, turning = (
            seat_forces_along(seat, mesh_torques, speeds[seat.carrier])[0],
            speeds[seat.nodes[0]] - speeds[seat.nodes[1]],
        )
        rubbing = rubbing + seat.count * _LOSSES.bearing_torque_constant(radial, seat.bore) * np.abs(turning)
    return Drag(rubbing + idle.seals, idle.windage, idle.churning)  # type: ignore[arg-type]


def mesh_loss_of(box: Box, loads: Loads, speeds: Floats) -> Floats:
    """Return what each mesh loses, shape (n, meshes) [W].

    Args:
        box: The gearbox.
        loads: What the train carries.
        speeds: Of its nodes, shape (n, nodes) [rad/s].
    """
    first, second, third = (_full(speeds)[:, places] for places in _ends(box))
    return -loads.first * (first - third) - loads.second * (second - third)


def _full(speeds: Floats) -> Floats:
    """Return the speeds of the nodes and of the ground."""
    return np.concatenate([speeds, np.zeros((len(speeds), 1))], axis=1)


def _ends(box: Box) -> list[list[int]]:
    """Return the columns of the meshes' gears and carriers; the ground is the last one."""
    train = box.gearbox.sizing.train
    column = {node: k for k, node in enumerate((*train.nodes, GROUND))}
    return [[column[row.nodes[place]] for row in train.meshes] for place in range(3)]


def point_of(box: Box, loads: Loads, speeds: Floats, powers: Floats) -> Point:
    """Return the operating points; every field has a first axis of n.

    Args:
        box: The gearbox.
        loads: What the train carries.
        speeds: Of its nodes, shape (n, nodes) [rad/s].
        powers: Of the machines without the propeller, shape (n, machines) [W].
    """
    total = np.zeros((speeds.shape[0], speeds.shape[1] + 1))
    for places, torque in zip(_ends(box), (loads.first, loads.second, loads.third), strict=True):
        for k, place in enumerate(places):
            total[:, place] += np.abs(torque[:, k])
    for k, node in enumerate(box.machines):
        total[:, node] += np.abs(np.where(powers[:, k] == 0.0, 0.0, powers[:, k] / speeds[:, node]))
    total[:, box.node] += np.abs(loads.balancing)
    count = np.array([row.count for row in box.gearbox.sizing.train.meshes])
    return Point(speeds, 0.5 * total[:, :-1], powers, loads.first / count, mesh_loss_of(box, loads, speeds))


# ----------------------------------------------------------------------------------------------------------------------
# Intervals that are asked what the one before is asked: the first few of a run are computed and speak for the rest.
# ----------------------------------------------------------------------------------------------------------------------


class Runs(NamedTuple):
    """Which intervals are computed."""

    kept: Ints
    """Their numbers, rising."""
    source: Ints
    """Of every interval, the place among the kept of the one that speaks for it."""


def runs_of(columns: Iterable[Any], starts: Bools, depth: int) -> Runs:
    """Return which intervals are computed: of a run of equal ones the first few.

    Args:
        columns: What intervals are asked; equal bits are equal.
        starts: Where a run starts in any case, shape (n,).
        depth: How many of a run: what one takes over from the one before has settled by then.
    """
    fresh = starts.copy()
    for column in columns:
        bits = column.view(f"u{column.itemsize}")
        fresh[1:] |= bits[1:] != bits[:-1]
    places = np.arange(len(fresh))
    kept = places - np.maximum.accumulate(np.where(fresh, places, 0)) < depth
    return Runs(np.flatnonzero(kept), np.cumsum(kept) - 1)


def shortened(deck: Deck, depth: int) -> tuple[Deck, Ints]:
    """Return a deck without what repeats, and which of its intervals speaks for each of the full one.

    Where intervals follow from those before them nothing repeats.

    Args:
        deck: What is asked.
        depth: As in `runs_of`.
    """
    course = deck.course
    if deck.follows:
        return deck, np.arange(len(deck.pitch))
    columns = (course.altitude, course.true_airspeed, course.power, course.propeller_speed, deck.pitch, deck.rating)
    spun = course.propeller_gain / course.duration
    runs = runs_of(
        (*columns, spun, *deck.parts.values(), *deck.driven.values()), course.starts_phase | deck.first, depth
    )
    return deck.at(runs.kept), runs.source


def spread(found: Any, source: Ints) -> Any:
    """Return what all intervals get from what those get that speak for them.

    Args:
        found: Arrays with a first axis of what is kept, in records and mappings; what is none stays.
        source: Of every interval, the place of the one that speaks for it.
    """
    if isinstance(found, np.ndarray):
        return found[source]
    if isinstance(found, dict):
        return {name: spread(value, source) for name, value in found.items()}
    if isinstance(found, tuple):
        values = [spread(value, source) for value in found]
        return type(found)(*values) if hasattr(found, "_fields") else tuple(values)
    return found


# ----------------------------------------------------------------------------------------------------------------------
# Rounds over all intervals at once, in which loads and what teeth lose under the loads of the one before agree.
# ----------------------------------------------------------------------------------------------------------------------


_SETTLED = 1e-13
"""Change of a part that is lost below which rounds have settled [-]."""
ROUNDS = 5
"""Every one leaves some 0.002 of the error of the one before, which begins with all losses, about 0.01."""


class Asked(NamedTuple):
    """What intervals ask of the gearbox; arrays have a first axis of n."""

    first: Bools
    """Where a flight begins."""
    again: Bools
    """Where a phase begins: losses are found twice."""
    wanted: Floats
    """Power of the propeller's shaft; NaN: of the machines [W]."""
    given: Floats
    """Power of the machines [W]."""
    speed: Floats
    """Of the propeller [rad/s]."""
    spin_up: Floats
    dragged: Floats
    """By shafts that turn motors without current [W]."""
    parts: Floats
    """Of the machines, in the order of a point's powers, shape (n, machines) [-]."""

    def at(self, lanes: Any) -> Asked:
        """Return what some intervals ask.

        Args:
            lanes: Which.
        """
        return Asked(*(column[lanes] for column in self))


class Balanced(NamedTuple):
    """A gearbox in balance."""

    point: Point
    friction: Drag
    short: Bools
    """Where the machines' power only spins the train up."""
    lost: Floats
    """Part that teeth of each stage lose, shape (n, stages) [-]."""
    change: Floats
    """Of that part in the last round, shape (n,) [-]."""

    @property
    def settled(self) -> Bools:
        """Where another round would change nothing."""
        return np.asarray(self.change <= _SETTLED)


def balanced_rounds(box: Box, asked: Asked, lost: Floats | None = None) -> Balanced | None:
    """Return the gearbox in balance after a few rounds; None where it loses too much to be solved so.

    Args:
        box: The gearbox.
        asked: Of it.
        lost: Part that teeth of each stage are thought to lose, shape (n, stages) [-]: the result of the round before,
            for one more; left out: nothing is known, and there are as many rounds as it takes.

    Source: the losses of an interval are those of the loads of the one before; where a phase starts they are found
        twice. Rounds over all intervals end where nothing changes, which is where one after the other leads. Of
        intervals that ask what the one before asks, as many are computed as there are rounds.
    """
    if lost is not None:
        return _rounds(box, asked, lost, 1)
    kept, source = runs_of((*asked[2:-1], *asked.parts.T.copy()), asked.first | asked.again, ROUNDS)
    found: Balanced | None = spread(_rounds(box, asked.at(kept), no_losses(box, len(kept)), ROUNDS), source)
    return found


def given_powers(machines: Sequence[str], asked: Asked, found: Balanced) -> dict[str, Floats]:
    """Return machine -> power into the train, with drag and spin-up, shape (n,) [W].

    Args:
        machines: Without the propeller, in the order of a point's powers.
        asked: Of the gearbox.
        found: What it carries.
    """
    carried, point = sum(found.friction) + asked.dragged + asked.spin_up, found.point
    return {name: point.machine_powers[:, k] + asked.parts[:, k] * carried for k, name in enumerate(machines)}


def no_losses(box: Box, count: int) -> Floats:
    """Return losses that are none, shape (n, stages) [-].

    Args:
        box: The gearbox.
        count: Intervals [-].
    """
    return np.zeros((count, len(box.stages)))


def _rounds(box: Box, asked: Asked, lost: Floats, count: int) -> Balanced | None:
    idle, first, again = idle_of(box, asked.speed), asked.first[:, None], np.flatnonzero(asked.again | asked.first)
    starting, idle_starts = asked.at(again), Idle(*(column[again] for column in idle))
    met: _Met | None = None
    change = lost[:, 0]
    for _ in range(count):  # always as many: a flight is the same whatever others it is found with
        met = _met(box, asked, idle, np.where(first, 0.0, np.roll(lost, 1, axis=0)))
        if met is None:
            return None
        twice = _met(box, starting, idle_starts, _losses(box, met.loads.first[again], starting.speed))
        if twice is None:
            return None
        _replace(met, twice, again)
        anew = _losses(box, met.loads.first, asked.speed)
        change, lost = np.abs(anew - lost).max(axis=1), anew
    assert met is not None  # there are rounds
    point = point_of(box, met.loads, met.speeds, met.powers)
    friction = drag_of(box, point.mesh_torques, asked.speed, idle)
    return Balanced(point, friction, met.short, lost, change)


class _Met(NamedTuple):
    """Loads in balance."""

    loads: Loads
    speeds: Floats
    powers: Floats
    short: Bools
    """Where power only spins the train up."""


def _replace(met: _Met, other: _Met, places: Any) -> None:
    """Put loads in the place of others."""
    for column, values in zip((*met.loads, *met[1:]), (*other.loads, *other[1:]), strict=True):
        column[places] = values


def _met(box: Box, asked: Asked, idle: Idle, lost: Floats) -> _Met | None:
    """Return the loads under which propeller or machines have their power."""
    wanted, given = asked.wanted, asked.given
    trial = np.where(wanted < 0.0, -TRIAL_POWER, TRIAL_POWER)
    powers = machine_powers(box, asked.parts, trial)
    found = balanced(box, powers, asked.speed, lost)
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
        left = given - asked.spin_up - sum(drag_of(box, torques, asked.speed, idle)) - asked.dragged
        short = ~by_work & (left <= 0.0)
        factor = np.where(by_work, factor, left / TRIAL_POWER)
    scaled = Loads(*(column * (factor[:, None] if column.ndim == 2 else factor) for column in loads))
    return _Met(scaled, speeds, powers * factor[:, None], short)


def _counts(box: Box) -> Floats:
    return np.array([float(row.count) for row in box.gearbox.sizing.train.meshes])


def _losses(box: Box, torques: Floats, speed: Floats) -> Floats:
    """Return what the teeth of each stage lose under the torques of all equal meshes [-]."""
    return stage_losses(box, torques / _counts(box), speed)
