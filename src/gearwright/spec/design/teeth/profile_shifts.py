"""Profile shifts of a stage from what its design gives: shifts of its gears, a centre distance, or how to balance them.

Two gears have two shifts and one centre distance, of which two are free; sun, planet and ring three shifts and one
centre distance that both meshes share, of which two are free. What is given beyond that has to agree.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gearwright.errors import DesignError, Problem, refuse
from gearwright.identity import Role
from gearwright.parts.gears import (
    BasicRack,
    CylindricalGear,
    GearPair,
    involute_room,
    reference_centre,
    working_angle_at,
)
from gearwright.spec.design.design import Design
from gearwright.spec.design.rules import GearRules
from gearwright.spec.design.stages import Pair, Planetary
from gearwright.spec.design.teeth.completed import cone_shifts, pair_shifts, set_shifts
from gearwright.spec.design.teeth.possible_teeth import impossible_teeth, pointed_cones
from gearwright.spec.design.teeth.shifts import PAIR_ROLES, Basis, StageShifts

_SHORTEST = 0.5
"""Most that internal teeth are shortened by themselves [-]."""
_SHADE = 1e-6
"""By which they are shorter than they must be, for rounding [-]."""


def stage_shifts(design: Design, name: str, teeth: Mapping[Role, int]) -> StageShifts:
    """Return the profile shifts of a stage of cylindrical gears whose teeth are known.

    Args:
        design: As read.
        name: Of a pair or planetary set.
        teeth: Role -> tooth number [-].

    Source: ISO 21771:2007; DIN 3960:1987 for tips; DIN 3992:1964 for balanced shifts.

    Raises:
        DesignError: Shifts and centre distances that contradict each other; with what would agree.
    """
    stage, rules = design.simple_stages[name], design.rules(name)
    planetary = isinstance(stage, Planetary)
    helix = 0.0 if planetary else rules.helix_angle
    path = f"{'planetaries' if planetary else 'pairs'}.{name}"
    basis = Basis(path, rules, {"pressure_angle": rules.pressure_angle, "helix_angle": helix})
    if isinstance(stage, Pair) and stage.kind == "bevel":
        teeth_of_cones = teeth[Role.PINION], teeth[Role.WHEEL]
        cones = cone_shifts(basis, stage, teeth_of_cones)
        shift, angle = cones.gears[0].profile_shift, rules.pressure_angle
        refuse(pointed_cones(path, teeth_of_cones, shift, pressure_angle=angle, spiral_angle=stage.spiral_angle))
        return cones
    try:
        if isinstance(stage, Planetary):
            shifts = set_shifts(basis, stage, (teeth[Role.SUN], teeth[Role.PLANET], teeth[Role.RING]))
        else:
            shifts = pair_shifts(basis, stage, (teeth[Role.PINION], teeth[Role.WHEEL]), _borrowed(design, stage))
    except DesignError as error:
        raise DesignError(_placed(path, problem) for problem in error.problems) from None
    if isinstance(stage, Pair) and stage.kind == "face":
        return shifts
    if ring := _ring_of(stage):
        shifts = _off_the_involute(basis, stage, ring, shifts, teeth)
    refuse(impossible_teeth(path, _shapes(basis, shifts, teeth), shifts.centre, ring=ring))
    return shifts


def _ring_of(stage: Pair | Planetary) -> Role | None:
    """Return which gear of a stage has its teeth inside, if one does."""
    if isinstance(stage, Planetary):
        return Role.RING
    return Role.WHEEL if stage.internal else None


def _off_the_involute(
    basis: Basis, stage: Pair | Planetary, ring: Role, shifts: StageShifts, teeth: Mapping[Role, int]
) -> StageShifts:
    """Return the shifts with the tips of internal teeth as short as the involute of the gear inside asks."""
    if getattr(stage, f"{ring}_tip_alteration") is not None:
        return shifts
    inside, wheel = list(_shapes(basis, shifts, teeth).values())[-2:]
    room = involute_room(GearPair(inside, replace(wheel, teeth=-wheel.teeth), shifts.centre))
    if room.clearance >= 0.0:
        return shifts
    shorter = shifts.gears[-1].tip_alteration + max(room.clearance, -_SHORTEST) - _SHADE
    return shifts._replace(gears=(*shifts.gears[:-1], shifts.gears[-1]._replace(tip_alteration=shorter)))


def _shapes(basis: Basis, shifts: StageShifts, teeth: Mapping[Role, int]) -> dict[Role, CylindricalGear]:
    """Return the teeth of a stage in a module of one metre."""
    rack = BasicRack(pressure_angle=basis.angles["pressure_angle"])
    helix = basis.angles["helix_angle"]
    return {
        role: CylindricalGear(number, 1.0, 1.0, helix, shift.profile_shift, rack, shift.tip_alteration)
        for (role, number), shift in zip(teeth.items(), shifts.gears, strict=True)
    }


def _placed(path: str, problem: Problem) -> Problem:
    """Return a problem of the formulas below the path of its stage."""
    if problem.path.startswith(path):
        return problem
    return Problem(f"{path}.{problem.path}" if problem.path == "centre_distance" else path, problem.message)


def _borrowed(design: Design, pair: Pair) -> dict[Role, float]:
    """Return the shifts that gears shared with other pairs have there, where their rules say a number."""
    shared = {side: pair.shared(side) for side in PAIR_ROLES}
    borrowed = {}
    for side, owner in shared.items():
        if owner is not None and owner[0] in design.pairs:
            other, role = design.pairs[owner[0]], owner[1]
            own = other.pinion_shift if role is Role.PINION else other.wheel_shift
            sign = 1.0 if role is Role.PINION else -1.0
            borrowed[side] = own if own is not None else sign * design.rules(owner[0]).profile_shift
    return borrowed


def working_angle(rules: GearRules, teeth_sum: int, shifts: StageShifts, helix_angle: float) -> float:
    """Return the working transverse pressure angle of a mesh of a stage α_wt [rad].

    Args:
        rules: Of the stage.
        teeth_sum: z_1 + z_2, with z_2 negative for an internal mesh [-].
        shifts: Of the stage.
        helix_angle: β [rad].

    Source: ISO 21771:2007, cos α_wt = a cos α_t/a_w.
    """
    centre = reference_centre(teeth_sum, helix_angle) if shifts.centre is None else shifts.centre
    return working_angle_at(teeth_sum, centre, pressure_angle=rules.pressure_angle, helix_angle=helix_angle)
