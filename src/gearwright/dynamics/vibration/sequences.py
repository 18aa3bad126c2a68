"""Sequences of numbers that callers give, speeds and frequencies, as one array."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem

NUMBERS = "iuf"
"""Kinds of arrays that are numbers: no texts that read like one, no truth values."""
LONGEST = 60
"""Characters of what was given that a message repeats."""


def numbers(values: Sequence[float] | Floats, path: str) -> Floats:
    """Return numbers as an array, one at least, all finite.

    Args:
        values: A list, a tuple, an array.
        path: What they are called, for the message.

    Raises:
        DesignError: If they are anything else.
    """
    try:
        given = np.asarray(values)
        array = given.astype(np.float64) if given.dtype.kind in NUMBERS else np.zeros((0, 0))
    except (TypeError, ValueError):
        array = np.zeros((0, 0))
    if array.ndim != 1 or not len(array) or not np.all(np.isfinite(array)):
        raise _refused(values, path, "finite")
    return array


def positive_numbers(values: Sequence[float] | Floats, path: str) -> Floats:
    """Return numbers as an array, one at least, all positive and finite.

    Args:
        values: A list, a tuple, an array.
        path: What they are called, for the message.

    Raises:
        DesignError: If they are anything else.
    """
    array = numbers(values, path)
    if not np.all(array > 0.0):
        raise _refused(values, path, "positive")
    return array


def _refused(values: object, path: str, what: str) -> DesignError:
    shown = repr(values)
    shown = shown if len(shown) <= LONGEST else f"{shown[:LONGEST]} …"
    return DesignError([Problem(path, f"{shown}; give a sequence of {what} numbers, one at least, as [0.5, 1.0]")])
