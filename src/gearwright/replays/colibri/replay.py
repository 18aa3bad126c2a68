"""The Colibri report compared number by number with its own computation, and its tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache
from itertools import groupby

from rich.console import Group
from rich.text import Text

from gearwright.render.terminal import Grid
from gearwright.replays.colibri.report import (
    Assumption,
    ColibriErratum,
    PrintedNumber,
    Step,
    assumptions,
    colibri_errata,
    executed,
    printed_numbers,
)
from gearwright.replays.colibri.verdicts import Finding, colibri_facts, correct_values, findings
from gearwright.units import shown, text, unit

# ----------------------------------------------------------------------------------------------------------------------
# The Colibri report held against its own computation: 236 numbers, each with verdict, right value and reason.
# ----------------------------------------------------------------------------------------------------------------------


class Outcome(StrEnum):
    """What becomes of a printed number."""

    INPUT = "input"
    REPRODUCED = "reproduced"
    HIDDEN = "reproduced with a hidden assumption"
    WRONG = "wrong in source"


@dataclass(frozen=True)
class Replayed:
    """One number of the report, printed and computed."""

    printed: PrintedNumber
    """As it stands there."""
    computed: Step
    """By the report's own steps, mistakes included."""
    correct: Step | None
    """What is right, where that differs and can be said."""
    erratum: ColibriErratum | None
    """The mistake of its own step, if there is one."""

    @property
    def relative(self) -> float:
        """(computed − printed)/printed; the difference itself where 0 is printed [-]."""
        difference = self.computed.value - self.printed.value
        return difference / self.printed.value if self.printed.value else difference

    @property
    def outcome(self) -> Outcome:
        """A mistake outweighs an assumption, and an assumption a mere computation."""
        if self.erratum is not None:
            return Outcome.WRONG
        if self.printed.is_stated:
            return Outcome.INPUT
        return Outcome.HIDDEN if self.computed.assumptions else Outcome.REPRODUCED


@dataclass(frozen=True)
class Replay:
    """The whole report, computed."""

    numbers: tuple[Replayed, ...]
    """In its order."""
    findings: tuple[Finding, ...]
    """Whether what it designs can be made and would last."""
    errata: tuple[ColibriErratum, ...]
    """Its mistakes, with numbers filled in."""
    assumptions: Mapping[str, Assumption]
    """What it does not say, with numbers filled in."""

    def count(self, outcome: Outcome) -> int:
        """Return how many numbers have an outcome.

        Args:
            outcome: Which.
        """
        return sum(number.outcome is outcome for number in self.numbers)


@cache
def replay() -> Replay:
    """Return the report computed from its stated inputs; takes some hundredths of a second."""
    facts, steps, right = colibri_facts(), executed(), correct_values()
    errata = tuple(replace(one, why=one.why.format(**facts)) for one in colibri_errata())
    wrong = {row: one for one in errata for row in one.rows}
    numbers = tuple(
        Replayed(number, steps[number.key], right.get(number.key), wrong.get(number.key))
        for number in printed_numbers()
    )
    hidden = {
        key: replace(assumption, evidence=assumption.evidence.format(**facts))
        for key, assumption in assumptions().items()
    }
    return Replay(numbers, findings(), errata, hidden)


# ----------------------------------------------------------------------------------------------------------------------
# The Colibri replay in words: how its numbers are written, and tables for the terminal.
# ----------------------------------------------------------------------------------------------------------------------


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


def chosen(replayed: Replay, *, part: str = "", wrong: bool = False) -> tuple[Replayed, ...]:
    """Return the numbers of one part, or of all, and all or only the wrong ones.

    Args:
        replayed: Of `replay`.
        part: A key of `PARTS`; empty for all.
        wrong: Whether to leave out the others.
    """
    return tuple(
        number
        for number in replayed.numbers
        if (not part or number.printed.part == part) and (not wrong or number.outcome is Outcome.WRONG)
    )


def replay_tables(numbers: Sequence[Replayed], replayed: Replay) -> Group:
    """Return numbers for the terminal, a table for each part, then the reasons that they name.

    Args:
        numbers: Which to show.
        replayed: Of `replay`.
    """
    tables = [_table(part, list(rows)) for part, rows in groupby(numbers, lambda number: number.printed.part)]
    return Group(*tables, _reasons(numbers, replayed))


def findings_table(findings: Sequence[Finding]) -> Grid:
    """Return for the terminal what of the design cannot be made or would not last.

    Args:
        findings: Of `replay`.
    """
    table = Grid("Can it be made, and would it last?", spaced=True)
    for header in ("", "designed", "must be", "limit from"):
        table.add_column(header)
    for finding in findings:
        table.add_row(*map(Text, finding_cells(finding)), style="" if finding.holds else "red")
    return table


