"""Envelopes of gears, shafts, bearings, carrier plates and ring gear hubs at their places in space."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

import numpy as np

from gearwright.base import Kind, PartId, Role, carrier_part
from gearwright.memo import of_latest
from gearwright.parts.bevel_geometry import bevel_profile
from gearwright.parts.gears import revolved_volume
from gearwright.sizing.axis_order import PLATE_GAP, set_length, slots
from gearwright.sizing.gear_geometry import ring_radii
from gearwright.sizing.places.frames import apart_of, bevel_cones, frames_of, set_members, stand_into
from gearwright.sizing.rating import BACKUP, Context
from gearwright.sizing.result import Arrangement, Body, Frame, GearSizing, Point, Sizing, Station
from gearwright.sizing.shaft_results import BearingSizing, BuiltShaft, CarrierSizing, ShaftSizing
from gearwright.sizing.shafts import cut_steps
from gearwright.spec import GROUND, Design

# ----------------------------------------------------------------------------------------------------------------------
# The envelopes of all parts at their places in space: gears, free stretches of shafts, bearings, carriers.
#
# Gears are their tip circles over their face widths; a bevel gear is its teeth, about the hollow inside them, and the
# blank behind them with the rim that drawings assume. The wheel of a face gear is the ring of its teeth, whose tips lie
# in one plane, and a disc behind it. Planets are the ring that they sweep. Machines and housings have none.
# ----------------------------------------------------------------------------------------------------------------------


_THIN = 1e-6
"""Stretches of a shaft that are shorter are none [m]."""


@dataclass(frozen=True)
class Parts:
    """What is sized, and where its shafts lie."""

    context: Context
    gears: Mapping[str, GearSizing]
    shafts: Sequence[ShaftSizing]
    built: Sequence[BuiltShaft]
    bearings: Sequence[BearingSizing]
    carriers: Sequence[CarrierSizing]
    arrangement: Arrangement
    """For bodies, with its frames."""


def placed(parts: Parts) -> Arrangement:
    """Return the arrangement with every shaft and every body in space.

    Args:
        parts: What is sized, and the arrangement's axes and plans.
    """
    frames = frames_of(parts.context, parts.gears, parts.arrangement)
    apart = apart_of(parts.context, parts.gears, parts.arrangement, frames)
    arrangement = replace(parts.arrangement, frames=frames, apart=apart)
    return replace(arrangement, bodies=bodies_of(replace(parts, arrangement=arrangement)))


def bodies_of(parts: Parts) -> tuple[Body, ...]:
    """Return the envelope of every part.

    Args:
        parts: What is sized.
    """
    gears = [*_pair_gears(parts), *_set_gears(parts)]
    bearings = [_bearing(parts, bearing) for bearing in parts.bearings]
    carriers = [body for carrier in parts.carriers for body in _carrier(parts, carrier)]
    hollow = {outer for _, outer in parts.arrangement.within}
    if hollow:
        bores = {shaft.name: shaft.bore / 2.0 for shaft in parts.shafts if shaft.name in hollow}
        gears = [_bored(body, bores) for body in gears]
        carriers = [_bored(body, bores) for body in carriers]
    shafts = [body for shaft in parts.shafts for body in _shaft(parts, shaft, [*gears, *bearings], carriers)]
    return (*gears, *shafts, *bearings, *carriers)


def _bored(body: Body, bores: Mapping[str, float]) -> Body:
    """Return a body with the bore of the hollow shaft that it sits on."""
    return replace(body, bore=max(body.bore, bores.get(body.shaft, 0.0)))


def _at(frame: Frame, place: float) -> Point:
    return Point(*(origin + place * along for origin, along in zip(frame.origin, frame.along, strict=True)))


def _round(
    part: PartId,
    shaft: str,
    frame: Frame,
    circles: Sequence[tuple[float, float]],
    *,
    bore: float = 0.0,
    what: str = "",
) -> Body:
    """Return a body from circles along a shaft: place from the shaft's first end, radius [m]."""
    ordered = sorted(circles)
    start = ordered[0][0]
    stations = tuple(Station(place - start, radius) for place, radius in ordered)
    return Body(part, shaft, what, _at(frame, start), frame.along, stations, bore)


