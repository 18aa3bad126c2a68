"""Rolling bearings by the formulas and tables of ISO 281, ISO 76 and ISO/TS 16281, written out once more."""

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.special import ellipe, ellipk

from gearwright.errors import DesignError
from gearwright.parts.bearings import (
    BearingGeometry,
    BearingKind,
    Cleanliness,
    OilFilter,
    RingLoad,
    ball_contacts,
    basic_life,
    basic_reference_life,
    cleanliness_factor,
    contamination_factor,
    dynamic_rating,
    ellipse_ratio,
    equivalent_load,
    fatigue_load_limit,
    life_modification,
    life_time,
    load_at_pressure,
    load_deflection_constant,
    load_distribution,
    mean_load,
    reference_viscosity,
    reliability_factor,
    static_equivalent_load,
    static_rating,
    static_safety,
    system_life,
    taper_factors,
    taper_pair_thrusts,
    taper_static_factors,
    weibull_slope,
)
from gearwright.parts.bearings.life import (
    DEEP_GROOVE_STATIC,
    FOUR_POINT,
    FOUR_POINT_STATIC,
    ISO_R281_1962,
    LoadFactors,
    StaticFactors,
    deep_groove_factors,
)
from gearwright.parts.bearings.rolling_bearing import (
    Contacts,
    Curvature,
    ball_dynamic_factor,
    ball_static_factor,
    roller_dynamic_factor,
)

DEEP, FOUR, ROLLER, TAPER = BearingKind
BALL = BearingGeometry(DEEP, 9, 15e-3, 62e-3, 0.3, rows=2, inner_conformity=0.515, outer_conformity=0.535)
LARGE = BearingGeometry(DEEP, 11, 30e-3, 150e-3, 0.2)
NEEDLE = BearingGeometry(ROLLER, 14, 12e-3, 70e-3, 0.0, 14e-3)
CONE = BearingGeometry(TAPER, 17, 9e-3, 60e-3, 0.25, 16e-3, rows=2)


def near(value):
    return pytest.approx(value, rel=1e-10, abs=0.0)


def test_ratios_of_a_bearing_are_those_of_its_drawing():
    """γ = D_w cos α/D_pw; (r_i/r_e)(2 r_e − D)/(2 r_i − D); grooves of 0.52 and 0.53, one row, no angle."""
    assert BALL.curvature_ratio == near(15.0 * math.cos(0.3) / 62.0)
    assert BALL.conformity_ratio == near(0.515 / 0.535 * 0.07 / 0.03)
    usual = BearingGeometry(DEEP, 3, 15e-3, 62e-3)
    assert (usual.inner_conformity, usual.outer_conformity, usual.rows) == (0.52, 0.53, 1)
    assert usual.curvature_ratio == near(15.0 / 62.0)
    assert [kind.is_ball for kind in BearingKind] == [True, True, False, False]
    with pytest.raises(DesignError, match="roller_length"):
        BearingGeometry(ROLLER, 14, 12e-3, 70e-3)


@pytest.mark.parametrize(("gamma", "f_c"), [(0.05, 46.7), (0.10, 55.5), (0.16, 59.6), (0.22, 59.6), (0.30, 56.0)])
def test_the_factor_of_balls_is_that_of_table_2(gamma, f_c):
    """ISO 281:2007, table 2, to its printed digit."""
    assert ball_dynamic_factor(BearingGeometry(DEEP, 9, gamma * 0.1, 0.1)) == pytest.approx(f_c, abs=0.06)


@pytest.mark.parametrize("bearing", [BALL, LARGE, BearingGeometry(FOUR, 12, 25.4e-3, 140e-3, 0.6, rows=2)])
def test_the_dynamic_rating_of_balls_is_that_of_clause_5(bearing):
    """ISO/TR 1281-1: f_c with λ = 0.95 and r_e = r_i; b_m = 1.3; D_w^1.8, or 3.647 D_w^1.4 above 25.4 mm."""
    gamma, r = bearing.curvature_ratio, bearing.inner_conformity
    f_c = 0.41 * 98.0665 * 0.95 * (2.0 * r / (2.0 * r - 1.0)) ** 0.41
    f_c *= (1.0 + (1.04 * ((1.0 - gamma) / (1.0 + gamma)) ** 1.72) ** (10.0 / 3.0)) ** -0.3
    f_c *= gamma**0.3 * (1.0 - gamma) ** 1.39 / (1.0 + gamma) ** (1.0 / 3.0)
    assert ball_dynamic_factor(bearing) == near(f_c)
    size = bearing.diameter * 1e3
    size = size**1.8 if size <= 25.4 else 3.647 * size**1.4
    along = (bearing.rows * math.cos(bearing.contact_angle)) ** 0.7
    assert dynamic_rating(bearing) == near(1.3 * f_c * along * bearing.elements ** (2.0 / 3.0) * size)


