"""The public verb beside its stepper, and both beside code written by hand: python benchmarks/verb.py [--rounds 41]

20 ms of both cases, all in turn in every round, processor time: medians, the least, medians of ratios of pairs.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable

import numpy as np
from by_hand import c_rk4, c_rk4_duties, numba_rk4
from cases import CASES
from integrators import machine, prepare
from peers import Case, gearwright, gearwright_public

from gearwright.dynamics import System, simulate
from gearwright.dynamics.codegen import summarise
from gearwright.dynamics.motion import blank_record, blank_summary, stepper

STEPS = 8
"""In each of 400 intervals, of what is written by hand."""


def own_pace(system: System) -> dict[str, Callable[[], object]]:
    """Return the verb at its own step, and its stepper at the same with statistics and energies."""
    step = simulate(system, 0.02).step
    count, size = round(0.02 / step), len(system.arrays.mass)
    advance, record = stepper(system.arrays, "runge-kutta", step), blank_record(system.arrays, 512)
    summary = blank_summary(record.shape[1])

    def alone() -> None:
        state = np.zeros(2 * size + 6)
        for first in range(0, count, 512):
            part = record[: min(512, count - first)]
            advance(first, part, state)
            summarise(part, summary)

    name = f"{count} steps"
    return {f"stepper, {name}": alone, f"simulate(), its own {name}": lambda: simulate(system, 0.02)}


def by_hand(case: Case) -> dict[str, Callable[[], object]]:
    """Return what takes eight steps in each of 400 intervals."""
    return {
        "stepper, 3200 steps": gearwright(case, STEPS),
        "simulate(), 3200 steps given": gearwright_public(case, STEPS),
        "RK4 by hand in numba": numba_rk4(case, STEPS),
        "straight C, no duties": c_rk4(case, STEPS),
        "straight C, the stepper's duties": c_rk4_duties(case, STEPS),
    }


def rows(runs: dict[str, Callable[[], object]], rounds: int) -> list[str]:
    """Return a table of runs; ratios are over the first."""
    times: dict[str, list[float]] = {name: [] for name in runs}
    for turn in range(rounds + 2):
        for name, run in runs.items():
            begun = time.process_time_ns()
            run()
            if turn > 1:
                times[name].append((time.process_time_ns() - begun) / 1e6)
    first = times[next(iter(runs))]
    lines = ["| run | median [ms] | least [ms] | over the first, pairs | least over least |"]
    lines += ["| --- | --- | --- | --- | --- |"]
    for name, spent in times.items():
        pairs = statistics.median(one / other for one, other in zip(spent, first, strict=True))
        ratio = f"{pairs:.2f} | {min(spent) / min(first):.2f}"
        lines.append(f"| {name} | {statistics.median(spent):.2f} | {min(spent):.2f} | {ratio} |")
    return lines


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=41)
    rounds = parser.parse_args().rounds
    print(machine())
    for title, build in CASES.items():
        system = build()
        for runs in (own_pace(system), by_hand(prepare(system))):
            print("\n".join(["", f"### {title}", "", *rows(runs, rounds)]), flush=True)


if __name__ == "__main__":
    main()
