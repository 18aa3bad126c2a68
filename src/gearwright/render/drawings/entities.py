"""What a drawing is made of: paths, hatches, words, dimensions (ISO 129-1), symbols, tolerances (ISO 1101)."""

import cmath
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from functools import lru_cache
from itertools import count
from typing import Literal, NamedTuple

from gearwright.render.vector.layout import POINT, text_width

# ----------------------------------------------------------------------------------------------------------------------
# What a drawing is made of: paths, arcs, hatches, words and dimensions on layers, in mm of paper.
#
# A point is a complex number x + i y [mm], x to the right and y upwards.
# ----------------------------------------------------------------------------------------------------------------------


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
    return [(part, k % 2 == 1) for k, part in enumerate(re.split(r"_\{(.*?)\}", text)) if part]


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


# ----------------------------------------------------------------------------------------------------------------------
# Dimensions as lines, arrows and words (ISO 129-1:2018), and the room that entities take.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Marks on a drawing: surface texture (ISO 1302), cutting planes (ISO 128-3), leaders and item numbers.
# ----------------------------------------------------------------------------------------------------------------------


LETTERS = "ABCDEFGHJKLMNPRSTUVWXYZ"
"""Of datums and sections: without I, O and Q (ISO 5459)."""
SHORT, LONG = 3.5, 7.5
"""Heights of the two legs of a texture mark with letters of 2.5 mm [mm] (ISO 1302:2002, annex A)."""


def texture(foot: complex, text: str, turn: float = 0.0) -> list[Entity]:
    """Return the mark of a surface that is machined, with what is asked of it under its bar.

    Args:
        foot: Its tip on the surface or its line [mm].
        text: Such as ``Ra 0.8``.
        turn: Of the mark [rad].
    """
    along = cmath.rect(1.0, turn)
    slope = math.tan(math.radians(30.0))
    left, right = complex(-SHORT * slope, SHORT), complex(SHORT * slope, SHORT)
    top = complex(LONG * slope, LONG)
    bar = top + words_length(text, SMALL) + 1.5
    points = tuple(foot + along * point for point in (left, 0j, top, bar))
    return [
        Path(points, Layer.SYMBOL),
        Path((foot + along * left, foot + along * right), Layer.SYMBOL),
        Words(foot + along * (top + complex(0.6, -SMALL - 1.0)), text, SMALL, "left", turn, Layer.SYMBOL),
    ]


def texture_length(text: str) -> float:
    """Return the length of a texture mark along its bar [mm].

    Args:
        text: Under the bar.
    """
    return SHORT * math.tan(math.radians(30.0)) + LONG * math.tan(math.radians(30.0)) + words_length(text, SMALL) + 1.5


def section_letters() -> Iterator[str]:
    """Yield letters of datums and sections, without end: A, B, ... Z, AA, BB, ...

    Source: ISO 5459:2011, 7.2.1: capital letters without I, O and Q, repeated where they are used up.

    >>> from itertools import islice
    >>> list(islice(section_letters(), 21, 25))
    ['Y', 'Z', 'AA', 'BB']
    """
    for times in count(1):
        yield from (letter * times for letter in LETTERS)


def cutting_plane(axis_point: complex, reach: float, letter: str, *, looking: complex) -> list[Entity]:
    """Return the two ends of a cutting plane across an axis, with arrows and letters.

    Args:
        axis_point: Where the plane cuts the axis [mm].
        reach: From the axis to the inner end of each stroke [mm].
        letter: Of the section.
        looking: Direction of view, of length 1 [-].
    """
    entities: list[Entity] = []
    for side in (-1.0, 1.0):
        across = looking * 1j * side
        inner, outer = axis_point + across * reach, axis_point + across * (reach + 6.0)
        entities.append(Path((inner, outer), Layer.OUTLINE))
        foot = axis_point + across * (reach + 4.5)
        entities += [Path((foot, foot - 7.0 * looking), Layer.SYMBOL), arrow(foot, looking, Layer.SYMBOL)]
        place = foot - 10.0 * looking - 1j * TEXT / 2.0
        entities.append(Words(place, letter, TEXT, "middle", layer=Layer.SYMBOL))
    return entities


