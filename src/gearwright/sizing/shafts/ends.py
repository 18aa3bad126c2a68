"""Retention of bearing rings, covers, shaft exits with seals, grooves and threads with the strength that is left."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise, takewhile
from typing import Literal, NamedTuple

from gearwright.base import Check, Kind, PartId, not_assessed, text
from gearwright.catalogue import (
    ELASTOMERS,
    Elastomer,
    HousingMaterial,
    LockNut,
    RadialSeal,
    ThreadUndercut,
    housing_materials,
    lip_speed,
    next_seal_shaft,
    seals_for,
    thread_run_out,
    thread_undercut,
)
from gearwright.catalogue.standard_parts import FAST, FAST_HARDNESS, HARDNESS, PRELOAD, PROOF_STRESS, SHAFT
from gearwright.memo import of_latest
from gearwright.parts.bearings import BearingKind
from gearwright.parts.iso6336 import GearSteel, Treatment
from gearwright.parts.material import vickers_of_rockwell
from gearwright.parts.shaft_fatigue import Shoulder
from gearwright.sizing.loads import shaft_forces
from gearwright.sizing.rating import context_of, method_for, rating_of
from gearwright.sizing.result import Sizing
from gearwright.sizing.shaft_results import BearingSizing, BuiltShaft, SectionStrength
from gearwright.sizing.shafts.retention import (
    Holder,
    Retention,
    Ring,
    clamped_plate,
    ends,
    made,
    plate,
    ring as ring_on,
    spacer,
    span_from,
    washer_and_nut,
)
from gearwright.sizing.shafts.sections import Section, Strength, strengths, undercuts_of
from gearwright.sizing.shafts.stretches import SHOULDER
from gearwright.spec.design import LOCATES

# ----------------------------------------------------------------------------------------------------------------------
# Ends of built shafts that leave the housing towards their machines: what lies beyond the outermost bearing.
# ----------------------------------------------------------------------------------------------------------------------


NEAR = 1e-6
"""Places that are nearer to each other are one [m]."""


class Leaving(NamedTuple):
    """An end of a shaft outside of the housing."""

    shaft: str
    start: float
    """Along the shaft from its first end: the outermost bearing's outer face, or that end [m]."""
    end: float
    """[m]"""
    radius: float
    """Largest of it [m]."""
    way: int
    """−1 at the shaft's first end, +1 at its second."""
    diameter: float
    """Beside the outermost bearing [m]."""

    @property
    def face(self) -> float:
        """Outer face of the outermost bearing, from the shaft's first end [m]."""
        return self.start if self.way > 0 else self.end


def leaving_of(sizing: Sizing) -> Iterator[Leaving]:
    """Yield the ends of built shafts on which machines sit beyond all bearings.

    Args:
        sizing: As sized.
    """
    for shaft in sizing.built_shafts:
        own = [bearing for bearing in sizing.bearings if bearing.shaft == shaft.name]
        places = [sizing.arrangement.plans[shaft.name].places[machine]
                  for machine, node in sizing.train.machines.items() if node == shaft.name]  # fmt: skip
        if own and places:
            span = (min(one.position - one.width / 2.0 for one in own),
                    max(one.position + one.width / 2.0 for one in own))  # fmt: skip
            yield from _ends(shaft, span, places)


def _ends(shaft: BuiltShaft, span: tuple[float, float], places: list[float]) -> Iterator[Leaving]:
    first, last = shaft.steps[0].start, shaft.steps[-1].end
    sides = ((-1, first, span[0], min(places) < span[0]), (1, span[1], last, max(places) > span[1]))
    for way, start, end, is_left in sides:
        inside = [step for step in shaft.steps if step.start < end - NEAR and step.end > start + NEAR]
        if is_left and end > start + NEAR:
            radius = max(step.diameter for step in inside) / 2.0
            yield Leaving(shaft.name, start, end, radius, way, inside[0 if way > 0 else -1].diameter)


# ----------------------------------------------------------------------------------------------------------------------
# Exits: where a shaft leaves the housing towards a machine, and the lip that may run there.
#
# Of elastomers the first is taken whose speed (SKF, by diameter) is not exceeded in any load case and that bears the
# oil: lips are warmer than the oil before them by 20 to 50 K (a maker's guide, SVKS), of which the least is asked.
# What no lip bears, as input shafts of turbines often are, has a labyrinth or a carbon face seal: neither is sized,
# weighed by more than an estimate, or drawn.
# ----------------------------------------------------------------------------------------------------------------------


LIP_WARMER = 20.0
"""How much warmer a lip is than the oil before it, the least of what makers name [K]."""
INSTEAD = "a labyrinth or a carbon face seal, as aircraft's gearboxes have, is to be designed: none is sized or drawn"


