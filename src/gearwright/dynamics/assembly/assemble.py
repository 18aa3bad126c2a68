"""Dynamic model of a sized design in one load case, its excitation orders and its assumptions."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import (
    MEMBERS,
    SIDES,
    Kind,
    PartId,
    Problem,
    Role,
    Row,
    by_name,
    carrier_part,
    gear_part,
    member_part,
    mesh_part,
    near,
    one_blas_thread,
    refuse,
    text,
    verb,
)
from gearwright.dynamics.assembly.bodies import (
    Assembly,
    add_bodies,
    add_supports,
    brakes,
    clutch_line,
    link_ends,
    shaft_lines,
)
from gearwright.dynamics.assembly.meshes import (
    base_circles,
    contacts_of,
    direction_between,
    gear_of,
    gear_pairs,
    planet_body,
    push_sense,
    stiffness_model,
)
from gearwright.dynamics.model import (
    ClutchDrive,
    Contact,
    Curve,
    DampingRatio,
    Entries,
    Line,
    MachineDrive,
    Member,
    Model,
    Owner,
    Periodic,
    PlanetarySet,
    PropellerDrive,
    System,
    add_planetary,
    contact_errors,
    points_of,
)
from gearwright.parts.planetary import planet_phases
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import CarrierSizing, GearSizing, Sizing, governing_case, planet_positions, play_in_motion
from gearwright.spec import GROUND, Airscrew, ElectricMachine, Epicyclic, Machine, Pair, Planetary, Record, quantity_of
from gearwright.spec.checks import table_of
from gearwright.spec.design import DynamicsRules, PartErrors
from gearwright.train import INTERNAL, Mesh, PowerFlow

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

    Source: round section of the shafts' steel: of one plate a cantilever, its force at the middle of the planet,
        k = 3 E I/(b/2)³; of two plates a beam on supports L = b + t apart with its force all along, k = 384 E I/(5 L³).
    """
    stated = sizing.design.planetaries[stage].bearings.pin
    if stated is not None:
        return stated
    width, carrier = _planet(sizing, stage).face_width, _carrier(sizing, stage)
    inertia = math.pi / 64.0 * (carrier.pin_diameter**4 - (carrier.pin_bore or 0.0) ** 4)
    bent = sizing.design.shaft_material.elastic_modulus * inertia
    if carrier.free_plate is not None:
        return 384.0 / 5.0 * bent / (width + carrier.free_plate) ** 3
    return 3.0 * bent / (0.5 * width) ** 3


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


# ----------------------------------------------------------------------------------------------------------------------
# Orders of a sized train that no line makes: blades, poles and slots of its machines, teeth and planets that pass.
#
# Each is so many times in a turn of some shafts, with the reason; it says what it shakes, not how hard.
# ----------------------------------------------------------------------------------------------------------------------


class _Times(NamedTuple):
    """How often in a turn, and why."""

    what: str
    times: float
    why: str


def add_orders(assembly: Assembly) -> None:
    """Add the orders of every machine, and those of teeth and planets that pass.

    Args:
        assembly: With all bodies and meshes.
    """
    design = assembly.sizing.design
    for sized in assembly.sizing.machines:
        body = assembly.loaded_body(sized)
        owner = Owner(PartId(Kind.MACHINE, sized.name))
        for order in _machine_orders(design.machines[sized.name]):
            name = f"{sized.name} {order.what}"
            assembly.model.order(name, {body: order.times}, on=[body], why=order.why, owner=owner)
    for mesh in assembly.sizing.train.meshes:
        _add_hunting(assembly, mesh)
        stage = design.stages[mesh.stage]
        if isinstance(stage, Pair):
            _add_sidebands_of_turning(assembly, mesh)
        elif mesh.sign == INTERNAL:
            _add_planet_pass(assembly, mesh)


def untold_orders(sizing: Sizing) -> Iterator[tuple[str, str]]:
    """Yield each electric machine whose orders are left out, and what to give for them.

    Args:
        sizing: What was sized.
    """
    for name, machine in sizing.design.machines.items():
        if isinstance(machine, ElectricMachine):
            missing = [field for field in ("poles", "slots") if getattr(machine, field) is None]
            if missing:
                yield name, f"none of the electric kind: give {' and '.join(missing)} of {name}"


