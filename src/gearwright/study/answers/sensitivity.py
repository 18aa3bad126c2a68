"""Sensitivity of results to the axes of a study: Sobol' indices of first and total order with confidence."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.ranking import largest_first
from gearwright.spec import Study
from gearwright.study.answers.table import Table

CONFIDENCE = 0.95
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
    low, high = np.nanquantile(drawn, [0.5 - 0.5 * CONFIDENCE, 0.5 + 0.5 * CONFIDENCE], axis=0)
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
