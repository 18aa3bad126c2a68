"""Shafts and carriers of a sized train."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from gearwright.catalogue.materials import materials
from gearwright.parts.beam import Diagram, diagram, supported
from gearwright.parts.carrier import pin_diameter, pin_mass, plate_mass, plate_shear_stress
from gearwright.parts.material import Material
from gearwright.parts.shaft import shaft_diameter, shaft_inertia, shaft_mass, shaft_stress, torsional_stiffness
from gearwright.sizing.axes import axes_of
from gearwright.sizing.gears import Context
from gearwright.sizing.layout import ShaftPlan, plan_of
from gearwright.sizing.loads import shaft_loads
from gearwright.sizing.result import BearingLoad, CarrierSizing, GearSizing, ShaftDiagram, ShaftSizing
from gearwright.spec import GROUND
from gearwright.spec.design import ShaftLayout
from gearwright.train.flow import RATED


def shaft_material(given: Context) -> Material:
    """Return the material of shafts and carriers.

    Args:
        given: What sizing reads.
    """
    return materials()[given.design.shafting.material or given.design.gears.material]


def size_shafts(given: Context, gears: tuple[GearSizing, ...]) -> tuple[ShaftSizing, ...]:
    """Return every shaft of the design, sized where bending and torsion together are largest.

    Args:
        given: What sizing reads.
        gears: From `size_gears`.

    Raises:
        DesignError: If axes do not close, or gears, places or bearings do not fit on a shaft.
    """
    axes, by_name = axes_of(given, gears), {gear.name: gear for gear in gears}
    return tuple(_shaft(given, plan_of(given, name, gears), axes, by_name, name=name) for name in given.design.shafts)


class _Governing(NamedTuple):
    """The load case that governs a shaft."""

    case: str
    bending_moment: float
    torque: float
    axial_force: float
    bearings: tuple[BearingLoad, ...]
    diagram: ShaftDiagram


def _shaft(
    given: Context, plan: ShaftPlan, axes: Mapping[str, complex], gears: Mapping[str, GearSizing], *, name: str
) -> ShaftSizing:
    rules, layout, take = given.design.shafting, given.design.layout.get(name, ShaftLayout()), given.overrides.take
    material, load = shaft_material(given), _governing(given, plan, axes, gears, name=name)
    allowable = (material.yield_strength or 0.0) / rules.safety
    ratio = layout.bore_ratio if layout.bore_ratio is not None else rules.bore_ratio
    diameter = layout.diameter or shaft_diameter(load.bending_moment, load.torque, allowable, bore_ratio=ratio)
    diameter = take(f"{name}.diameter", "length", diameter)
    bore = layout.bore if layout.bore is not None else ratio * diameter
    mass = take(f"{name}.mass", "mass", shaft_mass(diameter, plan.length, material.density, bore=bore))
    stress = shaft_stress(load.bending_moment, load.torque, diameter, bore=bore) if diameter else 0.0
    return ShaftSizing(
        name=name,
        case=load.case,
        speed=given.flows[RATED].speeds[name],
        torque=load.torque,
        bending_moment=load.bending_moment,
        axial_force=load.axial_force,
        length=plan.length,
        diameter=diameter,
        bore=bore,
        stress=stress,
        margin=allowable / stress if stress else math.inf,
        mass=mass,
        inertia=shaft_inertia(mass, diameter, bore=bore) if layout.inertia is None else layout.inertia,
        stiffness=layout.torsional_stiffness
        or torsional_stiffness(diameter, plan.length, material.shear_modulus, bore=bore),
        axis=(axes[name].real, axes[name].imag),
        bearings=load.bearings,
        diagram=load.diagram,
    )


def _governing(
    given: Context, plan: ShaftPlan, axes: Mapping[str, complex], gears: Mapping[str, GearSizing], *, name: str
) -> _Governing:
    """Return the case and the section where √(M² + T²) is largest, and what belongs to them."""
    loads, axial = shaft_loads(given, name, plan, axes=axes, gears=gears)
    bends = bool(loads.force.any())
    whole = supported(loads, plan.bearings, length=plan.length) if bends else loads
    drawn = diagram(whole)
    moment = np.hypot(drawn.bending[:, 0], drawn.bending[:, 1])
    case, section = np.unravel_index(int(np.argmax(np.hypot(moment, drawn.torsion))), moment.shape)
    reactions = whole.force[case, :, -2:].T.tolist() if bends else []
    return _Governing(
        case=list(given.flows)[case],
        bending_moment=float(moment[case, section]),
        torque=abs(float(drawn.torsion[case, section])),
        axial_force=float(axial[case]),
        bearings=tuple(BearingLoad(at, (y, z)) for at, (y, z) in zip(plan.bearings, reactions, strict=False)),
        diagram=_diagram(drawn, int(case)),
    )


def _diagram(drawn: Diagram, case: int) -> ShaftDiagram:
    shear, bending = drawn.shear[case].tolist(), drawn.bending[case].tolist()
    return ShaftDiagram(
        position=tuple(drawn.position.tolist()),
        shear=(tuple(shear[0]), tuple(shear[1])),
        bending=(tuple(bending[0]), tuple(bending[1])),
        torsion=tuple(drawn.torsion[case].tolist()),
    )


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
