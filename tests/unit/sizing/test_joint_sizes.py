"""Joints by hand: DIN 6885 keys under DIN 6892 pressure, DIN 5480 splines, Lamé's press fit, and what is too long."""

import math
from dataclasses import replace

import pytest

import gearwright as gw
from gearwright.catalogue import materials
from gearwright.errors import DesignError
from gearwright.render.drawings.shaft_view import shaft_body
from gearwright.sizing.rating import STANDARD_MODULES
from gearwright.sizing.shaft_results import hub_bore_of
from gearwright.sizing.shafts.sections import (
    JointSeat,
    joint_fits,
    keyway_depth,
    refuse_long,
    refuse_thick,
    size_joint,
    spline_root,
)
from gearwright.spec.design import Joint
from shipped_work import BY_HAND, sized, text_of

STEEL = materials()["carburised-9310"]
D = 0.050
"""Shaft [m]: key 14 x 9, t_1 = 5.5, t_2 = 3.8 mm."""
SEAT = JointSeat("stage.wheel", "output", 0.1, hub_length=0.07, root=0.11, torque=700.0, bore=0.02, tooth=0.0055)


def flank(torque, pressure):
    """Return the flat length of a key on the shaft D: T = p (d/2) (h − t_1) l."""
    return torque / (pressure * (D / 2.0) * 3.5e-3)


def test_a_key_is_the_next_standard_length_that_bears_with_its_round_ends():
    sized = size_joint(Joint(kind="key"), SEAT, D, STEEL)
    asked = flank(700.0, 150e6) + 0.014
    assert asked == pytest.approx(0.06733, abs=1e-5)
    assert sized.length == 0.070
    assert sized.pressure == pytest.approx(700.0 / (D / 2.0 * 3.5e-3 * 0.056))
    assert (sized.allowed_pressure, sized.torque, sized.diameter) == (150e6, 700.0, D)
    assert sized.designation == "DIN 6885 - A 14 x 9 x 70"


def test_a_key_of_form_b_bears_over_all_of_its_length_under_the_users_pressure():
    sized = size_joint(Joint(kind="key", form="B", pressure=175e6), SEAT, D, STEEL)
    assert flank(700.0, 175e6) == pytest.approx(0.04571, abs=1e-5)
    assert (sized.length, sized.designation, sized.allowed_pressure) == (0.050, "DIN 6885 - B 14 x 9 x 50", 175e6)
    assert size_joint(Joint(kind="key", length=0.063), SEAT, D, STEEL).length == 0.063


def test_a_key_is_never_shorter_than_the_standard_makes_it():
    assert size_joint(Joint(kind="key"), SEAT._replace(torque=1.0), D, STEEL).length == 0.036


def test_the_rim_is_what_root_circle_shaft_and_keyway_leave_over_the_tooth():
    root_to_shaft = (0.11 - D) / 2.0
    rim = {kind: size_joint(Joint(kind=kind), SEAT, D, STEEL).rim for kind in ("key", "spline", "press-fit")}
    assert rim["key"] == pytest.approx((root_to_shaft - 3.8e-3) / 0.0055)
    assert rim["spline"] == rim["press-fit"] == pytest.approx(root_to_shaft / 0.0055)
    assert keyway_depth(Joint(kind="key"), D) == pytest.approx(3.8e-3)
    machine = SEAT._replace(root=math.inf)
    assert size_joint(Joint(kind="key"), machine, D, STEEL).rim is None
    assert size_joint(Joint(kind="integral"), SEAT, D, STEEL).rim is None


def test_a_shaft_as_thick_as_the_root_circle_leaves_no_rim():
    thin = SEAT._replace(root=0.050)
    with pytest.raises(DesignError, match="leaves no rim: the root circle of the gear has 50 mm"):
        refuse_thick(size_joint(Joint(kind="spline"), thin, D, STEEL), thin)
    refuse_thick(size_joint(Joint(kind="spline"), SEAT, D, STEEL), SEAT)


