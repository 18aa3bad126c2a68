"""Bearings for every shaft that needs them: where they stand, of which kind, and how long the shafts become."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import (
    SIDES,
    Check,
    DesignError,
    Kind,
    Problem,
    Role,
    carrier_part,
    largest,
    refuse,
    smallest,
    verb,
)
from gearwright.closure.proportion import teeth_of
from gearwright.sizing import Sizing, size
from gearwright.sizing.arrangement import shared_axes
from gearwright.sizing.loads import shaft_forces
from gearwright.sizing.mass import CompleteMass, bevel_cones, complete_mass
from gearwright.sizing.rating import Context, context_of
from gearwright.sizing.result import Body, GearSizing, ShaftPlan
from gearwright.sizing.shafts import built_checks
from gearwright.sizing.shafts.building import Built, build_shaft
from gearwright.sizing.shafts.shafts import shaft_material
from gearwright.spec import Airscrew, Design, design_text, edited
from gearwright.spec.design import BUILT, NOTHING_GIVEN, BearingSeat, Pair, module_owners
from gearwright.spec.design.stages import Joint, Place
from gearwright.spec.edit import Value, implied

_MM = 1e-3

# ----------------------------------------------------------------------------------------------------------------------
# What stands on a shaft, how much of its axis each thing takes, and which of it stands between bearings.
# ----------------------------------------------------------------------------------------------------------------------


PARALLEL = 1e-6
"""How far the cosine of two directions of one axis may differ from 1 [-]."""
FIRST, SECOND = ENDS = ("first", "second")
"""Of a shaft, and of what stands between its bearings."""
STANDING = ("gear", "set")
"""Kinds of items that are wider than the shaft."""
COUPLED = ("machine", "link")
"""Kinds of items that a hub joins to a shaft."""


class Item(NamedTuple):
    """Something on a shaft, and what it takes of the axis."""

    name: str
    place: float
    """Middle of its width, from the first end of the shaft as it is without bearings [m]."""
    before: float
    """From the start of what it takes to its place [m]."""
    after: float
    """From its place to the end of what it takes [m]."""
    kind: str
    """``gear`` of a pair, ``set``, ``machine``, ``airscrew``, ``bearing``, or ``link``: a clutch, brake or damper."""
    inside: float = 0.0
    """How far its shaft goes on beyond its place where it ends there: a sun's as far as its teeth [m]."""


class Core(NamedTuple):
    """Which of the items on a shaft stand between its bearings."""

    first: int
    last: int
    """Behind the last of them; the same as `first` where both bearings stand side by side there."""


def items_on(sizing: Sizing, shaft: str) -> tuple[Item, ...]:
    """Return what stands on a shaft, in order along it.

    Args:
        sizing: Without bearings of that shaft.
        shaft: Its name.
    """
    plan, design = sizing.arrangement.plans[shaft], sizing.design
    gears = {gear.name: gear for gear in sizing.gears}
    sets = {gear.name: gear.stage for gear in sizing.gears if gear.stage in design.sets}
    sets |= {str(carrier_part(stage)): stage for stage in design.sets}
    found = []
    for name, place in plan.places.items():
        if name in sets:
            middle = _middle(sizing, shaft, name, sets[name])
            sun = name in gears and gears[name].role is Role.SUN
            inside = gears[name].face_width / 2.0 if sun else 0.0
            found.append(Item(name, middle, *_taken(sizing, shaft, middle, sets[name]), "set", inside))
        elif name in gears:
            found.append(Item(name, place, *_taken(sizing, shaft, place, gears[name]), "gear"))
        else:
            machine = design.machines.get(name)
            kind = "link" if machine is None else "airscrew" if isinstance(machine, Airscrew) else "machine"
            found.append(Item(name, place, 0.0, 0.0, kind))
    order = list(plan.places)
    return tuple(sorted(found, key=lambda item: (plan.places[item.name], order.index(item.name))))


def _middle(sizing: Sizing, shaft: str, name: str, stage: str) -> float:
    """Return where a member of a set has its middle along a shaft, of its carrier that of the planets [m]."""
    own = [gear for gear in sizing.gears if gear.name == name] or [
        gear for gear in sizing.gears if gear.stage == stage and gear.role is Role.PLANET
    ]
    bodies = [body for body in sizing.arrangement.bodies if any(_is_of(body, gear) for gear in own)]
    ends = [end for body in bodies for end in _ends(sizing, shaft, body)]
    return (min(ends) + max(ends)) / 2.0


