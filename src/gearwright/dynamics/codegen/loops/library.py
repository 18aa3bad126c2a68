"""Library: translated functions compiled together, and records as they read them."""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable
from functools import cache
from threading import Lock
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Ints
from gearwright.dynamics.codegen.assembler import address, machine_code
from gearwright.dynamics.codegen.loops.statements import assembly, kinds_of
from gearwright.dynamics.codegen.loops.words import ADDRESS, NUMBER


class Library:
    """Machine code of translated functions."""

    def __init__(self, functions: tuple[Callable[..., Any], ...]) -> None:
        self.engine = machine_code(assembly(functions), optimised=True)
        self.functions = {function.__name__: function for function in functions}
        self.made: dict[str, Callable[..., Any]] = {}

    def address(self, name: str) -> int:
        """Return where a function begins.

        Args:
            name: Of the function.
        """
        return int(self.engine.get_function_address(name))

    def function(self, name: str) -> Callable[..., Any]:
        """Return a function to call with numbers and addresses.

        Args:
            name: Of the function.
        """
        if name not in self.made:
            by_kind = {ADDRESS: ctypes.c_void_p, NUMBER: ctypes.c_double, "void": None}
            kinds: list[Any] = [by_kind.get(kind.text, ctypes.c_int64) for kind in kinds_of(self.functions[name])]
            self.made[name] = ctypes.CFUNCTYPE(kinds.pop(), *kinds)(self.address(name))
        return self.made[name]


def library(*functions: Callable[..., Any]) -> Library:
    """Return functions compiled together, once in a process, whoever asks first: what runs must not be let go.

    Args:
        functions: In the part of Python that `statements` knows.
    """
    with _LOCK:
        return _library(functions)


_library, _LOCK = cache(Library), Lock()


def packed(record: NamedTuple) -> Ints:
    """Return a record as translated functions read it, eight bytes a field: numbers, and addresses of arrays.

    Args:
        record: Whose arrays must live as long as it is read.
    """
    return np.array([_number(field) for field in record], dtype=np.int64)


def _number(field: Any) -> int:
    if isinstance(field, np.ndarray):
        return int(field.__array_interface__["data"][0])
    return struct.unpack("q", struct.pack("d", field))[0] if isinstance(field, float) else field  # type: ignore[no-any-return]


class Room:
    """A record whose arrays stand behind it in one piece of memory, so that it is had anew by one copy."""

    def __init__(self, record: NamedTuple) -> None:
        self.shapes, image, place = dict[str, tuple[slice, Any, tuple[int, ...]]](), [], len(record)
        for name, field in record._asdict().items():
            if isinstance(field, np.ndarray):
                self.shapes[name] = slice(place, place + field.size), field.dtype, field.shape
                image.append(np.ravel(field).view(np.int64))
                place += field.size
        head = [8 * self.shapes[name][0].start if name in self.shapes else _number(field)
                for name, field in record._asdict().items()]  # fmt: skip
        self.image = np.concatenate([np.array(head, dtype=np.int64), *image])
        self.pointers = np.array([place for place, name in enumerate(record._fields) if name in self.shapes])

    def fresh(self) -> Held:
        """Return the record anew, its arrays as they were given."""
        return Held(self)


class Held:
    """A record in one piece of memory; its arrays are looked at by name."""

    def __init__(self, room: Room) -> None:
        self.shapes, self.memory = room.shapes, room.image.copy()
        self.place = address(self.memory)
        self.memory[room.pointers] += self.place

    def __getattr__(self, name: str) -> Any:
        """Return one of the arrays."""
        place, kind, shape = self.shapes[name]
        array = self.memory[place].view(kind).reshape(shape)
        setattr(self, name, array)
        return array
