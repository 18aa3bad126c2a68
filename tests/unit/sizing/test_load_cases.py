"""Load cases as they are said: who takes what, how long, what is static, what is engaged, and what is refused."""

from __future__ import annotations

import pytest

from designs import BRAKED, HYBRID, PAIR, changed, problem
from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.sizing import size
from gearwright.spec import parse, parse_mission
from gearwright.train import PowerFlow, Turning, build_train, power_flow

CLOSURE = 1e-12
"""Part of the power that rounding may leave."""
TWO = """\
schema = 1
name = "two consumers"
level = "concept"
shafts = ["in", "a", "b"]
[turbines.t]
shaft = "in"
power_kw = 1000
speed_rpm = 6000
[rotors.main]
shaft = "a"
speed_rpm = 2000
diameter_m = 4
[rotors.tail]
shaft = "b"
speed_rpm = 500
diameter_m = 10
[pairs.one]
pinion = "in"
wheel = "a"
[pairs.two]
pinion = "in"
wheel = "b"
"""
RATED = PAIR + 'pinion_teeth = 30\nwheel_teeth = 90\n[gears]\nrating = "iso6336"\n'


def test_two_consumers_without_a_demand_are_refused_by_name():
    found = problem(TWO, sized=True)
    assert found.path == "cases.rated"
    assert found.message.startswith("main and tail both balance one branch, and nothing says how they divide its power")
    assert "[cases.take-off.tail] power_kw = -100" in found.message


def test_a_demand_of_one_consumer_makes_the_other_exact():
    flow = size(parse(TWO + "[cases.hover.t]\nrating = 1\n[cases.hover.tail]\npower_kw = -400\n")).flows["hover"]
    assert flow.machine_powers["main"] == pytest.approx(-600e3, rel=CLOSURE)
    assert flow.residual < CLOSURE


def test_a_torque_says_as_much_as_a_power():
    flow = size(parse(TWO + "[cases.hover.t]\nrating = 1\n[cases.hover.tail]\ntorque_nm = -5000\n")).flows["hover"]
    assert flow.machine_powers["tail"] == pytest.approx(-5000.0 * abs(flow.speeds["b"]), rel=CLOSURE)


@pytest.mark.parametrize("machine", ["generators", "loads"])
def test_generators_and_loads_take_what_is_left(machine):
    rating = "power_kw = 120\nspeed_rpm = 2000\n" if machine == "generators" else "speed_rpm = 2000\n"
    start, end = PAIR.index("[propellers"), PAIR.index("[pairs")
    sizing = size(parse(f'{PAIR[:start]}[{machine}.taker]\nshaft = "slow"\n{rating}\n{PAIR[end:]}'))
    assert sizing.flows["rated"].machine_powers["taker"] == pytest.approx(-100e3, rel=CLOSURE)


def test_a_motor_may_take_power_and_balance():
    text = HYBRID + "[cases.charge]\nshare = 0\n[cases.charge.turbine]\npower_kw = 1046\n"
    text += "[cases.charge.electric]\nbalances = true\n[cases.charge.propeller]\npower_kw = -800\n"
    assert size(parse(text)).flows["charge"].machine_powers["electric"] == pytest.approx(-246e3, rel=CLOSURE)


def test_two_machines_that_balance_one_branch_are_refused():
    text = HYBRID + "[cases.charge]\nshare = 0\n[cases.charge.electric]\nbalances = true\n"
    assert "both balance one branch" in problem(text, sized=True).message


def test_an_accessory_takes_its_power_and_turns_no_faster_than_it_may():
    pump = '[accessories.pump]\nshaft = "slow"\npower_kw = 2\n'
    assert size(parse(PAIR + pump)).flows["rated"].machine_powers["propeller"] == pytest.approx(-98e3, rel=CLOSURE)
    found = problem(PAIR + pump + "speed_rpm = 1500\n", sized=True)
    assert found.path == "accessories.pump.speed"
    assert "in case rated, and 1500 rpm is its limit" in found.message


def test_a_machine_on_the_ground_is_refused():
    found = problem(PAIR + '[loads.wheel]\nshaft = "ground"\npower_kw = 1\n')
    assert found.path == "loads.wheel.shaft"
    assert "stands still" in found.message


def test_a_case_beyond_a_machines_limit_is_refused_unless_the_limit_lasts_so_long():
    case = "[cases.climb]\nduration_min = 5\n[cases.climb.turbine]\npower_kw = 130\n"
    found = problem(PAIR + case, sized=True)
    assert found.path == "cases.climb.turbine.power"
    assert "130 kW in case climb, and 100 kW is its limit" in found.message
    limit = "speed_rpm = 6000\nlimits.take-off = { power_kw = 130, duration_min = 5 }\n"
    text = changed(PAIR, "speed_rpm = 6000\n", limit)
    assert size(parse(text + case)).rated_power == pytest.approx(130e3, rel=CLOSURE)
    assert "100 kW is its limit" in problem(text + case.replace("= 5\n", "= 6\n"), sized=True).message


