"""Where an unfolded section runs, in the view along the first shaft: a cutting plane with corners (ISO 128-3)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from gearwright.arrays import Floats
from gearwright.render.drawings.casing.section_path import lanes
from gearwright.render.drawings.sheet.dimensions import arrow
from gearwright.render.drawings.sheet.entities import TEXT, Entity, Layer, Path, Words
from gearwright.render.drawings.views.positions import Positions
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape.solids import spans_in
from gearwright.sizing import Sizing

LETTER = "B"
"""Of the section."""
BEYOND, STROKE, CORNER = 3.0, 6.0, 3.0
"""From the outline to the strokes at both ends, how long those are, and each of the two strokes of a corner [mm]."""
STRAIGHT = 1e-9
"""How far directions of two legs may differ that are one [-]."""


def cutting_way(sizing: Sizing, plane: Positions, covers: Sequence[Floats]) -> tuple[complex, ...]:
    """Return from where to where the section runs, over its corners; nothing where it is one plane, or steps.

    Args:
        sizing: What was sized.
        plane: Where shafts lie on the sheet.
        covers: Outlines of the housing's pieces across the first shaft [m], shape (n, 2) each.

    Returns:
        Points across the first shaft, y to the right and z upwards [mm].
    """
    ways = lanes(sizing, plane)
    if ways is None or len(ways) != 1 or not covers:
        return ()
    legs = ways[0].legs
    if all(abs(float(leg.along @ legs[0].along)) > 1.0 - STRAIGHT for leg in legs):
        return ()
    spans = [span for loop in covers for span in spans_in(loop, legs)]
    heights = [min(span[0] for span in spans), *(leg.high for leg in legs[:-1]), max(span[1] for span in spans)]
    points = [legs[0].foot + heights[0] * legs[0].along]
    points += [leg.foot + height * leg.along for leg, height in zip(legs, heights[1:], strict=True)]
    return tuple(MM * complex(*point.tolist()) for point in points)


def way_marks(way: Sequence[complex]) -> Iterator[Entity]:
    """Yield the strokes at both ends and corners of a section, arrows along which it is seen, and its letters.

    Args:
        way: Its corners from below on the sheet of the section [mm of paper].
    """
    for point, other, sense in ((way[0], way[1], -1.0), (way[-1], way[-2], 1.0)):
        out = (point - other) / abs(point - other)
        looking = -1j * sense * out
        inner, foot = point + BEYOND * out, point + (BEYOND + 0.75 * STROKE) * out
        yield Path((inner, inner + STROKE * out), Layer.OUTLINE)
        yield from (Path((foot, foot - 7.0 * looking), Layer.SYMBOL), arrow(foot, looking, Layer.SYMBOL))
        yield Words(foot - 10.0 * looking - 1j * TEXT / 2.0, LETTER, TEXT, "middle", layer=Layer.SYMBOL)
    for (before, corner), (_, behind) in pairwise(pairwise(way)):
        first, second = ((end - corner) / abs(end - corner) for end in (before, behind))
        if abs(first + second) > STRAIGHT:
            yield Path((corner + CORNER * first, corner, corner + CORNER * second), Layer.OUTLINE)
