"""Every check of the gears of a design: strength; of those that a standard rates scuffing, and what can be cut."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from gearwright.checks import Check, not_assessed
from gearwright.identity import Kind, PartId, Role
from gearwright.parts.bevel import WIDEST, WIDEST_MODULES
from gearwright.parts.gears import ISO53_A, least_teeth
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import (
    Context,
    Rating,
    Unloaded,
    cone_ratio,
    cylindrical_mesh,
    fewest_virtual_teeth,
    method_for,
)
from gearwright.sizing.result import GearSizing
from gearwright.sizing.stages.stage_sizes import StageSize

LEAST_CONTACT_RATIO = 1.0
"""Least transverse contact ratio ε_α with which motion is passed on without a gap [-]."""


def gear_checks(
    context: Context, gears: tuple[GearSizing, ...], meshes: tuple[MeshSizing, ...], sizes: Mapping[str, StageSize]
) -> Iterator[Check]:
    """Yield every check of the gears.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        meshes: From `size_meshes`.
        sizes: From `stage_sizes`.
    """
    by_name = {gear.name: gear for gear in gears}
    for mesh in meshes:
        parts = (by_name[mesh.gears[0]].part, by_name[mesh.gears[1]].part)
        yield from _strength(context.ratings[mesh.stage], mesh, parts)
    for stage, size in sizes.items():
        if context.ratings[stage].proportions is not None:
            row = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
            pair = (by_name[row.gears[0]], by_name[row.gears[1]])
            yield from (_cone if context.ratings[stage].kind == "bevel" else _cylinder)(
                context.ratings[stage], pair, size
            )


def _strength(rating: Rating, mesh: MeshSizing, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    """Yield what the method of a stage says of a mesh."""
    method = method_for(rating)
    if isinstance(mesh.rating, Unloaded):
        yield not_assessed(mesh.part, "strength", method.edition, "no load case sends power through it")
    else:
        yield from method.checks(mesh.rating, mesh.part, gears)


def _cylinder(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, second = pair
    rules, internal = rating.rules, second.role is Role.RING
    widest = rating.proportions
    assert widest is not None
    width, pinion = size.face_width, min(pair, key=lambda gear: gear.teeth)
    limits = {
        f"b ≤ {widest.widest_modules:g} m_n, usual": widest.widest_modules * size.module,
        f"b ≤ {widest.widest_diameters:g} d_1, usual": widest.widest_diameters * first.pitch_diameter,
    }
    for clause, largest in limits.items():
        yield Check(first.part, "face width", clause, width, largest, "length", at_most=True, exponent=None)
    height = ISO53_A.straight_dedendum - rules.profile_shift
    fewest = least_teeth(height, pressure_angle=rules.pressure_angle, helix_angle=rating.helix_angle)
    part, fewest = pinion.part, math.ceil(fewest - 1e-9)
    yield Check(part, "undercut", "ISO 21771, z_min", pinion.teeth, fewest, "number", exponent=None, symbol="z")
    mesh = cylindrical_mesh((first.teeth, second.teeth), size.module, width, rating, internal=internal)
    ratio = float(mesh.transverse_contact_ratio)
    stage = PartId(Kind.STAGE, first.stage)
    yield Check(stage, "contact ratio", "ISO 21771", ratio, LEAST_CONTACT_RATIO, exponent=None, symbol="ε_α")


def _cone(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, second = pair
    cone = float(cone_ratio(first.teeth, second.teeth))
    outer = size.module / math.cos(rating.helix_angle) + size.face_width / (2.0 * cone)
    limit = min(WIDEST * cone, WIDEST_MODULES) * outer
    clause = "ISO 23509, annex B: R_e/3 and 10 m_et"
    part, asked, fewest = first.part, size.asked_width, fewest_virtual_teeth(rating)
    yield Check(part, "face width", clause, asked, limit, "length", at_most=True, exponent=None)
    virtual = first.teeth * math.hypot(first.teeth, second.teeth) / second.teeth
    clause = "ISO 23509, z_1/cos δ_1"
    yield Check(part, "undercut", clause, virtual, fewest, "number", exponent=None, symbol="z_v")
