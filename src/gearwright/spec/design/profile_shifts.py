"""Profile shifts of a stage from what its design gives: shifts of its gears, a centre distance, or how to balance them.

Two gears have two shifts and one centre distance, of which two are free; sun, planet and ring three shifts and one
centre distance that both meshes share, of which two are free. What is given beyond that has to agree.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import NamedTuple

from gearwright.errors import DesignError, Problem, refuse
from gearwright.identity import Role
from gearwright.parts.bevel import gleason_profile_shift
from gearwright.parts.gears import (
    ISO53_A,
    UNSHIFTED,
    BasicRack,
    CylindricalGear,
    GearPair,
    ToothShift,
    involute_room,
    least_profile_shift,
    reference_centre,
    shifts_at,
    tip_shortening,
    working_angle_at,
    working_centre,
)
from gearwright.parts.iso6336 import MeshGeometry, balanced_shift, shifted_mesh
from gearwright.spec.design.design import Design
from gearwright.spec.design.gears import GearRules
from gearwright.spec.design.possible_teeth import impossible_teeth
from gearwright.spec.design.stages import Pair, Planetary

DEFAULT_BALANCE = "sliding"
"""How a sum of shifts is divided where the design says nothing."""
ROUNDING = 2e-3
"""Part of a module by which given shifts may miss a centre distance: they are written with three decimals [-]."""
PAIR_ROLES = (Role.PINION, Role.WHEEL)
SET_ROLES = (Role.SUN, Role.PLANET, Role.RING)
_SHORTEST = 0.5
"""Most that internal teeth are shortened by themselves [-]."""
_SHADE = 1e-6
"""By which they are shorter than they must be, for rounding [-]."""
_WIDEST = 1.5
"""Largest shift that is looked at [-]."""


class StageShifts(NamedTuple):
    """Profile shifts and tip alterations of the gears of a stage, and where they mesh."""

    gears: tuple[ToothShift, ...] = (UNSHIFTED, UNSHIFTED)
    """Of pinion and wheel, or of sun, planet and ring."""
    centre: float | None = None
    """Working centre distance over the module a_w/m_n [-]; None: the reference one of every mesh."""

    def mesh(self, *, internal: bool) -> tuple[ToothShift, ToothShift]:
        """Return the shifts of the two gears of a mesh.

        Args:
            internal: Of a planet and its ring, or of an internal pair.
        """
        first, second = self.gears[-2:] if internal else self.gears[:2]
        return first, second

    def of(self, role: Role) -> ToothShift:
        """Return the shift of one gear.

        Args:
            role: What it is in its stage.
        """
        roles = SET_ROLES if len(self.gears) == len(SET_ROLES) else PAIR_ROLES
        return self.gears[roles.index(role)] if role in roles else UNSHIFTED


class _Basis(NamedTuple):
    """What the shifts of a stage are found from."""

    path: str
    rules: GearRules
    angles: Mapping[str, float]
    """α_n and β, as the formulas of parts name them [rad]."""

    def sum_at(self, teeth: int, centre: float) -> float:
        return shifts_at(teeth, centre, **self.angles)

    def centre_of(self, teeth: int, shifts: float) -> float:
        return working_centre(teeth, shifts, **self.angles)

    def refused(self, key: str, message: str) -> DesignError:
        return DesignError([Problem(f"{self.path}.{key}", message)])


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
    basis = _Basis(path, rules, {"pressure_angle": rules.pressure_angle, "helix_angle": helix})
    if isinstance(stage, Pair) and stage.kind == "bevel":
        return _cone(basis, stage, (teeth[Role.PINION], teeth[Role.WHEEL]))
    try:
        if isinstance(stage, Planetary):
            shifts = _set(basis, stage, (teeth[Role.SUN], teeth[Role.PLANET], teeth[Role.RING]))
        else:
            shifts = _pair(basis, stage, (teeth[Role.PINION], teeth[Role.WHEEL]), _borrowed(design, stage))
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
    basis: _Basis, stage: Pair | Planetary, ring: Role, shifts: StageShifts, teeth: Mapping[Role, int]
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


def _shapes(basis: _Basis, shifts: StageShifts, teeth: Mapping[Role, int]) -> dict[Role, CylindricalGear]:
    """Return the teeth of a stage in a module of one metre."""
    rack = BasicRack(pressure_angle=basis.angles["pressure_angle"])
    helix = basis.angles["helix_angle"]
    return {
        role: CylindricalGear(number, 1.0, 1.0, helix, shift.profile_shift, rack, shift.tip_alteration)
        for (role, number), shift in zip(teeth.items(), shifts.gears, strict=True)
    }


def _cone(basis: _Basis, pair: Pair, teeth: tuple[int, int]) -> StageShifts:
    """Return the profile shift of a bevel pair, x_hm1 = −x_hm2: given, or Gleason's for balanced strength."""
    by, shift = basis.rules.balanced_shifts, pair.pinion_shift
    if pair.wheel_shift is not None and shift is not None and pair.wheel_shift != -shift:
        raise basis.refused(
            "wheel_shift", f"{pair.wheel_shift:g}, but bevel gears mesh with x_hm2 = −x_hm1 = {-shift:g}"
        )
    if shift is None and pair.wheel_shift is not None:
        shift = -pair.wheel_shift
    if shift is None and by == "sliding":
        message = '"sliding", but bevel gears are balanced by strength here; write "strength", or give pinion_shift'
        raise basis.refused("gears.balanced_shifts", message)
    if shift is None:
        shift = gleason_profile_shift(teeth) if by == "strength" else basis.rules.profile_shift
    return StageShifts((ToothShift(shift + 0.0), ToothShift(0.0 - shift)))


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


