"""The course of an optimisation: screening, generations, local search, and evaluation by workers."""

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from contextlib import ExitStack, closing
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, GearwrightError, Ints, Problem, refuse
from gearwright.optimum.generations import (
    Fixed,
    Guided,
    Judged,
    Parents,
    freedoms_of,
    is_continuous,
    judged,
    judged_columns,
    judged_rows,
    parents_of,
    place_of,
)
from gearwright.optimum.optimum import Fit, hypervolume
from gearwright.processes import computed
from gearwright.signals import heard_after
from gearwright.sizing import in_lanes
from gearwright.spec import Axis, Design, Search, Study, Value, axis_length, edited, value_at
from gearwright.study.cases import Case, goes_together, refuse_unknown_paths
from gearwright.study.journal import Journal, begin, in_memory, opened, recorded
from gearwright.study.running import refuse_changes
from gearwright.study.tables import FAILED, Blocks, Row, block_of_columns, blocks_of, crowding, non_dominated
from gearwright.study.workers import Compute, local

# ----------------------------------------------------------------------------------------------------------------------
# Where designs are evaluated: by workers, each kept in the journal as soon as it is finished, none computed twice.
# ----------------------------------------------------------------------------------------------------------------------


class Bench:
    """What evaluates the designs of one search, and remembers them."""

    def __init__(
        self, study: Study, designs: Mapping[str, Design], *, journal: Path | None, workers: int, anyway: bool = False
    ) -> None:
        self.study, self.designs = study, designs
        self.computed = 0
        """Designs that were evaluated since it was opened [-]."""
        self._open = ExitStack()
        try:
            refuse_unknown_paths(study, designs)
            self.book = self._book(journal, anyway=anyway)
            self.compute: Compute = self._open.enter_context(local(study, designs, workers))
            self.book.begin_run(workers)
        except BaseException:
            self._open.close()
            raise
        self._known = dict(self._kept()) if journal is not None else {}

    def _book(self, journal: Path | None, *, anyway: bool) -> Journal:
        """Return the journal, begun anew or gone on with."""
        if journal is None:
            book = in_memory(self.study, self.designs)
            self._open.enter_context(closing(book.database))
            return book
        if journal.exists():
            known = recorded(journal)
            if known.study != self.study:
                message = f"is of another search, {known.study.name!r}, or of one that asks for something else"
                refuse([Problem("journal", f"{journal} {message}; name another file, or take this one away")])
            if not anyway:
                refuse_changes(journal, known, self.designs)
        else:
            begin(journal, self.study, self.designs)
        return self._open.enter_context(opened(journal))

    def _kept(self) -> Iterator[tuple[int, Row]]:
        numbers = sorted(self.book.finished())
        yield from zip(numbers, self.book.rows(numbers), strict=True)

    def close(self) -> None:
        """End the workers and let the journal go."""
        self._open.close()

    def rows(self, cases: Sequence[Case]) -> list[Row]:
        """Return the rows of cases, those of the journal as they stand there.

        Args:
            cases: With numbers of their own.

        Raises:
            DesignError: If the journal has something else under a number.
        """
        found: dict[int, Row] = {}
        for blocks in self._finished(cases):
            found.update(blocks)
        return [found[case.number] for case in cases]

    def tried(self, cases: Sequence[Case]) -> list[Row]:
        """Return the rows of cases that are not kept: what follows from an answer and is soon computed again.

        Args:
            cases: Numbered from 0.
        """
        found: dict[int, Row] = {}
        for finished in self.compute(iter(cases), len(cases)):
            found.update(finished)
        return [found[case.number] for case in cases]

    def _finished(self, cases: Sequence[Case]) -> Iterator[Blocks]:
        """Yield cases in any order: those of the journal, then those that are computed."""
        missing = list[Case]()
        kept = list[tuple[int, Row]]()
        for case in cases:
            row = self.known(case)
            if row is None:
                missing.append(case)
            else:
                kept.append((case.number, row))
        if kept:
            yield blocks_of(kept)
        for finished in self.compute(iter(missing), len(missing)) if missing else ():
            blocks = blocks_of(finished)
            self.book.append(blocks)
            self.computed += len(blocks)
            yield blocks

    def known_between(self, first: int, end: int) -> list[tuple[int, Row]]:
        """Return number and row of what the journal has from one number up to another.

        Args:
            first: Number of a case.
            end: Number behind the last.
        """
        return [(number, row) for number, row in sorted(self._known.items()) if first <= number < end]

    def append(self, blocks: Blocks) -> None:
        """Keep cases that were computed elsewhere.

        Args:
            blocks: Finished cases.
        """
        self.book.append(blocks)
        self.computed += len(blocks)

    def known(self, case: Case) -> Row | None:
        """Return the row that the journal has of a case; None where it has none.

        Args:
            case: With its number.

        Raises:
            DesignError: If the journal has something else under its number.
        """
        row = self._known.get(case.number)
        if row is not None and (row.design, dict(row.inputs)) != (case.design, case.inputs):
            message = f"its evaluation {case.number} is of other inputs; it was made by another driver or seed"
            refuse([Problem("journal", f"{message}: drive it as it was begun, or name another file")])
        return row

    def keep(self, number: int, row: Row) -> Row:
        """Return a row that was computed elsewhere, kept under its number.

        Args:
            number: Of the evaluation, which the journal does not have.
            row: With its results.
        """
        self.book.append([(number, row)])
        self.computed += 1
        return row


