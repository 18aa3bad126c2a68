"""Joints, losses and planetary sets by the formulas of their sources, written out once more."""

import math
from itertools import pairwise

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.carriers import (
    eye_stress,
    eye_wall,
    hole_pressure,
    pin_diameter,
    pin_mass,
    pin_stress,
    plate_mass,
    plate_shear_stress,
)
from gearwright.parts.gears import CylindricalGear, GearPair, ToothShift
from gearwright.parts.losses import (
    HIGHEST_FRICTION,
    OIL_DENSITY,
    Friction,
    ToothContact,
    bearing_torque_constant,
    bearing_torque_palmgren,
    churning_power,
    cooler_conductance,
    mesh_efficiency,
    mesh_friction,
    ohlendorf_loss_factor,
    oil_flow,
    oil_viscosity,
    tip_contact_ratio,
    tooth_contact,
    tooth_loss_factor,
    windage_power,
)
from gearwright.parts.material import BRINELL_PER_VICKERS, Material, contact_strength, vickers_of_rockwell
from gearwright.parts.planetary import (
    ADDENDUMS,
    assembles,
    even_positions,
    excited_modes,
    most_planets,
    nearest_positions,
    neighbours_clear,
    pin_error_share,
    planet_phases,
    sun_to_ring_phase,
)
from gearwright.parts.shafts import (
    LONGEST_BEARING,
    MODULES,
    SHORTEST_RATIO,
    FitPart,
    KeySection,
    Spline,
    bearing_length,
    fit_interference,
    fit_pressure,
    fit_torque,
    hub_stress,
    key_length,
    key_pressure,
    shaft_fit_stress,
    spline,
    spline_length,
    spline_pressure,
)

PI = math.pi


def near(value):
    return pytest.approx(value, rel=1e-10, abs=0.0)


KEY = KeySection(14e-3, 9e-3, 5.5e-3, 3.8e-3)


@pytest.mark.parametrize(("keys", "bearing"), [(1, 1.0), (2, 1.5)])
def test_keys_bear_on_what_stands_out_of_the_shaft(keys, bearing):
    """DIN 6892, method C: p = 2 T/(d (h − t_1) l_tr i φ), φ = 0.75 for each of two; form A: l_tr = l − b."""
    assert bearing_length(KEY, 70e-3, 72e-3) == near(56e-3)
    made = key_pressure(500.0, 50e-3, KEY, bearing_length=56e-3, keys=keys)
    assert made == near(1000.0 / (50e-3 * 3.5e-3 * 56e-3 * bearing))
    assert key_length(500.0, 50e-3, KEY, allowable=made, keys=keys) == near(56e-3)
    assert key_length(500.0, 50e-3, KEY, allowable=1e8) == near(1000.0 / (50e-3 * 3.5e-3 * 1e8))
    assert key_pressure(1.0, 1.0, KEY, bearing_length=1.0) == near(2.0 / 3.5e-3)
    assert LONGEST_BEARING == 1.3


def test_press_fits_are_lames():
    """U − 0.8 (R_z,i + R_z,a) = p d (c_i/E_i + c_a/E_a); T = π/2 d² l μ p; 2 p/(1 − Q²)."""
    shaft, hub = FitPart(0.3, 206e9, 0.28, 4e-6), FitPart(0.6, 110e9, 0.31, 7e-6)
    widening = ((1.0 + 0.36) / 0.64 + 0.31) / 110e9 + ((1.0 + 0.09) / 0.91 - 0.28) / 206e9
    made = 0.8 * 11e-6 + 90e6 * 50e-3 * widening
    assert fit_interference(90e6, 50e-3, shaft, hub) == near(made)
    assert fit_pressure(made, 50e-3, shaft, hub) == near(90e6)
    assert fit_torque(90e6, 50e-3, 40e-3, friction=0.15) == near(PI / 2.0 * 50e-3**2 * 40e-3 * 0.15 * 90e6)
    assert hub_stress(90e6, hub) == near(180e6 / 0.64)
    assert (shaft_fit_stress(90e6, shaft), shaft_fit_stress(90e6, FitPart(0.0, 206e9))) == (near(180e6 / 0.91), 90e6)
    solid = FitPart(0.0, 206e9)
    assert (solid.poisson_ratio, solid.roughness) == (0.3, 0.0)
    assert fit_interference(1e6, 0.1, solid, solid) == near(1e5 * 2.0 / 206e9)


