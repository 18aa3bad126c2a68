"""Screws with what is on them: coaxial rings, round or with a hexagon outside, each a closed body of its own."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, following
from gearwright.shape.solids.plane import plane_triangles
from gearwright.shape.solids.surface import Surface, around, joined

FEWER, LEAST = 5, 8
"""Corners of circles of the scene over those of screws, which are small, and how many these have at least [-]."""
SIDES = 6
"""Of a hexagon [-]."""


class Layer(NamedTuple):
    """A ring about z."""

    start: float
    """Along z [m]."""
    end: float
    """[m]"""
    outer: float
    """Radius; of a hexagon half the width across its flats [m]."""
    bore: float = 0.0
    """Radius; 0: none [m]."""
    is_hexagon: bool = False

    @property
    def volume(self) -> float:
        """[m³]"""
        area = 2.0 * math.sqrt(3.0) if self.is_hexagon else math.pi
        return (area * self.outer**2 - math.pi * self.bore**2) * (self.end - self.start)


class Fastener(NamedTuple):
    """A screw with nut and washers: layers that touch each other or not, none in another."""

    layers: tuple[Layer, ...]


def fastener_surface(fastener: Fastener, segments: int) -> Surface:
    """Return the triangles of a screw and of what is on it, every layer closed by itself.

    Args:
        fastener: The screw.
        segments: Corners of larger circles of the scene.
    """
    return joined([_layer(layer, max(segments // FEWER, LEAST)) for layer in fastener.layers])


def _layer(layer: Layer, corners: int) -> Surface:
    span = (layer.start, layer.end)
    outer = around(*_corner(layer), corners)[:, :2] if not layer.is_hexagon else around(*_corner(layer), SIDES)[:, :2]
    loops = [outer, *([around(layer.bore, 0.0, corners)[:, :2]] if layer.bore else [])]
    pieces = [_flat_sides(outer, span) if layer.is_hexagon else _side(outer, span, out=True)]
    pieces += [_side(loop, span, out=False) for loop in loops[1:]]
    flat, triangles = np.concatenate(loops), plane_triangles(loops)
    for place, way in zip(span, (-1.0, 1.0), strict=True):
        points = np.column_stack([flat, np.full(len(flat), place)])
        normals = np.tile([0.0, 0.0, way], (len(flat), 1))
        pieces.append(Surface(points, normals, triangles if way > 0.0 else triangles[:, ::-1]))
    return joined(pieces)


def _corner(layer: Layer) -> tuple[float, float]:
    """Return how far the corners of a layer lie from its axis, and a height for them [m]."""
    return layer.outer / math.cos(math.pi / SIDES) if layer.is_hexagon else layer.outer, 0.0


def _side(loop: Floats, span: tuple[float, float], *, out: bool) -> Surface:
    """Return a round wall, seen from outside or from inside."""
    count = len(loop)
    points = np.concatenate([np.column_stack([loop, np.full(count, place)]) for place in span])
    ways = loop / np.linalg.norm(loop, axis=1, keepdims=True) * (1.0 if out else -1.0)
    normals = np.tile(np.column_stack([ways, np.zeros(count)]), (2, 1))
    here, there = np.arange(count), following(np.arange(count))
    triangles = np.concatenate([np.stack([here, there, there + count], axis=1),
                                np.stack([here, there + count, here + count], axis=1)])  # fmt: skip
    return Surface(points, normals, triangles if out else triangles[:, ::-1])


def _flat_sides(loop: Floats, span: tuple[float, float]) -> Surface:
    """Return the flat sides of a hexagon, whose corners are edges."""
    pieces = []
    for here, there in zip(loop, following(loop), strict=True):
        points = np.array([[*here, span[0]], [*there, span[0]], [*there, span[1]], [*here, span[1]]])
        way = (here + there) / float(np.linalg.norm(here + there))
        pieces.append(Surface(points, np.tile([*way, 0.0], (4, 1)), np.array([[0, 1, 2], [0, 2, 3]])))
    return joined(pieces)
