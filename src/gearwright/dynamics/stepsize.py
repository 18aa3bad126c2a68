"""Time step: what accuracy asks for and what stability allows."""

from __future__ import annotations

import numpy as np

from gearwright.dynamics.system import Arrays, Floats, entry_matrix, line_matrix, top_rate
from gearwright.errors import DesignError, Problem

STABLE = 2.78
"""Step times fastest rate up to which the classical fourth-order Runge–Kutta method is stable on either axis [-].

Source: Hairer, Wanner 1996, Solving Ordinary Differential Equations II, IV.2: 2.785 on the real axis, 2.828 on the
imaginary.
"""
COMFORTABLE = 1.0
"""The same for the default step: at 2.0 the fastest modes are stable but line forces off by 1e-2, at 1.0 by 1e-3."""
STEPS_PER_CYCLE = 6.0
"""Steps in a cycle of the highest harmonic: line forces within about 4e-4 (docs/theory/dynamics.md)."""
LARGEST_RUN = 1e10
"""Steps that one run may take: about an hour for a small train."""


def fastest_rate(arrays: Arrays) -> float:
    """Return a bound on the fastest rate |λ| of the system [rad/s], every stiffness at its top.

    Args:
        arrays: The system's numbers.

    Source:
        Energy bound of the damped system: |λ| ≤ d/2 + √(d²/4 + ω²), d the largest eigenvalue of the damping.
    """
    root = np.sqrt(arrays.mass)
    matrix = line_matrix(arrays) / root
    terms = np.hypot(arrays.variation.cosine, arrays.variation.sine)
    row = np.repeat(np.arange(len(arrays.stiffness)), np.diff(arrays.variation.start))
    swing = np.zeros(len(arrays.stiffness))
    np.add.at(swing, row, terms)
    square = _largest(matrix.T @ ((arrays.stiffness * (1.0 + swing))[:, None] * matrix))
    top = float(np.max(np.abs(arrays.profile.factor)))
    damping = matrix.T @ (arrays.damping[:, None] * matrix)
    damping += np.diag((arrays.loads.damping + 2.0 * arrays.loads.quadratic * np.abs(arrays.speed) * top) / arrays.mass)
    spin = entry_matrix(arrays.gyroscopic, len(root)) / np.outer(root, root) * top
    half = 0.5 * (_largest(damping) + float(np.linalg.norm(spin, 2)))
    return float(half + np.sqrt(half**2 + max(square, 0.0)))


def _largest(matrix: Floats) -> float:
    return float(np.linalg.eigvalsh(matrix)[-1])


def default_step(arrays: Arrays) -> float:
    """Return the step for explicit integration, h = min(1/(6 f_max), 1/λ_max) [s].

    Args:
        arrays: The system's numbers.
    """
    fastest, excited = fastest_rate(arrays), top_rate(arrays) / (2.0 * np.pi)
    stable = COMFORTABLE / fastest if fastest else np.inf
    return float(min(stable, 1.0 / (STEPS_PER_CYCLE * excited))) if excited else float(stable)


def check_step(arrays: Arrays, step: float) -> None:
    """Refuse a step at which explicit integration would blow up.

    Args:
        arrays: The system's numbers.
        step: [s].

    Raises:
        DesignError: Naming the step that would do.
    """
    fastest = fastest_rate(arrays)
    if not 0.0 < step * fastest <= STABLE:
        most, good = STABLE / fastest, default_step(arrays)
        message = f"{step:.3g} s is outside what is stable, 0 to {most:.3g} s; a step of {good:.3g} s would do"
        raise DesignError([Problem("step", message)])


def check_duration(duration: float, step: float) -> int:
    """Return the number of steps of a run.

    Args:
        duration: [s].
        step: [s].

    Raises:
        DesignError: If the duration is not positive, or so long that no one would wait for it.
    """
    if not 0.0 < duration < np.inf:
        raise DesignError([Problem("duration", f"{duration:g} s; it must be positive and finite")])
    if duration / step > LARGEST_RUN:
        message = f"{duration:.3g} s takes {duration / step:.2g} steps; at most {LARGEST_RUN * step:.3g} s at this step"
        raise DesignError([Problem("duration", message)])
    return max(1, round(duration / step))
