"""Axial retention of bearings and gears: shoulders, retaining rings, lock nuts and end plates."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import takewhile
from typing import NamedTuple

from gearwright.base import Check, Kind, PartId, Role, apart, text
from gearwright.catalogue import (
    STEEL_DENSITY,
    CentreHole,
    LockNut,
    RetainingRing,
    centre_hole,
    lock_nut,
    retaining_ring,
)
from gearwright.sizing.result import GearSizing, MeshSizing, Sizing
from gearwright.sizing.shaft_results import BearingSizing, BuiltShaft
from gearwright.sizing.shafts.stretches import SHOULDER
from gearwright.spec.design import LOCATES

# ----------------------------------------------------------------------------------------------------------------------
# What holds bearings and gears along a built shaft: shoulders within, and at both ends a retaining ring, or more.
#
# Parts are slid on from both ends up to shoulders, or to spacers on what sits further in. What pushes a shaft against
# a shoulder is held by it; what would pull the shaft out of a bearing, or a gear off its seat, must be held beyond
# the outermost part of that end. There a ring of DIN 471 is tried: its groove must bear the force and have room.
# Where it does not, a lock nut is, whose thread on the seat must bear the force and have room, and which must go over
# what lies beyond. Where it does not, an end plate is, whose screw in the centre hole of a solid shaft must clamp
# with more than the force; it lies on a spacer as long as what the shaft sticks out. Where none can be, nothing
# holds: that check fails.
# ----------------------------------------------------------------------------------------------------------------------


CLAUSE = "DIN 471, groove"
NUT = "thread sheared at 200 N/mm² yield"
PLATE = "ISO 898-1, preload of 8.8"
_INSIDE = 1e-6
"""How far from an edge a place lies that is certainly on one side of it [m]."""
ENDS = {-1: "first", 1: "second"}
"""Way along a shaft -> the end that it leads to."""


class Seated(NamedTuple):
    """A bearing or gear on a shaft, or the hub of a machine."""

    name: str
    start: float
    """From the shaft's first end [m]."""
    end: float
    """[m]"""
    pulls: tuple[float, float]
    """Largest force that it must take from what holds it towards the first and the second end [N]."""
    is_machine: bool = False

    def edge(self, way: int) -> float:
        """Return its end on one side [m].

        Args:
            way: −1 towards the shaft's first end, +1 towards the second.
        """
        return self.end if way > 0 else self.start


class Retention(NamedTuple):
    """What an end of a shaft needs."""

    shaft: str
    way: int
    """−1 at the first end, +1 at the second."""
    outermost: str
    """Part that is held."""
    force: float
    """[N]"""
    diameter: float
    """Of its seat [m]."""
    room: float
    """Beside it as far as the shaft is as thick, to the next part or the end of the shaft [m]."""
    ring: RetainingRing | None
    """That fits the diameter."""
    place: float
    """End of the part that is held, from the shaft's first end [m]."""
    level: float
    """Where the shaft stops being as thick as the seat, from its first end [m]."""
    hole: CentreHole | None = None
    """In the end of the shaft, for the screw of an end plate; None where nothing can lie before that end."""
    nut: LockNut | None = None
    """Whose thread has the diameter of the seat, where it can be slid over what lies beyond."""

    @property
    def holds(self) -> bool:
        """Whether a ring has room and bears the force, or a nut does, or an end plate."""
        return self.has_ring or self.has_nut or self.has_plate

    @property
    def has_ring(self) -> bool:
        """Whether a retaining ring holds it."""
        return not _lacking(self)

    @property
    def has_nut(self) -> bool:
        """Whether a lock nut holds it, as no ring does."""
        return not self.has_ring and self.nut is not None and _fits(self, self.nut)

    @property
    def has_plate(self) -> bool:
        """Whether an end plate holds it, as neither ring nor nut does."""
        others = self.has_ring or self.has_nut
        return not others and self.hole is not None and self.hole.preload >= self.force


def ends(sizing: Sizing) -> Iterator[Retention]:
    """Yield both ends of every built shaft where something is held, also where no force pulls.

    Args:
        sizing: As sized.
    """
    for shaft in sizing.built_shafts:
        seated = list(_seated(sizing, shaft))
        core = _core(sizing, shaft)
        for way in ENDS:
            stack = [part for part in seated if core is None or way * (part.start + part.end - 2.0 * core) > 0.0]
            held = sorted((part for part in stack if not part.is_machine), key=lambda part: way * part.edge(way))
            if not held:
                continue
            force = max(part.pulls[way > 0] for part in held)
            found = _retention(shaft, way, held[-1], stack, force=force)
            yield found._replace(hole=_hole(sizing, shaft, found))


