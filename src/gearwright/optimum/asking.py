"""Ask and tell: designs that are worth a look, their evaluation with a journal, and what came of them.

Any optimiser can drive the evaluation; without one, generations of NSGA-II answer what is asked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.optimum.course import Bench
from gearwright.optimum.freedoms import DESIGN, Judged, freedoms_of, judged_rows
from gearwright.optimum.generations import parents_of
from gearwright.optimum.optimum import Fit
from gearwright.shipped import find_design
from gearwright.showing import Shown
from gearwright.sizing import Named
from gearwright.spec import Design, Study, read
from gearwright.spec.studies import Search as Rules
from gearwright.spec.studies import Value, study_problems
from gearwright.study.cases import unit_sample
from gearwright.study.tables import Row
from gearwright.verbs import verb

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
            self._bench.known(case) or self._bench.keep(case.number, _answered(self.study, case.design, row, by(row)))
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


def _answered(study: Study, design: str, row: Asked, answer: Answer) -> Row:
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
