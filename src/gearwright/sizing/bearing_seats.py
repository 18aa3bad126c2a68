"""Bearing seats of shafts and planets, and bearing loads in proportion to the mesh torques."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

import numpy as np

from gearwright.base import Check, Floats, Force, Kind, Length, PartId, Role, gear_part
from gearwright.catalogue import Bearing, bearing, with_ratings
from gearwright.memo import of_latest
from gearwright.parts.gears import ISO53_A
from gearwright.parts.shafts import PointLoads, bearing_reactions
from gearwright.sizing.airscrew_loads import usual_loads
from gearwright.sizing.gear_geometry import planet_push, set_pins
from gearwright.sizing.loads import mesh_place, rotor_side, shaft_loads, tooth_forces
from gearwright.sizing.rating import Context, context_of, rim_below_roots
from gearwright.sizing.result import GearSizing, ShaftPlan, Sizing
from gearwright.sizing.shaft_results import PlanetBearingSizing, ShaftSizing
from gearwright.spec import GROUND, Design
from gearwright.spec.design import BearingSeat, PlanetBearing
from gearwright.train import INTERNAL, Mesh, PowerFlow

# ----------------------------------------------------------------------------------------------------------------------
# One bearing seat: what it bears in proportion to the torques of the meshes, and what sits there.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Seat:
    """One bearing seat, or several equal ones."""

    part: PartId
    """Bearing by the design's name, first or second of a shaft, or of the planets of a stage."""
    count: int
    """Equal seats: planets of a set [-]."""
    nodes: tuple[str, str]
    """What turns inside and what outside; the housing is ``ground``."""
    bore: Length
    """Diameter of shaft or pin [m]."""
    room: Length
    """Largest outside diameter: inside the rim of a planet; ∞ in the housing [m]."""
    forward: Floats
    """Force of the meshes along y and z on the bearing, or tangential and radial on a pin, and along x on the whole
    shaft, for a torque of 1 N m on gear a of one single mesh of each row, shape (meshes, 3) [N/(N m)]."""
    backward: Floats
    """The same for a torque of −1 N m."""
    swung: float = 0.0
    """Mass of a planet times the radius of its path [kg m]."""
    carrier: str = GROUND
    """Node whose speed swings it."""
    across: Force = 0.0
    """Of a rotor's force and moment, in any direction [N]."""
    rotor_side: float = 0.0
    """Sense along x in which a rotor's thrust pulls the shaft; 0 without a rotor [-]."""
    given: BearingSeat | None = None
    """What the design says of one on a shaft; the two usual bearings of a shaft have none."""
    fitted: PlanetBearing | None = None
    """What the design asks for inside a planet."""
    runs_on: PlanetBearingSizing | None = None
    """What was taken for it."""
    side_by_side: int = 1
    """Bearings of that kind in one seat [-]."""
    path: str = ""
    """Where the design says what sits there; empty for the two usual bearings of a shaft."""

    @property
    def holds_shaft(self) -> bool:
        """Whether it holds its shaft in the housing; what sits inside a planet holds none, and bears no thrust."""
        return self.nodes[1] == GROUND

    @property
    def name(self) -> str:
        """Its label: as the design calls it; else ``SHAFT.first``, ``SHAFT.second``, or ``STAGE.planet``."""
        return str(self.part)


def seat_forces(seat: Seat, torques: Floats, carrier_speed: Floats) -> tuple[Floats, Floats]:
    """Return the radial force on one seat and the meshes' force along its shaft [N], of the shape of the torques' rows.

    Args:
        seat: The seat.
        torques: On gear a of one single mesh of each row, shape (..., meshes) [N m].
        carrier_speed: Speed of what swings a planet, shape (...) [rad/s].

    Source: equilibrium; m r ω² of a planet stands across its tangential force; a rotor points where it loads most.
    """
    return borne(seat, pushed(seat, torques), carrier_speed)


def pushed(seat: Seat, torques: Floats) -> Floats:
    """Return what meshes push on one seat, across it and along its shaft, shape (..., 3) [N].

    Args:
        seat: The seat.
        torques: On gear a of one single mesh of each row, shape (..., meshes) [N m].
    """
    force: Floats = np.maximum(torques, 0.0) @ seat.forward + np.maximum(-torques, 0.0) @ seat.backward
    return force


