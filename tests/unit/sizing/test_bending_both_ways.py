"""Teeth that are loaded on both flanks bear alternating bending: Y_M = 0.7 (ISO 6336-3:2019, annex B, R = -1)."""

import pytest

from gearwright.sizing import size
from gearwright.spec import parse

TRAIN = """\
schema = 1
name = "an idler between two pairs"
level = "concept"
shafts = ["in", "middle", "out"]
[motors.drive]
shaft = "in"
power_kw = 100
speed_rpm = 6000
[loads.taker]
shaft = "out"
speed_rpm = 3000
[pairs.one]
pinion = "in"
wheel = "middle"
pinion_teeth = 25
wheel_teeth = 37
[pairs.two]
pinion = {pinion}
wheel = "out"
pinion_teeth = {teeth}
wheel_teeth = {wheel}
[gears]
rating = "iso6336"
material = "carburised-9310"
"""


def means(sizing):
    """Return gear -> Y_M in each of its meshes."""
    found = {}
    for mesh in sizing.meshes:
        for gear, strength in zip(mesh.gears, mesh.rating.factors.root_strength, strict=True):
            found.setdefault(gear, []).append(strength.mean_stress)
    return found


def test_a_fixed_idler_bends_both_ways_and_its_mates_do_not():
    """The wheel of one pair is the pinion of the next: it is driven on one flank and drives with the other."""
    sizing = size(parse(TRAIN.format(pinion='"one.wheel"', teeth=37, wheel=50)))
    assert means(sizing) == {"one.pinion": [1.0], "one.wheel": [0.7, 0.7], "two.wheel": [1.0]}


def test_two_gears_of_a_layshaft_bend_one_way():
    """The same shafts with a gear of its own for the second pair: a layshaft, and no idler."""
    sizing = size(parse(TRAIN.format(pinion='"middle"', teeth=30, wheel=41)))
    assert {value for values in means(sizing).values() for value in values} == {1.0}


@pytest.mark.parametrize(("other", "mean"), [(50, 1.0), (-50, 0.7)])
def test_a_gear_between_two_pinions_bends_both_ways_where_one_of_them_takes(other, mean):
    """Two motors drive one wheel on the same flank; where one of them takes power, the wheel drives it with the other.

    The pinion that takes bends one way, as in all of its life.
    """
    text = TRAIN[: TRAIN.index("[pairs.two]")].replace('pinion = "in"', 'pinion = ["in", "side"]')
    text = text.replace('"middle"]', '"side"]').replace('wheel = "middle"', 'wheel = "out"').replace('"middle", ', "")
    text = text.replace('["in", "out"]', '["in", "side", "out"]').replace("speed_rpm = 3000\n", "")
    text += '[motors.second]\nshaft = "side"\npower_kw = 60\nspeed_rpm = 6000\n' + TRAIN[TRAIN.index("[gears]") :]
    sizing = size(parse(text + f"[cases.a]\nshare = 1\ndrive.power_kw = 100\nsecond.power_kw = {other}\n"))
    assert set(means(sizing)["one.wheel"]) == {mean}


def test_a_limit_load_on_the_other_flank_is_no_alternating_bending():
    text = TRAIN.format(pinion='"middle"', teeth=30, wheel=41) + "[cases.a]\nshare = 1\ndrive.power_kw = 100\n"
    sizing = size(parse(text + "[cases.b]\nstatic = true\ndrive.torque_nm = -10\n"))
    assert {value for values in means(sizing).values() for value in values} == {1.0}
