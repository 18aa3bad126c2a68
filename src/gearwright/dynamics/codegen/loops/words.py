"""Words: what translated functions call beside mathematics, as plain Python does it, and the kinds of their values."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, TypeVar

import numpy as np

from gearwright.arrays import Floats, Ints

WHOLE, NUMBER, TRUTH, ADDRESS = "i64", "double", "i1", "ptr"
"""Kinds of values in assembly."""


class Kind(NamedTuple):
    """Of a value: a number, an array's place, or a record of them."""

    text: str
    """In assembly."""
    member: str = ""
    """Kind of an array's numbers."""
    record: type | None = None
    """Kind of a record, a named tuple."""


KINDS = {"int": Kind(WHOLE), "float": Kind(NUMBER), "bool": Kind(TRUTH), "Floats": Kind(ADDRESS, NUMBER),
         "Ints": Kind(ADDRESS, WHOLE), "None": Kind("void")}  # fmt: skip
"""By what an annotation says; all else is a record."""


def floats(address: int) -> Floats:
    """Return the array at an address; for translated functions, in which its length does not count.

    Args:
        address: Of its first number.
    """
    return np.ctypeslib.as_array(ctypes.cast(address, ctypes.POINTER(ctypes.c_double)), (1 << 20,))


Numbers = TypeVar("Numbers", Floats, Ints)


def at(array: Numbers, first: int) -> Numbers:
    """Return an array from one of its numbers on.

    Args:
        array: Numbers.
        first: Place.
    """
    return array[first:]


def call(address: int, *given: Any) -> None:
    """Call machine code with whole numbers and arrays.

    Args:
        address: Of the code.
        given: Arguments.
    """
    kinds = [ctypes.c_int64 if isinstance(one, int) else ctypes.c_void_p for one in given]
    ctypes.CFUNCTYPE(None, *kinds)(address)(*(one if isinstance(one, int) else one.ctypes.data for one in given))
