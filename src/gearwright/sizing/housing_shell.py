"""Housing shell: convex cross-sections around all bodies, and the space around bearing bosses."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Kind, following, smallest
from gearwright.catalogue import HousingMaterial
from gearwright.sizing.result import Body, Direction, Point

# ----------------------------------------------------------------------------------------------------------------------
# The shell that a housing is: cross-sections around all bodies, slice by slice along the first shaft.
#
# A circle of radius r square to a reaches h(n) = c·n + r |n − (n·a) a| in a direction n; the hull of a slice is
# bounded by the largest h of all bodies in it. With n at equal angles δ the polygon around them has sides l_i =
# (h_{i−1} + h_{i+1} − 2 h_i cos δ)/sin δ, the perimeter Σ l and the area Σ h l / 2; around a circle both are 0.1 %
# too large.
# ----------------------------------------------------------------------------------------------------------------------


_SIDES = 48
"""Sides of the polygon around a slice [-]."""
LEAST_CLEARANCE = 1.02
"""Inside of a wall as drawn over what turns in it [-]: 1 % of the diameter on either side, an estimate."""
CLEARANCE = 1.06
"""Inside of the housing over what turns in it [-]: 3 % of the diameter on either side, an estimate."""
SAME_SECTION = 1e-4
"""How far cross-sections may differ that are drawn as one [m]."""
SEAT = 1.6
"""Outside of the bearing on a shaft over the shaft's diameter [-]: light series of ISO 15."""


class Shell(NamedTuple):
    """The inside of a housing."""

    lateral: float
    """Area of its walls along the first shaft [m²]."""
    ends: float
    """Area of its walls across the first shaft: both ends, with every step between slices [m²]."""
    section: float
    """Area of its largest cross-section [m²]."""
    girth: float
    """Perimeter of that cross-section [m]."""
    length: float
    """[m]"""
    volume: float
    """[m³]"""
    rings: float
    """Area on which rings stand in place of walls along the first shaft, which have none there [m²]."""

    @property
    def area(self) -> float:
        """All walls [m²]."""
        return self.lateral + self.ends

    @property
    def outside(self) -> float:
        """All walls, with the rings that stand in their place [m²]."""
        return self.area + self.rings


class Stretch(NamedTuple):
    """A length of the housing with one cross-section: the polygon n·p ≤ h about the first shaft's direction."""

    start: float
    """Along the first shaft [m]."""
    end: float
    """[m]"""
    reach: Floats
    """h in every direction [m], shape (48,)."""
    least: Floats
    """That of what turns in it, with as little room as can be [m], shape (48,)."""
    perimeter: float
    """[m]"""
    area: float
    """[m²]"""

    @property
    def length(self) -> float:
        """[m]"""
        return self.end - self.start


def shell_around(bodies: Iterable[Body]) -> Shell:
    """Return the shell around bodies in space.

    Args:
        bodies: As the arrangement has them.

    Source: support functions of convex sets (Cauchy's formula). No housing follows a neck between two stages: a slice
        is as wide as the narrower of the widest before and the widest behind it, so that its walls across are two.
    """
    return _around([_Round.of(body) for body in bodies])


def section_across(bodies: Iterable[Body], way: Direction) -> float:
    """Return the largest cross-section of the shell around bodies square to a direction [m²].

    Args:
        bodies: As the arrangement has them.
        way: Unit vector.
    """
    first = np.array(way)
    beside = np.cross(first, np.eye(3)[int(np.argmin(np.abs(first)))])
    turned = np.stack([first, beside / np.linalg.norm(beside), np.cross(first, beside / np.linalg.norm(beside))])
    moved = (
        replace(body, origin=Point(*(turned @ np.array(body.origin)).tolist()),
                direction=Direction(*(turned @ np.array(body.direction)).tolist()))
        for body in bodies
    )  # fmt: skip
    return shell_around(moved).section


def _around(rounds: list[_Round]) -> Shell:
    slices = list(_slices(rounds))
    lengths = np.array([one.length for one in slices])
    girths, areas = np.array([one.perimeter for one in slices]), np.array([one.area for one in slices])
    girths, areas = _filled(girths), _filled(areas)
    return Shell(
        lateral=float(lengths @ girths),
        ends=2.0 * float(areas.max()),
        section=float(areas.max()),
        girth=float(girths.max()),
        length=float(lengths.sum()),
        volume=float(lengths @ areas),
        rings=0.0,
    )


def _filled(values: Floats) -> Floats:
    """Return values along the first shaft without valleys between larger ones."""
    before, behind = np.maximum.accumulate(values), np.maximum.accumulate(values[::-1])[::-1]
    return np.minimum(before, behind)


