"""The Colibri replay in words: how its numbers are written, tables for the terminal, and the whole as a record."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any

from rich.console import Group
from rich.text import Text

from gearwright.render.tables.grid import Grid
from gearwright.replays.colibri.findings import Finding
from gearwright.replays.colibri.replay import Outcome, Replay, Replayed
from gearwright.replays.colibri.steps import Step
from gearwright.units import shown, text, unit

PARTS = {
    "requirement": "Requirement", "material": "Material", "helical-pinion": "Helical pinion",
    "helical-wheel": "Helical wheel", "bevel-pinion": "Bevel pinion", "bevel-wheel": "Bevel wheel",
    "shaft-1": "Shaft 1, the engine's", "shaft-2": "Shaft 2, between the stages", "rotor-shaft": "Rotor shaft",
}  # fmt: skip
"""First half of the keys -> title, in the report's order."""
_STYLES = {Outcome.INPUT: "dim", Outcome.REPRODUCED: "", Outcome.HIDDEN: "yellow", Outcome.WRONG: "red"}
_SHORT = {Outcome.HIDDEN: "reproduced", Outcome.WRONG: "wrong"}
_DIGITS, _CORRECT_DIGITS = 10, 5
_EXACT = 5e-13
"""Relative difference below which only floating-point rounding is left [-]."""
_HOUR = 3600.0


def chosen(found: Replay, *, part: str = "", wrong: bool = False) -> tuple[Replayed, ...]:
    """Return the numbers of one part, or of all, and all or only the wrong ones.

    Args:
        found: Of `replay`.
        part: A key of `PARTS`; empty for all.
        wrong: Whether to leave out the others.
    """
    return tuple(
        number
        for number in found.numbers
        if (not part or number.printed.part == part) and (not wrong or number.outcome is Outcome.WRONG)
    )


def replay_tables(numbers: Sequence[Replayed], found: Replay) -> Group:
    """Return numbers for the terminal, a table for each part, then the reasons that they name.

    Args:
        numbers: Which to show.
        found: Of `replay`.
    """
    tables = [_table(part, list(rows)) for part, rows in groupby(numbers, lambda one: one.printed.part)]
    return Group(*tables, _reasons(numbers, found))


def findings_table(found: Sequence[Finding]) -> Grid:
    """Return for the terminal what of the design cannot be made or would not last.

    Args:
        found: Of `replay`.
    """
    table = Grid("Can it be made, and would it last?", spaced=True)
    for header in ("", "designed", "must be", "limit from"):
        table.add_column(header)
    for one in found:
        table.add_row(*map(Text, finding_cells(one)), style="" if one.holds else "red")
    return table


def finding_cells(one: Finding) -> tuple[str, str, str, str]:
    """Return a finding as it is read: what, value, limit, source.

    Args:
        one: With its numbers.
    """
    return one.what, _quantity(one.value, one), f"{one.sense.value} {_quantity(one.limit, one)}", one.source


def counts_text(found: Replay) -> str:
    """Return how many numbers are what, in one sentence.

    Args:
        found: Of `replay`.
    """
    parts = ", ".join(f"{found.count(outcome)} {outcome.value}" for outcome in Outcome)
    return f"{len(found.numbers)} printed numbers: {parts}."


def computed_text(one: Replayed) -> str:
    """Return what was computed, with the unit's digits.

    Args:
        one: Number.
    """
    return _signed(f"{one.computed.value / one.printed.scale:.{_DIGITS}g}")


def difference_text(one: Replayed) -> str:
    """Return the relative difference between computed and printed.

    Args:
        one: Number.
    """
    return "0" if abs(one.relative) < _EXACT else _signed(f"{one.relative:.1e}")


def correct_text(one: Replayed) -> str:
    """Return what is right in place of a wrong number; empty where nothing is wrong, a dash where it stays open.

    Args:
        one: Number.
    """
    if one.correct is None:
        return "–" if one.outcome is Outcome.WRONG else ""
    value = one.correct.value / one.printed.scale
    return _signed(f"{value:.0f}" if abs(value) >= 10.0 ** (_CORRECT_DIGITS - 1) else f"{value:.{_CORRECT_DIGITS}g}")


