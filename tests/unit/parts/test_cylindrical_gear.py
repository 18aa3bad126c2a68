"""Radii and thicknesses of one gear."""

import math

import pytest
from hypothesis import given, strategies as st

from gearwright.errors import DesignError
from gearwright.parts.gears import (
    CylindricalGear,
    ball_measurement,
    half_angle_at,
    span_measurement,
    spanned_teeth,
    tip_thickness,
)


@given(st.integers(20, 120), st.floats(-0.5, 0.5), st.floats(0.0, 0.5), st.floats(0.97, 1.03))
def test_a_rings_tooth_fills_the_space_of_the_gear_with_the_opposite_shift(teeth, shift, helix, height):
    """ISO 21771: internal tooth and external space of equal z and opposite x are one shape; rounding only."""
    outer = CylindricalGear(-teeth, 3e-3, 0.03, helix_angle=helix, profile_shift=shift)
    inner = CylindricalGear(teeth, 3e-3, 0.03, helix_angle=helix, profile_shift=-shift)
    radius = height * inner.pitch_radius
    both = half_angle_at(outer, radius) + half_angle_at(inner, radius)
    assert both == pytest.approx(math.pi / teeth, rel=1e-12)


def test_radii_of_external_and_internal_gears_mirror_each_other():
    """ISO 53 profile A: h_a = 1, h_f = 1.25 modules."""
    outer, inner = CylindricalGear(-60, 2e-3, 0.02), CylindricalGear(60, 2e-3, 0.02)
    assert outer.tip_radius == pytest.approx(58e-3) and inner.tip_radius == pytest.approx(62e-3)
    assert outer.root_radius == pytest.approx(62.5e-3) and inner.root_radius == pytest.approx(57.5e-3)


def test_every_wrong_entry_is_named_at_once():
    with pytest.raises(DesignError) as caught:
        CylindricalGear(3, -1e-3, 0.0)
    assert {problem.path for problem in caught.value.problems} == {"teeth", "module", "face_width"}


def test_the_tip_gets_pointed_with_shift():
    """A 10-tooth gear points near x = 0.8, textbook diagrams of the limits of shift."""
    assert tip_thickness(CylindricalGear(10, 1e-3, 0.01, profile_shift=0.4)) > 0.0
    assert tip_thickness(CylindricalGear(10, 1e-3, 0.01, profile_shift=0.9)) < 0.0


@pytest.mark.parametrize(("teeth", "spanned", "width"), [(20, 3, 7.6604), (30, 4, 10.7526), (60, 7, 20.0292)])
def test_span_measurement_of_standard_gears(teeth, spanned, width):
    """DIN base tangent tables for α = 20°, x = 0, m = 1; printed to four decimals."""
    gear = CylindricalGear(teeth, 1e-3, 0.01)
    assert spanned_teeth(gear) == spanned
    assert 1e3 * span_measurement(gear, spanned) == pytest.approx(width, abs=6e-5)


@pytest.mark.parametrize("teeth", [20, 21, -60, -61])
def test_a_ball_touches_both_flanks(teeth):
    """The ball's centre is D/2 away from the flank, measured along the flank's normal, which is tangent to the base."""
    gear, ball = CylindricalGear(teeth, 1e-3, 0.01, profile_shift=0.1), 1.7e-3
    across = ball_measurement(gear, ball) - gear.side * ball
    centre = 0.5 * across / (math.cos(0.5 * math.pi / teeth) if teeth % 2 else 1.0)
    tangent = math.sqrt(centre**2 - gear.base_radius**2) - gear.side * 0.5 * ball
    radius = math.hypot(gear.base_radius, tangent)
    turn = math.atan(tangent / gear.base_radius) - math.acos(gear.base_radius / centre)
    assert half_angle_at(gear, radius) + abs(turn) == pytest.approx(math.pi / abs(teeth), rel=1e-9)


def test_a_rings_span_is_refused():
    with pytest.raises(DesignError, match="balls"):
        span_measurement(CylindricalGear(-60, 1e-3, 0.01), 7)
