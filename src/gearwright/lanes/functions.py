"""Functions of `math` for numbers and for lanes of them, each lane by the function itself."""

from __future__ import annotations

import math
from collections.abc import Callable
from math import e, inf, nan, pi, tau
from typing import Any

import numpy as np

from gearwright.lanes.lanes import Diverged, Lanes, Unsupported, each, lanes_of

__all__ = ["e", "inf", "nan", "pi", "tau"]


def in_lanes(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function of numbers as one of lanes too.

    Args:
        function: Of numbers, or of arguments that can be looked up.
    """

    def computed(*values: Any, **named: Any) -> Any:
        for value in values:
            if type(value) is Lanes:
                return _each(function, *values, **named)
        return function(*values, **named)

    return computed


def _each(function: Callable[..., Any], *values: Any, **named: Any) -> Lanes:
    try:
        if named:
            return Lanes(each(lambda *numbers: function(*numbers, **named), *values))
        return Lanes(each(function, *values))
    except (ValueError, ArithmeticError) as error:
        raise Unsupported(f"{function.__name__}: {error}") from error


def sqrt(value: Any) -> Any:
    """Return the square root, which arrays have exactly.

    Args:
        value: A number, in lanes or not.
    """
    if type(value) is not Lanes:
        return math.sqrt(value)
    if (value.data < 0).any():
        negative = value.data < 0
        raise Unsupported("the root of a negative number") if negative.all() else Diverged(negative)
    return Lanes(np.sqrt(value.data))


def isfinite(value: Any) -> Any:
    """Tell whether it is finite.

    Args:
        value: A number, in lanes or not.
    """
    return Lanes(np.isfinite(value.data)) if type(value) is Lanes else math.isfinite(value)


def isnan(value: Any) -> Any:
    """Tell whether it is no number.

    Args:
        value: A number, in lanes or not.
    """
    return Lanes(np.isnan(value.data)) if type(value) is Lanes else math.isnan(value)


def isinf(value: Any) -> Any:
    """Tell whether it is infinite.

    Args:
        value: A number, in lanes or not.
    """
    return Lanes(np.isinf(value.data)) if type(value) is Lanes else math.isinf(value)


def isclose(one: Any, other: Any, *, rel_tol: float = 1e-9, abs_tol: float = 0.0) -> Any:
    """Tell whether two numbers are close, as `math.isclose` does.

    Args:
        one: A number, in lanes or not.
        other: A number, in lanes or not.
        rel_tol: Part of either by which they may differ [-].
        abs_tol: By which they may differ at least.
    """
    if type(one) is not Lanes and type(other) is not Lanes:
        return math.isclose(one, other, rel_tol=rel_tol, abs_tol=abs_tol)
    first, second = lanes_of(one).data, lanes_of(other).data
    apart = np.abs(second - first)
    near = (apart <= np.abs(rel_tol * second)) | (apart <= np.abs(rel_tol * first)) | (apart <= abs_tol)
    return Lanes((first == second) | (near & np.isfinite(first) & np.isfinite(second)))


def dist(one: Any, other: Any) -> Any:
    """Return the distance of two points.

    Args:
        one: First.
        other: Second.
    """
    size = len(one)
    values = (*one, *other)
    if not any(type(value) is Lanes for value in values):
        return math.dist(one, other)
    return Lanes(each(lambda *numbers: math.dist(numbers[:size], numbers[size:]), *values))


def fsum(values: Any) -> Any:
    """Return the sum, rounded once.

    Args:
        values: Numbers or an array, in lanes or not.
    """
    numbers = list(values)
    if not any(type(value) is Lanes for value in numbers):
        return math.fsum(numbers)
    return Lanes(each(lambda *lane: math.fsum(lane), *numbers))


def prod(values: Any, *, start: Any = 1) -> Any:
    """Return the product.

    Args:
        values: Numbers or an array, in lanes or not.
        start: Added to it.
    """
    total = start
    for value in values:
        total = total * value
    return total


def __getattr__(name: str) -> Any:
    function = in_lanes(getattr(math, name))
    globals()[name] = function
    return function
