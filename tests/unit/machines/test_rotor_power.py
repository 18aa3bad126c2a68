"""Power of a rotor against closed forms of momentum theory."""

import math

import pytest

from gearwright.errors import DesignError
from gearwright.machines.rotors import Disc, Stream, induced_velocity, rotor_power

DISC = Disc(diameter=10.0, solidity=0.05, profile_drag=0.01, induced_factor=1.15)
HOVER = Stream(density=1.225, forward=0.0, climb=0.0, speed=42.5)
THRUST = 17e3
V_H = math.sqrt(THRUST / (2.0 * 1.225 * DISC.area))


def test_hover_is_rankines_and_froudes():
    assert induced_velocity(DISC, HOVER, THRUST) == pytest.approx(V_H, rel=1e-10)


@pytest.mark.parametrize("climb", [2.0, 10.0, -2.0])
def test_axial_climb_is_a_quadratic(climb):
    expected = -0.5 * climb + math.sqrt(0.25 * climb**2 + V_H**2)
    assert induced_velocity(DISC, HOVER._replace(climb=climb), THRUST) == pytest.approx(expected, rel=1e-10)


def test_fast_flight_is_a_wing_of_the_rotors_span():
    found = induced_velocity(DISC, HOVER._replace(forward=20.0 * V_H), THRUST)
    assert found == pytest.approx(V_H**2 / (20.0 * V_H), rel=1e-5)  # v = T/(2 ρ A V), but for v² in V²


def test_hover_power_is_induced_and_profile():
    tip = 0.5 * 42.5 * 10.0
    profile = 1.225 * DISC.area * tip**3 * 0.05 * 0.01 / 8.0
    assert rotor_power(DISC, HOVER, THRUST) == pytest.approx(1.15 * THRUST * V_H + profile, rel=1e-10)


def test_there_is_a_speed_of_least_power():
    powers = [rotor_power(DISC, HOVER._replace(forward=speed), THRUST) for speed in (0.0, 30.0, 90.0)]
    assert powers[1] < powers[0]
    assert powers[1] < rotor_power(DISC, HOVER._replace(forward=30.0), 1.1 * THRUST)
    slow, fast = (rotor_power(DISC, HOVER._replace(forward=speed), 1e-6) for speed in (0.0, 63.75))
    assert fast / slow == pytest.approx(1.0 + 4.65 * (63.75 / 212.5) ** 2)  # profile power grows with μ²


def test_a_slow_steep_descent_is_refused():
    with pytest.raises(DesignError, match="into its own wake"):
        induced_velocity(DISC, HOVER._replace(climb=-8.0), THRUST)
    assert induced_velocity(DISC, HOVER._replace(climb=-8.0, forward=40.0), THRUST) > 0.0
