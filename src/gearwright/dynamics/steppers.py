"""Steppers: each fills a block of rows (q, q̇, line forces, deflections) and carries the state on.

A stepper is a plain function of (first step, record, state) that returns least, most, sum and sum of squares of the
record's columns. Blocks begin at multiples of `BLOCK`, so that a run that
is taken up again at a checkpoint repeats itself bit for bit.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearwright.dynamics import exact
from gearwright.dynamics.clock import clock
from gearwright.dynamics.generate import record_width, table_width
from gearwright.dynamics.native import compiled
from gearwright.dynamics.recorder import BLOCK, summary_of
from gearwright.dynamics.system import Arrays, Floats
from gearwright.dynamics.topology import parameters, topology

Stepper = Callable[[int, Floats, Floats], Floats]
METHODS = ("exact", "runge-kutta", "runge-kutta generic", "implicit")
"""Names of the methods; the plain ``"runge-kutta"`` runs code that is generated for the system's structure."""


def blank_record(arrays: Arrays, steps: int) -> Floats:
    """Return rows for a stepper to fill: q, q̇, line forces, deflections, and zeros up to a whole vector.

    Args:
        arrays: The system's numbers.
        steps: Rows.
    """
    return np.zeros((steps, record_width(topology(arrays))))


def stepper(arrays: Arrays, method: str, h: float) -> Stepper:
    """Return the stepper of a method.

    Args:
        arrays: The system's numbers.
        method: One of `METHODS`.
        h: Step [s].
    """
    builders = {"exact": _exact, "runge-kutta": _generated, "runge-kutta generic": _generic, "implicit": _implicit}
    return builders[method](arrays, h)


def _generated(arrays: Arrays, h: float) -> Stepper:
    shape = topology(arrays)
    layout, numbers = parameters(arrays, h)
    code = compiled(shape, layout)
    table = np.empty((2 * BLOCK + 1, table_width(shape)))
    fill = clock(arrays, h, len(table))

    width = record_width(shape)

    def advance(first: int, record: Floats, state: Floats) -> Floats:
        fill(first, table[: 2 * len(record) + 1])
        summary = np.zeros((4, width))
        summary[0], summary[1] = np.inf, -np.inf
        code.advance(len(record), numbers, numbers, table, state, record, summary)
        return summary

    return advance


def _generic(arrays: Arrays, h: float) -> Stepper:
    # Loaded here because the generated code does without it, and compiling it the first time takes seconds.
    from gearwright.dynamics import kernel

    instants = kernel.empty_instant(arrays), kernel.empty_instant(arrays)

    def advance(first: int, record: Floats, state: Floats) -> Floats:
        kernel.runge_kutta(arrays, instants, (first, h), record, state)
        return summary_of(record)

    return advance


def _implicit(arrays: Arrays, h: float) -> Stepper:
    from gearwright.dynamics import implicit, kernel

    now, parts = kernel.empty_instant(arrays), implicit.tangent_parts(arrays)

    def advance(first: int, record: Floats, state: Floats) -> Floats:
        implicit.march(arrays, now, (first, h), parts, record, state)
        return summary_of(record)

    return advance


def _exact(arrays: Arrays, h: float) -> Stepper:
    carry = exact.propagator(arrays, h, int(np.log2(BLOCK)))
    width = 2 * len(arrays.mass)
    past = width + 2 * len(arrays.stiffness)

    def advance(first: int, record: Floats, state: Floats) -> Floats:
        # Always a whole block: matrix products of other heights may round differently.
        rows = exact.block(carry, exact.extended_state(arrays, first * h, state), BLOCK)
        steps = len(record)
        record[:, :width] = rows[:steps, :width]
        record[:, width:past] = (rows @ carry.output)[:steps]
        state[:width] = rows[steps, :width]
        products = rows[:steps].T @ rows[:steps]
        state[width:] += np.einsum("kij,ij->k", carry.works, products)
        return summary_of(record)

    return advance
