"""Order and spacing of gears, bearings and concentric shafts along a common axis."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache, lru_cache
from itertools import combinations, pairwise
from typing import Literal, NamedTuple

from gearwright.base import Role, carrier_part
from gearwright.parts.planetary import planes
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing, ShaftPlan
from gearwright.spec import GROUND
from gearwright.spec.design import NOTHING_GIVEN

# ----------------------------------------------------------------------------------------------------------------------
# What stands on every axis that several shafts share, and which of it may stand where.
#
# A machine, the gears of pairs on one shaft, and a brake reach out from their shaft, so that it must be the outermost
# where they stand. A clutch or damper joins two shafts, between which no other may lie. A planetary set has its suns'
# shafts innermost, that of its carrier around them, and those of its rings outside; of two suns on one side the one
# whose plane is farther away goes through the other, of two rings it goes around the other.
# ----------------------------------------------------------------------------------------------------------------------


SUN, CARRIER, RING = range(3)
"""Layers of a set, from its axis outwards."""
Kind = Literal["machine", "reaching", "gears", "link", "set"]


class Member(NamedTuple):
    """A shaft of a planetary set."""

    shaft: str
    """Of what the ground holds a name of its own."""
    label: str
    """Of its gear or carrier."""
    layer: int
    held: bool
    """True of what the ground holds."""
    plane: int
    """Of its gear along the axis, from the first end of the set."""


class Token(NamedTuple):
    """What has one place on an axis."""

    name: str
    kind: Kind
    labels: tuple[tuple[str, str], ...]
    """Shaft, and what stands here on it."""
    members: tuple[Member, ...] = ()
    """Of a set."""
    held: tuple[int, ...] = ()
    """Planes of rings that the ground holds."""

    @property
    def shafts(self) -> tuple[str, ...]:
        """That it has to do with, each once."""
        return tuple(dict.fromkeys(shaft for shaft, _ in self.labels))


class Axle(NamedTuple):
    """Everything on one axis."""

    shafts: tuple[str, ...]
    """Of the design."""
    tokens: tuple[Token, ...]
    """In the order of the design."""
    usual: tuple[tuple[int, int], ...]
    """Two tokens of one shaft, the one that usually stands first before the other."""
    wished: tuple[tuple[int, int], ...]
    """Two tokens of which the design puts the first before the second."""


def axles_of(context: Context, axis: Mapping[str, str], listed: Mapping[str, tuple[str, ...]]) -> tuple[Axle, ...]:
    """Return the axes that several shafts share and whose bearings the design leaves open.

    Args:
        context: What sizing reads.
        axis: Shaft -> the first shaft on its axis.
        listed: Shaft -> what stands on it, in the usual order.
    """
    design, groups = context.design, dict[str, list[str]]()
    for shaft, first in axis.items():
        groups.setdefault(first, []).append(shaft)
    seated = {seat.shaft for seat in design.bearings.values()}
    return tuple(
        _axle(context, shafts, listed) for shafts in groups.values() if len(shafts) > 1 and seated.isdisjoint(shafts)
    )


def _axle(context: Context, shafts: list[str], listed: Mapping[str, tuple[str, ...]]) -> Axle:
    design, tokens, number = context.design, list[Token](), dict[tuple[str, str], int]()
    stages = {gear.name: gear.stage for gear in context.train.gears}
    stages |= {str(carrier_part(stage)): stage for stage in design.sets}
    known = {token.name: token for token in _tokens(context, shafts, listed, stages)}
    for shaft in shafts:
        for label in listed[shaft]:
            name = stages.get(label, label)
            name = f"gears of {shaft}" if name in design.pairs else name
            if known[name] not in tokens:
                tokens.append(known[name])
            number[shaft, label] = tokens.index(known[name])
    tokens += [token for token in known.values() if token not in tokens]
    usual, wished = list[tuple[int, int]](), list[tuple[int, int]]()
    for shaft in shafts:
        layout, labels = design.layout.get(shaft, NOTHING_GIVEN), listed[shaft]
        usual += _pairs(number, shaft, labels)
        wished += _pairs(number, shaft, tuple(label for label in layout.order if label in labels))
        placed = sorted((label for label in layout.places if label in labels), key=lambda k: layout.places[k].position)
        wished += _pairs(number, shaft, tuple(placed))
    return Axle(tuple(shafts), tuple(tokens), tuple(dict.fromkeys(usual)), tuple(dict.fromkeys(wished)))


def _pairs(number: Mapping[tuple[str, str], int], shaft: str, labels: tuple[str, ...]) -> list[tuple[int, int]]:
    places = dict.fromkeys(number[shaft, label] for label in labels)
    return list(combinations(places, 2))


def _tokens(
    context: Context, shafts: list[str], listed: Mapping[str, tuple[str, ...]], stages: Mapping[str, str]
) -> Iterator[Token]:
    design, own = context.design, set(shafts)
    for name, machine in design.machines.items():
        if machine.shaft in own:
            kind: Kind = "reaching" if name in design.airscrews else "machine"
            yield Token(name, kind, ((machine.shaft, name),))
    for link in context.train.links:
        ends = tuple((shaft, link.name) for shaft in (link.driving, link.driven) if shaft in own)
        if ends:
            yield Token(link.name, "link" if len(ends) == 2 else "reaching", ends)
    for stage in design.sets:
        if own & set(design.sets[stage].members):
            yield from _set(context, stage)
    for shaft in shafts:
        gears = tuple((shaft, label) for label in listed[shaft] if stages.get(label) in design.pairs)
        if gears:
            yield Token(f"gears of {shaft}", "gears", gears)


def _set(context: Context, stage: str) -> Iterator[Token]:
    """Yield a planetary set, and what holds its standing sun or carrier."""
    members, held = list[Member](), list[int]()
    compound, arm = context.design.epicyclics.get(stage), str(carrier_part(stage))
    lies = {} if compound is None else planes(compound.compound)
    keys = sorted({key for name in lies for key in lies[name]})
    for gear in context.train.gears:
        if gear.stage != stage or gear.role is Role.PLANET:
            continue
        plane = keys.index(min(lies[gear.own])) if lies else 0
        ring, shaft = gear.name in context.train.internal, gear.nodes[0]
        if ring and shaft == GROUND:
            held.append(plane)
        else:
            name = shaft if shaft != GROUND else f"{gear.name} on the ground"
            members.append(Member(name, gear.name, RING if ring else SUN, shaft == GROUND, plane))
    shaft = context.design.sets[stage].carrier
    members.append(Member(shaft if shaft != GROUND else f"{arm} on the ground", arm, CARRIER, shaft == GROUND, 0))
    labels = tuple((member.shaft, member.label) for member in members)
    yield Token(stage, "set", labels, tuple(members), tuple(held))
    for member in members:
        if member.held:
            yield Token(f"{member.label} to the ground", "reaching", ((member.shaft, member.label),))


# ----------------------------------------------------------------------------------------------------------------------
# In which order everything stands on an axis, and which shaft goes through which, by a search over all orders.
#
# Tokens are put down from the first end on. Between two of them, the shafts that reach over lie in each other, from
# the axis outwards; a shaft keeps its layer as long as it lasts. An order is kept only if every token has what it
# needs: what reaches out stands on the outermost shaft, nothing lies between what a clutch joins, and the shafts of a
# planetary set leave it in the order of its members. Of all that hold, the one is taken that leads the fewest shafts
# through machines, then the fewest around clutches and carriers to both sides; then the one with the fewest stretches
# of shaft side by side or in each other, which is the shortest; then the one that changes least of the usual order.
#
# The search is exact: the best way to go on depends only on what has been put down and on the shafts that reach over,
# and is found once for each (dynamic programming).
# ----------------------------------------------------------------------------------------------------------------------


Layers = tuple[str, ...]
"""Shafts that lie in each other, from the axis outwards."""
Cost = tuple[int, int, int, int, int]
"""Shafts through machines, around clutches and carriers to both sides; stretches; changes; sets turned about [-]."""
_NOTHING: Cost = (0, 0, 0, 0, 0)


class Way(NamedTuple):
    """An order of everything on an axis."""

    order: tuple[int, ...]
    """Numbers of the tokens."""
    layers: tuple[Layers, ...]
    """What reaches over behind each of them."""
    within: tuple[tuple[str, str], ...]
    """Inner and outer shaft, where one goes through the other."""
    turned: tuple[str, ...]
    """Planetary sets whose planes lie the other way round."""


class _Step(NamedTuple):
    """One way to put a token down."""

    layers: Layers
    through: int
    around: int
    within: tuple[tuple[str, str], ...]
    turned: bool = False


@lru_cache(maxsize=256)
def best_way(axle: Axle) -> Way | None:
    """Return the best order of everything on an axis; None where there is none.

    Args:
        axle: What stands on it.
    """
    tokens = axle.tokens
    first = _masks(len(tokens), axle.wished)
    usual = _masks(len(tokens), axle.usual)
    last = {shaft: sum(1 << k for k, token in enumerate(tokens) if shaft in token.shafts) for shaft in _shafts(axle)}
    everything = (1 << len(tokens)) - 1

    @cache
    def rest(done: int, layers: Layers) -> tuple[Cost, tuple[int, ...], tuple[_Step, ...]] | None:
        if done == everything:
            return _NOTHING, (), ()
        best = None
        for k, token in enumerate(tokens):
            if done >> k & 1 or first[k] & ~done:
                continue
            left = everything & ~(done | 1 << k)
            lasting = frozenset(shaft for shaft in token.shafts if last[shaft] & left)
            changes = (usual[k] & ~done).bit_count()
            for step in steps(token, layers, lasting):
                onward = rest(done | 1 << k, step.layers)
                if onward is None:
                    continue
                own = (step.through, step.around, len(step.layers), changes, int(step.turned))
                cost = _sum(own, onward[0])
                found = (cost, (k, *onward[1]), (step, *onward[2]))
                if best is None or found[:2] < best[:2]:
                    best = found
        return best

    found = rest(0, ())
    if found is None:
        return None
    _, order, taken = found
    within = {pair for step in taken for pair in step.within}
    turned = tuple(tokens[k].name for k, step in zip(order, taken, strict=True) if step.turned)
    return Way(order, tuple(step.layers for step in taken), tuple(sorted(within)), turned)


def _sum(one: Cost, other: Cost) -> Cost:
    a, b, c, d, e = one
    p, q, r, s, t = other
    return a + p, b + q, c + r, d + s, e + t


def _shafts(axle: Axle) -> tuple[str, ...]:
    return tuple(dict.fromkeys(shaft for token in axle.tokens for shaft in token.shafts))


def _masks(count: int, pairs: tuple[tuple[int, int], ...]) -> list[int]:
    """Return for every token the bits of those that stand before it."""
    masks = [0] * count
    for before, after in pairs:
        masks[after] |= 1 << before
    return masks


def steps(token: Token, layers: Layers, lasting: frozenset[str]) -> Iterator[_Step]:
    """Yield every way to put a token down behind shafts that lie in each other.

    Args:
        token: What is put down.
        layers: Shafts that reach over before it, from the axis outwards.
        lasting: Its shafts that reach on behind it.
    """
    passing = tuple(shaft for shaft in layers if shaft not in token.shafts)
    if token.kind == "set":
        yield from _at_set(token, layers, passing, lasting)
    elif token.kind == "link":
        yield from _at_link(token, layers, passing, lasting)
    elif token.shafts[0] not in layers or layers[-1] == token.shafts[0]:
        own = tuple(shaft for shaft in token.shafts if shaft in lasting)
        through = len(passing) if token.kind == "machine" else 0
        within = tuple((shaft, token.shafts[0]) for shaft in passing)
        yield _Step((*passing, *own), through, 0, within)


def _at_link(token: Token, layers: Layers, passing: Layers, lasting: frozenset[str]) -> Iterator[_Step]:
    """Yield the ways of a clutch: its shafts in line or in each other, with nothing between them."""
    came = [k for k, shaft in enumerate(layers) if shaft in token.shafts]
    if len(came) == 2 and came[1] - came[0] > 1:
        return
    both = tuple(layers[k] for k in came) if len(came) == 2 else token.shafts
    ways = {tuple(shaft for shaft in order if shaft in lasting) for order in (both, both[::-1])}
    if len(came) == 2 and len(lasting) == 2:
        ways = {both}
    places = [came[0]] if came else range(len(passing) + 1)
    for place in places:
        for own in sorted(ways):
            new = (*passing[:place], *own, *passing[place:])
            within = [(inner, shaft) for inner in passing[:place] for shaft in token.shafts]
            within += [(shaft, outer) for outer in passing[place:] for shaft in token.shafts]
            yield _Step(new, 0, len(passing) - place, (*within, *_nested(new)))


def _nested(layers: Layers) -> tuple[tuple[str, str], ...]:
    return tuple((inner, outer) for k, outer in enumerate(layers) for inner in layers[:k])


def _at_set(token: Token, layers: Layers, passing: Layers, lasting: frozenset[str]) -> Iterator[_Step]:
    """Yield the ways of a planetary set: what passes goes through its suns, its own shafts leave it by their layers."""
    came = layers[len(passing) :]
    if layers[: len(passing)] != passing or len(token.shafts) != len(token.members):
        return
    for turned in (False, True) if max(member.plane for member in token.members) or any(token.held) else (False,):
        sign = -1 if turned else 1
        members = [member._replace(plane=sign * member.plane) for member in token.members]
        held = [sign * plane for plane in token.held]
        before = sorted((member for member in members if member.shaft in came), key=lambda member: _depth(member, -1))
        behind = sorted((member for member in members if member.shaft in lasting), key=lambda member: _depth(member, 1))
        if tuple(member.shaft for member in before) != came:
            continue
        if not (_free(before, behind, held, -1) and _free(behind, before, held, 1)):
            continue
        around = sum(member.layer == CARRIER for member in before if member in behind)
        within = [(shaft, member.shaft) for shaft in passing for member in members if member.layer == SUN]
        for side, leaving in ((-1, before), (1, behind)):
            within += [
                (member.shaft, other.shaft)
                for member in leaving if member.layer == SUN
                for other in members if other.layer == SUN and side * (other.plane - member.plane) > 0
            ]  # fmt: skip
        new = (*passing, *(member.shaft for member in behind))
        if not any((outer, inner) in within for inner, outer in within):
            yield _Step(new, 0, around, (*within, *_nested(new)), turned)


def _depth(member: Member, side: int) -> tuple[int, int]:
    """Return what orders the shafts that leave a set on one side (-1: the first), from the axis outwards."""
    return member.layer, side * member.plane * (-1 if member.layer == RING else 1)


def _free(leaving: list[Member], others: list[Member], held: list[int], side: int) -> bool:
    """Tell whether no ring that leaves a set on one side runs into a standing one, or into one that goes the other way.

    A ring goes around those whose planes are nearer to that side: a standing one bars its way, and so does one that
    leaves on the other side, as that would have to go around this one.
    """
    rings = [member for member in leaving if member.layer == RING]
    barring = [*held, *(member.plane for member in others if member.layer == RING)]
    return not any(side * (plane - ring.plane) > 0 for ring in rings for plane in barring)


# ----------------------------------------------------------------------------------------------------------------------
# How long a planetary set is, and where in it the planes of its gears lie.
# ----------------------------------------------------------------------------------------------------------------------


PLATE_GAP = 0.005
"""Between planets and the plate of their carrier, an assumption [m]."""


def set_length(context: Context, gears: Mapping[str, GearSizing], stage: str) -> float:
    """Return how long the gears of a set are, plane by plane [m].

    Args:
        context: What sizing reads.
        gears: By name.
        stage: Name of the set.
    """
    return sum(_widths(context, gears, stage).values())


def slots(context: Context, gears: Mapping[str, GearSizing], stage: str, *, turned: bool) -> dict[str, float]:
    """Return gear -> where the middle of its width lies, from the set's middle on [m].

    Args:
        context: What sizing reads.
        gears: By name.
        stage: Name of the set.
        turned: True where its planes lie the other way round.
    """
    lies = _planes(context, stage)
    if stage in context.design.planetaries:  # one plane, in the middle
        return dict.fromkeys(lies, 0.0)
    widths = _widths(context, gears, stage)
    sense = -1.0 if turned else 1.0
    reached, middles = -sum(widths.values()) / 2.0, {}
    for key, width in widths.items():
        middles[key] = (reached, reached + width)
        reached += width
    found = {}
    for name, keys in lies.items():
        ends = [end for key in keys for end in middles[key]]
        found[name] = sense * (min(ends) + max(ends)) / 2.0
    return found


def _planes(context: Context, stage: str) -> dict[str, tuple[tuple[str, int], ...]]:
    """Return gear -> the planes that it lies in, in order."""
    gears = [gear for gear in context.train.gears if gear.stage == stage]
    if stage in context.design.planetaries:
        return {gear.name: (("", 0),) for gear in gears}
    lies = planes(context.design.epicyclics[stage].compound)
    return {gear.name: tuple(sorted(lies[gear.own])) for gear in gears}


def _widths(context: Context, gears: Mapping[str, GearSizing], stage: str) -> dict[tuple[str, int], float]:
    """Return plane -> its width, that of the widest gear which lies in it alone, in order along the axis [m]."""
    widths: dict[tuple[str, int], float] = {}
    for name, keys in sorted(_planes(context, stage).items(), key=lambda item: len(item[1])):
        for key in keys:
            share = gears[name].face_width / len(keys)
            widths[key] = max(widths.get(key, 0.0), share if gears[name].role is Role.PLANET or len(keys) == 1 else 0.0)
    return {key: widths[key] for key in sorted(widths)}


# ----------------------------------------------------------------------------------------------------------------------
# How far apart everything on an axis stands where shafts lie in each other or go through planetary sets.
#
# Every token stands as near to the first end as it may: beside its neighbour with a gap, and, on every shaft, as far
# from the one before as the shaft's own length divides among what is on it. What goes through a hollow shaft is as
# long as that, and has that stretch of its own beyond it; what goes through a planetary set, as long as the set is.
# ----------------------------------------------------------------------------------------------------------------------


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