@pytest.mark.parametrize("bearing", [NEEDLE, CONE])
def test_the_ratings_of_rollers_are_those_of_clause_7(bearing):
    """ISO/TR 1281-1: 207.9 λν, λν = 0.83; b_m = 1.1. ISO 76: 44 (1 − γ) i Z L D cos α."""
    gamma = bearing.curvature_ratio
    f_c = 207.9 * 0.83 * (1.0 + (1.04 * ((1.0 - gamma) / (1.0 + gamma)) ** (143.0 / 108.0)) ** 4.5) ** (-2.0 / 9.0)
    f_c *= gamma ** (2.0 / 9.0) * (1.0 - gamma) ** (29.0 / 27.0) / (1.0 + gamma) ** 0.25
    assert roller_dynamic_factor(bearing) == near(f_c)
    along, d, length = (
        bearing.rows * math.cos(bearing.contact_angle),
        bearing.diameter * 1e3,
        bearing.roller_length * 1e3,
    )
    rating = 1.1 * f_c * (along * length) ** (7.0 / 9.0) * bearing.elements**0.75 * d ** (29.0 / 27.0)
    assert dynamic_rating(bearing) == near(rating)
    assert static_rating(bearing) == near(44.0 * (1.0 - gamma) * along * bearing.elements * length * d)


def hertz(curvature):
    """χ by bisection of 1 − 2/(χ² − 1)(K/E − 1) = F(ρ), with K(χ) and E(χ) there."""
    low, high = 1.0 + 1e-7, 1e3
    for _ in range(200):
        chi = math.sqrt(low * high)
        k, e = ellipk(1.0 - chi**-2), ellipe(1.0 - chi**-2)
        low, high = (chi, high) if 1.0 - 2.0 / (chi**2 - 1.0) * (k / e - 1.0) < curvature.difference else (low, chi)
    return chi, k, e


def curvatures(bearing):
    """Σρ and F(ρ) of ISO/TS 16281 at the inner and the outer ring."""
    gamma, d = bearing.curvature_ratio, bearing.diameter
    for rolling, conformity in (
        (gamma / (1.0 - gamma), bearing.inner_conformity),
        (-gamma / (1.0 + gamma), bearing.outer_conformity),
    ):
        groove = 1.0 / (2.0 * conformity)
        yield Curvature(2.0 / d * (2.0 + rolling - groove), (rolling + groove) / (2.0 + rolling - groove))


@pytest.mark.parametrize("bearing", [BALL, LARGE])
def test_the_contacts_of_a_ball_are_hertz(bearing):
    """Semi-axes a = (2 χ² E/π · 3 Q (1 − ν²)/(E Σρ))^⅓ and a/χ, p = 3 Q/(2 π a b): the pressure comes back."""
    contacts = ball_contacts(bearing)
    for contact, expected in zip(contacts, curvatures(bearing), strict=True):
        assert contact == pytest.approx(expected, rel=1e-12)
        chi, _, e = hertz(contact)
        assert ellipse_ratio(contact.difference) == pytest.approx(chi, rel=1e-9)
        load = load_at_pressure(contact, 2.5e9, elastic_modulus=200e9, poisson_ratio=0.28)
        size = math.cbrt(2.0 * chi**2 * e / math.pi * 3.0 * load * (1.0 - 0.28**2) / (200e9 * contact.total))
        assert 3.0 * load / (2.0 * math.pi * size * size / chi) == pytest.approx(2.5e9, rel=1e-9)
    assert ellipse_ratio(5e-5) == near(math.exp(4.0 / 3.0 * 5e-5))
    assert ellipse_ratio(2e-4) == pytest.approx(math.exp(4.0 / 3.0 * 2e-4), rel=1e-7)
    stiff = load_deflection_constant(contacts, elastic_modulus=200e9, poisson_ratio=0.28)
    assert stiff == pytest.approx(deflection_constant(bearing, 200e9, 0.28), rel=1e-9)


