"""Profile shifts reach everything that is computed from the teeth."""

from __future__ import annotations

import dataclasses
import math

import pytest

from designs import PAIR
from gearwright.dynamics.assembly import gear_pairs
from gearwright.errors import DesignError
from gearwright.mission import Oil, gearbox_of
from gearwright.parts.gears import BasicRack, CylindricalGear, tip_thickness
from gearwright.shape.stands import cylindrical_gear
from gearwright.sizing import Sizing, size
from gearwright.spec import parse
from gearwright.spec.design.teeth.profile_shifts import Keys, impossible_teeth

TEETH = "pinion_teeth = 18\nwheel_teeth = 54\n"


def shifted(shift: float) -> Sizing:
    return size(parse(f"{PAIR}{TEETH}\n[gears]\nhelix_angle_deg = 0\nprofile_shift = {shift}\n"))


@pytest.mark.parametrize(("shift", "factor"), [(0.0, 0.1670), (0.4, 0.1769)])
def test_losses_in_flight_know_the_shift(shift, factor):
    """H_V of 18/54 by hand: see the validation of losses."""
    box = gearbox_of(shifted(shift), "propeller", Oil(353.15, 4e-7, {}))
    assert box.teeth.contacts[0].loss_factor == pytest.approx(factor, abs=5e-5)


def test_stiffness_and_contact_ratio_of_the_dynamics_know_the_shift():
    """By hand: ε_α = 1.648770 without a shift and 1.559706 with 0.4."""
    plain, cut = (gear_pairs(shifted(shift))["stage"] for shift in (0.0, 0.4))
    assert (cut.driver.profile_shift, cut.driven.profile_shift) == (0.4, -0.4)
    assert plain.transverse_contact_ratio == pytest.approx(1.648770, abs=3e-5)
    assert cut.transverse_contact_ratio == pytest.approx(1.559706, abs=3e-5)


def test_shifts_of_both_gears_add_up_to_nothing():
    """x_1 + x_2 = 0 keeps the centre distance."""
    sizing = shifted(0.3)
    shifts = [gear.profile_shift for gear in sizing.gears]
    assert sorted(shifts) == [-0.3, 0.3]
    assert [cylindrical_gear(sizing, gear).profile_shift for gear in sizing.gears] == shifts


def test_lewis_and_hertz_stand_at_the_working_circles():
    """By hand: F_t = 2 T/d_w, and 0.418 √(F_t E Σ(1/r_w)/(b cos α_w sin α_w)) of a spur pair at a given distance."""
    keys = f"{TEETH}module_mm = 4\nface_width_mm = 40\ncentre_distance_mm = 146\n"
    sizing = size(parse(f"{PAIR}{keys}\n[gears]\nhelix_angle_deg = 0\n"))
    mesh, torque = sizing.meshes[0], 1e5 / (6000.0 * math.pi / 30.0)
    radii = (0.146 * 18.0 / 72.0, 0.146 * 54.0 / 72.0)
    angle = math.acos(0.144 * math.cos(math.radians(20.0)) / 0.146)
    force = torque / radii[0]
    assert mesh.tangential_force == pytest.approx(force)
    assert mesh.rating.bending_stress == pytest.approx(force / (0.04 * 0.004 * mesh.rating.form_factor))
    modulus = sizing.design.material(sizing.design.rules("stage").material).elastic_modulus
    curvature = 1.0 / radii[0] + 1.0 / radii[1]
    hertz = 0.418 * math.sqrt(force * modulus * curvature / (0.04 * math.cos(angle) * math.sin(angle)))
    assert mesh.rating.contact_stress == pytest.approx(hertz, rel=1e-9)


def test_the_wheel_of_an_internal_pair_is_a_ring():
    """By hand: m = ρ b π ((r + s)² − r²), J = m (r² + (r + s)²)/2, the wall s of rim_thickness_ratio modules."""
    keys = "internal = true\nmodule_mm = 4\nface_width_mm = 40\n"
    sizing = size(parse(f"{PAIR}{TEETH}{keys}\n[gears]\nhelix_angle_deg = 0\nweb_ratio = 0.5\n"))
    wheel, rules = sizing.gears[1], sizing.design.rules("stage")
    inner, wall = 0.108, 0.004 * rules.rim_thickness_ratio
    outer = inner + wall
    density = sizing.design.material(rules.material).density
    assert wheel.rim == pytest.approx(wall)
    assert wheel.mass == pytest.approx(density * 0.040 * math.pi * (outer**2 - inner**2))
    assert wheel.inertia == pytest.approx(wheel.mass * (inner**2 + outer**2) / 2.0)


