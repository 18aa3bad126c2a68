"""Architectures at equal life as tables: what each weighs with everything in it, how long it lives, what it does not
meet, and of what its mass is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, make_dataclass
from typing import Any

from gearwright.render.grid.csv_text import table_csv
from gearwright.render.grid.table import Table, table
from gearwright.sizing.mass import GROUPS, CompleteMass, Statistics
from gearwright.study.running.equal_life import EqualLife
from gearwright.units import Mass, text

_COLUMNS = (
    "design", "variant", "verdict", "complete_mass", "lightest", "heaviest", "machines", "with_machines",
    "shortest_life",
    "limits", "fails",
)  # fmt: skip
ALIKE = 1.1
"""Largest over smallest of the statistics' limits up to which designs are of one requirement [-]: teeth give speeds
only nearly."""
_NOTE = (
    "Complete mass with its band of 68 %, machines beside it; those that pass come first, the lightest with its"
    " machines at the top. Verdict: that of an independent review of the written design; what fails stands with its"
    " best margin, and the nearest variant that closes has a row of its own. Shortest life: of the gear (at the asked"
    " safeties) or bearing that ends first; a dash where none"
    " ends before 1e6 h, and then what is nearest to its limit."
)
_GROUPS = make_dataclass("_Groups", [("design", str), *((name, Mass) for name in GROUPS), ("total", Mass)], frozen=True)


def equal_life_table(rows: Sequence[EqualLife], title: str) -> Table:
    """Return the table.

    Args:
        rows: In their order.
        title: In words.
    """
    return table(title, rows, _COLUMNS, note=f"{_NOTE}{_beside(rows)}")


def group_table(masses: Mapping[str, CompleteMass]) -> Table:
    """Return the groups of parts of every design.

    Args:
        masses: Design -> its complete mass.
    """
    rows: list[Any] = [
        _GROUPS(name, *(mass.of(group) for group in GROUPS), mass.total) for name, mass in masses.items()
    ]
    return table("Complete masses by groups of parts", rows, tuple(field.name for field in fields(_GROUPS)))


def equal_life_csv(rows: Sequence[EqualLife]) -> str:
    """Return the table as CSV, in the units that it shows.

    Args:
        rows: In their order.
    """
    return table_csv(equal_life_table(rows, ""))


def _beside(rows: Sequence[EqualLife]) -> str:
    """Return what real gearboxes weigh and whose band does not meet theirs; for designs of about one requirement."""
    known = {row.title: (row, *_band(row.statistics)) for row in rows if row.statistics and row.statistics.mass}
    if not known or max(high for _, _, high in known.values()) > ALIKE * min(high for _, _, high in known.values()):
        return ""
    ends = [min(low for _, low, _ in known.values()), max(high for _, _, high in known.values())]
    lighter = [name for name, (row, low, _) in known.items() if (row.heaviest or 0.0) < low]
    heavier = [name for name, (row, _, high) in known.items() if (row.lightest or 0.0) > high]
    span = " to ".join(text(mass, "mass", 3) for mass in ends)
    said = f" 61 real gearboxes of this power and these speeds: 68 % from {span}."
    said += f" Lighter, bands apart: {', '.join(lighter)}." if lighter else ""
    said += f" Heavier, bands apart: {', '.join(heavier)}." if heavier else ""
    return said if lighter or heavier else f"{said} All bands meet it."


def _band(known: Statistics) -> tuple[float, float]:
    return known.low or 0.0, known.high or 0.0
