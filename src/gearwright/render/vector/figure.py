"""A figure as a value: paper, panels with axes, marks in the units of their data, colours."""

from __future__ import annotations

import functools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from gearwright.base import DesignError, Floats, Problem, install
from gearwright.files import write_bytes, write_text

# ----------------------------------------------------------------------------------------------------------------------
# Colours of everything that is drawn, for light and for dark paper, and the classes by which a page may change them.
#
# The palette is Okabe and Ito's, which also those see who do not tell red from green.
# ----------------------------------------------------------------------------------------------------------------------


INK, MUTED, HAIR, PAPER = "#1d2530", "#66707c", "#d9dde2", "#ffffff"
BLUE, ORANGE, GREEN, PURPLE = "#0072b2", "#d55e00", "#009e73", "#a3548c"
SKY, AMBER = "#56b4e9", "#e69f00"
STEEL = "#e4e8ed"
"""Fill of gears and boxes."""
DARK_STEEL, PALE_STEEL, DEEP_STEEL = "#cdd5de", "#f3f5f7", "#b4bfca"
"""Shades of gears that lie beside each other."""
CYCLE = (BLUE, ORANGE, GREEN, PURPLE, SKY, AMBER)
"""Colours of curves, in order."""
TINT = 0.42
"""Share of the colour in the bands of power [-]."""

NAMES: Mapping[str, str] = MappingProxyType({
    INK: "ink", MUTED: "muted", HAIR: "hair", PAPER: "paper", BLUE: "blue", ORANGE: "orange", GREEN: "green",
    PURPLE: "purple", SKY: "sky", AMBER: "amber", STEEL: "steel", DARK_STEEL: "steel-2", PALE_STEEL: "steel-3",
    DEEP_STEEL: "steel-4",
})  # fmt: skip
"""Colour -> what a page calls it: the CSS variable is ``--gw-NAME``."""
DARK: Mapping[str, str] = MappingProxyType({
    "ink": "#e6e9ed", "muted": "#a0a9b4", "hair": "#39424d", "paper": "#171b21", "blue": "#4ba3dc",
    "orange": "#ee8344", "green": "#35c29b", "purple": "#cd86b8", "sky": "#7cc7f2", "amber": "#f0b73c",
    "steel": "#2d3642", "steel-2": "#3f4b5a", "steel-3": "#252d37", "steel-4": "#566476",
})  # fmt: skip
"""Name -> colour on dark paper."""


@functools.cache
def tinted(colour: str, strength: float = TINT) -> str:
    """Return a colour mixed with white.

    Args:
        colour: As ``#rrggbb``.
        strength: Share of the colour [-].
    """
    parts = [255.0 - strength * (255.0 - int(colour[k : k + 2], 16)) for k in (1, 3, 5)]
    return "#" + "".join(f"{round(part):02x}" for part in parts)


_TINTS: Mapping[str, str] = MappingProxyType({tinted(colour): name for colour, name in NAMES.items()})


def css_value(colour: str) -> tuple[str, str] | None:
    """Return the short name and the CSS value of a colour that pages may change; None for one that stays.

    Args:
        colour: As ``#rrggbb``.
    """
    if colour in NAMES:
        return NAMES[colour], f"var(--gw-{NAMES[colour]},{colour})"
    if colour in _TINTS:
        name = _TINTS[colour]
        whole = next(value for value, word in NAMES.items() if word == name)
        mixed = f"color-mix(in srgb,var(--gw-{name},{whole}) {100.0 * TINT:g}%,var(--gw-paper,{PAPER}))"
        return f"{name}-t", mixed
    return None


# ----------------------------------------------------------------------------------------------------------------------
# Marks on a panel, in the units of its data: curves, fills, boxes, dots, rules, shapes, words, pictures.
# ----------------------------------------------------------------------------------------------------------------------


EMPTY: Floats = np.zeros(0)


@dataclass(frozen=True)
class Pen:
    """How a line is drawn."""

    colour: str = INK
    width: float = 1.1
    """[pt]"""
    dash: str = "-"
    """``-``, ``--``, ``:`` or empty for no line."""
    alpha: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Mark:
    """What all marks have."""

    layer: float = 2.0
    label: str = ""
    """In the legend."""
    name: str = ""
    """What a pointer is told."""


