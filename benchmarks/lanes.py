"""How long few designs take together by `size_many`, over one by one in a loop: ``python benchmarks/lanes.py``.

Of every shipped design, or of those that are named, 24 rows (``--rows``), each of another power, or of another
safety of shafts where no machine has a power: processor time of the quickest of three pairs, with the twins loaded.
"""

from __future__ import annotations

import argparse
import gc
import random
import time
from collections.abc import Callable

from gearwright.errors import GearwrightError
from gearwright.shipped import shipped_designs
from gearwright.sizing import size, size_many
from gearwright.spec import Design, edited, read

PAIRS = 3
SPREAD = 0.15
"""By how much the number differs from that of the design at most, over it [-]."""


def axis_of(design: Design) -> tuple[str, float]:
    """Return the path of a power, or of the safety of shafts, and its value [kW or -]."""
    for table in ("turbines", "motors"):
        for name, machine in getattr(design, table).items():
            if machine.power is not None:
                return f"{table}.{name}.power_kw", machine.power / 1e3
    return "shafting.safety", design.shafting.safety


def columns(design: Design, count: int, seed: int, by: float = 0.0) -> dict[str, list[float]]:
    """Return one axis with a number for every row, all of them larger by some part."""
    (path, value), draw = axis_of(design), random.Random(seed)
    return {path: [value * (1.0 + by) * draw.uniform(1.0 - SPREAD, 1.0 + SPREAD) for _ in range(count)]}


def loop(design: Design, axes: dict[str, list[float]]) -> None:
    """Size every row alone."""
    ((path, values),) = axes.items()
    for value in values:
        try:
            size(edited(design, {path: value}))
        except GearwrightError:
            continue


def spent(run: Callable[[], object]) -> float:
    """Return the processor time of a run [s]."""
    gc.collect()
    start = time.process_time()
    run()
    return time.process_time() - start


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("names", nargs="*", default=shipped_designs())
    asked.add_argument("--rows", type=int, default=24)
    given = asked.parse_args()
    print("| design | rows together | together [ms] | one by one [ms] | ratio |\n| --- | --- | --- | --- | --- |")
    for name in given.names:
        design = read(name)
        together = int(size_many(design, columns(design, given.rows, 0)).together.sum())
        pairs = []
        for seed in range(1, 1 + PAIRS):
            own, other = (columns(design, given.rows, seed, by) for by in (0.0, 1e-9))  # no number is remembered
            runs = [lambda: size_many(design, own), lambda: loop(design, other)]  # noqa: B023
            order = (0, 1) if seed % 2 else (1, 0)
            times = {which: spent(runs[which]) for which in order}
            pairs.append((times[0], times[1]))
        many_ms, alone_ms = (1e3 * min(times) for times in zip(*pairs, strict=True))
        print(f"| {name} | {together} | {many_ms:.0f} | {alone_ms:.0f} | {many_ms / alone_ms:.2f} |", flush=True)


if __name__ == "__main__":
    main()
