"""Everything that a gearbox weighs as areas, and below it the band in which such gearboxes lie."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.ranking import largest_first
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.render.vector.palette import tinted
from gearwright.render.vector.words import text_width
from gearwright.sizing.mass import CompleteMass

FEW = 4
"""Letters of a name that is cut, at least."""
HEIGHT = 88.0
"""Of the areas [mm]."""
LETTERS = 6.5
"""[pt]"""
COLOURS = (*theme.CYCLE, theme.MUTED)
"""Of the groups, the heaviest first."""
_LINE = 3.0
"""Height of a line of letters [mm]."""

Place = tuple[float, float, float, float]
"""Left, low, width, height [mm]."""


def squarified(sizes: Sequence[float], place: Place) -> list[Place]:
    """Return rectangles of given areas that fill a place, as nearly square as rows of them allow.

    Args:
        sizes: Positive, the largest first.
        place: To fill.

    Source: Bruls, Huizing and van Wijk 2000, Squarified Treemaps.

    >>> squarified([2.0, 1.0, 1.0], (0.0, 0.0, 2.0, 2.0))
    [(0.0, 0.0, 1.0, 2.0), (1.0, 0.0, 1.0, 1.0), (1.0, 1.0, 1.0, 1.0)]
    """
    left, low, width, height = place
    scale = width * height / sum(sizes) if sizes else 0.0
    areas, made = [size * scale for size in sizes], list[Place]()
    while areas:
        side = min(width, height)
        longer = (k for k in range(1, len(areas)) if _worst(areas[: k + 1], side) > _worst(areas[:k], side))
        count = next(longer, len(areas))
        row, areas = areas[:count], areas[count:]
        depth, at = sum(row) / side, 0.0
        for area in row:
            long = area / depth
            made.append((left, low + at, depth, long) if width >= height else (left + at, low, long, depth))
            at += long
        if width >= height:
            left, width = left + depth, width - depth
        else:
            low, height = low + depth, height - depth
    return made


def _worst(row: Sequence[float], side: float) -> float:
    """Return the largest ratio of sides in a row along one side."""
    depth = sum(row) / side
    return max(max(depth * depth / area, area / (depth * depth)) for area in row)


@theme.drawn
def treemap_figure(mass: CompleteMass, low: float | None, high: float | None) -> Figure:
    """Return the parts of a complete mass as areas in the colours of their groups, and the bands of the whole.

    Args:
        mass: Sum of all parts.
        low: Least mass that real gearboxes let expect [kg]; None where it is not known.
        high: Greatest [kg].
    """
    figure = theme.sheet(WIDTH, HEIGHT + 34.0)
    areas, bands = figure.grid(2, 1, heights=(HEIGHT, 12.0))[:, 0]
    wide = WIDTH - 12.0
    for k, (group, parts) in enumerate(_groups(mass, (0.0, 0.0, wide, HEIGHT))):
        colour = COLOURS[k % len(COLOURS)]
        for words, place in parts:
            areas.rectangle(place[:2], *place[2:], fc=tinted(colour), ec=theme.PAPER, lw=0.8)
            _label(areas, words, place)
        areas.shape([(0.0, 0.0)] * 3, fc=tinted(colour), label=f"{group}, {mass.of(group):.3g} kg")
    areas.set(xlim=(0.0, wide), ylim=(0.0, HEIGHT), title=f"{mass.design}: {mass.total:.4g} kg")
    areas.set_axis_off()
    areas.legend("below", columns=5, size=LETTERS)
    _draw_bands(bands, mass, low, high)
    return figure


def _groups(mass: CompleteMass, place: Place) -> Iterator[tuple[str, list[tuple[list[str], Place]]]]:
    """Yield each group, the heaviest first, with words and place of its parts."""
    groups = largest_first(mass.groups, lambda group: group.total)
    for group, room in zip(groups, squarified([group.total for group in groups], place), strict=True):
        parts = largest_first((item for item in mass.parts if item.group == group.group), lambda item: item.total)
        places = squarified([item.total for item in parts], room)
        named = [
            [f"{item.count} × {item.part}" if item.count > 1 else item.part, f"{item.total:.3g} kg"] for item in parts
        ]
        yield group.group, list(zip(named, places, strict=True))


def _label(axes: Axes, words: Sequence[str], place: Place) -> None:
    """Write what fits: name and mass, or the name alone."""
    left, low, width, height = place
    name = _cut(words[0], width - 2.0)
    fitting = [word for word in (name, words[1]) if word and text_width(word, LETTERS, bold=False) <= width - 2.0]
    shown = fitting[: int((height - 1.0) / _LINE)]
    for k, word in enumerate(shown):
        axes.text(left + 1.0, low + height - 0.8 - k * _LINE, word, fontsize=LETTERS, va="top")


def _cut(word: str, width: float) -> str:
    """Return a word as far as it fits, nothing where that is less than a few letters."""
    if text_width(word, LETTERS, bold=False) <= width:
        return word
    shorter = (k for k in range(len(word) - 1, FEW, -1) if text_width(f"{word[:k]}…", LETTERS, bold=False) <= width)
    fits = next(shorter, 0)
    return word[:fits] + "…" if fits else ""


def _draw_bands(axes: Axes, mass: CompleteMass, low: float | None, high: float | None) -> None:
    rows = [("sum of its parts", mass.band, theme.BLUE)]
    if low is not None and high is not None:
        rows.append(("61 real gearboxes", (low, high), theme.MUTED))
    for place, (_, ends, colour) in enumerate(rows):
        axes.barh(place, ends[1] - ends[0], left=ends[0], height=0.6, color=colour)
    axes.x.zero = False
    axes.axvline(mass.total, color=theme.INK, lw=1.2)
    axes.set_yticks(range(len(rows)), [name for name, *_ in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xlim(0.0, 1.1 * max(ends[1] for _, ends, _ in rows))
    axes.set_xlabel("complete mass [kg]; bars: 68 %, line: this gearbox")
    axes.only_grid("x")
