"""Where shafts and gears stand in space, and the clearance between bodies of revolution or boxes there."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import chain, combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.base import Check, DesignError, Floats, Kind, PartId, Role, carrier_part
from gearwright.parts.bevel_geometry import BevelPair
from gearwright.sizing.arrangement import NO_ANGLES, Moves, arrange
from gearwright.sizing.axis_order import set_length, slots
from gearwright.sizing.rating import Context, geometry as standard_teeth
from gearwright.sizing.result import Arrangement, Body, Direction, Frame, GearSizing, Point
from gearwright.spec import GROUND
from gearwright.spec.design import NOTHING_GIVEN
from gearwright.train import Mesh

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
    apart = float(directions[int(np.argmax(gaps))] @ (other.middle - one.middle))
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
        cosine = sum(a * b for a, b in zip(one.direction, other.direction, strict=True))
        return max(room.gap for room in _beside_each_other(one, other, math.copysign(1.0, cosine))) < -touch
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
    rooms = _beside_each_other(one, other, sense)
    ahead, beside = rooms[:2]
    if ahead.gap > 0.0 and beside.gap > 0.0:
        far = math.hypot(ahead.gap, beside.gap)
        apart = (ahead.apart * ahead.gap + beside.apart * beside.gap) / far
        rooms.append(Room(apart, apart - far))
    return max(rooms, key=lambda room: room.gap)


def _beside_each_other(one: Body, other: Body, sense: float) -> list[Room]:
    """Return the room between two cylinders whose axes are parallel along these, across, and in each other's bores."""
    between = [b - a for a, b in zip(one.origin, other.origin, strict=True)]
    start = sum(way * along for way, along in zip(between, one.direction, strict=True))
    off = math.sqrt(max(sum(way * way for way in between) - start * start, 0.0))
    middles = abs(start + sense * other.length / 2.0 - one.length / 2.0)
    rooms = [Room(middles, (one.length + other.length) / 2.0), Room(off, one.radius + other.radius)]
    return rooms + [Room(body.bore, off + mate.radius) for body, mate in ((one, other), (other, one)) if body.bore]


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


# ----------------------------------------------------------------------------------------------------------------------
# The cones of a sized bevel pair.
# ----------------------------------------------------------------------------------------------------------------------


def bevel_cones(context: Context, gears: Mapping[str, GearSizing], stage: str) -> BevelPair:
    """Return the cones of a bevel pair; its gears are sized at their mean cones.

    Args:
        context: What sizing reads.
        gears: By name.
        stage: The pair.
    """
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    pinion, wheel = (gears[name] for name in mesh.gears)
    return standard_teeth.bevel_pair(
        (pinion.teeth, wheel.teeth), pinion.module, pinion.face_width, context.ratings[stage]
    )


# ----------------------------------------------------------------------------------------------------------------------
# Where every shaft lies in space: parallel beside its mates, across them in bevel and face meshes, in line in sets.
#
# A mesh, a planetary set or a clutch places the shaft at its other end; the first shaft of the design lies along x.
# What an axis in the cross-section is to its neighbour (`arrangement.axes`) it is in space: the direction in which
# two shafts meet there is the direction in which they meet here, so that loads and places agree.
# ----------------------------------------------------------------------------------------------------------------------


BESIDE = 5e-5
"""How far two gears in mesh may stand from each other along their axes before it is told [m]."""


@dataclass(frozen=True)
class _Join:
    """What places one shaft by another."""

    first: str
    second: str
    at: tuple[float, float]
    """Where they meet, along each [m]."""
    mesh: Mesh | None = None
    """None where they lie in line."""


