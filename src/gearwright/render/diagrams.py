"""Diagrams of the design file: sketches whose dimensions say the keys of its lengths and angles.

Each says what its keys measure; drawings of sized parts are in `render/drawings`, whose strokes these are made of.
"""

import cmath
import itertools
import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from gearwright.parts.gears import CylindricalGear, half_angle_at
from gearwright.render.drawings.entities import (
    ARROW,
    GAP,
    OUTSIDE,
    TEXT,
    Arc,
    Distance,
    Entity,
    Hatch,
    Layer,
    Path,
    Words,
    arrow,
    drawn,
    extent,
    moved,
)
from gearwright.render.drawings.paper import Sheet, Size
from gearwright.render.drawings.writers import sheet_svg

# ----------------------------------------------------------------------------------------------------------------------
# A diagram of a design file's keys: what each length and angle is measured from.
# ----------------------------------------------------------------------------------------------------------------------


MARGIN = 5.0
"""Around what is drawn [mm]."""
_KEY = re.compile(r"\b[a-z]+(?:_[a-z]+)*_(?:mm|deg)\b")


@dataclass(frozen=True)
class Diagram:
    """A sketch whose dimensions say keys."""

    name: str
    title: str
    tables: tuple[str, ...]
    """Tables of the file whose keys it shows, such as ``pairs.NAME``; it stands at the first."""
    draw: Callable[[], list[Entity]]

    @cached_property
    def keys(self) -> frozenset[str]:
        """The keys that it names, with the unit that is shown first."""
        words = (mark.text for mark in drawn(self.draw()) if isinstance(mark, Words))
        return frozenset(key for text in words for key in _KEY.findall(text))

    def svg(self) -> str:
        """Return it as an SVG image."""
        entities = self.draw()
        left, low, right, high = extent(entities)
        size = Size("", right - left + 2.0 * MARGIN, high - low + 2.0 * MARGIN, (0, 0))
        corner = complex(MARGIN - left, MARGIN - low)
        return sheet_svg(Sheet(self.name, self.title, size, 1.0, tuple(moved(entities, corner))))


# ----------------------------------------------------------------------------------------------------------------------
# Strokes of diagrams: dimensions that say a key, leaders, and the outlines that they measure.
# ----------------------------------------------------------------------------------------------------------------------


DEGREE = math.pi / 180.0
"""[rad]"""
SHELF = 2.0
"""How far a leader runs along its words before them [mm]."""
BEYOND = 4.0
"""How far a centre line goes beyond what it is the centre of [mm]."""


def across(first: complex, second: complex, height: float, key: str, text_at: complex | None = None) -> Entity:
    """Return a dimension along x.

    Args:
        first: A point that it measures [mm].
        second: The other one [mm].
        height: Of its line [mm].
        key: What it says.
        text_at: Middle of the words' base line [mm]; left out: over the line or beyond its right end.
    """
    return Distance(first, second, complex(first.real, height), 0.0, 1.0, text_at=text_at, named=key)


def up(first: complex, second: complex, place: float, key: str, *, left: bool = False) -> list[Entity]:
    """Return a dimension along y, with words that lie beside its middle.

    Args:
        first: A point that it measures [mm].
        second: The other one [mm].
        place: Of its line along x [mm].
        key: What it says.
        left: Whether the words stand to the left of the line.
    """
    height = (first.imag + second.imag) / 2.0
    if abs((second - first).imag) < 2.0 * ARROW + GAP:
        height = max(first.imag, second.imag) + OUTSIDE
    side = -1.0 if left else 1.0
    words = Words(complex(place + 2.0 * side, height - TEXT / 2.0), key, TEXT, "right" if left else "left")
    return [Distance(first, second, complex(place, first.imag), math.pi / 2.0, 1.0, named=""), words]


def swept(centre: complex, rays: tuple[float, float], radius: float, at: complex, key: str) -> list[Entity]:
    """Return an angle between two rays, with words at a leader.

    Args:
        centre: Where the rays meet [mm].
        rays: Directions of the first and, counterclockwise from it, the second [rad].
        radius: Of the arc [mm].
        at: Where the leader meets the words [mm].
        key: What it says.
    """
    arc = Arc(centre, radius, Layer.DIMENSION, *rays)
    lines = [line(centre, centre + cmath.rect(radius + 4.0, ray), layer=Layer.DIMENSION) for ray in rays]
    middle = centre + cmath.rect(radius, sum(rays) / 2.0)
    return [arc, *lines, *leader(middle, at, key)]


