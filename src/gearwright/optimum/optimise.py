"""Optimisation of a study or of a design, what binds its optimum, shadow prices, and why none exists."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import (
    Bools,
    Check,
    DesignError,
    Floats,
    GearwrightError,
    Problem,
    Shown,
    SolveError,
    largest_first,
    margin_text,
    refuse,
    smallest_first,
    verb,
)
from gearwright.optimum.course import Archive, Bench, Compass, Course, Tell, followed, polishable, rounds
from gearwright.optimum.generations import (
    DESIGN,
    Fixed,
    Judged,
    freedoms_of,
    is_continuous,
    judged_rows,
    parents_of,
    place_of,
    sizes_of,
    sizing_of,
    teeth_of,
    with_teeth,
)
from gearwright.optimum.optimum import Best, Binding, Counts, Fit, Gap, Influence, Optimum, Price, Regret, expected_gap
from gearwright.shipped import find_design
from gearwright.sizing import Named, Sizing
from gearwright.spec import (
    Axis,
    Bound,
    Design,
    Search as Rules,
    Study,
    Value,
    path_problem,
    read,
    standing_at,
    study_problems,
    value_at,
)
from gearwright.study.cases import Case, unit_sample
from gearwright.study.tables import Row

# ----------------------------------------------------------------------------------------------------------------------
# What keeps a design from being better: checks at their limits, constraints at their bounds, ranges at their ends.
# ----------------------------------------------------------------------------------------------------------------------


NEAR = 0.02
"""Of a limit within which it binds [-]."""
AT_END = 1e-3
"""Of a range within which its end binds [-]."""
DIGITS = 6
"""To which margins are told apart in their order: beyond is rounding [-]."""
FEW_LIMITS = 6
"""Limits that are named of each design [-]."""


def best_of(study: Study, designs: Mapping[str, Design], row: Row, *, polished: bool) -> Best:
    """Return a design of the front with what binds it, and its teeth.

    Args:
        study: With its changes and constraints.
        designs: Name -> design.
        row: That could be sized.
        polished: Whether its sizes were polished.
    """
    try:
        sizing = sizing_of(study, designs, row)
    except GearwrightError:
        return Best(row, bindings(study, row, ()), {}, polished)
    teeth: dict[str, tuple[int, ...]] = {}
    for gear in sizing.gears:
        teeth[gear.stage] = (*teeth.get(gear.stage, ()), gear.teeth)
    return Best(row, bindings(study, row, sizing.checks), teeth, polished)


def bindings(study: Study, row: Row, checks: Iterable[Check]) -> tuple[Binding, ...]:
    """Return what binds a design, the nearest first.

    Args:
        study: With its constraints.
        row: That could be sized.
        checks: Of its sizing.
    """
    found = [*_checks(checks), *_constraints(study, row)]
    found.sort(key=lambda binding: round(binding.margin, DIGITS))
    return (*found[:FEW_LIMITS], *_ends(study, row))


def _checks(checks: Iterable[Check]) -> Iterator[Binding]:
    nearest: dict[str, float] = {}
    for check in checks:
        if check.margin is not None and not check.waiver and check.margin <= 1.0 + NEAR:
            nearest.setdefault(check.name, check.margin)
    yield from (Binding("check", name, margin) for name, margin in nearest.items())


def _constraints(study: Study, row: Row) -> Iterator[Binding]:
    for name, bound in study.constraints.items():
        value = row.shown(name)
        for limit, margin in (
            (bound.minimum, _ratio(value, bound.minimum)),
            (bound.maximum, _ratio(bound.maximum, value)),
        ):
            if limit is not None and math.isfinite(margin) and margin <= 1.0 + NEAR:
                yield Binding("constraint", name, margin)


def _ratio(value: float | None, limit: float | None) -> float:
    return value / limit if value is not None and limit else math.inf


def _ends(study: Study, row: Row) -> Iterator[Binding]:
    for path, axis in study.axes.items():
        if is_continuous(axis) and path in row.inputs:
            place = place_of(path, axis, row.inputs[path])
            if place <= AT_END or place >= 1.0 - AT_END:
                yield Binding("end of a range", path, 1.0)


# ----------------------------------------------------------------------------------------------------------------------
# Shadow prices: by how much every objective falls when a limit is relaxed by one per cent, and the design follows.
# ----------------------------------------------------------------------------------------------------------------------


RELAXED = 0.02
"""By which a limit is relaxed: far above rounding, near enough to be a slope [-]."""
LIMITS: Mapping[str, float] = {
    "gears.bending_safety": -1.0, "gears.contact_safety": -1.0, "gears.iso6336.bending_safety": -1.0,
    "gears.iso6336.pitting_safety": -1.0, "gears.iso6336.scuffing_safety": -1.0, "shafting.safety": -1.0,
    "carriers.safety": -1.0, "service.life_h": -1.0, "service.bearing_life_h": -1.0,
    "teeth.speed_tolerance": 1.0, "teeth.stage_tolerance": 1.0,
}  # fmt: skip
"""Path of a rule that every design owes -> which way relaxes it [-]."""


class _Relaxed(NamedTuple):
    """The search with one limit relaxed."""

    limit: str
    kind: str
    study: Study
    changes: Mapping[str, Value]


def prices_of(bench: Bench, answer: Optimum, values: Floats) -> tuple[Price, ...]:
    """Return what limits cost the chosen design, the dearest first.

    Teeth are kept and ranges polished, with every limit in turn relaxed by a little; against the same polish without.

    Args:
        bench: What evaluates; these designs are not kept.
        answer: With its front.
        values: Its objectives, shape (designs, objectives).
    """
    start = with_teeth(answer.study, bench.designs, answer.best.row)
    if start is None:
        return ()
    free = [_Relaxed("", "", answer.study, {}), *_relaxed_rules(bench, answer), *_bounds(answer)]
    span = np.maximum(np.ptp(values, axis=0), 1e-3 * np.abs(values).max(axis=0) + 1e-300)
    found = _polished_relaxed(bench, start, free, span)
    if found[0] is None:
        return ()
    signs = np.array([1.0 if sense == "minimum" else -1.0 for sense in answer.study.objectives.values()])
    prices = []
    for relaxed, own in zip(free[1:], found[1:], strict=True):
        if own is not None:
            change = signs * (own - found[0]) / (100.0 * RELAXED)
            prices.append(
                Price(relaxed.limit, relaxed.kind, dict(zip(answer.objectives, change.tolist(), strict=True)))
            )
    return tuple(largest_first(prices, lambda price: _weight(price, span, answer)))


def _weight(price: Price, span: Floats, answer: Optimum) -> float:
    return float(sum(abs(price.changes[name]) / width for name, width in zip(answer.objectives, span, strict=True)))


def _relaxed_rules(bench: Bench, answer: Optimum) -> Iterator[_Relaxed]:
    """Yield the rules of the chosen design, each relaxed."""
    design = bench.designs[answer.best.row.design]
    for path, way in LIMITS.items():
        if path_problem(design, path) is None and path not in answer.study.axes:
            stands = answer.study.changes.get(path, standing_at(design, path).value)
            if isinstance(stands, int | float) and stands:
                yield _Relaxed(path, "rule", answer.study, {path: float(stands) * (1.0 + way * RELAXED)})


def _bounds(answer: Optimum) -> Iterator[_Relaxed]:
    """Yield the constraints of the study and the ends of ranges that bind, each relaxed."""
    study = answer.study
    bound = {(binding.kind, binding.name) for binding in answer.best.binds}
    for name, own in study.constraints.items():
        if ("constraint", name) in bound:
            relaxed = own.model_copy(update={
                "minimum": None if own.minimum is None else own.minimum - RELAXED * abs(own.minimum),
                "maximum": None if own.maximum is None else own.maximum + RELAXED * abs(own.maximum),
            })  # fmt: skip
            wider = study.model_copy(update={"constraints": {**study.constraints, name: relaxed}})
            yield _Relaxed(name, "constraint", wider, {})
    for path, axis in study.axes.items():
        if ("end of a range", path) in bound and axis.first is not None and axis.last is not None:
            room = RELAXED * (axis.last - axis.first)
            wide = axis.model_copy(
                update={"first": max(axis.first - room, min(axis.first, 0.0)), "last": axis.last + room}
            )
            yield _Relaxed(path, "end of a range", study.model_copy(update={"axes": {**study.axes, path: wide}}), {})


def _polished_relaxed(bench: Bench, start: Fixed, free: list[_Relaxed], span: Floats) -> list[Floats | None]:
    """Return the objectives to which the chosen design comes under each relaxation; nothing where it cannot be."""
    continuous = any(map(is_continuous, free[0].study.axes.values()))
    begun = [Fixed(start.design, {**start.inputs, **relaxed.changes}) for relaxed in free]
    rows = bench.tried([Case(k, own.design, dict(own.inputs)) for k, own in enumerate(begun)])
    found: list[Floats | None] = []
    compasses: dict[int, Compass] = {}
    for k, (relaxed, row) in enumerate(zip(free, rows, strict=True)):
        own = judged_rows(relaxed.study, [row])
        found.append(own.values[0] if own.good[0] else None)
        if own.good[0] and continuous:
            compasses[k] = Compass(begun[k], relaxed.study.axes, own, span)
    numbers = {id(compass): k for k, compass in compasses.items()}
    for going, tried in rounds(list(compasses.values()), 1):
        cases = list[Case]()
        for compass, places in zip(going, tried, strict=True):
            cases += [
                Case(len(cases) + n, compass.start.design, compass.inputs(place)) for n, place in enumerate(places)
            ]
        answers = iter(bench.tried(cases))
        for compass, places in zip(going, tried, strict=True):
            own_rows = [next(answers) for _ in places]
            number = numbers[id(compass)]
            compass.note(places, own_rows, judged_rows(free[number].study, own_rows))
            found[number] = compass.judged.values[0]
    return found


# ----------------------------------------------------------------------------------------------------------------------
# Doubt: what becomes of the front and of its choice where assumptions turn out otherwise.
# ----------------------------------------------------------------------------------------------------------------------


COMPARED = 24
"""Designs of the front that are held against each other, the chosen one among them [-]."""
LOW, HIGH = 0.16, 0.84
"""Between which 68 % of all that may come lies [-]."""
BAND = (0.05, 0.95)


def regrets_of(bench: Bench, answer: Optimum, values: Floats) -> tuple[Regret, ...]:
    """Return how designs of the front do in samples of what is uncertain, the chosen one first.

    In every sample all are sized anew with their teeth kept; a design regrets by how much its objectives, over the span
    of the front and each weighing the same, are worse than those of the best of that sample.

    Args:
        bench: What evaluates; these designs are not kept.
        answer: With its front.
        values: Its objectives, shape (designs, objectives).
    """
    study = answer.study
    if not study.uncertain or study.search is None:
        return ()
    places = _compared(answer)
    sizings = [sizing_of(study, bench.designs, answer.front[place].row) for place in places]
    samples = _samples(study, study.search.samples, study.search.seed)
    merits, spreads = [], []
    span, ideal = np.maximum(np.ptp(values, axis=0), 1e-300), values.min(axis=0)
    for place, sizing in zip(places, sizings, strict=True):
        fixed = _kept(answer, place, teeth_of(sizing))
        own = judged_rows(study, bench.tried([_case(k, fixed, sample) for k, sample in enumerate(samples)]))
        merits.append(np.where(own.good, ((own.values - ideal) / span).mean(axis=1), np.inf))
        spreads.append(_bands(study, own.values[~own.failed]))
    merit = np.array(merits)
    least = merit.min(axis=0)
    some = np.isfinite(least)
    regret = merit[:, some] - least[some]
    best = merit[:, some].argmin(axis=0)
    keeps = [_keeps(bench, answer, place, sizing, samples) for place, sizing in zip(places, sizings, strict=True)]
    late = np.quantile(regret, 0.95, axis=1, method="higher")
    return tuple(
        Regret(place, float((best == k).mean()), float(regret[k].mean()), float(late[k]), keeps[k], spreads[k])
        for k, place in enumerate(places)
    )


def _compared(answer: Optimum) -> list[int]:
    """Return the chosen design, then others evenly along the front."""
    others = np.unique(np.linspace(0, len(answer.front) - 1, COMPARED).astype(int)).tolist()
    return [answer.chosen, *(place for place in others if place != answer.chosen)]


def _kept(answer: Optimum, place: int, more: Mapping[str, Value]) -> Fixed:
    row = answer.front[place].row
    return Fixed(row.design, {**row.inputs, **more})


def _case(number: int, fixed: Fixed, sample: Mapping[str, Value]) -> Case:
    return Case(number, fixed.design, {**fixed.inputs, **sample})


def _samples(study: Study, count: int, seed: int) -> list[dict[str, Value]]:
    """Return samples of what is uncertain: scrambled Sobol' points."""
    sampling = study.sampling.model_copy(update={"method": "sobol", "count": count, "seed": seed})
    cube = unit_sample(study.model_copy(update={"axes": study.uncertain, "sampling": sampling}))
    axes = list(study.uncertain.items())
    return [
        {path: value_at(path, axis, float(own)) for (path, axis), own in zip(axes, place, strict=True)}
        for place in cube
    ]