# ----------------------------------------------------------------------------------------------------------------------
# The first layer: points that fill the axes and their ends, sized together in columns, of which each part keeps few.
#
# What is kept is the front, the best of every section of every range, and the best with any values of lists: what is
# best in the end may lie in another valley than the best of the points. Every second point is drawn apart, so that
# ranges have points at their ends, where what is best often lies. What cannot be sized together is left out and
# counted: this layer only says where generations begin.
# ----------------------------------------------------------------------------------------------------------------------


LEAST, MOST = 4096, 131_072
"""Points that are sized at once: the more the quicker each, the fewer the less is lost when it is stopped [-]."""
KEPT = 64
"""Of the front of each part, and of its values of lists, at most [-]."""
SECTIONS = 8
"""Of every range, beside its two ends [-]."""
APART = 1.5
"""By which every second point is drawn apart: a sixth of them stands at either end of a range [-]."""
NONE = "none of this part can be sized together with others, or all are refused"
"""Reason of the row that stands for a part without any."""


class Part(NamedTuple):
    """Some of the points of one design."""

    design: str
    number: int
    """Of its first case in the journal."""
    first: int
    """Its first point in the sequence."""
    points: int


class Screened(NamedTuple):
    """What a part keeps."""

    blocks: Blocks
    sized: int
    """Points that were sized [-]."""


