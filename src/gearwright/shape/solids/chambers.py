"""Chambers of a housing: a wall around a convex cross-section, with a plate that has holes at either end."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, following
from gearwright.shape.solids.plane import plane_triangles
from gearwright.shape.solids.surface import Surface, around, around_hole, joined

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