def stretches_around(bodies: Sequence[Body]) -> tuple[Stretch, ...]:
    """Return the cross-sections of the housing that `shell_around` weighs, from its first end to its last.

    Args:
        bodies: As the arrangement has them, and what else stands in the housing.

    Source: as `shell_around`: where a neck would be, the narrower of the widest before and the widest behind it, and
        what goes through it.
    """
    rounds, close = ([_Round.of(body, room) for body in bodies] for room in (CLEARANCE, LEAST_CLEARANCE))
    slices = [one._replace(least=_reach(rounds, close, one.start, one.end)) for one in _slices(rounds)]
    filled = _filled(np.array([one.area for one in slices]))
    found: list[Stretch] = []
    for one, area in zip(slices, filled, strict=True):
        wide = one._replace(start=found[-1].end if found else one.start)
        if one.area < area:
            other = slices[int(np.argmin([abs(each.area - area) for each in slices]))]
            reach, least = np.maximum(one.reach, other.reach), np.maximum(one.least, other.least)
            wide = Stretch(wide.start, one.end, reach, least, *_polygon(reach))
        if found and np.allclose(found[-1].reach, wide.reach, rtol=0.0, atol=SAME_SECTION):
            wide = found.pop()._replace(end=one.end)
        found.append(wide)
    return tuple(found)


def outline_of(reach: Floats) -> Floats:
    """Return the corners of a cross-section across the first shaft, y and z [m], shape (48, 2).

    Args:
        reach: h in every direction [m].
    """
    step = 2.0 * math.pi / _SIDES
    ways = _DIRECTIONS[:, 1:]
    beside = (following(reach) - reach * math.cos(step)) / math.sin(step)
    return np.asarray(reach[:, None] * ways + beside[:, None] * np.stack([-ways[:, 1], ways[:, 0]], axis=1))


class _Round(NamedTuple):
    """A body as its extents."""

    low: float
    """Along the first shaft [m]."""
    high: float
    """Along the first shaft [m]."""
    reach: Floats
    """h in every direction [m]."""

    @staticmethod
    def of(body: Body, clearance: float = CLEARANCE) -> _Round:
        """Return the extents of a body, a bare shaft's with its bearings, all with clearance."""
        axis, origin = np.array(body.direction), np.array(body.origin)
        places = np.array([station.place for station in body.stations])
        wider = SEAT if body.part.kind is Kind.SHAFT else 1.0
        radii = clearance * wider * np.array([station.radius for station in body.stations])
        centres = origin + places[:, None] * axis
        along = radii * math.sqrt(max(1.0 - axis[0] ** 2, 0.0))
        across = np.sqrt(np.maximum(1.0 - (_DIRECTIONS @ axis) ** 2, 0.0))
        reach = np.max(_DIRECTIONS @ centres.T + across[:, None] * radii, axis=1)
        return _Round(float(np.min(centres[:, 0] - along)), float(np.max(centres[:, 0] + along)), reach)


def _slices(rounds: list[_Round]) -> Iterator[Stretch]:
    """Yield the slices between places where a body begins or ends, one after the other."""
    edges = sorted({edge for body in rounds for edge in (body.low, body.high)})
    for start, end in pairwise(edges):
        if any(body.low < end and body.high > start for body in rounds):
            reach = _reach(rounds, rounds, start, end)
            yield Stretch(start, end, reach, reach, *_polygon(reach))


def _reach(rounds: list[_Round], seen: list[_Round], start: float, end: float) -> Floats:
    """Return how far those of some bodies reach, as they are seen, that stand in a slice [m]."""
    inside = [one.reach for body, one in zip(rounds, seen, strict=True) if body.low < end and body.high > start]
    return np.asarray(np.max(inside, axis=0))


def _polygon(reach: Floats) -> tuple[float, float]:
    """Return perimeter [m] and area [m²] of the polygon whose sides are so far from the origin."""
    step = 2.0 * math.pi / _SIDES
    sides = (np.concatenate([reach[-1:], reach[:-1]]) + following(reach) - 2.0 * reach * math.cos(step)) / math.sin(
        step
    )
    return float(sides.sum()), float(reach @ sides / 2.0)


def _directions() -> Floats:
    angles = 2.0 * np.pi * np.arange(_SIDES) / _SIDES
    return np.stack([np.zeros(_SIDES), np.cos(angles), np.sin(angles)], axis=1)


_DIRECTIONS = _directions()


# ----------------------------------------------------------------------------------------------------------------------
# Loops around the cross-sections of a housing, each n·p ≤ h in every direction n.
# ----------------------------------------------------------------------------------------------------------------------


