"""Crests: least and greatest of columns between their rows too, by generated code.

Between two rows the value is the polynomial through six, looked at in quarters, where a parabola tells the crest. What
the polynomial through four differs by is told beside it: the error of that one, and several times that of six.

Source: Lagrange's interpolation; with φ the angle between rows, the error of a wave is 3 φ⁴/128 by four rows and
5 φ⁶/1024 by six.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import cache

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.assembler import address, machine_code
from gearwright.dynamics.codegen.emit import CHUNK, VECTOR, Emitter, splat

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
        _code()[0](count, address(rows) + 8 * width * (first - BEFORE), address(crests), width, width)


def crests_code() -> int:
    """Return the address of the code, for compiled loops: (intervals, table, crests, its width, that of crests).

    Columns go by whole vectors: those of the table after the last of the crests are read, too.
    """
    return _code()[1]


@cache
def _code() -> tuple[Callable[..., None], int, object]:
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
