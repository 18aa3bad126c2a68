"""Every kind of phase against a calculation by hand: air, airspeeds, drag, energy and momentum are written here anew.

Of the flight only what it flew is read: times, thrust, fuel. Tolerances: thrust and drag are those of the middles of
intervals of 10 s, on the runway of some twenty of them.
"""

import math
from functools import cache

import numpy as np
import pytest

from gearwright.mission import fly
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import edited_mission, read, read_mission

G, FT, KT, NM = 9.80665, 0.3048, 1852.0 / 3600.0, 1852.0
MASS, AREA, DRAG, ASPECT, OSWALD = 22300.0, 61.0, 0.025, 12.0, 0.71
"""Of the missions' aircraft."""
FLAPS = {"clean": 0.0, "take-off": 0.015, "landing": 0.05}
LIFTS = {"clean": 1.35, "take-off": 1.785, "landing": 2.55}
ROLLING, BRAKING, ROLL_LIFT = 0.02, 0.3, 0.3
"""Friction and lift on the wheels: defaults of the mission file."""


@cache
def flown(name="regional-aircraft", design="in-line", changes=()):
    """Return a flight of a shipped mission."""
    mission = edited_mission(read_mission(shipped_mission(name)), dict(changes))
    return fly(size(read(shipped_design(design))), mission)


def air(height):
    """Return density [kg/m³] and pressure [Pa] of the standard troposphere."""
    temperature = 288.15 - 0.0065 * height
    pressure = 101325.0 * (temperature / 288.15) ** (G / (287.05287 * 0.0065))
    return pressure / (287.05287 * temperature), pressure


def true(calibrated, height):
    """Return the true airspeed of a calibrated one [m/s]: impact pressure at sea level, and back where it is flown."""
    impact = 101325.0 * ((1.0 + 0.2 * (calibrated / 340.294) ** 2) ** 3.5 - 1.0)
    density, pressure = air(height)
    return math.sqrt(7.0 * pressure / density * ((impact / pressure + 1.0) ** (1.0 / 3.5) - 1.0))


def drag(speed, height, lift, flaps="clean"):
    """Return the drag of a lift [N]."""
    force = 0.5 * air(height)[0] * speed**2 * AREA
    if force == 0.0:
        return 0.0
    return force * (DRAG + FLAPS[flaps] + (lift / force) ** 2 / (math.pi * ASPECT * OSWALD))


def wheels(speed, height, mass, *, friction, flaps):
    """Return what holds on the ground: drag of the lift at C_L 0.3, and friction of what is left of the weight [N]."""
    lift = ROLL_LIFT * 0.5 * air(height)[0] * speed**2 * AREA
    return drag(speed, height, lift, flaps) + friction * (mass * G - lift)


class Part:
    """One phase as it was flown."""

    def __init__(self, name, flight=None):
        flight = flight or flown()
        history, within = flight.history, np.array([phase == name for phase in flight.phase])
        burnt = 2.0 * history.fuel_flow * history.duration
        before = np.cumsum(burnt) - burnt
        self.start = float(history.time[within][0] - 0.5 * history.duration[within][0])
        self.time, self.span = history.time[within], history.duration[within]
        self.speed, self.height = history.true_airspeed[within], history.altitude[within]
        self.thrust, self.burnt = 2.0 * history.thrust[within], burnt[within]
        self.mass = MASS - before[within] - 0.5 * self.burnt
        self.first, self.last = self.mass[0] + 0.5 * self.burnt[0], self.mass[-1] - 0.5 * self.burnt[-1]
        self.duration, self.way = float(self.span.sum()), float((self.speed * self.span).sum())

    def work(self, held):
        """Return the work of thrust over a force that holds, which takes (speed, height, mass, sin γ) [J]."""
        slopes = np.gradient(self.height, self.time) / self.speed if len(self.time) > 1 else np.zeros(1)
        rows = zip(self.speed, self.height, self.mass, slopes, strict=True)
        against = np.array([held(*row) for row in rows])
        return float(((self.thrust - against) * self.speed * self.span).sum())

    def gain(self, start, end):
        """Return what height and speed gain, with those of the fuel that burns; ends as (speed, height) [J]."""
        ends = [0.5 * speed**2 + G * height for speed, height in (start, end)]
        return self.last * ends[1] - self.first * ends[0] + float(self.burnt.sum()) * 0.5 * (ends[0] + ends[1])


def clean(speed, height, mass, slope):
    """Return the drag in flight without flaps [N]."""
    return drag(speed, height, mass * G * math.sqrt(1.0 - slope**2))


def test_taxi_is_friction_of_the_wheels_and_drag():
    """22.3 t at μ 0.02 are 4.37 kN, and 12 kt add 46 N of drag."""
    part = Part("taxi-out")
    expected = wheels(12.0 * KT, 0.0, MASS, friction=ROLLING, flaps="clean")
    assert expected == pytest.approx(4.40e3, abs=10.0)
    assert part.thrust[0] == pytest.approx(expected, rel=1e-3)
    assert part.duration == pytest.approx(300.0)


