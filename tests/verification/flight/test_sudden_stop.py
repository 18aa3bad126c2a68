"""Stops to rest against momentum, and against the torque of blades that stand in a stream."""

import math
from functools import cache

import numpy as np
import pytest

from gearwright.catalogue import propeller_map
from gearwright.dynamics.equations.kernel import apply_drives
from gearwright.dynamics.model import PropellerDrive
from gearwright.dynamics.model.elements import drive_effects, encoded
from gearwright.errors import SolveError
from gearwright.machines import Governor, GovernorState, coefficients
from gearwright.mission import fly
from gearwright.mission.windows import fly_window
from gearwright.shipped import find_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import WindowRules, parse_mission, read, read_mission

FULL = "6-blades-af115-all-states"


@cache
def thesis():
    """Return the thesis's mission flown by its hybrid."""
    return fly(size(read(find_design("in-line-h2"))), read_mission(shipped_mission("thesis")))


@cache
def stopped(**rules):
    """Return a window with a sudden stop, at constant stiffness."""
    given = {"event": "sudden-stop", "event_at": 0.1, "over": 0.02, "stiffness": "constant", "lag": 1e-3}
    return fly_window(thesis(), "stop", WindowRules(**given | rules))


def taxi(**rules):
    """Return a stop on the ground, where the air hardly matters."""
    return stopped(phase="taxi-in", at=200.0, **rules)


def inertias(window):
    """Return what turns, and the propeller alone, at the propeller [kg m²]."""
    arrays, place = window.system.arrays, window.system.labels.coordinates.index("propeller")
    rotation = arrays.speed / arrays.speed[place]
    return float(np.sum(arrays.mass * rotation**2)), float(arrays.mass[place])


def test_a_stop_takes_momentum_over_torque_and_half_the_rise():
    """J ω = ∫ T dt down to the 2 % that count as rest; 1 %: the air takes 3 % of the brake's torque at first."""
    window = taxi(stop_time=0.5, duration=1.0)
    assert window.rest - 0.1 == pytest.approx(0.98 * 0.5 + 0.5 * 0.02, rel=0.01)
    whole, _ = inertias(window)
    brake = window.trace.drive.of("brake torque")["minimum"].min()
    assert -brake == pytest.approx(whole * float(thesis().history.propeller_speed[-1]) / 0.5, rel=1e-3)
    assert window.trace.work.imbalance < 1e-5


def test_a_stop_by_torque_is_that_by_its_time():
    by_time = taxi(stop_time=0.5, duration=1.0)
    torque = -float(by_time.trace.drive.of("brake torque")["minimum"].min())
    assert taxi(brake_torque=torque, duration=1.0).rest == pytest.approx(by_time.rest, rel=1e-9)


def test_behind_the_propeller_the_shaft_carries_what_goes_on_turning():
    """(J − J_propeller) α while a slow brake acts; 2 %: the train still swings."""
    window = taxi(stop_time=3.0, over=1.2, duration=3.0)
    whole, own = inertias(window)
    samples = window.trace.samples
    held = (samples.time > 1.6) & (samples.time < 2.6)
    slowing = -np.polyfit(samples.time[held], samples.drive("propeller speed")[held], 1)[0]
    assert np.mean(samples.force("output shaft")[held]) == pytest.approx((whole - own) * slowing, rel=0.02)


def test_a_standing_propeller_bears_the_torque_of_its_stream():
    """Q = C_P/J² ρ V² D³/(2 π), C_P/J² of the last row of the map in all states."""
    window = stopped(phase="cruise", at=600.0, stop_time=0.5, duration=1.5)
    history, chart = thesis().history, propeller_map(FULL)
    k = int(np.searchsorted(history.time, window.start))
    pitch, last = float(window.trace.drive.of("propeller pitch")["mean"][-1]), float(chart.advance_ratio[-1])
    diameter = thesis().sizing.design.airscrews["propeller"].diameter
    stream = history.air_density[k] * history.true_airspeed[k] ** 2 * diameter**3 / (2.0 * math.pi)
    expected = coefficients(chart, last, pitch).power / last**2 * stream
    assert window.trace.drive.of("propeller torque")["mean"][-1] == pytest.approx(expected, rel=1e-2)
    assert expected < -5e3  # the stream turns it
    assert window.trace.drive.of("brake torque")["mean"][-1] == pytest.approx(expected, rel=1e-2)
    assert window.rest is not None


