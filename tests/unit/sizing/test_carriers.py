"""Carriers: pins bear tooth forces and the planets' centrifugal force, and every check is in the margins."""

from __future__ import annotations

import math
from functools import cache

import pytest

from gearwright.checks import Status
from gearwright.parts.carriers import (
    Elastic,
    Frame,
    eye_wall,
    pin_diameter,
    pin_mass,
    plate_band,
    plate_lag,
    plate_mass,
)
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import complete_mass
from gearwright.spec import at_level, parse, read


@pytest.fixture(scope="module")
def sizing() -> Sizing:
    return size(read(shipped_design("in-line-h2")))


def test_a_planet_pulls_at_its_pin_with_its_centrifugal_force(sizing: Sizing) -> None:
    """m r ω² of the first stage's planets at 4500 rpm: 1.273 kg at 100.8 mm, 28.5 kN."""
    carrier, planet = sizing.carriers[0], next(gear for gear in sizing.gears if gear.name == "first.planet")
    speed = sizing.flows["rated"].speeds["intermediate"]
    assert carrier.centrifugal_force == pytest.approx(planet.mass * carrier.radius * speed**2, rel=1e-12)
    assert carrier.centrifugal_force == pytest.approx(28.5e3, rel=2e-3)
    assert carrier.pin_force == pytest.approx(math.hypot(carrier.tangential_force, carrier.centrifugal_force))


def test_pins_and_plate_bear_just_enough(sizing: Sizing) -> None:
    for carrier in sizing.carriers:
        assert carrier.pin_margin == pytest.approx(1.0, abs=1e-12)
        assert carrier.plate_margin is not None
        assert carrier.plate_margin >= 1.0 - 1e-12


def test_a_pin_that_is_given_too_thin_is_the_worst_margin() -> None:
    text = shipped_design("in-line-h2").read_text(encoding="utf-8")
    sizing = size(parse(text + '\n[overrides]\n"first.pin_diameter_mm" = 11.7\n'))
    assert sizing.worst_margin == pytest.approx((11.7e-3 / 18.58e-3) ** 3, rel=3e-3)


SHARED = ("in-line-h2", "star", "in-line-star", "hybrid-turboprop")
"""Whose first stages have room for a second plate, and planets for bridges."""


@cache
def shared(name: str) -> Sizing:
    """Return a shipped design against fatigue, where plates that bridges tie share the force of pins."""
    return size(at_level(read(shipped_design(name)), "preliminary"))


@pytest.mark.parametrize("name", SHARED)
def test_pins_between_two_plates_are_beams_on_two_supports(name: str) -> None:
    """The face b is loaded evenly, plates hold at L = b + t: M = F/4 (L − b/2), t of the free plate, at least b/8."""
    sizing = shared(name)
    carrier, planet = sizing.carriers[0], next(gear for gear in sizing.gears if gear.name == "first.planet")
    least, pin, bore = planet.face_width / 8.0, carrier.pin_diameter, carrier.pin_bore
    assert carrier.free_plate is not None and carrier.free_plate >= least and bore is not None
    moment = carrier.pin_force / 4.0 * (planet.face_width / 2.0 + carrier.free_plate)
    section = math.pi / 32.0 * pin**3 * (1.0 - (bore / pin) ** 4)
    assert carrier.pin_stress == pytest.approx(moment / section)
    assert carrier.pin_stress <= (sizing.design.shaft_material.yield_strength or 0.0) / 2.0 * (1.0 + 1e-9)


@pytest.mark.parametrize("name", SHARED)
def test_eyes_of_two_plates_bear_half_of_the_force_of_a_pin(name: str) -> None:
    sizing = shared(name)
    carrier = sizing.carriers[0]
    half, plate = carrier.pin_force / 2.0, carrier.free_plate
    assert plate is not None and plate <= carrier.plate_thickness
    assert carrier.hole_pressure == pytest.approx(half / (carrier.pin_diameter * plate))
    assert carrier.eye_stress == pytest.approx(half / (2.0 * plate * carrier.eye_wall))


