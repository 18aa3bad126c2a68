"""Loads of propellers and rotors by closed forms: against integrals, Ribner's fin, blade elements, and by hand."""

import math

import numpy as np
import pytest

from gearwright.machines import Blades, propeller_inertia
from gearwright.machines.propeller_loads import (
    FIN_SLOPE,
    ROOT,
    SOLIDITY,
    STEEPEST,
    blades_inertia,
    disc_velocity,
    excitation_factor,
    flight_thrust,
    gyroscopic_moment,
    incidence_of,
    once_per_turn,
    static_thrust,
)
from gearwright.machines.propellers import generic_blade, inclined
from gearwright.machines.rotor_loads import HUBS, hub_moment, tail_thrust_rise, usual_hub_moment

POWER, DIAMETER, SPEED = 2051e3, 3.93, 1212.0 * math.pi / 30.0
FLIGHTS = [(62.0, 10.0, 0.72), (87.5, 6.0, 0.80), (128.6, 2.0, 0.86)]
"""Airspeed [m/s], incidence [°], efficiency of take-off, climb and cruise of a regional turboprop."""


def integrated(thrust, airspeed, incidence, parts=20_000):
    """Return moment and side force by blade elements, summed over radius, and azimuth of six blades."""
    radius = np.linspace(ROOT, 1.0, parts + 1) * DIAMETER / 2.0
    radius = 0.5 * (radius[1:] + radius[:-1])
    step = (1.0 - ROOT) * DIAMETER / 2.0 / parts
    chord = SOLIDITY * math.pi * DIAMETER / 2.0 / 6
    turning = SPEED * radius
    whole = np.hypot(turning, airspeed)
    along, around = turning / whole, airspeed / whole
    lift = thrust / (6 * np.sum(0.5 * 1.225 * whole**2 * chord * along) * step)
    moment = force = 0.0
    for psi in 2.0 * math.pi * np.arange(6) / 6 + 0.3:
        more = 1.225 * chord * (lift * turning + FIN_SLOPE * airspeed / 2.0) * airspeed * math.sin(incidence)
        blade = more * math.sin(psi) * step
        moment += np.sum(blade * along * radius) * math.sin(psi)
        force += np.sum(blade * around) * math.sin(psi)
    return moment, force


@pytest.mark.parametrize(("airspeed", "degrees", "efficiency"), FLIGHTS)
def test_the_closed_form_is_the_sum_over_blades_and_radius(airspeed, degrees, efficiency):
    thrust = float(flight_thrust(POWER, airspeed, efficiency))
    found = once_per_turn(thrust, airspeed, math.radians(degrees), diameter=DIAMETER, speed=SPEED)
    moment, force = integrated(thrust, airspeed, math.radians(degrees))
    assert (float(found.moment), float(found.force)) == pytest.approx((moment, force), rel=1e-6)


@pytest.mark.parametrize(("airspeed", "degrees", "efficiency"), FLIGHTS)
def test_blade_elements_in_their_own_stream_give_nearly_the_same(airspeed, degrees, efficiency):
    """Against `inclined`: six blades of a published family, momentum at every radius, steady sections, 24 azimuths."""
    thrust, turns = float(flight_thrust(POWER, airspeed, efficiency)), SPEED / (2.0 * math.pi)
    shape, scale = generic_blade(Blades(6, 90.0, 0.5)), 1.225 * turns**2 * DIAMETER**4
    low, high = 0.1, 1.3
    for _ in range(50):
        middle = 0.5 * (low + high)
        found = inclined(shape, airspeed / (turns * DIAMETER), middle, incidence=math.radians(degrees))
        low, high = (middle, high) if found.thrust * scale < thrust else (low, middle)
    closed = once_per_turn(thrust, airspeed, math.radians(degrees), diameter=DIAMETER, speed=SPEED)
    assert float(closed.moment) == pytest.approx(found.yaw * scale * DIAMETER, rel=0.10)
    assert float(closed.force) == pytest.approx(found.normal * scale, rel=0.10)


def test_without_thrust_the_side_force_is_that_of_ribners_fin():
    """A fin of the blades' projected side area and aspect ratio 8, in the stream of the disc: NACA Reports 819, 820.

    The side area of B blades that turn is B/2 times that of one, c sin φ; U is small beside V, where blades are fins.
    """
    airspeed, speed = 200.0, 1.0
    found = once_per_turn(0.0, airspeed, 0.01, diameter=DIAMETER, speed=speed)
    side = 0.5 * SOLIDITY * math.pi * (DIAMETER / 2.0) ** 2 * (1.0 - ROOT)
    assert float(found.force) == pytest.approx(0.5 * 1.225 * airspeed**2 * side * FIN_SLOPE * math.sin(0.01), rel=1e-3)


