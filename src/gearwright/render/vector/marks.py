"""Marks on a panel, in the units of its data: curves, fills, boxes, dots, rules, shapes, words, pictures."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.vector.palette import INK, MUTED

EMPTY: Floats = np.zeros(0)


@dataclass(frozen=True)
class Pen:
    """How a line is drawn."""

    colour: str = INK
    width: float = 1.1
    """[pt]"""
    dash: str = "-"
    """``-``, ``--``, ``:`` or empty for no line."""
    alpha: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Mark:
    """What all marks have."""

    layer: float = 2.0
    label: str = ""
    """In the legend."""
    name: str = ""
    """What a pointer is told."""


@dataclass(frozen=True)
class Curve(Mark):
    """A line through points, and marks at them."""

    x: Floats
    y: Floats
    pen: Pen
    marker: str = ""
    """``o``, ``s``, ``^``, ``D``, ``v``, ``.`` or ``_``."""
    size: float = 6.0
    """Of the marks [pt]."""
    face: str = ""
    edge: str = ""
    edge_width: float = 0.0


@dataclass(frozen=True)
class Fill(Mark):
    """What lies between two curves."""

    x: Floats
    low: Floats
    high: Floats
    colour: str
    alpha: float = 1.0


@dataclass(frozen=True)
class Box(Mark):
    """A rectangle, such as a bar."""

    left: float
    low: float
    width: float
    height: float
    fill: str = ""
    edge: str = ""
    edge_width: float = 0.0
    alpha: float = 1.0
    hatched: bool = False
    bar: str = ""
    """Direction of the bar that it is: ``x``, ``y``, or empty."""

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Return left, low, right, high."""
        x, y = sorted((self.left, self.left + self.width)), sorted((self.low, self.low + self.height))
        return x[0], y[0], x[1], y[1]


@dataclass(frozen=True)
class Dots(Mark):
    """Discs whose areas mean something."""

    x: Floats
    y: Floats
    area: Floats
    """[pt²]"""
    faces: tuple[str, ...]
    edge: str = ""
    edge_width: float = 0.0
    alpha: float = 1.0


@dataclass(frozen=True)
class Rule(Mark):
    """A line or band across the whole panel."""

    axis: str
    """``x``: at a value of x, upright; ``y``: level."""
    low: float
    high: float
    """The same as low: a line."""
    pen: Pen


@dataclass(frozen=True)
class Shape(Mark):
    """A polygon or a closed path of cubic curves."""

    points: Floats
    """Shape (points, 2)."""
    fill: str = ""
    edge: str = ""
    edge_width: float = 0.0
    alpha: float = 1.0
    cubic: bool = False
    """Points after the first come in threes, two of them handles."""

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Return left, low, right, high."""
        low, high = np.min(self.points, axis=0), np.max(self.points, axis=0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])


@dataclass(frozen=True)
class Words(Mark):
    """A text at a place."""

    text: str
    x: float
    y: float
    frames: tuple[str, str] = ("data", "data")
    """What x and y count in: ``data`` or ``axes`` (0 to 1 across the panel)."""
    shift: tuple[float, float] = (0.0, 0.0)
    """[pt]"""
    size: float = 8.0
    """[pt]"""
    colour: str = INK
    across: str = "left"
    """``left``, ``center`` or ``right``."""
    up: str = "baseline"
    """``baseline``, ``center``, ``top`` or ``bottom``."""
    turned: float = 0.0
    """[°]"""
    bold: bool = False
    math: bool = False
    leader: tuple[float, float] | None = None
    """Point of the data that a thin line leads to."""
    leader_colour: str = MUTED


@dataclass(frozen=True)
class Picture(Mark):
    """Colours in cells, the first row lowest."""

    left: float
    low: float
    right: float
    high: float
    pixels: np.ndarray = field(repr=False)
    """Shape (rows, columns, 3), bytes."""


def circle(centre: tuple[float, float], width: float, height: float) -> Floats:
    """Return an ellipse as four cubic curves.

    Args:
        centre: (x, y).
        width: Whole.
        height: Whole.
    """
    k = 0.5522847498
    unit = [(1, 0), (1, k), (k, 1), (0, 1), (-k, 1), (-1, k), (-1, 0), (-1, -k), (-k, -1), (0, -1), (k, -1), (1, -k),
            (1, 0)]  # fmt: skip
    return np.array([(centre[0] + width / 2.0 * x, centre[1] + height / 2.0 * y) for x, y in unit])
