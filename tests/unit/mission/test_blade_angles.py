"""Of two blade angles that take one power, the one that was chosen stays: held, asked by a thrust, or governed."""

import math

import numpy as np
import pytest

from gearwright.catalogue import map_of, propeller_map
from gearwright.errors import DesignError
from gearwright.machines import angle_near, coefficients, governs
from gearwright.mission import fly, phase_forces
from gearwright.mission.windows import fly_window
from gearwright.shipped import shipped_mission
from gearwright.spec import edited_mission, parse_mission, read_mission
from gearwright.spec.missions import WindowRules
from shipped_work import sized

ANGLES = np.arange(-30.0, 41.0, 2.0)
LEAST = 4.0
"""Angle of least power of the hand-made map [deg]."""


def power(angle):
    """Return C_P of the hand-made map, the same at every advance ratio: a parabola."""
    return 0.03 + 4e-4 * (angle - LEAST) ** 2


def thrust(angle):
    """Return its C_T, a straight line through nothing at 2°."""
    return 0.012 * (angle - 2.0)


MAP = "advance_ratio,blade_angle_deg,power_coefficient,thrust_coefficient\n" + "".join(
    f"{ratio},{angle},{power(angle):.12g},{thrust(angle):.12g}\n" for ratio in (0.0, 2.0, 4.0) for angle in ANGLES
)
HEAD = 'schema = 1\nname = "test"\npropeller_map = "own.csv"\nengine = { thermal_power_kw = 2600 }\n'
HELD = """
[phases.brake]
altitude_ft = 0
tas_m_s = 40
duration_s = 60
pitch_deg = -12
propeller_speed_rpm = 1000
"""


@pytest.fixture
def folder(tmp_path):
    """Return a folder with the hand-made map."""
    (tmp_path / "own.csv").write_text(MAP, encoding="utf-8")
    return tmp_path


def scale():
    """Return ρ n² D⁴ at sea level and 1000 rpm [N]."""
    return 1.225 * (1000.0 / 60.0) ** 2 * sized("in-line").design.airscrews["propeller"].diameter ** 4


def test_a_plain_phase_in_reverse_brakes_as_its_blades_do(folder):
    """It had been given the forward angle of the same power, 20°: +0.216 of thrust coefficient for −0.168."""
    mission = parse_mission(HEAD + HELD, folder=folder)
    history = fly(sized("in-line"), mission, folder=folder).history
    assert power(-12.0) == pytest.approx(power(20.0))
    np.testing.assert_allclose(np.degrees(history.pitch), -12.0, rtol=1e-12)
    np.testing.assert_allclose(history.thrust, thrust(-12.0) * scale(), rtol=1e-4)  # 1.225 has four digits
    turns = 1000.0 / 60.0
    np.testing.assert_allclose(
        history.propeller_power, power(-12.0) * scale() * turns * (scale() / 1.225 / turns**2) ** 0.25, rtol=1e-4
    )


def test_a_phase_by_power_takes_the_blades_that_a_governor_finds(folder):
    held = fly(sized("in-line"), parse_mission(HEAD + HELD, folder=folder), folder=folder)
    given = float(sum(machine.power[0] for machine in held.machines.values()))
    text = HELD.replace("pitch_deg = -12", f"power_kw = {given / 1e3:.9f}")
    governed = fly(sized("in-line"), parse_mission(HEAD + text, folder=folder), folder=folder)
    np.testing.assert_allclose(np.degrees(governed.history.pitch), 20.0, rtol=1e-5)
    assert governed.history.thrust.min() > 0.0


