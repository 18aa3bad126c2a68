"""What the meshes of a sized train lose."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.gears import ToothShift
from gearwright.parts.losses import MeshDuty, ToothContact, mesh_loss_part, tooth_contact
from gearwright.sizing.losses.limits import mesh_limits
from gearwright.sizing.losses.oil import Oil
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.result import GearSizing, Sizing


class Teeth(NamedTuple):
    """What the losses of the meshes depend on and no load changes; one entry for each mesh row."""

    contacts: tuple[ToothContact, ...]
    radii: Floats
    """Working pitch radius of gear a, shape (meshes,) [m]."""
    widths: Floats
    """Narrower face, shape (meshes,) [m]."""


def teeth_of(sizing: Sizing) -> Teeth:
    """Return what the losses of the meshes depend on.

    Args:
        sizing: As sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    pairs = [(gears[mesh.gears[0]], gears[mesh.gears[1]]) for mesh in sizing.train.meshes]
    return Teeth(
        contacts=tuple(_contact(sizing, pair, mesh) for pair, mesh in zip(pairs, sizing.meshes, strict=True)),
        radii=np.array([mesh.working_diameter / 2.0 for mesh in sizing.meshes]),
        widths=np.array([min(gear.face_width, mate.face_width) for gear, mate in pairs]),
    )


def mesh_loss_parts(
    sizing: Sizing, teeth: Teeth, torques: Floats, *, speeds: Mapping[str, float], oil: Oil
) -> dict[str, float]:
    """Return mesh row -> part of the power of its teeth that it loses [-].

    Args:
        sizing: As sized.
        teeth: Its contacts.
        torques: On gear a of one single mesh of each row, shape (meshes,) [N m].
        speeds: Node -> its speed, of the ground too [rad/s].
        oil: Between the teeth.
    """
    return {
        mesh.name: mesh_loss_part(teeth.contacts[k], duty, oil.on_teeth(mesh.stage), law=oil.friction)
        for k, (mesh, duty) in enumerate(zip(sizing.train.meshes, _duties(sizing, teeth, torques, speeds), strict=True))
    }


def mesh_loss_limits(
    sizing: Sizing, teeth: Teeth, torques: Floats, *, speeds: Mapping[str, float], oil: Oil
) -> dict[str, str]:
    """Return mesh row -> limits at which its loss is taken, as words; empty where the formula holds.

    Args:
        sizing: As sized.
        teeth: Its contacts.
        torques: On gear a of one single mesh of each row, shape (meshes,) [N m].
        speeds: Node -> its speed, of the ground too [rad/s].
        oil: Between the teeth.
    """
    kinds = {name: pair.kind for name, pair in sizing.design.pairs.items()}
    duties = _duties(sizing, teeth, torques, speeds)
    return {
        mesh.name: mesh_limits(
            teeth.contacts[k], duty, oil.on_teeth(mesh.stage), oil.friction, kinds.get(mesh.stage, "")
        )
        for k, (mesh, duty) in enumerate(zip(sizing.train.meshes, duties, strict=True))
    }


def _duties(sizing: Sizing, teeth: Teeth, torques: Floats, speeds: Mapping[str, float]) -> Iterator[MeshDuty]:
    """Yield load and velocity of every mesh row."""
    for k, mesh in enumerate(sizing.train.meshes):
        normal = abs(torques[k]) / (teeth.radii[k] * np.cos(teeth.contacts[k].pressure_angle))
        velocity = (speeds[mesh.nodes[0]] - speeds[mesh.nodes[2]]) * teeth.radii[k]
        yield MeshDuty(float(normal / teeth.widths[k]), float(teeth.widths[k]), float(velocity))


def _contact(sizing: Sizing, pair: tuple[GearSizing, GearSizing], mesh: MeshSizing) -> ToothContact:
    gear, mate = pair
    shifted = gear.profile_shift + mate.profile_shift != 0.0
    return tooth_contact(
        (gear.teeth, -mate.teeth if mate.name in sizing.train.internal else mate.teeth),
        gear.module,
        pressure_angle=sizing.design.rules(mesh.stage).pressure_angle,
        helix_angle=gear.helix_angle,
        shifts=(_shift(gear), _shift(mate)),
        working_angle=mesh.working_pressure_angle if shifted else None,
    )


def _shift(gear: GearSizing) -> ToothShift:
    return ToothShift(gear.profile_shift, gear.tip_alteration)
