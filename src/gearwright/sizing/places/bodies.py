"""The envelopes of all parts at their places in space: gears, free stretches of shafts, bearings, carriers.

Gears are their tip circles over their face widths; a bevel gear is its teeth, about the hollow inside them, and the
blank behind them with the rim that drawings assume. The wheel of a face gear is the ring of its teeth, whose tips lie
in one plane, and a disc behind it. Planets are the ring that they sweep. Machines and housings have none.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from gearwright.identity import Kind, PartId, Role
from gearwright.parts.bevel import bevel_profile
from gearwright.sizing.arranged import Arrangement, Body, Frame, Point, Station
from gearwright.sizing.arrangement import PLATE_GAP, set_length, slots
from gearwright.sizing.carrying import CarrierSizing, ShaftSizing
from gearwright.sizing.mounted import BearingSizing, BuiltShaft
from gearwright.sizing.places.cones import bevel_cones
from gearwright.sizing.places.frames import apart_of, frames_of, set_members
from gearwright.sizing.rating import BACKUP, Context
from gearwright.sizing.result import GearSizing

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
    """Yield where a shaft is the cage of a carrier or the bell of a ring, along it [m]."""
    for stage, planetary in parts.context.design.sets.items():
        ring = any(gear.rim and shaft in gear.shafts for gear in parts.gears.values() if gear.stage == stage)
        if ring or planetary.carrier == shaft:
            yield from (_span(frame, body) for body in seated if body.part.name == stage)
        if ring:
            for start, end in (_span(frame, body) for body in carriers if body.part.name == stage):
                yield start - PLATE_GAP, end + PLATE_GAP


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
