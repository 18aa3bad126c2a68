"""Paths of a point mass against closed forms: ground roll, glide, climb, Breguet, and the order of the steps."""

import math
from itertools import pairwise

import pytest

from gearwright.air import air_at, stall_speed
from gearwright.mission.aircraft import (
    Powered,
    Push,
    State,
    _over_speed,
    books,
    march,
    path_by_power,
    rotation_speed,
    stretch,
)
from gearwright.mission.thrust import Attitude, polar_of, resistance
from gearwright.spec import Aircraft, Flaps, Phase
from gearwright.units import GRAVITY

AIRCRAFT = Aircraft(mass=20e3, wing_area=60.0, zero_lift_drag=0.025, induced_drag=0.035, highest_lift=1.6)
SLICK = Aircraft(mass=20e3, wing_area=1e-6, zero_lift_drag=1e-6, induced_drag=0.0, roll_lift=0.0)
BASE = {"altitude": 0.0, "propeller_speed": 100.0}


def start(altitude=0.0, speed=0.0, mass=20e3):
    """Return a state from which a phase starts."""
    return State(0.0, altitude, speed, 0.0, mass, 0.0, 0.0, 0.0)


def powered(phase, push, aircraft=AIRCRAFT):
    """Return a phase that is pushed by a law."""
    return Powered(aircraft, Phase(**{**BASE, **phase}), push, 0.0, 10.0)


def constant(thrust, fuel_flow=0.0):
    """Return a push that does not change."""
    return lambda _: Push(thrust, fuel_flow)


def test_a_roll_under_a_constant_force_ends_after_v_squared_over_two_a():
    rolls = powered({"kind": "take-off", "tas": 50.0, "power": 1.0}, constant(60e3), SLICK)
    path, end = path_by_power(rolls, start())
    acceleration = 60e3 / 20e3 - SLICK.rolling_friction * GRAVITY
    assert path.distance("roll") == pytest.approx(50.0**2 / (2.0 * acceleration), rel=1e-9)  # exact: linear in time
    rolled = next(leg.end.time for leg in reversed(list(path.legs)) if leg.stage == "roll")
    assert rolled == pytest.approx(50.0 / acceleration, rel=1e-9)
    assert end.speed > 50.0


def test_a_roll_against_quadratic_drag_ends_where_its_logarithm_says():
    aircraft = AIRCRAFT.model_copy(update={"roll_lift": 0.0})
    rolls = powered({"kind": "take-off", "tas": 55.0, "power": 1.0}, constant(50e3), aircraft)
    path, _ = path_by_power(rolls, start())
    pull = 50e3 - aircraft.rolling_friction * 20e3 * GRAVITY
    factor = 0.5 * air_at(0.0).density * aircraft.wing_area * aircraft.zero_lift_drag
    expected = 20e3 / (2.0 * factor) * math.log(pull / (pull - factor * 55.0**2))
    exact = march_distance(rolls, start(), 55.0)
    assert exact == pytest.approx(expected, rel=1e-9)  # the integral itself
    assert path.distance("roll") == pytest.approx(expected, rel=2e-3)  # trapezoids between its nodes


def march_distance(rolls, state, speed):
    """Return the distance that the integration itself found for a roll."""
    return stretch(rolls, _over_speed(rolls, 1.0), state, speed)[-1].distance


def test_a_glide_falls_by_drag_over_lift():
    descent = powered({"kind": "descent", "tas": 80.0, "altitude": 1000.0, "power": 1.0}, constant(0.0))
    path, end = path_by_power(descent, start(1200.0, 80.0))
    ends = [at_rest(altitude, 80.0) for altitude in (1200.0, 1000.0)]
    slopes = [drag / (20e3 * GRAVITY) for drag in ends]
    assert 200.0 / end.distance == pytest.approx(sum(slopes) / 2.0, rel=1e-4)  # air changes by 2 % over the height
    assert path.energy.residual < 1e-9


def at_rest(altitude, speed):
    """Return the drag of a steady glide: its lift is m g cos γ [N]."""
    phase, slope = Phase(**BASE, kind="descent"), 0.0
    for _ in range(20):
        drag = resistance(AIRCRAFT, phase, 20e3 * GRAVITY, Attitude(air_at(altitude), speed, slope, 0.0))
        slope = -drag / (20e3 * GRAVITY)
    return drag


