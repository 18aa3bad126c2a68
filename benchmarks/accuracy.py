"""Accuracy: what results promise beside closed forms, finer runs and multipliers of another solver.

python benchmarks/accuracy.py [--only peaks coverage cost mathieu orbits] [--count N] [--seed N] [--processes N]
"""

from __future__ import annotations

import argparse
import math
import os
import runpy
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from gearwright.dynamics import (
    Accuracy,
    DampingRatio,
    Model,
    Outputs,
    Periodic,
    System,
    Trace,
    modes,
    periodic,
    simulate,
    speed_map,
)
from gearwright.dynamics.assembly import assemble
from gearwright.errors import SolveError
from gearwright.mission import fly
from gearwright.mission.windows import fly_window
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import read, read_mission

OMEGA = 3e4
"""Of the mesh mode [rad/s]."""


def shaken(zeta: float, ratio: float) -> System:
    """Return a mesh whose error would press 200 N if nothing moved."""
    model = Model()
    model.rotation("clock", inertia=1.0, speed=OMEGA * ratio)
    model.rotation("rotor", inertia=1.0, speed=0.0)
    shake = [Periodic({"clock": 1}, (200.0 / OMEGA**2,))]
    model.mesh("mesh", {"rotor": 1.0}, stiffness=OMEGA**2, damping=DampingRatio(zeta), errors=shake)
    return model.build()


def peaks(count: int, seed: int) -> None:
    """Peaks at and beside resonance, of the closed form 200 N r² |(1 + 2iζr)/(1 − r² + 2iζr)|."""
    random = np.random.default_rng(seed)
    chosen = [(zeta, 1.0) for zeta in (0.2, 0.1, 0.05, 0.02, 0.01, 0.005)]
    chosen += [(10.0 ** random.uniform(-2.3, -0.7), 1.0 + 0.05 * random.normal()) for _ in range(count)]
    rows = np.zeros((len(chosen), 3))
    for row, (zeta, ratio) in zip(rows, chosen, strict=True):
        wanted = 200.0 * ratio**2 * abs((1 + 2j * zeta * ratio) / (1 - ratio**2 + 2j * zeta * ratio))
        system, settle = shaken(zeta, ratio), 12.0 / (zeta * OMEGA)
        duration = settle + 300.0 / OMEGA
        run = simulate(system, duration, method="runge-kutta", outputs=Outputs(start=settle))
        swept = speed_map(system, [1.0], settle=settle, duration=duration).forces
        found = run.force.maximum[0, 0], np.max(periodic(system).samples.force("mesh")), swept.maximum[0, 0]
        row[:] = np.array(found) / wanted - 1.0
        if ratio == 1.0:
            print(f"zeta {zeta:5.3f} {wanted:7.0f} N: " + " ".join(f"{100 * value:+.3f} %" for value in row))
    largest = 100 * np.max(np.abs(rows), axis=0)
    print(f"largest of {len(rows)}: " + " ".join(f"{value:.3f} %" for value in largest))


def random_system(random: np.random.Generator) -> tuple[System, float]:
    """Return a chain behind a mesh, with or without changing stiffness and backlash, and its exciting rate."""
    model, kind = Model(), int(random.integers(0, 3))
    zeta, load = 10.0 ** random.uniform(-2.3, -0.7), 10.0 ** random.uniform(1.0, 3.0) * (random.random() < 0.8)
    names = [model.rotation(f"r{i}", inertia=10.0 ** random.uniform(-4, -2)) for i in range(random.integers(2, 5))]
    model.rotation("clock", inertia=1.0, speed=1.0)
    ground, stiffness = 10.0 ** random.uniform(4, 6), 10.0 ** random.uniform(7.0, 8.5)
    model.support("ground", names[0], stiffness=ground, damping=DampingRatio(zeta))
    wave = Periodic({"clock": 1}, (random.uniform(0, 0.3), random.uniform(0, 0.1)))
    deflection = load / 0.05 / stiffness
    shake = (deflection * random.uniform(0, 0.5) + 1e-7, deflection * random.uniform(0, 0.3))
    model.mesh("mesh", {names[0]: 0.05, names[1]: 0.05}, stiffness=stiffness, damping=DampingRatio(zeta),
               variation=wave if kind else None, errors=[Periodic({"clock": 1}, shake)],
               backlash=1e-4 if kind == 2 else 0.0)  # fmt: skip
    for first, second in pairwise(names[1:]):
        twist = 10.0 ** random.uniform(4, 6)
        model.shaft(f"{first}-{second}", first, second, stiffness=twist, damping=DampingRatio(zeta))
    model.load(names[-1], constant=load)
    system = model.build()
    rates = 2.0 * np.pi * modes(system).frequency
    rate = float(random.choice(rates[rates > 0.0]) * (random.uniform(0.3, 2.0) if random.random() < 0.6 else 1.0))
    return replace(system, arrays=system.arrays._replace(tone_rate=system.arrays.tone_rate * rate)), rate