class Exit(NamedTuple):
    """Where a shaft leaves the housing."""

    machine: str
    """Towards which it leaves."""
    shaft: str
    way: int
    """−1 at the first end of a built shaft, +1 at the second; 0 of a shaft of the first sizing."""
    diameter: float
    """Of the shaft where a lip runs on it [m]; of a shaft of the first sizing its one diameter."""
    velocity: float
    """Of its surface there, the largest of all load cases [m/s]."""
    elastomer: Elastomer | None
    """Of a lip that bears it, or that the design asks for; None where none does."""
    seal: RadialSeal | None
    """Its smallest size; None without a lip, and of shafts of the first sizing."""
    lacking: str
    """Why it has no seal, and what helps; empty where it has one."""

    @property
    def limit(self) -> float | None:
        """Speed that its lip bears [m/s]; None without one."""
        return None if self.elastomer is None else lip_speed(self.diameter, self.elastomer)


@of_latest(1)
def exits_of(sizing: Sizing) -> tuple[Exit, ...]:
    """Return where shafts leave the housing; nothing where the gearbox has none of its own.

    Args:
        sizing: As sized.
    """
    return (*_built(sizing), *_first(sizing)) if sizing.design.housing.own else ()


def _built(sizing: Sizing) -> Iterator[Exit]:
    for end in leaving_of(sizing):
        plan = sizing.arrangement.plans[end.shaft]
        beyond = [name for name, node in sizing.train.machines.items()
                  if node == end.shaft and end.way * (plan.places[name] - end.face) > -NEAR]  # fmt: skip
        machine = min(beyond, key=lambda name: abs(plan.places[name] - end.face))
        made = _lip(sizing, machine, end.shaft, end.way, end.diameter)
        sizes = seals_for(end.diameter)
        if made.elastomer is not None and not sizes:
            wide, best = 1e3 * end.diameter, next_seal_shaft(end.diameter)
            more = "none is larger" if best is None else f"the next is for {1e3 * best:g} mm"
            lacking = f"ISO 6194-1 and SKF have no seal for {wide:g} mm, {more}: make the shaft that thick there"
            made = made._replace(lacking=lacking)
        yield made._replace(seal=sizes[0]) if made.elastomer is not None and sizes else made


def _first(sizing: Sizing) -> Iterator[Exit]:
    built = {shaft.name for shaft in sizing.built_shafts}
    diameters = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    for machine, shaft in sizing.train.machines.items():
        if shaft in diameters and shaft not in built:
            made = _lip(sizing, machine, shaft, 0, diameters[shaft])
            if made.elastomer is not None:
                told = f"{text(made.velocity, 'velocity')} on a first {1e3 * made.diameter:.3g} mm"
                bears = f"a lip of {made.elastomer.mark} bears {text(made.limit or 0.0, 'velocity')}"
                made = made._replace(lacking=f"{told}, and {bears}; shafts with [bearings] get seals")
            yield made


def _lip(sizing: Sizing, machine: str, shaft: str, way: int, diameter: float) -> Exit:
    """Return an exit with what its lip is of, as yet without a size."""
    asked, warm = sizing.design.shafting.seal, sizing.design.oil.temperature + LIP_WARMER
    velocity = max(abs(flow.speeds[shaft]) for flow in sizing.flows.values()) * diameter / 2.0
    bare = Exit(machine, shaft, way, diameter, velocity, None, None, "")
    if asked == "none":
        return bare._replace(lacking='the design asks for none (seal = "none")')
    if asked != "auto":
        return bare._replace(elastomer=next(one for one in ELASTOMERS if one.name == asked))
    for one in ELASTOMERS:
        if velocity <= lip_speed(diameter, one) and warm <= one.hottest:
            return bare._replace(elastomer=one)
    best = ELASTOMERS[-1]
    bears = text(lip_speed(diameter, best), "velocity")
    if warm > best.hottest:
        return bare._replace(lacking=f"no lip bears {warm:g} °C; {INSTEAD}")
    said = f"{text(velocity, 'velocity')} on {1e3 * diameter:.3g} mm are more than a lip of {best.mark} bears, {bears}"
    return bare._replace(lacking=f"{said}; {INSTEAD}")


# ----------------------------------------------------------------------------------------------------------------------
# Covers that screw onto the housing before outer rings, and the radial seals in them where shafts leave.
#
# A cover is a plate that holds the outer ring. Where its shaft leaves the housing, a boss stands on the plate, whose
# bore d_2 takes the seal: pressed in from outside against a step, so that it can be changed without taking the cover
# off, its lip towards the oil. It lies beyond what turns beside the bearing, a retaining ring or a nut.
# ----------------------------------------------------------------------------------------------------------------------


SCREWS = 6
"""Of a cover, an assumption [-]."""
SURPLUS = 1.5
"""Clamping of a cover's screws over the force that they hold, an assumption [-]."""
COVER_SCREWS = ((5e-3, 0.8e-3), (6e-3, 1.0e-3), (8e-3, 1.25e-3), (10e-3, 1.5e-3), (12e-3, 1.75e-3), (16e-3, 2e-3))
"""Thread and pitch of screws of covers, coarse threads of ISO 261 [m]."""
CIRCLE, RIM = 3.0, 5.5
"""Diameter of the circle of screws, and of the cover, beyond the bearing's over the screw's diameter [-]: a screw's
head of 1.5 d lies between, as does as much wall of the housing inside the thread."""
HEAD = 1.5
"""Diameter of a screw's head over its thread [-]: ISO 4762."""
STEP = 1.5e-3
"""Height of the step against which a seal is pressed, an assumption [m]."""
RELIEF = 2e-3
"""Depth of a cover with a seal over inner ring and cage, at least, an assumption [m]."""
CLEAR = 1e-3
"""Between a cover and what turns or slides beside it, an assumption [m]."""
SEAL = "radial seal"
"""Kind of holder that a seal is."""


