"""Assemble: a sizing and one of its load cases become a System of absolute rotations.

Every gear, carrier and machine is a body; shafts, clutches and meshes are lines. Planets are bodies of their own, with
the relative mesh phases that their places give. Lines are signed so that what carries power in the case carries it with
a positive force.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal, NamedTuple

from gearwright.catalogue import materials
from gearwright.dynamics.assembly.geometry import add_errors, add_supports, base_radii, body_of, contacts_of
from gearwright.dynamics.assembly.meshes import gear_pairs, mesh_curve
from gearwright.dynamics.assembly.translational import add_stage, with_preload
from gearwright.dynamics.model import (
    ClutchDrive,
    Curve,
    DampingRatio,
    MachineDrive,
    Model,
    Periodic,
    PropellerDrive,
    System,
    points_of,
)
from gearwright.errors import by_name
from gearwright.parts.gears import GearPair
from gearwright.parts.planetary import even_positions, planet_phases
from gearwright.parts.shafts import shaft_diameter, torsional_stiffness
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import MachineSizing, ShaftSizing, Sizing
from gearwright.spec import GROUND, Planetary
from gearwright.train import RATED, Joint, Mesh, PowerFlow
from gearwright.verbs import verb


class Driving(NamedTuple):
    """What drives a train in place of the constant torques of a case."""

    drives: Sequence[PropellerDrive | MachineDrive]
    """Propellers and machines; the ``body`` of each is the machine's name in the design."""
    resistances: Mapping[str, Curve]
    """Shaft -> torque that losses take from it, against its sense [N m]."""
    capacities: Mapping[str, Curve]
    """Clutch -> torque at which it slips [N m]; a clutch that is left out is a shaft."""


@dataclass
class _Assembly:
    """A model under construction and what it is made from."""

    sizing: Sizing
    flow: PowerFlow
    varying: bool
    model: Model = field(default_factory=Model)
    members: dict[str, list[str]] = field(default_factory=dict)
    """Shaft -> bodies on it, in order."""
    inertias: dict[str, tuple[float, float]] = field(default_factory=dict)
    """Body -> inertia [kg m²] and speed [rad/s]."""

    def body(self, name: str, shaft: str, inertia: float, *, speed: float | None = None) -> str:
        """Put a body on a shaft; the ground takes none."""
        if shaft != GROUND:
            self.inertias[name] = (inertia, self.flow.speeds[shaft] if speed is None else speed)
            if speed is None:
                self.members.setdefault(shaft, []).append(name)
        return name

    def add_inertia(self, name: str, inertia: float) -> None:
        """Add a share of a shaft to a body."""
        own, speed = self.inertias[name]
        self.inertias[name] = (own + inertia, speed)


