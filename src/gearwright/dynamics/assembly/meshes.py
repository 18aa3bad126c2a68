"""Meshes of a sized design: geometry, mesh stiffness, contact positions and compound planetary stages."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import DesignError, PartId, Problem, Role, Row, SolveError, carrier_part, gear_part
from gearwright.dynamics.model import Carried, Contact, Turns, crossing_axis, face_push_direction, push_direction
from gearwright.parts import Material
from gearwright.parts.gears import CylindricalGear, GearPair, half_angle_at, transverse_pressure_angle
from gearwright.parts.iso6336 import relief_term
from gearwright.parts.planetary import fitting_turns
from gearwright.parts.stiffness import (
    MeshStiffness,
    StiffnessCurve,
    cut_square_wave,
    mesh_curve_iso6336,
    mesh_stiffness_energy,
    mesh_stiffness_iso6336,
    mesh_stiffness_kuang_yang,
    sampled_curve,
)
from gearwright.sizing import GearSizing, MeshSizing, Sizing, cylindrical_gear, pins_of, planet_positions, towards
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.spec import GROUND, Epicyclic, Pair, Planetary
from gearwright.spec.design import MeshCurve
from gearwright.train import INTERNAL, Mesh, PowerFlow

# ----------------------------------------------------------------------------------------------------------------------
# Meshes of a sizing: their geometry, and their stiffness by the model that the design names.
# ----------------------------------------------------------------------------------------------------------------------


_OF_SHAPE = ("profile_shift", "helix_angle", "teeth")
"""Arguments at whose ends a model of stiffness ends, and strain energy does not."""


def gear_pairs(sizing: Sizing) -> dict[str, GearPair]:
    """Return the geometry of every mesh row, one mesh of it, gear a first; of bevel gears the virtual pair.

    Args:
        sizing: What was sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    pairs = {}
    for mesh, row in zip(sizing.meshes, sizing.train.meshes, strict=True):
        stage = sizing.design.stages[mesh.stage]
        first, second = (cylindrical_gear(sizing.design, gears[gear]) for gear in mesh.gears)
        if isinstance(stage, Pair) and stage.kind == "bevel":
            first, second = _virtual(first, second)
        second = replace(second, teeth=-second.teeth) if row.sign == INTERNAL else second
        unmoved = first.profile_shift + second.profile_shift == 0.0
        pairs[mesh.name] = GearPair(first, second, None if unmoved else mesh.centre_distance)
    return pairs


def gear_of(sizing: Sizing, name: str) -> GearSizing:
    """Return a gear by its name.

    Args:
        sizing: What was sized.
        name: Such as ``first.wheel``.
    """
    return next(gear for gear in sizing.gears if gear.name == name)


def _virtual(pinion: CylindricalGear, wheel: CylindricalGear) -> tuple[CylindricalGear, CylindricalGear]:
    """Return Tredgold's cylindrical gears at the mean cone, z/cos δ to whole teeth: for the stiffness of a tooth."""
    slant = math.hypot(pinion.teeth, wheel.teeth)
    virtual_pinion = replace(pinion, teeth=round(pinion.teeth * slant / wheel.teeth))
    return virtual_pinion, replace(wheel, teeth=round(wheel.teeth * slant / pinion.teeth))


def mesh_curve(sizing: Sizing, mesh: MeshSizing, pair: GearPair, *, harmonics: int | None = None) -> StiffnessCurve:
    """Return the stiffness of one mesh of a row along its line of action, by the design's model.

    Args:
        sizing: What was sized.
        mesh: The row at its worst case, whose specific load counts.
        pair: Its geometry.
        harmonics: Of the mesh frequency; 0 gives the mean; left out: as the design says.

    Raises:
        DesignError: If the model does not hold for these gears, with the mesh.
    """
    rules, name = sizing.design.dynamics, mesh.stage
    orders = rules.harmonics if harmonics is None else harmonics
    stated = rules.curves.get(mesh.name) or rules.curves.get(name)
    try:
        curve = _sampled(stated, orders) if stated is not None else _by_model(sizing, mesh, pair, orders)
    except DesignError as error:
        at = f"dynamics.curves.{mesh.name}" if stated is not None else "dynamics.mesh_stiffness"
        fix = "" if stated is not None else _other_model(rules.mesh_stiffness)
        raise DesignError(
            Problem(at, f"{mesh.name}: {problem.message}{fix if problem.path in _OF_SHAPE else ''}")
            for problem in error.problems
        ) from None
    stage = sizing.design.stages[name]
    return _known(curve, stage) if isinstance(stage, Pair) else curve


