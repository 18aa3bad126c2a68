"""Rotors of a helicopter over its speed, by hand and by what trim must do."""

import math

import pytest

import gearwright as gw
from gearwright.catalogue import Helicopter, TailRotor
from gearwright.errors import DesignError
from gearwright.units import GRAVITY

TAIL = TailRotor(0.75, 478.0, 6.0, 0.4, induced_factor=0.85)
CRAFT = Helicopter(1600.0, 10.0, 42.5, 0.057, 0.9, tail=TAIL)
AREA, TIP = 25.0 * math.pi, 212.5


def test_hover_by_hand():
    """κ T √(T/2ρA) + ρ A V_t³ σ c_d0/8, T with its download: rounding of the density."""
    found = gw.rotor(CRAFT, [0.0])
    thrust, row = 1600.0 * GRAVITY * 1.03, found.rows[0]
    velocity = math.sqrt(thrust / (2.0 * 1.225 * AREA))
    profile = 1.225 * AREA * TIP**3 * 0.057 * 0.01 / 8.0
    assert row.thrust == pytest.approx(thrust, rel=1e-12)
    assert row.power == pytest.approx(1.15 * thrust * velocity + profile, rel=1e-5)
    assert found.figure_of_merit == pytest.approx(thrust * velocity / row.power, rel=1e-5)
    assert row.loading == pytest.approx(thrust / (1.225 * AREA * TIP**2 * 0.057), rel=1e-5)


def test_the_tail_rotor_holds_the_torque_of_the_mast():
    for row in gw.rotor(CRAFT, [0.0, 20.0, 50.0]).rows:
        assert row.tail_thrust * 6.0 == pytest.approx(row.power / 42.5, rel=1e-12)
        assert row.total == pytest.approx(row.power + row.tail_power, rel=1e-12)
        assert row.power == pytest.approx(row.induced + row.profile + row.parasite + row.climb, rel=1e-12)


def test_the_best_speeds_are_those_of_the_bucket():
    """No speed of the table takes less than the least power; the ray from the origin touches at the greatest range."""
    found = gw.rotor(CRAFT, [float(speed) for speed in range(5, 70, 5)])
    assert found.least_power <= min(row.total for row in found.rows)
    at_best = gw.rotor(CRAFT, [found.best_range_speed]).rows[0]
    assert at_best.total / at_best.airspeed <= min(row.total / row.airspeed for row in found.rows)
    assert found.least_power_speed < found.best_range_speed


def test_the_disc_tilts_by_drag_over_weight():
    row = gw.rotor(CRAFT, [50.0]).rows[0]
    drag = 0.5 * 1.225 * 0.9 * 50.0**2
    assert math.tan(row.tilt) == pytest.approx(drag / (1600.0 * GRAVITY), rel=1e-5)
    assert row.parasite == pytest.approx(drag * 50.0, rel=1e-5)


def test_without_a_tail_rotor_its_columns_are_left_out():
    row = gw.rotor(Helicopter(1600.0, 10.0, 42.5, 0.057), [0.0]).rows[0]
    assert row.tail_power is None and row.total == row.power


@pytest.mark.parametrize(
    ("change", "speeds", "flight", "said"),
    [
        ({"mass": 4000.0}, [0.0], {}, "stall beyond 0.12; be lighter"),
        ({"mass": -1.0}, [0.0], {}, "helicopter.mass: -1: give"),
        ({"tail": TailRotor(0.75, 478.0, 0.0, 0.4)}, [0.0], {}, "helicopter.tail.arm: 0: give"),
        ({}, [0.0, 90.0], {}, "90 m/s: give 0 to 85 m/s"),
        ({}, [], {}, "none is given"),
        ({}, [5.0], {"rate_of_climb": -8.0}, "into its own wake"),
        ({}, [0.0], {"altitude": 3e4}, "altitude: 30000: give"),
        ({}, [0.0], {"isa_offset": -80.0}, "isa_offset: -80: give"),
        ({"mass": math.nan}, [0.0], {}, "helicopter.mass: nan: give"),
    ],
)
def test_what_cannot_fly_is_refused_with_its_place(change, speeds, flight, said):
    craft = Helicopter(**{**vars(CRAFT), **change})
    with pytest.raises(DesignError, match=said):
        gw.rotor(craft, speeds, **flight)
