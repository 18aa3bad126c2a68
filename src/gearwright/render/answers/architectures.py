"""The answer of an enumeration of architectures."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.enumeration import Ranking
from gearwright.render.tables.study.architectures import ArchitectureRow, rows_of
from gearwright.study import EqualLife
from gearwright.units import Life, Ratio


@dataclass(frozen=True)
class ArchitecturesAnswer:
    """Every architecture that can serve a requirement, and the best closed for one life."""

    requirement: str
    life: Life
    """Of gears and bearings alike [s]."""
    count: int
    """Architectures that can give the ratio [-]."""
    refused: int
    """Of them cannot be sized [-]."""
    confidence: Ratio | None
    """Probability that the lightest that passes is lighter than the next [-]."""
    closed: tuple[EqualLife, ...]
    """Closed designs: those that pass first, the lightest first."""
    rows: tuple[ArchitectureRow, ...]
    """Every architecture, the most promising first."""


def architectures_answer(ranking: Ranking) -> ArchitecturesAnswer:
    """Return what `gearwright architectures --json` answers.

    Args:
        ranking: From `architectures`.
    """
    return ArchitecturesAnswer(
        ranking.requirement, ranking.life, len(ranking.candidates), ranking.refused, ranking.confidence, ranking.closed,
        tuple(rows_of(ranking.candidates)),
    )  # fmt: skip
