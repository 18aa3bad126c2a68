"""Generated code for rows of a time history: linear recurrence, extreme values and statistics."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.dynamics.codegen.assembler import CHUNK, VECTOR, Emitter, address, aligned, machine_code, splat

# ----------------------------------------------------------------------------------------------------------------------
# Recurrence: z(k + 1) = Φ z(k) with outputs C z(k), generated for its size and run in one compiled loop.
#
# Eight steps go side by side: their eight successors are Φ⁸ times them. Each column of Φ⁸ and C is then read once for
# eight steps, and sums for a strip of rows stay in vector registers, so that the multiplications set the time.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Crests: least and greatest of columns between their rows too, by generated code.
#
# Between two rows the value is the polynomial through six, looked at in quarters, where a parabola tells the crest.
# What the polynomial through four differs by is told beside it: the error of that one, and several times that of six.
#
# Source: Lagrange's interpolation; with φ the angle between rows, the error of a wave is 3 φ⁴/128 by four rows and
# 5 φ⁶/1024 by six.
# ----------------------------------------------------------------------------------------------------------------------


BEFORE, AFTER = 2, 3
"""Rows that an interval needs before its first one and after it."""
KEPT = ("hi", "lo", "hib", "lob", "p")
"""Greatest and least, the same with what they may be off by, and the last point before the next interval."""


def bring_crests(rows: Floats, first: int, count: int, crests: Floats) -> None:
    """Bring crests up to date with some intervals between the rows of a table.

    Args:
        rows: Shape (rows, columns), whole vectors wide.
        first: Row at which the first interval begins.
        count: Intervals.
        crests: As `blank_crests` makes them.
    """
    width = crests.shape[1]
    if width:
        _crest_code()[0](count, address(rows) + 8 * width * (first - BEFORE), address(crests), width, width)


def crests_code() -> int:
    """Return the address of the code, for compiled loops: (intervals, table, crests, its width, that of crests).

    Columns go by whole vectors: those of the table after the last of the crests are read, too.
    """
    return _crest_code()[1]


@cache
def _crest_code() -> tuple[Callable[..., None], int, object]:
    """Return the function, for tables of any width, its address, and the engine that keeps it in memory."""
    engine = machine_code(_loop())
    signature = ctypes.CFUNCTYPE(None, ctypes.c_int64, *[ctypes.c_void_p] * 2, *[ctypes.c_int64] * 2)
    place = int(engine.get_function_address("crests"))
    return signature(place), place, engine


def blank_crests(width: int) -> Floats:
    """Return the crests of no rows, a row for each of `KEPT`, shape (5, width).

    Args:
        width: Numbers in a row.
    """
    crests = np.full((len(KEPT), width), np.nan)
    crests[:4] = np.array([-np.inf, np.inf, -np.inf, np.inf])[:, None]
    return crests


def _loop() -> str:
    """Return the loop over eight columns after the other, and in it the loop over intervals.

    Six rows and the crests stay in registers.
    """
    rows = [f"%x{place}" for place in range(6)]
    starts, before, phis = list[str](), list[str](), list[str]()
    for place, row in enumerate(rows[:5]):
        starts.append(f"{row}i = mul i64 %width, {place}")
        before += [f"{row}j = add i64 {row}i, %first", f"{row}at = getelementptr double, ptr %table, i64 {row}j",
                   f"{row}a = load {VECTOR}, ptr {row}at, align 8"]  # fmt: skip
        phis.append(f"{row} = phi {VECTOR} [{row}a, %strip], [{rows[place + 1]}, %head]")
    values, after = _interval(rows, {word: f"%{word}" for word in KEPT})
    for place, word in enumerate(KEPT):
        starts.append(f"%{word}i = mul i64 %columns, {place}")
        before += [f"%{word}j = add i64 %{word}i, %first",
                   f"%{word}at = getelementptr double, ptr %crests, i64 %{word}j",
                   f"%{word}a = load {VECTOR}, ptr %{word}at, align 8"]  # fmt: skip
        phis.append(f"%{word} = phi {VECTOR} [%{word}a, %strip], [{after[word]}, %head]")
    load = ["%o = mul i64 %i, %width", "%f = add i64 %o, %x5i", "%g = add i64 %f, %first",
            "%x5at = getelementptr double, ptr %table, i64 %g", f"%x5 = load {VECTOR}, ptr %x5at, align 8"]  # fmt: skip
    stores = [f"store {VECTOR} {after[word]}, ptr %{word}at, align 8" for word in KEPT]
    return "\n".join([
        "declare <8 x double> @llvm.fabs.v8f64(<8 x double>)", "",
        "define void @crests(i64 %rows, ptr noalias %table, ptr noalias %crests, i64 %width, i64 %columns) {",
        "entry:", *starts, "%x5i = mul i64 %width, 5", "br label %strip",
        "strip:", "%first = phi i64 [0, %entry], [%past, %after]", *before, "br label %head",
        "head:", "%i = phi i64 [0, %strip], [%n, %head]", *phis, *load, *values,
        "%n = add i64 %i, 1", "%m = icmp slt i64 %n, %rows", "br i1 %m, label %head, label %after",
        "after:", *stores, f"%past = add i64 %first, {CHUNK}", "%more = icmp slt i64 %past, %columns",
        "br i1 %more, label %strip, label %end", "end:", "ret void", "}",
    ])  # fmt: skip


def _interval(rows: list[str], kept: dict[str, str]) -> tuple[list[str], dict[str, str]]:
    """Return the instructions of one interval between the third row and the fourth, and what is kept after it."""
    code, nodes = Emitter(CHUNK), np.arange(-BEFORE, AFTER + 1, dtype=np.float64)
    quarters = [_mixed(code, rows, lagrange(nodes, theta)) for theta in (0.25, 0.5, 0.75)]
    points = [kept["p"], rows[2], *quarters, rows[3]]
    off = code.size(_mixed(code, rows, lagrange(nodes, 0.5) - np.pad(lagrange(nodes[1:-1], 0.5), 1)))
    tops = [_vertex(code, points[place : place + 3]) for place in range(len(points) - 2)]
    after = {"p": quarters[-1]}
    for word, pick, reach in (("hi", code.larger, code.add), ("lo", code.smaller, code.subtract)):
        top = pick(pick(tops[0], tops[1]), pick(tops[2], tops[3]))
        after[word], after[f"{word}b"] = pick(top, kept[word]), pick(reach(top, off), kept[f"{word}b"])
    return code.lines, after


def lagrange(nodes: Floats, theta: float) -> Floats:
    """Return the weights of values at nodes in the polynomial through them.

    Args:
        nodes: Where values are known.
        theta: Where it is wanted.
    """
    others = [np.delete(nodes, place) for place in range(len(nodes))]
    return np.array([np.prod((theta - other) / (node - other)) for node, other in zip(nodes, others, strict=True)])


def _mixed(code: Emitter, rows: list[str], weights: Floats) -> str:
    return code.total([code.multiply(row, splat(float(w))) for row, w in zip(rows, weights, strict=True) if w])


def _vertex(code: Emitter, points: list[str]) -> str:
    """Return the crest near the middle of three points, b + (w − u)²/(8 (u + w)) with u = b − a, w = b − c, or b."""
    before, middle, after = points
    rise, fall = code.subtract(middle, before), code.subtract(middle, after)
    apart = code.subtract(fall, rise)
    height = code.value(f"fdiv {VECTOR} {code.multiply(apart, apart)}, "
                        f"{code.multiply(code.add(rise, fall), splat(8.0))}")  # fmt: skip
    crest = code.value(f"fcmp ogt {VECTOR} {code.multiply(rise, fall)}, {splat(0.0)}")
    return code.value(f"select <{CHUNK} x i1> {crest}, {VECTOR} {code.add(middle, height)}, {VECTOR} {middle}")


# ----------------------------------------------------------------------------------------------------------------------
# Summary: least, most, sum and sum of squares of each column of a record, by generated code.
# ----------------------------------------------------------------------------------------------------------------------


SUMMARY_STRIP = 4
"""Vectors of columns whose four statistics fit into the registers together."""


def summarise(record: Floats, summary: Floats) -> None:
    """Bring a summary (least, most, sum, sum of squares of each column) up to date with a record.

    Args:
        record: Shape (rows, columns), whole vectors wide.
        summary: Shape (4, columns).
    """
    _summary_code()[0](len(record), address(record), address(summary), summary.shape[1])


def summary_code() -> int:
    """Return the address of the code, for compiled loops: (rows, record, summary, width)."""
    return _summary_code()[1]


@cache
def _summary_code() -> tuple[Callable[..., None], int, object]:
    """Return the function, for records of any width, its address, and the engine that keeps it in memory."""
    engine = machine_code(_summary_loop())
    signature = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64)
    place = int(engine.get_function_address("summarise"))
    return signature(place), place, engine


def _summary_loop() -> str:
    """Return the function that goes over a record in strips of columns whose summary stays in registers."""
    narrow = "\n".join(_call(chunks) for chunks in range(1, SUMMARY_STRIP))
    cases = " ".join(f"i64 {chunks}, label %narrow{chunks}" for chunks in range(1, SUMMARY_STRIP))
    functions = "\n\n".join(_summary_strip(chunks) for chunks in range(1, SUMMARY_STRIP + 1))
    return f"""{functions}

define void @summarise(i64 %rows, ptr noalias %record, ptr noalias %summary, i64 %width) {{
entry:
  %chunks = udiv i64 %width, {CHUNK}
  br label %strip
strip:
  %first = phi i64 [0, %entry], [%past, %wide]
  %gone = udiv i64 %first, {CHUNK}
  %left = sub i64 %chunks, %gone
  %more = icmp uge i64 %left, {SUMMARY_STRIP}
  br i1 %more, label %wide, label %rest
wide:
  call void @strip{SUMMARY_STRIP}(i64 %rows, ptr %record, ptr %summary, i64 %width, i64 %first)
  %past = add i64 %first, {SUMMARY_STRIP * CHUNK}
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


def _summary_strip(chunks: int) -> str:
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
