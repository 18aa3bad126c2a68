"""Static strength of roots and flanks, K_V by method C, load at the tip: by hand from the standard's formulas."""

import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.parts.iso6336 import (
    Choices,
    Edition,
    GearSteel,
    MeshDuty,
    MeshGeometry,
    MeshQuality,
    RatingMethod,
    Treatment,
    contact_ratio_factor_root,
    dynamic_factor_by_speed,
    rate_mesh,
    rim_factor,
    root_section,
    static_notch_sensitivity,
    static_strength,
    static_work_hardening,
    tip_loaded,
)

CASE = GearSteel("Eh", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6, yield_strength=850e6)
TEMPERED = GearSteel("V", Treatment.THROUGH_HARDENED, "MQ", 250.0, 700e6, 290e6, yield_strength=600e6)
SPUR = MeshGeometry((20.0, 60.0), 4e-3, 40e-3, 160e-3, (44e-3, 124e-3))
SLANT = math.radians(15.0)
HELICAL = replace(
    SPUR,
    helix_angle=SLANT,
    centre_distance=160e-3 / math.cos(SLANT),
    tip_radii=(4e-3 + 40e-3 / math.cos(SLANT), 4e-3 + 120e-3 / math.cos(SLANT)),
)
DUTY = MeshDuty(300.0, 10.0, 60.0)


@pytest.mark.parametrize(
    ("treatment", "yield_strength", "expected"),
    [
        (Treatment.CASE_HARDENED, 850e6, 0.44 * 2.4 + 0.12),
        (Treatment.INDUCTION_HARDENED, 600e6, 0.44 * 2.4 + 0.12),
        (Treatment.NITRIDED, 850e6, 0.20 * 2.4 + 0.60),
        (Treatment.NITROCARBURISED, None, 0.20 * 2.4 + 0.60),
        (Treatment.THROUGH_HARDENED, 600e6, (1.0 + 0.82 * 1.4 * 0.5**0.25) / (1.0 + 0.82 * 0.5**0.25)),
        (Treatment.STRUCTURAL, 320e6, (1.0 + 0.93 * 1.4 * 0.625**0.25) / (1.0 + 0.93 * 0.625**0.25)),
    ],
)
def test_static_notch_sensitivity_of_every_material(treatment, yield_strength, expected):
    """ISO 6336-3:2006, clause 12.3, at Y_S = 2.4."""
    steel = replace(CASE, treatment=treatment, yield_strength=yield_strength)
    assert float(static_notch_sensitivity(2.4, steel)) == pytest.approx(expected, rel=1e-14)


def test_the_soft_steels_line_is_the_test_gears_of_about_y_s_2_when_it_yields_late():
    """A notch of none, Y_S = 1, leaves 1/(1 + k s); a sharper one bears more nominal stress, in every material."""
    for steel in (CASE, TEMPERED, replace(CASE, treatment=Treatment.NITRIDED)):
        values = [float(static_notch_sensitivity(notch, steel)) for notch in (1.2, 1.6, 2.0, 2.8)]
        assert values == sorted(values)
        assert 0.6 < values[0] < values[-1] < 1.6


def test_static_work_hardening_is_held_between_130_and_470_brinell():
    """1.05 − (HB − 130)/680 of a soft gear against a hard mate, never below 1; ISO 6336-2:2006, clause 13."""
    soft = [static_work_hardening(replace(TEMPERED, hardness=hardness), CASE) for hardness in (100.0, 160.0, 300.0)]
    assert soft[0] == pytest.approx(1.05)
    assert soft[1] == pytest.approx(1.05 - (0.95 * 160.0 - 130.0) / 680.0, rel=1e-12)
    assert soft[2] == 1.0
    assert static_work_hardening(TEMPERED, TEMPERED) == static_work_hardening(CASE, CASE) == 1.0


def test_static_limits_are_strength_times_life_and_notch_factor():
    """σ_HG = 1500 · 1.6 and σ_FG = 500 · 2 · 2.5 · (0.44 Y_S + 0.12); S_y = R_p0.2 Y_S/σ_F."""
    rated = rate_mesh(SPUR, (CASE, CASE), DUTY)
    found = static_strength(rated.pitting, rated.bending, (CASE, CASE), 0)
    correction = float(rated.bending[0].section.stress_correction)
    assert found.contact_limit == pytest.approx(2400e6)
    assert found.bending_limit == pytest.approx(2500e6 * (0.44 * correction + 0.12))
    assert found.contact_safety == pytest.approx(2400e6 / float(rated.pitting.stresses[0]))
    assert found.bending_safety == pytest.approx(float(found.bending_limit) / float(rated.bending[0].stress))
    assert found.yielding_safety == pytest.approx(850e6 * correction / float(rated.bending[0].stress))
    assert (
        static_strength(rated.pitting, rated.bending, (CASE, replace(CASE, yield_strength=None)), 1).yielding_safety
        is None
    )


