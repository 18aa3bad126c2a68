"""The solids of a housing: the shell that is weighed, chamber by chamber, its flanges, bosses around bearings."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import HOUSING
from gearwright.shape.record import Node
from gearwright.shape.shafts import bearing_bodies
from gearwright.shape.solids import Chamber, End, Opening, Solid, chamber_volume, has_room, round_hole, tube
from gearwright.shape.stands import Axes, axes_at, middle_of
from gearwright.sizing import Sizing
from gearwright.sizing.arranged import Body, Direction, Point, Station
from gearwright.sizing.mass import (
    BOSS,
    Flanges,
    Leaving,
    Stretch,
    flanges_of,
    housed,
    leaving_of,
    outline_of,
    reaction_torque,
    shell_around,
    stretches_around,
    wall_of,
)
from gearwright.sizing.places import Run
from gearwright.sizing.shafts import holders_of

SAME = 1e-4
"""Steps of a wall that are less are none [m]."""
LIP = 2e-4
"""How far a plate stands inside of its own wall [m]."""
SAME_WAY = 1e-9
"""How far directions of one line may differ [-]."""
NEAR = 1e-7
"""Corners that are nearer are one [m]."""
LEAST = 2.0
"""Length of a chamber over the wall's thickness, below which it is one with its neighbour [-]."""
CHAMBER = "chamber"
"""What pieces of the shell are named."""
FLANGES = "flange"
"""What halves of flanges are named."""
NEARLY = (0.8, 0.6, 0.4, 0.0)
"""Perimeter over the longest one from which a cross-section carries flanges [-]: the width of flanges grows with it."""
ROOM = 3.6
"""From flange to flange over the thickness of a half [-]: both halves, nut, washer and end of a screw."""
AROUND = 1.06
"""Hole for a shaft over the shaft's diameter [-]: as much as the housing leaves around what turns."""


STEPS, ALIKE = 8, 1e-3
"""How often a wall is tried, and how near the metal is to what is weighed [-]."""
Hole = tuple[tuple[float, float], Floats, float]
"""Where along the first shaft plates may stand that it goes through, middle across it and radius of a hole [m]."""


class Piece(NamedTuple):
    """A solid of the housing and where it stands."""

    name: str
    key: str
    """Equal solids share one."""
    solid: Chamber | Solid
    axes: Axes


def housing_nodes(
    sizing: Sizing, drawn: tuple[Run, ...], inside: Iterable[tuple[Node, Solid]]
) -> Iterator[tuple[Node, Chamber | Solid]]:
    """Yield the housing's pieces; none where the gearbox has none of its own.

    Args:
        sizing: As sized.
        drawn: Shafts as they are drawn.
        inside: Bodies on shafts and carriers, about their own axes, with their solids.
    """
    still = dict.fromkeys(sizing.flows, 0.0)
    bodies = [*housed(sizing), *(_envelope(node, solid, _within(sizing, node)) for node, solid in inside)]
    for piece in _pieces(sizing, drawn, bodies) if sizing.design.housing.own else ():
        yield Node(piece.name, HOUSING, "housing", piece.key, piece.axes, 0.0, still), piece.solid


def _within(sizing: Sizing, node: Node) -> tuple[float, float]:
    """Return between which places about its own z a body is in the housing: a shaft less the ends that leave [m]."""
    low, high = -math.inf, math.inf
    for leaving in leaving_of(sizing) if node.look == "shaft" else ():
        if leaving.shaft == node.part.name:
            frame = sizing.arrangement.frames[leaving.shaft]
            middle = float((node.axes.origin - np.array(frame.origin)) @ np.array(frame.along))
            low, high = (low, leaving.start - middle) if leaving.start else (leaving.end - middle, high)
    return low, high