def deflection_constant(bearing, modulus, poisson):
    """c_P = π √2/3 E/(1 − ν²) (Σ K (Σρ/(χ² E))^⅓)^−1.5, ISO/TS 16281."""
    approach = 0.0
    for contact in curvatures(bearing):
        chi, k, e = hertz(contact)
        approach += k * math.cbrt(contact.total / (chi**2 * e))
    return math.pi * math.sqrt(2.0) / 3.0 * modulus / (1.0 - poisson**2) * approach**-1.5


@pytest.mark.parametrize("bearing", [BALL, LARGE])
def test_the_static_rating_of_balls_presses_the_worse_ring_with_4200_mpa(bearing):
    """f_0 = Q(4200 MPa)/(5 D_w²) with 207 GPa and 0.3 (ISO/TR 10657); C_0r = f_0 i Z D_w² cos α (ISO 76)."""
    loads = []
    for contact in curvatures(bearing):
        chi, _, e = hertz(contact)
        size = math.cbrt(2.0 * chi**2 * e / math.pi * 3.0 * 0.91 / (207e9 * contact.total))
        loads.append((4200e6 * 2.0 * math.pi / 3.0 * size**2 / chi) ** 3)
    assert ball_static_factor(bearing) == pytest.approx(min(loads) / (5.0 * (bearing.diameter * 1e3) ** 2), rel=1e-8)
    assert static_rating(bearing) == pytest.approx(
        min(loads) / 5.0 * bearing.rows * bearing.elements * math.cos(bearing.contact_angle), rel=1e-8
    )


def test_the_fatigue_limit_is_a_share_of_the_static_rating():
    """ISO 281, annex B: C_0/22 and C_0/8.2; above 100 mm with (100/D_pw)^0.5 and ^0.3."""
    wide = BearingGeometry(ROLLER, 14, 12e-3, 170e-3, 0.0, 14e-3)
    assert fatigue_load_limit(22e3, BALL) == near(1e3)
    assert fatigue_load_limit(22e3, LARGE) == near(1e3 * (100.0 / 150.0) ** 0.5)
    assert fatigue_load_limit(8.2e3, NEEDLE) == near(1e3)
    assert fatigue_load_limit(8.2e3, wide) == near(1e3 * (100.0 / 170.0) ** 0.3)


RELATIVE = (0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89)
LIMITS = (0.19, 0.22, 0.26, 0.28, 0.30, 0.34, 0.38, 0.42, 0.44)
AXIAL = (2.30, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.00)
OLD = ((0.025, 0.22, 2.0), (0.04, 0.24, 1.8), (0.07, 0.27, 1.6), (0.13, 0.31, 1.4), (0.25, 0.37, 1.2), (0.5, 0.44, 1.0))


def test_the_factors_of_deep_groove_bearings_are_the_printed_rows():
    """ISO 281:2007, table 3, and ISO/R 281:1962; linear between rows, held beyond."""
    for relative, limit, axial in zip(RELATIVE, LIMITS, AXIAL, strict=True):
        assert deep_groove_factors(relative) == LoadFactors(near(limit), 0.56, near(axial), 0.0)
    for relative, limit, axial in OLD:
        assert deep_groove_factors(relative, ISO_R281_1962) == LoadFactors(near(limit), 0.56, near(axial), 0.0)
    assert deep_groove_factors(0.05) == LoadFactors(0.19, 0.56, 2.30)
    assert deep_groove_factors(9.0) == LoadFactors(0.44, 0.56, 1.00)
    assert deep_groove_factors(0.517).axial == near(1.85)
    for (x_1, e_1, y_1), (x_2, e_2, y_2) in pairwise(OLD):
        middle = deep_groove_factors((x_1 + x_2) / 2.0, ISO_R281_1962)
        assert middle == LoadFactors(near((e_1 + e_2) / 2.0), 0.56, near((y_1 + y_2) / 2.0))
    rows = tuple(zip(RELATIVE, LIMITS, AXIAL, strict=True))
    for (x_1, e_1, y_1), (x_2, e_2, y_2) in pairwise(rows):
        middle = deep_groove_factors((x_1 + x_2) / 2.0)
        assert middle == LoadFactors(near((e_1 + e_2) / 2.0), 0.56, near((y_1 + y_2) / 2.0))


