"""Factors of ISO 6336 one by one: limits, continuity, monotony, and arrays that equal single calls."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from gearwright.errors import DesignError, SolveError
from gearwright.parts.gears import ISO53_A, ISO53_D, CylindricalGear, GearPair, load_point, tooth_form
from gearwright.parts.iso6336 import (
    CORRECTED_AND_CROWNED,
    Edition,
    GearSteel,
    LoadedTooth,
    MeshDeviations,
    MeshDuty,
    MeshGeometry,
    MeshSprings,
    Misalignment,
    PinionShaft,
    StressBin,
    ToothProportions,
    Treatment,
    bending_life_curve,
    bending_size_factor,
    contact_life_curve,
    contact_ratio_factor_root,
    deep_tooth_factor,
    deflection_misalignment,
    dynamic_factor,
    endurable_cycles,
    face_load_factor,
    helix_factor,
    lead_allowance,
    life_factor,
    load_sharing_factor,
    mesh_geometry,
    mesh_springs,
    notch_sensitivity_factor,
    outer_single_contact,
    rate_mesh,
    rate_pair,
    reduced_mass,
    rim_factor,
    root_section,
    running_in_allowance,
    shaped_fillet_radius,
    single_contact_factors,
    spectrum_damage,
    surface_factor,
    transverse_load_factor,
    work_hardening_factor,
)
from gearwright.parts.stiffness import mesh_stiffness_iso6336

HARD = GearSteel("hard", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 461e6)
SOFT = GearSteel("soft", Treatment.THROUGH_HARDENED, "MQ", 300.0, 760e6, 310e6, yield_strength=700e6)


def pair(first=27, second=107, helix=12.0, shifts=(0.2, 0.1), rack=ISO53_A, module=2.5e-3, width=45e-3):
    beta = math.radians(helix)
    return GearPair(
        CylindricalGear(first, module, width, helix_angle=beta, profile_shift=shifts[0], rack=rack),
        CylindricalGear(second, module, width, helix_angle=beta, profile_shift=shifts[1], rack=rack),
    )


PAIR = pair()
MESH = mesh_geometry(PAIR)


@pytest.mark.parametrize(
    "case", [PAIR, pair(helix=0.0), pair(30, -90, 0.0, (0.3, 0.3)), pair(25, -101, 20.0, (0.2, 0))]
)
def test_contact_ratios_and_angles_are_those_of_the_pair(case):
    """Two independent codes for one geometry: 1e-12."""
    mesh = mesh_geometry(case)
    assert mesh.transverse_contact_ratio == pytest.approx(case.transverse_contact_ratio, rel=1e-12)
    assert mesh.overlap_ratio == pytest.approx(case.overlap_ratio, abs=1e-15)
    assert mesh.working_angle == pytest.approx(case.working_pressure_angle, rel=1e-12)
    assert mesh.tooth_heights[1] == pytest.approx(abs(case.driven.tip_radius - case.driven.root_radius), rel=1e-12)


@pytest.mark.parametrize("teeth", [19, 35, 103])
@pytest.mark.parametrize("helix", [0.0, 15.0])
@pytest.mark.parametrize("rack", [ISO53_A, ISO53_D])
def test_the_critical_section_is_where_the_tooth_leans_thirty_degrees(teeth, helix, rack):
    """ISO 6336-3's closed form beside the traced trochoid of `tooth_form`; 2e-3 for its 200 points on the fillet."""
    gear = CylindricalGear(teeth, 1e-3, 10e-3, helix_angle=math.radians(helix), profile_shift=0.25, rack=rack)
    form = tooth_form(gear)
    lean = np.arctan(-np.gradient(form.half_thickness, form.height))[1:199]
    traced = np.interp(-math.pi / 6.0, -lean, 2.0 * form.half_thickness[1:199])
    mesh = mesh_geometry(GearPair(gear, gear))
    assert root_section(outer_single_contact(mesh, 0)).chord * 1e-3 == pytest.approx(traced, rel=2e-3)


