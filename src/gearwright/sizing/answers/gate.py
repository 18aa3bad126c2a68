"""The gate through which a sizing leaves: every number is one, and what physics wants above nothing is above nothing.

A margin, a safety or a life may be infinite where nothing loads the part; hardly another number may, and none is NaN.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from types import NoneType
from typing import Any

from gearwright.errors import DesignError, Problem
from gearwright.identity import PartId, Role, Row
from gearwright.sizing.carrying import CarrierSizing, ShaftSizing
from gearwright.sizing.result import GearSizing, MachineSizing, Sizing
from gearwright.spec import Design, Record

_POSITIVE = {
    GearSizing: ("module", "face_width", "pitch_diameter", "mass", "inertia"),
    ShaftSizing: ("length", "diameter", "mass", "stiffness"),
    CarrierSizing: ("radius", "pin_diameter", "plate_thickness", "mass", "inertia"),
    MachineSizing: ("inertia",),
}
"""Record -> fields that are above zero in every part that there can be."""
_UNSTATED = ("accessory", "load")
"""Kinds of machines that have no inertia where none is stated."""
_ENDLESS = ("margin", "safety", "safeties", "life", "value", "limit", "pressure")
"""How the names of fields end that are infinite where nothing loads the part, limits it, or bears (a key too short)."""

_PLAIN = frozenset({int, str, bool, NoneType, Role, Row, PartId})
"""Kinds of values that hold no number which could be none."""
_WORDS = {"str", "bool", "int", "PartId", "Role", "Row", "tuple[str, str]"}
"""Annotations of fields that hold no number which could be none."""


def refuse_no_numbers(sizing: Sizing) -> Sizing:
    """Return a sizing whose every result is a number that a part can have.

    Args:
        sizing: As computed.

    Raises:
        DesignError: With part, field and value of what is none, and the number of the design that is likely to blame.
    """
    wrong = [] if _all_numbers(sizing) else [*_parts(sizing)]
    if not wrong and not 0.0 < sizing.mass < math.inf:
        wrong = [("gearbox", "mass", sizing.mass)]
    if not wrong:
        return sizing
    part, field, value = wrong[0]
    key, size = _blamed(sizing.design)
    message = (
        f"{part}: the {field.replace('_', ' ')} comes out as {value:g}, which no part has; the number of this design"
    )
    raise DesignError([Problem(key, f"{message} that is farthest from any real one is {key} = {size:g} (in SI)")])


def _all_numbers(sizing: Sizing) -> bool:
    """Tell quickly whether every result is a number that a part can have; which is none is for `_parts`."""
    groups = (*_groups(sizing), tuple(sizing.flows.values()))
    return all(_is_number(part) for group in groups for part in group) and all(
        getattr(part, field) > 0.0 for group in _groups(sizing) for part in group for field in _positive(part)
    )


def _is_number(value: Any, *, endless: bool = False) -> bool:
    """Tell whether every number inside a value is one; infinite only where it may be."""
    kind: Any = type(value)
    if kind is float:
        return math.isfinite(value) or (endless and not math.isnan(value))
    if kind in _PLAIN:
        return True
    if kind is tuple or kind is dict:
        items, may_be = (value, endless) if kind is tuple else (value.values(), False)
        for item in items:
            if not (type(item) is float and item - item == 0.0) and not _is_number(item, endless=may_be):
                return False
        return True
    if not (names := _numbers_of(kind)):
        return not any(True for _ in _wrong(value, "life" if endless else ""))
    for name, may_be in names:
        item = getattr(value, name)
        if type(item) is float and item - item == 0.0:  # which only finite numbers are
            continue
        if type(item) not in _PLAIN and not _is_number(item, endless=may_be):
            return False
    return True


@cache
def _numbers_of(kind: type) -> tuple[tuple[str, bool], ...]:
    """Return the fields of a kind of record that hold numbers, each with whether it may be infinite."""
    names = [entry.name for entry in fields(kind) if entry.type not in _WORDS] if is_dataclass(kind) else []
    return tuple((name, name.endswith(_ENDLESS)) for name in names)


def _groups(sizing: Sizing) -> tuple[tuple[Any, ...], ...]:
    return (sizing.gears, sizing.meshes, sizing.shafts, sizing.carriers, sizing.machines, sizing.built_shafts,
            sizing.bearings, sizing.joints, sizing.checks)  # fmt: skip


def _positive(part: Any) -> tuple[str, ...]:
    """Return the fields of a part that are above zero."""
    unstated = isinstance(part, MachineSizing) and part.kind in _UNSTATED
    return () if unstated else _POSITIVE.get(type(part), ())


def _parts(sizing: Sizing) -> Iterator[tuple[str, str, float]]:
    """Yield part, field and value of every result that is no number, or not above zero where it should be."""
    for group in _groups(sizing):
        for part in group:
            name = str(getattr(part, "name", getattr(part, "part", getattr(part, "stage", ""))))
            yield from ((name, field, value) for field, value in _wrong(part, ""))
            for field in _positive(part):
                if not getattr(part, field) > 0.0:
                    yield name, field, getattr(part, field)
    for case, flow in sizing.flows.items():
        yield from ((f"case {case}", field, value) for field, value in _wrong(flow, ""))


def _wrong(value: Any, field: str) -> Iterator[tuple[str, float]]:
    """Yield every number inside a value that is none, with the name of its field."""
    if isinstance(value, float):
        if math.isnan(value) or (math.isinf(value) and not field.endswith(_ENDLESS)):
            yield field, value
    elif is_dataclass(value):
        for entry in fields(value):
            yield from _wrong(getattr(value, entry.name), entry.name)
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from _wrong(item, f"{field} of {key}")
    elif isinstance(value, tuple):
        for item in value:
            yield from _wrong(item, field)


def _blamed(design: Design) -> tuple[str, float]:
    """Return path and value of the number of a design that is farthest from 1, in powers of ten."""
    written = [(path, value) for path, value in _given(design, "") if value and math.isfinite(value)]
    return max(written, key=lambda item: abs(math.log10(abs(item[1]))))


def _given(value: Any, path: str) -> Iterator[tuple[str, float]]:
    """Yield every number that the user wrote, with its path."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        yield path, float(value)
    elif isinstance(value, Record):
        for name in value.model_fields_set:
            yield from _given(getattr(value, name), f"{path}.{name}".strip("."))
    elif isinstance(value, Mapping):
        for name, item in value.items():
            yield from _given(item, f"{path}.{name}".strip("."))
