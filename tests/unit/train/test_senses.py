"""A shaft turns the same way in every case, whatever drives it."""

from __future__ import annotations

import pytest

from gearwright.sizing import size
from gearwright.spec import parse

HYBRID = """
schema = 1
name = "Pair and planetary set with a motor between and an overrunning clutch before them"
level = "concept"
shafts = ["engine", "input", "intermediate", "output"]
[turbines.turbine]
shaft = "engine"
power_kw = 500
speed_rpm = 33000
[motors.motor]
shaft = "intermediate"
power_kw = 150
speed_rpm = 8000
[propellers.propeller]
shaft = "output"
speed_rpm = 1900
diameter_m = 2.5
[clutches.sprag]
driving = "engine"
driven = "input"
[pairs.first]
pinion = "input"
wheel = "intermediate"
[planetaries.second]
sun = "intermediate"
ring = "ground"
carrier = "output"
planets = 3
[cases.motor-only.turbine]
power_kw = 0
[cases.motor-only.motor]
power_kw = 150
[cases.engine-stopped.motor]
power_kw = 150
[cases.rated.turbine]
rating = 1
[cases.rated.motor]
rating = 1
"""


@pytest.mark.parametrize("case", ["motor-only", "engine-stopped"])
def test_the_motor_alone_turns_the_propeller_as_the_turbine_does(case: str) -> None:
    flows = size(parse(HYBRID)).flows
    for shaft in ("input", "intermediate", "output"):
        # Within the teeth's tolerance: the motor keeps its speed here, the turbine in the rated case.
        assert flows[case].speeds[shaft] == pytest.approx(flows["rated"].speeds[shaft], rel=0.05)
    assert flows[case].speeds["engine"] == 0.0
    assert flows[case].joints == {}
    assert flows[case].machine_powers["motor"] == pytest.approx(150e3)
