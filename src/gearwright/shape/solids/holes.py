"""Webs and plates with round holes: their faces around the holes, and the walls of the holes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Complexes, Floats, Ints
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


class Bores(NamedTuple):
    """Round holes along the axis through a body from end to end, each where the body reaches all around it."""

    middles: tuple[complex, ...]
    """Across the axis, x + i y [m]."""
    radius: float
    """[m]"""

    def rays(self, steps: int) -> Floats:
        """Return the rays from the axis on which corners of the holes lie, two each but at both ends [rad].

        Args:
            steps: Of each half of a hole [-].

        Returns:
            Shape (holes, rays), each hole's rising.
        """
        middles = np.array(self.middles)[:, None]
        return np.asarray(np.angle(middles) + _turned(self.radius / np.abs(middles), steps))

    def as_large(self, steps: int) -> Bores:
        """Return holes whose corners lie so far out that they leave as much of a body as round ones.

        Args:
            steps: As `rays`.
        """
        away = float(np.mean(np.abs(self.middles)))
        radius = self.radius
        for _ in range(4):
            turn = _turned(np.array([radius / away]), steps)
            rim = _rim(away, radius, np.exp(1j * turn))
            area = 0.5 * float(np.sum((np.conj(rim) * np.roll(rim, -1)).imag))
            radius *= math.sqrt(math.pi * self.radius**2 / area)
        return self._replace(radius=radius)


def _turned(share: Floats, steps: int) -> Floats:
    """Return rays to a hole from the one to its middle on, of a radius over its distance [rad]."""
    return np.asarray(np.arcsin(share * np.sin(np.arange(-steps, steps + 1) * (math.pi / 2.0 / steps))))


def _rim(away: float, radius: float, rays: Complexes) -> Complexes:
    """Return the corners of a hole at a distance along x on rising rays, the first and the last of which touch it."""
    root = np.sqrt(np.maximum(radius**2 - (away * rays.imag) ** 2, 0.0))
    root[[0, -1]] = 0.0
    along = away * rays.real
    return np.concatenate([(along + root) * rays, ((along - root) * rays)[-2:0:-1]])


def bored_ends(outline: Complexes, inner: Complexes, span: tuple[float, float], bores: Bores) -> Surface:
    """Return both ends of a plate, alike, and the bores between them.

    Args:
        outline: Corners of the plate on rays from its axis, also on all of `Bores.rays`, x + i y, shape (n,) [m].
        inner: Of its hole on the same rays; all zero: none [m].
        span: Where it begins and ends [m].
        bores: Through it.

    Source: between two rays every piece is convex, so that any walk from the outline inwards makes its triangles.
    """
    count, rims = len(outline), list[Complexes]()
    points: list[Complexes] = [outline, inner]
    upper, lower = dict[int, int](), dict[int, int]()
    for middle in bores.middles:
        rays = outline * np.conj(middle) / np.abs(outline * middle)
        seen = np.flatnonzero((np.abs(rays.imag) <= bores.radius / abs(middle) * (1.0 + 1e-9)) & (rays.real > 0.0))
        seen = seen[np.argsort(rays[seen].imag)]
        start, size = sum(map(len, points)), len(seen)
        rims.append(_rim(abs(middle), bores.radius, rays[seen]) * middle / abs(middle))
        points.append(rims[-1])
        upper |= {int(ray): start + k for k, ray in enumerate(seen)}
        lower |= {int(ray): start + (2 * (size - 1) - k) % (2 * (size - 1)) for k, ray in enumerate(seen)}
    flat = np.concatenate(points)
    pole = 0 if np.any(inner) else None
    triangles = np.array(list(_between_rays(count, upper, lower, pole)), dtype=np.int64)
    pieces = _walls(*span, np.stack([np.stack([rim.real, rim.imag], axis=1) for rim in rims]))
    for height, way in zip(span, (-1.0, 1.0), strict=True):
        corners = np.column_stack([flat.real, flat.imag, np.full(len(flat), height)])
        normals = np.tile([0.0, 0.0, way], (len(flat), 1))
        pieces.append(Surface(corners, normals, triangles if way > 0.0 else triangles[:, ::-1]))
    return joined(pieces)


def _between_rays(
    count: int, upper: Mapping[int, int], lower: Mapping[int, int], pole: int | None
) -> Iterator[tuple[int, int, int]]:
    """Yield the triangles of a face: outline from 0, its hole from `count` on, or its middle there, and holes."""
    for here in range(count):
        there = (here + 1) % count
        ends = [count + ray if pole is not None else count for ray in (here, there)]
        if here in upper and there in upper and abs(upper[here] - upper[there]) == 1:
            yield from _walked([here, upper[here]], [there, upper[there]])
            yield from _walked([lower[here], ends[0]], [lower[there], ends[1]])
        else:
            ways = [
                [ray, *([upper[ray]] if ray in upper else []), end]
                for ray, end in zip((here, there), ends, strict=True)
            ]
            yield from _walked(*ways)


def _walked(left: Sequence[int], right: Sequence[int]) -> Iterator[tuple[int, int, int]]:
    """Yield the triangles between corners on two rays, from the outline inwards."""
    i, j = 0, 0
    while i + 1 < len(left) or j + 1 < len(right):
        on_left = j + 1 == len(right) or (i + 1 < len(left) and i * len(right) <= j * len(left))
        triangle = (left[i], right[j], left[i + 1] if on_left else right[j + 1])
        i, j = (i + 1, j) if on_left else (i, j + 1)
        if len(set(triangle)) == 3:
            yield triangle


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
    return joined([*pieces, *_walls(min(faces), max(faces), _rims(holes, segments))])


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


def _walls(low: float, high: float, rims: Floats) -> list[Surface]:
    """Return the walls of all holes, which look towards their middles."""
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
