"""Carriers of planetary sets: cantilever pins under tooth forces and the planets' centrifugal force, and the plate."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from gearwright.base import Role, carrier_part, gear_part, largest
from gearwright.parts.planetary import (
    eye_stress,
    eye_wall,
    hole_pressure,
    pin_bore,
    pin_diameter,
    pin_mass,
    pin_stress,
    plate_mass,
    plate_shear_stress,
)
from gearwright.sizing.gear_geometry import external_tooth, pin_circle, planet_push, set_pins
from gearwright.sizing.loads import PinLoad, pin_length, pin_loads
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shaft_results import CarrierSizing, ShaftSizing
from gearwright.sizing.shafts.shafts import shaft_material

ROUNDING = 1e-9
"""Torque on a free carrier over the largest of its parts that counts as none [-]."""
THROUGH = 1e-3
"""Room between a plate and the tips of the ring that it is put in through, an assumption [m]."""


class _Pins(NamedTuple):
    """Equal pins of one planet body."""

    radius: float
    """Of the circle that they stand on [m]."""
    length: float
    """[m]"""
    seat: float = 0.0
    """Diameter under what the planets turn on; 0 where it follows the strength [m]."""
    rings: float = 0.0
    """Mass of inner rings on one [kg]."""


class _Asked(NamedTuple):
    """What a carrier has to bear, and on what."""

    equal: int
    """Pins of each planet body [-]."""
    torque: float
    """[N m]"""
    hub: float
    """Diameter of its shaft; 0 where it stands still [m]."""


def size_carriers(
    context: Context, gears: tuple[GearSizing, ...], shafts: tuple[ShaftSizing, ...],
    two_sided: tuple[str, ...] = (),
) -> tuple[CarrierSizing, ...]:  # fmt: skip
    """Return the carrier of every planetary set.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        shafts: From `size_shafts`.
        two_sided: Sets with a plate on both sides.
    """
    by_name = {gear.name: gear for gear in gears}
    diameters = {shaft.name: shaft.diameter for shaft in shafts}
    simple = [_carrier(context, name, by_name, diameters) for name in context.design.planetaries]
    compound = [_compound(context, name, by_name, diameters) for name in context.design.epicyclics]
    return tuple(
        _twice(context, carrier) if carrier.stage in two_sided else carrier for carrier in (*simple, *compound)
    )


def _twice(context: Context, carrier: CarrierSizing) -> CarrierSizing:
    """Return a carrier with a second plate on the other side of its planets; its pins stay as they are."""
    given, reach = context.given, carrier.reach
    more = plate_mass(
        reach, carrier.plate_thickness, shaft_material(context).density, fill=context.design.carriers.fill
    )
    return replace(
        carrier,
        mass=given.get(f"{carrier.part}.mass", carrier.mass + more),
        inertia=given.get(f"{carrier.part}.inertia", carrier.inertia + more * reach**2 / 2.0),
    )


def _carrier(
    context: Context, name: str, gears: Mapping[str, GearSizing], diameters: Mapping[str, float]
) -> CarrierSizing:
    """Return the carrier of a simple set."""
    planet, radius = gears[str(gear_part(name, Role.PLANET))], pin_circle(context, name, gears)
    torques = _torques(context, name)
    loads = _loads(context, name, planet, radius, torques=torques, push=planet_push(context, gears, name))
    pins = {str(Role.PLANET): _pins_of(planet, radius)}
    count = context.design.planetaries[name].planets
    asked = _Asked(count, max(torques), diameters.get(context.design.sets[name].carrier, 0.0))
    return _sized(context, name, pins, loads, asked=asked, room=_room(context, name, gears))


def _compound(
    context: Context, name: str, gears: Mapping[str, GearSizing], diameters: Mapping[str, float]
) -> CarrierSizing:
    """Return the carrier of a compound set."""
    stage, own = context.design.epicyclics[name], {gear.own: gear for gear in gears.values() if gear.stage == name}
    pins = {
        body: _Pins(abs(place), pin_length(stage, body, own)) for body, place in set_pins(context, name, own).items()
    }
    torque, loads = max(map(abs, _carrier_torques(context, name))), pin_loads(context, name, own)
    asked = _Asked(stage.sets, torque, diameters.get(stage.carrier, 0.0))
    return _sized(context, name, pins, loads, asked=asked, room=_room(context, name, gears))


def _room(context: Context, name: str, gears: Mapping[str, GearSizing]) -> float:
    """Return the radius of the narrowest ring of a set inside its teeth, through which a plate goes [m]."""
    rings = [gear for gear in gears.values() if gear.stage == name and gear.rim]
    tips = [external_tooth(context.design, ring)._replace(side=-1).tip_radius for ring in rings]
    return min(tips, default=math.inf) - THROUGH


def _pins_of(planet: GearSizing, radius: float) -> _Pins:
    """Return the pins of a simple set: as thick as what the planets turn on asks."""
    runs_on = planet.runs_on
    if runs_on is None:
        return _Pins(radius, planet.face_width)
    return _Pins(radius, planet.face_width, runs_on.pin_diameter, runs_on.standing_mass)


def _sized(
    context: Context, name: str, pins: Mapping[str, _Pins], loads: Sequence[PinLoad], *, asked: _Asked, room: float
) -> CarrierSizing:
    """Return a carrier with equal pins, as strong as the one that is loaded most needs."""
    rules, given, shaft = context.design.carriers, context.given, context.design.sets[name].carrier
    material, torque, hub = shaft_material(context), asked.torque, asked.hub
    allowable = (material.yield_strength or 0.0) / rules.safety
    worst, pulled = largest(loads, lambda load: load.pin * load.lever), largest(loads, lambda load: load.pin).pin
    length, outermost = pins[worst.body].length, max(equal.radius for equal in pins.values())
    needed = pin_diameter(worst.pin, worst.lever, allowable)
    pin = given.get(f"{name}.pin_diameter", max(needed, pins[worst.body].seat))
    bore = pin_bore(pin, needed) if pins[worst.body].seat else 0.0
    room = room - outermost - pin / 2.0
    thinnest = max(rules.plate_ratio * length, pulled / (pin * allowable))
    thickness = _thickness(thinnest, torque, hub, allowable=allowable)
    if room > 0.0:  # where the ring leaves less metal outside the pins, the plate is thicker
        thickness = max(thickness, pulled / (room * allowable))
    thickness = given.get(f"{name}.plate_thickness", thickness)
    wall = eye_wall(pulled, thickness, allowable / 2.0, needed=needed)
    wall = given.get(f"{name}.eye_wall", room if 0.0 < room < wall else wall)
    bending = pin_stress(worst.pin, worst.lever, pin, bore=bore)
    shear = plate_shear_stress(torque, hub, thickness) if hub else 0.0
    torn, pressed = eye_stress(pulled, thickness, wall), hole_pressure(pulled, pin, thickness)
    count = asked.equal
    masses = {body: count * pin_mass(pin, equal.length, material.density, bore=bore) for body, equal in pins.items()}
    reach = outermost + pin / 2.0 + wall
    plate = plate_mass(reach, thickness, material.density, fill=rules.fill)
    about = sum((mass + count * pins[body].rings) * pins[body].radius ** 2 for body, mass in masses.items())
    part = carrier_part(name)
    return CarrierSizing(
        stage=name,
        shaft=shaft,
        case=worst.case,
        torque=torque,
        tangential_force=abs(worst.tangential),
        centrifugal_force=worst.centrifugal,
        radial_force=worst.radial,
        pin_force=worst.pin,
        radius=pins[worst.body].radius,
        pin_diameter=pin,
        pin_bore=bore or None,
        pin_stress=bending,
        pin_margin=allowable / bending if bending else math.inf,
        plate_thickness=thickness,
        plate_stress=shear,
        plate_margin=allowable / 2.0 / shear if shear else None,
        eye_wall=wall,
        eye_stress=torn,
        eye_margin=allowable / 2.0 / torn if torn else math.inf,
        hole_pressure=pressed,
        hole_margin=allowable / pressed if pressed else math.inf,
        reach=reach,
        mass=given.get(f"{part}.mass", sum(masses.values()) + plate),
        inertia=given.get(f"{part}.inertia", about + plate * reach**2 / 2.0),
    )


def _carrier_torques(context: Context, name: str) -> list[float]:
    """Return the torque that the teeth put on a carrier in every case [N m]."""
    rows = [mesh.name for mesh in context.train.meshes if mesh.stage == name]
    torques = [[flow.meshes[row].torques[2] for row in rows] for flow in context.flows.values()]
    return [sum(parts) if abs(sum(parts)) > ROUNDING * max(map(abs, parts)) else 0.0 for parts in torques]


def _torques(context: Context, name: str) -> list[float]:
    """Return the size of the torque on a simple set's carrier in every case [N m]."""
    rows = [mesh.name for mesh in context.train.meshes if mesh.stage == name]
    return [abs(sum(flow.meshes[row].torques[2] for row in rows)) for flow in context.flows.values()]


def _loads(
    context: Context, name: str, planet: GearSizing, radius: float, *, torques: Sequence[float], push: float
) -> list[PinLoad]:
    """Return what every case puts on a pin of a simple set."""
    stage, factor = context.design.planetaries[name], context.ratings[name].load_factor
    loads = []
    for (case, flow), torque in zip(context.flows.items(), torques, strict=True):
        centrifugal = planet.turning_mass * radius * flow.speeds[stage.carrier] ** 2
        tangential = torque * factor / (stage.planets * radius)
        radial = push * tangential
        pin = math.hypot(tangential, centrifugal + radial)
        loads.append(PinLoad(case, str(Role.PLANET), tangential, radial, centrifugal, pin, planet.face_width))
    return loads


def _thickness(thinnest: float, torque: float, hub: float, *, allowable: float) -> float:
    """Return the plate's thickness: its share of the face width, or what its hub needs in shear (Tresca) [m]."""
    if not hub:
        return thinnest
    return thinnest * max(1.0, plate_shear_stress(torque, hub, thinnest) / (allowable / 2.0))
