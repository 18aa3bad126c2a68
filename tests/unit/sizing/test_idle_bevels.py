"""A bevel pair that no case loads has the size that is given, and is not rated."""

import pytest

from designs import PAIR
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.spec import parse

TAIL = f"""{PAIR.replace('["fast", "slow"]', '["fast", "slow", "tail"]')}
pinion_teeth = 24
wheel_teeth = 71

[pairs.tail]
kind = "bevel"
axis_angle_deg = 90
pinion = "fast"
wheel = "tail"
pinion_teeth = 20
wheel_teeth = 40

[gears]
rating = "iso6336"

[layout.tail]
diameter_mm = 20

[cases.climb]
duration_min = 5
turbine.power_kw = 90
[cases.cruise]
duration_min = 60
turbine.power_kw = 60
"""
GIVEN = "[overrides]\ntail.outer_module_mm = 5\ntail.face_width_mm = 30\n"


def test_an_idle_bevel_pair_takes_its_given_outer_module_and_width():
    """m_mn = m_et (1 - b/(2 R_e)) with R_e = m_et √(20² + 40²)/2."""
    sizing = size(parse(TAIL + GIVEN))
    pinion = next(gear for gear in sizing.gears if gear.name == "tail.pinion")
    cone = 5.0 * (20.0**2 + 40.0**2) ** 0.5 / 2.0
    assert pinion.face_width == pytest.approx(30e-3, rel=1e-12)
    assert pinion.module == pytest.approx(5e-3 * (1.0 - 15.0 / cone), rel=1e-12)
    assert not [check for check in sizing.checks if "tail" in str(check.part) and check.mode == "pitting"]


@pytest.mark.parametrize(("modules", "width"), [(2.0, 10.0), (6.0, 27.0)])
def test_an_idle_bevel_pair_with_a_module_alone_is_as_narrow_as_its_rules_allow(modules, width):
    """Whole millimetres, m_mn = m_et (1 - b/(2 R_e)): 6 · 4.4 = 26.4 mm at 27 mm, and 26 mm are less than 6 · 4.42."""
    rules = f"[gears.iso6336]\nnarrowest_modules = {modules}\n"
    text = TAIL.replace('rating = "iso6336"\n', f'rating = "iso6336"\n{rules}')
    sizing = size(parse(text + "[overrides]\ntail.outer_module_mm = 5\n"))
    pinion = next(gear for gear in sizing.gears if gear.name == "tail.pinion")
    assert pinion.face_width == pytest.approx(width * 1e-3, rel=1e-9)
    assert pinion.face_width >= modules * pinion.module > pinion.face_width - 1e-3


def test_an_idle_bevel_pair_without_a_module_is_told_what_to_write():
    with pytest.raises(DesignError, match="outer_module_mm = 2"):
        size(parse(TAIL))
