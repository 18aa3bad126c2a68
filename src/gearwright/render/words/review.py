"""A review in words: the verdict, every check worst first, what is waived and what is left open."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.render.tables.checks import review_tables
from gearwright.render.words.headline import headline, unneeded_text
from gearwright.render.words.text import table_text
from gearwright.reviews import Review


def review_text(review: Review) -> RenderableType:
    """Return a review for the terminal.

    Args:
        review: Of a design.
    """
    flown = f", flying {review.mission}" if review.mission else ""
    notes = [f"{unneeded_text(name)}." for name in review.unneeded]
    parts: list[RenderableType] = [Text(f"{review.design}{flown}", style="bold"), Text(f"{headline(review)}."), Text()]
    parts += [table_text(table) for table in review_tables(review.checks) if table.rows]
    return Group(*parts, *map(Text, notes))
