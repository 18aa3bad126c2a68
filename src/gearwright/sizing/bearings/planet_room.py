"""Whether what a planet turns on has room inside it."""

from __future__ import annotations

from gearwright.catalogue import Bearing, bearing
from gearwright.checks import Check
from gearwright.sizing.result import GearSizing
from gearwright.spec import Design


def named_room(design: Design, gears: tuple[GearSizing, ...]) -> tuple[Check, ...]:
    """Return whether the bearings that a design names for its planets are as wide as the planets at most.

    Args:
        design: As read.
        gears: As sized.
    """
    planets = {gear.stage: gear for gear in gears if gear.role == "planet"}
    named = {name: stage.planet_bearing for name, stage in design.planetaries.items()}
    return tuple(
        planet_room(planets[name], bearing(asked.designation), asked.side_by_side)
        for name, asked in named.items()
        if asked is not None
    )


def planet_room(planet: GearSizing, fitted: Bearing, side_by_side: int) -> Check:
    """Return whether bearings side by side are as wide as their planet at most.

    Args:
        planet: The gear.
        fitted: Each of the bearings in it.
        side_by_side: How many there are.
    """
    width, place = side_by_side * fitted.width, f"{fitted.designation} in {planet.name}"
    return Check(
        planet.part, "room for its bearing", "width of bearings and gear", width, planet.face_width, "length",
        at_most=True, exponent=None, place=place,
    )  # fmt: skip
