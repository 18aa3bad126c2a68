"""The validation tables: every published number beside what gearwright finds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import groupby

from gearwright.render.tables.tables import Cell, Table, table
from gearwright.validate import Case, Checked, check

FIELDS = ("case", "source", "expected", "got", "unit", "error", "holds", "reason")
"""Columns for machines."""
SHOWN = ("expected", "got", "error", "unit", "case")
"""Columns for the terminal; the source is the title."""
DIGITS = 7
"""Significant digits that are shown [-]."""


def by_source(cases: Iterable[Case]) -> Iterator[tuple[Checked, ...]]:
    """Compute and yield the numbers of one source after the other.

    Args:
        cases: Published results, those of one source together.
    """
    for _, group in groupby(cases, key=lambda case: case.source):
        yield tuple(one for case in group for one in check(case))


def source_table(found: tuple[Checked, ...]) -> Table:
    """Return the numbers of one source for the terminal; what is missed is said below, with its tolerance's reason.

    Args:
        found: Numbers of that source.
    """
    plain = table(found[0].source, found, SHOWN)
    rows = tuple(_written(row, one) for row, one in zip(plain.rows, found, strict=True))
    missed = "; ".join(f"{one.case} (allowed because {one.reason})" for one in found if not one.holds)
    return replace(plain, rows=rows, note=f"Missed: {missed}." if missed else "")


def validation_table(found: Iterable[Checked]) -> Table:
    """Return all numbers for machines.

    Args:
        found: Of all sources.
    """
    return table("Validation", found, FIELDS)


def verdict(found: Iterable[Checked]) -> str:
    """Return how many numbers come out.

    Args:
        found: Of all sources.
    """
    holds = [one.holds for one in found]
    return f"{sum(holds)} of {len(holds)} published numbers come out within their tolerance."


def _written(row: tuple[Cell, ...], one: Checked) -> tuple[Cell, ...]:
    expected, got, error, *words = row
    shown = [replace(cell, text=f"{cell.value:.{DIGITS}g}") for cell in (expected, got)]
    return (*shown, replace(error, text=f"{one.error:+.1e}{'' if one.holds else ' missed'}"), *words)
