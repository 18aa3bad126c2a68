"""Load sharing of thousands of gearboxes: closed form and full dynamics, the answers checked before the time.

python benchmarks/load_sharing.py
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable

import numpy as np

from gearwright.dynamics import simulate_many
from gearwright.dynamics.equations import slow_position
from gearwright.dynamics.motion import default_step
from gearwright.dynamics.sharing import (
    SharingProblem,
    as_forces,
    peak_shares,
    random_sets,
    sharing_problem,
    with_errors,
)
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read

GEARBOXES, SECONDS, REPEATS = 5000, 0.1, 3
CHECKED, LONG = 200, (0.2, 0.4)
"""Gearboxes on which the answers are compared, and from when to when [s]."""
SEED, INSTANTS = 1, 1000
LIKE = 0.95
"""Correlation of the peaks of closed form and integration below which one of them is wrong [-]."""


def timed(work: Callable[[], object]) -> float:
    """Return the median time of a few runs [s]."""
    found = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        work()
        found.append(time.perf_counter() - start)
    return statistics.median(found)


def likeness(problem: SharingProblem) -> float:
    """Return how the peaks of closed form and integration of some gearboxes correlate, the transient left out [-]."""
    sets = random_sets(problem.sources, CHECKED, seed=SEED)
    ensemble = simulate_many(with_errors(problem.system, sets), LONG[1], settle=LONG[0])
    moved = np.max(ensemble.maximum[:, problem.places], axis=1)
    forces = random_sets(as_forces(problem.train, problem.sources, problem.places), CHECKED, seed=SEED)
    slow = np.zeros(CHECKED)
    for instant in np.linspace(*LONG, INSTANTS):
        turning = np.einsum("r,rsl->sl", np.exp(1j * forces.rate * instant), forces.turning).real
        slow = np.maximum(slow, np.max(problem.train.perfect[problem.places] + forces.still + turning, axis=1))
    return float(np.corrcoef(slow, moved)[0, 1])


def main() -> None:
    problem = sharing_problem(size(read(shipped_design("face-gear-split-torque"))))
    alike = likeness(problem)
    if alike < LIKE:
        sys.exit(f"the closed form and the integration disagree: correlation {alike:.3f}")
    print(f"peak forces of {CHECKED} gearboxes by closed form and integration correlate by {alike:.3f}")
    perfect = problem.train.perfect[problem.places]

    def closed() -> None:
        forces = as_forces(problem.train, problem.sources, problem.places)
        peak_shares(perfect, random_sets(forces, GEARBOXES, seed=SEED))

    systems = with_errors(problem.system, random_sets(problem.sources, GEARBOXES, seed=SEED))
    rest = np.concatenate([slow_position(problem.system), np.zeros(len(problem.system.arrays.mass))])
    start = np.tile(rest, (GEARBOXES, 1))
    step = default_step(problem.system.arrays)
    print(f"closed form of {GEARBOXES} gearboxes    {1e3 * timed(closed):8.1f} ms")
    moved = timed(lambda: simulate_many(systems, SECONDS, start=start, step=step))
    print(f"integration of {SECONDS} s of each   {1e3 * moved:8.0f} ms, step {1e6 * step:.1f} µs")


if __name__ == "__main__":
    main()
