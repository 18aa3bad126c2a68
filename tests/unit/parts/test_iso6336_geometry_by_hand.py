"""Geometry, root section and stiffness of ISO 6336, once more by hand from the clauses; closed forms, so 1e-9 or less.

Two external pairs (helical; spur with the wheel's contact point the worse one) and a ring, none of whose proportions
are usual, so that every term counts.
"""

import math
from dataclasses import dataclass

import pytest

from gearwright.errors import DesignError
from gearwright.parts.gears import BasicRack, CylindricalGear, GearPair
from gearwright.parts.iso6336 import (
    LoadedTooth,
    MeshGeometry,
    MeshSprings,
    MovingBody,
    ToothProportions,
    mesh_springs,
    outer_single_contact,
    reduced_mass,
    root_section,
    shaped_fillet_radius,
    single_contact_factors,
)
from gearwright.parts.iso6336.geometry import mesh_geometry
from gearwright.parts.iso6336.loads import MeshDuty, flank_tolerances, load_cycles, specific_load
from gearwright.parts.iso6336.tooth_strength import contact_ratio_factor, zone_factor

PINION, WHEEL = ToothProportions(1.25, 0.38, 0.21, 0.0), ToothProportions(1.31, 0.29, 0.06, 0.0)


@dataclass(frozen=True)
class Hand:
    """One pair with what its standard's formulas give, written out again."""

    z_1: int
    z_2: int
    m: float
    b: float
    beta: float
    alpha: float
    a_w: float
    tips: tuple[float, float]

    @property
    def mesh(self):
        return MeshGeometry((self.z_1, self.z_2), self.m, self.b, self.a_w, self.tips, self.beta, self.alpha,
                            (PINION, WHEEL))  # fmt: skip

    def __getattr__(self, name):
        """Formulas of ISO 21771 by symbol; s is the side of the wheel."""
        beta, alpha, s = self.beta, self.alpha, math.copysign(1.0, self.z_2)
        alpha_t = math.atan(math.tan(alpha) / math.cos(beta))
        d_1, d_2 = (abs(z) * self.m / math.cos(beta) for z in (self.z_1, self.z_2))
        b_1, b_2 = d_1 * math.cos(alpha_t), d_2 * math.cos(alpha_t)
        alpha_wt = math.acos((b_2 + s * b_1) / (2.0 * self.a_w))
        t_1, t_2 = (math.sqrt((2.0 * r / d_b) ** 2 - 1.0) for r, d_b in zip(self.tips, (b_1, b_2), strict=True))
        e_1 = self.z_1 / (2.0 * math.pi) * (t_1 - math.tan(alpha_wt))
        e_2 = self.z_2 / (2.0 * math.pi) * (t_2 - math.tan(alpha_wt))
        e_a, e_b = e_1 + e_2, self.b * math.sin(beta) / (math.pi * self.m)
        beta_b = math.asin(math.sin(beta) * math.cos(alpha))
        rho_1, rho_2 = b_1 / 2.0 * math.tan(alpha_wt), s * b_2 / 2.0 * math.tan(alpha_wt)
        f_1 = d_1 / 2.0 - (PINION.dedendum - PINION.profile_shift) * self.m
        f_2 = d_2 / 2.0 - s * (WHEEL.dedendum - WHEEL.profile_shift) * self.m
        known = {
            "s": s, "alpha_t": alpha_t, "d": (d_1, d_2), "d_b": (b_1, b_2), "alpha_wt": alpha_wt, "t": (t_1, t_2),
            "e": (e_1, e_2), "e_a": e_a, "e_b": e_b, "beta_b": beta_b, "rho": rho_1 * rho_2 / (rho_1 + rho_2),
            "h": (self.tips[0] - f_1, s * (self.tips[1] - f_2)),
            "z_n": tuple(z / (math.cos(beta_b) ** 2 * math.cos(beta)) for z in (self.z_1, self.z_2)),
        }  # fmt: skip
        if name not in known:
            raise AttributeError(name)
        return known[name]


