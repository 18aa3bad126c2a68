"""Where rolling bearings sit in a sized train, and what each bears for the torques that its meshes carry.

The reactions of a shaft on two bearings grow in proportion to the torques of its meshes; only the radial forces keep
their sign when a torque changes its own. So two sets of coefficients, one for each sign, give the load of a bearing at
any moment. A planet's pin bears the tangential forces of its two meshes, and across them the centrifugal force of the
planet and, with shifted teeth, what unequal working angles leave of the radial forces. Shafts that carry torque only
have no seat here unless the design gives them bearings.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import Kind, PartId, Role, gear_part
from gearwright.parts.shafts import PointLoads, bearing_reactions
from gearwright.sizing.arranged import ShaftPlan
from gearwright.sizing.carrying import ShaftSizing
from gearwright.sizing.loads import rotor_side, shaft_loads
from gearwright.sizing.rating import Context, context_of
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.sizing.rolling import planet_push
from gearwright.spec import GROUND, Design
from gearwright.spec.design import BearingSeat
from gearwright.train import INTERNAL, Mesh, PowerFlow
from gearwright.units import Force, Length

ENDS = ("first", "second")
"""The two bearings of a shaft that the design leaves open, from its first end."""


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
    """What the design says of it; planets and the two usual bearings of a shaft have none."""

    @property
    def name(self) -> str:
        """Its label: as the design calls it; else ``SHAFT.first``, ``SHAFT.second``, or ``STAGE.planet``."""
        return str(self.part)


def bearing_seats(sizing: Sizing) -> tuple[Seat, ...]:
    """Return every seat whose load is known: on shafts that something bends or the design holds, and in each planet.

    Args:
        sizing: As sized.
    """
    context, gears = _unit_loads(sizing), {gear.name: gear for gear in sizing.gears}
    shafts = (seat for shaft in sizing.shafts for seat in _shaft_seats(context, sizing, shaft, gears))
    return (*shafts, *_planet_seats(context, sizing, gears))


def seat_forces(seat: Seat, torques: Floats, carrier_speed: Floats) -> tuple[Floats, Floats]:
    """Return the radial force on one seat and the meshes' force along its shaft [N], of the shape of the torques' rows.

    Args:
        seat: The seat.
        torques: On gear a of one single mesh of each row, shape (..., meshes) [N m].
        carrier_speed: Speed of what swings a planet, shape (...) [rad/s].

    Source: equilibrium; m r ω² of a planet stands across its tangential force; a rotor points where it loads most.
    """
    force = np.maximum(torques, 0.0) @ seat.forward + np.maximum(-torques, 0.0) @ seat.backward
    radial = np.hypot(force[..., 0], force[..., 1] + seat.swung * carrier_speed**2)
    return radial + seat.across, force[..., 2]


def _unit_loads(sizing: Sizing) -> Context:
    """Return what sizing reads, with a case for each sign of a unit torque on each mesh row, after the rated one."""
    design, train = sizing.design, sizing.train
    rated = sizing.reference
    cases = {f"{sign}{mesh.name}": _unit(sizing, rated, mesh, sign) for mesh in train.meshes for sign in (1, -1)}
    return context_of(design, train, sizing.teeth, {rated.case: rated, **cases}, sizing.given)


def _unit(sizing: Sizing, rated: PowerFlow, loaded: Mesh, sign: int) -> PowerFlow:
    """Return a flow in which one row of meshes carries ±1 N m on gear a of each single mesh, without losses."""
    meshes = {name: replace(flow, torques=(0.0, 0.0, 0.0)) for name, flow in rated.meshes.items()}
    torque = sign * loaded.count
    ratio = loaded.sign * sizing.teeth[loaded.gears[1]] / sizing.teeth[loaded.gears[0]]
    torques = (torque, -torque * ratio, torque * (ratio - 1.0))
    meshes[loaded.name] = replace(rated.meshes[loaded.name], torques=torques)
    return PowerFlow("", rated.speeds, {}, {}, meshes)


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
            forward=force[0::2],
            backward=force[1::2],
            across=float(across[k]) if bears else 0.0,
            rotor_side=side,
            given=written,
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


def _planet_seats(context: Context, sizing: Sizing, gears: Mapping[str, GearSizing]) -> Iterator[Seat]:
    for carrier in sizing.carriers:
        push = planet_push(context, gears, carrier.stage)
        planet, rules = gears[str(gear_part(carrier.stage, Role.PLANET))], sizing.design.rules(carrier.stage)
        force = np.zeros((len(sizing.train.meshes), 3))
        for k, mesh in enumerate(sizing.train.meshes):
            if mesh.stage == carrier.stage and mesh.sign != INTERNAL:
                ring = gears[str(gear_part(carrier.stage, Role.RING))].teeth
                arm = 1.0 + ring / gears[mesh.gears[0]].teeth
                force[k, 0] = (rules.mesh_load_factor or 1.0) * arm / carrier.radius
                force[k, 1] = force[k, 0] * push
        yield Seat(
            part=planet.part._replace(kind=Kind.BEARING),
            count=planet.bodies,
            nodes=(carrier.shaft, planet.name),
            bore=carrier.pin_diameter,
            room=planet.pitch_diameter - 2.0 * rules.rim_thickness_ratio * planet.module,
            forward=force,
            backward=force,
            swung=planet.mass * carrier.radius,
            carrier=carrier.shaft,
        )
