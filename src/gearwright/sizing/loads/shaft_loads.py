"""What acts on one shaft, in both planes and every load case: mesh forces as point loads, and all torques.

A mesh of a pair gives a tangential force that makes its torque, a radial force that parts the gears, and, with a
single helix, an axial force whose lever about the shaft's axis is the working pitch radius. Both halves of a
double-helical gear take half of it, each in its own middle; their axial forces meet inside the gear's body. The members
of a planetary set load their shaft by torque only: the forces of equal planets cancel. So does the pinion of face
gears, which lies across and stands between opposite ones. A bevel mesh acts at its mean cone; in the cross-sections its
two shafts stand side by side, as if the wheel's were turned into the pinion's. Forces carry the mesh load factor K_γ,
torques are those of the power flow. The thrust and the moments of a propeller are not in it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.identity import carrier_part
from gearwright.parts.shafts import PointLoads
from gearwright.sizing.arranged import ShaftPlan
from gearwright.sizing.arrangement import helix_hand
from gearwright.sizing.rating import Context, bevel_push
from gearwright.sizing.result import GearSizing
from gearwright.sizing.rolling import rolling_of
from gearwright.train import INTERNAL, Mesh


class _Load(NamedTuple):
    """What a mesh puts on a shaft over all cases; transverse values are complex, y + i z."""

    position: float
    torque: Floats
    force: Complexes
    couple: Complexes
    axial: Floats

    def part(self, position: float, share: float) -> _Load:
        """Return a share of the load at another place."""
        return _Load(position, share * self.torque, share * self.force, share * self.couple, share * self.axial)


def shaft_loads(
    context: Context, name: str, plan: ShaftPlan, *, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> tuple[PointLoads, Floats]:
    """Return the point loads on a shaft, bearings left out, and the axial force of each case [N].

    Args:
        context: What sizing reads.
        name: Of the shaft.
        plan: Where things sit along it.
        axes: Where all axes stand, y + i z [m].
        gears: By name.

    Returns:
        Forces and couples (cases, 2 planes, n), torques (cases, n); axial forces (cases,), positive along x.

    Source: forces of a mesh: ISO 21771:2007; equilibrium of the shaft: Pulvirenti 2023, §2.4.
    """
    pure, meshes = list(pure_torques(context, name, plan)), list(_meshes(context, name, plan, axes, gears))
    position = np.array([*(place for place, _ in pure), *(load.position for load in meshes)])
    torque = np.array([*(torques for _, torques in pure), *(load.torque for load in meshes)]).T
    force, couple = np.zeros((len(torque), 2, len(position))), np.zeros((len(torque), 2, len(position)))
    axial = np.zeros(len(torque))
    for k, load in enumerate(meshes, start=len(pure)):
        force[:, 0, k], force[:, 1, k] = load.force.real, load.force.imag
        couple[:, 0, k], couple[:, 1, k] = load.couple.real, load.couple.imag
        axial += load.axial
    return PointLoads(position, force, couple, torque), axial


def pure_torques(context: Context, name: str, plan: ShaftPlan) -> Iterator[tuple[float, list[float]]]:
    """Yield what loads a shaft by torque only: machines, clutches, dampers, members of planetary sets.

    Args:
        context: What sizing reads.
        name: Of the shaft.
        plan: Where things sit along it.

    Returns:
        Place [m], and the torque of every load case [N m].
    """
    train, flows = context.train, context.flows.values()
    for machine, shaft in train.machines.items():
        if shaft == name:
            yield plan.places[machine], [flow.machine_torques.get(machine, 0.0) for flow in flows]
    for link in train.links:
        if name in (link.driving, link.driven):
            sign = 1.0 if name == link.driven else -1.0
            yield plan.places[link.name], [sign * flow.given(link.name) for flow in flows]
    for mesh in train.meshes:
        if mesh.stage in context.design.sets and name in mesh.nodes:
            side = mesh.nodes.index(name)
            member = str(carrier_part(mesh.stage)) if side == 2 else mesh.gears[side]
            yield plan.places[member], [flow.meshes[mesh.name].torques[side] for flow in flows]


def _meshes(
    context: Context, name: str, plan: ShaftPlan, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> Iterator[_Load]:
    """Yield what every mesh of a pair puts on the shaft, once for each half of its gear."""
    for mesh in context.train.meshes:
        if mesh.stage in context.design.pairs and name in mesh.nodes[:2]:
            side = mesh.nodes.index(name)
            gear = gears[mesh.gears[side]]
            kind = context.design.pairs[mesh.stage].kind
            if kind != "cylindrical":
                crossing = _face_load if kind == "face" else _bevel_load
                yield crossing(context, mesh, side, axes, gear).part(plan.places[gear.name], 1.0)
                continue
            load = _mesh_load(context, mesh, side, axes, (gears[mesh.gears[0]], gears[mesh.gears[1]]))
            for half in range(mesh.count):
                offset = (half - (mesh.count - 1) / 2.0) * gear.face_width
                yield load.part(plan.places[gear.name] + offset, 1.0 / mesh.count)


def _mesh_load(
    context: Context, mesh: Mesh, side: int, axes: Mapping[str, complex], pair: tuple[GearSizing, GearSizing]
) -> _Load:
    """Return what all halves of a mesh together put on one of its two gears, at the origin."""
    rating, rolls = context.ratings[mesh.stage], rolling_of(context.rating(mesh), pair, mesh)
    radius = rolls.radii[side]
    torque = np.array([flow.meshes[mesh.name].torques[side] for flow in context.flows.values()])
    tangential = torque / radius * rating.load_factor
    radial = np.abs(tangential) * math.tan(rolls.pressure_angle)
    toward = _toward_mesh(mesh, side, axes)
    outward = 1.0 if mesh.sign == INTERNAL and side == 1 else -1.0
    force = toward * (1j * tangential + outward * radial)
    hand = helix_hand(context.design, context.train, context.flows, mesh.nodes[side])
    slope = hand * rolls.lean if mesh.count == 1 else 0.0
    axial = -slope * tangential
    return _Load(0.0, torque, force, -toward * radius * axial, axial)


def _face_load(context: Context, mesh: Mesh, side: int, axes: Mapping[str, complex], gear: GearSizing) -> _Load:
    """Return what a face-gear mesh puts on its wheel (1: tangential and axial force) or on its pinion (0: torque)."""
    rating, radius = context.ratings[mesh.stage], gear.pitch_diameter / 2.0
    torque = np.array([flow.meshes[mesh.name].torques[side] for flow in context.flows.values()])
    none = np.zeros_like(torque)
    if side == 0:
        return _Load(0.0, torque, none.astype(complex), none.astype(complex), none)
    tangential = torque / radius * rating.load_factor
    toward = _toward_mesh(mesh, side, axes)
    # The pinion pushes the wheel away from itself, to the side on which the wheel lies.
    away = 1.0 if toward.real + toward.imag > 0.0 else -1.0
    axial = away * np.abs(tangential) * math.tan(rating.rules.pressure_angle)
    return _Load(0.0, torque, toward * 1j * tangential, -toward * radius * axial, axial)


def _bevel_load(context: Context, mesh: Mesh, side: int, axes: Mapping[str, complex], gear: GearSizing) -> _Load:
    """Return what a bevel mesh puts on its pinion (0) or wheel (1), at the mean cone.

    The hand of spiral is the one that pushes the pinion away from the apex in the rated case, which keeps backlash.
    """
    rating, pair, radius = context.ratings[mesh.stage], context.design.pairs[mesh.stage], gear.pitch_diameter / 2.0
    torque = np.array([flow.meshes[mesh.name].torques[side] for flow in context.flows.values()])
    tangential = torque / radius * rating.load_factor
    rated = context.reference.meshes[mesh.name].torques[side]
    pushed = np.sign(torque * rated) * (1.0 if side == 0 else -1.0)
    here, mate = (context.teeth[mesh.gears[k]] for k in (side, 1 - side))
    forces = bevel_push(rating, np.abs(tangential), here / mate, pushed=pushed)
    away, radial = np.asarray(forces[0]), np.asarray(forces[1])
    apex = pair.pinion_apex if side == 0 else pair.wheel_apex
    axial = away if apex == "first" else -away
    toward = _toward_mesh(mesh, side, axes)
    return _Load(0.0, torque, toward * (1j * tangential - radial), -toward * radius * axial, axial)


def _toward_mesh(mesh: Mesh, side: int, axes: Mapping[str, complex]) -> complex:
    """Return the direction from a gear's axis to its pitch point: towards its mate, or, inside a ring, away from it."""
    between = axes[mesh.nodes[1]] - axes[mesh.nodes[0]]
    from_first = between / abs(between)
    if mesh.sign == INTERNAL:
        return -from_first
    return from_first if side == 0 else -from_first
