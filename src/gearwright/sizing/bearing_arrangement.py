"""Bearings for a shaft that has none: what stands between them, of which kind they are, how long the shaft becomes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import (
    SIDES,
    Check,
    DesignError,
    Kind,
    Problem,
    Role,
    carrier_part,
    lacking_of,
    largest,
    refuse,
    smallest,
)
from gearwright.parts.shafts import shaft_mass
from gearwright.sizing.bearings import pressure_centre_checks
from gearwright.sizing.loads import shaft_forces
from gearwright.sizing.places import plates_of
from gearwright.sizing.rating import Context, context_of
from gearwright.sizing.result import Body, GearSizing, ShaftPlan, Sizing
from gearwright.sizing.shafts import built_checks
from gearwright.sizing.shafts.building import Built, build_shaft
from gearwright.sizing.shafts.ends import groove_checks, groove_strengths
from gearwright.sizing.shafts.retention import ends, holding_room, retention_checks
from gearwright.sizing.shafts.shafts import shaft_material
from gearwright.sizing.shafts.stretches import whole_millimetres
from gearwright.spec import Airscrew, Design
from gearwright.spec.design import NOTHING_GIVEN, BearingSeat
from gearwright.spec.design.stages import Joint

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
    """How far its shaft goes on beyond its place where it ends there: a sun's or a ring's as far as its teeth [m]."""
    is_sun: bool = False
    """Whether the planets around it hold it."""


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
            inside = gears[name].face_width / 2.0 if name in gears else 0.0
            sun = name in gears and gears[name].role is Role.SUN
            found.append(Item(name, middle, *_taken(sizing, shaft, middle, sets[name]), "set", inside, sun))
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
    ends, bodies = [place], sizing.arrangement.bodies
    for body in bodies if isinstance(what, GearSizing) else (*bodies, *plates_of(sizing, what)):
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
    held = [item for item in items if item.kind == "set" and not item.is_sun]
    if not held or not machines:
        return None
    between = [k for k in machines if 0 < k < len(items) - 1]
    if between:
        return Core(between[0], between[-1] + 1)
    beside = max(machines[0], 1)
    return Core(beside, beside)


def bare_shafts(sizing: Sizing) -> tuple[str, ...]:
    """Return the shafts that need bearings and have none, in the order of the design.

    Args:
        sizing: Of any level.
    """
    seated = {seat.shaft for seat in sizing.design.bearings.values()}
    bare = (shaft.name for shaft in sizing.shafts if shaft.name not in seated)
    return tuple(name for name in bare if not _floats(sizing, name) and core_of(items_on(sizing, name)) is not None)


def _floats(sizing: Sizing, shaft: str) -> bool:
    """Tell whether all gears on a shaft drive face gears, between which it floats."""
    pairs, places = sizing.design.pairs, sizing.arrangement.plans[shaft].places
    gears = [gear for gear in sizing.gears if gear.name in places]
    return bool(gears) and all(
        gear.stage in pairs and pairs[gear.stage].kind == "face" and gear.role is SIDES[0] for gear in gears
    )


# ----------------------------------------------------------------------------------------------------------------------
# Kinds of bearings for a shaft, and where all stands on it with them.
# ----------------------------------------------------------------------------------------------------------------------


class BearingPair(NamedTuple):
    """Kinds of the bearings of a shaft."""

    first: tuple[str, str]
    """Kind of the first radial one, and what it locates."""
    second: tuple[str, str]
    """Of the second."""
    axial_end: str = ""
    """End at which a four-point contact bearing stands beside the radial one and locates both ways; empty: none."""


OPTIONS = (
    BearingPair(("deep-groove", "both"), ("cylindrical", "none")),
    BearingPair(("cylindrical", "none"), ("deep-groove", "both")),
    BearingPair(("taper", "first"), ("taper", "second")),
    BearingPair(("cylindrical", "none"), ("cylindrical", "none"), FIRST),
    BearingPair(("cylindrical", "none"), ("cylindrical", "none"), SECOND),
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
"""Of the shaft beyond its last bearing before what holds the ring is known [m]."""
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


def plan_with(
    line: Line, option: BearingPair, widths: Mapping[str, float], bores: Mapping[str, float], held: Mapping[str, float]
) -> ShaftPlan:
    """Return a shaft with bearings: its length, and where everything on it stands, in whole millimetres.

    Args:
        line: The shaft.
        option: Kinds of its bearings.
        widths: Bearing -> its width, of those that are chosen [m].
        bores: Bearing -> its bore, of those that would be thinner than a shaft is made [m].
        held: Bearing -> room beside it for the ring or nut that holds it, of those that are chosen [m].
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
    steps = [_step(line, one, other, held) for one, other in pairwise(row)]
    for k, (one, other) in enumerate(pairwise(row)):
        if (one.name in after and other.kind in STANDING) or (other.name in before and one.kind in STANDING):
            steps[k] += COVER
    _spread(line, row, steps, radial)
    places, reached = dict[str, float](), _beyond(line, row[0], row[0].before, held)
    for k, item in enumerate(row):
        places[item.name] = _written(reached)
        reached += steps[k] if k < len(steps) else _beyond(line, item, item.after, held)
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