def _pair(basis: _Basis, pair: Pair, teeth: tuple[int, int], borrowed: Mapping[Role, float]) -> StageShifts:
    first, second = borrowed.get(Role.PINION, pair.pinion_shift), borrowed.get(Role.WHEEL, pair.wheel_shift)
    signed = (teeth[0], -teeth[1] if pair.internal else teeth[1])
    total = sum(signed)
    centre = _given_centre(basis, pair)
    if centre is None and first is not None and second is not None:
        centre = basis.centre_of(total, first + second)
    if centre is None:
        if first is None and second is None and basis.rules.balanced_shifts is None:
            first = basis.rules.profile_shift
        given = first if first is not None else None if second is None else -second
        if given is None:
            given = _divided(basis, signed, 0.0, None)
        return StageShifts(_altered(basis, pair, PAIR_ROLES, (given + 0.0, 0.0 - given), signed, None))
    wanted = basis.sum_at(total, centre)
    shifts = _completed((first, second), wanted, lambda: _divided(basis, signed, wanted, centre))
    _agree(basis, "wheel_shift", shifts, total, centre)
    return StageShifts(_altered(basis, pair, PAIR_ROLES, shifts, signed, centre), centre)


def _set(basis: _Basis, planetary: Planetary, teeth: tuple[int, int, int]) -> StageShifts:
    sun, planet, ring = planetary.sun_shift, planetary.planet_shift, planetary.ring_shift
    outer, inner = teeth[0] + teeth[1], teeth[1] - teeth[2]
    centre = _given_centre(basis, planetary)
    if centre is None and sun is not None and planet is not None:
        centre = basis.centre_of(outer, sun + planet)
    if centre is None and planet is not None and ring is not None:
        centre = basis.centre_of(inner, planet + ring)
    closes = outer == -inner
    balanced = basis.rules.balanced_shifts is not None
    if centre is None and not closes:
        if not balanced:
            raise basis.refused("ring_teeth", _unclosed(teeth))
        centre = 0.5 * (reference_centre(outer, 0.0) + reference_centre(inner, 0.0))
    given = (sun, planet, ring)
    if centre is None and given == (None, None, None) and not balanced:
        sun = basis.rules.profile_shift
    at_reference = centre is None
    centre = reference_centre(outer, 0.0) if centre is None else centre
    sums = (basis.sum_at(outer, centre), basis.sum_at(inner, centre))
    if planet is None:
        if sun is None and ring is not None:
            planet = sums[1] - ring
        elif sun is None:
            sun = _divided(basis, (teeth[0], teeth[1]), sums[0], None if at_reference else centre)
        planet = sums[0] - (sun or 0.0) if planet is None else planet
    shifts = (
        (sun if sun is not None else sums[0] - planet) + 0.0,
        planet + 0.0,
        (ring if ring is not None else sums[1] - planet) + 0.0,
    )
    _agree(basis, "planet_shift", shifts[:2], outer, centre)
    _agree(basis, "ring_shift", shifts[1:], inner, centre)
    place = None if at_reference else centre
    return StageShifts(_altered(basis, planetary, SET_ROLES, shifts, (teeth[0], teeth[1]), place), place)


