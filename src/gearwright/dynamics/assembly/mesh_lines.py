"""Mesh connections of a sized design: manufacturing errors, tooth friction, translating planetary stages."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from gearwright.dynamics.assembly.bodies import Assembly
from gearwright.dynamics.assembly.meshes import base_circles, direction_between, gear_of, planet_body, push_sense
from gearwright.dynamics.model import (
    Contact,
    DampingRatio,
    Entries,
    Line,
    Member,
    Model,
    Owner,
    Periodic,
    PlanetarySet,
    System,
    add_planetary,
    contact_errors,
)
from gearwright.errors import Problem, near, refuse
from gearwright.identity import MEMBERS, Kind, PartId, Role, Row, carrier_part, gear_part, member_part, mesh_part
from gearwright.parts.planetary import planet_phases
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import CarrierSizing, GearSizing, Sizing, planet_positions, play_in_motion
from gearwright.spec import GROUND, Epicyclic, Pair, Planetary
from gearwright.spec.design import PartErrors
from gearwright.train import Mesh, PowerFlow

# ----------------------------------------------------------------------------------------------------------------------
# Lines of the meshes whose gears only turn: one per planet, or one for the halves of a double-helical gear.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Teeth:
    """What one line of a mesh row has of its own."""

    line: PartId
    curve: StiffnessCurve
    planet: int
    """Counted from 1; 0 without planets."""
    count: int
    """Meshes side by side in it."""
    phase: float
    """In cycles."""


def add_mesh_row(assembly: Assembly, mesh: Mesh) -> None:
    """Add the lines of a mesh row, in their relative mesh phases.

    Args:
        assembly: With all bodies.
        mesh: The row.
    """
    stage, curve = assembly.sizing.design.stages[mesh.stage], assembly.curve(mesh.name)
    if isinstance(stage, Planetary):
        inner, outer = (assembly.pairs[str(mesh_part(mesh.stage, row))] for row in (Row.SUN_PLANET, Row.PLANET_RING))
        phases = planet_phases(
            inner, outer, planet_positions(assembly.sizing.design, mesh.stage, assembly.sizing.teeth)
        )
        for k, phase in enumerate(phases.sun if mesh.row is Row.SUN_PLANET else phases.ring, start=1):
            _add_line(assembly, mesh, _Teeth(mesh.part._replace(number=k), curve, k, 1, phase))
    elif isinstance(stage, Epicyclic):
        for k, phase in enumerate(assembly.compound_phases(mesh.stage)[mesh.name], start=1):
            _add_line(assembly, mesh, _Teeth(mesh.part._replace(number=k), curve, k, 1, phase))
    else:
        _add_line(assembly, mesh, _Teeth(mesh.part, curve, 0, mesh.count, _parallel_phase(assembly, mesh)))


def _parallel_phase(assembly: Assembly, mesh: Mesh) -> float:
    """Return the phase of a pair behind the first of its parallel ones, by their places around the gear they share.

    A tooth of the shared gear passes the places one after the other, in the sense in which it turns [cycles].
    """
    row = [parallel for parallel in assembly.sizing.train.meshes if parallel.stage == mesh.stage]
    shared = 0 if len({parallel.nodes[0] for parallel in row}) == 1 else 1
    seen, first = (
        direction_between(assembly.sizing, pair.nodes[shared], pair.nodes[1 - shared]) for pair in (mesh, row[0])
    )
    angle = cmath.phase(seen / first)
    sense = 1.0 if assembly.flow.speeds[mesh.nodes[shared]] >= 0.0 else -1.0
    return (-sense * assembly.sizing.teeth[mesh.gears[shared]] * angle / (2.0 * math.pi)) % 1.0


def _add_line(assembly: Assembly, mesh: Mesh, teeth: _Teeth) -> None:
    """Add δ = r_a (θ_a − θ_c) − s r_b (θ_b − θ_c), signed so that its force is positive in the case."""
    design, curve = assembly.sizing.design, teeth.curve
    sense, circles = push_sense(assembly.flow, mesh.name), base_circles(assembly.sizing, mesh)
    first, second = sense * circles.first, -sense * mesh.sign * circles.second
    bodies = mesh_bodies(assembly, mesh, teeth.planet)
    weights = {
        body: weight
        for body, node, weight in zip(bodies, mesh.nodes, (first, second, -first - second), strict=True)
        if node != GROUND
    }
    variation = None
    if curve.cosine:
        variation = Periodic(
            phase=mesh_phase(assembly, mesh),
            cosine=[value / curve.mean for value in curve.cosine],
            sine=[value / curve.mean for value in curve.sine],
            offset=2.0 * math.pi * teeth.phase,
        )
    assembly.model.mesh(
        str(teeth.line),
        weights,
        stiffness=curve.mean * teeth.count,
        damping=DampingRatio(design.dynamics.mesh_damping),
        backlash=play_in_motion(assembly.sizing, mesh.name),
        variation=variation,
        owner=Owner(teeth.line),
    )


def mesh_bodies(assembly: Assembly, mesh: Mesh, planet: int) -> tuple[str, str, str]:
    """Return the bodies of gear a, gear b and carrier.

    Args:
        assembly: With all bodies.
        mesh: A row.
        planet: Counted from 1; 0 without planets.
    """
    if planet:
        gears = [assembly.sizing.train.gear(gear).part for gear in mesh.gears]
        first, second = (
            planet_body(assembly.sizing, part, planet) if part.role is Role.PLANET else part for part in gears
        )
        return str(first), str(second), str(carrier_part(mesh.stage))
    first, second = (
        gear_of(assembly.sizing, gear).body(shaft) for gear, shaft in zip(mesh.gears, mesh.nodes, strict=False)
    )
    return str(first), str(second), GROUND


def mesh_phase(assembly: Assembly, mesh: Mesh) -> dict[str, int]:
    """Return the mesh phase as integers of rotations, growing with time: z (θ − θ_c) of the sun or of gear a.

    Args:
        assembly: With all bodies.
        mesh: The row.
    """
    sizing, speeds = assembly.sizing, assembly.flow.speeds
    stage = sizing.design.stages[mesh.stage]
    if isinstance(stage, Planetary):
        gear, node, carrier = str(gear_part(mesh.stage, Role.SUN)), stage.sun, stage.carrier
        bodies = (gear, str(carrier_part(mesh.stage)))
    elif isinstance(stage, Epicyclic):
        gear, node, carrier = mesh.gears[0], mesh.nodes[0], stage.carrier
        first, _, third = mesh_bodies(assembly, mesh, 1)
        bodies = (first, third)
    else:
        gear, node, carrier = mesh.gears[0], mesh.nodes[0], GROUND
        bodies = (mesh_bodies(assembly, mesh, 0)[0], GROUND)
    teeth = sizing.teeth[gear] if speeds[node] >= speeds[carrier] else -sizing.teeth[gear]
    counts = {bodies[0]: teeth} if node != GROUND else {}
    if carrier != GROUND:
        counts[bodies[1]] = -teeth
    return counts


# ----------------------------------------------------------------------------------------------------------------------
# Errors of gears and shafts, as each mesh of a model feels them.
# ----------------------------------------------------------------------------------------------------------------------


def add_errors(model: Model, contacts: tuple[Contact, ...], parts: Mapping[str, PartErrors]) -> None:
    """Give every mesh the errors of its gears and shafts.

    Args:
        model: With every mesh as a line.
        contacts: From `contacts_of`.
        parts: Gear body, shaft or planet -> its errors.

    Raises:
        DesignError: If a part does not exist, or a clocking angle at which teeth do not go together.
    """
    refuse(_unknown(contacts, parts))
    by_line = {contact.line: contact for contact in contacts}
    refuse(
        problem for line in model.lines if line.name in by_line for problem in _jams(line, by_line[line.name], parts)
    )
    for number, line in enumerate(model.lines):
        if line.name in by_line:
            model.lines[number] = replace(line, errors=(*line.errors, *contact_errors(by_line[line.name], parts)))


def _unknown(contacts: tuple[Contact, ...], parts: Mapping[str, PartErrors]) -> Iterator[Problem]:
    known = {name for contact in contacts for side in contact.sides for name in (side.gear, side.shaft)} - {GROUND}
    for name in parts:
        if name not in known:
            yield Problem(f"errors.{name}", f"there is no such gear, shaft or planet; {near(name, known)}")


def _jams(line: Line, contact: Contact, parts: Mapping[str, PartErrors]) -> Iterator[Problem]:
    """Yield clocking angles at which the teeth of a mesh with backlash do not go together."""
    for side in contact.sides:
        moved = abs(side.lever * parts[side.gear].clocking) if side.gear in parts else 0.0
        if moved > line.backlash > 0.0:
            largest = math.degrees(line.backlash / abs(side.lever))
            message = (
                f"it moves the teeth of {line.name} by {moved * 1e6:.4g} µm, more than their backlash of "
                f"{line.backlash * 1e6:.4g} µm, so they do not go together; give at most {largest:.4g} deg"
            )
            yield Problem(f"errors.{side.gear}.clocking", message)


# ----------------------------------------------------------------------------------------------------------------------
# Torques of the friction of teeth in a case, as loads: with them the model stands where the flow with losses does.
#
# A mesh line puts its force on both gears in the ratio of their teeth. What the driven gear receives less, and the
# carrier bears, is a constant load on them, of the size that it has in the case.
# ----------------------------------------------------------------------------------------------------------------------


SLIGHT = 1e-12
"""Part of a mesh's torque below which what is lost of it is rounding [-]."""