@verb
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
        case: Load case; left out: the design's first one, or ``rated``.
        stiffness: ``"constant"`` or ``"varying"`` mesh stiffness; left out: as the design says.
        driving: Drives in place of the case's torques; the case's speeds stay the reference.

    Raises:
        DesignError: If there is no such case, or a mesh stiffness model does not hold for the gears.

    Source: Pulvirenti 2023, chapter 3, with the corrections of its errata (absolute planet angles, carrier inertia with
        planets, damping by effective mass, ISO 6336-1 mesh stiffness, phases of Parker & Lin 2004).
    """
    case = case or default_case(sizing)
    flow = by_name(case, sizing.flows, "case")
    varying = (stiffness or sizing.design.dynamics.stiffness) == "varying"
    assembly = _Assembly(sizing, flow, varying)
    _bodies(assembly)
    shaft_lines = list(_shaft_lines(assembly, frozenset(driving.capacities) if driving else frozenset()))
    moving = _moving(sizing)
    for name, (inertia, speed) in assembly.inertias.items():
        if name.partition(".")[0] not in moving or name in sizing.design.machines:
            assembly.model.rotation(name, inertia=inertia, speed=speed)
    for stage in moving:
        _add_moving(assembly, stage)
    damping = DampingRatio(sizing.design.dynamics.shaft_damping)
    for name, first, second, value in shaft_lines:
        assembly.model.shaft(name, first, second, stiffness=value, damping=damping)
    for mesh in sizing.train.meshes:
        if mesh.stage not in moving:
            _mesh_lines(assembly, mesh)
    if driving is not None:
        _add_driving(assembly, driving)
    for machine in sizing.machines if driving is None else ():
        torque = assembly.flow.machine_torques.get(machine.name, 0.0)
        if torque:
            assembly.model.load(machine.name if _turns_along(sizing) else _seat(assembly, machine), constant=torque)
    contacts = contacts_of(sizing, assembly.flow)
    add_supports(assembly.model, sizing, contacts, assembly.flow)
    add_errors(assembly.model, contacts, sizing.design.errors)
    return with_preload(assembly.model.build(), sizing, assembly.flow)


def _moving(sizing: Sizing) -> list[str]:
    """Return the planetary sets whose members also move across."""
    return list(sizing.design.planetaries) if sizing.design.dynamics.fidelity == "translational" else []


def _add_moving(assembly: _Assembly, stage: str) -> None:
    pairs = gear_pairs(assembly.sizing)
    inner, outer = (
        (pairs[mesh.name], mesh_curve(assembly.sizing, mesh, pairs[mesh.name], harmonics=_orders(assembly)))
        for end in ("sun-planet", "planet-ring")
        for mesh in assembly.sizing.meshes
        if mesh.name == f"{stage}.{end}"
    )
    inertias = {name: inertia for name, (inertia, _) in assembly.inertias.items()}
    add_stage(assembly.model, assembly.sizing, assembly.flow, stage=stage, inertias=inertias, meshes=(inner, outer))


def _orders(assembly: _Assembly) -> int | None:
    return None if assembly.varying else 0


def _turns_along(sizing: Sizing) -> bool:
    """Tell whether machines are bodies on shafts of their own, or torques on the train."""
    return sizing.design.dynamics.machines == "inertia"


def _seat(assembly: _Assembly, machine: MachineSizing) -> str:
    """Return the body that a machine's shaft joins, or that its torque acts on."""
    members = assembly.members[machine.shaft]
    return members[-1] if machine.kind == "propeller" else members[0]


def default_case(sizing: Sizing) -> str:
    """Return the case that is looked at if none is named: the design's first one, or ``rated``.

    Args:
        sizing: What was sized.
    """
    return next(iter(sizing.design.cases), RATED)


def _bodies(assembly: _Assembly) -> None:
    """Add every gear and carrier to its shaft, in the order of the stages, then the machines."""
    sizing = assembly.sizing
    gears = {gear.name: gear for gear in sizing.gears}
    carriers = {carrier.stage: carrier for carrier in sizing.carriers}
    for name, planetary in sizing.design.planetaries.items():
        planet = gears[f"{name}.planet"]
        carrier = carriers[name]
        # Planets that move on their pins are masses of their own.
        carried = 0.0 if name in _moving(sizing) else planet.bodies * planet.mass * carrier.radius**2
        assembly.body(f"{name}.sun", planetary.sun, gears[f"{name}.sun"].inertia)
        assembly.body(f"{name}.carrier", planetary.carrier, carrier.inertia + carried)
        assembly.body(f"{name}.ring", planetary.ring, gears[f"{name}.ring"].inertia)
        for k in range(planetary.planets):
            speed = assembly.flow.speeds[f"{name}.planet"]
            assembly.body(f"{name}.planet-{k + 1}", f"{name}.planet", planet.inertia, speed=speed)
    for gear in sizing.gears:
        if gear.role in ("pinion", "wheel"):
            for shaft in gear.shafts:
                assembly.body(body_of(sizing, gear.name, shaft), shaft, gear.inertia * gear.bodies / len(gear.shafts))
    for sized in sizing.shafts:
        _share_shaft(assembly, sized)
    for machine in sizing.machines if _turns_along(sizing) else ():
        assembly.inertias[machine.name] = (machine.inertia, assembly.flow.speeds[machine.shaft])


def _share_shaft(assembly: _Assembly, shaft: ShaftSizing) -> None:
    """Give each end of a shaft half of its inertia; a shaft without gears is a body itself."""
    members = assembly.members.setdefault(shaft.name, [])
    if not members:
        assembly.body(f"{shaft.name} hub", shaft.name, shaft.inertia)
        return
    for end in {members[0], members[-1]}:
        assembly.add_inertia(end, shaft.inertia / (1.0 if len(members) == 1 else 2.0))


