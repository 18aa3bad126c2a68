"""How fast sizing is: ``python benchmarks/sizing.py`` measures ``one many teeth``, or what is named.

one    size(in-line-h2), size(ec120b): least CPU time of twenty, and how many calls of functions it takes
first  `size` as a command in a new process with an empty folder for bytecode: processor and wall time
many   10 000 designs of In-Line H2 by `size_many`, motor speed and fill of the carriers varied: every hundredth is held
       against `size` alone, bit for bit; then the CPU time of a design, together and alone
rated  200 designs of each shipped one whose gears a standard rates, together, and ten of them alone, bit for bit
million  a million designs of In-Line H2 by `size_many`, one speed of which is no number: it alone is refused
sized  In-Line H2, and EC120B with all its teeth left out, with the hundred lightest gears sized in full, and with one
teeth  five open stages, four of them bevel pairs by ISO 10300; and pairs in a row, three to six of them

CPU times count what other processes do not take, and are still up to twice as long beside them; calls are the same on
any machine. Memory is the largest of the process so far.
"""

from __future__ import annotations

import cProfile
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from itertools import pairwise
from pathlib import Path

import numpy as np

from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size, size_many
from gearwright.spec import Design, edited, parse, read

HERE = Path(__file__).parent
SHIPPED = ("in-line-h2", "ec120b")
LEAST_OF = 20
EVERY, COLD = 100, 50
"""Designs from one that is held against `size` to the next; designs with which lanes are loaded [-]."""


def timed(design: Design, times: int) -> tuple[float, Sizing]:
    """Return the least CPU time [s] of some sizings, and the last of them."""
    least = float("inf")
    for _ in range(times):
        start = time.process_time()
        sizing = size(design)
        least = min(least, time.process_time() - start)
    return least, sizing


def calls(design: Design) -> int:
    """Return how many functions a sizing calls, of Python and of C [-]."""
    profile = cProfile.Profile()
    profile.runcall(size, design)
    return sum(entry.callcount for entry in profile.getstats())


