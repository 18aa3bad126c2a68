"""What holds both rings of every bearing along built shafts, on either side: the chain from part to part.

On the shaft, in this order: a shoulder as high as the bearing wants, a gear of one piece with the shaft, a spacer up to
the next part or shoulder, and beyond the outermost part of an end a retaining ring, a lock nut or an end plate; where
nothing pulls and no ring has room, or torque passes, the interference fit of the seat alone. In the housing: a cover
where no bearing of the shaft stands further out, a spacer between the outer rings of two bearings side by side, else a
shoulder of the housing. A bearing that locates needs both rings where it takes thrust; one of cylindrical rollers that
floats slides inside, so that both of its rings are held on both sides; another one that floats slides in the housing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal, NamedTuple

from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.latest import of_latest
from gearwright.parts.bearings import BearingKind
from gearwright.sizing.mounted import BearingSizing, BuiltShaft
from gearwright.sizing.result import Sizing
from gearwright.sizing.sealing import Exit, exits_of
from gearwright.sizing.shafts.holding.covers import CLEAR, covers
from gearwright.sizing.shafts.holding.holders import Holder, plate, spacer, washer_and_nut
from gearwright.sizing.shafts.holding.holders import ring as ring_on
from gearwright.sizing.shafts.holding.retention import Retention, ends
from gearwright.sizing.shafts.stretches import SHOULDER
from gearwright.spec.design import LOCATES

Ring = Literal["inner", "outer"]
_NEAR = 1e-6
"""Places that are nearer to each other are one [m]."""
_SIDE = 30e-3
"""Bearings whose outer rings are nearer than this stand side by side: one spacer parts them, an assumption [m]."""
CLAUSE = "shoulders, spacers, rings, nuts, covers"


class Held(NamedTuple):
    """One side of one ring of a bearing."""

    bearing: str
    ring: Ring
    way: int
    """−1 towards the shaft's first end, +1 towards the second."""
    force: float
    """That may push this side [N]; 0 where the bearing only has to stay."""
    by: str
    """What holds it, in words; empty where nothing does."""
    holders: tuple[Holder, ...] = ()
    """Parts for it, none of which is the shaft's or the housing's own."""


@of_latest
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


@of_latest
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


def _asked(sizing: Sizing, bearing: BearingSizing) -> Iterator[tuple[Ring, int, float]]:
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
