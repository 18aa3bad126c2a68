"""Mesh stiffness by its sources' formulas: printed coefficients, direct sums of pairs, and integrals done bluntly."""

import math
from itertools import pairwise

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts import Material
from gearwright.parts.gears import ISO53_A, BasicRack, CylindricalGear, GearPair, contact_radii, tooth_form
from gearwright.parts.stiffness import (
    GearBlank,
    StiffnessCurve,
    blank_factor,
    contact_compliance,
    curve_of,
    cut_square_wave,
    half_plane_foundation,
    held_body_foundation,
    load_factor,
    mesh_curve_iso6336,
    mesh_cycle_energy,
    mesh_stiffness_energy,
    mesh_stiffness_iso6336,
    mesh_stiffness_kuang_yang,
    pair_curve,
    pair_stiffness,
    rack_factor,
    rectangular_curve,
    sampled_curve,
    stiffness_at,
    summed_pairs,
    theoretical_stiffness,
    tooth_compliance,
    tooth_stiffness_kuang_yang,
)

PI = math.pi
STEEL = Material("steel", 206e9, 0.3, 7850.0)
LIGHT = Material("light", 110e9, 0.33, 4430.0)


def near(value):
    return pytest.approx(value, rel=1e-10, abs=0.0)


def pair(first, second, *, helix=0.0, shifts=(0.2, 0.1), rack=ISO53_A, other=None):
    beta = math.radians(helix)
    return GearPair(
        CylindricalGear(first, 3e-3, 22e-3, beta, shifts[0], rack),
        CylindricalGear(second, 3e-3, 20e-3, beta, shifts[1], other or rack),
    )


def printed_q(z_1, x_1, z_2, x_2):
    """q′ of ISO 6336-1, clause 9, the pinion first [mm µm/N]; 1/z = 0 for a ring."""
    one, two = 1.0 / z_1, 0.0 if z_2 is None else 1.0 / z_2
    return (
        0.04723 + 0.15551 * one + 0.25791 * two - 0.00635 * x_1 - 0.11654 * x_1 * one - 0.00193 * x_2
        - 0.24188 * x_2 * two + 0.00529 * x_1**2 + 0.00182 * x_2**2
    )  # fmt: skip


def test_the_gear_with_fewer_teeth_is_the_pinion_of_the_regression():
    assert theoretical_stiffness((21.0, 50.0), (0.3, 0.1)) == near(1e9 / printed_q(21.0, 0.3, 50.0, 0.1))
    assert theoretical_stiffness((50.0, 21.0), (0.1, 0.3)) == near(1e9 / printed_q(21.0, 0.3, 50.0, 0.1))
    assert theoretical_stiffness((30.0, 30.0), (0.1, 0.3)) == near(1e9 / printed_q(30.0, 0.3, 30.0, 0.1))
    assert theoretical_stiffness((30.0, 30.0), (0.3, 0.1)) == near(1e9 / printed_q(30.0, 0.3, 30.0, 0.1))
    assert theoretical_stiffness((30.0, math.inf)) == near(1e9 / printed_q(30.0, 0.0, None, 0.0))


def test_blank_rack_and_load_factors_have_their_limits():
    """C_R = 1 + ln(b_s/b)/(5 e^(s_R/(5 m))), 0.2 ≤ b_s/b ≤ 1.2, s_R/m ≥ 1; C_B; (w/100)^0.25."""
    for web, rim in ((0.5, 3.0), (0.1, 3.0), (1.5, 3.0), (0.5, 0.4)):
        expected = 1.0 + math.log(min(max(web, 0.2), 1.2)) / (5.0 * math.exp(max(rim, 1.0) / 5.0))
        assert blank_factor(GearBlank(web, rim)) == near(expected)
    assert blank_factor(GearBlank()) == 1.0
    assert blank_factor(GearBlank(0.5)) == near(1.0 + math.log(0.5) / (5.0 * math.e))
    first, second = BasicRack(math.radians(22.0), 1.0, 1.4, 0.3), BasicRack(math.radians(18.0), 1.0, 1.1, 0.3)
    expected = ((1.0 - 0.1) * (1.0 + 0.04) + (1.0 + 0.05) * (1.0 - 0.04)) / 2.0
    assert rack_factor(first, second) == near(expected)
    assert (load_factor(6.25e3), load_factor(99e3), load_factor(130e3)) == (near(0.5), near(0.99**0.25), 1.0)


