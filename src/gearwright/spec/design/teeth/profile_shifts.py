"""Profile shift coefficients of pairs and planetary stages: specified, completed, balanced and limited."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache
from itertools import count, islice, pairwise, takewhile
from typing import NamedTuple

from gearwright.base import DesignError, Problem, Role, refuse
from gearwright.parts.bevel_geometry import gleason_profile_shift
from gearwright.parts.gears import (
    ISO53_A,
    UNSHIFTED,
    BasicRack,
    CylindricalGear,
    GearPair,
    Room,
    ToothShift,
    involute_room,
    least_profile_shift,
    reference_centre,
    shifts_at,
    tip_clearances,
    tip_room,
    tip_shortening,
    tip_thickness,
    working_angle_at,
    working_centre,
)
from gearwright.parts.iso6336 import MeshGeometry, balanced_shift, shifted_mesh
from gearwright.spec.design.design import Design
from gearwright.spec.design.rules import GearRules
from gearwright.spec.design.stages import Pair, Planetary

# ----------------------------------------------------------------------------------------------------------------------
# What the profile shifts of a stage are found from and how they are divided, balanced and held against each other.
# ----------------------------------------------------------------------------------------------------------------------


DEFAULT_BALANCE = "sliding"
"""How a sum of shifts is divided where the design says nothing."""
ROUNDING = 2e-3
"""Part of a module by which given shifts may miss a centre distance: they are written with three decimals [-]."""
PAIR_ROLES = (Role.PINION, Role.WHEEL)
SET_ROLES = (Role.SUN, Role.PLANET, Role.RING)
WIDEST = 1.5
"""Largest shift that is looked at [-]."""
_ROUNDED = 1e-9
"""By which rounding may miss it [-]."""
_STEPS = 24
"""In which the centre distances that shifts reach are looked for, to either side [-]."""


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


class Basis(NamedTuple):
    """What the shifts of a stage are found from."""

    path: str
    """Of the stage."""
    rules: GearRules
    angles: Mapping[str, float]
    """α_n and β, as the formulas of parts name them [rad]."""

    def sum_at(self, teeth: int, centre: float) -> float:
        """Return the sum of shifts that closes a mesh at a centre distance over the module [-].

        Args:
            teeth: z_1 + z_2, with z_2 negative for an internal mesh [-].
            centre: a_w/m_n [-].
        """
        return shifts_at(teeth, centre, **self.angles)

    def centre_of(self, teeth: int, shifts: float) -> float:
        """Return the centre distance over the module at which a sum of shifts closes a mesh [-].

        Args:
            teeth: z_1 + z_2, with z_2 negative for an internal mesh [-].
            shifts: x_1 + x_2 [-].
        """
        return working_centre(teeth, shifts, **self.angles)

    def refused(self, key: str, message: str) -> DesignError:
        """Return the error that names one key of the stage.

        Args:
            key: Below the stage's table.
            message: What is wrong with it.
        """
        return DesignError([Problem(f"{self.path}.{key}", message)])


def placed(path: str, problem: Problem) -> Problem:
    """Return a problem of the formulas below the path of what they were asked for.

    Args:
        path: Of a stage, or of the planet whose pin it is.
        problem: As the formulas name it.
    """
    if problem.path.startswith(path):
        return problem
    return Problem(f"{path}.{problem.path}" if problem.path == "centre_distance" else path, problem.message)


def given_centre(basis: Basis, stage: Pair | Planetary) -> float | None:
    """Return the given centre distance over the given module [-].

    Args:
        basis: Of the stage.
        stage: As read.
    """
    if stage.centre_distance is None:
        return None
    if stage.module is None:
        message = "shifts follow from a centre distance only with the module; give module_mm, too"
        raise basis.refused("centre_distance", message)
    return stage.centre_distance / stage.module


def disagreements(
    basis: Basis, shifts: Mapping[str, float], *, changed: str, teeth: int, centre: float
) -> Iterator[Problem]:
    """Yield shifts that close elsewhere than at the centre distance.

    Args:
        basis: Of the stage.
        shifts: Key -> shift of the two gears of a mesh [-].
        changed: Key of the one whose shift can change without moving the centre distance.
        teeth: z_1 + z_2, with z_2 negative for an internal mesh [-].
        centre: a_w/m_n at which the stage stands [-].
    """
    closes = basis.centre_of(teeth, sum(shifts.values()))
    if abs(closes - centre) > ROUNDING:
        needed = basis.sum_at(teeth, centre) - sum(shifts.values()) + shifts[changed]
        given = " and ".join(f"{key} = {shift:.4g}" for key, shift in shifts.items())
        wanted = f"give {changed} = {needed:.4f}, or leave one of them out"
        if abs(needed) > WIDEST:
            wanted = f"it would take {changed} = {needed:.4f}, beyond ±{WIDEST:g}; leave one of them out"
        message = f"{given} close at {closes:.5g} modules and the stage stands at {centre:.5g}; {wanted}"
        yield Problem(f"{basis.path}.{changed}", message)


def refuse_wide(basis: Basis, role: str, shift: float, mates: tuple[int, int]) -> None:
    """Refuse a shift that is wider than any that is looked at, as a centre distance far away asks for it.

    Args:
        basis: Of the stage.
        role: Whose shift was found.
        shift: x [-].
        mates: z_1 and z_2 of the mesh that it closes, negative for internal teeth [-].

    Raises:
        DesignError: With the centre distances that are reached.
    """
    if abs(shift) > WIDEST + _ROUNDED:
        message = f"it closes only with the shift {shift:.4g} of the {role}; {_reach(basis, mates)}"
        raise basis.refused("centre_distance", message)


def _out_of_reach(basis: Basis, teeth: tuple[int, int], total: float) -> str:
    return f"it asks x_1 + x_2 = {total:.4g} of {teeth[0]} and {abs(teeth[1])} teeth; {_reach(basis, teeth)}"


def _reach(basis: Basis, teeth: tuple[int, int]) -> str:
    """Return between which centre distances shifts close a mesh, and what else would do."""
    ends: list[float] = []
    for steps in range(-_STEPS, _STEPS + 1):
        with suppress(DesignError):
            ends.append(basis.centre_of(sum(teeth), 2.0 * WIDEST * steps / _STEPS))
    return (
        f"shifts up to ±{WIDEST:g} reach {min(ends):.4g} to {max(ends):.4g} modules: give a centre distance between"
        " them, another module, or other teeth"
    )


def divided(
    basis: Basis, teeth: tuple[int, int], total: float, centre: float | None, *,
    within: tuple[float, float] = (-WIDEST, WIDEST),
) -> float:  # fmt: skip
    """Return x_1 of a sum of shifts that balances two gears as the rules say, without undercut of either.

    Args:
        basis: Of the stage.
        teeth: z_1 and z_2, negative for internal teeth [-].
        total: x_1 + x_2 [-].
        centre: a_w/m_n [-]; None: the reference one.
        within: Between which x_1 keeps further gears, whose shifts follow from it, free of undercut [-].
    """
    limits = [
        max(least_profile_shift(number, ISO53_A.straight_dedendum, **basis.angles), -WIDEST) if number > 0 else -WIDEST
        for number in teeth
    ]
    least, most = max(limits[0], total - WIDEST), min(total - limits[1], WIDEST)
    if total > 2.0 * WIDEST or total < -2.0 * WIDEST:
        raise basis.refused("centre_distance", _out_of_reach(basis, teeth, total))
    if least > most:
        needed = sum(limits)
        message = (
            f"no shifts keep {teeth[0]} and {teeth[1]} teeth free of undercut on this centre distance: together they"
            f" need {needed:.3f} and it leaves {total:.3f}; give a larger centre distance, or more teeth"
        )
        raise basis.refused("centre_distance", message)
    least, most = max(least, within[0]), min(most, within[1])
    if least > most:
        message = (
            f"no shifts keep {teeth[0]} and {abs(teeth[1])} teeth and their other mates free of undercut and within"
            f" ±{WIDEST:g} on this centre distance; give another one, or other teeth"
        )
        raise basis.refused("centre_distance", message)
    by = basis.rules.balanced_shifts or DEFAULT_BALANCE

    def shape(first: float) -> MeshGeometry:
        shifts = (first, total - first)
        tips = shortening(basis, teeth, shifts, centre)
        return shifted_mesh(teeth, (ToothShift(shifts[0], tips), ToothShift(shifts[1], tips)), centre, **basis.angles)

    return balanced_shift(shape, least, most, by=by)


def altered(
    basis: Basis,
    stage: Pair | Planetary,
    roles: tuple[Role, ...],
    shifts: tuple[float, ...],
    teeth: tuple[int, int],
    centre: float | None,
) -> tuple[ToothShift, ...]:
    """Return the shifts with the tip alterations: given, or those that keep the tip clearance.

    Args:
        basis: Of the stage.
        stage: As read.
        roles: Of its gears.
        shifts: Of its gears [-].
        teeth: z_1 and z_2 of its external mesh, or of its internal pair [-].
        centre: a_w/m_n [-]; None: the reference one.
    """
    kept = shortening(basis, teeth, shifts[:2], centre)
    altered = []
    for role, shift in zip(roles, shifts, strict=True):
        given = getattr(stage, f"{role}_tip_alteration")
        usual = 0.0 if role is Role.RING else kept
        altered.append(ToothShift(shift, usual if given is None else given))
    return tuple(altered)


def shortening(basis: Basis, teeth: tuple[int, int], shifts: tuple[float, ...], centre: float | None) -> float:
    """Return the tip alteration of an external mesh [-]; internal ones keep their tips.

    Args:
        basis: Of the stage.
        teeth: z_1 and z_2, negative for internal teeth [-].
        shifts: x_1 and x_2 [-].
        centre: a_w/m_n [-]; None: the reference one.
    """
    if centre is None or min(teeth) < 0:
        return 0.0
    return tip_shortening(sum(teeth), centre, shifts[0] + shifts[1], helix_angle=basis.angles["helix_angle"])


# ----------------------------------------------------------------------------------------------------------------------
# Profile shifts that complete those given: of a pair, of a planetary set, of a bevel pair.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Teeth that cannot be: pointed below their tip, undercut by their shift, fouling inside a ring; and which can.
# ----------------------------------------------------------------------------------------------------------------------


_NEAREST = 60
"""Teeth that are tried one after the other to find some that can be [-]."""
_LARGEST_SHIFT = 2.0
"""Of the gears that are tried, either way [-]."""
_LEAST_TIP = -0.6
"""Least tip alteration that a design may give [-]."""
_SHORTEST = 0.5
"""Most that internal teeth are shortened by themselves [-]."""
_SHADE = 1e-6
"""By which they are shorter than they must be, for rounding [-]."""
_TOUCHING = 1e-9
"""Part of a module that is no room between tips and root [-]."""


class Keys(NamedTuple):
    """Where a design file speaks of the teeth of a gear."""

    shift: str
    """Path of its profile shift."""
    teeth: str
    """Path of its tooth number."""
    tip: str
    """Name of its tip alteration in its table."""
    module: float | None = None
    """Its module, where it is given [m]."""


def impossible_teeth(keys: Keys, gear: CylindricalGear) -> Iterator[Problem]:
    """Yield what is impossible of the teeth of an external gear, and the nearest that are possible.

    Args:
        keys: Where the file speaks of it.
        gear: In any module.
    """
    yield from _pointed(keys.shift, gear)
    yield from _undercut(keys.shift, gear)


def pointed_cones(
    path: str, teeth: tuple[int, int], shift: float, *, pressure_angle: float, spiral_angle: float
) -> Iterator[Problem]:
    """Yield which gear of a bevel pair on square axes its profile shift points, by its virtual teeth z/cos δ.

    Args:
        path: Of the stage.
        teeth: z_1 and z_2 [-].
        shift: x_hm1 = −x_hm2 [-].
        pressure_angle: α_n [rad].
        spiral_angle: β_m [rad].
    """
    rack, cone = BasicRack(pressure_angle=pressure_angle), math.hypot(*teeth)
    virtual = {"pinion": (teeth[0] * cone / teeth[1], shift), "wheel": (teeth[1] * cone / teeth[0], -shift)}
    for role, (teeth_of_cone, x) in virtual.items():
        gear = CylindricalGear(max(math.ceil(teeth_of_cone), 5), 1.0, 1.0, spiral_angle, x, rack)
        if tip_thickness(gear) <= 0.0:
            message = f"{x:.4g} points its teeth below their tips, {teeth_of_cone:.3g} virtual ones; {_instead(gear)}"
            yield Problem(f"{path}.{role}_shift", message)


def _pointed(key: str, gear: CylindricalGear) -> Iterator[Problem]:
    if tip_thickness(gear) > 0.0:
        return
    message = f"{gear.profile_shift:.4g} points {gear.teeth} teeth below the tip circle; {_instead(gear, _NEAREST)}"
    yield Problem(key, message)


def _instead(gear: CylindricalGear, more_teeth: int = 0) -> str:
    """Return which shift, or up to how many more teeth, leave a gear with tips."""
    less = (replace(gear, profile_shift=x) for x in _falling(gear.profile_shift))
    more = (replace(gear, teeth=gear.teeth + more) for more in range(1, more_teeth))
    words = [
        *(f"at most {one.profile_shift:.2f}" for one in _blunt(less)),
        *(f"{one.teeth} teeth" for one in _blunt(more)),
    ]
    return f"give {', or '.join(words)}" if words else "no shift from −2 to 2 leaves them tips: give more teeth"


def _blunt(gears: Iterable[CylindricalGear]) -> list[CylindricalGear]:
    """Return the first gear that has tips, if any."""
    return list(islice((gear for gear in gears if tip_thickness(gear) > 0.0), 1))


def _falling(shift: float) -> Iterator[float]:
    """Yield smaller and smaller shifts, in hundredths, down to the least of all [-]."""
    yield from takewhile(lambda less: less >= -_LARGEST_SHIFT, (round(shift - 0.01 * step, 2) for step in count(1)))


def _undercut(key: str, gear: CylindricalGear) -> Iterator[Problem]:
    """Find shifts towards the axis that undercut; teeth too few for no shift are judged by a check."""
    least = gear.undercut_shift
    if gear.profile_shift >= 0.0 or gear.profile_shift >= least - 1e-9:
        return
    able = (gear.teeth + more for more in range(1, _NEAREST))
    more = next((z for z in able if replace(gear, teeth=z).undercut_shift <= gear.profile_shift), None)
    or_teeth = f", or {more} teeth" if more is not None else ""
    message = f"{gear.profile_shift:.4g} undercuts {gear.teeth} teeth; give at least {least:.3f}{or_teeth}"
    yield Problem(key, message)


def fouling(keys: Keys, pair: GearPair) -> Iterator[Problem]:
    """Yield an internal mesh whose tips dig into involutes or into each other.

    Args:
        keys: Where the file speaks of its ring.
        pair: The gear inside and the ring, in any module.
    """
    inside, ring = pair.driver.teeth, -pair.driven.teeth
    if (room := involute_room(pair)).clearance < 0.0:
        module = pair.driven.module
        needed = pair.driven.tip_alteration + room.clearance / module
        shorter = f"{keys.tip} = {needed - 5e-4:.3f} or below, " if needed - 5e-4 >= _LEAST_TIP else ""
        message = (
            f"the tips of the {ring} internal teeth dig {-room.clearance / module:.3g} modules past the"
            f" involute of the {inside} inside; give {shorter}more shift to the gear inside{_able(pair)}"
        )
        yield Problem(keys.teeth, message)
    elif (tips := tip_room(pair)) is not None and tips.clearance < 0.0:
        message = (
            f"the tips of {inside} teeth foul those of the {ring} internal ones as they leave (trochoidal"
            f" interference); shorten the tips with {keys.tip}{_able(pair)}"
        )
        yield Problem(keys.teeth, message)


def in_the_root(keys: Mapping[str, Keys], meshes: Mapping[tuple[str, str], GearPair]) -> Iterator[Problem]:
    """Yield the gears whose tips run into the root of a mate.

    Args:
        keys: Gear -> where the file speaks of it.
        meshes: Gears that mesh -> they, in a module of one metre.
    """
    for gear, own in keys.items():
        rooms = [
            (tip_clearances(pair)[end], ends[1 - end], (pair.driver, pair.driven)[end].tip_alteration)
            for ends, pair in meshes.items() for end in (0, 1) if ends[end] == gear
        ]  # fmt: skip
        room, mate, tip = min(rooms, default=(math.inf, "", 0.0))
        if room <= _TOUCHING:
            most = (math.ceil(round(1e3 * (tip + room), 6)) - 1) / 1e3
            length = f" ({-1e3 * room * own.module:.3g} mm)" if own.module else ""
            message = (
                f"its tips run {max(-room, 0.0):.3g} modules{length} into the root of {mate}, with a tip alteration of"
                f" {tip:.4g}; give {own.tip} = {most:.3f} or below"
            )
            yield Problem(f"{own.teeth.rsplit('.', 1)[0]}.{own.tip}", message)


def off_the_involute(pair: GearPair) -> float:
    """Return the tip alteration with which a ring's tips are as short as the involute of the gear inside asks [-].

    Args:
        pair: The gear inside and the ring, in any module.
    """
    ring, clearance = pair.driven, involute_room(pair).clearance / pair.driven.module
    return ring.tip_alteration if clearance >= 0.0 else ring.tip_alteration + max(clearance, -_SHORTEST) - _SHADE


def _able(pair: GearPair) -> str:
    """Return the next larger ring that runs with the gear inside, at the centre distance that their shifts give."""
    for more in range(1, _NEAREST):
        try:
            larger = GearPair(pair.driver, replace(pair.driven, teeth=pair.driven.teeth - more))
            rooms: list[Room | None] = [involute_room(larger), tip_room(larger)]
        except DesignError:
            continue
        if all(room is None or room.clearance >= 0.0 for room in rooms):
            return f", or {-larger.driven.teeth} teeth"
    return ""


# ----------------------------------------------------------------------------------------------------------------------
# Profile shifts of a stage from what its design gives: shifts of its gears, a centre distance, or how to balance them.
#
# Two gears have two shifts and one centre distance, of which two are free; sun, planet and ring three shifts and one
# centre distance that both meshes share, of which two are free. What is given beyond that has to agree.
# ----------------------------------------------------------------------------------------------------------------------


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
