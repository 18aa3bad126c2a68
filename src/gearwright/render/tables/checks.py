"""Checks as rows of a table, in the units of the trade, and as sentences."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated

from gearwright.checks import Check, Status
from gearwright.render.grid.table import Table, table
from gearwright.units import Quantity, digits_apart, margin_text, shown, unit, written

JUST_ENOUGH = (
    "Margin: the factor by which loads may grow; 1 is just enough. Of a safety value over limit, of a stress limit over"
    " value, of a bearing's life the root of life over limit (p = 3, rollers 10/3). What no load moves, such as room,"
    " passes or fails with its distance. Limits of stresses include the asked factor."
)
COLUMNS = ("part", "check", "case", "value", "limit", "unit", "margin", "source")
"""Of a check that is assessed."""


@dataclass(frozen=True)
class Judged:
    """A check as it is shown."""

    part: str
    check: str
    """Mode, symbol and place."""
    case: str
    """Load case that governs; empty where no single one does."""
    value: float | None
    """As computed, in the unit."""
    limit: float | None
    """What is allowed, in the unit."""
    unit: str
    """Empty for a ratio."""
    margin: Annotated[float | None, Quantity("ratio")]
    """1 is just enough [-]."""
    source: str
    """Equation or clause."""
    status: str
    """passes, fails, waived or not assessed."""
    why: str
    """Why it is waived or not assessed, or what else to know, such as what would help."""


def judged(checks: Iterable[Check]) -> tuple[Judged, ...]:
    """Return checks as they are shown, in the order in which they come.

    Args:
        checks: Of one gearbox.
    """
    return tuple(
        Judged(
            part=str(check.part),
            check=check.what,
            case=check.case,
            value=_shown(check.value, check.dimension),
            limit=_shown(check.limit, check.dimension),
            unit=unit(check.dimension),
            margin=check.margin,
            source=check.clause,
            status="waived" if check.waiver else str(check.status),
            why=check.waiver or check.why,
        )
        for check in checks
    )


def review_tables(checks: Iterable[Check]) -> tuple[Table, ...]:
    """Return what is assessed, the worst first, remarks on it, what is waived or not assessed, each as a table.

    Args:
        checks: Of one gearbox, in the order of `worst_first`.
    """
    rows = judged(checks)
    assessed = [row for row in rows if row.margin is not None]
    waived = [row for row in rows if row.status == "waived"]
    told = [row for row in assessed if row.why and row.status != "waived"]
    return (
        table("Checks, worst first", assessed, ("status", *COLUMNS), note=JUST_ENOUGH),
        table("Remarks", told, ("part", "check", "why")),
        table("Waived by the design", waived, ("part", "check", "why")),
        table("Not assessed", [row for row in rows if row.margin is None], ("part", "check", "why")),
    )


def _shown(value: float | None, dimension: str) -> float | None:
    return None if value is None else shown(value, dimension)


def check_sentence(check: Check) -> str:
    """Return part, check, value, limit, source, case and margin.

    Args:
        check: One that is assessed.
    """
    (row,) = judged([check])
    pair = row.value or 0.0, row.limit or 0.0
    digits = digits_apart(*pair) if check.status is Status.FAILS else 4
    value, limit = (f"{written(number, digits)} {row.unit}".rstrip() for number in pair)
    case = f", case {row.case}" if row.case else ""
    margin = margin_text(row.margin or 0.0)
    return f"{row.part}: {row.check} {value}, limit {limit} ({row.source}){case}: margin {margin}"
