"""Positioning of shafts and carriers without interference, with free axes turned, and checks of clearance."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from gearwright.base import GEARBOX, Check, DesignError, Kind, PartId, Role, smallest
from gearwright.sizing.arrangement import axles_in
from gearwright.sizing.axis_order import Axle, best_way
from gearwright.sizing.gear_geometry import cylindrical_gear, root_diameter
from gearwright.sizing.places.bodies import Parts, placed, roomy
from gearwright.sizing.places.frames import (
    CLAUSE,
    Room,
    Solid,
    arrange_meshing,
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
from gearwright.sizing.result import Arrangement, Body, GearSizing, Turn
from gearwright.sizing.shaft_results import BearingSizing, BuiltShaft, CarrierSizing, JointSizing, ShaftSizing
from gearwright.sizing.shafts import Built, refuse_bores, refuse_idle_shafts, size_carriers, size_shafts
from gearwright.spec import GROUND, Design
from gearwright.spec.design import CONCEPT, SIDE_ANGLES, KeepOut

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
    every = zip(bodies, axes_among(bodies), map(sphere_around, bodies), strict=True)
    for (one, first, around), (other, second, beside) in combinations(every, 2):
        if not _minds(one, other, rules, coaxial=first == second) or least_room(around, beside) > clear + _TOUCH:
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
    every = zip(bodies, axes_among(bodies), map(sphere_around, bodies), strict=True)
    return any(
        _minds(one, other, rules, coaxial=first == second)
        and least_room(around, beside) <= 0.0
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


def sphere_around(body: Body) -> tuple[list[float], float]:
    """Return middle and radius of the sphere around a body [m].

    Args:
        body: Its envelope.
    """
    half = body.length / 2.0
    middle = [at + half * along for at, along in zip(body.origin, body.direction, strict=True)]
    return middle, math.hypot(half, body.radius)


def least_room(one: tuple[list[float], float], other: tuple[list[float], float]) -> float:
    """Return the room between the spheres around two bodies [m]: never more than between the bodies.

    Args:
        one: Around the first.
        other: Around the other.
    """
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


# ----------------------------------------------------------------------------------------------------------------------
# Axes that the design leaves open, turned about their mates by the least angle that makes room.
#
# One axis after another, in the order of the shafts: where turning it moves bodies that stand into each other or into
# a keep-out, it stands at the smallest turn that gives all of them room, found on a grid of 5° both ways and refined
# by halving; where no turn does, it stays. Sizes are those that were found before; who calls sizes the shafts anew
# and looks again.
# ----------------------------------------------------------------------------------------------------------------------


STEP = math.radians(5.0)
"""Of the grid [rad]."""
_HALVINGS = 10
"""Of a step of the grid, until the smallest turn is found to 0.005° [-]."""
_PROBE = math.radians(77.0)
"""Turn that shows whether an axis has to do with what stands into each other [rad]."""
CLEAR = 1e-3
"""How far an axis is turned on beyond where it has room, along its circle or less [m]: sizes change as it turns."""
_SAME = 1e-4
"""Change of a gap below which turning an axis has not moved it [m]."""


class Clash(NamedTuple):
    """What stands into each other."""

    gap: float
    """Negative [m]."""
    bodies: tuple[str, ...]
    """Names of both, or of the one in a keep-out."""
    words: str
    """What stands how far into what."""


Clashes = Mapping[str, Clash]
"""Owners of two bodies, or a keep-out -> what stands into each other."""


@dataclass(frozen=True)
class _Task:
    """What is turned."""

    parts: Parts
    rules: Rules
    angles: Mapping[str, float]
    """Turned so far [rad]."""

    def turned(self, shaft: str, angle: float) -> Arrangement | None:
        """Return where everything stands with one axis turned; None where the axes do not close so.

        Args:
            shaft: Of the axis.
            angle: Its direction from its mate [rad].
        """
        try:
            bare = arrange_meshing(self.parts.context, tuple(self.parts.gears.values()), {**self.angles, shaft: angle})
        except DesignError:
            return None
        return placed(replace(self.parts, arrangement=bare))


def clashes(design: Design, arrangement: Arrangement, rules: Rules) -> Clashes:
    """Return owners of two bodies, or a keep-out -> what stands into each other most.

    Args:
        design: With its keep-outs.
        arrangement: With its bodies.
        rules: Which bodies need no room.
    """
    found = {
        f"{one} {other}": Clash(
            meeting.room.gap,
            (meeting.one.name, meeting.other.name),
            f"{meeting.names} stood {-1e3 * meeting.room.gap:.3g} mm into each other",
        )
        for (one, other), meeting in meetings(arrangement.bodies, rules).items()
    }
    for entry in entries(design, arrangement.bodies):
        words = f"{entry.body.name} stood {-1e3 * entry.room.gap:.3g} mm into keep-out {entry.name}"
        found[f"keep-out {entry.name}"] = Clash(entry.room.gap, (entry.body.name,), words)
    return {key: clash for key, clash in found.items() if clash.gap < -_TOUCH}


def turns_of(parts: Parts, rules: Rules, arrangement: Arrangement) -> tuple[Turn, ...]:
    """Return the axes that must be turned to make room, with those turned already; the latter where all have room.

    Args:
        parts: What is sized.
        rules: Which bodies need no room.
        arrangement: Where everything stands, bodies included.
    """
    design, turns = parts.context.design, {turn.shaft: turn for turn in arrangement.turns}
    known = clashes(design, arrangement, rules)
    for shaft in design.shafts[1:]:
        now = _direction(parts, arrangement.axes, shaft) if known else None
        if now is None or (shaft in design.layout and design.layout[shaft].angle is not None):
            continue
        task = _Task(replace(parts, arrangement=arrangement), rules, {name: turn.after for name, turn in turns.items()})
        moved = _moved(task, shaft, now, known)
        into = [known[key] for key in known if key in moved]
        after = _least(task, shaft, now, frozenset(known) - moved, into) if moved else None
        if after is not None:
            why = smallest([clash for key, clash in known.items() if key in moved], lambda clash: clash.gap).words
            turns[shaft] = Turn(shaft, turns[shaft].before if shaft in turns else now, after, why)
            known = {key: clash for key, clash in known.items() if key not in moved}
    return tuple(turns.values())


def _direction(parts: Parts, axes: Mapping[str, complex], shaft: str) -> float | None:
    """Return the direction of a shaft's axis from the first axis that it meshes with [rad]; None where it has none."""
    for mesh in parts.context.train.meshes:
        if mesh.stage in parts.context.design.pairs and shaft in mesh.nodes[:2]:
            mate = mesh.nodes[1 - mesh.nodes.index(shaft)]
            if abs(axes[shaft] - axes[mate]) > 0.0:
                return cmath.phase(axes[shaft] - axes[mate])
    return None


