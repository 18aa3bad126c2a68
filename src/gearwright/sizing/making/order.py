"""Whether a gearbox can be put together: what is slid onto each shaft from which end, and which shaft goes in when.

Shafts are taken out in thought, each along its own axis with all that sits on it; what comes out last goes in first.
A part sweeps a cylinder as it leaves, which must be clear of all that is still inside. Cylindrical gears slide out of
their meshes; a bevel gear leaves its mate only away from the apex of its cone. A housing that opens along its axes
needs none of this: where shafts lock each other in, that is what is asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from gearwright.checks import Check, not_assessed
from gearwright.identity import GEARBOX, Kind, PartId, Role
from gearwright.sizing import BuiltShaft, Sizing
from gearwright.sizing.arranged import Body, Point, Station
from gearwright.sizing.making.running import mates_of
from gearwright.sizing.mounted import hub_bore_of
from gearwright.sizing.places import room_between

ENDS = {-1: "first", 1: "second"}
"""Way along a shaft -> the end that it leads to."""
_TOUCH = 1e-6
"""How far a part may pass another by rounding [m]."""
_CLAUSE = "bodies along their axes"
_STACK = "bores over steps"


class Slid(NamedTuple):
    """A part that is put onto a shaft."""

    name: str
    way: int
    """End that it comes from: −1 the first, +1 the second."""
    place: float
    """Middle, from the first end [m]."""
    bore: float
    """[m]"""
    past: float
    """Thickest diameter that it passes over [m]; 0 where it passes none."""
    rolls: bool
    """Whether it is a bearing."""


class Withdrawn(NamedTuple):
    """A shaft that leaves the gearbox."""

    shaft: str
    way: int
    """End that it leaves by, its own: −1 the first, +1 the second."""


def stack_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether what sits on every built shaft passes over what it is slid over, with the order of its parts.

    Args:
        sizing: As sized.
    """
    for shaft in sizing.built_shafts:
        slid = list(slid_parts(sizing, shaft))
        part, mode = PartId(Kind.SHAFT, shaft.name), "assembly of its parts"
        small = [f"{one.name} of {1e3 * one.bore:g} mm" for one in slid if one.bore < _seat(shaft, one) - _TOUCH]
        if small:
            why = f"the design gives its shaft thicker than {' and '.join(small)}: it needs seats of their bores"
            yield not_assessed(part, mode, _STACK, why)
            continue
        passing = [one for one in slid if one.past]
        if passing:
            tightest = min(passing, key=lambda one: round(one.bore / one.past, 9))
            why = "" if tightest.bore >= tightest.past - _TOUCH else "a larger bore, or thinner steps outside it"
            yield Check(
                part, mode, _STACK, tightest.bore, tightest.past, "length", exponent=None, place=_order(slid), why=why
            )


def _seat(shaft: BuiltShaft, slid: Slid) -> float:
    """Return the diameter of a shaft where a bearing of one of its own bores sits; of a spline its hub is cut [m]."""
    return next(step.diameter for step in shaft.steps if step.start <= slid.place <= step.end) if slid.rolls else 0.0


def slid_parts(sizing: Sizing, shaft: BuiltShaft) -> Iterator[Slid]:
    """Yield bearings, gears and machines that are put onto a shaft, from the end that is nearer past its thickest step.

    Args:
        sizing: As sized.
        shaft: One of its built shafts.
    """
    parts = [(bearing.name, bearing.position, bearing.inner_diameter, True)
             for bearing in sizing.bearings if bearing.shaft == shaft.name]  # fmt: skip
    parts += [(joint.part, joint.position, hub_bore_of(joint), False)
              for joint in sizing.joints if joint.shaft == shaft.name and joint.kind != "integral"]  # fmt: skip
    for name, place, bore, rolls in sorted(parts, key=lambda part: part[1]):
        ways = {-1: [step.diameter for step in shaft.steps if step.end < place],
                1: [step.diameter for step in shaft.steps if step.start > place]}  # fmt: skip
        way = min(ways, key=lambda side: max(ways[side], default=0.0))
        yield Slid(name, way, place, bore, max(ways[way], default=0.0), rolls)


