"""Dynamic model of a sized design in one load case, its excitation orders and its assumptions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, NamedTuple

import numpy as np

from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.assembly.bodies import (
    Assembly,
    add_bodies,
    add_supports,
    brakes,
    clutch_line,
    link_ends,
    shaft_lines,
)
from gearwright.dynamics.assembly.mesh_lines import (
    add_errors,
    add_friction,
    add_mesh_row,
    add_moving_set,
    mesh_phase,
    pin_stiffness,
    with_preload,
)
from gearwright.dynamics.assembly.meshes import contacts_of, gear_pairs, stiffness_model
from gearwright.dynamics.model import (
    ClutchDrive,
    Curve,
    DampingRatio,
    MachineDrive,
    Owner,
    PropellerDrive,
    System,
    points_of,
)
from gearwright.errors import by_name
from gearwright.identity import SIDES, Kind, PartId
from gearwright.sizing import Sizing, governing_case, play_in_motion
from gearwright.spec import GROUND, Airscrew, ElectricMachine, Machine, Pair, Record, quantity_of
from gearwright.spec.checks import table_of
from gearwright.spec.design import DynamicsRules
from gearwright.train import INTERNAL, Mesh
from gearwright.units import text
from gearwright.verbs import verb

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
