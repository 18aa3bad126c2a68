"""Optimisation of a study or of one design with given design variables, objectives and constraints."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np

from gearwright.base import DesignError, Floats, Problem, Shown, SolveError, refuse, verb
from gearwright.optimum.course import Bench, Compass, Course, Tell, followed, polishable, rounds
from gearwright.optimum.generations import DESIGN, Fixed, Judged, freedoms_of, judged_rows, parents_of, with_teeth
from gearwright.optimum.optimum import Counts, Fit, Gap, Optimum, expected_gap
from gearwright.optimum.reasons import best_of, influences_of, prices_of, regrets_of, shortfall
from gearwright.shipped import find_design
from gearwright.sizing import Named
from gearwright.spec import Axis, Bound, Design, Search as Rules, Study, Value, read, standing_at, study_problems
from gearwright.study.cases import Case, unit_sample
from gearwright.study.tables import Row

# ----------------------------------------------------------------------------------------------------------------------
# Ask and tell: designs that are worth a look, their evaluation with a journal, and what came of them.
#
# Any optimiser can drive the evaluation; without one, generations of NSGA-II answer what is asked.
# ----------------------------------------------------------------------------------------------------------------------


Asked = Mapping[str, Value]
"""Freedom -> value: dotted paths in their units, and ``design`` where there are several."""
Answer = Mapping[str, float]
"""Result -> value [SI]."""


class Search(Shown):
    """Designs that are asked for, evaluated and told, until somebody is content.

    The same study, seed and tells give the same asks, bit for bit, whatever the number of workers; what is in the
    journal is not computed again, so that a driver that was killed is simply started anew.
    """

    def __init__(self, study: Study, designs: Mapping[str, Design], bench: Bench) -> None:
        self.study = study
        self.freedoms = freedoms_of(study)
        self.rows: list[Row] = []
        """Everything that was told."""
        self._bench, self._rules = bench, _rules(study)
        self._parents = parents_of(study, self._rules)
        self._generator = np.random.default_rng(self._rules.seed)
        self._first = first_places(study, self._rules.population, self._rules.seed)
        self._asked = self._number = 0

    def __enter__(self) -> Search:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """End the workers and let the journal go."""
        self._bench.close()

    @property
    def names(self) -> tuple[str, ...]:
        """Of the freedoms, one for each axis of the unit cube."""
        return self.freedoms.names

    @property
    def computed(self) -> int:
        """Designs that were evaluated and not found in the journal [-]."""
        return self._bench.computed

    @property
    def fits(self) -> tuple[Fit, ...]:
        """How well the surrogate foretells each result that it is not told; empty without ``search.surrogate``."""
        return self._parents.fits

    def ask(self, count: int) -> list[dict[str, Value]]:
        """Return designs that are worth a look: first evenly spread ones, then children of the best that were told.

        Args:
            count: How many [-].

        Raises:
            DesignError: If fewer than one is asked for.
        """
        if count < 1:
            raise DesignError([Problem("count", f"{count} are asked for; ask for 1 or more")])
        places = self._first[self._asked : self._asked + count]
        self._asked += len(places)
        if len(places) < count and len(self._parents.places) < 2:
            fresh = self._generator.random((count - len(places), len(self.names)))
            places = np.vstack([places, fresh])
        elif len(places) < count:
            places = np.vstack([places, self._parents.children(count - len(places), self._generator)])
        return [self.freedoms.row(place) for place in places]

    def at(self, places: Any) -> list[dict[str, Value]]:
        """Return what places of the unit cube mean, for optimisers that move in it.

        Args:
            places: From 0 to 1, shape (designs, freedoms), freedoms in the order of `names`.

        Raises:
            DesignError: If it has another shape, or a place is outside.
        """
        cube = np.atleast_2d(np.asarray(places, dtype=float))
        if cube.ndim != 2 or cube.shape[1] != len(self.names):
            wanted = f"give (designs, {len(self.names)}), a column for each of {', '.join(self.names)}"
            raise DesignError([Problem("places", f"of shape {cube.shape}; {wanted}")])
        if not ((cube >= 0.0) & (cube <= 1.0)).all():
            raise DesignError([Problem("places", "some are not between 0 and 1, where the unit cube is; clip them")])
        return [self.freedoms.row(place) for place in cube]

    def evaluate(self, rows: Sequence[Asked], by: Callable[[Asked], Answer] | None = None) -> list[Row]:
        """Return designs with their results; those that the journal has are not computed again.

        Args:
            rows: From `ask`, `at`, or anywhere: freedom -> value.
            by: What computes the results of a row in SI instead of the study's own verbs; left out: those.

        Raises:
            DesignError: If rows are none of this search, or the journal was made by another driver.
        """
        self.freedoms.refuse(rows)
        cases = [self.freedoms.case(self._number + k, row) for k, row in enumerate(rows)]
        self._refuse_many(len(rows))
        self._number += len(rows)
        if by is None:
            return self._bench.rows(cases)
        return [
            self._bench.known(case) or self._bench.keep(case.number, _row_of(self.study, case.design, row, by(row)))
            for case, row in zip(cases, rows, strict=True)
        ]

    def tell(self, rows: Sequence[Row]) -> None:
        """Take in what came of designs.

        Args:
            rows: From `evaluate`.
        """
        written = [{DESIGN: row.design, **row.inputs} for row in rows]
        self.rows += rows
        if rows:
            self._parents.add(self.freedoms.places(written), judged_rows(self.study, list(rows)))

    def judged(self, rows: Sequence[Row]) -> Judged:
        """Return objectives to be made small and broken constraints of designs, as arrays.

        Args:
            rows: From `evaluate`.
        """
        return judged_rows(self.study, list(rows))

    @property
    def front(self) -> tuple[Row, ...]:
        """Designs of all that were told that keep every constraint and no other one dominates."""
        own = judged_rows(self.study, self.rows)
        best = np.flatnonzero(own.good & (own.ranks == 0))
        return tuple(self.rows[k] for k in best[np.argsort(own.values[best, 0], kind="stable")])

    def _refuse_many(self, count: int) -> None:
        """Refuse more evaluations than the search says."""
        if self._number + count > (most := self._rules.evaluations):
            message = f"{self._number + count} evaluations; the study says at most {most}: raise search.evaluations"
            raise DesignError([Problem("rows", message)])


def first_places(study: Study, count: int, seed: int) -> Floats:
    """Return evenly spread places of the unit cube: scrambled Sobol' points, shape (count, freedoms).

    Args:
        study: With axes.
        count: How many [-].
        seed: Of the scrambling.
    """
    names = freedoms_of(study).names
    axes = {name: next(iter(study.axes.values())) for name in names}
    sampling = study.sampling.model_copy(update={"method": "sobol", "count": count, "seed": seed})
    return unit_sample(study.model_copy(update={"axes": axes, "sampling": sampling}))


def _rules(study: Study) -> Rules:
    return study.search if study.search is not None else Rules()


def _row_of(study: Study, design: str, row: Asked, answer: Answer) -> Row:
    """Return a row whose results came from elsewhere; their dimensions are not known there."""
    missing = [name for name in study.asked if name not in answer]
    if missing:
        raise DesignError([Problem("by", f"its answer lacks {', '.join(missing)}; give a number for each")])
    inputs = {name: value for name, value in row.items() if name != DESIGN}
    return Row(design, inputs, {name: Named(float(answer[name]), "ratio") for name in study.asked})


@verb
def search(
    study: Study,
    designs: Mapping[str, Design] | None = None,
    *,
    journal: Path | None = None,
    workers: int = 0,
    anyway: bool = False,
) -> Search:
    """Return a search that can be asked for designs, and told what came of them; any optimiser can drive it.

    Args:
        study: Axes as freedoms, objectives, constraints; its table ``search`` says seed, population and evaluations.
        designs: Name -> design, for every name in the study; left out: read by their names.
        journal: File that keeps every evaluation; one that is there is gone on with.
        workers: Processes that compute; 0: this one.
        anyway: Go on with a journal although designs or what computes have changed since it was begun.

    Raises:
        DesignError: If there is nothing to vary or to want, a path does not exist, or the journal is of another search.

    >>> import gearwright as gw
    >>> speed = {"motors.electric.speed_rpm": {"from": 4000, "to": 5000}}
    >>> asked = {"name": "lightest", "designs": ["in-line-h2"], "axes": speed, "objectives": {"total_mass": "minimum"}}
    >>> with gw.search(type(gw.read_study("motor-speed")).model_validate(asked)) as looking:
    ...     looking.tell(looking.evaluate(looking.ask(4)))
    ...     print(*(f"{row.number('total_mass'):.1f} kg" for row in looking.front))
    138.2 kg
    """
    if study.search is None:
        study = study.model_copy(update={"search": Rules()})
    own = study.model_copy(update={"search": _rules(study).model_copy(update={"screened": 0})})
    problems = study_problems(own)
    if problems:
        raise DesignError(problems, study.name)
    if workers < 0:
        raise DesignError([Problem("workers", f"{workers} are asked; 0 computes in this process")])
    known = designs if designs is not None else {name: read(find_design(name)) for name in study.designs}
    return Search(own, known, Bench(own, known, journal=journal, workers=workers, anyway=anyway))


# ----------------------------------------------------------------------------------------------------------------------
# Optimisation of a study or of one design with given design variables, objectives and constraints.
# ----------------------------------------------------------------------------------------------------------------------


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
    constraints: Mapping[str, Bound] | None = None, search: Rules | None = None,
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
        "constraints": {**kept, **(constraints or {})}, "search": search or Rules(),
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
    study = study if study.search is not None else study.model_copy(update={"search": Rules()})
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


def restarted(
    found: Optimum,
    designs: Mapping[str, Design] | None = None,
    *,
    starts: int,
    workers: int = 0,
    tell: Tell | None = None,
) -> Optimum:
    """Return the answer of a search with how far the best of each objective may lie beyond it, by more searches.

    Each of them looks at as many designs, with the next seed. What they find tells the gap alone: the front stays.

    Args:
        found: From `optimise`, with the first seed.
        designs: As there.
        starts: Searches in all.
        workers: As there.
        tell: Called with what is being done.

    Raises:
        DesignError: As `optimise`; if fewer than one start is asked for.
    """
    if starts < 1:
        raise DesignError([Problem("starts", f"{starts} are asked for; give 1 or more")])
    rules, every = _rules(found.study), [found]
    for number in range(1, starts):
        (tell or _quiet)(f"start {number + 1} of {starts}")
        again = rules.model_copy(update={"seed": rules.seed + number})
        every.append(optimise(found.study.model_copy(update={"search": again}), designs, workers=workers, tell=tell))
    gaps = list[Gap]()
    for name, sense in found.study.objectives.items() if starts > 1 else ():
        sign = 1.0 if sense == "minimum" else -1.0
        best = [min(sign * own.row.number(name) for own in one.front) for one in every]
        gaps.append(Gap(name, sign * min(best), expected_gap(best)))
    return replace(found, starts=starts, gaps=tuple(gaps))


def _problems(workers: int) -> Sequence[Problem]:
    return [] if workers >= 0 else [Problem("workers", f"{workers} are asked; 0 computes in this process")]


def _quiet(_: str) -> None:
    """Say nothing."""


def _answered(bench: Bench, rules: Rules, course: Course, tell: Tell) -> Optimum:
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


def _polished(bench: Bench, rules: Rules, course: Course) -> tuple[list[Row], int]:
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
    rows = bench.rows([Case(number + k, start.design, dict(start.inputs)) for k, start in enumerate(every)])
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
