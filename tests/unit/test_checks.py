"""One kind of check: its reserve, its status, its place in the list, and the labels of parts."""

import math

import pytest

from gearwright.checks import Check, Status, not_assessed, worst, worst_first
from gearwright.identity import Kind, PartId, Role, Row

SUN = PartId(Kind.GEAR, "first", Role.SUN)


def check(value, limit, **more):
    return Check(more.pop("part", SUN), "pitting", "ISO 6336-2", value, limit, **more)


@pytest.mark.parametrize(
    ("part", "label"),
    [
        (SUN, "first.sun"),
        (PartId(Kind.MESH, "first", Row.SUN_PLANET), "first.sun-planet"),
        (PartId(Kind.MESH, "first", Row.SUN_PLANET, number=3), "first.sun-planet-3"),
        (PartId(Kind.GEAR, "first", Role.PLANET, number=1), "first.planet-1"),
        (PartId(Kind.MESH, "off", Row.PAIR), "off"),
        (PartId(Kind.MESH, "off", Row.PAIR, "left"), "off.left"),
        (PartId(Kind.GEAR, "off", Role.WHEEL, "left"), "off.wheel.left"),
        (PartId(Kind.CARRIER, "first"), "first.carrier"),
        (PartId(Kind.JOINT, "helical.pinion", branch="input"), "helical.pinion on input"),
        (PartId(Kind.SHAFT, "mast"), "mast"),
    ],
)
def test_a_label_is_made_from_the_fields(part, label):
    assert str(part) == label


def test_a_safety_is_its_own_reserve_and_a_stress_counts_the_other_way_round():
    assert check(1.2, 1.0).reserve == pytest.approx(1.2)
    assert check(400e6, 500e6, dimension="stress", at_most=True).reserve == pytest.approx(1.25)


def test_half_the_life_of_a_ball_bearing_is_a_reserve_of_the_cube_root_of_a_half():
    life = check(500.0, 1000.0, dimension="life", exponent=3.0)
    assert life.reserve == pytest.approx(0.5 ** (1 / 3))
    assert life.ratio == pytest.approx(0.5)
    assert life.status is Status.FAILS


def test_room_fails_without_a_reserve():
    room = check(0.033, 0.017, dimension="length", at_most=True, exponent=None)
    assert room.reserve is None
    assert room.fails


def test_a_value_that_is_its_limit_but_for_rounding_passes():
    assert check(1.0 - 1e-12, 1.0).status is Status.PASSES
    assert check(1.0 - 1e-6, 1.0).status is Status.FAILS


def test_what_carries_nothing_has_an_infinite_reserve():
    assert check(math.inf, 1.0).reserve == math.inf
    assert check(0.0, 5.0, at_most=True).reserve == math.inf


def test_failures_stand_first_then_waived_ones_then_reserves_then_room_then_what_is_open():
    fails, worse = check(0.9, 1.0), check(0.5, 1.0)
    waived = check(0.1, 1.0, waiver="replaced every 50 h")
    passes, room = check(1.1, 1.0), check(1.0, 2.0, at_most=True, exponent=None)
    open_ = not_assessed(SUN, "scuffing", "ISO/TS 6336-21", "no oil is given")
    listed = worst_first([open_, room, passes, waived, fails, worse])
    assert listed == (worse, fails, waived, passes, room, open_)
    assert worst(listed) is worse
    assert worst([open_, waived, room, passes]) is passes
    assert worst([open_]) is None


def test_a_failure_without_reserve_is_worse_than_a_reserve_that_passes():
    near_resonance = check(0.011, 0.15, exponent=None)
    assert worst([check(1.0, 1.0), near_resonance]) is near_resonance


def test_a_distance_does_not_stand_among_factors_on_loads():
    """7 % of the distance that is asked are no factor of 0.07 on the loads: the stress that fails is told first."""
    near_resonance, weak = check(0.011, 0.15, exponent=None), check(0.97, 1.0)
    assert worst_first([near_resonance, weak]) == (weak, near_resonance)
    assert (near_resonance.margin, weak.margin) == (pytest.approx(0.011 / 0.15), 0.97)


def test_a_check_is_named_by_part_and_mode_for_waivers():
    fatigue = Check(PartId(Kind.SHAFT, "mast"), "fatigue", "DIN 743", 1.2, 1.5, symbol="n_f", place="bearing 1a")
    assert fatigue.name == "mast fatigue"
    assert fatigue.what == "fatigue n_f, bearing 1a"
