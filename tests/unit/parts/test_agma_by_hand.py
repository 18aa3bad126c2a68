"""AGMA 2001 and 908 by their printed constants and by geometry: J and I once more, by a rolled rack and by radii."""

import math
from itertools import pairwise

import numpy as np
import pytest

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
    BENDING_HB160,
    BENDING_HB250,
    BENDING_HB400,
    BENDING_NITRIDED,
    COMMERCIAL,
    EXTRA_PRECISION,
    OPEN_GEARING,
    PITTING,
    PITTING_NITRIDED,
    PRECISION,
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
    size_factor,
)
from gearwright.parts.iso6336 import life_factor

INCH, PSI = 0.0254, 6894.757293168361
PI = math.pi


def near(value):
    return pytest.approx(value, rel=1e-9, abs=0.0)


def test_dynamics_size_and_rim_follow_their_formulas():
    """A = 50 + 56 (1 − B), B = ¼ (12 − Q)^⅔, V in ft/min; 1.192 (F √Y/P)^0.0535 in inches; 1.6 ln(2.242/m_B)."""
    for quality, metres in ((6.0, 5.0), (9.5, 22.0)):
        b = 0.25 * (12.0 - quality) ** (2.0 / 3.0)
        a = 50.0 + 56.0 * (1.0 - b)
        feet = metres * 60.0 / 0.3048
        assert dynamic_factor_agma(metres, quality) == near(((a + math.sqrt(feet)) / a) ** b)
    assert size_factor(3.0 * INCH, INCH / 5.0, 0.36) == near(1.192 * (3.0 * 0.6 / 5.0) ** 0.0535)
    assert size_factor(0.1 * INCH, INCH / 20.0, 0.25) == 1.0
    assert rim_factor_agma(0.9) == near(1.6 * math.log(2.242 / 0.9))
    assert rim_factor_agma(1.3) == 1.0


MOUNTINGS = [
    (OPEN_GEARING, 0.247, 0.0167, -0.765e-4),
    (COMMERCIAL, 0.127, 0.0158, -1.093e-4),
    (PRECISION, 0.0675, 0.0128, -0.926e-4),
    (EXTRA_PRECISION, 0.0380, 0.0102, -0.822e-4),
]
"""AGMA 2001-D04, table 2; 2101-D04 prints C as −1.19, −1.69, −1.44 and −1.27e-7 per mm², the same over 25.4²."""


@pytest.mark.parametrize(("mounting", "a", "b", "c"), MOUNTINGS)
@pytest.mark.parametrize("inches", [0.8, 1.2, 6.0, 20.0])
@pytest.mark.parametrize("slender", [0.3, 0.9])
def test_the_load_distribution_is_that_of_clause_15(mounting, a, b, c, inches, slender):
    """1 + C_mc (C_pf C_pm + C_ma C_e); C_pf in three ranges of F, F/(10 d) at least 0.05."""
    proportion = max(slender / 10.0, 0.05) + (
        -0.025 if inches <= 1.0 else -0.0375 + 0.0125 * inches if inches <= 17.0
        else -0.1109 + 0.0207 * inches - 0.000228 * inches**2
    )  # fmt: skip
    alignment = a + b * inches + c * inches**2
    width, diameter = inches * INCH, inches * INCH / slender
    made = load_distribution_factor(width, diameter, mounting=mounting, crowning=0.8, offset=1.1, adjustment=0.9)
    assert made == near(1.0 + 0.8 * (proportion * 1.1 + alignment * 0.9))
    assert load_distribution_factor(width, diameter, mounting=mounting) == near(1.0 + proportion + alignment)
    usual = 0.127 + 0.0158 * inches - 1.093e-4 * inches**2
    assert load_distribution_factor(width, diameter) == near(1.0 + proportion + usual)
    metric = {OPEN_GEARING: -1.19, COMMERCIAL: -1.69, PRECISION: -1.44, EXTRA_PRECISION: -1.27}
    assert c / 25.4**2 == pytest.approx(metric[mounting] * 1e-7, abs=0.006e-7)


CURVES = [
    (BENDING_HB160, 2.3194, 0.0538, 1.3558, 0.0178, 3e6),
    (BENDING_HB250, 4.9404, 0.1045, 1.3558, 0.0178, 3e6),
    (BENDING_HB400, 9.4518, 0.148, 1.3558, 0.0178, 3e6),
    (BENDING_CARBURISED, 6.1514, 0.1192, 1.3558, 0.0178, 3e6),
    (BENDING_NITRIDED, 3.517, 0.0817, 1.3558, 0.0178, 3e6),
    (PITTING, 2.466, 0.056, 1.4488, 0.023, 1e7),
    (PITTING_NITRIDED, 1.249, 0.0138, 1.4488, 0.023, 1e7),
]
"""AGMA 2001-D04, figures 17 and 18."""


