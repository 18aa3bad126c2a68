"""Values of a table that follow from others in their row, as formulas of a spreadsheet."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from gearwright.exchange.tables.long import value_of
from gearwright.render.grid.table import Cell, Table

NEAR = 1e-9
"""Relative difference up to which a formula gives what was computed; where it does not, the number stands [-]."""


class Formula(NamedTuple):
    """How a value follows from its row."""

    needs: tuple[str, ...]
    """Columns, in the units that are shown."""
    written: str
    """For a spreadsheet; {0} is the first of those columns."""
    value: Callable[..., float]


FORMULAS: Mapping[str, tuple[Formula, ...]] = {
    "pitch_diameter": (
        Formula(("module", "teeth", "helix_angle"), "{0}*{1}/COS(RADIANS({2}))",
                lambda module, teeth, angle: module * teeth / math.cos(math.radians(angle))),
        Formula(("module", "teeth"), "{0}*{1}", lambda module, teeth: module * teeth),
    ),
    "power": (Formula(("torque", "speed"), "{0}*{1}*PI()/30000", lambda t, n: t * n * math.pi / 30000.0),),
    "total": (Formula(("count", "each"), "{0}*{1}", lambda count, each: count * each),),
    "deviation": (Formula(("actual", "asked"), "100*({0}/{1}-1)", lambda n, asked: 100.0 * (n / asked - 1.0)),),
    "lost": (
        Formula(("meshes", "bearings", "windage", "churning", "seals"), "{0}+{1}+{2}+{3}+{4}", lambda *lost: sum(lost)),
    ),
    "efficiency": (Formula(("lost", "power"), "1-{0}/{1}", lambda lost, p: 1.0 - lost / p),),
}  # fmt: skip
"""Column -> how it follows, the first that can be had."""


def formulas_of(table: Table, row: Sequence[Cell], line: int) -> dict[int, str]:
    """Return column -> formula, of those values of a row that follow from others in it.

    Args:
        table: With its columns.
        row: Of the table.
        line: Of the sheet, from 1.
    """
    places = {column.name: place for place, column in enumerate(table.columns)}
    found = {}
    for place, column in enumerate(table.columns):
        for formula in FORMULAS.get(column.name, ()):
            if set(formula.needs) <= places.keys() and _gives(formula, row, places, value_of(row[place])):
                cells = [f"{letters(places[need])}{line}" for need in formula.needs]
                found[place] = f"={formula.written.format(*cells)}"
                break
    return found


def _gives(formula: Formula, row: Sequence[Cell], places: Mapping[str, int], value: object) -> bool:
    """Tell whether a formula gives what was computed."""
    parts = [value_of(row[places[need]]) for need in formula.needs]
    if not all(isinstance(part, int | float) and math.isfinite(part) for part in (*parts, value)):
        return False
    try:
        return math.isclose(formula.value(*parts), float(str(value)), rel_tol=NEAR)
    except ZeroDivisionError:
        return False


def letters(place: int) -> str:
    """Return what a spreadsheet calls a column.

    Args:
        place: Of the column, from 0.

    >>> letters(0), letters(25), letters(26)
    ('A', 'Z', 'AA')
    """
    before, last = divmod(place, 26)
    return (letters(before - 1) if before else "") + chr(ord("A") + last)