def memory() -> float:
    """Return the largest memory of this process so far [MB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def one() -> None:
    for name in SHIPPED:
        design = read(name)
        least, sizing = timed(design, LEAST_OF)
        print(f"{name}: {1e3 * least:.1f} ms, {calls(design)} calls, {sizing.mass:.3f} kg")


def first() -> None:
    command = "from gearwright.cli import main; main()"
    for name in SHIPPED:
        with tempfile.TemporaryDirectory() as cold:
            before, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
            environment = {**os.environ, "PYTHONPYCACHEPREFIX": cold}
            environment.pop("PYTHONDONTWRITEBYTECODE", None)
            call = [sys.executable, "-c", command, "size", name]
            subprocess.run(call, check=True, env=environment, stdout=subprocess.DEVNULL)
            after, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter() - wall
        taken = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        print(f"first size of {name}: {taken:.2f} s of processor time, {wall:.2f} s")


def many() -> None:
    design, count = read("in-line-h2"), 10_000
    draw = np.random.default_rng(1)
    axes = {
        "motors.electric.speed_rpm": draw.uniform(3500, 5500, count),
        "carriers.fill": draw.uniform(0.4, 0.8, count),
    }
    columns = {path: values.tolist() for path, values in axes.items()}
    size_many(design, {path: values[:COLD] for path, values in columns.items()}, results=["mass"])  # loads the lanes
    start = time.process_time()
    sizings = size_many(design, columns, results=["mass"])
    together = (time.process_time() - start) / count
    rows = range(0, count, EVERY)
    start = time.process_time()
    alone = [size(edited(design, {path: values[row] for path, values in columns.items()})).mass for row in rows]
    apart = (time.process_time() - start) / len(rows)
    if not np.array_equal(sizings.columns["mass"][rows.start :: EVERY], alone):
        raise SystemExit("size_many and size do not give the same bits")
    print(f"size_many: {1e3 * together:.2f} ms a design, {1e3 * apart:.2f} ms alone;")
    print(f"{int(sizings.sized.sum())} sized, {int(np.sum(sizings.together))} together")


def million() -> None:
    design, count, bad = read("in-line-h2"), 1_000_000, 654_321
    speeds = np.random.default_rng(1).uniform(3500, 5500, count)
    speeds[bad] = np.nan
    start, wall = time.process_time(), time.perf_counter()
    sizings = size_many(design, {"motors.electric.speed_rpm": speeds.tolist()}, results=["mass"])
    taken, wall = time.process_time() - start, time.perf_counter() - wall
    if np.flatnonzero(~sizings.sized).tolist() != [bad] or not np.isnan(sizings.columns["mass"][bad]):
        raise SystemExit(f"{int((~sizings.sized).sum())} designs are refused, and one has a speed that is no number")
    print(f"a million: {taken:.0f} s of processor time, {wall:.0f} s, {memory():.0f} MB;")
    print(f"{int(sizings.together.sum())} together; {sizings.reasons[bad]}")


RATED = {
    "e-axle": ("motors.motor.speed_rpm", 4550.0, 4650.0),
    "twin-engine-helicopter": ("turbines.turbine-1.power_kw", 1450.0, 1500.0),
    "wind-turbine-5mw": ("gears.iso6336.pitting_safety", 1.15, 1.25),
}
"""Design -> an axis by which its gears change, and between which values [its unit]."""


def rated() -> None:
    for name, (axis, low, high) in RATED.items():
        design, count = read(name), 200
        values = np.random.default_rng(1).uniform(low, high, count).tolist()
        size_many(design, {axis: values[:COLD]}, results=["mass"])  # loads the lanes
        start = time.process_time()
        sizings = size_many(design, {axis: values}, results=["mass"])
        together = (time.process_time() - start) / count
        rows = range(0, count, count // 10)
        start = time.process_time()
        alone = [size(edited(design, {axis: values[row]})).mass for row in rows]
        apart = (time.process_time() - start) / len(rows)
        if not np.array_equal(sizings.columns["mass"][rows.start :: rows.step], alone):
            raise SystemExit("size_many and size do not give the same bits")
        print(f"{name}: {1e3 * together:.1f} ms a design, {1e3 * apart:.0f} ms alone;")
        print(f"{int(sizings.sized.sum())} sized, {int(sizings.together.sum())} together")


def sized() -> None:
    for name in SHIPPED:
        text = re.sub(r"(?m)^(pinion|wheel)_teeth.*$", "", shipped_design(name).read_text(encoding="utf-8"))
        for wanted in (1, 100):
            least, sizing = timed(edited(parse(text), {"teeth.sized": wanted}), 2)
            search = sizing.search
            assert search is not None
            print(
                f"{name}, {search.sized} sized in full, {search.refused} refused: {least:.2f} s, {sizing.mass:.3f} kg,"
                f" next {search.next_sized_mass:.3f} kg, of {search.combinations:.3g} combinations"
            )


def pairs_in_a_row(count: int) -> str:
    """Return a train of pairs, each of about 2:1."""
    shafts = [f"s{k}" for k in range(count + 1)]
    text = f'schema = 1\nname = "{count} pairs"\nshafts = {shafts}\n'
    text += '[turbines.t]\nshaft = "s0"\npower_kw = 100\nspeed_rpm = 6000\n'
    text += f'[propellers.p]\nshaft = "{shafts[-1]}"\nspeed_rpm = {6000 / 2.0**count}\ndiameter_m = 2\n'
    return text + "".join(f'[pairs.{a}-{b}]\npinion = "{a}"\nwheel = "{b}"\n' for a, b in pairwise(shafts))


def teeth() -> None:
    designs = {"five open stages": read(str(HERE / "five_open_stages.toml"))}
    designs |= {f"{count} pairs in a row": parse(pairs_in_a_row(count)) for count in (3, 4, 5, 6)}
    for name, design in designs.items():
        least, sizing = timed(design, 3)
        search = sizing.search
        assert search is not None
        proof = "proven" if search.proven else "not proven"
        print(
            f"{name}: {least:.2f} s, {memory():.0f} MB, {search.combinations:.3g} combinations, {proof},"
            f" gears {search.gear_mass:.2f} kg, next {search.next_mass:.2f} kg"
        )


ALL = (one, first, many, rated, sized, million, teeth)

if __name__ == "__main__":
    for chosen in sys.argv[1:] or ("one", "many", "teeth"):
        {measure.__name__: measure for measure in ALL}[chosen]()
