"""Whether bodies have room beside each other, as checks: distance of middles over what both bodies need.

Bodies of two shafts are held against each other unless they mesh or belong to one planetary set; those that share an
axis, where not both shafts are built, by `coaxial_checks`. On one shaft, where seats are kept apart as they are
sized, the blank of a bevel or face gear is held against the bearings and the other gears: it reaches beyond its seat.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import NamedTuple

from gearwright.checks import Check
from gearwright.identity import GEARBOX, Kind, PartId
from gearwright.sizing.arranged import Arrangement, Body
from gearwright.sizing.mounted import JointSizing
from gearwright.sizing.places.coaxial import CLAUSE, axes_among, of_one_set, owner
from gearwright.sizing.places.solids import Room, room_between
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.spec import GROUND

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
