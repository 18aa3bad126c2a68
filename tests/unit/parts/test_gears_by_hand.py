"""Cylindrical gears by ISO 21771 and geometry, Lewis and Hertz by their formulas: everything computed a second way."""

import math
from itertools import pairwise

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.gears import (
    ISO53_A,
    ISO53_D,
    BasicRack,
    CylindricalGear,
    GearPair,
    base_helix_angle,
    contact_radii,
    half_angle_at,
    involute,
    least_profile_shift,
    least_teeth,
    load_point,
    shift_sum,
    tooth_form,
    transverse_pressure_angle,
    virtual_teeth,
    working_pressure_angle,
)
from gearwright.parts.gears.cylindrical_gear import (
    ball_measurement,
    disc_inertia,
    disc_mass,
    feed_grade,
    involute_angle,
    least_backlash,
    pressure_angle_at,
    ring_inertia,
    ring_mass,
    runout_tolerance,
    span_allowances,
    span_measurement,
    spanned_teeth,
    tip_thickness,
)
from gearwright.parts.gears.gear_pair import (
    HERTZ_COEFFICIENT,
    assembly_room,
    bending_stress_lewis,
    contact_angles,
    contact_stress,
    hertz_coefficient,
    interference,
    involute_clearance,
    lewis_form_factor,
    module_hertz,
    module_lewis,
    tip_clearance_angle,
)

PI = math.pi
RACK = BasicRack(math.radians(21.0), 1.05, 1.3, 0.32)
BETA = math.radians(14.0)
HELICAL = CylindricalGear(27, 3e-3, 25e-3, BETA, 0.23, RACK, -0.04)
RING = CylindricalGear(-74, 3e-3, 22e-3, BETA, 0.17, RACK, -0.06)
BIG = CylindricalGear(52, 3e-3, 22e-3, BETA, 0.11, RACK, -0.02)


def near(value):
    return pytest.approx(value, rel=1e-10, abs=0.0)


def inv(angle):
    return math.tan(angle) - angle


@pytest.mark.parametrize("degrees", [0.5, 5.0, 20.0, 44.0, 55.0, 62.0, 75.0, 85.0])
def test_the_angle_of_an_involute_is_found_from_its_value(degrees):
    assert involute_angle(inv(math.radians(degrees))) == pytest.approx(math.radians(degrees), rel=1e-10)
    assert involute(math.radians(degrees)) == near(inv(math.radians(degrees)))
    assert involute_angle(0.0) == 0.0


def test_angles_and_shifts_are_those_of_iso_21771():
    """tan α_t, sin β_b, z_n, inv α_wt, x_min and z_min with 21°, 14° and signed teeth."""
    alpha = math.radians(21.0)
    alpha_t = math.atan(math.tan(alpha) / math.cos(BETA))
    beta_b = math.asin(math.sin(BETA) * math.cos(alpha))
    assert (transverse_pressure_angle(alpha, BETA), base_helix_angle(alpha, BETA)) == (near(alpha_t), near(beta_b))
    assert virtual_teeth(27, alpha, BETA) == near(27.0 / (math.cos(beta_b) ** 2 * math.cos(BETA)))
    for teeth, shift in ((79, 0.34), (-47, -0.06)):
        working = working_pressure_angle(teeth, shift, pressure_angle=alpha, helix_angle=BETA)
        assert inv(working) == near(inv(alpha_t) + 2.0 * math.tan(alpha) * shift / teeth)
        assert shift_sum(teeth, working, pressure_angle=alpha, helix_angle=BETA) == pytest.approx(shift)
    least = 1.1 - 12.0 * math.sin(alpha_t) ** 2 / (2.0 * math.cos(BETA))
    assert least_profile_shift(12.0, 1.1, pressure_angle=alpha, helix_angle=BETA) == near(least)
    few = 2.0 * 1.1 * math.cos(BETA) / math.sin(alpha_t) ** 2
    assert least_teeth(1.1, pressure_angle=alpha, helix_angle=BETA) == near(few)


