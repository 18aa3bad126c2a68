"""Where panels, legends and words stand on paper: widths of text, scales of axes, room around them, ink."""

import functools
import json
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import resources
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.render.vector import figure as m
from gearwright.render.vector.figure import INK, Axes, Axis, Figure, Pen, TextMark

# ----------------------------------------------------------------------------------------------------------------------
# Text on paper: how wide it is, and what of it stands higher or lower.
# ----------------------------------------------------------------------------------------------------------------------


POINT = 25.4 / 72.0
"""One typographic point [mm]."""
SPACING = 1.3
"""Line height over font size [-]."""
SMALL = 0.72
"""Size of what stands higher or lower, over the rest [-]."""
_EM = 2048.0
_USUAL = 1229
_PIECES = re.compile(r"([_^])(?:\{([^}]*)\}|(.))|([^_^]+)")
_LETTERS = re.compile(r"[A-Za-zα-ω]")


class TextRun(NamedTuple):
    """A piece of a line of text."""

    text: str
    shift: int
    """1 above, −1 below the line, 0 on it."""
    italic: bool


@functools.cache
def _widths(face: str) -> dict[int, int]:
    runs = json.loads(resources.files("gearwright.render.vector").joinpath("widths.json").read_text("utf-8"))[face]
    return {int(first) + k: width for first, run in runs.items() for k, width in enumerate(run)}


@functools.lru_cache(maxsize=4096)
def spans(text: str, *, math: bool) -> tuple[TextRun, ...]:
    """Return the pieces of a line.

    Args:
        text: The line.
        math: True: symbols stand between dollar signs, with ``_`` and ``^`` before what is lower and higher.

    >>> [span.text for span in spans("$z_2/z_1$ = 3", math=True)]
    ['z', '2', '/z', '1', ' = 3']
    """
    if not math or "$" not in text:
        return (TextRun(text, 0, italic=False),)
    found: list[TextRun] = []
    for k, part in enumerate(text.split("$")):
        if k % 2 == 0:
            found += [TextRun(part, 0, italic=False)] if part else []
            continue
        for sign, braced, single, plain in _PIECES.findall(part):
            words = braced or single or plain
            slanted = bool(_LETTERS.search(words)) and not sign
            found.append(TextRun(words, {"_": -1, "^": 1}.get(sign, 0), slanted))
    return tuple(found)


@functools.lru_cache(maxsize=8192)
def text_width(text: str, size: float, *, math: bool = False, bold: bool = True) -> float:
    """Return the width of one line [mm], in DejaVu Sans.

    Args:
        text: The line.
        size: Of the font [pt].
        math: True: symbols stand between dollar signs.
        bold: The wider face: what fits in bold fits in both.
    """
    table = _widths("bold" if bold else "regular")
    total = 0.0
    for span in spans(text, math=math):
        total += sum(table.get(ord(letter), _USUAL) for letter in span.text) * (SMALL if span.shift else 1.0)
    return total / _EM * size * POINT


# ----------------------------------------------------------------------------------------------------------------------
# Scales of axes: from values to paper, and the round numbers that stand beside an axis.
# ----------------------------------------------------------------------------------------------------------------------


PLAIN = (1e-3, 1e4)
"""Powers of ten between these are written out."""
ENOUGH = 6
"""Steps that are asked for at most where fewer leave less than three numbers."""
_STEPS = (1.0, 2.0, 5.0, 10.0)


class Scale(NamedTuple):
    """A straight or logarithmic way from values to places on paper."""

    low: float
    """Value at the start."""
    high: float
    start: float
    """Place of the lowest value [mm]."""
    end: float
    log: bool = False

    def places(self, values: Floats) -> Floats:
        """Return where values stand [mm]."""
        numbers = np.asarray(values, dtype=float)
        if not self.log:
            return self.start + (numbers - self.low) * ((self.end - self.start) / (self.high - self.low))
        low, high = math.log10(self.low), math.log10(self.high)
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (np.log10(numbers) - low) / (high - low)
        # What is not positive lies far below the paper, so that a curve leaves it downwards.
        part = np.where(numbers > 0.0, part, np.where(np.isnan(numbers), np.nan, -9.0))
        return self.start + part * (self.end - self.start)

    def place(self, value: float) -> float:
        """Return where one value stands [mm]."""
        return float(self.places(np.array([value]))[0])


class Ticks(NamedTuple):
    """Marks of an axis."""

    values: list[float]
    names: list[str]
    minor: list[float]
    """Values of marks without a name."""


def nice_step(span: float, most: int) -> float:
    """Return the smallest of 1, 2, 5 times a power of ten that divides a span into no more than so many parts.

    Args:
        span: Positive.
        most: Parts.

    Source: P. S. Heckbert, Nice Numbers for Graph Labels, Graphics Gems, Academic Press 1990.

    >>> nice_step(7.3, 5)
    2.0
    """
    raw = span / max(most, 1)
    power = 10.0 ** math.floor(math.log10(raw))
    return next(step for step in _STEPS if step * power >= raw * (1.0 - 1e-9)) * power


