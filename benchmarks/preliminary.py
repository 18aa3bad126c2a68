"""How long preliminary sizings take: ``python benchmarks/preliminary.py [--rows 200]``.

Each of the thesis's ten architectures alone, teeth left open, for 20 000 h: the least of three runs. Then rows of
In-Line H2 with other motors and propeller speeds, one process; and the same rated by ISO 6336 at level concept, whose
rows go together. Processor time, so that what else the machine does hardly counts.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from functools import partial

import gearwright as gw
from gearwright.spec import Design, against_fatigue, edited, read_study

LIFE = {"service.life_h": 20000, "service.bearing_life_h": 20000}


def taken(work: Callable[[], object]) -> float:
    """Return the processor time of a piece of work [s]."""
    before = time.process_time()
    work()
    return time.process_time() - before


def axes(count: int) -> dict[str, list[float]]:
    """Return what differs from row to row: the motor's power and the propeller's speed, spread evenly."""
    return {
        "propellers.propeller.speed_rpm": [1180.0 + 60.0 * k / count for k in range(count)],
        "motors.electric.power_kw": [1005.0 + 120.0 * ((k * 7919) % count) / count for k in range(count)],
    }


def rows(design: Design, count: int, name: str) -> None:
    """Print what a row takes among many."""
    found = []
    spent = taken(lambda: found.append(gw.size_many(design, axes(count))))
    together = int(found[0].together.sum())
    print(f"{name}: {1e3 * spent / count:.1f} ms a row of {count}, {together} of them together")


def main() -> None:
    """Print the numbers."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", type=int, default=200)
    count = parser.parse_args().rows
    for name in read_study(gw.shipped_study("architectures")).designs:
        design = edited(gw.at_level(gw.read(name), "preliminary"), LIFE)
        spent = min(taken(partial(gw.size, design)) for _ in range(3))
        print(f"{name}: {1e3 * spent:.0f} ms")
    hybrid = gw.read("in-line-h2")
    rows(edited(gw.at_level(hybrid, "preliminary"), LIFE), count, "in-line-h2, preliminary")
    rows(against_fatigue(hybrid, LIFE), count, "in-line-h2, concept by ISO 6336")


if __name__ == "__main__":
    main()
