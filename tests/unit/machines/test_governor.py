"""The pitch governor: steady errors, stops, wind-up, rate, overshoot and limit cycles."""

import math

import numba
import numpy as np
import pytest

from gearwright.machines import Governor, GovernorState, Rotor, governor_rates, limit_cycle
from governed_rotor import governed_response

DEGREE = math.pi / 180.0
THESIS = Governor(0.70, 20.0 * DEGREE, 0.0, 0.1, 0.0, 0.5, 0.9, 1.0)
ROTOR = Rotor(100.0, -200.0, 60e3, 0.72)


def test_the_thesiss_governor_leaves_a_speed_error():
    """Pulvirenti 2023, §3.4: 20 deg/(rad/s), so two degrees of pitch stand for 0.1 rad/s.

    At rest the pitch is β_ref - K_p e and I ω̇ = s w - q (β - β_0) = 0; solved by hand; 1e-6 after 200 time constants.
    """
    _, speed, _ = governed_response(THESIS, ROTOR, 0.0, duration=20.0, step=5e-3)
    s, q, k = ROTOR.speed_slope, ROTOR.pitch_slope, THESIS.proportional
    assert speed[-1] == pytest.approx(q * (THESIS.reference - ROTOR.pitch) / (s - q * k), rel=1e-6)
    assert speed[-1] > 0.0


def test_integral_action_takes_the_speed_error_away():
    governor = THESIS._replace(integral=0.5)
    _, speed, pitch = governed_response(governor, ROTOR, 0.5, duration=20.0, step=5e-3)
    assert abs(speed[-1]) < 1e-6
    assert pitch[-1] == pytest.approx(ROTOR.pitch, abs=1e-6)


def test_the_integral_does_not_wind_up_against_a_stop():
    governor = THESIS._replace(integral=0.5)
    slow = GovernorState(governor.lower, 0.0, 10.0)
    assert governor_rates(governor, slow, 1.0).error_sum == 0.0
    assert governor_rates(governor, slow, -1.0).error_sum == -1.0


def test_a_slow_propeller_gets_less_pitch_down_to_the_stop():
    """An actuator of first order moves by what is missing of the command over its time constant."""
    governor, pitch = THESIS._replace(rate=100.0), 0.72
    for error, command in ((0.1, 0.70 - 2.0 * DEGREE), (10.0, THESIS.lower), (-10.0, THESIS.upper)):
        moving = governor_rates(governor, GovernorState(pitch, 0.0, 0.0), error).pitch
        assert pitch + moving * governor.time_constant == pytest.approx(command)


def test_the_pitch_moves_no_faster_than_its_rate():
    governor = THESIS._replace(rate=0.02)
    _, _, pitch = governed_response(governor, ROTOR, 1.0, duration=1.0)
    assert np.abs(np.diff(pitch)).max() <= 0.02 * 1e-3 * (1.0 + 1e-9)


def test_an_actuator_of_second_order_overshoots_and_one_of_first_order_does_not():
    """A free actuator (no propeller): overshoot exp(-π ζ/√(1-ζ²)); 1e-3 for the step of the integration."""
    alone = Rotor(1e12, 0.0, 0.0, 0.6)
    first = THESIS._replace(proportional=0.0, rate=100.0)
    second = first._replace(damping=0.5)
    _, _, plain = governed_response(first, alone, 0.0, duration=3.0)
    _, _, swung = governed_response(second, alone, 0.0, duration=3.0)
    assert plain.max() <= first.reference
    overshoot = (swung.max() - first.reference) / (first.reference - alone.pitch)
    assert overshoot == pytest.approx(math.exp(-math.pi * 0.5 / math.sqrt(0.75)), abs=1e-3)


def test_too_high_a_gain_limit_cycles_with_the_frequency_of_the_loop():
    """Second-order actuator: the third-order loop is unstable by Hurwitz; the rate limit bounds it."""
    hot = THESIS._replace(proportional=2.0, damping=0.3, rate=0.3, reference=ROTOR.pitch)
    time, speed, _ = governed_response(hot, ROTOR, 0.5, duration=20.0, step=2e-3)
    found = limit_cycle(time, speed)
    assert found is not None
    turns = np.abs(np.fft.rfft(speed[5000:] - speed[5000:].mean()))
    assert found.frequency == pytest.approx(turns.argmax() / 10.0, abs=0.1)


def test_a_governor_that_comes_to_rest_has_no_limit_cycle():
    time, speed, _ = governed_response(THESIS, ROTOR, 0.5, duration=10.0, step=2e-3)
    assert limit_cycle(time, speed) is None


def test_a_compiled_kernel_runs_the_same_governor():
    compiled = numba.njit(governor_rates)
    for governor in (THESIS, THESIS._replace(damping=0.4, integral=0.2)):
        state = GovernorState(0.8, 0.1, 0.3)
        assert tuple(compiled(governor, state, 0.2)) == pytest.approx(tuple(governor_rates(governor, state, 0.2)))
