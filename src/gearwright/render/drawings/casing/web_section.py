"""Webs that carry bosses, in a section: cut across they are metal, lengthwise they are not hatched (ISO 128)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.ranking import largest
from gearwright.render.drawings.casing.section_path import Lane
from gearwright.shape import WEB, Node, Scene
from gearwright.shape.solids import Rectangle, Solid, spans_in, without

SQUARE = 1e-9
"""How far directions may be from square, or from one another [-]."""
SEEN = 1e-5
"""Pieces of lines that are shorter are left out [m]."""

Line = tuple[complex, complex]
Span = tuple[float, float]


def web_nodes(scene: Scene) -> list[Node]:
    """Return the webs of a housing.

    Args:
        scene: With the housing.
    """
    return [node for node in scene.nodes if node.look == "housing" and f", {WEB} " in node.name]


def webs_across(scene: Scene, ways: Sequence[Lane]) -> Iterator[Rectangle]:
    """Yield what a section cuts of webs that it does not lie along.

    Args:
        scene: With the housing.
        ways: Of the section.
    """
    for node in web_nodes(scene):
        along, across, way = node.axes.turned.T
        if abs(abs(float(along[0])) - 1.0) > SQUARE:
            continue  # of a shaft across the first one: its webs lie in the section, or beside it
        long, wide, thick = _half_sizes(scene, node)
        signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
        loop = node.axes.origin[1:] + np.array([x * thick * across + y * long * way for x, y in signs])[:, 1:]
        if float(across[1] * way[2] - across[2] * way[1]) < 0.0:
            loop = loop[::-1]
        start, end = (float(node.axes.origin[0]) + sign * wide for sign in (-1.0, 1.0))
        for lane in ways:
            if any(abs(float(leg.along @ across[1:])) < SQUARE for leg in lane.legs):
                continue
            low, high = max(start, lane.start), min(end, lane.end)
            if low < high:
                yield from (Rectangle(low, high, *span) for span in spans_in(loop, lane.legs))


def webs_along(scene: Scene, ways: Sequence[Lane], metal: Sequence[Rectangle]) -> Iterator[Line]:
    """Yield the edges of webs along which a section lies, where they stand out of other metal, x + i height [m].

    Args:
        scene: With the housing.
        ways: Of the section.
        metal: What the section cuts of the housing.
    """
    for node in web_nodes(scene):
        for lane in ways:
            for leg in lane.legs:
                found = _outline(scene, node, leg.foot, leg.along)
                if found is None:
                    continue
                x, height = found
                x = max(x[0], lane.start), min(x[1], lane.end)
                height = max(height[0], leg.low), min(height[1], leg.high)
                if x[0] >= x[1] or height[0] >= height[1]:
                    continue
                if abs(float(node.axes.along[0])) < SQUARE:
                    yield from (_seen_up(at, height, metal) for at in x)
                else:
                    yield from (_seen_along(at, x, metal) for at in height)


def _outline(
    scene: Scene, node: Node, foot: Floats, up: Floats
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """Return from where to where a web that lies in a plane is along the first shaft and on it; None of others [m]."""
    along, across, way = node.axes.turned.T
    off = node.axes.origin[1:] - foot
    long, wide, thick = _half_sizes(scene, node)
    beside = abs(float(off @ np.array([-up[1], up[0]])))
    if abs(float(across[0])) > SQUARE or abs(float(across[1:] @ up)) > SQUARE or beside > thick:
        return None
    height, x = float(off @ up), float(node.axes.origin[0])
    level = wide * abs(float(along[0])) + long * abs(float(way[0]))
    upright = wide * abs(float(along[1:] @ up)) + long * abs(float(way[1:] @ up))
    return (x - level, x + level), (height - upright, height + upright)


def _half_sizes(scene: Scene, node: Node) -> tuple[float, float, float]:
    """Return half of a web's length, of its width along its shaft and of its thickness [m]."""
    solid = scene.solids[node.surface]
    assert isinstance(solid, Solid)
    points = solid.sections[0].points
    length = max(place for place, _ in solid.profile)
    return length, float(points[:, 0].max()), float(points[:, 1].max())


def _seen_up(x: float, height: tuple[float, float], metal: Sequence[Rectangle]) -> Line:
    """Return the longest piece of an upright edge that is not in metal."""
    taken = [(one.low, one.high) for one in metal if one.start - SEEN < x < one.end + SEEN]
    low, high = largest(without([height], taken) or [(height[0], height[0])], lambda span: span[1] - span[0])
    return complex(x, low), complex(x, high)


def _seen_along(height: float, x: tuple[float, float], metal: Sequence[Rectangle]) -> Line:
    """Return the longest piece of a level edge that is not in metal."""
    taken = [(one.start, one.end) for one in metal if one.low - SEEN < height < one.high + SEEN]
    low, high = largest(without([x], taken) or [(x[0], x[0])], lambda span: span[1] - span[0])
    return complex(low, height), complex(high, height)