def _bands(study: Study, values: Floats) -> dict[str, tuple[float, float]]:
    """Return the band of every objective, in its own sense."""
    band = {}
    for (name, sense), column in zip(study.objectives.items(), values.T, strict=True):
        own = column if sense == "minimum" else -column
        band[name] = (
            (float(np.quantile(own, BAND[0])), float(np.quantile(own, BAND[1]))) if len(own) else (np.nan, np.nan)
        )
    return band


def _keeps(bench: Bench, answer: Optimum, place: int, sizing: Sizing, samples: Sequence[Mapping[str, Value]]) -> float:
    """Return in which part of the samples a design keeps the constraints as it was built."""
    fixed = _kept(answer, place, {**teeth_of(sizing), **sizes_of(sizing)})
    own = judged_rows(answer.study, bench.tried([_case(k, fixed, sample) for k, sample in enumerate(samples)]))
    good: Bools = own.good
    return float(good.mean())


def influences_of(bench: Bench, answer: Optimum, values: Floats) -> tuple[Influence, ...]:
    """Return what each assumption alone does, from its 16 to its 84 % quantile, all others at their medians.

    Args:
        bench: What evaluates; these designs are not kept.
        answer: With its front.
        values: Its objectives, shape (designs, objectives).
    """
    study = answer.study
    medians = {path: value_at(path, axis, 0.5) for path, axis in study.uncertain.items()}
    places = _compared(answer)
    span, ideal = np.maximum(np.ptp(values, axis=0), 1e-300), values.min(axis=0)
    signs = [1.0 if sense == "minimum" else -1.0 for sense in study.objectives.values()]
    found = []
    for path, axis in study.uncertain.items():
        ends, chosen = [], []
        for quantile in (LOW, HIGH):
            sample = {**medians, path: value_at(path, axis, quantile)}
            own = judged_rows(
                study, bench.tried([_case(k, _kept(answer, place, {}), sample) for k, place in enumerate(places)])
            )
            away = np.where(own.good[:, None], (own.values - ideal) / span, np.inf).max(axis=1)
            ends.append(own.values[0])
            chosen.append(places[int(np.argmin(away))])
        change = {name: sign * float(high - low)
                  for name, sign, low, high in zip(study.objectives, signs, *ends, strict=True)}  # fmt: skip
        low, high = (float(value_at(path, axis, quantile)) for quantile in (LOW, HIGH))
        found.append(Influence(path, low, high, change, (chosen[0], chosen[1])))
    return tuple(
        sorted(
            found,
            key=lambda own: (
                -sum(abs(own.changes[name]) / width for name, width in zip(study.objectives, span, strict=True))
            ),
        )
    )


