"""What carries, encloses and cools the gears of a stage: estimates for arrays of sizes, to rank them by."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.catalogue import STEEL_DENSITY, STEEL_SHARE, bored_mass, loaded_mass, rating_for
from gearwright.catalogue.materials import HousingMaterial, housing_materials
from gearwright.parts.bearings import BearingKind
from gearwright.parts.carriers import Plate, first_carrier_mass
from gearwright.parts.housings import CastingRule, casting_wall, torque_wall
from gearwright.parts.losses import windage_power
from gearwright.spec import GROUND, Design, Pair, Planetary, case_named
from gearwright.train import INTERNAL, Mesh, PowerFlow, Train, gears_of

# ----------------------------------------------------------------------------------------------------------------------
# What the parts around the gears of a stage are estimated from, beside their sizes.
# ----------------------------------------------------------------------------------------------------------------------


class Turned(NamedTuple):
    """A load case as the losses of a stage see it."""

    powers: tuple[float, ...]
    """What the teeth of each row pass on [W]."""
    speeds: tuple[float, ...]
    """Of each kind of gear [rad/s]."""


class Casing(NamedTuple):
    """Of what a housing is made, and what it holds."""

    density: float
    """[kg/m³]"""
    wall: CastingRule
    """How thick its walls are poured; of a given wall that one, whatever their area."""
    torque: float
    """That it holds, which may ask for a thicker one [N m]; 0 where the wall is given."""
    shear: float
    """Working shear stress of its material [Pa]."""
    hubs: float
    """What shafts and plates of a set add to its depth [m]."""


class GearSeat(NamedTuple):
    """A kind of gears of a pair as what holds its shafts sees it."""

    place: int
    """Of the kind [-]."""
    bodies: int
    """Equal ones [-]."""
    torque: float
    """On one of them, of one mesh [N m]."""
    push: float
    """Force on its shaft over that along its circle [-]; 0 where those of several mates cancel, about."""
    per_force: float
    """Both bearings with their bosses by their load, over the power 1.5 of the force on the gear [kg/N^1.5]."""


class ShaftBasis(NamedTuple):
    """What holds the gears of a pair: shafts in two bearings each."""

    seats: tuple[GearSeat, ...]
    per_bore: float
    """Both bearings with their bosses at least, over the cube of the shaft's diameter [kg/m³]."""
    allowable: float
    """Stress of shafts [Pa]."""
    density: float
    """Of shafts [kg/m³]."""
    end: float
    """What a shaft is longer than its gear on each side, and the width of a bearing [m]."""


class MassBasis(NamedTuple):
    """What the parts around the gears of a stage are estimated from."""

    gears: tuple[str, ...]
    """Names of its kinds of gears: sun, planet, ring; pinion, wheel."""
    bodies: tuple[int, ...]
    """Equal ones of each [-]."""
    rows: tuple[tuple[int, int, int], ...]
    """Places of both gears of each row, and its sign: +1 internal."""
    lean: float
    """Helix angle [rad]."""
    cases: tuple[Turned, ...]
    """That last."""
    carried: tuple[tuple[float, float], ...] = ()
    """Torque [N m], without K_γ, and speed [rad/s] of the carrier of a simple set in every case."""
    plate: Plate | None = None
    """Of that carrier; None of pairs and of compound sets."""
    bell: float = 0.0
    """Disc by which a ring turns a shaft, over the square of its diameter [kg/m²]; 0 of a ring that is held."""
    casing: Casing | None = None
    """None: no housing of its own."""
    per_heat: float = 0.0
    """Oil, pump, lines, filter and cooler over the power that is lost [kg/W]."""
    held: ShaftBasis | None = None
    """Of pairs, whose meshes bend their shafts."""


