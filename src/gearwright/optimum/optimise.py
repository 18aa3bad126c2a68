"""Optimisation of a study or of one design with given design variables, objectives and constraints."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import closing
from pathlib import Path

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, SolveError, refuse
from gearwright.optimum.course import Bench, Compass, Course, Tell, followed, polishable, rounds
from gearwright.optimum.freedoms import Fixed, Judged, judged_rows, with_teeth
from gearwright.optimum.optimum import Counts, Optimum
from gearwright.optimum.reasons import best_of, influences_of, prices_of, regrets_of, shortfall
from gearwright.shipped import find_design
from gearwright.spec import Design, Study, read
from gearwright.spec.edit import standing_at
from gearwright.spec.studies import Axis, Bound, Search, study_problems
from gearwright.study.cases import Case
from gearwright.study.tables import Row
from gearwright.verbs import verb

__all__ = ["Judged", "Optimum", "SolveError"]


# ----------------------------------------------------------------------------------------------------------------------
# A study that looks for the best of one design, for who has no study file: freedoms, objectives, bounds in short.
# ----------------------------------------------------------------------------------------------------------------------


OBJECTIVES = {"total_mass": "minimum", "loss": "minimum"}
"""What is wanted where nothing is said."""
CONSTRAINTS = {"worst_margin": {"minimum": 1.0}}
"""What every design keeps: the worst margin of its sizing."""
PLANETS = (3, 4, 5, 6)
SPEEDS = (0.8, 1.25)
"""Of a motor's speed, from and to [-]."""
WIDTHS = (6.0, 16.0)
"""Face width over module, from and to [-]."""


def study_for(
    name: str, design: Design, *, axes: Mapping[str, Axis] | None = None, objectives: Mapping[str, str] | None = None,
    constraints: Mapping[str, Bound] | None = None, search: Search | None = None,
) -> Study:  # fmt: skip
    """Return the study that looks for the best of a design.

    Args:
        name: Of the design, as it is found.
        design: What may be changed.
        axes: Path -> range or list; left out: speeds of motors, numbers of planets, face width over module.
        objectives: Result -> ``minimum`` or ``maximum``; left out: mass with motors, and lost power.
        constraints: Result -> bounds, beside the margin of the sizing.
        search: How far it goes.
    """
    free = dict(axes) if axes else {path: Axis.model_validate(axis) for path, axis in _freedoms(design)}
    kept = {key: Bound.model_validate(bound) for key, bound in CONSTRAINTS.items()}
    return Study.model_validate({
        "name": f"The best of {design.name}", "designs": [name], "axes": free,
        "results": list(objectives or OBJECTIVES), "objectives": dict(objectives or OBJECTIVES),
        "constraints": {**kept, **(constraints or {})}, "search": search or Search(),
    })  # fmt: skip


def _freedoms(design: Design) -> Iterable[tuple[str, dict[str, object]]]:
    """Yield what most designs leave free."""
    for name in design.motors:
        speed = standing_at(design, path := f"motors.{name}.speed_rpm").value
        if isinstance(speed, float):
            yield path, {"from": round(SPEEDS[0] * speed), "to": round(SPEEDS[1] * speed)}
    for name, stage in design.planetaries.items():
        if stage.sun_teeth is None and stage.planet_teeth is None:
            yield f"planetaries.{name}.planets", {"values": list(PLANETS)}
    if design.planetaries or design.pairs:
        yield "gears.face_width_ratio", {"from": WIDTHS[0], "to": WIDTHS[1]}


# ----------------------------------------------------------------------------------------------------------------------
# The verb: the best designs along the freedoms of a study, why they are, and how sure that is.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def optimise(
    study: Study,
    designs: Mapping[str, Design] | None = None,
    *,
    journal: Path | None = None,
    workers: int = 0,
    anyway: bool = False,
    tell: Tell | None = None,
) -> Optimum:
    """Return the best designs along the axes of a study: points that fill them, generations, polish with teeth kept.

    Generations end when the hypervolume of the front stands still. The same study gives the same answer, bit for bit,
    whatever the number of workers and however often it was stopped.

    Args:
        study: Axes as freedoms, objectives, constraints, what is uncertain; its table ``search`` says how far it goes.
        designs: Name -> design, for every name in the study; left out: read by their names.
        journal: File that keeps every design that is looked at; one that is there is gone on with.
        workers: Processes; 0 computes in this one.
        anyway: Go on with a journal although designs or what computes have changed since it was begun.
        tell: Called with what is being done.

    Raises:
        DesignError: If there is nothing to vary or to want, a path does not exist, the journal is of another search,
            or no design keeps the constraints.
        SolveError: If the journal cannot be written, or workers die.

    Source: Deb et al. 2002 (NSGA-II); Kolda et al. 2003 (compass search).
    """
    study = study if study.search is not None else study.model_copy(update={"search": Search()})
    rules = study.search
    assert rules is not None
    refuse([*study_problems(study), *_problems(workers)], study.name)
    known = designs if designs is not None else {name: read(find_design(name)) for name in study.designs}
    say = tell or _quiet
    with closing(Bench(study, known, journal=journal, workers=workers, anyway=anyway)) as bench:
        course = followed(bench, rules, workers=workers, tell=say)
        if not course.archive.rows:
            raise DesignError(shortfall(study, known, course.archive), study.name)
        return _answered(bench, rules, course, say)


