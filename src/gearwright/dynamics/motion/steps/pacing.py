"""Pacing: how finely a run goes, from what is asked, by fixed steps and by adaptive ones."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import line_state, statics
from gearwright.dynamics.model import System, line_matrix
from gearwright.dynamics.motion.steps.steppers import ADAPTIVE, RUNGE_KUTTA
from gearwright.dynamics.motion.steps.stepsize import (
    AIM,
    Accuracy,
    Pace,
    check_step,
    default_step,
    excited_step,
)
from gearwright.errors import DesignError, Problem

TOLERANCE = 1e-5
"""Root of the energy in an adaptive step's error over that of the energy held: line forces within about 1e-4 [-]."""
TOLERANT = 1e-3
"""Error of line forces at that tolerance, with room [-]."""


def pace_of(system: System, method: str, step: float | Accuracy | None, state: Floats) -> Pace:
    """Return how finely a run goes.

    Args:
        system: Bodies, lines, loads.
        method: One of `METHODS`.
        step: As in `simulate`.
        state: q, q̇ and works at the start.

    Raises:
        DesignError: If the step cannot be, with the one that would do.
    """
    arrays = system.arrays
    if step is None or isinstance(step, Accuracy):
        asked = step or Accuracy()
        step = excited_step(arrays) if method == "implicit" else default_step(arrays, asked)
        share = min(1.0, AIM * asked.value / TOLERANT)
        return Pace(step, share * _tolerance(system, state) if method in ADAPTIVE else 0.0)
    if method in RUNGE_KUTTA:
        check_step(arrays, step)
    elif not 0.0 < step < np.inf:
        raise DesignError([Problem("step", f"{step:g} s; it must be positive and finite")])
    return Pace(step, _tolerance(system, state) if method in ADAPTIVE else 0.0)


def _tolerance(system: System, state: Floats) -> float:
    """Return the tolerance of adaptive steps: a share of the energy that loads, errors, slip and the start hold."""
    arrays, size = system.arrays, len(system.arrays.mass)
    position, velocity = state[:size], state[size : 2 * size]
    at_rest = statics(system, balance="accelerate").position
    states = (line_state(arrays, 0.0, where, 0.0 * where) for where in (position, at_rest))
    energy = max(float(np.sum(lines.stiffness * lines.contact**2)) for lines in states)
    mobility = np.sum(line_matrix(arrays) ** 2 / arrays.mass, axis=1)
    slipping = float(np.sum((arrays.profile.factor[0] * arrays.slip) ** 2 / mobility))
    energy = 0.5 * (energy + float(np.sum(arrays.mass * velocity**2)) + slipping)
    if not energy > 0.0:
        message = "tsit5 measures its error by the energy of loads, errors and start; there is none: use runge-kutta"
        raise DesignError([Problem("method", message)])
    return TOLERANCE * float(np.sqrt(energy))
