"""Where rolling bearings sit in a sized train, and what each bears for the torques that its meshes carry.

The reactions of a shaft on two bearings grow in proportion to the torques of its meshes; only the radial forces keep
their sign when a torque changes its own. So two sets of coefficients, one for each sign, give the load of a bearing at
any moment. Shafts that carry torque only have no seat here unless the design gives them bearings.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import Kind, PartId
from gearwright.parts.shafts import PointLoads, bearing_reactions
from gearwright.sizing.arranged import ShaftPlan
from gearwright.sizing.bearings.planet_seats import planet_seats
from gearwright.sizing.bearings.seat import Seat
from gearwright.sizing.bearings.unit_loads import unit_loads
from gearwright.sizing.carrying import ShaftSizing
from gearwright.sizing.loads import rotor_side, shaft_loads
from gearwright.sizing.rating import Context, context_of
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.spec import GROUND, Design
from gearwright.spec.design import BearingSeat

ENDS = ("first", "second")
"""The two bearings of a shaft that the design leaves open, from its first end."""


def bearing_seats(sizing: Sizing) -> tuple[Seat, ...]:
    """Return every seat whose load is known: on shafts that something bends or the design holds, and in each planet.

    Args:
        sizing: As sized.
    """
    rated = {sizing.reference.case: sizing.reference}
    context = unit_loads(context_of(sizing.design, sizing.train, sizing.teeth, rated, sizing.given))
    gears = {gear.name: gear for gear in sizing.gears}
    shafts = (seat for shaft in sizing.shafts for seat in _shaft_seats(context, sizing, shaft, gears))
    return (*shafts, *planet_seats(context, sizing.gears, sizing.carriers))


def _shaft_seats(
    context: Context, sizing: Sizing, shaft: ShaftSizing, gears: Mapping[str, GearSizing]
) -> Iterator[Seat]:
    plan = sizing.arrangement.plans[shaft.name]
    if not plan.seats and not shaft.bearings:
        return
    loads, axial = shaft_loads(context, shaft.name, plan, axes=sizing.arrangement.axes, gears=gears)
    forces = bearing_reactions(loads, plan.bearings)[1:]
    across, side = _rotor(sizing.design, shaft.name, plan)
    parts: dict[PartId, BearingSeat | None] = {PartId(Kind.BEARING, name): seat for name, seat in plan.seats.items()}
    k = 0
    for part, written in (parts or {PartId(Kind.BEARING, shaft.name, branch=end): None for end in ENDS}).items():
        bears = written is None or written.radial
        radial = forces[:, :, k] if bears else np.zeros((len(forces), 2))
        force = np.hstack([radial, axial[1:, None]])
        yield Seat(
            part=part,
            count=1,
            nodes=(shaft.name, GROUND),
            bore=shaft.diameter,
            room=np.inf,
            forward=force[0::2].copy(),
            backward=force[1::2].copy(),
            across=float(across[k]) if bears else 0.0,
            rotor_side=side,
            given=written,
            path=f"bearings.{part}" if written is not None else "",
        )
        k += bears


def _rotor(design: Design, shaft: str, plan: ShaftPlan) -> tuple[Floats, float]:
    """Return what a rotor's force and moment put on both radial bearings [N], and the sense of its thrust."""
    for name, rotor in design.airscrews.items():
        if rotor.shaft == shaft:
            place = plan.places[name]
            side = 1.0 if place >= sum(plan.bearings) / 2.0 else -1.0
            force, couple = np.array([rotor.in_plane_force]), np.array([side * rotor.hub_moment])
            loads = PointLoads(np.array([place]), force, couple, np.zeros(1))
            return np.abs(bearing_reactions(loads, plan.bearings)), rotor_side(plan, name)
    return np.zeros(2), 0.0