def test_a_take_off_rolls_until_its_energy_is_there():
    """½ m V² is the work over friction and drag; V_R is 1.1 of the stall at C_L 1.785. Roll within 5 % of
    the textbook's V_R²/(2 a) with the acceleration at 0.7 V_R (Anderson, Aircraft Performance and Design, 6.7)."""
    part, flight = Part("take-off"), flown()
    density = air(0.0)[0]
    rotates = 1.1 * math.sqrt(2.0 * part.first * G / (density * AREA * LIFTS["take-off"]))
    path = flight.paths["take-off"]
    rolls = [stage == "roll" for stage in path.stages]
    ends = path.nodes[sum(rolls)]
    assert ends.speed == pytest.approx(rotates, rel=1e-4)
    held = np.array(
        [
            wheels(speed, 0.0, mass, friction=ROLLING, flaps="take-off")
            for speed, mass in zip(part.speed, part.mass, strict=True)
        ]
    )
    work = float(((part.thrust - held) * part.speed * part.span)[rolls].sum())
    assert work == pytest.approx(0.5 * part.first * rotates**2, rel=0.01)
    some = 0.7 * rotates
    push = np.interp(some, part.speed[rolls], part.thrust[rolls])
    rate = (push - wheels(some, 0.0, part.first, friction=ROLLING, flaps="take-off")) / part.first
    assert path.distance("roll") == pytest.approx(rotates**2 / (2.0 * rate), rel=0.05)


def test_rotation_lasts_two_seconds_and_the_wheels_let_go_in_them():
    path = flown().paths["take-off"]
    turning = [leg for leg in path.legs if leg.stage == "rotation"]
    assert sum(leg.duration for leg in turning) == pytest.approx(2.0)
    gained = turning[-1].end.speed - turning[0].start.speed
    part = Part("take-off")
    push = np.interp(turning[0].start.time + 1.0 + part.start, part.time, part.thrust)
    speed = 0.5 * (turning[0].start.speed + turning[-1].end.speed)
    rolling = ROLL_LIFT * 0.5 * air(0.0)[0] * speed**2 * AREA
    lifts = [rolling + share * (part.last * G - rolling) for share in (0.0, 0.5, 1.0)]
    held = [drag(speed, 0.0, lift, "take-off") + ROLLING * (part.last * G - lift) for lift in lifts]
    mean = (held[0] + 4.0 * held[1] + held[2]) / 6.0  # Simpson: exact for the square of a lift that rises evenly
    assert gained == pytest.approx(2.0 * (push - mean) / part.last, rel=0.01)


@pytest.mark.parametrize(
    ("name", "speeds", "height"), [("to-climb", (None, 170.0), 35.0), ("to-descent", (275.0, 220.0), 17e3)]
)
def test_a_change_of_speed_on_the_level_is_work_over_drag(name, speeds, height):
    part, flight = Part(name), flown()
    height *= FT
    start = flight.paths[name].nodes[0].speed if speeds[0] is None else speeds[0] * KT
    end = true(speeds[1] * KT, height)
    assert part.work(clean) == pytest.approx(part.gain((start, height), (end, height)), rel=0.01)


def test_a_climb_by_power_gains_height_and_speed_by_what_is_over():
    """Energy over the whole climb, and at half of it dh/dt = (T − D) V/(m g (1 + V/g dV/dh))."""
    part = Part("climb")
    heights = (35.0 * FT, 17e3 * FT)
    ends = [(true(170.0 * KT, height), height) for height in heights]
    assert part.work(clean) == pytest.approx(part.gain(*ends), rel=2e-3)
    k = len(part.time) // 2
    speed, height, mass = part.speed[k], part.height[k], part.mass[k]
    assert speed == pytest.approx(true(170.0 * KT, height), rel=1e-3)
    change = (true(170.0 * KT, height + 50.0) - true(170.0 * KT, height - 50.0)) / 100.0
    over = (part.thrust[k] - drag(speed, height, mass * G)) * speed
    rate = over / (mass * G * (1.0 + speed / G * change))
    assert (part.height[k + 1] - part.height[k - 1]) / (part.time[k + 1] - part.time[k - 1]) == pytest.approx(
        rate, rel=5e-3
    )


def test_a_climb_at_a_stated_rate_takes_its_time_and_thrust():
    """700 ft/min from 1500 to 8000 ft; T = D + m g sin γ + m dV/dt."""
    part = Part("reserve-climb", flown("hybrid-reserves", "in-line-h2"))
    assert part.duration == pytest.approx((8000.0 - 1500.0) / 700.0 * 60.0, rel=1e-9)
    ends = [(true(170.0 * KT, height * FT), height * FT) for height in (1500.0, 8000.0)]
    assert part.work(clean) == pytest.approx(part.gain(*ends), rel=2e-3)


def test_a_cruise_is_drag_over_its_distance():
    part = Part("cruise")
    assert part.way == pytest.approx(120.0 * NM, rel=1e-9)
    assert part.duration == pytest.approx(120.0 / 275.0 * 3600.0, rel=1e-9)
    for k in (0, -1):
        assert part.thrust[k] == pytest.approx(drag(275.0 * KT, 17e3 * FT, part.mass[k] * G), rel=1e-4)


