"""The solids of carriers: the plate that takes the torque, the pins, and what planets turn on."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.parts.gears import Blank
from gearwright.shape.solids import Solid, arms, bearing, tube
from gearwright.shape.stands import Axes, Stand
from gearwright.sizing import CarrierSizing, GearSizing, Sizing
from gearwright.sizing.arranged import Body
from gearwright.sizing.places import IN_LINE, Run

CLEAR = 1.08
"""Hole of a plate over a shaft that goes through it without being tied to it, an assumption [-]."""
LEAST_RING = 5e-4
"""Room between pin and planet below which nothing is drawn in it [m]."""


def plate_solid(
    sizing: Sizing, carrier: CarrierSizing, body: Body, axes: Axes,
    planets: Sequence[Stand], runs: Sequence[Run], segments: int,
) -> Solid:  # fmt: skip
    """Return the plate of a carrier: arms to its pins, with a hole for what goes through it.

    Args:
        sizing: As sized.
        carrier: As sized.
        body: Its envelope.
        axes: Where it stands.
        planets: That it carries.
        runs: Shafts as drawn.
        segments: Corners of a circle.
    """
    pins = {(stand.node, stand.place): axes.angle(stand.axes.origin - axes.origin) for stand in planets}
    fill = sizing.design.carriers.fill if len({node for node, _ in pins}) == 1 else 1.0
    bore = max((_through(sizing, run, axes, body, carrier.shaft) for run in runs), default=0.0)
    return arms(
        list(pins.values()), body.radius, body.length, bore=min(bore, 0.8 * body.radius), fill=fill, segments=segments
    )


def _through(sizing: Sizing, run: Run, axes: Axes, body: Body, own: str) -> float:
    """Return the radius of the hole that a shaft needs in a plate; 0 where it does not reach it [m]."""
    frame = sizing.arrangement.frames[run.shaft]
    between = axes.origin - np.asarray(frame.origin)
    place = float(between @ np.asarray(frame.along))
    beside = float(np.linalg.norm(between - place * np.asarray(frame.along)))
    if beside > IN_LINE or abs(abs(float(axes.along @ np.asarray(frame.along))) - 1.0) > IN_LINE:
        return 0.0
    half = body.length / 2.0
    radii = [radius for low, high, radius in run.steps if low < place + half and place - half < high]
    return max(radii, default=0.0) * (1.0 if run.shaft == own else CLEAR)


def pin_solid(carrier: CarrierSizing, plate: Body, steps: Sequence[Stand], axes: Axes) -> Solid:
    """Return a pin from the far end of its planet through the plate.

    Args:
        carrier: As sized.
        plate: The plate's envelope.
        steps: Of the planet on it.
        axes: Where it is drawn about.
    """
    ends = [
        float((step.axes.origin - axes.origin) @ axes.along) + sign * step.gear.face_width / 2.0
        for step in steps for sign in (-1.0, 1.0)
    ]  # fmt: skip
    near = [float((np.asarray(plate.origin) + far * np.asarray(plate.direction) - axes.origin) @ axes.along)
            for far in (0.0, plate.length)]  # fmt: skip
    span = (min(*ends, *near), max(*ends, *near))
    return tube(span, carrier.pin_diameter / 2.0, (carrier.pin_bore or 0.0) / 2.0)


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
