"""Designs are changed by dotted paths in the user's own keys and units; what does not exist is named."""

from __future__ import annotations

import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.spec import Design, edited, read
from gearwright.spec.edit import Value
from gearwright.units import RPM


@pytest.fixture
def design() -> Design:
    return read(shipped_design("in-line-h2"))


def test_a_value_is_converted_from_the_unit_of_its_path(design: Design) -> None:
    changed = edited(design, {"motors.electric.speed_rpm": 4200, "turbines.gas-turbine.power_hp": 1000})
    assert changed.motors["electric"].speed == pytest.approx(4200 * RPM, rel=1e-15)
    assert changed.turbines["gas-turbine"].power == pytest.approx(745699.87158227, rel=1e-12)


def test_a_path_with_a_quoted_name_is_read_as_a_file_writes_it(design: Design) -> None:
    quoted = edited(design, {'overrides."first.module_mm"': 3})
    assert quoted.overrides == edited(design, {"overrides.first.module_mm": 3}).overrides == {"first.module_mm": 3}


def test_the_design_itself_stays_as_it_is(design: Design) -> None:
    edited(design, {"planetaries.first.planets": 4})
    assert design.planetaries["first"].planets == 3


def test_an_entry_that_was_left_out_is_added(design: Design) -> None:
    changed = edited(design, {"carriers.fill": 0.5, "overrides.first.module_mm": 2.0})
    assert changed.carriers.fill == 0.5
    assert changed.overrides == {"first.module_mm": 2.0}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"motors.electrc.speed_rpm": 1}, "there is no motors.electrc; did you mean electric?"),
        ({"motors.electric.sped_rpm": 1}, "did you mean speed_rpm?"),
        ({"motors.electric": 1}, "name one of its entries"),
        ({"motors.electric.power_kw": "fast"}, "'fast' is not a number; give a number in kW"),
        ({"motors.electric.power_kw": -2}, "not allowed"),
        ({"name.first": "x"}, "name has no entries"),
        ({"turbines.gas-turbine.shaft": "inptu"}, "did you mean input?"),
        ({"supports.input": {"stiffness_n_um": 3.0}}, "there is no supports.input"),
    ],
)
def test_what_cannot_be_changed_is_named(design: Design, changes: dict[str, Value], said: str) -> None:
    with pytest.raises(DesignError) as raised:
        edited(design, changes)
    assert said in str(raised.value)


def test_all_wrong_paths_are_named_at_once(design: Design) -> None:
    with pytest.raises(DesignError) as raised:
        edited(design, {"motor.electric.speed_rpm": 1, "carriers.fil": 1})
    assert len(raised.value.problems) == 2
