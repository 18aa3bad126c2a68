"""Gears of a preliminary sizing: their mass and inertia are those of the bodies that the complete mass counts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gearwright.sizing.mass.gears import gear_item
from gearwright.sizing.mass.planet_bores import PlanetBore, named_bores
from gearwright.sizing.result import PRELIMINARY, GearSizing, Sizing


def as_made(sizing: Sizing) -> Sizing:
    """Return a preliminary sizing with gears as they are made: teeth, rims, webs, hubs, bores; any other as it is.

    Args:
        sizing: With shafts and what planets turn on.
    """
    if sizing.level != PRELIMINARY:
        return sizing
    bores, shafts = named_bores(sizing), {shaft.name: shaft.diameter for shaft in sizing.shafts}
    return replace(sizing, gears=tuple(_made(sizing, gear, bores, shafts) for gear in sizing.gears))


def _made(sizing: Sizing, gear: GearSizing, bores: Mapping[str, PlanetBore], shafts: Mapping[str, float]) -> GearSizing:
    """Return a gear with the mass of its body; its inertia goes with the mass, as rims lie outside and hubs inside."""
    if f"{gear.name}.mass" in sizing.given:
        return gear
    mass = gear_item(sizing, gear, bores, shafts).each
    inertia = gear.inertia if f"{gear.name}.inertia" in sizing.given else gear.inertia * (mass / gear.mass)
    return replace(gear, mass=mass, inertia=inertia)
