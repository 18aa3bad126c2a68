"""Manufacturability and assembly checks: running clearance, grinding, assembly sequence, spanner access.

Bodies that stand into each other are `sizing`'s to find; strength of what holds parts is its too.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from gearwright.base import GEARBOX, Check, Kind, PartId, Role, not_assessed
from gearwright.parts.carriers import BRIDGE, bridge_thickness
from gearwright.sizing.casing import boss_bodies, cover_bodies, ring_seats
from gearwright.sizing.gear_geometry import cylindrical_gear
from gearwright.sizing.housing_shell import ball_around
from gearwright.sizing.mass import carried_in_walls, tooth_of
from gearwright.sizing.places import axes_among, least_room, of_one_set, room_between, sphere_around
from gearwright.sizing.result import Body, GearSizing, Point, Sizing, Station
from gearwright.sizing.shaft_results import BuiltShaft, CarrierSizing, hub_bore_of
from gearwright.sizing.shafts import (
    Retention,
    groove_checks,
    holders_of,
    holding_checks,
    pressure_centre_checks,
    retention_checks,
    retentions,
    seal_checks,
)
from gearwright.sizing.shafts.carriers import THROUGH
from gearwright.spec import GROUND, Design

# ----------------------------------------------------------------------------------------------------------------------
# Whether bodies that turn against each other stay clear while shafts bend: the nearest two of a gearbox.
#
# What takes of the room between two bodies is how far each shaft bends there, how far its slope moves the rim of the
# body, and what castings and fits are allowed to be off.
# ----------------------------------------------------------------------------------------------------------------------


OFF = 5e-4
"""What housings, fits and bearings may be off between two bodies, an estimate [m]."""
_EQUAL = 1e-6
"""Difference of two rooms over what is needed that counts as none [-]."""
_CLEARANCE_HELP = (
    "move them apart along their shafts ([layout.SHAFT.places]), turn an axis (angle_deg), or stiffen the shafts"
)


class Clearance(NamedTuple):
    """Two bodies that turn against each other."""

    one: Body
    other: Body
    gap: float
    """[m]"""
    needed: float
    """[m]"""


class SeatDeflection(NamedTuple):
    """How a shaft bends where a part sits."""

    deflection: float
    """[m]"""
    slope: float
    """[rad]"""


def running_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the least running clearance of a gearbox over what bending and inaccuracy take of it.

    Args:
        sizing: As sized.
    """
    least = _least_clearance(sizing)
    if least is None:
        return
    mode, clause = "running clearance", "bending of shafts, and 0.5 mm"
    names = f"{least.one.part} and {least.other.part}"
    built = {shaft.name for shaft in sizing.built_shafts} | {GROUND}
    if least.gap < least.needed and not built >= {least.one.shaft, least.other.shaft}:
        why = f"{1e3 * least.gap:.3g} mm between {names}, as a first sizing places them: {_CLEARANCE_HELP}"
        yield not_assessed(GEARBOX, mode, clause, why)
        return
    why = "" if least.gap >= least.needed else _CLEARANCE_HELP
    yield Check(GEARBOX, mode, clause, least.gap, least.needed, "length", exponent=None, place=names, why=why)


def _least_clearance(sizing: Sizing) -> Clearance | None:
    """Return the bodies with the least room over what is needed, of equals the first; None where none may touch.

    Bodies of which the spheres around them show more are not looked at.
    """
    least, ratio = None, math.inf
    for one, other, needed, apart in _turning(sizing):
        if apart > (ratio + _EQUAL) * needed:
            continue
        gap = room_between(one, other, enough=0.01).gap
        if gap >= 0.0 and round(gap / needed, 9) < ratio:
            least, ratio = Clearance(one, other, gap, needed), round(gap / needed, 9)
    return least


