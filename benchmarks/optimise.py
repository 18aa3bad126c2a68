"""The search for the best: a million designs, planted optima, and its hypervolume beside pymoo's.

python benchmarks/optimise.py million     10⁶ concept designs of In-Line H2 screened, then the rest of the search
python benchmarks/optimise.py planted     50 small problems whose best a whole grid knows; a number behind draws others
python benchmarks/optimise.py peers       hypervolume at equal evaluations, five seeds (extra optimisers)
python benchmarks/optimise.py surrogate   designs until the least excitation is found, with a surrogate and without
"""

from __future__ import annotations

import os
import resource
import sys
import time
from contextlib import closing
from itertools import islice

import numpy as np

import gearwright as gw
from gearwright.optimum import hypervolume
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
EVALUATIONS, POPULATION, SCREENED, SEEDS = 1200, 100, 256, 5


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


def planted(start: int = 1) -> None:
    generator, found, worst = np.random.default_rng(start), 0, -np.inf
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
            axes, {objective: "minimum"}, screened=4096, evaluations=1000, population=64, polished=3, seed=number
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
    """Generations and pymoo side by side: what all of them ask for at once is sized together, by one `size_many`."""
    for name, (axes, objectives) in PROBLEMS.items():
        asked = {
            seed: study(axes, objectives, screened=0, evaluations=EVALUATIONS, population=POPULATION, seed=seed)
            for seed in range(1, SEEDS + 1)
        }
        drivers: dict[tuple[str, int], Generations | Pymoo] = {}
        for seed, own in asked.items():
            drivers["generations", seed], drivers["pymoo", seed] = Generations(own), Pymoo(own, seed)
        costs = dict.fromkeys(drivers, 0.0)
        with gw.search(study(axes, objectives, evaluations=1_000_000)) as bench:
            for _ in range(EVALUATIONS // POPULATION):
                rows: list[dict] = []
                for key, driver in drivers.items():
                    begun = time.process_time()
                    rows += driver.ask()
                    costs[key] += (time.process_time() - begun) / EVALUATIONS
                found = iter(bench.evaluate(rows))
                for key, driver in drivers.items():
                    own_rows, begun = list(islice(found, POPULATION)), time.process_time()
                    driver.tell(own_rows)
                    costs[key] += (time.process_time() - begun) / EVALUATIONS
        fronts = {key: driver.search.judged(driver.search.front).values for key, driver in drivers.items()}
        for seed in asked:
            fronts["search", seed], costs["search", seed] = _whole(axes, objectives, seed)
        _compared(name, fronts, costs)


GUIDED, AT_ONCE, NEAR = {True: 48, False: 192}, 8, 1e-2
"""Designs of a run with a surrogate and without, designs that are asked for at once, and what counts as found [-]."""


def surrogate() -> None:
    """Count designs until the excitation is within 1 % of the least that any run finds."""
    axes, _ = PROBLEMS["mass and noise"]
    runs: dict[tuple[bool, int], np.ndarray] = {}
    for guided, most in GUIDED.items():
        for seed in range(1, SEEDS + 1):
            own = study(axes, {"excitation": "minimum"}, population=AT_ONCE, evaluations=most, seed=seed,
                        surrogate=guided)  # fmt: skip
            begun = time.process_time()
            with gw.search(own) as search:
                while len(search.rows) < most:
                    search.tell(search.evaluate(search.ask(AT_ONCE)))
                judged = search.judged(search.rows)
                runs[guided, seed] = np.minimum.accumulate(np.where(judged.good, judged.values[:, 0], np.inf))
                errors = ", ".join(f"{fit.result} {100 * fit.error:.0f} %" for fit in search.fits)
            print(f"guided {guided}, seed {seed}: {runs[guided, seed][-1]:.6g}, "
                  f"{time.process_time() - begun:.1f} s; foretold wrong by {errors or '-'}", flush=True)  # fmt: skip
    least = min(run[-1] for run in runs.values())
    for (guided, seed), run in runs.items():
        near = np.flatnonzero(run <= least * (1.0 + NEAR))
        first = f"after {near[0] + 1} designs" if len(near) else f"not, {100 * (run[-1] / least - 1):.2f} % are left"
        print(f"guided {guided}, seed {seed}: within {100 * NEAR:g} % {first}")


class Generations:
    """The search alone, without its first layer and its polish."""

    def __init__(self, own: Study) -> None:
        self.search = gw.search(own)

    def ask(self) -> list[dict]:
        """Return the next designs."""
        return self.search.ask(POPULATION)

    def tell(self, rows: list) -> None:
        """Take in what came of them."""
        self.search.tell(rows)


class Pymoo:
    """NSGA-II of pymoo by its own ask and tell, with all else as it comes."""

    def __init__(self, own: Study, seed: int) -> None:
        from pymoo.algorithms.moo.nsga2 import NSGA2
        from pymoo.core.evaluator import Evaluator
        from pymoo.core.problem import Problem
        from pymoo.problems.static import StaticProblem

        from gearwright.exchange.optimisers import pymoo_problem

        self.known = lambda values, broken, asked: Evaluator().eval(
            StaticProblem(self.plain, F=values, G=broken), asked
        )
        self.search = gw.search(own)
        problem, self.algorithm = pymoo_problem(self.search), NSGA2(pop_size=POPULATION)
        self.plain = Problem(n_var=problem.n_var, n_obj=problem.n_obj, n_ieq_constr=1, xl=problem.xl, xu=problem.xu)
        self.algorithm.setup(self.plain, termination=("n_eval", EVALUATIONS), seed=seed, verbose=False)

    def ask(self) -> list[dict]:
        """Return the next designs."""
        self.asked = self.algorithm.ask()
        return self.search.at(self.asked.get("X"))

    def tell(self, rows: list) -> None:
        """Take in what came of them."""
        self.search.rows += rows
        judged = self.search.judged(rows)
        broken = judged.broken + np.where(judged.failed, 1.0, 0.0)[:, None]
        self.known(judged.values, broken, self.asked)
        self.algorithm.tell(infills=self.asked)


def _whole(axes: dict, objectives: dict, seed: int) -> tuple[np.ndarray, float]:
    """Return the front of all layers with as many designs in all, and the processor time of each, prices left out."""
    from gearwright.optimum.course import Bench, followed
    from gearwright.optimum.optimise import _polished

    own = study(axes, objectives, screened=SCREENED, evaluations=EVALUATIONS - SCREENED, population=POPULATION,
                polished=16, still=EVALUATIONS, seed=seed)  # fmt: skip
    begun = time.process_time()
    with closing(Bench(own, {"in-line-h2": gw.read("in-line-h2")}, journal=None, workers=0)) as bench:
        course = followed(bench, own.search, workers=0, tell=lambda _: None)
        _polished(bench, own.search, course)
    return course.archive.judged.values, (time.process_time() - begun) / EVALUATIONS


def _compared(name: str, fronts: dict, costs: dict) -> None:
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


if __name__ == "__main__":
    {"million": million, "planted": planted, "peers": peers, "surrogate": surrogate}[sys.argv[1]](
        *map(int, sys.argv[2:])
    )
