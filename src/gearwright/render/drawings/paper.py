"""A sheet of paper: sizes, frame and title block, tables; views composed so that no line crosses a text."""

import cmath
import math
from collections.abc import Callable, Iterable, Iterator, Sequence, Set as AbstractSet
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import pairwise
from typing import NamedTuple

from gearwright.base import DesignError, Problem, Shown
from gearwright.render.drawings.entities import (
    ARROW,
    GAP,
    SMALL,
    TEXT,
    Arc,
    Box,
    Distance,
    Entity,
    Hatch,
    Layer,
    Mark,
    Path,
    Words,
    balloon,
    drawn,
    ends,
    extent,
    moved,
    words_corners,
    words_length,
)
from gearwright.render.style import spread
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# A sheet of paper with what is on it, the sizes of ISO 5457 and the scales of ISO 5455.
# ----------------------------------------------------------------------------------------------------------------------


FILING = 20.0
"""Margin on the left [mm] (ISO 5457:1999)."""
MARGIN = 10.0
"""Margin on the other sides [mm] (ISO 5457:1999)."""
SCALES = (50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01)
"""Scales of ISO 5455:1979 [-]: mm of paper per mm."""


@dataclass(frozen=True)
class Size:
    """A trimmed sheet, lying."""

    name: str
    width: float
    """[mm]"""
    height: float
    """[mm]"""
    fields: tuple[int, int]
    """Number of reference fields along the width and the height."""


SIZES = (
    Size("A3", 420.0, 297.0, (8, 6)),
    Size("A2", 594.0, 420.0, (12, 8)),
    Size("A1", 841.0, 594.0, (16, 12)),
    Size("A0", 1189.0, 841.0, (24, 16)),
)
"""Lying sheets of ISO 5457:1999, the smallest first."""


@dataclass(frozen=True, repr=False)
class Sheet(Shown):
    """A drawing sheet."""

    name: str
    """Of its file."""
    title: str
    size: Size
    scale: float
    """[-]: mm of paper per mm."""
    entities: tuple[Entity, ...]
    """In mm of paper, from the lower left corner."""


def scale_text(scale: float) -> str:
    """Return a scale as ISO 5455 writes it.

    Args:
        scale: mm of paper per mm [-].

    >>> scale_text(0.5), scale_text(2.0)
    ('1:2', '2:1')
    """
    return f"{scale:g}:1" if scale >= 1.0 else f"1:{1.0 / scale:g}"


# ----------------------------------------------------------------------------------------------------------------------
# Frame and title block of a sheet: ISO 5457 and ISO 7200.
# ----------------------------------------------------------------------------------------------------------------------


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


