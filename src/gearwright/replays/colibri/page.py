"""The Colibri replay as one self-contained page, and as Markdown for the documentation."""

from __future__ import annotations

import html
import re
from functools import cache
from itertools import groupby
from typing import Any

from jinja2 import Environment
from markupsafe import Markup

from gearwright.render.pages.page import Number, Page, Section, Tone, Verdict, set_page
from gearwright.render.style.templates import environment
from gearwright.replays.colibri import words
from gearwright.replays.colibri.replay import Outcome, replay
from gearwright.replays.colibri.report.printed import SOURCE
from gearwright.version import __version__

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
    return _rendered("page.md.j2")


def indexed(written: str) -> Markup:
    """Return words with what follows an underscore set as an index, safe for HTML.

    Args:
        written: With formulas such as ``F_a/C_0``.

    >>> str(indexed("F_a < e"))
    'F<sub>a</sub> &lt; e'
    """
    return Markup(_INDEX.sub(r"<sub>\1</sub>", html.escape(written, quote=False)))


def _rendered(template: str) -> str:
    return _environment().get_template(template).render(_context())


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
