"""A design as the text of a file: what it gives, in the usual units, table by table."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from typing import Any

from gearwright.spec.bounds import is_path, quantity_of
from gearwright.spec.design import Design
from gearwright.spec.keys import Key, keys_of
from gearwright.spec.record import Record
from gearwright.units import shown
from gearwright.verbs import verb

DIGITS = 15
"""Digits of a quantity in its unit, so that 0.0035 m is written as 3.5 mm."""


@verb
def design_text(design: Design) -> str:
    """Return a design as TOML, which `gearwright.read` reads as the same design.

    Only what the design gives is written; defaults stay defaults. Comments of a file that it was read from are lost.

    Args:
        design: As read, edited or closed.
    """
    return "\n".join(_table(design, "")).strip() + "\n"


def _table(record: Record, path: str) -> Iterator[str]:
    """Yield the lines of a table: its own values, then the tables in it."""
    values, tables = list[str](), list[tuple[str, Record | Mapping[str, Any]]]()
    for key, value in _entries(record):
        at = f"{path}.{_name(key)}" if path else _name(key)
        if isinstance(value, Record | dict):
            tables.append((at, value))
        else:
            values.append(f"{_name(key)} = {_written(value)}")
    if path and (values or not tables):
        yield from ("", f"[{path}]")
    yield from values
    for at, inner in tables:
        yield from _inner(inner, at)


def _inner(inner: Record | Mapping[str, Any], at: str) -> Iterator[str]:
    """Yield a table, or every table of a table of them."""
    if isinstance(inner, Record):
        yield from _table(inner, at)
        return
    plain = [
        f"{_name(key)} = {_written(value)}" for key, value in inner.items() if not isinstance(value, Record | dict)
    ]
    if plain:
        yield from ("", f"[{at}]", *plain)
    for key, value in inner.items():
        if isinstance(value, Record | dict):
            yield from _inner(value, f"{at}.{_name(key)}")


def _entries(record: Record) -> Iterator[tuple[str, Any]]:
    """Yield what a record gives, each by one of the keys that a file may have for it."""
    fields = type(record).model_fields
    for name, info in fields.items():
        value = getattr(record, name)
        if name not in record.model_fields_set or value is None:
            continue
        key, meant = _key(type(record), info.alias or name)
        yield key, _rounded(meant.written(value)) if meant.suffix else value
    yield from (record.model_extra or {}).items()


def _key(kind: type[Record], field: str) -> tuple[str, Key]:
    """Return the key of a field in the unit in which people read its quantity, or the first that it has."""
    keys = [(key, meant) for key, meant in keys_of(kind).items() if meant.field == field and not meant.inverse]
    quantity = quantity_of(kind.model_fields[field]) if field in kind.model_fields else None
    if quantity is None:
        return keys[0]
    return next((pair for pair in keys if math.isclose(pair[1].factor * shown(1.0, quantity.dimension), 1.0)), keys[0])


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")


def _name(key: str) -> str:
    """Return a key, in quotes where it has dots or other marks."""
    return key if is_path(key) and "." not in key and key.isascii() and " " not in key else json.dumps(key)


def _written(value: Any) -> str:
    """Return a value in TOML."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list | tuple):
        return f"[{', '.join(_written(entry) for entry in value)}]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)