def _machine_orders(machine: Machine) -> Iterator[_Times]:
    """Yield how often a machine acts in a turn of its shaft.

    Source: counting: blades, pairs of poles and slots that pass in a turn; three phases ripple at six times the
        electrical frequency, poles and slots face each other alike lcm(poles, slots) times in a turn.
    """
    yield _Times("1P", 1.0, "once per turn")
    if isinstance(machine, Airscrew):
        yield _Times("blade pass", float(machine.blades), f"{machine.blades} blades")
        yield _Times("twice blade pass", 2.0 * machine.blades, f"2 × {machine.blades} blades")
    elif isinstance(machine, ElectricMachine):
        yield from _electric_orders(machine.poles, machine.slots)


def _electric_orders(poles: int | None, slots: int | None) -> Iterator[_Times]:
    if poles is not None:
        yield _Times("electrical", 0.5 * poles, f"{poles} poles")
        yield _Times("twice electrical", 1.0 * poles, f"{poles} poles, unequal phases")
        yield _Times("six times electrical", 3.0 * poles, f"{poles} poles, ripple of three phases")
    if slots is not None:
        yield _Times("slots", float(slots), f"{slots} slots")
    if poles is not None and slots is not None and math.lcm(poles, slots) != slots:
        yield _Times("cogging", float(math.lcm(poles, slots)), f"lcm of {poles} poles and {slots} slots")


def _add_hunting(assembly: Assembly, mesh: Mesh) -> None:
    """Add the frequency at which the same two teeth meet, unless a gear turns as often.

    Source: counting: every lcm(z_a, z_b) teeth, so the mesh frequency over it.
    """
    first, second = (assembly.sizing.teeth[gear] for gear in mesh.gears)
    together = math.lcm(first, second)
    if together > max(first, second):
        turns = {body: teeth / together for body, teeth in mesh_phase(assembly, mesh).items()}
        why = f"the same teeth of {first} and {second} meet"
        _add(assembly, mesh, f"{mesh.name} hunting tooth", turns, why=why)


def _add_sidebands_of_turning(assembly: Assembly, mesh: Mesh) -> None:
    """Add the mesh frequency less and plus a turn of each gear of a pair."""
    phase = mesh_phase(assembly, mesh)
    for side, node in zip(SIDES, mesh.nodes, strict=False):
        if node != GROUND:
            _add_sidebands(assembly, mesh, phase, {_body(assembly, node): 1.0}, name=f"{side} turn")


def _add_planet_pass(assembly: Assembly, mesh: Mesh) -> None:
    """Add how often planets pass a place of their ring, and the sidebands that it gives the mesh.

    Source: McFadden & Smith 1985, Proc. Inst. Mech. Eng. C 199, 65-70.
    """
    _, ring, carrier = mesh.nodes
    turns = {}
    if carrier != GROUND:
        turns[_body(assembly, carrier)] = float(mesh.count)
    if ring != GROUND:
        turns[_body(assembly, ring)] = -float(mesh.count)
    _add(assembly, mesh, f"{_short(assembly, mesh)} planet pass", turns, why=f"{mesh.count} planets")
    _add_sidebands(assembly, mesh, mesh_phase(assembly, mesh), turns, name="planet pass")


def _add_sidebands(
    assembly: Assembly, mesh: Mesh, phase: Mapping[str, float], turns: Mapping[str, float], *, name: str
) -> None:
    for sign, word in ((-1.0, "less"), (1.0, "plus")):
        both = {body: phase.get(body, 0.0) + sign * turns.get(body, 0.0) for body in {**phase, **turns}}
        _add(assembly, mesh, f"{_short(assembly, mesh)} mesh {word} {name}", both, why=f"mesh modulated by {name}")


def _add(assembly: Assembly, mesh: Mesh, name: str, turns: Mapping[str, float], *, why: str) -> None:
    """Add an order that shakes the first mesh of a row; what stands still, as all members do, is left out."""
    lines = [line.name for line in assembly.model.lines if line.owner.part and line.owner.part.is_of(mesh.part)]
    if any(turns.values()):
        assembly.model.order(name, turns, on=lines[:1], why=why, owner=Owner(mesh.part))


