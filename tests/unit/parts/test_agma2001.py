"""AGMA 2001 and 908: limits, joints between regimes, signs, and what is refused."""

import math

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.agma908 import (
    HobbedPair,
    LoadPlace,
    bending_geometry,
    helical_overlap_factor,
    load_sharing_ratio,
    pitting_geometry_factor,
    stress_correction,
)
from gearwright.parts.agma2001 import (
    BENDING_CARBURISED,
    EXTRA_PRECISION,
    OPEN_GEARING,
    PITTING,
    AgmaGear,
    AgmaLoad,
    AgmaMesh,
    AgmaSteel,
    AgmaStrength,
    agma_rating,
    agma_strength,
    dynamic_factor_agma,
    elastic_coefficient,
    hardness_ratio_factor,
    load_distribution_factor,
    reliability_factor,
    rim_factor_agma,
)
from gearwright.parts.iso6336 import life_factor


def helical(width, helix=20.0):
    return HobbedPair((21, 55), helix_angle=math.radians(helix), face_width=width)


def test_helical_gears_start_as_spur_gears():
    """C_ψ → 1 and I, J → spur values as the helix vanishes: 1e-3 at 0.01°."""
    spur, nearly = HobbedPair((21, 55)), helical(10.0, 0.01)
    assert helical_overlap_factor(nearly) == pytest.approx(1.0, abs=1e-3)
    assert pitting_geometry_factor(nearly) == pytest.approx(pitting_geometry_factor(spur), rel=2e-3)
    assert bending_geometry(nearly, 0).factor == pytest.approx(bending_geometry(spur, 0).factor, rel=2e-3)


def test_the_length_of_contact_lines_is_the_mean_at_whole_ratios():
    """m_F = 2: no line is wasted at whole axial ratios, so L_min = m_p F/cos ψ_b; rounding of the modulus only."""
    pair = helical(2.0 * math.pi / math.sin(math.radians(20.0)) * (1.0 + 1e-12))
    profile = pair.contact_length / pair.base_pitch
    assert load_sharing_ratio(pair) == pytest.approx(math.cos(pair.base_helix_angle) / profile, rel=1e-6)


def test_helical_gears_share_and_carry_more():
    wide, spur = helical(25.0), HobbedPair((21, 55))
    assert load_sharing_ratio(wide) < 0.75
    assert pitting_geometry_factor(wide) > 1.3 * pitting_geometry_factor(spur)
    assert bending_geometry(wide, 0).factor > bending_geometry(spur, 0).factor


def test_a_load_at_the_tip_bends_more():
    high, tip = (bending_geometry(HobbedPair((26, 55)), 0, place) for place in LoadPlace)
    assert tip.factor < high.factor
    assert tip.height > high.height


def test_a_long_addendum_pinion_is_stronger():
    """x = ±0.25: J of the pinion rises, that of the gear falls (AGMA 908, tables for 25 % long addenda)."""
    plain, long = HobbedPair((21, 55)), HobbedPair((21, 55), profile_shifts=(0.25, -0.25))
    assert bending_geometry(long, 0).factor > bending_geometry(plain, 0).factor + 0.03
    assert bending_geometry(long, 1).factor < bending_geometry(plain, 1).factor


def test_stress_correction_of_dolan_and_broghamer():
    """At 20°: H = 0.1788, L = 0.1523, M = 0.4512; with both ratios 1 it is 1 + H."""
    assert stress_correction(math.radians(20.0), 1.0, 1.0) == pytest.approx(1.1788, abs=1e-4)
    assert stress_correction(math.radians(20.0), 4.0, 2.0) == pytest.approx(
        0.1788 + 4.0**0.1523 * 2.0**0.4512, abs=1e-3
    )


def test_the_dynamic_factor_is_one_at_rest_and_falls_with_accuracy():
    assert dynamic_factor_agma(0.0, 8.0) == 1.0
    factors = [dynamic_factor_agma(20.0, quality) for quality in (6.0, 8.0, 10.0, 11.0)]
    assert factors == sorted(factors, reverse=True)


def test_load_distribution_joins_its_regimes():
    """C_pf is continuous at 1 in and, by the standard's digits, within 3e-3 at 17 in."""
    inch = 0.0254
    for joint, step in ((1.0, 1e-9), (17.0, 3e-3)):
        below, above = (load_distribution_factor(joint * f * inch, 10 * inch) for f in (1 - 1e-9, 1 + 1e-9))
        assert below == pytest.approx(above, abs=step)
    open_gears, precise = (
        load_distribution_factor(0.05, 0.1, mounting=each) for each in (OPEN_GEARING, EXTRA_PRECISION)
    )
    assert open_gears > precise > 1.0


@pytest.mark.parametrize("curve", [BENDING_CARBURISED, PITTING])
def test_cycle_factors_join_and_fall(curve):
    """The fitted branches meet where they cross."""
    below, above = life_factor(curve, curve.cycles[1] * np.array([1.0 - 1e-9, 1.0 + 1e-9]))
    assert below == pytest.approx(above, rel=1e-9)
    assert life_factor(curve, 1e4) > life_factor(curve, 1e6) > life_factor(curve, 1e9)


@pytest.mark.parametrize(
    ("reliability", "factor"), [(0.5, 0.70), (0.9, 0.85), (0.99, 1.0), (0.999, 1.25), (0.9999, 1.5)]
)
def test_reliability_factors_of_the_table(reliability, factor):
    """AGMA 2001-D04, table 11; exact at its rows."""
    assert reliability_factor(reliability) == pytest.approx(factor, rel=1e-9)


def test_hardness_ratio_counts_from_a_fifth_harder():
    assert hardness_ratio_factor(220.0, 200.0, 4.0) == 1.0
    assert hardness_ratio_factor(400.0, 200.0, 4.0) == pytest.approx(1.0 + 0.00698 * 3.0)


def test_stresses_scale_with_load_and_strength_with_reliability():
    """s_t ∝ W_t, s_c ∝ √W_t; limits ∝ 1/K_R; exact."""
    gear = AgmaGear(0.34, AgmaStrength(400e6, 1400e6))
    mesh = AgmaMesh(0.03, 0.003, 0.063, pitting_factor=0.1, elastic_coefficient=190e3)
    one, four = (agma_rating(AgmaLoad(force), gear, mesh) for force in (1e3, 4e3))
    assert four.bending_stress == pytest.approx(4.0 * one.bending_stress, rel=1e-12)
    assert four.contact_stress == pytest.approx(2.0 * one.contact_stress, rel=1e-12)
    reliable = agma_rating(AgmaLoad(1e3), gear, mesh, reliability=1.25)
    assert reliable.bending_safety == pytest.approx(one.bending_safety / 1.25, rel=1e-12)
    assert elastic_coefficient((206e9, 206e9), (0.3, 0.3)) == pytest.approx(189811.7, rel=1e-6)


def test_rims_thinner_than_a_fifth_over_the_tooth_weaken_it():
    assert rim_factor_agma(1.2) == pytest.approx(1.0, abs=1e-3)
    assert rim_factor_agma(0.8) > 1.6


def test_unknown_grades_and_hardness_are_refused():
    with pytest.raises(DesignError, match="through-hardened steel has grades 1 to 2"):
        agma_strength(AgmaSteel.THROUGH_HARDENED, 3, 300.0)
    with pytest.raises(DesignError, match="covers 180 to 400 HB"):
        agma_strength(AgmaSteel.THROUGH_HARDENED, 1, 150.0)
    assert agma_strength(AgmaSteel.CARBURISED, 2).contact == pytest.approx(225e3 * 6894.757, rel=1e-6)
