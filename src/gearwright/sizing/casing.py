"""Housing of a sized gearbox: enclosed bodies, support webs, flanges and ring gear seats.

What it weighs is for `sizing.mass`, its solids for `shape`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import HOUSING, Floats, Kind, following, smallest
from gearwright.catalogue import housing_materials
from gearwright.memo import of_latest
from gearwright.parts.shafts import MODULES, ROOT_DEPTH, Spline, spline, spline_length, spline_pressure
from gearwright.sizing.gear_geometry import ring_radii
from gearwright.sizing.housing_shell import (
    CLEAR,
    SUNK,
    Around,
    Shell,
    Stretch,
    ball_around,
    inside_of,
    rooms_around,
    shell_around,
    stretches_around,
    ways_of,
)
from gearwright.sizing.places import ring_torque
from gearwright.sizing.places.bodies import plates_of
from gearwright.sizing.result import Body, Frame, GearSizing, Point, Sizing, Station
from gearwright.sizing.shaft_results import BearingSizing
from gearwright.sizing.shafts import Holder, holders_of
from gearwright.sizing.shafts.ends import NEAR, Leaving, leaving_of
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# What a housing stands around: all but the ends of built shafts that leave it, with bosses and covers of bearings.
# ----------------------------------------------------------------------------------------------------------------------


Span = tuple[float, float]
"""From one place to the next along an axis [m]."""
BOSS = 0.12
"""Wall of a bearing's boss over the bearing's outside diameter [-], an estimate."""


@of_latest(1)
def housed(sizing: Sizing) -> tuple[Body, ...]:
    """Return the bodies around which a housing stands: all but the ends of built shafts that leave it.

    Bosses of bearings on built shafts are among them, and what holds bearings but where a shaft leaves: a cover there
    lies in the wall.

    Args:
        sizing: As sized.
    """
    ends = tuple(leaving_of(sizing))
    inside = [body for body in sizing.arrangement.bodies if not any(_is_in(sizing, body, end) for end in ends)]
    return (*inside, *_still(sizing, ends))


@of_latest(1)
def shell_of(sizing: Sizing) -> Shell:
    """Return the shell of a housing around all that stands in it.

    Args:
        sizing: As sized.

    Where a ring is bolted between two housings, it is the wall itself: no shell goes around it there.
    """
    shell, cuts = shell_around(housed(sizing)), ring_cuts(sizing)
    if not cuts:
        return shell
    rooms = stretches_around(housed(sizing))
    lengths = [(room.perimeter, min(room.end, high) - max(room.start, low)) for room in rooms for low, high in cuts]
    rings = sum(around * length for around, length in lengths if length > 0.0)
    return shell._replace(lateral=shell.lateral - rings, rings=rings)


RIM = 0.1
"""Of a bolted ring's width on either side, over which the flange of the housing reaches [-], an estimate."""


@of_latest(1)
def ring_cuts(sizing: Sizing) -> tuple[Span, ...]:
    """Return between which places along the first shaft a ring stands in place of the housing's wall [m].

    Args:
        sizing: As sized.
    """
    found = []
    for ring in bolted_rings(sizing):
        frame, middle = ring_frame(sizing, ring)
        if abs(frame.along.x) > 1.0 - PARALLEL:
            centre, half = frame.origin.x + frame.along.x * middle, (0.5 - RIM) * ring.face_width
            found.append((centre - half, centre + half))
    return tuple(sorted(found))


def bolted_rings(sizing: Sizing) -> tuple[GearSizing, ...]:
    """Return the rings that stand between two housings, bolted to both.

    Args:
        sizing: As sized.
    """
    rules, sets = sizing.design.housing, sizing.design.sets
    if not rules.own or rules.rings != "bolted":
        return ()
    return tuple(one for one in sizing.gears if one.rim and one.stage in sets and one.shafts[0] == GROUND)