def around_stage(name: str, design: Design, train: Train, flows: Mapping[str, PowerFlow], lean: float) -> MassBasis:
    """Return what the parts around the gears of a stage are estimated from.

    Args:
        name: Of the stage.
        design: As read.
        train: Its graph.
        flows: Every load case.
        lean: Helix angle of its teeth [rad].
    """
    stage, rows = design.stages[name], [mesh for mesh in train.meshes if mesh.stage == name]
    names = gears_of(name, stage)
    gears = [train.gear(gear) for gear in names]
    lasting = [flow for case, flow in flows.items() if not case_named(design, case).static]
    cases = tuple(
        Turned(tuple(_power(flow, mesh) for mesh in rows), tuple(_speed(flow, gear.nodes[0]) for gear in gears))
        for flow in lasting
    )
    places = tuple((names.index(mesh.gears[0]), names.index(mesh.gears[1]), mesh.sign) for mesh in rows)
    found = MassBasis(
        names, tuple(gear.bodies for gear in gears), places, lean, cases,
        casing=_casing(design, lasting[0] if lasting else next(iter(flows.values()))), per_heat=_per_heat(design),
    )  # fmt: skip
    if isinstance(stage, Pair):
        found = found._replace(held=_held(design, train, rows, names, lasting))
    steel, carriers = design.shaft_material, design.carriers
    bell = 0.0
    if any(gear.name in train.internal and gear.nodes[0] != GROUND for gear in gears):
        bell = math.pi / 4.0 * steel.density * BELL
    if not isinstance(stage, Planetary):
        return found._replace(bell=bell)
    carried = tuple(
        (abs(sum(flow.meshes[mesh.name].torques[2] for mesh in rows)), _speed(flow, stage.carrier))
        for flow in flows.values()
    )
    allowable = (steel.yield_strength or math.inf) / carriers.safety
    plate = Plate(allowable, steel.density, carriers.plate_ratio, carriers.fill, turns=stage.carrier != GROUND)
    return found._replace(bell=bell, carried=carried, plate=plate)


def _power(flow: PowerFlow, mesh: Mesh) -> float:
    rolling = _speed(flow, mesh.nodes[0], signed=True) - _speed(flow, mesh.nodes[2], signed=True)
    return abs(flow.meshes[mesh.name].torques[0] * rolling)


def _speed(flow: PowerFlow, node: str, *, signed: bool = False) -> float:
    speed = flow.speeds.get(node, 0.0)
    return speed if signed else abs(speed)


def _casing(design: Design, flow: PowerFlow) -> Casing | None:
    """Return what a housing is made of, and the torque that it holds in the case that speaks for the design."""
    rules = design.housing
    if not rules.own or rules.mass is not None:
        return None
    material, torques = housing_materials()[rules.material], list(flow.machine_torques.values())
    torque = max(abs(sum(torques)), *map(abs, torques))
    hubs = HUBS * math.cbrt(torque)
    if rules.wall is not None:
        given = CastingRule(rules.wall, 0.0, rules.wall, rules.wall)
        return Casing(material.density, given, 0.0, material.shear_strength, hubs)
    return Casing(material.density, material.casting, torque, material.shear_strength, hubs)


def _held(
    design: Design, train: Train, rows: Sequence[Mesh], names: Sequence[str], lasting: Sequence[PowerFlow]
) -> ShaftBasis | None:
    """Return what holds the gears of a pair, in the case that speaks for the design."""
    if not lasting:
        return None
    flow, rules, service = lasting[0], design.shafting, design.service
    boss = 1.0 + (boss_share(housing_materials()[design.housing.material]) if design.housing.own else 0.0)
    seats = dict[str, GearSeat]()
    for mesh in rows:
        for side, name in enumerate(mesh.gears):
            gear = train.gear(name)
            rating = rating_for(0.5 * service.mean_load, service.bearing_life, _speed(flow, gear.nodes[0]))
            torque = abs(flow.meshes[mesh.name].torques[side]) / mesh.count
            mates = sum(row.count for row in rows if name in row.gears) / gear.bodies
            push = PUSH if mates < 2.0 else 0.0
            seats[name] = GearSeat(names.index(name), gear.bodies, torque, push, 2.0 * boss * loaded_mass(rating))
    allowable = (design.shaft_material.yield_strength or math.inf) / rules.safety
    return ShaftBasis(
        tuple(seats.values()),
        2.0 * boss * bored_mass(1.0),
        allowable,
        design.shaft_material.density,
        rules.bearing_length,
    )