SAME = 1e-4
"""Steps of a wall that are less are none [m]."""
GAP = 5e-4
"""Between a wall and the end of what stands square to it, at least [m], an assumption."""
SAME_CORNER = 1e-7
"""Corners that are nearer are one [m]."""


def inside_of(own: Stretch, wall: float) -> Floats:
    """Return how far the inside of a wall is: the wall's middle where it is weighed, where there is room for it [m].

    Args:
        own: The cross-section.
        wall: Thickness [m].
    """
    corners = loop_around(own.reach - wall / 2.0)
    if not len(corners):  # a wall thicker than the room is wide
        return np.asarray(own.least + GAP)
    return np.asarray(np.maximum(np.max(corners @ ways_of(len(own.reach)).T, axis=0), own.least + GAP))


@lru_cache(maxsize=4)
def ways_of(count: int) -> Floats:
    """Return equally spaced directions from y on [-], shape (n, 2).

    Args:
        count: How many.
    """
    angle = 2.0 * math.pi * np.arange(count) / count
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def fits(reach: Floats, middle: Floats, radius: float) -> bool:
    """Tell whether a circle lies in a cross-section; of a negative radius, whether any of it does.

    Args:
        reach: h of the cross-section in every direction [m].
        middle: Of the circle [m].
        radius: Of the circle [m].
    """
    return bool(np.all(ways_of(len(reach)) @ middle + radius < reach))


def loop_size(reach: Floats) -> tuple[float, float]:
    """Return perimeter [m] and area [m²] of the polygon n·p ≤ h.

    Args:
        reach: h in every direction [m].
    """
    loop = loop_around(reach)
    after = following(loop)
    area = float(np.sum(loop[:, 0] * after[:, 1] - loop[:, 1] * after[:, 0]) / 2.0)
    return float(np.sum(np.linalg.norm(after - loop, axis=1))), area


def loop_around(reach: Floats) -> Floats:
    """Return the corners of the polygon n·p ≤ h, also where some of its sides lie outside of others [m], shape (n, 2).

    None where nothing lies within all sides.

    Args:
        reach: h in every direction [m].
    """
    loop, ways = outline_of(reach), ways_of(len(reach))
    if np.all(loop @ ways.T <= reach + SAME_CORNER):
        return _cleaned(loop)
    wide = 2.0 * float(np.max(np.abs(reach)))
    corners = [complex(wide, -wide), complex(wide, wide), complex(-wide, wide), complex(-wide, -wide)]
    for way, limit in zip((ways[:, 0] - 1j * ways[:, 1]).tolist(), reach.tolist(), strict=True):
        far = [(corner * way).real - limit for corner in corners]
        if not far:
            return np.empty((0, 2))
        if max(far) <= 0.0:
            continue
        kept: list[complex] = []
        for here, there, corner, onward in zip(
            far, [*far[1:], far[0]], corners, [*corners[1:], corners[0]], strict=True
        ):
            if here <= 0.0:
                kept.append(corner)
            if (here < 0.0 < there) or (there < 0.0 < here):
                kept.append(corner + here / (here - there) * (onward - corner))
        corners = kept
    loop = np.array([[corner.real, corner.imag] for corner in corners])
    return _cleaned(loop)


def _cleaned(loop: Floats) -> Floats:
    """Return a loop with one corner where several coincide."""
    return np.asarray(loop[np.linalg.norm(loop - np.concatenate([loop[-1:], loop[:-1]]), axis=1) > SAME_CORNER])


# ----------------------------------------------------------------------------------------------------------------------
# Rooms of a housing: cross-sections that can be cast, without short steps, each within the wider one beside it.
# ----------------------------------------------------------------------------------------------------------------------


LEAST, SHORTEST = 2.0, 0.02
"""Length of a room over the wall's thickness [-], and in metres, below which it is one with its neighbour."""


def rooms_around(bodies: Sequence[Body], wall: float) -> list[Stretch]:
    """Return the rooms around bodies, from the first end to the last.

    Args:
        bodies: That stand in the housing.
        wall: Thickness [m].
    """
    return _nested(_long_enough(list(stretches_around(bodies)), wall))


def _long_enough(stretches: list[Stretch], wall: float) -> list[Stretch]:
    """Return cross-sections without steps that are too short to cast: one with the neighbour that grows least."""
    found = list(stretches)
    while len(found) > 1:
        k = smallest(range(len(found)), lambda k: found[k].length)
        if found[k].length >= max(LEAST * wall, SHORTEST):
            break
        beside = [_joined(found[j], found[k]) for j in (k - 1, k + 1) if 0 <= j < len(found)]
        _, one = smallest(beside, lambda choice: choice[0])
        low = next(j for j, each in enumerate(found) if each.start == one.start)
        found[low : low + 2] = [one]
    return found


