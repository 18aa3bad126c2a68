"""Contacts of a sizing: where every mesh stands in space, and on which flanks it carries.

The frame of a shaft with a sun, a ring or a carrier is that of its planetary set's carrier.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal, NamedTuple

from gearwright.dynamics.assembly.compound_sets import planet_bodies, planet_body, set_directions
from gearwright.dynamics.assembly.meshes import gear_of
from gearwright.dynamics.model import (
    Carried,
    Contact,
    Turns,
    crossing_axis,
    face_push_direction,
    push_direction,
)
from gearwright.errors import DesignError, Problem
from gearwright.identity import PartId, Role, Row, carrier_part, gear_part
from gearwright.parts.gears import transverse_pressure_angle
from gearwright.sizing import Sizing, planet_positions
from gearwright.spec import GROUND, Epicyclic, Pair, Planetary
from gearwright.train import INTERNAL, Mesh, PowerFlow


def contacts_of(sizing: Sizing, flow: PowerFlow) -> tuple[Contact, ...]:
    """Return every mesh of a sizing as a contact, on the flanks that carry in a load case.

    Args:
        sizing: What was sized.
        flow: The load case.

    Raises:
        DesignError: If the pinion of a face gear lies neither along y nor along z.
    """
    contacts: list[Contact] = []
    for mesh in sizing.train.meshes:
        stage = sizing.design.stages[mesh.stage]
        if isinstance(stage, Epicyclic):
            contacts += _compound(sizing, flow, mesh, stage)
        elif isinstance(stage, Planetary):
            contacts += _planets(sizing, flow, mesh, stage)
        else:
            contacts.append(_pair(sizing, flow, mesh))
    return tuple(contacts)


def bodies_of(sizing: Sizing) -> dict[str, PartId]:
    """Return every body that teeth or pins move, by its name.

    Args:
        sizing: What was sized.
    """
    gears = [gear.body(shaft) for gear in sizing.gears if gear.role is not Role.PLANET for shaft in gear.shafts]
    for stage, planetary in sizing.design.planetaries.items():
        gears += [gear_part(stage, Role.PLANET, number=number + 1) for number in range(planetary.planets)]
        gears.append(carrier_part(stage))
    for stage in sizing.design.epicyclics:
        gears += [*(planet.part for planet in planet_bodies(sizing, stage)), carrier_part(stage)]
    return {str(part): part for part in gears}


def push_sense(flow: PowerFlow, row: str) -> Literal[1, -1]:
    """Return the sense in which gear a of a mesh row pushes: against the torque that the mesh puts on it.

    Args:
        flow: The load case.
        row: Name of the mesh row.
    """
    return -1 if flow.meshes[row].torques[0] > 0.0 else 1


class BaseCircles(NamedTuple):
    """Base circles of a mesh."""

    first: float
    """Base radius of gear a [m]."""
    second: float
    """Base radius of gear b [m]."""
    pressure_angle: float
    """Working transverse pressure angle α_wt [rad]."""


def base_circles(sizing: Sizing, mesh: Mesh) -> BaseCircles:
    """Return the base circles of a mesh; of bevel gears at the mean cone.

    Args:
        sizing: What was sized.
        mesh: A row of its train.

    Source: ISO 21771:2007, r_b = d/2 cos α_t, at the working angle α_wt, with tan α_t = tan α_n / cos β.
    """
    gears = [gear_of(sizing, name) for name in mesh.gears]
    angle = transverse_pressure_angle(sizing.design.rules(mesh.stage).pressure_angle, gears[0].helix_angle)
    first, second = (gear.pitch_diameter / 2.0 * math.cos(angle) for gear in gears)
    working = next(row for row in sizing.meshes if row.name == mesh.name).working_pressure_angle
    return BaseCircles(first, second, working)


def _first_body(sizing: Sizing, shaft: str) -> str:
    """Return the body whose rotation stands for a shaft's, so that its errors are one tone."""
    for stage in (*sizing.design.sets, *sizing.design.pairs):
        for gear in sizing.gears:
            if gear.stage == stage and shaft in gear.shafts:
                return str(gear.body(shaft))
        if stage in sizing.design.sets and sizing.design.sets[stage].carrier == shaft:
            return str(carrier_part(stage))
    return ""