def balloon(target: complex, middle: complex, number: str) -> list[Entity]:
    """Return an item number in a circle with its leader, which ends in a dot on the part (ISO 6433).

    Args:
        target: On the part [mm].
        middle: Of the circle [mm].
        number: Of the item.
    """
    radius = 4.0
    towards = (target - middle) / abs(target - middle)
    dot = tuple(target + cmath.rect(0.6, math.pi / 4.0 * k) for k in range(8))
    return [
        Arc(middle, radius, Layer.SYMBOL),
        Path((middle + radius * towards, target), Layer.SYMBOL),
        *(Path((target, corner, following), Layer.SYMBOL, closed=True, filled=True)
          for corner, following in zip(dot, (*dot[1:], dot[0]), strict=True)),
        Words(middle - 1j * TEXT / 2.0, number, TEXT, "middle", layer=Layer.SYMBOL),
    ]  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Geometrical tolerances: frames with what is allowed against which datums (ISO 1101), and datums (ISO 5459).
# ----------------------------------------------------------------------------------------------------------------------


HIGH = 2.0 * SMALL
"""Height of a frame [mm] (ISO 7083: twice the height of its letters)."""
_AIR = 1.0
"""Beside what stands in a cell [mm]."""
_TIP = 1.2
"""Length of the arrowheads of symbols [mm]."""
TRIANGLE = 3.0
"""Height of the triangle of a datum [mm]."""


Characteristic = Literal[
    "run-out", "total run-out", "coaxiality", "position", "perpendicularity", "flatness", "symmetry"
]


class GeometricTolerance(NamedTuple):
    """What a frame says."""

    what: Characteristic
    width: float
    """Of its zone [mm]."""
    datums: str = ""
    """Such as ``A–B``; empty of what needs none."""
    of: str = ""
    """What of teeth or splines is meant, behind the frame: ``PD`` for their pitch circle (ISO 1101)."""

    @property
    def text(self) -> str:
        """The width as the frame has it, to 0.1 µm; with Ø where its zone is a cylinder."""
        round_zone = "Ø" if self.what in ("coaxiality", "position") else ""
        return round_zone + f"{self.width:.4f}".rstrip("0").rstrip(".")


def frame_length(tolerance: GeometricTolerance) -> float:
    """Return the length of a frame [mm].

    Args:
        tolerance: What it says.
    """
    return sum(_widths(tolerance)) + (words_length(tolerance.of, SMALL) + _AIR if tolerance.of else 0.0)


def tolerance_frame(start: complex, tolerance: GeometricTolerance, turn: float = 0.0) -> list[Entity]:
    """Return a frame: symbol, width of the zone, datums.

    Args:
        start: Middle of its side with the symbol [mm].
        tolerance: What it says.
        turn: Direction in which it reads [rad].
    """
    along, widths = cmath.rect(1.0, turn), _widths(tolerance)
    edges = [sum(widths[:k]) for k in range(len(widths) + 1)]
    outline = (complex(0.0, -HIGH / 2.0), complex(edges[-1], -HIGH / 2.0), complex(edges[-1], HIGH / 2.0),
               complex(0.0, HIGH / 2.0))  # fmt: skip
    entities: list[Entity] = [_path(start, along, outline, closed=True)]
    entities += [_path(start, along, (edge - 0.5j * HIGH, edge + 0.5j * HIGH)) for edge in edges[1:-1]]
    entities += _symbol(start + along * widths[0] / 2.0, along, tolerance.what)
    for text, left, width in zip(_texts(tolerance), edges[1:], widths[1:], strict=False):
        at = start + along * complex(left + width / 2.0, -SMALL / 2.0)
        entities.append(Words(at, text, SMALL, "middle", turn, Layer.SYMBOL))
    if tolerance.of:
        at = start + along * complex(edges[-1] + _AIR, -SMALL / 2.0)
        entities.append(Words(at, tolerance.of, SMALL, "left", turn, Layer.SYMBOL))
    return entities


