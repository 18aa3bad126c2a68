"""Cells and windings that a flight warms: books, wear, limits told with path, value and fix."""

import functools

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.spec import edited_mission, parse_mission, read_mission
from shipped_work import sized

CELLS = {
    "slow_resistance_ohm": 0.005,
    "activation_k": 2500.0,
    "cooling_w_k": 0.0,
    "cycle_life": 2000.0,
    "calendar_years": 10.0,
}
HEAT = {"winding_capacity_j_k": 8e3, "case_capacity_j_k": 4e4, "winding_to_case_w_k": 600.0,
        "case_to_coolant_w_k": 1600.0, "coolant_temperature_k": 333.15}  # fmt: skip


def mission(cells=None, heat=None, **changes):
    plain = read_mission("strategies")
    data = plain.model_dump(by_alias=True)
    if cells is not None:
        data["battery"]["cells"] = CELLS | cells
    if heat is not None:
        data["motor"]["heat"] = HEAT | heat
    changed = type(plain).model_validate(data)
    return edited_mission(changed, changes) if changes else changed


@functools.cache
def warm():
    return fly(sized(), mission({}, {"rated_winding_k": 343.15}))


def test_a_plain_mission_follows_no_temperature():
    flight = fly(sized(), read_mission("strategies"))
    assert flight.history.battery_temperature is None and flight.history.winding_temperature is None
    assert flight.pack is None


def test_the_books_agree_with_cells_that_polarise():
    assert warm().balance.residual < 1e-9


def test_cells_warm_where_they_work_and_wear_by_what_passes():
    flight = warm()
    history, pack = flight.history, flight.pack
    heat = flight.balance.battery_loss / (pack.mass * 1000.0)  # nothing cools them
    assert history.battery_temperature[-1] - 298.15 == pytest.approx(heat, rel=1e-9)
    assert pack.mass == pytest.approx(300e3 / 180.0)
    passed = float((np.abs(history.battery_current) * history.duration).sum())
    assert pack.throughput == pytest.approx(passed, rel=1e-12)
    assert pack.cycles == pytest.approx(passed / (2.0 * 300.0 * 3.6e6 / 730.0), rel=1e-12)
    assert pack.worn > pack.cycles / 2000.0  # warmer than 25 °C, and older


def test_windings_warm_and_their_copper_resists_more():
    flight, cold = warm(), fly(sized(), mission({}))
    assert flight.history.winding_temperature.max() > 350.0
    boost = np.array(flight.phase) == "climb"
    warmer = (flight.history.winding_temperature > 345.0) & boost
    assert warmer.any()
    assert np.all(flight.history.motor_loss[warmer][1:] > cold.history.motor_loss[warmer][1:])


@pytest.mark.parametrize(
    ("cells", "heat", "message"),
    [
        (None, {"highest_winding_k": 380.0}, r"motor.heat.highest_winding_k: the winding of .* reaches .*more cooling"),
        (None, {"derate_from_k": 350.0}, r"derated from motor.heat.derate_from_k"),
        ({"start_temperature_k": 250.0}, None, r"battery.cells.lowest_temperature_k: .*-23.1 °C, the lowest"),
        (
            {"cooling_w_k": 0.0, "highest_temperature_k": 300.0},
            None,
            r"battery.cells.highest_temperature_k: .*cool it more",
        ),
    ],
)
def test_temperatures_beyond_limits_are_told(cells, heat, message):
    with pytest.raises(DesignError, match=message):
        fly(sized(), mission(cells, heat))


def test_a_limit_below_the_surroundings_is_told():
    with pytest.raises(DesignError, match=r"highest_winding_k: 300 K is not above coolant_temperature_k, 333"):
        fly(sized(), mission(None, {"highest_winding_k": 300.0}))


def test_a_battery_emptied_in_a_step_is_told():
    with pytest.raises(DesignError, match=r"battery: empty: .*(minimum 0.1).*give more energy_kwh"):
        fly(sized(), mission({}, None, **{"battery.energy_kwh": 60.0, "battery.highest_c_rate": 60.0}))


TEXT = """
schema = 1
name = "test"
[battery]
energy_kwh = 100
[battery.cells]
{cells}
[phases.one]
altitude_ft = 5000
cas_kt = 170
duration_min = 2
power_kw = 900
propeller_speed_rpm = 1212
"""


@pytest.mark.parametrize(
    ("cells", "message"),
    [
        ("ocv_charge = [0, 1]", "a curve needs ocv_charge and ocv_v"),
        ("ocv_charge = [0, 0.5, 1]\nocv_v = [600, 700]", "2 voltages at 3 states"),
        ("ocv_charge = [0, 0.6, 0.5, 1]\nocv_v = [600, 650, 700, 800]", "must rise from 0 to 1"),
        ("ocv_charge = [0, 0.5, 1]\nocv_v = [600, 700, 650]", "never fall"),
        ("lowest_temperature_k = 300\nhighest_temperature_k = 290", "290 K is not above the lowest, 300 K"),
    ],
)
def test_curves_and_limits_that_cannot_be_are_told(cells, message):
    with pytest.raises(DesignError, match=message):
        parse_mission(TEXT.format(cells=cells))
