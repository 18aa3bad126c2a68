"""What carries the bosses of bearings: webs and collars from each boss to the walls around it, where nothing turns.

Bosses beside each other on one shaft are one. Of what finds a way (a collar around the axis to the next wall, or a
cross of webs) the lightest is taken. Webs are as wide along the shaft as their boss and as thick as forces ask: each
is built in at both ends; together they hold the radial force, whichever way it acts, and the axial one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import housing_materials
from gearwright.ranking import smallest
from gearwright.sizing.arranged import Body, Frame
from gearwright.sizing.casing.around import CLEAR, SUNK, Around, ball_around
from gearwright.sizing.casing.housed import bosses_of, housed
from gearwright.sizing.casing.rooms import rooms_around
from gearwright.sizing.mounted import BearingSizing
from gearwright.sizing.result import Sizing
from gearwright.sizing.shafts import Holder, holders_of

STEP = 4e-3
"""Between places along a way at which it is looked at [m]."""
AROUND = 12
"""Lines along a collar that are looked at [-]."""
TURNS = 6
"""By how many parts of a right angle a cross of webs is tried, first with one web in the plane of axes [-]."""
TRIES = 4
"""How often the thickness of webs is found anew for the room that it takes [-]."""


class Web(NamedTuple):
    """A flat wall from a boss to the wall of the housing, along a line away from the shaft's axis; lengths [m]."""

    bearing: str
    """In whose boss it begins."""
    start: Floats
    """Middle of its foot on the boss, in space, shape (3,)."""
    way: Floats
    """Unit vector out [-], shape (3,)."""
    along: Floats
    """Unit vector of the shaft [-], shape (3,)."""
    length: float
    """Into the wall, in which it ends."""
    width: float
    """Along the shaft: as wide as the boss."""
    thickness: float
    """Around the shaft."""

    @property
    def across(self) -> Floats:
        """Unit vector around the shaft [-], shape (3,)."""
        (a, b, c), (x, y, z) = self.along.tolist(), self.way.tolist()
        return np.array([b * z - c * y, c * x - a * z, a * y - b * x])

    @property
    def volume(self) -> float:
        """[m³]"""
        return self.length * self.width * self.thickness


class Collar(NamedTuple):
    """A tube from the face of a boss to the next wall, or to the boss beside it; lengths [m]."""

    bearing: str
    """At whose boss it begins."""
    shaft: str
    span: tuple[float, float]
    """Along the shaft from its first end."""
    outer: float
    """Radius."""
    inner: float
    """Radius."""

    @property
    def volume(self) -> float:
        """[m³]"""
        return math.pi * (self.outer**2 - self.inner**2) * (self.span[1] - self.span[0])


class Carried(NamedTuple):
    """How the bosses of bearings beside each other on a shaft are carried."""

    bearings: tuple[str, ...]
    webs: tuple[Web, ...]
    collars: tuple[Collar, ...]
    found: bool
    """Whether walls carry them: by what is here, or because they stand in one."""

    @property
    def volume(self) -> float:
        """[m³]"""
        return sum(web.volume for web in self.webs) + sum(collar.volume for collar in self.collars)


class _Boss(NamedTuple):
    """The boss of one bearing."""

    bearing: BearingSizing
    radius: float
    low: float
    high: float


def carried_bosses(sizing: Sizing, wall: float) -> tuple[Carried, ...]:
    """Return how the housing carries the bosses of bearings on built shafts; nothing where it is none of its own.

    Args:
        sizing: As sized.
        wall: Thickness of the housing's wall [m].

    Collars are at most as long as their boss is wide outside, and bear 2 F/A of shear.

    Source: webs built in at both ends: F = Σ k_i (u_i·δ) u_i with k_i ~ 1/L_i within the cross-section, shares
        ~ 1/L_i³ and moments F_i L_i/2 along the shaft; σ = N/A + M/W ≤ 2 τ (Tresca), τ the working stress.
    """
    if not sizing.bearings or not sizing.design.housing.own:
        return ()
    holders = holders_of(sizing)
    bodies = housed(sizing)
    rooms = rooms_around(bodies, wall)
    obstacles = [*sizing.arrangement.bodies, *(body for body in bodies if body not in sizing.arrangement.bodies)]
    material = housing_materials()[sizing.design.housing.material]
    balls = np.array([ball_around(body) for body in obstacles])
    place = Around(rooms, obstacles, balls, wall, material)
    outsides = bosses_of(sizing, holders)
    return tuple(_carried(sizing, group, holders, place) for group in _groups(sizing, outsides))


