"""Chambers of a housing, and what sections along a way cut out of their metal."""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, Ints, following
from gearwright.shape.surfaces import Surface, around, around_hole, joined, plane_triangles

# ----------------------------------------------------------------------------------------------------------------------
# Chambers of a housing: a wall around a convex cross-section, with a plate that has holes at either end.
# ----------------------------------------------------------------------------------------------------------------------


ROUND = 48
"""Corners of a round hole [-]."""
SQUARE = 1e-9
"""How far the ends of a side may stand from square to what goes through it [m]."""


class End(NamedTuple):
    """A plate across a chamber, its outside flush with the end of the wall."""

    thickness: float
    """[m]"""
    holes: tuple[Floats, ...]
    """Outlines through it, convex, counter-clockwise, apart from each other [m], shape (n, 2) each."""


class Opening(NamedTuple):
    """A round hole through one side of a wall."""

    way: Floats
    """Unit vector square to that side, out of the chamber [-], shape (2,)."""
    middle: Floats
    """A point of its axis within the chamber, shape (3,) [m]."""
    radius: float
    """[m]"""

    @property
    def along(self) -> Floats:
        """Unit vector along the side, counter-clockwise around the chamber [-], shape (2,)."""
        return np.array([-self.way[1], self.way[0]])


class Chamber(NamedTuple):
    """A piece of a housing about z."""

    outer: Floats
    """Outline of the wall, convex, counter-clockwise [m], shape (n, 2)."""
    inner: Floats
    """Its inside, corner by corner [m], shape (n, 2)."""
    span: tuple[float, float]
    """Where it begins and ends along z [m]."""
    ends: tuple[End | None, End | None] = (None, None)
    """Plates; None: open."""
    openings: tuple[Opening, ...] = ()
    """Each in a side of its own, between the plates."""


def round_hole(middle: Sequence[float] | Floats, radius: float) -> Floats:
    """Return the outline of a hole into which a round body of that radius fits.

    Args:
        middle: x and y [m].
        radius: [m].
    """
    return np.asarray(around(around_hole(radius, ROUND), 0.0, ROUND)[:, :2] + np.asarray(middle))


def chamber_surface(chamber: Chamber) -> Surface:
    """Return the triangles of a chamber.

    Args:
        chamber: The chamber.
    """
    pieces = [_wall(chamber.outer, chamber.span, chamber.openings)]
    inside = list(chamber.span)
    for k, (end, way) in enumerate(zip(chamber.ends, (-1.0, 1.0), strict=True)):
        place = chamber.span[k]
        if end is None:
            pieces.append(_face(chamber.outer, (chamber.inner,), place, way))
            continue
        inside[k] = place - way * end.thickness
        pieces += [_face(chamber.outer, end.holes, place, way), _face(chamber.inner, end.holes, inside[k], -way)]
        pieces += [_turned(_wall(hole, _ordered(place, inside[k]))) for hole in end.holes]
    pieces.append(_turned(_wall(chamber.inner, (inside[0], inside[1]), chamber.openings)))
    for opening in chamber.openings:
        for loop, span, turned in ((chamber.outer, chamber.span, False), (chamber.inner, inside, True)):
            side = _side(loop, (span[0], span[1]), opening)
            pieces.append(_turned(side) if turned else side)
        pieces.append(_bore(opening, *(rim_of(opening, loop) for loop in (chamber.inner, chamber.outer))))
    return joined(pieces)


def side_of(loop: Floats, way: Floats) -> int:
    """Return the number of the side of a loop that looks in a direction.

    Args:
        loop: Convex, counter-clockwise [m], shape (n, 2).
        way: Unit vector [-], shape (2,).
    """
    along = following(loop) - loop
    out = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.maximum(
        np.linalg.norm(along, axis=1, keepdims=True), 1e-30
    )
    return int(np.argmax(out @ way))


def has_room(chamber: Chamber, opening: Opening) -> bool:
    """Tell whether both sides of a wall are square to an opening, and reach around it.

    Args:
        chamber: The chamber.
        opening: A hole through one of its sides.
    """
    low, high = (place - way * (end.thickness if end else 0.0)
                 for place, end, way in zip(chamber.span, chamber.ends, (-1.0, 1.0), strict=True))  # fmt: skip
    at, wide = float(opening.middle[:2] @ opening.along), around_hole(opening.radius, ROUND)
    for loop in (chamber.outer, chamber.inner):
        k = side_of(loop, opening.way)
        ends = loop[[k, (k + 1) % len(loop)]]
        if abs(float((ends[1] - ends[0]) @ opening.way)) > SQUARE or not ends[0] @ opening.along < at - wide:
            return False
        if not at + wide < ends[1] @ opening.along:
            return False
    return bool(low < opening.middle[2] - wide and opening.middle[2] + wide < high)


