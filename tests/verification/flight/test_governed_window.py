"""Propeller, governor and rigid train: stability by Hurwitz, rest by hand, and the mission's own equilibrium."""

import math
from functools import cache

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.machines import Governor
from gearwright.mission import governed_window, rotor_at, trim_at
from shipped_work import flown

DEGREE = math.pi / 180.0


@cache
def trim():
    """Return the equilibrium in cruise."""
    return trim_at(flown(), 2000.0)


def governor(gain, time_constant, damping, integral=0.0):
    """Return a governor around the equilibrium; gain in deg/(rad/s)."""
    around = (trim().pitch - 0.2, trim().pitch + 0.2, 10.0 * DEGREE)
    return Governor(trim().pitch, gain * DEGREE, integral, time_constant, damping, *around)


def critical_gain(time_constant, damping):
    """Return the gain [deg/(rad/s)] at which (J s + a)(τ² s² + 2 ζ τ s + 1) + q K = 0 meets the imaginary axis."""
    rotor = rotor_at(trim())
    inertia, damping_torque, pitch_slope = rotor.inertia, -rotor.speed_slope, rotor.pitch_slope
    a3 = inertia * time_constant**2
    a2 = 2.0 * damping * time_constant * inertia + damping_torque * time_constant**2
    a1 = inertia + 2.0 * damping * time_constant * damping_torque
    return (a2 * a1 / a3 - damping_torque) / pitch_slope / DEGREE


def test_the_window_starts_where_the_mission_flies():
    """Both read one map: torque times speed is the mission's propeller power; 1e-9 is rounding."""
    k = int(np.argmin(np.abs(flown().history.time - 2000.0)))
    assert trim().torque(trim().speed, trim().pitch) * trim().speed == pytest.approx(
        flown().history.propeller_power[k], rel=1e-9
    )
    still = governed_window(trim(), governor(1.0, 0.1, 0.0), duration=0.5)
    assert np.ptp(still.speed) < 1e-9 * trim().speed


@pytest.mark.parametrize("time_constant", [0.05, 0.1])
def test_a_governor_limit_cycles_beyond_the_gain_of_hurwitz_and_rests_below_it(time_constant):
    """Routh and Hurwitz on the linear loop; 25 % to either side, as the map is not linear."""
    limit = critical_gain(time_constant, 0.7)
    below = governed_window(trim(), governor(0.75 * limit, time_constant, 0.7), duration=15.0, torque_step=-0.05)
    above = governed_window(trim(), governor(1.25 * limit, time_constant, 0.7), duration=15.0, torque_step=-0.05)
    assert below.limit_cycle is None
    assert above.limit_cycle is not None


def test_the_thesiss_gain_rests_with_a_first_order_actuator_and_cycles_with_a_second_order_one():
    """K_p = 20 deg/(rad/s), Pulvirenti 2023, §3.4; τ = 0.1 s and ζ = 0.7 are assumed. Frequency: digit of the docs."""
    first = governed_window(trim(), governor(20.0, 0.1, 0.0), duration=10.0, torque_step=-0.1)
    second = governed_window(trim(), governor(20.0, 0.1, 0.7), duration=10.0, torque_step=-0.1)
    assert first.limit_cycle is None
    assert second.limit_cycle is not None
    assert second.limit_cycle.frequency == pytest.approx(2.1, abs=0.05)


def test_a_motor_cut_leaves_the_proportional_governor_slow_and_the_integral_one_on_speed():
    """At rest Q(ω, β_ref - K_p e) = drive; 1e-4 rad/s after 20 s for the integral's slow mode."""
    held = governed_window(trim(), governor(5.0, 0.1, 0.0), duration=10.0, torque_step=-0.1)
    error = trim().speed - held.speed[-1]
    drive = 0.9 * trim().torque(trim().speed, trim().pitch)
    assert error > 0.05
    assert trim().torque(trim().speed - error, trim().pitch - 5.0 * DEGREE * error) == pytest.approx(drive, rel=1e-6)
    exact = governed_window(trim(), governor(5.0, 0.1, 0.0, integral=0.2), duration=20.0, torque_step=-0.1, step=5e-3)
    assert exact.speed[-1] == pytest.approx(trim().speed, abs=1e-4)


def test_a_window_that_leaves_the_map_says_so():
    with pytest.raises(DesignError, match="lie outside the map"):
        governed_window(trim(), governor(1.0, 0.1, 0.0), duration=10.0, torque_step=-0.95)


def test_schedules_have_no_governor():
    rotor = flown("face-gear-split-torque", "rotor-schedule")
    with pytest.raises(DesignError, match="a governor needs a map"):
        trim_at(rotor, 10.0)
