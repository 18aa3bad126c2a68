"""Scuffing by ISO/TS 6336-20 and -21, factor by factor and then as a whole, written out once more in N, mm and µm."""

import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.parts.iso6336 import MeshGeometry
from gearwright.parts.scuffing import (
    AUSTENITIC,
    CASE_HARDENED_USUAL,
    COPPER_PLATED,
    DIP,
    MINERAL,
    NITRIDED,
    NON_WATER_POLYGLYCOL,
    PHOSPHATE_ESTER,
    PHOSPHATED,
    POLYALPHAOLEFIN,
    SPRAY,
    SUBMERGED,
    WATER_POLYGLYCOL,
    FlashEdition,
    Oil,
    ScuffingMesh,
    approach_factor,
    contact_ratio_factor_integral,
    flash_temperature,
    friction_coefficient,
    friction_coefficient_integral,
    integral_temperature,
    load_sharing,
    lubricant_factor_scuffing,
    scuffing_integral_temperature,
    thermo_elastic_factor,
    tip_relief_factor,
)

ANGLE = math.radians(20.0)
SPUR = MeshGeometry((23, 71), 3e-3, 24e-3, 142.1e-3, (38.2e-3, 109.6e-3))
NARROW = MeshGeometry((23, 71), 3e-3, 10e-3, 146.1e-3, (39.1e-3, 113.2e-3), math.radians(14.0))
HELICAL = MeshGeometry((23, 71), 3e-3, 30e-3, 146.1e-3, (39.1e-3, 113.2e-3), math.radians(14.0))
WIDE = MeshGeometry((23, 71), 3e-3, 85e-3, 146.1e-3, (39.1e-3, 113.2e-3), math.radians(14.0))
OIL = Oil(90.0, 11e-3, 9.0, 0.8, SPRAY, 150e-6)


def mesh_of(pair, **values):
    given = {
        "specific_load": 3e5, "nominal_load": 2e5, "speed": 17.0, "roughness": 0.6e-6, "stiffness": (13e9, 19e9),
        "reliefs": (6e-6, 4e-6), "grade": 5, "elastic_modulus": 210e9, "poisson_ratio": 0.28, "structure": 1.25,
    }  # fmt: skip
    return ScuffingMesh(pair, **(given | values))


def near(value):
    return pytest.approx(value, rel=1e-9, abs=0.0)


def radii(pair, place):
    """ρ_1, ρ_2 and ρ_rel in the transverse section [mm], at Γ."""
    reach, u = pair.centre_distance * 1e3 * math.sin(pair.working_angle), 71.0 / 23.0
    first, second = (1.0 + place) / (1.0 + u) * reach, (u - place) / (1.0 + u) * reach
    return first, second, first * second / (first + second)


def ends(pair):
    """Γ at A, B, D and E (ISO/TS 6336-20, eqs 30 to 35)."""
    tangent, u = math.tan(pair.working_angle), 71.0 / 23.0
    start, end = -u * (pair.tip_tangents[1] / tangent - 1.0), pair.tip_tangents[0] / tangent - 1.0
    pitch = 2.0 * math.pi / (23.0 * tangent)
    return start, end - pitch, start + pitch, end