def along(first: complex, second: complex, away: float, key: str) -> Entity:
    """Return a dimension from one point to another.

    Args:
        first: Where it begins [mm].
        second: Where it ends, to the right of the first [mm].
        away: From the points to its line, to the left of the way [mm].
        key: What it says.
    """
    way = (second - first) / abs(second - first)
    return Distance(first, second, first + away * 1j * way, cmath.phase(way), 1.0, named=key)


def leader(target: complex, at: complex, key: str) -> list[Entity]:
    """Return a word with an arrow from it to what it names.

    Args:
        target: Where the arrow points [mm].
        at: Where its line meets the words, which go on away from the target [mm].
        key: What it says.
    """
    side = 1.0 if at.real >= target.real else -1.0
    end = at + side * SHELF
    words = Words(end + complex(side * GAP, -TEXT / 2.0), key, TEXT, "left" if side > 0.0 else "right")
    return [Path((target, at, end), Layer.DIMENSION), arrow(target, (target - at) / abs(target - at)), words]


def line(*points: complex, layer: Layer = Layer.OUTLINE, closed: bool = False) -> Path:
    """Return straight lines from point to point.

    Args:
        points: At least two [mm].
        layer: How they are drawn.
        closed: Whether the last is joined with the first.
    """
    return Path(points, layer, closed)


def box(low: complex, high: complex, *, cut: bool = False, lean: float = math.pi / 4.0) -> list[Entity]:
    """Return a rectangle, hatched where it is cut.

    Args:
        low: Its lower left corner [mm].
        high: Its upper right corner [mm].
        cut: Whether it is a section.
        lean: Angle of the hatching [rad].
    """
    corners = (low, complex(high.real, low.imag), high, complex(low.real, high.imag))
    return [*([Hatch(corners, lean)] if cut else []), Path(corners, Layer.OUTLINE, closed=True)]


def mirrored(low: complex, high: complex, *, cut: bool = False) -> list[Entity]:
    """Return a rectangle above the axis y = 0 and the one below it.

    Args:
        low: Lower left corner of the upper one [mm].
        high: Its upper right corner [mm].
        cut: Whether they are sections.
    """
    below = box(complex(low.real, -high.imag), complex(high.real, -low.imag), cut=cut, lean=-math.pi / 4.0)
    return [*box(low, high, cut=cut), *below]


def axis(start: complex, end: complex) -> Path:
    """Return a centre line, a little longer than what it is the centre of.

    Args:
        start: Of that [mm].
        end: Of that [mm].
    """
    way = BEYOND * (end - start) / abs(end - start)
    return Path((start - way, end + way), Layer.CENTRE)


def cross(middle: complex, radius: float) -> list[Entity]:
    """Return the centre lines of a circle.

    Args:
        middle: Of the circle [mm].
        radius: Of the circle [mm].
    """
    return [axis(middle - radius, middle + radius), axis(middle - 1j * radius, middle + 1j * radius)]


def toothed(gear: CylindricalGear, middle: complex, turn: float = 0.0) -> list[Entity]:
    """Return a gear seen along its axis: involute teeth, and the pitch circle.

    Args:
        gear: Its teeth, with lengths in mm of paper.
        middle: Where its axis stands [mm].
        turn: Direction of the middle of a tooth [rad].
    """
    root, tip = max(gear.root_radius, gear.base_radius), max(gear.tip_radius, gear.base_radius)
    flank = [root + (tip - root) * step / 6.0 for step in range(7)]
    halves = [(radius, half_angle_at(gear, radius)) for radius in flank]
    halves = [(gear.root_radius, halves[0][1]), *halves, (gear.tip_radius, halves[-1][1])]
    points = [
        middle + cmath.rect(radius, turn + math.tau * tooth / abs(gear.teeth) + sign * half)
        for tooth in range(abs(gear.teeth))
        for sign, way in ((-1.0, halves), (1.0, halves[::-1]))
        for radius, half in way
    ]
    return [Path(tuple(points), Layer.OUTLINE, closed=True), Arc(middle, abs(gear.pitch_radius), Layer.PITCH)]


