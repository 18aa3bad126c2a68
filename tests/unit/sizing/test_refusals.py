"""Designs that read well and cannot be made: which stage, what was asked, what would do."""

import pytest

from designs import HYBRID, PAIR, changed, problem
from gearwright.sizing import size
from gearwright.spec import parse


def test_a_ratio_that_no_teeth_can_give_is_refused_with_the_range():
    """The motor at 19 000 rpm leaves 1.053 for a planetary set, which begins above 2."""
    found = problem(changed(HYBRID, "speed_rpm = 4500", "speed_rpm = 19000"), sized=True)
    assert found.path == "planetaries.first"
    least = "1 + z_r/z_s = 1.053 is below 2.06, the least with suns of up to 400 teeth and planets of 12 or more"
    assert found.message.startswith(least)


def test_a_ratio_between_two_teeth_is_refused_within_the_tolerance():
    """z_2 = 20 · 3.0 = 60; 59 teeth miss the ratio by 1.7 %."""
    text = PAIR + "pinion_teeth = 20\nwheel_teeth = 59\n"
    assert size(parse(text)).teeth["stage.wheel"] == 59
    text = changed(text, "wheel_teeth = 59", "ratio = 3.025") + "[teeth]\nstage_tolerance = 0.001\n"
    found = problem(text, sized=True)
    assert found.path == "pairs.stage"
    assert found.message.startswith(
        "no wheel gives a pinion of 20 teeth the ratio 3.025 within 0.1%; leave pinion_teeth"
    )


def test_five_planets_that_do_not_fit_name_how_many_do():
    """At 6.75, five planets touch: (z_s + z_p) sin 36° > z_p + 2 needs a ratio below 4.85; four fit below 6.83."""
    text = changed(HYBRID, "speed_rpm = 1212", "speed_rpm = 667")
    found = problem(text, sized=True)
    assert found.path == "planetaries.second.planets"
    assert found.message == "5 planets do not fit at ratio 6.75; at most 4"
    assert size(parse(changed(text, "planets = 5", "planets = 4"))).design.planetaries["second"].planets == 4


def test_speeds_that_contradict_the_teeth_are_named_with_both():
    """30 and 90 teeth turn the carrier at 5000 rpm, where the motor asks for 4500."""
    text = changed(HYBRID, "planets = 3", "planets = 3\nsun_teeth = 30\nplanet_teeth = 30")
    found = problem(text, sized=True)
    assert found.path == "motors.electric.speed"
    assert found.message.startswith("4500 rpm is asked, but the teeth and the other speeds give 5000 rpm (+11.1%)")


def test_a_ratio_that_contradicts_the_speeds_is_refused():
    found = problem(PAIR + "ratio = 2\n", sized=True)
    assert found.path == "pairs.stage"
    assert "the asked ratio 2 turn a machine at another speed than it asks for, by more than 5.0%" in found.message


def test_a_case_whose_speeds_contradict_the_teeth_is_refused():
    text = PAIR + "[cases.odd.turbine]\npower_kw = 50\nspeed_rpm = 6000\n[cases.odd.propeller]\nspeed_rpm = 1000\n"
    found = problem(text, sized=True)
    assert found.path == "cases.odd.propeller.speed"


def test_teeth_below_the_undercut_limit_are_refused():
    """z_min = 2/sin² 20° = 17.1: 18 teeth."""
    found = problem(PAIR + "pinion_teeth = 14\n", sized=True)
    assert found.path == "pairs.stage.pinion_teeth"
    assert found.message.startswith("14 teeth are undercut; use at least 18")
    assert size(parse(PAIR + "pinion_teeth = 14\n[gears]\nprofile_shift = 0.3\n")).teeth["stage.pinion"] == 14


