"""The sized gearbox as the mission sees it: torques, forces and losses of one operating point."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, by_name
from gearwright.identity import Role
from gearwright.mission.consumers import own_demand, taken_parts, with_consumers
from gearwright.parts.gears import ToothShift
from gearwright.parts.losses import (
    OIL_DENSITY,
    Friction,
    ToothContact,
    bearing_torque_constant,
    churning_power,
    mesh_efficiency,
    mesh_friction,
    oil_viscosity,
    tooth_contact,
    windage_power,
)
from gearwright.sizing import GearSizing, MeshSizing, Sizing
from gearwright.sizing.bearings import Seat, bearing_seats, seat_forces
from gearwright.spec import GROUND, Case, Drive
from gearwright.train import PowerFlow, Turning, power_flow
from gearwright.verbs import verb

_CASE = "mission"


class Oil(NamedTuple):
    """What losses need of oil and flanks."""

    temperature: float
    """Into the gearbox [K]."""
    roughness: float
    """R_a of the flanks [m]."""
    dip: Mapping[str, float]
    """Gear -> part of it that dips into an oil bath [-]; one left out runs dry."""
    friction: Friction = Friction.SCHLENK
    """Whose mean coefficient of friction."""


class Drag(NamedTuple):
    """What the gearbox takes beside its meshes."""

    bearings: float
    """[W]"""
    windage: float
    """[W]"""
    churning: float
    """[W]"""


class Point(NamedTuple):
    """One operating point of the gearbox."""

    speeds: Floats
    """Of the train's nodes, shape (nodes,) [rad/s]."""
    shaft_torques: Floats
    """Transmitted by each node: half the sum of what acts on it, shape (nodes,) [N m]."""
    machine_powers: Floats
    """Into the train without drag, shape (machines,) [W]."""
    mesh_torques: Floats
    """On gear a of one single mesh of each row, shape (meshes,) [N m]."""
    mesh_losses: Floats
    """Of all equal meshes of a row, shape (meshes,) [W]."""

    @property
    def mesh_loss(self) -> float:
        """Of all meshes [W]."""
        return float(self.mesh_losses.sum())

    @property
    def work(self) -> float:
        """Power that reaches the propeller [W]."""
        return float(self.machine_powers.sum()) - self.mesh_loss

    def scaled(self, factor: float) -> Point:
        """Return the point with all torques and powers changed by one factor, accessories' among them.

        Args:
            factor: [-].
        """
        return Point(self.speeds, *(factor * value for value in self[1:]))


@dataclass(frozen=True)
class Gearbox:
    """A sizing with everything that does not change in flight worked out."""

    sizing: Sizing
    propeller: str
    """Name of its propeller."""
    oil: Oil
    contacts: tuple[ToothContact, ...]
    """Of each mesh row."""
    radii: Floats
    """Working pitch radius of gear a of each mesh row, shape (meshes,) [m]."""
    widths: Floats
    """Narrower face of each mesh row, shape (meshes,) [m]."""
    inertia: float
    """Of everything that turns, at the propeller [kg m²]."""
    turning: Turning
    """Speeds of the train: intervals often turn alike."""
    taken: Mapping[str, float]
    """What takes its part of the power that the train is given -> this part [-]."""
    demand: float
    """What accessories take whatever is given [W]; without any, torques and powers are proportional."""
    seats: tuple[Seat, ...]
    """Of the bearings whose load follows from the meshes."""

    @property
    def machines(self) -> tuple[str, ...]:
        """Machines without the propeller, in the order of a point's powers."""
        return tuple(name for name in self.sizing.train.machines if name != self.propeller)


@verb
def gearbox_of(sizing: Sizing, propeller: str, oil: Oil) -> Gearbox:
    """Return a sizing made ready to fly.

    Args:
        sizing: The sized transmission.
        propeller: Name of the propeller that flies.
        oil: Its oil.
    """
    by_name(propeller, sizing.design.airscrews, "propeller")
    _refuse_slip(sizing)
    gears = {gear.name: gear for gear in sizing.gears}
    pairs = [(gears[mesh.gears[0]], gears[mesh.gears[1]]) for mesh in sizing.train.meshes]
    return Gearbox(
        sizing=sizing,
        propeller=propeller,
        oil=oil,
        contacts=tuple(_contact(sizing, pair, mesh) for pair, mesh in zip(pairs, sizing.meshes, strict=True)),
        radii=np.array([mesh.working_diameter / 2.0 for mesh in sizing.meshes]),
        widths=np.array([min(gear.face_width, mate.face_width) for gear, mate in pairs]),
        inertia=_inertia(sizing, propeller),
        turning=Turning(sizing.design, sizing.train, sizing.teeth),
        taken=taken_parts(sizing),
        demand=own_demand(sizing),
        seats=bearing_seats(sizing),
    )


