"""Sheets of carriers: section through a pin, end view, how true pins stand.

What all drawings are made of lies in `sheet` and `views` beside this folder.
"""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Role, gear_part
from gearwright.catalogue import LARGEST, SMALLEST, shaft_limits, standard_tolerance
from gearwright.parts.planetary import pin_error_share, pin_error_within
from gearwright.render.drawings.entities import (
    HIGH,
    TEXT,
    Arc,
    Distance,
    Entity,
    GeometricTolerance,
    Hatch,
    Layer,
    Path,
    Words,
    datum,
    millimetres,
    tolerance_frame,
    trimmed,
)
from gearwright.render.drawings.paper import Content, Rows, SheetTable, Title
from gearwright.render.drawings.shaft_view import MM, OVERSHOOT, SheetAxis, made_of
from gearwright.shape import axes_at, circle, held_at, middle_of, plate_outline, set_frame, stands_of
from gearwright.shape.solids import Arm, plate_form
from gearwright.sizing import CarrierSizing, Sizing
from gearwright.sizing.mass import Cage, Plate, cage_of
from gearwright.sizing.places import along_body, runs
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# A carrier in section through a pin, and seen along its axis.
# ----------------------------------------------------------------------------------------------------------------------


ASIDE, LEVEL = 9.0, 8.0
"""From a part to its nearest dimension line, and between parallel ones [mm]."""
LEAN = (math.pi / 4.0, 3.0 * math.pi / 4.0)
"""Of the hatching of plates and of pins [rad]."""
AROUND = 720
"""Corners of an outline [-]."""
KNEE = 8.0
"""Of a leader beyond the plate [mm]."""


@dataclass(frozen=True)
class Drawn:
    """A carrier as its sheet shows it; the first pin stands on top, lengths in mm from the first plate's outer end."""

    cage: Cage
    held: tuple[Arm, ...]
    """Eyes and bridges, turned so that the first eye is on top [m]."""
    plates: tuple[tuple[float, float, Plate], ...]
    """Where each begins and ends, from the left [mm]."""
    pins: tuple[float, float]
    """Where they begin and end [mm]."""

    @property
    def eyes(self) -> tuple[Arm, ...]:
        """Around pins."""
        return tuple(arm for arm in self.held if arm.is_round)


def drawn_carrier(cage: Cage, held: Sequence[Arm], *, along: float) -> Drawn:
    """Return a carrier as its sheet shows it, seen from its left end.

    Args:
        cage: As made.
        held: Its eyes and bridges about its axis.
        along: Positive where the axis of their angles goes from left to right, away from who looks [-].
    """
    top = max((arm for arm in held if arm.is_round), key=lambda arm: round(arm.radius, 9))
    sense = -1.0 if along > 0.0 else 1.0
    first, zero = cage.plates[0].body, cage.whole[0]
    ends = [along_body(first, own.body) for own in cage.plates]
    spans = [(MM * (low - zero), MM * (high - zero), own) for (low, high), own in zip(ends, cage.plates, strict=True)]
    turned = [arm._replace(angle=math.pi / 2.0 + sense * (arm.angle - top.angle)) for arm in held]
    turned.sort(key=lambda arm: round(_from_top(arm), 6))
    return Drawn(
        cage, tuple(turned), tuple(sorted(spans, key=lambda span: span[0])), (0.0, MM * (cage.whole[1] - zero))
    )


def _from_top(arm: Arm) -> float:
    return (arm.angle - math.pi / 2.0 + 1e-9) % (2.0 * math.pi)


def places_of(drawn: Drawn) -> tuple[tuple[float, float], ...]:
    """Return where pins stand: angle from the one on top, counter-clockwise [°], and radius of their circle [mm].

    Args:
        drawn: The carrier.
    """
    return tuple((round(math.degrees(_from_top(eye)), 4), MM * eye.radius) for eye in drawn.eyes)


def is_even(drawn: Drawn) -> bool:
    """Tell whether pins stand evenly on one circle.

    Args:
        drawn: The carrier.
    """
    places = places_of(drawn)
    return all(abs(angle - 360.0 * k / len(places)) < 1e-3 and math.isclose(radius, places[0][1], rel_tol=1e-9)
               for k, (angle, radius) in enumerate(places))  # fmt: skip


