"""Running clearance, run-out of grinding wheels, order of assembly, access of nuts, bridges of carriers: by hand."""

import dataclasses
import math
import re

import pytest

import gearwright as gw
from gearwright.checks import Status
from gearwright.identity import Role
from gearwright.reviews import review_of
from gearwright.sizing.making import (
    Withdrawn,
    bridge_checks,
    bridge_needed,
    bridge_room,
    grinding_checks,
    largest_wheel,
    order_checks,
    running_checks,
    spanner_checks,
    stack_checks,
    withdrawals,
)
from gearwright.spec import edited
from shipped_work import BY_HAND, ball_bearings_of_the_tail, sized, text_of, with_turned_down_tail

TEXT = text_of(BY_HAND)


def replaced(pattern, new):
    """Return the EC120B gearbox with another number."""
    text, count = re.subn(pattern, rf"\g<1>{new}", TEXT, count=1, flags=re.DOTALL)
    assert count == 1
    return gw.size(gw.parse(text))


def shifted(sizing, part, by):
    """Return a sizing with the bodies of a part elsewhere along x [m]."""
    bodies = tuple(
        dataclasses.replace(body, origin=body.origin._replace(x=body.origin.x + by)) if str(body.part) == part else body
        for body in sizing.arrangement.bodies
    )
    return dataclasses.replace(sizing, arrangement=dataclasses.replace(sizing.arrangement, bodies=bodies))


def only(checks, mode=""):
    (check,) = (check for check in checks if mode in check.mode)
    return check


def test_the_take_off_wheel_runs_beside_and_below_the_input_s_front_bearing():
    """It ends at 173 mm, NU 205 of 52 mm begins at 179.5 mm, on axes 79.2 mm apart; 0.5 mm and its bending are asked.

    The input's rear bearing ends at 93.5 mm, 10.5 mm beside the large wheel: 36 mm wide, it begins at 104 mm.
    """
    sizing = sized(BY_HAND)
    check = only(running_checks(sizing))
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == "tail")
    across = 1e-3 / math.cos(math.radians(12.0))
    distance, tip = (67 + 88) / 2.0 * across, 88 / 2.0 * across + 1e-3
    by = dict(shaft.deflections)["tail-take-off.wheel"] + dict(shaft.slopes)["tail-take-off.wheel"] * tip
    assert check.value == pytest.approx(math.hypot(0.0065, distance - tip - 0.026), abs=1e-9)
    assert check.limit == pytest.approx(5e-4 + by, rel=1e-4)
    assert {"tail-take-off.wheel", "input-front"} == set(check.place.split(" and "))


def test_a_body_that_is_moved_until_it_nearly_touches_another_fails():
    sizing = shifted(sized(BY_HAND), "input-rear", 10.2e-3)
    check = only(running_checks(sizing))
    assert check.value == pytest.approx(0.3e-3, abs=1e-9) and check.fails
    assert "move them apart" in check.why


def test_bodies_of_a_first_sizing_that_nearly_touch_are_told_and_not_judged():
    """The motor's wheel stands 15 mm beside the first pinion."""
    check = only(running_checks(shifted(sized("off-set-h1-free"), "motor-stage.wheel.left", -14.8e-3)))
    assert "0.2 mm between first.pinion and motor-stage.wheel.left" in check.why
    assert check.status is Status.NOT_ASSESSED and "angle_deg" in check.why


def test_a_grinding_wheel_stands_as_wide_as_its_chord():
    """A wheel of 50 mm is 20 mm wide of its lowest point where it is 10 mm higher: 20² = 10 (50 − 10)."""
    assert largest_wheel(0.020, 0.010) == pytest.approx(0.050, rel=1e-15)
    assert largest_wheel(0.020, 0.0) == math.inf


