"""From a figure to ink and to SVG with real text: marks through their scales, curves as a pixel shows them."""

import base64
import math
import re
import struct
import zlib
from collections.abc import Iterator, Sequence
from html import escape
from itertools import groupby
from operator import itemgetter

import numpy as np

from gearwright.base import Floats
from gearwright.render.vector import figure as m
from gearwright.render.vector.figure import (
    DARK,
    HAIR,
    INK,
    MUTED,
    NAMES,
    PAPER,
    Axes,
    Figure,
    Pen,
    circle,
    css_value,
    tinted,
)
from gearwright.render.vector.layout import (
    POINT,
    SMALL,
    TICK,
    Disc,
    DrawnPath,
    Frame,
    Image,
    Ink,
    Line,
    Scale,
    key_ink,
    key_rows,
    key_size,
    laid_out,
    line_height,
    marker_ink,
    outside,
    overhang,
    scales_of,
    spans,
    text_width,
    ticks_of,
    words_at,
)

# ----------------------------------------------------------------------------------------------------------------------
# Curves as a pixel shows them: extremes of every column, and of paths that turn back every stretch once.
# ----------------------------------------------------------------------------------------------------------------------


COLUMN = 0.26
"""Width of a column on paper [mm]: a pixel of a page, of which 96 make an inch."""
GRAIN = 0.3
"""Distance of points on paper that look like one [mm]."""
PASSES, FEWEST, HAIR_STEPS = 12, 4, 1.5
"""Looks for points on a line, points of a path that is left as it is, and steps beside the line that look straight."""
BANDS = 400
"""Stretches of a band."""
FEW = 400
"""Points of a curve that is left as it is."""


def thinned(points: Floats) -> list[Floats]:
    """Return a curve on paper as pieces that look the same.

    Args:
        points: Shape (points, 2) [mm]; not a number parts the curve.
    """
    good = np.all(np.isfinite(points), axis=1)
    if not good.all():
        edges = np.flatnonzero(np.diff(good.astype(int))) + 1
        pieces = [piece for piece, fine in zip(np.split(points, edges), np.split(good, edges), strict=True) if fine[0]]
        return [part for piece in pieces for part in thinned(piece)]
    if len(points) <= FEW:
        return [points] if len(points) else []
    if np.all(np.diff(points[:, 0]) >= 0.0):
        return [extremes(points)]
    return distinct(points)


def extremes(points: Floats) -> Floats:
    """Return the lowest and highest point of every column of a curve that runs to the right.

    Args:
        points: Shape (points, 2) [mm].
    """
    column = np.floor((points[:, 0] - points[0, 0]) / COLUMN)
    starts = np.flatnonzero(np.diff(column, prepend=-1.0))
    if 2 * len(starts) >= len(points):
        return points
    ends = np.append(starts[1:], len(points))
    kept = {0, len(points) - 1}
    for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
        y = points[start:end, 1]
        kept.update((start + int(np.argmin(y)), start + int(np.argmax(y))))
    return points[sorted(kept)]


def band(x: Floats, rows: Floats) -> tuple[Floats, Floats, Floats]:
    """Return places, and the least and greatest of all rows between two of them.

    Args:
        x: Rising, shape (points,).
        rows: Shape (points, rows).
    """
    starts = np.unique(np.linspace(0, len(x), BANDS + 1, dtype=int)[:-1])
    low, high = np.fmin.reduceat(rows, starts).min(axis=1), np.fmax.reduceat(rows, starts).max(axis=1)
    return np.append(x[starts], x[-1]), np.append(low, low[-1]), np.append(high, high[-1])


def distinct(points: Floats) -> list[Floats]:
    """Return the stretches of a path that do not lie on others, on a fine grid.

    Args:
        points: Shape (points, 2) [mm].
    """
    grid = np.round(points / GRAIN).astype(np.int64)
    moved = np.any(np.diff(grid, axis=0, prepend=grid[:1] - 1) != 0, axis=1)
    kept, grid = points[moved], grid[moved]
    key = (grid[:, 0] << 32) + grid[:, 1]
    pairs = np.sort(np.stack([key[:-1], key[1:]], axis=1), axis=1)
    _, first = np.unique(pairs, axis=0, return_index=True)
    new = np.zeros(len(pairs), dtype=bool)
    new[first] = True
    pieces = []
    edges = np.flatnonzero(np.diff(new.astype(int))) + 1
    for part in np.split(np.arange(len(new)), edges):
        if len(part) and new[part[0]]:
            pieces.append(kept[part[0] : part[-1] + 2])
    return pieces


