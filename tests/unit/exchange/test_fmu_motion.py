"""The equations in C are those of the Python right-hand side, law by law, and their steps those of `simulate`."""

import functools

import numpy as np
import pytest

import gearwright as gw
from driven_train import SPEED, driven_state, driven_train, propeller
from fmu_host import COMPILES, ERROR, OK, WARNING, Instance, Unpacked
from gearwright.dynamics import Line, Model
from gearwright.dynamics.equations import WORKS, reference
from gearwright.dynamics.model import MachineDrive
from gearwright.dynamics.motion import BLOCK, blank_record, equilibrium, stepper
from gearwright.exchange import fmu_of_system, to_fmu
from gearwright.exchange.fmu import MachinePort
from random_systems import random_system

pytestmark = COMPILES
FORCE, VELOCITY, DRIVE = 3, 2, 5
"""Blocks of references."""


def names_of(file, block):
    """Return the names of a block of variables."""
    return [port.name for port in file.ports if port.reference >> 20 == block]


def marched(system, state, step, count, since=0.0):
    """March the plain right-hand side by the classical Runge–Kutta method; return forces, speeds and drives."""
    arrays, size = system.arrays, len(system.arrays.mass)

    def rate(time, now):
        position, velocity, states = now[:size], now[size : 2 * size], now[2 * size :]
        pulled = reference.acceleration(arrays, time, position, velocity, states)
        return np.concatenate([velocity, pulled, reference.driven(arrays, time, velocity, states).rate])

    forces, speeds, drives = [], [], []
    for number in range(count + 1):
        time = since + number * step
        position, velocity = state[:size], state[size : 2 * size]
        forces.append(reference.line_state(arrays, time, position, velocity).force)
        speeds.append(arrays.speed * reference.speed_factor(arrays.profile, time)[0] + velocity)
        drives.append(reference.driven(arrays, time, velocity, state[2 * size :]).output)
        a = rate(time, state)
        b = rate(time + 0.5 * step, state + 0.5 * step * a)
        c = rate(time + 0.5 * step, state + 0.5 * step * b)
        d = rate(time + step, state + step * c)
        state = state + step / 6.0 * (a + 2.0 * b + 2.0 * c + d)
    return np.array(forces), np.array(speeds), np.array(drives)


def compare(system, position, velocity, folder, *, step, count, since=0.0):
    """Hold an FMU against the plain right-hand side: 1e-12 of what is largest, as rounding adds up over steps.

    Of drives of each number; sums of errors of speeds begin at 0, and have the rounding of those speeds, 1e-14.
    """
    file = fmu_of_system(system, start=(position, velocity), step=step)
    state = np.concatenate([position, velocity, system.arrays.drives.start])
    wanted = marched(system, state, step, count, since)
    one = Instance(Unpacked(file.content, folder)).begin(since)
    times = since + step * np.arange(count + 1)
    blocks = [names_of(file, block) for block in (FORCE, VELOCITY, DRIVE)]
    found = np.split(
        one.run(times, [name for block in blocks for name in block]),
        np.cumsum([len(block) for block in blocks])[:2],
        axis=1,
    )
    one.free()
    for numbers, given, axis in zip(found, wanted, (None, None, 0), strict=True):
        largest = np.max(np.abs(given), axis=axis, initial=0.0)
        assert np.all(np.abs(numbers - given) <= 1e-12 * largest + 1e-14)


@pytest.mark.parametrize("seed", [1, 2])
def test_lines_frames_schedules_and_profiles_are_those_of_the_plain_right_hand_side(seed, tmp_path):
    """With backlash, infinite backlash, errors, varying stiffness, gyroscopic terms and a speed that changes."""
    system, rng = random_system(seed, 6, 12), np.random.default_rng(seed)
    size = len(system.arrays.mass)
    compare(system, rng.normal(0.0, 0.05, size), rng.normal(0.0, 1.0, size), tmp_path, step=2e-3, count=200, since=0.3)


@pytest.mark.parametrize(("one_way", "command"), [(False, 2900.0), (True, 9000.0)])
def test_propeller_governor_machines_and_clutch_follow_their_laws_in_python(one_way, command, tmp_path):
    """The second train asks its turbine for more than its limit, and its clutch overruns; 1e-12, as in `compare`.

    From 55 ms the turbine's command falls, from 100 ms the speed.
    """
    system = driven_train(one_way=one_way, command=command)
    position, velocity, _ = driven_state(system)
    compare(system, 0.01 * position, velocity, tmp_path, step=2e-4, count=300, since=0.055)


@pytest.mark.parametrize(
    ("speed", "damping", "above", "aims"),
    [(SPEED, 0.0, 1e-3, (0.98, 1.01)), (-SPEED, 0.0, 1e-3, (0.98, 1.01)), (SPEED, 0.7, 0.2, (1.05, 0.93))],
)
def test_governors_at_their_stops_and_fastest_rates_are_those_in_python(speed, damping, above, aims, tmp_path):
    """Integrals stand still at a stop, until the set speed changes; the second propeller turns the other way."""
    first, last = (aim * SPEED for aim in aims)
    drive = propeller(set_speed=((0.0, first), (0.15, first), (0.2, last)), pitch_command=((0.0, 0.0), (0.3, 0.01)))
    governor = drive.governor._replace(damping=damping, upper=drive.start.pitch + above)
    system = propelled(drive._replace(governor=governor), speed)
    compare(system, np.zeros(2), np.zeros(2), tmp_path, step=1e-3, count=400)