HELICAL = Hand(23, 71, 3e-3, 19e-3, math.radians(14.0), math.radians(21.0), 146.1e-3, (39.1e-3, 113.2e-3))
SPUR = Hand(21, 23, 2e-3, 24e-3, 0.0, math.radians(20.0), 44.5e-3, (22.9e-3, 25.3e-3))
RING = Hand(25, -83, 2.5e-3, 30e-3, math.radians(9.0), math.radians(20.0), 73.7e-3, (34.6e-3, 102.9e-3))
WIDE = Hand(23, 71, 3e-3, 60e-3, math.radians(14.0), math.radians(21.0), 146.1e-3, (39.1e-3, 113.2e-3))
PAIRS = pytest.mark.parametrize("hand", [HELICAL, SPUR, RING, WIDE], ids=["helical", "spur", "ring", "wide"])
close = pytest.approx


def near(*values):
    return close(values if len(values) > 1 else values[0], rel=1e-10, abs=0.0)


@PAIRS
def test_angles_diameters_and_contact_ratios_are_those_of_iso_21771(hand):
    mesh = hand.mesh
    assert mesh.side == hand.s and mesh.ratio == near(hand.z_2 / hand.z_1)
    assert mesh.transverse_angle == near(hand.alpha_t)
    assert mesh.base_helix_angle == near(hand.beta_b)
    assert mesh.pitch_diameters == near(*hand.d)
    assert mesh.base_diameters == near(*hand.d_b)
    assert mesh.working_angle == near(hand.alpha_wt)
    assert mesh.base_pitch == near(math.pi * hand.m / math.cos(hand.beta) * math.cos(hand.alpha_t))
    assert mesh.tip_tangents == near(*hand.t)
    assert mesh.addendum_contact_ratios == near(*hand.e)
    assert mesh.transverse_contact_ratio == near(hand.e_a)
    assert mesh.overlap_ratio == near(hand.e_b)
    assert mesh.total_contact_ratio == near(hand.e_a + hand.e_b)
    assert mesh.virtual_teeth == near(*hand.z_n)
    assert mesh.relative_curvature == near(hand.rho)
    assert mesh.tooth_heights == near(*hand.h)


def test_a_mesh_is_spur_of_twenty_degrees_with_the_standard_tooth_if_nothing_else_is_said():
    """ISO 53 profile A: 1.25 and 0.38; α_n = 20°."""
    mesh = MeshGeometry((20, 60), 2e-3, 20e-3, 80e-3, (22e-3, 62e-3))
    assert (mesh.helix_angle, math.degrees(mesh.pressure_angle)) == (0.0, pytest.approx(20.0))
    assert mesh.proportions == (ToothProportions(1.25, 0.38, 0.0, 0.0),) * 2
    gear = mesh_geometry(GearPair(CylindricalGear(20, 2e-3, 20e-3), CylindricalGear(60, 2e-3, 20e-3)))
    assert gear.proportions == mesh.proportions
    assert mesh.transverse_contact_ratio == near(gear.transverse_contact_ratio)


@PAIRS
def test_zone_contact_ratio_and_single_contact_factors_are_those_of_part_2(hand):
    """Clauses 6.2, 6.3 and 8; with f_ZCa = 1.2 the helical limit of Z_B and Z_D is √1.2."""
    alpha_t, alpha_wt = hand.alpha_t, hand.alpha_wt
    zone = 2.0 * math.cos(hand.beta_b) * math.cos(alpha_wt) / (math.cos(alpha_t) ** 2 * math.sin(alpha_wt))
    assert zone_factor(hand.mesh) == near(math.sqrt(zone))
    share = min(hand.e_b, 1.0)
    assert contact_ratio_factor(hand.mesh) == near(math.sqrt((4.0 - hand.e_a) / 3.0 * (1.0 - share) + share / hand.e_a))
    (t_1, t_2), one, two = hand.t, 2.0 * math.pi / hand.z_1, 2.0 * math.pi / hand.z_2
    m_1 = math.tan(alpha_wt) / math.sqrt((t_1 - one) * (t_2 - (hand.e_a - 1.0) * two))
    m_2 = math.tan(alpha_wt) / math.sqrt((t_2 - two) * (t_1 - (hand.e_a - 1.0) * one))
    for profile in (1.0, 1.2):
        z_b, z_d = (max(m, 1.0) - share * (max(m, 1.0) - math.sqrt(profile)) for m in (m_1, m_2))
        z_d = z_d if hand.z_2 > 0 else 1.0
        assert single_contact_factors(hand.mesh, profile_factor=profile) == near(z_b, z_d)


