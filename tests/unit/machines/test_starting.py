"""Starts: the gas generator below its choking meets the choked one, torque by hand, energy, hung and hot starts."""

import functools

import numpy as np
import pytest

from gearwright.catalogue import DesignPoint, StartRules, engine_start
from gearwright.errors import DesignError
from gearwright.machines.gas_generator import Starter, cranked, friction_torque, started
from gearwright.machines.turboshaft import Inlet, Rated, engine_of, steady_state
from gearwright.units import HORSEPOWER, POUND

STANDARD = Inlet(288.15, 101325.0, 101325.0)
FAST = 4500.0
ENGINE = engine_of(
    Rated(1120.0 * HORSEPOWER, 644.0 * POUND / 3600.0, 7.9568 * POUND, 9.0, 0.81, 0.86, inertia=0.06, speed=FAST)
)
OVER = ENGINE.rated.fuel_flow / (9.0 * 101325.0)
DESIGN = DesignPoint(1120.0 * HORSEPOWER, 644.0 * POUND / 3600.0 / (1120.0 * HORSEPOWER), 7.9568 * POUND, 9.0, FAST)


@functools.cache
def run(step=0.1, torque=40.0):
    starter = Starter(torque, 0.8 * FAST, 0.5 * FAST, 0.12 * FAST, 0.9 * OVER, 1100.0)
    return started(ENGINE, starter, STANDARD, idle=0.62 * FAST, times=(60.0, step))


@pytest.mark.parametrize(("part", "tolerance"), [(1.0, 1e-4), (0.9, 2e-2), (0.8, 2e-2)])
def test_where_it_chokes_it_is_the_engine_that_flies(part, tolerance):
    """Losses of pressure that fall with the flow, and constant ones, differ by up to 1 % of T_45 at 80 % of N1."""
    rest = steady_state(ENGINE, STANDARD, part * FAST)
    low = cranked(ENGINE, STANDARD, part * FAST, rest.fuel_flow)
    assert low.air_flow == pytest.approx(rest.air_flow, rel=tolerance)
    assert low.between == pytest.approx(rest.between, rel=tolerance)
    assert abs(low.surplus) <= 2e-3 * rest.compressor_power


def test_cold_it_takes_the_compressors_torque_and_friction_less_what_the_turbine_gives():
    cold = cranked(ENGINE, STANDARD, 0.15 * FAST, 0.0)
    assert 1.0 < cold.pressure_ratio < 1.05
    assert cold.friction == pytest.approx(friction_torque(ENGINE) * 0.15 * FAST)
    assert friction_torque(ENGINE) == pytest.approx(
        0.01 * steady_state(ENGINE, STANDARD, FAST).turbine_power / 0.99 / FAST
    )
    assert 0.0 <= cold.turbine < 0.4 * cold.compressor
    assert cold.surplus < 0.0


def test_the_rotor_has_the_energy_of_starter_and_turbine():
    """½ J Δω² = ∫ (P_starter + P_surplus) dt by trapezia: 1 % where starter and fuel come and go within steps."""
    made = run(0.05)
    gained = 0.5 * 0.06 * (made.speed[-1] ** 2 - made.speed[0] ** 2)
    assert np.trapezoid(made.starter + made.surplus, made.time) == pytest.approx(gained, rel=1e-2)
    assert made.starter[made.speed > 0.5 * FAST].max() == 0.0
    assert made.fuel[made.speed < 0.12 * FAST].max() == 0.0


def test_half_the_step_gives_the_same_start_and_less_torque_a_longer_and_hotter_one():
    assert run(0.05).time[-1] == pytest.approx(run().time[-1], abs=0.3)
    weak = run(torque=15.0)
    assert weak.time[-1] > 1.5 * run().time[-1]
    assert run().between.max() < weak.between.max() <= 1100.0 + 15.0


@pytest.mark.parametrize(
    ("rules", "said"),
    [
        (StartRules(3.0), "does not turn it to 0.12, where it lights; give more torque"),
        (StartRules(40.0, hottest=600.0, longest=20.0), "it hangs; give more torque, a higher cut, more fuel"),
        (StartRules(-1.0, cut=0.1, hottest=100.0), "(?s)torque: -1 N m.*cut: give light below cut.*hottest: 100 K"),
    ],
)
def test_what_does_not_start_is_told(rules, said):
    with pytest.raises(DesignError, match=said):
        engine_start(DESIGN, rules)
