"""Every factor of ISO 6336-1 to -3 by the formula of its clause, in every branch and at both ends of every clamp."""

import math
from dataclasses import replace
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.iso6336 import (
    CENTRED,
    CORRECTED_AND_CROWNED,
    CROWNED,
    UNMODIFIED,
    Edition,
    GearSteel,
    MeshDeviations,
    MeshDuty,
    MeshGeometry,
    MeshSprings,
    Misalignment,
    MovingBody,
    PinionShaft,
    StrengthLine,
    StressBin,
    ToothLoadFactors,
    Treatment,
    allowable_stress,
    bending_life_curve,
    bending_size_factor,
    contact_life_curve,
    contact_ratio_factor_root,
    damage_parts,
    deep_tooth_factor,
    deflection_misalignment,
    dynamic_factor,
    elasticity_factor,
    endurable_cycles,
    equivalent_roughness,
    face_load_factor,
    helix_factor,
    knee_curve,
    lead_allowance,
    life_curves,
    life_factor,
    load_sharing_factor,
    lubricant_factor,
    notch_sensitivity_factor,
    outer_single_contact,
    pitting_rating,
    rate_mesh,
    reduced_mass,
    rim_factor,
    root_section,
    roughness_factor,
    running_in_allowance,
    single_contact_factors,
    spectrum_damage,
    speed_factor,
    surface_factor,
    transverse_load_factor,
    work_hardening_factor,
)
from gearwright.parts.iso6336.dynamic import mesh_springs
from gearwright.parts.iso6336.loads import USUAL, HelixModification, MeshQuality, flank_tolerances, specific_load
from gearwright.parts.iso6336.tooth_strength import (
    ContactStrengthFactors,
    RootBody,
    RootStrengthFactors,
    bending_rating,
    contact_ratio_factor,
    slip_layer,
    zone_factor,
)

ST, V, EH, IF, NT, NV, NVC, *_ = Treatment
HARD = GearSteel("hard", EH, "MQ", 700.0, 1500e6, 461e6, 206e9, 0.3, 7830.0)
SOFT = GearSteel("soft", V, "MQ", 280.0, 640e6, 310e6, 210e9, 0.28, 7850.0, 700e6)
MESH = MeshGeometry((23, 71), 3e-3, 19e-3, 146.1e-3, (39.1e-3, 113.2e-3), math.radians(14.0), math.radians(21.0))
RING = MeshGeometry((25, -83), 2.5e-3, 30e-3, 73.7e-3, (34.6e-3, 102.9e-3), math.radians(9.0))


def near(value):
    return pytest.approx(value, rel=1e-10, abs=0.0)


@pytest.mark.parametrize(("strength", "c_l", "c_v", "c_r"), [
    (600.0, 0.83, 0.85, 0.15), (920.0, 0.846, 0.866, 0.136), (1500.0, 0.91, 0.93, 0.08),
])  # fmt: skip
def test_the_film_factors_run_between_850_and_1200(strength, c_l, c_v, c_r):
    """ISO 6336-2:2006, 12.3: C_ZL = (σ − 850)/350 · 0.08 + 0.83, C_Zv = C_ZL + 0.02, C_ZR = 0.32 − 0.0002 σ."""
    sigma = strength * 1e6
    assert lubricant_factor(150e-6, sigma) == near(c_l + 4.0 * (1.0 - c_l) / (1.2 + 134.0 / 150.0) ** 2)
    assert speed_factor(7.0, sigma) == near(c_v + 2.0 * (1.0 - c_v) / math.sqrt(0.8 + 32.0 / 7.0))
    assert roughness_factor(4e-6, 25e-3, sigma) == near((3.0 / (4.0 * 0.4 ** (1.0 / 3.0))) ** c_r)


@pytest.mark.parametrize(("treatments", "hardness", "mate", "ratio", "expected"), [
    ((EH, V), 600.0, 250.0, 3.0, 1.0),
    ((V, EH), 300.0, 650.0, 3.0, (1.2 - 170.0 / 1700.0) * 0.75**0.15),
    ((V, NT), 110.0, 650.0, 3.0, 1.2 * 0.75**0.15),
    ((V, EH), 500.0, 650.0, 3.0, 1.0),
    ((V, V), 200.0, 220.0, 3.0, 1.0),
    ((V, V), 200.0, 300.0, 3.0, 1.0 + (0.00898 * 1.5 - 0.00829) * 2.0),
    ((ST, V), 150.0, 300.0, 4.0, 1.0 + 0.00698 * 3.0),
    ((V, V), 200.0, 260.0, 3.0, 1.0 + (0.00898 * 1.3 - 0.00829) * 2.0),
        ((V, V), 200.0, 300.0, 25.0, 1.0 + (0.00898 * 1.5 - 0.00829) * 19.0),
])  # fmt: skip
def test_work_hardening_helps_a_soft_gear_against_a_harder_one(treatments, hardness, mate, ratio, expected):
    """ISO 6336-2:2006, clause 13, R_zH = 4 µm: (3/4)^0.15."""
    factor = work_hardening_factor(hardness, treatments, mate_hardness=mate, mate_roughness=4e-6, ratio=ratio)
    assert factor == near(expected)