def _shaft_lines(assembly: _Assembly, slipping: Set[str]) -> Iterator[tuple[str, str, str, float]]:
    """Yield name, ends and stiffness [N m/rad] of every line along a shaft, to a machine or across a clutch."""
    sizing = assembly.sizing
    shafts = {shaft.name: shaft for shaft in sizing.shafts}
    for name, members in assembly.members.items():
        if name not in shafts:
            continue
        pieces = len(members) - 1
        for k, (first, second) in enumerate(pairwise(members)):
            line = f"{name} shaft" if pieces == 1 else f"{name} shaft {k + 1}"
            yield line, first, second, shafts[name].stiffness * pieces
    for machine in sizing.machines if _turns_along(sizing) else ():
        members, end = assembly.members[machine.shaft], _seat(assembly, machine)
        driving = assembly.flow.machine_powers[machine.name] >= 0.0
        ends = (machine.name, end) if driving else (end, machine.name)
        if len(members) == 1 and _only_machine(assembly, machine.shaft):
            yield f"{machine.shaft} shaft", *ends, shafts[machine.shaft].stiffness
        else:
            yield f"{machine.name} shaft", *ends, _stub_stiffness(assembly, machine.torque)
    for joint in sizing.train.joints:
        if joint.name in assembly.flow.joints and joint.name not in slipping:
            yield f"{joint.name} clutch", *_across(assembly, joint)


def _across(assembly: _Assembly, joint: Joint) -> tuple[str, str, float]:
    """Return the bodies that a clutch joins, and its stiffness: that of the softer shaft [N m/rad]."""
    shafts = {shaft.name: shaft.stiffness for shaft in assembly.sizing.shafts}
    softer = min(shafts[joint.driving], shafts[joint.driven])
    return assembly.members[joint.driving][-1], assembly.members[joint.driven][0], softer


def _add_driving(assembly: _Assembly, driving: Driving) -> None:
    """Add drives, losses and slipping clutches in place of a case's torques."""
    model, sizing = assembly.model, assembly.sizing
    for machine in sizing.machines:
        body = machine.name if _turns_along(sizing) else _seat(assembly, machine)
        for drive in driving.drives:
            if drive.body == machine.name:
                model.drive(drive._replace(body=body))
    for shaft, curve in driving.resistances.items():
        sense = -1.0 if assembly.flow.speeds[shaft] >= 0.0 else 1.0
        model.load(assembly.members[shaft][0], schedule=[(time, sense * value) for time, value in points_of(curve)])
    for joint in sizing.train.joints:
        if joint.name in driving.capacities:
            first, second, stiffness = _across(assembly, joint)
            mobility = sum(1.0 / assembly.inertias[name][0] for name in (first, second))
            damping = DampingRatio(sizing.design.dynamics.shaft_damping).damper(stiffness, mobility)
            capacity = driving.capacities[joint.name]
            model.drive(ClutchDrive(joint.name, first, second, stiffness, damping, capacity, joint.overrunning))


def _only_machine(assembly: _Assembly, shaft: str) -> bool:
    return sum(machine.shaft == shaft for machine in assembly.sizing.machines) == 1


def _stub_stiffness(assembly: _Assembly, torque: float) -> float:
    """Return the stiffness of a machine's own shaft, sized by its torque [N m/rad]."""
    rules = assembly.sizing.design.shafting
    material = materials()[rules.material or assembly.sizing.design.gears.material]
    diameter = shaft_diameter(0.0, torque, (material.yield_strength or 0.0) / rules.safety, bore_ratio=rules.bore_ratio)
    return torsional_stiffness(diameter, rules.end_length, material.shear_modulus, bore=rules.bore_ratio * diameter)


def _mesh_lines(assembly: _Assembly, mesh: Mesh) -> None:
    """Add the lines of a row: one per planet, or one for the halves of a double-helical gear."""
    sizing, pairs = assembly.sizing, gear_pairs(assembly.sizing)
    sized = next(each for each in sizing.meshes if each.name == mesh.name)
    pair = pairs[mesh.name]
    curve = mesh_curve(sizing, sized, pair, harmonics=_orders(assembly))
    stage = sizing.design.stages[mesh.stage]
    if isinstance(stage, Planetary):
        phases = _phases(mesh, stage, pairs)
        for k in range(mesh.count):
            _add_line(assembly, mesh, _Tooth(f"{mesh.name}-{k + 1}", k + 1, curve, 1, phases[k]))
    else:
        _add_line(assembly, mesh, _Tooth(mesh.name, 0, curve, mesh.count, _parallel_phase(assembly, mesh)))


@dataclass(frozen=True)
class _Tooth:
    """What one line of a mesh row has of its own."""

    name: str
    planet: int
    curve: StiffnessCurve
    count: int
    phase: float
    """In cycles."""


