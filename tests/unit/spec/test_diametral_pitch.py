"""Modules written as diametral pitches: one mechanism for reading, changing, overriding, studies and the schema."""

import pytest
from hypothesis import given, strategies as st

from designs import HYBRID, PAIR, changed, problem
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.spec import edited, keys_of, parse, schema
from gearwright.spec.design import CentralGear, Pair, Planetary, PlanetGear
from gearwright.spec.record import Key, Range

SPUR = f"{PAIR}pinion_teeth = 20\nwheel_teeth = 60\n"


@pytest.mark.parametrize(
    ("record", "key"),
    [
        (Pair, "normal_diametral_pitch"), (Pair, "outer_diametral_pitch"), (Planetary, "diametral_pitch"),
        (Planetary, "normal_diametral_pitch"), (CentralGear, "diametral_pitch"), (PlanetGear, "diametral_pitch"),
    ],
)  # fmt: skip
def test_every_table_with_a_module_takes_a_pitch(record, key):
    """8 teeth an inch of diameter are 3.175 mm, exactly."""
    meant = keys_of(record)[key]
    assert meant.field == ("outer_module" if key.startswith("outer") else "module")
    assert meant.si(8.0) == 0.0254 / 8.0


@given(st.floats(1e-3, 1e3))
def test_writing_undoes_reading(pitch):
    key = keys_of(Pair)["normal_diametral_pitch"]
    assert key.written(key.si(pitch)) == pytest.approx(pitch, rel=1e-14)
    assert key.si(2.0 * pitch) == pytest.approx(0.5 * key.si(pitch))


def test_a_pitch_and_its_module_make_one_gearbox():
    """P 8 and inches for widths and centre distances are as good as 3.175 mm."""
    inches = size(parse(f"{SPUR}normal_diametral_pitch = 8\nface_width_in = 1.25\ncentre_distance_in = 5.05\n"))
    metric = size(parse(f"{SPUR}module_mm = 3.175\nface_width_mm = 31.75\ncentre_distance_mm = 128.27\n"))
    assert inches.gears[0].module == pytest.approx(3.175e-3, rel=1e-14)
    assert inches.mass == pytest.approx(metric.mass, rel=1e-12)
    assert inches.gears[0].profile_shift == pytest.approx(metric.gears[0].profile_shift, rel=1e-9)


@pytest.mark.parametrize("other", ["module_mm = 3", "module_in = 0.125", "module_mm = 3.175"])
def test_both_are_one_too_many(other):
    told = problem(f"{SPUR}normal_diametral_pitch = 8\n{other}\n")
    assert told.path == f"pairs.stage.{other.split()[0]}"
    assert told.message == (
        "module is given twice; keep one of pairs.stage.normal_diametral_pitch and pairs.stage." + other.split()[0]
    )


@pytest.mark.parametrize("pitch", ["0", "-8", "1e9", '"8"', "true", "inf"])
def test_a_pitch_that_is_none_is_told_in_its_own_unit(pitch):
    told = problem(f"{SPUR}normal_diametral_pitch = {pitch}\n")
    assert told.path == "pairs.stage.normal_diametral_pitch"
    assert "1/in" in told.message


def test_the_transverse_name_is_that_of_spur_sets():
    """On a pair, which may be helical, it would have two meanings."""
    told = problem(f"{SPUR}diametral_pitch = 8\n").message
    assert told == "no such field; write normal_diametral_pitch or outer_diametral_pitch"


def test_a_change_of_the_pitch_is_a_change_of_the_module():
    design = parse(f"{SPUR}module_mm = 2\n")
    assert edited(design, {"pairs.stage.normal_diametral_pitch": 10}).pairs["stage"].module == pytest.approx(2.54e-3)
    assert edited(design, {"pairs.stage.normal_diametral_pitch": None}).pairs["stage"].module is None
    with pytest.raises(DesignError, match="module is given twice"):
        edited(design, {"pairs.stage.normal_diametral_pitch": 10, "pairs.stage.module_mm": 3})
    with pytest.raises(DesignError, match="write normal_diametral_pitch or outer_diametral_pitch"):
        edited(design, {"pairs.stage.diametral_pitch": 10})
    with pytest.raises(DesignError, match=r"0 1/in is not allowed"):
        edited(design, {"pairs.stage.normal_diametral_pitch": 0})


def test_overrides_and_origins_take_a_pitch():
    over = '[overrides]\n"first.diametral_pitch" = 8\n[origins]\n"first.diametral_pitch" = "an old drawing"\n'
    sizing = size(parse(HYBRID + over))
    given_module = sizing.given["first.module"]
    assert given_module.value == 0.0254 / 8.0
    assert (given_module.amount, given_module.entry) == (8.0, "first.diametral_pitch")
    assert given_module.origin == "an old drawing"
    assert "is not allowed; give" in problem(HYBRID + '[overrides]\n"first.diametral_pitch" = -8\n').message
    twice = HYBRID + '[overrides]\n"first.diametral_pitch" = 8\n"first.module_mm" = 3\n'
    assert "first.module is given twice" in problem(twice).message


def test_the_schema_offers_the_pitch_with_bounds_turned_over():
    table = schema()["$defs"]["Pair"]
    module, pitch = table["properties"]["module_in"], table["properties"]["normal_diametral_pitch"]
    assert pitch["title"] == "normal diametral pitch [1/in]"
    assert pitch["minimum"] == pytest.approx(1.0 / module["maximum"])
    assert pitch["maximum"] == pytest.approx(1.0 / module["minimum"])
    one_of = next(
        part["oneOf"] for part in table["then"]["allOf"] if {"required": ["module_mm"]} in part.get("oneOf", [])
    )
    assert {"required": ["normal_diametral_pitch"]} in one_of


def test_words_of_a_range_are_turned_over_with_their_ends():
    key = Key("module", 0.0254, "per_in", inverse=True)
    assert key.words(Range(0.001, 0.0254, above=True)) == "a value from 1 and below 25.4 1/in"


def test_a_hidden_table_takes_it_as_well():
    text = changed(HYBRID, 'carrier = "middle"\n', 'carrier = "middle"\ndiametral_pitch = 10\n')
    assert parse(text).planetaries["first"].module == 0.0254 / 10.0
