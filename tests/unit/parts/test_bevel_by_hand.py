"""Bevel gears by ISO 10300 and ISO 23509, formula by formula, once more by hand: straight, low and full spirals."""

import math
from dataclasses import dataclass, replace

import pytest

from gearwright.errors import DesignError
from gearwright.parts.bevel_geometry import (
    BevelPair,
    BevelTooth,
    Hand,
    Rotation,
    bevel_forces,
    cone_forces,
    gleason_profile_shift,
)
from gearwright.parts.iso6336 import (
    GearSteel,
    LoadedTooth,
    ToothLoadFactors,
    ToothProportions,
    Treatment,
    bending_size_factor,
    lubricant_factor,
    notch_sensitivity_factor,
    root_section,
    roughness_factor,
    speed_factor,
    surface_factor,
)
from gearwright.parts.iso10300 import (
    BOTH_OVERHUNG,
    LOW_CROWNING,
    ONE_OVERHUNG,
    STRADDLE,
    BevelDuty,
    BevelSurfaces,
    VirtualPair,
    bevel_bending,
    bevel_dynamics,
    bevel_load_factors,
    bevel_pitch_tolerance,
    bevel_pitting,
    contact_ratio_factor_bending,
    mid_zone_factor,
    rate_bevel,
    spiral_angle_factor,
    tip_loaded_section,
    virtual_force,
)

TOOTH = BevelTooth(1.0, 1.25, 0.2, (0.05, -0.03), (0.3, 0.25))
STRAIGHT = BevelPair((17, 43), 4e-3, 28e-3, 0.0, math.radians(22.0), math.radians(80.0), TOOTH)
LOW = BevelPair((17, 43), 4e-3, 22e-3, math.radians(12.0), math.radians(20.0), math.pi / 2.0, TOOTH)
SPIRAL = BevelPair((15, 46), 8.5e-3, 51e-3, math.radians(35.0), math.radians(20.0), math.pi / 2.0, TOOTH)
MIDDLE = BevelPair((17, 43), 4e-3, 29e-3, math.radians(20.0), math.radians(20.0), math.radians(100.0), TOOTH)
JUST = replace(MIDDLE, spiral_angle=math.radians(27.0))
"""Just above an overlap of 1."""
SHORT = replace(STRAIGHT, tooth=replace(TOOTH, addendum=0.7))
"""Short teeth: ε_vγ below 1.5."""
PAIRS = pytest.mark.parametrize("pair", [STRAIGHT, LOW, MIDDLE, JUST, SPIRAL])
HARD = GearSteel("hard", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 461e6, 206e9, 0.3)
OTHER = GearSteel("other", Treatment.NITRIDED, "MQ", 650.0, 1100e6, 400e6, 200e9, 0.29)


def near(value):
    return pytest.approx(value, rel=1e-9, abs=0.0)


