"""Engine, motor and battery in flight: limits and energies."""

import numba
import pytest
from hypothesis import given, strategies as st

from gearwright.air import air_at, stagnation_ratios
from gearwright.errors import DesignError
from gearwright.machines import (
    Battery,
    Engine,
    battery_step,
    fuel_flow,
    motor_loss,
    power_limits,
    rated_losses,
    stored_energy,
)

ENGINE = Engine(1e6, 2e6, 500.0, 7.75e-8, 0.2, -0.5, -3.9)
PACK = Battery(1e6, 800.0, 600.0, 0.05, 3.0, 0.1)


def test_a_battery_without_resistance_and_of_constant_voltage_gives_power_over_voltage():
    step = battery_step(Battery(1e6, 700.0, 700.0, 0.0, 3.0, 0.1), 0.5, 7e4, 10.0)
    assert step.current == pytest.approx(100.0, rel=1e-12)
    assert step.loss == 0.0


def test_a_flat_rated_engine_keeps_its_rating_until_the_core_gives_less():
    sea = stagnation_ratios(air_at(0.0), 0.0)
    assert sea == (1.0, 1.0)
    assert min(power_limits(ENGINE, *sea, 2100.0)) == 1e6
    found = min(power_limits(ENGINE, *stagnation_ratios(air_at(10000.0), 0.5), 2100.0))
    assert 0.3 * 2e6 < found < 0.4 * 2e6


def test_a_slow_shaft_meets_the_torque_limit():
    assert min(power_limits(ENGINE, 1.0, 1.0, 1000.0)) == 500e3


def test_an_engine_without_power_still_burns_its_idle_fuel():
    assert fuel_flow(ENGINE, 1.0, 1.0, 0.0) == pytest.approx(0.2 * fuel_flow(ENGINE, 1.0, 1.0, 2e6))


def test_the_rated_point_of_a_motor_has_its_efficiency():
    motor = rated_losses(1e6, 471.2, efficiency=0.96)
    assert 1e6 / (1e6 + motor_loss(motor, 1e6 / 471.2, 471.2)) == pytest.approx(0.96, rel=1e-12)
    assert motor_loss(motor, 0.0, 0.0) == 0.0
    assert motor_loss(motor, -2000.0, 400.0) == motor_loss(motor, 2000.0, 400.0)


@given(st.floats(0.2, 0.95), st.floats(-3e5, 3e5), st.floats(0.1, 30.0))
def test_a_battery_gives_what_its_store_loses(state, power, duration):
    """The midpoint makes it exact for a linear voltage; 1e-9 is rounding."""
    step = battery_step(PACK, state, power, duration)
    lost = stored_energy(PACK, state) - stored_energy(PACK, step.state_of_charge)
    scale = stored_energy(PACK, 1.0)
    assert step.open_power * duration == pytest.approx(lost, abs=1e-12 * scale)
    assert step.open_power == pytest.approx(power + step.loss, abs=1e-9 * (abs(power) + 1.0))


@pytest.mark.parametrize(
    ("state", "power", "stop"),
    [(0.1001, 1e5, "empty"), (0.5, 4e6, "overloaded"), (0.9999, -1e5, "full"), (0.5, 1e5, "")],
)
def test_what_stops_a_battery_is_named(state, power, stop):
    assert battery_step(PACK, state, power, 10.0).fault == stop


def test_a_loaded_battery_sags():
    assert battery_step(PACK, 0.5, 3e5, 1.0).terminal_voltage < battery_step(PACK, 0.5, 1e5, 1.0).terminal_voltage


def test_a_compiled_kernel_runs_the_same_machines():
    motor = rated_losses(1e6, 471.2, efficiency=0.96)
    assert numba.njit(motor_loss)(motor, 100.0, 300.0) == pytest.approx(motor_loss(motor, 100.0, 300.0), rel=1e-14)
    assert numba.njit(power_limits)(ENGINE, 0.9, 0.5, 2000.0) == power_limits(ENGINE, 0.9, 0.5, 2000.0)
    assert numba.njit(fuel_flow)(ENGINE, 0.9, 0.5, 1e5) == pytest.approx(fuel_flow(ENGINE, 0.9, 0.5, 1e5), rel=1e-14)


def test_an_altitude_and_an_offset_outside_the_model_are_refused_together():
    with pytest.raises(DesignError) as refused:
        air_at(-1.0, 200.0)
    assert [problem.path for problem in refused.value.problems] == ["altitude", "isa_offset"]
