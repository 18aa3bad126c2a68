"""How fast gears are rated and a whole gearbox is sized: ``python benchmarks/rating.py``.

Checks first that an array of pairs is rated as each pair alone, then times one pair alone, pairs in arrays, and the
sizing of the shipped helicopter gearbox with its ratings, shafts, bearings and joints. Medians of seven,
in processor time: what others do on the machine does not count.
"""

from __future__ import annotations

import math
import platform
import statistics
import time
from collections.abc import Callable

import numpy as np

from gearwright.catalogue import gear_steel
from gearwright.parts.iso6336 import MeshDuty, MeshGeometry, PairRating, rate_mesh
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read

STEEL = gear_steel("case-hardened", "MQ", 700.0)
DUTY = MeshDuty(512.5, 628.3, 3500 * 3600.0, 1.25)
REPEATS = 7


def pairs(widths: np.ndarray | float) -> MeshGeometry:
    """27/107 teeth of module 2.5, 12 degrees, of some face widths [m]."""
    module, helix = 2.5e-3, math.radians(12.0)
    radii = [0.5 * teeth * module / math.cos(helix) for teeth in (27, 107)]
    one = np.ones_like(widths)
    tips = (one * (radii[0] + module), one * (radii[1] + module))
    return MeshGeometry(
        (27.0 * one, 107.0 * one), module * one, widths * one, sum(radii) * one, tips, helix_angle=helix
    )


def rated(widths: np.ndarray | float) -> PairRating:
    return rate_mesh(pairs(widths), (STEEL, STEEL), DUTY)


def median(work: Callable[[], object], calls: int) -> float:
    """Return the median processor time of one call [s]."""
    found = []
    for _ in range(REPEATS):
        start = time.process_time()
        for _ in range(calls):
            work()
        found.append((time.process_time() - start) / calls)
    return statistics.median(found)


def main() -> None:
    widths = np.linspace(20e-3, 60e-3, 1000)
    together = rated(widths)
    for k in (0, 499, 999):
        alone = rated(float(widths[k]))
        for many, one in zip(together.pitting.safeties, alone.pitting.safeties, strict=True):
            assert math.isclose(float(many[k]), float(one), rel_tol=1e-12)
        for many_root, one_root in zip(together.bending, alone.bending, strict=True):
            assert math.isclose(float(many_root.safety[k]), float(one_root.safety), rel_tol=1e-12)
    print(f"{platform.machine()}, Python {platform.python_version()}, NumPy {np.__version__}; answers agree to 1e-12")
    print("| work | time | a pair |\n| --- | --- | --- |")
    alone = median(lambda: rated(45e-3), 50)
    print(f"| one pair by ISO 6336 | {1e3 * alone:.2f} ms | {1e6 * alone:.0f} µs |")
    for count in (100, 1000, 10000):
        several = np.linspace(20e-3, 60e-3, count)
        span = median(lambda several=several: rated(several), max(1, 2000 // count))
        print(f"| {count} pairs in one call | {1e3 * span:.2f} ms | {1e6 * span / count:.1f} µs |")
    design = read(shipped_design("ec120b"))
    print(f"| EC120B gearbox, sized whole | {1e3 * median(lambda: size(design), 1):.0f} ms | |")


if __name__ == "__main__":
    main()
