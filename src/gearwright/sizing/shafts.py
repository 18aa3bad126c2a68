"""Shafts and carriers of a sized train."""

from __future__ import annotations

import math
from collections.abc import Mapping

from gearwright.catalogue.materials import materials
from gearwright.parts.carrier import pin_diameter, pin_mass, plate_mass, plate_shear_stress
from gearwright.parts.material import Material
from gearwright.parts.shaft import shaft_diameter, shaft_inertia, shaft_mass, shaft_stress, torsional_stiffness
from gearwright.sizing.gears import Context
from gearwright.sizing.result import CarrierSizing, GearSizing, ShaftSizing
from gearwright.spec import GROUND
from gearwright.spec.design import ShaftLayout
from gearwright.train.flow import RATED, PowerFlow
from gearwright.train.graph import Train


def shaft_material(given: Context) -> Material:
    """Return the material of shafts and carriers.

    Args:
        given: What sizing reads.
    """
    return materials()[given.design.shafting.material or given.design.gears.material]


def torque_inside(flow: PowerFlow, train: Train, shaft: str) -> float:
    """Return the largest torque that can act inside a shaft [N m]: half the sum of the magnitudes on it.

    Args:
        flow: A load case.
        train: The graph.
        shaft: Name of the shaft.
    """
    on_shaft = [torque for name, torque in flow.machine_torques.items() if train.machines[name] == shaft]
    for mesh in train.meshes:
        torques = flow.meshes[mesh.name].torques
        on_shaft += [torque for node, torque in zip(mesh.nodes, torques, strict=True) if node == shaft]
    for joint in train.joints:
        if joint.name in flow.joints and shaft in (joint.driving, joint.driven):
            on_shaft.append(flow.joints[joint.name])
    return sum(abs(torque) for torque in on_shaft) / 2.0


def size_shafts(given: Context, gears: tuple[GearSizing, ...]) -> tuple[ShaftSizing, ...]:
    """Return every shaft of the design.

    Args:
        given: What sizing reads.
        gears: From `size_gears`.
    """
    return tuple(_shaft(given, name, gears) for name in given.design.shafts)


def _shaft(given: Context, name: str, gears: tuple[GearSizing, ...]) -> ShaftSizing:
    rules, layout, take = given.design.shafting, given.design.layout.get(name, ShaftLayout()), given.overrides.take
    material = shaft_material(given)
    loads = {case: torque_inside(flow, given.train, name) for case, flow in given.flows.items()}
    case = max(loads, key=lambda each: loads[each])
    torque, moment = loads[case], 0.0
    allowable = (material.yield_strength or 0.0) / rules.safety
    ratio = layout.bore_ratio if layout.bore_ratio is not None else rules.bore_ratio
    diameter = layout.diameter or shaft_diameter(moment, torque, allowable, bore_ratio=ratio)
    diameter = take(f"{name}.diameter", "length", diameter)
    bore = layout.bore if layout.bore is not None else ratio * diameter
    length = take(f"{name}.length", "length", layout.length or _length(given, name, gears))
    mass = take(f"{name}.mass", "mass", shaft_mass(diameter, length, material.density, bore=bore))
    stress = shaft_stress(moment, torque, diameter, bore=bore) if diameter else 0.0
    return ShaftSizing(
        name=name,
        case=case,
        speed=given.flows[RATED].speeds[name],
        torque=torque,
        bending_moment=moment,
        length=length,
        diameter=diameter,
        bore=bore,
        stress=stress,
        margin=allowable / stress if stress else math.inf,
        mass=mass,
        inertia=shaft_inertia(mass, diameter, bore=bore),
        stiffness=torsional_stiffness(diameter, length, material.shear_modulus, bore=bore),
    )


def _length(given: Context, name: str, gears: tuple[GearSizing, ...]) -> float:
    """Return a shaft's length: gears of pairs side by side with gaps, or the standard length between planetary sets."""
    rules = given.design.shafting
    widths = [
        gear.face_width * gear.bodies / len(gear.shafts)
        for gear in gears
        if name in gear.shafts and gear.role in ("pinion", "wheel")
    ]
    if widths:
        return sum(widths) + rules.bearing_length * (len(widths) + 1)
    members = sum(name in (stage.sun, stage.ring, stage.carrier) for stage in given.design.planetaries.values())
    return rules.middle_length if members > 1 else rules.end_length


def size_carriers(
    given: Context, gears: tuple[GearSizing, ...], shafts: tuple[ShaftSizing, ...]
) -> tuple[CarrierSizing, ...]:
    """Return the carrier of every planetary set.

    Args:
        given: What sizing reads.
        gears: From `size_gears`.
        shafts: From `size_shafts`.
    """
    by_name = {gear.name: gear for gear in gears}
    diameters = {shaft.name: shaft.diameter for shaft in shafts}
    return tuple(_carrier(given, name, by_name, diameters) for name in given.design.planetaries)


def _carrier(
    given: Context, name: str, gears: Mapping[str, GearSizing], diameters: Mapping[str, float]
) -> CarrierSizing:
    stage, rules, take = given.design.planetaries[name], given.design.carriers, given.overrides.take
    material = shaft_material(given)
    allowable = (material.yield_strength or 0.0) / rules.safety
    torque = max(
        abs(sum(flow.meshes[mesh.name].torques[2] for mesh in given.train.meshes if mesh.stage == name))
        for flow in given.flows.values()
    )
    sun, planet = gears[f"{name}.sun"], gears[f"{name}.planet"]
    radius = (sun.pitch_diameter + planet.pitch_diameter) / 2.0
    force = torque * given.ratings[name].load_factor / (stage.planets * radius)
    pin = take(f"{name}.pin_diameter", "length", pin_diameter(force, planet.face_width, allowable))
    thickness = rules.plate_ratio * planet.face_width
    hub = diameters.get(stage.carrier, 0.0)
    if hub and stage.carrier != GROUND:
        thickness *= max(1.0, plate_shear_stress(torque, hub, thickness) / (allowable / 2.0))
    thickness = take(f"{name}.plate_thickness", "length", thickness)
    pins = stage.planets * pin_mass(pin, planet.face_width, material.density)
    plate = plate_mass(radius + pin / 2.0, thickness, material.density, fill=rules.fill)
    inertia = pins * radius**2 + plate * (radius + pin / 2.0) ** 2 / 2.0
    return CarrierSizing(
        stage=name,
        shaft=stage.carrier,
        torque=torque,
        pin_force=force,
        radius=radius,
        pin_diameter=pin,
        plate_thickness=thickness,
        mass=take(f"{name}.carrier.mass", "mass", pins + plate),
        inertia=take(f"{name}.carrier.inertia", "inertia", inertia),
    )
