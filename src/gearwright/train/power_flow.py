"""Power flow of a load case: branches, recirculating power, and mesh and planet pass frequencies."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal

from gearwright.base import Kind, PartId, Power, Role, Row, Speed, Torque, carrier_part, largest_first
from gearwright.spec import GROUND, Design, Planetary
from gearwright.train.graph import INTERNAL, Mesh, Train
from gearwright.train.kinematics import Yielded

# ----------------------------------------------------------------------------------------------------------------------
# What a balanced load case carries: in its meshes, clutches, dampers and machines.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDING = 1e-12
"""Of the largest power of a machine: what is lost below this are sums that nearly close [-]. Trains without losses
leave up to 5e-14."""


@dataclass(frozen=True)
class MeshFlow:
    """What one row of equal meshes carries."""

    name: str
    multiplier: float
    """Torque per tooth of all equal meshes together, λ [N m]."""
    torques: tuple[float, float, float]
    """Torque on the nodes of gear a, gear b and carrier, all equal meshes together [N m]."""
    tooth_power: float
    """Power through the teeth relative to the carrier, positive from a to b [W]."""
    loss: float
    """Power lost in the teeth [W]."""


@dataclass(frozen=True)
class Dragged:
    """What a damper carries."""

    torque: float
    """That it gives to its driven shaft [N m]."""
    slip: float
    """Speed of its driving shaft over the driven one [rad/s]."""

    @property
    def loss(self) -> float:
        """Heat [W]."""
        return self.torque * self.slip


@dataclass(frozen=True)
class PowerFlow:
    """A balanced load case."""

    case: str
    speeds: Mapping[str, float]
    """Node -> speed [rad/s]; the ground is in it with zero."""
    machine_torques: Mapping[str, float]
    """Machine -> torque on its shaft [N m]."""
    machine_powers: Mapping[str, float]
    """Machine -> power into the train [W]; negative takes power out."""
    meshes: Mapping[str, MeshFlow]
    """Mesh row -> what it carries."""
    joints: Mapping[str, float] = field(default_factory=dict)
    """Engaged clutch -> torque that it gives to its driven shaft [N m]; an open one is not in it."""
    dampers: Mapping[str, Dragged] = field(default_factory=dict)
    """Damper -> what it carries."""
    yielded: tuple[Yielded, ...] = ()
    """Machines whose asked speed the teeth give only nearly."""

    @property
    def loss(self) -> float:
        """Power lost in all meshes and dampers [W]; none where it is rounding beside the powers of the machines."""
        lost = sum(mesh.loss for mesh in self.meshes.values()) + sum(damper.loss for damper in self.dampers.values())
        return lost if abs(lost) > ROUNDING * max(map(abs, self.machine_powers.values()), default=0.0) else 0.0

    def given(self, link: str) -> float:
        """Return the torque that a clutch or damper gives to its driven shaft [N m]; zero of an open clutch.

        Args:
            link: Its name.
        """
        return self.dampers[link].torque if link in self.dampers else self.joints.get(link, 0.0)

    @property
    def residual(self) -> float:
        """Power in minus power out minus losses, as a part of the power in [-]."""
        powers = self.machine_powers.values()
        supplied = sum(power for power in powers if power > 0.0)
        return abs(sum(powers) - self.loss) / supplied if supplied else 0.0


def shaft_powers(train: Train, flow: PowerFlow) -> dict[tuple[str, str], float]:
    """Return what every stage gives to each shaft that it meshes with [W]; negative where it takes.

    Args:
        train: The graph.
        flow: A load case.

    Returns:
        (stage, shaft) -> power; planets are within their stage.
    """
    powers: dict[tuple[str, str], float] = {}
    for mesh in train.meshes:
        for node, torque in zip(mesh.nodes, flow.meshes[mesh.name].torques, strict=True):
            if node != GROUND and node not in train.planet_nodes:
                key = (mesh.stage, node)
                powers[key] = powers.get(key, 0.0) + torque * flow.speeds[node]
    return powers


# ----------------------------------------------------------------------------------------------------------------------
# Branches of the power flow: what each machine, gear, carrier, clutch and damper gives to its shaft.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Branch:
    """One part on one shaft; a part that takes power out of the shaft has a negative power."""

    shaft: str
    """Shaft, or ``ground``."""
    part: PartId
    """Machine, clutch, damper, or member of a stage such as ``first.sun``, ``first.carrier``."""
    stage: str
    """Pair or planetary set; empty for what is in no stage."""
    speed: Speed
    """Of the shaft [rad/s]."""
    torque: Torque
    """On the shaft [N m]."""

    @property
    def power(self) -> Power:
        """Into the shaft [W]."""
        return self.torque * self.speed


@dataclass(frozen=True)
class Attachment:
    """Where a part of the train sits on a shaft."""

    shaft: str
    part: PartId
    stage: str
    """Of which it is a member there, also of a gear that another pair owns; empty for what is in no stage."""

    @property
    def member(self) -> Role | Kind:
        """What it is there: role of a gear, or carrier, machine, clutch, damper."""
        return self.part.role if isinstance(self.part.role, Role) else self.part.kind


def attachments(train: Train) -> tuple[Attachment, ...]:
    """Return every part of a train with the shaft, or the ground, that it sits on.

    Args:
        train: The graph.
    """
    machines = [Attachment(shaft, PartId(Kind.MACHINE, name), "") for name, shaft in train.machines.items()]
    gears = [
        Attachment(shaft, gear.part, gear.stage)
        for gear in train.gears
        for shaft in gear.nodes
        if gear.role is not Role.PLANET
    ]
    shared = [
        Attachment(node, train.gear(gear).part, mesh.stage)
        for mesh in train.meshes
        for gear, node in zip(mesh.gears, mesh.nodes, strict=False)
        if train.gear(gear).stage != mesh.stage
    ]
    carriers = [
        Attachment(mesh.nodes[2], carrier_part(mesh.stage), mesh.stage)
        for mesh in train.meshes
        if mesh.row is not Row.PAIR
    ]
    links = [
        Attachment(shaft, PartId(kind, link.name), "")
        for kind, group in ((Kind.CLUTCH, train.joints), (Kind.DAMPER, train.dampers))
        for link in group
        for shaft in (link.driving, link.driven)
    ]
    return tuple(dict.fromkeys([*machines, *gears, *shared, *carriers, *links]))


def branches(train: Train, flow: PowerFlow) -> tuple[Branch, ...]:
    """Return what every part gives to its shaft in one load case.

    Args:
        train: The graph.
        flow: The case.
    """
    return tuple(
        Branch(
            attachment.shaft,
            attachment.part,
            attachment.stage,
            flow.speeds[attachment.shaft],
            _torque(attachment, train, flow),
        )
        for attachment in attachments(train)
    )


def _torque(attachment: Attachment, train: Train, flow: PowerFlow) -> float:
    part = attachment.part
    if part.kind is Kind.MACHINE:
        return flow.machine_torques[part.name]
    if part.kind in (Kind.CLUTCH, Kind.DAMPER):
        link = next(link for link in train.links if link.name == part.name)
        torque = flow.given(part.name)
        return torque if attachment.shaft == link.driven else -torque
    return sum(_on_member(attachment, mesh, flow) for mesh in train.meshes if mesh.stage == attachment.stage)


def _on_member(attachment: Attachment, mesh: Mesh, flow: PowerFlow) -> float:
    torques, name = flow.meshes[mesh.name].torques, str(attachment.part)
    if attachment.part.kind is Kind.CARRIER:
        return torques[2]
    ends = zip(mesh.gears, mesh.nodes[:2], torques[:2], strict=True)
    return sum(torque for gear, node, torque in ends if gear == name and node == attachment.shaft)


# ----------------------------------------------------------------------------------------------------------------------
# Power that runs in a circle: out of a stage on one shaft, through other stages, and back into it on another.
# ----------------------------------------------------------------------------------------------------------------------


SMALLEST_SHARE = 1e-9
"""Circulating power below this part of the power supplied is rounding."""


@dataclass(frozen=True)
class Loop:
    """One circle of power."""

    path: tuple[str, ...]
    """Stages and shafts in the direction of the power; the first one follows the last."""
    power: float
    """What circulates [W]."""


def recirculation(train: Train, flow: PowerFlow) -> tuple[Loop, ...]:
    """Return every circle in which power runs, the largest first; none is the usual case.

    Args:
        train: The graph.
        flow: A load case.
    """
    edges = _edges(train, flow)
    supplied = sum(power for power in flow.machine_powers.values() if power > 0.0)
    loops = []
    while (path := _circle(edges)) is not None:
        steps = list(zip(path, (*path[1:], path[0]), strict=True))
        power = min(edges[start][end] for start, end in steps)
        loops.append(Loop(tuple(path), power))
        for start, end in steps:
            edges[start][end] -= power
            if edges[start][end] <= SMALLEST_SHARE * supplied:
                del edges[start][end]
    return tuple(largest_first(loops, lambda loop: loop.power))


def _edges(train: Train, flow: PowerFlow) -> dict[str, dict[str, float]]:
    """Return the power from every stage to the shafts that it drives, and to it from those that drive it [W]."""
    powers = {(f"stage {stage}", shaft): power for (stage, shaft), power in shaft_powers(train, flow).items()}
    for link in train.links:
        torque = flow.given(link.name)
        powers[(f"link {link.name}", link.driven)] = torque * flow.speeds[link.driven]
        powers[(f"link {link.name}", link.driving)] = -torque * flow.speeds[link.driving]
    supplied = sum(power for power in flow.machine_powers.values() if power > 0.0)
    edges: dict[str, dict[str, float]] = {}
    for (stage, shaft), power in powers.items():
        if abs(power) > SMALLEST_SHARE * supplied:
            start, end = (stage, shaft) if power > 0.0 else (shaft, stage)
            edges.setdefault(start, {})[end] = abs(power)
    return edges


def _circle(edges: Mapping[str, Mapping[str, float]]) -> list[str] | None:
    """Return one directed circle, or None."""
    done: set[str] = set()
    for start in edges:
        path: list[str] = []
        circle = _walk(start, edges, path, done)
        if circle is not None:
            return circle
    return None


def _walk(node: str, edges: Mapping[str, Mapping[str, float]], path: list[str], done: set[str]) -> list[str] | None:
    """Follow the power from a node until a node of the path comes again."""
    if node in path:
        return path[path.index(node) :]
    if node in done:
        return None
    path.append(node)
    for following in edges.get(node, {}):
        circle = _walk(following, edges, path, done)
        if circle is not None:
            return circle
    path.pop()
    done.add(node)
    return None


# ----------------------------------------------------------------------------------------------------------------------
# How often teeth mesh and planets pass: the frequencies that a turning train shakes its housing with.
# ----------------------------------------------------------------------------------------------------------------------


Pass = Literal["mesh", "planet-pass"]


def passes(
    design: Design, train: Train, teeth: Mapping[str, float], flow: PowerFlow, of: Pass
) -> Iterator[tuple[Mesh, float]]:
    """Yield the rows of a train whose teeth mesh, or whose planets pass a tooth of their ring, and how often [Hz].

    Both rows of a planetary set mesh as often: the one with the sun speaks for it. What stands still passes nothing.

    Args:
        design: With its stages.
        train: Its graph.
        teeth: Tooth number of every gear.
        flow: A load case.
        of: Teeth (mesh) or planets (planet-pass).

    Source: counting: z |ω − ω_c|/2π and N |ω_c − ω_r|/2π; McFadden & Smith 1985, Proc. Inst. Mech. Eng. C 199, 65-70.
    """
    for mesh in train.meshes:
        first, second, carrier = (flow.speeds[node] for node in mesh.nodes)
        in_ring = mesh.sign == INTERNAL
        if of == "mesh" and not (in_ring and isinstance(design.stages[mesh.stage], Planetary)):
            frequency = teeth[mesh.gears[0]] * abs(first - carrier) / (2.0 * math.pi)
        elif of == "planet-pass" and in_ring and mesh.stage in design.sets:
            frequency = mesh.count * abs(carrier - second) / (2.0 * math.pi)
        else:
            continue
        if frequency:
            yield mesh, frequency
