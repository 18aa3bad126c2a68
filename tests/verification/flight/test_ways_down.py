"""The shipped descents by hand: signs, glide, what regeneration keeps, a feathered propeller, reverse on the runway."""

import functools
import math

import numpy as np
import pytest

from gearwright.catalogue import propeller_map
from gearwright.machines import Blades, coefficients
from gearwright.machines.propellers import feathered, generic_blade, loads
from gearwright.mission import fly
from gearwright.mission.aircraft import phase_forces
from gearwright.spec import edited_mission, read_mission
from shipped_work import flown, sized

GRAVITY, DIAMETER = 9.80665, 3.93


@functools.cache
def flight():
    return flown("in-line-h2", "ways-down")


def within(name):
    return np.array(flight().phase) == name


def mean(column, name):
    """Mean over a phase, weighted by time."""
    history = flight().history
    return float(np.average(getattr(history, column)[within(name)], weights=history.duration[within(name)]))


def test_the_books_agree_on_the_way_down():
    assert flight().balance.residual <= 1e-9


def test_at_idle_the_blades_brake_and_take_what_the_turbine_has_left():
    idle = within("idle-descent")
    assert np.all(flight().history.thrust[idle] < 0.0) and np.all(flight().history.propeller_power[idle] > 0.0)
    assert mean("turbine_power", "idle-descent") == pytest.approx(40e3, rel=1e-4)
    eaten = mean("gearbox_heat", "idle-descent") + mean("motor_loss", "idle-descent")
    assert mean("propeller_power", "idle-descent") == pytest.approx(40e3 - eaten, rel=1e-3)


def test_an_idle_descent_sinks_as_drag_and_brake_over_weight():
    """V (D - T)/(m g) with the polar by hand at the middle of the phase: 2 %, with what air thickens on the way."""
    history, idle = flight().history, within("idle-descent")
    speed, density = mean("true_airspeed", "idle-descent"), mean("air_density", "idle-descent")
    weight, pressure = 20965.0 * GRAVITY, 0.5 * density * speed**2 * 61.0
    drag = pressure * (0.025 + (weight / pressure) ** 2 / (math.pi * 12.0 * 0.71))
    sink = speed * (drag - 2.0 * mean("thrust", "idle-descent")) / weight
    assert (15000 - 10000) * 0.3048 / history.duration[idle].sum() == pytest.approx(sink, rel=0.02)


def test_regeneration_keeps_what_the_air_gives_less_every_loss():
    """Stored = air + slower train - gearbox - motors - battery, by the histories: rounding; a fifth is lost."""
    history, charged = flight().history, within("regenerate")
    span = history.duration[charged]
    assert np.all(history.propeller_power[charged] < 0.0) and not history.fuel_flow[charged].any()
    air, kept = -float(history.propeller_power[charged] @ span), -float(history.battery_power[charged] @ span)
    slower = -float(history.spin_up[charged] @ span)
    lost = sum(float(getattr(history, name)[charged] @ span) for name in ("gearbox_heat", "motor_loss", "battery_loss"))
    assert kept + lost == pytest.approx(air + slower, rel=1e-9)
    assert slower == pytest.approx(0.5 * flight().inertia * (126.92**2 - 94.25**2), rel=1e-3)
    assert 0.7 < kept / (air + slower) < 0.9


def test_one_engine_pulls_alone_and_the_other_propeller_drags_in_feather():
    forces = {row.name: row for row in phase_forces(flight())}
    speed, density = mean("true_airspeed", "one-engine"), mean("air_density", "one-engine")
    weight, pressure = forces["one-engine"].mass * GRAVITY, 0.5 * density * speed**2 * 61.0
    drag = pressure * (0.025 + 0.0035 + (weight / pressure) ** 2 / (math.pi * 12.0 * 0.71))
    assert forces["one-engine"].thrust == pytest.approx(drag, rel=1e-3)
    assert (
        pytest.approx(feathered(generic_blade(Blades(6, 115.0, 0.5))).drag_area * DIAMETER**2 / 61.0, rel=0.02)
        == 0.0035
    )


def test_feather_stops_the_blades_and_blades_drag_each_for_itself():
    two, six = (feathered(generic_blade(Blades(blades, 115.0, 0.5))) for blades in (2, 6))
    assert six.drag_area == pytest.approx(3.0 * two.drag_area, rel=0.02)
    shape = generic_blade(Blades(6, 115.0, 0.5))
    both = loads(shape, 1e4, np.array([six.angle - 0.02, six.angle + 0.02]))
    assert both.power[0] < 0.0 < both.power[1] and np.all(both.thrust < 0.0)
    flat = loads(shape, 1e4, math.radians(20.0))
    assert -2.0 * float(flat.thrust[0] if np.ndim(flat.thrust) else flat.thrust) / 1e8 > 8.0 * six.drag_area


def test_reverse_takes_power_and_brakes_more_than_the_wheels_alone():
    """Without reverse the roll is longer: V²/2 over the mean deceleration, both by the same wheels."""
    landing = within("landing")
    assert np.all(flight().history.propeller_power[landing] > 3e5) and np.all(flight().history.thrust[landing] < 0.0)
    roll = next(row.roll for row in phase_forces(flight()) if row.name == "landing")
    mission = edited_mission(read_mission("ways-down"), {"phases.landing.pitch_deg": 2.0})
    longer = next(row.roll for row in phase_forces(fly(sized(), mission)) if row.name == "landing")
    assert 1.1 * roll < longer


def test_reverse_at_standstill_is_that_of_blades_twisted_the_wrong_way():
    """Shipped map at -10°, as the theory page tells it; by elements alone 2 %; figure of merit 0.12, far below 1."""
    held = coefficients(propeller_map("6-blades-af115-all-states"), 0.0, math.radians(-10.0))
    alone = loads(generic_blade(Blades(6, 115.0, 0.5)), 0.0, math.radians(-10.0))
    assert (held.thrust, held.power) == pytest.approx((-0.051, 0.079), abs=5e-4)
    assert (held.thrust, held.power) == pytest.approx((float(alone.thrust), float(alone.power)), rel=0.02)
    assert 0.1 < (-held.thrust) ** 1.5 * math.sqrt(2.0 / math.pi) / held.power < 0.13
