"""A shaft that is taken as the design gives it: a cylinder on which nothing grows; what does not fit is a check.

It is laid as it is written, also where that cannot be made. Parts that stand into each other are cut at the middle of
what they share, so that every section belongs to one of them. The room that they lack is a check, as is every seat that
is not the bore of its bearing, every shaft that reaches the roots of its gear, every key that no standard has.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from gearwright.catalogue import Bearing, key_for_shaft
from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.sizing.mounted import JointSizing
from gearwright.sizing.shafts.joints import Seat, keyway_depth
from gearwright.sizing.shafts.stretches import LARGEST_BODY, Item, Stretch
from gearwright.spec.design import Joint

_SAME = 1e-9
"""Lengths that differ by less are the same [m]."""


def cylinder(items: Sequence[Item], length: float, diameter: float, seats: Mapping[str, float]) -> tuple[Stretch, ...]:
    """Return the stretches of a shaft of one diameter.

    Args:
        items: What sits on it, in order.
        length: Of the shaft [m].
        diameter: Of the shaft [m].
        seats: Hub -> its own diameter, where the user gives one [m].
    """
    shared = [(item.end + after.start) / 2.0 for item, after in pairwise(items)]
    stretches, reached, before = list[Stretch](), 0.0, ""
    for item, limit in zip(items, (*shared, length), strict=True):
        start = max(item.start, reached)
        end = max(min(item.end, limit), start)
        stretches += [Stretch(f"after {before}".strip(), "between", reached, start, diameter)]
        stretches += [Stretch(item.name, item.kind, start, end, _own(item, diameter, seats))]
        reached, before = end, item.name
    stretches.append(Stretch(f"after {before}".strip(), "between", reached, length, diameter))
    return tuple(stretch for stretch in stretches if stretch.length > _SAME)


def _own(item: Item, diameter: float, seats: Mapping[str, float]) -> float:
    """Return the diameter of a seat; a gear of one piece stiffens its shaft as far as its roots."""
    if item.kind == "integral":
        return max(diameter, min(item.limit, LARGEST_BODY * diameter))
    return seats.get(item.name, diameter)


def room_checks(shaft: str, items: Sequence[Item], length: float) -> Iterator[Check]:
    """Yield whether parts have room beside each other and between the ends of their shaft.

    Args:
        shaft: Its name.
        items: What sits on it, in order.
        length: Of the shaft [m].
    """
    ends = (Item("first end", "between", 0.0, 0.0), *items, Item("second end", "between", length, 0.0))
    part, clause = PartId(Kind.SHAFT, shaft), "half of both widths"
    for left, right in pairwise(ends):
        apart, needed = right.middle - left.middle, (left.width + right.width) / 2.0
        place = f"between {left.name} and {right.name}"
        yield Check(part, "room", clause, apart, needed, "length", exponent=None, place=place)


def seat_checks(seat: float, bearings: Mapping[str, Bearing]) -> Iterator[Check]:
    """Yield whether every bearing has the bore of its seat.

    Args:
        seat: Diameter of the shaft [m].
        bearings: On it, by name.
    """
    for name, bearing in bearings.items():
        part, thick = PartId(Kind.BEARING, name), seat > bearing.bore
        yield Check(
            part, "shaft in its bore", "ISO 15, d", seat, bearing.bore, "length",
            at_most=thick, exponent=None, place=bearing.designation,
        )  # fmt: skip


def joint_checks(joint: Joint, seat: Seat, sized: JointSizing) -> Iterator[Check]:
    """Yield whether a shaft stays inside the roots of its gear, and whether a key is one that can be had.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        sized: As it came out.
    """
    part, length = PartId(Kind.JOINT, sized.part, branch=sized.shaft), sized.length
    if seat.root < math.inf:
        mode = "shaft and keyway in the root circle" if joint.kind == "key" else "shaft in the root circle"
        reach = sized.diameter + 2.0 * keyway_depth(joint, sized.diameter)
        yield _within(part, mode, "ISO 21771, d_f", reach, seat.root)
    if joint.kind != "integral" and seat.hub_length < math.inf:
        yield _within(part, f"{joint.kind} in its hub", "length of the hub", length, seat.hub_length)
    if joint.kind == "key":
        key = key_for_shaft(sized.diameter)
        yield Check(part, "key length", "DIN 6885-1, shortest", length, key.shortest, "length", exponent=None)
        width, mode = key.section.width, "key length over its width"
        yield Check(part, mode, "DIN 6885-1, b", length, width, "length", exponent=None)


def _within(part: PartId, mode: str, clause: str, length: float, room: float) -> Check:
    return Check(part, mode, clause, length, room, "length", at_most=True, exponent=None)
