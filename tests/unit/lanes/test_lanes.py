"""Numbers in lanes: every lane has the bits that Python's numbers give alone, and what differs is never guessed."""

import math
import operator
import random

import numpy as np
import pytest

from gearwright.lanes import Diverged, Lanes, Unsupported, chosen, functions as lane_math, twin
from gearwright.lanes.builtin import float_, int_, isinstance_, max_, min_, sum_
from gearwright.lanes.numeric import numpy as lane_numpy

DRAW = random.Random(7)
ONE = [DRAW.uniform(0.1, 9.0) * 10.0 ** DRAW.randint(-6, 6) for _ in range(500)]
OTHER = [DRAW.uniform(0.1, 9.0) for _ in range(500)]


def pairs(one, other):
    return zip(one, other, strict=True)


def lanes(values):
    return Lanes(np.array(values))


@pytest.mark.parametrize("name", ["add", "sub", "mul", "truediv", "pow", "mod", "floordiv", "lt", "ge", "eq"])
def test_operators_give_the_bits_of_numbers(name):
    function = getattr(operator, name)
    with np.errstate(all="ignore"):
        found = function(lanes(ONE), lanes(OTHER)).data.tolist()
        by_a_number = function(2.5, lanes(OTHER)).data.tolist()
    assert found == [function(one, other) for one, other in zip(ONE, OTHER, strict=True)]
    assert by_a_number == [function(2.5, other) for other in OTHER]


@pytest.mark.parametrize("name", ["sqrt", "sin", "cos", "tan", "atan", "exp", "cbrt", "log", "hypot", "atan2"])
def test_functions_give_the_bits_of_numbers(name):
    function, arguments = getattr(math, name), (OTHER, ONE) if name in ("hypot", "atan2") else (OTHER,)
    found = getattr(lane_math, name)(*map(lanes, arguments)).data.tolist()
    assert found == [function(*numbers) for numbers in zip(*arguments, strict=True)]


@pytest.mark.parametrize("exponent", [0, 2, 3, 2.0, 4.0])
def test_whole_powers_of_any_number_have_the_bits_of_numbers(exponent):
    bases = [0.0, -0.0, *ONE, *(-one for one in OTHER)]
    found = (lanes(bases) ** exponent).data.tolist()
    assert list(map(float.hex, found)) == [float(base**exponent).hex() for base in bases]


def test_one_number_in_all_lanes_is_computed_once_and_zeros_of_both_signs_are_two():
    times = []

    def counted(*numbers):
        times.append(numbers)
        return math.atan2(*numbers)

    in_all = lane_math.in_lanes(counted)
    assert in_all(lanes([0.3] * 7), 2.0).data.tolist() == [math.atan2(0.3, 2.0)] * 7 and len(times) == 1
    assert in_all(lanes([0.0, -0.0]), -1.0).data.tolist() == [math.pi, -math.pi]


def test_numbers_are_close_as_python_finds_them():
    numbers = [0.0, -0.0, 1.0, 1.0 + 1e-9, 1.0 - 2e-9, 1e-12, -1.0, math.inf, -math.inf, math.nan, *ONE[:5]]
    one, other = ([a for a in numbers for _ in numbers], numbers * len(numbers))
    for given in ({}, {"rel_tol": 2e-9}, {"abs_tol": 1e-11}):
        with np.errstate(all="ignore"):
            found = lane_math.isclose(lanes(one), lanes(other), **given).data.tolist()
        assert found == [math.isclose(a, b, **given) for a, b in pairs(one, other)]


def test_complex_numbers_are_multiplied_and_divided_as_python_does():
    one, other = ([complex(a, b) for a, b in pair] for pair in (pairs(ONE, OTHER), pairs(OTHER, ONE[::-1])))
    for function in (operator.mul, operator.truediv, operator.add):
        assert function(lanes(one), lanes(other)).data.tolist() == [function(a, b) for a, b in pairs(one, other)]
    assert abs(lanes(one)).data.tolist() == list(map(abs, one))


def test_sums_extremes_and_roundings_are_those_of_numbers():
    columns = [ONE, OTHER, ONE[::-1]]
    given, rows = list(map(lanes, columns)), list(zip(*columns, strict=True))
    assert sum_(given).data.tolist() == list(map(sum, rows))
    assert max_(given).data.tolist() == list(map(max, rows))
    assert min_(*given).data.tolist() == list(map(min, rows))
    assert round(given[1], 3).data.tolist() == [round(value, 3) for value in OTHER]


