"""What a writer puts on paper: paths, discs, words and pictures, in mm from the lower left corner."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.vector.marks import Pen
from gearwright.render.vector.words import Span

Frame = tuple[float, float, float, float]
"""Left, low, right, high [mm]."""


@dataclass(frozen=True)
class Path:
    """Lines, or a filled shape."""

    pieces: tuple[Floats, ...]
    """Each of shape (points, 2) [mm]."""
    pen: Pen | None = None
    fill: str = ""
    alpha: float = 1.0
    """Of the fill."""
    closed: bool = False
    cubic: bool = False
    hatched: bool = False
    clip: Frame | None = None


@dataclass(frozen=True)
class Disc:
    """A filled circle."""

    x: float
    y: float
    radius: float
    """[mm]"""
    fill: str
    edge: str = ""
    edge_width: float = 0.0
    alpha: float = 1.0
    clip: Frame | None = None


@dataclass(frozen=True)
class Line:
    """One line of text from its base line."""

    x: float
    y: float
    spans: tuple[Span, ...]
    size: float
    """[pt]"""
    colour: str
    anchor: str
    """``start``, ``middle`` or ``end``."""
    turned: float = 0.0
    """[°]"""
    bold: bool = False


@dataclass(frozen=True)
class Image:
    """Cells of colours."""

    frame: Frame
    pixels: np.ndarray


Ink = Path | Disc | Line | Image
