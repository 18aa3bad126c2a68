"""What a general arrangement draws of each part: gears, bearings, what holds them; and the view of the end."""

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice, pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Role, gear_part, largest
from gearwright.catalogue import Bearing
from gearwright.parts.bearings import BearingKind
from gearwright.render.drawings.entities import (
    SMALL,
    Arc,
    Distance,
    Entity,
    Hatch,
    Layer,
    Path,
    Words,
    extent,
    words_length,
)
from gearwright.render.drawings.gear_view import (
    Hub,
    bell_anchor,
    bell_section,
    bevel_corners,
    bevel_section,
    cylinder_section,
    face_section,
    face_teeth,
    hub_of,
    is_face_wheel,
    keeper_section,
    ring_section,
    seat_section,
    toward_pinion,
)
from gearwright.render.drawings.paper import Segment, clear_of, segments
from gearwright.render.drawings.positions import PLATE_GAP, Lying, Positions
from gearwright.render.drawings.shaft_view import (
    MM,
    OVERSHOOT,
    Piece,
    ShaftBody,
    SheetAxis,
    away_of,
    bevel_profile,
    made_of,
    mass_with_gears,
    shaft_body,
    shaft_outline,
)
from gearwright.render.style import overlap
from gearwright.shape.chambers import Leg, spans_in, without
from gearwright.shape.stands import cylindrical_gear, halves_of, is_internal, kind_of, stands_of
from gearwright.sizing import CarrierSizing, GearSizing, Sizing
from gearwright.sizing.casing import RingSeat, ring_seats
from gearwright.sizing.mass import Cage, bell_name, cage_of, ring_outside, seat_names
from gearwright.sizing.places import bells, runs
from gearwright.sizing.shafts import Holder, holders_of
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# Rolling bearings in section, simplified: boundary dimensions, rings, and the elements that their ratings assume.
# ----------------------------------------------------------------------------------------------------------------------


SHOULDER = 0.5
"""Height of shoulders and lips over the middle of the rolling elements, in their radii [-]; drawn only."""
_FINE = 1.5
"""Between hatching lines [mm]."""


def bearing_section(axis: SheetAxis, bearing: Bearing, middle: float, *, opens: float) -> list[Entity]:
    """Return a bearing in section, both halves.

    Args:
        axis: Of its shaft.
        bearing: From the catalogue.
        middle: Of its width along the shaft [mm].
        opens: +1 where the raceways of a taper bearing widen towards the second end, −1 towards the first [-].
    """
    draw = {BearingKind.CYLINDRICAL: _cylindrical, BearingKind.TAPER: _taper}.get(bearing.kind, _ball)
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        for part in draw(bearing, opens):
            entities += _placed(axis, part, middle, side)
    return entities


def _placed(axis: SheetAxis, part: Entity, middle: float, side: float) -> Iterator[Entity]:
    """Yield a part of the upper half, about the middle of the bearing in mm, on its shaft."""

    def at(point: complex) -> complex:
        return axis.at(middle + point.real, side * point.imag)

    match part:
        case Path():
            yield Path(tuple(at(point) for point in part.points), part.layer, part.closed)
        case Arc():
            yield Arc(at(part.centre), part.radius * axis.scale, part.layer)
        case Hatch():
            yield Hatch(tuple(at(point) for point in part.points), part.angle + cmath.phase(axis.along), _FINE)


def _ring(corners: Sequence[complex], *, inner: bool) -> Iterator[Entity]:
    yield Hatch(tuple(corners), math.radians(135.0 if inner else 45.0))
    yield Path(tuple(corners), Layer.OUTLINE, closed=True)


def _sizes(bearing: Bearing) -> tuple[float, float, float, float, float]:
    """Return bore, outside and pitch radius, half width and radius of the rolling elements [mm]."""
    inside = bearing.geometry
    return (
        MM * bearing.bore / 2.0, MM * bearing.outer_diameter / 2.0, MM * inside.pitch_diameter / 2.0,
        MM * bearing.width / 2.0, MM * inside.diameter / 2.0,
    )  # fmt: skip