def test_a_taxi_below_the_angle_of_least_power_has_the_thrust_that_was_asked(folder):
    """At 3.6° the blades push; the angle of the same power on the other side, 4.4°, pushes half as hard again."""
    aircraft = "[aircraft]\nmass_kg = 8000\nwing_area_m2 = 61\nzero_lift_drag = 0.025\ninduced_drag = 0.03\n"
    taxi = (
        HELD.replace("[phases.brake]", '[phases.taxi]\nkind = "taxi"')
        .replace("pitch_deg = -12\n", "")
        .replace("tas_m_s = 40", "tas_m_s = 5")
    )
    mission = parse_mission(HEAD + aircraft + taxi, folder=folder)
    flight = fly(sized("in-line"), mission, folder=folder)
    drag = 0.02 * (8000.0 * 9.80665 - 0.3 * 61.0 * 0.5 * 1.225 * 25.0) + 0.5 * 1.225 * 25.0 * 61.0 * 0.0277
    angle = 2.0 + drag / scale() / 0.012
    assert 2.0 < angle < LEAST
    np.testing.assert_allclose(np.degrees(flight.history.pitch), angle, rtol=5e-4)  # fuel is burnt
    (row,) = phase_forces(flight)
    assert row.left_over == pytest.approx(0.0, abs=1e-6 * row.drag)


def test_a_shipped_map_taxies_on_blades_below_the_angle_of_least_power():
    """At 5 m/s and 1200 rpm the thrust of taxi is that of 4.5°; at 0.12 of advance ratio the least power lies above."""
    shipped = read_mission(shipped_mission("regional-aircraft"))
    mission = edited_mission(shipped, {"phases.taxi-in.propeller_speed_rpm": 1200.0})
    flight = fly(sized("in-line"), mission)
    row = next(row for row in phase_forces(flight) if row.name == "taxi-in")
    assert abs(row.left_over) < 0.01 * row.drag


def test_the_angle_next_to_another_is_found_on_both_sides_of_least_power():
    chart = map_of(MAP, "own")
    for angle in (-12.0, 20.0):
        near = angle_near(chart, 1.0, power(angle), math.radians(angle + 3.0))
        assert math.degrees(near) == pytest.approx(angle, abs=1e-9)
    assert governs(chart, 1.0, math.radians(20.0))
    assert not governs(chart, 1.0, math.radians(-12.0))
    with pytest.raises(DesignError, match=r"power coefficient 2, of 0\.03 to"):
        angle_near(chart, 1.0, 2.0, 0.1)


def test_of_shipped_maps_in_all_states_thrust_decides_the_angle_between_braking_and_stall():
    """One rise of C_T spans all angles between, so that a thrust has one angle; a power has two."""
    for name in ("6-blades-af115-all-states", "4-blades-af114-all-states"):
        chart = propeller_map(name)
        for ratio in (0.1, 0.8, 1.6, 2.4):
            angles = np.radians(np.arange(0.0, 25.0, 0.5)) + math.atan(0.25 * ratio)
            forces = [coefficients(chart, ratio, angle).thrust for angle in angles]
            assert np.all(np.diff(forces) > 0.0)
            powers = [coefficients(chart, ratio, angle).power for angle in np.radians(np.arange(-20.0, 45.0, 1.0))]
            assert 0 < int(np.argmin(powers)) < len(powers) - 1


def test_a_window_in_reverse_starts_on_the_blades_that_are_held_and_leaves_them_there():
    """No governor works below the angle of least power: a coarser pitch would take less and the speed run away."""
    mission = parse_mission(HEAD.replace("own.csv", "6-blades-af115-all-states") + HELD)
    flight = fly(sized("in-line"), mission)
    window = fly_window(flight, "quiet", WindowRules(phase="brake", at=20.0, duration=0.05))
    pitch = window.trace.drive.of("propeller pitch")
    assert math.degrees(float(pitch["mean"][0])) == pytest.approx(-12.0, abs=0.2)  # losses are lumped otherwise
    assert np.ptp(pitch["mean"]) == pytest.approx(0.0, abs=1e-9)
    torque = window.trace.drive.of("propeller torque")["mean"]
    expected = flight.history.propeller_power[0] / flight.history.propeller_speed[0]
    np.testing.assert_allclose(torque, expected, rtol=5e-3)
