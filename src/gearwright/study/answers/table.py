"""Table: one row per variant; a failed variant is a row with its reason."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, near
from gearwright.showing import Shown, frame
from gearwright.sizing import TEXT, Named
from gearwright.units import number_text, shown, unit

_NUMBER = re.compile(r"(?<![\w.-])(?<![A-Z]{3} )[-−+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w]|[.-]\w)")
"""A number that stands alone: none in a name (``h2``, ``in-line-3``), in a path or in that of a standard."""


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

    def number(self, result: str) -> float:
        """Return one result of a variant that did not fail [SI].

        Args:
            result: Its name.

        Raises:
            DesignError: If it is a text.
        """
        value = self.results[result].value
        if isinstance(value, str):
            raise DesignError([Problem(result, f"{value!r} is a name and no number; take it as one of the results")])
        return value

    def shown(self, result: str) -> float:
        """Return one result in the unit in which it is shown.

        Args:
            result: Its name.

        Raises:
            DesignError: If it is a text.
        """
        return shown(self.number(result), self.results[result].dimension)

    def text(self, result: str) -> str:
        """Return one result as tables and sentences have it, without its unit.

        Args:
            result: Its name.
        """
        value, dimension = self.results[result]
        return value if isinstance(value, str) else number_text(value, dimension)


@dataclass(frozen=True, repr=False)
class Table(Shown):
    """The rows of a study."""

    name: str
    """Of the study."""
    description: str
    """What it answers."""
    results: tuple[str, ...]
    """Results that were asked for."""
    rows: tuple[Row, ...]
    """In the order of the study: designs outermost, the last axis fastest."""
    tied: bool = False
    """True if the axes were changed together, value by value."""

    @property
    def free(self) -> tuple[str, ...]:
        """Paths that vary on their own: of those that were changed together only the last."""
        paths = tuple(self.rows[0].inputs) if self.rows else ()
        return paths[-1:] if self.tied else paths

    def column(self, result: str) -> list[float]:
        """Return one result of every row that did not fail [SI].

        Args:
            result: Its name.

        Raises:
            DesignError: If it was not asked for.
        """
        if result not in self.results:
            raise DesignError([Problem("results", f"{result!r} was not asked for; {near(result, self.results)}")])
        return [row.number(result) for row in self.good]

    @cached_property
    def good(self) -> tuple[Row, ...]:
        """Rows that did not fail."""
        return tuple([row for row in self.rows if not row.problem])

    @cached_property
    def numbers(self) -> tuple[str, ...]:
        """Results that are numbers, not names."""
        return tuple(name for name in self.results if self.good and self.good[0].results[name].dimension != TEXT)

    def unit(self, result: str) -> str:
        """Return the unit in which a result is shown; empty for what has none.

        Args:
            result: Its name.
        """
        return unit(self.good[0].results[result].dimension) if result in self.numbers else ""

    def to_dataframe(self) -> Any:
        """Return a pandas ``DataFrame``: a row for each variant, as shown and exported; units in ``attrs["units"]``."""
        from gearwright.study.answers.export import columns  # export's tables are these

        return frame(columns(self), "")

    @cached_property
    def failed(self) -> tuple[Row, ...]:
        """Rows that failed."""
        return tuple([row for row in self.rows if row.problem])


def kind_of(problem: str) -> str:
    """Return why a case failed without its numbers, so that like reasons count together.

    Args:
        problem: Of a row.

    >>> kind_of("pairs.in-line-h2.width: 12.5 mm is below -3 mm (ISO 6336-2, 5.3)")
    'pairs.in-line-h2.width: … mm is below … mm (ISO 6336-2, …)'
    """
    return _NUMBER.sub("…", problem)


def quantiles(values: Sequence[float] | Floats, parts: Sequence[float]) -> list[float]:
    """Return the values below which parts of all lie; between an endless one and another nothing is interpolated.

    Args:
        values: Of one result.
        parts: Of all cases [-].

    >>> quantiles([1.0, 2.0], [0.5]), quantiles([1.0, 2.0, float("inf")], [0.5, 0.95])
    ([1.5], [2.0, inf])
    """
    method: Literal["linear", "nearest"] = "linear" if np.isfinite(values).all() else "nearest"
    return [float(quantile) for quantile in np.quantile(values, parts, method=method)]
