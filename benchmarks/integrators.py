"""Compare integrators: first the answer against a tight reference, then the time, interleaved, medians.

python benchmarks/integrators.py [--rounds 7] [--write docs/benchmarks.md]
"""

from __future__ import annotations

import argparse
import os
import platform
import shutil
import statistics
import time
from collections.abc import Callable
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from by_hand import c_rk4, numba_rk4
from cases import CASES, mesh_columns
from peers import PEERS, STEPS, Case, numba_slope
from scipy.integrate import solve_ivp

from gearwright.dynamics import System, statics
from gearwright.dynamics.equations import line_state

DURATION, INTERVALS = 0.02, 400
HEAD = "| solver | setting | error | processor time for 20 ms [ms] | times slower |"
TARGETS = (1e-3, 1e-5)
BY_HAND = {"RK4 by hand in numba": (numba_rk4, STEPS)}
if shutil.which("gcc"):
    BY_HAND["RK4 as straight-line C, gcc (a bound)"] = (c_rk4, STEPS)
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


def reference(case: Case) -> np.ndarray:
    """Return the states by DOP853 at the tightest tolerance that it takes."""
    scale = 1e-14 * np.max(np.abs(case.start))
    span = (0.0, case.duration)
    slope = numba_slope(case.arrays)
    return solve_ivp(slope, span, case.start, "DOP853", t_eval=case.grid, rtol=3e-14, atol=scale, max_step=2e-6).y.T


def loosest(system: System, case: Case, wanted: np.ndarray, target: float) -> dict[str, tuple[float, float, Callable]]:
    """Return for each peer the loosest setting that reaches the target: (setting, error, run)."""
    found = {}
    for name, (make, settings) in {**PEERS, **BY_HAND}.items():
        for setting in settings:
            run = make(case, setting)
            error = np.max(np.abs(mesh_forces(system, case, run()) - wanted)) / np.max(np.abs(wanted))
            if error <= target:
                found[name] = (setting, float(error), run)
                break
        else:
            print(f"  {name}: does not reach {target:g}")
    return found


def timings(runs: dict[str, Callable], rounds: int) -> dict[str, float]:
    """Return the median processor time of each, all taken in turn in every round [s].

    Other work on the machine lengthens it far less than time on the wall, and all of these run on one core.
    """
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(rounds):
        for name, run in runs.items():
            start = time.process_time()
            run()
            times[name].append(time.process_time() - start)
    return {name: statistics.median(values) for name, values in times.items()}


def table(rounds: int) -> list[str]:
    """Return the lines of the whole comparison."""
    lines = []
    for title, build in CASES.items():
        system = build()
        case = prepare(system)
        wanted = mesh_forces(system, case, reference(case))
        for target in TARGETS:
            found = loosest(system, case, wanted, target)
            times = timings({name: run for name, (_, _, run) in found.items()}, rounds)
            lines += ["", f"### {title}, mesh-force error at most {target:g}", ""]
            lines += [HEAD, "| --- | --- | --- | --- | --- |"]
            for name, seconds in sorted(times.items(), key=lambda item: item[1]):
                setting, error, _ = found[name]
                ratio = seconds / times["gearwright RK4"]
                lines.append(f"| {name} | {setting:g} | {error:.1e} | {seconds * 1e3:.2f} | {ratio:.1f} |")
    return lines


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
    parser.add_argument("--write", type=Path)
    chosen = parser.parse_args()
    text = "\n".join([machine(), *table(chosen.rounds)]) + "\n"
    print(text)
    if chosen.write:
        chosen.write.write_text("# Integrators compared\n\n`python benchmarks/integrators.py`\n\n" + text)


if __name__ == "__main__":
    main()
