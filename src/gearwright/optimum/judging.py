"""Rows as numbers for optimisers: objectives to be made small, and by how much each constraint is broken."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.spec import Study
from gearwright.study.answers import FAILED, NUMBER, REAL, Block, Blocks, Row, ranks, wanted
from gearwright.units import shown


class Judged(NamedTuple):
    """What optimisers know of designs."""

    values: Floats
    """Objectives to be made small [SI], shape (designs, objectives)."""
    broken: Floats
    """By how much each constraint is broken, over its bound [-], shape (designs, constraints); 0 where it is kept."""

    @property
    def violation(self) -> Floats:
        """All constraints together [-], shape (designs,)."""
        return np.asarray(self.broken.sum(axis=1) + np.where(self.failed, FAILED, 0.0))

    @property
    def failed(self) -> Bools:
        """Designs that cannot be sized."""
        return np.asarray((self.values >= FAILED).all(axis=1))

    @property
    def good(self) -> Bools:
        """Designs that keep every constraint."""
        return np.asarray(self.violation == 0.0)

    def take(self, place: Ints) -> Judged:
        """Return some of the designs.

        Args:
            place: Which.
        """
        return Judged(self.values[place], self.broken[place])

    def joined(self, other: Judged) -> Judged:
        """Return these designs and others.

        Args:
            other: Of the same search.
        """
        return Judged(np.vstack([self.values, other.values]), np.vstack([self.broken, other.broken]))

    @property
    def ranks(self) -> Ints:
        """Front that each belongs to [-], shape (designs,)."""
        return ranks(self.values, self.violation)


def judged(study: Study, blocks: Blocks) -> tuple[Ints, Judged]:
    """Return the numbers of cases and what optimisers know of them.

    Args:
        study: With objectives and constraints.
        blocks: Finished cases.
    """
    parts = [_of_block(study, block) for block in blocks.blocks]
    numbers = np.concatenate([block.records[NUMBER] for block in blocks.blocks])
    return numbers, Judged(np.vstack([part.values for part in parts]), np.vstack([part.broken for part in parts]))


def judged_rows(study: Study, rows: list[Row]) -> Judged:
    """Return what optimisers know of rows.

    Args:
        study: With objectives and constraints.
        rows: In any order, which is kept.
    """
    broken = np.array([[_excess(study, row, name) for name in study.constraints] for row in rows])
    return Judged(wanted(study, rows), broken.reshape(len(rows), len(study.constraints)))


def _excess(study: Study, row: Row, name: str) -> float:
    return 0.0 if row.problem else float(_over(study, name, np.array([row.shown(name)]))[0])


def _of_block(study: Study, block: Block) -> Judged:
    entries = {name: (k, dimension, kind) for k, (name, dimension, kind) in enumerate(block.shape.results)}
    asked = [*study.objectives, *study.constraints]
    if block.shape.failed or any(entries[name][2] != REAL for name in asked):
        return judged_rows(study, [row for _, row in block])
    offset = len(block.shape.inputs)
    columns = {name: (block.records[f"entry {offset + entries[name][0]}"], entries[name][1]) for name in asked}
    return judged_columns(study, columns)


def judged_columns(study: Study, columns: Mapping[str, tuple[Floats, str]]) -> Judged:
    """Return what optimisers know of designs whose results are columns.

    Args:
        study: With objectives and constraints.
        columns: Result -> values [SI], shape (designs,), and their dimension.
    """
    signs = [1.0 if sense == "minimum" else -1.0 for sense in study.objectives.values()]
    values = [sign * columns[name][0] for sign, name in zip(signs, study.objectives, strict=True)]
    broken = [_over(study, name, columns[name][0] * shown(1.0, columns[name][1])) for name in study.constraints]
    count = len(values[0])
    return Judged(np.array(values).reshape(-1, count).T, np.array(broken).reshape(-1, count).T)


ROUNDING = 1e-9
"""Of a bound by which it may be missed, as every check may [-]."""


def _over(study: Study, name: str, value: Floats) -> Floats:
    """Return by how much a result breaks its bounds, over them [-]."""
    bound, total = study.constraints[name], np.zeros(len(value))
    for limit, excess in ((bound.minimum, -1.0), (bound.maximum, 1.0)):
        if limit is not None:
            over = excess * (value - limit) / (abs(limit) or 1.0)
            total += np.where(over > ROUNDING, over, 0.0)
    return total
