"""Closed surfaces of triangles: what a body is made of, and what it encloses.

Vertices are shared along smooth surfaces and doubled along edges, where the normals differ; points that coincide are
equal to the last bit, so that who joins them by place finds every edge twice.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints, following
from gearwright.showing import Shown
from gearwright.units import Volume


@dataclass(frozen=True, repr=False)
class Surface(Shown):
    """Triangles of one body, about its own axis z, the middle of its width at z = 0."""

    points: Floats
    """Places of the vertices [m], shape (n, 3)."""
    normals: Floats
    """Unit vectors out of the body [-], shape (n, 3)."""
    triangles: Ints
    """Vertices of every triangle, counter-clockwise seen from outside, shape (m, 3)."""

    @property
    def volume(self) -> Volume:
        """What it encloses [m³]."""
        first, second, third = (self.points[self.triangles[:, k]] for k in range(3))
        return float(np.einsum("ij,ij->", first, np.cross(second, third)) / 6.0)

    @property
    def reach(self) -> float:
        """Largest distance of a vertex from the axis [m]."""
        return float(np.max(np.hypot(self.points[:, 0], self.points[:, 1])))


def joined(pieces: Sequence[Surface]) -> Surface:
    """Return pieces as one surface.

    Args:
        pieces: That close each other.
    """
    starts = np.cumsum([0, *(len(piece.points) for piece in pieces)])
    return Surface(
        np.concatenate([piece.points for piece in pieces]),
        np.concatenate([piece.normals for piece in pieces]),
        np.concatenate([piece.triangles + start for piece, start in zip(pieces, starts, strict=False)]),
    )


def shifted(piece: Surface, by: Sequence[float]) -> Surface:
    """Return a surface elsewhere.

    Args:
        piece: The surface.
        by: How far [m].
    """
    return Surface(piece.points + np.asarray(by), piece.normals, piece.triangles)


class Edges(NamedTuple):
    """How the triangles of a surface hang together where vertices at one place are one."""

    open: int
    """Edges that are not passed once each way [-]."""
    euler: int
    """Euler's number: vertices less edges plus triangles; 2 of a ball, 0 of a ring [-]."""


def edges_of(surface: Surface) -> Edges:
    """Return whether a surface is closed, and its Euler number.

    Args:
        surface: The surface.

    Source: a closed oriented surface passes every edge once each way; χ = V − E + F.
    """
    same, corners = _places(surface.points)
    faces = same[surface.triangles].astype(np.int64)
    faces = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])]
    start, end = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    counts = np.unique(np.minimum(start, end) * corners + np.maximum(start, end), return_counts=True)[1]
    ways, times = np.unique(start * corners + end, return_counts=True)
    backwards = ways % corners * corners + ways // corners
    wrong = int(np.sum(times != 1)) + int(np.sum(~np.isin(backwards, ways)))
    return Edges(wrong + int(np.sum(counts != 2)), len(np.unique(faces)) - len(counts) + len(faces))


def _places(points: Floats) -> tuple[Ints, int]:
    """Return a number for every point, one for all at one place, and how many places there are."""
    order = np.lexsort(points.T)
    starts = np.r_[True, np.any(np.diff(points[order], axis=0) != 0.0, axis=1)]
    numbers = np.empty(len(points), dtype=np.int64)
    numbers[order] = np.cumsum(starts) - 1
    return numbers, int(np.sum(starts))


def circle(segments: int) -> Floats:
    """Return the angles of the corners of a circle [rad], shape (segments,).

    Args:
        segments: How many.
    """
    return np.arange(segments, dtype=np.float64) * (2.0 * math.pi / segments)


def around_hole(radius: float, segments: int) -> float:
    """Return the radius of the corners of a hole whose sides touch a circle: a round body of that radius fits into it.

    Args:
        radius: Of the circle [m].
        segments: How many corners.
    """
    return radius / math.cos(math.pi / segments)


def around(radius: float, height: float, segments: int) -> Floats:
    """Return the corners of a circle about the axis [m], shape (segments, 3).

    Args:
        radius: [m].
        height: z [m].
        segments: How many corners.
    """
    angle = circle(segments)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(segments, height)], axis=1)


def revolved(profile: Sequence[tuple[float, float]], segments: int) -> Surface:
    """Return the surface that a chain of straight lines sweeps about the axis, with edges at its corners.

    Args:
        profile: z and radius of its points [m], with the body to the right of the way from each to the next; a chain
            whose ends meet, or lie on the axis, closes the surface.
        segments: Corners of a circle.
    """
    pieces = []
    angle = circle(segments)
    for (low, inner), (high, outer) in pairwise(profile):
        length = math.hypot(high - low, outer - inner)
        if length == 0.0 or (inner == 0.0 and outer == 0.0):
            continue
        axial, radial = -(outer - inner) / length, (high - low) / length
        points = np.concatenate([around(inner, low, segments), around(outer, high, segments)])
        normal = np.stack([radial * np.cos(angle), radial * np.sin(angle), np.full(segments, axial)], axis=1)
        here, there = np.arange(segments), following(np.arange(segments))
        first = np.stack([here, there, there + segments], axis=1)
        second = np.stack([here, there + segments, here + segments], axis=1)
        triangles = second if inner == 0.0 else first if outer == 0.0 else np.concatenate([first, second])
        pieces.append(Surface(points, np.concatenate([normal, normal]), triangles))
    return joined(pieces) if pieces else Surface(np.empty((0, 3)), np.empty((0, 3)), np.empty((0, 3), dtype=np.int64))


def strip(outer: Floats, inner: Floats) -> Ints:
    """Return triangles between two closed loops about one axis, counter-clockwise seen from +z.

    Args:
        outer: Angles of the outer loop's points, rising but for small steps back [rad], shape (n,).
        inner: Of the inner loop, shape (m,); its points are numbered after the outer ones.

    Source: both are walked in order of angle; each step makes one triangle.
    """
    n, m = len(outer), len(inner)
    keys = [np.maximum.accumulate(np.append(angle[1:], angle[0] + 2.0 * math.pi)) for angle in (outer, inner)]
    order = np.argsort(np.concatenate(keys), kind="stable")
    is_outer = order < n
    i: Ints = np.cumsum(is_outer) - is_outer
    j: Ints = np.cumsum(~is_outer) - ~is_outer
    here, other = i % n, n + j % m
    onward = np.where(is_outer, (i + 1) % n, n + (j + 1) % m)
    return np.stack([here, onward, other], axis=1)