def test_the_single_contact_factors_of_these_pairs_reach_both_sides_of_one():
    """Else the test above would not see which of two branches is taken."""
    helical, spur = single_contact_factors(HELICAL.mesh), single_contact_factors(SPUR.mesh)
    assert helical[0] > 1.0 == helical[1]
    assert spur[1] > 1.0


@PAIRS
def test_the_mass_of_a_pair_is_that_of_discs_at_their_mean_diameters(hand):
    """m* = π/8 ρ d_m² (d_m/d_b)² (1 − q⁴), d_m = (d_a + d_f)/2; of a ring q⁴ − 1: ISO 6336-1:2006, clause 6.5.9."""
    masses, inside = [], []
    for gear, (rho, q, sign) in enumerate(((7830.0, 0.3, 1.0), (4430.0, 0.6 if hand.s > 0 else 1.3, hand.s))):
        d_a = 2.0 * hand.tips[gear]
        mean = (d_a + (d_a - sign * 2.0 * hand.h[gear])) / 2.0
        inside.append(MovingBody(q * mean))
        masses.append(math.pi / 8.0 * rho * mean**4 / hand.d_b[gear] ** 2 * abs(1.0 - q**4))
    assert reduced_mass(hand.mesh, (7830.0, 4430.0), tuple(inside)) == near(1.0 / (1.0 / masses[0] + 1.0 / masses[1]))
    solid = masses[0] / (1.0 - 0.3**4)
    wheel = masses[1] / (1.0 - 0.6**4) if hand.s > 0 else math.inf
    assert reduced_mass(hand.mesh, (7830.0, 4430.0)) == near(1.0 / (1.0 / solid + 1.0 / wheel))


def test_loads_and_cycles_count_meshes_and_paths():
    """T_1 = 200 N m, K_A = 1.25, K_γ = 1.1; 150 rad/s over 1000 h, three meshes a turn and two."""
    duty = MeshDuty(200.0, -150.0, 3.6e6, 1.25, 1.1, (3.0, 2.0))
    assert specific_load(RING.mesh, duty) == near(400.0 / RING.d[0] / 30e-3 * 1.25 * 1.1)
    turns = 150.0 * 3.6e6 / (2.0 * math.pi)
    assert load_cycles(RING.mesh, duty) == near(3.0 * turns, 2.0 * turns * 25.0 / 83.0)
    assert MeshDuty(200.0, 150.0, 3.6e6).meshes_per_turn == (1.0, 1.0)


def test_tolerances_are_those_of_iso_1328():
    """ISO 1328-1:2013, clause 5, in mm and µm; a class is a step of √2 and class 5 the base."""
    for grade, scale in ((5, 1.0), (8, math.sqrt(8.0)), (3, 0.5)):
        made = flank_tolerances(240e-3, 4e-3, 36e-3, grade=grade)
        assert made.single_pitch == near(scale * 1e-6 * (0.24 + 1.6 + 5.0))
        assert made.profile_form == near(scale * 1e-6 * (2.2 + 5.0))
        assert made.profile_slope == near(scale * 1e-6 * (1.6 + 0.24 + 4.0))
        assert made.helix_slope == near(scale * 1e-6 * (0.05 * math.sqrt(240.0) + 0.35 * 6.0 + 4.0))


