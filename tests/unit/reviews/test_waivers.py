"""Waivers: a design accepts that a check fails, by its name and with a reason."""

import pytest

from designs import problems
from gearwright.checks import Status, unneeded
from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.reviews import Verdict, review_of
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import parse, read_mission

REPORTED = shipped_design("ec120b-as-reported").read_text(encoding="utf-8")
HYBRID = shipped_design("in-line-h2").read_text(encoding="utf-8")


def with_waivers(text, *names, reason="accepted for the test"):
    return f"{text}\n[waivers]\n" + "".join(f'"{name}" = "{reason}"\n' for name in names)


def test_a_waived_failure_keeps_its_numbers_and_does_not_decide():
    """The worst entry becomes the next one; both face widths, by modules and by diameter, have the one name."""
    plain, waived = (
        size(parse(REPORTED)),
        size(parse(with_waivers(REPORTED, "mast slope", "helical.pinion face width"))),
    )
    slopes = [check for check in waived.checks if check.name == "mast slope"]
    assert [check.waiver for check in slopes if check.status is Status.FAILS] == ["accepted for the test"] * 2
    assert not any(check.fails for check in slopes)
    assert plain.checks[0].name == "mast slope"
    assert waived.worst_margin > plain.worst_margin
    assert sum(check.status is Status.FAILS for check in waived.checks) == sum(check.fails for check in plain.checks)
    assert not any(check.fails for check in waived.checks if check.name == "helical.pinion face width")


def test_a_design_whose_every_failure_is_waived_passes_as_far_as_it_is_assessed():
    failing = {check.name for check in review_of(size(parse(HYBRID))).failing}
    reviewed = review_of(size(parse(with_waivers(HYBRID, *failing))))
    assert reviewed.verdict is Verdict.PASSES_SO_FAR
    assert {check.name for check in reviewed.waived} == failing
    assert reviewed.worst.status is Status.PASSES


def test_a_waiver_of_what_passes_is_said_not_to_be_needed():
    reviewed = review_of(size(parse(with_waivers(HYBRID, "first.carrier pin bending"))))
    assert reviewed.unneeded == ("first.carrier pin bending",)
    assert unneeded(reviewed.checks, {"no check at all": "x"}) == ()


def test_a_waiver_of_no_check_is_refused_with_the_nearest():
    (found,) = problems(with_waivers(REPORTED, "helical.pinion face wdth"), sized=True)
    assert found.path == "waivers.helical.pinion face wdth"
    assert "did you mean helical.pinion face width?" in found.message


@pytest.mark.parametrize("name", ["first.planet bearing life", "gearbox resonance of second mesh x 2"])
def test_a_sizing_leaves_waivers_of_what_a_run_or_a_flight_judges_alone(name):
    assert size(parse(with_waivers(HYBRID, name))).design.waivers == {name: "accepted for the test"}


def test_a_review_with_a_mission_knows_every_check():
    text = with_waivers(HYBRID, "second.plant bearing life")
    sizing = size(parse(text))
    assert review_of(sizing).verdict is Verdict.FAILS
    with pytest.raises(
        DesignError, match=r"second\.plant bearing life: there is no such check; did you mean second\.pl"
    ):
        review_of(sizing, fly(sizing, read_mission(shipped_mission("thesis"))))


@pytest.mark.parametrize("reason", ["", "   "])
def test_a_waiver_without_a_reason_is_refused(reason):
    (found,) = problems(with_waivers(HYBRID, "first.carrier pin bending", reason=reason))
    assert (found.path, "has no reason" in found.message) == ("waivers.first.carrier pin bending", True)


def test_waivers_do_not_change_what_is_sized():
    with_, without = (size(parse(text)) for text in (with_waivers(HYBRID, "first.carrier pin bending"), HYBRID))
    assert with_.gears == without.gears