def test_dynamic_factor_of_method_c_by_hand():
    """z 20/60, class 6, 200 N/mm, v 5 m/s: x = 5·0.2·3/√10, K_3 = 2.071 − 0.357 x, spur 14.9 and 0.0193."""
    place = 3.0 / math.sqrt(10.0)
    expected = 1.0 + (14.9 / 200.0 + 0.0193) * place * (2.071 - 0.357 * place)
    assert float(dynamic_factor_by_speed(SPUR, 6, specific_load=2e5, speed=5.0).factor) == pytest.approx(expected)
    light = dynamic_factor_by_speed(SPUR, 6, specific_load=2e4, speed=5.0).factor
    assert light == dynamic_factor_by_speed(SPUR, 6, specific_load=1e5, speed=5.0).factor  # 100 N/mm at least


def test_helical_dynamics_of_method_c_run_straight_between_spur_and_an_overlap_of_one():
    narrow, wide = (replace(HELICAL, face_width=width) for width in (1e-9, 400e-3))
    half = replace(HELICAL, face_width=0.5 * math.pi * 4e-3 / math.sin(math.radians(15.0)))
    ends = [float(dynamic_factor_by_speed(each, 7, specific_load=2e5, speed=4.0).factor) for each in (narrow, wide)]
    between = float(dynamic_factor_by_speed(half, 7, specific_load=2e5, speed=4.0).factor)
    assert between == pytest.approx(0.5 * sum(ends), rel=1e-6)
    assert ends[1] < between < ends[0]


def test_load_at_the_tip_takes_the_tip_circle_and_y_epsilon():
    """Method C: σ_F0 = F_t/(b m_n) Y_Fa Y_Sa Y_ε Y_β, Y_ε = 0.25 + 0.75/ε_αn."""
    tip = root_section(tip_loaded(SPUR, 0))
    assert tip_loaded(SPUR, 0).load_diameter == pytest.approx(22.0)
    quality = MeshQuality(choices=Choices(root=RatingMethod.C))
    rated = rate_mesh(SPUR, (CASE, CASE), DUTY, quality=quality)
    root = rated.bending[0]
    load = float(rated.tangential_force) / 40e-3 / 4e-3
    share = 0.25 + 0.75 / float(SPUR.transverse_contact_ratio)
    assert float(contact_ratio_factor_root(SPUR)) == pytest.approx(share)
    assert root.contact_ratio == pytest.approx(share)
    assert root.load_sharing == 1.0
    assert float(root.nominal_stress) == pytest.approx(load * float(tip.form) * float(tip.stress_correction) * share)
    assert float(tip.form) > float(rate_mesh(SPUR, (CASE, CASE), DUTY).bending[0].section.form)


def test_method_c_of_the_root_asks_more_of_spur_teeth_than_method_b():
    """The load at the tip and Y_ε together lie within a third of the load at the outer single contact, above it."""
    for edition in (Edition.ISO2006, Edition.ISO2019):
        stresses = [
            float(rate_mesh(SPUR, (CASE, CASE), DUTY, quality=MeshQuality(choices=Choices(root=method)),
                            edition=edition).bending[0].stress)
            for method in (RatingMethod.B, RatingMethod.C)
        ]  # fmt: skip
        assert 1.0 < stresses[1] / stresses[0] < 4.0 / 3.0


def test_an_array_of_pairs_is_rated_by_both_methods_as_each_alone():
    quality = MeshQuality(choices=Choices(RatingMethod.C, RatingMethod.C))
    many = replace(HELICAL, face_width=np.array([30e-3, 60e-3, 90e-3]))
    together = rate_mesh(many, (CASE, TEMPERED), DUTY, quality=quality)
    for place, width in enumerate((30e-3, 60e-3, 90e-3)):
        alone = rate_mesh(replace(HELICAL, face_width=width), (CASE, TEMPERED), DUTY, quality=quality)
        assert np.asarray(together.bending[1].safety)[place] == pytest.approx(float(alone.bending[1].safety), rel=1e-12)
        assert np.asarray(together.dynamic.factor)[place] == pytest.approx(float(alone.dynamic.factor), rel=1e-12)


def test_thick_rims_count_as_solid_from_the_standards_corner_on():
    """1.2 h_t, and 3.5 m_n of rings; thinner ones by 1.6 ln(2.242 h_t/s_R) and 1.15 ln(8.324 m_n/s_R)."""
    assert rim_factor(1.2 * 9e-3, 9e-3, 4e-3) == 1.0
    assert rim_factor(0.8 * 9e-3, 9e-3, 4e-3) == pytest.approx(1.6 * math.log(2.242 / 0.8))
    assert rim_factor(3.5 * 4e-3, 9e-3, 4e-3, internal=True) == 1.0
    assert rim_factor(2.7 * 4e-3, 9e-3, 4e-3, internal=True) == pytest.approx(1.15 * math.log(8.324 / 2.7))


def test_a_root_knows_its_rim_factor():
    rated = rate_mesh(SPUR, (CASE, CASE), DUTY, quality=MeshQuality(rims=(1.0, 1.5)))
    plain = rate_mesh(SPUR, (CASE, CASE), DUTY)
    assert float(rated.bending[1].stress) == pytest.approx(1.5 * float(plain.bending[1].stress))
    assert float(rated.bending[0].stress) == float(plain.bending[0].stress)