def _given_centre(basis: _Basis, stage: Pair | Planetary) -> float | None:
    """Return the given centre distance over the given module [-]."""
    if stage.centre_distance is None:
        return None
    if stage.module is None:
        message = "shifts follow from a centre distance only with the module; give module_mm, too"
        raise basis.refused("centre_distance", message)
    return stage.centre_distance / stage.module


def _completed(
    given: tuple[float | None, float | None], wanted: float, divided: Callable[[], float]
) -> tuple[float, float]:
    """Return both shifts of a pair whose sum is known."""
    first, second = given
    if first is None and second is None:
        first = divided()
    if first is None and second is not None:
        first = wanted - second
    assert first is not None
    return first, wanted - first if second is None else second


def _agree(basis: _Basis, key: str, shifts: tuple[float, ...], teeth: int, centre: float) -> None:
    """Refuse shifts that close elsewhere than at the centre distance."""
    closes = basis.centre_of(teeth, sum(shifts))
    if abs(closes - centre) > ROUNDING:
        wanted = basis.sum_at(teeth, centre)
        message = (
            f"the shifts {shifts[0]:.4g} and {shifts[1]:.4g} close at {closes:.5g} modules and the stage stands at"
            f" {centre:.5g}; their sum must be {wanted:.4f}: give {wanted - shifts[0]:.4f} and"
            f" {shifts[0]:.4g}, or leave one of them out"
        )
        raise basis.refused(key, message)


def _divided(basis: _Basis, teeth: tuple[int, int], total: float, centre: float | None) -> float:
    """Return x_1 of a sum of shifts that balances two gears as the rules say, without undercut of either."""
    limits = [
        least_profile_shift(number, ISO53_A.straight_dedendum, **basis.angles) if number > 0 else -_WIDEST
        for number in teeth
    ]
    least, most = max(limits[0], -_WIDEST), min(total - limits[1], _WIDEST)
    if least > most:
        needed = sum(limits)
        message = (
            f"no shifts keep {teeth[0]} and {teeth[1]} teeth free of undercut on this centre distance: together they"
            f" need {needed:.3f} and it leaves {total:.3f}; give a larger centre distance, or more teeth"
        )
        raise basis.refused("centre_distance", message)
    by = basis.rules.balanced_shifts or DEFAULT_BALANCE

    def shape(first: float) -> MeshGeometry:
        shifts = (first, total - first)
        tips = _shortening(basis, teeth, shifts, centre)
        return shifted_mesh(teeth, (ToothShift(shifts[0], tips), ToothShift(shifts[1], tips)), centre, **basis.angles)

    return balanced_shift(shape, least, most, by=by)


def _shortening(basis: _Basis, teeth: tuple[int, int], shifts: tuple[float, ...], centre: float | None) -> float:
    """Return the tip alteration of an external mesh; internal ones keep their tips."""
    if centre is None or min(teeth) < 0:
        return 0.0
    return tip_shortening(sum(teeth), centre, shifts[0] + shifts[1], helix_angle=basis.angles["helix_angle"])


def _altered(
    basis: _Basis,
    stage: Pair | Planetary,
    roles: tuple[Role, ...],
    shifts: tuple[float, ...],
    teeth: tuple[int, int],
    centre: float | None,
) -> tuple[ToothShift, ...]:
    """Return the shifts with the tip alterations: given, or those that keep the tip clearance."""
    kept = _shortening(basis, teeth, shifts[:2], centre)
    altered = []
    for role, shift in zip(roles, shifts, strict=True):
        given = getattr(stage, f"{role}_tip_alteration")
        usual = 0.0 if role is Role.RING else kept
        altered.append(ToothShift(shift, usual if given is None else given))
    return tuple(altered)


def _unclosed(teeth: tuple[int, int, int]) -> str:
    sun, planet, ring = teeth
    return (
        f"{ring} does not close without profile shift: z_s + 2 z_p = {sun} + 2·{planet} = {sun + 2 * planet}; give"
        ' shifts (sun_shift and planet_shift), a centre_distance, gears.balanced_shifts = "strength", or'
        f" {sun + 2 * planet} teeth"
    )


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
