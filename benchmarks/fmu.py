"""FMUs: how well they agree with the steps of `simulate`, how large they are, what they cost.

python benchmarks/fmu.py [--only NAME …] [--duration S]

It needs a C compiler, and no simulator: the library is called as one would call it.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import gearwright as gw
from gearwright.arrays import Floats
from gearwright.dynamics import System
from gearwright.dynamics.equations import WORKS
from gearwright.dynamics.motion import BLOCK, blank_record, equilibrium, stepper
from gearwright.exchange import FmuFile, to_fmu

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from fmu_host import Instance, Unpacked

FORCES = 3
"""Block of references."""
SHOWN = 500
"""Communication points, about."""


def stepped(system: System, method: str, step: float, count: int) -> tuple[Floats, Floats, float]:
    """Return forces and deflections of every step, and processor time [s]."""
    arrays, size, lines = system.arrays, len(system.arrays.mass), len(system.arrays.stiffness)
    state = np.concatenate([equilibrium(system), np.zeros(size + WORKS + len(arrays.drives.start))])
    record, rows, advance = blank_record(arrays, BLOCK), list[Floats](), stepper(arrays, method, step)
    advance(0, record[:1], state.copy())  # compiles
    start = time.process_time()
    for first in range(0, count, BLOCK):
        part = record[: min(BLOCK, count - first)]
        advance(first, part, state)
        rows.append(part[:, 2 * size : 2 * (size + lines)].copy())
    table = np.concatenate(rows)
    return table[:, :lines], table[:, lines:], time.process_time() - start


def touching(system: System, deflection: Floats) -> int:
    """Return how many steps pass before a tooth leaves its flank, or all."""
    backlash = system.arrays.backlash > 0.0
    parted = np.flatnonzero(np.any(deflection[:, backlash] < 0.0, axis=1))
    return int(parted[0]) if len(parted) and parted[0] else len(deflection)


def run(file: FmuFile, times: Floats) -> tuple[Floats, float]:
    """Return the forces that an FMU gives at some times, and processor time [s]."""
    names = [port.name for port in file.ports if port.reference >> 20 == FORCES]
    with tempfile.TemporaryDirectory() as folder:
        one = Instance(Unpacked(file.content, Path(folder))).begin()
        start = time.process_time()
        forces = one.run(times, names)
        one.free()
    return forces, time.process_time() - start


def row(name: str, duration: float) -> str:
    """Return a line of the table."""
    sizing = gw.size(gw.read(name))
    system, file = gw.assemble(sizing), to_fmu(sizing)
    count = int(duration / file.step)
    every = max(1, count // SHOWN)
    shown = np.arange(0, count, every)
    forces, spent = run(file, file.step * shown)
    cells = [name, f"{len(file.content) / 1e3:.0f}", f"{1e6 * file.step:.2f}"]
    for method in ("runge-kutta generic", "runge-kutta"):
        wanted, deflection, own = stepped(system, method, file.step, count)
        kept = shown[shown < touching(system, deflection)]
        error = np.abs(forces[: len(kept)] - wanted[kept]) / np.max(np.abs(wanted), axis=0)
        cells.append(f"{np.max(error):.1e}")
    cells += [f"{len(kept) * every * file.step * 1e3:.0f}", f"{spent / duration:.1f}", f"{own / duration:.1f}"]
    return f"| {' | '.join(cells)} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="*", default=list(gw.shipped_designs()))
    parser.add_argument("--duration", type=float, default=0.02)
    asked = parser.parse_args()
    print("| design | kB | step, µs | generic steps | generated steps | over, ms | FMU, s/s | generated, s/s |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for name in asked.only:
        print(row(name, asked.duration), flush=True)


if __name__ == "__main__":
    main()
