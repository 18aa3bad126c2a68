"""Formulas of a module for arrays: the same functions, whose ``math``, ``min`` and ``max`` are those of numpy.

Lighter than a twin: no branch is followed lane by lane, so a function that branches on its numbers is replaced by name.
"""

from __future__ import annotations

import builtins
from collections.abc import Callable
from functools import reduce
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

_MATH = SimpleNamespace(
    **{name: getattr(np, name) for name in ("sqrt", "exp", "log", "log10", "sin", "cos", "tan", "radians", "hypot")},
    pow=np.power,
    pi=np.pi,
    inf=np.inf,
)


def rebound(module: ModuleType, **others: Any) -> SimpleNamespace:
    """Return what a module holds, its functions such that they take arrays where they take numbers.

    Args:
        module: Of formulas.
        others: Name in it -> what stands for it, such as a function of another module that is rebound too.
    """
    names: dict[str, Any] = vars(module) | {"math": _MATH, "min": _least, "max": _largest, "float": _kept} | others
    for name, held in vars(module).items():
        if isinstance(held, FunctionType) and held.__module__ == module.__name__ and name not in others:
            made = FunctionType(held.__code__, names, name, held.__defaults__, held.__closure__)
            made.__kwdefaults__ = held.__kwdefaults__
            names[name] = made
    return SimpleNamespace(**names)


def _least(*values: Any, **named: Any) -> Any:
    return _extreme(np.minimum, builtins.min, values, named)


def _largest(*values: Any, **named: Any) -> Any:
    return _extreme(np.maximum, builtins.max, values, named)


def _extreme(of_arrays: Any, of_numbers: Callable[..., Any], values: Any, named: Any) -> Any:
    entries = tuple(values[0]) if len(values) == 1 else values
    if named or not any(isinstance(entry, np.ndarray) for entry in entries):
        return of_numbers(entries, **named)
    return reduce(of_arrays, entries)


def _kept(value: Any = 0.0) -> Any:
    return value if isinstance(value, np.ndarray) else builtins.float(value)
