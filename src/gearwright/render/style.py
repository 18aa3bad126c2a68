"""The look of everything that is drawn: one font, one palette, labels that do not overlap, formulas as MathML.

What is drawn is decided in the rooms above.
"""

import functools
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from html import escape
from itertools import pairwise
from types import MappingProxyType
from typing import ParamSpec

import numpy as np

from gearwright.base import Floats, verb
from gearwright.render.vector.figure import (
    AMBER,
    BLUE,
    CYCLE,
    GREEN,
    HAIR,
    INK,
    MUTED,
    ORANGE,
    PAPER,
    PURPLE,
    SKY,
    STEEL,
    Axes,
    Box as Rectangle,
    Curve,
    Figure,
    Shape,
)
from gearwright.render.vector.layout import POINT, SPACING, text_width
from gearwright.render.vector.svg import svg_text

__all__ = ["AMBER", "BLUE", "CYCLE", "GREEN", "HAIR", "INK", "MUTED", "ORANGE", "PAPER", "PURPLE", "SKY", "STEEL"]


# ----------------------------------------------------------------------------------------------------------------------
# The look of every figure: one font, one small palette, a thin grid; and a figure as SVG or PNG, the same each time.
#
# Figures are values of `vector`.
# ----------------------------------------------------------------------------------------------------------------------


Drawing = Figure


WIDTH = 180.0
"""Of a figure on an A4 page [mm]."""
KIND_COLOURS: Mapping[str, str] = MappingProxyType({"turbine": BLUE, "motor": ORANGE, "propeller": GREEN})
"""Colour of the power that each kind of machine gives."""
INCH = 25.4
"""[mm]; figures are sized in mm of paper."""
RESOLUTION = 160.0
"""Of PNG images [dots per inch]."""

_Inputs = ParamSpec("_Inputs")


def drawn(draw: Callable[_Inputs, Figure]) -> Callable[_Inputs, Figure]:
    """Return a drawing function that refuses what is not of its types, as every public verb.

    Args:
        draw: Builds the figure.
    """
    return functools.wraps(draw)(verb(draw))


def sheet(width: float, height: float) -> Figure:
    """Return an empty figure.

    Args:
        width: Of the paper [mm].
        height: Of the paper [mm].
    """
    return Figure(width, height)


