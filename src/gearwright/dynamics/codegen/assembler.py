"""LLVM assembly for scalars and vectors, and its compilation to machine code in memory."""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, Literal

import numpy as np

from gearwright.base import Floats, Ints
from gearwright.dynamics.kept_code import COMPILING, keep_code, kept_code
from gearwright.notices import notice

# ----------------------------------------------------------------------------------------------------------------------
# Emitter: a few words of LLVM assembly, for numbers alone (one trajectory) or side by side (lanes).
#
# Only what the generated right-hand side needs: loads, stores, sums, products, the larger and smaller of two.
# Whatever is asked for twice is written once. Sixteen lanes are of single precision: as many bits as eight of double.
# ----------------------------------------------------------------------------------------------------------------------


CHUNK = 8
"""Numbers in a vector."""
SINGLE = 16
"""Numbers of single precision in a vector: lanes that are so many are of it."""
VECTOR = f"<{CHUNK} x double>"
FLAGS = "contract nsz"
"""Products and sums may fuse, and −(a − b) may become b − a. Nothing else may change."""


class Emitter:
    """Writes the body of one function of straight-line code; memory that it fills must be read before it is filled."""

    def __init__(self, lanes: int) -> None:
        self.lanes, self.single = lanes, lanes == SINGLE
        self.number = "float" if self.single else "double"
        self.type = "double" if lanes == 1 else vector(lanes)
        self.lines: list[str] = []
        self.known: dict[str, str] = {}
        self.zero = "0.0" if lanes == 1 else "zeroinitializer"

    @property
    def wide(self) -> Emitter:
        """Emitter of whole vectors that writes into the same body."""
        if self.lanes >= CHUNK:
            return self
        wide = Emitter(CHUNK)
        wide.lines, wide.known = self.lines, self.known
        return wide

    def value(self, text: str) -> str:
        """Write an instruction, unless it stands there already, and return the name of its result.

        Args:
            text: Right-hand side of the assignment.
        """
        if text not in self.known:
            self.known[text] = f"%v{len(self.lines)}"
            self.lines.append(f"  {self.known[text]} = {text}")
        return self.known[text]

    def part(self, name: str) -> None:
        """Begin another part, which loads again what it needs: fewer values are held at a time.

        Args:
            name: Of the part.
        """
        self.known.clear()
        self.lines += [f"  br label %{name}", f"{name}:"]

    def at(self, pointer: str, offset: int) -> str:
        """Return the address of a number.

        Args:
            pointer: Base address.
            offset: In numbers.
        """
        return self.value(f"getelementptr {self.number}, ptr {pointer}, i64 {offset}")

    def load(self, pointer: str, offset: int) -> str:
        """Load as many numbers as there are lanes.

        Args:
            pointer: Base address.
            offset: In numbers.
        """
        return self.value(f"load {self.type}, ptr {self.at(pointer, offset)}, align {self._bytes}")

    def spread(self, pointer: str, offset: int) -> str:
        """Load a number that is the same for all lanes.

        Args:
            pointer: Base address.
            offset: In numbers.
        """
        number = self.value(f"load {self.number}, ptr {self.at(pointer, offset)}, align {self._bytes}")
        if self.lanes == 1:
            return number
        first = self.value(f"insertelement {self.type} poison, {self.number} {number}, i64 0")
        mask = f"<{self.lanes} x i32> zeroinitializer"
        return self.value(f"shufflevector {self.type} {first}, {self.type} poison, {mask}")

    def join(self, values: Sequence[str]) -> str:
        """Return values as one whole vector, zeros after the last.

        Args:
            values: One, if they are whole vectors already; else at most as many as a vector holds.
        """
        if self.lanes >= CHUNK:
            return values[0]
        vector = "zeroinitializer"
        for place, value in enumerate(values):
            vector = self.value(f"insertelement <{CHUNK} x double> {vector}, double {value}, i64 {place}")
        return vector

    def store(self, value: str, pointer: str, offset: int) -> None:
        """Store as many numbers as there are lanes.

        Args:
            value: What to store.
            pointer: Base address.
            offset: In numbers.
        """
        self.lines.append(f"  store {self.type} {value}, ptr {self.at(pointer, offset)}, align {self._bytes}")

    @property
    def _bytes(self) -> int:
        return 4 if self.single else 8

    def add(self, a: str, b: str) -> str:
        """Return a + b; a zero is dropped."""
        if self.zero in (a, b):
            return b if a == self.zero else a
        return self.value(f"fadd contract {self.type} {a}, {b}")

    def subtract(self, a: str, b: str) -> str:
        """Return a − b; a zero b is dropped."""
        return a if b == self.zero else self.value(f"fsub {FLAGS} {self.type} {a}, {b}")

    def multiply(self, a: str, b: str) -> str:
        """Return a b; a zero stays one."""
        return self.zero if self.zero in (a, b) else self.value(f"fmul {FLAGS} {self.type} {a}, {b}")

    def total(self, values: Sequence[str]) -> str:
        """Return the sum of values, in pairs, then pairs of pairs: short chains, and equal sums are written once."""
        while len(values) > 1:
            pairs = [self.add(*values[first : first + 2]) for first in range(0, len(values) - 1, 2)]
            values = [*pairs, *values[2 * len(pairs) :]]
        return values[0] if values else self.zero

    def larger(self, a: str, b: str) -> str:
        """Return the larger of two; the second if either is not a number."""
        return self._chosen("ogt", a, b)

    def smaller(self, a: str, b: str) -> str:
        """Return the smaller of two; the second if either is not a number."""
        return self._chosen("olt", a, b)

    def _chosen(self, relation: str, a: str, b: str) -> str:
        truth = "i1" if self.lanes == 1 else f"<{self.lanes} x i1>"
        mask = self.value(f"fcmp {relation} {self.type} {a}, {b}")
        return self.value(f"select {truth} {mask}, {self.type} {a}, {self.type} {b}")

    def size(self, a: str) -> str:
        """Return |a|."""
        return self._call("fabs", "", a)

    def extreme(self, which: Literal["minnum", "maxnum"], a: str, b: str) -> str:
        """Return the smaller or larger of two numbers in one instruction, even where the result goes back to memory."""
        return self._call(which, "nnan", a, b)

    def _call(self, name: str, flags: str, *values: str) -> str:
        suffix = "f64" if self.lanes == 1 else f"v{self.lanes}f{8 * self._bytes}"
        arguments = ", ".join(f"{self.type} {value}" for value in values)
        return self.value(f"call {flags} {self.type} @llvm.{name}.{suffix}({arguments})")


