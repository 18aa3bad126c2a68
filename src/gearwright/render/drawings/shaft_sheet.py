"""The sheet of one shaft: outline with dimensions, sections through keyways, fits, tooth data of integral gears."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gearwright.catalogue import SEAT_SOURCE, centre_hole, shaft_limits
from gearwright.catalogue.standard_parts.radial_seals import FAST, FAST_HARDNESS, HARDNESS, ROUGHNESS
from gearwright.catalogue.standard_parts.radial_seals import SHAFT as UNDER_SEAL
from gearwright.render.drawings.sheet.compose import Content, Rows
from gearwright.render.drawings.sheet.entities import Distance, millimetres
from gearwright.render.drawings.sheet.frame import Title
from gearwright.render.drawings.sheet.symbols import cutting_plane, section_letters
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.sheet.tolerances import HIGH, TRIANGLE, datum
from gearwright.render.drawings.views.shaft_parts import MM, Piece, ShaftBody, shaft_body
from gearwright.render.drawings.views.shaft_view import Axis, end_chamfer, shaft_outline
from gearwright.render.drawings.views.shafts.hardness import Zone, zone_grid, zone_lines, zones
from gearwright.render.drawings.views.shafts.keyways import keyway_section
from gearwright.render.drawings.views.shafts.lengths import BETWEEN_SHOULDERS, TO_GROOVE, TO_TEETH, lengths
from gearwright.render.drawings.views.shafts.splines import run_out_notes, spline_grids
from gearwright.render.drawings.views.shafts.surfaces import (
    AXIS,
    DATUMS,
    RUNOUT_SOURCE,
    SEAT_TEXTURE,
    SPLINE_GRADE,
    middle_of,
    surfaces,
)
from gearwright.render.drawings.views.shafts.threads import thread_grid, thread_lines
from gearwright.render.drawings.views.tooth_data import tooth_grid
from gearwright.render.drawings.views.undercut_view import relief_detail, undercut_detail
from gearwright.render.drawings.views.weights import mass_with_gears
from gearwright.shape.teeth import gear_of
from gearwright.sizing import Sizing
from gearwright.sizing.shafts import ENDS, Groove, Retention, ends, grooves, held_rings, sealed_exits

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
    axis = Axis(0j, 1 + 0j, scale)
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


def _fits(body: ShaftBody) -> tuple[Grid, ...]:
    """Return the limits of every seat; none where no seat has a tolerance."""
    seats = {f"Ø{millimetres(piece.diameter)} {piece.fit}": piece for piece in body.pieces if piece.fit}
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
