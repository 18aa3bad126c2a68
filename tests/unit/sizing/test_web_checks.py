"""Webs of wheels are held against waves that stand in space, the mesh, and bending by helical teeth."""

import pytest

from designs import changed
from gearwright.sizing import size
from gearwright.sizing.webs import webbed_wheels
from gearwright.spec import at_level, parse

WHEEL = """
schema = 1
name = "thin wheel"
shafts = ["fast", "slow"]
[turbines.t]
shaft = "fast"
power_kw = 500
speed_rpm = 8508
[loads.l]
shaft = "slow"
speed_rpm = 1212
[pairs.p]
pinion = "fast"
wheel = "slow"
pinion_teeth = 50
wheel_teeth = 351
module_mm = 2.394
face_width_mm = 58
[gears]
web_thickness_ratio = 0.0862
"""


def checks(text, level=None):
    """Return mode -> check of the wheel, and its web."""
    design = parse(text) if level is None else at_level(parse(text), level)
    sizing = size(design)
    webs = {wheel.gear.name: wheel.web for wheel in webbed_wheels(sizing)}
    return {check.mode: check for check in sizing.checks if check.part.name == "p.wheel"}, webs["p.wheel"]


@pytest.mark.parametrize(
    ("ratio", "thickness", "fails"), [(0.0862, 5.0e-3, True), (0.138, 8.0e-3, True), (0.207, 12.0e-3, False)]
)
def test_a_thin_wheel_fails_until_its_web_is_thick_enough(ratio, thickness, fails):
    found, web = checks(changed(WHEEL, "web_thickness_ratio = 0.0862", f"web_thickness_ratio = {ratio}"))
    standing = found["standing wave of the web"]
    assert web.thickness == pytest.approx(thickness, rel=1e-2)
    assert standing.fails is fails
    assert standing.place == "2 diameters"
    assert standing.limit == pytest.approx(1.3 * 2 * 1212 / 60, rel=1e-3)
    assert ("web_thickness_ratio" in standing.why) is fails


def test_modes_keep_clear_of_the_mesh_and_of_twice_it():
    found, _ = checks(WHEEL)
    assert found["resonance of the web"].limit == 0.10
    slow = changed(WHEEL, "speed_rpm = 8508", "speed_rpm = 85.08").replace("speed_rpm = 1212", "speed_rpm = 12.12")
    low, _ = checks(slow.replace("power_kw = 500", "power_kw = 5"))
    assert low["resonance of the web"].value != found["resonance of the web"].value
    assert not low["standing wave of the web"].fails


def test_helical_teeth_bend_a_web_and_double_helical_ones_do_not():
    assert "bending of the web" not in checks(WHEEL)[0]
    helical = f"{WHEEL}helix_angle_deg = 12\n"
    found, _ = checks(changed(helical, "module_mm = 2.394", "module_mm = 2.34"))
    thick, _ = checks(
        changed(helical, "web_thickness_ratio = 0.0862", "web_thickness_ratio = 0.207").replace("2.394", "2.34")
    )
    bending = found["bending of the web"]
    assert bending.value > thick["bending of the web"].value
    assert bending.value / thick["bending of the web"].value == pytest.approx((12.0 / 5.0) ** 2, rel=0.05)


def test_a_concept_has_no_such_checks():
    found, _ = checks(WHEEL, "concept")
    assert not [mode for mode in found if "web" in mode]
