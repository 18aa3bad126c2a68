"""Where rolling bearings sit in a sized train, and what each bears for the torques that its meshes carry.

The reactions of a shaft on two bearings grow in proportion to the torques of its meshes; only the radial forces keep
their sign when a torque changes its own. So two sets of coefficients, one for each sign, give the load of a bearing at
any moment. A planet's pin bears the tangential forces of its two meshes, which are equal, and across them the
centrifugal force of the planet. Shafts that carry torque only have no seat here: what their bearings bear comes from
outside the train.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearwright.parts.beam import bearing_reactions
from gearwright.sizing.axes import axes_of
from gearwright.sizing.context import Context, context
from gearwright.sizing.layout import plan_of
from gearwright.sizing.loads import shaft_loads
from gearwright.sizing.result import GearSizing, ShaftSizing, Sizing
from gearwright.spec import GROUND, Design
from gearwright.spec.mounting import LOCATES, BearingSeat
from gearwright.spec.overrides import Overrides
from gearwright.train.flow import RATED, MeshFlow, PowerFlow
from gearwright.train.graph import INTERNAL, Mesh
from gearwright.units import Length, Mass

Array = NDArray[np.float64]
ENDS = ("first", "second")
"""The two bearings of a shaft that the design leaves open, from its first end."""


@dataclass(frozen=True)
class Seat:
    """One bearing seat, or several equal ones."""

    name: str
    """As the design calls it; else ``SHAFT.first``, ``SHAFT.second``, or ``STAGE.planet``."""
    count: int
    """Equal seats: planets of a set [-]."""
    nodes: tuple[str, str]
    """What turns inside and what outside; the housing is ``ground``."""
    bore: Length
    """Diameter of shaft or pin [m]."""
    room: Length
    """Largest outside diameter: inside the rim of a planet; ∞ in the housing [m]."""
    forward: Array
    """Force along y, z and x of the shaft, or tangential, radial and axial on a pin, for a torque of 1 N m on gear a of
    one single mesh of each row, shape (meshes, 3) [N/(N m)]."""
    backward: Array
    """The same for a torque of −1 N m."""
    swung: Mass
    """Mass of a planet times the radius of its path [kg m]; 0 on shafts."""
    carrier: str
    """Node whose speed swings it."""
    given: BearingSeat | None = None
    """What the design says of it; planets and the two usual bearings of a shaft have none."""


def bearing_seats(sizing: Sizing) -> tuple[Seat, ...]:
    """Return every seat whose load follows from the meshes: on shafts with gears of pairs, and in each planet.

    An axial force goes to the bearing that locates the shaft towards it; without one, to the less loaded bearing.

    Args:
        sizing: As sized.
    """
    given = _unit_loads(sizing)
    axes, gears = axes_of(given, sizing.gears), {gear.name: gear for gear in sizing.gears}
    shafts = (seat for shaft in sizing.shafts for seat in _shaft_seats(given, sizing, shaft, axes=axes, gears=gears))
    return (*shafts, *_planet_seats(sizing, gears))


def seat_loads(seat: Seat, torques: Array, carrier_speed: Array) -> tuple[Array, Array]:
    """Return radial and axial force on one seat [N], each of the torques' shape without its last axis.

    Args:
        seat: The seat.
        torques: On gear a of one single mesh of each row, shape (..., meshes) [N m].
        carrier_speed: Speed of what swings a planet, shape (...) [rad/s].

    Source: equilibrium; m r ω² of a planet stands across its tangential force.
    """
    force = np.maximum(torques, 0.0) @ seat.forward + np.maximum(-torques, 0.0) @ seat.backward
    radial = np.hypot(force[..., 0], force[..., 1] + seat.swung * carrier_speed**2)
    return radial, np.abs(force[..., 2])


def _unit_loads(sizing: Sizing) -> Context:
    """Return what sizing reads, with a case for each sign of a unit torque on each mesh row, after the rated one."""
    design, train = sizing.design, sizing.train
    overrides = Overrides(design.overrides, design.origins)
    given = context(design, train, sizing.teeth, sizing.flows, overrides)
    rated = sizing.flows[RATED]
    cases = {f"{sign}{mesh.name}": _unit(sizing, rated, mesh, sign) for mesh in train.meshes for sign in (1, -1)}
    return replace(given, flows={RATED: rated, **cases})


def _unit(sizing: Sizing, rated: PowerFlow, loaded: Mesh, sign: int) -> PowerFlow:
    """Return a flow in which one row of meshes carries ±1 N m on gear a of each single mesh, without losses."""
    meshes = {mesh.name: MeshFlow(mesh.name, 0.0, (0.0, 0.0, 0.0), 0.0, 0.0) for mesh in sizing.train.meshes}
    one = sign * loaded.count
    ratio = loaded.sign * sizing.teeth[loaded.gears[1]] / sizing.teeth[loaded.gears[0]]
    meshes[loaded.name] = MeshFlow(loaded.name, 0.0, (one, -one * ratio, one * (ratio - 1.0)), 0.0, 0.0)
    return PowerFlow("", rated.speeds, {}, {}, meshes)


def _shaft_seats(
    given: Context, sizing: Sizing, shaft: ShaftSizing, *, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> Iterator[Seat]:
    if not shaft.bearings:
        return
    plan = plan_of(given, shaft.name, sizing.gears)
    loads, axial = shaft_loads(given, shaft.name, plan, axes=axes, gears=gears)
    radial = _radial_seats(sizing.design, shaft, plan.bearings)
    forces = bearing_reactions(loads, [place for place, _ in radial.values()])[1:]
    takers = _takers(sizing.design, shaft, tuple(radial))
    for k, (name, (_, own)) in enumerate(radial.items()):
        yield _on_shaft(shaft, name, np.hstack([forces[:, :, k], _taken(takers, name, -axial[1:])]), own)
    for name in dict.fromkeys(takers.values()):
        if name not in radial:
            none = np.zeros((len(axial) - 1, 2))
            own = sizing.design.bearings[name]
            yield _on_shaft(shaft, name, np.hstack([none, _taken(takers, name, -axial[1:])]), own)


def _radial_seats(
    design: Design, shaft: ShaftSizing, usual: tuple[float, float]
) -> dict[str, tuple[float, BearingSeat | None]]:
    """Return the two bearings that bear across a shaft: name -> place, and what the design says of it."""
    own = {name: seat for name, seat in design.bearings.items() if seat.shaft == shaft.name and seat.radial}
    if len(own) != len(ENDS):
        return {f"{shaft.name}.{end}": (place, None) for end, place in zip(ENDS, usual, strict=True)}
    return {name: (seat.position, seat) for name, seat in sorted(own.items(), key=lambda each: each[1].position)}


def _takers(design: Design, shaft: ShaftSizing, radial: tuple[str, ...]) -> dict[int, str]:
    """Return the bearing that takes a force along the shaft, by its sign; by default the less loaded."""
    usual = radial[int(np.argmin([each.radial_force for each in shaft.bearings]))]
    found = dict.fromkeys((-1, 1), usual)
    for name, seat in design.bearings.items():
        if seat.shaft == shaft.name:
            found |= dict.fromkeys(LOCATES[seat.locates], name)
    return found


def _taken(takers: Mapping[int, str], name: str, reaction: Array) -> Array:
    """Return the part of a reaction along the shaft that one bearing gives, as a column."""
    own = [sign for sign, taker in takers.items() if taker == name]
    return np.where(np.isin(np.sign(-reaction), own), reaction, 0.0)[:, None]


def _on_shaft(shaft: ShaftSizing, name: str, force: Array, given: BearingSeat | None) -> Seat:
    return Seat(
        name=name,
        count=1,
        nodes=(shaft.name, GROUND),
        bore=(given.bore if given else None) or shaft.diameter,
        room=(given.largest_outer_diameter if given else None) or np.inf,
        forward=force[0::2],
        backward=force[1::2],
        swung=0.0,
        carrier=GROUND,
        given=given,
    )


def _planet_seats(sizing: Sizing, gears: Mapping[str, GearSizing]) -> Iterator[Seat]:
    for carrier in sizing.carriers:
        planet, rules = gears[f"{carrier.stage}.planet"], sizing.design.rules(carrier.stage)
        force = np.zeros((len(sizing.train.meshes), 3))
        for k, mesh in enumerate(sizing.train.meshes):
            if mesh.stage == carrier.stage and mesh.sign != INTERNAL:
                force[k, 0] = 2.0 * (rules.mesh_load_factor or 1.0) / (0.5 * gears[mesh.gears[0]].pitch_diameter)
        yield Seat(
            name=planet.name,
            count=planet.bodies,
            nodes=(carrier.shaft, planet.name),
            bore=carrier.pin_diameter,
            room=planet.pitch_diameter - 2.0 * rules.rim_thickness_ratio * planet.module,
            forward=force,
            backward=force,
            swung=planet.mass * carrier.radius,
            carrier=carrier.shaft,
        )
