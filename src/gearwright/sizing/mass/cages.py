"""Carriers as they are made: a plate on both sides of the planets, hollow pins through them, bridges with room.

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
from gearwright.sizing.mass.bodies import tooth_of
from gearwright.sizing.places import IN_LINE, Run, along_body, planets_span, plates_of
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
    """Share of its disc that is left, the hole for shafts among what is taken, holes for pins not [-]."""

    @property
    def volume(self) -> float:
        """With its holes for pins closed [m³]."""
        radius = self.body.radius
        return math.pi * min(self.fill * radius**2, radius**2 - self.bore**2) * self.body.length


class Bridge(NamedTuple):
    """What joins both plates between two planets; lengths [m]."""

    width: float
    """Around the axis."""
    depth: float
    """Away from the axis."""
    radius: float
    """Of its middle, on the chord between neighbouring pins."""


class Cage(NamedTuple):
    """A carrier as it is made."""

    plates: tuple[Plate, ...]
    """One, or two where the second has room."""
    span: tuple[float, float]
    """From the inner face of one plate to that of the other, or to the far end of the planets, along the first plate's
    axis from its origin [m]."""
    whole: tuple[float, float]
    """Where pins begin and end: flush with the outer faces of their plates; as `span` [m]."""
    pin_diameter: float
    """[m]"""
    eye_wall: float
    """Metal of plates outside the holes for pins [m]."""
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
        length, pin = self.span[1] - self.span[0], math.pi / 4.0 * self.pin_diameter**2
        bridges = 0.0 if self.bridge is None else self.bridges * self.bridge.width * self.bridge.depth
        pins = self.pins * (pin * length - math.pi / 4.0 * self.pin_bore**2 * (self.whole[1] - self.whole[0]))
        return sum(plate.volume for plate in self.plates) + pins + bridges * length


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
    plates = tuple(Plate(body, plate_bore(sizing, body, runs), fill) for body in bodies)
    bridge = bridge_between(sizing, carrier, planets) if len(plates) > 1 else None
    span = _between(sizing, bodies)
    ends = [end for body in bodies for end in along_body(bodies[0], body)]
    whole = (min(span[0], *ends), max(span[1], *ends))
    return Cage(
        plates, span, whole, carrier.pin_diameter, carrier.eye_wall, bore, sum(pins.values()), bridge,
        max(pins.values()),
    )  # fmt: skip


def _between(sizing: Sizing, plates: Sequence[Body]) -> tuple[float, float]:
    """Return where pins begin and end along the axis of the first plate, from its origin [m]."""
    first = plates[0]
    if len(plates) > 1:
        low, high = along_body(first, plates[1])
        far = low if low > 0.0 else high
    else:
        low, high = planets_span(sizing, first)
        far = high if low > 0.0 else low
    return (first.length, far) if far > 0.0 else (far, 0.0)


def bridge_between(sizing: Sizing, carrier: CarrierSizing, planets: Sequence[GearSizing]) -> Bridge | None:
    """Return a bridge, as wide as neighbouring planets leave on their chord; None where they leave nothing.

    Args:
        sizing: As sized.
        carrier: Of it.
        planets: On its pins.

    Source: chord 2 r sin(π/N) less the tip diameter; between the tips of suns and rings away from the axis.
    """
    if len({gear.shafts[0] for gear in planets}) > 1:
        return None
    widest = max(planets, key=lambda gear: gear.pitch_diameter)
    tip = 2.0 * _tip(sizing, widest)
    width = 2.0 * carrier.radius * math.sin(math.pi / widest.bodies) - tip - 2.0 * BESIDE
    own = [gear for gear in sizing.gears if gear.stage == carrier.stage]
    suns = [_tip(sizing, gear) for gear in own if gear.role is Role.SUN]
    rings = [_tip(sizing, gear) for gear in own if gear.rim]
    middle = carrier.radius * math.cos(math.pi / widest.bodies)
    inner = max([middle - BRIDGE * tip / 2.0, *(radius + BESIDE for radius in suns)])
    within = [math.sqrt(max((radius - BESIDE) ** 2 - width**2 / 4.0, 0.0)) for radius in rings]
    outer = min([middle + BRIDGE * tip / 2.0, *within])
    if width <= 0.0 or outer <= inner or widest.bodies == 1:
        return None
    return Bridge(width, outer - inner, (outer + inner) / 2.0)


def _tip(sizing: Sizing, gear: GearSizing) -> float:
    return tooth_of(sizing, gear).tip_radius


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
