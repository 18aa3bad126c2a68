"""Formulas over arrays: the numbers of the same formulas one by one."""

import math

import numpy as np
import pytest

from gearwright.air import (
    Air,
    air_along,
    air_at,
    stagnation_along,
    stagnation_ratios,
    true_along,
    true_of_calibrated,
)
from gearwright.errors import DesignError
from gearwright.lanes import rebound
from gearwright.parts import losses as oil

HEIGHTS = np.array([0.0, 500.0, 10_999.0, 11_000.0, 11_001.0, 20_000.0])


def same(found, wanted):
    """Tell whether numbers are the same but for the last bits of numpy's powers."""
    assert np.asarray(found) == pytest.approx(np.asarray(wanted), rel=1e-14)


def test_air_along_heights_is_the_air_at_each():
    along = air_along(HEIGHTS, 7.0)
    for k, height in enumerate(HEIGHTS):
        same([column[k] for column in along], air_at(float(height), 7.0))


def test_airspeeds_along_heights_are_those_at_each():
    speed, air = np.full(6, 60.0), air_along(HEIGHTS)
    for k, height in enumerate(HEIGHTS):
        same(true_along(speed, air)[k], true_of_calibrated(60.0, air_at(float(height))))


def test_stagnation_along_heights_is_that_at_each():
    air = air_along(HEIGHTS)
    for k, height in enumerate(HEIGHTS):
        here = stagnation_along(Air(*(column[k] for column in air)), 0.5)
        same(here, stagnation_ratios(air_at(float(height)), 0.5))


def test_one_height_too_many_is_refused_as_it_is_alone():
    with pytest.raises(DesignError, match="20001 m; the standard atmosphere"):
        air_along(np.array([0.0, 20_001.0]))


def test_one_speed_beyond_sound_is_refused():
    with pytest.raises(DesignError, match="Mach"):
        true_along(np.array([50.0, 400.0]), air_along(np.array([0.0, 0.0])))


def test_rebound_functions_call_each_other_and_leave_their_module_alone():
    over = rebound(oil)
    speeds = np.array([0.0, 10.0, 500.0])
    found = over.windage_power(0.1, 0.02, speeds, viscosity=5e-3)
    same(found, [oil.windage_power(0.1, 0.02, speed, viscosity=5e-3) for speed in speeds.tolist()])
    assert oil.math is math


def test_a_function_can_be_replaced():
    over = rebound(oil, math=math)
    assert over.math is math
