"""Scattered flights: each has the bits that it has alone, whatever it is flown with and whoever computes it."""

import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.spec import parse_study
from gearwright.study.cases import cases, evaluate, flown_together
from gearwright.study.running import run_study

SCATTERED = """
schema = 1
name = "scattered"
designs = ["in-line-h2"]
results = ["fly.fuel", "fly.minimum_charge", "fly.duration", "fly.climb.fuel", "fly.life", "mass"]
[fly]
mission = "thesis"
[axes]
"mission.isa_offset_k" = {distribution = "normal", mean = 0, deviation = 8}
"mission.phases.cruise.duration_min" = {distribution = "triangular", from = 25, likeliest = 40, to = 60}
"mission.phases.climb.altitude_ft, mission.phases.cruise.altitude_ft" = {from = 17000, to = 25000}
[sampling]
method = "random"
count = 7
seed = 4
"""


@pytest.fixture(scope="module")
def study():
    """Return a study of scattered flights."""
    return parse_study(SCATTERED)


@pytest.fixture(scope="module")
def designs():
    """Return its design."""
    return {"in-line-h2": gw.read("in-line-h2")}


def test_flights_together_have_the_bits_of_each_alone(study, designs):
    drawn = list(cases(study))
    together = flown_together(study, designs, drawn)
    assert together == [evaluate(study, designs["in-line-h2"], case) for case in drawn]
    assert together[2:5] == flown_together(study, designs, drawn[2:5])


def test_workers_and_none_give_the_same_bits(study, designs):
    assert run_study(study, designs, workers=1) == run_study(study, designs) == gw.study(study, designs)


def test_paths_with_a_comma_between_them_have_the_same_value(study, designs):
    row = flown_together(study, designs, list(cases(study))[:1])[0]
    (altitude,) = (value for path, value in row.inputs.items() if "altitude" in path)
    paths = ("phases.climb.altitude_ft", "phases.cruise.altitude_ft")
    others = {path.removeprefix("mission."): value for path, value in row.inputs.items() if "," not in path}
    mission = gw.edited_mission(gw.read_mission("thesis"), others | dict.fromkeys(paths, altitude))
    flight = gw.fly(gw.size(designs["in-line-h2"]), mission)
    assert row.number("fly.fuel") == flight.fuel
    assert flight.history.altitude[list(flight.phase).index("cruise")] == pytest.approx(0.3048 * altitude)


def test_a_path_of_several_that_is_none_is_refused():
    with pytest.raises(DesignError, match="altitud_ft"):
        gw.study(parse_study(SCATTERED.replace("climb.altitude_ft", "climb.altitud_ft")))


def test_a_flight_that_cannot_be_flown_is_a_row_with_the_reason_that_it_has_alone(study, designs):
    short = parse_study(SCATTERED.replace("[sampling]", '[changes]\n"mission.battery.energy_kwh" = 560\n[sampling]'))
    rows = flown_together(short, designs, list(cases(short)))
    assert {bool(row.problem) for row in rows} == {True, False}
    assert rows == [evaluate(short, designs["in-line-h2"], case) for case in cases(short)]


def test_a_battery_that_empties_is_told_with_phase_and_time(designs):
    mission = gw.edited_mission(gw.read_mission("thesis"), {"battery.energy_kwh": 500.0})
    with pytest.raises(DesignError, match=r"phases\.cruise: at \d+ s, battery: empty"):
        gw.fly(gw.size(designs["in-line-h2"]), mission)


def test_many_flights_scatter_by_the_axes_of_studies(designs):
    scatter = {"mission.isa_offset_k": {"distribution": "normal", "mean": 0.0, "deviation": 5.0}}
    told = []
    table = gw.fly_many(
        designs["in-line-h2"], gw.read_mission("thesis"), scatter, 3, seed=2, results=["fly.fuel"], watch=told.append
    )
    again = gw.fly_many(designs["in-line-h2"], gw.read_mission("thesis"), scatter, 3, seed=2, results=["fly.fuel"])
    assert table == again and told[-1].done == 3
    assert len(set(table.column("fly.fuel"))) == 3


@pytest.mark.parametrize(
    ("axis", "said"),
    [
        ({"distribution": "normal", "mean": 0.0}, "needs mean and deviation"),
        ({"from": 5.0, "to": 1.0}, "from must be below to"),
    ],
)
def test_a_scatter_that_is_none_is_refused(axis, said, designs):
    with pytest.raises(DesignError, match=said):
        gw.fly_many(designs["in-line-h2"], gw.read_mission("thesis"), {"mission.isa_offset_k": axis}, 3)


def test_no_flights_are_refused(designs):
    with pytest.raises(DesignError, match="fly one at least"):
        gw.fly_many(designs["in-line-h2"], gw.read_mission("thesis"), {}, 0)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"battery.energy_kwh": 500.0}, "battery: empty"),
        ({"phases.climb.power_kw": 2100.0}, "gas-turbine: needs"),
    ],
)
def test_the_interval_that_cannot_be_flown_says_why(designs, change, reason):
    sizing, mission = gw.size(designs["in-line-h2"]), gw.edited_mission(gw.read_mission("thesis"), change)
    with pytest.raises(DesignError, match=reason):
        gw.fly(sizing, mission)