def _turning(sizing: Sizing) -> Iterator[tuple[Body, Body, float, float]]:
    """Yield bodies that turn against each other, the room that they need, and the least that they have [m].

    Gears in mesh, gears of one set, and coaxial shafts of a first sizing, whose places are open, are left out. So are
    two bearings: their outer rings stand still.
    """
    bodies, bent = sizing.arrangement.bodies, bending(sizing)
    built, mates = {shaft.name for shaft in sizing.built_shafts}, mates_of(sizing)
    sets = frozenset(sizing.design.sets)
    takes, around = [moved(body, bent) for body in bodies], map(sphere_around, bodies)
    rows = zip(bodies, axes_among(bodies), takes, around, strict=True)
    for (one, first, takes_one, beside), (other, second, takes_other, ball) in combinations(rows, 2):
        if one.shaft == other.shaft or {one.part.kind, other.part.kind} == {Kind.BEARING}:
            continue
        if first == second and not built >= {one.shaft, other.shaft}:
            continue
        if of_one_set(one, other, sets) or frozenset((one.part, other.part)) in mates:
            continue
        yield one, other, OFF + takes_one + takes_other, least_room(beside, ball)


def mates_of(sizing: Sizing) -> frozenset[frozenset[PartId]]:
    """Return the gears of pairs that mesh, two and two.

    Args:
        sizing: As sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    return frozenset(
        frozenset(gears[name].body(node) for name, node in zip(mesh.gears, mesh.nodes, strict=False))
        for mesh in sizing.train.meshes
        if mesh.stage in sizing.design.pairs
    )


def bending(sizing: Sizing) -> dict[tuple[str, str], SeatDeflection]:
    """Return shaft and gear or bearing -> how the shaft bends there; of built shafts.

    Args:
        sizing: As sized.
    """
    found = {}
    for shaft in sizing.built_shafts:
        deflections = dict(shaft.deflections)
        for place, slope in shaft.slopes:
            found[shaft.name, place] = SeatDeflection(deflections.get(place, 0.0), slope)
    return found


def moved(body: Body, bent: Mapping[tuple[str, str], SeatDeflection]) -> float:
    """Return how far bending moves the rim of a body at most [m]; a free stretch moves as the worst of its shaft.

    Args:
        body: Of a shaft.
        bent: From `bending`.
    """
    if body.shaft == GROUND or body.part.kind is Kind.BEARING:
        return 0.0
    own = [by for (shaft, place), by in bent.items() if shaft == body.shaft and place in str(body.part)]
    own = own or [by for (shaft, _), by in bent.items() if shaft == body.shaft]
    return max((by.deflection + by.slope * body.radius for by in own), default=0.0)


# ----------------------------------------------------------------------------------------------------------------------
# Whether a gearbox can be put together: what is slid onto each shaft from which end, and which shaft goes in when.
#
# Shafts are taken out in thought, each along its own axis with all that sits on it; what comes out last goes in first.
# A part sweeps a cylinder as it leaves, which must be clear of all that is still inside. Cylindrical gears slide out of
# their meshes; a bevel gear leaves its mate only away from the apex of its cone. A housing that opens along its axes
# needs none of this: where shafts lock each other in, that is what is asked for.
# ----------------------------------------------------------------------------------------------------------------------


ENDS = {-1: "first", 1: "second"}
"""Way along a shaft -> the end that it leads to."""
_TOUCH = 1e-6
"""How far a part may pass another by rounding [m]."""
_ASSEMBLY_CLAUSE = "bodies along their axes"
_STACK = "bores over steps"


class Slid(NamedTuple):
    """A part that is put onto a shaft."""

    name: str
    way: int
    """End that it comes from: −1 the first, +1 the second."""
    place: float
    """Middle, from the first end [m]."""
    bore: float
    """[m]"""
    past: float
    """Thickest diameter that it passes over [m]; 0 where it passes none."""
    rolls: bool
    """Whether it is a bearing."""


class Withdrawn(NamedTuple):
    """A shaft that leaves the gearbox."""

    shaft: str
    way: int
    """End that it leaves by, its own: −1 the first, +1 the second."""


def stack_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether what sits on every built shaft passes over what it is slid over, with the order of its parts.

    Args:
        sizing: As sized.
    """
    for shaft in sizing.built_shafts:
        slid = list(slid_parts(sizing, shaft))
        part, mode = PartId(Kind.SHAFT, shaft.name), "assembly of its parts"
        small = [f"{one.name} of {1e3 * one.bore:g} mm" for one in slid if one.bore < _seat(shaft, one) - _TOUCH]
        if small:
            why = f"the design gives its shaft thicker than {' and '.join(small)}: it needs seats of their bores"
            yield not_assessed(part, mode, _STACK, why)
            continue
        passing = [one for one in slid if one.past]
        if passing:
            tightest = min(passing, key=lambda one: round(one.bore / one.past, 9))
            why = "" if tightest.bore >= tightest.past - _TOUCH else "a larger bore, or thinner steps outside it"
            yield Check(
                part, mode, _STACK, tightest.bore, tightest.past, "length", exponent=None, place=_order(slid), why=why
            )