def test_the_printed_constants_of_oil_and_steel():
    """ISO/TS 6336-20: X_S by eq. 22, X_W by table 2, the oils of eq. 27; and X_L = kind · η^−0.05 in mPa s."""
    assert (SPRAY, DIP, SUBMERGED) == (1.2, 1.0, 0.2)
    assert (AUSTENITIC, CASE_HARDENED_USUAL, PHOSPHATED, COPPER_PLATED, NITRIDED) == (0.85, 1.0, 1.25, 1.5, 1.5)
    oils = (MINERAL, POLYALPHAOLEFIN, NON_WATER_POLYGLYCOL, WATER_POLYGLYCOL, PHOSPHATE_ESTER)
    assert oils == (1.0, 0.8, 0.7, 0.6, 1.3)
    for kind in oils:
        assert lubricant_factor_scuffing(replace(OIL, kind=kind)) == near(kind * 11.0**-0.05)
    usual = Oil(90.0, 11e-3, 9.0)
    assert (usual.kind, usual.supply, usual.viscosity_40) == (1.0, 1.0, 100e-6)
    assert thermo_elastic_factor(210e9, 0.28) == near(1000.0 / 435.0 * (210e3 / (1.0 - 0.28**2)) ** 0.25)
    plain = ScuffingMesh(SPUR, 3e5, 2e5, 17.0, 0.6e-6)
    assert (plain.stiffness, plain.reliefs, plain.grade, plain.structure) == ((14e9, 20e9), (0.0, 0.0), 6, 1.0)
    assert (plain.elastic_modulus, plain.poisson_ratio) == (206e9, 0.3)
    assert flash_temperature(plain, usual).thermo_elastic == near(thermo_elastic_factor(206e9, 0.3))


@pytest.mark.parametrize("speed", [17.0, 80.0])
@pytest.mark.parametrize("pair", [SPUR, HELICAL])
def test_friction_of_the_flash_temperature(pair, speed):
    """Eqs 25 to 28: 0.060 (w_Bt/(v_ΣC ρ_relC))^0.2 X_L R_a^¼, v up to 50 m/s."""
    rolling = 2.0 * min(speed, 50.0) * math.sin(pair.working_angle)
    expected = 0.060 * (300.0 / (rolling * radii(pair, 0.0)[2])) ** 0.2 * 0.8 * 11.0**-0.05 * 0.6**0.25
    assert friction_coefficient(mesh_of(pair, speed=speed), OIL) == near(expected)
    former = friction_coefficient(mesh_of(pair, speed=speed), OIL, FlashEdition.TR2000)
    assert former == near(expected * 0.6**0.25)
    assert flash_temperature(mesh_of(pair, speed=speed), OIL, FlashEdition.TR2000).friction == near(former)


def test_the_approach_factor_counts_missing_relief_before_the_pitch_point():
    """Eqs 45 and 46: C_eff = K_A K_γ F_t/(b cos α_t c_γ); (−Γ/(Γ_E − Γ_A))³ over 50 µm."""
    place = np.array([-0.6, -0.3, 0.0, 0.5])
    needed = 200.0 / math.cos(HELICAL.transverse_angle) / 19.0 * 1e-6 * 1e0
    expected = [1.0 + (needed - 4e-6) / 50e-6 * (max(-g, 0.0) / 1.1) ** 3 for g in place]
    assert approach_factor(mesh_of(HELICAL), place) == pytest.approx(expected)
    assert approach_factor(mesh_of(HELICAL, reliefs=(0.0, 40e-6)), place).tolist() == [1.0] * 4


@pytest.mark.parametrize("grade", [5, 7, 9])
def test_pairs_share_their_load_by_accuracy(grade):
    """Eqs 57 to 60: (Q − 2)/15 + 1/3 of the way from A to B, all of it from B to D, and back; Q at least 7."""
    a, b, d, e = ends(SPUR)
    base = (max(grade, 7) - 2.0) / 15.0
    place = np.array([a - 0.1, a, a + 0.4 * (b - a), b - 1e-9, b + 1e-9, 0.0, d - 1e-9, d + 0.3 * (e - d), e, e + 0.2])
    share = load_sharing(mesh_of(SPUR, grade=grade), place)
    expected = [0.0, base, base + 0.4 / 3.0, base + 1.0 / 3.0, 1.0, 1.0, 1.0, base + 0.7 / 3.0, base, 0.0]
    assert share[1:-1] == pytest.approx(expected[1:-1], abs=1e-6)