def covers(
    sizing: Sizing, bearing: BearingSizing, way: int, force: float,
    *, leaves: Exit | None = None, turning: Sequence[Holder] = (), apart: float = 0.0,
) -> tuple[Holder, ...]:  # fmt: skip
    """Return the cover before an outer ring, and the seal in it where the shaft leaves there.

    Args:
        sizing: As sized.
        bearing: That it holds.
        way: Towards which end it lies.
        force: That the outer ring presses on it with [N].
        leaves: Of the shaft there, with its seal; None where none runs in the cover.
        turning: What goes round with the shaft beside the bearing, inside of the cover.
        apart: Between the outer ring and the cover, where the ring slides [m].
    """
    material = housing_materials()[sizing.design.housing.material]
    screw, clamps = next(((d, clamp) for d, clamp in _clamps() if clamp >= SURPLUS * force), _clamps()[-1])
    bore = bearing.outer_diameter - SHOULDER * (bearing.outer_diameter - bearing.inner_diameter)
    seal = None if leaves is None or leaves.elastomer is None else leaves.seal
    boss = 0.0 if seal is None else seal.bore + 2.0 * material.least_wall
    circle = max(bearing.outer_diameter + CIRCLE * screw, boss + HEAD * screw if seal else 0.0)
    allowed = math.sqrt(3.0) * material.shear_strength
    thick = max(material.least_wall, clamped_plate(force, (bore + bearing.outer_diameter) / 2.0, circle, allowed))
    face = bearing.position + way * (bearing.width / 2.0 + apart)
    designation, density = f"{SCREWS} screws M{1e3 * screw:g}, 8.8", material.density
    rim = circle + (RIM - CIRCLE) * screw
    if leaves is None or seal is None or leaves.elastomer is None:
        plain = made(bearing, "cover", designation, span_from(face, way, thick), (bore, rim), density, turns=False)
        return (plain._replace(force=force, capacity=clamps),)
    reached = max((way * (place - face) for part in turning for place in (part.start, part.end)), default=0.0)
    around = max((part.outer for part in turning), default=0.0)
    rings, at = _bossed(material, seal, (bore, rim, boss), (thick, reached, around))
    turned = tuple(sorted(Ring(*span_from(face + way * low, way, high - low), inner, outer)
                          for low, high, inner, outer in rings))  # fmt: skip
    whole = (turned[0].start, turned[-1].end)
    held = made(bearing, "cover", designation, whole, (min(one.bore for one in turned), rim), density, turns=False)
    held = held._replace(
        mass=sum(_volume(one) for one in turned) * density, force=force, capacity=clamps, stepped=turned
    )
    lip = made(bearing, SEAL, seal.designation(leaves.elastomer), span_from(face + way * at, way, seal.width),
               (seal.shaft, seal.bore), leaves.elastomer.density, turns=False)  # fmt: skip
    return held, lip._replace(lip=-way, mass=seal.mass(leaves.elastomer))


def _bossed(
    material: HousingMaterial, seal: RadialSeal, size: tuple[float, float, float], inside: tuple[float, float, float]
) -> tuple[list[tuple[float, float, float, float]], float]:
    """Return start, end, bore and outside of the parts of a cover with a seal, and where the seal begins [m].

    Args:
        material: Of the cover.
        seal: In it.
        size: Bore of the plain cover, outside of its plate and of its boss [m].
        inside: Thickness of its plate, how far beyond its face something turns, and the diameter of that [m].
    """
    (bore, rim, boss), (thick, reached, around) = size, inside
    hollow = max(reached + CLEAR, RELIEF)
    plate = max(thick, hollow + material.least_wall)
    step = min(bore, seal.bore - 2.0 * STEP)
    return [
        (0.0, hollow, max(bore, around + 2.0 * CLEAR), rim),
        (hollow, plate, step, rim),
        (plate, plate + seal.depth, seal.bore, boss),
    ], plate


def _volume(ring: Ring) -> float:
    return math.pi / 4.0 * (ring.outer**2 - ring.bore**2) * (ring.end - ring.start)


def _clamps() -> list[tuple[float, float]]:
    """Return diameters of screws [m] and what all of a cover's clamp with [N]: 0.7 S_p A_s each."""
    return [(d, SCREWS * PRELOAD * math.pi / 4.0 * (d - 0.9382 * pitch) ** 2 * _proof(d)) for d, pitch in COVER_SCREWS]


def _proof(thread: float) -> float:
    return next(stress for largest, stress in PROOF_STRESS if thread <= largest)


