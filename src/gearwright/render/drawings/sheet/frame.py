"""Frame and title block of a sheet: ISO 5457 and ISO 7200."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.render.drawings.sheet.entities import SMALL, TEXT, Arc, Entity, Layer, Path, Words, words_length
from gearwright.render.drawings.sheet.sheets import FILING, MARGIN, Size, scale_text
from gearwright.version import __version__

BLOCK_WIDTH = 180.0
"""Of the title block [mm] (ISO 7200:2004)."""
ROWS = (8.0, 10.0, 14.0, 10.0)
"""Heights of its rows, from below [mm]."""
BLOCK_HEIGHT = sum(ROWS)
LABEL = 1.8
"""Height of the names of its fields [mm]."""
_FIELD = 5.0
"""Width of the strip of reference fields outside the frame [mm]."""
CENTRING = 5.0
"""How far a centring mark reaches into the drawing space [mm]."""
_LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ"
"""Without I and O (ISO 5457)."""


@dataclass(frozen=True)
class Title:
    """What a title block says; what is empty is for people to fill in."""

    project: str
    title: str
    number: str
    """Identification number."""
    kind: str
    """Such as ``Component drawing``."""
    material: str = ""
    mass: str = ""
    sheet: tuple[int, int] = (1, 1)
    """Number of this sheet and of all."""


def frame(size: Size) -> list[Entity]:
    """Return the frame with centring marks and reference fields (ISO 5457:1999).

    Args:
        size: Of the sheet.
    """
    left, low, right, high = inside(size)
    corners = (complex(left, low), complex(right, low), complex(right, high), complex(left, high))
    outer = (
        complex(left - _FIELD, low - _FIELD), complex(right + _FIELD, low - _FIELD),
        complex(right + _FIELD, high + _FIELD), complex(left - _FIELD, high + _FIELD),
    )  # fmt: skip
    entities: list[Entity] = [Path(corners, Layer.FRAME, closed=True), Path(outer, Layer.TABLE, closed=True)]
    across, up = size.fields
    numbers = [str(k + 1) for k in range(across)]
    letters = list(_LETTERS[:up])[::-1]
    entities += _fields(numbers, size.width / 2.0, (left, right), ((low - _FIELD, low), (high, high + _FIELD)), turn=1)
    strips = ((left - _FIELD, left), (right, right + _FIELD))
    entities += _fields(letters, size.height / 2.0, (low, high), strips, turn=1j)
    return entities


def inside(size: Size) -> tuple[float, float, float, float]:
    """Return the drawing space within the frame: left, low, right, high [mm].

    Args:
        size: Of the sheet.
    """
    return FILING, MARGIN, size.width - MARGIN, size.height - MARGIN


def _fields(
    names: list[str],
    centre: float,
    span: tuple[float, float],
    strips: tuple[tuple[float, float], ...],
    *,
    turn: complex,
) -> Iterator[Entity]:
    """Yield the fields of one direction, 50 mm each from the middle; the first and last take the rest."""
    half = len(names) / 2.0
    edges = [span[0], *(centre + 50.0 * (k - half) for k in range(1, len(names))), span[1]]
    for start, end in strips:
        for k, name in enumerate(names):
            if k:
                wide = math.isclose(edges[k], centre)
                reach = CENTRING if wide else 0.0
                inner, outer = (end + reach, start) if start < centre else (end, start - reach)
                points = (_at(edges[k], outer, turn), _at(edges[k], inner, turn))
                yield Path(points, Layer.FRAME if wide else Layer.TABLE)
            middle = _at((edges[k] + edges[k + 1]) / 2.0, (start + end) / 2.0, turn)
            yield Words(middle - 1j * SMALL / 2.0, name, SMALL, "middle", layer=Layer.TABLE)


def _at(along: float, across: float, turn: complex) -> complex:
    return complex(along, across) if turn == 1 else complex(across, along)


class Cell(NamedTuple):
    """A field of the title block."""

    width: float
    """[mm]"""
    name: str
    """Above what it says."""
    value: str
    """What it says; empty: left to the user."""
    size: float
    """Of the letters, where they fit [mm]."""


def title_block(title: Title, size: Size, scale: float) -> list[Entity]:
    """Return the title block in the lower right corner (ISO 7200:2004).

    Args:
        title: What it says.
        size: Of the sheet.
        scale: Of its views [-].
    """
    _, low, right, _ = inside(size)
    corner = complex(right - BLOCK_WIDTH, low)
    number, of = title.sheet
    rows: tuple[tuple[Cell, ...], ...] = (
        (
            Cell(36.0, "General tolerances", "ISO 2768-mK", SMALL), Cell(36.0, "Edges", "ISO 13715", SMALL),
            Cell(30.0, "Units", "mm", SMALL), Cell(22.0, "Size", size.name, SMALL),
            Cell(32.0, "Language", "en", SMALL), Cell(24.0, "Sheet", f"{number}/{of}", SMALL),
        ),
        (
            Cell(36.0, "Scale", scale_text(scale), TEXT), Cell(36.0, "Projection", "", SMALL),
            Cell(30.0, "Mass [kg]", title.mass, SMALL), Cell(54.0, "Identification number", title.number, SMALL),
            Cell(24.0, "Revision", "", SMALL),
        ),
        (Cell(72.0, "Legal owner", "", SMALL), Cell(108.0, title.project, title.title, 5.0)),
        (
            Cell(36.0, "Created by", f"gearwright {__version__}", SMALL), Cell(36.0, "Approved by", "", SMALL),
            Cell(30.0, "Date of issue", "", SMALL), Cell(38.0, "Material", title.material, SMALL),
            Cell(40.0, "Document type", title.kind, SMALL),
        ),
    )  # fmt: skip
    box = (corner, corner + BLOCK_WIDTH, corner + complex(BLOCK_WIDTH, BLOCK_HEIGHT), corner + 1j * BLOCK_HEIGHT)
    entities: list[Entity] = [Path(box, Layer.FRAME, closed=True)]
    at = corner
    for height, cells in zip(ROWS, rows, strict=True):
        entities += _row(at, height, cells)
        at += 1j * height
    entities += first_angle(corner + complex(36.0 + 18.0, ROWS[0] + 4.0))
    return entities


def _row(corner: complex, height: float, cells: Sequence[Cell]) -> Iterator[Entity]:
    yield Path((corner + 1j * height, corner + BLOCK_WIDTH + 1j * height), Layer.TABLE)
    at = corner
    for width, name, value, size in cells:
        if at != corner:
            yield Path((at, at + 1j * height), Layer.TABLE)
        yield Words(at + complex(1.2, height - LABEL - 0.9), name, LABEL, layer=Layer.TABLE)
        fitted = min(size, size * (width - 2.4) / max(words_length(value, size), 1e-9)) if value else size
        if value:
            yield Words(at + complex(1.2, 0.35 * size + 0.5), value, fitted, layer=Layer.TABLE)
        at += width


def first_angle(middle: complex) -> list[Entity]:
    """Return the mark of first-angle projection (ISO 5456-2:1996): a cone from the side, and from its small end.

    Args:
        middle: Of the mark [mm].
    """
    small, large, length = 1.5, 3.0, 6.0
    side, round_view = middle - 6.5, middle + 6.0
    edge = (
        side + complex(-length / 2, -small), side + complex(length / 2, -large),
        side + complex(length / 2, large), side + complex(-length / 2, small),
    )  # fmt: skip
    return [
        Path(edge, Layer.TABLE, closed=True),
        Arc(round_view, small, Layer.TABLE),
        Arc(round_view, large, Layer.TABLE),
        Path((side - length / 2 - 1.5, side + length / 2 + 1.5), Layer.CENTRE),
        Path((round_view - large - 1.5, round_view + large + 1.5), Layer.CENTRE),
        Path((round_view - 1j * (large + 1.5), round_view + 1j * (large + 1.5)), Layer.CENTRE),
    ]