def outline_radii(drawn: Drawn, own: Plate, angles: Floats) -> Floats:
    """Return the outline of a plate [mm].

    Args:
        drawn: The carrier.
        own: One of its plates.
        angles: [rad]
    """
    return np.asarray(MM * plate_form(drawn.held, plate_outline(own)).radii(angles))


def section(drawn: Drawn, axis: SheetAxis) -> list[Entity]:
    """Return the section through the pin on top and through what stands opposite.

    Args:
        drawn: The carrier.
        axis: On paper.
    """
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(drawn.pins[0] - beyond), axis.at(drawn.pins[1] + beyond)), Layer.CENTRE)]
    entities += _half(drawn, axis, drawn.eyes[0], 1.0)
    below = next((arm for arm in drawn.held if _is_below(arm)), None)
    if below is not None and below.is_round:
        entities += _half(drawn, axis, below, -1.0)
    else:
        entities += _opposite(drawn, axis, below)
    for start, end, own in drawn.plates:
        for x in (start, end) if own.bore else ():
            entities.append(Path((axis.at(x, -MM * own.bore), axis.at(x, MM * own.bore)), Layer.OUTLINE))
    return entities


def _is_below(arm: Arm) -> bool:
    return abs(cmath.phase(cmath.rect(1.0, arm.angle + math.pi / 2.0))) < 1e-6


def _half(drawn: Drawn, axis: SheetAxis, eye: Arm, side: float) -> Iterator[Entity]:
    """Yield plates and a pin in section, on one side of the axis."""
    middle, pin, hollow = MM * eye.radius, MM * drawn.cage.pin_diameter / 2.0, MM * drawn.cage.pin_bore / 2.0
    for start, end, own in drawn.plates:
        top = float(outline_radii(drawn, own, np.array([math.pi / 2.0]))[0]) if side > 0.0 else middle + MM * eye.half
        for low, high in ((MM * own.bore, middle - pin), (middle + pin, top)):
            yield from _cut(axis, (start, end), (side * low, side * high), LEAN[0])
    start, end = drawn.pins
    walls = (
        [(middle - pin, middle - hollow), (middle + hollow, middle + pin)] if hollow else [(middle - pin, middle + pin)]
    )
    for low, high in walls:
        yield from _cut(axis, (start, end), (side * low, side * high), LEAN[1])
    if hollow:
        for x in drawn.pins:
            yield Path((axis.at(x, side * (middle - hollow)), axis.at(x, side * (middle + hollow))), Layer.OUTLINE)
    more = OVERSHOOT / axis.scale
    yield Path((axis.at(start - more, side * middle), axis.at(end + more, side * middle)), Layer.CENTRE)


def _opposite(drawn: Drawn, axis: SheetAxis, bridge: Arm | None) -> Iterator[Entity]:
    """Yield what stands opposite of the pin: plates with a bridge between them, one piece, or plates alone."""
    below = np.array([-math.pi / 2.0])
    spans = [
        (start, end, MM * own.bore, float(outline_radii(drawn, own, below)[0])) for start, end, own in drawn.plates
    ]
    if bridge is None or len(spans) < 2:
        for start, end, bore, top in spans:
            yield from _cut(axis, (start, end), (-bore, -top), LEAN[0])
        return
    (a, b, hole, top), (c, d, other, reach) = spans
    low, high = MM * bridge.inner, MM * bridge.radius
    corners = [(a, hole), (b, hole), (b, low), (c, low), (c, other), (d, other), (d, reach), (c, reach), (c, high),
               (b, high), (b, top), (a, top)]  # fmt: skip
    points = tuple(axis.at(x, -radius) for x, radius in corners)
    yield from (Hatch(points, LEAN[0]), Path(points, Layer.OUTLINE, closed=True))


def _cut(axis: SheetAxis, span: tuple[float, float], radii: tuple[float, float], lean: float) -> Iterator[Entity]:
    corners = tuple(axis.at(x, radius) for x, radius in
                    ((span[0], radii[0]), (span[1], radii[0]), (span[1], radii[1]), (span[0], radii[1])))  # fmt: skip
    yield from (Hatch(corners, lean, 2.0 if lean == LEAN[1] else 3.0), Path(corners, Layer.OUTLINE, closed=True))


