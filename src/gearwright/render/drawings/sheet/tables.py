"""Tables on a sheet: tooth data, fits, parts; and notes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gearwright.render.drawings.sheet.entities import SMALL, Entity, Layer, Path, Words, words_length

ROW = 5.0
"""Height of a row [mm]."""
PAD = 1.5
"""Between a line and the words in a cell [mm]."""


@dataclass(frozen=True)
class Grid:
    """A table with a title."""

    title: str
    rows: tuple[tuple[str, ...], ...]
    heads: tuple[str, ...] = ()
    """Names of the columns; none where the first column says what a row is."""


def grid_size(grid: Grid) -> tuple[float, float]:
    """Return width and height of a table [mm].

    Args:
        grid: The table.
    """
    lines = 1 + len(grid.rows) + bool(grid.heads)
    return sum(_columns(grid)), ROW * lines


def _columns(grid: Grid) -> list[float]:
    rows = [*grid.rows, *([grid.heads] if grid.heads else [])]
    widths = [max(words_length(row[k], SMALL) for row in rows) + 2.0 * PAD for k in range(len(rows[0]))]
    short = words_length(grid.title, SMALL) + 2.0 * PAD - sum(widths)
    widths[-1] += max(short, 0.0)
    return widths


def grid_entities(grid: Grid, corner: complex) -> list[Entity]:
    """Return a table.

    Args:
        grid: The table.
        corner: Its upper right corner [mm].
    """
    width, height = grid_size(grid)
    columns = _columns(grid)
    at = corner - width
    box = (at, corner, corner - 1j * height, at - 1j * height)
    entities: list[Entity] = [Path(box, Layer.OUTLINE, closed=True)]
    entities.append(Words(at + complex(PAD, -ROW + PAD), grid.title, SMALL, layer=Layer.TABLE))
    lines = [grid.heads, *grid.rows] if grid.heads else list(grid.rows)
    for k, line in enumerate(lines, start=1):
        top = at - 1j * ROW * k
        entities.append(Path((top, top + width), Layer.OUTLINE if k == 1 else Layer.TABLE))
        for x, words in zip(_starts(columns), line, strict=True):
            entities.append(Words(top + complex(x + PAD, -ROW + PAD), words, SMALL, layer=Layer.TABLE))
    for x in _starts(columns)[1:]:
        entities.append(Path((at + x - 1j * ROW, at + x - 1j * height), Layer.TABLE))
    return entities


def _starts(columns: Sequence[float]) -> list[float]:
    return [sum(columns[:k]) for k in range(len(columns))]


def notes_entities(notes: Sequence[str], corner: complex, width: float) -> list[Entity]:
    """Return notes one below the other, broken to a width.

    Args:
        notes: Each a sentence or two.
        corner: Lower left corner [mm].
        width: Of the column [mm].
    """
    lines = [line for note in notes for line in _broken(note, width)]
    return [Words(corner + 1j * (ROW - 0.7) * (len(lines) - 1 - k), line, SMALL) for k, line in enumerate(lines)]


def notes_height(notes: Sequence[str], width: float) -> float:
    """Return the height of notes [mm].

    Args:
        notes: Each a sentence or two.
        width: Of the column [mm].
    """
    return (ROW - 0.7) * sum(len(_broken(note, width)) for note in notes)


def _broken(note: str, width: float) -> list[str]:
    lines = [""]
    for word in note.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and words_length(longer, SMALL) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines
