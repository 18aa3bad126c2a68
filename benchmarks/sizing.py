"""How fast sizing is: ``python benchmarks/sizing.py`` measures all, or some of ``one teeth``.

one    size(in-line-h2), size(ec120b): least CPU time of twenty
teeth  five open stages, three of them bevel pairs by ISO 10300; and pairs in a row, three to six of them

CPU times count what other processes do not take. Memory is the largest of the process so far.
"""

from __future__ import annotations

import resource
import sys
import time
from itertools import pairwise
from pathlib import Path

from gearwright.sizing import Sizing, size
from gearwright.spec import Design, parse, read

HERE = Path(__file__).parent
SHIPPED = ("in-line-h2", "ec120b")
LEAST_OF = 20


def timed(design: Design, times: int) -> tuple[float, Sizing]:
    """Return the least CPU time [s] of some sizings, and the last of them."""
    least = float("inf")
    for _ in range(times):
        start = time.process_time()
        sizing = size(design)
        least = min(least, time.process_time() - start)
    return least, sizing


def memory() -> float:
    """Return the largest memory of this process so far [MB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def one() -> None:
    for name in SHIPPED:
        least, sizing = timed(read(name), LEAST_OF)
        print(f"{name}: {1e3 * least:.1f} ms, {sizing.mass:.3f} kg")


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


if __name__ == "__main__":
    for chosen in sys.argv[1:] or ("one", "teeth"):
        {"one": one, "teeth": teeth}[chosen]()
