"""Parallel paths of a train: which pairs lie on a loop that the power can pass two ways, and how often it has split."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from gearwright.identity import SIDES, Role
from gearwright.spec.design.design import GROUND, Design
from gearwright.spec.design.latest import of_the_latest


class _Link(NamedTuple):
    """Two shafts that turn at a fixed ratio, with the stage that joins them."""

    stage: str
    ends: tuple[str, str]


@of_the_latest
def split_levels(design: Design) -> Mapping[str, float]:
    """Return pair -> how often the power has split in two where it passes, of pairs on parallel paths [-].

    Two paths are one level, four are two. Paths of machines of their own, as of two engines on one wheel, close no
    loop: their machines decide what each of them carries.

    Args:
        design: As typed.
    """
    links = list(_links(design))
    rows = {name: [link for link in links if link.stage == name] for name in design.pairs}
    looped = {name for name, own in rows.items() if any(_closes(link, links) for link in own)}
    branches = {name: _branches(design, name) if len(rows[name]) > 1 else set() for name in looped}

    def levels(name: str, above: frozenset[str]) -> float:
        trunk = {end for link in rows[name] for end in link.ends} - branches[name]
        parents = (other for other in looped - above - {name} if trunk & branches[other])
        return math.log2(len(rows[name])) + max((levels(other, above | {name}) for other in parents), default=0.0)

    return {name: levels(name, frozenset()) for name in looped}


def _branches(design: Design, name: str) -> set[str]:
    """Return the shafts of the side of a pair that has several."""
    sides = (_shafts(design, name, side) for side in SIDES)
    return set().union(*(side for side in sides if len(side) > 1))


def _shafts(design: Design, name: str, side: Role) -> list[str]:
    """Return the shafts on one side of a pair, of a shared gear those of its owner."""
    pair = design.pairs[name]
    shared = pair.shared(side)
    if shared is None:
        return pair.named(side)
    owner = design.pairs.get(shared[0])
    return [] if owner is None or owner.shared(shared[1]) is not None else owner.named(shared[1])


def _links(design: Design) -> Iterator[_Link]:
    """Yield what joins two shafts at a fixed ratio: pairs, sets of which a member stands still, clutches."""
    for name in design.pairs:
        first, second = (_shafts(design, name, side) for side in SIDES)
        for one in first:
            for other in second:
                yield _Link(name, (one, other))
    for name, planetary in design.planetaries.items():
        moving = [shaft for shaft in planetary.members if shaft != GROUND]
        if len(moving) == 2:
            yield _Link(name, (moving[0], moving[1]))
    for name, clutch in design.clutches.items():
        if clutch.kind != "open" and GROUND not in (clutch.driving, clutch.driven):
            yield _Link(name, (clutch.driving, clutch.driven))


def _closes(link: _Link, links: list[_Link]) -> bool:
    """Tell whether the ends of a link are joined without it."""
    near = defaultdict[str, set[str]](set)
    for other in links:
        if other is not link:
            first, second = other.ends
            near[first].add(second)
            near[second].add(first)
    reached, waiting = {link.ends[0]}, [link.ends[0]]
    while waiting:
        new = near[waiting.pop()] - reached
        reached |= new
        waiting += new
    return link.ends[1] in reached
