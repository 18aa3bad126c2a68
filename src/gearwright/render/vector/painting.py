"""From a figure to ink: marks through their scales, axes with their numbers, titles, legends."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gearwright.render.vector import marks as m
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.render.vector.ink import Disc, Frame, Image, Ink, Line, Path
from gearwright.render.vector.keys import key_ink, key_rows, key_size, marker_ink
from gearwright.render.vector.layout import (
    TICK,
    laid_out,
    line_height,
    outside,
    overhang,
    scales_of,
    ticks_of,
    words_at,
)  # fmt: skip
from gearwright.render.vector.palette import HAIR, INK, MUTED
from gearwright.render.vector.scales import Scale
from gearwright.render.vector.thinning import extremes, thinned
from gearwright.render.vector.words import POINT, spans, text_width

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
        if isinstance(mark, m.Words):
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
            yield Path(tuple(piece for piece in thinned(points) if len(piece) > 1), mark.pen, clip=clip)
        if mark.marker:
            for place in points[np.all(np.isfinite(points), axis=1)].tolist():
                yield marker_ink(mark, place[0], place[1], clip)
    elif isinstance(mark, m.Fill):
        across = x.places(mark.x)
        edges = [_near(np.stack([across, y.places(end)], axis=1), frame) for end in (mark.low, mark.high)]
        lower, upper = (extremes(edge[np.all(np.isfinite(edge), axis=1)]) for edge in edges)
        yield Path((np.concatenate([lower, upper[::-1]]),), None, mark.colour, mark.alpha, closed=True, clip=clip)
    elif isinstance(mark, m.Box):
        box = mark.box
        corners = _corners(x.place(box[0]), x.place(box[2]), y.place(box[1]), y.place(box[3]))
        pen = m.Pen(mark.edge, mark.edge_width) if mark.edge and mark.edge_width else None
        if mark.width and mark.height and np.isfinite(corners).all():
            yield Path(
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
                yield Path((corners[[0, 2]],), mark.pen)
            else:
                yield Path((corners,), None, mark.pen.colour, mark.pen.alpha, closed=True)
    elif isinstance(mark, m.Shape):
        points = np.stack([x.places(mark.points[:, 0]), y.places(mark.points[:, 1])], axis=1)
        pen = m.Pen(mark.edge, mark.edge_width) if mark.edge and mark.edge_width else None
        yield Path((points,), pen, mark.fill, mark.alpha, closed=True, cubic=mark.cubic, clip=clip)
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


def _words(words: m.Words, axes: Axes, frame: Frame) -> Iterator[Ink]:
    x, y = words_at(words, axes, frame)
    if words.leader is not None:
        scales = scales_of(axes, frame)
        start = (scales[0].place(words.leader[0]), scales[1].place(words.leader[1]))
        yield Path((np.array([start, (x, y)]),), m.Pen(words.leader_colour, 0.4))
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
        yield Path(tuple(lines), m.Pen(HAIR, 0.5))


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
        yield Path(tuple(spines), _THIN)


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