def _ball(bearing: Bearing, opens: float) -> Iterator[Entity]:
    del opens
    bore, outside, pitch, half, ball = _sizes(bearing)
    angle = math.acos(SHOULDER)
    for wall, side, inner in ((bore, -1.0, True), (outside, 1.0, False)):
        groove = [complex(0.0, pitch) + ball * 1j * side * cmath.rect(1.0, angle * (1.0 - k / 8.0)) for k in range(17)]
        shoulder = pitch + side * SHOULDER * ball
        first = math.copysign(half, groove[0].real)
        corners = [
            complex(-first, wall),
            complex(first, wall),
            complex(first, shoulder),
            *groove,
            complex(-first, shoulder),
        ]
        yield from _ring(corners, inner=inner)
    yield Arc(complex(0.0, pitch), ball, Layer.OUTLINE)
    if bearing.kind is BearingKind.FOUR_POINT:
        yield Path((complex(0.0, bore), complex(0.0, pitch - ball)), Layer.OUTLINE)


def _cylindrical(bearing: Bearing, opens: float) -> Iterator[Entity]:
    del opens
    bore, outside, pitch, half, roller = _sizes(bearing)
    length = MM * bearing.geometry.roller_length / 2.0
    low, high, lip = pitch - roller, pitch + roller, pitch + SHOULDER * roller
    yield from _ring([complex(-half, bore), complex(half, bore), complex(half, low), complex(-half, low)], inner=True)
    cup = [
        complex(-half, outside), complex(half, outside), complex(half, lip), complex(length, lip),
        complex(length, high), complex(-length, high), complex(-length, lip), complex(-half, lip),
    ]  # fmt: skip
    yield from _ring(cup, inner=False)
    yield from _roller(complex(0.0, pitch), length, roller, 0.0)


def _taper(bearing: Bearing, opens: float) -> Iterator[Entity]:
    bore, outside, pitch, half, roller = _sizes(bearing)
    angle = opens * bearing.geometry.contact_angle
    length = MM * bearing.geometry.roller_length / 2.0
    rise = math.tan(angle)
    for wall, side, inner in ((bore, -1.0, True), (outside, 1.0, False)):
        ends = [pitch + side * roller / math.cos(angle) + x * rise for x in (half, -half)]
        kept = [max(end, wall + 0.5) if inner else min(end, wall - 0.5) for end in ends]
        yield from _ring(
            [complex(-half, wall), complex(half, wall), complex(half, kept[0]), complex(-half, kept[1])], inner=inner
        )
    yield from _roller(complex(0.0, pitch), length, roller, angle)


def _roller(middle: complex, length: float, radius: float, angle: float) -> Iterator[Entity]:
    turn = cmath.rect(1.0, angle)
    corners = [
        middle + turn * complex(x, y)
        for x, y in ((-length, -radius), (length, -radius), (length, radius), (-length, radius))
    ]
    yield Path(tuple(corners), Layer.OUTLINE, closed=True)
    yield Path((middle - turn * 1.25 * length, middle + turn * 1.25 * length), Layer.CENTRE)


# ----------------------------------------------------------------------------------------------------------------------
# Parts that hold bearings in section: rings, nuts, end plates, spacers, covers and the radial seals in them.
# ----------------------------------------------------------------------------------------------------------------------


_FINE_HOLDER = 1.0
"""Between hatching lines [mm]."""
LEANS = {"spacer": 60.0, "housing spacer": 120.0, "cover": 30.0, "radial seal": 75.0}
"""Kind -> lean of its hatching [°]: unlike that of the rings beside it; of all else 150."""
SEAL = (
    (0.0, 1.0), (1.0, 1.0), (1.0, 0.76), (0.32, 0.76), (0.32, 0.58), (0.5, 0.46), (0.86, 0.44), (0.86, 0.2),
    (0.62, 0.0), (0.3, 0.26), (0.0, 0.34),
)  # fmt: skip
"""Corners of a seal's section: along from its air side over its width, up from the shaft over its height [-]."""
SPRING, SPRING_RADIUS = (0.68, 0.34), 0.1
"""Middle and radius of its spring, likewise."""


def holder_section(axis: SheetAxis, holder: Holder) -> list[Entity]:
    """Return a part in section, both halves.

    Args:
        axis: Of its shaft.
        holder: The part.
    """
    lean = math.radians(LEANS.get(holder.kind, 150.0))
    outside = [point for ring in holder.rings for point in ((ring.start, ring.outer), (ring.end, ring.outer))]
    inside = [point for ring in holder.rings for point in ((ring.start, ring.bore), (ring.end, ring.bore))]
    around = [complex(MM * place, MM * diameter / 2.0) for place, diameter in (*outside, *reversed(inside))]
    spring: tuple[complex, float] | None = None
    if holder.lip:
        around, spring = _seal(holder)
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        corners = tuple(axis.at(point.real, side * point.imag) for point in around)
        entities += [Hatch(corners, lean, _FINE_HOLDER), Path(corners, Layer.OUTLINE, closed=True)]
        if spring is not None:
            middle, radius = spring
            entities.append(Arc(axis.at(middle.real, side * middle.imag), radius * axis.scale, Layer.THIN))
    return entities


