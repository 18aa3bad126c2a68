"""What a flight does to the rolling bearings: life by ISO 281 over their spectrum of loads, and which ones to take."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from gearwright.catalogue.bearing_choice import BearingDuty, check_bearing
from gearwright.catalogue.bearings import Bearing, bearing, bearings, with_ratings
from gearwright.errors import DesignError, Problem
from gearwright.mission.flight import Flight
from gearwright.parts.bearing_life import MILLION, life_exponent, reliability_factor
from gearwright.parts.bearing_load import mean_load
from gearwright.parts.rolling_bearing import BearingKind
from gearwright.sizing.bearing_seats import Seat, bearing_seats, seat_loads
from gearwright.spec import GROUND
from gearwright.spec.mission import BearingLifeRules
from gearwright.units import Force, Mass, Ratio, Speed

Array = NDArray[np.float64]
FATIGUE = "rolling fatigue"
"""How bearings fail here."""
USUAL_RELIABILITY = 0.9
"""Of a basic rating life [-]; ISO 281."""
_LEAST_LOAD = 1.0
"""Radial force below which a bearing has nothing to bear but rounding and weight [N]."""
_SHORT = 0.05
"""Part of the asked life that may be missing: bearings are chosen by the mean of their loads [-]."""
_KINDS = {
    "deep-groove": BearingKind.DEEP_GROOVE,
    "cylindrical": BearingKind.CYLINDRICAL,
    "taper": BearingKind.TAPER,
    "four-point": BearingKind.FOUR_POINT,
}
_ROUNDING = 1e-9
"""Axial over the largest radial force below which opposite helices cancel [-]."""


class SeatDuty(NamedTuple):
    """What one seat bears over a flight; every array has one value per interval."""

    radial: Array
    """[N]"""
    axial: Array
    """[N]"""
    speed: Array
    """Of one ring against the other, without sign [rad/s]."""
    turns: Array
    """[-]"""


@dataclass(frozen=True)
class BearingDamage:
    """The bearing of one seat, or of several equal ones."""

    seat: str
    """Such as ``left.first`` or ``second.planet``."""
    bearing: Bearing
    """Which one."""
    count: int
    """Equal seats times bearings side by side [-]."""
    mean_load: Force
    """Equivalent load that tires it as the spectrum does, of one seat [N]."""
    mean_speed: Speed
    """Turns over the time of the flight [rad/s]."""
    static_safety: Ratio
    """C_0 over the largest load [-]."""
    damage: Ratio
    """Miner's sum of one flight at the asked reliability [-]."""
    hours: float
    """Of the flight [h]."""
    asked: float | None
    """Flight hours for which it was chosen; None where the design names it [h]."""

    @property
    def falls_short(self) -> bool:
        """True where no bearing that fits reaches the asked life, and this one comes nearest."""
        return self.asked is not None and self.life < self.asked * (1.0 - _SHORT)

    @property
    def flights(self) -> float:
        """Flights until the sum is 1; ∞ where nothing is loaded [-]."""
        return 1.0 / self.damage if self.damage > 0.0 else math.inf

    @property
    def life(self) -> float:
        """Flight hours until then [h]."""
        return self.flights * self.hours

    @property
    def mass(self) -> Mass:
        """Of all of them [kg]."""
        return self.count * self.bearing.mass


@dataclass(frozen=True)
class BearingLives:
    """The bearings of a gearbox over a flight."""

    rows: tuple[BearingDamage, ...]
    """The worst first."""
    notes: tuple[str, ...]
    """Seats without a bearing, and why."""

    @property
    def mass(self) -> Mass:
        """Of all known bearings [kg]."""
        return sum(row.mass for row in self.rows)


