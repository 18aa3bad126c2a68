"""Statistics of a study: ranking of designs, Sobol' indices, quantiles and summaries without rows.

How rows come about is in `cases` and `running`.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gearwright.base import DesignError, Floats, Ints, Problem, Shown, SolveError, largest_first, shown, unit
from gearwright.sizing import Named
from gearwright.spec import Study, value_at
from gearwright.study.tables import (
    FAILED,
    OTHER,
    Block,
    Blocks,
    Row,
    Table,
    kind_of,
    non_dominated,
    violations,
    wanted,
)

# ----------------------------------------------------------------------------------------------------------------------
# Which design wins over all objectives, by how much, and how sure that is.
#
# Designs are compared at equal inputs: one such comparison is a scenario. In each, every objective gives every design
# a rank; the mean rank over the objectives orders them. Ranks need no common unit, so that kilograms, hours and parts
# of a per cent can stand side by side. How sure a winner is has two parts: in how many scenarios it comes first, and
# for how many weights of the objectives it does (stochastic multicriteria acceptability).
# ----------------------------------------------------------------------------------------------------------------------


WEIGHTS = 2000
"""Weights of the objectives that are drawn: a share of them is then within 0.02 [-]."""
NORMAL_95 = 1.959963984540054
"""Two-sided 95 % point of the normal distribution [-]."""
CONFIDENCE = 0.95
"""Of intervals and bounds [-]."""


@dataclass(frozen=True)
class Standing:
    """Where one design stands."""

    design: str
    place: float
    """Mean rank over objectives and scenarios, 1 is best [-]."""
    first: int
    """Scenarios in which its mean rank is the best [-]."""
    weights: float
    """Part of all weights of the objectives, over all scenarios, with which it comes first [-]."""
    non_dominated: float
    """Part of the scenarios in which it is on the Pareto front [-]."""


@dataclass(frozen=True)
class Verdict:
    """How designs compare at equal inputs."""

    standings: tuple[Standing, ...]
    """The winner first."""
    scenarios: int
    """Comparisons at equal inputs [-]."""
    without: dict[str, str]
    """Objective -> who would win if it did not count; only those without which another design does."""

    @property
    def sureness(self) -> tuple[float, float]:
        """95 % confidence interval of the part of scenarios in which the winner is first [-]."""
        return confidence(self.standings[0].first, self.scenarios)


def verdict(study: Study, table: Table) -> Verdict | None:
    """Return how the designs of a study compare, or None where there is nothing to compare at equal inputs.

    Args:
        study: With objectives.
        table: Its rows; a design that fails or breaks a constraint in a scenario has the last place there.

    Source: mean rank: Borda 1781; weights drawn evenly from the simplex: Lahdelma and Salminen 2001, SMAA-2, Oper.
        Res. 49 (3), 444-454, on places instead of values.
    """
    searched = study.sampling.method == "nsga2"  # whose cases have equal inputs by chance alone
    groups = scenarios(table) if len(study.designs) > 1 and study.objectives and not searched else []
    if not groups:
        return None
    designs = [row.design for row in groups[0]]
    values = np.stack([_allowed(study, rows) for rows in groups])
    places = np.stack([_places(value) for value in values])
    means = places.mean(axis=2)
    on_front = np.mean([non_dominated(value, np.zeros(len(designs))) for value in values], axis=0)
    standings = [
        Standing(name, float(place), int(won), float(share), float(free))
        for name, place, won, share, free in zip(
            designs, means.mean(axis=0), _firsts(means), _acceptability(study, places), on_front, strict=True
        )
    ]
    standings.sort(key=lambda standing: (standing.place, -standing.first))
    return Verdict(tuple(standings), len(groups), _without(study, places, designs, standings[0].design))


def scenarios(table: Table) -> list[list[Row]]:
    """Return the rows of equal inputs together, of those inputs at which every design is and one at least succeeds.

    Args:
        table: Of a study.
    """
    groups: dict[tuple[object, ...], dict[str, Row]] = {}
    for row in table.rows:
        groups.setdefault(tuple(row.inputs.values()), {})[row.design] = row
    designs = list(dict.fromkeys(row.design for row in table.rows))
    complete = [group for group in groups.values() if len(group) == len(designs)]
    rows = [[group[name] for name in designs] for group in complete]
    return [scenario for scenario in rows if not all(row.problem for row in scenario)]


def _allowed(study: Study, rows: Sequence[Row]) -> Floats:
    broken = violations(study, rows) > 0.0
    values: Floats = np.where(broken[:, None], FAILED, wanted(study, rows))
    return values


def _places(values: Floats) -> Floats:
    """Return the place of every row in every column, 1 the smallest; equal ones share the mean of their places."""
    less = (values[:, None, :] > values[None, :, :]).sum(axis=1, dtype=float)
    same = (values[:, None, :] == values[None, :, :]).sum(axis=1, dtype=float)
    places: Floats = less + (same + 1.0) / 2.0
    return places


def _firsts(means: Floats) -> Ints:
    """Return in how many scenarios each design has the best mean rank; a tie goes to none of its designs."""
    best = means == means.min(axis=1, keepdims=True)
    alone: Ints = (best & (best.sum(axis=1, keepdims=True) == 1)).sum(axis=0)
    return alone


def _acceptability(study: Study, places: Floats) -> Floats:
    """Return the part of weights and scenarios with which each design is first."""
    generator = np.random.default_rng(study.sampling.seed)
    weights = generator.dirichlet(np.ones(places.shape[2]), WEIGHTS)
    shares = np.zeros(places.shape[1])
    for place in places:  # one scenario at a time: all of them together would need gigabytes
        shares += np.bincount(np.argmin(place @ weights.T, axis=0), minlength=len(shares))
    shares /= shares.sum()
    return shares


def _without(study: Study, places: Floats, designs: Sequence[str], winner: str) -> dict[str, str]:
    if len(study.objectives) < 2:
        return {}
    winners = {}
    for k, name in enumerate(study.objectives):
        rest = np.delete(places, k, axis=2).mean(axis=(0, 2))
        best = designs[int(np.argmin(rest))]
        if best != winner:
            winners[name] = best
    return winners


def confidence(hits: int, count: int) -> tuple[float, float]:
    """Return the 95 % confidence interval of a probability [-].

    Args:
        hits: How often it came true.
        count: Of how many independent trials, at least 1.

    Source: Wilson 1927, J. Am. Stat. Assoc. 22, 209-212.

    >>> [round(each, 3) for each in confidence(8, 10)]
    [0.49, 0.943]
    """
    square = NORMAL_95**2
    middle = (hits + square / 2.0) / (count + square)
    half = NORMAL_95 / (count + square) * math.sqrt(hits * (count - hits) / count + square / 4.0)
    return max(0.0, middle - half), min(1.0, middle + half)


def bound(values: Sequence[float], part: float = 0.95) -> float | None:
    """Return the value below which at least a part of all that may come lies, with 95 % confidence, or None.

    Args:
        values: Independent samples; None is returned where there are too few for any bound (59 for a part of 0.95).
        part: Of all cases that shall lie below [-].

    Source: distribution-free tolerance limit, Wilks 1941, Ann. Math. Stat. 12, 91-96.

    >>> bound([float(k) for k in range(58)]), bound([float(k) for k in range(59)])
    (None, 58.0)
    """
    from scipy.stats import binom  # half a second to load

    count = len(values)
    order = int(binom.ppf(CONFIDENCE, count, part)) + 1
    return sorted(values)[order - 1] if order <= count else None


def kept(study: Study, table: Table) -> dict[str, int]:
    """Return in how many cases each constraint is kept; a failed case keeps none.

    Args:
        study: With constraints.
        table: Its rows.
    """
    return {
        name: sum(
            (limit.minimum is None or row.shown(name) >= limit.minimum)
            and (limit.maximum is None or row.shown(name) <= limit.maximum)
            for row in table.good
        )
        for name, limit in study.constraints.items()
    }


# ----------------------------------------------------------------------------------------------------------------------
# Sensitivity of results to the axes of a study: Sobol' indices of first and total order with confidence.
# ----------------------------------------------------------------------------------------------------------------------


INDEX_CONFIDENCE = 0.95
"""Of the intervals [-]."""
ROUNDING = 1e-9
"""Relative spread below which a result counts as the same in every case [-]."""
RESAMPLES = 400
"""Bootstrap resamples: their interval ends then scatter by some 5 % of its width."""


@dataclass(frozen=True)
class Influence:
    """How much of a result's variance one axis explains."""

    axis: str
    """Dotted path."""
    first: float
    """First-order index: the axis alone [-]."""
    first_interval: tuple[float, float]
    """95 % confidence interval of it [-]."""
    total: float
    """Total index: with all interactions [-]."""
    total_interval: tuple[float, float]
    """95 % confidence interval of it [-]."""