# ----------------------------------------------------------------------------------------------------------------------
# What holds both rings of every bearing along built shafts, on either side: the chain from part to part.
#
# On the shaft, in this order: a shoulder as high as the bearing wants, a gear of one piece with the shaft, a spacer
# up to the next part or shoulder, and beyond the outermost part of an end a retaining ring, a lock nut or an end
# plate; where nothing pulls and no ring has room, or torque passes, the interference fit of the seat alone. In the
# housing: a cover where no bearing of the shaft stands further out, a spacer between the outer rings of two bearings
# side by side, else a shoulder of the housing. A bearing that locates needs both rings where it takes thrust; one of
# cylindrical rollers that floats slides inside, so that both of its rings are held on both sides; another one that
# floats slides in the housing.
# ----------------------------------------------------------------------------------------------------------------------


BearingRing = Literal["inner", "outer"]
_NEAR = 1e-6
"""Places that are nearer to each other are one [m]."""
_SIDE = 30e-3
"""Bearings whose outer rings are nearer than this stand side by side: one spacer parts them, an assumption [m]."""
CLAUSE = "shoulders, spacers, rings, nuts, covers"


class Held(NamedTuple):
    """One side of one ring of a bearing."""

    bearing: str
    ring: BearingRing
    way: int
    """−1 towards the shaft's first end, +1 towards the second."""
    force: float
    """That may push this side [N]; 0 where the bearing only has to stay."""
    by: str
    """What holds it, in words; empty where nothing does."""
    holders: tuple[Holder, ...] = ()
    """Parts for it, none of which is the shaft's or the housing's own."""


@of_latest(1)
def held_rings(sizing: Sizing) -> tuple[Held, ...]:
    """Return what holds every side of every ring that has to be held.

    Args:
        sizing: As sized; none of bearings that the design does not name.
    """
    named = sizing.design.bearings
    if any(bearing.name not in named for bearing in sizing.bearings):
        return ()
    found = list[Held]()
    by_end = {(held.shaft, held.way): held for held in ends(sizing)}
    leaving = {(one.shaft, one.way): one for one in exits_of(sizing) if one.seal is not None}
    for shaft in sizing.built_shafts:
        for bearing in (one for one in sizing.bearings if one.shaft == shaft.name):
            for ring, way, force in _asked(sizing, bearing):
                if ring == "inner":
                    by, holders = _on_shaft(sizing, shaft, bearing, way, by_end.get((shaft.name, way)))
                else:
                    end, leaves = by_end.get((shaft.name, way)), leaving.get((shaft.name, way))
                    by, holders = _in_housing(sizing, bearing, way, force, end=end, leaves=leaves)
                found.append(Held(bearing.name, ring, way, force, by, holders))
    return tuple(found)


@of_latest(1)
def holders_of(sizing: Sizing) -> tuple[Holder, ...]:
    """Return the parts that hold bearings and seal their shafts, each once, in order along every shaft.

    Args:
        sizing: As sized.
    """
    every = dict.fromkeys(holder for held in held_rings(sizing) for holder in held.holders)
    every |= dict.fromkeys(_sealing(sizing, every))
    order = [shaft.name for shaft in sizing.built_shafts]
    return tuple(sorted(every, key=lambda holder: (order.index(holder.shaft), holder.start, holder.name)))