def test_the_racks_of_iso_53_are_the_printed_ones():
    """ISO 53:1998, profiles A and D; straight part h_fP − ρ (1 − sin α)."""
    racks = [(r.addendum, r.dedendum, r.fillet_radius) for r in (ISO53_A, ISO53_D)]
    assert racks == [(1.0, 1.25, 0.38), (1.0, 1.40, 0.39)]
    assert {round(math.degrees(r.pressure_angle), 9) for r in (ISO53_A, ISO53_D)} == {20.0}
    assert RACK.straight_dedendum == near(1.3 - 0.32 * (1.0 - math.sin(math.radians(21.0))))
    plain = CylindricalGear(20, 2e-3, 10e-3)
    assert (plain.helix_angle, plain.profile_shift, plain.tip_alteration, plain.rack) == (0.0, 0.0, 0.0, ISO53_A)
    assert tooth_form(plain).base_radius == near(20e-3 * math.cos(math.radians(20.0)))


@pytest.mark.parametrize(("gear", "side"), [(HELICAL, 1.0), (RING, -1.0)])
def test_radii_and_thickness_are_those_of_iso_21771(gear, side):
    """r, r_b, r_a, r_f, ψ_y = (π + 4 x tan α)/(2 z) ± (inv α_t − inv α_y)."""
    alpha_t = math.atan(math.tan(math.radians(21.0)) / math.cos(BETA))
    z, x, k = abs(gear.teeth), gear.profile_shift, gear.tip_alteration
    r = z * 3e-3 / (2.0 * math.cos(BETA))
    assert (gear.side, gear.transverse_module) == (side, near(3e-3 / math.cos(BETA)))
    assert (gear.transverse_pressure_angle, gear.pitch_radius) == (near(alpha_t), near(r))
    assert (gear.base_radius, gear.base_pitch) == (
        near(r * math.cos(alpha_t)),
        near(2.0 * PI * r * math.cos(alpha_t) / z),
    )
    assert gear.tip_radius == near(r + side * 3e-3 * (1.05 + x + k))
    assert gear.root_radius == near(r - side * 3e-3 * (1.3 - x))
    assert gear.base_helix_angle == near(math.asin(math.sin(BETA) * math.cos(math.radians(21.0))))
    for radius in (gear.tip_radius, r, r + side * 1e-3):
        angle = math.acos(r * math.cos(alpha_t) / radius)
        half = (PI + 4.0 * x * math.tan(math.radians(21.0))) / (2.0 * z) + side * (inv(alpha_t) - inv(angle))
        assert pressure_angle_at(gear, radius) == near(angle)
        assert half_angle_at(gear, radius) == near(half)
    assert tip_thickness(gear) == near(2.0 * half_angle_at(gear, gear.tip_radius) * gear.tip_radius)
    least = RACK.straight_dedendum - 27.0 * math.sin(alpha_t) ** 2 / (2.0 * math.cos(BETA))
    assert gear.undercut_shift == (near(least) if side > 0 else -math.inf)


@pytest.mark.parametrize("given", [None, 120.5e-3])
def test_an_external_pair_meshes_where_its_involutes_do(given):
    """α_wt by inv or by the given centre distance; path, contact ratios and backlash from radii alone."""
    check_pair(GearPair(HELICAL, BIG, given), 1.0, given)


@pytest.mark.parametrize("given", [None, 71.9e-3])
def test_an_internal_pair_meshes_where_its_involutes_do(given):
    check_pair(GearPair(HELICAL, RING, given), -1.0, given)


def check_pair(pair, side, given):
    """Everything of a pair from the radii of its gears."""
    one, two = pair.driver, pair.driven
    base = two.base_radius + side * one.base_radius
    assert pair.base_centre_distance == near(base) and pair.side == side
    alpha_wt = math.acos(base / given) if given else None
    if alpha_wt is None:
        value = inv(one.transverse_pressure_angle)
        value += 2.0 * math.tan(math.radians(21.0)) * (one.profile_shift + two.profile_shift) / (one.teeth + two.teeth)
        assert inv(pair.working_pressure_angle) == near(value)
        assert pair.backlash == pytest.approx(0.0, abs=1e-12)
        alpha_wt = pair.working_pressure_angle
    assert pair.working_pressure_angle == near(alpha_wt)
    assert pair.centre_distance == near(base / math.cos(alpha_wt))
    ends = [math.sqrt(gear.tip_radius**2 - gear.base_radius**2) for gear in (one, two)]
    recess = ends[0] - one.base_radius * math.tan(alpha_wt)
    approach = side * (ends[1] - two.base_radius * math.tan(alpha_wt))
    assert (pair.approach, pair.recess) == (near(approach), near(recess))
    assert pair.transverse_contact_ratio == near((approach + recess) / one.base_pitch)
    assert pair.face_width == 22e-3
    assert pair.overlap_ratio == near(22e-3 * math.sin(BETA) / (PI * 3e-3))
    pitch = [gear.base_radius / math.cos(alpha_wt) for gear in (one, two)]
    gaps = 2.0 * PI * pitch[0] / one.teeth - sum(
        2.0 * half_angle_at(g, r) * r for g, r in zip((one, two), pitch, strict=True)
    )
    assert pair.backlash == pytest.approx(gaps, abs=1e-15)
    reach = [gear.base_radius * math.tan(alpha_wt) for gear in (one, two)]
    expected = (math.hypot(one.base_radius, reach[0] + 1e-3), math.hypot(two.base_radius, reach[1] - side * 1e-3))
    assert contact_radii(pair, 1e-3) == pytest.approx(expected)


