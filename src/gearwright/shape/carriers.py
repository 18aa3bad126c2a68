"""The solids of carriers: both plates, pins and bridges between them, and what planets turn on."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gearwright.parts.gears import Blank
from gearwright.shape.solids import Arm, Outline, Solid, bearing, block, plate, tube
from gearwright.shape.stands import Axes, Stand
from gearwright.sizing import CarrierSizing, GearSizing
from gearwright.sizing.mass import Bridge, Cage, Plate

LEAST_RING = 5e-4
"""Room between pin and planet below which nothing is drawn in it [m]."""


def held_at(cage: Cage, axes: Axes, planets: Sequence[Stand]) -> tuple[Arm, ...]:
    """Return what the plates of a carrier hold, about its axis: eyes around pins by their angles, then bridges.

    Args:
        cage: As made.
        axes: Of the carrier.
        planets: That it carries.
    """
    off = {(stand.node, stand.place): stand.axes.origin - axes.origin for stand in planets}
    eye = cage.pin_diameter / 2.0 + cage.eye_wall
    pins = sorted(Arm(axes.angle(way), math.hypot(*(axes.turned.T @ way)[:2]), eye) for way in off.values())
    if cage.bridge is None:
        return tuple(pins)
    angles = [pin.angle for pin in pins]
    following = [*angles[1:], angles[0] + 2.0 * math.pi]
    inner, end = (cage.bridge.radius + way * cage.bridge.depth / 2.0 for way in (-1.0, 1.0))
    half = cage.bridge.width / 2.0
    between = [0.5 * (one + other) for one, other in zip(angles, following, strict=True)]
    return (*pins, *(Arm(angle, end, half, inner, is_round=False) for angle in between))


def plate_outline(own: Plate) -> Outline:
    """Return what a plate of a carrier is cut to.

    Args:
        own: As made.
    """
    return Outline(own.body.radius, own.bore, own.fill)


def plate_solid(cage: Cage, own: Plate, held: Sequence[Arm], segments: int) -> Solid:
    """Return a plate of a carrier: arms to what it holds, with holes for its pins and for what goes through it.

    Args:
        cage: As made.
        own: One of its plates.
        held: Its pins and bridges.
        segments: Corners of a circle.
    """
    return plate(held, plate_outline(own), own.body.length, pin=cage.pin_diameter / 2.0, segments=segments)


def pin_solid(cage: Cage, axes: Axes) -> Solid:
    """Return a pin, through its plates.

    Args:
        cage: As made.
        axes: Where it is drawn about.
    """
    return tube(_between(cage, cage.whole, axes), cage.pin_diameter / 2.0, cage.pin_bore / 2.0)


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
    middle = sum(_between(cage, cage.span, axes)) / 2.0
    return Axes(axes.origin + radius * turned[:, 0] + middle * axes.along, turned)


def _between(cage: Cage, span: tuple[float, float], axes: Axes) -> tuple[float, float]:
    """Return where a span of the first plate's axis begins and ends along another one, from its origin [m]."""
    body = cage.plates[0].body
    ends = [float((np.asarray(body.origin) + far * np.asarray(body.direction) - axes.origin) @ axes.along)
            for far in span]  # fmt: skip
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
