"""What the bearings inside planets bear for the torques of their meshes, of simple and of compound sets.

A body that one place holds gives its whole force to it. Where the design says how the gears of a body lie along the
axis, each of its bearings bears what statics gives it, the moment that tilts the body included.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from gearwright.identity import Role, gear_part
from gearwright.parts.gears import ISO53_A
from gearwright.sizing.bearings.planet_bodies import PlanetBody, Support, planet_bodies
from gearwright.sizing.bearings.seat import Seat
from gearwright.sizing.loads import mesh_place, tooth_forces
from gearwright.sizing.rating import Context, rim_below_roots
from gearwright.sizing.result import GearSizing
from gearwright.sizing.rolling import planet_push, set_pins
from gearwright.train import INTERNAL


class Carrying(Protocol):
    """What seats ask of a carrier."""

    @property
    def stage(self) -> str:
        """Set that it belongs to."""

    @property
    def shaft(self) -> str:
        """Shaft that it is part of, or ``ground``."""

    @property
    def radius(self) -> float:
        """Of the circle of its pins [m]."""

    @property
    def pin_diameter(self) -> float:
        """[m]"""


class Push(NamedTuple):
    """Force of one mesh on a body, for a torque of ±1 N m on gear a of one of its meshes."""

    row: int
    """Of the train's meshes."""
    place: float
    """Along the axis; 0 where it is not known [m]."""
    forward: tuple[float, float]
    """Tangential and radial, for a positive torque [N/(N m)]."""
    backward: tuple[float, float]
    """The same for a negative one."""


class Swung(NamedTuple):
    """A step that a carrier swings."""

    place: float
    """Along the axis; 0 where it is not known [m]."""
    moment: float
    """Its mass times the radius of its path [kg m]."""


class Borne(NamedTuple):
    """Everything that a body bears."""

    pushes: Sequence[Push]
    swung: Sequence[Swung]


def planet_seats(context: Context, gears: tuple[GearSizing, ...], carriers: Sequence[Carrying]) -> Iterator[Seat]:
    """Yield the bearing seats inside planets of some carriers.

    Args:
        context: With a flow for each sign of a unit torque on each mesh row, by the sign and the name of the row.
        gears: As sized, those on the carriers at least.
        carriers: As sized.
    """
    sized = {carrier.stage: carrier for carrier in carriers}
    for body in planet_bodies(context.design, gears):
        if body.stage not in sized:
            continue
        carrier, own = sized[body.stage], {gear.name: gear for gear in gears if gear.stage == body.stage}
        borne = _in_compound(context, body, own) if body.part.own else _in_simple(context, body, carrier, own)
        for support in body.supports or (None,):
            yield _seat(context, body, carrier, support, borne)


def shares(supports: tuple[Support, ...], own: Support | None, place: float) -> float:
    """Return the part of a force that one of the bearings of a rigid body bears [-].

    Args:
        supports: All of them; they yield alike.
        own: The one; None where one place bears all.
        place: Where the force acts [m].

    Source: equilibrium of forces and moments; of two bearings whatever their stiffness.
    """
    if own is None:
        return 1.0
    middle = sum(support.place for support in supports) / len(supports)
    spread = sum((support.place - middle) ** 2 for support in supports)
    return 1.0 / len(supports) + (place - middle) * (own.place - middle) / spread


def room_in(context: Context, step: GearSizing) -> float:
    """Return the largest bore of a planet whose rim its rules ask to stay: as stated for planets, or as for rings [m].

    Args:
        context: What sizing reads.
        step: The planet, or a step of it.
    """
    rating = context.ratings[step.stage]
    stated = rim_below_roots(rating, step.role)
    wall = rating.rules.rim_thickness_ratio if stated is None else stated + ISO53_A.dedendum
    return step.pitch_diameter - 2.0 * wall * step.module


def _seat(context: Context, body: PlanetBody, carrier: Carrying, own: Support | None, borne: Borne) -> Seat:
    """Return one seat of a body: all of it, or one of its bearings."""
    forward, backward = np.zeros((2, len(context.train.meshes), 3))
    for push in borne.pushes:
        share = shares(body.supports, own, push.place)
        forward[push.row, :2] += share * np.array(push.forward)
        backward[push.row, :2] += share * np.array(push.backward)
    fitting = own.fitting if own is not None else next(iter(body.fittings), None)
    holding = body.steps if own is None else (own.fitting.step,)
    return Seat(
        part=body.part if own is None else body.part._replace(own=own.fitting.step.own, number=own.number),
        count=body.steps[0].bodies,
        nodes=(carrier.shaft, body.node),
        bore=carrier.pin_diameter,
        room=min(room_in(context, step) for step in holding),
        forward=forward,
        backward=backward,
        swung=sum(step.moment * shares(body.supports, own, step.place) for step in borne.swung),
        carrier=carrier.shaft,
        fitted=None if fitting is None else fitting.asked,
        runs_on=None if fitting is None else fitting.step.runs_on,
        side_by_side=1 if own is not None or fitting is None else fitting.asked.side_by_side,
        path="" if fitting is None else fitting.path,
    )


def _in_simple(context: Context, body: PlanetBody, carrier: Carrying, gears: Mapping[str, GearSizing]) -> Borne:
    """Return what a planet of a simple set bears: sun and ring together, by the torque of the sun's mesh."""
    stage, pushes = carrier.stage, list[Push]()
    outwards, factor = planet_push(context, gears, stage), context.ratings[stage].load_factor
    for k, mesh in enumerate(context.train.meshes):
        if mesh.stage == stage and mesh.sign != INTERNAL:
            arm = 1.0 + gears[str(gear_part(stage, Role.RING))].teeth / gears[mesh.gears[0]].teeth
            force = factor * arm / carrier.radius
            pushes.append(Push(k, 0.0, (force, force * outwards), (force, force * outwards)))
    return Borne(pushes, [Swung(0.0, body.mass * carrier.radius)])


def _in_compound(context: Context, body: PlanetBody, gears: Mapping[str, GearSizing]) -> Borne:
    """Return what a body of a compound set bears: every mesh of each of its steps."""
    epicyclic, own = context.design.epicyclics[body.stage], {gear.own: gear for gear in gears.values()}
    steps, pushes = [step.own for step in body.steps], list[Push]()
    for k, mesh in enumerate(context.train.meshes):
        if not {step.name for step in body.steps} & set(mesh.gears):
            continue
        ahead, back = (
            tooth_forces(context, body.stage, own, context.flows[f"{sign}{mesh.name}"])[mesh.name] for sign in (1, -1)
        )
        for there, behind in zip(ahead, back, strict=True):
            if there.planet in steps:
                place = mesh_place(epicyclic, own, there.planet, there.mate) or 0.0
                pushes.append(Push(k, place, (there.tangential, there.radial), (behind.tangential, behind.radial)))
    radius, places = abs(set_pins(context, body.stage, own)[steps[0]]), body.places or (0.0,) * len(steps)
    swung = [Swung(place, step.turning_mass * radius) for place, step in zip(places, body.steps, strict=True)]
    return Borne(pushes, swung)
