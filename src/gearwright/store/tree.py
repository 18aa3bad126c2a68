"""Values as trees of JSON and back, bit for bit: records, arrays, mappings, tuples, enumerations, numbers.

Text, whole numbers, finite floats, True, False and None stand as they are, a tuple is a list, a mapping of plain
names an object; everything else is an object with one ``$`` key. Records are named by their module and class, and only
records and enumerations of gearwright are made from a name: nothing in a file is run.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeGuard

import numpy as np
from pydantic import BaseModel

_ROOM = "gearwright."
_NAME = re.compile(r"[a-z][a-z0-9_]*(\.[a-z][a-z0-9_]*)*:[A-Za-z_][A-Za-z0-9_]*(\.[A-Za-z_][A-Za-z0-9_]*)*")
_DTYPE = re.compile(r"\|b1|[<>|][iu][1248]|[<>]f[248]|[<>]c(8|16)|[<>]U[0-9]+")
_PLAIN = (bool, int, str)
_TAG = "$"


class Unkept(Exception):
    """A value that no file keeps; with where it stands."""


class Damaged(Exception):
    """A tree that no value makes."""


def is_record(kind: type) -> bool:
    """Tell whether files keep a class: a frozen dataclass, a named tuple or a record of files, of gearwright.

    Args:
        kind: The class.
    """
    if not kind.__module__.startswith(_ROOM) or "<" in kind.__qualname__:
        return False
    named = issubclass(kind, tuple) and hasattr(kind, "_fields")
    frozen = is_dataclass(kind) and kind.__dataclass_params__.frozen  # type: ignore[attr-defined]
    return named or frozen or issubclass(kind, BaseModel)


def encoded(value: object, at: str = "") -> Any:
    """Return a value as a tree.

    Args:
        value: Of records, arrays, mappings, tuples, enumerations and numbers.
        at: Where it stands, for the message.

    Raises:
        Unkept: It holds something else.
    """
    kind = type(value)
    if value is None or kind in _PLAIN:
        return value
    if isinstance(value, float) and kind is float:
        return value if math.isfinite(value) else {"$float": str(value)}
    if isinstance(value, Enum) and kind.__module__.startswith(_ROOM):
        return {"$enum": _name(kind), "value": encoded(value.value, at)}
    if is_record(kind):
        members = {name: encoded(member, f"{at}.{name}") for name, member in _members(value)}
        return {"$record": _name(kind), "fields": members}
    if isinstance(value, np.ndarray | np.generic):
        return _array(value, at)
    return _container(value, at)


def _name(kind: type) -> str:
    return f"{kind.__module__.removeprefix(_ROOM)}:{kind.__qualname__}"


def _members(value: Any) -> list[tuple[str, object]]:
    """Return the fields of a record; of a record of a file those that were given."""
    if isinstance(value, BaseModel):
        declared = [name for name in type(value).model_fields if name in value.model_fields_set]
        return [*((name, getattr(value, name)) for name in declared), *(value.model_extra or {}).items()]
    names = [field.name for field in fields(value) if field.init] if _is_dataclass(value) else value._fields
    return [(name, getattr(value, name)) for name in names]


def _is_dataclass(value: object) -> TypeGuard[Any]:
    return is_dataclass(value)


def _array(value: Any, at: str) -> dict[str, Any]:
    """Return an array, or one of its numbers, with its type."""
    if not _DTYPE.fullmatch(value.dtype.str):
        raise Unkept(f"{at} is an array of {value.dtype}")
    flat = np.ravel(value)
    flat = flat.view(f"{flat.dtype.str[0]}f{flat.dtype.itemsize // 2}") if flat.dtype.kind == "c" else flat
    values = flat.tolist()
    if flat.dtype.kind == "f" and not np.isfinite(flat).all():
        values = [number if math.isfinite(number) else str(number) for number in values]
    tag = "$array" if isinstance(value, np.ndarray) else "$scalar"
    return {tag: value.dtype.str, "shape": list(value.shape), "values": values}


def _container(value: object, at: str) -> Any:
    kind = type(value)
    if isinstance(value, tuple | list) and kind in (tuple, list):
        members = [encoded(member, f"{at}[{k}]") for k, member in enumerate(value)]
        return members if kind is tuple else {"$list": members}
    if isinstance(value, complex) and kind is complex:
        return {"$complex": [encoded(value.real), encoded(value.imag)]}
    if isinstance(value, Path):
        return {"$path": str(value)}
    if isinstance(value, MappingProxyType):
        return {"$fixed": encoded(dict(value), at)}
    if isinstance(value, dict) and kind is dict:
        return _mapping(value, at)
    raise Unkept(f"{at or 'the value'} is of type {kind.__name__}")


def _mapping(value: Mapping[Any, object], at: str) -> dict[str, Any]:
    if all(type(key) is str and not key.startswith(_TAG) for key in value):
        return {key: encoded(member, f"{at}[{key!r}]") for key, member in value.items()}
    return {"$pairs": [[encoded(key, at), encoded(member, f"{at}[{key!r}]")] for key, member in value.items()]}


def decoded(tree: Any) -> Any:
    """Return the value of a tree.

    Args:
        tree: As `encoded` makes it.

    Raises:
        Damaged: It is none, or names what gearwright does not have.
    """
    if isinstance(tree, list):
        return tuple(decoded(member) for member in tree)
    if not isinstance(tree, dict):
        return tree
    if not any(key.startswith(_TAG) for key in tree):
        return {key: decoded(member) for key, member in tree.items()}
    try:
        return _made(tree)
    except (TypeError, ValueError, KeyError, OverflowError, AttributeError) as error:
        raise Damaged(f"{next(iter(tree.values()))}: {error}") from None


def _made(tree: dict[str, Any]) -> Any:
    """Return the value of an object with a tag."""
    match tree:
        case {"$record": str(name), "fields": dict(members)}:
            return _record(name, members)
        case {"$enum": str(name), "value": value}:
            return _enum(name, value)
        case {"$array": str(dtype), "shape": list(shape), "values": list(values)}:
            return _numbers(dtype, shape, values)
        case {"$scalar": str(dtype), "shape": [], "values": list(values)}:
            return _numbers(dtype, [], values)[()]
        case {"$float": "inf" | "-inf" | "nan" as number}:
            return float(number)
        case {"$complex": [real, imaginary]}:
            return complex(decoded(real), decoded(imaginary))
        case {"$list": list(members)}:
            return [decoded(member) for member in members]
        case {"$fixed": members}:
            return MappingProxyType(decoded(members))
        case {"$pairs": list(pairs)}:
            return dict(decoded(pairs))
        case {"$path": str(path)}:
            return Path(path)
        case _:
            raise Damaged(f"{next(key for key in tree if key.startswith(_TAG))!r} is not known")


def _record(record: str, fields: dict[str, Any]) -> Any:
    kind: Any = _class(record)
    if not is_record(kind):
        raise Damaged(f"{record} is no record")
    members = {name: decoded(member) for name, member in fields.items()}
    if issubclass(kind, BaseModel):
        known = kind.model_fields
        return kind.model_validate(
            {(known[name].alias or name) if name in known else name: value for name, value in members.items()}
        )
    return kind(**members)


def _enum(enum: str, value: Any) -> Any:
    kind = _class(enum)
    if not issubclass(kind, Enum):
        raise Damaged(f"{enum} is no enumeration")
    return kind(decoded(value))


def _class(name: str) -> type:
    """Return a class of gearwright by its name in a file; nothing else is looked up."""
    if not _NAME.fullmatch(name):
        raise Damaged(f"{name!r} is no name of a record")
    module, _, path = name.partition(":")
    try:
        found: Any = import_module(_ROOM + module)
        for part in path.split("."):
            found = vars(found)[part]
    except (ImportError, KeyError, TypeError):
        raise Damaged(f"this version has no {name}") from None
    if not isinstance(found, type) or found.__module__ != _ROOM + module:
        raise Damaged(f"{name} is no record")
    return found


def _numbers(dtype: str, shape: list[int], values: list[Any]) -> Any:
    if not _DTYPE.fullmatch(dtype) or any(size < 0 for size in shape) or any(isinstance(v, list) for v in values):
        raise ValueError("no array of numbers or texts")
    kind = np.dtype(dtype)
    if kind.kind == "c":
        return np.array(values, f"{dtype[0]}f{kind.itemsize // 2}").view(kind).reshape(shape)
    return np.array(values, kind).reshape(shape)
