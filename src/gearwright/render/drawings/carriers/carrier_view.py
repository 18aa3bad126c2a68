"""A carrier in section through a pin, and seen along its axis."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.drawings.sheet.entities import TEXT, Arc, Distance, Entity, Hatch, Layer, Path, Words
from gearwright.render.drawings.sheet.tolerances import HIGH, Tolerance, datum, tolerance_frame
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis
from gearwright.shape.carriers import plate_outline
from gearwright.shape.solids import Arm, circle, plate_form
from gearwright.sizing.mass import Cage, Plate
from gearwright.sizing.places import along_body

ASIDE, LEVEL = 9.0, 8.0
"""From a part to its nearest dimension line, and between parallel ones [mm]."""
LEAN = (math.pi / 4.0, 3.0 * math.pi / 4.0)
"""Of the hatching of plates and of pins [rad]."""
AROUND = 720
"""Corners of an outline [-]."""
KNEE = 8.0
"""Of a leader beyond the plate [mm]."""


@dataclass(frozen=True)
class Drawn:
    """A carrier as its sheet shows it; the first pin stands on top, lengths in mm from the first plate's outer end."""

    cage: Cage
    held: tuple[Arm, ...]
    """Eyes and bridges, turned so that the first eye is on top [m]."""
    plates: tuple[tuple[float, float, Plate], ...]
    """Where each begins and ends, from the left [mm]."""
    pins: tuple[float, float]
    """Where they begin and end [mm]."""

    @property
    def eyes(self) -> tuple[Arm, ...]:
        """Around pins."""
        return tuple(arm for arm in self.held if arm.is_round)


def drawn_carrier(cage: Cage, held: Sequence[Arm], *, along: float) -> Drawn:
    """Return a carrier as its sheet shows it, seen from its left end.

    Args:
        cage: As made.
        held: Its eyes and bridges about its axis.
        along: Positive where the axis of their angles goes from left to right, away from who looks [-].
    """
    top = max((arm for arm in held if arm.is_round), key=lambda arm: round(arm.radius, 9))
    sense = -1.0 if along > 0.0 else 1.0
    first, zero = cage.plates[0].body, cage.whole[0]
    ends = [along_body(first, own.body) for own in cage.plates]
    spans = [(MM * (low - zero), MM * (high - zero), own) for (low, high), own in zip(ends, cage.plates, strict=True)]
    turned = [arm._replace(angle=math.pi / 2.0 + sense * (arm.angle - top.angle)) for arm in held]
    turned.sort(key=lambda arm: round(_from_top(arm), 6))
    return Drawn(
        cage, tuple(turned), tuple(sorted(spans, key=lambda span: span[0])), (0.0, MM * (cage.whole[1] - zero))
    )


def _from_top(arm: Arm) -> float:
    return (arm.angle - math.pi / 2.0 + 1e-9) % (2.0 * math.pi)


def places_of(drawn: Drawn) -> tuple[tuple[float, float], ...]:
    """Return where pins stand: angle from the one on top, counter-clockwise [°], and radius of their circle [mm].

    Args:
        drawn: The carrier.
    """
    return tuple((round(math.degrees(_from_top(eye)), 4), MM * eye.radius) for eye in drawn.eyes)


def is_even(drawn: Drawn) -> bool:
    """Tell whether pins stand evenly on one circle.

    Args:
        drawn: The carrier.
    """
    places = places_of(drawn)
    return all(abs(angle - 360.0 * k / len(places)) < 1e-3 and math.isclose(radius, places[0][1], rel_tol=1e-9)
               for k, (angle, radius) in enumerate(places))  # fmt: skip


def outline_radii(drawn: Drawn, own: Plate, angles: Floats) -> Floats:
    """Return the outline of a plate [mm].

    Args:
        drawn: The carrier.
        own: One of its plates.
        angles: [rad]
    """
    return np.asarray(MM * plate_form(drawn.held, plate_outline(own)).radii(angles))


def section(drawn: Drawn, axis: Axis) -> list[Entity]:
    """Return the section through the pin on top and through what stands opposite.

    Args:
        drawn: The carrier.
        axis: On paper.
    """
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(drawn.pins[0] - beyond), axis.at(drawn.pins[1] + beyond)), Layer.CENTRE)]
    entities += _half(drawn, axis, drawn.eyes[0], 1.0)
    below = next((arm for arm in drawn.held if _is_below(arm)), None)
    if below is not None and below.is_round:
        entities += _half(drawn, axis, below, -1.0)
    else:
        entities += _opposite(drawn, axis, below)
    for start, end, own in drawn.plates:
        for x in (start, end) if own.bore else ():
            entities.append(Path((axis.at(x, -MM * own.bore), axis.at(x, MM * own.bore)), Layer.OUTLINE))
    return entities