def section_dimensions(drawn: Drawn, axis: SheetAxis, fits: tuple[str, str], *, letter: str) -> Iterator[Entity]:
    """Yield diameters on both sides and lengths below.

    Args:
        drawn: The carrier.
        axis: On paper.
        fits: Of the pins in their holes, and after the diameter of the hole in the plate with the datum.
        letter: Of the datum; empty: none.
    """
    left, right = drawn.plates[0], drawn.plates[-1]
    reach = MM * max(own.body.radius for _, _, own in drawn.plates)
    eye, level = MM * drawn.eyes[0].radius, ASIDE
    bores = [(left, left[0], -1.0)] if len(drawn.plates) == 1 else [(left, left[0], -1.0), (right, right[1], 1.0)]
    for (_, _, own), x, way in bores:
        if own.bore:
            half = MM * own.bore
            low, high = axis.at(x, -half), axis.at(x, half)
            yield Distance(low, high, high + way * level, math.pi / 2.0, axis.scale, "Ø")
            if letter and own is drawn.cage.plates[0]:
                yield from datum(low + way * level, -1j, letter)
    start, end = drawn.pins
    far = axis.at(end).real + ASIDE + LEVEL
    pin = MM * drawn.cage.pin_diameter / 2.0
    for radius, row in ((eye, 0), (reach, 1)):
        low, high = axis.at(end, -radius), axis.at(end, radius)
        yield Distance(low, high, complex(far + LEVEL * row, 0.0), math.pi / 2.0, axis.scale, "Ø")
    low, high = axis.at(start, eye - pin), axis.at(start, eye + pin)
    yield Distance(low, high, high - ASIDE, math.pi / 2.0, axis.scale, "Ø", fits[0])
    if drawn.cage.pin_bore:
        hollow = MM * drawn.cage.pin_bore / 2.0
        low, high = axis.at(start, eye - hollow), axis.at(start, eye + hollow)
        yield Distance(low, high, high - ASIDE - LEVEL, math.pi / 2.0, axis.scale, "Ø")
    foot = axis.at(0.0, -reach) - 1j * ASIDE
    spans = [(a, b) for a, b, _ in drawn.plates]
    spans += [(left[1], right[0])] if len(drawn.plates) > 1 else []
    below = -min(float(outline_radii(drawn, own, np.array([-math.pi / 2.0]))[0]) for _, _, own in drawn.plates)
    for k, (a, b) in enumerate([*spans, drawn.pins]):
        yield Distance(axis.at(a, below), axis.at(b, below), foot - 1j * LEVEL * k, 0.0, axis.scale)


def end_view(drawn: Drawn, axis: SheetAxis, words: str, tolerance: GeometricTolerance | None) -> list[Entity]:
    """Return a carrier seen from its left end: outline, pins on their circle, bridges behind the plate.

    Args:
        drawn: The carrier.
        axis: Its origin is the middle.
        words: Of the holes, at the leader.
        tolerance: Of their places.
    """
    _, _, own = drawn.plates[0]
    angles = circle(AROUND)
    radii = outline_radii(drawn, own, angles)
    outline = tuple(axis.on(complex(cmath.rect(float(r), float(a)))) for r, a in zip(radii, angles, strict=True))
    entities: list[Entity] = [Path(outline, Layer.OUTLINE, closed=True)]
    if own.bore:
        entities.append(Arc(axis.at(0.0), axis.scale * MM * own.bore, Layer.OUTLINE))
    for arm in drawn.held:
        entities += _pin(drawn, axis, arm) if arm.is_round else [_bridge(axis, arm)]
    entities += [Arc(axis.at(0.0), axis.scale * radius, Layer.CENTRE)
                 for radius in sorted({round(MM * eye.radius, 6) for eye in drawn.eyes})]  # fmt: skip
    reach = axis.scale * MM * own.body.radius
    entities += [Path((axis.origin - way, axis.origin + way), Layer.CENTRE)
                 for way in (reach + OVERSHOOT, 1j * (reach + OVERSHOOT))]  # fmt: skip
    return [*entities, *_leader(drawn, axis, words, tolerance)]