def _taken(sizing: Sizing, shaft: str, place: float, what: GearSizing | str) -> tuple[float, float]:
    """Return how far a gear on a shaft, or all of a set around it, reaches before and behind a place [m]."""
    along = np.asarray(sizing.arrangement.frames[shaft].along)
    ends = [place]
    for body in sizing.arrangement.bodies:
        own = body.part.name == what if isinstance(what, str) else _is_of(body, what) and body.shaft == shaft
        if own and abs(abs(float(np.asarray(body.direction) @ along)) - 1.0) < PARALLEL:
            ends += _ends(sizing, shaft, body)
    return place - min(ends), max(ends) - place


def _is_of(body: Body, gear: GearSizing) -> bool:
    return body.part.kind is Kind.GEAR and body.part.name == gear.stage and body.part.role is gear.role


def _ends(sizing: Sizing, shaft: str, body: Body) -> tuple[float, float]:
    """Return where a body begins and ends along a shaft, from its first end [m]."""
    frame = sizing.arrangement.frames[shaft]
    along = np.asarray(frame.along)
    start = float((np.asarray(body.origin) - np.asarray(frame.origin)) @ along)
    return start, start + float(np.asarray(body.direction) @ along) * body.length


def core_of(items: Sequence[Item]) -> Core | None:
    """Return what of the items on a shaft stands between its bearings; None where it needs none.

    Gears of pairs stand between bearings; a propeller or rotor, and a machine beside a planetary set, overhang them. A
    shaft that joins sets alone, or the sun of one to a machine's coupling, is held by the planets around it.

    Args:
        items: In order.
    """
    gears, screws, machines = ([k for k, item in enumerate(items) if item.kind in kinds]
                               for kinds in (("gear",), ("airscrew",), COUPLED))  # fmt: skip
    if gears:
        return Core(gears[0], gears[-1] + 1)
    if screws:
        beside = max(screws[0], 1)
        return Core(beside, beside)
    held = [item for item in items if item.kind == "set" and not item.inside]
    if not held or not machines:
        return None
    between = [k for k in machines if 0 < k < len(items) - 1]
    if between:
        return Core(between[0], between[-1] + 1)
    beside = max(machines[0], 1)
    return Core(beside, beside)


# ----------------------------------------------------------------------------------------------------------------------
# Kinds of bearings for a shaft, and where all stands on it with them.
# ----------------------------------------------------------------------------------------------------------------------


class Option(NamedTuple):
    """Kinds of the bearings of a shaft."""

    first: tuple[str, str]
    """Kind of the first radial one, and what it locates."""
    second: tuple[str, str]
    """Of the second."""
    axial_end: str = ""
    """End at which a four-point contact bearing stands beside the radial one and locates both ways; empty: none."""


OPTIONS = (
    Option(("deep-groove", "both"), ("cylindrical", "none")),
    Option(("cylindrical", "none"), ("deep-groove", "both")),
    Option(("taper", "first"), ("taper", "second")),
    Option(("cylindrical", "none"), ("cylindrical", "none"), FIRST),
    Option(("cylindrical", "none"), ("cylindrical", "none"), SECOND),
)
"""Arrangements of locating and floating bearings that are tried for every shaft."""
AXIAL = ("four-point", "both")
"""Kind of the bearing that stands beside a radial one, and what it locates."""
DIGITS = 4
"""To which places and lengths in millimetres are written [-]."""
GUESS = 60e-3
"""Width of a bearing before one is chosen: wider than it will be, as a bearing without room is refused [m]."""
BESIDE = 2e-3
"""Between two bearings side by side [m]."""
GAP = 3e-3
"""Between a bearing and what its shaft carries between both, at least [m]."""
SHOULDER = 0.1
"""The same over the diameter of the shaft: a shoulder of 0.08 d and 0.02 d beside it [-]."""
COVER = 7e-3
"""By how much more a bearing stands from what is beyond it: a cover with its screws, and room for what turns [m]."""
END = 5e-3
"""Of the shaft beyond its last bearing, for what holds the ring [m]."""
SEAL = 12e-3
"""Between a bearing and a hub beyond it: a seal and its cover [m]."""
HUB = 1.0
"""Hub of a coupling over the diameter of the shaft [-], an estimate."""
OVERHANG = 2.5
"""From the last bearing to the plane of a propeller or rotor over the diameter of its shaft [-], an estimate."""
SPAN_OF_WHEEL = 0.25
"""Span of bearings over the pitch diameter of the largest gear on the shaft, at least: it tilts [-], an estimate."""
SPANS = {"gear": 1.0 / 0.6, "airscrew": 1.25}
"""What overhangs its bearings -> their span over that overhang, at least [-], an estimate."""
LEAST_SEAT = 0.7
"""Bore of a bearing over the diameter that its shaft asks for, at least, also where it carries no torque [-]."""
BORE_STEP = 5e-3
"""Of the bores of bearings [m]."""
BORES = (0.6, 0.4, 0.0)
"""Bore over the diameter of a shaft whose bore is open, the first with which there is room for it [-]: 0.6 costs a
seventh of the strength and saves a third of the mass."""


