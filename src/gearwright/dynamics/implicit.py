"""Implicit steps for truly stiff systems: the generalized-α method with Newton's method on contact and stiffness.

Source: Chung, Hulbert 1993, J. Appl. Mech. 60, 371: second order, stable at any step, its high-frequency damping set by
ρ∞. It starts afresh at every block, so that a replay repeats itself.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from gearwright.dynamics import kernel
from gearwright.dynamics.linear import linear
from gearwright.dynamics.system import Arrays, Floats, line_matrix

RADIUS = 0.8
"""ρ∞: what is left of an unresolved vibration after each step [-]."""
NEWTON = 12
"""Rounds in which contact must settle within a step; what is left then shows in the error estimate."""
SETTLED = 1e-10
"""Change of acceleration over the largest at which Newton's method stops [-]."""


def tangent_parts(arrays: Arrays) -> tuple[Floats, Floats]:
    """Return the lines' weights as a matrix, and the damping matrix at the reference speeds.

    Args:
        arrays: The system's numbers.
    """
    return line_matrix(arrays), linear(arrays, float(arrays.profile.factor[0])).damping


def _touching_stiffness(arrays: Arrays, now: kernel.Instant, deflection: Floats, out: Floats) -> None:
    for j in range(len(out)):
        open_ = arrays.backlash[j] > 0.0 and -arrays.backlash[j] <= deflection[j] <= 0.0
        out[j] = 0.0 if open_ else now.stiffness[j]


_touching = njit(_touching_stiffness, cache=True, error_model="numpy")


def _march(
    arrays: Arrays,
    now: kernel.Instant,
    clock: tuple[int, float],
    parts: tuple[Floats, Floats],
    record: Floats,
    state: Floats,
) -> None:
    first, h = clock
    matrix, damping = parts
    size, lines = len(arrays.mass), len(arrays.stiffness)
    am, af = (2.0 * RADIUS - 1.0) / (RADIUS + 1.0), RADIUS / (RADIUS + 1.0)
    gamma = 0.5 - am + af
    beta = 0.25 * (gamma + 0.5) ** 2
    slope, ahead, trial = np.empty_like(state), np.empty_like(state), state.copy()
    output, closed = np.empty(2 * lines), np.empty(lines)
    kernel.set_instant(arrays, first * h, now)
    kernel.derivative(arrays, now, state, slope, output)
    inner = slope[size : 2 * size].copy()
    for row in range(len(record)):
        record[row, : 2 * size], record[row, 2 * size : 2 * (size + lines)] = state[: 2 * size], output
        kernel.set_instant(arrays, (first + row + 1) * h, now)
        guess = inner.copy()
        for _ in range(NEWTON):
            trial[:size] = state[:size] + h * (state[size : 2 * size] + h * ((0.5 - beta) * inner + beta * guess))
            trial[size : 2 * size] = state[size : 2 * size] + h * ((1.0 - gamma) * inner + gamma * guess)
            kernel.derivative(arrays, now, trial, ahead, output)
            wanted = ((1.0 - am) * guess + am * inner - af * slope[size : 2 * size]) / (1.0 - af)
            rest = arrays.mass * (ahead[size : 2 * size] - wanted)
            _touching(arrays, now, output[lines:], closed)
            tangent = h * gamma * damping + h * h * beta * (matrix.T @ (closed.reshape(lines, 1) * matrix))
            for i in range(size):
                tangent[i, i] += arrays.mass[i] * (1.0 - am) / (1.0 - af)
            change = np.linalg.solve(tangent, rest)
            guess += change
            if np.max(np.abs(change)) <= SETTLED * (np.max(np.abs(guess)) + 1e-300):
                break
        trial[2 * size :] = state[2 * size :] + 0.5 * h * (slope[2 * size :] + ahead[2 * size :])
        state[:], slope[:], inner[:] = trial, ahead, guess


march = njit(_march, cache=True, error_model="numpy")
"""(arrays, instant, (first step, h), (line matrix, damping), record, state): fills the record, carries the state on."""