def variation_left(sizing: Sizing, mesh: MeshSizing, flow: PowerFlow) -> float:
    """Return what tip relief leaves of the variation of a mesh's stiffness in a load case, B_k, at most 1 [-].

    Relief makes up for the deflection of one load, that of K_A and K_γ included; B_k says what is left at another. A
    stated stiffness is taken as it is, and so are teeth whose method of rating knows no relief.

    Args:
        sizing: What was sized.
        mesh: A row of it.
        flow: The load case.

    Source: ISO 6336-1:2006, clause 6.5.5.
    """
    design, rated, stage = sizing.design, mesh.rating, sizing.design.stages[mesh.stage]
    stated = mesh.name in design.dynamics.curves or mesh.stage in design.dynamics.curves
    if (
        stated
        or not isinstance(rated, Iso6336Rating)
        or (isinstance(stage, Pair) and stage.stiffness_swing is not None)
    ):
        return 1.0
    first = gear_of(sizing, mesh.gears[0])
    radius = 0.5 * first.pitch_diameter / first.teeth
    width = min(gear_of(sizing, gear).face_width for gear in mesh.gears)
    load = abs(flow.meshes[mesh.name].multiplier) / mesh.count / radius / width
    load *= design.service.application_factor * mesh.load_factor
    if load <= 0.0:
        return 1.0
    return min(float(relief_term(rated.factors.relief, load, grade=rated.made.grade)), 1.0)


def _other_model(model: str) -> str:
    """Return what a user writes where a model ends at the shape of the teeth."""
    if model == "energy":
        return ""
    return f'; {model!r} ends there: write dynamics.mesh_stiffness = "energy", which follows any shape of the teeth'


def _sampled(stated: MeshCurve, harmonics: int) -> StiffnessCurve:
    phase = 2.0 * math.pi * np.array(stated.phase_cycles)
    return sampled_curve(phase, stated.stiffness_n_m, harmonics=harmonics, source=stated.file or "design")


def stiffness_model(sizing: Sizing, mesh: MeshSizing, pair: GearPair) -> str:
    """Return by which model a mesh is as stiff as it is: strain energy where no model is asked and the usual one ends.

    Args:
        sizing: What was sized.
        mesh: The row at its worst case.
        pair: Its geometry.
    """
    rules = sizing.design.dynamics
    if "mesh_stiffness" in rules.model_fields_set:
        return rules.mesh_stiffness
    try:
        _iso(mesh, pair, _materials(sizing, mesh))
    except DesignError as error:
        if any(problem.path in _OF_SHAPE for problem in error.problems):
            return "energy"
    return rules.mesh_stiffness


def _by_model(sizing: Sizing, mesh: MeshSizing, pair: GearPair, harmonics: int) -> StiffnessCurve:
    made = _materials(sizing, mesh)
    match stiffness_model(sizing, mesh, pair):
        case "energy":
            return mesh_stiffness_energy(pair, materials=made, harmonics=harmonics)
        case "kuang-yang":
            return mesh_stiffness_kuang_yang(pair, harmonics=harmonics, elastic_moduli=_moduli(made))
        case "square-wave":
            wave = cut_square_wave(_iso(mesh, pair, made).mesh * pair.face_width)
            return replace(wave, cosine=wave.cosine[:harmonics], sine=wave.sine[:harmonics])
    return mesh_curve_iso6336(pair, _iso(mesh, pair, made), harmonics=harmonics)


def _materials(sizing: Sizing, mesh: MeshSizing) -> tuple[Material, Material]:
    """Return what both gears are of: that of the stage, with E and ν of the classes that they are rated as."""
    material, rated = sizing.design.gear_material(mesh.stage), mesh.rating
    if not isinstance(rated, Iso6336Rating):
        return material, material
    first, second = (
        replace(material, elastic_modulus=steel.elastic_modulus, poisson_ratio=steel.poisson_ratio)
        for steel in (rated.steel, rated.mate_steel or rated.steel)
    )
    return first, second