def _cylinder(
    part: PartId, shaft: str, frame: Frame, span: tuple[float, float], radius: float, *, bore: float = 0.0
) -> Body:
    return _round(part, shaft, frame, [(span[0], radius), (span[1], radius)], bore=bore)


def _tip(gear: GearSizing) -> float:
    return gear.pitch_diameter / 2.0 + gear.module * (1.0 + gear.profile_shift + gear.tip_alteration)


def _pair_gears(parts: Parts) -> Iterator[Body]:
    design, arrangement = parts.context.design, parts.arrangement
    for gear in parts.gears.values():
        if gear.stage not in design.pairs:
            continue
        for shaft in gear.shafts:
            frame, middle = arrangement.frames[shaft], arrangement.plans[shaft].places[gear.name]
            yield from _pair_gear(parts, gear, shaft, frame=frame, middle=middle)


def _pair_gear(parts: Parts, gear: GearSizing, shaft: str, *, frame: Frame, middle: float) -> Iterator[Body]:
    kind, part = parts.context.design.pairs[gear.stage].kind, gear.body(shaft)
    half = gear.face_width * gear.bodies / len(gear.shafts) / 2.0
    if kind == "bevel":
        yield from _bevel(parts, gear, shaft, frame=frame, middle=middle)
    elif gear.rim:
        outer, inner = gear.pitch_diameter / 2.0 + gear.rim, gear.pitch_diameter / 2.0 - 1.25 * gear.module
        yield _cylinder(part, shaft, frame, (middle - half, middle + half), outer, bore=inner)
    elif kind == "face" and gear.role is Role.WHEEL:
        yield from _face_wheel(parts, gear, shaft, frame=frame, middle=middle)
    else:
        yield _cylinder(part, shaft, frame, (middle - half, middle + half), _tip(gear))


def _face_wheel(parts: Parts, gear: GearSizing, shaft: str, *, frame: Frame, middle: float) -> Iterator[Body]:
    """Yield the teeth of a face gear, about its pitch circle and towards its pinion, and the disc behind them."""
    arrangement, part = parts.arrangement, gear.body(shaft)
    mesh = next(mesh for mesh in parts.context.train.meshes if mesh.stage == gear.stage and shaft in mesh.nodes[:2])
    mate = _at(arrangement.frames[mesh.nodes[0]], arrangement.plans[mesh.nodes[0]].places[mesh.gears[0]])
    off = sum((at - zero) * way for at, zero, way in zip(mate, _at(frame, middle), frame.along, strict=True))
    toward, radius = math.copysign(gear.module, off), gear.pitch_diameter / 2.0
    tip, root, back = (middle + toward * far for far in (1.0, -1.25, -1.25 - BACKUP * 2.25))
    outer, inner = radius + gear.face_width / 2.0, radius - gear.face_width / 2.0
    yield _round(part, shaft, frame, [(tip, outer), (root, outer)], bore=inner, what="teeth")
    yield _round(part, shaft, frame, [(root, outer), (back, outer)], what="blank")


def _bevel(parts: Parts, gear: GearSizing, shaft: str, *, frame: Frame, middle: float) -> Iterator[Body]:
    """Yield the teeth of a bevel gear, hollow inside the root at their small end, and its blank."""
    pair = parts.context.design.pairs[gear.stage]
    side = 0 if gear.role is Role.PINION else 1
    outline = bevel_profile(bevel_cones(parts.context, parts.gears, gear.stage), side)
    away = -1.0 if (pair.pinion_apex, pair.wheel_apex)[side] == "second" else 1.0
    small, large = outline.roots
    heel = large + BACKUP * (large - outline.large[0])
    for what, corners, bore in (
        ("teeth", (outline.small[0], outline.large[0], small, large), small.imag),
        ("blank", (small, large, heel), 0.0),
    ):
        circles = [(middle + away * corner.real, corner.imag) for corner in corners]
        yield _round(gear.body(shaft), shaft, frame, circles, bore=bore, what=what)


