"""Cases of which only the mission differs: sized once, and flown together as arrays."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from itertools import takewhile
from typing import Any

from gearwright.errors import DesignError, GearwrightError
from gearwright.sizing import Named, Sizing, asked_results, size
from gearwright.spec import Design, Mission, Study, edited, edited_mission
from gearwright.spec.studies import Value
from gearwright.study.answers import Row
from gearwright.study.cases.evaluate import evaluate, row_of, split
from gearwright.study.cases.sampling import Case

_LONE_VERBS = ("review", "modes", "simulate")
"""Beginnings of results for which a case is computed alone."""
_kept: list[tuple[Design, Mapping[str, Value], Sizing]] = []
"""The last sizing."""


TOGETHER = 64
"""Flights of a chunk: many beside what an operation on arrays costs, few beside a cache and a journal."""


def flown_together(study: Study, designs: Mapping[str, Design], cases: Sequence[Case]) -> list[Row]:
    """Return the rows of cases, each with the bits that it has alone.

    Args:
        study: Changes, and the results that are asked for.
        designs: Name -> design.
        cases: Their inputs.
    """
    if not fly_together(study):
        return [evaluate(study, designs[case.design], case) for case in cases]
    rows, place = list[Row](), 0
    while place < len(cases):
        first, changes = cases[place], _design_part(study, cases[place])
        chunk = list(takewhile(partial(_alike, study, first.design, changes), cases[place : place + TOGETHER]))
        rows += _flown_rows(study, designs[first.design], changes, chunk)
        place += len(chunk)
    return rows


def fly_together(study: Study) -> bool:
    """Tell whether flights of a study can be found together.

    Args:
        study: With its results.
    """
    alone = any(name.partition(".")[0] in _LONE_VERBS for name in study.asked)
    return study.flies and study.mission is not None and study.fly.life is None and not alone


def _alike(study: Study, design: str, changes: Mapping[str, Value], case: Case) -> bool:
    return case.design == design and _design_part(study, case) == changes


def _design_part(study: Study, case: Case) -> Mapping[str, Value]:
    return split({**study.changes, **case.inputs})[0]


def _flown_rows(study: Study, design: Design, changes: Mapping[str, Value], cases: Sequence[Case]) -> list[Row]:
    from gearwright.mission import Flight, fly_each, gear_damages  # what flies is loaded for those who ask for it
    from gearwright.study.cases.flight import asks_lives

    mission = study.mission
    assert mission is not None  # `fly_together`
    try:
        sizing = _sized(design, changes)
    except GearwrightError:
        return [evaluate(study, design, case) for case in cases]
    missions = [_edited(mission, split({**study.changes, **case.inputs})[1]) for case in cases]
    good = [entry for entry in missions if isinstance(entry, Mission)]
    flights = iter(fly_each(sizing, good))
    found = [next(flights) if isinstance(entry, Mission) else entry for entry in missions]
    flew = [one for one in found if isinstance(one, Flight)]
    damages = iter(gear_damages(flew) if asks_lives(study.asked) else [None] * len(flew))
    lived = [next(damages) if isinstance(one, Flight) else None for one in found]
    once = cache(lambda: asked_results(sizing, study.asked))
    return [
        row_of(study, case, partial(_results, study, once, one, damage))
        for case, one, damage in zip(cases, found, lived, strict=True)
    ]


def _sized(design: Design, changes: Mapping[str, Value]) -> Sizing:
    """Return the sizing of a design with changes; the last one is kept."""
    for known, same, sizing in _kept:
        if known is design and same == changes:
            return sizing
    sizing = size(edited(design, changes))
    _kept[:] = [(design, dict(changes), sizing)]
    return sizing


def _edited(mission: Mission, changes: Mapping[str, Value]) -> Mission | DesignError:
    try:
        return edited_mission(mission, changes)
    except DesignError as error:
        return error


def _results(study: Study, of_sizing: Callable[[], dict[str, Named]], flight: object, damage: Any) -> dict[str, Named]:
    """Return the results that are asked for; those of the sizing, the same for all, where a flight has not all."""
    from gearwright.mission import Flight
    from gearwright.study.cases.flight import flight_results

    for known in (flight, damage):
        if isinstance(known, DesignError):
            raise known
    assert isinstance(flight, Flight)
    results = flight_results(flight, study.asked, damage)
    if all(name in results for name in study.asked):
        return {name: results[name] for name in study.asked}
    return of_sizing() | results