@PAIRS
@pytest.mark.parametrize(("load", "light"), [(250e3, 1.0), (6.25e3, 0.5)])
def test_the_springs_of_a_mesh_follow_the_least_flexibility_of_clause_9(hand, load, light):
    """q′ with C_1 … C_9 as printed; C_M = 0.8; C_B of the mean dedendum; 6.25 N/mm is a sixteenth of 100: half."""
    z_1, z_2 = hand.z_n
    x_1, x_2 = PINION.profile_shift, WHEEL.profile_shift
    one_2 = 1.0 / z_2 if z_2 > 0 else 0.0
    q = 0.04723 + 0.15551 / z_1 + 0.25791 * one_2 - 0.00635 * x_1 - 0.11654 * x_1 / z_1
    q += -0.00193 * x_2 - 0.24188 * x_2 * one_2 + 0.00529 * x_1**2 + 0.00182 * x_2**2
    rack = (1.0 + 0.5 * (1.2 - (1.25 + 1.31) / 2.0)) * (1.0 - 0.02 * (20.0 - math.degrees(hand.alpha)))
    single = 1e9 / q * 0.8 * rack * math.cos(hand.beta) * light
    mean = single * (0.75 * hand.e_a + 0.25)
    assert mesh_springs(hand.mesh, load) == MeshSprings(near(single), near(mean), near(0.85 * mean))


def sectioned(z_n, d_en, alpha, tooth, *, shift=0.0, force=None):
    """ϑ, s_Fn, ρ_F, h_Fe, α_Fen, Y_F, q_s, Y_S of ISO 6336-3, clauses 6 and 7, iterated as the standard says."""
    h, rho, x, s_pr = tooth.dedendum, tooth.fillet_radius, tooth.profile_shift, tooth.undercut
    e = math.pi / 4.0 - shift - h * math.tan(alpha) + s_pr / math.cos(alpha)
    e -= (1.0 - math.sin(alpha)) * rho / math.cos(alpha)
    g = rho - h + x
    internal = z_n < 0
    t, chord_root, arm_root = (math.pi / 6.0, 1.0, math.sqrt(3.0)) if internal else (math.pi / 3.0, math.sqrt(3.0), 1.0)
    big_h = 2.0 / z_n * (math.pi / 2.0 - e) - t
    theta = t / 2.0
    for _ in range(400):
        theta = 2.0 * g / z_n * math.tan(theta) - big_h
    s = z_n * math.sin(t - theta) + chord_root * (g / math.cos(theta) - rho)
    fillet = rho + 2.0 * g**2 / (math.cos(theta) * (z_n * math.cos(theta) ** 2 - 2.0 * g))
    alpha_en = math.acos(z_n * math.cos(alpha) / d_en)
    gamma = (math.pi / 2.0 + 2.0 * (x * math.tan(alpha) + shift)) / z_n
    gamma += math.tan(alpha) - alpha - (math.tan(alpha_en) - alpha_en)
    load = alpha_en - gamma
    lever = (math.cos(gamma) - math.sin(gamma) * math.tan(load)) * d_en
    lever = 0.5 * (lever - z_n * math.cos(t - theta) - arm_root * (g / math.cos(theta) - rho))
    form = 6.0 * lever * math.cos(load) / (s**2 * math.cos(alpha if force is None else force))
    slender, notch = s / lever, s / (2.0 * fillet)
    stress = (1.2 + 0.13 * slender) * notch ** (1.0 / (1.21 + 2.3 / slender))
    return theta, s, fillet, lever, load, form, notch, stress


@pytest.mark.parametrize(
    ("z_n", "d_en", "degrees", "tooth", "shift", "force"),
    [
        (24.3, 25.4, 20.0, ToothProportions(1.25, 0.38, 0.21, 0.0), 0.0, None),
        (38.0, 39.1, 22.5, ToothProportions(1.35, 0.27, -0.13, 0.04), 0.023, math.radians(21.0)),
        (-83.0, -82.2, 20.0, ToothProportions(1.31, 0.29, 0.06, 0.02), 0.0, None),
        (-61.0, -60.4, 25.0, ToothProportions(1.15, 0.22, 0.31, 0.0), 0.01, None),
    ],
)
def test_the_critical_section_is_that_of_clauses_6_and_7(z_n, d_en, degrees, tooth, shift, force):
    """External and internal teeth, with protuberance, a bevel gear's thickness and an angle of force: 1e-9."""
    alpha = math.radians(degrees)
    section = root_section(LoadedTooth(z_n, d_en, alpha, tooth, shift, force))
    by_hand = sectioned(z_n, d_en, alpha, tooth, shift=shift, force=force)
    assert tuple(vars(section).values()) == pytest.approx(by_hand, rel=1e-9)