@pytest.mark.parametrize(("flanks", "curvature", "speed", "expected"), [
    ((8e-6, 8e-6), 10e-3, 15.0, 8.0),  # ν_40 v = 1500: nothing but R_z
    ((8e-6, 4e-6), 10e-3, 15.0, 8.0 * 2.0**0.66),
    ((8e-6, 8e-6), 40e-3, 15.0, 8.0 * 4.0**-0.33),
    ((8e-6, 8e-6), 10e-3, 7.5, 8.0 * 2.0**0.33),
    ((20e-6, 20e-6), 10e-3, 15.0, 16.0),
    ((2e-6, 2e-6), 10e-3, 15.0, 3.0),
])  # fmt: skip
def test_a_hard_flank_works_its_mate_by_its_equivalent_roughness(flanks, curvature, speed, expected):
    """ISO 6336-2:2006, 13.3.2, by hand at ν_40 = 100 mm²/s; held between 3 and 16 µm."""
    assert equivalent_roughness(flanks, curvature, viscosity=100e-6, speed=speed) == near(1e-6 * expected)


@pytest.mark.parametrize(("treatment", "module", "expected"), [
    (ST, 4.0, 1.0), (V, 20.0, 0.91), (V, 40.0, 0.85), (EH, 4.0, 1.0), (IF, 12.0, 0.93), (NT, 30.0, 0.80),
])  # fmt: skip
def test_the_size_factor_of_bending_is_that_of_table_5(treatment, module, expected):
    """ISO 6336-3:2006, table 5."""
    assert bending_size_factor(module * 1e-3, treatment) == near(expected)


@pytest.mark.parametrize("rough", [0.5, 1.1, 1.5, 6.0, 40.0, 60.0])
def test_the_surface_factor_is_that_of_its_three_groups(rough):
    """ISO 6336-3:2006, 13.3: constant below 1 µm, held from 40 µm."""
    height = min(rough, 40.0) + 1.0
    for treatments, fine, first, second, power in (
        ((V, EH, IF), 1.12, 1.674, 0.529, 0.1),
        ((ST,), 1.07, 5.306, 4.203, 0.01),
        ((NT, NV, NVC), 1.025, 4.299, 3.259, 0.0058),
    ):
        expected = fine if rough < 1.0 else first - second * height**power
        for treatment in treatments:
            assert surface_factor(rough * 1e-6, treatment) == near(expected)


YIELDS = [(250.0, 0.0833), (300.0, 0.0833), (350.0, 0.0639), (400.0, 0.0445), (500.0, 0.0281), (600.0, 0.0194),
          (800.0, 0.0064), (1000.0, 0.0014), (1300.0, 0.0014), (700.0, 0.0129)]  # fmt: skip


def test_the_slip_layer_is_that_of_table_3():
    """ISO 6336-3:2006, table 3, in mm; 700 N/mm² lies in the middle between 600 and 800."""
    for strength, layer in YIELDS:
        assert slip_layer(replace(SOFT, yield_strength=strength * 1e6)) == near(layer * 1e-3)
    assert slip_layer(replace(SOFT, treatment=ST, yield_strength=400e6)) == near(0.0445e-3)
    for treatment, layer in ((EH, 0.0030), (IF, 0.0030), (NT, 0.1005), (NV, 0.1005), (NVC, 0.1005)):
        assert slip_layer(replace(HARD, treatment=treatment)) == near(layer * 1e-3)


def test_the_notch_sensitivity_follows_the_stress_gradient():
    """(1 + √(ρ′ χ*))/(1 + √(ρ′ 1.2)), χ* = (1 + 2 q_s)/5."""
    for steel, layer in ((HARD, 0.0030), (SOFT, 0.0129)):
        expected = (1.0 + math.sqrt(layer * (1.0 + 2.0 * 3.4) / 5.0)) / (1.0 + math.sqrt(layer * 1.2))
        assert notch_sensitivity_factor(3.4, steel) == near(expected)


def test_thin_rims_have_the_printed_logarithms():
    """ISO 6336-3:2006, clause 9: 1.6 ln(2.242 h/s), 1.15 ln(8.324 m/s); 1 from 1.2 h and 3.5 m on."""
    assert rim_factor(4e-3, 5e-3, 2e-3) == near(1.6 * math.log(2.242 * 5.0 / 4.0))
    assert rim_factor(5e-3, 5e-3, 2e-3, internal=True) == near(1.15 * math.log(8.324 * 2.0 / 5.0))
    assert rim_factor(3.6e-3, 9e-3, 2e-3, internal=True) == near(1.15 * math.log(8.324 * 2.0 / 3.6))
    assert rim_factor(12e-3, 5e-3, 2e-3) == rim_factor(20e-3, 5e-3, 2e-3, internal=True) == 1.0
    assert rim_factor(2.6e-3, 5e-3, 2e-3) == near(1.6 * math.log(2.242 * 5.0 / 2.6))


