"""How paths that lie around a shaft share its load, as a polar figure: planets round their carrier."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.sharing import LoadSharing
from gearwright.render.style import theme
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure

SIDES = 120
"""Corners of what is drawn for a circle."""
RING = 0.25
"""Step of the rings [-]."""
NEARLY, ROOM, WIDE = 0.2, 0.5, 2.8
"""What is counted as above or below the middle, room for words around the rings [-], half the width over the rings."""


@theme.drawn
def around_figure(sharing: LoadSharing) -> Figure:
    """Return the sharing coefficients of parallel paths in their order round the shaft, the first one on top.

    Args:
        sharing: Of three paths or more.
    """
    shares = sharing.instantaneous
    low, middle, high = shares.min(axis=0), shares.mean(axis=0), shares.max(axis=0)
    figure = theme.sheet(theme.WIDTH, 92.0)
    axes = figure.panel()
    axes.set_axis_off()
    axes.set_aspect("data")
    reach = _rings(axes, max(1.0, float(high.max())))
    turn = np.pi / 2.0 - 2.0 * np.pi * np.arange(len(middle)) / len(middle)
    half = 0.8 * np.pi / len(middle)
    for k, angle in enumerate(turn):
        colour = theme.CYCLE[k % len(theme.CYCLE)]
        arc = np.linspace(angle - half, angle + half, SIDES // 4)
        x, y = _places(arc, np.full(len(arc), middle[k]))
        axes.shape(np.stack([np.append(x, 0.0), np.append(y, 0.0)], axis=1), fc=colour, alpha=0.35, zorder=2.0)
        axes.plot(*_places(np.full(2, angle), np.array([low[k], high[k]])), color=colour, lw=3.0, zorder=3.0)
        at = (reach + 0.25) * np.cos(angle), (reach + 0.25) * np.sin(angle)
        across = "center" if abs(at[0]) < NEARLY else "left" if at[0] > 0.0 else "right"
        axes.annotate(sharing.lines[k], at, (0, 1), fontsize=7.5, ha=across, weight="bold")
        words = f"mean {middle[k]:.3f}, {low[k]:.3f} to {high[k]:.3f}"
        axes.annotate(words, at, (0, -8), fontsize=7.0, ha=across, color=theme.MUTED)
    axes.set(xlim=(-WIDE * reach, WIDE * reach), ylim=(-reach - ROOM, reach + ROOM))
    return figure


def _rings(axes: Axes, most: float) -> float:
    """Draw a ring for every step of the coefficient, the equal share darker; return the last one's."""
    count = int(np.ceil(most / RING))
    around = np.linspace(0.0, 2.0 * np.pi, SIDES + 1)
    for step in range(1, count + 1):
        equal = step * RING == 1.0
        colour, width = (theme.MUTED, 1.0) if equal else (theme.HAIR, 0.6)
        axes.plot(*_places(around, np.full(len(around), step * RING)), color=colour, lw=width, zorder=1.0)
    return count * RING


def _places(angle: Floats, radius: Floats) -> tuple[Floats, Floats]:
    return radius * np.cos(angle), radius * np.sin(angle)
