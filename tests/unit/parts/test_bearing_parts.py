"""Bearings from inside: what must hold whatever the numbers, and what is refused."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from gearwright.errors import DesignError
from gearwright.parts.bearings import (
    DEEP_GROOVE_STATIC,
    FOUR_POINT,
    FOUR_POINT_STATIC,
    BearingGeometry,
    BearingKind,
    Cleanliness,
    Curvature,
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
    static_safety,
    system_life,
    taper_factors,
    taper_pair_thrusts,
    taper_static_factors,
    weibull_slope,
)

BALL = BearingGeometry(BearingKind.DEEP_GROOVE, 8, 17.462e-3, 72.5e-3)
"""A 6309."""


@given(st.floats(0.0, 0.99))
def test_ellipse_ratio_solves_its_equation(difference):
    """A longer ellipse belongs to a greater difference of curvature, and a circle to none."""
    ratio = ellipse_ratio(difference)
    assert ratio >= 1.0
    assert ellipse_ratio(min(difference + 0.005, 0.995)) > ratio


def test_a_sphere_on_a_plane_is_hertz():
    """Contact of circle: p = (6 Q E*²/(π³ R²))^(1/3) with 1/E* = 2 (1−ν²)/E; here Σρ = 2/R, F(ρ) = 0."""
    radius, modulus, pressure = 0.01, 210e9, 1e9
    reduced = modulus / (2.0 * (1.0 - 0.3**2))
    expected = math.pi**3 * radius**2 * pressure**3 / (6.0 * reduced**2)
    load = load_at_pressure(Curvature(2.0 / radius, 0.0), pressure, elastic_modulus=modulus, poisson_ratio=0.3)
    assert load == pytest.approx(expected, rel=1e-9)


def test_two_stiff_contacts_in_series_are_softer_than_either():
    """c_P grows with E and not faster."""
    soft, hard = (
        load_deflection_constant(ball_contacts(BALL), elastic_modulus=modulus, poisson_ratio=0.3)
        for modulus in (100e9, 200e9)
    )
    assert hard == pytest.approx(2.0 * soft)


@given(
    st.floats(100.0, 2e4),
    st.integers(-100, 100).map(lambda step: 100.0 * step),
    st.integers(0, 40).map(lambda step: 1e-6 * step),
)
def test_balls_hold_what_loads_the_ring(radial, axial, clearance):
    """Forces of the balls sum to the load: Σ Q cos α cos φ = F_r, Σ Q sin α = F_a; solver's 1e-8 with room."""
    found = load_distribution(BALL, RingLoad(x=radial, axial=axial), clearance=clearance)
    around = 2.0 * np.pi * np.arange(8) / 8
    size = math.hypot(radial, axial)
    assert (found.force * np.cos(found.contact_angle)) @ np.cos(around) == pytest.approx(radial, abs=1e-6 * size)
    assert found.force @ np.sin(found.contact_angle) == pytest.approx(axial, abs=1e-6 * size)


def test_stribeck_heaviest_ball():
    """With no clearance the heaviest ball bears 4.37 F_r/Z (Stribeck 1907: point contact, many balls)."""
    many = BearingGeometry(BearingKind.DEEP_GROOVE, 24, 6e-3, 72.5e-3)
    found = load_distribution(many, RingLoad(x=1000.0), clearance=0.0)
    assert found.force.max() == pytest.approx(4.37 * 1000.0 / 24, rel=0.005)


def test_tilt_turns_with_the_couple():
    """A bearing is alike in every direction of a ball: turning the couple turns the tilt."""
    along = load_distribution(BALL, RingLoad(moment_x=20.0), clearance=0.0).motion
    across = load_distribution(BALL, RingLoad(moment_y=20.0), clearance=0.0).motion
    assert across.tilt_y == pytest.approx(along.tilt_x, rel=1e-6)
    assert abs(across.tilt_x) < 1e-9


