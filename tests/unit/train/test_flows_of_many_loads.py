"""Torques of many loads at once against those of each alone, and what stages give to shafts, in watts."""

import math
from dataclasses import replace

import numpy as np
import pytest

from designs import HYBRID, changed
from gearwright.spec import GROUND, parse
from gearwright.train import (
    Efficiency,
    Turning,
    along,
    build_train,
    can_be_along,
    is_slight,
    power_flow,
    shaft_powers,
    speed_range,
    tooth_ratio_range,
)  # fmt: skip

near = pytest.approx

TEETH = {"first.sun": 30, "first.planet": 36, "first.ring": 102, "second.sun": 33, "second.planet": 27}
TEETH["second.ring"] = 87
LOADS = {"driven": (900e3, 300e3), "charging": (400e3, -250e3), "braked": (-80e3, -250e3), "dragging": (-20e3, 60e3)}
"""Case -> powers of turbine and motor [W]; the last three turn the power of one stage or of both round."""
LOST = {"first": 0.012, "second": 0.03}
TEXT = changed(HYBRID, "[turbines.turbine]", "[motors.turbine]").split("[cases.cruise.turbine]")[0] + "".join(
    f"[cases.{name}]\nshare = 0.25\nturbine.power_kw = {turbine / 1e3}\nelectric.power_kw = {motor / 1e3}\n"
    for name, (turbine, motor) in LOADS.items()
)


@pytest.fixture(scope="module")
def hybrid():
    design = parse(TEXT)
    train = build_train(design)
    return design, train, Turning(design, train, TEETH)


def torques_of(hybrid, lost=LOST):
    """Return what `along` says of all loads, and the flow of each alone."""
    design, train, turning = hybrid
    flows = [
        power_flow(design, train, TEETH, case, efficiency={stage: 1.0 - part for stage, part in lost.items()})
        for case in LOADS
    ]
    senses = {name: turning.senses[node] for name, node in train.machines.items()}
    turn = turning.turn({"propeller": senses["propeller"] * abs(flows[0].speeds["output"])}, [])
    node = train.column["output"]
    assert can_be_along(turn, node)
    applied = np.zeros((len(LOADS), len(train.nodes)))
    for row, flow in enumerate(flows):
        for machine in ("turbine", "electric"):
            applied[row, train.column[train.machines[machine]]] = flow.machine_torques[machine]
    part = np.array([[lost[mesh.stage] for mesh in train.meshes]] * len(LOADS))
    return along(turn, node, part, applied), flows


def test_loads_of_both_senses_solved_together_are_those_of_each_alone(hybrid):
    """Rounding of a linear system of some ten unknowns."""
    loads, flows = torques_of(hybrid)
    meshes = [mesh.name for mesh in hybrid[1].meshes]
    for row, flow in enumerate(flows):
        assert loads.balancing[row] == near(flow.machine_torques["propeller"], rel=1e-9)
        for k, name in enumerate(meshes):
            found = (loads.multipliers[row, k], loads.first[row, k], loads.second[row, k], loads.third[row, k])
            assert found == near((flow.meshes[name].multiplier, *flow.meshes[name].torques), rel=1e-9, abs=1e-9)
    assert {np.sign(loads.multipliers[row]).tobytes() for row in range(len(flows))} != {loads.multipliers[0].tobytes()}


def test_loads_of_one_sense_need_one_system_and_no_load_gives_no_torque(hybrid):
    _, train, turning = hybrid
    _, flows = torques_of(hybrid)
    turn = turning.turn({"propeller": turning.senses["output"] * 1.0}, [])
    applied = np.zeros((3, len(train.nodes)))
    applied[1:, train.column["input"]] = [
        flows[0].machine_torques["turbine"],
        2.0 * flows[0].machine_torques["turbine"],
    ]
    part = np.full((3, len(train.meshes)), 0.01)
    both = along(turn, train.column["output"], part, applied)
    assert not both.multipliers[0].any() and both.balancing[0] == 0.0
    assert both.multipliers[2] == near(2.0 * both.multipliers[1], rel=1e-12)


def test_losses_that_may_leave_several_states_are_not_solved_together(hybrid):
    """Nine tenths of the power are lost in every mesh: what rows feel reaches a half, where several states may be."""
    _, train, turning = hybrid
    turn = turning.turn({"propeller": turning.senses["output"] * 1.0}, [])
    count, place = len(train.meshes), np.arange(len(train.meshes))
    one = np.where(place == 0, 0.9, 0.001)  # one mesh is enough
    part = np.stack([np.full(count, 0.9), one, np.full(count, 0.01)])
    assert is_slight(turn, train.column["output"], part).tolist() == [False, False, True]


