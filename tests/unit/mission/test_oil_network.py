"""Oil, gears, bearings and housing that warm up, and minutes without oil."""

import functools
import math

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.mission.plant import GearHeat, Warm, dry_run, oil_start, oil_step
from gearwright.spec import OilNetworkRules, read_mission
from shipped_work import sized

RULES = {"oil_mass": 12.0, "housing_mass": 40.0, "bearing_mass": 15.0, "gears_to_oil_w_k": 400.0,
         "bearings_to_oil_w_k": 300.0, "cooler_w_k": 300.0}  # fmt: skip
HEAT = GearHeat(9e3, 6e3, 1e3, 500.0)


def rules(**changes):
    return OilNetworkRules(**(RULES | changes))


def mission(**changes):
    plain = read_mission("strategies")
    return plain.model_copy(update={"oil": plain.oil.model_copy(update={"network": rules(**changes)})})


@functools.cache
def warm():
    return fly(sized(), mission(dry_from="cruise"))


def test_at_rest_cooler_and_housing_carry_all_heat():
    """By hand, with no link between oil and housing: oil stands heat/cooler above the air."""
    alone = rules(oil_to_housing_w_k=0.0, bearings_to_housing_w_k=0.0, gears_to_housing_w_k=0.0, cooler_opens_k=250.0)
    end, _ = oil_step(alone, 44.0, oil_start(alone, 320.0), heat=HEAT, air=280.0, duration=1e7)
    assert end.oil == pytest.approx(280.0 + sum(HEAT) / 300.0, rel=1e-9)
    assert end.gears == pytest.approx(end.oil + (0.5 * 9e3 + 1e3) / 400.0, rel=1e-9)
    assert end.bearings == pytest.approx(end.oil + 0.5 * 6e3 / 300.0, rel=1e-9)


def test_a_valve_that_regulates_settles_at_one_temperature_whatever_the_interval():
    """Four bodies at rest by their linear system, the valve's opening by bisection; an interval of 20 or 300 s: 1e-5.

    A valve as the oil was at the start of an interval swings by 13 K, where the oil and its cooler need 10 s.
    """
    asked = rules(cooler_w_k=600.0, oil_mass=8.0)
    low, high = 0.0, 1.0
    for _ in range(60):
        valve = 0.5 * (low + high)
        k = np.array([[750.0 + 600.0 * valve, -400.0, -300.0, -50.0], [-400.0, 402.0, 0.0, -2.0],
                      [-300.0, 0.0, 320.0, -20.0], [-50.0, -2.0, -20.0, 87.0]])  # fmt: skip
        q = [0.5 * 15e3 + 500.0 + 600.0 * valve * 260.0, 0.5 * 9e3 + 1e3, 0.5 * 6e3, 15.0 * 260.0]
        oil = float(np.linalg.solve(k, q)[0])
        low, high = (valve, high) if (oil - 343.15) / 10.0 > valve else (low, valve)
    assert 0.05 < valve < 0.95
    for step in (20.0, 60.0, 300.0):
        now = oil_start(asked, 330.0)
        for _ in range(round(1.2e4 / step)):
            now, _ = oil_step(asked, 44.0, now, heat=HEAT, air=260.0, duration=step)
        assert now.oil == pytest.approx(oil, rel=1e-5)


def test_what_heats_it_is_stored_or_given_to_the_air():
    now, given = oil_start(rules(), 300.0), 0.0
    start = now
    for _ in range(60):
        now, after = oil_step(rules(), 44.0, now, heat=HEAT, air=270.0, duration=10.0)
        given += 10.0 * float(after.rejected.sum())
    capacity = np.array([12.0 * 2000.0, 44.0 * 470.0, 15.0 * 470.0, 40.0 * 900.0])
    stored = float(capacity @ (np.array(now) - np.array(start)))
    assert stored + given == pytest.approx(600.0 * sum(HEAT), rel=1e-9)


def test_losses_follow_the_oil():
    flight, stated = warm(), fly(sized(), read_mission("strategies"))
    history = flight.history
    assert flight.balance.residual < 1e-9
    assert history.oil_temperature.min() > 300.0 and history.gears_temperature.max() > history.oil_temperature.max()
    assert flight.oil_outlet == pytest.approx(history.oil_temperature)
    assert not np.allclose(history.mesh_loss, stated.history.mesh_loss, rtol=1e-4)
    assert history.mesh_loss == pytest.approx(stated.history.mesh_loss, rel=0.1)  # η^-0.05


def test_a_larger_cooler_makes_colder_oil():
    larger = fly(sized(), mission(cooler_w_k=600.0))
    assert larger.hottest_oil < warm().hottest_oil


def test_a_dry_run_without_links_is_capacity_over_heat():
    alone = rules(bearings_to_housing_w_k=0.0, gears_to_housing_w_k=0.0, highest_bearings_k=1400.0)
    run = dry_run(alone, 44.0, Warm(360.0, 370.0, 365.0, 350.0), heat=HEAT, air=280.0)
    assert run.part == "gears"
    assert run.lasts == pytest.approx((523.15 - 370.0) * 44.0 * 470.0 / (3.0 * 9e3 + 1e3), rel=1e-9)


def test_more_friction_ends_a_dry_run_sooner_and_none_lasts_for_ever():
    start = Warm(360.0, 370.0, 365.0, 350.0)
    runs = [dry_run(rules(dry_friction=k), 44.0, start, heat=HEAT, air=280.0).lasts for k in (1.0, 2.0, 5.0)]
    assert runs[0] > runs[1] > runs[2] > 0.0
    cold = dry_run(rules(), 44.0, start, heat=GearHeat(0.0, 0.0, 0.0, 0.0), air=280.0)
    assert math.isinf(cold.lasts) and not cold.part


def test_the_page_tells_how_long_it_runs_dry():
    assert warm().dry.part and 60.0 < warm().dry.lasts < 7200.0


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"highest_oil_k": 340.0},
            r"oil.network.highest_oil_k: oil reach .*the highest is 66.9 °C; give a larger cooler",
        ),
        ({"highest_bearings_k": 300.0}, r"oil.network.highest_bearings_k: bearings reach"),
        ({"dry_from": "cruse"}, r"oil.network.dry_from: there is no phase 'cruse'; .*cruise"),
    ],
)
def test_what_cannot_be_is_told(changes, message):
    with pytest.raises(DesignError, match=message):
        fly(sized(), mission(**changes))


def test_oil_of_minus_eighty_degrees_does_not_flow_and_of_minus_forty_it_does():
    with pytest.raises(DesignError, match=r"oil: at -80\.0 °C it has .* no pump moves it"):
        fly(sized(), mission(start_temperature_k=193.15))
    assert np.isfinite(fly(sized(), mission(start_temperature_k=233.15)).history.gearbox_heat).all()
