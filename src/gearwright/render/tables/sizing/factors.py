"""Every factor of a rated mesh: symbol, value on pinion and wheel, unit and clause, as a rating program prints it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from gearwright.render.grid.table import Table, table
from gearwright.sizing import MeshSizing, Sizing, pair_data
from gearwright.sizing.insight import usual_values
from gearwright.sizing.rating import METHODS, Factor, factor_rows
from gearwright.units import shown, unit, written

_NOTE = (
    "In the heaviest case over the whole life, application factor included; a single value holds for both gears."
    " The safeties under all cases stand in the table of checks. At a limit: the standard holds the factor there."
)
_USUAL = "Open in the design. Mass: by how much its gears would weigh more otherwise, with their teeth as they are."


@dataclass(frozen=True)
class FactorView:
    """One line: a quantity of both gears, or of the mesh."""

    chapter: str
    quantity: str
    """In words."""
    equation: str
    """Symbol, or the equation that makes it."""
    pinion: str
    """First gear, or the mesh."""
    wheel: str
    """Second gear; empty where there is one value."""
    unit: str
    limit: str
    """Limit of the standard at which it stands."""
    clause: str


def factor_tables(sizing: Sizing) -> dict[str, Table]:
    """Return mesh -> table of the factors of its rating; none where its method has no more than stresses and margins.

    Args:
        sizing: As sized.
    """
    return {mesh.name: _table(mesh, rows) for mesh, rows in rated_factors(sizing)}


def usual_table(sizing: Sizing) -> Table:
    """Return the load factors, reliefs and classes that a design leaves open, and what others would weigh.

    Args:
        sizing: As sized.
    """
    fields = ("stage", "quantity", "value", "source", "otherwise", "mass")
    return table("Usual values taken", usual_values(sizing), fields, note=_USUAL)


def rated_factors(sizing: Sizing) -> Iterator[tuple[MeshSizing, tuple[Factor, ...]]]:
    """Yield every mesh whose method has more than stresses and margins, with its geometry and its factors.

    Args:
        sizing: As sized.
    """
    for mesh in sizing.meshes:
        factors = METHODS[mesh.rating.method].factors(mesh.rating) if mesh.rating.method else ()
        if rows := (*factors,):
            yield mesh, (*factor_rows(pair_data(sizing, mesh), "geometry"), *rows)


def _table(mesh: MeshSizing, rows: tuple[Factor, ...]) -> Table:
    method = METHODS[mesh.rating.method]
    views = [_view(row) for row in rows]
    chapters = ["", *(view.chapter for view in views)]
    views = [
        replace(view, chapter="") if view.chapter == last else view for view, last in zip(views, chapters, strict=False)
    ]
    title = f"Rating of {mesh.name}: {mesh.gears[0]} and {mesh.gears[1]}, {method.edition}, case {mesh.rating.case}"
    return table(title, views, tuple(field.name for field in fields(FactorView)), note=_NOTE)


def _view(row: Factor) -> FactorView:
    values = [_read(value, row.dimension) for value in row.values]
    if len(values) > 2:
        values = [", ".join(values)]
    pinion, wheel = (*values, "")[:2]
    return FactorView(
        row.chapter, row.quantity, row.equation, pinion, wheel, unit(row.dimension), row.limit, row.clause
    )


def _read(value: Any, dimension: str) -> str:
    if isinstance(value, int):
        return str(value)
    return written(shown(float(np.asarray(value)), dimension), 5)