def seat_forces_along(seat: Seat, torques: Floats, carrier_speed: Floats) -> tuple[Floats, Floats]:
    """Return `seat_forces` of many loads, each of which has the same bits whatever others it is found with.

    Args:
        seat: The seat.
        torques: On gear a of one single mesh of each row, shape (n, meshes) [N m].
        carrier_speed: Speed of what swings a planet, shape (n,) or (1,) [rad/s].
    """
    force = np.zeros((len(torques), 3))
    for torque, forward, backward in zip(torques.T, seat.forward, seat.backward, strict=True):
        if forward.any() or backward.any():  # not the meshes of other shafts
            back = torque < 0.0
            along = np.where(back[:, None], backward, forward) if back.any() else forward
            force += np.abs(torque)[:, None] * along
    return borne(seat, force, carrier_speed)


def borne(seat: Seat, force: Floats, carrier_speed: Floats) -> tuple[Floats, Floats]:
    """Return the radial force on one seat, with what swings there, and the force along its shaft [N].

    Args:
        seat: The seat.
        force: From `pushed` [N].
        carrier_speed: Speed of what swings a planet, shape (...) [rad/s].
    """
    radial = np.hypot(force[..., 0], force[..., 1] + seat.swung * carrier_speed**2)
    return radial + seat.across, force[..., 2]


# ----------------------------------------------------------------------------------------------------------------------
# Flows in which one row of meshes carries a unit torque: what seats bear in proportion is read from them.
# ----------------------------------------------------------------------------------------------------------------------


def unit_loads(context: Context) -> Context:
    """Return what sizing reads, with the first case and then one for each sign of a unit torque on each mesh row.

    They are called by the sign and the row: ``1first.sun-planet`` and ``-1first.sun-planet``.

    Args:
        context: With the cases of the design, or the first of them.
    """
    rated = context.reference
    cases = {
        f"{sign}{mesh.name}": _unit(context, rated, mesh, sign) for mesh in context.train.meshes for sign in (1, -1)
    }
    return replace(context, flows={rated.case: rated, **cases})


def _unit(context: Context, rated: PowerFlow, loaded: Mesh, sign: int) -> PowerFlow:
    """Return a flow in which one row of meshes carries ±1 N m on gear a of each single mesh, without losses."""
    meshes = {name: replace(flow, torques=(0.0, 0.0, 0.0)) for name, flow in rated.meshes.items()}
    torque = sign * loaded.count
    ratio = loaded.sign * context.teeth[loaded.gears[1]] / context.teeth[loaded.gears[0]]
    torques = (torque, -torque * ratio, torque * (ratio - 1.0))
    meshes[loaded.name] = replace(rated.meshes[loaded.name], torques=torques)
    return PowerFlow("", rated.speeds, {}, {}, meshes)


# ----------------------------------------------------------------------------------------------------------------------
# What turns on a pin: a planet, or the steps of a stepped one, with the bearings that the design names for it.
# ----------------------------------------------------------------------------------------------------------------------


MAKER = "maker's ratings, given by the user"


def as_made(asked: PlanetBearing, designation: str) -> Bearing:
    """Return what the design names for a planet, with the maker's ratings where it gives both.

    Args:
        asked: As in the design.
        designation: In the catalogue.
    """
    standard = bearing(designation)
    if asked.dynamic_rating is None or asked.static_rating is None:
        return standard
    return with_ratings(standard, asked.dynamic_rating, asked.static_rating, source=MAKER)


class Fitting(NamedTuple):
    """What the design names for a planet or one of its steps."""

    step: GearSizing
    """That holds it."""
    asked: PlanetBearing
    path: str
    """Where it stands in the design file."""

    @property
    def runs_on(self) -> PlanetBearingSizing:
        """What was taken for it."""
        assert self.step.runs_on is not None
        return self.step.runs_on

    @property
    def spacing(self) -> float:
        """From the middle of one of the bearings to the next [m]."""
        return self.asked.spacing or self.runs_on.width / self.runs_on.side_by_side

    @property
    def width(self) -> float:
        """From the outer face of the first to that of the last [m]."""
        return (self.asked.side_by_side - 1) * self.spacing + self.runs_on.width / self.runs_on.side_by_side


