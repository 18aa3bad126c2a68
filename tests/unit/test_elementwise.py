"""Formulas of arrays: the numbers of the same formulas one by one."""

import numpy as np
import pytest

from gearwright.air import Air, air_at, stagnation_ratios, true_of_calibrated
from gearwright.elementwise import functions
from gearwright.errors import DesignError
from gearwright.machines.turboshaft import Gas, enthalpy, temperature_of
from gearwright.parts import losses
from gearwright.parts.bearings import BearingKind

HEIGHTS = np.array([0.0, 500.0, 10_999.0, 11_000.0, 11_001.0, 20_000.0])
LOADS, SPEEDS = np.array([0.0, 2e4, 1e5, 4e5]), np.array([0.0, -3.0, 20.0, 90.0])


def same(found, wanted):
    """Tell whether numbers are the same but for the last bits of numpy's powers."""
    assert np.asarray(found) == pytest.approx(np.asarray(wanted), rel=1e-14)


def test_functions_are_those_of_what_a_formula_is_given():
    assert functions(1.0, 2.0).min(3.0, 2.0, 4.0) == 2.0
    assert functions(1.0, HEIGHTS).max(HEIGHTS, 600.0).tolist() == np.maximum(HEIGHTS, 600.0).tolist()


def test_air_along_heights_is_the_air_at_each():
    along = air_at(HEIGHTS, 7.0)
    for k, height in enumerate(HEIGHTS):
        same([column[k] for column in along], air_at(float(height), 7.0))


def test_airspeeds_along_heights_are_those_at_each():
    speed, air = np.full(6, 60.0), air_at(HEIGHTS)
    for k, height in enumerate(HEIGHTS):
        same(true_of_calibrated(speed, air)[k], true_of_calibrated(60.0, air_at(float(height))))


def test_stagnation_along_heights_is_that_at_each():
    air = air_at(HEIGHTS)
    for k, height in enumerate(HEIGHTS):
        here = stagnation_ratios(Air(*(column[k] for column in air)), 0.5)
        same(here, stagnation_ratios(air_at(float(height)), 0.5))


def test_one_height_too_many_is_refused_as_it_is_alone():
    with pytest.raises(DesignError, match="20001 m; the standard atmosphere"):
        air_at(np.array([0.0, 20_001.0]))


def test_one_speed_beyond_sound_is_refused():
    with pytest.raises(DesignError, match="Mach"):
        true_of_calibrated(np.array([50.0, 400.0]), air_at(np.array([0.0, 0.0])))


@pytest.mark.parametrize("law", list(losses.MeshLaw))
def test_losses_of_teeth_under_many_loads_are_those_under_each(law):
    contact = losses.tooth_contact((20, 41), 0.003, pressure_angle=0.35)
    oils = [losses.OilState(viscosity, 950.0, 4e-7) for viscosity in (4e-3, 5e-3, 6e-3, 7e-3)]
    duty = losses.LossDuty(LOADS, 0.03, SPEEDS)
    state = oils[0]._replace(viscosity=np.array([oil.viscosity for oil in oils]))
    along = losses.mesh_loss_part(contact, duty, state, law=law)
    for k, oil in enumerate(oils):
        alone = losses.LossDuty(float(LOADS[k]), 0.03, float(SPEEDS[k]))
        same(along[k], losses.mesh_loss_part(contact, alone, oil, law=law))


@pytest.mark.parametrize(
    "kind", [BearingKind.DEEP_GROOVE, BearingKind.FOUR_POINT, BearingKind.CYLINDRICAL, BearingKind.TAPER]
)
def test_friction_of_bearings_under_many_loads_is_that_under_each(kind):
    friction = losses.SeriesFriction(2.0, 3e-4, (4.4e-7, 1.7, 1.8e-12), (2e-3, 100.0, 1e-12))
    pushed = np.array([0.0, 500.0, -900.0, 0.0])

    def bearing(radial, axial):
        return losses.RunningBearing(kind, 0.05, 0.09, 3e4, 0.3, radial, axial)

    along = losses.bearing_torque_skf(bearing(LOADS, pushed), friction, SPEEDS, viscosity=8e-6)
    for k, speed in enumerate(SPEEDS.tolist()):
        alone = bearing(float(LOADS[k]), float(pushed[k]))
        same(along[k], losses.bearing_torque_skf(alone, friction, speed, viscosity=8e-6))


def test_temperatures_of_many_gases_are_those_of_each():
    ratios, wanted = np.array([0.01, 0.02, 0.03]), np.array([2e5, 5e5, 9e5])
    along = temperature_of(Gas(ratios), wanted)
    for k, ratio in enumerate(ratios.tolist()):
        same(along[k], temperature_of(Gas(ratio), float(wanted[k])))
    same(enthalpy(Gas(ratios), along), wanted)