def test_the_flattest_glide_is_one_over_the_best_glide_ratio():
    best = 2.0 * math.sqrt(AIRCRAFT.zero_lift_drag * AIRCRAFT.induced)
    polar, air, weight = polar_of(AIRCRAFT, Phase(**BASE)), air_at(1000.0), 20e3 * GRAVITY
    speed = math.sqrt(2.0 * weight / (air.density * polar.area) * math.sqrt(polar.induced / polar.zero_lift))
    found = {
        factor: resistance(AIRCRAFT, Phase(**BASE), weight, Attitude(air, factor * speed, 0.0, 0.0)) / weight
        for factor in (0.99, 1.0, 1.01)
    }
    assert found[1.0] == pytest.approx(best, rel=1e-12)
    assert min(found, key=found.get) == 1.0


def test_the_best_rate_of_climb_at_constant_power_is_at_the_least_power_needed():
    """V for least D V is 3^(-1/4) of that of the best glide: Anderson, Aircraft Performance and Design, ch. 5."""
    polar, air, weight = polar_of(AIRCRAFT, Phase(**BASE)), air_at(0.0), 20e3 * GRAVITY
    glide = math.sqrt(2.0 * weight / (air.density * polar.area) * math.sqrt(polar.induced / polar.zero_lift))

    def rate(speed):
        climb = powered(
            {"kind": "climb", "tas": speed, "altitude": 1.0, "power": 1.0}, lambda at: Push(2e6 / at.speed, 0)
        )
        return 1.0 / path_by_power(climb, start(0.0, speed))[1].time

    best = glide / 3.0**0.25
    assert rate(best) > max(rate(0.97 * best), rate(1.03 * best))
    by_hand = (2e6 - best * resistance(AIRCRAFT, Phase(**BASE), weight, Attitude(air, best, 0.0, 0.0))) / weight
    assert rate(best) == pytest.approx(by_hand, rel=0.01)  # lift is m g cos γ, and γ is 5°


def test_a_cruise_at_constant_lift_over_drag_is_breguets():
    """R = η/(g c) (L/D) ln(m_0/m_1): drag that is C_D0 alone times a speed that falls with the mass."""
    efficiency, consumption, ratio = 0.85, 80e-9, 14.0

    def push(at):
        drag = at.mass * GRAVITY / ratio
        return Push(drag, drag * at.speed / efficiency * consumption)

    cruise = powered({"kind": "cruise", "altitude": 5000.0, "distance": 500e3, "power": 1.0}, push)
    object.__setattr__(cruise, "force", lambda state, _slope, _rolls: (push(state), push(state).thrust))
    _, end = path_by_power(cruise, start(5000.0, 130.0))
    assert efficiency / (GRAVITY * consumption) * ratio * math.log(20e3 / end.mass) == pytest.approx(500e3, rel=1e-9)


def test_a_cruise_at_a_power_comes_to_the_speed_whose_drag_it_holds():
    cruise = powered(
        {"kind": "cruise", "altitude": 3000.0, "duration": 4000.0, "power": 1.0}, lambda at: Push(2e6 / at.speed, 0.0)
    )
    _, end = path_by_power(cruise, start(3000.0, 100.0))
    weight, air = 20e3 * GRAVITY, air_at(3000.0)
    held = resistance(AIRCRAFT, Phase(**BASE), weight, Attitude(air, end.speed, 0.0, 0.0))
    assert end.speed * held == pytest.approx(2e6, rel=1e-6)


def test_a_burning_cruise_over_a_distance_is_the_integral_of_its_mass():
    def push(at):
        drag = resistance(AIRCRAFT, Phase(**BASE), at.mass * GRAVITY, Attitude(air_at(5000.0), at.speed, 0.0, 0.0))
        return Push(drag, drag * at.speed / 0.85 * 80e-9)

    cruise = powered({"kind": "cruise", "altitude": 5000.0, "distance": 400e3, "power": 1.0}, push)
    _, end = path_by_power(cruise, start(5000.0, 130.0))
    q, k = 0.5 * air_at(5000.0).density * 130.0**2 * 60.0, AIRCRAFT.induced
    root, factor = math.sqrt(AIRCRAFT.zero_lift_drag / k), GRAVITY / q
    # dm/dx = -(c/η) q S (C_D0 + k (g m/(q S))²): an arctangent
    passed = math.atan(factor * 20e3 / root) - 80e-9 / 0.85 * q * k * root * factor * 400e3
    assert end.mass == pytest.approx(root / factor * math.tan(passed), rel=1e-9)


