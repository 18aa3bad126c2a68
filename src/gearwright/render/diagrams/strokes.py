"""Strokes of diagrams: dimensions that say a key, leaders, and the outlines that they measure."""

from __future__ import annotations

import cmath
import math

from gearwright.parts.gears import CylindricalGear, half_angle_at
from gearwright.render.drawings.sheet.dimensions import OUTSIDE, arrow
from gearwright.render.drawings.sheet.entities import (
    ARROW,
    GAP,
    TEXT,
    Arc,
    Distance,
    Entity,
    Hatch,
    Layer,
    Path,
    Words,
)

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
