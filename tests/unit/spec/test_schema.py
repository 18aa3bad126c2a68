"""The JSON Schema speaks of the same files as the reader."""

import tomllib
from typing import Any

import pytest

from designs import HYBRID, PAIR, changed, problems
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.spec import keys_of, parse, quantity_of, records, schema
from gearwright.spec.design import Design

SCHEMA = schema()
SAYS_NOTHING = ("title", "description", "default", "$schema", "$defs")
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float)}


def fits(value: Any, part: dict[str, Any]) -> bool:
    """Tell whether a value keeps the words of JSON Schema that this schema uses; an unknown word is an error."""
    part = {
        word: each for word, each in part.items() if word not in ("title", "description", "default", "$schema", "$defs")
    }
    return all(_keeps(value, word, wanted, part) for word, wanted in part.items())


def _keeps(value: Any, word: str, wanted: Any, part: dict[str, Any]) -> bool:
    match word:
        case "$ref":
            return fits(value, SCHEMA["$defs"][wanted.rpartition("/")[2]])
        case "type":
            numeric_bool = isinstance(value, bool) and wanted in ("integer", "number")
            return value is None if wanted == "null" else isinstance(value, TYPES[wanted]) and not numeric_bool
        case "anyOf":
            return any(fits(value, each) for each in wanted)
        case "oneOf":
            return sum(fits(value, each) for each in wanted) == 1
        case "allOf":
            return all(fits(value, each) for each in wanted)
        case "not":
            return not fits(value, wanted)
        case "required":
            return all(key in value for key in wanted)
        case "properties":
            return all(fits(each, wanted[key]) for key, each in value.items() if key in wanted)
        case "additionalProperties":
            others = [each for key, each in value.items() if key not in part.get("properties", {})]
            return not others if wanted is False else all(fits(each, wanted) for each in others)
        case "items":
            return all(fits(each, wanted) for each in value)
        case "minItems":
            return len(value) >= wanted
        case "enum" | "const":
            return value in wanted if word == "enum" else value == wanted
        case "minimum" | "maximum" | "exclusiveMinimum" | "exclusiveMaximum":
            bounds = {
                "minimum": value >= wanted,
                "maximum": value <= wanted,
                "exclusiveMinimum": value > wanted,
                "exclusiveMaximum": value < wanted,
            }
            return bounds[word]
    raise AssertionError(f"the schema says {word!r}, which this test does not know")


@pytest.mark.parametrize("name", shipped_designs())
def test_every_shipped_design_fits(name):
    assert fits(tomllib.loads(shipped_design(name).read_text(encoding="utf-8")), SCHEMA)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("power_kw = 100", "power_kw = -100"),
        ("power_kw = 100", "power_kg = 100"),
        ("power_kw = 100", "power = 100"),
        ("power_kw = 100", 'power_kw = "100"'),
        ("power_kw = 100\n", ""),
        ("power_kw = 100", "power_kw = 100\npower_w = 1e5"),
        ("diameter_m = 2", "diameter_m = 2\ninertia_kg_m2 = 0"),
        ("diameter_m = 2", "diameter_m = 2\nblades = 2.5"),
        ('shaft = "fast"\n', ""),
        ('shafts = ["fast", "slow"]', "shafts = []"),
        ("schema = 1", "schema = 2"),
        ("[pairs.stage]", "[pears.stage]"),
        ('wheel = "slow"', 'wheel = "slow"\nhalves = 3'),
        ('wheel = "slow"', 'wheel = "slow"\n[shafting]\nend_length_mm = 1\nend_length_m = 0.001'),
    ],
)
def test_what_the_reader_refuses_by_its_types_the_schema_refuses_too(old, new):
    text = changed(PAIR, old, new)
    assert problems(text)
    assert not fits(tomllib.loads(text), SCHEMA)
    assert fits(tomllib.loads(PAIR), SCHEMA)


def test_every_key_of_every_record_stands_in_the_schema_with_its_meaning():
    for model in records(Design, {}):
        table = SCHEMA if model is Design else SCHEMA["$defs"][model.__name__]
        assert set(table["properties"]) == set(keys_of(model))
        assert table["additionalProperties"] is False
        for key, entry in table["properties"].items():
            assert entry.get("description") or "$ref" in entry, (model, key)


def test_bounds_are_those_of_the_type_in_the_unit_of_the_key():
    """14° to 30°: GearRules.pressure_angle."""
    entry = SCHEMA["$defs"]["GearRules"]["properties"]["pressure_angle_deg"]
    assert (entry["minimum"], entry["maximum"], entry["default"]) == pytest.approx((14, 30, 20), rel=1e-14)


def test_a_design_written_as_json_reads_back_equal():
    for text in (PAIR, HYBRID):
        design = parse(text)
        assert Design.model_validate_json(design.model_dump_json(by_alias=True, exclude_unset=True)) == design


def test_a_quantity_is_known_by_its_mark():
    marked = {name for name, info in Design.model_fields.items() if quantity_of(info) is not None}
    assert marked == set()
    speeds = SCHEMA["$defs"]["Drive"]["properties"]
    assert {"speed_rpm", "speed_rad_s"} <= set(speeds)
    assert "speed" not in speeds