def test_dampers_slip_with_the_speed_profile_as_in_python(tmp_path):
    model = Model(profile=((0.0, 1.0), (0.1, 1.0), (0.2, 0.7)))
    for name, speed in (("first", 20.0), ("second", 30.0), ("third", 20.0)):
        model.rotation(name, inertia=2.0, speed=speed)
    model.damper("damper", "second", "first", damping=0.4)
    model.shaft("shaft", "first", "third", stiffness=4000.0)
    compare(model.build(), np.array([0.01, 0.0, 0.0]), np.zeros(3), tmp_path, step=1e-3, count=300)


def propelled(drive, speed=SPEED):
    """Return a propeller with a hub that a turbine drives about as in the cruise."""
    model = Model()
    model.rotation("propeller", inertia=100.0, speed=speed)
    model.rotation("hub", inertia=1.0)
    model.shaft("stub", "hub", "propeller", stiffness=1e4, damping=10.0)
    model.drive(MachineDrive("turbine", "hub", 11600.0, SPEED, 0.8))
    model.drive(drive)
    return model.build()


@functools.cache
def shipped(name):
    """Return system and FMU of a shipped design."""
    sizing = gw.size(gw.read(name))
    return gw.assemble(sizing), to_fmu(sizing)


@pytest.mark.parametrize("name", ["in-line-h2", "ec120b", "face-gear-split-torque"])
def test_a_shipped_design_moves_as_simulate_steps_it(name, tmp_path):
    """1e-12 of each line's peak over 5 ms; generated code of `simulate` adds the same numbers in another order."""
    system, file = shipped(name)
    arrays, size, lines = system.arrays, len(system.arrays.mass), len(system.arrays.stiffness)
    state = np.concatenate([equilibrium(system), np.zeros(size + WORKS)])
    steps = round(0.005 / file.step)
    record, rows, advance = blank_record(arrays, BLOCK), [], stepper(arrays, "runge-kutta", file.step)
    for first in range(0, steps, BLOCK):
        part = record[: min(BLOCK, steps - first)]
        advance(first, part, state)
        rows.append(part[:, 2 * size : 2 * size + lines].copy())
    wanted, every = np.concatenate(rows), 25
    one = Instance(Unpacked(file.content, tmp_path)).begin()
    found = one.run(file.step * np.arange(0, steps, every), names_of(file, FORCE))
    one.free()
    peaks = np.max(np.abs(wanted), axis=0)
    assert np.all(np.abs(found - wanted[::every]) <= 1e-12 * peaks)


def test_how_often_it_is_looked_at_changes_nothing(tmp_path):
    """Bit for bit at common times: the steps of the integration are its own."""
    _, file = shipped("in-line-h2")
    fmu, names = Unpacked(file.content, tmp_path), names_of(file, FORCE)
    ends = []
    for length in (1e-3, 3.7e-5, 1e-6):
        one = Instance(fmu).begin()
        times = np.append(np.arange(0.0, 2e-3, length), 2e-3)
        ends.append(one.run(times[np.append(np.diff(times) > 1e-9, True)], names)[-1])
        one.free()
    assert np.array_equal(ends[0], ends[1])
    assert np.array_equal(ends[0], ends[2])


def test_a_torque_from_outside_is_a_load_of_the_system(tmp_path):
    """Against a system whose load is the new one, from an equilibrium that lasts up to 0.4 of a step: 1e-12."""
    after = []
    for change in (0.0, -3.0):
        model = two_bodies()
        model.load("first", constant=5.0 + change)
        after.append(model.build())
    one, file = hosted(after[0], tmp_path)
    names, step = [*names_of(file, FORCE), *names_of(file, VELOCITY)], file.step
    one.run(step * np.array([0.0, 50.0, 100.4]), names)
    assert one.put({"first.torque": 2.0}) == OK
    forces, speeds, _ = marched(after[1], np.append(equilibrium(after[0]), [0.0, 0.0]), step, 50)
    found = one.run(step * (100.4 + np.arange(51)), names)
    one.free()
    np.testing.assert_allclose(found[:, 0], forces[:, 0], rtol=0.0, atol=1e-12 * np.max(np.abs(forces)))
    np.testing.assert_allclose(found[:, 1:], speeds, rtol=1e-12)


def two_bodies(profile=((0.0, 1.0),)):
    """Return two bodies on a shaft, the second with a brake."""
    model = Model(profile=profile)
    model.rotation("first", inertia=2.0, speed=10.0)
    model.rotation("second", inertia=3.0)
    model.add(Line("shaft", {"first": 1.0, "second": -1.0}, stiffness=4000.0, damping=80.0, kind="shaft"))
    model.load("second", constant=-5.0)
    return model


