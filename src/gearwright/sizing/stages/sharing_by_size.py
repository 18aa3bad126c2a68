"""K_γ that follows from the sizes of gears and their loads: by tolerances of pins, by the clocking of two paths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearwright.catalogue import LEAST_SHARING
from gearwright.identity import Role
from gearwright.parts.iso6336 import mesh_springs
from gearwright.parts.planetary import clocking_load_factor, path_stiffness, tolerance_load_factor
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import Context, cylindrical_mesh, load_sharing
from gearwright.sizing.rating.iso6336 import steels_of
from gearwright.sizing.result import GearSizing
from gearwright.spec import Epicyclic, Pair, Planetary
from gearwright.spec.design import split_levels
from gearwright.train import INTERNAL

ROUNDS = 8
"""Times that gears are sized anew with the K_γ of their sizes, at most [-]."""
STILL = 1e-3
"""Change of K_γ that counts as none [-]."""
BEARING = 1e9
"""Radial stiffness of a planet's bearing on its pin where none is given [N/m], an estimate."""
LARGEST = 3.0
"""K_γ at most, as where it is given [-]: beyond, planets do not all carry."""


def sharing_of_sizes(
    context: Context, gears: Sequence[GearSizing], meshes: Sequence[MeshSizing]
) -> Mapping[str, float]:
    """Return stage -> K_γ by the sizes of its gears, where the design asks for that [-].

    Args:
        context: What gear sizing reads.
        gears: As sized.
        meshes: As sized.
    """
    found = dict[str, float]()
    for name, stage in context.design.stages.items():
        if load_sharing(context.design, name).by_size:
            own = [mesh for mesh in meshes if mesh.stage == name]
            if isinstance(stage, Pair):
                factor = _by_clocking(context, name, stage, own)
            else:
                factor = max(_by_tolerances(context, stage, gears, mesh) for mesh in own)
            found[name] = min(max(factor, 1.0), LARGEST)
    return found


def _by_clocking(context: Context, name: str, pair: Pair, meshes: Sequence[MeshSizing]) -> float:
    """Return K_γ of clocked paths by the torque that comes in where they part, in the case that loads them most."""
    case = meshes[0].case
    rows = [row for row in context.train.meshes if row.stage == name]
    multiplier = sum(abs(context.flows[case].meshes[row.name].multiplier) for row in rows)
    split = 0 if len(pair.named(Role.WHEEL)) >= len(pair.named(Role.PINION)) else 1
    torque = multiplier * context.teeth[rows[0].gears[split]]
    assert pair.clocking is not None
    return float(clocking_load_factor(pair.clocking, torque) ** split_levels(context.design)[name])


def _by_tolerances(
    context: Context, stage: Planetary | Epicyclic, gears: Sequence[GearSizing], mesh: MeshSizing
) -> float:
    """Return K_γ of a set by the places of its pins, in the case that loads a mesh most."""
    rating = context.ratings[mesh.stage]
    first, second = (next(gear for gear in gears if gear.name == name) for name in mesh.gears)
    row = next(row for row in context.train.meshes if row.name == mesh.name)
    width = min(first.face_width, second.face_width)
    pair = cylindrical_mesh(
        (first.teeth, second.teeth), first.module, width, context.rating(row), internal=row.sign == INTERNAL
    )
    springs = mesh_springs(pair, steels=steels_of(rating, (first.role, second.role)))
    pin = stage.bearings.pin if isinstance(stage, Planetary) else None
    stiffness = path_stiffness(
        float(springs.mesh), width, bearing=pin or BEARING, pressure_angle=mesh.working_pressure_angle
    )
    planets = stage.planets if isinstance(stage, Planetary) else stage.sets
    assert stage.pin_position is not None
    force = mesh.tangential_force / mesh.load_factor
    factor = tolerance_load_factor(planets, stage.pin_position, force, stiffness=stiffness, floating=True)
    return max(factor, LEAST_SHARING)