class Covered(NamedTuple):
    """What one random run says of itself, and what is true of it."""

    peak: float
    """True error of peaks over the stated one."""
    rms: float
    """True error of root mean squares over the stated one."""
    late: bool
    """Less accurate than promised."""
    marked: bool
    """With a note that says so."""
    parted: bool
    """Of neighbouring motions that part."""


def compared(seed: int, number: int) -> Covered | None:
    """Compare a random run with the same at an eighth of the step; None where it grows until it is refused."""
    random = np.random.default_rng((seed, number))
    system, rate = random_system(random)
    duration = 2.0 * math.pi / rate * int(random.integers(20, 200))
    outputs = Outputs(samples=2, start=0.0 if random.random() < 0.5 else 0.5 * duration)
    try:
        run = simulate(system, duration, outputs=outputs, method="runge-kutta")
    except SolveError:  # a parametric resonance without backlash
        return None
    fine = simulate(system, duration, outputs=outputs, method="runge-kutta", step=run.step / 8.0)
    units = np.array(system.labels.line_units)
    errors = []
    for mine, wanted in zip(_forces(run), _forces(fine), strict=True):
        largest = np.max(np.where(units[:, None] == units, wanted, 0.0), axis=1)  # forces of their kind set the scale
        errors.append(float(np.max(np.abs(mine - wanted) / np.maximum(wanted, 0.01 * largest))))
    marked = any("asked were" in note for note in run.notes)
    parted = any(words in note for note in run.notes for words in ("exponent", "sensitive"))
    late = errors[0] > 0.01 or errors[1] > 0.001
    return Covered(errors[0] / run.error, errors[1] / run.rms_error, late, marked, parted)


def coverage(count: int, seed: int, processes: int) -> None:
    """Print how many of the random runs state an error that holds the true one."""
    with ProcessPoolExecutor(processes) as pool:
        results = list(pool.map(partial(compared, seed), range(count), chunksize=5))
    runs = [run for run in results if run is not None]
    print(f"coverage, seed {seed}: {count} systems, {count - len(runs)} refused as growing without end")
    for name, ratios in (("peaks", [run.peak for run in runs]), ("root mean squares", [run.rms for run in runs])):
        held = sum(ratio <= 1.0 for ratio in ratios)
        share = f"{held} of {len(runs)}, {100 * held / len(runs):.1f} %"
        print(f"  {name}: the stated error covers {share}; the true one is at most {max(ratios):.2f} of it")
    parted, marked = sum(run.parted for run in runs), sum(run.marked for run in runs)
    print(f"  neighbours part in {parted}; marked as less accurate {marked},")
    print(f"  less accurate than promised without a mark {sum(run.late and not run.marked for run in runs)}")


def _forces(run: Trace) -> tuple[np.ndarray, np.ndarray]:
    return np.maximum(np.abs(run.force.minimum[0]), np.abs(run.force.maximum[0])), run.force.rms[0]


