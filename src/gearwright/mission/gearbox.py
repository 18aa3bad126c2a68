"""The sized gearbox in flight: torques, forces and losses at an operating point, and power consumers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, by_name
from gearwright.identity import Role
from gearwright.sizing import Sizing
from gearwright.sizing.bearing_seats import Seat, bearing_seats
from gearwright.sizing.losses import (
    ORIGINS,
    Oil,
    Teeth,
    bearing_losses,
    gear_losses,
    mesh_loss_parts,
    seal_losses,
    teeth_of,
)
from gearwright.spec import GROUND, Accessory, Case, Drive, drives_of
from gearwright.train import PowerFlow, Turning, power_flow
from gearwright.verbs import verb

__all__ = ["Oil"]


# ----------------------------------------------------------------------------------------------------------------------
# What takes power in flight: the propeller or rotor that balances, accessories by demand, others by their part.
# ----------------------------------------------------------------------------------------------------------------------


def flown_airscrew(sizing: Sizing) -> str:
    """Return the propeller or rotor that a mission is flown with: the one that balances in its first case.

    Args:
        sizing: What was sized.

    Raises:
        DesignError: If there is none, or more than one.
    """
    drives = drives_of(sizing.design, sizing.reference.case)
    names = [name for name in sizing.design.airscrews if not drives[name].stated]
    if len(names) != 1:
        balance = f"{len(names)} propellers or rotors balance in case {sizing.reference.case}"
        raise DesignError([Problem("propellers", f"{balance}; a mission is flown with one per gearbox")])
    return names[0]


def taken_parts(sizing: Sizing) -> dict[str, float]:
    """Return every other machine that only takes -> its part of the power that the train is given [-].

    Tail rotors, generators and loads take in flight the part that they take in the case that speaks for the design;
    accessories are not among them: they take their own power at any speed, as in a case that says nothing of them.

    Args:
        sizing: What was sized.
    """
    flown, powers = flown_airscrew(sizing), sizing.reference.machine_powers
    given = sum(power for power in powers.values() if power > 0.0)
    takers = [
        name
        for name, machine in sizing.design.machines.items()
        if name != flown and not machine.drives and not isinstance(machine, Accessory)
    ]
    return {name: powers[name] / given for name in takers} if given else dict.fromkeys(takers, 0.0)


def own_demand(sizing: Sizing) -> float:
    """Return what all accessories take in flight, whatever the machines give [W].

    Args:
        sizing: What was sized.
    """
    return sum(accessory.power for accessory in sizing.design.accessories.values())


def with_consumers(powers: Mapping[str, float], taken: Mapping[str, float]) -> dict[str, float]:
    """Return the machines' powers with those of what takes its part of them [W].

    Args:
        powers: Machine -> power into the train [W].
        taken: From `taken_parts`; one whose power is among the others keeps that.
    """
    given = abs(sum(power for name, power in powers.items() if name not in taken))
    return {**{name: part * given for name, part in taken.items()}, **powers}


# ----------------------------------------------------------------------------------------------------------------------
# The sized gearbox as the mission sees it: torques, forces and losses of one operating point.
# ----------------------------------------------------------------------------------------------------------------------


_CASE = "mission"


class Drag(NamedTuple):
    """What the gearbox takes beside its meshes."""

    bearings: float
    """And seals, where there are some [W]."""
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
    teeth: Teeth
    """Contacts of the meshes."""
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
    return Gearbox(
        sizing=sizing,
        propeller=propeller,
        oil=oil,
        teeth=teeth_of(sizing),
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


def _inertia(sizing: Sizing, propeller: str) -> float:
    """Everything that turns, reduced to the propeller by the speeds of the rated case."""
    speeds = sizing.reference.speeds
    carriers = {carrier.stage: carrier for carrier in sizing.carriers}
    energy = 0.0
    for gear in sizing.gears:
        energy += gear.turning_inertia * gear.bodies * float(np.mean([speeds[node] ** 2 for node in gear.shafts]))
        if gear.role is Role.PLANET:
            carrier = carriers[gear.stage]
            energy += gear.turning_mass * gear.bodies * (carrier.radius * speeds[carrier.shaft]) ** 2
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
    train = gearbox.sizing.train
    parts = mesh_loss_parts(
        gearbox.sizing, gearbox.teeth, point.mesh_torques, speeds=_speeds(gearbox, point), oil=gearbox.oil
    )
    by_stage: dict[str, list[float]] = {}
    for mesh in train.meshes:
        by_stage.setdefault(mesh.stage, []).append(1.0 - parts[mesh.name])
    return {stage: float(np.mean(values)) for stage, values in by_stage.items()}


def drag(gearbox: Gearbox, point: Point) -> Drag:
    """Return what bearings, windage and churning take from the machines.

    Args:
        gearbox: The gearbox.
        point: Its loads and speeds.
    """
    speeds, sizing, oil = _speeds(gearbox, point), gearbox.sizing, gearbox.oil
    bodies = [*gear_losses(sizing, speeds, oil), *seal_losses(sizing, speeds, oil)]
    taken = {origin: sum(body.power for body in bodies if body.origin == origin) for origin in ORIGINS}
    rubbing = sum(
        seat.power for seat in bearing_losses(sizing, gearbox.seats, point.mesh_torques, speeds=speeds, oil=oil)
    )
    return Drag(rubbing + taken["seals"], taken["windage"], taken["churning"])


def _speeds(gearbox: Gearbox, point: Point) -> dict[str, float]:
    return {**dict(zip(gearbox.sizing.train.nodes, point.speeds.tolist(), strict=True)), GROUND: 0.0}
