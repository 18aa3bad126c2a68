"""Steppers: each fills a block of rows (q, q̇, line forces, deflections) and carries the state on.

A stepper is a plain function of (first step, record, state). Blocks begin at multiples of `BLOCK`, so that a run that
is taken up again at a checkpoint repeats itself bit for bit.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearwright.dynamics import exact, kernel
from gearwright.dynamics.recorder import BLOCK
from gearwright.dynamics.system import Arrays, Floats

Stepper = Callable[[int, Floats, Floats], None]
METHODS = ("exact", "runge-kutta")
"""Names of the methods."""


def stepper(arrays: Arrays, method: str, h: float) -> Stepper:
    """Return the stepper of a method.

    Args:
        arrays: The system's numbers.
        method: One of `METHODS`.
        h: Step [s].
    """
    return _exact(arrays, h) if method == "exact" else _runge_kutta(arrays, h)


def _runge_kutta(arrays: Arrays, h: float) -> Stepper:
    instants = kernel.empty_instant(arrays), kernel.empty_instant(arrays)

    def advance(first: int, record: Floats, state: Floats) -> None:
        kernel.runge_kutta(arrays, instants, (first, h), record, state)

    return advance


def _exact(arrays: Arrays, h: float) -> Stepper:
    carry = exact.propagator(arrays, h, int(np.log2(BLOCK)))
    width = 2 * len(arrays.mass)

    def advance(first: int, record: Floats, state: Floats) -> None:
        # Always a whole block: matrix products of other heights may round differently.
        rows = exact.block(carry, exact.extended_state(arrays, first * h, state), BLOCK)
        steps = len(record)
        record[:, :width] = rows[:steps, :width]
        record[:, width:] = (rows @ carry.output)[:steps]
        state[:width] = rows[steps, :width]
        products = rows[:steps].T @ rows[:steps]
        state[width:] += np.einsum("kij,ij->k", carry.works, products)

    return advance
