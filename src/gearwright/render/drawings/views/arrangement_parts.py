"""What a general arrangement draws of each part, and where its item number points."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from gearwright.identity import Role, gear_part
from gearwright.ranking import largest
from gearwright.render.drawings.sheet.entities import Entity, Hatch, Layer, Path
from gearwright.render.drawings.views.bearing_view import bearing_section
from gearwright.render.drawings.views.face_view import face_section, face_teeth, is_face_wheel, toward_pinion
from gearwright.render.drawings.views.gear_parts import Hub, hub_of
from gearwright.render.drawings.views.gear_view import (
    bell_anchor,
    bell_section,
    bevel_corners,
    bevel_section,
    cylinder_section,
    keeper_section,
    ring_section,
    seat_section,
)
from gearwright.render.drawings.views.holder_view import holder_anchor, holder_section
from gearwright.render.drawings.views.laid.beside import Lying
from gearwright.render.drawings.views.positions import PLATE_GAP, Positions
from gearwright.render.drawings.views.shaft_parts import (
    MM,
    Piece,
    ShaftBody,
    away_of,
    bevel_profile,
    shaft_body,
)
from gearwright.render.drawings.views.shaft_view import Axis, shaft_outline
from gearwright.render.drawings.views.weights import made_of, mass_with_gears
from gearwright.shape.teeth import cylindrical_gear, halves_of, is_internal, kind_of
from gearwright.sizing import CarrierSizing, GearSizing, Sizing
from gearwright.sizing.casing import RingSeat, ring_seats
from gearwright.sizing.mass import Cage, bell_name, cage_of, ring_outside, seat_names
from gearwright.sizing.places import bells, runs
from gearwright.sizing.shafts import holders_of
from gearwright.spec import GROUND

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


def axis_of(lying: Lying, scale: float) -> Axis:
    """Return where a shaft lies on the sheet.

    Args:
        lying: In the plane.
        scale: mm of paper per mm [-].
    """
    return Axis(scale * lying.origin, lying.along, scale)


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


def _free(axis: Axis, body: ShaftBody) -> complex:
    """Return a point of a shaft where nothing sits on it, or that of its longest piece."""
    free = [piece for piece in body.pieces if not piece.seat] or list(body.pieces)
    longest = largest(free, lambda piece: piece.end - piece.start)
    return axis.at(longest.start + 0.3 * (longest.end - longest.start), 0.3 * longest.diameter)


def gear_parts(sizing: Sizing, gear: GearSizing, axis: Axis, *, shaft: str, middle: float, lean: float) -> list[Entity]:
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
        moved = Axis(axis.at(middle), axis.along, axis.scale)
        return bevel_section(moved, bevel_profile(sizing, gear), hub, away=away_of(sizing, gear), lean=lean)
    if is_face_wheel(sizing, gear):
        moved = Axis(axis.at(middle), axis.along, axis.scale)
        return face_section(sizing, gear, hub, moved, toward=toward_pinion(sizing, gear, shaft), lean=lean)
    half = MM * gear.face_width * halves_of(gear) / 2.0
    span = (middle - half, middle + half)
    teeth = cylindrical_gear(sizing, gear)
    if is_internal(sizing, gear):
        return ring_section(axis, teeth, MM * ring_outside(sizing, gear), span, lean=lean)
    return cylinder_section(axis, teeth, hub, span, lean=lean)


def gear_item(sizing: Sizing, gear: GearSizing, axis: Axis, *, shaft: str, middle: float) -> Item:
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
        pin_axis = Axis(axis.at(0.0, up * MM * carrier.radius), axis.along, scale)
        entities += cylinder_section(
            pin_axis, cylindrical_gear(sizing, planet), hub, (middle - half, middle + half), lean=lean
        )
    side = _towards(plane, planetary.carrier, middle, plane.places[shaft].get(str(carrier.part), middle))
    cage = cage_of(sizing, carrier, runs(sizing)[0])
    entities += _carrier(axis, carrier, cage, middle, half=half, side=side)
    teeth, bore = cylindrical_gear(sizing, planet), max(hub.bore / 2.0, MM * carrier.pin_diameter / 2.0)
    anchor = axis.at(middle - 0.3 * half, MM * carrier.radius + 0.1 * bore + 0.9 * MM * teeth.root_radius)
    for up in (1.0, -1.0):
        pin_axis = Axis(axis.at(0.0, up * MM * carrier.radius), axis.along, scale)
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


def _seated(sizing: Sizing, item: Item, seat: RingSeat, axis: Axis, middle: float) -> Iterator[Item]:
    """Yield the item of a ring with the splines on its outside, and that of the ring that keeps it in the housing."""
    teeth, keeper = (made_of(sizing).weights.get(name) for name in seat_names(seat.ring))
    yield replace(item, remark=f"{item.remark}, W {seat.name}", mass=(item.mass or 0.0) + (teeth or 0.0))
    low, high = seat.keeper
    size = f"Ø{2.0 * MM * seat.outside:.4g} / Ø{2.0 * MM * seat.clear:.4g} x {MM * (high - low):.4g}, screwed"
    anchor = axis.at(middle + MM * (low + high) / 2.0, -MM * (seat.outside + seat.clear) / 2.0)
    yield Item(f"Keeper of {seat.ring.name}", size, 1, keeper, anchor)


def _turning(axis: Axis, pin: float, bore: float, span: tuple[float, float]) -> Iterator[Entity]:
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
    axis: Axis, carrier: CarrierSizing, cage: Cage, middle: float, *, half: float, side: float
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
