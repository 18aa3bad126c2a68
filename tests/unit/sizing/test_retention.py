"""What pulls at the ends of built shafts, and whether a ring holds it; bearings that are moved are seen."""

import math
import re
from types import SimpleNamespace

import pytest

import gearwright as gw
from gearwright.checks import Status
from gearwright.identity import Role
from gearwright.reviews import review_of
from gearwright.shipped import shipped_design
from gearwright.sizing.shaft_results import ShaftStep
from gearwright.sizing.shafts import holding_checks, retention_checks, retentions
from gearwright.sizing.shafts.ends import seal_checks
from gearwright.sizing.shafts.retention import Seated, _retention, _seated, _thrust, ends
from gearwright.spec.design import LOCATES
from shipped_work import BY_HAND, ball_bearings_of_the_tail, sized, text_of, with_turned_down_tail

TEXT = text_of(BY_HAND)


def moved(bearing, by):
    """Return the EC120B gearbox with one bearing elsewhere [mm]."""
    place = re.search(rf"(\[bearings\.{bearing}\].*?position_mm = )([\d.]+)", TEXT, re.DOTALL)
    return TEXT[: place.start(2)] + str(float(place.group(2)) + by) + TEXT[place.end(2) :]


def checks_of(sizing):
    return {str(check.part): check for check in retention_checks(sizing)}


def test_a_ring_beside_the_four_point_bearing_of_the_input_holds_its_thrust():
    """DIN 471 - 25 × 1.2: d_2 = 23.9 mm bears 200/1.2 N/mm² on its collar."""
    sizing = sized(BY_HAND)
    check = checks_of(sizing)["input"]
    bearing = next(bearing for bearing in sizing.bearings if bearing.name == "input-axial")
    assert check.status is Status.PASSES
    assert check.value == pytest.approx(math.pi / 4.0 * (25.0**2 - 23.9**2) * 200.0 / 1.2, rel=1e-12)
    assert check.limit == pytest.approx(sizing.design.service.application_factor * bearing.axial, rel=1e-12)
    assert "DIN 471 - 25 x 1.2 beside input-axial" in check.place


def test_an_end_plate_holds_a_bearing_that_has_no_room_for_a_groove():
    """QJ 313 stands 3.5 mm from the end of its shaft, a groove takes 7.15; M20 of 8.8: 0.7 · 600 N/mm² · 245 mm²."""
    check = checks_of(sized(BY_HAND))["intermediate"]
    assert check.status is Status.PASSES and check.place == "end plate with M20 beside intermediate-axial"
    assert check.value == pytest.approx(0.7 * 600.0 * 244.8, rel=1e-3)
    assert check.limit == pytest.approx(33550.0, rel=1e-3)


UNHELD = ball_bearings_of_the_tail('locates = "both"\n', "")
"""The EC120B gearbox whose tail shaft is located by its front bearing, beside which it is thinner at once."""


@pytest.fixture(scope="module")
def unheld():
    return with_turned_down_tail(gw.size(gw.parse(UNHELD)))


def test_a_seat_goes_on_for_a_ring_where_the_end_of_its_shaft_is_thinner():
    """DIN 471 - 17 x 1 takes m + n = 1.1 + 1.2 mm; a seal of 17 mm runs on the same seat beside it."""
    sizing = gw.size(gw.parse(UNHELD))
    tail = next(shaft for shaft in sizing.built_shafts if shaft.name == "tail")
    end, beside, seat = tail.steps[:3]
    assert (end.diameter, beside.diameter, seat.diameter, seat.seat) == (0.010, 0.017, 0.017, "tail-front")
    held = checks_of(sizing)["tail"]
    assert held.status is Status.PASSES and held.place == "DIN 471 - 17 x 1 beside tail-front"
    assert not [check for check in (*holding_checks(sizing), *seal_checks(sizing)) if check.fails]


def test_halves_of_a_double_helical_gear_push_nothing_along_their_shaft():
    pairs = {"stage": SimpleNamespace(kind="cylindrical", halves=2)}
    gear, mesh = SimpleNamespace(stage="stage", role=Role.WHEEL), SimpleNamespace(axial_force=500.0, radial_force=100.0)
    assert _thrust(SimpleNamespace(design=SimpleNamespace(pairs=pairs)), gear, mesh) == 0.0
    pairs["stage"].halves = 1
    assert _thrust(SimpleNamespace(design=SimpleNamespace(pairs=pairs)), gear, mesh) == 500.0