@dataclass(frozen=True)
class Curve(Mark):
    """A line through points, and marks at them."""

    x: Floats
    y: Floats
    pen: Pen
    marker: str = ""
    """``o``, ``s``, ``^``, ``D``, ``v``, ``.`` or ``_``."""
    size: float = 6.0
    """Of the marks [pt]."""
    face: str = ""
    edge: str = ""
    edge_width: float = 0.0


@dataclass(frozen=True)
class Fill(Mark):
    """What lies between two curves."""

    x: Floats
    low: Floats
    high: Floats
    colour: str
    alpha: float = 1.0


@dataclass(frozen=True)
class Box(Mark):
    """A rectangle, such as a bar."""

    left: float
    low: float
    width: float
    height: float
    fill: str = ""
    edge: str = ""
    edge_width: float = 0.0
    alpha: float = 1.0
    hatched: bool = False
    bar: str = ""
    """Direction of the bar that it is: ``x``, ``y``, or empty."""

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Return left, low, right, high."""
        x, y = sorted((self.left, self.left + self.width)), sorted((self.low, self.low + self.height))
        return x[0], y[0], x[1], y[1]


@dataclass(frozen=True)
class Dots(Mark):
    """Discs whose areas mean something."""

    x: Floats
    y: Floats
    area: Floats
    """[pt²]"""
    faces: tuple[str, ...]
    edge: str = ""
    edge_width: float = 0.0
    alpha: float = 1.0


@dataclass(frozen=True)
class Rule(Mark):
    """A line or band across the whole panel."""

    axis: str
    """``x``: at a value of x, upright; ``y``: level."""
    low: float
    high: float
    """The same as low: a line."""
    pen: Pen


@dataclass(frozen=True)
class Shape(Mark):
    """A polygon or a closed path of cubic curves."""

    points: Floats
    """Shape (points, 2)."""
    fill: str = ""
    edge: str = ""
    edge_width: float = 0.0
    alpha: float = 1.0
    cubic: bool = False
    """Points after the first come in threes, two of them handles."""

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Return left, low, right, high."""
        low, high = np.min(self.points, axis=0), np.max(self.points, axis=0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])


@dataclass(frozen=True)
class TextMark(Mark):
    """A text at a place."""

    text: str
    x: float
    y: float
    frames: tuple[str, str] = ("data", "data")
    """What x and y count in: ``data`` or ``axes`` (0 to 1 across the panel)."""
    shift: tuple[float, float] = (0.0, 0.0)
    """[pt]"""
    size: float = 8.0
    """[pt]"""
    colour: str = INK
    across: str = "left"
    """``left``, ``center`` or ``right``."""
    up: str = "baseline"
    """``baseline``, ``center``, ``top`` or ``bottom``."""
    turned: float = 0.0
    """[°]"""
    bold: bool = False
    math: bool = False
    leader: tuple[float, float] | None = None
    """Point of the data that a thin line leads to."""
    leader_colour: str = MUTED


@dataclass(frozen=True)
class Picture(Mark):
    """Colours in cells, the first row lowest."""

    left: float
    low: float
    right: float
    high: float
    pixels: np.ndarray = field(repr=False)
    """Shape (rows, columns, 3), bytes."""


def circle(centre: tuple[float, float], width: float, height: float) -> Floats:
    """Return an ellipse as four cubic curves.

    Args:
        centre: (x, y).
        width: Whole.
        height: Whole.
    """
    k = 0.5522847498
    unit = [(1, 0), (1, k), (k, 1), (0, 1), (-k, 1), (-1, k), (-1, 0), (-1, -k), (-k, -1), (0, -1), (k, -1), (1, -k),
            (1, 0)]  # fmt: skip
    return np.array([(centre[0] + width / 2.0 * x, centre[1] + height / 2.0 * y) for x, y in unit])


# ----------------------------------------------------------------------------------------------------------------------
# One axis of a panel: its limits, from what is drawn or as they are given, its marks and its name.
# ----------------------------------------------------------------------------------------------------------------------


NOWHERE = (np.inf, -np.inf)