def rim_of(opening: Opening, loop: Floats) -> Floats:
    """Return the corners of an opening in a side of a loop, counter-clockwise from outside [m], shape (n, 3).

    Args:
        opening: Through the side that it is square to.
        loop: Outline or inside of the wall [m], shape (n, 2).
    """
    flat = around(around_hole(opening.radius, ROUND), 0.0, ROUND)[:, :2]
    foot = float(loop[side_of(loop, opening.way)] @ opening.way) * opening.way
    at = float(opening.middle[:2] @ opening.along)
    across = foot + (at + flat[:, :1]) * opening.along
    return np.column_stack([across, opening.middle[2] + flat[:, 1]])


def _side(loop: Floats, span: tuple[float, float], opening: Opening) -> Surface:
    """Return a side of a wall with its opening, seen from outside."""
    k, rim = side_of(loop, opening.way), rim_of(opening, loop)
    ends = loop[[k, (k + 1) % len(loop)]]
    corners = np.array([[*ends[0], span[0]], [*ends[1], span[0]], [*ends[1], span[1]], [*ends[0], span[1]]])
    points = np.concatenate([corners, rim])
    flat = np.column_stack([points[:, :2] @ opening.along, points[:, 2]])
    return Surface(points, np.tile([*opening.way, 0.0], (len(points), 1)), plane_triangles([flat[:4], flat[4:]]))


def _bore(opening: Opening, inner: Floats, outer: Floats) -> Surface:
    """Return the wall of an opening, which looks towards its axis."""
    count = len(inner)
    here, there = np.arange(count), following(np.arange(count))
    inwards = inner.mean(axis=0) - inner
    inwards /= np.linalg.norm(inwards, axis=1, keepdims=True)
    triangles = np.concatenate([np.stack([here, there + count, there], axis=1),
                                np.stack([here, here + count, there + count], axis=1)])  # fmt: skip
    return Surface(np.concatenate([inner, outer]), np.concatenate([inwards, inwards]), triangles)


def chamber_volume(chamber: Chamber) -> float:
    """Return the volume of a chamber's metal [m³].

    Args:
        chamber: The chamber.
    """
    room = _area(chamber.inner)
    found = (_area(chamber.outer) - room) * (chamber.span[1] - chamber.span[0])
    plates = (end.thickness * (room - sum(map(_area, end.holes))) for end in chamber.ends if end is not None)
    bored = 0.0
    for opening in chamber.openings:
        far = [float(loop[side_of(loop, opening.way)] @ opening.way) for loop in (chamber.outer, chamber.inner)]
        bored += (far[0] - far[1]) * _area(around(around_hole(opening.radius, ROUND), 0.0, ROUND)[:, :2])
    return found + sum(plates) - bored


def _area(loop: Floats) -> float:
    after = following(loop)
    return float(np.sum(loop[:, 0] * after[:, 1] - loop[:, 1] * after[:, 0]) / 2.0)


def depth_in(points: Floats, chamber: Chamber, skin: float = 0.0) -> float:
    """Return how deep the deepest of some points stands in the metal of a chamber, from its room or its holes [m].

    Args:
        points: About the chamber's own z [m], shape (n, 3).
        chamber: The chamber.
        skin: How near to the outside points are not seen: what touches a wall from outside is not in it [m].
    """
    flat, height = points[:, :2], points[:, 2]
    past = _outside(flat, chamber.inner)
    for end, place, way in zip(chamber.ends, chamber.span, (-1.0, 1.0), strict=True):
        if end is not None:
            into = way * (height - place) + end.thickness
            through = np.min([_outside(flat, hole) for hole in end.holes], axis=0) if end.holes else np.inf
            past = np.maximum(past, np.minimum(into, through))
    for opening in chamber.openings:
        off = points - opening.middle
        beside = np.hypot(off[:, :2] @ opening.along, off[:, 2]) - opening.radius
        past = np.where(off[:, :2] @ opening.way > 0.0, np.minimum(past, beside), past)
    inside = (_outside(flat, chamber.outer) < -skin) & (height > chamber.span[0]) & (height < chamber.span[1])
    return float(np.max(past[inside], initial=0.0))


