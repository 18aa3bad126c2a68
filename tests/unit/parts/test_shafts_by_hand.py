"""Shafts by hand: closed forms of beams, DIN 743 and Shigley's chapters 6 and 7 written out, table by table."""

import math
from itertools import pairwise

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.shaft_fatigue import (
    Concentration,
    FatigueStrength,
    SectionLoad,
    SectionStress,
    ShaftSection,
    ShaftSteel,
    Shoulder,
    SteelGroup,
    asme_safety,
    blank_factor,
    din743_safety,
    endurance_limit,
    fatigue_notch_factor,
    felt_concentration,
    goodman_safety,
    keyseat_concentration,
    keyway_factor,
    notch_sensitivity,
    press_fit_factor,
    section_factor,
    section_stress,
    spline_factor,
    stress_concentration,
    surface_factors,
    yield_limits,
    yield_safety,
)
from gearwright.parts.shafts import (
    PointLoads,
    Sections,
    bearing_reactions,
    bent_line,
    critical_speed,
    diagram,
    influence,
    lumped_shaft,
    shaft_diameter,
    shaft_diameter_around,
    shaft_inertia,
    shaft_mass,
    shaft_stress,
    supported,
    torsional_stiffness,
)

PI = math.pi


def near(value):
    return pytest.approx(value, rel=1e-10, abs=0.0)


def test_a_hollow_shaft_is_stressed_by_its_moment_of_resistance():
    """W = π (d⁴ − d_i⁴)/(32 d); √(M² + T²)/W is Tresca's √(σ² + 4 τ²)."""
    resist = PI * (0.05**4 - 0.03**4) / (32.0 * 0.05)
    sigma, tau = 300.0 / resist, 400.0 / (2.0 * resist)
    assert shaft_stress(300.0, 400.0, 0.05, bore=0.03) == near(math.sqrt(sigma**2 + 4.0 * tau**2))
    assert shaft_stress(300.0, 400.0, 0.05) == near(500.0 * 32.0 / (PI * 0.05**3))
    for bore in (0.0, 0.6):
        d = shaft_diameter(300.0, 400.0, 80e6, bore_ratio=bore)
        assert shaft_stress(300.0, 400.0, d, bore=bore * d) == near(80e6)
    assert shaft_diameter(300.0, 400.0, 80e6) == near(math.cbrt(32.0 * 500.0 / (PI * 80e6)))
    d = shaft_diameter_around(0.035, 300.0, 400.0, allowable=80e6)
    assert d > 0.035 and shaft_stress(300.0, 400.0, d, bore=0.035) == near(80e6)
    assert shaft_diameter_around(0.0, 0.0, 0.0, allowable=80e6) == 0.0


def test_a_hollow_shaft_is_a_cylinder_without_another():
    """Mass, inertia and stiffness are those of d less those of the bore."""
    whole, hole = (shaft_mass(d, 0.3, 7800.0) for d in (0.05, 0.03))
    assert shaft_mass(0.05, 0.3, 7800.0, bore=0.03) == near(whole - hole) == near(7800.0 * 0.3 * PI * 4e-4)
    turned = whole * 0.05**2 / 8.0 - hole * 0.03**2 / 8.0
    assert shaft_inertia(whole - hole, 0.05, bore=0.03) == near(turned)
    assert shaft_inertia(whole, 0.05) == near(whole * 0.05**2 / 8.0)
    stiff, soft = (torsional_stiffness(d, 0.3, 80e9) for d in (0.05, 0.03))
    assert stiff == near(80e9 * PI * 0.05**4 / 32.0 / 0.3)
    assert torsional_stiffness(0.05, 0.3, 80e9, bore=0.03) == near(stiff - soft)


LOADS = PointLoads(
    np.array([0.5, 0.1, 0.3]),
    np.array([[-700.0, 400.0, 250.0], [90.0, -60.0, 0.0]]),
    np.array([[0.0, 20.0, -35.0], [5.0, 0.0, 0.0]]),
    np.array([[-80.0, 50.0, 30.0], [0.0, 0.0, 0.0]]),
)
"""Three loads out of order, in two planes; one overhangs."""


