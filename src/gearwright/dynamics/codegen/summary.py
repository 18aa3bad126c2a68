"""Summary: least, most, sum and sum of squares of each column of a record, by generated code for its width."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import lru_cache

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.assembler import address, machine_code
from gearwright.dynamics.codegen.emit import CHUNK, VECTOR

STRIP = 4
"""Vectors of columns whose four statistics fit into the registers together."""


@lru_cache(maxsize=64)
def summariser(width: int) -> Callable[[Floats, Floats], None]:
    """Return what brings a summary (least, most, sum, sum of squares of each column) up to date with a record.

    Args:
        width: Numbers in a row, whole vectors.
    """
    engine = machine_code(_summary_loop(width))
    function = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p)(
        engine.get_function_address("summarise")
    )

    def summarise(record: Floats, summary: Floats, *, _code: object = engine) -> None:
        function(len(record), address(record), address(summary))

    return summarise


def _summary_loop(width: int) -> str:
    """Return the function that goes over a record in strips of columns whose summary stays in registers."""
    strips = [range(first, min(first + STRIP, width // CHUNK)) for first in range(0, width // CHUNK, STRIP)]
    body = "\n".join(_strip(number, strip, width) for number, strip in enumerate(strips))
    return f"""define void @summarise(i64 %rows, ptr noalias %record, ptr noalias %summary) {{
entry:
  br label %before0
{body}
before{len(strips)}:
  ret void
}}"""


def _strip(number: int, chunks: range, width: int) -> str:
    words = ("lo", "hi", "su", "sq")
    before, loop, after = [], [], []
    for c in chunks:
        for row, word in enumerate(words):
            before.append(f"%{word}p{c} = getelementptr double, ptr %summary, i64 {row * width + CHUNK * c}")
            before.append(f"%{word}a{c} = load {VECTOR}, ptr %{word}p{c}, align 8")
            loop.append(f"%{word}{c} = phi {VECTOR} [%{word}a{c}, %before{number}], [%{word}n{c}, %head{number}]")
            after.append(f"store {VECTOR} %{word}n{c}, ptr %{word}p{c}, align 8")
    loop += [f"%offset{number} = mul i64 %i{number}, {width}"]
    for c in chunks:
        loop += [
            f"%at{c} = add i64 %offset{number}, {CHUNK * c}",
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
    count = f"%i{number} = phi i64 [0, %before{number}], [%next{number}, %head{number}]"
    ends = [f"%next{number} = add i64 %i{number}, 1", f"%more{number} = icmp slt i64 %next{number}, %rows"]
    ends += [f"br i1 %more{number}, label %head{number}, label %after{number}"]
    parts = [f"before{number}:", *before, f"br label %head{number}", f"head{number}:", count, *loop, *ends]
    return "\n".join([*parts, f"after{number}:", *after, f"br label %before{number + 1}"])
