"""Ceilings of one core: products and sums in a second, and numbers loaded: python benchmarks/ceilings.py

Loops of whole vectors whose results depend on none of the others, by the assembler that the engine uses.
"""

from __future__ import annotations

import ctypes
import time
from collections.abc import Callable

from gearwright.dynamics.codegen.assembler import address, aligned, machine_code

SUMS, WIDE, ROUNDS = 16, 8, 20_000_000
"""Sums side by side, numbers in a vector, turns of the loop."""
NEAR, LOADS, TIMES = 1024, 16, 400_000
"""Numbers that stay in the nearest cache, vectors that are loaded in a turn, turns."""


def fused(sums: int, rounds: int) -> str:
    """Return a loop of products and sums in registers."""
    kind, numbers = f"<{WIDE} x double>", range(sums)
    heads = [f"%s{n} = phi {kind} [%x, %entry], [%t{n}, %head]" for n in numbers]
    steps = [f"%m{n} = fmul contract {kind} %s{n}, %x\n  %t{n} = fadd contract {kind} %m{n}, %y" for n in numbers]
    adds = [f"%e{n + 1} = fadd {kind} %e{n}, %t{n}" for n in numbers]
    lines = [
        "define void @run(ptr %p) {", "entry:", f"%x = load {kind}, ptr %p, align 64",
        f"%q = getelementptr double, ptr %p, i64 {WIDE}", f"%y = load {kind}, ptr %q, align 64",
        "br label %head", "head:", "%i = phi i64 [0, %entry], [%next, %head]", *heads, *steps,
        "%next = add i64 %i, 1", f"%more = icmp slt i64 %next, {rounds}", "br i1 %more, label %head, label %end",
        "end:", f"%e0 = fadd {kind} %x, %y", *adds, f"store {kind} %e{sums}, ptr %p, align 64", "ret void", "}",
    ]  # fmt: skip
    return "\n".join(lines)


def loads(count: int, times: int) -> str:
    """Return a loop that goes over an array in the nearest cache and adds what it loads to as many sums."""
    kind, numbers = f"<{WIDE} x double>", range(count)
    heads = [f"%s{n} = phi {kind} [zeroinitializer, %entry], [%t{n}, %head]" for n in numbers]
    steps = [
        f"%o{n} = add i64 %at, {WIDE * n}\n  %p{n} = getelementptr double, ptr %p, i64 %o{n}\n"
        f"  %l{n} = load {kind}, ptr %p{n}, align 64\n  %t{n} = fadd {kind} %s{n}, %l{n}"
        for n in numbers
    ]
    adds = [f"%e{n + 1} = fadd {kind} %e{n}, %t{n}" for n in numbers]
    lines = [
        "define void @run(ptr %p) {", "entry:", "br label %head", "head:",
        "%i = phi i64 [0, %entry], [%next, %head]", *heads,
        f"%far = mul i64 %i, {WIDE * count}", f"%at = and i64 %far, {NEAR - 1}", *steps,
        "%next = add i64 %i, 1", f"%more = icmp slt i64 %next, {times}", "br i1 %more, label %head, label %end",
        "end:", f"%e0 = fadd {kind} zeroinitializer, zeroinitializer", *adds,
        f"store {kind} %e{count}, ptr %p, align 64", "ret void", "}",
    ]  # fmt: skip
    return "\n".join(lines)


def quickest(text: str) -> float:
    """Return the least processor time of a few runs [s]: other work on the machine only lengthens it."""
    engine, room = machine_code(text), aligned(NEAR)
    run: Callable[[int], None] = ctypes.CFUNCTYPE(None, ctypes.c_void_p)(engine.get_function_address("run"))
    times = []
    for _ in range(7):
        room[:] = 0.5
        start = time.process_time()
        run(address(room))
        times.append(time.process_time() - start)
    return min(times)


def measured() -> tuple[float, float]:
    """Return the most of products and sums [1/s], two for a fused one, and of bytes loaded [1/s], of one core."""
    flops = 2.0 * SUMS * WIDE * ROUNDS / 4 / quickest(fused(SUMS, ROUNDS // 4))
    return flops, 8.0 * LOADS * WIDE * TIMES * 10 / quickest(loads(LOADS, TIMES * 10))


def ceilings() -> str:
    """Return the line that says what one core can do."""
    flops, loaded = measured()
    return (
        f"One core, measured: {flops / 1e9:.1f} GFLOP/s of fused products and sums, "
        f"{loaded / 1e9:.0f} GB/s loaded from the nearest cache."
    )


if __name__ == "__main__":
    print(ceilings())
