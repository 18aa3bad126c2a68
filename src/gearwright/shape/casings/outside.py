"""The outside of a housing's walls: where flanges leave them free, feet on them, and what stands in their way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, following
from gearwright.shape.casings.flanges import ENDS
from gearwright.shape.solids import Chamber
from gearwright.sizing import Sizing
from gearwright.sizing.casing.loops import ways_of
from gearwright.sizing.places import Run
from gearwright.sizing.shafts import holders_of

AIR = 1e-3
"""Between what stands on a wall and heads of screws, shafts and covers beside it, an assumption [m]."""


class Joint(NamedTuple):
    """A flange where it stands."""

    chamber: int
    """Number of the chamber that it is around, from 0 on."""
    place: float
    """Along the first shaft [m]."""
    half: Chamber
    """One half of it."""


class Gap(NamedTuple):
    """A free length of a wall."""

    chamber: int
    """Its number, from 0 on."""
    start: float
    """Beyond heads and ends of screws, along the first shaft [m]."""
    end: float
    """[m]"""
    low: float
    """Up to the face of the flange, between screws [m]."""
    high: float
    """[m]"""


class Foot(NamedTuple):
    """A place on a wall."""

    point: Floats
    """Across the first shaft [m], shape (2,)."""
    out: Floats
    """Square to the wall [-], shape (2,)."""

    @property
    def along(self) -> Floats:
        """Unit vector along the wall, counter-clockwise [-], shape (2,)."""
        return np.array([-self.out[1], self.out[0]])


class Taken(NamedTuple):
    """What stands on a wall."""

    foot: Foot
    span: tuple[float, float]
    """Along the first shaft [m]."""
    half: float
    """Half of its width along the wall [m]."""


class Rods(NamedTuple):
    """Cylinders in space: shafts as they are drawn, and covers."""

    origin: Floats
    """[m], shape (n, 3)."""
    along: Floats
    """[-], shape (n, 3)."""
    length: Floats
    """[m], shape (n,)."""
    radius: Floats
    """[m], shape (n,)."""

    def meet(self, points: Floats, half: float) -> Bools:
        """Tell which of several bodies stand in one of them, or too near to one, shape (m,).

        Args:
            points: Of each body, in the middle of its width [m], shape (m, n, 3).
            half: Half of that width [m].
        """
        off = points[:, :, None, :] - self.origin
        height = np.einsum("mnrk,rk->mnr", off, self.along)
        beside = np.linalg.norm(off - height[..., None] * self.along, axis=3)
        room = half + AIR
        inside: Bools = (height > -room) & (height < self.length + room) & (beside < self.radius + room)
        return np.asarray(inside.any(axis=(1, 2)))


def gaps_of(chambers: Sequence[Chamber], joints: Sequence[Joint], room: float = math.inf) -> Iterator[Gap]:
    """Yield the free lengths of all walls, from the first end on.

    Args:
        chambers: Of the housing.
        joints: Its flanges.
        room: How far out of a wall what stands on it reaches: flanges of wider chambers further out are not in its way
            [m].
    """
    for k, chamber in enumerate(chambers):
        low = start = chamber.span[0]
        for joint in sorted(joints, key=lambda joint: joint.place):
            thick, own = joint.half.span[1], joint.chamber == k
            before, behind = joint.place - ENDS[0] * thick - AIR, joint.place + ENDS[1] * thick + AIR
            if not own and _past(chamber.outer, joint.half.inner) > room:
                continue
            if behind < chamber.span[0] or before > chamber.span[1]:
                continue
            if before > start:
                yield Gap(k, start, before, low, joint.place - thick if own else before)
            start, low = max(start, behind), max(low, joint.place + thick if own else behind)
        if chamber.span[1] > start:
            yield Gap(k, start, chamber.span[1], low, chamber.span[1])


def _past(one: Floats, other: Floats) -> float:
    """Return how far another loop reaches beyond one, where it does least [m]."""
    ways = ways_of(48)
    return float(np.min((ways @ other.T).max(axis=1) - (ways @ one.T).max(axis=1)))


def feet_at(loop: Floats, points: Floats, half: float = 0.0) -> list[Foot]:
    """Return the places on sides of a loop that are nearest to points outside of it; none on sides that are too narrow.

    Args:
        loop: Convex, counter-clockwise [m], shape (n, 2).
        points: [m], shape (m, 2).
        half: How far from both ends of its side a place must be [m].
    """
    way = following(loop) - loop
    length = np.linalg.norm(way, axis=1)
    way = way / length[:, None]
    out = np.stack([way[:, 1], -way[:, 0]], axis=1)
    sides = np.argmax(points @ out.T - np.sum(loop * out, axis=1), axis=1)
    at = np.sum((points - loop[sides]) * way[sides], axis=1)
    at = np.clip(at, half, np.maximum(length[sides] - half, half))
    feet = loop[sides] + at[:, None] * way[sides]
    return [Foot(feet[k], out[side]) for k, side in enumerate(sides) if length[side] >= 2.0 * half]


def around_loop(loop: Floats, shares: Floats, *, half: bool = False) -> Floats:
    """Return points of a loop [m], shape (n, 2).

    Args:
        loop: Its corners [m], shape (m, 2).
        shares: Of its length, from its first corner on [-], shape (n,).
        half: Whether they count from the middle of its last side instead, in which rounds look along y.
    """
    closed = np.concatenate([loop, loop[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    before = float(np.linalg.norm(loop[0] - loop[-1])) / 2.0 if half else 0.0
    at = np.mod(shares * along[-1] - before, along[-1])
    return np.stack([np.interp(at, along, closed[:, 0]), np.interp(at, along, closed[:, 1])], axis=1)


def length_of(loop: Floats) -> float:
    """Return the length of a closed loop [m].

    Args:
        loop: Its corners [m], shape (n, 2).
    """
    return float(np.sum(np.linalg.norm(following(loop) - loop, axis=1)))


def is_open(chamber: Chamber, foot: Foot, half: float, span: tuple[float, float]) -> bool:
    """Tell whether an opening of a wall lies beneath what would stand on it.

    Args:
        chamber: The wall.
        foot: Where it would stand.
        half: Half of its width along the wall [m].
        span: From where to where along the first shaft [m].
    """
    for opening in chamber.openings:
        beside = abs(float((foot.point - opening.middle[:2]) @ opening.along)) - opening.radius
        past = max(span[0] - opening.middle[2], opening.middle[2] - span[1]) - opening.radius
        if float(foot.out @ opening.way) > 0.0 and beside < half + AIR and past < AIR:
            return True
    return False


def rods_of(sizing: Sizing, drawn: Sequence[Run]) -> Rods:
    """Return shafts and covers as cylinders.

    Args:
        sizing: As sized.
        drawn: Shafts as they are drawn.
    """
    frames = sizing.arrangement.frames
    steps = [(run.shaft, *step) for run in drawn for step in run.steps]
    steps += [(one.shaft, one.start, one.end, one.outer / 2.0) for one in holders_of(sizing) if one.kind == "cover"]
    along = np.array([frames[shaft].along for shaft, *_ in steps]).reshape(-1, 3)
    origin = np.array([frames[shaft].origin for shaft, *_ in steps]).reshape(-1, 3)
    numbers = np.array([numbers for _, *numbers in steps]).reshape(-1, 3)
    return Rods(origin + numbers[:, :1] * along, along, numbers[:, 1] - numbers[:, 0], numbers[:, 2])


def in_space(foot: Foot, x: float, up: float) -> Floats:
    """Return a place above a wall in space [m], shape (3,).

    Args:
        foot: On the wall.
        x: Along the first shaft [m].
        up: Out of the wall [m].
    """
    return np.array([x, *(foot.point + up * foot.out)])


def sheets_on(feet: Sequence[Foot], x: Floats, up: Floats) -> Floats:
    """Return points of rectangles that stand on walls in space [m], shape (n, 15, 3).

    Args:
        feet: Where, n of them.
        x: From where to where along the first shaft [m], shape (n, 2).
        up: How high out of the wall [m], shape (n,).
    """
    points, out = (np.array([getattr(foot, name) for foot in feet]) for name in ("point", "out"))
    along = x[:, :1] + np.linspace(0.0, 1.0, 5) * (x[:, 1:] - x[:, :1])
    high = np.linspace(0.1, 1.0, 3) * up[:, None]
    across = points[:, None] + high[:, :, None] * out[:, None]
    shape = (len(feet), 5, 3)
    found = np.empty((*shape, 3))
    found[..., 0], found[..., 1:] = along[:, :, None], across[:, None]
    return found.reshape(len(feet), 15, 3)


def turned(foot: Foot) -> Floats:
    """Return directions about a place on a wall as columns: out of it, along it, along the first shaft, shape (3, 3).

    Args:
        foot: The place.
    """
    return np.column_stack([[0.0, *foot.out], [0.0, *foot.along], [1.0, 0.0, 0.0]])


def quarter_turns(count: int) -> Floats:
    """Return angles of a half circle from −90° to 90° [rad], shape (n,).

    Args:
        count: How many parts it has.
    """
    return np.linspace(-math.pi / 2.0, math.pi / 2.0, count + 1)