@dataclass(frozen=True)
class Line:
    """A shaft that is to stand in bearings."""

    name: str
    items: tuple[Item, ...]
    core: Core
    thick: float
    """Its diameter as first sized [m]."""
    wheel: float
    """Pitch diameter of the largest gear of a pair on it [m]."""
    splined: tuple[str, ...]
    """Gears that a spline joins to it; the others are of one piece with it."""
    bore: float | None = None
    """Over its diameter [-]; None: as the design gives it."""
    apart: Mapping[str, float] = field(default_factory=dict)
    """Bearing -> how much farther it stands from what is beside it [m]."""
    no_axial: frozenset[str] = frozenset()
    """Ends at which there is no room for one more bearing."""
    slack: float = 0.0
    """By which more than the width of a bearing is left for it [m]."""
    thicker: float = 0.0
    """By which the thinnest seat is thicker [m]."""

    @property
    def thinnest(self) -> float:
        """Bore of its bearings, at least: a multiple of `BORE_STEP` [m]."""
        return math.ceil(LEAST_SEAT * self.thick / BORE_STEP - 1e-6) * BORE_STEP + self.thicker

    @property
    def machine_end(self) -> str:
        """End at which a machine stands that may stand at the other as well; empty: none, or beside a set."""
        kinds = [item.kind for item in self.items]
        if not {"set", "link"}.isdisjoint(kinds) or kinds.count("machine") != 1:
            return ""
        return FIRST if kinds[0] == "machine" else SECOND if kinds[-1] == "machine" else ""


def plan_with(line: Line, option: Option, widths: Mapping[str, float], bores: Mapping[str, float]) -> ShaftPlan:
    """Return a shaft with bearings: its length, and where everything on it stands, in whole millimetres.

    Args:
        line: The shaft.
        option: Kinds of its bearings.
        widths: Bearing -> its width, of those that are chosen [m].
        bores: Bearing -> its bore, of those that would be thinner than a shaft is made [m].
    """
    radial = [f"{line.name}-{end}" for end in ENDS]
    before, after = [radial[0]], [radial[1]]
    if option.axial_end == FIRST:
        before.insert(0, f"{line.name}-axial")
    elif option.axial_end:
        after.append(f"{line.name}-axial")
    halves = {name: widths.get(name, GUESS) / 2.0 + line.apart.get(name, 0.0) for name in (*before, *after)}
    row = [
        *line.items[: line.core.first],
        *(Item(name, 0.0, halves[name], halves[name], "bearing") for name in before),
        *line.items[line.core.first : line.core.last],
        *(Item(name, 0.0, halves[name], halves[name], "bearing") for name in after),
        *line.items[line.core.last :],
    ]
    steps = [_step(line, one, other) for one, other in pairwise(row)]
    for k, (one, other) in enumerate(pairwise(row)):
        if (one.name in after and other.kind in STANDING) or (other.name in before and one.kind in STANDING):
            steps[k] += COVER
    _spread(line, row, steps, radial)
    places, reached = dict[str, float](), _beyond(line, row[0], row[0].before)
    for k, item in enumerate(row):
        places[item.name] = _written(reached)
        reached += steps[k] if k < len(steps) else _beyond(line, item, item.after)
    kinds = dict(zip(radial, (option.first, option.second), strict=True))
    seats = dict[str, BearingSeat]()
    for name in (*before, *after):
        kind, locates = kinds.get(name, AXIAL)
        seat = {"shaft": line.name, "position": places[name], "kind": kind, "locates": locates}
        seat |= {"bore": bores[name]} if name in bores else {}
        seats[name] = BearingSeat.model_validate(seat if name in kinds else {**seat, "radial": False})
    own = {item.name: places[item.name] for item in line.items}
    seats = dict(sorted(seats.items(), key=lambda seat: seat[1].position))
    return ShaftPlan(_written(reached), (places[radial[0]], places[radial[1]]), own, seats)


