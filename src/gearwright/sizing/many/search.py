"""Search for the tooth numbers of many designs with the same structure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, Ints
from gearwright.lanes import Lanes, Unsupported, lanes_of
from gearwright.sizing.many.by_lane import of_lane
from gearwright.sizing.many.twinned import twinned
from gearwright.sizing.teeth.candidates import (
    EQUAL,
    REACHES,
    Front,
    Needs,
    Reach,
    is_given,
    needs_of,
    planet_counts,
    states_of,
)
from gearwright.sizing.teeth.criteria import aligned, clear
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


def choose_rows(design: Design, train: Any, count: int) -> Rows:
    """Return the teeth of every row of a design whose numbers are lanes.

    Args:
        design: With lanes.
        train: Its graph.
        count: Rows [-].

    Raises:
        Unsupported: If its rows have to be searched one by one.
    """
    search = twinned("gearwright.sizing.teeth.search")
    if all(is_given(stage) and len(planet_counts(name, design)) == 1 for name, stage in design.stages.items()):
        teeth = search.given_teeth(design)
        return Rows({gear: rows_of(number, count) for gear, number in teeth.items()}, {}, np.ones(count, dtype=bool))
    given = batch_of(design, train, count, search)
    fronts = []
    for first in range(0, count, AT_ONCE):
        row = np.arange(first, min(first + AT_ONCE, count))
        start = Front({ROW: row}, {shaft: given.speeds[shaft][row] for shaft in given.kept}, {}, {})
        fronts.append(_searched(given, start))
    front = fronts[0].joined(fronts[1:])
    place = _first_lightest(front.teeth[ROW], aligned(front, given.design).mass, count)
    taken = front.take(np.maximum(place, 0))
    teeth = {name: values for name, values in taken.teeth.items() if name != ROW}
    teeth |= {gear: rows_of(number, count) for gear, number in search.compound_teeth(given.design).items()}
    left_out = {name for name, stage in given.design.planetaries.items() if stage.planets_given is None}
    planets = {name: values for name, values in taken.planets.items() if name in left_out}
    return Rows(teeth, planets, place >= 0)


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


def _searched(given: Batch, front: Front) -> Front:
    """Return whole combinations of every row, as far as they are found here."""
    later = list(given.tasks)
    front = carried_over(given.design, front)
    while later:
        task = next((task for task in later if is_ready(task, front)), None)
        if task is None:
            raise Unsupported("stages to which no known speed leads")
        later.remove(task)
        front = _extended(given, front, task, needs_of(later, given.design), last=not later)
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
    grown = weighed_front(grown, own, given.design, small, large)
    if not own.bans:
        return grown
    good = clear(grown, given.task(task, grown))
    return grown.take(good) if good.any() else None


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
    if last and not needs.gears and not needs.groups:
        place = _first_lightest(front.teeth[ROW], mass, int(front.teeth[ROW].max()) + 1)
        return front.take(place[place >= 0])
    state = states_of(front, needs._replace(gears=needs.gears | {ROW}))
    least = np.full(int(state.max()) + 1, np.inf)
    np.minimum.at(least, state, mass)
    light = np.flatnonzero(mass <= least[state] * (1.0 + EQUAL))
    chosen = np.sort(light[np.unique(state[light], return_index=True)[1]])
    return front if len(chosen) == len(front) else front.take(chosen)