def _groups(sizing: Sizing, outsides: dict[str, float]) -> Iterator[list[_Boss]]:
    """Yield the bosses of bearings that stand beside each other on one shaft, nearer than the narrower is wide."""
    for shaft in sizing.built_shafts:
        own = sorted((one for one in sizing.bearings if one.shaft == shaft.name), key=lambda one: one.position)
        group: list[_Boss] = []
        for one in own:
            half = one.width / 2.0
            boss = _Boss(one, outsides[one.name] / 2.0, one.position - half, one.position + half)
            if group and boss.low - group[-1].high > min(one.width, group[-1].bearing.width):
                yield group
                group = []
            group.append(boss)
        if group:
            yield group


def _carried(sizing: Sizing, group: Sequence[_Boss], holders: Sequence[Holder], place: Around) -> Carried:
    """Return the lightest way in which walls carry some bosses."""
    names = tuple(boss.bearing.name for boss in group)
    frame = sizing.arrangement.frames[group[0].bearing.shaft]
    joined = Carried(names, (), tuple(_between(group, holders, place)), found=False)
    forces = sum(boss.bearing.radial for boss in group), sum(abs(boss.bearing.axial) for boss in group)
    ways = list[Carried]()
    for boss, way in ((group[0], -1), (group[-1], 1)):
        collar = _collar(frame, boss, way, forces, holders, place)
        if collar is not None and collar.span[1] - collar.span[0] <= SUNK + CLEAR / 2.0:
            return joined._replace(found=True)
        if collar is not None:
            ways.append(joined._replace(collars=(*joined.collars, collar), found=True))
    for boss in group:
        webs = _cross(sizing, frame, boss, forces, place)
        if webs is not None:
            ways.append(joined._replace(webs=webs, found=True))
    return smallest(ways, lambda way: way.volume) if ways else joined


def _bears(place: Around) -> float:
    """Return the stress that webs and collars bear: twice the working shear stress of the housing, by Tresca [Pa]."""
    return 2.0 * place.material.shear_strength


def _between(group: Sequence[_Boss], holders: Sequence[Holder], place: Around) -> Iterator[Collar]:
    """Yield what joins bosses beside each other on one shaft."""
    for one, other in pairwise(group):
        low, high = one.high, other.low
        if low < high:
            narrow = min(one, other, key=lambda boss: boss.radius)
            inner = _inner(one.bearing, (low, high), holders)
            outer = max(narrow.radius, inner + place.material.least_wall)
            yield Collar(one.bearing.name, one.bearing.shaft, (low, high), outer, inner)


def _inner(bearing: BearingSizing, span: tuple[float, float], holders: Sequence[Holder]) -> float:
    """Return the radius of the room that a collar leaves: as wide as the bore, and as what stands there [m]."""
    within = [holder.outer / 2.0 for holder in holders
              if holder.shaft == bearing.shaft and holder.start < span[1] and span[0] < holder.end]  # fmt: skip
    return max([bearing.outer_diameter / 2.0, *within])


def _collar(
    frame: Frame, boss: _Boss, way: int, forces: tuple[float, float], holders: Sequence[Holder], place: Around
) -> Collar | None:
    """Return the collar between the face of a boss and the wall before it; None where that is far or not free."""
    face = boss.low if way < 0 else boss.high
    axis = np.asarray(frame.along)
    angles = 2.0 * np.pi * np.arange(AROUND) / AROUND
    round_it = np.outer(np.cos(angles), frame.across) + np.outer(np.sin(angles), frame.up)
    own = [one for one in holders if one.beside == boss.bearing.name]
    span = (face, face + way * 2.0 * boss.radius)
    inner = _inner(boss.bearing, (min(span), max(span)), own)
    asked = math.sqrt(inner**2 + (4.0 * forces[0] + forces[1]) / (math.pi * _bears(place)))
    outer = max(boss.radius, inner + place.material.least_wall, asked)
    foot = np.asarray(frame.origin) + face * axis
    lengths = list[float]()
    for out in round_it:
        lengths.append(place.reach(foot + 0.5 * (inner + outer) * out, way * axis))
        if max(lengths) - min(lengths) > place.wall / 2.0 or lengths[-1] > 2.0 * boss.radius:
            return None
    length = max(lengths)
    places = np.arange(CLEAR, length - CLEAR, STEP)
    lines = [foot + radius * round_it for radius in (inner + CLEAR, outer)]
    points = np.concatenate([line[:, None] + way * places[None, :, None] * axis for line in lines]).reshape(-1, 3)
    if len(points) and not place.is_free(points, lambda body: _is_beside(body, boss, frame)):
        return None
    low, high = sorted((face, face + way * length))
    return Collar(boss.bearing.name, boss.bearing.shaft, (low, high), outer, inner)


