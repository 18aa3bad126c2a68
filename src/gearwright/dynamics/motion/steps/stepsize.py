"""Time step: what accuracy asks for and what stability allows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import damped_rates
from gearwright.dynamics.model import CLUTCH, LARGE, Arrays, entry_matrix, line_matrix, planned, top_rate
from gearwright.dynamics.motion.steps.bounds import damping_bound, rate_bound
from gearwright.errors import DesignError, Problem

STABLE = 2.78
"""Step times fastest rate up to which the classical fourth-order Runge–Kutta method is stable on either axis [-].

Source: Hairer, Wanner 1996, Solving Ordinary Differential Equations II, IV.2: 2.785 on the real axis, 2.828 on the
imaginary.
"""
COMFORTABLE = 1.0
"""The same for the default step: at 2.0 the fastest modes are stable but line forces off by 1e-2, at 1.0 by 1e-3."""
STEPS_PER_CYCLE = 6.0 + 0.5 * (5.0**0.5 - 1.0)
"""Steps in a cycle of the highest harmonic: no fraction of whole numbers, so that peaks are met in every phase."""
EXCITED = 1.25
"""Rate of a mode over the highest harmonic's up to which it may ring: stiffness and contact shift both [-]."""
AIM = 0.25
"""Share of the error that is asked which the step aims at, so that the measured one, which is larger, holds too [-]."""
LEAST_DAMPING = 1e-3
"""Damping ratio that modes without damping are taken to have: no force settles there, whatever the step [-]."""
IMPLICIT_STEPS_PER_CYCLE = 40.0
"""The same for the implicit second-order step."""
MARGIN = 0.8
"""What the step is shortened by, so that the error comes out below what was asked [-]."""
ROUNDING = 1e-11
"""Accuracy that rounding allows [-]."""
SEEN = 2.5
"""Highest harmonic's rate times the step below which it is still followed: half a cycle is 3.14 [-]."""
RMS_SHARE = 0.1
"""Error allowed in the root mean square over that allowed in peaks [-]."""
LARGEST_RUN = 1e10
"""Steps that one run may take: about an hour for a small train."""

_top_rate = planned(top_rate)


class Pace(NamedTuple):
    """How finely a run goes."""

    step: float
    """Time step; for adaptive methods the spacing of the rows [s]."""
    tolerance: float = 0.0
    """Root of the energy that the error of one adaptive step may hold; 0 for fixed steps [√J]."""

    def times(self, factor: float) -> Pace:
        """Return a coarser pace, or with a factor below one a finer: a fourth-order method errs by its fourth power.

        Args:
            factor: On the step [-].
        """
        return Pace(self.step * factor, self.tolerance * factor**4)

    def over(self, other: Pace) -> float:
        """Return this pace over another, as the factor that `times` would take [-].

        Args:
            other: Of the same method.
        """
        return self.step / other.step


@dataclass(frozen=True)
class Accuracy:
    """Asks for forces: the peak of every line right to a share of it, its root mean square to a tenth of that share.

    A line that carries next to nothing is judged beside the others of its kind.
    """

    value: float = 0.01
    """Largest error of a peak over the peak [-]."""

    def __post_init__(self) -> None:
        if not isinstance(self.value, float | int) or not ROUNDING < self.value < 1.0:
            message = f"accuracy {self.value}; it must be a number between {ROUNDING:g} and 1"
            raise DesignError([Problem("step", message)])


@planned
def fastest_rate(arrays: Arrays) -> float:
    """Return a bound on the fastest rate |λ| of the system [rad/s], every stiffness at its top.

    Args:
        arrays: The system's numbers.

    Source:
        Energy bound of the damped system: |λ| ≤ d/2 + √(d²/4 + ω²), d the largest eigenvalue of the damping.
    """
    if len(arrays.mass) > LARGE:
        return rate_bound(arrays)
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


@planned
def default_step(arrays: Arrays, asked: Accuracy = Accuracy()) -> float:
    """Return the step for explicit integration [s]: for the harmonics, the fastest mode, and modes that may ring.

    Args:
        arrays: The system's numbers.
        asked: Accuracy of the forces.
    """
    fastest, excited = fastest_rate(arrays), _top_rate(arrays)
    stable = COMFORTABLE / fastest if fastest else np.inf
    return float(min(stable, 2.0 * np.pi / (STEPS_PER_CYCLE * excited), _ringing_step(arrays, excited, asked))
                 if excited else stable)  # fmt: skip


def _ringing_step(arrays: Arrays, excited: float, asked: Accuracy) -> float:
    """Return the step at which modes that the harmonics may meet ring as their physical damping lets them.

    A step shifts a mode by (ω h)⁴/120 and damps it by (ω h)⁵/144, which moves a force on the flank of a resonance
    by up to the shift over 2 ζ.

    Source: amplification of the classical fourth-order method, e^z (1 − z⁵/120 + z⁶/144 …), at z = i ω h.
    """
    if len(arrays.mass) > LARGE:
        fastest = min(EXCITED * excited, fastest_rate(arrays))
        least = max(damping_bound(arrays, fastest), LEAST_DAMPING)
        return float((240.0 * AIM * asked.value * least) ** 0.25 / fastest)
    slowest, quickest = float(np.min(arrays.profile.factor)), float(np.max(arrays.profile.factor))
    step = np.inf
    for factor in {slowest, quickest}:
        rate = damped_rates(arrays, factor)
        rings = rate[np.abs(rate) <= EXCITED * excited]
        damping = np.maximum(-rings.real / np.abs(rings), LEAST_DAMPING)
        step = min(step, float(np.min((240.0 * AIM * asked.value * damping) ** 0.25 / np.abs(rings), initial=np.inf)))
    return step


def excited_step(arrays: Arrays) -> float:
    """Return the step that resolves what excites, whatever the modes [s].

    Args:
        arrays: The system's numbers.

    Raises:
        DesignError: If nothing excites: then the step must be given.
    """
    excited = _top_rate(arrays) / (2.0 * np.pi)
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


def whole_step(duration: float, step: float) -> float:
    """Return the largest step that is not larger and cuts the duration into an even number [s].

    Args:
        duration: [s].
        step: [s].

    Raises:
        DesignError: If the duration cannot be.
    """
    check_duration(duration, step)
    return duration / (2.0 * float(np.ceil(0.5 * duration / step * (1.0 - ROUNDING))))


def may_take(arrays: Arrays, method: str, pace: Pace) -> bool:
    """Tell whether steps at a pace would neither blow up nor miss what excites.

    Args:
        arrays: The system's numbers.
        method: One of `METHODS`.
        pace: How finely.
    """
    met = _top_rate(arrays) * pace.step < SEEN
    return met and ("runge-kutta" not in method or pace.step * fastest_rate(arrays) <= MARGIN * STABLE)


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
