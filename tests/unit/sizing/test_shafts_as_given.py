"""A shaft that is taken as given: nothing on it grows, and what does not fit is a check, not a refusal."""

import math
from itertools import pairwise

import pytest

from designs import changed, problems
from mounted_designs import PAIR, given, sized

TAKEN = changed(
    given(given(PAIR, "2a", 'designation = "33014"'), "2b", 'designation = "33014"'),
    "[layout.output]\n",
    "[layout.output]\ndiameter_mm = 70\nas_given = true\n",
)
"""The pair with a shaft of 70 mm in bearings of 70 mm."""
KEYED = changed(TAKEN, 'kind = "spline"', 'kind = "key"\nlength_mm = 18')


def check(sizing, part, words):
    """Return the one check of a part that begins so."""
    (found,) = (each for each in sizing.checks if str(each.part) == part and each.what.startswith(words))
    return found


def test_a_given_shaft_is_a_cylinder_and_its_bearings_fit():
    """70 mm from end to end; every fit has a margin of 1 or more, and nothing else of the design moves."""
    sizing = sized(TAKEN)
    assert {step.diameter for step in sizing.built_shafts[1].steps} == {0.070}
    assert sizing.shafts[1].diameter == 0.070
    assert check(sizing, "2a", "shaft in its bore").margin == 1.0
    fits = [each for each in sizing.checks if str(each.part) == "output" and each.mode == "room"]
    assert len(fits) == 4
    assert all(each.margin > 1.0 for each in fits)
    assert sizing.built_shafts[0] == sized(PAIR).built_shafts[0]


def test_a_weak_shaft_stays_as_it_is():
    """Half the diameter, an eighth of the yield safety, 16 times the slope; what is below its limit is shown."""
    sizing = sized(changed(TAKEN, "diameter_mm = 70", "diameter_mm = 35"))
    thick, thin = sized(TAKEN).built_shafts[1], sizing.built_shafts[1]
    assert {step.diameter for step in thin.steps} == {0.035}
    seats = [next(each for each in shaft.sections if each.place == "seat of 2b") for shaft in (thick, thin)]
    assert seats[0].yield_safety / seats[1].yield_safety == pytest.approx(8.0, rel=1e-9)
    assert dict(thin.slopes)["2b"] / dict(thick.slopes)["2b"] == pytest.approx(16.0, rel=1e-9)
    assert sizing.worst_margin <= check(sizing, "output", "fatigue n_f").margin < 1.0


@pytest.mark.parametrize(("diameter", "margin"), [(80, 70 / 80), (60, 60 / 70)])
def test_a_seat_that_is_not_the_bore_fails_thicker_or_thinner(diameter, margin):
    sizing = sized(changed(TAKEN, "diameter_mm = 70", f"diameter_mm = {diameter}"))
    assert check(sizing, "2b", "shaft in its bore").margin == pytest.approx(margin)


def test_a_bearing_that_is_left_open_is_chosen_for_the_shaft():
    sizing = sized(changed(PAIR, "[layout.output]\n", "[layout.output]\ndiameter_mm = 75\nas_given = true\n"))
    assert [each.inner_diameter for each in sizing.bearings if each.shaft == "output"] == [0.075, 0.075]
    short = changed(PAIR, "[layout.output]\n", "[layout.output]\ndiameter_mm = 41\nas_given = true\n")
    assert any("with a bore of 41 mm" in each.message for each in problems(short, sized=True))


def test_a_hub_with_a_seat_of_its_own_keeps_it():
    """90 mm under the wheel, with a notch at each shoulder."""
    sizing = sized(changed(TAKEN, 'kind = "spline"', 'kind = "spline"\ndiameter_mm = 90'))
    seats = {step.seat: step.diameter for step in sizing.built_shafts[1].steps}
    assert seats["helical.wheel"] == 0.090
    assert sum(each.place.startswith("shoulder") for each in sizing.built_shafts[1].sections) == 2


def test_a_bore_that_follows_the_ratio_is_that_of_the_cylinder():
    sizing = sized(changed(TAKEN, "as_given = true\n", "as_given = true\nbore_ratio = 0.5\n"))
    assert sizing.built_shafts[1].bore == pytest.approx(0.035)


CROWDED = {
    "a gear in a bearing": ('"helical.wheel" = { position_mm = 90 }',
                            '"helical.wheel" = { position_mm = 50 }', "room, between 2a and helical.wheel"),
    "a gear around a bearing": ('"helical.wheel" = { position_mm = 90 }',
                                '"helical.wheel" = { position_mm = 170.1 }', "room, between 2b and helical.wheel"),
    "a bearing over the end": ("position_mm = 32", "position_mm = 4", "room, between first end and 2a"),
}  # fmt: skip


