"""Many trajectories: ours, JAX and diffrax under vmap, a pool of processes with scipy; then our cost from 64 to 16 384.

python benchmarks/ensembles.py [--rounds 3] [--scipy 64] [--write docs/...]

Case 2 with every stiffness varied by 5 %, 0.1 s each from static equilibrium of the mean system. Each solver runs at
the loosest setting, found on 20 ms of the first trajectories, that leaves a mesh-force error of at most 1e-3. scipy is
timed on fewer trajectories and scaled up: it takes each by itself. Processor time is summed over all cores; other work
on the machine lengthens it far less than time on the wall.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import statistics
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import get_args

import numpy as np
from cases import split_torque
from integrators import machine, mesh_forces, reference
from peers import Case, dense, has, numba_slope
from scipy.integrate import solve_ivp

from gearwright.dynamics import System, simulate_many, statics
from gearwright.dynamics.motion.ensemble import Precision, lanes_of

DURATION, TARGET, TRIED = 0.1, 1e-3, 4
WORKERS = os.cpu_count() or 1
PRECISIONS: tuple[Precision, ...] = get_args(Precision)


def family(count: int) -> list[System]:
    """Return variants of case 2: every stiffness within 5 % of its mean."""
    base, rng = split_torque(), np.random.default_rng(0)
    lines = len(base.arrays.stiffness)
    return [
        replace(base, arrays=base.arrays._replace(stiffness=base.arrays.stiffness * rng.uniform(0.95, 1.05, lines)))
        for _ in range(count)
    ]


def start_of(system: System) -> np.ndarray:
    """Return the start of every trajectory: static equilibrium of the mean system, at rest."""
    position = statics(system, balance="accelerate").position
    return np.concatenate([position, np.zeros_like(position)])


def ours(
    systems: list[System], start: np.ndarray, setting: float, precision: Precision = "double"
) -> Callable[[], np.ndarray]:
    """Eight or sixteen to a vector on every core; setting: step [s]. Statistics of every step are included.

    So is a second run at twice the step, which measures the error, and of single precision a few in double.
    """
    starts = np.tile(start, (len(systems), 1))
    return lambda: simulate_many(systems, DURATION, step=setting, start=starts, precision=precision).state


def ours_single(case: Case, setting: float) -> np.ndarray:
    """Return the states of one trajectory on the grid at our step."""
    from peers import gearwright

    return gearwright(case, round(case.duration / case.intervals / setting))()


def jax_slope(systems: list[System]) -> tuple[Callable, Callable]:
    """Return dy/dt(t, y, k) for one trajectory's mean stiffnesses, and the array maker."""
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", val=True)
    arrays = systems[0].arrays
    form, size = dense(arrays), len(arrays.mass)
    (kc, ks), (ec, es) = (
        [jnp.asarray(part) for part in pair]
        for pair in ([part / arrays.stiffness[:, None] for part in form.stiffness], form.error)
    )
    weights, rate, backlash = jnp.asarray(form.weights), jnp.asarray(arrays.tone_rate), jnp.asarray(arrays.backlash)
    mass, constant, damping = (jnp.asarray(part) for part in (arrays.mass, arrays.loads.constant, arrays.damping))

    def slope(t, y, stiffness):
        cos, sin = jnp.cos(rate * t), jnp.sin(rate * t)
        deflection = weights @ y[:size] - ec @ cos - es @ sin
        speed = weights @ y[size:] - (es * rate) @ cos + (ec * rate) @ sin
        gap = jnp.maximum(deflection, 0.0) + jnp.minimum(deflection + backlash, 0.0)
        contact = jnp.where(backlash > 0.0, gap, deflection)
        force = stiffness * (1.0 + kc @ cos + ks @ sin) * contact + damping * speed
        return jnp.concatenate([y[size:], (constant - weights.T @ force) / mass])

    return slope, jnp.asarray


def jax_many(systems: list[System], start: np.ndarray, setting: float, grid: np.ndarray | None = None) -> Callable:
    """JAX: RK4 under jit, vmap and scan; setting: step [s]. Returns the ends, or the states on a grid."""
    import jax

    slope, array = jax_slope(systems)
    stiffness = array(np.array([system.arrays.stiffness for system in systems]))
    marks = 1 if grid is None else len(grid) - 1
    duration = DURATION if grid is None else float(grid[-1])
    steps = round(duration / setting / marks)
    h = duration / (steps * marks)

    def one(k):
        def step(carry, _):
            t, y = carry
            k1 = slope(t, y, k)
            k2 = slope(t + h / 2, y + h / 2 * k1, k)
            k3 = slope(t + h / 2, y + h / 2 * k2, k)
            k4 = slope(t + h, y + h * k3, k)
            return (t + h, y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)), None

        def interval(carry, _):
            carry, _ = jax.lax.scan(step, carry, None, length=steps)
            return carry, carry[1]

        return jax.lax.scan(interval, (0.0, array(start)), None, length=marks)[1]

    whole = jax.jit(jax.vmap(one))
    return lambda: np.asarray(whole(stiffness))


