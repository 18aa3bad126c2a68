"""Blade elements against charts and a measured propeller, and the maps that they carry on."""

import math
from itertools import product

import numpy as np
import pytest

from gearwright.catalogue import ALL_STATES, MAPS, carried_on, hamilton_standard_charts, propeller_map
from gearwright.machines import Blades, angle_for_power, look_up, performance
from gearwright.machines.propellers import activity_factor, generic_blade, integrated_lift, loads
from gearwright.mission import fly
from gearwright.shipped import shipped_mission
from gearwright.sizing import size
from gearwright.spec import parse_mission, read

CHARTS = hamilton_standard_charts()


def nodes(count):
    """Charted C_T and C_P, and the elements', at every node of a blade count's charts, with J."""
    shape = generic_blade(Blades(int(CHARTS.blade_counts[count]), 150.0, 0.5))
    rows = []
    for j, ratio in enumerate(CHARTS.advance_ratio):
        found = loads(shape, ratio, np.radians(CHARTS.blade_angle[j]))
        rows += zip(
            np.full(len(found.thrust), ratio), CHARTS.thrust[count][j], CHARTS.power[count][j],
            found.thrust, found.power, strict=True,
        )  # fmt: skip
    return np.array(rows).T


def test_the_generic_blade_has_the_activity_factor_and_lift_it_is_made_for():
    shape = generic_blade(Blades(6, 115.0, 0.45))
    assert activity_factor(shape) == pytest.approx(115.0, rel=1e-9)
    assert integrated_lift(shape) == pytest.approx(0.45, rel=2e-3)


@pytest.mark.parametrize("count", range(4))
def test_efficiency_at_the_charts_nodes(count):
    """NASA CR-114399 where η ≥ 0.6, at one blade angle: median within 3 %, 95 % within 8 %."""
    ratio, thrust, power, found, taken = nodes(count)
    at = (power > 0.0) & (ratio * thrust >= 0.6 * power)
    error = np.abs((found / taken)[at] / (thrust / power)[at] - 1.0)
    assert at.sum() > 15
    assert np.median(error) < 0.03
    assert np.percentile(error, 95) < 0.08


def test_windmilling_thrust_at_the_charts_nodes():
    """Charted negative C_T of 2 to 8 blades: all within 0.01, half within 0.003."""
    errors = []
    for count in range(4):
        _, thrust, _, found, _ = nodes(count)
        errors += list(np.abs(found - thrust)[thrust < 0.0])
    assert len(errors) == 40
    assert np.median(errors) < 0.003
    assert max(errors) < 0.01


def test_windmilling_power_at_the_charts_nodes():
    """What the air gives, charted for 2 to 8 blades: median within 8 %, beyond a C_P of -0.05 all within 16 %."""
    rows = np.concatenate([np.array(nodes(count)).T for count in range(4)])
    _, _thrust, power, _, taken = rows[(rows[:, 1] < 0.0) & (rows[:, 2] < 0.0)].T
    error = np.abs(taken / power - 1.0)
    assert len(error) == 32
    assert np.median(error) < 0.08
    assert error[power < -0.05].max() < 0.16


def test_thrust_at_the_charts_power_for_blades_that_no_fit_saw():
    """AF 90 and 180, C_Li 0.4 and 0.6, J 0.9 to 3, η ≥ 0.6: median within 3 %; from C_P/B 0.03 AF/150 on all in 8 %."""
    errors = []
    for number, factor, lift in product((3, 4, 6), (90.0, 180.0), (0.4, 0.6)):
        blades = Blades(number, factor, lift)
        for ratio, load in product((0.9, 1.4, 2.2, 3.0), (0.035, 0.07, 0.12)):
            power = load * number * factor / 150.0
            point = performance(CHARTS, blades, ratio, power_coefficient=power)
            if point.held or ratio * point.thrust_coefficient < 0.6 * power:
                continue
            angles = point.blade_angle + np.radians(np.linspace(-4.0, 4.0, 17))
            made = loads(generic_blade(blades), ratio, angles)
            errors.append(abs(np.interp(power, made.power, made.thrust) / point.thrust_coefficient - 1.0))
    assert len(errors) > 60
    assert np.median(errors) < 0.03
    assert max(errors) < 0.08


@pytest.mark.parametrize("name", ALL_STATES)
def test_maps_in_all_states_are_made_as_they_say_and_keep_the_chart(name):
    """The made map is the shipped one (its sixth decimal); on the chart's own points it is the chart."""
    shipped, chart, made = propeller_map(name), propeller_map(ALL_STATES[name]), carried_on(ALL_STATES[name])
    assert MAPS[ALL_STATES[name]]
    assert shipped.thrust == pytest.approx(made.thrust, abs=2e-6)
    assert shipped.power == pytest.approx(made.power, abs=2e-6)
    for row in range(0, len(chart.advance_ratio), 10):
        column = -(-int(chart.first[row]) // 2) * 2
        at = float(chart.advance_ratio[row]), float(chart.blade_angle[column])
        assert look_up(shipped, *at).thrust == pytest.approx(chart.thrust[row, column], abs=2e-6)


@pytest.mark.parametrize("name", ALL_STATES)
def test_maps_in_all_states_windmill_feather_and_reverse(name):
    chart = propeller_map(name)
    idle = angle_for_power(chart, 2.0, 0.0)
    assert look_up(chart, 2.0, idle).thrust < 0.0
    assert look_up(chart, 0.3, math.radians(-20.0)).thrust < 0.0 < look_up(chart, 0.3, math.radians(-20.0)).power
    assert abs(look_up(chart, 5.0, math.radians(66.0)).thrust) < 1.0


def test_a_descent_at_idle_flies_on_a_map_in_all_states():
    """40 kW at 220 kt: the propeller drags; the map that ends with the charts refuses it."""
    text = shipped_mission("regional-250nm").read_text(encoding="utf-8")
    text = text.replace('"6-blades-af115"', '"6-blades-af115-all-states"')
    text = text.replace("rate_of_climb_ft_min = -900\n", "rate_of_climb_ft_min = -900\npower_kw = 40\n")
    flight = fly(size(read("in-line")), parse_mission(text))
    thrust = flight.history.thrust[flight.phase.index("descent") + 5]
    assert thrust < 0.0


def test_a_measured_propeller_at_its_best_efficiencies():
    """Hartman and Biermann, NACA TR-640: 5868-9, three blades, 10 ft, read from its curves at 15 to 45°.

    C_P within 16 % and efficiency 3 to 10 % above: another blade (AF 90 assumed), Clark Y, before a nacelle.
    """
    shape = generic_blade(Blades(3, 90.0, 0.5))
    measured = (
        (15, 0.6, 0.0338, 0.7684), (20, 0.8, 0.048, 0.8283), (25, 1.0, 0.0696, 0.8421), (30, 1.3, 0.0761, 0.8505),
        (35, 1.5, 0.1094, 0.8446), (40, 1.7, 0.1621, 0.8346), (45, 2.0, 0.2385, 0.8261),
    )  # fmt: skip
    for angle, ratio, power, efficiency in measured:
        found = loads(shape, ratio, math.radians(angle))
        assert found.power == pytest.approx(power, rel=0.16)
        assert 1.03 < ratio * float(found.thrust / found.power) / efficiency < 1.10