def test_the_take_off_pinion_is_ground_beside_a_larger_one():
    """From 140 to 155 mm; tips of 77.587 mm above roots of the take-off pinion."""
    sizing = sized(BY_HAND)
    checks = {str(check.part): check for check in grinding_checks(sizing)}
    check = checks["tail-take-off.pinion"]
    gears = {gear.name: gear for gear in sizing.gears}
    large, small = gears["helical.pinion"], gears["tail-take-off.pinion"]
    tip = large.pitch_diameter / 2.0 + large.module * (1.0 + large.profile_shift + large.tip_alteration)
    root = small.pitch_diameter / 2.0 - small.module * (1.25 - small.profile_shift)
    assert check.value == pytest.approx((0.015**2 + (tip - root) ** 2) / (tip - root), rel=1e-9)
    assert check.place == "beside helical.pinion"
    assert check.status is Status.PASSES


def test_a_pinion_that_is_put_nearer_to_a_larger_one_cannot_be_ground():
    """5 mm beside it: D = (5² + 7.1²)/7.1 = 10.6 mm."""
    sizing = sized(BY_HAND)
    plans = dict(sizing.arrangement.plans)
    places = {**plans["input"].places, "tail-take-off.pinion": 0.154}
    plans["input"] = dataclasses.replace(plans["input"], places=places)
    near = dataclasses.replace(sizing, arrangement=dataclasses.replace(sizing.arrangement, plans=plans))
    check = next(check for check in grinding_checks(near) if str(check.part) == "tail-take-off.pinion")
    assert check.fails and check.value < 0.015 and "more room" in check.why


def test_what_is_slid_on_is_told_from_the_inside_out():
    checks = {str(check.part): check for check in stack_checks(sized(BY_HAND))}
    assert (
        checks["mast"].place == "from the first end bevel.wheel, mast-lower; from the second end mast-upper, main-rotor"
    )
    assert checks["mast"].value == pytest.approx(0.060) and checks["mast"].limit == pytest.approx(0.060)
    assert all(check.status is Status.PASSES for check in checks.values())


def test_a_bearing_smaller_than_a_step_outside_it_does_not_pass():
    """An inner ring of 30 mm does not go over a machine's seat of 32 mm."""
    sizing = sized(BY_HAND)
    thick = [dataclasses.replace(step, diameter=0.032) if step.seat == "arrius-2f" else step
             for step in sizing.built_shafts[0].steps]  # fmt: skip
    shafts = (dataclasses.replace(sizing.built_shafts[0], steps=tuple(thick)), *sizing.built_shafts[1:])
    check = next(stack_checks(dataclasses.replace(sizing, built_shafts=shafts)))
    assert check.fails and (check.value, check.limit) == (pytest.approx(0.030), pytest.approx(0.032))


def test_shafts_as_reported_have_no_seats_for_their_bearings():
    checks = {str(check.part): check for check in stack_checks(sized("ec120b-as-reported"))}
    assert checks["input"].status is Status.NOT_ASSESSED and "input-rear of 30 mm" in checks["input"].why


def test_the_shafts_of_the_ec120b_leave_one_after_another():
    """The bevel wheel leaves away from its apex. The input leaves after the tail's shaft, by its second end: the
    take-off pinion's tips of 35.2 mm and the wheel's of 178.9 mm do not pass each other in 213.7 mm."""
    sizing = sized(BY_HAND)
    out, left = withdrawals(sizing)
    assert not left
    assert Withdrawn("mast", -1) in out and Withdrawn("mast", 1) not in out
    assert [step.shaft for step in out].index("tail") < [step.shaft for step in out].index("input")
    assert Withdrawn("input", 1) in out
    check = only(order_checks(sizing))
    assert check.status is Status.PASSES and check.value == 4.0


def test_a_shaft_with_pinions_on_both_sides_of_a_large_wheel_is_locked_in():
    """Another take-off pinion 80 mm before the first one: neither passes the tips of the wheel between them."""
    sizing = sized(BY_HAND)
    moved = shifted(sizing, "tail-take-off.pinion", -0.080).arrangement.bodies
    more = next(body for body in moved if str(body.part) == "tail-take-off.pinion")
    bodies = (*sizing.arrangement.bodies, more)
    sizing = dataclasses.replace(sizing, arrangement=dataclasses.replace(sizing.arrangement, bodies=bodies))
    assert "input" in withdrawals(sizing)[1]
    check = only(order_checks(sizing))
    assert check.status is Status.NOT_ASSESSED and "housing must open" in check.why


