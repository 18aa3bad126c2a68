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

from gearwright.base import SIDES, Check, DesignError, Kind, Problem, Role, carrier_part, refuse, smallest, verb
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
PARALLEL = 1e-6
"""How far the cosine of two directions of one axis may differ from 1 [-]."""

# ----------------------------------------------------------------------------------------------------------------------
# What stands on a shaft, how much of its axis each thing takes, and between which of them bearings go.
# ----------------------------------------------------------------------------------------------------------------------


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
    """``gear`` of a pair, ``set``, ``machine``, ``airscrew``, or ``link``: a clutch, brake or damper."""
    inside: float = 0.0
    """How far its shaft goes on beyond its place where it ends there: a sun's as far as its teeth [m]."""


def items_on(sizing: Sizing, shaft: str) -> tuple[Item, ...]:
    """Return what stands on a shaft, in order along it.

    Args:
        sizing: Without bearings of that shaft.
        shaft: Its name.
    """
    plan, design = sizing.arrangement.plans[shaft], sizing.design
    pairs = {gear.name: gear for gear in sizing.gears if gear.role in SIDES and gear.stage in design.pairs}
    sets = {gear.name: gear.stage for gear in sizing.gears if gear.stage in design.sets}
    sets |= {str(carrier_part(stage)): stage for stage in design.sets}
    suns = {gear.name: gear.face_width / 2.0 for gear in sizing.gears if gear.role is Role.SUN}
    found = []
    for name, place in plan.places.items():
        if name in pairs:
            found.append(Item(name, place, *_taken(sizing, shaft, place, pairs[name]), "gear"))
        elif name in sets:
            middle = _middle(sizing, shaft, name, sets[name])
            found.append(Item(name, middle, *_taken(sizing, shaft, middle, sets[name]), "set", suns.get(name, 0.0)))
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
    ends = [end for body in sizing.arrangement.bodies if any(_is_of(body, gear) for gear in own)
            for end in _ends(sizing, shaft, body)]  # fmt: skip
    return (min(ends) + max(ends)) / 2.0


def _is_of(body: Body, gear: GearSizing) -> bool:
    return body.part.kind is Kind.GEAR and body.part.name == gear.stage and body.part.role is gear.role


def _ends(sizing: Sizing, shaft: str, body: Body) -> tuple[float, float]:
    """Return where a body begins and ends along a shaft, from its first end [m]."""
    frame = sizing.arrangement.frames[shaft]
    along = np.asarray(frame.along)
    start = float((np.asarray(body.origin) - np.asarray(frame.origin)) @ along)
    return start, start + float(np.asarray(body.direction) @ along) * body.length


def _taken(sizing: Sizing, shaft: str, place: float, what: GearSizing | str) -> tuple[float, float]:
    """Return how far a gear on a shaft, or all of a set around it, reaches before and behind a place [m]."""
    along = np.asarray(sizing.arrangement.frames[shaft].along)
    ends = [place]
    for body in sizing.arrangement.bodies:
        own = body.part.name == what if isinstance(what, str) else _is_of(body, what) and body.shaft == shaft
        if own and abs(abs(float(np.asarray(body.direction) @ along)) - 1.0) < PARALLEL:
            ends += _ends(sizing, shaft, body)
    return place - min(ends), max(ends) - place


STANDING = ("gear", "set")
"""Kinds of items that are wider than the shaft."""
COUPLED = ("machine", "link")
"""Kinds of items that a hub joins to a shaft."""


class Core(NamedTuple):
    """Which of the items on a shaft stand between its bearings."""

    first: int
    last: int
    """Behind the last of them; the same as `first` where both bearings stand side by side there."""


def core_of(items: Sequence[Item], *, floats: bool) -> Core | None:
    """Return what of the items on a shaft stands between its bearings; None where it needs none.

    Gears of pairs stand between bearings; a propeller or rotor, and a machine beside a planetary set, overhang them. A
    shaft that joins sets alone, or the sun of one to a machine's coupling, is held by the planets around it.

    Args:
        items: In order.
        floats: Whether the design lets it float.
    """
    gears = [k for k, item in enumerate(items) if item.kind == "gear"]
    if gears:
        return None if floats else Core(gears[0], gears[-1] + 1)
    screws = [k for k, item in enumerate(items) if item.kind == "airscrew"]
    if screws:
        return Core(screws[0], screws[0]) if screws[0] else Core(1, 1)
    held = [k for k, item in enumerate(items) if item.kind == "set" and not item.name.endswith(".sun")]
    machines = [k for k, item in enumerate(items) if item.kind in COUPLED]
    if not held or not machines:
        return None
    middle = [k for k in machines if 0 < k < len(items) - 1]
    if middle:
        return Core(middle[0], middle[-1] + 1)
    return Core(1, 1) if machines[0] == 0 else Core(machines[0], machines[0])


