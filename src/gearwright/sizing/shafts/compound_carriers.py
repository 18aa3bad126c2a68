"""What the planets of a compound set put on their pins: tooth forces of every mesh, added as vectors."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from gearwright.sizing.compound import pins_of, towards
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.train import PowerFlow


class PinLoad(NamedTuple):
    """What one case puts on the pin of one planet body."""

    case: str
    body: str
    tangential: float
    """From its teeth, around the axis of the carrier [N]."""
    radial: float
    """From its teeth, outwards [N]."""
    centrifugal: float
    """From its mass [N]."""
    pin: float
    """Both together as vectors [N]."""


def pin_loads(context: Context, name: str, gears: Mapping[str, GearSizing]) -> list[PinLoad]:
    """Return what every case puts on every pin of the first set.

    Args:
        context: What sizing reads.
        name: Of a compound set.
        gears: Its gears by the design's names.

    Source: equilibrium of a planet: tangential and separating force of each mesh, ISO 21771:2007, and m r ω_c².
    """
    epicyclic = context.design.epicyclics[name]
    pins, loads = pins_of(epicyclic, gears), []
    for case, flow in context.flows.items():
        teeth = _tooth_forces(context, name, gears, pins, flow)
        speed = flow.speeds[epicyclic.carrier]
        for body, place in pins.items():
            mass = sum(gears[step].mass for step in epicyclic.planets if epicyclic.body(step) == body)
            outwards = mass * speed**2 * place
            force = teeth[body] / place * abs(place)
            loads.append(PinLoad(case, body, abs(force.imag), force.real, abs(outwards), abs(teeth[body] + outwards)))
    return loads


def _tooth_forces(
    context: Context, name: str, gears: Mapping[str, GearSizing], pins: Mapping[str, complex], flow: PowerFlow
) -> dict[str, complex]:
    """Return the force of all teeth on each planet body of one set [N]."""
    epicyclic, rating = context.design.epicyclics[name], context.ratings[name]
    forces = dict.fromkeys(pins, 0j)
    parts = {gear.name: own for own, gear in gears.items()}
    for mesh in (mesh for mesh in context.train.meshes if mesh.stage == name):
        for end in (0, 1):
            own, mate = parts[mesh.gears[end]], parts[mesh.gears[1 - end]]
            if own in epicyclic.planets:
                torque = flow.meshes[mesh.name].torques[end] / mesh.count * rating.load_factor
                tangential = torque / (gears[own].pitch_diameter / 2.0)
                separating = -abs(tangential) * math.tan(rating.rules.pressure_angle)
                force = towards(epicyclic, pins, own, mate) * (1j * tangential + separating)
                forces[epicyclic.body(own)] += force
    return forces