@pytest.mark.parametrize(
    ("line", "path", "words"),
    [
        ("sun_teeth = 5", "sun_teeth", "give a value from 6 to 2000"),
        ("planet_teeth = 5", "planet_teeth", "give a value from 6 to 2000"),
        ("sun_teeth = 54\nring_teeth = 187", "ring_teeth", "187 leaves no planets beside a sun of 54"),
        ("planet_teeth = 54\nring_teeth = 100", "ring_teeth", "100 leaves no sun inside planets of 54"),
        ("sun_teeth = 5000", "sun_teeth", "give a value from 6 to 2000"),
    ],
)
def test_teeth_that_make_no_planetary_set_are_refused(line, path, words):
    found = problem(changed(HYBRID, "planets = 3", f"planets = 3\n{line}"))
    assert found.path == f"planetaries.first.{path}"
    assert words in found.message


def test_a_ring_that_is_given_alone_is_kept():
    teeth = size(parse(changed(HYBRID, "planets = 3", "planets = 3\nring_teeth = 176"))).teeth
    assert (teeth["first.sun"], teeth["first.planet"], teeth["first.ring"]) == (52, 62, 176)
    found = problem(changed(HYBRID, "planets = 3", "planets = 3\nring_teeth = 150"), sized=True)
    assert found.message.startswith("no tooth numbers with ring_teeth = 150 give the ratio 4.444 within 2.5% and let 3")


def test_given_teeth_that_cannot_be_assembled_are_named():
    """(z_s + z_r)/N = (55 + 187)/3 is not whole."""
    text = changed(HYBRID, "planets = 3", "planets = 3\nsun_teeth = 55\nplanet_teeth = 66")
    found = problem(text, sized=True)
    assert found.path.startswith("planetaries.first")
    assert "assembled" in found.message


def test_a_bore_thicker_than_the_sized_shaft_is_refused():
    found = problem(PAIR + "[layout.fast]\nbore_mm = 80\n", sized=True)
    assert found.path == "layout.fast.bore_mm"
    assert (
        "80 mm, and stage.pinion (z 18, m_n 3.109 mm) has a root circle of 48.19 mm; allowed: up to 41.19 mm"
        in found.message
    )
    found = problem(PAIR + "[layout.fast]\nbore_mm = 40\n", sized=True)
    assert found.path == "layout.fast.bore_mm"
    assert found.message.startswith("the bore 40 mm leaves too thin a wall in a shaft of ")
    assert size(parse(PAIR + "[layout.fast]\nbore_mm = 2\n")).shafts[0].bore == 0.002


def test_a_split_that_contradicts_the_speeds_is_refused():
    """The motor's speed leaves no freedom that a split could use."""
    found = problem(changed(HYBRID, "planets = 3", "planets = 3\nratio_split = 1.3"), sized=True)
    assert found.path == "planetaries.first"
    assert "tooth numbers that give z_r/z_s = " in found.message


def test_clutches_that_leave_no_path_are_refused():
    """The only clutch transmits from the propeller's side to the turbine's."""
    text = changed(changed(PAIR, 'pinion = "fast"', 'pinion = "middle"'), '"slow"]', '"slow", "middle"]')
    good = text + '[clutches.sprag]\ndriving = "fast"\ndriven = "middle"\n'
    assert size(parse(good)).flows["rated"].joints["sprag"] > 0.0
    found = problem(text + '[clutches.sprag]\ndriving = "middle"\ndriven = "fast"\n', sized=True)
    assert found.path == "cases.rated"
    assert "the power of some machine has no path to it. Join the shafts, engage a clutch" in found.message


def test_a_planetary_set_with_three_free_members_is_refused():
    text = changed(HYBRID, 'ring = "ground"', 'ring = "loose"').replace('"output"]', '"output", "loose"]')
    found = problem(text, sized=True)
    assert found.path == "shafts"
    assert "the speeds of loose are not determined" in found.message
    assert "ground a member" in found.message


def test_the_power_of_a_case_that_nothing_balances_is_refused():
    text = PAIR + "[cases.stuck.turbine]\npower_kw = 100\n[cases.stuck.propeller]\npower_kw = -50\n"
    found = problem(text)
    assert found.path == "cases.stuck"
    assert "the power of every machine is given (turbine, propeller), so that none balances" in found.message
