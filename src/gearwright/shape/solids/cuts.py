"""Sections of chambers: what a way across them, of straight legs that all hold their z, cuts out of their metal.

In such a section every chamber is a number of rectangles, as exact as its numbers: z one way, the way's length the
other. What several bodies cut together is their union, with its outlines.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints, following
from gearwright.shape.solids.chambers import Chamber, Opening, side_of

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
