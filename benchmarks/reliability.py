"""How likely a finished gearbox breaks down under loads that scatter: first order, subset simulation, plain counting.

    python benchmarks/reliability.py [MARGIN ...]

The star of In-Line H2, frozen, with scattered powers. Its first two shafts are the nearest to their limits, each in
proportion to the power of one machine, so that the exact probability is known: with margins of 1.000 at the mean and
power p ~ N(p0, s) the margin p0/p falls below M where p > p0/M.
"""

from __future__ import annotations

import sys
import time

from scipy.special import ndtr

from gearwright.spec import parse_study
from gearwright.study import run
from gearwright.study.reliability import reliability

STUDY = """
schema = 1
name = "How likely the star breaks down"
designs = ["in-line-h2-star"]
frozen = true
results = ["worst_margin"]

[axes]
"turbines.gas-turbine.power_kw, cases.cruise.gas-turbine.power_kw" = {shaken}
"motors.electric.power_kw" = {{distribution = "normal", mean = 1005, deviation = 30}}

[constraints]
worst_margin = {{minimum = {margin}}}

[sampling]
method = "{method}"
count = {count}
population = 500
seed = 1
"""
SHAKEN = '{distribution = "normal", mean = 1046, deviation = 30}'
"""Power of the turbine [kW]."""
MARGINS = (0.95, 0.9)
COUNTS = {"form": 1100, "subset": 2500, "random": 1100}
"""Method -> evaluations [-]."""
MEAN, DEVIATION = 1046.0, 30.0
"""Power of the turbine, whose shaft governs [kW]."""


def main(margins: tuple[float, ...]) -> None:
    """Print one line for each margin and method."""
    print("| margin below | method | cases | probability (95 % confidence) | β | the shaft alone | CPU [s] |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for margin in margins:
        exact = ndtr(-(MEAN / margin - MEAN) / DEVIATION)
        for method, count in COUNTS.items():
            start = time.process_time()
            study = parse_study(STUDY.format(shaken=SHAKEN, margin=margin, method=method, count=count))
            (found,) = reliability(study, run(study))
            taken = time.process_time() - start
            low, high = found.interval
            sure = f"{found.probability:.2g} ({low:.2g} to {high:.2g})"
            line = f"| {margin} | {method} | {count} | {sure} | {found.index:.2f} | {exact:.2g} | {taken:.0f} |"
            print(line, flush=True)


if __name__ == "__main__":
    main(tuple(float(text) for text in sys.argv[1:]) or MARGINS)