def datum(foot: complex, way: complex, letter: str) -> list[Entity]:
    """Return the mark of a datum; in line with a dimension it means the axis or middle plane of what is dimensioned.

    Args:
        foot: On the outline or an extension line [mm].
        way: From there to the letter, of length 1 [-].
        letter: Its name.
    """
    half, far = TRIANGLE / math.sqrt(3.0), TRIANGLE + 2.0
    corners = (complex(0.0, -half), complex(0.0, half), complex(TRIANGLE, 0.0))
    box = [
        complex(far + x, y) for x, y in ((0.0, -0.5 * HIGH), (HIGH, -0.5 * HIGH), (HIGH, 0.5 * HIGH), (0.0, 0.5 * HIGH))
    ]
    middle = foot + way * (far + HIGH / 2.0)
    return [
        _path(foot, way, corners, closed=True, filled=True),
        _path(foot, way, (complex(TRIANGLE), complex(far))),
        _path(foot, way, box, closed=True),
        Words(middle - 1j * SMALL / 2.0, letter, SMALL, "middle", layer=Layer.SYMBOL),
    ]


def _widths(tolerance: GeometricTolerance) -> list[float]:
    return [HIGH + _AIR, *(words_length(text, SMALL) + 2.0 * _AIR for text in _texts(tolerance))]


def _texts(tolerance: GeometricTolerance) -> tuple[str, ...]:
    return (tolerance.text, tolerance.datums) if tolerance.datums else (tolerance.text,)


def _path(
    start: complex, along: complex, points: Sequence[complex], *, closed: bool = False, filled: bool = False
) -> Path:
    return Path(tuple(start + along * point for point in points), Layer.SYMBOL, closed=closed, filled=filled)


def _symbol(middle: complex, along: complex, what: Characteristic) -> list[Entity]:
    """Return the symbol of a characteristic (ISO 1101, table 1)."""
    if what in ("run-out", "total run-out"):
        return _arrows(middle, along, is_total=what == "total run-out")
    if what == "perpendicularity":
        strokes = ((complex(-1.6, -1.5), complex(1.6, -1.5)), (complex(0.0, -1.5), complex(0.0, 1.6)))
        return [_path(middle, along, stroke) for stroke in strokes]
    if what == "flatness":
        corners = (complex(-2.0, -1.0), complex(0.8, -1.0), complex(2.0, 1.0), complex(-0.8, 1.0))
        return [_path(middle, along, corners, closed=True)]
    if what == "symmetry":
        lines = ((1.0, -0.9), (1.8, 0.0), (1.0, 0.9))
        return [_path(middle, along, (complex(-half, y), complex(half, y))) for half, y in lines]
    small = Arc(middle, 0.8, Layer.SYMBOL)
    if what == "coaxiality":
        return [small, Arc(middle, 1.6, Layer.SYMBOL)]
    cross = ((complex(-1.8, 0.0), complex(1.8, 0.0)), (complex(0.0, -1.8), complex(0.0, 1.8)))
    return [Arc(middle, 1.2, Layer.SYMBOL), *(_path(middle, along, stroke) for stroke in cross)]


def _arrows(middle: complex, along: complex, *, is_total: bool) -> list[Entity]:
    """Return one leaning arrow of circular run-out, or two joined ones of total run-out."""
    lean = complex(1.6, 3.0)
    feet = (complex(-1.8, -1.5), complex(0.2, -1.5)) if is_total else (complex(-0.8, -1.5),)
    entities: list[Entity] = []
    for foot in feet:
        tip, way = foot + lean, lean / abs(lean)
        barbs = (tip, tip - _TIP * way * cmath.rect(1.0, 0.3), tip - _TIP * way * cmath.rect(1.0, -0.3))
        entities += [_path(middle, along, (foot, tip)), _path(middle, along, barbs, closed=True, filled=True)]
    return [*entities, _path(middle, along, feet)] if is_total else entities