def test_the_path_ends_where_the_involute_does():
    """A tip beyond the tangent point adds no contact: r_b1 tan α_wt is the longest approach."""
    pair = GearPair(CylindricalGear(12, 3e-3, 20e-3, profile_shift=0.1), CylindricalGear(80, 3e-3, 20e-3))
    assert pair.approach == near(pair.driver.base_radius * math.tan(pair.working_pressure_angle))


def test_gears_that_do_not_match_are_refused():
    with pytest.raises(DesignError, match="below π/3"):
        CylindricalGear(20, 3e-3, 20e-3, math.radians(61.0))
    plain = CylindricalGear(20, 3e-3, 20e-3)
    for driver, driven, match in (
        (CylindricalGear(-60, 3e-3, 20e-3), plain, "must be external"),
        (plain, CylindricalGear(-20, 3e-3, 20e-3), "do not fit inside"),
        (plain, CylindricalGear(30, 3.1e-3, 20e-3), "driven.module"),
        (plain, CylindricalGear(30, 3e-3, 20e-3, 0.1), "driven.helix_angle"),
        (plain, CylindricalGear(30, 3e-3, 20e-3, rack=RACK), "driven.rack.pressure_angle"),
    ):
        with pytest.raises(DesignError, match=match):
            GearPair(driver, driven)
    base = GearPair(plain, CylindricalGear(30, 3e-3, 20e-3)).base_centre_distance
    with pytest.raises(DesignError, match=f"above {1e3 * base:.6g} mm"):
        GearPair(plain, CylindricalGear(30, 3e-3, 20e-3), base)
    assert GearPair(plain, CylindricalGear(-21, 3e-3, 20e-3, tip_alteration=-0.9)).side == -1


@pytest.mark.parametrize(
    ("teeth", "shift", "beta"), [(27, 0.23, BETA), (20, 0.0, 0.0), (31, -0.1, 0.2), (9, 0.5, 0.0), (70, 0.1, 0.6)]
)
def test_span_and_spanned_teeth(teeth, shift, beta):
    """W_k = (k − 1) p_bn + s_bn; the k whose half span comes nearest to the cylinder of d + 2 x m."""
    gear = CylindricalGear(teeth, 3e-3, 25e-3, beta, shift, RACK)
    alpha, alpha_t = math.radians(21.0), gear.transverse_pressure_angle
    s_bt = 2.0 * gear.base_radius * ((PI / 2.0 + 2.0 * shift * math.tan(alpha)) / teeth + inv(alpha_t))
    for k in (1, 2, 5):
        expected = (k - 1) * PI * 3e-3 * math.cos(alpha) + s_bt * math.cos(gear.base_helix_angle)
        assert span_measurement(gear, k) == near(expected)
    middle = gear.pitch_radius + shift * 3e-3
    wanted = 2.0 * math.sqrt(middle**2 - gear.base_radius**2) / math.cos(gear.base_helix_angle)
    assert spanned_teeth(gear) == min(range(2, 30), key=lambda k: abs(span_measurement(gear, k) - wanted))
    with pytest.raises(DesignError, match="between balls"):
        span_measurement(RING, 3)


@pytest.mark.parametrize("gear", [HELICAL, BIG, RING, CylindricalGear(-73, 3e-3, 22e-3, BETA, 0.17, RACK)])
def test_balls_touch_both_flanks_of_a_space(gear):
    """The ball's centre lies at α_K: its base half angle is that of the space moved by D/(2 r_b cos β_b)."""
    diameter, z = 5.2e-3, abs(gear.teeth)
    half_space = PI / z - half_angle_at(gear, gear.base_radius)
    moved = diameter / (2.0 * gear.base_radius * math.cos(gear.base_helix_angle))
    value = moved - half_space if gear.side > 0 else half_space - moved
    centre = gear.base_radius / math.cos(involute_angle(value))
    across = 2.0 * centre * (math.cos(PI / (2.0 * z)) if z % 2 else 1.0)
    assert ball_measurement(gear, diameter) == near(across + gear.side * diameter)


