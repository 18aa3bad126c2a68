"""Places along shafts, senses of helices, roots and the envelope, worked out by hand."""

import math

import numpy as np
import pytest
from shaft_designs import INTERNAL, OFF_SET, SINGLE_HELIX, SPUR

from designs import HYBRID, PAIR, changed
from gearwright.errors import DesignError
from gearwright.parts.bearings import LoadFactors
from gearwright.shipped import shipped_design
from gearwright.sizing import ShaftPlan, size
from gearwright.sizing.arrangement import axial_forces, envelope, helix_hand
from gearwright.sizing.gear_geometry import root_diameter
from gearwright.sizing.loads import rotor_side, shaft_loads
from gearwright.sizing.rating import context_of
from gearwright.spec import edited, parse, read
from gearwright.spec.design import BearingSeat
from mounted_designs import HELICOPTER


def sized(text):
    return size(parse(text))


def context(sizing):
    return context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)


def point_loads(sizing, shaft):
    """Return the point loads and the axial force on a shaft."""
    gears = {gear.name: gear for gear in sizing.gears}
    plan = sizing.arrangement.plans[shaft]
    return shaft_loads(context(sizing), shaft, plan, axes=sizing.arrangement.axes, gears=gears)


def test_gears_stand_side_by_side_with_equal_gaps_and_machines_at_the_ends():
    """Length: face widths and a bearing's length beside each; bearings in the middle of theirs."""
    sizing = sized(OFF_SET)
    rules = sizing.design.shafting
    widths = {gear.name: gear.face_width * 2 for gear in sizing.gears if gear.stage == "first"}
    widths |= {gear.name: gear.face_width for gear in sizing.gears if gear.stage == "second"}
    left = sizing.arrangement.plans["left"]
    first, second = widths["first.wheel"], widths["second.pinion"]
    gap = rules.bearing_length
    assert left.length == pytest.approx(first + second + 3 * gap)
    assert left.places["first.wheel"] == pytest.approx(gap + first / 2)
    assert left.places["second.pinion"] == pytest.approx(gap + first + gap + second / 2)
    assert left.bearings == (pytest.approx(gap / 2), pytest.approx(left.length - gap / 2))
    assert sizing.arrangement.plans["input"].places["turbine"] == 0.0
    assert sizing.arrangement.plans["output"].places["propeller"] == sizing.arrangement.plans["output"].length


def test_a_given_length_leaves_what_is_over_as_equal_gaps():
    sizing = sized(OFF_SET + "[layout.left]\nlength_mm = 400\n")
    width = {gear.name: gear.face_width * (2 if gear.stage == "first" else 1) for gear in sizing.gears}
    gap = (0.4 - width["first.wheel"] - width["second.pinion"]) / 3
    places = sizing.arrangement.plans["left"].places
    assert places["first.wheel"] == pytest.approx(gap + width["first.wheel"] / 2)
    assert places["second.pinion"] == pytest.approx(0.4 - gap - width["second.pinion"] / 2)


def test_bearings_of_a_short_shaft_stand_at_its_quarters():
    """A seat is as long as the rules say, or half of the shaft."""
    design = parse(HYBRID)
    for length in (0.03, 0.3):
        plan = size(edited(design, {"layout.middle.length_mm": 1e3 * length})).arrangement.plans["middle"]
        seat = min(design.shafting.bearing_length, length / 2) / 2
        assert plan.bearings == (pytest.approx(seat), pytest.approx(length - seat))


def test_what_gives_torque_only_stands_at_equal_distances():
    """Along x: the turbine, the first set, the motor between the sets, the second set, the propeller."""
    sizing = sized(HYBRID)
    rules, plans = sizing.design.shafting, sizing.arrangement.plans
    assert plans["input"].length == rules.end_length and plans["middle"].length == rules.middle_length
    assert dict(plans["input"].places) == {"turbine": 0.0, "first.sun": rules.end_length}
    middle = rules.middle_length
    assert list(plans["middle"].places.items()) == [
        ("first.carrier", 0.0), ("electric", middle / 2), ("second.sun", middle),
    ]  # fmt: skip
    assert list(plans["output"].places) == ["second.carrier", "propeller"]


def test_a_clutch_stands_at_the_end_on_its_side():
    text = changed(HYBRID, '"middle", "output"]', '"middle", "between", "output"]')
    text = changed(text, 'sun = "middle"', 'sun = "between"')
    text += '[clutches.joint]\ndriving = "middle"\ndriven = "between"\nkind = "engaged"\n'
    plans = sized(text).arrangement.plans
    assert list(plans["middle"].places)[-1] == "joint" and next(iter(plans["between"].places)) == "joint"