def vector(lanes: int) -> str:
    """Return the type of whole vectors.

    Args:
        lanes: `SINGLE`, or else it is of double precision.
    """
    return f"<{SINGLE} x float>" if lanes == SINGLE else VECTOR


def splat(value: float, lanes: int = CHUNK) -> str:
    """Return a vector constant.

    Args:
        value: Of all its numbers.
        lanes: As `vector` takes them.
    """
    if lanes != SINGLE:
        return "<" + ", ".join([f"double {value!r}"] * CHUNK) + ">"
    rounded = struct.unpack("f", struct.pack("f", value))[0]
    return "<" + ", ".join([f"float 0x{struct.pack('>d', rounded).hex()}"] * SINGLE) + ">"


# ----------------------------------------------------------------------------------------------------------------------
# Assembler: LLVM assembly to machine code in memory, and arrays that begin where vectors like it.
# ----------------------------------------------------------------------------------------------------------------------


LONG = 2_500_000
"""Characters of assembly from which compiling takes more than a second, of some thousand lines of a model."""


def aligned(*shape: int, single: bool = False) -> Floats:
    """Return zeros that begin at a whole vector of memory, so that no load straddles two cache lines.

    Args:
        shape: Of the array.
        single: Whether its numbers are of single precision.
    """
    count, side = int(np.prod(shape)), SINGLE if single else CHUNK
    room: Any = np.zeros(count + side, dtype=np.float32 if single else np.float64)
    first = -(room.ctypes.data // room.itemsize) % side
    return room[first : first + count].reshape(shape)  # type: ignore[no-any-return]


_NOTHING = ctypes.c_char * 0
_NO_CALLS: Mapping[str, int] = MappingProxyType({})


def address(array: Floats | Ints) -> int:
    """Return where an array begins in memory; much quicker than its own `ctypes`.

    Args:
        array: Writable, rows one after the other.
    """
    return ctypes.addressof(_NOTHING.from_buffer(array))  # type: ignore[arg-type]


def machine_code(text: str, called: Mapping[str, int] = _NO_CALLS, *, optimised: bool = False) -> Any:
    """Return the engine that holds the machine code of an assembly, compiled or as it was kept.

    Args:
        text: LLVM assembly.
        called: Where in memory the functions are that it only declares, by name.
        optimised: Whether LLVM's passes go over it: not over code without redundancy, where they gain nothing.
    """
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    for name, place in called.items():
        llvm.add_symbol(name, place)
    triple, features = llvm.Target.from_default_triple(), llvm.get_host_cpu_features().flatten()
    cpu = llvm.get_host_cpu_name()
    target = triple.create_target_machine(cpu=cpu, features=features, opt=3)
    key = "\n".join([str(triple), cpu, features, text])
    kept = kept_code(key)
    if not kept and len(text) > LONG:
        notice(COMPILING)
    module = llvm.parse_assembly("" if kept else text)
    engine = llvm.create_mcjit_compiler(module, target)
    if kept:
        engine.add_object_file(llvm.ObjectFileRef.from_data(kept))
    else:
        module.verify()
        if optimised:
            tuning = llvm.create_pipeline_tuning_options(speed_level=2)
            llvm.create_pass_builder(target, tuning).getModulePassManager().run(
                module, llvm.create_pass_builder(target, tuning)
            )
        engine.set_object_cache(notify_func=lambda _, code: keep_code(key, code))
    engine.finalize_object()
    return engine