def _refuse_slip(sizing: Sizing) -> None:
    """Refuse dampers that slip: an operating point is scaled with its power, which their heat does not follow."""
    slipping = [name for name, damper in sizing.reference.dampers.items() if damper.slip]
    message = "its shafts turn at different speeds, and a mission does not fly with its heat; leave it out, or join"
    if slipping:
        raise DesignError([Problem(f"dampers.{name}", f"{message} shafts that turn alike") for name in slipping])


def _contact(sizing: Sizing, pair: tuple[GearSizing, GearSizing], mesh: MeshSizing) -> ToothContact:
    gear, mate = pair
    shifted = gear.profile_shift + mate.profile_shift != 0.0
    return tooth_contact(
        (gear.teeth, -mate.teeth if mate.name in sizing.train.internal else mate.teeth),
        gear.module,
        pressure_angle=sizing.design.rules(mesh.stage).pressure_angle,
        helix_angle=gear.helix_angle,
        shifts=(_shift(gear), _shift(mate)),
        working_angle=mesh.working_pressure_angle if shifted else None,
    )


def _shift(gear: GearSizing) -> ToothShift:
    return ToothShift(gear.profile_shift, gear.tip_alteration)


def _inertia(sizing: Sizing, propeller: str) -> float:
    """Everything that turns, reduced to the propeller by the speeds of the rated case."""
    speeds = sizing.reference.speeds
    carriers = {carrier.stage: carrier for carrier in sizing.carriers}
    energy = 0.0
    for gear in sizing.gears:
        energy += gear.inertia * gear.bodies * float(np.mean([speeds[node] ** 2 for node in gear.shafts]))
        if gear.role is Role.PLANET:
            carrier = carriers[gear.stage]
            energy += gear.mass * gear.bodies * (carrier.radius * speeds[carrier.shaft]) ** 2
    energy += sum(shaft.inertia * speeds[shaft.name] ** 2 for shaft in sizing.shafts)
    energy += sum(carrier.inertia * speeds[carrier.shaft] ** 2 for carrier in sizing.carriers)
    energy += sum(machine.inertia * speeds[machine.shaft] ** 2 for machine in sizing.machines)
    return float(energy / speeds[sizing.train.machines[propeller]] ** 2)


def operate(
    gearbox: Gearbox, powers: Mapping[str, float], propeller_speed: float, efficiency: Mapping[str, float]
) -> Point:
    """Return the operating point at which machines give their powers and the propeller takes what is left.

    Args:
        gearbox: The gearbox.
        powers: Machine -> power into the train [W]; one left out idles, or takes its demand or its part of the power.
        propeller_speed: [rad/s].
        efficiency: Stage -> efficiency of each of its meshes [-].

    Raises:
        DesignError: The train does not balance, or one speed does not set all others.
    """
    drives = {name: Drive(power=power) for name, power in with_consumers(powers, gearbox.taken).items()}
    drives[gearbox.propeller] = Drive(speed=propeller_speed)
    sizing = gearbox.sizing
    design = sizing.design.model_copy(update={"cases": {_CASE: Case.model_validate(drives)}})
    flow = power_flow(design, sizing.train, sizing.teeth, _CASE, efficiency=efficiency, turning=gearbox.turning)
    return _point(gearbox, flow)


def _point(gearbox: Gearbox, flow: PowerFlow) -> Point:
    train = gearbox.sizing.train
    meshes = [flow.meshes[mesh.name] for mesh in train.meshes]
    return Point(
        speeds=np.array([flow.speeds[node] for node in train.nodes]),
        shaft_torques=transmitted(gearbox.sizing, flow),
        machine_powers=np.array([flow.machine_powers[name] for name in gearbox.machines]),
        mesh_torques=np.array(
            [mesh_flow.torques[0] / mesh.count for mesh_flow, mesh in zip(meshes, train.meshes, strict=True)]
        ),
        mesh_losses=np.array([mesh_flow.loss for mesh_flow in meshes]),
    )


