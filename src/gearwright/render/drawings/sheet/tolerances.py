"""Geometrical tolerances: frames with what is allowed against which datums (ISO 1101), and datums (ISO 5459)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

from gearwright.render.drawings.sheet.entities import SMALL, Arc, Entity, Layer, Path, Words, words_length

HIGH = 2.0 * SMALL
"""Height of a frame [mm] (ISO 7083: twice the height of its letters)."""
_AIR = 1.0
"""Beside what stands in a cell [mm]."""
_TIP = 1.2
"""Length of the arrowheads of symbols [mm]."""
TRIANGLE = 3.0
"""Height of the triangle of a datum [mm]."""


Characteristic = Literal[
    "run-out", "total run-out", "coaxiality", "position", "perpendicularity", "flatness", "symmetry"
]


class Tolerance(NamedTuple):
    """What a frame says."""

    what: Characteristic
    width: float
    """Of its zone [mm]."""
    datums: str = ""
    """Such as ``A–B``; empty of what needs none."""
    of: str = ""
    """What of teeth or splines is meant, behind the frame: ``PD`` for their pitch circle (ISO 1101)."""

    @property
    def text(self) -> str:
        """The width as the frame has it, to 0.1 µm; with Ø where its zone is a cylinder."""
        round_zone = "Ø" if self.what in ("coaxiality", "position") else ""
        return round_zone + f"{self.width:.4f}".rstrip("0").rstrip(".")


def frame_length(tolerance: Tolerance) -> float:
    """Return the length of a frame [mm].

    Args:
        tolerance: What it says.
    """
    return sum(_widths(tolerance)) + (words_length(tolerance.of, SMALL) + _AIR if tolerance.of else 0.0)


def tolerance_frame(start: complex, tolerance: Tolerance, turn: float = 0.0) -> list[Entity]:
    """Return a frame: symbol, width of the zone, datums.

    Args:
        start: Middle of its side with the symbol [mm].
        tolerance: What it says.
        turn: Direction in which it reads [rad].
    """
    along, widths = cmath.rect(1.0, turn), _widths(tolerance)
    edges = [sum(widths[:k]) for k in range(len(widths) + 1)]
    outline = (complex(0.0, -HIGH / 2.0), complex(edges[-1], -HIGH / 2.0), complex(edges[-1], HIGH / 2.0),
               complex(0.0, HIGH / 2.0))  # fmt: skip
    entities: list[Entity] = [_path(start, along, outline, closed=True)]
    entities += [_path(start, along, (edge - 0.5j * HIGH, edge + 0.5j * HIGH)) for edge in edges[1:-1]]
    entities += _symbol(start + along * widths[0] / 2.0, along, tolerance.what)
    for text, left, width in zip(_texts(tolerance), edges[1:], widths[1:], strict=False):
        at = start + along * complex(left + width / 2.0, -SMALL / 2.0)
        entities.append(Words(at, text, SMALL, "middle", turn, Layer.SYMBOL))
    if tolerance.of:
        at = start + along * complex(edges[-1] + _AIR, -SMALL / 2.0)
        entities.append(Words(at, tolerance.of, SMALL, "left", turn, Layer.SYMBOL))
    return entities


def datum(foot: complex, way: complex, letter: str) -> list[Entity]:
    """Return the mark of a datum; in line with a dimension it means the axis or middle plane of what is dimensioned.

    Args:
        foot: On the outline or an extension line [mm].
        way: From there to the letter, of length 1 [-].
        letter: Its name.
    """
    half, far = TRIANGLE / math.sqrt(3.0), TRIANGLE + 2.0
    corners = (complex(0.0, -half), complex(0.0, half), complex(TRIANGLE, 0.0))
    box = [
        complex(far + x, y) for x, y in ((0.0, -0.5 * HIGH), (HIGH, -0.5 * HIGH), (HIGH, 0.5 * HIGH), (0.0, 0.5 * HIGH))
    ]
    middle = foot + way * (far + HIGH / 2.0)
    return [
        _path(foot, way, corners, closed=True, filled=True),
        _path(foot, way, (complex(TRIANGLE), complex(far))),
        _path(foot, way, box, closed=True),
        Words(middle - 1j * SMALL / 2.0, letter, SMALL, "middle", layer=Layer.SYMBOL),
    ]


def _widths(tolerance: Tolerance) -> list[float]:
    return [HIGH + _AIR, *(words_length(text, SMALL) + 2.0 * _AIR for text in _texts(tolerance))]


def _texts(tolerance: Tolerance) -> tuple[str, ...]:
    return (tolerance.text, tolerance.datums) if tolerance.datums else (tolerance.text,)


def _path(
    start: complex, along: complex, points: Sequence[complex], *, closed: bool = False, filled: bool = False
) -> Path:
    return Path(tuple(start + along * point for point in points), Layer.SYMBOL, closed=closed, filled=filled)


def _symbol(middle: complex, along: complex, what: Characteristic) -> list[Entity]:
    """Return the symbol of a characteristic (ISO 1101, table 1)."""
    if what in ("run-out", "total run-out"):
        return _arrows(middle, along, is_total=what == "total run-out")
    if what == "perpendicularity":
        strokes = ((complex(-1.6, -1.5), complex(1.6, -1.5)), (complex(0.0, -1.5), complex(0.0, 1.6)))
        return [_path(middle, along, stroke) for stroke in strokes]
    if what == "flatness":
        corners = (complex(-2.0, -1.0), complex(0.8, -1.0), complex(2.0, 1.0), complex(-0.8, 1.0))
        return [_path(middle, along, corners, closed=True)]
    if what == "symmetry":
        lines = ((1.0, -0.9), (1.8, 0.0), (1.0, 0.9))
        return [_path(middle, along, (complex(-half, y), complex(half, y))) for half, y in lines]
    small = Arc(middle, 0.8, Layer.SYMBOL)
    if what == "coaxiality":
        return [small, Arc(middle, 1.6, Layer.SYMBOL)]
    cross = ((complex(-1.8, 0.0), complex(1.8, 0.0)), (complex(0.0, -1.8), complex(0.0, 1.8)))
    return [Arc(middle, 1.2, Layer.SYMBOL), *(_path(middle, along, stroke) for stroke in cross)]


def _arrows(middle: complex, along: complex, *, is_total: bool) -> list[Entity]:
    """Return one leaning arrow of circular run-out, or two joined ones of total run-out."""
    lean = complex(1.6, 3.0)
    feet = (complex(-1.8, -1.5), complex(0.2, -1.5)) if is_total else (complex(-0.8, -1.5),)
    entities: list[Entity] = []
    for foot in feet:
        tip, way = foot + lean, lean / abs(lean)
        barbs = (tip, tip - _TIP * way * cmath.rect(1.0, 0.3), tip - _TIP * way * cmath.rect(1.0, -0.3))
        entities += [_path(middle, along, (foot, tip)), _path(middle, along, barbs, closed=True, filled=True)]
    return [*entities, _path(middle, along, feet)] if is_total else entities