def _step(line: Line, one: Item, other: Item) -> float:
    """Return how far two neighbours stand from each other [m]."""
    if one.kind == other.kind == "gear":
        return other.place - one.place
    kinds, far = {one.kind, other.kind}, one.after + other.before
    if kinds == {"bearing"}:
        return _up(far + BESIDE)
    if "airscrew" in kinds:
        return _up(max(far + SEAL + HUB * line.thick, OVERHANG * line.thick))
    if not kinds.isdisjoint(COUPLED):
        return _up(far + SEAL + HUB * line.thick / 2.0)
    return _up(far + max(GAP, SHOULDER * line.thick))


def _spread(line: Line, row: Sequence[Item], steps: list[float], radial: Sequence[str]) -> None:
    """Move both bearings apart as far as wheels between them, and what overhangs them, ask for."""
    first, second = (next(k for k, item in enumerate(row) if item.name == name) for name in radial)
    asked = [SPAN_OF_WHEEL * line.wheel]
    for k, item in enumerate(row):
        if item.kind in SPANS and not first < k < second:
            asked.append(SPANS[item.kind] * (sum(steps[k:first]) if k < first else sum(steps[second:k])))
    lacking = max(asked) - sum(steps[first:second])
    if lacking > 0.0 and second == first + 1:
        steps[first] = _up(steps[first] + lacking)
    elif lacking > 0.0:
        steps[first], steps[second - 1] = _up(steps[first] + lacking / 2.0), _up(steps[second - 1] + lacking / 2.0)


def _beyond(line: Line, item: Item, half: float) -> float:
    """Return how far a shaft goes on beyond the middle of what stands at its end [m]."""
    if item.kind in ("set", "link"):
        return item.inside
    if item.kind in ("machine", "airscrew"):
        return _up(HUB * line.thick / 2.0)
    return _up(half + (END if item.kind == "bearing" else 0.0))


def _up(length: float) -> float:
    """Return a length in whole millimetres, rounded up [m]."""
    return math.ceil(length / _MM - 1e-6) * _MM


def _written(length: float) -> float:
    """Return a length as it is read from a file [m]."""
    return round(length / _MM, DIGITS) * _MM


# ----------------------------------------------------------------------------------------------------------------------
# The lightest bearings with which a shaft passes its checks.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 6
"""How often places follow from the widths of the bearings that are chosen, at most [-]."""
WIDER = 1.3
"""Room for a bearing over the width of one that was refused there [-]."""


class Stood(NamedTuple):
    """A shaft in bearings."""

    line: Line
    option: Option
    plan: ShaftPlan
    built: Built
    failing: tuple[Check, ...]
    mass: float
    """Of shaft and bearings [kg]."""

    @property
    def ends(self) -> dict[str, str]:
        """Bearing -> the end of what the shaft carries at which it stands; none where all stand at one."""
        if self.line.core.first == self.line.core.last:
            return {}
        middle = sum(self.plan.bearings) / 2.0
        return {name: FIRST if seat.position < middle else SECOND for name, seat in self.plan.seats.items()}


