"""JSON Schema of design, mission, mix and study files, from the same types that read them.

Editors mark what does not fit. One mistake is to mark one place: there is no choice of schemas where a type says the
same, and what is required is asked for only in a table whose keys are all known, as a key that is misspelt is then the
one that is missing.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from gearwright.base import DesignError, Problem, near, suffix_unit, verb
from gearwright.spec.design import Design
from gearwright.spec.missions import Mission
from gearwright.spec.record import Key, Range, Record, keys_of, quantity_of, range_of
from gearwright.spec.studies import MixFile, Study

FILES: Mapping[str, type[Record]] = MappingProxyType(
    {"design": Design, "mission": Mission, "mix": MixFile, "study": Study}
)
"""What users write -> its type."""
DIALECT = "https://json-schema.org/draft/2020-12/schema"


@verb
def schema(of: str = "design") -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of a file: every key with its unit, bounds and meaning.

    Args:
        of: ``design``, ``mission``, ``mix`` or ``study``.

    Raises:
        DesignError: If there is no such file.
    """
    if of not in FILES:
        raise DesignError([Problem("of", f"{of!r} is no file that users write; {near(of, FILES)}")])
    top = FILES[of]
    document = top.model_json_schema(by_alias=True)
    definitions: dict[str, Any] = document.get("$defs", {})
    for model in records(top, {}):
        table = document if model is top else definitions[model.__name__]
        _expand(table, model)
    head = {"$schema": DIALECT, "$id": schema_id(of), "title": f"gearwright {of}"}
    told: dict[str, Any] = {**head, **{word: part for word, part in document.items() if word not in head}}
    return {word: _plain(part) for word, part in told.items()}


def schema_id(of: str) -> str:
    """Return the name of the schema of a file; its last part counts up when files of before would no longer fit.

    Args:
        of: ``design``, ``mission``, ``mix`` or ``study``.

    >>> schema_id("design")
    'urn:gearwright:file:design:1'
    """
    return f"urn:gearwright:file:{of}:1"


def records(model: type[Record], seen: dict[type[Record], None]) -> list[type[Record]]:
    """Return a record's type and all record types inside it.

    Args:
        model: The record's type.
        seen: What was met before; start with an empty one.
    """
    if model in seen:
        return []
    seen[model] = None
    for annotation in (*(info.annotation for info in model.model_fields.values()), model.others):
        for inner in _inside(annotation):
            records(inner, seen)
    return list(seen)


def _inside(annotation: Any) -> list[type[Record]]:
    if isinstance(annotation, type) and issubclass(annotation, Record):
        return [annotation]
    return [model for part in getattr(annotation, "__args__", ()) for model in _inside(part)]


def _expand(table: dict[str, Any], model: type[Record]) -> None:
    """Replace every quantity by one property per unit, of which one at most may stand; name what must stand."""
    properties, required = table["properties"], table.pop("required", [])
    wanted: list[dict[str, Any]] = [{"required": [name]} for name in required if name in properties]
    for name, info in model.model_fields.items():
        quantity = quantity_of(info)
        if quantity is None:
            continue
        entry = properties.pop(name)
        options = [key for key, meant in keys_of(model).items() if meant.field == name]
        for key in options:
            properties[key] = _number(entry, key, keys_of(model)[key], range_of(info))
        choices: list[dict[str, Any]] = [{"required": [key]} for key in options]
        if name in required:
            wanted = [part for part in wanted if part != {"required": [name]}]
            wanted.append({"oneOf": choices} if len(choices) > 1 else choices[0])
        elif len(choices) > 1:
            wanted.append({"oneOf": [*choices, {"not": {"anyOf": choices}}]})
    if wanted:
        table |= {"if": {"propertyNames": {"enum": list(properties)}}, "then": {"allOf": wanted}}


def _number(entry: dict[str, Any], key: str, meant: Key, allowed: Range) -> dict[str, Any]:
    """Return the property of one unit, its bounds converted from SI."""
    symbol = suffix_unit(meant.suffix)
    name = (key if meant.inverse else meant.field).replace("_", " ")
    number: dict[str, Any] = {
        "title": f"{name} [{symbol}]",
        "type": "number",
        "description": f"{entry.get('description', '')} [{symbol}]",
    }
    low, high = ("exclusiveMinimum" if allowed.above else "minimum", "exclusiveMaximum" if allowed.below else "maximum")
    if meant.inverse:
        allowed = allowed.over(meant.factor)
        number[low], number[high] = allowed.minimum, allowed.maximum
    else:
        number[low], number[high] = allowed.minimum / meant.factor, allowed.maximum / meant.factor
    if isinstance(entry.get("default"), int | float):
        number["default"] = meant.written(entry["default"])
    return number


def _plain(part: Any) -> Any:
    """Return a schema without null, which TOML does not have, and without choices between types that one word names."""
    if isinstance(part, list):
        return [_plain(inner) for inner in part]
    if not isinstance(part, dict):
        return part
    words = {word: _plain(inner) for word, inner in part.items() if not (word == "default" and inner is None)}
    if "gt" in words:  # which pydantic leaves on a union of numbers
        words["exclusiveMinimum"] = words.pop("gt")
    choices = [choice for choice in words.get("anyOf", []) if choice != {"type": "null"}]
    if not choices or not all("type" in choice or len(choices) == 1 for choice in choices):
        return words
    types = [kind for choice in choices for kind in _types(choice)]
    merged = {word: inner for choice in choices for word, inner in choice.items()}
    named = {"type": types[0] if len(types) == 1 else types} if types else {}
    return {word: inner for word, inner in words.items() if word != "anyOf"} | merged | named


def _types(choice: dict[str, Any]) -> list[str]:
    kind = choice.get("type", [])
    return [kind] if isinstance(kind, str) else kind