def _short(assembly: Assembly, mesh: Mesh) -> str:
    """Return the stage of a row, where no other row of it has the same orders, or else the row."""
    alike = [row for row in assembly.sizing.train.meshes if (row.stage, row.row) == (mesh.stage, mesh.row)]
    return mesh.stage if len(alike) == 1 else mesh.name


def _body(assembly: Assembly, node: str) -> str:
    return assembly.members[node][0]


# ----------------------------------------------------------------------------------------------------------------------
# Assemble: a sizing and one of its load cases become a System of absolute rotations.
#
# Every gear, carrier and machine is a body; shafts, clutches, dampers and meshes are lines. Planets are bodies of their
# own, with the relative mesh phases that their places give. Lines are signed so that what carries power in the case
# carries it with a positive force.
# ----------------------------------------------------------------------------------------------------------------------


class Driving(NamedTuple):
    """What drives a train in place of the constant torques of a case."""

    drives: Sequence[PropellerDrive | MachineDrive]
    """Propellers and machines; the ``body`` of each is the machine's name in the design."""
    resistances: Mapping[str, Curve]
    """Shaft -> torque that losses take from it, against its sense [N m]."""
    capacities: Mapping[str, Curve]
    """Clutch -> torque at which it slips [N m]; a clutch that is left out is a shaft."""
    carried: Mapping[str, float] = MappingProxyType({})
    """Clutch -> torque that it carries at the start [N m]; 0 where it is left out."""


@verb
@one_blas_thread()
def assemble(
    sizing: Sizing,
    case: str | None = None,
    *,
    stiffness: Literal["constant", "varying"] | None = None,
    driving: Driving | None = None,
) -> System:
    """Return the drive train of a sizing as bodies and lines.

    Args:
        sizing: What was sized.
        case: Load case; left out: the governing one, which has the least margin.
        stiffness: ``"constant"`` or ``"varying"`` mesh stiffness; left out: as the design says.
        driving: Drives in place of the case's torques; the case's speeds stay the reference.

    Raises:
        DesignError: If there is no such case, or a mesh stiffness model does not hold for the gears.

    Source: Pulvirenti 2023, chapter 3, with the corrections of its errata (absolute planet angles, carrier inertia with
        planets, damping by effective mass, ISO 6336-1 mesh stiffness, phases of Parker & Lin 2004).
    """
    flow = by_name(case or governing_case(sizing), sizing.flows, "case")
    varying = (stiffness or sizing.design.dynamics.stiffness) == "varying"
    assembly = Assembly(sizing, flow, harmonics=None if varying else 0)
    model = assembly.model
    add_bodies(assembly)
    for name, rotor in assembly.rotors.items():
        if rotor.part.kind not in (Kind.GEAR, Kind.CARRIER) or rotor.part.name not in assembly.moving:
            model.rotation(name, inertia=rotor.inertia, speed=rotor.speed, owner=Owner(rotor.part))
    for stage in assembly.moving:
        add_moving_set(assembly, stage)
    damping = DampingRatio(sizing.design.dynamics.shaft_damping)
    for line in shaft_lines(assembly, driving.capacities.keys() if driving else frozenset()):
        model.shaft(
            line.name, line.first, line.second, stiffness=line.stiffness, damping=damping, owner=Owner(line.part)
        )
    for brake in brakes(assembly):
        model.support(brake.name, brake.body, stiffness=brake.stiffness, damping=damping, owner=Owner(brake.part))
    for damper in sizing.train.dampers:
        owner = Owner(PartId(Kind.DAMPER, damper.name))
        model.damper(f"{damper.name} damper", *link_ends(assembly, damper), damping=damper.damping, owner=owner)
    for mesh in sizing.train.meshes:
        if mesh.stage not in assembly.moving:
            add_mesh_row(assembly, mesh)
    add_orders(assembly)
    if driving is None:
        _add_torques(assembly)
        add_friction(assembly)
    else:
        _add_driving(assembly, driving)
    contacts = contacts_of(sizing, flow)
    add_supports(model, sizing, contacts, flow)
    add_errors(model, contacts, sizing.design.errors)
    return with_preload(model.build(), sizing, flow)


