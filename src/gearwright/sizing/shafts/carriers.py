"""Carriers of planetary sets: cantilever pins under tooth forces and the planets' centrifugal force, and the plate."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from gearwright.identity import Role, carrier_part, gear_part
from gearwright.parts.planetary import pin_diameter, pin_mass, pin_stress, plate_mass, plate_shear_stress
from gearwright.sizing.compound import pins_of
from gearwright.sizing.rating import Context
from gearwright.sizing.result import CarrierSizing, GearSizing, ShaftSizing
from gearwright.sizing.rolling import planet_push
from gearwright.sizing.shafts.compound_carriers import pin_loads
from gearwright.sizing.shafts.shafts import shaft_material
from gearwright.spec import GROUND

ROUNDING = 1e-9
"""Torque on a free carrier over the largest of its parts that counts as none [-]."""


class _Load(NamedTuple):
    """What one case puts on a carrier."""

    case: str
    torque: float
    """T_c [N m]."""
    tangential: float
    """On one pin, from the teeth [N]."""
    centrifugal: float
    """On one pin, from its planet [N]."""
    radial: float
    """On one pin, from the teeth, outwards [N]."""

    @property
    def pin(self) -> float:
        return math.hypot(self.tangential, self.centrifugal + self.radial)


def size_carriers(
    context: Context, gears: tuple[GearSizing, ...], shafts: tuple[ShaftSizing, ...]
) -> tuple[CarrierSizing, ...]:
    """Return the carrier of every planetary set.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        shafts: From `size_shafts`.
    """
    by_name = {gear.name: gear for gear in gears}
    diameters = {shaft.name: shaft.diameter for shaft in shafts}
    simple = [_carrier(context, name, by_name, diameters) for name in context.design.planetaries]
    compound = [_compound(context, name, by_name, diameters) for name in context.design.epicyclics]
    return (*simple, *compound)


def _carrier(
    context: Context, name: str, gears: Mapping[str, GearSizing], diameters: Mapping[str, float]
) -> CarrierSizing:
    stage, rules, given = context.design.planetaries[name], context.design.carriers, context.given
    material = shaft_material(context)
    allowable = (material.yield_strength or 0.0) / rules.safety
    sun, planet = (gears[str(gear_part(name, role))] for role in (Role.SUN, Role.PLANET))
    centre = context.ratings[name].shifts.centre
    radius = (sun.pitch_diameter + planet.pitch_diameter) / 2.0 if centre is None else centre * sun.module
    loads = _loads(context, name, planet, radius, push=planet_push(context, gears, name))
    worst = max(loads, key=lambda load: load.pin)
    torque = max(load.torque for load in loads)
    pin = given.get(f"{name}.pin_diameter", pin_diameter(worst.pin, planet.face_width, allowable))
    hub = diameters.get(stage.carrier, 0.0) if stage.carrier != GROUND else 0.0
    thickness = _thickness(rules.plate_ratio * planet.face_width, torque, hub, allowable=allowable)
    thickness = given.get(f"{name}.plate_thickness", thickness)
    bending = pin_stress(worst.pin, planet.face_width, pin)
    shear = plate_shear_stress(torque, hub, thickness) if hub else 0.0
    part = carrier_part(name)
    pins = stage.planets * pin_mass(pin, planet.face_width, material.density)
    reach = radius + pin / 2.0
    plate = plate_mass(reach, thickness, material.density, fill=rules.fill)
    return CarrierSizing(
        stage=name,
        shaft=stage.carrier,
        case=worst.case,
        torque=torque,
        tangential_force=worst.tangential,
        centrifugal_force=worst.centrifugal,
        radial_force=worst.radial,
        pin_force=worst.pin,
        radius=radius,
        pin_diameter=pin,
        pin_stress=bending,
        pin_margin=allowable / bending if bending else math.inf,
        plate_thickness=thickness,
        plate_stress=shear,
        plate_margin=allowable / 2.0 / shear if shear else None,
        mass=given.get(f"{part}.mass", pins + plate),
        inertia=given.get(f"{part}.inertia", pins * radius**2 + plate * reach**2 / 2.0),
    )


def _compound(
    context: Context, name: str, gears: Mapping[str, GearSizing], diameters: Mapping[str, float]
) -> CarrierSizing:
    """Return the carrier of a compound set: equal pins, as strong as the one that is loaded most needs."""
    stage, rules, given = context.design.epicyclics[name], context.design.carriers, context.given
    material, own = shaft_material(context), {gear.own: gear for gear in gears.values() if gear.stage == name}
    allowable = (material.yield_strength or 0.0) / rules.safety
    places, loads = pins_of(stage, own), pin_loads(context, name, own)
    lengths = {body: sum(own[step].face_width for step in stage.planets if stage.body(step) == body) for body in places}
    worst = max(loads, key=lambda load: load.pin * lengths[load.body])
    length, torque = lengths[worst.body], max(abs(load) for load in _carrier_torques(context, name))
    pin = given.get(f"{name}.pin_diameter", pin_diameter(worst.pin, length, allowable))
    hub = diameters.get(stage.carrier, 0.0)
    thickness = _thickness(rules.plate_ratio * length, torque, hub, allowable=allowable)
    thickness = given.get(f"{name}.plate_thickness", thickness)
    bending = pin_stress(worst.pin, length, pin)
    shear = plate_shear_stress(torque, hub, thickness) if hub else 0.0
    masses = {body: stage.sets * pin_mass(pin, lengths[body], material.density) for body in places}
    reach = max(map(abs, places.values())) + pin / 2.0
    plate = plate_mass(reach, thickness, material.density, fill=rules.fill)
    about = sum(mass * abs(places[body]) ** 2 for body, mass in masses.items())
    part = carrier_part(name)
    return CarrierSizing(
        stage=name,
        shaft=stage.carrier,
        case=worst.case,
        torque=torque,
        tangential_force=worst.tangential,
        centrifugal_force=worst.centrifugal,
        radial_force=worst.radial,
        pin_force=worst.pin,
        radius=abs(places[worst.body]),
        pin_diameter=pin,
        pin_stress=bending,
        pin_margin=allowable / bending if bending else math.inf,
        plate_thickness=thickness,
        plate_stress=shear,
        plate_margin=allowable / 2.0 / shear if shear else None,
        mass=given.get(f"{part}.mass", sum(masses.values()) + plate),
        inertia=given.get(f"{part}.inertia", about + plate * reach**2 / 2.0),
    )


def _carrier_torques(context: Context, name: str) -> list[float]:
    """Return the torque that the teeth put on a carrier in every case [N m]."""
    rows = [mesh.name for mesh in context.train.meshes if mesh.stage == name]
    torques = [[flow.meshes[row].torques[2] for row in rows] for flow in context.flows.values()]
    return [sum(parts) if abs(sum(parts)) > ROUNDING * max(map(abs, parts)) else 0.0 for parts in torques]


def _loads(context: Context, name: str, planet: GearSizing, radius: float, *, push: float) -> list[_Load]:
    stage = context.design.planetaries[name]
    factor = context.ratings[name].load_factor
    loads = []
    for case, flow in context.flows.items():
        torque = abs(sum(flow.meshes[mesh.name].torques[2] for mesh in context.train.meshes if mesh.stage == name))
        centrifugal = planet.mass * radius * flow.speeds[stage.carrier] ** 2
        tangential = torque * factor / (stage.planets * radius)
        loads.append(_Load(case, torque, tangential, centrifugal, push * tangential))
    return loads


def _thickness(thinnest: float, torque: float, hub: float, *, allowable: float) -> float:
    """Return the plate's thickness: its share of the face width, or what its hub needs in shear (Tresca) [m]."""
    if not hub:
        return thinnest
    return thinnest * max(1.0, plate_shear_stress(torque, hub, thinnest) / (allowable / 2.0))
