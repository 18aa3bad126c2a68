"""Complete mass of a sized gearbox: its housing, oil system, seals, sensors and accessory drives."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Role, largest_first, verb
from gearwright.catalogue import STEEL_DENSITY, STEEL_SHARE, HousingMaterial, housing_materials
from gearwright.memo import of_latest
from gearwright.parts.bearings import BearingKind
from gearwright.parts.housings import bearing_wall, casting_wall, torque_arm_volume, torque_wall
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
from gearwright.sizing.inner_walls import inner_walls
from gearwright.sizing.losses import largest_heat
from gearwright.sizing.mass.bodies import (
    bearing_items,
    carrier_items,
    gear_items,
    planet_bores,
    seat_duties,
    shaft_items,
)
from gearwright.sizing.mass.record import DETAILS, CompleteMass, MassItem, class_of, ordered
from gearwright.sizing.result import Direction, Sizing
from gearwright.sizing.shaft_results import BearingSizing
from gearwright.sizing.shafts import holders_of, unsealed_exits

# ----------------------------------------------------------------------------------------------------------------------
# The housing: a shell around the arrangement, as thick as casting, torque and bearings ask, and what is on it.
# ----------------------------------------------------------------------------------------------------------------------


SURE = 0.35
"""One standard deviation of housings over their value, an estimate [-]."""
RIBS = 0.20
"""Ribs over the shell [-], an estimate: as high as five walls, as thick as one, a fifth of the area each way."""
MOUNTS = 0.10
"""Feet and lugs over the shell [-], an estimate."""
SHRINK_DISC = 0.35e-3
"""Shrink disc by which a rotor's shaft holds a gearbox's, over the torque [kg/(N m)], from makers' sheets by memory."""
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


def housing_items(sizing: Sizing, shell: Shell, bearings: Sequence[MassItem]) -> Iterator[MassItem]:
    """Yield the housing's shell and what is on it.

    Args:
        sizing: As sized.
        shell: Around it.
        bearings: Bearings with their masses.
    """
    rules = sizing.design.housing
    if rules.mass is not None:
        yield MassItem("housing", "housing", 1, rules.mass, 0.02, "given", "housing.mass of the design")
    elif rules.own:
        wall = wall_of(sizing, shell)
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
    walls = sum(one.volume for one in inner_walls(sizing, wall.thickness)) * material.density
    yield _item("inner walls", walls, "A t ρ across, between stages", "a wall for every bearing plane")
    yield _item("pads", _pads(sizing, wall.thickness, material), "F/(2 D τ) − t on 2 D around bearings", "equilibrium")
    sized = {bearing.name for bearing in sizing.bearings}
    bosses = sum(_boss(item, material) for item in bearings if item.part not in planets | sized)
    outside = bosses_of(sizing, holders_of(sizing))
    bosses += sum(_around(bearing, outside[bearing.name], material) for bearing in sizing.bearings)
    yield _item("bosses", bosses, "wall of 0.12 D around bearings, as wide as covers at least", "estimate")
    webs = sum(carried.volume for carried in carried_bosses(sizing, wall.thickness)) * material.density
    if webs:
        yield _item("webs", webs, "F = Σ k_i (u_i·δ) u_i, σ = N/A + M/W", "webs built in at both ends")
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


def wall_of(sizing: Sizing, shell: Shell) -> Wall:
    """Return the wall of a housing: the larger of what a foundry pours and torques ask, or the given one.

    Args:
        sizing: As sized.
        shell: Around it.

    Source: `casting_wall` by its area, rings that are wall among it; `torque_wall` in the largest section across the
        axis of each torque, at the working stress of the material.
    """
    given = sizing.design.housing.wall
    if given is not None:
        return Wall(given, "the design")
    material = housing_materials()[sizing.design.housing.material]
    asked = [Wall(casting_wall(shell.outside, material.casting), "casting")]
    for way, torque in held_torques(sizing):
        section = shell.section if abs(way.x) > 1.0 - ALONG else section_across(housed(sizing), way)
        asked.append(Wall(torque_wall(torque, section, material.shear_strength), "its torque"))
    return max(asked)