def bosses_of(sizing: Sizing, holders: Sequence[Holder]) -> dict[str, float]:
    """Return bearing of a built shaft -> outside diameter of its boss [m].

    Args:
        sizing: As sized.
        holders: Of it.

    Source: a wall of 0.12 D, an estimate; as wide as its cover and the thinnest wall around it.
    """
    least = housing_materials()[sizing.design.housing.material].least_wall
    found = {bearing.name: (1.0 + 2.0 * BOSS) * bearing.outer_diameter for bearing in sizing.bearings}
    for holder in holders:
        if holder.kind == "cover":
            found[holder.beside] = max(found[holder.beside], holder.outer + 2.0 * least)
    return found


def cover_at(holders: Sequence[Holder], leaving: Leaving) -> Holder | None:
    """Return the cover through which the end of a shaft leaves; None where there is none.

    Args:
        holders: Of the sizing.
        leaving: The end.
    """
    covers = [holder for holder in holders if holder.kind == "cover" and holder.shaft == leaving.shaft]
    beyond = [cover for cover in covers if leaving.way * ((cover.start + cover.end) / 2.0 - leaving.face) > 0.0]
    return next(iter(beyond), None)


def _still(sizing: Sizing, ends: tuple[Leaving, ...]) -> Iterator[Body]:
    """Yield bosses, and what holds bearings within the housing, not where a shaft leaves."""
    holders = holders_of(sizing)
    yield from boss_bodies(sizing, holders).values()
    for holder in holders:
        beyond = (
            end.way * (holder.start + holder.end - 2.0 * end.face) > 0.0 for end in ends if end.shaft == holder.shaft
        )
        if not any(beyond):
            yield _round(sizing, holder.shaft, (holder.start, holder.end), holder.outer)


def boss_bodies(sizing: Sizing, holders: Sequence[Holder]) -> dict[str, Body]:
    """Return bearing of a built shaft -> its boss.

    Args:
        sizing: As sized.
        holders: Of it.
    """
    bosses, found = bosses_of(sizing, holders), dict[str, Body]()
    for bearing in sizing.bearings:
        span = (bearing.position - bearing.width / 2.0, bearing.position + bearing.width / 2.0)
        found[bearing.name] = _round(sizing, bearing.shaft, span, bosses[bearing.name])
    return found


def cover_bodies(sizing: Sizing, holders: Sequence[Holder]) -> list[tuple[str, Body]]:
    """Return the plates and necks of covers, each with the bearing that its cover is beside.

    Args:
        sizing: As sized.
        holders: Of it.
    """
    return [
        (holder.beside, _round(sizing, holder.shaft, (ring.start, ring.end), ring.outer))
        for holder in holders if holder.kind == "cover" for ring in holder.rings
    ]  # fmt: skip


def _round(sizing: Sizing, shaft: str, span: tuple[float, float], diameter: float) -> Body:
    frame = sizing.arrangement.frames[shaft]
    origin = Point(*(np.asarray(frame.origin) + span[0] * np.asarray(frame.along)).tolist())
    circles = (Station(0.0, diameter / 2.0), Station(span[1] - span[0], diameter / 2.0))
    return Body(HOUSING, shaft, "", origin, frame.along, circles)


def _is_in(sizing: Sizing, body: Body, end: Leaving) -> bool:
    """Tell whether a body is a stretch of such an end."""
    if body.part.kind is not Kind.SHAFT or body.shaft != end.shaft:
        return False
    frame = sizing.arrangement.frames[end.shaft]
    place = float((np.asarray(body.origin) - np.asarray(frame.origin)) @ np.asarray(frame.along))
    return end.start - NEAR <= place and place + body.length <= end.end + NEAR