def test_roots_of_splines_are_those_of_published_shafts():
    """W 6 × 0.8 × 6, broached with 0.55 m: d_f1 = 4.24 mm (a published sheet of DIN 5480); a hob goes 0.05 m deeper.
    W 30 × 1.5 × 18 × 8f, hobbed: d_f1 is 26.49 mm at most (calculator of Ondrives), where A_s − T_eff = −37 µm of DIN
    5480-1 take 37 µm/tan 30° of the nominal."""
    broached = spline(6e-3, 0.8e-3)
    assert broached.teeth == 6
    assert broached.shaft_root == near(4.24e-3 - 2.0 * 0.05 * 0.8e-3)
    hobbed = spline(30e-3, 1.5e-3)
    assert hobbed.teeth == 18
    assert hobbed.shaft_root - 37e-6 / math.tan(PI / 6.0) == pytest.approx(26.49e-3, abs=0.5e-5)


def test_splines_are_those_of_din_5480():
    """DIN 5480, W 120 × 3 × 38: d_a1 = 119.4, d_a2 = 114, x m = 1.35 mm; hobbed d_f1 = 113.1; W 25 × 1.25 × 18."""
    joint = spline(0.120, 3e-3)
    assert (joint.teeth, joint.profile_shift * 3.0) == (38, near(1.35))
    assert (joint.shaft_tip, joint.hub_tip, joint.shaft_root) == (near(0.1194), near(0.114), near(0.1131))
    assert joint.pitch_diameter == near(0.114)
    assert spline(0.025, 1.25e-3).teeth == 18
    assert spline(0.035, 2e-3).teeth == 16
    assert spline(0.0219, 1e-3).teeth == 20
    printed = (0.5, 0.6, 0.75, 0.8, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4, 5, 6, 8, 10)
    assert pytest.approx([millimetres * 1e-3 for millimetres in printed]) == MODULES
    for millimetres in printed:
        assert spline(30.0 * millimetres * 1e-3, millimetres * 1e-3).teeth == 28
    with pytest.raises(DesignError, match="6 are needed"):
        spline(0.0065, 1e-3)
    assert spline(0.007, 1e-3).teeth == 6
    # 22 would need x = −0.06 and 20 needs 0.49 where 21 has −0.01: the odd one is left.
    assert spline(0.02298, 1e-3).teeth == 21
    assert spline(0.02208, 1e-3).teeth == 21


def test_the_shift_of_a_spline_stays_within_its_range():
    """d_B = m (z + 2 x + 1.1), −0.05 ≤ x ≤ 0.45, and the even one of two."""
    for tenths in range(100, 400):
        joint = spline(tenths * 1e-4, 1e-3)
        assert -0.05 - 1e-9 <= joint.profile_shift <= 0.45 + 1e-9
        assert joint.teeth + 2.0 * joint.profile_shift + 1.1 == pytest.approx(tenths / 10.0)
        other = {joint.teeth - 1: joint.profile_shift + 0.5, joint.teeth + 1: joint.profile_shift - 0.5}
        if joint.teeth % 2:
            assert not any(-0.05 <= x <= 0.45 for x in other.values())


def test_flanks_of_a_spline_bear_by_their_heights():
    """p = 2 T/(d_m h l z k), h = 0.9 m, d_m = d_B − 1.1 m, k = 0.75."""
    joint = Spline(0.120, 3e-3, 38, 0.45)
    assert spline_pressure(4000.0, joint, 0.08) == near(8000.0 / (0.1167 * 2.7e-3 * 0.08 * 38.0 * 0.75))
    assert spline_pressure(4000.0, joint, 0.08, share=0.5) == near(8000.0 / (0.1167 * 2.7e-3 * 0.08 * 38.0 * 0.5))
    assert spline_length(4000.0, joint, allowable=60e6) == near(8000.0 / (0.1167 * 2.7e-3 * 60e6 * 38.0 * 0.75))
    assert SHORTEST_RATIO == 0.6


