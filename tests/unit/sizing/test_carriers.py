"""Carriers: pins bear tooth forces and the planets' centrifugal force, and every check is in the margins."""

from __future__ import annotations

import math

import pytest

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
    assert sizing.worst_margin == pytest.approx((11.7e-3 / 18.58e-3) ** 3, rel=3e-3)


def test_planets_on_a_carrier_that_stands_still_do_not_pull() -> None:
    carrier = size(read(shipped_design("star"))).carriers[0]
    assert carrier.centrifugal_force == 0.0
    assert carrier.plate_margin is None
