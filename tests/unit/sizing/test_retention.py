"""What pulls at the ends of built shafts, and whether a ring holds it; bearings that are moved are seen."""

import math
import re

import pytest

import gearwright as gw
from gearwright.checks import Status
from gearwright.reviews import review_of
from gearwright.sizing.shafts import retention_checks, retentions
from shipped_work import sized

TEXT = gw.shipped_design("ec120b").read_text(encoding="utf-8")


def moved(bearing, by):
    """Return the EC120B gearbox with one bearing elsewhere [mm]."""
    place = re.search(rf"(\[bearings\.{bearing}\].*?position_mm = )([\d.]+)", TEXT, re.DOTALL)
    return TEXT[: place.start(2)] + str(float(place.group(2)) + by) + TEXT[place.end(2) :]


def checks_of(sizing):
    return {str(check.part): check for check in retention_checks(sizing)}


def test_a_ring_beside_the_four_point_bearing_of_the_input_holds_its_thrust():
    """DIN 471 - 30 × 1.5: d_2 = 28.6 mm bears 200/1.2 N/mm² on its collar."""
    sizing = sized("ec120b")
    check = checks_of(sizing)["input"]
    bearing = next(bearing for bearing in sizing.bearings if bearing.name == "input-axial")
    assert check.status is Status.PASSES
    assert check.value == pytest.approx(math.pi / 4.0 * (30.0**2 - 28.6**2) * 200.0 / 1.2, rel=1e-12)
    assert check.limit == pytest.approx(sizing.design.service.application_factor * bearing.axial, rel=1e-12)
    assert "DIN 471 - 30 x 1.5 beside input-axial" in check.place


def test_thrust_of_a_bearing_that_has_no_room_for_a_groove_is_named():
    """QJ 313 stands 3.5 mm from the end of its shaft; m + n of DIN 471 for 65 mm is 2.65 + 4.5 mm."""
    check = checks_of(sized("ec120b"))["intermediate"]
    assert check.status is Status.NOT_ASSESSED
    assert "groove and collar need 7.15 mm beside it, and there are 3.5 mm" in check.why and "nut" in check.why


def test_a_shoulder_holds_what_pushes_against_it():
    """The upper taper bearing of the mast takes thrust towards the second end, against the collar below it."""
    assert all((held.shaft, held.way) != ("mast", 1) for held in retentions(sized("ec120b")))


def test_a_seat_beside_which_the_shaft_is_thinner_has_no_room():
    held = next(held for held in retentions(sized("ec120b")) if held.shaft == "tail")
    assert held.diameter == pytest.approx(0.017) and held.room == 0.0


def test_a_review_lists_what_holds_shafts():
    modes = {check.mode for check in review_of(sized("ec120b")).checks}
    assert "axial retention at its first end" in modes


def test_a_bearing_that_is_moved_by_eight_millimetres_into_a_wheel_fails():
    checks = gw.size(gw.parse(moved("mast-lower", 8.0))).checks
    assert [check.name for check in checks if check.fails] == ["mast room on its shaft"]


@pytest.mark.parametrize(("bearing", "by"), [("input-axial", 8.0), ("intermediate-rear", -8.0), ("input-front", 8.0)])
def test_a_bearing_that_is_moved_by_eight_millimetres_into_another_or_over_the_end_is_refused(bearing, by):
    with pytest.raises(gw.DesignError, match=r"stands .* mm into"):
        gw.size(gw.parse(moved(bearing, by)))
