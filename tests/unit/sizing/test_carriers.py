"""Carriers: pins bear tooth forces and the planets' centrifugal force, and every check is in the margins."""

from __future__ import annotations

import math

import pytest

from gearwright.checks import Status
from gearwright.parts.planetary import eye_wall, pin_diameter, pin_mass, plate_mass
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
from gearwright.spec import parse, read


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
    assert sizing.worst_margin == pytest.approx((11.7e-3 / 12.61e-3) ** 3 * (1.0 - 0.6**4), rel=3e-3)


def test_pins_between_two_plates_are_beams_on_two_supports(sizing: Sizing) -> None:
    """16.8 mm wide in plates of at least b/8: M = F (b + b/4)/8, a solid pin of 12.6 mm, bored one of 13.2."""
    carrier, planet = sizing.carriers[0], next(gear for gear in sizing.gears if gear.name == "first.planet")
    moment = carrier.pin_force * 1.25 * planet.face_width / 8.0
    section = math.pi / 32.0 * carrier.pin_diameter**3 * (1.0 - 0.6**4)
    assert carrier.pin_bore == pytest.approx(0.6 * carrier.pin_diameter)
    assert carrier.pin_stress == pytest.approx(moment / section) == pytest.approx(785e6 / 2.0)
    assert carrier.pin_diameter == pytest.approx(13.21e-3, rel=1e-3)


@pytest.mark.parametrize(("name", "stage"), [("in-line-h2", "first"), ("star", "first")])
def test_two_plates_weigh_less_than_one_that_bears_all_and_another(name: str, stage: str) -> None:
    """One plate of b/4 with pins of M = F b/2, each as the rules for a single plate have it, and its twin."""
    sizing = size(read(shipped_design(name)))
    carrier = next(one for one in sizing.carriers if one.stage == stage)
    planet = next(gear for gear in sizing.gears if gear.name == f"{stage}.planet")
    allowable, width = (sizing.design.shaft_material.yield_strength or 0.0) / 2.0, planet.face_width
    pin = pin_diameter(carrier.pin_force, width, allowable)
    plate = max(0.25 * width, carrier.pin_force / (pin * allowable))
    wall = eye_wall(carrier.pin_force, plate, allowable / 2.0, needed=pin)
    density, fill = sizing.design.shaft_material.density, sizing.design.carriers.fill
    twin = 2.0 * plate_mass(carrier.radius + pin / 2.0 + wall, plate, density, fill=fill)
    apart = planet.bodies * pin_mass(pin, width, density)
    assert carrier.free_plate is not None and carrier.mass < twin + apart


def test_planets_on_a_carrier_that_stands_still_do_not_pull() -> None:
    carrier = size(read(shipped_design("star"))).carriers[0]
    assert carrier.centrifugal_force == 0.0
    assert carrier.plate_margin is None


def test_plates_have_metal_outside_their_pins(sizing: Sizing) -> None:
    """Half of 29.4 kN tears the metal outside the pin of the thinner plate twice, at R_p0.2/4."""
    first, second = sizing.carriers
    steel = sizing.design.shaft_material
    for carrier in (first, second):
        half = carrier.pin_force / 2.0
        assert carrier.eye_wall == pytest.approx(half / (2.0 * carrier.free_plate * 785e6 / 4.0), rel=1e-3)
        assert carrier.eye_stress == pytest.approx((steel.yield_strength or 0.0) / 4.0)
        assert carrier.eye_margin == pytest.approx(1.0) and carrier.hole_margin > 1.0 - 1e-12
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
    assert carrier.free_plate == pytest.approx(carrier.pin_force / 2.0 / (2.0 * carrier.eye_wall * tear))
    assert carrier.free_plate > 0.125 * 16.8e-3 and carrier.eye_margin == pytest.approx(1.0)


def test_a_plate_that_is_given_too_thin_fails_at_its_holes() -> None:
    """In the hole p = F/(d t) rises as the plate is thinner; the metal outside the pin grows, so that it holds."""
    text = shipped_design("in-line-h2").read_text(encoding="utf-8")
    sizing = size(parse(text + '\n[overrides]\n"first.plate_thickness_mm" = 2.0\n'))
    carrier = sizing.carriers[0]
    assert carrier.hole_pressure == pytest.approx(carrier.pin_force / 2.0 / (carrier.pin_diameter * 2e-3))
    assert carrier.eye_wall == pytest.approx(carrier.pin_force / 2.0 / (2.0 * 2e-3 * 785e6 / 4.0), rel=1e-3)
    failed = {check.what for check in sizing.checks if check.part == carrier.part and check.status is Status.FAILS}
    assert "pin in its hole" in failed and "eye shear" not in failed


def test_a_plate_reaches_beyond_the_outermost_pins_of_a_compound_set() -> None:
    """A Ravigneaux set has pins on two circles; the plate bears both."""
    sizing = size(read(shipped_design("ravigneaux-automatic")))
    (carrier,) = sizing.carriers
    assert carrier.reach > 84.4e-3 + carrier.pin_diameter / 2.0 + 0.9 * carrier.eye_wall
