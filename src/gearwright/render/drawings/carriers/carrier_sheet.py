"""The sheet of one carrier: section through a pin, end view, sizes, how true pins stand."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearwright.catalogue import LARGEST, SMALLEST, shaft_limits, standard_tolerance
from gearwright.render.drawings.carriers.carrier_view import (
    Drawn,
    drawn_carrier,
    end_view,
    is_even,
    places_of,
    section,
    section_dimensions,
)
from gearwright.render.drawings.carriers.pin_places import PinPlaces, pin_places
from gearwright.render.drawings.sheet.compose import Content, Rows
from gearwright.render.drawings.sheet.entities import millimetres, trimmed
from gearwright.render.drawings.sheet.frame import Title
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.sheet.tolerances import Tolerance
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import Axis
from gearwright.render.drawings.views.weights import made_of
from gearwright.shape.carriers import held_at
from gearwright.shape.stands import axes_at, middle_of, set_frame, stands_of
from gearwright.sizing import CarrierSizing, Sizing
from gearwright.sizing.mass import Cage, cage_of
from gearwright.sizing.places import runs
from gearwright.spec import GROUND

PIN_FIT = ("H7", "p6")
"""Of holes and pins: a light press fit; assumed."""
DATUM = "A"


def carrier_content(sizing: Sizing, carrier: CarrierSizing) -> Content:
    """Return what the sheet of a carrier shows.

    Args:
        sizing: What was sized.
        carrier: One of its carriers.
    """
    cage = cage_of(sizing, carrier, runs(sizing)[0])
    axes = axes_at(set_frame(sizing, carrier.stage), middle_of(cage.plates[0].body))
    own = [stand for stand in stands_of(sizing) if stand.gear.stage == carrier.stage and stand.carrier]
    along = float(axes.along @ np.asarray(cage.plates[0].body.direction))
    drawn = drawn_carrier(cage, held_at(cage, axes, own), along=along)
    name, places = f"carrier-{carrier.stage}", pin_places(sizing, carrier)
    title = Title(
        sizing.design.name, f"Carrier {carrier.stage}", name, "Assembly drawing",
        sizing.design.shaft_material.name, f"{made_of(sizing).weights[str(carrier.part)]:.2f}",
    )  # fmt: skip
    letter = DATUM if cage.plates[0].bore else ""
    zone = None if places.zone is None else Tolerance("position", MM * places.zone, letter)
    across = millimetres(MM * cage.pin_diameter)
    holes = f"{len(drawn.eyes)} × Ø{across} {PIN_FIT[0]}, {'evenly spaced' if is_even(drawn) else 'see table'}"

    def views(scale: float) -> Rows:
        axis = Axis(0j, 1 + 0j, scale)
        side = [*section(drawn, axis), *section_dimensions(drawn, axis, (f" {'/'.join(PIN_FIT)}", ""), letter=letter)]
        return [[side, end_view(drawn, axis, holes, zone)]]

    notes = (*_notes(sizing, carrier, drawn), *_shared(places), *_assumed(cage))
    grids = (Grid(f"Carrier {carrier.stage}", tuple(_rows(sizing, carrier, drawn))), *_unequal(drawn))
    return Content(name, title, views, grids, notes, kind="carrier")


def _unequal(drawn: Drawn) -> Iterator[Grid]:
    """Yield where every pin stands, where they are not evenly spaced on one circle."""
    if not is_even(drawn):
        rows = tuple((str(k), f"{trimmed(angle, 4)}°", millimetres(2.0 * radius))
                     for k, (angle, radius) in enumerate(places_of(drawn), start=1))  # fmt: skip
        yield Grid("Pins, the first on top, counter-clockwise", rows, ("Pin", "Angle", "Circle Ø"))


def _rows(sizing: Sizing, carrier: CarrierSizing, drawn: Drawn) -> Iterator[tuple[str, str]]:
    cage, circles = drawn.cage, sorted({round(MM * eye.radius, 6) for eye in drawn.eyes})
    yield "Pins", f"{cage.pins}, Ø{_mm(cage.pin_diameter)}, bore Ø{_mm(cage.pin_bore)}"
    yield "Length of a pin", _mm(cage.whole[1] - cage.whole[0])
    yield "Pin circle", ", ".join(f"Ø{millimetres(2.0 * circle)}" for circle in circles)
    yield "Metal outside the pins", f"{_mm(carrier.eye_wall)} (eye R{_mm(drawn.eyes[0].half)})"
    yield "Plates", ", ".join(f"{millimetres(end - start)} thick" for start, end, _ in drawn.plates)
    if len(drawn.plates) > 1:
        yield "Between the plates", _mm(cage.span[1] - cage.span[0])
    if cage.bridge is not None:
        ends = [cage.bridge.radius + way * cage.bridge.depth / 2.0 for way in (-1.0, 1.0)]
        yield "Bridges", f"{cage.bridges}, {_mm(cage.bridge.width)} × {_mm(cage.bridge.depth)}"
        yield "Bridges, from the axis", " to ".join(map(_mm, ends))
    low, high = _press(cage)
    if high:
        yield f"Press fit {'/'.join(PIN_FIT)}", f"{low:.0f} to {high:.0f} µm"
    yield "Largest torque", f"{carrier.torque:.5g} N m"
    yield "Force on a pin", f"{carrier.pin_force / 1e3:.4g} kN"
    yield "Yield strength", f"{(sizing.design.shaft_material.yield_strength or 0.0) / 1e6:.4g} MPa"


def _mm(value: float) -> str:
    return millimetres(MM * value)


def _press(cage: Cage) -> tuple[float, float]:
    """Return least and largest interference of pins in their holes [µm]; zeros beyond the sizes of ISO 286-1."""
    if not SMALLEST < cage.pin_diameter <= LARGEST:
        return 0.0, 0.0
    low, high = shaft_limits(cage.pin_diameter, PIN_FIT[1])
    return 1e6 * (low - standard_tolerance(cage.pin_diameter, 7)), 1e6 * high


def _notes(sizing: Sizing, carrier: CarrierSizing, drawn: Drawn) -> Iterator[str]:
    cage = drawn.cage
    if carrier.shaft == GROUND:
        yield "The carrier stands still: what holds it in the housing is not sized."
    else:
        yield f"One piece with shaft {carrier.shaft}: the bore of that side is drawn to its outside."
    one = "plates and bridges one piece" if cage.bridge is not None else "plate"
    if cage.bridge is None and len(cage.plates) > 1:
        one = "two plates that the pins alone tie"
    elif len(cage.plates) == 1:
        one = "one plate, as a second one has no room"
    share = f"{sizing.design.carriers.fill:g} of its disc is left"
    yield f"As weighed: {one}; arms as wide as eyes, hubs so large that {share}, holes for pins not counted."
    yield "Pins are pressed in, flush with the outer faces; what secures them and brings oil to them is not sized."


def _shared(places: PinPlaces) -> Iterator[str]:
    """Yield how true pins stand, and what it makes of the load of a planet."""
    if places.zone is None:
        return
    yield f"Position of the holes: {places.origin}."
    if not places.is_simple:
        yield "What it makes of the loads of compound sets, or of two planets, is not said by the closed form."
        return
    floats, fixed = ("beyond what leaves all planets a load" if each is None else f"{each:.3g}"
                     for each in (places.floating, places.fixed))  # fmt: skip
    yield (
        f"With one pin {1e6 * places.zone / 2.0:.3g} µm off along the circle K_{{γ}} is {floats} where a member floats,"
        f" {fixed} where none does (rigid pins, 20 N/(mm µm); Ligata et al. 2009); rated with {places.asked:g}."
    )


def _assumed(cage: Cage) -> Iterator[str]:
    more = " Holes of both plates in one setting." if len(cage.plates) > 1 else ""
    yield f"Holes {PIN_FIT[0]}, Ra 0.8; pins {PIN_FIT[1]} (assumed).{more}"
    yield "Edges of holes 1 × 45°, inner corners R2 (assumed; not weighed). General surfaces Ra 3.2 (assumed)."
    yield "Dimensions in mm."
