"""Variation: how motions beside a periodic one go, which decides whether it is stable.

A disturbance obeys η̇ = A(t) η, A from the stiffness of the lines that touch at that instant of the orbit. Over two of
its steps A is taken to its fourth order in time and solved by the exponential of a matrix, so that a constant A is
exact and no step damps what the system does not.
"""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations import WORKS, linear, state_matrix, stiffness_at
from gearwright.dynamics.model import Arrays, System, entry_matrix, line_matrix
from gearwright.dynamics.motion import BLOCK, Samples, blank_record, stepper

NODES = (slice(0, -1, 2), slice(1, None, 2), slice(2, None, 2))
"""First, middle and last instants of each two steps."""


def every_step(system: System, start: Floats, step: float, steps: int) -> Samples:
    """Return every instant of a motion from q and q̇ at time 0.

    Args:
        system: Bodies, lines, loads.
        start: q and q̇, shape (2 coordinates,).
        step: [s].
        steps: How many.
    """
    arrays = system.arrays
    size, lines = len(arrays.mass), len(arrays.stiffness)
    advance, record = stepper(arrays, "runge-kutta", step), blank_record(arrays, steps + 1)
    state = np.concatenate([start, np.zeros(WORKS)])
    for first in range(0, len(record), BLOCK):
        advance(first, record[first : first + BLOCK], state)
    ends = [size, 2 * size, 2 * size + lines, 2 * size + 2 * lines]
    position, velocity, force, deflection, _ = np.split(np.asarray(record), ends, axis=1)
    drive = np.zeros((steps + 1, 0))
    time = np.asarray(step * np.arange(steps + 1), dtype=np.float64)
    return Samples(time, position, velocity, force, deflection, system.labels, drive)


def monodromy(system: System, samples: Samples) -> Floats:
    """Return the derivative of a motion's end by its start, shape (2 coordinates, 2 coordinates).

    Args:
        system: At constant speed.
        samples: Every step of the motion, an even number of them.

    Source: Magnus series to fourth order with Simpson's nodes, Blanes, Casas, Oteo & Ros 2009, Phys. Rep. 470, 151,
        section 5.
    """
    from scipy import linalg  # statics, whose layer this is, do without it

    arrays = system.arrays
    stiffness, share = stiffness_at(system, samples.time), _touching(arrays, samples.line_deflection)
    first, middle, last = (_matrices(arrays, share * stiffness[nodes]) for nodes in NODES)
    step = 2.0 * float(samples.time[1] - samples.time[0])
    exponents = step / 6.0 * (first + 4.0 * middle + last) - step**2 / 12.0 * (first @ last - last @ first)
    total = np.eye(2 * len(arrays.mass))
    with one_blas_thread():
        for turn in linalg.expm(exponents):
            total = turn @ total
    return np.asarray(total)


def _touching(arrays: Arrays, deflection: Floats) -> Floats:
    """Return the share of each two steps in which lines touch, shape (steps / 2, lines).

    Between instants a deflection is taken as straight, so that flanks part and meet inside a step.
    """
    low, high = np.minimum(deflection[:-1], deflection[1:]), np.maximum(deflection[:-1], deflection[1:])
    gap = np.minimum(high, 0.0) - np.maximum(low, -arrays.backlash)
    length = high - low
    still = np.where(gap > 0.0, 1.0, 0.0)
    opened = np.divide(np.maximum(gap, 0.0), length, out=still, where=length > 0.0)
    touching = np.where(arrays.backlash > 0.0, 1.0 - opened, 1.0)
    return np.asarray(0.5 * (touching[::2] + touching[1::2]))


def _matrices(arrays: Arrays, stiffness: Floats) -> Floats:
    """Return A at many instants, shape (instants, 2 coordinates, 2 coordinates)."""
    factor, size = float(arrays.profile.factor[0]), len(arrays.mass)
    matrix = line_matrix(arrays)
    turned = factor**2 * entry_matrix(arrays.centripetal, size)
    found = np.repeat(state_matrix(linear(arrays, factor))[None], len(stiffness), axis=0)
    held = np.einsum("li,tl,lj->tij", matrix, stiffness, matrix, optimize=True) - turned
    found[:, size:, :size] = -held / arrays.mass[:, None]
    return np.asarray(found)
