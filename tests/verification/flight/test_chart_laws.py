"""The guarded charts obey the momentum of the stream: no point beyond Froude's limit, no C_T that falls with C_P."""

from itertools import pairwise

import numpy as np
import pytest

from gearwright.catalogue import hamilton_standard_charts
from gearwright.errors import SolveError
from gearwright.machines import Blades, ideal_power, performance

CHARTS = hamilton_standard_charts()
POWERS = np.geomspace(0.01, 3.0, 24)


def trusted(blades: Blades, ratio: float) -> list[tuple[float, float]]:
    """C_P and C_T of the points for which nothing is held."""
    points = []
    for power in POWERS:
        try:
            found = performance(CHARTS, blades, ratio, power_coefficient=power)
        except SolveError:
            continue
        if not found.held:
            points.append((power, found.thrust_coefficient))
    return points


@pytest.mark.parametrize("number", [2, 3, 4, 6])
@pytest.mark.parametrize("lift", [0.3, 0.5, 0.65])
def test_no_trusted_point_beats_the_actuator_disc_or_falls(number, lift):
    """A subset of benchmarks/propeller_charts.py; four blades, AF 100, C_Li 0.3, J 1.2, C_P 0.02 once gave η 1.755."""
    count = 0
    for ratio in (0.0, 0.7, 1.2, 2.4):
        points = trusted(Blades(number, 100.0, lift), ratio)
        count += len(points)
        assert all(power >= ideal_power(ratio, thrust) for power, thrust in points)
        assert all(after[1] > before[1] for before, after in pairwise(points))
    assert count > 10


def test_a_point_above_froudes_limit_says_so():
    found = performance(CHARTS, Blades(4, 100.0, 0.3), 1.2, power_coefficient=0.02)
    assert found.held
    assert 1.2 * found.thrust_coefficient / 0.02 > 1.0
