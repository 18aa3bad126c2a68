"""Every requirement that the closure meets binds somewhere: left out there, the design fails its review by it."""

import pytest
from test_planet_bearings_chosen import SET

from designs import PAIR
from gearwright.closure import REQUIREMENTS, Wishes, close, requirement_of
from gearwright.reviews import review
from gearwright.spec import design_text, edited, parse

HOUR = 3600.0
JAMMED = PAIR.replace(
    "[pairs.stage]",
    """\
[cases.rated.turbine]
rating = 1

[cases.jam]
static = true

[cases.jam.turbine]
power_kw = 110

[pairs.stage]""",
)
"""A turbine that pushes once harder than rated."""
OUT_OF_PLACE = """
[errors."set.planet-2"]
pin_tangential_um = 20
"""
"""A pin that stands ahead of its place, in a set none of whose members floats."""
FAST = {"turbines.turbine.speed_rpm": 15000, "propellers.propeller.speed_rpm": 5000}
SLOW = {"turbines.turbine.speed_rpm": 3000, "propellers.propeller.speed_rpm": 1000}
LONG = {
    "turbines.turbine.speed_rpm": 9000,
    "propellers.propeller.speed_rpm": 2000,
    "service.life_h": 20000,
    "service.bearing_life_h": 20000,
}
ISO = "gears.iso6336."
FINE = {f"{ISO}tolerance_class": 1, f"{ISO}pitting_safety": 1.0, "service.application_factor": 1.0}
CASES = {
    "flank": (PAIR, {}),
    "root": (PAIR, {f"{ISO}bending_safety": 5.0, f"{ISO}pitting_safety": 1.0}),
    "static strength": (JAMMED, {f"{ISO}static_bending_safety": 5.0, f"{ISO}pitting_safety": 1.0}),
    "scuffing": (PAIR, {f"{ISO}scuffing_safety": 2.5, **FAST}),
    "teeth": (PAIR, {f"{ISO}widest_modules": 8}),
    "sharing": (f"{SET}{OUT_OF_PLACE}", {}),
    "peaks": (PAIR, FINE),
    "shafts": (PAIR, {}),
    "critical speeds": (PAIR, SLOW),
    "bearings": (SET, LONG),
}
"""Requirement -> a design in which it binds."""
NOT_MOVED = {"carriers", "rims", "room of planets", "joints", "room", "life in flight", "machines", "others"}
"""What the closure changes nothing for: the sizing meets them, or a review tells them."""


def closed(name, *left_out):
    """Return the design of a requirement, closed without some of them, and what fails in its review."""
    text, changes = CASES[name]
    design = edited(parse(text), {"gears.rating": "iso6336", **changes})
    wishes = Wishes(separate=name == "critical speeds", lighten=False, left_out=frozenset(left_out))
    found = close(design, wishes=wishes)
    return found, {requirement_of(check) for check in review(parse(design_text(found.design))).failing}


def test_every_requirement_has_a_design_in_which_it_binds_or_is_known_not_to_move_anything():
    assert CASES.keys() | NOT_MOVED == REQUIREMENTS.keys()
    assert not CASES.keys() & NOT_MOVED


@pytest.mark.parametrize("name", CASES)
def test_a_requirement_that_is_left_out_fails_in_the_review(name):
    _, failing = closed(name)
    _, without = closed(name, name)
    assert name not in failing
    assert name in without