def _is_below(arm: Arm) -> bool:
    return abs(cmath.phase(cmath.rect(1.0, arm.angle + math.pi / 2.0))) < 1e-6


def _half(drawn: Drawn, axis: Axis, eye: Arm, side: float) -> Iterator[Entity]:
    """Yield plates and a pin in section, on one side of the axis."""
    middle, pin, hollow = MM * eye.radius, MM * drawn.cage.pin_diameter / 2.0, MM * drawn.cage.pin_bore / 2.0
    for start, end, own in drawn.plates:
        top = float(outline_radii(drawn, own, np.array([math.pi / 2.0]))[0]) if side > 0.0 else middle + MM * eye.half
        for low, high in ((MM * own.bore, middle - pin), (middle + pin, top)):
            yield from _cut(axis, (start, end), (side * low, side * high), LEAN[0])
    start, end = drawn.pins
    walls = (
        [(middle - pin, middle - hollow), (middle + hollow, middle + pin)] if hollow else [(middle - pin, middle + pin)]
    )
    for low, high in walls:
        yield from _cut(axis, (start, end), (side * low, side * high), LEAN[1])
    if hollow:
        for x in drawn.pins:
            yield Path((axis.at(x, side * (middle - hollow)), axis.at(x, side * (middle + hollow))), Layer.OUTLINE)
    more = OVERSHOOT / axis.scale
    yield Path((axis.at(start - more, side * middle), axis.at(end + more, side * middle)), Layer.CENTRE)


def _opposite(drawn: Drawn, axis: Axis, bridge: Arm | None) -> Iterator[Entity]:
    """Yield what stands opposite of the pin: plates with a bridge between them, one piece, or plates alone."""
    below = np.array([-math.pi / 2.0])
    spans = [
        (start, end, MM * own.bore, float(outline_radii(drawn, own, below)[0])) for start, end, own in drawn.plates
    ]
    if bridge is None or len(spans) < 2:
        for start, end, bore, top in spans:
            yield from _cut(axis, (start, end), (-bore, -top), LEAN[0])
        return
    (a, b, hole, top), (c, d, other, reach) = spans
    low, high = MM * bridge.inner, MM * bridge.radius
    corners = [(a, hole), (b, hole), (b, low), (c, low), (c, other), (d, other), (d, reach), (c, reach), (c, high),
               (b, high), (b, top), (a, top)]  # fmt: skip
    points = tuple(axis.at(x, -radius) for x, radius in corners)
    yield from (Hatch(points, LEAN[0]), Path(points, Layer.OUTLINE, closed=True))


def _cut(axis: Axis, span: tuple[float, float], radii: tuple[float, float], lean: float) -> Iterator[Entity]:
    corners = tuple(axis.at(x, radius) for x, radius in
                    ((span[0], radii[0]), (span[1], radii[0]), (span[1], radii[1]), (span[0], radii[1])))  # fmt: skip
    yield from (Hatch(corners, lean, 2.0 if lean == LEAN[1] else 3.0), Path(corners, Layer.OUTLINE, closed=True))


def section_dimensions(drawn: Drawn, axis: Axis, fits: tuple[str, str], *, letter: str) -> Iterator[Entity]:
    """Yield diameters on both sides and lengths below.

    Args:
        drawn: The carrier.
        axis: On paper.
        fits: Of the pins in their holes, and after the diameter of the hole in the plate with the datum.
        letter: Of the datum; empty: none.
    """
    left, right = drawn.plates[0], drawn.plates[-1]
    reach = MM * max(own.body.radius for _, _, own in drawn.plates)
    eye, level = MM * drawn.eyes[0].radius, ASIDE
    bores = [(left, left[0], -1.0)] if len(drawn.plates) == 1 else [(left, left[0], -1.0), (right, right[1], 1.0)]
    for (_, _, own), x, way in bores:
        if own.bore:
            half = MM * own.bore
            low, high = axis.at(x, -half), axis.at(x, half)
            yield Distance(low, high, high + way * level, math.pi / 2.0, axis.scale, "Ø")
            if letter and own is drawn.cage.plates[0]:
                yield from datum(low + way * level, -1j, letter)
    start, end = drawn.pins
    far = axis.at(end).real + ASIDE + LEVEL
    pin = MM * drawn.cage.pin_diameter / 2.0
    for radius, row in ((eye, 0), (reach, 1)):
        low, high = axis.at(end, -radius), axis.at(end, radius)
        yield Distance(low, high, complex(far + LEVEL * row, 0.0), math.pi / 2.0, axis.scale, "Ø")
    low, high = axis.at(start, eye - pin), axis.at(start, eye + pin)
    yield Distance(low, high, high - ASIDE, math.pi / 2.0, axis.scale, "Ø", fits[0])
    if drawn.cage.pin_bore:
        hollow = MM * drawn.cage.pin_bore / 2.0
        low, high = axis.at(start, eye - hollow), axis.at(start, eye + hollow)
        yield Distance(low, high, high - ASIDE - LEVEL, math.pi / 2.0, axis.scale, "Ø")
    foot = axis.at(0.0, -reach) - 1j * ASIDE
    spans = [(a, b) for a, b, _ in drawn.plates]
    spans += [(left[1], right[0])] if len(drawn.plates) > 1 else []
    below = -min(float(outline_radii(drawn, own, np.array([-math.pi / 2.0]))[0]) for _, _, own in drawn.plates)
    for k, (a, b) in enumerate([*spans, drawn.pins]):
        yield Distance(axis.at(a, below), axis.at(b, below), foot - 1j * LEVEL * k, 0.0, axis.scale)


