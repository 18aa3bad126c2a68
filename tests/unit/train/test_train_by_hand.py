"""Targets, senses, clutches, circles of power and losses of trains, worked out by hand."""

import math

import numpy as np
import pytest
from test_recirculation import LOOP, TEETH
from test_senses import HYBRID as SPRAG

from designs import HYBRID, PAIR, changed
from gearwright.sizing import named_results, size
from gearwright.spec import parse
from gearwright.train import Turning, branches, build_train, handed_on, power_flow, recirculation, targets
from gearwright.train.graph import null_space, row_and_null_space
from gearwright.train.kinematics import willis_ratio, willis_speed
from gearwright.train.torques import Sharing, balance, solve_torques
from gearwright.units import RPM

TWO = """\
schema = 1
name = "two pairs in a row"
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
[pairs.second]
pinion = "middle"
wheel = "slow"
"""


def test_what_machines_leave_open_is_split_into_equal_ratios():
    found = targets(parse(TWO))
    assert found.tooth_ratios == {name: pytest.approx(math.sqrt(6.0), rel=1e-6) for name in ("first", "second")}
    assert found.speeds["middle"] == pytest.approx(6000 * RPM / math.sqrt(6.0), rel=1e-6)


def test_a_split_gives_one_stage_more_and_the_other_what_is_left():
    found = targets(parse(changed(TWO, 'wheel = "middle"\n', 'wheel = "middle"\nratio_split = 1.2\n')))
    assert found.tooth_ratios["first"] == pytest.approx(1.2 * math.sqrt(6.0), rel=1e-5)
    assert found.tooth_ratios["second"] == pytest.approx(math.sqrt(6.0) / 1.2, rel=1e-5)


def test_given_teeth_and_ratios_hold_before_equal_ones():
    teeth = changed(TWO, 'wheel = "middle"\n', 'wheel = "middle"\npinion_teeth = 20\nwheel_teeth = 40\n')
    assert targets(parse(teeth)).tooth_ratios["second"] == pytest.approx(3.0, rel=1e-5)
    ratio = changed(TWO, 'wheel = "slow"\n', 'wheel = "slow"\nratio = 1.5\n')
    assert targets(parse(ratio)).tooth_ratios["first"] == pytest.approx(4.0, rel=1e-5)


def test_a_stage_beside_the_way_to_the_propeller_takes_its_own_machines_ratio():
    """The pair of a motor is no part of the way from the turbine: the two stages of that stay equal."""
    text = changed(TWO, '"slow"]', '"slow", "boost"]') + '[pairs.side]\npinion = "boost"\nwheel = "middle"\n'
    free = targets(parse(text + '[motors.m]\nshaft = "boost"\npower_kw = 10\nspeed_rpm = 9000\n'))
    assert free.tooth_ratios["first"] == pytest.approx(math.sqrt(6.0), rel=1e-4)
    assert free.tooth_ratios["side"] == pytest.approx(9000.0 / 6000.0 * math.sqrt(6.0), rel=1e-4)


@pytest.mark.parametrize("ends", [("middle", "between"), ("between", "middle")])
def test_a_clutch_is_on_the_way_whichever_end_drives(ends):
    """Both pairs share the ratio of 6, although only a clutch joins them; a stage on the side does not."""
    text = changed(
        changed(TWO, '"middle", ', '"middle", "between", "aside", '), 'pinion = "middle"', 'pinion = "between"'
    )
    text += '[clutches.c]\ndriving = "{}"\ndriven = "{}"\nkind = "engaged"\n'.format(*ends)
    text += '[pairs.side]\npinion = "aside"\nwheel = "between"\n'
    found = targets(parse(text + '[motors.m]\nshaft = "aside"\npower_kw = 10\nspeed_rpm = 9000\n'))
    assert found.tooth_ratios["first"] == pytest.approx(math.sqrt(6.0), rel=1e-4)
    assert found.speeds["middle"] == pytest.approx(found.speeds["between"], rel=1e-5)
    assert found.tooth_ratios["side"] == pytest.approx(1.5 * math.sqrt(6.0), rel=1e-4)


def test_targets_of_sets_follow_from_willis():
    """6000 to 1212 and so on: z_r/z_s = ω_s/ω_c − 1 with the ring held."""
    found = targets(parse(HYBRID))
    assert found.tooth_ratios["first"] == pytest.approx(20000 / 4500 - 1.0, rel=1e-5)
    assert found.tooth_ratios["second"] == pytest.approx(4500 / 1212 - 1.0, rel=1e-5)


def test_a_slow_shaft_has_its_sense_too():
    """±1 by the sign of the speed alone: 0.4 rad/s is forwards."""
    text = changed(changed(PAIR, "speed_rpm = 6000", "speed_rpm = 4"), "speed_rpm = 2000", "speed_rpm = 2")
    design = parse(text)
    turning = Turning(design, build_train(design), {"stage.pinion": 20, "stage.wheel": 40})
    assert turning.senses["fast"] == 1.0 and turning.senses["slow"] == -1.0