@pytest.mark.parametrize(("curve", "c_1", "e_1", "c_2", "e_2", "corner"), CURVES)
def test_lives_follow_the_curves_of_clause_17(curve, c_1, e_1, c_2, e_2, corner):
    for cycles in (1e4, 0.99 * corner):
        assert life_factor(curve, cycles) == near(c_1 * cycles**-e_1)
    for cycles in (1.02 * corner, 1e9, 1e12):
        assert life_factor(curve, cycles) == near(c_2 * cycles**-e_2)


def test_reliability_and_hardness_are_those_of_tables_and_clause_14():
    """Table 11, straight over lg(1 − R); 1 + A (m_G − 1) from 1.2 to 1.7 and above."""
    rows = ((0.5, 0.70), (0.9, 0.85), (0.99, 1.0), (0.999, 1.25), (0.9999, 1.5))
    for (r_1, k_1), (r_2, k_2) in pairwise(rows):
        assert reliability_factor(r_1) == near(k_1) and reliability_factor(r_2) == near(k_2)
        between = 1.0 - math.sqrt((1.0 - r_1) * (1.0 - r_2))
        assert reliability_factor(between) == near((k_1 + k_2) / 2.0)
    assert hardness_ratio_factor(230.0, 200.0, 4.0) == 1.0
    assert hardness_ratio_factor(240.0, 200.0, 4.0) == near(1.0 + 3.0 * (0.00898 * 1.2 - 0.00829))
    assert hardness_ratio_factor(320.0, 200.0, 4.0) == near(1.0 + 3.0 * (0.00898 * 1.6 - 0.00829))
    assert hardness_ratio_factor(400.0, 200.0, 4.0) == near(1.0 + 3.0 * 0.00698)


ROWS = [
    (AgmaSteel.THROUGH_HARDENED, 1, 77.3 * 250.0 + 12800.0, 322.0 * 250.0 + 29100.0),
    (AgmaSteel.THROUGH_HARDENED, 2, 102.0 * 250.0 + 16400.0, 349.0 * 250.0 + 34300.0),
    (AgmaSteel.CARBURISED, 1, 55e3, 180e3),
    (AgmaSteel.CARBURISED, 2, 65e3, 225e3),
    (AgmaSteel.CARBURISED, 3, 75e3, 275e3),
    (AgmaSteel.NITRIDED_4140, 1, 82.3 * 250.0 + 12150.0, 155e3),
    (AgmaSteel.NITRIDED_4140, 2, 108.6 * 250.0 + 15890.0, 168e3),
]
"""AGMA 2001-D04, tables 3 and 4, figures 8 to 10, at 250 HB [psi]."""


@pytest.mark.parametrize(("steel", "grade", "bending", "contact"), ROWS)
def test_strengths_are_those_of_tables_3_and_4(steel, grade, bending, contact):
    assert agma_strength(steel, grade, 250.0) == AgmaStrength(near(bending * PSI), near(contact * PSI))


def test_carburised_steel_needs_no_hardness():
    assert agma_strength(AgmaSteel.CARBURISED, 1) == AgmaStrength(near(55e3 * PSI), near(180e3 * PSI))


def test_a_rating_is_the_product_of_its_factors():
    """Eqs 1, 4, 10 and 13 with another number for every factor."""
    strength = AgmaStrength(400e6, 1500e6)
    load = AgmaLoad(12e3, 1.25, 1.2, 1.3)
    assert load.raised == near(12e3 * 1.25 * 1.2 * 1.3)
    mesh = AgmaMesh(40e-3, 5e-3, 90e-3, 0.11, 190e3)
    gear = AgmaGear(0.38, strength, 1.05, 1.15, 0.95, 0.92, 1.01)
    made = agma_rating(load, gear, mesh, reliability=1.25, temperature=1.1)
    force = 12e3 * 1.25 * 1.2 * 1.3 * 1.05
    bending = force * 1.15 / (40e-3 * 5e-3 * 0.38)
    contact = 190e3 * math.sqrt(force / (90e-3 * 40e-3 * 0.11))
    assert (made.bending_stress, made.contact_stress) == (near(bending), near(contact))
    assert made.bending_limit == near(400e6 * 0.95 / 1.375)
    assert made.contact_limit == near(1500e6 * 0.92 * 1.01 / 1.375)
    assert made.bending_safety == near(400e6 * 0.95 / 1.375 / bending)
    assert made.contact_safety == near(1500e6 * 0.92 * 1.01 / 1.375 / contact)
    plain = agma_rating(AgmaLoad(12e3), AgmaGear(0.38, strength), mesh)
    assert plain.bending_stress == near(12e3 / (40e-3 * 5e-3 * 0.38))
    assert (plain.bending_limit, plain.contact_limit) == (400e6, 1500e6)
    pair = (1.0 - 0.09) / 206e9 + (1.0 - 0.28**2) / 110e9
    assert elastic_coefficient((206e9, 110e9), (0.3, 0.28)) == near(math.sqrt(1.0 / (PI * pair)))


