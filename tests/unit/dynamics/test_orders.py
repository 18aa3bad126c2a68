"""Orders of machines, teeth and planets: how often, why, what they shake, and what is left out and told."""

import math

import pytest

from gearwright.dynamics import Model, campbell
from gearwright.dynamics.assembly import assumptions
from gearwright.dynamics.vibration import SEPARATION, SWING, critical_speeds
from gearwright.errors import DesignError
from gearwright.reviews import review
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.store import read_orders, written_orders

TEXT = shipped_design("in-line-h2").read_text(encoding="utf-8")


def sized(more=""):
    return size(parse(TEXT.replace("[motors.electric]", f"[motors.electric]\n{more}")))


SIZING = sized("poles = 10\nslots = 12")
FOUND = critical_speeds(SIZING)[0]
ORDERS = {str(order): order.frequency for order in FOUND.campbell.orders}


def turns(shaft):
    return abs(SIZING.flows["rated"].speeds[shaft]) / (2.0 * math.pi)


def test_blades_poles_and_slots_pass_so_often_in_a_turn():
    propeller, motor = SIZING.design.propellers["propeller"], SIZING.design.motors["electric"]
    expected = {
        "propeller 1P": turns(propeller.shaft),
        "propeller blade pass": 6 * turns(propeller.shaft),
        "propeller twice blade pass": 12 * turns(propeller.shaft),
        "gas-turbine 1P": turns("input"),
        "electric electrical": 5 * turns(motor.shaft),
        "electric twice electrical": 10 * turns(motor.shaft),
        "electric six times electrical": 30 * turns(motor.shaft),
        "electric slots": 12 * turns(motor.shaft),
        "electric cogging": 60 * turns(motor.shaft),
    }
    assert {name: ORDERS[name] for name in expected} == pytest.approx(expected, rel=1e-12)


def test_the_same_teeth_meet_and_planets_pass_as_counting_says():
    """54 and 66 teeth meet anew every lcm = 594 teeth; three pass the fixed ring in a turn of the cage."""
    mesh = 54 * (turns("input") - turns("intermediate"))
    assert ORDERS["first.sun-planet hunting tooth"] == pytest.approx(mesh / 594, rel=1e-12)
    assert ORDERS["first planet pass"] == pytest.approx(3 * turns("intermediate"), rel=1e-12)
    apart = ORDERS["first mesh plus planet pass"] - ORDERS["first mesh less planet pass"]
    assert apart == pytest.approx(6 * turns("intermediate"), rel=1e-9)


def test_an_order_of_a_machine_shakes_as_hard_as_its_assumed_swing():
    """Blade pass and its double shake one body by one torque, so their resonances with one mode are as hard."""
    worst = max(critical.dynamic_force for critical in FOUND.assumed if critical.order == "propeller blade pass")
    again = max(critical.dynamic_force for critical in FOUND.assumed if critical.order == "propeller twice blade pass")
    assert worst == pytest.approx(again, rel=1e-6)
    assert worst > SWING


def test_orders_of_machines_do_not_mix_with_those_whose_strength_is_stated():
    assert not any(critical.why for critical in FOUND.critical)
    assert all(critical.why for critical in FOUND.assumed)
    near = [row for row in FOUND.assumed if row.criterion and abs(row.separation_margin) < SEPARATION.limit]
    assert all(row.in_resonance for row in near)
    assert sum(row.in_resonance for row in FOUND.assumed) == len(near)


def test_a_review_lists_the_crossing_of_each_excited_order():
    modes = {check.mode: check for check in review(SIZING.design).checks}
    assert modes["resonance of propeller blade pass"].clause == "API 617: 10 %"
    assert "electrical and slot orders" not in modes


def test_a_motor_without_poles_and_slots_has_no_such_orders_and_is_told_of():
    plain = sized()
    found = critical_speeds(plain)[0]
    assert not any("electrical" in str(order) or "slots" in str(order) for order in found.campbell.orders)
    told = {row.subject: row.value for row in assumptions(plain, found.system)}
    assert told["orders of electric"] == "none of the electric kind: give poles and slots of electric"
    assert any(check.mode == "electrical and slot orders" for check in review(plain.design).checks)


@pytest.mark.parametrize(
    ("keys", "message"),
    [("poles = 7", "7 is odd; poles come in pairs"), ("poles = 0", "poles"), ("slots = 2.5", "slots")],
)
def test_impossible_poles_and_slots_are_refused(keys, message):
    with pytest.raises(DesignError, match=message):
        sized(keys)


def test_blades_of_a_turbine_are_refused_as_no_key_of_it():
    with pytest.raises(DesignError, match="blades"):
        parse(TEXT.replace("[turbines.gas-turbine]", "[turbines.gas-turbine]\nblades = 4"))


def test_an_order_written_by_hand_is_a_ray_of_the_diagram():
    model = Model()
    model.rotation("engine", inertia=1.0, speed=100.0)
    model.rotation("propeller", inertia=3.0)
    model.shaft("shaft", "engine", "propeller", stiffness=2e5, damping=1.0)
    model.order("blade pass", {"propeller": 4}, on=["propeller"], why="4 blades")
    diagram = campbell(model.build())
    crossing = next(crossing for crossing in diagram.crossings if str(crossing.order) == "blade pass")
    assert crossing.frequency == pytest.approx(math.sqrt(2e5 * (1.0 + 1.0 / 3.0)) / (2.0 * math.pi), rel=1e-3)
    assert crossing.factor == pytest.approx(crossing.frequency * 2.0 * math.pi / 400.0, rel=1e-12)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"turns": {"propelle": 4}}, "no such rotation: propelle; did you mean propeller"),
        ({"turns": {}}, "say how often it acts in a turn"),
        ({"turns": {"propeller": math.nan}}, "say how often it acts in a turn"),
        ({"turns": {"propeller": 4}, "on": ["shaf"]}, "it shakes shaf, which is no coordinate and no line"),
    ],
)
def test_an_order_of_nothing_is_refused(given, message):
    model = Model()
    model.rotation("engine", inertia=1.0, speed=100.0)
    model.rotation("propeller", inertia=3.0)
    model.shaft("shaft", "engine", "propeller", stiffness=3e5)
    model.order("blade pass", **given)
    with pytest.raises(DesignError, match=message):
        model.build()


def test_orders_survive_being_stored():
    labels = FOUND.system.labels
    assert read_orders(written_orders(labels.orders)) == labels.orders
    assert read_orders("") == ()
