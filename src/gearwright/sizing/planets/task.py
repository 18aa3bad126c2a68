"""What a bearing between a planet and its pin is chosen for: the room, the loads, the strength of the pin."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

from gearwright.identity import Role, gear_part
from gearwright.parts.gears import disc_mass
from gearwright.parts.planetary import pin_stress
from gearwright.sizing.bearings import PlanetLoad, Seat, borne_by, planet_seats, unit_loads
from gearwright.sizing.blanks import crown_volume, planet_body_volume
from gearwright.sizing.pinned import PlanetBearingSizing
from gearwright.sizing.rating import Context
from gearwright.sizing.result import PRELIMINARY, GearSizing
from gearwright.sizing.rolling import pin_circle
from gearwright.spec.design import PlanetBearing

THICKEST = 0.96
"""Largest bore of a planet over its root circle, whatever stands in it: what has no room is told by its checks [-]."""


class Carried(NamedTuple):
    """What is known of a carrier before it is sized."""

    stage: str
    shaft: str
    radius: float
    """[m]"""
    pin_diameter: float
    """[m]"""


@dataclass(frozen=True)
class Task:
    """One planet of a simple set, whose bearing the design leaves open or names."""

    context: Context
    planet: GearSizing
    asked: PlanetBearing
    path: str
    """Where the design asks."""
    seat: Seat
    """What its meshes push."""
    radius: float
    """Of the circle of pins [m]."""

    @property
    def room(self) -> float:
        """Largest bore of the planet [m]."""
        return self.seat.room

    @property
    def width(self) -> float:
        """Of rollers' room or film [m]."""
        return self.asked.width or self.planet.face_width

    @property
    def fastest(self) -> float:
        """Of the planet against its carrier, in all cases [rad/s]."""
        return max(borne_by(self.context, self.seat).speeds, default=0.0)

    @cached_property
    def crown(self) -> float:
        """What the teeth of the planet fill [m³]; 0 where it counts as a ring without them."""
        return crown_of(self.context, self.planet)

    def load(self, runs_on: PlanetBearingSizing) -> PlanetLoad:
        """Return what a bearing bears in every case, with what it takes from the planet and what it swings itself.

        Args:
            runs_on: The bearing.
        """
        moving = bored(self.context, self.planet, runs_on, crown=self.crown).turning_mass
        return borne_by(self.context, replace(self.seat, swung=moving * self.radius))

    def pin_margin(self, pin: float, load: PlanetLoad) -> float:
        """Return allowable over actual stress of a solid pin [-].

        Args:
            pin: Its diameter [m].
            load: On it.
        """
        design = self.context.design
        allowable = (design.shaft_material.yield_strength or 0.0) / design.carriers.safety
        stress = pin_stress(float(load.radial.max()), self.planet.face_width, pin)
        return allowable / stress if stress else math.inf


def tasks(context: Context, gears: tuple[GearSizing, ...]) -> Iterator[Task]:
    """Yield every planet of a simple set for which the design asks a bearing.

    Args:
        context: What sizing reads.
        gears: As sized, planets as solid discs.
    """
    asked = {name: stage for name, stage in context.design.planetaries.items() if stage.planet_bearing is not None}
    if not asked:
        return
    by_name = {gear.name: gear for gear in gears}
    carriers = [
        Carried(name, stage.carrier, pin_circle(context, name, by_name), 0.0)
        for name, stage in context.design.planetaries.items()
    ]
    own = [gear for gear in gears if gear.stage in context.design.planetaries]
    simple = {seat.part.name: seat for seat in planet_seats(unit_loads(context), tuple(own), carriers)}
    for carrier in carriers:
        bearing = context.design.planetaries[carrier.stage].planet_bearing
        if bearing is not None:
            planet, path = by_name[str(gear_part(carrier.stage, Role.PLANET))], f"planetaries.{carrier.stage}"
            seat = replace(simple[carrier.stage], fitted=bearing, side_by_side=bearing.side_by_side)
            yield Task(context, planet, bearing, f"{path}.planet_bearing", seat, carrier.radius)


def crown_of(context: Context, planet: GearSizing) -> float:
    """Return what the teeth of a planet fill, where it is weighed as it is made; else 0 [m³].

    Args:
        context: What sizing reads.
        planet: As sized.
    """
    return crown_volume(context.design, planet) if context.design.level == PRELIMINARY else 0.0


def bored(context: Context, planet: GearSizing, runs_on: PlanetBearingSizing, *, crown: float) -> GearSizing:
    """Return a planet with the bore that its bearing takes, of its own mass and inertia: a ring, or as it is made.

    What the user gives of mass or inertia stays.

    Args:
        context: What sizing reads.
        planet: As a solid disc.
        runs_on: What stands in it.
        crown: From `crown_of` [m³].
    """
    mean = planet.pitch_diameter + 2.0 * planet.profile_shift * planet.module
    bore = min(runs_on.outer_diameter, THICKEST * (planet.pitch_diameter - 2.5 * planet.module))
    density = context.ratings[planet.stage].material.density
    if crown:
        own = density * (crown + planet_body_volume(context.design, planet, runs_on.outer_diameter))
    else:
        own = planet.mass - disc_mass(bore, planet.face_width, density)
    mass = context.given.get(f"{planet.name}.mass", own)
    inertia = context.given.get(f"{planet.name}.inertia", mass * (mean**2 + bore**2) / 8.0)
    return replace(planet, mass=mass, inertia=inertia, runs_on=runs_on)