def test_a_truth_that_differs_parts_the_lanes_and_one_that_does_not_is_a_truth():
    assert lanes([1.0, 2.0]) > 0.0
    assert not lanes([1.0, 2.0]) > 3.0
    with pytest.raises(Diverged) as parted:
        bool(lanes([1.0, 2.0]) > 1.5)
    assert parted.value.labels.tolist() == [False, True]
    with pytest.raises(Diverged) as parted:
        range(lanes([3, 4, 3]))
    assert parted.value.labels.tolist() == [3, 4, 3]
    assert len(range(lanes([3, 3]))) == 3


def test_lanes_are_no_number_outside_of_their_functions():
    for function in (float, int, math.sin, np.asarray, np.cbrt):
        with pytest.raises(TypeError):
            function(lanes(ONE))


def test_a_division_by_zero_parts_the_lanes_that_have_one():
    with pytest.raises(Diverged) as parted:
        1.0 / lanes([0.0, 1.0])
    assert parted.value.labels.tolist() == [True, False]
    with pytest.raises(Unsupported):
        1.0 / lanes([0.0, 0.0])


def test_kinds_are_those_of_the_numbers_inside():
    assert isinstance_(lanes(ONE), float) and not isinstance_(lanes(ONE), int | np.ndarray)
    assert isinstance_(lanes([1, 2]), int) and isinstance_(Lanes(np.ones((2, 3))), np.ndarray)
    assert int_(lanes([1.9, -1.9])).data.tolist() == [1, -1]
    assert float_(lanes([1, 2])).data.dtype == np.float64


def test_numbers_are_chosen_lane_by_lane():
    assert chosen(lanes([True, False]), lanes([1.0, 2.0]), 5.0).data.tolist() == [1.0, 5.0]
    assert chosen(True, 1.0, 2.0) == 1.0


@pytest.mark.parametrize("rows, columns", [(3, 4), (6, 6), (9, 11)])
def test_linear_algebra_of_every_lane_is_that_of_its_matrix_alone(rows, columns):
    draw = np.random.default_rng(3)
    matrices, vectors = draw.normal(size=(50, rows, columns)), draw.normal(size=(50, columns))
    product = Lanes(matrices) @ Lanes(vectors)
    assert all(np.array_equal(product.data[k], matrices[k] @ vectors[k]) for k in range(50))
    transposed = Lanes(matrices) @ Lanes(matrices).T
    assert all(np.array_equal(transposed.data[k], matrices[k] @ matrices[k].T) for k in range(50))
    for axis in (None, 0, 1):
        summed = Lanes(matrices).sum(axis=axis)
        lengths = lane_numpy.linalg.norm(Lanes(matrices), axis=axis)
        assert all(np.array_equal(summed.data[k], matrices[k].sum(axis=axis)) for k in range(50))
        assert all(np.array_equal(lengths.data[k], np.linalg.norm(matrices[k], axis=axis)) for k in range(50))
    if rows == columns:
        inverse = lane_numpy.linalg.inv(Lanes(matrices))
        assert all(np.array_equal(inverse.data[k], np.linalg.inv(matrices[k])) for k in range(50))


def test_arrays_take_lanes_where_they_are_written():
    array = lane_numpy.zeros((2, 2))
    array[0, 1] += lanes([1.0, 2.0])
    array[1, 1] = 3.0
    assert array.data.tolist() == [[[0.0, 1.0], [0.0, 3.0]], [[0.0, 2.0], [0.0, 3.0]]]


def test_a_twin_computes_the_same_formula_for_a_number_and_for_lanes():
    single = twin("gearwright.parts.gears.cylindrical_gear")
    from gearwright.parts.gears import involute, transverse_pressure_angle

    angles = [0.1 + 0.001 * k for k in range(300)]
    assert single.involute(0.3) == involute(0.3)
    assert single.involute(lanes(angles)).data.tolist() == list(map(involute, angles))
    helix = [0.001 * k for k in range(300)]
    found = single.transverse_pressure_angle(0.35, lanes(helix)).data.tolist()
    assert found == [transverse_pressure_angle(0.35, angle) for angle in helix]
