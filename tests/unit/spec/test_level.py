"""How far a design is worked out: stated in its file, or seen from its bearings."""

import pytest

from designs import PAIR, problem
from gearwright.render.answers.design import size_answer
from gearwright.render.pages.report_parts import key_numbers
from gearwright.shipped import shipped_design, shipped_designs, shipped_study
from gearwright.sizing import size
from gearwright.spec import parse, read, read_study
from mounted_designs import HELICOPTER, sized


def stating(text, level):
    """Return a design file that states its level."""
    return text.replace("shafts = ", f'level = "{level}"\nshafts = ', 1)


@pytest.mark.parametrize(("text", "level"), [(PAIR, "concept"), (HELICOPTER, "built")])
def test_bearings_decide_the_level_where_the_file_is_silent(text, level):
    sizing, stated = sized(text), sized(stating(text, level))
    assert sizing.level == stated.level == level
    assert (sizing.gears, sizing.shafts) == (stated.gears, stated.shafts)


def test_a_concept_has_no_bearings_and_a_built_one_has():
    found = problem(stating(HELICOPTER, "concept"))
    assert found.path == "level"
    assert 'write level = "built"' in found.message
    found = problem(stating(PAIR, "built"))
    assert (found.path, found.line) == ("level", 3)
    assert "'built' needs [bearings]" in found.message


def test_a_level_that_there_is_not_is_told_with_those_that_there_are():
    found = problem(stating(PAIR, "final"))
    assert "'final' is not known; allowed: 'concept', 'preliminary' or 'built'" in found.message


def test_pages_and_data_say_the_level():
    sizing = size(parse(PAIR))
    assert ("level", "concept") in [(number.name, number.text) for number in key_numbers(sizing)]
    assert size_answer(sizing).level == "concept"


@pytest.mark.parametrize("name", [*read_study(shipped_study("architectures")).designs, "face-gear-split-torque"])
def test_what_is_replayed_states_its_level_and_its_rating(name):
    """So that neither a new default nor a new method moves what published work is held against."""
    design = read(shipped_design(name))
    assert (design.level, design.gears.rating) == ("concept", "lewis-hertz")
    assert {"level"} <= design.model_fields_set and "rating" in design.gears.model_fields_set


def test_the_reported_helicopter_states_that_it_is_built():
    assert "ec120b-as-reported" in shipped_designs()
    assert read(shipped_design("ec120b-as-reported")).level == "built"
