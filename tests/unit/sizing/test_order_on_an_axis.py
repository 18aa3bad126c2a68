"""What stands on an axis: its order, which shaft goes through which, how long and how hollow shafts become."""

import math
from itertools import combinations

import pytest

import gearwright as gw
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.places import bells, runs

PLANETARY = """schema = 1
name = "A machine between two sets"
level = "concept"
shafts = ["input", "intermediate", "output"]
[turbines.turbine]
shaft = "input"
power_kw = 1000
speed_rpm = 20000
[motors.electric]
shaft = "intermediate"
power_kw = 400
speed_rpm = 4500
[propellers.propeller]
shaft = "output"
speed_rpm = 1212
diameter_m = 4
[planetaries.first]
sun = "input"
ring = "ground"
carrier = "intermediate"
planets = 3
[planetaries.second]
sun = "intermediate"
ring = "ground"
carrier = "output"
planets = 3
[gears]
rating = "lewis-hertz"
"""


def places(sizing, shaft):
    """Return what stands on a shaft, from its first end on."""
    found = sizing.arrangement.plans[shaft].places
    return sorted(found, key=found.__getitem__)


def failing(sizing, mode):
    """Return the failing checks of a mode."""
    return [check for check in sizing.checks if check.fails and check.mode.startswith(mode)]


def test_a_machine_on_the_shaft_between_two_sets_stands_between_them_and_adds_its_torque_there():
    """T = T_carrier left of the motor, T_carrier + T_motor right of it, by hand from powers and speeds."""
    sizing = size(gw.parse(PLANETARY))
    assert places(sizing, "intermediate") == ["first.carrier", "electric", "second.sun"]
    shaft = next(shaft for shaft in sizing.shafts if shaft.name == "intermediate")
    flow = sizing.flows[shaft.case]
    speed, motor = abs(flow.speeds["intermediate"]), abs(flow.machine_torques["electric"])
    carrier = abs(sum(flow.meshes[mesh].torques[2] for mesh in flow.meshes if mesh.startswith("first.")))
    at, drawn = sizing.arrangement.plans["intermediate"].places["electric"], shaft.diagram
    first = drawn.position.index(at)
    left, right = abs(drawn.torsion[first]), abs(drawn.torsion[first + 1])
    assert left == pytest.approx(carrier, rel=1e-9)
    assert right == pytest.approx(carrier + motor, rel=1e-9)
    assert motor == pytest.approx(400e3 / speed, rel=1e-9)
    assert not failing(sizing, "room beside")


def test_a_motor_wished_before_the_first_set_needs_a_hollow_shaft_around_the_sun_s():
    """The carrier's shaft then leaves the set on both sides, and the sun's goes through it."""
    text = PLANETARY + '[layout.intermediate]\norder = ["electric", "first.carrier", "second.sun"]\n'
    sizing = size(gw.parse(text))
    assert places(sizing, "intermediate")[0] == "electric"
    assert ("input", "intermediate") in sizing.arrangement.within
    shafts = {shaft.name: shaft for shaft in sizing.shafts}
    assert shafts["intermediate"].bore == pytest.approx(shafts["input"].diameter + 0.004, abs=1e-12)
    assert sizing.mass > size(gw.parse(PLANETARY)).mass
    assert not failing(sizing, "room beside")


def test_the_outer_of_two_propeller_shafts_is_hollow_around_the_inner_one_and_as_strong():
    """By hand: bore = d_inner + 2 × 2 mm; 16 T d / (π (d⁴ − bore⁴)) × 2 = R_p0.2 / S (Tresca)."""
    sizing = size(gw.read(shipped_design("contra-rotating-propellers")))
    shafts = {shaft.name: shaft for shaft in sizing.shafts}
    inner, outer = shafts["front"], shafts["rear"]
    assert sizing.arrangement.within == (("front", "rear"),)
    assert outer.bore == pytest.approx(inner.diameter + 0.004, abs=1e-12)
    shear = 16.0 * outer.torque * outer.diameter / (math.pi * (outer.diameter**4 - outer.bore**4))
    assert 2.0 * shear == pytest.approx(outer.stress, rel=1e-9)
    assert outer.margin >= 1.0 - 1e-9
    assert inner.length == pytest.approx(outer.length + 0.1, abs=1e-12)
    assert not failing(sizing, "room beside")


def test_the_gap_between_shafts_is_a_rule():
    text = shipped_design("contra-rotating-propellers").read_text() + "[shafting]\nradial_gap_mm = 6\n"
    shafts = {shaft.name: shaft for shaft in size(gw.parse(text)).shafts}
    assert shafts["rear"].bore == pytest.approx(shafts["front"].diameter + 0.012, abs=1e-12)


