"""The search for the best: a million designs, planted optima, and its hypervolume beside pymoo's.

python benchmarks/optimise.py million     10⁶ concept designs of In-Line H2 screened, then the rest of the search
python benchmarks/optimise.py planted     50 small problems whose best a whole grid knows
python benchmarks/optimise.py peers       hypervolume at equal evaluations, five seeds (extra optimisers)
"""

from __future__ import annotations

import os
import resource
import sys
import time

import numpy as np

import gearwright as gw
from gearwright.optimum import Search, hypervolume
from gearwright.spec import Study

SPEED, WIDTH = "motors.electric.speed_rpm", "gears.face_width_ratio"
FIRST, SECOND = "planetaries.first.planets", "planetaries.second.planets"
H2 = {
    SPEED: {"from": 3600, "to": 5600},
    WIDTH: {"from": 6, "to": 16},
    FIRST: {"values": [3, 4, 5]},
    SECOND: {"values": [3, 4, 5]},
}
KEEPS = {"worst_margin": {"minimum": 1.0}}
PROBLEMS = {
    "mass and loss": ({**H2}, {"total_mass": "minimum", "loss": "minimum"}),
    "mass and noise": ({**H2}, {"total_mass": "minimum", "excitation": "minimum"}),
    "mass, loss and room": ({**H2}, {"total_mass": "minimum", "loss": "minimum", "envelope.volume": "minimum"}),
}
EVALUATIONS, POPULATION, SEEDS = 1200, 100, 5


def study(axes: dict, objectives: dict, **search: int) -> Study:
    return Study.model_validate({
        "name": "benchmark", "designs": ["in-line-h2"], "axes": axes, "objectives": objectives,
        "results": list(objectives), "constraints": KEEPS, "search": search,
    })  # fmt: skip


def processor_time() -> float:
    own, children = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def million() -> None:
    axes, objectives = PROBLEMS["mass and loss"]
    asked = study(axes, objectives, screened=1_000_000, evaluations=10_000, population=200)
    begun, used, said = time.time(), processor_time(), []

    def tell(words: str) -> None:
        said.append((time.time() - begun, words))
        print(f"{said[-1][0]:7.1f} s  {processor_time() - used:7.1f} s of processor time  {words}", flush=True)

    optimum = gw.optimise(asked, workers=2, tell=tell)
    screened = next(at for at, words in said if words.startswith("generation 1"))
    print(f"10⁶ designs screened and one generation after {screened:.0f} s; all after {time.time() - begun:.0f} s,")
    print(f"processor time {processor_time() - used:.0f} s, load {os.getloadavg()[0]:.1f}; {optimum.counts}")
    best = optimum.best.row
    print({name: round(best.shown(name), 3) for name in best.results}, dict(best.inputs))


def planted() -> None:
    generator, found, worst = np.random.default_rng(1), 0, -np.inf
    for number in range(50):
        low, narrow = generator.uniform(3800, 4600), generator.uniform(6, 10)
        lists = {FIRST: [3, 4, 5], SECOND: [3, 4, 5], "gears.pressure_angle_deg": [20, 22.5, 25]}
        chosen = generator.choice(list(lists), 2, replace=False)
        ranges = {SPEED: (low, low + generator.uniform(300, 900)), WIDTH: (narrow, narrow + generator.uniform(2, 6))}
        objective = ("total_mass", "loss", "excitation", "flank_area")[number % 4]
        axes = {path: {"from": a, "to": b} for path, (a, b) in ranges.items()}
        axes |= {path: {"values": lists[path]} for path in chosen}
        columns = [np.linspace(*ranges[path], 25) for path in ranges] + [lists[path] for path in chosen]
        mesh = [column.ravel().tolist() for column in np.meshgrid(*columns)]
        grid = gw.size_many(
            gw.read("in-line-h2"), dict(zip(axes, mesh, strict=True)), results=[objective, "worst_margin"]
        )
        keeps = grid.columns["worst_margin"] >= 1.0 - 1e-9
        least = float(np.nanmin(np.where(keeps, grid.columns[objective], np.nan)))
        asked = study(
            axes, {objective: "minimum"}, screened=1024, evaluations=640, population=64, polished=3, seed=number
        )
        value = gw.optimise(asked).best.row.number(objective)
        worst = max(worst, value / least - 1.0)
        found += value <= least * (1.0 + 1e-6)
        print(
            f"{number:2d}  {objective:12s} grid {least:.6g}  search {value:.6g}  {100 * (value / least - 1):+.4f} %",
            flush=True,
        )
    print(f"{found} of 50 at or below the best of their grids of 5625 designs; the worst is {100 * worst:+.4f} % above")


