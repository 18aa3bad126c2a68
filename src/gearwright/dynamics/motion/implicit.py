"""Implicit steps for truly stiff systems: the generalized-α method with Newton's method on contact and stiffness.

Source: Chung, Hulbert 1993, J. Appl. Mech. 60, 371: second order, stable at any step, its high-frequency damping set by
ρ∞. It starts afresh at every block, so that a replay repeats itself.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.equations import kernel
from gearwright.dynamics.model import Arrays

RADIUS = 0.8
"""ρ∞: what is left of an unresolved vibration after each step [-]."""
NEWTON = 12
"""Rounds in which contact must settle within a step; what is left then shows in the error estimate."""
SETTLED = 1e-10
"""Change of acceleration over the largest at which Newton's method stops [-]."""


class Shares(NamedTuple):
    """By how much the unbalanced force changes with the acceleration at the end of a step."""

    damping: float
    """Through the velocity there [s]."""
    stiffness: float
    """Through the position there [s²]."""
    mass: float
    """Through the inertia force [-]."""


@compiled
def fill_tangent(arrays: Arrays, shares: Shares, damping: Floats, closed: Floats, tangent: Floats) -> None:
    """Fill the derivative of the unbalanced force by the acceleration."""
    for i in range(len(arrays.mass)):
        for j in range(len(arrays.mass)):
            tangent[i, j] = shares.damping * damping[i, j]
        tangent[i, i] += shares.mass * arrays.mass[i]
    for line in range(len(closed)):
        for a in range(arrays.line_start[line], arrays.line_start[line + 1]):
            for b in range(arrays.line_start[line], arrays.line_start[line + 1]):
                stiffness = arrays.line_weight[a] * arrays.line_weight[b] * closed[line]
                tangent[arrays.line_dof[a], arrays.line_dof[b]] += shares.stiffness * stiffness


@compiled
def touching_stiffness(arrays: Arrays, now: kernel.Instant, deflection: Floats, out: Floats) -> None:
    """Fill the stiffness of each line, nothing where it stands open."""
    for j in range(len(out)):
        open_ = arrays.backlash[j] > 0.0 and -arrays.backlash[j] <= deflection[j] <= 0.0
        out[j] = 0.0 if open_ else now.stiffness[j]


@compiled
def march(
    arrays: Arrays, now: kernel.Instant, first: int, h: float, damping: Floats, record: Floats, state: Floats
) -> None:
    """Advance by one step for each row of `record`, as `kernel.runge_kutta` does; `damping` of the whole system."""
    size, lines = len(arrays.mass), len(arrays.stiffness)
    am, af = (2.0 * RADIUS - 1.0) / (RADIUS + 1.0), RADIUS / (RADIUS + 1.0)
    gamma = 0.5 - am + af
    beta = 0.25 * (gamma + 0.5) ** 2
    shares = Shares(h * gamma, h * h * beta, (1.0 - am) / (1.0 - af))
    slope, ahead, trial = np.empty_like(state), np.empty_like(state), state.copy()
    output, closed, tangent = np.empty(2 * lines), np.empty(lines), np.empty((size, size))
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
            touching_stiffness(arrays, now, output[lines:], closed)
            fill_tangent(arrays, shares, damping, closed, tangent)
            change = np.linalg.solve(tangent, rest)
            guess += change
            if np.max(np.abs(change)) <= SETTLED * (np.max(np.abs(guess)) + 1e-300):
                break
        trial[2 * size :] = state[2 * size :] + 0.5 * h * (slope[2 * size :] + ahead[2 * size :])
        state[:], slope[:], inner[:] = trial, ahead, guess
