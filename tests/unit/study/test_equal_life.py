"""Designs at equal life: closed, judged by a review of what was written, those that meet everything first."""

import math
from dataclasses import replace
from functools import cache
from types import SimpleNamespace

import pytest

import gearwright as gw
from designs import PAIR
from gearwright.checks import Check
from gearwright.closure import Wishes
from gearwright.identity import Kind, PartId, Role
from gearwright.render.pages.studies import equal_life_page
from gearwright.render.tables.study import equal_life_csv, equal_life_table, measures_table
from gearwright.render.words.study import behind, equal_life_sentences
from gearwright.reviews import Verdict, review
from gearwright.spec import edited, parse
from gearwright.study import equal_life
from gearwright.study.architectures import (
    MOTORS,
    OWN,
    SEPARABLE,
    _shortest,
    closed_designs,
    difference,
    in_bearings,
    outdone,
    with_public_motors,
)
from gearwright.study.measures import measures_of

HOUR = 3600.0
GOOD = edited(parse(PAIR), {"gears.rating": "iso6336"})


@cache
def rows():
    """A pair, the same with a width that does not do, and one whose speeds cannot be had."""
    designs = {
        "narrow": edited(GOOD, {"pairs.stage.module_mm": 2, "pairs.stage.face_width_mm": 12}),
        "impossible": edited(GOOD, {"pairs.stage.pinion_teeth": 20, "pairs.stage.wheel_teeth": 21}),
        "good": GOOD,
    }
    return equal_life(designs, wishes=Wishes(300 * HOUR, lighten=False))


def test_what_meets_everything_comes_first_and_what_cannot_be_last():
    assert [row.design for row in rows()] == ["good", "narrow", "impossible"]
    good, narrow, impossible = rows()
    assert (good.verdict, narrow.verdict) == (str(Verdict.PASSES_SO_FAR), str(Verdict.FAILS))
    assert impossible.verdict == "refused"
    assert impossible.fails
    assert impossible.complete_mass is None


def test_the_written_design_has_the_verdict_of_its_row():
    good, narrow, _ = rows()
    assert str(review(parse(good.file)).verdict) == good.verdict
    assert "stage.pinion pitting" in narrow.fails
    assert good.fails == ""


def test_masses_are_complete_and_stand_in_their_band():
    good, _, _ = rows()
    assert good.lightest < good.complete_mass < good.heaviest
    assert good.shortest_life >= 300 * HOUR
    assert good.with_machines == good.complete_mass + good.machines


def test_a_bearing_that_ends_before_the_gears_is_the_shortest_life():
    """A planet's bearing that lives a tenth of what is asked limits, however long the gears live."""
    bearing = Check(PartId(Kind.BEARING, "first", Role.PLANET), "life", "ISO 281", 30 * HOUR, 300 * HOUR, "life")
    closed, judged = SimpleNamespace(lives=()), SimpleNamespace(checks=(bearing,))
    assert _shortest(closed, judged) == (30 * HOUR, "first.planet life")
    gears = SimpleNamespace(lives=(SimpleNamespace(life=20 * HOUR, governs="first.sun pitting"),))
    assert _shortest(gears, judged) == (20 * HOUR, "first.sun pitting")


def test_what_lasts_beyond_a_million_hours_has_no_life_but_says_what_is_nearest():
    endless = SimpleNamespace(lives=(SimpleNamespace(life=1.2e6 * HOUR, governs="first scuffing"),))
    assert _shortest(endless, SimpleNamespace(checks=())) == (None, "first scuffing")


def test_the_page_has_masses_lives_and_groups_of_every_design():
    page = equal_life_page(rows(), closed_designs(rows()), "Closed for 300 h")
    assert "The lightest that passes as far as assessed: good" in page
    assert "narrow does not meet everything" in page
    assert "impossible does not meet everything" in page
    assert "Complete masses by groups of parts" in page


def test_the_table_as_csv_has_the_masses_that_it_shows():
    good = equal_life_csv(rows()).splitlines()[1]
    assert good.startswith("good,,passes as far as assessed,")
    assert float(good.split(",")[3]) == rows()[0].complete_mass


def test_the_table_has_a_row_for_each():
    shown = equal_life_table(rows(), "Closed")
    assert [row[0].text for row in shown.rows] == ["good", "narrow", "impossible"]


def test_every_shaft_of_a_row_stands_in_bearings_which_are_in_its_mass():
    good = rows()[0]
    written = parse(good.file)
    assert {seat.shaft for seat in written.bearings.values()} == set(written.shafts)
    assert good.without_bearings == ""
    assert gw.complete_mass(gw.size(written)).total == pytest.approx(good.complete_mass, rel=1e-12)
    assert sum(group.total for group in good.groups) == pytest.approx(good.complete_mass, rel=1e-12)


def test_what_finds_no_bearings_is_said_and_is_not_compared():
    """The pinion of the split's branches has a root of 61 mm, and nothing of that bore lives as long."""
    _, _, why = in_bearings(gw.size(gw.at_level(gw.read("face-gear-split-torque"), "preliminary")))
    assert why.startswith("left, right, output (bearings.")
    good = rows()[0]
    bare = replace(good, design="bare", without_bearings=why, with_machines=1.0)
    assert difference(good, bare) is None and difference(bare, good) is None
    said = list(equal_life_sentences((good, bare)))
    assert said[0].startswith("The lightest that passes as far as assessed: good")
    assert said[1].startswith("Not comparable: bare has no bearings on left, right, output")


