"""Walls of housings by hand: by casting, by torque, by bearings; arms; fatigue of cast materials from zero."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from gearwright.catalogue import housing_materials
from gearwright.parts.housings import (
    CAST_SAFETY,
    CastingRule,
    bearing_wall,
    casting_wall,
    pulsating_strength,
    torque_arm_volume,
    torque_wall,
)

near = pytest.approx
IRON = CastingRule(6e-3, 0.010, 8e-3, 50e-3)


def test_a_casting_s_wall_by_hand():
    """A box of 2 x 2 x 1 m has 16 m² and L = 2 m: 6 + 20 = 26 mm; one of 0.2 m asks 8 mm, no less; one of 6 m 50 mm."""
    assert casting_wall(16.0, IRON) == near(26e-3)
    assert casting_wall(4.0 * 0.1**2, IRON) == near(8e-3)
    assert casting_wall(4.0 * 6.0**2, IRON) == near(50e-3)
    assert casting_wall(np.array([16.0, 0.04]), IRON) == near(np.array([26e-3, 8e-3]))


def test_a_tube_s_wall_holds_its_torque_by_the_formula_of_thin_tubes():
    """A tube of radius r bears T = 2 π r² t τ, whatever its length."""
    torque, radius, shear = 1.3e6, 0.8, 25e6
    assert torque_wall(torque, math.pi * radius**2, shear) == near(torque / (2.0 * math.pi * radius**2 * shear))


def test_a_wall_shears_on_both_sides_of_a_bearing():
    """80 kN on 0.16 m: two faces of 0.16 m by t at 25 MPa, 10 mm."""
    assert 2.0 * 0.16 * bearing_wall(80e3, 0.16, 25e6) * 25e6 == near(80e3)
    assert bearing_wall(80e3, 0.16, 25e6) == near(10e-3)


@pytest.mark.parametrize("arms", [1, 2, 4])
def test_torque_arms_bear_their_torque_at_the_foot_and_weigh_the_same_however_many(arms):
    """b h² = 6 (T/n)/σ at each foot; l = 2 h and a taper to nothing: n b h l/2 = n b h²; 0.71 kg/(kN m) of iron."""
    torque, bending, height = 4e6, 60e6, 0.9
    breadth = 6.0 * torque / arms / (bending * height**2)
    assert torque_arm_volume(torque, bending) == near(arms * breadth * height * 2.0 * height / 2.0)
    assert 7100.0 * torque_arm_volume(1e3, 60e6) == near(0.71)


@pytest.mark.parametrize(
    ("name", "tensile", "share", "in_shear", "base"),
    [("aluminium", 250.0, 0.30, 0.75, 0.20 + 0.25), ("cast-iron", 400.0, 0.34, 0.65, 0.08 + 0.35 * 0.4)],
)
def test_working_stresses_are_fatigue_strengths_from_zero_over_the_stated_safety(name, tensile, share, in_shear, base):
    """σ_W = f R_m about zero, M = a R_m/1000 MPa + b; 2 σ_W/(1 + M) from zero; both times f_τ in shear; over 3.5."""
    material = housing_materials()[name]
    bending = 2.0 * share * tensile / (1.0 + base)
    shear = 2.0 * in_shear * share * tensile / (1.0 + in_shear * base)
    assert material.bending_strength == near(bending * 1e6 / 3.5, rel=5e-3)
    assert material.shear_strength == near(shear * 1e6 / 3.5, rel=5e-3)
    assert near(2.1 * 1.5 / 0.89, rel=0.02) == CAST_SAFETY
    assert pulsating_strength(share * tensile, base) == near(bending)


@given(st.floats(1e-3, 200.0), st.floats(1.0, 3.0))
def test_a_larger_housing_never_has_a_thinner_wall(area, more):
    for material in housing_materials().values():
        assert casting_wall(more * area, material.casting) >= casting_wall(area, material.casting)
        assert material.casting.least <= casting_wall(area, material.casting) <= material.casting.most
