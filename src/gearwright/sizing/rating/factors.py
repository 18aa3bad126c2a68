"""Every quantity of a rating as a row: the fields of its records that say where they come from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from types import MappingProxyType
from typing import Any

from gearwright.parts.iso6336 import GearSteel
from gearwright.units import marks_of

CHAPTERS: Mapping[str, str] = MappingProxyType({
    "dynamic": "dynamic factor", "face": "face load factor", "transverse": "transverse load factor",
    "loads": "load factors", "contact_strength": "strength of flanks", "pitting": "pitting",
    "root_strength": "strength of roots", "bending": "tooth root", "geometry": "pitting", "section": "tooth root",
    "tooth_root": "tooth root", "strength": "strength", "gears": "stresses", "wheel_strength": "strength of the wheel",
    "scuffing": "scuffing",
})  # fmt: skip
"""Field that holds records -> chapter of their rows; others stand in the chapter around them."""
_HIDDEN = ("virtual",)
"""Fields whose records are geometry, shown elsewhere."""


@dataclass(frozen=True)
class Factor:
    """A quantity of both gears, or of the mesh."""

    chapter: str
    quantity: str
    """In words."""
    equation: str
    """Symbol, or the equation that makes it."""
    values: tuple[Any, ...]
    """Of first and second gear, or one of the mesh; more are one list [SI]."""
    dimension: str
    clause: str
    limit: str = ""
    """Limit of the standard at which it stands; empty where it stands at none that is known."""


def factor_rows(record: object, chapter: str) -> Iterator[Factor]:
    """Yield a row for every field that says where it comes from, and look inside records and pairs of them.

    Args:
        record: A dataclass.
        chapter: Of its rows.
    """
    marks = marks_of(type(record))
    for field in fields(record):  # type: ignore[arg-type]
        value, mark = getattr(record, field.name), marks[field.name]
        inner = CHAPTERS.get(field.name, chapter)
        if is_dataclass(value):
            yield from factor_rows(value, inner) if field.name not in _HIDDEN else ()
        elif isinstance(value, tuple) and value and is_dataclass(value[0]):
            yield from map(_side_by_side, factor_rows(value[0], inner), factor_rows(value[1], inner))
        elif (origin := mark.origin) is not None and value is not None:
            values = value if isinstance(value, tuple) else (value,)
            words = field.name.replace("_", " ")
            yield Factor(chapter, words, origin.equation, values, mark.dimension or "number", origin.source)


def steel_rows(steel: GearSteel) -> Iterator[Factor]:
    """Yield the strengths of a steel, each with where it comes from: the rows of a table, or who states it.

    Args:
        steel: As it is rated.
    """
    for row in factor_rows(steel, "steel"):
        yield replace(row, clause=steel.source or row.clause)


def _side_by_side(first: Factor, second: Factor) -> Factor:
    """Return one row of the same quantity of both gears."""
    return Factor(
        first.chapter, first.quantity, first.equation, (*first.values, *second.values), first.dimension, first.clause
    )