@dataclass(frozen=True)
class Hand10300:
    """Cones and virtual gears of ISO 10300-1, annex A, without offset."""

    pair: BevelPair
    exponent: float = 1.5

    def __getattr__(self, name):
        p = self.pair
        (z_1, z_2), sigma, beta, alpha = p.teeth, p.shaft_angle, p.spiral_angle, p.pressure_angle
        delta_1 = math.atan(math.sin(sigma) / (math.cos(sigma) + z_2 / z_1))
        delta = (delta_1, sigma - delta_1)
        r_e = z_1 * p.outer_module / (2.0 * math.sin(delta_1))
        r_m = r_e - p.face_width / 2.0
        d_m = tuple(z * p.outer_module * r_m / r_e for z in p.teeth)
        m_mn = p.outer_module * math.cos(beta) * r_m / r_e
        alpha_vt = math.atan(math.tan(alpha) / math.cos(beta))
        beta_vb = math.asin(math.sin(beta) * math.cos(alpha))
        d_v = tuple(d / math.cos(angle) for d, angle in zip(d_m, delta, strict=True))
        d_vb = tuple(d * math.cos(alpha_vt) for d in d_v)
        x = (p.tooth.profile_shift, -p.tooth.profile_shift)
        d_va = tuple(d + 2.0 * (p.tooth.addendum + s) * m_mn for d, s in zip(d_v, x, strict=True))
        z_v = tuple(z / math.cos(angle) for z, angle in zip(p.teeth, delta, strict=True))
        g = sum(math.sqrt(a**2 - b**2) / 2.0 for a, b in zip(d_va, d_vb, strict=True))
        g -= sum(d_v) / 2.0 * math.sin(alpha_vt)
        p_vet = math.pi * m_mn * math.cos(alpha_vt) / math.cos(beta)
        b_eff = 0.85 * p.face_width
        e_a, e_b = g / p_vet, b_eff * math.sin(beta) / (math.pi * m_mn)
        rho_t = 1.0 / sum(2.0 / (d * math.sin(alpha_vt)) for d in d_v)
        known = {
            "delta": delta, "r_e": r_e, "r_m": r_m, "d_m": d_m, "m_mn": m_mn, "alpha_vt": alpha_vt, "beta_vb": beta_vb,
            "d_v": d_v, "d_vb": d_vb, "d_va": d_va, "z_v": z_v, "g": g, "p_vet": p_vet, "b_eff": b_eff, "e_a": e_a,
            "e_b": e_b, "rho": rho_t / math.cos(beta_vb), "x": x,
            "z_vn": tuple(z / (math.cos(beta_vb) ** 2 * math.cos(beta)) for z in z_v),
        }  # fmt: skip
        if name not in known:
            raise AttributeError(name)
        return known[name]

    def line(self, f):
        """Length and peak of the contact line at f: the part of a straight line within the zone, g by b_eff."""
        beta, half, width = self.beta_vb, self.g / 2.0, self.b_eff
        reach = (self.g + width * math.tan(beta)) * math.cos(beta) / 2.0
        part = min(abs(f) / reach, 1.0)
        inside = width
        if beta:
            # Along the face, y runs from −b/2 to b/2; the line lies at x = (f − y sin β)/cos β, inside where |x| ≤ g/2.
            ends = sorted(((f - half * math.cos(beta)) / math.sin(beta), (f + half * math.cos(beta)) / math.sin(beta)))
            inside = max(min(ends[1], width / 2.0) - max(ends[0], -width / 2.0), 0.0) / math.cos(beta)
        length = inside * (1.0 - (1.0 - math.sqrt(0.85)) * math.sqrt(1.0 - part**2))
        return length, 1.0 - part**self.exponent

    @property
    def lines(self):
        """Tip, middle and root, table A.2."""
        step = self.p_vet * math.cos(self.beta_vb)
        middle = -step * (1.0 - self.e_a / 2.0) * (1.0 - self.e_b) if self.e_b < 1.0 else 0.0
        return [self.line(middle + shift * step) for shift in (1.0, 0.0, -1.0)]


def test_the_pairs_reach_every_range_of_overlap():
    ratios = [Hand10300(pair).e_b for pair in (STRAIGHT, LOW, MIDDLE, SPIRAL)]
    assert ratios[0] == 0.0 < ratios[1] < ratios[2] < 1.0 < ratios[3]
    assert Hand10300(SHORT).e_a < 1.5 < Hand10300(STRAIGHT).e_a
    totals = [hand.e_a + hand.e_b for hand in map(Hand10300, (LOW, MIDDLE, SPIRAL))]
    assert 1.5 < totals[0] < 2.0 < totals[1] < 2.5 < totals[2]


@PAIRS
def test_cones_and_virtual_gears_are_those_of_annex_a(pair):
    hand, virtual = Hand10300(pair), VirtualPair(pair)
    assert pair.pitch_angles == pytest.approx(hand.delta)
    assert pair.outer_diameters == pytest.approx([z * pair.outer_module for z in pair.teeth])
    assert (pair.outer_cone_distance, pair.mean_cone_distance) == (near(hand.r_e), near(hand.r_m))
    assert pair.mean_diameters == pytest.approx(hand.d_m) and pair.mean_module == near(hand.m_mn)
    assert pair.addenda == pytest.approx((1.2 * hand.m_mn, 0.8 * hand.m_mn))
    assert pair.dedenda == pytest.approx((1.05 * hand.m_mn, 1.45 * hand.m_mn))
    assert virtual.diameters == pytest.approx(hand.d_v) and virtual.base_diameters == pytest.approx(hand.d_vb)
    assert virtual.tip_diameters == pytest.approx(hand.d_va)
    assert (virtual.transverse_angle, virtual.base_helix_angle) == (near(hand.alpha_vt), near(hand.beta_vb))
    assert virtual.teeth == pytest.approx(hand.z_v) and virtual.normal_teeth == pytest.approx(hand.z_vn)
    assert (virtual.base_pitch, virtual.path) == (near(hand.p_vet), near(hand.g))
    assert (virtual.effective_width, virtual.profile_ratio) == (near(hand.b_eff), near(hand.e_a))
    assert virtual.face_ratio == pytest.approx(hand.e_b)
    assert virtual.total_ratio == near(hand.e_a + hand.e_b)
    assert virtual.curvature == near(hand.rho)