def _pair(sizing: Sizing, flow: PowerFlow, mesh: Mesh) -> Contact:
    circles, sense = base_circles(sizing, mesh), push_sense(flow, mesh.name)
    towards = direction_between(sizing, mesh.nodes[0], mesh.nodes[1])
    face = isinstance(stage := sizing.design.stages[mesh.stage], Pair) and stage.kind == "face"
    axis = crossing_axis(towards) if face else "x"
    if axis is None:
        message = "a face gear stands along y or z from its pinion; give 0, 90, 180 or -90"
        raise DesignError([Problem(f"layout.{mesh.nodes[1]}.angle_deg", message)])
    if face:
        direction = face_push_direction(towards, circles.pressure_angle, sense=sense)
    else:
        outwards = -towards if mesh.sign == INTERNAL else towards
        direction = push_direction(outwards, circles.pressure_angle, sense=sense)
    sides = (
        _carried(sizing, mesh, 0, lever=sense * circles.first, axis=axis),
        _carried(sizing, mesh, 1, lever=-mesh.sign * sense * circles.second, axis="x"),
    )
    return Contact(mesh.name, direction, sides)


def direction_between(sizing: Sizing, shaft: str, to: str) -> complex:
    """Return the vector from one shaft's axis to another's, y + i z [m].

    Args:
        sizing: What was sized.
        shaft: From whose axis.
        to: To whose axis.
    """
    return sizing.arrangement.axes[to] - sizing.arrangement.axes[shaft]


def _carried(sizing: Sizing, mesh: Mesh, end: int, *, lever: float, axis: str) -> Carried:
    shaft = mesh.nodes[end]
    turns = {_first_body(sizing, shaft): 1} if shaft != GROUND else {}
    return Carried(str(gear_of(sizing, mesh.gears[end]).body(shaft)), shaft, lever, turns, turns, {}, axis)


def _planets(sizing: Sizing, flow: PowerFlow, mesh: Mesh, stage: Planetary) -> Iterator[Contact]:
    circles, sense, at_sun = base_circles(sizing, mesh), push_sense(flow, mesh.name), mesh.row is Row.SUN_PLANET
    frame = {str(carrier_part(mesh.stage)): -1} if stage.carrier != GROUND else {}
    for k, position in enumerate(planet_positions(sizing.design, mesh.stage, sizing.teeth), start=1):
        towards = complex(math.cos(position), math.sin(position))
        planet = str(gear_part(mesh.stage, Role.PLANET, number=k))
        role, shaft = (Role.SUN, stage.sun) if at_sun else (Role.RING, stage.ring)
        member = str(gear_part(mesh.stage, role))
        turns: Turns = {member: 1, **frame} if shaft != GROUND else frame
        central = Carried(member, shaft, 0.0, turns, turns, frame)
        carried = Carried(planet, stage.carrier, 0.0, {planet: 1, **frame}, {}, frame, "x", towards)
        first, second = (central, carried) if at_sun else (carried, central)
        sides = (
            first._replace(lever=sense * circles.first),
            second._replace(lever=-mesh.sign * sense * circles.second),
        )
        yield Contact(
            str(mesh.part._replace(number=k)), push_direction(towards, circles.pressure_angle, sense=sense), sides
        )


def _compound(sizing: Sizing, flow: PowerFlow, mesh: Mesh, stage: Epicyclic) -> Iterator[Contact]:
    """Yield the contacts of a row of a compound set, one for each set, in the frame of the carrier."""
    circles, sense = base_circles(sizing, mesh), push_sense(flow, mesh.name)
    frame: Turns = {str(carrier_part(mesh.stage)): -1} if stage.carrier != GROUND else {}
    levers = (sense * circles.first, -mesh.sign * sense * circles.second)
    for number, direction, places in set_directions(sizing, mesh):
        sides = []
        for end, (gear, node) in enumerate(zip(mesh.gears, mesh.nodes, strict=False)):
            part = sizing.train.gear(gear).part
            if end in places:
                planet = str(planet_body(sizing, part, number))
                turns: Turns = {planet: 1, **frame}
                side = Carried(planet, stage.carrier, levers[end], turns, {}, frame, "x", places[end])
            else:
                turns = {str(part): 1, **frame} if node != GROUND else frame
                side = Carried(str(part), node, levers[end], turns, turns, frame)
            sides.append(side)
        push = push_direction(direction, circles.pressure_angle, sense=sense)
        yield Contact(str(mesh.part._replace(number=number)), push, (sides[0], sides[1]))
