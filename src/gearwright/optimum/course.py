"""The course of a search: screening, generations until the hypervolume stands still, polish with teeth kept."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.optimum.bench import Bench
from gearwright.optimum.breeding import Parents
from gearwright.optimum.freedoms import freedoms_of, is_continuous
from gearwright.optimum.guided import Guided, parents_of
from gearwright.optimum.hypervolume import hypervolume
from gearwright.optimum.judging import Judged, judged_rows
from gearwright.optimum.optimum import Fit
from gearwright.optimum.polishing import ENOUGH
from gearwright.optimum.screening import parts_of, screening, starts
from gearwright.processes import computed
from gearwright.spec import Study
from gearwright.spec.studies import Search
from gearwright.study.answers import FAILED, Blocks, Row, blocks_of
from gearwright.study.cases import goes_together

BEYOND = 0.1
"""Of the span of the first good designs, by which the reference of the hypervolume lies beyond its worst values [-]."""
Tell = Callable[[str], None]


class Archive:
    """Good designs that no other one dominates, of all that were looked at."""

    def __init__(self, study: Study) -> None:
        objectives, constraints = len(study.objectives), len(study.constraints)
        self.rows: list[Row] = []
        self.judged = Judged(np.zeros((0, objectives)), np.zeros((0, constraints)))
        self.refusal = ""
        """Why the first design that could not be sized is refused."""
        self.nearest: Row | None = None
        """Of all that could be sized, the one that breaks the constraints least, for as long as none keeps them."""
        self.least_broken = np.full(constraints, np.inf)
        """By how much each constraint is broken at least, over its bound [-]."""
        self._least = np.inf
        self._listed = [path for path, axis in study.axes.items() if not is_continuous(axis)]
        self._best: dict[Hashable, tuple[float, Row]] = {}
        """Design and values of lists -> least first objective of those that are good, and its row."""

    def add(self, rows: Sequence[Row], own: Judged) -> None:
        """Take in designs, and keep those that no other one dominates.

        Args:
            rows: Designs with their results.
            own: What is known of them.
        """
        self._miss(rows, own)
        self.refusal = self.refusal or next((row.problem for row in rows if row.problem), "")
        for k in np.flatnonzero(own.good).tolist():
            key, value = self._kind(rows[k]), float(own.values[k, 0])
            if value < self._best.get(key, (np.inf,))[0]:
                self._best[key] = value, rows[k]
        rows, judged = [*self.rows, *rows], self.judged.joined(own)
        good = np.flatnonzero(judged.good)
        best = good[judged.take(good).ranks == 0]
        _, first = np.unique(judged.values[best], axis=0, return_index=True)
        best = best[np.sort(first)]
        self.rows, self.judged = [rows[k] for k in best.tolist()], judged.take(best)

    def beside(self, count: int) -> list[Row]:
        """Return the best designs with other values of lists than the front has, one of each, by the first objective.

        Args:
            count: At most [-].
        """
        met = {self._kind(row) for row in self.rows}
        ordered = sorted(self._best.items(), key=lambda item: item[1][0])
        return [row for key, (_, row) in ordered if key not in met][:count]

    def _kind(self, row: Row) -> Hashable:
        return (row.design, *(row.inputs[path] for path in self._listed))

    def _miss(self, rows: Sequence[Row], own: Judged) -> None:
        """Take in by how much designs miss what is asked."""
        if len(rows) and own.violation.min() < min(self._least, FAILED):
            place = int(own.violation.argmin())
            self.nearest, self._least = rows[place], float(own.violation[place])
        self.least_broken = np.minimum(self.least_broken, own.broken[~own.failed].min(axis=0, initial=np.inf))


class Course(NamedTuple):
    """Where a search has come to."""

    archive: Archive
    number: int
    """Of the next evaluation."""
    growth: tuple[float, ...]
    still: bool
    parents: Parents | Guided
    """The best that were bred."""


def followed(bench: Bench, rules: Search, *, workers: int, tell: Tell) -> Course:
    """Return what screening and generations find.

    Args:
        bench: What evaluates.
        rules: Of the search.
        workers: Processes.
        tell: Called with what is being done.
    """
    study = bench.study
    first = len(study.designs) * rules.screened
    archive = Archive(study)
    parents = parents_of(study, rules)
    if rules.screened and goes_together(study):
        blocks = _screened(bench, rules, workers, tell)
        if len(blocks):
            places, own = starts(study, blocks)
            parents.add(places, own)
            archive.add([row for _, row in sorted(blocks, key=lambda pair: pair[0])], own)
    growth, still, number = list[float](), False, first
    for values, number in _bred(bench, rules, parents, archive, first):  # noqa: B007
        growth.append(values)
        still = stands_still(growth, rules)
        size = f"{len(archive.rows)} on the front, hypervolume {values:.4f}"
        tell(f"generation {len(growth)}: {size}{_errors(parents.fits)}")
        if still:
            break
    return Course(archive, number, tuple(growth), still, parents)


def _errors(fits: Sequence[Fit]) -> str:
    """Return words on how well surrogates foretell what they are not told, where there are any."""
    return "; foretold wrong by " + ", ".join(f"{fit.result} {100 * fit.error:.0f} %" for fit in fits) if fits else ""


def stands_still(growth: Sequence[float], rules: Search) -> bool:
    """Tell whether the hypervolume has not grown for as many generations as end a search.

    Args:
        growth: After every generation.
        rules: Of the search.
    """
    if len(growth) <= rules.still or growth[-1] <= 0.0:
        return False
    before = growth[-1 - rules.still]
    return growth[-1] - before <= rules.growth * growth[-1]


def _screened(bench: Bench, rules: Search, workers: int, tell: Tell) -> Blocks:
    """Return what the first layer keeps, part after part into the journal."""
    parts = list(parts_of(bench.study, rules))
    kept = list[tuple[int, Row]]()
    missing = []
    for part in parts:
        own = bench.known_between(part.number, part.number + part.points)
        kept += own
        missing += [] if own else [part]
    done = sum(part.points for part in parts) - sum(part.points for part in missing)
    tell(f"screening {sum(part.points for part in parts):,} designs, {done:,} of them done before")
    for part, found in computed(screening(bench.study, bench.designs), missing, min(workers, len(missing))):
        bench.append(found.blocks)
        kept += list(found.blocks)
        done += part.points
        tell(f"screened {done:,}; of the last {part.points:,} {found.sized:,} can be sized")
    return blocks_of(sorted(kept, key=lambda pair: pair[0]))


def _bred(
    bench: Bench, rules: Search, parents: Parents | Guided, archive: Archive, first: int
) -> Iterator[tuple[float, int]]:
    """Yield the hypervolume after every generation, and the number of the evaluation that is next."""
    freedoms, generator = freedoms_of(bench.study), np.random.default_rng(rules.seed)
    left, number = _for_generations(rules), first
    box: tuple[Floats, Floats] | None = None
    while left > 0:
        count = min(rules.population, left)
        places = (
            parents.children(count, generator)
            if len(parents.places) > 1
            else generator.random((count, len(freedoms.names)))
        )
        rows = bench.rows([freedoms.case(number + k, freedoms.row(place)) for k, place in enumerate(places)])
        number, left = number + count, left - count
        own = judged_rows(bench.study, rows)
        parents.add(places, own)
        archive.add(rows, own)
        box = box or _box(parents.judged.values[parents.judged.good])
        yield (0.0 if box is None else covered(archive.judged.values, box)), number


def _for_generations(rules: Search) -> int:
    """Return the evaluations of generations: three quarters, where the rest suffices for a polish."""
    kept = rules.evaluations // 4
    return rules.evaluations - (kept if polishable(rules, kept) else 0)


def polishable(rules: Search, evaluations: int) -> int:
    """Return how many designs so many evaluations polish [-]: few that are polished are worth more than many begun.

    Args:
        rules: Of the search.
        evaluations: That are left.
    """
    return min(rules.polished, evaluations // ENOUGH)


def _box(values: Floats) -> tuple[Floats, Floats] | None:
    """Return ideal and reference of the first good designs; nothing where there are none."""
    if not len(values):
        return None
    low, high = values.min(axis=0), values.max(axis=0)
    span = np.where(high > low, high - low, np.maximum(np.abs(high), 1e-300) * BEYOND)
    return low, high + BEYOND * span


def covered(values: Floats, box: tuple[Floats, Floats]) -> float:
    """Return the part of a box that a front dominates; above 1 where it grows beyond the first ideal [-].

    Args:
        values: Of the front.
        box: Ideal and reference.
    """
    low, high = box
    return hypervolume((values - low) / (high - low), np.ones(len(low)))
