"""The search for teeth of many designs of one structure: one front of choices, each with the row that it belongs to.

Stage after stage it takes the steps of the search for one design (`sizing.teeth`), by the same functions of arrays; the
row of a choice stands among its teeth, so that choices of different rows never leave the same to what comes after them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.lanes import Lanes, Unsupported
from gearwright.sizing.many.batch import ROW, Batch, batch_of, rows_of
from gearwright.sizing.many.by_lane import holds_lanes
from gearwright.sizing.many.twinned import twinned
from gearwright.sizing.rating import ELEMENTWISE
from gearwright.sizing.teeth.candidates import REACHES, Reach, is_given, planet_counts
from gearwright.sizing.teeth.forbidden import clear
from gearwright.sizing.teeth.front import Front
from gearwright.sizing.teeth.masses import aligned
from gearwright.sizing.teeth.search import MANY, Chosen, carried_over, is_ready
from gearwright.sizing.teeth.stage import (
    PARENTS,
    asked_ratios,
    is_open,
    near_candidates,
    new_speeds,
    tooth_ratio,
    weighed_front,
)
from gearwright.sizing.teeth.states import EQUAL, Needs, needs_of, ranks_of, states_of
from gearwright.spec import Design

AT_ONCE = 128
"""Rows that are searched at once, so that memory is bounded [-]."""


class Rows(NamedTuple):
    """Teeth of many designs."""

    teeth: dict[str, Ints]
    """Gear -> tooth number in every row."""
    planets: dict[str, Ints]
    """Planetary set whose number of planets is open -> that number in every row."""
    found: Bools
    """Rows whose teeth are chosen; the others are to be searched alone."""


class Considered(NamedTuple):
    """Combinations of teeth of many designs, one after the other, those of a design together, its lightest first."""

    teeth: dict[str, Ints]
    """Gear -> tooth number in every combination."""
    planets: dict[str, Ints]
    """Planetary set whose number of planets is open -> that number in every combination."""
    mass: Floats
    """What the gears weigh by the estimate of the search [kg]; 0 where the design gives all teeth."""
    row: Ints
    """Design that each is of."""


def choose_rows(design: Design, train: Any, count: int) -> Rows:
    """Return the teeth of every row of a design whose numbers are lanes.

    Args:
        design: With lanes.
        train: Its graph.
        count: Rows [-].

    Raises:
        Unsupported: If its rows have to be searched one by one.
    """
    every = consider_rows(design, train, count, kept=1)
    found = np.bincount(every.row, minlength=count) > 0
    place = np.zeros(count, dtype=np.int64)
    place[every.row] = np.arange(len(every.row))
    teeth, planets = ({name: values[place] for name, values in of.items()} for of in (every.teeth, every.planets))
    return Rows(teeth, planets, found)


def consider_rows(design: Design, train: Any, count: int, *, kept: int) -> Considered:
    """Return so many of the lightest combinations of teeth of every row of a design whose numbers are lanes.

    Args:
        design: With lanes.
        train: Its graph.
        count: Rows [-].
        kept: How many of each [-].

    Raises:
        Unsupported: If its rows have to be searched one by one.
    """
    search = twinned("gearwright.sizing.teeth.search")
    if all(is_given(stage) and len(planet_counts(name, design)) == 1 for name, stage in design.stages.items()):
        teeth = search.given_teeth(design)
        return Considered(
            {gear: rows_of(number, count) for gear, number in teeth.items()}, {}, np.zeros(count), np.arange(count)
        )
    given = batch_of(design, train, count, search)
    fronts = []
    for first in range(0, count, AT_ONCE):
        row = np.arange(first, min(first + AT_ONCE, count))
        start = Front({ROW: row}, {shaft: given.speeds[shaft][row] for shaft in given.kept}, {}, {})
        fronts.append(_searched(given, start, kept))
    return _considered(given, search, fronts[0].joined(fronts[1:]), kept=kept, count=count)


def _considered(given: Batch, search: Any, front: Front, *, kept: int, count: int) -> Considered:
    """Return of every row its lightest choices, the first of those that are as light as any before the others."""
    mass, row = aligned(front, given.design).mass, front.teeth[ROW]
    first = _first_lightest(row, mass, count)
    order = first[first >= 0]
    if kept > 1:
        leads = np.ones(len(row), dtype=bool)
        leads[order] = False
        ordered = np.lexsort((ranks_of(mass), leads, row))
        begin = np.flatnonzero(np.diff(row[ordered], prepend=-1))
        order = ordered[np.arange(len(row)) - np.repeat(begin, np.diff(begin, append=len(row))) < kept]
    taken = front.take(order)
    teeth = {name: values for name, values in taken.teeth.items() if name != ROW}
    compound = search.compound_teeth(given.design)
    teeth |= {gear: rows_of(number, count)[taken.teeth[ROW]] for gear, number in compound.items()}
    left_out = {name for name, stage in given.design.planetaries.items() if stage.planets_given is None}
    planets = {name: values for name, values in taken.planets.items() if name in left_out}
    return Considered(teeth, planets, mass[order], taken.teeth[ROW])


def _first_lightest(row: Ints, mass: Floats, count: int) -> Ints:
    """Return of every row the place of the first choice that is as light as any; −1 where it has none."""
    least = np.full(count, np.inf)
    if len(row):
        starts = np.flatnonzero(np.r_[True, row[1:] != row[:-1]])
        least[row[starts]] = np.minimum.reduceat(mass, starts)
    light = np.flatnonzero(mass <= least[row] * (1.0 + EQUAL))
    place = np.full(count, -1)
    place[row[light[::-1]]] = light[::-1]
    return place


def _searched(given: Batch, front: Front, kept: int) -> Front:
    """Return whole combinations of every row, as far as they are found here."""
    later = list(given.tasks)
    front = carried_over(given.design, front)
    while later:
        task = next((task for task in later if is_ready(task, front)), None)
        if task is None:
            raise Unsupported("stages to which no known speed leads")
        later.remove(task)
        front = _extended(given, front, task, needs_of(later, given.design, kept=kept), last=not later)
        front = carried_over(given.design, _not_too_many(front))
    return front


def _not_too_many(front: Front) -> Front:
    """Leave out the rows that have so many choices that one design's search would look for those that cannot win."""
    row = front.teeth[ROW]
    if not len(row):
        return front
    many = np.bincount(row) > min(MANY, PARENTS)
    return front.take(~many[row]) if many.any() else front