def peers() -> None:
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.optimize import minimize

    from gearwright.exchange.optimisers import pymoo_problem

    for name, (axes, objectives) in PROBLEMS.items():
        fronts, costs = {}, {}
        for seed in range(1, SEEDS + 1):
            # The search alone, without its first layer and its polish: generations against generations.
            asked = study(axes, objectives, screened=0, evaluations=EVALUATIONS, population=POPULATION, seed=seed)
            with gw.search(asked) as search:
                inside = _timed(search)
                used = time.process_time()
                while len(search.rows) < EVALUATIONS:
                    search.tell(search.evaluate(search.ask(POPULATION)))
                costs["generations", seed] = (time.process_time() - used - inside[0]) / EVALUATIONS
                fronts["generations", seed] = _front(search)
            with gw.search(asked) as search:
                inside = _timed(search)
                used = time.process_time()
                minimize(pymoo_problem(search), NSGA2(pop_size=POPULATION), ("n_eval", EVALUATIONS), seed=seed)
                costs["pymoo", seed] = (time.process_time() - used - inside[0]) / EVALUATIONS
                fronts["pymoo", seed] = _front(search)
            # The whole search, its screening counted: as many designs in all.
            whole = study(axes, objectives, screened=EVALUATIONS // 2, evaluations=EVALUATIONS // 2,
                          population=POPULATION, polished=16, seed=seed)  # fmt: skip
            used = time.process_time()
            optimum = gw.optimise(whole)
            costs["search", seed] = (time.process_time() - used) / EVALUATIONS
            signs = [1.0 if sense == "minimum" else -1.0 for sense in objectives.values()]
            fronts["search", seed] = np.array(
                [
                    [sign * best.row.number(key) for sign, key in zip(signs, objectives, strict=True)]
                    for best in optimum.front
                ]
            )
        every = np.vstack(list(fronts.values()))
        low, high = every.min(axis=0), every.max(axis=0)
        print(f"{name}: hypervolume over the box of all fronts, 10 % beyond its worst; {EVALUATIONS} designs each")
        for who in ("generations", "search", "pymoo"):
            volumes = [
                hypervolume((fronts[who, seed] - low) / (high - low), np.full(len(low), 1.1))
                for seed in range(1, SEEDS + 1)
            ]
            spent = np.mean([costs[who, seed] for seed in range(1, SEEDS + 1)])
            kind = "all" if who == "search" else "overhead"
            each = ", ".join(f"{own:.4f}" for own in volumes)
            print(f"  {who:12s} {np.mean(volumes):.4f}  ({each})  {1e6 * spent:.0f} µs a design ({kind})", flush=True)


def _timed(search: Search) -> list[float]:
    """Count the processor time of what both are given: the evaluation of rows, with its journal."""
    inside, rows = [0.0], search._bench.rows

    def timed(cases: list) -> list:
        begun = time.process_time()
        found = rows(cases)
        inside[0] += time.process_time() - begun
        return found

    search._bench.rows = timed
    return inside


def _front(search: Search) -> np.ndarray:
    return search.judged(search.front).values


if __name__ == "__main__":
    {"million": million, "planted": planted, "peers": peers}[sys.argv[1]]()
