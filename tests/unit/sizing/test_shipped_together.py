"""Rows of every shipped design are the bits of their designs alone; of those named here most must go together."""

import math
import random

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.sizing import size, size_many, total_results
from gearwright.sizing.many import sizings as columns
from gearwright.spec import Design, edited, read

TOGETHER = (
    "in-line", "in-line-h2", "mixed", "mixed-h1", "mixed-h2", "off-set", "off-set-h1", "off-set-h3", "star",
    "single-planetary", "differential-hybrid", "face-gear-split-torque", "geared-turbofan-star", "twin-engine-sprag",
    "contra-rotating-propellers", "in-line-h1", "off-set-h2", "ravigneaux-automatic", "wolfrom-reducer",
    "wind-turbine-5mw", "off-set-h1-free",
)  # fmt: skip
"""All but those whose sizes are compared, and of gears that a standard rates on shafts that are built."""
COMPARED = {
    "e-axle": {"motors.motor.speed_rpm": (4500.0, 4700.0)},
    "twin-engine-helicopter": {"turbines.turbine-1.power_kw": (1400.0, 1500.0)},
}
"""Axes of designs whose modules are open: each row completes several sizes, so that it is sized alone."""
LOADS = {
    "wind-turbine-5mw": {"gears.iso6336.pitting_safety": (1.0, 1.2)},
}
"""Axes by which gears that a standard rates become larger or smaller."""
SEVERAL = {"in-line-h2": 300, "off-set-h1": 200, "off-set-h3": 200, "mixed": 200}
RATED = dict.fromkeys(LOADS, 16)
"""Rows of a few; of gears that a standard rates, where a design takes half a second, few; of the others 40."""


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


def held(name: str, count: int, every: int, axes: dict[str, list[float]] | None = None) -> np.ndarray:
    """Hold rows of a design against each alone, and return which were sized together, of those that are sized."""
    design = read(name)
    axes = axes or axes_of(design, count, random.Random(name))
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


@pytest.fixture
def at_any_price(monkeypatch):
    """Let few rows go together that part late: not worth it, but quick to hold against each alone."""
    monkeypatch.setattr(columns, "SPARED", 9.0)


@pytest.mark.usefixtures("at_any_price")
@pytest.mark.parametrize("name", TOGETHER)
def test_rows_of_a_shipped_design_go_together_with_the_bits_of_each_alone(name):
    count = (SEVERAL | RATED).get(name, 40)
    together = held(name, count, every=count // 4 if name in RATED else count // 12)
    assert together.mean() > 0.5


@pytest.mark.usefixtures("at_any_price")
@pytest.mark.parametrize("name", LOADS)
def test_rows_whose_rated_gears_differ_in_size_go_together_too(name):
    """Modules are given; whole millimetres of width and safeties by bisection are looked for in all rows at once."""
    draw = random.Random(name)
    axes = {path: [draw.uniform(*ends) for _ in range(16)] for path, ends in LOADS[name].items()}
    together = held(name, 16, every=4, axes=axes)
    assert together.mean() > 0.5


@pytest.mark.parametrize("name", COMPARED)
def test_rows_whose_sizes_are_compared_are_sized_alone(name):
    draw = random.Random(name)
    axes = {path: [draw.uniform(*ends) for _ in range(3)] for path, ends in COMPARED[name].items()}
    assert not held(name, 3, every=1, axes=axes).any()


def test_built_shafts_with_gears_that_a_standard_rates_go_one_by_one():
    """Steps, seats and bearings of the catalogue part the rows."""
    assert not held("ec120b", 12, every=6).any()
