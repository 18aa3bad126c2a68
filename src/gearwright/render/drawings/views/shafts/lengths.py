"""Lengths of a shaft: functional ones between the faces that parts lean on, all others from the first end.

Their tolerances are a rule, assumed: between the shoulders of both radial bearings ± IT9/2, which sets the room for
their play; from the shoulder that a stack of bearings leans on to the loaded side of its ring's groove H11, so that
the ring always goes in; to faces of teeth ± IT10/2. Grooves are H13 wide (DIN 471).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gearwright.catalogue import LARGEST, SMALLEST, standard_tolerance
from gearwright.render.drawings.sheet.entities import Distance, Entity, trimmed
from gearwright.render.drawings.views.shaft_parts import MM, Piece, ShaftBody
from gearwright.render.drawings.views.shaft_view import Axis, end_chamfer

LEVEL = 8.0
"""Between parallel dimension lines [mm]."""
BETWEEN_SHOULDERS, TO_TEETH = 9, 10
"""Grades of ISO 286-1 of functional lengths; assumed."""
TO_GROOVE, GROOVE_WIDTH = "H11", "H13"
"""Classes of the length to the loaded side of a ring's groove, assumed, and of its width (DIN 471)."""
NEAR = 1e-6
"""Places that are nearer to each other are one [mm]."""


class Span(NamedTuple):
    """A length between two places of a shaft."""

    start: float
    """[mm]"""
    end: float
    """[mm]"""
    radii: tuple[float, float]
    """Of the outline there [mm]."""
    suffix: str = ""
    """Its tolerance."""


class Face(NamedTuple):
    """A face on which the inner ring of a bearing leans."""

    x: float
    """[mm]"""
    away: float
    """−1 where the seat lies before it, +1 where it lies behind."""
    seat: Piece
    thick: float
    """Radius of the thicker piece [mm]."""


def rests(body: ShaftBody) -> tuple[Face, ...]:
    """Return the faces that bearings lean on: where a seat meets a thicker piece.

    Args:
        body: The shaft.
    """
    found = []
    for left, right in zip(body.pieces, body.pieces[1:], strict=False):
        thin, thick, away = (left, right, -1.0) if left.diameters[1] < right.diameters[0] else (right, left, 1.0)
        beside = thick.diameters[0] if away < 0.0 else thick.diameters[1]
        if thin.tolerance and beside > thin.diameter + NEAR:
            found.append(Face(right.start, away, thin, beside / 2.0))
    return tuple(found)


def lengths(axis: Axis, body: ShaftBody, seats: Sequence[Piece], *, below: float) -> Iterator[Entity]:
    """Yield the lengths of a shaft, the functional ones nearest to it.

    Args:
        axis: Of the shaft.
        body: The shaft.
        seats: Of its radial bearings.
        below: By which all stand lower, for what is marked below the shaft [mm of paper].
    """
    level = axis.origin - 1j * (axis.scale * max(piece.diameter for piece in body.pieces) / 2.0 + 9.0 + below)
    stacks = list(_to_grooves(body))
    short = [*_cut_spans(body), *(span for _, span in stacks)]
    between = list(_between(body, seats))
    for row in (short, [span for span, _ in stacks], between):
        for span in row:
            yield _distance(axis, span, level)
        level -= 1j * LEVEL if row else 0.0
    known = {round(span.end, 6) for span in between}
    known |= {round(x, 6) for _, span in stacks for x in (span.start, span.end)}
    for span in _from_first_end(body):
        if round(span.end, 6) not in known:
            yield _distance(axis, span, level)
            level -= 1j * LEVEL


def _distance(axis: Axis, span: Span, level: complex) -> Distance:
    start, end = (axis.at(x, -radius) for x, radius in zip((span.start, span.end), span.radii, strict=True))
    return Distance(start, end, level, 0.0, axis.scale, suffix=span.suffix)