@pytest.mark.parametrize(("ratio", "deep"), [(1.8, 1.0), (2.2, 2.366 - 0.666 * 2.2), (2.6, 0.7)])
@pytest.mark.parametrize("lean", [0.0, 0.2])
def test_deep_teeth_count_by_the_virtual_contact_ratio(ratio, deep, lean):
    """ISO 6336-3:2006, clause 10, ε_αn = ε_α/cos² β_b; and Y_ε = 0.25 + 0.75/ε_αn of 1996."""
    mesh = SimpleNamespace(transverse_contact_ratio=ratio * math.cos(lean) ** 2, base_helix_angle=lean)
    assert deep_tooth_factor(mesh, 4) == near(deep)
    assert deep_tooth_factor(mesh, 5) == 1.0
    assert contact_ratio_factor_root(mesh) == near(0.25 + 0.75 / ratio)


def test_load_sharing_and_helix_factor_of_leaning_teeth():
    """ε_αn = 1.5/cos² 0.2 with ε_β = 0.4, and 2.1 over it; Y_β = 1 − 0.4 · 14/120."""
    lean = {"base_helix_angle": 0.2, "overlap_ratio": 0.4, "helix_angle": math.radians(14.0)}
    ratio = 1.5 / math.cos(0.2) ** 2
    mesh = SimpleNamespace(transverse_contact_ratio=1.5, **lean)
    assert load_sharing_factor(mesh) == near(math.sqrt(0.6 + 0.4 / ratio))
    assert [edition.value for edition in Edition] == [1987, 2006, 2019]
    assert helix_factor(mesh, Edition.ISO2019) == near((1.0 - 0.4 * 14.0 / 120.0) / math.cos(math.radians(14.0)) ** 3)


def test_the_elasticity_factor_is_that_of_two_bodies():
    """√(1/(π Σ (1 − ν²)/E)); 189.8 √(N/mm²) for steel on steel, ISO 6336-2, table of Z_E."""
    assert elasticity_factor((HARD, HARD)) == pytest.approx(189.8e3, rel=5e-4)
    pair = (1.0 - 0.3**2) / 206e9 + (1.0 - 0.28**2) / 210e9
    assert elasticity_factor((HARD, SOFT)) == near(math.sqrt(1.0 / (math.pi * pair)))


LIVES = [
    (lambda: contact_life_curve(EH), ((1e5, 1.6), (5e7, 1.0), (1e10, 0.85))),
    (lambda: contact_life_curve(V, at_1e10=1.0), ((1e5, 1.6), (5e7, 1.0), (1e10, 1.0))),
    (lambda: contact_life_curve(IF, some_pitting=True), ((6e5, 1.6), (1e7, 1.3), (1e9, 1.0), (1e10, 0.85))),
    (lambda: contact_life_curve(NT), ((1e5, 1.3), (2e6, 1.0), (1e10, 0.85))),
    (lambda: contact_life_curve(NV, some_pitting=True), ((1e5, 1.3), (2e6, 1.0), (1e10, 0.85))),
    (lambda: contact_life_curve(NVC), ((1e5, 1.1), (2e6, 1.0), (1e10, 0.85))),
    (lambda: bending_life_curve(ST), ((1e4, 2.5), (3e6, 1.0), (1e10, 0.85))),
    (lambda: bending_life_curve(V), ((1e4, 2.5), (3e6, 1.0), (1e10, 0.85))),
    (lambda: bending_life_curve(EH, at_1e10=0.92), ((1e3, 2.5), (3e6, 1.0), (1e10, 0.92))),
    (lambda: bending_life_curve(IF), ((1e3, 2.5), (3e6, 1.0), (1e10, 0.85))),
    (lambda: bending_life_curve(NT), ((1e3, 1.6), (3e6, 1.0), (1e10, 0.85))),
    (lambda: bending_life_curve(NV), ((1e3, 1.6), (3e6, 1.0), (1e10, 0.85))),
    (lambda: bending_life_curve(NVC), ((1e3, 1.1), (3e6, 1.0), (1e10, 0.85))),
]
"""Corners of ISO 6336-2:2019, table 2, and ISO 6336-3:2019, table 1."""


@pytest.mark.parametrize(("made", "corners"), LIVES)
def test_lives_are_straight_between_the_printed_corners(made, corners):
    curve = made()
    assert tuple(zip(curve.cycles, curve.factors, strict=True)) == corners
    assert life_factor(curve, corners[0][0] / 7.0) == near(corners[0][1])
    (n_1, f_1), (n_2, f_2) = corners[-2:]
    assert life_factor(curve, n_2 * n_2 / n_1) == near(f_2 * f_2 / f_1)
    for (n_1, f_1), (n_2, f_2) in pairwise(corners):
        middle = (n_1 * n_2) ** 0.5
        assert life_factor(curve, middle) == near((f_1 * f_2) ** 0.5)
        if f_1 > f_2:
            assert endurable_cycles(curve, (f_1 * f_2) ** 0.5) == near(middle)


