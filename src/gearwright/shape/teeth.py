"""The teeth of a sized gear as its drawing states them: cylinders, cones, hand, and what turns with what."""

from __future__ import annotations

from dataclasses import replace

from gearwright.errors import by_name
from gearwright.identity import SIDES
from gearwright.parts.bevel import Hand
from gearwright.parts.gears import CylindricalGear
from gearwright.sizing import GearSizing, MeshSizing, Sizing, tooth_shape
from gearwright.sizing.arrangement import helix_hand
from gearwright.sizing.as_sized import rating_as_sized
from gearwright.sizing.mass import bevel_cones as bevel_pair
from gearwright.sizing.rating import Making, method_for
from gearwright.spec import Pair
from gearwright.train import Mesh

__all__ = [
    "bevel_pair", "cylindrical_gear", "gear_of", "halves_of", "hand_of", "is_internal", "kind_of", "making_of",
    "meshes_of", "sized_mesh",
]  # fmt: skip


def gear_of(sizing: Sizing, name: str) -> GearSizing:
    """Return a gear by its name.

    Args:
        sizing: What was sized.
        name: Such as ``first.sun``.
    """
    return by_name(name, {gear.name: gear for gear in sizing.gears}, "gear")


def kind_of(sizing: Sizing, stage: str) -> str:
    """Return cylindrical, face or bevel.

    Args:
        sizing: What was sized.
        stage: A pair or a planetary set.
    """
    rules = sizing.design.stages[stage]
    return rules.kind if isinstance(rules, Pair) else "cylindrical"


def making_of(sizing: Sizing, stage: str) -> Making:
    """Return how the gears of a stage are made, as far as its method of rating asks.

    Args:
        sizing: What was sized.
        stage: A pair or a planetary set.
    """
    rating = rating_as_sized(sizing, stage)
    return method_for(rating).making(rating)


def halves_of(gear: GearSizing) -> int:
    """Return how often a gear of a pair stands on its shaft: 2 for a double-helical one, 1 for all others.

    Args:
        gear: As sized.
    """
    return max(gear.bodies // max(len(gear.shafts), 1), 1) if gear.role in SIDES else 1


def is_internal(sizing: Sizing, gear: GearSizing) -> bool:
    """Return True for a gear with teeth inside.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    return gear.name in sizing.train.internal


def cylindrical_gear(sizing: Sizing, gear: GearSizing) -> CylindricalGear:
    """Return the teeth of a cylindrical gear with the basic rack ISO 53 A and the profile shift of its stage.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    teeth = tooth_shape.cylindrical_gear(sizing.design, gear)
    return replace(teeth, teeth=-gear.teeth) if is_internal(sizing, gear) else teeth


def meshes_of(sizing: Sizing, gear: str) -> list[tuple[Mesh, int]]:
    """Return every mesh row of a gear, with 0 where it is the first gear of the row and 1 where it is the second.

    Args:
        sizing: What was sized.
        gear: Its name.
    """
    return [(mesh, mesh.gears.index(gear)) for mesh in sizing.train.meshes if gear in mesh.gears]


def sized_mesh(sizing: Sizing, mesh: Mesh) -> MeshSizing:
    """Return what sizing made of a mesh row.

    Args:
        sizing: What was sized.
        mesh: A row of its train.
    """
    return by_name(mesh.name, {row.name: row for row in sizing.meshes}, "mesh")


def hand_of(sizing: Sizing, gear: GearSizing, shaft: str) -> Hand | None:
    """Return the hand of helix or spiral that the forces of the sizing belong to; None for straight teeth.

    The spiral of a bevel pinion pushes it away from the apex in the rated case.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        shaft: That carries it.
    """
    if gear.helix_angle == 0.0:
        return None
    if kind_of(sizing, gear.stage) != "bevel":
        return Hand.LEFT if helix_hand(sizing.design, sizing.train, sizing.flows, shaft) < 0.0 else Hand.RIGHT
    (mesh, side), *_ = meshes_of(sizing, gear.name)
    stage = sizing.design.pairs[mesh.stage]
    pinion, flow = mesh.nodes[0], sizing.reference
    drives = flow.meshes[mesh.name].torques[0] * flow.speeds[pinion] < 0.0
    # Seen from the back towards the apex; a positive speed turns clockwise about the way from first to second end.
    clockwise = (flow.speeds[pinion] >= 0.0) == (stage.pinion_apex == "second")
    left = (clockwise == drives) == (side == 0)
    return Hand.LEFT if left else Hand.RIGHT
