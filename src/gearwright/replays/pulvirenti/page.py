"""The errata and claims of Pulvirenti (2023) as tables: words for the terminal, Markdown, one self-contained page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache

from jinja2 import Environment
from rich.text import Text

from gearwright.render.grid.grid import Grid
from gearwright.render.grid.table import written
from gearwright.render.style.templates import environment
from gearwright.replays.pulvirenti.claims import Claim, claims
from gearwright.replays.pulvirenti.errata import Erratum, errata
from gearwright.replays.verdict import Verdict
from gearwright.units import unit
from gearwright.version import __version__

_DIGITS = 3
_STYLES = {Verdict.HOLDS: "green", Verdict.CONDITION: "yellow", Verdict.FAILS: "red"}
_SIGNS = {Verdict.HOLDS: "yes", Verdict.CONDITION: "partly", Verdict.FAILS: "no"}


def thesis_page() -> str:
    """Return the page as HTML that makes no request to anywhere."""
    return _rendered("page.html.j2")


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
    judged = claims()
    return (
        _environment()
        .get_template(template)
        .render(
            claims=judged,
            errata=errata(),
            counts={verdict: sum(claim.verdict is verdict for claim in judged) for verdict in Verdict},
            version=__version__,
        )
    )


@cache
def _environment() -> Environment:
    pages = environment("gearwright.replays.pulvirenti")
    pages.filters |= {"computed": computed_text, "covered": covered_text, "sign": _SIGNS.__getitem__}
    return pages