def test_errors_that_two_gearboxes_share_cancel_in_their_difference():
    good = rows()[0]
    same = difference(good, good)
    assert (same.mass, same.rules, same.probability, same.separable) == (0.0, 0.0, 0.5, False)
    assert same.deviation == same.own == pytest.approx(OWN * math.sqrt(2.0) * good.complete_mass)
    gears, other = next(group for group in good.groups if group.group == "gears"), 7.0
    heavier = tuple(replace(group, deviation=group.deviation + 2.0 * (group is gears)) for group in good.groups)
    more = replace(good, groups=heavier, machines=other, motors=other, with_machines=good.with_machines + other)
    found = difference(good, more)
    assert found.rules == pytest.approx(math.hypot(2.0, MOTORS * other))
    assert found.mass == pytest.approx(other)


@pytest.mark.parametrize(("times", "separable"), [(1.2, False), (1.35, True), (-1.35, True)])
def test_nine_tenths_on_one_side_of_nought_are_separable(times, separable):
    good = rows()[0]
    own = OWN * math.sqrt(2.0) * good.complete_mass
    other = replace(good, with_machines=good.with_machines + times * own)
    found = difference(good, other)
    assert found.probability == pytest.approx(0.5 * (1.0 + math.erf(times / math.sqrt(2.0))))
    assert found.separable is separable is (max(found.probability, 1.0 - found.probability) >= SEPARABLE)


def test_rivals_weigh_by_one_law_of_electric_machines_and_a_mass_that_is_given_stays():
    hybrid = gw.read("in-line-h1")
    (name,) = hybrid.motors
    assert hybrid.motors[name].mass_law == "ndarc"
    public = with_public_motors(hybrid)
    assert public.motors[name].mass_law == "public"
    sizing = gw.size(public)
    assert 45.0 < sizing.motor_mass < 75.0
    assert sizing.machines_mass > sizing.motor_mass + 100.0, "an inverter and cooling of one megawatt beside it"
    given = edited(hybrid, {f"motors.{name}.mass_kg": 60.0})
    assert with_public_motors(given) == given
    conventional = gw.read("in-line")
    assert with_public_motors(conventional) is conventional


def test_what_further_starts_found_widens_the_difference_by_what_a_search_without_end_might_find():
    """θ/r = (x̄ − x₁)/(r − 1): of 100, 104 and 108 kg 2; of 120 and 126 kg 3."""
    good = rows()[0]
    one = replace(good, with_machines=100.0, complete_mass=100.0, starts=(104.0, 100.0, 108.0))
    other = replace(good, with_machines=120.0, complete_mass=120.0, starts=(120.0, 126.0))
    assert (one.search_error, other.search_error, good.search_error) == (2.0, 3.0, None)
    found, unknown = difference(one, other), difference(one, replace(other, starts=()))
    assert (found.mass, found.search) == (20.0, pytest.approx(13.0**0.5))
    assert found.deviation == pytest.approx(math.hypot(unknown.deviation, found.search))
    sure = 0.5 * (1.0 + math.erf((20.0 + 2.0 - 3.0) / found.deviation / math.sqrt(2.0)))
    assert found.probability == pytest.approx(sure)
    assert "of the ±: search 4, rules of mass" in behind(one, other)
    assert "what the search left is not in it" in behind(one, replace(other, starts=()))


def test_what_may_not_fit_is_not_surely_the_lightest():
    """With p of the first fitting, it is first where it is lighter and fits: 0.3 of nearly one."""
    good = rows()[0]
    lighter = replace(good, measures=replace(good.measures, fits=0.3))
    heavier = replace(good, with_machines=good.with_machines + 100.0)
    assert difference(good, heavier).separable
    found = difference(lighter, heavier)
    assert found.probability == pytest.approx(0.3, abs=1e-6) and not found.separable


def test_what_is_no_lighter_wider_longer_or_hotter_than_another_that_passes_is_not_outdone():
    good, narrow, _ = rows()
    wide = replace(good, measures=replace(good.measures, frontal_diameter=1.2 * good.measures.frontal_diameter))
    light = replace(wide, with_machines=good.with_machines - 1.0)
    assert outdone([good, wide, light, narrow]) == [False, True, False, False]
    assert f"frontal diameter is {1.2:.2f} times as large: mass alone does not decide" in behind(good, wide)
    assert "frontal diameter" not in behind(good, replace(good, with_machines=good.with_machines + 1.0))
    shown = measures_table(
        [good, wide, narrow],
    )
    assert [row[-1].text for row in shown.rows] == ["", "by another", ""]
    assert "fits" not in [column.name for column in shown.columns]


def test_measures_are_those_of_the_written_design():
    good = rows()[0]
    sizing = gw.size(parse(good.file))
    assert good.measures == measures_of(sizing)
    assert good.measures.gears == 2 and good.measures.bearings == len(sizing.bearings)
    balance = gw.loss_balance(sizing)
    assert good.measures.efficiency == pytest.approx(balance.efficiency)
    assert good.measures.heat == pytest.approx(balance.lost)
