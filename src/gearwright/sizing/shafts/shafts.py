"""Shafts and carriers of a sized train: uniform, stepped or concentric shafts, pins and plates, and their checks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import (
    Check,
    DesignError,
    Kind,
    PartId,
    Problem,
    largest,
    refuse,
    smallest,
    stressed,
    text,
)
from gearwright.parts import Material
from gearwright.parts.shafts import (
    shaft_diameter,
    shaft_diameter_around,
    shaft_inertia,
    shaft_mass,
    shaft_stress,
    torsional_stiffness,
)
from gearwright.sizing.bearings import life_check, limit_checks
from gearwright.sizing.loads import ShaftForces, pure_torques, shaft_forces
from gearwright.sizing.rating import Context
from gearwright.sizing.result import Arrangement, GearSizing, ShaftPlan
from gearwright.sizing.shaft_results import (
    BearingLoad,
    BearingSizing,
    BuiltShaft,
    JointSizing,
    SectionStrength,
    ShaftDiagram,
    ShaftSizing,
)
from gearwright.sizing.shafts.building import Built, build_shaft
from gearwright.sizing.shafts.stretches import BEARING_SLOPES, GEAR_SLOPE
from gearwright.spec import Design
from gearwright.spec.design import NOTHING_GIVEN

# ----------------------------------------------------------------------------------------------------------------------
# Shafts that go through one another: the inner ones are sized first, the outer ones around them.
# ----------------------------------------------------------------------------------------------------------------------


THINNEST_WALL = 0.9
"""Bore over diameter of a shaft around another one that strength alone would make thinner, an assumption [-]."""


def inner_first(arrangement: Arrangement) -> Sequence[str]:
    """Return the shafts in the order of the design, but every one behind those that go through it.

    Args:
        arrangement: With what goes through what.
    """
    if not arrangement.within:
        return tuple(arrangement.plans)
    found = list[str]()
    while len(found) < len(arrangement.plans):
        waiting = {outer for inner, outer in arrangement.within if inner not in found}
        found += [name for name in arrangement.plans if name not in found and name not in waiting]
    return found


def least_bore(context: Context, arrangement: Arrangement, shafts: Sequence[ShaftSizing], outer: str) -> float:
    """Return the bore that a shaft needs around those that go through it; 0 where none does [m].

    Args:
        context: What sizing reads.
        arrangement: With what goes through what.
        shafts: Sized so far, the inner ones among them.
        outer: Name of the shaft.
    """
    inner = {first for first, second in arrangement.within if second == outer}
    if not inner:
        return 0.0
    thickest = max((shaft.diameter for shaft in shafts if shaft.name in inner), default=0.0)
    return thickest + 2.0 * context.design.shafting.radial_gap


# ----------------------------------------------------------------------------------------------------------------------
# Shafts that come out without a diameter, as no load case loads them, or with too thin a wall: refused.
# ----------------------------------------------------------------------------------------------------------------------


NOTHING = 1e-9
"""Load over the largest one below which it is rounding [-]."""
MOST_HOLLOW = 0.95
"""Largest bore over diameter, as for bore_ratio [-]."""


def refuse_idle_shafts(shafts: Iterable[ShaftSizing]) -> None:
    """Raise where nothing loads a shaft whose diameter is not given.

    Args:
        shafts: As sized.

    Raises:
        DesignError: For every such shaft, with what to give.
    """
    sized = list(shafts)
    load = {shaft.name: math.hypot(shaft.torque, shaft.bending_moment) for shaft in sized}
    largest, thickest = max(load.values()), max(shaft.diameter for shaft in sized)
    problems = [
        Problem(
            f"layout.{shaft.name}.diameter_mm",
            f"no load case loads the shaft {shaft.name!r}, so that strength asks for no diameter; give one, such as"
            f" {1e3 * thickest:.3g}, or a case that loads it",
        )
        for shaft in sized
        if load[shaft.name] <= NOTHING * largest and shaft.diameter <= math.cbrt(NOTHING) * thickest
    ]
    refuse(problems)


def refuse_bores(shafts: Iterable[ShaftSizing]) -> None:
    """Raise where a given bore leaves too thin a wall in a shaft.

    Args:
        shafts: As sized.

    Raises:
        DesignError: With the bore and the diameter of every such shaft.
    """
    problems = [
        Problem(
            f"layout.{shaft.name}.bore_mm",
            f"the bore {text(shaft.bore, 'length')} leaves too thin a wall in a shaft of"
            f" {text(shaft.diameter, 'length')}; it may be {MOST_HOLLOW:.0%} of the diameter: give a smaller bore",
        )
        for shaft in shafts
        if shaft.diameter and shaft.bore > MOST_HOLLOW * shaft.diameter
    ]
    refuse(problems)


# ----------------------------------------------------------------------------------------------------------------------
# Shafts of a sized train: of one diameter, or built where the design gives them bearings.
# ----------------------------------------------------------------------------------------------------------------------


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
    weak = largest(built.shaft.sections, lambda section: _tresca(section, bore))
    case, stress = forces.names(context.flows).index(weak.case), _tresca(weak, bore)
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
        speed=forces.by_row([flow.speeds[name] for flow in context.flows.values()])[case],
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


# ----------------------------------------------------------------------------------------------------------------------
# Every check of shafts, carriers, bearings and joints against its limit.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_CRITICAL = 2.0
"""First critical speed over the highest speed [-] (Shigley, 10th ed., §7-6)."""
THICKEST_RIM = 1.2
"""Rim under the teeth over their height from which on it does not weaken them [-] (ISO 6336-3:2019, Y_B = 1)."""
_CLAUSES = {"key": "DIN 6892:2012, C", "spline": "DIN 5480, first sizing", "press-fit": "DIN 7190-1"}


def shaft_checks(shaft: ShaftSizing) -> Iterator[Check]:
    """Yield the check of a shaft of one diameter, or of the section of a built one that its stress is of.

    Args:
        shaft: As sized.
    """
    part, clause = PartId(Kind.SHAFT, shaft.name), "Pulvirenti 2023, eq. 2.47"
    yield stressed(part, "Tresca", clause, shaft.stress, shaft.margin, case=shaft.case)


def built_checks(built: Built, design: Design) -> Iterator[Check]:
    """Yield every check of a built shaft, its bearings and its joints.

    Args:
        built: The shaft.
        design: With its limits.
    """
    yield from _strength(built.shaft, design)
    yield from _stiffness(built.shaft, design)
    for bearing in built.bearings:
        yield from _bearing(bearing, design)
    for joint in built.joints:
        yield from _joint(joint)
    yield from built.fits


_LAWS = {"asme": "DE-ASME", "goodman": "DE-Goodman", "gerber": "DE-Gerber", "soderberg": "DE-Soderberg"}
"""Criterion -> as tables name it."""


def _strength(shaft: BuiltShaft, design: Design) -> Iterator[Check]:
    service, part = design.service, PartId(Kind.SHAFT, shaft.name)
    tired, strained = shaft.weakest, smallest(shaft.sections, lambda section: section.yield_safety)
    law = _LAWS[design.shafting.fatigue]
    yield Check(
        part, "fatigue", f"{law}, Shigley ch. 7", tired.fatigue_safety, service.shaft_fatigue_safety,
        symbol="n_f", place=tired.place, case=tired.case,
    )  # fmt: skip
    yield Check(
        part, "yield", "Shigley eq. 7-16", strained.yield_safety, service.shaft_yield_safety,
        symbol="n_y", place=strained.place, case=strained.case,
    )  # fmt: skip
    held = [(section, section.limit_safety) for section in shaft.sections if section.limit_safety is not None]
    if held:
        section, safety = smallest(held, lambda one: one[1])
        clause = "CS-25.303, 25.305: yield, and 1.5 x limit against R_m"
        yield Check(part, "limit load", clause, safety, 1.0, place=section.place)


def _stiffness(shaft: BuiltShaft, design: Design) -> Iterator[Check]:
    part = PartId(Kind.SHAFT, shaft.name)
    for place, slope in shaft.slopes:
        limit = _slope_limit(place, design)
        if limit is not None and slope > 0.0:
            yield Check(part, "slope", "Shigley table 7-2", slope, limit, "slope", at_most=True, place=place)
    if shaft.critical_speed is not None:
        first, asked = shaft.critical_speed, LEAST_CRITICAL * shaft.highest_speed
        yield Check(part, "first critical speed", "Shigley §7-6", first, asked, "speed", exponent=None)


def _slope_limit(place: str, design: Design) -> float | None:
    """Return what is allowed at a gear or a bearing [rad]."""
    return BEARING_SLOPES.get(design.bearings[place].kind) if place in design.bearings else GEAR_SLOPE


def _bearing(bearing: BearingSizing, design: Design) -> Iterator[Check]:
    part, place, taken = PartId(Kind.BEARING, bearing.name), bearing.designation, bearing.bearing
    yield life_check(part, taken, bearing.life, bearing.oiled, bearing.wanted_life, design)
    yield Check(
        part, "static safety", "ISO 76:2006", bearing.static_safety, bearing.wanted_static_safety,
        symbol="s_0", place=place, case=bearing.case,
    )  # fmt: skip
    yield from limit_checks(part, taken, bearing.running, design)


def _joint(joint: JointSizing) -> Iterator[Check]:
    if joint.kind == "integral":
        return
    part, clause = PartId(Kind.JOINT, joint.part, branch=joint.shaft), _CLAUSES[joint.kind]
    pressure, allowed = joint.pressure, joint.allowed_pressure
    yield Check(part, f"{joint.kind} pressure", clause, pressure, allowed, "stress", at_most=True)
    if joint.kind == "press-fit" and joint.speed:
        running, needed = joint.running_pressure, joint.needed_pressure
        yield Check(part, "press-fit pressure at speed", "DIN 7190-1", running, needed, "stress", symbol="p")
    if joint.rim is not None and joint.rim > 0.0:
        clause = "ISO 6336-3:2019, Y_B"
        yield Check(part, "rim under the teeth", clause, joint.rim, THICKEST_RIM, exponent=None, symbol="s_R/h_t")