@PAIRS
@pytest.mark.parametrize("exponent", [1.5, LOW_CROWNING])
def test_contact_lines_and_their_shares_are_those_of_the_zone(pair, exponent):
    """ISO 10300-1, table A.2 and eqs A.26 to A.36; Z_LS of part 2, eqs 7 to 10; e_LS = 1.5 and 3."""
    virtual = VirtualPair(pair, exponent)
    lines = Hand10300(pair, exponent).lines
    for line, (length, peak) in zip(virtual.lines, lines, strict=True):
        assert line.length == pytest.approx(length, rel=1e-9, abs=1e-12)
        assert line.peak == pytest.approx(peak, rel=1e-9, abs=1e-12)
    areas = [length * peak for length, peak in lines]
    assert virtual.load_sharing == near(math.sqrt(areas[1] / sum(areas)))
    assert LOW_CROWNING == 3.0 and VirtualPair(pair).peak_exponent == 1.5
    assert VirtualPair(pair).load_sharing == near(VirtualPair(pair, 1.5).load_sharing)


@PAIRS
def test_mid_zone_contact_ratio_and_spiral_factors_are_the_printed_ones(pair):
    """Part 2, eq. 6 and table 4; part 3, eqs 27 to 35."""
    hand, virtual = Hand10300(pair), VirtualPair(pair)
    e_a, e_b = hand.e_a, hand.e_b
    f_1, f_2 = (2.0 + (e_a - 2.0) * e_b, 2.0 * e_a - 2.0 + (2.0 - e_a) * e_b) if e_b < 1.0 else (e_a, e_a)
    product = math.prod(
        math.sqrt((a / b) ** 2 - 1.0) - f * math.pi / z
        for a, b, f, z in zip(hand.d_va, hand.d_vb, (f_1, f_2), hand.z_v, strict=True)
    )
    assert mid_zone_factor(virtual) == near(math.tan(hand.alpha_vt) / math.sqrt(product))
    spur = 0.25 + 0.75 / e_a
    expected = 0.625 if e_b >= 1.0 else spur - e_b * (spur - 0.625)
    assert contact_ratio_factor_bending(virtual) == near(expected)
    if not e_b:
        assert spiral_angle_factor(virtual) == 1.0
        return
    width = pair.face_width / math.cos(pair.spiral_angle)
    covered = hand.lines[1][0] * math.cos(hand.beta_vb) / math.cos(pair.spiral_angle)
    x = width / (2.25 * hand.m_mn)
    a = -0.0182 * x**2 + 0.4736 * x - 0.32
    b = -0.0032 * x**2 + 0.0526 * x + 0.712
    c = -0.0050 * x**2 + 0.0850 * x + 0.54
    assert spiral_angle_factor(virtual) == near(a / c * (covered / width - 1.05 * b) ** 2 + 1.0)


@pytest.mark.parametrize("gear", [0, 1])
def test_the_root_of_a_bevel_tooth_is_loaded_at_its_tip(gear):
    """Part 3, eqs 6 to 26: z_vn, d_van = z_vn + 2 (k + x), the own edge radius and thickness shift."""
    hand = Hand10300(SPIRAL)
    x = hand.x[gear]
    z = hand.z_vn[gear]
    tooth = ToothProportions(1.25, TOOTH.edge_radii[gear], x)
    loaded = LoadedTooth(z, z + 2.0 * (1.0 + x), SPIRAL.pressure_angle, tooth, TOOTH.thickness_shifts[gear])
    section = tip_loaded_section(VirtualPair(SPIRAL), gear)
    assert tuple(vars(section).values()) == pytest.approx(tuple(vars(root_section(loaded)).values()), rel=1e-9)


