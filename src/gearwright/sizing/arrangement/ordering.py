"""In which order everything stands on an axis, and which shaft goes through which, by a search over all orders.

Tokens are put down from the first end on. Between two of them, the shafts that reach over lie in each other, from the
axis outwards; a shaft keeps its layer as long as it lasts. An order is kept only if every token has what it needs:
what reaches out stands on the outermost shaft, nothing lies between what a clutch joins, and the shafts of a planetary
set leave it in the order of its members. Of all that hold, the one is taken that leads the fewest shafts through
machines, then the fewest around clutches and carriers to both sides; then the one with the fewest stretches of shaft
side by side or in each other, which is the shortest; then the one that changes least of the usual order.

The search is exact: the best way to go on depends only on what has been put down and on the shafts that reach over, and
is found once for each (dynamic programming).
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, lru_cache
from typing import NamedTuple

from gearwright.sizing.arrangement.axle import CARRIER, RING, SUN, Axle, Member, Token

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