@dataclass
class Axis:
    """One axis of a panel."""

    log: bool = False
    low: float | None = None
    high: float | None = None
    margin: float = 0.05
    """Free room at each end over the range [-]."""
    values: list[float] | None = None
    """Marks that are asked for."""
    names: list[str] | None = None
    label: str = ""
    label_colour: str = INK
    size: float = 8.0
    """Of the numbers [pt]."""
    grid: bool = True
    ticks: bool = True
    numbers: bool = True
    most: int = 0
    """Steps, at most; 0: as there is room."""
    mates: list[Axis] = field(default_factory=list)
    """Axes with the same limits."""
    extent: tuple[float, float] = NOWHERE
    least: float = np.inf
    """Least positive value."""
    zero: bool = False
    """Bars start at zero."""
    inverted: bool = False

    def reach(self, values: Floats) -> None:
        """Count values as shown."""
        numbers = np.asarray(values, dtype=float).ravel()
        numbers = numbers[np.isfinite(numbers)]
        if len(numbers):
            self.extent = (min(self.extent[0], float(numbers.min())), max(self.extent[1], float(numbers.max())))
            positive = numbers[numbers > 0.0]
            self.least = min(self.least, float(positive.min()) if len(positive) else np.inf)

    def limits(self) -> tuple[float, float]:
        """Return where the axis starts and ends; the first is larger where it is inverted."""
        axes = self.mates or [self]
        low, high = min(axis.extent[0] for axis in axes), max(axis.extent[1] for axis in axes)
        given_low = next((axis.low for axis in axes if axis.low is not None), None)
        given_high = next((axis.high for axis in axes if axis.high is not None), None)
        log, zero, inverted = (any(getattr(axis, name) for axis in axes) for name in ("log", "zero", "inverted"))
        if log:
            low = min(axis.least for axis in axes)
        if low > high:
            low, high = (1.0, 10.0) if log else (0.0, 1.0)
        low, high = _widened(low, high, min(axis.margin for axis in axes), log=log, zero=zero)
        low, high = (low if given_low is None else given_low), (high if given_high is None else given_high)
        if low == high:
            high = low + (abs(low) or 1.0)
        return (high, low) if inverted else (low, high)


def _widened(low: float, high: float, margin: float, *, log: bool, zero: bool) -> tuple[float, float]:
    if log:
        factor = (high / low) ** margin if high > low else 2.0
        return low / factor, high * factor
    room = margin * (high - low) if high > low else 0.05 * (abs(high) or 1.0)
    return (0.0 if zero and low == 0.0 else low - room), (0.0 if zero and high == 0.0 else high + room)


