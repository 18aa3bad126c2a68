"""How likely it is that a design breaks a constraint of its study: which cases that takes, and what they say."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.ranking import largest_first
from gearwright.showing import Shown
from gearwright.spec import Study, value_at
from gearwright.spec.studies import Value
from gearwright.study.answers import Limit, Row, Table, confidence, left_of, limits_of
from gearwright.study.cases import Case, unit_sample
from gearwright.study.reliability import (
    Estimate,
    Point,
    chance_beyond,
    first_order,
    from_samples,
    importance,
    index_of,
    subset,
)

COUNTED = ("random", "sobol", "latin-hypercube")
"""Methods whose cases are simply counted."""


@dataclass(frozen=True)
class LimitState:
    """One limit that may be broken."""

    limit: Limit
    """Which one."""
    probability: float
    """That it is broken: to first order for the method ``form``, else as counted [-]."""
    likeliest: Mapping[str, Value]
    """Axis -> value in the likeliest failure that was found; empty where none was."""
    influence: Mapping[str, float]
    """Axis -> direction cosine of that failure [-]: their squares add up to 1; above 0 a larger value does harm."""
    settled: bool
    """False if the search for it did not come to rest."""

    @property
    def index(self) -> float:
        """Reliability index β [-]."""
        return index_of(self.probability)


@dataclass(frozen=True, repr=False)
class Reliability(Shown):
    """How likely it is that one design breaks any constraint of its study."""

    design: str
    """Its name."""
    probability: float
    """Of failure [-]."""
    interval: tuple[float, float]
    """Between which it lies with 95 % confidence [-]."""
    limits: tuple[LimitState, ...]
    """Every limit, the likeliest to be broken first."""
    evaluations: int
    """Cases that it took [-]."""
    failed: int
    """Cases that could not be built, counted as broken [-]."""
    settled: bool
    """False if the cases did not suffice, or a search did not come to rest: do not trust the probability then."""

    @property
    def index(self) -> float:
        """Reliability index β = −Φ⁻¹(p) [-]."""
        return index_of(self.probability)


def reliability(study: Study, table: Table) -> tuple[Reliability, ...]:
    """Return how likely it is that each design of a study breaks a constraint.

    Args:
        study: With axes that have distributions, and constraints; its method ``form``, ``subset``, or one that draws.
        table: Its rows, all of them.

    Raises:
        DesignError: If the study has no constraint, or its cases are no samples.
    """
    method = study.sampling.method
    if not study.constraints or method not in (*COUNTED, "form", "subset"):
        message = f'{method!r} gives no probability; take "form" or "subset", and give [constraints]'
        raise DesignError([Problem("sampling.method", message)])
    if method in COUNTED:
        return tuple(_counted(study, name, [row for row in table.rows if row.design == name]) for name in study.designs)
    search, rows = failures(study), list(table.rows)
    batch = next(search)
    while True:
        try:
            batch = search.send([rows.pop(0) for _ in batch])
        except StopIteration as end:
            found: tuple[Reliability, ...] = end.value
            return found


def failures(study: Study) -> Generator[list[Case], list[Row], tuple[Reliability, ...]]:
    """Yield one batch of cases after the other; send the rows of each to get the next, and in the end what they say.

    The cases follow from the seed and the rows alone, so that a study that was interrupted finds its way again.

    Args:
        study: With constraints, and the method ``form`` or ``subset``.
    """
    number, found = 0, list[Reliability]()
    for design in study.designs:
        generator = np.random.default_rng(study.sampling.seed)
        if study.sampling.method == "form":
            search = _first_order_then_draws(study, generator)
        else:
            limits, sampling = len(limits_of(study)), study.sampling
            search = subset(len(study.axes), limits, sampling.population, sampling.count or 0, generator)
        places, rows = next(search), list[Row]()
        while True:
            answers = yield [_case(study, design, number + k, place) for k, place in enumerate(places)]
            number += len(places)
            rows += answers
            try:
                places = search.send(_left(study, answers))
            except StopIteration as end:
                found.append(_said(study, design, end.value, rows))
                break
    return tuple(found)


def _first_order_then_draws(study: Study, generator: np.random.Generator) -> Generator[Floats, Floats, Estimate]:
    """Search the likeliest failures; draw about them with the evaluations that are left."""
    axes, count, used = len(study.axes), study.sampling.count or 0, 0
    search = first_order(axes, generator)
    places = next(search)
    while True:
        used += len(places)
        answers = yield places
        try:
            places = search.send(answers)
        except StopIteration as end:
            points: tuple[Point, ...] = end.value
            break
    if count <= used:
        return _bounded(points)
    return (yield from importance(points, axes, count - used, generator))


def _bounded(points: Sequence[Point]) -> Estimate:
    """Return what is known without draws: the likeliest limit alone, and all of them as if they never broke together.

    Source: Cornell 1967, bounds of a series system.
    """
    likely = [point.probability for point in points]
    most = float(1.0 - np.prod([1.0 - part for part in likely]))
    return Estimate(max(likely), (max(likely), most), tuple(points), all(point.settled for point in points))


def _case(study: Study, design: str, number: int, place: Floats) -> Case:
    return Case(number, design, _inputs(study, place))


def _inputs(study: Study, place: Floats) -> dict[str, Value]:
    """Return the values of all axes at a point of standard normal space."""
    return {
        path: value_at(path, axis, chance_beyond(-float(own)))
        for (path, axis), own in zip(study.axes.items(), place, strict=True)
    }


def _left(study: Study, rows: Sequence[Row]) -> Floats:
    """Return what is left of every limit; what no number is, is broken."""
    left = left_of(study, rows)
    kept: Floats = np.where(np.isnan(left), -np.inf, left)
    return kept


def _counted(study: Study, design: str, rows: Sequence[Row]) -> Reliability:
    left = _left(study, rows)
    broken = int((left <= 0.0).any(axis=1).sum())
    probability = broken / len(rows)
    from scipy.special import ndtri  # a third of a second to load, for workers who never ask

    places = ndtri(np.clip(unit_sample(study)[: len(rows)], np.finfo(float).tiny, 1.0 - 2.0**-53))
    points = from_samples(places, left, probability)
    return _said(study, design, Estimate(probability, confidence(broken, len(rows)), points, settled=True), rows)


def _said(study: Study, design: str, found: Estimate, rows: Sequence[Row]) -> Reliability:
    states = largest_first(_states(study, found.points), lambda state: state.probability)
    failed = sum(bool(row.problem) for row in rows)
    return Reliability(
        design, found.probability, found.interval, tuple(states), len(rows), failed, found.settled
    )  # fmt: skip


def _states(study: Study, points: Sequence[Point]) -> Iterator[LimitState]:
    for limit, point in zip(limits_of(study), points, strict=True):
        if not np.isfinite(point.place).all():
            yield LimitState(limit, point.probability, {}, {}, point.settled)
            continue
        distance = float(np.linalg.norm(point.place))
        cosines = point.place / distance if distance else point.place
        influence = dict(zip(study.axes, cosines.tolist(), strict=True))
        yield LimitState(limit, point.probability, _inputs(study, point.place), influence, point.settled)
