"""Native: generated assembly joined into one Runge–Kutta loop, compiled in memory and called through a pointer."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import llvmlite.binding as llvm
import numpy as np

from gearwright.dynamics.generate import CHUNK, Writer, record_width, state_size, state_width, table_width
from gearwright.dynamics.system import Floats
from gearwright.dynamics.topology import Layout, Topology

Advance = Callable[[int, Floats, Floats, Floats, Floats, Floats, Floats], None]
"""(steps, parameters, each lane's own parameters, clock table, state, record, summary): carries the state on in place.

For one trajectory each step fills a row of `record`, and `summary` takes least, most, sum and sum of squares of its
columns. Lanes keep no record; their summary is of the line forces.
"""


class Compiled(NamedTuple):
    """Machine code of one structure."""

    advance: Advance
    """Runs a block of steps."""
    derivative: int
    """Address of the right-hand side alone, (parameters, clock row, state, slope, output); 0 for lanes."""
    engine: Any
    """Keeps the machine code in memory."""
    assembly: str
    """What was compiled, to read."""


@lru_cache(maxsize=64)
def compiled(shape: Topology, layout: Layout, lanes: int = 1, own: frozenset[str] = frozenset()) -> Compiled:
    """Return the machine code for a structure; each structure is compiled once.

    Args:
        shape: Structure.
        layout: Places of the numbers, which follow from the structure.
        lanes: 1 for a single trajectory with every step recorded; 8 for as many side by side with statistics.
        own: Fields of `Layout`, and ``"clock"``, that each lane has to itself; all others are alike.
    """
    text = assembly(shape, layout, lanes, own)
    engine = machine_code(text)
    pointer, whole = ctypes.c_void_p, ctypes.c_int64
    signature = ctypes.CFUNCTYPE(None, whole, *[pointer] * 6)
    function = signature(engine.get_function_address("advance"))

    def advance(steps: int, *arrays: Floats) -> None:
        function(steps, *(array.ctypes.data for array in arrays))

    alone = int(engine.get_function_address("derivative")) if lanes == 1 else 0
    return Compiled(advance, alone, engine, text)


def aligned(*shape: int) -> Floats:
    """Return zeros that begin at a whole vector of memory, so that no load straddles two cache lines.

    Args:
        shape: Of the array.
    """
    count = int(np.prod(shape))
    room = np.zeros(count + CHUNK)
    first = -(room.ctypes.data // 8) % CHUNK
    return room[first : first + count].reshape(shape)


def assembly(shape: Topology, layout: Layout, lanes: int, own: frozenset[str] = frozenset()) -> str:
    """Return the LLVM assembly of a structure.

    Args:
        shape: Structure.
        layout: Places of the numbers.
        lanes: Trajectories side by side.
        own: Numbers that each lane has to itself.
    """
    writer = Writer(shape, layout, lanes, own)
    look = writer.slope("look", "record" if lanes == 1 else "statistics")
    parts = [_DECLARATIONS, writer.instant(), look, writer.slope("slope", ""), _loop(shape, lanes, own)]
    return "\n\n".join([*parts, *([_alone(len(shape.lines))] if lanes == 1 else [])])


def _alone(lines: int) -> str:
    """Return the function that works out one derivative, for steps of any length."""
    pointers = ", ".join(f"ptr noalias %{name}" for name in ("p", "row", "y", "dy", "out"))
    return f"""define void @derivative({pointers}) {{
  %now = alloca [{4 * lines} x double], align 64
  call void @instant(ptr %p, ptr %p, ptr %row, ptr %now)
  call void @look(ptr %p, ptr %p, ptr %row, ptr %now, ptr %y, ptr %dy, ptr %out)
  ret void
}}"""


_DECLARATIONS = """declare double @llvm.fabs.f64(double)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)"""


def machine_code(text: str) -> Any:
    """Return the engine that holds the machine code of an assembly.

    Args:
        text: LLVM assembly.
    """
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    triple, features = llvm.Target.from_default_triple(), llvm.get_host_cpu_features().flatten()
    # The assembly is straight-line code without redundancy: optimising passes before code generation gain nothing.
    target = triple.create_target_machine(cpu=llvm.get_host_cpu_name(), features=features, opt=3)
    module = llvm.parse_assembly(text)
    module.verify()
    engine = llvm.create_mcjit_compiler(module, target)
    engine.finalize_object()
    return engine


def _loop(shape: Topology, lanes: int, own: frozenset[str]) -> str:
    """Return the function that takes the steps: the classical fourth-order Runge–Kutta method."""
    width = state_width(shape, lanes)
    row = table_width(shape) * (lanes if "clock" in own else 1)
    numbers = 2 * shape.size
    stride = record_width(shape) if lanes == 1 else 0
    keep = f"  call void @llvm.memcpy.p0.p0.i64(ptr %place, ptr %y, i64 {8 * numbers}, i1 false)" if lanes == 1 else ""
    seen = f"%seen = getelementptr double, ptr %place, i64 {numbers}" if lanes == 1 else _SEEN_LANES
    arrays = "\n".join(f"  %{name} = alloca [{width} x double], align 64" for name in ("y", "s", "k", "sum"))
    clear = "\n".join(
        f"  call void @llvm.memset.p0.i64(ptr %{name}, i8 0, i64 {8 * width}, i1 false)"
        for name in ("y", "s", "k", "sum")
    )
    size = 8 * state_size(shape) * lanes
    names = ("p", "own", "table", "state", "out", "summary")
    pointers = "i64 %steps, " + ", ".join(f"ptr noalias %{name}" for name in names)
    return f"""define void @advance({pointers}) {{
entry:
{arrays}
  %now = alloca [{4 * len(shape.lines) * lanes} x double], align 64
{clear}
  call void @llvm.memcpy.p0.p0.i64(ptr %y, ptr %state, i64 {size}, i1 false)
  {_SPREAD_STEP}
  %half = fmul <8 x double> %h, {_splat(0.5)}
  %sixth = fmul <8 x double> %h, {_splat(1.0 / 6.0)}
  call void @instant(ptr %p, ptr %own, ptr %table, ptr %now)
  br label %head
head:
  %i = phi i64 [0, %entry], [%next, %head]
  %twice = mul i64 %i, {2 * row}
  %row0 = getelementptr double, ptr %table, i64 %twice
  %row1 = getelementptr double, ptr %row0, i64 {row}
  %row2 = getelementptr double, ptr %row1, i64 {row}
  %offset = mul i64 %i, {stride}
  %place = getelementptr double, ptr %out, i64 %offset
  {seen}
{keep}
  call void @look(ptr %p, ptr %own, ptr %row0, ptr %now, ptr %y, ptr %k, ptr %seen)
{summary_update(stride)}
{_stage("a", width, "%half", "first")}
  call void @instant(ptr %p, ptr %own, ptr %row1, ptr %now)
  call void @slope(ptr %p, ptr %own, ptr %row1, ptr %now, ptr %s, ptr %k, ptr %seen)
{_stage("b", width, "%half", "middle")}
  call void @slope(ptr %p, ptr %own, ptr %row1, ptr %now, ptr %s, ptr %k, ptr %seen)
{_stage("c", width, "%h", "middle")}
  call void @instant(ptr %p, ptr %own, ptr %row2, ptr %now)
  call void @slope(ptr %p, ptr %own, ptr %row2, ptr %now, ptr %s, ptr %k, ptr %seen)
{_stage("d", width, "%sixth", "last")}
  %next = add i64 %i, 1
  %more = icmp slt i64 %next, %steps
  br i1 %more, label %head, label %done
done:
  call void @llvm.memcpy.p0.p0.i64(ptr %state, ptr %y, i64 {size}, i1 false)
  ret void
}}"""


_SEEN_LANES = "%seen = getelementptr double, ptr %summary, i64 0"
_SPREAD_STEP = """%one = load double, ptr %p, align 8
  %lone = insertelement <8 x double> poison, double %one, i64 0
  %h = shufflevector <8 x double> %lone, <8 x double> poison, <8 x i32> zeroinitializer"""


def summary_update(width: int) -> str:
    """Return the assembly that updates least, most, sum and sum of squares with the row at %place.

    Args:
        width: Numbers in a row, whole vectors.
    """
    lines, vector = [], "<8 x double>"
    for i in range(0, width, CHUNK):
        lines.append(f"%rp{i} = getelementptr double, ptr %place, i64 {i}")
        lines.append(f"%row{i}v = load {vector}, ptr %rp{i}, align 8")
        for part, word in enumerate(("lo", "hi", "su", "sq")):
            lines.append(f"%{word}p{i} = getelementptr double, ptr %summary, i64 {part * width + i}")
            lines.append(f"%{word}{i} = load {vector}, ptr %{word}p{i}, align 8")
        lines.append(f"%lm{i} = fcmp ult {vector} %row{i}v, %lo{i}")
        lines.append(f"%lon{i} = select <8 x i1> %lm{i}, {vector} %row{i}v, {vector} %lo{i}")
        lines.append(f"%hm{i} = fcmp ugt {vector} %row{i}v, %hi{i}")
        lines.append(f"%hin{i} = select <8 x i1> %hm{i}, {vector} %row{i}v, {vector} %hi{i}")
        lines.append(f"%sun{i} = fadd {vector} %su{i}, %row{i}v")
        lines.append(f"%sqm{i} = fmul contract {vector} %row{i}v, %row{i}v")
        lines.append(f"%sqn{i} = fadd contract {vector} %sq{i}, %sqm{i}")
        lines += [f"store {vector} %{word}n{i}, ptr %{word}p{i}, align 8" for word in ("lo", "hi", "su", "sq")]
    return "\n".join(f"  {line}" for line in lines)


def _splat(value: float) -> str:
    return "<" + ", ".join([f"double {value!r}"] * CHUNK) + ">"


def _stage(tag: str, width: int, factor: str, which: str) -> str:
    """Return the sums after a slope: s = y + factor k and sum += (1 or 2) k; after the last, y += factor (sum + k)."""
    lines = []
    vector, flags = "<8 x double>", "contract"
    for i in range(0, width, CHUNK):
        name = f"{tag}{i}"
        for pointer in ("y", "k", "sum", "s"):
            lines.append(f"%{pointer}p{name} = getelementptr double, ptr %{pointer}, i64 {i}")
        for pointer in ("y", "k", "sum"):
            lines.append(f"%{pointer}{name} = load {vector}, ptr %{pointer}p{name}, align 64")
        if which == "first":
            lines.append(f"store {vector} %k{name}, ptr %sump{name}, align 64")
        elif which == "middle":
            lines.append(f"%d{name} = fmul {flags} {vector} %k{name}, {_splat(2.0)}")
            lines.append(f"%n{name} = fadd {flags} {vector} %sum{name}, %d{name}")
            lines.append(f"store {vector} %n{name}, ptr %sump{name}, align 64")
        else:
            lines.append(f"%n{name} = fadd {flags} {vector} %sum{name}, %k{name}")
        change, target = ("n", "yp") if which == "last" else ("k", "sp")
        lines.append(f"%m{name} = fmul {flags} {vector} {factor}, %{change}{name}")
        lines.append(f"%r{name} = fadd {flags} {vector} %y{name}, %m{name}")
        lines.append(f"store {vector} %r{name}, ptr %{target}{name}, align 64")
    return "\n".join(f"  {line}" for line in lines)
