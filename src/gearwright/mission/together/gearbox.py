"""The gearbox under many loads at once: operating points, the losses of teeth, and what takes power beside them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.lanes import rebound
from gearwright.mission.gearbox import Drag, Gearbox, Point
from gearwright.parts.losses import MeshDuty, MeshLaw, bearing, mesh, oil, seal, tooth_power
from gearwright.sizing.bearings import seat_forces_along
from gearwright.sizing.losses import bodies
from gearwright.spec import GROUND, Drive
from gearwright.train import Loads, along, asked_speeds, can_be_along
from gearwright.train.flow.turning import Turn

_FRICTION = rebound(mesh)
_TEETH = rebound(tooth_power, mesh_friction=_FRICTION.mesh_friction)
_OIL, _SEAL, _BEARING = rebound(oil), rebound(seal), rebound(bearing)
_BODIES = rebound(
    bodies,
    **{name: getattr(_OIL, name) for name in ("churning_power", "windage_power", "windage_power_dawson")},
    **{name: getattr(_SEAL, name) for name in ("seal_power_14179_1", "seal_power_14179_2", "seal_power_oil")},
)
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
        parts[:, k] = _TEETH.mesh_loss_part(contact, duty, oil_state, law=gearbox.oil.friction)
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
        rubbing = rubbing + seat.count * _BEARING.bearing_torque_constant(radial, seat.bore) * np.abs(turning)
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