def holding_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield of every bearing how many of the sides that must be held are, and by what.

    Args:
        sizing: As sized.
    """
    sides: dict[str, list[Held]] = {}
    for held in held_rings(sizing):
        sides.setdefault(held.bearing, []).append(held)
    for name, every in sides.items():
        open_sides = [held for held in every if not held.by]
        why = " and ".join(
            f"nothing holds its {held.ring} ring towards the {_END[held.way]} end" for held in open_sides
        )
        yield Check(
            PartId(Kind.BEARING, name), "axial retention of its rings", CLAUSE,
            float(len(every) - len(open_sides)), float(len(every)), "number", exponent=None,
            place="; ".join(f"{held.ring} {_END[held.way]}: {held.by or 'nothing'}" for held in every), why=why,
        )  # fmt: skip
    for holder in holders_of(sizing):
        if holder.capacity and holder.force:
            yield Check(
                PartId(Kind.BEARING, holder.beside), "axial retention by its cover", "ISO 898-1, preload of 8.8",
                holder.capacity, holder.force, "force", symbol="F_V", place=holder.designation,
            )  # fmt: skip


_END = {-1: "first", 1: "second"}


def _asked(sizing: Sizing, bearing: BearingSizing) -> Iterator[tuple[BearingRing, int, float]]:
    """Yield the sides of its rings that have to be held, with what may push them [N]."""
    force = sizing.design.service.application_factor * abs(bearing.axial)
    signs = LOCATES[sizing.design.bearings[bearing.name].locates]
    for sign in signs:
        # A shaft that pushes towards one end does so from the other side of the inner ring.
        yield "inner", -sign, force
        yield "outer", sign, force
    if not signs:
        for way in (-1, 1):
            yield "inner", way, 0.0
            if bearing.bearing.kind is BearingKind.CYLINDRICAL:
                yield "outer", way, 0.0


def _on_shaft(
    sizing: Sizing, shaft: BuiltShaft, bearing: BearingSizing, way: int, end: Retention | None
) -> tuple[str, tuple[Holder, ...]]:
    """Return what holds an inner ring on one side, and the parts for it."""
    edge, seat = _edge(bearing, way), bearing.inner_diameter
    wanted = seat + SHOULDER * (bearing.outer_diameter - seat)
    if end is not None and end.outermost == bearing.name:
        return _at_end(sizing, bearing, end)
    place = edge
    steps = shaft.steps if way > 0 else shaft.steps[::-1]
    for step in steps:
        near, far = (step.start, step.end) if way > 0 else (step.end, step.start)
        if way * (far - place) < _NEAR:
            continue
        if step.seat and _is_integral(sizing, step.seat):
            return _reached(sizing, shaft, bearing, (edge, near), f"the teeth of {step.seat}")
        if step.diameter >= wanted - _NEAR:
            return _reached(sizing, shaft, bearing, (edge, near), "a shoulder")
        if step.seat and step.seat not in (bearing.name, *sizing.design.machines):
            return _reached(sizing, shaft, bearing, (edge, near), step.seat)
        if step.diameter < seat - _NEAR:
            break
        place = far
    return "its fit alone", ()


def _reached(
    sizing: Sizing, shaft: BuiltShaft, bearing: BearingSizing, span: tuple[float, float], against: str
) -> tuple[str, tuple[Holder, ...]]:
    """Return what a ring leans on, at once or by a spacer."""
    low, high = sorted(span)
    if high - low < _NEAR:
        return against, ()
    both = sorted((one for one in sizing.bearings if one.name in (bearing.name, against)), key=lambda one: one.position)
    seat = max(step.diameter for step in shaft.steps if step.start < high - _NEAR and step.end > low + _NEAR)
    outer = min(max(seat, one.inner_diameter) + SHOULDER * (one.outer_diameter - one.inner_diameter) for one in both)
    ring = spacer(sizing, both[0], (low, high), bore=seat, outer=outer, turns=True)
    return f"a spacer of {1e3 * (high - low):.4g} mm to {against}", (ring,)


def _at_end(sizing: Sizing, bearing: BearingSizing, end: Retention) -> tuple[str, tuple[Holder, ...]]:
    """Return what holds the outermost part of an end."""
    machines = [place for name, place in sizing.arrangement.plans[end.shaft].places.items()
                if name in sizing.design.machines and end.way * (place - end.place) > -_NEAR]  # fmt: skip
    if not end.force and machines:  # a groove there would weaken the shaft for nothing
        return "its fit alone", ()
    if end.ring is not None and end.has_ring:
        return end.ring.designation, (ring_on(sizing, bearing, end, end.ring),)
    if end.nut is not None and end.has_nut and end.force:
        return end.nut.designation, washer_and_nut(bearing, end, end.nut)
    if end.hole is not None and end.has_plate and end.force:
        return f"an end plate with {end.hole.screw}", plate(sizing, bearing, end, end.hole)
    return ("", ()) if end.force else ("its fit alone", ())


def _in_housing(
    sizing: Sizing, bearing: BearingSizing, way: int, force: float, *, end: Retention | None, leaves: Exit | None
) -> tuple[str, tuple[Holder, ...]]:
    """Return what holds an outer ring on one side, and the parts for it."""
    edge = _edge(bearing, way)
    further = [one for one in sizing.bearings if one.shaft == bearing.shaft and way * (one.position - edge) > 0.0]
    if not further:
        plan = sizing.arrangement.plans[bearing.shaft]
        nearest = min((0.0, plan.length), key=lambda place: abs(place - edge))
        outwards = 1 if nearest > edge else -1
        if outwards == way:
            made = covers(sizing, bearing, way, force, leaves=leaves, turning=_turning(sizing, bearing, end))
            return f"a cover with {made[0].designation}", made
        return "a shoulder of the housing", ()
    beside = min(further, key=lambda one: abs(one.position - edge))
    gap = sorted((edge, _edge(beside, -way)))
    if gap[1] - gap[0] > _SIDE or _crowded(sizing, bearing.shaft, gap):
        return "a shoulder of the housing", ()
    pair = (bearing, beside)
    outer = max(one.outer_diameter for one in pair)
    bore = min(one.outer_diameter - SHOULDER * (one.outer_diameter - one.inner_diameter) for one in pair)
    first = min(pair, key=lambda one: one.position)
    ring = spacer(sizing, first, (gap[0], gap[1]), bore=bore, outer=outer, turns=False)
    return f"a spacer of {1e3 * (gap[1] - gap[0]):.4g} mm to the outer ring of {beside.name}", (ring,)


def _turning(sizing: Sizing, bearing: BearingSizing, end: Retention | None) -> tuple[Holder, ...]:
    """Return what goes round beside the outermost bearing of an end."""
    return _at_end(sizing, bearing, end)[1] if end is not None and end.outermost == bearing.name else ()


def _sealing(sizing: Sizing, holders: Iterable[Holder]) -> Iterator[Holder]:
    """Yield the covers and seals of ends that leave where no cover holds a bearing; its outer ring slides."""
    named = sizing.design.bearings
    if any(bearing.name not in named for bearing in sizing.bearings):
        return
    sealed = {(holder.shaft, holder.beside) for holder in holders if holder.kind == "cover"}
    by_end = {(held.shaft, held.way): held for held in ends(sizing)}
    for leaves in exits_of(sizing):
        own = [bearing for bearing in sizing.bearings if bearing.shaft == leaves.shaft]
        if leaves.seal is not None and own:
            bearing = max(own, key=lambda one: leaves.way * _edge(one, leaves.way))
            if (leaves.shaft, bearing.name) not in sealed:
                turning = _turning(sizing, bearing, by_end.get((leaves.shaft, leaves.way)))
                yield from covers(sizing, bearing, leaves.way, 0.0, leaves=leaves, turning=turning, apart=CLEAR)


def _crowded(sizing: Sizing, shaft: str, gap: list[float]) -> bool:
    """Tell whether a gear stands between two places on a shaft."""
    places = sizing.arrangement.plans[shaft].places
    return any(gap[0] - _NEAR < places[gear.name] < gap[1] + _NEAR for gear in sizing.gears if gear.name in places)


def _edge(bearing: BearingSizing, way: int) -> float:
    return bearing.position + way * bearing.width / 2.0


def _is_integral(sizing: Sizing, seat: str) -> bool:
    return any(joint.part == seat and joint.kind == "integral" for joint in sizing.joints) and any(
        gear.name == seat for gear in sizing.gears
    )


# ----------------------------------------------------------------------------------------------------------------------
# Radial seals as they are placed: which exit has which, and whether lip, oil and running surface suit each other.
# ----------------------------------------------------------------------------------------------------------------------


SPEEDS = "SKF, pages of products HMS5"
SURFACE = "DIN 3760, as makers' sheets have it"


class Sealed(NamedTuple):
    """An exit with the seal that runs there."""

    leaves: Exit
    seal: Holder


def sealed_exits(sizing: Sizing) -> tuple[Sealed, ...]:
    """Return the exits in whose covers seals sit.

    Args:
        sizing: As sized.
    """
    seals = {(holder.shaft, -holder.lip): holder for holder in holders_of(sizing) if holder.kind == SEAL}
    return tuple(
        Sealed(leaves, seals[leaves.shaft, leaves.way])
        for leaves in exits_of(sizing)
        if (leaves.shaft, leaves.way) in seals
    )


def unsealed_exits(sizing: Sizing) -> tuple[Exit, ...]:
    """Return the exits without a seal, each with what it lacks.

    Args:
        sizing: As sized.
    """
    sealed = {one.leaves for one in sealed_exits(sizing)}
    return tuple(leaves for leaves in exits_of(sizing) if leaves not in sealed)


def seal_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield of every seal whether its lip bears speed and oil, and whether the shaft is long and hard enough under it.

    Args:
        sizing: As sized.
    """
    for leaves, seal in sealed_exits(sizing):
        part, lip = PartId(Kind.MACHINE, leaves.machine), leaves.elastomer
        assert lip is not None and leaves.limit is not None
        yield Check(
            part, "seal speed", SPEEDS, leaves.velocity, leaves.limit, "velocity", at_most=True, exponent=None,
            symbol="v", place=seal.designation,
        )  # fmt: skip
        yield Check(
            part, "seal temperature", SPEEDS, sizing.design.oil.temperature + LIP_WARMER, lip.hottest, "temperature",
            at_most=True, exponent=None, place=f"lip, {LIP_WARMER:g} K warmer than the oil",
        )  # fmt: skip
        free, needed = _surface(sizing, leaves, seal)
        yield Check(
            part, "seal seat", "as drawn", free, needed, "length", exponent=None,
            place=f"shaft {1e3 * leaves.diameter:g} {SHAFT}, from the bearing on",
            why="" if free >= needed - NEAR else "move what sits outside further out, or the bearing inwards",
        )  # fmt: skip
        yield _hardness(sizing, part, leaves)


