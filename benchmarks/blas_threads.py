"""Processor time of modes with one thread of BLAS, as they are, and with as many as BLAS would take.

python benchmarks/blas_threads.py
"""

from __future__ import annotations

import inspect
import statistics
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from engine import chain

from gearwright.dynamics import System, campbell, frequency_response, modes
from gearwright.dynamics.assembly import assemble
from gearwright.sizing import size
from gearwright.spec import read

ROUNDS = 9
PAUSE = 0.3
"""After which threads that spin have gone to sleep [s]."""


def anew(system: System, number: int) -> System:
    """Return a system of which nothing is remembered: each mass is more by some billionths."""
    return replace(system, arrays=system.arrays._replace(mass=system.arrays.mass * (1.0 + 1e-9 * number)))


def spent(answers: Callable[[System], object], system: System, numbers: range) -> float:
    """Return the median processor time of all threads [ms]."""
    times = []
    for number in numbers:
        own = anew(system, number)
        time.sleep(PAUSE)
        start = time.process_time()
        answers(own)
        times.append(1e3 * (time.process_time() - start))
    return statistics.median(times[1:])


def main() -> None:
    systems = {name: assemble(size(read(name))) for name in ("hybrid-turboprop", "ec120b")}
    systems |= {f"{bodies} bodies in a row": chain(bodies) for bodies in (50, 100)}
    asked = {
        "modes": (modes, inspect.unwrap(modes)),
        "campbell, 2 speeds": tuple(
            lambda system, verb=verb: verb(system, np.array([0.5, 1.0]))
            for verb in (campbell, inspect.unwrap(campbell))
        ),
        "frequency_response, 50 frequencies": tuple(
            lambda system, verb=verb: verb(system, np.linspace(1.0, 1000.0, 50))
            for verb in (frequency_response, inspect.unwrap(frequency_response))
        ),
    }
    print("| system | what | one thread [ms] | as many as BLAS takes [ms] |\n| --- | --- | --- | --- |")
    for name, system in systems.items():
        for what, (one, many) in asked.items():
            told = [spent(verb, system, range(k * ROUNDS, (k + 1) * ROUNDS + 1)) for k, verb in enumerate((one, many))]
            print(f"| {name} ({len(system.arrays.mass)} coordinates) | {what} | {told[0]:.1f} | {told[1]:.1f} |")


if __name__ == "__main__":
    main()