# ----------------------------------------------------------------------------------------------------------------------
# Kinds of bearings for a shaft, and how long it is with them.
# ----------------------------------------------------------------------------------------------------------------------


ENDS = ("first", "second")
"""Of what stands between the bearings of a shaft."""


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
    Option(("cylindrical", "none"), ("cylindrical", "none"), "first"),
    Option(("cylindrical", "none"), ("cylindrical", "none"), "second"),
)
"""Arrangements of locating and floating bearings that are tried for every shaft."""
GUESS = 60e-3
"""Width of a bearing before one is chosen [m]."""
BESIDE = 2e-3
"""Between two bearings side by side [m]."""
GAP = 3e-3
"""Between a bearing and what its shaft carries between both, at least [m]."""
COVER = 10e-3
"""Between a bearing and what stands beyond it: a cover with its screws, and room for what turns [m]."""
SHOULDER = 0.1
"""Shoulder of a seat and gap together over the diameter of the shaft [-]: 0.08 d and 0.02 d."""
END = 5e-3
"""Of the shaft beyond its last bearing, for what holds the ring [m]."""
BORES = (0.6, 0.4, 0.0)
"""Bore over the diameter of a shaft whose bore is open, the first with which there is room for it [-]: 0.6 costs a
seventh of the strength and saves a third of the mass."""
LEAST_SEAT = 0.7
"""Bore of a bearing over the diameter that its shaft asks for, at least, also where it carries no torque [-]."""
BORE_STEP = 5e-3
"""Of the bores of bearings [m]."""
HUB = 1.0
"""Hub of a coupling over the diameter of the shaft [-], an estimate."""
SEAL = 12e-3
"""Room for a seal and its cover [m]."""
OVERHANG = 2.5
"""From the last bearing to the plane of a propeller over the diameter that its torque alone asks for [-]."""
SPAN_OF_WHEEL = 0.25
"""Span of bearings over the pitch diameter of the largest gear between them, at least [-]: it tilts."""
SPANS = {"gear": 1.0 / 0.6, "airscrew": 1.25}
"""What overhangs its bearings -> their span over that overhang, at least [-]."""
SLACK = ((0.0, 0.0), (2e-3, 5e-3), (6e-3, 10e-3))
"""More room for a bearing than its width, and a thicker seat where the end of a shaft carries little, for axes that
turn with longer shafts and load others [m]."""
PLACINGS = 5
"""How often room is made for what stands into something else, at most [-]."""
ROUNDS = 6
"""How often places follow from the widths of the bearings that are chosen, at most [-]."""


@dataclass(frozen=True)
class Line:
    """A shaft that is to stand in bearings."""

    name: str
    items: tuple[Item, ...]
    core: Core
    thick: float
    """Its diameter by torque and bending as first sized [m]."""
    wheel: float
    """Pitch diameter of the largest gear of a pair on it [m]."""
    bore: float | None = None
    """Over its diameter [-]; None: as the design gives it."""
    slack: float = 0.0
    """By which more than the width of a bearing is left for it [m]."""
    @property
    def machine_end(self) -> str:
        """End at which a machine stands that may stand at the other as well; empty: none, or beside a set."""
        kinds = [item.kind for item in self.items]
        if "set" in kinds or kinds.count("machine") != 1:
            return ""
        return "first" if kinds[0] == "machine" else "second" if kinds[-1] == "machine" else ""

    apart: Mapping[str, float] = field(default_factory=dict)
    """Bearing -> how much farther it stands from what is beside it [m]."""
    no_axial: frozenset[str] = frozenset()
    """Ends at which there is no room for one more bearing."""
    thicker: float = 0.0
    """By which the thinnest seat is thicker [m]."""