def test_stages_give_shafts_what_machines_take_and_planets_and_ground_are_none_of_them(hybrid):
    """Turbine 900 kW into the sun, motor 300 kW at the shaft between: 900 (1 − loss) and then both together."""
    design, train, _ = hybrid
    flow = power_flow(design, train, TEETH, "driven", efficiency={"first": 1.0, "second": 1.0})
    powers = shaft_powers(train, flow)
    assert powers == {
        ("first", "input"): near(-900e3, rel=1e-12),
        ("first", "middle"): near(900e3, rel=1e-12),
        ("second", "middle"): near(-1200e3, rel=1e-12),
        ("second", "output"): near(1200e3, rel=1e-12),
    }
    assert GROUND not in {shaft for _, shaft in powers}


def test_the_residual_of_a_flow_is_what_its_powers_leave_open_over_what_comes_in(hybrid):
    """100 and 50 kW in, 120 kW out, nothing lost by these meshes: 30/150; without any power nothing is open."""
    design, train, _ = hybrid
    flow = power_flow(design, train, TEETH, "driven", efficiency={"first": 1.0, "second": 1.0})
    powers = {"turbine": 100e3, "electric": 50e3, "propeller": -120e3}
    assert replace(flow, machine_powers=powers).residual == near(0.2, rel=1e-12)
    assert replace(flow, machine_powers={**powers, "propeller": -160e3}).residual == near(1.0 / 15.0, rel=1e-12)
    assert replace(flow, machine_powers={"turbine": 0.4, "propeller": -0.3}).residual == near(0.25, rel=1e-6)
    assert replace(flow, machine_powers=dict.fromkeys(powers, 0.0)).residual == 0.0


RANGED = """\
schema = 1
name = "a pair of bounded ratio and one of given teeth"
level = "concept"
shafts = ["fast", "middle", "slow"]
[turbines.turbine]
shaft = "fast"
power_kw = 100
speed_rpm = 6000
[propellers.propeller]
shaft = "slow"
speed_rpm = 1000
diameter_m = 2
[pairs.first]
pinion = "fast"
wheel = "middle"
ratio = 2.5
[planetaries.second]
sun = "middle"
ring = "ground"
carrier = "slow"
planets = 5
"""


def test_a_shaft_turns_within_what_its_stages_leave_between_known_speeds():
    """Behind a ratio of 2.5 it has one speed; before a set 1 + z_r/z_s times the carrier's, as teeth allow."""
    design = parse(RANGED)
    fast, slow = 600.0, 100.0
    low, high = tooth_ratio_range(design.planetaries["second"], design, sun=150)
    least, most = 1.0 + low, 1.0 + high
    assert 2.0 < least < most < math.inf
    assert speed_range("middle", design, {"slow": slow}, sun=150) == near((slow * least, slow * most))
    assert speed_range("middle", design, {"fast": fast}, sun=150) == near((fast / 2.5, fast / 2.5))
    both = speed_range("middle", design, {"fast": fast, "slow": slow}, sun=150)
    assert both == near((max(240.0, slow * least), min(240.0, slow * most)))
    assert speed_range("slow", design, {"middle": fast}, sun=150) == near((fast / most, fast / least))
    assert speed_range("fast", design, {"middle": fast}, sun=150) == near((2.5 * fast, 2.5 * fast))
    assert speed_range("slow", design, {"fast": fast}, sun=150) == speed_range("middle", design, {}, sun=150)
    assert speed_range("middle", design, {}, sun=150) == (0.0, math.inf)


@pytest.mark.parametrize(
    ("forwards", "backwards", "locked"),
    [(0.9, 0.8, ()), (0.9, -0.1, ("out",)), (0.9, 0.0, ("out",)), (-0.2, 0.7, ("in",)), (0.0, 0.0, ("in", "out"))],
)
def test_shafts_cannot_drive_where_nothing_arrives(forwards, backwards, locked):
    way = Efficiency(("in",), ("out",), forwards, backwards)
    assert way.locked == locked
    only = {(): "", ("out",): "out cannot drive it, only in can", ("in",): "in cannot drive it, only out can"}
    assert way.locking == only.get(locked, "in and out cannot drive it")
