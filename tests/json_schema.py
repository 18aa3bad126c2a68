"""A validator of the words of JSON Schema that gearwright's schemas use; a word that it does not know is an error."""

from __future__ import annotations

from typing import Any

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float)}
SAYS_NOTHING = ("title", "description", "default", "unit", "equation", "source", "rows", "$schema", "$id", "$defs",
                "then")  # fmt: skip
Fault = tuple[str, str]
"""Place, and the word that is broken there."""


def faults(value: Any, schema: dict[str, Any]) -> list[Fault]:
    """Return every fault as an editor marks it: of a choice that does not fit, those of all its branches."""
    return list(_faults(value, schema, schema, "$"))


def _faults(value: Any, part: dict[str, Any], whole: dict[str, Any], at: str) -> list[Fault]:
    return [
        fault
        for word, wanted in part.items()
        if word not in SAYS_NOTHING
        for fault in _broken(value, word, wanted, part, whole, at)
    ]


def _broken(value: Any, word: str, wanted: Any, part: dict[str, Any], whole: dict[str, Any], at: str) -> list[Fault]:
    def inside(inner: Any, schema: Any, name: object = "") -> list[Fault]:
        return _faults(inner, schema, whole, f"{at}.{name}" if name != "" else at)

    table = value if isinstance(value, dict) else {}
    row = value if isinstance(value, list) else []
    numeric = isinstance(value, int | float) and not isinstance(value, bool)
    match word:
        case "$ref":
            return inside(value, whole["$defs"][wanted.rpartition("/")[2]])
        case "type":
            holds = any(_is(value, kind) for kind in ([wanted] if isinstance(wanted, str) else wanted))
        case "anyOf":
            of_branches = [inside(value, branch) for branch in wanted]
            return [] if not all(of_branches) else [fault for branch in of_branches for fault in branch]
        case "oneOf":
            holds = sum(not inside(value, branch) for branch in wanted) == 1
        case "allOf":
            return [fault for branch in wanted for fault in inside(value, branch)]
        case "not":
            holds = bool(inside(value, wanted))
        case "if":
            return [] if inside(value, wanted) else inside(value, part["then"])
        case "required":
            holds = not isinstance(value, dict) or all(key in value for key in wanted)
        case "propertyNames":
            return [fault for key in table for fault in inside(key, wanted, key)]
        case "properties":
            return [fault for key, inner in table.items() if key in wanted for fault in inside(inner, wanted[key], key)]
        case "additionalProperties":
            others = {key: inner for key, inner in table.items() if key not in part.get("properties", {})}
            if wanted is False:
                return [(f"{at}.{key}", word) for key in others]
            return [fault for key, inner in others.items() for fault in inside(inner, wanted, key)]
        case "items":
            return [fault for number, inner in enumerate(row) for fault in inside(inner, wanted, number)]
        case "minItems":
            holds = not isinstance(value, list) or len(value) >= wanted
        case "minProperties":
            holds = not isinstance(value, dict) or len(value) >= wanted
        case "enum" | "const":
            holds = value in wanted if word == "enum" else value == wanted
        case "minimum":
            holds = not numeric or value >= wanted
        case "maximum":
            holds = not numeric or value <= wanted
        case "exclusiveMinimum":
            holds = not numeric or value > wanted
        case "exclusiveMaximum":
            holds = not numeric or value < wanted
        case _:
            raise AssertionError(f"the schema says {word!r}, which this validator does not know")
    return [] if holds else [(at, word)]


def _is(value: Any, kind: str) -> bool:
    if kind == "null":
        return value is None
    return isinstance(value, TYPES[kind]) and not (isinstance(value, bool) and kind in ("integer", "number"))