def test_equivalent_loads_are_those_of_both_standards():
    """ISO 281, 5.2 and 7.2; ISO 76, 5.2 and 7.2; a taper of 14° by table 8; a four-point bearing of 35° by table 3."""
    factors = LoadFactors(0.3, 0.56, 1.45, 0.2)
    assert equivalent_load(1000.0, -250.0, factors) == near(1050.0)
    assert equivalent_load(1000.0, 300.0, factors) == near(1060.0)
    assert equivalent_load(1000.0, -400.0, factors) == near(560.0 + 580.0)
    assert equivalent_load(1000.0, 200.0, LoadFactors(0.3, 0.56, 1.45)) == 1000.0
    tangent = math.tan(math.radians(14.0))
    assert taper_factors(math.radians(14.0)) == LoadFactors(near(1.5 * tangent), 0.4, near(0.4 / tangent))
    assert taper_static_factors(math.radians(14.0)) == StaticFactors(0.5, near(0.22 / tangent))
    assert equivalent_load(1000.0, 900.0, FOUR_POINT) == near(1594.0)
    assert equivalent_load(1000.0, 1000.0, FOUR_POINT) == near(1670.0)
    assert equivalent_load(1000.0, 950.0, FOUR_POINT) == near(1627.0)
    assert static_equivalent_load(1000.0, -500.0, FOUR_POINT_STATIC) == near(1290.0)
    assert static_equivalent_load(1000.0, -900.0, DEEP_GROOVE_STATIC) == near(1050.0)
    assert static_equivalent_load(1000.0, 300.0, DEEP_GROOVE_STATIC) == 1000.0
    assert static_safety(30e3, 20e3) == near(1.5)


def test_spectra_and_pairs_of_tapers_are_linear_damage_and_statics():
    """(Σ P^p n/Σ n)^(1/p); thrusts F_r/(2 Y), the one that is pushed together bears what is left over."""
    assert mean_load([1000.0, 3000.0], [3.0, 1.0]) == near((30.0e9 / 4.0) ** (1.0 / 3.0))
    assert mean_load([1000.0, 3000.0], [3.0, 1.0], 2.0) == near(math.sqrt(12e6 / 4.0))
    factors = (LoadFactors(0.4, 0.4, 1.5), LoadFactors(0.4, 0.4, 2.0))
    assert taper_pair_thrusts((3000.0, 2000.0), 200.0, factors) == (near(1000.0), near(800.0))
    assert taper_pair_thrusts((3000.0, 2000.0), 900.0, factors) == (near(1400.0), near(500.0))
    assert taper_pair_thrusts((3000.0, 2000.0), -900.0, factors) == (near(1000.0), near(1900.0))


def test_lives_are_those_of_clause_5_and_table_12():
    """p = 3 and 10/3; a_1 of ISO 281:2007, table 12; e = 10/9 and 9/8; L/ω."""
    assert basic_life(40e3, 10e3, FOUR) == near(64.0)
    assert basic_life(80e3, 10e3, TAPER) == near(8.0 ** (10.0 / 3.0)) == near(basic_life(80e3, 10e3, ROLLER))
    assert basic_life(0.5, 0.25, DEEP) == near(8.0)
    shares = ((0.90, 1.0), (0.95, 0.64), (0.96, 0.55), (0.97, 0.47), (0.98, 0.37), (0.99, 0.25), (0.995, 0.175),
              (0.999, 0.093))  # fmt: skip
    for reliability, share in shares:
        assert reliability_factor(reliability) == near(share)
    for (r_1, s_1), (r_2, s_2) in pairwise(shares):
        assert reliability_factor((r_1 + r_2) / 2.0) == near((s_1 + s_2) / 2.0)
    assert (weibull_slope(DEEP), weibull_slope(ROLLER)) == (near(10.0 / 9.0), near(1.125))
    assert life_time(3.0, -200.0) == near(3e6 * 2.0 * math.pi / 200.0)
    assert life_time(3.0, 0.0) == math.inf


