"""Compound sets of a sizing: every planet body of every set, and how their meshes follow each other.

The teeth of a gear pass the places at which it meshes one after the other; what of a cycle lies between two of them
follows from the angle between them, and from the thickness of a tooth where one is on its other flank.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from gearwright.dynamics.assembly.meshes import gear_pairs
from gearwright.errors import SolveError
from gearwright.identity import PartId, Role, gear_part
from gearwright.parts.gears import half_angle_at
from gearwright.parts.planetary import fitting_turns
from gearwright.sizing import GearSizing, Sizing, pins_of, towards
from gearwright.train import Mesh, PowerFlow


def planet_body(sizing: Sizing, gear: PartId, number: int) -> PartId:
    """Return the body in one set that a planet, or a step of one, is part of.

    Args:
        sizing: What was sized.
        gear: A planet, or a step of one.
        number: Of the set, from 1.
    """
    epicyclic = sizing.design.epicyclics.get(gear.name)
    own = epicyclic.body(gear.own) if epicyclic is not None else ""
    return gear_part(gear.name, Role.PLANET, number=number, own=own)


class PlanetBody(NamedTuple):
    """One planet of one set, all its steps together."""

    part: PartId
    node: str
    """Of the graph, which all sets share."""
    inertia: float
    """About its own axis [kg m²]."""
    mass: float
    """[kg]"""
    place: complex
    """Of its pin, in the frame of the carrier, y + i z [m]."""


def planet_bodies(sizing: Sizing, stage: str) -> Iterator[PlanetBody]:
    """Yield every planet body of a compound set, set by set.

    Args:
        sizing: What was sized.
        stage: Name of the set.
    """
    epicyclic, gears = sizing.design.epicyclics[stage], own_gears(sizing, stage)
    for body, pin in _pins(sizing, stage).items():
        steps = [gears[step] for step in epicyclic.planets if epicyclic.body(step) == body]
        inertia, mass = sum(step.turning_inertia for step in steps), sum(step.turning_mass for step in steps)
        for number in range(epicyclic.sets):
            part = gear_part(stage, Role.PLANET, number=number + 1, own=body)
            turn = cmath.rect(1.0, 2.0 * math.pi * number / epicyclic.sets)
            yield PlanetBody(part, steps[0].shafts[0], inertia, mass, pin * turn)


def own_gears(sizing: Sizing, stage: str) -> dict[str, GearSizing]:
    """Return the gears of a compound set by the design's names.

    Args:
        sizing: What was sized.
        stage: Name of the set.
    """
    return {gear.own: gear for gear in sizing.gears if gear.stage == stage}


def _pins(sizing: Sizing, stage: str) -> dict[str, complex]:
    """Return planet body -> place of its pin in the first set, y + i z [m]."""
    centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes if mesh.stage == stage}
    return pins_of(sizing.design.epicyclics[stage], own_gears(sizing, stage), centres)


def compound_phases(sizing: Sizing, flow: PowerFlow, stage: str) -> dict[str, tuple[float, ...]]:
    """Return mesh row -> phase of its mesh in every set, ahead of the first mesh of its group [cycles].

    Args:
        sizing: What was sized.
        flow: The load case, which says what turns which way, and on which flanks.
        stage: Name of a compound set.

    Source: angles between meshes and the half angle of a tooth, as Parker & Lin 2004, J. Mech. Des. 126, 365-370, for
        sun and ring; from set to set the turn with which a planet fits, z_p ψ, which gives their z_s ψ_n/2π.
    """
    rows = [mesh for mesh in sizing.train.meshes if mesh.stage == stage]
    inside = _within(sizing, flow, stage, rows)
    epicyclic = sizing.design.epicyclics[stage]
    phases: dict[str, list[float]] = {mesh.name: [inside[mesh.name] % 1.0] for mesh in rows}
    for number in range(1, epicyclic.sets):
        turns = fitting_turns(epicyclic.compound, number=number)
        if turns is None:
            raise SolveError(f"{stage}: its planets cannot be assembled")
        for mesh in rows:
            gear = next(sizing.train.gear(name) for name in mesh.gears if sizing.train.gear(name).role is Role.PLANET)
            turned = float(turns[epicyclic.body(gear.own)].first) * sizing.teeth[gear.name]
            phases[mesh.name].append((inside[mesh.name] + _sense(mesh, gear.nodes[0], flow) * turned) % 1.0)
    return {name: tuple(values) for name, values in phases.items()}


def _within(sizing: Sizing, flow: PowerFlow, stage: str, rows: list[Mesh]) -> dict[str, float]:
    """Return mesh row -> its phase in the first set, gears joined by teeth from mesh to mesh [cycles]."""
    known: dict[str, float] = {}
    for _ in rows:
        for mesh in rows:
            if mesh.name in known:
                continue
            beside = [row for row in rows if row.name in known and row.group == mesh.group]
            shared = [(row, gear) for row in beside for gear in row.gears if gear in mesh.gears]
            if shared:
                row, gear = shared[0]
                here, there = (_passed(sizing, flow, stage, place, gear) for place in (mesh, row))
                known[mesh.name] = known[row.name] + here - there
            elif not any(row.group == mesh.group for row in rows if row.name in known):
                known[mesh.name] = 0.0
    return known


def _passed(sizing: Sizing, flow: PowerFlow, stage: str, mesh: Mesh, gear: str) -> float:
    """Return by what part of a cycle a gear's contact in a mesh runs ahead of a tooth's middle at angle 0 [cycles]."""
    epicyclic, end = sizing.design.epicyclics[stage], mesh.gears.index(gear)
    body, mate = (sizing.train.gear(mesh.gears[k]).own for k in (end, 1 - end))
    sense = _sense(mesh, mesh.nodes[end], flow)
    angle = sense * cmath.phase(towards(epicyclic, _pins(sizing, stage), body, mate))
    pair = gear_pairs(sizing)[mesh.name]
    tooth = (pair.driver, pair.driven)[end]
    half = half_angle_at(tooth, tooth.base_radius / math.cos(pair.working_pressure_angle))
    first_drives = flow.meshes[mesh.name].torques[0] * _sense(mesh, mesh.nodes[0], flow) < 0.0
    drives = first_drives == (end == 0)  # in a mesh that idles, too, one gear drives and one is driven
    return sizing.teeth[gear] * ((half if drives else -half) - angle) / (2.0 * math.pi)


def _sense(mesh: Mesh, node: str, flow: PowerFlow) -> float:
    """Return the sense in which a node turns beside the carrier of a mesh, ±1."""
    return -1.0 if flow.speeds[node] < flow.speeds[mesh.nodes[2]] else 1.0


def set_directions(sizing: Sizing, mesh: Mesh) -> Iterator[tuple[int, complex, Mapping[int, complex]]]:
    """Yield for every set its number, the direction from gear a's axis to its pitch point, and where its planets stand.

    Args:
        sizing: What was sized.
        mesh: A row of a compound set.
    """
    epicyclic, pins = sizing.design.epicyclics[mesh.stage], _pins(sizing, mesh.stage)
    first, second = (sizing.train.gear(name).own for name in mesh.gears)
    direction = towards(epicyclic, pins, first, second)
    places = {
        end: pins[epicyclic.body(own)] / abs(pins[epicyclic.body(own)])
        for end, own in enumerate((first, second))
        if own in epicyclic.planets
    }
    for number in range(epicyclic.sets):
        turn = cmath.rect(1.0, 2.0 * math.pi * number / epicyclic.sets)
        yield number + 1, direction * turn, {end: place * turn for end, place in places.items()}
