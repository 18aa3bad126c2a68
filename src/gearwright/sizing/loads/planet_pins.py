"""What the planets of a compound set put on their pins: tooth forces of every mesh, added as vectors."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from gearwright.sizing.compound import towards
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.rolling import set_pins, set_rollings
from gearwright.spec import Epicyclic
from gearwright.train import PowerFlow


class ToothForce(NamedTuple):
    """What one mesh of the first set puts on a planet, or on one step of it."""

    planet: str
    """In the design's words."""
    mate: str
    """In the design's words."""
    radial: float
    """Outwards [N]."""
    tangential: float
    """Around the axis of the carrier, signed as torques are [N]."""


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
    lever: float
    """Bending moment at the root of the pin over half of that force [m]: the width, where it acts in the middle."""


def pin_loads(context: Context, name: str, gears: Mapping[str, GearSizing]) -> list[PinLoad]:
    """Return what every case puts on every pin of the first set.

    Args:
        context: What sizing reads.
        name: Of a compound set.
        gears: Its gears by the design's names.

    Source: equilibrium of a planet: tangential and separating force of each mesh, ISO 21771:2007, and m r ω_c².
    """
    epicyclic = context.design.epicyclics[name]
    pins, loads = set_pins(context, name, gears), []
    for case, flow in context.flows.items():
        forces = [force for row in tooth_forces(context, name, gears, flow).values() for force in row]
        speed = flow.speeds[epicyclic.carrier]
        for body, place in pins.items():
            own = [force for force in forces if epicyclic.body(force.planet) == body]
            swung = {step: gears[step].turning_mass * speed**2 * abs(place) for step in steps_of(epicyclic, body)}
            radial, tangential = sum(force.radial for force in own), sum(force.tangential for force in own)
            centrifugal = sum(swung.values())
            pin = math.hypot(tangential, radial + centrifugal)
            lever = _lever(epicyclic, gears, own, swung, pin)
            loads.append(PinLoad(case, body, tangential, radial, centrifugal, pin, lever))
    return loads


def steps_of(epicyclic: Epicyclic, body: str) -> list[str]:
    """Return the planets that turn as one piece, in the design's words.

    Args:
        epicyclic: A compound set.
        body: The first of them.
    """
    return [planet for planet in epicyclic.planets if epicyclic.body(planet) == body]


def pin_length(epicyclic: Epicyclic, body: str, gears: Mapping[str, GearSizing]) -> float:
    """Return how far a pin stands out of its plate: to the last of its steps, or as far as they side by side [m].

    Args:
        epicyclic: A compound set.
        body: The first planet of the piece that turns on it.
        gears: Its gears by the design's names.
    """
    steps = steps_of(epicyclic, body)
    ends = [place + gears[step].face_width / 2.0 for step in steps if (place := epicyclic.planets[step].place)]
    return max(ends) if len(ends) == len(steps) else sum(gears[step].face_width for step in steps)


def tooth_forces(
    context: Context, name: str, gears: Mapping[str, GearSizing], flow: PowerFlow
) -> dict[str, list[ToothForce]]:
    """Return mesh row -> what it puts on the planets of the first set: on one of them, or on the two that mesh.

    Both gears of a mesh bear one force. Its moment about the carrier's axis, of the two pins that it ends in, is what
    the mesh puts on the carrier: so it balances with the losses, with which neither gear's own torque does.

    Args:
        context: What sizing reads.
        name: Of a compound set.
        gears: Its gears by the design's names.
        flow: Torques of a case.

    Source: equilibrium of a mesh; separating force F_t tan α, ISO 21771:2007.
    """
    epicyclic, rating = context.design.epicyclics[name], context.ratings[name]
    parts, rolls = {gear.name: own for own, gear in gears.items()}, set_rollings(context, name, gears)
    pins = set_pins(context, name, gears)
    forces = dict[str, list[ToothForce]]()
    for mesh in (mesh for mesh in context.train.meshes if mesh.stage == name):
        first, second = (parts[gear] for gear in mesh.gears)
        here, there = (pins[epicyclic.body(own)] if own in epicyclic.planets else 0j for own in (first, second))
        moment = flow.meshes[mesh.name].torques[2] / mesh.count * rating.load_factor
        tangential = moment / abs(here - there)
        separating = rolls[mesh.own].radial(abs(tangential))
        around = 1j * (here - there) / abs(here - there) * tangential
        for own, mate, pin, sense in ((first, second, here, 1.0), (second, first, there, -1.0)):
            if own in epicyclic.planets:
                force = (sense * around - separating * towards(epicyclic, pins, own, mate)) / pin * abs(pin)
                forces.setdefault(mesh.name, []).append(ToothForce(own, mate, force.real, force.imag))
    return forces


def mesh_place(epicyclic: Epicyclic, gears: Mapping[str, GearSizing], planet: str, mate: str) -> float | None:
    """Return how far from the carrier's plate a planet meshes with a mate: in the middle of the width that both have.

    Args:
        epicyclic: A compound set.
        gears: Its gears by the design's names.
        planet: In the design's words.
        mate: In the design's words.

    Returns:
        Place along the axis [m]; the planet's own where the mate's is not given, None where neither is.
    """
    own, other = (epicyclic.toothed[gear].place for gear in (planet, mate))
    if own is None or other is None:
        return own
    half, reach = (gears[gear].face_width / 2.0 for gear in (planet, mate))
    return (max(own - half, other - reach) + min(own + half, other + reach)) / 2.0


def _lever(
    epicyclic: Epicyclic, gears: Mapping[str, GearSizing], forces: Iterable[ToothForce], swung: Mapping[str, float],
    pin: float,
) -> float:  # fmt: skip
    """Return the moment at the root of a pin over half of its force [m]: by the places of its gears if all are given.

    Else the force acts in the middle of the pin, which is as long as its steps side by side.
    """
    places = {step: epicyclic.planets[step].place for step in swung}
    if pin == 0.0 or None in places.values():
        return sum(gears[step].face_width for step in swung)
    around = outwards = 0.0
    for force in forces:
        place = mesh_place(epicyclic, gears, force.planet, force.mate) or 0.0
        around, outwards = around + place * force.tangential, outwards + place * force.radial
    outwards += sum(force * (places[step] or 0.0) for step, force in swung.items())
    return 2.0 * math.hypot(around, outwards) / pin