def plan_with(line: Line, option: Option, widths: Mapping[str, float], bores: Mapping[str, float]) -> ShaftPlan:
    """Return a shaft with bearings: its length, and where everything on it stands, in whole millimetres.

    Args:
        line: The shaft.
        option: Kinds of its bearings.
        widths: Bearing -> its width, of those that are chosen [m].
        bores: Bearing -> its bore, of those that would be thinner than a shaft is made [m].
    """
    names = [f"{line.name}-first", f"{line.name}-second"]
    before, after = [names[0]], [names[1]]
    if option.axial_end == "first":
        before = [f"{line.name}-axial", *before]
    elif option.axial_end:
        after = [*after, f"{line.name}-axial"]
    bearings = {
        name: Item(name, 0.0, *(2 * (widths.get(name, GUESS) / 2.0 + line.apart.get(name, 0.0),)), "bearing")
        for name in (*before, *after)
    }
    row = [*line.items[: line.core.first], *(bearings[name] for name in before),
           *line.items[line.core.first : line.core.last],
           *(bearings[name] for name in after), *line.items[line.core.last :]]  # fmt: skip
    steps = [_step(line, one, other) for one, other in pairwise(row)]
    for k, (one, other) in enumerate(pairwise(row)):
        beyond = (one.name in after and other.kind in STANDING) or (other.name in before and one.kind in STANDING)
        steps[k] += (COVER - GAP) * beyond
    _spread(line, row, steps, names)
    places, reached = {}, _beyond(line, row[0], row[0].before)
    for k, item in enumerate(row):
        places[item.name] = reached
        reached += steps[k] if k < len(steps) else _beyond(line, item, item.after)
    kinds = dict(zip(names, (option.first, option.second), strict=True))
    seats = {
        name: BearingSeat.model_construct(
            shaft=line.name, position=places[name], kind=kinds.get(name, ("four-point", "both"))[0],
            locates=kinds.get(name, ("four-point", "both"))[1], radial=name in kinds, designation=None,
            bore=bores.get(name), dynamic_rating=None, static_rating=None, largest_outer_diameter=None, life=None,
        )
        for name in bearings
    }  # fmt: skip
    seats = dict(sorted(seats.items(), key=lambda seat: seat[1].position))
    own = {item.name: places[item.name] for item in line.items}
    return ShaftPlan(reached, (places[names[0]], places[names[1]]), own, seats)


def _step(line: Line, one: Item, other: Item) -> float:
    """Return how far two neighbours stand from each other [m]."""
    if one.kind == other.kind == "gear":
        return other.place - one.place
    kinds = {one.kind, other.kind}
    far = one.after + other.before
    if kinds == {"bearing"}:
        return _up(far + BESIDE)
    if "airscrew" in kinds:
        return _up(max(far + SEAL + HUB * line.thick, OVERHANG * line.thick))
    if not kinds.isdisjoint(COUPLED):
        return _up(far + SEAL + HUB * line.thick / 2.0)
    return _up(far + max(GAP, SHOULDER * line.thick))


def _spread(line: Line, row: Sequence[Item], steps: list[float], names: Sequence[str]) -> None:
    """Move both bearings apart as far as wheels between them, and what overhangs them, ask for."""
    first, second = (next(k for k, item in enumerate(row) if item.name == name) for name in names)
    asked = [SPAN_OF_WHEEL * line.wheel]
    for k, item in enumerate(row):
        if item.kind in SPANS and not first < k < second:
            asked.append(SPANS[item.kind] * (sum(steps[k:first]) if k < first else sum(steps[second:k])))
    lacking = max(asked) - sum(steps[first:second])
    if lacking <= 0.0:
        return
    if second == first + 1:
        steps[first] = _up(steps[first] + lacking)
    else:
        steps[first], steps[second - 1] = _up(steps[first] + lacking / 2.0), _up(steps[second - 1] + lacking / 2.0)


def _beyond(line: Line, item: Item, half: float) -> float:
    """Return how far a shaft goes on beyond the middle of what stands at its end [m]."""
    if item.kind in ("set", "link"):
        return item.inside
    if item.kind in (*COUPLED, "airscrew"):
        return _up(HUB * line.thick / 2.0)
    return _up(half + (END if item.kind == "bearing" else 0.0))