def _core(sizing: Sizing, shaft: BuiltShaft) -> float | None:
    """Return where a shaft is thickest, of a plain one where its own gear is; None where it has no shoulder [m]."""
    thick = max(shaft.steps, key=lambda step: step.diameter)
    if all(step.diameter > thick.diameter - _INSIDE for step in shaft.steps):
        own = {joint.part for joint in sizing.joints if joint.shaft == shaft.name and joint.kind == "integral"}
        return next(((step.start + step.end) / 2.0 for step in shaft.steps if step.seat in own), None)
    return (thick.start + thick.end) / 2.0


def retentions(sizing: Sizing) -> Iterator[Retention]:
    """Yield what both ends of every built shaft need where a force pulls there.

    Args:
        sizing: As sized.
    """
    yield from (held for held in ends(sizing) if held.force > 0.0)


def retention_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether what holds both ends of built shafts bears what pulls there; where nothing holds, it fails.

    Args:
        sizing: As sized.
    """
    for held in retentions(sizing):
        clause, bears, symbol, what = _bearing_up(held)
        yield Check(
            PartId(Kind.SHAFT, held.shaft), f"axial retention at its {ENDS[held.way]} end", clause, bears, held.force,
            "force", symbol=symbol, place=f"{what} beside {held.outermost}", why="" if held.holds else _objection(held),
        )  # fmt: skip


def _bearing_up(held: Retention) -> tuple[str, float, str, str]:
    """Return by what an end is held: source, the force that it bears [N], its symbol and what it is."""
    if held.has_ring and held.ring is not None:
        return CLAUSE, held.ring.capacity, "F_N", held.ring.designation
    if held.has_nut and held.nut is not None:
        return NUT, held.nut.capacity, "F", held.nut.designation
    if held.has_plate and held.hole is not None:
        return PLATE, held.hole.preload, "F_V", f"end plate with {held.hole.screw}"
    return CLAUSE, 0.0, "F_N", "nothing"


def _objection(held: Retention) -> str:
    """Return why nothing holds, and what would help."""
    nut = "no nut of DIN 981 goes on there" if held.nut is None else f"a {held.nut.designation} fits no better"
    return (
        f"{_lacking(held)}; {nut}, and no end plate can lie there: move it inwards, let the shaft go on as thick, or"
        " let another bearing locate the shaft"
    )


def _fits(held: Retention, nut: LockNut) -> bool:
    return held.room >= nut.room and nut.capacity >= held.force


def _hole(sizing: Sizing, shaft: BuiltShaft, held: Retention) -> CentreHole | None:
    """Return the centre hole for an end plate; None of a hollow shaft, or where it goes on thinner or to a machine."""
    end = shaft.steps[-1].end if held.way > 0 else shaft.steps[0].start
    machines = [
        place for name, place in sizing.arrangement.plans[shaft.name].places.items() if name in sizing.design.machines
    ]
    if shaft.bore or held.way * (end - held.place) > held.room + _INSIDE:
        return None
    if any(held.way * (place - held.place) > -_INSIDE for place in machines):
        return None
    return centre_hole(held.diameter)


def _lacking(held: Retention) -> str:
    """Return why no ring holds; empty where one does."""
    if held.ring is None:
        return f"DIN 471 has no ring for {1e3 * held.diameter:g} mm"
    if held.room < held.ring.room:
        needed, there = apart(held.ring.room, held.room, "length", 3)
        return f"groove and collar need {needed} beside it, and there are {there}"
    if held.ring.capacity < held.force:
        return f"the groove of {held.ring.designation} bears {text(held.ring.capacity, 'force')}"
    return ""


def _seated(sizing: Sizing, shaft: BuiltShaft) -> Iterator[Seated]:
    factor = sizing.design.service.application_factor
    for bearing in sizing.bearings:
        if bearing.shaft == shaft.name:
            signs, half = LOCATES[sizing.design.bearings[bearing.name].locates], bearing.width / 2.0
            force = factor * abs(bearing.axial)
            # The shaft pulls out of the bearing towards the end from which the bearing would follow it.
            pulls = (force if 1 in signs else 0.0, force if -1 in signs else 0.0)
            yield Seated(bearing.name, bearing.position - half, bearing.position + half, pulls)
    gears = {gear.name: gear for gear in sizing.gears}
    for joint in sizing.joints:
        if joint.shaft != shaft.name or joint.kind == "integral":
            continue
        gear = gears.get(joint.part)
        if gear is None:
            half = joint.length / 2.0
            yield Seated(joint.part, joint.position - half, joint.position + half, (0.0, 0.0), is_machine=True)
            continue
        half = gear.face_width * gear.bodies / len(gear.shafts) / 2.0
        thrust = factor * max(_thrust(sizing, gear, mesh) for mesh in sizing.meshes if gear.name in mesh.gears)
        yield Seated(gear.name, joint.position - half, joint.position + half, (thrust, thrust))


def _thrust(sizing: Sizing, gear: GearSizing, mesh: MeshSizing) -> float:
    """Return what pushes a gear along its shaft, either way: of a bevel wheel what is radial at its pinion [N].

    Halves of a double-helical gear push each other alone.
    """
    pair = sizing.design.pairs.get(gear.stage)
    if pair is not None and pair.halves > 1:
        return 0.0
    crossed = pair is not None and pair.kind == "bevel" and gear.role is Role.WHEEL
    return abs(mesh.radial_force if crossed else mesh.axial_force)


def _retention(shaft: BuiltShaft, way: int, part: Seated, stack: list[Seated], *, force: float) -> Retention:
    edge = part.edge(way)
    inside = min(max(edge - way * _INSIDE, shaft.steps[0].start), shaft.steps[-1].end)  # a part may hang over an end
    seat = next(step.diameter for step in shaft.steps if step.start <= inside <= step.end)
    beyond = [other.edge(-way) for other in stack if other.is_machine and way * (other.edge(-way) - edge) > -_INSIDE]
    outwards = shaft.steps if way > 0 else shaft.steps[::-1]
    past = [step for step in outwards if way * ((step.end if way > 0 else step.start) - edge) > _INSIDE]
    level = list(takewhile(lambda step: abs(step.diameter - seat) < _INSIDE, past))
    last = edge if not level else level[-1].end if way > 0 else level[-1].start
    room = max(0.0, min(way * (place - edge) for place in (*beyond, last)))
    nut, thinner = lock_nut(seat), past[len(level) :]
    passes = (
        nut is not None and room >= way * (last - edge) - _INSIDE and all(step.diameter <= nut.bore for step in thinner)
    )
    ring, nut = retaining_ring(seat), nut if passes else None
    return Retention(shaft.name, way, part.name, force, seat, room, ring, edge, last, nut=nut)


HALF = 0.5e-3
"""Step of lengths of seats [m]."""


def holding_room(seat: float, force: float) -> float:
    """Return how far a seat must go on beyond what is held there: for a retaining ring, a nut where no ring bears [m].

    In steps of half a millimetre, with something to spare.

    Args:
        seat: Its diameter [m].
        force: That pulls there [N].
    """
    ring, nut = retaining_ring(seat), lock_nut(seat)
    found = next((one.room for one in (ring, nut) if one is not None and one.capacity >= force), None)
    room = found or (0.0 if ring is None else ring.room)
    return math.ceil(room / HALF + 1e-6) * HALF


# ----------------------------------------------------------------------------------------------------------------------
# Turned parts that hold bearings along shafts: rings, nuts, end plates, spacers; how thick, how heavy.
# ----------------------------------------------------------------------------------------------------------------------


RING_HEIGHT = 0.08
"""How far a retaining ring stands out of the shaft over its diameter, an estimate [-]."""
LEAST_PLATE = 3e-3
"""Thinnest end plate, an assumption [m]."""


class Ring(NamedTuple):
    """A part of a holder with one bore and one outside."""

    start: float
    """From the shaft's first end [m]."""
    end: float
    """[m]"""
    bore: float
    """Diameter [m]; 0: none."""
    outer: float
    """Diameter [m]."""