def _outside(points: Floats, loop: Floats) -> Floats:
    """Return how far points lie outside of a convex loop; inside of it negative [m]."""
    along = following(loop) - loop
    out = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.linalg.norm(along, axis=1, keepdims=True)
    return np.asarray(np.max(points @ out.T - np.sum(loop * out, axis=1), axis=1))


def _ordered(one: float, other: float) -> tuple[float, float]:
    return min(one, other), max(one, other)


def _turned(surface: Surface) -> Surface:
    """Return a surface with its other side out."""
    return Surface(surface.points, -surface.normals, surface.triangles[:, ::-1])


def _wall(loop: Floats, span: tuple[float, float], openings: Sequence[Opening] = ()) -> Surface:
    """Return what a loop sweeps along z, shaded as if it were round, without sides that have openings."""
    count = len(loop)
    points = np.concatenate([np.column_stack([loop, np.full(count, place)]) for place in span])
    along = following(loop) - loop
    length = np.linalg.norm(along, axis=1, keepdims=True)
    out = np.where(length > 0.0, np.stack([along[:, 1], -along[:, 0]], axis=1) / np.maximum(length, 1e-30), 0.0)
    mean = out + np.roll(out, 1, axis=0)
    mean = np.where(np.linalg.norm(mean, axis=1, keepdims=True) > 0.0, mean, loop - loop.mean(axis=0))
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    normals = np.tile(np.column_stack([mean, np.zeros(count)]), (2, 1))
    here, there = np.arange(count), following(np.arange(count))
    kept = np.setdiff1d(here, [side_of(loop, opening.way) for opening in openings])
    here, there = here[kept], there[kept]
    low, high = np.stack([here, there, there + count], axis=1), np.stack([here, there + count, here + count], axis=1)
    return Surface(points, normals, np.concatenate([low, high]))


def _face(outer: Floats, holes: Sequence[Floats], place: float, way: float) -> Surface:
    """Return a flat face with holes that looks along ±z."""
    loops = [outer, *holes]
    flat = np.concatenate(loops)
    triangles = plane_triangles(loops)
    points = np.column_stack([flat, np.full(len(flat), place)])
    normals = np.tile([0.0, 0.0, way], (len(flat), 1))
    return Surface(points, normals, triangles if way > 0.0 else triangles[:, ::-1])


# ----------------------------------------------------------------------------------------------------------------------
# Sections of chambers: what a way across them, of straight legs that all hold their z, cuts out of their metal.
#
# In such a section every chamber is a number of rectangles, as exact as its numbers: z one way, the way's length the
# other. What several bodies cut together is their union, with its outlines.
# ----------------------------------------------------------------------------------------------------------------------


ALIKE = 1e-7
"""Places that are nearer to each other are one [m]."""
SAME_WAY = 1e-9
"""How far a leg may turn from the axis of an opening that it is cut along [-]."""
STEPS = ((1, 0), (0, 1), (-1, 0), (0, -1))
"""Ways along edges of cells, each a quarter turn left of the one before."""


class Leg(NamedTuple):
    """A straight piece of a way across chambers, in the plane square to their z."""

    low: float
    """Where it begins along the way [m]; −inf of the first one."""
    high: float
    """Where it ends [m]; inf of the last one."""
    foot: Floats
    """Its point at 0 along the way, on it or beyond its ends [m], shape (2,)."""
    along: Floats
    """Unit vector [-], shape (2,)."""


class Rectangle(NamedTuple):
    """Metal in a section."""

    start: float
    """Along z [m]."""
    end: float
    """[m]"""
    low: float
    """Along the way [m]."""
    high: float
    """[m]"""


class Cut(NamedTuple):
    """The union of rectangles: what is cut of one part."""

    loops: tuple[tuple[tuple[float, float], ...], ...]
    """Its outlines, z and place along the way [m], metal to the left: around it counter-clockwise, around its holes
    clockwise."""
    rectangles: tuple[Rectangle, ...]
    """That fill it, none over another."""


Span = tuple[float, float]


