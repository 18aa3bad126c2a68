"""A panel: marks in the units of its data, two axes, title and legend, until it is laid out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gearwright.render.vector import marks as m
from gearwright.render.vector.axis import Axis
from gearwright.render.vector.palette import CYCLE, INK


@dataclass(frozen=True)
class Legend:
    """Where the names of marks stand."""

    where: str
    """``right``, ``below``, ``above``, or a corner inside, such as ``upper right``; ``best``: the emptiest corner."""
    columns: int = 1
    size: float = 7.5
    title: str = ""
    at: tuple[float, float] | None = None


class Axes:
    """A panel of a figure; places and sizes are in the units of its data, widths of lines and letters in points."""

    def __init__(self) -> None:
        self.x, self.y = Axis(), Axis()
        self.marks: list[m.Mark] = []
        self.title, self.title_size, self.title_bold = "", 9.0, True
        self.key: Legend | None = None
        self.off = False
        self.left_spine = self.bottom_spine = True
        self.aspect = ""
        self.twin: Axes | None = None
        self.is_twin = False
        self._turn = 0

    # What tests and labels ask -------------------------------------------------------------------------------------

    def of(self, kind: type[Any]) -> list[Any]:
        """Return the marks of one kind, in the order in which they were drawn."""
        return [mark for mark in self.marks if isinstance(mark, kind)]

    def texts(self) -> list[str]:
        """Return all that is written on the panel and beside it."""
        named = [name for axis in (self.x, self.y) for name in (axis.label, *(axis.names or ()))]
        keys = [mark.label for mark in self.marks if mark.label]
        return [word for word in (self.title, *named, *keys, *(mark.text for mark in self.of(m.Words))) if word]

    # Marks ----------------------------------------------------------------------------------------------------------

    def _add(self, mark: m.Mark, x: Any = (), y: Any = ()) -> None:
        self.marks.append(mark)
        self.x.reach(np.asarray(x, dtype=float))
        self.y.reach(np.asarray(y, dtype=float))

    def colour(self) -> str:
        """Return the next colour of the cycle."""
        self._turn += 1
        return CYCLE[(self._turn - 1) % len(CYCLE)]

    def plot(  # noqa: PLR0913
        self, x: Any, y: Any, style: str = "", *, color: str = "", lw: float = 1.1, ls: str = "-", alpha: float = 1.0,
        label: str = "", marker: str = "", ms: float = 6.0, mfc: str = "", mec: str = "", mew: float = 0.0,
        zorder: float = 2.0, names: Sequence[str] = (),
    ) -> None:  # fmt: skip
        """Draw curves through points, a curve for every column of y; names are what a pointer is told of each."""
        across, values = np.atleast_1d(np.asarray(x, dtype=float)), np.atleast_1d(np.asarray(y, dtype=float))
        columns = values.T if values.ndim == 2 else [values]
        dash = next((sign for sign in ("--", ":", "-") if sign in style), "" if style else ls)
        mark = marker or style.replace("-", "").replace(":", "")
        for k, column in enumerate(columns):
            tone = color or self.colour()
            pen = m.Pen(tone, lw, dash, alpha)
            curve = m.Curve(across, column, pen, mark, ms, mfc or tone, mec, mew or (1.0 if mec else 0.0), layer=zorder,
                            label=label if k == 0 else "", name=names[k] if names else "")  # fmt: skip
            self._add(curve, across, column)

    def barh(
        self, places: Any, widths: Any, height: float = 0.8, *, left: Any = 0.0, color: Any = "", label: str = "",
        edgecolor: str = "", linewidth: float = 0.0,
    ) -> None:  # fmt: skip
        """Draw level bars; places may be names, from the first row on."""
        rows = [places] if np.ndim(places) == 0 else list(places)
        if rows and isinstance(rows[0], str):
            self.set_yticks(range(len(rows)), rows)
            rows = list(range(len(rows)))
        lengths, starts = np.broadcast_to(widths, len(rows)), np.broadcast_to(left, len(rows))
        tones = [color or self.colour()] * len(rows) if isinstance(color, str) else list(color)
        for k, (row, length, start, tone) in enumerate(zip(rows, lengths, starts, tones, strict=True)):
            box = m.Box(float(start), row - height / 2.0, float(length), height, tone, edgecolor, linewidth, bar="x",
                        label=label if k == 0 else "", layer=1.0)  # fmt: skip
            self._add(box, (start, start + length), (row - height / 2.0, row + height / 2.0))
        self.x.zero = True

    def hist(self, values: Any, bins: Any = 10, *, color: str = "", alpha: float = 1.0, label: str = "") -> None:
        """Draw how often values fall into bins."""
        count, edges = np.histogram(np.asarray(values, dtype=float), bins)
        tone = color or self.colour()
        for k, number in enumerate(count.tolist()):
            box = m.Box(float(edges[k]), 0.0, float(edges[k + 1] - edges[k]), number, tone, alpha=alpha, bar="y",
                        label=label if k == 0 else "", layer=1.0)  # fmt: skip
            self._add(box, edges[k : k + 2], (0.0, number))
        self.y.zero = True

    def fill_between(
        self, x: Any, low: Any, high: Any = 0.0, *, color: str = "", alpha: float = 1.0, label: str = "",
        zorder: float = 1.0, lw: float = 0.0,
    ) -> None:  # fmt: skip
        """Fill what lies between two curves."""
        across = np.asarray(x, dtype=float)
        ends = [np.broadcast_to(np.asarray(end, dtype=float), across.shape) for end in (low, high)]
        tone = color or self.colour()
        self._add(m.Fill(across, ends[0], ends[1], tone, alpha, label=label, layer=zorder), across, ends)
        if lw:
            for end in ends:
                self.plot(across, end, color=tone, lw=lw)

    def step(self, x: Any, y: Any, *, where: str = "post", color: str = "", label: str = "", lw: float = 1.1) -> None:
        """Draw stairs; ``post``: a value holds until the next place, ``pre``: since the last one."""
        across, values = np.repeat(np.asarray(x, dtype=float), 2), np.repeat(np.asarray(y, dtype=float), 2)
        pair = (across[1:], values[:-1]) if where == "post" else (across[:-1], values[1:])
        self.plot(*pair, color=color, label=label, lw=lw)

    def scatter(  # noqa: PLR0913
        self, x: Any, y: Any, s: Any = 20.0, *, color: str = "", c: Sequence[str] | None = None, label: str = "",
        edgecolors: str = "", lw: float = 0.0, alpha: float = 1.0, zorder: float = 2.0,
    ) -> None:  # fmt: skip
        """Draw discs of an area [pt²]."""
        across, up = np.atleast_1d(np.asarray(x, dtype=float)), np.atleast_1d(np.asarray(y, dtype=float))
        faces = tuple(c) if c is not None else (color or self.colour(),) * max(len(across), 1)
        area = np.broadcast_to(np.asarray(s, dtype=float), max(len(across), 1))
        self._add(m.Dots(across, up, area, faces, edgecolors, lw, alpha, label=label, layer=zorder), across, up)

    def rule(self, axis: str, low: float, high: float, pen: m.Pen, layer: float) -> None:
        """Draw a line or a band across the panel."""
        mark = m.Rule(axis, low, high, pen, layer=layer)
        self._add(mark, *(((low, high), ()) if axis == "x" else ((), (low, high))))

    def axvline(
        self, x: float, *, color: str = INK, lw: float = 1.1, ls: str = "-", zorder: float = 2.0, alpha: float = 1.0
    ) -> None:
        """Draw an upright line across the panel."""
        self.rule("x", x, x, m.Pen(color, lw, ls, alpha), zorder)

    def axhline(
        self, y: float, *, color: str = INK, lw: float = 1.1, ls: str = "-", zorder: float = 2.0, alpha: float = 1.0
    ) -> None:
        """Draw a level line across the panel."""
        self.rule("y", y, y, m.Pen(color, lw, ls, alpha), zorder)

    def axvspan(
        self, low: float, high: float, *, color: str, alpha: float = 1.0, lw: float = 0.0, zorder: float = 0.0
    ) -> None:
        """Fill an upright band across the panel."""
        self.rule("x", low, high, m.Pen(color, lw, "", alpha), zorder)

    def hlines(self, y: Any, start: Any, end: Any, *, color: str = INK, lw: float = 1.1) -> None:
        """Draw level lines, one for every place."""
        places = np.asarray(y, dtype=float)
        starts, ends = np.broadcast_to(start, places.shape), np.broadcast_to(end, places.shape)
        gap = np.full(places.shape, np.nan)
        self.plot(np.stack([starts, ends, gap], axis=1).ravel(), np.repeat(places, 3), color=color, lw=lw, zorder=1.9)

    def shape(
        self, points: Any, *, fc: str = "", ec: str = "", lw: float = 1.0, alpha: float = 1.0, zorder: float = 1.0,
        cubic: bool = False, label: str = "",
    ) -> None:  # fmt: skip
        """Draw a polygon, or a closed path of cubic curves."""
        corners = np.asarray(points, dtype=float)
        mark = m.Shape(corners, fc, ec, lw if ec else 0.0, alpha, cubic, layer=zorder, label=label)
        self._add(mark, corners[:, 0], corners[:, 1])

    def rectangle(
        self, at: tuple[float, float], width: float, height: float, *, fc: str = "", ec: str = "", lw: float = 1.0,
        hatched: bool = False, zorder: float = 1.0,
    ) -> None:  # fmt: skip
        """Draw a rectangle from its lower left corner."""
        box = m.Box(*at, width, height, fc, ec, lw if ec else 0.0, hatched=hatched, layer=zorder)
        self._add(box, (at[0], at[0] + width), (at[1], at[1] + height))

    def text(  # noqa: PLR0913
        self, x: float, y: float, words: str, *, fontsize: float = 8.0, color: str = INK, ha: str = "left",
        va: str = "baseline", weight: str = "normal", rotation: float = 0.0, parse_math: bool = False,
        inside: bool = False, zorder: float = 3.0,
    ) -> None:  # fmt: skip
        """Write at a place of the data, or, if ``inside``, at parts of the panel's width and height."""
        frames = ("axes", "axes") if inside else ("data", "data")
        up = va.replace("center_baseline", "center")
        self._write(m.Words(words, x, y, frames, (0.0, 0.0), fontsize, color, ha, up, rotation, weight == "bold",
                            parse_math, layer=zorder))  # fmt: skip

    def annotate(  # noqa: PLR0913
        self, words: str, at: tuple[float, float], shift: tuple[float, float] = (0.0, 0.0), *,
        frames: tuple[str, str] = ("data", "data"), fontsize: float = 8.0, color: str = INK, ha: str = "left",
        va: str = "baseline", rotation: float = 0.0, weight: str = "normal", math: bool = False,
        leader: tuple[float, float] | None = None,
    ) -> None:  # fmt: skip
        """Write beside a place, moved by so many points."""
        self._write(m.Words(words, *at, frames, shift, fontsize, color, ha, va, rotation, weight == "bold", math,
                            leader, layer=3.0))  # fmt: skip

    def _write(self, words: m.Words) -> None:
        self.marks.append(words)

    def picture(self, box: tuple[float, float, float, float], pixels: Any) -> None:
        """Draw cells of colours between left, low, right and high."""
        mark = m.Picture(*box, np.asarray(pixels, dtype=np.uint8), layer=0.2)
        self._add(mark, box[::2], box[1::2])

    # Axes -----------------------------------------------------------------------------------------------------------

    def set(
        self, *, xlabel: str = "", ylabel: str = "", title: str = "", xlim: Any = None, ylim: Any = None,
        xscale: str = "",
    ) -> None:  # fmt: skip
        """Set labels, title, limits and scale at once, as the methods ``set_NAME`` do."""
        self.x.label, self.y.label = xlabel or self.x.label, ylabel or self.y.label
        self.title = title or self.title
        self.x.log = self.x.log or xscale == "log"
        for axis, limits in ((self.x, xlim), (self.y, ylim)):
            if limits is not None:
                _set_limits(axis, limits, None)

    def set_xlim(self, low: Any = None, high: float | None = None, *, left: float | None = None) -> None:
        """Set where x starts and ends."""
        _set_limits(self.x, low if left is None else left, high)

    def set_ylim(self, low: Any = None, high: float | None = None, *, bottom: float | None = None) -> None:
        """Set where y starts and ends; start above end turns the axis round."""
        _set_limits(self.y, low if bottom is None else bottom, high)

    def get_xlim(self) -> tuple[float, float]:
        """Return where x starts and ends."""
        return self.x.limits()

    def get_ylim(self) -> tuple[float, float]:
        """Return where y starts and ends."""
        return self.y.limits()

    def set_xlabel(self, words: str) -> None:
        """Name the axis below."""
        self.x.label = words

    def set_ylabel(self, words: str, *, color: str = INK) -> None:
        """Name the axis at the side."""
        self.y.label, self.y.label_colour = words, color

    def set_title(self, words: str, *, fontsize: float = 9.0, weight: str = "bold") -> None:
        """Write above the panel, from its left edge on."""
        self.title, self.title_size, self.title_bold = words, fontsize, weight == "bold"

    def set_xscale(self, kind: str) -> None:
        """Make x ``log`` or ``linear``."""
        self.x.log = kind == "log"

    def set_yscale(self, kind: str) -> None:
        """Make y ``log`` or ``linear``."""
        self.y.log = kind == "log"

    def set_xticks(self, values: Iterable[float], names: Iterable[str] | None = None, *, fontsize: float = 0.0) -> None:
        """Set the marks of x."""
        _set_ticks(self.x, values, names, fontsize)

    def set_yticks(self, values: Iterable[float], names: Iterable[str] | None = None, *, fontsize: float = 0.0) -> None:
        """Set the marks of y."""
        _set_ticks(self.y, values, names, fontsize)

    def invert_yaxis(self) -> None:
        """Let y rise downwards."""
        self.y.inverted = True

    def margins(self, *, x: float | None = None, y: float | None = None) -> None:
        """Set the free room at the ends of the axes over their ranges."""
        self.x.margin = self.x.margin if x is None else x
        self.y.margin = self.y.margin if y is None else y

    def set_axis_off(self) -> None:
        """Draw neither frame nor axes."""
        self.off = True

    def set_aspect(self, how: str) -> None:
        """Give x and y one scale: ``box`` makes the panel smaller, ``data`` its limits wider."""
        self.aspect = how

    def only_grid(self, axis: str) -> None:
        """Keep the grid lines of one axis, as bars need."""
        other = self.y if axis == "x" else self.x
        other.grid = other.ticks = False

    def twinx(self) -> Axes:
        """Return a panel in the same place whose y stands on the right."""
        self.twin = Axes()
        self.twin.is_twin = True
        self.twin.x, self.twin.y.grid = self.x, False
        return self.twin

    def legend(
        self, where: str = "best", *, columns: int = 1, size: float = 7.5, title: str = "",
    ) -> None:  # fmt: skip
        """Name the marks that have a label."""
        self.key = Legend(where, columns, size, title)


def _set_limits(axis: Axis, low: Any, high: float | None) -> None:
    first, last = low if isinstance(low, tuple | list | np.ndarray) else (low, high)
    if first is not None and last is not None and first > last:
        axis.inverted, first, last = True, last, first
    axis.low, axis.high = (axis.low if first is None else float(first)), (axis.high if last is None else float(last))


def _set_ticks(axis: Axis, values: Iterable[float], names: Iterable[str] | None, size: float) -> None:
    axis.values, axis.names = [float(value) for value in values], None if names is None else list(names)
    axis.size = size or axis.size
    if not axis.log:
        axis.reach(np.array(axis.values))
