"""Pairs: backlash, path of contact, contact ratios, interference of internal pairs."""

import math

import pytest
from hypothesis import given, strategies as st
from scipy.optimize import brentq

from gearwright.errors import DesignError
from gearwright.parts.gears import (
    ISO53_D,
    CylindricalGear,
    GearPair,
    assembly_room,
    contact_radii,
    half_angle_at,
    interference,
    involute_clearance,
    pressure_angle_at,
    tip_clearance_angle,
)


def gear(teeth, shift=0.0, module=3e-3, **more):
    return CylindricalGear(teeth, module, 0.02, profile_shift=shift, **more)


@given(st.integers(17, 40), st.integers(80, 120), st.floats(0.0, 0.4), st.floats(-0.1, 0.3), st.sampled_from([1, -1]))
def test_without_a_given_centre_distance_the_backlash_is_zero(first, second, x_1, x_2, side):
    """Thickness over the working circles closes the pitch, ISO 21771; 1e-12 m is rounding."""
    pair = GearPair(gear(first, x_1), gear(side * second, x_2))
    assert abs(pair.backlash) < 1e-12


def test_a_longer_centre_distance_opens_an_external_pair_and_a_shorter_one_a_ring():
    outer, ring = GearPair(gear(20), gear(40)), GearPair(gear(20), gear(-60))
    assert GearPair(gear(20), gear(40), outer.centre_distance + 1e-4).backlash > 0.0
    assert GearPair(gear(20), gear(-60), ring.centre_distance - 1e-4).backlash > 0.0


def test_contact_and_overlap_ratio_of_the_iso_example():
    """ISO/TR 6336-30:2017, example 1: Z_ε = 0.803 is printed, √(1/ε_α) for ε_β ≥ 1; three digits."""
    pair = GearPair(
        CylindricalGear(17, 8e-3, 0.1, helix_angle=math.radians(15.8), profile_shift=0.145, rack=ISO53_D),
        CylindricalGear(103, 8e-3, 0.1, helix_angle=math.radians(15.8), rack=ISO53_D),
        0.5,
    )
    assert math.sqrt(1.0 / pair.transverse_contact_ratio) == pytest.approx(0.803, abs=5e-4)
    assert pair.overlap_ratio == pytest.approx(0.1 * math.sin(math.radians(15.8)) / (math.pi * 8e-3))


def test_contact_ratio_of_the_fzg_c_gears():
    """FZG type C: z 16/24, m 4.5, a 91.5 mm, tips 82.46 and 118.36 mm, ε_α = 1.44 in the FZG literature."""
    gears = []
    for teeth, shift, tip in ((16, 0.1817, 82.46e-3), (24, 0.1715, 118.36e-3)):
        full = CylindricalGear(teeth, 4.5e-3, 0.014, profile_shift=shift)
        short = (0.5 * tip - full.tip_radius) / 4.5e-3
        gears.append(CylindricalGear(teeth, 4.5e-3, 0.014, profile_shift=shift, tip_alteration=short))
    assert GearPair(*gears, 91.5e-3).transverse_contact_ratio == pytest.approx(1.44, abs=0.005)


@pytest.mark.parametrize("driven", [50, -80])
def test_contact_ends_at_the_tips_and_passes_the_pitch_circles(driven):
    pair = GearPair(gear(24), gear(driven))
    assert contact_radii(pair, pair.recess)[0] == pytest.approx(pair.driver.tip_radius)
    assert contact_radii(pair, -pair.approach)[1] == pytest.approx(pair.driven.tip_radius)
    assert contact_radii(pair, 0.0) == pytest.approx((pair.driver.pitch_radius, pair.driven.pitch_radius))


def test_contact_never_goes_below_the_pinions_base_circle():
    """A 10-tooth pinion and a rack-like wheel: the wheel's tip reaches past the tangent point, the contact does not."""
    pair = GearPair(gear(10), gear(200))
    assert contact_radii(pair, -pair.approach)[0] == pytest.approx(pair.driver.base_radius)


def test_gears_that_cannot_mesh_are_refused_with_every_reason():
    with pytest.raises(DesignError) as caught:
        GearPair(gear(20), CylindricalGear(40, 4e-3, 0.02, helix_angle=0.2))
    assert len(caught.value.problems) == 2
    with pytest.raises(DesignError, match="external"):
        GearPair(gear(-60), gear(20))
    with pytest.raises(DesignError, match="inside"):
        GearPair(gear(60), gear(-60))
    with pytest.raises(DesignError, match="base circles"):
        GearPair(gear(20), gear(40), 0.08)


@pytest.mark.parametrize(("pinion", "fouls"), [(48, False), (54, True)])
def test_tip_clearance_is_that_of_the_turning_gears(pinion, fouls):
    """Turn the pinion until its tip corner crosses the ring's tip circle and compare the two corners' angles."""
    pair = GearPair(gear(pinion), gear(-60))
    working = math.tan(pair.working_pressure_angle) - pair.working_pressure_angle

    def corner(part):
        angle = pressure_angle_at(part, part.tip_radius)
        return working - (math.tan(angle) - angle)

    def place(turn):
        angle = corner(pair.driver) + turn
        x = pair.centre_distance + pair.driver.tip_radius * math.cos(angle)
        return x, pair.driver.tip_radius * math.sin(angle)

    turn = brentq(lambda t: math.hypot(*place(t)) - pair.driven.tip_radius, 0.0, math.pi, xtol=1e-14)
    x, y = place(turn)
    clearance = corner(pair.driven) + turn * pinion / 60 - math.atan2(y, x)
    assert tip_clearance_angle(pair) == pytest.approx(clearance, abs=1e-10)
    assert bool(interference(pair)) is fouls


def test_a_small_pinion_is_undercut_by_the_rings_tip_and_an_external_pair_is_not_asked():
    """20°, full depth: rings foul the involute of pinions below about 20 teeth when they have 60."""
    assert involute_clearance(GearPair(gear(18), gear(-60))) < 0.0 < involute_clearance(GearPair(gear(24), gear(-60)))
    assert interference(GearPair(gear(18), gear(-60)))[0].path == "driven"
    assert interference(GearPair(gear(12), gear(60))) == ()


def test_a_pinion_nearly_as_large_as_its_ring_must_go_in_axially():
    """The gap at the working position can only shrink with more teeth over the same arc."""
    small, large = (assembly_room(GearPair(gear(teeth), gear(-60))) for teeth in (30, 50))
    assert small.clearance > 0.0 > large.clearance
    centred = half_angle_at(gear(-60), gear(-60).tip_radius)
    assert centred < math.pi / 60
