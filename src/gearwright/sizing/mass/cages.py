"""Carriers as they are made: a plate on both sides of the planets, hollow pins between, bridges where there is room.

What weighs them and what draws them take them from here.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.identity import Role
from gearwright.sizing.arranged import Body
from gearwright.sizing.carrying import CarrierSizing
from gearwright.sizing.places import IN_LINE, Run, along_body, plates_of
from gearwright.sizing.result import GearSizing, Sizing

PIN_BORE = 0.6
"""Bore of planet pins over their diameter [-], an estimate: held on both sides, a pin as thick as a cantilever one
bears a quarter of the moment, for which a bore of 0.93 would do."""
BRIDGE = 0.5
"""Depth of a carrier's bridge over a planet's diameter [-], an estimate from drawings of two-plate carriers."""
BESIDE = 1e-3
"""Room between a bridge and each planet beside it [m], an assumption."""
CLEAR = 1.08
"""Hole of a plate over a shaft that goes through it without being tied to it, an assumption [-]."""
WIDEST = 0.8
"""Hole of a plate over its outer radius, at most [-]."""


class Plate(NamedTuple):
    """One plate of a carrier."""

    body: Body
    """Where it stands."""
    bore: float
    """Radius of the hole for the shafts that go through it [m]."""
    fill: float
    """Share of its disc that is left, the hole among what is taken [-]."""

    @property
    def volume(self) -> float:
        """[m³]"""
        radius = self.body.radius
        return math.pi * min(self.fill * radius**2, radius**2 - self.bore**2) * self.body.length


class Bridge(NamedTuple):
    """What joins both plates between two planets; lengths [m]."""

    width: float
    """Around the axis, at the pins' circle."""
    depth: float
    """Away from the axis."""


class Cage(NamedTuple):
    """A carrier as it is made."""

    plates: tuple[Plate, Plate]
    span: tuple[float, float]
    """From the inner face of one plate to that of the other, along the first plate's axis from its origin [m]."""
    pin_diameter: float
    """[m]"""
    pin_bore: float
    """[m]"""
    pins: int
    """[-]"""
    bridge: Bridge | None
    """None where planets leave no room."""
    bridges: int
    """[-]"""

    @property
    def volume(self) -> float:
        """[m³]"""
        length = self.span[1] - self.span[0]
        pins = self.pins * math.pi / 4.0 * (self.pin_diameter**2 - self.pin_bore**2)
        bridges = 0.0 if self.bridge is None else self.bridges * self.bridge.width * self.bridge.depth
        return sum(plate.volume for plate in self.plates) + (pins + bridges) * length


def cage_of(sizing: Sizing, carrier: CarrierSizing, runs: Sequence[Run]) -> Cage:
    """Return a carrier as it is made.

    Args:
        sizing: As sized.
        carrier: Of it.
        runs: Shafts from end to end.
    """
    planets = [gear for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET]
    pins = {gear.shafts[0]: gear.bodies for gear in planets}
    bore = PIN_BORE * carrier.pin_diameter if carrier.pin_bore is None else carrier.pin_bore
    bodies = plates_of(sizing, carrier.stage)
    fill = sizing.design.carriers.fill
    plates = (
        Plate(bodies[0], plate_bore(sizing, bodies[0], runs), fill),
        Plate(bodies[1], plate_bore(sizing, bodies[1], runs), fill),
    )
    bridge = bridge_between(carrier, planets)
    return Cage(plates, _between(bodies), carrier.pin_diameter, bore, sum(pins.values()), bridge, max(pins.values()))


def _between(bodies: tuple[Body, Body]) -> tuple[float, float]:
    """Return where the room between two plates begins and ends, along the first one's axis [m]."""
    other = along_body(bodies[0], bodies[1])
    return (bodies[0].length, other[0]) if other[0] > 0.0 else (other[1], 0.0)


def bridge_between(carrier: CarrierSizing, planets: Sequence[GearSizing]) -> Bridge | None:
    """Return a bridge, as wide as neighbouring planets of a simple set leave; None where they leave nothing.

    Args:
        carrier: As sized.
        planets: On its pins.
    """
    if len({gear.shafts[0] for gear in planets}) > 1:
        return None
    widest = max(planets, key=lambda gear: gear.pitch_diameter)
    tip = widest.pitch_diameter + 2.0 * widest.module * (1.0 + widest.profile_shift + widest.tip_alteration)
    width = 2.0 * carrier.radius * math.sin(math.pi / widest.bodies) - tip - 2.0 * BESIDE
    return Bridge(width, BRIDGE * tip) if width > 0.0 and widest.bodies > 1 else None


def plate_bore(sizing: Sizing, plate: Body, runs: Sequence[Run]) -> float:
    """Return the radius of the hole that a plate has for the shafts that go through it [m].

    Args:
        sizing: As sized.
        plate: Its envelope.
        runs: Shafts from end to end.
    """
    return min(max((_through(sizing, run, plate) for run in runs), default=0.0), WIDEST * plate.radius)


def _through(sizing: Sizing, run: Run, plate: Body) -> float:
    """Return the radius of the hole that a shaft needs in a plate; 0 where it does not reach it [m]."""
    frame = sizing.arrangement.frames[run.shaft]
    axis, middle = np.asarray(frame.along), np.asarray(plate.origin) + plate.length / 2.0 * np.asarray(plate.direction)
    place = float((middle - np.asarray(frame.origin)) @ axis)
    beside = float(np.linalg.norm(middle - np.asarray(frame.origin) - place * axis))
    if beside > IN_LINE or abs(abs(float(np.asarray(plate.direction) @ axis)) - 1.0) > IN_LINE:
        return 0.0
    half = plate.length / 2.0
    radii = [radius for low, high, radius in run.steps if low < place + half and place - half < high]
    return max(radii, default=0.0) * (1.0 if run.shaft == plate.shaft else CLEAR)
