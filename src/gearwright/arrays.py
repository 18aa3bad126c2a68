"""Types of arrays, ranking of values with stable order of ties, and the threads of their linear algebra."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import cache
from threading import Lock
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

# ----------------------------------------------------------------------------------------------------------------------
# Arrays by what they hold, for signatures and fields.
# ----------------------------------------------------------------------------------------------------------------------


Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
Complexes = NDArray[np.complexfloating[Any, Any]]


def following(values: NDArray[Any]) -> NDArray[Any]:
    """Return the next one of every value along the first axis of a closed loop; what `numpy.roll` gives, in less time.

    Args:
        values: Shape (n, …).

    >>> following(np.array([1, 2, 3])).tolist()
    [2, 3, 1]
    """
    return np.concatenate([values[1:], values[:1]])


# ----------------------------------------------------------------------------------------------------------------------
# The largest and the smallest of some: equals keep their order, whatever a processor's last digit of rounding says.
# ----------------------------------------------------------------------------------------------------------------------


Row = TypeVar("Row")
ALIKE = 1e-9
"""Part by which two values may differ and be equal [-]."""


def largest(rows: Iterable[Row], value: Callable[[Row], float]) -> Row:
    """Return the row of the largest value, the first one of equals.

    Args:
        rows: One or more.
        value: Of a row.

    Raises:
        ValueError: There is no row.

    >>> largest(["left", "right"], {"left": 0.3, "right": 0.1 + 0.2}.__getitem__)
    'left'
    """
    first, *others = rows
    for row in others:
        if value(row) - value(first) > ALIKE * abs(value(first)):
            first = row
    return first


def smallest(rows: Iterable[Row], value: Callable[[Row], float]) -> Row:
    """Return the row of the smallest value, the first one of equals.

    Args:
        rows: One or more.
        value: Of a row.

    Raises:
        ValueError: There is no row.

    >>> smallest(["left", "right"], {"left": 0.1 + 0.2, "right": 0.3}.__getitem__)
    'left'
    """
    first, *others = rows
    for row in others:
        if value(first) - value(row) > ALIKE * abs(value(row)):
            first = row
    return first


def smallest_first(rows: Iterable[Row], value: Callable[[Row], float]) -> list[Row]:
    """Return the rows by rising value, equals as they came.

    Args:
        rows: Any number.
        value: Of a row; what is that small beside the largest is zero with rounding, and none is not a number.

    >>> smallest_first("abc", {"a": 0.1 + 0.2, "b": 1.0, "c": 0.3}.__getitem__)
    ['a', 'c', 'b']
    """
    kept = list(rows)
    values = [value(row) for row in kept]
    least = ALIKE * max((abs(number) for number in values if math.isfinite(number)), default=0.0)
    ranks = [float(f"{number:.9g}") if abs(number) > least else 0.0 for number in values]
    return [kept[place] for place in sorted(range(len(kept)), key=ranks.__getitem__)]


def largest_first(rows: Iterable[Row], value: Callable[[Row], float]) -> list[Row]:
    """Return the rows by falling value, equals and zeros as they came.

    Args:
        rows: Any number.
        value: Of a row; what is that small beside the largest is zero with rounding, and none is not a number.

    >>> largest_first("abc", {"a": 0.3, "b": 1.0, "c": 0.1 + 0.2}.__getitem__)
    ['b', 'a', 'c']
    """
    return smallest_first(rows, lambda row: -value(row))


def place_of_largest(values: NDArray[np.float64]) -> int:
    """Return where the largest of some numbers is, counted as `numpy.argmax` does; the first place of equals.

    Args:
        values: One or more; those that are not numbers are passed over where others are.

    >>> place_of_largest(np.array([0.1, 0.3, 0.1 + 0.2]))
    1
    """
    flat = np.ravel(values)
    most = float(np.nanmax(flat))
    return int(np.argmax(flat >= most * (1.0 - math.copysign(ALIKE, most))))


def place_of_smallest(values: NDArray[np.float64]) -> int:
    """Return where the smallest of some numbers is, counted as `numpy.argmin` does; the first place of equals.

    Args:
        values: One or more; those that are not numbers are passed over where others are.

    >>> place_of_smallest(np.array([0.9, 0.1 + 0.2, 0.3]))
    1
    """
    return place_of_largest(-values)


# ----------------------------------------------------------------------------------------------------------------------
# Threads of BLAS, the library beneath numpy's and scipy's linear algebra: one is enough for matrices of a gear train.
#
# From some fifty rows on BLAS shares a matrix among as many threads as there are processors. Of a few hundred rows the
# shares are so small that threads spend their time on waiting for each other, which takes all processors.
# ----------------------------------------------------------------------------------------------------------------------


_BRING = ("numpy", "scipy.linalg")
"""Modules that bring a BLAS each; scipy's is loaded when it is first needed."""
_LOCK = Lock()
_INSIDE = list[int]()
"""A mark for every block that runs now, of all threads: the limit is the process's."""
_BEFORE = dict[str, tuple[Any, int]]()
"""File of a BLAS -> the BLAS, and the threads that it had before the first of these blocks [-]."""


@contextmanager
def one_blas_thread() -> Iterator[None]:
    """Limit BLAS to one thread while a block runs; after the last of all that run at once it has its own again.

    A block that loads scipy's BLAS enters anew once it is loaded.
    """
    with _LOCK:
        _INSIDE.append(1)
        for library in _libraries(tuple(name in sys.modules for name in _BRING)):
            if library.filepath not in _BEFORE:
                _BEFORE[library.filepath] = library, library.get_num_threads()
                library.set_num_threads(1)
    try:
        yield
    finally:
        with _LOCK:
            _INSIDE.pop()
            while _BEFORE and not _INSIDE:
                library, threads = _BEFORE.popitem()[1]
                library.set_num_threads(threads)


@cache
def _libraries(_loaded: tuple[bool, ...]) -> list[Any]:
    """Return every BLAS of the process, looked for once for the modules that are loaded."""
    from threadpoolctl import ThreadpoolController  # with what it looks through, 10 ms, which one never pays by help

    return list(ThreadpoolController().select(user_api="blas").lib_controllers)