def test_a_bore_that_is_too_small_for_what_goes_through_it_fails_and_says_what_helps():
    text = shipped_design("contra-rotating-propellers").read_text() + "[layout.rear]\nbore_mm = 40\n"
    (check,) = failing(size(gw.parse(text)), "room beside")
    assert str(check.part) == "rear"
    assert "front goes through rear" in check.why
    assert "larger bore" in check.why


def test_every_shaft_of_a_ravigneaux_set_has_its_layer():
    """Large sun around the small one around the input; the carrier's shaft around all three, inside the output's."""
    sizing = size(gw.read(shipped_design("ravigneaux-automatic")))
    shafts = {shaft.name: shaft for shaft in sizing.shafts}
    for inner, outer in sizing.arrangement.within:
        assert shafts[outer].bore >= shafts[inner].diameter + 0.004 - 1e-12
    assert {("small-sun", "large-sun"), ("large-sun", "carrier"), ("carrier", "output")} <= {*sizing.arrangement.within}
    assert places(sizing, "large-sun") == ["back", "band", "gear.large"]
    assert not failing(sizing, "room beside")


def test_members_of_a_set_that_leave_it_on_one_side_lie_sun_carrier_ring():
    """All three machines on the first side: the sun's shaft within the carrier's, that within the ring's."""
    text = shipped_design("contra-rotating-propellers").read_text()
    for shaft, order in (
        ("input", ["gas-turbine", "differential.sun"]),
        ("front", ["front-propeller", "differential.carrier"]),
        ("rear", ["rear-propeller", "differential.ring"]),
    ):
        text += f"[layout.{shaft}]\norder = {order}\n".replace("'", '"')
    sizing = size(gw.parse(text))
    assert {("input", "front"), ("front", "rear"), ("input", "rear")} == {*sizing.arrangement.within}
    assert not failing(sizing, "room beside")


def test_a_wish_that_no_order_keeps_fails_with_an_order_that_would_do():
    """A load on the sun's shaft on both sides of the set is fine; two wishes that contradict each other are not."""
    text = PLANETARY + '[layout.intermediate]\norder = ["electric", "first.carrier", "second.sun"]\n'
    text += "[layout.intermediate.places]\nelectric = { position_mm = 60 }\n"
    text += '"first.carrier" = { position_mm = 0 }\n"second.sun" = { position_mm = 60 }\n'
    (check,) = failing(size(gw.parse(text)), "order along its axis")
    assert "turbine, first, electric, second, propeller" in check.why


def test_an_order_of_what_is_not_on_the_shaft_is_refused_with_the_nearest():
    with pytest.raises(gw.DesignError, match=r"layout\.intermediate\.order: 'electrc' .* electric"):
        size(gw.parse(PLANETARY + '[layout.intermediate]\norder = ["electrc"]\n'))


@pytest.mark.parametrize(
    "name",
    [
        "in-line-h2",
        "in-line-h2-star",
        "star",
        "contra-rotating-propellers",
        "differential-hybrid",
        "ravigneaux-automatic",
    ],
)
def test_shafts_and_the_bells_of_rings_are_drawn_outside_each_other(name):
    """On one axis, what two shafts take of it is side by side or one in the bore of the other."""
    sizing = size(gw.read(shipped_design(name)))
    taken = []
    for run in runs(sizing)[0]:
        frame = sizing.arrangement.frames[run.shaft]
        taken += [(run.shaft, frame, low, high, run.bore, radius) for low, high, radius in run.steps]
    radii = {shaft.name: shaft.diameter / 2.0 for shaft in sizing.shafts}
    for bell in bells(sizing):
        shaft = bell.ring.shafts[0]
        disc = (min(bell.disc), max(bell.disc), radii[shaft], bell.ring.pitch_diameter / 2.0)
        taken.append((shaft, sizing.arrangement.frames[shaft], *disc))
    for one, other in combinations(taken, 2):
        coaxial = math.hypot(one[1].origin.y - other[1].origin.y, one[1].origin.z - other[1].origin.z) < 1e-9
        ends = [(part[1].origin.x + part[2], part[1].origin.x + part[3]) for part in (one, other)]
        over = min(ends[0][1], ends[1][1]) - max(ends[0][0], ends[1][0])
        if coaxial and one[0] != other[0] and over > 1e-6:
            assert one[5] < other[4] or other[5] < one[4], (one[0], other[0])