class Support(NamedTuple):
    """One bearing of a body whose gears and bearings have a place along the axis."""

    fitting: Fitting
    number: int | None
    """From 1, among those side by side; None where it is alone in its step."""
    place: float
    """Its middle, from the carrier's plate [m]."""


class PlanetBody(NamedTuple):
    """One of the equal pieces that turn on the pins of a set."""

    stage: str
    steps: tuple[GearSizing, ...]
    """One gear, or the steps of a stepped planet, that first which its node is called by."""
    places: tuple[float, ...]
    """Middle of each step from the carrier's plate [m]; empty where the design does not say all."""
    fittings: tuple[Fitting, ...]
    """None where the design names no bearing."""

    @property
    def part(self) -> PartId:
        """Its bearing, called as the first of its steps."""
        return self.steps[0].part._replace(kind=Kind.BEARING)

    @property
    def node(self) -> str:
        """Of the train."""
        return self.steps[0].shafts[0]

    @property
    def mass(self) -> float:
        """Of one, with what turns of its bearings [kg]."""
        return sum(step.turning_mass for step in self.steps)

    @property
    def width(self) -> float:
        """Of its steps side by side [m]."""
        return sum(step.face_width for step in self.steps)

    @property
    def supports(self) -> tuple[Support, ...]:
        """Every bearing by itself, where two or more hold a body whose gears have places; else none."""
        if not self.places:
            return ()
        places = {step.name: place for step, place in zip(self.steps, self.places, strict=True)}
        found = [support for fitting in self.fittings for support in _supports(fitting, places[fitting.step.name])]
        return tuple(found) if len(found) > 1 else ()


def planet_bodies(design: Design, gears: Sequence[GearSizing]) -> Iterator[PlanetBody]:
    """Yield what turns on the pins of every planetary and compound set.

    Args:
        design: As read.
        gears: As sized.
    """
    planets = [gear for gear in gears if gear.role is Role.PLANET]
    for name, stage in design.planetaries.items():
        (planet,) = (gear for gear in planets if gear.stage == name)
        asked, path = stage.planet_bearing, f"planetaries.{name}.planet_bearing"
        yield PlanetBody(name, (planet,), (), () if asked is None else (Fitting(planet, asked, path),))
    for name, epicyclic in design.epicyclics.items():
        own = {gear.own: gear for gear in planets if gear.stage == name}
        for body in dict.fromkeys(epicyclic.body(planet) for planet in epicyclic.planets):
            turning = sorted((step for step in own if epicyclic.body(step) == body), key=lambda step: step != body)
            steps = {step: own[step] for step in turning}
            places = [place for step in steps if (place := epicyclic.planets[step].place) is not None]
            fittings = (
                Fitting(gear, asked, f"epicyclics.{name}.planets.{step}.bearing")
                for step, gear in steps.items()
                if (asked := epicyclic.planets[step].bearing) is not None
            )
            known = tuple(places) if len(places) == len(steps) else ()
            yield PlanetBody(name, tuple(steps.values()), known, tuple(fittings))


def _supports(fitting: Fitting, place: float) -> Iterator[Support]:
    count = fitting.asked.side_by_side
    for k in range(count):
        yield Support(fitting, k + 1 if count > 1 else None, place + (k - (count - 1) / 2.0) * fitting.spacing)


# ----------------------------------------------------------------------------------------------------------------------
# What the bearings inside planets bear for the torques of their meshes, of simple and of compound sets.
#
# A body that one place holds gives its whole force to it. Where the design says how the gears of a body lie along the
# axis, each of its bearings bears what statics gives it, the moment that tilts the body included.
# ----------------------------------------------------------------------------------------------------------------------


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


class BodyLoads(NamedTuple):
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


def _seat(context: Context, body: PlanetBody, carrier: Carrying, own: Support | None, borne: BodyLoads) -> Seat:
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


