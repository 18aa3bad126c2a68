"""A study without its rows: how results are spread, along which axis, and the best cases, of any number of cases.

A reduced study adds up: that of two parts is the reduced one of both together, in whatever order cases are finished.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.showing import Shown
from gearwright.sizing import Named
from gearwright.spec import Study, value_at
from gearwright.study.answers.blocks import OTHER, Block, Blocks
from gearwright.study.answers.pareto import non_dominated, violations, wanted
from gearwright.study.answers.sketch import buckets, quantiles_of
from gearwright.study.answers.table import Row, kind_of
from gearwright.units import shown, unit

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
