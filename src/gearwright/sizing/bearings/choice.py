"""Bearings of one shaft: what each bears over its service, which sizes of the catalogue do, and which one is taken."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import (
    Bearing,
    BearingCheck,
    BearingSpectrum,
    bearing,
    bearings,
    check_bearing,
    equivalent_loads,
    least_ratings,
    with_ratings,
)
from gearwright.errors import DesignError, Problem
from gearwright.parts.bearings import LoadFactors, speed_factor, taper_factors
from gearwright.sizing.arrangement import axial_forces
from gearwright.sizing.bearings.duty import duty_of
from gearwright.sizing.bearings.run_checks import highest_speed_factor
from gearwright.sizing.bearings.running import oiled_life, running_of
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.mounted import BearingSizing
from gearwright.sizing.rating import Context
from gearwright.spec import Design
from gearwright.spec.checks import APART, KINDS
from gearwright.spec.design import BearingSeat
from gearwright.units import apart

TYPICAL_TAPER = LoadFactors(0.4, 0.4, 1.5)
"""e, X, Y of taper bearings before one is chosen: α = 15° [-]."""
MAKER = "maker's rating, given by the user"


class Tried(NamedTuple):
    """What is known of the sizes of a bearing under one duty."""

    checks: dict[str, BearingCheck]
    """Size -> how it bears the duty, as far as that was asked."""
    weak: set[str]
    """Sizes that do not."""


Checked = dict[tuple[str, BearingSpectrum], Tried]
"""Bearing of a shaft and its duty -> what is known of its sizes."""


@dataclass(frozen=True)
class Seating:
    """The bearings of one shaft under one set of thrusts."""

    seats: Mapping[str, BearingSeat]
    """In order along the shaft."""
    radial: Mapping[str, Floats]
    """Bearing -> radial force of every case [N]."""
    axial: Mapping[str, Floats]
    """Bearing -> axial force of every case, induced thrust included [N]."""
    duties: Mapping[str, BearingSpectrum]
    """Bearing -> what it bears."""
    sizes: Mapping[str, tuple[Bearing, ...]]
    """Bearing -> the sizes that may be taken, in order of preference."""
    design: Design
    """With its oil, and the life that it asks."""
    tried: Mapping[str, Tried]
    """Bearing -> what is known of its sizes, also from other seatings of the shaft with the same duty."""

    def check(self, name: str, size: Bearing) -> BearingCheck:
        """Return how a size bears the duty of a bearing.

        Args:
            name: Of the bearing.
            size: From the catalogue.
        """
        checks = self.tried[name].checks
        if size.designation not in checks:
            plain = check_bearing(size, self.duties[name])
            modified = self.design.bearing_rules.life == "modified"
            checks[size.designation] = self._oiled(name, plain) if modified else plain
        return checks[size.designation]

    def _does(self, name: str, size: Bearing) -> bool:
        """Return whether a size bears its duty, and keep it where it does not."""
        bears = _bears(self.check(name, size))
        if not bears:
            self.tried[name].weak.add(size.designation)
        return bears

    def _too_fast(self, name: str, size: Bearing) -> bool:
        fastest = max(abs(speed) for speed in self.duties[name].speed)
        reached = speed_factor(fastest, size.bore, size.outer_diameter)
        return reached > highest_speed_factor(size.kind, self.design)

    def _oiled(self, name: str, plain: BearingCheck) -> BearingCheck:
        """Return a check by the modified life, where there is one."""
        duty = self.duties[name]
        oiled = oiled_life(self.design, plain.bearing, duty, path=f"bearings.{name}")
        return plain if oiled is None else replace(plain, life=oiled.life, life_margin=oiled.life / duty.life)

    def choose(self, name: str, smallest: float, largest: float) -> Bearing:
        """Return the first size that bears its duty around a shaft, or the one that the user gives.

        One that does not turn too fast comes before all that do.

        Args:
            name: Of the bearing.
            smallest: Smallest bore [m].
            largest: Largest bore [m].

        Raises:
            DesignError: If there is none, with the nearest.
        """
        seat, sizes = self.seats[name], self.sizes[name]
        if seat.designation is not None:
            return sizes[0]
        if seat.bore is not None:
            smallest = largest = sizes[0].bore
        low, high, weak = smallest - 1e-9, largest + 1e-9, self.tried[name].weak
        around = [size for size in sizes if low <= size.bore <= high and size.designation not in weak]
        too_fast = list[Bearing]()
        for size in around:
            if self._too_fast(name, size):
                too_fast.append(size)
            elif self._does(name, size):
                return size
        for size in too_fast:
            if self._does(name, size):
                return size
        room = [size for size in sizes if low <= size.bore <= high]
        checks = [self.check(name, size) for size in room or sizes]
        raise DesignError([Problem(f"bearings.{name}", _none(self.duties[name], seat, (smallest, largest), checks))])


def seating(
    context: Context, shaft: str, forces: ShaftForces, chosen: Mapping[str, Bearing], *, slim: bool, known: Checked
) -> Seating:
    """Return what the bearings of a shaft bear, and the sizes that may be taken.

    Args:
        context: What sizing reads.
        shaft: Name of the shaft.
        forces: What acts on it.
        chosen: Bearing -> the size taken last; the thrust of taper bearings follows from it.
        slim: Prefer small bores to light bearings.
        known: What other seatings of the shaft have tried.

    Raises:
        DesignError: If nothing takes a force along the shaft, or the catalogue has no such bore.
    """
    seats = forces.plan.seats
    reactions = forces.largest_radial()
    carried = iter(reactions.T)
    radial = {name: next(carried) if seat.radial else np.zeros(len(reactions)) for name, seat in seats.items()}
    factors = {
        name: taper_factors(chosen[name].geometry.contact_angle) if name in chosen else TYPICAL_TAPER
        for name, seat in seats.items()
        if seat.kind == "taper"
    }
    axial = axial_forces(shaft, seats, forces.axial, radial=radial, factors=factors, cases=tuple(context.flows))
    speeds = [flow.speeds[shaft] for flow in context.flows.values()]
    duties = {name: duty_of(context, radial[name], axial[name], speeds, life=seat.life) for name, seat in seats.items()}
    sizes = {name: _sizes(name, seat, slim=slim) for name, seat in seats.items()}
    plain = context.design.bearing_rules.life != "modified"
    for name, duty in duties.items():
        if (name, duty) not in known:
            known[name, duty] = Tried({}, _too_weak(sizes[name], duty, by_life=plain))
    tried = {name: known[name, duty] for name, duty in duties.items()}
    return Seating(seats, radial, axial, duties, sizes, context.design, tried)


def _too_weak(sizes: Sequence[Bearing], duty: BearingSpectrum, *, by_life: bool) -> set[str]:
    """Return the sizes of which ratings alone say that they do not bear a duty."""
    dynamic, static = least_ratings(sizes[0].kind, duty)
    return {
        size.designation for size in sizes if size.static_rating < static or (by_life and size.dynamic_rating < dynamic)
    }


def _sizes(name: str, seat: BearingSeat, *, slim: bool) -> tuple[Bearing, ...]:
    if seat.designation is not None:
        return (_as_made(seat, bearing(seat.designation)),)
    outer = math.inf if seat.largest_outer_diameter is None else seat.largest_outer_diameter
    fitting = [
        size
        for size in _in_order(KINDS[seat.kind], slim=slim)
        if size.outer_diameter <= outer + 1e-9 and (seat.bore is None or abs(size.bore - seat.bore) < APART)
    ]
    if not fitting:
        message = f"no {KINDS[seat.kind]} bearing has at most {1e3 * outer:.4g} mm outside; give it more room"
        raise DesignError([Problem(f"bearings.{name}.largest_outer_diameter", message)])
    return tuple(fitting)


@cache
def _in_order(kind: str, *, slim: bool) -> tuple[Bearing, ...]:
    """Return the sizes of a kind in the catalogue, small bores or light ones first."""
    sizes = (size for size in bearings().values() if size.kind == kind)
    return tuple(sorted(sizes, key=lambda size: (size.bore, size.mass) if slim else (size.mass, size.bore)))


def _as_made(seat: BearingSeat, standard: Bearing) -> Bearing:
    """Return a bearing with the maker's ratings where the user gives them."""
    if seat.dynamic_rating is None and seat.static_rating is None:
        return standard
    dynamic, static = seat.dynamic_rating or standard.dynamic_rating, seat.static_rating or standard.static_rating
    return with_ratings(standard, dynamic, static, source=MAKER)


