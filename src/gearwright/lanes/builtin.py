"""Built-in functions for numbers and for lanes of them."""

from __future__ import annotations

import builtins
import sys
from collections.abc import Callable
from functools import cache as _cache, lru_cache as _lru_cache, wraps
from typing import Any

import numpy as np

from gearwright.lanes.lanes import Lanes, each, lanes_of

COMPENSATED = sys.version_info >= (3, 12)
"""Whether Python's own sum of floats carries what it rounds off."""


def float_(value: Any = 0.0) -> Any:
    """Return a number as a float.

    Args:
        value: A number, in lanes or not.
    """
    if type(value) is not Lanes:
        return builtins.float(value)
    data = value.data.reshape(len(value.data)) if value.data.ndim > 1 and value.data[0].size == 1 else value.data
    return Lanes(data.astype(np.float64)) if data.dtype != np.float64 else Lanes(data)


def int_(value: Any = 0, *more: Any) -> Any:
    """Return a number as a whole one.

    Args:
        value: A number, in lanes or not.
        more: What else the function takes.
    """
    if type(value) is not Lanes:
        return builtins.int(value, *more)
    return value if value.data.dtype.kind in "iu" else Lanes(np.trunc(value.data).astype(np.int64))


def bool_(value: Any = None) -> Any:
    """Return a truth, of lanes their truths.

    Args:
        value: A number, in lanes or not.
    """
    if type(value) is not Lanes:
        return builtins.bool(value)
    return value if value.data.dtype == np.bool_ else Lanes(value.data != 0)


def complex_(real: Any = 0.0, imag: Any = 0.0) -> Any:
    """Return a complex number.

    Args:
        real: Real part.
        imag: Imaginary part.
    """
    if type(real) is not Lanes and type(imag) is not Lanes:
        return builtins.complex(real, imag)
    return Lanes(each(builtins.complex, real, imag))


def isinstance_(value: Any, kinds: Any) -> bool:
    """Tell whether a value is of some kinds; lanes are what their numbers are.

    Args:
        value: A number, in lanes or not.
        kinds: As `isinstance` takes them.
    """
    if type(value) is not Lanes:
        return builtins.isinstance(value, kinds)
    if value.data.ndim > 1:
        stands: Any = np.empty(0)
    else:
        stands = {"f": 0.0, "i": 0, "b": True, "c": 0j}[value.data.dtype.kind]
    return builtins.isinstance(stands, kinds)


def min_(*values: Any, **named: Any) -> Any:
    """Return the least; of numbers lane by lane.

    Args:
        values: Numbers or an array, in lanes or not.
        named: What else the function takes.
    """
    return _extreme(builtins.min, -1, values, named)


def max_(*values: Any, **named: Any) -> Any:
    """Return the largest; of numbers lane by lane.

    Args:
        values: Numbers or an array, in lanes or not.
        named: What else the function takes.
    """
    return _extreme(builtins.max, 1, values, named)


def _extreme(function: Callable[..., Any], sense: int, values: Any, named: Any) -> Any:
    entries = list(values[0]) if len(values) == 1 else values
    if "key" in named or not any(type(entry) is Lanes for entry in entries):
        return function(entries, **named)
    best = entries[0]
    for entry in entries[1:]:
        better = entry > best if sense > 0 else entry < best
        best = chosen(better, entry, best)
    return best


def chosen(truth: Any, one: Any, other: Any) -> Any:
    """Return one number where something is true, else another.

    Args:
        truth: Of every lane, or of all.
        one: Number.
        other: Number.
    """
    if type(truth) is not Lanes:
        return one if truth else other
    if truth.data.all():
        return one
    if not truth.data.any():
        return other
    return Lanes(np.where(truth.data, lanes_of(one).data, lanes_of(other).data))


def sum_(values: Any, start: Any = 0) -> Any:
    """Return the sum as Python adds numbers.

    Args:
        values: Numbers or an array, in lanes or not.
        start: Added to it.
    """
    entries = list(values)
    if not COMPENSATED or not any(type(entry) is Lanes for entry in entries):
        return builtins.sum(entries, start)
    return Lanes(each(lambda *lane: builtins.sum(lane, start), *entries))


def lru_cache(*given: Any, **named: Any) -> Any:
    """Return a cache that keeps no lanes.

    Args:
        given: As `functools.lru_cache` takes it.
        named: What else the function takes.
    """
    if given and callable(given[0]):
        return _kept(given[0], _lru_cache(given[0]))
    return lambda function: _kept(function, _lru_cache(*given, **named)(function))


def cache(function: Callable[..., Any]) -> Any:
    """Return a cache that keeps no lanes.

    Args:
        function: Of numbers, or of arguments that can be looked up.
    """
    return _kept(function, _cache(function))


def _kept(function: Callable[..., Any], kept: Callable[..., Any]) -> Callable[..., Any]:
    @wraps(function)
    def looked_up(*values: Any, **named: Any) -> Any:
        for value in values:
            kind = type(value)
            if kind is Lanes or kind not in _SIMPLE:
                return function(*values, **named)
        return kept(*values, **named)

    return looked_up


_SIMPLE = {builtins.int, builtins.float, str, builtins.bool, type(None), type}
