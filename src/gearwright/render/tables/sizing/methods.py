"""A mesh by every method, factor by factor: what differs, and why."""

from __future__ import annotations

import math

from gearwright.render.grid.table import Cell, Column, Table
from gearwright.sizing import Beside, MeshBeside, Sizing, methods_beside
from gearwright.sizing.rating import METHODS
from gearwright.units import margin_text, shown, unit, written

_NOTE = (
    "Teeth, module, width and loads of the design; steel and making of each method's own rules. In the heaviest case,"
    " pinion / wheel; one value holds for both. A dash: the method has no such factor. Margins: over the safeties that"
    " the method's rules ask."
)


def method_tables(sizing: Sizing) -> dict[str, Table]:
    """Return mesh -> table of its factors by every method.

    Args:
        sizing: As sized.
    """
    return {mesh.mesh: _table(mesh) for mesh in methods_beside(sizing)}


def _table(mesh: MeshBeside) -> Table:
    columns = [Column("aspect", "", "", ""), *(Column(name, name, "", "") for name in mesh.margins)]
    columns += [Column("unit", "unit", "", ""), Column("why", "why they differ", "", "")]
    rows = [_row(line, tuple(mesh.margins)) for line in mesh.rows]
    for place, words in enumerate(("margin of flanks", "margin of roots")):
        cells = [_number(margin_text(margin[place], 4), margin[place]) for margin in mesh.margins.values()]
        rows.append((_words(words), *cells, _words(""), _words("")))
    left = "".join(f" Not by {METHODS[name].edition}: {why}." for name, why in mesh.refused.items())
    return Table(f"Rating of {mesh.mesh} by every method", tuple(columns), tuple(rows), _NOTE + left)


def _row(line: Beside, methods: tuple[str, ...]) -> tuple[Cell, ...]:
    cells = [_values(line.values.get(name, ()), line.dimension) for name in methods]
    return (_words(line.aspect), *cells, _words(unit(line.dimension)), _words(line.why))


def _values(values: tuple[float, ...], dimension: str) -> Cell:
    if not values:
        return _words("–")
    numbers = [shown(value, dimension) for value in values]
    same = all(math.isclose(number, numbers[0], rel_tol=1e-9) for number in numbers)
    texts = [written(number) for number in (numbers[:1] if same else numbers)]
    return _number(" / ".join(texts), numbers[0] if same else None)


def _number(text: str, value: float | None) -> Cell:
    return Cell(text if value is None else value, text)


def _words(text: str) -> Cell:
    return Cell(text, text)
