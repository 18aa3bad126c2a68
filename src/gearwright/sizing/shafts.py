"""Shafts and carriers of a sized train."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from gearwright.catalogue.materials import materials
from gearwright.parts.beam import Diagram, diagram, supported
from gearwright.parts.material import Material
from gearwright.parts.shaft import (
    shaft_diameter,
    shaft_diameter_around,
    shaft_inertia,
    shaft_mass,
    shaft_stress,
    torsional_stiffness,
)
from gearwright.sizing.axes import axes_of
from gearwright.sizing.context import Context
from gearwright.sizing.layout import ShaftPlan, plan_of
from gearwright.sizing.loads import pure_torques, shaft_loads
from gearwright.sizing.result import BearingLoad, GearSizing, ShaftDiagram, ShaftSizing
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
    if layout.bore is not None:
        needed = shaft_diameter_around(layout.bore, load.bending_moment, load.torque, allowable=allowable)
    else:
        needed = shaft_diameter(load.bending_moment, load.torque, allowable, bore_ratio=ratio)
    diameter = layout.diameter or needed
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
    if not any(mesh.stage in given.design.pairs and name in mesh.nodes for mesh in given.train.meshes):
        return _twisted(given, plan, name=name)
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


def _twisted(given: Context, plan: ShaftPlan, *, name: str) -> _Governing:
    """Return what governs a shaft that nothing bends: the case and the section where the torque is largest."""
    loads = sorted(pure_torques(given, name, plan), key=lambda load: load[0])
    position = tuple(place for place, _ in loads for _ in range(2))
    torsion = [_along(torques) for torques in zip(*(each for _, each in loads), strict=True)]
    largest = [max(map(abs, each)) for each in torsion]
    torque = max(largest)
    case = largest.index(torque)
    straight = (0.0,) * len(position)
    drawn = ShaftDiagram(position, (straight, straight), (straight, straight), torsion[case])
    return _Governing(list(given.flows)[case], 0.0, torque, 0.0, (), drawn)


def _along(torques: Iterable[float]) -> tuple[float, ...]:
    """Return the torque just left and just right of every load, from those of the loads."""
    stations, total = list[float](), 0.0
    for torque in torques:
        total += torque
        stations += (total - torque, total)
    return tuple(stations)


def _diagram(drawn: Diagram, case: int) -> ShaftDiagram:
    shear, bending = drawn.shear[case].tolist(), drawn.bending[case].tolist()
    return ShaftDiagram(
        position=tuple(drawn.position.tolist()),
        shear=(tuple(shear[0]), tuple(shear[1])),
        bending=(tuple(bending[0]), tuple(bending[1])),
        torsion=tuple(drawn.torsion[case].tolist()),
    )