def test_a_steel_has_the_curves_of_its_treatment_or_its_own():
    """N ~ σ^−p below the knee: 1.5^−9 of it at the static factor; the slope is p again."""
    own = knee_curve(4e7, 9.0, greatest=1.5, at_1e10=0.9)
    assert own.cycles == (near(4e7 * 1.5**-9.0), 4e7, 1e10) and own.factors == (1.5, 1.0, 0.9)
    assert own.slope == near(9.0)
    assert knee_curve(4e7, 9.0, greatest=1.5).factors[-1] == 0.85
    assert life_curves(SOFT) == (contact_life_curve(V), bending_life_curve(V))
    assert life_curves(replace(SOFT, contact_life=own)) == (own, bending_life_curve(V))
    assert life_curves(replace(SOFT, bending_life=own)) == (contact_life_curve(V), own)
    assert life_factor(own, 4e7 / 1.2**9) == near(1.2)


def test_beyond_its_corners_a_curve_goes_on_or_ends():
    """The last slope goes on; a flat end is an endurance limit; above the static value nothing is endured."""
    falling, flat = contact_life_curve(EH), contact_life_curve(EH, at_1e10=1.0)
    assert endurable_cycles(falling, 0.85**2) == pytest.approx(1e10 * (1e10 / 5e7), rel=1e-9)
    assert endurable_cycles(flat, 1.0) == endurable_cycles(flat, 0.99) == math.inf > endurable_cycles(flat, 1.01)
    assert endurable_cycles(falling, 1.61) == 0.0
    assert endurable_cycles(falling, 1.6) == near(1e5)


def test_damage_adds_up_bin_by_bin():
    """Miner: n/N with N from the middle of each slope; nothing without stress, endless above the static value."""
    curve = contact_life_curve(EH)
    middle, beyond = math.sqrt(1.6), math.sqrt(0.85)
    bins = [StressBin(middle * 1e9, 1e6), StressBin(beyond * 1e9, 3e8), StressBin(0.0, 1e9)]
    n_1, n_2 = math.sqrt(1e5 * 5e7), math.sqrt(5e7 * 1e10)
    assert damage_parts(bins, 1e9, curve) == pytest.approx((1e6 / n_1, 3e8 / n_2, 0.0))
    damage = spectrum_damage(bins, 1e9, curve)
    assert damage.total == near(1e6 / n_1 + 3e8 / n_2)
    assert sum(damage_parts([replace(b, stress=b.stress * damage.safety) for b in bins], 1e9, curve)) == pytest.approx(
        1.0
    )
    assert damage_parts([StressBin(2e9, 1.0)], 1e9, curve) == (math.inf,)
    # At the static value itself 1e5 cycles are endured: fewer leave just the static safety.
    assert spectrum_damage([StressBin(1e9, 10.0)], 1e9, curve).safety == pytest.approx(1.6)
    for strength in (6e5, 70.0, 0.006, 6e-6):
        assert spectrum_damage([StressBin(1e9, 1e5)], strength * 1e9, curve).safety == pytest.approx(1.6 * strength)


def test_running_in_takes_its_share_off_every_deviation():
    """ISO 6336-1, 8.3.6 and 7.5.2.5, soft steel of 640 N/mm² and a nitrided one."""
    for speed, most in ((5.0, math.inf), (5.5, 12800.0), (7.0, 12800.0), (10.0, 12800.0), (11.0, 6400.0)):
        for micron in (30.0, 90.0):
            expected = min(160.0 / 640.0 * micron, most / 640.0) * 1e-6
            assert running_in_allowance(micron * 1e-6, SOFT, speed) == near(expected)
            expected = min(320.0 / 640.0 * micron, 2.0 * most / 640.0) * 1e-6
            assert lead_allowance(micron * 1e-6, SOFT, speed) == near(expected)
    weak = replace(SOFT, contact_strength=250e6)
    assert lead_allowance(20e-6, weak, 3.0) == near(20e-6)
    nitrided = replace(HARD, treatment=NVC)
    assert running_in_allowance(20e-6, nitrided, 3.0) == near(1.5e-6)
    assert lead_allowance(20e-6, nitrided, 3.0) == near(3e-6)