def straightened(grid: Floats) -> Floats:
    """Return a path without the points that stand on the line between their neighbours, or a hair beside it.

    Args:
        grid: Shape (points, 2), whole steps.
    """
    if len(grid) < FEWEST:
        return grid
    grid = grid[np.concatenate([[True], np.any(np.diff(grid, axis=0) != 0.0, axis=1)])]
    for turn in range(PASSES):
        if len(grid) < FEWEST:
            break
        before, at, after = grid[:-2], grid[1:-1], grid[2:]
        along, off = after - before, at - before
        length = np.hypot(along[:, 0], along[:, 1])
        ahead = np.sum(along * off, axis=1)
        beside = np.abs(along[:, 0] * off[:, 1] - along[:, 1] * off[:, 0])
        on_it = (beside <= HAIR_STEPS * length) & (ahead > 0.0) & (ahead < length**2)
        on_it[turn % 2 :: 2] = False
        if not on_it.any() and turn % 2:
            break
        grid = grid[np.concatenate([[True], ~on_it, [True]])]
    return grid


# ----------------------------------------------------------------------------------------------------------------------
# From a figure to ink: marks through their scales, axes with their numbers, titles, legends.
# ----------------------------------------------------------------------------------------------------------------------


_THIN = m.Pen(MUTED, 0.6)


def painted(figure: Figure) -> list[Ink]:
    """Return all that a figure puts on paper, the lowest first.

    Args:
        figure: As drawn.
    """
    ink: list[Ink] = []
    for slot, frame in zip(figure.slots, laid_out(figure), strict=True):
        ink += _panel(slot.axes, frame)
    y = 1.5
    if figure.caption:
        ink.append(Line(figure.width / 2.0, y + 0.8, spans(figure.caption, math=False), 6.5, INK, "middle"))
        y += line_height(6.5) + 1.0
    if figure.shared_key:
        rows = key_rows(figure.axes[0])
        width, height = key_size(rows, figure.shared_key, 7.5)
        ink += key_ink(rows, figure.shared_key, 7.5, at=((figure.width - width) / 2.0, y + height))
    return ink


def _panel(axes: Axes, frame: Frame) -> Iterator[Ink]:
    scales = scales_of(axes, frame)
    if not axes.off:
        yield from _grid(axes, frame, scales)
    twin = axes.twin
    layers = [(mark, scales) for mark in axes.marks]
    if twin is not None:
        layers += [(mark, (scales[0], scales_of(twin, frame)[1])) for mark in twin.marks]
    for mark, pair in sorted(layers, key=lambda entry: entry[0].layer):
        if isinstance(mark, m.TextMark):
            if math.isfinite(mark.x) and math.isfinite(mark.y):
                yield from _words(mark, axes, frame)
        else:
            yield from _mark(mark, pair, frame, clipped=not axes.off)
    if not axes.off:
        yield from _axes(axes, frame, scales)
    if axes.title:
        yield from _title(axes, frame)
    if axes.key is not None:
        yield from _key(axes, frame, scales)


# Marks --------------------------------------------------------------------------------------------------------------