def _step(line: Line, one: Item, other: Item, held: Mapping[str, float]) -> float:
    """Return how far two neighbours stand from each other [m]."""
    if one.kind == other.kind == "gear":
        return other.place - one.place
    kinds, far = {one.kind, other.kind}, one.after + other.before
    if not kinds.isdisjoint((*COUPLED, "airscrew")):
        far += held.get(one.name, 0.0) + held.get(other.name, 0.0)
    if kinds == {"bearing"}:
        return whole_millimetres(far + BESIDE)
    if "airscrew" in kinds:
        return whole_millimetres(max(far + SEAL + HUB * line.thick, OVERHANG * line.thick))
    if not kinds.isdisjoint(COUPLED):
        return whole_millimetres(far + SEAL + HUB * line.thick / 2.0)
    return whole_millimetres(far + max(GAP, SHOULDER * line.thick))


def _spread(line: Line, row: Sequence[Item], steps: list[float], radial: Sequence[str]) -> None:
    """Move both bearings apart as far as wheels between them, and what overhangs them, ask for."""
    first, second = (next(k for k, item in enumerate(row) if item.name == name) for name in radial)
    asked = [SPAN_OF_WHEEL * line.wheel]
    for k, item in enumerate(row):
        if item.kind in SPANS and not first < k < second:
            asked.append(SPANS[item.kind] * (sum(steps[k:first]) if k < first else sum(steps[second:k])))
    lacking = max(asked) - sum(steps[first:second])
    if lacking > 0.0 and second == first + 1:
        steps[first] = whole_millimetres(steps[first] + lacking)
    elif lacking > 0.0:
        steps[first], steps[second - 1] = (
            whole_millimetres(steps[first] + lacking / 2.0),
            whole_millimetres(steps[second - 1] + lacking / 2.0),
        )


def _beyond(line: Line, item: Item, half: float, held: Mapping[str, float]) -> float:
    """Return how far a shaft goes on beyond the middle of what stands at its end [m]."""
    if item.kind in ("set", "link"):
        return item.inside
    if item.kind in ("machine", "airscrew"):
        return whole_millimetres(HUB * line.thick / 2.0)
    return whole_millimetres(half + (held.get(item.name, END) if item.kind == "bearing" else 0.0))


def _written(length: float) -> float:
    """Return a length as it is read from a file [m]."""
    return round(length / _MM, DIGITS) * _MM


# ----------------------------------------------------------------------------------------------------------------------
# The lightest bearings with which a shaft passes its checks.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 6
"""How often places follow from the widths of the bearings that are chosen, at most [-]."""
ALIKE = 1e-6
"""Of what two shafts lack of their limits, what counts as none [-]."""
WIDER = 1.3
"""Room for a bearing over the width of one that was refused there [-]."""


class Stood(NamedTuple):
    """A shaft in bearings."""

    line: Line
    option: BearingPair
    plan: ShaftPlan
    built: Built
    failing: tuple[Check, ...]
    mass: float
    """Of shaft and bearings [kg]."""
    weak: tuple[str, ...] = ()
    """Bearings that lack life or metal beside them, which a larger bore gives."""

    @property
    def lacking(self) -> float:
        """What its checks lack of their limits together [-]; more than nothing where any fails."""
        return lacking_of(self.failing) + ALIKE * len(self.failing)

    @property
    def thin(self) -> dict[str, float]:
        """Bearing that is to have a larger bore -> the bore that it has [m]."""
        return {bearing.name: bearing.bearing.bore for bearing in self.built.bearings if bearing.name in self.weak}

    @property
    def ends(self) -> dict[str, str]:
        """Bearing -> the end of what the shaft carries at which it stands; none where all stand at one."""
        if self.line.core.first == self.line.core.last:
            return {}
        middle = sum(self.plan.bearings) / 2.0
        return {name: FIRST if seat.position < middle else SECOND for name, seat in self.plan.seats.items()}


