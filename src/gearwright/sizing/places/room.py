"""Clearance checks: neighbouring bodies, keep-out volumes, orders on an axis, and planet pins."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import NamedTuple

import numpy as np

from gearwright.base import GEARBOX, Check, Kind, PartId, Role, smallest
from gearwright.sizing.arrangement import axles_in
from gearwright.sizing.axis_order import Axle, best_way
from gearwright.sizing.gear_geometry import cylindrical_gear, root_diameter
from gearwright.sizing.places.solids import (
    CLAUSE,
    Room,
    Solid,
    axes_among,
    box_of,
    of_one_set,
    owner,
    room_between,
    solid_of,
    solid_room,
    stand_into,
)
from gearwright.sizing.rating import BACKUP, TOOTH_HEIGHT, Context
from gearwright.sizing.result import Arrangement, Body, GearSizing
from gearwright.sizing.shaft_results import CarrierSizing, JointSizing
from gearwright.spec import GROUND, Design
from gearwright.spec.design import KeepOut

# ----------------------------------------------------------------------------------------------------------------------
# Whether bodies have room beside each other, as checks: distance of middles over what both bodies need.
#
# Bodies of two shafts are held against each other unless they mesh or belong to one planetary set; those that share an
# axis, where not both shafts are built, by `coaxial_checks`. On one shaft, where seats are kept apart as they are
# sized, the blank of a bevel or face gear is held against the bearings and the other gears: it reaches beyond its seat.
# ----------------------------------------------------------------------------------------------------------------------


BOSS = 1.4
"""Diameter of a bevel or face gear's hub over that of its bore, where its body is not sized [-]."""
_TOUCH = 1e-9
"""How far bodies may stand into each other by rounding [m]."""


class Meeting(NamedTuple):
    """Two bodies, and the room between them."""

    one: Body
    other: Body
    room: Room

    @property
    def names(self) -> str:
        """Parts of both."""
        return f"{self.one.part} and {self.other.part}"


Meetings = dict[tuple[PartId, PartId], Meeting]
"""Two shafts -> their two bodies with the least room between them."""


@dataclass(frozen=True)
class Rules:
    """Which bodies need no room beside each other."""

    sets: frozenset[str]
    """Planetary sets."""
    mates: frozenset[frozenset[PartId]]
    """Gears in mesh."""
    built: frozenset[str]
    """Shafts that are worked out along their axes."""
    hubs: Mapping[tuple[PartId, str], float]
    """Bevel or face gear with a hub of its own, and its shaft -> diameter of that hub [m]."""
    known: list[tuple[Sequence[Body], Meetings]] = field(default_factory=list, compare=False, repr=False)
    """Bodies that were held against each other last, and their meetings: axes and checks ask for the same."""


def rules_of(
    context: Context, gears: Mapping[str, GearSizing], built: Iterable[str], joints: Sequence[JointSizing]
) -> Rules:
    """Return which bodies need no room beside each other.

    Args:
        context: What sizing reads.
        gears: By name.
        built: Shafts with bearings.
        joints: Of those shafts.
    """
    design = context.design
    pairs = [mesh for mesh in context.train.meshes if mesh.stage in design.pairs]
    mates = [
        frozenset(gears[name].body(node) for name, node in zip(mesh.gears, mesh.nodes, strict=False)) for mesh in pairs
    ]
    blanks = {name for name, pair in design.pairs.items() if pair.kind in ("bevel", "face")}
    hubs = {
        (gears[joint.part].body(joint.shaft), joint.shaft): BOSS * joint.diameter
        for joint in joints
        if joint.kind != "integral" and joint.part in gears and gears[joint.part].stage in blanks
    }
    return Rules(frozenset(design.sets), frozenset(mates), frozenset(built), hubs)


def meetings(bodies: Sequence[Body], rules: Rules) -> Meetings:
    """Return two shafts -> their two bodies with the least room between them: the nearest, and all without room.

    Args:
        bodies: Of a transmission.
        rules: Which of them need no room.
    """
    if not rules.known or rules.known[0][0] is not bodies:
        rules.known[:] = [(bodies, _meetings(bodies, rules))]
    return rules.known[0][1]


def _meetings(bodies: Sequence[Body], rules: Rules) -> Meetings:
    found: Meetings = {}
    clear = math.inf
    every = zip(bodies, axes_among(bodies), map(_sphere, bodies), strict=True)
    for (one, first, around), (other, second, beside) in combinations(every, 2):
        if not _minds(one, other, rules, coaxial=first == second) or _apart(around, beside) > clear + _TOUCH:
            continue
        room, key = room_between(one, other, enough=0.0), _ordered(owner(one), owner(other))
        if key not in found or room.gap < found[key].room.gap - _TOUCH:  # of equal ones the first
            found[key] = Meeting(one, other, room)
        if room.gap >= -_TOUCH:
            clear = min(clear, max(room.gap, 0.0))
    return found


