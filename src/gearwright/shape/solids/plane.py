"""Triangles of plane faces with holes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from gearwright.arrays import Bools, Complexes, Floats, Ints, following

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