def diffrax_many(systems: list[System], start: np.ndarray, setting: float, grid: np.ndarray | None = None) -> Callable:
    """diffrax: Tsit5 with its adaptive controller under jit and vmap; setting: relative tolerance."""
    import diffrax
    import jax

    slope, array = jax_slope(systems)
    stiffness = array(np.array([system.arrays.stiffness for system in systems]))
    duration = DURATION if grid is None else float(grid[-1])
    save = diffrax.SaveAt(t1=True) if grid is None else diffrax.SaveAt(ts=array(grid[1:]))
    control = diffrax.PIDController(rtol=setting, atol=setting * float(np.max(np.abs(start))))
    term, solver = diffrax.ODETerm(lambda t, y, k: slope(t, y, k)), diffrax.Tsit5()

    def one(k):
        return diffrax.diffeqsolve(
            term, solver, 0.0, duration, 1e-6, array(start), args=k, saveat=save, stepsize_controller=control,
            max_steps=10**6,
        ).ys  # fmt: skip

    whole = jax.jit(jax.vmap(one))
    return lambda: np.asarray(whole(stiffness))


_SLOPES: dict[str, Callable] = {}


def scipy_one(task: tuple[np.ndarray, np.ndarray, float, str]) -> float:
    """Run one trajectory by solve_ivp and return its processor time [s]; each process compiles its slope once."""
    stiffness, start, setting, kind = task
    began = time.process_time()
    if kind not in _SLOPES:
        _SLOPES[kind] = numba_many() if kind == "numba" else numpy_many()
    slope, scale = _SLOPES[kind], np.max(np.abs(start))
    solve_ivp(
        lambda t, y: slope(t, y, stiffness), (0.0, DURATION), start, "RK45", rtol=setting, atol=setting * scale
    )  # fmt: skip
    return time.process_time() - began


def numpy_many() -> Callable:
    """Return dy/dt(t, y, k) of case 2 in numpy."""
    from peers import array_slope

    base = split_torque().arrays
    cache: dict[bytes, Callable] = {}

    def slope(t, y, stiffness):
        key = stiffness.tobytes()
        if key not in cache:
            cache.clear()
            cache[key] = array_slope(base._replace(stiffness=stiffness), np)
        return cache[key](t, y)

    return slope


def numba_many() -> Callable:
    """Return dy/dt(t, y, k) of case 2 as compiled loops: the stiffness is an argument, so that it compiles once."""
    from peers import numba_slope_of

    return numba_slope_of(split_torque().arrays)


def settings(systems: list[System], start: np.ndarray) -> dict[str, tuple[float, float]]:
    """Return for each solver the loosest setting that keeps the error of the first trajectories, and the error."""
    few = systems[:TRIED]
    cases = [Case(system.arrays, start, 0.02, 400) for system in few]
    wanted = [reference(system, case)[0] for system, case in zip(few, cases, strict=True)]
    grid = cases[0].grid

    def error(states: list[np.ndarray]) -> float:
        rows = zip(few, cases, states, wanted, strict=True)
        return max(float(np.max(np.abs(mesh_forces(s, c, y) - w)) / np.max(np.abs(w))) for s, c, y, w in rows)

    steps = [0.02 / 400 / number for number in (2, 3, 4, 5, 6, 8, 10)]
    loose = [10.0 ** (-power / 3) for power in range(6, 31)]
    solvers: dict[str, tuple[list[float], Callable]] = {
        "gearwright": (steps, lambda setting: [ours_single(case, setting) for case in cases]),
        "scipy": (loose, lambda setting: [
            solve_ivp(numba_slope(c.arrays), (0.0, 0.02), start, "RK45", t_eval=grid, rtol=setting,
                      atol=setting * np.max(np.abs(start))).y.T for c in cases]),
    }  # fmt: skip
    for name, make in {"JAX": jax_many, "diffrax": diffrax_many}.items():
        if has(name.lower()):
            choices = steps if name == "JAX" else loose
            solvers[name] = (choices, lambda setting, make=make: [
                np.vstack([start, states]) for states in make(few, start, setting, grid)()
            ])  # fmt: skip
    found = {}
    for name, (choices, run) in solvers.items():
        found[name] = next((setting, off) for setting in choices if (off := error(run(setting))) <= TARGET)
    return found