def _seal(holder: Holder) -> tuple[list[complex], tuple[complex, float]]:
    """Return the section of a radial seal of type A, and middle and radius of its spring [mm]; a form as drawn."""
    width, low, high = MM * (holder.end - holder.start), MM * holder.bore / 2.0, MM * holder.outer / 2.0
    air = MM * (holder.start if holder.lip > 0 else holder.end)

    def at(along: float, up: float) -> complex:
        return complex(air + holder.lip * along * width, low + up * (high - low))

    return [at(*point) for point in SEAL], (at(*SPRING), SPRING_RADIUS * (high - low))


def holder_anchor(axis: SheetAxis, holder: Holder) -> complex:
    """Return where the item number of a part points.

    Args:
        axis: Of its shaft.
        holder: The part.
    """
    if holder.lip:
        width, height = holder.end - holder.start, holder.outer - holder.bore
        air = holder.start if holder.lip > 0 else holder.end
        return axis.at(MM * (air + holder.lip * 0.16 * width), MM * (holder.bore + 0.72 * height) / 2.0)
    ring = max(holder.rings, key=lambda one: (one.outer, one.end - one.start))
    return axis.at(MM * (ring.start + ring.end) / 2.0, MM * (ring.bore + 3.0 * ring.outer) / 8.0)


# ----------------------------------------------------------------------------------------------------------------------
# What a general arrangement draws of each part, and where its item number points.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_RING = 0.5
"""Room between pin and planet, and metal around a pin, below which nothing is drawn [mm]."""
CARRIER_LEAN = math.radians(60.0)
"""Of the hatching of carriers [rad]: unlike that of gears."""


@dataclass(frozen=True)
class Item:
    """A part of the arrangement."""

    part: str
    """What it is called in the list of parts."""
    remark: str
    """Designation, material, or what it is one piece with."""
    count: int
    mass: float | None
    """Of one [kg]."""
    anchor: complex
    """Where its number points [mm of paper]."""


def axis_of(lying: Lying, scale: float) -> SheetAxis:
    """Return where a shaft lies on the sheet.

    Args:
        lying: In the plane.
        scale: mm of paper per mm [-].
    """
    return SheetAxis(scale * lying.origin, lying.along, scale)


def shaft_parts(sizing: Sizing, plane: Positions, name: str, scale: float) -> tuple[list[Entity], list[Item]]:
    """Return a shaft, its gears and its bearings.

    Args:
        sizing: What was sized.
        plane: Where everything lies.
        name: Of the shaft.
        scale: mm of paper per mm [-].
    """
    lying = plane.shafts[name]
    axis, body = axis_of(lying, scale), shaft_body(sizing, name)
    entities: list[Entity] = []
    items: list[Item] = []
    drawn = _drawn_bodies(sizing, body)
    if drawn:
        for one in drawn:
            entities += shaft_outline(axis, one)
        remark, mass = ", ".join(f"with {gear}" for gear in body.gears), mass_with_gears(sizing, body.gears, name)
        items.append(Item(f"Shaft {name}", remark, 1, mass, _free(axis, drawn[0])))
    lean = math.pi / 4.0 * (1.0 if sizing.design.shafts.index(name) % 2 == 0 else 3.0)
    for gear in sizing.gears:
        if name in gear.shafts and gear.name not in body.gears:
            middle = plane.places[name][gear.name]
            entities += gear_parts(sizing, gear, axis, shaft=name, middle=middle, lean=lean)
            items.append(gear_item(sizing, gear, axis, shaft=name, middle=middle))
    for bell in bells(sizing):
        if name in bell.ring.shafts:
            entities += bell_section(axis, bell, lean=math.pi - lean)
            of, weighed = bell.ring.name, made_of(sizing).weights.get(bell_name(bell.ring))
            items.append(Item(f"Bell of {of}", f"to shaft {name}", 1, weighed, axis.on(bell_anchor(bell))))
    for bearing in sizing.bearings:
        if bearing.shaft == name:
            seat = sizing.design.bearings.get(bearing.name)
            opens = -1.0 if seat is not None and seat.locates == "second" else 1.0
            middle = MM * bearing.position
            entities += bearing_section(axis, bearing.bearing, middle, opens=opens)
            rolling = bearing.bearing
            radius = MM * (rolling.outer_diameter / 2.0 - 0.15 * (rolling.outer_diameter - rolling.bore) / 2.0)
            anchor = axis.at(middle, radius)
            items.append(Item(f"Bearing {bearing.name}", rolling.designation, 1, rolling.mass, anchor))
    for holder in holders_of(sizing):
        if holder.shaft == name:
            entities += holder_section(axis, holder)
            remark = (
                holder.designation
                or f"Ø{MM * holder.outer:.4g} / Ø{MM * holder.bore:.4g} x {MM * (holder.end - holder.start):.4g}"
            )
            items.append(Item(holder.kind.capitalize(), remark, 1, holder.mass, holder_anchor(axis, holder)))
    return entities, items