def stood(sizing: Sizing, context: Context, line: Line, axes: Mapping[str, complex]) -> Stood:
    """Return a shaft in the lightest of the bearings with which its checks lack least.

    Args:
        sizing: Without these bearings.
        context: What sizing reads.
        line: The shaft.
        axes: Where all axes stand, y + i z [m].

    Raises:
        DesignError: If none can be had.
    """
    tried, refused = list[Stood](), list[DesignError]()
    for bore in _bores(context.design, line.name):
        for option in OPTIONS:
            if option.axial_end in line.no_axial:
                continue
            try:
                tried.append(_with(sizing, context, replace(line, bore=bore), option, axes))
            except DesignError as error:
                refused.append(error)
        if any(not one.failing for one in tried):
            break
    if not tried:
        raise min(refused, key=lambda error: len(error.problems))
    return _best(tried)


def _bores(design: Design, shaft: str) -> tuple[float | None, ...]:
    """Return the bores over their diameter that a shaft may have [-]; None: as the design gives it."""
    layout = design.layout.get(shaft, NOTHING_GIVEN)
    is_open = layout.bore is None and layout.bore_ratio is None and "bore_ratio" not in design.shafting.model_fields_set
    return BORES if is_open else (None,)


def _with(sizing: Sizing, context: Context, line: Line, option: BearingPair, axes: Mapping[str, complex]) -> Stood:
    """Return a shaft in bearings of some kinds, which stand as their widths ask for: the best that is found."""
    widths, bores, held = dict[str, float](), dict[str, float](), dict[str, float]()
    fitting, last = list[Stood](), None
    factor = context.design.service.application_factor
    for _ in range(ROUNDS):
        try:
            last = _built(sizing, context, line, option, plan_with(line, option, widths, bores, held), axes)
        except DesignError:
            if last is None and not bores:
                raise
            bores = {name: bore + BORE_STEP for name, bore in bores.items()}
            widths = {name: WIDER * width for name, width in widths.items()}
            continue
        bearings = last.built.bearings
        now = {bearing.name: bearing.bearing.width + line.slack for bearing in bearings}
        thin = {bearing.name: line.thinnest for bearing in bearings if bearing.bearing.bore < line.thinnest}
        if widths and not thin and all(now[name] < widths[name] + _MM / 2.0 for name in now):
            fitting.append(last)
            thin = {name: bore + BORE_STEP for name, bore in last.thin.items()}
            stays = all(now[name] > widths[name] - _MM / 2.0 for name in now)
            if stays and all(bores.get(name, 0.0) > bore - _MM for name, bore in thin.items()):
                break
        widths, bores = now, {**bores, **thin}
        pull = factor * max(abs(bearing.axial) for bearing in bearings)
        held = {bearing.name: holding_room(bearing.bearing.bore, pull) for bearing in bearings}
    assert last is not None
    return _best(fitting or [last])


def _best(tried: Sequence[Stood]) -> Stood:
    """Return the lightest of those that lack least."""
    least = smallest(tried, lambda one: one.lacking).lacking
    return smallest([one for one in tried if one.lacking <= least + ALIKE], lambda one: one.mass)


def _built(
    sizing: Sizing, context: Context, line: Line, option: BearingPair, plan: ShaftPlan, axes: Mapping[str, complex]
) -> Stood:
    """Return a shaft with its bearings at given places."""
    gears, design = {gear.name: gear for gear in sizing.gears}, context.design
    layout = design.layout.get(line.name, NOTHING_GIVEN)
    layout = layout if line.bore is None else layout.model_copy(update={"bore_ratio": line.bore})
    changed = {
        "bearings": {**design.bearings, **plan.seats},
        "layout": {**design.layout, line.name: layout},
        "joints": {**splines_of(line), **design.joints},
    }
    own = replace(context, design=design.model_copy(update=changed))
    forces = shaft_forces(own, line.name, plan, axes=axes, gears=gears)
    built = build_shaft(own, line.name, forces, shaft_material(own), gears=gears, core=None)
    arrangement = replace(sizing.arrangement, plans={**sizing.arrangement.plans, line.name: plan}, axes=axes)
    alone = replace(
        sizing, design=own.design, arrangement=arrangement, built_shafts=(built.shaft,), bearings=built.bearings,
        joints=built.joints,
    )  # fmt: skip
    weak = dict(_weak_seats(alone))
    failing = [check for check in (*built_checks(built, own.design), *retention_checks(alone)) if check.fails]
    return Stood(line, option, plan, built, (*failing, *weak.values()), _mass(own, built), tuple(weak))