def linear_ticks(low: float, high: float, most: int = 7) -> Ticks:
    """Return round numbers from low to high, at most so many steps apart.

    Args:
        low: Of the axis.
        high: Above it.
        most: Steps.

    >>> linear_ticks(0.0, 1.0, 5).names
    ['0.0', '0.2', '0.4', '0.6', '0.8', '1.0']
    """
    step = nice_step(high - low, most)
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    if last - first < 2 and most < ENOUGH:
        return linear_ticks(low, high, most + 1)
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    values = [step * k for k in range(first, last + 1)]
    return Ticks(values, [_number(value, digits, step) for value in values], [])


def _number(value: float, digits: int, step: float) -> str:
    largest = max(abs(value), step)
    if step >= 1e7 or (largest < 1e-4 and digits > 4):
        return f"{value:.4g}".replace("-", "−")
    return f"{value:.{digits}f}".replace("-", "−")


def log_ticks(low: float, high: float, most: int = 8) -> Ticks:
    """Return powers of ten from low to high; where they are few, 2 and 5 times them as well.

    Args:
        low: Of the axis, above zero.
        high: Above it.
        most: Named marks.

    >>> log_ticks(0.5, 200.0).names
    ['1', '10', '100']
    """
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    stride = max(1, -(-(last - first + 1) // most))
    powers = list(range(first, last + 1, stride))
    between = [factor * 10.0**power for power in range(first - 1, last + 1) for factor in range(2, 10)]
    minor = [value for value in between if low <= value <= high] if stride == 1 and last - first <= 5 else []
    if len(powers) >= 3 or math.log10(high / low) > 2.0:
        return Ticks([10.0**power for power in powers], [_power(power, powers) for power in powers], minor)
    values = [factor * 10.0**power for power in range(first - 1, last + 1) for factor in (1.0, 2.0, 5.0)]
    values = [value for value in values if low * (1.0 - 1e-9) <= value <= high * (1.0 + 1e-9)]
    if len(values) < 2:
        return linear_ticks(low, high, min(most, 5))
    return Ticks(values, [f"{value:.6g}" for value in values], minor)


def _power(power: int, every: Sequence[int]) -> str:
    if PLAIN[0] <= 10.0 ** every[0] and 10.0 ** every[-1] <= PLAIN[1]:
        return f"{10.0**power:.6g}"
    return f"$10^{{{power}}}$".replace("-", "−")


# ----------------------------------------------------------------------------------------------------------------------
# What a writer puts on paper: paths, discs, words and pictures, in mm from the lower left corner.
# ----------------------------------------------------------------------------------------------------------------------


Frame = tuple[float, float, float, float]
"""Left, low, right, high [mm]."""


@dataclass(frozen=True)
class DrawnPath:
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
    spans: tuple[TextRun, ...]
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


Ink = DrawnPath | Disc | Line | Image


# ----------------------------------------------------------------------------------------------------------------------
# Legends: which marks have a name, how much room the names take, and what stands before each.
# ----------------------------------------------------------------------------------------------------------------------


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
        line: list[Ink] = [DrawnPath((ends,), replace(row.pen, alpha=1.0))] if row.pen.dash else []
        return line + ([marker_ink(row, x + SWATCH / 2.0, y, None)] if row.marker else [])
    if isinstance(row, m.Dots):
        radius = min(2.0, math.sqrt(float(row.area[0]) / math.pi) * POINT)
        return [Disc(x + SWATCH / 2.0, y, radius, row.faces[0], row.edge, row.edge_width, row.alpha)]
    fill = row.fill if isinstance(row, m.Box | m.Shape) else row.colour if isinstance(row, m.Fill) else INK
    alpha = row.alpha if isinstance(row, m.Box | m.Fill | m.Shape) else 1.0
    corners = np.array([(x, y - 0.9), (x + SWATCH, y - 0.9), (x + SWATCH, y + 0.9), (x, y + 0.9)])
    return [DrawnPath((corners,), None, fill, alpha, closed=True)]


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
        return DrawnPath((np.array([(x - radius, y), (x + radius, y)]),), m.Pen(curve.face, 1.4, "-", curve.pen.alpha))
    if curve.marker in _CORNERS:
        corners = np.array(_CORNERS[curve.marker]) * radius * 0.9 + (x, y)
        pen = m.Pen(curve.edge, curve.edge_width) if curve.edge else None
        return DrawnPath((corners,), pen, curve.face, curve.pen.alpha, closed=True, clip=clip)
    radius *= 0.5 if curve.marker == "." else 1.0
    return Disc(x, y, radius, curve.face, curve.edge, curve.edge_width, curve.pen.alpha, clip)


# ----------------------------------------------------------------------------------------------------------------------
# Where panels stand on paper: as large as numbers, names, titles and legends around them leave room for.
# ----------------------------------------------------------------------------------------------------------------------


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
    boxes = [words_box(words, axes, frame) for words in axes.of(TextMark) if np.isfinite([words.x, words.y]).all()]
    if not boxes:
        return 0.0, 0.0, 0.0, 0.0
    ends = np.array(boxes)
    reach = (frame[0] - ends[:, 0].min(), frame[1] - ends[:, 1].min(), ends[:, 2].max() - frame[2],
             ends[:, 3].max() - frame[3])  # fmt: skip
    return tuple(max(0.0, float(value)) for value in reach)  # type: ignore[return-value]


def words_at(words: TextMark, axes: Axes, frame: Frame) -> tuple[float, float]:
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


def words_box(words: TextMark, axes: Axes, frame: Frame) -> Frame:
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