def reaction_items(sizing: Sizing) -> Iterator[MassItem]:
    """Yield what holds the gearbox's torque against its frame, where the design asks for torque arms.

    Args:
        sizing: As sized.

    Source: `torque_arm_volume` at the working stress of the housing's material; the shrink disc by the torque.
    """
    if not sizing.design.housing.own or sizing.design.housing.reaction != "torque-arms":
        return
    material, torque = housing_materials()[sizing.design.housing.material], reaction_torque(sizing)
    arms = torque_arm_volume(torque, material.bending_strength) * material.density
    yield MassItem("torque arms", "reaction", 1, arms, SURE, "6 T ρ/σ", "bending of tapered arms, l = 2 h: estimate")
    disc = SHRINK_DISC * torque
    yield MassItem("shrink disc", "reaction", 1, disc, SURE, "0.35 kg/(kN m) T", "sheets of makers, from memory")


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


def torque_about(sizing: Sizing, torques: Mapping[str, Floats], way: Direction) -> Floats:
    """Return what the housing holds about a direction under many loads, with its sign [N m].

    Args:
        sizing: As sized.
        torques: Machine -> torque on its shaft under each load, shape (n,) [N m].
        way: One of `held_torques`.

    Source: equilibrium of the whole; at least the largest machine, as `held_torques`.
    """
    shafts, frames = sizing.train.machines, sizing.arrangement.frames
    own = [value for name, value in torques.items() if abs(_cosine(way, frames[shafts[name]].along)) > 1.0 - ALONG]
    rows = np.stack([np.sum(own, axis=0), *own])
    return np.asarray(np.take_along_axis(rows, np.argmax(np.abs(rows), axis=0)[None], axis=0)[0])


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
            asked = bearing_wall(bearing.radial_force, seat, material.shear_strength)
            mass += math.pi / 4.0 * 3.0 * seat**2 * max(asked - wall, 0.0) * material.density
    return mass


# ----------------------------------------------------------------------------------------------------------------------
# Oil, and what moves, cleans and cools it: all by the heat that the gearbox makes in the case that speaks for it.
# ----------------------------------------------------------------------------------------------------------------------


HEAT_CAPACITY = 2000.0
"""Of lubricating oil at about 90 °C [J/(kg K)]."""
FILM = 0.02
"""Oil on walls and in mist over the housing's inside [-], an estimate."""
SUMP = 0.10
"""Oil of splash lubrication over the housing's inside [-], an estimate: the lowest gear dips a tooth deep or two."""
SURE_OIL_SYSTEM = 0.5
"""One standard deviation of the oil system over its value, an estimate [-]."""
_LITRE_MIN = 1e-3 / 60.0


class _Rule(NamedTuple):
    """A unit of the oil system: what it weighs at least, and what every litre a minute or kilowatt adds."""

    part: str
    least: float
    """[kg]"""
    per_flow: float
    """[kg/(l/min)]"""
    per_heat: float = 0.0
    """[kg/kW]"""


RULES = (
    _Rule("oil pump", 0.5, 0.10),
    _Rule("oil filter", 0.3, 0.05),
    _Rule("oil cooler", 0.3, 0.0, 0.25),
    _Rule("oil lines and jets", 0.3, 0.05),
)
"""Estimates from data sheets of aircraft units as a class; none of them is one unit's published mass."""


def oil_flow(sizing: Sizing, heat: float) -> float:
    """Return the oil that carries a heat away at the temperature rise of the design [m³/s].

    Args:
        sizing: As sized.
        heat: Of the gearbox [W].

    Source: heat balance, q = P_V/(ρ c ΔT).
    """
    return heat / (sizing.design.oil.density * HEAT_CAPACITY * sizing.design.housing.oil_temperature_rise)


def oil_items(sizing: Sizing, inside: float) -> Iterator[MassItem]:
    """Yield the oil and its units.

    Args:
        sizing: As sized.
        inside: Volume inside the housing [m³].

    Source: heat balance, q = P_V/(ρ c ΔT); the tank holds what the dwell asks.
    """
    rules, oil = sizing.design.housing, sizing.design.oil
    if rules.oil_system == "shared":
        return
    if rules.oil_system == "splash":
        yield MassItem("oil", "lubrication", 1, SUMP * inside * oil.density, SURE_OIL_SYSTEM, "0.1 V ρ", "estimate")
        return
    heat = largest_heat(sizing)
    flow = oil_flow(sizing, heat)
    mass = (flow * rules.oil_dwell + FILM * inside) * oil.density
    yield MassItem("oil", "lubrication", 1, mass, 0.3, "(q t + 0.02 V) ρ, q = P_V/(ρ c ΔT)", "heat balance; estimate")
    for rule in RULES:
        mass = rule.least + rule.per_flow * flow / _LITRE_MIN + rule.per_heat * heat / 1e3
        yield MassItem(rule.part, "lubrication", 1, mass, SURE_OIL_SYSTEM, "m_0 + k q + j P_V", "estimate")


