"""Round outlines of a housing: where its solid has the sides of a polygon, a drawing has the arcs that they touch."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import pairwise

LARGEST = math.radians(8.0)
"""Turn from one side to the next up to which both stand for an arc [rad]: solids have 48 sides around."""
LEAST = 1e-6
"""Turn below which there is no corner [rad]."""
PIECES = 6
"""Straight pieces of the arc of one corner [-]."""


def rounded(points: Sequence[complex]) -> tuple[complex, ...]:
    """Return a line with arcs in place of small corners, each from as far before as behind, half a side at most.

    A regular polygon gives the circle that touches its sides.

    Args:
        points: From corner to corner; closed where the last one is the first [mm].

    >>> square = [cmath.rect(1.0 / math.cos(math.pi / 48.0), math.pi / 24.0 * k) for k in range(49)]
    >>> round(max(map(abs, rounded(square))), 6)
    1.0
    """
    closed = len(points) > 3 and abs(points[0] - points[-1]) < LEAST
    if not closed:
        inner = [piece for before, corner, behind in zip(points, points[1:], points[2:], strict=False)
                 for piece in _corner(before, corner, behind)]  # fmt: skip
        return (points[0], *inner, points[-1])
    ring = [points[-2], *points[:-1], points[0]]
    found = [piece for (before, corner), (_, behind) in pairwise(pairwise(ring))
             for piece in _corner(before, corner, behind)]  # fmt: skip
    return (*found, found[0])


def _corner(before: complex, corner: complex, behind: complex) -> list[complex]:
    """Return what stands for a corner."""
    first, second = corner - before, behind - corner
    turn = cmath.phase(second / first) if first and second else 0.0
    if not LEAST < abs(turn) < LARGEST:
        return [corner]
    far = min(abs(first), abs(second)) / 2.0
    start = corner - far * first / abs(first)
    middle = start + 1j * math.copysign(far / math.tan(abs(turn) / 2.0), turn) * first / abs(first)
    return [middle + (start - middle) * cmath.rect(1.0, turn * k / PIECES) for k in range(PIECES + 1)]
