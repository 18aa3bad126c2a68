"""What stands above a shaft: diameters, threads and splines by name, textures, and frames of geometrical tolerances."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.catalogue import LARGEST, SMALLEST, standard_tolerance
from gearwright.parts.gears import runout_tolerance
from gearwright.render.drawings.sheet.entities import Entity
from gearwright.render.drawings.sheet.tolerances import Tolerance
from gearwright.render.drawings.views.marks import ACROSS, AT_FACE, Mark, marked
from gearwright.render.drawings.views.shaft_parts import MM, Piece, ShaftBody, thread_name
from gearwright.render.drawings.views.shaft_view import Axis
from gearwright.render.drawings.views.shafts.lengths import NEAR, rests
from gearwright.render.style.labels import spread
from gearwright.shape.teeth import cylindrical_gear, gear_of, kind_of, making_of
from gearwright.sizing import Sizing

DATUMS = ("A", "B")
"""Seats of the two radial bearings."""
AXIS = "–".join(DATUMS)
"""The axis of both."""
RUNOUT_GRADE = 5
"""Of seats, of which half is their total run-out, and of the axial run-out of their shoulders (`RUNOUT_SOURCE`)."""
RUNOUT_SOURCE = "SKF, geometrical tolerances of seats and abutments for bearings of normal class"
"""Where `RUNOUT_GRADE` comes from: total radial run-out IT5/2, total axial run-out IT5."""
SPLINE_GRADE = 7
"""Of the run-out of splines at their reference diameter; assumed."""
SEAT_TEXTURE = "Ra 0.8"
"""Of bearing seats; assumed (usual for IT6 and normal bearings)."""
GROOVE_CLASSES = ((10.0, " h10"), (22.0, " h11"), (100.0, " h12"))
"""Shafts up to this [mm] have grooves of rings of this tolerance class: DIN 471, the last of them from memory."""


def surfaces(sizing: Sizing, axis: Axis, body: ShaftBody, seats: Sequence[Piece]) -> Iterator[Entity]:
    """Yield every diameter and what its surface may run out, written above the shaft.

    Args:
        sizing: What was sized.
        axis: Of the shaft.
        body: The shaft.
        seats: Of its radial bearings; none where there is no axis to run true to.
    """
    marks = list(_marks(body))
    if seats:
        marks += [*_seats(body), *_shoulders(axis, body), *_toothings(sizing, body)]
    marks.sort(key=lambda mark: mark.x)
    top = axis.scale * max(piece.diameter for piece in body.pieces) / 2.0
    places = spread([axis.scale * mark.x for mark in marks], ACROSS)
    for mark, slot in zip(marks, places, strict=True):
        yield from marked(axis, mark, slot, top)


def middle_of(body: ShaftBody, piece: Piece) -> float:
    """Return where the diameter of a piece is dimensioned, beside keyways and splines [mm].

    Args:
        body: The shaft.
        piece: Of it.
    """
    for toothing in body.splines:
        low, high = max(toothing.start, piece.start), min(toothing.end, piece.end)
        if low < high:  # in the middle of what is longer beside them
            before = low - piece.start > piece.end - high
            return (piece.start + low) / 2.0 if before else (high + piece.end) / 2.0
    share = 0.25 if any(slot.start < piece.end and slot.end > piece.start for slot in body.slots) else 0.5
    return piece.start + share * (piece.end - piece.start)


def _marks(body: ShaftBody) -> Iterator[Mark]:
    for before, piece, after in zip((None, *body.pieces), body.pieces, (*body.pieces[1:], None), strict=False):
        neighbours = [neighbour for neighbour in (before, after) if neighbour is not None]
        beside = [neighbour.diameter for neighbour in neighbours if neighbour.tolerance]
        if not piece.fit and piece.diameter in beside and (piece.thread is None or piece.relieved):
            continue
        x = middle_of(body, piece)
        if any(toothing.start - NEAR <= x <= toothing.end + NEAR for toothing in body.splines):
            continue
        if piece.thread is not None:
            if not piece.relieved:
                yield Mark(x, piece.diameter / 2.0, "", thread_name(piece.thread))
            elif piece.thread.undercut is not None:
                yield Mark(x, piece.diameter / 2.0, "", piece.thread.undercut.designation)
            continue
        if piece.conical:
            x = piece.start if piece.diameters[0] > piece.diameters[1] else piece.end
        suffix = f" {piece.fit}" if piece.fit else ""
        if piece.is_groove:
            shaft = max(neighbour.diameter for neighbour in neighbours)
            suffix = next((text for up_to, text in GROOVE_CLASSES if shaft <= up_to), "")
        yield Mark(x, piece.diameter / 2.0, suffix, texture=SEAT_TEXTURE if piece.fit else "")
    for toothing in body.splines:
        x = toothing.start + 0.75 * (toothing.end - toothing.start)
        yield Mark(x, MM * toothing.teeth.shaft_tip / 2.0, "", toothing.designation)
    for cut in body.undercuts:
        yield Mark(MM * (cut.place + cut.edge) / 2.0, MM * cut.bottom / 2.0, "", cut.standard.designation)


def _seats(body: ShaftBody) -> Iterator[Mark]:
    """Yield the total run-out of every bearing seat, on its side away from its shoulder."""
    shouldered = {face.seat: face.away for face in rests(body)}
    for piece in body.pieces:
        if piece.tolerance:
            runout = MM * standard_tolerance(piece.diameter / MM, RUNOUT_GRADE) / 2.0
            share = 0.2 if shouldered.get(piece, 1.0) < 0.0 else 0.8
            x = piece.start + share * (piece.end - piece.start)
            yield Mark(x, piece.diameter / 2.0, "", tolerance=Tolerance("total run-out", runout, AXIS))


def _shoulders(axis: Axis, body: ShaftBody) -> Iterator[Mark]:
    """Yield the axial run-out of the faces that bearings lean on."""
    for face in rests(body):
        runout = MM * standard_tolerance(face.seat.diameter / MM, RUNOUT_GRADE)
        radius = (face.seat.diameter / 2.0 + face.thick) / 2.0
        x = face.x + face.away * AT_FACE / axis.scale
        yield Mark(x, radius, "", tolerance=Tolerance("total run-out", runout, AXIS), face=face.away)


def _toothings(sizing: Sizing, body: ShaftBody) -> Iterator[Mark]:
    """Yield the run-out of cylindrical teeth by their class, and of splines."""
    for piece in body.pieces:
        if piece.toothed and kind_of(sizing, gear_of(sizing, piece.seat).stage) == "cylindrical":
            gear = gear_of(sizing, piece.seat)
            grade = making_of(sizing, gear.stage).iso_class
            if grade is not None:
                teeth = cylindrical_gear(sizing, gear)
                runout = MM * runout_tolerance(2.0 * teeth.pitch_radius, teeth.module, grade)
                tolerance = Tolerance("run-out", round(runout, 3), AXIS, "PD")
                x = piece.start + 0.8 * (piece.end - piece.start)
                yield Mark(x, piece.diameter / 2.0, "", tolerance=tolerance)
    for toothing in body.splines:
        size = toothing.teeth.reference_diameter
        if SMALLEST < size <= LARGEST:
            tolerance = Tolerance("run-out", MM * standard_tolerance(size, SPLINE_GRADE), AXIS, "PD")
            x = toothing.start + 0.25 * (toothing.end - toothing.start)
            yield Mark(x, MM * toothing.teeth.shaft_tip / 2.0, "", tolerance=tolerance)