def compare(count: int, rounds: int, scipy_count: int) -> list[str]:
    """Return the table of peers."""
    systems = family(count)
    start = start_of(split_torque())
    found = settings(systems, start)
    runs: dict[str, tuple[Callable, str, float]] = {
        f"gearwright, {lanes_of(precision)} to a vector, {precision}": (
            ours(systems, start, found["gearwright"][0], precision), "gearwright", 1.0
        )
        for precision in PRECISIONS
    }  # fmt: skip
    if "JAX" in found:
        runs["JAX RK4, vmap"] = (jax_many(systems, start, found["JAX"][0]), "JAX", 1.0)
    if "diffrax" in found:
        runs["diffrax Tsit5, vmap"] = (diffrax_many(systems, start, found["diffrax"][0]), "diffrax", 1.0)
    with ProcessPoolExecutor(WORKERS, multiprocessing.get_context("spawn")) as pool:
        for kind in ("numba", "numpy"):
            part = scipy_count if kind == "numba" else max(scipy_count // 4, WORKERS)
            tasks = [(s.arrays.stiffness, start, found["scipy"][0], kind) for s in systems[:part]]
            name = f"scipy RK45, {kind} slope, {WORKERS} processes ({part} run)"
            runs[name] = (lambda tasks=tasks: sum(pool.map(scipy_one, tasks)), "scipy", count / part)
        times: dict[str, list[tuple[float, float]]] = {name: [] for name in runs}
        for turn in range(rounds + 1):
            for name, (run, _, scale) in runs.items():
                began, worked = time.perf_counter(), time.process_time()
                result = run()
                elsewhere = result if isinstance(result, float) else 0.0
                spent = time.perf_counter() - began, time.process_time() - worked + elsewhere
                if turn:
                    times[name].append((scale * spent[0], scale * spent[1]))
    medians = {name: np.median(values, axis=0) for name, values in times.items()}
    best = medians[next(iter(runs))]
    lines = ["", f"### {count} trajectories of 0.1 s, mesh-force error at most {TARGET:g}", ""]
    lines += ["| solver | setting | error | time [s] | times slower | processor time [s] | times slower |"]
    lines += ["| --- | --- | --- | --- | --- | --- | --- |"]
    for name, (wall, work) in sorted(medians.items(), key=lambda item: item[1][0]):
        setting, off = found[runs[name][1]]
        cells = f"{wall:.3g} | {wall / best[0]:.1f} | {work:.3g} | {work / best[1]:.1f}"
        lines.append(f"| {name} | {setting:.3g} | {off:.1e} | {cells} |")
    return lines


def growth(rounds: int, counts: tuple[int, ...] = (64, 256, 1024, 4096, 16384)) -> list[str]:
    """Return the table of our processor time per trajectory against their number, taken in turn; 0.02 s each."""
    base, systems = start_of(split_torque()), family(counts[-1])
    costs: dict[tuple[int, Precision], list[float]] = {(n, precision): [] for n in counts for precision in PRECISIONS}
    moved = dict[int, float]()
    for _ in range(rounds):
        for (count, precision), spent in costs.items():
            starts = np.tile(base, (count, 1))
            began = time.process_time()
            run = simulate_many(systems[:count], 0.02, step=1.5e-5, start=starts, precision=precision)
            spent.append((time.process_time() - began) / count)
            moved[count] = run.rounding.peak
    lines = ["", "### Cost per trajectory against their number, 0.02 s each at 15 µs", ""]
    lines += ["| trajectories | processor time each, double [ms] | single [ms] | times | peaks moved by single |"]
    lines += ["| --- | --- | --- | --- | --- |"]
    for count in counts:
        double, single = (1e3 * statistics.median(costs[count, precision]) for precision in PRECISIONS)
        lines.append(f"| {count} | {double:.3f} | {single:.3f} | {double / single:.1f} | {moved[count]:.0e} |")
    return lines


def main() -> None:
    """Print the tables, and write them where asked."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--scipy", type=int, default=64)
    parser.add_argument("--write", type=Path)
    chosen = parser.parse_args()
    text = (
        "\n".join(
            [
                machine(),
                *compare(chosen.count, chosen.rounds, chosen.scipy),
                *growth(chosen.rounds),
            ]
        )
        + "\n"
    )
    print(text)
    if chosen.write:
        chosen.write.write_text("# Ensembles compared\n\n`python benchmarks/ensembles.py`\n\n" + text)


if __name__ == "__main__":
    main()
