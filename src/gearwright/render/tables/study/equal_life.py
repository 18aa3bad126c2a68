"""Architectures at equal life as a table: what each weighs with everything in it, and what it does not meet."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.render.grid.table import Table, table
from gearwright.study.running.equal_life import EqualLife

_COLUMNS = (
    "design", "variant", "verdict", "complete_mass", "lightest", "heaviest", "gears_and_shafts", "machines", "life",
    "limits", "fails",
)  # fmt: skip


def equal_life_table(rows: Sequence[EqualLife], title: str) -> Table:
    """Return the table.

    Args:
        rows: In their order.
        title: In words.
    """
    note = (
        "Complete mass with its band of 68 %, machines not in it; gears and shafts alone beside it, wheels as solid as"
        " their rules say. Verdict: that of an independent review of the written design; what fails stands with its"
        " best margin, and the nearest variant that closes has a row of its own. Life: the longest at which gears keep"
        " every asked safety."
    )
    return table(title, rows, _COLUMNS, note=note)
