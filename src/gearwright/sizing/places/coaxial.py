"""Which bodies share an axis, and shafts of a first sizing that reach into each other there.

A first sizing does not work out which of two shafts on one axis is hollow, and where each ends. What it draws is held
against each other all the same: where envelopes run into each other, the room between the two is open, and said to be.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, combinations

from gearwright.checks import Check, not_assessed
from gearwright.identity import Kind, PartId, Role
from gearwright.sizing.arranged import Body
from gearwright.spec import GROUND

CLAUSE = "bodies in space"
"""Of checks of room between bodies."""
_CLOSE = 1e-9
"""Axes nearer than this are one [m]; so are directions [-]."""
_TOUCH = 1e-9
"""How far bodies may stand into each other by rounding [m]."""
_OPEN = (
    "on one axis their envelopes run into each other, and a first sizing does not work out which is hollow and where"
    " each ends: give both shafts [bearings], or [layout.SHAFT] a length_mm and places"
)


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


def coaxial_checks(bodies: Sequence[Body], sets: frozenset[str], built: frozenset[str]) -> Iterator[Check]:
    """Yield the shafts on one axis whose envelopes run into each other in a first sizing, two at a time.

    Args:
        bodies: Of a transmission.
        sets: Names of planetary sets.
        built: Shafts that are worked out along their axes.
    """
    if all(body.shaft in built for body in bodies):
        return
    told, on_axis = set[tuple[str, str]](), dict[int, list[Body]]()
    for body, number in zip(bodies, axes_among(bodies), strict=True):
        on_axis.setdefault(number, []).append(body)
    for one, other in chain.from_iterable(combinations(alike, 2) for alike in on_axis.values()):
        if one.shaft == other.shaft or (one.shaft in built and other.shaft in built):
            continue
        if not of_one_set(one, other, sets) and _meet(one, other):
            low, high = sorted((owner(one), owner(other)), key=str)
            if (str(low), str(high)) not in told:
                told.add((str(low), str(high)))
                yield not_assessed(high, f"room beside {low}", CLAUSE, _OPEN)


def _meet(one: Body, other: Body) -> bool:
    """Tell whether two bodies on one axis run into each other: side by side, or one in the bore of the other."""
    (a, b, c), (x, y, z), (u, v, w), (d, e, f) = one.direction, one.origin, other.origin, other.direction
    start = (u - x) * a + (v - y) * b + (w - z) * c
    end = start + other.length * (d * a + e * b + f * c)
    if min(max(start, end), one.length) - max(min(start, end), 0.0) <= _TOUCH:
        return False
    return one.radius > other.bore and other.radius > one.bore
