"""Speeds from teeth and machines, and trains that have none or too many."""

import pytest
from test_graph import LAYSHAFTS

from designs import PAIR, changed
from gearwright.errors import DesignError
from gearwright.spec import parse
from gearwright.train import build_train, power_flow
from gearwright.units import RPM

ROUNDING = 1e-12
"""A handful of operations on numbers of one size."""


def flow(text: str, teeth: dict[str, float], case: str = "rated"):
    """Return the power flow of a text with given teeth."""
    design = parse(text)
    return power_flow(design, build_train(design), teeth, case)


def planetary(sun: str, ring: str, carrier: str, *, motor: str = "") -> str:
    """Return a design whose turbine turns at 6000 rpm on shaft a and whose propeller is on shaft b."""
    head = PAIR[: PAIR.index("[pairs")].replace('"fast"', '"a"').replace('"slow"', '"b"')
    head = changed(head, '["a", "b"]', '["a", "b", "c"]') if motor else head
    return head + f'[planetaries.set]\nsun = "{sun}"\nring = "{ring}"\ncarrier = "{carrier}"\n' + motor


TEETH = {"set.sun": 30, "set.planet": 24, "set.ring": 78}


def test_an_external_pair_turns_the_other_way():
    found = flow(PAIR, {"stage.pinion": 20, "stage.wheel": 60})
    assert found.speeds["fast"] == pytest.approx(6000 * RPM, rel=ROUNDING)
    assert found.speeds["slow"] == pytest.approx(-2000 * RPM, rel=ROUNDING)


def test_an_internal_pair_turns_the_same_way():
    found = flow(PAIR + "internal = true\n", {"stage.pinion": 20, "stage.wheel": 60})
    assert found.speeds["slow"] == pytest.approx(2000 * RPM, rel=ROUNDING)


@pytest.mark.parametrize(
    ("members", "ratio"),
    [
        (("a", "ground", "b"), 1 + 78 / 30),
        (("a", "b", "ground"), -78 / 30),
        (("ground", "a", "b"), 1 + 30 / 78),
        (("b", "ground", "a"), 1 / (1 + 78 / 30)),
        (("b", "a", "ground"), -30 / 78),
    ],
)
def test_willis_gives_the_ratio_of_every_grounded_member(members, ratio):
    """Willis 1841: (ω_s − ω_c)/(ω_r − ω_c) = −z_r/z_s, solved for one member at rest."""
    found = flow(planetary(*members), TEETH)
    assert found.speeds["a"] / found.speeds["b"] == pytest.approx(ratio, rel=ROUNDING)


def test_planets_turn_as_the_sun_drives_them():
    """ω_p − ω_c = −(z_s/z_p)(ω_s − ω_c)."""
    speeds = flow(planetary("a", "ground", "b"), TEETH).speeds
    carrier = speeds["b"]
    assert speeds["set.planet"] - carrier == pytest.approx(-30 / 24 * (speeds["a"] - carrier), rel=ROUNDING)


def test_a_differential_adds_two_given_speeds():
    """(1 + i) ω_c = ω_s + i ω_r with i = z_r/z_s; the motor balances as the third member."""
    motor = '[motors.electric]\nshaft = "c"\npower_kw = 50\nspeed_rpm = 1000\nbalances = true\n'
    found = flow(planetary("a", "c", "b", motor=motor), TEETH)
    assert found.speeds["c"] == pytest.approx(1000 * RPM, rel=ROUNDING)
    assert 3.6 * found.speeds["b"] == pytest.approx(found.speeds["a"] + 2.6 * found.speeds["c"], rel=ROUNDING)
    assert found.machine_torques["electric"] == pytest.approx(2.6 * found.machine_torques["turbine"], rel=ROUNDING)
    assert found.residual < ROUNDING


def test_parallel_layshafts_turn_and_share_alike():
    """Power parts into halves; a row's torque is that of both halves of the double-helical gear."""
    found = flow(LAYSHAFTS, {"first.pinion": 15, "first.wheel": 61, "second.pinion": 15, "second.wheel": 61})
    for side in ("left", "right"):
        assert found.speeds[side] == pytest.approx(-20000 * RPM * 15 / 61, rel=ROUNDING)
    torque = found.machine_torques["turbine"]
    for side in ("left", "right"):
        assert found.meshes[f"first.{side}"].torques[0] == pytest.approx(-torque / 2, rel=ROUNDING)


