"""Limits and fits of ISO 286."""

import math

import pytest

from gearwright.catalogue import seat_tolerance, shaft_limits, standard_tolerance
from gearwright.errors import DesignError
from gearwright.parts.bearings import BearingKind


@pytest.mark.parametrize(
    ("diameter", "tolerance", "limits"),
    [(0.045, "k6", (2, 18)), (0.045, "m6", (9, 25)), (0.060, "m6", (11, 30)), (0.060, "n6", (20, 39)),
     (0.100, "h7", (-35, 0)), (0.020, "k5", (2, 11))],
)  # fmt: skip
def test_limits_are_those_of_iso_286_2(diameter, tolerance, limits):
    """ISO 286-2:2010, tables of shaft deviations in µm."""
    assert tuple(round(1e6 * each) for each in shaft_limits(diameter, tolerance)) == limits


def test_standard_tolerances_grow_by_1_6_each_fifth_grade_of_ten():
    """ISO 286-1: five grades are a factor of ten; the table's rounding keeps within 10 %."""
    for diameter in (0.008, 0.040, 0.090, 0.300):
        assert standard_tolerance(diameter, 10) / standard_tolerance(diameter, 5) == pytest.approx(10.0, rel=0.1)


@pytest.mark.parametrize(
    ("low", "high"),
    [(500, 630), (630, 800), (800, 1000), (1000, 1250), (1250, 1600), (1600, 2000), (2000, 2500), (2500, 3150)],
)
def test_tolerances_of_large_sizes_are_those_of_iso_286s_formula(low, high):
    """ISO 286-1:2010: 10, 16, 25, 40, 64 and 100 times I = 0.004 D + 2.1 µm, D the range's geometric mean, rounded."""
    step = 0.004 * math.sqrt(low * high) + 2.1
    for grade, steps in zip(range(6, 12), (10, 16, 25, 40, 64, 100), strict=True):
        assert 1e6 * standard_tolerance(1e-3 * high, grade) == pytest.approx(steps * step, rel=0.035)


def test_sizes_and_classes_outside_of_the_table_are_named():
    with pytest.raises(DesignError, match="above 6 up to 3150 mm"):
        shaft_limits(3.2, "k6")
    with pytest.raises(DesignError, match="no IT12"):
        standard_tolerance(0.05, 12)


def test_seats_of_rollers_are_tighter_than_those_of_balls():
    assert seat_tolerance(BearingKind.DEEP_GROOVE, 0.045) == "k6"
    assert seat_tolerance(BearingKind.CYLINDRICAL, 0.045) == "m6"
    assert seat_tolerance(BearingKind.TAPER, 0.120) == "n6"