def loaded_bodies(sizing: Sizing, case: str | None = None) -> dict[str, str]:
    """Return machine → body of the assembled train that feels its torque.

    Args:
        sizing: What was sized.
        case: As in `assemble`.
    """
    assembly = Assembly(sizing, by_name(case or governing_case(sizing), sizing.flows, "case"), harmonics=0)
    add_bodies(assembly)
    return {machine.name: assembly.loaded_body(machine) for machine in sizing.machines}


def _add_torques(assembly: Assembly) -> None:
    for machine in assembly.sizing.machines:
        torque = assembly.flow.machine_torques.get(machine.name, 0.0)
        if torque:
            assembly.model.load(assembly.loaded_body(machine), constant=torque)


def _add_driving(assembly: Assembly, driving: Driving) -> None:
    """Add drives, losses and slipping clutches in place of a case's torques."""
    model, sizing = assembly.model, assembly.sizing
    for machine in sizing.machines:
        for drive in driving.drives:
            if drive.body == machine.name:
                model.drive(drive._replace(body=assembly.loaded_body(machine)))
    for shaft, curve in driving.resistances.items():
        sense = -1.0 if assembly.flow.speeds[shaft] >= 0.0 else 1.0
        model.load(assembly.members[shaft][0], schedule=[(time, sense * value) for time, value in points_of(curve)])
    for joint in sizing.train.joints:
        if joint.name in driving.capacities:
            _, _, first, second, stiffness = clutch_line(assembly, joint)
            mobility = sum(1.0 / assembly.rotors[name].inertia for name in (first, second))
            damping = DampingRatio(sizing.design.dynamics.shaft_damping).damper(stiffness, mobility)
            capacity = driving.capacities[joint.name]
            carried = driving.carried.get(joint.name, 0.0)
            model.drive(
                ClutchDrive(joint.name, first, second, stiffness, damping, capacity, joint.overrunning, carried)
            )


# ----------------------------------------------------------------------------------------------------------------------
# Assumptions: what a simulation of a sizing rests on that nobody measured, with its value and where it is from.
# ----------------------------------------------------------------------------------------------------------------------


Source = Literal["given", "default", "computed"]
_MEMBER = {"ring_tangential": "ring"}
"""Field of a set's bearings -> the member that it holds, where it is not called so."""


@dataclass(frozen=True)
class Assumption:
    """One thing that the dynamic model takes for granted."""

    subject: str
    """What it is about."""
    value: str
    """With its unit."""
    origin: Source
    """``"given"`` in the design file, its ``"default"``, or ``"computed"`` from the sizing."""
    path: str
    """Entry of the design file that changes it; empty where none does."""


def assumptions(sizing: Sizing, system: System) -> tuple[Assumption, ...]:
    """Return what a simulation rests on, in the order in which a reader asks.

    Args:
        sizing: What was sized.
        system: Assembled from it.
    """
    return (
        *_rules(sizing.design.dynamics),
        *_curves(sizing),
        *_backlash(sizing),
        *_bearings(sizing),
        *_inertias(sizing),
        *(Assumption(f"orders of {name}", words, "default", "") for name, words in untold_orders(sizing)),
        *_model(sizing, system),
    )


def _origin(record: Record, name: str) -> Source:
    return "given" if name in record.model_fields_set else "default"


def _rules(rules: DynamicsRules) -> Iterator[Assumption]:
    subjects = {
        "fidelity": "motions of planetary sets",
        "mesh_stiffness": "mesh stiffness model",
        "stiffness": "mesh stiffness over the mesh cycle",
        "harmonics": "harmonics of the mesh frequency kept",
        "mesh_damping": "damping ratio of meshes and bearings ζ",
        "shaft_damping": "damping ratio of shafts ζ",
        "machines": "machines in the model",
    }
    for name, subject in subjects.items():
        if name != "harmonics" or rules.stiffness == "varying":
            yield Assumption(subject, str(getattr(rules, name)), _origin(rules, name), f"dynamics.{name}")