def test_reactions_and_moments_are_sums_of_what_is_left_of_a_section():
    """Bearings at 0.05 and 0.4 m; V = Σ F, M = Σ F (x − x_k) − Σ C, T = Σ T_k over x_k < x."""
    balanced = supported(LOADS, [0.4, 0.05], length=0.6)
    reactions = bearing_reactions(LOADS, [0.4, 0.05])
    drawn = diagram(balanced)
    for plane in range(2):
        force, couple = LOADS.force[plane], LOADS.couple[plane]
        about = sum(f * (x - 0.4) for f, x in zip(force, LOADS.position, strict=True)) + couple.sum()
        second = -about / (0.05 - 0.4)
        assert reactions[plane] == pytest.approx([-force.sum() - second, second])
        acting = [*zip(LOADS.position, force, couple, LOADS.torque[plane], strict=True)]
        acting += [(0.4, reactions[plane][0], 0.0, 0.0), (0.05, second, 0.0, 0.0)]
        assert np.all(np.diff(drawn.position) >= 0.0)
        for x in (0.07, 0.2, 0.35, 0.45):
            left = [load for load in acting if load[0] < x]
            shear = np.interp(x, drawn.position, drawn.shear[plane])
            assert shear == pytest.approx(sum(f for _, f, _, _ in left))
            bending = np.interp(x, drawn.position, drawn.bending[plane])
            assert bending == pytest.approx(sum(f * (x - p) - c for p, f, c, _ in left))
            torsion = np.interp(x, drawn.position, drawn.torsion[plane])
            assert torsion == pytest.approx(sum(t for _, _, _, t in left), abs=1e-9)
        assert drawn.bending[plane][-1] == pytest.approx(0.0, abs=1e-9)
    # A couple makes a step: 20 N m down at 0.1 m, seen from both sides of the station.
    at = int(np.searchsorted(drawn.position, 0.1))
    assert drawn.bending[0][at] - drawn.bending[0][at + 1] == pytest.approx(20.0)
    assert drawn.shear[0][at + 1] - drawn.shear[0][at] == pytest.approx(400.0)
    assert drawn.torsion[0][at + 1] - drawn.torsion[0][at] == pytest.approx(50.0)


def test_torques_alone_bend_nothing():
    twisted = PointLoads(np.array([0.1, 0.3]), np.zeros(2), np.zeros(2), np.array([30.0, -30.0]))
    drawn = diagram(twisted)
    assert drawn.torsion.tolist() == [0.0, 30.0, 30.0, 0.0]
    assert drawn.bending.tolist() == drawn.shear.tolist() == [0.0] * 4


UNIFORM = Sections(np.array([0.0, 0.6]), np.array([0.04]), np.array([0.02]))
RIGID = 210e9 * PI / 64.0 * (0.04**4 - 0.02**4)


def test_a_uniform_shaft_deflects_by_the_tables_of_the_trade():
    """F a² b²/(3 E I L) under the load, F a² (L + a)/(3 E I) at an overhung one; M = F a b/L; Roark, table 8.1."""
    a, b, span = 0.2, 0.3, 0.5
    known = influence(UNIFORM, [0.0, 0.5], [0.2, 0.6], elastic_modulus=210e9)
    assert known[0, 0] == pytest.approx(a**2 * b**2 / (3.0 * RIGID * span), rel=1e-7)
    assert known[1, 1] == pytest.approx(0.1**2 * (span + 0.1) / (3.0 * RIGID), rel=1e-7)
    # An overhung load lifts the span: w(x) = −F a x (L² − x²)/(6 E I L).
    assert known[0, 1] == pytest.approx(-0.1 * a * (span**2 - a**2) / (6.0 * RIGID * span), rel=1e-7)
    assert known[0, 1] == pytest.approx(known[1, 0], rel=1e-9)
    loads = supported(PointLoads(np.array([0.2]), np.array([-1e3]), np.zeros(1), np.zeros(1)), [0.0, 0.5], length=0.6)
    line = bent_line(diagram(loads), UNIFORM, [0.0, 0.5], elastic_modulus=210e9)
    # Slope at the first bearing: F b (L² − b²)/(6 E I L), and straight beyond the second.
    assert line.slope[0] == pytest.approx(-1e3 * b * (span**2 - b**2) / (6.0 * RIGID * span), rel=1e-7)
    assert line.slope[-1] == pytest.approx(1e3 * a * (span**2 - a**2) / (6.0 * RIGID * span), rel=1e-7)
    assert line.deflection[-1] == pytest.approx(line.slope[-1] * 0.1, rel=1e-7)
    assert line.deflection[0] == 0.0


