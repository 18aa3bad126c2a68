"""Pacing: how finely a run goes, from what is asked, and what error that leaves over its first stretch."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import line_state, statics
from gearwright.dynamics.model import Arrays, System, line_matrix
from gearwright.dynamics.motion.record import BLOCK
from gearwright.dynamics.motion.steps.steppers import ADAPTIVE, RUNGE_KUTTA, blank_record, stepper
from gearwright.dynamics.motion.steps.stepsize import (
    Accuracy,
    Pace,
    accurate_pace,
    check_step,
    default_step,
    excited_step,
)
from gearwright.errors import DesignError, Problem

ATTEMPTS = 4
"""Times that the pace is made finer for an accuracy; contact that comes and goes converges slowly."""
TOLERANCE = 1e-5
"""Root of the energy in an adaptive step's error over that of the energy held: line forces within about 1e-4 [-]."""
STRETCH = 1000
"""Steps of the first stretch, repeated at half the step for the error estimate."""
SECOND_ORDER = 4.0 / 3.0
"""Error of a second-order step from the difference to two half steps [-]."""
RICHARDSON = 16.0 / 15.0
"""Error from the difference to a pace that makes a sixteenth of it [-]."""


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
    if isinstance(step, Accuracy):
        tried = pace_of(system, method, None, state)
        for _ in range(ATTEMPTS):
            error = estimated_error(arrays, method, tried, steps=STRETCH, start=state)
            if error <= step.value:
                break
            tried = accurate_pace(tried, error, step)
        return tried
    if step is None:
        step = excited_step(arrays) if method == "implicit" else default_step(arrays)
    elif method in RUNGE_KUTTA:
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


def estimated_error(arrays: Arrays, method: str, pace: Pace, *, steps: int, start: Floats) -> float:
    """Return the difference of line forces to those at a finer pace over the largest force [-].

    Args:
        arrays: The system's numbers.
        method: One of `METHODS`.
        pace: Of the run.
        steps: Rows to compare.
        start: q, q̇ and works at the start.
    """
    forces = []
    for tried in (pace, pace.finer()):
        pieces = round(pace.step / tried.step)
        advance, state = stepper(arrays, method, tried.step, tolerance=tried.tolerance), start.copy()
        record = blank_record(arrays, pieces * steps)
        for first in range(0, len(record), BLOCK):
            advance(first, record[first : first + BLOCK], state)
        columns = slice(2 * len(arrays.mass), 2 * len(arrays.mass) + len(arrays.stiffness))
        forces.append(record[::pieces, columns])
    largest = float(np.max(np.abs(forces[1]), initial=0.0))
    share = SECOND_ORDER if method == "implicit" else RICHARDSON
    return share * float(np.max(np.abs(forces[0] - forces[1]), initial=0.0)) / largest if largest else 0.0
