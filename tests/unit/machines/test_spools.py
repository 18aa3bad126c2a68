"""A turboshaft of two spools: its books, a published deck's part load, a spool's linear limit, limits held."""

import functools
import math

import numpy as np
import pytest

from gearwright.machines.gas_generator import FuelControl, at_rest, fuelled, spool, time_constant
from gearwright.machines.turboshaft import (
    Gas,
    Inlet,
    Rated,
    engine_of,
    entering,
    enthalpy,
    leaving,
    state_for,
    steady_state,
)
from gearwright.units import HORSEPOWER, POUND

POUND_PER_HOUR = POUND / 3600.0
STANDARD = Inlet(288.15, 101325.0, 101325.0)


@functools.cache
def engine(power=1120.0, fuel=644.0, air=7.9568, ratio=9.0):
    """The design point of NASA Aviary's turboshaft_1120hp deck; its pressure ratio and efficiencies are assumptions."""
    return engine_of(
        Rated(
            power=power * HORSEPOWER, fuel_flow=fuel * POUND_PER_HOUR, air_flow=air * POUND, pressure_ratio=ratio,
            compressor=0.81, turbine=0.86, inertia=0.06, speed=4500.0,
        )
    )  # fmt: skip


@functools.cache
def half():
    return state_for(engine(), STANDARD, 560.0 * HORSEPOWER, (4200.0, 1200.0))


def imbalance(state, inlet):
    """Energy of the whole engine, every term by its own component, over what enters."""
    left = leaving(state) + state.power + state.casing + state.unburnt + state.surplus
    return (entering(state, inlet) - left) / entering(state, inlet)


@pytest.mark.parametrize(("speed", "hot"), [(4500.0, 1400.0), (3600.0, 1000.0), (4000.0, 1500.0), (4300.0, 900.0)])
def test_components_close_the_engine_also_when_it_spools(speed, hot):
    from gearwright.machines.turboshaft import state_at

    for inlet in (STANDARD, Inlet(193.0, 3e4, 2.6e4)):
        assert abs(imbalance(state_at(engine(), inlet, speed, hot), inlet)) < 1e-9


def test_the_design_point_comes_back():
    state = steady_state(engine(), STANDARD, 4500.0)
    rated = engine().rated
    assert state.power == pytest.approx(rated.power, rel=1e-9)
    assert state.fuel_flow == pytest.approx(rated.fuel_flow, rel=1e-9)
    assert state.pressure_ratio == pytest.approx(9.0, rel=1e-9)
    assert 0.6 < engine().power_efficiency < 0.95  # its tailpipe wants some of the pressure


def test_a_power_turbine_at_one_speed_takes_what_its_blades_catch():
    """η/η_0 = x (2 - x), x = √(Δh_0/Δh): by hand from the state of a third of the power."""
    _, state = state_for(engine(), STANDARD, 370.0 * HORSEPOWER, (4000.0, 1100.0))
    gas = Gas(0.995 * state.fuel_flow / state.air_flow)
    flow = state.air_flow + state.fuel_flow
    taken = enthalpy(gas, state.between) - enthalpy(gas, state.exhaust)
    assert flow * taken == pytest.approx(state.power, rel=1e-9)
    ideal = (taken / engine().power_efficiency + engine().drop) ** 2 / (4.0 * engine().drop)
    x = math.sqrt(engine().drop / ideal)
    assert taken / ideal == pytest.approx(engine().power_efficiency * x * (2.0 - x), rel=1e-12)
    assert 1.1 < x < 1.6


def test_scaled_air_scales_the_engine():
    """Similarity: half the pressure at the same temperatures halves flows and powers."""
    full = steady_state(engine(), STANDARD, 4300.0)
    thin = steady_state(engine(), Inlet(288.15, 0.5 * 101325.0, 0.5 * 101325.0), 4300.0)
    for name in ("air_flow", "fuel_flow", "power", "compressor_power"):
        assert getattr(thin, name) == pytest.approx(0.5 * getattr(full, name), rel=1e-8)
    assert thin.between == pytest.approx(full.between, rel=1e-8)


def test_a_small_step_of_fuel_is_followed_with_the_linear_time_constant():
    """e^(-t/τ), τ = -J N1/(dP/dN1): 0.1 % more fuel; 1e-2 (6e-3 found) for what is not linear, and steps of 0.05 s."""
    speed, state = half()
    tau = time_constant(engine(), STANDARD, speed, state)
    assert 0.2 < tau < 1.0
    open_loop = FuelControl(0.0, 1e-12, 1e-6, 1e9, 1e9, 1.0, 0.0)
    start = at_rest(engine(), STANDARD, speed, state, open_loop)
    start = start._replace(integral=1.001 * state.fuel_flow / 1e-12)
    run = spool(engine(), open_loop, STANDARD, start=start, demand=lambda time: speed, times=(2.5, 0.05))
    gained = run.speed - speed
    exact = gained[-1] / (1.0 - math.exp(-2.5 / tau)) * (1.0 - np.exp(-run.time / tau))
    assert gained == pytest.approx(exact, abs=1e-2 * gained[-1])


def test_a_slam_keeps_the_limits():
    speed, state = state_for(engine(), STANDARD, 200.0 * HORSEPOWER, (3600.0, 1000.0))
    hottest = steady_state(engine(), STANDARD, 4500.0).between
    fuel_over_pressure = engine().rated.fuel_flow / (9.0 * 101325.0)
    control = FuelControl(3e-4, 3e-4, 0.05, 4590.0, hottest, 0.95 * fuel_over_pressure, 0.3 * fuel_over_pressure)
    start = at_rest(engine(), STANDARD, speed, state, control)
    run = spool(engine(), control, STANDARD, start=start, demand=lambda time: 4400.0, times=(4.0, 0.05))
    assert run.power[-1] > 3.0 * run.power[0]
    assert run.speed.max() < 4590.0
    assert run.fuel_over_pressure.max() <= control.accelerating * (1.0 + 0.02)
    assert run.between.max() <= hottest + 5.0
    assert run.fuel_over_pressure.max() >= 0.9 * control.accelerating  # it was at the schedule


@pytest.mark.parametrize("power", [1800.0, 5000.0])
def test_beyond_its_ceiling_an_engine_says_so(power):
    thin = Inlet(230.0, 2e4, 1.8e4)
    with pytest.raises(ValueError, match="kW are beyond what it gives at rest in this air"):
        state_for(engine(), thin, power * HORSEPOWER, (4300.0, 1250.0))


def test_more_fuel_than_the_gas_bears_is_refused():
    with pytest.raises(ValueError, match="2000 K"):
        fuelled(engine(), STANDARD, 3000.0, 0.3, 1200.0)