def transmitted(sizing: Sizing, flow: PowerFlow) -> Floats:
    """Return what each node of the train transmits: half the sum of the torques on it, shape (nodes,) [N m].

    Args:
        sizing: With the train.
        flow: A balanced case of it.
    """
    column = {node: k for k, node in enumerate(sizing.train.nodes)}
    total = np.zeros(len(column))
    for mesh in sizing.train.meshes:
        for node, torque in zip(mesh.nodes, flow.meshes[mesh.name].torques, strict=True):
            if node in column:
                total[column[node]] += abs(torque)
    for name, torque in flow.machine_torques.items():
        total[column[sizing.train.machines[name]]] += abs(torque)
    for link in sizing.train.links:
        for node in {link.driving, link.driven} - {GROUND}:
            total[column[node]] += abs(flow.given(link.name))
    return 0.5 * total


def efficiencies(gearbox: Gearbox, point: Point) -> dict[str, float]:
    """Return the mesh efficiency of each stage at an operating point: of its meshes the mean loss.

    Args:
        gearbox: The gearbox.
        point: Its loads and speeds.
    """
    train, viscosity = gearbox.sizing.train, oil_viscosity(gearbox.oil.temperature) * OIL_DENSITY
    speed = {**dict(zip(train.nodes, point.speeds, strict=True)), "ground": 0.0}
    by_stage: dict[str, list[float]] = {}
    for k, mesh in enumerate(train.meshes):
        contact = gearbox.contacts[k]
        normal = abs(point.mesh_torques[k]) / (gearbox.radii[k] * np.cos(contact.pressure_angle))
        friction = mesh_friction(
            contact,
            float(normal / gearbox.widths[k]),
            float((speed[mesh.nodes[0]] - speed[mesh.nodes[2]]) * gearbox.radii[k]),
            viscosity=viscosity,
            roughness=gearbox.oil.roughness,
            law=gearbox.oil.friction,
        )
        by_stage.setdefault(mesh.stage, []).append(mesh_efficiency(contact, friction))
    return {stage: float(np.mean(values)) for stage, values in by_stage.items()}


def drag(gearbox: Gearbox, point: Point) -> Drag:
    """Return what bearings, windage and churning take from the machines.

    Args:
        gearbox: The gearbox.
        point: Its loads and speeds.
    """
    speed = {**dict(zip(gearbox.sizing.train.nodes, point.speeds.tolist(), strict=True)), GROUND: 0.0}
    return Drag(_bearing_drag(gearbox, point, speed), *_oil_drag(gearbox, speed))


def _oil_drag(gearbox: Gearbox, speed: Mapping[str, float]) -> tuple[float, float]:
    """Return windage and churning [W]; a gear that dips churns the bath instead of the mist."""
    viscosity, windage, churning = oil_viscosity(gearbox.oil.temperature), 0.0, 0.0
    for gear in gearbox.sizing.gears:
        turning = speed.get(gear.shafts[0], 0.0)
        dip = gearbox.oil.dip.get(gear.name, 0.0)
        if dip:
            module = gear.module / math.cos(gear.helix_angle)
            churning += gear.bodies * churning_power(
                gear.pitch_diameter, gear.face_width, turning,
                viscosity=viscosity, dip=dip, module=module, helix_angle=gear.helix_angle,
            )  # fmt: skip
        else:
            radius = gear.pitch_diameter / 2.0
            windage += gear.bodies * windage_power(radius, gear.face_width, turning, viscosity=viscosity * OIL_DENSITY)
    return windage, churning


def _bearing_drag(gearbox: Gearbox, point: Point, speed: Mapping[str, float]) -> float:
    total = 0.0
    for seat in gearbox.seats:
        radial, _ = seat_forces(seat, point.mesh_torques, np.array(speed[seat.carrier]))
        turning = abs(speed[seat.nodes[0]] - speed[seat.nodes[1]])
        total += seat.count * bearing_torque_constant(float(radial), seat.bore) * turning
    return total
