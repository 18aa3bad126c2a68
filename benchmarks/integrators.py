"""Compare integrators: first the answer against a tight reference, then the time, interleaved, medians.

python benchmarks/integrators.py [--rounds 7] [--limit 60] [--only gearwright --only hand] [--write docs/benchmarks.md]

Each table is printed, and written, as soon as it is there. A solver whose search for its loosest setting takes longer
than the limit of processor time is left out of that table by name, not waited for.
"""

from __future__ import annotations

import argparse
import os
import platform
import shutil
import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from importlib.metadata import version
from importlib.util import find_spec
from itertools import chain
from pathlib import Path
from typing import NamedTuple

import numpy as np
from better_peers import BETTER
from by_hand import c_rk4, c_rk4_duties, numba_rk4
from cases import CASES, mesh_columns
from ceilings import ceilings
from peers import PEERS, STEPS, Case, numba_slope
from scipy.integrate import solve_ivp

from gearwright.dynamics import System, statics
from gearwright.dynamics.equations import line_state

DURATION, INTERVALS = 0.02, 400
HEAD = "| solver | setting | error | processor time for 20 ms [ms] | largest less least [ms] | times slower |"
OURS = "gearwright RK4"
FINEST = 320
"""Steps in an interval of the reference."""
TARGETS = (1e-3, 1e-5)
BY_HAND = {"RK4 by hand in numba": (numba_rk4, STEPS)}
if shutil.which("gcc"):
    BY_HAND["RK4 as straight-line C, gcc (a bound)"] = (c_rk4, STEPS)
    BY_HAND["RK4 as straight-line C, gcc, with our stepper's duties"] = (c_rk4_duties, STEPS)
PACKAGES = ("numpy", "scipy", "numba", "jax", "diffrax", "casadi", "numbalsoda")


def prepare(system: System) -> Case:
    """Return a case that starts at static equilibrium at rest."""
    position = statics(system, balance="accelerate").position
    return Case(system.arrays, np.concatenate([position, np.zeros_like(position)]), DURATION, INTERVALS, system)


def mesh_forces(system: System, case: Case, states: np.ndarray) -> np.ndarray:
    """Return the mesh forces of states on the grid, shape (instants, meshes)."""
    size, columns = len(case.arrays.mass), mesh_columns(system)
    rows = zip(case.grid, states, strict=True)
    return np.array([line_state(case.arrays, t, y[:size], y[size:]).force[columns] for t, y in rows])


