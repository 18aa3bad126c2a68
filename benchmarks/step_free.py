"""Exact linear flow with kicks beside Runge–Kutta: python benchmarks/step_free.py [--rounds 5]

Between kicks a matrix exponential carries state, loads and tones without error; kicks, at Gauss points of a step, are
what stiffness and contact do beyond their mean. Both answers are checked first, against DOP853 at 3e-14; then counted
and timed at the loosest step that holds 1e-3 and 1e-5. The splitting runs compiled (numba), by dense matrices.
"""

from __future__ import annotations

import argparse
import statistics
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
from cases import CASES
from integrators import TARGETS, mesh_forces, prepare, reference, timings
from numba import njit
from peers import Case, gearwright
from scipy.linalg import expm

from gearwright.dynamics.model import Arrays, line_matrix

STEPS = (1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20, 24, 28, 34, 40, 56, 80, 112)
"""Steps in each interval of the grid that are tried."""


def by_tone(series, count: int, scale: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return cosine and sine coefficients, shape (lines, tones) each."""
    cosine, sine = np.zeros((2, len(scale), count))
    line = np.repeat(np.arange(len(scale)), np.diff(series.start))
    np.add.at(cosine, (line, series.tone), series.cosine * scale[line])
    np.add.at(sine, (line, series.tone), series.sine * scale[line])
    return cosine, sine


def linear_part(arrays: Arrays) -> tuple[np.ndarray, ...]:
    """Return A of z = (q, q̇, 1, cos φ, sin φ), rows of deflections, of changing stiffness, and columns of kicks."""
    size, tones, rate = len(arrays.mass), len(arrays.tone_rate), arrays.tone_rate
    first, wide = 2 * size + 1, 2 * size + 1 + 2 * tones
    cosine, sine = by_tone(arrays.error, tones, np.ones(len(arrays.stiffness)))
    matrix = line_matrix(arrays)
    deflection, speed = np.zeros((2, len(matrix), wide))
    deflection[:, :size], deflection[:, first:] = matrix, -np.hstack([cosine, sine])
    speed[:, size : 2 * size], speed[:, first:] = matrix, np.hstack([-sine * rate, cosine * rate])
    force = arrays.stiffness[:, None] * deflection + arrays.damping[:, None] * speed
    flow, kick = np.zeros((wide, wide)), np.zeros((wide, len(matrix)))
    flow[:size, size : 2 * size] = np.eye(size)
    flow[size : 2 * size] = -(matrix.T @ force) / arrays.mass[:, None]
    flow[size : 2 * size, 2 * size] += arrays.loads.constant / arrays.mass
    flow[first : first + tones, first + tones :] = -np.diag(rate)
    flow[first + tones :, first : first + tones] = np.diag(rate)
    kick[size : 2 * size] = -matrix.T / arrays.mass[:, None]
    waves = np.zeros_like(deflection)
    waves[:, first:] = np.hstack(by_tone(arrays.variation, tones, arrays.stiffness))
    return flow, deflection, waves, kick


@njit(fastmath=True)
def march(start, flows, weights, reading, kicks, springs, steps, intervals):
    """Return z at the grid."""
    rows, waves = reading
    mean, gap = springs
    out = np.empty((intervals + 1, len(start)))
    out[0], state = start, start.copy()
    force, points = np.empty(len(mean)), len(weights)
    for interval in range(intervals):
        for _ in range(steps):
            for point in range(points):
                state = flows[point] @ state
                deflection, change = rows @ state, waves @ state
                for line in range(len(mean)):
                    x = deflection[line]
                    touching = max(x, 0.0) + min(x + gap[line], 0.0) if gap[line] > 0.0 else x
                    force[line] = (mean[line] + change[line]) * touching - mean[line] * x
                state += weights[point] * (kicks @ force)
            state = flows[points] @ state
        out[interval + 1] = state
    return out


def split(case: Case, points: int, steps: int) -> Callable[[], np.ndarray]:
    """Return the splitting with Gauss points in each step."""
    flow, rows, waves, kicks = linear_part(case.arrays)
    nodes, weights = np.polynomial.legendre.leggauss(points)
    h = case.duration / case.intervals / steps
    gaps = np.diff(np.concatenate([[0.0], 0.5 * (nodes + 1.0), [1.0]]))
    flows = np.array([expm(flow * h * gap) for gap in gaps])
    tones = len(case.arrays.tone_rate)
    start = np.concatenate([case.start, np.ones(1 + tones), np.zeros(tones)])
    numbers = (rows, waves), kicks, (case.arrays.stiffness, case.arrays.backlash)
    return partial(march, start, flows, 0.5 * h * weights, *numbers, steps, case.intervals)


def found(system, case: Case, wanted: np.ndarray, target: float) -> Iterator[tuple[str, int, float, Callable]]:
    """Yield name, evaluations in an interval, error and run of each at its loosest step that holds the target."""
    ways = {f"kicks, {points} Gauss points": (points, partial(split, case, points)) for points in (1, 2, 3)}
    for name, (each, make) in {"Runge–Kutta": (4, partial(gearwright, case)), **ways}.items():
        for steps in STEPS:
            run = make(steps)
            states = run()[:, : 2 * len(case.arrays.mass)]
            error = float(np.max(np.abs(mesh_forces(system, case, states) - wanted)) / np.max(np.abs(wanted)))
            if error <= target:
                yield name, each * steps, error, run
                break
        else:
            print(f"| {name} | does not reach {target:g} | | | |")


def main() -> None:
    """Print a table for each case and target."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    for title, build in CASES.items():
        system = build()
        case = prepare(system)
        wanted = reference(system, case)[0]
        for target in TARGETS:
            print(f"\n{title}, mesh forces within {target:g}\n")
            print("| method | evaluations in 50 µs | error | processor time of 20 ms | over Runge–Kutta's |")
            print("| --- | --- | --- | --- | --- |")
            rows = list(found(system, case, wanted, target))
            spent = timings({name: run for name, _, _, run in rows}, rounds)
            times = {name: statistics.median(seconds) for name, seconds in spent.items()}
            for name, count, error, _ in rows:
                ratio = times[name] / times["Runge–Kutta"]
                print(f"| {name} | {count} | {error:.1e} | {times[name] * 1e3:.2f} ms | {ratio:.1f} |")


if __name__ == "__main__":
    main()
