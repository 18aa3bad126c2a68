"""What shafts, their bearings, their joints and machines are measured by."""

from __future__ import annotations

import cmath
import math

from gearwright.parts.gears import CylindricalGear
from gearwright.render.diagrams.strokes import across, axis, box, cross, leader, line, mirrored, note, toothed, up
from gearwright.render.drawings.sheet.entities import Arc, Entity, Layer, moved


def _bearing(middle: float, bore: float, outer: float, width: float) -> list[Entity]:
    """Return a bearing in section about the axis y = 0."""
    low, high = complex(middle - width / 2.0, bore), complex(middle + width / 2.0, outer)
    ends = ((low, high), (complex(low.real, high.imag), complex(high.real, low.imag)))
    lines = [line(a, b, layer=Layer.THIN) for a, b in ends]
    return [*mirrored(low, high), *lines, *(line(a.conjugate(), b.conjugate(), layer=Layer.THIN) for a, b in ends)]


def solid(start: float, end: float, radius: float) -> list[Entity]:
    """Return a solid shaft about the axis y = 0.

    Args:
        start: Its first end [mm].
        end: Its second end [mm].
        radius: [mm].
    """
    return box(complex(start, -radius), complex(end, radius))


def layout() -> list[Entity]:
    """A shaft from its first end: length, diameters, and where bearings and gears sit."""
    length, radius, bore, bearings, gear = 150.0, 12.0, 5.0, (18.0, 128.0), 78.0
    entities: list[Entity] = [*mirrored(complex(0.0, bore), complex(length, radius), cut=True)]
    for middle in bearings:
        entities += _bearing(middle, radius, 24.0, 14.0)
        entities += [axis(complex(middle, -24.0), complex(middle, 24.0))]
    entities += [*mirrored(complex(gear - 12.0, radius), complex(gear + 12.0, 34.0), cut=True)]
    entities += [axis(complex(gear, -34.0), complex(gear, 34.0)), axis(0j, complex(length))]
    first = complex(0.0, -radius)
    entities += [across(first, complex(bearings[0], -24.0), -32.0, "first_bearing_mm", complex(44.0, -31.0))]
    entities += [across(first, complex(gear, -34.0), -44.0, "position_mm")]
    entities += [across(first, complex(bearings[1], -24.0), -54.0, "second_bearing_mm")]
    entities += [across(first, complex(length, -radius), -64.0, "length_mm")]
    entities += up(complex(0.0, -bore), complex(0.0, bore), -10.0, "bore_mm", left=True)
    entities += up(complex(length, -radius), complex(length, radius), 162.0, "diameter_mm")
    return [*entities, note(complex(0.0, 30.0), "first end"), note(complex(length, 30.0), "second end")]


def seat() -> list[Entity]:
    """A bearing of a shaft in its housing."""
    entities: list[Entity] = [*solid(0.0, 110.0, 14.0)]
    entities += [*_bearing(64.0, 14.0, 32.0, 20.0), axis(0j, complex(110.0)), axis(-32j + 64.0, 32j + 64.0)]
    entities += mirrored(complex(54.0, 32.0), complex(74.0, 42.0), cut=True)
    entities += mirrored(complex(74.0, 20.0), complex(82.0, 42.0), cut=True)
    entities += mirrored(complex(82.0, 34.0), complex(116.0, 42.0), cut=True)
    entities += [across(complex(0.0, -14.0), complex(64.0, -42.0), -52.0, "position_mm")]
    entities += up(complex(110.0, -14.0), complex(110.0, 14.0), 124.0, "bore_mm")
    entities += up(complex(54.0, -32.0), complex(54.0, 32.0), -6.0, "largest_outer_diameter_mm", left=True)
    entities += up(complex(116.0, 34.0), complex(116.0, 42.0), 124.0, "wall_mm")
    return [*entities, note(complex(0.0, 18.0), "first end", "left")]


