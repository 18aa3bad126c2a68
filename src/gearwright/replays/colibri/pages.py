"""The Colibri replication as a page, as Markdown and as machine-readable output."""

import html
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from typing import Any

from jinja2 import Environment
from markupsafe import Markup

from gearwright.render.pages.page import Number, Page, Section, Tone, Verdict, environment, set_page
from gearwright.replays.colibri import replay as words
from gearwright.replays.colibri.replay import ColibriReplay, Outcome, Replayed, finding_in_unit, reason_keys, replay
from gearwright.replays.colibri.report import SOURCE, Step
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# The Colibri replay as one self-contained page, and as Markdown for the documentation.
# ----------------------------------------------------------------------------------------------------------------------


_LEAD = (
    'A students\' term project sizes the transmission of an EC120B "Colibri": a helical pair, a bevel pair, '
    "three shafts, their bearings and keys ({source}). This page computes each of its {total} printed "
    "numbers from the {inputs} that it states, by its own steps. Where a number is wrong, the step repeats "
    "the mistake on purpose, so that the printed digits come out; beside it stands the right value, "
    "computed by gearwright."
)
_FOOTER = (
    "Difference: computed less printed, over printed. Correct values mend the mistake of their own step "
    "and keep what the report has before it."
)
_INDEX = re.compile(r"_([A-Za-z0-9αβ]+)")
_CLASSES = {Outcome.INPUT: "input", Outcome.REPRODUCED: "same", Outcome.HIDDEN: "hidden", Outcome.WRONG: "wrong"}


def colibri_page() -> str:
    """Return the page as HTML that makes no request to anywhere."""
    context = _context()
    found: Any = context["found"]
    made: Any = _environment().get_template("page.html.j2").make_module(context)
    wrong, total = found.count(Outcome.WRONG), len(found.numbers)
    failing = sum(not finding.holds for finding in found.findings)
    said = f"{failing} of {len(found.findings)} checks of the design as printed fail."
    sections = (
        Section("How much of it is right", content=Markup(made.part_overview())),
        Section("Can it be made, and would it last?", content=Markup(made.part_findings())),
        *(Section(title, content=Markup(made.part_numbers(part, places))) for title, part, places in context["parts"]),
        Section("What is wrong", content=Markup(made.part_errata())),
        Section("What it does not say", content=Markup(made.part_assumptions())),
    )
    numbers = tuple(Number(outcome.value, f"{found.count(outcome)}") for outcome in Outcome)
    verdict = Verdict(Tone.BAD if wrong else Tone.GOOD, f"{wrong} of {total} printed numbers are wrong", said)
    lead = _LEAD.format(source=SOURCE, total=total, inputs=found.count(Outcome.INPUT))
    return set_page(Page("Replay", "The Colibri report, computed", lead, verdict, numbers, sections, footer=_FOOTER))


def colibri_markdown() -> str:
    """Return the same as Markdown, for the documentation."""
    return _environment().get_template("page.md.j2").render(_context())


def indexed(written: str) -> Markup:
    """Return words with what follows an underscore set as an index, safe for HTML.

    Args:
        written: With formulas such as ``F_a/C_0``.

    >>> str(indexed("F_a < e"))
    'F<sub>a</sub> &lt; e'
    """
    return Markup(_INDEX.sub(r"<sub>\1</sub>", html.escape(written, quote=False)))


def _context() -> dict[str, Any]:
    replayed = replay()
    grouped = [
        (
            words.PARTS[part],
            part,
            [(place, list(rows)) for place, rows in groupby(list(of), lambda number: number.printed.place)],
        )
        for part, of in groupby(replayed.numbers, lambda number: number.printed.part)
    ]
    return {
        "found": replayed,
        "parts": grouped,
        "outcomes": Outcome,
        "counts": {
            part: [sum(row.outcome is outcome for _, rows in places for row in rows) for outcome in Outcome]
            for _, part, places in grouped
        },
        "source": SOURCE,
        "version": __version__,
    }


@cache
def _environment() -> Environment:
    pages = environment("gearwright.replays.colibri")
    pages.filters |= {
        "indexed": indexed,
        "class": _CLASSES.__getitem__,
        "computed": words.computed_text,
        "difference": words.difference_text,
        "correct": words.correct_text,
        "cells": words.finding_cells,
    }
    return pages


# ----------------------------------------------------------------------------------------------------------------------
# The Colibri replay as an answer to machines: numbers in the units of the report, findings and reasons.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ComparedNumber:
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
    numbers: tuple[ComparedNumber, ...]
    findings: tuple[Held, ...]
    errata: tuple[Mistake, ...]
    assumptions: tuple[Taken, ...]


def colibri_answer(numbers: Sequence[Replayed], replayed: ColibriReplay) -> ColibriAnswer:
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


def _number(number: Replayed) -> ComparedNumber:
    def value(step: Step) -> float:
        return step.value / number.printed.scale

    return ComparedNumber(
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
