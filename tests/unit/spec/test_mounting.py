"""What is wrong with bearings, joints and service in a design file is told with its path and what would do."""

import pytest

from designs import changed, problems
from gearwright.spec import parse
from mounted_designs import PAIR, given

WRONG = {
    "a shaft that is not there": (("[bearings.1a]\nshaft = \"input\"", "[bearings.1a]\nshaft = \"inputt\""),
                                  "bearings.1a.shaft", "there is no shaft 'inputt'; did you mean input?"),
    "one bearing": (("[bearings.1b]\nshaft = \"input\"", "[bearings.1b]\nshaft = \"output\""),
                    "bearings.1a", "1 radial bearing on 'input': it would fall; add another"),
    "three radial bearings": (("radial = false\n", ""), "bearings.1b", "statics knows two; write radial = false at 1x"),
    "bearings in one place": (("position_mm = 15\n", "position_mm = 40\n"), "bearings.1a.position_mm",
                              "40 mm, where 1x stands already"),
    "outside the shaft": (("position_mm = 138", "position_mm = 500"), "bearings.1b.position_mm",
                          "500 mm is outside the shaft; allowed: 0 to 160 mm"),
    "an NU bearing that locates": (("[bearings.1a]\n", "[bearings.1a]\nlocates = \"first\"\n"), "bearings.1a.locates",
                                   "an NU bearing bears no axial force"),
    "a taper bearing that locates both ways": (("locates = \"second\"", "locates = \"both\""), "bearings.2b.locates",
                                               "a taper bearing locates one way"),
    "a taper bearing alone": (("kind = \"taper\"\nlocates = \"first\"", "kind = \"deep-groove\""),
                              "bearings.2b.locates", 'add another that locates = "first"'),
    "two that locate the same way": (("[bearings.1a]\n",
                                      "[bearings.1a]\nkind = \"deep-groove\"\nlocates = \"first\"\n"),
                                     "bearings.1a.locates", "1x locates the shaft towards its first end already"),
    "a bearing that bears nothing": (("locates = \"both\"\n", ""), "bearings.1x", "it bears nothing"),
    "a designation that is not there": (("[bearings.1a]\n", "[bearings.1a]\ndesignation = \"NU 2122\"\n"),
                                        "bearings.1a.designation", "not in the catalogue; did you mean NU 2"),
    "a designation like no other": (("[bearings.1a]\n", "[bearings.1a]\ndesignation = \"quite another\"\n"),
                                    "bearings.1a.designation", "not in the catalogue; such are 60"),
    "a designation of another kind": (("[bearings.1a]\n", "[bearings.1a]\ndesignation = \"6209\"\n"),
                                      "bearings.1a.kind", "write kind = 'deep-groove'"),
    "a bore that no bearing has": (("[bearings.1a]\n", "[bearings.1a]\nbore_mm = 43\n"), "bearings.1a.bore_mm",
                                   "no cylindrical bearing has 43 mm; the nearest has 45 mm"),
    "two different bores": (("[bearings.1a]\n", "[bearings.1a]\nbore_mm = 40\ndesignation = \"NU 209\"\n"),
                            "bearings.1a.bore_mm", "40 mm, but NU 209 has 45 mm"),
    "a size that has no room": (("[bearings.1a]\n",
                                 "[bearings.1a]\nlargest_outer_diameter_mm = 80\ndesignation = \"NU 209\"\n"),
                                "bearings.1a.largest_outer_diameter_mm", "80 mm, but NU 209 has 85 mm"),
    "a rating of no bearing": (("[bearings.1a]\n", "[bearings.1a]\ndynamic_rating_kn = 80\n"), "bearings.1a",
                               "a maker's rating belongs to one bearing"),
    "bearings given twice": (("[layout.input]\n", "[layout.input]\nfirst_bearing_mm = 20\n"),
                             "layout.input.first_bearing_mm", "its bearings stand in [bearings] already"),
    "a joint of nothing": (("[joints.\"helical.wheel\"]", "[joints.\"helical.whel\"]"), "joints.helical.whel",
                           "did you mean helical.wheel?; a name with a point stands in quotes"),
    "a key longer than its hub": (("kind = \"spline\"", "kind = \"key\"\nlength_mm = 60\nhub_length_mm = 45"),
                                  "joints.helical.wheel.length_mm", "longer than its hub; allowed: up to 45 mm"),
    "a module that DIN 5480 has not": (("kind = \"spline\"", "kind = \"spline\"\nmodule_mm = 2.2"),
                                       "joints.helical.wheel.module_mm", "the nearest is 2 mm"),
    "a field that says nothing": (("kind = \"spline\"", "kind = \"spline\"\nfriction = 0.2"),
                                  "joints.helical.wheel.friction", "only about press-fit; leave it out"),
    "a machine without a hub": (("[joints.\"helical.wheel\"]\n",
                                 "[joints.rotor]\nkind = \"spline\"\n[joints.\"helical.wheel\"]\n"),
                                "joints.rotor.hub_length_mm", "is required for a machine"),
    "shares that are not all": (("[service]\n", "[service]\nshares = { rated = 0.7 }\n"), "service.shares",
                                "their sum is 0.7; give positive shares with sum 1"),
    "a share of no case": (("[service]\n", "[service]\nshares = { ratd = 1.0 }\n"), "service.shares.ratd",
                           "there is no case 'ratd'; did you mean rated?"),
    "a mean load beside shares": (("[service]\n", "[service]\nmean_load = 0.8\nshares = { rated = 1.0 }\n"),
                                  "service.mean_load", "it follows from service.shares"),
    "a shaft that is all bore": (("[layout.output]\n", "[layout.output]\nbore_ratio = 0.93\n"),
                                 "layout.output.bore_ratio", "give 0.9 or less"),
    "a reliability without a number": (("[service]\n", "[shafting]\nreliability = 0.97\n[service]\n"),
                                       "shafting.reliability", "0.97 given; allowed: 0.5, 0.9, 0.95, 0.99, 0.999"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_a_mistake_is_told_with_its_place_and_what_would_do(case):
    (old, new), path, words = WRONG[case]
    found = problems(changed(PAIR, old, new))
    assert any(each.path == path and words in each.message for each in found), found


def test_all_mistakes_are_told_at_once():
    text = changed(given(PAIR, "1a", 'designation = "NU 2122"'), 'kind = "spline"', 'kind = "spline"\nmodule_mm = 2.2')
    assert len(problems(changed(text, "[service]\n", "[service]\nshares = { rated = 0.7 }\n"))) == 3


def test_a_sound_design_has_no_problems():
    assert parse(PAIR).bearings["1x"].locates == "both"
