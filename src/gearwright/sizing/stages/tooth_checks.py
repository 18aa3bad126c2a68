"""Whether teeth can be cut, run and be put together: undercut, tips, contact, interference in rings, planets."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

from gearwright.checks import Check
from gearwright.identity import Kind, PartId, Role, gear_part
from gearwright.parts.gears import (
    ISO53_A,
    CylindricalGear,
    GearPair,
    assembly_room,
    involute_room,
    least_teeth,
    tip_room,
    tip_thickness,
)
from gearwright.parts.planetary import tip_gap
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.tooth_play import backlash_of
from gearwright.sizing.tooth_shape import cylindrical_gear, planet_positions
from gearwright.train import INTERNAL, Mesh

LEAST_CONTACT_RATIO = 1.0
"""Least transverse contact ratio ε_α with which motion is passed on without a gap [-]."""
THINNEST_TIP = 0.2
"""Least tooth thickness at the tip over the module [-]; DIN 3960:1987, 0.4 where the tip is hardened through."""


def tooth_checks(
    context: Context, stage: str, gears: Mapping[str, GearSizing], meshes: list[MeshSizing]
) -> Iterator[Check]:
    """Yield what the teeth of a stage of cylindrical gears are held against.

    Args:
        context: What sizing reads.
        stage: A pair or planetary set.
        gears: By name.
        meshes: Its rows.
    """
    rows = {mesh.name: mesh for mesh in context.train.meshes}
    own = {name: gears[name] for mesh in meshes for name in mesh.gears}
    shapes = {name: cylindrical_gear(context.design, gear) for name, gear in own.items()}
    pairs = [_tooth_pair(context, rows[mesh.name], shapes, mesh.centre_distance) for mesh in meshes]
    yield _undercut(context, list(own.values()))
    part = PartId(Kind.STAGE, stage)
    ratio = min(pair.transverse_contact_ratio for pair in pairs)
    yield Check(part, "contact ratio", "ISO 21771", ratio, LEAST_CONTACT_RATIO, exponent=None, symbol="ε_α")
    for gear in own.values():
        if gear.name not in context.train.internal and (gear.profile_shift or gear.tip_alteration):
            tip = tip_thickness(shapes[gear.name]) * math.cos(gear.helix_angle) / gear.module
            yield Check(gear.part, "tip thickness", "DIN 3960", tip, THINNEST_TIP, exponent=None, symbol="s_an/m_n")
    for mesh, pair in zip(meshes, pairs, strict=True):
        yield from _play(context, mesh, gears)
        if pair.side < 0:
            yield from _inside(mesh.part, pair)
    yield from _neighbours(context, stage, gears, shapes)


def _tooth_pair(context: Context, mesh: Mesh, shapes: Mapping[str, CylindricalGear], centre: float) -> GearPair:
    """Return one mesh of a row of cylindrical gears on its working centre distance [m]."""
    first, second = (shapes[name] for name in mesh.gears)
    if mesh.sign == INTERNAL:
        second = replace(second, teeth=-second.teeth)
    return GearPair(first, second, centre if context.rating(mesh).shifts.centre is not None else None)


def _undercut(context: Context, gears: list[GearSizing]) -> Check:
    """Return the check of the gear that is nearest to undercut, or furthest beyond it."""
    external = [gear for gear in gears if gear.name not in context.train.internal]
    gear = min(external, key=lambda candidate: candidate.teeth - fewest_uncut(context, candidate))
    limit = math.ceil(fewest_uncut(context, gear) - 1e-9)
    return Check(gear.part, "undercut", "ISO 21771, z_min", gear.teeth, limit, "number", exponent=None, symbol="z")


def fewest_uncut(context: Context, gear: GearSizing) -> float:
    """Return the teeth of a gear of its angles and shift that are just not undercut [-].

    Args:
        context: What sizing reads.
        gear: External.
    """
    rating, height = context.ratings[gear.stage], ISO53_A.straight_dedendum - gear.profile_shift
    return least_teeth(height, pressure_angle=rating.rules.pressure_angle, helix_angle=rating.helix_angle)


def _play(context: Context, mesh: MeshSizing, gears: Mapping[str, GearSizing]) -> Iterator[Check]:
    """Yield whether the thickest teeth leave a gap where the axes stand as badly as they may."""
    if (play := backlash_of(context.design, gears, mesh)) is not None:
        clause = "DIN 3967, DIN 3964"
        yield Check(mesh.part, "backlash", clause, play.opened, play.closed, "length", exponent=None, symbol="j_bn")


def _inside(part: PartId, pair: GearPair) -> Iterator[Check]:
    """Yield the three interferences of a gear inside a ring: of involutes, of tips, on the way in."""
    kinds = {
        "involute interference": (involute_room(pair), "Niemann & Winter II", "length", "r_a2"),
        "tip interference": (tip_room(pair), "Colbourne 1987", "angle", "θ"),
        "radial assembly": (assembly_room(pair), "Colbourne 1987, trimming", "length", "s"),
    }
    for mode, (room, clause, dimension, symbol) in kinds.items():
        if room is not None:
            yield Check(part, mode, clause, room.there, room.needed, dimension, exponent=None, symbol=symbol)


def _neighbours(
    context: Context, stage: str, gears: Mapping[str, GearSizing], shapes: Mapping[str, CylindricalGear]
) -> Iterator[Check]:
    """Yield the gap between the tips of neighbouring planets."""
    if stage not in context.design.planetaries:
        return
    planet, sun = (gears[str(gear_part(stage, role))] for role in (Role.PLANET, Role.SUN))
    positions = planet_positions(context.design, stage, context.teeth)
    centre = context.ratings[stage].shifts.centre
    arm = (sun.pitch_diameter + planet.pitch_diameter) / 2.0 if centre is None else centre * sun.module
    if len(positions) > 1:
        tips = 2.0 * shapes[planet.name].tip_radius
        apart = tip_gap(arm, 0.0, positions)
        yield Check(PartId(Kind.STAGE, stage), "planets apart", "tip circles", apart, tips, "length", exponent=None)