def _set_gears(parts: Parts) -> Iterator[Body]:
    design = parts.context.design
    for stage in design.sets:
        host, middle = next(set_members(parts.context, parts.gears, parts.arrangement, stage))
        frame, turned = parts.arrangement.frames[host], stage in parts.arrangement.turned
        lies = slots(parts.context, parts.gears, stage, turned=turned)
        own = [gear for gear in parts.gears.values() if gear.stage == stage]
        arm = next(carrier.radius for carrier in parts.carriers if carrier.stage == stage)
        for gear in own:
            at, half = middle + lies[gear.name], gear.face_width / 2.0
            span, shaft = (at - half, at + half), gear.shafts[0]
            if gear.rim:
                outer, inner = gear.pitch_diameter / 2.0 + gear.rim, gear.pitch_diameter / 2.0 - 1.25 * gear.module
                yield _cylinder(gear.part, shaft, frame, span, outer, bore=inner)
            elif gear.role is not Role.PLANET:
                yield _cylinder(gear.part, shaft, frame, span, _tip(gear))
            else:
                inner = max(arm - _tip(gear), 0.0)
                yield _cylinder(gear.part, shaft, frame, span, arm + _tip(gear), bore=inner)


def _carrier(parts: Parts, carrier: CarrierSizing) -> Iterator[Body]:
    """Yield the plate of a carrier beside the planets, on the sides on which its shaft leaves the set.

    A plate without a shaft that goes on stands away from the rings that do: a shaft passes a plate, a ring's web does
    not. It has a bore for the sun's shaft on its side, as far as its pins leave it.
    """
    members = dict(set_members(parts.context, parts.gears, parts.arrangement, carrier.stage))
    middle, frame = next((at, parts.arrangement.frames[shaft]) for shaft, at in members.items())
    plans = parts.arrangement.plans
    sides = {shaft: 1.0 if at <= plans[shaft].length / 2.0 else -1.0 for shaft, at in members.items()}
    side, bore = sides.get(carrier.shaft, 1.0), 0.0
    if carrier.shaft not in plans or len(plans[carrier.shaft].places) == 1:
        own = [gear for gear in parts.gears.values() if gear.stage == carrier.stage]
        rings = {sides[shaft] for gear in own if gear.rim for shaft in gear.shafts if shaft in sides}
        side = -side if rings == {side} else side
        suns = {shaft for gear in own if gear.role is Role.SUN for shaft in gear.shafts if sides.get(shaft) == side}
        through = max((shaft.diameter / 2.0 + PLATE_GAP for shaft in parts.shafts if shaft.name in suns), default=0.0)
        bore = through if through < carrier.radius - carrier.pin_diameter / 2.0 - carrier.eye_wall else 0.0
    beside = set_length(parts.context, parts.gears, carrier.stage) / 2.0 + PLATE_GAP
    for way in (side, -side) if carrier.stage in parts.arrangement.two_sided else (side,):
        ends = sorted((middle + way * beside, middle + way * (beside + carrier.plate_thickness)))
        yield _cylinder(carrier.part, carrier.shaft, frame, (ends[0], ends[1]), carrier.reach, bore=bore)


def _bearing(parts: Parts, bearing: BearingSizing) -> Body:
    rolling, half = bearing.bearing, bearing.bearing.width / 2.0
    span, frame = (bearing.position - half, bearing.position + half), parts.arrangement.frames[bearing.shaft]
    part = PartId(Kind.BEARING, bearing.name)
    return _cylinder(part, bearing.shaft, frame, span, rolling.outer_diameter / 2.0, bore=rolling.bore / 2.0)


def _shaft(parts: Parts, shaft: ShaftSizing, seated: Sequence[Body], carriers: Sequence[Body]) -> Iterator[Body]:
    """Yield a shaft where nothing sits on it: its steps, or, in a first sizing, its cylinder between its parts.

    Around the gears of a planetary set, and around the plate of its carrier, a shaft is the set's own body.
    """
    frame, part = parts.arrangement.frames[shaft.name], PartId(Kind.SHAFT, shaft.name)
    built = next((built for built in parts.built if built.name == shaft.name), None)
    if built is not None:
        steps = [(step.start, step.end, step.diameter) for step in built.steps]
    else:
        plan = parts.arrangement.plans[shaft.name]
        steps = [(min(plan.places.values()), max(plan.places.values()), shaft.diameter)] if plan.places else []
    own = sorted(_span(frame, body) for body in seated if body.shaft == shaft.name)
    if own and steps and any(shaft.name in pair for pair in parts.arrangement.within):  # on to gears inside a set
        start, end, diameter = steps[0]
        steps = [(min(start, own[0][1]), max(end, own[-1][0]), diameter)]
    taken = sorted([*own, *_caged(parts, shaft.name, frame, seated, carriers)])
    for start, end, diameter in steps:
        for first, last in _free(start, end, taken):
            circles = [(first, diameter / 2.0), (last, diameter / 2.0)]
            what = f"{1e3 * first:.4g} to {1e3 * last:.4g} mm"
            yield _round(part, shaft.name, frame, circles, bore=shaft.bore / 2.0, what=what)