def test_bearings_rub_by_palmgren():
    """0.5 μ P d, μ = 0.0011; 1e-7 f_0 (ν n)^⅔ d³ + f_1 P d in N mm, ν n at least 2000; nothing idle at rest."""
    assert bearing_torque_constant(4000.0, 0.06) == near(0.5 * 0.0011 * 240.0)
    assert bearing_torque_constant(4000.0, 0.06, 0.0015) == near(0.5 * 0.0015 * 240.0)

    def torque(speed):
        return bearing_torque_palmgren(4000.0, 0.06, speed, viscosity=15e-6, oil_factor=2.0, load_factor=4e-4)

    loaded = 1e-3 * 4e-4 * 4000.0 * 60.0
    for rpm, product in ((900.0, 13500.0), (-900.0, 13500.0), (100.0, 2000.0)):
        idle = 1e-7 * 2.0 * product ** (2.0 / 3.0) * 60.0**3
        assert torque(rpm * PI / 30.0) == near(loaded + 1e-3 * idle)
    assert torque(0.0) == near(loaded)


@pytest.mark.parametrize(("teeth", "shift"), [((23, 57), 0.2), ((23, -71), -0.1)])
def test_tooth_loss_is_ohlendorfs(teeth, shift):
    """H_V = π (1/z_1 + 1/z_2)/cos β_b (1 − ε_α + ε_1² + ε_2²); tips of one module, shifts opposite."""
    alpha, beta, m = math.radians(21.0), math.radians(13.0), 3e-3
    alpha_t, beta_b = math.atan(math.tan(alpha) / math.cos(beta)), math.asin(math.sin(beta) * math.cos(alpha))
    ratios = []
    for z, x in zip(teeth, (shift, -shift), strict=True):
        radius = m * z / (2.0 * math.cos(beta))
        tip, base = radius + m * (1.0 + x), radius * math.cos(alpha_t)
        ratios.append(z / (2.0 * PI) * (math.sqrt((tip / base) ** 2 - 1.0) - math.tan(alpha_t)))
        assert tip_contact_ratio(z, abs(tip), abs(base), alpha_t) == near(ratios[-1])
    total = sum(ratios)
    inverse = abs(1.0 / teeth[0] + 1.0 / teeth[1])
    # Past a pitch no pair bears the whole load where the closed form has one: (1 - ε)² counts negative.
    past = 2.0 * sum((ratio - 1.0) ** 2 / 2.0 for ratio in ratios if ratio > 1.0)
    factor = PI * inverse / math.cos(beta_b) * (1.0 - total + ratios[0] ** 2 + ratios[1] ** 2 - past)
    assert tooth_loss_factor(teeth, beta_b, approach=ratios[1], recess=ratios[0]) == near(factor)
    made = tooth_contact(
        teeth, m, pressure_angle=alpha, helix_angle=beta, shifts=(ToothShift(shift), ToothShift(-shift))
    )
    r_1, r_2 = (m * z / (2.0 * math.cos(beta)) for z in teeth)
    curvature = math.sin(alpha_t) / math.cos(beta_b) / (1.0 / r_1 + 1.0 / r_2)
    pitch = PI * m * math.cos(alpha_t) / math.cos(beta)
    assert made == ToothContact(
        near(factor), near(curvature), near(alpha_t), near(beta_b), near(2.0 * min(abs(r_1), abs(r_2))),
        radii=(near(r_1), near(r_2)), path=(near(ratios[1] * pitch), near(ratios[0] * pitch)),
        base_pitch=near(pitch), helix=beta,
    )  # fmt: skip
    assert made.closing == near(abs(1.0 / r_1 + 1.0 / r_2))
    spur = tooth_contact(teeth, m, pressure_angle=alpha)
    assert (spur.base_helix, spur.pressure_angle) == (0.0, near(alpha))
    assert tip_contact_ratio(20.0, 0.01, 0.02, 0.3) == near(-20.0 / (2.0 * PI) * math.tan(0.3))
    assert mesh_efficiency(made, 0.05) == near(1.0 - 0.05 * factor)