@PAIRS
@pytest.mark.parametrize("gear", [0, 1])
def test_the_load_acts_at_the_outer_point_of_single_contact(hand, gear):
    """Clause 6.4: d_an = d_n + d_a − d, and back by π m_n cos α_n (ε_αn − 1) along the path; a ring's is negative."""
    z_n, m, sign = hand.z_n[gear], hand.m, (1.0, hand.s)[gear]
    d_an = abs(z_n) * m + 2.0 * hand.tips[gear] - hand.d[gear]
    d_bn = abs(z_n) * m * math.cos(hand.alpha)
    e_an = hand.e_a / math.cos(hand.beta_b) ** 2
    path = math.sqrt(d_an**2 - d_bn**2) / 2.0 - sign * math.pi * m * math.cos(hand.alpha) * (e_an - 1.0)
    loaded = outer_single_contact(hand.mesh, gear)
    assert loaded.load_diameter == near(sign * 2.0 * math.hypot(path, d_bn / 2.0) / m)
    assert loaded.teeth == near(z_n) and loaded.pressure_angle == hand.alpha
    assert loaded.tooth is (PINION, WHEEL)[gear] and loaded.thickness_shift == 0.0 and loaded.force_angle is None


def test_a_shaper_cutter_leaves_its_own_fillet():
    """ISO 6336-3:2006, 6.2.2: ρ + (x_0 + h − ρ)^1.95 / (3.156 · 1.036^z_0)."""
    tooth = ToothProportions(1.25, 0.38)
    assert shaped_fillet_radius(tooth, 25.0, 0.1) == near(0.38 + 0.97**1.95 / (3.156 * 1.036**25))
    assert shaped_fillet_radius(tooth, 40.0) == near(0.38 + 0.87**1.95 / (3.156 * 1.036**40))


def test_the_geometry_of_a_pair_is_taken_over_as_it_is():
    """Teeth, tips, racks and shifts of both gears, each of them another."""
    beta, alpha = math.radians(11.0), math.radians(22.0)
    pinion = CylindricalGear(29, 3e-3, 26e-3, beta, 0.2, BasicRack(alpha, 1.0, 1.25, 0.31), -0.03)
    wheel = CylindricalGear(64, 3e-3, 22e-3, beta, 0.1, BasicRack(alpha, 1.0, 1.3, 0.28), -0.05)
    mesh = mesh_geometry(GearPair(pinion, wheel, 144e-3))
    assert (mesh.teeth, mesh.module, mesh.face_width) == ((29, 64), 3e-3, 22e-3)
    assert mesh.centre_distance == near(144e-3)
    d_1, d_2 = 29 * 3e-3 / math.cos(beta), 64 * 3e-3 / math.cos(beta)
    assert mesh.tip_radii == near(d_1 / 2.0 + 3e-3 * 1.17, d_2 / 2.0 + 3e-3 * 1.05)
    assert (mesh.helix_angle, mesh.pressure_angle) == (beta, alpha)
    assert mesh.proportions == (ToothProportions(1.25, 0.31, 0.2), ToothProportions(1.3, 0.28, 0.1))


def test_tips_and_roots_that_interfere_are_refused():
    """A tip may reach the mate's tangent point on the base circle and no farther; a ring's tip no less far."""

    def pair(height, wheel):
        rack = CylindricalGear(30, 2e-3, 20e-3, profile_shift=0.1)
        return GearPair(rack, CylindricalGear(wheel, 2e-3, 20e-3, profile_shift=0.1, tip_alteration=height))

    for wheel, sign in ((40, 1.0), (-90, -1.0)):
        good = pair(0.0, wheel)
        path = good.centre_distance * math.sin(good.working_pressure_angle)
        limit = math.hypot(good.driven.base_radius, path)
        reach = sign * (limit - good.driven.tip_radius) / 2e-3
        assert mesh_geometry(pair(reach - 1e-6, wheel)).teeth == (30, wheel)
        bound = "at most" if wheel > 0 else "at least"
        with pytest.raises(DesignError, match=rf"driven.tip_radius: .* use {bound} {1e3 * limit:.5g} mm"):
            mesh_geometry(pair(reach + 1e-6, wheel))
