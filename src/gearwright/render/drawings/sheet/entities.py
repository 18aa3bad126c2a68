"""What a drawing is made of: paths, arcs, hatches, words and dimensions on layers, in mm of paper.

A point is a complex number x + i y [mm], x to the right and y upwards.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import Enum
from functools import lru_cache

from gearwright.render.vector.words import POINT, text_width

TEXT = 3.5
"""Height of capitals in dimensions and notes [mm] (ISO 3098-1)."""
SMALL = 2.5
"""Height of capitals in tables and symbols [mm] (ISO 3098-1)."""
CAPITALS = 0.73
"""Height of capitals over the size of the font, as in Arial and DejaVu Sans [-]."""
INDEX = 0.7
"""Height of an index over that of its line [-]."""
ARROW = 3.0
"""Length of an arrowhead [mm]."""
GAP = 1.0
"""Between a dimension line and its text, and between an outline and an extension line [mm]."""
WIDE, NARROW = 0.5, 0.25
"""Line group 0.5 [mm] (ISO 128-2:2020)."""

CONTINUOUS: tuple[float, ...] = ()
DASHED = (12 * NARROW, 3 * NARROW)
CHAIN = (24 * NARROW, 3 * NARROW, 0.5 * NARROW, 3 * NARROW)
WIDE_CHAIN = (24 * WIDE, 3 * WIDE, 0.5 * WIDE, 3 * WIDE)


class Layer(Enum):
    """Layers by content, with their line width [mm] and dashes [mm] (ISO 128-2:2020)."""

    OUTLINE = ("visible outlines", WIDE, CONTINUOUS)
    THIN = ("visible edges that run out, root lines of splines", NARROW, CONTINUOUS)
    HIDDEN = ("hidden outlines", NARROW, DASHED)
    CENTRE = ("centre lines", NARROW, CHAIN)
    PITCH = ("pitch lines of gears (ISO 2203)", NARROW, CHAIN)
    HARDENED = ("surfaces to be hardened (ISO 15787)", WIDE, WIDE_CHAIN)
    HATCH = ("sections", NARROW, CONTINUOUS)
    DIMENSION = ("dimensions", NARROW, CONTINUOUS)
    SYMBOL = ("roughness and section marks", NARROW, CONTINUOUS)
    TEXT = ("notes", NARROW, CONTINUOUS)
    TABLE = ("tables", NARROW, CONTINUOUS)
    FRAME = ("frame and title block", 0.7, CONTINUOUS)

    @property
    def width(self) -> float:
        """Line width [mm]."""
        width: float = self.value[1]
        return width

    @property
    def dashes(self) -> tuple[float, ...]:
        """Lengths of dashes and gaps [mm]; none where it is continuous."""
        dashes: tuple[float, ...] = self.value[2]
        return dashes


@dataclass(frozen=True)
class Path:
    """Straight lines from point to point."""

    points: tuple[complex, ...]
    layer: Layer
    closed: bool = False
    filled: bool = False
    """In the colour of the line, as arrowheads are."""


@dataclass(frozen=True)
class Arc:
    """A circle, or counterclockwise a part of one."""

    centre: complex
    radius: float
    layer: Layer
    start: float = 0.0
    """[rad]"""
    end: float = 2.0 * math.pi
    """[rad]"""

    @property
    def whole(self) -> bool:
        """True for a circle."""
        return math.isclose(self.end - self.start, 2.0 * math.pi)


@dataclass(frozen=True)
class Hatch:
    """A section's face."""

    points: tuple[complex, ...]
    angle: float = math.pi / 4.0
    """Of the lines [rad]."""
    spacing: float = 3.0
    """Between lines [mm]."""
    layer: Layer = Layer.HATCH


@dataclass(frozen=True)
class Words:
    """One line of text; what stands in ``_{…}`` is an index."""

    at: complex
    """Left end, middle or right end of its base line."""
    text: str
    height: float = TEXT
    """Of capitals [mm]."""
    align: str = "left"
    """left, middle or right."""
    turn: float = 0.0
    """[rad]"""
    layer: Layer = Layer.TEXT

    @property
    def length(self) -> float:
        """Length of the line [mm]."""
        return words_length(self.text, self.height)


