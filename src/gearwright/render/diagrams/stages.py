"""What planetary sets, compound sets and what their planets turn on are measured by."""

from __future__ import annotations

import cmath
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
    mirrored,
    note,
    toothed,
    up,
)
from gearwright.render.drawings.sheet.entities import Arc, Entity, Layer


def planetary() -> list[Entity]:
    """A planetary set along its axis, and its upper half in section."""
    sun, planet, ring = (CylindricalGear(teeth, 1.9, 1.0) for teeth in (24, 18, -60))
    distance, rim, bore, hub = sun.pitch_radius + planet.pitch_radius, 66.0, 10.0, 9.0
    entities: list[Entity] = [*toothed(sun, 0j), *toothed(ring, 0j), *cross(0j, rim)]
    entities += [Arc(0j, radius, Layer.OUTLINE) for radius in (hub, rim)]
    for place in (90.0, 210.0, 330.0):
        middle = cmath.rect(distance, place * DEGREE)
        entities += toothed(planet, middle, place * DEGREE + math.pi / 18.0)
        entities += [Arc(middle, radius, Layer.OUTLINE) for radius in (7.0, bore)]
    entities += [line(complex(-8.0, distance), complex(8.0, distance), layer=Layer.CENTRE)]
    entities += up(0j, 1j * distance, -76.0, "centre_distance_mm", left=True)
    entities += leader(cmath.rect(hub, 235.0 * DEGREE), complex(-60.0, -54.0), "sun_bore_mm")
    entities += leader(cmath.rect(distance, 210.0 * DEGREE), complex(-74.0, -28.0), "pin_position_mm")
    names = (
        (complex(12.0, -12.0), "sun"),
        (cmath.rect(distance, 330.0 * DEGREE) + 12.0, "planet"),
        (complex(46.0, 46.0), "ring"),
    )
    for (target, text), place in zip(names, (-16.0, -36.0, 66.0), strict=True):
        entities += leader(target, complex(74.0, place), text)
    start, end = 124.0, 152.0
    entities += [*box(complex(start, ring.tip_radius), complex(end, rim), cut=True)]
    for low, high in ((distance - planet.tip_radius, distance - bore), (distance + bore, distance + planet.tip_radius)):
        entities += box(complex(start, low), complex(end, high), cut=True)
    entities += box(complex(start, hub), complex(end, sun.tip_radius), cut=True)
    entities += [*box(complex(start - 18.0, 28.0), complex(start - 5.0, distance + 14.0), cut=True)]
    entities += box(complex(start - 18.0, distance - 7.0), complex(end, distance + 7.0))
    entities += [
        axis(complex(start - 18.0), complex(end)),
        axis(complex(start - 18.0, distance), complex(end, distance)),
    ]
    for height in (sun.pitch_radius, ring.pitch_radius):
        entities += [line(complex(start - 2.0, height), complex(end + 2.0, height), layer=Layer.PITCH)]
    entities += [across(complex(start, 0.0), complex(end, 0.0), -14.0, "face_width_mm")]
    entities += [across(complex(start - 18.0, 28.0), complex(start - 5.0, 28.0), -26.0, "plate_thickness_mm")]
    entities += up(complex(end, distance - 7.0), complex(end, distance + 7.0), 164.0, "pin_diameter_mm")
    entities += leader(complex(end, distance + bore), complex(166.0, distance + 22.0), "planet_bore_mm / 2")
    eye = complex(start - 18.0, distance)
    entities += up(eye + 7.0j, eye + 14.0j, start - 26.0, "eye_wall_mm", left=True)
    entities += leader(complex(end, sun.pitch_radius), complex(166.0, 14.0), "z_{s} · module_mm / 2")
    return entities