def stood(sizing: Sizing, context: Context, line: Line) -> Stood:
    """Return a shaft in the lightest of the bearings with which the fewest of its checks fail.

    Args:
        sizing: In which gears and axes stand as they load the shaft.
        context: What sizing reads.
        line: The shaft.

    Raises:
        DesignError: If none can be had.
    """
    tried, refused = list[Stood](), list[DesignError]()
    for bore in _bores(context.design, line.name):
        for option in OPTIONS:
            if option.axial_end in line.no_axial:
                continue
            try:
                tried.append(_with(sizing, context, replace(line, bore=bore), option))
            except DesignError as error:
                refused.append(error)
        if any(not one.failing for one in tried):
            break
    if not tried:
        raise min(refused, key=lambda error: len(error.problems))
    fewest = min(len(one.failing) for one in tried)
    return smallest([one for one in tried if len(one.failing) == fewest], lambda one: one.mass)


def _bores(design: Design, shaft: str) -> tuple[float | None, ...]:
    """Return the bores over their diameter that a shaft may have [-]; None: as the design gives it."""
    layout = design.layout.get(shaft, NOTHING_GIVEN)
    is_open = layout.bore is None and layout.bore_ratio is None and "bore_ratio" not in design.shafting.model_fields_set
    return BORES if is_open else (None,)


def _with(sizing: Sizing, context: Context, line: Line, option: Option) -> Stood:
    """Return a shaft in bearings of some kinds, which stand as their widths ask for."""
    widths, bores, found = dict[str, float](), dict[str, float](), None
    for _ in range(ROUNDS):
        try:
            found = _built(sizing, context, line, option, plan_with(line, option, widths, bores))
        except DesignError:
            if found is None and not bores:
                raise
            bores = {name: bore + BORE_STEP for name, bore in bores.items()}
            widths = {name: WIDER * width for name, width in widths.items()}
            continue
        bearings = found.built.bearings
        now = {bearing.name: bearing.bearing.width + line.slack for bearing in bearings}
        thin = {bearing.name: line.thinnest for bearing in bearings if bearing.bearing.bore < line.thinnest}
        if widths and not thin and all(abs(now[name] - widths[name]) < _MM / 2.0 for name in now):
            break
        widths, bores = now, {**bores, **thin}
    assert found is not None
    return found


def _built(sizing: Sizing, context: Context, line: Line, option: Option, plan: ShaftPlan) -> Stood:
    """Return a shaft with its bearings at given places."""
    gears, design = {gear.name: gear for gear in sizing.gears}, context.design
    layout = design.layout.get(line.name, NOTHING_GIVEN)
    layout = layout if line.bore is None else layout.model_copy(update={"bore_ratio": line.bore})
    changed = {
        "bearings": {**design.bearings, **plan.seats},
        "layout": {**design.layout, line.name: layout},
        "joints": {**_splines(line), **design.joints},
    }
    own = replace(context, design=design.model_copy(update=changed))
    forces = shaft_forces(own, line.name, plan, axes=sizing.arrangement.axes, gears=gears)
    built = build_shaft(own, line.name, forces, shaft_material(own), gears=gears, core=None)
    failing = tuple(check for check in built_checks(built, own.design) if check.fails)
    return Stood(line, option, plan, built, failing, _mass(own, built))


def _splines(line: Line) -> dict[str, Joint]:
    return {name: Joint(kind="spline") for name in line.splined}


def _mass(context: Context, built: Built) -> float:
    density, shaft = shaft_material(context).density, built.shaft
    sections = [(step.diameter**2 - shaft.bore**2) * (step.end - step.start) for step in shaft.steps]
    return math.pi / 4.0 * density * sum(sections) + sum(bearing.bearing.mass for bearing in built.bearings)


# ----------------------------------------------------------------------------------------------------------------------
# All shafts of a gearbox, and room for those that stand into something else.
# ----------------------------------------------------------------------------------------------------------------------


SLACK = ((0.0, 0.0), (2e-3, 5e-3), (6e-3, 10e-3))
"""More room for a bearing than its width, and a thicker seat where the end of a shaft carries little, for axes that
turn with longer shafts and load others [m]."""
PLACINGS = 5
"""How often room is made for what stands into something else, at most [-]."""


