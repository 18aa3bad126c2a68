"""The closed laws of journal bearings against Reynolds' equation, solved by finite differences, and their limits."""

import math

import numpy as np
import pytest
from journal_film import solved

from gearwright.parts.bearings import (
    attitude_angle,
    film_load,
    friction_variable,
    narrow_load,
    side_flow,
    wide_load,
)

near = pytest.approx


@pytest.mark.parametrize("width_ratio", [0.25, 0.6, 1.0, 1.4])
@pytest.mark.parametrize("eccentricity", [0.2, 0.5, 0.8, 0.9])
def test_load_flow_and_attitude_are_those_of_the_film(eccentricity, width_ratio):
    """Fits of 1.3 %, 1.4 % and 1.1°; the grid itself errs by 0.5 % at ε = 0.9."""
    film = solved(eccentricity, width_ratio)
    assert film_load(eccentricity, width_ratio) == near(film.load, rel=0.02)
    assert side_flow(eccentricity, width_ratio) == near(film.flow, rel=0.02)
    assert attitude_angle(eccentricity, width_ratio) == near(film.attitude, abs=math.radians(1.5))


def test_the_grid_converges_with_the_square_of_its_cells():
    """Twice as many cells take the error to a fourth: the differences of three grids stand 4 to 1, here 2.5 to 6."""
    loads = [solved(0.6, 0.5, around=n, across=n // 10).load for n in (60, 120, 240)]
    assert 2.5 < (loads[1] - loads[0]) / (loads[2] - loads[1]) < 6.0


@pytest.mark.parametrize("eccentricity", [0.1, 0.4, 0.7])
def test_a_narrow_bearing_is_that_of_ocvirk(eccentricity):
    """At B/D = 0.1 a film bears 1 to 2 % less than one that is narrow without end."""
    limit = narrow_load(eccentricity, 0.1)
    assert 0.97 * limit < film_load(eccentricity, 0.1) < limit


def test_wider_bearings_come_near_the_wide_limit_and_stay_below_it():
    shares = [float(film_load(0.5, ratio) / wide_load(0.5)) for ratio in (0.5, 1.0, 1.5, 2.0)]
    assert shares == sorted(shares)
    assert 0.6 < shares[-1] < 1.0


def test_the_wide_limit_by_hand():
    """ε = 0.6: 1.8 √(0.64 π² + 1.44)/(2.36 · 0.64) = 1.8 · 2.785/1.5104."""
    assert wide_load(0.6) == near(1.8 * math.sqrt(0.64 * math.pi**2 + 1.44) / 1.5104, rel=1e-12)


def test_petroff_is_the_friction_of_a_film_without_load():
    """f F = 2 π² … : f/ψ So → π as ε → 0."""
    assert float(friction_variable(0.02, 1.0) * film_load(0.02, 1.0)) == near(math.pi, rel=2e-3)


def test_more_load_presses_the_film_thinner_at_every_width():
    ratios = np.linspace(0.1, 2.0, 20)[:, None]
    loads = film_load(np.linspace(0.02, 0.98, 97)[None, :], ratios)
    assert (np.diff(loads, axis=1) > 0.0).all()