@pytest.mark.parametrize("shift", [0.0, 0.3])
def test_the_critical_section_of_a_ring_leans_sixty_degrees(shift):
    """Internal teeth beside the traced tooth of `tooth_form`, whose fillet is a circle instead of a rack's: 1 %.

    The load angle, which knows no fillet, agrees to rounding.
    """
    ring = CylindricalGear(-90, 1.0, 10.0, profile_shift=shift)
    loaded = outer_single_contact(mesh_geometry(GearPair(CylindricalGear(30, 1.0, 10.0, profile_shift=shift), ring)), 1)
    found, form = root_section(loaded), tooth_form(ring)
    lean = np.arctan(-np.gradient(form.half_thickness, form.height))[1:199][::-1]
    half, height = (np.interp(math.pi / 3.0, lean, each[1:199][::-1]) for each in (form.half_thickness, form.height))
    high, thick, angle = (float(each[0]) for each in load_point(form, np.array([-0.5 * loaded.load_diameter])))
    assert found.load_angle == pytest.approx(angle, rel=1e-9)
    assert found.chord == pytest.approx(2.0 * half, rel=0.01)
    assert found.lever == pytest.approx(high - thick * math.tan(angle) - height, rel=0.01)


def test_a_ring_with_many_teeth_approaches_the_rack_from_the_other_side():
    """External and internal teeth meet in the rack: s_Fn at 30° of z = ±1e6 differ by their tangents only.

    At 60° the section lies deeper, so it is thicker; both tend to their rack values, which 1e5 and 1e6 teeth share.
    """
    tooth = ToothProportions()
    for sign in (1.0, -1.0):
        near, far = (
            root_section(LoadedTooth(sign * z, sign * (z + sign * 2.0), math.radians(20.0), tooth)) for z in (1e5, 1e6)
        )
        assert near.chord == pytest.approx(far.chord, rel=1e-4)
        assert near.form == pytest.approx(far.form, rel=1e-4)
    assert near.chord > root_section(LoadedTooth(1e6, 1e6 + 2.0, math.radians(20.0), tooth)).chord


def test_a_shaper_leaves_a_larger_fillet_than_the_rack():
    tooth = ToothProportions(1.25, 0.25)
    few, many = (shaped_fillet_radius(tooth, teeth) for teeth in (20.0, 80.0))
    assert few > many > 0.25


def test_a_tooth_that_cannot_be_is_refused():
    with pytest.raises(SolveError, match="no tangent point"):
        root_section(LoadedTooth(6.0, 8.0, math.radians(20.0), ToothProportions(3.0, 0.1, -1.0)))


def test_undercut_and_interference_are_refused_with_the_remedy():
    with pytest.raises(DesignError, match=r"x = 0 undercuts 12 teeth; needs 0\.2"):
        mesh_geometry(pair(12, 40, 0.0, (0.0, 0.0)))
    long_teeth = CylindricalGear(150, 2e-3, 20e-3, tip_alteration=0.6)
    with pytest.raises(DesignError, match=r"driven\.tip_radius: tip radius .* interferes"):
        mesh_geometry(GearPair(CylindricalGear(18, 2e-3, 20e-3), long_teeth))


@pytest.mark.parametrize("case", [PAIR, pair(30, -90, 0.0, (0.3, 0.3)), pair(20, 41, 25.0, (0.4, -0.1), ISO53_D)])
@pytest.mark.parametrize("load", [30e3, 400e3])
def test_the_stiffness_over_arrays_is_that_of_one_pair(case, load):
    """`mesh_springs` beside `mesh_stiffness_iso6336`: one formula, written twice; 1e-12."""
    many, one = mesh_springs(mesh_geometry(case), load), mesh_stiffness_iso6336(case, specific_load=min(load, 1e5))
    assert (many.single, many.mesh, many.face) == pytest.approx((one.single, one.mesh, one.face), rel=1e-12)


def test_arrays_rate_as_single_pairs_do():
    """One call for four variants of pinion and torque, factor by factor; equal to rounding, 1e-11."""
    teeth, torques = np.array([21.0, 27.0, 35.0, 52.0]), np.array([200.0, 512.5, 700.0, 40.0])
    cases = [pair(int(z), 107) for z in teeth]
    one = [mesh_geometry(case) for case in cases]
    many = MeshGeometry(
        (teeth, 107.0),
        2.5e-3,
        45e-3,
        np.array([mesh.centre_distance for mesh in one]),
        (np.array([mesh.tip_radii[0] for mesh in one]), one[0].tip_radii[1]),
        MESH.helix_angle,
        MESH.pressure_angle,
        MESH.proportions,
    )
    together = rate_mesh(many, (HARD, HARD), MeshDuty(torques, 628.3, 1.26e7, 1.25))
    alone = [
        rate_pair(case, (HARD, HARD), MeshDuty(float(torque), 628.3, 1.26e7, 1.25))
        for case, torque in zip(cases, torques, strict=True)
    ]
    for value in (
        lambda each: each.loads.dynamic,
        lambda each: each.loads.face_bending,
        lambda each: each.loads.transverse_contact,
        lambda each: each.pitting.safeties[0],
        lambda each: each.pitting.safeties[1],
        lambda each: each.bending[0].safety,
        lambda each: each.bending[1].safety,
        lambda each: each.root_strength[1].notch_sensitivity,
    ):
        np.testing.assert_allclose(value(together), [value(each) for each in alone], rtol=1e-11)


