"""ISO/TR 6336-30:2017, example 1: a case-hardened helical pair, every quantity that the report lists for pitting.

The reference values are the report's as tabulated by the open program of Rebouças & Nejad (Drivetrain). The report
takes its tolerances from ISO 1328-1:1995 and rounds ε_α, so what hangs on them agrees to 0.05 %, all else to 0.01 %.
"""

import math

import pytest

from gearwright.catalogue import gear_steel
from gearwright.parts.gears import ISO53_D, CylindricalGear, GearPair
from gearwright.parts.iso6336 import (
    MeshDuty,
    MeshQuality,
    Misalignment,
    ToothLoadFactors,
    face_load_factor,
    mesh_geometry,
    pitting_rating,
    rate_pair,
)
from gearwright.parts.stiffness import mesh_stiffness_iso6336
from gearwright.units import RPM

BETA = math.radians(15.8)
PAIR = GearPair(
    CylindricalGear(17, 8e-3, 0.1, helix_angle=BETA, profile_shift=0.145, rack=ISO53_D),
    CylindricalGear(103, 8e-3, 0.1, helix_angle=BETA, rack=ISO53_D),
    0.5,
)
STEEL = gear_steel("case-hardened", "MQ", 700.0)
DUTY = MeshDuty(9000.0, 360.0 * RPM, 50_000 * 3600.0)
QUALITY = MeshQuality(grade=5, flank_roughness=6e-6, tip_relief=70e-6, viscosity=320e-6)
RATED = rate_pair(PAIR, (STEEL, STEEL), DUTY, quality=QUALITY)
PRINTED = ToothLoadFactors(dynamic=1.003, face_contact=1.16)


@pytest.mark.parametrize(
    ("name", "found", "printed", "tolerance"),
    [
        ("F_t", RATED.tangential_force, 127352.0, 1e-4),
        ("v", RATED.speed, 2.664, 1e-4),
        ("z_n1", mesh_geometry(PAIR).virtual_teeth[0], 18.905, 1e-4),
        ("z_n2", mesh_geometry(PAIR).virtual_teeth[1], 114.543, 1e-4),
        ("Z_H", RATED.pitting.geometry.zone, 2.39533, 1e-5),
        ("Z_E", RATED.pitting.geometry.elasticity / 1e3, 189.8117, 1e-6),
        ("Z_eps", RATED.pitting.geometry.contact_ratio, 0.803, 5e-4),
        ("Z_beta", RATED.pitting.geometry.helix, 1.01944, 1e-5),
        ("Z_B", RATED.pitting.geometry.single_contact[0], 1.0, 1e-12),
        ("Z_D", RATED.pitting.geometry.single_contact[1], 1.0, 1e-12),
        ("Z_L", RATED.contact_strength[0].lubricant, 1.04739, 1e-5),
        ("Z_v", RATED.contact_strength[0].speed, 0.96911, 1e-5),
        ("Z_R", RATED.contact_strength[0].roughness, 0.96599, 1e-5),
        ("Z_W", RATED.contact_strength[1].work_hardening, 1.0, 1e-12),
        ("Z_X", RATED.contact_strength[0].size, 1.0, 1e-12),
        ("N_L1", RATED.cycles[0], 1.080e9, 1e-6),
        ("N_L2", RATED.cycles[1], 1.783e8, 3e-4),
        ("Z_NT1", RATED.contact_strength[0].life, 0.910, 1e-4),
        ("Z_NT2", RATED.contact_strength[1].life, 0.962, 3e-4),
        ("sigma_H0", RATED.pitting.nominal_stress / 1e6, 1206.58207, 1e-4),
        ("sigma_HP1", RATED.pitting.permissible[0] / 1e6, 1338.48050, 1e-6),
        ("sigma_HP2", RATED.pitting.permissible[1] / 1e6, 1414.52551, 1e-6),
        ("K_v", RATED.dynamic.factor, 1.003, 5e-4),
        ("K_Halpha", RATED.transverse.contact, 1.0, 1e-12),
        ("K_Falpha", RATED.transverse.bending, 1.0, 1e-12),
    ],
)
def test_every_factor_of_the_iso_example(name, found, printed, tolerance):
    """ISO/TR 6336-30:2017, annex A, example 1; the tolerance is the rounding of the printed digits."""
    assert found == pytest.approx(printed, rel=tolerance), name


def test_stress_and_safety_of_the_iso_example_with_its_load_factors():
    """σ_H 1301.35343, S_H 1.02853 and 1.08696, with the printed K_V 1.003 and K_Hβ 1.16: 1e-4 by the rounded ε_α."""
    rating = pitting_rating(
        mesh_geometry(PAIR), (STEEL, STEEL), RATED.tangential_force, loads=PRINTED, strengths=RATED.contact_strength
    )
    assert rating.stresses[0] / 1e6 == pytest.approx(1301.35343, rel=1e-4)
    assert rating.safeties[0] == pytest.approx(1.02853, rel=1e-4)
    assert rating.safeties[1] == pytest.approx(1.08696, rel=1e-4)


def helix_slope_1995(diameter, width):
    """ISO 1328-1:1995, f_Hβ = 0.07 √d + 0.45 √b + 3 µm at the geometric means of the ranges, rounded to 0.5 µm."""
    return round(2.0 * (0.07 * math.sqrt(diameter) + 0.45 * math.sqrt(width) + 3.0)) / 2.0


def test_face_load_factors_of_the_iso_example_with_the_tolerances_of_its_time():
    """K_Hβ 1.16 and K_Fβ 1.12803; f_Hβ of 8.5 and 9.5 µm from the ranges 125-280, 560-1000 and 80-160 mm.

    K_Hβ is printed with two decimals (0.5 %); K_Fβ = K_Hβ^N_F with five, which fixes K_Hβ to 1e-5.
    """
    slopes = [helix_slope_1995(math.sqrt(low * high), math.sqrt(80 * 160)) for low, high in ((125, 280), (560, 1000))]
    assert slopes == [8.5, 9.5]
    mesh = mesh_geometry(PAIR)
    load = RATED.tangential_force / mesh.face_width * 1.003
    found = face_load_factor(
        mesh,
        Misalignment(RATED.face.deflection, 1e-6 * math.hypot(*slopes)),
        (STEEL, STEEL),
        stiffness=mesh_stiffness_iso6336(PAIR).face,
        specific_load=load,
        speed=RATED.speed,
    )
    assert found.contact == pytest.approx(1.16, rel=1e-3)
    assert found.bending == pytest.approx(1.12803, rel=2e-4)


def test_the_current_tolerances_change_the_face_load_by_less_than_half_a_percent():
    """ISO 1328-1:2013 in place of 1995: f_ma 12.1 µm instead of 12.7 µm."""
    assert RATED.face.contact == pytest.approx(1.16, rel=5e-3)
