"""The Colibri replay as an answer to machines: numbers in the units of the report, findings and reasons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gearwright.replays.colibri.replay import Outcome, Replay, Replayed
from gearwright.replays.colibri.report.steps import Step
from gearwright.replays.colibri.words import finding_in_unit, reason_keys


@dataclass(frozen=True)
class PrintedNumber:
    """A number of the report beside the computed one."""

    key: str
    place: str
    symbol: str
    unit: str
    """Of the numbers, as the report has it."""
    printed: str
    computed: float
    how: str
    relative_difference: float
    verdict: Outcome
    correct: float | None
    """What is right in its place; null where nothing is wrong, or where it stays open."""
    correct_how: str | None
    reasons: tuple[str, ...]
    """Keys of errata and assumptions."""


@dataclass(frozen=True)
class Held:
    """Something of the design that can be made and lasts, or not."""

    what: str
    value: float
    sense: str
    limit: float
    unit: str
    """Of value and limit."""
    source: str
    holds: bool


@dataclass(frozen=True)
class Mistake:
    """An erratum of the report."""

    key: str
    title: str
    why: str


@dataclass(frozen=True)
class Taken:
    """An assumption that the report does not state."""

    key: str
    text: str
    evidence: str


@dataclass(frozen=True)
class ColibriAnswer:
    """Every printed number of the report, computed."""

    counts: Mapping[str, int]
    """Verdict -> numbers, of the whole report."""
    numbers: tuple[PrintedNumber, ...]
    findings: tuple[Held, ...]
    errata: tuple[Mistake, ...]
    assumptions: tuple[Taken, ...]


def colibri_answer(numbers: Sequence[Replayed], replayed: Replay) -> ColibriAnswer:
    """Return what `gearwright replay colibri --json` answers.

    Args:
        numbers: Which to tell.
        replayed: Of `replay`.
    """
    return ColibriAnswer(
        counts={outcome.value: replayed.count(outcome) for outcome in Outcome},
        numbers=tuple(_number(number) for number in numbers),
        findings=tuple(Held(*finding_in_unit(finding)) for finding in replayed.findings),
        errata=tuple(Mistake(erratum.key, erratum.title, erratum.why) for erratum in replayed.errata),
        assumptions=tuple(Taken(taken.key, taken.text, taken.evidence) for taken in replayed.assumptions.values()),
    )


def _number(number: Replayed) -> PrintedNumber:
    def value(step: Step) -> float:
        return step.value / number.printed.scale

    return PrintedNumber(
        key=number.printed.key,
        place=number.printed.place,
        symbol=number.printed.symbol,
        unit=number.printed.unit,
        printed=number.printed.printed,
        computed=value(number.computed),
        how=number.computed.how,
        relative_difference=number.relative,
        verdict=number.outcome,
        correct=None if number.correct is None else value(number.correct),
        correct_how=number.correct.how if number.correct else None,
        reasons=tuple(reason_keys(number)),
    )