@pytest.mark.parametrize("helix", [0.0, 17.0])
@pytest.mark.parametrize("wheel", [61, -83])
def test_the_mesh_stiffness_is_that_of_clause_9(helix, wheel):
    """c′ = c′_th C_M C_R C_B cos β (w/100)^¼ E/E_St; c_γα = c′ (0.75 ε_α + 0.25), c_γβ = 0.85 c_γα."""
    rack, other = BasicRack(fillet_radius=0.3), BasicRack(dedendum=1.35, fillet_radius=0.3)
    mesh = pair(23, wheel, helix=helix, rack=rack, other=other)
    beta = math.radians(helix)
    beta_b = math.asin(math.sin(beta) * math.cos(math.radians(20.0)))
    z_1, z_2 = (z / (math.cos(beta_b) ** 2 * math.cos(beta)) for z in (23, wheel))
    theory = 1e9 / printed_q(z_1, 0.2, z_2 if wheel > 0 else None, 0.1)
    blank, moduli = GearBlank(0.4, 3.0), (206e9, 110e9)
    c_r, c_b = 1.0 + math.log(0.4) / (5.0 * math.exp(0.6)), 0.5 * (0.975 + 0.925)
    single = theory * 0.8 * c_r * c_b * math.cos(beta) * 0.5 * 2.0 / (1.0 / 206e9 + 1.0 / 110e9) / 206e9
    made = mesh_stiffness_iso6336(mesh, blank=blank, specific_load=6.25e3, elastic_moduli=moduli)
    assert (made.theoretical, made.single) == (near(theory), near(single))
    mean = single * (0.75 * mesh.transverse_contact_ratio + 0.25)
    assert (made.mesh, made.face) == (near(mean), near(0.85 * mean))
    usual = mesh_stiffness_iso6336(mesh)
    assert usual.single == near(theory * 0.8 * c_b * math.cos(beta))
    curve = mesh_curve_iso6336(mesh, made)
    assert curve.mean == near(mean * 20e-3)
    ends = (-mesh.approach / mesh.driver.base_pitch, mesh.recess / mesh.driver.base_pitch)
    same = rectangular_curve(single * 20e-3, ends, overlap=mesh.overlap_ratio, harmonics=8)
    assert curve.cosine == pytest.approx(same.cosine) and curve.sine == pytest.approx(same.sine)


@pytest.mark.parametrize(("helix", "shifts", "match"), [
    (46.0, (0.2, 0.1), "at most 45"), (0.0, (1.5, 0.6), "−0.5 to 2"), (0.0, (-0.2, -0.35), "−0.5 to 2"),
])  # fmt: skip
def test_what_clause_9_does_not_cover_is_refused(helix, shifts, match):
    with pytest.raises(DesignError, match=match):
        mesh_stiffness_iso6336(pair(60, 70, helix=helix, shifts=shifts))


def test_the_edges_of_clause_9_are_in_it():
    assert mesh_stiffness_iso6336(pair(60, 70, helix=45.0)).mesh > 0.0
    assert mesh_stiffness_iso6336(pair(60, 70, shifts=(-0.25, -0.24))).mesh > 0.0
    assert mesh_stiffness_iso6336(pair(60, 70, shifts=(1.0, 0.99))).mesh > 0.0


