"""Faults in windows against what they must become in limits: no flux, no time, a rigid train."""

from functools import cache

import numpy as np
import pytest

import shipped_work
from gearwright.machines import Winding, short_circuit_torque
from gearwright.mission.windows import fly_window
from gearwright.spec import GovernorRules, WindowRules

SHORT = {"event": "motor-short-circuit", "back_emf_v": 250.0, "inductance_mh": 0.1, "pole_pairs": 6}


@cache
def flown(**rules):
    """Return half a second of cruise, at constant stiffness, with an event after 0.05 s."""
    given = {"phase": "cruise", "at": 600.0, "duration": 0.5, "event_at": 0.05, "stiffness": "constant"}
    return fly_window(shipped_work.flown(), "fault", WindowRules(**given | rules))


def test_a_short_circuit_puts_the_torque_of_its_closed_form_on_the_rotor():
    """Straight lines between 32 points of a cycle, and the bins' extremes at steps: 1 %."""
    trace = flown(**SHORT, resistance_ohm=0.01).trace
    rated = shipped_work.flown().sizing.design.motors["electric"].speed
    torque = trace.drive.of("electric torque")
    speed, before = float(trace.samples.drive("electric speed")[0]), float(torque["mean"][0])
    expected = short_circuit_torque(
        Winding(250.0, 0.1e-3, 0.01, 6, rated), abs(speed), before=before, time=np.linspace(0.0, 0.45, 100_000)
    )
    assert torque["minimum"].min() == pytest.approx(expected.min(), rel=1e-2)
    assert torque["maximum"].max() == pytest.approx(expected.max(), rel=1e-2)
    assert torque["mean"][-1] == pytest.approx(expected[-1], rel=1e-2)
    assert trace.work.imbalance < 1e-5


def test_a_short_circuit_without_flux_is_a_motor_cut():
    """Torque falls at once; the cut takes a microsecond. 1e-3 of the torque: one line between two points."""
    cut = flown(event="motor-cut", over=1e-6).trace
    short = flown(**SHORT | {"back_emf_v": 0.0}).trace
    assert short.drive.of("electric torque")["mean"][-1] == 0.0
    for line in ("electric shaft", "output shaft"):
        assert short.force.of(line)["mean"] == pytest.approx(
            cut.force.of(line)["mean"], abs=1e-3 * np.abs(cut.force.of(line)["mean"]).max()
        )


def test_a_window_names_the_peak_of_every_mesh_and_shaft_beside_what_they_are_sized_for():
    """The shaft of a machine carries what its statistics say; margins fall as torque rises."""
    window = flown(**SHORT)
    assert {load.mesh for load in window.meshes} == {mesh.name for mesh in shipped_work.flown().sizing.meshes}
    shaft = next(load for load in window.shafts if load.shaft == "input")
    history, sized = window.trace.force.of("input shaft"), shipped_work.flown().sizing.shafts[0]
    assert shaft.peak_torque == max(history["maximum"].max(), -history["minimum"].min())
    assert shaft.margin == pytest.approx(sized.margin * sized.torque / shaft.peak_torque, rel=1e-12)


def test_an_engine_that_fails_without_delay_is_a_turbine_cut():
    """Its torque falls in microseconds; 2e-3 of the torque is left of the two ways to say it."""
    climb = {"phase": "climb", "at": 300.0, "duration": 0.3}
    cut = flown(**climb, event="turbine-cut", over=1e-5).trace
    out = flown(**climb, event="engine-out", lag=1e-6).trace
    for line in ("input shaft", "output shaft"):
        expected = cut.force.of(line)["mean"]
        assert out.force.of(line)["mean"] == pytest.approx(expected, abs=2e-3 * np.abs(expected).max())


def test_the_torque_of_an_engine_that_fails_halves_within_its_lag_times_the_logarithm_of_two():
    """Its slope is left out, so that its torque is what it is told; 2e-3: straight lines."""
    samples = flown(event="engine-out", lag=0.2, turbine_slope=0.0).trace.samples
    torque = samples.drive("gas-turbine torque")
    assert np.interp(0.05 + 0.2 * np.log(2.0), samples.time, torque) == pytest.approx(0.5 * torque[0], rel=5e-3)