def _iso(mesh: MeshSizing, pair: GearPair, made: tuple[Material, Material]) -> MeshStiffness:
    # A mesh that idles in every case has no load; the standard's method asks for some.
    load = max(mesh.tangential_force / pair.face_width, 1.0)
    return mesh_stiffness_iso6336(pair, specific_load=load, elastic_moduli=_moduli(made))


def _moduli(made: tuple[Material, Material]) -> tuple[float, float]:
    return made[0].elastic_modulus, made[1].elastic_modulus


def _known(curve: StiffnessCurve, pair: Pair) -> StiffnessCurve:
    """Return a stiffness curve with what the design gives of it: its mean, its first harmonic."""
    mean = pair.mesh_stiffness or curve.mean
    if pair.stiffness_swing is not None and curve.cosine:
        return StiffnessCurve(mean, (pair.stiffness_swing * mean,), (0.0,), "design")
    if pair.mesh_stiffness is None:
        return curve
    scale = mean / curve.mean
    return StiffnessCurve(mean, tuple(scale * a for a in curve.cosine), tuple(scale * b for b in curve.sine), "design")


# ----------------------------------------------------------------------------------------------------------------------
# Compound sets of a sizing: every planet body of every set, and how their meshes follow each other.
#
# The teeth of a gear pass the places at which it meshes one after the other; what of a cycle lies between two of them
# follows from the angle between them, and from the thickness of a tooth where one is on its other flank.
# ----------------------------------------------------------------------------------------------------------------------


def planet_body(sizing: Sizing, gear: PartId, number: int) -> PartId:
    """Return the body in one set that a planet, or a step of one, is part of.

    Args:
        sizing: What was sized.
        gear: A planet, or a step of one.
        number: Of the set, from 1.
    """
    epicyclic = sizing.design.epicyclics.get(gear.name)
    own = epicyclic.body(gear.own) if epicyclic is not None else ""
    return gear_part(gear.name, Role.PLANET, number=number, own=own)


class PlanetBody(NamedTuple):
    """One planet of one set, all its steps together."""

    part: PartId
    node: str
    """Of the graph, which all sets share."""
    inertia: float
    """About its own axis [kg m²]."""
    mass: float
    """[kg]"""
    place: complex
    """Of its pin, in the frame of the carrier, y + i z [m]."""


def planet_bodies(sizing: Sizing, stage: str) -> Iterator[PlanetBody]:
    """Yield every planet body of a compound set, set by set.

    Args:
        sizing: What was sized.
        stage: Name of the set.
    """
    epicyclic, gears = sizing.design.epicyclics[stage], own_gears(sizing, stage)
    for body, pin in _pins(sizing, stage).items():
        steps = [gears[step] for step in epicyclic.planets if epicyclic.body(step) == body]
        inertia, mass = sum(step.turning_inertia for step in steps), sum(step.turning_mass for step in steps)
        for number in range(epicyclic.sets):
            part = gear_part(stage, Role.PLANET, number=number + 1, own=body)
            turn = cmath.rect(1.0, 2.0 * math.pi * number / epicyclic.sets)
            yield PlanetBody(part, steps[0].shafts[0], inertia, mass, pin * turn)


def own_gears(sizing: Sizing, stage: str) -> dict[str, GearSizing]:
    """Return the gears of a compound set by the design's names.

    Args:
        sizing: What was sized.
        stage: Name of the set.
    """
    return {gear.own: gear for gear in sizing.gears if gear.stage == stage}


def _pins(sizing: Sizing, stage: str) -> dict[str, complex]:
    """Return planet body -> place of its pin in the first set, y + i z [m]."""
    centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes if mesh.stage == stage}
    return pins_of(sizing.design.epicyclics[stage], own_gears(sizing, stage), centres)


