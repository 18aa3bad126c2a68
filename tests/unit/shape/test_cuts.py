"""Sections of chambers: what is cut is what is metal there; unions keep areas, outlines go around them."""

import math

import numpy as np
import pytest

from gearwright.shape.chambers import (
    Chamber,
    End,
    Leg,
    Opening,
    Rectangle,
    cut_chamber,
    depth_in,
    round_hole,
    spans_in,
    united,
    without,
)

STRAIGHT = (Leg(-math.inf, math.inf, np.zeros(2), np.array([1.0, 0.0])),)


def square(half):
    return np.array([[-half, -half], [half, -half], [half, half], [-half, half]])


def area(loop):
    """Return the area inside of a loop, counter-clockwise positive."""
    return sum(x * v - u * y for (x, y), (u, v) in zip(loop, [*loop[1:], loop[0]], strict=True)) / 2.0


def space(legs, z, at):
    """Return points of a section in the chamber's frame."""
    points = []
    for z_of, place in zip(z, at, strict=True):
        leg = next(leg for leg in legs if place <= leg.high)
        points.append([*(leg.foot + place * leg.along), z_of])
    return np.array(points)


def test_a_way_is_inside_of_a_loop_from_side_to_side():
    """A square of ±1: along x from −1 to 1; along a diagonal 2 √2 long; beside it not at all."""
    (span,) = spans_in(square(1.0), STRAIGHT)
    assert span == pytest.approx((-1.0, 1.0))
    way = np.array([1.0, 1.0]) / math.sqrt(2.0)
    (span,) = spans_in(square(1.0), [Leg(-math.inf, math.inf, np.zeros(2), way)])
    assert span[1] - span[0] == pytest.approx(2.0 * math.sqrt(2.0))
    assert spans_in(square(1.0), [STRAIGHT[0]._replace(foot=np.array([0.0, 1.5]))]) == []


def test_a_way_goes_on_round_a_corner():
    """From −1 along x to the middle, from there upwards: one span of 1 + 1."""
    legs = (
        Leg(-math.inf, 0.0, np.zeros(2), np.array([1.0, 0.0])),
        Leg(0.0, math.inf, np.zeros(2), np.array([0.0, 1.0])),
    )
    assert spans_in(square(1.0), legs) == [pytest.approx((-1.0, 1.0))]


def test_what_is_taken_is_taken():
    assert without([(0.0, 4.0)], [(1.0, 2.0), (3.0, 9.0)]) == [(0.0, 1.0), (2.0, 3.0)]


@pytest.mark.parametrize("turn", [0.0, 0.4, 1.3])
def test_what_is_cut_is_what_is_metal(turn):
    """Against the depth in the metal at points drawn at random, of a way with a corner."""
    chamber = Chamber(square(2.0), square(1.7), (0.0, 3.0), (End(0.2, (round_hole([0.1, -0.2], 0.5),)), None))
    way = np.array([math.cos(turn), math.sin(turn)])
    legs = (Leg(-math.inf, 0.0, np.zeros(2), np.array([1.0, 0.0])), Leg(0.0, math.inf, np.zeros(2), way))
    cut = cut_chamber(chamber, legs)
    rng = np.random.default_rng(3)
    z, at = rng.uniform(-0.5, 3.5, 4000), rng.uniform(-3.0, 3.0, 4000)
    drawn = [any(one.start < x < one.end and one.low < y < one.high for one in cut) for x, y in zip(z, at, strict=True)]
    metal = [depth_in(point[None], chamber) > 0.0 for point in space(legs, z, at)]
    assert drawn == metal and 200 < sum(metal) < 2000


def test_an_opening_is_cut_along_its_axis_and_refused_across_it():
    """Radius 0.5, 0.3 beside the section: 2 √(0.5² − 0.3²) = 0.8 wide; a section that leans through it is none."""
    opening = Opening(np.array([1.0, 0.0]), np.array([0.0, 0.3, 1.5]), 0.5)
    chamber = Chamber(square(2.0), square(1.8), (0.0, 3.0), openings=(opening,))
    cut = cut_chamber(chamber, STRAIGHT)
    assert sum((one.end - one.start) * (one.high - one.low) for one in cut) == pytest.approx(0.2 * (3.0 + 3.0 - 0.8))
    way = np.array([math.cos(0.1), math.sin(0.1)])
    assert cut_chamber(chamber, [Leg(-math.inf, math.inf, np.zeros(2), way)]) is None
    assert cut_chamber(chamber, [Leg(-math.inf, math.inf, np.zeros(2), np.array([0.0, 1.0]))]) is not None


def test_a_union_counts_what_lies_over_itself_once_and_goes_around_holes_the_other_way():
    """A frame of 4 by 4 around 2 by 2 of four bars that cross at the corners: 12, of 16 less 4."""
    bars = [Rectangle(0, 4, 0, 1), Rectangle(0, 4, 3, 4), Rectangle(0, 1, 0, 4), Rectangle(3, 4, 0, 4)]
    (cut,) = united(bars)
    assert sorted(area(loop) for loop in cut.loops) == pytest.approx([-4.0, 16.0])
    assert [len(loop) for loop in cut.loops] == [4, 4]
    assert sum((one.end - one.start) * (one.high - one.low) for one in cut.rectangles) == pytest.approx(12.0)


def test_a_joint_parts_what_lies_across_it():
    left, right = united([Rectangle(0, 4, 0, 1), Rectangle(2, 6, 0, 1)], [3.0])
    assert [sorted({x for x, _ in cut.loops[0]}) for cut in (left, right)] == [[0.0, 3.0], [3.0, 6.0]]


def test_cells_that_touch_at_a_corner_have_outlines_of_their_own():
    (cut,) = united([Rectangle(0, 1, 0, 1), Rectangle(1, 2, 1, 2)])
    assert [area(loop) for loop in cut.loops] == [1.0, 1.0]
