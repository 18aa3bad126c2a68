"""Many designs at once: columns that are what each design is alone, and what a batch may contain that is wrong."""

import math
import random

import numpy as np
import pytest

from designs import HYBRID, PAIR, changed
from gearwright.errors import DesignError
from gearwright.sizing import named_results, size, size_many, structure_of
from gearwright.spec import edited, parse

AXES = {"motors.electric.speed_rpm": [4000.0, 4321.0, 4500.0, 5100.0], "carriers.fill": [0.4, 0.55, 0.6, 0.8]}


@pytest.fixture(scope="module")
def hybrid():
    return parse(HYBRID)


def refused(*arguments, **named) -> list:
    """Return what a batch is refused for."""
    with pytest.raises(DesignError) as caught:
        size_many(*arguments, **named)
    return list(caught.value.problems)


def test_a_row_is_what_its_design_is_alone_to_the_last_bit_in_any_order(hybrid):
    whole = size_many(hybrid, AXES)
    order = random.Random(3).sample(range(4), 4)
    mixed = size_many(hybrid, {path: [values[row] for row in order] for path, values in AXES.items()})
    for place, row in enumerate(order):
        alone = size(edited(hybrid, {path: values[row] for path, values in AXES.items()}))
        assert whole.at(row).mass == alone.mass == whole.columns["mass"][row] == mixed.columns["mass"][place]
        for name, column in whole.columns.items():
            assert column[row] == mixed.columns[name][place], name
    assert whole.sized.all() and len(whole) == 4
    assert len(set(whole.columns["mass"])) == 4
    assert whole.dimensions["mass"] == "mass"


def test_one_that_is_no_number_among_others_is_a_row_with_its_reason(hybrid):
    sizings = size_many(hybrid, {"motors.electric.speed_rpm": np.array([4000.0, math.nan, 4500.0])})
    assert sizings.sized.tolist() == [True, False, True]
    assert list(sizings.reasons) == [1] and "nan is not allowed" in sizings.reasons[1]
    assert np.isnan(sizings.columns["mass"]).tolist() == [False, True, False]
    assert sizings.structure.tolist() == [0, -1, 0]
    with pytest.raises(DesignError, match="nan is not allowed"):
        sizings.at(1)


def test_what_cannot_be_sized_has_its_reason_and_its_structure(hybrid):
    sizings = size_many(hybrid, {"propellers.propeller.speed_rpm": [1212, 4400]})
    assert sizings.structure.tolist() == [0, 0]
    assert "planetaries.second" in sizings.reasons[1]


def test_a_value_given_to_some_designs_only_leaves_the_others_theirs(hybrid):
    sizings = size_many(hybrid, {"planetaries.first.module_mm": [None, 3.0, None]}, results=["mass"])
    assert sizings.at(1).given["first.module"].value == pytest.approx(3e-3)
    assert not sizings.at(0).given
    masses = sizings.columns["mass"]
    assert masses[0] == masses[2] == size(hybrid).mass != masses[1]


def test_designs_of_different_structure_stand_side_by_side(hybrid):
    pair = parse(PAIR)
    names = ["mass", "gears.first.sun.module", "gears.stage.pinion.module"]
    sizings = size_many([pair, hybrid, pair], results=names)
    assert sizings.structure.tolist() == [0, 1, 0]
    assert sizings.structures == (structure_of(pair), structure_of(hybrid))
    assert list(sizings.columns) == names
    assert np.isnan(sizings.columns["gears.first.sun.module"]).tolist() == [True, False, True]
    expected = named_results(size(hybrid))["gears.first.sun.module"].value
    assert sizings.columns["gears.first.sun.module"][1] == expected
    other = parse(changed(PAIR, "power_kw = 100", "power_kw = 120"))
    assert structure_of(other) == structure_of(pair) and hash(structure_of(other)) == hash(structure_of(pair))


def test_a_batch_of_none_has_no_rows(hybrid):
    for sizings in (size_many([]), size_many(hybrid, {"carriers.fill": []})):
        assert len(sizings) == 0 and not sizings.columns and not sizings.reasons
        with pytest.raises(DesignError, match="0 is no row; there are 0"):
            sizings.at(0)


def test_one_design_without_axes_is_a_batch_of_one(hybrid):
    sizings = size_many(hybrid)
    assert sizings.columns["mass"].tolist() == [size(hybrid).mass]
    assert sizings.at(-1).mass == size(hybrid).mass
    with pytest.raises(DesignError, match="1 is no row; there are 1"):
        sizings.at(1)


def test_axes_that_no_design_has_are_refused_all_at_once(hybrid):
    first, second = refused(hybrid, {"motors.electric.sped_rpm": [1.0], "carriers.full": [0.5]})
    assert "did you mean speed_rpm?" in first.message and "fill" in second.message


def test_an_entry_in_two_units_is_refused(hybrid):
    (found,) = refused(hybrid, {"motors.electric.power_kw": [900.0], "motors.electric.power_hp": [1200.0]})
    assert "is given twice" in found.message


def test_columns_of_different_lengths_are_refused_with_both(hybrid):
    (found,) = refused(hybrid, {"carriers.fill": [0.4, 0.5], "motors.electric.speed_rpm": [4000.0]})
    assert "carriers.fill 2, motors.electric.speed_rpm 1" in found.message
    (found,) = refused([hybrid, hybrid], {"carriers.fill": [0.4]})
    assert "designs 2, carriers.fill 1" in found.message


def test_results_that_no_design_has_are_refused_before_any_row(hybrid):
    (found,) = refused(hybrid, AXES, results=["mas"])
    assert "no design has such a result; did you mean mass?" in found.message


def test_a_batch_shows_itself_in_a_few_lines(hybrid):
    shown = repr(size_many(hybrid, {"carriers.fill": [0.5, math.nan]}, results=["mass"]))
    assert shown.startswith("Sizings: 2 designs of 1 structures, 1 refused\ncolumns mass\nrow 1: carriers.fill")
