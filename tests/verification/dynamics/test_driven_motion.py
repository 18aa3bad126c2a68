"""Drives against closed forms: governed propeller, slipping clutch, a machine's slope, and the order of the steps."""

import math

import numpy as np
import pytest

from gearwright.catalogue import propeller_map
from gearwright.dynamics import Model, simulate, statics
from gearwright.dynamics.model import ClutchDrive, MachineDrive, PropellerDrive
from gearwright.machines import Governor, GovernorState, Rotor, coefficients, limit_cycle
from gearwright.mission.windows import PropellerTrim, governed_window
from governed_rotor import governed_response

PITCH, SPEED, DIAMETER, DENSITY, AIRSPEED = math.radians(42.3), 126.9, 3.93, 0.549, 161.0
CHART = propeller_map("6-blades-af115")
INERTIA = 143.0


def torque(speed: float, pitch: float) -> float:
    """Return what the propeller takes [N m]."""
    turns = speed / (2.0 * math.pi)
    power = coefficients(CHART, AIRSPEED / (turns * DIAMETER), pitch).power
    return power * DENSITY * turns**2 * DIAMETER**5 / (2.0 * math.pi)


def rotor() -> Rotor:
    """Return the propeller linear about the cruise, by central differences inside one cell of the map."""
    small = 1e-4
    slope = (torque(SPEED + small, PITCH) - torque(SPEED - small, PITCH)) / (2.0 * small)
    pitching = (torque(SPEED, PITCH + small) - torque(SPEED, PITCH - small)) / (2.0 * small)
    return Rotor(INERTIA, -slope, pitching, PITCH)


def governed(governor: Governor, kick: float = 0.0, stiffness: float = 1e7, command: float = 1.0):
    """Return hub and propeller on one shaft, driven by the torque of the cruise, and a start with a speed error."""
    model = Model()
    model.rotation("hub", inertia=0.3 * INERTIA, speed=SPEED)
    model.rotation("propeller", inertia=0.7 * INERTIA)
    model.shaft("shaft", "hub", "propeller", stiffness=stiffness, damping=2.0 * 0.05 * math.sqrt(stiffness * 30.0))
    start = GovernorState(PITCH, 0.0, 0.0)
    model.drive(PropellerDrive("propeller", "propeller", CHART, DIAMETER, governor, start, DENSITY, AIRSPEED, SPEED))
    model.drive(MachineDrive("motor", "hub", command * torque(SPEED, PITCH), SPEED))
    system = model.build()
    return system, (statics(system, balance="accelerate").position, np.full(2, kick))


def settings(gain_deg: float, damping: float, integral: float = 0.0) -> Governor:
    """Return a governor with an actuator of 0.1 s."""
    low, high, rate = (math.radians(each) for each in (38.0, 50.0, 10.0))
    return Governor(PITCH, math.radians(gain_deg), math.radians(integral), 0.1, damping, low, high, rate)


@pytest.mark.parametrize(("gain", "damping", "integral"), [(1.0, 0.0, 0.0), (1.0, 0.7, 0.0), (0.5, 0.7, 0.5)])
def test_a_governed_propeller_on_a_stiff_shaft_answers_as_the_rigid_closed_form(gain, damping, integral):
    """`governed_response` is linear in speed and pitch; at a kick of 0.05 rad/s what is left of the map's curvature
    is (0.05/127)/2 of the swing, and the shaft twists by 1e-3 of it."""
    governor, kick = settings(gain, damping, integral), 0.05
    system, start = governed(governor, kick)
    trace = simulate(system, 4.0, start=start)
    time, speed, pitch = governed_response(governor, rotor(), kick, duration=4.0)
    found = trace.samples.drive("propeller speed") - SPEED
    assert np.interp(trace.samples.time, time, speed) == pytest.approx(found, abs=5e-3 * kick)
    swing = np.ptp(pitch)
    assert np.interp(trace.samples.time, time, pitch) == pytest.approx(
        trace.samples.drive("propeller pitch"), abs=5e-3 * swing
    )


