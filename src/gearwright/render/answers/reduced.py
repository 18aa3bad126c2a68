"""Answer of a study that kept no rows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gearwright.render.answers.study import StudyRow, study_row
from gearwright.study.answers import Reduced
from gearwright.study.answers.sketch import ACCURACY


@dataclass(frozen=True)
class SpreadOf:
    """How one result of one design is spread."""

    design: str
    result: str
    unit: str
    quantiles: Mapping[str, float]
    """Part of the cases, such as 0.05 -> value below which it lies, to the relative accuracy."""


@dataclass(frozen=True)
class ReducedAnswer:
    """A study that kept no rows."""

    name: str
    cases: int
    """Seen."""
    failed: int
    """Of them without a result."""
    accuracy: float
    """Relative, of every quantile."""
    spread: tuple[SpreadOf, ...]
    best: Mapping[str, StudyRow]
    """Number -> case of the Pareto front and of the best of every objective."""
    reasons: Mapping[str, int]
    """Why cases failed -> how many."""


def reduced_answer(reduced: Reduced) -> ReducedAnswer:
    """Return what `gearwright study --json` answers of a study with the table ``reduced``.

    Args:
        reduced: Of the study.
    """
    parts = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)
    spread = tuple(
        SpreadOf(design, result, reduced.unit(result), {
            str(part): reduced.shown(result, value)
            for part, value in zip(parts, reduced.quantiles(design, result, parts), strict=True)
        })
        for design, result, axis in sorted(reduced.counts)
        if not axis
    )  # fmt: skip
    best = {str(number): study_row(row) for number, row in sorted(reduced.best.items())}
    return ReducedAnswer(
        reduced.study.name, reduced.cases, reduced.failed, ACCURACY, spread, best, dict(reduced.reasons.most_common(20))
    )  # fmt: skip