# ----------------------------------------------------------------------------------------------------------------------
# What carries the bosses of bearings: webs and collars from each boss to the walls around it, where nothing turns.
#
# Bosses beside each other on one shaft are one. Of what finds a way (a collar around the axis to the next wall, or a
# cross of webs) the lightest is taken. Webs are as wide along the shaft as their boss and as thick as forces ask: each
# is built in at both ends; together they hold the radial force, whichever way it acts, and the axial one.
# ----------------------------------------------------------------------------------------------------------------------


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
        ~ 1/L_i³ and moments F_i L_i/2 along the shaft; σ = N/A + M/W ≤ the working normal stress.
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
    asked = math.sqrt(inner**2 + (4.0 * forces[0] + forces[1]) / (math.pi * place.material.bending_strength))
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
        asked = _thickness(webs, forces, place.material.bending_strength, place.wall / 2.0)
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
    shares = web_shares(webs, forces, least)
    if shares is None:
        return math.inf
    width = webs[0].width
    return float(np.max(shares.pulls / width + 6.0 * shares.moments / width**2) / stress)


class WebShares(NamedTuple):
    """What each web of one boss bears, shape (webs,)."""

    pulls: Floats
    """Along it, whichever way the radial force acts [N]."""
    moments: Floats
    """At both of its ends, by the axial force [N m]."""


def web_shares(webs: Sequence[Web], forces: tuple[float, float], least: float) -> WebShares | None:
    """Return what webs bear of the forces on their boss; None where they hold a force one way only.

    Args:
        webs: Of one boss, of equal width.
        forces: Radial and axial [N].
        least: Length at which one is taken at least, as short webs do not bear all [m].

    Source: `carried_bosses`.
    """
    if len(webs) < 2:
        return None
    lengths = np.maximum([web.length for web in webs], least)
    ways = np.array([web.way for web in webs])
    stiffness = np.einsum("i,ij,ik->jk", 1.0 / lengths, ways, ways) + np.outer(webs[0].along, webs[0].along)
    if np.linalg.cond(stiffness) > 1e6:
        return None
    pulled = np.linalg.norm(np.linalg.solve(stiffness, ways.T), axis=0) / lengths * forces[0]
    bent = forces[1] * lengths**-3 / np.sum(lengths**-3) * lengths / 2.0
    return WebShares(np.asarray(pulled), np.asarray(bent))


# ----------------------------------------------------------------------------------------------------------------------
# Flanges of a housing: how many screws of which thread hold two halves together, how wide and thick those are.
# ----------------------------------------------------------------------------------------------------------------------


WIDTH, THICKNESS = 2.5, 1.2
"""Of each of the two halves of a flange, over its screws [-]: usual proportions of cast housings."""
THREADS = (6e-3, 8e-3, 10e-3, 12e-3, 16e-3, 20e-3, 24e-3, 30e-3, 36e-3, 42e-3, 48e-3, 56e-3, 64e-3)
"""Coarse threads of the first choice of ISO 261, from the thinnest that is usual in housings [m]."""
PITCH = 5.0
"""Largest distance of screws over their diameter [-]: room for a spanner, and no gap between."""
PRELOAD = 700e6
"""Of screws of class 10.9, in their section [Pa]: three quarters of R_p0.2 = 940 MPa (ISO 898-1)."""
FRICTION = 0.15
"""Of a flange's faces [-]: dry steel or iron."""
LENGTH, HEAD, NUT, WASHER = 4.0, (1.6, 0.65), (1.6, 0.87), (2.0, 0.25)
"""Over its diameter [-]: length of a screw, which reaches through both halves, nut and two washers; across flats and
height of head and nut, diameter and thickness of a washer: M6 to M20 of ISO 4017, ISO 4032 and ISO 7089, rounded."""
HOLE = 1.1
"""Clearance hole over the screw [-]: ISO 273, medium, from M6 to M20."""


class Flanges(NamedTuple):
    """Equal flanges of a housing."""

    number: int
    """How many of them [-]."""
    thread: float
    """Diameter of their screws [m]."""
    screws: int
    """Of each [-]."""
    girth: float
    """Perimeter of the wall that they are weighed around [m]."""

    @property
    def thickness(self) -> float:
        """Of each half [m]."""
        return THICKNESS * self.thread

    @property
    def face(self) -> float:
        """Area of each half's face, the holes of its screws not taken off [m²]."""
        return WIDTH * self.thread * self.girth