@PAIRS
@pytest.mark.parametrize(("hand", "rotation", "sign"), [
    (Hand.LEFT, Rotation.CLOCKWISE, 1.0), (Hand.RIGHT, Rotation.CLOCKWISE, -1.0),
    (Hand.LEFT, Rotation.COUNTERCLOCKWISE, -1.0), (Hand.RIGHT, Rotation.COUNTERCLOCKWISE, 1.0),
])  # fmt: skip
def test_forces_are_those_of_iso_23509(pair, hand, rotation, sign):
    """F_a = F/cos β (tan α sin δ ± sin β cos δ), F_r = F/cos β (tan α cos δ ∓ sin β sin δ)."""
    by_hand = Hand10300(pair)
    force = 2.0 * 150.0 / by_hand.d_m[0]
    made = bevel_forces(pair, 150.0, hand=hand, rotation=rotation)
    assert made.tangential == near(force)
    scale, tangent, lean = (
        force / math.cos(pair.spiral_angle),
        math.tan(pair.pressure_angle),
        math.sin(pair.spiral_angle),
    )
    for gear, pushed in ((0, sign), (1, -sign)):
        delta = by_hand.delta[gear]
        axial = scale * (tangent * math.sin(delta) + pushed * lean * math.cos(delta))
        radial = scale * (tangent * math.cos(delta) - pushed * lean * math.sin(delta))
        assert made.axial[gear] == pytest.approx(axial) and made.radial[gear] == pytest.approx(radial)
    pushed = cone_forces(force, by_hand.delta[0], pressure_angle=pair.pressure_angle, spiral_angle=pair.spiral_angle)
    assert pushed[0] == pytest.approx(
        scale * (tangent * math.sin(by_hand.delta[0]) + lean * math.cos(by_hand.delta[0]))
    )


def printed_k_v(ratio, error, total):
    """Part 1, eqs 15 to 21, with the table of c_v over ε_vγ."""
    if total <= 2.0:
        c_12, c_3, c_4, c_56 = 0.66, 0.23, 0.90, 0.94
    else:
        c_12, c_3 = 0.32 + 0.57 / (total - 0.3), 0.096 / (total - 1.56)
        c_4, c_56 = (0.57 - 0.05 * total) / (total - 1.44), 0.47 + 0.12 / (total - 1.74)
    c_7 = 0.75 if total <= 1.5 else 0.125 * math.sin(math.pi * (total - 2.0)) + 0.875 if total <= 2.5 else 1.0
    resonant, above = c_12 * error + c_4 + 1.0, c_56 * error + c_7
    if ratio <= 0.75:
        return 1.0 + ratio * (c_12 * error + c_3)
    if ratio <= 1.25:
        return resonant
    return above if ratio >= 1.5 else above + (resonant - above) / 0.25 * (1.5 - ratio)