def test_a_curve_is_its_fourier_series():
    """k = 10 + 2 cos φ − cos 2φ + 3 sin φ + 0.5 sin 2φ; 2 Re c_n and −2 Im c_n."""
    curve = StiffnessCurve(10.0, (2.0, -1.0), (3.0, 0.5))
    phi = np.array([[0.3, 1.7], [2.9, 5.1]])
    expected = 10.0 + 2.0 * np.cos(phi) - np.cos(2.0 * phi) + 3.0 * np.sin(phi) + 0.5 * np.sin(2.0 * phi)
    assert stiffness_at(curve, phi) == pytest.approx(expected)
    assert curve_of(np.array([10.0, 1.0 - 1.5j, -0.5 - 0.25j]), "x") == StiffnessCurve(
        10.0, (2.0, -1.0), (3.0, 0.5), "x"
    )
    assert stiffness_at(StiffnessCurve(4.0), [0.0, 1.0]).tolist() == [4.0, 4.0]
    with pytest.raises(DesignError, match="must be positive"):
        StiffnessCurve(1.0, (0.0,) * 4 + (1.2,), (0.0,) * 5)
    assert StiffnessCurve(1.0, (0.0,) * 4 + (0.99,), (0.0,) * 5).mean == 1.0
    # A dip at 0.5 rad alone.
    dip = [tuple(-0.3 * wave(0.5 * n) for n in (1, 2, 3, 4)) for wave in (math.cos, math.sin)]
    with pytest.raises(DesignError, match=r"at mesh phase 0\.4|at mesh phase 0\.5"):
        StiffnessCurve(1.0, *dip)


@pytest.mark.parametrize("closed", [True, False])
def test_a_polygon_has_its_own_fourier_coefficients(closed):
    """(1/π) ∫ k cos nφ dφ by 2e5 rectangles."""
    x, y = [0.4, 1.1, 3.0, 4.6], [5.0, 9.0, 7.0, 6.0]
    end = ([*x, 0.4 + 2.0 * PI], [*y, 5.0])
    curve = sampled_curve(*(end if closed else (x, y)), harmonics=3, source="own")
    phi = 0.4 + 2.0 * PI * (np.arange(200000) + 0.5) / 200000
    k = np.interp(phi, *end)
    assert curve.mean == pytest.approx(k.mean(), rel=1e-8)
    for n in (1, 2, 3):
        assert curve.cosine[n - 1] == pytest.approx(2.0 * (k * np.cos(n * phi)).mean(), abs=1e-7)
        assert curve.sine[n - 1] == pytest.approx(2.0 * (k * np.sin(n * phi)).mean(), abs=1e-7)
    assert curve.source == "own"


def test_points_that_make_no_cycle_are_refused():
    for x, y, match in (
        ([0.0, 1.0], [1.0, 1.0], "at least 3"), ([0.0, 2.0, 1.0], [1.0] * 3, "increase"),
        ([0.0, 1.0, 7.0], [1.0] * 3, "one mesh cycle"), ([0.0, 1.0, 2.0 * PI], [1.0, 1.0, 2.0], "not periodic"),
        ([0.0, 1.0, 2.0], [1.0, -1.0, 2.0], "point 1"), ([0.0, 1.0, 2.0], [1.0, 1.0], "at least 3"),
    ):  # fmt: skip
        with pytest.raises(DesignError, match=match):
            sampled_curve(x, y, harmonics=2, source="x")


ENDS = (-0.62, 0.95)


def single_pair(place):
    """A stiffness over the path that has no symmetry."""
    return 3.0 + 0.8 * place - 1.1 * place**2


@pytest.mark.parametrize("overlap", [0.0, 0.35])
def test_pairs_pass_one_base_pitch_after_another(overlap):
    """The sum of shifted pairs, averaged over the lag of the slices across the face, transformed bluntly."""
    curve = pair_curve(ENDS, single_pair, overlap=overlap, harmonics=4, source="x")
    tau = (np.arange(40000) + 0.5) / 40000
    k = np.zeros_like(tau)
    lags = (np.arange(400) + 0.5) / 400 - 0.5 if overlap else np.zeros(1)
    for lag in lags * overlap:
        for shift in range(-3, 4):
            place = tau + lag + shift
            k += np.where((place >= ENDS[0]) & (place <= ENDS[1]), single_pair(place), 0.0) / len(lags)
    assert curve.mean == pytest.approx(k.mean(), rel=1e-4)
    for n in (1, 2, 3, 4):
        assert curve.cosine[n - 1] == pytest.approx(2.0 * (k * np.cos(2.0 * PI * n * tau)).mean(), abs=1e-3)
        assert curve.sine[n - 1] == pytest.approx(2.0 * (k * np.sin(2.0 * PI * n * tau)).mean(), abs=1e-3)
    assert curve.source == "x"