def _mark(mark: m.Mark, scales: tuple[Scale, Scale], frame: Frame, *, clipped: bool) -> Iterator[Ink]:
    clip = frame if clipped else None
    x, y = scales
    if isinstance(mark, m.Curve):
        points = np.stack([x.places(mark.x), y.places(mark.y)], axis=1) if len(mark.x) else np.zeros((0, 2))
        points = _near(points, frame)
        if mark.pen.dash and len(points):
            yield DrawnPath(tuple(piece for piece in thinned(points) if len(piece) > 1), mark.pen, clip=clip)
        if mark.marker:
            for place in points[np.all(np.isfinite(points), axis=1)].tolist():
                yield marker_ink(mark, place[0], place[1], clip)
    elif isinstance(mark, m.Fill):
        across = x.places(mark.x)
        edges = [_near(np.stack([across, y.places(end)], axis=1), frame) for end in (mark.low, mark.high)]
        lower, upper = (extremes(edge[np.all(np.isfinite(edge), axis=1)]) for edge in edges)
        yield DrawnPath((np.concatenate([lower, upper[::-1]]),), None, mark.colour, mark.alpha, closed=True, clip=clip)
    elif isinstance(mark, m.Box):
        box = mark.box
        corners = _corners(x.place(box[0]), x.place(box[2]), y.place(box[1]), y.place(box[3]))
        pen = m.Pen(mark.edge, mark.edge_width) if mark.edge and mark.edge_width else None
        if mark.width and mark.height and np.isfinite(corners).all():
            yield DrawnPath(
                (_near(corners, frame),), pen, mark.fill, mark.alpha, closed=True, hatched=mark.hatched, clip=clip
            )
    elif isinstance(mark, m.Dots):
        places = zip(x.places(mark.x).tolist(), y.places(mark.y).tolist(), mark.area.tolist(), mark.faces, strict=False)
        for across, up, area, face in places:
            if math.isfinite(across) and math.isfinite(up):
                radius = math.sqrt(area / math.pi) * POINT
                yield Disc(across, up, radius, face, mark.edge, mark.edge_width, mark.alpha, clip)
    elif isinstance(mark, m.Rule):
        scale, k = (x, 0) if mark.axis == "x" else (y, 1)
        low, high = (
            min(max(place, frame[k]), frame[k + 2]) for place in (scale.place(mark.low), scale.place(mark.high))
        )
        outside = mark.low == mark.high and low != scale.place(mark.low)
        if not outside:
            corners = _corners(low, high, frame[1], frame[3]) if k == 0 else _corners(frame[0], frame[2], low, high)
            if mark.low == mark.high:
                yield DrawnPath((corners[[0, 2]],), mark.pen)
            else:
                yield DrawnPath((corners,), None, mark.pen.colour, mark.pen.alpha, closed=True)
    elif isinstance(mark, m.Shape):
        points = np.stack([x.places(mark.points[:, 0]), y.places(mark.points[:, 1])], axis=1)
        pen = m.Pen(mark.edge, mark.edge_width) if mark.edge and mark.edge_width else None
        yield DrawnPath((points,), pen, mark.fill, mark.alpha, closed=True, cubic=mark.cubic, clip=clip)
    elif isinstance(mark, m.Picture):
        yield Image((x.place(mark.left), y.place(mark.low), x.place(mark.right), y.place(mark.high)), mark.pixels)


def _near(points: np.ndarray, frame: Frame) -> np.ndarray:
    """Return points that are not farther from the frame than three times its size."""
    width, height = frame[2] - frame[0], frame[3] - frame[1]
    low = np.array([frame[0] - 3.0 * width, frame[1] - 3.0 * height])
    high = np.array([frame[2] + 3.0 * width, frame[3] + 3.0 * height])
    near: np.ndarray = np.clip(points, low, high)
    return near


def _corners(left: float, right: float, low: float, high: float) -> np.ndarray:
    return np.array([(left, low), (right, low), (right, high), (left, high)])


def _words(words: m.TextMark, axes: Axes, frame: Frame) -> Iterator[Ink]:
    x, y = words_at(words, axes, frame)
    if words.leader is not None:
        scales = scales_of(axes, frame)
        start = (scales[0].place(words.leader[0]), scales[1].place(words.leader[1]))
        yield DrawnPath((np.array([start, (x, y)]),), m.Pen(words.leader_colour, 0.4))
    lines = words.text.split("\n")
    high = line_height(words.size)
    top = {"top": -0.78, "bottom": len(lines) - 0.78, "center": 0.5 * len(lines) - 0.78, "baseline": 0.0}[
        words.up
    ] * high
    anchor = {"left": "start", "center": "middle", "right": "end"}[words.across]
    angle = math.radians(words.turned)
    for k, line in enumerate(lines):
        # Down by the same way along the turned text's own upright direction.
        away = top - k * high
        at = (x - away * math.sin(angle), y + away * math.cos(angle))
        yield Line(*at, spans(line, math=words.math), words.size, words.colour, anchor, words.turned, words.bold)