def _surface(sizing: Sizing, leaves: Exit, seal: Holder) -> tuple[float, float]:
    """Return how far the shaft is free and of one diameter from its bearing on, and how far the seal reaches [m]."""
    face = next(end.face for end in leaving_of(sizing) if (end.shaft, end.way) == (leaves.shaft, leaves.way))
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == leaves.shaft)
    outwards = shaft.steps if leaves.way > 0 else shaft.steps[::-1]
    beyond = [step for step in outwards if leaves.way * ((step.start + step.end) / 2.0 - face) > 0.0]
    level = takewhile(lambda step: abs(step.diameter - leaves.diameter) < NEAR and not step.seat, beyond)
    free = sum(step.end - step.start for step in level)
    return free, max(leaves.way * (place - face) for place in (seal.start, seal.end))


def case_hardened(sizing: Sizing, shaft: str) -> dict[str, GearSteel]:
    """Return gears of one piece with a shaft that are case-hardened -> their steel; what runs under its seals is, too.

    Args:
        sizing: As sized.
        shaft: Its name.
    """
    found = dict[str, GearSteel]()
    stages = {gear.name: gear.stage for gear in sizing.gears}
    for joint in sizing.joints:
        if joint.kind == "integral" and joint.shaft == shaft and joint.part in stages:
            rating = rating_of(sizing.design, stages[joint.part], sizing.teeth)
            steel = method_for(rating).making(rating).iso_steel
            if steel is not None and steel.treatment is Treatment.CASE_HARDENED:
                found[joint.part] = steel
    return found


