"""Summary: least, most, sum and sum of squares of each column of a record, by generated code."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import cache

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.assembler import address, machine_code
from gearwright.dynamics.codegen.emit import CHUNK, VECTOR

STRIP = 4
"""Vectors of columns whose four statistics fit into the registers together."""


def summarise(record: Floats, summary: Floats) -> None:
    """Bring a summary (least, most, sum, sum of squares of each column) up to date with a record.

    Args:
        record: Shape (rows, columns), whole vectors wide.
        summary: Shape (4, columns).
    """
    _code()[0](len(record), address(record), address(summary), summary.shape[1])


def summary_code() -> int:
    """Return the address of the code, for compiled loops: (rows, record, summary, width)."""
    return _code()[1]


@cache
def _code() -> tuple[Callable[..., None], int, object]:
    """Return the function, for records of any width, its address, and the engine that keeps it in memory."""
    engine = machine_code(_summary_loop())
    signature = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64)
    place = int(engine.get_function_address("summarise"))
    return signature(place), place, engine


def _summary_loop() -> str:
    """Return the function that goes over a record in strips of columns whose summary stays in registers."""
    narrow = "\n".join(_call(chunks) for chunks in range(1, STRIP))
    cases = " ".join(f"i64 {chunks}, label %narrow{chunks}" for chunks in range(1, STRIP))
    functions = "\n\n".join(_strip(chunks) for chunks in range(1, STRIP + 1))
    return f"""{functions}

define void @summarise(i64 %rows, ptr noalias %record, ptr noalias %summary, i64 %width) {{
entry:
  %chunks = udiv i64 %width, {CHUNK}
  br label %strip
strip:
  %first = phi i64 [0, %entry], [%past, %wide]
  %gone = udiv i64 %first, {CHUNK}
  %left = sub i64 %chunks, %gone
  %more = icmp uge i64 %left, {STRIP}
  br i1 %more, label %wide, label %rest
wide:
  call void @strip{STRIP}(i64 %rows, ptr %record, ptr %summary, i64 %width, i64 %first)
  %past = add i64 %first, {STRIP * CHUNK}
  br label %strip
rest:
  switch i64 %left, label %end [{cases}]
{narrow}
end:
  ret void
}}"""


def _call(chunks: int) -> str:
    return f"""narrow{chunks}:
  call void @strip{chunks}(i64 %rows, ptr %record, ptr %summary, i64 %width, i64 %first)
  br label %end"""


def _strip(chunks: int) -> str:
    """Return the function that goes over so many vectors of columns from a first column on."""
    words = ("lo", "hi", "su", "sq")
    before = [f"%{word}b = mul i64 %width, {row}" for row, word in enumerate(words)]
    loop, after = list[str](), list[str]()
    for c in range(chunks):
        before.append(f"%c{c} = add i64 %first, {CHUNK * c}")
        for word in words:
            before.append(f"%{word}i{c} = add i64 %{word}b, %c{c}")
            before.append(f"%{word}p{c} = getelementptr double, ptr %summary, i64 %{word}i{c}")
            before.append(f"%{word}a{c} = load {VECTOR}, ptr %{word}p{c}, align 8")
            loop.append(f"%{word}{c} = phi {VECTOR} [%{word}a{c}, %before], [%{word}n{c}, %head]")
            after.append(f"store {VECTOR} %{word}n{c}, ptr %{word}p{c}, align 8")
    loop += ["%offset = mul i64 %i, %width"]
    for c in range(chunks):
        loop += [
            f"%at{c} = add i64 %offset, %c{c}",
            f"%p{c} = getelementptr double, ptr %record, i64 %at{c}",
            f"%x{c} = load {VECTOR}, ptr %p{c}, align 8",
            f"%lm{c} = fcmp olt {VECTOR} %x{c}, %lo{c}",
            f"%lon{c} = select <8 x i1> %lm{c}, {VECTOR} %x{c}, {VECTOR} %lo{c}",
            f"%hm{c} = fcmp ogt {VECTOR} %x{c}, %hi{c}",
            f"%hin{c} = select <8 x i1> %hm{c}, {VECTOR} %x{c}, {VECTOR} %hi{c}",
            f"%sun{c} = fadd {VECTOR} %su{c}, %x{c}",
            f"%sqm{c} = fmul contract {VECTOR} %x{c}, %x{c}",
            f"%sqn{c} = fadd contract {VECTOR} %sq{c}, %sqm{c}",
        ]
    loop += ["%next = add i64 %i, 1", "%more = icmp slt i64 %next, %rows", "br i1 %more, label %head, label %after"]
    numbers = "i64 %rows, ptr noalias %record, ptr noalias %summary, i64 %width, i64 %first"
    head = f"define internal void @strip{chunks}({numbers}) noinline {{"
    parts = [head, "before:", *before, "br label %head", "head:", "%i = phi i64 [0, %before], [%next, %head]", *loop]
    return "\n".join([*parts, "after:", *after, "ret void", "}"])