def test_friction_is_schlenks():
    """0.048 (F/b/(v_ΣC ρ))^0.2 η^−0.05 R_a^0.25 in N/mm, m/s, mm, mPa s and µm; at most 0.2."""
    contact = ToothContact(0.2, 11e-3, math.radians(23.0), 0.1, 0.08)
    rolling = 2.0 * 14.0 * math.sin(math.radians(23.0))
    expected = 0.048 * (310.0 / (rolling * 11.0)) ** 0.2 * 9.0**-0.05 * 0.7**0.25
    assert mesh_friction(contact, -310e3, -14.0, viscosity=9e-3, roughness=0.7e-6) == near(expected)
    assert mesh_friction(contact, 1e9, 0.01, viscosity=9e-3, roughness=0.7e-6) == HIGHEST_FRICTION == 0.2
    # At rest the sum of the rolling speeds counts as 1 mm/s.
    crept = 0.048 * (1e-3 / (1e-3 * 11.0)) ** 0.2 * 9.0**-0.05 * 0.7**0.25
    assert mesh_friction(contact, 1.0, 0.0, viscosity=9e-3, roughness=0.7e-6) == near(crept)


def test_friction_by_niemann_and_winter_weighs_roughness_against_the_pinion():
    """0.045 and 3.8 (R_a/d_1)^¼ with d_1 in mm, in place of 0.048 and R_a^¼."""
    contact = ToothContact(0.2, 11e-3, math.radians(23.0), 0.1, 0.08)
    oil = {"viscosity": 9e-3, "roughness": 0.7e-6}
    schlenk = mesh_friction(contact, 310e3, 14.0, **oil)
    niemann = mesh_friction(contact, 310e3, 14.0, law=Friction.NIEMANN_WINTER, **oil)
    assert niemann / schlenk == near(0.045 / 0.048 * 3.8 / 80.0**0.25)
    assert mesh_friction(contact, 1e9, 0.01, law=Friction.NIEMANN_WINTER, **oil) == HIGHEST_FRICTION


@pytest.mark.parametrize(
    ("approach", "recess"), [(0.7, 0.8), (-0.2, 1.4), (1.3, -0.1), (0.04, 1.24), (1.1, 1.3), (1.6, 1.7), (1.0, 1.0)]
)
def test_the_loss_factor_is_the_sliding_of_all_points_of_the_path_wherever_the_pitch_point_lies(approach, recess):
    """By 200 000 points of the path, equal shares of the load: the mean of |x| over the number of pairs, twice."""
    place = (np.arange(200_000) + 0.5) / 200_000 * (approach + recess) - approach
    pairs = sum((place + k >= -approach) & (place + k <= recess) for k in range(-4, 5))
    by_points = 2.0 * np.mean(np.abs(place) / pairs) * (approach + recess)
    expected = PI * (1.0 / 16.0 + 1.0 / 24.0) * by_points
    assert tooth_loss_factor((16, 24), 0.0, approach=approach, recess=recess) == pytest.approx(expected, rel=2e-5)


@pytest.mark.parametrize("recess", [1.0, 1.2, 1.7])
def test_the_loss_factor_has_no_step_where_the_pitch_point_leaves_the_path(recess):
    before, after = (tooth_loss_factor((16, 24), 0.0, approach=part, recess=recess) for part in (-1e-9, 1e-9))
    assert before == pytest.approx(after, rel=1e-7)


def test_windage_and_churning_are_those_of_their_reports():
    """NASA TP-1622 in 1/min and mPa s; ISO/TR 14179-1 in mm, mm²/s; β at least 10°, m_t at least 1 mm."""
    rpm = 6000.0
    expected = 2.82e-4 * (1.0 + 2.3 * 40.0 / 120.0) * rpm**2.8 * 0.12**4.6 * (0.028 * 8.0 + 0.019) ** 0.2
    assert windage_power(0.12, 0.04, -rpm * PI / 30.0, viscosity=8e-3) == near(expected)
    for degrees, module in ((18.0, 3.0), (0.0, 3.0), (18.0, 0.6)):
        lean = math.tan(math.radians(max(degrees, 10.0)))
        teeth = (7.93 - 4.648 / max(module, 1.0)) / math.sqrt(lean)
        watts = 1e3 * 0.4 * 20.0 * 1500.0**3 * 180.0**4.7 * (7.37 * 40.0 * teeth + 1.474 * 180.0) / (0.2 * 1e26)
        made = churning_power(
            0.18, 0.04, -1500.0 * PI / 30.0, viscosity=20e-6, dip=0.4, module=module * 1e-3,
            helix_angle=math.radians(degrees),
        )  # fmt: skip
        assert made == near(watts)
    straight = churning_power(0.18, 0.04, 157.0, viscosity=20e-6, dip=0.4, module=3e-3)
    ten = churning_power(0.18, 0.04, 157.0, viscosity=20e-6, dip=0.4, module=3e-3, helix_angle=math.radians(10.0))
    assert straight == near(ten)