def add_friction(assembly: Assembly) -> None:
    """Load every gear and carrier with what the friction of its teeth takes or gives in the case.

    Args:
        assembly: With all bodies.

    Source: power flow with losses: the driven gear receives η of what the driving one gives, relative to the carrier.
    """
    for mesh in assembly.sizing.train.meshes:
        for node, torque in _lost(assembly, mesh).items():
            bodies = _on(assembly, mesh, node)
            for body in bodies:
                assembly.model.load(body, constant=torque / len(bodies))


def _lost(assembly: Assembly, mesh: Mesh) -> dict[str, float]:
    """Return node -> torque on it beside that of a mesh line [N m], of all equal meshes of a row; only what is some."""
    flow, (first, second) = assembly.flow.meshes[mesh.name], (assembly.sizing.teeth[gear] for gear in mesh.gears)
    turned = flow.multiplier * first, -mesh.sign * flow.multiplier * second
    line = (*turned, -sum(turned))
    return {
        node: torque - without
        for node, torque, without in zip(mesh.nodes, flow.torques, line, strict=True)
        if node != GROUND and abs(torque - without) > SLIGHT * max(map(abs, line))
    }


def _on(assembly: Assembly, mesh: Mesh, node: str) -> list[str]:
    """Return the bodies of a mesh row on a node: one, or a planet of every set."""
    pair = isinstance(assembly.sizing.design.stages[mesh.stage], Pair)
    return list(dict.fromkeys(_bodies(assembly, mesh, node, (0,) if pair else range(1, mesh.count + 1))))