def tiles(
    count: int, columns: int, *, frame: float, row: float, share_x: bool = False, share_y: str = ""
) -> tuple[Figure, np.ndarray]:
    """Return a figure as wide as a page and its panels in rows; those that are left over stay empty.

    Args:
        count: Of panels that are drawn.
        columns: Panels side by side.
        frame: Height of all that stands outside the rows [mm].
        row: Height of a row [mm].
        share_x: One scale along x for all.
        share_y: ``all``: one scale along y for all.
    """
    rows = max(1, -(-count // columns))
    figure = sheet(WIDTH, frame + row * rows)
    grid = figure.grid(rows, columns, share_x=share_x, share_y=share_y)
    for axes in grid.flat[count:]:
        axes.set_axis_off()
    return figure, grid


def to_svg(figure: Figure, prefix: str = "", *, styled: bool = True) -> str:
    """Return a figure as an SVG element that stands alone or inside a page.

    Args:
        figure: As drawn.
        prefix: Goes before every id, so that several figures can share a page.
        styled: With its own style; else the page has it.
    """
    return svg_text(figure, prefix, styled=styled)


def to_png(figure: Figure, resolution: float = RESOLUTION) -> bytes:
    """Return a figure as a PNG image.

    Args:
        figure: As drawn.
        resolution: [dots per inch].

    Raises:
        DesignError: If matplotlib is not installed.
    """
    return figure.png(resolution)


# ----------------------------------------------------------------------------------------------------------------------
# Labels that do not overlap: each takes the first of its places that is free of parts and of other labels.
# ----------------------------------------------------------------------------------------------------------------------


MARGIN = 0.6
"""Free room around a label [mm]."""

Box = tuple[float, float, float, float]
"""Left, low, right, high [mm]."""


@dataclass
class Board:
    """A drawing in mm of paper, and what is taken of it."""

    axes: Axes
    taken: list[Box] = field(default_factory=list)
    labels: list[Box] = field(default_factory=list)
    """Boxes of the labels alone."""

    def take_parts(self) -> None:
        """Count everything drawn so far as taken."""
        self.taken += [mark.box for mark in (*self.axes.of(Rectangle), *self.axes.of(Shape))]
        for curve in self.axes.of(Curve):
            points = np.stack([curve.x, curve.y], axis=1).tolist()
            self.taken += [(min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1]))
                           for a, b in pairwise(points)]  # fmt: skip

    def place(
        self, text: str, places: Iterable[tuple[float, float]], *, size: float = 6.5, bold: bool = False,
        colour: str = INK,
    ) -> Box:  # fmt: skip
        """Write a label at the first of its places that is free, or else where it overlaps least.

        Args:
            text: Lines to write: names, numbers, and symbols between dollar signs.
            places: Middles (x, y) in order of preference [mm].
            size: Of the font [pt].
            bold: First line in bold.
            colour: Of the text.

        Returns:
            The label's box.
        """
        lines = text.split("\n")
        width, height = max(text_width(line, size, math=True) for line in lines), len(lines) * size * SPACING * POINT
        boxes = [(x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0) for x, y in places]
        taken = np.array(self.taken).reshape(-1, 4)
        box = min(boxes, key=lambda place: _covered(place, taken))
        for k, line in enumerate(lines):
            y = box[3] - (k + 0.5) * size * SPACING * POINT
            self.axes.text((box[0] + box[2]) / 2.0, y, line, ha="center", va="center_baseline", fontsize=size,
                           color=colour, weight="bold" if bold and k == 0 else "normal", zorder=8,
                           parse_math=True)  # fmt: skip
        self.taken.append(box)
        self.labels.append(box)
        return box

    def extent(self) -> Box:
        """Return the box of everything that is taken [mm]."""
        return (
            min(box[0] for box in self.taken), min(box[1] for box in self.taken),
            max(box[2] for box in self.taken), max(box[3] for box in self.taken),
        )  # fmt: skip


def spread(places: Sequence[float], gap: float) -> list[float]:
    """Return places in their order that are moved as little as keeps them a gap apart.

    Args:
        places: Rising.
        gap: Least distance.

    >>> spread([0.0, 0.0, 10.0], 2.0)
    [-1.0, 1.0, 10.0]
    """
    groups: list[list[float]] = []
    for place in places:
        groups.append([place])
        while len(groups) > 1 and _middle(groups[-1]) - _middle(groups[-2]) < gap * len(groups[-2] + groups[-1]) / 2.0:
            last = groups.pop()
            groups[-1] += last
    return [_middle(group) + gap * (k - (len(group) - 1) / 2.0) for group in groups for k in range(len(group))]


def _middle(group: list[float]) -> float:
    return sum(group) / len(group)


def _covered(box: Box, taken: Floats) -> float:
    """Return the sum of the `overlap` of a box with others [mm²], shape (others, 4)."""
    size = np.minimum(box[2:], taken[:, 2:]) - np.maximum(box[:2], taken[:, :2]) + MARGIN
    return float(np.prod(np.maximum(size, 0.0), axis=1).sum())


def overlap(box: Box, other: Box) -> float:
    """Return the area in which two boxes meet, free room around them counted [mm²].

    Args:
        box: Of a label.
        other: Of anything.
    """
    width = min(box[2], other[2]) - max(box[0], other[0]) + MARGIN
    height = min(box[3], other[3]) - max(box[1], other[1]) + MARGIN
    return max(width, 0.0) * max(height, 0.0)


# ----------------------------------------------------------------------------------------------------------------------
# Marks that are made of several: stacks, ranges, and maps of colours with their bar.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Formulas as they stand in the code, such as ``σ_H = Z_H √(F_t/(d_1 b))``, as mathematics that a browser sets.
# ----------------------------------------------------------------------------------------------------------------------


