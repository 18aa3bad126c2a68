"""The sheet of one shaft: outline with lengths, fits and surfaces, keyways, splines, threads."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from gearwright.catalogue import (
    LARGEST,
    SEAT_SOURCE,
    SMALLEST,
    centre_hole,
    keyway_tolerance,
    shaft_limits,
    standard_tolerance,
    thread_chamfer,
    thread_run_out,
)
from gearwright.catalogue.standard_parts import FAST, FAST_HARDNESS, HARDNESS, ROUGHNESS, SHAFT as UNDER_SEAL
from gearwright.parts.gears import runout_tolerance
from gearwright.render.drawings.entities import (
    GAP,
    HIGH,
    TEXT,
    TRIANGLE,
    Distance,
    Entity,
    GeometricTolerance,
    Layer,
    Path,
    Words,
    cutting_plane,
    datum,
    extent,
    frame_length,
    millimetres,
    section_letters,
    tolerance_frame,
    trimmed,
    words_length,
)
from gearwright.render.drawings.gear_sheet import CASE, case_words, hard_line, tooth_grid
from gearwright.render.drawings.paper import Content, Rows, SheetTable, Title
from gearwright.render.drawings.shaft_view import (
    ACROSS,
    AT_FACE,
    MM,
    Callout,
    Keyway,
    Piece,
    ShaftBody,
    SheetAxis,
    Toothing,
    end_chamfer,
    key_section,
    marked,
    mass_with_gears,
    relief_detail,
    shaft_body,
    shaft_outline,
    thread_name,
    undercut_detail,
)
from gearwright.render.style import spread
from gearwright.shape.stands import cylindrical_gear, gear_of, kind_of, making_of
from gearwright.sizing import Sizing
from gearwright.sizing.shafts import (
    ENDS,
    Groove,
    Retention,
    Thread,
    case_hardened,
    ends,
    grooves,
    held_rings,
    sealed_exits,
)

# ----------------------------------------------------------------------------------------------------------------------
# Where a shaft is case-hardened: lines beside its outline with numbers (ISO 15787), and the table of what is asked.
# ----------------------------------------------------------------------------------------------------------------------


UNDER_LIP = (0.3, 0.6)
"""Depth of the case under the lip of a seal, at least (makers' sheets) and at most (assumed) [mm]."""


class Zone(NamedTuple):
    """A surface of a shaft that is hardened."""

    piece: Piece
    what: str
    """Such as ``teeth of helical.pinion``."""
    hardness: float
    """At least [HV]."""
    depth: tuple[float, float]
    """At least and at most [mm]."""

    @property
    def words(self) -> str:
        """Hardness and depth of the case as drawings write them."""
        return case_words(self.hardness, self.depth)


def zones(sizing: Sizing, body: ShaftBody) -> tuple[Zone, ...]:
    """Return the teeth of one piece with a shaft that are case-hardened, and with them what runs under lips of seals.

    Args:
        sizing: What was sized.
        body: The shaft.
    """
    found, steels = [], case_hardened(sizing, body.name)
    for piece in body.pieces:
        if piece.toothed and piece.seat in steels:
            gear = gear_of(sizing, piece.seat)
            low, high = (MM * share * gear.module for share in CASE)
            found.append(Zone(piece, f"teeth of {gear.name}", steels[gear.name].hardness, (low, high)))
    if found:
        hardness = min(zone.hardness for zone in found)
        found += [Zone(piece, f"under the seal towards {piece.sealed}", hardness, UNDER_LIP)
                  for piece in body.pieces if piece.sealed]  # fmt: skip
    return tuple(found)


def zone_lines(axis: SheetAxis, hard: tuple[Zone, ...]) -> Iterator[Entity]:
    """Yield the lines below the outline along which a shaft is hardened, with their numbers.

    Args:
        axis: Of the shaft.
        hard: From `zones`.
    """
    for number, zone in enumerate(hard, start=1):
        piece = zone.piece
        ends = [
            axis.at(x, -diameter / 2.0) for x, diameter in zip((piece.start, piece.end), piece.diameters, strict=True)
        ]
        along = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        yield from hard_line((ends[0], ends[1]), -1j * along, number)


def zone_grid(hard: tuple[Zone, ...]) -> Iterator[SheetTable]:
    """Yield the table of hardened surfaces; none where none is.

    Args:
        hard: From `zones`.
    """
    if hard:
        rows = [(f"{number}", zone.what, zone.words) for number, zone in enumerate(hard, start=1)]
        rows.append(("", "all else", "soft: kept from carburizing (assumed)"))
        yield SheetTable("Case-hardened and tempered (ISO 15787)", tuple(rows))


# ----------------------------------------------------------------------------------------------------------------------
# Lengths of a shaft: functional ones between the faces that parts lean on, all others from the first end.
#
# Their tolerances are a rule, assumed: between the shoulders of both radial bearings ± IT9/2, which sets the room for
# their play; from the shoulder that a stack of bearings leans on to the loaded side of its ring's groove H11, so that
# the ring always goes in; to faces of teeth ± IT10/2. Grooves are H13 wide (DIN 471).
# ----------------------------------------------------------------------------------------------------------------------


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


def lengths(axis: SheetAxis, body: ShaftBody, seats: Sequence[Piece], *, below: float) -> Iterator[Entity]:
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


def _distance(axis: SheetAxis, span: Span, level: complex) -> Distance:
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


# ----------------------------------------------------------------------------------------------------------------------
# What stands above a shaft: diameters, threads and splines by name, textures, and frames of geometrical tolerances.
# ----------------------------------------------------------------------------------------------------------------------


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


def surfaces(sizing: Sizing, axis: SheetAxis, body: ShaftBody, seats: Sequence[Piece]) -> Iterator[Entity]:
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


def _marks(body: ShaftBody) -> Iterator[Callout]:
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
                yield Callout(x, piece.diameter / 2.0, "", thread_name(piece.thread))
            elif piece.thread.undercut is not None:
                yield Callout(x, piece.diameter / 2.0, "", piece.thread.undercut.designation)
            continue
        if piece.conical:
            x = piece.start if piece.diameters[0] > piece.diameters[1] else piece.end
        suffix = f" {piece.fit}" if piece.fit else ""
        if piece.is_groove:
            shaft = max(neighbour.diameter for neighbour in neighbours)
            suffix = next((text for up_to, text in GROOVE_CLASSES if shaft <= up_to), "")
        yield Callout(x, piece.diameter / 2.0, suffix, texture=SEAT_TEXTURE if piece.fit else "")
    for toothing in body.splines:
        x = toothing.start + 0.75 * (toothing.end - toothing.start)
        yield Callout(x, MM * toothing.teeth.shaft_tip / 2.0, "", toothing.designation)
    for cut in body.undercuts:
        yield Callout(MM * (cut.place + cut.edge) / 2.0, MM * cut.bottom / 2.0, "", cut.standard.designation)


def _seats(body: ShaftBody) -> Iterator[Callout]:
    """Yield the total run-out of every bearing seat, on its side away from its shoulder."""
    shouldered = {face.seat: face.away for face in rests(body)}
    for piece in body.pieces:
        if piece.tolerance:
            runout = MM * standard_tolerance(piece.diameter / MM, RUNOUT_GRADE) / 2.0
            share = 0.2 if shouldered.get(piece, 1.0) < 0.0 else 0.8
            x = piece.start + share * (piece.end - piece.start)
            yield Callout(x, piece.diameter / 2.0, "", tolerance=GeometricTolerance("total run-out", runout, AXIS))


def _shoulders(axis: SheetAxis, body: ShaftBody) -> Iterator[Callout]:
    """Yield the axial run-out of the faces that bearings lean on."""
    for face in rests(body):
        runout = MM * standard_tolerance(face.seat.diameter / MM, RUNOUT_GRADE)
        radius = (face.seat.diameter / 2.0 + face.thick) / 2.0
        x = face.x + face.away * AT_FACE / axis.scale
        yield Callout(x, radius, "", tolerance=GeometricTolerance("total run-out", runout, AXIS), face=face.away)


def _toothings(sizing: Sizing, body: ShaftBody) -> Iterator[Callout]:
    """Yield the run-out of cylindrical teeth by their class, and of splines."""
    for piece in body.pieces:
        if piece.toothed and kind_of(sizing, gear_of(sizing, piece.seat).stage) == "cylindrical":
            gear = gear_of(sizing, piece.seat)
            grade = making_of(sizing, gear.stage).iso_class
            if grade is not None:
                teeth = cylindrical_gear(sizing, gear)
                runout = MM * runout_tolerance(2.0 * teeth.pitch_radius, teeth.module, grade)
                tolerance = GeometricTolerance("run-out", round(runout, 3), AXIS, "PD")
                x = piece.start + 0.8 * (piece.end - piece.start)
                yield Callout(x, piece.diameter / 2.0, "", tolerance=tolerance)
    for toothing in body.splines:
        size = toothing.teeth.reference_diameter
        if SMALLEST < size <= LARGEST:
            tolerance = GeometricTolerance("run-out", MM * standard_tolerance(size, SPLINE_GRADE), AXIS, "PD")
            x = toothing.start + 0.25 * (toothing.end - toothing.start)
            yield Callout(x, MM * toothing.teeth.shaft_tip / 2.0, "", tolerance=tolerance)


# ----------------------------------------------------------------------------------------------------------------------
# Keyways on the sheet of a shaft: the removed section with width, depth and how symmetric it stands.
# ----------------------------------------------------------------------------------------------------------------------


SYMMETRY_GRADE = 9
"""Of the width of a keyway, of which half is how symmetric it stands; assumed: P9 has this grade."""
LEAST_WIDTH = 10e-3
"""Up to which widths have the tolerance of this one, as the grades begin above 6 mm [m]."""
AIR = 3.0
"""Between what stands in line with the width [mm of paper]."""


def keyway_section(slot: Keyway, bore: float, letter: str, scale: float, *, datums: str) -> list[Entity]:
    """Return the section of a shaft through a keyway with its dimensions.

    Args:
        slot: The keyway.
        bore: Of the shaft [mm].
        letter: Of the cutting plane.
        scale: Of the view [-].
        datums: Axis to which it is symmetric; empty where the sheet has none.
    """
    axis = SheetAxis(0j, 1 + 0j, scale)
    entities = key_section(axis, slot, bore)
    radius, half = slot.diameter / 2.0, MM * slot.section.width / 2.0
    floor = radius - MM * slot.section.shaft_depth
    rim = math.sqrt(radius**2 - half**2)
    above = 1j * (scale * radius + 7.0)
    width = Distance(axis.at(-half, rim), axis.at(half, rim), above, 0.0, scale, suffix=" P9")
    entities.append(width)
    beyond = max(extent([width])[2], scale * half) + AIR
    if datums:
        # In line with the dimension of the width: its middle plane is what stands symmetric.
        zone = MM * standard_tolerance(max(slot.section.width, LEAST_WIDTH), SYMMETRY_GRADE) / 2.0
        tolerance, start = GeometricTolerance("symmetry", zone, datums), above + beyond
        entities += [Path((above + scale * half, start), Layer.SYMBOL), *tolerance_frame(start, tolerance)]
        beyond += frame_length(tolerance) + AIR
    low, high = axis.at(0.0, -radius), axis.at(half, floor)
    deviation = f" 0/−{trimmed(MM * keyway_tolerance(slot.section), 1)}"
    depth = Distance(low, high, complex(scale * radius + 9.0), math.pi / 2.0, scale, suffix=deviation)
    if words_length(depth.text, TEXT) > scale * depth.measured:  # its text stands above its line, beside all of this
        depth = replace(depth, line=complex(max(scale * radius + 9.0, beyond + TEXT + GAP)))
    entities.append(depth)
    top = extent(entities)[3]
    entities.append(Words(1j * (top + 3.0), f"{letter}–{letter}", TEXT, "middle"))
    entities.append(Words(-1j * (scale * radius + 9.0), slot.designation, TEXT, "middle"))
    return entities


# ----------------------------------------------------------------------------------------------------------------------
# Splines on the sheet of a shaft: the tables of their data, and whether a hob has room to run out behind them.
# ----------------------------------------------------------------------------------------------------------------------


HOB = 60.0
"""Diameter of a hob for splines; assumed [mm]."""


def spline_grids(body: ShaftBody) -> Iterator[SheetTable]:
    """Yield the data of every spline.

    Args:
        body: The shaft.
    """
    for toothing in body.splines:
        teeth = toothing.teeth
        rows = (
            ("Number of teeth", "z", f"{teeth.teeth}"),
            ("Module", "m", millimetres(MM * teeth.module)),
            ("Pressure angle", "α", "30°"),
            ("Profile shift coefficient", "x", f"{teeth.profile_shift:.3g}"),
            ("Reference diameter", "d_{B}", millimetres(MM * teeth.reference_diameter)),
            ("Pitch diameter", "d", millimetres(MM * teeth.pitch_diameter)),
            ("Tip diameter", "d_{a1}", millimetres(MM * teeth.shaft_tip)),
            ("Root diameter, hobbed", "d_{f1}", millimetres(MM * teeth.shaft_root)),
        )
        yield SheetTable(f"Spline: {toothing.designation}", rows)


def run_out_notes(body: ShaftBody) -> Iterator[str]:
    """Yield of every spline that a hob cannot leave before the next shoulder that it must be shaped.

    Args:
        body: The shaft.
    """
    for toothing in body.splines:
        room, needed = hob_room(body, toothing), hob_run_out(toothing)
        if room < needed:
            yield (
                f"{toothing.designation}: shaped, as {millimetres(room)} mm lie before the next shoulder; a hob of"
                f" Ø{HOB:g} (assumed) runs out over {needed:.1f} mm."
            )


def hob_run_out(toothing: Toothing) -> float:
    """Return over which length a hob leaves teeth that it cuts to their full depth [mm]: √(h (D − h)).

    Args:
        toothing: Splines of a shaft.
    """
    depth = MM * (toothing.teeth.shaft_tip - toothing.teeth.shaft_root) / 2.0
    return math.sqrt(depth * (HOB - depth))


def hob_room(body: ShaftBody, toothing: Toothing) -> float:
    """Return how far it is from either end of a spline to what is thicker than it, the less of both [mm].

    Args:
        body: The shaft.
        toothing: On it.
    """
    tip = MM * toothing.teeth.reference_diameter
    thick = [piece for piece in body.pieces if piece.diameter > tip + 1e-6]
    behind = (piece.start - toothing.end for piece in thick if piece.start > toothing.end - 1e-6)
    before = (toothing.start - piece.end for piece in thick if piece.end < toothing.start + 1e-6)
    return min((*behind, *before), default=math.inf)


# ----------------------------------------------------------------------------------------------------------------------
# Threads of lock nuts on a shaft: their lines on the outline (ISO 6410-1) and the table of their data.
# ----------------------------------------------------------------------------------------------------------------------


def thread_lines(axis: SheetAxis, thread: Thread) -> Iterator[Entity]:
    """Yield the core of a thread as thin lines, and where its full turns end; turns that run out lean.

    Args:
        axis: Of the shaft.
        thread: On it.
    """
    radius, core = MM * thread.nut.thread / 2.0, MM * thread.nut.core / 2.0
    foot, first, last = MM * thread.foot, MM * thread.first, MM * thread.last
    for side in (1.0, -1.0):
        yield Path((axis.at(first, side * core), axis.at(last, side * core)), Layer.THIN)
        if thread.undercut is None:
            yield Path((axis.at(foot, side * radius), axis.at(first, side * core)), Layer.THIN)
    if thread.undercut is None:
        yield Path((axis.at(first, -radius), axis.at(first, radius)), Layer.OUTLINE)


def thread_grid(thread: Thread) -> SheetTable:
    """Return the data of a thread.

    Args:
        thread: On a shaft.
    """
    nut, (low, high) = thread.nut, thread.turns
    rows = [
        ("Nominal diameter", "d", millimetres(MM * nut.thread)),
        ("Pitch", "P", millimetres(MM * nut.pitch)),
        ("Minor diameter", "d_{3}", f"{MM * nut.core:.3f}"),
        ("Full turns", "", millimetres(MM * (high - low))),
    ]
    if thread.undercut is None:
        rows.append(("Run-out, at most 2.5 P", "x_{1}", millimetres(MM * thread_run_out(nut.pitch))))
    else:
        cut = thread.undercut
        rows += [
            (f"Undercut {cut.designation}", "d_{g}", millimetres(MM * thread.bottom)),
            ("its width, flanks of 30°", "g_{2}", millimetres(MM * cut.width)),
            ("its radius", "r", millimetres(MM * cut.radius)),
        ]
    rows.append(("Chamfer at its start", "", f"{millimetres(MM * thread_chamfer(nut.pitch))} × 45°"))
    return SheetTable(f"Thread: {thread_name(thread)}", tuple(rows))


# ----------------------------------------------------------------------------------------------------------------------
# The sheet of one shaft: outline with dimensions, sections through keyways, fits, tooth data of integral gears.
# ----------------------------------------------------------------------------------------------------------------------


BELOW = TRIANGLE + 2.0 + HIGH - 4.0
"""By which lengths stand lower than without datums [mm]."""


def shaft_content(sizing: Sizing, name: str) -> Content:
    """Return what the sheet of a shaft shows.

    Args:
        sizing: What was sized.
        name: Of the shaft.
    """
    body = shaft_body(sizing, name)
    seats, hard = datum_seats(sizing, body), zones(sizing, body)
    material = sizing.design.shaft_material
    mass = f"{mass_with_gears(sizing, body.gears, name):.2f}"
    title = Title(sizing.design.name, f"Shaft {name}", f"shaft-{name}", "Component drawing", material.name, mass)
    grids = [tooth_grid(sizing, gear_of(sizing, gear), name) for gear in body.gears]
    fits = (*_fits(body), *_fillets(body), *spline_grids(body), *(thread_grid(thread) for thread in body.threads))
    return Content(
        f"shaft-{name}",
        title,
        lambda scale: _views(sizing, body, seats, hard, scale),
        (*grids, *zone_grid(hard), *fits),
        tuple(_notes(sizing, body, seats)),
        kind="shaft",
    )


def datum_seats(sizing: Sizing, body: ShaftBody) -> tuple[Piece, ...]:
    """Return the seats of both radial bearings, whose common axis is the shaft's; none in a first sizing.

    Args:
        sizing: What was sized.
        body: The shaft.
    """
    places = [MM * place for place in sizing.arrangement.plans[body.name].bearings]
    seats = tuple(piece for piece in body.pieces if piece.tolerance
                  and any(piece.start < place < piece.end for place in places))  # fmt: skip
    return seats if len(seats) == len(DATUMS) else ()


def _views(sizing: Sizing, body: ShaftBody, seats: Sequence[Piece], hard: tuple[Zone, ...], scale: float) -> Rows:
    axis = SheetAxis(0j, 1 + 0j, scale)
    main = shaft_outline(axis, body)
    main += [line for thread in body.threads for line in thread_lines(axis, thread)]
    main += surfaces(sizing, axis, body, seats)
    main += zone_lines(axis, hard)
    main += lengths(axis, body, seats, below=BELOW if seats else 0.0)
    for letter, seat in zip(DATUMS, seats, strict=False):
        main += datum(axis.at(middle_of(body, seat), -seat.diameter / 2.0), -1j, letter)
    if body.bore:
        end = body.pieces[-1].end
        low, high = axis.at(end, -body.bore / 2.0), axis.at(end, body.bore / 2.0)
        main.append(Distance(low, high, high + 10.0, math.pi / 2.0, scale, "Ø"))
    sections = []
    for letter, slot in zip(section_letters(), body.slots, strict=False):
        reach = slot.diameter / 2.0 * scale + 2.0
        main += cutting_plane(axis.at((slot.start + slot.end) / 2.0), reach, letter, looking=1 + 0j)
        sections.append(keyway_section(slot, body.bore, letter, scale, datums=AXIS if seats else ""))
    details = [undercut_detail(standard) for standard in dict.fromkeys(cut.standard for cut in body.undercuts)]
    reliefs = dict.fromkeys(thread.undercut for thread in body.threads if thread.undercut is not None)
    details += [relief_detail(standard) for standard in reliefs]
    return [[main, *details], *([sections] if sections else [])]


def _fits(body: ShaftBody) -> tuple[SheetTable, ...]:
    """Return the limits of every seat; none where no seat has a tolerance."""
    seats = {f"Ø{millimetres(piece.diameter)} {piece.fit}": piece for piece in body.pieces if piece.fit}
    rows = tuple((fit, *_limits(seat)) for fit, seat in seats.items())
    return (SheetTable("Fits (ISO 286-2), deviations in µm", rows, ("Fit", "upper", "lower")),) if rows else ()


def _fillets(body: ShaftBody) -> tuple[SheetTable, ...]:
    """Return the fillets at shoulders that the strength was judged with; equal ones in a row."""
    places: dict[str, list[str]] = {}
    for x, radius in body.fillets:
        cone = next((piece for piece in body.pieces if piece.conical and piece.start < x < piece.end), None)
        at = x if cone is None else min(cone.start, cone.end, key=lambda end: abs(end - x))
        places.setdefault(f"R{millimetres(radius)}", []).append(millimetres(at))
    rows = tuple((radius, ", ".join(at)) for radius, at in places.items())
    return (SheetTable("Fillets at shoulders", rows, ("Radius", "from the first end at")),) if rows else ()


def _ends_of(sizing: Sizing, name: str) -> list[Retention]:
    """Return what both ends of a shaft need, where the design says how its bearings locate."""
    if any(bearing.name not in sizing.design.bearings for bearing in sizing.bearings):
        return []
    return [held for held in ends(sizing) if held.shaft == name]


def _grooves(sizing: Sizing, name: str) -> list[Groove]:
    """Return the grooves of retaining rings in a shaft."""
    return [groove for groove in grooves(sizing) if groove.shaft == name and not (groove.is_thread or groove.around)]


def _held(sizing: Sizing, name: str) -> Iterator[str]:
    """Yield what holds the parts at the ends of a built shaft, and the centres in its ends."""
    for held in _ends_of(sizing, name):
        if held.force:
            yield f"{held.outermost} is held at the {ENDS[held.way]} end by {_holder(held)}."
    for groove in _grooves(sizing, name):
        where = f"from {millimetres(MM * groove.start)} to {millimetres(MM * groove.end)}"
        yield f"{groove.what[0].upper()}{groove.what[1:]}, Ø{millimetres(MM * groove.diameter)}, {where}."
    own = [bearing.name for bearing in sizing.bearings if bearing.shaft == name]
    for bearing in own:
        sides = [f"{ENDS[held.way]} {held.by or 'nothing'}" for held in held_rings(sizing)
                 if held.bearing == bearing and held.ring == "inner"]  # fmt: skip
        if sides:
            yield f"Inner ring of {bearing}, by ends: {'; '.join(sides)}."
    steps = next((shaft.steps for shaft in sizing.built_shafts if shaft.name == name and not shaft.bore), ())
    holes = {way: centre_hole(step.diameter) for way, step in ((-1, steps[0]), (1, steps[-1]))} if steps else {}
    centres = [f"{hole.designation} at the {ENDS[way]} end" for way, hole in holes.items() if hole is not None]
    if centres:
        yield f"Centres (assumed, by the ends' diameters): {', '.join(centres)}."


def _sealed(sizing: Sizing, body: ShaftBody) -> Iterator[str]:
    """Yield what is asked of the surfaces on which lips of seals run."""
    for leaves, seal in sealed_exits(sizing):
        if leaves.shaft == body.name:
            span = f"{millimetres(MM * seal.start)} to {millimetres(MM * seal.end)}"
            least, most = (f"{1e6 * limit:g}" for limit in ROUGHNESS)
            hard = FAST_HARDNESS if leaves.velocity > FAST else HARDNESS
            yield (
                f"Under the seal towards {leaves.machine}, {span}: Ra {least} to {most}, plunge-ground without lead, "
                f"{hard:g} HRC or more, {UNDER_SEAL}."
            )


def _holder(held: Retention) -> str:
    """Return what holds a part."""
    if held.has_ring and held.ring is not None:
        return held.ring.designation
    if held.has_nut and held.nut is not None:
        return f"{held.nut.designation}, with a slot of the washer's tab in the thread"
    if held.has_plate and held.hole is not None:
        return f"an end plate with a screw {held.hole.screw}, 8.8"
    return "nothing yet"


def _limits(piece: Piece) -> tuple[str, str]:
    low, high = shaft_limits(piece.diameter / MM, piece.fit)
    return _deviation(high), _deviation(low)


def _deviation(limit: float) -> str:
    """Return a limit deviation in µm; zero has no sign."""
    return f"{1e6 * limit:+.0f}" if abs(limit) > 5e-7 else "0"


def _notes(sizing: Sizing, body: ShaftBody, seats: Sequence[Piece]) -> Iterator[str]:
    chamfers = {end_chamfer(piece) for piece in (body.pieces[0], body.pieces[-1])} - {0.0}
    if chamfers:
        yield f"Ends chamfered {' and '.join(f'{chamfer:g}' for chamfer in sorted(chamfers))} × 45° (assumed)."
    if any(piece.tolerance for piece in body.pieces):
        yield f"Bearing seats (assumed): k6 under balls, m6 under rollers, n6 over Ø100; {SEAT_SOURCE}; {SEAT_TEXTURE}."
    if seats:
        yield f"{AXIS}: axis of the seats of both radial bearings. Seats IT5/2, shoulders IT5: {RUNOUT_SOURCE}."
        yield f"PD: pitch circles, of teeth by their class, of splines IT{SPLINE_GRADE} (assumed)."
        lines = f"between shoulders ± IT{BETWEEN_SHOULDERS}/2, to teeth ± IT{TO_TEETH}/2"
        yield f"Lengths (assumed): {lines}, to the loaded sides of grooves {TO_GROOVE}."
    yield from _held(sizing, body.name)
    yield from _sealed(sizing, body)
    if body.slots:
        forms = " and ".join(sorted({slot.form for slot in body.slots}))
        yield f"Keyways DIN 6885-1, form {forms}, width P9, as symmetric as half of IT9 (assumed)."
    yield from run_out_notes(body)
    if all(shaft.name != body.name for shaft in sizing.built_shafts):
        yield (
            "First sizing: one cylinder that bears bending and torsion. Shoulders, seats and joints are not sized, "
            "as the design gives this shaft no bearings; they are not drawn."
        )
    yield "General surfaces Ra 3.2 (assumed). Dimensions in mm; lengths from the first end."
