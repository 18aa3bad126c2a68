"""Rims and webs that are free become thinner until roots, or what standards know of them, say no."""

from functools import cache
from math import log, pi

import pytest

import gearwright.closure.moves as bodies
from designs import PAIR
from gearwright.closure import Outcome, Wishes, close, contradictions
from gearwright.reviews import review
from gearwright.sizing import size
from gearwright.sizing.mass.bodies import gear_blanks
from gearwright.spec import design_text, edited, parse

GIVEN = {"pairs.stage.pinion_teeth": 43, "pairs.stage.wheel_teeth": 129, "pairs.stage.module_mm": 2}
RATED = edited(parse(PAIR), {"gears.rating": "iso6336", **GIVEN})
RIM, WEB = "pairs.stage.gears.rim_ratio", "pairs.stage.gears.web_thickness_ratio"


@cache
def closed(*free):
    return close(RATED, wishes=Wishes(free=free, separate=False, left_out=frozenset({"critical speeds"})))


@cache
def against():
    found = closed("rims", "webs")
    return {row.against: row.unmet for row in contradictions(RATED, found)}


def root(rim):
    """Return the margin of the wheel's root, all else as closed, and the load factors of the root."""
    sizing = size(edited(closed("rims", "webs").design, {RIM: rim}))
    margin = next(check.margin for check in sizing.checks if check.name == "stage.wheel tooth root")
    return margin, float(sizing.meshes[0].rating.factors.loads.bending)


def test_thinner_ones_are_lighter_and_an_independent_review_finds_nothing_new():
    thin, thick = closed("rims", "webs"), closed()
    assert thin.outcome is Outcome.CLOSED
    assert thin.whole.total < 0.95 * thick.whole.total
    failing = [{check.name for check in review(parse(design_text(own.design))).failing} for own in (thin, thick)]
    assert failing[0] == failing[1]


def test_a_rim_stops_where_its_roots_would_fail_by_the_factor_of_iso_6336_3():
    stated = closed("rims", "webs").design.rules("stage").rim_ratio
    next_ = round(stated - 0.05, 4)
    (own, loads), (thinner, lighter) = root(stated), root(next_)
    assert own >= 1.0 > thinner
    assert lighter != loads, "a thinner rim vibrates otherwise: K_V"
    assert own * loads / (thinner * lighter) == pytest.approx(log(2.242 / next_) / log(2.242 / stated), rel=1e-6)
    assert against()[f"{RIM} = {next_}"] == ("stage.wheel tooth root",)


def test_a_web_stops_where_the_standard_knows_no_thinner_one():
    assert closed("rims", "webs").design.rules("stage").web_thickness_ratio == 0.2
    assert "C_R" in against()[f"{WEB} < 0.2"][0]


def test_a_web_bears_its_torque_in_shear_at_the_hub(monkeypatch):
    """100 kW at 6000 and 2000 rpm; by hand t = 2 T/(π d² τ) with τ = R_p0.2/(2 S)."""
    monkeypatch.setattr(bodies, "THINNEST_WEB", 0.0)
    sizing = closed().sizing
    width, design, blanks = sizing.gears[0].face_width, sizing.design, gear_blanks(sizing)
    shear = design.shaft_material.yield_strength / design.shafting.safety / 2.0
    rows = (("stage.pinion", 6000.0), ("stage.wheel", 2000.0))
    by_hand = [2e5 / (rpm * pi / 30.0) / (pi * (2.0 * blanks[gear].hub_radius) ** 2 * shear) for gear, rpm in rows]
    assert bodies.least_web(sizing, "stage") * width == pytest.approx(max(by_hand), rel=1e-9)


def test_a_rim_is_made_thicker_where_the_stated_one_is_too_thin():
    few = {"pairs.stage.pinion_teeth": 33, "pairs.stage.wheel_teeth": 99, "pairs.stage.module_mm": 2.75}
    thin = edited(RATED, {**few, RIM: 0.55})
    wishes = {"separate": False, "left_out": frozenset({"critical speeds"})}
    kept, free = (close(thin, wishes=Wishes(free=own, **wishes)) for own in ((), ("rims",)))
    assert free.whole.total < kept.whole.total
    assert free.design.rules("stage").rim_ratio > 0.6


def test_the_rim_of_wheels_is_not_that_of_pinions():
    """Y_B counts for wheels and planets alone, so that a pinion keeps the rim that costs no strength."""
    whole, thin = (gear_blanks(size(edited(closed().design, {RIM: rim}))) for rim in (None, 0.8))
    assert thin["stage.pinion"] == whole["stage.pinion"]
    assert thin["stage.wheel"].rim_radius == pytest.approx(whole["stage.wheel"].rim_radius + 0.4 * 2.25 * 2e-3)
