"""Bevel gears: forces that balance, virtual gears in their limits, impossible geometry refused."""

import math

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth, Hand, Rotation, bevel_forces
from gearwright.parts.iso6336 import GearSteel, Treatment
from gearwright.parts.iso10300 import (
    BevelDuty,
    VirtualPair,
    bevel_load_factors,
    contact_ratio_factor_bending,
    mid_zone_factor,
    spiral_angle_factor,
)

STRAIGHT = BevelPair((17, 43), 4e-3, 30e-3)

SPIRAL = BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(35.0))
STEELS = (GearSteel("case-hardened", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6),) * 2


def force_vector(forces, gear, angle):
    """Force on a gear whose axis is `angle` from x, apex at the origin, contact in the x-y plane above."""
    axis = np.array([math.cos(angle), math.sin(angle), 0.0])
    outward = np.array([-math.sin(angle), math.cos(angle), 0.0]) * (1.0 if gear == 0 else -1.0)
    return forces.axial[gear] * axis - forces.radial[gear] * outward


@pytest.mark.parametrize("hand", list(Hand))
@pytest.mark.parametrize("rotation", list(Rotation))
@pytest.mark.parametrize("shaft", [60.0, 90.0, 110.0])
def test_the_two_gears_push_each_other_equally(hand, rotation, shaft):
    """Newton's third law in the plane of the axes: the pinion's axis along x, the wheel's at Σ; exact."""
    pair = BevelPair((20, 43), 4e-3, 25e-3, math.radians(30.0), shaft_angle=math.radians(shaft))
    forces = bevel_forces(pair, 100.0, hand=hand, rotation=rotation)
    on_pinion = force_vector(forces, 0, 0.0)
    on_wheel = force_vector(forces, 1, math.radians(shaft))
    np.testing.assert_allclose(on_pinion, -on_wheel, atol=1e-9 * forces.tangential)


def test_the_total_force_is_that_of_the_normal_pressure():
    """|F| = F_mt/(cos α_n cos β_m), whatever the hand; exact."""
    for hand in Hand:
        forces = bevel_forces(SPIRAL, 2031.1, hand=hand, rotation=Rotation.CLOCKWISE)
        total = math.hypot(forces.tangential, forces.axial[0], forces.radial[0])
        expected = forces.tangential / (math.cos(SPIRAL.pressure_angle) * math.cos(SPIRAL.spiral_angle))
        assert total == pytest.approx(expected, rel=1e-12)


def test_a_left_hand_pinion_that_drives_clockwise_is_pushed_from_the_apex():
    """Both other signs turn together: right-hand counterclockwise gives the same forces."""
    good = bevel_forces(SPIRAL, 2031.1, hand=Hand.LEFT, rotation=Rotation.CLOCKWISE)
    same = bevel_forces(SPIRAL, 2031.1, hand=Hand.RIGHT, rotation=Rotation.COUNTERCLOCKWISE)
    bad = bevel_forces(SPIRAL, 2031.1, hand=Hand.RIGHT, rotation=Rotation.CLOCKWISE)
    assert good == same
    assert good.axial[0] > 0.0 > bad.axial[0]


def test_straight_teeth_do_not_know_a_hand():
    left, right = (bevel_forces(STRAIGHT, 100.0, hand=hand, rotation=Rotation.CLOCKWISE) for hand in Hand)
    assert left == right
    assert left.axial[0] == pytest.approx(left.radial[1], rel=1e-12)


def test_corrected_forces_of_the_published_helicopter_report():
    """EC120B report, bevel m = 4, 17/43, b = 30.8 mm: corrected F_mt 72 355 N, F_r 24 491 N, F_a 9682 N: 1e-3."""
    pair = BevelPair((17, 43), 4e-3, 30.82e-3)
    forces = bevel_forces(pair, 2050.0667, hand=Hand.LEFT, rotation=Rotation.CLOCKWISE)
    assert forces.tangential == pytest.approx(72355.0, rel=1e-3)
    assert forces.radial[0] == pytest.approx(24491.0, rel=1e-3)
    assert forces.axial[0] == pytest.approx(9682.0, rel=1e-3)


def test_a_face_beyond_a_third_of_the_cone_distance_is_refused():
    """The report's own 150.8 mm on a cone distance of 92.48 mm; the answer is 30.83 mm."""
    with pytest.raises(DesignError, match=r"150\.8 mm given with a cone distance of 92\.48 mm; use at most 30\.83 mm"):
        BevelPair((17, 43), 4e-3, 150.8e-3)


def test_an_undercut_pinion_is_refused_with_the_shift_that_helps():
    with pytest.raises(DesignError, match="undercuts 10 teeth") as caught:
        BevelPair((10, 30), 4e-3, 15e-3)
    least = float(str(caught.value).split("needs ")[1].split()[0])
    BevelPair((10, 30), 4e-3, 15e-3, tooth=BevelTooth(profile_shift=least + 1e-3))


def test_all_problems_come_at_once():
    with pytest.raises(DesignError, match="2 problems"):
        BevelPair((30, 20), -1.0, 15e-3)


def test_virtual_lengths_scale_with_the_module():
    """Twice the size doubles lengths and leaves ratios, exactly."""
    small, large = VirtualPair(SPIRAL), VirtualPair(BevelPair((17, 43), 17e-3, 102e-3, math.radians(35.0)))
    assert large.curvature == pytest.approx(2.0 * small.curvature, rel=1e-12)
    assert large.lines[1].length == pytest.approx(2.0 * small.lines[1].length, rel=1e-12)
    assert large.load_sharing == pytest.approx(small.load_sharing, rel=1e-12)


def test_contact_lines_stay_inside_the_zone_of_action():
    """No line is longer than the zone allows: path/sin β_vb for wide, b_v,eff/cos β_vb for narrow zones."""
    for spiral in (0.0, 5.0, 20.0, 35.0):
        virtual = VirtualPair(BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(spiral)))
        for line in virtual.lines:
            assert 0.0 <= line.length <= virtual.effective_width / math.cos(virtual.base_helix_angle) + 1e-12
            assert 0.0 <= line.peak <= 1.0


def test_straight_teeth_rate_as_the_limit_of_small_spirals():
    """Continuity at β_m → 0; 1e-3 for an angle of 0.01°."""
    straight = VirtualPair(STRAIGHT)
    nearly = VirtualPair(BevelPair((17, 43), 4e-3, 30e-3, math.radians(0.01)))
    assert mid_zone_factor(nearly) == pytest.approx(mid_zone_factor(straight), rel=1e-3)
    assert nearly.lines[1].length == pytest.approx(straight.lines[1].length, rel=1e-3)
    assert contact_ratio_factor_bending(nearly) == pytest.approx(contact_ratio_factor_bending(straight), rel=1e-3)
    assert spiral_angle_factor(straight) == 1.0


def test_a_duty_without_load_is_refused():
    with pytest.raises(DesignError, match="pinion_torque: 0 given") as caught:
        BevelDuty(0.0, 0.0, 10e-6)
    assert len(caught.value.problems) == 2


def test_a_small_cutter_relieves_the_root():
    """K_F0 lies between 1 and 1.15 (ISO 10300-1, eqs 33 to 35)."""
    virtual = VirtualPair(SPIRAL)
    wide, _ = bevel_load_factors(virtual, BevelDuty(2000.0, 150.0, 10e-6), STEELS)
    tight, _ = bevel_load_factors(virtual, BevelDuty(2000.0, 150.0, 10e-6, cutter_radius=95e-3), STEELS)
    assert wide.face_bending == wide.face_contact
    assert 1.0 < wide.face_bending / tight.face_bending <= 1.15