# Axes ---------------------------------------------------------------------------------------------------------------


def _grid(axes: Axes, frame: Frame, scales: tuple[Scale, Scale]) -> Iterator[Ink]:
    lines = []
    if axes.x.grid:
        for value in ticks_of(axes.x, frame[2] - frame[0], "x").values:
            at = scales[0].place(value)
            lines.append(np.array([(at, frame[1]), (at, frame[3])]))
    if axes.y.grid:
        for value in ticks_of(axes.y, frame[3] - frame[1], "y").values:
            at = scales[1].place(value)
            lines.append(np.array([(frame[0], at), (frame[2], at)]))
    if lines:
        yield DrawnPath(tuple(lines), m.Pen(HAIR, 0.5))


def _axes(axes: Axes, frame: Frame, scales: tuple[Scale, Scale]) -> Iterator[Ink]:
    spines = []
    if axes.bottom_spine:
        spines.append(np.array([(frame[0], frame[1]), (frame[2], frame[1])]))
    if axes.left_spine:
        spines.append(np.array([(frame[0], frame[1]), (frame[0], frame[3])]))
    low = frame[1] - 2.0 * TICK
    ticks = ticks_of(axes.x, frame[2] - frame[0], "x")
    for value, name in zip(ticks.values, ticks.names, strict=True):
        at = scales[0].place(value)
        if axes.x.ticks:
            spines.append(np.array([(at, frame[1]), (at, frame[1] - TICK)]))
        for k, line in enumerate(name.split("\n") if axes.x.numbers else ()):
            y = low - (k + 0.72) * line_height(axes.x.size)
            yield Line(at, y, spans(line, math=axes.x.names is None), axes.x.size, INK, "middle")
    if axes.x.label:
        rows = max((len(name.split("\n")) for name in axes.x.names or [""]), default=1) if axes.x.numbers else 0
        y = (low - rows * line_height(axes.x.size) if rows else frame[1]) - 0.3
        for k, line in enumerate(axes.x.label.split("\n")):
            yield Line((frame[0] + frame[2]) / 2.0, y - (k + 0.72) * line_height(8.0), spans(line, math=False), 8.0,
                       axes.x.label_colour, "middle")  # fmt: skip
    yield from _upright(axes, frame, scales[1], spines, side=-1.0)
    if axes.twin is not None:
        spines.append(np.array([(frame[2], frame[1]), (frame[2], frame[3])]))
        yield from _upright(axes.twin, frame, scales_of(axes.twin, frame)[1], spines, side=1.0)
    if spines:
        yield DrawnPath(tuple(spines), _THIN)


def _upright(axes: Axes, frame: Frame, scale: Scale, spines: list[np.ndarray], *, side: float) -> Iterator[Ink]:
    edge = frame[0] if side < 0.0 else frame[2]
    ticks = ticks_of(axes.y, frame[3] - frame[1], "y")
    widest = 0.0
    high = line_height(axes.y.size)
    for value, name in zip(ticks.values, ticks.names, strict=True):
        at = scale.place(value)
        if axes.y.ticks:
            spines.append(np.array([(edge, at), (edge + side * TICK, at)]))
        lines = name.split("\n") if axes.y.numbers else []
        for k, line in enumerate(lines):
            widest = max(widest, text_width(line, axes.y.size, math=axes.y.names is None, bold=False))
            y = at + (0.5 * len(lines) - k - 0.78) * high
            yield Line(
                edge + side * 2.0 * TICK,
                y,
                spans(line, math=axes.y.names is None),
                axes.y.size,
                INK,
                "end" if side < 0.0 else "start",
            )
    lines = axes.y.label.split("\n") if axes.y.label else []
    room = widest + 2.0 * TICK if ticks.names and axes.y.numbers else 0.0
    for k, line in enumerate(lines):
        rows = len(lines) - 1 - k if side < 0.0 else k
        x = edge + side * (room + 0.5 + rows * line_height(8.0)) + (0.0 if side < 0.0 else 0.72 * line_height(8.0))
        x -= 0.25 * line_height(8.0) if side < 0.0 else 0.0
        yield Line(x, (frame[1] + frame[3]) / 2.0, spans(line, math=False), 8.0, axes.y.label_colour, "middle", 90.0)