def test_a_duty_without_load_or_life_is_refused():
    with pytest.raises(DesignError, match="pinion_torque: 0 given") as caught:
        MeshDuty(np.array([100.0, 0.0]), 10.0, -1.0)
    assert [each.path for each in caught.value.problems] == ["pinion_torque", "life"]


def kv(ratio, load=4e5, mesh=MESH):
    """K_V at a reference speed N."""
    resonance = math.sqrt(20e9 / 5.0) / 27.0
    found = dynamic_factor(
        mesh,
        MeshSprings(14e9, 20e9, 17e9),
        MeshDeviations(4e-6, 5e-6),
        specific_load=load,
        pinion_speed=np.asarray(ratio) * resonance,
        masses=(5.0,),
    )
    return found.factor


def test_the_dynamic_factor_starts_at_one_and_joins_its_regions():
    """Continuous at N = 1.15 and 1.5 by the interpolation; at rest 1 exactly."""
    assert kv(0.0) == 1.0
    for joint in (1.15, 1.5):
        assert kv(joint - 1e-9) == pytest.approx(kv(joint + 1e-9), rel=1e-6)


def test_light_loads_widen_the_resonance():
    """N_S = 0.5 + 0.35 √(w/100 N/mm) below 100 N/mm: at 25 N/mm it starts at 0.675."""
    assert kv(0.67, 25e3) < kv(0.68, 25e3) - 0.05
    assert kv(0.80) < kv(0.84) < kv(0.86)


def test_heavier_loads_feel_errors_less():
    assert kv(0.5, 8e5) < kv(0.5, 4e5) < kv(0.5, 2e5)


def test_the_reduced_mass_of_equal_solid_discs():
    """Two equal discs: half of π/8 ρ d_m⁴/d_b² each; with a wheel of infinite mass the pinion's alone."""
    same = mesh_geometry(pair(30, 30, 0.0, (0.0, 0.0)))
    single = (
        math.pi / 8.0 * 7830.0 * (2.0 * same.tip_radii[0] - same.tooth_heights[0]) ** 4 / same.base_diameters[0] ** 2
    )
    assert reduced_mass(same, (7830.0, 7830.0)) == pytest.approx(0.5 * single, rel=1e-12)
    assert reduced_mass(same, (7830.0, 1e15)) == pytest.approx(single, rel=1e-9)


@pytest.mark.parametrize(("speed", "limit"), [(3.0, math.inf), (8.0, 12800 / 760), (20.0, 6400 / 760)])
def test_running_in_of_soft_flanks_is_limited_by_speed(speed, limit):
    """ISO 6336-1, 8.3.6: 160/σ_Hlim f, at most 12800 or 6400 over σ_Hlim in µm."""
    found = running_in_allowance(100e-6, SOFT, speed)
    assert found == pytest.approx(1e-6 * min(160.0 / 760.0 * 100.0, limit), rel=1e-12)


def test_running_in_of_hard_flanks_is_small():
    assert running_in_allowance(10e-6, HARD, 10.0) == pytest.approx(0.75e-6)
    assert running_in_allowance(100e-6, HARD, 10.0) == pytest.approx(3e-6)
    assert lead_allowance(100e-6, HARD, 10.0) == pytest.approx(6e-6)


def test_an_overhung_or_offset_pinion_bends_more():
    middle = deflection_misalignment(MESH, 4e5, PinionShaft())
    offset = deflection_misalignment(MESH, 4e5, PinionShaft(0.03, 0.15, 0.06, 0.48))
    assert offset > middle > 0.0
    assert deflection_misalignment(MESH, 4e5, PinionShaft(), paths=3) > middle