DRIVEN = (
    HELICOPTER[: HELICOPTER.index("[turbines.engine]")]
    + """[propellers.engine]
shaft = "input"
speed_rpm = 6000
diameter_m = 2
[turbines.rotor]
shaft = "mast"
power_kw = 322
speed_rpm = 598.6
"""
    + HELICOPTER[HELICOPTER.index("[pairs.helical]") :]
)
"""The same gears, driven from the mast: the bevel wheel drives its pinion."""


@pytest.mark.parametrize("apex", ["first", "second"])
@pytest.mark.parametrize("text", [HELICOPTER, DRIVEN])
def test_the_helix_beside_a_bevel_pinion_pushes_against_it(apex, text):
    """The spiral pushes the pinion away from its apex; the helical wheel on its shaft the other way, driven or driving:
    of 26 kN the helix takes its own 3 kN off."""
    sizing = sized(text.replace('wheel_apex = "first"', f'wheel_apex = "first"\npinion_apex = "{apex}"'))
    _, axial = point_loads(sizing, "middle")
    push = {mesh.stage: mesh.axial_force for mesh in sizing.meshes}
    assert push["helical"] > 1e3
    assert abs(axial[0]) == pytest.approx(abs(push["bevel"]) - push["helical"], rel=1e-6)
    assert (axial[0] > 0.0) == (apex == "first")


def test_a_helix_is_right_handed_where_its_shaft_turns_forwards():
    """Without a bevel pair: mating external gears turn opposite ways, and have opposite hands."""
    for text in (SINGLE_HELIX, INTERNAL, OFF_SET):
        sizing = sized(text)
        speeds = sizing.flows["rated"].speeds
        for shaft in sizing.design.shafts:
            hand = helix_hand(sizing.design, sizing.train, sizing.flows, shaft)
            assert hand == math.copysign(1.0, speeds[shaft])


def test_halves_of_a_gear_of_unlike_load_stand_where_they_should():
    """A double helix has its halves half a face width either side of its middle, the first one nearer to the end."""
    sizing = sized(OFF_SET)
    loads, _ = point_loads(sizing, "input")
    gear = next(gear for gear in sizing.gears if gear.name == "first.pinion")
    middle = sizing.arrangement.plans["input"].places[gear.name]
    positions = [place for place, force in zip(loads.position, loads.force[0, 0], strict=True) if force]
    assert positions[0] == pytest.approx(middle - gear.face_width / 2)
    assert positions[1] == pytest.approx(middle + gear.face_width / 2)


def test_torques_on_a_shaft_are_those_of_the_flow_and_add_up_to_nothing():
    for name in ("in-line-h2", "star", "mixed", "off-set"):
        sizing = size(read(shipped_design(name)))
        for shaft in sizing.design.shafts:
            loads, _ = point_loads(sizing, shaft)
            assert np.abs(loads.torque.sum(axis=-1)).max() <= 1e-9 * np.abs(loads.torque).max()
            assert np.abs(loads.torque).max() > 0.0


def test_root_circles_are_those_of_iso_21771_and_of_the_thin_end_of_a_cone():
    """d_f = d − 2 m (1.25 − x), of a wheel with − x; a bevel gear's ends at d_m − 2.5 m_mn cos δ − b sin δ."""
    text = changed(HELICOPTER, "helix_angle_deg = 12\n", "helix_angle_deg = 12\nprofile_shift = 0.2\n")
    sizing = sized(changed(text, "{ helix_angle_deg = 0 }", "{ helix_angle_deg = 0, profile_shift = 0 }"))
    gears, given = {gear.name: gear for gear in sizing.gears}, context(sizing)
    pinion, wheel = gears["helical.pinion"], gears["helical.wheel"]
    assert root_diameter(given, pinion) == pytest.approx(pinion.pitch_diameter - 2.1 * pinion.module)
    assert root_diameter(given, wheel) == pytest.approx(wheel.pitch_diameter - 2.9 * wheel.module)
    for name, slope in (("bevel.pinion", 17 / 43), ("bevel.wheel", 43 / 17)):
        gear, cone = gears[name], math.atan(slope)
        depth = 2.5 * gear.module * math.cos(cone)
        thin = gear.pitch_diameter - depth - gear.face_width * math.sin(cone)
        assert root_diameter(given, gear) == pytest.approx(thin)