def _problems(workers: int) -> Sequence[Problem]:
    return [] if workers >= 0 else [Problem("workers", f"{workers} are asked; 0 computes in this process")]


def _quiet(_: str) -> None:
    """Say nothing."""


def _answered(bench: Bench, rules: Search, course: Course, tell: Tell) -> Optimum:
    """Return the answer to which a search has come, polished and judged."""
    study, archive = bench.study, course.archive
    first = len(study.designs) * rules.screened
    tell(f"{len(archive.rows)} designs on the front; polishing with their teeth kept")
    fixed, end = _polished(bench, rules, course)
    chosen = nearest(archive.judged.values)
    counts = Counts(first, course.number - first, end - course.number, len(course.growth))
    teeth = {id(row): True for row in fixed}
    front = tuple(best_of(study, bench.designs, row, polished=id(row) in teeth) for row in archive.rows)
    order = np.argsort(archive.judged.values[:, 0], kind="stable")
    place = int(np.flatnonzero(order == chosen)[0])
    ordered = tuple(front[k] for k in order.tolist())
    answer = Optimum(study, ordered, place, counts, course.growth, course.still)
    tell("what limits cost, and what is uncertain")
    values = archive.judged.values[order]
    prices = () if rules.surrogate else prices_of(bench, answer, values)
    return Optimum(
        study, ordered, place, counts, course.growth, course.still,
        prices, regrets_of(bench, answer, values), influences_of(bench, answer, values), course.parents.fits,
    )  # fmt: skip


def nearest(values: Floats) -> int:
    """Return the design whose worst objective is nearest to the best of it, over the spans of the front.

    Args:
        values: Objectives to be made small, shape (designs, objectives).
    """
    span = np.maximum(np.ptp(values, axis=0), 1e-300)
    away = (values - values.min(axis=0)) / span
    return int(np.lexsort((away.sum(axis=1), away.max(axis=1)))[0])


def _polished(bench: Bench, rules: Search, course: Course) -> tuple[list[Row], int]:
    """Polish designs that are spread over the front, and some beside it; return those with teeth kept, and the next
    number."""
    archive, number = course.archive, course.number
    most = len(bench.study.designs) * rules.screened + rules.evaluations
    count = polishable(rules, most - number)
    starts = [with_teeth(bench.study, bench.designs, archive.rows[k]) for k in _spread(archive.judged.values, count)]
    kept = [start for start in starts if start is not None]
    every = [*kept, *(Fixed(row.design, row.inputs) for row in archive.beside(count - len(kept)))]
    if not every:
        return [], number
    rows = bench.rows([_case(number + k, start) for k, start in enumerate(every)])
    number += len(every)
    own = judged_rows(bench.study, rows)
    scale = np.maximum(np.ptp(archive.judged.values, axis=0), 1e-3 * np.abs(archive.judged.values).max(axis=0) + 1e-300)
    compasses = [
        Compass(start, bench.study.axes, own.take(np.array([k])), scale) for k, start in enumerate(every) if own.good[k]
    ]
    for going, tried in rounds(compasses, rules.seed):
        cases, number = _cases(going, tried, number)
        if number > most:
            number -= len(cases)
            break
        answers = iter(bench.rows(cases))
        for compass, places in zip(going, tried, strict=True):
            found = [next(answers) for _ in places]
            compass.note(places, found, judged_rows(bench.study, found))
    better = {compass: compass.row for compass in compasses if compass.row is not None}
    if better:
        archive.add(list(better.values()), judged_rows(bench.study, list(better.values())))
    return [row for compass, row in better.items() if compass.start in kept], number


def _case(number: int, start: Fixed) -> Case:
    return Case(number, start.design, dict(start.inputs))


def _cases(going: Sequence[Compass], tried: Sequence[Sequence[Floats]], number: int) -> tuple[list[Case], int]:
    """Return the cases of a round of compasses, and the number behind the last."""
    cases = list[Case]()
    for compass, places in zip(going, tried, strict=True):
        for place in places:
            cases.append(Case(number + len(cases), compass.start.design, compass.inputs(place)))
    return cases, number + len(cases)


def _spread(values: Floats, count: int) -> list[int]:
    """Return so many designs spread over a front: the best of each objective, then always the one that is farthest."""
    scaled = (values - values.min(axis=0)) / np.maximum(np.ptp(values, axis=0), 1e-300)
    taken = list(dict.fromkeys([nearest(values), *np.argmin(values, axis=0).tolist()]))[:count]
    while len(taken) < min(count, len(values)):
        away = np.min([np.linalg.norm(scaled - scaled[k], axis=1) for k in taken], axis=0)
        taken.append(int(np.argmax(away)))
    return taken
