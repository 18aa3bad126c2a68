"""Shafts of a sized train: of one diameter, or built where the design gives them bearings."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from gearwright.errors import DesignError, Problem, refuse
from gearwright.parts import Material
from gearwright.parts.shafts import (
    shaft_diameter,
    shaft_diameter_around,
    shaft_inertia,
    shaft_mass,
    shaft_stress,
    torsional_stiffness,
)
from gearwright.sizing.arranged import Arrangement, ShaftPlan
from gearwright.sizing.carrying import BearingLoad, ShaftDiagram, ShaftSizing
from gearwright.sizing.loads import ShaftForces, pure_torques, shaft_forces
from gearwright.sizing.mounted import SectionStrength
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shafts.building import Built, build_shaft
from gearwright.sizing.shafts.nested import THINNEST_WALL, inner_first, least_bore
from gearwright.sizing.shafts.refusals import MOST_HOLLOW
from gearwright.spec.design import NOTHING_GIVEN


def shaft_material(context: Context) -> Material:
    """Return the material of shafts and carriers.

    Args:
        context: What sizing reads.
    """
    return context.design.shaft_material


def size_shafts(
    context: Context, gears: tuple[GearSizing, ...], arrangement: Arrangement
) -> tuple[tuple[ShaftSizing, ...], tuple[Built, ...]]:
    """Return every shaft of the design, and those that the design gives bearings also as they are built.

    A shaft without bearings in the design has one diameter, sized where bending and torsion together are largest.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        arrangement: From `arrange`.

    Raises:
        DesignError: If no shaft can be built that bears its loads.
    """
    axes, by_name = arrangement.axes, {gear.name: gear for gear in gears}
    bent = _bent(context)
    shafts: list[ShaftSizing] = []
    built: list[Built] = []
    problems: list[Problem] = []
    for name in inner_first(arrangement):
        plan, room = arrangement.plans[name], least_bore(context, arrangement, shafts, name)
        if not plan.seats and name not in bent:
            load = _twisted(context, plan, name=name)
            shafts.append(_plain(context, plan, load, axes[name], name=name, room=room))
            continue
        forces = shaft_forces(context, name, plan, axes=axes, gears=by_name)
        if not plan.seats:
            shafts.append(_plain(context, plan, _governing(context, forces), axes[name], name=name, room=room))
            continue
        try:
            built.append(_built(context, forces, by_name, name=name))
        except DesignError as error:
            problems += error.problems
            continue
        shafts.append(_stepped(context, forces, built[-1], axes[name], name=name))
    refuse(problems)
    if arrangement.within:
        order = list(arrangement.plans)
        shafts.sort(key=lambda shaft: order.index(shaft.name))
    return tuple(shafts), tuple(built)


def _bent(context: Context) -> set[str]:
    """Return the shafts that something may bend: a mesh of a pair, or a rotor's force or moment."""
    geared = {node for mesh in context.train.meshes if mesh.stage in context.design.pairs for node in mesh.nodes}
    rotors = context.design.airscrews.values()
    return geared | {rotor.shaft for rotor in rotors if rotor.thrust or rotor.in_plane_force or rotor.hub_moment}


class _Governing(NamedTuple):
    """The load case that governs a shaft of one diameter, at the section where √(M² + T²) is largest."""

    case: str
    bending_moment: float
    torque: float
    axial_force: float
    bearings: tuple[BearingLoad, ...]
    diagram: ShaftDiagram


def _governing(context: Context, forces: ShaftForces) -> _Governing:
    moment = np.hypot(forces.drawn.bending[:, 0], forces.drawn.bending[:, 1])
    worst = np.unravel_index(int(np.argmax(np.hypot(moment, forces.drawn.torsion))), moment.shape)
    case = int(worst[0])
    return _Governing(
        case=list(context.flows)[case],
        bending_moment=float(moment[worst]),
        torque=abs(float(forces.drawn.torsion[worst])),
        axial_force=float(forces.axial[case]),
        bearings=forces.bearing_loads(case),
        diagram=forces.diagram(case),
    )


def _twisted(context: Context, plan: ShaftPlan, *, name: str) -> _Governing:
    """Return what governs a shaft that nothing bends: the case and the section where the torque is largest."""
    loads = sorted(pure_torques(context, name, plan), key=lambda load: load[0])
    position = tuple(place for place, _ in loads for _ in range(2))
    torsion = [_along(torques) for torques in zip(*(by_case for _, by_case in loads), strict=True)]
    largest = [max(map(abs, torques)) for torques in torsion]
    torque = max(largest)
    case = largest.index(torque)
    straight = (0.0,) * len(position)
    drawn = ShaftDiagram(position, (straight, straight), (straight, straight), torsion[case])
    return _Governing(list(context.flows)[case], 0.0, torque, 0.0, (), drawn)