def _title(axes: Axes, frame: Frame) -> Iterator[Ink]:
    lines = axes.title.split("\n")
    high = line_height(axes.title_size)
    top = frame[3] + overhang(axes, frame)[3]
    for k, line in enumerate(lines):
        y = top - (k + 0.75) * high
        yield Line(frame[0], y, spans(line, math=False), axes.title_size, INK, "start", bold=axes.title_bold)


def _key(axes: Axes, frame: Frame, scales: tuple[Scale, Scale]) -> Iterator[Ink]:
    key = axes.key
    assert key is not None
    rows = key_rows(axes)
    width, height = key_size(rows, key.columns, key.size, key.title)
    if key.where == "right":
        at = (frame[2] + 3.0 + outside(axes, frame), (frame[1] + frame[3] + height) / 2.0)
    elif key.where == "below":
        at = (frame[0], frame[1] - overhang(axes, frame)[1] + height)
    elif key.where == "above":
        title = len(axes.title.split("\n")) * line_height(axes.title_size) + 1.0 if axes.title else 0.0
        at = (frame[0], frame[3] + overhang(axes, frame)[3] - title)
    else:
        at = _corner(axes, frame, scales, key.where, (width, height))
    yield from key_ink(rows, key.columns, key.size, at=at, title=key.title)


def _corner(
    axes: Axes, frame: Frame, scales: tuple[Scale, Scale], where: str, size: tuple[float, float]
) -> tuple[float, float]:
    """Return the upper left corner of a legend inside; of the four corners the one that hides least."""
    spots = {
        f"{up} {side}": (frame[0] + 1.5 if side == "left" else frame[2] - size[0] - 1.5,
                         frame[3] - 1.0 if up == "upper" else frame[1] + size[1] + 1.5)
        for up in ("upper", "lower") for side in ("right", "left")
    }  # fmt: skip
    if where != "best":
        return spots[where]
    points = [np.stack([scales[0].places(c.x), scales[1].places(c.y)], axis=1) for c in axes.of(m.Curve) if len(c.x)]
    points += [np.stack([scales[0].places(f.x), scales[1].places(e)], axis=1) for f in axes.of(m.Fill)
               for e in (f.low, f.high)]  # fmt: skip
    boxes = [box.box for box in axes.of(m.Box)]
    points += [np.array([(scales[0].place(x), scales[1].place(y)) for x in (b[0], b[2]) for y in (b[1], b[3])])
               for b in boxes]  # fmt: skip
    every = np.concatenate(points) if points else np.zeros((0, 2))

    def hidden(at: tuple[float, float]) -> int:
        inside = (every[:, 0] > at[0]) & (every[:, 0] < at[0] + size[0]) & (every[:, 1] < at[1])
        return int(np.sum(inside & (every[:, 1] > at[1] - size[1])))

    return min(spots.values(), key=hidden)


# ----------------------------------------------------------------------------------------------------------------------
# A figure as SVG: real text, colours that a page may change by CSS variables, whole numbers for coordinates.
# ----------------------------------------------------------------------------------------------------------------------


ROUND = 13
"""Points of an ellipse of four cubic curves."""
UNITS = 20.0
"""Steps of the drawing's own grid in one mm."""
FONT = "DejaVu Sans,Verdana,sans-serif"
OPEN = 'fill="none"'
LOOK = "\0"
"""Where an element's look stands until it is known whether its neighbours share it."""
_DASHES = {"--": "5 2.5", ":": "1 1.8"}


