"""A design's text as a form: every table with its entries, what each means, in which units, within which bounds.

All of it stands in the JSON Schema of the file; here it is laid beside what the text gives.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from gearwright.render.diagrams import DIAGRAMS
from gearwright.spec import key_lines, schema
from gearwright.spec.read import toml_tables

Table = Mapping[str, Any]
PLAIN = ("number", "integer", "string", "boolean")
"""Kinds that have a field of their own; others are changed in the text."""


@dataclass(frozen=True)
class Field:
    """One entry of a table, written or possible."""

    key: str
    """As written, with its unit; of what is not written the usual one."""
    name: str
    """In words, without the unit."""
    unit: str
    units: tuple[str, ...]
    """Keys of the same quantity."""
    kind: str
    """number, integer, string, boolean or other."""
    help: str
    least: float | None
    most: float | None
    default: Any
    """What holds where it is left out, as far as that is one value."""
    choices: tuple[str, ...]
    value: Any
    """As written; None where it is not."""
    line: int | None
    diagram: str
    """Name of the diagram that shows what it is measured from, if any."""


@dataclass(frozen=True)
class Group:
    """One table of the text."""

    path: tuple[str, ...]
    help: str
    line: int | None
    written: tuple[Field, ...]
    possible: tuple[Field, ...]
    """What could be written too."""


def form_json(text: str) -> bytes:
    """Return the form of a design's text as JSON.

    Args:
        text: In TOML.

    Raises:
        DesignError: If it is not TOML.
    """
    return json.dumps(form(text), ensure_ascii=False, allow_nan=False, default=vars).encode()


def form(text: str) -> tuple[Group, ...]:
    """Return the form of a design's text.

    Args:
        text: In TOML; what is wrong with its entries does not matter.

    Raises:
        DesignError: If it is not TOML.
    """
    return tuple(_groups(toml_tables(text, ""), _schema(), (), key_lines(text)))


@cache
def _schema() -> dict[str, Any]:
    return schema()


def _groups(table: Table, of: Table, path: tuple[str, ...], lines: Mapping[str, int]) -> Iterator[Group]:
    """Yield a table and then those in it, in the order of the text."""
    properties: Table = of.get("properties", {})
    if properties:
        yield _group(table, of, path, lines)
    for name, inner in table.items():
        below = _resolved(properties.get(name, of.get("additionalProperties")))
        if isinstance(inner, dict) and below:
            yield from _groups(inner, below, (*path, name), lines)


def _group(table: Table, of: Table, path: tuple[str, ...], lines: Mapping[str, int]) -> Group:
    quantities: dict[str, list[str]] = {}
    for key, entry in of["properties"].items():
        if not _is_table(entry):
            quantities.setdefault(_name(key, entry), []).append(key)
    written, possible = list[Field](), list[Field]()
    for name, keys in quantities.items():
        there = [key for key in keys if key in table]
        for key in there or keys[:1]:
            line = lines.get(".".join((*path, key)))
            entry, drawn = of["properties"][key], _drawn(path, keys)
            field = _field(key, name, keys, entry=entry, value=table.get(key), line=line, diagram=drawn)
            (written if there else possible).append(field)
    order = list(table)
    written.sort(key=lambda field: order.index(field.key))
    return Group(path, of.get("description", ""), lines.get(".".join(path)), tuple(written), tuple(possible))


def _drawn(path: tuple[str, ...], keys: list[str]) -> str:
    """Return the name of the diagram that says one of the keys of a quantity of a table; empty where none does."""
    for diagram in DIAGRAMS:
        if not diagram.keys.isdisjoint(keys) and any(_is(path, table.split(".")) for table in diagram.tables):
            return diagram.name
    return ""


def _is(path: tuple[str, ...], table: list[str]) -> bool:
    return len(path) == len(table) and all(name in ("NAME", at) for at, name in zip(path, table, strict=True))


def _field(key: str, name: str, keys: list[str], *, entry: Table, value: Any, line: int | None, diagram: str) -> Field:
    found = _resolved(entry) | {word: part for word, part in entry.items() if word != "$ref"}
    kind = found.get("type", "other")
    unit = _unit(entry)
    words = found.get("description", "").removesuffix(f" [{unit}]") if unit else found.get("description", "")
    least, most = (found.get(word, found.get(strict)) for word, strict in _BOUNDS)
    choices = tuple(map(str, found.get("enum", ())))
    if value is not None and not (
        isinstance(value, bool | int | str) or (isinstance(value, float) and math.isfinite(value))
    ):
        kind, value = "other", str(value)
    plain = kind if kind in PLAIN else "other"
    return Field(
        key, name, unit, tuple(keys), plain, words, least, most, found.get("default"), choices, value, line, diagram
    )  # fmt: skip


_BOUNDS = (("minimum", "exclusiveMinimum"), ("maximum", "exclusiveMaximum"))


def _name(key: str, entry: Table) -> str:
    """Return what a quantity is called, equal for all its units."""
    return str(entry.get("title", key)).partition(" [")[0] if _unit(entry) else key.replace("_", " ")


def _unit(entry: Table) -> str:
    title = str(entry.get("title", ""))
    return title.partition(" [")[2].removesuffix("]")


def _is_table(entry: Table) -> bool:
    found = _resolved(entry)
    return found.get("type") == "object" or "properties" in found


def _resolved(entry: Any) -> dict[str, Any]:
    """Return a part of the schema where a reference stands for it."""
    if not isinstance(entry, dict):
        return {}
    for _ in range(4):
        choices = entry.get("allOf") or entry.get("anyOf") or []
        reference = entry.get("$ref") or next((part["$ref"] for part in choices if "$ref" in part), None)
        if reference is None:
            break
        entry = _schema()["$defs"][reference.rpartition("/")[2]]
    return dict(entry)
