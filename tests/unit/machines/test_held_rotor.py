"""A governor on N2: rest stays rest, droop by hand, the integral takes it away, energy of the rotor, limits."""

import math

import numpy as np
import pytest

from gearwright.machines.gas_generator import FuelControl, RotorGovernor, at_rest, held_rotor, turbine_torque
from gearwright.machines.turboshaft import Inlet, Rated, engine_of, state_for
from gearwright.units import HORSEPOWER, POUND

STANDARD = Inlet(288.15, 101325.0, 101325.0)
ENGINE = engine_of(
    Rated(1120.0 * HORSEPOWER, 644.0 * POUND / 3600.0, 7.9568 * POUND, 9.0, 0.81, 0.86, inertia=0.06, speed=4500.0)
)
"""The design point of NASA Aviary's turboshaft_1120hp; its pressure ratio and efficiencies are assumptions."""
FUEL = ENGINE.rated.fuel_flow / (9.0 * 101325.0)
CONTROL = FuelControl(3e-4, 3e-4, 0.05, 4590.0, 1200.0, 1.2 * FUEL, 0.2 * FUEL)
N2 = 2000.0
LOW, HIGH = 400.0 * HORSEPOWER, 700.0 * HORSEPOWER
GUESS = (4200.0, 1200.0)


def rotor(integral, load, gain=2.0, times=(12.0, 0.02), highest=math.inf):
    """Return a rotor that begins with 400 hp, and takes a load."""
    speed, state = state_for(ENGINE, STANDARD, LOW, GUESS)
    start = at_rest(ENGINE, STANDARD, speed, state, CONTROL)
    governor = RotorGovernor(2.0, N2, gain, integral, highest)
    return held_rotor(ENGINE, CONTROL, governor, STANDARD, start=start, load=load, times=times)


def stepped(time, speed):
    del speed
    return (HIGH if time > 0.5 else LOW) / N2


def test_what_is_at_rest_stays():
    held = rotor(1.0, lambda time, speed: LOW / N2, times=(1.0, 0.02))
    assert held.rotor == pytest.approx(np.full(51, N2), rel=1e-9)


def test_without_an_integral_the_rotor_droops_by_the_speed_that_the_gas_generator_must_gain():
    """K_p (N2_0 - N2) = N1 of the power that the torque asks for at that N2, less N1 at first: 1 % of the droop."""
    held = rotor(0.0, stepped)
    droop = N2 - held.rotor[-1]
    power = HIGH
    for _ in range(6):
        gas = state_for(ENGINE, STANDARD, power, GUESS)[1]
        power = HIGH - (gas.air_flow + gas.fuel_flow) * ENGINE.power_efficiency * ENGINE.drop * droop / N2
    gained = state_for(ENGINE, STANDARD, power, GUESS)[0] - state_for(ENGINE, STANDARD, LOW, GUESS)[0]
    assert droop == pytest.approx(gained / 2.0, rel=1e-2)
    assert droop > 10.0


def test_an_integral_brings_the_speed_back():
    held = rotor(2.0, stepped, times=(20.0, 0.02))
    assert held.rotor.min() < N2 - 10.0
    assert held.rotor[-1] == pytest.approx(N2, rel=1e-3)
    assert held.torque[-1] * N2 == pytest.approx(HIGH, rel=1e-2)


def test_the_rotors_energy_is_the_work_of_turbine_and_load():
    """½ J Δω² = ∫ (T - Q) ω dt by trapezia: 1e-3 of the energy that goes over, steps of 0.02 s."""
    held = rotor(0.0, stepped, times=(3.0, 0.02))
    work = np.trapezoid((held.torque - held.load) * held.rotor, held.time)
    gained = 0.5 * 2.0 * (held.rotor[-1] ** 2 - N2**2)
    assert work == pytest.approx(gained, rel=3e-2)


def test_the_limits_hold_and_a_load_beyond_the_engine_slows_the_rotor():
    held = rotor(2.0, lambda time, speed: (1500.0 * HORSEPOWER if time > 0.5 else LOW) / N2, times=(2.0, 0.02))
    assert held.speed.max() <= CONTROL.highest_speed
    assert held.between.max() <= CONTROL.hottest + 15.0
    assert held.rotor[-1] < 0.92 * N2


def test_beyond_the_limit_of_n2_the_least_fuel_flows():
    """A load that goes away: the fuel of deceleration, and less overspeed than the governor leaves alone."""
    free, cut = (rotor(2.0, lambda time, speed: 0.0, 0.5, (1.5, 0.02), highest) for highest in (math.inf, 1.03 * N2))
    above = np.flatnonzero(cut.rotor[:-1] >= 1.03 * N2)[5:]  # once the valve has followed
    assert len(above) and np.all(cut.fuel[above + 1] < 0.8 * free.fuel[above + 1])
    assert cut.rotor[-1] < free.rotor[-1] - 5.0


def test_the_power_of_a_free_turbine_is_greatest_where_its_blades_suit_the_gas():
    """At the design point at its speed; with slower gas at √(Δh/Δh_0) of it, by the parabola of η."""
    for power, peak in ((1120.0 * HORSEPOWER, 1.0), (LOW, None)):
        gas = state_for(ENGINE, STANDARD, power, GUESS)[1]
        caught = (gas.air_flow + gas.fuel_flow) * ENGINE.power_efficiency * ENGINE.drop
        best = 0.5 * (power / caught + 1.0)
        assert peak is None or best == pytest.approx(peak, rel=1e-9)
        assert turbine_torque(ENGINE, gas, N2, N2) * N2 == pytest.approx(power)
        powers = [turbine_torque(ENGINE, gas, y * best * N2, N2) * y * best for y in (0.95, 1.0, 1.05)]
        assert max(powers) == powers[1]