def spans_in(loop: Floats, legs: Sequence[Leg]) -> list[Span]:
    """Return where a way is inside of a convex loop, from and to along the way [m].

    Args:
        loop: Counter-clockwise [m], shape (n, 2).
        legs: In order, one after the other.
    """
    along = following(loop) - loop
    out = np.stack([along[:, 1], -along[:, 0]], axis=1)
    reach = np.sum(loop * out, axis=1)
    found: list[Span] = []
    for leg in legs:
        rate, room = out @ leg.along, reach - out @ leg.foot
        flat = np.abs(rate) < 1e-15
        if np.any(room[flat] < 0.0):
            continue
        limits = room[~flat] / rate[~flat]
        low = max(leg.low, float(np.max(limits[rate[~flat] < 0.0], initial=-math.inf)))
        high = min(leg.high, float(np.min(limits[rate[~flat] > 0.0], initial=math.inf)))
        if high - low > ALIKE:
            if found and low - found[-1][1] < ALIKE:
                low = found.pop()[0]
            found.append((low, high))
    return found


def without(spans: Iterable[Span], taken: Iterable[Span]) -> list[Span]:
    """Return what is left of some spans [m].

    Args:
        spans: Apart from each other [m].
        taken: What is not part of them [m].
    """
    found = list(spans)
    for start, end in taken:
        pieces = [piece for low, high in found for piece in ((low, min(high, start)), (max(low, end), high))]
        found = [(low, high) for low, high in pieces if high - low > ALIKE]
    return found


def cut_chamber(chamber: Chamber, legs: Sequence[Leg]) -> list[Rectangle] | None:
    """Return the metal of a chamber that a way cuts; None where the way meets an opening not along its axis.

    Args:
        chamber: The chamber.
        legs: Of the way across it.
    """
    outer, inner = spans_in(chamber.outer, legs), spans_in(chamber.inner, legs)
    found = [Rectangle(*chamber.span, *span) for span in without(outer, inner)]
    for end, place, way in zip(chamber.ends, chamber.span, (-1.0, 1.0), strict=True):
        if end is not None:
            holes = [span for hole in end.holes for span in spans_in(hole, legs)]
            thick = sorted((place, place - way * end.thickness))
            found += [Rectangle(thick[0], thick[1], *span) for span in without(inner, holes)]
    for opening in chamber.openings:
        for leg in legs:
            cleared = _cleared(chamber, opening, leg)
            if cleared is None:
                return None
            found = [piece for one in found for piece in (_beside(one, cleared) if cleared else (one,))]
    return found


def _cleared(chamber: Chamber, opening: Opening, leg: Leg) -> Rectangle | tuple[()] | None:
    """Return what an opening takes of a leg's section; nothing where it does not meet it, None where not squarely."""
    out, beside = float(leg.along @ opening.way), float(leg.along @ opening.along)
    faces = [float(loop[side_of(loop, opening.way)] @ opening.way) for loop in (chamber.inner, chamber.outer)]
    off = float((leg.foot - opening.middle[:2]) @ opening.along)
    if abs(beside) > SAME_WAY:
        if abs(out) > SAME_WAY:
            places = [(face - float(leg.foot @ opening.way)) / out for face in faces]
            low, high = max(min(places), leg.low), min(max(places), leg.high)
            near = low < high and min(abs(off + beside * at) for at in (low, high)) < opening.radius
            return None if near else ()
        height = float(leg.foot @ opening.way)
        return None if faces[0] < height < faces[1] else ()
    if abs(off) >= opening.radius:
        return ()
    half = math.sqrt(opening.radius**2 - off**2)
    places = sorted((face - float(leg.foot @ opening.way)) / out for face in faces)
    low, high = max(places[0], leg.low), min(places[1], leg.high)
    if high - low < ALIKE:
        return ()
    return Rectangle(float(opening.middle[2]) - half, float(opening.middle[2]) + half, low, high)


def bored(rectangles: Iterable[Rectangle], holes: Sequence[Rectangle]) -> list[Rectangle]:
    """Return what holes leave of some rectangles.

    Args:
        rectangles: Metal.
        holes: What is not.
    """
    found = list(rectangles)
    for hole in holes:
        found = [piece for one in found for piece in _beside(one, hole)]
    return found


