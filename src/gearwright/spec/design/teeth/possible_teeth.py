"""Teeth that cannot be: pointed below their tip, undercut by their shift, fouling inside a ring; and which can."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import count, islice, takewhile
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.parts.gears import (
    BasicRack,
    CylindricalGear,
    GearPair,
    Room,
    involute_room,
    tip_clearances,
    tip_room,
    tip_thickness,
)

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
