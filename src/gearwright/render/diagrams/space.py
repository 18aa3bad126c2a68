"""Where axes stand, what they may not take, and what errors move."""

from __future__ import annotations

import cmath
import itertools
import math

from gearwright.parts.gears import CylindricalGear
from gearwright.render.diagrams.strokes import (
    DEGREE,
    across,
    axis,
    box,
    cross,
    leader,
    line,
    note,
    swept,
    toothed,
    up,
)
from gearwright.render.drawings.sheet.dimensions import arrow
from gearwright.render.drawings.sheet.entities import Arc, Entity, Layer, moved


def _axes(middle: complex, reach: float) -> list[Entity]:
    """Return the axes y and z of a cross-section, seen along x."""
    entities: list[Entity] = []
    for way, name, beside in ((1.0 + 0j, "y", 2.0 - 1.5j), (1j, "z", -1.0 + 2.0j)):
        tip = middle + reach * way
        entities += [line(middle, tip, layer=Layer.DIMENSION), arrow(tip, way), note(tip + beside, name, "left")]
    return entities


def angles() -> list[Entity]:
    """Two axes in the cross-section: the direction from the mate's to the shaft's own."""
    mate, shaft = 0j, cmath.rect(46.0, 50.0 * DEGREE)
    entities = [*_axes(mate, 62.0), Arc(mate, 28.0, Layer.PITCH), Arc(shaft, 18.0, Layer.PITCH)]
    entities += [*cross(shaft, 18.0), line(mate, shaft, layer=Layer.DIMENSION)]
    entities += swept(mate, (0.0, 50.0 * DEGREE), 38.0, complex(66.0, 16.0), "angle_deg")
    return [
        *entities,
        note(-36.0j, "shaft that it meshes with"),
        note(shaft + complex(16.0, 14.0), "this shaft", "left"),
    ]


def keep_out() -> list[Entity]:
    """A box and a cylinder that the gearbox may not take, from the first end of the first shaft."""
    entities: list[Entity] = [line(_seen(-8.0, 0.0, 0.0), _seen(110.0, 0.0, 0.0), layer=Layer.CENTRE)]
    for place, name in (((0.0, 34.0, 0.0), "y"), ((0.0, 0.0, 34.0), "z")):
        tip = _seen(*place)
        entities += [line(0j, tip, layer=Layer.DIMENSION), arrow(tip, tip / abs(tip)), note(tip + 2.0, name, "left")]
    low, high = (46.0, 40.0, 30.0), (84.0, 70.0, 52.0)
    entities += _edges(low, high)
    steps = [0j, _seen(low[0], 0.0, 0.0), _seen(low[0], low[1], 0.0), _seen(*low)]
    for first, second, key in zip(steps, steps[1:], ("x_mm", "y_mm", "z_mm"), strict=False):
        way = (second - first) / abs(second - first)
        entities += [line(first, second, layer=Layer.DIMENSION), arrow(second, way)]
        entities += [note((first + second) / 2.0 + complex(1.5, -5.0), key, "left")]
    entities += [note(_seen(*low) - complex(2.0, 3.0), "start", "right"), note(_seen(*high) + 2.0, "end", "left")]
    start, end, radius = complex(150.0, 20.0), complex(196.0, 20.0), 14.0
    entities += [axis(start, end), *(line(start + side, end + side) for side in (1j * radius, -1j * radius))]
    for middle in (start, end):
        entities += [_ellipse(middle, radius)]
    entities += up(end, end + 1j * radius, 206.0, "radius_mm")
    entities += [note(start - complex(2.0, 24.0), "start"), note(end - complex(-2.0, 24.0), "end")]
    return [*entities, note(complex(0.0, -17.0), "first end of the first shaft", "left")]


def _seen(x: float, y: float, z: float) -> complex:
    """Return a place in an oblique view: x to the right, y away to the upper right, z upwards."""
    return complex(x + 0.5 * y, z + 0.35 * y)


def _edges(low: tuple[float, float, float], high: tuple[float, float, float]) -> list[Entity]:
    """Return the edges of a box in the oblique view."""
    ends = list(itertools.product((0, 1), repeat=3))
    place = {at: _seen(*((low, high)[side][way] for way, side in enumerate(at))) for at in ends}
    return [line(place[a], place[b]) for a in ends for b in ends if a < b and sum(map(int.__ne__, a, b)) == 1]


