"""The guarded Hamilton Standard charts on a grid of 1e5 points: python benchmarks/propeller_charts.py

Counts trusted points (nothing held), those of them beyond Froude's limit, and falls of C_T with rising C_P between
neighbours that are both trusted. Takes about ten minutes of processor time.
"""

from __future__ import annotations

from itertools import product
from time import process_time

import numpy as np

from gearwright.catalogue import hamilton_standard_charts
from gearwright.errors import SolveError
from gearwright.machines import Blades, ideal_power, performance

COUNTS = (2, 3, 4, 5, 6, 7, 8)
ACTIVITY = (80.0, 100.0, 117.0, 150.0, 200.0)
LIFT = (0.3, 0.4, 0.45, 0.5, 0.57, 0.65, 0.7, 0.8)
RATIOS = np.linspace(0.0, 4.8, 15)
POWERS = np.geomspace(0.01, 3.0, 24)


def main() -> None:
    """Print the counts."""
    charts, start = hamilton_standard_charts(), process_time()
    points = trusted = beyond = falling = 0
    for number, activity, lift, ratio in product(COUNTS, ACTIVITY, LIFT, RATIOS):
        before = None
        for power in POWERS:
            points += 1
            try:
                point = performance(charts, Blades(number, activity, lift), ratio, power_coefficient=power)
            except SolveError:
                before = None
                continue
            if point.held:
                continue
            trusted += 1
            beyond += power < ideal_power(ratio, point.thrust_coefficient)
            falling += before is not None and point.thrust_coefficient <= before
            before = point.thrust_coefficient
    print(f"{points} points, {trusted} trusted: {beyond} beyond Froude, {falling} with falling C_T")
    print(f"{process_time() - start:.0f} s of processor time")


if __name__ == "__main__":
    main()