def hosted(system, folder, **wanted):
    """Return an instance of a system whose first body is a machine, ready to step, and its file."""
    loads = zip(system.labels.coordinates, system.arrays.loads.constant, strict=True)
    machines = [MachinePort(name, name, float(load)) for name, load in loads]
    file = fmu_of_system(system, machines, step=1e-3)
    return Instance(Unpacked(file.content, folder)).begin(**wanted), file


def test_a_machine_of_given_speed_keeps_it_and_says_the_torque_that_it_takes(tmp_path):
    """Settled on a shaft whose other end is braked by 5 N m, it takes as much (1e-9)."""
    model = two_bodies()
    model.load("first", constant=5.0)
    one, _ = hosted(model.build(), tmp_path, **{"first.speed_is_given": True, "first.given_speed": 12.0})
    assert one.step(0.0, 10.0) == OK
    assert one.value("first.speed") == 12.0
    assert one.value("second.speed") == pytest.approx(12.0, abs=1e-9)
    assert one.value("first.acting_torque") == pytest.approx(5.0, abs=1e-9)
    assert one.value("shaft.transmitted_torque") == pytest.approx(5.0, abs=1e-9)
    one.free()


def test_a_profile_of_the_reference_changes_nothing_at_a_given_speed(tmp_path):
    """It is only what positions are measured from: torques and speeds are those without it (1e-9)."""
    answers = []
    for number, profile in enumerate((((0.0, 1.0),), ((0.0, 1.0), (0.9, 0.5)))):
        model = two_bodies(profile)
        model.load("first", constant=5.0)
        one, _ = hosted(model.build(), tmp_path / str(number), **{"first.speed_is_given": True})
        assert one.step(0.0, 0.5) == one.put({"first.given_speed": 11.0}) == one.step(0.5, 0.02) == OK
        answers.append(one.values(["first.acting_torque", "first.speed", "second.speed", "shaft.transmitted_torque"]))
        one.free()
    np.testing.assert_allclose(answers[1], answers[0], rtol=1e-9)


def test_two_machines_of_one_body_are_not_both_given_a_speed(tmp_path):
    machines = [MachinePort("motor", "first", 1.0), MachinePort("brake", "first", -1.0)]
    fmu = Unpacked(fmu_of_system(two_bodies().build(), machines, step=1e-3).content, tmp_path)
    one = Instance(fmu)
    assert one.put({"motor.speed_is_given": True, "brake.speed_is_given": True}) == OK
    assert one.call("EnterInitializationMode") == OK
    assert one.call("ExitInitializationMode") == ERROR
    assert "two machines of one body" in one.said[-1]
    assert one.put({"brake.speed_is_given": False}) == OK
    assert one.call("ExitInitializationMode") == OK
    one.free()


def test_the_speed_factor_sets_speeds_at_the_start_and_leaves_them_later(tmp_path):
    """Later it is a change of the frame that positions are measured from: nothing that can be seen jumps."""
    model = two_bodies()
    model.load("first", constant=5.0)
    one, file = hosted(model.build(), tmp_path, speed_factor=0.5)
    assert one.value("first.speed") == pytest.approx(5.0, rel=1e-12)
    one.step(0.0, 0.1)
    names = [*names_of(file, FORCE), *names_of(file, VELOCITY)]
    before = one.values(names)
    assert one.put({"speed_factor": 1.0}) == OK
    np.testing.assert_allclose(one.values(names), before, rtol=1e-12)
    one.free()


def test_phases_that_follow_run_with_the_train(tmp_path):
    """A torque doubles the speed: the speed factor goes with the angular momentum, which no shaft changes (1e-9)."""
    model = two_bodies()
    model.load("first", constant=5.0)
    one, _ = hosted(model.build(), tmp_path, phases_follow=True)
    assert one.put({"first.torque": 55.0}) == OK
    for number in range(1000):
        assert one.step(1e-3 * number, 1e-3) == OK
    # Torque 50 N m more, inertia 5 kg m²: 10 rad/s in a second; the factor is that of the last step's start.
    assert one.value("speed_factor") == pytest.approx(1.0 + 0.999, abs=1e-9)
    one.free()


def test_a_propeller_outside_its_map_is_told_and_a_motion_without_end_is_refused(tmp_path):
    one = Instance(Unpacked(fmu_of_system(propelled(propeller()), step=1e-3).content, tmp_path)).begin()
    assert one.step(0.0, 0.01) == OK
    assert one.put({"propeller.airspeed": 900.0}) == OK
    assert one.step(0.01, 0.01) == WARNING
    assert "outside its map" in one.said[-1]
    assert one.put({"propeller.density": 1e300}) == OK
    assert one.step(0.02, 1.0) == ERROR
    assert "diverged" in one.said[-1]
    assert one.step(1.02, 0.1) == ERROR
    assert "may not be called in the state: failed" in one.said[-1]
    one.free()
