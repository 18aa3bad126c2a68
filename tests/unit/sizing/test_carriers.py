"""Carriers: pins bear tooth forces and the planets' centrifugal force, and every check is in the margins."""

from __future__ import annotations

import math
from functools import cache

import pytest

from gearwright.checks import Status
from gearwright.parts.carriers import eye_wall, pin_diameter, pin_mass, plate_mass
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
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
    """The face b is loaded evenly, plates hold at L = b + t: M = F/4 (L − b/2), with t of b/8 at least."""
    sizing = shared(name)
    carrier, planet = sizing.carriers[0], next(gear for gear in sizing.gears if gear.name == "first.planet")
    least, pin, bore = planet.face_width / 8.0, carrier.pin_diameter, carrier.pin_bore
    assert carrier.free_plate is not None and carrier.free_plate >= least and bore is not None
    moment = carrier.pin_force / 4.0 * (planet.face_width / 2.0 + least)
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