# ----------------------------------------------------------------------------------------------------------------------
# A panel: marks in the units of its data, two axes, title and legend, until it is laid out.
# ----------------------------------------------------------------------------------------------------------------------


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
        self.marks: list[Mark] = []
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
        return [word for word in (self.title, *named, *keys, *(mark.text for mark in self.of(TextMark))) if word]

    # Marks ----------------------------------------------------------------------------------------------------------

    def _add(self, mark: Mark, x: Any = (), y: Any = ()) -> None:
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
            pen = Pen(tone, lw, dash, alpha)
            curve = Curve(across, column, pen, mark, ms, mfc or tone, mec, mew or (1.0 if mec else 0.0), layer=zorder,
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
            box = Box(float(start), row - height / 2.0, float(length), height, tone, edgecolor, linewidth, bar="x",
                        label=label if k == 0 else "", layer=1.0)  # fmt: skip
            self._add(box, (start, start + length), (row - height / 2.0, row + height / 2.0))
        self.x.zero = True

    def hist(self, values: Any, bins: Any = 10, *, color: str = "", alpha: float = 1.0, label: str = "") -> None:
        """Draw how often values fall into bins."""
        count, edges = np.histogram(np.asarray(values, dtype=float), bins)
        tone = color or self.colour()
        for k, number in enumerate(count.tolist()):
            box = Box(float(edges[k]), 0.0, float(edges[k + 1] - edges[k]), number, tone, alpha=alpha, bar="y",
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
        self._add(Fill(across, ends[0], ends[1], tone, alpha, label=label, layer=zorder), across, ends)
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
        self._add(Dots(across, up, area, faces, edgecolors, lw, alpha, label=label, layer=zorder), across, up)

    def rule(self, axis: str, low: float, high: float, pen: Pen, layer: float) -> None:
        """Draw a line or a band across the panel."""
        mark = Rule(axis, low, high, pen, layer=layer)
        self._add(mark, *(((low, high), ()) if axis == "x" else ((), (low, high))))

    def axvline(
        self, x: float, *, color: str = INK, lw: float = 1.1, ls: str = "-", zorder: float = 2.0, alpha: float = 1.0
    ) -> None:
        """Draw an upright line across the panel."""
        self.rule("x", x, x, Pen(color, lw, ls, alpha), zorder)

    def axhline(
        self, y: float, *, color: str = INK, lw: float = 1.1, ls: str = "-", zorder: float = 2.0, alpha: float = 1.0
    ) -> None:
        """Draw a level line across the panel."""
        self.rule("y", y, y, Pen(color, lw, ls, alpha), zorder)

    def axvspan(
        self, low: float, high: float, *, color: str, alpha: float = 1.0, lw: float = 0.0, zorder: float = 0.0
    ) -> None:
        """Fill an upright band across the panel."""
        self.rule("x", low, high, Pen(color, lw, "", alpha), zorder)

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
        mark = Shape(corners, fc, ec, lw if ec else 0.0, alpha, cubic, layer=zorder, label=label)
        self._add(mark, corners[:, 0], corners[:, 1])

    def rectangle(
        self, at: tuple[float, float], width: float, height: float, *, fc: str = "", ec: str = "", lw: float = 1.0,
        hatched: bool = False, zorder: float = 1.0,
    ) -> None:  # fmt: skip
        """Draw a rectangle from its lower left corner."""
        box = Box(*at, width, height, fc, ec, lw if ec else 0.0, hatched=hatched, layer=zorder)
        self._add(box, (at[0], at[0] + width), (at[1], at[1] + height))

    def text(  # noqa: PLR0913
        self, x: float, y: float, words: str, *, fontsize: float = 8.0, color: str = INK, ha: str = "left",
        va: str = "baseline", weight: str = "normal", rotation: float = 0.0, parse_math: bool = False,
        inside: bool = False, zorder: float = 3.0,
    ) -> None:  # fmt: skip
        """Write at a place of the data, or, if ``inside``, at parts of the panel's width and height."""
        frames = ("axes", "axes") if inside else ("data", "data")
        up = va.replace("center_baseline", "center")
        self._write(TextMark(words, x, y, frames, (0.0, 0.0), fontsize, color, ha, up, rotation, weight == "bold",
                            parse_math, layer=zorder))  # fmt: skip

    def annotate(  # noqa: PLR0913
        self, words: str, at: tuple[float, float], shift: tuple[float, float] = (0.0, 0.0), *,
        frames: tuple[str, str] = ("data", "data"), fontsize: float = 8.0, color: str = INK, ha: str = "left",
        va: str = "baseline", rotation: float = 0.0, weight: str = "normal", math: bool = False,
        leader: tuple[float, float] | None = None,
    ) -> None:  # fmt: skip
        """Write beside a place, moved by so many points."""
        self._write(TextMark(words, *at, frames, shift, fontsize, color, ha, va, rotation, weight == "bold", math,
                            leader, layer=3.0))  # fmt: skip

    def _write(self, words: TextMark) -> None:
        self.marks.append(words)

    def picture(self, box: tuple[float, float, float, float], pixels: Any) -> None:
        """Draw cells of colours between left, low, right and high."""
        mark = Picture(*box, np.asarray(pixels, dtype=np.uint8), layer=0.2)
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


# ----------------------------------------------------------------------------------------------------------------------
# A figure: paper of a size, panels in rows and columns, words below all of them.
# ----------------------------------------------------------------------------------------------------------------------


RESOLUTION = 160.0
"""Of PNG images [dots per inch]."""


@dataclass(frozen=True)
class Parallel:
    """Cases across parallel axes, which a page lets a reader brush."""

    names: tuple[str, ...]
    """Of the axes, with units."""
    values: np.ndarray
    """Shape (cases, axes)."""
    drawn: tuple[int, ...]
    """Places of the cases that are drawn."""
    chosen: tuple[int, ...]
    """Places of those that stand out."""


@dataclass
class Slot:
    """A panel and its place."""

    axes: Axes
    row: int
    column: int


@dataclass
class Figure:
    """What is drawn, until a writer asks for it."""

    width: float
    """Of the paper [mm]."""
    height: float
    """Of the paper [mm]."""
    slots: list[Slot] = field(default_factory=list)
    heights: list[float] = field(default_factory=lambda: [1.0])
    """Of the rows, in parts."""
    widths: list[float] = field(default_factory=lambda: [1.0])
    """Of the columns, in parts."""
    caption: str = ""
    """One line below all panels."""
    shared_key: int = 0
    """Columns of a legend below all panels, of the first one's marks; 0: none."""
    bare: bool = False
    """One panel that is the whole paper, in mm."""
    title: str = ""
    """For readers of screens; left out: the titles of the panels."""
    parallel: Parallel | None = None
    """What stands across parallel axes, where it is that."""

    @property
    def axes(self) -> list[Axes]:
        """Return the panels, row by row."""
        return [slot.axes for slot in self.slots]

    def texts(self) -> list[str]:
        """Return all that is written on it."""
        return [*(word for axes in self.axes for word in axes.texts()), *([self.caption] if self.caption else [])]

    def savefig(self, path: str | Path) -> None:
        """Write the figure as a file.

        Args:
            path: Of the file, ``*.svg`` or ``*.png``.

        Raises:
            DesignError: If the name ends otherwise, or matplotlib is not installed.
        """
        target = Path(path)
        if target.suffix == ".png":
            write_bytes(target, self.png())
        elif target.suffix == ".svg":
            write_text(target, self._repr_html_())
        else:
            message = f"{target.suffix!r} is not drawn; end the name with .svg or .png"
            raise DesignError([Problem("path", message)], "figure")

    def png(self, resolution: float = RESOLUTION) -> bytes:
        """Return it as a PNG image.

        Args:
            resolution: [dots per inch].

        Raises:
            DesignError: If matplotlib is not installed; with how to get it.
        """
        try:
            from gearwright.render.vector.pixels import to_png
        except ModuleNotFoundError:
            message = f"PNG needs matplotlib, which is not here; {install('png')}, or end the name with .svg"
            raise DesignError([Problem("path", message)], "figure") from None
        return to_png(self, resolution)

    def _repr_html_(self) -> str:
        """Return the figure as a notebook shows it."""
        from gearwright.render.vector.svg import svg_text

        return svg_text(self)

    def panel(self) -> Axes:
        """Add the only panel and return it."""
        axes: Axes = self.grid(1, 1)[0, 0]
        return axes

    def grid(
        self, rows: int, columns: int, *, heights: Sequence[float] = (), widths: Sequence[float] = (),
        share_x: bool = False, share_y: str = "",
    ) -> np.ndarray:  # fmt: skip
        """Add panels in rows and columns and return them, shape (rows, columns).

        Args:
            rows: How many.
            columns: How many.
            heights: Of the rows, in parts.
            widths: Of the columns, in parts.
            share_x: One scale along x for all, its numbers below the last row.
            share_y: ``all`` or ``row``: one scale along y, its numbers at the first column.
        """
        self.heights, self.widths = list(heights) or [1.0] * rows, list(widths) or [1.0] * columns
        panels = np.array([[Axes() for _ in range(columns)] for _ in range(rows)], dtype=object).reshape(rows, columns)
        self.slots = [Slot(panels[row, column], row, column) for row in range(rows) for column in range(columns)]
        if share_x:
            _marry([axes.x for axes in panels.flat])
            for axes in panels[:-1].flat:
                axes.x.numbers = False
        for group in [panels.flat] if share_y == "all" else panels if share_y == "row" else []:
            _marry([axes.y for axes in group])
        if share_y:
            for axes in panels[:, 1:].flat:
                axes.y.numbers = False
        return panels


def _marry(axes: list[Axis]) -> None:
    for axis in axes:
        axis.mates = axes
