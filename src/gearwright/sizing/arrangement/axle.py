"""What stands on every axis that several shafts share, and which of it may stand where.

A machine, the gears of pairs on one shaft, and a brake reach out from their shaft, so that it must be the outermost
where they stand. A clutch or damper joins two shafts, between which no other may lie. A planetary set has its suns'
shafts innermost, that of its carrier around them, and those of its rings outside; of two suns on one side the one whose
plane is farther away goes through the other, of two rings it goes around the other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Literal, NamedTuple

from gearwright.identity import Role, carrier_part
from gearwright.parts.planetary import planes
from gearwright.sizing.rating import Context
from gearwright.spec import GROUND
from gearwright.spec.design import NOTHING_GIVEN

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
