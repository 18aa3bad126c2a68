"""Branches of the power flow: what each machine, gear, carrier, clutch and damper gives to its shaft."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.identity import Kind, PartId, Role, Row, carrier_part
from gearwright.train.flow.carried import PowerFlow
from gearwright.train.graph import Mesh, Train
from gearwright.units import Power, Speed, Torque


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
