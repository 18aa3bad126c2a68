"""Which bodies share an axis, and shafts that run into each other there.

The order on an axis gives every body its room, where nothing that the design gives is in the way: a length, a place, a
bore. What it gives is held against each other all the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, combinations

from gearwright.checks import Check
from gearwright.identity import Kind, PartId, Role
from gearwright.sizing.arranged import Arrangement, Body
from gearwright.sizing.places.solids import Room, room_between
from gearwright.spec import GROUND

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