def note(at: complex, text: str, align: str = "middle") -> Words:
    """Return words that are no key.

    Args:
        at: On their base line [mm].
        text: What they say.
        align: left, middle or right.
    """
    return Words(at, text, TEXT, align)


# ----------------------------------------------------------------------------------------------------------------------
# What shafts, their bearings, their joints and machines are measured by.
# ----------------------------------------------------------------------------------------------------------------------


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


def propeller_loads() -> list[Entity]:
    """A propeller beyond the end of its shaft, and the stream that it meets."""
    entities: list[Entity] = [*solid(0.0, 60.0, 6.0), axis(complex(-6.0), complex(128.0))]
    entities += [line(complex(60.0, 0.0), complex(60.0, -34.0), layer=Layer.CENTRE)]
    entities += box(complex(60.0, -5.0), complex(84.0, 5.0))
    for side in (1.0, -1.0):
        entities += box(complex(80.0, 5.0 * side), complex(84.0, 40.0 * side))
    entities += [across(complex(60.0, -34.0), complex(82.0, -40.0), -48.0, "overhang_mm")]
    stream = 18.0 * DEGREE
    entities += [line(complex(84.0), 84.0 + cmath.rect(46.0, -stream), layer=Layer.CENTRE)]
    entities += swept(complex(84.0), (-stream, 0.0), 36.0, complex(134.0, 10.0), "incidence_deg")
    return [*entities, note(complex(136.0, -20.0), "stream")]


# ----------------------------------------------------------------------------------------------------------------------
# What planetary sets, compound sets and what their planets turn on are measured by.
# ----------------------------------------------------------------------------------------------------------------------


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


def carrier_twist() -> list[Entity]:
    """Two plates seen from outside along a pin: the free one lags behind, and the planet's face leans with the pin."""
    low, high = 22.0, 72.0

    def place(x: float, beside: float = 0.0) -> complex:
        return complex(x, 0.2 * x + beside)

    entities = [*box(complex(0.0, -22.0), complex(10.0, 24.0)), *box(complex(84.0, -4.0), complex(92.0, 42.0))]
    entities += [line(place(10.0, -4.0), place(84.0, -4.0)), line(place(10.0, 4.0), place(84.0, 4.0))]
    entities += [line(*(place(x, y) for x, y in ((low, -14), (high, -14), (high, 14), (low, 14))), closed=True)]
    entities += [line(place(-6.0), place(98.0), layer=Layer.CENTRE), axis(complex(-2.0, 1.0), complex(92.0, 1.0))]
    entities += up(place(low, 14.0), place(high, 14.0), 104.0, "largest_misalignment_mm")
    entities += leader(complex(5.0, -22.0), complex(16.0, -34.0), "plate at which the torque enters")
    return [*entities, *leader(complex(88.0, -4.0), complex(98.0, -14.0), "free plate")]


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


# ----------------------------------------------------------------------------------------------------------------------
# What pairs of gears and their teeth are measured by.
# ----------------------------------------------------------------------------------------------------------------------


def pair() -> list[Entity]:
    """A cylindrical pair along its axes, with its bores, and from the side, with the helix on the pitch cylinder."""
    pinion, wheel = (CylindricalGear(teeth, 2.5, 1.0) for teeth in (17, 29))
    distance = pinion.pitch_radius + wheel.pitch_radius
    entities: list[Entity] = []
    for gear, middle, turn in ((pinion, 0j, 0.0), (wheel, complex(distance), math.pi + math.pi / 29.0)):
        entities += [*toothed(gear, middle, turn), Arc(middle, 7.0, Layer.OUTLINE), *cross(middle, gear.tip_radius)]
    entities.append(across(0j, complex(distance), -48.0, "centre_distance_mm"))
    entities += leader(cmath.rect(7.0, 145.0 * DEGREE), complex(-28.0, 24.0), "pinion_bore_mm")
    entities += leader(distance + cmath.rect(7.0, 45.0 * DEGREE), complex(distance + 44.0, 48.0), "wheel_bore_mm")
    entities += [note(complex(0.0, 32.0), "pinion"), note(complex(distance, 46.0), "wheel")]
    start, end, radius = 112.0, 148.0, wheel.tip_radius
    middle = (start + end) / 2.0
    entities += [*box(complex(start, -radius), complex(end, radius)), axis(complex(start), complex(end))]
    slope = 18.0 * math.tan(20.0 * DEGREE)
    for k in range(-3, 4):
        entities.append(line(complex(start, 8.0 * k - slope), complex(end, 8.0 * k + slope), layer=Layer.THIN))
    entities += swept(complex(middle), (0.0, 20.0 * DEGREE), 28.0, complex(end + 18.0, 16.0), "helix_angle_deg")
    entities.append(across(complex(start, -radius), complex(end, -radius), -48.0, "face_width_mm"))
    return entities