def _along(torques: Iterable[float]) -> tuple[float, ...]:
    """Return the torque just left and just right of every load, from those of the loads."""
    stations, total = list[float](), 0.0
    for torque in torques:
        total += torque
        stations += (total - torque, total)
    return tuple(stations)


def _plain(
    context: Context, plan: ShaftPlan, load: _Governing, axis: complex, *, name: str, room: float = 0.0
) -> ShaftSizing:
    """Return a shaft of one diameter, by Tresca where √(M² + T²) is largest, around what goes through it."""
    rules, layout = context.design.shafting, context.design.layout.get(name, NOTHING_GIVEN)
    material, length = shaft_material(context), plan.length
    bending, torque = load.bending_moment, load.torque
    allowable = (material.yield_strength or 0.0) / rules.safety
    ratio = layout.bore_ratio if layout.bore_ratio is not None else rules.bore_ratio
    if layout.bore is not None:
        needed = shaft_diameter_around(layout.bore, bending, torque, allowable=allowable)
    else:
        needed = shaft_diameter(bending, torque, allowable, bore_ratio=ratio)
    bore = layout.bore if layout.bore is not None else ratio * needed
    if layout.bore is None and room > bore:
        around = shaft_diameter_around(room, bending, torque, allowable=allowable)
        needed, bore = max(around, room / THINNEST_WALL), room
    diameter = context.given.get(f"{name}.diameter", needed)
    if layout.bore is None and diameter != needed:
        bore = max(ratio * diameter, min(room, MOST_HOLLOW * diameter))
    mass = context.given.get(f"{name}.mass", shaft_mass(diameter, length, material.density, bore=bore))
    stress = shaft_stress(bending, torque, diameter, bore=bore) if diameter else 0.0
    stiffness = torsional_stiffness(diameter, length, material.shear_modulus, bore=bore)
    return ShaftSizing(
        name=name,
        case=load.case,
        speed=context.flows[load.case].speeds[name],
        torque=torque,
        bending_moment=bending,
        axial_force=load.axial_force,
        length=length,
        diameter=diameter,
        bore=bore,
        stress=stress,
        margin=allowable / stress if stress else math.inf,
        mass=mass,
        inertia=shaft_inertia(mass, diameter, bore=bore) if layout.inertia is None else layout.inertia,
        stiffness=layout.torsional_stiffness or stiffness,
        axis=(axis.real, axis.imag),
        bearings=load.bearings,
        diagram=load.diagram,
    )


def _built(context: Context, forces: ShaftForces, gears: Mapping[str, GearSizing], *, name: str) -> Built:
    core = context.given.get(f"{name}.diameter")
    return build_shaft(context, name, forces, shaft_material(context), gears=gears, core=core)


def _stepped(context: Context, forces: ShaftForces, built: Built, axis: complex, *, name: str) -> ShaftSizing:
    """Return the row of a built shaft: its weakest section, and the mass, inertia and stiffness of its steps."""
    rules, layout = context.design.shafting, context.design.layout.get(name, NOTHING_GIVEN)
    material, steps, bore = shaft_material(context), built.shaft.steps, built.shaft.bore
    weak = max(built.shaft.sections, key=lambda section: _tresca(section, bore))
    case, stress = list(context.flows).index(weak.case), _tresca(weak, bore)
    allowable = (material.yield_strength or 0.0) / rules.safety
    inside = {gear.name for gear in context.train.gears}
    outside = [0.0 if step.seat in inside else step.diameter for step in steps]
    pieces = [
        shaft_mass(diameter, step.end - step.start, material.density, bore=bore)
        for step, diameter in zip(steps, outside, strict=True)
    ]
    mass = context.given.get(f"{name}.mass", sum(pieces))
    turning = sum(shaft_inertia(piece, diameter, bore=bore) for piece, diameter in zip(pieces, outside, strict=True))
    compliance = sum(
        1.0 / torsional_stiffness(step.diameter, step.end - step.start, material.shear_modulus, bore=bore)
        for step in steps
    )
    inertia = turning * mass / sum(pieces)
    return ShaftSizing(
        name=name,
        case=weak.case,
        speed=context.flows[weak.case].speeds[name],
        torque=weak.torque,
        bending_moment=weak.bending_moment,
        axial_force=float(forces.axial[case]),
        length=forces.plan.length,
        diameter=max(step.diameter for step in steps if step.seat not in inside),
        bore=bore,
        stress=stress,
        margin=allowable / stress if stress else math.inf,
        mass=mass,
        inertia=inertia if layout.inertia is None else layout.inertia,
        stiffness=layout.torsional_stiffness or 1.0 / compliance,
        axis=(axis.real, axis.imag),
        bearings=forces.bearing_loads(case),
        diagram=forces.diagram(case),
    )


def _tresca(section: SectionStrength, bore: float) -> float:
    return shaft_stress(section.bending_moment, section.torque, section.diameter, bore=bore)
