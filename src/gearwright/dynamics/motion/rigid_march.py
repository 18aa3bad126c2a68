"""The rigid motion of a driven train through time, in compiled code: what `rigid_pass` reads a speed profile from."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.equations import WORKS, kernel
from gearwright.dynamics.model import Arrays


class Work(NamedTuple):
    """Arrays that every slope fills anew."""

    state: Floats
    """(q, q̇, works, x), shape (states,)."""
    change: Floats
    """Its rate, shape (states,)."""
    output: Floats
    """Line forces and deflections, and what the drives report."""
    rate: Floats
    """Rate of (ν, x)."""


@compiled
def _slope(arrays: Arrays, now: kernel.Instant, rigid: Floats, state: Floats, work: Work) -> None:
    """Fill the rate of (ν, x)."""
    size = len(rigid)
    first = 2 * size + WORKS
    for i in range(size):
        work.state[size + i] = rigid[i] * state[0]
    work.state[first:] = state[1:]
    kernel.derivative(arrays, now, work.state, work.change, work.output)
    rate = 0.0
    for i in range(size):
        rate += rigid[i] * arrays.mass[i] * work.change[size + i]
    work.rate[0], work.rate[1:] = rate, work.change[first:]


@compiled
def march(arrays: Arrays, now: kernel.Instant, rigid: Floats, h: float, work: Work, motion: Floats) -> None:
    """Fill ν after each step."""
    states = len(arrays.drives.start)
    state, total = np.zeros(1 + states), np.zeros(1 + states)
    state[1:] = arrays.drives.start
    for step in range(len(motion) - 1):
        motion[step] = state[0]
        begin, total[:] = state.copy(), 0.0
        for stage in range(4):
            kernel.set_instant(arrays, (step + (0.0, 0.5, 0.5, 1.0)[stage]) * h, now)
            _slope(arrays, now, rigid, state, work)
            total += (1.0, 2.0, 2.0, 1.0)[stage] * work.rate
            state[:] = begin + (0.5, 0.5, 1.0, 0.0)[stage] * h * work.rate
        state[:] = begin + h / 6.0 * total
    motion[-1] = state[0]
