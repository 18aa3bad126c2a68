"""Recurrence: z(k + 1) = Φ z(k) with outputs C z(k), generated for its size and run in one compiled loop.

One pass over the columns of Φ and C gives both the next state and this step's outputs, all of it in vector registers,
so that a step costs one multiplication for each entry and no call.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

from gearwright.dynamics.generate import CHUNK
from gearwright.dynamics.native import aligned, machine_code, summary_update
from gearwright.dynamics.system import Floats

Run = Callable[[Floats, Floats, Floats], Floats]
"""(state, record, summary): fills the record's rows and its summary, returns the state after them."""
VECTOR = "<8 x double>"


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
        step: Φ, shape (states, states).
        output: C, shape (outputs, states).
        size: Sizes.
    """
    code = _compiled(size)
    states, chunks = size.state_chunks * CHUNK, size.output_chunks * CHUNK
    columns = aligned(size.states, states + chunks)
    columns[:, : size.states], columns[:, states : states + size.outputs] = step.T, output.T

    def run(state: Floats, record: Floats, summary: Floats) -> Floats:
        filled = aligned(states)
        filled[: size.states] = state
        addresses = (array.ctypes.data for array in (columns, filled, record, summary))
        code[0](len(record), *addresses)
        return filled[: size.states]

    return run


@lru_cache(maxsize=64)
def _compiled(size: Size) -> tuple[Callable[..., None], object]:
    """Return the function and the engine that keeps it in memory."""
    engine = machine_code(_assembly(size))
    signature = ctypes.CFUNCTYPE(None, ctypes.c_int64, *[ctypes.c_void_p] * 4)
    return signature(engine.get_function_address("recur")), engine


def _assembly(size: Size) -> str:
    accumulators = range(size.state_chunks + size.output_chunks)
    starts = "\n".join(f"  %a{i} = phi {VECTOR} [zeroinitializer, %step], [%b{i}, %column]" for i in accumulators)
    sums = "\n".join(
        f"  %m{i} = getelementptr double, ptr %here, i64 {CHUNK * i}\n"
        f"  %l{i} = load {VECTOR}, ptr %m{i}, align 8\n"
        f"  %f{i} = fmul contract {VECTOR} %l{i}, %z\n"
        f"  %b{i} = fadd contract {VECTOR} %a{i}, %f{i}"
        for i in accumulators
    )
    return f"""declare void @llvm.masked.store.v8f64.p0({VECTOR}, ptr, i32, <8 x i1>)

define void @recur(i64 %steps, ptr noalias %columns, ptr noalias %state, ptr noalias %record, ptr noalias %summary) {{
entry:
  br label %step
step:
  %k = phi i64 [0, %entry], [%next, %done]
  %offset = mul i64 %k, {size.width}
  %place = getelementptr double, ptr %record, i64 %offset
  br label %column
column:
  %j = phi i64 [0, %step], [%after, %column]
{starts}
  %zp = getelementptr double, ptr %state, i64 %j
  %one = load double, ptr %zp, align 8
  %lone = insertelement {VECTOR} poison, double %one, i64 0
  %z = shufflevector {VECTOR} %lone, {VECTOR} poison, <8 x i32> zeroinitializer
  %row = mul i64 %j, {CHUNK * len(accumulators)}
  %here = getelementptr double, ptr %columns, i64 %row
{sums}
  %after = add i64 %j, 1
  %more = icmp slt i64 %after, {size.states}
  br i1 %more, label %column, label %done
done:
{_stores(size)}
{summary_update(size.width)}
  %next = add i64 %k, 1
  %again = icmp slt i64 %next, %steps
  br i1 %again, label %step, label %end
end:
  ret void
}}"""


def _stores(size: Size) -> str:
    """Return the stores of a row (the state as it was, then the outputs) and of the next state."""
    lines = []
    for i in range(-(-size.kept // CHUNK)):
        lines.append(f"%op{i} = getelementptr double, ptr %state, i64 {CHUNK * i}")
        lines.append(f"%ol{i} = load {VECTOR}, ptr %op{i}, align 8")
        lines.append(_store(f"%ol{i}", ("%place", CHUNK * i), min(CHUNK, size.kept - CHUNK * i), f"o{i}"))
    for i in range(size.output_chunks):
        value = f"%b{size.state_chunks + i}"
        place = ("%place", size.kept + CHUNK * i)
        lines.append(_store(value, place, min(CHUNK, size.outputs - CHUNK * i), f"u{i}"))
    for i in range(size.state_chunks):
        lines.append(_store(f"%b{i}", ("%state", CHUNK * i), CHUNK, f"s{i}"))
    return "\n".join(f"  {line}" for line in lines)


def _store(value: str, place: tuple[str, int], count: int, tag: str) -> str:
    """Return a store of the first `count` numbers of a vector."""
    pointer, index = place
    mask = ", ".join(f"i1 {'true' if number < count else 'false'}" for number in range(CHUNK))
    address = f"%t{tag} = getelementptr double, ptr {pointer}, i64 {index}"
    call = f"call void @llvm.masked.store.v8f64.p0({VECTOR} {value}, ptr %t{tag}, i32 8, <8 x i1> <{mask}>)"
    return f"{address}\n  {call}"
