"""Recurrence: z(k + 1) = Φ z(k) with outputs C z(k), generated for its size and run in one compiled loop.

Eight steps go side by side: their eight successors are Φ⁸ times them. Each column of Φ⁸ and C is then read once for
eight steps, and sums for a strip of rows stay in vector registers, so that the multiplications set the time.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.assembler import address, aligned, machine_code
from gearwright.dynamics.codegen.emit import CHUNK, VECTOR

Run = Callable[[Floats, Floats], None]
"""(eight states, record): fills the record's rows, a whole number of times eight."""
SIDE = 8
"""Steps that go side by side."""
STRIP = 3
"""Most vectors of rows in a strip: three times eight sums fill the registers."""


class Size(NamedTuple):
    """Sizes of a recurrence: the key of its code."""

    states: int
    """Numbers in z."""
    kept: int
    """How many of z, from the first on, begin a row of the record."""
    outputs: int
    """Numbers after them in a row."""
    width: int
    """Numbers in a row, filled up to whole vectors."""

    @property
    def state_chunks(self) -> int:
        """Vectors in a state."""
        return -(-self.states // CHUNK)

    @property
    def output_chunks(self) -> int:
        """Vectors in the outputs."""
        return -(-self.outputs // CHUNK)


def recurrence(step: Floats, output: Floats, size: Size) -> Run:
    """Return the runner of a recurrence.

    Args:
        step: Φ⁸, shape (states, states).
        output: C, shape (outputs, states).
        size: Sizes.
    """
    states, chunks = size.state_chunks * CHUNK, size.output_chunks * CHUNK
    columns = aligned(size.states, states + chunks)
    columns[:, : size.states], columns[:, states : states + size.outputs] = step.T, output.T
    code = _compiled(size, tuple(_strips(columns, size)))
    buffers = aligned(2, SIDE, states)

    def run(start: Floats, record: Floats) -> None:
        buffers[0, :, : size.states] = start
        code[0](len(record) // SIDE, *map(address, (columns, buffers[0], buffers[1], record)))

    return run


class Strip(NamedTuple):
    """Vectors of rows that are summed together, over the columns in which one of them is not zero."""

    chunks: range
    """Which vectors."""
    columns: range
    """Deflections need no velocities, for example."""


def _strips(columns: Floats, size: Size) -> Iterator[Strip]:
    """Return the strips of the states, then of the outputs."""
    past = size.state_chunks + size.output_chunks
    for start, stop in ((0, size.state_chunks), (size.state_chunks, past)):
        for first in range(start, stop, STRIP):
            chunks = range(first, min(first + STRIP, stop))
            used = np.flatnonzero(np.any(columns[:, CHUNK * chunks.start : CHUNK * chunks.stop], axis=1))
            yield Strip(chunks, range(int(used[0]), int(used[-1]) + 1) if len(used) else range(1))


@lru_cache(maxsize=64)
def _compiled(size: Size, strips: tuple[Strip, ...]) -> tuple[Callable[..., None], object]:
    """Return the function and the engine that keeps it in memory."""
    engine = machine_code(_assembly(size, strips))
    signature = ctypes.CFUNCTYPE(None, ctypes.c_int64, *[ctypes.c_void_p] * 4)
    return signature(engine.get_function_address("recur")), engine


def _assembly(size: Size, strips: tuple[Strip, ...]) -> str:
    body = "\n".join(_strip(number, strip, size) for number, strip in enumerate(strips))
    pointers = ", ".join(f"ptr noalias %{name}" for name in ("columns", "first", "second", "record"))
    return f"""declare void @llvm.masked.store.v8f64.p0({VECTOR}, ptr, i32, <8 x i1>)

define void @recur(i64 %groups, {pointers}) {{
entry:
  br label %group
group:
  %k = phi i64 [0, %entry], [%next, %before{len(strips)}]
  %here = phi ptr [%first, %entry], [%there, %before{len(strips)}]
  %there = phi ptr [%second, %entry], [%here, %before{len(strips)}]
  %offset = mul i64 %k, {SIDE * size.width}
  %rows = getelementptr double, ptr %record, i64 %offset
{_copies(size)}
  br label %before0
{body}
before{len(strips)}:
  %next = add i64 %k, 1
  %again = icmp slt i64 %next, %groups
  br i1 %again, label %group, label %end
end:
  ret void
}}"""


def _strip(number: int, strip: Strip, size: Size) -> str:
    """Return the sums of a strip of rows of Φ⁸ or C for all eight steps, and their stores."""
    width = CHUNK * (size.state_chunks + size.output_chunks)
    tags = [(step, chunk) for step in range(SIDE) for chunk in strip.chunks]
    start, loop = f"%before{number}", f"%column{number}"
    lines = [f"before{number}:", f"  br label {loop}", f"column{number}:"]
    lines.append(f"  %j{number} = phi i64 [{strip.columns.start}, {start}], [%n{number}, {loop}]")
    lines += [f"  %a{s}.{c} = phi {VECTOR} [zeroinitializer, {start}], [%b{s}.{c}, {loop}]" for s, c in tags]
    lines.append(f"  %row{number} = mul i64 %j{number}, {width}")
    for c in strip.chunks:
        lines.append(f"  %at{c} = add i64 %row{number}, {CHUNK * c}")
        lines.append(f"  %cp{c} = getelementptr double, ptr %columns, i64 %at{c}")
        lines.append(f"  %c{c} = load {VECTOR}, ptr %cp{c}, align 64")
    for s in range(SIDE):
        z = f"{number}.{s}"
        lines.append(f"  %zi{z} = add i64 %j{number}, {s * size.state_chunks * CHUNK}")
        lines.append(f"  %zp{z} = getelementptr double, ptr %here, i64 %zi{z}")
        lines.append(f"  %zs{z} = load double, ptr %zp{z}, align 8")
        lines.append(f"  %zl{z} = insertelement {VECTOR} poison, double %zs{z}, i64 0")
        lines.append(f"  %z{z} = shufflevector {VECTOR} %zl{z}, {VECTOR} poison, <8 x i32> zeroinitializer")
        for c in strip.chunks:
            lines.append(f"  %f{s}.{c} = fmul contract {VECTOR} %c{c}, %z{z}")
            lines.append(f"  %b{s}.{c} = fadd contract {VECTOR} %a{s}.{c}, %f{s}.{c}")
    lines += [f"  %n{number} = add i64 %j{number}, 1", f"  %m{number} = icmp slt i64 %n{number}, {strip.columns.stop}"]
    lines += [f"  br i1 %m{number}, label {loop}, label %after{number}", f"after{number}:"]
    lines += [_store(f"%b{s}.{c}", _place(s, c, size), f"r{s}.{c}") for s, c in tags]
    return "\n".join([*lines, f"  br label %before{number + 1}"])


class _Place(NamedTuple):
    """Where a vector goes."""

    pointer: str
    offset: int
    """In numbers."""
    numbers: int
    """How many of it go there."""


def _place(step: int, chunk: int, size: Size) -> _Place:
    """Return where a vector of sums goes."""
    if chunk < size.state_chunks:
        return _Place("%there", CHUNK * (step * size.state_chunks + chunk), CHUNK)
    first = CHUNK * (chunk - size.state_chunks)
    return _Place("%rows", step * size.width + size.kept + first, min(CHUNK, size.outputs - first))


def _copies(size: Size) -> str:
    """Return the copies of the states as they are into their rows."""
    lines = []
    for s in range(SIDE):
        for i in range(-(-size.kept // CHUNK)):
            tag = f"{s}.{i}"
            lines.append(f"  %op{tag} = getelementptr double, ptr %here, i64 {CHUNK * (s * size.state_chunks + i)}")
            lines.append(f"  %ol{tag} = load {VECTOR}, ptr %op{tag}, align 64")
            place = _Place("%rows", s * size.width + CHUNK * i, min(CHUNK, size.kept - CHUNK * i))
            lines.append(_store(f"%ol{tag}", place, f"o{tag}"))
    return "\n".join(lines)


def _store(value: str, place: _Place, tag: str) -> str:
    """Return a store of the first numbers of a vector."""
    pointer = f"  %t{tag} = getelementptr double, ptr {place.pointer}, i64 {place.offset}"
    if place.numbers == CHUNK:
        return f"{pointer}\n  store {VECTOR} {value}, ptr %t{tag}, align 8"
    mask = ", ".join(f"i1 {'true' if number < place.numbers else 'false'}" for number in range(CHUNK))
    call = f"call void @llvm.masked.store.v8f64.p0({VECTOR} {value}, ptr %t{tag}, i32 8, <8 x i1> <{mask}>)"
    return f"{pointer}\n  {call}"