def compound_phases(sizing: Sizing, flow: PowerFlow, stage: str) -> dict[str, tuple[float, ...]]:
    """Return mesh row -> phase of its mesh in every set, ahead of the first mesh of its group [cycles].

    Args:
        sizing: What was sized.
        flow: The load case, which says what turns which way, and on which flanks.
        stage: Name of a compound set.

    Source: angles between meshes and the half angle of a tooth, as Parker & Lin 2004, J. Mech. Des. 126, 365-370, for
        sun and ring; from set to set the turn with which a planet fits, z_p ψ, which gives their z_s ψ_n/2π.
    """
    rows = [mesh for mesh in sizing.train.meshes if mesh.stage == stage]
    inside = _within(sizing, flow, stage, rows)
    epicyclic = sizing.design.epicyclics[stage]
    phases: dict[str, list[float]] = {mesh.name: [inside[mesh.name] % 1.0] for mesh in rows}
    for number in range(1, epicyclic.sets):
        turns = fitting_turns(epicyclic.compound, number=number)
        if turns is None:
            raise SolveError(f"{stage}: its planets cannot be assembled")
        for mesh in rows:
            gear = next(sizing.train.gear(name) for name in mesh.gears if sizing.train.gear(name).role is Role.PLANET)
            turned = float(turns[epicyclic.body(gear.own)].first) * sizing.teeth[gear.name]
            phases[mesh.name].append((inside[mesh.name] + _sense(mesh, gear.nodes[0], flow) * turned) % 1.0)
    return {name: tuple(values) for name, values in phases.items()}


def _within(sizing: Sizing, flow: PowerFlow, stage: str, rows: list[Mesh]) -> dict[str, float]:
    """Return mesh row -> its phase in the first set, gears joined by teeth from mesh to mesh [cycles]."""
    known: dict[str, float] = {}
    for _ in rows:
        for mesh in rows:
            if mesh.name in known:
                continue
            beside = [row for row in rows if row.name in known and row.group == mesh.group]
            shared = [(row, gear) for row in beside for gear in row.gears if gear in mesh.gears]
            if shared:
                row, gear = shared[0]
                here, there = (_passed(sizing, flow, stage, place, gear) for place in (mesh, row))
                known[mesh.name] = known[row.name] + here - there
            elif not any(row.group == mesh.group for row in rows if row.name in known):
                known[mesh.name] = 0.0
    return known


def _passed(sizing: Sizing, flow: PowerFlow, stage: str, mesh: Mesh, gear: str) -> float:
    """Return by what part of a cycle a gear's contact in a mesh runs ahead of a tooth's middle at angle 0 [cycles]."""
    epicyclic, end = sizing.design.epicyclics[stage], mesh.gears.index(gear)
    body, mate = (sizing.train.gear(mesh.gears[k]).own for k in (end, 1 - end))
    sense = _sense(mesh, mesh.nodes[end], flow)
    angle = sense * cmath.phase(towards(epicyclic, _pins(sizing, stage), body, mate))
    pair = gear_pairs(sizing)[mesh.name]
    tooth = (pair.driver, pair.driven)[end]
    half = half_angle_at(tooth, tooth.base_radius / math.cos(pair.working_pressure_angle))
    first_drives = flow.meshes[mesh.name].torques[0] * _sense(mesh, mesh.nodes[0], flow) < 0.0
    drives = first_drives == (end == 0)  # in a mesh that idles, too, one gear drives and one is driven
    return sizing.teeth[gear] * ((half if drives else -half) - angle) / (2.0 * math.pi)


def _sense(mesh: Mesh, node: str, flow: PowerFlow) -> float:
    """Return the sense in which a node turns beside the carrier of a mesh, ±1."""
    return -1.0 if flow.speeds[node] < flow.speeds[mesh.nodes[2]] else 1.0


def set_directions(sizing: Sizing, mesh: Mesh) -> Iterator[tuple[int, complex, Mapping[int, complex]]]:
    """Yield for every set its number, the direction from gear a's axis to its pitch point, and where its planets stand.

    Args:
        sizing: What was sized.
        mesh: A row of a compound set.
    """
    epicyclic, pins = sizing.design.epicyclics[mesh.stage], _pins(sizing, mesh.stage)
    first, second = (sizing.train.gear(name).own for name in mesh.gears)
    direction = towards(epicyclic, pins, first, second)
    places = {
        end: pins[epicyclic.body(own)] / abs(pins[epicyclic.body(own)])
        for end, own in enumerate((first, second))
        if own in epicyclic.planets
    }
    for number in range(epicyclic.sets):
        turn = cmath.rect(1.0, 2.0 * math.pi * number / epicyclic.sets)
        yield number + 1, direction * turn, {end: place * turn for end, place in places.items()}