def test_the_thesis_gain_on_a_second_order_actuator_limit_cycles_on_an_elastic_train_too():
    """After a cut of 10 % of the torque; reference: `governed_window`, which marches the same map on a rigid train."""
    governor = settings(20.0, 0.7)
    system, start = governed(governor, command=0.9)
    trace = simulate(system, 10.0, start=start)
    found = limit_cycle(trace.samples.time, trace.samples.drive("propeller speed"))
    trim = PropellerTrim(CHART, DENSITY, AIRSPEED, DIAMETER, SPEED, PITCH, INERTIA)
    rigid = governed_window(trim, governor, duration=10.0, torque_step=-0.1).limit_cycle
    assert found is not None
    assert rigid is not None
    assert found.frequency == pytest.approx(rigid.frequency, rel=0.01)
    assert found.amplitude == pytest.approx(rigid.amplitude, rel=0.01)


def test_steps_are_of_fourth_order_through_propeller_and_governor():
    """Richardson: inside one cell of the map, half the step makes a sixteenth of the error of the governor's states."""
    system, start = governed(settings(1.0, 0.7, 0.5), kick=0.02, stiffness=1e6)
    ends = []
    for step in (1.6e-3, 0.8e-3, 0.4e-3, 0.1e-3):
        trace = simulate(system, 0.32, start=start, method="runge-kutta", step=step)
        ends.append(trace.samples.drives[-1][:3])
    errors = [float(np.max(np.abs(end - ends[-1]))) for end in ends[:-1]]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(4.0, abs=0.3)
    assert math.log2(errors[1] / errors[2]) == pytest.approx(4.0, abs=0.3)


def clutched(capacity: float, *, one_way: bool, slip: float):
    """Return two flywheels and a clutch between them; each carries a second disc on a stiff shaft."""
    model = Model()
    for name, speed in (("first", 100.0), ("second", 100.0)):
        model.rotation(name, inertia=1.0, speed=speed)
        model.rotation(f"{name} disc", inertia=1.0)
        model.shaft(f"{name} shaft", name, f"{name} disc", stiffness=1e6, damping=200.0)
    model.drive(ClutchDrive("clutch", "first", "second", 1e5, 100.0, capacity, one_way))
    return model.build(), (np.zeros(4), np.array([slip, slip, 0.0, 0.0]))


def test_a_friction_clutch_locks_when_and_with_the_heat_that_two_flywheels_say():
    """t = J_red Δω/T with J_red = J/2 = 1 kg m²; heat ½ J_red Δω²: 20 rad/s, 40 N m → 0.5 s and 200 J."""
    system, start = clutched(40.0, one_way=False, slip=20.0)
    trace = simulate(system, 1.0, start=start)
    slip, sticking = trace.samples.drive("clutch slip"), trace.samples.drive("clutch slipping") == 0.0
    assert trace.samples.time[np.argmax(np.abs(slip) < 0.05)] == pytest.approx(0.5, rel=5e-3)
    assert sticking[-1]
    assert trace.work.braked - trace.work.driven == pytest.approx(200.0, rel=5e-3)
    assert trace.samples.velocity[-1] == pytest.approx(np.full(4, 10.0), abs=1e-3)


def test_an_overrunning_clutch_lets_go_when_the_second_rotation_leads():
    system, start = clutched(1e9, one_way=True, slip=-5.0)
    trace = simulate(system, 0.2, start=start)
    assert trace.samples.drive("clutch torque") == pytest.approx(0.0, abs=1e-9)
    assert trace.samples.velocity[-1] == pytest.approx([-5.0, -5.0, 0.0, 0.0], abs=1e-6)


def test_a_machine_with_a_slope_runs_up_as_the_exponential_of_its_law():
    """J ω̇ = T (1 + κ (1 − ω/ω_r)) − T: the speed error dies with the rate κ T/(J ω_r)."""
    model = Model()
    model.rotation("rotor", inertia=0.5, speed=100.0)
    model.rotation("disc", inertia=0.5)
    model.shaft("shaft", "rotor", "disc", stiffness=1e6, damping=100.0)
    model.drive(MachineDrive("turbine", "rotor", 50.0, 100.0, 1.5))
    model.load("disc", constant=-50.0)
    twist = 50.0 / 1e6
    trace = simulate(model.build(), 2.0, start=(np.array([twist, 0.0]), np.full(2, -8.0)))
    expected = 100.0 - 8.0 * np.exp(-1.5 * 50.0 / 100.0 * trace.samples.time)
    # The start is twisted as at rest; the shaft's own small oscillation about the acceleration is what is left.
    assert trace.samples.drive("turbine speed") == pytest.approx(expected, abs=5e-3)