def svg_text(figure: Figure, prefix: str = "", *, styled: bool = True) -> str:
    """Return a figure as an SVG element that stands alone or inside a page.

    Args:
        figure: As drawn.
        prefix: Goes before every id and names the figure's own ids, so that several figures can share a page.
        styled: With its own style; else the page has that of `style_of`.
    """
    writer = _Writer(figure, f"{prefix}-" if prefix else "", styled=styled)
    return writer.text(painted(figure))


def style_of(page: str) -> str:
    """Return the rules of all classes that figures without their own style use on a page, and its colours.

    Args:
        page: HTML.
    """
    light = "".join(f"--gw-{name}:{colour};" for colour, name in NAMES.items())
    dark = "".join(f"--gw-{name}:{colour};" for name, colour in DARK.items())
    used = sorted(set(re.findall(r"gw-[fs]-[a-z0-9-]+", page)))
    colours = {
        known[0]: re.sub(r",#\w+\)", ")", known[1]) for known in map(css_value, (*NAMES, *map(tinted, NAMES))) if known
    }
    kinds = {"f": "fill", "s": "stroke"}
    rules = "".join(f".{name}{{{kinds[name[3]]}:{colours[name[5:]]}}}" for name in used)
    return f":root{{{light}}}@media screen and (prefers-color-scheme:dark){{:root{{{dark}}}}}{rules}"