def _is_beside(body: Body, boss: _Boss, frame: Frame) -> bool:
    """Tell whether a body is the boss itself, its bearing or a still ring or cover within a collar around them."""
    off = np.asarray(body.origin) - np.asarray(frame.origin)
    along = float(off @ np.asarray(frame.along))
    beside = float(np.linalg.norm(off - along * np.asarray(frame.along)))
    parallel = abs(float(np.asarray(body.direction) @ np.asarray(frame.along))) > 1.0 - 1e-9
    return parallel and beside < CLEAR and body.radius <= boss.radius + CLEAR and body.shaft == boss.bearing.shaft


def _cross(
    sizing: Sizing, frame: Frame, boss: _Boss, forces: tuple[float, float], place: Around
) -> tuple[Web, ...] | None:
    """Return the first cross of webs from a boss that finds a way and bears; None where none does.

    Those that end at once, as the boss stands in the wall there, carry, but nothing is drawn or weighed of them.
    """
    axis, first = np.asarray(frame.along), _plane(sizing, boss.bearing.shaft)
    other = np.cross(axis, first)
    for turn in range(TURNS):
        angles = math.pi / 2.0 * (turn / TURNS + np.arange(4))
        ways = np.outer(np.cos(angles), first) + np.outer(np.sin(angles), other)
        webs = _webs(frame, boss, ways, forces, place)
        if webs is not None:
            return tuple(web for web in webs if web.length > place.wall / 2.0)
    return None


def _plane(sizing: Sizing, shaft: str) -> Floats:
    """Return the unit vector, square to a shaft, towards the nearest other axis; along the first shaft from one that
    stands across it."""
    frames = sizing.arrangement.frames
    frame = frames[shaft]
    origin, axis = np.asarray(frame.origin), np.asarray(frame.along)
    if abs(axis[0]) < 0.5:
        along = np.array([1.0, 0.0, 0.0]) - axis[0] * axis
        return np.asarray(along / np.linalg.norm(along))
    ways = [np.asarray(other.origin) - origin for other in frames.values()]
    ways = [way - float(way @ axis) * axis for way in ways]
    far = [way for way in ways if float(np.linalg.norm(way)) > CLEAR]
    nearest = smallest(far, lambda way: float(np.linalg.norm(way))) if far else np.asarray(frame.across)
    return np.asarray(nearest / np.linalg.norm(nearest))


def _webs(frame: Frame, boss: _Boss, ways: Floats, forces: tuple[float, float], place: Around) -> list[Web] | None:
    """Return webs along those of some ways that are free, as thick as forces ask; None where they do not bear."""
    axis = np.asarray(frame.along)
    middle = np.asarray(frame.origin) + 0.5 * (boss.low + boss.high) * axis
    width, thickness = boss.high - boss.low, place.wall
    for _ in range(TRIES):
        webs = []
        for way in ways:
            start = middle + boss.radius * way
            length = place.reach(start, way)
            web = Web(boss.bearing.name, start, way, axis, length, width, thickness)
            if _is_free(web, place):
                webs.append(web)
        asked = _thickness(webs, forces, _bears(place), place.wall / 2.0)
        if asked <= thickness:
            return webs
        if asked > 2.0 * boss.radius:
            return None
        thickness = asked
    return None


def _is_free(web: Web, place: Around) -> bool:
    """Tell whether nothing stands in the way of a web."""
    across = web.across
    places = np.arange(CLEAR, web.length, STEP)
    if not len(places):
        return True
    corners = [x * web.width * web.along + y * web.thickness * across for x in (-0.5, 0.0, 0.5) for y in (-0.5, 0.5)]
    points = web.start + places[:, None, None] * web.way + np.array(corners)[None]
    return place.is_free(points.reshape(-1, 3))


def _thickness(webs: Sequence[Web], forces: tuple[float, float], stress: float, least: float) -> float:
    """Return how thick webs must be at one stress [m]; infinite where they hold a force one way only.

    Args:
        webs: Of one boss, of equal width.
        forces: Radial and axial [N].
        stress: Permissible [Pa].
        least: Length at which one is taken at least, as short webs do not bear all [m].
    """
    if len(webs) < 2:
        return math.inf
    lengths = np.maximum([web.length for web in webs], least)
    ways, width = np.array([web.way for web in webs]), webs[0].width
    stiffness = np.einsum("i,ij,ik->jk", 1.0 / lengths, ways, ways) + np.outer(webs[0].along, webs[0].along)
    if np.linalg.cond(stiffness) > 1e6:
        return math.inf
    pulled = np.linalg.norm(np.linalg.solve(stiffness, ways.T), axis=0) / lengths * forces[0]
    bent = forces[1] * lengths**-3 / np.sum(lengths**-3) * lengths / 2.0
    return float(np.max(pulled / width + 6.0 * bent / width**2) / stress)