SHIFTED = HobbedPair((21, 55), math.radians(22.0), 0.0, 9.0, (0.15, -0.15), (1.0, 0.95), 1.3, 0.27, 0.03)
NARROW = HobbedPair((19, 64), math.radians(20.0), math.radians(12.0), 9.0, (0.1, -0.1), (1.0, 1.0), 1.35, 0.3, 0.02)
WIDE = HobbedPair((19, 64), math.radians(20.0), math.radians(18.0), 14.0, (0.1, -0.1), (1.0, 1.0), 1.35, 0.3, 0.02)
WIDER = HobbedPair((19, 64), math.radians(20.0), math.radians(18.0), 18.3, (0.1, -0.1), (1.0, 1.0), 1.35, 0.3, 0.02)
PAIRS = pytest.mark.parametrize("pair", [SHIFTED, NARROW, WIDE, WIDER], ids=["spur", "narrow", "wide", "wider"])


class Hand:
    """Radii, path and curvatures of a pair in normal modules, AGMA 908-B89, clause 3."""

    def __init__(self, pair):
        phi_n, psi = pair.pressure_angle, pair.helix_angle
        self.phi = math.atan(math.tan(phi_n) / math.cos(psi))
        self.psi_b = math.asin(math.sin(psi) * math.cos(phi_n))
        self.r = [n / (2.0 * math.cos(psi)) for n in pair.teeth]
        self.b = [r * math.cos(self.phi) for r in self.r]
        self.o = [r + h + x for r, h, x in zip(self.r, pair.addenda, pair.profile_shifts, strict=True)]
        self.reach = [math.sqrt(o**2 - b**2) for o, b in zip(self.o, self.b, strict=True)]
        self.line = sum(self.r) * math.sin(self.phi)
        self.p_b = 2.0 * PI * self.b[0] / pair.teeth[0]
        self.z = sum(self.reach) - self.line
        self.m_f = pair.face_width * math.sin(psi) / PI
        low = self.reach[0] - self.p_b
        mean_radius = (self.o[0] + sum(self.r) - self.o[1]) / 2.0
        mean = math.sqrt(mean_radius**2 - self.b[0] ** 2)
        self.low, self.mean = (low, self.line - low), (mean, self.line - mean)
        self.m_n, self.c_psi = 1.0, 1.0
        if self.m_f > 1.0:
            a, r, p_x = self.m_f % 1.0, (self.z / self.p_b) % 1.0, PI / math.sin(psi)
            lost = a * r if a <= 1.0 - r else (1.0 - a) * (1.0 - r)
            self.m_n = pair.face_width * math.cos(self.psi_b) / (self.z / self.p_b * pair.face_width - lost * p_x)
        else:
            bridge = mean * self.mean[1] * self.z / (low * self.low[1] * PI * math.cos(phi_n))
            self.c_psi = math.sqrt(1.0 - self.m_f * (1.0 - bridge))


@PAIRS
def test_path_sharing_overlap_and_i_are_those_of_clauses_3_and_4(pair):
    """m_N = F/L_min in both of its ranges, C_ψ, I = cos φ C_ψ²/((1/ρ_1 + 1/ρ_2) d m_N)."""
    hand = Hand(pair)
    assert (pair.transverse_angle, pair.base_helix_angle) == (near(hand.phi), near(hand.psi_b))
    assert pair.radii == pytest.approx(hand.r) and pair.outside_reach == pytest.approx(hand.reach)
    assert (pair.line, pair.base_pitch, pair.contact_length) == (near(hand.line), near(hand.p_b), near(hand.z))
    assert pair.axial_ratio == pytest.approx(hand.m_f)
    assert load_sharing_ratio(pair) == near(hand.m_n)
    assert helical_overlap_factor(pair) == near(hand.c_psi)
    first, second = hand.mean if hand.m_f > 1.0 else hand.low
    i = math.cos(hand.phi) * hand.c_psi**2 / ((1.0 / first + 1.0 / second) * 2.0 * hand.r[0] * hand.m_n)
    assert pitting_geometry_factor(pair) == near(i)


def test_the_two_wide_pairs_lose_length_by_either_formula():
    """n_a ≤ 1 − n_r for one of them and above for the other."""
    sides = []
    for pair in (WIDE, WIDER):
        hand = Hand(pair)
        sides.append(hand.m_f % 1.0 <= 1.0 - (hand.z / hand.p_b) % 1.0)
    assert sides == [True, False] or sides == [False, True]