def _caged(
    parts: Parts, shaft: str, frame: Frame, seated: Sequence[Body], carriers: Sequence[Body]
) -> Iterator[tuple[float, float]]:
    """Yield where a shaft is the cage of a carrier or the bell of a ring, along it [m].

    Between its plate and the planets a carrier has pins and no shaft.
    """
    for stage, planetary in parts.context.design.sets.items():
        gears = [_span(frame, body) for body in seated if body.part.name == stage]
        plates = [_span(frame, body) for body in carriers if body.part.name == stage]
        ring = any(gear.rim and shaft in gear.shafts for gear in parts.gears.values() if gear.stage == stage)
        if ring or planetary.carrier == shaft:
            yield from gears
        if ring:
            yield from ((start - PLATE_GAP, end + PLATE_GAP) for start, end in plates)
        elif planetary.carrier == shaft and gears:
            low, high = min(start for start, _ in gears), max(end for _, end in gears)
            yield from ((high, start) if start > high else (end, low) for start, end in plates)


def _span(frame: Frame, body: Body) -> tuple[float, float]:
    """Return where a body on a shaft begins and ends along it [m]."""
    start = sum((at - zero) * along for at, zero, along in zip(body.origin, frame.origin, frame.along, strict=True))
    return start, start + body.length


def _free(start: float, end: float, taken: Sequence[tuple[float, float]]) -> Iterator[tuple[float, float]]:
    """Yield what is left of a stretch beside what sits on it."""
    for first, last in taken:
        if first - start > _THIN and start < end:
            yield start, min(first, end)
        start = max(start, last)
    if end - start > _THIN:
        yield start, end


# ----------------------------------------------------------------------------------------------------------------------
# Both plates of carriers: the one that takes the torque, and the one that holds the other ends of the pins.
# ----------------------------------------------------------------------------------------------------------------------


_IN_LINE = 1e-6
"""How far two axes may be apart and count as one [m]."""


def plates_of(sizing: Sizing, stage: str) -> tuple[Body, ...]:
    """Return the plates of a carrier: as the arrangement has them, and a second one beyond the planets that has room.

    Args:
        sizing: As sized.
        stage: A planetary or compound set.
    """
    return _plates(sizing)[stage]


@of_latest(1)
def _plates(sizing: Sizing) -> dict[str, tuple[Body, ...]]:
    """Return the plates of every carrier."""
    alone = {carrier.stage for carrier in sizing.carriers if carrier.alone}
    return {stage: _plates_of(sizing, stage)[: 1 if stage in alone else None] for stage in sizing.design.sets}


def _plates_of(standing: Standing, stage: str) -> tuple[Body, ...]:
    part = carrier_part(stage)
    bodies = tuple(body for body in standing.arrangement.bodies if body.part == part)
    free = next(carrier.free_plate for carrier in standing.carriers if carrier.stage == stage)
    second, taken = _mirrored(standing, bodies[0], free)
    return bodies if len(bodies) > 1 or not _has_room(standing, taken) else (*bodies, second)


class Standing(Protocol):
    """Gears and shafts that stand where they are."""

    @property
    def design(self) -> Design:
        """What they are sized for."""

    @property
    def gears(self) -> tuple[GearSizing, ...]:
        """As sized."""

    @property
    def shafts(self) -> tuple[ShaftSizing, ...]:
        """As sized."""

    @property
    def carriers(self) -> tuple[CarrierSizing, ...]:
        """As sized."""

    @property
    def arrangement(self) -> Arrangement:
        """With bodies."""


def roomy(standing: Standing) -> tuple[str, ...]:
    """Return the sets that have a plate on both sides of their planets, or room for a second one.

    Args:
        standing: With a plate on one side at least.
    """
    return tuple(stage for stage in standing.design.sets if len(_plates_of(standing, stage)) > 1)