def test_a_socket_spanner_reaches_the_nut_of_the_tail_s_shaft():
    """79.228 mm from the input's axis, less the helical pinion's tips; a nut of 1.5 × 17 mm, a wall of 5 mm."""
    text = ball_bearings_of_the_tail('locates = "both"\n', "")  # by its front bearing, beside which no ring has room
    sizing = with_turned_down_tail(gw.size(gw.parse(text)))
    check = next(check for check in spanner_checks(sizing) if str(check.part) == "tail")
    body = next(body for body in sizing.arrangement.bodies if str(body.part) == "helical.pinion")
    axis = abs(sizing.arrangement.axes["tail"] - sizing.arrangement.axes["input"])
    assert check.value == pytest.approx(axis - body.radius, rel=1e-9)
    assert check.limit == pytest.approx(1.5 * 0.017 / 2.0 + 0.005)
    assert check.status is Status.PASSES and "past helical.pinion" in check.place


def test_bridges_have_what_planets_leave_on_the_pin_circle():
    """Five planets on a circle of r: 2 r sin 36° less a tip circle, less 0.5 mm on both sides."""
    sizing = sized()
    carrier = next(carrier for carrier in sizing.carriers if carrier.stage == "second")
    planet = next(gear for gear in sizing.gears if gear.stage == "second" and gear.role is Role.PLANET)
    tip = planet.pitch_diameter + 2.0 * planet.module * (1.0 + planet.profile_shift + planet.tip_alteration)
    assert bridge_room(carrier, planet) == pytest.approx(
        2.0 * carrier.radius * math.sin(math.radians(36.0)) - tip - 1e-3
    )
    thick = bridge_needed(sizing, carrier, planet)
    moment = carrier.torque / (2.0 * 5 * carrier.radius) * planet.face_width / 2.0
    stress = 6.0 * moment / (0.5 * planet.pitch_diameter * thick**2)
    assert stress == pytest.approx(sizing.design.shaft_material.yield_strength / sizing.design.shafting.safety)
    assert all(check.status is Status.PASSES for check in bridge_checks(sizing))


def test_plates_that_do_not_go_through_their_ring_fail():
    """Tips of the first ring of In-Line H2 lie at 154.55 mm; pins of 18.6 mm on 100.8 mm with 60 mm 170.1 mm."""
    for wall, status in ((40.0, Status.PASSES), (60.0, Status.FAILS)):
        sizing = gw.size(edited(gw.read("in-line-h2"), {"planetaries.first.eye_wall_mm": wall}))
        check = next(check for check in bridge_checks(sizing) if check.mode == "plate through its ring")
        assert (str(check.part), check.status) == ("first.carrier", status)
        assert check.limit == pytest.approx(0.15455 - 1e-3, abs=1e-5)


def test_planets_that_leave_too_little_for_bridges_are_told():
    """Eyes of 15.5 mm bear 212.5 N/mm² on both sides of pins on 275 mm, with K_γ = 1.19 of five planets (level 3)."""
    sizing = sized("twin-engine-helicopter")
    through, check = bridge_checks(sizing)
    carrier = next(carrier for carrier in sizing.carriers if carrier.stage == "main")
    force = math.hypot(1.19 * carrier.torque / (5 * 0.275), carrier.centrifugal_force)
    reach = 0.275 + carrier.pin_diameter / 2.0 + force / (2.0 * 0.0155 * 212.5e6)
    assert through.status is Status.PASSES and through.value == pytest.approx(reach, abs=1e-6)
    assert check.status is Status.NOT_ASSESSED and "one plate must hold the pins" in check.why


def test_a_review_lists_them():
    modes = {check.mode for check in review_of(sized(BY_HAND)).checks}
    assert {"running clearance", "wheel that grinds it", "assembly order", "assembly of its parts"} <= modes


def test_a_bearing_that_is_moved_eight_millimetres_towards_the_wheel_of_another_shaft_is_nearer():
    """input-rear from 80 to 88 mm leaves 2.5 mm of the 10.5 mm."""
    check = only(running_checks(replaced(r"(\[bearings\.input-rear\].*?position_mm = )[\d.]+", "88")))
    assert check.value == pytest.approx(0.0025, abs=1e-6)