@pytest.mark.parametrize("case", CROWDED)
def test_parts_that_stand_into_each_other_or_over_an_end_are_a_check(case):
    """Distance over half of both widths; steps still cover the shaft once."""
    old, new, words = CROWDED[case]
    sizing = sized(changed(TAKEN, old, new))
    steps = sizing.built_shafts[1].steps
    assert steps[0].start == 0.0
    assert all(one.end == pytest.approx(other.start) for one, other in pairwise(steps))
    assert all(step.end > step.start for step in steps)
    assert check(sizing, "output", words).margin < 1.0


def test_the_heaviest_section_is_judged_where_a_hub_is_cut():
    """The key's moment is the largest under the gear, though its hub loses half of what it shares with a bearing."""
    text = changed(KEYED, '"helical.wheel" = { position_mm = 90 }', '"helical.wheel" = { position_mm = 55 }')
    sizing = sized(text)
    keyed = [each for each in sizing.built_shafts[1].sections if each.place == "key at helical.wheel"]
    assert any(each.position == pytest.approx(0.055) for each in keyed)
    moments = [math.hypot(*pair) for pair in zip(*sizing.shafts[1].diagram.bending, strict=True)]
    assert max(each.bending_moment for each in keyed) == pytest.approx(max(moments), rel=1e-6)


def test_a_key_is_checked_against_its_standard_its_hub_and_its_width():
    """20 x 12 on 70 mm: 56 mm at least; 18 mm with round ends leave no flank, with square ones all of it bears."""
    part = "helical.wheel on output"
    round_, square = sized(KEYED), sized(changed(KEYED, "length_mm = 18", 'length_mm = 18\nform = "B"'))
    for sizing in (round_, square):
        lengths = {each.mode: each.margin for each in sizing.checks if str(each.part) == part and "key" in each.mode}
        assert lengths["key length"] == pytest.approx(18.0 / 56.0)
        assert lengths["key length over its width"] == pytest.approx(18.0 / 20.0)
        assert lengths["key in its hub"] > 1.0
    assert check(round_, part, "key pressure").value == math.inf
    assert check(round_, part, "key pressure").margin == 0.0
    torque = next(each.torque for each in square.joints if each.part == "helical.wheel")
    expected = 2.0 * torque / (0.070 * (12.0 - 7.5) * 1e-3 * 0.018)
    assert check(square, part, "key pressure").value == pytest.approx(expected)


def test_a_key_with_round_ends_that_is_too_short_is_refused_where_the_shaft_is_built():
    text = changed(PAIR, 'kind = "spline"', 'kind = "key"\nlength_mm = 8')
    found = problems(text, sized=True)
    assert any(each.path == "joints.helical.wheel.length" and 'form = "B"' in each.message for each in found), found


def test_a_shaft_thicker_than_its_pinion_is_a_check():
    """The pinion's root circle has 62.77 mm: 70 mm through it, of one piece or with a key (t_2 = 4.9 mm)."""
    text = changed(PAIR, "[layout.input]\n", "[layout.input]\ndiameter_mm = 70\nas_given = true\n")
    text += '[overrides]\n"helical.module_mm" = 2.5\n"helical.face_width_mm" = 45\n'
    for name in ("1x", "1a", "1b"):
        text = given(text, name, f'designation = "{"QJ" if name == "1x" else "NU"} 214"')
    root = 2.5e-3 * (27.0 / math.cos(math.radians(12.0)) - 2.5)
    part, words = "helical.pinion on input", "shaft"
    assert check(sized(text), part, words).margin == pytest.approx(root / 0.070)
    keyed = sized(changed(text, 'kind = "integral"', 'kind = "key"\nlength_mm = 40'))
    assert check(keyed, part, words).margin == pytest.approx(root / 0.0798)
    assert not any(str(each.part) == part and each.mode.startswith("rim") for each in keyed.checks)


WRONG = {
    "no diameter": (("[layout.output]\n", "[layout.output]\nas_given = true\n"), "layout.output.diameter_mm",
                    "is required with as_given = true"),
    "a form of no key": (('kind = "spline"', 'kind = "spline"\nform = "B"'), "joints.helical.wheel.form",
                         "only about key; leave it out"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_a_given_shaft_lacks_is_told(case):
    (old, new), path, words = WRONG[case]
    found = problems(changed(PAIR, old, new))
    assert any(each.path == path and words in each.message for each in found), found


def test_a_given_shaft_without_bearings_is_told_that_it_is_one_in_any_case():
    text = PAIR.split("[bearings.1x]")[0]
    found = problems(changed(text, "[layout.output]\n", "[layout.output]\ndiameter_mm = 70\nas_given = true\n"))
    assert any(each.path == "layout.output.as_given" and "no bearings" in each.message for each in found), found
