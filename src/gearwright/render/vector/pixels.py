"""A figure as PNG: matplotlib sets its ink in pixels; nothing else of a figure needs it."""

import io
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Plotted
from matplotlib.patches import Circle, PathPatch, Rectangle
from matplotlib.path import Path as Outline

from gearwright.render.vector.figure import MUTED, PAPER, Figure
from gearwright.render.vector.layout import Disc, DrawnPath, Image, Ink, Line, TextRun
from gearwright.render.vector.svg import painted

INCH = 25.4
"""[mm]"""
_STYLE: dict[Any, Any] = {
    "font.family": ["DejaVu Sans"],
    "hatch.linewidth": 0.6,
    "text.parse_math": True,
    "path.simplify": True,
}


def to_png(figure: Figure, resolution: float) -> bytes:
    """Return a figure as a PNG image.

    Args:
        figure: As drawn.
        resolution: [dots per inch].
    """
    buffer = io.BytesIO()
    with mpl.rc_context(_STYLE):
        plotted = Plotted(figsize=(figure.width / INCH, figure.height / INCH), facecolor=PAPER)
        axes = plotted.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set_axis_off()
        for place, drop in enumerate(painted(figure)):
            _put(axes, drop, place)
        axes.set(xlim=(0.0, figure.width), ylim=(0.0, figure.height))
        plotted.savefig(buffer, format="png", dpi=resolution, metadata={"Software": None})
    return buffer.getvalue()


def _put(axes: Axes, drop: Ink, layer: int) -> None:
    if isinstance(drop, Line):
        words = "".join(_math(span) for span in drop.spans)
        across = {"start": "left", "middle": "center", "end": "right"}[drop.anchor]
        axes.text(drop.x, drop.y, words, fontsize=drop.size, color=drop.colour, ha=across, va="baseline",
                  rotation=drop.turned, rotation_mode="anchor", weight="bold" if drop.bold else "normal",
                  zorder=layer)  # fmt: skip
        return
    if isinstance(drop, Image):
        left, low, right, high = drop.frame
        axes.imshow(drop.pixels, extent=(left, right, low, high), origin="lower", aspect="auto", zorder=layer)
        return
    if isinstance(drop, Disc):
        patch: Circle | PathPatch = Circle((drop.x, drop.y), drop.radius, fc=drop.fill, ec=drop.edge or "none",
                                           lw=drop.edge_width, alpha=drop.alpha, zorder=layer)  # fmt: skip
    else:
        patch = _patch(drop, layer)
    axes.add_patch(patch)
    if drop.clip is not None:
        left, low, right, high = drop.clip
        patch.set_clip_path(Rectangle((left, low), right - left, high - low, transform=axes.transData))


def _patch(path: DrawnPath, layer: int) -> PathPatch:
    parts = []
    for piece in path.pieces:
        codes = np.full(len(piece), Outline.CURVE4 if path.cubic else Outline.LINETO, dtype=Outline.code_type)
        codes[0] = Outline.MOVETO
        corners = np.asarray(piece, dtype=float)
        if path.closed:
            corners, codes = np.concatenate([corners, corners[:1]]), np.append(codes, Outline.CLOSEPOLY)
        parts.append(Outline(corners, codes))
    pen = path.pen
    outline = Outline.make_compound_path(*parts) if parts else Outline(np.zeros((1, 2)))
    fill = mpl.colors.to_rgba(path.fill, path.alpha) if path.fill else "none"
    patch = PathPatch(outline, fc=fill, ec="none", lw=0.0, zorder=layer, hatch="//////" if path.hatched else None)
    if path.hatched:
        patch.set_edgecolor(MUTED)
    if pen is not None:
        patch.set(edgecolor=mpl.colors.to_rgba(pen.colour, pen.alpha), linewidth=pen.width, linestyle=pen.dash or "-",
                  capstyle="butt")  # fmt: skip
    return patch


def _math(span: TextRun) -> str:
    """Return a piece as matplotlib reads it, what is a dollar sign to users left one."""
    if not span.shift and not span.italic:
        return span.text.replace("$", r"\$")
    words = span.text if span.italic else rf"\mathrm{{{span.text}}}"
    return f"${words}$" if not span.shift else f"${{}}{'_' if span.shift < 0 else '^'}{{{span.text}}}$"