def test_the_envelope_is_the_box_around_every_disc():
    """Tip circles d/2 + m_n around every axis, shafts beside them, and the longest axis."""
    sizing = sized(SPUR)
    place = {shaft.name: shaft.axis for shaft in sizing.shafts}
    discs = [(*shaft.axis, shaft.diameter / 2) for shaft in sizing.shafts]
    discs += [(*place[shaft], gear.pitch_diameter / 2 + gear.module) for gear in sizing.gears for shaft in gear.shafts]
    box = envelope(sizing)
    assert box.width == pytest.approx(max(y + r for y, _, r in discs) - min(y - r for y, _, r in discs))
    assert box.height == pytest.approx(max(z + r for _, z, r in discs) - min(z - r for _, z, r in discs))
    assert box.length == pytest.approx(max(shaft.length for shaft in sizing.shafts))


def test_a_thick_shaft_is_in_the_envelope_too():
    sizing = sized(PAIR + "[layout.fast]\ndiameter_mm = 900\n")
    place = next(shaft.axis for shaft in sizing.shafts if shaft.name == "fast")
    assert place == (0.0, 0.0)
    assert envelope(sizing).height == pytest.approx(0.9) and envelope(sizing).width >= 0.9


def test_sets_on_one_axis_are_as_long_as_their_shafts_and_faces():
    for name in ("in-line-h2", "star"):
        sizing = size(read(shipped_design(name)))
        faces = sum(gear.face_width for gear in sizing.gears if gear.role == "ring")
        assert envelope(sizing).length == pytest.approx(sum(shaft.length for shaft in sizing.shafts) + faces)
        radius = max(gear.pitch_diameter / 2 + gear.rim for gear in sizing.gears if gear.role == "ring")
        assert envelope(sizing).height == pytest.approx(2 * radius)


def test_a_rotor_looks_away_from_all_else_on_its_shaft():
    plan = ShaftPlan(1.0, (0.3, 0.5), {"rotor": 0.41, "gear": 0.45, "wheel": 0.35})
    assert rotor_side(plan, "rotor") == 1.0
    assert rotor_side(plan, "wheel") == -1.0
    assert rotor_side(ShaftPlan(1.0, (0.3, 0.5), {"rotor": 0.39, "gear": 0.45, "wheel": 0.35}), "rotor") == -1.0


def test_taper_bearings_take_the_outer_force_and_what_they_make_themselves():
    """F_a = F_r/(2 Y) each; the one that is pushed together bears the other's and the force along the shaft."""
    seats = {
        "a": BearingSeat(shaft="s", position=0.1, kind="taper", locates="first"),
        "b": BearingSeat(shaft="s", position=0.2, kind="taper", locates="second"),
    }
    axial = np.array([500.0, -500.0, 4000.0])
    radial = {"a": np.full(3, 3000.0), "b": np.full(3, 2000.0)}
    factors = {"a": LoadFactors(0.4, 0.4, 1.5), "b": LoadFactors(0.4, 0.4, 1.25)}
    forces = axial_forces("s", seats, axial, radial=radial, factors=factors, cases=("x", "y", "z"))
    assert forces["b"].tolist() == [1000.0 + 500.0, 800.0, 1000.0 + 4000.0]
    assert forces["a"].tolist() == [1000.0, 800.0 + 500.0, 1000.0]


def test_a_force_along_the_shaft_goes_to_the_bearing_that_locates_towards_it():
    seats = {
        "a": BearingSeat(shaft="s", position=0.1, kind="deep-groove", locates="first"),
        "b": BearingSeat(shaft="s", position=0.2, kind="deep-groove", locates="second"),
    }
    radial = {"a": np.array([100.0, 100.0]), "b": np.array([100.0, 100.0])}
    axial = np.array([30.0, -70.0])
    forces = axial_forces("s", seats, axial, radial=radial, factors={}, cases=("x", "y"))
    assert forces["a"].tolist() == [0.0, 70.0] and forces["b"].tolist() == [30.0, 0.0]
    floats = {name: seat.model_copy(update={"locates": "none"}) for name, seat in seats.items()}
    nothing = axial_forces("s", floats, 1e-12 * axial, radial=radial, factors={}, cases=("x", "y"))
    assert not nothing["a"].any() and not nothing["b"].any()
    with pytest.raises(DesignError, match=r'pushed towards its first end with 70 N in case y.*locates = "both" at a'):
        axial_forces("s", floats, axial, radial=radial, factors={}, cases=("x", "y"))
