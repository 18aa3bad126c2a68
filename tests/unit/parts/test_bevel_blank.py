"""Blanks of bevel gears: cones that meet where they must, and cutters that do not do."""

import math
from dataclasses import replace

import pytest

from gearwright.errors import DesignError
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth, bevel_blank, dedendum_angles, least_cutter_radius

PAIR = BevelPair((14, 39), 4.5e-3, 25e-3, math.radians(35.0), tooth=BevelTooth(profile_shift=0.4))


def test_roots_of_the_standard_taper_point_to_the_apex():
    """h_fe/R_e = h_fm/R_m, and the whole depth is the same part of the cone distance everywhere."""
    blank = bevel_blank(PAIR)
    for outer, mean in zip(blank.outer_dedendum, PAIR.dedenda, strict=True):
        assert outer / PAIR.outer_cone_distance == pytest.approx(mean / PAIR.mean_cone_distance, rel=1e-12)
    assert blank.outer_spiral_angle == blank.inner_spiral_angle == PAIR.spiral_angle


@pytest.mark.parametrize("cutter", [None, 114.3e-3])
def test_tips_are_parallel_to_the_roots_of_the_mate(cutter):
    """δ_a1 + δ_f2 = Σ: clearance is the same along the face."""
    blank = bevel_blank(PAIR, cutter)
    assert blank.tip_angle[0] + blank.root_angle[1] == pytest.approx(PAIR.shaft_angle, rel=1e-12)
    assert blank.tip_angle[1] + blank.root_angle[0] == pytest.approx(PAIR.shaft_angle, rel=1e-12)
    clearances = [blank.outer_dedendum[gear] - blank.outer_addendum[1 - gear] for gear in (0, 1)]
    assert clearances == pytest.approx([0.25 * PAIR.mean_module] * 2, rel=1e-9)


def test_thicknesses_share_the_pitch():
    assert sum(bevel_blank(PAIR).thickness) == pytest.approx(math.pi * PAIR.mean_module, rel=1e-12)


def test_larger_cutters_taper_more_and_the_smallest_not_at_all():
    """Duplex: Σθ_f rises from 0 at r_c0 = R_m sin β_m towards 90° m_et/(R_e tan α cos β)."""
    least = PAIR.mean_cone_distance * math.sin(PAIR.spiral_angle)
    sums = [sum(dedendum_angles(PAIR, radius)) for radius in (least, 0.06, 0.09, 0.15, 1e6)]
    assert sums[0] == pytest.approx(0.0, abs=1e-15)
    assert sums == sorted(sums)
    most = 0.5 * math.pi * 4.5e-3 / (PAIR.outer_cone_distance * math.tan(PAIR.pressure_angle))
    assert sums[-1] == pytest.approx(most / math.cos(PAIR.spiral_angle), rel=1e-6)


def test_the_smallest_cutter_is_named():
    least = least_cutter_radius(PAIR)
    assert bevel_blank(PAIR, least).outer_spiral_angle > PAIR.spiral_angle
    with pytest.raises(DesignError, match=f"ask for {1e3 * least:.4g} mm"):
        bevel_blank(PAIR, 0.99 * least)


def test_a_slight_spiral_asks_for_a_cutter_that_reaches_both_ends():
    slight = replace(PAIR, spiral_angle=math.radians(3.0))
    least = least_cutter_radius(slight)
    assert least > slight.mean_cone_distance * math.sin(slight.spiral_angle)
    assert math.degrees(bevel_blank(slight, least).outer_spiral_angle) < 90.0


def test_straight_teeth_ask_for_no_cutter():
    straight = replace(PAIR, spiral_angle=0.0)
    assert bevel_blank(straight, 1e-3) == bevel_blank(straight)
