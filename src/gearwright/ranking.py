"""The largest of some: equals keep their order, whatever the last digit of a processor's rounding says."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

Row = TypeVar("Row")
ALIKE = 1e-9
"""Part by which two values may differ and be equal [-]."""


def largest(rows: Iterable[Row], value: Callable[[Row], float]) -> Row:
    """Return the row of the largest value, the first one of equals.

    Args:
        rows: One or more.
        value: Of a row, zero or above.

    Raises:
        ValueError: There is no row.

    >>> largest(["left", "right"], {"left": 0.3, "right": 0.1 + 0.2}.__getitem__)
    'left'
    """
    first, *others = rows
    for row in others:
        if value(row) > value(first) * (1.0 + ALIKE):
            first = row
    return first


def largest_first(rows: Iterable[Row], value: Callable[[Row], float]) -> list[Row]:
    """Return the rows by falling value, equals and zeros as they came.

    Args:
        rows: Any number.
        value: Of a row, zero or above; what is that small beside the largest is zero with rounding.

    >>> largest_first("abc", {"a": 0.3, "b": 1.0, "c": 0.1 + 0.2}.__getitem__)
    ['b', 'a', 'c']
    """
    kept = list(rows)
    least = ALIKE * max((value(row) for row in kept), default=0.0)
    return sorted(kept, key=lambda row: -float(f"{value(row):.9g}") if value(row) > least else 0.0)