def _rack(pitch: float, count: int, heights: tuple[float, float], slope: float) -> list[complex]:
    """Return the profile of a rack whose first tooth has its middle at x = 0; at y = 0 a tooth is half a pitch."""
    return [
        complex(tooth * pitch + sign * (pitch / 4.0 - slope * y), y)
        for tooth in range(count)
        for sign in (-1.0, 1.0)
        for y in (heights if sign < 0.0 else heights[::-1])
    ]


def teeth() -> list[Entity]:
    """Teeth in a normal section: pitch, pressure angle, relief, roughness and thickness."""
    module, slope = 12.0, math.tan(20.0 * DEGREE)
    pitch, low, high = math.pi * module, -1.25 * module, module
    left, right = complex(-0.5 * pitch, low), complex(2.5 * pitch, low)
    body = (left, *_rack(pitch, 3, (low, high), slope), right)
    entities: list[Entity] = [
        Hatch((*body, right - 8.0j, left - 8.0j)), Path(body, Layer.OUTLINE),
        Path((left - 1j * low, right - 1j * low), Layer.PITCH),
    ]  # fmt: skip
    flank = complex(-pitch / 4.0)
    entities.append(across(flank, flank + pitch, 30.0, "π · module_mm"))
    foot = complex(pitch / 4.0)
    entities += swept(foot, (90.0 * DEGREE, 110.0 * DEGREE), 17.0, complex(-26.0, 20.0), "pressure_angle_deg")
    relieved = complex(pitch + pitch / 4.0 - slope * high, high)
    entities += [line(relieved + complex(slope * 8.0, -8.0), relieved - 2.6, layer=Layer.THIN)]
    entities += leader(relieved - 1.0, relieved + complex(9.0, 9.0), "tip_relief_mm ± tip_relief_tolerance_mm")
    thick = complex(2.0 * pitch + pitch / 4.0)
    entities += [line(*(thick + complex(2.6 - slope * y, y) for y in (low, high)), layer=Layer.HIDDEN)]
    normal = cmath.rect(2.44, 20.0 * DEGREE)
    entities += leader(thick + normal, thick + complex(16.0, 8.0), "tooth_thickness_mm")
    rough = complex(2.0 * pitch - pitch / 4.0 + slope * 5.0, -5.0)
    entities += leader(rough, complex(2.0 * pitch + 20.0, -32.0), "flank_roughness_mm, roughness_mm")
    root = complex(pitch / 2.0 - 2.0, low)
    entities += leader(root, complex(pitch / 2.0 - 12.0, -32.0), "root_roughness_mm")
    return entities


def mesh() -> list[Entity]:
    """A tooth in the gap of its mate: the play along the line of action, at the flanks that do not touch."""
    module, slope, play = 14.0, math.tan(20.0 * DEGREE), 4.0
    pitch, low, high = math.pi * module, -1.25 * module, module
    below = (complex(-1.05 * pitch, low), *_rack(pitch, 2, (low, high), slope), complex(1.6 * pitch, low))
    below = tuple(point - pitch / 2.0 for point in below)
    half = pitch / 4.0 - play / 2.0 / math.cos(20.0 * DEGREE)
    shift = complex(-play / 2.0 / math.cos(20.0 * DEGREE))
    above = tuple(
        shift + complex(sign * (half + slope * y), y)
        for sign, y in ((-1.0, 15.0), (-1.0, -high), (1.0, -high), (1.0, 15.0))
    )
    normal = cmath.rect(play, -20.0 * DEGREE)
    gap = above[2] + (above[3] - above[2]) * 0.55
    entities: list[Entity] = [
        Hatch((*below, below[-1] - 7.0j, below[0] - 7.0j)), Path(below, Layer.OUTLINE),
        Hatch((*above, above[-1] + 5.0j, above[0] + 5.0j), angle=-math.pi / 4.0), Path(above, Layer.OUTLINE),
        Path((complex(-52.0), complex(52.0)), Layer.PITCH),
        along(gap, gap + normal, 0.0, ""),
        *leader(gap + 0.5 * normal, complex(44.0, 14.0), "backlash_mm"),
    ]  # fmt: skip
    return [*entities, note(complex(0.0, 24.0), "tooth of the driven gear"), note(complex(0.0, -33.0), "driving gear")]


