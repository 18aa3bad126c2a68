"""From views, tables and notes to a sheet: the smallest size and the largest scale that hold them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import Entity, moved
from gearwright.render.drawings.sheet.frame import BLOCK_HEIGHT, BLOCK_WIDTH, Title, frame, inside, title_block
from gearwright.render.drawings.sheet.relief import relieved
from gearwright.render.drawings.sheet.sheets import SCALES, SIZES, Sheet, Size
from gearwright.render.drawings.sheet.tables import Grid, grid_entities, grid_size, notes_entities, notes_height

AIR = 8.0
"""Free room around views and tables [mm]."""
FILLED = 0.25
"""Share of an A0 sheet below which a smaller scale is better [-]."""
WISHES = ((1.0, 2), (0.5, 3), (0.2, 4), (0.1, 4), (0.05, 4), (0.0, 4))
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
    projected: bool = False
    """Whether its views stand where projection has them: side by side on one level, in their order."""


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
    size, scale, plan = fit
    entities: list[Entity] = [*frame(size), *title_block(content.title, size, scale)]
    for rows, room in plan.views:
        entities += _placed(rows, room)
    for grid, corner in zip(content.grids, plan.grids, strict=True):
        entities += grid_entities(grid, corner)
    entities += notes_entities(content.notes, *plan.notes)
    return Sheet(content.name, f"{content.title.project}: {content.title.title}", size, scale, tuple(entities))


Room = tuple[float, float, float, float]


class Plan(NamedTuple):
    """Where everything stands on a sheet."""

    views: tuple[tuple[Rows, Room], ...]
    """With the room of each."""
    grids: tuple[complex, ...]
    """Upper right corners."""
    notes: tuple[complex, float]
    """Lower left corner, and width of the lines [mm]."""

    @property
    def share(self) -> float:
        """Area of the views' boxes over that of their rooms [-]."""
        boxes = [_rows_size(rows) for rows, _ in self.views]
        rooms = sum((room[2] - room[0]) * (room[3] - room[1]) for _, room in self.views)
        return sum(width * height for width, height in boxes) / rooms

    @property
    def holds(self) -> bool:
        """Whether all views fit."""
        sizes = [(_rows_size(rows), room) for rows, room in self.views]
        return all(width <= room[2] - room[0] and height <= room[3] - room[1] for (width, height), room in sizes)


def _fits(content: Content) -> Iterator[tuple[Size, float, Plan]]:
    """Yield the sheets that hold the content, the best first."""
    views = cache(content.views)
    for smallest_scale, tried in WISHES:
        for size in SIZES[: len(SIZES) if content.is_whole and smallest_scale < 1.0 else tried]:
            for scale in (one for one in SCALES if smallest_scale <= one <= content.largest_scale):
                plan = next((plan for plan in _plans(content, size, views(scale)) if plan.holds), None)
                if plan is not None and not (size is SIZES[-1] and smallest_scale and plan.share < FILLED):
                    yield size, scale, plan
                    break


def _plans(content: Content, size: Size, rows: Rows) -> Iterator[Plan]:
    """Yield ways in which a content may stand on a sheet."""
    if content.is_whole:
        yield from _whole(content, size, rows)
        return
    left, low, right, high = inside(size)
    column = max((grid_size(grid)[0] for grid in content.grids), default=-AIR)
    tall = sum(grid_size(grid)[1] + AIR / 2.0 for grid in content.grids)
    width = right - left - BLOCK_WIDTH - 2.0 * AIR
    notes = notes_height(content.notes, width) + AIR / 2.0
    if tall > high - low - BLOCK_HEIGHT - AIR:
        return
    room = (left + AIR, low + max(BLOCK_HEIGHT, notes) + AIR, right - column - 2.0 * AIR, high - AIR)
    top, corners = complex(right - AIR / 2.0, high - AIR / 2.0), []
    for grid in content.grids:
        corners.append(top)
        top -= 1j * (grid_size(grid)[1] + AIR / 2.0)
    yield Plan(((rows, room),), tuple(corners), (complex(left + AIR, low + AIR / 2.0), width))


def _whole(content: Content, size: Size, rows: Rows) -> Iterator[Plan]:
    """Yield ways in which a gearbox may stand beside a column of tables on the title block: with notes below the views,
    with notes in the column, with the first of several views over the column, for which the last table may make room.
    """
    left, low, right, high = inside(size)
    wide = max(BLOCK_WIDTH, *(grid_size(grid)[0] + AIR / 2.0 for grid in content.grids))
    top, corners = complex(right - AIR / 2.0, low + BLOCK_HEIGHT + AIR / 2.0), []
    for grid in content.grids:
        top += 1j * grid_size(grid)[1]
        corners.append(top)
        top += 1j * AIR / 2.0
    if top.imag > high:
        return
    foot, beside = complex(left + AIR, low + AIR / 2.0), right - wide - AIR
    under = low + AIR / 2.0 + notes_height(content.notes, beside - foot.real) + AIR
    half = AIR / 2.0
    yield Plan(((rows, (left + half, under, beside, high - half)),), tuple(corners), (foot, beside - foot.real))
    above = top.imag + notes_height(content.notes, wide - AIR)
    if above < high:
        notes = (complex(right - wide + AIR / 2.0, top.imag), wide - AIR)
        yield Plan(((rows, (left + half, low + half, beside, high - half)),), tuple(corners), notes)
    if len(rows) != 1 or len(rows[0]) < 2 or content.projected:
        return
    aside, main = [[rows[0][0]]], [[view] for view in rows[0][1:]]
    far = right - max(wide, _rows_size(aside)[0] + AIR) - AIR
    under = low + AIR / 2.0 + notes_height(content.notes, far - foot.real) + AIR
    rooms = (far + AIR, top.imag - half, right - half, high - half / 2.0), (left + half, under, far, high - half)
    yield Plan(((aside, rooms[0]), (main, rooms[1])), tuple(corners), (foot, far - foot.real))
    # The uppermost table beside the notes.
    moved_wide, moved_tall = grid_size(content.grids[-1])
    beside_it = complex(foot.real + moved_wide + AIR, foot.imag)
    under = foot.imag + max(notes_height(content.notes, far - beside_it.real), moved_tall) + AIR
    rooms = ((far + AIR, top.imag - half - moved_tall, right - half, high - half / 2.0),
             (left + half, under, far, high - half))  # fmt: skip
    corners[-1] = foot + complex(moved_wide, moved_tall)
    yield Plan(((aside, rooms[0]), (main, rooms[1])), tuple(corners), (beside_it, far - beside_it.real))


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