def face(misalignment, **choices):
    return face_load_factor(
        MESH, Misalignment(misalignment, 0.0), (HARD, HARD), stiffness=17e9, specific_load=4e5, speed=10.0, **choices
    )


def test_the_face_load_factor_is_continuous_where_contact_leaves_the_face():
    """1 + t and 2√t meet at t = 1 with one slope: a step of 1e-4 in t moves K_Hβ by 1e-4."""
    at_unit = (2.0 * 4e5 / 17e9 + 6e-6) / 1.33
    before, after = face(at_unit * 0.9999).contact, face(at_unit * 1.0001).contact
    assert before == pytest.approx(2.0, abs=2e-4)
    assert after == pytest.approx(before, abs=4e-4)


def test_crowning_and_correction_even_the_load():
    assert face(20e-6, modification=CORRECTED_AND_CROWNED).contact < face(20e-6).contact
    assert 1.0 < face(20e-6).bending < face(20e-6).contact


def test_transverse_factors_stay_between_one_and_one_pair_carrying_all():
    """ISO 6336-1, 8.3: upper limits ε_γ/(ε_α Z_ε²) and ε_γ/(0.25 ε_α + 0.75)."""
    fine, coarse = (
        transverse_load_factor(MESH, error, stiffness=20e9, specific_load=4e5, contact_ratio_factor=0.8)
        for error in (0.0, 1e-3)
    )
    assert (fine.contact, fine.bending) == (1.0, 1.0)
    total, alpha = MESH.total_contact_ratio, MESH.transverse_contact_ratio
    assert coarse.contact == pytest.approx(total / (alpha * 0.64), rel=1e-12)
    assert coarse.bending == pytest.approx(total / (0.25 * alpha + 0.75), rel=1e-12)


@given(st.sampled_from(list(Treatment)), st.floats(1e3, 9e9), st.sampled_from(["contact", "bending"]))
def test_cycles_and_life_factor_are_inverse(treatment, cycles, kind):
    """Where the curve falls; 1e-6 since slopes of 0.01 amplify rounding."""
    curve = contact_life_curve(treatment) if kind == "contact" else bending_life_curve(treatment)
    if cycles > curve.cycles[0]:
        assert endurable_cycles(curve, float(life_factor(curve, cycles))) == pytest.approx(cycles, rel=1e-6)


@pytest.mark.parametrize(
    ("treatment", "cycles", "contact", "bending"),
    [
        (Treatment.CASE_HARDENED, 1e2, 1.6, 2.5),
        (Treatment.CASE_HARDENED, 3e6, (5e7 / 3e6) ** 0.0756, 1.0),
        (Treatment.CASE_HARDENED, 1e10, 0.85, 0.85),
        (Treatment.NITRIDED, 1e2, 1.3, 1.6),
        (Treatment.NITRIDED, 2e6, 1.0, (3e6 / 2e6) ** 0.0587),
        (Treatment.NITROCARBURISED, 1e2, 1.1, 1.1),
        (Treatment.THROUGH_HARDENED, 1e4, 1.6, 2.5),
    ],
)
def test_life_factors_at_the_corners_of_the_tables(treatment, cycles, contact, bending):
    """ISO 6336-2, table 2 and ISO 6336-3, table 1; 2e-4 for exponents printed with three digits."""
    assert life_factor(contact_life_curve(treatment), cycles) == pytest.approx(contact, rel=2e-4)
    assert life_factor(bending_life_curve(treatment), cycles) == pytest.approx(bending, rel=2e-4)


def test_no_damage_below_a_flat_curve_and_no_life_above_the_static_limit():
    flat = contact_life_curve(Treatment.CASE_HARDENED, at_1e10=1.0)
    assert endurable_cycles(flat, 0.99) == math.inf
    assert endurable_cycles(flat, 1.61) == 0.0
    assert contact_life_curve(Treatment.CASE_HARDENED, some_pitting=True).cycles[2] == 1e9


def test_damage_adds_up_and_its_safety_brings_the_sum_to_one():
    """Half the life at each of two levels is a sum of 1, so the safety is 1; 1e-9 by bisection."""
    curve = bending_life_curve(Treatment.CASE_HARDENED)
    levels = [1.8, 1.2]
    bins = [StressBin(level * 800e6, 0.5 * endurable_cycles(curve, level)) for level in levels]
    found = spectrum_damage(bins, 800e6, curve)
    assert found.parts == pytest.approx((0.5, 0.5), rel=1e-12)
    assert found.safety == pytest.approx(1.0, rel=1e-9)