def sensitivity(study: Study, table: Table, result: str, *, design: str | None = None) -> tuple[Influence, ...]:
    """Return the influence of every axis on a result, the greatest total first.

    Args:
        study: With the method ``saltelli``.
        table: Its rows.
        result: Name of a result that was asked for.
        design: Name; left out: the first one.

    Source: Sobol' 2001, Math. Comput. Simul. 55, 271-280; estimators of Saltelli et al. 2010, Comput. Phys. Commun.
        181, 259-270, table 2 (b) and (f); percentile bootstrap with the study's seed.

    Raises:
        DesignError: If the study has another method.
        SolveError: If cases failed, without which the estimators do not hold, or the result does not vary.
    """
    if study.sampling.method != "saltelli":
        message = f'{study.sampling.method!r} gives no sensitivities; take "saltelli"'
        raise DesignError([Problem("sampling.method", message)])
    rows = [row for row in table.rows if row.design == (design or study.designs[0])]
    failed = sum(bool(row.problem) for row in rows)
    if failed:
        raise SolveError(f"{failed} of {len(rows)} cases are infeasible; narrow the axes until none is")
    values = np.array([row.number(result) for row in rows])
    if not varies(values):
        raise SolveError(f"{result} does not vary, or is not finite everywhere: nothing has an influence on it")
    return _influences(study, values)


