"""Gears and meshes of a train whose teeth are chosen: modules, widths, forces, stresses, margins, masses."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

from gearwright.parts.gear_body import disc_inertia, disc_mass, ring_inertia, ring_mass
from gearwright.parts.hertz import contact_stress
from gearwright.parts.lewis import bending_stress_lewis
from gearwright.sizing.rating import Rating, form_factor, modules, rating_of
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.sizing.teeth import groups_of
from gearwright.spec import Design, Pair
from gearwright.spec.overrides import Overrides
from gearwright.train.flow import PowerFlow
from gearwright.train.graph import INTERNAL, Gear, Mesh, Train


class Demand(NamedTuple):
    """What a mesh row asks for at its worst case."""

    case: str
    """That case."""
    per_tooth: float
    """Torque per tooth of one mesh, load factor included [N m]."""
    bending: float
    """Module that bending asks for [m]."""
    contact: float
    """Module that contact asks for [m]."""


@dataclass(frozen=True)
class Context:
    """What every step of gear sizing reads."""

    design: Design
    train: Train
    teeth: Mapping[str, int]
    """Gear -> tooth number [-]."""
    flows: Mapping[str, PowerFlow]
    """Case -> speeds, torques and powers."""
    overrides: Overrides
    ratings: Mapping[str, Rating]
    """Stage -> resolved rules."""
    demands: Mapping[str, Demand]
    """Mesh row -> what it asks for."""


def context(
    design: Design, train: Train, teeth: Mapping[str, int], flows: Mapping[str, PowerFlow], overrides: Overrides
) -> Context:
    """Return what gear sizing reads, with the rules of every stage resolved.

    Args:
        design: The design.
        train: Its graph.
        teeth: Tooth number of every gear.
        flows: Every load case.
        overrides: The user's values.
    """
    ratings = {
        name: rating_of(design.rules(name), helical=isinstance(stage, Pair)) for name, stage in design.stages.items()
    }
    given = Context(design, train, teeth, flows, overrides, ratings, {})
    return replace(given, demands={mesh.name: _demand(given, mesh) for mesh in train.meshes})


def stage_modules(given: Context) -> dict[str, float]:
    """Return the normal module of every stage [m]: the largest that a mesh of its group asks for.

    Args:
        given: What gear sizing reads.
    """
    group = groups_of(given.design)
    needed: dict[str, float] = {}
    for mesh in given.train.meshes:
        owner = group[mesh.stage]
        needed[owner] = max(needed.get(owner, 0.0), *given.demands[mesh.name][2:])
    _align(given, needed, group)
    taken = {owner: given.overrides.take(f"{owner}.module", "length", value) for owner, value in needed.items()}
    return {stage: taken[owner] for stage, owner in group.items()}


def _align(given: Context, needed: dict[str, float], group: Mapping[str, str]) -> None:
    """Raise modules until pairs on the same axes have the larger one's centre distance."""
    for name, pair in given.design.pairs.items():
        if pair.coaxial_with is None:
            continue
        spans = {each: _span(given, each) for each in (name, pair.coaxial_with)}
        distance = max(needed[group[each]] * span for each, span in spans.items())
        for each, span in spans.items():
            needed[group[each]] = distance / span


def _span(given: Context, stage: str) -> float:
    """Return a pair's centre distance over its normal module, (z_1 ± z_2) / (2 cos β) [-]."""
    mesh = next(mesh for mesh in given.train.meshes if mesh.stage == stage)
    one, other = (given.teeth[gear] for gear in mesh.gears)
    return abs(one - mesh.sign * other) / (2.0 * math.cos(given.ratings[stage].helix_angle))


def worst_case(given: Context, mesh: Mesh) -> tuple[str, float]:
    """Return the case that loads a mesh most, and its torque per tooth, load factor included [N m].

    Args:
        given: What gear sizing reads.
        mesh: A row of the train.
    """
    loads = {case: abs(flow.meshes[mesh.name].multiplier) for case, flow in given.flows.items()}
    case = max(loads, key=lambda each: loads[each])
    return case, loads[case] / mesh.count * given.ratings[mesh.stage].load_factor


