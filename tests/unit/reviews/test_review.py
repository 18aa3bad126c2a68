"""A review: one list of checks from sizing, motion and flight, one verdict, one worst entry."""

import dataclasses

import pytest

from designs import PAIR
from gearwright import review
from gearwright.checks import BEYOND_SIZING, Status, worst_first
from gearwright.dynamics import Outputs, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import critical_speeds, dynamic_loads
from gearwright.errors import DesignError
from gearwright.mission import bearing_lives, durability
from gearwright.reviews import Review, Verdict, review_of
from gearwright.shipped import shipped_design, shipped_designs, shipped_mission
from gearwright.sizing import size
from gearwright.spec import parse, read, read_mission
from gearwright.spec.record import is_path
from shipped_work import flown, flown_review, ground_review, sized

DESIGN, MISSION = read(shipped_design("in-line-h2")), read_mission(shipped_mission("thesis"))


def named(reviewed, name):
    """Return the one check of a name."""
    (found,) = (check for check in reviewed.checks if check.name == name)
    return found


def test_the_worst_entry_without_a_mission_is_the_peak_that_a_run_of_the_worst_case_shows():
    """A sizing of margin 1.000 fails where its teeth meet the run's peak of the rated case."""
    trace = simulate(assemble(sized(), "rated"), 0.2, outputs=Outputs(start=0.05))
    load = next(load for load in dynamic_loads(sized(), trace) if load.mesh == "second.planet-ring")
    assert sized().worst_margin == pytest.approx(1.0)
    assert ground_review().verdict is Verdict.FAILS
    assert ground_review().worst.name == "second.planet-ring peak bending"
    assert ground_review().worst.margin == pytest.approx(load.bending_margin, rel=1e-9)
    assert ground_review().worst.value == pytest.approx(load.peak_force, rel=1e-9)
    contact = named(ground_review(), "second.planet-ring peak contact")
    assert contact.margin == pytest.approx(load.contact_margin, rel=1e-9)


def test_an_excited_resonance_within_15_percent_fails_by_its_distance():
    near = [c for case in critical_speeds(sized()) for c in case.critical if c.excited and c.in_resonance]
    failing = [check for check in ground_review().failing if check.mode.startswith("resonance of ")]
    orders = {critical.order.replace("×", "x") for critical in near}
    assert {check.mode for check in failing} == {f"resonance of {order}" for order in orders}
    found = named(ground_review(), "gearbox resonance of second mesh x 2")
    assert found.value == abs(near[0].separation_margin)
    assert found.reserve is None


def test_a_planets_bearing_that_lives_207_hours_is_worse_than_the_peak():
    """(207/5000)^(3/10) = 0.385, a factor on its load as 0.72 is one on the teeth's."""
    row = next(row for row in bearing_lives(flown()).rows if row.seat == "first.planet")
    found = named(flown_review(), "first.planet bearing life")
    assert flown_review().worst == found
    assert found.margin == pytest.approx((row.life / 5000.0) ** 0.3)
    assert found.margin < ground_review().worst.margin


def test_a_bearing_that_is_wider_than_its_planet_fails():
    """NU 2308 has 33 mm, the gear 16.8 mm."""
    room = named(flown_review(), "first.planet room for its bearing")
    assert (room.status, room.reserve) == (Status.FAILS, None)
    assert (room.value, room.limit) == (pytest.approx(0.033), pytest.approx(0.0168, rel=1e-3))


def test_a_bearing_that_a_design_names_for_a_planet_is_judged_by_sizing():
    text = shipped_design("in-line").read_text(encoding="utf-8")
    text += '\n[planetaries.second.planet_bearing]\ndesignation = "NU 2205"\nside_by_side = {}\n'
    one, two = (size(parse(text.format(count))).checks for count in (1, 2))
    room = [next(check for check in checks if check.mode == "room for its bearing") for checks in (one, two)]
    assert [check.value for check in room] == [pytest.approx(0.018), pytest.approx(0.036)]
    assert [check.fails for check in room] == [False, True]


def test_a_review_says_what_it_did_not_look_at():
    reasons = {check.name: check.why for check in ground_review().open}
    assert "no mission is given" in reasons["gearbox lives of gears and bearings, heat, charge"]
    assert "no [bearings]" in reasons["input bearings and joints"]
    assert "Lewis and Hertz" in reasons["first tooth fatigue and scuffing"]
    assert "gearbox lives of gears and bearings, heat, charge" not in {check.name for check in flown_review().open}
    face = review_of(size(read(shipped_design("face-gear-split-torque"))))
    assert "no standard rates them" in named(face, "first rating of face gears").why


def test_checks_come_worst_first_and_every_mode_beyond_sizing_is_known_to_sizing():
    """A waiver of what only a run or a flight judges must not be refused by a sizing."""
    assert flown_review().checks == worst_first(flown_review().checks)
    sizing_modes = {check.mode for check in sized().checks}
    beyond = {check.mode for check in flown_review().checks if check.ratio is not None} - sizing_modes
    assert all(mode.startswith(BEYOND_SIZING) for mode in beyond)


@pytest.mark.parametrize("name", shipped_designs())
def test_every_check_of_a_shipped_design_has_a_name_that_a_waiver_can_say(name):
    reviewed = review(read(shipped_design(name)))
    assert all(is_path(check.name) and check.clause for check in reviewed.checks if check.ratio is not None)
    assert reviewed.worst is not None


@pytest.mark.parametrize("status", list(Verdict))
def test_the_verdict_is_no_better_than_the_list(status):
    passing = tuple(check for check in ground_review().checks if check.status is Status.PASSES)
    checks = {
        Verdict.FAILS: ground_review().checks,
        Verdict.PASSES_SO_FAR: passing + ground_review().open,
        Verdict.PASSES: passing,
    }
    assert dataclasses.replace(ground_review(), checks=checks[status]).verdict is status


def test_a_life_that_is_asked_for_a_flight_is_the_limit_of_its_gears():
    longer = review_of(sized(), flown(), durability(flown()), life=2.0 * DESIGN.service.life)
    one, two = (named(reviewed, "first.sun pitting life") for reviewed in (flown_review(), longer))
    assert two.limit == 2.0 * one.limit == 2.0 * DESIGN.service.life


def test_the_public_verb_is_the_same_and_a_mission_that_does_not_fit_is_refused():
    assert review(DESIGN) == ground_review()
    assert isinstance(review(parse(PAIR)), Review)
    with pytest.raises(DesignError, match="the design has no motor"):
        review(read(shipped_design("ec120b")), MISSION)
    with pytest.raises(DesignError, match=r"design: .*; give a Design, from gw\.read"):
        review("in-line-h2")


def test_planets_without_a_named_bearing_are_open_until_a_flight_rates_one_for_them():
    """Thesis mission: a bearing is chosen for them, and its life is a check."""
    bare = {str(check.part) for check in ground_review().open if check.mode == "bearing of the planets"}
    assert bare == {"first.planet", "second.planet"}
    assert not any(check.mode == "bearing of the planets" for check in flown_review().checks)