def test_a_stepped_shaft_deflects_by_castigliano():
    """∫ M m/(E I) over two cylinders: unit load in the middle of 0.4 m, step there; E I over each half."""
    stepped = Sections(np.array([0.0, 0.2, 0.4]), np.array([0.03, 0.05]), np.array([0.0, 0.01]))
    first, second = 200e9 * PI / 64.0 * 0.03**4, 200e9 * PI / 64.0 * (0.05**4 - 0.01**4)
    half = 0.2**3 / 12.0  # ∫ (x/2)² dx from 0 to 0.2
    known = influence(stepped, [0.0, 0.4], [0.2], elastic_modulus=200e9)
    assert known[0, 0] == pytest.approx(half / first + half / second, rel=1e-7)


def test_what_stands_outside_a_shaft_is_refused():
    loads = PointLoads(np.array([0.2]), np.array([1.0]), np.zeros(1), np.zeros(1))
    for bearings in ([0.0, 0.7], [-0.1, 0.5]):
        balanced = supported(loads, np.clip(bearings, 0.0, 0.6), length=0.6)
        with pytest.raises(DesignError, match="outside the shaft"):
            bent_line(diagram(balanced), UNIFORM, bearings, elastic_modulus=210e9)
    assert supported(loads, [0.0, 0.6], length=0.6).position.tolist() == [0.2, 0.0, 0.6]
    with pytest.raises(DesignError, match="outside"):
        supported(loads, [0.0, 0.6], length=0.1)


def test_one_mass_swings_at_the_root_of_stiffness_over_mass():
    """ω = 1/√(δ m); two uncoupled ones at the slower; a uniform shaft at π²/L² √(E I/(ρ A)) to 1e-3 by 40 pieces."""
    assert critical_speed(np.array([[2e-8]]), [5.0]) == near(1.0 / math.sqrt(1e-7))
    assert critical_speed(np.diag([2e-8, 1e-8]), [5.0, 20.0]) == near(1.0 / math.sqrt(2e-7))
    shaft = Sections(np.array([0.1, 0.6]), np.array([0.04]), np.array([0.02]))
    places, masses = lumped_shaft(shaft, 7800.0)
    assert len(places) == 40 and places[0] == near(0.1 + 0.5 / 80.0)
    assert masses == pytest.approx(7800.0 * PI / 4.0 * (0.04**2 - 0.02**2) * 0.5 / 40.0)
    own = critical_speed(influence(shaft, [0.1, 0.6], places, elastic_modulus=210e9), masses)
    exact = PI**2 / 0.25 * math.sqrt(RIGID / (7800.0 * PI / 4.0 * (0.04**2 - 0.02**2)))
    assert own == pytest.approx(exact, rel=1e-3)
    two = Sections(np.array([0.0, 0.3, 0.4]), np.array([0.03, 0.05]), np.array([0.01, 0.02]))
    places, masses = lumped_shaft(two, 1000.0, pieces=4)
    assert places.tolist() == pytest.approx([0.05, 0.15, 0.25, 0.35])
    assert masses == pytest.approx([PI * 0.02] * 3 + [PI / 4.0 * 2.1e-3 * 100.0])
    with pytest.raises(DesignError, match="masses"):
        critical_speed(np.diag([2e-8, 1e-8]), [5.0, -1.0])


SURFACES = {
    "ground": (1.58, -0.085),
    "machined": (4.51, -0.265),
    "hot-rolled": (57.7, -0.718),
    "forged": (272.0, -0.995),
}
"""Shigley, table 6-2, MPa."""
DEVIATES = {0.5: 0.0, 0.9: 1.288, 0.95: 1.645, 0.99: 2.326, 0.999: 3.091, 0.9999: 3.719}
"""Shigley, table 6-5."""


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("reliability", DEVIATES)
@pytest.mark.parametrize(
    ("millimetres", "size"), [(30.0, 1.24 * 30.0**-0.107), (60.0, 1.51 * 60.0**-0.157), (80.0, 1.51 * 80.0**-0.157)]
)
def test_marins_factors_are_shigleys(surface, reliability, millimetres, size):
    """k_a = a S_ut^b, k_b to 51 mm and beyond, k_e = 1 − 0.08 z_a, 0.5 S_ut up to 1400 MPa."""
    a, b = SURFACES[surface]
    for ultimate in (690.0, 1600.0):
        expected = min(a * ultimate**b, 1.0) * size * (1.0 - 0.08 * DEVIATES[reliability]) * 0.5 * min(ultimate, 1400.0)
        made = endurance_limit(ultimate * 1e6, millimetres * 1e-3, surface=surface, reliability=reliability)
        assert made == near(expected * 1e6)


