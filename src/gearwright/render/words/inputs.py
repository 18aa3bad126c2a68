"""A design or a mission as read: every entry with its unit, and which ones are defaults."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from pydantic.fields import FieldInfo

from gearwright.spec import Design, Mission, Record, quantity_of
from gearwright.units import KWH, text

_IN_THE_HEAD = ("schema_version", "name", "description")
"""What the page's head shows already."""
_OF_A_STAGE = re.compile(r"(pairs|planetaries)\.[^.]+\.gears\..")
"""Rules of one stage, which are the design's where it does not state its own."""
_LARGER = {"time": ((3600.0, "life"), (60.0, "flight_time")), "energy": ((KWH, "electric_energy"),)}
"""Dimension -> values from which on it is shown as another dimension does, the largest first."""


@dataclass(frozen=True)
class Entry:
    """One value of the file."""

    path: str
    """Dotted path in the file, without the unit of the key."""
    value: str
    """With its unit."""
    is_given: bool
    """True if the file states it, False for a default."""
    meaning: str
    """What it is."""
    key: str = ""
    """Last part of the path."""


def entries(written: Design | Mission) -> tuple[Entry, ...]:
    """Return every value of a file, in the order of its types; without name, description and what is left open.

    Args:
        written: As read.
    """
    return tuple(_record("", written, written.model_fields_set))


def _record(path: str, record: Record, given: set[str]) -> Iterator[Entry]:
    for name, info in type(record).model_fields.items():
        value = getattr(record, name)
        key = info.alias if info.alias and quantity_of(info) is None else name
        where = f"{path}.{key}" if path else key
        if value is None or value in ({}, "", []) or where in _IN_THE_HEAD:
            continue
        if _OF_A_STAGE.match(where) and name not in given:
            continue
        if isinstance(value, Record):
            yield from _record(where, value, value.model_fields_set)
        elif isinstance(value, Mapping):
            yield from _table(where, value, info)
        else:
            yield Entry(where, _words(value, info), name in given, info.description or "", key)
    for name, table in (record.model_extra or {}).items():  # machines of a case
        yield from _record(f"{path}.{name}", table, table.model_fields_set)


def _table(path: str, table: Mapping[str, object], info: FieldInfo) -> Iterator[Entry]:
    for name, value in table.items():
        where = f"{path}.{name}"
        if isinstance(value, Record):
            yield from _record(where, value, value.model_fields_set)
        elif isinstance(value, Mapping):
            yield from _table(where, value, info)
        else:
            yield Entry(where, str(value), is_given=True, meaning=info.description or "", key=name)


def _long(value: float, dimension: str) -> str:
    """Return a value in its usual unit, or in a larger one where that reads better."""
    for least, larger in _LARGER.get(dimension, ()):
        if abs(value) >= least:
            return text(value, larger)
    return text(value, dimension)


def _words(value: object, info: FieldInfo) -> str:
    quantity = quantity_of(info)
    if quantity is not None and isinstance(value, int | float):
        return _long(value, quantity.dimension)
    if isinstance(value, list | tuple):
        return ", ".join(map(str, value))
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value)