def test_pinion_and_shaft_bend_by_the_formula_of_clause_7():
    """f_sh = F_m/b 0.023 (|B* + K′ l s/d_1² (d_1/d_sh)⁴ − 0.3| + 0.3)(b/d_1)², in N/mm, mm and µm."""
    d_1 = MESH.pitch_diameters[0] * 1e3
    for shaft, paths in ((PinionShaft(20e-3, 150e-3, 55e-3, 0.6), 1), (PinionShaft(-30e-3, 210e-3, 48e-3, 1.33), 3)):
        lever = shaft.constant * shaft.span * shaft.offset * 1e6 / d_1**2 * (d_1 / (shaft.diameter * 1e3)) ** 4
        b_star = 1.0 + 2.0 * (paths - 1)
        expected = 180.0 * 0.023 * (abs(b_star + lever - 0.3) + 0.3) * (19.0 / d_1) ** 2 * 1e-6
        assert deflection_misalignment(MESH, 180e3, shaft, paths=paths) == near(expected)
    assert deflection_misalignment(MESH, 180e3, CENTRED) == near(180.0 * 0.023 * (19.0 / d_1) ** 2 * 1e-6)
    assert (CENTRED.offset, CENTRED.span, CENTRED.constant) == (0.0, 0.0, 0.48)
    # A shaft that straightens the pinion: the amount inside the bars turns over.
    back = PinionShaft(-30e-3, 300e-3, 48e-3, 0.48)
    lever = 0.48 * 300.0 * -30.0 / d_1**2 * (d_1 / 48.0) ** 4
    assert 1.0 + lever - 0.3 < 0.0
    assert deflection_misalignment(MESH, 1e5, back) == near(2.3e-6 * (0.3 - 0.7 - lever) * (19.0 / d_1) ** 2)


def test_helix_modifications_have_the_weights_of_table_8():
    """ISO 6336-1:2006, table 8: B_1 and B_2 of rows 1, 3 and 5."""
    rows = (UNMODIFIED, CROWNED, CORRECTED_AND_CROWNED)
    assert [(row.deflection, row.manufacture) for row in rows] == [
        (1.0, 1.0), (0.5, 0.5), (0.1, 0.5),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("deflection", "manufacture", "load"), [(8e-6, 6e-6, 2e5), (0.4e-6, 0.1e-6, 4e5), (30e-6, 25e-6, 1e5)]
)
def test_the_face_load_factor_is_that_of_clause_7(deflection, manufacture, load):
    """F_βx = 1.33 B_1 f_sh + B_2 f_ma ≥ 0.005 mm µm/N F_m/b; 1 + F_βy c_γβ/(2 w), or √(2 F_βy c_γβ/w) from 2 on."""
    weights, stiffness = HelixModification(0.9, 0.7), 15e9
    initial = max(1.33 * 0.9 * deflection + 0.7 * manufacture, 0.005 * load * 1e-3 * 1e-6)
    taken = 0.5 * (min(0.15 * initial, 6e-6) + min(0.5 * initial, 40e-6))
    tilt = (initial - taken) * stiffness / load
    contact = math.sqrt(2.0 * tilt) if tilt >= 2.0 else 1.0 + tilt / 2.0
    for mesh in (MESH, RING):
        face = face_load_factor(
            mesh, Misalignment(deflection, manufacture), (HARD, SOFT),
            stiffness=stiffness, specific_load=load, speed=8.0, modification=weights,
        )  # fmt: skip
        assert (face.deflection, face.manufacture) == (deflection, manufacture)
        assert face.misalignment == near(initial - taken)
        assert face.contact == near(contact)
        slender = max(3.0, mesh.face_width / max(mesh.tooth_heights))
        assert face.bending == near(contact ** (slender**2 / (1.0 + slender + slender**2)))


def test_of_the_two_pairs_above_one_is_slender_and_one_is_held_at_three():
    assert 19e-3 / max(MESH.tooth_heights) < 3.0 < 30e-3 / max(RING.tooth_heights)
    assert MESH.tooth_heights[0] != MESH.tooth_heights[1] and RING.tooth_heights[0] != RING.tooth_heights[1]


@pytest.mark.parametrize("deviation", [0.5e-6, 9e-6, 14e-6, 60e-6])
@pytest.mark.parametrize(("alpha", "total"), [(1.6, 1.6), (1.6, 2.7), (1.2, 1.9), (1.3, 2.2)])
def test_the_transverse_load_factor_is_that_of_clause_8(deviation, alpha, total):
    """K = ε_γ/2 (0.9 + 0.4 q) up to ε_γ = 2, 0.9 + 0.4 √(2(ε_γ − 1)/ε_γ) q beyond; between 1 and the two limits."""
    mesh = SimpleNamespace(total_contact_ratio=total, transverse_contact_ratio=alpha)
    error = 16e9 * deviation / 2e5
    factor = (
        0.5 * total * (0.9 + 0.4 * error)
        if total <= 2.0
        else 0.9 + 0.4 * math.sqrt(2.0 * (total - 1.0) / total) * error
    )
    result = transverse_load_factor(mesh, deviation, stiffness=16e9, specific_load=2e5, contact_ratio_factor=0.85)
    assert result.contact == near(max(1.0, min(factor, total / (alpha * 0.85**2))))
    assert result.bending == near(max(1.0, min(factor, total / (0.25 * alpha + 0.75))))


