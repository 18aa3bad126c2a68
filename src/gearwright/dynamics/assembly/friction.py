"""Torques of the friction of teeth in a case, as loads: with them the model stands where the flow with losses does.

A mesh line puts its force on both gears in the ratio of their teeth. What the driven gear receives less, and the
carrier bears, is a constant load on them, of the size that it has in the case.
"""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.dynamics.assembly.bodies import Assembly
from gearwright.dynamics.assembly.mesh_lines import mesh_bodies
from gearwright.spec import GROUND, Pair
from gearwright.train import Mesh

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
