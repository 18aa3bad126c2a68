"""The claims of the paper as a table for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import RenderableType

from gearwright.render.grid.table import table
from gearwright.render.pages.sharing import ClaimRow
from gearwright.render.words.text import table_text


def claims_table(claims: Sequence[ClaimRow]) -> RenderableType:
    """Return what the paper says, what becomes of it, and why.

    Args:
        claims: Of the paper.
    """
    return table_text(table("Claims of the paper", claims, ("place", "printed", "verdict", "why")))
