"""Peers at the settings that `integrators.py` found for 1e-3, without its search: python benchmarks/settings.py

Errors of mesh forces are held against straight C at 64 steps an interval; all run in turn, processor time. For JAX set
XLA_FLAGS=--xla_cpu_multi_thread_eigen=false, so that it does not spread over threads, whose time adds up.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable

import numpy as np
from better_peers import diffrax_forward, jax_tables
from by_hand import c_rk4, c_rk4_duties, numba_rk4
from cases import CASES
from integrators import machine, mesh_forces, prepare
from peers import diffrax_run, gearwright, gearwright_public, jax_runge_kutta

from gearwright.dynamics import simulate

FOUND = {"two-stage planetary": (7, 10.0 ** (-10 / 3)), "split torque": (3, 1e-3)}
"""Steps in an interval of fixed-step methods, and tolerance of others."""
FIXED: dict[str, Callable] = {
    "gearwright RK4": gearwright, "gearwright simulate(), step given": gearwright_public,
    "RK4 by hand in numba": numba_rk4,
    "straight C, no duties": c_rk4, "straight C, the stepper's duties": c_rk4_duties, "JAX RK4": jax_runge_kutta,
    **{f"JAX RK4, tables, {kind}": jax_tables(kind) for kind in ("matrices", "sums", "straight-line")},
}  # fmt: skip
ADAPTIVE: dict[str, Callable] = {
    "diffrax Tsit5": diffrax_run("Tsit5"), "diffrax Dopri8": diffrax_run("Dopri8"),
    "diffrax Tsit5, PI, forward mode": diffrax_forward("Tsit5"),
}  # fmt: skip


def main() -> None:
    """Print a table for each case."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=11)
    rounds = parser.parse_args().rounds
    print(machine())
    for title, (steps, tolerance) in FOUND.items():
        system = CASES[title]()
        case = prepare(system)
        wanted = mesh_forces(system, case, c_rk4(case, 64)())
        runs: dict[str, tuple[Callable, str]] = {}
        for makers, setting in ((FIXED, steps), (ADAPTIVE, tolerance)):
            for name, make in makers.items():
                run = make(case, setting)
                error = np.max(np.abs(mesh_forces(system, case, run()) - wanted)) / np.max(np.abs(wanted))
                runs[name] = run, f"{error:.1e}"
        runs["gearwright simulate(), its own step"] = (lambda system=system: simulate(system, 0.02)), "measured by it"
        times: dict[str, list[float]] = {name: [] for name in runs}
        for _ in range(rounds):
            for name, (run, _) in runs.items():
                begun = time.process_time_ns()
                run()
                times[name].append((time.process_time_ns() - begun) / 1e6)
        print(f"\n### {title}\n\n| solver | error | median [ms] | least [ms] | times slower |")
        print("| --- | --- | --- | --- | --- |")
        for name, spent in sorted(times.items(), key=lambda item: statistics.median(item[1])):
            ratio = statistics.median(a / b for a, b in zip(spent, times["gearwright RK4"], strict=True))
            print(f"| {name} | {runs[name][1]} | {statistics.median(spent):.2f} | {min(spent):.2f} | {ratio:.1f} |")


if __name__ == "__main__":
    main()