def test_a_case_balances_with_a_machine_that_idles_behind_its_clutch():
    """The turbine stands still where it drives nothing; its clutch carries nothing, and the motor's power goes on."""
    sizing = size(parse(SPRAG))
    for case in ("motor-only", "engine-stopped"):
        flow = sizing.flows[case]
        assert flow.speeds["engine"] == 0.0 and "sprag" not in flow.joints
        assert flow.given("sprag") == 0.0
        assert flow.machine_powers["motor"] == pytest.approx(150e3)
        assert flow.machine_powers["propeller"] == pytest.approx(-150e3)
    rated = sizing.flows["rated"]
    assert rated.given("sprag") == pytest.approx(500e3 / rated.speeds["engine"])
    assert rated.machine_powers["propeller"] == pytest.approx(-650e3)


def test_a_machine_on_another_shaft_does_not_stop_with_the_clutch():
    """Two turbines behind clutches of their own: one at rest, the other goes on with its speed."""
    text = changed(SPRAG, 'shafts = ["engine", ', 'shafts = ["engine", "second-engine", ')
    other = '[turbines.other]\nshaft = "second-engine"\npower_kw = 200\nspeed_rpm = 33000\n'
    own = '[clutches.own]\ndriving = "second-engine"\ndriven = "input"\n'
    text = changed(text, "[clutches.sprag]", f"{other}{own}[clutches.sprag]")
    text = text.partition("[cases.motor-only.turbine]")[0]
    text += "[cases.all.turbine]\npower_kw = 500\n[cases.all.other]\npower_kw = 200\n[cases.all.motor]\npower_kw = 50\n"
    text += "[cases.one.turbine]\npower_kw = 0\n[cases.one.other]\npower_kw = 200\n[cases.one.motor]\npower_kw = 50\n"
    flow = size(parse(text)).flows["one"]
    assert flow.speeds["engine"] == 0.0 and flow.speeds["second-engine"] == pytest.approx(33000 * RPM, rel=0.05)
    assert flow.machine_powers["propeller"] == pytest.approx(-250e3)


def test_power_in_a_circle_is_found_through_a_clutch_too():
    """The loop of a set whose ring is driven from its carrier, with a clutch between idler and ring."""
    text = changed(LOOP, '"idler", "ring"]', '"idler", "beyond", "ring"]')
    text = changed(text, 'pinion = "idler"', 'pinion = "beyond"')
    text += '[clutches.c]\ndriving = "idler"\ndriven = "beyond"\nkind = "engaged"\n'
    design = parse(text)
    train = build_train(design)
    flow = power_flow(design, train, TEETH | {"down.wheel": 60})
    (loop,) = recirculation(train, flow)
    assert loop.power == pytest.approx(100e3 * 1.5 / 2.5, rel=1e-9)
    start = loop.path.index("stage set")
    around = (*loop.path[start:], *loop.path[:start])
    assert around == ("stage set", "out", "stage up", "idler", "link c", "beyond", "stage down", "ring")


def test_a_gear_of_two_shafts_gives_each_what_its_own_mesh_does():
    """Layshafts of unlike shares: branches tell the torque on each, not their sum."""
    text = TWO.replace('["fast", "middle", "slow"]', '["fast", "left", "right", "slow"]')
    text = text.replace('wheel = "middle"', 'wheel = ["left", "right"]\nshare = [0.6, 0.4]')
    design = parse(text.replace('pinion = "middle"', 'pinion = ["left", "right"]'))
    train = build_train(design)
    teeth = {"first.pinion": 20, "first.wheel": 50, "second.pinion": 20, "second.wheel": 48}
    flow = power_flow(design, train, teeth)
    whole = 100e3 / (6000 * RPM)
    wheels = {branch.shaft: branch.torque for branch in branches(train, flow) if str(branch.part) == "first.wheel"}
    assert {shaft: abs(torque) for shaft, torque in wheels.items()} == {
        "left": pytest.approx(0.6 * whole * 2.5), "right": pytest.approx(0.4 * whole * 2.5),
    }  # fmt: skip
    (pinion,) = [branch for branch in branches(train, flow) if str(branch.part) == "first.pinion"]
    assert pinion.torque == pytest.approx(-whole)


def test_losses_of_a_pair_are_what_the_efficiency_leaves():
    """η of the tooth power arrives, whichever side drives; a lossless train keeps all."""
    design = parse(PAIR)
    train, teeth = build_train(design), {"stage.pinion": 20, "stage.wheel": 60}
    flow = power_flow(design, train, teeth, efficiency={"stage": 0.97})
    assert flow.machine_powers["propeller"] == pytest.approx(-97e3)
    assert flow.loss == pytest.approx(3e3) and flow.residual < 1e-12
    assert flow.meshes["stage"].loss == pytest.approx(3e3)
    assert flow.meshes["stage"].tooth_power == pytest.approx(100e3)
    assert power_flow(design, train, teeth).loss == pytest.approx(0.0, abs=1e-9)