def test_a_set_of_bearings_outlives_as_the_product_of_its_survivals():
    """Σ (L/L_i)^e_i = 1; of equal slopes in closed form, with 10/9 if none is said."""
    assert system_life([800.0, 1200.0]) == near((800.0 ** (-10 / 9) + 1200.0 ** (-10 / 9)) ** -0.9)
    life = system_life([800.0, 1200.0, 500.0], [10.0 / 9.0, 9.0 / 8.0, 1.5])
    assert (life / 800.0) ** (10 / 9) + (life / 1200.0) ** 1.125 + (life / 500.0) ** 1.5 == near(1.0)


def test_the_reference_life_is_that_of_iso_ts_16281():
    """Q_ci with 0.407 and Q_ce with 0.389, L = (Σ (Q_e/Q_c)^(10/3))^−0.9, cubic mean inside, 10/3 outside."""
    forces, gamma = np.array([900.0, 2500.0, 400.0, 0.0]), BALL.curvature_ratio
    rings = 1.044 * ((1.0 - gamma) / (1.0 + gamma)) ** 1.72 * (0.515 / 0.535 * 0.07 / 0.03) ** 0.41
    ball = 45e3 / (9.0 * math.cos(0.3) ** 0.7 * 2.0**0.7)
    inner = ball / 0.407 * (1.0 + rings ** (10.0 / 3.0)) ** 0.3
    outer = ball / 0.389 * (1.0 + rings ** (-10.0 / 3.0)) ** 0.3
    q_i = ((900.0**3 + 2500.0**3 + 400.0**3) / 4.0) ** (1.0 / 3.0)
    q_e = ((900.0 ** (10 / 3) + 2500.0 ** (10 / 3) + 400.0 ** (10 / 3)) / 4.0) ** 0.3
    expected = ((q_i / inner) ** (10.0 / 3.0) + (q_e / outer) ** (10.0 / 3.0)) ** -0.9
    assert basic_reference_life(BALL, 45e3, forces) == near(expected)


@pytest.mark.parametrize("load", [
    RingLoad(3000.0, 1200.0, 800.0, 15.0, -9.0), RingLoad(x=4000.0), RingLoad(axial=-2500.0),
    RingLoad(y=500.0, moment_x=40.0),
])  # fmt: skip
@pytest.mark.parametrize("clearance", [0.0, 25e-6])
def test_every_ball_bears_what_its_groove_centres_approach(load, clearance):
    """ISO/TS 16281, ball by ball: s/2 taken from A, tilt about R_i, forces summed about D_pw/2; the solver's 1e-8."""
    bearing = BearingGeometry(DEEP, 9, 15e-3, 62e-3, inner_conformity=0.515, outer_conformity=0.535)
    result = load_distribution(bearing, load, clearance=clearance)
    motion, a = result.motion, (0.515 + 0.535 - 1.0) * 15e-3
    c_p = deflection_constant(bearing, 210e9, 0.3)
    cosine = 1.0 - clearance / (2.0 * a)
    arm = 31e-3 + 0.015 * 15e-3 * cosine
    sums = np.zeros(5)
    for j in range(9):
        c, s = math.cos(2.0 * math.pi * j / 9.0), math.sin(2.0 * math.pi * j / 9.0)
        radial = a * cosine + motion.x * c + motion.y * s
        axial = motion.axial + arm * (math.sin(motion.tilt_x) * c + math.sin(motion.tilt_y) * s)
        force, angle = c_p * max(math.hypot(radial, axial) - a, 0.0) ** 1.5, math.atan2(axial, radial)
        assert result.force[j] == pytest.approx(force, rel=1e-6, abs=1e-3)
        assert result.contact_angle[j] == pytest.approx(angle, rel=1e-9, abs=1e-12)
        across, along = force * math.cos(angle), force * math.sin(angle)
        sums += [across * c, across * s, along, 31e-3 * along * c, 31e-3 * along * s]
    size = max(abs(force) for force in load[:3])
    assert sums[:3] == pytest.approx(np.array(load[:3]), abs=1e-6 * size)
    assert sums[3:] == pytest.approx(np.array(load[3:]), abs=1e-6 * size * a + 1e-6 * max(map(abs, load[3:])))
    assert motion.radial == near(math.hypot(motion.x, motion.y))
    assert motion.tilt == near(math.hypot(motion.tilt_x, motion.tilt_y))