def compound() -> list[Entity]:
    """A stepped planet between a sun and a ring, in section."""
    distance = 46.0
    first, second = (28.0, 44.0), (64.0, 84.0)
    entities: list[Entity] = [*box(complex(0.0, 24.0), complex(14.0, distance + 16.0), cut=True)]
    for span, inner, outer in (((28.0, 44.0), 8.0, 26.0), ((44.0, 84.0), 8.0, 15.0)):
        entities += box(complex(span[0], distance + inner), complex(span[1], distance + outer), cut=True)
        entities += box(complex(span[0], distance - outer), complex(span[1], distance - inner), cut=True)
    entities += box(complex(0.0, distance - 6.0), complex(84.0, distance + 6.0))
    entities += [*box(complex(first[0], 8.0), complex(first[1], 20.0), cut=True)]
    entities += box(complex(second[0], distance + 15.0), complex(second[1], distance + 25.0), cut=True)
    entities += [axis(0j, complex(84.0)), axis(complex(0.0, distance), complex(84.0, distance))]
    plate, middles = complex(14.0, 24.0), [complex(sum(span) / 2.0, 0.0) for span in (first, second)]
    entities += [line(middle - 12.0j, middle + 80.0j, layer=Layer.CENTRE) for middle in middles]
    entities += [across(plate, middles[0], -8.0, "place_mm", complex(-2.0, -7.0))]
    entities += [across(plate, middles[1], -18.0, "place_mm")]
    entities += [across(complex(0.0, 62.0), complex(14.0, 62.0), 76.0, "plate_thickness_mm", complex(-20.0, 77.0))]
    entities += [across(complex(second[0], 71.0), complex(second[1], 71.0), 82.0, "face_width_mm")]
    entities += up(0j, complex(0.0, distance), -14.0, "centre_distance_mm", left=True)
    entities += up(complex(0.0, distance + 6.0), complex(0.0, distance + 16.0), -6.0, "eye_wall_mm", left=True)
    entities += up(complex(84.0, distance - 6.0), complex(84.0, distance + 6.0), 98.0, "pin_diameter_mm")
    entities += leader(complex(first[1], 8.0), complex(54.0, 4.0), "bore_mm / 2")
    entities += leader(complex(78.0, distance - 8.0), complex(92.0, 28.0), "bore_mm / 2")
    entities += leader(complex(88.0, distance), complex(104.0, 36.0), "pin_position_mm")
    entities += leader(complex(first[1], 18.5), complex(60.0, 12.0), "z · module_mm / 2")
    return [*entities, note(complex(26.0, 2.0), "sun", "right"), note(complex(88.0, 64.0), "ring", "left")]


def planet_bearing() -> list[Entity]:
    """What a planet turns on: rollers on its pin, two rows or a film of oil."""
    half, pin, rollers = 40.0, 14.0, 7.0
    entities: list[Entity] = []
    entities += mirrored(complex(-half, pin + rollers), complex(half, pin + rollers + 14.0), cut=True)
    entities += box(complex(-half - 12.0, -pin), complex(half + 12.0, pin))
    for middle in (-20.0, 20.0):
        for side in (1.0, -1.0):
            low = side * pin if side > 0.0 else -pin - rollers
            entities += box(complex(middle - 15.0, low), complex(middle + 15.0, low + rollers))
        entities += [axis(complex(middle, -pin - rollers), complex(middle, pin + rollers + 16.0))]
    entities += [axis(complex(-half - 12.0), complex(half + 12.0))]
    top = pin + rollers + 14.0
    entities += [across(complex(-20.0, top), complex(20.0, top), top + 8.0, "spacing_mm")]
    entities += [across(complex(5.0, -pin - rollers), complex(35.0, -pin - rollers), -top - 8.0, "width_mm")]
    entities += up(complex(-half - 12.0, -pin), complex(-half - 12.0, pin), -66.0, "diameter_mm", left=True)
    entities += up(complex(35.0, pin), complex(35.0, pin + rollers), 58.0, "roller_diameter_mm")
    film = complex(152.0, 0.0)
    entities += [Arc(film, 36.0, Layer.OUTLINE), Arc(film, 24.0, Layer.OUTLINE), *cross(film, 36.0)]
    entities += [Arc(film - 5.0j, 16.0, Layer.OUTLINE), *cross(film - 5.0j, 16.0)]
    entities += leader(film - 22.5j, film + complex(24.0, -40.0), "least_film_mm")
    entities += [note(film + 42.0j, "a plain bearing, its play enlarged")]
    return entities
