"""Gears of a preliminary sizing: their mass and inertia are those of the bodies that the complete mass counts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gearwright.identity import Role
from gearwright.sizing.mass.bodies import Seats, shaft_diameters
from gearwright.sizing.mass.duties import seat_duties
from gearwright.sizing.mass.gears import gear_item
from gearwright.sizing.mass.planet_bores import PlanetBore, named_bores, planet_bores
from gearwright.sizing.result import PRELIMINARY, GearSizing, Sizing


def as_made(sizing: Sizing) -> Sizing:
    """Return a preliminary sizing with gears as they are made: teeth, rims, webs, hubs, bores; any other as it is.

    Args:
        sizing: With shafts and what planets turn on.
    """
    if sizing.level != PRELIMINARY:
        return sizing
    seats = Seats(_bores(sizing), shaft_diameters(sizing))
    return replace(sizing, gears=tuple(_made(sizing, gear, seats) for gear in sizing.gears))


def _made(sizing: Sizing, gear: GearSizing, seats: Seats) -> GearSizing:
    """Return a gear with the mass of its body; its inertia goes with the mass, as rims lie outside and hubs inside."""
    if f"{gear.name}.mass" in sizing.given:
        return gear
    mass = gear_item(sizing, gear, seats).each
    inertia = gear.inertia if f"{gear.name}.inertia" in sizing.given else gear.inertia * (mass / gear.mass)
    return replace(gear, mass=mass, inertia=inertia)


def _bores(sizing: Sizing) -> Mapping[str, PlanetBore]:
    """Return what planets turn on; of those on films, and where nothing fits, what their loads ask for."""
    named = named_bores(sizing)
    planets = {gear.name for gear in sizing.gears if gear.role is Role.PLANET}
    return named if planets <= named.keys() else planet_bores(sizing, tuple(seat_duties(sizing)))