def _drawn_bodies(sizing: Sizing, body: ShaftBody) -> list[ShaftBody]:
    """Return a shaft as the arrangement draws it: of a first sizing the cylinders that its solid has, or none."""
    if any(shaft.name == body.name for shaft in sizing.built_shafts):
        return [body]
    pieces = [
        tuple(Piece(MM * start, MM * end, (2.0 * MM * radius,) * 2) for start, end, radius in run.steps)
        for run in runs(sizing)[0]
        if run.shaft == body.name
    ]
    return [ShaftBody(body.name, steps, body.bore) for steps in pieces if steps[0].diameter > 0.0]


def _free(axis: SheetAxis, body: ShaftBody) -> complex:
    """Return a point of a shaft where nothing sits on it, or that of its longest piece."""
    free = [piece for piece in body.pieces if not piece.seat] or list(body.pieces)
    longest = largest(free, lambda piece: piece.end - piece.start)
    return axis.at(longest.start + 0.3 * (longest.end - longest.start), 0.3 * longest.diameter)


def gear_parts(
    sizing: Sizing, gear: GearSizing, axis: SheetAxis, *, shaft: str, middle: float, lean: float
) -> list[Entity]:
    """Return a gear in section on its shaft.

    Args:
        sizing: What was sized.
        gear: Not one piece with its shaft.
        axis: Of the shaft.
        shaft: That carries it.
        middle: Of the face along the shaft [mm].
        lean: Of the hatching [rad].
    """
    full = hub_of(sizing, gear, shaft)
    hub = Hub(full.bore, boss=full.boss, web=full.web, way=full.way)
    if kind_of(sizing, gear.stage) == "bevel":
        moved = SheetAxis(axis.at(middle), axis.along, axis.scale)
        return bevel_section(moved, bevel_profile(sizing, gear), hub, away=away_of(sizing, gear), lean=lean)
    if is_face_wheel(sizing, gear):
        moved = SheetAxis(axis.at(middle), axis.along, axis.scale)
        return face_section(sizing, gear, hub, moved, toward=toward_pinion(sizing, gear, shaft), lean=lean)
    half = MM * gear.face_width * halves_of(gear) / 2.0
    span = (middle - half, middle + half)
    teeth = cylindrical_gear(sizing, gear)
    if is_internal(sizing, gear):
        return ring_section(axis, teeth, MM * ring_outside(sizing, gear), span, lean=lean)
    return cylinder_section(axis, teeth, hub, span, lean=lean)


def gear_item(sizing: Sizing, gear: GearSizing, axis: SheetAxis, *, shaft: str, middle: float) -> Item:
    """Return the item of a gear.

    Args:
        sizing: What was sized.
        gear: The gear.
        axis: Of its shaft.
        shaft: That carries it.
        middle: Of its face along the shaft [mm].
    """
    return Item(
        f"Gear {gear.name}",
        _toothing(gear),
        1,
        made_of(sizing).weights[gear.name],
        axis.on(middle + _metal(sizing, gear, shaft)),
    )