def _seat(shaft: BuiltShaft, slid: Slid) -> float:
    """Return the diameter of a shaft where a bearing of one of its own bores sits; of a spline its hub is cut [m]."""
    return next(step.diameter for step in shaft.steps if step.start <= slid.place <= step.end) if slid.rolls else 0.0


def slid_parts(sizing: Sizing, shaft: BuiltShaft) -> Iterator[Slid]:
    """Yield bearings, gears and machines that are put onto a shaft, from the end that is nearer past its thickest step.

    Args:
        sizing: As sized.
        shaft: One of its built shafts.
    """
    parts = [(bearing.name, bearing.position, bearing.inner_diameter, True)
             for bearing in sizing.bearings if bearing.shaft == shaft.name]  # fmt: skip
    parts += [(joint.part, joint.position, hub_bore_of(joint), False)
              for joint in sizing.joints if joint.shaft == shaft.name and joint.kind != "integral"]  # fmt: skip
    for name, place, bore, rolls in sorted(parts, key=lambda part: part[1]):
        ways = {-1: [step.diameter for step in shaft.steps if step.end < place],
                1: [step.diameter for step in shaft.steps if step.start > place]}  # fmt: skip
        way = min(ways, key=lambda side: max(ways[side], default=0.0))
        yield Slid(name, way, place, bore, max(ways[way], default=0.0), rolls)


def _order(slid: Sequence[Slid]) -> str:
    """Return what is put on from which end, in words."""
    words = []
    for way, end in ENDS.items():
        names = [part.name for part in sorted(slid, key=lambda part: way * part.place) if part.way == way]
        words += [f"from the {end} end {', '.join(names)}"] if names else []
    return "; ".join(words)