# ----------------------------------------------------------------------------------------------------------------------
# Why a search has found nothing: the design that comes nearest, what it misses, and which checks keep it from it.
# ----------------------------------------------------------------------------------------------------------------------


FEW_CHECKS = 3
"""Checks that are named [-]."""


def shortfall(study: Study, designs: Mapping[str, Design], archive: Archive) -> list[Problem]:
    """Return why no design of a search is good.

    Args:
        study: With its constraints.
        designs: Name -> design.
        archive: Everything that was looked at, none of it good.
    """
    if archive.nearest is None:
        return [Problem("axes", f"every design is refused, the first with {archive.refusal}")]
    row = archive.nearest
    problems = list(_missed(study, archive, row))
    at = ", ".join(f"{path} = {value:.6g}" if isinstance(value, float) else f"{path} = {value}"
                   for path, value in row.inputs.items())  # fmt: skip
    failing = "; ".join(_failing(study, designs, row))
    told = f"the nearest of all that were looked at is {row.design}: {at}"
    why = f"; its sizing fails {failing}" if failing else ""
    return [*problems, Problem("axes", f"{told}{why}: free what these depend on, or widen the axes")]


def _missed(study: Study, archive: Archive, row: Row) -> Iterator[Problem]:
    """Yield every constraint that the nearest design breaks, and how near any design comes to it."""
    for name, least in zip(study.constraints, archive.least_broken.tolist(), strict=True):
        value, bound = row.shown(name), study.constraints[name]
        for limit, over in ((bound.minimum, -1.0), (bound.maximum, 1.0)):
            if limit is not None and over * (value - limit) > 0.0:
                asked = f"at {'least' if over < 0.0 else 'most'} {limit:g} is asked"
                share = abs(value - limit) / (abs(limit) or 1.0)
                others = "others come nearer and break another" if least < share * (1.0 - 1e-9) else "none comes nearer"
                reached = f"the nearest design has {value:.4g}, {100 * share:.1f} % off; {others}"
                yield Problem(f"constraints.{name}", f"{asked}, and {reached}: relax it")


def _failing(study: Study, designs: Mapping[str, Design], row: Row) -> Iterator[str]:
    """Yield the checks of its sizing that fail, the worst first."""
    try:
        checks = sizing_of(study, designs, row).checks
    except GearwrightError:
        return
    worst = smallest_first((check for check in checks if check.fails), lambda check: check.margin or 0.0)
    yield from (f"{check.name} ({margin_text(check.margin or 0.0)} of what is asked)" for check in worst[:FEW_CHECKS])


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
    axes = {name: next(iter(study.axes.values())) for name in freedoms_of(study).names}
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
