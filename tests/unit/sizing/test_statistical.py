"""The pieces of the statistical mass estimate."""

import math

import pytest
from hypothesis import given, strategies as st
from scipy.special import stdtrit

from gearwright.errors import DesignError
from gearwright.units import RPM
from gearwright.weights import (
    Requirement,
    StatedMass,
    bands,
    compare,
    corners,
    estimate,
    from_beta,
    laws as willis,
    left_out_scatter,
    log_line,
    mass_tm215680,
    methods,
    middle,
    refit,
    scores,
)
from gearwright.weights.methods import student_quantile

PW127 = Requirement(2051e3, 20204 * RPM, 1212 * RPM)


def of(key, need=PW127):
    return next(one for one in compare(need).estimates if one.method.key == key)


def test_a_requirement_reports_every_wrong_number_at_once():
    with pytest.raises(DesignError) as caught:
        Requirement(-1.0, math.nan, 100.0)
    assert [one.path for one in caught.value.problems] == ["power", "engine_speed"]


def test_swapped_speeds_are_refused_with_the_fix():
    with pytest.raises(DesignError, match="swap the speeds"):
        Requirement(2051e3, 1212 * RPM, 20204 * RPM)


@given(st.floats(0.1, 100.0), st.floats(1.5, 90.0), st.floats(20.0, 300.0))
def test_a_requirement_from_beta_has_that_beta(value, ratio, speed):
    """The inverse of a power law; 1e-12 is a few roundings."""
    assert from_beta(value, ratio=ratio, propeller_speed=speed).beta == pytest.approx(value, rel=1e-12)


@given(st.floats(1e3, 2e7), st.floats(1.01, 200.0), st.floats(10.0, 1000.0))
def test_no_method_ever_gives_a_mass_that_is_not_positive(power, ratio, speed):
    need = Requirement(power, ratio * speed, speed)
    for method in methods():
        found = estimate(method, need)
        if found.mass is None:
            assert found.reason
        else:
            assert found.mass > 0.0


def test_the_line_of_the_report_says_its_range_where_it_would_be_negative():
    """-37.4262 + 116.3297 β is negative below β = 0.322."""
    small = from_beta(0.2, ratio=15.0, propeller_speed=200.0)
    assert of("tm215680", small).mass is None
    assert "beta 0.2 is outside 0.627 to 65.9" in of("tm215680", small).reason
    with pytest.raises(DesignError, match="negative"):
        mass_tm215680(0.2)


def test_wate2_beyond_its_published_power_shows_the_bare_formula_apart_from_the_masses():
    found = of("wate2")
    assert found.mass is None
    assert "2051 kW is outside" in found.reason
    assert found.beyond == pytest.approx(160.6, abs=0.05)
    assert of("wate2", Requirement(1.5e6, 20204 * RPM, 1212 * RPM)).mass is not None


def test_a_planetary_stage_whose_planets_would_touch_gives_no_mass():
    assert of("willis-planetary").mass is None
    assert of("willis-planetary").beyond is None


def test_the_upper_limit_of_a_planetary_stage_is_where_neighbouring_planets_touch():
    greatest = next(one for one in methods() if one.key == "willis-planetary").ranges[0].high
    planet = (greatest - 2.0) / 2.0
    assert (1.0 + planet) * math.sin(math.pi / 3.0) == pytest.approx(planet, rel=1e-9)


def test_the_double_reduction_bracket_is_the_sum_of_its_two_pairs():
    """Gear volumes add: the second pair carries m times the torque of the first."""
    first, overall = 3.0, 12.0

    def pair(ratio):
        return 1.0 + 1.0 / ratio + ratio + ratio**2

    total = pair(first) + first * pair(overall / first)
    assert willis.bracket_double_reduction(first, overall) == pytest.approx(total, rel=1e-14)


def test_a_double_branch_halves_what_its_shared_gears_carry():
    """Two pinion meshes of T/2 on one pinion, two intermediate shafts, one wheel."""
    m, overall = 3.0, 12.0
    n = overall / m
    pinion, wheels = 0.5 * (1 + 1 / m), 2 * 0.5 * (m + m**2)
    pinions, wheel = 2 * 0.5 * m * (1 + 1 / n), 0.5 * m * (n + n**2)
    assert willis.bracket_double_branch(m, overall) == pytest.approx(pinion + wheels + pinions + wheel, rel=1e-14)


def test_the_epicyclic_bracket_is_sun_planets_and_ring():
    """Sun and ring of b meshes of T/b each, b planets; the ring weighs 0.4 of a disc."""
    b, planet, ring = 3, 1.2, 3.4
    mesh = (1 + 1 / planet) / b
    total = mesh + b * planet**2 * mesh + 0.4 * ring**2 * mesh
    assert willis.bracket_epicyclic(planet, ring, b) == pytest.approx(total, rel=1e-14)