def _metal(sizing: Sizing, gear: GearSizing, shaft: str) -> complex:
    """Return a point in the section of a gear, from the middle of its face [mm]."""
    hub, root = hub_of(sizing, gear, shaft), MM * abs(cylindrical_gear(sizing, gear).root_radius)
    if kind_of(sizing, gear.stage) == "bevel":
        rim = sum(bevel_corners(bevel_profile(sizing, gear), hub)[:3]) / 3.0
        return complex(away_of(sizing, gear) * rim.real, rim.imag)
    if is_face_wheel(sizing, gear):
        teeth = face_teeth(sizing, gear)
        return complex(-toward_pinion(sizing, gear, shaft) * 1.5 * teeth.root, sum(teeth.reach) / 2.0)
    if is_internal(sizing, gear):
        return complex(0.2 * MM * gear.face_width, (root + MM * ring_outside(sizing, gear)) / 2.0)
    inner = hub.reach / 2.0 if hub.web is None else hub.web.rim
    return complex(0.2 * MM * gear.face_width, root - min(0.3 * root, (root - inner) / 2.0))


def _toothing(gear: GearSizing) -> str:
    return f"z = {gear.teeth}, m = {MM * gear.module:.4g}"


def planetary_parts(
    sizing: Sizing, stage: str, plane: Positions, scale: float, *, lean: float
) -> tuple[list[Entity], list[Item]]:
    """Return planets, their carrier and what stands still of a planetary set.

    Args:
        sizing: What was sized.
        stage: The set.
        plane: Where everything lies.
        scale: mm of paper per mm [-].
        lean: Of the hatching [rad].
    """
    planetary = sizing.design.planetaries[stage]
    shaft = next(name for name in (planetary.sun, planetary.ring, planetary.carrier) if name != GROUND)
    axis, middle = axis_of(plane.shafts[shaft], scale), plane.places[shaft][str(gear_part(stage, Role.PLANET))]
    gears = {gear.role: gear for gear in sizing.gears if gear.stage == stage}
    carrier = next(carrier for carrier in sizing.carriers if carrier.stage == stage)
    planet, half = gears[Role.PLANET], MM * gears[Role.PLANET].face_width / 2.0
    full = hub_of(sizing, planet, planet.shafts[0])
    hub = Hub(full.bore, web=full.web)
    entities: list[Entity] = []
    for up in (1.0, -1.0):
        pin_axis = SheetAxis(axis.at(0.0, up * MM * carrier.radius), axis.along, scale)
        entities += cylinder_section(
            pin_axis, cylindrical_gear(sizing, planet), hub, (middle - half, middle + half), lean=lean
        )
    side = _towards(plane, planetary.carrier, middle, plane.places[shaft].get(str(carrier.part), middle))
    cage = cage_of(sizing, carrier, runs(sizing)[0])
    entities += _carrier(axis, carrier, cage, middle, half=half, side=side)
    teeth, bore = cylindrical_gear(sizing, planet), max(hub.bore / 2.0, MM * carrier.pin_diameter / 2.0)
    anchor = axis.at(middle - 0.3 * half, MM * carrier.radius + 0.1 * bore + 0.9 * MM * teeth.root_radius)
    for up in (1.0, -1.0):
        pin_axis = SheetAxis(axis.at(0.0, up * MM * carrier.radius), axis.along, scale)
        entities += _turning(pin_axis, MM * carrier.pin_diameter / 2.0, bore, (middle - half, middle + half))
    items = [
        Item(f"Planet {planet.name}", _toothing(planet), planet.bodies, made_of(sizing).weights[planet.name], anchor)
    ]
    plate = middle + side * (half + PLATE_GAP + MM * carrier.plate_thickness / 2.0)
    whole, mass = _made(cage), made_of(sizing).weights[str(carrier.part)]
    items.append(Item(f"Carrier {stage}", whole, 1, mass, axis.at(plate, 0.6 * MM * carrier.radius)))
    return entities, items


def standing_ring(
    sizing: Sizing, ring: GearSizing, plane: Positions, scale: float, *, lean: float
) -> tuple[list[Entity], list[Item]]:
    """Return a ring that stands in the housing, with the splines on its outside and its keeper.

    Args:
        sizing: What was sized.
        ring: Of a set.
        plane: Where everything lies.
        scale: mm of paper per mm [-].
        lean: Of the hatching [rad].
    """
    shaft = next(name for name in sizing.design.sets[ring.stage].members if name != GROUND)
    axis, middle = axis_of(plane.shafts[shaft], scale), plane.places[shaft][ring.name]
    entities = gear_parts(sizing, ring, axis, shaft=GROUND, middle=middle, lean=lean)
    items = [gear_item(sizing, ring, axis, shaft=GROUND, middle=middle)]
    for seat in (seat for seat in ring_seats(sizing) if seat.ring is ring):
        entities += seat_section(axis, seat, middle, lean=lean)
        entities += keeper_section(axis, seat, middle, lean=math.pi - lean)
        items = list(_seated(sizing, items[0], seat, axis, middle))
    return entities, items