def _in_simple(context: Context, body: PlanetBody, carrier: Carrying, gears: Mapping[str, GearSizing]) -> BodyLoads:
    """Return what a planet of a simple set bears: sun and ring together, by the torque of the sun's mesh."""
    stage, pushes = carrier.stage, list[Push]()
    outwards, factor = planet_push(context, gears, stage), context.ratings[stage].load_factor
    for k, mesh in enumerate(context.train.meshes):
        if mesh.stage == stage and mesh.sign != INTERNAL:
            arm = 1.0 + gears[str(gear_part(stage, Role.RING))].teeth / gears[mesh.gears[0]].teeth
            force = factor * arm / carrier.radius
            pushes.append(Push(k, 0.0, (force, force * outwards), (force, force * outwards)))
    return BodyLoads(pushes, [Swung(0.0, body.mass * carrier.radius)])


def _in_compound(context: Context, body: PlanetBody, gears: Mapping[str, GearSizing]) -> BodyLoads:
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
    return BodyLoads(pushes, swung)


# ----------------------------------------------------------------------------------------------------------------------
# Where rolling bearings sit in a sized train, and what each bears for the torques that its meshes carry.
#
# The reactions of a shaft on two bearings grow in proportion to the torques of its meshes; only the radial forces
# keep their sign when a torque changes its own. So two sets of coefficients, one for each sign, give the load of a
# bearing at any moment. Shafts that carry torque only have no seat here unless the design gives them bearings.
# ----------------------------------------------------------------------------------------------------------------------


ENDS = ("first", "second")
"""The two bearings of a shaft that the design leaves open, from its first end."""


@of_latest(2)
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
    across, side = _rotor(sizing.design, sizing.flows, shaft.name, plan)
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


def _rotor(design: Design, flows: Mapping[str, PowerFlow], shaft: str, plan: ShaftPlan) -> tuple[Floats, float]:
    """Return what a rotor's force and moment put on both radial bearings [N], and the sense of its thrust."""
    for name, rotor in design.airscrews.items():
        if rotor.shaft == shaft:
            place = plan.places[name]
            side = 1.0 if place >= sum(plan.bearings) / 2.0 else -1.0
            usual = usual_loads(design, flows, name, in_bearings=bool(plan.seats))
            force, couple = np.array([usual.force]), np.array([side * usual.moment])
            loads = PointLoads(np.array([place]), force, couple, np.zeros(1))
            return np.abs(bearing_reactions(loads, plan.bearings)), rotor_side(plan, name)
    return np.zeros(2), 0.0


# ----------------------------------------------------------------------------------------------------------------------
# Whether what a planet turns on has room inside it.
# ----------------------------------------------------------------------------------------------------------------------


def named_room(design: Design, gears: tuple[GearSizing, ...]) -> tuple[Check, ...]:
    """Return whether the bearings that a design names have room in its planets, and planets beside their carrier.

    Bearings in one step of a body have the width of all its steps; those in several steps each that of their own.

    Args:
        design: As read.
        gears: As sized.
    """
    checks = list[Check]()
    for body in planet_bodies(design, gears):
        for step, place in zip(body.steps, body.places, strict=False):
            checks.append(_beside_plate(step, place))
        for fitting in body.fittings:
            own = body if len(body.fittings) == 1 else body._replace(steps=(fitting.step,))
            checks.append(planet_room(own, fitting.runs_on.designation, fitting.width))
    return tuple(checks)


def planet_room(body: PlanetBody, designation: str, width: float) -> Check:
    """Return whether what a planet turns on is as wide as the planet at most.

    Args:
        body: The planet, or the steps that the bearings stand in.
        designation: Of the bearings.
        width: Of all that stand side by side [m].
    """
    part = body.part._replace(kind=Kind.GEAR)
    return Check(
        part, "room for its bearing", "width of bearings and gear", width, body.width, "length",
        at_most=True, exponent=None, place=f"{designation} in {part}",
    )  # fmt: skip


def _beside_plate(step: GearSizing, place: float) -> Check:
    """Return whether a planet stands clear of the plate of its carrier."""
    return Check(
        step.part, "room beside the plate", "half its width, and its place", step.face_width / 2.0, place, "length",
        at_most=True, exponent=None,
    )  # fmt: skip