def varies(values: np.ndarray) -> bool:
    """Tell whether finite values differ by more than rounding.

    Args:
        values: Of one result, shape (cases,).
    """
    return bool(np.isfinite(values).all() and np.ptp(values) > ROUNDING * np.abs(values).max())


def _influences(study: Study, values: np.ndarray) -> tuple[Influence, ...]:
    axes, count = list(study.axes), study.sampling.count or 0
    blocks = values.reshape(len(axes) + 2, count)
    indices = _indices(blocks)
    generator = np.random.default_rng(study.sampling.seed)
    drawn = np.array([_indices(blocks[:, generator.integers(count, size=count)]) for _ in range(RESAMPLES)])
    low, high = np.nanquantile(drawn, [0.5 - 0.5 * INDEX_CONFIDENCE, 0.5 + 0.5 * INDEX_CONFIDENCE], axis=0)
    influences = [
        Influence(
            axis,
            float(indices[0, k]),
            (float(low[0, k]), float(high[0, k])),
            float(indices[1, k]),
            (float(low[1, k]), float(high[1, k])),
        )
        for k, axis in enumerate(axes)
    ]
    return tuple(largest_first(influences, lambda influence: influence.total))


def _indices(blocks: np.ndarray) -> np.ndarray:
    """Return first and total index of every axis, shape (2, axes), from the rows f(A), f(B) and f(A with B's axis)."""
    base, resampled, *mixed = blocks - np.mean(blocks[:2])
    spread = np.var([base, resampled])
    if not spread:
        return np.full((2, len(mixed)), np.nan)
    first = np.mean(resampled * (mixed - base), axis=-1)
    total = 0.5 * np.mean((base - mixed) ** 2, axis=-1)
    return np.array([first / spread, total / spread])


