"""Which single gears mesh, where they touch, and which way their teeth go there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.shape.stands import Stand
from gearwright.shape.teeth import kind_of
from gearwright.sizing import Sizing
from gearwright.train import INTERNAL, Mesh


@dataclass(frozen=True)
class Contact:
    """Two gears in mesh."""

    mesh: Mesh
    """Row of the train."""
    first: Stand
    second: Stand
    angles: tuple[float, float]
    """Where they touch, as each sees it about its own axis [rad]."""
    sense: float
    """+1 where teeth that turn the same way about both axes go the same way, −1 where against each other [-]."""
    offset: float
    """How far the second gear's middle stands from the first one's along the axis, of parallel axes [m]."""


def contacts_of(sizing: Sizing, stands: Sequence[Stand]) -> tuple[Contact, ...]:
    """Return every mesh of single gears.

    Args:
        sizing: As sized.
        stands: Its gears where they stand.
    """
    by_gear: dict[tuple[str, str, int], Stand] = {(stand.gear.name, stand.node, stand.place): stand for stand in stands}
    return tuple(contact for mesh in sizing.train.meshes for contact in _of_row(sizing, mesh, by_gear))


def _of_row(sizing: Sizing, mesh: Mesh, stands: Mapping[tuple[str, str, int], Stand]) -> Iterator[Contact]:
    sets = mesh.count if mesh.stage in sizing.design.sets else 1
    for place in range(sets):
        pair = []
        for gear, node in zip(mesh.gears, mesh.nodes[:2], strict=True):
            pair.append(stands.get((gear, node, place)) or stands[(gear, node, 0)])
        yield contact_of(sizing, mesh, pair[0], pair[1])


def contact_of(sizing: Sizing, mesh: Mesh, first: Stand, second: Stand) -> Contact:
    """Return how two gears touch.

    Args:
        sizing: As sized.
        mesh: Row of the train.
        first: Its first gear.
        second: Its second gear.
    """
    ways = _ways(sizing, mesh, first, second)
    moves = [np.cross(stand.axes.along, way) for stand, way in zip((first, second), ways, strict=True)]
    angles = (first.axes.angle(ways[0]), second.axes.angle(ways[1]))
    offset = float((second.axes.origin - first.axes.origin) @ first.axes.along)
    return Contact(mesh, first, second, angles, float(np.sign(moves[0] @ moves[1])), offset)


def _ways(sizing: Sizing, mesh: Mesh, first: Stand, second: Stand) -> tuple[Floats, Floats]:
    """Return the directions from both axes to where the gears touch, square to each axis."""
    kind, (one, other) = kind_of(sizing, mesh.stage), (first.axes, second.axes)
    if kind == "bevel":
        pair = sizing.design.pairs[mesh.stage]
        back = [axes.along * (-1.0 if apex == "second" else 1.0)
                for axes, apex in zip((one, other), (pair.pinion_apex, pair.wheel_apex), strict=True)]  # fmt: skip
        return _square(back[1], back[0]), _square(back[0], back[1])
    if kind == "face":
        toward = _square(one.origin - other.origin, other.along)  # from the wheel's axis to the pinion
        radius = second.gear.pitch_diameter / 2.0
        touch = other.origin + radius * toward
        return _square(touch - one.origin, one.along), toward
    between = _square(other.origin - one.origin, one.along)
    return (-between, -between) if mesh.sign == INTERNAL else (between, -between)


def _square(way: Floats, axis: Floats) -> Floats:
    """Return the unit vector along that part of a way which is square to an axis."""
    part = way - (way @ axis) * axis
    return np.asarray(part / np.linalg.norm(part))
