"""What is written across an axis, above a part: diameters, designations, textures and frames of tolerances."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from gearwright.render.drawings.sheet.dimensions import arrow
from gearwright.render.drawings.sheet.entities import (
    GAP,
    TEXT,
    Distance,
    Entity,
    Layer,
    Path,
    Words,
    millimetres,
    words_length,
)
from gearwright.render.drawings.sheet.symbols import texture, texture_length
from gearwright.render.drawings.sheet.tolerances import Tolerance, tolerance_frame
from gearwright.render.drawings.views.shaft_view import Axis

ACROSS = 10.5
"""Between what is written across an axis: a texture mark on one side reaches beside half a frame on the other [mm]."""

AT_FACE = 2.5
"""Between the foot of a leader and the face that it points at [mm of paper]."""


class Mark(NamedTuple):
    """Something written across a shaft: a diameter, or a designation with a leader."""

    x: float
    """Along the axis [mm]."""
    radius: float
    """Of the outline there [mm]."""
    suffix: str
    """After the diameter."""
    words: str = ""
    """Instead of a diameter."""
    texture: str = ""
    tolerance: Tolerance | None = None
    """Of the surface there, instead of words."""
    face: float = 0.0
    """−1 or +1 where a face is meant that lies to the right or to the left of the leader's foot."""


def marked(axis: Axis, mark: Mark, place: float, top: float) -> Iterator[Entity]:
    """Yield a diameter whose line goes on above the shaft, to its slot, with the text along it.

    Args:
        axis: Of the part.
        mark: What is written.
        place: Along the axis, above which it stands [mm of paper].
        top: Radius of the part where it is thickest [mm of paper].
    """
    low, high = axis.at(mark.x, -mark.radius), axis.at(mark.x, mark.radius)
    start = complex(place, axis.origin.imag + top + 8.0)
    knee = complex(high.real, axis.origin.imag + top + 2.0)
    if mark.tolerance is not None:
        tip, way = (high - mark.face * AT_FACE, complex(-mark.face)) if mark.face else (high, -1j)
        yield Path(((tip, high, knee, start) if mark.face else (high, knee, start)), Layer.SYMBOL)
        yield arrow(tip, way, Layer.SYMBOL)
        yield from tolerance_frame(start, mark.tolerance, math.pi / 2.0)
        return
    words = mark.words or f"Ø{millimetres(2.0 * mark.radius)}{mark.suffix}"
    length = words_length(words, TEXT)
    middle = start + 1j * (1.0 + length / 2.0) - GAP
    tail = start + 1j * (2.0 + length)
    if mark.words:
        yield Words(middle, words, TEXT, "middle", math.pi / 2.0, Layer.DIMENSION)
    else:
        yield Distance(low, high, high, math.pi / 2.0, axis.scale, "Ø", mark.suffix, middle)
    end = tail + (1j * texture_length(mark.texture) if mark.texture else 0.0)
    yield Path((high, knee, start, end), Layer.DIMENSION)
    if mark.texture:
        yield from texture(tail + 2.5j, mark.texture, math.pi / 2.0)