def test_allowances_are_those_of_iso_tr_10064():
    """2/3 (0.06 + 0.0005 a + 0.03 m) mm; F_r = 0.9 (0.002 d + 0.55 √d + 0.7 m + 12) √2^(A − 5) µm; the feed's table."""
    assert least_backlash(0.2, 4e-3) == near(1e-3 * 2.0 / 3.0 * (0.06 + 0.1 + 0.12))
    for grade, scale in ((5, 1.0), (8, math.sqrt(8.0)), (3, 0.5)):
        assert runout_tolerance(0.25, 4e-3, grade) == near(
            0.9e-6 * scale * (0.5 + 0.55 * math.sqrt(250.0) + 2.8 + 12.0)
        )
    table = {4: (7, 1.26), 5: (8, 1.0), 6: (8, 1.26), 7: (9, 1.0), 8: (9, 1.26), 9: (10, 1.0)}
    assert {grade: feed_grade(grade) for grade in range(4, 10)} == table
    low, high = span_allowances(150e-6, 20e-6, 40e-6, pressure_angle=0.4)
    assert high == near(-75e-6)
    assert low == near(-75e-6 - 2.0 * math.sin(0.4) * math.sqrt(20.0**2 + 40.0**2) * 1e-6)


LEWIS = {
    12: 0.245, 13: 0.261, 14: 0.277, 15: 0.290, 16: 0.296, 17: 0.303, 18: 0.309, 19: 0.314, 20: 0.322, 21: 0.328,
    22: 0.331, 24: 0.337, 26: 0.346, 28: 0.353, 30: 0.359, 34: 0.371, 38: 0.384, 43: 0.397, 50: 0.409, 60: 0.422,
    75: 0.435, 100: 0.447, 150: 0.460, 300: 0.472, 400: 0.480,
}  # fmt: skip
"""Shigley, 9th ed., table 14-2."""


def test_lewis_is_shigleys_table_and_a_cantilever():
    """σ = F/(b m Y); with F = 2 (T/z) cos β/m and b = λ m it is the allowable stress at the module given."""
    for teeth, factor in LEWIS.items():
        assert float(lewis_form_factor(teeth)) == near(factor)
    for (z_1, y_1), (z_2, y_2) in pairwise(LEWIS.items()):
        assert float(lewis_form_factor((z_1 + z_2) / 2.0)) == near((y_1 + y_2) / 2.0)
    assert float(lewis_form_factor(1e4)) == near(0.480)
    with pytest.raises(ValueError, match="from 12 teeth on"):
        lewis_form_factor([20.0, 11.9])
    for beta in (0.0, 0.3):
        module = float(module_lewis(4.0, 0.38, 9.0, allowable=250e6, **({"helix_angle": beta} if beta else {})))
        force = 2.0 * 4.0 * math.cos(beta) / module
        assert bending_stress_lewis(force, 9.0 * module, module, form_factor=0.38) == near(250e6)
    assert bending_stress_lewis(1e3, 0.02, 3e-3, form_factor=0.4) == near(1e3 / (0.02 * 3e-3 * 0.4))


