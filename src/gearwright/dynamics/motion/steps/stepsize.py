"""Time step: what accuracy asks for and what stability allows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model import CLUTCH, Arrays, entry_matrix, line_matrix, top_rate
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
IMPLICIT_STEPS_PER_CYCLE = 40.0
"""The same for the implicit second-order step."""
MARGIN = 0.9
"""What the step is shortened by, so that the error comes out below what was asked [-]."""
ROUNDING = 1e-11
"""Accuracy that rounding allows [-]."""
LARGEST_RUN = 1e10
"""Steps that one run may take: about an hour for a small train."""


class Pace(NamedTuple):
    """How finely a run goes."""

    step: float
    """Time step; for adaptive methods the spacing of the rows [s]."""
    tolerance: float = 0.0
    """Root of the energy that the error of one adaptive step may hold; 0 for fixed steps [√J]."""

    def finer(self) -> Pace:
        """Return the pace at which a fourth-order method makes a sixteenth of the error."""
        return self._replace(tolerance=self.tolerance / 16.0) if self.tolerance else Pace(0.5 * self.step)


@dataclass(frozen=True)
class Accuracy:
    """Asks for the step at which line forces are right to a share of the largest, as the first stretch shows."""

    value: float
    """Largest line-force error over the largest force [-]."""


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
    stiff, damped, slipping = _clutches(arrays, root)
    square, damping = square + _largest(stiff), damping + damped
    half = 0.5 * (_largest(damping) + _spin(arrays, root) * top)
    return max(slipping, float(half + np.sqrt(half**2 + max(square, 0.0))))


def _clutches(arrays: Arrays, root: Floats) -> tuple[Floats, Floats, float]:
    """Return stiffness and damping of clutches that stick, and the fastest rate k/c of one that slips [1/s]."""
    size, place, fastest, table = len(root), 2, 0.0, arrays.drives.table
    stiff, damped = np.zeros((2, size, size))
    while place < len(table):
        if table[place + 1] == CLUTCH:
            weight = np.zeros(size)
            first, second, (stiffness, damping) = int(table[place + 2]), int(table[place + 4]), table[place + 8 :][:2]
            weight[first], weight[second] = 1.0 / root[first], -1.0 / root[second]
            stiff += stiffness * np.outer(weight, weight)
            damped += damping * np.outer(weight, weight)
            fastest = max(fastest, float(stiffness / damping))
        place += int(table[place])
    return stiff, damped, fastest


def _spin(arrays: Arrays, root: Floats) -> float:
    """Return the norm of the gyroscopic terms at the reference speeds [rad/s]."""
    if len(arrays.gyroscopic.value) == 0:
        return 0.0
    return float(np.linalg.norm(entry_matrix(arrays.gyroscopic, len(root)) / np.outer(root, root), 2))


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


def excited_step(arrays: Arrays) -> float:
    """Return the step that resolves what excites, whatever the modes [s].

    Args:
        arrays: The system's numbers.

    Raises:
        DesignError: If nothing excites: then the step must be given.
    """
    excited = top_rate(arrays) / (2.0 * np.pi)
    if not excited:
        raise DesignError([Problem("step", "nothing in the system sets a time scale for implicit steps; give one")])
    return 1.0 / (IMPLICIT_STEPS_PER_CYCLE * excited)


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
        largest, good = STABLE / fastest, default_step(arrays)
        message = f"{step:.3g} s is outside what is stable, 0 to {largest:.3g} s; a step of {good:.3g} s would do"
        raise DesignError([Problem("step", message)])


def accurate_pace(pace: Pace, error: float, asked: Accuracy) -> Pace:
    """Return the pace that brings the error down to what is asked, never a coarser one.

    The error grows with the fourth power of a fixed step and in proportion to the tolerance of adaptive ones.

    Args:
        pace: That was tried.
        error: Its error [-].
        asked: Accuracy.

    Raises:
        DesignError: If the accuracy is not between rounding and one.
    """
    if not ROUNDING < asked.value < 1.0:
        raise DesignError([Problem("step", f"accuracy {asked.value:g}; it must lie between {ROUNDING:g} and 1")])
    room = asked.value / max(error, 1e-6 * asked.value)
    if pace.tolerance:
        return pace._replace(tolerance=pace.tolerance * min(1.0, MARGIN * room))
    return Pace(pace.step * min(1.0, MARGIN * float(np.sqrt(np.sqrt(room)))))


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
