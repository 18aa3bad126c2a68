"""Every compiled right-hand side agrees with the plain one."""

import numpy as np
from hypothesis import given, settings, strategies as st

from gearwright.dynamics.equations import WORKS, kernel, reference
from gearwright.dynamics.motion import stored_energy
from random_systems import random_system


@settings(max_examples=60)
@given(seed=st.integers(0, 2**32 - 1), bodies=st.integers(4, 12), lines=st.integers(1, 25), time=st.floats(-0.5, 1.5))
def test_generic_kernel_agrees_with_plain_numpy(seed, bodies, lines, time):
    """1e-12 of the largest term: both add the same numbers in another order."""
    arrays = random_system(seed, bodies, lines).arrays
    rng = np.random.default_rng(seed + 1)
    size = len(arrays.mass)
    state = np.concatenate([rng.normal(0.0, 0.1, size), rng.normal(0.0, 1.0, size), np.zeros(WORKS)])
    now, slope, output = kernel.empty_instant(arrays), np.zeros_like(state), np.zeros(2 * lines)
    kernel.set_instant(arrays, time, now)
    kernel.derivative(arrays, now, state, slope, output)
    plain = reference.line_state(arrays, time, state[:size], state[size : 2 * size])
    wanted = reference.acceleration(arrays, time, state[:size], state[size : 2 * size])
    scale = np.max(np.abs(plain.force)) * 1e-12
    np.testing.assert_allclose(output[:lines], plain.force, rtol=1e-12, atol=scale)
    np.testing.assert_allclose(output[lines:], plain.deflection, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(slope[size : 2 * size] * arrays.mass, wanted * arrays.mass, rtol=1e-12, atol=scale)
    assert np.array_equal(slope[:size], state[size : 2 * size])


@settings(max_examples=20)
@given(seed=st.integers(0, 2**32 - 1), time=st.floats(0.45, 0.65))
def test_powers_are_the_rates_of_the_energies(seed, time):
    """d(stored)/dt by central differences along the flow equals what the six powers add up to.

    Within one piece of the speed profile and the schedule. Differences over 2e-6 s leave about 1e-7 of the powers, and
    a contact that switches between them a little more.
    """
    arrays = random_system(seed).arrays
    rng = np.random.default_rng(seed + 1)
    size = len(arrays.mass)
    q, v = rng.normal(0.0, 0.1, size), rng.normal(0.0, 1.0, size)
    state, output = np.concatenate([q, v, np.zeros(WORKS)]), np.zeros(2 * len(arrays.stiffness))
    now, slope = kernel.empty_instant(arrays), np.zeros_like(state)
    kernel.set_instant(arrays, time, now)
    kernel.derivative(arrays, now, state, slope, output)
    driven, braked, dissipated, stiffness, error, frame = slope[2 * size :]
    power = driven - braked - dissipated + stiffness + error + frame
    assert np.isclose(power, _stored_rate(arrays, time, state, slope), rtol=1e-5, atol=1e-5 * (driven + braked + 1.0))


def _stored_rate(arrays, time, state, slope):
    dt = 1e-6
    ahead, behind = state + dt * slope, state - dt * slope
    return (stored_energy(arrays, time + dt, ahead) - stored_energy(arrays, time - dt, behind)) / (2.0 * dt)