def test_half_survive_if_nothing_else_is_said_and_a_finish_never_helps():
    """b < 0: 170 MPa ground gives 1.58 · 170^−0.085 = 1.021, which counts as 1; 51 mm still belong to the first law."""
    assert endurance_limit(170e6, 0.051, surface="ground") == near(85e6 * 1.24 * 51.0**-0.107)


STRESS = SectionStress(80e6, 50e6, 120e6)
STRENGTH = FatigueStrength(200e6, 900e6, 700e6)


def test_equivalent_stresses_and_safeties_are_those_of_chapter_7():
    """σ = 32 K_f M/(π d³ (1 − q⁴)), τ = half of it with K_fs; von Mises; Goodman, ASME, first yield."""
    load, notch = SectionLoad(300.0, 40.0, 70.0, 500.0), Concentration(1.7, 1.4)
    made = section_stress(load, 0.05, notch, bore=0.03)
    resist = PI * (0.05**4 - 0.03**4) / (32.0 * 0.05)

    def mises(moment, torque):
        return math.sqrt((1.7 * moment / resist) ** 2 + 3.0 * (1.4 * torque / (2.0 * resist)) ** 2)

    assert made == (near(mises(300.0, 70.0)), near(mises(40.0, 500.0)), near(mises(340.0, 570.0)))
    plain = section_stress(load, 0.05)
    resist = PI * 0.05**3 / 32.0
    assert plain.mean == near(math.sqrt((40.0 / resist) ** 2 + 3.0 * (250.0 / resist) ** 2))
    assert SectionLoad() == (0.0, 0.0, 0.0, 0.0) and section_stress(SectionLoad(), 0.05) == (0.0, 0.0, 0.0)
    assert goodman_safety(STRESS, STRENGTH) == near(1.0 / (80.0 / 200.0 + 50.0 / 900.0))
    assert asme_safety(STRESS, STRENGTH) == near(1.0 / math.sqrt((80.0 / 200.0) ** 2 + (50.0 / 700.0) ** 2))
    assert yield_safety(STRESS, STRENGTH) == near(700.0 / 120.0)
    assert yield_safety(SectionStress(0.0, 0.0, 0.0), STRENGTH) == math.inf


@pytest.mark.parametrize("shoulder", [Shoulder(0.04, 0.05, 2e-3), Shoulder(0.03, 0.06, 0.9e-3)])
def test_shoulders_raise_stress_by_din_743(shoulder):
    """α of DIN 743-2:2012; n with 10^−(0.33 + σ_S/712); φ counts only where d/D is above 0.67."""
    d, big, r, _ = shoulder
    t = (big - d) / 2.0
    shape = 0.62 * r / t + 2.0 * 5.8 * r / d * (1.0 + 2.0 * r / d) ** 2 + 0.2 * (r / t) ** 3 * d / big
    bending = 1.0 + 1.0 / math.sqrt(shape)
    shape = 3.4 * r / t + 38.0 * r / d * (1.0 + 2.0 * r / d) ** 2 + (r / t) ** 2 * d / big
    torsion = 1.0 + 1.0 / math.sqrt(shape)
    assert stress_concentration(shoulder) == (near(bending), near(torsion))
    phi = 1.0 / (4.0 * math.sqrt(t / r) + 2.0) if d / big > 0.67 else 0.0
    support = 10.0 ** -(0.33 + 500.0 / 712.0)
    felt = fatigue_notch_factor(shoulder, 500e6)
    assert felt.bending == near(bending / (1.0 + math.sqrt(2.3 * (1.0 + phi) / (r * 1e3)) * support))
    assert felt.torsion == near(torsion / (1.0 + math.sqrt(1.15 / (r * 1e3)) * support))


