"""Temperatures of a flight in the lives of bearings and the films of teeth: limits, senses, brute force."""

import functools

import numpy as np
import pytest

from gearwright.mission import fly
from gearwright.mission.lives import bearing_lives, damage as films
from gearwright.sizing import size
from gearwright.spec import OilNetworkRules, edited, read, read_mission

NETWORK = {"oil_mass": 6.0, "housing_mass": 15.0, "bearing_mass": 6.0, "gears_to_oil_w_k": 100.0,
           "bearings_to_oil_w_k": 80.0}  # fmt: skip
STILL = {"oil_mass": 1e4, "housing_mass": 1e5, "bearing_mass": 1e4, "bearings_to_oil_w_k": 1e6, "cooler_w_k": 0.0,
         "start_temperature_k": 363.15}  # fmt: skip


@functools.cache
def gearbox():
    return size(edited(read("ec120b"), {"bearing_rules.life": "modified"}))


@functools.cache
def flight(**changes):
    mission = read_mission("ec120b-sortie")
    network = OilNetworkRules(**(NETWORK | changes))
    return fly(gearbox(), mission.model_copy(update={"oil": mission.oil.model_copy(update={"network": network})}))


@functools.cache
def lives(**changes):
    return {row.seat: row for row in bearing_lives(flight(**changes)).rows}


def test_at_the_designs_temperature_bearings_live_as_the_design_says():
    """A network too heavy to warm up, at the 90 °C of [oil]: the factor of the flight without it, to 2 %, of 0.43 K."""
    plain = {row.seat: row for row in bearing_lives(fly(gearbox(), read_mission("ec120b-sortie"))).rows}
    still = lives(**STILL)
    assert flight(**STILL).history.bearings_temperature == pytest.approx(
        np.full(len(flight(**STILL).phase), 363.15), abs=0.5
    )
    for seat, row in plain.items():
        assert still[seat].life_factor == pytest.approx(row.life_factor, rel=2e-2)


def test_warmer_bearings_live_shorter():
    cool, hot = lives(cooler_w_k=200.0, cooler_opens_k=300.0), lives(cooler_w_k=12.0)
    assert (
        flight(cooler_w_k=12.0).history.bearings_temperature.max()
        > 20.0 + flight(cooler_w_k=200.0, cooler_opens_k=300.0).history.bearings_temperature.max()
    )
    shorter = [hot[seat].life_factor / cool[seat].life_factor for seat in cool if cool[seat].life_factor]
    assert len(shorter) > 3 and max(shorter) < 0.95


def test_warmer_oil_scuffs_sooner_and_without_a_network_nothing_is_said():
    cool, hot = (
        {check.part: check.value for check in films.film_checks_of(flight(**changes))}
        for changes in ({"cooler_w_k": 200.0, "cooler_opens_k": 300.0}, {"cooler_w_k": 12.0})
    )
    assert cool.keys() == hot.keys() and len(cool) == 3
    assert all(hot[part] < 0.95 * cool[part] for part in cool)
    assert list(films.film_checks_of(fly(gearbox(), read_mission("ec120b-sortie")))) == []


def test_intervals_that_no_other_surpasses_hold_the_worst(monkeypatch):
    """All intervals judged give the same worst as the few that are looked at."""
    few = list(films.film_checks_of(flight(cooler_w_k=12.0)))
    monkeypatch.setattr(films, "_extreme", lambda torque, warm, speed, among: among)
    assert [check.value for check in films.film_checks_of(flight(cooler_w_k=12.0))] == [check.value for check in few]
