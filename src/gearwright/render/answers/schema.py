"""Marked records as plain data for JSON, and their JSON Schema from the same marks."""

import ast
import inspect
import math
import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from types import MappingProxyType, NoneType, UnionType
from typing import Annotated, Any, ClassVar, Literal, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np

from gearwright.base import Origin, PartId, Quantity, SolveError, key_suffix, shown, unit
from gearwright.sizing.rating import METHODS, MeshRating

# ----------------------------------------------------------------------------------------------------------------------
# Marked records as plain data for JSON: every key carries its unit, and what is not finite is null.
# ----------------------------------------------------------------------------------------------------------------------


OWN_UNIT = "dimension"
"""Field of a record that says the dimension of its numbers without a mark, as `checks.Check` has it; it is written as
``unit``."""


def plain(value: Any, dimension: str = "") -> Any:
    """Return a value as JSON has it.

    Args:
        value: A record, a collection, a number in SI, words.
        dimension: Of its numbers, which are written in the unit in which that is shown; empty: as they are.

    >>> plain({"first": (0.0254, float("inf"))}, "length")
    {'first': [25.4, None]}
    """
    match value:
        case None | bool() | str() if not isinstance(value, Enum):
            return value
        case PartId() | Path():
            return str(value)
        case Enum():
            return value.value
        case int() | np.integer() if not dimension:
            return int(value)
        case int() | float() | np.number():
            return _number(float(value), dimension)
        case np.ndarray():
            return plain(value.tolist(), dimension)
        case Mapping():
            return {str(name): plain(inner, dimension) for name, inner in value.items()}
    return dict(_entries(value)) if _is_record(type(value)) else [plain(inner, dimension) for inner in value]


def _number(value: float, dimension: str) -> float | None:
    number = shown(value, dimension) if dimension else value
    return number if math.isfinite(number) else None


def _is_record(kind: Any) -> bool:
    return isinstance(kind, type) and (is_dataclass(kind) or (issubclass(kind, tuple) and hasattr(kind, "_fields")))


def _entries(record: Any) -> Iterator[tuple[str, Any]]:
    own = getattr(record, OWN_UNIT, "")
    kind: type = type(record)
    for name, written, marked in _keys(kind):
        value = getattr(record, name)
        if name == OWN_UNIT:
            yield "unit", unit(value)
        else:
            yield written, plain(value, marked or (own if isinstance(value, float) else ""))


@cache
def _keys(kind: type) -> tuple[tuple[str, str, str], ...]:
    """Return name, key and dimension of every entry."""
    return tuple((name, key(name, hint), dimension_of(hint)) for name, hint in entries_of(kind).items())


@cache
def entries_of(kind: type) -> Mapping[str, Any]:
    """Return what of a record is written: its fields and constants, and properties that are marked quantities or words.

    Args:
        kind: Type of the record.

    Returns:
        Name -> annotation with its marks.
    """
    hints = get_type_hints(kind, include_extras=True)
    names = [field.name for field in fields(kind)] if is_dataclass(kind) else list(getattr(kind, "_fields", ()))
    constants = {name: get_args(hint)[0] for name, hint in hints.items() if get_origin(hint) is ClassVar}
    told = {**constants, **{name: hints[name] for name in names}}
    for name, member in vars(kind).items():
        made = member.fget if isinstance(member, property) else getattr(member, "func", None)
        if made is not None and not name.startswith("_"):
            returned = get_type_hints(made, include_extras=True).get("return")
            if dimension_of(returned) or returned in (str, PartId):
                told[name] = returned
    return MappingProxyType(told)


def named(results: Mapping[str, tuple[float | str, str]]) -> Iterator[tuple[str, float | str]]:
    """Yield results that have their dimension beside them: name with the unit, value in that unit.

    Args:
        results: Name -> value in SI and dimension, or words.
    """
    for name, (value, dimension) in results.items():
        if isinstance(value, str):
            yield name, value
        else:
            suffix = key_suffix(dimension)
            yield f"{name}_{suffix}" if suffix else name, shown(value, dimension)


def key(name: str, hint: Any) -> str:
    """Return the key of an entry: its name with the unit in which it is written.

    Args:
        name: Of the field.
        hint: Its annotation with marks.

    >>> key("mass", Annotated[float, Quantity("mass")])
    'mass_kg'
    """
    suffix = key_suffix(dimension_of(hint))
    return f"{name}_{suffix}" if suffix else name


def dimension_of(hint: Any) -> str:
    """Return the dimension of the numbers in a field, also of those in its collections; empty if there is no mark.

    Args:
        hint: Its annotation with marks.

    >>> dimension_of(dict[str, Annotated[float, Quantity("mass")]])
    'mass'
    """
    if get_origin(hint) is Annotated:
        mark = next((mark for mark in hint.__metadata__ if isinstance(mark, Quantity)), None)
        if mark is not None:
            return mark.dimension
    return next((found for part in get_args(hint) if (found := dimension_of(part))), "")


# ----------------------------------------------------------------------------------------------------------------------
# The JSON Schema of an answer, from the same marks that write it: each key with unit, meaning, equation, source.
# ----------------------------------------------------------------------------------------------------------------------


_SIMPLE: Mapping[Any, Any] = {str: "string", bool: "boolean", int: "integer", float: ["number", "null"],
                              NoneType: "null", PartId: "string", Path: "string"}  # fmt: skip

