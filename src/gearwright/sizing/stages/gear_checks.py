"""Every check of the gears of a design: strength; of those that a standard rates scuffing, and what can be cut."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from gearwright.checks import Check, not_assessed
from gearwright.identity import Kind, PartId
from gearwright.parts.bevel import WIDEST, WIDEST_MODULES, least_cutter_radius
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import (
    Context,
    Rating,
    Unloaded,
    bevel_pair,
    cone_ratio,
    fewest_virtual_teeth,
    method_for,
)
from gearwright.sizing.result import GearSizing
from gearwright.sizing.stages.stage_sizes import StageSize
from gearwright.sizing.stages.tooth_checks import tooth_checks

SAME_AXES = 1e-5
"""By how much centre distances of pairs on the same axes may differ [m]: within js6, ±14.5 µm at 180 to 250 mm."""


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
    for sized, size in sizes.items():
        own = {mesh.name for mesh in context.train.meshes if mesh.sized == sized}
        rows = [mesh for mesh in meshes if mesh.name in own]
        rating, pair = context.ratings[rows[0].stage], (by_name[rows[0].gears[0]], by_name[rows[0].gears[1]])
        if rating.proportions is not None:
            yield from (_cone if rating.kind == "bevel" else _cylinder)(rating, pair, size)
        if rating.kind == "cylindrical":
            yield from tooth_checks(context, rows[0].stage, by_name, rows)
    yield from _axes(context, {mesh.stage: mesh.centre_distance for mesh in meshes})


def _axes(context: Context, distances: Mapping[str, float]) -> Iterator[Check]:
    """Yield the pairs on common axes whose centre distances differ, by how much."""
    for name, pair in context.design.pairs.items():
        other = pair.coaxial_with
        if other is not None and abs(distances[name] - distances[other]) > SAME_AXES:
            why = f"centre distances of {1e3 * distances[name]:.6g} and {1e3 * distances[other]:.6g} mm on common axes"
            yield Check(
                PartId(Kind.STAGE, name), f"axes of {other}", "geometry", abs(distances[name] - distances[other]),
                SAME_AXES, "length", at_most=True, exponent=None, why=why,
            )  # fmt: skip


def _strength(rating: Rating, mesh: MeshSizing, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    """Yield what the method of a stage says of a mesh."""
    method = method_for(rating)
    if isinstance(mesh.rating, Unloaded):
        yield not_assessed(mesh.part, "strength", method.edition, "no load case sends power through it")
    else:
        yield from method.checks(mesh.rating, mesh.part, gears)


def _cylinder(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, widest, width = pair[0], rating.proportions, size.face_width
    assert widest is not None
    limits = {
        f"b ≤ {widest.widest_modules:g} m_n, usual": widest.widest_modules * size.module,
        f"b ≤ {widest.widest_diameters:g} d_1, usual": widest.widest_diameters * first.pitch_diameter,
    }
    for clause, largest in limits.items():
        yield Check(first.part, "face width", clause, width, largest, "length", at_most=True, exponent=None)


def _cone(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, second = pair
    cone = float(cone_ratio(first.teeth, second.teeth))
    outer = size.module / math.cos(rating.helix_angle) + size.face_width / (2.0 * cone)
    limit = min(WIDEST * cone, WIDEST_MODULES) * outer
    clause = "ISO 23509, annex B: R_e/3 and 10 m_et"
    part, asked, fewest = first.part, size.asked_width, fewest_virtual_teeth(rating)
    yield Check(part, "face width", clause, asked, limit, "length", at_most=True, exponent=None)
    virtual = first.teeth * math.hypot(first.teeth, second.teeth) / second.teeth
    if (cutter := rating.rules.cutter_radius) is not None and rating.helix_angle:
        least = least_cutter_radius(bevel_pair((first.teeth, second.teeth), size.module, size.face_width, rating))
        yield Check(part, "cutter", "ISO 23509, annex C.5", cutter, least, "length", exponent=None, symbol="r_c0")
    clause = "ISO 23509, z_1/cos δ_1"
    yield Check(part, "undercut", clause, virtual, fewest, "number", exponent=None, symbol="z_v")