def test_helical_teeth_share_over_all_pairs_and_stiffen_at_their_ends():
    """Eq. 76: 1/ε_α for ε_γ > 2; eqs 49 to 56: X_but falls from 1 + 0.3 ε_β, at most 1.3, over 0.2 sin β_b."""
    for pair, peak in ((WIDE, 0.3), (HELICAL, 0.3 * HELICAL.overlap_ratio)):
        a, _, _, e = ends(pair)
        width = 0.2 * math.sin(pair.base_helix_angle)
        place = np.array([a, a + 0.25 * width, a + 2.0 * width, e - 0.5 * width, e])
        even = 1.0 / pair.transverse_contact_ratio
        expected = [even * (1.0 + peak * part) for part in (1.0, 0.75, 0.0, 0.5, 1.0)]
        assert pair.total_contact_ratio > 2.0
        assert load_sharing(mesh_of(pair), place) == pytest.approx(expected)
    assert NARROW.total_contact_ratio < 2.0
    a, b, d, e = ends(NARROW)
    shared = load_sharing(mesh_of(NARROW), np.array([a, 0.5 * (b + d)]))
    assert shared == pytest.approx([(1.0 + 0.3 * NARROW.overlap_ratio) / 3.0, 1.0])


@pytest.mark.parametrize("pair", [SPUR, HELICAL])
def test_the_flash_temperature_is_that_of_equation_5(pair):
    """2.52 μ X_M/50 X_J (X_Γ w_Bt)^¾ √(n_1/60) |√ρ_1 − √(ρ_2/u)|/ρ_rel^¼; ϑ_M and ϑ_S by eqs 22 and 99."""
    mesh = mesh_of(pair)
    made = flash_temperature(mesh, OIL)
    place, u = made.place, 71.0 / 23.0
    assert (place[0], place[-1], len(place)) == (near(ends(pair)[0]), near(ends(pair)[3]), 401)
    turns = 17.0 / (math.pi * pair.pitch_diameters[0])
    share, shock = load_sharing(mesh, place), approach_factor(mesh, place)
    for i in (0, 57, 200, 333, 400):
        first, second, relative = radii(pair, place[i])
        flash = 2.52 * friction_coefficient(mesh, OIL) * made.thermo_elastic / 50.0 * shock[i]
        flash *= (share[i] * 300.0) ** 0.75 * math.sqrt(turns)
        flash *= abs(math.sqrt(first) - math.sqrt(second / u)) / relative**0.25
        assert made.flash[i] == near(flash)
    mean = np.trapezoid(made.flash, place) / (place[-1] - place[0])
    assert made.bulk == near(90.0 + 0.47 * 1.2 * mean)
    assert made.contact == near(made.bulk + made.flash.max())
    limit = 80.0 + (0.85 + 1.4 * 1.25) * 0.8 * 11.0**-0.05 * 81.0
    assert made.scuffing == near(limit)
    assert made.safety == near((limit - 90.0) / (made.contact - 90.0))
    assert made.margin == near(limit - made.contact)


@pytest.mark.parametrize(("mates", "factor"), [(1.0, 1.0), (2.0, 1.5), (3.0, 2.0), (5.0, 3.0)])
def test_a_sun_is_heated_by_all_its_planets(mates, factor):
    """X_mp = (1 + n_p)/2 of ISO/TR 13989-1:2000 in the bulk temperature alone; of flashes there are as hot ones."""
    alone, among = flash_temperature(mesh_of(SPUR), OIL), flash_temperature(mesh_of(SPUR, mates=mates), OIL)
    assert among.flash == pytest.approx(alone.flash)
    assert among.bulk - 90.0 == near(factor * (alone.bulk - 90.0))
    assert among.contact == near(among.bulk + alone.flash.max())
    one, all_of_them = integral_temperature(mesh_of(SPUR), OIL), integral_temperature(mesh_of(SPUR, mates=mates), OIL)
    assert all_of_them.flash_mean == near(one.flash_mean)
    assert all_of_them.integral == near(90.0 + (0.7 * 1.2 * factor + 1.5) * one.flash_mean)


def k_b(total):
    """K_Bγ, ISO/TS 6336-21, eq. 5."""
    return 1.0 if total <= 2.0 else 1.3 if total >= 3.5 else 1.0 + 0.2 * math.sqrt((total - 2.0) * (5.0 - total))