def order_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield in which order built shafts go into their housing from its ends, or which lock each other in.

    Args:
        sizing: As sized.
    """
    if len(sizing.built_shafts) < 2:
        return
    out, left = withdrawals(sizing)
    words = ", ".join(f"{step.shaft} by its {ENDS[step.way]} end" for step in reversed(out))
    if left:
        why = f"{' and '.join(left)} lock each other in along their axes: the housing must open beside them"
        yield not_assessed(GEARBOX, "assembly order", _ASSEMBLY_CLAUSE, why)
        return
    count = float(len(sizing.built_shafts))
    yield Check(
        GEARBOX,
        "assembly order",
        _ASSEMBLY_CLAUSE,
        float(len(out)),
        count,
        "number",
        exponent=None,
        place=f"in go {words}",
    )


def withdrawals(sizing: Sizing) -> tuple[tuple[Withdrawn, ...], tuple[str, ...]]:
    """Return in which order built shafts leave the gearbox along their axes, and those that cannot.

    A bearing leaves with its shaft, or before it by the end from which it is slid on.

    Args:
        sizing: As sized.
    """
    left, out = [shaft.name for shaft in sizing.built_shafts], list[Withdrawn]()
    while left:
        ways = (Withdrawn(shaft, way) for shaft in left for way in ENDS)
        free = next((step for step in ways if leaves_past(sizing, step, left)), None)
        if free is None:
            break
        out.append(free)
        left.remove(free.shaft)
    return tuple(out), tuple(left)


def leaves_past(sizing: Sizing, step: Withdrawn, left: Sequence[str]) -> bool:
    """Tell whether a shaft can be drawn out by one of its ends past the others that are left.

    Args:
        sizing: As sized.
        step: Which one, by which end.
        left: Built shafts that are still in.
    """
    bodies = sizing.arrangement.bodies
    inside = [body for body in bodies if body.shaft in left and body.shaft != step.shaft]
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == step.shaft)
    off = {part.name: part.way for part in slid_parts(sizing, shaft) if part.rolls}
    return all(
        any(_passes(sizing, body, way, inside) for way in {step.way, off.get(str(body.part), step.way)})
        for body in bodies
        if body.shaft == step.shaft
    )


def _passes(sizing: Sizing, body: Body, way: int, inside: Sequence[Body]) -> bool:
    """Tell whether a body leaves along its axis past others."""
    mates, swept = mates_of(sizing), _swept(body, way, _far(inside))
    for other in inside:
        if frozenset((body.part, other.part)) in mates:
            if not _parts(sizing, body.part, way):
                return False
        elif room_between(swept, other, enough=0.0).gap < -_TOUCH:
            return False
    return True


def _parts(sizing: Sizing, part: PartId, way: int) -> bool:
    """Tell whether a gear leaves its mate by an end of its shaft."""
    pair = sizing.design.pairs[part.name]
    if pair.kind == "cylindrical":
        return True
    if pair.kind == "face":
        return part.role is Role.PINION
    apex = pair.pinion_apex if part.role is Role.PINION else pair.wheel_apex
    return way == (-1 if apex == "second" else 1)


def _far(bodies: Sequence[Body]) -> float:
    """Return a length beyond all bodies [m]."""
    return 10.0 * max((max(map(abs, body.origin)) + body.length + body.radius for body in bodies), default=0.1)


def _swept(body: Body, way: int, far: float) -> Body:
    """Return the cylinder that a body sweeps as it leaves along its axis."""
    start = body.origin if way > 0 else Point(
        *(at - far * along for at, along in zip(body.origin, body.direction, strict=True)))  # fmt: skip
    return replace(
        body, origin=start, stations=(Station(0.0, body.radius), Station(body.length + far, body.radius)), bore=0.0
    )


# ----------------------------------------------------------------------------------------------------------------------
# Whether teeth of one piece with a shaft can be ground: how large a wheel runs out beside what is thicker there.
#
# A wheel of diameter D that cuts down to the root circle stands a = √(h (D − h)) wide of its lowest point where it is h
# higher. What stands a beside the teeth and reaches h above their roots therefore lets pass D = (a² + h²)/h.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_WHEEL = 0.03
"""Smallest wheel that grinds profiles between shoulders, an estimate: plated ones of a few centimetres [m]."""
_GRINDING_CLAUSE = "D = (a² + h²)/h"
_GRINDING_HELP = (
    "more room between them along the shaft, or a gear that is joined instead of being of one piece, would help"
)


class Obstacle(NamedTuple):
    """What stands beside teeth and is thicker than their root circle."""

    name: str
    apart: float
    """From the face of the teeth [m]."""
    height: float
    """Above their roots [m]."""


def largest_wheel(apart: float, height: float) -> float:
    """Return the largest wheel that runs out of teeth beside what is thicker than their roots [m].

    Args:
        apart: From the face of the teeth [m].
        height: Of what stands there above the roots [m].

    Source: a chord of a circle, a² = h (D − h).

    >>> round(1e3 * largest_wheel(0.0145, 0.007), 3)
    37.036
    """
    return (apart**2 + height**2) / height if height > 0.0 else math.inf


def grinding_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the largest wheel that grinds every cylindrical gear of one piece with its shaft.

    Args:
        sizing: As sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    for shaft in sizing.built_shafts:
        own = [gears[joint.part] for joint in sizing.joints
               if joint.shaft == shaft.name and joint.kind == "integral" and joint.part in gears]  # fmt: skip
        for gear in own:
            if _is_ground_by_wheels(sizing.design, gear):
                yield from _ground(sizing, shaft, gear, own)


def _is_ground_by_wheels(design: Design, gear: GearSizing) -> bool:
    """Tell whether a gear has teeth on the outside of a cylinder."""
    pair = design.pairs.get(gear.stage)
    if pair is None:
        return gear.role is not Role.RING
    return pair.kind == "cylindrical" and not (pair.internal and gear.role is Role.WHEEL)


def _ground(sizing: Sizing, shaft: BuiltShaft, gear: GearSizing, own: list[GearSizing]) -> Iterator[Check]:
    wheels = [
        (largest_wheel(thing.apart, thing.height), thing.name) for thing in _beside_teeth(sizing, shaft, gear, own)
    ]
    if wheels:
        wheel, name = min(wheels)
        yield Check(
            gear.body(shaft.name), "wheel that grinds it", _GRINDING_CLAUSE, wheel, LEAST_WHEEL, "length",
            exponent=None,
            place=f"beside {name}", why="" if wheel >= LEAST_WHEEL else _GRINDING_HELP,
        )  # fmt: skip


def _beside_teeth(sizing: Sizing, shaft: BuiltShaft, gear: GearSizing, own: list[GearSizing]) -> Iterator[Obstacle]:
    """Yield the steps and gears of one piece with the shaft that are thicker than the roots of a gear."""
    places, root = sizing.arrangement.plans[shaft.name].places, cylindrical_gear(sizing.design, gear).root_radius
    start, end = (places[gear.name] + side * _half(gear) for side in (-1.0, 1.0))
    thick = [(step.start, step.end, step.diameter / 2.0, step.seat or "its shaft") for step in shaft.steps]
    thick += [(places[other.name] - _half(other), places[other.name] + _half(other), _tip(other), other.name)
              for other in own]  # fmt: skip
    for low, high, radius, name in thick:
        if name != gear.name and radius > root:
            yield Obstacle(name, max(low - end, start - high, 0.0), radius - root)


def _half(gear: GearSizing) -> float:
    return gear.face_width * gear.bodies / len(gear.shafts) / 2.0


def _tip(gear: GearSizing) -> float:
    return gear.pitch_diameter / 2.0 + gear.module * (1.0 + gear.profile_shift + gear.tip_alteration)


# ----------------------------------------------------------------------------------------------------------------------
# Whether carriers go through their rings, and have room for bridges, which tie a second plate to the first.
#
# Where bridges can tie a second plate to the first, both share the force of the pins. A planet of tip diameter
# d_a is put in through the window between two bridges, on the chord 2 r sin(π/N) of neighbouring pins. Half of the
# torque crosses to the second plate: each bridge bends as a beam with both ends held, M = F L/2 with F = T/(2 N r).
# ----------------------------------------------------------------------------------------------------------------------


_BRIDGE_CLAUSE = "window between bridges; beam with both ends held"
_BRIDGE_HELP = "one plate must hold the pins; fewer planets, or smaller ones, would leave bridges room"


def bridge_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether plates go through rings, and what planets leave on the pin circle is thick enough for a bridge.

    Args:
        sizing: As sized.
    """
    for carrier in sizing.carriers:
        yield from _through(sizing, carrier)
        planets = [gear for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET]
        several = carrier.stage in sizing.design.planetaries and max(gear.bodies for gear in planets) > 1
        if several and not carrier.alone:
            yield _bridges(sizing, carrier, planets[0])
        if carrier.misalignment is not None and carrier.largest_misalignment is not None:
            yield _straight(carrier, carrier.misalignment, carrier.largest_misalignment)


