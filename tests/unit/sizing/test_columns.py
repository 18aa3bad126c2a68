"""Rows sized together: each has, of every result, the bits of its design alone; and what cannot be so is told apart."""

import math
import random

import pytest

from designs import HYBRID
from gearwright.errors import DesignError
from gearwright.sizing import named_results, size, size_many, total_results
from gearwright.spec import edited, parse, read

DRAW = random.Random(11)


def drawn(low, high, count):
    return [DRAW.uniform(low, high) for _ in range(count)]


def assert_alone(design, axes, *, results=None, every=1):
    """Hold rows against each design alone, and return them."""
    sizings = size_many(design, axes, results=results)
    for row in range(0, len(sizings), every):
        changes = {path: values[row] for path, values in axes.items() if values[row] is not None}
        try:
            alone = size(edited(design, changes))
        except DesignError as error:
            assert not sizings.sized[row]
            assert sizings.reasons[row] == "; ".join(map(str, error.problems))
            continue
        assert sizings.sized[row]
        named = total_results(alone) if results is None else named_results(alone)
        for name, column in sizings.columns.items():
            assert column[row] == named[name].value, (row, name)
    return sizings


def test_open_teeth_of_planetary_sets_are_sized_together():
    axes = {
        "motors.electric.speed_rpm": drawn(3500, 5500, 64),
        "turbines.gas-turbine.power_kw": drawn(1046, 1200, 64),
        "carriers.fill": drawn(0.4, 0.8, 64),
        "gears.bending_safety": drawn(1.2, 2.0, 64),
    }
    sizings = assert_alone(read("in-line-h2"), axes, every=3)
    assert sizings.together.sum() > 50


def test_every_number_of_every_part_is_that_of_the_design_alone():
    design = read("in-line-h2")
    names = [name for name, named in named_results(size(design)).items() if named.dimension != "text"]
    axes = {"motors.electric.speed_rpm": drawn(4000, 5000, 30), "shafting.safety": drawn(1.5, 3.0, 30)}
    assert_alone(design, axes, results=names, every=4)


@pytest.mark.parametrize("name", ["in-line-h2", "off-set"])
def test_complete_masses_with_their_bands_are_found_together(name):
    names = ["complete_mass", "complete_mass.low", "complete_mass.high"]
    sizings = assert_alone(read(name), {"gears.face_width_ratio": drawn(6, 16, 24)}, results=names, every=3)
    assert sizings.together.sum() > 12


def test_refused_rows_among_others_have_the_words_of_their_designs():
    speeds = [*drawn(3500, 5500, 20), 19900.0, math.nan, 1213.0, *drawn(4000, 5000, 20)]
    sizings = assert_alone(parse(HYBRID), {"motors.electric.speed_rpm": speeds}, every=5)
    assert not sizings.sized[21] and "nan" in sizings.reasons[21]


def test_rows_that_differ_by_more_than_numbers_are_grouped():
    axes = {
        "motors.electric.speed_rpm": drawn(4000, 5000, 48),
        "planetaries.first.planets": [3, 4] * 24,
        "planetaries.first.module_mm": [None] * 24 + [3.0] * 24,
    }
    assert_alone(parse(HYBRID), axes, every=5)


def test_given_teeth_are_sized_together():
    sized = size(parse(HYBRID))
    given = {"sun_teeth": sized.teeth["first.sun"], "planet_teeth": sized.teeth["first.planet"]}
    design = edited(parse(HYBRID), {f"planetaries.first.{key}": teeth for key, teeth in given.items()})
    power = design.turbines["turbine"].power / 1e3
    sizings = assert_alone(design, {"turbines.turbine.power_kw": drawn(power, 1.1 * power, 32)}, every=4)
    assert sizings.together.any()


def test_order_and_neighbours_change_no_bit():
    axes = {"motors.electric.speed_rpm": drawn(3500, 5500, 60), "carriers.fill": drawn(0.4, 0.8, 60)}
    whole = size_many(read("in-line-h2"), axes)
    order = DRAW.sample(range(60), 31)
    mixed = size_many(read("in-line-h2"), {path: [values[row] for row in order] for path, values in axes.items()})
    for name, column in mixed.columns.items():
        assert column.tolist() == whole.columns[name][order].tolist(), name


@pytest.mark.parametrize("name", ["in-line", "single-planetary", "star", "geared-turbofan-star", "mixed-h1"])
def test_other_trains_have_the_same_bits_together_and_alone(name):
    design = read(name)
    turbine = next(iter(design.turbines or design.motors))
    table = "turbines" if design.turbines else "motors"
    power = getattr(design, table)[turbine].power / 1e3
    axes = {f"{table}.{turbine}.power_kw": drawn(power, 1.1 * power, 20), "carriers.fill": drawn(0.4, 0.8, 20)}
    if not design.sets:
        del axes["carriers.fill"]
    assert_alone(design, axes, every=4)


def test_a_search_that_is_not_made_together_is_made_alone():
    design = edited(parse(HYBRID), {"teeth.sized": 3})
    sizings = size_many(design, {"carriers.fill": drawn(0.4, 0.8, 14)})
    assert sizings.sized.any() and not sizings.together.any()