def test_reference_life_of_a_radial_load_is_near_the_basic_one():
    """With a small clearance half the balls bear: P_ref is F_r within 10 % (ISO 281 is made for that)."""
    found = load_distribution(BALL, RingLoad(x=8e3), clearance=0.0)
    rating = dynamic_rating(BALL)
    life = basic_reference_life(BALL, rating, found.force)
    assert rating / math.cbrt(life) == pytest.approx(8e3, rel=0.1)


def test_negative_clearance_is_refused():
    """And the range is named."""
    with pytest.raises(DesignError, match=r"clearance: -5 µm given; allowed: 0 to 1746 µm"):
        load_distribution(BALL, RingLoad(x=1e3), clearance=-5e-6)


def test_a_bearing_without_load_is_refused():
    """There is no direction to go."""
    with pytest.raises(DesignError, match="nothing loads the bearing"):
        load_distribution(BALL, RingLoad(), clearance=0.0)


def test_impossible_insides_are_all_named_at_once():
    """Two balls, too thick ones, and a groove tighter than its ball."""
    with pytest.raises(DesignError) as caught:
        BearingGeometry(BearingKind.DEEP_GROOVE, 2, 0.08, 0.07, inner_conformity=0.5)
    assert [problem.path for problem in caught.value.problems] == ["elements", "diameter", "conformity"]


def test_taper_bearings_need_an_angle():
    """Without one they bear no thrust, and Y has no end."""
    with pytest.raises(DesignError, match="0° given; a taper bearing has more than 0°"):
        BearingGeometry(BearingKind.TAPER, 20, 0.01, 0.065, roller_length=0.012)


def test_static_load_of_deep_groove_and_four_point_bearings():
    """ISO 76: 0.6 F_r + 0.5 F_a, and F_r + 0.58 F_a."""
    assert static_equivalent_load(1e3, 4e3, DEEP_GROOVE_STATIC) == pytest.approx(2.6e3)
    assert static_equivalent_load(1e3, 4e3, FOUR_POINT_STATIC) == pytest.approx(3.32e3)


def test_rollers_need_a_length():
    """Line contact has one."""
    with pytest.raises(DesignError, match="rollers need a length"):
        BearingGeometry(BearingKind.CYLINDRICAL, 15, 0.012, 0.065)


def test_large_balls_join_the_small_ones():
    """At 25.4 mm: D^1.8 = 3.647 D^1.4 within 0.02 %."""
    below, above = (
        dynamic_rating(BearingGeometry(BearingKind.DEEP_GROOVE, 8, size, 5.0 * size)) for size in (0.025399, 0.025401)
    )
    assert above == pytest.approx(below, rel=5e-4)


def test_fatigue_limit_shrinks_above_100_mm():
    """C_0/22 (rollers 8.2) below, and times (100/D_pw)^0.5 (rollers 0.3) above."""
    large = BearingGeometry(BearingKind.DEEP_GROOVE, 8, 0.04, 0.4)
    rollers = BearingGeometry(BearingKind.CYLINDRICAL, 20, 0.04, 0.4, roller_length=0.04)
    assert fatigue_load_limit(22e3, BALL) == pytest.approx(1e3)
    assert fatigue_load_limit(22e3, large) == pytest.approx(500.0)
    assert fatigue_load_limit(8.2e3, rollers) == pytest.approx(1e3 * 0.25**0.3)


@given(st.floats(0.0, 2e4), st.floats(-2e4, 2e4))
def test_no_load_is_rated_below_its_radial_share(radial, axial):
    """P_0 ≥ F_r always, and P ≥ 0.6 F_r for four points."""
    assert static_equivalent_load(radial, axial, taper_static_factors(0.25)) >= radial
    assert equivalent_load(radial, axial, FOUR_POINT) >= 0.6 * radial


def test_two_taper_bearings_balance_the_shaft():
    """The difference of both thrusts is the external force, and none is below its own."""
    factors = (taper_factors(0.25), taper_factors(0.25))
    for axial in (-9e3, -100.0, 0.0, 100.0, 9e3):
        first, second = taper_pair_thrusts((4e3, 6e3), axial, factors)
        assert first - second == pytest.approx(axial)
        assert first >= 4e3 / (2.0 * factors[0].axial)
        assert second >= 6e3 / (2.0 * factors[1].axial)