def bevel() -> list[Entity]:
    """A bevel pair through its axes, and the crown wheel of its teeth from above."""
    angle, inner, outer = math.atan(20.0 / 31.0), 46.0, 72.0
    entities = [*_cone(angle, 0.0, (inner, outer)), *_cone(math.pi / 2.0 - angle, -math.pi / 2.0, (inner, outer))]
    entities += [axis(0j, complex(84.0)), axis(0j, complex(0.0, -66.0))]
    entities += swept(0j, (-math.pi / 2.0, 0.0), 26.0, complex(-8.0, -13.0), "axis_angle_deg")
    near, far = (cmath.rect(reach, angle) for reach in (inner, outer))
    entities += [along(near, far, 13.0, "face_width_mm")]
    heel = cmath.rect(outer, angle)
    entities += up(heel.conjugate(), heel, 94.0, "z_{1} · outer_module_mm")
    return [*entities, *_crown(complex(190.0, -86.0))]


def _cone(angle: float, turn: float, cones: tuple[float, float]) -> list[Entity]:
    """Return a bevel gear in section: its teeth, its body and its pitch cone."""
    ahead = cmath.rect(1.0, turn)
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        ray = cmath.rect(1.0, side * angle)
        out = ray * 1j * side
        tips, roots = ([cone * ray + out * height * cone / cones[1] for cone in cones] for height in (4.5, -5.6))
        body = [*roots, complex(roots[1].real + 3.0, side * 8.0), complex(roots[0].real, side * 8.0)]
        teeth = [tips[0], tips[1], roots[1], roots[0]]
        entities += [
            Hatch(tuple(ahead * point for point in body), side * math.pi / 4.0),
            line(*(ahead * point for point in body), closed=True),
            line(*(ahead * point for point in teeth), closed=True),
            line(0j, ahead * (cones[1] + 6.0) * ray, layer=Layer.PITCH),
        ]
    return entities


def _crown(centre: complex) -> list[Entity]:
    """Return a part of the crown wheel: spiral teeth, cut by a circle of blades."""
    inner, outer, radius, spiral = 58.0, 88.0, 62.0, 35.0 * DEGREE
    mean = (inner + outer) / 2.0
    span = (72.0 * DEGREE, 122.0 * DEGREE)
    entities: list[Entity] = [Arc(centre, reach, Layer.OUTLINE, *span) for reach in (inner, outer)]
    entities += [line(*(centre + cmath.rect(reach, end) for reach in (inner, outer))) for end in span]
    tangent = cmath.rect(1.0, math.pi / 2.0 - spiral)
    cutter = 1j * mean - radius * 1j * tangent
    arc = [cutter + cmath.rect(radius, cmath.phase(1j * tangent) + k * DEGREE) for k in range(-40, 41)]
    inside = [point for point in arc if inner <= abs(point) <= outer]
    for tooth in range(-2, 4):
        entities.append(
            Path(tuple(centre + cmath.rect(1.0, 7.0 * tooth * DEGREE) * point for point in inside), Layer.THIN)
        )
    middle = centre + 1j * mean
    entities += [line(middle - 25.0j, middle + 33.0j, layer=Layer.CENTRE)]
    rays = (math.pi / 2.0 - spiral, math.pi / 2.0)
    entities += swept(middle, rays, 28.0, middle + complex(24.0, 36.0), "spiral_angle_deg")
    entities += [*cross(centre + cutter, 3.0), along(middle, centre + cutter, 0.0, "cutter_radius_mm")]
    return entities