def joint() -> list[Entity]:
    """A key, a spline and a press fit."""
    entities: list[Entity] = [*solid(-14.0, 64.0, 14.0), axis(complex(-14.0), complex(64.0))]
    entities += mirrored(complex(0.0, 14.0), complex(50.0, 30.0), cut=True)
    key = [complex(8.0 + 4.0, 10.0), complex(42.0 - 4.0, 10.0), complex(42.0 - 4.0, 18.0), complex(12.0, 18.0)]
    entities += [*box(complex(8.0, 10.0), complex(42.0, 18.0)), line(key[0], key[3]), line(key[1], key[2])]
    entities += [across(key[3], key[2], 38.0, "length_mm"), across(30j + 0.0, 30j + 50.0, 46.0, "hub_length_mm")]
    entities += up(complex(-14.0, -14.0), complex(-14.0, 14.0), -24.0, "diameter_mm", left=True)
    spline, middle = CylindricalGear(14, 4.0, 1.0), complex(108.0)
    entities += [*toothed(spline, middle), *cross(middle, 30.0)]
    entities += leader(middle + cmath.rect(28.0, 0.5), middle + complex(30.0, 35.0), "z · module_mm / 2")
    fit = 160.0
    entities += [
        *mirrored(complex(fit, 14.0), complex(fit + 26.0, 30.0), cut=True),
        axis(complex(fit), complex(fit + 70.0)),
    ]
    entities += [*solid(fit + 34.0, fit + 70.0, 17.0)]
    entities += [line(complex(fit + 26.0, 14.0), complex(fit + 34.0, 14.0), layer=Layer.DIMENSION)]
    entities += leader(complex(fit + 34.0, 15.5), complex(fit + 40.0, 40.0), "interference_mm / 2")
    captions = ((25.0, "key"), (108.0, "spline"), (fit + 34.0, "press fit, before it is joined"))
    return [*entities, *(note(complex(place, -42.0), text) for place, text in captions)]


def shafting() -> list[Entity]:
    """Lengths of shafts that a design leaves open: with planetary sets, with gears of pairs, one in another."""
    entities: list[Entity] = [axis(0j, complex(170.0))]
    places = ((0.0, 24.0, "machine"), (64.0, 88.0, "set"), (116.0, 140.0, "set"))
    for start, end, name in places:
        entities += [*box(complex(start, -14.0), complex(end, 14.0)), note(complex((start + end) / 2.0, -22.0), name)]
    entities += [*solid(24.0, 64.0, 4.0), *solid(88.0, 116.0, 4.0)]
    entities += [across(complex(24.0, 14.0), complex(64.0, 14.0), 22.0, "end_length_mm", complex(40.0, 23.0))]
    entities += [across(complex(88.0, 14.0), complex(116.0, 14.0), 22.0, "middle_length_mm", complex(128.0, 23.0))]
    entities += moved(_side_by_side(), -62.0j)
    return [*entities, *moved(_nested(), complex(142.0, -62.0))]


def _side_by_side() -> list[Entity]:
    """Return a shaft with gears of pairs, and the gaps between them and at both ends."""
    gap, faces = 16.0, ((16.0, 40.0, 18.0), (56.0, 76.0, 24.0))
    entities: list[Entity] = [*solid(0.0, 92.0, 6.0), axis(0j, complex(92.0))]
    for start, end, radius in faces:
        entities += mirrored(complex(start, 6.0), complex(end, radius), cut=True)
    for middle in (gap / 2.0, 92.0 - gap / 2.0):
        entities += _bearing(middle, 6.0, 13.0, 8.0)
    for start in (0.0, 40.0, 76.0):
        ends = complex(start, -13.0), complex(start + gap, -13.0)
        entities += [across(*ends, -32.0, "bearing_length_mm" if start == 76.0 else "")]
    return entities


def _nested() -> list[Entity]:
    """Return a shaft that goes through another."""
    entities: list[Entity] = [*solid(0.0, 50.0, 7.0), axis(0j, complex(50.0))]
    entities += mirrored(complex(8.0, 12.0), complex(42.0, 18.0), cut=True)
    return [*entities, *up(complex(42.0, 7.0), complex(42.0, 12.0), 54.0, "radial_gap_mm")]


def machines() -> list[Entity]:
    """Discs of machines: a turbine's last, a propeller's and a rotor's."""
    entities: list[Entity] = [
        *mirrored(complex(-4.0, 0.0), complex(4.0, 18.0), cut=True),
        axis(complex(-8.0), complex(18.0)),
    ]
    entities += up(complex(-4.0, -18.0), complex(-4.0, 18.0), -14.0, "diameter_mm", left=True)
    for middle, radius, blades in ((complex(66.0), 30.0, 4), (complex(182.0), 38.0, 5)):
        entities += [Arc(middle, radius, Layer.CENTRE), Arc(middle, 4.0, Layer.OUTLINE)]
        for blade in range(blades):
            ray = cmath.rect(1.0, math.pi / 2.0 + math.tau * blade / blades)
            chord = [ray * complex(*corner) for corner in ((4.0, -1.5), (radius, -2.5), (radius, 2.0), (4.0, 1.5))]
            entities += [line(*(middle + corner for corner in chord), closed=True)]
        entities += up(middle - 1j * radius, middle + 1j * radius, middle.real + radius + 8.0, "diameter_mm")
    captions = ((0.0, "turbine"), (66.0, "propeller"), (182.0, "rotor"))
    return [*entities, *(note(complex(place, -50.0), text) for place, text in captions)]