def reference(system: System, case: Case) -> tuple[np.ndarray, str]:
    """Return the mesh forces of a converged run by code written by hand, and how far two others are from it, in words.

    The others are the same at twice the step, and DOP853 of scipy, which shares nothing with it but the slope's form.
    """
    wanted, coarser = (mesh_forces(system, case, numba_rk4(case, steps)()) for steps in (FINEST, FINEST // 2))
    scale, span = 1e-10 * np.max(np.abs(case.start)), (0.0, case.duration)
    slope = numba_slope(case.arrays)
    states = solve_ivp(slope, span, case.start, "DOP853", t_eval=case.grid, rtol=1e-10, atol=scale).y.T
    largest = np.max(np.abs(wanted))
    gaps = [np.max(np.abs(other - wanted)) / largest for other in (coarser, mesh_forces(system, case, states))]
    return wanted, (
        f"Reference: RK4 by hand, {FINEST} steps an interval; half as many differ by {gaps[0]:.0e}, "
        f"scipy's DOP853 at 1e-10 by {gaps[1]:.0e} of the largest mesh force."
    )


class Search(NamedTuple):
    """What is looked for."""

    target: float
    """Error of mesh forces over the largest [-]."""
    limit: float
    """Processor time for one solver [s]."""
    only: Sequence[str]
    """Parts of the names of solvers that are compared; none for all."""


def loosest(
    system: System, case: Case, wanted: np.ndarray, search: Search
) -> tuple[dict[str, tuple[float, float, Callable]], list[str]]:
    """Return for each peer the loosest setting that reaches the target: (setting, error, run); what was left out."""
    found, left = {}, list[str]()
    for name, (make, settings) in {**PEERS, **BETTER, **BY_HAND}.items():
        if search.only and not any(part in name for part in search.only):
            continue
        target, begun = search.target, time.process_time()
        for setting in settings:
            if time.process_time() - begun > search.limit:
                left.append(f"{name}: no setting down to {setting:g} reaches it in {search.limit:g} s of search")
                break
            run = make(case, setting)
            error = np.max(np.abs(mesh_forces(system, case, run()) - wanted)) / np.max(np.abs(wanted))
            if error <= target:
                found[name] = (setting, float(error), run)
                break
        else:
            left.append(f"{name}: none of its settings down to {settings[-1]:g} reaches it")
    return found, left


def timings(runs: dict[str, Callable], rounds: int) -> dict[str, list[float]]:
    """Return the processor times of each, all taken in turn in every round [s].

    Other work on the machine lengthens it far less than time on the wall, and all of these run on one core.
    """
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(rounds):
        for name, run in runs.items():
            start = time.process_time()
            run()
            times[name].append(time.process_time() - start)
    return times


def tables(rounds: int, limit: float, only: Sequence[str]) -> Iterator[str]:
    """Yield the parts of the whole comparison as they are there."""
    for title, build in CASES.items():
        system = build()
        case = prepare(system)
        wanted, converged = reference(system, case)
        for target in TARGETS:
            found, left = loosest(system, case, wanted, Search(target, limit, only))
            times = timings({name: run for name, (_, _, run) in found.items()}, rounds)
            lines = ["", f"### {title}, mesh-force error at most {target:g}", "", converged, ""]
            lines += [HEAD, "| --- | --- | --- | --- | --- | --- |"]
            for name, values in sorted(times.items(), key=lambda item: statistics.median(item[1])):
                setting, error, _ = found[name]
                seconds, spread = statistics.median(values), max(values) - min(values)
                pairs = zip(values, times.get(OURS, values), strict=True)
                ratio = statistics.median(one / ours for one, ours in pairs)
                cells = (f"{seconds * 1e3:.2f}", f"{spread * 1e3:.2f}", f"{ratio:.1f}")
                lines.append(f"| {name} | {setting:g} | {error:.1e} | {' | '.join(cells)} |")
            yield "\n".join([*lines, "", *(f"Left out: {line}." for line in left)])


def machine() -> str:
    """Return the line that says what the numbers were taken on."""
    facts = Path("/proc/cpuinfo").read_text(encoding="utf-8") if Path("/proc/cpuinfo").exists() else ""
    model = next((line.split(":")[1].strip() for line in facts.splitlines() if line.startswith("model name")), "")
    vectors = "AVX-512" if "avx512f" in facts else "no AVX-512"
    versions = [f"{name} {version(name)}" for name in PACKAGES if find_spec(name)]
    cores = f"{os.cpu_count()} cores {model or platform.machine()}, {vectors}"
    return f"Machine: {cores}; {platform.system()}, Python {platform.python_version()}, {', '.join(versions)}."


def main() -> None:
    """Print the comparison, and write it where asked."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--limit", type=float, default=60.0, help="processor time to search one solver's setting [s]")
    parser.add_argument("--only", action="append", default=[], help="part of the names of solvers to compare")
    parser.add_argument("--write", type=Path)
    chosen = parser.parse_args()
    parts = ["# Integrators compared\n\n`python benchmarks/integrators.py`\n"]
    for part in chain([machine(), ceilings()], tables(chosen.rounds, chosen.limit, chosen.only)):
        print(part, flush=True)
        parts.append(part)
        if chosen.write:
            chosen.write.write_text("\n".join(parts) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
