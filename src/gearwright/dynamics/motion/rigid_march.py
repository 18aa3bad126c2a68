"""The rigid motion of a driven train through time, in compiled code: what `rigid_pass` reads a speed profile from.

The right-hand side is the structure's own generated code, behind its address; what is compiled besides is this loop.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen import address, clock, drive_width, parameters, topology
from gearwright.dynamics.codegen import compiled as generated
from gearwright.dynamics.codegen.loops import at, call, library, packed
from gearwright.dynamics.equations import WORKS
from gearwright.dynamics.model import Arrays

BLOCK = 512
"""Steps between two settings of the clock."""


class Rigid(NamedTuple):
    """What the loop works with."""

    derivative: int
    """Address of the right-hand side."""
    numbers: Floats
    """Its parameters."""
    row: int
    """Numbers in a row of the clock table."""
    h: float
    """Step [s]."""
    size: int
    """Coordinates."""
    states: int
    """Of the drives."""
    past: int
    """Place of the drives' states in a state."""
    rigid: Floats
    """Rigid motion of unit mass, shape (coordinates,)."""
    mass: Floats
    state: Floats
    """(q, q̇, works, x) of a stage, with q at rest."""
    change: Floats
    """Its rate."""
    output: Floats
    """Line forces and deflections, and what the drives report."""
    motion: Floats
    """(ν, x), which is carried on."""
    inside: Floats
    """The same within a step."""
    total: Floats
    """Sum of its rates."""


def march_rigid(c: Rigid, table: Floats, count: int, speeds: Floats) -> None:
    """Carry (ν, x) on, and fill ν before each step and after the last."""
    for step in range(count):
        speeds[step] = c.motion[0]
        for i in range(c.states + 1):
            c.inside[i] = c.motion[i]
            c.total[i] = 0.0
        for stage in range(4):
            for i in range(c.size):
                c.state[c.size + i] = c.rigid[i] * c.inside[0]
            for i in range(c.states):
                c.state[c.past + i] = c.inside[1 + i]
            row = at(table, (2 * step + (stage + 1) // 2) * c.row)
            call(c.derivative, c.numbers, row, c.state, c.change, c.output)
            share = 2.0 if stage == 1 or stage == 2 else 1.0
            reach = c.h if stage == 2 else 0.5 * c.h
            for k in range(c.states + 1):
                rate = 0.0
                if k == 0:
                    for i in range(c.size):
                        rate += c.rigid[i] * c.mass[i] * c.change[c.size + i]
                else:
                    rate = c.change[c.past + k - 1]
                c.total[k] += share * rate
                c.inside[k] = c.motion[k] + reach * rate
        for i in range(c.states + 1):
            c.motion[i] += c.h / 6.0 * c.total[i]
    speeds[count] = c.motion[0]


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
    past, reports = 2 * size + WORKS, 2 * len(shape.lines) + drive_width(shape)
    speeds, motion = np.zeros(steps + 1), np.concatenate([[0.0], arrays.drives.start])
    table = now(0, min(BLOCK, steps))[0]
    course = Rigid(
        code.derivative, numbers, table.shape[1], h, size, states, past, rigid, arrays.mass, np.zeros(past + states),
        np.zeros(past + states), np.zeros(reports), motion, motion.copy(), motion.copy(),
    )  # fmt: skip
    given, march = packed(course), library(march_rigid).function("march_rigid")
    for first in range(0, steps, BLOCK):
        count = min(BLOCK, steps - first)
        table = now(first, count)[0]  # its tones need no turning: what lines pull along a rigid motion adds up to zero
        march(address(given), address(table), count, address(speeds) + 8 * first)
    return speeds