def _envelope(node: Node, solid: Solid, within: tuple[float, float]) -> Body:
    """Return the circles between which a body lies, as far as it is in the housing."""
    circles = list(solid.profile)
    for section in solid.sections[:: max(len(solid.sections) - 1, 1)]:
        radius = float(section.radius.max())
        circles += [(float(section.height.min()), radius), (float(section.height.max()), radius)]
    circles = [(min(max(place, within[0]), within[1]), radius) for place, radius in circles]
    low = min(place for place, _ in circles)
    stations = tuple(Station(place - low, radius) for place, radius in sorted(circles))
    axis = node.axes.along
    return Body(HOUSING, "", "", Point(*(node.axes.origin + low * axis)), Direction(*axis), stations)


def _pieces(sizing: Sizing, drawn: tuple[Run, ...], bodies: Sequence[Body]) -> Iterator[Piece]:
    shell = shell_around(housed(sizing))
    wall = wall_of(sizing, shell).thickness
    stretches = _nested(_long_enough(list(stretches_around(bodies)), wall))
    metal = shell.area * wall if sizing.design.housing.wall is None else None
    through = [*_leaving(sizing, drawn), *_leaving_built(sizing)], list(_across(sizing))
    wall, chambers = _as_weighed(stretches, through, wall, metal)
    axes = Axes(np.zeros(3), np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
    for k, chamber in enumerate(chambers):
        name = f"housing, {CHAMBER} {k + 1}"
        yield Piece(name, name, chamber, axes)
    flanges = flanges_of(sizing, shell, reaction_torque(sizing))
    for k, (place, key, half) in enumerate(_flanges(flanges, stretches, wall)):
        moved = Axes(np.array([place, 0.0, 0.0]), axes.turned)
        yield Piece(f"housing, {FLANGES} {k // 2 + 1}{'ab'[k % 2]}", f"housing {FLANGES}{key}", half, moved)
    for part, body in bearing_bodies(sizing):
        name, span = f"housing, boss of {part}", (-body.length / 2.0, body.length / 2.0)
        boss = tube(span, body.radius * (1.0 + 2.0 * BOSS), body.radius)
        yield Piece(name, name, boss, axes_at(sizing.arrangement.frames[body.shaft], middle_of(body)))


def _as_weighed(
    stretches: list[Stretch], leaving: tuple[list[Hole], list[Opening]], wall: float, metal: float | None
) -> tuple[float, list[Chamber]]:
    """Return the wall with which the chambers have the metal that is weighed, A t of a thin shell, and the chambers.

    A wall that the design gives stands: no metal is asked for.
    """
    for _ in range(STEPS):
        chambers = [_chamber(stretches, k, wall, leaving) for k in range(len(stretches))]
        share = metal / sum(map(chamber_volume, chambers)) if metal else 1.0
        if abs(share - 1.0) < ALIKE:
            break
        wall *= share
    return wall, chambers


def _long_enough(stretches: list[Stretch], wall: float) -> list[Stretch]:
    """Return cross-sections without steps that are too short to be cast: they are as wide as what is beside them."""
    found = list(stretches)
    while len(found) > 1:
        k = min(range(len(found)), key=lambda k: found[k].length)
        if found[k].length >= LEAST * wall:
            break
        beside = [j for j in (k - 1, k + 1) if 0 <= j < len(found)]
        j = min(beside, key=lambda j: abs(found[j].area - found[k].area))
        low, high = min(j, k), max(j, k)
        wide, least = (np.maximum(one, other) for one, other in zip(found[low][2:4], found[high][2:4], strict=True))
        larger = max(found[j], found[k], key=lambda one: one.area)
        one = larger._replace(start=found[low].start, end=found[high].end, reach=wide, least=least)
        found[low : high + 1] = [one]
    return found


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


def _chamber(stretches: list[Stretch], k: int, wall: float, leaving: tuple[list[Hole], list[Opening]]) -> Chamber:
    """Return a chamber; the plate of a step belongs to its wider side, and stands beside what turns in it."""
    own, span, ends = stretches[k], [stretches[k].start, stretches[k].end], list[End | None]()
    for side, way in ((0, -1), (1, 1)):
        beside = stretches[k + way] if 0 <= k + way < len(stretches) else None
        plane = span[side]
        wider = beside is None or bool(np.any(own.reach > beside.reach + SAME))
        if not wider:
            span[side] -= way * wall
            ends.append(None)
            continue
        span[side] += way * wall
        holes = [] if beside is None else [_outline(np.minimum(_inside(own, wall) - LIP, _inside(beside, wall)))]
        for (low, high), middle, radius in leaving[0]:
            through = beside is not None and _fits(beside.reach + wall, middle, -radius)
            is_there = low - LEAST * wall < plane < high + LEAST * wall
            if is_there and not through and _fits(_inside(own, wall), middle, radius):
                holes.append(round_hole(middle, radius))
        ends.append(End(wall, tuple(holes)))
    inside = _inside(own, wall)
    found = Chamber(_outline(inside + wall), _outline(inside), (span[0], span[1]), (ends[0], ends[1]))
    return found._replace(openings=tuple(opening for opening in leaving[1] if has_room(found, opening)))


def _inside(own: Stretch, wall: float) -> Floats:
    """Return how far the inside of a wall is: the wall's middle where it is weighed, where there is room for it."""
    corners = _outline(own.reach - wall / 2.0)
    return np.asarray(np.maximum(np.max(corners @ _ways(len(own.reach)).T, axis=0), own.least))


def _ways(count: int) -> Floats:
    angle = 2.0 * math.pi * np.arange(count) / count
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _fits(reach: Floats, middle: Floats, radius: float) -> bool:
    """Tell whether a circle lies in a cross-section; of a negative radius, whether any of it does."""
    return bool(np.all(_ways(len(reach)) @ middle + radius < reach))


def _outline(reach: Floats) -> Floats:
    """Return the corners of the polygon n·p ≤ h, also where some of its sides lie outside of others [m]."""
    loop, ways = outline_of(reach), _ways(len(reach))
    if np.all(loop @ ways.T <= reach + NEAR):
        return _cleaned(loop)
    wide = 2.0 * float(np.max(np.abs(reach)))
    corners = [complex(wide, -wide), complex(wide, wide), complex(-wide, wide), complex(-wide, -wide)]
    for way, limit in zip((ways[:, 0] - 1j * ways[:, 1]).tolist(), reach.tolist(), strict=True):
        far = [(corner * way).real - limit for corner in corners]
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
    return np.asarray(loop[np.linalg.norm(loop - np.roll(loop, 1, axis=0), axis=1) > NEAR])


def _leaving(sizing: Sizing, drawn: tuple[Run, ...]) -> Iterator[Hole]:
    """Yield the holes for ends of shafts of a first sizing along the first one that join machines [m]."""
    ends: dict[tuple[float, ...], Hole] = {}
    built = {shaft.name for shaft in sizing.built_shafts}
    for machine, shaft in sizing.train.machines.items():
        if shaft in built:
            continue
        frame, runs = sizing.arrangement.frames[shaft], [run for run in drawn if run.shaft == shaft]
        if abs(frame.along.x) < 1.0 - SAME_WAY or not runs:
            continue
        steps = [step for run in runs for step in run.steps]
        low, high = min(steps), max(steps, key=lambda step: step[1])
        place = sizing.arrangement.plans[shaft].places[machine]
        end, radius = (low[0], low[2]) if place - low[0] < high[1] - place else (high[1], high[2])
        place = frame.origin.x + end * frame.along.x
        found = ((place, place), np.array([frame.origin.y, frame.origin.z]), AROUND * radius)
        key = tuple(np.round([place, *found[1]], 4))
        ends[key] = max(ends.get(key, found), found, key=lambda one: one[2])  # one shaft within the other
    yield from ends.values()


def _passing(sizing: Sizing) -> Iterator[tuple[Leaving, float]]:
    """Yield the ends of shafts that leave, and the radius of what goes round there, rings and nuts too [m]."""
    for leaving in leaving_of(sizing):
        around = [holder.outer / 2.0 for holder in holders_of(sizing)
                  if holder.shaft == leaving.shaft and holder.turns
                  and holder.start > leaving.start - NEAR and holder.end < leaving.end + NEAR]  # fmt: skip
        yield leaving, AROUND * max([leaving.radius, *around])


def _leaving_built(sizing: Sizing) -> Iterator[Hole]:
    """Yield the holes for ends of built shafts along the first one that leave towards machines [m]."""
    for leaving, radius in _passing(sizing):
        frame = sizing.arrangement.frames[leaving.shaft]
        if abs(frame.along.x) > 1.0 - SAME_WAY:
            places = sorted(frame.origin.x + at * frame.along.x for at in (leaving.start, leaving.end))
            yield (places[0], places[1]), np.array([frame.origin.y, frame.origin.z]), radius


def _across(sizing: Sizing) -> Iterator[Opening]:
    """Yield the openings for ends of built shafts square to the first one that leave towards machines."""
    for leaving, radius in _passing(sizing):
        frame = sizing.arrangement.frames[leaving.shaft]
        if abs(frame.along.x) < SAME_WAY:
            sign, place = (1.0, leaving.start) if leaving.start else (-1.0, leaving.end)
            along, origin = (np.array([one.y, one.z, one.x]) for one in (frame.along, frame.origin))
            yield Opening(sign * along[:2], origin + place * along, radius)


def _flanges(flanges: Flanges, stretches: Sequence[Stretch], wall: float) -> Iterator[tuple[float, str, Chamber]]:
    """Yield place, key and solid of both halves of every flange, as heavy as they are weighed."""
    for k, place in _joints(stretches, flanges.number, flanges.thickness, wall):
        solid = _flange(_inside(stretches[k], wall) + wall, flanges.face, flanges.thickness)
        yield place - flanges.thickness, f" {k + 1}", solid
        yield place, f" {k + 1}", solid


def _joints(stretches: Sequence[Stretch], count: int, thick: float, wall: float) -> list[tuple[int, float]]:
    """Return number of the cross-section and place of every flange, from the first end to the last [m].

    They stand apart around cross-sections nearly as long around as the longest one; where there is no room for screws
    between them, around shorter ones, too.
    """
    longest, found = max(one.perimeter for one in stretches), list[tuple[int, float]]()
    free = [_beside_plates(stretches, k, 2.0 * thick + wall) for k in range(len(stretches))]
    for least in NEARLY:
        wide = [k for k, one in enumerate(stretches) if one.perimeter >= least * longest and free[k][0] <= free[k][1]]
        ends = np.cumsum([stretches[k].length for k in wide])
        found = []
        for share in np.linspace(0.0, float(ends[-1]), count):
            j = int(np.searchsorted(ends, share - NEAR))
            place = stretches[wide[j]].end + share - float(ends[j])
            low, high = free[wide[j]]
            found.append((wide[j], min(max(place, low), high)))
        if all(other[1] - one[1] > ROOM * thick for one, other in pairwise(found)):
            break
    return found


def _beside_plates(stretches: Sequence[Stretch], k: int, room: float) -> tuple[float, float]:
    """Return from where to where a flange may stand: away from plates of wider chambers beside its own [m]."""
    own, low, high = stretches[k], stretches[k].start, stretches[k].end
    if k > 0 and np.any(stretches[k - 1].reach > own.reach + SAME):
        low += room
    if k + 1 < len(stretches) and np.any(stretches[k + 1].reach > own.reach + SAME):
        high -= room
    return low, high


def _flange(reach: Floats, face: float, thick: float) -> Chamber:
    """Return one half of a flange around a wall: as wide as its face is large [m²]."""
    inner = _outline(reach)
    around = float(np.sum(np.linalg.norm(np.roll(inner, -1, axis=0) - inner, axis=1)))
    more = len(reach) * math.tan(math.pi / len(reach))
    wide = (math.sqrt(around**2 + 4.0 * more * face) - around) / (2.0 * more)
    return Chamber(_outline(reach + wide), inner, (0.0, thick))
