"""Whether bodies that turn against each other stay clear while shafts bend: the nearest two of a gearbox.

What takes of the room between two bodies is how far each shaft bends there, how far its slope moves the rim of the
body, and what castings and fits are allowed to be off.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import NamedTuple

from gearwright.checks import Check, not_assessed
from gearwright.identity import GEARBOX, Kind, PartId
from gearwright.sizing import Sizing
from gearwright.sizing.arranged import Body
from gearwright.sizing.places import axes_among, of_one_set, room_between
from gearwright.spec import GROUND

OFF = 5e-4
"""What housings, fits and bearings may be off between two bodies, an estimate [m]."""
_HELP = "move them apart along their shafts ([layout.SHAFT.places]), turn an axis (angle_deg), or stiffen the shafts"


class Clearance(NamedTuple):
    """Two bodies that turn against each other."""

    one: Body
    other: Body
    gap: float
    """[m]"""
    needed: float
    """[m]"""


class Bent(NamedTuple):
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
    least = min(clearances(sizing), key=lambda pair: round(pair.gap / pair.needed, 9), default=None)
    if least is None:
        return
    mode, clause = "running clearance", "bending of shafts, and 0.5 mm"
    names = f"{least.one.part} and {least.other.part}"
    built = {shaft.name for shaft in sizing.built_shafts} | {GROUND}
    if least.gap < least.needed and not built >= {least.one.shaft, least.other.shaft}:
        why = f"{1e3 * least.gap:.3g} mm between {names}, as a first sizing places them: {_HELP}"
        yield not_assessed(GEARBOX, mode, clause, why)
        return
    why = "" if least.gap >= least.needed else _HELP
    yield Check(GEARBOX, mode, clause, least.gap, least.needed, "length", exponent=None, place=names, why=why)


def clearances(sizing: Sizing) -> Iterator[Clearance]:
    """Yield bodies that turn against each other and do not stand into each other, with the room between them.

    Gears in mesh, gears of one set, and coaxial shafts of a first sizing, whose places are open, are left out. So are
    two bearings: their outer rings stand still.

    Args:
        sizing: As sized.
    """
    bodies, bent = sizing.arrangement.bodies, bending(sizing)
    built, mates = {shaft.name for shaft in sizing.built_shafts}, mates_of(sizing)
    sets = frozenset(sizing.design.sets)
    for (one, first), (other, second) in combinations(zip(bodies, axes_among(bodies), strict=True), 2):
        if one.shaft == other.shaft or {one.part.kind, other.part.kind} == {Kind.BEARING}:
            continue
        if first == second and not built >= {one.shaft, other.shaft}:
            continue
        if of_one_set(one, other, sets) or frozenset((one.part, other.part)) in mates:
            continue
        gap = room_between(one, other, enough=0.01).gap
        if gap >= 0.0:
            yield Clearance(one, other, gap, OFF + moved(one, bent) + moved(other, bent))


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


def bending(sizing: Sizing) -> dict[tuple[str, str], Bent]:
    """Return shaft and gear or bearing -> how the shaft bends there; of built shafts.

    Args:
        sizing: As sized.
    """
    found = {}
    for shaft in sizing.built_shafts:
        deflections = dict(shaft.deflections)
        for place, slope in shaft.slopes:
            found[shaft.name, place] = Bent(deflections.get(place, 0.0), slope)
    return found


def moved(body: Body, bent: Mapping[tuple[str, str], Bent]) -> float:
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