@dataclass(frozen=True)
class Distance:
    """A linear dimension; its value is what it measures, at the sheet's scale."""

    first: complex
    second: complex
    line: complex
    """A point of the dimension line."""
    angle: float
    """Of the dimension line [rad]: 0 along x, π/2 along y."""
    scale: float
    """Of the view [-]: mm of paper per mm."""
    prefix: str = ""
    """Such as Ø."""
    suffix: str = ""
    """Such as k6."""
    text_at: complex | None = None
    """Middle of the text's base line, where it does not stand over the middle of the line."""
    layer: Layer = Layer.DIMENSION
    named: str | None = None
    """What it says instead of its value."""

    @property
    def measured(self) -> float:
        """Length that is dimensioned [mm]."""
        direction = cmath.rect(1.0, self.angle)
        return abs(((self.second - self.first) * direction.conjugate()).real) / self.scale

    @property
    def text(self) -> str:
        """What stands at the dimension line."""
        return self.named if self.named is not None else f"{self.prefix}{millimetres(self.measured)}{self.suffix}"


@dataclass(frozen=True)
class Corner:
    """An angular dimension between two rays from one point."""

    centre: complex
    start: float
    """Direction of the first ray [rad]."""
    end: float
    """Direction of the second ray, counterclockwise from the first [rad]."""
    radius: float
    """Of the dimension arc [mm]."""
    layer: Layer = Layer.DIMENSION

    @property
    def measured(self) -> float:
        """[°]"""
        return math.degrees(self.end - self.start)

    @property
    def text(self) -> str:
        """What stands at the arc."""
        return trimmed(self.measured, 2) + "°"


Mark = Path | Arc | Hatch | Words
"""What is drawn as it is."""
Entity = Mark | Distance | Corner
Box = tuple[float, float, float, float]
"""Left, low, right, high [mm]."""


def millimetres(value: float) -> str:
    """Return a length as dimensions write it: to 0.01 mm, without zeros at the end.

    Args:
        value: [mm].

    >>> millimetres(45.0), millimetres(46.587)
    ('45', '46.59')
    """
    return trimmed(value, 2)


def trimmed(value: float, digits: int) -> str:
    """Return a number rounded to some digits after its point, without zeros at the end.

    Args:
        value: Any.
        digits: At least 1.

    >>> trimmed(0.25, 3), trimmed(-0.0001, 3)
    ('0.25', '0')
    """
    return f"{value:z.{digits}f}".rstrip("0").rstrip(".")


@lru_cache(maxsize=8192)
def words_length(text: str, height: float) -> float:
    """Return the length of a line of text [mm].

    Args:
        text: The line.
        height: Of its capitals [mm].
    """
    return sum(text_width(part, 1.0) * (INDEX if low else 1.0) for part, low in runs(text)) * height / CAPITALS / POINT


def runs(text: str) -> list[tuple[str, bool]]:
    """Return a line in parts, each with True where it is an index.

    Args:
        text: The line.

    >>> runs("W_{k} over 4")
    [('W', False), ('k', True), (' over 4', False)]
    """
    parts = re.split(r"_\{(.*?)\}", text)
    return [(part, k % 2 == 1) for k, part in enumerate(parts) if part]


def moved(entities: Iterable[Entity], by: complex) -> list[Entity]:
    """Return entities at another place.

    Args:
        entities: What to move.
        by: How far [mm].
    """
    return [_moved(entity, by) for entity in entities]


def _moved(entity: Entity, by: complex) -> Entity:
    match entity:
        case Path() | Hatch():
            return replace(entity, points=tuple(point + by for point in entity.points))
        case Arc() | Corner():
            return replace(entity, centre=entity.centre + by)
        case Words():
            return replace(entity, at=entity.at + by)
        case Distance():
            text_at = None if entity.text_at is None else entity.text_at + by
            return replace(
                entity, first=entity.first + by, second=entity.second + by, line=entity.line + by, text_at=text_at
            )