def bearing_lives(flight: Flight) -> BearingLives:
    """Return the life of every bearing that the design names or the mission asks for, over the flight's spectrum.

    Args:
        flight: As flown; its mission may ask for bearings, its design may name or seat them.

    Source: ISO 281:2007, 5.3 and 7.3, with the equivalent load of every interval and Palmgren's linear damage; equal
        bearings side by side bear i^0.7 (balls) or i^(7/9) (rollers) times the rating of one, 5.1.2 and 7.1.2.

    Raises:
        DesignError: A named bearing that does not fit its seat, or cannot bear its kind of load.
    """
    rows, notes, problems = [], [], []
    idle, opened = [], []
    for seat in bearing_seats(flight.sizing):
        named = _named(flight, seat)
        if seat_duty(flight, seat).radial.max() < _LEAST_LOAD:
            idle.append(seat.name)
        elif named is None and flight.mission.bearings is None:
            opened.append(seat.name)
        else:
            try:
                rows.append(_known(flight, seat, named))
            except DesignError as error:
                problems += [Problem(_path(seat), each.message) for each in error.problems if named]
                notes += [f"{seat.name}: {each.message}" for each in error.problems if not named]
    if problems:
        raise DesignError(problems)
    notes += [
        f"{row.seat}: no bearing that fits reaches the asked life; {row.bearing.designation} comes nearest"
        for row in rows
        if row.falls_short
    ]
    notes += [f"{', '.join(idle)}: nothing to rate, as the forces of the meshes cancel"] if idle else []
    notes += (
        [f"{', '.join(opened)}: no bearing is named, and the mission has no [bearings] to choose one"] if opened else []
    )
    return BearingLives(tuple(sorted(rows, key=lambda row: -row.damage)), tuple(notes))


def _path(seat: Seat) -> str:
    """Return where the design says what sits there."""
    return f"bearings.{seat.name}" if seat.given else f"planetaries.{seat.name.removesuffix('.planet')}.planet_bearing"


class _Named(NamedTuple):
    """A bearing that the design gives."""

    bearing: Bearing
    side_by_side: int


def _named(flight: Flight, seat: Seat) -> _Named | None:
    """Return the bearing that the design names on a seat, or that its sizing took; None where it is open."""
    design, given = flight.sizing.design, seat.given
    if given is not None:
        sized = next((each.bearing for each in flight.sizing.bearings if each.name == seat.name), None)
        if sized is None and given.designation is not None:
            sized = _rated(bearing(given.designation), given.dynamic_rating, given.static_rating)
        return None if sized is None else _Named(sized, 1)
    stage, _, last = seat.name.rpartition(".")
    own = design.planetaries[stage].planet_bearing if last == "planet" and stage in design.planetaries else None
    if own is None:
        return None
    return _Named(_rated(bearing(own.designation), own.dynamic_rating, own.static_rating), own.side_by_side)


def _rated(found: Bearing, dynamic: float | None, static: float | None) -> Bearing:
    """Return a bearing with its maker's ratings, where both are given."""
    if dynamic is None or static is None:
        return found
    return with_ratings(found, dynamic, static, source="maker's ratings, given by the user")


def _known(flight: Flight, seat: Seat, named: _Named | None) -> BearingDamage:
    rules = flight.mission.bearings
    if named is None:
        return _chosen(flight, seat, cast(BearingLifeRules, rules))
    found = named.bearing
    if not _fits(found, seat):
        message = (
            f"{found.designation} has a bore of {1e3 * found.bore:g} mm and an outside of"
            f" {1e3 * found.outer_diameter:g} mm; allowed: {1e3 * seat.bore:.4g} mm or more, and"
            f" {1e3 * seat.room:.4g} mm or less; take another size"
        )
        raise DesignError([Problem("designation", message)])
    reliability = rules.reliability if rules else USUAL_RELIABILITY
    return _lived(flight, seat, found, (named.side_by_side, reliability), asked=None)


def seat_duty(flight: Flight, seat: Seat) -> SeatDuty:
    """Return what a seat bears in every interval of a flight.

    Args:
        flight: As flown.
        seat: Of its gearbox.
    """
    speeds = {**flight.speeds, GROUND: np.zeros(len(flight.phase))}
    torques = np.stack([flight.mesh_torques[mesh.name] for mesh in flight.sizing.train.meshes], axis=-1)
    radial, axial = seat_loads(seat, torques, speeds[seat.carrier])
    axial = np.where(axial > _ROUNDING * radial.max(), axial, 0.0)
    speed = np.abs(speeds[seat.nodes[0]] - speeds[seat.nodes[1]])
    return SeatDuty(radial, axial, speed, speed * flight.history["duration"] / (2.0 * math.pi))