def test_where_nothing_holds_what_pulls_the_check_fails_and_says_what_would_help(unheld):
    """Beyond the front bearing of the tail's shaft it goes on thinner to the oil pump."""
    check = checks_of(unheld)["tail"]
    assert check.status is Status.FAILS and check.value == 0.0 and check.limit > 500.0
    assert "mm beside it, and there are 0 mm" in check.why and "let another bearing locate the shaft" in check.why
    (rings,) = (check for check in holding_checks(unheld) if str(check.part) == "tail-front" and "rings" in check.mode)
    assert rings.status is Status.FAILS and (rings.value, rings.limit) == (3.0, 4.0)
    assert rings.why == "nothing holds its inner ring towards the first end"


def test_an_end_plate_needs_a_centre_and_enough_preload():
    (held,) = (held for held in retentions(sized(BY_HAND)) if held.shaft == "intermediate")
    assert held.holds and held.has_plate
    assert not held._replace(hole=None).holds
    assert not held._replace(force=103e3).holds


def test_a_nut_holds_what_a_ring_cannot_where_it_has_room():
    """KM 13 on the seat of 65 mm: washer 1.5 mm, nut 12 mm, a turn of 2 mm; a ring would hold 39 kN."""
    (held,) = (held for held in retentions(sized(BY_HAND)) if held.shaft == "intermediate")
    roomy = held._replace(room=0.020, force=80e3)
    assert not roomy.has_ring and roomy.has_nut and not roomy.has_plate
    assert roomy.nut.designation == "KM 13 with MB 13" and roomy.nut.room == pytest.approx(15.5e-3)
    by_hand = 0.5 * 0.6 * 200.0 * 0.875 * math.pi * 65.0 * (12.0 - 2.0)
    assert roomy.nut.capacity == pytest.approx(by_hand) and by_hand > 80e3
    assert not roomy._replace(room=0.0154).has_nut and not roomy._replace(force=by_hand + 1.0).has_nut
    assert roomy._replace(force=30e3).has_ring and not roomy._replace(force=30e3).has_nut


def test_a_shoulder_holds_what_pushes_against_it():
    """The upper taper bearing of the mast takes thrust towards the second end, against the collar below it."""
    assert all((held.shaft, held.way) != ("mast", 1) for held in retentions(sized(BY_HAND)))


def test_a_seat_beside_which_the_shaft_is_thinner_has_no_room(unheld):
    held = next(held for held in retentions(unheld) if held.shaft == "tail")
    assert held.diameter == pytest.approx(0.017) and held.room == 0.0


def test_a_review_lists_what_holds_shafts():
    modes = {check.mode for check in review_of(sized(BY_HAND)).checks}
    assert {"axial retention at its first end", "axial retention of its rings", "axial retention by its cover"} <= modes
    assert "fatigue at its groove of DIN 471 - 25 x 1.2" in modes


def test_a_bearing_that_is_moved_by_eight_millimetres_into_a_wheel_fails():
    checks = gw.size(gw.parse(moved("mast-lower", 8.0))).checks
    assert [check.name for check in checks if check.fails] == ["mast room on its shaft"]


@pytest.mark.parametrize(("bearing", "by"), [("input-axial", 12.0), ("intermediate-rear", -8.0), ("input-front", 8.0)])
def test_a_bearing_that_is_moved_into_another_or_over_the_end_is_refused(bearing, by):
    with pytest.raises(gw.DesignError, match=r"stands .* mm into"):
        gw.size(gw.parse(moved(bearing, by)))


STEPS = ((0.0, 20.0, 25.0), (20.0, 30.0, 30.0), (30.0, 40.0, 30.0), (40.0, 90.0, 45.0), (90.0, 120.0, 25.0))
"""A shaft: start, end, diameter [mm]; its core is the fourth."""


def shaft(steps):
    return SimpleNamespace(
        name="shaft", steps=[ShaftStep(start / 1e3, end / 1e3, width / 1e3) for start, end, width in steps]
    )


def mirrored(steps):
    """Return a shaft turned end for end, 120 mm long."""
    return [(120.0 - end, 120.0 - start, width) for start, end, width in reversed(steps)]