def _bodies(assembly: Assembly, mesh: Mesh, node: str, planets: tuple[int, ...] | range) -> Iterator[str]:
    for planet in planets:
        yield mesh_bodies(assembly, mesh, planet)[mesh.nodes.index(node)]


# ----------------------------------------------------------------------------------------------------------------------
# Planetary sets of a sizing whose members also move across, on bearings that give way.
# ----------------------------------------------------------------------------------------------------------------------


def add_moving_set(assembly: Assembly, stage: str) -> None:
    """Add a planetary set with translations, in the frame of its carrier.

    Args:
        assembly: That gets it; its carrier is without planets.
        stage: Name of the set.

    Source: Lin & Parker 1999, J. Vib. Acoust. 121, 316-321.
    """
    planetary, flow = assembly.sizing.design.planetaries[stage], assembly.flow
    shafts = {str(member): getattr(planetary, member) for member in MEMBERS}
    speeds = {name: flow.speeds[shaft] for name, shaft in shafts.items() if shaft != GROUND}
    add_planetary(assembly.model, _planetary_set(assembly, stage), name=stage, speeds=speeds)


def _planetary_set(assembly: Assembly, stage: str) -> PlanetarySet:
    rows = tuple(str(mesh_part(stage, row)) for row in (Row.SUN_PLANET, Row.PLANET_RING))
    inner, outer = (assembly.pairs[row] for row in rows)
    places = planet_positions(assembly.sizing.design, stage, assembly.sizing.teeth)
    return PlanetarySet(
        *_members(assembly, stage),
        sun_mesh=assembly.curve(rows[0]),
        ring_mesh=assembly.curve(rows[1]),
        pressure_angles=(inner.working_pressure_angle, outer.working_pressure_angle),
        positions=places,
        sun_teeth=inner.driver.teeth,
        phases=planet_phases(inner, outer, places),
        damping=assembly.sizing.design.dynamics.mesh_damping,
        backlash=(play_in_motion(assembly.sizing, rows[0]), play_in_motion(assembly.sizing, rows[1])),
        flank=push_sense(assembly.flow, rows[0]),
    )