@dataclass(frozen=True)
class Room:
    """What is done so that parts do not stand into each other."""

    around: Mapping[str, float] = field(default_factory=dict)
    """Set -> more room along its axis, on both sides [m]."""
    beside: Mapping[str, float] = field(default_factory=dict)
    """Bearing -> how much farther it stands from what is beside it [m]."""
    overhung: frozenset[tuple[str, str]] = frozenset()
    """Shafts, and the end at which no bearing holds what stands there."""
    no_axial: frozenset[tuple[str, str]] = frozenset()
    """Shafts, and the end at which no bearing stands beside the radial one."""
    mirrored: frozenset[str] = frozenset()
    """Shafts whose machine stands at the other end."""

    def with_around(self, stage: str, lacking: float) -> Room:
        """Return it with more room around a set."""
        return replace(self, around={**self.around, stage: self.around.get(stage, 0.0) + lacking})

    def with_beside(self, bearing: str, lacking: float) -> Room:
        """Return it with more room beside a bearing."""
        return replace(self, beside={**self.beside, bearing: self.beside.get(bearing, 0.0) + lacking})


@dataclass(frozen=True)
class Arranged:
    """A design whose shafts stand in bearings."""

    before: Sizing
    """Without them."""
    design: Design
    """With them, teeth, modules and face widths as they were sized before."""
    sizing: Sizing
    """Of that."""
    shafts: tuple[Stood, ...]
    """What was put into bearings."""

    @cached_property
    def masses(self) -> tuple[CompleteMass, CompleteMass]:
        """Complete masses before and after."""
        return complete_mass(self.before), complete_mass(self.sizing)

    @cached_property
    def worse(self) -> tuple[Check, ...]:
        """Checks that fail and did not before."""
        known = {check.name for check in self.before.checks if check.fails}
        return tuple(check for check in self.sizing.checks if check.fails and check.name not in known)

    @property
    def text(self) -> str:
        """The design as a file."""
        return design_text(self.design)


@verb
def arrange(design: Design) -> Arranged:
    """Return a design with bearings on every shaft that needs them, and shafts as long as these ask for.

    Args:
        design: Without bearings, or with those of some shafts, which stay.

    Raises:
        DesignError: If it cannot be sized, or a shaft finds no bearings.
    """
    before = size(design)
    own = edited(design, {**dict(teeth_of(design, before)), **dict(_sizes(design, before))})
    sized = size(own)
    context = context_of(sized.design, sized.train, sized.teeth, sized.flows, sized.given)
    room, best = Room(), None
    for _ in range(PLACINGS):
        arranged = Arranged(before, *_placed(own, sized, context, room))
        if best is None or len(arranged.worse) < len(best.worse):
            best = arranged
        more = _more_room(arranged, room)
        if more == room:
            break
        room = more
    assert best is not None
    return best


def _placed(own: Design, sized: Sizing, context: Context, room: Room) -> tuple[Design, Sizing, tuple[Stood, ...]]:
    """Return a design with bearings, its sizing and its shafts."""
    refused: DesignError | None = None
    for slack, thicker in SLACK:
        lines = [replace(line, slack=slack, thicker=thicker) for line in _lines(sized, room)]
        shafts = _stand(sized, context, lines)
        try:
            turned = size(edited(own, dict(_changes(own, sized, shafts, as_given=True))))
        except DesignError:  # it tells where axes stand; without it they are taken as they stood
            turned = sized
        shafts = _stand(turned, context, lines)
        arranged = edited(own, dict(_changes(own, sized, shafts)))
        try:
            return arranged, size(arranged), shafts
        except DesignError as error:
            refused = refused or error
    assert refused is not None
    raise refused


def _lines(sizing: Sizing, room: Room) -> Iterator[Line]:
    """Yield the shafts that need bearings and have none."""
    gears = {gear.name: gear for gear in sizing.gears}
    seated = {seat.shaft for seat in sizing.design.bearings.values()}
    for shaft in sizing.shafts:
        name = shaft.name
        items = tuple(_widened(item, room) for item in items_on(sizing, name))
        own = [gears[item.name] for item in items if item.name in gears]
        if name in seated or _floats(sizing.design, own):
            continue
        if name in room.mirrored:
            items = tuple(
                item._replace(place=-item.place, before=item.after, after=item.before) for item in items[::-1]
            )
        core = core_of(items)
        if core is not None:
            first = core.first + ((name, FIRST) in room.overhung)
            core = Core(first, max(core.last - ((name, SECOND) in room.overhung), first))
            wheel = max((gears[item.name].pitch_diameter for item in items if item.kind == "gear"), default=0.0)
            apart = {seat: far for seat, far in room.beside.items() if seat.rpartition("-")[0] == name}
            full = frozenset(end for end in ENDS if (name, end) in room.no_axial)
            yield Line(name, items, core, shaft.diameter, wheel, _splined(own), apart=apart, no_axial=full)