def test_oil_carries_heat_and_thins_by_walther():
    """Q = P/(ρ c ΔT), 950 kg/m³ and 2000 J/(kg K); lg lg(ν + 0.7) straight over lg T through 26 and 5 mm²/s."""
    assert oil_flow(9e3, 15.0) == near(9e3 / (950.0 * 2000.0 * 15.0))
    assert oil_flow(9e3, 15.0, density=900.0, heat_capacity=1900.0) == near(9e3 / (900.0 * 1900.0 * 15.0))
    assert OIL_DENSITY == 950.0
    assert cooler_conductance(9e3, 360.0, 320.0) == near(225.0)
    assert (oil_viscosity(313.15), oil_viscosity(373.15)) == (near(26e-6), near(5e-6))
    hot, cold = (math.log10(math.log10(nu + 0.7)) for nu in (5.0, 26.0))
    part = math.log(343.15 / 313.15) / math.log(373.15 / 313.15)
    assert oil_viscosity(343.15) == near((10.0 ** (10.0 ** (cold + part * (hot - cold))) - 0.7) * 1e-6)


def test_planets_assemble_and_stay_clear():
    """(z_s + z_r)/N whole; (z_s + z_p) sin(π/N) > z_p + 2; one planet has no neighbour."""
    assert assembles([20, 21], 70, 3).tolist() == [True, False]
    assert assembles(20, 70, 4).tolist() is False
    assert ADDENDUMS == 2
    assert neighbours_clear([18, 18], [27, 60], 4).tolist() == [True, False]
    assert neighbours_clear([18, 19], 27, 1).tolist() == [True, True]
    for sun, planet in ((18, 27), (40, 15), (60, 12), (12, 60), (24, 24), (100, 20), (21, 6), (10, 50)):
        clear = [n for n in range(2, 60) if (sun + planet) * math.sin(PI / n) > planet + 2]
        assert most_planets(0.5 * (sun + planet), 0.5 * planet + 1.0) == max(clear, default=1)
    # Six planets of 10 teeth about a sun of 14 touch: 24 sin 30° = 12 = 10 + 2.
    assert most_planets(12.0, 6.0) == 5
    assert most_planets(11.0, 11.0) == most_planets(10.5, 11.0) == 1


def test_pins_and_plates_are_cantilevers_and_discs():
    """σ = 32 (F b/2)/(π d³); τ = 2 T/(π d² t)."""
    assert pin_stress(9e3, 30e-3, 25e-3) == near(32.0 * 9e3 * 15e-3 / (PI * 25e-3**3))
    assert pin_stress(9e3, 30e-3, pin_diameter(9e3, 30e-3, 150e6)) == near(150e6)
    assert pin_mass(25e-3, 30e-3, 7800.0) == near(7800.0 * PI * 12.5e-3**2 * 30e-3)
    assert plate_mass(80e-3, 12e-3, 7800.0, fill=0.6) == near(0.6 * 7800.0 * PI * 80e-3**2 * 12e-3)
    assert plate_shear_stress(700.0, 40e-3, 12e-3) == near(700.0 / (PI * 40e-3 * 12e-3 * 20e-3))


def test_an_eye_bears_its_pin_along_two_planes():
    """F = 2 w t τ: 12 kN, 8 mm, 100 MPa need 7.5 mm; a quarter of a solid pin where that is more; p = F/(d t).

    Where the hole bears the most that Tresca allows, p = 2 τ, the metal outside it is as thick as the pin: its edge
    lies 1.5 diameters from the middle.
    """
    assert eye_wall(12e3, 8e-3, 100e6, needed=20e-3) == near(7.5e-3)
    assert eye_wall(12e3, 8e-3, 100e6, needed=40e-3) == near(10e-3)
    assert eye_stress(12e3, 8e-3, 7.5e-3) == near(100e6)
    assert hole_pressure(12e3, 30e-3, 8e-3) == near(50e6)
    pressed = hole_pressure(12e3, 7.5e-3, 8e-3)
    assert pressed == near(200e6) and eye_wall(12e3, 8e-3, pressed / 2.0, needed=0.0) == near(7.5e-3)