def reason_keys(one: Replayed) -> tuple[str, ...]:
    """Return the keys of the mistake and of the assumptions behind a number.

    Args:
        one: Number.
    """
    return (*([one.erratum.key] if one.erratum else []), *one.computed.assumptions)


def replay_record(numbers: Sequence[Replayed], found: Replay) -> dict[str, Any]:
    """Return numbers, findings and reasons for machines, numbers in the units of the report.

    Args:
        numbers: Which to write.
        found: Of `replay`.
    """
    return {
        "counts": {outcome.value: found.count(outcome) for outcome in Outcome},
        "numbers": [_record(number) for number in numbers],
        "findings": [_finding_record(finding) for finding in found.findings],
        "errata": [{"key": one.key, "title": one.title, "why": one.why} for one in found.errata],
        "assumptions": [
            {"key": assumption.key, "text": assumption.text, "evidence": assumption.evidence}
            for assumption in found.assumptions.values()
        ],
    }


def _record(one: Replayed) -> dict[str, Any]:
    def value(step: Step | None) -> float | None:
        return None if step is None else step.value / one.printed.scale

    return {
        "key": one.printed.key,
        "place": one.printed.place,
        "symbol": one.printed.symbol,
        "unit": one.printed.unit,
        "printed": one.printed.printed,
        "computed": value(one.computed),
        "how": one.computed.how,
        "relative_difference": one.relative,
        "verdict": one.outcome.value,
        "correct": value(one.correct),
        "correct_how": one.correct.how if one.correct else None,
        "reasons": list(reason_keys(one)),
    }


def _finding_record(one: Finding) -> dict[str, Any]:
    value, name = _in_unit(one.value, one)
    limit, _ = _in_unit(one.limit, one)
    sides = {"what": one.what, "value": value, "sense": one.sense.value, "limit": limit, "unit": name}
    return {**sides, "source": one.source, "holds": one.holds}


def _table(part: str, rows: Sequence[Replayed]) -> Grid:
    table = Grid(PARTS[part])
    table.add_column("", no_wrap=True)
    table.add_column("unit")
    for header in ("printed", "computed", "difference"):
        table.add_column(header, justify="right")
    table.add_column("verdict")
    table.add_column("correct", justify="right")
    for place, numbers in groupby(rows, lambda one: one.printed.place):
        table.add_section()
        table.add_row(Text(place.rpartition(", ")[2], style="bold"))
        for number in numbers:
            table.add_row(*map(Text, _cells(number)), style=_STYLES[number.outcome])
    return table


def _cells(one: Replayed) -> Iterator[str]:
    verdict = _SHORT.get(one.outcome, one.outcome.value)
    yield from (one.printed.symbol, one.printed.unit, _signed(one.printed.printed), computed_text(one))
    yield from (difference_text(one), " ".join((verdict, *reason_keys(one))), correct_text(one))


def _reasons(numbers: Sequence[Replayed], found: Replay) -> Grid:
    named = {key for number in numbers for key in reason_keys(number)}
    table = Grid("Reasons", show_header=False, spaced=True)
    table.add_column("")
    table.add_column("")
    for mistake in found.errata:
        if mistake.key in named:
            table.add_row(Text(mistake.key, style="red"), Text(f"{mistake.title}. {mistake.why}"))
    for assumption in found.assumptions.values():
        if assumption.key in named:
            table.add_row(Text(assumption.key, style="yellow"), Text(f"{assumption.text} {assumption.evidence}"))
    return table


def _quantity(value: float, one: Finding) -> str:
    if one.dimension == "time":
        number, name = _in_unit(value, one)
        return f"{number:.0f} {name}"
    return text(value, one.dimension)


def _in_unit(value: float, one: Finding) -> tuple[float, str]:
    """Return a value and its unit; lives are in hours."""
    if one.dimension == "time":
        return value / _HOUR, "h"
    return shown(value, one.dimension), unit(one.dimension)


def _signed(number: str) -> str:
    return number.replace("-", "−")
