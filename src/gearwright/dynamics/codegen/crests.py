"""Crests: least and greatest of columns between their rows too, by generated code.

Between two rows the value is the polynomial through six, looked at in quarters, where a parabola tells the crest. What
the polynomial through four differs by is told beside it: the error of that one, and several times that of six.

Source: Lagrange's interpolation; with φ the angle between rows, the error of a wave is 3 φ⁴/128 by four rows and
5 φ⁶/1024 by six.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import lru_cache

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.assembler import address, machine_code
from gearwright.dynamics.codegen.emit import CHUNK, VECTOR, Emitter, splat

BEFORE, AFTER = 2, 3
"""Rows that an interval needs before its first one and after it."""
KEPT = ("hi", "lo", "hib", "lob", "p")
"""Greatest and least, the same with what they may be off by, and the last point before the next interval."""


@lru_cache(maxsize=64)
def crester(width: int) -> Callable[[Floats, int, int, Floats], None]:
    """Return what brings crests up to date with some intervals between the rows of a table.

    It takes the table, the first row and the number of intervals, and the crests as `blank_crests` makes them.

    Args:
        width: Numbers in a row, whole vectors.
    """
    engine = machine_code(_loop(width))
    signature = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p)
    function = signature(engine.get_function_address("crests"))

    def bring(rows: Floats, first: int, count: int, crests: Floats, *, _code: object = engine) -> None:
        function(count, address(rows) + 8 * width * (first - BEFORE), address(crests))

    return bring


def blank_crests(width: int) -> Floats:
    """Return the crests of no rows, a row for each of `KEPT`, shape (5, width).

    Args:
        width: Numbers in a row.
    """
    crests = np.full((len(KEPT), width), np.nan)
    crests[:4] = np.array([-np.inf, np.inf, -np.inf, np.inf])[:, None]
    return crests


def _loop(width: int) -> str:
    strips = range(width // CHUNK)
    body = "\n".join(_strip(number, width) for number in strips)
    return f"""declare <8 x double> @llvm.fabs.v8f64(<8 x double>)

define void @crests(i64 %rows, ptr noalias %table, ptr noalias %crests) {{
entry:
  br label %before0
{body}
before{len(strips)}:
  ret void
}}"""


def _strip(number: int, width: int) -> str:
    """Return the loop over the intervals of eight columns; six rows and the crests stay in registers."""
    rows, first = [f"%x{place}.{number}" for place in range(6)], CHUNK * number
    before, phis = [], []
    for place, row in enumerate(rows[:5]):
        before += [f"{row}at = getelementptr double, ptr %table, i64 {place * width + first}",
                   f"{row}a = load {VECTOR}, ptr {row}at, align 8"]  # fmt: skip
        phis.append(f"{row} = phi {VECTOR} [{row}a, %before{number}], [{rows[place + 1]}, %head{number}]")
    values, after = _interval(rows, {word: f"%{word}.{number}" for word in KEPT}, number)
    for place, word in enumerate(KEPT):
        name = f"%{word}.{number}"
        before += [f"{name}at = getelementptr double, ptr %crests, i64 {place * width + first}",
                   f"{name}a = load {VECTOR}, ptr {name}at, align 8"]  # fmt: skip
        phis.append(f"{name} = phi {VECTOR} [{name}a, %before{number}], [{after[word]}, %head{number}]")
    load = [f"%o{number} = mul i64 %i{number}, {width}", f"%f{number} = add i64 %o{number}, {5 * width + first}",
            f"{rows[5]}at = getelementptr double, ptr %table, i64 %f{number}",
            f"{rows[5]} = load {VECTOR}, ptr {rows[5]}at, align 8"]  # fmt: skip
    ends = [f"%n{number} = add i64 %i{number}, 1", f"%m{number} = icmp slt i64 %n{number}, %rows",
            f"br i1 %m{number}, label %head{number}, label %after{number}"]  # fmt: skip
    stores = [f"store {VECTOR} {after[word]}, ptr %{word}.{number}at, align 8" for word in KEPT]
    count = f"%i{number} = phi i64 [0, %before{number}], [%n{number}, %head{number}]"
    return "\n".join([
        f"before{number}:", *before, f"br label %head{number}", f"head{number}:", count, *phis, *load, *values, *ends,
        f"after{number}:", *stores, f"br label %before{number + 1}",
    ])  # fmt: skip


def _interval(rows: list[str], kept: dict[str, str], number: int) -> tuple[list[str], dict[str, str]]:
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
    lines = [line.replace("%v", f"%s{number}v") for line in code.lines]
    return lines, {word: name.replace("%v", f"%s{number}v") for word, name in after.items()}


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