def test_a_single_level_has_the_safety_of_a_single_rating():
    """S = σ_HG Z_NT(n)/σ: Miner with one bin is the plain life factor; 1e-9."""
    curve = contact_life_curve(Treatment.CASE_HARDENED)
    found = spectrum_damage([StressBin(1100e6, 2e7)], 1500e6, curve)
    assert found.safety == pytest.approx(1500.0 / 1100.0 * float(life_factor(curve, 2e7)), rel=1e-9)


def test_an_empty_spectrum_is_refused():
    with pytest.raises(DesignError, match="no bin has both stress and cycles"):
        spectrum_damage([StressBin(0.0, 1e6)], 1500e6, contact_life_curve(Treatment.CASE_HARDENED))


def test_inner_points_of_single_contact_matter_for_few_teeth_only():
    """Z_B > 1 for a small spur pinion, 1 from ε_β = 1 on, between them for narrow helical gears."""
    spur = single_contact_factors(mesh_geometry(pair(18, 60, 0.0, (0.0, 0.0))))[0]
    narrow = single_contact_factors(mesh_geometry(pair(18, 60, 10.0, (0.0, 0.0), width=20e-3)))[0]
    wide = single_contact_factors(mesh_geometry(pair(18, 60, 20.0, (0.0, 0.0))))[0]
    assert spur > narrow > wide == 1.0
    assert single_contact_factors(mesh_geometry(pair(25, -101, 0.0, (0.2, 0.0))))[1] == 1.0


def test_soft_wheels_harden_against_hard_smooth_pinions():
    """ISO 6336-2, clause 13: 1.2 at 130 HB, 1 at 470 HB with R_zH = 3 µm; 1 for hard gears."""
    both = (Treatment.THROUGH_HARDENED, Treatment.CASE_HARDENED)
    args = {"mate_hardness": 650.0, "mate_roughness": 3e-6, "ratio": 4.0}
    assert work_hardening_factor(130.0, both, **args) == pytest.approx(1.2)
    assert work_hardening_factor(470.0, both, **args) == pytest.approx(1.0)
    assert work_hardening_factor(650.0, both[::-1], **args) == 1.0
    soft = (Treatment.THROUGH_HARDENED,) * 2
    found = work_hardening_factor(200.0, soft, mate_hardness=240.0, mate_roughness=3e-6, ratio=3.0)
    assert found == pytest.approx(1.0 + (0.00898 * 1.2 - 0.00829) * 2.0)
    assert work_hardening_factor(200.0, soft, mate_hardness=210.0, mate_roughness=3e-6, ratio=3.0) == 1.0


def test_size_factors_are_one_for_aircraft_modules():
    for treatment in Treatment:
        assert bending_size_factor(5e-3, treatment) == 1.0
    assert bending_size_factor(30e-3, Treatment.CASE_HARDENED) == pytest.approx(0.8)
    assert bending_size_factor(30e-3, Treatment.THROUGH_HARDENED) == pytest.approx(0.85)


@pytest.mark.parametrize("treatment", list(Treatment))
def test_the_surface_factor_is_one_at_the_roughness_of_the_test_gears(treatment):
    """R_z = 10 µm is the reference; the printed constants give it to 6e-3."""
    assert surface_factor(10e-6, treatment) == pytest.approx(1.0, abs=6e-3)
    assert surface_factor(0.5e-6, treatment) >= surface_factor(2e-6, treatment) > surface_factor(40e-6, treatment)


def test_the_notch_factor_is_one_at_the_notch_of_the_test_gears():
    """q_sT = 2.5 for every steel; exact."""
    for steel in (HARD, SOFT):
        assert notch_sensitivity_factor(2.5, steel) == pytest.approx(1.0, rel=1e-12)
    unknown = GearSteel("soft", Treatment.THROUGH_HARDENED, "MQ", 300.0, 760e6, 310e6)
    with pytest.raises(DesignError, match=r"R_p0\.2"):
        notch_sensitivity_factor(3.0, unknown)


