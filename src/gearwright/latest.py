"""What a function gave of the values that it was asked for last: asked again of one of them, it computes nothing."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TypeVar

Value = TypeVar("Value")
Result = TypeVar("Result")


def of_latest(function: Callable[[Value], Result]) -> Callable[[Value], Result]:
    """Return a function of one frozen value that keeps the latest value with its result, and no other.

    Values are told apart by which object they are: equal ones that are two objects are computed twice, and what is
    refused is refused anew.

    Args:
        function: Without any other input; what it returns is not changed by those who ask.

    >>> asked = []
    >>> length = of_latest(lambda words: asked.append(words) or len(words))
    >>> words = ("sun", "planet")
    >>> length(words), length(words), length(("sun", "planet")[:1]), len(asked)
    (2, 2, 1, 2)
    """
    return _keeping(1, function)


def of_latest_two(function: Callable[[Value], Result]) -> Callable[[Value], Result]:
    """Return a function as `of_latest` does that keeps the latest two values: of two that take turns none is forgotten.

    Args:
        function: Without any other input; what it returns is not changed by those who ask.
    """
    return _keeping(2, function)


def _keeping(count: int, function: Callable[[Value], Result]) -> Callable[[Value], Result]:
    kept: list[tuple[Value, Result]] = []

    @wraps(function)
    def asked(value: Value) -> Result:
        for known, result in kept:
            if known is value:
                return result
        result = function(value)
        kept[:] = [(value, result), *kept[: count - 1]]
        return result

    return asked