# ----------------------------------------------------------------------------------------------------------------------
# Seals, sensors, drives of accessories, what holds and seals bearings, and the rest that no rule counts.
# ----------------------------------------------------------------------------------------------------------------------


SEAL = 40.0
"""Seal that is not chosen, with its cover, over the square of the shaft's diameter, an estimate [kg/m²]."""
SENSORS = 0.8
"""Chip detector, pressure and temperature sensors with their leads [kg], an estimate."""
PAD = 1.5
"""Pad, gear and bearings of an accessory's drive [kg], an estimate."""
SURE_DETAILS = 0.5
"""One standard deviation of details over their value, an estimate [-]."""
_WHOLE = ("reaction", "lubrication", "details")
"""Groups beside which nothing is left uncounted."""
HELD = 0.2
"""The same of parts that hold bearings, which are sized, an estimate [-]."""


def detail_items(sizing: Sizing, counted: Sequence[MassItem]) -> Iterator[MassItem]:
    """Yield seals, sensors, drives of accessories and the rest.

    Args:
        sizing: As sized.
        counted: Every other part.
    """
    housing = sizing.design.housing
    for leaves in unsealed_exits(sizing):
        yield MassItem(
            f"{leaves.machine} seal", "details", 1, SEAL * leaves.diameter**2, SURE_DETAILS, "40 kg/m² d²", "estimate"
        )
    if housing.oil_system == "own":
        yield MassItem("sensors", "details", 1, SENSORS, SURE_DETAILS, "0.8 kg", "estimate")
    if housing.accessory_drives:
        yield MassItem(
            "accessory drives", "details", housing.accessory_drives, PAD, SURE_DETAILS, "1.5 kg each", "estimate"
        )
    held = {holder.name: holder.mass for holder in holders_of(sizing)}
    for name, mass in held.items():
        yield MassItem(
            name, "details", 1, mass, HELD, "as drawn; nuts: catalogue", "parts that hold bearings and seal shafts"
        )
    share = DETAILS * sum(item.total for item in counted if item.group not in _WHOLE)
    rest = max(share - sum(held.values()), 0.0)
    yield MassItem(
        "fasteners and small parts", "details", 1, rest, SURE_DETAILS, "a share, less what is sized", "estimate"
    )


# ----------------------------------------------------------------------------------------------------------------------
# The verb: what a sized gearbox weighs with everything in it.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def complete_mass(sizing: Sizing) -> CompleteMass:
    """Return the complete mass of a gearbox: gears with teeth and webs, shafts, carriers, bearings, housing, oil.

    Machines are not in it. What the design gives (masses of parts, of the housing, of the whole) stands as given.

    Args:
        sizing: As sized.

    >>> import gearwright as gw
    >>> mass = gw.complete_mass(gw.size(gw.read("off-set")))
    >>> ", ".join(group.group for group in mass.groups)
    'gears, shafts, bearings, housing, lubrication, details'
    """
    whole = sizing.given.get("gearbox.mass")
    if whole is not None:
        item = MassItem("gearbox", "details", 1, whole.value, 0.02, "given", whole.origin or "the design")
        return CompleteMass(sizing.design.name, (item,), 1.0)
    duties = tuple(seat_duties(sizing))
    bores = planet_bores(sizing, duties)
    bearings = tuple(bearing_items(sizing, duties, bores))
    parts = [*gear_items(sizing, bores), *shaft_items(sizing), *carrier_items(sizing), *bearings]
    shell = shell_of(sizing)
    parts += housing_items(sizing, shell, bearings)
    parts += reaction_items(sizing)
    parts += oil_items(sizing, shell.volume)
    parts += detail_items(sizing, parts)
    return CompleteMass(sizing.design.name, ordered(parts), class_of(sizing).scatter)