def _up(length: float) -> float:
    """Return a length in whole millimetres, rounded up [m]."""
    return math.ceil(length / _MM - 1e-6) * _MM


# ----------------------------------------------------------------------------------------------------------------------
# The lightest of the kinds that a shaft passes its checks with.
# ----------------------------------------------------------------------------------------------------------------------


class Stood(NamedTuple):
    """A shaft in bearings."""

    line: Line
    option: Option
    plan: ShaftPlan
    built: Built
    failing: tuple[Check, ...]

    @property
    def ends(self) -> dict[str, str]:
        """Bearing -> the end of what the shaft carries at which it stands; none where all stand at one."""
        if self.line.core.first == self.line.core.last:
            return {}
        middle = sum(self.plan.bearings) / 2.0
        return {name: "first" if seat.position < middle else "second" for name, seat in self.plan.seats.items()}

    mass: float
    """Of shaft and bearings [kg]."""


def stood(sizing: Sizing, context: Context, line: Line) -> Stood:
    """Return a shaft in the lightest of the bearings with which the fewest of its checks fail.

    Args:
        sizing: Of the gearbox, without them.
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
        raise DesignError(dict.fromkeys(problem for error in refused for problem in error.problems))
    fewest = min(len(one.failing) for one in tried)
    return smallest([one for one in tried if len(one.failing) == fewest], lambda one: one.mass)


def _bores(design: Design, shaft: str) -> tuple[float | None, ...]:
    """Return the bores over their diameter that a shaft may have [-]; None: as the design gives it."""
    layout = design.layout.get(shaft, NOTHING_GIVEN)
    is_open = layout.bore is None and layout.bore_ratio is None and "bore_ratio" not in design.shafting.model_fields_set
    return BORES if is_open else (None,)


def _with(sizing: Sizing, context: Context, line: Line, option: Option) -> Stood:
    gears = {gear.name: gear for gear in sizing.gears}
    widths, bores, found = dict[str, float](), dict[str, float](), None
    for _ in range(ROUNDS):
        plan = plan_with(line, option, widths, bores)
        own = replace(context, design=_in_bearings(context.design, sizing, line, plan))
        forces = shaft_forces(own, line.name, plan, axes=sizing.arrangement.axes, gears=gears)
        try:
            built = build_shaft(own, line.name, forces, shaft_material(own), gears=gears, core=None)
        except DesignError:
            if found is None and not bores:
                raise
            bores = {name: bore + BORE_STEP for name, bore in bores.items()}
            widths = {name: width * 1.3 for name, width in widths.items()}
            continue
        failing = tuple(check for check in built_checks(built, own.design) if check.fails)
        found = Stood(line, option, plan, built, failing, _mass(own, built))
        now = {bearing.name: bearing.bearing.width + line.slack for bearing in built.bearings}
        thin = {bearing.name: _thinnest(line) for bearing in built.bearings if bearing.bearing.bore < _thinnest(line)}
        if widths and not thin and all(abs(now[name] - widths[name]) < _MM / 2.0 for name in now):
            break
        widths, bores = now, {**bores, **thin}
    assert found is not None
    return found


def _thinnest(line: Line) -> float:
    """Return the bore that a bearing of a shaft has at least: of a standard that is no thinner than usual [m]."""
    return math.ceil(LEAST_SEAT * line.thick / BORE_STEP - 1e-6) * BORE_STEP + line.thicker


def _in_bearings(design: Design, sizing: Sizing, line: Line, plan: ShaftPlan) -> Design:
    """Return a design with the bearings of a shaft, a bore where none is given, and splines in its wheels."""
    layout = design.layout.get(line.name, NOTHING_GIVEN)
    if line.bore is not None:
        layout = layout.model_copy(update={"bore_ratio": line.bore})
    return design.model_copy(update={
        "bearings": {**design.bearings, **plan.seats},
        "layout": {**design.layout, line.name: layout},
        "joints": {**{name: Joint(kind="spline") for name in _splined(sizing, line)}, **design.joints},
    })  # fmt: skip


def _splined(sizing: Sizing, line: Line) -> tuple[str, ...]:
    """Return the gears that splines join to a shaft: all but one, its smallest pinion, or a sun where it has none."""
    gears = {gear.name: gear for gear in sizing.gears}
    every = [gears[item.name] for item in line.items if item.name in gears]
    own = [gear for gear in every if gear.role is not Role.RING]
    pinions = [gear for gear in own if gear.role is Role.PINION]
    if not pinions and len(own) == len(every):
        pinions = [gear for gear in own if gear.role is Role.SUN]
    solid = smallest(pinions, lambda gear: gear.pitch_diameter).name if pinions else ""
    return tuple(gear.name for gear in own if gear.name != solid)


def _mass(context: Context, built: Built) -> float:
    steel, shaft = shaft_material(context).density, built.shaft
    metal = sum(
        math.pi / 4.0 * (step.diameter**2 - shaft.bore**2) * (step.end - step.start) * steel for step in shaft.steps
    )
    return metal + sum(bearing.bearing.mass for bearing in built.bearings)


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a design without bearings becomes one whose shafts stand in them.
# ----------------------------------------------------------------------------------------------------------------------


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
    tried: frozenset[str] = frozenset()
    """For what room was made before."""

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
    wider: dict[str, float] = {}
    tried = list[tuple[int, Arranged]]()
    for _ in range(PLACINGS):
        found = _placed(own, sized, context, wider)
        arranged = Arranged(before, *found, frozenset(wider))
        lacking = _lacking(arranged)
        tried.append((len(arranged.worse), arranged))
        if not lacking:
            break
        wider = {name: wider.get(name, 0.0) + lacking.get(name, 0.0) for name in {**wider, **lacking}}
    return min(tried, key=lambda one: one[0])[1]


def _placed(
    own: Design, sized: Sizing, context: Context, wider: Mapping[str, float]
) -> tuple[Design, Sizing, tuple[Stood, ...]]:
    """Return a design with bearings, with more room around some sets and bearings than they take."""
    refused: DesignError | None = None
    for slack, thicker in SLACK:
        lines = [replace(line, slack=slack, thicker=thicker) for line in _lines(sized, wider)]
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


def _stand(sizing: Sizing, context: Context, lines: Sequence[Line]) -> tuple[Stood, ...]:
    """Return all shafts in bearings, loaded as their axes stand in a sizing."""
    shafts, problems = list[Stood](), list[Problem]()
    for line in lines:
        try:
            shafts.append(stood(sizing, context, line))
        except DesignError as error:
            problems += error.problems
    refuse(problems)
    return tuple(shafts)


def _lacking(arranged: Arranged) -> dict[str, float]:
    """Return what keeps parts out of each other: set -> more room along its shaft [m], shaft and what it does -> 1.

    A bearing for which there is no room at one end of what its shaft carries goes to the other, and where a machine
    stands at that end, that goes there, too.
    """
    found = dict[str, float]()
    planned = {bearing.name: bearing.bearing.width for one in arranged.shafts for bearing in one.built.bearings}
    for bearing in arranged.sizing.bearings:
        wider = bearing.bearing.width - planned.get(bearing.name, math.inf)
        if wider > _MM / 2.0:
            found[bearing.name] = _up(wider / 2.0)
    for check in arranged.worse:
        if not check.mode.startswith("room") or check.value is None or check.limit is None:
            continue
        words = {str(check.part), *check.place.replace(",", " ").split(), *check.mode.split()}
        into = [stage for stage in arranged.design.sets if any(word.split(".")[0] == stage for word in words)]
        if into:
            found |= {stage: max(found.get(stage, 0.0), _up(check.limit - check.value) + _MM) for stage in into}
            continue
        names = set(check.place.replace(",", " ").split())
        for one in arranged.shafts:
            ends = [end for name, end in one.ends.items() if name in names]
            if one.line.name in names and (end := _end_of(one, check.why)):
                found[f"{one.line.name} {'mirrored' if end == one.line.machine_end else end}"] = 1.0
            elif f"{one.line.name}-axial" in names and ends:
                found[f"{one.line.name} axial {ends[0]}"] = 1.0
            elif ends and ends[0] == one.line.machine_end:
                found[f"{one.line.name} mirrored"] = 1.0
            elif ends:
                found[f"{one.line.name} {ends[0]}"] = 1.0
            else:
                continue
            seat = next((name for name in one.ends if name in names), "")
            if seat and seat not in arranged.tried:
                found = {key: far for key, far in found.items() if not key.startswith(f"{one.line.name} ")}
                found[seat] = _up(check.limit - check.value) + _MM
            break
    return found


def _end_of(one: Stood, why: str) -> str:
    """Return at which end of a shaft the stretch is that a check tells of; empty where it tells of none."""
    found = re.search(rf"\b{re.escape(one.line.name)} ([\d.]+) to ([\d.]+) mm", why)
    if found is None:
        return ""
    return "first" if sum(map(float, found.groups())) * _MM < one.plan.length else "second"



def _lines(sizing: Sizing, wider: Mapping[str, float]) -> Iterator[Line]:
    """Yield the shafts that need bearings and have none."""
    design, gears = sizing.design, {gear.name: gear for gear in sizing.gears}
    seated = {seat.shaft for seat in design.bearings.values()}
    for shaft in sizing.shafts:
        if shaft.name in seated:
            continue
        items = tuple(_widened(item, wider) for item in items_on(sizing, shaft.name))
        if f"{shaft.name} mirrored" in wider:
            items = tuple(item._replace(place=-item.place, before=item.after, after=item.before) for item in items[::-1])
        core = core_of(items, floats=_floats(sizing, items))
        if core is not None:
            core = _beside(core, {end for end in ENDS if f"{shaft.name} {end}" in wider})
            wheel = max((gears[item.name].pitch_diameter for item in items if item.kind == "gear"), default=0.0)
            full = frozenset(end for end in ENDS if f"{shaft.name} axial {end}" in wider)
            apart = {name: far for name, far in wider.items() if name.startswith(f"{shaft.name}-")}
            yield Line(shaft.name, items, core, shaft.diameter, wheel, apart=apart, no_axial=full)


def _beside(core: Core, blocked: set[str]) -> Core:
    """Return where bearings stand if there is no room for them at one end: what is outermost there overhangs them."""
    first = core.first + ("first" in blocked)
    return Core(first, max(core.last - ("second" in blocked), first))


def _widened(item: Item, wider: Mapping[str, float]) -> Item:
    more = next((far for stage, far in wider.items() if item.kind == "set" and item.name.split(".")[0] == stage), 0.0)
    return item._replace(before=item.before + more, after=item.after + more)


def _floats(sizing: Sizing, items: Sequence[Item]) -> bool:
    """Tell whether all gears on a shaft drive face gears, between which it floats."""
    gears: dict[str, GearSizing] = {gear.name: gear for gear in sizing.gears}
    own = [gears[item.name] for item in items if item.kind == "gear"]
    return bool(own) and all(
        sizing.design.pairs[gear.stage].kind == "face" and gear.role is SIDES[0] for gear in own
    )


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
        seats = {name: seat.model_copy(update={"designation": taken[name], "bore": None}) for name, seat in seats.items()}
    yield "bearings", {
        name: {key: value for key, value in seat.model_dump().items() if value is not None}
        for name, seat in {**design.bearings, **seats}.items()
    }
    if not as_given:
        joints = {**{name: Joint(kind="spline") for one in shafts for name in _splined(sizing, one.line)}, **design.joints}
        yield "joints", {name: own.model_dump(exclude_none=True, exclude_defaults=True) for name, own in joints.items()}
    plans = {one.line.name: one.plan for one in shafts}
    axis = shared_axes(design)
    beside = {axis[name] for name in plans}
    plans |= {
        name: plan for name, plan in sizing.arrangement.plans.items() if name not in plans and axis[name] in beside
    }
    layout = dict(design.layout)
    for name, plan in plans.items():
        kept = layout.get(name, NOTHING_GIVEN)
        places = {label: Place(position=at) for label, at in plan.places.items()}
        layout[name] = kept.model_copy(update={"length": plan.length, "places": places})
    for one in shafts:
        own: dict[str, Any] = {"diameter": None} | ({} if one.line.bore is None else {"bore_ratio": one.line.bore})
        if as_given:
            own |= {"as_given": True, "diameter": max(bearing.bearing.bore for bearing in one.built.bearings)}
        layout[one.line.name] = layout[one.line.name].model_copy(update=own)
    yield "layout", {name: own.model_dump(exclude_none=True, exclude_defaults=True) for name, own in layout.items()}