@pytest.mark.parametrize("transverse", [True, False])
@pytest.mark.parametrize("beta", [0.0, 0.3])
def test_hertz_at_the_pitch_point_gives_back_its_module(transverse, beta):
    """σ = 0.418 √(F E (1/r_1 + 1/r_2) cos β/(b cos α sin α)) at the module that bears it."""
    alpha = math.radians(21.0)
    angles = contact_angles(alpha, beta, transverse=transverse)
    alpha_t = math.atan(math.tan(alpha) / math.cos(beta))
    beta_b = math.asin(math.sin(beta) * math.cos(alpha))
    assert angles == pytest.approx((alpha_t, beta_b) if transverse else (alpha, beta))
    module = float(
        module_hertz(
            4.0, 1 / 20 + 1 / 55, 9.0, allowable=1100e6, elastic_modulus=210e9, angles=angles, helix_angle=beta
        )
    )
    force, width = 2.0 * 4.0 * math.cos(beta) / module, 9.0 * module
    curvature = 2.0 * math.cos(beta) / module * (1 / 20 + 1 / 55)
    stress = 0.418 * math.sqrt(force * 210e9 * curvature * math.cos(angles.line)
                               / (width * math.cos(angles.pressure) * math.sin(angles.pressure)))  # fmt: skip
    assert stress == near(1100e6)
    assert contact_stress(force, width, curvature, angles=angles, elastic_modulus=210e9) == near(stress)
    other = contact_stress(force, width, curvature, angles=angles, elastic_modulus=210e9, poisson_ratio=0.27)
    assert other == near(stress * math.sqrt(0.91 / (1.0 - 0.27**2)))
    assert hertz_coefficient(0.27) == near(math.sqrt(1.0 / (2.0 * PI * (1.0 - 0.27**2))))
    assert pytest.approx(hertz_coefficient(0.3), abs=5e-4) == HERTZ_COEFFICIENT
    usual = module_hertz(
        4.0, 0.1, 9.0, allowable=1e9, elastic_modulus=210e9, angles=contact_angles(alpha, 0.0, transverse=True)
    )
    load = 4.0 * 4.0 * 0.1 * 210e9 / (math.cos(alpha) * math.sin(alpha))
    assert float(usual) == near(math.cbrt(0.418**2 * load / (9.0 * 1e18)))


def test_discs_and_rings_have_mass_and_inertia():
    """π r² b ρ; m d²/8; the ring is one disc less another."""
    whole, hole = disc_mass(0.3, 0.04, 7800.0), disc_mass(0.24, 0.04, 7800.0)
    assert hole == near(PI * 0.12**2 * 0.04 * 7800.0)
    assert disc_inertia(hole, 0.24) == near(hole * 0.12**2 / 2.0)
    assert ring_mass(0.24, 0.03, 0.04, density=7800.0) == near(whole - hole)
    left = disc_inertia(whole, 0.3) - disc_inertia(hole, 0.24)
    assert ring_inertia(whole - hole, 0.24, 0.03) == near(left)


def fillet_by_rolling(gear, z, count):
    """Points of a rack's rounded tip that envelop the fillet, by the contact's normal through the pitch point."""
    rack, m = gear.rack, gear.module
    depth = (rack.dedendum - rack.fillet_radius - gear.profile_shift) * m
    flat = PI / 4.0 - rack.dedendum * math.tan(rack.pressure_angle)
    flat -= rack.fillet_radius * (1.0 - math.sin(rack.pressure_angle)) / math.cos(rack.pressure_angle)
    for lean in np.linspace(0.0, PI / 2.0 - rack.pressure_angle, count):
        back = depth * math.tan(lean)
        x = back + rack.fillet_radius * m * math.sin(lean)
        y = z * m / 2.0 - depth - rack.fillet_radius * m * math.cos(lean)
        angle = PI / z - (math.atan2(x, y) - (back - flat * m) / (z * m / 2.0))
        yield math.hypot(x, y) * math.cos(angle), math.hypot(x, y) * math.sin(angle)


