"""Air and burnt gas: published enthalpies, inverses, expansions without loss."""

import math

import numpy as np
import pytest

from gearwright.machines.turboshaft import (
    AIR,
    GAS_CONSTANT,
    Breathing,
    Gas,
    enthalpy,
    entropy,
    exhaust_heat,
    exhaust_of,
    heat_capacity,
    isentropic,
    mixed,
    temperature_of,
)


@pytest.mark.parametrize(
    ("temperature", "printed"), [(400.0, 400.98), (600.0, 607.02), (1000.0, 1046.04), (1400.0, 1515.42)]
)
def test_enthalpy_of_air_is_that_of_the_tables(temperature, printed):
    """Moran and Shapiro, Fundamentals of Engineering Thermodynamics, table A-22, over the 300.19 kJ/kg at 300 K.

    2e-3: the polynomial is fitted to another set of data.
    """
    rise = enthalpy(AIR, temperature) - enthalpy(AIR, 300.0)
    assert rise / 1e3 == pytest.approx(printed - 300.19, rel=2e-3)


@pytest.mark.parametrize("gas", [AIR, Gas(0.02), Gas(0.04)])
@pytest.mark.parametrize("temperature", [200.0, 288.15, 900.0, 1700.0])
def test_inverse_and_slopes_belong_to_the_enthalpy(gas, temperature):
    assert temperature_of(gas, enthalpy(gas, temperature)) == pytest.approx(temperature, rel=1e-12)
    step = 1e-3
    slope = (enthalpy(gas, temperature + step) - enthalpy(gas, temperature - step)) / (2.0 * step)
    assert slope == pytest.approx(heat_capacity(gas, temperature), rel=1e-6)
    slope = (entropy(gas, temperature + step) - entropy(gas, temperature - step)) / (2.0 * step)
    assert slope == pytest.approx(heat_capacity(gas, temperature) / temperature, rel=1e-6)


def test_a_small_expansion_follows_the_perfect_gas():
    exponent = GAS_CONSTANT / heat_capacity(AIR, 300.0)
    assert isentropic(AIR, 300.0, 0.98) == pytest.approx(300.0 * math.pow(0.98, exponent), rel=1e-6)


def test_burnt_gas_holds_more_heat():
    assert heat_capacity(AIR, 1200.0) < heat_capacity(Gas(0.02), 1200.0) < heat_capacity(Gas(0.04), 1200.0)


def test_an_exhaust_carries_what_shaft_and_casing_leave():
    air, inlet, fuel, power = np.array([[8.0], [280.0], [0.16], [1.6e6]])
    left = exhaust_of(Breathing(10.0, 0.5, 0.01), air, inlet, fuel=fuel, power=power)
    assert exhaust_heat(left, inlet) + left.casing + 1.6e6 == pytest.approx(0.16 * 42.8e6, rel=1e-12)
    # by hand, with c_p = 1.10 kJ/(kg K) between 280 and 800 K: (0.16 * 42.8e6 * 0.99 - 1.6e6)/(8.16 * 1100)
    assert left.temperature - 280.0 == pytest.approx((0.16 * 42.8e6 * 0.99 - 1.6e6) / (8.16 * 1100.0), rel=0.03)


def test_mixed_exhausts_lose_nothing():
    breathing, cold = Breathing(10.0, 0.5, 0.02), np.array([250.0])
    flows = [exhaust_of(breathing, air, cold, fuel=fuel, power=power) for air, fuel, power in
             np.array([[[9.0], [0.2], [2e6]], [[5.0], [0.07], [3e5]], [[6.0], [0.0], [0.0]]])]  # fmt: skip
    whole = mixed(flows)
    assert exhaust_heat(whole, cold) == pytest.approx(sum(exhaust_heat(flow, cold) for flow in flows), rel=1e-12)
    assert flows[1].temperature < whole.temperature < flows[0].temperature
    assert mixed(flows[2:]).temperature == 250.0