@pytest.mark.parametrize(
    ("seat", "machine", "room", "diameter"),
    [
        ((30.0, 40.0), None, 10.0, 30.0),  # as far as the shaft is 30 mm thick
        ((30.0, 40.0), (22.0, 26.0), 4.0, 30.0),  # as far as the hub of a machine
        ((30.0, 40.0), (5.0, 15.0), 10.0, 30.0),  # a hub beyond the shoulder takes nothing
        ((20.0, 40.0), None, 0.0, 30.0),  # the shaft is thinner beyond
        ((5.0, 20.0), None, 5.0, 25.0),  # as far as the end of the shaft
    ],
)
def test_room_beside_a_seat_ends_where_the_shaft_changes_a_hub_begins_or_the_shaft_ends(seat, machine, room, diameter):
    """Towards the first end, and towards the second of the same shaft turned end for end."""
    part = Seated("bearing", seat[0] / 1e3, seat[1] / 1e3, (800.0, 0.0))
    stack = [
        part,
        *([Seated("hub", machine[0] / 1e3, machine[1] / 1e3, (0.0, 0.0), is_machine=True)] if machine else []),
    ]
    turned = [part._replace(start=0.12 - part.end, end=0.12 - part.start) for part in stack]
    for way, steps, parts in ((-1, STEPS, stack), (1, mirrored(STEPS), turned)):
        held = _retention(shaft(steps), way, parts[0], parts, force=800.0)
        assert (held.room, held.diameter) == (pytest.approx(room / 1e3, abs=1e-9), pytest.approx(diameter / 1e3))
        assert (held.shaft, held.way, held.outermost, held.force) == ("shaft", way, "bearing", 800.0)
        assert held.place == pytest.approx((0.0 if way < 0 else 0.12) - way * seat[0] / 1e3)
        assert held.ring is not None and held.ring.shaft == pytest.approx(diameter / 1e3)


def test_what_pulls_at_bearings_and_gears_by_hand():
    """K_A 1.5 times 200 N at bearings, by the way that they locate; at a gear the larger of two thrusts."""
    located = {"fixed": "both", "first": "first", "second": "second", "free": "none"}
    assert set(located.values()) <= set(LOCATES)
    bearings = [
        SimpleNamespace(name=name, shaft="shaft", axial=-200.0, position=0.05, width=0.02) for name in located
    ] + [SimpleNamespace(name="elsewhere", shaft="other", axial=900.0, position=0.0, width=0.01)]
    gear = SimpleNamespace(
        name="stage.wheel", stage="stage", role=Role.WHEEL, face_width=0.03, bodies=1, shafts=("shaft",)
    )
    joints = [
        SimpleNamespace(shaft="shaft", kind="key", part=part, length=0.04, position=0.1)
        for part in ("stage.wheel", "propeller")
    ]
    joints += [SimpleNamespace(shaft="shaft", kind="integral", part="stage.wheel", length=0.04, position=0.1)]
    sizing = SimpleNamespace(
        design=SimpleNamespace(
            service=SimpleNamespace(application_factor=1.5),
            pairs={"stage": SimpleNamespace(kind="cylindrical", halves=1)},
            bearings={name: SimpleNamespace(locates=way) for name, way in located.items()},
        ),
        bearings=bearings, gears=[gear], joints=joints,
        meshes=[
            SimpleNamespace(gears=("stage.pinion", "stage.wheel"), axial_force=force, radial_force=2.0 * abs(force))
            for force in (100.0, -400.0)
        ],
    )  # fmt: skip
    seated = list(_seated(sizing, SimpleNamespace(name="shaft")))
    assert [part.name for part in seated] == [*located, "stage.wheel", "propeller"]
    by_name = {part.name: part for part in seated}
    for name, way in located.items():
        signs = LOCATES[way]
        assert by_name[name].pulls == (300.0 if 1 in signs else 0.0, 300.0 if -1 in signs else 0.0)
        assert (by_name[name].start, by_name[name].end) == (pytest.approx(0.04), pytest.approx(0.06))
    assert (by_name["fixed"].pulls, by_name["free"].pulls) == ((300.0, 300.0), (0.0, 0.0))
    assert by_name["stage.wheel"].pulls == (600.0, 600.0)
    assert (by_name["stage.wheel"].start, by_name["stage.wheel"].end) == (pytest.approx(0.085), pytest.approx(0.115))
    assert by_name["propeller"].is_machine and by_name["propeller"].pulls == (0.0, 0.0)
    assert (by_name["propeller"].start, by_name["propeller"].end) == (pytest.approx(0.08), pytest.approx(0.12))
    sizing.design.pairs["stage"].kind = "bevel"
    crossed = {part.name: part for part in _seated(sizing, SimpleNamespace(name="shaft"))}
    assert crossed["stage.wheel"].pulls == (1200.0, 1200.0)


def test_a_pinion_that_hangs_over_the_end_of_its_shaft_is_told_and_not_a_crash():
    """In the middle of the shaft's end, half of it beyond: its end sits on the last step, and room is what fails."""
    text = shipped_design("ec120b-as-reported").read_text(encoding="utf-8")
    moved = text.replace('"helical.pinion".position_mm = 115', '"helical.pinion".position_mm = 0')
    assert moved != text
    sizing = gw.size(gw.parse(moved))
    (first,) = [held for held in ends(sizing) if (held.shaft, held.way) == ("input", -1)]
    assert (first.outermost, first.diameter) == ("helical.pinion", 0.032) and first.place < 0.0
    assert any(check.part.name == "input" and check.mode == "room" for check in review_of(sizing).failing)
