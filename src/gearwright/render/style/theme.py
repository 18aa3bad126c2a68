"""The look of every figure: one font, one small palette, a thin grid; and a figure as SVG or PNG, the same each time.

Figures are values of `vector`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import ParamSpec

import numpy as np

from gearwright.render.vector.figure import Figure
from gearwright.render.vector.palette import (
    AMBER,
    BLUE,
    CYCLE,
    GREEN,
    HAIR,
    INK,
    MUTED,
    ORANGE,
    PAPER,
    PURPLE,
    SKY,
    STEEL,
)  # fmt: skip
from gearwright.render.vector.svg import svg_text
from gearwright.verbs import verb

Drawing = Figure

__all__ = [
    "AMBER", "BLUE", "CYCLE", "GREEN", "HAIR", "INCH", "INK", "KIND_COLOURS", "MUTED", "ORANGE", "PAPER", "PURPLE",
    "RESOLUTION", "SKY", "STEEL", "WIDTH", "drawn", "sheet", "tiles", "to_png", "to_svg",
]  # fmt: skip

WIDTH = 180.0
"""Of a figure on an A4 page [mm]."""
KIND_COLOURS: Mapping[str, str] = MappingProxyType({"turbine": BLUE, "motor": ORANGE, "propeller": GREEN})
"""Colour of the power that each kind of machine gives."""
INCH = 25.4
"""[mm]; figures are sized in mm of paper."""
RESOLUTION = 160.0
"""Of PNG images [dots per inch]."""

_Inputs = ParamSpec("_Inputs")


def drawn(draw: Callable[_Inputs, Figure]) -> Callable[_Inputs, Figure]:
    """Return a drawing function that refuses what is not of its types, as every public verb.

    Args:
        draw: Builds the figure.
    """
    return functools.wraps(draw)(verb(draw))


def sheet(width: float, height: float) -> Figure:
    """Return an empty figure.

    Args:
        width: Of the paper [mm].
        height: Of the paper [mm].
    """
    return Figure(width, height)


def tiles(
    count: int, columns: int, *, frame: float, row: float, share_x: bool = False, share_y: str = ""
) -> tuple[Figure, np.ndarray]:
    """Return a figure as wide as a page and its panels in rows; those that are left over stay empty.

    Args:
        count: Of panels that are drawn.
        columns: Panels side by side.
        frame: Height of all that stands outside the rows [mm].
        row: Height of a row [mm].
        share_x: One scale along x for all.
        share_y: ``all``: one scale along y for all.
    """
    rows = max(1, -(-count // columns))
    figure = sheet(WIDTH, frame + row * rows)
    grid = figure.grid(rows, columns, share_x=share_x, share_y=share_y)
    for axes in grid.flat[count:]:
        axes.set_axis_off()
    return figure, grid


def to_svg(figure: Figure, prefix: str = "", *, styled: bool = True) -> str:
    """Return a figure as an SVG element that stands alone or inside a page.

    Args:
        figure: As drawn.
        prefix: Goes before every id, so that several figures can share a page.
        styled: With its own style; else the page has it.
    """
    return svg_text(figure, prefix, styled=styled)


def to_png(figure: Figure, resolution: float = RESOLUTION) -> bytes:
    """Return a figure as a PNG image.

    Args:
        figure: As drawn.
        resolution: [dots per inch].

    Raises:
        DesignError: If matplotlib is not installed.
    """
    return figure.png(resolution)
