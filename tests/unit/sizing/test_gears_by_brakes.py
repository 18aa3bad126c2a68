"""Sets that only brakes ground: teeth are chosen for the case that defines them, and every case is worked out."""

from __future__ import annotations

import numpy as np
import pytest

from designs import changed, problem
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import modes
from gearwright.dynamics.motion import simulate
from gearwright.sizing import size
from gearwright.spec import parse

REDUCED = '[cases.reduced]\nshare = 0.5\nengaged = ["brake"]\nmotor.rating = 1\n'
DIRECT = '[cases.direct]\nshare = 0.5\nengaged = ["lock"]\nmotor.rating = 1\n'
OPEN = """\
schema = 1
name = "two speeds"
level = "concept"
shafts = ["input", "output", "rim"]
[motors.motor]
shaft = "input"
power_kw = 100
speed_rpm = 9000
[loads.wheel]
shaft = "output"
speed_rpm = 3000
[planetaries.set]
sun = "input"
ring = "rim"
carrier = "output"
planets = 3
[clutches.brake]
driving = "rim"
driven = "ground"
kind = "open"
[clutches.lock]
driving = "input"
driven = "output"
kind = "open"
"""


def test_open_teeth_of_a_braked_set_are_those_of_a_grounded_one():
    grounded = changed(OPEN, 'ring = "rim"', 'ring = "ground"').replace(', "rim"]', "]")
    grounded = grounded[: grounded.index("[clutches.brake]")] + "[cases.reduced.motor]\nrating = 1\n"
    assert size(parse(OPEN + REDUCED + DIRECT)).teeth == size(parse(grounded)).teeth


def test_every_gear_is_sized_and_closes():
    """From the sun to the carrier: 3 with the ring braked; 1, and no load in the teeth, where it is locked."""
    flows = size(parse(OPEN + REDUCED + DIRECT)).flows
    assert flows["reduced"].speeds["input"] / flows["reduced"].speeds["output"] == pytest.approx(3.0, rel=1e-12)
    speeds = flows["direct"].speeds
    assert speeds["output"] == pytest.approx(speeds["input"], rel=1e-12) == pytest.approx(speeds["rim"], rel=1e-12)
    assert all(flow.residual < 1e-12 for flow in flows.values())
    assert flows["reduced"].given("brake") == pytest.approx(-2.0 * 100e3 / flows["reduced"].speeds["input"])
    assert flows["direct"].given("lock") == pytest.approx(100e3 / flows["direct"].speeds["input"])
    assert max(abs(mesh.tooth_power) for mesh in flows["direct"].meshes.values()) < 1e-6


@pytest.mark.parametrize("case", ["reduced", "direct"])
def test_every_gear_vibrates_and_runs(case):
    """The mean torque behind the input is that of the motor, whatever holds; one motion is rigid."""
    sizing = size(parse(OPEN + REDUCED + DIRECT))
    system = assemble(sizing, case)
    assert np.count_nonzero(modes(system).frequency < 1.0) == 1
    torque = simulate(system, 0.01).force.whole("input shaft").mean
    # 1e-3: the mean over less than whole periods of the mesh.
    assert abs(torque) == pytest.approx(100e3 / sizing.flows[case].speeds["input"], rel=1e-3)


def test_direct_drive_does_not_choose_the_teeth():
    """It comes first, and any teeth would do for it."""
    free = changed(changed(OPEN, "speed_rpm = 3000\n", ""), "planets = 3", "planets = 3\nratio = 4.2")
    speeds = size(parse(free + DIRECT + REDUCED)).flows["reduced"].speeds
    assert speeds["input"] / speeds["output"] == pytest.approx(4.2, rel=0.025)


def test_a_set_that_no_case_grounds_is_refused_by_its_shaft():
    found = problem(OPEN + changed(DIRECT, "share = 0.5\n", ""), sized=True)
    assert found.path == "shafts" and "the speeds of rim are not determined" in found.message


def test_a_speed_that_a_case_itself_asks_for_holds_in_its_gear():
    """Rated speeds are those of the first case's gear; one that the case of another gear says is held against it."""
    asked = DIRECT + "motor.speed_rpm = 9000\n[cases.direct.wheel]\nspeed_rpm = 5000\n"
    found = problem(OPEN + REDUCED + asked, sized=True)
    assert found.path == "cases.direct.wheel.speed" and "(+80.0%)" in found.message