def _seated(sizing: Sizing, item: Item, seat: RingSeat, axis: SheetAxis, middle: float) -> Iterator[Item]:
    """Yield the item of a ring with the splines on its outside, and that of the ring that keeps it in the housing."""
    teeth, keeper = (made_of(sizing).weights.get(name) for name in seat_names(seat.ring))
    yield replace(item, remark=f"{item.remark}, W {seat.name}", mass=(item.mass or 0.0) + (teeth or 0.0))
    low, high = seat.keeper
    size = f"Ø{2.0 * MM * seat.outside:.4g} / Ø{2.0 * MM * seat.clear:.4g} x {MM * (high - low):.4g}, screwed"
    anchor = axis.at(middle + MM * (low + high) / 2.0, -MM * (seat.outside + seat.clear) / 2.0)
    yield Item(f"Keeper of {seat.ring.name}", size, 1, keeper, anchor)


def _turning(axis: SheetAxis, pin: float, bore: float, span: tuple[float, float]) -> Iterator[Entity]:
    """Yield what a planet turns on, as ISO 8826-1 has bearings: a box with an upright cross."""
    if bore - pin < LEAST_RING:
        return
    middle, half = (span[0] + span[1]) / 2.0, 0.2 * min(bore - pin, span[1] - span[0])
    for side in (1.0, -1.0):
        corners = ((span[0], pin), (span[1], pin), (span[1], bore), (span[0], bore))
        yield Path(tuple(axis.at(x, side * radius) for x, radius in corners), Layer.OUTLINE, closed=True)
        centre = side * (pin + bore) / 2.0
        yield Path((axis.at(middle - half, centre), axis.at(middle + half, centre)), Layer.THIN)
        yield Path((axis.at(middle, centre - half), axis.at(middle, centre + half)), Layer.THIN)


def _made(cage: Cage) -> str:
    """Return what a carrier consists of."""
    bridges = "" if cage.bridge is None else f", {cage.bridges} bridges"
    return f"{'two plates' if len(cage.plates) > 1 else 'plate'}, {cage.pins} pins{bridges}"


def _towards(plane: Positions, shaft: str, middle: float, plate: float) -> float:
    """Return the side on which a carrier's plate stands, or its shaft goes on: +1 towards the second end."""
    if plate != middle:
        return math.copysign(1.0, plate - middle)
    if shaft == GROUND:
        return 1.0
    lying = plane.shafts[shaft]
    return 1.0 if lying.end - middle >= middle - lying.start else -1.0


def _carrier(
    axis: SheetAxis, carrier: CarrierSizing, cage: Cage, middle: float, *, half: float, side: float
) -> Iterator[Entity]:
    """Yield the pins, uncut, and the plates beside the planets in section, from the hole for shafts outwards."""
    pin, outer = MM * carrier.pin_diameter / 2.0, MM * cage.plates[0].body.radius
    faces = []
    for way, plate in zip((side, -side), cage.plates, strict=False):
        near = middle + way * (half + PLATE_GAP)
        faces.append((near, near + way * MM * plate.body.length, MM * plate.bore))
    far = faces[0][1]
    last = faces[1][1] if len(faces) > 1 else middle - side * half
    for sign in (1.0, -1.0):
        radius = sign * MM * carrier.radius
        pins = [(last, -pin), (far, -pin), (far, pin), (last, pin)]
        yield Path(tuple(axis.at(x, radius + r) for x, r in pins), Layer.OUTLINE, closed=True)
        ends = (last - side * 3.0, far + side * 3.0)
        yield Path((axis.at(ends[0], radius), axis.at(ends[1], radius)), Layer.CENTRE)
        for near, end, bore in faces:
            around = ((bore, MM * carrier.radius - pin), (MM * carrier.radius + pin, outer))
            for low, high in (room for room in around if room[1] - room[0] > LEAST_RING):
                box = ((near, low), (end, low), (end, high), (near, high))
                corners = tuple(axis.at(x, sign * r) for x, r in box)
                yield from (Hatch(corners, CARRIER_LEAN, 1.5), Path(corners, Layer.OUTLINE, closed=True))


