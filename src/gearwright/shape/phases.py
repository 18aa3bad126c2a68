"""How every gear is turned so that teeth stand in gaps, and which way every shaft turns in space.

Two gears mesh where z_1 (φ_1 − θ_1) − s z_2 (φ_2 − θ_2) is an odd number of half turns: φ says where a tooth of each
stands, θ where they touch and s which way teeth go there (`contacts`); a helix adds what it turns by along the axis
from one gear's middle to the other's. A gear on a shaft is turned freely against its neighbours there, planets of equal
sets alike: the steps of all stepped planets stand to each other as those of the first.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.identity import Role
from gearwright.shape.contacts import Contact
from gearwright.shape.stands import Stand
from gearwright.sizing import Sizing

CLOSES = 1e-6
"""Of a pitch by which a mesh may miss the middle of its gap and is still met [-]."""


class Phases(NamedTuple):
    """How all gears stand."""

    turned: Mapping[str, float]
    """Gear -> angle of the middle of one of its teeth [rad]."""
    missed: Mapping[str, float]
    """Mesh, as its two gears -> how far its teeth stand beside the middle of their gaps, in pitches [-]; those that
    are met left out."""
    senses: Mapping[str, float]
    """Shaft or planets' node -> +1 where it turns about its own axis as the speeds of the train count, −1 where
    against it [-]."""
    against: tuple[str, ...]
    """Meshes whose shafts cannot turn in space as the train's speeds say."""


def helix_rate(stand: Stand, hand: float) -> float:
    """Return by how much the teeth of a cylindrical gear turn along its axis [rad/m].

    Args:
        stand: The gear.
        hand: +1 right, −1 left.
    """
    return hand * math.tan(stand.gear.helix_angle) / (stand.gear.pitch_diameter / 2.0)


def phases_of(
    sizing: Sizing, stands: Sequence[Stand], contacts: Sequence[Contact], hands: Mapping[str, float]
) -> Phases:
    """Return how every gear stands.

    Args:
        sizing: As sized.
        stands: Its gears.
        contacts: Their meshes.
        hands: Gear -> +1 for a right-hand helix, −1 for a left-hand one, 0 for straight or double-helical teeth.
    """
    turned: dict[str, float] = {}
    steps: dict[tuple[str, str], float] = {}
    for start in _ordered(stands):
        if start.name not in turned:
            turned[start.name] = 0.0
            _spread(contacts, stands, turned, steps, hands)
    missed = {}
    for contact in contacts:
        off = residual(contact, turned, hands)
        if abs(off) > CLOSES:
            missed[f"{contact.first.name} and {contact.second.name}"] = off
    senses, against = _senses(sizing, contacts)
    return Phases(turned, missed, senses, against)


def residual(contact: Contact, turned: Mapping[str, float], hands: Mapping[str, float]) -> float:
    """Return how far a mesh is from teeth in the middle of gaps, in pitches, within ±½.

    Args:
        contact: The mesh.
        turned: Gear -> where its teeth stand [rad].
        hands: Of their helices.
    """
    one, other = contact.first, contact.second
    lean = helix_rate(other, hands[other.name]) * contact.offset
    first = one.gear.teeth * (turned[one.name] - contact.angles[0])
    second = other.gear.teeth * (turned[other.name] - lean - contact.angles[1])
    off = (first - contact.sense * second) / (2.0 * math.pi) - 0.5
    return off - round(off)


def _ordered(stands: Sequence[Stand]) -> Iterator[Stand]:
    """Yield the gears in the order in which their turns are free: suns and pinions first."""
    order = (Role.SUN, Role.PINION, Role.WHEEL, Role.PLANET, Role.RING)
    yield from sorted(stands, key=lambda stand: (order.index(stand.gear.role), stand.place))


def _spread(
    contacts: Sequence[Contact],
    stands: Sequence[Stand],
    turned: dict[str, float],
    steps: dict[tuple[str, str], float],
    hands: Mapping[str, float],
) -> None:
    """Turn every gear that meshes with a turned one, or is one piece with it, until none is left."""
    moved = True
    while moved:
        moved = False
        for contact in sorted(contacts, key=lambda contact: max(contact.first.place, contact.second.place)):
            known = [stand.name in turned for stand in (contact.first, contact.second)]
            if sum(known) != 1:
                continue
            new = contact.second if known[0] else contact.first
            turned[new.name] = 0.0
            turned[new.name] = _closing(contact, new, turned, hands)
            if new.carrier:
                _one_piece(new, contacts, stands, turned=turned, steps=steps, hands=hands)
            moved = True
            break