def _moved(task: _Task, shaft: str, now: float, known: Clashes) -> frozenset[str]:
    """Return the clashes whose bodies turning an axis moves against each other, or against a keep-out."""
    here = {body.name: body for body in task.parts.arrangement.bodies}
    for turn in (_PROBE, -_PROBE):
        stands = task.turned(shaft, now + turn)
        if stands is not None:
            there = {body.name: body for body in stands.bodies}
            return frozenset(key for key, clash in known.items() if _is_moved(clash, here, there))
    return frozenset()


def _is_moved(clash: Clash, here: Mapping[str, Body], there: Mapping[str, Body]) -> bool:
    if len(clash.bodies) == 1:
        one, other = here[clash.bodies[0]], there[clash.bodies[0]]
        ends = zip((*one.origin, *one.direction), (*other.origin, *other.direction), strict=True)
        return any(abs(after - before) > _SAME for before, after in ends)
    before, after = (
        room_between(bodies[clash.bodies[0]], bodies[clash.bodies[1]], enough=-math.inf).gap for bodies in (here, there)
    )
    return abs(after - before) > _SAME


def _is_left(arrangement: Arrangement, names: tuple[str, ...]) -> bool:
    """Tell whether two bodies still stand into each other, on axes of their own."""
    one, other = (next(body for body in arrangement.bodies if body.name == name) for name in names)
    first, second = axes_among((one, other))
    return first != second and stand_into(one, other, _TOUCH)


def _least(task: _Task, shaft: str, now: float, left: frozenset[str], moved: Sequence[Clash]) -> float | None:
    """Return the direction nearest to the present one that leaves no clash but those that no turn moves [rad].

    None where there is none.
    """
    design = task.parts.context.design
    pairs = [clash.bodies for clash in moved if len(clash.bodies) == 2]

    def clear(turn: float) -> bool:
        stands = task.turned(shaft, now + turn)
        if stands is None or any(_is_left(stands, pair) for pair in pairs):
            return False
        return not any_into(stands.bodies, task.rules, but=left) and all(
            entry.room.gap >= -_TOUCH or f"keep-out {entry.name}" in left for entry in entries(design, stands.bodies)
        )

    turn = next((turn for turn in _grid(design, shaft, now) if clear(turn)), None)
    if turn is None:
        return None
    low, high = turn - math.copysign(STEP, turn), turn
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        low, high = (low, middle) if clear(middle) else (middle, high)
    arm = max(max(abs(frame.origin.y), abs(frame.origin.z)) for frame in task.parts.arrangement.frames.values())
    more = high + math.copysign(CLEAR / max(arm, CLEAR), high)
    return now + (more if clear(more) else high)