def test_a_cruise_by_power_settles_where_thrust_is_drag():
    flight = flown(
        changes=(
            ("phases.cruise.tas_kt", None),
            ("phases.cruise.power_kw", 1200.0),
            ("phases.to-descent.from_tas_kt", None),
        )
    )
    part = Part("cruise", flight)
    assert part.thrust[-1] == pytest.approx(drag(part.speed[-1], 17e3 * FT, part.mass[-1] * G), rel=5e-3)


def test_a_descent_at_a_rate_takes_what_is_left_of_drag():
    part = Part("descent")
    assert part.duration == pytest.approx((17000.0 - 1500.0) / 1100.0 * 60.0, rel=1e-9)
    ends = [(true(220.0 * KT, height * FT), height * FT) for height in (17e3, 1500.0)]
    assert part.work(clean) == pytest.approx(part.gain(*ends), abs=2e-3 * MASS * G * 15.5e3 * FT)
    k = len(part.time) // 2
    sink, turn = 1100.0 * FT / 60.0, (part.speed[k + 1] - part.speed[k - 1]) / (part.time[k + 1] - part.time[k - 1])
    expected = drag(part.speed[k], part.height[k], part.mass[k] * G) - part.mass[k] * (G * sink / part.speed[k] - turn)
    assert part.thrust[k] == pytest.approx(expected, abs=0.005 * drag(part.speed[k], part.height[k], part.mass[k] * G))


def test_a_descent_at_idle_sinks_as_its_drag_says():
    """At 250 kW a side; dh/dt as in the climb, with the sign of what is missing."""
    changes = (("phases.descent.rate_of_climb_ft_min", None), ("phases.descent.power_kw", 250.0))
    part = Part("descent", flown(changes=changes))
    k = len(part.time) // 2
    speed, height, mass = part.speed[k], part.height[k], part.mass[k]
    change = (true(220.0 * KT, height + 50.0) - true(220.0 * KT, height - 50.0)) / 100.0
    rate = (part.thrust[k] - drag(speed, height, mass * G)) * speed / (mass * G * (1.0 + speed / G * change))
    assert rate < 0.0
    assert (part.height[k + 1] - part.height[k - 1]) / (part.time[k + 1] - part.time[k - 1]) == pytest.approx(
        rate, rel=5e-3
    )


def test_an_approach_at_three_degrees_flies_its_triangle():
    part = Part("approach")
    assert part.way == pytest.approx(1500.0 * FT / math.sin(math.radians(3.0)), rel=2e-3)
    mean = 0.5 * (true(120.0 * KT, 0.0) + true(120.0 * KT, 1500.0 * FT))
    assert part.duration == pytest.approx(part.way / mean, rel=2e-3)
    k, slope = len(part.time) // 2, -math.sin(math.radians(3.0))
    speed, mass = part.speed[k], part.mass[k]
    held = drag(speed, part.height[k], mass * G * math.cos(math.radians(3.0)), "landing")
    turn = (part.speed[k + 1] - part.speed[k - 1]) / (part.time[k + 1] - part.time[k - 1])
    assert part.thrust[k] == pytest.approx(held + mass * (G * slope + turn), rel=0.01)


def test_a_landing_rolls_until_brakes_and_drag_have_taken_its_energy():
    part, path = Part("landing"), flown().paths["landing"]
    held = np.array(
        [
            wheels(speed, 0.0, mass, friction=BRAKING, flaps="landing")
            for speed, mass in zip(part.speed, part.mass, strict=True)
        ]
    )
    work = float(((part.thrust - held) * part.speed * part.span).sum())
    start, end = true(120.0 * KT, 0.0), 5.0
    assert path.nodes[0].speed == pytest.approx(start, rel=1e-4)
    assert work == pytest.approx(0.5 * part.first * (end**2 - start**2), rel=0.01)
    mean = float(held.mean() - part.thrust.mean()) / part.first
    assert path.distance() == pytest.approx((start**2 - end**2) / (2.0 * mean), rel=0.1)  # as if it braked evenly


def test_a_hold_is_drag_for_its_time_and_reserves_are_no_block_fuel():
    flight = flown("hybrid-reserves", "in-line-h2")
    part = Part("hold", flight)
    assert part.duration == pytest.approx(600.0)
    speed = true(170.0 * KT, 8000.0 * FT)
    assert part.thrust[0] == pytest.approx(drag(speed, 8000.0 * FT, part.mass[0] * G), rel=1e-3)
    reserves = [name for name, phase in flight.mission.phases.items() if phase.reserve]
    assert reserves == ["reserve-slower", "reserve-climb", "alternate", "hold", "reserve-descent"]
    assert sum(float(Part(name, flight).burnt.sum()) for name in reserves) == pytest.approx(437.5, abs=0.5)
    assert Part("alternate", flight).way == pytest.approx(60.0 * NM, rel=1e-9)
