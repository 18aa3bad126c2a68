"""The common form of mesh stiffness, and the ways into it."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from gearwright.errors import DesignError
from gearwright.parts.stiffness import StiffnessCurve, pair_curve, rectangular_curve, sampled_curve, stiffness_at


def test_a_curve_is_its_series():
    curve = StiffnessCurve(10.0, (1.0, 2.0), (3.0, 0.5))
    phase = 0.7
    expected = 10.0 + math.cos(phase) + 2.0 * math.cos(1.4) + 3.0 * math.sin(phase) + 0.5 * math.sin(1.4)
    assert float(stiffness_at(curve, phase)) == pytest.approx(expected)


def test_a_curve_that_goes_negative_is_refused():
    with pytest.raises(DesignError, match="must be positive"):
        StiffnessCurve(1.0, (2.0,), (0.0,))


@given(st.floats(0.5, 0.95), st.floats(0.5, 0.95))
def test_the_two_levels_of_iso_have_the_mean_of_iso(approach, recess):
    """c_γ = c′ (0.75 ε_α + 0.25), ISO 6336-1:2006, clause 9; rounding only."""
    curve = rectangular_curve(2.0, (-approach, recess), harmonics=0)
    assert curve.mean == pytest.approx(2.0 * (0.75 * (approach + recess) + 0.25))


def test_many_harmonics_show_the_two_levels():
    """Cut at n = 400 the series is within 1/(π² n Δ) of the levels at Δ = 0.1 cycles from a jump: 0.3 % of the step."""
    curve = rectangular_curve(1.0, (-0.8, 0.7), harmonics=400)
    # ε_α = 1.5: a second pair touches for −0.8 < τ < −0.3 and 0.2 < τ < 0.7, one pair between.
    assert stiffness_at(curve, 2 * np.pi * np.array([-0.05, 0.45])) == pytest.approx([1.0, 1.75], abs=3e-3)


def test_a_pair_of_constant_stiffness_gives_the_rectangular_curve():
    """Quadrature against the closed form; Gauss is exact to rounding for these orders."""
    ends = (-0.83, 0.71)
    one = pair_curve(ends, lambda place: np.full_like(place, 5.0), overlap=0.3, harmonics=20, source="")
    other = rectangular_curve(5.0, ends, step=1.0, overlap=0.3, harmonics=20)
    assert one.cosine == pytest.approx(other.cosine, abs=1e-10) and one.sine == pytest.approx(other.sine, abs=1e-10)


@given(st.integers(1, 3))
def test_a_whole_overlap_ratio_makes_helical_stiffness_constant(overlap):
    """Slices that cover whole pitches: every harmonic vanishes (sinc of a whole number)."""
    curve = rectangular_curve(1.0, (-0.8, 0.7), overlap=float(overlap), harmonics=6)
    assert np.hypot(curve.cosine, curve.sine) == pytest.approx(np.zeros(6), abs=1e-15)


def test_slicing_is_the_average_over_the_face():
    """The sliced curve is the spur curve averaged over ε_β cycles about the same phase; 401 slices, trapezoid."""
    spur = rectangular_curve(1.0, (-0.8, 0.7), harmonics=6)
    helical = rectangular_curve(1.0, (-0.8, 0.7), overlap=0.4, harmonics=6)
    slices = np.linspace(-0.2, 0.2, 401) * 2.0 * np.pi
    for phase in (0.0, 1.0, 2.5):
        average = np.trapezoid(stiffness_at(spur, phase + slices), slices) / (0.4 * 2.0 * np.pi)
        assert float(stiffness_at(helical, phase)) == pytest.approx(float(average), rel=1e-4)


def test_points_of_a_known_series_give_it_back():
    """A polygon of 2000 chords is within (π/2000)²/3 ≈ 1e-6 of the curve."""
    phase = np.linspace(0.0, 2.0 * np.pi, 2001)
    curve = sampled_curve(phase, 10.0 + 2.0 * np.cos(phase) - np.sin(3.0 * phase), harmonics=3, source="measured")
    assert curve.mean == pytest.approx(10.0)
    assert curve.cosine == pytest.approx((2.0, 0.0, 0.0), abs=1e-5)
    assert curve.sine == pytest.approx((0.0, 0.0, -1.0), abs=1e-5)


def test_uneven_points_without_a_closing_one_are_closed():
    """The triangle through (0, 1) and (π, 3): mean 2, first harmonic −8/π² · 1."""
    curve = sampled_curve(
        [0.0, 1.0, math.pi, 5.0],
        [1.0, 1.0 + 2.0 / math.pi, 3.0, 3.0 - 2 * (5 - math.pi) / math.pi],
        harmonics=1,
        source="",
    )
    assert curve.mean == pytest.approx(2.0)
    assert curve.cosine[0] == pytest.approx(-8.0 / math.pi**2)


@pytest.mark.parametrize(
    ("phase", "stiffness", "says"),
    [
        ([0.0, 1.0], [1.0, 1.0], "at least 3"),
        ([0.0, 2.0, 1.0], [1.0, 1.0, 1.0], "increase"),
        ([0.0, 1.0, 7.0], [1.0, 1.0, 1.0], "2π"),
        ([0.0, 1.0, 2.0 * math.pi], [1.0, 1.0, 2.0], "not periodic"),
        ([0.0, 1.0, 2.0], [1.0, -1.0, 1.0], "point 1"),
        ([0.0, 1.0, 2.0], [1.0, 1.0, math.inf], "finite"),
    ],
)
def test_bad_points_are_refused_with_the_reason(phase, stiffness, says):
    with pytest.raises(DesignError, match=says):
        sampled_curve(phase, stiffness, harmonics=2, source="")