class _Writer:
    """Collects elements, and which colours and clips they need."""

    def __init__(self, figure: Figure, prefix: str, *, styled: bool) -> None:
        self.figure, self.prefix, self.styled = figure, prefix, styled
        self.rules: dict[str, str] = {}
        self.clips: dict[Frame, str] = {}
        self.hatched = False

    def text(self, ink: Sequence[Ink]) -> str:
        wide, high = self._length(self.figure.width), self._length(self.figure.height)
        body = [self._rectangle(0, 0, wide, high, self._look("fill", PAPER)), *self._body(ink)]
        titles = [axes.title for axes in self.figure.axes if axes.title]
        title = self.figure.title or "; ".join(dict.fromkeys(titles)) or "Figure"
        told = ". ".join(dict.fromkeys(self.figure.texts()))
        lines = [
            f'<svg class="gw-figure" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" role="img"'
            f' width="{self.figure.width:.5g}mm" height="{self.figure.height:.5g}mm" font-family="{FONT}"'
            f' aria-labelledby="{self.prefix}title {self.prefix}desc">',
            f'<title id="{self.prefix}title">{escape(title.replace(chr(10), " "))}</title>',
            f'<desc id="{self.prefix}desc">{escape(told.replace(chr(10), " ")[:1500])}</desc>',
            *([f"<style>{self._style()}</style>"] if self.styled else []),
            *self._definitions(),
            *body,
            "</svg>",
        ]
        return "\n".join(lines) + "\n"

    def _style(self) -> str:
        rules = "".join(f".{name}{{{rule}}}" for name, rule in sorted(self.rules.items()))
        dark = "".join(f"--gw-{name}:{colour};" for name, colour in DARK.items())
        # A page sets the variables itself; only a file that stands alone follows the reader's own choice.
        return f"{rules}@media screen and (prefers-color-scheme:dark){{svg.gw-figure:root{{{dark}}}}}"

    def _definitions(self) -> list[str]:
        parts = []
        if self.hatched:
            look = self._look("stroke", MUTED)
            size = 'width="22" height="22" patternUnits="userSpaceOnUse"'
            parts.append(f'<pattern id="{self.prefix}hatch" {size}>'
                         f'<path d="M-5 5l10-10M0 22l22-22M17 27l10-10" stroke-width="4" {look}/>'
                         "</pattern>")  # fmt: skip
        for frame, name in self.clips.items():
            left, low, right, high = frame
            box = (self._x(left), self._y(high), self._x(right) - self._x(left), self._y(low) - self._y(high))
            parts.append(f'<clipPath id="{name}">{self._rectangle(*box, "")}</clipPath>')
        return ["<defs>", *parts, "</defs>"] if parts else []

    def _body(self, ink: Sequence[Ink]) -> list[str]:
        """Return elements, those that share a clip in one group."""
        lines: list[str] = []
        for clip, drops in groupby(ink, key=lambda drop: getattr(drop, "clip", None)):
            lines += [f'<g clip-path="url(#{self._clip(clip)})">'] if clip is not None else []
            for look, elements in groupby(map(self._element, drops), key=itemgetter(1)):
                lines += _together([element for element, _ in elements], look)
            lines += ["</g>"] if clip is not None else []
        return lines

    def _clip(self, frame: Frame) -> str:
        return self.clips.setdefault(frame, f"{self.prefix}clip-{len(self.clips)}")

    def _element(self, drop: Ink) -> tuple[str, str]:
        """Return an element with a place for its look, and the look."""
        if isinstance(drop, DrawnPath):
            return self._path(drop)
        if isinstance(drop, Disc):
            look = self._look("fill", drop.fill) + _opacity(drop.alpha)
            if drop.edge:
                look += " " + self._stroke(Pen(drop.edge, drop.edge_width or 1.0))
            place = f'cx="{self._x(drop.x)}" cy="{self._y(drop.y)}" r="{drop.radius * UNITS:.3g}"'
            return f"<circle {place}{LOOK}/>", _one_class(look)
        if isinstance(drop, Image):
            return self._image(drop), ""
        return self._line(drop)

    def _path(self, path: DrawnPath) -> tuple[str, str]:
        shape = (
            self._round(path) or f'path d="{"".join(self._piece(piece, path) for piece in path.pieces if len(piece))}"'
        )
        look = self._look("fill", path.fill) + _opacity(path.alpha) if path.fill else OPEN
        if path.hatched:
            self.hatched = True
            look = f'fill="url(#{self.prefix}hatch)"'
        pen = " " + self._stroke(path.pen) if path.pen is not None else ""
        return f"<{shape}{LOOK}/>", _one_class(look + pen)

    def _round(self, path: DrawnPath) -> str:
        """Return the element of an ellipse; nothing for other paths."""
        points = path.pieces[0] if path.cubic and len(path.pieces) == 1 else np.zeros((0, 2))
        if len(points) != ROUND:
            return ""
        centre, size = (
            (points[0] + points[6]) / 2.0,
            np.array([points[0, 0] - points[6, 0], points[3, 1] - points[9, 1]]),
        )
        if not np.allclose(points, circle((centre[0], centre[1]), size[0], size[1])):
            return ""
        radii = np.round(np.abs(size) / 2.0 * UNITS).astype(int)
        return f'ellipse cx="{self._x(centre[0])}" cy="{self._y(centre[1])}" rx="{radii[0]}" ry="{radii[1]}"'

    def _piece(self, points: np.ndarray, path: DrawnPath) -> str:
        grid = np.stack([np.round(points[:, 0] * UNITS), np.round((self.figure.height - points[:, 1]) * UNITS)], axis=1)
        grid = grid if path.cubic else straightened(grid)
        steps = np.diff(grid.astype(int), axis=0)
        first = f"M{int(grid[0, 0])} {int(grid[0, 1])}"
        if path.cubic:
            words = " ".join(f"{x} {y}" for x, y in grid[1:].astype(int).tolist())
            return f"{first}C{words}z"
        words = " ".join(f"{x} {y}" for x, y in steps.tolist()).replace(" -", "-")
        return f"{first}l{words or '0 0'}" + ("z" if path.closed else "")

    def _line(self, line: Line) -> tuple[str, str]:
        x, y = self._x(line.x), self._y(line.y)
        size = line.size * POINT * UNITS
        look = f'font-size="{size:.3g}" {self._look("fill", line.colour)}'
        look += f' text-anchor="{line.anchor}"' if line.anchor != "start" else ""
        look += ' font-weight="bold"' if line.bold else ""
        turned = f' transform="rotate({-line.turned:.4g} {x} {y})"' if line.turned else ""
        words = "".join(self._spans(line, size))
        return f'<text x="{x}" y="{y}"{turned}{LOOK}>{words}</text>', look

    def _spans(self, line: Line, size: float) -> list[str]:
        words, level = [], 0.0
        for span in line.spans:
            to = -span.shift * (0.36 if span.shift > 0 else 0.2) * size
            moved = f' dy="{to - level:.3g}"' if to != level else ""
            level = to
            small = f' font-size="{SMALL * size:.3g}"' if span.shift else ""
            slanted = ' font-style="italic"' if span.italic else ""
            text = escape(span.text, quote=False)
            words.append(f"<tspan{moved}{small}{slanted}>{text}</tspan>" if moved or small or slanted else text)
        return words

    def _image(self, image: Image) -> str:
        left, low, right, high = image.frame
        box = (self._x(left), self._y(high), self._x(right) - self._x(left), self._y(low) - self._y(high))
        data = base64.b64encode(png_bytes(image.pixels[::-1])).decode("ascii")
        return (f'<image x="{box[0]}" y="{box[1]}" width="{box[2]}" height="{box[3]}" preserveAspectRatio="none"'
                f' href="data:image/png;base64,{data}"/>')  # fmt: skip

    def _rectangle(self, x: int, y: int, width: int, height: int, look: str) -> str:
        return f'<rect x="{x}" y="{y}" width="{width}" height="{height}" {look}/>'.replace(" />", "/>")

    def _look(self, what: str, colour: str) -> str:
        """Return the attribute of a colour, and the class by which a page may change it."""
        known = css_value(colour)
        if known is None:
            return f'{what}="{colour}"'
        name = f"gw-{what[0]}-{known[0]}"
        self.rules[name] = f"{what}:{known[1]}"
        return f'class="{name}" {what}="{colour}"' if self.styled else f'class="{name}"'

    def _stroke(self, pen: Pen) -> str:
        width = pen.width * POINT * UNITS
        look = f'{self._look("stroke", pen.colour)} stroke-width="{width:.3g}"'
        if pen.dash in _DASHES:
            steps = " ".join(f"{float(part) * width:.3g}" for part in _DASHES[pen.dash].split())
            look += f' stroke-dasharray="{steps}"'
        return look + (f' stroke-opacity="{pen.alpha:.3g}"' if pen.alpha < 1.0 else "")

    def _length(self, size: float) -> int:
        return round(size * UNITS)

    def _x(self, x: float) -> int:
        return round(x * UNITS)

    def _y(self, y: float) -> int:
        return round((self.figure.height - y) * UNITS)


