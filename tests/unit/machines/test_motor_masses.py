"""Masses of electric machines: the law of torque and speed, what stands beside a motor, the largest rotor."""

import math

import pytest

from gearwright.machines import (
    cooling_mass,
    inverter_mass,
    largest_power,
    motor_mass,
    motor_mass_ndarc,
)
from gearwright.units import RPM

MEGAWATT = 1005e3


def _weighed(power, rpm):
    return motor_mass(power / (rpm * RPM), rpm * RPM)


def test_a_motor_of_one_power_is_lighter_the_faster_it_turns_and_heavier_than_by_its_torque_alone():
    masses = [_weighed(MEGAWATT, rpm) for rpm in (1212, 4500, 10000, 20000)]
    assert masses == sorted(masses, reverse=True)
    fast = MEGAWATT / (20000 * RPM)
    assert _weighed(MEGAWATT, 20000) > 1.8 * motor_mass_ndarc(fast)


def test_no_motor_is_denser_than_the_densest_that_is_published():
    """25 kW/kg; at the largest speed of its power the law itself is below."""
    for power in (1e3, 1e4, 1e5, 1e6, 1e7):
        speed = math.sqrt(largest_power(1.0) / power)
        assert largest_power(speed) == pytest.approx(power)
        for rpm in (1000.0, speed / RPM, 4.0 * speed / RPM):
            assert power / _weighed(power, rpm) <= 25e3 * (1.0 + 1e-12)
    assert 20e3 < MEGAWATT / _weighed(MEGAWATT, 27000) < 25e3
    assert MEGAWATT / _weighed(MEGAWATT, 60000) == pytest.approx(25e3)


def test_inverter_and_cooling_grow_with_power_alone():
    """1005 kW over 12 kW/kg; 0.8 kg per kW of the nineteenth that is lost at 0.95."""
    assert inverter_mass(MEGAWATT) == pytest.approx(1005 / 12)
    assert inverter_mass(MEGAWATT, 19e3) == pytest.approx(1005 / 19)
    assert cooling_mass(MEGAWATT) == pytest.approx(0.8 * 1005 / 19)
    assert cooling_mass(MEGAWATT, 0.0) == 0.0


def test_the_largest_power_falls_with_the_square_of_the_speed_and_rises_with_the_cube_of_the_tips():
    """rpm √kW is 8.56e5 at 220 m/s: 7.3, 1.83 and 0.81 MW at 10 000, 20 000 and 30 000 rpm."""
    for rpm, megawatts in ((10000, 7.32), (20000, 1.83), (30000, 0.813)):
        power = largest_power(rpm * RPM)
        assert power == pytest.approx(megawatts * 1e6, rel=2e-3)
        assert rpm * math.sqrt(power / 1e3) == pytest.approx(8.56e5, rel=1e-3)
    assert largest_power(100.0, 110.0) == pytest.approx(largest_power(100.0) / 8.0)
