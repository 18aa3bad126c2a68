"""Keys of a table, with the units in which a quantity may be written, and what to do about a key that is none."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

from pydantic import BaseModel

from gearwright.errors import near
from gearwright.spec.bounds import Range, quantity_of, reciprocals_of
from gearwright.units import SUFFIXES, suffix_unit


class Key(NamedTuple):
    """What a key of a table stands for."""

    field: str
    """Name in the record."""
    factor: float
    """To SI [-]."""
    suffix: str
    """Of the unit; empty for what has none."""
    inverse: bool = False
    """True where the quantity is the factor over what is written, as a module over its diametral pitch."""

    def si(self, value: float) -> float:
        """Return what is written in SI; what no reciprocal has, 0 and below, as it is.

        Args:
            value: As written.
        """
        if self.inverse:
            return self.factor / value if value > 0.0 else value
        return value * self.factor

    def written(self, value: float) -> float:
        """Return a value as it would be written.

        Args:
            value: In SI.
        """
        return self.factor / value if self.inverse else value / self.factor

    def words(self, allowed: Range) -> str:
        """Return the numbers that a field takes, in the unit of this key.

        Args:
            allowed: In SI.
        """
        symbol = suffix_unit(self.suffix) if self.suffix else ""
        return allowed.over(self.factor).words(1.0, symbol) if self.inverse else allowed.words(self.factor, symbol)


Keys = Mapping[str, Key]


@cache
def keys_of(model: type[BaseModel]) -> Keys:
    """Return the keys that a table of this record may have.

    Args:
        model: The record's type.

    Returns:
        As written -> what it stands for.
    """
    keys: dict[str, Key] = {}
    for name, info in model.model_fields.items():
        quantity = quantity_of(info)
        if quantity is None:
            keys[info.alias or name] = Key(info.alias or name, 1.0, "")
            continue
        for suffix, factor in SUFFIXES[quantity.dimension].items():
            keys[f"{name}_{suffix}"] = Key(name, factor, suffix)
        for mark in reciprocals_of(info):
            keys[mark.key] = Key(name, mark.scale, mark.suffix, inverse=True)
    return MappingProxyType(keys)


def longer_keys(key: str, keys: Keys) -> str:
    """Return which keys a word may mean that they end with; empty where none does.

    Args:
        key: As written.
        keys: Of the table.
    """
    longer = [name for name in keys if name.endswith(f"_{key}")]
    return f"write {' or '.join(longer)}" if longer else ""


def unknown_key(key: str, model: type[BaseModel]) -> str:
    """Return what to do about a key that a table does not have.

    Args:
        key: As written.
        model: The record's type.
    """
    keys = keys_of(model)
    if key in model.model_fields and quantity_of(model.model_fields[key]) is not None:
        units = ", ".join(sorted(name for name in keys if name.startswith(f"{key}_")))
        return f"the unit is missing; write one of {units}"
    lower = {name.lower(): name for name in keys}
    if key.lower() in lower:
        return f"no such field; did you mean {lower[key.lower()]}?"
    foreign = _foreign(key, model, keys)
    if foreign:
        return foreign
    if longer := longer_keys(key, keys):
        return f"no such field; {longer}"
    usual = {meant.field: name for name, meant in reversed(list(keys.items()))}
    return f"no such field; {near(key, keys, usual.values())}"


_FOREIGN: Mapping[str, str] = MappingProxyType({
    "ps": "1 PS (metric horsepower) = 0.7355 kW", "cv": "1 CV (metric horsepower) = 0.7355 kW", "cm": "1 cm = 10 mm",
    "bar": "1 bar = 0.1 MPa", "ksi": "1 ksi = 6.895 MPa", "kgf": "1 kgf = 9.807 N", "dan": "1 daN = 10 N",
    "kgfm": "1 kgf m = 9.807 N m", "mph": "1 mph = 1.609 km/h", "rps": "1 rps = 60 rpm",
})  # fmt: skip
"""Suffix of a unit that no key has -> what it is in one that keys have."""


def _foreign(key: str, model: type[BaseModel], keys: Keys) -> str:
    """Return what to do about a unit that is known to people alone; empty where the key is no such quantity."""
    name, _, suffix = key.rpartition("_")
    info = model.model_fields.get(name)
    if suffix.lower() not in _FOREIGN or info is None or quantity_of(info) is None:
        return ""
    units = ", ".join(written for written, meant in keys.items() if meant.field == name)
    return f"this unit is not known: {_FOREIGN[suffix.lower()]}; write one of {units}"
