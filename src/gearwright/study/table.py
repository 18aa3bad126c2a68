"""Table: one row per variant; a failed variant is a row with its reason."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gearwright.errors import DesignError, Problem, near
from gearwright.sizing.named import Named


@dataclass(frozen=True)
class Row:
    """One variant."""

    design: str
    """Design that was varied."""
    inputs: Mapping[str, float | int | str | bool]
    """Dotted path -> value, in the unit of the path."""
    results: Mapping[str, Named]
    """Result -> value; empty if the variant failed."""
    problem: str = ""
    """Why the variant failed; empty if it did not."""


@dataclass(frozen=True)
class Table:
    """The rows of a study."""

    name: str
    """Of the study."""
    description: str
    """What it answers."""
    results: tuple[str, ...]
    """Results that were asked for."""
    rows: tuple[Row, ...]
    """In the order of the study: designs outermost, the last axis fastest."""

    def column(self, result: str) -> list[float]:
        """Return one result of every row that did not fail [SI].

        Args:
            result: Its name.

        Raises:
            DesignError: If it was not asked for.
        """
        if result not in self.results:
            raise DesignError([Problem("results", f"{result!r} was not asked for; {near(result, self.results)}")])
        return [row.results[result].value for row in self.rows if not row.problem]

    @property
    def failed(self) -> tuple[Row, ...]:
        """Rows that failed."""
        return tuple(row for row in self.rows if row.problem)