def test_the_series_of_a_pair_is_exact_for_a_polynomial():
    """∫ k(τ) dτ from −0.62 to 0.95 of 3 + 0.8 τ − 1.1 τ², to rounding."""
    curve = pair_curve(ENDS, single_pair, overlap=0.0, harmonics=2, source="x")
    start, end = ENDS
    exact = 3.0 * (end - start) + 0.4 * (end**2 - start**2) - 1.1 / 3.0 * (end**3 - start**3)
    assert curve.mean == near(exact)


def test_summed_pairs_jump_where_a_pair_enters_or_leaves():
    for turn in (-0.7, -0.5, 0.0, 0.1, 0.3, 0.37, 0.4, 0.9, 1.2):
        places = [turn + shift for shift in range(-4, 5) if ENDS[0] <= turn + shift <= ENDS[1]]
        expected = sum(single_pair(place) for place in places)
        assert summed_pairs(ENDS, single_pair, [2.0 * PI * turn]) == pytest.approx([expected])


@pytest.mark.parametrize(("step", "overlap"), [(0.75, 0.0), (0.6, 0.4)])
def test_two_levels_have_their_own_series(step, overlap):
    """c_n = k step/(2π i n) (e^(−2πi n a) − e^(−2πi n e)) sinc(n ε_β), mean k (1 − step + step ε_α)."""
    curve = rectangular_curve(7.0, ENDS, step=step, overlap=overlap, harmonics=3)
    assert curve.mean == near(7.0 * (1.0 - step + step * 1.57))
    for n in (1, 2, 3):
        sinc = math.sin(PI * n * overlap) / (PI * n * overlap) if overlap else 1.0
        scale = 7.0 * step * sinc / (PI * n)
        cosine = scale * (math.sin(2.0 * PI * n * ENDS[1]) - math.sin(2.0 * PI * n * ENDS[0]))
        sine = scale * (math.cos(2.0 * PI * n * ENDS[0]) - math.cos(2.0 * PI * n * ENDS[1]))
        assert curve.cosine[n - 1] == near(cosine) and curve.sine[n - 1] == near(sine)
    usual = rectangular_curve(7.0, ENDS)
    assert len(usual.sine) == 8 and usual.mean == near(7.0 * (0.25 + 0.75 * 1.57))


def test_contact_that_ends_too_early_is_refused():
    for refused in (
        lambda: pair_curve((-0.4, 0.5), single_pair, overlap=0.05, harmonics=1, source="x"),
        lambda: summed_pairs((-0.4, 0.5), single_pair, [0.0]),
        lambda: rectangular_curve(1.0, (-0.4, 0.5), overlap=0.05),
    ):
        with pytest.raises(DesignError, match="contact_ratio"):
            refused()
    assert rectangular_curve(1.0, (-0.4, 0.5), overlap=0.1, harmonics=1).mean == near(0.25 + 0.75 * 0.9)


CUBICS = (
    (3.867, 1.612, -0.02916, 0.0001553),
    (17.060, 0.7289, -0.01728, 0.0000993),
    (2.637, -1.222, 0.02217, -0.0001179),
    (-6.330, -1.033, 0.02068, -0.0001130),
)
"""Kuang & Yang 1992, A_0 to A_3."""