def _joined(one: Stretch, other: Stretch) -> tuple[float, Stretch]:
    """Return by how much two neighbours grow when they become one [m³], and that one."""
    reach, least = np.maximum(one.reach, other.reach), np.maximum(one.least, other.least)
    whole = min(one, other, key=lambda each: each.start)
    around, area = loop_size(reach)
    whole = Stretch(whole.start, max(one.end, other.end), reach, least, around, area)
    return whole.area * whole.length - one.area * one.length - other.area * other.length, whole


def _nested(stretches: list[Stretch]) -> list[Stretch]:
    """Return cross-sections of which, side by side, one lies in the other: the larger one reaches around both."""
    found, again = list(stretches), True
    while again:
        again = False
        for k, (one, other) in enumerate(pairwise(found)):
            if all(np.any(a.reach > b.reach + SAME) for a, b in ((one, other), (other, one))):
                j = k if one.area >= other.area else k + 1
                reach, least = np.maximum(one.reach, other.reach), np.maximum(one.least, other.least)
                found[j], again = found[j]._replace(reach=reach, least=least), True
    return found


# ----------------------------------------------------------------------------------------------------------------------
# What stands around the bosses of bearings: rooms up to their walls, and bodies to keep clear of.
# ----------------------------------------------------------------------------------------------------------------------


CLEAR = 2e-3
"""Between a web and what turns or holds bearings, at least [m], an assumption."""
SUNK = 1e-3
"""How far webs and collars go on into walls, so that they are one piece with them [m]."""


class Around(NamedTuple):
    """What stands around bosses."""

    rooms: Sequence[Stretch]
    bodies: Sequence[Body]
    balls: Floats
    """Of bodies, from `ball_around` [m], shape (n, 4)."""
    wall: float
    material: HousingMaterial

    def is_free(self, points: Floats, ignored: Callable[[Body], bool] = lambda _: False) -> bool:
        """Tell whether points are clear of bodies.

        Args:
            points: [m], shape (n, 3).
            ignored: Which bodies do not count.
        """
        middle = points.mean(axis=0)
        radius = float(np.max(np.linalg.norm(points - middle, axis=1))) + CLEAR
        near = np.linalg.norm(self.balls[:, :3] - middle, axis=1) < self.balls[:, 3] + radius
        for k in np.flatnonzero(near).tolist():
            body = self.bodies[k]
            if ignored(body):
                continue
            off, axis = points - np.asarray(body.origin), np.asarray(body.direction)
            place = off @ axis
            beside = np.linalg.norm(off - place[:, None] * axis, axis=1)
            places, radii = zip(*body.stations, strict=True)
            within = (place > -CLEAR) & (place < body.length + CLEAR) & (beside > body.bore - CLEAR)
            if np.any(within & (beside < np.interp(place, places, radii) + CLEAR)):
                return False
        return True

    def reach(self, start: Floats, way: Floats) -> float:
        """Return how far it is from a point into the wall [m]; 0 outside of all rooms.

        Args:
            start: [m], shape (3,).
            way: Unit vector, shape (3,).
        """
        ways, far = ways_of(len(self.rooms[0].reach)), 0.0
        across, order = ways @ way[1:], list(self.rooms if way[0] >= 0.0 else self.rooms[::-1])
        for room in order:
            here = start + far * way
            ahead = (room.end if way[0] >= 0.0 else room.start) - here[0]
            if (ahead < SAME_CORNER) if way[0] >= 0.0 else (ahead > -SAME_CORNER):
                continue
            left = room.reach - ways @ here[1:]
            if left.min() < -SAME_CORNER or not room.start - SAME_CORNER < here[0] < room.end + SAME_CORNER:
                return far + SUNK if far else 0.0
            out = across > SAME_CORNER
            side = float(np.min(left[out] / across[out], initial=math.inf))
            plane = ahead / float(way[0]) if abs(way[0]) > SAME_CORNER else math.inf
            if side <= plane:
                return far + side + SUNK
            far += plane
        return far + SUNK if far else 0.0


def ball_around(body: Body) -> list[float]:
    """Return middle and radius of a ball around a body [m].

    Args:
        body: The body.
    """
    middle = np.asarray(body.origin) + body.length / 2.0 * np.asarray(body.direction)
    return [*middle.tolist(), math.hypot(body.length / 2.0, body.radius)]
