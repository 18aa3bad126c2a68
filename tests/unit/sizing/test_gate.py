"""Designs that read well and whose sizing used to end in no number, or in none at all: each is refused or sized."""

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import pytest

from designs import HYBRID, PAIR, changed
from gearwright.errors import DesignError, Problem
from gearwright.lanes import twin
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import Sizing, refuse_no_numbers, size
from gearwright.sizing.result import _written
from gearwright.spec import Record, parse


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
    with pytest.raises(DesignError) as caught:
        refuse_no_numbers(with_one(sizing, group, field, value))
    (found,) = caught.value.problems
    assert found.path == "turbines.turbine.power"
    assert f"the {field.replace('_', ' ')} comes out as {value:g}" in found.message


@pytest.mark.parametrize(
    ("group", "field"),
    [("shafts", "margin"), ("carriers", "pin_margin"), ("carriers", "eye_margin"), ("carriers", "hole_margin"),
     ("checks", "value"), ("checks", "limit")],
)  # fmt: skip
def test_a_margin_of_a_part_that_nothing_loads_may_be_infinite(group: str, field: str):
    changed_ = with_one(sizing_of(HYBRID), group, field, math.inf)
    assert refuse_no_numbers(changed_) is changed_


@pytest.mark.parametrize(
    ("group", "field"),
    [("carriers", "hole_pressure"), ("carriers", "plate_margin"), ("bearings", "wanted_life"),
     ("bearings", "modified_life"), ("joints", "allowed_pressure"), ("joints", "needed_pressure")],
)  # fmt: skip
def test_a_result_is_not_infinite_for_its_name(group: str, field: str):
    sizing = shipped_sizing("twin-engine-helicopter" if group == "carriers" else "ec120b")
    with pytest.raises(DesignError, match=f"the {field.replace('_', ' ')} comes out as inf"):
        refuse_no_numbers(with_one(sizing, group, field, math.inf))


@cache
def shipped_sizing(name: str) -> Sizing:
    return sizing_of(shipped(name))


def with_one(sizing: Sizing, group: str, field: str, value: float) -> Sizing:
    """Return a sizing whose first part of a group has another value."""
    first, *rest = getattr(sizing, group)
    return replace(sizing, **{group: (replace(first, **{field: value}), *rest)})


def scaled(value: object, path: str, factor: float, own: str = "") -> object:
    """Return a record, or what is in one, with one of its numbers times a factor."""
    if own == path:
        return value * factor  # type: ignore[operator]
    if isinstance(value, Record) and path.startswith(own):
        names = value.model_fields_set
        update = {name: scaled(getattr(value, name), path, factor, f"{own}.{name}".strip(".")) for name in names}
        return value.model_copy(update=update)
    if isinstance(value, Mapping):
        return {name: scaled(item, path, factor, f"{own}.{name}") for name, item in value.items()}
    return value


def blamed(sizing: Sizing) -> Problem:
    with pytest.raises(DesignError) as caught:
        refuse_no_numbers(with_one(sizing, "gears", "mass", math.nan))
    (found,) = caught.value.problems
    return found


@pytest.mark.parametrize("name", shipped_designs())
def test_no_number_of_a_shipped_design_is_blamed(name: str):
    found = blamed(shipped_sizing(name))
    assert found.path == ""
    assert found.message.endswith("comes out as nan, which no part has; no number of the design stands out")


@pytest.mark.parametrize("factor", [1e9, 1e-9])
@pytest.mark.parametrize("name", shipped_designs())
def test_a_number_that_is_wrong_by_nine_powers_of_ten_is_blamed(name: str, factor: float):
    """Every number of every shipped design: in a file most are refused before anything is sized with them."""
    sizing = shipped_sizing(name)
    single = [number for number in _written(sizing.design) if not number.key.endswith(("share", "load"))]
    for number in single:
        found = blamed(replace(sizing, design=scaled(sizing.design, number.path, factor)))
        assert found.path == number.path
        assert f"{number.path} = {number.value * factor:g} stands out: the shipped designs have " in found.message


def test_a_number_that_no_shipped_design_has_is_not_blamed():
    sizing = sizing_of(HYBRID)
    unknown = replace(sizing, design=sizing.design.model_copy(update={"overrides": {"first.volume_l": 1e30}}))
    assert blamed(unknown).path == ""


def test_a_power_of_twice_the_largest_shipped_one_is_not_blamed():
    sizing = shipped_sizing("geared-turbofan-star")
    assert blamed(replace(sizing, design=scaled(sizing.design, "turbines.low-pressure-turbine.power", 2.0))).path == ""


def test_the_gate_of_many_designs_says_the_same():
    sizing = with_one(shipped_sizing("in-line-h2"), "gears", "mass", math.inf)
    for gate in (refuse_no_numbers, twin("gearwright.sizing.result").refuse_no_numbers):
        with pytest.raises(DesignError, match=r"the mass comes out as inf.*no number of the design stands out"):
            gate(sizing)
