"""What planets turn on is chosen with the gears: rolling bearings where they live, and a plain word where none does."""

from functools import cache

from gearwright.closure import Outcome, Step, Wishes, close
from gearwright.closure.moves import FILM, ROLLING
from gearwright.errors import DesignError
from gearwright.reviews import review
from gearwright.sizing import size
from gearwright.spec import design_text, edited, parse

HOUR = 3600.0
SET = """\
schema = 1
name = "one set"
shafts = ["fast", "slow"]
level = "concept"
[turbines.turbine]
shaft = "fast"
power_kw = 300
speed_rpm = 6000

[propellers.propeller]
shaft = "slow"
speed_rpm = 1350
diameter_m = 3

[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3

[gears]
rating = "iso6336"
"""


QUICK = {
    "turbines.turbine.power_kw": 1046,
    "turbines.turbine.speed_rpm": 20000,
    "propellers.propeller.speed_rpm": 4500,
    "propellers.propeller.diameter_m": 1.0,
}


@cache
def closed(*, fast=False, hours=5000):
    """The set as it is, off its resonances, or the first of the thesis's hybrid: 1046 kW from 20 000 to 4500 rpm."""
    design = edited(parse(SET), QUICK) if fast else parse(SET)
    return close(design, wishes=Wishes(hours * HOUR, separate=not fast, lighten=False))


def bearing(found):
    return found.design.planetaries["set"].planet_bearing


def test_a_slow_set_gets_a_rolling_bearing_that_lives():
    assert closed().outcome is Outcome.CLOSED
    assert not closed().unmet
    assert bearing(closed()).kind in {kind for kind, _ in ROLLING}
    lives = [check for check in closed().checks if check.name == "set.planet life"]
    assert [check.margin >= 1.0 for check in lives] == [True]
    assert Step.BEAR in [row.step for row in closed().rounds]


def test_the_written_design_says_it_to_an_independent_review():
    reviewed = review(parse(design_text(closed().design)))
    assert not [check for check in reviewed.failing if check.part.name == "set"]
    assert "set.planet life" in [check.name for check in reviewed.checks]


def test_no_lighter_rolling_bearing_would_have_had_room_and_lived():
    own, fitting = "planetaries.set.planet_bearing", []
    for kind, count in ROLLING:
        other = edited(closed().design, {own: {"kind": kind, "side_by_side": count}})
        try:
            sizing = size(other)
        except DesignError as error:
            assert "has room" in str(error)
            continue
        fitting.append(kind)
        lacking = [check for check in sizing.checks if check.fails]
        assert lacking or sizing.mass >= closed().mass * (1.0 - 1e-9), kind
    assert len(fitting) > 1 and bearing(closed()).kind in fitting


def test_a_carrier_at_4500_rpm_leaves_no_bearing_20000_hours():
    """The planets' own weight on their pins: 28.5 kN against 7.3 kN of the teeth in the thesis's first stage."""
    found = closed(fast=True, hours=20000)
    assert found.outcome is Outcome.OPEN
    (unmet,) = (row for row in found.unmet if row.requirement == "bearings" and row.check.part.name == "set")
    assert unmet.check.margin < 0.5
    assert "star stage" in unmet.helps
    failing = [check.name for check in review(parse(design_text(found.design))).failing]
    assert unmet.check.name in failing


def test_a_bearing_that_is_named_stays():
    named = edited(parse(SET), {"planetaries.set.planet_bearing": {"kind": "plain"}})
    assert ("plain", 1) in FILM
    found = close(named, wishes=Wishes(500 * HOUR, separate=False, lighten=False))
    assert bearing(found).kind == "plain"
    assert Step.BEAR not in [row.step for row in found.rounds]