def boss_share(material: HousingMaterial) -> float:
    """Return what the boss around a bearing weighs over it [-].

    Args:
        material: Of the housing.

    Source: bosses as `mass.complete` has them: 0.12 D thick and 0.25 D wide around light series, d = D/1.6, B = 0.2 D.
    """
    steel = STEEL_SHARE[BearingKind.CYLINDRICAL] * STEEL_DENSITY * (1.0 - 1.0 / 1.6**2) * 0.2
    return (1.24**2 - 1.0) * 0.25 * material.density / steel


def _per_heat(design: Design) -> float:
    rules = design.housing
    if rules.oil_system != "own":
        return 0.0
    flow = 1.0 / (HEAT_CAPACITY * rules.oil_temperature_rise)
    return flow * (rules.oil_dwell + UNITS) + COOLER


# ----------------------------------------------------------------------------------------------------------------------
# Carrier, bell and housing; what the oil that carries the heat away weighs with all that moves and cools it.
#
# The complete mass of a sized gearbox has all of it from the bodies that stand there (`mass`); constants here are
# those of that, or fitted to it over gearboxes at random.
# ----------------------------------------------------------------------------------------------------------------------


BELL = 3e-3
"""Thickness of the disc by which a ring turns its shaft [m], the least."""
RIBBED = 1.3
"""Shell with its ribs and mounts over the shell [-]."""
FLANGES = 2.1
"""Flanges with bolts over the girth of a housing [kg/m]."""
DEEP, LONG = 1.3, 1.6
"""Depth of a housing over the face width of a pair, and over that of a set with the plates of its carrier [-]."""
HUBS = 5.5e-3
"""What shafts add to the depth around a set, over the cube root of the torque that the housing holds [m/(N m)^⅓]."""
PUSH = 1.064
"""Force on a gear over that along its circle [-]: at α = 20°."""
HEAT_CAPACITY = 2000.0
"""Of lubricating oil [J/(kg K)]."""
UNITS = 12.6
"""Pump, filter, lines over the flow of oil [s]: 0.2 kg for every litre a minute."""
COOLER = 2.5e-4
"""Cooler over the power that it takes [kg/W]."""
RUBBING = 0.08
"""Part of its power that a mesh loses, over 1/z_1 ± 1/z_2 [-]."""
MIST = 5.324e-3
"""Dynamic viscosity of a warm turbine oil, of whose mist windage comes [Pa s]."""


def around_mass(
    around: MassBasis, teeth: Sequence[Floats], modules: Floats, widths: Floats, *, planet: Floats, planets: int,
    factor: float,
) -> Floats:  # fmt: skip
    """Return about what carries and encloses the gears of sizes of a stage weighs [kg].

    Args:
        around: The stage.
        teeth: Of its kinds of gears [-].
        modules: m_n [m].
        widths: b [m].
        planet: Mass of one planet [kg]; of pairs not read.
        planets: Their number; of pairs not read [-].
        factor: K_γ [-].
    """
    transverse = modules / math.cos(around.lean)
    rings = [teeth[second] for _, second, sign in around.rows if sign == INTERNAL]
    widest = np.maximum.reduce(rings or list(teeth)) * transverse
    mass = np.zeros(np.broadcast_shapes(widest.shape, np.shape(widths)))
    if rings:
        mass = mass + around.bell * widest**2
    if around.plate is not None and around.carried:
        sun, own, ring = (z * modules / 2.0 for z in teeth)
        mass = mass + first_carrier_mass(
            [(factor * torque, speed) for torque, speed in around.carried], sun + own, widths,
            (sun + modules, own + modules, ring - modules), planet=planet, planets=planets, plate=around.plate,
        )  # fmt: skip
    if around.held is not None:
        mass = mass + held_mass(around.held, [z * transverse / 2.0 for z in teeth], widths)
    if around.casing is not None:
        length = widest if rings else (teeth[0] + teeth[1]) * transverse
        depth = LONG * widths + around.casing.hubs if rings else DEEP * widths
        mass = mass + housing_mass(around.casing, length, widest, depth)
    return np.asarray(mass)


