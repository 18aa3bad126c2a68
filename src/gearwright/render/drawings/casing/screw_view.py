"""A screw of a flange on a section: seen from its side and not cut, as ISO 128 has fasteners, in its clearance hole."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.render.drawings.sheet.entities import Entity, Layer, Path
from gearwright.sizing.casing import HEAD, LENGTH, NUT, THICKNESS, WASHER

CORNERS = 1.0 / math.cos(math.pi / 6.0)
"""Across the corners of a hexagon over across its flats [-]: a screw shows three of its sides."""


def screw_entities(joint: complex, thread: float) -> Iterator[Entity]:
    """Yield the outlines of a screw along x, its head before the joint: head, washers, shank in its hole, nut and end.

    Args:
        joint: Where its axis goes through the joint [mm].
        thread: Its diameter [mm].
    """
    radius, face, washer = 0.5 * thread, THICKNESS * thread, WASHER[1] * thread
    below = -face - washer
    nut = (face + washer, face + washer + NUT[1] * thread)
    yield from _hexagon(joint, (below - HEAD[1] * thread, below), CORNERS * HEAD[0] * radius)
    for start in (below, face):
        yield _box(joint, (start, start + washer), WASHER[0] * radius)
    for side in (1j, -1j):
        yield Path((joint - face + side * radius, joint + face + side * radius), Layer.OUTLINE)
    yield from _hexagon(joint, nut, CORNERS * NUT[0] * radius)
    yield _box(joint, (nut[1], below + LENGTH * thread), radius)


def _hexagon(joint: complex, span: tuple[float, float], half: float) -> Iterator[Path]:
    """Yield the outline of a hexagon with the edges between its sides."""
    yield _box(joint, span, half)
    for side in (1j, -1j):
        yield Path(tuple(joint + place + side * half / 2.0 for place in span), Layer.OUTLINE)


def _box(joint: complex, span: tuple[float, float], half: float) -> Path:
    low, high = span
    corners = (complex(low, -half), complex(high, -half), complex(high, half), complex(low, half))
    return Path(tuple(joint + corner for corner in corners), Layer.OUTLINE, closed=True)