@pytest.mark.parametrize("pair", [STRAIGHT, LOW, MIDDLE, JUST, SPIRAL, SHORT])
@pytest.mark.parametrize("ratio", [0.5, 0.74, 0.8, 1.2, 1.3, 1.45, 1.55, 2.0])
@pytest.mark.parametrize(("deviation", "load"), [(8e-6, 250e3), (60e-6, 40e3)])
def test_k_v_and_the_load_factors_are_those_of_clauses_7_to_9(pair, ratio, deviation, load):
    """c_γ = 20 and c′ = 14 N/(mm µm) E/210 GPa, less below 100 N/mm; y_α = 0.075 f_pt to 3 µm; K_Hβ = 1.5 K_Hβ-be."""
    hand = Hand10300(pair)
    torque = load * hand.b_eff / 1.25 * hand.d_m[0] / 2.0
    masses = [math.pi / 8.0 * 7700.0 * d**2 / math.cos(pair.pressure_angle) ** 2 for d in hand.d_m]
    mass, light = 1.0 / (1.0 / masses[0] + 1.0 / masses[1]), min(1.0, load / 100e3)
    speed = -ratio * math.sqrt(20e9 * 206.0 / 210.0 * light / mass) / pair.teeth[0]
    duty = BevelDuty(torque, speed, deviation, 1.25, 1.05, 0.4 * hand.r_m)
    steels = (replace(HARD, density=7700.0, elastic_modulus=206e9),) * 2
    soft = 206.0 / 210.0
    left = deviation - min(0.075 * deviation, 3e-6)
    total = hand.e_a + hand.e_b
    k_v = printed_k_v(ratio, 14e9 * soft * light * left / load, total)
    made = bevel_dynamics(VirtualPair(pair), duty, steels)
    assert (made.reduced_mass, made.resonance_ratio) == (near(mass), near(ratio))
    assert (made.pitch_deviation, made.factor) == (near(left), near(k_v))
    assert virtual_force(pair, duty) == near(2.0 * torque / hand.d_m[0])
    factors, dynamic = bevel_load_factors(VirtualPair(pair), duty, steels)
    assert dynamic == made
    error = 20e9 * soft * light * left / (load * 0.85 * k_v * 1.5 * 1.05)
    share = (
        0.5 * total * (0.9 + 0.4 * error)
        if total <= 2.0
        else 0.9 + 0.4 * math.sqrt(2.0 * (total - 1.0) / total) * error
    )
    lengthwise = 1.0
    if pair.spiral_angle:
        lengthwise = 0.211 * 0.4 ** (0.279 / math.log10(math.sin(pair.spiral_angle))) + 0.789
        lengthwise = min(max(lengthwise, 1.0), 1.15)
    assert (factors.application, factors.mesh_load, factors.dynamic) == (1.25, 1.0, near(k_v))
    assert factors.face_contact == near(1.575) and factors.face_bending == near(1.575 / lengthwise)
    assert factors.transverse_contact == factors.transverse_bending == near(max(share, 1.0))


def test_a_cutter_bends_teeth_lengthwise_up_to_fifteen_per_cent():
    """K_F0 of eqs 33 to 35: 1.15 for a small cutter, 1 above the mean cone distance, and the formula between."""
    r_m = Hand10300(SPIRAL).r_m
    exponent = 0.279 / math.log10(math.sin(math.radians(35.0)))
    for cutter, expected in ((0.2, 1.15), (0.9, 0.211 * 0.9**exponent + 0.789), (1.05, 1.0), (math.inf, 1.0)):
        duty = BevelDuty(2000.0, 150.0, 8e-6, cutter_radius=cutter * r_m)
        factors, _ = bevel_load_factors(VirtualPair(SPIRAL), duty, (HARD, HARD))
        assert factors.face_contact / factors.face_bending == near(expected)
    assert (STRADDLE, ONE_OVERHUNG, BOTH_OVERHUNG) == (1.05, 1.10, 1.25)
    usual = BevelDuty(2000.0, 150.0, 8e-6)
    assert (usual.application_factor, usual.mounting, usual.cutter_radius) == (1.0, 1.10, math.inf)


@PAIRS
def test_pitting_is_the_product_of_part_2(pair):
    """σ_H0 = √(F_n/(l_bm ρ_rel)) Z_M-B Z_LS Z_E; σ_HP = σ_Hlim Z_NT Z_L Z_v Z_R 1.2."""
    hand, virtual = Hand10300(pair), VirtualPair(pair)
    duty, loads = BevelDuty(180.0, -220.0, 8e-6), ToothLoadFactors(1.25, 1.0, 1.1, 1.6, 1.2, 1.5, 1.2)
    force = 360.0 / hand.d_m[0] / (math.cos(pair.pressure_angle) * math.cos(pair.spiral_angle))
    compliance = 0.91 / 206e9 + (1.0 - 0.29**2) / 200e9
    nominal = math.sqrt(force / (hand.lines[1][0] * hand.rho)) * mid_zone_factor(virtual) * virtual.load_sharing
    nominal *= math.sqrt(1.0 / (math.pi * compliance))
    stress = nominal * math.sqrt(1.25 * 1.1 * 1.6 * 1.2)
    speed = 110.0 * hand.d_m[0]
    for given, viscosity, rough in (({}, 100e-6, 8e-6), ({"viscosity": 200e-6, "roughness": 3e-6}, 200e-6, 3e-6)):
        made = bevel_pitting(virtual, (HARD, OTHER), duty, loads=loads, lives=(0.9, 0.95), **given)
        film = (lubricant_factor(viscosity, 1100e6), speed_factor(speed, 1100e6))
        film = (*film, roughness_factor(rough, hand.rho, 1100e6))
        assert made.film == pytest.approx(film)
        assert (made.nominal_stress, made.stress) == (near(nominal), near(stress))
        limits = (1500e6 * 0.9 * math.prod(film) * 1.2, 1100e6 * 0.95 * math.prod(film) * 1.2)
        assert made.permissible == pytest.approx(limits)
        assert made.safeties == pytest.approx((limits[0] / stress, limits[1] / stress))


