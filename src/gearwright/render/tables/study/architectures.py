"""Enumerated architectures as a table: what each is, with which numbers, what it weighs, and what it lacks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from gearwright.enumeration import Candidate
from gearwright.render.grid.csv_text import table_csv
from gearwright.render.grid.table import Table, table
from gearwright.units import Mass, Speed, margin_text

SHOWN = 24
"""Rows on the screen and on the page [-]."""
_NOTE = (
    "Each with the ratios, and the speed of its motor, with which it weighs least as a first sizing, of as many planets"
    " as stand beside each other, five at most; those not far from the lightest then against fatigue for the life, with"
    " everything in their mass, and the lightest of these with numbers chosen anew by that mass and what they lack. In"
    " the order in which they are looked at further: by mass, and by the load that what fails lacks, which closing may"
    " bring or not."
)
_COLUMNS = (
    "architecture", "ratios", "motor_speed", "first_mass", "complete_mass", "motor_mass", "with_machines", "lacks",
)  # fmt: skip


@dataclass(frozen=True)
class ArchitectureRow:
    """One of them, as tables and machines have it."""

    architecture: str
    """In words."""
    ratios: str
    """Of its stages, from the engine on."""
    motor_speed: Speed | None
    """[rad/s]"""
    first_mass: Mass | None
    """Of gears, shafts and carriers as a first sizing, with its motor [kg]."""
    complete_mass: Mass | None
    """[kg]"""
    motor_mass: Mass | None
    """[kg]"""
    with_machines: Mass | None
    """[kg]"""
    lacks: str
    """What fails worst, with its margin, or why it is refused."""


def rows_of(candidates: Iterable[Candidate]) -> Iterator[ArchitectureRow]:
    """Yield the row of each.

    Args:
        candidates: In their order.
    """
    for row in candidates:
        yield ArchitectureRow(
            row.architecture.name,
            " · ".join(f"{ratio:.2f}" for ratio in row.ratios),
            row.motor_speed,
            row.first_mass,
            row.complete_mass,
            row.motor_mass,
            row.with_machines,
            row.refused or _lacked(row),
        )


def _lacked(row: Candidate) -> str:
    """Return the worst of what fails, and how much more there is."""
    if not row.lacks:
        return ""
    name, margin = min(row.lacks, key=lambda lack: lack[1])
    more = f" and {len(row.lacks) - 1} more" if len(row.lacks) > 1 else ""
    return f"{name} {margin_text(margin)}{more}"


def architectures_table(candidates: Iterable[Candidate], title: str) -> Table:
    """Return the table.

    Args:
        candidates: In their order.
        title: In words.
    """
    return table(title, rows_of(candidates), _COLUMNS, note=_NOTE)


def architectures_csv(candidates: Iterable[Candidate]) -> str:
    """Return all of them as CSV, in the units of the screen.

    Args:
        candidates: In their order.
    """
    return table_csv(architectures_table(candidates, ""))