@pytest.mark.parametrize("teeth", [12, 31, 50])
def test_a_tooth_of_kuang_and_yang_is_four_cubics(teeth):
    a_0, a_1, a_2, a_3 = (sum(c * teeth**n for n, c in enumerate(cubic)) for cubic in CUBICS)
    expected = [1e9 * (a_0 + a_1 * 0.3 + (a_2 + a_3 * 0.3) * r / 1.3) for r in (-0.4, 0.0, 0.7)]
    assert tooth_stiffness_kuang_yang(teeth, [-0.4, 0.0, 0.7], 0.3) == pytest.approx(expected)
    assert tooth_stiffness_kuang_yang(teeth, 0.5) == near(1e9 * (a_0 + 0.5 * a_2))


def test_two_teeth_of_kuang_and_yang_are_springs_in_series():
    mesh = pair(25, 41)
    curve, pitch = mesh_stiffness_kuang_yang(mesh), mesh.driver.base_pitch

    def series(place):
        springs = []
        for at in np.atleast_1d(place):
            radii = contact_radii(mesh, float(at) * pitch)
            one, two = (
                float(tooth_stiffness_kuang_yang(z, (r - 1.5e-3 * z) / 3e-3, x))
                for z, r, x in zip((25, 41), radii, (0.2, 0.1), strict=True)
            )
            springs.append(20e-3 / (1.0 / one + 1.0 / two))
        return np.array(springs)

    ends = (-mesh.approach / pitch, mesh.recess / pitch)
    same = pair_curve(ends, series, overlap=0.0, harmonics=8, source="x")
    assert curve.mean == near(same.mean)
    assert curve.cosine == pytest.approx(same.cosine) and curve.sine == pytest.approx(same.sine)
    half = mesh_stiffness_kuang_yang(mesh, elastic_moduli=(103e9, 103e9))
    assert half.mean == near(0.5 * curve.mean)
    first, second = (
        mesh_stiffness_kuang_yang(mesh, elastic_moduli=moduli).mean for moduli in ((103e9, 206e9), (206e9, 103e9))
    )
    assert half.mean < first < curve.mean and half.mean < second < curve.mean
    for refused in (pair(25, 41, helix=10.0), pair(25, -81)):
        with pytest.raises(DesignError, match="external spur"):
            mesh_stiffness_kuang_yang(refused)
    for offset, shift in ((51, 0.0), (11, 0.0), (30, 0.65), (30, -0.65)):
        with pytest.raises(DesignError, match="fit holds"):
            tooth_stiffness_kuang_yang(offset, 0.0, shift)


def test_the_cut_square_wave_is_a_quarter_up_and_down():
    """K + K/π (sin φ + sin 3φ/3 + sin 5φ/5): ± K/4 with 4/π of the first harmonic."""
    curve = cut_square_wave(8.0)
    assert (curve.mean, curve.cosine) == (8.0, (0.0,) * 5)
    assert curve.sine == pytest.approx((8.0 / PI, 0.0, 8.0 / (3.0 * PI), 0.0, 8.0 / (5.0 * PI)))


SAINSOT = (
    (-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045),
    (60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086),
    (-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236),
    (-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904),
)
"""Sainsot, Velex & Duverger 2004, table 1: A/θ² + B h² + C h/θ + D/θ + E h + F."""


def by_hand(gear, radius):
    """Height, half thickness and angle of the force at a radius, and the root's chord and rise."""
    form, z = tooth_form(gear), abs(gear.teeth)
    base = abs(gear.base_radius)
    pressure = math.acos(base / radius)
    half = PI / (2.0 * z) + 2.0 * gear.profile_shift * math.tan(math.radians(20.0)) / z
    psi_b = half + gear.side * (math.tan(math.radians(20.0)) - math.radians(20.0))
    psi = psi_b - gear.side * (math.tan(pressure) - pressure)
    foot = form.root_radius * math.cos(form.root_half_angle)
    height = gear.side * (radius * math.cos(psi) - foot)
    return form, height, radius * math.sin(psi), pressure - gear.side * psi