def _weak_seats(alone: Sizing) -> Iterator[tuple[str, Check]]:
    """Yield the bearings of one shaft that lack what a larger bore gives, life or metal beside them, and the check.

    A taper bearing whose load acts at its pressure centre lives shorter; a ring's groove beside a bearing weakens its
    shaft.
    """
    for check in pressure_centre_checks(alone):
        if check.fails:
            yield check.part.name, check
    weak = [check for check in groove_checks(alone) if check.fails]
    places = [one.position for one in groove_strengths(alone)] if weak else []
    for held in ends(alone):
        if held.has_ring and any(abs(place - held.place) < held.room for place in places):
            yield from ((held.outermost, check) for check in weak)


def splines_of(line: Line) -> dict[str, Joint]:
    """Return gear -> spline that joins it to a shaft.

    Args:
        line: The shaft.
    """
    return {name: Joint(kind="spline") for name in line.splined}


def _mass(context: Context, built: Built) -> float:
    density, shaft = shaft_material(context).density, built.shaft
    steps = sum(shaft_mass(step.diameter, step.end - step.start, density, bore=shaft.bore) for step in shaft.steps)
    return steps + sum(bearing.bearing.mass for bearing in built.bearings)


def stand(sizing: Sizing, lines: Sequence[Line], axes: Mapping[str, complex]) -> tuple[Stood, ...]:
    """Return all shafts in bearings, loaded as their axes stand; equal branches in those of the heaviest of them.

    Args:
        sizing: Without these bearings.
        lines: The shafts.
        axes: Where all axes stand, y + i z [m].

    Raises:
        DesignError: For every shaft that finds no bearings.
    """
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    shafts, problems = list[Stood](), list[Problem]()
    for line in lines:
        try:
            shafts.append(stood(sizing, context, line, axes))
        except DesignError as error:
            problems += error.problems
    refuse(problems)
    branches = dict[tuple[str, ...], list[Stood]]()
    for one in shafts:
        branches.setdefault(tuple(item.name for item in one.line.items), []).append(one)
    found = list[Stood]()
    for one in shafts:
        pattern = largest(branches[tuple(item.name for item in one.line.items)], lambda branch: branch.mass)
        found.append(one if pattern is one else _like(sizing, context, one, pattern, axes))
    return tuple(found)


def _like(sizing: Sizing, context: Context, one: Stood, pattern: Stood, axes: Mapping[str, complex]) -> Stood:
    """Return a shaft in the bearings of another branch, at the same places; as it is where they do not do."""
    name, taken = one.line.name, {bearing.name: bearing.bearing.designation for bearing in pattern.built.bearings}
    alike = {f"{pattern.line.name}-{place}": f"{name}-{place}" for place in (*ENDS, "axial")}
    seats = {
        alike[seat]: own.model_copy(update={"shaft": name, "designation": taken[seat]})
        for seat, own in pattern.plan.seats.items()
    }
    line = replace(one.line, bore=pattern.line.bore)
    try:
        like = _built(sizing, context, line, pattern.option, replace(pattern.plan, seats=seats), axes)
    except DesignError:
        return one
    return one if len(like.failing) > len(one.failing) else like


def splined(gears: Sequence[GearSizing]) -> tuple[str, ...]:
    """Return the gears that splines join to a shaft: all but one that is of one piece with it, so that bearings go on.

    That is the smallest pinion, or where there is none a ring's bell or the sun.

    Args:
        gears: On the shaft.
    """
    for role in (Role.PINION, Role.RING, Role.SUN):
        if own := [gear for gear in gears if gear.role is role]:
            solid = smallest(own, lambda gear: gear.pitch_diameter).name
            return tuple(gear.name for gear in gears if gear.name != solid and gear.role is not Role.RING)
    return tuple(gear.name for gear in gears)