_TILT_CLAUSE = "ISO 6336-1:2006, table 8; carrier as beams"
_TILT_HELP = (
    "a second plate has no room beyond the planets: longer shafts between stages ([layout.SHAFT] length) would give it"
    " some"
)


def _straight(carrier: CarrierSizing, off: float, allowed: float) -> Check:
    """Return whether a carrier keeps planets straight; not assessed where one plate holds them for want of room."""
    if carrier.free_plate is None and not carrier.alone and off > allowed:
        leans = f"teeth lean by {1e6 * off:.3g} µm over their face, {1e6 * allowed:.3g} allowed"
        why = f"on cantilever pins {leans}: {_TILT_HELP}"
        return not_assessed(carrier.part, "planet tilt", _TILT_CLAUSE, why)
    return Check(
        carrier.part, "planet tilt", _TILT_CLAUSE, off, allowed, "length", at_most=True, symbol="F_βx",
        case=carrier.case,
    )  # fmt: skip


def _through(sizing: Sizing, carrier: CarrierSizing) -> Iterator[Check]:
    """Yield whether the plates of a carrier, with their eyes, pass the tips of the narrowest ring of their set."""
    tips = [tooth_of(sizing, gear).tip_radius for gear in sizing.gears if gear.stage == carrier.stage and gear.rim]
    if tips:
        yield Check(
            carrier.part, "plate through its ring", "tip circle", carrier.reach, min(tips) - THROUGH, "length",
            at_most=True, exponent=None, symbol="r",
        )  # fmt: skip