def test_mean_load_of_a_constant_load_is_that_load():
    """And of a mix the cubes count: ((5³ + 3 · 10³)/4)^(1/3)."""
    assert mean_load([5.0, 5.0], [0.3, 0.9]) == pytest.approx(5.0)
    assert mean_load([5.0, 10.0], [2.0, 6.0]) == pytest.approx((3125.0 / 4.0) ** (1.0 / 3.0))
    assert mean_load([5.0, 10.0], [1.0, 1.0], 10.0 / 3.0) > mean_load([5.0, 10.0], [1.0, 1.0])


def test_a_shaft_at_rest_lives_for_ever():
    """No turns, no fatigue."""
    assert life_time(1.0, 0.0) == math.inf


def test_system_is_shorter_lived_than_its_worst():
    """Two alike: 2^(-1/e) of one; and a thousand times better one changes 0.05 % at most."""
    slope = weibull_slope(BearingKind.DEEP_GROOVE)
    assert system_life([1e4, 1e4], slope) == pytest.approx(1e4 * 2.0 ** (-0.9))
    assert system_life([1e4, 1e7], slope) == pytest.approx(1e4, rel=5e-4)


def test_cleaner_oil_and_thicker_film_give_longer_life():
    """e_C and a_ISO grow with κ and with the filter, up to the standard's limits."""
    steps = [contamination_factor(OilFilter.BETA_12_200, kappa, 0.0725) for kappa in (0.2, 1.0, 4.0)]
    assert steps == sorted(steps) and steps[0] > 0.0 and steps[-1] <= 1.0
    assert contamination_factor(OilFilter.BETA_40_75, 1.0, 0.0725) < contamination_factor(
        OilFilter.BETA_6_200, 1.0, 0.0725
    )
    assert contamination_factor(OilFilter.BETA_12_200, 1.0, 0.064) == pytest.approx(
        0.0432 * 64.0**0.55 * (1 - 0.9987 / 4)
    )
    assert [each.value for each in Cleanliness] == sorted((each.value for each in Cleanliness), reverse=True)
    assert cleanliness_factor(Cleanliness.EXTREME, 0.05) == 1.0
    assert cleanliness_factor(Cleanliness.HIGH, 0.09) < cleanliness_factor(Cleanliness.HIGH, 0.11)
    for kind in BearingKind:
        lives = [life_modification(0.1, kappa, kind) for kappa in (0.1, 0.4, 1.0, 4.0, 9.0)]
        assert lives == sorted(lives) and lives[-1] == lives[-2]


@pytest.mark.parametrize("kind", [BearingKind.DEEP_GROOVE, BearingKind.TAPER])
@pytest.mark.parametrize("kappa", [0.4, 1.0])
def test_life_modification_is_continuous(kind, kappa):
    """The ranges of κ meet: rounding of the standard's constants leaves 0.05 %."""
    below, above = (life_modification(0.1, kappa + step, kind) for step in (-1e-9, 1e-9))
    assert above == pytest.approx(below, rel=5e-4)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: reliability_factor(0.85), "0.85 given; allowed: 0.9 to 0.999"),
        (lambda: life_modification(0.1, 0.05, BearingKind.TAPER), "below 0.1"),
        (lambda: basic_life(1e4, 0.0, BearingKind.TAPER), "above 0 N"),
        (lambda: static_safety(1e4, 0.0), "above 0 N"),
        (lambda: mean_load([1.0], [0.0]), "turns: .* some are above"),
        (lambda: reference_viscosity(0.0, 0.07), "no oil film forms"),
    ],
)
def test_what_the_standard_does_not_cover_is_refused(call, message):
    """By value and range."""
    with pytest.raises(DesignError, match=message):
        call()
