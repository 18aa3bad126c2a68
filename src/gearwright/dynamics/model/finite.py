"""One gate for the numbers of the dynamics: what is not finite neither enters a verb nor leaves it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import numpy as np
from numpy.typing import ArrayLike

from gearwright.dynamics.model.system import System
from gearwright.errors import SolveError


def refuse_not_finite(values: ArrayLike, parts: Sequence[str], what: str) -> None:
    """Refuse results that are no numbers.

    Args:
        values: Shape (…, parts).
        parts: What the last axis counts.
        what: That they are, for the message.

    Raises:
        SolveError: With the first part whose value is infinite or no number.
    """
    if np.isfinite(values).all():
        return
    table = np.asarray(values).reshape(-1, len(parts))
    wrong = np.argwhere(~np.isfinite(table))
    if len(wrong):
        row, column = wrong[0]
        message = f"{what} of {parts[column]} is {table[row, column]}, no finite number"
        raise SolveError(f"{message}; look for an extreme mass, stiffness, speed or load there")


def check_finite(system: System) -> None:
    """Refuse a system that cannot be run: with numbers that are not finite, or with forces that have no potential.

    Args:
        system: As assembled, or built by hand.

    Raises:
        SolveError: With the part whose number it is.
    """
    refuse_following(system)
    _check_numbers(system)


def refuse_following(system: System) -> None:
    """Refuse unequal cross terms of bearings, which the linear verbs alone know.

    Args:
        system: As built.

    Raises:
        SolveError: If there are such terms.
    """
    if any(len(entries.value) for entries in system.arrays.following):
        message = "bearings have unequal cross terms (k_xy and k_yx): campbell and frequency_response know them"
        raise SolveError(f"{message}; give equal ones for statics and runs")


def _check_numbers(system: System) -> None:
    arrays, labels = system.arrays, system.labels
    for what, values, parts in (
        ("mass or inertia", np.where(arrays.mass > 0.0, arrays.mass, np.nan), labels.coordinates),
        ("speed", arrays.speed, labels.coordinates),
        ("load", arrays.loads.constant, labels.coordinates),
        ("stiffness", arrays.stiffness, labels.lines),
        ("damping", arrays.damping, labels.lines),
        ("slip", arrays.slip, labels.lines),
    ):
        refuse_not_finite(values, parts, what)


@contextmanager
def finite_numbers(system: System) -> Iterator[None]:
    """Refuse a system with numbers that are not finite, and say so where its equations cannot be solved.

    Args:
        system: That is solved inside.

    Raises:
        SolveError: If a number is not finite, with its part; if the equations have no solution.
    """
    _check_numbers(system)
    try:
        # What overflows is refused with its part when it comes out.
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            yield
    except (ValueError, ArithmeticError) as error:  # LinAlgError is a ValueError
        raise SolveError(f"the equations of motion have no solution in floating point: {error}") from error