def _phases(mesh: Mesh, stage: Planetary, pairs: Mapping[str, GearPair]) -> tuple[float, ...]:
    sun_mesh, ring_mesh = pairs[f"{mesh.stage}.sun-planet"], pairs[f"{mesh.stage}.planet-ring"]
    phases = planet_phases(sun_mesh, ring_mesh, even_positions(stage.planets))
    return phases.sun if mesh.name.endswith("sun-planet") else phases.ring


def _parallel_phase(assembly: _Assembly, mesh: Mesh) -> float:
    """Return the phase of a pair behind the first of its parallel ones, by their places around the gear they share.

    A tooth of the shared gear passes the places one after the other, in the sense in which it turns [cycles].
    """
    row = [each for each in assembly.sizing.train.meshes if each.stage == mesh.stage]
    shared = 0 if len({each.nodes[0] for each in row}) == 1 else 1
    angle = cmath.phase(_seen(assembly, mesh, shared) / _seen(assembly, row[0], shared))
    sense = 1.0 if assembly.flow.speeds[mesh.nodes[shared]] >= 0.0 else -1.0
    return (-sense * assembly.sizing.teeth[mesh.gears[shared]] * angle / (2.0 * math.pi)) % 1.0


def _seen(assembly: _Assembly, mesh: Mesh, end: int) -> complex:
    """Return the direction from one axis of a mesh to the other; a face gear's pinion sees opposite ones alike."""
    axes = {shaft.name: complex(*shaft.axis) for shaft in assembly.sizing.shafts}
    return axes[mesh.nodes[1 - end]] - axes[mesh.nodes[end]]


def _add_line(assembly: _Assembly, mesh: Mesh, tooth: _Tooth) -> None:
    """Add δ = r_a (θ_a − θ_c) − s r_b (θ_b − θ_c), signed so that its force is positive in the case."""
    flow, sizing = assembly.flow, assembly.sizing
    sign = -1.0 if flow.meshes[mesh.name].torques[0] > 0.0 else 1.0
    first, second, _ = base_radii(sizing, mesh)
    one, other = sign * first, -sign * mesh.sign * second
    names = _line_bodies(assembly, mesh, tooth.planet)
    weights = {
        name: value
        for name, node, value in zip(names, mesh.nodes, (one, other, -one - other), strict=True)
        if node != GROUND
    }
    mean = tooth.curve.mean
    variation = None
    if tooth.curve.cosine:
        variation = Periodic(
            phase=_tone(assembly, mesh),
            cosine=[value / mean for value in tooth.curve.cosine],
            sine=[value / mean for value in tooth.curve.sine],
            offset=2.0 * math.pi * tooth.phase,
        )
    damping = DampingRatio(sizing.design.dynamics.mesh_damping)
    backlash = sizing.design.stages[mesh.stage].backlash
    assembly.model.mesh(
        tooth.name, weights, stiffness=mean * tooth.count, damping=damping, backlash=backlash, variation=variation
    )


def _line_bodies(assembly: _Assembly, mesh: Mesh, planet: int) -> tuple[str, str, str]:
    """Return the bodies of gear a, gear b and carrier."""
    if planet:
        one, other = (f"{gear}-{planet}" if gear.endswith(".planet") else gear for gear in mesh.gears)
        return one, other, f"{mesh.stage}.carrier"
    one, other = (body_of(assembly.sizing, name, node) for name, node in zip(mesh.gears, mesh.nodes, strict=False))
    return one, other, GROUND


def _tone(assembly: _Assembly, mesh: Mesh) -> dict[str, int]:
    """Return the mesh phase as integers of rotations, growing with time: z (θ − θ_c) of the sun or of gear a."""
    sizing, speeds = assembly.sizing, assembly.flow.speeds
    stage = sizing.design.stages[mesh.stage]
    if isinstance(stage, Planetary):
        gear, node, carrier = f"{mesh.stage}.sun", stage.sun, stage.carrier
        bodies = (gear, f"{mesh.stage}.carrier")
    else:
        gear, node, carrier = mesh.gears[0], mesh.nodes[0], GROUND
        bodies = (_line_bodies(assembly, mesh, 0)[0], GROUND)
    teeth = sizing.teeth[gear] if speeds[node] >= speeds[carrier] else -sizing.teeth[gear]
    counts = {bodies[0]: teeth} if node != GROUND else {}
    if carrier != GROUND:
        counts[bodies[1]] = -teeth
    return counts
