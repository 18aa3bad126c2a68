"""Impacts: motions that lose contact, from one-sided bounces to hard stops, beside exact piecewise linear ones.

python benchmarks/impacts.py [--count N] [--seed N] [--processes N]
"""

from __future__ import annotations

import argparse
import math
import os
import runpy
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from gearwright.dynamics import Outputs, simulate

TESTS = Path(__file__).parents[1] / "tests" / "verification" / "dynamics"
sys.path.insert(0, str(TESTS))
EXACT: dict[str, Any] = {
    name: value
    for file in ("piecewise_linear.py", "test_backlash_orbits.py")
    for name, value in runpy.run_path(str(TESTS / file)).items()
}
STEP = 0.02
"""Of the exact motion's samples, over the time that a contact of one radian takes."""


class Impacting(NamedTuple):
    """What one impacting run says of itself, and what is true of it."""

    contacts: int
    """How often contact began or ended."""
    peak: float
    """True error of the peak force [-]."""
    peak_share: float
    """The same over what is stated."""
    rms_share: float
    """True error of the root mean square over what is stated."""
    late: bool
    """Less accurate than promised."""
    marked: bool
    """With a note that says so, or that the motion is chaotic."""
    steps: float
    """Steps in one radian of contact."""


def drawn(random: np.random.Generator) -> Any:
    """Return a random mesh or stop: one flank, or two that are near or far; soft or hard beside the period."""
    one_sided = random.random() < 0.4
    load = 10.0 ** random.uniform(-1.3, 0.0) if one_sided or random.random() < 0.8 else 0.0
    gap = 1e3 if one_sided else 10.0 ** random.uniform(-1.0, 1.0)
    return EXACT["Case"](10.0 ** random.uniform(-2.3, -0.7), load, 10.0 ** random.uniform(-1.0, 0.5),
                         10.0 ** random.uniform(-1.0, 0.3), gap)  # fmt: skip


def exact_force(case: Any, place: float, speed: float, end: float) -> tuple[float, float, int]:
    """Return peak and root mean square of the exact mesh force, and how often contact begins or ends."""
    time, peak, square, crossings = 0.0, 0.0, 0.0, 0
    while time < end:
        piece, stop, crossed = EXACT["leave"](case, time, place, speed, min(end, time + case.period))
        crossings += crossed
        count = 2 * max(4, math.ceil((stop - time) / (2.0 * STEP)))
        instants = np.linspace(time, stop, count + 1)
        places, speeds = piece.place(instants), piece.speed(instants)
        spring = (
            places if piece.least == 0.0 else (places + case.backlash if piece.most == -case.backlash else 0.0 * places)
        )
        force = spring + 2.0 * case.damping * speeds
        peak = max(peak, crest(np.abs(force)))
        weights = np.full(count + 1, 2.0)
        weights[1::2], weights[[0, -1]] = 4.0, 1.0
        square += float(weights @ force**2) * (stop - time) / (3.0 * count)
        time, place, speed = stop, float(places[-1]), float(speeds[-1])
        if crossed:
            place = piece.most if abs(place - piece.most) < abs(place - piece.least) else piece.least
    return peak, math.sqrt(square / end), crossings


def crest(values: np.ndarray) -> float:
    """Return the largest value, by a parabola where it lies inside."""
    top = int(np.argmax(values))
    if not 0 < top < len(values) - 1:
        return float(values[top])
    before, at, after = (float(values[top + shift]) for shift in (-1, 0, 1))
    return at - 0.125 * (after - before) ** 2 / (after - 2.0 * at + before) if after - 2.0 * at + before else at


def compared(seed: int, number: int) -> Impacting | None:
    """Compare a random run with the exact motion; None where it keeps contact."""
    random = np.random.default_rng((seed, number))
    case = drawn(random)
    length = int(random.integers(10, 60)) * case.period
    system = EXACT["gear"](case)
    run = simulate(system, length, method="runge-kutta", outputs=Outputs(samples=2))
    place, speed = float(run.samples.deflection("mesh")[0]), float(run.samples.velocity[0, 1])
    peak, rms, contacts = exact_force(case, place, speed, length)
    if not contacts:
        return None
    found = max(abs(float(run.force.minimum[0, 0])), abs(float(run.force.maximum[0, 0]))), float(run.force.rms[0, 0])
    away = abs(found[0] / peak - 1.0), abs(found[1] / rms - 1.0)
    marked = any(words in note for note in run.notes for words in ("asked were", "exponent", "sensitive"))
    late = away[0] > 0.01 or away[1] > 0.001
    return Impacting(contacts, away[0], away[0] / run.error, away[1] / run.rms_error, late, marked, 1.0 / run.step)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    asked = parser.parse_args()
    with ProcessPoolExecutor(asked.processes) as pool:
        results = list(pool.map(partial(compared, asked.seed), range(asked.count), chunksize=5))
    runs = [run for run in results if run is not None]
    plain = [run for run in runs if not run.marked]
    contacts = sum(run.contacts for run in runs)
    print(f"impacts, seed {asked.seed}: {len(runs)} of {asked.count} lose contact, {contacts} times in all")
    peaks, squares = [run.peak_share for run in runs], [run.rms_share for run in runs]
    for name, shares in (("peaks", peaks), ("root mean squares", squares)):
        held = 100 * sum(share <= 1.0 for share in shares) / len(runs)
        print(f"  {name}: the stated error covers {held:.1f} %; the true one is at most {max(shares):.2f} of it")
    largest, late = max(run.peak for run in plain), sum(run.late for run in plain)
    print(f"  marked as chaotic, sensitive or less accurate {len(runs) - len(plain)}; without a mark")
    print(f"  the largest error of peaks is {largest:.1e}, and {late} are less accurate than promised")
    print(f"  steps in one radian of contact: median {np.median([run.steps for run in runs]):.1f}")


if __name__ == "__main__":
    main()
