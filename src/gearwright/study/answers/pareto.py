"""Pareto fronts: designs that no other design dominates, constraints counted."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

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
    best = np.flatnonzero(non_dominated(values, np.zeros(len(good))))
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
    failed = np.array([bool(row.problem) for row in rows], dtype=bool)
    broken = np.fmax(0.0, -left_of(study, rows)).sum(axis=1)
    total: Floats = np.where(failed, FAILED, broken)
    return total


class Limit(NamedTuple):
    """One side of a constraint."""

    result: str
    """Its name."""
    bound: float
    """In the unit of tables."""
    is_minimum: bool
    """True if the result has to be at least the bound, False if at most."""


def limits_of(study: Study) -> tuple[Limit, ...]:
    """Return every limit that the constraints of a study set.

    Args:
        study: With constraints.
    """
    return tuple(
        Limit(name, value, is_minimum)
        for name, bound in study.constraints.items()
        for value, is_minimum in ((bound.minimum, True), (bound.maximum, False))
        if value is not None
    )


def left_of(study: Study, rows: Sequence[Row]) -> Floats:
    """Return what is left of every limit, relative to it [-], shape (rows, limits): below 0 it is broken.

    Args:
        study: With constraints.
        rows: Of it; of one that failed nothing is known, which is minus infinity.
    """
    limits = limits_of(study)
    return np.array([[_left(row, limit) for limit in limits] for row in rows]).reshape(len(rows), len(limits))


def _left(row: Row, limit: Limit) -> float:
    if row.problem:
        return -math.inf
    over = (row.shown(limit.result) - limit.bound) / (abs(limit.bound) or 1.0)
    return over if limit.is_minimum else -over


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
    for k in np.lexsort((*values.T[::-1], broken)).tolist():  # what comes first strikes out the most
        if best[k]:
            same = broken == broken[k]
            worse = (values >= values[k]).all(axis=1) & (values > values[k]).any(axis=1)
            best &= ~((broken > broken[k]) | (same & worse))
    return best


def crowding(values: Floats, rank: Ints) -> Floats:
    """Return the crowding distance of every row within its rank [-]; the ends of a front are infinitely far apart.

    Args:
        values: Objectives, shape (rows, objectives).
        rank: Front that each row belongs to, shape (rows,).
    """
    distance = np.zeros(len(values))
    for front in np.unique(rank):
        members = np.flatnonzero(rank == front)
        for column in values.T:
            order = members[np.argsort(column[members], kind="stable")]
            ordered = column[order]
            distance[order[[0, -1]]] = np.inf
            span = ordered[-1] - ordered[0]
            if 0.0 < span < np.inf:
                distance[order[1:-1]] += (ordered[2:] - ordered[:-2]) / span
    return distance
