"""Preliminary sizings of many rows: each looks at its lightest combinations as one design does, all of them at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Ints
from gearwright.lanes import lanes_of
from gearwright.sizing.many.search import Considered, Rows
from gearwright.sizing.teeth import Chosen, StageTeeth, Trying, stage_teeth


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