def flanges_of(sizing: Sizing, shell: Shell, torque: float) -> Flanges:
    """Return the flanges of a housing: one for every stage, at least one more than sets, two more for a bolted ring.

    Args:
        sizing: As sized.
        shell: Around it.
        torque: That each holds by its grip [N m].

    Source: n π/4 d² σ μ r = T with n = U/(5 d) screws on r = U/(2 π), rounded up to a thread and to whole screws.
    """
    wanted = 8.0 * PITCH * torque / (FRICTION * PRELOAD * shell.girth**2)
    thread = next((thread for thread in THREADS if thread >= wanted), wanted)
    number = max(len(sizing.design.stages), len(sizing.design.sets) + 1, 2) + 2 * len(bolted_rings(sizing))
    return Flanges(number, thread, math.ceil(shell.girth / (PITCH * thread)), shell.girth)


def screw_volume(thread: float) -> float:
    """Return the volume of a screw with nut and two washers [m³].

    Args:
        thread: Its diameter [m].

    >>> round(screw_volume(1.0), 2)
    6.92
    """
    heights = LENGTH * math.pi / 4.0
    heads = HEAD[1] * hexagon(HEAD[0]) + NUT[1] * (hexagon(NUT[0]) - math.pi / 4.0)
    washers = 2.0 * WASHER[1] * math.pi / 4.0 * (WASHER[0] ** 2 - HOLE**2)
    return (heights + heads + washers) * thread**3


def hexagon(flats: float) -> float:
    """Return the area of a hexagon [m²].

    Args:
        flats: Across them [m].
    """
    return math.sqrt(3.0) / 2.0 * flats**2


# ----------------------------------------------------------------------------------------------------------------------
# Seats of rings that stand in the housing: splines on their outside in a land of the housing, and a keeper.
#
# A land stands about the middle of its ring: a shoulder and the hub's teeth, before whose end a keeper is screwed. A
# ring so held centres itself on its planets as far as flanks leave play.
# ----------------------------------------------------------------------------------------------------------------------


MODULE = 0.008
"""Module of a seat's splines over the ring's outside diameter, at most [-], an assumption: half of the room within the
wall is left for the land."""
SHORTEST = 3.0
"""Length of a seat's splines over their module, at least [-], an assumption."""
SIDE = (1.0, 2e-3)
"""Width of a shoulder and of a keeper: over the module [-], and at least [m], assumptions."""
SPLINE_CLEARANCE, OVER = 0.25, 1.0
"""Between the ring's outside and what stands beside its teeth, and how far a keeper reaches over the land, over their
module [-], assumptions."""
LAND_OVERLAP = (0.1, 1e-3)
"""How far a land goes on into the wall, so that it is one piece with it: over the wall [-], and at least [m]."""
CORNERS = 48
"""Of a land's outline [-]."""
PARALLEL = 1e-9
"""One less the cosine between axes that count as parallel [-]."""


class RingSeat(NamedTuple):
    """How a ring is held against turning and along its axis; places along the axis from the ring's middle."""

    ring: GearSizing
    torque: float
    """Largest of all cases [N m]."""
    teeth: Spline
    pressure: float
    """On the flanks [Pa]."""
    permissible: float
    """[Pa]"""
    spline: Span
    """[m]"""
    keeper: Span
    """Of the ring that is screwed to the land beyond the splines [m]."""
    span: Span
    """Of the land, from the shoulder on to the end of the splines [m]."""

    @property
    def middle(self) -> float:
        """Radius at half the height of the teeth: what the ring has outside, the land inside [m]."""
        return (self.teeth.shaft_tip + self.teeth.hub_tip) / 4.0

    @property
    def clear(self) -> float:
        """Radius beside the teeth within shoulder and keeper [m]."""
        return self.teeth.shaft_root / 2.0 + SPLINE_CLEARANCE * self.teeth.module

    @property
    def outside(self) -> float:
        """Radius of the keeper's outside [m]."""
        return self.middle + OVER * self.teeth.module

    @property
    def name(self) -> str:
        """As of DIN 5480, of a reference diameter that is the ring's own."""
        teeth = self.teeth
        return f"{1e3 * teeth.reference_diameter:.4g} x {1e3 * teeth.module:g} x 30 x {teeth.teeth}"

    @property
    def teeth_volume(self) -> float:
        """Of the teeth on the ring [m³]."""
        return _annulus(self.middle, self.teeth.shaft_root / 2.0) * (self.spline[1] - self.spline[0])

    @property
    def keeper_volume(self) -> float:
        """Of the keeper [m³]."""
        return _annulus(self.outside, self.clear) * (self.keeper[1] - self.keeper[0])