def _members(assembly: Assembly, stage: str) -> tuple[Member, Member, Member, Member]:
    """Return sun, ring, carrier and one planet; what is part of the ground and rigid has no motion."""
    sizing, planetary = assembly.sizing, assembly.sizing.design.planetaries[stage]
    inner, outer = (assembly.pairs[str(mesh_part(stage, row))] for row in (Row.SUN_PLANET, Row.PLANET_RING))
    gears: dict[Role | Kind, GearSizing] = {gear.role: gear for gear in sizing.gears if gear.stage == stage}
    mass = {role: gear.turning_mass for role, gear in gears.items()} | {Kind.CARRIER: _carrier(sizing, stage).mass}
    radii = (inner.driver.base_radius, outer.driven.base_radius, inner.centre_distance)
    radius: dict[Role | Kind, float] = dict(zip(MEMBERS, radii, strict=True))

    def member(role: Role | Kind) -> Member:
        # A member that stands still is no body of the train; a ring that does gives way as itself.
        standing = gears[role].inertia if role in gears else 1.0
        rotor = assembly.rotors.get(str(member_part(stage, role)))
        support, torsion = _support(planetary, role), _torsion(planetary, role, radius[role])
        return Member(mass[role], rotor.inertia if rotor else standing, radius[role], support=support, torsion=torsion)

    pin = math.inf if "pin" in planetary.bearings.rigid else pin_stiffness(sizing, stage)
    planet = Member(mass[Role.PLANET], gears[Role.PLANET].turning_inertia, inner.driven.base_radius, support=pin)
    return member(Role.SUN), member(Role.RING), member(Kind.CARRIER), planet


def _carrier(sizing: Sizing, stage: str) -> CarrierSizing:
    return next(carrier for carrier in sizing.carriers if carrier.stage == stage)


def _planet(sizing: Sizing, stage: str) -> GearSizing:
    return gear_of(sizing, str(gear_part(stage, Role.PLANET)))


def pin_stiffness(sizing: Sizing, stage: str) -> float:
    """Return the stiffness of a planet's pin [N/m]: as the design says, or of the sized pin without its bearing.

    Args:
        sizing: What was sized.
        stage: Name of the planetary set.

    Source: cantilever of round section of the shafts' steel, its force at the middle of the planet, k = 3 E I/(b/2)³.
    """
    stated = sizing.design.planetaries[stage].bearings.pin
    if stated is not None:
        return stated
    width, diameter = _planet(sizing, stage).face_width, _carrier(sizing, stage).pin_diameter
    modulus = sizing.design.shaft_material.elastic_modulus
    return 3.0 * modulus * math.pi / 64.0 * diameter**4 / (0.5 * width) ** 3


def _support(planetary: Planetary, name: Role | Kind) -> float:
    grounded = name is not Role.RING and getattr(planetary, name) == GROUND
    return math.inf if grounded or name in planetary.bearings.rigid else float(getattr(planetary.bearings, name))


def _torsion(planetary: Planetary, name: Role | Kind, radius: float) -> float:
    if getattr(planetary, name) != GROUND:
        return 0.0
    if name is Role.RING and name.value not in planetary.bearings.rigid:
        return planetary.bearings.ring_tangential * radius**2
    return math.inf


def with_preload(system: System, sizing: Sizing, flow: PowerFlow) -> System:
    """Return a system whose planets' centrifugal preload turns with the carrier.

    Written in the carrier's frame, a rotation of a whole set would otherwise drive itself: the centripetal term of the
    planets' tangential motion η has no counterpart. As the preloaded pins turn by θ, m Ω² η² becomes m Ω² (η − r θ)²,
    and a rotation of the whole is free again. Entries for η are there; those with θ are added.

    Args:
        system: As assembled.
        sizing: What was sized.
        flow: The load case.

    Source: potential of isotropic springs between pins and planets under centrifugal load, to second order in the
        displacements and first order in m Ω² over the pin's stiffness.
    """
    names, old = system.labels.coordinates, system.arrays.centripetal
    rows, columns, values = list[int](), list[int](), list[float]()
    for stage, planetary in sizing.design.planetaries.items():
        carrier, speed = str(carrier_part(stage)), flow.speeds[planetary.carrier]
        paths = [f"{gear_part(stage, Role.PLANET, number=k + 1)}.tangential" for k in range(planetary.planets)]
        if paths[0] not in names or carrier not in names:
            continue
        radius, turn = _carrier(sizing, stage).radius, names.index(carrier)
        pull = _planet(sizing, stage).turning_mass * speed**2 * radius
        for along in map(names.index, paths):
            rows += [along, turn, turn]
            columns += [turn, along, turn]
            values += [-pull, -pull, pull * radius]
    added = Entries(np.array(rows, np.int64), np.array(columns, np.int64), np.array(values))
    entries = Entries(*(np.append(*parts) for parts in zip(old, added, strict=True)))
    return replace(system, arrays=system.arrays._replace(centripetal=entries))