def _extended(given: Batch, front: Front, task: Any, needs: Needs, *, last: bool) -> Front:
    """Multiply every row's choices by a stage's candidates; those that find none look further."""
    grown, waiting = list[Front](), front
    for reach in REACHES:
        added = _grown(given, waiting, task, reach)
        if added is not None:
            grown.append(_lightest(added, needs, last=last))
            done = np.zeros(int(front.teeth[ROW].max()) + 1, dtype=bool)
            done[added.teeth[ROW]] = True
            waiting = waiting.take(~done[waiting.teeth[ROW]])
        if not len(waiting):
            break
    if not grown:
        raise Unsupported("no row has candidates")
    whole = grown[0].joined(grown[1:]) if len(grown) > 1 else grown[0]
    return whole.take(np.argsort(whole.teeth[ROW], kind="stable")) if len(grown) > 1 else whole


def _grown(given: Batch, front: Front, task: Any, reach: Reach) -> Front | None:
    """Return the choices that a stage's candidates make of those of a front."""
    if is_open(front, task, given.design) and len(front) == 1:
        raise Unsupported("a ratio that is the search's own choice")
    own = given.task(task, front)
    target = asked_ratios(front, own, given.targets(front))
    parent, small, large = near_candidates(front, own, given.design, target, reach=reach)
    actual = tooth_ratio(task, small, large)
    grown = front.take(parent)
    speeds = new_speeds(grown, task, actual)
    good = _speeds_hold(given, task, speeds, grown.teeth[ROW])
    if not good.any():
        return None
    grown = replace(grown, speeds={**grown.speeds, **speeds})
    if not good.all():
        grown, small, large = grown.take(good), small[good], large[good]
    own = given.task(task, grown)
    if task.rating.proportions is None:
        grown = weighed_front(grown, own, given.design, small, large)
    elif task.rating.method in ELEMENTWISE and task.rating.kind != "bevel" and not holds_lanes(task.rating):
        grown = weighed_front(grown, replace(own, row=grown.teeth[ROW]), given.design, small, large)
    else:
        grown = _weighed_by_rows(given, grown, task, small, large)
    if not own.bans:
        return grown
    good = clear(grown, given.task(task, grown))
    return grown.take(good) if good.any() else None


def _weighed_by_rows(given: Batch, front: Front, task: Any, small: Ints, large: Ints) -> Front:
    """Add a stage that a standard rates, whose modules are found for the loads of each row."""
    row, parts = front.teeth[ROW], list[Front]()
    starts = np.flatnonzero(np.r_[True, row[1:] != row[:-1]])
    for first, end in zip(starts, [*starts[1:], len(row)], strict=True):
        part = front.take(np.arange(first, end))
        parts.append(
            weighed_front(part, given.row(task, int(row[first])), given.design, small[first:end], large[first:end])
        )
    return parts[0].joined(parts[1:])


def _speeds_hold(given: Batch, task: Any, speeds: Mapping[str, Floats], row: Ints) -> Bools:
    """Tell which choices keep the machines' speeds within the tolerance; given teeth are as they are."""
    good = np.ones(len(row), dtype=bool)
    if is_given(task.stage):
        return good
    for name, asked in given.asked.items():
        shaft = given.design.machines[name].shaft
        if shaft in speeds:
            good &= np.abs(speeds[shaft] / asked[row] - 1.0) <= given.design.teeth.speed_tolerance
    return good


def _lightest(front: Front, needs: Needs, *, last: bool) -> Front:
    """Return the lightest of the choices of each row that leave the same to the stages after them."""
    mass = front.mass
    if needs.kept > 1:
        return _several(front, states_of(front, needs._replace(gears=needs.gears | {ROW})), mass, needs.kept)
    if last and not needs.gears and not needs.groups:
        place = _first_lightest(front.teeth[ROW], mass, int(front.teeth[ROW].max()) + 1)
        return front.take(place[place >= 0])
    state = states_of(front, needs._replace(gears=needs.gears | {ROW}))
    least = np.full(int(state.max()) + 1, np.inf)
    np.minimum.at(least, state, mass)
    light = np.flatnonzero(mass <= least[state] * (1.0 + EQUAL))
    chosen = np.sort(light[np.unique(state[light], return_index=True)[1]])
    return front if len(chosen) == len(front) else front.take(chosen)


def _several(front: Front, state: Ints, mass: Floats, kept: int) -> Front:
    """Return so many of the lightest of every state."""
    order = np.lexsort((mass, state))
    begin = np.flatnonzero(np.diff(state[order], prepend=-1))
    light = np.arange(len(order)) - np.repeat(begin, np.diff(begin, append=len(order))) < kept
    return front if light.all() else front.take(np.sort(order[light]))


__all__ = ["Chosen", "Considered", "Lanes", "Rows", "choose_rows", "consider_rows"]
