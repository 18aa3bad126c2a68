"""The solids of carriers: both plates, pins and bridges between them, and what planets turn on."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gearwright.parts.gears import Blank
from gearwright.shape.solids import Solid, arms, bearing, block, tube
from gearwright.shape.stands import Axes, Stand
from gearwright.sizing import CarrierSizing, GearSizing
from gearwright.sizing.mass import Bridge, Cage, Plate

LEAST_RING = 5e-4
"""Room between pin and planet below which nothing is drawn in it [m]."""


def held_at(cage: Cage, axes: Axes, planets: Sequence[Stand]) -> tuple[list[float], list[float]]:
    """Return where a carrier holds pins, and where its bridges stand, about its axis [rad].

    Args:
        cage: As made.
        axes: Of the carrier.
        planets: That it carries.
    """
    pins = {(stand.node, stand.place): axes.angle(stand.axes.origin - axes.origin) for stand in planets}
    angles = sorted(pins.values())
    if cage.bridge is None:
        return angles, []
    following = [*angles[1:], angles[0] + 2.0 * math.pi]
    return angles, [0.5 * (one + other) for one, other in zip(angles, following, strict=True)]


def plate_solid(plate: Plate, held: Sequence[float], segments: int) -> Solid:
    """Return a plate of a carrier: arms to what it holds, with a hole for what goes through it.

    Args:
        plate: As made.
        held: Angles of pins and bridges [rad].
        segments: Corners of a circle.
    """
    body = plate.body
    return arms(held, body.radius, body.length, bore=plate.bore, fill=plate.fill, segments=segments)


def pin_solid(cage: Cage, axes: Axes) -> Solid:
    """Return a pin from plate to plate.

    Args:
        cage: As made.
        axes: Where it is drawn about.
    """
    return tube(_between(cage, axes), cage.pin_diameter / 2.0, cage.pin_bore / 2.0)


def bridge_solid(cage: Cage, bridge: Bridge) -> Solid:
    """Return a bridge about its middle, away from the carrier's axis along x.

    Args:
        cage: As made.
        bridge: Of it.
    """
    return block(bridge.width, bridge.depth, cage.span[1] - cage.span[0])


def bridge_axes(cage: Cage, radius: float, axes: Axes, angle: float) -> Axes:
    """Return where a bridge stands.

    Args:
        cage: As made.
        radius: Of its middle [m].
        axes: Of the carrier.
        angle: About the carrier's axis [rad].
    """
    cosine, sine = math.cos(angle), math.sin(angle)
    turned = axes.turned @ np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    middle = sum(_between(cage, axes)) / 2.0
    return Axes(axes.origin + radius * turned[:, 0] + middle * axes.along, turned)


def _between(cage: Cage, axes: Axes) -> tuple[float, float]:
    """Return where the room between both plates begins and ends along an axis, from its origin [m]."""
    body = cage.plates[0].body
    ends = [float((np.asarray(body.origin) + far * np.asarray(body.direction) - axes.origin) @ axes.along)
            for far in cage.span]  # fmt: skip
    return min(ends), max(ends)


def planet_bearing(carrier: CarrierSizing, gear: GearSizing, blank: Blank, halves: int) -> Solid | None:
    """Return the envelope of what a planet turns on; None where there is no room between planet and pin.

    Args:
        carrier: As sized.
        gear: The planet.
        blank: Its body.
        halves: 2 of a double-helical planet.
    """
    inner, outer = carrier.pin_diameter / 2.0, blank.bore_radius
    if outer - inner < LEAST_RING:
        return None
    return bearing(inner, outer, halves * gear.face_width)