def test_a_step_of_two_thirds_is_not_yet_slender():
    """d/D = 0.68 is slender, 0.66 is not: φ = 0."""
    r = 1e-3
    shoulder = Shoulder(0.066, 0.1, r)
    bending = fatigue_notch_factor(shoulder, 500e6).bending
    support = 10.0 ** -(0.33 + 500.0 / 712.0)
    assert bending == near(stress_concentration(shoulder).bending / (1.0 + math.sqrt(2.3) * support))
    shoulder = Shoulder(0.068, 0.1, r)
    phi = 1.0 / (4.0 * math.sqrt(16e-3 / r) + 2.0)
    bending = fatigue_notch_factor(shoulder, 500e6).bending
    assert bending == near(stress_concentration(shoulder).bending / (1.0 + math.sqrt(2.3 * (1.0 + phi)) * support))


def test_fillets_hold_from_three_hundredths_of_the_step():
    """DIN 743-2: r/t ≥ 0.03, t = 10 mm: 0.31 mm is rated and 0.29 mm is told what it lacks."""
    assert stress_concentration(Shoulder(0.04, 0.06, 0.31e-3)).bending > 1.0
    with pytest.raises(DesignError, match=r"0\.29 mm given; the formulas hold from 0\.3 mm on"):
        stress_concentration(Shoulder(0.04, 0.06, 0.29e-3))


def test_an_undercut_raises_stress_between_its_shoulder_and_its_groove():
    """d = 39.6 mm, d_1 = 40 mm, D = 60 mm, r = 1.2 mm: α_A + (α_R − α_A) √(0.4/20.4), here with α_R by hand."""
    cut = Shoulder(0.0396, 0.060, 1.2e-3, 0.2e-3)
    found, plain = stress_concentration(cut), stress_concentration(cut._replace(undercut=0.0))
    slender, share = 1.2 / 39.6, math.sqrt(0.4 / 20.4)
    for k, (a, b) in enumerate(((0.2, 2.75), (0.7, 10.3))):
        groove = 1.0 + 1.0 / math.sqrt(a * 1.2 / 10.2 + 2.0 * b * slender * (1.0 + 2.0 * slender) ** 2)
        assert found[k] == pytest.approx(plain[k] + share * (groove - plain[k]), rel=1e-12)
        assert plain[k] < found[k] < groove
    support = 10.0 ** -(0.33 + 500.0 / 712.0)
    assert fatigue_notch_factor(cut, 500e6).torsion == pytest.approx(found.torsion / (1.0 + support / math.sqrt(1.2)))
    # As shallow as nothing it is the shoulder, as deep as the step the groove.
    assert stress_concentration(cut._replace(undercut=1e-15)) == pytest.approx(plain, rel=1e-6)
    groove = stress_concentration(cut._replace(larger=0.040))
    assert groove.torsion == pytest.approx(1.0 + 1.0 / math.sqrt(4.2 + 20.6 * slender * (1.0 + 2.0 * slender) ** 2))
    with pytest.raises(DesignError, match=r"shoulder\.undercut: 11 mm given; it is no deeper than the step, 10\.2 mm"):
        stress_concentration(cut._replace(undercut=11e-3))


@pytest.mark.parametrize(
    ("sizes", "raised"),
    [
        ((30.0, 38.0, 1.2, 0.2), (2.451 / 2.384, 1.713 / 1.676)),
        ((60.0, 69.0, 1.6, 0.3), (2.594 / 2.529, 1.790 / 1.759)),
        ((40.0, 50.0, 1.2, 0.2), (2.687 / 2.612, 1.835 / 1.796)),
    ],
)
def test_undercuts_raise_stress_by_more_than_finite_elements_say(sizes, raised):
    """Seat, step, r and t of DIN 509-F [mm]: peak stress with it over that of a shoulder of the same bottom and radius.

    Axisymmetric elements of second order, r/22 at the notch; in bending the first harmonic, in torsion a potential.
    """
    seat, step, radius, depth = (1e-3 * size for size in sizes)
    cut = Shoulder(seat - 2.0 * depth, step, radius, depth)
    found, plain = stress_concentration(cut), stress_concentration(cut._replace(undercut=0.0))
    for have, without, least in zip(found, plain, raised, strict=True):
        assert least < have / without < least + 0.06