@pytest.mark.parametrize("teeth", [37, -83])
@pytest.mark.parametrize("offset", [-0.3e-3, 0.9e-3])
def test_a_tooth_bends_shears_and_shortens_as_a_cantilever(teeth, offset):
    """∫ 12 M²/(E w³), 1.2 cos² α ∫ dx/(G w), sin² α ∫ dx/(E w) by 40000 slices of the outline; 3e-4 for the outline."""
    gear = CylindricalGear(teeth, 3e-3, 20e-3, profile_shift=0.1)
    radius = gear.pitch_radius + gear.side * offset
    form, height, half, angle = by_hand(gear, radius)
    x = (np.arange(40000) + 0.5) * height / 40000
    width = 2.0 * np.interp(x, form.height, form.half_thickness)
    moment = math.cos(angle) * (height - x) - math.sin(angle) * half
    step, shear = height / 40000, 110e9 / (2.0 * 1.33)
    made = tooth_compliance(form, np.array([radius]), material=LIGHT)
    assert made.bending[0] == pytest.approx(12.0 * (moment**2 / width**3).sum() * step / 110e9, rel=3e-4, abs=0.0)
    assert made.shear[0] == pytest.approx(
        1.2 * math.cos(angle) ** 2 * (1.0 / width).sum() * step / shear, rel=3e-4, abs=0.0
    )
    assert made.compression[0] == pytest.approx(
        math.sin(angle) ** 2 * (1.0 / width).sum() * step / 110e9, rel=3e-4, abs=0.0
    )
    assert made.total[0] == near(made.bending[0] + made.shear[0] + made.compression[0] + made.foundation[0])


@pytest.mark.parametrize("teeth", [37, -83])
def test_a_root_gives_by_odonnell_and_by_sainsot(teeth):
    """cos² α/E (5.306 r² + 2 (1 − ν) r + 1.534 (1 + 0.4167 tan² α/(1 + ν))); L*, M*, P*, Q* of table 1."""
    gear = CylindricalGear(teeth, 3e-3, 20e-3, profile_shift=0.1)
    radius = gear.pitch_radius + 0.4e-3
    form, height, half, angle = by_hand(gear, radius)
    chord = 2.0 * form.root_radius * math.sin(form.root_half_angle)
    rise = gear.side * form.root_radius * (1.0 - math.cos(form.root_half_angle))
    reach = (height - half * math.tan(angle) - rise) / chord
    axial = 1.534 * (1.0 + 0.4167 * math.tan(angle) ** 2 / 1.33)
    plane = math.cos(angle) ** 2 / 110e9 * (5.306 * reach**2 + 2.0 * 0.67 * reach + axial)
    assert half_plane_foundation(form, np.array([radius]), material=LIGHT)[0] == near(plane)
    assert tooth_compliance(form, np.array([radius]), material=LIGHT).foundation[0] == near(plane)
    if teeth < 0:
        with pytest.raises(DesignError, match="half plane"):
            held_body_foundation(form, np.array([radius]), material=LIGHT, bore_radius=20e-3)
        return
    theta, h = form.root_half_angle, form.root_radius / 20e-3
    terms = (theta**-2, h**2, h / theta, 1.0 / theta, h, 1.0)
    l_, m_, p_, q_ = (sum(c * t for c, t in zip(row, terms, strict=True)) for row in SAINSOT)
    held = math.cos(angle) ** 2 / 110e9 * (l_ * reach**2 + m_ * reach + p_ * (1.0 + q_ * math.tan(angle) ** 2))
    assert held_body_foundation(form, np.array([radius]), material=LIGHT, bore_radius=20e-3)[0] == near(held)
    assert tooth_compliance(form, np.array([radius]), material=LIGHT, bore_radius=20e-3).foundation[0] == near(held)
    for bore in (form.root_radius / 1.39, form.root_radius / 7.1):
        with pytest.raises(DesignError, match=r"1\.4 to 7"):
            held_body_foundation(form, np.array([radius]), material=LIGHT, bore_radius=bore)
    few = tooth_form(CylindricalGear(14, 3e-3, 20e-3, profile_shift=0.3))
    with pytest.raises(DesignError, match="half angle"):
        held_body_foundation(few, np.array([few.root_radius + 4e-3]), material=LIGHT, bore_radius=few.root_radius / 3.0)


