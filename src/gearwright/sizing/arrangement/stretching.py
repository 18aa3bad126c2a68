"""How far apart everything on an axis stands where shafts lie in each other or go through planetary sets.

Every token stands as near to the first end as it may: beside its neighbour with a gap, and, on every shaft, as far from
the one before as the shaft's own length divides among what is on it. What goes through a hollow shaft is as long as
that, and has that stretch of its own beyond it; what goes through a planetary set, as long as the set is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from gearwright.sizing.arranged import ShaftPlan
from gearwright.sizing.arrangement.axle import CARRIER, Axle, Token
from gearwright.sizing.arrangement.ordering import Way
from gearwright.sizing.arrangement.sets import PLATE_GAP, set_length, slots
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.spec.design import NOTHING_GIVEN

Edge = tuple[int, int, float]
"""Two tokens, the first nearer to the first end, and how far apart their middles stand at least [m]."""


def stretched(
    context: Context, axle: Axle, way: Way, plans: Mapping[str, ShaftPlan], gears: tuple[GearSizing, ...]
) -> dict[str, tuple[float, dict[str, float]]]:
    """Return shaft -> its length and the places on it [m], for those whose length and places are open.

    Args:
        context: What sizing reads.
        axle: What stands on the axis.
        way: In which order.
        plans: Of every shaft by itself.
        gears: From `size_gears`.
    """
    by_name = {gear.name: gear for gear in gears}
    order = [axle.tokens[k] for k in way.order]
    order = [token for token in order if any(shaft in plans for shaft in token.shafts)]
    halves = [_half(context, token, plans, by_name) for token in order]
    own = {shaft: [k for k, token in enumerate(order) if shaft in token.shafts] for shaft in plans}
    own = {shaft: places for shaft, places in own.items() if places}
    edges = [*_neighbours(context, order, halves, by_name), *_along(context, order, halves, own, way, plans=plans)]
    middles = [0.0] * len(order)
    for k in range(len(order)):
        middles[k] = max((middles[first] + far for first, second, far in edges if second == k), default=0.0)
    found = {}
    for shaft, places in own.items():
        if len(places) > 1 and _is_open(context, shaft):
            found[shaft] = _plan(context, shaft, order, places, way, halves, middles, plans[shaft], by_name)
    return found


def _is_open(context: Context, shaft: str) -> bool:
    layout = context.design.layout.get(shaft, NOTHING_GIVEN)
    return not layout.places and f"{shaft}.length" not in context.given and layout.second_bearing is None


def _half(context: Context, token: Token, plans: Mapping[str, ShaftPlan], gears: Mapping[str, GearSizing]) -> float:
    """Return half of what a token takes along the axis [m]."""
    if token.kind == "set":
        return set_length(context, gears, token.name) / 2.0
    return plans[token.shafts[0]].length / 2.0 if _is_block(token) else 0.0


def _is_block(token: Token) -> bool:
    """Tell whether a token is the gears of pairs on a shaft."""
    return token.kind == "gears"


def _plate(context: Context, token: Token, gears: Mapping[str, GearSizing]) -> float:
    """Return the room that the plate of a set's carrier takes beside its gears [m]."""
    if token.kind != "set":
        return 0.0
    return 2.0 * PLATE_GAP + context.design.carriers.plate_ratio * set_length(context, gears, token.name)


def _neighbours(
    context: Context, order: list[Token], halves: list[float], gears: Mapping[str, GearSizing]
) -> Iterator[Edge]:
    """Yield the gaps between neighbours, with the plates of carriers between them."""
    gap = context.design.shafting.bearing_length
    for k, (one, other) in enumerate(pairwise(order)):
        joined = not set(one.shafts).isdisjoint(other.shafts) and (_is_block(one) or _is_block(other))
        room = 0.0 if joined else max(gap, _plate(context, one, gears), _plate(context, other, gears))
        yield k, k + 1, halves[k] + halves[k + 1] + room


def _along(
    context: Context, order: list[Token], halves: list[float], own: Mapping[str, list[int]], way: Way,
    *, plans: Mapping[str, ShaftPlan],
) -> Iterator[Edge]:  # fmt: skip
    """Yield the stretches of every shaft between what is on it, and those beyond what it goes through."""
    for shaft, places in own.items():
        block = any(_is_block(order[k]) for k in places)
        share = 0.0 if block else plans[shaft].length / max(len(places) - 1, 1)
        around = [own[outer] for inner, outer in way.within if inner == shaft and outer in own]
        for first, second in pairwise(places):
            yield first, second, halves[first] + halves[second] + share
            for outer in around:
                if first < outer[-1] < second:
                    yield outer[-1], second, halves[outer[-1]] + halves[second] + share
                if first < outer[0] < second:
                    yield first, outer[0], halves[first] + halves[outer[0]] + share


def _plan(
    context: Context, shaft: str, order: list[Token], places: list[int], way: Way,
    halves: list[float], middles: list[float], plan: ShaftPlan, gears: Mapping[str, GearSizing],
) -> tuple[float, dict[str, float]]:  # fmt: skip
    """Return the length of a shaft and where everything on it stands [m]."""
    first, last = places[0], places[-1]
    start = middles[first] + (halves[first] if order[first].kind == "set" else -halves[first])
    end = middles[last] - (halves[last] if order[last].kind == "set" else -halves[last])
    at: dict[str, float] = {}
    for k in places:
        token = order[k]
        lies = slots(context, gears, token.name, turned=token.name in way.turned) if token.kind == "set" else {}
        for label in (label for host, label in token.labels if host == shaft):
            if token.kind == "set" and k in (first, last):
                at[label] = 0.0 if k == first else end - start
            elif _is_block(token):
                at[label] = middles[k] - halves[k] + plan.places[label] - start
            else:
                at[label] = middles[k] + lies.get(label, 0.0) - start
    return end - start, at


def spans_a_set(axle: Axle, way: Way) -> bool:
    """Tell whether a shaft goes through another one, or on both sides of a planetary set.

    Args:
        axle: What stands on the axis.
        way: In which order.
    """
    if any(inner in axle.shafts and outer in axle.shafts for inner, outer in way.within):
        return True
    before: tuple[str, ...] = ()
    for k, behind in zip(way.order, way.layers, strict=True):
        token = axle.tokens[k]
        if token.kind == "set" and any(m.shaft in before and m.shaft in behind for m in token.members):
            return True
        before = behind
    return False


def both_sides(axle: Axle, way: Way) -> tuple[str, ...]:
    """Return the planetary sets whose carrier's shaft leaves them on both sides.

    Args:
        axle: What stands on the axis.
        way: In which order.
    """
    found, before = list[str](), tuple[str, ...]()
    for k, behind in zip(way.order, way.layers, strict=True):
        arms = [member.shaft for member in axle.tokens[k].members if member.layer == CARRIER]
        found += [axle.tokens[k].name for arm in arms if arm in before and arm in behind]
        before = behind
    return tuple(found)