def _widened(item: Item, room: Room) -> Item:
    more = room.around.get(item.name.split(".")[0], 0.0) if item.kind == "set" else 0.0
    return item._replace(before=item.before + more, after=item.after + more)


def _floats(design: Design, gears: Sequence[GearSizing]) -> bool:
    """Tell whether all gears on a shaft drive face gears, between which it floats."""
    return bool(gears) and all(
        gear.stage in design.pairs and design.pairs[gear.stage].kind == "face" and gear.role is SIDES[0]
        for gear in gears
    )


def _splined(gears: Sequence[GearSizing]) -> tuple[str, ...]:
    """Return the gears that splines join to a shaft: all but one that is of one piece with it, so that bearings go on.

    That is the smallest pinion, or where there is none a ring's bell or the sun.
    """
    for role in (Role.PINION, Role.RING, Role.SUN):
        if own := [gear for gear in gears if gear.role is role]:
            solid = smallest(own, lambda gear: gear.pitch_diameter).name
            return tuple(gear.name for gear in gears if gear.name != solid and gear.role is not Role.RING)
    return tuple(gear.name for gear in gears)


def _stand(sizing: Sizing, context: Context, lines: Sequence[Line]) -> tuple[Stood, ...]:
    """Return all shafts in bearings, loaded as their axes stand; equal branches in those of the heaviest of them."""
    shafts, problems = list[Stood](), list[Problem]()
    for line in lines:
        try:
            shafts.append(stood(sizing, context, line))
        except DesignError as error:
            problems += error.problems
    refuse(problems)
    branches = dict[tuple[str, ...], list[Stood]]()
    for one in shafts:
        branches.setdefault(tuple(item.name for item in one.line.items), []).append(one)
    found = list[Stood]()
    for one in shafts:
        pattern = largest(branches[tuple(item.name for item in one.line.items)], lambda branch: branch.mass)
        found.append(one if pattern is one else _like(sizing, context, one, pattern))
    return tuple(found)


def _like(sizing: Sizing, context: Context, one: Stood, pattern: Stood) -> Stood:
    """Return a shaft in the bearings of another branch, at the same places; as it is where they do not do."""
    name, taken = one.line.name, {bearing.name: bearing.bearing.designation for bearing in pattern.built.bearings}
    seats = {
        name + seat.removeprefix(pattern.line.name): own.model_copy(update={"shaft": name, "designation": taken[seat]})
        for seat, own in pattern.plan.seats.items()
    }
    line = replace(one.line, bore=pattern.line.bore)
    try:
        like = _built(sizing, context, line, pattern.option, replace(pattern.plan, seats=seats))
    except DesignError:
        return one
    return one if len(like.failing) > len(one.failing) else like


def _more_room(arranged: Arranged, room: Room) -> Room:
    """Return what is done next so that parts do not stand into each other.

    More room is made around sets. A bearing moves away; if that was not enough, what it holds overhangs the others, and
    where a machine stands at its end, that goes to the other one.
    """
    planned = {bearing.name: bearing.bearing.width for one in arranged.shafts for bearing in one.built.bearings}
    for bearing in arranged.sizing.bearings:
        wider = bearing.bearing.width - planned.get(bearing.name, math.inf)
        if wider > _MM / 2.0:
            room = room.with_beside(bearing.name, _up(wider / 2.0))
    for check in arranged.worse:
        if check.mode.startswith("room") and check.value is not None and check.limit is not None:
            room = _with_room(arranged, room, check, _up(check.limit - check.value) + _MM)
    return room