def _ellipse(middle: complex, radius: float) -> Entity:
    """Return a circle seen aslant."""
    round_about = (math.tau * step / 48.0 for step in range(48))
    return line(
        *(middle + complex(0.35 * radius * math.cos(t), radius * math.sin(t)) for t in round_about), closed=True
    )


def errors() -> list[Entity]:
    """What errors move: the axis of a shaft, that of a gear on it, its teeth along and about it, a planet's pin."""
    entities = [*_offset_axes(), *moved(_pin(), complex(150.0, 0.0)), *moved(_along_axis(), complex(0.0, -92.0))]
    return [*entities, *moved(_clocked(), complex(150.0, -92.0))]


def _offset_axes() -> list[Entity]:
    """Return the drawn axis, the one that stands, and the one of the gear that runs about it."""
    standing = cmath.rect(34.0, 25.0 * DEGREE)
    own = standing + cmath.rect(18.0, 75.0 * DEGREE)
    entities = [*_axes(0j, 56.0), *cross(standing, 2.0), Arc(own, 24.0, Layer.PITCH), *cross(own, 2.0)]
    ways = (("radial_mm", "radial_angle_deg", 0j, standing, 24.0), ("eccentricity_mm", "phase_deg", standing, own, 9.0))
    for length, angle, start, end, radius in ways:
        way = (end - start) / abs(end - start)
        entities += [line(start, end, layer=Layer.DIMENSION), arrow(end, way)]
        entities += [line(start, start + radius + 5.0, layer=Layer.DIMENSION)]
        entities += [Arc(start, radius, Layer.DIMENSION, 0.0, cmath.phase(way))]
        entities += leader(start + cmath.rect(radius, 0.2), complex(64.0, start.imag - 6.0), angle)
        entities += leader(start + 0.7 * (end - start), complex(-4.0, 46.0 if start else 30.0), length)
    return [*entities, note(complex(-2.0, -6.0), "as drawn", "left")]


def _pin() -> list[Entity]:
    """Return a planet's pin that stands too far out and ahead."""
    distance, drawn, away, ahead = 44.0, 0.0 + 12.0j, 12.0, 16.0
    centre = drawn - 1j * distance
    entities: list[Entity] = [Arc(centre, distance, Layer.PITCH, 40.0 * DEGREE, 140.0 * DEGREE), *cross(centre, 4.0)]
    entities += [Arc(drawn, 8.0, Layer.HIDDEN), axis(drawn - 10j, drawn + 26j)]
    there = drawn + complex(-ahead, away)
    entities += [Arc(there, 8.0, Layer.OUTLINE), *cross(there, 8.0)]
    entities += [*up(drawn, there, 14.0, "pin_radial_mm"), across(there, drawn, 44.0, "pin_tangential_mm")]
    entities += [Arc(centre, 14.0, Layer.DIMENSION, 60.0 * DEGREE, 115.0 * DEGREE)]
    tip = cmath.rect(14.0, 117.0 * DEGREE)
    return [
        *entities,
        arrow(centre + tip, cmath.rect(1.0, 198.0 * DEGREE)),
        note(centre + complex(-10.0, 14.0), "positive", "right"),
    ]


def _along_axis() -> list[Entity]:
    """Return a gear that sits further along its shaft than drawn."""
    entities: list[Entity] = [*box(-7j, complex(96.0, 7.0)), axis(0j, complex(96.0))]
    for low, high in ((7.0, 26.0), (-26.0, -7.0)):
        corners = (complex(26.0, low), complex(50.0, low), complex(50.0, high), complex(26.0, high))
        entities += [line(*corners, layer=Layer.HIDDEN, closed=True), line(*(p + 12.0 for p in corners), closed=True)]
    entities += [across(complex(26.0, 26.0), complex(38.0, 26.0), 34.0, "axial_mm")]
    tip = complex(108.0)
    return [
        *entities,
        line(complex(96.0), tip, layer=Layer.DIMENSION),
        arrow(tip, 1.0 + 0j),
        note(tip + 2.0, "x", "left"),
    ]


def _clocked() -> list[Entity]:
    """Return a gear that is turned on its shaft."""
    gear = CylindricalGear(18, 2.6, 1.0)
    entities = [
        *toothed(gear, 0j, math.pi / 2.0 - 8.0 * DEGREE),
        Arc(0j, 8.0, Layer.OUTLINE),
        *cross(0j, gear.tip_radius),
    ]
    entities += swept(0j, (82.0 * DEGREE, 90.0 * DEGREE), 34.0, complex(24.0, 34.0), "clocking_deg")
    return entities
