"""Dimensions as lines, arrows and words (ISO 129-1:2018), and the room that entities take."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator

from gearwright.render.drawings.sheet.entities import (
    ARROW,
    GAP,
    TEXT,
    Arc,
    Box,
    Corner,
    Distance,
    Entity,
    Hatch,
    Layer,
    Mark,
    Path,
    Words,
    words_length,
)

BEYOND = 2.0
"""How far an extension line goes beyond its dimension line [mm]."""
OUTSIDE = 6.0
"""Length of a dimension line outside of arrows that point inwards [mm]."""


def ends(dimension: Distance) -> tuple[complex, complex]:
    """Return the two ends of a dimension line, first and second [mm].

    Args:
        dimension: A linear dimension.
    """
    along = cmath.rect(1.0, dimension.angle)
    return tuple(  # type: ignore[return-value]
        dimension.line + along * ((point - dimension.line) * along.conjugate()).real
        for point in (dimension.first, dimension.second)
    )


def text_place(dimension: Distance) -> complex:
    """Return the middle of the base line of a dimension's text [mm].

    Over the middle of the line where it is not longer, else beyond its right or upper end.

    Args:
        dimension: A linear dimension.
    """
    if dimension.text_at is not None:
        return dimension.text_at
    first, second = ends(dimension)
    along = cmath.rect(1.0, dimension.angle)
    length = words_length(dimension.text, TEXT)
    middle = (first + second) / 2.0
    if length > abs(second - first):
        upper = max(first, second, key=lambda end: ((end - dimension.line) * along.conjugate()).real)
        middle = upper + along * (length / 2.0 + ARROW + 2.0)
    return middle + along * 1j * GAP


def arrows_outside(dimension: Distance) -> bool:
    """Return True where there is no room for arrows between the extension lines.

    Args:
        dimension: A linear dimension.
    """
    first, second = ends(dimension)
    return abs(second - first) < 2.0 * ARROW + GAP


def arrow(tip: complex, direction: complex, layer: Layer = Layer.DIMENSION) -> Path:
    """Return a filled arrowhead of 20°.

    Args:
        tip: Where it points to [mm].
        direction: In which it points, of length 1 [-].
        layer: Where it lies.
    """
    back, half = tip - ARROW * direction, ARROW * math.tan(math.radians(10.0))
    return Path((tip, back + half * 1j * direction, back - half * 1j * direction), layer, closed=True, filled=True)


def drawn(entities: Iterable[Entity]) -> Iterator[Mark]:
    """Yield entities as they look: dimensions as their lines, arrows and words.

    Args:
        entities: Of any kind.
    """
    for entity in entities:
        match entity:
            case Distance():
                yield from _linear(entity)
            case Corner():
                yield from _angular(entity)
            case _:
                yield entity


def _linear(dimension: Distance) -> Iterator[Mark]:
    first, second = ends(dimension)
    along = (second - first) / abs(second - first)
    for point, end in ((dimension.first, first), (dimension.second, second)):
        if abs(end - point) > GAP:
            away = (end - point) / abs(end - point)
            yield Path((point + GAP * away, end + BEYOND * away), dimension.layer)
    outside = arrows_outside(dimension)
    yield from (arrow(first, along if outside else -along), arrow(second, -along if outside else along))
    reach = OUTSIDE * along if outside else 0.0
    yield Path((first - reach, second + reach), dimension.layer)
    yield from _to_text(dimension, first, second)
    yield Words(text_place(dimension), dimension.text, TEXT, "middle", dimension.angle, dimension.layer)


def _to_text(dimension: Distance, first: complex, second: complex) -> Iterator[Path]:
    """Yield the dimension line on to text that stands beyond its ends."""
    along = cmath.rect(1.0, dimension.angle)
    place, half = text_place(dimension), words_length(dimension.text, TEXT) / 2.0
    low, high = sorted(((end - place) * along.conjugate()).real for end in (first, second))
    foot = place - along * 1j * GAP
    if abs(((first - foot) * (along * 1j).conjugate()).real) > 1e-6:
        return
    if high < half:
        yield Path((foot + along * high, foot + along * half), dimension.layer)
    if low > -half:
        yield Path((foot + along * low, foot - along * half), dimension.layer)


def _angular(dimension: Corner) -> Iterator[Mark]:
    start, end, radius = dimension.start, dimension.end, dimension.radius
    yield Arc(dimension.centre, radius, dimension.layer, start, end)
    turn = ARROW / 2.0 / radius
    narrow = radius * (end - start) < 2.0 * ARROW + GAP
    for at, sign in ((start, -1.0), (end, 1.0)):
        sense = -sign if narrow else sign
        heading = cmath.rect(1.0, at + sense * (math.pi / 2.0 - turn))
        yield arrow(dimension.centre + cmath.rect(radius, at), heading, dimension.layer)
    if narrow:
        yield Arc(dimension.centre, radius, dimension.layer, start - OUTSIDE / radius, start)
    yield from corner_leader(dimension)
    yield corner_words(dimension)


def corner_leader(dimension: Corner) -> list[Arc]:
    """Return the arc that goes on to the text of an angular dimension, where that stands beyond its end.

    Args:
        dimension: An angular dimension.
    """
    at, half = _corner_place(dimension), words_length(dimension.text, TEXT) / 2.0 / dimension.radius
    if at < dimension.end:
        return []
    return [Arc(dimension.centre, dimension.radius, dimension.layer, dimension.end, at + half)]


def _corner_place(dimension: Corner) -> float:
    """Return the direction in which the text of an angular dimension stands [rad]."""
    length = words_length(dimension.text, TEXT)
    room = dimension.radius * (dimension.end - dimension.start) - 2.0 * ARROW
    beyond = (OUTSIDE + length / 2.0 + 1.0) / dimension.radius
    return (dimension.start + dimension.end) / 2.0 if room > length + 1.0 else dimension.end + beyond


def corner_words(dimension: Corner) -> Words:
    """Return the text of an angular dimension: over the middle of its arc, or beyond its end where that is short.

    Args:
        dimension: An angular dimension.
    """
    at = _corner_place(dimension)
    turn = (at - math.pi / 2.0 + math.pi / 2.0) % math.pi - math.pi / 2.0
    outward = cmath.rect(1.0, at)
    turned_over = (cmath.rect(1.0, turn) * 1j * outward.conjugate()).real < 0.0
    base = dimension.radius + GAP + (TEXT if turned_over else 0.0)
    return Words(dimension.centre + base * outward, dimension.text, TEXT, "middle", turn, dimension.layer)


def extent(entities: Iterable[Entity]) -> Box:
    """Return the box of entities [mm].

    Args:
        entities: At least one.
    """
    points = [corner for mark in drawn(entities) for corner in _corners(mark)]
    xs, ys = [point.real for point in points], [point.imag for point in points]
    return min(xs), min(ys), max(xs), max(ys)


def _corners(mark: Mark) -> Iterator[complex]:
    match mark:
        case Path() | Hatch():
            yield from mark.points
        case Arc():
            steps = 1 if mark.radius == 0.0 else 24
            for k in range(steps + 1):
                yield mark.centre + cmath.rect(mark.radius, mark.start + (mark.end - mark.start) * k / steps)
        case Words():
            yield from words_corners(mark)


def words_corners(words: Words) -> Iterator[complex]:
    """Yield the four corners of a line of text [mm].

    Args:
        words: The line.
    """
    along = cmath.rect(1.0, words.turn)
    start = words.at - along * words.length * {"left": 0.0, "middle": 0.5, "right": 1.0}[words.align]
    for right in (0.0, words.length):
        for up in (-0.25 * words.height, words.height):
            yield start + along * (right + 1j * up)
