"""Gears and meshes of a train whose stages are sized: diameters, forces, stresses, margins, masses."""

from __future__ import annotations

import math
from collections.abc import Mapping

from gearwright.identity import Role
from gearwright.parts.gears import disc_inertia, disc_mass, ring_inertia, ring_mass
from gearwright.sizing.compound import plane_counts
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import Context, Demand, bevel_push, rate_row
from gearwright.sizing.result import GearSizing
from gearwright.sizing.rolling import rolling_of
from gearwright.sizing.stages.stage_sizes import StageSize
from gearwright.train import Gear, Mesh


def size_gears(context: Context, sizes: Mapping[str, StageSize]) -> tuple[GearSizing, ...]:
    """Return every kind of gear body.

    Args:
        context: What gear sizing reads.
        sizes: Stage, or group of gears of a compound set -> its module and face width.
    """
    lengths = {name: plane_counts(epicyclic) for name, epicyclic in context.design.epicyclics.items()}
    planes = {gear.name: lengths.get(gear.stage, {}).get(gear.own, 1) for gear in context.train.gears}
    return tuple(
        _gear(context, gear, sizes[gear.sized].planes(planes[gear.name])) for gear in context.train.gears
    )  # fmt: skip


def _gear(context: Context, gear: Gear, size: StageSize) -> GearSizing:
    rating, teeth, given = context.ratings[gear.stage], context.teeth[gear.name], context.given
    module, width = size.module, size.face_width
    diameter = module * teeth / math.cos(rating.helix_angle)
    density = rating.material.density
    ring = gear.name in context.train.internal
    wall = rating.rules.rim_thickness_ratio * module if ring else 0.0
    shift = rating.shift_of(gear)
    # Profile shift moves teeth and roots as they are; what is cut off thin tips is left out.
    thicker = shift.profile_shift * module if rating.kind == "cylindrical" else 0.0
    if ring:
        mean, depth = diameter - 2.0 * thicker, wall
        mass = ring_mass(mean, depth, width, density=density)
    else:
        mean, depth = diameter + 2.0 * thicker, 0.0
        mass = disc_mass(mean, width, density) * (rating.rules.web_ratio if gear.role is Role.WHEEL else 1.0)
    mass = given.get(f"{gear.name}.mass", mass)
    inertia = ring_inertia(mass, mean, depth) if ring else disc_inertia(mass, mean)
    return GearSizing(
        stage=gear.stage,
        role=gear.role,
        shafts=gear.nodes,
        bodies=gear.bodies,
        teeth=teeth,
        module=module,
        helix_angle=rating.helix_angle,
        face_width=width,
        pitch_diameter=diameter,
        rim=wall - thicker if ring else 0.0,  # the root circle moves with the teeth, and the wall behind it
        mass=mass,
        inertia=given.get(f"{gear.name}.inertia", inertia),
        profile_shift=shift.profile_shift,
        tip_alteration=shift.tip_alteration,
        own=gear.own,
    )


def size_meshes(
    context: Context, gears: tuple[GearSizing, ...], demands: Mapping[str, Demand]
) -> tuple[MeshSizing, ...]:
    """Return every mesh row at its worst case.

    Args:
        context: What gear sizing reads.
        gears: From `size_gears`.
        demands: Mesh row -> what it asks for.
    """
    by_name = {gear.name: gear for gear in gears}
    return tuple(
        _mesh(context, mesh, (by_name[mesh.gears[0]], by_name[mesh.gears[1]]), demands[mesh.name])
        for mesh in context.train.meshes
    )


def _mesh(context: Context, mesh: Mesh, pair: tuple[GearSizing, GearSizing], demand: Demand) -> MeshSizing:
    rating, (first, _) = context.rating(mesh), pair
    case, per_tooth, module_bending, module_contact = demand
    width = min(gear.face_width for gear in pair)
    rolls = rolling_of(rating, pair, mesh)
    force = per_tooth * first.teeth / rolls.radii[0]
    flow = context.flows[case]
    rolling = abs(flow.speeds[mesh.nodes[0]] - flow.speeds[mesh.nodes[2]])
    if rating.kind == "bevel":
        axial, radial = (float(push) for push in bevel_push(rating, force, first.teeth / pair[1].teeth))
    else:
        axial = rolls.axial(force)
        radial = rolls.radial(force)
    return MeshSizing(
        stage=mesh.stage,
        row=mesh.row,
        gears=mesh.gears,
        count=mesh.count,
        case=case,
        load_factor=rating.load_factor,
        tangential_force=force,
        radial_force=radial,
        axial_force=axial,
        pitch_line_velocity=rolling * rolls.radii[0],
        centre_distance=rolls.centre_distance,
        working_pressure_angle=rolls.pressure_angle,
        working_diameter=2.0 * rolls.radii[0],
        rating=rate_row(context, mesh, first.module, width, asked=(module_bending, module_contact)),
        branch=mesh.branch,
        own=mesh.own,
    )
