"""Pareto fronts: designs that no other design dominates, constraints counted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.errors import DesignError, Problem
from gearwright.spec import Study
from gearwright.study.answers.table import Row, Table

FAILED = 1e30
"""Objective and violation of an infeasible design: worse than any that can."""


def pareto_front(study: Study, table: Table) -> tuple[Row, ...]:
    """Return the Pareto front: designs that no other one dominates, by the first objective, the best of it first.

    Args:
        study: With objectives and constraints.
        table: Its rows.

    Raises:
        DesignError: If the study has no objective, or no design keeps the constraints.
    """
    if not study.objectives:
        raise DesignError([Problem("objectives", 'there is none; add such as [objectives] mass = "minimum"')])
    good = [row for row in table.rows if not row.problem and not violations(study, [row])[0]]
    if not good:
        raise DesignError([Problem("constraints", "no design keeps all of them; relax one")])
    values = wanted(study, good)
    best = np.flatnonzero(ranks(values, np.zeros(len(good))) == 0)
    _, distinct = np.unique(values[best], axis=0, return_index=True)
    return tuple(good[k] for k in best[distinct])


FEW = 12
"""Designs of a front that are listed."""


def front_table(study: Study, table: Table) -> Table:
    """Return the front as a table: all of it, or evenly spaced ones of a long one.

    Args:
        study: With objectives and constraints.
        table: Its rows.

    Raises:
        DesignError: As `pareto_front`.
    """
    front = pareto_front(study, table)
    kept = np.unique(np.linspace(0, len(front) - 1, FEW).astype(int))
    name = f"Pareto front ({len(kept)} of {len(front)})"
    return replace(table, name=name, description="", rows=tuple(front[k] for k in kept))


def wanted(study: Study, rows: Sequence[Row]) -> Floats:
    """Return the objectives as numbers to be made small [SI], shape (rows, objectives).

    Args:
        study: With objectives.
        rows: Of it.
    """
    signs = {name: 1.0 if sense == "minimum" else -1.0 for name, sense in study.objectives.items()}
    return np.array(
        [[FAILED if row.problem else sign * row.number(name) for name, sign in signs.items()] for row in rows]
    ).reshape(len(rows), len(signs))


def violations(study: Study, rows: Sequence[Row]) -> Floats:
    """Return by how much each row breaks the constraints, relative to their bounds and summed [-], shape (rows,).

    Args:
        study: With constraints.
        rows: Of it.
    """
    return np.array([_violation(study, row) for row in rows])


def _violation(study: Study, row: Row) -> float:
    if row.problem:
        return FAILED
    total = 0.0
    for name, bound in study.constraints.items():
        value = row.shown(name)
        for limit, excess in ((bound.minimum, -1.0), (bound.maximum, 1.0)):
            if limit is not None:
                total += max(0.0, excess * (value - limit)) / (abs(limit) or 1.0)
    return total


def ranks(values: Floats, broken: Floats) -> Ints:
    """Return the front that each row belongs to [-]: 0 is dominated by none, 1 only by rows of 0, and so on.

    Args:
        values: Objectives to be made small, shape (rows, objectives).
        broken: Violation of the constraints [-], shape (rows,): who breaks them less dominates.

    Source: Deb et al. 2002, IEEE Trans. Evol. Comput. 6 (2), definition 1 (constraint-domination).
    """
    rank, left, front = np.zeros(len(values), dtype=np.int64), np.arange(len(values)), 0
    while len(left):
        best = non_dominated(values[left], broken[left])
        rank[left[best]] = front
        left, front = left[~best], front + 1
    return rank


def non_dominated(values: Floats, broken: Floats) -> Bools:
    """Tell which rows no other one dominates; each of them strikes out all that it dominates at once.

    Args:
        values: Objectives to be made small, shape (rows, objectives).
        broken: Violation of the constraints [-], shape (rows,).
    """
    best = np.ones(len(values), dtype=bool)
    for k in range(len(values)):
        if best[k]:
            same = broken == broken[k]
            worse = (values >= values[k]).all(axis=1) & (values > values[k]).any(axis=1)
            best &= ~((broken > broken[k]) | (same & worse))
    return best
