"""JSON Schema of the design file, from the same types that read it."""

from __future__ import annotations

from typing import Any

from gearwright.spec.bounds import Range, quantity_of, range_of
from gearwright.spec.design import Design
from gearwright.spec.record import Record, keys_of
from gearwright.units import SUFFIXES


def schema() -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of a design file: every key with its unit, bounds and meaning."""
    document = Design.model_json_schema(by_alias=True)
    definitions: dict[str, Any] = document.get("$defs", {})
    for model in records(Design, {}):
        table = document if model is Design else definitions[model.__name__]
        _expand(table, model)
    document["$schema"] = "https://json-schema.org/draft/2020-12/schema"
    document["title"] = "gearwright design"
    return document


def records(model: type[Record], seen: dict[type[Record], None]) -> list[type[Record]]:
    """Return a record's type and all record types inside it.

    Args:
        model: The record's type.
        seen: What was met before; start with an empty one.
    """
    if model in seen:
        return []
    seen[model] = None
    for info in model.model_fields.values():
        for inner in _inside(info.annotation):
            records(inner, seen)
    return list(seen)


def _inside(annotation: Any) -> list[type[Record]]:
    if isinstance(annotation, type) and issubclass(annotation, Record):
        return [annotation]
    return [model for part in getattr(annotation, "__args__", ()) for model in _inside(part)]


def _expand(table: dict[str, Any], model: type[Record]) -> None:
    """Replace every quantity by one property per unit, of which one at most may stand."""
    properties, required = table["properties"], table.get("required", [])
    for name, info in model.model_fields.items():
        quantity = quantity_of(info)
        if quantity is None:
            continue
        entry = properties.pop(name)
        options = [key for key, (field, _, _) in keys_of(model).items() if field == name]
        for key, (suffix, factor) in zip(options, SUFFIXES[quantity.dimension].items(), strict=True):
            properties[key] = _number(entry, suffix, factor, range_of(info))
        choices: list[dict[str, Any]] = [{"required": [key]} for key in options]
        if name in required:
            required.remove(name)
        elif len(options) > 1:
            choices.append({"not": {"anyOf": [{"required": [key]} for key in options]}})
        else:
            continue
        table.setdefault("allOf", []).append({"oneOf": choices})


def _number(entry: dict[str, Any], suffix: str, factor: float, allowed: Range) -> dict[str, Any]:
    """Return the property of one unit, its bounds converted from SI."""
    number: dict[str, Any] = {"type": "number", "description": f"{entry.get('description', '')} [{suffix}]"}
    number["exclusiveMinimum" if allowed.above else "minimum"] = allowed.least / factor
    number["exclusiveMaximum" if allowed.below else "maximum"] = allowed.most / factor
    if isinstance(entry.get("default"), int | float):
        number["default"] = entry["default"] / factor
    return number
