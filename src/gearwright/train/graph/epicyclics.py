"""Compound epicyclic sets in the graph: a node per planet body, a row per mesh, all relative to the one carrier."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.identity import Role, Row, gear_part
from gearwright.spec import Epicyclic
from gearwright.train.graph.toothed import EXTERNAL, INTERNAL, Gear, Mesh


def epicyclic_gears(stage: str, epicyclic: Epicyclic) -> Iterator[Gear]:
    """Yield every gear of a compound set; the steps of a stepped planet share a node.

    Args:
        stage: Its name.
        epicyclic: As in the design.
    """
    for name in epicyclic.toothed:
        central, role = epicyclic.centrals.get(name), _role(epicyclic, name)
        bodies = epicyclic.sets if central is None else 1
        yield Gear(stage, role, (_node(stage, epicyclic, name),), bodies, name, epicyclic.group(name))


def epicyclic_meshes(stage: str, epicyclic: Epicyclic) -> Iterator[Mesh]:
    """Yield every mesh row of a compound set.

    Args:
        stage: Its name.
        epicyclic: As in the design.
    """
    for first, second in epicyclic.mesh_pairs:
        yield Mesh(
            stage,
            _row(epicyclic, first, second),
            (_name(stage, epicyclic, first), _name(stage, epicyclic, second)),
            (_node(stage, epicyclic, first), _node(stage, epicyclic, second), epicyclic.carrier),
            INTERNAL if second in epicyclic.rings else EXTERNAL,
            epicyclic.sets,
            own=f"{first}-{second}",
            group=epicyclic.group(first),
        )


def _role(epicyclic: Epicyclic, name: str) -> Role:
    return Role.SUN if name in epicyclic.suns else Role.RING if name in epicyclic.rings else Role.PLANET


def _row(epicyclic: Epicyclic, first: str, second: str) -> Row:
    if second in epicyclic.rings:
        return Row.PLANET_RING
    return Row.SUN_PLANET if first in epicyclic.suns else Row.PLANET_PLANET


def _name(stage: str, epicyclic: Epicyclic, gear: str) -> str:
    return str(gear_part(stage, _role(epicyclic, gear), own=gear))


def _node(stage: str, epicyclic: Epicyclic, gear: str) -> str:
    """Return the shaft of a sun or ring, or the node of a planet's body, called as the first of its steps."""
    central = epicyclic.centrals.get(gear)
    return _name(stage, epicyclic, epicyclic.body(gear)) if central is None else central.shaft