def test_notch_sensitivity_is_neubers():
    """Shigley, eqs (6-34) and (6-35), S_ut = 100 ksi, r = 0.09 in: √r = 0.3."""
    ksi = 6894757.293168361
    q = notch_sensitivity(0.09 * 0.0254, 100.0 * ksi)
    bending = 0.246 - 0.308 + 0.151 - 0.0267
    torsion = 0.190 - 0.251 + 0.135 - 0.0267
    assert q == (near(1.0 / (1.0 + bending / 0.3)), near(1.0 / (1.0 + torsion / 0.3)))
    assert felt_concentration(Concentration(2.2, 1.8), Concentration(0.9, 0.7)) == (near(2.08), near(1.56))
    # An end-milled keyseat, r/d = 0.02: 2.14 and 3.0.
    q = notch_sensitivity(0.02 * 0.05, 690e6)
    assert keyseat_concentration(0.05, 690e6) == (near(1.0 + 1.14 * q.bending), near(1.0 + 2.0 * q.torsion))


@pytest.mark.parametrize("millimetres", [5.0, 25.0, 60.0, 200.0])
def test_what_sits_on_a_shaft_notches_it_by_din_743(millimetres):
    """Tested at 40 mm; K_3 = 1 − 0.2 lg β lg(d/7.5)/lg 20 between 7.5 and 150 mm."""

    def sized(beta):
        def k_3(d):
            return 1.0 - 0.2 * math.log10(beta) * math.log10(d / 7.5) / math.log10(20.0)

        return near(beta * k_3(40.0) / k_3(min(max(millimetres, 7.5), 150.0)))

    d = millimetres * 1e-3
    beta = 3.0 * 0.8**0.38
    assert keyway_factor(d, 800e6) == (sized(beta), sized(0.56 * beta + 0.1))
    beta = 2.7 * 0.8**0.43
    assert press_fit_factor(d, 800e6) == (sized(beta), sized(0.65 * beta))
    beta = math.exp(4.2e-7 * 800.0**2)
    assert spline_factor(d, 800e6) == (sized(1.0 + 0.49 * (beta - 1.0)), sized(beta))


GROUPS = {
    "STRUCTURAL": ((100.0, 0.23), (32.0, 0.26), 300.0),
    "NITRIDING": ((100.0, 0.23), (100.0, 0.23), 300.0),
    "TEMPERED": ((16.0, 0.26), (16.0, 0.34), 300.0),
    "NICKEL_CASE_HARDENED": ((16.0, 0.26), (16.0, 0.26), 300.0),
    "CASE_HARDENED": ((16.0, 0.41), (16.0, 0.41), 150.0),
}
"""DIN 743-2:2012, K_1: reference diameter and slope of σ_B and of σ_S, end of the range."""


@pytest.mark.parametrize("name", GROUPS)
def test_the_blank_lowers_strength_as_printed(name):
    for yielding, (reference, slope) in enumerate(GROUPS[name][:2]):
        for d in (10.0, 20.0, 50.0, 120.0, 200.0, 280.0, 500.0):
            expected = 1.0 - slope * math.log10(min(max(d, reference), GROUPS[name][2]) / reference)
            assert blank_factor(d * 1e-3, SteelGroup[name], yielding=bool(yielding)) == near(expected)


def test_size_and_surface_lower_strength_as_printed():
    """K_2 = 1 − 0.2 lg(d/7.5)/lg 20; K_Fσ = 1 − 0.22 lg R_z (lg(σ_B/20) − 1), K_Fτ = 0.575 K_Fσ + 0.425."""
    for d in (5.0, 7.5, 40.0, 150.0, 300.0):
        expected = 1.0 - 0.2 * math.log10(min(max(d, 7.5), 150.0) / 7.5) / math.log10(20.0)
        assert section_factor(d * 1e-3) == near(expected)
    for rough, ultimate in ((0.5, 800.0), (1.2, 800.0), (16.0, 800.0), (16.0, 2300.0)):
        k = 1.0 - 0.22 * math.log10(max(rough, 1.0)) * (math.log10(min(ultimate, 2000.0) / 20.0) - 1.0)
        assert surface_factors(rough * 1e-6, ultimate * 1e6) == (near(k), near(0.575 * k + 0.425))


