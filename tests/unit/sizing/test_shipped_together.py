"""Rows of every shipped design are the bits of their designs alone; of those named here most must go together."""

import math
import random

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.sizing import size, size_many, total_results
from gearwright.spec import Design, edited, read

TOGETHER = (
    "in-line", "in-line-h2", "mixed", "mixed-h1", "mixed-h2", "off-set", "off-set-h1", "off-set-h3", "star",
    "single-planetary", "differential-hybrid", "face-gear-split-torque", "geared-turbofan-star", "twin-engine-sprag",
    "contra-rotating-propellers",
)  # fmt: skip
"""Gears by Lewis and Hertz, or given ones."""
SEVERAL = {"in-line-h2": 300, "off-set-h1": 200, "off-set-h3": 200, "mixed": 200}
"""Rows of a few; of the others 40."""


def axes_of(design: Design, count: int, draw: random.Random) -> dict[str, list[float]]:
    """Return columns of asked speeds near those of the design, and of three rules."""
    axes = {
        "carriers.fill": [draw.uniform(0.4, 0.9) for _ in range(count)],
        "shafting.safety": [draw.uniform(1.5, 2.5) for _ in range(count)],
    }
    for table in ("motors", "propellers"):
        for name, machine in getattr(design, table).items():
            if machine.asked_speed is not None:
                rpm = machine.asked_speed * 30.0 / math.pi
                axes[f"{table}.{name}.speed_rpm"] = [rpm * draw.uniform(0.99, 1.01) for _ in range(count)]
                return axes
    return axes


def held(name: str, count: int, every: int) -> np.ndarray:
    """Hold rows of a design against each alone, and return which were sized together, of those that are sized."""
    design = read(name)
    axes = axes_of(design, count, random.Random(name))
    sizings = size_many(design, axes)
    for row in range(0, count, every):
        try:
            alone = total_results(size(edited(design, {path: values[row] for path, values in axes.items()})))
        except DesignError as error:
            assert sizings.reasons[row] == "; ".join(map(str, error.problems))
            continue
        for result, column in sizings.columns.items():
            assert column[row] == alone[result].value, (row, result)
    return sizings.together[sizings.sized]


@pytest.mark.parametrize("name", TOGETHER)
def test_rows_of_a_shipped_design_go_together_with_the_bits_of_each_alone(name):
    count = SEVERAL.get(name, 40)
    together = held(name, count, every=max(count // 12, 1))
    assert together.mean() > 0.5


def test_gears_rated_by_a_standard_go_one_by_one():
    """Its searches go another way in every design."""
    assert not held("ec120b", 12, every=6).any()