# ----------------------------------------------------------------------------------------------------------------------
# Quantiles of any number of values in the room of some hundred counts, the same whatever the order they came in.
#
# Source: logarithmic buckets of Masson, Rim, Lee 2019, DDSketch, Proc. VLDB Endow. 12 (12), 2195-2205: a quantile is
# off by no more than the relative accuracy that was asked, and sketches of parts add up to that of the whole.
# ----------------------------------------------------------------------------------------------------------------------


ACCURACY = 0.005
"""Relative, of a quantile [-]."""
_GROWTH = (1.0 + ACCURACY) / (1.0 - ACCURACY)
_TINY = 1e-300
"""Magnitude up to which a value is zero."""
_BELOW, _ABOVE = -(1 << 40), 1 << 40
"""Buckets of minus and plus infinity."""
_MIDDLE = 1 << 20
"""Bucket of zero lies between those of negative and positive numbers, whose logarithms are below this in magnitude."""


def buckets(values: Floats) -> Ints:
    """Return the bucket of every value, in the order of the values.

    Args:
        values: Numbers or infinities, shape (values,).
    """
    size = np.abs(values)
    with np.errstate(divide="ignore", invalid="ignore"):
        steps = np.where(size > _TINY, np.ceil(np.log(size) / math.log(_GROWTH)) + _MIDDLE, 0.0)
    signed = np.sign(values) * steps
    found: Ints = np.where(np.isinf(values), np.where(values > 0.0, _ABOVE, _BELOW), np.nan_to_num(signed)).astype(
        np.int64
    )
    return found


def middle(bucket: int) -> float:
    """Return the value that stands for a bucket.

    Args:
        bucket: From `buckets`.

    >>> [round(middle(int(bucket)) / value - 1.0, 6) == 0.0 or abs(middle(int(bucket)) / value - 1.0) < 0.0051
    ...  for value in (3.0, -1e-9, 7e12) for bucket in buckets(np.array([value]))]
    [True, True, True]
    """
    if bucket == 0:
        return 0.0
    if bucket in (_ABOVE, _BELOW):
        return math.copysign(math.inf, bucket)
    power = math.exp((abs(bucket) - _MIDDLE) * math.log(_GROWTH))
    return math.copysign(2.0 * power / (_GROWTH + 1.0), bucket)


def quantiles_of(counts: Mapping[int, int], parts: tuple[float, ...]) -> tuple[float, ...]:
    """Return the values below which parts of all lie, to the relative accuracy.

    Args:
        counts: Bucket -> values in it.
        parts: Of all values [-].
    """
    order = sorted(counts)
    reached = np.cumsum([counts[bucket] for bucket in order])
    ranks = [min(int(part * (reached[-1] - 1)), int(reached[-1]) - 1) for part in parts]
    return tuple(middle(order[int(np.searchsorted(reached, rank, side="right"))]) for rank in ranks)


# ----------------------------------------------------------------------------------------------------------------------
# A study without its rows: how results are spread, along which axis, and the best cases, of any number of cases.
#
# A reduced study adds up: that of two parts is the reduced one of both together, in whatever order cases are finished.
# ----------------------------------------------------------------------------------------------------------------------


SECTIONS = 24
"""Sections of an axis along which results are followed [-]: equal shares of its samples."""
_SECTION = 1 << 42
"""More than any bucket: section and bucket become one number."""
Counts = Counter[int]