def test_a_stated_share_holds():
    text = changed(LAYSHAFTS, "halves = 2", "halves = 2\nshare = [0.6, 0.4]")
    found = flow(text, {"first.pinion": 15, "first.wheel": 61, "second.pinion": 15, "second.wheel": 61})
    torque = found.machine_torques["turbine"]
    assert found.meshes["first.left"].torques[0] == pytest.approx(-0.6 * torque, rel=ROUNDING)
    assert found.meshes["second.left"].torques[0] / found.meshes["second.right"].torques[0] == pytest.approx(
        1.5, rel=1e-9
    )
    assert found.residual < ROUNDING


def test_a_machine_that_cannot_have_its_speed_yields_and_says_so():
    found = flow(PAIR, {"stage.pinion": 18, "stage.wheel": 53})
    (yielded,) = found.yielded
    assert yielded.machine == "propeller"
    assert yielded.deviation == pytest.approx(54 / 53 - 1, rel=1e-9)


def test_the_kept_speed_is_the_users_choice():
    found = flow(PAIR + '[speeds]\nkeep = ["propeller"]\n', {"stage.pinion": 18, "stage.wheel": 53})
    assert found.speeds["slow"] == pytest.approx(2000 * RPM, rel=ROUNDING)
    assert found.yielded[0].machine == "turbine"


def test_a_case_may_state_a_speed():
    text = PAIR + "[cases.idle.propeller]\nspeed_rpm = 1000\n[cases.idle.turbine]\npower_kw = 20\n"
    found = flow(text, {"stage.pinion": 20, "stage.wheel": 60}, "idle")
    assert abs(found.speeds["fast"]) == pytest.approx(3000 * RPM, rel=ROUNDING)
    assert found.machine_powers["propeller"] == pytest.approx(-20e3, rel=ROUNDING)


def refusal(text: str, teeth: dict[str, float]) -> str:
    with pytest.raises(DesignError) as caught:
        flow(text, teeth)
    (problem,) = caught.value.problems
    return str(problem)


def test_a_loop_of_shafts_with_no_solution_is_named():
    """Three external meshes in a triangle lock, whatever their teeth."""
    text = changed(PAIR, '"slow"]', '"slow", "third"]')
    text += '[pairs.two]\npinion = "slow"\nwheel = "third"\n[pairs.three]\npinion = "third"\nwheel = "fast"\n'
    message = refusal(text, {f"{p}.{s}": 30 for p in ("stage", "two", "three") for s in ("pinion", "wheel")})
    assert message.startswith("shafts.fast: turbine cannot turn it: the train locks it.")
    assert "stage, two, three" in message


def test_two_pairs_that_contradict_each_other_are_named():
    text = PAIR + '[pairs.twin]\npinion = "fast"\nwheel = "slow"\n'
    agree = {"stage.pinion": 20, "stage.wheel": 60, "twin.pinion": 21, "twin.wheel": 63}
    assert flow(text, agree).residual < ROUNDING
    message = refusal(text, agree | {"twin.wheel": 64})
    assert "Their teeth contradict each other around: stage, twin" in message


def test_a_train_with_a_speed_too_few_names_its_loose_shafts():
    text = changed(planetary("a", "c", "b"), '["a", "b"]', '["a", "b", "c"]')
    text = (
        changed(text, "speed_rpm = 2000", "speed_rpm = 2000") + "[cases.half.turbine]\npower_kw = 1\nspeed_rpm = 6000\n"
    )
    design = parse(text)
    with pytest.raises(
        DesignError, match=r"the speeds of b, c are not determined: the train has 2 free speeds"
    ) as caught:
        power_flow(design, build_train(design), TEETH, "half")
    assert caught.value.problems[0].path == "shafts"


def test_a_planetary_set_with_three_free_members_is_named():
    """Turbine and propeller fix all speeds, but nothing holds the ring."""
    text = changed(planetary("a", "c", "b"), '["a", "b"]', '["a", "b", "c"]')
    message = refusal(text, TEETH)
    assert message.startswith("cases.rated: no torques balance: propeller is free to balance")
    assert "All three members of set turn: ground one, or put a machine that balances on each" in message


def test_power_without_a_path_is_refused():
    text = changed(PAIR, 'pinion = "fast"', 'pinion = "middle"').replace('"slow"]', '"slow", "middle"]')
    text += '[clutches.sprag]\ndriving = "middle"\ndriven = "fast"\n'
    message = refusal(text, {"stage.pinion": 20, "stage.wheel": 60})
    assert "no torques balance" in message
    assert "engage a clutch" in message
