"""Assemble: a sizing and one of its load cases become a System of absolute rotations.

Every gear, carrier and machine is a body; shafts, clutches, dampers and meshes are lines. Planets are bodies of their
own, with the relative mesh phases that their places give. Lines are signed so that what carries power in the case
carries it with a positive force.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Literal, NamedTuple

from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.assembly.bodies import Assembly, add_bodies
from gearwright.dynamics.assembly.contacts import contacts_of
from gearwright.dynamics.assembly.errors import add_errors
from gearwright.dynamics.assembly.friction import add_friction
from gearwright.dynamics.assembly.mesh_lines import add_mesh_row
from gearwright.dynamics.assembly.orders import add_orders
from gearwright.dynamics.assembly.shaft_lines import brakes, clutch_line, link_ends, shaft_lines
from gearwright.dynamics.assembly.supports import add_supports
from gearwright.dynamics.assembly.translational import add_moving_set, with_preload
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
from gearwright.identity import Kind, PartId
from gearwright.sizing import Sizing, governing_case
from gearwright.verbs import verb


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