# ----------------------------------------------------------------------------------------------------------------------
# Where axes stand, what they may not take, and what errors move.
# ----------------------------------------------------------------------------------------------------------------------


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


def installation() -> list[Entity]:
    """A gearbox beside and along its first shaft: length with the ends of shafts, circle of its housing, offset."""
    low, high = 0j, 32.0j
    entities = [*box(complex(10.0, -22.0), complex(64.0, 52.0)), axis(low, low + 74.0), axis(high, high + 78.0)]
    entities += [*box(complex(0.0, -4.0), complex(10.0, 4.0)), *box(complex(64.0, 26.0), complex(78.0, 38.0))]
    entities += [across(complex(0.0, -4.0), complex(78.0, 26.0), -36.0, "length_mm")]
    front = complex(140.0, 0.0)
    wheel, radius = front + high, (22.0 + 32.0 + 20.0) / 2.0
    middle = front + 1j * (radius - 22.0)
    entities += [Arc(front, 22.0, Layer.PITCH), Arc(wheel, 20.0, Layer.PITCH), Arc(middle, radius, Layer.OUTLINE)]
    entities += [*cross(front, 4.0), *cross(wheel, 4.0)]
    entities += up(front, wheel, 190.0, "offset_mm")
    entities += [across(middle - radius, middle + radius, -36.0, "diameter_mm")]
    return [*entities, note(complex(-6.0, -2.0), "drives", "right"), note(complex(81.0, 30.0), "driven", "left")]


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


# ----------------------------------------------------------------------------------------------------------------------
# Every diagram, with the tables whose keys it shows.
# ----------------------------------------------------------------------------------------------------------------------


DIAGRAMS: tuple[Diagram, ...] = (
    Diagram(
        "input-machines", "Diameters of machines",
        ("turbines.NAME", "propellers.NAME", "rotors.NAME"), machines,
    ),
    Diagram(
        "input-propeller-loads", "What a propeller loads its shaft by",
        ("propellers.NAME.loads", "propellers.NAME.loads.cases.NAME"), propeller_loads,
    ),
    Diagram("input-pair", "A cylindrical pair", ("pairs.NAME", "gears"), pair),
    Diagram("input-bevel", "A bevel pair", ("pairs.NAME", "gears"), bevel),
    Diagram(
        "input-backlash", "Backlash of a mesh",
        ("pairs.NAME", "planetaries.NAME", "epicyclics.NAME"), mesh,
    ),
    Diagram(
        "input-teeth", "Teeth in a normal section",
        ("gears", "gears.iso6336", "gears.agma2001", "losses", "pairs.NAME", "errors.NAME"), teeth,
    ),
    Diagram("input-planetary", "A planetary set", ("planetaries.NAME",), planetary),
    Diagram("input-carrier", "A carrier whose free plate lags, not to scale", ("carriers",), carrier_twist),
    Diagram(
        "input-planet-bearing", "What a planet turns on",
        ("planetaries.NAME.planet_bearing",), planet_bearing,
    ),
    Diagram(
        "input-compound", "A stepped planet of a compound set",
        ("epicyclics.NAME", "epicyclics.NAME.suns.NAME", "epicyclics.NAME.planets.NAME"), compound,
    ),
    Diagram("input-shafting", "Lengths of shafts that are left open", ("shafting",), shafting),
    Diagram("input-shaft", "Along a shaft", ("layout.NAME", "layout.NAME.places.NAME"), layout),
    Diagram("input-angle", "Where an axis stands, seen along x", ("layout.NAME",), angles),
    Diagram(
        "input-keep-out", "A box and a cylinder that the gearbox may not take",
        ("keep_out.NAME", "keep_out.NAME.start"), keep_out,
    ),
    Diagram("input-installation", "Room that a gearbox may take", ("installation_envelope",), installation),
    Diagram("input-errors", "What is not as drawn", ("errors.NAME",), errors),
    Diagram("input-bearing", "A bearing in its housing", ("bearings.NAME", "housing"), seat),
    Diagram("input-joint", "Between a shaft and what sits on it", ("joints.NAME",), joint),
)  # fmt: skip
"""In the order of the file."""