def steel(group=SteelGroup.TEMPERED):
    return ShaftSteel(1100e6, 900e6, 550e6, 330e6, group)


def test_yielding_is_held_back_by_notches_and_the_core():
    """γ_F = 1, 1.05, 1.1, 1.15 by β_σ; K_2F = 1.2 solid, 1.1 and 1 hollow, 1 with a hard case."""
    for beta, gamma in ((1.2, 1.0), (1.5, 1.0), (1.7, 1.05), (2.0, 1.05), (2.5, 1.1), (3.0, 1.1), (3.5, 1.15)):
        notch = Concentration(beta, 1.3)
        for group, bore, support in (
            (SteelGroup.TEMPERED, 0.0, (1.2, 1.2)), (SteelGroup.NITRIDING, 0.02, (1.1, 1.0)),
            (SteelGroup.CASE_HARDENED, 0.0, (1.0, 1.0)), (SteelGroup.NICKEL_CASE_HARDENED, 0.02, (1.0, 1.0)),
        ):  # fmt: skip
            limits = yield_limits(ShaftSection(0.05, 0.06, notch, bore=bore), steel(group))
            strength = 900e6 * blank_factor(0.06, group, yielding=True)
            assert limits == (near(strength * support[0] * gamma), near(strength * support[1] / math.sqrt(3.0)))


@pytest.mark.parametrize("load", [SectionLoad(800.0, 150.0, 120.0, 600.0), SectionLoad(100.0, 4000.0, 100.0, 4000.0)])
def test_both_safeties_are_those_of_din_743(load):
    """K = (β/K_2 + 1/K_F − 1)/K_V; σ_ADK = σ_WK − ψ σ_mv, ψ = σ_WK/(2 K_1 σ_B − σ_WK), and at most σ_FK − σ_mv."""
    notch = Concentration(1.8, 1.4)
    section = ShaftSection(0.05, 0.06, notch, 4e-6, 0.02, 1.1)
    greatest = SectionLoad(1200.0, 300.0, 200.0, 1500.0)
    resist = PI / 32.0 * (0.05**4 - 0.02**4) / 0.05
    k_1 = blank_factor(0.06, SteelGroup.TEMPERED, yielding=False)
    k_2, rough = section_factor(0.05), surface_factors(4e-6, k_1 * 1100e6)
    yields = yield_limits(section, steel())
    mean_b, mean_t = load.bending_mean / resist, load.torque_mean / (2.0 * resist)
    mixed = math.sqrt(mean_b**2 + 3.0 * mean_t**2)
    used = 0.0
    for limit, beta, k_f, mean, yielding, stress in (
        (550e6, 1.8, rough[0], mixed, yields[0], load.bending_amplitude / resist),
        (330e6, 1.4, rough[1], mixed / math.sqrt(3.0), yields[1], load.torque_amplitude / (2.0 * resist)),
    ):
        part = k_1 * limit / ((beta / k_2 + 1.0 / k_f - 1.0) / 1.1)
        psi = part / (2.0 * k_1 * 1100e6 - part)
        used += (stress / min(part - psi * mean, yielding - mean)) ** 2
    strained = math.hypot(1500.0 / resist / yields[0], 1700.0 / (2.0 * resist) / yields[1])
    safety = din743_safety(load, section, steel(), greatest=greatest)
    assert safety == (near(1.0 / math.sqrt(used)), near(1.0 / strained))


def test_a_section_without_load_needs_no_strength():
    """Without amplitude or load a section is safe without end; ground to 10 µm and solid if nothing else is said."""
    section = ShaftSection(0.05, 0.06, Concentration(1.8, 1.4))
    assert (section.roughness, section.bore, section.hardening) == (10e-6, 0.0, 1.0)
    none = SectionLoad()
    assert din743_safety(none, section, steel(), greatest=none) == (math.inf, math.inf)
    with pytest.raises(DesignError, match="no fatigue strength"):
        din743_safety(SectionLoad(1.0, 2e4), section, steel(), greatest=none)


def test_the_corners_of_gamma_are_in_order():
    """Each row of γ_F begins where the last ended."""
    limits = [
        yield_limits(ShaftSection(0.05, 0.06, Concentration(beta, 1.0)), steel()).bending
        for beta in (1.0, 1.6, 2.4, 4.0)
    ]
    for less, more in pairwise(limits):
        assert more > less