def _bridges(sizing: Sizing, carrier: CarrierSizing, planet: GearSizing) -> Check:
    if carrier.bridge_width is not None:  # as sized, which may stand where planets leave more
        allowed = (sizing.design.shaft_material.yield_strength or math.inf) / sizing.design.shafting.safety
        force = carrier.tangential_force * carrier.radius / (2.0 * (carrier.bridge_radius or carrier.radius))
        needed = bridge_thickness(force, planet.face_width, carrier.bridge_depth or math.inf, allowed)
        return Check(
            carrier.part, "bridges between planets", _BRIDGE_CLAUSE, carrier.bridge_width, needed, "length",
            exponent=None,
        )  # fmt: skip
    room, needed = bridge_room(carrier, planet), bridge_needed(sizing, carrier, planet)
    if room < needed:
        why = f"planets leave {1e3 * max(room, 0.0):.3g} mm for bridges that need {1e3 * needed:.3g} mm: {_BRIDGE_HELP}"
        return not_assessed(carrier.part, "bridges between planets", _BRIDGE_CLAUSE, why)
    return Check(carrier.part, "bridges between planets", _BRIDGE_CLAUSE, room, needed, "length", exponent=None)


def bridge_room(carrier: CarrierSizing, planet: GearSizing) -> float:
    """Return the thickness that neighbouring planets, put in through windows, leave for a bridge [m].

    Args:
        carrier: As sized.
        planet: On its pins.
    """
    tip = planet.pitch_diameter + 2.0 * planet.module * (1.0 + planet.profile_shift + planet.tip_alteration)
    return 2.0 * carrier.radius * math.sin(math.pi / planet.bodies) - tip - 2.0 * OFF


def bridge_needed(sizing: Sizing, carrier: CarrierSizing, planet: GearSizing) -> float:
    """Return the thickness that half of the carrier's torque asks of a bridge [m].

    Args:
        sizing: As sized.
        carrier: Of it.
        planet: On its pins.
    """
    allowed = (sizing.design.shaft_material.yield_strength or math.inf) / sizing.design.shafting.safety
    force = carrier.torque / (2.0 * planet.bodies * carrier.radius)
    return bridge_thickness(force, planet.face_width, BRIDGE * planet.pitch_diameter, allowed)