def test_a_planetary_stage_takes_the_planet_from_coaxiality():
    """Ring diameter = sun + 2 planets."""
    assert willis.bracket_planetary(5.0, 3) == willis.bracket_epicyclic(1.5, 4.0, 3)


def test_the_lightest_planet_is_a_minimum():
    best = willis.lightest_planet(3.0, 3)
    at = [willis.bracket_epicyclic(factor * best, 3.0, 3) for factor in (0.98, 1.0, 1.02)]
    assert at[1] < min(at[0], at[2])


def test_a_power_law_without_noise_is_recovered_exactly():
    """y = 3 x²; the spread is rounding only."""
    line = log_line([1.0, 2.0, 4.0, 8.0], [3.0, 12.0, 48.0, 192.0])
    assert (line.slope, line.at(1.0)) == pytest.approx((2.0, 3.0), rel=1e-12)
    assert line.spread < 1e-12


def test_the_prediction_band_of_five_points_is_that_of_students_t():
    """x = 0..4 and residuals ±1: s² = 4/3·..., t(0.975, 3) = 3.182446 (tables of Student's t, six decimals)."""
    u, v = [0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.2, 1.8, 3.2, 4.0]
    line = log_line([10.0**one for one in u], [10.0**one for one in v])
    slope = sum((a - 2.0) * b for a, b in zip(u, v, strict=True)) / 10.0
    intercept = sum(v) / 5.0 - 2.0 * slope
    s = math.sqrt(sum((b - intercept - slope * a) ** 2 for a, b in zip(u, v, strict=True)) / 3.0)
    width = 3.182446 * s * math.sqrt(1.0 + 1.0 / 5.0 + 1.0 / 10.0)
    low, high = line.band(10.0**3, 0.95)
    assert math.log10(high) == pytest.approx(intercept + 3.0 * slope + width, rel=1e-6)
    assert math.log10(low) == pytest.approx(intercept + 3.0 * slope - width, rel=1e-6)


def test_about_95_of_100_weights_lie_in_their_95_per_cent_band():
    """61 weights of which each lies inside with 0.95: 54 to 61 cover 99 % of the binomial distribution."""
    from gearwright.catalogue import weighed_gearboxes
    from gearwright.units import POUND

    inside = 0
    for one in weighed_gearboxes():
        low, high = refit().band(one.beta, 0.95)
        inside += low <= one.mass / POUND <= high
    assert 54 <= inside <= 61


def test_a_wider_band_holds_the_narrower_one():
    narrow, wide = bands(PW127)
    assert wide.low < narrow.low < 136.5 < narrow.high < wide.high


def test_the_users_mass_wins_and_keeps_its_origin():
    stated = StatedMass(190.0, "weighed, maintenance manual", overridden=True)
    found = compare(PW127, bottom_up=150.0, stated=stated)
    assert found.taken is stated
    assert found.taken.overridden


def test_without_a_stated_mass_the_refit_is_taken_not_a_sum_of_parts_without_housing():
    found = compare(PW127, bottom_up=150.0)
    assert found.bottom_up.mass == 150.0
    assert "10^2.0084" in found.taken.origin


def test_outside_the_real_weights_no_mass_is_taken():
    tiny = from_beta(0.1, ratio=10.0, propeller_speed=200.0)
    assert compare(tiny).taken is None
    assert compare(tiny).bands == ()


def test_a_stated_mass_needs_an_origin_and_a_positive_value():
    with pytest.raises(DesignError) as caught:
        StatedMass(-3.0, " ")
    assert [one.path for one in caught.value.problems] == ["mass_kg", "origin"]


def test_the_refit_has_no_bias_on_its_own_weights_and_scatters_more_on_those_left_out():
    score = next(one for one in scores() if one.method.key == "refit")
    assert score.bias == pytest.approx(1.0, rel=1e-12)
    assert score.needs_only_beta
    assert left_out_scatter() > score.scatter


def test_brown_hangs_on_the_assumed_ratio_only():
    """hp^0.76 rpm_in^0.13 / rpm_out^0.89: the exponents of speed and power in rpm_out cancel, 0.76 + 0.13 = 0.89."""
    law = next(one for one in methods() if one.key == "brown72")
    slow, fast = (law.mass(from_beta(5.0, ratio=20.0, propeller_speed=one * RPM)) for one in (200.0, 2000.0))
    assert slow == pytest.approx(fast, rel=1e-12)


def test_the_middle_of_the_assumption_lies_between_its_corners():
    ratios = [one.ratio for one in corners()]
    speeds = [one.propeller_speed for one in corners()]
    assert min(ratios) < middle().ratio < max(ratios)
    assert min(speeds) < middle().propeller_speed < max(speeds)


@pytest.mark.parametrize("freedoms", [1, 2, 3, 4, 5, 10, 59, 60, 200])
def test_students_quantile_is_that_of_a_library(freedoms):
    for level in (0.5, 0.68, 0.95, 0.999):
        assert student_quantile(freedoms, level) == pytest.approx(stdtrit(freedoms, 0.5 + 0.5 * level), rel=1e-9)