def test_loads_of_a_turboprop_by_case():
    """The table of a checked calculation of 2051 kW at 1212 rpm, 3.93 m, six blades, solidity 0.15."""
    assert float(static_thrust(POWER, DIAMETER)) == pytest.approx(36.0e3, rel=2e-3)
    assert float(static_thrust(POWER, DIAMETER, share=1.0)) == pytest.approx(50.0e3, rel=2e-3)
    airspeed = np.array([62.0, 87.5, 128.6, 87.5, 87.5])
    degrees = np.array([10.0, 6.0, 2.0, *np.degrees(incidence_of([3.0, 4.5], 87.5))])
    thrust = flight_thrust(POWER, airspeed, [0.72, 0.80, 0.86, 0.80, 0.80])
    found = once_per_turn(thrust, airspeed, np.radians(degrees), diameter=DIAMETER, speed=SPEED)
    assert thrust / 1e3 == pytest.approx([23.8, 18.8, 13.7, 18.8, 18.8], rel=5e-3)
    assert degrees[3:] == pytest.approx([12.6, 18.8], abs=0.05)
    assert excitation_factor(np.radians(degrees), airspeed) == pytest.approx([1.20, 1.43, 1.03, 3.0, 4.5], abs=0.005)
    assert found.moment == pytest.approx([3372.0, 2865.0, 1471.0, 5961.0, 8851.0], rel=5e-3)
    assert found.force == pytest.approx([1060.0, 1281.0, 961.0, 2664.0, 3956.0], rel=5e-3)


def test_arrays_of_cases_give_what_single_ones_give():
    cases = once_per_turn([20e3, 10e3], [60.0, 120.0], [0.1, 0.05], diameter=DIAMETER, speed=[100.0, 127.0])
    single = [
        once_per_turn(pull, flow, angle, diameter=DIAMETER, speed=speed)
        for pull, flow, angle, speed in ((20e3, 60.0, 0.1, 100.0), (10e3, 120.0, 0.05, 127.0))
    ]
    assert cases.moment.tolist() == [float(one.moment) for one in single]
    assert cases.force.tolist() == [float(one.force) for one in single]


def test_a_propeller_that_stands_in_still_air_has_no_incidence():
    found = once_per_turn(36e3, 0.0, 0.2, diameter=DIAMETER, speed=SPEED)
    assert (float(found.moment), float(found.force)) == (0.0, 0.0)


def test_gyroscopic_moments_by_hand():
    """Six blades of 14 kg at 0.38 R: 6 · 14 · (0.38 · 1.965)² = 46.84 kg m²; I Ω ω = 46.84 · 126.92 · 2.5 N m."""
    inertia = float(blades_inertia(6, 14.0, DIAMETER))
    assert inertia == pytest.approx(46.84, abs=0.01)
    assert gyroscopic_moment(inertia, SPEED, [2.5, 1.0, 0.3]) == pytest.approx([14.86e3, 5945.0, 1783.0], rel=1e-3)
    assert propeller_inertia(DIAMETER, 6) == pytest.approx(94.5, abs=0.05)


def test_slow_flight_asks_for_no_incidence_at_which_blades_stall():
    assert float(incidence_of(3.0, 30.0)) == STEEPEST
    assert float(disc_velocity(POWER, DIAMETER)) == pytest.approx((POWER / (2 * 1.225 * 12.130)) ** (1 / 3), rel=1e-4)


def test_hub_moments_by_hand():
    """B/2 m_β e Ω² β₁ with 3 blades, 30 kg m, 0.2 m, 42.5 rad/s and 0.02: 1.5 · 30 · 0.2 · 1806 · 0.02 = 325 N m."""
    assert float(hub_moment(3, 30.0, 0.2, speed=42.5, flapping=0.02)) == pytest.approx(325.1, abs=0.1)
    usual = [float(usual_hub_moment(hub, 18.5e3, 10.0)) for hub in ("teetering", "articulated", "hingeless")]
    assert usual == pytest.approx([925.0, 2775.0, 5550.0])
    assert sorted(HUBS.values()) == list(HUBS.values())
    assert tail_thrust_rise() == pytest.approx(2.5 ** (2 / 3))
