"""The JSON Schema speaks of the same files as the reader."""

import json
import tomllib

import pytest

from designs import HYBRID, PAIR, changed, problems
from gearwright.errors import DesignError
from gearwright.shipped import (
    shipped_design,
    shipped_designs,
    shipped_mission,
    shipped_missions,
    shipped_mix,
    shipped_studies,
    shipped_study,
)
from gearwright.spec import keys_of, parse, quantity_of, records, schema
from gearwright.spec.design import Design
from json_schema import faults

SCHEMA = schema()


def fits(value, part):
    return not faults(value, part)


@pytest.mark.parametrize("name", shipped_designs())
def test_every_shipped_design_fits(name):
    assert fits(tomllib.loads(shipped_design(name).read_text(encoding="utf-8")), SCHEMA)


@pytest.mark.parametrize("name", shipped_missions())
def test_every_shipped_mission_fits(name):
    assert not faults(tomllib.loads(shipped_mission(name).read_text(encoding="utf-8")), schema("mission"))


@pytest.mark.parametrize("name", shipped_studies())
def test_every_shipped_study_fits(name):
    assert not faults(tomllib.loads(shipped_study(name).read_text(encoding="utf-8")), schema("study"))


@pytest.mark.parametrize("of", ["design", "mission", "mix", "study"])
def test_a_schema_has_a_name_and_asks_for_no_null_which_toml_does_not_have(of):
    made = schema(of)
    assert made["$id"] == f"urn:gearwright:file:{of}:1"
    assert '"null"' not in json.dumps(made)


def test_a_file_that_nobody_writes_has_no_schema():
    with pytest.raises(DesignError, match="did you mean mission"):
        schema("misson")


def misspelt(tables, at=()):
    """Yield the path of every key of a file."""
    for key, value in tables.items():
        yield (*at, key)
        if isinstance(value, dict):
            yield from misspelt(value, (*at, key))


@pytest.mark.parametrize("of", ["design", "mission", "mix", "study"])
def test_one_misspelt_key_marks_one_place(of):
    """Where the schema names the keys; names that the user gives may be anything."""
    text = {"design": PAIR, "mission": shipped_mission("thesis").read_text(encoding="utf-8"),
            "mix": shipped_mix("regional-life").read_text(encoding="utf-8"),
            "study": shipped_study("lightest-hybrid").read_text(encoding="utf-8")}[of]  # fmt: skip
    made, marked = schema(of), 0
    for path in misspelt(tomllib.loads(text)):
        tables = tomllib.loads(text)
        table = tables
        for name in path[:-1]:
            table = table[name]
        table[f"{path[-1]}x"] = table.pop(path[-1])
        found = faults(tables, made)
        assert len(found) <= 1, (path, found)
        if found:
            assert found == [(".".join(("$", *path[:-1], f"{path[-1]}x")), "additionalProperties")]
            marked += 1
    assert marked >= 10


def test_one_wrong_value_marks_one_place():
    for old, new, place in [
        ('shaft = "fast"', "shaft = 3", "$.turbines.turbine.shaft"),
        ('pinion = "fast"', "pinion = 3", "$.pairs.stage.pinion"),
        ("power_kw = 100", 'power_kw = "2,67"', "$.turbines.turbine.power_kw"),
    ]:
        assert [at for at, _ in faults(tomllib.loads(changed(PAIR, old, new)), SCHEMA)] == [place]


def test_titles_have_units_as_engineers_write_them():
    entries = SCHEMA["$defs"]["Turbine"]["properties"]
    assert entries["power_kw"]["title"] == "power [kW]"
    assert entries["inertia_kg_m2"]["description"].endswith("[kg m²]")


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
        beside = False if model.others is None else {"$ref": f"#/$defs/{model.others.__name__}"}
        assert table["additionalProperties"] == beside
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