def _bears(check: BearingCheck) -> bool:
    return check.life_margin >= 1.0 and check.static_margin >= 1.0


def _none(duty: BearingSpectrum, seat: BearingSeat, room: tuple[float, float], checks: list[BearingCheck]) -> str:
    """Say why no size will do, and which is nearest."""
    smallest, largest = room
    around = f"bores from {1e3 * smallest:.4g} mm" + (
        f" to {1e3 * largest:.4g} mm, the root of the gear," if largest < math.inf else ""
    )
    if smallest == largest:
        around = f"a bore of {1e3 * smallest:.4g} mm"
    best = max(checks, key=lambda check: min(check.life_margin, check.static_margin))
    outer = seat.largest_outer_diameter
    inside = f" and {1e3 * outer:.4g} mm outside" if outer else ""
    asked, lives = apart(duty.life, best.life, "life")
    wanted, has = apart(duty.static_safety, best.static_safety, "ratio", 3)
    return (
        f"no {KINDS[seat.kind]} bearing with {around}{inside} lives {asked} with s_0 = {wanted} under"
        f" {max(duty.radial):.4g} N across and {max(duty.axial):.4g} N along; the nearest,"
        f" {best.bearing.designation} ({1e3 * best.bearing.bore:g} mm), gives {lives} and s_0 = {has}; take another"
        " kind, give more room, move the bearings apart, or ask for less life"
    )