@PAIRS
@pytest.mark.parametrize("gear", [0, 1])
def test_bending_is_the_product_of_part_3(pair, gear):
    """σ_F0 = F/(b m_mn) Y_Fa Y_Sa Y_ε Y_BS Z_LS²; σ_FP = σ_Flim 2 Y_NT Y_δ Y_R Y_X."""
    hand, virtual = Hand10300(pair), VirtualPair(pair)
    duty, loads = BevelDuty(180.0, 220.0, 8e-6), ToothLoadFactors(1.25, 1.0, 1.1, 1.6, 1.2, 1.5, 1.3)
    section = tip_loaded_section(virtual, gear)
    nominal = 360.0 / hand.d_m[0] / (pair.face_width * hand.m_mn) * section.form * section.stress_correction
    nominal *= contact_ratio_factor_bending(virtual) * spiral_angle_factor(virtual) * virtual.load_sharing**2
    stress = nominal * 1.25 * 1.1 * 1.5 * 1.3
    for given, rough in (({}, 16e-6), ({"roughness": 5e-6}, 5e-6)):
        made = bevel_bending(virtual, gear, OTHER, duty=duty, loads=loads, life=0.9, **given)
        assert (made.nominal_stress, made.stress) == (near(nominal), near(stress))
        assert (made.section.form, made.load_sharing) == (near(section.form), near(virtual.load_sharing**2))
        assert (made.contact_ratio, made.spiral) == (
            near(contact_ratio_factor_bending(virtual)),
            near(spiral_angle_factor(virtual)),
        )
        limit = 400e6 * 2.0 * 0.9 * notch_sensitivity_factor(section.notch, OTHER)
        limit *= surface_factor(rough, Treatment.NITRIDED) * bending_size_factor(hand.m_mn, Treatment.NITRIDED)
        assert (made.permissible, made.safety) == (near(limit), near(limit / stress))


def test_a_rating_hands_on_surfaces_lives_and_cycles():
    """Turns of the pinion and of the wheel; flanks and roots with their own roughness; 4 and 10 µm, 100 mm²/s."""
    duty, surfaces = BevelDuty(1800.0, -150.0, 8e-6, 1.25), BevelSurfaces(3e-6, 7e-6, 220e-6, 3.0)
    rated = rate_bevel(SPIRAL, (HARD, OTHER), duty, 4e6, surfaces=surfaces)
    virtual, turns = VirtualPair(SPIRAL, 3.0), 150.0 * 4e6 / (2.0 * math.pi)
    assert rated.cycles == pytest.approx((turns, turns * 15.0 / 46.0))
    assert rated.speed == near(75.0 * SPIRAL.mean_diameters[0])
    assert rated.tangential_force == near(3600.0 / SPIRAL.mean_diameters[0])
    loads, _ = bevel_load_factors(virtual, duty, (HARD, OTHER))
    pitting = bevel_pitting(virtual, (HARD, OTHER), duty, loads=loads, lives=rated.contact_life,
                            viscosity=220e-6, roughness=3e-6)  # fmt: skip
    assert rated.pitting == pitting
    for gear, steel in enumerate((HARD, OTHER)):
        root = bevel_bending(virtual, gear, steel, duty=duty, loads=loads, life=rated.root_life[gear], roughness=7e-6)
        assert rated.bending[gear].safety == near(root.safety)
    usual = rate_bevel(SPIRAL, (HARD, OTHER), duty, 4e6)
    same = rate_bevel(SPIRAL, (HARD, OTHER), duty, 4e6, surfaces=BevelSurfaces(4e-6, 10e-6, 100e-6, 1.5))
    assert usual.pitting.safeties == same.pitting.safeties
    assert usual.bending[0].safety == same.bending[0].safety
    # Z_NT of ISO 6336-2, table 2: 1.6 at 1e5, 1 at 5e7, 0.85 at 1e10; nitrided 1.3, 1 at 2e6.
    first = 0.85 ** (math.log(turns / 5e7) / math.log(200.0))
    second = 0.85 ** (math.log(turns * 15.0 / 46.0 / 2e6) / math.log(5000.0))
    assert rated.contact_life == pytest.approx((first, second))
    roots = [0.85 ** (math.log(n / 3e6) / math.log(1e10 / 3e6)) for n in rated.cycles]
    assert rated.root_life == pytest.approx(tuple(roots))


