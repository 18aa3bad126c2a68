"""Both plates of carriers: the one that takes the torque, and the one that holds the other ends of the pins."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from gearwright.identity import Kind, PartId, Role, carrier_part
from gearwright.sizing.arranged import Body, Point, Station
from gearwright.sizing.places.solids import room_between
from gearwright.sizing.result import GearSizing, Sizing

_IN_LINE = 1e-6
"""How far two axes may be apart and count as one [m]."""


def plates_of(sizing: Sizing, stage: str) -> tuple[Body, ...]:
    """Return the plates of a carrier: as the arrangement has them, and a second one beyond the planets that has room.

    Args:
        sizing: As sized.
        stage: A planetary or compound set.
    """
    part = carrier_part(stage)
    bodies = tuple(body for body in sizing.arrangement.bodies if body.part == part)
    second, taken = _mirrored(sizing, bodies[0])
    return bodies if len(bodies) > 1 or not _has_room(sizing, taken) else (*bodies, second)


def _mirrored(sizing: Sizing, plate: Body) -> tuple[Body, Body]:
    """Return a plate as far from the planets as the first, as thick as one that takes no torque, and what it takes."""
    planets, (low, high) = _planets(sizing, plate)
    thick = sizing.design.carriers.plate_ratio * max(gear.face_width for gear in planets)
    if low > 0.0:  # the first plate lies before the planets
        start = low + high - plate.length
        return _moved(plate, start, thick), _moved(plate, high, start + thick - high)
    end = low + high
    return _moved(plate, end - thick, thick), _moved(plate, end - thick, low - end + thick)


def planets_span(sizing: Sizing, plate: Body) -> tuple[float, float]:
    """Return where the planets of a set begin and end along the axis of its carrier's plate, from its origin [m].

    Args:
        sizing: As sized.
        plate: Of the carrier.
    """
    return _planets(sizing, plate)[1]


def _planets(sizing: Sizing, plate: Body) -> tuple[list[GearSizing], tuple[float, float]]:
    found = {gear.part: gear for gear in sizing.gears if gear.stage == plate.part.name and gear.role is Role.PLANET}
    spans = [along_body(plate, body) for body in sizing.arrangement.bodies if body.part in found]
    return list(found.values()), (min(span[0] for span in spans), max(span[1] for span in spans))


def _moved(plate: Body, start: float, length: float) -> Body:
    """Return a disc as wide as a plate elsewhere on its axis, without a bore."""
    origin = Point(*(at + start * way for at, way in zip(plate.origin, plate.direction, strict=True)))
    return replace(plate, origin=origin, stations=(Station(0.0, plate.radius), Station(length, plate.radius)), bore=0.0)


def _has_room(sizing: Sizing, plate: Body) -> bool:
    """Tell whether nothing but shafts in line, for which plates have a hole, stands where a plate would."""
    axis = plate.direction
    for body in (*sizing.arrangement.bodies, *_whole(sizing)):
        if body.part.name == plate.part.name and body.part.kind in (Kind.GEAR, Kind.CARRIER):
            continue
        off = tuple(at - zero for at, zero in zip(body.origin, plate.origin, strict=True))
        beside, tilt = math.hypot(*_cross(off, axis)), math.hypot(*_cross(body.direction, axis))
        if body.part.kind is Kind.SHAFT and beside < _IN_LINE and tilt < _IN_LINE:
            continue
        if room_between(plate, body, enough=0.0).gap < 0.0:
            return False
    return True


def _cross(one: Sequence[float], other: Sequence[float]) -> tuple[float, float, float]:
    """Return the vector product of two vectors; numpy's takes longer for a single one."""
    (a, b, c), (x, y, z) = one, other
    return b * z - c * y, c * x - a * z, a * y - b * x


def _whole(sizing: Sizing) -> Iterator[Body]:
    """Yield shafts of a first sizing as long as they are sized, with what holds their ends."""
    for shaft in sizing.shafts:
        frame, radius = sizing.arrangement.frames[shaft.name], shaft.diameter / 2.0
        ends = (Station(0.0, radius), Station(shaft.length, radius))
        yield Body(PartId(Kind.SHAFT, shaft.name), shaft.name, "", frame.origin, frame.along, ends)


def along_body(body: Body, other: Body) -> tuple[float, float]:
    """Return where another body begins and ends along the axis of a body, from its origin [m].

    Args:
        body: That says where the axis lies.
        other: In line with it.
    """
    ends = [float((np.asarray(other.origin) + far * np.asarray(other.direction) - np.asarray(body.origin))
                  @ np.asarray(body.direction)) for far in (0.0, other.length)]  # fmt: skip
    return min(ends), max(ends)