@pytest.mark.parametrize("name", SHARED)
def test_two_plates_weigh_less_than_one_that_bears_all_and_another(name: str) -> None:
    """One plate of b/4 with pins of M = F b/2, each as the rules for a single plate have it, and its twin."""
    sizing = shared(name)
    carrier, planet = sizing.carriers[0], next(gear for gear in sizing.gears if gear.name == "first.planet")
    allowable, width = (sizing.design.shaft_material.yield_strength or 0.0) / 2.0, planet.face_width
    pin = max(pin_diameter(carrier.pin_force, width, allowable), carrier.pin_diameter)
    plate = max(0.25 * width, carrier.pin_force / (pin * allowable))
    wall = eye_wall(carrier.pin_force, plate, allowable / 2.0, needed=pin)
    density, fill = sizing.design.shaft_material.density, sizing.design.carriers.fill
    twin = 2.0 * plate_mass(carrier.radius + pin / 2.0 + wall, plate, density, fill=fill)
    apart = planet.bodies * pin_mass(pin, width, density)
    assert carrier.mass < twin + apart


def with_rules(rules: str, name: str = "in-line-h2") -> Sizing:
    """Return a design against fatigue with a line more in its rules of carriers."""
    text = shipped_design(name).read_text(encoding="utf-8") + f"\n[carriers]\n{rules}\n"
    return size(at_level(parse(text), "preliminary"))


def carriers_mass(sizing: Sizing) -> float:
    """Return the complete mass of carriers, bridges included [kg]."""
    return complete_mass(sizing).of("carriers")


@pytest.mark.parametrize("name", SHARED)
def test_carriers_keep_planets_straight_to_half_of_the_helix_slope_tolerance(name: str) -> None:
    """Half of f_Hβ = (0.05 √d + 0.35 √b + 4) √2^(A − 5) µm, d and b in mm; class A 4 above 60 m/s, 5 from 15 m/s on."""
    sizing = shared(name)
    for carrier in sizing.carriers:
        planet = next(gear for gear in sizing.gears if gear.name == f"{carrier.stage}.planet")
        slope = 0.05 * math.sqrt(1e3 * planet.pitch_diameter) + 0.35 * math.sqrt(1e3 * planet.face_width) + 4.0
        assert carrier.misalignment is not None and carrier.largest_misalignment is not None
        grades = [round(5.0 + 2.0 * math.log2(2e6 * carrier.largest_misalignment / slope), 9)]
        assert grades[0] in (4.0, 5.0)
        if carrier.free_plate is not None or carrier.alone:
            assert carrier.misalignment <= carrier.largest_misalignment * (1.0 + 1e-6)


def test_the_lag_of_a_sized_carrier_is_that_of_its_plates_and_bridges() -> None:
    """1.33 · 0.1 of b times the lag over b + t, of the frame as it was sized."""
    sizing = shared("in-line-h2")
    carrier, planet = sizing.carriers[0], next(gear for gear in sizing.gears if gear.name == "first.planet")
    assert carrier.bridge_width and carrier.bridge_depth and carrier.bridge_radius and carrier.free_plate
    steel, b = sizing.design.shaft_material, planet.face_width
    frame = Frame(
        planet.bodies, carrier.radius, b, carrier.bridge_width, carrier.bridge_depth, carrier.bridge_radius,
        carrier.free_plate, plate_band(carrier.reach, sizing.design.carriers.fill),
    )  # fmt: skip
    lag = plate_lag(carrier.tangential_force, frame, Elastic(steel.elastic_modulus, steel.shear_modulus))
    assert carrier.misalignment == pytest.approx(0.133 * b * float(lag) / (b + carrier.free_plate), rel=0.02)


def test_the_lighter_of_one_plate_and_two_is_chosen_and_the_user_may_say_which() -> None:
    free, one, two = with_rules(""), with_rules("plates = 1"), with_rules("plates = 2")
    assert all(carrier.free_plate is None for carrier in one.carriers) and one.carriers[0].alone
    assert two.carriers[0].free_plate is not None and not two.carriers[0].alone
    assert carriers_mass(free) <= min(carriers_mass(one), carriers_mass(two)) * (1.0 + 1e-9)


def test_a_plate_that_clamps_cantilever_pins_bears_their_moment() -> None:
    """F/(d t) + 6 M/(d t²) with M = F (b + t)/2 about the middle of the plate, R_p0.2/2 at most."""
    sizing = with_rules("plates = 1")
    carrier, planet = sizing.carriers[0], next(gear for gear in sizing.gears if gear.name == "first.planet")
    d, t, moment = carrier.pin_diameter, carrier.plate_thickness, carrier.pin_force * planet.face_width / 2.0
    moment += carrier.pin_force * carrier.plate_thickness / 2.0
    pressed = carrier.pin_force / (d * t) + 6.0 * moment / (d * t**2)
    assert pressed <= (sizing.design.shaft_material.yield_strength or 0.0) / 2.0 * (1.0 + 1e-6)


