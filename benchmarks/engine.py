"""The engine by itself: a long run, the exact step beside scipy's lsim, ensembles, and cost against size.

python benchmarks/engine.py
"""

from __future__ import annotations

import statistics
import time
import tracemalloc
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from cases import split_torque, two_stage
from scipy.signal import StateSpace, lsim

from gearwright.dynamics import DampingRatio, Model, Periodic, System, replay, simulate, simulate_many
from gearwright.dynamics.equations import linear, state_matrix
from gearwright.dynamics.motion import blank_record, stepper


def median(run: Callable[[], object], rounds: int = 5) -> float:
    """Return the median time of a run after one to warm up [s]."""
    times = []
    for _ in range(rounds + 1):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return statistics.median(times[1:])


def medians(runs: Sequence[Callable[[], object]], rounds: int = 9) -> list[float]:
    """Return the median processor time of each run, all taken in turn after one round to warm up [s]."""
    times = np.zeros((rounds + 1, len(runs)))
    for turn in times:
        for number, run in enumerate(runs):
            start = time.process_time()
            run()
            turn[number] = time.process_time() - start
    return list(np.median(times[1:], axis=0))


def long_run() -> None:
    """Ten seconds of case 1 with statistics, and a replay of 10 ms."""
    system = two_stage()
    seconds = median(lambda: simulate(system, 10.0), 3)
    trace = simulate(system, 10.0)
    again = median(lambda: replay(system, trace, 5.003, 5.013))
    print(f"10 s of case 1 at {trace.step:.3g} s (error {trace.error:.1e}): {seconds:.2f} s")
    print(f"10 ms of it replayed: {again * 1e3:.1f} ms")


def exact_step() -> None:
    """One second of case 1 at constant stiffness, at 20 µs: our exact step and scipy's lsim."""
    system = two_stage()
    arrays = system.arrays
    empty = arrays.variation._replace(
        start=np.zeros_like(arrays.variation.start), tone=arrays.variation.tone[:0],
        cosine=arrays.variation.cosine[:0], sine=arrays.variation.sine[:0],
    )  # fmt: skip
    system = replace(system, arrays=arrays._replace(variation=empty))
    size, h, steps = len(arrays.mass), 2e-5, 50_000
    matrix = state_matrix(linear(system.arrays))
    inputs = np.vstack([np.zeros(size), arrays.loads.constant / arrays.mass]).reshape(-1, 1)
    plant = StateSpace(matrix, inputs, np.eye(2 * size), np.zeros((2 * size, 1)))
    instants = np.arange(steps) * h
    advance, record = stepper(system.arrays, "exact", h), blank_record(system.arrays, 512)

    def ours() -> None:
        state = np.zeros(2 * size + 6)
        for first in range(0, steps, 512):
            advance(first, record[: min(512, steps - first)], state)

    state = np.zeros(2 * size + 6)
    advance(0, record, state)
    wanted = lsim(plant, np.ones(512), instants[:512])[2]
    gap = np.max(np.abs(record[:, : 2 * size] - wanted)) / np.max(np.abs(wanted))
    seconds, peer = medians([ours, lambda: lsim(plant, np.ones(steps), instants)])
    print(f"exact step: {seconds:.4f} s for 50 000 steps; lsim {peer:.3f} s, {peer / seconds:.0f} times")
    print(f"their states differ by {gap:.0e}")


def ensembles() -> None:
    """Trajectories of case 2 side by side, 0.1 s each."""
    base, rng = split_torque(), np.random.default_rng(0)
    lines = len(base.arrays.stiffness)
    for count in (64, 256, 1000):
        systems = [
            replace(base, arrays=base.arrays._replace(stiffness=base.arrays.stiffness * rng.uniform(0.95, 1.05, lines)))
            for _ in range(count)
        ]
        start = np.zeros((count, 2 * len(base.arrays.mass)))
        for threads in (1, 2):
            seconds = median(lambda: simulate_many(systems, 0.1, step=1.5e-5, start=start, threads=threads), 3)  # noqa: B023
            print(f"{count} x 0.1 s of case 2, {threads} threads: {seconds:.2f} s, {seconds / count * 1e3:.2f} ms each")


def chain(bodies: int) -> System:
    """Return a chain of meshes with varying stiffness."""
    model = Model()
    for number in range(bodies):
        model.rotation(f"{number}", inertia=1e-3, speed=500.0 if number == 0 else None)
    for number in range(bodies - 1):
        wave = Periodic({"0": 20}, (0.2, 0.1, 0.05))
        weights = {f"{number}": 0.05, f"{number + 1}": 0.05}
        model.mesh(f"{number}", weights, stiffness=1e8, damping=DampingRatio(0.05), variation=wave)
    model.load("0", constant=100.0)
    model.load(f"{bodies - 1}", constant=100.0 * (-1.0) ** bodies)
    return model.build()


def sizes() -> None:
    """Cost of a step against entries and lines; all bodies move, since numbers too small to be normal take longer."""
    works, costs, rng = [], [], np.random.default_rng(0)
    for bodies in (10, 30, 100, 300, 1000):
        arrays = chain(bodies).arrays
        advance, record = stepper(arrays, "runge-kutta", 1e-6), blank_record(arrays, 512)
        state = np.concatenate([1e-6 * rng.normal(size=2 * bodies), np.zeros(6)])
        cost = medians([lambda: advance(0, record, state)])[0] / 512  # noqa: B023
        works.append(len(arrays.line_dof) + len(arrays.stiffness))
        costs.append(cost)
        print(f"{bodies} coordinates, {works[-1]} entries and lines: {cost * 1e9:.0f} ns a step")
    slope = np.polyfit(np.log(works), np.log(costs), 1)[0]
    print(f"exponent {slope:.2f}")


def memory() -> None:
    """Most memory at once of runs of case 1 of different length."""
    system = two_stage()
    simulate(system, 0.05)
    tracemalloc.start()
    for duration in (0.5, 2.0, 8.0):
        tracemalloc.reset_peak()
        simulate(system, duration)
        print(f"memory of {duration:g} s of case 1: {tracemalloc.get_traced_memory()[1] / 1e6:.1f} MB")
    tracemalloc.stop()


if __name__ == "__main__":
    for part in (long_run, memory, exact_step, ensembles, sizes):
        part()