def _mirrored(sizing: Standing, plate: Body, free: float | None) -> tuple[Body, Body]:
    """Return a plate as far from the planets as the first, as thick as one that takes no torque, and what it takes."""
    planets, (low, high) = _planets(sizing, plate)
    thick = free or sizing.design.carriers.plate_ratio * max(gear.face_width for gear in planets)
    if low > 0.0:  # the first plate lies before the planets
        start = low + high - plate.length
        return _moved(plate, start, thick), _moved(plate, high, start + thick - high)
    end = low + high
    return _moved(plate, end - thick, thick), _moved(plate, end - thick, low - end + thick)


def planets_span(sizing: Sizing, plate: Body) -> tuple[float, float]:
    """Return where the planets of a set begin and end along the axis of its carrier's plate, from its origin [m].

    Args:
        sizing: As sized.
        plate: Of the carrier.
    """
    return _planets(sizing, plate)[1]


def _planets(sizing: Standing, plate: Body) -> tuple[list[GearSizing], tuple[float, float]]:
    found = {gear.part: gear for gear in sizing.gears if gear.stage == plate.part.name and gear.role is Role.PLANET}
    spans = [along_body(plate, body) for body in sizing.arrangement.bodies if body.part in found]
    return list(found.values()), (min(span[0] for span in spans), max(span[1] for span in spans))


def _moved(plate: Body, start: float, length: float) -> Body:
    """Return a disc as wide as a plate elsewhere on its axis, without a bore."""
    origin = Point(*(at + start * way for at, way in zip(plate.origin, plate.direction, strict=True)))
    return replace(plate, origin=origin, stations=(Station(0.0, plate.radius), Station(length, plate.radius)), bore=0.0)


def _has_room(sizing: Standing, plate: Body) -> bool:
    """Tell whether nothing but shafts in line, for which plates have a hole, stands where a plate would."""
    axis = plate.direction
    for body in (*sizing.arrangement.bodies, *_whole(sizing)):
        if body.part.name == plate.part.name and body.part.kind in (Kind.GEAR, Kind.CARRIER):
            continue
        off = tuple(at - zero for at, zero in zip(body.origin, plate.origin, strict=True))
        beside, tilt = math.hypot(*_cross(off, axis)), math.hypot(*_cross(body.direction, axis))
        if body.part.kind is Kind.SHAFT and beside < _IN_LINE and tilt < _IN_LINE:
            continue
        if stand_into(plate, body, 0.0):
            return False
    return True


def _cross(one: Sequence[float], other: Sequence[float]) -> tuple[float, float, float]:
    """Return the vector product of two vectors; numpy's takes longer for a single one."""
    (a, b, c), (x, y, z) = one, other
    return b * z - c * y, c * x - a * z, a * y - b * x


def _whole(sizing: Standing) -> Iterator[Body]:
    """Yield shafts of a first sizing as long as they are sized, with what holds their ends."""
    for shaft in sizing.shafts:
        frame, radius = sizing.arrangement.frames[shaft.name], shaft.diameter / 2.0
        ends = (Station(0.0, radius), Station(shaft.length, radius))
        yield Body(PartId(Kind.SHAFT, shaft.name), shaft.name, "", frame.origin, frame.along, ends)


def along_body(body: Body, other: Body) -> tuple[float, float]:
    """Return where another body begins and ends along the axis of a body, from its origin [m].

    Args:
        body: That says where the axis lies.
        other: In line with it.
    """
    ends = [float((np.asarray(other.origin) + far * np.asarray(other.direction) - np.asarray(body.origin))
                  @ np.asarray(body.direction)) for far in (0.0, other.length)]  # fmt: skip
    return min(ends), max(ends)


# ----------------------------------------------------------------------------------------------------------------------
# Bells: what joins a ring that turns to its shaft, a wall beside the ring and a disc down to the shaft.
#
# What weighs a bell, what draws it and how far its shaft reaches all follow from the section that stands here.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_WALL = 3e-3
"""Of a bell, that it can be turned and hardened without warping [m], an assumption."""
FLAT = 5e-4
"""By how much a disc must be thicker at its hub to be a cone there [m], an assumption."""
TAPER = 3.0
"""Thickness of a bell's disc at its hub over that at its outside, at most [-]."""

Span = tuple[float, float]


