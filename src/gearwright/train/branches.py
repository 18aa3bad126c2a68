"""Branches of the power flow: what each machine, gear, carrier and clutch gives to the shaft that it sits on."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.train.flow import PowerFlow
from gearwright.train.graph import Mesh, Train
from gearwright.units import Power, Speed, Torque


@dataclass(frozen=True)
class Branch:
    """One part on one shaft; a part that takes power out of the shaft has a negative power."""

    shaft: str
    """Shaft, or ``ground``."""
    part: str
    """Machine, clutch, or member of a stage such as ``first.sun``, ``first.carrier``."""
    stage: str
    """Pair or planetary set; empty for machines and clutches."""
    kind: str
    """``machine``, ``clutch``, or the member's role."""
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
    part: str
    stage: str
    kind: str


def attachments(train: Train) -> tuple[Attachment, ...]:
    """Return every part of a train with the shaft, or the ground, that it sits on.

    Args:
        train: The graph.
    """
    machines = [Attachment(shaft, name, "", "machine") for name, shaft in train.machines.items()]
    gears = [
        Attachment(shaft, gear.name, gear.stage, gear.role)
        for gear in train.gears
        for shaft in gear.nodes
        if gear.role != "planet"
    ]
    shared = [
        Attachment(node, gear, mesh.stage, "shared")
        for mesh in train.meshes
        for gear, node in zip(mesh.gears, mesh.nodes, strict=False)
        if not gear.startswith(f"{mesh.stage}.")
    ]
    carriers = {
        mesh.stage: Attachment(mesh.nodes[2], f"{mesh.stage}.carrier", mesh.stage, "carrier")
        for mesh in train.meshes
        if any(train.gear(gear).role == "planet" for gear in mesh.gears)
    }
    clutches = [
        Attachment(shaft, joint.name, "", "clutch") for joint in train.joints for shaft in (joint.driving, joint.driven)
    ]
    return tuple(dict.fromkeys([*machines, *gears, *shared, *carriers.values(), *clutches]))


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
            attachment.kind,
            flow.speeds[attachment.shaft],
            _torque(attachment, train, flow),
        )
        for attachment in attachments(train)
    )


def _torque(attachment: Attachment, train: Train, flow: PowerFlow) -> float:
    if attachment.kind == "machine":
        return flow.machine_torques[attachment.part]
    if attachment.kind == "clutch":
        joint = next(joint for joint in train.joints if joint.name == attachment.part)
        torque = flow.joints.get(attachment.part, 0.0)
        return torque if attachment.shaft == joint.driven else -torque
    return sum(_on_member(attachment, mesh, flow) for mesh in train.meshes if mesh.stage == attachment.stage)


def _on_member(attachment: Attachment, mesh: Mesh, flow: PowerFlow) -> float:
    torques = flow.meshes[mesh.name].torques
    if attachment.kind == "carrier":
        return torques[2]
    ends = zip(mesh.gears, mesh.nodes[:2], torques[:2], strict=True)
    return sum(torque for gear, node, torque in ends if gear == attachment.part and node == attachment.shaft)