def _pin(drawn: Drawn, axis: SheetAxis, eye: Arm) -> Iterator[Entity]:
    middle, out = axis.on(complex(cmath.rect(MM * eye.radius, eye.angle))), cmath.rect(1.0, eye.angle)
    pin = axis.scale * MM * drawn.cage.pin_diameter / 2.0
    yield Arc(middle, pin, Layer.OUTLINE)
    if drawn.cage.pin_bore:
        yield Arc(middle, axis.scale * MM * drawn.cage.pin_bore / 2.0, Layer.OUTLINE)
    if abs(out.real) > 1e-9 and abs(out.imag) > 1e-9:
        yield Path((middle - (pin + 2.0) * out, middle + (pin + 2.0) * out), Layer.CENTRE)


def _bridge(axis: SheetAxis, arm: Arm) -> Path:
    along, across = cmath.rect(1.0, arm.angle), cmath.rect(1.0, arm.angle + math.pi / 2.0)
    corners = ((arm.inner, -arm.half), (arm.radius, -arm.half), (arm.radius, arm.half), (arm.inner, arm.half))
    return Path(tuple(axis.on(MM * (x * along + y * across)) for x, y in corners), Layer.HIDDEN, closed=True)


def _leader(drawn: Drawn, axis: SheetAxis, words: str, tolerance: GeometricTolerance | None) -> Iterator[Entity]:
    """Yield what is said of the holes for pins, beside the one on top, clear of the plate."""
    eye, reach = drawn.eyes[0], axis.scale * MM * max(own.body.radius for _, _, own in drawn.plates)
    middle = axis.on(complex(cmath.rect(MM * eye.radius, eye.angle)))
    target = middle + cmath.rect(axis.scale * MM * drawn.cage.pin_diameter / 2.0, math.pi / 4.0)
    level = axis.origin.imag + reach + KNEE
    knee = complex(target.real + (level - target.imag), level)
    written = Words(knee + 2.0 + 1.0j, words, TEXT, "left", layer=Layer.DIMENSION)
    yield Path((target, knee, knee + 4.0 + written.length), Layer.DIMENSION)
    yield written
    if tolerance is not None:
        yield from tolerance_frame(knee + 2.0 - 1j * (1.5 + HIGH / 2.0), tolerance)


# ----------------------------------------------------------------------------------------------------------------------
# How true the pins of a carrier stand, and what that makes of the load of a planet.
# ----------------------------------------------------------------------------------------------------------------------


PLACE_GRADE = 6
"""Of the zone in which the axis of a pin lies, over the radius of the pin circle; assumed."""
MESH_STIFFNESS = 20e9
"""Of steel teeth over their width [N/m²]: 20 N/(mm µm), the mean value of ISO 6336-1 for c_γ, from memory."""


class PinPlaces(NamedTuple):
    """Where the axes of pins may stand."""

    zone: float | None
    """Diameter of the zone about the true place [m]; None beyond the sizes of ISO 286-1."""
    origin: str
    """Where it comes from, as a note says it."""
    asked: float
    """K_γ that the stage is rated with [-]."""
    is_simple: bool = False
    """Whether the closed form holds for its set: three planets or more around one sun."""
    floating: float | None = None
    """K_γ with one pin at the edge of its zone, where a member floats [-]; None where planets lose all load."""
    fixed: float | None = None
    """The same where none does [-]."""


class _Set(NamedTuple):
    """What the closed form asks of a set."""

    planets: int
    force: float
    stiffness: tuple[float, float]
    angle: float