def _chosen(flight: Flight, seat: Seat, rules: BearingLifeRules) -> BearingDamage:
    """Take the lightest bearing whose life is met by the mean of the loads, at the mean speed."""
    duty = seat_duty(flight, seat)
    usual = rules.thrust_kind if duty.axial.any() else rules.kind
    kind = _KINDS[seat.given.kind if seat.given else usual]
    share, exponent = _pair_factor(kind, rules.side_by_side), life_exponent(kind)
    radial, axial = (mean_load(each.tolist(), duty.turns.tolist(), exponent) / share for each in duty[:2])
    asked = BearingDuty(
        radial=radial,
        axial=axial,
        speed=2.0 * math.pi * float(duty.turns.sum()) / flight.duration,
        life=rules.life / reliability_factor(rules.reliability),
        static_safety=rules.static_safety,
        limit_factor=float(np.hypot(duty.radial, duty.axial).max()) / share / math.hypot(radial, axial),
    )
    fitting = [each for each in bearings().values() if each.kind is kind and _fits(each, seat)]
    if not fitting:
        room = "" if math.isinf(seat.room) else f" and no more than {1e3 * seat.room:.4g} mm outside"
        message = f"the catalogue has no {kind} bearing with a bore of {1e3 * seat.bore:.4g} mm or more{room}"
        raise DesignError([Problem("bore", f"{message}; take another kind")])
    checks = [check_bearing(each, asked) for each in sorted(fitting, key=lambda each: each.mass)]
    able = (each for each in checks if min(each.life_margin, each.static_margin) >= 1.0)
    found = next(able, max(checks, key=lambda each: min(each.life_margin, each.static_margin))).bearing
    return _lived(flight, seat, found, (rules.side_by_side, rules.reliability), asked=rules.life)


def _fits(found: Bearing, seat: Seat) -> bool:
    """A seat that the design gives may be thinner than its shaft elsewhere."""
    return (seat.given is not None or found.bore >= seat.bore - 1e-9) and found.outer_diameter <= seat.room + 1e-9


def _lived(
    flight: Flight, seat: Seat, found: Bearing, rules: tuple[int, float], *, asked: float | None
) -> BearingDamage:
    """Return the damage of a bearing, for bearings side by side and a reliability."""
    (several, reliability), duty = rules, seat_duty(flight, seat)
    pairs = zip(duty.radial.tolist(), duty.axial.tolist(), strict=True)
    loads, statics = np.array([_equivalent(found, radial, axial) for radial, axial in pairs]).T
    exponent, rating = life_exponent(found.kind), _pair_factor(found.kind, several) * found.dynamic_rating
    damage = float((loads / rating) ** exponent @ (duty.turns / MILLION)) / reliability_factor(reliability)
    return BearingDamage(
        seat=seat.name,
        bearing=found,
        count=seat.count * several,
        mean_load=mean_load(loads.tolist(), duty.turns.tolist(), exponent),
        mean_speed=2.0 * math.pi * float(duty.turns.sum()) / flight.duration,
        static_safety=several * found.static_rating / float(statics.max()),
        damage=damage,
        hours=flight.duration / 3600.0,
        asked=None if asked is None else asked / 3600.0,
    )


def _equivalent(found: Bearing, radial: float, axial: float) -> tuple[float, float]:
    """Return dynamic and static equivalent load, P and P_0 [N]."""
    if not (radial or axial):
        return 0.0, 0.0
    check = check_bearing(found, BearingDuty(radial, axial, speed=1.0, life=1.0))
    return check.equivalent_load, found.static_rating / check.static_safety


def _pair_factor(kind: BearingKind, side_by_side: int) -> float:
    """Rating of equal bearings side by side over that of one [-]."""
    return math.pow(side_by_side, 0.7 if kind.is_ball else 7.0 / 9.0)
