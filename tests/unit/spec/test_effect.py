"""Keys that nothing reads where they stand are told, with what to do; names that two parts would share, too."""

import pytest

from designs import HYBRID, PAIR, changed, problem
from gearwright.sizing import size
from gearwright.spec import parse

ISO = '[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
BEVEL = PAIR + 'kind = "bevel"\naxis_angle_deg = 90\n'
SET_RULES = "[planetaries.first.gears]\n"


@pytest.mark.parametrize(
    ("text", "path", "words"),
    [
        (PAIR + "spiral_angle_deg = 20\n", "pairs.stage.spiral_angle_deg", "only bevel gears have one"),
        (PAIR + 'wheel_apex = "first"\n', "pairs.stage.wheel_apex", "only bevel gears have one"),
        (PAIR + "pinion_teeth = 20\nwheel_teeth = 60\nratio = 3\n", "pairs.stage.ratio", "its teeth are given"),
        (PAIR + "ratio = 3\nratio_split = 1.2\n", "pairs.stage.ratio_split", "ratio states this one"),
        (PAIR + "[pairs.stage.gears]\nidler_factor = 0.7\n", "pairs.stage.gears.idler_factor", "only planetary sets"),
        (PAIR + "[pairs.stage.gears]\noverlap_ratio = 2\n", "pairs.stage.gears.overlap_ratio", "only helical gears"),
        (PAIR + "[pairs.stage.gears.iso6336]\ngrade = 'ME'\n", "pairs.stage.gears.iso6336", "with Lewis and Hertz"),
        (PAIR + "[gears.iso6336]\ngrade = 'ME'\n", "gears.iso6336", "with Lewis and Hertz"),
        (PAIR + ISO + "bending_safety = 2\n", "gears.bending_safety", "ISO 6336 does not read it"),
        (PAIR + "[service]\nlife_h = 100\n", "service", "has no effect without a rated part"),
        (HYBRID + SET_RULES + "helix_angle_deg = 15\n", "planetaries.first.gears.helix_angle_deg", "are spur here"),
        (PAIR + '[joints."stage.pinion"]\nkind = "key"\n', "joints.stage.pinion", "fast has no bearings"),
        (HYBRID + "[layout.middle]\nfirst_bearing_mm = 5\n", "layout.middle.first_bearing_mm", "only torque acts"),
        (changed(PAIR, "speed_rpm = 6000", "speed_rpm = 6000\ninertia_kg_m2 = 1\ndiameter_m = 0.5"),
         "turbines.turbine.diameter_m", "it only estimates the inertia"),
    ],
)  # fmt: skip
def test_a_key_without_effect_is_told(text: str, path: str, words: str):
    with pytest.raises(Exception, match="problem") as caught:
        parse(text)
    first = caught.value.problems[0]
    assert words in first.message
    assert not path or first.path == path


def test_a_shift_of_all_pinions_is_taken_back_for_a_stage():
    text = PAIR + 'gears = {profile_shift = 0}\nkind = "bevel"\naxis_angle_deg = 90\n' + ISO + "profile_shift = 0.3\n"
    assert parse(text).rules("stage").profile_shift == 0.0


def test_rules_for_all_parts_may_say_more_than_one_design_has_parts_for():
    """A study varies them over several architectures, of which not every one has carriers or wheels."""
    assert (
        parse(PAIR + "[carriers]\nfill = 0.5\n[gears]\nidler_factor = 0.7\nrim_thickness_ratio = 4\n").carriers.fill
        == 0.5
    )


def test_a_helix_for_all_pairs_says_nothing_to_a_design_of_sets():
    """Refused where it stands with a set alone; for all parts it is that of pairs, which this design lacks."""
    assert "[pairs." not in HYBRID
    straight, helical = size(parse(HYBRID)), size(parse(HYBRID + "[gears]\nhelix_angle_deg = 15\n"))
    assert helical.mass == straight.mass


def test_a_machine_named_like_a_shaft_is_refused_with_both_places():
    """Its shaft in the dynamic model and its mass in [overrides] would be called alike."""
    found = problem(changed(PAIR, "[turbines.turbine]", "[turbines.fast]"))
    assert found.path == "turbines.fast"
    assert found.message == (
        "shafts has a shaft of this name already; results, places along shafts and overrides need different names:"
        " rename the machine"
    )


def test_a_pair_named_like_a_line_of_the_dynamic_model_is_refused():
    found = problem(changed(PAIR, "[pairs.stage]", '[pairs."fast shaft"]'))
    assert found.path == "pairs.fast shaft"
    assert "the dynamic model calls the shaft of 'fast' so" in found.message


def test_a_train_that_nothing_drives_is_refused():
    text = changed(PAIR, '[turbines.turbine]\nshaft = "fast"\npower_kw = 100\nspeed_rpm = 6000\n', "")
    found = problem(text)
    assert found.message.startswith("no machine of a stated power drives this train, so that nothing loads it")


SHARED = """\
schema = 1
name = "one pinion between two wheels"
level = "concept"
shafts = ["in", "a", "b"]
[turbines.t]
shaft = "in"
power_kw = 1000
speed_rpm = 6000
[propellers.p]
shaft = "a"
speed_rpm = 2000
diameter_m = 4
[motors.m]
shaft = "b"
power_kw = 10
speed_rpm = 3000
[pairs.one]
pinion = "in"
wheel = "a"
[pairs.two]
pinion = "one.pinion"
wheel = "b"
"""


@pytest.mark.parametrize(
    ("old", "new", "path"),
    [
        ('"one.pinion"', '"one.pinion"\npinion_teeth = 30', "pairs.two.pinion_teeth"),
        ('"one.pinion"', '"one.pinion"\nhalves = 2', "pairs.two.halves"),
        ('wheel = "b"\n', 'wheel = "b"\ngears = {helix_angle_deg = 15}\n', "pairs.two.gears.helix_angle"),
        ('wheel = "b"\n', 'wheel = "b"\ngears = {profile_shift = 0.2}\n', "pairs.two.gears.profile_shift"),
    ],
)
def test_two_pairs_that_share_a_gear_say_the_same_of_it(old: str, new: str, path: str):
    parse(SHARED)
    assert problem(changed(SHARED, old, new)).path.startswith(path)


def test_an_internal_wheel_is_larger_than_its_pinion():
    found = problem(PAIR + "internal = true\npinion_teeth = 40\nwheel_teeth = 40\n")
    assert found.path == "pairs.stage.wheel_teeth"
