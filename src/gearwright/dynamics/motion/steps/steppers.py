"""Steppers: each fills a block of rows (q, q̇, line forces, deflections) and carries the state on.

A stepper is a plain function of (first step, record, state). Blocks begin at multiples of `BLOCK`, so that a run that
is taken up again at a checkpoint repeats itself bit for bit.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.codegen import (
    SIDE,
    Clocked,
    Compiled,
    Size,
    aligned,
    clock,
    clocked,
    compiled,
    parameters,
    record_width,
    recurrence,
    table_width,
    topology,
)
from gearwright.dynamics.equations import linear
from gearwright.dynamics.model import Arrays, kept
from gearwright.dynamics.motion.record import BLOCK
from gearwright.dynamics.motion.steps import exact
from gearwright.errors import SolveError

Stepper = Callable[[int, Floats, Floats], None]
RUNGE_KUTTA = ("runge-kutta", "runge-kutta generic")
"""Methods of fixed steps that a system's fastest mode limits."""
ADAPTIVE = ("tsit5", "tsit5 generic")
"""Methods that choose their own steps."""
METHODS = ("exact", *RUNGE_KUTTA, *ADAPTIVE, "implicit")
"""Names of the methods; those without ``generic`` run code that is generated for the system's structure."""


def blank_record(arrays: Arrays, steps: int) -> Floats:
    """Return rows for a stepper to fill: q, q̇, line forces, deflections, and zeros up to a whole vector.

    Args:
        arrays: The system's numbers.
        steps: Rows.
    """
    return aligned(steps, kept(arrays, (record_width,), lambda: record_width(topology(arrays))))


def blank_summary(width: int) -> Floats:
    """Return the summary of no rows, shape (4, width).

    Args:
        width: Numbers in a row.
    """
    summary = np.zeros((4, width))
    summary[0], summary[1] = np.inf, -np.inf
    return summary


def stepper(arrays: Arrays, method: str, h: float, *, tolerance: float = 0.0) -> Stepper:
    """Return the stepper of a method.

    Args:
        arrays: The system's numbers.
        method: One of `METHODS`.
        h: Step [s]; for adaptive methods the spacing of the record's rows.
        tolerance: Root of the energy that the error of one adaptive step may hold [√J].
    """
    if method in ADAPTIVE:
        return _adaptive(arrays, h, tolerance, generic=method != ADAPTIVE[0])
    builders = {"exact": _exact, "runge-kutta": _generated, "runge-kutta generic": _generic, "implicit": _implicit}
    return builders[method](arrays, h)


class GeneratedRun(NamedTuple):
    """What a run by generated code is made of."""

    code: int
    """Address of what advances a block."""
    numbers: Floats
    """Its parameters."""
    clock: Clocked
    """Of this run alone."""
    given: Ints
    """The same as compiled code reads it."""


def generated_run(arrays: Arrays, h: float) -> GeneratedRun:
    """Return what a run by generated code is made of.

    Args:
        arrays: The system's numbers.
        h: Step [s].
    """
    return GeneratedRun(_code(arrays, h).address, parameters(arrays, h)[1], *clocked(arrays, h, BLOCK))


def _code(arrays: Arrays, h: float) -> Compiled:
    return kept(arrays, (compiled,), lambda: compiled(topology(arrays), parameters(arrays, h)[0]))


def _generated(arrays: Arrays, h: float) -> Stepper:
    numbers, code, now = parameters(arrays, h)[1], _code(arrays, h), clock(arrays, h, BLOCK)

    def advance(first: int, record: Floats, state: Floats) -> None:
        table, turn = now(first, len(record))
        code.advance(len(record), numbers, numbers, table, turn, state, record)

    return advance


def _generic(arrays: Arrays, h: float) -> Stepper:
    # Loaded here because the generated code does without it, and compiling it the first time takes seconds.
    from gearwright.dynamics.equations import kernel

    instants = kernel.empty_instant(arrays), kernel.empty_instant(arrays)

    def advance(first: int, record: Floats, state: Floats) -> None:
        kernel.runge_kutta(arrays, instants, first, h, record, state)

    return advance


def _adaptive(arrays: Arrays, h: float, tolerance: float, *, generic: bool) -> Stepper:
    from gearwright.dynamics.equations import kernel
    from gearwright.dynamics.motion.steps import tsit5

    shape = topology(arrays)
    layout, numbers = parameters(arrays, h)
    code = None if generic else compiled(shape, layout)
    row, now = np.zeros(table_width(shape)), kernel.empty_instant(arrays)
    limit = tsit5.limits(arrays, tolerance)

    def advance(first: int, record: Floats, state: Floats) -> None:
        right = tsit5.Right(code.derivative if code else 0, numbers, row, now)
        _, done, reached = tsit5.march(arrays, right, first, h, limit, record, state)
        if not done:
            raise SolveError(f"the run diverged at {reached:.6g} s: no step is short enough; it needs more damping")

    return advance


def _implicit(arrays: Arrays, h: float) -> Stepper:
    from gearwright.dynamics.equations import kernel
    from gearwright.dynamics.motion.steps import implicit

    now, damping = kernel.empty_instant(arrays), linear(arrays, float(arrays.profile.factor[0])).damping

    def advance(first: int, record: Floats, state: Floats) -> None:
        implicit.march(arrays, now, first, h, damping, record, state)

    return advance


def _exact(arrays: Arrays, h: float) -> Stepper:
    carry = exact.propagator(arrays, h, int(np.log2(BLOCK)))
    kept, width = 2 * len(arrays.mass), record_width(topology(arrays))
    size = Size(len(carry.step), kept, len(carry.output), width)
    run, block = recurrence(carry.powers[SIDE.bit_length() - 1], carry.output, size), aligned(BLOCK, width)
    eight = exact.first_powers(carry, SIDE)

    def advance(first: int, record: Floats, state: Floats) -> None:
        start = exact.extended_state(arrays, first * h, state)
        room = record if len(record) % SIDE == 0 else block[: -(-len(record) // SIDE) * SIDE]
        run((eight @ start).reshape(SIDE, -1), room)
        if room is not record:
            record[:] = room[: len(record)]
        works, end = exact.works_during(carry, start, len(record))
        state[:kept] = end[:kept]
        state[kept:] += works

    return advance
