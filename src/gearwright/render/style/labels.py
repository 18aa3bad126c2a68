"""Labels that do not overlap: each takes the first of its places that is free of parts and of other labels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.style import theme
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.marks import Box as Rectangle
from gearwright.render.vector.marks import Curve, Shape
from gearwright.render.vector.words import POINT, SPACING, text_width

MARGIN = 0.6
"""Free room around a label [mm]."""

Box = tuple[float, float, float, float]
"""Left, low, right, high [mm]."""


@dataclass
class Board:
    """A drawing in mm of paper, and what is taken of it."""

    axes: Axes
    taken: list[Box] = field(default_factory=list)
    labels: list[Box] = field(default_factory=list)
    """Boxes of the labels alone."""

    def take_parts(self) -> None:
        """Count everything drawn so far as taken."""
        self.taken += [mark.box for mark in (*self.axes.of(Rectangle), *self.axes.of(Shape))]
        for curve in self.axes.of(Curve):
            points = np.stack([curve.x, curve.y], axis=1).tolist()
            self.taken += [(min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1]))
                           for a, b in pairwise(points)]  # fmt: skip

    def place(
        self, text: str, places: Iterable[tuple[float, float]], *, size: float = 6.5, bold: bool = False,
        colour: str = theme.INK,
    ) -> Box:  # fmt: skip
        """Write a label at the first of its places that is free, or else where it overlaps least.

        Args:
            text: Lines to write: names, numbers, and symbols between dollar signs.
            places: Middles (x, y) in order of preference [mm].
            size: Of the font [pt].
            bold: First line in bold.
            colour: Of the text.

        Returns:
            The label's box.
        """
        lines = text.split("\n")
        width, height = max(text_width(line, size, math=True) for line in lines), len(lines) * size * SPACING * POINT
        boxes = [(x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0) for x, y in places]
        taken = np.array(self.taken).reshape(-1, 4)
        box = min(boxes, key=lambda place: _covered(place, taken))
        for k, line in enumerate(lines):
            y = box[3] - (k + 0.5) * size * SPACING * POINT
            self.axes.text((box[0] + box[2]) / 2.0, y, line, ha="center", va="center_baseline", fontsize=size,
                           color=colour, weight="bold" if bold and k == 0 else "normal", zorder=8,
                           parse_math=True)  # fmt: skip
        self.taken.append(box)
        self.labels.append(box)
        return box

    def extent(self) -> Box:
        """Return the box of everything that is taken [mm]."""
        return (
            min(box[0] for box in self.taken), min(box[1] for box in self.taken),
            max(box[2] for box in self.taken), max(box[3] for box in self.taken),
        )  # fmt: skip


def spread(places: Sequence[float], gap: float) -> list[float]:
    """Return places in their order that are moved as little as keeps them a gap apart.

    Args:
        places: Rising.
        gap: Least distance.

    >>> spread([0.0, 0.0, 10.0], 2.0)
    [-1.0, 1.0, 10.0]
    """
    groups: list[list[float]] = []
    for place in places:
        groups.append([place])
        while len(groups) > 1 and _middle(groups[-1]) - _middle(groups[-2]) < gap * len(groups[-2] + groups[-1]) / 2.0:
            last = groups.pop()
            groups[-1] += last
    return [_middle(group) + gap * (k - (len(group) - 1) / 2.0) for group in groups for k in range(len(group))]


def _middle(group: list[float]) -> float:
    return sum(group) / len(group)


def _covered(box: Box, taken: Floats) -> float:
    """Return the sum of the `overlap` of a box with others [mm²], shape (others, 4)."""
    size = np.minimum(box[2:], taken[:, 2:]) - np.maximum(box[:2], taken[:, :2]) + MARGIN
    return float(np.prod(np.maximum(size, 0.0), axis=1).sum())


def overlap(box: Box, other: Box) -> float:
    """Return the area in which two boxes meet, free room around them counted [mm²].

    Args:
        box: Of a label.
        other: Of anything.
    """
    width = min(box[2], other[2]) - max(box[0], other[0]) + MARGIN
    height = min(box[3], other[3]) - max(box[1], other[1]) + MARGIN
    return max(width, 0.0) * max(height, 0.0)