def _cut_spans(body: ShaftBody) -> Iterator[Span]:
    """Yield the lengths of keyways and splines."""
    for slot in body.slots:
        yield Span(slot.start, slot.end, (slot.diameter / 2.0,) * 2)
    for spline in body.splines:
        yield Span(spline.start, spline.end, (MM * spline.teeth.shaft_tip / 2.0,) * 2)


def _to_grooves(body: ShaftBody) -> Iterator[tuple[Span, Span]]:
    """Yield of every ring's groove beyond a shoulder the length from there to its loaded side, and its own width."""
    for groove in (piece for piece in body.pieces if piece.is_groove):
        faces = [face for face in rests(body) if abs(face.seat.diameter - _beside(body, groove)) < NEAR]
        inwards = [face for face in faces if face.away * (groove.start - face.x) > -NEAR]
        if inwards:
            face = min(inwards, key=lambda face: abs(groove.start - face.x))
            loaded = groove.end if face.away > 0.0 else groove.start
            edge = _beside(body, groove) / 2.0
            ends = ((face.x, face.seat.diameter / 2.0), (loaded, edge))
            (low, first), (high, last) = sorted(ends)
            width = Span(groove.start, groove.end, (edge, edge), f" {GROOVE_WIDTH}")
            yield Span(low, high, (first, last), f" {TO_GROOVE}"), width


def _beside(body: ShaftBody, groove: Piece) -> float:
    """Return the diameter beside a groove [mm]."""
    k = body.pieces.index(groove)
    return max(piece.diameter for piece in (*body.pieces[k - 1 : k], *body.pieces[k + 1 : k + 2]))


def _between(body: ShaftBody, seats: Sequence[Piece]) -> Iterator[Span]:
    """Yield the length between the shoulders that both radial bearings lean on."""
    faces = [face for seat in seats for face in rests(body) if face.seat == seat]
    if len(faces) == 2 and faces[0].seat != faces[1].seat:
        first, last = sorted(faces)
        half = _grade(last.x - first.x, BETWEEN_SHOULDERS) / 2.0
        radii = (first.seat.diameter / 2.0, last.seat.diameter / 2.0)
        yield Span(first.x, last.x, radii, f" ±{trimmed(half, 3)}" if half else "")


def _from_first_end(body: ShaftBody) -> Iterator[Span]:
    """Yield lengths to shoulders, starts of keyways and splines and the second end, those to teeth with a tolerance."""
    first, last = body.pieces[0], body.pieces[-1]
    ends = [(piece.end, max(piece.diameters[1], after.diameters[0]) / 2.0, piece.toothed or after.toothed)
            for piece, after in zip(body.pieces, body.pieces[1:], strict=False)
            if not _is_even(piece, after)]  # fmt: skip
    ends.append((last.end, last.diameters[1] / 2.0 - end_chamfer(last), False))
    ends += [(slot.start, slot.diameter / 2.0, False) for slot in body.slots if slot.start > NEAR]
    ends += [(spline.start, MM * spline.teeth.shaft_tip / 2.0, False) for spline in body.splines]
    seen: list[float] = []
    datum = first.diameters[0] / 2.0 - end_chamfer(first)
    for x, radius, at_teeth in sorted(ends):
        if x > first.start + NEAR and all(abs(x - earlier) > NEAR for earlier in seen):
            seen.append(x)
            half = _grade(x - first.start, TO_TEETH) / 2.0 if at_teeth else 0.0
            yield Span(first.start, x, (datum, radius), f" ±{trimmed(half, 3)}" if half else "")


def _is_even(piece: Piece, after: Piece) -> bool:
    """Tell whether only the surface under a seal ends between two pieces: a note has its length."""
    level = abs(piece.diameters[1] - after.diameters[0]) < NEAR
    return level and any(one.sealed and not other.fit for one, other in ((piece, after), (after, piece)))


def _grade(length: float, grade: int) -> float:
    """Return a standard tolerance of a length [mm]; 0 where ISO 286-1 has none."""
    size = length / MM
    return MM * standard_tolerance(size, grade) if SMALLEST < size <= LARGEST else 0.0