def _grid(design: Design, shaft: str, now: float) -> Iterator[float]:
    """Yield turns both ways, the smallest first, that keep to the side that is asked [rad]."""
    side = design.layout[shaft].side if shaft in design.layout else None
    for k in range(1, round(math.pi / STEP) + 1):
        for turn in (k * STEP, -k * STEP):
            if side is None or math.cos(now + turn - SIDE_ANGLES[side]) > 0.0:
                yield turn


# ----------------------------------------------------------------------------------------------------------------------
# Shafts and carriers sized where everything has room: sized, placed, axes turned where they must, and sized again.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 3
"""How often axes are turned at most: the loads on the shafts turn with them, and with these their diameters [-]."""


@dataclass(frozen=True)
class Settled:
    """What carries gears, and where it stands."""

    arrangement: Arrangement
    shafts: tuple[ShaftSizing, ...]
    built: tuple[Built, ...]
    carriers: tuple[CarrierSizing, ...]
    rules: Rules
    """Which bodies need no room beside each other."""

    @property
    def built_shafts(self) -> tuple[BuiltShaft, ...]:
        """Shafts with bearings."""
        return tuple(shaft.shaft for shaft in self.built)

    @property
    def bearings(self) -> tuple[BearingSizing, ...]:
        """Of those shafts."""
        return tuple(bearing for shaft in self.built for bearing in shaft.bearings)

    @property
    def joints(self) -> tuple[JointSizing, ...]:
        """Of those shafts."""
        return tuple(joint for shaft in self.built for joint in shaft.joints)


def settle(context: Context, gears: tuple[GearSizing, ...], *, still: bool = False) -> Settled:
    """Return shafts and carriers with the arrangement in which they have room, as far as open angles give it.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        still: Whether open axes stay where they stand first.

    Raises:
        DesignError: If axes do not close, or what sits on a shaft, its bore or its strength cannot be had.
    """
    turns: tuple[Turn, ...] = ()
    for _ in range(0 if still else ROUNDS):
        settled = _settled(context, gears, turns)
        found = turns_of(_parts(context, gears, settled), settled.rules, settled.arrangement)
        if found == turns:
            return settled
        turns = found
    return _settled(context, gears, turns)


def _settled(context: Context, gears: tuple[GearSizing, ...], turns: tuple[Turn, ...]) -> Settled:
    bare = arrange_meshing(context, gears, {turn.shaft: turn.after for turn in turns})
    shafts, built = size_shafts(context, gears, bare)
    refuse_bores(shafts)
    refuse_idle_shafts(shafts)
    by_name = {gear.name: gear for gear in gears}
    joints = [joint for shaft in built for joint in shaft.joints]
    rules = rules_of(context, by_name, [shaft.shaft.name for shaft in built], joints)
    bare, room, without = replace(bare, turns=turns), set[str](), set[str]()
    while True:  # plates that share are thinner, which leaves other sets room for a second one; stiff ones leave less
        carriers = size_carriers(context, gears, shafts, bare.two_sided, tuple(sorted(room)))
        settled = Settled(bare, shafts, tuple(built), carriers, rules)
        settled = replace(settled, arrangement=placed(_parts(context, gears, settled)))
        if context.design.level == CONCEPT:
            return settled
        more = {*roomy(_Standing(context.design, gears, shafts, settled.arrangement, carriers))}
        shared = {carrier.stage for carrier in carriers if carrier.free_plate is not None}
        if lost := (room & shared) - more:
            without |= lost
        elif more - without <= room:
            return settled
        room = (room | more) - without


class _Standing(NamedTuple):
    """What has to be known to tell whether second plates have room."""

    design: Design
    gears: tuple[GearSizing, ...]
    shafts: tuple[ShaftSizing, ...]
    arrangement: Arrangement
    carriers: tuple[CarrierSizing, ...]


def _parts(context: Context, gears: tuple[GearSizing, ...], settled: Settled) -> Parts:
    by_name = {gear.name: gear for gear in gears}
    return Parts(
        context, by_name, settled.shafts, settled.built_shafts, settled.bearings, settled.carriers, settled.arrangement
    )