def test_helix_and_load_sharing_of_the_two_editions():
    """ISO 6336-3:2006 and :2019 agree for spur gears (Y_β = 1, f_ε = 1) and differ by 1/cos³ β for helical ones."""
    spur = mesh_geometry(pair(helix=0.0))
    assert helix_factor(spur, Edition.ISO2006) == helix_factor(spur, Edition.ISO2019) == 1.0
    assert load_sharing_factor(spur) == 1.0
    ratio = helix_factor(MESH, Edition.ISO2019) / helix_factor(MESH, Edition.ISO2006)
    assert ratio == pytest.approx(1.0 / math.cos(MESH.helix_angle) ** 3, rel=1e-12)
    assert contact_ratio_factor_root(spur) == pytest.approx(0.25 + 0.75 / spur.transverse_contact_ratio)


def test_thin_rims_raise_the_root_stress_and_too_thin_ones_are_refused():
    """Continuous at s_R = 1.2 h_t and 3.5 m_n: the logarithms are 1 there to 2e-3."""
    assert rim_factor(10e-3, 5e-3, 2e-3) == 1.0
    assert rim_factor(0.9999 * 6e-3, 5e-3, 2e-3) == pytest.approx(1.0, abs=2e-3)
    assert rim_factor(0.9999 * 7e-3, 5e-3, 2e-3, internal=True) == pytest.approx(1.0, abs=5e-3)
    assert rim_factor(4e-3, 5e-3, 2e-3) > 1.3
    with pytest.raises(DesignError, match=r"2 mm given; ISO 6336-3 rates rims above 2\.5 mm"):
        rim_factor(2e-3, 5e-3, 2e-3)


def test_deep_teeth_count_only_when_they_are_accurate():
    deep = MeshGeometry((40.0, 80.0), 2e-3, 20e-3, 0.12, (42.8e-3, 82.8e-3))
    assert deep.transverse_contact_ratio > 2.05
    assert deep_tooth_factor(deep, 4) < 1.0
    assert deep_tooth_factor(deep, 5) == 1.0


def test_more_load_more_width_and_better_steel_move_safety_the_right_way():
    """Signs of the whole chain: S_H falls with √T and rises with b; S_F follows σ_Flim."""
    duty = MeshDuty(512.5, 628.3, 3500 * 3600.0, 1.25)
    base = rate_pair(PAIR, (HARD, HARD), duty)
    heavy = rate_pair(PAIR, (HARD, HARD), MeshDuty(1025.0, 628.3, 3500 * 3600.0, 1.25))
    wide = rate_pair(pair(width=60e-3), (HARD, HARD), duty)
    strong = GearSteel("strong", Treatment.CASE_HARDENED, "ME", 700.0, 1650e6, 525e6)
    better = rate_pair(PAIR, (strong, strong), duty)
    assert heavy.pitting.safeties[0] < base.pitting.safeties[0] < wide.pitting.safeties[0]
    assert better.bending[0].safety == pytest.approx(base.bending[0].safety * 525.0 / 461.0, rel=1e-12)
    assert base.cycles[0] == pytest.approx(628.3 / (2 * math.pi) * 3500 * 3600, rel=1e-12)


@pytest.mark.parametrize("wheel", [90, -90])
@pytest.mark.parametrize("helix", [0.0, 20.0])
def test_the_nominal_stress_is_hertz_at_the_pitch_point(wheel, helix):
    """σ_H0/(Z_ε Z_β) = √(F_bn E/(2π (1 − ν²) b ρ_n)), for pairs and rings alike: an independent path, 1e-12.

    F_bn = F_t/(cos α_t cos β_b) over b, ρ_n = ρ_red/cos β_b, and the contact line b/cos β_b.
    """
    case = pair(30, wheel, helix, (0.3, 0.3))
    mesh = mesh_geometry(case)
    rated = rate_pair(case, (HARD, HARD), MeshDuty(300.0, 200.0, 3.6e6))
    lean = math.cos(mesh.base_helix_angle)
    force = rated.tangential_force / (math.cos(mesh.transverse_angle) * lean)
    load = force / (mesh.face_width / lean)
    hertz = math.sqrt(load * 206e9 / (2.0 * math.pi * (1.0 - 0.3**2)) / (mesh.relative_curvature / lean))
    factors = rated.pitting.geometry
    assert rated.pitting.nominal_stress / (factors.contact_ratio * factors.helix) == pytest.approx(hertz, rel=1e-12)


def test_a_stress_that_is_next_to_nothing_is_borne_for_ever():
    curve = bending_life_curve(Treatment.CASE_HARDENED)
    assert endurable_cycles(curve, 1e-12) == math.inf
    assert math.isfinite(endurable_cycles(curve, 0.5))