class Holder(NamedTuple):
    """A part of revolution about a shaft."""

    name: str
    shaft: str
    beside: str
    """Bearing that it holds."""
    kind: str
    """retaining ring, lock washer, lock nut, end plate, spacer, housing spacer, cover or radial seal."""
    designation: str
    """Of the standard, or its screws; empty of a plain part."""
    start: float
    """From the shaft's first end [m]."""
    end: float
    """[m]"""
    bore: float
    """Diameter [m]; 0: none."""
    outer: float
    """Diameter [m]."""
    mass: float
    """[kg]"""
    turns: bool
    """Whether it goes round with the shaft."""
    force: float = 0.0
    """That it bears [N]."""
    capacity: float = 0.0
    """What its screws clamp with [N]; 0 of what has none, or is checked with the end of its shaft."""
    stepped: tuple[Ring, ...] = ()
    """Its parts along the shaft, of what is no plain ring: bore and outer are then the smallest and the largest."""

    lip: int = 0
    """Way along the shaft to which the lip of a seal looks: −1 to its first end, +1 to its second; 0 of all else."""

    @property
    def rings(self) -> tuple[Ring, ...]:
        """Its parts along the shaft, without gaps."""
        return self.stepped or (Ring(self.start, self.end, self.bore, self.outer),)


def ring(sizing: Sizing, bearing: BearingSizing, end: Retention, standard: RetainingRing) -> Holder:
    """Return a retaining ring in its groove beside a bearing.

    Args:
        sizing: As sized.
        bearing: That it holds.
        end: Of the shaft.
        standard: The ring.
    """
    del sizing
    span = span_from(end.place, end.way, standard.thickness)
    outer = standard.shaft * (1.0 + 2.0 * RING_HEIGHT)
    return made(
        bearing, "retaining ring", standard.designation, span, (standard.groove, outer), STEEL_DENSITY, turns=True
    )


