"""Legends: which marks have a name, how much room the names take, and what stands before each."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from gearwright.render.vector import marks as m
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.ink import Disc, Frame, Ink, Line, Path
from gearwright.render.vector.palette import INK
from gearwright.render.vector.words import POINT, SPACING, spans, text_width

SWATCH, BEFORE, BETWEEN = 6.0, 1.5, 4.0
"""Width of a sample, room after it, and room between columns [mm]."""


def key_rows(axes: Axes) -> list[m.Mark]:
    """Return the first mark of every name, in the order of drawing.

    Args:
        axes: The panel, with that on its right.
    """
    named: dict[str, m.Mark] = {}
    for mark in (*axes.marks, *(axes.twin.marks if axes.twin else ())):
        if mark.label:
            named.setdefault(mark.label, mark)
    return list(named.values())


def _columns(rows: list[m.Mark], columns: int, size: float) -> tuple[int, list[float]]:
    count = math.ceil(len(rows) / max(columns, 1)) or 1
    groups = [rows[k : k + count] for k in range(0, len(rows), count)]
    return count, [
        SWATCH + BEFORE + max(text_width(row.label, size, math=False, bold=False) for row in group) for group in groups
    ]


def key_size(rows: list[m.Mark], columns: int, size: float, title: str = "") -> tuple[float, float]:
    """Return width and height of a legend [mm].

    Args:
        rows: Marks with a name.
        columns: At most.
        size: Of the font [pt].
        title: Above them.
    """
    if not rows:
        return 0.0, 0.0
    count, widths = _columns(rows, columns, size)
    wide = max(sum(widths) + BETWEEN * (len(widths) - 1), text_width(title, size, bold=True))
    return wide, (count + bool(title)) * size * SPACING * POINT


def key_ink(rows: list[m.Mark], columns: int, size: float, *, at: tuple[float, float], title: str = "") -> list[Ink]:
    """Return the ink of a legend.

    Args:
        rows: Marks with a name.
        columns: At most.
        size: Of the font [pt].
        at: Its upper left corner [mm].
        title: Above the names.
    """
    if not rows:
        return []
    count, widths = _columns(rows, columns, size)
    high = size * SPACING * POINT
    left, top = at
    ink: list[Ink] = []
    if title:
        ink.append(Line(left, top - 0.72 * high, spans(title, math=False), size, INK, "start", bold=True))
        top -= high
    for k, row in enumerate(rows):
        column, place = divmod(k, count)
        x = left + sum(widths[:column]) + BETWEEN * column
        y = top - (place + 0.5) * high
        ink += _sample(row, x, y)
        ink.append(Line(x + SWATCH + BEFORE, y - 0.27 * high, spans(row.label, math=False), size, INK, "start"))
    return ink


def _sample(row: m.Mark, x: float, y: float) -> list[Ink]:
    if isinstance(row, m.Curve):
        ends = np.array([(x, y), (x + SWATCH, y)])
        line: list[Ink] = [Path((ends,), replace(row.pen, alpha=1.0))] if row.pen.dash else []
        return line + ([marker_ink(row, x + SWATCH / 2.0, y, None)] if row.marker else [])
    if isinstance(row, m.Dots):
        radius = min(2.0, math.sqrt(float(row.area[0]) / math.pi) * POINT)
        return [Disc(x + SWATCH / 2.0, y, radius, row.faces[0], row.edge, row.edge_width, row.alpha)]
    fill = row.fill if isinstance(row, m.Box | m.Shape) else row.colour if isinstance(row, m.Fill) else INK
    alpha = row.alpha if isinstance(row, m.Box | m.Fill | m.Shape) else 1.0
    corners = np.array([(x, y - 0.9), (x + SWATCH, y - 0.9), (x + SWATCH, y + 0.9), (x, y + 0.9)])
    return [Path((corners,), None, fill, alpha, closed=True)]


_CORNERS = {
    "s": [(-1, -1), (1, -1), (1, 1), (-1, 1)], "^": [(-1, -1), (1, -1), (0, 1)], "v": [(-1, 1), (1, 1), (0, -1)],
    "<": [(1, -1), (1, 1), (-1, 0)], ">": [(-1, -1), (-1, 1), (1, 0)],
    "D": [(0, -1), (1, 0), (0, 1), (-1, 0)],
    "P": [(-1, -0.4), (-0.4, -0.4), (-0.4, -1), (0.4, -1), (0.4, -0.4), (1, -0.4), (1, 0.4), (0.4, 0.4), (0.4, 1),
          (-0.4, 1), (-0.4, 0.4), (-1, 0.4)],
}  # fmt: skip


def marker_ink(curve: m.Curve, x: float, y: float, clip: Frame | None) -> Ink:
    """Return the ink of one mark of a curve.

    Args:
        curve: Whose.
        x: Place [mm].
        y: Place [mm].
        clip: What it must not leave.
    """
    radius = curve.size * POINT / 2.0
    if curve.marker == "_":
        return Path((np.array([(x - radius, y), (x + radius, y)]),), m.Pen(curve.face, 1.4, "-", curve.pen.alpha))
    if curve.marker in _CORNERS:
        corners = np.array(_CORNERS[curve.marker]) * radius * 0.9 + (x, y)
        pen = m.Pen(curve.edge, curve.edge_width) if curve.edge else None
        return Path((corners,), pen, curve.face, curve.pen.alpha, closed=True, clip=clip)
    radius *= 0.5 if curve.marker == "." else 1.0
    return Disc(x, y, radius, curve.face, curve.edge, curve.edge_width, curve.pen.alpha, clip)