_ABOVE = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻½ᵀ"
_INDEX = rf"[^\W_{_ABOVE}]"
_TOKEN = re.compile(
    r"(?P<space>\s+)"
    r"|(?P<number>\d+(?:\.\d+)?)"
    r"|(?P<operator>[ΣΠ])"
    rf"|(?P<raised>[{_ABOVE}]+)"
    rf"|(?P<name>[^\W\d_{_ABOVE}]+\u0307?(?:'s\b)?(?:[′*](?![^\W_]))*)(?:_(?P<below>{_INDEX}+(?:[.*]{_INDEX}+)*(?:[,-][^\W\d_]+)*))?"
    r"|(?P<sign>.)"
)
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᵀ", "0123456789−T")
_FUNCTIONS = {"sin", "cos", "tan", "cot", "inv", "ln", "log", "exp", "max", "min"}
_SIGNS = set("=+−·×≥≤<>±∓Σ∫Π∝→")
_GREEK = re.compile(r"[α-ωΑ-Ωϑϕ]")
_MATHEMATICS = re.compile(r"[=√Σ∫Πα-ωΑ-Ωϑ²³⁴^]|_|\d")
_WORD = re.compile(r"[^\W\d_]{3}")
_THIN = "<mspace width=.22em />"
_ROOT, _OVER, _POWER = "√", "/", "^"


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    below: str = ""


@cache
def mathml(formula: str) -> str:
    """Return a formula as MathML; what is words alone comes back as words. Both are safe in HTML.

    Args:
        formula: In the trade's symbols: ``_`` sets what follows below, ``^`` or a raised digit above, ``√`` takes what
            stands next, ``/`` divides its neighbours, and with blanks around it all that is multiplied before it.

    >>> mathml("its gears")
    'its gears'
    >>> mathml("T/r")
    '<math><mfrac><mi>T</mi><mi>r</mi></mfrac></math>'
    """
    if not _MATHEMATICS.search(formula) and _WORD.search(formula):
        return escape(formula)
    return f"<math>{_Reader(_tokens(formula)).sum_to('')}</math>"


def _tokens(formula: str) -> list[_Token]:
    made = []
    for match in _TOKEN.finditer(formula):
        kind = match.lastgroup if match.lastgroup != "below" else "name"
        kind = "sign" if kind == "operator" else kind
        made.append(_Token(kind or "sign", match["name"] or match[0], match["below"] or ""))
    return made