def test_an_engine_that_fails_leaves_its_load_to_the_other_and_its_freewheel_never_pulls():
    """Nothing comes back through an overrunning clutch; the energies of clutch and train close."""
    flight = shipped_work.flown("twin-engine-sprag", "regional-250nm")
    rules = WindowRules(
        phase="climb", at=180.0, duration=1.5, event="engine-out", event_at=0.2, lag=0.1, machine="turbine-2",
        stiffness="constant",
    )  # fmt: skip
    trace = fly_window(flight, "out", rules).trace
    clutch = trace.drive.of("sprag-2 torque")
    assert clutch["mean"][0] == pytest.approx(trace.drive.of("turbine-2 torque")["mean"][0], rel=1e-6)
    assert clutch["minimum"].min() >= 0.0
    assert clutch["mean"][-1] < 0.01 * clutch["mean"][0]
    assert trace.drive.of("turbine-1 torque")["mean"][-1] > 300.0
    assert trace.work.imbalance < 1e-5


def test_a_pitch_that_runs_away_is_caught_by_the_overspeed_governor():
    """Until then it runs at the actuator's limit, 10 deg/s (2 %: of second order, it nears that in
    its own time); then the speed comes to rest at 1.05 of what was set, 2e-3 after ten seconds."""
    trace = flown(event="pitch-runaway", overspeed=1.05, duration=12.0, event_at=0.5).trace
    samples = trace.samples
    speed = samples.drive("propeller speed") / samples.drive("propeller speed")[0]
    running = (samples.time > 0.65) & (speed < 1.04) & (samples.time < samples.time[np.argmax(speed)])
    pitch = np.degrees(samples.drive("propeller pitch")[running])
    assert np.polyfit(samples.time[running], pitch, 1)[0] == pytest.approx(-10.0, rel=2e-2)
    assert 1.05 < speed.max() < 1.1
    assert speed[-1] == pytest.approx(1.05, abs=2e-3)
    assert trace.work.imbalance < 1e-5


def test_a_slam_to_the_power_that_is_there_changes_nothing():
    """What is staged anew at the same power are the torques of the flight; 1e-3: losses at the window's own speed."""
    flight = shipped_work.flown()
    k = int(np.argmin(np.abs(flight.history.time - fly_start())))
    power = sum(float(machine.power[k]) for machine in flight.machines.values())
    trace = flown(event="power-slam", power=power, lag=0.1).trace
    torque = trace.force.of("output shaft")["mean"]
    assert np.ptp(torque) < 1e-3 * torque[0]


def fly_start():
    """Return when the windows of this file start [s]."""
    return flown().start


def test_a_slam_raises_motors_within_over_and_turbines_by_their_lag():
    """Half the change of the torque is made after over/2 and lag ln 2."""
    rules = {"event": "power-slam", "power": 1.3e6, "lag": 0.1, "over": 0.02, "turbine_slope": 0.0}
    samples = flown(**rules, duration=1.5).trace.samples
    for machine, half in (("electric", 0.01), ("gas-turbine", 0.1 * np.log(2.0))):
        torque = samples.drive(f"{machine} torque")
        middle = np.interp(0.05 + half, samples.time, torque)
        assert middle == pytest.approx(0.5 * (torque[0] + torque[-1]), rel=1e-2)
        assert torque[-1] < torque[0]


def test_a_gentle_strike_is_carried_by_inertia_alone():
    """T = J α behind the shaft: what turns before the propeller goes on and pushes. The rise takes many cycles of the
    train; machines are sources of torque, the pitch stands. 1 %: the train still swings a little."""
    rules = {"event": "propeller-strike", "stop_time": 15.0, "lasts": 0.8, "over": 0.2, "turbine_slope": 0.0}
    window = flown(**rules, duration=0.6, losses=False, governor=GovernorRules(gain_deg_s=0.0, integral_deg_rad=0.0))
    arrays, trace = window.system.arrays, window.trace
    rotation = arrays.speed / arrays.speed[window.system.labels.coordinates.index("propeller")]
    inertia = float(np.sum(arrays.mass * rotation**2))
    own = float(arrays.mass[window.system.labels.coordinates.index("propeller")])
    time, shaft = trace.samples.time, trace.samples.force("output shaft")
    held = (time > 0.35) & (time < 0.55)
    slowing = -np.polyfit(time[held], trace.samples.drive("propeller speed")[held], 1)[0]
    assert np.mean(shaft[held]) - shaft[0] == pytest.approx((inertia - own) * slowing, rel=1e-2)
    assert trace.work.imbalance < 1e-5


def test_a_strike_over_endless_time_is_no_strike():
    still = flown(event="propeller-strike", stop_time=1e6, lasts=0.2, over=0.05).trace
    torque = still.force.of("output shaft")["maximum"]
    assert torque.max() == pytest.approx(torque[0], rel=1e-4)