def fillet(pair, teeth, shift):
    """Points of the fillet by rolling the hob's rack: height above the centre and half thickness in tooth axes.

    The rounding's centre lies ρ within the flat tip; at each roll the contact lies on the line from it to the pitch
    point.
    """
    rho, pitch = pair.hob_radius, teeth / 2.0
    depth = pair.hob_addendum - rho - shift
    phi = pair.pressure_angle
    flat = PI / 4.0 - pair.hob_addendum * math.tan(phi) - rho * (1.0 - math.sin(phi)) / math.cos(phi)

    def point(normal):
        # In axes of the space: the rack's tooth stands in it; `normal` is the angle of the contact's normal.
        back = depth * math.tan(normal)
        roll = (back - flat) / pitch
        x = back + rho * math.sin(normal)
        y = pitch - depth - rho * math.cos(normal)
        around = math.atan2(x, y)
        angle = PI / teeth - (around - roll)
        r = math.hypot(x, y)
        return r * math.cos(angle), r * math.sin(angle)

    return point


@PAIRS
@pytest.mark.parametrize("gear", [0, 1])
@pytest.mark.parametrize("place", LoadPlace)
def test_j_is_that_of_the_parabola_that_touches_the_fillet(pair, gear, place):
    """AGMA 908-B89, clauses 5 and 6: of all points of the fillet the parabola touches that of greatest 6 h/s²."""
    hand, phi = Hand(pair), pair.pressure_angle
    cube = math.cos(pair.helix_angle) ** 3
    n_v = [n / cube for n in pair.teeth]
    r = [n / 2.0 for n in n_v]
    b = [radius * math.cos(phi) for radius in r]
    o = [radius + h + x for radius, h, x in zip(r, pair.addenda, pair.profile_shifts, strict=True)]
    reach = [math.sqrt(tip**2 - base**2) for tip, base in zip(o, b, strict=True)]
    single = sum(r) * math.sin(phi) - reach[1 - gear] + PI * math.cos(phi)
    at_tip = hand.m_f > 1.0 or place is LoadPlace.TIP
    tangent = (reach[gear] if at_tip else single) / b[gear]
    x_g = pair.profile_shifts[gear] - pair.thinning / (2.0 * math.tan(phi))
    half_base = (PI / 2.0 + 2.0 * x_g * math.tan(phi)) / n_v[gear] + math.tan(phi) - phi
    load = tangent - half_base
    vertex = b[gear] / math.cos(load)
    point = fillet(pair, n_v[gear], x_g)
    grid = [point(normal) for normal in np.linspace(0.0, PI / 2.0 - phi, 20001)]
    sizes = np.array([(vertex - y) / x**2 for y, x in grid])
    y, x = grid[int(np.argmax(sizes))]
    height, thickness = vertex - y, 2.0 * x
    made = bending_geometry(pair, gear, place)
    assert made.height == pytest.approx(height, rel=1e-3)
    assert made.thickness == pytest.approx(thickness, rel=1e-3)
    depth = pair.hob_addendum - pair.hob_radius - x_g
    rho_f = pair.hob_radius + depth**2 / (n_v[gear] / 2.0 + depth)
    k_f = 0.331 - 0.436 * phi
    over = (made.thickness / rho_f) ** (0.324 - 0.492 * phi) * (made.thickness / made.height) ** (0.261 + 0.545 * phi)
    assert made.stress_correction == near(k_f + over)
    assert stress_correction(phi, made.thickness / rho_f, made.thickness / made.height) == near(k_f + over)
    c_h, k_psi = 1.0, 1.0
    if hand.m_f > 1.0:
        omega = math.degrees(math.atan(math.tan(pair.helix_angle) * math.sin(phi))) / 100.0
        c_h, k_psi = 1.0 / (1.0 - math.sqrt(omega * (1.0 - omega))), math.cos(pair.helix_angle) ** 2
    bracket = 6.0 * made.height / (made.thickness**2 * c_h) - math.tan(load) / made.thickness
    y_form = k_psi * math.cos(phi) / (math.cos(load) * bracket)
    assert made.form == near(y_form)
    assert made.sharing == near(hand.m_n)
    assert made.factor == near(y_form * hand.c_psi / (made.stress_correction * hand.m_n))


def test_a_pair_is_usual_if_nothing_else_is_said():
    """AGMA 908's tables: 20°, spur, h_a0 = 1.25, ρ_a0 = 0.25, Δs_n = 0.024, loaded at single contact."""
    usual = HobbedPair((21, 55), PI / 9.0, 0.0, 10.0, (0.0, 0.0), (1.0, 1.0), 1.25, 0.25, 0.024)
    assert bending_geometry(HobbedPair((21, 55)), 0) == bending_geometry(usual, 0, LoadPlace.SINGLE_CONTACT)
    assert pitting_geometry_factor(HobbedPair((21, 55))) == pitting_geometry_factor(usual)
    assert HobbedPair((21, 55)).face_width == 10.0
