"""Power slams in windows that wait for the gas generator: what they begin and end with, inertia, limits, bad input."""

import numpy as np
import pytest

import shipped_work
from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.mission.windows.background import background, value_at
from gearwright.mission.windows.events import changed
from gearwright.spec import WindowRules, edited_mission, parse_mission, read_mission

SPOOL = {"engine.spool.pressure_ratio": 12.0, "engine.spool.speed_rpm": 33000.0, "engine.spool.inertia_kg_m2": 0.1}
RULES = WindowRules(phase="run-up", at=22.0, duration=9.0, event_at=1.0, event="power-slam", power=2.05e6)


def slammed(rules=RULES, **changes):
    """Return the turbine's torque in a slam, and what there was without it."""
    mission = edited_mission(read_mission("thesis"), SPOOL | {f"engine.spool.{key}": it for key, it in changes.items()})
    flight = fly(shipped_work.sized(), mission)
    back = background(flight, rules)
    return changed(back, rules).torques["gas-turbine"], back.torques["gas-turbine"]


def half_time(curve):
    """Return when half of the change has come, after the lever [s]."""
    time, torque = np.array([point for point in curve if point[0] >= RULES.event_at]).T
    middle = 0.5 * (torque[0] + torque[-1])
    return float(time[np.argmax(np.abs(torque - torque[0]) >= abs(middle - torque[0]))]) - RULES.event_at


def test_a_slam_begins_with_the_flights_torque_and_ends_with_that_of_a_lag():
    """The same ends as by a lag of 0.2 s, 40 of which are over: 0.5 %, to which the governor on N1 has settled."""
    spooled, before = slammed()
    lagged, _ = slammed(RULES.model_copy(update={"lag": 0.2}))
    assert value_at(spooled, 0.9) == pytest.approx(value_at(before, 0.9), rel=1e-9)
    assert value_at(spooled, 1.0) == pytest.approx(value_at(lagged, 1.0), rel=1e-6)
    assert value_at(spooled, 9.0) == pytest.approx(value_at(lagged, 9.0), rel=5e-3)
    assert value_at(spooled, 9.0) > 2.0 * value_at(before, 1.0)


def test_a_heavier_gas_generator_takes_longer():
    """At the acceleration limit J dN1/dt is given by the engine alone: twice the inertia, nearly twice the time."""
    light, heavy = (half_time(slammed(inertia_kg_m2=inertia)[0]) for inertia in (0.1, 0.2))
    assert 1.4 < heavy / light < 2.2


def test_less_fuel_for_acceleration_takes_longer():
    fast, slow = (half_time(slammed(acceleration=limit)[0]) for limit in (1.2, 0.7))
    assert slow > 1.1 * fast


def test_a_slam_beyond_the_engine_is_refused_with_path_and_fix():
    with pytest.raises(DesignError, match=r"windows: power-slam: gas-turbine: needs .* and gives .*; ask for less"):
        slammed(RULES.model_copy(update={"power": 1e7}))
    with pytest.raises(DesignError, match=r"engine\.spool: .*give other efficiencies"):
        slammed(pressure_ratio=40.0, compressor=0.55, turbine=0.55)


def test_without_lag_a_slam_asks_for_a_gas_generator():
    text = 'schema = 1\nname = "x"\n[phases.a]\naltitude_m = 0\ntas_m_s = 50\nduration_s = 60\npower_kw = 900\n'
    text += 'propeller_speed_rpm = 1212\n[windows.w]\nphase = "a"\nevent = "power-slam"\npower_kw = 800\n'
    with pytest.raises(DesignError, match=r"windows\.w: power-slam without lag; give one, or \[engine\.spool\]"):
        parse_mission(text)
    spool = "[engine.spool]\npressure_ratio = 12\nspeed_rpm = 33000\ninertia_kg_m2 = 0.1\n"
    assert parse_mission(text + spool).engine.spool.inertia == 0.1
