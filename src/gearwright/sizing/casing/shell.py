"""The shell that a housing is: cross-sections around all bodies, slice by slice along the first shaft.

A circle of radius r square to a reaches h(n) = c·n + r |n − (n·a) a| in a direction n; the hull of a slice is bounded
by the largest h of all bodies in it. With n at equal angles δ the polygon around them has sides
l_i = (h_{i−1} + h_{i+1} − 2 h_i cos δ)/sin δ, the perimeter Σ l and the area Σ h l / 2; around a circle both are 0.1 %
too large.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, following
from gearwright.identity import Kind
from gearwright.sizing.arranged import Body, Direction, Point

_SIDES = 48
"""Sides of the polygon around a slice [-]."""
LEAST_CLEARANCE = 1.02
"""Inside of a wall as drawn over what turns in it [-]: 1 % of the diameter on either side, an estimate."""
CLEARANCE = 1.06
"""Inside of the housing over what turns in it [-]: 3 % of the diameter on either side, an estimate."""
SAME = 1e-4
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

    @property
    def area(self) -> float:
        """All walls [m²]."""
        return self.lateral + self.ends


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
        if found and np.allclose(found[-1].reach, wide.reach, rtol=0.0, atol=SAME):
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