def test_a_spline_has_about_25_teeth_and_whole_millimetres():
    """50 mm: module 2, z = 24 with d_B = m (z + 2 x + 1.1); p = 2 T/(d_m h l z k), d_m = d_B − 1.1 m, h = 0.9 m."""
    sized = size_joint(Joint(kind="spline"), SEAT, D, STEEL)
    per_length = 2.0 * 700.0 / ((0.050 - 1.1 * 0.002) * 0.9 * 0.002 * 24 * 0.75)
    asked = math.ceil(1e3 * per_length / 100e6) / 1e3
    assert sized.designation == "DIN 5480 - W 50 x 2 x 24"
    assert sized.length == pytest.approx(max(asked, 0.6 * 0.050))
    assert sized.pressure == pytest.approx(per_length / sized.length)
    assert sized.allowed_pressure == 100e6


def test_a_loaded_spline_is_as_long_as_its_torque_asks_and_a_light_one_as_long_as_keeps_it_from_rocking():
    heavy = size_joint(Joint(kind="spline"), SEAT._replace(torque=2500.0), D, STEEL)
    per_length = 2.0 * 2500.0 / ((0.050 - 1.1 * 0.002) * 0.9 * 0.002 * 24 * 0.75)
    assert heavy.length == pytest.approx(math.ceil(1e3 * per_length / 100e6) / 1e3)
    assert heavy.length > 0.6 * 0.050
    short = SEAT._replace(torque=50.0, hub_length=0.021)
    assert size_joint(Joint(kind="spline"), short, D, STEEL).length == pytest.approx(0.021)
    idle = size_joint(Joint(kind="spline"), SEAT._replace(torque=0.0, hub_length=0.0), D, STEEL)
    assert (idle.length, idle.pressure) == (0.0, 0.0)


def test_a_splines_module_is_the_users_where_it_is_given():
    sized = size_joint(Joint(kind="spline", module=0.003, length=0.04, pressure=80e6), SEAT, D, STEEL)
    assert sized.designation == "DIN 5480 - W 50 x 3 x 15"
    assert (sized.length, sized.allowed_pressure) == (0.04, 80e6)
    assert spline_root(Joint(kind="spline", module=0.003), D) == pytest.approx(0.050 - 2.3 * 0.003)
    assert spline_root(Joint(kind="spline"), D) == pytest.approx(0.050 - 2.3 * 0.002)


def test_a_press_fit_slips_at_its_safety_times_the_torque_and_bears_what_its_weaker_part_does():
    """Lamé: p = 2 S T/(π d² l μ); hub 2 p/(1 − Q_a²), hollow shaft 2 p/(1 − Q_i²) against R_p0.2."""
    joint = Joint(kind="press-fit", friction=0.15, safety=1.7)
    sized = size_joint(joint, SEAT, D, STEEL)
    pressure = 2.0 * 1.7 * 700.0 / (math.pi * D**2 * 0.07 * 0.15)
    inner, outer = 0.02 / D, D / 0.11
    worst = max(2.0 / (1.0 - outer**2), 2.0 / (1.0 - inner**2))
    e, nu = STEEL.elastic_modulus, STEEL.poisson_ratio
    give = (1.0 + outer**2) / (1.0 - outer**2) + nu + (1.0 + inner**2) / (1.0 - inner**2) - nu
    interference = pressure * D * give / e + 0.8 * 8e-6
    assert sized.pressure == pytest.approx(pressure)
    assert sized.allowed_pressure == pytest.approx(STEEL.yield_strength / worst)
    assert sized.interference == pytest.approx(interference)
    assert sized.length == 0.07
    assert sized.designation == f"DIN 7190 - 50 with {1e6 * interference:.0f} µm"


def test_a_press_fit_has_the_steel_of_its_gear_around_that_of_its_shaft():
    """Lamé with a hub of its own E, ν and R_p0.2: the interference of both, the pressure that the weaker one bears."""
    hub = replace(STEEL, elastic_modulus=110e9, poisson_ratio=0.34, yield_strength=400e6)
    sized = size_joint(Joint(kind="press-fit"), SEAT._replace(hub=hub), D, STEEL)
    inner, outer = 0.02 / D, D / 0.11
    of_hub = ((1.0 + outer**2) / (1.0 - outer**2) + 0.34) / 110e9
    of_shaft = ((1.0 + inner**2) / (1.0 - inner**2) - STEEL.poisson_ratio) / STEEL.elastic_modulus
    assert sized.interference == pytest.approx(sized.pressure * D * (of_hub + of_shaft) + 0.8 * 8e-6)
    assert sized.allowed_pressure == pytest.approx(400e6 / (2.0 / (1.0 - outer**2)))