def test_torque_that_is_taken_in_the_middle_of_bridges_lets_no_plate_lag() -> None:
    plate, middle = with_rules("plates = 2"), with_rules('plates = 2\ntorque_at = "middle"')
    assert middle.carriers[0].misalignment == 0.0
    assert carriers_mass(middle) <= carriers_mass(plate)


def test_a_smaller_misalignment_asks_for_a_heavier_carrier() -> None:
    wide, narrow = (with_rules(f"plates = 2\nlargest_misalignment_um = {most}") for most in (4.0, 0.5))
    assert (narrow.carriers[0].misalignment or 1.0) <= 0.5e-6 * (1.0 + 1e-6)
    assert carriers_mass(narrow) > carriers_mass(wide)


def test_at_level_concept_one_plate_bears_all_as_the_thesis_has_it(sizing: Sizing) -> None:
    assert [carrier.free_plate for carrier in sizing.carriers] == [None, None]


def test_planets_on_a_carrier_that_stands_still_do_not_pull() -> None:
    carrier = size(read(shipped_design("star"))).carriers[0]
    assert carrier.centrifugal_force == 0.0
    assert carrier.plate_margin is None


def test_plates_have_metal_outside_their_pins(sizing: Sizing) -> None:
    """29.4 kN tear 17.85 mm × 4.2 mm twice at R_p0.2/4: as thick as the pin of 18.6 mm; the second plate's 6.2 mm."""
    first, second = sizing.carriers
    steel = sizing.design.shaft_material
    for carrier, wall in ((first, 17.85e-3), (second, 6.18e-3)):
        assert carrier.eye_wall == pytest.approx(wall, rel=1e-3)
        assert carrier.eye_stress == pytest.approx((steel.yield_strength or 0.0) / 4.0)
        assert carrier.eye_margin == pytest.approx(1.0) and carrier.hole_margin > 1.0
        assert carrier.reach == pytest.approx(carrier.radius + carrier.pin_diameter / 2.0 + carrier.eye_wall)
        bodies = [body for body in sizing.arrangement.bodies if body.part == carrier.part]
        assert {body.radius for body in bodies} == {carrier.reach}


def test_a_plate_goes_through_its_ring_and_is_thicker_where_that_leaves_less_metal() -> None:
    """A pin of 105 mm leaves 1.2 mm inside the ring's teeth less 1 mm: F = 2 w t τ then asks for the thickness."""
    text = shipped_design("in-line-h2").read_text(encoding="utf-8")
    sizing = size(parse(text + '\n[overrides]\n"first.pin_diameter_mm" = 105.0\n'))
    carrier = sizing.carriers[0]
    ring = next(gear for gear in sizing.gears if gear.name == "first.ring")
    assert carrier.reach == pytest.approx(ring.pitch_diameter / 2.0 - ring.module - 1e-3)
    tear = (sizing.design.shaft_material.yield_strength or 0.0) / 4.0
    assert carrier.plate_thickness == pytest.approx(carrier.pin_force / (2.0 * carrier.eye_wall * tear))
    assert carrier.plate_thickness > 0.25 * 16.8e-3 and carrier.eye_margin == pytest.approx(1.0)


def test_a_plate_that_is_given_too_thin_fails_at_its_holes() -> None:
    """In the hole p = F/(d t) rises as the plate is thinner; the metal outside the pin grows, so that it holds."""
    text = shipped_design("in-line-h2").read_text(encoding="utf-8")
    sizing = size(parse(text + '\n[overrides]\n"first.plate_thickness_mm" = 3.0\n'))
    carrier = sizing.carriers[0]
    assert carrier.hole_pressure == pytest.approx(carrier.pin_force / (carrier.pin_diameter * 3e-3))
    assert carrier.eye_wall == pytest.approx(17.85e-3 * 4.2 / 3.0, rel=1e-3)
    failed = {check.what for check in sizing.checks if check.part == carrier.part and check.status is Status.FAILS}
    assert "pin in its hole" in failed and "eye shear" not in failed


def test_a_plate_reaches_beyond_the_outermost_pins_of_a_compound_set() -> None:
    """A Ravigneaux set has pins on two circles; the plate bears both."""
    sizing = size(read(shipped_design("ravigneaux-automatic")))
    (carrier,) = sizing.carriers
    assert carrier.reach > 84.4e-3 + carrier.pin_diameter / 2.0 + 0.9 * carrier.eye_wall
