"""Designs that read well and whose sizing used to end in no number, or in none at all: each is refused or sized."""

import math
from dataclasses import replace

import pytest

from designs import HYBRID, PAIR, changed
from gearwright.errors import DesignError, Problem
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, refuse_no_numbers, size
from gearwright.spec import parse


def shipped(name: str) -> str:
    return shipped_design(name).read_text(encoding="utf-8")


def refused(text: str) -> Problem:
    with pytest.raises(DesignError) as caught:
        size(parse(text))
    return caught.value.problems[0]


def test_gears_that_no_case_loads_are_refused_with_what_to_give():
    """The layshafts of this train drive nothing: the first pair leads from the input to the output by itself."""
    text = changed(shipped("off-set"), 'wheel = ["left", "right"]', 'wheel = "output"')
    text = changed(text, "hunting = true", "hunting = false")
    found = refused(text)
    assert found.path == "pairs.second"
    assert "write one here, such as module_mm = 2" in found.message


def test_a_shaft_that_no_case_loads_is_refused_with_what_to_give():
    text = PAIR.replace('["fast", "slow"]', '["fast", "slow", "idle"]')
    text += '[clutches.c]\ndriving = "idle"\ndriven = "fast"\nkind = "engaged"\n'
    assert refused(text).path == "layout.idle.diameter_mm"
    assert size(parse(text + "[layout.idle]\ndiameter_mm = 20\n")).shafts[2].diameter == pytest.approx(0.02)


def test_two_pairs_of_different_distance_between_the_same_axes_are_refused():
    """15 and 61 teeth in both, but other modules: the layshafts cannot stand at both distances from the input."""
    text = shipped("off-set") + '\n[pairs.third]\npinion = "input"\nwheel = ["left", "right"]\npinion_teeth = 15\n'
    found = refused(text)
    assert found.path == "pairs.third"
    assert "write coaxial_with where two pairs lie on the same axes" in found.message


def test_a_bearing_inside_a_gear_of_a_shaft_as_given_is_a_failed_check():
    """The pinion's middle at the shaft's end leaves no stretch to the bearing at 60 mm: nothing is refused there."""
    text = changed(
        shipped("ec120b-as-reported"), '"helical.pinion".position_mm = 115', '"helical.pinion".position_mm = 0'
    )
    checks = size(parse(text)).checks
    rear = next(each for each in checks if each.name == "input-rear shaft in its bore")
    assert (rear.value, rear.limit) == (pytest.approx(0.032), pytest.approx(0.030))
    assert any(each.margin < 0.1 for each in checks if each.mode == "room")


def sizing_of(text: str) -> Sizing:
    return size(parse(text))


@pytest.mark.parametrize(
    ("group", "field", "value"),
    [("gears", "module", math.inf), ("gears", "mass", 0.0), ("carriers", "pin_stress", math.nan),
     ("machines", "inertia", 0.0), ("shafts", "stiffness", -1.0), ("meshes", "tangential_force", math.inf)],
)  # fmt: skip
def test_no_result_leaves_that_is_no_number_or_not_above_zero(group: str, field: str, value: float):
    sizing = sizing_of(changed(HYBRID, "power_kw = 1046", "power_kw = 9e5"))
    first, *rest = getattr(sizing, group)
    with pytest.raises(DesignError) as caught:
        refuse_no_numbers(replace(sizing, **{group: (replace(first, **{field: value}), *rest)}))
    (found,) = caught.value.problems
    assert found.path == "turbines.turbine.power"
    assert f"the {field.replace('_', ' ')} comes out as {value:g}" in found.message


def test_a_margin_of_a_part_that_nothing_loads_may_be_infinite():
    sizing = sizing_of(HYBRID)
    first, *rest = sizing.shafts
    changed_ = replace(sizing, shafts=(replace(first, margin=math.inf), *rest))
    assert refuse_no_numbers(changed_) is changed_
