"""Products of whole vectors that ensembles do beside what one core can do: python benchmarks/products.py

One vector of case 2 is stepped, nothing else done, 40 times 4096 steps; the least processor time counts, since other
work on the machine only lengthens it. The instructions are those of the machine code.
"""

from __future__ import annotations

import re
import time
from collections import Counter
from dataclasses import replace
from typing import NamedTuple

import llvmlite.binding as llvm
import numpy as np
from cases import split_torque
from ceilings import measured
from ensembles import PRECISIONS, family, start_of
from integrators import machine

from gearwright.dynamics import System
from gearwright.dynamics.codegen import aligned, compiled, parameter_rows, topology
from gearwright.dynamics.model import own_groups, stacked
from gearwright.dynamics.motion.ensemble import Clock, Precision, lanes_of


class Mix(NamedTuple):
    """Instructions of one step of a vector of trajectories."""

    products: int
    """Products of whole vectors, fused with a sum or not."""
    arithmetic: int
    """All that the two units for whole vectors do: products, sums, least, most, comparisons."""
    every: int
    """All."""


def mix(text: str, size: int) -> Mix:
    """Return what one step takes by the machine code of an assembly, two `instant`, one `look`, three `slope`."""
    target = llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=3
    )
    counts, inside = {name: Counter[str]() for name in ("instant", "look", "slope")}, ""
    for line in target.emit_assembly(llvm.parse_assembly(text)).splitlines():
        inside = line.split(":")[0] if line and line[0].isalpha() else inside
        if inside in counts and line.startswith("\t") and not line.startswith("\t."):
            counts[inside][line.split()[0]] += 1
    total = Counter({"vmul": 4 * size, "vadd": 6 * size, "vmov": 7 * size})  # between the last two stages
    for times, part in zip((2, 1, 3), counts.values(), strict=True):
        for name, count in part.items():
            total[name] += times * count
    products = sum(count for name, count in total.items() if PRODUCTS.match(name))
    other = sum(count for name, count in total.items() if OTHERS.match(name))
    return Mix(products, products + other, total.total())


PRODUCTS = re.compile(r"vf?n?m(ul|add|sub)")
OTHERS = re.compile(r"v(add|sub|min|max|cmp|blend|xor|and)")


def stepping(systems: list[System], start: np.ndarray, precision: Precision) -> tuple[float, Mix]:
    """Return the least processor time of a step of one vector [s], nothing else done, and what it takes."""
    lanes, step, steps = lanes_of(precision), 1.5e-5, 4096
    members = [system.arrays for system in systems[:lanes]]
    family, shape = stacked(members), topology(members[0])
    layout, rows = parameter_rows(family, step)
    own = own_groups(family, layout, layout._fields, rows)
    code, single = compiled(shape, layout, lanes, own), precision == "single"
    clock = Clock(members if "clock" in own else members[:1], shape, step, lanes)
    numbers, state, out = (
        aligned(*size, lanes, single=single) for size in ((rows.shape[1],), (len(start) + 6,), (4, len(shape.lines)))
    )
    numbers[:], state[: len(start)] = rows.T, start[:, None]
    alike, times = numbers[:, 0].copy(), []
    for turn in range(40):
        turns = clock.turns(turn * steps, steps)
        begun = time.process_time()
        code.advance(steps, alike, numbers, clock.table, turns, state, out)
        times.append(time.process_time() - begun)
    return min(times) / steps, mix(code.assembly, shape.size)


def ceiling() -> list[str]:
    """Return how many of the products that a core could do in that time it does: alike but for stiffness, and not."""
    start, rng = start_of(split_torque()), np.random.default_rng(1)
    alike = family(16)
    flops, loaded = measured()
    lines = ["", "### Products of whole vectors beside what one core can do", ""]
    lines += [
        f"One core, measured: {flops / 1e9:.1f} GFLOP/s fused, {loaded / 1e9:.0f} GB/s from the nearest cache.",
        "",
    ]
    lines += ["| members differ in | precision | products, all arithmetic, all instructions of a step | "
              "time of a vector's step [ns] | of the most [%] | most of this mix [%] |"]  # fmt: skip
    lines += ["| --- | --- | --- | --- | --- | --- |"]
    different = [scattered(one, rng) for one in alike]
    for name, systems in {"stiffness": alike, "every number": different}.items():
        for precision in PRECISIONS:
            spent, took = stepping(systems, start, precision)
            share = 100 * took.products * 16 / spent / flops
            counts = f"{took.products}, {took.arithmetic}, {took.every}"
            bound = 100 * took.products / took.arithmetic
            lines.append(f"| {name} | {precision} | {counts} | {spent * 1e9:.0f} | {share:.0f} | {bound:.0f} |")
    return lines


def scattered(system: System, rng: np.random.Generator) -> System:
    """Return a system whose numbers are all a little different."""
    arrays = system.arrays

    def other(values: np.ndarray) -> np.ndarray:
        return values * rng.uniform(0.95, 1.05, len(values))

    loads = arrays.loads._replace(constant=other(arrays.loads.constant))
    series = {
        name: one._replace(cosine=other(one.cosine), sine=other(one.sine))
        for name, one in (("variation", arrays.variation), ("error", arrays.error))
    }
    plain = {name: other(getattr(arrays, name)) for name in ("mass", "stiffness", "damping", "backlash", "tone_rate")}
    weight = arrays.line_weight * float(rng.uniform(0.95, 1.05))
    return replace(system, arrays=arrays._replace(line_weight=weight, loads=loads, **plain, **series))


if __name__ == "__main__":
    print("\n".join([machine(), *ceiling()]))
