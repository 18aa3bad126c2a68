"""Every factor of a rated mesh: symbol, value on pinion and wheel, unit and clause, as a rating program prints it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any, get_args, get_type_hints

import numpy as np

from gearwright.parts.bevel import BevelRating
from gearwright.render.tables.tables import Table, table, written
from gearwright.sizing import MeshSizing, Sizing, pair_data
from gearwright.sizing.rating import MeshRating, rating_of, steel_of
from gearwright.units import Origin, Quantity, shown, unit

_PARTS = {
    "dynamic": "dynamic factor", "face": "face load factor", "transverse": "transverse load factor",
    "loads": "load factors", "contact_strength": "strength of flanks", "pitting": "pitting",
    "root_strength": "strength of roots", "bending": "tooth root", "geometry": "pitting", "section": "tooth root",
    "scuffing": "scuffing",
}  # fmt: skip
"""Field of a rating -> chapter of the table."""
_NOTE = (
    "In the heaviest case over the whole life, application factor included; a single value holds for both gears."
    " The safeties under all cases stand in the table of checks."
)


@dataclass(frozen=True)
class Factor:
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
    clause: str


def factor_tables(sizing: Sizing) -> tuple[Table, ...]:
    """Return a table of factors for every mesh that ISO 6336 or ISO 10300 rates.

    Args:
        sizing: As sized.
    """
    return tuple(_table(sizing, mesh, mesh.rating) for mesh in rated(sizing) if mesh.rating is not None)


def rated(sizing: Sizing) -> tuple[MeshSizing, ...]:
    """Return the meshes that ISO 6336 or ISO 10300 rates.

    Args:
        sizing: As sized.
    """
    return tuple(mesh for mesh in sizing.meshes if mesh.rating is not None)


def _table(sizing: Sizing, mesh: MeshSizing, rating: MeshRating) -> Table:
    standard = "ISO 10300, method B1" if isinstance(rating.factors, BevelRating) else "ISO 6336, method B"
    steel = steel_of(rating_of(sizing.design, mesh.name.partition(".")[0]))
    rows = [*_rows(pair_data(sizing, mesh), "geometry"), *_rows(steel, "steel"), *_rows(rating.factors, "mesh")]
    if rating.scuffing is not None:
        rows += _rows(rating.scuffing, "scuffing")
    names = tuple(field.name for field in fields(Factor))
    chapters = ["", *(row.chapter for row in rows)]
    rows = [replace(row, chapter="") if row.chapter == last else row for row, last in zip(rows, chapters, strict=False)]
    title = f"Rating of {mesh.name}: {mesh.gears[0]} and {mesh.gears[1]}, {standard}, case {rating.case}"
    return table(title, rows, names, note=_NOTE)


def _rows(record: object, chapter: str) -> Iterator[Factor]:
    """Yield a line for every field that says where it comes from, and look inside records and pairs of them."""
    hints = get_type_hints(type(record), include_extras=True)
    for field in fields(record):  # type: ignore[arg-type]
        value, hint = getattr(record, field.name), hints[field.name]
        inner = _PARTS.get(field.name, chapter)
        if is_dataclass(value):
            yield from _rows(value, inner) if field.name != "virtual" else ()
        elif isinstance(value, tuple) and value and is_dataclass(value[0]):
            yield from _side_by_side(list(_rows(value[0], inner)), list(_rows(value[1], inner)))
        else:
            yield from _line(field.name, value, hint, chapter)


def _side_by_side(first: list[Factor], second: list[Factor]) -> Iterator[Factor]:
    for pinion, wheel in zip(first, second, strict=True):
        yield Factor(
            pinion.chapter, pinion.quantity, pinion.equation, pinion.pinion, wheel.pinion, pinion.unit, pinion.clause
        )


def _line(name: str, value: Any, hint: Any, chapter: str) -> Iterator[Factor]:
    marks = [mark for part in (hint, *get_args(hint)) for mark in getattr(part, "__metadata__", ())]
    origin = next((mark for mark in marks if isinstance(mark, Origin)), None)
    if origin is None or value is None:
        return
    dimension = next((mark.dimension for mark in marks if isinstance(mark, Quantity)), "number")
    values = [_read(gear_value, dimension) for gear_value in (value if isinstance(value, tuple) else (value,))]
    if len(values) > 2:
        values = [", ".join(values)]
    pinion, wheel = (*values, "")[:2]
    words = name.replace("_", " ")
    yield Factor(chapter, words, origin.equation, pinion, wheel, unit(dimension), origin.source)


def _read(value: Any, dimension: str) -> str:
    if isinstance(value, int):
        return str(value)
    return written(shown(float(np.asarray(value)), dimension), 5)