def test_limits_below_one_do_not_pull_the_transverse_factors_below_one():
    mesh = SimpleNamespace(total_contact_ratio=1.1, transverse_contact_ratio=1.6)
    result = transverse_load_factor(mesh, 50e-6, stiffness=16e9, specific_load=2e5, contact_ratio_factor=0.95)
    assert (result.contact, result.bending) == (1.0, 1.0)


def test_the_dynamic_factor_counts_teeth_mass_and_stiffness():
    """N = ω_1 z_1/√(c_γα/m_red); B_p and B_f over the specific load; B_k as handed on, 1 where nothing is."""
    springs, dev = MeshSprings(14e9, 20e9, 17e9), MeshDeviations(4e-6, 3e-6, 0.4)
    k = dynamic_factor(MESH, springs, dev, specific_load=2e5, pinion_speed=700.0, masses=(0.3,))
    ratio = 700.0 * 23.0 / math.sqrt(20e9 / 0.3)
    b_p, b_f, b_k = 14e9 * 4e-6 / 2e5, 14e9 * 3e-6 / 2e5, 0.4
    assert (k.reduced_mass, k.resonance_ratio) == (0.3, near(ratio))
    assert (k.pitch_term, k.profile_term, k.relief_term) == (near(b_p), near(b_f), near(b_k))
    c = MESH.total_contact_ratio
    assert c > 2.0
    terms = 0.32 * b_p + 0.57 / (c - 0.3) * b_f + 0.096 / (c - 1.56) * b_k
    assert k.factor == near(1.0 + ratio * terms)
    assert MeshDeviations(1e-6, 1e-6).relief_term == 1.0


def test_pitting_is_the_product_of_its_factors():
    """ISO 6336-2, clause 5: σ_H0 = Z_H Z_E Z_ε Z_β √(F_t/(d_1 b) (u + 1)/u); every factor another number."""
    loads = ToothLoadFactors(1.25, 1.1, 1.07, 1.2, 1.15, 1.18, 1.13)
    assert loads.contact == near(1.25 * 1.1 * 1.07 * 1.2 * 1.15)
    assert loads.bending == near(1.25 * 1.1 * 1.07 * 1.18 * 1.13)
    strengths = (ContactStrengthFactors(0.9, 1.02, 0.97, 0.93, 1.1, 0.98), ContactStrengthFactors(0.95))
    assert strengths[0].product == near(0.9 * 1.02 * 0.97 * 0.93 * 1.1 * 0.98)
    for mesh, u in ((MESH, 71.0 / 23.0), (RING, -83.0 / 25.0)):
        rated = pitting_rating(mesh, (HARD, SOFT), 9e3, loads=loads, strengths=strengths, profile_factor=1.07)
        z_b, z_d = single_contact_factors(mesh, profile_factor=1.07)
        nominal = zone_factor(mesh) * elasticity_factor((HARD, SOFT)) * contact_ratio_factor(mesh)
        nominal *= math.cos(mesh.helix_angle) ** -0.5
        nominal *= math.sqrt(9e3 / (mesh.pitch_diameters[0] * mesh.face_width) * (u + 1.0) / u)
        assert rated.geometry.single_contact == (near(z_b), near(z_d))
        assert rated.nominal_stress == near(nominal)
        root = math.sqrt(loads.contact)
        assert rated.stresses == pytest.approx((z_b * nominal * root, z_d * nominal * root))
        limits = (1500e6 * strengths[0].product, 640e6 * 0.95)
        assert rated.permissible == pytest.approx(limits)
        assert rated.safeties == pytest.approx((limits[0] / rated.stresses[0], limits[1] / rated.stresses[1]))


@pytest.mark.parametrize("edition", Edition)
@pytest.mark.parametrize("gear", [0, 1])
def test_bending_is_the_product_of_its_factors(edition, gear):
    """ISO 6336-3, clause 5; f_ε and the cosines of Y_β with the edition; Y_ST = 2."""
    loads, strength = (
        ToothLoadFactors(1.25, 1.1, 1.07, 1.2, 1.15, 1.18, 1.13),
        RootStrengthFactors(0.9, 0.98, 1.03, 0.97, 0.7),
    )
    assert strength.product == near(0.9 * 0.98 * 1.03 * 0.97 * 0.7)
    rated = bending_rating(
        MESH, gear, SOFT, specific_load=3e5, loads=loads, strength=strength, body=RootBody(1.2, 0.9, edition)
    )
    section = root_section(outer_single_contact(MESH, gear))
    sharing = load_sharing_factor(MESH) if edition is Edition.ISO2019 else 1.0
    helix = helix_factor(MESH, edition)
    stress = 3e5 / 3e-3 * section.form * sharing * section.stress_correction * helix * 1.2 * 0.9
    assert (rated.load_sharing, rated.helix, rated.rim, rated.deep_tooth) == (near(sharing), near(helix), 1.2, 0.9)
    assert rated.nominal_stress == near(stress)
    assert rated.stress == near(stress * loads.bending)
    assert rated.permissible == near(2.0 * 310e6 * strength.product)
    assert rated.safety == near(2.0 * 310e6 * strength.product / (stress * loads.bending))


