"""Every check of the gears of a design that ISO 6336 or ISO 10300 rates: strength, scuffing, and what can be cut."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from gearwright.parts.bevel import WIDEST, WIDEST_MODULES, BevelRating
from gearwright.parts.gears import ISO53_A, least_teeth
from gearwright.sizing.mounted import Check
from gearwright.sizing.rating import Context, MeshRating, Rating, cone_ratio, cylindrical_mesh, fewest_virtual_teeth
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.sizing.stages.stage_sizes import StageSize

LEAST_CONTACT_RATIO = 1.0
"""Least transverse contact ratio ε_α with which motion is passed on without a gap [-]."""


def gear_checks(
    context: Context, gears: tuple[GearSizing, ...], meshes: tuple[MeshSizing, ...], sizes: Mapping[str, StageSize]
) -> Iterator[Check]:
    """Yield every check of the gears that a standard rates.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        meshes: From `size_meshes`.
        sizes: From `stage_sizes`.
    """
    by_name = {gear.name: gear for gear in gears}
    for mesh in meshes:
        if mesh.rating is not None:
            rating = context.ratings[mesh.name.partition(".")[0]]
            yield from _strength(mesh, mesh.rating, rating)
    for stage, size in sizes.items():
        if context.ratings[stage].by_standard:
            row = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
            pair = (by_name[row.gears[0]], by_name[row.gears[1]])
            yield from (_cone if context.ratings[stage].kind == "bevel" else _cylinder)(
                context.ratings[stage], pair, size
            )


def _strength(mesh: MeshSizing, rated: MeshRating, rating: Rating) -> Iterator[Check]:
    rules, bevel = rating.rules.iso6336, isinstance(rated.factors, BevelRating)
    flank, root = ("ISO 10300-2, eq. 5", "ISO 10300-3, eq. 5") if bevel else ("ISO 6336-2, 5.3", "ISO 6336-3, 5.2")
    for gear, contact, bending in zip(mesh.gears, rated.pitting, rated.bending, strict=True):
        yield Check(gear, "pitting S_H", flank, contact, rules.pitting_safety)
        yield Check(gear, "tooth root S_F", root, bending, rules.bending_safety)
    if rated.scuffing is not None:
        yield Check(
            mesh.name, "scuffing S_intS", "ISO/TS 6336-21, eq. 14", rated.scuffing.safety, rules.scuffing_safety
        )


def _cylinder(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, second = pair
    rules, internal = rating.rules, second.role == "ring"
    width, pinion = size.face_width, min(pair, key=lambda gear: gear.teeth)
    limits = {
        f"b ≤ {rules.iso6336.widest_modules:g} m_n, usual": rules.iso6336.widest_modules * size.module,
        f"b ≤ {rules.iso6336.widest_diameters:g} d_1, usual": rules.iso6336.widest_diameters * first.pitch_diameter,
    }
    for clause, largest in limits.items():
        yield Check(first.name, "face width", clause, width, largest, "length", at_most=True)
    height = ISO53_A.straight_dedendum - rules.profile_shift
    fewest = least_teeth(height, pressure_angle=rules.pressure_angle, helix_angle=rating.helix_angle)
    yield Check(
        pinion.name, "teeth free of undercut", "ISO 21771, z_min", pinion.teeth, math.ceil(fewest - 1e-9), "number"
    )
    mesh = cylindrical_mesh((first.teeth, second.teeth), size.module, width, rating, internal=internal)
    ratio = float(mesh.transverse_contact_ratio)
    yield Check(first.stage, "contact ratio ε_α", "ISO 21771", ratio, LEAST_CONTACT_RATIO)


def _cone(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, second = pair
    cone = float(cone_ratio(first.teeth, second.teeth))
    outer = size.module / math.cos(rating.helix_angle) + size.face_width / (2.0 * cone)
    limit = min(WIDEST * cone, WIDEST_MODULES) * outer
    clause = "ISO 23509, annex B: R_e/3 and 10 m_et"
    yield Check(first.name, "face width", clause, size.asked_width, limit, "length", at_most=True)
    fewest = fewest_virtual_teeth(rating)
    virtual = first.teeth * math.hypot(first.teeth, second.teeth) / second.teeth
    yield Check(first.name, "virtual teeth free of undercut", "ISO 23509, z_1/cos δ_1", virtual, fewest, "number")