# ----------------------------------------------------------------------------------------------------------------------
# Contacts of a sizing: where every mesh stands in space, and on which flanks it carries.
#
# The frame of a shaft with a sun, a ring or a carrier is that of its planetary set's carrier.
# ----------------------------------------------------------------------------------------------------------------------


def contacts_of(sizing: Sizing, flow: PowerFlow) -> tuple[Contact, ...]:
    """Return every mesh of a sizing as a contact, on the flanks that carry in a load case.

    Args:
        sizing: What was sized.
        flow: The load case.

    Raises:
        DesignError: If the pinion of a face gear lies neither along y nor along z.
    """
    contacts: list[Contact] = []
    for mesh in sizing.train.meshes:
        stage = sizing.design.stages[mesh.stage]
        if isinstance(stage, Epicyclic):
            contacts += _compound(sizing, flow, mesh, stage)
        elif isinstance(stage, Planetary):
            contacts += _planets(sizing, flow, mesh, stage)
        else:
            contacts.append(_pair(sizing, flow, mesh))
    return tuple(contacts)


def bodies_of(sizing: Sizing) -> dict[str, PartId]:
    """Return every body that teeth or pins move, by its name.

    Args:
        sizing: What was sized.
    """
    gears = [gear.body(shaft) for gear in sizing.gears if gear.role is not Role.PLANET for shaft in gear.shafts]
    for stage, planetary in sizing.design.planetaries.items():
        gears += [gear_part(stage, Role.PLANET, number=number + 1) for number in range(planetary.planets)]
        gears.append(carrier_part(stage))
    for stage in sizing.design.epicyclics:
        gears += [*(planet.part for planet in planet_bodies(sizing, stage)), carrier_part(stage)]
    return {str(part): part for part in gears}


def push_sense(flow: PowerFlow, row: str) -> Literal[1, -1]:
    """Return the sense in which gear a of a mesh row pushes: against the torque that the mesh puts on it.

    Args:
        flow: The load case.
        row: Name of the mesh row.
    """
    return -1 if flow.meshes[row].torques[0] > 0.0 else 1


class BaseCircles(NamedTuple):
    """Base circles of a mesh."""

    first: float
    """Base radius of gear a [m]."""
    second: float
    """Base radius of gear b [m]."""
    pressure_angle: float
    """Working transverse pressure angle α_wt [rad]."""


def base_circles(sizing: Sizing, mesh: Mesh) -> BaseCircles:
    """Return the base circles of a mesh; of bevel gears at the mean cone.

    Args:
        sizing: What was sized.
        mesh: A row of its train.

    Source: ISO 21771:2007, r_b = d/2 cos α_t, at the working angle α_wt, with tan α_t = tan α_n / cos β.
    """
    gears = [gear_of(sizing, name) for name in mesh.gears]
    angle = transverse_pressure_angle(sizing.design.rules(mesh.stage).pressure_angle, gears[0].helix_angle)
    first, second = (gear.pitch_diameter / 2.0 * math.cos(angle) for gear in gears)
    working = next(row for row in sizing.meshes if row.name == mesh.name).working_pressure_angle
    return BaseCircles(first, second, working)


def _first_body(sizing: Sizing, shaft: str) -> str:
    """Return the body whose rotation stands for a shaft's, so that its errors are one tone."""
    for stage in (*sizing.design.sets, *sizing.design.pairs):
        for gear in sizing.gears:
            if gear.stage == stage and shaft in gear.shafts:
                return str(gear.body(shaft))
        if stage in sizing.design.sets and sizing.design.sets[stage].carrier == shaft:
            return str(carrier_part(stage))
    return ""


