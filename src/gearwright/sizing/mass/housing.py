"""The housing: a shell around the arrangement, as thick as casting, torque and bearings ask, and what is on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gearwright.base import Role, largest_first
from gearwright.catalogue import STEEL_DENSITY, STEEL_SHARE, HousingMaterial, housing_materials
from gearwright.memo import of_latest
from gearwright.parts.bearings import BearingKind
from gearwright.sizing.casing import (
    BOSS,
    Carried,
    Flanges,
    bosses_of,
    carried_bosses,
    flanges_of,
    housed,
    lands_of,
    screw_volume,
    shell_of,
)
from gearwright.sizing.housing_shell import Shell, section_across
from gearwright.sizing.mass.record import CALIBRATED, Calibration, MassItem
from gearwright.sizing.result import Direction, Sizing
from gearwright.sizing.shaft_results import BearingSizing
from gearwright.sizing.shafts import holders_of

SURE = 0.35
"""One standard deviation of housings over their value, an estimate [-]."""
RIBS = 0.20
"""Ribs over the shell [-], an estimate: as high as five walls, as thick as one, a fifth of the area each way."""
MOUNTS = 0.10
"""Feet, lugs and torque arms over the shell [-], an estimate."""
ALONG = 1e-6
"""How far the cosine of directions of one axis may differ from 1 [-]."""
SEAT = 1.6
"""Outside of a bearing over its shaft [-]: light series of ISO 15."""
_SHARE = STEEL_SHARE[BearingKind.CYLINDRICAL]


class Wall(NamedTuple):
    """How thick the shell is, and why."""

    thickness: float
    """[m]"""
    why: str
    """What asks for it."""


def housing_items(
    sizing: Sizing, shell: Shell, bearings: Sequence[MassItem], fitted: Calibration
) -> Iterator[MassItem]:
    """Yield the housing's shell and what is on it.

    Args:
        sizing: As sized.
        shell: Around it.
        bearings: Bearings with their masses.
        fitted: What published gearboxes set.
    """
    rules = sizing.design.housing
    if rules.mass is not None:
        yield MassItem("housing", "housing", 1, rules.mass, 0.02, "given", "housing.mass of the design")
    elif rules.own:
        wall = wall_of(sizing, shell, fitted)
        yield from _parts(sizing, shell, wall, bearings)


def _parts(sizing: Sizing, shell: Shell, wall: Wall, bearings: Sequence[MassItem]) -> Iterator[MassItem]:
    planets = {str(gear.part) for gear in sizing.gears if gear.role is Role.PLANET}
    material = housing_materials()[sizing.design.housing.material]
    skin = shell.area * wall.thickness * material.density
    yield _item("shell", skin, f"A t ρ, t by {wall.why}", material.source)
    yield _item("ribs", RIBS * skin, "0.2 of the shell", "estimate")
    yield _item("mounts", MOUNTS * skin, "0.1 of the shell", "estimate")
    flanges = flanges_of(sizing, shell, reaction_torque(sizing))
    ring = 2.0 * flanges.face * flanges.thickness * material.density
    yield _item("flanges", ring, "2 · 2.5 d · 1.2 d · girth", "proportions of cast housings", flanges.number)
    screws = flanges.screws * screw_volume(flanges.thread) * STEEL_DENSITY
    yield _item("bolts", screws, "7 d³ ρ each, at most 5 d apart", "grip of a flange; ISO 898-1", flanges.number)
    yield _item("pads", _pads(sizing, wall.thickness, material), "F/(2 D τ) − t on 2 D around bearings", "equilibrium")
    sized = {bearing.name for bearing in sizing.bearings}
    bosses = sum(_boss(item, material) for item in bearings if item.part not in planets | sized)
    outside = bosses_of(sizing, holders_of(sizing))
    bosses += sum(_around(bearing, outside[bearing.name], material) for bearing in sizing.bearings)
    yield _item("bosses", bosses, "wall of 0.12 D around bearings, as wide as covers at least", "estimate")
    webs = sum(carried.volume for carried in carried_bosses(sizing, wall.thickness)) * material.density
    if webs:
        yield _item("webs", webs, "F = Σ k_i (u_i·δ) u_i, σ = N/A + M/W ≤ 2 τ", "webs built in at both ends")
    lands = sum(land.volume for land in lands_of(sizing, wall.thickness)) * material.density
    if lands:
        yield _item("lands of rings", lands, "from the splines of rings to the wall", "DIN 5480-1; widths: estimates")


def _item(part: str, mass: float, formula: str, source: str, count: int = 1) -> MassItem:
    return MassItem(f"housing {part}", "housing", count, mass, SURE, formula, source)


def _boss(bearing: MassItem, material: HousingMaterial) -> float:
    """Return the mass of the bosses around equal bearings, whose outside and width follow from their mass [kg].

    Light series: d = D/1.6 (`SEAT`), B = 0.2 D; the steel's share of that room is the catalogue's.
    """
    room = _SHARE * STEEL_DENSITY * math.pi / 4.0 * (1.0 - 1.0 / SEAT**2) * 0.2
    outside = (bearing.each / room) ** (1.0 / 3.0)
    section = math.pi / 4.0 * ((1.0 + 2.0 * BOSS) ** 2 - 1.0) * outside**2
    return float(bearing.count * section * 0.25 * outside * material.density)


def _around(bearing: BearingSizing, outside: float, material: HousingMaterial) -> float:
    """Return the mass of the boss around a sized bearing, as wide as that [kg]."""
    section = math.pi / 4.0 * (outside**2 - bearing.outer_diameter**2)
    return section * bearing.width * material.density


def wall_of(sizing: Sizing, shell: Shell, fitted: Calibration = CALIBRATED) -> Wall:
    """Return the wall of a housing: the larger of what casting and torque ask, or the given one.

    Args:
        sizing: As sized.
        shell: Around it.
        fitted: What published gearboxes set.

    Source: Bredt's shear flow, τ = T/(2 A t), in the largest section across the axis of each torque.
    """
    given = sizing.design.housing.wall
    if given is not None:
        return Wall(given, "the design")
    material = housing_materials()[sizing.design.housing.material]
    shear = fitted.stress_share * material.shear_strength
    asked = [Wall(material.least_wall, "the thinnest casting")]
    for way, torque in held_torques(sizing):
        section = shell.section if abs(way.x) > 1.0 - ALONG else section_across(housed(sizing), way)
        asked.append(Wall(torque / (2.0 * section * shear), "its torque"))
    return max(asked)


@of_latest(1)
def weighed_wall(sizing: Sizing) -> Wall:
    """Return the wall of a housing around all that stands in it.

    Args:
        sizing: As sized.
    """
    return wall_of(sizing, shell_of(sizing))


@of_latest(1)
def weighed_flanges(sizing: Sizing) -> Flanges:
    """Return the flanges of a housing around all that stands in it.

    Args:
        sizing: As sized.
    """
    return flanges_of(sizing, shell_of(sizing), reaction_torque(sizing))


@of_latest(1)
def carried_in_walls(sizing: Sizing) -> tuple[Carried, ...]:
    """Return how the housing, in its wall as it is weighed, carries the bosses of bearings.

    Args:
        sizing: As sized.
    """
    return carried_bosses(sizing, weighed_wall(sizing).thickness)


def held_torques(sizing: Sizing) -> tuple[tuple[Direction, float], ...]:
    """Return what the housing holds about each direction of machines' axes, in the case that speaks for the design.

    Args:
        sizing: As sized.

    Returns:
        Directions, from the first shaft's on, and torques [N m]: their sum about each, the largest machine at least.

    Source: equilibrium of the whole.
    """
    shafts, frames = sizing.train.machines, sizing.arrangement.frames
    about = [(frames[shafts[name]].along, torque) for name, torque in sizing.reference.machine_torques.items()]
    found: list[tuple[Direction, float]] = []
    for way, _ in largest_first(about, lambda one: abs(one[0].x)):
        if all(abs(_cosine(way, other)) < 1.0 - ALONG for other, _ in found):
            parts = [torque for other, torque in about if abs(_cosine(way, other)) > 1.0 - ALONG]
            found.append((way, max(abs(sum(parts)), *map(abs, parts))))
    return tuple(found)


def _cosine(one: Direction, other: Direction) -> float:
    return sum(a * b for a, b in zip(one, other, strict=True))


def reaction_torque(sizing: Sizing) -> float:
    """Return what joints across the first shaft hold, in the case that speaks for the design [N m].

    Args:
        sizing: As sized.

    Source: equilibrium of the whole; bevel pairs turn a torque's direction, so the largest machine counts at least.
    """
    torques = list(sizing.reference.machine_torques.values())
    return max(abs(sum(torques)), *(abs(torque) for torque in torques))


def _pads(sizing: Sizing, wall: float, material: HousingMaterial) -> float:
    """Return what thickens the wall around bearings that shear it, on twice their outside diameter [kg].

    A bearing's force goes into the wall on both sides of it, τ = F/(2 D t).
    """
    mass = 0.0
    for shaft in sizing.shafts:
        seat = SEAT * shaft.diameter
        for bearing in shaft.bearings:
            asked = bearing.radial_force / (2.0 * seat * material.shear_strength)
            mass += math.pi / 4.0 * 3.0 * seat**2 * max(asked - wall, 0.0) * material.density
    return mass
