"""Profile shifts that complete those given: of a pair, of a planetary set, of a bevel pair."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from gearwright.errors import refuse
from gearwright.identity import Role
from gearwright.parts.bevel import gleason_profile_shift
from gearwright.parts.gears import ToothShift, reference_centre
from gearwright.spec.design.stages import Pair, Planetary
from gearwright.spec.design.teeth.shifts import (
    PAIR_ROLES,
    SET_ROLES,
    Basis,
    StageShifts,
    altered,
    disagreements,
    divided,
    given_centre,
    refuse_wide,
)


def pair_shifts(basis: Basis, pair: Pair, teeth: tuple[int, int], borrowed: Mapping[Role, float]) -> StageShifts:
    """Return the profile shifts of a pair of cylindrical gears: those given, and what closes or balances the rest.

    Args:
        basis: Of the stage.
        pair: As read.
        teeth: Of its gears [-].
        borrowed: Shifts that shared gears have in other pairs [-].

    Raises:
        DesignError: What is given contradicts itself.
    """
    first, second = borrowed.get(Role.PINION, pair.pinion_shift), borrowed.get(Role.WHEEL, pair.wheel_shift)
    signed = (teeth[0], -teeth[1] if pair.internal else teeth[1])
    total = sum(signed)
    centre = given_centre(basis, pair)
    if centre is None and first is not None and second is not None:
        centre = basis.centre_of(total, first + second)
    if centre is None:
        if first is None and second is None and basis.rules.balanced_shifts is None:
            first = basis.rules.profile_shift
        given = first if first is not None else None if second is None else -second
        if given is None:
            given = divided(basis, signed, 0.0, None)
        return StageShifts(altered(basis, pair, PAIR_ROLES, (given + 0.0, 0.0 - given), signed, None))
    wanted = basis.sum_at(total, centre)
    shifts = _completed((first, second), wanted, lambda: divided(basis, signed, wanted, centre))
    named = dict(zip(("pinion_shift", "wheel_shift"), shifts, strict=True))
    changed = "pinion_shift" if Role.WHEEL in borrowed else "wheel_shift"
    refuse(disagreements(basis, named, changed=changed, teeth=total, centre=centre))
    for role, shift in zip(PAIR_ROLES, shifts, strict=True):
        refuse_wide(basis, role, shift, signed)
    return StageShifts(altered(basis, pair, PAIR_ROLES, shifts, signed, centre), centre)


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


def set_shifts(basis: Basis, planetary: Planetary, teeth: tuple[int, int, int]) -> StageShifts:
    """Return the profile shifts of sun, planet and ring: those given, and what closes or balances the rest.

    Args:
        basis: Of the stage.
        planetary: As read.
        teeth: Of its gears [-].

    Raises:
        DesignError: What is given contradicts itself.
    """
    sun, planet, ring = planetary.sun_shift, planetary.planet_shift, planetary.ring_shift
    outer, inner = teeth[0] + teeth[1], teeth[1] - teeth[2]
    centre = given_centre(basis, planetary)
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
            sun = divided(basis, (teeth[0], teeth[1]), sums[0], None if at_reference else centre)
        planet = sums[0] - (sun or 0.0) if planet is None else planet
    shifts = (
        (sun if sun is not None else sums[0] - planet) + 0.0,
        planet + 0.0,
        (ring if ring is not None else sums[1] - planet) + 0.0,
    )
    # The planet's shift stays: the other mesh has it, too.
    first = {"sun_shift": shifts[0], "planet_shift": shifts[1]}
    refuse(disagreements(basis, first, changed="sun_shift", teeth=outer, centre=centre))
    second = {"ring_shift": shifts[2], "planet_shift": shifts[1]}
    refuse(disagreements(basis, second, changed="ring_shift", teeth=inner, centre=centre))
    for role, shift in zip(SET_ROLES, shifts, strict=True):
        refuse_wide(basis, role, shift, (teeth[1], -teeth[2]) if role is Role.RING else (teeth[0], teeth[1]))
    place = None if at_reference else centre
    return StageShifts(altered(basis, planetary, SET_ROLES, shifts, (teeth[0], teeth[1]), place), place)


def _unclosed(teeth: tuple[int, int, int]) -> str:
    sun, planet, ring = teeth
    return (
        f"{ring} does not close without profile shift: z_s + 2 z_p = {sun} + 2·{planet} = {sun + 2 * planet}; give"
        ' shifts (sun_shift and planet_shift), a centre_distance, gears.balanced_shifts = "strength", or'
        f" {sun + 2 * planet} teeth"
    )


def cone_shifts(basis: Basis, pair: Pair, teeth: tuple[int, int]) -> StageShifts:
    """Return the profile shift of a bevel pair, x_hm1 = −x_hm2: given, or Gleason's for balanced strength.

    Args:
        basis: Of the stage.
        pair: As read.
        teeth: z_1 and z_2 [-].

    Raises:
        DesignError: Shifts that are not opposite, or a balance that bevel gears do not have.
    """
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
