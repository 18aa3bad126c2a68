"""Search for the tooth numbers of many designs with the same structure, and their preliminary sizings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, Ints
from gearwright.lanes import Lanes, Unsupported, lanes_of
from gearwright.sizing.many.by_lane import holds_lanes, of_lane
from gearwright.sizing.many.twinned import twinned
from gearwright.sizing.rating import ELEMENTWISE
from gearwright.sizing.teeth import StageTeeth, Trying, stage_teeth
from gearwright.sizing.teeth.candidates import REACHES, Reach, is_given, planet_counts
from gearwright.sizing.teeth.forbidden import clear
from gearwright.sizing.teeth.front import EQUAL, Front, Needs, needs_of, ranks_of, states_of
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
from gearwright.spec import Design, replaced

__all__ = ["Chosen", "Lanes"]


# ----------------------------------------------------------------------------------------------------------------------
# What the search for teeth reads of many designs of one structure at once: tasks of every choice, and of every row.
# ----------------------------------------------------------------------------------------------------------------------


ROW = "\0row"
"""Under which name the row of a choice stands among its teeth."""
NUMBERS = ("torque", "speed", "rolling", "steady", "fastest")
"""Numbers of a task that may differ from row to row."""


def rows_of(value: Any, count: int) -> Any:
    """Return a number of every row.

    Args:
        value: Lanes, or a number that all rows have.
        count: Rows [-].
    """
    return np.broadcast_to(lanes_of(value).data, (count,))


def _spread(rating: Any, row: Ints) -> Any:
    """Return rules whose numbers that are lanes are those of the row of every choice."""
    rules, material = rating.rules, rating.material
    own = {name: value for name, value in rules.__dict__.items() if type(value) is Lanes}
    steel = {name: value for name, value in vars(material).items() if type(value) is Lanes}
    if own:
        rules = replaced(rules, {(name,): rows_of(value, len(value.data))[row] for name, value in own.items()})
    if steel:
        material = replace(material, **{name: value.data[row] for name, value in steel.items()})
    factor = rating.load_factor
    if type(factor) is Lanes:
        factor = rows_of(factor, len(factor.data))[row]
    elif not own and not steel:
        return rating
    return replace(rating, rules=rules, material=material, load_factor=factor)


def _banned(ban: Any, row: Ints) -> Any:
    """Return a ban whose numbers that are lanes are those of the row of every choice."""
    ends: dict[tuple[str, ...], Any] = {
        (name,): end.data[row] for name in ("lowest", "highest") if type(end := getattr(ban.band, name)) is Lanes
    }
    band = replaced(ban.band, ends) if ends else ban.band
    factors = lanes_of(ban.factor).data
    return ban._replace(band=band, factor=factors[row] if len(factors) > 1 else float(factors[0]))


class Batch(NamedTuple):
    """What the search of a batch reads."""

    design: Design
    """As the case holds it that asks for the speeds; its numbers may be lanes."""
    tasks: Sequence[Any]
    nominal: Any
    speeds: Mapping[str, Floats]
    """Shaft -> asked speed in every row [rad/s]."""
    asked: Mapping[str, Floats]
    """Machine -> asked speed in every row [rad/s]."""
    numbers: Mapping[str, Mapping[str, Floats]]
    """Stage -> `NUMBERS` of its task in every row."""
    alone: dict[tuple[str, int], Any]
    """Stage and row -> its task there, as far as asked for."""
    kept: frozenset[str]
    """Shafts whose speed is kept."""

    def task(self, task: Any, front: Front) -> Any:
        """Return a task with the numbers of every choice of a front."""
        row = front.teeth[ROW]
        numbers = {name: values[row] for name, values in self.numbers[task.name].items()}
        bans = tuple(_banned(ban, row) for ban in task.bans)
        rating = _spread(task.rating, row)
        return replace(task, **numbers, rating=rating, bans=bans)

    def row(self, task: Any, row: int) -> Any:
        """Return a task with the numbers of one row."""
        if (task.name, row) not in self.alone:
            numbers = {name: float(values[row]) for name, values in self.numbers[task.name].items()}
            self.alone[task.name, row] = replace(of_lane(task, row), **numbers, known={}, closed={})
        return self.alone[task.name, row]

    def targets(self, front: Front) -> Any:
        """Return the asked speeds of every choice of a front."""
        row = front.teeth[ROW]
        return replace(self.nominal, speeds={shaft: speed[row] for shaft, speed in self.speeds.items()})


def batch_of(design: Design, train: Any, count: int, search: Any) -> Batch:
    """Return what the search of a design with lanes reads.

    Args:
        design: With lanes.
        train: Its graph.
        count: Rows [-].
        search: Twin of the search.

    Raises:
        Unsupported: If its rows have to be searched one by one.
    """
    rules = design.teeth
    if rules.sized != 1 or rules.split != "equal" or rules.ring_deviation:
        raise Unsupported("teeth that are searched in another way")
    nominal = search.targets(design)
    if any(not is_given(stage) and nominal.tooth_ratios[name] <= 1.0 for name, stage in design.planetaries.items()):
        raise Unsupported("a ring no larger than its sun")
    flow, known = search.nominal_flow(design, train, nominal)
    given_design, design = design, nominal.design
    tasks = [search.task_of(name, design, train, nominal, flow) for name in design.simple_stages]
    bans = search.banned(tasks, given_design, train, nominal, flow)
    if bans.whole:
        raise Unsupported("bands of frequencies that only whole trains are held against")
    tasks = search.with_twins(bans.tasks, design, nominal)
    return Batch(
        design, tasks, nominal,
        {shaft: rows_of(speed, count) for shaft, speed in nominal.speeds.items()},
        {name: rows_of(machine.asked_speed, count) for name, machine in design.machines.items()
         if machine.asked_speed is not None},
        {task.name: {name: rows_of(getattr(task, name), count) for name in NUMBERS} for task in tasks},
        {}, frozenset(known),
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# The search for teeth of many designs of one structure: one front of choices, each with the row that it belongs to.
#
# Stage after stage it takes the steps of the search for one design (`sizing.teeth`), by the same functions of arrays;
# the row of a choice stands among its teeth, so that choices of different rows never leave the same to what comes
# after them.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Preliminary sizings of many rows: each looks at its lightest combinations as one design does, all of them at once.
# ----------------------------------------------------------------------------------------------------------------------


class Looked(NamedTuple):
    """What came of one combination of some rows."""

    nearness: Mapping[str, Any]
    """Stage -> least value over limit of its checks, in lanes [-]."""
    heaviness: Mapping[str, Any]
    """Stage -> volume of its gears over that by which they were found, in lanes [-]."""
    mass: Any
    """What the gears weigh, in lanes [kg]."""


Look = Callable[[Ints, Rows], Iterator[tuple[Ints, Looked]]]
"""Some rows and their teeth -> what came of them, of those that can be computed at once."""


def _teeth_at(train: Any, considered: Considered, first: int, place: int) -> frozenset[StageTeeth]:
    """Return the teeth of the stages of a combination of a row."""
    at = first + place
    teeth = {gear: int(numbers[at]) for gear, numbers in considered.teeth.items()}
    planets = {stage: int(counts[at]) for stage, counts in considered.planets.items()}
    return stage_teeth(train, Chosen(teeth, planets))


def nearest_rows(train: Any, considered: Considered, look: Look, *, count: int) -> Rows:
    """Return the teeth of every row whose gears come nearest to meeting everything, the lightest of equals.

    Args:
        train: Graph of the design.
        considered: Combinations of every row.
        look: What sizes the gears of one combination of some rows.
        count: Rows [-].
    """
    first = np.searchsorted(considered.row, np.arange(count + 1))
    courses = [
        Trying(partial(_teeth_at, train, considered, start), considered.mass[start:end].tolist())
        for start, end in pairwise(first.tolist())
    ]
    left = np.arange(count)
    while len(left):
        places = [courses[row].next() for row in left.tolist()]
        going = np.array([place is not None for place in places], dtype=bool)
        left = left[going]
        at = np.array([place for place in places if place is not None], dtype=np.int64)
        lost = np.ones(len(left), dtype=bool)
        for some, looked in look(left, _rows(considered, first[left] + at)):
            _note(courses, left[some], at[some], looked)
            lost[some] = False
        for row in left[lost].tolist():
            courses[row].tried.clear()
        left = left[~lost]
    found = np.array([bool(course.tried) for course in courses], dtype=bool)
    best = [course.ranked()[0].place if course.tried else 0 for course in courses]
    return _rows(considered, np.minimum(first[:-1] + best, len(considered.row) - 1))._replace(found=found)


def _rows(considered: Considered, place: Ints) -> Rows:
    """Return the teeth of some combinations."""
    return Rows(
        {gear: numbers[place] for gear, numbers in considered.teeth.items()},
        {stage: counts[place] for stage, counts in considered.planets.items()},
        np.ones(len(place), dtype=bool),
    )


def _note(courses: Sequence[Trying], rows: Ints, places: Ints, looked: Looked) -> None:
    """Note what came of a combination of every row."""
    count = len(rows)
    nearness, heaviness = (_columns(ratios, count) for ratios in (looked.nearness, looked.heaviness))
    mass = _column(looked.mass, count)
    for k, (row, place) in enumerate(zip(rows.tolist(), places.tolist(), strict=True)):
        near, heavy = ({stage: ratios[k] for stage, ratios in of.items()} for of in (nearness, heaviness))
        courses[row].note(place, near, heavy, mass=mass[k])


def _columns(lanes: Mapping[str, Any], count: int) -> dict[str, list[float]]:
    return {name: _column(values, count) for name, values in lanes.items()}


def _column(values: Any, count: int) -> list[float]:
    column: list[float] = np.broadcast_to(lanes_of(values).data, (count,)).tolist()
    return column
