"""The Colibri replay as one self-contained page, and as Markdown for the documentation."""

from __future__ import annotations

import html
import re
from functools import cache
from itertools import groupby

from jinja2 import Environment
from markupsafe import Markup

from gearwright.render.style.templates import environment
from gearwright.replays.colibri import words
from gearwright.replays.colibri.replay import Outcome, replay
from gearwright.replays.colibri.report.printed import SOURCE
from gearwright.version import __version__

_INDEX = re.compile(r"_([A-Za-z0-9αβ]+)")
_CLASSES = {Outcome.INPUT: "input", Outcome.REPRODUCED: "same", Outcome.HIDDEN: "hidden", Outcome.WRONG: "wrong"}


def colibri_page() -> str:
    """Return the page as HTML that makes no request to anywhere."""
    return _rendered("page.html.j2")


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
    replayed = replay()
    grouped = [
        (
            words.PARTS[part],
            part,
            [(place, list(rows)) for place, rows in groupby(list(of), lambda number: number.printed.place)],
        )
        for part, of in groupby(replayed.numbers, lambda number: number.printed.part)
    ]
    return (
        _environment()
        .get_template(template)
        .render(
            found=replayed,
            parts=grouped,
            outcomes=Outcome,
            counts={
                part: [sum(row.outcome is outcome for _, rows in places for row in rows) for outcome in Outcome]
                for _, part, places in grouped
            },
            source=SOURCE,
            version=__version__,
        )
    )


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
