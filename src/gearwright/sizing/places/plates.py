"""Both plates of carriers: the one that takes the torque, and the one that holds the other ends of the pins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gearwright.identity import Role, carrier_part
from gearwright.sizing.arranged import Body, Point, Station
from gearwright.sizing.result import Sizing


def plates_of(sizing: Sizing, stage: str) -> tuple[Body, Body]:
    """Return both plates of a carrier: as the arrangement has them, or the second one as far beyond the planets.

    Args:
        sizing: As sized.
        stage: A planetary or compound set.
    """
    part = carrier_part(stage)
    bodies = [body for body in sizing.arrangement.bodies if body.part == part]
    return (bodies[0], bodies[1]) if len(bodies) > 1 else (bodies[0], _mirrored(sizing, bodies[0]))


def _mirrored(sizing: Sizing, plate: Body) -> Body:
    """Return the second plate, as far from the planets as the first, by the rule for one that takes no torque."""
    planets = {gear.part: gear for gear in sizing.gears if gear.stage == plate.part.name and gear.role is Role.PLANET}
    spans = [along_body(plate, body) for body in sizing.arrangement.bodies if body.part in planets]
    low, high = min(span[0] for span in spans), max(span[1] for span in spans)
    thick = sizing.design.carriers.plate_ratio * max(gear.face_width for gear in planets.values())
    ends = (low + high - plate.length, low + high)
    start = ends[1] - thick if ends[0] < low else ends[0]
    origin = Point(*(at + start * way for at, way in zip(plate.origin, plate.direction, strict=True)))
    return replace(plate, origin=origin, stations=(Station(0.0, plate.radius), Station(thick, plate.radius)), bore=0.0)


def along_body(body: Body, other: Body) -> tuple[float, float]:
    """Return where another body begins and ends along the axis of a body, from its origin [m].

    Args:
        body: That says where the axis lies.
        other: In line with it.
    """
    ends = [float((np.asarray(other.origin) + far * np.asarray(other.direction) - np.asarray(body.origin))
                  @ np.asarray(body.direction)) for far in (0.0, other.length)]  # fmt: skip
    return min(ends), max(ends)