def test_shift_and_pitch_tolerance_are_the_printed_ones():
    """ISO 23509, C.3.2.3: 2 (½ − 0.210 − 0.290/u²); ISO 17485: (0.003 d + 0.3 m + 5) √2^(B − 4)."""
    assert gleason_profile_shift((15, 45)) == near(2.0 * (0.29 - 0.29 / 9.0))
    assert bevel_pitch_tolerance(0.2, 4e-3, 4) == near(6.8e-6)
    assert bevel_pitch_tolerance(0.2, 4e-3, 7) == near(6.8e-6 * math.sqrt(8.0))


def test_spirals_lean_up_to_45_degrees():
    assert replace(SPIRAL, spiral_angle=math.pi / 4.0).spiral_angle == math.pi / 4.0
    with pytest.raises(DesignError, match="from 0 to 45"):
        replace(SPIRAL, spiral_angle=math.radians(46.0))


def test_a_pair_is_straight_at_right_angles_if_nothing_else_is_said():
    """20°, ISO 23509's tooth of 1 and 1.25, edges of 0.3."""
    pair = BevelPair((20, 40), 4e-3, 20e-3)
    assert (pair.spiral_angle, pair.shaft_angle, math.degrees(pair.pressure_angle)) == (0.0, math.pi / 2.0, near(20.0))
    assert pair.tooth == BevelTooth(1.0, 1.25, 0.0, (0.0, 0.0), (0.3, 0.3))
    assert pair.pitch_angles[0] == near(math.atan(0.5))
    assert pair.addenda[0] == near(pair.mean_module) and pair.dedenda[1] == near(1.25 * pair.mean_module)
    assert VirtualPair(pair).base_helix_angle == 0.0


@pytest.mark.parametrize(("teeth", "width", "limit"), [((17, 43), 31e-3, None), ((30, 60), 40.1e-3, "40 mm")])
def test_a_face_is_a_third_of_the_cone_or_ten_modules(teeth, width, limit):
    """ISO 23509, annex B: R_e/3 = 30.83 mm of 17/43 at 4 mm; 10 m_et = 40 mm of 30/60."""
    cone = 2e-3 * math.hypot(*teeth)
    least = min(cone / 3.0, 40e-3)
    assert BevelPair(teeth, 4e-3, least).face_width == least
    with pytest.raises(DesignError, match=f"use at most {1e3 * least:.4g} mm"):
        BevelPair(teeth, 4e-3, max(width, least * 1.0001))
    assert limit is None or f"{1e3 * least:.4g} mm" == limit


@pytest.mark.parametrize("gear", [0, 1])
def test_a_pair_may_be_shifted_as_far_as_its_virtual_rack_does_not_undercut(gear):
    """x ≥ k_hfp − ρ (1 − sin α) − z_v sin² α_t/(2 cos β), pinion and wheel."""
    base = replace(SPIRAL, teeth=(12, 14) if gear else (9, 40), outer_module=8e-3, face_width=20e-3)
    angles = [math.atan2(base.teeth[0], base.teeth[1])]
    angles.append(math.pi / 2.0 - angles[0])
    alpha_t = math.atan(math.tan(math.radians(20.0)) / math.cos(base.spiral_angle))
    z_v = base.teeth[gear] / math.cos(angles[gear])
    straight = 1.25 - TOOTH.edge_radii[gear] * (1.0 - math.sin(math.radians(20.0)))
    least = straight - z_v * math.sin(alpha_t) ** 2 / (2.0 * math.cos(base.spiral_angle))
    sign = -1.0 if gear else 1.0
    good = replace(base, tooth=replace(TOOTH, profile_shift=sign * (least + 1e-6)))
    assert good.teeth == base.teeth
    with pytest.raises(DesignError, match=f"x_hm{gear + 1} = "):
        replace(base, tooth=replace(TOOTH, profile_shift=sign * (least - 1e-6)))