def _curves(sizing: Sizing) -> Iterator[Assumption]:
    for mesh, curve in sizing.design.dynamics.curves.items():
        words = curve.file or f"{len(curve.phase_cycles)} points"
        yield Assumption(f"stiffness of {mesh}", words, "given", f"dynamics.curves.{mesh}")
    stated, pairs = sizing.design.dynamics, gear_pairs(sizing)
    for row in sizing.meshes:
        if row.name in stated.curves or row.stage in stated.curves:
            continue
        if (model := stiffness_model(sizing, row, pairs[row.name])) != stated.mesh_stiffness:
            words = f"{model}: its teeth are beyond those that {stated.mesh_stiffness} is for"
            yield Assumption(f"stiffness of {row.name}", words, "default", "dynamics.mesh_stiffness")


def _backlash(sizing: Sizing) -> Iterator[Assumption]:
    for name, stage in sizing.design.stages.items():
        plays = {mesh.name: play_in_motion(sizing, mesh.name) for mesh in sizing.meshes if mesh.stage == name}
        given, path = "backlash" in stage.model_fields_set, f"{sizing.design.table(name)}.backlash_um"
        if given or not any(plays.values()):
            words = f"{stage.backlash * 1e6:.4g} µm" if stage.backlash else "none: teeth stay in contact both ways"
            yield Assumption(f"backlash of {name}", words, _origin(stage, "backlash"), path)
            continue
        for mesh, play in plays.items():
            yield Assumption(f"backlash of {mesh}", f"{play * 1e6:.4g} µm, the mean of its fits", "computed", path)


def _bearings(sizing: Sizing) -> Iterator[Assumption]:
    if sizing.design.dynamics.fidelity == "rotational":
        if not sizing.design.supports:
            yield Assumption("bearings and pins", "rigid", "default", "dynamics.fidelity")
        return
    for name, planetary in sizing.design.planetaries.items():
        bearings = planetary.bearings
        for field, info in type(bearings).model_fields.items():
            quantity, path = quantity_of(info), f"planetaries.{name}.bearings.{field}"
            member = _MEMBER.get(field, field)
            if quantity is None or (field == "ring_tangential" and planetary.ring != GROUND):
                continue
            if member in bearings.rigid or (getattr(planetary, member, "") == "ground" and member != "ring"):
                yield Assumption(f"bearing of {name}.{field}", "rigid", "given", path)
                continue
            value = pin_stiffness(sizing, name) if field == "pin" else getattr(bearings, field)
            origin: Source = "computed" if field == "pin" and bearings.pin is None else _origin(bearings, field)
            words = text(value, quantity.dimension) if value else "none: floats"
            yield Assumption(f"bearing of {name}.{field}".replace("_", " "), words, origin, f"{path}_n_um")


def _inertias(sizing: Sizing) -> Iterator[Assumption]:
    for machine in sizing.machines:
        table = table_of(machine.name, sizing.design)
        origin: Source = "given" if machine.inertia_is_given else "computed" if machine.inertia else "default"
        path = f"{table}.{machine.name}.inertia_kg_m2"
        words = text(machine.inertia, "inertia") if machine.inertia else "none: not stated"
        yield Assumption(f"inertia of {machine.name}", words, origin, path)


def _model(sizing: Sizing, system: System) -> Iterator[Assumption]:
    arrays = system.arrays
    speed_dependent = np.any(arrays.loads.damping) or np.any(arrays.loads.quadratic)
    words = "depends on speed" if speed_dependent else "constant: does not change with speed"
    yield Assumption("torque of machines", words, "default", "")
    with_errors = bool(sizing.design.errors) or bool(np.any(arrays.error.cosine) or np.any(arrays.error.sine))
    errors: tuple[str, Source] = ("as the design states", "given") if with_errors else ("none: as drawn", "default")
    yield Assumption("errors of gears and shafts", *errors, "errors")
    yield Assumption("flanks", "no profile modification, contact along the whole width", "default", "")
    yield Assumption("shafts across sets and pairs", "coupled in rotation alone", "default", "")
