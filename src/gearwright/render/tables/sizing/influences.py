"""What moves the margins of a mesh, and what would raise the worst to a wish."""

from __future__ import annotations

from gearwright.render.grid.table import Cell, Column, Table
from gearwright.sizing import Influence, MeshInfluences, Sizing, influences
from gearwright.units import margin_text, shown, unit, written

_NOTE = (
    "%/%: by how many per cent a safety grows for one per cent more of the value, ∂ ln S/∂ ln x; teeth and all else"
    " kept, the centre distance follows module and helix. The last column: where the worst margin is the wished one; a"
    " dash: not within a factor of three."
)


def influence_tables(sizing: Sizing, wish: float) -> dict[str, Table]:
    """Return mesh -> table of what moves its margins.

    Args:
        sizing: As sized.
        wish: Margin that is wished [-].
    """
    return {mesh.mesh: _table(mesh) for mesh in influences(sizing, wish)}


def _table(mesh: MeshInfluences) -> Table:
    heads = ("", "as it is", "unit", "S_H, %/%", "S_F, %/%", f"margin {mesh.wish:g}")
    title = f"What moves {mesh.mesh} ({mesh.method}): worst margin {margin_text(mesh.margin, 4)}"
    columns = tuple(Column(head, head, "", "") for head in heads)
    return Table(title, columns, tuple(_row(row) for row in mesh.rows), _NOTE)


def _row(row: Influence) -> tuple[Cell, ...]:
    value, wanted = shown(row.value, row.dimension), row.wanted
    aim = Cell(None, "–") if wanted is None else _number(shown(wanted, row.dimension))
    slopes = (Cell(slope, f"{round(slope, 3) + 0.0:+.3f}".replace("-", "−")) for slope in (row.flank, row.root))
    return (Cell(row.handle, row.handle), _number(value), Cell(unit(row.dimension), unit(row.dimension)), *slopes, aim)


def _number(value: float) -> Cell:
    return Cell(value, written(value))
