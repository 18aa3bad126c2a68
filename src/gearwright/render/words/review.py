"""A review in words and for machines: the verdict, every check worst first, what is waived and what is left open."""

from __future__ import annotations

import json
import math

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.checks import Check
from gearwright.render.tables.checks import review_tables
from gearwright.render.words.headline import headline
from gearwright.render.words.text import table_text
from gearwright.reviews import Review
from gearwright.units import si_unit


def review_text(review: Review) -> RenderableType:
    """Return a review for the terminal.

    Args:
        review: Of a design.
    """
    flown = f", flying {review.mission}" if review.mission else ""
    notes = [f"The waiver of {name} is not needed: it passes." for name in review.unneeded]
    parts: list[RenderableType] = [Text(f"{review.design}{flown}", style="bold"), Text(f"{headline(review)}."), Text()]
    parts += [table_text(table) for table in review_tables(review.checks) if table.rows]
    return Group(*parts, *map(Text, notes))


def review_json(review: Review) -> str:
    """Return a review as JSON, in SI.

    Args:
        review: Of a design.
    """
    first = review.worst
    told = {
        "design": review.design,
        "mission": review.mission,
        "verdict": str(review.verdict),
        "worst": None if first is None else first.name,
        "margin": None if first is None else _finite(first.margin),
        "facts": {name: {"value": fact.value, "unit": si_unit(fact.dimension)} for name, fact in review.facts.items()},
        "checks": [_told(check) for check in review.checks],
        "unneeded_waivers": review.unneeded,
    }
    return json.dumps(told, indent=2, ensure_ascii=False, allow_nan=False)


def _told(check: Check) -> dict[str, object]:
    return {
        "name": check.name, "part": str(check.part), "kind": str(check.part.kind), "mode": check.mode,
        "symbol": check.symbol, "place": check.place, "case": check.case, "source": check.clause,
        "value": _finite(check.value), "limit": _finite(check.limit), "unit": si_unit(check.dimension),
        "at_most": check.at_most, "ratio": _finite(check.ratio), "reserve": _finite(check.reserve),
        "status": str(check.status), "waiver": check.waiver, "why": check.why,
    }  # fmt: skip


def _finite(value: float | None) -> float | None:
    """Return a number that JSON has: what nothing loads has no finite margin."""
    return value if value is not None and math.isfinite(value) else None