def held_mass(held: ShaftBasis, radii: Sequence[Floats], widths: Floats) -> Floats:
    """Return about what shafts of a pair weigh beside its gears, with their bearings and the bosses around these [kg].

    Args:
        held: What holds them.
        radii: Of the kinds of gears [m].
        widths: b [m].

    Source: a force in the middle, F/2 on each bearing, M = F (b + e)/4; L_10 = (C/P)^(10/3), m = max((C/c)^1.5, k d³).
    """
    mass = np.zeros(np.broadcast_shapes(np.shape(radii[0]), np.shape(widths)))
    for seat in held.seats:
        force = seat.push * seat.torque / radii[seat.place]
        moment = force * (widths + held.end) / 4.0
        cube = 32.0 / (math.pi * held.allowable) * np.hypot(moment, seat.torque)
        shaft = held.density * math.pi / 4.0 * np.cbrt(cube) ** 2 * (2.0 * held.end + widths)
        bearings = np.maximum(seat.per_force * force**1.5, held.per_bore * cube)
        mass = mass + seat.bodies * (bearings + shaft)
    return np.asarray(mass)


def housing_mass(casing: Casing, length: Floats, breadth: Floats, depth: Floats) -> Floats:
    """Return about what a housing weighs whose walls go round two circles [kg].

    Args:
        casing: Of what it is made.
        length: Over both circles [m].
        breadth: Diameter of the larger [m].
        depth: Along the axes [m].

    Source: shell, A t ρ, with t by casting or by Bredt's shear flow, τ = T/(2 A t); flanges of one girth.
    """
    section = breadth * (length - (1.0 - math.pi / 4.0) * breadth)
    girth = 2.0 * (length - breadth) + math.pi * breadth
    area = 2.0 * section + girth * depth
    wall = np.maximum(casting_wall(area, casing.wall), torque_wall(casing.torque, section, casing.shear))
    return np.asarray(RIBBED * casing.density * wall * area + FLANGES * girth)


def oil_mass(
    around: MassBasis, teeth: Sequence[Floats], modules: Floats, widths: Floats, *, planets: int = 0
) -> Floats:
    """Return about what oil weighs that carries away what the gears of a stage lose, with what moves and cools it [kg].

    Args:
        around: The stage.
        teeth: Of its kinds of gears [-].
        modules: m_n [m].
        widths: b [m].
        planets: Number of planets; 0: as the stage has them [-].

    Source: mesh losses, P (1/z_1 ± 1/z_2); windage, `windage_power`.
    """
    if not around.per_heat:
        return np.zeros(np.broadcast_shapes(np.shape(modules), np.shape(widths)))
    radii = [z * modules / (2.0 * math.cos(around.lean)) for z in teeth]
    heats = list[Floats]()
    for case in around.cases:
        heat = np.zeros(np.broadcast_shapes(np.shape(radii[0]), np.shape(widths)))
        for power, (first, second, sign) in zip(case.powers, around.rows, strict=True):
            heat = heat + RUBBING * power * np.abs(1.0 / teeth[first] - sign / teeth[second])
        for place, (radius, speed) in enumerate(zip(radii, case.speeds, strict=True)):
            if speed:
                count = planets if planets and place == 1 else around.bodies[place]
                heat = heat + count * windage_power(radius, widths, speed, viscosity=MIST)
        heats.append(heat)
    return np.asarray(around.per_heat * np.maximum.reduce(heats)) if heats else np.zeros(np.shape(widths))