class LandPiece(NamedTuple):
    """A stretch of a land: from an outline in the wall to a bore."""

    span: Span
    """Along the first shaft [m]."""
    outer: Floats
    """Outline across it, y and z [m], shape (n, 2)."""
    inner: Floats
    """The bore, corner by corner, as large as its circle [m], shape (n, 2)."""
    volume: float
    """[m³]"""


def ring_seats(sizing: Sizing) -> Iterator[RingSeat]:
    """Yield how the rings of sets that stand in a housing of the gearbox's own are held.

    Args:
        sizing: As sized.

    The module is the largest of DIN 5480-1 up to 0.008 of the ring's outside with which the land is no wider than the
    ring; the length is what the torque asks at the permissible pressure, twice the working shear stress of the housing
    (Tresca), 3 modules at least, and no more than the ring leaves.

    Source: p = 2 T/(d_m h l z k) as `spline_pressure`; that a turboprop's second ring is held by splines in its case,
        with plates for axial retention: U.S. Army, subcourse AL0993, figure 9.9; how long and with which module:
        assumptions. Wear of flanks that move is not assessed.
    """
    if not sizing.design.housing.own or sizing.design.housing.rings == "bolted":
        return
    permissible = 2.0 * housing_materials()[sizing.design.housing.material].shear_strength
    for ring in sizing.gears:
        if ring.rim and ring.stage in sizing.design.sets and ring.shafts[0] == GROUND:
            yield _seat(sizing, ring, permissible)


def _seat(sizing: Sizing, ring: GearSizing, permissible: float) -> RingSeat:
    outside, torque = 2.0 * ring_radii(sizing.design, ring)[1], ring_torque(sizing, ring)
    module = _module(min(MODULE * outside, ring.face_width / (SHORTEST + 2.0 * SIDE[0])))
    teeth, side = spline(outside + ROOT_DEPTH * module, module), max(SIDE[0] * module, SIDE[1])
    room = max(ring.face_width - 2.0 * side, SHORTEST * module)
    length = min(max(spline_length(torque, teeth, allowable=permissible), SHORTEST * module), room)
    pressure = spline_pressure(torque, teeth, length)
    half = length / 2.0
    return RingSeat(
        ring, torque, teeth, pressure, permissible, (-half, half), (half, half + side), (-half - side, half)
    )


def _module(most: float) -> float:
    """Return the largest module of the standard that is no larger than a length [m]; the smallest one if none is."""
    return max((size for size in MODULES if size <= most), default=MODULES[0])


def ring_frame(sizing: Sizing, ring: GearSizing) -> tuple[Frame, float]:
    """Return the frame of a shaft on a ring's axis, and where along it the ring's middle is [m].

    Args:
        sizing: As sized.
        ring: Of a set.
    """
    host = next(shaft for shaft in sizing.design.sets[ring.stage].members if shaft != GROUND)
    frame = sizing.arrangement.frames[host]
    body = next(body for body in sizing.arrangement.bodies if body.part == ring.part)
    start = float((np.asarray(body.origin) - np.asarray(frame.origin)) @ np.asarray(frame.along))
    return frame, start + float(np.asarray(body.direction) @ np.asarray(frame.along)) * body.length / 2.0


class Land(NamedTuple):
    """What holds a ring in the housing, one piece with its wall."""

    seat: RingSeat
    pieces: tuple[LandPiece, ...]
    """Its shoulder and its teeth; none about an axis across the first shaft, of which none is found."""

    @property
    def volume(self) -> float:
        """[m³]"""
        return sum(piece.volume for piece in self.pieces)