def _order(slid: Sequence[Slid]) -> str:
    """Return what is put on from which end, in words."""
    words = []
    for way, end in ENDS.items():
        names = [part.name for part in sorted(slid, key=lambda part: way * part.place) if part.way == way]
        words += [f"from the {end} end {', '.join(names)}"] if names else []
    return "; ".join(words)


def order_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield in which order built shafts go into their housing from its ends, or which lock each other in.

    Args:
        sizing: As sized.
    """
    if len(sizing.built_shafts) < 2:
        return
    out, left = withdrawals(sizing)
    words = ", ".join(f"{step.shaft} by its {ENDS[step.way]} end" for step in reversed(out))
    if left:
        why = f"{' and '.join(left)} lock each other in along their axes: the housing must open beside them"
        yield not_assessed(GEARBOX, "assembly order", _CLAUSE, why)
        return
    count = float(len(sizing.built_shafts))
    yield Check(
        GEARBOX, "assembly order", _CLAUSE, float(len(out)), count, "number", exponent=None, place=f"in go {words}"
    )


def withdrawals(sizing: Sizing) -> tuple[tuple[Withdrawn, ...], tuple[str, ...]]:
    """Return in which order built shafts leave the gearbox along their axes, and those that cannot.

    A bearing leaves with its shaft, or before it by the end from which it is slid on.

    Args:
        sizing: As sized.
    """
    left, out = [shaft.name for shaft in sizing.built_shafts], list[Withdrawn]()
    while left:
        ways = (Withdrawn(shaft, way) for shaft in left for way in ENDS)
        free = next((step for step in ways if _leaves(sizing, step, left)), None)
        if free is None:
            break
        out.append(free)
        left.remove(free.shaft)
    return tuple(out), tuple(left)


def _leaves(sizing: Sizing, step: Withdrawn, left: Sequence[str]) -> bool:
    """Tell whether a shaft can be drawn out by one of its ends past the others that are left."""
    bodies = sizing.arrangement.bodies
    inside = [body for body in bodies if body.shaft in left and body.shaft != step.shaft]
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == step.shaft)
    off = {part.name: part.way for part in slid_parts(sizing, shaft) if part.rolls}
    return all(
        any(_passes(sizing, body, way, inside) for way in {step.way, off.get(str(body.part), step.way)})
        for body in bodies
        if body.shaft == step.shaft
    )


def _passes(sizing: Sizing, body: Body, way: int, inside: Sequence[Body]) -> bool:
    """Tell whether a body leaves along its axis past others."""
    mates, swept = mates_of(sizing), _swept(body, way, _far(inside))
    for other in inside:
        if frozenset((body.part, other.part)) in mates:
            if not _parts(sizing, body.part, way):
                return False
        elif room_between(swept, other, enough=0.0).gap < -_TOUCH:
            return False
    return True


def _parts(sizing: Sizing, part: PartId, way: int) -> bool:
    """Tell whether a gear leaves its mate by an end of its shaft."""
    pair = sizing.design.pairs[part.name]
    if pair.kind == "cylindrical":
        return True
    if pair.kind == "face":
        return part.role is Role.PINION
    apex = pair.pinion_apex if part.role is Role.PINION else pair.wheel_apex
    return way == (-1 if apex == "second" else 1)


def _far(bodies: Sequence[Body]) -> float:
    """Return a length beyond all bodies [m]."""
    return 10.0 * max((max(map(abs, body.origin)) + body.length + body.radius for body in bodies), default=0.1)


def _swept(body: Body, way: int, far: float) -> Body:
    """Return the cylinder that a body sweeps as it leaves along its axis."""
    start = body.origin if way > 0 else Point(
        *(at - far * along for at, along in zip(body.origin, body.direction, strict=True)))  # fmt: skip
    return replace(
        body, origin=start, stations=(Station(0.0, body.radius), Station(body.length + far, body.radius)), bore=0.0
    )
