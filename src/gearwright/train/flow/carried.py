"""What a balanced load case carries: in its meshes, clutches, dampers and machines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gearwright.spec import GROUND
from gearwright.train.graph import Train
from gearwright.train.kinematics import Yielded

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