def bearing_sizings(
    seated: Seating, chosen: Mapping[str, Bearing], shaft: str, cases: tuple[str, ...]
) -> tuple[BearingSizing, ...]:
    """Return the bearings of a shaft as they were taken.

    Args:
        seated: What they bear.
        chosen: Bearing -> the size taken.
        shaft: Name of the shaft.
        cases: Names of the load cases.
    """
    return tuple(_sizing(name, seated, chosen[name], shaft, cases) for name in seated.seats)


def _sizing(name: str, seated: Seating, taken: Bearing, shaft: str, cases: tuple[str, ...]) -> BearingSizing:
    duty, check = seated.duties[name], seated.check(name, taken)
    statics = [equivalent_loads(taken, *loads)[1] for loads in zip(duty.radial, duty.axial, strict=True)]
    worst = int(np.argmax(statics))
    oiled = oiled_life(seated.design, taken, duty, path=f"bearings.{name}")
    return BearingSizing(
        name=name,
        shaft=shaft,
        position=seated.seats[name].position,
        bearing=taken,
        case=cases[worst],
        radial=duty.radial[worst],
        axial=duty.axial[worst],
        equivalent_load=check.equivalent_load,
        life=check_bearing(taken, duty).life,
        wanted_life=duty.life,
        static_safety=check.static_safety,
        wanted_static_safety=duty.static_safety,
        judged_life=check.life,
        modified_life=oiled.life if oiled else None,
        life_factor=oiled.factor if oiled else None,
        viscosity_ratio=oiled.viscosity_ratio if oiled else None,
        contamination=oiled.contamination if oiled else None,
        **running_of(taken, duty)._asdict(),
    )
