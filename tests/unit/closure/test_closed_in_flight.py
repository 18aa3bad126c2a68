"""Gears of a design that is closed on a mission live through its flights, as a review of the written design says."""

from functools import cache
from importlib import import_module

import pytest

from gearwright.closure import OnMission, Step, Wishes, close, requirement_of
from gearwright.reviews import review
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.spec import design_text, edited, edited_mission, parse, read, read_mission

HOUR = 3600.0
FLOWN = "life in flight"
LIGHT = frozenset({"peaks", "flank", "scuffing"})
"""Left out, so that roots under the cases of the design alone make gears too light for the mission's flanks."""


@cache
def mission():
    path = shipped_mission("thesis")
    return OnMission(read_mission(path), path.parent)


@cache
def closed(*, on_mission=True):
    design = read(shipped_design("mixed-h2"))
    wishes = Wishes(20000 * HOUR, separate=False, lighten=False, left_out=LIGHT)
    return close(design, wishes=wishes, on_mission=mission() if on_mission else None)


def failing(found):
    judged = review(parse(design_text(found.design)), mission().mission, folder=mission().folder)
    return {check.name for check in judged.failing if requirement_of(check) == FLOWN}


def test_gears_that_are_too_light_for_the_mission_grow_until_they_live():
    assert failing(closed(on_mission=False)) != set()
    assert failing(closed()) == set()
    assert closed().mass > closed(on_mission=False).mass
    rounds = [row for row in closed().rounds if row.step is Step.FLY]
    assert "times its cases" in rounds[0].what


def test_gears_do_not_live_through_flights_that_the_closure_does_not_look_at():
    design = read(shipped_design("mixed-h2"))
    wishes = Wishes(20000 * HOUR, separate=False, lighten=False, left_out=LIGHT | {FLOWN})
    assert failing(close(design, wishes=wishes, on_mission=mission())) != set()


def test_checks_of_the_flight_stand_with_the_others():
    assert FLOWN in {requirement_of(check) for check in closed().checks}
    assert FLOWN not in {requirement_of(check) for check in closed(on_mission=False).checks}


def test_flights_that_do_not_come_to_rest_are_told(monkeypatch):
    monkeypatch.setattr(import_module("gearwright.closure.close"), "MOST_ROUNDS", 1)
    design = read(shipped_design("mixed-h2"))
    wishes = Wishes(20000 * HOUR, separate=False, lighten=False, left_out=LIGHT)
    found = close(design, wishes=wishes, on_mission=mission())
    (told,) = (check for check in found.checks if check.mode == "convergence of the closure in flight")
    assert told.fails
    assert "live through them" in told.clause
    least = min(check.reserve for check in found.checks if requirement_of(check) == FLOWN and check.fails)
    assert told.margin == pytest.approx(least, rel=1e-4)  # that of the text, whose shafts are rounded, is flown last


def test_oil_that_is_warmer_in_flight_is_what_teeth_are_rated_with():
    """Oil of 96 °C into the gearbox, where scuffing counted on 90: the closure rates with it, unless 90 are given."""
    warm = edited_mission(mission().mission, {"oil.inlet_temperature_k": 369.15})
    wishes = Wishes(20000 * HOUR, separate=False, lighten=False, left_out=LIGHT - {"scuffing"} | {"life in flight"})
    asked = OnMission(warm, mission().folder)
    found = close(read(shipped_design("mixed-h2")), wishes=wishes, on_mission=asked)
    assert found.design.oil.temperature == pytest.approx(96.0)
    assert "oil of 96 °C" in " ".join(row.what for row in found.rounds if row.step is Step.FLY)
    cool = edited(read(shipped_design("mixed-h2")), {"oil.temperature": 90.0})
    kept = close(cool, wishes=wishes, on_mission=asked)
    assert "oil temperature" in {row.check.mode for row in kept.unmet}
    assert kept.design.oil.temperature == 90.0


def test_planets_whose_bearings_die_in_flight_turn_on_what_lives():
    """Cases that last at a third of the power choose bearings that the flights of the mission wear out."""
    by_cases, by_flights = eased(5000), eased(5000, on_mission=mission())
    assert "second.planet bearing life" in dead(by_cases)
    assert dead(by_flights) == set()
    thick = {shaft.name: shaft.diameter for shaft in by_flights.sizing.shafts}
    assert thick["input"] > {shaft.name: shaft.diameter for shaft in by_cases.sizing.shafts}["input"]
    assert "input is " in " ".join(row.what for row in by_flights.rounds)
    assert "planets of second turn" in next(row.what for row in by_flights.rounds if row.step is Step.FLY)


def test_planets_are_asked_for_no_longer_life_where_nothing_with_room_has_it():
    """12 000 h in flight are 70 000 h in the cases, of which the best bearing lasts 53 500: asked once, and told."""
    found = eased(12000, on_mission=mission())
    assert sum("planets of second turn" in row.what for row in found.rounds if row.step is Step.FLY) == 1
    assert {"second.planet life", "second.planet bearing life"} <= {row.check.name for row in found.unmet}
    assert not any(check.mode == "convergence of the closure in flight" for check in found.checks)


def eased(hours, *, on_mission=None):
    """Return a design closed for a life [h] whose cases ask for a third of the power of its flights."""
    light = {"cases.cruise.share": 1.0, "cases.rated.share": 0.0,
             "cases.cruise.gas-turbine.power_kw": 400, "cases.cruise.electric.power_kw": 300}  # fmt: skip
    wishes = Wishes(hours * HOUR, separate=False, lighten=False, left_out=frozenset({"peaks", FLOWN}))
    return close(edited(read(shipped_design("mixed-h2")), light), wishes=wishes, on_mission=on_mission)


def dead(found):
    """Return the bearings that do not live through the flights of a written design."""
    judged = review(parse(design_text(found.design)), mission().mission, folder=mission().folder)
    return {check.name for check in judged.failing if requirement_of(check) == "bearings"}
