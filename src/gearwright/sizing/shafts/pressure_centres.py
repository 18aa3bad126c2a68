"""Lives of taper bearings whose loads act at their pressure centres; sizing takes the middles of their widths."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gearwright.catalogue import pressure_centre
from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.sizing.bearings import bearing_sizings, life_check, seating
from gearwright.sizing.loads import shaft_forces
from gearwright.sizing.mounted import BearingSizing
from gearwright.sizing.rating import context_of
from gearwright.sizing.result import Sizing
from gearwright.spec.design import LOCATES

BESIDE = " with its load at the pressure centre"
"""What is added to the mode of a check of life."""


def centred_bearings(sizing: Sizing) -> Iterator[BearingSizing]:
    """Yield the taper bearings of built shafts as they bear what acts at their pressure centres.

    A bearing that takes thrust towards one end has the back of its inner ring, and its pressure centre, on the other
    side.

    Args:
        sizing: As sized.
    """
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    gears = {gear.name: gear for gear in sizing.gears}
    for shaft in sizing.built_shafts:
        chosen = {bearing.name: bearing.bearing for bearing in sizing.bearings if bearing.shaft == shaft.name}
        plan = sizing.arrangement.plans[shaft.name]
        off = {
            name: -LOCATES[seat.locates][0] * pressure_centre(chosen[name])
            for name, seat in plan.seats.items()
            if seat.kind == "taper"
        }
        if not off:
            continue
        radial = [name for name, seat in plan.seats.items() if seat.radial]
        first, second = (place + off.get(name, 0.0) for name, place in zip(radial, plan.bearings, strict=True))
        centred = replace(plan, bearings=(first, second))
        forces = shaft_forces(context, shaft.name, centred, axes=sizing.arrangement.axes, gears=gears)
        seated = seating(context, shaft.name, forces, chosen, slim=True, known={})
        yield from (bearing for bearing in bearing_sizings(seated, chosen, shaft.name, tuple(context.flows))
                    if bearing.name in off)  # fmt: skip


def pressure_centre_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the life of every taper bearing with its load at its pressure centre.

    Args:
        sizing: As sized.
    """
    for bearing in centred_bearings(sizing):
        part = PartId(Kind.BEARING, bearing.name)
        check = life_check(part, bearing.bearing, bearing.life, bearing.oiled, bearing.wanted_life, sizing.design)
        yield replace(check, mode=f"{check.mode}{BESIDE}")