@pytest.mark.parametrize(
    "gear",
    [
        HELICAL,
        CylindricalGear(35, 2e-3, 10e-3, profile_shift=0.1),
        CylindricalGear(9, 2e-3, 9e-3),
        CylindricalGear(13, 2e-3, 9e-3),
    ],
)
def test_an_external_tooth_is_cut_by_its_rack(gear):
    """Fillet from the rolling rack, flank from the involute; an undercut flank begins where the trochoid leaves it."""
    form = tooth_form(gear)
    z = virtual_teeth(gear.teeth, gear.rack.pressure_angle, gear.helix_angle)
    alpha, m = gear.rack.pressure_angle, gear.module
    base = z * m / 2.0 * math.cos(alpha)
    psi = (PI + 4.0 * gear.profile_shift * math.tan(alpha)) / (2.0 * z) + inv(alpha)
    assert (form.side, form.base_radius, form.base_half_angle) == (1, near(base), near(psi))
    assert form.root_radius == near(z * m / 2.0 - (gear.rack.dedendum - gear.profile_shift) * m)
    foot = form.root_radius * math.cos(form.root_half_angle)
    assert form.root_chord == near(2.0 * form.root_radius * math.sin(form.root_half_angle))
    assert form.half_thickness[0] == near(form.root_chord / 2.0) and form.height[0] == 0.0
    points = list(fillet_by_rolling(gear, z, 200))
    rolled_height, rolled_half = np.array(points).T
    undercut = gear.teeth in (9, 13)
    kept = len(form.height) - 199
    assert kept == 200 if not undercut else 20 < kept < 200
    assert form.height[:kept] == pytest.approx(rolled_height[:kept] - foot, abs=1e-12)
    assert form.half_thickness[:kept] == pytest.approx(rolled_half[:kept], abs=1e-12)
    for height, half in zip(form.height[kept:], form.half_thickness[kept:], strict=True):
        radius = math.hypot(height + foot, half)
        angle = math.acos(min(1.0, base / radius))
        assert math.atan2(half, height + foot) == pytest.approx(psi - inv(angle), abs=1e-9)
    tip = math.hypot(form.height[-1] + foot, form.half_thickness[-1])
    assert tip == near(z * m / 2.0 + gear.tip_radius - gear.pitch_radius)
    if undercut:
        rolled = [math.atan2(half, height) for height, half in points]
        radii = [math.hypot(*point) for point in points]
        flanks = [psi - inv(math.acos(min(1.0, base / r))) if r > base else math.inf for r in radii]
        assert all(own < flank for own, flank in zip(rolled[:kept], flanks[:kept], strict=True))
        assert not all(own < flank for own, flank in zip(rolled, flanks, strict=True))


@pytest.mark.parametrize("gear", [RING, CylindricalGear(-60, 2e-3, 10e-3, profile_shift=0.1)])
def test_an_internal_tooth_has_a_circle_at_its_root(gear):
    """The circle touches the root circle's depth and the flank, whose normal is a tangent of the base circle."""
    form = tooth_form(gear)
    z = virtual_teeth(-gear.teeth, gear.rack.pressure_angle, gear.helix_angle)
    alpha, m, rho = gear.rack.pressure_angle, gear.module, gear.rack.fillet_radius * gear.module
    base = z * m / 2.0 * math.cos(alpha)
    psi = (PI + 4.0 * gear.profile_shift * math.tan(alpha)) / (2.0 * z) - inv(alpha)
    root = z * m / 2.0 + (gear.rack.dedendum - gear.profile_shift) * m
    assert (form.side, form.base_radius, form.base_half_angle) == (-1, near(base), near(psi))
    foot = form.root_radius * math.cos(form.root_half_angle)
    x, y = form.half_thickness, foot - form.height
    # The centre stands ρ inside the root circle, and as far from the flank: its own involute's half angle less ρ/r_b.
    centre = math.acos(base / (root - rho))
    around = psi + inv(centre) + rho / base
    at = ((root - rho) * math.sin(around), (root - rho) * math.cos(around))
    arc = np.hypot(x[:200] - at[0], y[:200] - at[1])
    assert arc == pytest.approx(np.full(200, rho), abs=1e-12)
    assert (x[0], y[0]) == (near(at[0]), near(at[1] + rho))
    touching = math.hypot(base, base * math.tan(centre) + rho)
    assert math.hypot(x[199], y[199]) == near(touching)
    for i in range(199, len(x)):
        radius = math.hypot(x[i], y[i])
        assert math.atan2(x[i], y[i]) == pytest.approx(psi + inv(math.acos(min(1.0, base / radius))), abs=1e-9)
    assert math.hypot(x[-1], y[-1]) == near(max(z * m / 2.0 + gear.tip_radius - gear.pitch_radius, base))


@pytest.mark.parametrize("gear", [CylindricalGear(35, 2e-3, 10e-3), CylindricalGear(-60, 2e-3, 10e-3)])
def test_a_force_acts_on_the_flank_along_its_normal(gear):
    """α_y ∓ ψ_y to the root chord, at r cos ψ above it."""
    form = tooth_form(gear)
    radius = gear.pitch_radius + 0.3e-3
    psi, alpha_y = half_angle_at(gear, radius), math.acos(gear.base_radius / radius)
    height, half, angle = (float(v[0]) for v in load_point(form, np.array([radius])))
    foot = form.root_radius * math.cos(form.root_half_angle)
    assert height == near(gear.side * (radius * math.cos(psi) - foot))
    assert half == near(radius * math.sin(psi))
    assert angle == near(alpha_y - gear.side * psi)
    below = load_point(form, np.array([0.99 * gear.base_radius]))
    assert float(below[2][0]) == near(-gear.side * form.base_half_angle)