@dataclass
class Reduced(Shown):
    """What is left of the cases of a study when each has been seen once."""

    study: Study
    """With the table ``reduced``."""
    cases: int = 0
    """Seen [-]."""
    failed: int = 0
    """Of them without a result [-]."""
    dimensions: dict[str, str] = field(default_factory=dict)
    """Result that is a number -> its dimension."""
    counts: dict[tuple[str, str, str], Counts] = field(default_factory=dict)
    """(Design, result, axis) -> values of every bucket, with their section of the axis; axis "" has no sections."""
    best: dict[int, Row] = field(default_factory=dict)
    """Number -> row of the cases that are kept: the Pareto front, and the best ones of every objective."""
    reasons: Counter[str] = field(default_factory=Counter)
    """Reason of failed cases without its digits -> how many."""

    def absorb(self, finished: Blocks) -> None:
        """Take finished cases.

        Args:
            finished: Any of the study, each once.
        """
        for block in finished.blocks:
            self.cases += len(block)
            if block.shape.failed:
                self.failed += len(block)
                self.reasons.update(kind_of(texts[-1]) for texts in block.texts)
            else:
                self._count(block)
                self._keep_best(block)

    def add(self, other: Reduced) -> None:
        """Take what another part of the study left.

        Args:
            other: Of other cases of the same study.
        """
        self.cases += other.cases
        self.failed += other.failed
        self.dimensions |= other.dimensions
        for key, counts in other.counts.items():
            self.counts.setdefault(key, Counter()).update(counts)
        self.reasons.update(other.reasons)
        self._choose({**self.best, **other.best})

    def quantiles(self, design: str, result: str, parts: tuple[float, ...] = (0.05, 0.5, 0.95)) -> tuple[float, ...]:
        """Return the values of a result below which parts of the cases lie [SI], to `sketch.ACCURACY`.

        Args:
            design: Name.
            result: Name.
            parts: Of the cases that have a result [-].
        """
        return quantiles_of(self.counts[design, result, ""], parts)

    def along(self, design: str, result: str, axis: str) -> Iterator[tuple[int, int, tuple[float, ...]]]:
        """Yield section, cases and 5 %, median and 95 % of a result along an axis [SI].

        Args:
            design: Name.
            result: Name.
            axis: Path.
        """
        by_section: dict[int, Counts] = {}
        for key, count in self.counts[design, result, axis].items():
            section, bucket = divmod(key + _SECTION // 2, _SECTION)
            by_section.setdefault(section, Counter())[bucket - _SECTION // 2] += count
        for section in sorted(by_section):
            own = by_section[section]
            yield section, own.total(), quantiles_of(own, (0.05, 0.5, 0.95))

    def shown(self, result: str, value: float) -> float:
        """Return a value of a result in the unit in which it is shown.

        Args:
            result: Name.
            value: In SI.
        """
        return shown(value, self.dimensions[result])

    def unit(self, result: str) -> str:
        """Return the unit in which a result is shown.

        Args:
            result: Name.
        """
        return unit(self.dimensions[result])

    def _count(self, block: Block) -> None:
        shape, paths = block.shape, len(block.shape.inputs)
        places = {path: self._sections(path, _column(block, k)) for k, (path, _) in enumerate(shape.inputs)}
        for k, (name, dimension, kind) in enumerate(shape.results):
            if kind == OTHER:
                continue
            self.dimensions[name] = dimension
            own = buckets(block.records[f"entry {paths + k}"])
            for path, sections in {"": np.zeros(len(own), dtype=np.int64), **places}.items():
                keys, counts = np.unique(sections * _SECTION + own, return_counts=True)
                held = self.counts.setdefault((shape.design, name, path), Counter())
                held.update(dict(zip(keys.tolist(), counts.tolist(), strict=True)))

    def _sections(self, path: str, values: Sequence[Any]) -> Ints:
        """Return the section of an axis in which every value lies."""
        axis = self.study.axes[path]
        if axis.values is not None:
            listed = {value: k for k, value in enumerate(axis.values)}
            return np.array([listed[value] for value in values], dtype=np.int64)
        edges = [value_at(path, axis, k / SECTIONS) for k in range(1, SECTIONS)]
        found: Ints = np.searchsorted(np.array(edges, dtype=float), np.array(values, dtype=float), side="right")
        return found

    def _keep_best(self, block: Block) -> None:
        """Keep those rows of a block that may be among the best."""
        table = self.study.reduced
        if table is None or not self.study.objectives:
            return
        rows = block.where(self._candidates(block)) if len(block) > table.best else block
        self._choose({**self.best, **dict(rows)})

    def _candidates(self, block: Block) -> Any:
        """Tell which rows no kept row dominates, or which beat the last of the kept ones in an objective."""
        own = _objectives(self.study, block)
        if not self.best:
            return np.ones(len(block), dtype=bool)
        kept = wanted(self.study, list(self.best.values()))
        allowed = violations(self.study, list(self.best.values())) == 0.0
        dominated = np.zeros(len(block), dtype=bool)
        for values in kept[allowed]:
            dominated |= (own >= values).all(axis=1)
        if len(self.best) < (self.study.reduced.best if self.study.reduced else 0):
            return np.ones(len(block), dtype=bool)
        return ~dominated | (own < kept.max(axis=0)).any(axis=1)

    def _choose(self, rows: Mapping[int, Row]) -> None:
        """Keep the front, and of every objective the best ones that keep the constraints."""
        table = self.study.reduced
        if table is None or not rows:
            return
        numbers = np.array(sorted(rows))
        ordered = [rows[int(number)] for number in numbers]
        values, broken = wanted(self.study, ordered), violations(self.study, ordered)
        chosen = non_dominated(values, broken) & (broken == 0.0)
        sound = np.flatnonzero(broken == 0.0)
        for column in values.T:
            chosen[sound[np.argsort(column[sound], kind="stable")[: table.best]]] = True
        self.best = {int(number): rows[int(number)] for number in numbers[chosen]}


def _column(block: Block, place: int) -> Sequence[Any]:
    """Return one entry of every row."""
    kinds = block.shape.kinds
    if kinds[place] != OTHER:
        column: Sequence[Any] = block.records[f"entry {place}"].tolist()
        return column
    other = sum(kind == OTHER for kind in kinds[:place])
    return [texts[other] for texts in block.texts]


def _objectives(study: Study, block: Block) -> Floats:
    """Return the objectives of every row as numbers to be made small, shape (rows, objectives)."""
    names = [name for name, *_ in block.shape.results]
    first = len(block.shape.inputs)
    columns = []
    for name, sense in study.objectives.items():
        column = np.array(_column(block, first + names.index(name)), dtype=float)
        columns.append(column if sense == "minimum" else -column)
    return np.stack(columns, axis=1)


def as_plain(reduced: Reduced) -> dict[str, Any]:
    """Return a reduced study as a tree that JSON holds.

    Args:
        reduced: Without its study.
    """
    return {
        "cases": reduced.cases,
        "failed": reduced.failed,
        "dimensions": reduced.dimensions,
        "counts": [[*key, sorted(counts.items())] for key, counts in sorted(reduced.counts.items())],
        "best": [
            [number, row.design, dict(row.inputs), {name: list(named) for name, named in row.results.items()}]
            for number, row in sorted(reduced.best.items())
        ],
        "reasons": dict(sorted(reduced.reasons.items())),
    }


def from_plain(study: Study, tree: Mapping[str, Any]) -> Reduced:
    """Return the reduced study of a tree.

    Args:
        study: That it is of.
        tree: As `as_plain` gave it.
    """
    counts = {
        (design, result, axis): Counter(dict(map(tuple, pairs))) for design, result, axis, pairs in tree["counts"]
    }
    best = {
        number: Row(design, inputs, {name: Named(*named) for name, named in results.items()})
        for number, design, inputs, results in tree["best"]
    }
    return Reduced(
        study, tree["cases"], tree["failed"], dict(tree["dimensions"]), counts, best, Counter(tree["reasons"])
    )  # fmt: skip