class Bell(NamedTuple):
    """What joins a turning ring to its shaft; places along that shaft from its first end."""

    ring: GearSizing
    middle: float
    """Of the ring [m]."""
    disc: Span
    """Where the disc begins and ends at its hub, away from the ring [m]."""
    hub: float
    """Radius of the shaft there [m]."""
    section: tuple[tuple[float, float], ...]
    """Corners from the shaft on, along the face towards the ring, back along the other one: place and radius [m]."""

    @property
    def volume(self) -> float:
        """[m³]"""
        return revolved_volume(self.section)


def along(sizing: Sizing, shaft: str, body: Body) -> Span:
    """Return where a body begins and ends along a shaft [m].

    Args:
        sizing: As sized.
        shaft: In line with the body.
        body: Its envelope.
    """
    frame = sizing.arrangement.frames[shaft]
    ends = [float((np.asarray(body.origin) + far * np.asarray(body.direction) - np.asarray(frame.origin))
                  @ np.asarray(frame.along)) for far in (0.0, body.length)]  # fmt: skip
    return min(ends), max(ends)


def bells(sizing: Sizing) -> Iterator[Bell]:
    """Yield the bell of every ring that turns, on the side of its set or pair to which its shaft leads.

    Args:
        sizing: As sized.

    Source: equilibrium of a disc in shear (Tresca), τ = T/(2 π r² t): as thick as the largest torque of all cases asks
        at the hub, from there a cone to where a third of it is enough, or the thinnest wall; the wall by the same.
    """
    for ring in sizing.gears:
        if ring.rim and ring.shafts[0] != GROUND:
            yield _bell(sizing, ring)


def _bell(sizing: Sizing, ring: GearSizing) -> Bell:
    shaft = ring.shafts[0]
    start, end = along(sizing, shaft, next(body for body in sizing.arrangement.bodies if body.part == ring.body(shaft)))
    middle = (start + end) / 2.0
    side = 1.0 if sizing.arrangement.plans[shaft].length / 2.0 >= middle else -1.0
    face = side * _beyond(sizing, ring, side) + side * PLATE_GAP
    hub, torque = _radius(sizing, shaft, face), ring_torque(sizing, ring)
    root, outside = ring_radii(sizing.design, ring)
    inside = max(outside - max(LEAST_WALL, _thickness(sizing, torque, outside)), root)
    thick = max(_thickness(sizing, torque, hub), LEAST_WALL)
    thin = max(thick / TAPER, LEAST_WALL)
    knee = min(hub * math.sqrt(thick / thin), inside)
    cone = [(face + side * thin, knee)] if thick > thin + FLAT else []
    thin = thin if cone else thick
    back = [(face + side * thick, hub), *cone, (face + side * thin, outside)]
    ring_end = end if side > 0.0 else start
    front = [(face, hub), (face, inside), (ring_end, inside), (ring_end, outside)]
    return Bell(ring, middle, (face, face + side * thick), hub, (*front, *back[::-1]))


def _beyond(sizing: Sizing, ring: GearSizing, side: float) -> float:
    """Return how far gears and both plates of a ring's set, or the gears of its pair, reach along its shaft [m]."""
    gears = [body for body in sizing.arrangement.bodies
             if body.part.name == ring.stage and body.part.kind is Kind.GEAR]  # fmt: skip
    plates = plates_of(sizing, ring.stage) if ring.stage in sizing.design.sets else ()
    bodies: Sequence[Body] = (*gears, *plates)
    return max(side * end for body in bodies for end in along(sizing, ring.shafts[0], body))


def _radius(sizing: Sizing, shaft: str, place: float) -> float:
    """Return the radius of a shaft at a place: its step's, of a first sizing its own [m]."""
    steps = next((built.steps for built in sizing.built_shafts if built.name == shaft), ())
    at = [step.diameter for step in steps if step.start <= place <= step.end]
    return max(at, default=next(one.diameter for one in sizing.shafts if one.name == shaft)) / 2.0


def _thickness(sizing: Sizing, torque: float, radius: float) -> float:
    """Return the thickness of a disc, or of a tube, that its torque shears at a radius [m]; 0 of unknown strength."""
    shear = (sizing.design.shaft_material.yield_strength or 0.0) / sizing.design.shafting.safety / 2.0
    return torque / (2.0 * math.pi * radius**2 * shear) if shear else 0.0