@pytest.mark.parametrize("pair", [SPUR, HELICAL, WIDE])
@pytest.mark.parametrize(("speed", "load"), [(17.0, 3e5), (80.0, 1e5)])
def test_friction_of_the_integral_temperature(pair, speed, load):
    """Eqs 1 to 7: 0.045 (w_Bt K_Bγ/(v_ΣC ρ_redC))^0.2 η^−0.05 · 2.2 (R_a/ρ_redC)^¼ X_L; at least 150 N/mm."""
    rho = pair.relative_curvature * 1e3 / math.cos(pair.base_helix_angle)
    rolling = 2.0 * min(speed, 50.0) * math.tan(pair.working_angle) * math.cos(pair.transverse_angle)
    expected = 0.045 * (max(load * 1e-3, 150.0) * k_b(pair.total_contact_ratio) / (rolling * rho)) ** 0.2
    expected *= 11.0**-0.05 * 2.2 * (0.6 / rho) ** 0.25 * 0.8
    made = friction_coefficient_integral(mesh_of(pair, speed=speed, specific_load=load), OIL)
    assert made == near(expected)


def test_these_pairs_reach_every_range_of_the_helical_factor():
    totals = [pair.total_contact_ratio for pair in (SPUR, HELICAL, WIDE)]
    assert totals[0] < 2.0 < totals[1] < 3.5 < totals[2]


@pytest.mark.parametrize(("first", "second", "value"), [
    (0.5, 0.3, 0.25 + 0.09),
    (0.6, 0.5, 0.70 * 0.61 - 0.22 * 1.1 + 0.52 - 0.60 * 0.3),
    (0.8, 0.6, 0.70 * (0.64 + 0.36) - 0.22 * 1.4 + 0.52 - 0.60 * 0.48),
    (1.2, 0.5, 0.18 * 1.44 + 0.70 * 0.25 + 0.82 * 1.2 - 0.52 * 0.5 - 0.30 * 0.6),
    (0.5, 1.2, 0.18 * 1.44 + 0.70 * 0.25 + 0.82 * 1.2 - 0.52 * 0.5 - 0.30 * 0.6),
    (1.4, 0.8, 0.44 * 1.96 + 0.59 * 0.64 + 0.30 * 1.4 - 0.30 * 0.8 - 0.15 * 1.12),
    (0.8, 1.4, 0.44 * 1.96 + 0.59 * 0.64 + 0.30 * 1.4 - 0.30 * 0.8 - 0.15 * 1.12),
])  # fmt: skip
def test_the_contact_ratio_factor_has_the_printed_coefficients(first, second, value):
    """Eqs 39 to 44, each over 2 ε_α ε_1."""
    assert contact_ratio_factor_integral(first, second) == near(value / (2.0 * (first + second) * first))


@pytest.mark.parametrize(("pair", "stiffness"), [(SPUR, 13e9), (HELICAL, 19e9)])
@pytest.mark.parametrize("reliefs", [(6e-6, 4e-6), (40e-6, 40e-6)])
def test_tip_relief_helps_the_longer_addendum(pair, stiffness, reliefs):
    """Eqs 32 to 38: 1 + (0.06 + 0.18 r) ε_max + (0.02 + 0.69 r) ε_max², r = C_a/C_eff up to 1; c′ for spur."""
    first, second = pair.addendum_contact_ratios
    chosen = reliefs[0] if first > 1.5 * second else reliefs[1]
    part, longest = min(chosen * stiffness / 2e5, 1.0), max(first, second)
    expected = 1.0 + (0.06 + 0.18 * part) * longest + (0.02 + 0.69 * part) * longest**2
    assert tip_relief_factor(mesh_of(pair, reliefs=reliefs)) == near(expected)
    assert tip_relief_factor(mesh_of(pair, reliefs=reliefs, grade=6)) == near(expected)
    assert tip_relief_factor(mesh_of(pair, reliefs=reliefs, grade=7)) == 1.0


