"""The gate through which a sizing leaves: every number is one, and what physics wants above nothing is above nothing.

A margin, a safety or a life may be infinite where nothing loads the part; hardly another number may, and none is NaN.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from typing import Any

from gearwright.errors import DesignError, Problem
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


def refuse_no_numbers(sizing: Sizing) -> Sizing:
    """Return a sizing whose every result is a number that a part can have.

    Args:
        sizing: As computed.

    Raises:
        DesignError: With part, field and value of what is none, and the number of the design that is likely to blame.
    """
    wrong = [*_parts(sizing)]
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


def _parts(sizing: Sizing) -> Iterator[tuple[str, str, float]]:
    """Yield part, field and value of every result that is no number, or not above zero where it should be."""
    groups = (sizing.gears, sizing.meshes, sizing.shafts, sizing.carriers, sizing.machines, sizing.built_shafts)
    for group in (*groups, sizing.bearings, sizing.joints, sizing.checks):
        for part in group:
            name = str(getattr(part, "name", getattr(part, "part", getattr(part, "stage", ""))))
            yield from ((name, field, value) for field, value in _wrong(part, ""))
            unstated = isinstance(part, MachineSizing) and part.kind in _UNSTATED
            for field in () if unstated else _POSITIVE.get(type(part), ()):
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
