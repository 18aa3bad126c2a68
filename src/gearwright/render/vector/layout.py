"""Where panels stand on paper: as large as numbers, names, titles and legends around them leave room for."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.render.vector.axes import Axes
from gearwright.render.vector.axis import Axis
from gearwright.render.vector.figure import Figure
from gearwright.render.vector.ink import Frame
from gearwright.render.vector.keys import key_rows, key_size
from gearwright.render.vector.marks import Words
from gearwright.render.vector.scales import Scale, Ticks, linear_ticks, log_ticks
from gearwright.render.vector.words import POINT, SPACING, text_width

EDGE, GAP = 1.5, 2.5
"""Free room at the edge of the paper and between panels [mm]."""
TICK = 0.9
"""Length of a mark, and half the room between it and its number [mm]."""
ROUNDS = 3
"""Of the layout: numbers depend on sizes, sizes on numbers."""
STEP = {"x": 16.0, "y": 9.0}
"""Least distance of two numbers [mm]."""


def line_height(size: float) -> float:
    """Return the height of a line of text [mm].

    Args:
        size: Of the font [pt].
    """
    return size * SPACING * POINT


def ticks_of(axis: Axis, length: float, direction: str) -> Ticks:
    """Return the marks of an axis.

    Args:
        axis: Whose.
        length: On paper [mm].
        direction: ``x`` or ``y``.
    """
    low, high = sorted(axis.limits())
    if axis.values is not None:
        inside = [(v, k) for k, v in enumerate(axis.values) if low - 1e-9 * abs(low) <= v <= high + 1e-9 * abs(high)]
        names = axis.names or [f"{value:.6g}".replace("-", "−") for value in axis.values]
        return Ticks([value for value, _ in inside], [names[k] for _, k in inside], [])
    most = axis.most or max(2, int(length / STEP[direction]))
    return log_ticks(low, high, most + 2) if axis.log else linear_ticks(low, high, most)


def scales_of(axes: Axes, frame: Frame) -> tuple[Scale, Scale]:
    """Return from data to paper along x and y.

    Args:
        axes: The panel.
        frame: Its place.
    """
    (x0, x1), (y0, y1) = axes.x.limits(), axes.y.limits()
    if axes.aspect == "data":
        per = max(abs(x1 - x0) / (frame[2] - frame[0]), abs(y1 - y0) / (frame[3] - frame[1]))
        x_more, y_more = (per * (frame[k + 2] - frame[k]) - abs(d) for k, d in ((0, x1 - x0), (1, y1 - y0)))
        x0, x1, y0, y1 = x0 - x_more / 2.0, x1 + x_more / 2.0, y0 - y_more / 2.0, y1 + y_more / 2.0
    return Scale(x0, x1, frame[0], frame[2], axes.x.log), Scale(y0, y1, frame[1], frame[3], axes.y.log)


def laid_out(figure: Figure) -> list[Frame]:
    """Return the frame of every panel [mm].

    Args:
        figure: To lay out.
    """
    if figure.bare:
        return [(0.0, 0.0, figure.width, figure.height)]
    below = line_height(6.5) + 1.0 if figure.caption else 0.0
    if figure.shared_key:
        below += key_size(key_rows(figure.axes[0]), figure.shared_key, 7.5)[1] + 1.0
    paper = (EDGE, EDGE + below, figure.width - EDGE, figure.height - EDGE)
    frames = _frames(figure, paper, np.zeros((len(figure.slots), 4)) + 8.0)
    for _ in range(ROUNDS):
        around = np.array([overhang(slot.axes, frame) for slot, frame in zip(figure.slots, frames, strict=True)])
        frames = _frames(figure, paper, around)
    return [_squared(slot.axes, frame) for slot, frame in zip(figure.slots, frames, strict=True)]


def _squared(axes: Axes, frame: Frame) -> Frame:
    if axes.aspect != "box":
        return frame
    (x0, x1), (y0, y1) = axes.x.limits(), axes.y.limits()
    width, height = frame[2] - frame[0], frame[3] - frame[1]
    per = max(abs(x1 - x0) / width, abs(y1 - y0) / height)
    cut_x, cut_y = (width - abs(x1 - x0) / per) / 2.0, (height - abs(y1 - y0) / per) / 2.0
    return frame[0] + cut_x, frame[1] + cut_y, frame[2] - cut_x, frame[3] - cut_y


def _frames(figure: Figure, paper: Frame, around: np.ndarray) -> list[Frame]:
    """Return frames with the widest surroundings of each row and column kept free."""
    rows, columns = len(figure.heights), len(figure.widths)
    row, column = (np.array([getattr(slot, name) for slot in figure.slots]) for name in ("row", "column"))
    left, right = (np.array([around[column == k, side].max() for k in range(columns)]) for side in (0, 2))
    low, high = (np.array([around[row == k, side].max() for k in range(rows)]) for side in (1, 3))
    x = _shares(paper[0], paper[2], left, right, figure.widths)
    y = _shares(paper[1], paper[3], low[::-1], high[::-1], figure.heights[::-1])[::-1]
    return [(x[slot.column][0], y[slot.row][0], x[slot.column][1], y[slot.row][1]) for slot in figure.slots]


def _shares(
    start: float, end: float, before: np.ndarray, after: np.ndarray, parts: Sequence[float]
) -> list[tuple[float, float]]:
    free = end - start - float(before.sum() + after.sum()) - GAP * (len(parts) - 1)
    sizes = np.maximum(free, 5.0 * len(parts)) * np.array(parts) / sum(parts)
    places = []
    for k, size in enumerate(sizes.tolist()):
        start += float(before[k])
        places.append((start, start + size))
        start += size + float(after[k]) + GAP
    return places


def overhang(axes: Axes, frame: Frame) -> tuple[float, float, float, float]:
    """Return how far words stand out of a frame: left, below, right, above [mm].

    Args:
        axes: The panel.
        frame: Its place.
    """
    left, low, _, high = words_overhang(axes, frame)
    right = outside(axes, frame)
    if not axes.off:
        left, low = max(left, _side(axes.y, frame[3] - frame[1])), max(low, _below(axes.x))
        high = max(high, line_height(axes.y.size) / 2.0 - 1.0)
    if axes.key is not None:
        width, height = key_size(key_rows(axes), axes.key.columns, axes.key.size, axes.key.title)
        right += width + 3.0 if axes.key.where == "right" else 0.0
        low += height + 1.0 if axes.key.where == "below" else 0.0
        high += height + 1.0 if axes.key.where == "above" else 0.0
    if axes.title:
        high += len(axes.title.split("\n")) * line_height(axes.title_size) + 2.0
    return left, low, right, high


def outside(axes: Axes, frame: Frame) -> float:
    """Return how far words and numbers stand out of a frame on the right, its legend left out [mm].

    Args:
        axes: The panel.
        frame: Its place.
    """
    right = words_overhang(axes, frame)[2]
    if axes.off:
        return right
    names = ticks_of(axes.x, frame[2] - frame[0], "x").names if axes.x.numbers else []
    right = max(
        right, text_width(names[-1], axes.x.size, math=axes.x.names is None, bold=False) / 2.0 if names else 0.0
    )
    return right if axes.twin is None else max(right, _side(axes.twin.y, frame[3] - frame[1]))


def _side(axis: Axis, length: float) -> float:
    """Return the room of numbers and name of an upright axis [mm]."""
    names = ticks_of(axis, length, "y").names if axis.numbers else []
    words = [word for name in names for word in name.split("\n")]
    width = max((text_width(word, axis.size, math=axis.names is None, bold=False) for word in words),
                default=0.0)  # fmt: skip
    label = len(axis.label.split("\n")) * line_height(8.0) + 0.5 if axis.label else 0.0
    return (width + 2.0 * TICK if names else 0.0) + label


def _below(axis: Axis) -> float:
    """Return the room of numbers and name of a level axis [mm]."""
    lines = max((len(name.split("\n")) for name in axis.names or [""]), default=1)
    numbers = lines * line_height(axis.size) + 2.0 * TICK if axis.numbers else 0.0
    return numbers + (len(axis.label.split("\n")) * line_height(8.0) + 0.3 if axis.label else 0.0)


def words_overhang(axes: Axes, frame: Frame) -> tuple[float, float, float, float]:
    """Return how far the words of marks stand out of a frame: left, below, right, above [mm].

    Args:
        axes: The panel.
        frame: Its place.
    """
    boxes = [words_box(words, axes, frame) for words in axes.of(Words) if np.isfinite([words.x, words.y]).all()]
    if not boxes:
        return 0.0, 0.0, 0.0, 0.0
    ends = np.array(boxes)
    reach = (frame[0] - ends[:, 0].min(), frame[1] - ends[:, 1].min(), ends[:, 2].max() - frame[2],
             ends[:, 3].max() - frame[3])  # fmt: skip
    return tuple(max(0.0, float(value)) for value in reach)  # type: ignore[return-value]


def words_at(words: Words, axes: Axes, frame: Frame) -> tuple[float, float]:
    """Return where words are held [mm].

    Args:
        words: On the panel.
        axes: The panel.
        frame: Its place.
    """
    scales = scales_of(axes, frame)
    at = [
        frame[k] + value * (frame[k + 2] - frame[k]) if how == "axes" else scales[k].place(value)
        for k, (value, how) in enumerate(zip((words.x, words.y), words.frames, strict=True))
    ]
    return at[0] + words.shift[0] * POINT, at[1] + words.shift[1] * POINT


def words_box(words: Words, axes: Axes, frame: Frame) -> Frame:
    """Return the box of words, turned ones as well.

    Args:
        words: On the panel.
        axes: The panel.
        frame: Its place.
    """
    x, y = words_at(words, axes, frame)
    lines = words.text.split("\n")
    width = max(text_width(line, words.size, math=words.math, bold=words.bold) for line in lines)
    height = len(lines) * line_height(words.size)
    left = {"left": 0.0, "center": -width / 2.0, "right": -width}[words.across]
    low = {"baseline": -0.25 * line_height(words.size), "bottom": 0.0, "center": -height / 2.0, "top": -height}[
        words.up
    ]
    if not words.turned:
        return x + left, y + low, x + left + width, y + low + height
    angle = np.radians(words.turned)
    cosine, sine = abs(float(np.cos(angle))), abs(float(np.sin(angle)))
    across, up = width * cosine + height * sine, width * sine + height * cosine
    low = {"center": -up / 2.0, "top": -up}.get(words.up, 0.0)
    left = {"left": 0.0, "center": -across / 2.0, "right": -across}[words.across]
    return x + left, y + low, x + left + across, y + low + up