LONG = MeshGeometry((23, 71), 3e-3, 24e-3, 142.1e-3, (38.9e-3, 108.2e-3))
SHORT = MeshGeometry((23, 71), 3e-3, 24e-3, 142.1e-3, (36.6e-3, 110.6e-3))


def test_the_pinions_relief_counts_where_its_addendum_is_half_as_long_again():
    first, second = LONG.addendum_contact_ratios
    assert first > 1.5 * second
    part, mesh = 6e-6 * 13e9 / 2e5, mesh_of(LONG)
    assert tip_relief_factor(mesh) == near(1.0 + (0.06 + 0.18 * part) * first + (0.02 + 0.69 * part) * first**2)


def test_the_oils_test_gives_the_scuffing_temperature():
    """Eqs 94 to 97: 80 + 0.23 T X_L + X_W 0.3 T (100/ν_40)^0.02 X_L, T = 3.726 S²."""
    torque = 3.726 * 81.0
    expected = 80.0 + 0.23 * torque * 0.8 + 1.25 * 1.5 * 0.2 * torque * (100.0 / 150.0) ** 0.02 * 0.8
    assert scuffing_integral_temperature(OIL, 1.25) == near(expected)
    told = scuffing_integral_temperature(replace(OIL, test_torque=0.9 * torque), 1.25)
    assert told == near(80.0 + 0.9 * (expected - 80.0))


@pytest.mark.parametrize("pair", [SPUR, HELICAL, WIDE, SHORT])
def test_the_integral_temperature_is_that_of_clause_5(pair):
    """ϑ_flaE = μ X_M X_BE X_αβ (K_Bγ w_Bt)^¾ √v/a^¼/(X_Q X_Ca); ϑ_int = ϑ_oil + 0.7 X_S ϑ + 1.5 ϑ."""
    mesh, u, a = mesh_of(pair), 71.0 / 23.0, pair.centre_distance * 1e3
    made = integral_temperature(mesh, OIL)
    x_m = math.sqrt(1000.0) * (210e3 / (1.0 - 0.28**2)) ** 0.25 / math.sqrt(50.0 * 3.8)
    rho_1 = 0.5 * pair.base_diameters[0] * 1e3 * pair.tip_tangents[0]
    rho_2 = a * math.sin(pair.working_angle) - rho_1
    x_be = 0.51 * math.sqrt(u + 1.0) * (math.sqrt(rho_1) - math.sqrt(rho_2 / u)) / (rho_1 * rho_2) ** 0.25
    first, second = pair.addendum_contact_ratios
    x_q = min(max(1.40 - 4.0 / 15.0 * second / first, 0.6), 1.0)
    alpha_wt, alpha_t = pair.working_angle, pair.transverse_angle
    x_ab = 1.22 * (math.sin(alpha_wt) * math.cos(ANGLE) * math.cos(pair.helix_angle)) ** 0.25
    x_ab /= math.sqrt(math.cos(alpha_wt) * math.cos(alpha_t))
    x_ca, x_e = tip_relief_factor(mesh), contact_ratio_factor_integral(first, second)
    friction = friction_coefficient_integral(mesh, OIL)
    flash = friction * x_m * x_be * x_ab * (k_b(pair.total_contact_ratio) * 300.0) ** 0.75
    flash *= math.sqrt(17.0) / a**0.25 / (x_q * x_ca) * x_e
    assert (made.friction, made.thermal_flash, made.geometry) == (near(friction), near(x_m), near(x_be))
    assert (made.approach, made.tip_relief, made.contact_ratio) == (near(x_q), near(x_ca), near(x_e))
    assert made.flash_mean == near(flash)
    assert made.integral == near(90.0 + 0.7 * 1.2 * flash + 1.5 * flash)
    assert made.scuffing == near(scuffing_integral_temperature(OIL, 1.25))
    assert made.safety == near(made.scuffing / made.integral)


def test_the_approach_factor_of_a_short_pinion_is_below_one():
    """Eqs 25 to 29: between 1.5 and 3 of ε_2/ε_1."""
    first, second = SHORT.addendum_contact_ratios
    assert 1.5 < second / first < 3.0