def pin_places(sizing: Sizing, carrier: CarrierSizing) -> PinPlaces:
    """Return in which zone the pins of a carrier stand: by the design's errors, else so that K_γ is kept, at most IT6.

    Args:
        sizing: What was sized.
        carrier: Of it.

    Source: Ligata, Kahraman & Singh 2009 by `gearwright.parts.planetary.pin_error_share`; zones by ISO 286-1.
    """
    set_, asked = _set_of(sizing, carrier), sizing.design.rules(carrier.stage).mesh_load_factor or 1.0
    # The largest error of a pin that the design has [m].
    count = max(gear.bodies for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET)
    names = [str(gear_part(carrier.stage, Role.PLANET, number=k)) for k in range(1, count + 1)]
    rows = [sizing.design.errors[name] for name in names if name in sizing.design.errors]
    errors = max((math.hypot(row.pin_tangential, row.pin_radial) for row in rows), default=0.0)
    fits = SMALLEST < carrier.radius <= LARGEST
    zone = standard_tolerance(carrier.radius, PLACE_GRADE) if fits else None
    origin = f"IT{PLACE_GRADE} of the pin circle's radius (assumed)"
    if errors:
        zone, origin = 2.0 * errors, "twice the largest error of a pin in [errors]"
    elif set_ is not None and asked > 1.0 and zone is not None:
        kept = 2.0 * pin_error_within(set_.planets, asked, set_.force, stiffness=set_.stiffness,
                                      pressure_angle=set_.angle, floating=True)  # fmt: skip
        if kept < zone:
            zone, origin = math.floor(1e6 * kept) / 1e6, f"keeps K_{{γ}} = {asked:g} of the design, if a member floats"
    if set_ is None or not zone:
        return PinPlaces(zone or None, origin, asked)
    floating, fixed = (_factor(set_, zone / 2.0, floating=way) for way in (True, False))
    return PinPlaces(zone, origin, asked, is_simple=True, floating=floating, fixed=fixed)


def _set_of(sizing: Sizing, carrier: CarrierSizing) -> _Set | None:
    """Return what the closed form asks; None of compound sets, fewer than three planets, and without load."""
    planetary = sizing.design.planetaries.get(carrier.stage)
    if planetary is None or planetary.planets < 3 or not carrier.torque:
        return None
    rows = [mesh for mesh in sizing.meshes if mesh.stage == carrier.stage]
    width = next(gear.face_width for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET)
    angle = sum(row.working_pressure_angle for row in rows) / len(rows)
    stiffness = MESH_STIFFNESS * width
    return _Set(planetary.planets, carrier.torque / carrier.radius, (stiffness, stiffness), angle)


def _factor(set_: _Set, error: float, *, floating: bool) -> float | None:
    """Return K_γ; None where a neighbour would lose more than its load, which the closed form does not know."""
    count, free = set_.planets, 3 if floating else 1
    factor = count * pin_error_share(
        count, error, set_.force, stiffness=set_.stiffness, pressure_angle=set_.angle, floating=floating
    )
    if count == free:
        return factor
    loss = (factor - 1.0) / (count - free) * (1.0 + 2.0 * math.cos(2.0 * math.pi / count) if floating else 1.0)
    return factor if loss <= 1.0 else None


# ----------------------------------------------------------------------------------------------------------------------
# The sheet of one carrier: section through a pin, end view, sizes, how true pins stand.
# ----------------------------------------------------------------------------------------------------------------------


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
    zone = None if places.zone is None else GeometricTolerance("position", MM * places.zone, letter)
    across = millimetres(MM * cage.pin_diameter)
    holes = f"{len(drawn.eyes)} × Ø{across} {PIN_FIT[0]}, {'evenly spaced' if is_even(drawn) else 'see table'}"

    def views(scale: float) -> Rows:
        axis = SheetAxis(0j, 1 + 0j, scale)
        side = [*section(drawn, axis), *section_dimensions(drawn, axis, (f" {'/'.join(PIN_FIT)}", ""), letter=letter)]
        return [[side, end_view(drawn, axis, holes, zone)]]

    notes = (*_notes(sizing, carrier, drawn), *_shared(places), *_assumed(cage))
    grids = (SheetTable(f"Carrier {carrier.stage}", tuple(_rows(sizing, carrier, drawn))), *_unequal(drawn))
    return Content(name, title, views, grids, notes, kind="carrier")


def _unequal(drawn: Drawn) -> Iterator[SheetTable]:
    """Yield where every pin stands, where they are not evenly spaced on one circle."""
    if not is_even(drawn):
        rows = tuple((str(k), f"{trimmed(angle, 4)}°", millimetres(2.0 * radius))
                     for k, (angle, radius) in enumerate(places_of(drawn), start=1))  # fmt: skip
        yield SheetTable("Pins, the first on top, counter-clockwise", rows, ("Pin", "Angle", "Circle Ø"))


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