QUALITY = MeshQuality(
    4, 3e-6, 12e-6, 5e-6, helix=CROWNED, shaft=PinionShaft(10e-3, 90e-3, 50e-3, 0.6), viscosity=220e-6,
    rims=(1.1, 1.3), mean_stresses=(0.7, 0.9), profile_factor=1.07,
)  # fmt: skip


def test_a_rating_hands_every_factor_on_in_the_order_of_the_standard():
    """K_V from the nominal load, K_Hβ with K_V in it, K_Hα with both; the film by the softer steel; roots by width."""
    duty = MeshDuty(260.0, -310.0, 4e6, 1.25, 1.1, (3.0, 1.0))
    steels, widths = (HARD, SOFT), (22e-3, 20e-3)
    rated = rate_mesh(MESH, steels, duty, quality=QUALITY, widths=widths)
    d_1, speed = MESH.pitch_diameters[0], 155.0 * MESH.pitch_diameters[0]
    assert rated.tangential_force == near(520.0 / d_1)
    assert rated.speed == near(speed)
    load = 520.0 / d_1 / 19e-3 * 1.25 * 1.1
    springs = mesh_springs(MESH, load, steels=steels)
    one, two = (flank_tolerances(d, 3e-3, 19e-3, grade=4) for d in MESH.pitch_diameters)
    pitch = two.single_pitch * math.cos(MESH.transverse_angle)
    assert two.single_pitch > one.single_pitch

    def left(f):
        return f - 0.5 * (running_in_allowance(f, HARD, speed) + running_in_allowance(f, SOFT, speed))

    k_v = dynamic_factor(
        MESH, springs, MeshDeviations(left(pitch), left(two.profile_form), abs(1.0 - springs.single * 5e-6 / load)),
        specific_load=load, pinion_speed=310.0,
        masses=(reduced_mass(MESH, (7830.0, 7850.0), (MovingBody(meshes=3.0), MovingBody())),),
    )  # fmt: skip
    assert vars(rated.dynamic) == pytest.approx(vars(k_v))
    loaded = load * k_v.factor
    bent = deflection_misalignment(MESH, loaded, QUALITY.shaft, paths=3.0)
    made = math.hypot(one.helix_slope, two.helix_slope)
    face = face_load_factor(
        MESH, Misalignment(bent, made), steels, stiffness=springs.face, specific_load=loaded, speed=speed,
        modification=CROWNED,
    )  # fmt: skip
    assert vars(rated.face) == pytest.approx(vars(face))
    across = transverse_load_factor(
        MESH, left(pitch), stiffness=springs.mesh, specific_load=loaded * face.contact,
        contact_ratio_factor=contact_ratio_factor(MESH),
    )  # fmt: skip
    assert vars(rated.transverse) == pytest.approx(vars(across))
    assert vars(rated.loads) == pytest.approx(
        vars(ToothLoadFactors(1.25, 1.1, k_v.factor, face.contact, across.contact, face.bending, across.bending))
    )
    for gear, (steel, count, width) in enumerate(zip(steels, rated.cycles, widths, strict=True)):
        z, y = rated.contact_strength[gear], rated.root_strength[gear]
        assert z.life == life_factor(contact_life_curve(steel.treatment), count)
        assert z.lubricant == lubricant_factor(220e-6, 640e6) and z.speed == speed_factor(rated.speed, 640e6)
        assert z.roughness == near(roughness_factor(3e-6, MESH.relative_curvature, 640e6))
        assert z.size == 1.0
        notch = root_section(outer_single_contact(MESH, gear)).notch
        assert y.life == life_factor(bending_life_curve(steel.treatment), count)
        assert y.notch_sensitivity == near(notch_sensitivity_factor(notch, steel))
        assert y.surface == near(surface_factor(12e-6, V)) and y.size == 1.0
        assert y.mean_stress == (0.7, 0.9)[gear]
        by_hand = bending_rating(
            MESH, gear, steel, specific_load=rated.tangential_force / width, loads=rated.loads, strength=y,
            body=RootBody((1.1, 1.3)[gear], 1.0),
        )  # fmt: skip
        assert rated.bending[gear].safety == near(by_hand.safety)
        assert (rated.bending[gear].rim, rated.bending[gear].deep_tooth) == ((1.1, 1.3)[gear], 1.0)
    # 280 HV are 266 HB: a soft wheel against a hard pinion of 3 µm, (3/3)^0.15 = 1.
    assert rated.contact_strength[0].work_hardening == 1.0
    assert rated.contact_strength[1].work_hardening == near(1.2 - (0.95 * 280.0 - 130.0) / 1700.0)
    by_hand = pitting_rating(MESH, steels, rated.tangential_force, loads=rated.loads, strengths=rated.contact_strength,
                             profile_factor=1.07)  # fmt: skip
    assert rated.pitting.safeties == pytest.approx(by_hand.safeties)