def frames_of(context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement) -> dict[str, Frame]:
    """Return the axes of every shaft in space.

    Args:
        context: What sizing reads.
        gears: By name.
        arrangement: Its axes and plans.
    """
    joins = [*_meshes(context, arrangement), *_sets(context, gears, arrangement), *_links(context, arrangement)]
    frames: dict[str, Frame] = {}
    for name in context.design.shafts:
        if name not in frames:
            frames[name] = _free(arrangement.axes[name])
        while join := next((join for join in joins if (join.first in frames) != (join.second in frames)), None):
            side = 0 if join.first in frames else 1
            known, new = (join.first, join.second)[:: 1 if side == 0 else -1]
            frames[new] = _placed(context, gears, arrangement, join, side, frames[known])
    return frames


def apart_of(
    context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement, frames: Mapping[str, Frame]
) -> dict[str, float]:
    """Return mesh row -> how far its gears stand from where they mesh, along their axes [m].

    Args:
        context: What sizing reads.
        gears: By name.
        arrangement: Its axes and plans.
        frames: From `frames_of`.
    """
    found = {}
    for join in _meshes(context, arrangement):
        if join.mesh is not None and context.design.pairs[join.mesh.stage].kind != "face":
            wanted = _placed(context, gears, arrangement, join, 0, frames[join.first])
            stands = frames[join.second]
            off = float((np.array(stands.origin) - np.array(wanted.origin)) @ np.array(wanted.along))
            if abs(off) > BESIDE:
                found[join.mesh.name] = off
    return found


def _free(axis: complex) -> Frame:
    origin = Point(0.0, axis.real, axis.imag)
    return Frame(origin, Direction(1.0, 0.0, 0.0), Direction(0.0, 1.0, 0.0), Direction(0.0, 0.0, 1.0))


def _meshes(context: Context, arrangement: Arrangement) -> Iterator[_Join]:
    plans = arrangement.plans
    for mesh in context.train.meshes:
        first, second = mesh.nodes[:2]
        if mesh.stage in context.design.pairs and first in plans and second in plans:
            yield _Join(first, second, (plans[first].places[mesh.gears[0]], plans[second].places[mesh.gears[1]]), mesh)


def _sets(context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement) -> Iterator[_Join]:
    """Yield the shafts of every planetary set in line, each at the set's middle."""
    for stage in context.design.sets:
        members = list(set_members(context, gears, arrangement, stage))
        for shaft, middle in members[1:]:
            if shaft != members[0][0]:
                yield _Join(members[0][0], shaft, (members[0][1], middle))


def set_members(
    context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement, stage: str
) -> Iterator[tuple[str, float]]:
    """Yield every shaft of a planetary set, with where the set's middle lies along it [m].

    A set at the end of a shaft of a first sizing lies beyond that end.

    Args:
        context: What sizing reads.
        gears: By name.
        arrangement: Its plans.
        stage: Name of the set.
    """
    design, places = context.design, slots(context, gears, stage, turned=stage in arrangement.turned)
    labels = {gear.name: gear.nodes for gear in context.train.gears if gear.stage == stage and gear.role != Role.PLANET}
    labels[str(carrier_part(stage))] = (design.sets[stage].carrier,)
    half = set_length(context, gears, stage) / 2.0
    for label, nodes in labels.items():
        for shaft in nodes:
            if shaft not in arrangement.plans:
                continue
            plan = arrangement.plans[shaft]
            at = plan.places[label] - places.get(label, 0.0)
            if not plan.seats:
                at = -half if plan.places[label] <= 0.0 else plan.length + half if at >= plan.length - half else at
            yield shaft, at


def _links(context: Context, arrangement: Arrangement) -> Iterator[_Join]:
    for name, link in context.design.links.items():
        if link.driving in arrangement.plans and link.driven in arrangement.plans:
            at = (arrangement.plans[link.driving].places[name], arrangement.plans[link.driven].places[name])
            yield _Join(link.driving, link.driven, at)


