"""Marks that are made of several: stacks, ranges, and maps of colours with their bar."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.palette import BLUE, PAPER

NIGHT: tuple[str, ...] = (PAPER, "#c5dcec", BLUE, "#0b2d4a", "#05121f")
"""From nothing to the most, on light paper."""
DUSK: tuple[str, ...] = ("#00224e", "#2a3f6d", "#575c6d", "#7d7c78", "#a59c74", "#d2c060", "#fee838")
"""From low to high, even to those who do not tell red from green; anchors of cividis, Nuñez et al. 2018."""
CELLS = 64
"""Of a bar of colours."""


def stacked(
    axes: Axes, x: Floats, parts: Sequence[Floats], *, colours: Sequence[str], labels: Sequence[str] = (),
    alpha: float = 1.0,
) -> None:  # fmt: skip
    """Fill parts on top of each other.

    Args:
        axes: To draw on.
        x: Places.
        parts: From the lowest on.
        colours: Of each.
        labels: In the legend.
        alpha: Of the fills [-].
    """
    low = np.zeros(len(x))
    for k, (part, colour) in enumerate(zip(parts, colours, strict=False)):
        label = labels[k] if k < len(labels) else ""
        axes.fill_between(x, low, low + part, color=colour, alpha=alpha, label=label)
        low = low + part


def upright_ranges(axes: Axes, x: Floats, low: Floats, high: Floats, *, colour: str, width: float = 1.2) -> None:
    """Draw an upright line from low to high at every place.

    Args:
        axes: To draw on.
        x: Places.
        low: Lower ends.
        high: Upper ends.
        colour: Of the lines.
        width: [pt].
    """
    gap = np.full(len(x), np.nan)
    axes.plot(np.repeat(x, 3), np.stack([low, high, gap], axis=1).ravel(), color=colour, lw=width)


def shades(levels: Floats, anchors: Sequence[str]) -> np.ndarray:
    """Return colours of levels as bytes, shape (…, 3); what is not a number is paper.

    Args:
        levels: From 0 to 1.
        anchors: Colours at even distances.
    """
    known = np.array([[int(anchor[k : k + 2], 16) for k in (1, 3, 5)] for anchor in anchors], dtype=float)
    places = np.linspace(0.0, 1.0, len(known))
    mixed = np.stack([np.interp(levels, places, known[:, k]) for k in range(3)], axis=-1)
    return np.where(np.isfinite(levels)[..., None], np.round(mixed), 255).astype(np.uint8)


def shade(level: float, anchors: Sequence[str] = DUSK) -> str:
    """Return one colour as ``#rrggbb``.

    Args:
        level: From 0 to 1.
        anchors: Colours at even distances.
    """
    return "#" + "".join(f"{part:02x}" for part in shades(np.array(level), anchors).tolist())


def colour_bar(axes: Axes, limits: tuple[float, float], anchors: Sequence[str], *, upright: bool) -> None:
    """Draw a bar of colours over a whole panel, with its values at one axis.

    Args:
        axes: The bar's own panel.
        limits: Values at its ends.
        anchors: Colours at even distances.
        upright: From below to above; else from left to right.
    """
    ramp = shades(np.linspace(0.0, 1.0, CELLS), anchors)
    low, high = limits
    box = (0.0, low, 1.0, high) if upright else (low, 0.0, high, 1.0)
    axes.picture(box, ramp[:, None] if upright else ramp[None])
    other = axes.x if upright else axes.y
    other.numbers = other.ticks = False
    axes.x.grid = axes.y.grid = False
    axes.set(xlim=box[::2], ylim=box[1::2])