# ----------------------------------------------------------------------------------------------------------------------
# Whether walls of the housing carry the bosses of all bearings, and whether bosses and covers stand clear.
# ----------------------------------------------------------------------------------------------------------------------


NEAR = 0.01
"""Room that is enough not to be looked at further [m]."""
_ROOM = "bending of shafts, and 0.5 mm"
_APART = "move bearings or gears along their shafts ([bearings], [layout.SHAFT.places])"
_WEB_CLAUSE = "webs built in at both ends; working normal stress of the housing"
_BOSS_HELP = "move bearings nearer to a wall, or away from what turns around them ([bearings], [layout.SHAFT.places])"


def boss_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the least room between bosses and covers and what turns, or other covers, about other axes.

    Args:
        sizing: As sized.
    """
    if (least := boss_room(sizing)) is not None:
        gap, needed, names = least
        why = "" if gap >= needed else f"{1e3 * gap:.3g} mm between {names}: {_APART}"
        yield Check(
            GEARBOX, "running clearance of bosses", _ROOM, max(gap, 0.0), needed, "length", exponent=None,
            place=names, why=why,
        )  # fmt: skip


def boss_room(sizing: Sizing) -> tuple[float, float, str] | None:
    """Return the least room beside bosses and covers, negative where bodies overlap, what is needed [m], and whose.

    Args:
        sizing: As sized.
    """
    if not sizing.bearings or not sizing.design.housing.own:
        return None
    return min(_beside_bosses(sizing), key=lambda pair: (round(pair[0] - pair[1], 9), pair[2]), default=None)


def _beside_bosses(sizing: Sizing) -> Iterator[tuple[float, float, str]]:
    """Yield the room between a boss or cover and a body about another axis, what is needed [m], and both names."""
    holders, bent = holders_of(sizing), bending(sizing)
    bosses, covers = boss_bodies(sizing, holders), cover_bodies(sizing, holders)
    balls = np.array([ball_around(body) for body in sizing.arrangement.bodies])
    named = [(f"the boss of {name}", body) for name, body in bosses.items()]
    named += [(f"the cover of {name}", body) for name, body in covers]
    for name, body in named:
        ball = ball_around(body)
        near = np.linalg.norm(balls[:, :3] - ball[:3], axis=1) < balls[:, 3] + ball[3] + NEAR
        for other in (sizing.arrangement.bodies[k] for k in np.flatnonzero(near).tolist()):
            if other.shaft != body.shaft and other.part.kind is not Kind.BEARING:
                gap = room_between(body, other, enough=NEAR).gap
                yield gap, OFF + moved(other, bent), f"{name} and {other.part}"
        for beside, other in covers:
            if other.shaft != body.shaft:
                yield room_between(body, other, enough=NEAR).gap, OFF, f"{name} and the cover of {beside}"


def web_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield how many of the bosses of bearings walls, webs and collars of the housing carry.

    Args:
        sizing: As sized.
    """
    if not sizing.bearings or not sizing.design.housing.own:
        return
    bosses = carried_in_walls(sizing)
    bare = [name for carried in bosses if not carried.found for name in carried.bearings]
    count, why = (
        len(sizing.bearings),
        f"no web or collar finds a way to {', '.join(bare)}: {_BOSS_HELP}" if bare else "",
    )
    yield Check(
        GEARBOX, "webs of bosses", _WEB_CLAUSE, float(count - len(bare)), float(count), "number", exponent=None, why=why
    )


# ----------------------------------------------------------------------------------------------------------------------
# Whether a spanner reaches the screw of an end plate, or the nut that an end needs: a free cylinder outwards.
#
# Their outsides and the spanner's are estimates over the diameters of screw and seat.
# ----------------------------------------------------------------------------------------------------------------------


HEAD = 1.5
"""Outside of a nut that is not sized, or of a screw's head, over its thread, an estimate [-]."""
SPANNER = 5e-3
"""Wall of a socket spanner around a nut, an estimate [m]."""
_SPANNER_HELP = "another order of parts, or a nut at the other end, would help"


