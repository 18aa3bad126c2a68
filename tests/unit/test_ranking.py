"""What is equal but for rounding is equal: no order and no choice hangs on the last digit of a processor."""

import math

import numpy as np
import pytest

from gearwright.arrays import largest, largest_first, place_of_largest, place_of_smallest, smallest, smallest_first

SUM = 0.1 + 0.2
"""0.30000000000000004."""


def test_the_first_of_equals_is_the_largest_in_whatever_way_it_is_rounded():
    assert largest([("left", 0.3), ("right", SUM)], lambda row: row[1])[0] == "left"
    assert largest([("left", SUM), ("right", 0.3)], lambda row: row[1])[0] == "left"
    assert largest([("left", 0.3), ("right", 0.3001)], lambda row: row[1])[0] == "right"


def test_equals_and_zeros_with_rounding_stay_in_their_order():
    rows = {"idle": 3e-15, "left": 0.3, "rest": 0.0, "most": 2.0, "right": SUM, "still": 5e-15}
    assert largest_first(rows, rows.__getitem__) == ["most", "left", "right", "idle", "rest", "still"]
    assert largest_first([], float) == []


def test_the_first_of_equals_is_the_smallest_in_whatever_way_it_is_rounded():
    assert smallest([("left", SUM), ("right", 0.3)], lambda row: row[1])[0] == "left"
    assert smallest([("left", 0.3), ("right", SUM)], lambda row: row[1])[0] == "left"
    assert smallest([("left", 0.3001), ("right", SUM)], lambda row: row[1])[0] == "right"


@pytest.mark.parametrize("choose", [largest, smallest])
def test_numbers_below_zero_and_infinite_ones_are_compared_as_others_are(choose):
    """Reserves are below zero where something falls short, lives without bound where nothing loads a part."""
    rows = {"short": -0.3, "as short": -SUM, "one": 1.0, "bound": math.inf, "none": math.inf}
    assert choose(rows, rows.__getitem__) == {largest: "bound", smallest: "short"}[choose]
    assert choose(list(reversed(rows)), rows.__getitem__) == {largest: "none", smallest: "as short"}[choose]


def test_rising_values_stand_with_equals_as_they_came_and_infinite_ones_last():
    rows = {"none": math.inf, "right": SUM, "idle": 3e-17, "left": 0.3, "short": -1.0, "rest": 0.0}
    assert smallest_first(rows, rows.__getitem__) == ["short", "idle", "rest", "right", "left", "none"]
    assert smallest_first([], float) == []


def test_the_place_of_the_largest_number_is_the_first_of_equals():
    assert place_of_largest(np.array([0.1, 0.3, SUM])) == place_of_largest(np.array([0.1, SUM, 0.3])) == 1
    assert place_of_largest(np.array([[math.nan, -2.0], [-1.0, -3.0]])) == 2
    assert place_of_largest(np.array([1.0, math.inf])) == place_of_smallest(np.array([1.0, -math.inf])) == 1
    assert place_of_smallest(np.array([0.9, SUM, 0.3])) == place_of_smallest(np.array([0.9, 0.3, SUM])) == 1
