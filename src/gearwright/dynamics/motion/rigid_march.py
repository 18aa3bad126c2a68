"""The rigid motion of a driven train through time, in compiled code: what `rigid_pass` reads a speed profile from.

The right-hand side is the structure's own generated code, behind a pointer: nothing else is compiled for it than this
loop, which is the same for all.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.codegen import clock, drive_width, parameters, topology
from gearwright.dynamics.codegen import compiled as generated
from gearwright.dynamics.equations import WORKS
from gearwright.dynamics.model import Arrays
from gearwright.dynamics.motion.steps.call import call_generated

BLOCK = 512
"""Steps between two settings of the clock."""


class Work(NamedTuple):
    """Arrays that every slope fills anew."""

    state: Floats
    """(q, q̇, works, x), shape (states,)."""
    change: Floats
    """Its rate, shape (states,)."""
    output: Floats
    """Line forces and deflections, and what the drives report."""


def rigid_speeds(arrays: Arrays, rigid: Floats, h: float, steps: int) -> Floats:
    """Return ν before every step and after the last, shape (steps + 1,).

    Args:
        arrays: The system's numbers, at a constant speed factor.
        rigid: Its rigid motion, of unit mass, shape (coordinates,).
        h: Step [s].
        steps: How many.
    """
    shape, (layout, numbers) = topology(arrays), parameters(arrays, h)
    code, now = generated(shape, layout), clock(arrays, h, BLOCK)
    size, states = len(rigid), len(arrays.drives.start)
    length = 2 * size + WORKS + states
    work = Work(np.zeros(length), np.zeros(length), np.zeros(2 * len(shape.lines) + drive_width(shape)))
    motion, state = np.zeros(steps + 1), np.concatenate([[0.0], arrays.drives.start])
    for first in range(0, steps, BLOCK):
        count = min(BLOCK, steps - first)
        table = now(first, count)[0]  # its tones need no turning: what lines pull along a rigid motion adds up to zero
        _march(
            code.derivative,
            numbers,
            table,
            h,
            work,
            rigid,
            rigid * arrays.mass,
            state,
            motion[first : first + count + 1],
        )
    return motion


@compiled
def _march(
    address: int, numbers: Floats, table: Floats, h: float, work: Work, rigid: Floats, weight: Floats, state: Any,
    motion: Floats,
) -> None:  # fmt: skip
    """Carry (ν, x) on, and fill ν before each step and after the last."""
    size, states, width = len(rigid), len(state) - 1, 8 * table.shape[1]
    past = len(work.state) - states
    numbers_at, table_at, output_at = numbers.ctypes.data, table.ctypes.data, work.output.ctypes.data
    state_at, change_at = work.state.ctypes.data, work.change.ctypes.data
    inside, total = state.copy(), state.copy()
    for step in range(len(motion) - 1):
        motion[step] = state[0]
        for i in range(states + 1):
            inside[i], total[i] = state[i], 0.0
        for stage in range(4):
            for i in range(size):
                work.state[size + i] = rigid[i] * inside[0]
            for i in range(states):
                work.state[past + i] = inside[1 + i]
            row = 2 * step + (stage + 1) // 2
            call_generated(address, numbers_at, table_at + row * width, state_at, change_at, output_at)
            rate = 0.0
            for i in range(size):
                rate += weight[i] * work.change[size + i]
            share = 2.0 if stage == 1 or stage == 2 else 1.0
            reach = h if stage == 2 else 0.5 * h
            total[0] += share * rate
            inside[0] = state[0] + reach * rate
            for i in range(states):
                rate = work.change[past + i]
                total[1 + i] += share * rate
                inside[1 + i] = state[1 + i] + reach * rate
        for i in range(states + 1):
            state[i] += h / 6.0 * total[i]
    motion[-1] = state[0]