@pytest.mark.parametrize("bores", [(None, None), (14e-3, 20e-3)])
def test_a_pair_is_two_teeth_and_a_contact_in_series(bores):
    """Yang & Sun: 2/π Σ (1 − ν²)/E; the cycle adds the pairs in contact over b cos β_b."""
    mesh = pair(29, 41)
    contact = 2.0 / PI * (0.91 / 206e9 + (1.0 - 0.33**2) / 110e9)
    assert contact_compliance(STEEL, LIGHT) == near(contact)
    places = np.array([-2e-3, 0.5e-3, 3e-3])
    made = pair_stiffness(mesh, places, materials=(STEEL, LIGHT), bore_radii=bores)
    for i, place in enumerate(places):
        radii = contact_radii(mesh, place)
        one, two = (
            tooth_compliance(tooth_form(gear), np.array([r]), material=m, bore_radius=b).total[0]
            for gear, r, m, b in zip((mesh.driver, mesh.driven), radii, (STEEL, LIGHT), bores, strict=True)
        )
        assert made.stiffness[i] == near(1.0 / (one + two + contact))
    pitch = mesh.driver.base_pitch
    start, end = -mesh.approach / pitch, mesh.recess / pitch

    def passing(place):
        return 20e-3 * pair_stiffness(mesh, place * pitch, materials=(STEEL, LIGHT), bore_radii=bores).stiffness

    curve = mesh_stiffness_energy(mesh, materials=(STEEL, LIGHT), bore_radii=bores, harmonics=3)
    same = pair_curve((start, end), passing, overlap=0.0, harmonics=3, source="x")
    assert curve.mean == near(same.mean) and curve.sine == pytest.approx(same.sine)
    cycle = mesh_cycle_energy(mesh, np.array([0.2, 2.5]), materials=(STEEL, LIGHT), bore_radii=bores)
    assert cycle == pytest.approx(summed_pairs((start, end), passing, [0.2, 2.5]))


def test_helical_teeth_bend_in_their_normal_section():
    """Radii move to the equivalent spur gear at equal height; width b cos β_b; slices lag by ε_β."""
    mesh = pair(29, 41, helix=15.0)
    beta_b = mesh.driver.base_helix_angle
    place = np.array([0.4e-3])
    made = pair_stiffness(mesh, place, materials=(STEEL, STEEL))
    compliance = contact_compliance(STEEL, STEEL)
    for gear, radius in zip((mesh.driver, mesh.driven), contact_radii(mesh, 0.4e-3), strict=True):
        virtual = gear.teeth / (math.cos(beta_b) ** 2 * math.cos(gear.helix_angle))
        moved = radius - gear.pitch_radius + virtual * 3e-3 / 2.0
        compliance += tooth_compliance(tooth_form(gear), np.array([moved]), material=STEEL).total[0]
    assert made.stiffness[0] == near(1.0 / compliance)
    pitch = mesh.driver.base_pitch

    def passing(at):
        return 20e-3 * math.cos(beta_b) * pair_stiffness(mesh, at * pitch, materials=(STEEL, STEEL)).stiffness

    ends = (-mesh.approach / pitch, mesh.recess / pitch)
    same = pair_curve(ends, passing, overlap=mesh.overlap_ratio, harmonics=8, source="x")
    curve = mesh_stiffness_energy(mesh, materials=(STEEL, STEEL))
    assert curve.mean == near(same.mean) and curve.sine == pytest.approx(same.sine)
    with pytest.raises(DesignError, match="no jumps"):
        mesh_cycle_energy(mesh, np.array([0.2]), materials=(STEEL, STEEL))


def test_more_teeth_are_stiffer_in_every_fit():
    """A check of order, not of numbers: q′ falls with z."""
    for less, more in pairwise((20.0, 30.0, 50.0, 90.0)):
        assert theoretical_stiffness((less, 100.0)) < theoretical_stiffness((more, 100.0))
