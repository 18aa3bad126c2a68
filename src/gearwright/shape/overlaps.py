"""Where bodies that turn against each other stand into each other, by the points of one in the section of the other.

A body is seen as what it sweeps about its own axis: of gears what lies below their roots, so that teeth in mesh, which
`meshing` and `crossing` look at, do not count.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.identity import HOUSING, Kind, Role
from gearwright.ranking import largest_first
from gearwright.shape.casings.flanges import FLANGES
from gearwright.shape.casings.screws import SCREW
from gearwright.shape.record import Node, Scene
from gearwright.shape.solids import Chamber, Solid, depth_in
from gearwright.sizing import Sizing
from gearwright.spec import GROUND

TOUCH = 1e-5
"""How deep points may stand in another body by rounding and by chords [m]."""
CORNERS, MANY = 8, 13
"""Points of the outline of a bridge, and along each of its edges [-]."""


class Overlap(NamedTuple):
    """Two bodies in one place."""

    one: str
    other: str
    """Names of nodes."""
    depth: float
    """How deep a point of one stands in the other [m]."""


def overlaps(sizing: Sizing, scene: Scene) -> tuple[Overlap, ...]:
    """Return which bodies that turn against each other, or covers and walls, stand into each other, the deepest first.

    Args:
        sizing: As sized.
        scene: Of it.
    """
    nodes = [node for node in scene.nodes
             if isinstance(scene.solids.get(node.surface), Solid) and (node.part.number or 1) == 1]  # fmt: skip
    moves = {node.name: _moves(sizing, node) for node in nodes}
    found = []
    for one, other in combinations(nodes, 2):
        if moves[one.name] != moves[other.name] and _near(scene, one, other):
            depth = max(_deep(scene, one, other), _deep(scene, other, one))
            if depth > TOUCH:
                found.append(Overlap(one.name, other.name, depth))
    moving = [node for node in nodes if any(node.spins.values()) or node.on or node.look == "holder"]
    found += _into_walls(scene, [*moving, *(node for node in scene.nodes if node.look == SCREW)])
    return tuple(largest_first(found, lambda overlap: overlap.depth))


def _into_walls(scene: Scene, bodies: list[Node]) -> Iterator[Overlap]:
    """Yield what stands in a wall or a plate of the housing, at rest."""
    walls = [(node, chamber) for node in scene.nodes if isinstance(chamber := scene.solids.get(node.surface), Chamber)]
    for node in bodies:
        points = scene.surfaces[node.surface].points @ node.axes.turned.T + node.axes.origin
        for wall, chamber in walls:
            if node.look == SCREW and FLANGES in wall.name:  # through whose halves it goes
                continue
            depth = depth_in((points - wall.axes.origin) @ wall.axes.turned, chamber, TOUCH)
            if depth > TOUCH:
                yield Overlap(node.name, wall.name, depth)


def _moves(sizing: Sizing, node: Node) -> str:
    """Return what a body turns with: a shaft, a planet, the carrier that it is on, or the ground."""
    if node.part == HOUSING:
        return GROUND
    if node.look == "shaft" or node.part.kind is Kind.SHAFT:
        return node.part.name
    if node.part.kind is Kind.CARRIER:
        return next(carrier.shaft for carrier in sizing.carriers if carrier.part == node.part)
    if node.part.kind is Kind.BEARING and not node.on:
        return next(bearing.shaft for bearing in sizing.bearings if bearing.name == node.part.name)
    gear = next((gear for gear in sizing.gears if node.part in [gear.part, *map(gear.body, gear.shafts)]), None)
    if gear is None or node.look == "bearing":  # of a planet
        return f"planets of {node.on}"
    return f"planets of {node.on}" if gear.role is Role.PLANET else node.part.branch or gear.shafts[0] or GROUND


def _near(scene: Scene, one: Node, other: Node) -> bool:
    """Tell whether balls around two bodies meet."""
    sizes = [float(np.max(np.linalg.norm(scene.surfaces[node.surface].points, axis=1))) for node in (one, other)]
    return float(np.linalg.norm(one.axes.origin - other.axes.origin)) < sum(sizes)


def _deep(scene: Scene, one: Node, other: Node) -> float:
    """Return how deep the points of one body stand in what another one sweeps [m]; 0 outside."""
    solid = _solid(scene, other)
    if solid.sections and len(solid.sections[0].radius) == CORNERS:  # a bridge, which sweeps nothing about itself
        return 0.0
    points = _points(scene, one) @ one.axes.turned.T + one.axes.origin
    own = (points - other.axes.origin) @ other.axes.turned
    section = _section(solid)
    seen = np.stack([own[:, 2], np.hypot(own[:, 0], own[:, 1])], axis=1)
    inside = _inside(seen, section)
    return float(np.max(_edge(seen[inside], section), initial=0.0))


def _points(scene: Scene, node: Node) -> Floats:
    """Return points on a body about its own axis [m]; on the edges of a bridge, many."""
    solid = _solid(scene, node)
    if not solid.sections or len(solid.sections[0].radius) != CORNERS:
        return scene.surfaces[node.surface].points
    low, high = (section.points for section in (solid.sections[0], solid.sections[-1]))
    share = np.linspace(0.0, 1.0, MANY)[:, None, None]
    around = low + share * (np.roll(low, -1, axis=0) - low)
    return np.asarray((around[:, None] + share[:, None] * np.array([0.0, 0.0, high[0, 2] - low[0, 2]])).reshape(-1, 3))


def _solid(scene: Scene, node: Node) -> Solid:
    solid = scene.solids[node.surface]
    assert isinstance(solid, Solid)  # no chamber of a housing, which stands still
    return solid


def _section(solid: Solid) -> Floats:
    """Return the corners of what a body sweeps in the half-plane through its axis: place and radius [m]."""
    corners = list(solid.profile)
    for section in solid.sections[:: len(solid.sections) - 1] if solid.sections else ():
        k = int(np.argmax(section.radius) if solid.inside else np.argmin(section.radius))
        corners.append((float(section.height[k]), float(section.radius[k])))
    if solid.sections and solid.inside:
        corners[-2:] = corners[:-3:-1]
    return np.array(corners)


def _inside(points: Floats, corners: Floats) -> Bools:
    """Return which points lie within a closed chain of lines: a line crosses it an odd number of times."""
    odd = np.zeros(len(points), dtype=bool)
    for (z, r), (onward, out) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if z == onward:
            continue
        across = (points[:, 0] >= min(z, onward)) & (points[:, 0] < max(z, onward))
        odd ^= across & (points[:, 1] < r + (out - r) * (points[:, 0] - z) / (onward - z))
    return odd


def _edge(points: Floats, corners: Floats) -> Floats:
    """Return how far points are from a closed chain of lines; what lies on the axis is no edge [m]."""
    near = np.full(len(points), np.inf)
    for start, end in _edges(corners):
        way = end - start
        share = np.clip((points - start) @ way / max(float(way @ way), 1e-30), 0.0, 1.0)
        near = np.minimum(near, np.linalg.norm(points - start - share[:, None] * way, axis=1))
    return near


def _edges(corners: Floats) -> Iterator[tuple[Floats, Floats]]:
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if start[1] or end[1]:
            yield start, end
