"""Maintenance: intervals by hand, what comes off first by where parts stand, and what a design may ask of it."""

import dataclasses

import pytest

from gearwright.checks import Status
from gearwright.mission.lives import upkeep_of
from gearwright.mission.lives.upkeep import way_to
from gearwright.reviews import review_of
from gearwright.shipped import shipped_designs
from gearwright.sizing import size
from gearwright.sizing.making import leaves_past, withdrawals
from gearwright.spec import edited
from shipped_work import BY_HAND, flown, lives, sized

HOUR = 3600.0


def task(name, part, what):
    """Return one task of a shipped design."""
    (found,) = (one for one in upkeep_of(sized(name)) if (str(one.part), one.task) == (part, what))
    return found


@pytest.mark.parametrize("name", shipped_designs())
def test_every_shipped_design_has_its_maintenance_the_shortest_interval_first(name):
    tasks = upkeep_of(sized(name))
    known = [one.interval for one in tasks if one.interval is not None]
    assert known == pytest.approx(sorted(known)) and all(interval > 0.0 for interval in known)
    assert all(one.decides and one.source for one in tasks)
    assert [one.interval for one in tasks][len(known) :] == [None] * (len(tasks) - len(known))


def test_the_bearings_of_a_set_live_as_long_as_the_first_of_them_to_fail():
    """Five equal rollers: L_10 of one over 5^(8/9), as Weibull's slope of line contact is 9/8."""
    sizing = sized("hybrid-turboprop")
    (one,) = (check for check in sizing.checks if str(check.part) == "second.planet" and check.dimension == "life")
    found = task("hybrid-turboprop", "second.planet", "change bearings")
    assert found.interval == pytest.approx(one.value / 5.0 ** (8.0 / 9.0), rel=1e-9)
    assert found.opens


def test_a_flight_s_lives_stand_in_place_of_the_load_cases():
    rows = {row.seat: row for row in lives().bearings.rows}
    found = {str(one.part): one for one in upkeep_of(sized(), flown(), lives()) if one.task == "change bearings"}
    row = rows["first.planet"]
    assert found["first.planet"].interval == pytest.approx(row.life * HOUR / row.count ** (8.0 / 9.0), rel=1e-6)
    assert found["first.planet"].decides.endswith("over the flight")


def test_each_of_two_sets_in_line_comes_out_by_its_own_end():
    """The first by the turbine's end, the second by the propeller's: neither has to come out for the other."""
    first, second = way_to(sized(), "first"), way_to(sized(), "second")
    assert first == ("gas-turbine", "housing at its first end")
    assert second == ("propeller", "housing at its second end")


def test_a_set_between_two_stages_needs_one_of_them_out():
    """Of a wind turbine's three stages the middle one comes out behind the first, of which it is the neighbour."""
    assert way_to(sized("wind-turbine-5mw"), "second") == ("blades", "housing at its first end", "first")


def test_what_a_set_waits_for_follows_from_where_it_stands():
    """With the middle set moved before the first, the first waits for it."""
    sizing = sized("wind-turbine-5mw")
    arrangement = sizing.arrangement

    def moved(body):
        if body.part.name == "second" and body.part.kind != "shaft":
            return dataclasses.replace(body, origin=body.origin._replace(x=body.origin.x - 2.0))
        return body

    bodies = tuple(moved(body) for body in arrangement.bodies)
    turned = dataclasses.replace(sizing, arrangement=dataclasses.replace(arrangement, bodies=bodies))
    assert "second" in way_to(turned, "first")
    assert "first" not in way_to(turned, "second")


def test_shafts_leave_behind_the_fewest_others_and_no_fewer_would_do():
    """EC120B: the intermediate shaft after tail and input, the input after the tail, mast and tail at once."""
    sizing = sized(BY_HAND)
    shafts = [shaft.name for shaft in sizing.built_shafts]
    ways = {step.shaft: step for step in withdrawals(sizing)[0]}
    for shaft, before in {"mast": (), "tail": (), "input": ("tail",), "intermediate": ("tail", "input")}.items():
        found = task(BY_HAND, shaft, "overhaul with its bearings")
        assert tuple(word.removeprefix("shaft ") for word in found.first if word.startswith("shaft ")) == before
        left = [name for name in shafts if name not in before]
        assert leaves_past(sizing, ways[shaft], left)
        for kept in before:
            others = [name for name in before if name != kept]
            blocked = [name for name in others if not leaves_past(sizing, ways[name], shafts)]
            assert blocked or not leaves_past(sizing, ways[shaft], [*left, kept])


def test_seals_need_their_machine_off_and_oil_nothing():
    """110 °C on FKM of 200 °C would last 1000 h · 2^9; at 9.42 m/s 250 000 km are 7368 h. 90 °C age oil in 2890 h."""
    seal = task("ec120b", "arrius-2f", "change seal")
    assert (seal.first, seal.opens) == (("arrius-2f",), False)
    assert seal.interval == pytest.approx(2.5e8 / 9.42477796, rel=1e-6)
    oil = task("ec120b", "gearbox", "change oil")
    assert oil.removed_first == "nothing"
    assert oil.interval == pytest.approx(8760.0 * HOUR * 4.0 ** (-40.0 / 50.0))
    assert task("ec120b", "gearbox", "change oil filter").interval == pytest.approx(oil.interval / 2.0)


def test_hot_lips_age_before_they_wear():
    """NBR at its hottest, 100 °C, lasts 1000 h."""
    seal = task("wind-turbine-5mw", "generator", "change seal")
    assert seal.interval == pytest.approx(1000.0 * HOUR)
    assert "NBR at 100 °C" in seal.decides


def test_an_interval_that_is_asked_is_a_check_of_what_opens_the_housing():
    """Planets' bearings of 1196 and 1883 h: 1500 h are met by one set, and oil and seals are not asked."""
    design = edited(sized("hybrid-turboprop").design, {"housing.overhaul_interval_h": 1500})
    checks = {str(check.part): check for check in review_of(size(design)).checks if check.mode == "overhaul interval"}
    assert {name: check.status for name, check in checks.items()} == {
        "first.planet": Status.PASSES,
        "second.planet": Status.FAILS,
    }
    assert not [check for check in review_of(sized()).checks if check.mode == "overhaul interval"]