def test_losses_of_a_set_are_those_of_its_rolling():
    """Sun to carrier with the ring held: η = (1 + ρ η_s η_r)/(1 + ρ) with the basic efficiency of both meshes."""
    design = parse(
        HYBRID.partition("[motors.electric]")[0]
        + HYBRID[HYBRID.index("[propellers.propeller]") :].partition("[cases")[0]
    )
    train = build_train(design)
    teeth = {"first.sun": 24, "first.planet": 30, "first.ring": 84}
    teeth |= {"second.sun": 30, "second.planet": 25, "second.ring": 80}
    flow = power_flow(design, train, teeth, efficiency={"first": 0.98})
    efficiency = (1.0 + 84 / 24 * 0.98**2) / (1.0 + 84 / 24)
    assert -flow.machine_powers["propeller"] / 1046e3 == pytest.approx(efficiency, rel=1e-9)


def test_a_matrix_is_split_into_what_it_feels_and_what_it_does_not():
    matrix = np.array([[1.0, 1.0, 0.0], [2.0, 2.0, 0.0]])
    felt, free = row_and_null_space(matrix)
    assert felt.shape == (3, 1) and free.shape == (3, 2)
    assert np.abs(matrix @ free).max() < 1e-12 and abs(felt[:, 0] @ np.array([1.0, 1.0, 0.0])) == pytest.approx(2**0.5)
    none, every = row_and_null_space(np.zeros((0, 3)))
    assert none.shape == (3, 0) and every.tolist() == np.eye(3).tolist()
    assert null_space(np.array([[1.0, 0.0], [0.0, 1e-9]])).shape == (2, 0)
    assert null_space(np.array([[1.0, 0.0], [0.0, 1e-11]])).shape == (2, 1)


def test_parallel_rows_share_as_stated_and_then_alike():
    """One machine against three parallel rows: 12 N m as 6, 4, 2, or as 4 each."""
    matrix = np.array([[1.0, -1.0], [1.0, -1.0], [1.0, -1.0]])
    applied = np.array([12.0, 0.0])
    stated = Sharing((0, 1, 2), (0.5, 1.0 / 3.0, 1.0 / 6.0), stated=True)
    alike = Sharing((0, 1, 2), (1.0 / 3.0,) * 3, stated=False)
    assert solve_torques(balance(matrix, [1], [stated]), applied).tolist() == pytest.approx([-6.0, -4.0, -2.0, -12.0])
    assert solve_torques(balance(matrix, [1], [alike]), applied).tolist() == pytest.approx([-4.0, -4.0, -4.0, -12.0])
    both = balance(matrix, [1], [alike, stated])
    assert solve_torques(both, applied).tolist() == pytest.approx([-6.0, -4.0, -2.0, -12.0])
    assert solve_torques(balance(np.array([[1.0, -1.0]]), []), applied) is None
    single = solve_torques(balance(np.array([[1.0, -3.0]]), [1]), applied)
    assert single.tolist() == pytest.approx([-12.0, -36.0])


@pytest.mark.parametrize("member", ["in", "ring", "out"])
def test_willis_gives_each_member_from_the_other_two(member):
    """ω_s + ρ ω_r = (1 + ρ) ω_c with ρ = 3: 100, 20 and 40 rad/s belong together, and so do 30, 10 and 15."""
    stage = parse(LOOP).planetaries["set"]
    speeds = {"in": [100.0, 30.0], "ring": [20.0, 10.0], "out": [40.0, 15.0]}
    known = {shaft: np.array(values) for shaft, values in speeds.items() if shaft != member}
    found = willis_speed(stage, member, np.array([3.0, 3.0]), known)
    assert found.tolist() == pytest.approx(speeds[member])
    ratio = willis_ratio(stage, {shaft: np.array(values) for shaft, values in speeds.items()})
    assert ratio.tolist() == pytest.approx([3.0, 3.0])


def test_efficiency_is_what_arrives_of_what_is_given():
    """One pair of 0.97: 3 % of the power is lost."""
    sizing = size(parse(PAIR + "[gears]\nmesh_efficiency = 0.97\n"))
    assert named_results(sizing)["efficiency"].value == pytest.approx(0.97)
    assert named_results(size(parse(PAIR + "[gears]\nmesh_efficiency = 1\n")))["efficiency"].value == pytest.approx(1.0)


def test_however_little_teeth_lose_power_closes():
    """1e-10 of 100 kW is 10 µW: it goes into the teeth, and is no rounding of the sum."""
    flow = size(parse(PAIR + "[gears]\nmesh_efficiency = 0.9999999999\n")).reference
    assert flow.loss == pytest.approx(1e-10 * max(flow.machine_powers.values()), rel=1e-3)
    assert sum(flow.machine_powers.values()) == pytest.approx(flow.loss, rel=1e-3)


def test_a_compound_set_hands_on_speeds_in_the_ratio_of_its_ties():
    """Without their sense; what is known stays as it is, and where nothing is known nothing is handed on."""
    ties = {"a": 2.0, "b": -3.0, "c": 0.5}
    assert handed_on(ties, {"b": 12.0}) == {"a": pytest.approx(8.0), "c": pytest.approx(2.0)}
    assert handed_on(ties, {"a": 10.0, "b": 99.0}) == {"c": pytest.approx(2.5)}
    assert handed_on(ties, {"other": 1.0}) == {}
