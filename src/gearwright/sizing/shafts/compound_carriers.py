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
    """From its teeth, around the axis of the carrier, signed as torques are [N]."""
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
            loads.append(PinLoad(case, body, force.imag, force.real, abs(outwards), abs(teeth[body] + outwards)))
    return loads


def _tooth_forces(
    context: Context, name: str, gears: Mapping[str, GearSizing], pins: Mapping[str, complex], flow: PowerFlow
) -> dict[str, complex]:
    """Return the force of all teeth on each planet body of one set [N].

    Both gears of a mesh bear one force. Its moment about the carrier's axis, of the two pins that it ends in, is what
    the mesh puts on the carrier: so it balances with the losses, with which neither gear's own torque does.
    """
    epicyclic, rating = context.design.epicyclics[name], context.ratings[name]
    forces = dict.fromkeys(pins, 0j)
    parts = {gear.name: own for own, gear in gears.items()}
    for mesh in (mesh for mesh in context.train.meshes if mesh.stage == name):
        first, second = (parts[gear] for gear in mesh.gears)
        bodies = [epicyclic.body(own) if own in epicyclic.planets else "" for own in (first, second)]
        here, there = (pins.get(body, 0j) for body in bodies)
        moment = flow.meshes[mesh.name].torques[2] / mesh.count * rating.load_factor
        tangential = moment / abs(here - there)
        separating = abs(tangential) * math.tan(rating.rules.pressure_angle)
        around = 1j * (here - there) / abs(here - there) * tangential
        for body, own, mate, sense in ((bodies[0], first, second, 1.0), (bodies[1], second, first, -1.0)):
            if body:
                forces[body] += sense * around - separating * towards(epicyclic, pins, own, mate)
    return forces
