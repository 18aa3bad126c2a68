"""Profile shifts of a stage from what its design gives: shifts of its gears, a centre distance, or how to balance them.

Two gears have two shifts and one centre distance, of which two are free; sun, planet and ring three shifts and one
centre distance that both meshes share, of which two are free. What is given beyond that has to agree.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise

from gearwright.errors import DesignError, Problem, refuse
from gearwright.identity import Role
from gearwright.parts.gears import (
    BasicRack,
    CylindricalGear,
    GearPair,
    reference_centre,
    working_angle_at,
)
from gearwright.spec.design.design import Design
from gearwright.spec.design.rules import GearRules
from gearwright.spec.design.stages import Pair, Planetary
from gearwright.spec.design.teeth.completed import cone_shifts, pair_shifts, set_shifts
from gearwright.spec.design.teeth.possible_teeth import (
    Keys,
    fouling,
    impossible_teeth,
    in_the_root,
    off_the_involute,
    pointed_cones,
)
from gearwright.spec.design.teeth.shifts import PAIR_ROLES, Basis, StageShifts, placed


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
        raise DesignError(placed(path, problem) for problem in error.problems) from None
    if isinstance(stage, Pair) and stage.kind == "face":
        return shifts
    ring = _ring_of(stage)
    if ring is not None:
        shifts = _off_the_involute(basis, stage, ring, shifts, teeth)
    gears = tuple(_shapes(basis, shifts, teeth).items())
    refuse([*_impossible(path, gears, shifts.centre, ring), *_grounded(path, gears, shifts.centre, ring, stage.module)])
    return shifts


@lru_cache(maxsize=4096)
def _impossible(
    path: str, gears: tuple[tuple[Role, CylindricalGear], ...], centre: float | None, ring: Role | None
) -> tuple[Problem, ...]:
    """Return what is impossible of the teeth of a stage; those of a study repeat."""
    outside = [(role, gear) for role, gear in gears if role is not ring]
    problems = [problem for role, gear in outside for problem in impossible_teeth(_keys(path, role), gear)]
    if ring is not None:
        problems += fouling(_keys(path, ring), _in_ring(outside[-1][1], dict(gears)[ring], centre))
    return tuple(problems)


@lru_cache(maxsize=4096)
def _grounded(
    path: str, gears: tuple[tuple[Role, CylindricalGear], ...], centre: float | None, ring: Role | None,
    module: float | None,
) -> tuple[Problem, ...]:  # fmt: skip
    """Return whose tips run into the root of a mate."""
    keys = {str(role): _keys(path, role)._replace(module=module) for role, _ in gears}
    meshes = {
        (str(first), str(second)): (_in_ring(one, two, centre) if second is ring else GearPair(one, two, centre))
        for (first, one), (second, two) in pairwise(gears)
    }
    return tuple(in_the_root(keys, meshes))


def _keys(path: str, role: Role) -> Keys:
    return Keys(f"{path}.{role}_shift", f"{path}.{role}_teeth", f"{role}_tip_alteration")


def _in_ring(inside: CylindricalGear, ring: CylindricalGear, centre: float | None) -> GearPair:
    return GearPair(inside, replace(ring, teeth=-ring.teeth), centre)


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
    tip = _cleared(inside, wheel, shifts.centre)
    return shifts._replace(gears=(*shifts.gears[:-1], shifts.gears[-1]._replace(tip_alteration=tip)))


@lru_cache(maxsize=4096)
def _cleared(inside: CylindricalGear, wheel: CylindricalGear, centre: float | None) -> float:
    """Return the tip alteration that clears the involute of the gear inside [-]; the teeth of a study repeat."""
    return off_the_involute(_in_ring(inside, wheel, centre))


def _shapes(basis: Basis, shifts: StageShifts, teeth: Mapping[Role, int]) -> dict[Role, CylindricalGear]:
    """Return the teeth of a stage in a module of one metre."""
    rack = BasicRack(pressure_angle=basis.angles["pressure_angle"])
    helix = basis.angles["helix_angle"]
    return {
        role: CylindricalGear(number, 1.0, 1.0, helix, shift.profile_shift, rack, shift.tip_alteration)
        for (role, number), shift in zip(teeth.items(), shifts.gears, strict=True)
    }


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
