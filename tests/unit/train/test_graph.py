"""The graph of a design: nodes, gears, mesh rows, clutches."""

from designs import HYBRID, PAIR, changed
from gearwright.spec import GROUND, parse
from gearwright.train import EXTERNAL, INTERNAL, build_train

LAYSHAFTS = """\
schema = 1
name = "two layshafts"
level = "concept"
shafts = ["in", "left", "right", "out"]
[turbines.turbine]
shaft = "in"
power_kw = 2000
speed_rpm = 20000
[propellers.propeller]
shaft = "out"
speed_rpm = 1212
diameter_m = 3.9
[pairs.first]
pinion = "in"
wheel = ["left", "right"]
halves = 2
[pairs.second]
pinion = ["left", "right"]
wheel = "out"
"""


def test_a_planetary_set_is_two_rows_relative_to_its_carrier():
    train = build_train(parse(HYBRID))
    assert train.nodes == ("input", "middle", "output", "first.planet", "second.planet")
    sun, ring = train.meshes[0], train.meshes[1]
    assert (sun.nodes, sun.sign, sun.count) == (("input", "first.planet", "middle"), EXTERNAL, 3)
    assert (ring.nodes, ring.sign, ring.count) == (("first.planet", GROUND, "middle"), INTERNAL, 3)
    assert [(gear.name, gear.bodies) for gear in train.gears[:3]] == [
        ("first.sun", 1), ("first.planet", 3), ("first.ring", 1)
    ]  # fmt: skip


def test_a_pair_is_one_row_on_the_ground():
    train = build_train(parse(PAIR))
    (mesh,) = train.meshes
    assert (mesh.name, mesh.nodes, mesh.sign) == ("stage", ("fast", "slow", GROUND), EXTERNAL)
    assert build_train(parse(PAIR + "internal = true\n")).meshes[0].sign == INTERNAL


def test_a_gear_that_meshes_with_several_has_a_row_for_each():
    train = build_train(parse(LAYSHAFTS))
    assert [mesh.name for mesh in train.meshes] == ["first.left", "first.right", "second.left", "second.right"]
    assert [mesh.count for mesh in train.meshes] == [2, 2, 1, 1]
    assert {gear.name: gear.bodies for gear in train.gears} == {
        "first.pinion": 2, "first.wheel": 4, "second.pinion": 2, "second.wheel": 1
    }  # fmt: skip


def test_a_shared_gear_is_one_body():
    text = (
        changed(PAIR, '"slow"]', '"slow", "motor"]') + '[pairs.motor-stage]\npinion = "motor"\nwheel = "stage.wheel"\n'
    )
    text += '[motors.electric]\nshaft = "motor"\npower_kw = 10\nspeed_rpm = 4000\n'
    train = build_train(parse(text))
    assert [gear.name for gear in train.gears] == ["stage.pinion", "stage.wheel", "motor-stage.pinion"]
    assert train.meshes[1].gears == ("motor-stage.pinion", "stage.wheel")
    assert train.meshes[1].nodes == ("motor", "slow", GROUND)
    assert train.gear("stage.wheel").nodes == ("slow",)


def test_an_open_clutch_joins_nothing():
    text = changed(PAIR, 'wheel = "slow"', 'wheel = "idle"').replace('"slow"]', '"slow", "idle"]')
    text += '[clutches.sprag]\ndriving = "idle"\ndriven = "slow"\n'
    (joint,) = build_train(parse(text)).joints
    assert (joint.name, joint.driving, joint.driven, joint.overrunning) == ("sprag", "idle", "slow", True)
    assert build_train(parse(text + 'kind = "open"\n')).joints == ()
    assert build_train(parse(text + 'kind = "engaged"\n')).joints[0].overrunning is False