def end_view(drawn: Drawn, axis: Axis, words: str, tolerance: Tolerance | None) -> list[Entity]:
    """Return a carrier seen from its left end: outline, pins on their circle, bridges behind the plate.

    Args:
        drawn: The carrier.
        axis: Its origin is the middle.
        words: Of the holes, at the leader.
        tolerance: Of their places.
    """
    _, _, own = drawn.plates[0]
    angles = circle(AROUND)
    radii = outline_radii(drawn, own, angles)
    outline = tuple(axis.on(complex(cmath.rect(float(r), float(a)))) for r, a in zip(radii, angles, strict=True))
    entities: list[Entity] = [Path(outline, Layer.OUTLINE, closed=True)]
    if own.bore:
        entities.append(Arc(axis.at(0.0), axis.scale * MM * own.bore, Layer.OUTLINE))
    for arm in drawn.held:
        entities += _pin(drawn, axis, arm) if arm.is_round else [_bridge(axis, arm)]
    entities += [Arc(axis.at(0.0), axis.scale * radius, Layer.CENTRE)
                 for radius in sorted({round(MM * eye.radius, 6) for eye in drawn.eyes})]  # fmt: skip
    reach = axis.scale * MM * own.body.radius
    entities += [Path((axis.origin - way, axis.origin + way), Layer.CENTRE)
                 for way in (reach + OVERSHOOT, 1j * (reach + OVERSHOOT))]  # fmt: skip
    return [*entities, *_leader(drawn, axis, words, tolerance)]


def _pin(drawn: Drawn, axis: Axis, eye: Arm) -> Iterator[Entity]:
    middle, out = axis.on(complex(cmath.rect(MM * eye.radius, eye.angle))), cmath.rect(1.0, eye.angle)
    pin = axis.scale * MM * drawn.cage.pin_diameter / 2.0
    yield Arc(middle, pin, Layer.OUTLINE)
    if drawn.cage.pin_bore:
        yield Arc(middle, axis.scale * MM * drawn.cage.pin_bore / 2.0, Layer.OUTLINE)
    if abs(out.real) > 1e-9 and abs(out.imag) > 1e-9:
        yield Path((middle - (pin + 2.0) * out, middle + (pin + 2.0) * out), Layer.CENTRE)


def _bridge(axis: Axis, arm: Arm) -> Path:
    along, across = cmath.rect(1.0, arm.angle), cmath.rect(1.0, arm.angle + math.pi / 2.0)
    corners = ((arm.inner, -arm.half), (arm.radius, -arm.half), (arm.radius, arm.half), (arm.inner, arm.half))
    return Path(tuple(axis.on(MM * (x * along + y * across)) for x, y in corners), Layer.HIDDEN, closed=True)


def _leader(drawn: Drawn, axis: Axis, words: str, tolerance: Tolerance | None) -> Iterator[Entity]:
    """Yield what is said of the holes for pins, beside the one on top, clear of the plate."""
    eye, reach = drawn.eyes[0], axis.scale * MM * max(own.body.radius for _, _, own in drawn.plates)
    middle = axis.on(complex(cmath.rect(MM * eye.radius, eye.angle)))
    target = middle + cmath.rect(axis.scale * MM * drawn.cage.pin_diameter / 2.0, math.pi / 4.0)
    level = axis.origin.imag + reach + KNEE
    knee = complex(target.real + (level - target.imag), level)
    written = Words(knee + 2.0 + 1.0j, words, TEXT, "left", layer=Layer.DIMENSION)
    yield Path((target, knee, knee + 4.0 + written.length), Layer.DIMENSION)
    yield written
    if tolerance is not None:
        yield from tolerance_frame(knee + 2.0 - 1j * (1.5 + HIGH / 2.0), tolerance)