class _Reader:
    """Reads tokens from left to right."""

    def __init__(self, tokens: list[_Token]) -> None:
        self.tokens = tokens
        self.at = 0

    def peek(self, ahead: int = 0) -> _Token:
        place = self.at + ahead
        return self.tokens[place] if place < len(self.tokens) else _Token("end", "")

    def sum_to(self, closing: str) -> str:
        """Return all up to a closing sign, signs between products."""
        parts: list[str] = []
        while self.peek().kind != "end" and not (closing and self.peek().text == closing):
            token = self.peek()
            if token.kind == "space":
                self.at += 1
            elif token.kind == "sign" and token.text in _SIGNS:
                self.at += 1
                parts.append(f"<mo>{escape(token.text)}</mo>")
            elif token.kind == "sign" and token.text in ",;:":
                self.at += 1
                parts.append(f"<mtext>{token.text}&#160;</mtext>")
            else:
                parts.append(self.product(closing))
        return "".join(parts)

    def product(self, closing: str) -> str:
        """Return factors one beside the other, with their fractions."""
        factors: list[str] = []
        while True:
            token = self.peek()
            spaced = token.kind == "space"
            following = self.peek(1) if spaced else token
            ends = following.kind == "end" or (closing != "" and following.text == closing)
            if ends or (following.kind == "sign" and (following.text in _SIGNS or following.text in ",;:")):
                break
            self.at += spaced
            if following.text == _OVER and following.kind == "sign":
                self.at += 1
                self.at += self.peek().kind == "space"
                above = _row(factors) if spaced else (factors.pop() if factors else "<mrow></mrow>")
                factors = [] if spaced else factors
                below = self.factor()
                factors.append(f"<mfrac>{_bare(above)}{_bare(below)}</mfrac>")
            else:
                factors.append(self.factor())
        return _beside(factors)

    def factor(self) -> str:
        """Return one factor with what stands above it; a function takes what stands next."""
        function = self.peek().kind == "name" and self.peek().text in _FUNCTIONS
        made = self.raised()
        if function and self.peek().kind == "space" and self.peek(1).kind in ("name", "number"):
            self.at += 1
            return f"<mrow>{made}{_THIN}{self.factor()}</mrow>"
        return made

    def raised(self) -> str:
        """Return one atom with what stands above it."""
        made = self.atom()
        while True:
            token = self.peek()
            if token.kind == "raised":
                self.at += 1
                above = f"<mn>{token.text.translate(_RAISED)}</mn>"
            elif token.kind == "sign" and token.text == _POWER:
                self.at += 1
                above = _bare(self.atom())
            else:
                return made
            made = f"<msup>{made}{above}</msup>"

    def atom(self) -> str:
        """Return a number, a symbol, a root, what stands in parentheses, or a word."""
        token = self.peek()
        self.at += 1
        if token.kind == "number":
            return f"<mn>{token.text}</mn>"
        if token.kind == "name":
            return _named(token)
        if token.text == _ROOT:
            return f"<msqrt>{self._under_root()}</msqrt>"
        if token.text in "([":
            closing = ")" if token.text == "(" else "]"
            inside = self.sum_to(closing)
            closed = self.peek().text == closing
            self.at += closed
            end = f"<mo stretchy=false>{closing}</mo>" if closed else ""
            return f"<mrow><mo stretchy=false>{token.text}</mo>{inside}{end}</mrow>"
        if token.text in ("−", "+"):
            return f"<mrow><mo>{token.text}</mo>{self.factor()}</mrow>"
        return "<mrow></mrow>" if token.kind == "end" else f"<mtext>{escape(token.text)}</mtext>"

    def _under_root(self) -> str:
        """Return what a root is taken of: what stands in parentheses, one symbol, or a function with its argument."""
        first = self.peek().text
        made = _bare(self.atom())
        if first in _FUNCTIONS and self.peek().kind == "space":
            self.at += 1
            made += f"{_THIN}{self.atom()}"
        return made


def _named(token: _Token) -> str:
    """Return a symbol, upright where it is a function or a word."""
    name = escape(token.text)
    short = len(re.sub(r"[′*\u0307]", "", token.text)) == 1
    if token.text in _FUNCTIONS or (not short and not _GREEK.search(token.text) and token.below):
        symbol = f'<mi mathvariant="normal">{name}</mi>' if short else f"<mi>{name}</mi>"
    elif short or (_GREEK.search(token.text) and len(token.text) <= 2):
        symbol = f"<mi>{name}</mi>"
    else:
        return f"<mtext>{name}</mtext>"
    return f"<msub>{symbol}<mtext>{escape(token.below)}</mtext></msub>" if token.below else symbol


_ENCLOSED = re.compile(r"<mrow><mo stretchy=false>[(\[]</mo>(.*)<mo stretchy=false>[)\]]</mo></mrow>")


def _bare(made: str) -> str:
    """Return what stands in one pair of parentheses without them: a bar or a root encloses it already."""
    match = _ENCLOSED.fullmatch(made)
    if match is None:
        return made
    inside, depth = match[1], 0
    for sign in re.findall(r"stretchy=false>([(\[)\]])", inside):
        depth += 1 if sign in "([" else -1
        if depth < 0:
            return made
    return f"<mrow>{inside}</mrow>"


def _row(factors: list[str]) -> str:
    return factors[0] if len(factors) == 1 else f"<mrow>{_beside(factors)}</mrow>"


_WORDS = re.compile(r"<mtext>([^<]*)</mtext>")


def _beside(factors: list[str]) -> str:
    """Return factors one beside the other, words in one piece."""
    pieces: list[str] = []
    for factor in factors:
        word, before = _WORDS.fullmatch(factor), _WORDS.fullmatch(pieces[-1]) if pieces else None
        if word and before:
            pieces[-1] = f"<mtext>{before[1]} {word[1]}</mtext>"
        else:
            pieces.append(factor)
    return _THIN.join(pieces)
