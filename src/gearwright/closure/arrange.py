"""The verb that puts shafts into bearings: all shafts of a gearbox, and room for what stands into something else."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from gearwright.base import Check, DesignError, Shown, lacking_of, verb
from gearwright.closure.proportion import sized_as, teeth_of
from gearwright.sizing import Sizing, size
from gearwright.sizing.arrangement import shared_axes
from gearwright.sizing.bearing_arrangement import (
    BORE_STEP,
    ENDS,
    FIRST,
    SECOND,
    Core,
    Item,
    Line,
    Stood,
    bare_shafts,
    core_of,
    items_on,
    splined,
    splines_of,
    stand,
)
from gearwright.sizing.making import boss_room, built_checks
from gearwright.sizing.mass import CompleteMass, bevel_cones, complete_mass
from gearwright.sizing.result import ShaftPlan
from gearwright.sizing.shafts.stretches import whole_millimetres
from gearwright.spec import Design, design_text, edited
from gearwright.spec.design import BUILT, NOTHING_GIVEN, module_owners
from gearwright.spec.design.stages import Place
from gearwright.spec.edit import Value, implied

_MM = 1e-3

# ----------------------------------------------------------------------------------------------------------------------
# All shafts of a gearbox, and room for those that stand into something else.
# ----------------------------------------------------------------------------------------------------------------------


SLACK = ((0.0, 0.0), (2e-3, 5e-3), (6e-3, 10e-3))
"""More room for a bearing than its width, and a thicker seat where the end of a shaft carries little, for axes that
turn with longer shafts and load others [m]."""
CROWDED = ("room", "running clearance")
"""How checks begin of parts that stand too near to each other."""
NEAR = 10e-3
"""Room that a bearing lacks up to which it is moved away; beyond, something else is done [m]."""
WHIRLS, TOO_FAST = "first critical speed", "speed factor"
"""Modes of checks of a shaft that is too soft for its speed, and of a bearing whose n d_m is too much."""
UNDER_RACE = "under-race"
"""How oil comes to fast bearings: through the shaft, to 3e6 mm/min where jets end at 1.5e6."""
PLACINGS = 8
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
    thicker: Mapping[str, float] = field(default_factory=dict)
    """Shaft -> by how much its thinnest seat is thicker, so that it turns below its first critical speed [m]."""
    under_race: bool = False
    """Whether oil comes to the bearings through the shafts, as their n d_m is more than jets of oil allow."""

    def with_around(self, stage: str, more: float) -> Room:
        """Return it with so much room around a set, where it has less."""
        return replace(self, around={**self.around, stage: max(self.around.get(stage, 0.0), more)})

    def with_beside(self, bearing: str, lacking: float) -> Room:
        """Return it with more room beside a bearing."""
        return replace(self, beside={**self.beside, bearing: self.beside.get(bearing, 0.0) + lacking})

    def with_thicker(self, shaft: str) -> Room:
        """Return it with the next bore in the bearings of a shaft."""
        return replace(self, thicker={**self.thicker, shaft: self.thicker.get(shaft, 0.0) + BORE_STEP})


@dataclass(frozen=True, repr=False)
class Arranged(Shown):
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
        """Checks that fail and did not before, of what holds parts and puts them together, too."""
        known = {check.name for check in self.before.checks if check.fails}
        checks = (*self.sizing.checks, *built_checks(self.sizing))
        return tuple(check for check in checks if check.fails and check.name not in known)

    @property
    def lacking(self) -> float:
        """What these checks lack of their limits together [-]."""
        return lacking_of(self.worse)

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
    chosen = [*teeth_of(design, before), *sized_as(design, before), *_bevel_sizes(design, before)]
    own = edited(design, dict(chosen))
    sized = size(own)
    room, best = Room(), None
    for _ in range(PLACINGS):
        try:
            arranged = Arranged(before, *_placed(own, sized, room))
        except DesignError:
            if best is None:
                raise
            break
        if best is None or arranged.lacking < best.lacking:
            best = arranged
        more = _more_room(arranged, room)
        if more == room:
            break
        room = more
    assert best is not None
    return best


def arranged_where_needed(sizing: Sizing, design: Design) -> tuple[Arranged | None, str]:
    """Return a design in bearings, and which shafts that need some find none, and why.

    Args:
        sizing: Whose shafts need bearings, or not.
        design: That is put into them.

    Returns:
        None and no words where no shaft needs any.
    """
    if not (bare := bare_shafts(sizing)):
        return None, ""
    try:
        return arrange(design), ""
    except DesignError as error:
        why = "; ".join(f"{problem.path}: {problem.message}" for problem in error.problems)
        return None, f"{', '.join(bare)} ({why})"


def _placed(own: Design, sized: Sizing, room: Room) -> tuple[Design, Sizing, tuple[Stood, ...]]:
    """Return a design with bearings, its sizing and its shafts."""
    refused: DesignError | None = None
    if room.under_race and own.bearing_rules.lubrication != UNDER_RACE:
        own = edited(own, {"bearing_rules.lubrication": UNDER_RACE})
        sized = size(own)
    for slack, thicker in SLACK:
        lines = [replace(line, slack=slack, thicker=line.thicker + thicker) for line in _lines(sized, room)]
        shafts = stand(sized, lines, sized.arrangement.axes)
        try:
            turned = size(edited(own, dict(_changes(own, sized, shafts, as_given=True))))
        except DesignError:  # it tells where axes stand; without it they are taken as they stood
            turned = sized
        if turned.arrangement.axes != sized.arrangement.axes:
            shafts = stand(sized, lines, turned.arrangement.axes)
        arranged = edited(own, dict(_changes(own, sized, shafts)))
        try:
            return arranged, size(arranged), shafts
        except DesignError as error:
            refused = refused or error
    assert refused is not None
    raise refused


def _lines(sizing: Sizing, room: Room) -> Iterator[Line]:
    """Yield the shafts that need bearings and have none."""
    gears, thick = {gear.name: gear for gear in sizing.gears}, {shaft.name: shaft.diameter for shaft in sizing.shafts}
    for name in bare_shafts(sizing):
        items = tuple(_widened(item, room) for item in items_on(sizing, name))
        own = [gears[item.name] for item in items if item.name in gears]
        if name in room.mirrored:
            items = tuple(
                item._replace(place=-item.place, before=item.after, after=item.before) for item in items[::-1]
            )
        core = core_of(items)
        if core is not None:
            first = core.first + ((name, FIRST) in room.overhung)
            core = Core(first, max(core.last - ((name, SECOND) in room.overhung), first))
            wheel = max((gears[item.name].pitch_diameter for item in items if item.kind == "gear"), default=0.0)
            full = frozenset(end for end in ENDS if (name, end) in room.no_axial)
            yield Line(
                name, items, core, thick[name], wheel, splined(own), apart=room.beside, no_axial=full,
                thicker=room.thicker.get(name, 0.0),
            )  # fmt: skip


def _widened(item: Item, room: Room) -> Item:
    more = room.around.get(item.name.split(".")[0], 0.0) if item.kind == "set" else 0.0
    return item._replace(before=item.before + more, after=item.after + more)


def _more_room(arranged: Arranged, room: Room) -> Room:
    """Return what is done next so that parts do not stand into each other.

    More room is made around sets. A bearing moves away; if that was not enough, what it holds overhangs the others, and
    where a machine stands at its end, that goes to the other one.
    """
    planned = {bearing.name: bearing.bearing.width for one in arranged.shafts for bearing in one.built.bearings}
    for bearing in arranged.sizing.bearings:
        wider = bearing.bearing.width - planned.get(bearing.name, math.inf)
        if wider > _MM / 2.0:
            room = room.with_beside(bearing.name, whole_millimetres(wider / 2.0))
    for shaft in {check.part.name: None for check in arranged.worse if check.mode == WHIRLS}:
        room = room.with_thicker(shaft)
    if any(check.mode == TOO_FAST for check in arranged.worse) and _oil_is_open(arranged.before.design):
        room = replace(room, under_race=True)
    crowded = [check for check in arranged.worse if check.mode.startswith(CROWDED)]
    bosses = boss_room(arranged.sizing) if crowded else None
    done, before = set[tuple[str, str]](), room.around
    for check in crowded:
        if check.value is not None and check.limit is not None:
            lacking = check.limit - check.value
            if bosses is not None and check.place == bosses[2]:
                lacking = bosses[1] - bosses[0]
            room = _with_room(arranged, room, check, whole_millimetres(lacking) + _MM, done, before)
    return room


def _oil_is_open(design: Design) -> bool:
    """Tell whether a design leaves open how oil comes to its bearings."""
    return {"lubrication", "speed_factor"}.isdisjoint(design.bearing_rules.model_fields_set)


def _with_room(
    arranged: Arranged,
    room: Room,
    check: Check,
    lacking: float,
    done: set[tuple[str, str]],
    before: Mapping[str, float],
) -> Room:
    """Return what is done for one check, where nothing was done yet for that end of that shaft.

    Args:
        arranged: What stands.
        room: As far as other checks asked for it.
        check: That fails.
        lacking: Room that it lacks [m].
        done: Shafts and ends for which something was done already; this one is added.
        before: Set -> room around it as it stands [m].
    """
    names = set(check.place.replace(",", " ").split())
    words = {str(check.part), *check.mode.split(), *names}
    stages = [stage for stage in arranged.design.sets if any(word.split(".")[0] == stage for word in words)]
    if stages:
        for stage in stages:
            room = room.with_around(stage, before.get(stage, 0.0) + lacking)
        return room
    for one in arranged.shafts:
        name, seat = one.line.name, next((seat for seat in one.ends if seat in names), "")
        end = _end_of(one, check.why) if name in names else one.ends.get(seat, "")
        if not end or (name, end) in done:
            continue
        done.add((name, end))
        if seat and seat not in room.beside and lacking <= NEAR:
            return room.with_beside(seat, lacking)
        if seat == f"{name}-axial":
            beside = {bearing: more for bearing, more in room.beside.items() if bearing != seat}
            return replace(room, no_axial=room.no_axial | {(name, end)}, beside=beside)
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


def _bevel_sizes(design: Design, sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield outer modules and widths of bevels that the design leaves open."""
    owners, gears = module_owners(design), {gear.stage: gear for gear in sizing.gears}
    for name, pair in design.pairs.items():
        if pair.kind != "bevel":
            continue
        if f"{name}.outer_module" not in sizing.given and owners[name] == name:
            yield f"{design.table(name)}.outer_module_mm", bevel_cones(sizing, name).outer_module / _MM
        if f"{name}.face_width" not in sizing.given:
            yield f"{design.table(name)}.face_width_mm", gears[name].face_width / _MM


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
        joints = {**{name: joint for one in shafts for name, joint in splines_of(one.line).items()}, **design.joints}
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
        own: dict[str, Any] = {"diameter": None, "first_bearing": None, "second_bearing": None} | (
            {} if one.line.bore is None else {"bore_ratio": one.line.bore}
        )
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