def mathieu(points: int) -> None:
    """Verdicts over Mathieu's chart beside DOP853 at a relative tolerance of 1e-11."""
    wrong = border = 0
    away = 0.0
    for ratio in np.linspace(0.4, 2.6, points):
        for depth in np.linspace(0.02, 0.6, points):
            model = Model()
            model.rotation("clock", inertia=1.0, speed=100.0 * ratio)
            model.rotation("rotor", inertia=1.0, speed=0.0)
            wave = Periodic({"clock": 1}, (depth,))
            model.mesh("spring", {"rotor": 1.0}, stiffness=1e4, damping=DampingRatio(0.005), variation=wave)
            model.load("rotor", constant=1.0)
            orbit = periodic(model.build())

            def slope(time: float, state: np.ndarray, depth: float = depth, ratio: float = ratio) -> list[float]:
                stiffness = 1e4 * (1.0 + depth * math.cos(100.0 * ratio * time))
                return [state[1], -stiffness * state[0] - state[1]]

            span = (0.0, 2.0 * math.pi / (100.0 * ratio))
            columns = [solve_ivp(slope, span, start, "DOP853", rtol=1e-11, atol=1e-12).y[:, -1] for start in np.eye(2)]
            wanted = float(np.max(np.abs(np.linalg.eigvals(np.array(columns).T))))
            wrong += orbit.stable is not (wanted < 1.0)
            border += bool(orbit.notes)
            away = max(away, abs(abs(orbit.multipliers[0]) - wanted))
    print(f"Mathieu, {points**2} points: {wrong} wrong verdicts, {border} on the border, multipliers within {away:.1e}")


def orbits() -> None:
    """Orbits with backlash beside exact piecewise linear ones, by default and at 1e-5."""
    tests = Path(__file__).parents[1] / "tests" / "verification" / "dynamics"
    sys.path.insert(0, str(tests))
    exact = runpy.run_path(str(tests / "test_backlash_orbits.py"))
    for case in exact["CASES"]:
        rows = []
        for asked in (Accuracy(), Accuracy(1e-5)):
            orbit = periodic(exact["gear"](case), step=asked)
            away, contacts = exact["apart"](case, orbit)
            rows.append(f"{len(orbit.samples.time) - 1} steps {away:.1e} (stated {orbit.error:.1e})")
        print(f"{case}: {contacts} contacts, stable {orbit.stable}: {', '.join(rows)}")


def used(work: Callable[[], Any]) -> tuple[float, Any]:
    """Return processor time of some work after one try [s], and what came of it."""
    work()
    start = time.process_time()
    result = work()
    return time.process_time() - start, result


def cost() -> None:
    """Processor time of 0.2 s of shipped designs, of a speed map and of ten seconds of a flight, code ready."""
    for name in ("single-planetary", "in-line-h2", "face-gear-split-torque", "ec120b"):
        system = assemble(size(read(shipped_design(name))))
        seconds, trace = used(partial(simulate, system, 0.2))
        print(f"{name}: {seconds:.3f} s at {trace.step:.2e} s, error {trace.error:.1e}, {trace.rms_error:.1e}")
    system = assemble(size(read(shipped_design("single-planetary"))))
    seconds, swept = used(partial(speed_map, system, np.linspace(0.5, 1.5, 64), settle=0.05, duration=0.1))
    forces = swept.forces
    print(f"speed map of 64: {seconds:.2f} s at {forces.step:.2e} s, error {np.max(forces.error):.1e}")
    flight = fly(size(read(shipped_design("in-line-h2"))), read_mission(shipped_mission("thesis")))
    rules = flight.mission.windows["cruise"].model_copy(update={"stiffness": "varying"})
    seconds, seen = used(partial(fly_window, flight, "cruise", rules))
    print(f"window of 10 s: {seconds:.2f} s at {seen.trace.step:.2e} s, error {seen.trace.error:.1e}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parts = ("peaks", "coverage", "cost", "mathieu", "orbits")
    parser.add_argument("--only", nargs="+", choices=parts, default=parts)
    parser.add_argument("--count", type=int, default=1000, help="random runs (a twentieth of them for peaks)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    asked = parser.parse_args()
    work = {
        "peaks": lambda: peaks(asked.count // 20, asked.seed),
        "coverage": lambda: coverage(asked.count, asked.seed, asked.processes),
        "cost": cost,
        "mathieu": lambda: mathieu(20),
        "orbits": orbits,
    }
    for part in asked.only:
        work[part]()


if __name__ == "__main__":
    main()