def test_a_press_fit_of_a_machine_is_as_long_as_its_shaft_is_thick_in_a_hub_of_twice_its_diameter():
    machine = SEAT._replace(hub_length=math.inf, root=math.inf, bore=0.0)
    sized = size_joint(Joint(kind="press-fit"), machine, D, STEEL)
    assert sized.length == D
    assert sized.allowed_pressure == pytest.approx(STEEL.yield_strength / (2.0 / (1.0 - 0.25)))
    assert sized.pressure == pytest.approx(2.0 * 1.5 * 700.0 / (math.pi * D**2 * D * 0.12))


def test_only_splines_and_press_fits_of_free_length_gain_by_a_thicker_shaft():
    tight = SEAT._replace(torque=9000.0)
    free = size_joint(Joint(kind="spline"), tight, D, STEEL)
    assert free.length > tight.hub_length
    assert not joint_fits(Joint(kind="spline"), tight, free)
    assert joint_fits(Joint(kind="spline", length=0.05), tight, free)
    assert joint_fits(Joint(kind="key"), tight, free)
    assert not joint_fits(Joint(kind="press-fit"), tight, size_joint(Joint(kind="press-fit"), tight, D, STEEL))
    assert joint_fits(Joint(kind="spline"), SEAT, size_joint(Joint(kind="spline"), SEAT, D, STEEL))


@pytest.mark.parametrize(
    ("joint", "changes", "message"),
    [
        (Joint(kind="key", length=0.014), {}, "14 mm leaves no flat flank between round ends; give more than 14 mm"),
        (Joint(kind="key"), {"torque": 1100.0}, "ask for 100 mm of DIN 6885 - A 14 x 9 x 100, but its hub has 70 mm"),
        (
            Joint(kind="key"),
            {"torque": 1100.0, "hub_length": 0.2},
            "ask for 100 mm of DIN 6885 - A 14 x 9 x 100, but more than 79 mm does not bear on 50 mm",
        ),
        (
            Joint(kind="key", form="B"),
            {"torque": 1100.0, "hub_length": 0.2},
            "ask for 90 mm of DIN 6885 - B 14 x 9 x 90, but more than 65 mm does not bear on 50 mm",
        ),
        (Joint(kind="spline"), {"torque": 9000.0}, 'but its hub has 70 mm; write kind = "integral"'),
        (Joint(kind="key"), {"torque": 1100.0}, "a spline does with 30 mm, DIN 5480 - W 50 x 2 x 24"),
    ],
)
def test_what_is_too_long_is_told_with_what_would_do(joint, changes, message):
    seat = SEAT._replace(**changes)
    with pytest.raises(DesignError) as caught:
        refuse_long(joint, seat, size_joint(joint, seat, D, STEEL))
    assert message in str(caught.value)
    assert caught.value.problems[0].path.startswith("joints.stage.wheel")


def test_what_is_long_enough_is_not_refused():
    for kind in ("key", "spline", "press-fit", "integral"):
        refuse_long(Joint(kind=kind), SEAT, size_joint(Joint(kind=kind), SEAT, D, STEEL))


def test_modules_are_those_of_iso_54():
    """Series I, then series II without 6.5, of which the standard says to keep away."""
    first = (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50)
    second = (1.125, 1.375, 1.75, 2.25, 2.75, 3.5, 4.5, 5.5, 7, 9, 11, 14, 18, 22, 28, 36, 45)
    assert tuple(sorted((*first, *second))) == STANDARD_MODULES