def _closing(contact: Contact, new: Stand, turned: Mapping[str, float], hands: Mapping[str, float]) -> float:
    """Return the angle at which a gear that stands at 0 meshes."""
    off = residual(contact, turned, hands) * 2.0 * math.pi / new.gear.teeth
    return -off if new is contact.first else contact.sense * off


def _one_piece(
    new: Stand, contacts: Sequence[Contact], stands: Sequence[Stand],
    *, turned: dict[str, float], steps: dict[tuple[str, str], float], hands: Mapping[str, float],
) -> None:  # fmt: skip
    """Turn the other steps of a planet as the first planet has them, by the whole teeth that let all of them mesh."""
    others = [stand for stand in stands if stand.node == new.node and stand.place == new.place and stand is not new]
    others = [stand for stand in others if (new.gear.name, stand.gear.name) in steps or new.place == 0]
    if not others:
        return
    for other in others:
        if new.place == 0 and (new.gear.name, other.gear.name) not in steps:
            meshes = [c for c in contacts if other in (c.first, c.second)
                      and (c.second if c.first is other else c.first).name in turned]  # fmt: skip
            turned[other.name] = 0.0
            if meshes:
                turned[other.name] = _closing(meshes[0], other, turned, hands)
            steps[new.gear.name, other.gear.name] = turned[other.name] - turned[new.name]
            steps[other.gear.name, new.gear.name] = turned[new.name] - turned[other.name]
    base, best = turned[new.name], (math.inf, 0.0)
    for k in range(new.gear.teeth):
        trial = base + 2.0 * math.pi * k / new.gear.teeth
        placed = {**turned, new.name: trial}
        placed |= {other.name: trial + steps[new.gear.name, other.gear.name] for other in others}
        ends = {new.name, *(other.name for other in others)}
        offs = [abs(residual(c, placed, hands)) for c in contacts
                if {c.first.name, c.second.name} & ends and {c.first.name, c.second.name} <= placed.keys()]  # fmt: skip
        best = min(best, (round(max(offs, default=0.0), 9), trial))
    turned[new.name] = best[1]
    turned |= {other.name: best[1] + steps[new.gear.name, other.gear.name] for other in others}


def _senses(sizing: Sizing, contacts: Sequence[Contact]) -> tuple[dict[str, float], tuple[str, ...]]:
    """Return which way shafts turn in space; what is in line turns as the train counts."""
    ties: list[tuple[str, str, float, str]] = []
    for contact in contacts:
        if contact.mesh.stage in sizing.design.pairs:
            ends = contact.mesh.nodes[:2]
            ties.append((ends[0], ends[1], contact.sense * contact.mesh.sign, contact.mesh.name))
    for stage in sizing.design.sets.values():
        ties += [(stage.members[0], shaft, 1.0, "") for shaft in stage.members[1:]]
    ties += [(link.driving, link.driven, 1.0, "") for link in sizing.train.links]
    senses: dict[str, float] = {"ground": 1.0}
    ties = [tie for tie in ties if "ground" not in tie[:2]] + _past_ground(sizing)
    for start in sizing.design.shafts:
        if start in senses:
            continue
        senses[start] = 1.0
        moved = True
        while moved:
            moved = False
            for first, second, sign, _ in ties:
                for here, there in ((first, second), (second, first)):
                    if here in senses and there not in senses:
                        senses[there] = senses[here] * sign
                        moved = True
    for gear in sizing.train.gears:
        if gear.role is Role.PLANET:
            members = [shaft for shaft in sizing.design.sets[gear.stage].members if shaft != "ground"]
            senses[gear.nodes[0]] = senses[members[0]]
    against = tuple(dict.fromkeys(name for first, second, sign, name in ties
                                  if senses[first] * sign != senses[second] and np.isfinite(sign)))  # fmt: skip
    return senses, against


def _past_ground(sizing: Sizing) -> list[tuple[str, str, float, str]]:
    """Return what joins the turning members of sets of which one stands still."""
    found = []
    for stage in sizing.design.sets.values():
        moving = [shaft for shaft in stage.members if shaft != "ground"]
        found += [(moving[0], shaft, 1.0, "") for shaft in moving[1:]]
    return found