def _demand(given: Context, mesh: Mesh) -> Demand:
    rating = given.ratings[mesh.stage]
    case, per_tooth = worst_case(given, mesh)
    teeth = (given.teeth[mesh.gears[0]], given.teeth[mesh.gears[1]])
    idler = any(given.train.gear(gear).role == "planet" for gear in mesh.gears)
    bending, contact = modules(per_tooth, teeth, rating, internal=mesh.sign == INTERNAL, idler=idler)
    return Demand(case, per_tooth, float(bending), float(contact))


def size_gears(given: Context, module: Mapping[str, float]) -> tuple[GearSizing, ...]:
    """Return every kind of gear body.

    Args:
        given: What gear sizing reads.
        module: Stage -> normal module [m].
    """
    return tuple(_gear(given, gear, module[gear.stage]) for gear in given.train.gears)


def _gear(given: Context, gear: Gear, module: float) -> GearSizing:
    rating, teeth, take = given.ratings[gear.stage], given.teeth[gear.name], given.overrides.take
    width = take(f"{gear.stage}.face_width", "length", rating.width_ratio * module)
    diameter = module * teeth / math.cos(rating.helix_angle)
    density = rating.material.density
    ring = gear.role == "ring"
    wall = rating.rules.rim_thickness_ratio * module if ring else 0.0
    if ring:
        mass = ring_mass(diameter, wall, width, density=density)
    else:
        mass = disc_mass(diameter, width, density) * (rating.rules.web_ratio if gear.role == "wheel" else 1.0)
    mass = take(f"{gear.name}.mass", "mass", mass)
    inertia = ring_inertia(mass, diameter, wall) if ring else disc_inertia(mass, diameter)
    return GearSizing(
        name=gear.name,
        stage=gear.stage,
        role=gear.role,
        shafts=gear.nodes,
        bodies=gear.bodies,
        teeth=teeth,
        module=module,
        helix_angle=rating.helix_angle,
        face_width=width,
        pitch_diameter=diameter,
        rim=wall,
        mass=mass,
        inertia=take(f"{gear.name}.inertia", "inertia", inertia),
    )


def size_meshes(given: Context, gears: tuple[GearSizing, ...]) -> tuple[MeshSizing, ...]:
    """Return every mesh row at its worst case.

    Args:
        given: What gear sizing reads.
        gears: From `size_gears`.
    """
    by_name = {gear.name: gear for gear in gears}
    return tuple(_mesh(given, mesh, (by_name[mesh.gears[0]], by_name[mesh.gears[1]])) for mesh in given.train.meshes)


def _mesh(given: Context, mesh: Mesh, pair: tuple[GearSizing, GearSizing]) -> MeshSizing:
    rating, (one, other) = given.ratings[mesh.stage], pair
    case, per_tooth, module_bending, module_contact = given.demands[mesh.name]
    internal = mesh.sign == INTERNAL
    width = min(one.face_width, other.face_width)
    force = 2.0 * per_tooth * one.teeth / one.pitch_diameter
    weaker = min(one.teeth, other.teeth)
    bending = bending_stress_lewis(force, width, one.module, form_factor=float(form_factor(weaker, rating)))
    curvature = 2.0 / one.pitch_diameter + (-2.0 if internal else 2.0) / other.pitch_diameter
    contact = contact_stress(
        force, width, curvature, angles=rating.angles, elastic_modulus=rating.material.elastic_modulus
    )
    flow = given.flows[case]
    rolling = abs(flow.speeds[mesh.nodes[0]] - flow.speeds[mesh.nodes[2]])
    idler = "planet" in (one.role, other.role)
    allowable = rating.bending_allowable * (rating.rules.idler_factor if idler else 1.0)
    return MeshSizing(
        name=mesh.name,
        gears=mesh.gears,
        count=mesh.count,
        case=case,
        load_factor=rating.load_factor,
        tangential_force=force,
        radial_force=force * math.tan(rating.rules.pressure_angle) / math.cos(rating.helix_angle),
        axial_force=force * math.tan(rating.helix_angle),
        pitch_line_velocity=rolling * one.pitch_diameter / 2.0,
        module_bending=module_bending,
        module_contact=module_contact,
        bending_stress=bending,
        bending_margin=allowable / bending if bending else math.inf,
        contact_stress=contact,
        contact_margin=rating.contact_allowable / contact if contact else math.inf,
    )