def lands_of(sizing: Sizing, wall: float) -> tuple[Land, ...]:
    """Return the lands in which the rings that stand in the housing sit.

    Args:
        sizing: As sized.
        wall: Thickness of the housing's wall [m].
    """
    seats = tuple(ring_seats(sizing))
    if not seats:
        return ()
    rings = tuple(
        _Held(*ring_frame(sizing, seat.ring), seat.span, seat.spline, seat.clear, seat.middle) for seat in seats
    )
    pieces = _pieces(in_housing(sizing), rings, wall)
    return tuple(Land(seat, own) for seat, own in zip(seats, pieces, strict=True))


class _Held(NamedTuple):
    """What a land's pieces follow from."""

    frame: Frame
    place: float
    span: Span
    spline: Span
    clear: float
    middle: float


def _pieces(bodies: tuple[Body, ...], rings: tuple[_Held, ...], wall: float) -> tuple[tuple[LandPiece, ...], ...]:
    """Return the pieces of the land of every ring, in a wall around bodies."""
    rooms = rooms_around(bodies, wall)
    return tuple(_pieces_of(ring, rooms, wall) for ring in rings)


def _pieces_of(ring: _Held, rooms: Sequence[Stretch], wall: float) -> tuple[LandPiece, ...]:
    frame = ring.frame
    if abs(frame.along.x) < 1.0 - PARALLEL:
        return ()
    way, middle = math.copysign(1.0, frame.along.x), np.array([frame.origin.y, frame.origin.z])
    centre = frame.origin.x + way * ring.place
    low, high = sorted(centre + way * end for end in ring.span)
    around = [inside_of(room, wall) for room in rooms if room.start < high and room.end > low]
    outer = outline_about(np.min(around, axis=0) + max(LAND_OVERLAP[0] * wall, LAND_OVERLAP[1]), middle)
    bores = (((ring.span[0], ring.spline[0]), ring.clear), (ring.spline, ring.middle))
    ends = [sorted(centre + way * end for end in span) for span, _ in bores]
    pieces: list[LandPiece] = []
    for (start, end), (_, bore) in zip(ends, bores, strict=True):
        inner = middle + _circle(bore)
        pieces.append(LandPiece((start, end), outer, inner, (area_of(outer) - area_of(inner)) * (end - start)))
    return tuple(pieces)


def in_housing(sizing: Sizing) -> tuple[Body, ...]:
    """Return all bodies that stand in the housing, with both plates of carriers.

    Args:
        sizing: As sized.
    """
    plates = [plate for stage in sizing.design.sets for plate in plates_of(sizing, stage)]
    return (*housed(sizing), *plates)


def outline_about(reach: Floats, middle: Floats) -> Floats:
    """Return points of a cross-section's outline at equal angles about a point within it [m], shape (n, 2).

    Args:
        reach: h of the cross-section in every direction [m].
        middle: The point [m].
    """
    ways, sides = ways_of(CORNERS), ways_of(len(reach))
    left, toward = reach - sides @ middle, ways @ sides.T
    far = np.where(toward > PARALLEL, left / np.where(toward > PARALLEL, toward, 1.0), math.inf)
    return np.asarray(middle + np.min(far, axis=1)[:, None] * ways)


def _circle(radius: float) -> Floats:
    """Return a polygon as large as a circle [m], shape (n, 2)."""
    step = 2.0 * math.pi / CORNERS
    return np.asarray(radius * math.sqrt(step / math.sin(step)) * ways_of(CORNERS))


def area_of(loop: Floats) -> float:
    """Return the area within a closed loop [m²].

    Args:
        loop: Its corners, counter-clockwise [m], shape (n, 2).
    """
    after = following(loop)
    return float(np.sum(loop[:, 0] * after[:, 1] - loop[:, 1] * after[:, 0]) / 2.0)


def _annulus(outer: float, inner: float) -> float:
    return math.pi * (outer**2 - inner**2)
