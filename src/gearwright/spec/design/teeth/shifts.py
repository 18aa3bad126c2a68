"""What the profile shifts of a stage are found from and how they are divided, balanced and held against each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.identity import Role
from gearwright.parts.gears import (
    ISO53_A,
    UNSHIFTED,
    ToothShift,
    least_profile_shift,
    shifts_at,
    tip_shortening,
    working_centre,
)
from gearwright.parts.iso6336 import MeshGeometry, balanced_shift, shifted_mesh
from gearwright.spec.design.rules import GearRules
from gearwright.spec.design.stages import Pair, Planetary

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