def _with_room(arranged: Arranged, room: Room, check: Check, lacking: float) -> Room:
    """Return what is done for one check."""
    names = set(check.place.replace(",", " ").split())
    words = {str(check.part), *check.mode.split(), *names}
    stages = [stage for stage in arranged.design.sets if any(word.split(".")[0] == stage for word in words)]
    if stages:
        for stage in stages:
            room = room.with_around(stage, lacking)
        return room
    for one in arranged.shafts:
        name, seat = one.line.name, next((seat for seat in one.ends if seat in names), "")
        end = _end_of(one, check.why) if name in names else one.ends.get(seat, "")
        if not end:
            continue
        if seat and seat not in room.beside:
            return room.with_beside(seat, lacking)
        if seat == f"{name}-axial":
            return replace(room, no_axial=room.no_axial | {(name, end)})
        if end == one.line.machine_end:
            return replace(room, mirrored=room.mirrored ^ {name})
        return replace(room, overhung=room.overhung | {(name, end)})
    return room


def _end_of(one: Stood, why: str) -> str:
    """Return at which end of a shaft the stretch is that a check tells of; empty where it tells of none."""
    found = re.search(rf"\b{re.escape(one.line.name)} ([\d.]+) to ([\d.]+) mm", why)
    if found is None:
        return ""
    return FIRST if sum(map(float, found.groups())) * _MM < one.plan.length else SECOND


# ----------------------------------------------------------------------------------------------------------------------
# What is written into the design.
# ----------------------------------------------------------------------------------------------------------------------


def _sizes(design: Design, sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield modules and widths that the design leaves open; those of compound sets follow as they did."""
    owners = module_owners(design)
    gears = {gear.stage: gear for gear in sizing.gears}
    for name, stage in design.simple_stages.items():
        table = design.table(name)
        if isinstance(stage, Pair) and stage.kind == "bevel":
            if f"{name}.outer_module" not in sizing.given and owners[name] == name:
                yield f"{table}.outer_module_mm", bevel_cones(sizing, name).outer_module / _MM
        elif f"{name}.module" not in sizing.given and owners[name] == name:
            yield f"{table}.module_mm", gears[name].module / _MM
        if f"{name}.face_width" not in sizing.given:
            yield f"{table}.face_width_mm", gears[name].face_width / _MM


def _changes(
    design: Design, sizing: Sizing, shafts: Sequence[Stood], *, as_given: bool = False
) -> Iterator[tuple[str, Value]]:
    """Yield what is written of bearings, splines, lengths and places; as given, with bearings and diameters."""
    if "level" in design.model_fields_set:
        yield "level", BUILT
    yield from ((path, value) for path, value in implied(design).items() if path != "level")
    seats = {name: seat for one in shafts for name, seat in one.plan.seats.items()}
    if as_given:
        taken = {bearing.name: bearing.bearing.designation for one in shafts for bearing in one.built.bearings}
        seats = {
            name: seat.model_copy(update={"designation": taken[name], "bore": None}) for name, seat in seats.items()
        }
    else:
        joints = {**{name: joint for one in shafts for name, joint in _splines(one.line).items()}, **design.joints}
        yield "joints", {name: own.model_dump(exclude_none=True, exclude_defaults=True) for name, own in joints.items()}
    yield (
        "bearings",
        {
            name: seat.model_dump(exclude_none=True, exclude_defaults=True)
            for name, seat in {**design.bearings, **seats}.items()
        },
    )
    layout = dict(design.layout)
    for name, plan in _plans(design, sizing, shafts).items():
        places = {label: Place(position=at) for label, at in plan.places.items()}
        layout[name] = layout.get(name, NOTHING_GIVEN).model_copy(update={"length": plan.length, "places": places})
    for one in shafts:
        own: dict[str, Any] = {"diameter": None} | ({} if one.line.bore is None else {"bore_ratio": one.line.bore})
        if as_given:
            own |= {"as_given": True, "diameter": max(bearing.bearing.bore for bearing in one.built.bearings)}
        layout[one.line.name] = layout[one.line.name].model_copy(update=own)
    yield "layout", {name: own.model_dump(exclude_none=True, exclude_defaults=True) for name, own in layout.items()}


def _plans(design: Design, sizing: Sizing, shafts: Sequence[Stood]) -> dict[str, ShaftPlan]:
    """Return how shafts in bearings stand, and those on the same axes, whose order would be found anew without it."""
    axis, plans = shared_axes(design), {one.line.name: one.plan for one in shafts}
    beside = {axis[name] for name in plans}
    return plans | {
        name: plan for name, plan in sizing.arrangement.plans.items() if name not in plans and axis[name] in beside
    }
