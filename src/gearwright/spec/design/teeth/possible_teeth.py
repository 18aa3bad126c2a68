"""Teeth that cannot be: pointed below their tip, undercut by their shift, fouling inside a ring; and which can."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

from gearwright.errors import DesignError, Problem
from gearwright.identity import Role
from gearwright.parts.gears import BasicRack, CylindricalGear, GearPair, Room, involute_room, tip_room, tip_thickness

_NEAREST = 60
"""Teeth that are tried one after the other to find some that can be [-]."""


def impossible_teeth(
    path: str, gears: Mapping[Role, CylindricalGear], centre: float | None, *, ring: Role | None
) -> Iterator[Problem]:
    """Yield what is impossible of the teeth of a stage, and the nearest that are possible.

    Args:
        path: Of the stage.
        gears: Of a module of one metre, as external gears.
        centre: Working centre distance over the module [-]; None: the reference one.
        ring: Which of them has its teeth inside, the last; None: all mesh outside.
    """
    outside = [role for role in gears if role is not ring]
    for role in outside:
        yield from _pointed(path, role, gears[role])
        yield from _undercut(path, role, gears[role])
    if ring is not None:
        yield from _fouling(path, ring, (gears[outside[-1]], gears[ring]), centre)


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
    for role, (count, x) in virtual.items():
        gear = CylindricalGear(max(math.ceil(count), 5), 1.0, 1.0, spiral_angle, x, rack)
        if tip_thickness(gear) <= 0.0:
            less = next(x for x in _falling(x) if tip_thickness(replace(gear, profile_shift=x)) > 0.0)
            message = f"{x:.4g} points its teeth below their tips, {count:.3g} virtual ones; give at most {less:.2f}"
            yield Problem(f"{path}.{role}_shift", message)


def _pointed(path: str, role: Role, gear: CylindricalGear) -> Iterator[Problem]:
    if tip_thickness(gear) > 0.0:
        return
    able = (replace(gear, teeth=gear.teeth + more) for more in range(1, _NEAREST))
    more = next((f", or {tooth.teeth} teeth" for tooth in able if tip_thickness(tooth) > 0.0), "")
    less = next(x for x in _falling(gear.profile_shift) if tip_thickness(replace(gear, profile_shift=x)) > 0.0)
    message = f"{gear.profile_shift:.4g} points {gear.teeth} teeth below the tip circle; give at most {less:.2f}{more}"
    yield Problem(f"{path}.{role}_shift", message)


def _falling(shift: float) -> Iterator[float]:
    """Yield smaller and smaller shifts, in hundredths [-]."""
    yield from (round(shift - 0.01 * step, 2) for step in range(1, 400))


def _undercut(path: str, role: Role, gear: CylindricalGear) -> Iterator[Problem]:
    """Find shifts towards the axis that undercut; teeth too few for no shift are judged by a check."""
    least = gear.undercut_shift
    if gear.profile_shift >= 0.0 or gear.profile_shift >= least - 1e-9:
        return
    able = (gear.teeth + more for more in range(1, _NEAREST))
    more = next((z for z in able if replace(gear, teeth=z).undercut_shift <= gear.profile_shift), None)
    or_teeth = f", or {more} teeth" if more is not None else ""
    message = f"{gear.profile_shift:.4g} undercuts {gear.teeth} teeth; give at least {least:.3f}{or_teeth}"
    yield Problem(f"{path}.{role}_shift", message)


def _fouling(
    path: str, ring: Role, gears: tuple[CylindricalGear, CylindricalGear], centre: float | None
) -> Iterator[Problem]:
    """Find internal meshes whose tips dig into involutes or into each other."""
    pinion, wheel = gears
    pair = GearPair(pinion, replace(wheel, teeth=-wheel.teeth), centre)
    if (room := involute_room(pair)).clearance < 0.0:
        needed = wheel.tip_alteration + room.clearance / wheel.module
        message = (
            f"the tips of the {wheel.teeth} internal teeth dig {-room.clearance / wheel.module:.3g} modules past the"
            f" involute of the {pinion.teeth} inside; give {ring}_tip_alteration = {needed - 5e-4:.3f} or below,"
            f" more shift to the gear inside{_able(pair)}"
        )
        yield Problem(f"{path}.{ring}_teeth", message)
    elif (tips := tip_room(pair)) is not None and tips.clearance < 0.0:
        message = (
            f"the tips of {pinion.teeth} teeth foul those of the {wheel.teeth} internal ones as they leave (trochoidal"
            f" interference); shorten the tips with {ring}_tip_alteration{_able(pair)}"
        )
        yield Problem(f"{path}.{ring}_teeth", message)


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