def any_into(bodies: Sequence[Body], rules: Rules, *, but: Collection[str]) -> bool:
    """Tell whether bodies stand into each other, beside those of some shafts two at a time.

    Args:
        bodies: Of a transmission.
        rules: Which of them need no room.
        but: Two shafts of `meetings`, as words, whose bodies do not count.
    """
    every = zip(bodies, axes_among(bodies), map(_sphere, bodies), strict=True)
    return any(
        _minds(one, other, rules, coaxial=first == second)
        and _apart(around, beside) <= 0.0
        and " ".join(map(str, _ordered(owner(one), owner(other)))) not in but
        and stand_into(one, other, _TOUCH)
        for (one, first, around), (other, second, beside) in combinations(every, 2)
    )


def room_checks(arrangement: Arrangement, rules: Rules) -> list[Check]:
    """Return all bodies that stand into each other, two shafts at a time, and the two nearest of those that do not.

    Args:
        arrangement: With its bodies.
        rules: Which of them need no room.
    """
    found = meetings(arrangement.bodies, rules)
    into = {key: meeting for key, meeting in found.items() if meeting.room.gap < -_TOUCH}
    clear = [meeting for key, meeting in found.items() if key not in into]
    checks = [_check(meeting, into=key) for key, meeting in into.items()]
    return [*checks, *(_check(meeting) for meeting in sorted(clear, key=lambda each: round(each.room.gap, 8))[:1])]


def beside_checks(context: Context, arrangement: Arrangement) -> Iterator[Check]:
    """Yield gears in mesh that do not stand beside each other along their axes.

    Args:
        context: What sizing reads.
        arrangement: With its frames.
    """
    for mesh in context.train.meshes:
        off = arrangement.apart.get(mesh.name)
        if off is not None:
            yield Check(
                mesh.part, "gears beside each other", "places along the shafts", abs(off), 5e-5, "length",
                at_most=True, exponent=None,
            )  # fmt: skip


def _check(meeting: Meeting, into: tuple[PartId, PartId] | None = None) -> Check:
    """Return a meeting as a check: of the gearbox, or, where bodies stand into each other, of the second's shaft."""
    room, part, mode, why = meeting.room, GEARBOX, "room between bodies", ""
    if into is not None:
        part, mode = into[1], "room on its shaft" if into[0] == into[1] else f"room beside {into[0]}"
        where = [f"{body.part} {body.what}" for body in (meeting.one, meeting.other) if body.what]
        why = f"{-1e3 * room.gap:.3g} mm into each other{''.join(f', {words}' for words in where)}"
    return Check(
        part, mode, CLAUSE, max(room.apart, 0.0), room.needed, "length",
        exponent=None, place=meeting.names, why=why,
    )  # fmt: skip


def _ordered(one: PartId, other: PartId) -> tuple[PartId, PartId]:
    return (one, other) if str(one) <= str(other) else (other, one)


def _minds(one: Body, other: Body, rules: Rules, *, coaxial: bool) -> bool:
    """Tell whether two bodies need room beside each other."""
    if one.shaft == other.shaft != GROUND:
        return _mind_on_one_shaft(one, other, rules)
    if coaxial and not (one.shaft in rules.built and other.shaft in rules.built):  # for `coaxial_checks`
        return False
    return not of_one_set(one, other, rules.sets) and frozenset((one.part, other.part)) not in rules.mates


def _mind_on_one_shaft(one: Body, other: Body, rules: Rules) -> bool:
    """Tell whether two bodies of one shaft need room: blanks of bevel and face gears beside bearings and gears."""
    for blank, mate in ((one, other), (other, one)):
        if blank.what != "blank" or mate.part == blank.part:
            continue
        if mate.part.kind is Kind.BEARING:
            hub = rules.hubs.get((blank.part, blank.shaft))
            return hub is None or 2.0 * mate.radius > hub
        return mate.part.kind is Kind.GEAR and mate.what != "teeth"
    return False


def _sphere(body: Body) -> tuple[list[float], float]:
    """Return middle and radius of the sphere around a body [m]."""
    half = body.length / 2.0
    middle = [at + half * along for at, along in zip(body.origin, body.direction, strict=True)]
    return middle, math.hypot(half, body.radius)


def _apart(one: tuple[list[float], float], other: tuple[list[float], float]) -> float:
    """Return the room between the spheres around two bodies [m]: never more than between the bodies."""
    return math.dist(one[0], other[0]) - (one[1] + other[1])


# ----------------------------------------------------------------------------------------------------------------------
# Whether the gearbox stays out of the space that the design keeps free.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Entry:
    """The body that is nearest to a keep-out, or farthest inside it."""

    name: str
    """Of the keep-out."""
    reason: str
    body: Body
    room: Room


