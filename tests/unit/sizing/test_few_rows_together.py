"""Two dozen rows of one design, quickly: each has the bits of its design alone, whichever way the search goes."""

import random

import pytest

from designs import HYBRID, PAIR
from gearwright.errors import DesignError
from gearwright.sizing import size, size_many, total_results
from gearwright.spec import edited, parse

ROWS = 24
STANDARD = '[gears]\nmaterial = "18CrNiMo7-6"\nrating = "iso6336"\n'
BAND = '[teeth.forbidden.floor]\nlowest_hz = 2000\nhighest_hz = 2600\nof = "mesh"\n'
FEW = "[teeth]\nstage_tolerance = 0.004\npinion_maximum = 34\n"
RATIOS = "[teeth]\nratio_tolerance = 0.002\n"


def spread(low, high, seed=1):
    draw = random.Random(seed)
    return [draw.uniform(low, high) for _ in range(ROWS)]


POWERS = {"turbines.turbine.power_kw": spread(60, 160)}
CASES = {
    "a pair": (PAIR, {**POWERS, "propellers.propeller.speed_rpm": spread(1500, 2600, 2)}),
    "a pair that a standard rates": (
        PAIR + STANDARD,
        {**POWERS, "propellers.propeller.speed_rpm": spread(1500, 2600, 3)},
    ),
    "a pair with few teeth": (PAIR + FEW, {**POWERS, "propellers.propeller.speed_rpm": spread(900, 2600, 4)}),
    "a pair beside a band": (PAIR + BAND, {**POWERS, "propellers.propeller.speed_rpm": spread(1500, 2600, 5)}),
    "sets": (HYBRID, {"motors.electric.speed_rpm": spread(3500, 5500, 6)}),
    "sets that a standard rates": (HYBRID + STANDARD, {"motors.electric.power_kw": spread(800, 1200, 7)}),
    "sets beside a band": (HYBRID + BAND, {"motors.electric.speed_rpm": spread(3500, 5500, 8)}),
}


@pytest.mark.parametrize("name", CASES)
def test_a_row_among_few_has_the_bits_of_its_design_alone(name):
    text, axes = CASES[name]
    design = parse(text)
    sizings = size_many(design, axes)
    compared = name.endswith("a standard rates")  # whose rows complete several sizes, each alone
    assert not sizings.together.any() if compared else sizings.together.sum() >= ROWS // 2
    for row in range(0, ROWS, 3):
        changes = {path: values[row] for path, values in axes.items()}
        try:
            named = total_results(size(edited(design, changes)))
        except DesignError as error:
            assert not sizings.sized[row] and sizings.reasons[row] == "; ".join(map(str, error.problems))
            continue
        assert sizings.sized[row]
        assert {key: column[row] for key, column in sizings.columns.items()} == {
            key: named[key].value for key in sizings.columns
        }