def ring_torque(sizing: Sizing, ring: GearSizing) -> float:
    """Return the largest torque that the meshes of a ring put on it, of all cases [N m].

    Args:
        sizing: As sized.
        ring: One of its internal gears.
    """
    rows = [(mesh.name, mesh.gears.index(ring.name)) for mesh in sizing.train.meshes if ring.name in mesh.gears]
    return max(abs(sum(flow.meshes[row].torques[side] for row, side in rows)) for flow in sizing.flows.values())


# ----------------------------------------------------------------------------------------------------------------------
# From where to where every shaft reaches along its axis, among others in line.
#
# Masses and solids of shafts follow it.
# ----------------------------------------------------------------------------------------------------------------------


IN_LINE = 1e-6
"""How far two axes may be apart and count as one [m]."""
END = 2e-4
"""By which a shaft ends inside the face of what sits at its end, so that shafts in line do not touch [m]."""


class Run(NamedTuple):
    """A shaft, or a piece of one, from end to end."""

    shaft: str
    steps: tuple[tuple[float, float, float], ...]
    """Start, end and radius of each, from the shaft's first end [m]."""
    bore: float
    """Radius [m]."""
    piece: int = 1
    """Of the shaft, from its first end: one that is the cage of a set in between has two."""

    @property
    def volume(self) -> float:
        """Of its metal [m³]."""
        return math.pi * sum((radius**2 - self.bore**2) * (end - start) for start, end, radius in self.steps)

    @property
    def label(self) -> str:
        """As the scene names it."""
        return f"shaft {self.shaft}" if self.piece == 1 else f"shaft {self.shaft}, piece {self.piece}"


@of_latest(2)
def runs(sizing: Sizing) -> tuple[tuple[Run, ...], tuple[str, ...]]:
    """Return every shaft, and in sentences which are cut because another one stands in their place.

    Args:
        sizing: As sized.
    """
    built = {shaft.name: shaft for shaft in sizing.built_shafts}
    spans = {shaft.name: _reach(sizing, shaft.name, shaft.length) for shaft in sizing.shafts}
    cut = _cleared(sizing, spans)
    found, words = [], []
    for shaft in sizing.shafts:
        low, high = cut[shaft.name]
        if shaft.name not in built and _is_cage(sizing, shaft.name):
            words.append(f"shaft {shaft.name} is the cage of its planets alone: nothing else sits on it, none is drawn")
            continue
        if shaft.name not in built and any(shaft.name in pair for pair in sizing.arrangement.within):
            found += [
                Run(shaft.name, ((start, end, shaft.diameter / 2.0),), shaft.bore / 2.0, k + 1)
                for k, (start, end) in enumerate(_pieces(sizing, shaft.name))
            ]
            continue
        if shaft.name in built:
            steps = cut_steps(sizing, built[shaft.name])
            found.append(Run(shaft.name, steps, built[shaft.name].bore / 2.0))
            continue
        found.append(Run(shaft.name, ((low, high, shaft.diameter / 2.0),), shaft.bore / 2.0))
        less = spans[shaft.name][1] - spans[shaft.name][0] - (high - low)
        if less > IN_LINE:
            words.append(
                f"shaft {shaft.name} is drawn {1e3 * less:.3g} mm shorter than sized: another body stands there"
            )
    return tuple(found), tuple(words)


def _is_cage(sizing: Sizing, shaft: str) -> bool:
    """Tell whether a shaft is a carrier's alone, so that nothing goes on from its plate."""
    plan = sizing.arrangement.plans[shaft]
    return len(plan.places) == 1 and any(stage.carrier == shaft for stage in sizing.design.sets.values())


def _pieces(sizing: Sizing, shaft: str) -> list[Span]:
    """Return the stretches of a shaft in or around another one, with the hubs of what sits on it.

    Within a set, the shaft of its carrier or ring is the set's own cage or bell.
    """
    bodies = [body for body in sizing.arrangement.bodies if body.shaft == shaft]
    rings = {gear.part for gear in sizing.gears if gear.rim}
    spans = [along(sizing, shaft, body) for body in bodies if body.part.kind is Kind.SHAFT]
    seated = [body for body in bodies if body.part.kind is not Kind.SHAFT and body.part not in rings]
    hubs = [along(sizing, shaft, body) for body in seated]
    hubs = [(low + END, high - END) for low, high in hubs]
    hubs += [bell.disc for bell in bells(sizing) if bell.ring.shafts[0] == shaft]
    merged: list[Span] = []
    for low, high in sorted((min(span), max(span)) for span in (*spans, *hubs)):
        if merged and low <= merged[-1][1] + 2.0 * END:
            merged[-1] = (merged[-1][0], max(merged[-1][1], high))
        else:
            merged.append((low, high))
    return merged