def test_two_soft_gears_harden_by_the_ratio_of_their_hardness():
    """0.00898 · 1.5 − 0.00829 times |u| − 1, and the roots by the common width if no other is said."""
    harder = replace(SOFT, hardness=420.0)
    duty = MeshDuty(100.0, 100.0, 4e6)
    rated = rate_mesh(RING, (harder, SOFT), duty)
    assert rated.contact_strength[1].work_hardening == near(1.0 + (0.00898 * 1.5 - 0.00829) * (83.0 / 25.0 - 1.0))
    assert rated.bending[0].nominal_stress == near(
        rate_mesh(RING, (harder, SOFT), duty, widths=(30e-3, 1.0)).bending[0].nominal_stress
    )
    assert rated.bending[0].deep_tooth == rated.bending[0].rim == 1.0


def test_what_is_usual_is_class_5_ground_and_centred():
    """ISO 6336-5's test gears: R_z of 4 and 10 µm; ν_40 of 100 mm²/s."""
    assert (USUAL.grade, USUAL.flank_roughness, USUAL.root_roughness, USUAL.tip_relief) == (5, 4e-6, 10e-6, 0.0)
    assert (USUAL.viscosity, USUAL.rims, USUAL.mean_stresses, USUAL.profile_factor) == (100e-6, (1, 1), (1, 1), 1.0)
    assert (USUAL.helix, USUAL.shaft) == (UNMODIFIED, CENTRED)
    steel = GearSteel("steel", EH, "MQ", 700.0, 1500e6, 461e6)
    rated = rate_mesh(RING, (steel, steel), MeshDuty(100.0, 100.0, 1e6))
    assert vars(rated.loads)["application"] == vars(rated.loads)["mesh_load"] == 1.0
    assert (steel.elastic_modulus, steel.poisson_ratio, steel.density) == (206e9, 0.3, 7830.0)
    assert specific_load(MESH, MeshDuty(100.0, 1.0, 1.0)) == near(200.0 / MESH.pitch_diameters[0] / 19e-3)


def test_factors_that_nobody_gives_are_one():
    """A load, a strength and a body without factors: the bare stresses and limits of clause 5."""
    rated = pitting_rating(MESH, (HARD, HARD), 9e3, loads=ToothLoadFactors(), strengths=(ContactStrengthFactors(),) * 2)
    z_b, _ = single_contact_factors(MESH)
    assert rated.stresses[0] == near(z_b * rated.nominal_stress) and rated.permissible == (1500e6, 1500e6)
    root = bending_rating(MESH, 0, HARD, specific_load=3e5, loads=ToothLoadFactors(), strength=RootStrengthFactors())
    assert root.stress == root.nominal_stress and root.permissible == 922e6
    assert (root.rim, root.deep_tooth) == (1.0, 1.0)


def test_fast_coarse_flanks_run_in_by_their_own_speed():
    """At 9 m/s class 11 loses all that 20 µm allow; at 10 µm, the limit above 10 m/s, it would lose less."""
    d_1 = MESH.pitch_diameters[0]
    rated = rate_mesh(MESH, (SOFT, SOFT), MeshDuty(260.0, 18.0 / d_1, 4e6), quality=MeshQuality(11))
    made = flank_tolerances(MESH.pitch_diameters[1], 3e-3, 19e-3, grade=11)
    pitch = made.single_pitch * math.cos(MESH.transverse_angle)
    assert 0.25 * pitch > 10e-6
    load = specific_load(MESH, MeshDuty(260.0, 1.0, 1.0))
    assert rated.dynamic.pitch_term == near(mesh_springs(MESH, load).single * 210.0 / 206.0 * 0.75 * pitch / load)
    initial = 1.33 * rated.face.deflection + rated.face.manufacture
    assert 0.5 * initial > 20e-6
    assert rated.face.misalignment == near(initial - min(0.5 * initial, 40e-6))


def test_strengths_are_lines_over_hardness():
    """ISO 6336-5, table 1: V MQ contact, 1.313 · 300 + 373 N/mm²."""
    assert allowable_stress(StrengthLine(1.313e6, 373e6, (200.0, 360.0)), 300.0) == near(766.9e6)


def test_one_bad_load_of_many_is_refused():
    with pytest.raises(DesignError, match="pinion_torque"):
        MeshDuty(np.array([1.0, -1.0]), 1.0, 1.0)


def test_the_hardest_of_the_soft_gains_by_a_smooth_mate_alone():
    """1.2 − 340/1700 = 1 from 470 HB on, times 3^0.15 for 1 µm."""
    factor = work_hardening_factor(520.0, (V, EH), mate_hardness=650.0, mate_roughness=1e-6, ratio=3.0)
    assert factor == near(3.0**0.15)