def _placed(
    context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement, join: _Join, side: int, known: Frame
) -> Frame:
    """Return the frame of the shaft at the other end of a join."""
    kind = "" if join.mesh is None else context.design.pairs[join.mesh.stage].kind
    ends = (join.first, join.second)
    between = arrangement.axes[ends[1 - side]] - arrangement.axes[ends[side]]
    if kind == "bevel" and join.mesh is not None:
        return _crossed(context, gears, join, side, known=known, toward=between / abs(between))
    if kind == "face" and join.mesh is not None:
        return _across(gears, join, side, known=known, between=between)
    step = join.at[side] - join.at[1 - side]
    along = np.array(known.origin) + step * np.array(known.along)
    origin = along + (between.real * np.array(known.across) + between.imag * np.array(known.up))
    return Frame(_point(origin), known.along, known.across, known.up)


def _crossed(
    context: Context, gears: Mapping[str, GearSizing], join: _Join, side: int, *, known: Frame, toward: complex
) -> Frame:
    """Return the other shaft of a bevel pair, through the common apex.

    From the apex, this gear lies along e and the other one along e' = cos Σ e + sin Σ u, with u the direction in which
    they touch; the other shaft's own direction of touch is that part of e which is square to e'.
    """
    assert join.mesh is not None
    pair, stage = bevel_cones(context, gears, join.mesh.stage), context.design.pairs[join.mesh.stage]
    sense = [1.0 if apex == "second" else -1.0 for apex in (stage.pinion_apex, stage.wheel_apex)]
    reach = [pair.mean_cone_distance * math.cos(angle) for angle in pair.pitch_angles]
    touch = toward.real * np.array(known.across) + toward.imag * np.array(known.up)
    here, angle = -sense[side] * np.array(known.along), pair.shaft_angle
    there = math.cos(angle) * here + math.sin(angle) * touch
    back = (here - math.cos(angle) * there) / math.sin(angle)
    apex = np.array(known.origin) + (join.at[side] + sense[side] * reach[side]) * np.array(known.along)
    other = 1 - side
    along = -sense[other] * there
    origin = apex - (join.at[other] + sense[other] * reach[other]) * along
    return _turned(origin, along, back, -toward)


def _across(gears: Mapping[str, GearSizing], join: _Join, side: int, *, known: Frame, between: complex) -> Frame:
    """Return the other shaft of a face-gear pair: the middle of the pinion's face on the wheel's pitch circle."""
    assert join.mesh is not None
    pinion, wheel = (gears[name].pitch_diameter / 2.0 for name in join.mesh.gears)
    toward = between / abs(between)
    touch = toward.real * np.array(known.across) + toward.imag * np.array(known.up)
    middle = np.array(known.origin) + join.at[side] * np.array(known.along)
    out = toward if side == 1 else -toward  # as the wheel sees it
    away = 1.0 if out.real + out.imag > 0.0 else -1.0  # the side to which the pinion pushes the wheel, as in its loads
    if side == 1:
        along = away * touch
        place = middle + wheel * touch - away * pinion * np.array(known.along)
        return _turned(place - join.at[0] * along, along, away * np.array(known.along), -toward)
    along, radial = away * touch, away * np.array(known.along)
    place = middle + pinion * touch - wheel * radial
    return _turned(place - join.at[1] * along, along, radial, -toward)


def _turned(origin: Floats, along: Floats, touch: Floats, toward: complex) -> Frame:
    """Return the frame whose cross-section shows a direction in space as a given direction."""
    side = np.cross(along, touch)
    across, up = toward.real * touch - toward.imag * side, toward.imag * touch + toward.real * side
    return Frame(_point(origin), _direction(along), _direction(across), _direction(up))


def _point(place: Floats) -> Point:
    return Point(*(float(value) for value in place))


def _direction(vector: Floats) -> Direction:
    return Direction(*(float(value) for value in vector))


# ----------------------------------------------------------------------------------------------------------------------
# Gears of first sizings moved along their shafts to where they mesh.
#
# Where meshes close a loop, the gears of the last one may stand beside each other along their axes, as shafts without
# bearings or places of their own have equal gaps. A gear that has no other mesh, on such a shaft, then moves to its
# mate.
# ----------------------------------------------------------------------------------------------------------------------


