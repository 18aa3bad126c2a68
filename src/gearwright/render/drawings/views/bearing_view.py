"""Rolling bearings in section, simplified: boundary dimensions, rings, and the elements that their ratings assume."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from gearwright.catalogue import Bearing
from gearwright.parts.bearings import BearingKind
from gearwright.render.drawings.sheet.entities import Arc, Entity, Hatch, Layer, Path
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import Axis

SHOULDER = 0.5
"""Height of shoulders and lips over the middle of the rolling elements, in their radii [-]; drawn only."""
_FINE = 1.5
"""Between hatching lines [mm]."""


def bearing_section(axis: Axis, bearing: Bearing, middle: float, *, opens: float) -> list[Entity]:
    """Return a bearing in section, both halves.

    Args:
        axis: Of its shaft.
        bearing: From the catalogue.
        middle: Of its width along the shaft [mm].
        opens: +1 where the raceways of a taper bearing widen towards the second end, −1 towards the first [-].
    """
    draw = {BearingKind.CYLINDRICAL: _cylindrical, BearingKind.TAPER: _taper}.get(bearing.kind, _ball)
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        for part in draw(bearing, opens):
            entities += _placed(axis, part, middle, side)
    return entities


def _placed(axis: Axis, part: Entity, middle: float, side: float) -> Iterator[Entity]:
    """Yield a part of the upper half, about the middle of the bearing in mm, on its shaft."""

    def at(point: complex) -> complex:
        return axis.at(middle + point.real, side * point.imag)

    match part:
        case Path():
            yield Path(tuple(at(point) for point in part.points), part.layer, part.closed)
        case Arc():
            yield Arc(at(part.centre), part.radius * axis.scale, part.layer)
        case Hatch():
            yield Hatch(tuple(at(point) for point in part.points), part.angle + cmath.phase(axis.along), _FINE)


def _ring(corners: Sequence[complex], *, inner: bool) -> Iterator[Entity]:
    yield Hatch(tuple(corners), math.radians(135.0 if inner else 45.0))
    yield Path(tuple(corners), Layer.OUTLINE, closed=True)


def _sizes(bearing: Bearing) -> tuple[float, float, float, float, float]:
    """Return bore, outside and pitch radius, half width and radius of the rolling elements [mm]."""
    inside = bearing.geometry
    return (
        MM * bearing.bore / 2.0, MM * bearing.outer_diameter / 2.0, MM * inside.pitch_diameter / 2.0,
        MM * bearing.width / 2.0, MM * inside.diameter / 2.0,
    )  # fmt: skip


def _ball(bearing: Bearing, opens: float) -> Iterator[Entity]:
    del opens
    bore, outside, pitch, half, ball = _sizes(bearing)
    angle = math.acos(SHOULDER)
    for wall, side, inner in ((bore, -1.0, True), (outside, 1.0, False)):
        groove = [complex(0.0, pitch) + ball * 1j * side * cmath.rect(1.0, angle * (1.0 - k / 8.0)) for k in range(17)]
        shoulder = pitch + side * SHOULDER * ball
        first = math.copysign(half, groove[0].real)
        corners = [
            complex(-first, wall),
            complex(first, wall),
            complex(first, shoulder),
            *groove,
            complex(-first, shoulder),
        ]
        yield from _ring(corners, inner=inner)
    yield Arc(complex(0.0, pitch), ball, Layer.OUTLINE)
    if bearing.kind is BearingKind.FOUR_POINT:
        yield Path((complex(0.0, bore), complex(0.0, pitch - ball)), Layer.OUTLINE)


def _cylindrical(bearing: Bearing, opens: float) -> Iterator[Entity]:
    del opens
    bore, outside, pitch, half, roller = _sizes(bearing)
    length = MM * bearing.geometry.roller_length / 2.0
    low, high, lip = pitch - roller, pitch + roller, pitch + SHOULDER * roller
    yield from _ring([complex(-half, bore), complex(half, bore), complex(half, low), complex(-half, low)], inner=True)
    cup = [
        complex(-half, outside), complex(half, outside), complex(half, lip), complex(length, lip),
        complex(length, high), complex(-length, high), complex(-length, lip), complex(-half, lip),
    ]  # fmt: skip
    yield from _ring(cup, inner=False)
    yield from _roller(complex(0.0, pitch), length, roller, 0.0)


def _taper(bearing: Bearing, opens: float) -> Iterator[Entity]:
    bore, outside, pitch, half, roller = _sizes(bearing)
    angle = opens * bearing.geometry.contact_angle
    length = MM * bearing.geometry.roller_length / 2.0
    rise = math.tan(angle)
    for wall, side, inner in ((bore, -1.0, True), (outside, 1.0, False)):
        ends = [pitch + side * roller / math.cos(angle) + x * rise for x in (half, -half)]
        kept = [max(end, wall + 0.5) if inner else min(end, wall - 0.5) for end in ends]
        yield from _ring(
            [complex(-half, wall), complex(half, wall), complex(half, kept[0]), complex(-half, kept[1])], inner=inner
        )
    yield from _roller(complex(0.0, pitch), length, roller, angle)


def _roller(middle: complex, length: float, radius: float, angle: float) -> Iterator[Entity]:
    turn = cmath.rect(1.0, angle)
    corners = [
        middle + turn * complex(x, y)
        for x, y in ((-length, -radius), (length, -radius), (length, radius), (-length, radius))
    ]
    yield Path(tuple(corners), Layer.OUTLINE, closed=True)
    yield Path((middle - turn * 1.25 * length, middle + turn * 1.25 * length), Layer.CENTRE)