@pytest.mark.parametrize(("floating", "free"), [(True, 3.0), (False, 1.0)])
def test_a_pin_out_of_place_loads_its_planet(floating, free):
    """1/N + (N − f)/N · 4 cos² α/(1/k_sp + 1/k_rp) e/F."""
    share = pin_error_share(5, 12e-6, 5e4, stiffness=(4e8, 6e8), pressure_angle=0.4, floating=floating)
    loop = 4.0 * math.cos(0.4) ** 2 * 2.4e8
    assert share == near(0.2 + (5.0 - free) / 5.0 * loop * 12e-6 / 5e4)


def test_positions_and_modes_are_parkers():
    """ψ_n = 2π n/N; l z_s mod N = 0, 1 or N − 1, else."""
    assert even_positions(5) == pytest.approx([2.0 * PI * n / 5.0 for n in range(5)])
    names = [excited_modes(23, 5, harmonic) for harmonic in (1, 2, 3, 4, 5)]
    assert names == ["planet", "translational", "translational", "planet", "rotational"]


def gears(shifts, beta=0.0):
    sun, planet = (CylindricalGear(z, 2e-3, 20e-3, beta, x) for z, x in zip((24, 27), shifts[:2], strict=True))
    ring = CylindricalGear(-78, 2e-3, 20e-3, beta, shifts[2])
    return GearPair(sun, planet), GearPair(planet, ring)


@pytest.mark.parametrize("shifts", [(0.0, 0.0, 0.0), (0.2, 0.1, 0.15), (-0.1, 0.3, 0.35)])
def test_phases_of_a_set_follow_its_teeth(shifts):
    """γ_sn = −z_s ψ/2π, γ_rn = z_r ψ/2π + γ_rs; γ_rs = −z_p (π + inv α_ws + inv α_wr − 2 ψ_b)/2π."""
    sun_mesh, ring_mesh = gears(shifts)
    involutes = [math.tan(a) - a for a in (sun_mesh.working_pressure_angle, ring_mesh.working_pressure_angle)]
    base = (
        (PI + 4.0 * shifts[1] * math.tan(math.radians(20.0))) / 54.0 + math.tan(math.radians(20.0)) - math.radians(20.0)
    )
    shift = -27.0 * (PI + sum(involutes) - 2.0 * base) / (2.0 * PI)
    made = sun_to_ring_phase(sun_mesh, ring_mesh)
    assert math.remainder(made - shift, 1.0) == pytest.approx(0.0, abs=1e-9) and 0.0 <= made < 1.0
    positions = [0.3 + 2.0 * PI * k / 102.0 for k in (0, 25, 52, 77)]
    phases = planet_phases(sun_mesh, ring_mesh, positions)
    for k, sun, ring in zip((0, 25, 52, 77), phases.sun, phases.ring, strict=True):
        assert math.remainder(sun + 24.0 * k / 102.0, 1.0) == pytest.approx(0.0, abs=1e-9)
        assert math.remainder(ring - 78.0 * k / 102.0 - shift, 1.0) == pytest.approx(0.0, abs=1e-9)
        assert 0.0 <= sun < 1.0 and 0.0 <= ring < 1.0
    with pytest.raises(DesignError, match=r"positions\.1: .* whole multiples of 360°/102"):
        planet_phases(sun_mesh, ring_mesh, [0.0, 2.0 * PI * 25.001 / 102.0])


def test_a_phase_of_a_whole_cycle_is_none():
    """Planets that sit at whole teeth of the sun: 24 · 17/102 = 4."""
    sun_mesh, ring_mesh = gears((0.0, 0.0, 0.0))
    for start in (0.0, 0.1, 0.7, 2.3):
        phases = planet_phases(sun_mesh, ring_mesh, [start + 2.0 * PI * k / 6.0 for k in range(6)])
        assert phases.sun == phases.ring == (0.0,) * 6


