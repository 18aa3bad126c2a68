"""Corners of rating factors that no usual pair reaches: tables class by class, racks of other angles, soft steels."""

import math
from dataclasses import replace

import pytest

from gearwright.parts.agma908 import HobbedPair, bending_geometry
from gearwright.parts.agma2001 import overload_distribution, yield_safety
from gearwright.parts.bevel_geometry import BevelPair, bevel_profile
from gearwright.parts.iso6336 import (
    Choices,
    GearSteel,
    MeshDuty,
    MeshGeometry,
    MeshQuality,
    RatingMethod,
    Treatment,
    bending_life_curve,
    contact_life_curve,
    dynamic_factor_by_speed,
    mesh_springs,
    rate_mesh,
    running_in_allowance,
)

SPUR = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
STEEL = GearSteel("case-hardened", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
K_1 = {3: 2.1, 4: 3.9, 5: 7.5, 6: 14.9, 7: 26.8, 8: 39.1, 9: 52.8, 10: 76.6, 11: 102.6, 12: 146.3}
"""Class -> K_1 of spur gears (ISO 6336-1:2006, clause 6, method C)."""
K_1_HELICAL = {3: 1.9, 4: 3.5, 5: 6.7, 6: 13.3, 7: 23.9, 8: 34.8, 9: 47.0, 10: 68.2, 11: 91.4, 12: 130.3}
"""The same of helical ones."""


@pytest.mark.parametrize("grade", K_1)
def test_k_v_of_method_c_by_every_class(grade):
    """x = v z_1/100 √(u²/(1 + u²)) = 5 · 0.2 · 3/√10; K_3 = 2.071 − 0.357 x; K_V = 1 + (K_1/200 + K_2) x K_3."""
    place = 5.0 * 0.2 * 3.0 / math.sqrt(10.0)
    rise = place * (2.071 - 0.357 * place)
    spur = dynamic_factor_by_speed(SPUR, grade, specific_load=2e5, speed=5.0)
    assert float(spur.factor) == pytest.approx(1.0 + (K_1[grade] / 200.0 + 0.0193) * rise, rel=1e-12)
    wide = replace(SPUR, helix_angle=math.radians(20.0), face_width=0.1)
    assert wide.overlap_ratio > 1.0
    helical = dynamic_factor_by_speed(wide, grade, specific_load=2e5, speed=5.0)
    assert float(helical.factor) == pytest.approx(1.0 + (K_1_HELICAL[grade] / 200.0 + 0.0087) * rise, rel=1e-12)


def test_a_mesh_by_method_c_has_the_k_v_of_its_class_load_and_speed():
    """512.5 N m at 100 rad/s: F_t = 2 T/d_1, v = ω d_1/2, K_A 1.25."""
    duty = MeshDuty(50.0, 100.0, 1e7, application_factor=1.25)
    quality = MeshQuality(grade=7, choices=Choices(RatingMethod.C, RatingMethod.B))
    rated = rate_mesh(SPUR, (STEEL, STEEL), duty, quality=quality)
    alone = dynamic_factor_by_speed(SPUR, 7, specific_load=1.25 * 2.0 * 50.0 / 0.04 / 0.02, speed=100.0 * 0.02)
    assert float(rated.loads.dynamic) == pytest.approx(float(alone.factor), rel=1e-12)


@pytest.mark.parametrize(("treatment", "greatest"), [
    (Treatment.NITROCARBURISED, 1.1), (Treatment.NITRIDED, 1.3), (Treatment.NITRIDED_THROUGH_HARDENED, 1.3),
    (Treatment.CASE_HARDENED, 1.6), (Treatment.INDUCTION_HARDENED, 1.6), (Treatment.STRUCTURAL, 1.6),
    (Treatment.THROUGH_HARDENED, 1.6),
])  # fmt: skip
def test_the_static_corner_of_flanks_by_treatment(treatment, greatest):
    """ISO 6336-2:2019, table 2."""
    curve = contact_life_curve(treatment)
    assert (curve.cycles[0], curve.factors[0]) == (1e5, greatest)
    assert curve.cycles[1] == (2e6 if "N" in treatment.value else 5e7)


@pytest.mark.parametrize(("treatment", "greatest"), [
    (Treatment.NITROCARBURISED, 1.1), (Treatment.NITRIDED, 1.6), (Treatment.NITRIDED_THROUGH_HARDENED, 1.6),
    (Treatment.CASE_HARDENED, 2.5), (Treatment.INDUCTION_HARDENED, 2.5), (Treatment.STRUCTURAL, 2.5),
    (Treatment.THROUGH_HARDENED, 2.5),
])  # fmt: skip
def test_the_static_corner_of_roots_by_treatment(treatment, greatest):
    """ISO 6336-3:2019, table 1."""
    assert bending_life_curve(treatment).factors[0] == greatest


@pytest.mark.parametrize("degrees", [14.5, 20.0, 25.0])
def test_stiffness_falls_by_a_fiftieth_for_every_degree_below_twenty(degrees):
    """C_B = … (1 − 0.02 (20 − α_n)) of ISO 6336-1:2006, clause 9; all else of c′ does not know α_n of spur gears."""
    at_twenty = float(mesh_springs(SPUR).single)
    tilted = float(mesh_springs(replace(SPUR, pressure_angle=math.radians(degrees))).single)
    assert tilted / at_twenty == pytest.approx(1.0 - 0.02 * (20.0 - degrees), rel=1e-12)


def test_a_bevel_profile_in_another_unit_is_the_same_one():
    """Every length times the factor, each end and side at its place."""
    whole = bevel_profile(BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(35.0)), 0)
    scaled = whole.scaled(1e3)
    for name in ("small", "large", "roots"):
        assert getattr(scaled, name) == pytest.approx([1e3 * place for place in getattr(whole, name)], rel=1e-12)
    assert scaled.apex == pytest.approx(1e3 * whole.apex, rel=1e-12)
    assert abs(whole.small[0]) < abs(whole.large[0])


@pytest.mark.parametrize(("speed", "most"), [(5.0, math.inf), (5.1, 12800.0), (10.0, 12800.0), (10.1, 6400.0)])
def test_soft_flanks_run_in_by_their_strength(speed, most):
    """ISO 6336-1:2019, 8.3.6: y_α = 160/σ_Hlim f, at most 12800/σ_Hlim µm up to 10 m/s and 6400/σ_Hlim beyond."""
    soft = GearSteel("through-hardened-alloy", Treatment.THROUGH_HARDENED, "MQ", 300.0, 800e6, 300e6)
    for deviation in (5e-6, 60e-6, 120e-6):
        expected = min(160.0 / 800.0 * deviation, most / 800.0 * 1e-6)
        assert float(running_in_allowance(deviation, soft, speed)) == pytest.approx(expected, rel=1e-12)


def test_yielding_by_agma_2001_by_hand():
    """s_ay K_y J K_f F m_t/(W_max K_my): 771 MPa, 0.75, 20 kN, F 40 mm, m_t 3 mm, K_my = 1.07 + 0.0144 40/25.4."""
    geometry = bending_geometry(HobbedPair((21, 55)), 0)
    spread = 1.07 + 0.0144 * 40.0 / 25.4
    assert float(overload_distribution(0.04)) == pytest.approx(spread, rel=1e-12)
    expected = 771e6 * 0.75 * geometry.factor * geometry.stress_correction * 0.04 * 3e-3 / (20e3 * spread)
    found = yield_safety(20e3, geometry, 771e6, face_width=0.04, module=3e-3, factor=0.75)
    assert float(found) == pytest.approx(float(expected), rel=1e-12)