@pytest.mark.parametrize(("gear", "match"), [
    (CylindricalGear(20, 2e-3, 9e-3, rack=BasicRack(fillet_radius=0.5)), "too narrow"),
    (CylindricalGear(6, 2e-3, 9e-3, profile_shift=1.3), "pointed"),
    (CylindricalGear(-14, 2e-3, 9e-3, profile_shift=1.4, rack=BasicRack(fillet_radius=1.0)), "base circle"),
    (CylindricalGear(-60, 2e-3, 9e-3, rack=BasicRack(fillet_radius=0.9)), "root space is too narrow"),
])  # fmt: skip
def test_teeth_that_cannot_be_are_refused(gear, match):
    with pytest.raises(DesignError, match=match):
        tooth_form(gear)


RINGS = [
    GearPair(CylindricalGear(20, 2e-3, 10e-3, profile_shift=0.2), CylindricalGear(-50, 2e-3, 10e-3, profile_shift=0.1)),
    GearPair(CylindricalGear(40, 2e-3, 10e-3), CylindricalGear(-45, 2e-3, 10e-3, tip_alteration=-0.2)),
    GearPair(
        CylindricalGear(18, 2e-3, 10e-3, tip_alteration=-0.3), CylindricalGear(-60, 2e-3, 10e-3, profile_shift=0.4)
    ),
]


@pytest.mark.parametrize("pair", RINGS)
def test_the_tips_of_ring_and_pinion_clear_by_colbourne(pair):
    """Where the tip circles cross the pinion's tooth stands before the ring's: both by the law of cosines."""
    r_1, r_2, a = pair.driver.tip_radius, pair.driven.tip_radius, pair.centre_distance
    alpha = pair.working_pressure_angle
    clear = r_2 - math.hypot(pair.driven.base_radius, a * math.sin(alpha))
    assert involute_clearance(pair) == pytest.approx(clear)
    if r_1 + a <= r_2:
        assert tip_clearance_angle(pair) == PI
    else:
        x = (r_2**2 - r_1**2 - a**2) / (2.0 * a)
        gamma_1, gamma_2 = math.acos(x / r_1), math.acos((a + x) / r_2)
        turn_1 = gamma_1 + inv(math.acos(pair.driver.base_radius / r_1)) - inv(alpha)
        turn_2 = gamma_2 + inv(math.acos(pair.driven.base_radius / r_2)) - inv(alpha)
        u = pair.driver.teeth / -pair.driven.teeth
        assert tip_clearance_angle(pair) == pytest.approx(turn_1 * u - turn_2)


def test_interference_is_told_and_external_pairs_have_none():
    """A pinion with five teeth less than its ring fouls at the tips; a ring on 18 teeth digs into the root."""
    assert interference(GearPair(HELICAL, BIG)) == ()
    assert interference(RINGS[0]) == ()
    close = interference(GearPair(CylindricalGear(40, 2e-3, 10e-3), CylindricalGear(-45, 2e-3, 10e-3)))
    assert any("tips foul" in str(problem) for problem in close)
    deep = GearPair(CylindricalGear(14, 2e-3, 10e-3), CylindricalGear(-60, 2e-3, 10e-3))
    told = " ".join(map(str, interference(deep)))
    assert involute_clearance(deep) < 0.0 and f"{-1e6 * involute_clearance(deep):.3g} µm" in told


@pytest.mark.parametrize("pair", RINGS)
def test_a_pinion_is_put_in_radially_where_its_tips_stay_in_their_spaces(pair):
    """Every tip corner that passes the ring's tip circle against the corner of its space, both as heights aside."""
    one, two, gaps = pair.driver, pair.driven, []
    for j in range(one.teeth // 2 + 1):
        turned = 2.0 * PI * j / one.teeth + half_angle_at(one, one.tip_radius)
        aside, along = one.tip_radius * math.sin(turned), one.tip_radius * math.cos(turned)
        if turned > PI / 2.0 or aside > two.tip_radius:
            break
        if math.hypot(pair.centre_distance + along, aside) <= two.tip_radius:
            break
        corner = 2.0 * PI * j / -two.teeth + PI / -two.teeth - half_angle_at(two, two.tip_radius)
        gaps.append(two.tip_radius * math.sin(corner) - aside)
    assert gaps
    assert assembly_room(pair).clearance == pytest.approx(min(gaps))