ISO18265 = {
    240: 20.3, 250: 22.2, 260: 24.0, 270: 25.6, 280: 27.1, 290: 28.5, 300: 29.8, 310: 31.0, 320: 32.2, 330: 33.3,
    340: 34.4, 350: 35.5, 360: 36.6, 370: 37.7, 380: 38.8, 390: 39.8, 400: 40.8, 410: 41.8, 420: 42.7, 430: 43.6,
    440: 44.5, 450: 45.3, 460: 46.1, 470: 46.9, 480: 47.7, 490: 48.4, 500: 49.1, 510: 49.8, 520: 50.5, 530: 51.1,
    540: 51.7, 550: 52.3, 560: 53.0, 570: 53.6, 580: 54.1, 590: 54.7, 600: 55.2, 610: 55.7, 620: 56.3, 630: 56.8,
    640: 57.3, 650: 57.8, 660: 58.3, 670: 58.8, 680: 59.2, 690: 59.7, 700: 60.1, 720: 61.0, 740: 61.8, 760: 62.5,
    780: 63.3, 800: 64.0, 820: 64.7, 840: 65.3, 860: 65.9, 880: 66.4, 900: 67.0, 920: 67.5, 940: 68.0,
}  # fmt: skip
"""ISO 18265:2013, table A.1: HRC over HV."""


def test_rockwell_is_turned_into_vickers_by_the_table():
    """Row by row and half way between; 0.95 HB per HV."""
    for vickers, rockwell in ISO18265.items():
        assert vickers_of_rockwell(rockwell) == near(vickers)
    for (v_1, r_1), (v_2, r_2) in pairwise(ISO18265.items()):
        assert vickers_of_rockwell((r_1 + r_2) / 2.0) == near((v_1 + v_2) / 2.0)
    assert BRINELL_PER_VICKERS == 0.95
    for outside in (20.2, 68.1):
        with pytest.raises(ValueError, match=r"converts 20\.3 to 68"):
            vickers_of_rockwell(outside)


def test_materials_shear_and_bear_by_two_formulas():
    """G = E/(2 (1 + ν)); σ_H0 = 2.5 HB."""
    assert Material("steel", 210e9, 0.27, 7850.0).shear_modulus == near(210e9 / 2.54)
    assert contact_strength(280.0) == near(700e6)


def test_ohlendorfs_formula_leans_with_the_base_helix():
    """π (1/z_1 + 1/z_2)/cos β_b (1 − ε_α + ε_1² + ε_2²), also where the path starts behind the pitch point."""
    for approach, recess in ((0.7, 0.8), (-0.1, 1.4)):
        shape = 1.0 - (approach + recess) + approach**2 + recess**2
        factor = PI * (1.0 / 20.0 + 1.0 / 50.0) / math.cos(0.4) * shape
        assert ohlendorf_loss_factor((20.0, 50.0), 0.4, approach=approach, recess=recess) == near(factor)


@pytest.mark.parametrize("teeth", [(20, 50), (20, -50)])
def test_curvature_at_the_pitch_point_is_that_of_the_working_circles(teeth):
    """ρ = r_w1 r_w2/(r_w1 + r_w2) sin α_wt/cos β_b, with r_w = r cos α_t/cos α_wt."""
    alpha, beta, working = math.radians(20.0), math.radians(15.0), math.radians(24.0)
    made = tooth_contact(teeth, 3e-3, pressure_angle=alpha, helix_angle=beta, working_angle=working)
    transverse = math.atan(math.tan(alpha) / math.cos(beta))
    rolls = [3e-3 * z / (2.0 * math.cos(beta)) * math.cos(transverse) / math.cos(working) for z in teeth]
    base = math.asin(math.sin(beta) * math.cos(alpha))
    assert made.curvature == near(math.sin(working) / math.cos(base) / (1.0 / rolls[0] + 1.0 / rolls[1]))


@pytest.mark.parametrize(("sun", "ring", "planets"), [(27, 99, 4), (25, 86, 3), (30, 83, 5), (20, 61, 6), (24, 72, 4)])
def test_planets_stand_at_the_nearest_places_where_teeth_meet(sun, ring, planets):
    """Whole multiples of 2π/(z_s + z_r), none further than half of that from its equal share of the circle."""
    step = 2.0 * PI / (sun + ring)
    for number, place in enumerate(nearest_positions(sun, ring, planets)):
        assert place / step == near(round(place / step))
        assert abs(place - 2.0 * PI * number / planets) <= 0.5 * step * (1.0 + 1e-9)
