"""A review by requirements: what fails and what would help, and of every requirement its worst check."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated

from gearwright.checks import Check, Status, worst_first
from gearwright.closure import REQUIREMENTS, requirement_of
from gearwright.render.grid import Table, table
from gearwright.render.tables.checks import Judged, judged
from gearwright.units import Quantity

_NOTHING = ("nothing", "nothing yet")
"""What is told of requirements that the closure changes nothing for."""
_ORDERS = "critical speeds"
"""Requirement that orders belong to."""
_NOTE = (
    "Worst first. Before “else”: what gearwright close changes by itself. Margin: the factor by which loads may grow;"
    " what no load moves, by its distance to the limit."
)


@dataclass(frozen=True)
class Failed:
    """A check that fails, and what would help."""

    part: str
    check: str
    """Mode, symbol and place."""
    case: str
    value: float | None
    """In the unit."""
    limit: float | None
    """In the unit."""
    unit: str
    margin: Annotated[float | None, Quantity("ratio")]
    """1 is just enough [-]."""
    source: str
    what_would_help: str


@dataclass(frozen=True)
class Met:
    """One requirement as a whole."""

    requirement: str
    status: str
    checks: int
    """That are assessed."""
    fail: int
    waived: int
    not_assessed: int
    worst: str
    """Part and check."""
    margin: Annotated[float | None, Quantity("ratio")]
    """Of the worst [-]."""


def failed_table(checks: Iterable[Check]) -> Table:
    """Return what fails, with its limit, its source and what would help.

    Args:
        checks: Of a review.
    """
    rows = [_failed(check) for check in checks if check.fails]
    fields = ("part", "check", "case", "value", "limit", "unit", "margin", "source", "what_would_help")
    return table("", rows, fields, note=_NOTE)


def met_table(checks: Iterable[Check]) -> Table:
    """Return every requirement that checks belong to: those that fail first, then by the worst margin.

    Args:
        checks: Of a review.
    """
    groups: dict[str, list[Check]] = {}
    for check in worst_first(checks):
        groups.setdefault(requirement_of(check), []).append(check)
    rows = sorted((_met(name, group) for name, group in groups.items()), key=_place)
    fields = ("requirement", "status", "checks", "fail", "waived", "not_assessed", "worst", "margin")
    return table("", rows, fields)


def order_table(checks: Iterable[Check]) -> Table:
    """Return every order that excites a mode, or comes near none, the nearest to its limit first.

    Args:
        checks: Of a review.
    """
    orders = [check for check in worst_first(checks) if requirement_of(check) == _ORDERS and check.ratio is not None]
    rows = [
        _Order(check.mode, check.place, check.case, check.value, check.limit, row.status)
        for check, row in zip(orders, judged(orders), strict=True)
    ]
    return table("", rows, ("order", "nearest", "case", "distance", "asked", "status"))


def open_table(checks: Iterable[Check]) -> Table:
    """Return what is not assessed, equal reasons together.

    Args:
        checks: Of a review.
    """
    groups: dict[tuple[str, str], list[Judged]] = {}
    for row in judged(check for check in checks if check.status is Status.NOT_ASSESSED):
        groups.setdefault((row.check, row.why), []).append(row)
    rows = [_Open(", ".join(row.part for row in group), check, why) for (check, why), group in groups.items()]
    return table("", rows, ("part", "check", "why"))


def waived_table(checks: Iterable[Check]) -> Table:
    """Return what fails and is accepted, with the reason.

    Args:
        checks: Of a review.
    """
    return table("", judged(check for check in checks if check.waiver), ("part", "check", "margin", "why"))


@dataclass(frozen=True)
class _Order:
    order: str
    nearest: str
    case: str
    distance: Annotated[float | None, Quantity("percent")]
    asked: Annotated[float | None, Quantity("percent")]
    status: str


@dataclass(frozen=True)
class _Open:
    part: str
    check: str
    why: str


def _failed(check: Check) -> Failed:
    (row,) = judged([check])
    requirement = REQUIREMENTS[requirement_of(check)]
    moved = "" if requirement.moved_by in _NOTHING else f"{requirement.moved_by}; else "
    return Failed(
        row.part, row.check, row.case, row.value, row.limit, row.unit, row.margin, row.source,
        what_would_help=f"{moved}{requirement.helps}",
    )  # fmt: skip


def _met(name: str, checks: list[Check]) -> Met:
    """Return a requirement; the first of its checks is the worst."""
    fails, waived = (sum(1 for check in checks if of(check)) for of in (_fails, _waived))
    left = sum(1 for check in checks if check.status is Status.NOT_ASSESSED)
    assessed = len(checks) - left
    first = checks[0]
    said = "fails" if fails else "waived" if waived else "not assessed" if not assessed else "passes"
    words = "" if not assessed else f"{first.part}: {first.what}"
    return Met(name, said, assessed, fails, waived, left, words, first.margin)


def _fails(check: Check) -> bool:
    return check.fails


def _waived(check: Check) -> bool:
    return bool(check.waiver)


def _place(row: Met) -> tuple[int, float]:
    return ("fails", "waived", "passes", "not assessed").index(row.status), row.margin or 0.0
