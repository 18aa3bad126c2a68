"""From views, tables and notes to a sheet: the smallest size and the largest scale that hold them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache

from gearwright.errors import DesignError, Problem
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import Entity, moved
from gearwright.render.drawings.sheet.frame import BLOCK_HEIGHT, BLOCK_WIDTH, Title, frame, inside, title_block
from gearwright.render.drawings.sheet.relief import relieved
from gearwright.render.drawings.sheet.sheets import SCALES, SIZES, Sheet, Size
from gearwright.render.drawings.sheet.tables import Grid, grid_entities, grid_size, notes_entities, notes_height

AIR = 8.0
"""Free room around views and tables [mm]."""
WISHES = ((1.0, 2), (0.5, 3), (0.2, 4), (0.0, 4))
"""Scales that are wished for, one after the other [-], each with the number of sheet sizes to try for it."""

View = list[Entity]
Rows = Sequence[Sequence[View]]
"""Views one beside the other, in rows from above; views of a row share their base line y = 0."""


@dataclass(frozen=True)
class Content:
    """What a sheet shows, before its size and scale are known."""

    name: str
    title: Title
    views: Callable[[float], Rows]
    """Scale -> views in mm of paper, each about its own origin."""
    grids: tuple[Grid, ...] = ()
    """In a column at the right, from above."""
    notes: tuple[str, ...] = ()
    largest_scale: float = field(default=2.0)
    """[-]"""
    kind: str = ""
    """What it shows: ``arrangement``, ``shaft`` or ``gear``."""
    is_whole: bool = False
    """Whether it shows a whole gearbox, for which A0 at 1:2 is better than less at 1:5."""


def compose(content: Content) -> Sheet:
    """Return the sheet of a content.

    Args:
        content: What it shows.

    Raises:
        DesignError: If it fits no sheet at any scale.
    """
    fit = next(_fits(content), None)
    if fit is None:
        raise DesignError([Problem(content.name, "this is too large for A0 at 1:100; draw its parts instead")])
    size, scale, rows, room = fit
    left, low, right, high = inside(size)
    entities: list[Entity] = [*frame(size), *title_block(content.title, size, scale)]
    entities += _placed(rows, room)
    top = complex(right - AIR / 2.0, high - AIR / 2.0)
    for grid in content.grids:
        entities += grid_entities(grid, top)
        top -= 1j * (grid_size(grid)[1] + AIR / 2.0)
    width = right - left - BLOCK_WIDTH - 2.0 * AIR
    entities += notes_entities(content.notes, complex(left + AIR, low + AIR / 2.0), width)
    return Sheet(content.name, f"{content.title.project}: {content.title.title}", size, scale, tuple(entities))


Room = tuple[float, float, float, float]


def _fits(content: Content) -> Iterator[tuple[Size, float, Rows, Room]]:
    """Yield the sheets that hold the content, the best first."""
    views = cache(content.views)
    for smallest_scale, tried in WISHES:
        for size in SIZES[: len(SIZES) if content.is_whole and smallest_scale < 1.0 else tried]:
            room = _room(content, size)
            for scale in SCALES:
                if room is not None and smallest_scale <= scale <= content.largest_scale:
                    rows = views(scale)
                    width, height = _rows_size(rows)
                    if width <= room[2] - room[0] and height <= room[3] - room[1]:
                        yield size, scale, rows, room
                        break


def _room(content: Content, size: Size) -> Room | None:
    """Return the room for views on a sheet; None where tables and title block leave none."""
    left, low, right, high = inside(size)
    column = max((grid_size(grid)[0] for grid in content.grids), default=-AIR)
    tall = sum(grid_size(grid)[1] + AIR / 2.0 for grid in content.grids)
    notes = notes_height(content.notes, right - left - BLOCK_WIDTH - 2.0 * AIR) + AIR / 2.0
    if tall > high - low - BLOCK_HEIGHT - AIR:
        return None
    return (
        left + AIR, low + max(BLOCK_HEIGHT, notes) + AIR,
        right - column - 2.0 * AIR, high - AIR,
    )  # fmt: skip


def _rows_size(rows: Rows) -> tuple[float, float]:
    boxes = [[extent(view) for view in row] for row in rows]
    width = max(sum(box[2] - box[0] + 2.0 * AIR for box in row) - 2.0 * AIR for row in boxes)
    height = sum(max(box[3] for box in row) - min(box[1] for box in row) + AIR for row in boxes) - AIR
    return width, height


def _placed(rows: Rows, room: Room) -> Iterator[Entity]:
    """Yield the views in the middle of the room, with equal air between rows."""
    _, height = _rows_size(rows)
    spare = (room[3] - room[1] - height) / (len(rows) + 1)
    top = room[3] - spare
    for row in rows:
        boxes = [extent(view) for view in row]
        above, below = max(box[3] for box in boxes), min(box[1] for box in boxes)
        wide = sum(box[2] - box[0] for box in boxes)
        gap = (room[2] - room[0] - wide) / (len(row) + 1)
        left = room[0] + gap
        for view, box in zip(row, boxes, strict=True):
            yield from moved(relieved(view), complex(left - box[0], top - above))
            left += box[2] - box[0] + gap
        top -= above - below + spare + AIR