def parts_of(study: Study, search: Search) -> Iterator[Part]:
    """Yield the parts of the first layer.

    Args:
        study: With designs.
        search: Its table.
    """
    size = min(max(LEAST, 1 << max(search.screened // 8 - 1, 1).bit_length()), MOST)
    for place, name in enumerate(study.designs):
        for first in range(0, search.screened, size):
            yield Part(name, place * search.screened + first, first, min(size, search.screened - first))


def screened(study: Study, designs: Mapping[str, Design], part: Part) -> Screened:
    """Return the best of a part: of those that keep the constraints, or break them least, what none dominates.

    Args:
        study: With axes, objectives and constraints.
        designs: Name -> design.
        part: Which points.
    """
    places = _places(study, part)
    columns = {path: _values(path, axis, places[:, k]) for k, (path, axis) in enumerate(study.axes.items())}
    try:
        base = edited(
            designs[part.design], {path: value for path, value in study.changes.items() if path not in columns}
        )
    except GearwrightError as error:
        return Screened(_none(part, columns, str(error)), 0)
    found, _ = in_lanes(base, columns, study.asked, count=part.points)
    sized = found.done.copy()
    for name in study.asked:
        sized &= ~np.isnan(found.values.get(name, np.full(part.points, np.nan)))
    place = np.flatnonzero(sized)
    if not len(place):
        return Screened(_none(part, columns, NONE), 0)
    own = judged_columns(study, {name: (found.values[name][place], found.dimensions[name]) for name in study.asked})
    place = place[_best(own, _cells(study, places[place]))]
    inputs = {path: [values[k] for k in place.tolist()] for path, values in columns.items()}
    results = {name: (found.values[name][place], found.dimensions[name]) for name in study.asked}
    return Screened(block_of_columns(part.design, place + part.number, inputs, results), int(sized.sum()))


def _none(part: Part, columns: Mapping[str, list[object]], why: str) -> Blocks:
    inputs = {path: values[0] for path, values in columns.items()}
    return blocks_of([(part.number, Row(part.design, inputs, {}, why))])  # type: ignore[arg-type]


def _best(own: Judged, cells: Sequence[Ints]) -> Ints:
    """Return which are kept, in their order: the front (of a large one those that stand freest), the best of cells."""
    scale = np.maximum(np.ptp(own.values, axis=0), 1e-300)
    order = np.lexsort(((own.values / scale).sum(axis=1), own.violation))
    best = order[non_dominated(own.values[order], own.violation[order])]
    if len(best) > KEPT:
        best = best[np.argsort(-crowding(own.values[best], np.zeros(len(best), dtype=np.int64)), kind="stable")[:KEPT]]
    for cell in cells:
        _, first = np.unique(cell[order], return_index=True)
        best = np.union1d(best, order[np.sort(first)[:KEPT]])
    return best


def _cells(study: Study, places: Floats) -> list[Ints]:
    """Return the section of every range in which points lie, ends apart, and the number of their values of lists."""
    ranges, listed = list[Ints](), np.zeros(len(places), dtype=np.int64)
    for (path, axis), own in zip(study.axes.items(), places.T, strict=True):
        if is_continuous(axis):
            ranges.append((np.floor(own * SECTIONS) + (own > 0.0)).astype(np.int64))
        else:
            length = axis_length(path, axis)
            listed = listed * length + np.minimum(own * length, length - 1).astype(np.int64)
    return [*ranges, listed]


def _places(study: Study, part: Part) -> Floats:
    """Return the points of a part in the unit cube, shape (points, axes)."""
    assert study.search is not None
    # Some of a scrambled Sobol' sequence, shape (points, axes).
    axes = len(study.axes)
    from scipy.stats import qmc

    with heard_after():  # its first numbers are read in C, which swallows what is raised in it
        sequence = qmc.Sobol(axes, rng=np.random.default_rng(study.search.seed))
    if part.first:
        sequence.fast_forward(part.first)
    places = np.asarray(sequence.random(1 << (part.points - 1).bit_length()))[: part.points]
    ranges = [is_continuous(axis) and axis.distribution != "normal" for axis in study.axes.values()]
    apart = np.clip(APART * (places[1::2] - 0.5) + 0.5, 0.0, 1.0)
    places[1::2] = np.where(ranges, apart, places[1::2])
    return places


def _values(path: str, axis: Axis, places: Floats) -> list[object]:
    """Return the values of an axis at some places, with the bits of `value_at`."""
    if axis.values is None and axis.step is None and axis.distribution == "uniform":
        low, high = float(axis.first or 0.0), float(axis.last or 0.0)
        return (low + (high - low) * places).tolist()  # type: ignore[no-any-return]
    return [value_at(path, axis, place) for place in places.tolist()]


def screening(study: Study, designs: Mapping[str, Design]) -> partial[Screened]:
    """Return what screens a part, for processes.

    Args:
        study: With axes, objectives and constraints.
        designs: Name -> design.
    """
    return partial(screened, study, designs)


def starts(study: Study, blocks: Blocks) -> tuple[Floats, Judged]:
    """Return places and judgement of the designs that the first layer kept, in the order of their cases.

    Args:
        study: With axes, objectives and constraints.
        blocks: Of all parts.
    """
    numbers, own = judged(study, blocks)
    order = np.argsort(numbers, kind="stable")
    rows = [{"design": row.design, **row.inputs} for _, row in blocks]
    return freedoms_of(study).places(rows)[order], own.take(order)


# ----------------------------------------------------------------------------------------------------------------------
# Polish: teeth are kept, and ranges followed downhill by a compass, all designs of a front at once.
#
# Where a front has few designs, the best with other values of lists follow theirs, teeth chosen anew: they may lie in
# another valley. Each design goes the way on which all its objectives gain alike (Chebyshev's distance, augmented), so
# that it ends where it dominates what it was.
# Source: Kolda, Lewis, Torczon 2003, SIAM Review 45 (3), 385-482 (compass search); Miettinen 1999, Nonlinear
# Multiobjective Optimization, section 3.4 (augmented Chebyshev).
# ----------------------------------------------------------------------------------------------------------------------


FIRST, LAST = 0.05, 1e-3
"""First and last step of the compass, over each range [-]."""
DIRECTIONS = 14
"""Ways that are tried from each design, so that all can be sized together [-]."""
ENOUGH = 1 + 8 * DIRECTIONS
"""Evaluations of a compass: its start, the steps that become small, and as many that go somewhere [-]."""
AUGMENTED = 1e-3
"""Weight of the sum of objectives beside the largest [-]."""


class Compass:
    """One design on its way downhill."""

    def __init__(self, start: Fixed, axes: Mapping[str, Axis], own: Judged, scale: Floats) -> None:
        self.start, self.scale = start, scale
        self.axes = {path: axis for path, axis in axes.items() if is_continuous(axis)}
        self.place = np.array([place_of(path, axis, start.inputs[path]) for path, axis in self.axes.items()])
        self.aim, self.judged = own.values[0], own
        self.row: Row | None = None
        self.step = FIRST if len(self.place) else 0.0

    @property
    def going(self) -> bool:
        """Whether its steps are not small yet."""
        return self.step >= LAST

    def tries(self, generator: np.random.Generator) -> list[Floats]:
        """Return places around it: along every axis both ways, and on ways that are drawn.

        Args:
            generator: Of random numbers.
        """
        ways = [sign * way for way in np.eye(len(self.place)) for sign in (1.0, -1.0)]
        while len(ways) < DIRECTIONS:
            drawn = generator.normal(size=len(self.place))
            ways.append(drawn / max(float(np.linalg.norm(drawn)), 1e-9))
        return [np.clip(self.place + self.step * way, 0.0, 1.0) for way in ways]

    def inputs(self, place: Floats) -> dict[str, Value]:
        """Return what a place means, teeth kept.

        Args:
            place: Of the ranges, from 0 to 1.
        """
        moved = {
            path: value_at(path, axis, float(own)) for (path, axis), own in zip(self.axes.items(), place, strict=True)
        }
        return {**self.start.inputs, **moved}

    def note(self, places: Sequence[Floats], rows: Sequence[Row], own: Judged) -> None:
        """Go to the best of places, or take smaller steps.

        Args:
            places: That were tried.
            rows: What came of each.
            own: What is known of them.
        """
        merit = np.where(own.good, self._merit(own.values), np.inf)
        best = int(np.argmin(merit))
        if merit[best] < self._merit(self.judged.values)[0] - 1e-9:
            self.place, self.judged, self.row = places[best], own.take(np.array([best])), rows[best]
        else:
            self.step /= 3.0

    def _merit(self, values: Floats) -> Floats:
        gain = (values - self.aim) / self.scale
        return np.asarray(gain.max(axis=1) + AUGMENTED * gain.sum(axis=1))


def rounds(compasses: Sequence[Compass], seed: int) -> Iterator[tuple[list[Compass], list[list[Floats]]]]:
    """Yield those that are still on their way, with the places that each tries.

    Args:
        compasses: All of them; whoever takes a round notes what came of it.
        seed: Of the ways that are drawn.
    """
    generator = np.random.default_rng(seed)
    while going := [compass for compass in compasses if compass.going]:
        yield going, [compass.tries(generator) for compass in going]


# ----------------------------------------------------------------------------------------------------------------------
# The course of a search: screening, generations until the hypervolume stands still, polish with teeth kept.
# ----------------------------------------------------------------------------------------------------------------------


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