def test_shares_that_do_not_sum_to_one_and_lives_without_durations_are_refused():
    cases = "[cases.a]\nshare = {}\nturbine.rating = 1\n[cases.b]\nshare = 0.5\nturbine.rating = 0.5\n"
    assert "the sum of their shares is 0.9" in problem(RATED + cases.format(0.4)).message
    bare = "[cases.a.turbine]\nrating = 1\n[cases.b.turbine]\nrating = 0.5\n"
    found = problem(RATED + bare)
    assert found.path == "cases"
    assert found.message.startswith("a, b: how long each lasts is not said, and lives are asked")
    assert size(parse(PAIR + bare)).flows.keys() == {"a", "b"}


def test_durations_are_shares_of_the_life():
    shares = "[cases.a]\nshare = 0.25\nturbine.rating = 1\n[cases.b]\nshare = 0.75\nturbine.rating = 0.5\n"
    durations = shares.replace("share = 0.25", "duration_min = 10").replace("share = 0.75", "duration_min = 30")
    one, other = (size(parse(RATED + text)).meshes[0].rating for text in (shares, durations))
    assert one.pitting == pytest.approx(other.pitting, rel=1e-12)


def test_a_limit_load_counts_no_cycles_and_asks_for_less_than_the_same_load_for_life():
    lasting = RATED + "[cases.a]\nshare = 1\nturbine.rating = 0.5\n"
    limit = "[cases.limit]\n{}\nturbine.torque_nm = 159\n"
    alone = size(parse(lasting))
    static = size(parse(lasting + limit.format("static = true")))
    always = size(parse(lasting.replace("share = 1", "share = 0") + limit.format("share = 1")))
    assert alone.gear_mass <= static.gear_mass < always.gear_mass
    assert "counts no cycles" in problem(lasting + limit.format("static = true\nshare = 0.1")).message


def test_teeth_that_drive_in_one_case_and_are_driven_in_another_bend_both_ways():
    """Y_M = 0.7, as of idlers (ISO 6336-3, annex B)."""
    motors = '[motors.starter]\nshaft = "fast"\npower_kw = 100\nspeed_rpm = 6000\n'
    text = PAIR[: PAIR.index("[turbines")] + motors + PAIR[PAIR.index("[propellers") :] + RATED[len(PAIR) :]
    drive = "[cases.drive]\nshare = 0.5\nstarter.power_kw = 100\n"
    back = drive + "[cases.back]\nshare = 0.5\nstarter.power_kw = {}\n"
    for power, mean in ((50, 1.0), (-50, 0.7)):
        rating = size(parse(text + back.format(power))).meshes[0].rating
        assert [root.mean_stress for root in rating.factors.root_strength] == [mean, mean]


def test_a_hybrid_takes_off_on_the_turbine_alone():
    """2051 kW by the turbine, 1005 kW by the motor, never both: what sizes is the larger, not the sum."""
    text = HYBRID[: HYBRID.index("[cases")].replace("power_kw = 1046", "power_kw = 2051")
    text += "[cases.turbine-alone.turbine]\nrating = 1\n[cases.motor-alone.electric]\nrating = 1\n"
    text += "[cases.both.turbine]\npower_kw = 1046\n[cases.both.electric]\nrating = 1\n"
    sizing = size(parse(text))
    assert sizing.rated_power == pytest.approx(2051e3, rel=CLOSURE)
    assert all(flow.residual < CLOSURE for flow in sizing.flows.values())
    mission = 'schema = 1\nname = "take-off"\npropeller_map = "none"\n[phases.take-off]\nmode = "conventional"\n'
    mission += "duration_s = 60\naltitude_m = 0\nmach = 0.1\npropeller_speed_rpm = 1212\npower_kw = 2000\n"
    flight = fly(sizing, parse_mission(mission))
    # 1e-5: the drag of the bearings is that of the loads one round before.
    assert flight.machines["turbine"].power.max() == pytest.approx(2000e3, rel=1e-5)


def gear(engaged: str) -> str:
    return f"[cases.gear]\nengaged = {engaged}\nm.rating = 1\n"


def in_gear(engaged: str) -> PowerFlow:
    design, teeth = parse(BRAKED + gear(engaged)), {"set.sun": 33, "set.planet": 18, "set.ring": 69}
    train = build_train(design)
    return power_flow(design, train, teeth, "gear", turning=Turning(design, train, teeth))


@pytest.mark.parametrize(("engaged", "ratio"), [('["brake"]', 1.0 + 69.0 / 33.0), ('["lock"]', 1.0)])
def test_brakes_and_clutches_that_a_case_engages_choose_the_ratio(engaged, ratio):
    flow = in_gear(engaged)
    assert flow.speeds["in"] / flow.speeds["out"] == pytest.approx(ratio, rel=1e-12)
    assert flow.machine_powers["wheel"] == pytest.approx(-100e3, rel=CLOSURE)


@pytest.mark.parametrize(("engaged", "words"), [("[]", "are not determined"), ('["brake", "lock"]', "cannot turn it")])
def test_free_and_locked_sets_are_refused_with_words(engaged, words):
    with pytest.raises(DesignError, match=words):
        in_gear(engaged)


def test_an_unknown_or_overrunning_clutch_is_not_engaged():
    assert "no clutch or brake 'brak'" in problem(BRAKED + gear('["brak"]')).message
    free = changed(BRAKED, 'driven = "ground"\nkind = "open"', 'driven = "ground"')
    assert "acts by itself" in problem(free + gear('["brake"]')).message
