"""Walls across a housing between its stages, in which the bearings of shafts will stand that have no place yet."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Kind, smallest
from gearwright.sizing.casing import LAND_OVERLAP, Span, area_of, in_housing, outline_about
from gearwright.sizing.housing_shell import CLEAR, inside_of, rooms_around, ways_of
from gearwright.sizing.places import IN_LINE
from gearwright.sizing.result import Body, Sizing

# ----------------------------------------------------------------------------------------------------------------------
# One wall between stages that stand behind each other: bearings of the shafts that go on from one to the next need it.
#
# Where bearings have their places, webs and collars carry their bosses, and no wall is assumed.
# ----------------------------------------------------------------------------------------------------------------------


HOLE = 1.6
"""Hole of an inner wall over the shafts that go through it [-]: outside of bearings of a light series of ISO 15."""
APART = 1e-6
"""Between bodies that have a wall between them, at least [m]."""


class InnerWall(NamedTuple):
    """A wall across the first shaft, with one hole around all shafts that go through it."""

    span: Span
    """Along the first shaft [m]."""
    outer: Floats
    """Outline, y and z [m], shape (n, 2)."""
    inner: Floats
    """The hole, corner by corner [m], shape (n, 2)."""
    volume: float
    """[m³]"""
    fits: bool
    """Whether stages leave room for it, as first sizings keep none free: else it is weighed and not drawn."""


def inner_walls(sizing: Sizing, wall: float) -> tuple[InnerWall, ...]:
    """Return the walls between stages behind each other, of a housing of the gearbox's own without sized bearings.

    Args:
        sizing: As sized.
        wall: Thickness of the housing's wall, which is theirs [m].

    Source: a wall for every plane of bearings that is not at an end of the housing; where it is, an assumption: in the
        middle of the gap.
    """
    if sizing.bearings or not sizing.design.housing.own:
        return ()
    return _walls(sizing.arrangement.bodies, in_housing(sizing), wall)


def _walls(placed: Sequence[Body], bodies: tuple[Body, ...], wall: float) -> tuple[InnerWall, ...]:
    """Return the walls in gaps between bodies that only shafts pass."""
    gaps = _gaps(bodies)
    if not gaps:
        return ()
    rooms, found = rooms_around(bodies, wall), list[InnerWall]()
    for low, high in gaps:
        place = (low + high) / 2.0
        room = smallest(
            [room for room in rooms if room.start - wall <= place <= room.end + wall], lambda room: room.area
        )
        circles = [(np.array([body.origin.y, body.origin.z]), HOLE * body.radius)
                   for body in placed if _passes(body, place)]  # fmt: skip
        if not circles:
            continue
        ways = ways_of(len(room.reach))
        hole = np.max([ways @ centre + radius for centre, radius in circles], axis=0)
        outside = inside_of(room, wall)
        if np.all(hole < outside):
            reach = outside + max(LAND_OVERLAP[0] * wall, LAND_OVERLAP[1])
            middle = np.mean([centre for centre, _ in circles], axis=0)
            outer, inner = outline_about(reach, middle), outline_about(hole, middle)
            span = (place - wall / 2.0, place + wall / 2.0)
            volume, fits = (area_of(outer) - area_of(inner)) * wall, high - low > wall + 2.0 * CLEAR
            found.append(InnerWall(span, outer, inner, volume, bool(fits)))
    return tuple(found)


def _gaps(bodies: Sequence[Body]) -> tuple[Span, ...]:
    """Return the gaps along the first shaft between stages, gears with the plates of carriers [m]."""
    stages = dict[str, Span]()
    for body in bodies:
        if body.part.kind in (Kind.GEAR, Kind.CARRIER):
            low, high = _extent(body)
            one = stages.get(body.part.name, (low, high))
            stages[body.part.name] = min(one[0], low), max(one[1], high)
    gaps, spans = list[Span](), sorted(stages.values())
    reached = spans[0][1]
    for low, high in spans[1:]:
        if low > reached + APART:
            gaps.append((reached, low))
        reached = max(reached, high)
    return tuple(gaps)


def _passes(body: Body, place: float) -> bool:
    """Tell whether a body is a shaft along the first one that goes through a plane across it."""
    low, high = _extent(body)
    return body.part.kind is Kind.SHAFT and abs(body.direction.x) > 1.0 - IN_LINE and low < place < high


def _extent(body: Body) -> Span:
    """Return from where to where a body reaches along the first shaft [m]."""
    across = math.sqrt(max(1.0 - body.direction.x**2, 0.0))
    low = min(body.origin.x + one.place * body.direction.x - across * one.radius for one in body.stations)
    high = max(body.origin.x + one.place * body.direction.x + across * one.radius for one in body.stations)
    return low, high
