"""The sheet of one shaft: outline with dimensions, sections through keyways, fits, tooth data of integral gears."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gearwright.catalogue import SEAT_SOURCE, centre_hole, shaft_limits, standard_tolerance
from gearwright.render.drawings.sheet.compose import Content, Rows
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import (
    TEXT,
    Distance,
    Entity,
    Words,
    millimetres,
)
from gearwright.render.drawings.sheet.frame import Title
from gearwright.render.drawings.sheet.symbols import cutting_plane
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.sheet.tolerances import HIGH, TRIANGLE, Tolerance, datum
from gearwright.render.drawings.views.marks import ACROSS, Mark, marked
from gearwright.render.drawings.views.shaft_parts import MM, Piece, ShaftBody, Slot, shaft_body, thread_name
from gearwright.render.drawings.views.shaft_view import Axis, end_chamfer, key_section, shaft_outline
from gearwright.render.drawings.views.shafts.threads import thread_grid, thread_lines
from gearwright.render.drawings.views.tooth_data import tooth_grid
from gearwright.render.drawings.views.undercut_view import relief_detail, undercut_detail
from gearwright.render.drawings.views.weights import mass_with_gears
from gearwright.render.style.labels import spread
from gearwright.shape.teeth import gear_of
from gearwright.sizing import Sizing
from gearwright.sizing.shafts import ENDS, Groove, Retention, ends, grooves, held_rings

DATUMS = ("A", "B")
"""Seats of the two radial bearings."""
RUNOUT_GRADE = 5
"""Of the seats of normal bearings, of which half is their total run-out; assumed (usual)."""
BELOW = TRIANGLE + 2.0 + HIGH - 4.0
"""By which lengths stand lower than without datums [mm]."""
LEVEL = 8.0
"""Between parallel dimension lines [mm]."""
SEAT_TEXTURE = "Ra 0.8"
"""Of bearing seats; assumed (usual for IT6 and normal bearings)."""


def shaft_content(sizing: Sizing, name: str) -> Content:
    """Return what the sheet of a shaft shows.

    Args:
        sizing: What was sized.
        name: Of the shaft.
    """
    body = shaft_body(sizing, name)
    seats = datum_seats(sizing, body)
    material = sizing.design.shaft_material
    mass = f"{mass_with_gears(sizing, body.gears, name):.2f}"
    title = Title(sizing.design.name, f"Shaft {name}", f"shaft-{name}", "Component drawing", material.name, mass)
    grids = [tooth_grid(sizing, gear_of(sizing, gear), name) for gear in body.gears]
    fits = (*_fits(body), *_fillets(body), *_splines(body), *(thread_grid(thread) for thread in body.threads))
    return Content(
        f"shaft-{name}",
        title,
        lambda scale: _views(body, seats, scale),
        (*grids, *fits),
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


def _views(body: ShaftBody, seats: Sequence[Piece], scale: float) -> Rows:
    axis = Axis(0j, 1 + 0j, scale)
    main = shaft_outline(axis, body)
    main += [line for thread in body.threads for line in thread_lines(axis, thread)]
    main += _diameters(axis, body, seats)
    main += _lengths(axis, body, below=BELOW if seats else 0.0)
    for letter, seat in zip(DATUMS, seats, strict=False):
        main += datum(axis.at(_middle(body, seat), -seat.diameter / 2.0), -1j, letter)
    if body.bore:
        end = body.pieces[-1].end
        low, high = axis.at(end, -body.bore / 2.0), axis.at(end, body.bore / 2.0)
        main.append(Distance(low, high, high + 10.0, math.pi / 2.0, scale, "Ø"))
    sections = []
    for letter, slot in zip("ABCDEFGH", body.slots, strict=False):
        reach = slot.diameter / 2.0 * scale + 2.0
        main += cutting_plane(axis.at((slot.start + slot.end) / 2.0), reach, letter, looking=1 + 0j)
        sections.append(_section(slot, body.bore, letter, scale))
    details = [undercut_detail(standard) for standard in dict.fromkeys(cut.standard for cut in body.undercuts)]
    reliefs = dict.fromkeys(thread.undercut for thread in body.threads if thread.undercut is not None)
    details += [relief_detail(standard) for standard in reliefs]
    return [[main, *details], *([sections] if sections else [])]


def _diameters(axis: Axis, body: ShaftBody, seats: Sequence[Piece]) -> Iterator[Entity]:
    """Yield every diameter and what its surface may run out, written above the shaft."""
    marks = sorted((*_marks(body), *_runouts(body, seats)), key=lambda mark: mark.x)
    top = axis.scale * max(piece.diameter for piece in body.pieces) / 2.0
    places = spread([axis.scale * mark.x for mark in marks], ACROSS)
    for mark, slot in zip(marks, places, strict=True):
        yield from marked(axis, mark, slot, top)


def _marks(body: ShaftBody) -> Iterator[Mark]:
    for before, piece, after in zip((None, *body.pieces), body.pieces, (*body.pieces[1:], None), strict=False):
        beside = [neighbour.diameter for neighbour in (before, after) if neighbour is not None and neighbour.tolerance]
        if not piece.tolerance and piece.diameter in beside and (piece.thread is None or piece.relieved):
            continue
        x = _middle(body, piece)
        if piece.thread is not None:
            if not piece.relieved:
                yield Mark(x, piece.diameter / 2.0, "", thread_name(piece.thread))
            elif piece.thread.undercut is not None:
                yield Mark(x, piece.diameter / 2.0, "", piece.thread.undercut.designation)
            continue
        if piece.conical:
            x = piece.start if piece.diameters[0] > piece.diameters[1] else piece.end
        suffix = f" {piece.tolerance}" if piece.tolerance else ""
        yield Mark(x, piece.diameter / 2.0, suffix, texture=SEAT_TEXTURE if piece.tolerance else "")
    for toothing in body.splines:
        x = toothing.start + 0.75 * (toothing.end - toothing.start)
        yield Mark(x, MM * toothing.teeth.shaft_tip / 2.0, "", toothing.designation)
    for cut in body.undercuts:
        yield Mark(MM * (cut.place + cut.edge) / 2.0, MM * cut.bottom / 2.0, "", cut.standard.designation)


def _middle(body: ShaftBody, piece: Piece) -> float:
    """Return where the diameter of a piece is dimensioned, beside keyways [mm]."""
    share = 0.25 if any(slot.start < piece.end and slot.end > piece.start for slot in body.slots) else 0.5
    return piece.start + share * (piece.end - piece.start)


def _runouts(body: ShaftBody, seats: Sequence[Piece]) -> Iterator[Mark]:
    """Yield the total run-out of every bearing seat against the axis of both radial bearings."""
    for piece in body.pieces:
        if piece.tolerance and seats:
            runout = MM * standard_tolerance(piece.diameter / MM, RUNOUT_GRADE) / 2.0
            tolerance = Tolerance("total run-out", runout, "–".join(DATUMS))
            x = piece.start + 0.85 * (piece.end - piece.start)
            yield Mark(x, piece.diameter / 2.0, "", tolerance=tolerance)


def _lengths(axis: Axis, body: ShaftBody, *, below: float) -> Iterator[Entity]:
    """Yield lengths from the first end, one below the other, and those of keyways and splines nearest to the shaft."""
    level = axis.origin - 1j * (axis.scale * max(piece.diameter for piece in body.pieces) / 2.0 + 9.0 + below)
    spans = [(slot.start, slot.end, slot.diameter) for slot in body.slots]
    spans += [(spline.start, spline.end, MM * spline.teeth.shaft_tip) for spline in body.splines]
    for start, end, diameter in spans:
        radius = -diameter / 2.0
        yield Distance(axis.at(start, radius), axis.at(end, radius), level, 0.0, axis.scale)
    first = body.pieces[0]
    level -= 1j * LEVEL if spans else 0.0
    for x, radius in _shoulders(body):
        datum = axis.at(first.start, -first.diameters[0] / 2.0 + end_chamfer(first))
        yield Distance(datum, axis.at(x, -radius), level, 0.0, axis.scale)
        level -= 1j * LEVEL


def _shoulders(body: ShaftBody) -> Iterator[tuple[float, float]]:
    """Yield where lengths end: at shoulders, starts of keyways, and the second end, with the radius there."""
    ends = [(piece.end, max(piece.diameters[1], after.diameters[0]) / 2.0)
            for piece, after in zip(body.pieces, body.pieces[1:], strict=False)]  # fmt: skip
    last = body.pieces[-1]
    ends.append((last.end, last.diameters[1] / 2.0 - end_chamfer(last)))
    ends += [(slot.start, slot.diameter / 2.0) for slot in body.slots if slot.start > 1e-6]
    ends += [(spline.start, MM * spline.teeth.shaft_tip / 2.0) for spline in body.splines]
    seen: list[float] = []
    for x, radius in sorted(ends):
        if x > body.pieces[0].start + 1e-6 and all(abs(x - earlier) > 1e-6 for earlier in seen):
            seen.append(x)
            yield x, radius


def _section(slot: Slot, bore: float, letter: str, scale: float) -> list[Entity]:
    axis = Axis(0j, 1 + 0j, scale)
    entities = key_section(axis, slot, bore)
    radius, half = slot.diameter / 2.0, MM * slot.section.width / 2.0
    floor = radius - MM * slot.section.shaft_depth
    rim = math.sqrt(radius**2 - half**2)
    above, aside = 1j * (scale * radius + 7.0), scale * radius + 9.0
    entities.append(Distance(axis.at(-half, rim), axis.at(half, rim), above, 0.0, scale, suffix=" P9"))
    low, high = axis.at(0.0, -radius), axis.at(half, floor)
    entities.append(Distance(low, high, complex(aside, 0.0), math.pi / 2.0, scale))
    top = extent(entities)[3]
    entities.append(Words(1j * (top + 3.0), f"{letter}–{letter}", TEXT, "middle"))
    entities.append(Words(-1j * (scale * radius + 9.0), slot.designation, TEXT, "middle"))
    return entities


def _fits(body: ShaftBody) -> tuple[Grid, ...]:
    """Return the limits of every seat; none where no seat has a tolerance."""
    seats = {f"Ø{millimetres(piece.diameter)} {piece.tolerance}": piece for piece in body.pieces if piece.tolerance}
    rows = tuple((fit, *_limits(seat)) for fit, seat in seats.items())
    return (Grid("Fits (ISO 286-2), deviations in µm", rows, ("Fit", "upper", "lower")),) if rows else ()


def _fillets(body: ShaftBody) -> tuple[Grid, ...]:
    """Return the fillets at shoulders that the strength was judged with; equal ones in a row."""
    places: dict[str, list[str]] = {}
    for x, radius in body.fillets:
        cone = next((piece for piece in body.pieces if piece.conical and piece.start < x < piece.end), None)
        at = x if cone is None else min(cone.start, cone.end, key=lambda end: abs(end - x))
        places.setdefault(f"R{millimetres(radius)}", []).append(millimetres(at))
    rows = tuple((radius, ", ".join(at)) for radius, at in places.items())
    return (Grid("Fillets at shoulders", rows, ("Radius", "from the first end at")),) if rows else ()


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


def _holder(held: Retention) -> str:
    """Return what holds a part."""
    if held.has_ring and held.ring is not None:
        return held.ring.designation
    if held.has_nut and held.nut is not None:
        return f"{held.nut.designation}, with a slot of the washer's tab in the thread"
    if held.has_plate and held.hole is not None:
        return f"an end plate with a screw {held.hole.screw}, 8.8"
    return "nothing yet"


def _splines(body: ShaftBody) -> Iterator[Grid]:
    """Yield the data of every spline."""
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
        yield Grid(f"Spline: {toothing.designation}", rows)


def _limits(piece: Piece) -> tuple[str, str]:
    low, high = shaft_limits(piece.diameter / MM, piece.tolerance)
    return f"{1e6 * high:+.0f}", f"{1e6 * low:+.0f}"


def _notes(sizing: Sizing, body: ShaftBody, seats: Sequence[Piece]) -> Iterator[str]:
    chamfers = {end_chamfer(piece) for piece in (body.pieces[0], body.pieces[-1])} - {0.0}
    if chamfers:
        yield f"Ends chamfered {' and '.join(f'{chamfer:g}' for chamfer in sorted(chamfers))} × 45° (assumed)."
    if any(piece.tolerance for piece in body.pieces):
        yield f"Bearing seats (assumed): k6 under balls, m6 under rollers, n6 over Ø100; {SEAT_SOURCE}; {SEAT_TEXTURE}."
        axis = f" against {'–'.join(DATUMS)}, the seats of the radial bearings" if seats else ""
        yield f"Run-out of bearing seats IT5/2 in total, of their shoulders IT5 (usual; assumed){axis}."
    yield from _held(sizing, body.name)
    if body.slots:
        forms = " and ".join(sorted({slot.form for slot in body.slots}))
        yield f"Keyways DIN 6885-1, form {forms}, width P9 (assumed)."
    if all(shaft.name != body.name for shaft in sizing.built_shafts):
        yield (
            "First sizing: one cylinder that bears bending and torsion. Shoulders, seats and joints are not sized, "
            "as the design gives this shaft no bearings; they are not drawn."
        )
    yield "General surfaces Ra 3.2 (assumed). Dimensions in mm; lengths from the first end."