def _together(elements: Sequence[str], look: str) -> list[str]:
    """Return elements of one look, which several of them have from their group."""
    if look.startswith(OPEN) and "opacity" not in look:
        elements = ["".join(elements).replace(f'"{LOOK}/><path d="', "")]
    if len(elements) == 1 or not look:
        return [element.replace(LOOK, f" {look}" if look else "") for element in elements]
    return [f"<g {look}>", *(element.replace(LOOK, "") for element in elements), "</g>"]


def _opacity(alpha: float) -> str:
    return f' fill-opacity="{alpha:.3g}"' if alpha < 1.0 else ""


def _one_class(look: str) -> str:
    """Return attributes with their classes in one."""
    parts = look.split('class="')
    if len(parts) < 3:
        return look
    names = [part.split('"', 1)[0] for part in parts[1:]]
    rest = parts[0] + "".join(part.split('"', 1)[1] for part in parts[1:])
    return f'class="{" ".join(names)}" {" ".join(rest.split())}'


def png_bytes(pixels: np.ndarray) -> bytes:
    """Return cells of colours as a PNG image.

    Args:
        pixels: Shape (rows, columns, 3), bytes, the first row on top.

    Source: ISO/IEC 15948 (PNG), chunks IHDR, IDAT and IEND; every row with filter 0.
    """
    rows, columns = pixels.shape[:2]
    raw = b"".join(b"\0" + row.tobytes() for row in np.ascontiguousarray(pixels, dtype=np.uint8))
    head = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    parts = [(b"IHDR", head), (b"IDAT", zlib.compress(raw, 9)), (b"IEND", b"")]
    chunks = [
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in parts
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)
