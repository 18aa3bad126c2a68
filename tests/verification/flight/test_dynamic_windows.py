"""Dynamic windows against the quasi-steady flight, against the rigid governed propeller, and against themselves."""

import math
from functools import cache

import numpy as np
import pytest

from gearwright.dynamics import simulate
from gearwright.dynamics.motion import fastest_rate, followed, with_profile
from gearwright.machines import Governor
from gearwright.mission import fly, governed_window, trim_at
from gearwright.mission.windows import fly_window
from gearwright.render.answers.flights import window_answer
from gearwright.render.answers.schema import plain
from gearwright.render.pages.flight import window_page
from gearwright.shipped import find_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import GovernorRules, WindowRules, parse_mission, read
from html_checks import stands_alone
from shipped_work import flown

STIFFNESSES = ("constant", "varying")


def interval(flight, time):
    """Return the interval of a flight at a time."""
    return int(np.argmin(np.abs(flight.history.time - time)))


@cache
def quiet(phase, at, stiffness):
    """Return a second of a flight without an event, flown once for all tests that look at it."""
    return fly_window(flown(), "quiet", WindowRules(phase=phase, at=at, duration=1.0, stiffness=stiffness))


@pytest.mark.parametrize("stiffness", STIFFNESSES)
@pytest.mark.parametrize(("phase", "at"), [("cruise", 605.0), ("climb", 305.0), ("taxi-out", 105.0)])
def test_a_quiet_window_has_the_means_of_the_quasi_steady_flight(phase, at, stiffness):
    """Propeller torque: the same balance, 1e-4. Shafts and teeth: losses are lumped at the first shaft of each stage
    instead of at each mesh, half a per cent of the torque."""
    flight = flown()
    window = quiet(phase, at, stiffness)
    k, trace = interval(flight, window.start), window.trace
    expected = flight.history.propeller_power[k] / flight.history.propeller_speed[k]
    assert trace.drive.of("propeller torque")["mean"][-1] == pytest.approx(expected, rel=1e-3)
    assert math.degrees(trace.drive.of("propeller pitch")["mean"][-1]) == pytest.approx(
        math.degrees(flight.history.pitch[k]), abs=0.02
    )
    pressure = math.cos(flight.sizing.design.gears.pressure_angle)
    for row in ("first.sun-planet", "second.sun-planet"):
        force = np.mean([np.mean(trace.force.of(f"{row}-{n}")["mean"][-100:]) for n in (1, 2, 3)])
        scale = flight.meshes["second.sun-planet"].force[k]
        assert abs(force) == pytest.approx(abs(flight.meshes[row].force[k]) / pressure, rel=1e-2, abs=2e-3 * abs(scale))


@pytest.mark.parametrize("stiffness", STIFFNESSES)
def test_in_green_taxi_the_teeth_of_stage_one_carry_nothing_on_average(stiffness):
    """Pulvirenti 2023, §4.2.1: stage-1 forces zero (constant) or of zero mean (varying), here over stage 2's."""
    trace = quiet("taxi-out", 105.0, stiffness).trace
    second = np.mean(trace.force.of("second.sun-planet-1")["mean"])
    for line in trace.labels.lines:
        if line.startswith("first."):
            assert abs(np.mean(trace.force.of(line)["mean"])) < 1e-3 * second


def test_peaks_of_a_quiet_window_are_those_of_its_end():
    """What varying stiffness shakes at the start, here 1.5 times the peaks that last, is no load of the flight; what is
    left of it when statistics begin is below 1e-3. Planets of a row have one peak, whatever tooth they start on: their
    places in the cycle are turned by whole steps."""
    trace = quiet("cruise", 605.0, "varying").trace
    for row in ("first.sun-planet", "first.planet-ring", "second.sun-planet", "second.planet-ring"):
        peaks = np.array([trace.force.of(f"{row}-{n}")["maximum"] for n in (1, 2, 3)])
        assert np.max(peaks) == pytest.approx(np.max(peaks[:, -100:]), rel=2e-3)
        assert np.ptp(np.max(peaks, axis=1)) < 2e-3 * np.max(peaks)


def test_a_motor_cut_moves_speed_and_pitch_as_on_a_rigid_train():
    """`governed_window` marches the rigid train with the same map and governor, its drive a source of torque. In the
    first milliseconds the elastic train rings by 4 % of the swing; once that is damped, 1 % is left."""
    flight, rules = flown(), GovernorRules()
    window = fly_window(
        flight, "cut",
        WindowRules(phase="cruise", at=605.0, duration=4.0, event="motor-cut", event_at=0.01, over=0.001,
                    stiffness="constant", turbine_slope=0.0),
    )  # fmt: skip
    found, labels, speeds = window.trace.samples, window.system.labels, window.system.arrays.speed
    ratio = abs(speeds[labels.coordinates.index("electric")] / speeds[labels.coordinates.index("propeller")])
    step = -ratio * found.drive("electric torque")[0] / found.drive("propeller torque")[0]
    trim = trim_at(flight, window.start)
    governor = Governor(
        trim.pitch, math.radians(rules.gain_deg_s), math.radians(rules.integral_deg_rad), rules.time_constant,
        rules.damping, math.radians(37.0), math.radians(58.0), math.radians(rules.rate_deg_s),
    )  # fmt: skip
    rigid = governed_window(trim, governor, duration=4.0, torque_step=step)
    apart = np.abs(found.drive("propeller speed") - np.interp(found.time - 0.0105, rigid.time, rigid.speed))
    assert np.max(apart) < 0.04 * np.ptp(rigid.speed)
    assert np.max(apart[found.time > 0.5]) < 0.01 * np.ptp(rigid.speed)


