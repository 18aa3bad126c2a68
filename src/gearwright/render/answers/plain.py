"""Marked records as plain data for JSON: every key carries its unit, and what is not finite is null."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, get_args, get_origin, get_type_hints

import numpy as np

from gearwright.identity import PartId
from gearwright.units import Quantity, key_suffix, shown, unit

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
    if _is_record(type(value)):
        return dict(_entries(value))
    return [plain(inner, dimension) for inner in value]


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