def test_a_press_fit_is_made_so_tight_that_it_holds_at_speed():
    """What turning takes, ρ ω² d³/(16 E) (3 + ν)(1/Q_a² − Q_i²), is added to the interference; the rest needs p."""
    seat, joint = SEAT._replace(speed=1500.0), Joint(kind="press-fit", friction=0.15, safety=1.7)
    still, turning = (size_joint(joint, where, D, STEEL) for where in (SEAT, seat))
    inner, outer = 0.02 / D, D / 0.11
    taken = STEEL.density * 1500.0**2 * D**3 / (16.0 * STEEL.elastic_modulus)
    taken *= (3.0 + STEEL.poisson_ratio) * (1.0 / outer**2 - inner**2)
    assert turning.interference - still.interference == pytest.approx(taken)
    assert turning.running_pressure == pytest.approx(turning.needed_pressure) == pytest.approx(still.pressure)
    assert turning.pressure > still.pressure == pytest.approx(still.running_pressure)


def test_an_interference_of_the_users_may_be_too_small_at_speed():
    seat = SEAT._replace(speed=1000.0)
    joint = Joint(kind="press-fit", friction=0.15, safety=1.7, interference=size_joint(
        Joint(kind="press-fit", friction=0.15, safety=1.7), SEAT, D, STEEL).interference)  # fmt: skip
    sized = size_joint(joint, seat, D, STEEL)
    assert 0.0 < sized.running_pressure < sized.needed_pressure <= sized.pressure * (1.0 + 1e-9)
    loose = size_joint(joint, SEAT._replace(speed=20e3), D, STEEL)
    assert loose.running_pressure == 0.0


def outside(shaft, seat):
    """Return the thickest diameter over which what sits on a seat is slid on, from the side where that is less [m]."""
    place = next(step for step in shaft.steps if step.seat == seat)
    sides = (
        [step.diameter for step in shaft.steps if step.end <= place.start],
        [step.diameter for step in shaft.steps if step.start >= place.end],
    )
    return min(max(side, default=0.0) for side in sides)


def test_hubs_of_splines_pass_with_their_teeth_over_what_is_further_out():
    """W 70 x 2.5: d_B − 2 m = 65 mm over the bearings' seats of 65 mm; the mast beyond its rotor is turned to 66 mm."""
    sizing = sized(BY_HAND)
    shafts = {shaft.name: shaft for shaft in sizing.built_shafts}
    splined = [joint for joint in sizing.joints if joint.kind == "spline"]
    assert len(splined) == 5
    for joint in splined:
        assert hub_bore_of(joint) == pytest.approx(joint.diameter - 2.0 * joint.module)
        assert hub_bore_of(joint) >= outside(shafts[joint.shaft], joint.part) - 1e-9, joint.part
    (wheel,) = (joint for joint in splined if joint.part == "helical.wheel")
    assert (wheel.designation, outside(shafts["intermediate"], "helical.wheel")) == (
        "DIN 5480 - W 70 x 2.5 x 26",
        0.065,
    )
    assert [shafts["mast"].steps[-1].diameter, shafts["mast"].steps[-2].seat] == [0.066, "main-rotor"]


def test_a_spline_that_does_not_pass_over_the_seats_outside_it_is_refused_with_one_that_does():
    text = text_of(BY_HAND)
    given = '"helical.wheel" = { kind = "spline", diameter_mm = 66 }'
    with pytest.raises(DesignError, match=r"teeth that leave 61 mm in a seat of 66 mm .* over 65 mm .* give it 70 mm"):
        gw.size(gw.parse(text.replace('"helical.wheel".kind = "spline"', given)))


def test_splines_are_cut_on_to_the_end_of_their_seat_from_which_the_hub_comes():
    """12 mm of the tail drive's hub of 30 mm bear, about 175 mm; its teeth go on to the end of the shaft at 190 mm."""
    sizing = sized(BY_HAND)
    (teeth,) = shaft_body(sizing, "tail").splines
    assert (teeth.start, teeth.end) == pytest.approx((169.0, 190.0))
    (wheel,) = shaft_body(sizing, "intermediate").splines
    assert wheel.start == pytest.approx(92.0 - 36.0 / 2.0) and wheel.end == pytest.approx(92.0 + 36.0 / 2.0)
