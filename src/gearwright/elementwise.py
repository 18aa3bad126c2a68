"""Functions of numbers and of arrays under one name, so that a formula stands once and takes either."""

import math
from functools import reduce
from types import SimpleNamespace
from typing import Any

import numpy as np

Values = Any
"""A number, or an array of numbers; a formula that takes it returns as many."""


def _least(*values: Values) -> Values:
    return min(*values)


def _largest(*values: Values) -> Values:
    return max(*values)


def _either(truth: Any, one: Values, other: Values) -> Values:
    return one if truth else other


def _between(value: Values, points: Any, values: Any) -> Values:
    return float(np.interp(value, points, values))


def _least_along(*values: Values) -> Values:
    return reduce(np.minimum, values)


def _largest_along(*values: Values) -> Values:
    return reduce(np.maximum, values)


_OF_NUMBERS = SimpleNamespace(
    sqrt=math.sqrt,
    exp=math.exp,
    log=math.log,
    log10=math.log10,
    sin=math.sin,
    cos=math.cos,
    tan=math.tan,
    pow=math.pow,
    radians=math.radians,
    min=_least,
    max=_largest,
    where=_either,
    interp=_between,
)
_OF_ARRAYS = SimpleNamespace(
    sqrt=np.sqrt,
    exp=np.exp,
    log=np.log,
    log10=np.log10,
    sin=np.sin,
    cos=np.cos,
    tan=np.tan,
    pow=np.power,
    radians=np.radians,
    min=_least_along,
    max=_largest_along,
    where=np.where,
    interp=np.interp,
)


def functions(*values: Values) -> Any:
    """Return the functions of a formula: those of numbers, or of numpy where one of its values is an array.

    Args:
        values: That the formula is given.

    Returns:
        ``sqrt``, ``exp``, ``log``, ``log10``, ``sin``, ``cos``, ``tan``, ``pow``, ``radians``, ``where``, ``interp``,
        and ``min`` and ``max`` of two or more values.

    >>> functions(2.0).max(2.0, 3.0), functions(np.array([2.0, 4.0])).max(np.array([2.0, 4.0]), 3.0).tolist()
    (3.0, [3.0, 4.0])
    """
    for value in values:
        if isinstance(value, np.ndarray):
            return _OF_ARRAYS
    return _OF_NUMBERS


def across(value: Values) -> Values:
    """Return a value that is to be combined with points along a new last axis; a number as it is.

    Args:
        value: Shape (...,).
    """
    return value[..., None] if isinstance(value, np.ndarray) else value


def plain(value: Values) -> Values:
    """Return a number as Python's own, whose powers are not numpy's; an array as it is.

    Args:
        value: A number or an array.
    """
    return value if isinstance(value, np.ndarray) else float(value)
