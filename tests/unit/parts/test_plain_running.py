"""Journal bearings in balance of heat: conservation, limits and hand calculation."""

import math

import pytest

from gearwright.parts.bearings import (
    FilmOil,
    Journal,
    film_speed,
    friction_variable,
    laminar_limit,
    run_film,
    side_flow,
    usual_clearance,
    usual_least_film,
)

near = pytest.approx
STEADY = FilmOil(lambda temperature: 0.0275, 860.0, 2000.0, 330.0)
"""An oil whose viscosity no heat moves."""
THIN = FilmOil(lambda temperature: 0.02 * math.exp(-0.03 * (temperature - 330.0)), 900.0, 2000.0, 330.0)
BEARING = Journal(0.0381, 0.0381, 2e-3)


def test_a_bearing_of_constant_viscosity_by_hand():
    """p = F/(B D), So = p ψ²/(η ω): 2224 N on 38.1 mm square at 188.5 rad/s with ψ = 2e-3 and 27.5 mPa s: 1.182."""
    state = run_film(BEARING, 2224.0, 188.5, STEADY)
    assert state.pressure == near(2224.0 / 0.0381**2, rel=1e-12)
    assert state.sommerfeld == near(1.532e6 * 4e-6 / (0.0275 * 188.5), rel=1e-3)
    assert state.eccentricity == near(0.577, abs=0.005)
    assert state.film == near(0.0381 * 1e-3 * (1.0 - state.eccentricity), rel=1e-12)
    assert state.friction == near(2e-3 * float(friction_variable(state.eccentricity, 1.0)), rel=1e-3)


def test_the_oil_carries_all_heat_away():
    state = run_film(BEARING, 3000.0, 400.0, THIN)
    assert state.power == near(900.0 * 2000.0 * state.flow * state.rise, rel=1e-9)
    assert state.power == near(state.friction * 3000.0 * state.sliding_speed, rel=1e-12)
    assert state.flow == near(0.0381**3 * 2e-3 * 400.0 * float(side_flow(state.eccentricity, 1.0)), rel=1e-3)


def test_the_film_has_the_viscosity_of_the_mean_temperature():
    state = run_film(BEARING, 3000.0, 400.0, THIN)
    viscosity = state.pressure * 4e-6 / (400.0 * state.sommerfeld)
    assert viscosity == near(THIN.viscosity(330.0 + state.rise / 2.0), rel=1e-6)


def test_without_load_it_rubs_as_petroff_says():
    """M = π η ω D² B/(2 ψ), whatever the load."""
    state = run_film(BEARING, 1e-3, 100.0, STEADY)
    moment = math.pi * 0.0275 * 100.0 * 0.0381**2 * 0.0381 / (2.0 * 2e-3)
    assert state.power == near(moment * 100.0, rel=1e-9)


@pytest.mark.parametrize(("load", "speed"), [(6000.0, 400.0), (3000.0, 200.0)])
def test_more_load_or_less_speed_thins_the_film(load, speed):
    assert run_film(BEARING, load, speed, STEADY).film < run_film(BEARING, 3000.0, 400.0, STEADY).film


def test_equal_bearings_of_another_scale_sit_alike():
    """Twice the size under four times the load at the same speed: p, So and ε stay, the film doubles."""
    small, large = run_film(BEARING, 2e3, 300.0, STEADY), run_film(Journal(0.0762, 0.0762, 2e-3), 8e3, 300.0, STEADY)
    assert large.eccentricity == near(small.eccentricity, rel=1e-12)
    assert large.film == near(2.0 * small.film, rel=1e-12)
    assert large.rise == near(small.rise, rel=1e-9)


def test_a_planet_builds_its_film_by_its_speed_against_the_carrier():
    carrier, planet = 471.0, -859.0
    assert film_speed(carrier, planet, carrier) == near(abs(planet - carrier), rel=1e-12)


def test_limits_step_where_their_table_does():
    assert [round(1e6 * usual_least_film(size, 20.0)) for size in (0.05, 0.063, 0.1, 0.3, 0.9, 2.0)] == [
        7, 7, 9, 11, 13, 16,
    ]  # fmt: skip
    assert [round(1e6 * usual_least_film(0.1, speed)) for speed in (0.5, 2.0, 5.0, 20.0, 50.0)] == [4, 5, 7, 9, 12]
    assert laminar_limit(4e-3) == near(laminar_limit(1e-3) / 2.0, rel=1e-12)
    assert usual_clearance(81.0) == near(2.4e-3, rel=1e-12)