def _beside(one: Rectangle, taken: Rectangle) -> Iterator[Rectangle]:
    """Yield what is left of a rectangle."""
    start, end = max(one.start, taken.start), min(one.end, taken.end)
    low, high = max(one.low, taken.low), min(one.high, taken.high)
    if start >= end or low >= high:
        yield one
        return
    parts = (
        Rectangle(one.start, start, one.low, one.high), Rectangle(end, one.end, one.low, one.high),
        Rectangle(start, end, one.low, low), Rectangle(start, end, high, one.high),
    )  # fmt: skip
    yield from (part for part in parts if part.end - part.start > ALIKE and part.high - part.low > ALIKE)


def united(rectangles: Sequence[Rectangle], joints: Sequence[float] = ()) -> list[Cut]:
    """Return the union of rectangles, in pieces between joints.

    Args:
        rectangles: In any order, over each other or not.
        joints: Places along z at which one part ends and the next one begins [m].
    """
    places = _apart([*(place for one in rectangles for place in one[:2]), *joints])
    levels = _apart([level for one in rectangles for level in one[2:]])
    filled = np.zeros((max(len(places) - 1, 0), max(len(levels) - 1, 0)), dtype=bool)
    for one in rectangles:
        start, end = (int(np.argmin(np.abs(places - place))) for place in one[:2])
        low, high = (int(np.argmin(np.abs(levels - level))) for level in one[2:])
        filled[start:end, low:high] = True
    edges = [0, *sorted(int(np.argmin(np.abs(places - joint))) for joint in joints), len(places) - 1]
    found = []
    for first, last in pairwise(edges):
        own = np.zeros_like(filled)
        own[first:last] = filled[first:last]
        if own.any():
            found.append(Cut(tuple(_loops(own, places, levels)), tuple(_filling(own, places, levels))))
    return found


def _apart(values: Sequence[float]) -> Floats:
    """Return values in order, one where several coincide."""
    ordered = np.sort(np.asarray(values, dtype=float))
    kept = np.concatenate([[True], np.diff(ordered) > ALIKE]) if len(ordered) else np.zeros(0, dtype=bool)
    return np.asarray(ordered[kept])


def _filling(filled: Bools, places: Floats, levels: Floats) -> Iterator[Rectangle]:
    """Yield rectangles that fill cells: each as long along z as can be, then as far along the way."""
    left = filled.copy()
    for column, row in np.argwhere(filled).tolist():
        if not left[column, row]:
            continue
        end = column
        while end < len(left) and left[end, row]:
            end += 1
        high = row + 1
        while high < left.shape[1] and left[column:end, high].all():
            high += 1
        left[column:end, row:high] = False
        yield Rectangle(*(float(one) for one in (places[column], places[end], levels[row], levels[high])))


def _loops(filled: Bools, places: Floats, levels: Floats) -> Iterator[tuple[tuple[float, float], ...]]:
    """Yield the outlines of cells, with a corner only where they turn; cells that touch at a corner alone are apart."""
    edges = _edges(np.pad(filled, 1))
    while edges:
        start = next(iter(edges))
        at, way, corners = start[0], start[1], list[tuple[float, float]]()
        while (at, way) in edges:
            del edges[at, way]
            at = (at[0] + STEPS[way][0], at[1] + STEPS[way][1])
            turned = next((turn for turn in (1, 0, 3) if (at, (way + turn) % 4) in edges), None)
            turn = (start[1] - way) % 4 if turned is None else turned
            if turn:
                corners.append((float(places[at[0]]), float(levels[at[1]])))
            way = (way + turn) % 4
        yield tuple(corners)


def _edges(padded: Bools) -> dict[tuple[tuple[int, int], int], None]:
    """Return the edges of cells that others do not share, each by its first corner and its way, cells to its left."""
    inside = padded[1:-1, 1:-1]
    neighbours = ((padded[1:-1, :-2], 0, (0, 0)), (padded[2:, 1:-1], 1, (1, 0)),
                  (padded[1:-1, 2:], 2, (1, 1)), (padded[:-2, 1:-1], 3, (0, 1)))  # fmt: skip
    found = list[tuple[tuple[int, int], int]]()
    for beside, way, (across, up) in neighbours:
        cells: Ints = np.argwhere(inside & ~beside)
        found += [((column + across, row + up), way) for column, row in cells.tolist()]
    return dict.fromkeys(sorted(found))
