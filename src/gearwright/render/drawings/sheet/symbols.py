"""Marks on a drawing: surface texture (ISO 1302), cutting planes (ISO 128-3), leaders and item numbers."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import count

from gearwright.render.drawings.sheet.dimensions import arrow
from gearwright.render.drawings.sheet.entities import SMALL, TEXT, Arc, Entity, Layer, Path, Words, words_length

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