def _hardness(sizing: Sizing, part: PartId, leaves: Exit) -> Check:
    """Return whether the surface under a lip is hard enough, in HV."""
    mode, asked = "seal hardness", FAST_HARDNESS if leaves.velocity > FAST else HARDNESS
    hardness, needed = sizing.design.shaft_material.hardness, vickers_of_rockwell(asked)
    if hardness is None:
        why = f"the material of the shafts states none, and {asked:g} HRC are asked: harden the seat or fit a sleeve"
        return not_assessed(part, mode, SURFACE, why)
    if not case_hardened(sizing, leaves.shaft):
        why = (
            f"{asked:g} HRC are asked under the lip, and no teeth of one piece with this shaft are case-hardened, "
            "with which its seat would be: harden the seat or fit a sleeve"
        )
        return not_assessed(part, mode, SURFACE, why)
    return Check(
        part, mode, SURFACE, hardness, needed, "number", exponent=None, symbol="HV",
        place=f"{asked:g} HRC or more under the lip, 0.3 mm deep",
        why="" if hardness >= needed else "harden the seat by induction, or fit a hardened sleeve",
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Threads of lock nuts in built shafts: from where to where they are cut, how they end, what they leave of the shaft.
#
# Full turns begin where the nut does, beyond its washer, and go on outwards as far as the shaft is as thick, since the
# nut comes from there. Inwards a thread ends beneath washer and inner ring: in an undercut DIN 76 - A where the design
# asks for undercuts at its shoulders, else in turns that run out over 2.5 P.
# ----------------------------------------------------------------------------------------------------------------------


class Thread(NamedTuple):
    """A thread on a shaft."""

    shaft: str
    beside: str
    """Part that its nut holds."""
    way: int
    """Towards which end the nut is screwed off."""
    nut: LockNut
    foot: float
    """Where undercut or run-out begin, from the shaft's first end [m]."""
    first: float
    """Where its full turns begin [m]."""
    last: float
    """Where it starts, with a chamfer [m]."""
    undercut: ThreadUndercut | None
    """None where its turns run out."""

    @property
    def turns(self) -> tuple[float, float]:
        """Lower and upper end of its full turns [m]."""
        return min(self.first, self.last), max(self.first, self.last)

    @property
    def fading(self) -> tuple[float, float]:
        """Lower and upper end of its undercut, or of the turns that run out [m]."""
        return min(self.foot, self.first), max(self.foot, self.first)

    @property
    def bottom(self) -> float:
        """Diameter of its undercut, where it has one, else of its core [m]."""
        return self.nut.core if self.undercut is None else self.nut.thread - self.undercut.below


def threads(sizing: Sizing) -> Iterator[Thread]:
    """Yield the threads of every built shaft.

    Args:
        sizing: As sized.
    """
    kinds = {(holder.shaft, holder.beside) for holder in holders_of(sizing) if holder.kind == "lock nut"}
    for end in ends(sizing) if kinds else ():
        nut = end.nut
        if (end.shaft, end.outermost) not in kinds or nut is None:
            continue
        first = end.place + end.way * nut.washer
        cut = thread_undercut(nut.pitch) if sizing.design.shafting.shoulders == "undercut" else None
        foot = first - end.way * (thread_run_out(nut.pitch) if cut is None else cut.width)
        yield Thread(end.shaft, end.outermost, end.way, nut, foot, first, end.level, cut)


# ----------------------------------------------------------------------------------------------------------------------
# Grooves of retaining rings, threads of lock nuts and their undercuts in built shafts: what they leave of strength.
#
# They are found after a shaft is built, beyond its outermost bearings and hubs: it does not grow by them. Its safeties
# there are checks of their own.
# ----------------------------------------------------------------------------------------------------------------------


GROOVE_RADIUS = 0.1
"""At the bottom of a ring's groove over the thickness of the ring, at most: DIN 471 [-]."""
ROOT_RADIUS = 0.125
"""At the root of a thread over its pitch, at least: ISO 965-1 [-]."""
_SAME_PLACE = 1e-9
"""Places that are nearer to each other are one [m]."""


class Groove(NamedTuple):
    """What is cut into a shaft for a ring or a nut."""

    shaft: str
    start: float
    """From the shaft's first end [m]."""
    end: float
    """[m]"""
    diameter: float
    """That is left: of a thread its core [m]."""
    radius: float
    """At the bottom [m]."""
    what: str
    """Such as ``groove of DIN 471 - 30 x 1.5``, ``thread M30 x 1.5`` or ``undercut of thread M30 x 1.5``."""
    around: float
    """Diameter beside a round groove, whose stress is that of its shape [m]; 0 of what is as sharp as a ring's."""
    is_thread: bool = False


def grooves(sizing: Sizing) -> Iterator[Groove]:
    """Yield the grooves, threads and undercuts of threads of every built shaft.

    Args:
        sizing: As sized.
    """
    kinds = {(holder.shaft, holder.beside) for holder in holders_of(sizing) if holder.kind == "retaining ring"}
    for end in ends(sizing) if kinds else ():
        if (end.shaft, end.outermost) in kinds and end.has_ring and end.ring is not None:
            low, high = sorted((end.place, end.place + end.way * end.ring.groove_width))
            radius = GROOVE_RADIUS * end.ring.thickness
            yield Groove(end.shaft, low, high, end.ring.groove, radius, f"groove of {end.ring.designation}", 0.0)
    for thread in threads(sizing):
        nut, sharp = thread.nut, ROOT_RADIUS * thread.nut.pitch
        what = f"thread {nut.cut}"
        low, high = thread.turns if thread.undercut else (min(thread.foot, thread.last), max(thread.foot, thread.last))
        yield Groove(thread.shaft, low, high, nut.core, sharp, what, 0.0, is_thread=True)
        if thread.undercut is not None:
            foot, first = thread.fading
            yield Groove(
                thread.shaft, foot, first, thread.bottom, thread.undercut.radius, f"undercut of {what}", nut.thread
            )


def cut_steps(sizing: Sizing, shaft: BuiltShaft) -> tuple[tuple[float, float, float], ...]:
    """Return the steps of a shaft with its undercuts and the grooves of its rings, as start, end and radius [m].

    Args:
        sizing: As sized.
        shaft: One of its built shafts.
    """
    own = [groove for groove in grooves(sizing) if groove.shaft == shaft.name and not groove.is_thread]
    taken = [(groove.start, groove.end, groove.diameter) for groove in own]
    taken += [(min(cut.place, cut.edge), max(cut.place, cut.edge), cut.bottom) for cut in undercuts_of(sizing, shaft)]
    steps = []
    for step in shaft.steps:
        edges = {step.start, step.end}
        edges |= {edge for start, end, _ in taken for edge in (start, end) if step.start < edge < step.end}
        places = sorted(edges)
        for low, high in pairwise(places):
            cut = [left for start, end, left in taken if start < high - _SAME_PLACE and end > low + _SAME_PLACE]
            steps.append((low, high, min([step.diameter, *cut]) / 2.0))
    return tuple(steps)


def groove_strengths(sizing: Sizing) -> Iterator[SectionStrength]:
    """Yield the safeties of every groove and thread.

    Args:
        sizing: As sized.
    """
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    gears = {gear.name: gear for gear in sizing.gears}
    for shaft in sizing.built_shafts:
        own = [groove for groove in grooves(sizing) if groove.shaft == shaft.name]
        if not own:
            continue
        plan = sizing.arrangement.plans[shaft.name]
        forces = shaft_forces(context, shaft.name, plan, axes=sizing.arrangement.axes, gears=gears)
        names = forces.names(context.flows)
        judge = Strength(shaft.name, sizing.design, sizing.design.shaft_material, names, forces.rows)
        blank = max(step.diameter for step in shaft.steps)
        sections = [_section(groove, at, blank) for groove in own for at in (groove.start, groove.end)]
        yield from strengths(sections, forces, judge, bore=shaft.bore)


def groove_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the safeties of every groove and thread against fatigue and yielding, the worse of its two edges.

    Args:
        sizing: As sized.
    """
    asked = sizing.design.service
    worst: dict[tuple[str, str], SectionStrength] = {}
    for found in groove_strengths(sizing):
        key = (found.shaft, found.place)
        if key not in worst or found.fatigue_safety < worst[key].fatigue_safety:
            worst[key] = found
    for (shaft, place), found in worst.items():
        part = PartId(Kind.SHAFT, shaft)
        clause = "DIN 743-2, round groove" if found.fillet else "Shigley, table 7-1"
        safeties = (("fatigue", "n_f", found.fatigue_safety, asked.shaft_fatigue_safety),
                    ("yield", "n_y", found.yield_safety, asked.shaft_yield_safety))  # fmt: skip
        for mode, symbol, safety, least in safeties:
            yield Check(part, f"{mode} at its {place}", clause, safety, least, symbol=symbol, case=found.case)


def _section(groove: Groove, place: float, blank: float) -> Section:
    """Return a section at an edge of a groove."""
    if not groove.around:
        return Section(groove.what, groove.what, place, groove.diameter, blank, hub="groove", radius=groove.radius)
    depth = (groove.around - groove.diameter) / 2.0
    round_groove = Shoulder(groove.diameter, groove.around, groove.radius, depth)
    return Section(groove.what, groove.what, place, groove.diameter, blank, round_groove)