def washer_and_nut(bearing: BearingSizing, end: Retention, nut: LockNut) -> tuple[Holder, Holder]:
    """Return a lock washer and the nut behind it, as heavy as their maker says.

    Args:
        bearing: That they hold.
        end: Of the shaft.
        nut: The nut.
    """
    behind = end.place + end.way * nut.washer
    sheet = made(
        bearing, "lock washer", "", span_from(end.place, end.way, nut.washer), (nut.thread, nut.face), 0.0, turns=True
    )
    body = made(
        bearing,
        "lock nut",
        nut.designation,
        span_from(behind, end.way, nut.width),
        (nut.thread, nut.outer),
        0.0,
        turns=True,
    )
    return sheet._replace(mass=nut.washer_mass), body._replace(mass=nut.mass)


def plate(sizing: Sizing, bearing: BearingSizing, end: Retention, hole: CentreHole) -> tuple[Holder, ...]:
    """Return an end plate before the end of a shaft, with the spacer on what sticks out of the bearing.

    Args:
        sizing: As sized.
        bearing: That they hold.
        end: Of the shaft.
        hole: For its screw.
    """
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == end.shaft)
    face = shaft.steps[-1].end if end.way > 0 else shaft.steps[0].start
    seat, material = bearing.inner_diameter, sizing.design.shaft_material
    outer = seat + SHOULDER * (bearing.outer_diameter - seat)
    allowed = (material.yield_strength or math.inf) / sizing.design.shafting.safety
    thick = max(clamped_plate(end.force, hole.thread, (seat + outer) / 2.0, allowed), LEAST_PLATE)
    disc = made(bearing, "end plate", f"screw {hole.screw}, 8.8", span_from(face, end.way, thick), (0.0, outer),
                 material.density, turns=True)._replace(force=end.force)  # fmt: skip
    if abs(face - end.place) < 1e-6:
        return (disc,)
    low, high = sorted((face, end.place))
    return spacer(sizing, bearing, (low, high), bore=seat, outer=outer, turns=True), disc


def spacer(
    sizing: Sizing, bearing: BearingSizing, span: tuple[float, float], *, bore: float, outer: float, turns: bool
) -> Holder:
    """Return a plain ring between two parts.

    Args:
        sizing: As sized.
        bearing: Beside which it lies.
        span: Where it begins and ends [m].
        bore: Diameter [m].
        outer: Diameter [m].
        turns: Whether it lies on the shaft, not in the housing.
    """
    kind, density = ("spacer" if turns else "housing spacer"), sizing.design.shaft_material.density
    return made(bearing, kind, "", span, (bore, outer), density, turns=turns)


def clamped_plate(force: float, inner: float, outer: float, allowed: float) -> float:
    """Return how thick a plate must be that is pressed along one circle and held along another [m].

    Args:
        force: [N].
        inner: Diameter of the smaller circle [m].
        outer: Of the larger [m].
        allowed: Stress [Pa].

    Source: strips along the radius, which bear alone: M = F (r_o − r_i) on 2 π r_i, σ = 6 M/(2 π r_i t²). Rings around
        them, which are left out, make it thicker than it must be.

    >>> round(1e3 * clamped_plate(33.5e3, 0.020, 0.071, 567e6), 1)
    12.0
    """
    return math.sqrt(6.0 * force * (outer - inner) / 2.0 / (math.pi * inner * allowed))


def span_from(place: float, way: int, thick: float) -> tuple[float, float]:
    """Return where a part begins and ends that lies on one side of a place [m].

    Args:
        place: [m].
        way: −1 towards the shaft's first end, +1 towards the second.
        thick: [m].
    """
    low, high = sorted((place, place + way * thick))
    return low, high


def made(
    bearing: BearingSizing, kind: str, designation: str, span: tuple[float, float], size: tuple[float, float],
    density: float, *, turns: bool,
) -> Holder:  # fmt: skip
    """Return a plain ring or disc as heavy as it is large.

    Args:
        bearing: Beside which it lies.
        kind: What it is.
        designation: Of the standard, or its screws.
        span: Where it begins and ends [m].
        size: Bore and outer diameter [m].
        density: [kg/m³].
        turns: Whether it goes round with the shaft.
    """
    bore, outer = size
    mass = math.pi / 4.0 * (outer**2 - bore**2) * (span[1] - span[0]) * density
    name = f"{kind} beside {bearing.name}, {1e3 * span[0]:.4g} mm"
    return Holder(name, bearing.shaft, bearing.name, kind, designation, *span, bore, outer, mass, turns)
