"""The Colibri report held against its own computation: 236 numbers, each with verdict, right value and reason."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache

from gearwright.replays.colibri.report.chain import executed
from gearwright.replays.colibri.report.printed import (
    Assumption,
    ColibriErratum,
    PrintedNumber,
    assumptions,
    colibri_errata,
    printed_numbers,
)
from gearwright.replays.colibri.report.steps import Step
from gearwright.replays.colibri.verdicts.correct import correct_values
from gearwright.replays.colibri.verdicts.facts import colibri_facts
from gearwright.replays.colibri.verdicts.findings import Finding, findings


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