def _pair(sizing: Sizing, flow: PowerFlow, mesh: Mesh) -> Contact:
    circles, sense = base_circles(sizing, mesh), push_sense(flow, mesh.name)
    towards = direction_between(sizing, mesh.nodes[0], mesh.nodes[1])
    face = isinstance(stage := sizing.design.stages[mesh.stage], Pair) and stage.kind == "face"
    axis = crossing_axis(towards) if face else "x"
    if axis is None:
        message = "a face gear stands along y or z from its pinion; give 0, 90, 180 or -90"
        raise DesignError([Problem(f"layout.{mesh.nodes[1]}.angle_deg", message)])
    if face:
        direction = face_push_direction(towards, circles.pressure_angle, sense=sense)
    else:
        outwards = -towards if mesh.sign == INTERNAL else towards
        direction = push_direction(outwards, circles.pressure_angle, sense=sense)
    sides = (
        _carried(sizing, mesh, 0, lever=sense * circles.first, axis=axis),
        _carried(sizing, mesh, 1, lever=-mesh.sign * sense * circles.second, axis="x"),
    )
    return Contact(mesh.name, direction, sides)


def direction_between(sizing: Sizing, shaft: str, to: str) -> complex:
    """Return the vector from one shaft's axis to another's, y + i z [m].

    Args:
        sizing: What was sized.
        shaft: From whose axis.
        to: To whose axis.
    """
    return sizing.arrangement.axes[to] - sizing.arrangement.axes[shaft]


def _carried(sizing: Sizing, mesh: Mesh, end: int, *, lever: float, axis: str) -> Carried:
    shaft = mesh.nodes[end]
    turns = {_first_body(sizing, shaft): 1} if shaft != GROUND else {}
    return Carried(str(gear_of(sizing, mesh.gears[end]).body(shaft)), shaft, lever, turns, turns, {}, axis)


def _planets(sizing: Sizing, flow: PowerFlow, mesh: Mesh, stage: Planetary) -> Iterator[Contact]:
    circles, sense, at_sun = base_circles(sizing, mesh), push_sense(flow, mesh.name), mesh.row is Row.SUN_PLANET
    frame = {str(carrier_part(mesh.stage)): -1} if stage.carrier != GROUND else {}
    for k, position in enumerate(planet_positions(sizing.design, mesh.stage, sizing.teeth), start=1):
        towards = complex(math.cos(position), math.sin(position))
        planet = str(gear_part(mesh.stage, Role.PLANET, number=k))
        role, shaft = (Role.SUN, stage.sun) if at_sun else (Role.RING, stage.ring)
        member = str(gear_part(mesh.stage, role))
        turns: Turns = {member: 1, **frame} if shaft != GROUND else frame
        central = Carried(member, shaft, 0.0, turns, turns, frame)
        carried = Carried(planet, stage.carrier, 0.0, {planet: 1, **frame}, {}, frame, "x", towards)
        first, second = (central, carried) if at_sun else (carried, central)
        sides = (
            first._replace(lever=sense * circles.first),
            second._replace(lever=-mesh.sign * sense * circles.second),
        )
        yield Contact(
            str(mesh.part._replace(number=k)), push_direction(towards, circles.pressure_angle, sense=sense), sides
        )


def _compound(sizing: Sizing, flow: PowerFlow, mesh: Mesh, stage: Epicyclic) -> Iterator[Contact]:
    """Yield the contacts of a row of a compound set, one for each set, in the frame of the carrier."""
    circles, sense = base_circles(sizing, mesh), push_sense(flow, mesh.name)
    frame: Turns = {str(carrier_part(mesh.stage)): -1} if stage.carrier != GROUND else {}
    levers = (sense * circles.first, -mesh.sign * sense * circles.second)
    for number, direction, places in set_directions(sizing, mesh):
        sides = []
        for end, (gear, node) in enumerate(zip(mesh.gears, mesh.nodes, strict=False)):
            part = sizing.train.gear(gear).part
            if end in places:
                planet = str(planet_body(sizing, part, number))
                turns: Turns = {planet: 1, **frame}
                side = Carried(planet, stage.carrier, levers[end], turns, {}, frame, "x", places[end])
            else:
                turns = {str(part): 1, **frame} if node != GROUND else frame
                side = Carried(str(part), node, levers[end], turns, turns, frame)
            sides.append(side)
        push = push_direction(direction, circles.pressure_angle, sense=sense)
        yield Contact(str(mesh.part._replace(number=number)), push, (sides[0], sides[1]))
