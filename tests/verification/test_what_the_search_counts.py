"""What the search for teeth says of itself is what counting every combination says."""

import math

import numpy as np
import pytest

from designs import PAIR
from gearwright.sizing import size
from gearwright.sizing.rating import rating_of
from gearwright.sizing.teeth.candidates import StageTask
from gearwright.sizing.teeth.search import _candidates, _near
from gearwright.spec import edited, parse
from gearwright.train.kinematics import edge_of

RULES = "[teeth]\npinion_minimum = 19\npinion_maximum = 30\nstage_tolerance = 0.02\n"


def task_of(design):
    """Return the pair as the search sees it."""
    stage = design.pairs["stage"]
    return StageTask("stage", stage, edge_of("stage", design), "stage", rating_of(design, "stage"), 100.0, 1.0, 1.0)


def masses(design):
    """Return (pinion, wheel) -> mass of the gears of every pair of teeth that is near enough to 3:1."""
    found = {}
    for pinion in range(19, 31):
        for wheel in range(2 * pinion, 4 * pinion):
            # the whole numbers beside the exact one count, not all that are within the tolerance
            beside = wheel in (3 * pinion - 1, 3 * pinion)
            if beside and abs(wheel / pinion / 3.0 - 1.0) <= 0.02:
                given = edited(design, {"pairs.stage.pinion_teeth": pinion, "pairs.stage.wheel_teeth": wheel})
                found[pinion, wheel] = size(given).gear_mass
    return found


def test_combinations_the_lightest_and_the_next_are_those_of_all():
    design = parse(PAIR + RULES)
    sizing, every = size(design), masses(design)
    search = sizing.search
    assert search.combinations == len(every)
    assert search.weighed == len(every)
    assert search.proven is True
    lightest, second = sorted(every.values())[:2]
    assert search.gear_mass == pytest.approx(lightest, rel=1e-9)
    assert search.next_mass == pytest.approx(second, rel=1e-9)
    assert every[sizing.teeth["stage.pinion"], sizing.teeth["stage.wheel"]] == lightest


def test_the_only_combination_has_no_next():
    search = size(parse(PAIR + RULES.replace("maximum = 30", "maximum = 19").replace("0.02", "0.01"))).search
    assert (search.combinations, search.next_mass) == (1.0, math.inf)


@pytest.mark.parametrize("asked", [(2.9, 3.1), (3.0, 3.0), (1.5, 1.6)])
def test_a_bound_knows_every_pair_of_teeth_near_a_range(asked):
    design = parse(PAIR + RULES)
    task = StageTask(
        "stage", design.pairs["stage"], edge_of("stage", design), "stage", rating_of(design, "stage"), 100.0, 1.0, 1.0
    )
    low, high = _near(task, design, asked)
    assert (low, high) == pytest.approx((asked[0] * 0.98, asked[1] * 1.02), rel=1e-8)
    ratios, mass = _candidates(task, design, (low, high), 600.0)
    held = {round(ratio, 12) for ratio in ratios.tolist()}
    for pinion in range(19, 31):
        for wheel in range(math.ceil(low * pinion), math.floor(high * pinion) + 1):
            assert round(wheel / pinion, 12) in held, (pinion, wheel)
    assert np.all(np.diff(ratios) >= 0.0)
    assert np.all(mass[np.isfinite(mass)] > 0.0)


def test_given_teeth_are_near_whatever_is_asked():
    design = parse(PAIR + "pinion_teeth = 21\nwheel_teeth = 61\n")
    task = StageTask(
        "stage", design.pairs["stage"], edge_of("stage", design), "stage", rating_of(design, "stage"), 100.0, 1.0, 1.0
    )
    assert _near(task, design, (2.9, 3.1)) == (0.0, math.inf)
