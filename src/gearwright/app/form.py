"""A design file as a form: keys, units and bounds, and edits that keep comments."""

import json
import math
import re
from collections.abc import Iterator, Mapping, MutableMapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from gearwright.errors import DesignError, Problem, refuse
from gearwright.render.diagrams import DIAGRAMS
from gearwright.spec import key_lines, parse, schema, standing_at
from gearwright.spec.read import DEEPEST, dotted_names, toml_tables

# ----------------------------------------------------------------------------------------------------------------------
# One entry of a design's text changed, its comments and order kept.
# ----------------------------------------------------------------------------------------------------------------------


MOST_DOTTED = 200
"""Names of dotted keys: what keeps comments takes time with their square [-]."""


def with_entry(text: str, path: Sequence[str], value: Any) -> str:
    """Return a text with one entry changed; None takes it out.

    Args:
        text: In TOML.
        path: Names of tables, and the key with its unit.
        value: A number, text, truth value or list, in the unit of the key.

    Raises:
        DesignError: If the text is no TOML, or there can be no such entry.
    """
    import tomlkit
    from tomlkit.exceptions import TOMLKitError

    _refuse_odd(path, value)
    toml_tables(text, "")  # names the line of what is no TOML, and how much of it is too much
    if (names := dotted_names(text)) > MOST_DOTTED:
        message = f"with {names} names in dotted keys entries are changed in the text alone; write tables, as [a.b]"
        raise _refusal("", message)
    try:
        document = tomlkit.parse(text)
        table: MutableMapping[str, Any] = document
        for name in path[:-1]:
            if name not in table and value is not None:
                table[name] = tomlkit.table()
            table = table[name]
        if value is None:
            table.pop(path[-1], None)
        else:
            table[path[-1]] = value
        return tomlkit.dumps(document)
    except (TOMLKitError, KeyError, TypeError, AttributeError, ValueError) as error:
        where = ".".join(path)
        raise _refusal(where, f"this entry cannot be changed here ({type(error).__name__}); change the text") from None


def in_unit(text: str, path: Sequence[str], key: str) -> str:
    """Return a text with one quantity written in another unit.

    Args:
        text: Of a design without problems.
        path: Names of tables, and the key as it is.
        key: The key with the other unit.

    Raises:
        DesignError: If the design is not whole, or there is no such key.
    """
    _refuse_odd((*path[:-1], key), 0)
    standing = standing_at(parse(text), ".".join((*path[:-1], key)))
    if not isinstance(standing.value, float) or not math.isfinite(standing.value):
        raise _refusal(".".join(path), f"it cannot be written as {key}")
    changed = with_entry(text, path, float(f"{standing.value:.12g}"))
    lines = changed.split("\n")
    at = key_lines(changed).get(".".join(path))
    if at is None:
        raise _refusal(".".join(path), "this entry stands in a table in one line; change the text")
    lines[at - 1] = re.sub(rf"^(\s*){re.escape(path[-1])}(\s*=)", rf"\g<1>{key}\g<2>", lines[at - 1])
    return "\n".join(lines)


def _refuse_odd(path: Sequence[str], value: object) -> None:
    if not 1 <= len(path) <= DEEPEST or not all(path):
        refuse([Problem("path", f"an entry has 1 to {DEEPEST} names")])
    if isinstance(value, float) and not math.isfinite(value):
        refuse([Problem(".".join(path), "a number is needed")])


def _refusal(path: str, sentence: str) -> DesignError:
    return DesignError([Problem(path, sentence)])


# ----------------------------------------------------------------------------------------------------------------------
# A design's text as a form: every table with its entries, what each means, in which units, within which bounds.
#
# All of it stands in the JSON Schema of the file; here it is laid beside what the text gives.
# ----------------------------------------------------------------------------------------------------------------------


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