# ----------------------------------------------------------------------------------------------------------------------
# A gearbox seen along its first shaft, where one section cannot show how all stands: gears at their true places.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 2.0
"""Between places of a name that are tried [mm]."""
TRIES = 30
"""Of them, each way [-]."""
BELOW = 8.0
"""From the view to the distance of its planets, and from each to the next [mm]."""
_ALONG = 1.0 - 1e-9
"""Share of an axis along the view from which on it lies along it [-]."""


class Outside(NamedTuple):
    """A housing as it is seen along the first shaft from its second end, y in space to the right, z upwards."""

    lines: tuple[Path, ...] = ()
    """Its edges [mm]."""
    covers: tuple[Floats, ...] = ()
    """Convex loops that fill what it covers [m], shape (n, 2) each."""
    way: tuple[complex, ...] = ()
    """Corners of an unfolded section, from end to end [mm]."""


def end_view(sizing: Sizing, scale: float, outside: Outside, *, turned: bool) -> list[Entity]:
    """Return a gearbox seen along the first shaft, from its second end.

    Gears whose axes lie along the view, planets too, are their pitch circles; of those across it the outlines of the
    bodies are seen, dashed where the housing covers them.

    Args:
        sizing: What was sized; all axes along the first shaft or square to it.
        scale: mm of paper per mm [-].
        outside: The housing; empty where none is drawn.
        turned: Whether the view is turned by half a turn.
    """
    entities: list[Entity] = [
        replace(line, points=tuple(scale * point for point in line.points)) for line in outside.lines
    ]
    if outside.way:
        entities.append(Path(tuple(scale * point for point in outside.way), Layer.CENTRE))
    frames, axes = sizing.arrangement.frames, dict[complex, list[str]]()
    along = [name for name in frames if abs(frames[name].along[0]) > _ALONG]
    for name in along:
        y, z = (round(scale * MM * coordinate, 6) for coordinate in frames[name].origin[1:])
        axes.setdefault(complex(y, z), []).append(name)
    circles = _pitch_circles(sizing, scale)
    for middle in dict.fromkeys((*axes, *circles)):
        radii = circles.get(middle, set())
        entities += [Arc(middle, radius, Layer.PITCH) for radius in sorted(radii)]
        reach = max(radii, default=0.0) + OVERSHOOT if middle in axes else OVERSHOOT
        entities += [Path((middle - way, middle + way), Layer.CENTRE) for way in (reach, 1j * reach)]
    several = len(axes) > 1 or len(along) < len(frames)
    names_of = [(middle, ", ".join(shafts)) for middle, shafts in axes.items() if several]
    for name in frames:
        if name not in along:
            entities += _across(sizing, name, scale, outside.covers)
            names_of.append((_seen(frames[name].origin, scale), name))
    if turned:
        entities, names_of = _upside_down(entities), [(-middle, name) for middle, name in names_of]
    entities += names_beside(names_of, list(segments(entities)))
    return [*entities, *_planet_distances(sizing, scale, extent(entities)[1], -1.0 if turned else 1.0)]


def _planet_distances(sizing: Sizing, scale: float, low: float, sense: float) -> Iterator[Distance]:
    """Yield the distance of planets from the axis of their set, below the view, of sets with one beside their axis."""
    stands = stands_of(sizing)
    for row, carrier in enumerate(sizing.carriers, start=1):
        middle = next(stand.axes for stand in stands if stand.gear.stage == carrier.stage and not stand.carrier)
        if abs(float(middle.along[0])) <= _ALONG:
            continue
        foot = sense * _seen(middle.origin.tolist(), scale)
        planets = [sense * _seen(stand.axes.origin.tolist(), scale) for stand in stands
                   if stand.carrier and stand.gear.stage == carrier.stage]  # fmt: skip
        level = [place for place in planets if abs(place.imag - foot.imag) < 1e-6]
        if level:
            yield Distance(foot, level[0], complex(0.0, low - BELOW * row), 0.0, scale)


def _pitch_circles(sizing: Sizing, scale: float) -> dict[complex, set[float]]:
    """Return axis along the view -> radii of the pitch circles about it, also of planets [mm of paper]."""
    found: dict[complex, set[float]] = {}
    for stand in stands_of(sizing):
        if abs(float(stand.axes.along[0])) > _ALONG:
            y, z = (round(scale * MM * float(coordinate), 6) for coordinate in stand.axes.origin[1:])
            found.setdefault(complex(y, z), set()).add(scale * MM * stand.gear.pitch_diameter / 2.0)
    return found