def spanner_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether a socket spanner comes to every end of a built shaft that no retaining ring holds.

    Args:
        sizing: As sized.
    """
    for held in retentions(sizing):
        if held.has_ring:
            continue
        what, head = _turned(held)
        others = [body for body in sizing.arrangement.bodies if body.shaft != held.shaft]
        axis, needed = _axis(sizing, held), head / 2.0 + SPANNER
        free = [(room_between(axis, body, enough=2.0 * needed).gap, body.name) for body in others]
        if free:
            gap, name = min(free, key=lambda pair: round(pair[0], 9))
            yield Check(
                PartId(Kind.SHAFT, held.shaft), f"access to a {what} at its {ENDS[held.way]} end", "socket spanner",
                max(gap, 0.0), needed, "length", exponent=None, place=f"at {held.outermost}, past {name}",
                why="" if gap >= needed else _SPANNER_HELP,
            )  # fmt: skip


def _turned(held: Retention) -> tuple[str, float]:
    """Return what is turned at an end, and its outer diameter [m]."""
    if held.has_plate and held.hole is not None:
        return "screw", HEAD * held.hole.thread
    if held.has_nut and held.nut is not None:
        return "nut", held.nut.outer
    return "nut", HEAD * held.diameter


def _axis(sizing: Sizing, held: Retention) -> Body:
    """Return the axis along which a spanner comes, from the held part out beyond all bodies."""
    frame, bodies = sizing.arrangement.frames[held.shaft], sizing.arrangement.bodies
    far = 10.0 * max(max(map(abs, body.origin)) + body.length + body.radius for body in bodies)
    start = held.place if held.way > 0 else held.place - far
    origin = Point(*(at + start * along for at, along in zip(frame.origin, frame.along, strict=True)))
    ends = (Station(0.0, 0.0), Station(far, 0.0))
    return Body(PartId(Kind.SHAFT, held.shaft), held.shaft, "", origin, frame.along, ends)


# ----------------------------------------------------------------------------------------------------------------------
# Whether the splines of rings bear the torque that the housing holds.
# ----------------------------------------------------------------------------------------------------------------------


_SPLINE_CLAUSE = "p = 2 T/(d_m h l z k) on splines in the housing; 2 τ (Tresca)"
_SPLINE_HELP = "a wider ring leaves room for longer splines; a stronger material of the housing bears more"


def ring_seat_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the pressure on the flanks of the splines of every ring that stands in a housing of the gearbox's own.

    Args:
        sizing: As sized.
    """
    for seat in ring_seats(sizing):
        yield Check(
            seat.ring.part, "ring seat pressure", _SPLINE_CLAUSE, seat.pressure, seat.permissible, "stress",
            at_most=True,
            symbol="p", place=f"W {seat.name}, T = {seat.torque:.4g} N m",
            why="" if seat.pressure <= seat.permissible else _SPLINE_HELP,
        )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# All of these checks of a design.
# ----------------------------------------------------------------------------------------------------------------------


def making_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether parts run clear of each other, can be ground and can be put together.

    Args:
        sizing: As sized.
    """
    yield from running_checks(sizing)
    yield from grinding_checks(sizing)
    yield from stack_checks(sizing)
    yield from order_checks(sizing)
    yield from spanner_checks(sizing)
    yield from bridge_checks(sizing)
    yield from boss_checks(sizing)
    yield from web_checks(sizing)
    yield from ring_seat_checks(sizing)


def built_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield every check of what holds parts, of seals, pressure centres and making, beside those of a sizing.

    Args:
        sizing: As sized.
    """
    yield from retention_checks(sizing)
    yield from holding_checks(sizing)
    yield from groove_checks(sizing)
    yield from seal_checks(sizing)
    yield from pressure_centre_checks(sizing)
    yield from making_checks(sizing)
