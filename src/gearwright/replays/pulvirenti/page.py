"""The errata and claims of Pulvirenti (2023) as tables: words for the terminal, Markdown, one self-contained page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from typing import Any

from jinja2 import Environment
from markupsafe import Markup
from rich.text import Text

from gearwright.render.grid.grid import Grid
from gearwright.render.pages.page import Number, Page, Section, Tone, set_page
from gearwright.render.pages.page import Verdict as Judged
from gearwright.render.style.templates import environment
from gearwright.replays.pulvirenti.claims import Claim, claims
from gearwright.replays.pulvirenti.errata import Erratum, errata
from gearwright.replays.verdict import Verdict
from gearwright.units import unit, written
from gearwright.version import __version__

_TITLE = "Pulvirenti 2023: what it claims, what it prints, what gearwright uses"
_LEAD = (
    "The thesis on hybrid-electric turboprop gearboxes is where gearwright's first sizing comes from. This "
    "page holds its claims against what its own equations give once they are right, and lists the "
    "corrections."
)
_FOOTER = (
    "Text: doubtful words, not a formula. Right: doubted, and found right. Provable: by dimension, balance "
    "or geometry. Scan: the misprint may be that of the scanned text."
)
_DIGITS = 3
_STYLES = {Verdict.HOLDS: "green", Verdict.CONDITION: "yellow", Verdict.FAILS: "red"}
_SIGNS = {Verdict.HOLDS: "yes", Verdict.CONDITION: "partly", Verdict.FAILS: "no"}


def thesis_page() -> str:
    """Return the page as HTML that makes no request to anywhere."""
    counts = _context()["counts"]
    parts: Any = _environment().get_template("page.html.j2").make_module(_context())
    failing, held = counts[Verdict.FAILS], counts[Verdict.HOLDS]
    total = sum(counts.values())
    said = f"{held} hold, {counts[Verdict.CONDITION]} hold with a condition, {failing} do not hold."
    word = f"{failing} of {total} claims do not hold" if failing else "Every claim holds"
    sections = (
        Section(f"{total} claims", content=Markup(parts.part_claims())),
        Section(f"{len(errata())} doubtful passages", content=Markup(parts.part_errata())),
    )
    numbers = (*(Number(verdict.value, f"{count}") for verdict, count in counts.items()),
               Number("doubtful passages", f"{len(errata())}"))  # fmt: skip
    verdict = Judged(Tone.BAD if failing else Tone.GOOD, word, said)
    return set_page(Page("Replay", _TITLE, _LEAD, verdict, numbers, sections, footer=_FOOTER))


def thesis_markdown() -> str:
    """Return the same as Markdown, for the documentation."""
    return _rendered("page.md.j2")


def claims_table(judged: Sequence[Claim]) -> Grid:
    """Return the claims for the terminal.

    Args:
        judged: Of `claims`.
    """
    table = Grid("Claims of Pulvirenti 2023, and what its equations give once they are right", names=0, spaced=True)
    for header in ("printed", "computed", "verdict"):
        table.add_column(header)
    for claim in judged:
        table.add_row(
            claim.printed.printed, computed_text(claim), Text(claim.verdict.value, style=_STYLES[claim.verdict])
        )
    return table


def errata_table(listed: Sequence[Erratum]) -> Grid:
    """Return the errata for the terminal.

    Args:
        listed: Of `errata`.
    """
    table = Grid("Errata of Pulvirenti 2023", spaced=True)
    for header in ("equation", "standing", "printed", "correct"):
        table.add_column(header)
    for erratum in listed:
        table.add_row(erratum.equation, erratum.standing, Text(erratum.printed), Text(erratum.correct))
    return table


def computed_text(claim: Claim) -> str:
    """Return what was computed, by each way of counting.

    Args:
        claim: With its numbers.
    """
    first = f"{_number(claim.value, claim.printed.dimension)} ({claim.printed.counts})"
    if claim.other is None:
        return first
    return f"{first}; {_number(claim.other, claim.printed.dimension)} ({claim.printed.other})"


def covered_text(claim: Claim) -> str:
    """Return which numbers the wording covers.

    Args:
        claim: With its printed side.
    """
    low, high, dimension = claim.printed.low, claim.printed.high, claim.printed.dimension
    if math.isinf(high):
        return f"above {_number(low, dimension)}"
    if low == 0.0:
        return f"below {_number(high, dimension)}"
    return f"{_number(low, dimension)} to {_number(high, dimension)}"


def _number(value: float, dimension: str) -> str:
    if dimension == "percent":
        return f"{value:.1f} %".replace("-", "−")
    return f"{written(value, 4 if dimension == 'speed' else _DIGITS)} {unit(dimension)}".rstrip()


def _rendered(template: str) -> str:
    return _environment().get_template(template).render(_context())


def _context() -> dict[str, Any]:
    judged = claims()
    return {
        "claims": judged,
        "errata": errata(),
        "counts": {verdict: sum(claim.verdict is verdict for claim in judged) for verdict in Verdict},
        "version": __version__,
    }


@cache
def _environment() -> Environment:
    pages = environment("gearwright.replays.pulvirenti")
    pages.filters |= {"computed": computed_text, "covered": covered_text, "sign": _SIGNS.__getitem__}
    return pages