_SI_UNIT = re.compile(r"\s*\[[^\]\n]*\]")
"""Of a field in Python, which its key in JSON need not have."""
Schema = dict[str, Any]


def described(hint: Any, definitions: dict[str, Schema]) -> Schema:
    """Return the schema of what `plain` writes of a value.

    Args:
        hint: Type or annotation of the value.
        definitions: Schemas of records by their name; those that are met are added.

    Raises:
        SolveError: If the annotation names something that JSON does not have.

    >>> described(tuple[float, ...], {})
    {'type': 'array', 'items': {'type': ['number', 'null']}}
    """
    origin, parts = get_origin(hint), get_args(hint)
    if hint in _SIMPLE:
        return {"type": _SIMPLE[hint]}
    if hint is Any:
        return {}
    if isinstance(hint, TypeVar):
        return {"type": ["number", "null"]}
    if origin is Annotated:
        return described(parts[0], definitions) | _marks(hint)
    if origin is Literal:
        return {"enum": list(parts)}
    if origin in (Union, UnionType):
        return _one_of(parts, definitions)
    if hint is MeshRating:
        return _one_of(rated_records(), definitions)
    if isinstance(hint, type) and issubclass(hint, Enum):
        return {"enum": [member.value for member in hint]}
    if origin is np.ndarray:
        return {"type": "array", "items": {"type": ["number", "null", "array", "integer", "boolean"]}}
    if is_dataclass(origin):
        return _record(origin, definitions)
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return {"type": "object", "additionalProperties": described(parts[1], definitions)}
    if isinstance(origin, type) and issubclass(origin, Iterable):
        return {"type": "array", "items": _items(parts, definitions)}
    return _record(hint, definitions)


def _one_of(parts: tuple[Any, ...], definitions: dict[str, Schema]) -> Schema:
    choices = list[Schema]()
    for choice in (described(part, definitions) for part in parts):
        if choice not in choices:
            choices.append(choice)
    types = [kind for choice in choices for kind in _types(choice)]
    if all(set(choice) == {"type"} for choice in choices):
        return {"type": types[0] if len(set(types)) == 1 else list(dict.fromkeys(types))}
    return {"anyOf": choices} if len(choices) > 1 else choices[0]


def _types(choice: Schema) -> list[str]:
    kind = choice.get("type", [])
    return [kind] if isinstance(kind, str) else kind


def _items(parts: tuple[Any, ...], definitions: dict[str, Schema]) -> Schema:
    """Return the schema of the items of a list; those of a tuple of unlike things may be any of them."""
    return _one_of(tuple(part for part in parts if part is not Ellipsis), definitions)


def _marks(hint: Any) -> Schema:
    """Return unit, equation and source of a marked field."""
    marks: Schema = {"unit": unit(dimension_of(hint))} if dimension_of(hint) else {}
    for mark in hint.__metadata__:
        if isinstance(mark, Origin):
            marks |= {"equation": mark.equation, "source": mark.source}
    return marks


def rated_records() -> tuple[type, ...]:
    """Return the records that stand for a rated mesh: one of every method."""
    made = [get_type_hints(type(method).rate)["return"] for method in METHODS.values()]
    return tuple(dict.fromkeys(record for hint in made for record in get_args(hint) or (hint,)))


def _record(kind: Any, definitions: dict[str, Schema]) -> Schema:
    if not isinstance(kind, type):
        raise SolveError(f"JSON has nothing for {kind}")
    if kind.__name__ not in definitions:
        definitions[kind.__name__] = {}
        definitions[kind.__name__] = _object(kind, definitions)
    return {"$ref": f"#/$defs/{kind.__name__}"}


def _object(kind: type, definitions: dict[str, Schema]) -> Schema:
    entries = entries_of(kind)
    if not entries:
        raise SolveError(f"JSON has nothing for {kind.__name__}")
    meanings, properties = meanings_of(kind), dict[str, Schema]()
    for name, hint in entries.items():
        entry = {"type": "string"} if name == OWN_UNIT else described(hint, definitions)
        meaning = {"description": meanings[name]} if meanings.get(name) else {}
        properties["unit" if name == OWN_UNIT else key(name, hint)] = entry | meaning
    summary = (inspect.getdoc(kind) or "").partition("\n\n")[0]
    return {"type": "object", "description": summary, "properties": properties, "required": list(properties),
            "additionalProperties": False}  # fmt: skip


@cache
def meanings_of(kind: type) -> Mapping[str, str]:
    """Return what the source says of each field and property of a record, in SI where it names a unit.

    Args:
        kind: Type of the record.
    """
    body = ast.parse(textwrap.dedent(inspect.getsource(kind))).body[0]
    assert isinstance(body, ast.ClassDef)
    meanings = {}
    for statement, following in zip(body.body, [*body.body[1:], None], strict=True):
        if isinstance(statement, ast.FunctionDef):
            meanings[statement.name] = _SI_UNIT.sub("", ast.get_docstring(statement) or "")
        elif isinstance(statement, ast.AnnAssign) and isinstance(statement.target, ast.Name):
            meanings[statement.target.id] = _text(following)
    return meanings


def _text(statement: ast.stmt | None) -> str:
    """Return the text of a docstring that stands behind a field."""
    if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant):
        return _SI_UNIT.sub("", inspect.cleandoc(str(statement.value.value)).replace("``", "`"))
    return ""