def test_teeth_inside_are_neither_undercut_nor_pointed_as_teeth_outside_are():
    """40 teeth with x = 0.5 are 31 above their least, 56 with −0.5 would be 30 above theirs if they stood outside."""
    keys = "internal = true\nmodule_mm = 4\nface_width_mm = 40\npinion_teeth = 40\nwheel_teeth = 56\n"
    slower = PAIR.replace("speed_rpm = 2000", "speed_rpm = 4286")
    sizing = size(parse(f"{slower}{keys}\n[gears]\nhelix_angle_deg = 0\nprofile_shift = 0.5\n"))
    of = {mode: [check.part for check in sizing.checks if check.mode == mode] for mode in ("undercut", "tip thickness")}
    assert of == {"undercut": [sizing.gears[0].part], "tip thickness": [sizing.gears[0].part]}


def test_a_shifted_gear_weighs_what_its_mean_circle_holds():
    """By hand: x m_n outside of the pitch circle of a gear, and inside of that of a ring whose outside stays."""
    keys = "module_mm = 4\nface_width_mm = 40\ncentre_distance_mm = 148\npinion_shift = 0.5\n"
    sizing = size(parse(f"{PAIR}{TEETH}{keys}\n[gears]\nhelix_angle_deg = 0\n"))
    density = sizing.design.material(sizing.design.rules("stage").material).density
    for gear in sizing.gears:
        radius = 0.5 * gear.pitch_diameter + 0.004 * gear.profile_shift
        assert gear.mass == pytest.approx(density * 0.040 * math.pi * radius**2)
        assert gear.inertia == pytest.approx(0.5 * gear.mass * radius**2)
    ring = "internal = true\nmodule_mm = 4\nface_width_mm = 40\npinion_shift = 0.3\nwheel_shift = -0.3\n"
    wheel = size(parse(f"{PAIR}{TEETH}{ring}\n[gears]\nhelix_angle_deg = 0\n")).gears[1]
    inner, outer = 0.108 + 0.004 * 0.3, 0.108 + wheel.rim
    assert wheel.mass == pytest.approx(density * 0.040 * math.pi * (outer**2 - inner**2))


def test_the_search_knows_the_shift_that_is_given():
    """z_min = 2 (1 − x)/sin² 20° = 17.1, 12.0 and 23.9: a shift outwards lets fewer teeth in, one inwards asks more."""
    teeth = [
        size(parse(f"{PAIR}{shift}[gears]\nhelix_angle_deg = 0\n")).teeth["stage.pinion"]
        for shift in ("pinion_shift = 0.3\n", "", "pinion_shift = -0.4\n", "wheel_shift = 0.4\n")
    ]
    assert teeth[0] < teeth[1] < teeth[2] == teeth[3] == 24


def test_teeth_are_chosen_for_a_centre_distance_that_is_given():
    """By hand: 121 mm of module 3 are 40.33 modules, 79 teeth stand at 39.5; without it others are lighter."""
    keys = "module_mm = 3\ncentre_distance_mm = 121\n"
    sizing = size(parse(f"{PAIR}{keys}[gears]\nhelix_angle_deg = 0\n"))
    pinion, wheel = (sizing.teeth[f"stage.{side}"] for side in ("pinion", "wheel"))
    assert -0.4 <= 121.0 / 3.0 - 0.5 * (pinion + wheel) <= 0.9
    assert sizing.meshes[0].centre_distance == pytest.approx(0.121)


def test_a_centre_distance_that_no_teeth_of_the_search_reach_is_refused_with_it():
    with pytest.raises(DesignError, match=r"at a centre distance of 100 modules; change centre_distance or module"):
        size(parse(f"{PAIR}module_mm = 2\ncentre_distance_mm = 200\n[gears]\nhelix_angle_deg = 0\n"))


def test_a_shift_that_points_teeth_names_a_shift_or_teeth_that_do_not():
    """8 teeth of 30° at x = −2 have no tips, and no lesser shift is a shift; at x = 1.2 one is named to a hundredth."""
    gear = CylindricalGear(8, 1.0, 1.0, 0.0, -2.0, BasicRack(pressure_angle=math.radians(30.0)))
    keys = Keys("pairs.p.pinion_shift", "pinion_teeth", "pinion_tip_alteration")
    pointed, _ = impossible_teeth(keys, gear)
    assert pointed.message == "-2 points 8 teeth below the tip circle; give 14 teeth"
    (high,) = impossible_teeth(keys, dataclasses.replace(gear, profile_shift=1.2))
    least = float(high.message.partition("at most ")[2].partition(",")[0])
    assert tip_thickness(dataclasses.replace(gear, profile_shift=least)) > 0.0
    assert tip_thickness(dataclasses.replace(gear, profile_shift=least + 0.01)) <= 0.0