def is_turned(sizing: Sizing, shafts: Mapping[str, Lying]) -> bool:
    """Tell whether the section has shafts across the first one upside down, as the view along it has to, then.

    Args:
        sizing: What was sized.
        shafts: As the section has them.
    """
    frames = sizing.arrangement.frames
    return sum(frames[name].along.z * lying.along.imag for name, lying in shafts.items()) < 0.0


def _upside_down(entities: Sequence[Entity]) -> list[Entity]:
    """Return circles and lines turned by half a turn."""
    turned: list[Entity] = []
    for mark in entities:
        if isinstance(mark, Arc):
            turned.append(replace(mark, centre=-mark.centre))
        elif isinstance(mark, Path):
            turned.append(replace(mark, points=tuple(-point for point in mark.points)))
    return turned


def is_square(sizing: Sizing) -> bool:
    """Tell whether every axis lies along the first shaft or square to it.

    Args:
        sizing: What was sized.
    """
    ways = [abs(frame.along[0]) for frame in sizing.arrangement.frames.values()]
    return all(way > _ALONG or way < 1.0 - _ALONG for way in ways)


def _across(sizing: Sizing, shaft: str, scale: float, covers: Sequence[Floats]) -> Iterator[Entity]:
    """Yield the outlines of the bodies on a shaft that lies across the view, and its axis."""
    for body in sizing.arrangement.bodies:
        if body.shaft != shaft or max(station.radius for station in body.stations) <= 0.0:
            continue
        way = complex(body.direction.y, body.direction.z)
        origin = _seen(body.origin, scale)
        upper = [(scale * MM * station.place, scale * MM * station.radius) for station in body.stations]
        corners = [*upper, *((place, -radius) for place, radius in reversed(upper))]
        outline = tuple(origin + way * complex(x, r) for x, r in corners)
        if not covers:
            yield Path(outline, Layer.THIN, closed=True)
        for start, end in pairwise([*outline, outline[0]] if covers else ()):
            yield from _parted(start, end, [scale * MM * loop for loop in covers])
    frame, plan = sizing.arrangement.frames[shaft], sizing.arrangement.plans[shaft]
    way = complex(*frame.along[1:])
    start = _seen(frame.origin, scale)
    end = start + way * scale * MM * plan.length
    yield Path((start - OVERSHOOT * way, end + OVERSHOOT * way), Layer.CENTRE)


def _parted(start: complex, end: complex, covers: Sequence[Floats]) -> Iterator[Path]:
    """Yield a line, dashed where loops cover it [mm of paper]."""
    length = abs(end - start)
    if length < 1e-6:
        return
    way = (end - start) / length
    leg = Leg(0.0, length, np.array([start.real, start.imag]), np.array([way.real, way.imag]))
    free = [(0.0, length)]
    for loop in covers:
        free = without(free, spans_in(loop, [leg]))
    for spans, layer in ((free, Layer.OUTLINE), (without([(0.0, length)], free), Layer.HIDDEN)):
        yield from (Path((start + low * way, start + high * way), layer) for low, high in spans)


def _seen(point: Sequence[float], scale: float) -> complex:
    """Return a point of space as the view has it [mm of paper]."""
    return scale * MM * complex(point[1], point[2])


def names_beside(named: Sequence[tuple[complex, str]], lines: Sequence[Segment]) -> list[Words]:
    """Return the names of shafts beside their axes, each at the nearest place that no line and no name crosses.

    A name for which there is no such place is left out: the table of axes has it.

    Args:
        named: Axes [mm of paper] with their names.
        lines: Of the view.
    """
    found: list[Words] = []
    for middle, name in named:
        wide = words_length(name, SMALL)
        ways = [complex(1.5 + STEP * k, side * (1.5 + STEP * j) - (side < 0.0) * SMALL)
                for k in range(TRIES) for j in range(TRIES) for side in (1.0, -1.0)]  # fmt: skip
        ways += [complex(-way.real - wide, way.imag) for way in ways]
        wanted = [Words(middle + way, name, SMALL) for way in sorted(ways, key=abs)]
        boxes = [extent([other]) for other in found]
        apart = (words for words in wanted if not any(overlap(extent([words]), box) for box in boxes))
        found += islice((words for words in apart if clear_of([_wider(words)], lines)), 1)
    return found


def _wider(words: Words) -> Words:
    """Return a text with air at both ends."""
    return replace(words, at=words.at - words_length("i", SMALL), text=f"i{words.text}i")