def test_every_mesh_of_a_seized_motor_bears_the_inertia_of_the_propeller():
    """Two thirds of what turns is the propeller: teeth next to it push harder than if it seizes, the others less."""
    rules = {"phase": "cruise", "at": 600.0, "stop_time": 0.3, "duration": 0.8}
    motor, propeller = stopped(**rules, machine="electric"), stopped(**rules)
    assert {load.mesh for load in motor.meshes} == {mesh.name for mesh in thesis().sizing.meshes}
    peak = {load.mesh: load.peak_force for load in propeller.meshes}
    for load in motor.meshes:
        assert (
            load.peak_force > 1.3 * peak[load.mesh]
            if load.mesh.startswith("second")
            else load.peak_force < peak[load.mesh]
        )
    assert motor.trace.drive.of("electric torque")["mean"][-1] == pytest.approx(0.0, abs=1e-9)


def test_machines_that_go_on_are_held_too_or_the_stop_is_none():
    """A brake of half the propeller's torque cannot hold turbine and motor."""
    weak = stopped(phase="cruise", at=600.0, brake_torque=5e3, lag=None, duration=0.6)
    assert weak.rest is None


def test_a_map_of_ones_own_that_ends_before_the_stop_is_told(tmp_path):
    rows = [
        f"{j},{b},{0.003 * (b - 10 * j):.6f},{0.003 * (b - 10 * j):.6f}" for j in (0, 1, 1.5, 2) for b in (25, 40, 55)
    ]
    head = "advance_ratio,blade_angle_deg,power_coefficient,thrust_coefficient"
    text = "\n".join([head, *rows[:-1]])  # at the last advance ratio the coarsest angle is missing
    (tmp_path / "own.csv").write_text(text, encoding="utf-8")
    mission = parse_mission(
        'schema = 1\nname = "test"\npropeller_map = "own.csv"\nengine = { thermal_power_kw = 2600 }\n'
        "[phases.cruise]\naltitude_ft = 20000\ntas_m_s = 110\nduration_s = 60\npower_kw = 500\n"
        "propeller_speed_rpm = 1212\n",
        folder=tmp_path,
    )
    flight = fly(size(read(find_design("in-line"))), mission, folder=tmp_path)
    rules = WindowRules(
        phase="cruise", at=20.0, duration=1.0, event="sudden-stop", event_at=0.1, stop_time=0.3, stiffness="constant"
    )
    with pytest.raises(SolveError, match="leaves its map"):
        fly_window(flight, "stop", rules)


@pytest.mark.parametrize("speed", [0.0, 0.5, 10.0, 120.0])
def test_the_compiled_law_beyond_the_map_is_the_one_in_plain_python(speed):
    governor = Governor(0.7, 0.01, 0.0, 0.1, 0.0, 0.7, 0.7, 0.1)
    chart, start = propeller_map(FULL), GovernorState(0.7, 0.0, 0.0)
    drive = PropellerDrive("p", "p", chart, 3.93, governor, start, 0.55, 160.0, 126.9, 0.0, True)
    drives = encoded([drive], {"p": 0}, np.array([126.9]))
    inputs = np.array([0.55, 160.0, 126.9, 0.0])
    plain = drive_effects(drives, np.array([speed]), inputs, np.array(start))
    torque, rate, output = np.zeros(1), np.zeros(3), np.zeros(6)
    apply_drives(drives.table, inputs, 0.0, np.array([speed]), np.array(start), torque, rate, output)
    assert torque == pytest.approx(plain.torque, rel=1e-12)
    assert output == pytest.approx(plain.output, rel=1e-12)
