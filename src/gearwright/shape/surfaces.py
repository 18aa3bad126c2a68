"""Closed surfaces of triangles, plane faces with holes, and plates and webs with round holes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, Complexes, Floats, Ints, Shown, Volume, following

# ----------------------------------------------------------------------------------------------------------------------
# Closed surfaces of triangles: what a body is made of, and what it encloses.
#
# Vertices are shared along smooth surfaces and doubled along edges, where the normals differ; points that coincide are
# equal to the last bit, so that who joins them by place finds every edge twice.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Triangles of plane faces with holes.
# ----------------------------------------------------------------------------------------------------------------------


NONE = 1e-13
"""Twice an area that is none [m²]."""


def plane_triangles(loops: Sequence[Floats]) -> Ints:
    """Return triangles of a plane face, counter-clockwise, by numbers of all corners one loop after the other.

    Args:
        loops: Its outline, then its holes, apart from each other and from it, all convex, counter-clockwise [m].

    Source: a fan; between two loops supports in the directions of edges; else ears are cut of the outline that bridges
        have joined with its holes (Meisters, two-ears theorem).
    """
    first = np.arange(1, len(loops[0]) - 1)
    if len(loops) == 1:
        return np.stack([np.zeros_like(first), first, first + 1], axis=1)
    if len(loops) == 2:
        return _between(loops[0], loops[1])
    return _ears(np.concatenate(loops), _bridged(loops))


def _between(outer: Floats, inner: Floats) -> Ints:
    """Return triangles between two convex loops: every edge with the corner of the other loop that lies furthest out.

    Edges of both are walked in order of their directions.
    """
    n, m = len(outer), len(inner)
    ways = [following(loop) - loop for loop in (outer, inner)]
    angle = np.concatenate([np.mod(np.arctan2(way[:, 1], way[:, 0]), 2.0 * np.pi) for way in ways])
    order = np.argsort(angle, kind="stable")
    is_outer = order < n
    i, j = int(np.argmin(angle[:n])), int(np.argmin(angle[n:]))
    here: Ints = (i + np.cumsum(is_outer) - is_outer) % n
    there: Ints = (j + np.cumsum(~is_outer) - ~is_outer) % m
    onward = np.where(is_outer, (here + 1) % n, n + (there + 1) % m)
    return np.stack([here, onward, n + there], axis=1)


def _bridged(loops: Sequence[Floats]) -> list[int]:
    """Return one loop of numbers of corners that goes around all holes, over the shortest bridges there and back.

    Source: Prim's tree: the nearest hole that is not joined yet, from a corner of what is.
    """
    points = [complex(*point) for loop in loops for point in loop.tolist()]
    starts = np.cumsum([0, *(len(loop) for loop in loops)]).tolist()
    numbers = [list(range(start, end)) for start, end in pairwise(starts)]
    way, left, nearest, last = numbers[0], set(range(1, len(loops))), dict[int, tuple[float, int, int]](), 0
    while left:
        for k in left:
            far = np.linalg.norm(loops[last][:, None] - loops[k][None, :], axis=2)
            at, corner = divmod(int(np.argmin(far)), len(loops[k]))
            found = (float(far[at, corner]), numbers[last][at], corner)
            nearest[k] = min(nearest.get(k, found), found)
        last = min(left, key=nearest.__getitem__)
        _, foot, corner = nearest[last]
        left.remove(last)
        around = [*numbers[last][corner::-1], *numbers[last][:corner:-1], numbers[last][corner]]
        feet = [k for k, number in enumerate(way) if number == foot]
        at = next((k for k in feet if _sees(points, way, k, around[0])), feet[0])
        way = [*way[: at + 1], *around, *way[at:]]
    return way


def _sees(points: Sequence[complex], way: Sequence[int], at: int, other: int) -> bool:
    """Tell whether a bridge to another corner leaves a loop on its inside: several may stand on one corner."""
    here = points[way[at]]
    back, onward, across = (points[k] - here for k in (way[at - 1], way[(at + 1) % len(way)], other))
    if (onward.conjugate() * back).imag > 0.0:  # less than half a turn lies inside
        return (onward.conjugate() * across).imag > 0.0 < (across.conjugate() * back).imag
    return (back.conjugate() * across).imag <= 0.0 or (across.conjugate() * onward).imag <= 0.0


def _ears(points: Floats, way: list[int]) -> Ints:
    """Return the triangles of a loop that may touch itself along bridges: ears apart from each other go at once."""
    left, places, found = np.array(way), points[:, 0] + 1j * points[:, 1], list[Ints]()
    while len(left) > 3:
        here = places[left]
        corners = np.stack([np.roll(here, 1), here, following(here)])
        area = _turns(*corners)
        ears = np.flatnonzero(area > NONE)
        ears = ears[~_holds(corners[:, ears], here[area <= NONE])]
        if not len(ears):  # corners on one line, or at one place
            ears = np.array([np.argmin(np.abs(area))])
        cut = _apart(ears.tolist(), len(left))
        found.append(np.stack([left[cut - 1], left[cut], left[(cut + 1) % len(left)]], axis=1))
        left = np.delete(left, cut)
    return np.concatenate([*found, left[None]])


def _apart(ears: Sequence[int], count: int) -> Ints:
    """Return ears of which no two are neighbours in a loop of so many corners, and that leave a triangle."""
    found: list[int] = []
    for ear in ears:
        if not found or (ear > found[-1] + 1 and ear - found[0] < count - 1):
            found.append(ear)
    return np.array(found[: count - 3])


def _turns(one: Complexes, two: Complexes, three: Complexes) -> Floats:
    """Return twice the areas of triangles, positive counter-clockwise [m²]."""
    return np.asarray(((two - one).conjugate() * (three - one)).imag)


def _holds(corners: Complexes, points: Complexes) -> Bools:
    """Return which triangles, shape (3, n), have any of some points inside, not on their edges."""
    one, two, three = corners[:, :, None]
    inside = np.ones((corners.shape[1], len(points)), dtype=bool)
    for here, there in ((one, two), (two, three), (three, one)):
        inside &= _turns(here, there, points) > NONE
    return np.asarray(inside.any(axis=1))


# ----------------------------------------------------------------------------------------------------------------------
# Webs and plates with round holes: their faces around the holes, and the walls of the holes.
# ----------------------------------------------------------------------------------------------------------------------


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
