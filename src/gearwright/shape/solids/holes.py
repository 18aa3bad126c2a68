"""Webs with round holes: their faces around the holes, and the walls of the holes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.shape.solids.surface import Surface, around, circle, joined, revolved, strip

BESIDE = 1.3
"""Half of the piece of a web in which a hole lies over the hole's radius, at least [-]."""
LEAST = 12
"""Corners of a hole, at least [-]."""


class Holes(NamedTuple):
    """Round holes through the web of a body, evenly spaced, the first about the angle 0."""

    number: int
    """At least 3 [-]."""
    circle: float
    """Radius of the circle of their middles [m]."""
    radius: float
    """[m]"""


def pierced(profile: Sequence[tuple[float, float]], holes: Holes, segments: int) -> Surface:
    """Return what a way sweeps about the axis, its faces across the circle of the holes open where these are.

    Args:
        profile: z and radius [m], as `revolved` has it; it crosses the circle on two faces square to the axis.
        holes: In the web between these faces.
        segments: Corners of a circle, a multiple of the holes.
    """
    pieces, faces = [], []
    for here, there in pairwise(profile):
        low, high = sorted((here[1], there[1]))
        if here[0] == there[0] and low < holes.circle < high:
            pieces.append(_face(here[0], (low, high), holes, segments, up=here[1] > there[1]))
            faces.append(here[0])
        else:
            pieces.append(revolved((here, there), segments))
    return joined([*pieces, *_walls(min(faces), max(faces), holes, segments)])


def _rims(holes: Holes, segments: int) -> Floats:
    """Return the corners of all holes across the axis [m], shape (holes, corners, 2)."""
    angle = circle(max(LEAST, segments // 4))
    turn = np.exp(1j * circle(holes.number))[:, None]
    corners = turn * (holes.circle + holes.radius * np.exp(1j * angle))
    return np.stack([corners.real, corners.imag], axis=2)


def _face(height: float, radii: tuple[float, float], holes: Holes, segments: int, *, up: bool) -> Surface:
    """Return a face between two circles, open where holes are."""
    inner, outer = radii
    step, each = 2.0 * math.pi / segments, segments // holes.number
    reach = min(math.ceil(BESIDE * holes.radius / holes.circle / step), each // 2)
    rims = _rims(holes, segments)
    count, corners = rims.shape[:2]
    flat = np.concatenate([rims.reshape(-1, 2), np.full((count * corners, 1), height)], axis=1)
    points = np.concatenate([around(outer, height, segments), around(inner, height, segments), flat])
    plain = np.concatenate([each * k + np.arange(reach, each - reach) for k in range(count)]) % segments
    after = (plain + 1) % segments
    triangles = [np.stack([plain, after, after + segments], axis=1),
                 np.stack([plain, after + segments, plain + segments], axis=1)]  # fmt: skip
    for k in range(count):
        along = each * k + np.arange(-reach, reach + 1)
        loop = np.concatenate([along % segments, along[::-1] % segments + segments])
        own = 2 * segments + k * corners + np.arange(corners)
        middle = holes.circle * np.exp(2j * math.pi * k / count)
        triangles.append(_around_hole(points, loop, own, middle))
    normals = np.tile([0.0, 0.0, 1.0 if up else -1.0], (len(points), 1))
    found = np.concatenate(triangles)
    return Surface(points, normals, found if up else found[:, ::-1])


def _around_hole(points: Floats, loop: Ints, own: Ints, middle: complex) -> Ints:
    """Return the triangles between the corners of a piece of the web and those of its hole, all seen from its middle.

    Each side makes one triangle; both loops are walked in the order in which the middles of their sides are seen.
    """
    away = [points[numbers, 0] + 1j * points[numbers, 1] - middle for numbers in (loop, own)]
    start = np.angle(away[0][0])
    outer, inner = (np.mod(np.angle(place) - start, 2.0 * math.pi) for place in away)
    outer[0] = 0.0
    order = np.argsort(inner)
    sides = [angle - 0.5 * np.mod(angle - np.roll(angle, 1), 2.0 * math.pi) for angle in (outer, inner[order])]
    numbers = np.concatenate([loop, own[order]])
    return np.asarray(numbers[strip(*sides)])


def _walls(low: float, high: float, holes: Holes, segments: int) -> list[Surface]:
    """Return the walls of all holes, which look towards their middles."""
    rims = _rims(holes, segments)
    count = rims.shape[1]
    here, there = np.arange(count), np.roll(np.arange(count), -1)
    triangles = np.concatenate([np.stack([here, there + count, there], axis=1),
                                np.stack([here, here + count, there + count], axis=1)])  # fmt: skip
    walls = []
    for rim in rims:
        inwards = rim.mean(axis=0) - rim
        inwards /= np.linalg.norm(inwards, axis=1, keepdims=True)
        points = [np.concatenate([rim, np.full((count, 1), height)], axis=1) for height in (low, high)]
        normals = np.concatenate([inwards, np.zeros((count, 1))], axis=1)
        walls.append(Surface(np.concatenate(points), np.concatenate([normals, normals]), triangles))
    return walls