def finding_cells(finding: Finding) -> tuple[str, str, str, str]:
    """Return a finding as it is read: what, value, limit, source.

    Args:
        finding: With its numbers.
    """
    return (
        finding.what,
        _quantity(finding.value, finding),
        f"{finding.sense.value} {_quantity(finding.limit, finding)}",
        finding.source,
    )


def counts_text(replayed: Replay) -> str:
    """Return how many numbers are what, in one sentence.

    Args:
        replayed: Of `replay`.
    """
    parts = ", ".join(f"{replayed.count(outcome)} {outcome.value}" for outcome in Outcome)
    return f"{len(replayed.numbers)} printed numbers: {parts}."


def computed_text(number: Replayed) -> str:
    """Return what was computed, with the unit's digits.

    Args:
        number: Number.
    """
    return _signed(f"{number.computed.value / number.printed.scale:.{_DIGITS}g}")


def difference_text(number: Replayed) -> str:
    """Return the relative difference between computed and printed.

    Args:
        number: Number.
    """
    return "0" if abs(number.relative) < _EXACT else _signed(f"{number.relative:.1e}")


def correct_text(number: Replayed) -> str:
    """Return what is right in place of a wrong number; empty where nothing is wrong, a dash where it stays open.

    Args:
        number: Number.
    """
    if number.correct is None:
        return "–" if number.outcome is Outcome.WRONG else ""
    value = number.correct.value / number.printed.scale
    return _signed(f"{value:.0f}" if abs(value) >= 10.0 ** (_CORRECT_DIGITS - 1) else f"{value:.{_CORRECT_DIGITS}g}")


def reason_keys(number: Replayed) -> tuple[str, ...]:
    """Return the keys of the mistake and of the assumptions behind a number.

    Args:
        number: Number.
    """
    return (*([number.erratum.key] if number.erratum else []), *number.computed.assumptions)


def finding_in_unit(finding: Finding) -> tuple[str, float, str, float, str, str, bool]:
    """Return what a finding says: what, value, sense, limit, the unit of both, source, and whether it holds.

    Args:
        finding: With its numbers.
    """
    value, name = _in_unit(finding.value, finding)
    limit, _ = _in_unit(finding.limit, finding)
    return finding.what, value, finding.sense.value, limit, name, finding.source, finding.holds


def _table(part: str, rows: Sequence[Replayed]) -> Grid:
    table = Grid(PARTS[part])
    table.add_column("", no_wrap=True)
    table.add_column("unit")
    for header in ("printed", "computed", "difference"):
        table.add_column(header, justify="right")
    table.add_column("verdict")
    table.add_column("correct", justify="right")
    for place, numbers in groupby(rows, lambda number: number.printed.place):
        table.add_section()
        table.add_row(Text(place.rpartition(", ")[2], style="bold"))
        for number in numbers:
            table.add_row(*map(Text, _cells(number)), style=_STYLES[number.outcome])
    return table


def _cells(number: Replayed) -> Iterator[str]:
    verdict = _SHORT.get(number.outcome, number.outcome.value)
    yield from (number.printed.symbol, number.printed.unit, _signed(number.printed.printed), computed_text(number))
    yield from (difference_text(number), " ".join((verdict, *reason_keys(number))), correct_text(number))


def _reasons(numbers: Sequence[Replayed], replayed: Replay) -> Grid:
    named = {key for number in numbers for key in reason_keys(number)}
    table = Grid("Reasons", show_header=False, spaced=True)
    table.add_column("")
    table.add_column("")
    for mistake in replayed.errata:
        if mistake.key in named:
            table.add_row(Text(mistake.key, style="red"), Text(f"{mistake.title}. {mistake.why}"))
    for assumption in replayed.assumptions.values():
        if assumption.key in named:
            table.add_row(Text(assumption.key, style="yellow"), Text(f"{assumption.text} {assumption.evidence}"))
    return table


def _quantity(value: float, finding: Finding) -> str:
    if finding.dimension == "time":
        number, name = _in_unit(value, finding)
        return f"{number:.0f} {name}"
    return text(value, finding.dimension)


def _in_unit(value: float, finding: Finding) -> tuple[float, str]:
    """Return a value and its unit; lives are in hours."""
    if finding.dimension == "time":
        return value / _HOUR, "h"
    return shown(value, finding.dimension), unit(finding.dimension)


def _signed(number: str) -> str:
    return number.replace("-", "−")