class TitleField(NamedTuple):
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
    rows: tuple[tuple[TitleField, ...], ...] = (
        (
            TitleField(36.0, "General tolerances", "ISO 2768-mK", SMALL), TitleField(36.0, "Edges", "ISO 13715", SMALL),
            TitleField(30.0, "Units", "mm", SMALL), TitleField(22.0, "Size", size.name, SMALL),
            TitleField(32.0, "Language", "en", SMALL), TitleField(24.0, "Sheet", f"{number}/{of}", SMALL),
        ),
        (
            TitleField(36.0, "Scale", scale_text(scale), TEXT), TitleField(36.0, "Projection", "", SMALL),
            TitleField(30.0, "Mass [kg]", title.mass, SMALL),
            TitleField(54.0, "Identification number", title.number, SMALL),
            TitleField(24.0, "Revision", "", SMALL),
        ),
        (TitleField(72.0, "Legal owner", "", SMALL), TitleField(108.0, title.project, title.title, 5.0)),
        (
            TitleField(36.0, "Created by", f"gearwright {__version__}", SMALL),
            TitleField(36.0, "Approved by", "", SMALL),
            TitleField(30.0, "Date of issue", "", SMALL), TitleField(38.0, "Material", title.material, SMALL),
            TitleField(40.0, "Document type", title.kind, SMALL),
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


def _row(corner: complex, height: float, cells: Sequence[TitleField]) -> Iterator[Entity]:
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


# ----------------------------------------------------------------------------------------------------------------------
# Tables on a sheet: tooth data, fits, parts; and notes.
# ----------------------------------------------------------------------------------------------------------------------


ROW = 5.0
"""Height of a row [mm]."""
PAD = 1.5
"""Between a line and the words in a cell [mm]."""


@dataclass(frozen=True)
class SheetTable:
    """A table with a title."""

    title: str
    rows: tuple[tuple[str, ...], ...]
    heads: tuple[str, ...] = ()
    """Names of the columns; none where the first column says what a row is."""


def grid_size(grid: SheetTable) -> tuple[float, float]:
    """Return width and height of a table [mm].

    Args:
        grid: The table.
    """
    return sum(_columns(grid)), ROW * (1 + len(grid.rows) + bool(grid.heads))


def _columns(grid: SheetTable) -> list[float]:
    rows = [*grid.rows, *([grid.heads] if grid.heads else [])]
    widths = [max(words_length(row[k], SMALL) for row in rows) + 2.0 * PAD for k in range(len(rows[0]))]
    short = words_length(grid.title, SMALL) + 2.0 * PAD - sum(widths)
    widths[-1] += max(short, 0.0)
    return widths


def grid_entities(grid: SheetTable, corner: complex) -> list[Entity]:
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
    for k, line in enumerate([grid.heads, *grid.rows] if grid.heads else list(grid.rows), start=1):
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


# ----------------------------------------------------------------------------------------------------------------------
# Whether lines run through text: segments of a sheet against the rectangles of its words.
# ----------------------------------------------------------------------------------------------------------------------


Segment = tuple[complex, complex]
ROUND = 48
"""Straight pieces of a circle [-]."""
INKED = 0.8
"""Height of letters over the height of their line with the room of descenders [-]."""
EDGE = 0.02
"""Share of the length of a text at its ends that a line may touch: letters have room around them [-]."""


def segments(marks: Iterable[Entity]) -> Iterator[Segment]:
    """Yield the straight pieces of all lines; sections' hatching has none, it is parted around text.

    Args:
        marks: Of a sheet or a view.
    """
    for mark in drawn(marks):
        yield from _pieces(mark)


def _pieces(mark: Mark) -> Iterator[Segment]:
    match mark:
        case Path():
            yield from pairwise([*mark.points, *(mark.points[:1] if mark.closed else ())])
        case Arc():
            turn = (mark.end - mark.start) / ROUND
            yield from pairwise(
                [mark.centre + cmath.rect(mark.radius, mark.start + k * turn) for k in range(ROUND + 1)]
            )
        case Hatch() | Words():
            return


def texts(marks: Iterable[Entity]) -> list[Words]:
    """Return all text, that of dimensions too.

    Args:
        marks: Of a sheet or a view.
    """
    return [mark for mark in drawn(marks) if isinstance(mark, Words) and mark.text.strip()]


def crossings(words: Words, lines: Iterable[Segment]) -> int:
    """Return how many lines run through a text [-].

    Args:
        words: The text.
        lines: From `segments`.
    """
    corners = list(words_corners(words))
    middle, along = sum(corners) / 4.0, cmath.rect(1.0, words.turn)
    half = complex(words.length * (0.5 - EDGE), INKED * abs(corners[1] - corners[0]) / 2.0)
    near = _beside(lines, corners)
    return sum(_meets((one - middle) / along, (other - middle) / along, half) for one, other in near)


def _beside(lines: Iterable[Segment], corners: Sequence[complex]) -> Iterator[Segment]:
    """Yield the lines whose boxes meet that of some points: no other one can run between them."""
    left, right = min(corner.real for corner in corners), max(corner.real for corner in corners)
    low, high = min(corner.imag for corner in corners), max(corner.imag for corner in corners)
    for line in lines:
        one, other = line
        if not (
            (one.real < left and other.real < left)
            or (one.real > right and other.real > right)
            or (one.imag < low and other.imag < low)
            or (one.imag > high and other.imag > high)
        ):
            yield line


def clear_of(words: Iterable[Words], lines: Sequence[Segment]) -> bool:
    """Tell whether no line runs through any text.

    Args:
        words: All text.
        lines: From `segments`.
    """
    return all(crossings(text, lines) == 0 for text in words)


def _meets(start: complex, end: complex, half: complex) -> bool:
    """Tell whether a line meets a rectangle about the origin (Liang and Barsky 1984)."""
    low, high, way = 0.0, 1.0, end - start
    for at, by, reach in ((start.real, way.real, half.real), (start.imag, way.imag, half.imag)):
        if abs(by) < 1e-12:
            if abs(at) > reach:
                return False
            continue
        first, second = sorted(((-reach - at) / by, (reach - at) / by))
        low, high = max(low, first), min(high, second)
    return low < high


# ----------------------------------------------------------------------------------------------------------------------
# Texts of lengths that lines would run through, put elsewhere along their dimension lines.
# ----------------------------------------------------------------------------------------------------------------------


STEP, TRIES = 3.0, 12
"""Between places that are tried beyond either end [mm], and how many [-]."""


def relieved(view: Sequence[Entity]) -> list[Entity]:
    """Return a view whose lengths have their texts where no line runs through them, as far as there is such a place.

    Args:
        view: Its entities.
    """
    lines = list(segments(view))
    if all(clear_of(texts(drawn([mark])), lines) for mark in view if isinstance(mark, Distance)):
        return list(view)
    found: list[Entity] = []
    for k, mark in enumerate(view):
        crossed = isinstance(mark, Distance) and mark.text_at is None and not clear_of(texts(drawn([mark])), lines)
        found.append(_moved(mark, [*found, *view[k + 1 :]]) if crossed and isinstance(mark, Distance) else mark)
    return found


def _moved(mark: Distance, rest: Sequence[Entity]) -> Distance:
    return next((tried for tried in _elsewhere(mark) if _is_clear(tried, rest)), mark)


def _is_clear(mark: Distance, rest: Sequence[Entity]) -> bool:
    """Tell whether no line runs through the text of a length, and its line through no other text."""
    own = list(segments([mark]))
    return clear_of(texts(drawn([mark])), [*segments(rest), *own]) and clear_of(texts(drawn(rest)), own)


def _elsewhere(mark: Distance) -> Iterator[Distance]:
    """Yield a length with its text beyond either end, the nearest first."""
    along, half = cmath.rect(1.0, mark.angle), words_length(mark.text, TEXT) / 2.0 + ARROW + 2.0
    low, high = sorted(ends(mark), key=lambda end: ((end - mark.line) * along.conjugate()).real)
    for k in range(TRIES):
        for end, way in ((high, 1.0), (low, -1.0)):
            yield replace(mark, text_at=end + way * along * (half + STEP * k) + along * 1j * GAP)


# ----------------------------------------------------------------------------------------------------------------------
# From views, tables and notes to a sheet: the smallest size and the largest scale that hold them.
# ----------------------------------------------------------------------------------------------------------------------


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
    grids: tuple[SheetTable, ...] = ()
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


# ----------------------------------------------------------------------------------------------------------------------
# Item numbers around a view: each on the nearest side from which its leader crosses no text.
# ----------------------------------------------------------------------------------------------------------------------


AROUND = 9.0
"""From the parts to their item numbers [mm]."""
APART = 10.0
"""Between item numbers [mm]."""
SIDES = ("left", "right", "top", "bottom")
"""On which item numbers stand."""


def balloons(anchors: Sequence[complex], box: Box, words: Sequence[Words], first: int = 1) -> Iterator[Entity]:
    """Yield item numbers around the parts, each on the nearest side from which its leader crosses no text.

    Args:
        anchors: Where the numbers point, in their order [mm].
        box: Of the parts [mm].
        words: That leaders must not cross.
        first: Number of the first one.
    """
    barred = [set[str]() for _ in anchors]
    for _ in range(len(SIDES)):
        middles = _around(anchors, box, barred)
        through = [not clear_of(words, [(middle, anchor)])
                   for (_, middle), anchor in zip(middles, anchors, strict=True)]  # fmt: skip
        retried = False
        for (side, _), shut, crosses in zip(middles, barred, through, strict=True):
            if crosses and len(shut) < len(SIDES) - 1:
                shut.add(side)
                retried = True
        if not retried:
            break
    for k, ((_, middle), anchor) in enumerate(zip(middles, anchors, strict=True), start=first):
        yield from balloon(anchor, middle, f"{k}")


def _around(anchors: Sequence[complex], box: Box, barred: Sequence[AbstractSet[str]]) -> list[tuple[str, complex]]:
    """Return side and place of every item number, on the nearest side that is not barred for it [mm]."""
    sides: dict[str, list[tuple[float, int]]] = {side: [] for side in SIDES}
    for k, anchor in enumerate(anchors):
        x, y = anchor.real, anchor.imag
        far = {"left": x - box[0], "right": box[2] - x, "bottom": y - box[1], "top": box[3] - y}
        side = min((side for side in far if side not in barred[k]), key=far.__getitem__)
        sides[side].append((y if side in ("left", "right") else x, k))
    found: dict[int, tuple[str, complex]] = {}
    for side, listed in sides.items():
        ordered = sorted(listed)
        for place, (_, k) in zip(spread([along for along, _ in ordered], APART), ordered, strict=True):
            middle = {
                "left": complex(box[0] - AROUND, place), "right": complex(box[2] + AROUND, place),
                "bottom": complex(place, box[1] - AROUND), "top": complex(place, box[3] + AROUND),
            }[side]  # fmt: skip
            found[k] = (side, middle)
    return [found[k] for k in range(len(anchors))]