def test_the_speed_profile_does_not_change_the_motion_of_constant_stiffness():
    """It is only where coordinates are measured from; tolerance: the steps' error over the swing of the speed."""
    flight = flown()
    rules = WindowRules(phase="cruise", at=605.0, duration=2.0, event="motor-cut", event_at=0.2, stiffness="constant")
    window = fly_window(flight, "cut", rules)
    fixed = with_profile(window.system, [(0.0, float(window.system.arrays.profile.factor[0]))])
    other = simulate(fixed, 2.0, step=1.0 / fastest_rate(window.system.arrays))
    one, two = (trace.samples.drive("propeller speed") for trace in (window.trace, other))
    assert np.interp(window.trace.samples.time, other.samples.time, two) == pytest.approx(one, abs=1e-4)


def test_the_rigid_pass_is_followed_by_the_elastic_train():
    """Mesh phases run with the profile: the elastic speed leaves it by less than 1e-4."""
    rules = WindowRules(phase="climb", at=300.0, duration=1.5, event="gust", gust=5.0, event_at=0.2)
    window = fly_window(flown(), "gust", rules)
    size_ = len(window.system.arrays.mass)
    assert len(window.system.arrays.profile.time) > 100
    assert np.abs(window.trace.samples.velocity[:, size_ - 1]).max() < 1e-4 * 126.9
    again = followed(window.system, 0.1)
    assert again.arrays.profile.factor[0] == window.system.arrays.profile.factor[0]


FAULTS = ("short-circuit", "pitch-runaway", "power-slam", "propeller-strike", "sudden-stop")


@pytest.mark.parametrize("name", ["taxi-to-hybrid", "hybrid-to-turbine", "pitch-step", "gust", *FAULTS])
def test_energies_close_in_every_shipped_window(name):
    """Tolerance: what is left of the steps, 1e-5 of the work; forces as accurate as any run promises."""
    rules = flown().mission.windows[name].model_copy(update={"stiffness": "varying"})
    window = fly_window(flown(), name, rules.model_copy(update={"duration": 7.0 if name == "taxi-to-hybrid" else 1.5}))
    assert window.trace.work.imbalance < 1e-5
    assert window.trace.error <= 1e-2
    assert window.trace.rms_error <= 1e-3


def test_a_governor_that_limit_cycles_is_named_with_frequency_and_amplitude():
    """The gain of Pulvirenti 2023 on an actuator of second order; a stable governor is not named."""
    rules = flown().mission.windows["thesis-gain"].model_copy(update={"stiffness": "constant"})
    found = fly_window(flown(), "thesis-gain", rules).limit_cycle
    assert found is not None
    assert found.frequency == pytest.approx(2.0, abs=0.1)
    assert found.amplitude == pytest.approx(1.1, abs=0.1)
    calm = rules.model_copy(update={"governor": None, "duration": 5.0})
    assert fly_window(flown(), "calm", calm).limit_cycle is None


def test_a_late_engine_joins_through_its_overrunning_clutch():
    """Behind by 300 rpm its clutch overruns without torque; its turbine catches up, and then the clutch carries it."""
    text = shipped_mission("regional-250nm").read_text(encoding="utf-8") + (
        '\n[windows.join]\nphase = "climb"\nat_min = 3\nduration_s = 2.5\nevent = "clutch-engagement"\nslip_rpm = 300\n'
        'clutch = "sprag-2"\nover_s = 0.5\nstiffness = "constant"\n'
    )
    flight = fly(size(read(find_design("twin-engine-sprag"))), parse_mission(text))
    samples = fly_window(flight, "join").trace.samples
    before, after = samples.time < 1.0, samples.time > 2.0
    assert samples.drive("sprag-2 torque")[before] == pytest.approx(0.0, abs=1e-9)
    assert samples.drive("sprag-2 slip")[0] == pytest.approx(-300.0 * math.pi / 30.0, rel=1e-6)
    assert np.all(samples.drive("sprag-2 slipping")[after] == 0.0)
    carried, given = (np.mean(samples.drive(name)[after]) for name in ("sprag-2 torque", "turbine-2 torque"))
    assert carried == pytest.approx(given, rel=0.02)


def test_the_page_of_a_window_says_first_what_its_json_says():
    window, sizing = quiet("cruise", 605.0, "constant"), flown().sizing
    page, told = window_page(window, sizing), plain(window_answer(window))
    stands_alone(page)
    margins = [min(load.bending_margin, load.contact_margin) for load in window.meshes]
    margins += [load.margin for load in window.shafts]
    assert ('class="verdict bad"' in page) == (min(margins) < 1.0)
    assert f'data-v="{min(margins):.7g}"' in page
    assert f'data-v="{max(row["peak_torque_nm"] for row in told["shafts"]):.7g}"' in page