def test_a_clearance_as_wide_as_the_grooves_is_refused():
    """2 A = 2 · 0.05 · 15 mm is where no ball is left between the rings."""
    with pytest.raises(DesignError, match="allowed: 0 to 1500 µm"):
        load_distribution(BearingGeometry(DEEP, 9, 15e-3, 62e-3), RingLoad(x=1.0), clearance=1.6e-3)


def modified(kappa, share, ball):
    """a_ISO of ISO 281:2007, eqs (31) to (36)."""
    if ball:
        constant, inner, outer, last = 2.5671, 0.83, 1.0 / 3.0, 9.3
        film = 2.2649 / kappa**0.054381 if kappa < 0.4 else 1.9987 / kappa ** (0.19087 if kappa < 1.0 else 0.071739)
    else:
        constant, inner, outer, last = 1.5859, 1.0, 0.4, 9.185
        film = 1.3993 / kappa**0.054381 if kappa < 0.4 else 1.2348 / kappa ** (0.19087 if kappa < 1.0 else 0.071739)
    return 0.1 * (1.0 - (constant - film) ** inner * share**outer) ** -last


@pytest.mark.parametrize("kappa", [0.1, 0.25, 0.39, 0.45, 0.7, 1.1, 2.5, 4.0])
@pytest.mark.parametrize("kind", BearingKind)
def test_oil_changes_life_by_the_printed_constants(kappa, kind):
    assert life_modification(0.08, kappa, kind) == near(modified(kappa, 0.08, kind.is_ball))


def test_more_than_four_and_fifty_do_not_count():
    assert life_modification(0.08, 6.0, ROLLER) == near(modified(4.0, 0.08, False))
    assert 50.0 < modified(4.0, 0.24, True) < 60.0
    for share in (0.24, 0.9, 3.0):
        assert life_modification(share, 4.0, DEEP) == 50.0
    value = life_modification(0.22, 4.0, DEEP)
    assert value == near(modified(4.0, 0.22, True)) and 40.0 < value < 50.0


def test_films_and_filters_are_those_of_clause_9_and_annex_a():
    """45000 n^−0.83 D^−½ below 1000 rpm, 4500 n^−½ D^−½ from there on; e_C of A.4 and table 13."""
    for rpm, law in ((400.0, 45000.0 * 400.0**-0.83), (1600.0, 4500.0 / 40.0)):
        assert reference_viscosity(-rpm * math.pi / 30.0, 0.081) == near(1e-6 * law / 9.0)
    assert reference_viscosity(1100.0 * math.pi / 30.0, 0.081) == near(1e-6 * 500.0 * 1100.0**-0.5)
    constants = ((0.0864, 0.5663), (0.0432, 0.9987), (0.0288, 1.6329), (0.0216, 2.3362))
    for oil_filter, (slope, coarse) in zip(OilFilter, constants, strict=True):
        film = slope * 0.6**0.68 * 64.0**0.55
        assert film < 1.0
        assert contamination_factor(oil_filter, 0.6, 0.064) == near(film * (1.0 - coarse / 4.0))
    assert contamination_factor(OilFilter.BETA_6_200, 4.0, 0.216) == near(1.0 - 0.5663 / 6.0)
    assert contamination_factor(OilFilter.BETA_40_75, 0.6, 0.008) == 0.0
    words = ((1.0, 1.0), (0.7, 0.85), (0.55, 0.7), (0.4, 0.5), (0.2, 0.3), (0.05, 0.05))
    for word, (small, large) in zip(Cleanliness, words, strict=True):
        assert (cleanliness_factor(word, 0.099), cleanliness_factor(word, 0.1)) == (small, large)


def test_two_alike_contacts_halve_what_one_would_bear_at_a_depth():
    """c_P of two equal contacts is that of one over 2^1.5."""
    contact = Curvature(300.0, 0.9)
    chi, k, e = hertz(contact)
    one = math.pi * math.sqrt(2.0) / 3.0 * 210e9 / 0.91 * (k * math.cbrt(300.0 / (chi**2 * e))) ** -1.5
    both = load_deflection_constant(Contacts(contact, contact), elastic_modulus=210e9, poisson_ratio=0.3)
    assert both == pytest.approx(one / 2.0**1.5, rel=1e-9)
