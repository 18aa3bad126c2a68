"""What a reader wants to see of the bearings of planets, as a table."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gearwright.render.grid.table import Table, table
from gearwright.sizing import Sizing
from gearwright.units import Length, Mass

_NOTE = (
    "The smallest that serves, where kind or size are left open; a planet is a ring around its bearing, and what turns"
    " of the bearing swings with it. Lives and films stand with the margins."
)


@dataclass(frozen=True)
class PlanetRow:
    """What one kind of planet turns on."""

    planet: str
    designation: str
    pin_diameter: Length
    """[m]"""
    bore: Length
    """Of the planet [m]."""
    width: Length
    """[m]"""
    ring: Mass
    """Of the planet itself [kg]."""
    turning: Mass
    """Of its bearing that turns with it [kg]."""


def planet_table(sizing: Sizing) -> Table:
    """Return what planets turn on; empty where the design does not say.

    Args:
        sizing: As sized.
    """
    fields = ("planet", "designation", "pin_diameter", "bore", "width", "ring", "turning")
    return table("Planet bearings", list(_rows(sizing)), fields, note=_NOTE)


def _rows(sizing: Sizing) -> Iterator[PlanetRow]:
    for gear in sizing.gears:
        if (runs_on := gear.runs_on) is not None:
            sizes = (runs_on.pin_diameter, runs_on.outer_diameter, runs_on.width)
            yield PlanetRow(gear.name, runs_on.designation, *sizes, gear.mass, runs_on.turning_mass)
