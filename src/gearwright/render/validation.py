"""The validation table: every published number beside what gearwright finds."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from gearwright.render.tables import Table, table
from gearwright.validate import Case, Checked, check


@dataclass(frozen=True)
class Row:
    """One number."""

    case: str
    source: str
    unit: str
    expected: str
    """With the digits that are compared."""
    got: str
    error: str
    """Deviation over the number."""
    verdict: str


def validation_table(cases: Iterable[Case]) -> tuple[Table, int]:
    """Return the table, and how many numbers are missed.

    Args:
        cases: Published results.
    """
    found = [one for case in cases for one in check(case)]
    missed = sum(not one.holds for one in found)
    note = f"{len(found) - missed} of {len(found)} published numbers come out within their tolerance."
    fields = ("case", "source", "expected", "got", "unit", "error", "verdict")
    return table("Validation", [_row(one) for one in found], fields, note=note), missed


def _row(one: Checked) -> Row:
    words = "holds" if one.holds else f"missed ({one.reason})"
    return Row(one.case, one.source, one.unit, f"{one.expected:.7g}", f"{one.got:.7g}", f"{one.error:+.1e}", words)
