"""Fuel by mass and charge by state on one side, work, losses and states of gas on the other."""

import dataclasses

import numpy as np
import pytest

from gearwright.air import air_at, stagnation_ratios
from gearwright.errors import DesignError
from gearwright.machines.turboshaft import Exhaust, exhaust_heat
from gearwright.mission import fly
from gearwright.shipped import shipped_missions
from gearwright.sizing import size
from gearwright.spec import edited_mission, parse_mission, read, read_mission
from shipped_work import flown

FLIGHTS = (
    ("in-line-h2", "thesis"), ("in-line", "regional-250nm"), ("twin-engine-helicopter", "rotor-schedule"),
    ("in-line-h2", "thesis-chapter-4"), ("in-line-h2", "strategies"), ("in-line-h2", "hybrid-reserves"),
    ("in-line-h2", "ways-down"), ("in-line", "regional-aircraft"), ("in-line", "equal-power"),
    ("ec120b", "ec120b-sortie"), ("ec120b", "ec120b-trim"),
)  # fmt: skip
"""Every shipped mission."""


def gas_heat(flight, warmer=0.0):
    """What the gas carries away, from recorded flows and temperatures alone [J]."""
    history = flight.history
    inlet = stagnation_ratios(air_at(history.altitude, flight.mission.isa_offset_k), history.mach)[0] * 288.15
    flows = history.air_flow, history.fuel_flow
    gas = Exhaust(*flows, history.exhaust_temperature + warmer, history.casing_heat)
    return float((history.duration * exhaust_heat(gas, inlet)).sum())


@pytest.mark.parametrize("pair", FLIGHTS)
def test_the_books_agree(pair):
    assert flown(*pair).balance.residual <= 1e-9


def test_every_shipped_mission_is_among_them():
    assert {mission for _, mission in FLIGHTS} == set(shipped_missions())


def test_the_second_book_is_made_of_what_is_recorded():
    flight = flown(*FLIGHTS[0])
    assert gas_heat(flight) == pytest.approx(flight.balance.exhaust_heat, rel=1e-12)
    other = dataclasses.replace(flight.balance, turbine_heat=gas_heat(flight, 1.0) + flight.balance.casing_heat)
    assert other.residual > 1e-4


def test_more_air_makes_a_cooler_exhaust_and_no_other_balance():
    mission = read_mission("regional-250nm")
    less, more = (
        fly(size(read("in-line")), edited_mission(mission, {"engine.air_flow_kg_s": flow})) for flow in (9.0, 12.0)
    )
    assert np.all(more.history.exhaust_temperature < less.history.exhaust_temperature)
    assert more.balance.exhaust_heat == pytest.approx(less.balance.exhaust_heat, rel=1e-9)
    assert max(more.balance.residual, less.balance.residual) <= 1e-9


def test_a_turbine_that_is_off_leaves_the_air_as_it_is():
    flight = flown(*FLIGHTS[0])
    off = flight.history.fuel_flow == 0.0
    assert off.any() and not flight.history.exhaust_heat[off].any()
    assert flight.history.exhaust_temperature[off] == pytest.approx(
        flight.history.air_temperature[off] * (1.0 + 0.2 * flight.history.mach[off] ** 2), rel=1e-12
    )


THIN = """
schema = 1
name = "thin and cold"
isa_offset_k = {offset}
propeller_map = "6-blades-af115"
[engine]
thermal_power_kw = 2600
[phases.one]
altitude_ft = {altitude}
tas_kt = 290
duration_min = 1
power_kw = {power}
propeller_speed_rpm = 1212
"""


def test_the_books_agree_at_minus_eighty_degrees():
    flight = fly(size(read("in-line")), parse_mission(THIN.format(offset=-35, altitude=30000, power=800)))
    assert flight.history.air_temperature.max() < 193.95
    assert flight.balance.residual <= 1e-9


def test_an_engine_beyond_its_ceiling_is_told_with_time_value_and_fix():
    wanted = r"phases.one: at 5 s, gas-turbine: needs 900 kW at 18288 m, and gives .* kW .by its core.; ask for less"
    with pytest.raises(DesignError, match=wanted):
        fly(size(read("in-line")), parse_mission(THIN.format(offset=0, altitude=60000, power=900)))
