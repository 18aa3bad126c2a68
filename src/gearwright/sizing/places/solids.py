"""Clearance between bodies of revolution or boxes in space, and bodies on a common axis."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from itertools import chain, combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.base import Check, Floats, Kind, PartId, Role
from gearwright.sizing.result import Arrangement, Body
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# How much room there is between two bodies of revolution in space, or between one and a box.
#
# Two convex bodies are apart by the largest distance that any direction n shows between their shadows, max over n of
# n·(c_2 − c_1) − h_1(n) − h_2(n), with h the half extent in that direction: positive it is their distance, negative
# the least way by which one must be moved until they touch. Every direction gives a lower bound, so that no room is
# ever seen where there is none. A circle of radius r square to a has h = r |n − (n·a) a|; a body is the hull of its
# circles. Two cylinders side by side have a closed form. A body with a bore also clears what lies wholly within the
# bore.
#
# Source: separating planes of convex sets (Boyd and Vandenberghe, Convex Optimization, §2.5 and §8.2).
# ----------------------------------------------------------------------------------------------------------------------


_DIRECTIONS = 400
"""Directions over the whole sphere that a search starts from [-]."""
_STARTS = 4
"""Best directions that are refined [-]."""
_TURNS = 28
"""Steps of a refinement, each with half the angle of the one before where nothing better is found [-]."""
_PARALLEL = 1e-9
"""One less the cosine of the angle between two axes, and the sine, below which they are parallel [-]."""

_BALL = 1e-6
"""Radius of a ball within two bodies that proves that they stand into each other [m]."""


class Room(NamedTuple):
    """Room between two bodies, in the direction in which there is most."""

    apart: float
    """Distance of their middles in that direction, or the radius of the bore in which one lies [m]."""
    needed: float
    """What both take of it [m]."""

    @property
    def gap(self) -> float:
        """Clearance; negative where they stand into each other [m]."""
        return self.apart - self.needed


class Solid(NamedTuple):
    """A body as arrays."""

    axis: Floats
    """Unit vector; of a box it means nothing."""
    centres: Floats
    """Of its circles, or the corners of a box (n, 3) [m]."""
    radii: Floats
    """(n,) [m]"""
    bore: float
    """[m]"""

    @property
    def middle(self) -> Floats:
        """Middle of all centres [m]."""
        return np.asarray((self.centres[0] + self.centres[-1]) / 2.0)

    @property
    def reach(self) -> float:
        """Radius of a sphere about the middle that holds it [m]."""
        return float(np.max(np.linalg.norm(self.centres - self.middle, axis=1) + self.radii))

    def extent(self, directions: Floats) -> Floats:
        """Return how far it reaches from the origin in given directions [m], (k,).

        Args:
            directions: Unit vectors (k, 3).
        """
        square = np.sqrt(np.maximum(1.0 - (directions @ self.axis) ** 2, 0.0))
        return np.asarray(np.max(directions @ self.centres.T + square[:, None] * self.radii, axis=1))


@lru_cache(maxsize=512)
def solid_of(body: Body) -> Solid:
    """Return a body as arrays.

    Args:
        body: Its envelope.
    """
    axis, origin = np.array(body.direction), np.array(body.origin)
    places = np.array([station.place for station in body.stations])
    return Solid(axis, origin + places[:, None] * axis, np.array([s.radius for s in body.stations]), body.bore)


def box_of(first: Sequence[float], second: Sequence[float]) -> Solid:
    """Return a box along the axes of space.

    Args:
        first: One corner [m].
        second: The opposite corner [m].
    """
    low, high = np.minimum(first, second), np.maximum(first, second)
    corners = [
        [(low, high)[k][0], (low, high)[j][1], (low, high)[i][2]] for k in (0, 1) for j in (0, 1) for i in (0, 1)
    ]
    return Solid(np.array([1.0, 0.0, 0.0]), np.array(corners), np.zeros(8), 0.0)


def room_between(one: Body, other: Body, *, enough: float = math.inf) -> Room:
    """Return the room between two bodies.

    Args:
        one: A body.
        other: Another one.
        enough: Gap that is found quickly and need not be looked for further [m]; it may then be more.
    """
    if _are_cylinders(one, other):
        cosine = sum(a * b for a, b in zip(one.direction, other.direction, strict=True))
        return _side_by_side(one, other, math.copysign(1.0, cosine))
    return solid_room(solid_of(one), solid_of(other), enough=enough)


def solid_room(one: Solid, other: Solid, *, enough: float = math.inf) -> Room:
    """Return the room between two bodies, or a body and a box, by the directions between them.

    Args:
        one: A body.
        other: Another one.
        enough: Gap that is found quickly and need not be looked for further [m]; it may then be more.
    """
    best = max((*_inside(one, other), *_inside(other, one)), key=lambda room: room.gap, default=None)
    if best is not None and best.gap > enough:
        return best
    directions = _likely(one, other)
    if float(np.max(_gaps(one, other, directions))) <= enough:
        directions = _refined(one, other, np.vstack([directions, _sphere()]))
    gaps = _gaps(one, other, directions)
    way = directions[int(np.argmax(gaps))]
    apart = float(way @ (other.middle - one.middle))
    found = Room(apart, apart - float(np.max(gaps)))
    return found if best is None or found.gap >= best.gap else best


def stand_into(one: Body, other: Body, touch: float) -> bool:
    """Tell whether two bodies stand into each other: as `room_between` has it, without how far.

    Args:
        one: A body.
        other: Another one.
        touch: How far they may by rounding [m].
    """
    if _are_cylinders(one, other):
        return room_between(one, other).gap < -touch
    first, second = solid_of(one), solid_of(other)
    if any(room.gap >= -touch for room in (*_inside(first, second), *_inside(second, first))):
        return False
    directions = _likely(first, second)
    if float(np.max(_gaps(first, second, directions))) >= -touch:
        return False
    if _share_a_ball(first, second):
        return True
    directions = _refined(first, second, np.vstack([directions, _sphere()]), until=-touch)
    return float(np.max(_gaps(first, second, directions))) < -touch


def _are_cylinders(one: Body, other: Body) -> bool:
    """Tell whether two bodies are cylinders side by side."""
    cosine = sum(a * b for a, b in zip(one.direction, other.direction, strict=True))
    parallel = 1.0 - abs(cosine) < _PARALLEL and len(one.stations) == len(other.stations) == 2
    return parallel and all(body.stations[0].radius == body.stations[1].radius for body in (one, other))


def _share_a_ball(one: Solid, other: Solid) -> bool:
    """Tell whether a small ball is found within both: no direction then shows them apart. False proves nothing."""
    points = np.vstack([_within(one), _within(other)])
    return bool(np.any(_hold(one, points) & _hold(other, points)))


def _within(solid: Solid) -> Floats:
    """Return points within a body, on five circles between each two of its own (n, 3) [m]."""
    parts = np.linspace(0.05, 0.95, 5)[:, None]
    middles = np.concatenate([a + parts * (b - a) for a, b in zip(solid.centres, solid.centres[1:], strict=False)])
    radii = np.concatenate([a + parts[:, 0] * (b - a) for a, b in zip(solid.radii, solid.radii[1:], strict=False)])
    side = _square_to(solid.axis[None])
    up = _cross(solid.axis[None], side)
    ring = np.exp(2j * np.pi * np.arange(12) / 12)[:, None]
    round_ = np.concatenate([part * (ring.real * side + ring.imag * up) for part in (0.0, 0.5, 0.95)])
    return np.asarray((middles[:, None] + radii[:, None, None] * round_).reshape(-1, 3))


def _hold(solid: Solid, points: Floats) -> NDArray[np.bool_]:
    """Tell for each point whether a small ball about it lies within a body, between two neighbouring circles (n,)."""
    off = points - solid.centres[0]
    along = off @ solid.axis
    away = np.linalg.norm(off - along[:, None] * solid.axis, axis=1)
    places = (solid.centres - solid.centres[0]) @ solid.axis
    room = np.minimum(np.interp(along - _BALL, places, solid.radii), np.interp(along + _BALL, places, solid.radii))
    return np.asarray((away + _BALL < room) & (along - _BALL > places[0]) & (along + _BALL < places[-1]))


def _cross(one: Floats, other: Floats) -> Floats:
    """Return the products of vectors, row by row: what `numpy.cross` gives, without its looks at shapes (n, 3)."""
    (a, b, c), (x, y, z) = one.T, other.T
    return np.stack([b * z - c * y, c * x - a * z, a * y - b * x], axis=1)


def _square_to(ways: Floats) -> Floats:
    """Return unit vectors square to given ones (n, 3)."""
    side = _cross(ways, np.eye(3)[np.argmin(np.abs(ways), axis=1)])
    return np.asarray(side / np.linalg.norm(side, axis=1)[:, None])


def _side_by_side(one: Body, other: Body, sense: float) -> Room:
    """Return the room between two cylinders whose axes are parallel: beside, before or around each other."""
    between = [b - a for a, b in zip(one.origin, other.origin, strict=True)]
    start = sum(way * along for way, along in zip(between, one.direction, strict=True))
    off = math.sqrt(max(sum(way * way for way in between) - start * start, 0.0))
    middles = abs(start + sense * other.length / 2.0 - one.length / 2.0)
    ahead, beside = Room(middles, (one.length + other.length) / 2.0), Room(off, one.radius + other.radius)
    rooms = [ahead, beside]
    if ahead.gap > 0.0 and beside.gap > 0.0:
        far = math.hypot(ahead.gap, beside.gap)
        apart = (ahead.apart * ahead.gap + beside.apart * beside.gap) / far
        rooms.append(Room(apart, apart - far))
    rooms += [Room(body.bore, off + mate.radius) for body, mate in ((one, other), (other, one)) if body.bore]
    return max(rooms, key=lambda room: room.gap)


def _gaps(one: Solid, other: Solid, directions: Floats) -> Floats:
    """Return the distance between the shadows of two bodies in every direction [m]."""
    return -other.extent(-directions) - one.extent(directions)


def _likely(one: Solid, other: Solid) -> Floats:
    """Return directions that their axes suggest: along both, square to each, square to both, between the middles."""
    between = other.middle - one.middle
    ways = [between, one.axis, other.axis, np.cross(one.axis, other.axis)]
    ways += [between - (between @ axis) * axis for axis in (one.axis, other.axis)]
    ways += [np.array(way) for way in np.eye(3)]
    lengths = [float(np.linalg.norm(way)) for way in ways]
    units = [way / length for way, length in zip(ways, lengths, strict=True) if length > _PARALLEL]
    return np.array([sign * way for way in units for sign in (1.0, -1.0)])


@cache
def _sphere() -> Floats:
    """Return directions evenly over the sphere, on a spiral by the golden angle."""
    k = np.arange(_DIRECTIONS)
    height = 1.0 - (2.0 * k + 1.0) / _DIRECTIONS
    turn = math.pi * (3.0 - math.sqrt(5.0)) * k
    flat = np.sqrt(1.0 - height**2)
    return np.stack([height, flat * np.cos(turn), flat * np.sin(turn)], axis=1)


def _refined(one: Solid, other: Solid, directions: Floats, *, until: float = math.inf) -> Floats:
    """Return the best of given directions, each turned step by step to where the shadows are farthest apart.

    Where one of them shows as much room as is looked for [m] it ends.
    """
    best = directions[np.argsort(-_gaps(one, other, directions), kind="stable")[:_STARTS]]
    angle = np.full(len(best), 0.2)
    value = _gaps(one, other, best)
    ring = np.exp(2j * np.pi * np.arange(8) / 8)
    for _ in range(_TURNS):
        if float(np.max(value)) >= until:
            break
        side = _square_to(best)
        up = _cross(best, side)
        tried = best[:, None] + angle[:, None, None] * (
            ring.real[:, None] * side[:, None] + ring.imag[:, None] * up[:, None]
        )
        tried /= np.linalg.norm(tried, axis=2)[..., None]
        gaps = _gaps(one, other, tried.reshape(-1, 3)).reshape(tried.shape[:2])
        choice = np.argmax(gaps, axis=1)
        rows = np.arange(len(best))
        better = gaps[rows, choice] > value
        best = np.where(better[:, None], tried[rows, choice], best)
        value = np.where(better, gaps[rows, choice], value)
        angle = np.where(better, angle, angle / 2.0)
    return best


def _inside(outer: Solid, inner: Solid) -> list[Room]:
    """Return the room around a body that lies within the bore of another one, if the other has a bore.

    A circle of radius r square to a, its centre at c from the bore's axis b: along a × b it reaches r beyond c, square
    to that r |a·b|.
    """
    if not outer.bore:
        return []
    off = inner.centres - outer.middle
    off = off - (off @ outer.axis)[:, None] * outer.axis
    level = np.cross(inner.axis, outer.axis)
    sine = float(np.linalg.norm(level))
    if sine < _PARALLEL:
        return [Room(outer.bore, float(np.max(np.linalg.norm(off, axis=1) + inner.radii)))]
    level = level / sine
    tilt = abs(float(inner.axis @ outer.axis))
    along = np.abs(off @ level)
    across = np.sqrt(np.maximum(np.sum(off**2, axis=1) - along**2, 0.0))
    return [Room(outer.bore, float(np.max(np.hypot(along + inner.radii, across + tilt * inner.radii))))]


# ----------------------------------------------------------------------------------------------------------------------
# Which bodies share an axis, and shafts that run into each other there.
#
# The order on an axis gives every body its room, where nothing that the design gives is in the way: a length, a
# place, a bore. What it gives is held against each other all the same.
# ----------------------------------------------------------------------------------------------------------------------


CLAUSE = "bodies in space"
"""Of checks of room between bodies."""
_CLOSE = 1e-9
"""Axes are one where the square of their distance is less [m²], and 1 − |cos| of their angle [-]."""
_TOUCH = 1e-9
"""How far bodies may stand into each other by rounding [m]."""


def axes_among(bodies: Sequence[Body]) -> list[int]:
    """Return the number of every body's axis, those of coaxial ones alike [-].

    Args:
        bodies: Of a transmission.
    """
    firsts, numbers, known = list[Body](), list[int](), dict[str, int]()
    for body in bodies:
        number = known.get(body.shaft)
        if number is None:
            number = next((k for k, first in enumerate(firsts) if _coaxial(first, body)), len(firsts))
            if number == len(firsts):
                firsts.append(body)
            if body.shaft != GROUND:
                known[body.shaft] = number
        numbers.append(number)
    return numbers


def _coaxial(one: Body, other: Body) -> bool:
    """Tell whether two bodies share an axis."""
    (x, y, z), (a, b, c), (d, e, f) = other.origin, one.direction, other.direction
    x, y, z = x - one.origin[0], y - one.origin[1], z - one.origin[2]
    along = x * a + y * b + z * c
    x, y, z = x - along * a, y - along * b, z - along * c
    return x * x + y * y + z * z < _CLOSE and 1.0 - abs(a * d + b * e + c * f) < _CLOSE


def owner(body: Body) -> PartId:
    """Return what a body belongs to: its shaft, or the set whose planets or standing gears it is.

    Args:
        body: At its place.
    """
    if body.part.role is Role.PLANET or body.shaft == GROUND:
        return PartId(Kind.STAGE, body.part.name)
    return PartId(Kind.SHAFT, body.shaft)


def of_one_set(one: Body, other: Body, sets: frozenset[str]) -> bool:
    """Tell whether two bodies are gears or the carrier of one planetary set.

    Args:
        one: A body.
        other: Another one.
        sets: Names of planetary sets.
    """
    return one.part.name == other.part.name and one.part.name in sets and _toothed(one) and _toothed(other)


def _toothed(body: Body) -> bool:
    return body.part.kind in (Kind.GEAR, Kind.CARRIER)


def coaxial_checks(arrangement: Arrangement, sets: frozenset[str], built: frozenset[str]) -> Iterator[Check]:
    """Yield the shafts on one axis whose bodies run into each other, two at a time.

    Args:
        arrangement: With its bodies.
        sets: Names of planetary sets.
        built: Shafts that are worked out along their axes.
    """
    bodies = arrangement.bodies
    if all(body.shaft in built for body in bodies):
        return
    worst, on_axis = dict[tuple[PartId, PartId], tuple[Room, Body, Body]](), dict[int, list[Body]]()
    for body, number in zip(bodies, axes_among(bodies), strict=True):
        on_axis.setdefault(number, []).append(body)
    for one, other in chain.from_iterable(combinations(alike, 2) for alike in on_axis.values()):
        if one.shaft == other.shaft or (one.shaft in built and other.shaft in built):
            continue
        if not of_one_set(one, other, sets) and _meet(one, other):
            low, high = sorted((owner(one), owner(other)), key=str)
            room = room_between(one, other, enough=0.0)
            if (low, high) not in worst or room.gap < worst[low, high][0].gap:
                worst[low, high] = (room, one, other)
    for (low, high), (room, one, other) in worst.items():
        why = f"{-1e3 * room.gap:.3g} mm into each other on one axis; {_help(arrangement, one.shaft, other.shaft)}"
        yield Check(
            high, f"room beside {low}", CLAUSE, max(room.apart, 0.0), room.needed, "length",
            exponent=None, place=f"{one.part} and {other.part}", why=why,
        )  # fmt: skip


def _help(arrangement: Arrangement, *shafts: str) -> str:
    """Return what would make room between two shafts on one axis."""
    for inner, outer in (shafts, shafts[::-1]):
        if (inner, outer) in arrangement.within:
            return (
                f"{inner} goes through {outer}: leave bore, diameter and length of both open in [layout], or give"
                f" {outer} a larger bore"
            )
    return (
        f"leave length and places of {' and '.join(shafts)} open in [layout], so that they follow from each other, or"
        " give both [bearings]"
    )


def _meet(one: Body, other: Body) -> bool:
    """Tell whether two bodies on one axis run into each other: side by side, or one in the bore of the other."""
    (a, b, c), (x, y, z), (u, v, w), (d, e, f) = one.direction, one.origin, other.origin, other.direction
    start = (u - x) * a + (v - y) * b + (w - z) * c
    end = start + other.length * (d * a + e * b + f * c)
    if min(max(start, end), one.length) - max(min(start, end), 0.0) <= _TOUCH:
        return False
    return one.radius > other.bore and other.radius > one.bore