def arrange_meshing(
    context: Context, gears: tuple[GearSizing, ...], angles: Mapping[str, float] = NO_ANGLES
) -> Arrangement:
    """Return axes and plans in which gears in mesh stand beside each other, as far as open places give it.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        angles: Shaft -> direction of its axis from its mate, where the design leaves it open [rad].

    Raises:
        DesignError: As `arrange`.
    """
    arrangement = arrange(context, gears, angles)
    rows = [mesh for mesh in context.train.meshes if mesh.stage in context.design.pairs]
    if not _closes(context, rows):
        return arrangement
    moves: Moves = {}
    for _ in rows:
        closer = _closer(context, gears, angles, rows, arrangement, moves)
        if closer is None:
            break
        arrangement, moves = closer
    return arrangement


def _closes(context: Context, rows: list[Mesh]) -> bool:
    """Tell whether meshes close a loop of shafts, which sets and clutches join, too."""
    design, known = context.design, dict[str, str]()

    def root(shaft: str) -> str:
        while known.get(shaft, shaft) != shaft:
            shaft = known[shaft]
        return shaft

    joined = [stage.members for stage in design.sets.values()]
    joined += [(link.driving, link.driven) for link in design.links.values()]
    for first, *others in ([shaft for shaft in members if shaft != GROUND] for members in joined):
        known |= {root(other): root(first) for other in others if root(other) != root(first)}
    for mesh in rows:
        first, second = root(mesh.nodes[0]), root(mesh.nodes[1])
        if first == second:
            return True
        known[second] = first
    return False


def _closer(
    context: Context,
    gears: tuple[GearSizing, ...],
    angles: Mapping[str, float],
    rows: list[Mesh],
    arrangement: Arrangement,
    moves: Moves,
) -> tuple[Arrangement, Moves] | None:
    """Return the arrangement with one more gear moved to its mate, and all moves; None where none can be."""
    by_name = {gear.name: gear for gear in gears}
    frames = frames_of(context, by_name, arrangement)
    apart = apart_of(context, by_name, arrangement, frames)
    for mesh in rows:
        for shaft, gear in _open_ends(context, rows, mesh, arrangement) if mesh.name in apart else ():
            moved = _moved(moves, shaft, gear, frames, off=apart[mesh.name], mesh=mesh)
            try:
                return arrange(context, gears, angles, moved), moved
            except DesignError:  # it has no room on its shaft
                continue
    return None


def _open_ends(context: Context, rows: list[Mesh], mesh: Mesh, arrangement: Arrangement) -> Iterator[tuple[str, str]]:
    """Yield shaft and gear of the ends of a mesh that may move along their shafts."""
    for shaft, gear in zip(mesh.nodes[:2], mesh.gears, strict=True):
        layout = context.design.layout.get(shaft, NOTHING_GIVEN)
        meshes = sum((shaft, gear) in zip(row.nodes[:2], row.gears, strict=True) for row in rows)
        given = gear in layout.places or f"{shaft}.length" in context.given or layout.first_bearing is not None
        if meshes == 1 and not given and layout.second_bearing is None and not arrangement.plans[shaft].seats:
            yield shaft, gear


def _moved(moves: Moves, shaft: str, gear: str, frames: Mapping[str, Frame], *, off: float, mesh: Mesh) -> Moves:
    """Return moves with one more: the second shaft of the mesh stands too far on by so much, along itself."""
    first, second = (frames[node].along for node in mesh.nodes[:2])
    alike = 1.0 if sum(one * other for one, other in zip(first, second, strict=True)) > 0.0 else -1.0
    by = off * alike if shaft == mesh.nodes[0] else -off
    return {**moves, (shaft, gear): moves.get((shaft, gear), 0.0) + by}