def entries(design: Design, bodies: Sequence[Body]) -> Iterator[Entry]:
    """Yield the nearest body of every keep-out.

    Args:
        design: With its keep-outs.
        bodies: At their places.
    """
    for name, keep in design.keep_out.items():
        space = _space(keep)
        rooms = [(body, solid_room(solid_of(body), space, enough=0.0)) for body in bodies]
        if rooms:
            body, room = smallest(rooms, lambda pair: pair[1].gap)
            yield Entry(name, keep.reason, body, room)


def keep_out_checks(design: Design, bodies: Sequence[Body]) -> Iterator[Check]:
    """Yield whether all bodies stay out of every keep-out.

    Args:
        design: With its keep-outs.
        bodies: At their places.
    """
    for entry in entries(design, bodies):
        gap = entry.room.gap
        into = f"{-1e3 * gap:.3g} mm into it, " if gap < 0.0 else ""
        yield Check(
            GEARBOX, f"keep-out {entry.name}", CLAUSE, max(entry.room.apart, 0.0), entry.room.needed,
            "length", exponent=None, place=entry.body.name, why=f"{into}{entry.reason}",
        )  # fmt: skip


def _space(keep: KeepOut) -> Solid:
    ends = [(spot.x, spot.y, spot.z) for spot in (keep.start, keep.end)]
    if keep.radius is None:
        return box_of(*ends)
    axis = np.array(ends[1]) - np.array(ends[0])
    return Solid(axis / np.linalg.norm(axis), np.array(ends), np.full(2, keep.radius), 0.0)


# ----------------------------------------------------------------------------------------------------------------------
# Axes on which no order gives all that stands there room, and gears that are hollow around another shaft.
# ----------------------------------------------------------------------------------------------------------------------


def order_checks(context: Context, arrangement: Arrangement) -> Iterator[Check]:
    """Yield every axis on which nothing was found that lets all its shafts turn, and what would help.

    Args:
        context: What sizing reads.
        arrangement: Its axes and plans.
    """
    if not arrangement.unordered:
        return
    for axle in axles_in(context):
        if best_way(axle) is None:
            yield Check(
                PartId(Kind.SHAFT, axle.shafts[0]),
                "order along its axis",
                CLAUSE,
                0.0,
                1.0,
                exponent=None,
                why=_help(axle),
            )


def _help(axle: Axle) -> str:
    """Return what would make an order."""
    free = best_way(axle._replace(wished=()))
    if free is not None:
        names = ", ".join(axle.tokens[k].name for k in free.order)
        return f"no order that keeps to [layout] lets all shafts pass each other; without order and places: {names}"
    helps = [token.name for k, token in enumerate(axle.tokens) if token.kind != "set" and _without(axle, k)]
    if helps:
        return f"no order lets all shafts pass each other; one does without {' or without '.join(helps)}: move it"
    return "no order lets all shafts pass each other; join other members of the sets, or use a layshaft"


def _without(axle: Axle, left: int) -> bool:
    """Tell whether there is an order without one of the tokens."""
    tokens = (*axle.tokens[:left], *axle.tokens[left + 1 :])
    return best_way(Axle(axle.shafts, tokens, (), ())) is not None


def hollow_checks(context: Context, gears: Sequence[GearSizing], arrangement: Arrangement) -> Iterator[Check]:
    """Yield the rim of every gear of a hollow shaft around another one, over the height of its teeth.

    Args:
        context: What sizing reads.
        gears: As sized.
        arrangement: With its bodies.
    """
    hollow = {outer for _, outer in arrangement.within}
    for gear in gears if hollow else ():
        if gear.rim or gear.role is Role.PLANET or hollow.isdisjoint(gear.shafts):
            continue
        own = {gear.part, *(gear.body(shaft) for shaft in gear.shafts)}
        bore = max((body.bore for body in arrangement.bodies if body.part in own), default=0.0)
        rim = root_diameter(context, gear) / 2.0 - bore
        yield Check(
            gear.part, "rim around its bore", "ISO 6336-3:2019, Y_B", rim / (TOOTH_HEIGHT * gear.module), BACKUP,
            exponent=None, symbol="s_R/h_t",
        )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Whether the pins of a carrier fit inside the planets on them.
# ----------------------------------------------------------------------------------------------------------------------


def pin_checks(design: Design, gears: Mapping[str, GearSizing], carriers: Sequence[CarrierSizing]) -> Iterator[Check]:
    """Yield whether the pin of every planet is thinner than the planet's root circle.

    Args:
        design: With the rules of its stages.
        gears: By name.
        carriers: As sized.
    """
    pins = {carrier.stage: carrier.pin_diameter for carrier in carriers}
    for gear in gears.values():
        if gear.role is Role.PLANET and gear.stage in pins:
            root = 2.0 * cylindrical_gear(design, gear).root_radius
            yield Check(
                gear.part, "pin in its bore", "ISO 21771, d_f", pins[gear.stage], root, "length",
                at_most=True, exponent=None,
            )  # fmt: skip
