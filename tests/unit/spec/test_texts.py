"""Changes of a design in the text of its file: comments, order and units of what is not changed stay."""

import pytest

from designs import PAIR
from gearwright.shipped import find_design, shipped_designs
from gearwright.spec import design_text_like, edited, parse, read

TEXT = """\
schema = 1
name = "one pair"
shafts = ["fast", "slow"]
level = "concept"   # a first sizing
[turbines.turbine]
shaft = "fast"
power_kw = 100
speed_rpm = 6000
limits.oei = { power_kw = 120, duration_min = 2.5 } # for a while

[propellers.propeller]
shaft = "slow"
speed_rpm = 2000
diameter_m = 3.93   # as flown

# the only stage
[pairs.stage]
pinion = "fast"
wheel = "slow"
ratio = 3.0
# behind it nothing
[gears]
rating = "iso6336"
iso6336.grade = "MQ"
"""
"""A design as a user writes it."""


def written(changes, text=TEXT):
    before = parse(text)
    after = edited(before, changes)
    found = design_text_like(after, text, before)
    assert parse(found) == after
    return found


@pytest.mark.parametrize("name", shipped_designs())
def test_a_design_that_is_not_changed_is_written_as_it_stands(name):
    text = find_design(name).read_text(encoding="utf-8")
    design = read(name)
    assert design_text_like(design, text, design).strip() == text.strip()


def test_units_comments_and_order_stay():
    found = written({"propellers.propeller.diameter_mm": 4000, "turbines.turbine.power_w": 90500})
    assert "diameter_m = 4   # as flown" in found
    assert "power_kw = 90.5\n" in found
    assert found.replace("diameter_m = 4 ", "diameter_m = 3.93 ").replace("90.5", "100") == TEXT


def test_new_keys_stand_in_their_table_without_digits_that_rounding_made():
    before = parse(TEXT)
    after = edited(before, {"pairs.stage.module_mm": 12.700000000000001, "pairs.stage.pinion_teeth": 20})
    found = design_text_like(after, TEXT, before)
    above, _, below = found.partition("# behind it nothing\n[gears]")
    assert below and sorted(above.splitlines()[-3:]) == ["module_mm = 12.7", "pinion_teeth = 20", "ratio = 3.0"]


def test_new_tables_stand_beside_their_like_and_lives_are_hours():
    found = written({"service.life_h": 5000, "layout.fast.diameter_mm": 30.0})
    assert found.endswith("\n[layout.fast]\ndiameter_mm = 30\n\n[service]\nlife_h = 5000\n")


def test_dotted_keys_and_tables_in_one_line_are_changed_where_they_stand():
    found = written({"turbines.turbine.limits.oei.power_kw": 130, "gears.iso6336.grade": "ME",
                     "gears.iso6336.steel": "case-hardened"})  # fmt: skip
    assert "limits.oei = { power_kw = 130, duration_min = 2.5 } # for a while" in found
    assert 'iso6336.grade = "ME"\niso6336.steel = "case-hardened"\n' in found


def test_what_is_left_out_goes_with_its_line():
    found = written({"pairs.stage.ratio": None, "pairs.stage.pinion_teeth": 20})
    assert "ratio =" not in found and "# behind it nothing" in found


def test_texts_and_lists_over_lines_are_one_value():
    text = TEXT.replace('shafts = ["fast", "slow"]', 'shafts = [\n  "fast", # first\n  "slow",\n]')
    text = text.replace('name = "one pair"', 'name = "one pair"\ndescription = """two\nlines = 3 # of text"""')
    found = written({"turbines.turbine.power_kw": 80, "description": "one"}, text)
    assert 'description = "one"\nshafts = [\n  "fast", # first' in found


def test_a_text_whose_statements_cannot_be_changed_is_written_anew():
    text = PAIR.replace("[turbines.turbine]", "[[x]]\n[turbines.turbine]").replace("[[x]]\n", "")
    before = parse(text)
    after = edited(before, {"turbines.turbine.power_kw": 7})
    broken = text.replace("[turbines.turbine]\n", "[ turbines . turbine ]\n")
    assert parse(design_text_like(after, broken, before)) == after