def _own(sizing: Sizing, shaft: str) -> list[Span]:
    """Return where a shaft's own gears, plates and bearings sit on it; rings are tied to it by a disc."""
    rings = {gear.part for gear in sizing.gears if gear.rim}
    seated = (body for body in sizing.arrangement.bodies if body.shaft == shaft and body.part.kind is not Kind.SHAFT)
    bodies = (body for body in seated if body.part not in rings)
    return [along(sizing, shaft, body) for body in bodies] + [
        (min(bell.disc), max(bell.disc)) for bell in bells(sizing) if bell.ring.shafts[0] == shaft
    ]


def _reach(sizing: Sizing, shaft: str, length: float) -> Span:
    """Return a shaft from its first end to its second one, and on through what sits at its ends."""
    own = [(low + END, high - END) for low, high in _own(sizing, shaft) if high - low > 4.0 * END]
    return min([0.0, *(low for low, _ in own)]), max([length, *(high for _, high in own)])


def _cleared(sizing: Sizing, spans: Mapping[str, Span]) -> dict[str, Span]:
    """Return the shafts without what hangs over their own parts into another one in line, which has parts there."""
    cut, frames = dict(spans), sizing.arrangement.frames
    built = {shaft.name for shaft in sizing.built_shafts}
    for name in [name for name in spans if name not in built]:
        core = _hull(_own(sizing, name))
        if core is None:
            continue
        for other in spans:
            offset = _in_line(sizing, name, other)
            if other == name or offset is None:
                continue
            sign = 1.0 if np.dot(frames[name].along, frames[other].along) > 0.0 else -1.0
            taken = sorted(offset + sign * end for end in cut[other])
            low, high = cut[name]
            if low < taken[1] and taken[0] < core[0] and taken[1] <= core[0] + IN_LINE:
                low = max(low, taken[1]) if taken[0] <= low else core[0]
            if high > taken[0] and taken[1] > core[1] and taken[0] >= core[1] - IN_LINE:
                high = min(high, taken[0]) if taken[1] >= high else core[1]
            cut[name] = (min(low, core[0]), max(high, core[1]))
        cut[name] = _before_plates(sizing, name, core, cut[name])
    return cut


def _before_plates(sizing: Sizing, shaft: str, core: Span, span: Span) -> Span:
    """Return a shaft that ends before plates of carriers beside it, beyond its own parts."""
    frame, (low, high) = sizing.arrangement.frames[shaft], span
    radius = next(one.diameter for one in sizing.shafts if one.name == shaft) / 2.0
    for plate in (plate for stage in sizing.design.sets for plate in plates_of(sizing, stage)):
        between = np.asarray(plate.origin) - np.asarray(frame.origin)
        beside = float(np.linalg.norm(between - (between @ np.asarray(frame.along)) * np.asarray(frame.along)))
        tilt = float(np.linalg.norm(np.cross(plate.direction, frame.along)))
        if tilt > IN_LINE or not IN_LINE < beside < plate.radius + radius:
            continue
        near, far = along(sizing, shaft, plate)
        if core[1] <= near + IN_LINE and near < high:
            high = max(near, core[1])
        if far - IN_LINE <= core[0] and low < far:
            low = min(far, core[0])
    return low, high


def _hull(spans: Sequence[Span]) -> Span | None:
    return (min(low for low, _ in spans), max(high for _, high in spans)) if spans else None


def _in_line(sizing: Sizing, shaft: str, other: str) -> float | None:
    """Return where the first end of another shaft lies along a shaft on one axis with it; None of other axes [m]."""
    one, two = (sizing.arrangement.frames[name] for name in (shaft, other))
    between = np.asarray(two.origin) - np.asarray(one.origin)
    far = float(between @ np.asarray(one.along))
    beside = float(np.linalg.norm(between - far * np.asarray(one.along)))
    tilt = float(np.linalg.norm(np.cross(one.along, two.along)))
    return far if beside < IN_LINE and tilt < IN_LINE else None
