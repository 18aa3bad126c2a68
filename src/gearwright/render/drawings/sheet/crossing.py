"""Whether lines run through text: segments of a sheet against the rectangles of its words."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

from gearwright.render.drawings.sheet.dimensions import drawn, words_corners
from gearwright.render.drawings.sheet.entities import Arc, Entity, Hatch, Mark, Path, Words

Segment = tuple[complex, complex]
ROUND = 48
"""Straight pieces of a circle [-]."""
INKED = 0.8
"""Height of letters over the height of their line with the room of descenders [-]."""
EDGE = 0.02
"""Share of the length of a text at its ends that a line may touch: letters have room around them [-]."""


def segments(marks: Iterable[Entity]) -> Iterator[Segment]:
    """Yield the straight pieces of all lines; sections' hatching has none, it is parted around text.

    Args:
        marks: Of a sheet or a view.
    """
    for mark in drawn(marks):
        yield from _pieces(mark)


def _pieces(mark: Mark) -> Iterator[Segment]:
    match mark:
        case Path():
            yield from pairwise([*mark.points, *(mark.points[:1] if mark.closed else ())])
        case Arc():
            turn = (mark.end - mark.start) / ROUND
            yield from pairwise(
                [mark.centre + cmath.rect(mark.radius, mark.start + k * turn) for k in range(ROUND + 1)]
            )
        case Hatch() | Words():
            return


def texts(marks: Iterable[Entity]) -> list[Words]:
    """Return all text, that of dimensions too.

    Args:
        marks: Of a sheet or a view.
    """
    return [mark for mark in drawn(marks) if isinstance(mark, Words) and mark.text.strip()]


def crossings(words: Words, lines: Iterable[Segment]) -> int:
    """Return how many lines run through a text [-].

    Args:
        words: The text.
        lines: From `segments`.
    """
    corners = list(words_corners(words))
    middle, along = sum(corners) / 4.0, cmath.rect(1.0, words.turn)
    half = complex(words.length * (0.5 - EDGE), INKED * abs(corners[1] - corners[0]) / 2.0)
    near = _beside(lines, corners)
    return sum(_meets((one - middle) / along, (other - middle) / along, half) for one, other in near)


def _beside(lines: Iterable[Segment], corners: Sequence[complex]) -> Iterator[Segment]:
    """Yield the lines whose boxes meet that of some points: no other one can run between them."""
    left, right = min(corner.real for corner in corners), max(corner.real for corner in corners)
    low, high = min(corner.imag for corner in corners), max(corner.imag for corner in corners)
    for line in lines:
        one, other = line
        if not (
            (one.real < left and other.real < left)
            or (one.real > right and other.real > right)
            or (one.imag < low and other.imag < low)
            or (one.imag > high and other.imag > high)
        ):
            yield line


def clear_of(words: Iterable[Words], lines: Sequence[Segment]) -> bool:
    """Tell whether no line runs through any text.

    Args:
        words: All text.
        lines: From `segments`.
    """
    return all(crossings(text, lines) == 0 for text in words)


def _meets(start: complex, end: complex, half: complex) -> bool:
    """Tell whether a line meets a rectangle about the origin (Liang and Barsky 1984)."""
    low, high, way = 0.0, 1.0, end - start
    for at, by, reach in ((start.real, way.real, half.real), (start.imag, way.imag, half.imag)):
        if abs(by) < 1e-12:
            if abs(at) > reach:
                return False
            continue
        first, second = sorted(((-reach - at) / by, (reach - at) / by))
        low, high = max(low, first), min(high, second)
    return low < high