@pytest.mark.parametrize("kind", ["take-off", "landing", "climb", "cruise", "speed-change"])
def test_the_work_of_the_thrust_is_drag_height_and_speed(kind):
    phases = {
        "take-off": ({"altitude": 10.7, "tas": 55.0}, start(), 60e3),
        "landing": ({}, start(0.0, 55.0), 2e3),
        "climb": ({"altitude": 5000.0, "cas": 90.0}, start(0.0, 90.0), 30e3),
        "cruise": ({"altitude": 3000.0, "duration": 900.0}, start(3000.0, 120.0), 15e3),
        "speed-change": ({"altitude": 3000.0, "tas": 140.0}, start(3000.0, 100.0), 25e3),
    }
    phase, begin, thrust = phases[kind]
    path, _ = path_by_power(powered({**phase, "kind": kind, "power": 1.0}, constant(thrust, 0.2)), begin)
    assert path.energy.residual < 1e-6
    assert abs(path.energy.thrust) > 0.0


def test_a_climb_by_calibrated_airspeed_gives_power_to_speed_too():
    climb = powered({"kind": "climb", "cas": 90.0, "altitude": 5000.0, "power": 1.0}, constant(30e3))
    path, end = path_by_power(climb, start(0.0, 90.0))
    assert path.nodes[-1].speed > 110.0  # true airspeed has risen with the height
    assert path.energy.gained == pytest.approx(20e3 * (GRAVITY * 5000.0 + 0.5 * (end.speed**2 - 90.0**2)), rel=1e-6)


def test_a_climb_changes_from_calibrated_airspeed_to_mach():
    climb = powered({"kind": "climb", "cas": 110.0, "mach": 0.35, "altitude": 7000.0, "power": 1.0}, constant(40e3))
    path, _ = path_by_power(climb, start(0.0, 110.0))
    machs = [node.speed / air_at(node.altitude).sound_speed for node in path.nodes]
    assert max(machs) == pytest.approx(0.35, rel=1e-12)
    assert path.energy.residual < 1e-3  # one step lies across the corner of the schedule


def test_steps_are_of_fourth_order():
    """A roll against drag and falling thrust, whose distance has no polynomial."""
    rolls = powered(
        {"kind": "take-off", "tas": 60.0, "power": 1.0}, lambda at: Push(60e3 / (1.0 + at.speed / 80.0), 0.0)
    )

    def distance(count):
        return march(_over_speed(rolls, 1.0), start(), length=60.0, count=count)[-1].distance

    exact = distance(512)
    errors = [abs(distance(count) - exact) for count in (2, 4, 8)]
    assert [math.log2(a / b) for a, b in pairwise(errors)] == pytest.approx([4.0, 4.0], abs=0.4)


def test_the_books_of_energy_notice_a_force_that_is_left_out():
    rolls = powered({"kind": "landing", "power": 1.0}, constant(2e3))
    states = march(_over_speed(rolls, 1.0), start(0.0, 55.0), length=-50.0, count=32)
    assert books(states[0], states[-1]).residual < 1e-6
    wrong = states[-1]._replace(drag_work=0.9 * states[-1].drag_work)
    assert books(states[0], wrong).residual > 0.05


def test_rotation_is_a_factor_above_the_stall():
    flaps = Flaps(highest_lift=2.2)
    aircraft = AIRCRAFT.model_copy(update={"take_off": flaps, "rotation_over_stall": 1.15})
    take_off = powered({"kind": "take-off", "power": 1.0}, constant(60e3), aircraft)
    lowest = math.sqrt(2.0 * 20e3 * GRAVITY / (air_at(0.0).density * 60.0 * 2.2))
    assert stall_speed(polar_of(aircraft, take_off.phase), air_at(0.0), 20e3 * GRAVITY, 2.2) == pytest.approx(lowest)
    assert rotation_speed(take_off, start()) == pytest.approx(1.15 * lowest)
