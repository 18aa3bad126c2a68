"""Bearing life over a flight by ISO 281: loads, speeds, oil, and selection of bearings."""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple, cast

import numpy as np

from gearwright.base import (
    DesignError,
    Floats,
    Force,
    Mass,
    Problem,
    Ratio,
    Speed,
    largest,
    largest_first,
    place_of_largest,
    refuse,
    smallest,
    text,
    verb,
)
from gearwright.catalogue import (
    Bearing,
    BearingDuty,
    BearingSpectrum,
    ModifiedLife,
    bore_around,
    check_bearing,
    fitting_bearings,
)
from gearwright.mission.flight import Flight
from gearwright.mission.gearbox import flown_airscrew
from gearwright.parts.bearings import (
    BearingKind,
    LoadFactors,
    life_exponent,
    mean_load,
    pair_factor,
    reliability_factor,
    speed_factor,
    taper_factors,
)
from gearwright.parts.losses import oil_viscosity
from gearwright.sizing import Sizing
from gearwright.sizing.airscrew_loads import usual_thrust
from gearwright.sizing.arrangement import axial_forces
from gearwright.sizing.bearing_seats import Seat, bearing_seats, seat_forces
from gearwright.sizing.bearings import SeatedBearing, fitted_in, highest_speed_factor, oiled_life
from gearwright.spec import BearingLifeRules
from gearwright.spec.checks import KINDS

# ----------------------------------------------------------------------------------------------------------------------
# What a flight lays on each bearing: force across and along, speed and the oil in it, interval by interval.
# ----------------------------------------------------------------------------------------------------------------------


_ROUNDING = 1e-9
"""Axial over the largest radial force below which opposite helices cancel [-]."""


class SeatDuty(NamedTuple):
    """What one seat bears over a flight; every array has one value per interval."""

    radial: Floats
    """[N]"""
    axial: Floats
    """[N]"""
    speed: Floats
    """Of one ring against the other, without sign [rad/s]."""
    time: Floats
    """Duration [s]."""
    viscosity: Floats | None = None
    """ν of the oil in it, where the flight follows its temperature [m²/s]."""
    missing: str = ""
    """Why its axial force is not known; empty where it is."""

    @property
    def turns(self) -> Floats:
        """Revolutions of each interval [-]."""
        return self.speed * self.time / (2.0 * math.pi)


class ThrustNote(NamedTuple):
    """What becomes of the thrust on a shaft whose bearings the design does not describe."""

    words: str
    """Which shaft, how much, what is missing."""
    taken: bool
    """Whether one of two usual bearings is taken to bear it."""


def seat_duties(flight: Flight) -> tuple[tuple[Seat, SeatDuty], ...]:
    """Return every seat with what it bears in every interval of a flight.

    The meshes' forces along a shaft and a propeller's thrust go to the bearings that locate the shaft, as in sizing; on
    a shaft without bearings in the design, to that of its two usual ones that bears less across. Bearings inside
    planets bear none of it.

    Args:
        flight: As flown.
    """
    seats = {seat.name: seat for seat in bearing_seats(flight.sizing)}
    torques = np.stack([flight.meshes[mesh.name].torque for mesh in flight.sizing.train.meshes], axis=-1)
    forces = {name: seat_forces(seat, torques, flight.speed(seat.carrier)) for name, seat in seats.items()}
    axial = {name: np.zeros_like(radial) for name, (radial, _) in forces.items()}
    missing: dict[str, str] = {}
    for shaft, on_shaft in held_shafts(seats).items():
        try:
            axial |= _located(flight, shaft, on_shaft, forces)
        except DesignError as error:  # a flight's thrust that sizing did not know
            missing |= dict.fromkeys(on_shaft, "; ".join(problem.message for problem in error.problems))
    duties, warmth = [], _thickness(flight)
    for name, seat in seats.items():
        speed = np.abs(flight.speed(seat.nodes[0]) - flight.speed(seat.nodes[1]))
        duty = SeatDuty(
            forces[name][0], axial[name], speed, flight.history.duration, warmth, missing.get(name, "")
        )  # fmt: skip
        duties.append((seat, duty))
    return tuple(duties)


def thrust_notes(flight: Flight) -> Iterator[ThrustNote]:
    """Yield where the thrust of a propeller or rotor goes to no bearing that the design describes, and what to write.

    Args:
        flight: As flown.
    """
    held = held_shafts({seat.name: seat for seat in bearing_seats(flight.sizing)})
    for shaft in dict.fromkeys(screw.shaft for screw in flight.sizing.design.airscrews.values()):
        thrust, seats = float(np.abs(thrust_on(flight, shaft)).max()), held.get(shaft, {})
        if not thrust or any(seat.given is not None for seat in seats.values()):
            continue
        usual = f"that of {' and '.join(seats)} which bears less across is taken to bear it"
        yield ThrustNote(
            f"{shaft}: up to {text(thrust, 'force')} of thrust, and the design describes no bearing of it;"
            f" {usual if seats else 'where it goes is not assessed'}; describe them in [bearings.NAME] with"
            f' shaft = "{shaft}", one of them with locates = "both"',
            bool(seats),
        )


def held_shafts(seats: Mapping[str, Seat]) -> dict[str, dict[str, Seat]]:
    """Return shaft -> the seats that hold it in the housing, by their names.

    Args:
        seats: By their names.
    """
    held: dict[str, dict[str, Seat]] = {}
    for name, seat in seats.items():
        if seat.holds_shaft:
            held.setdefault(seat.nodes[0], {})[name] = seat
    return held


def _thickness(flight: Flight) -> Floats | None:
    """Return ν of the oil as warm as bearings run, per interval [m²/s]; None where a flight does not follow them."""
    warm, oil = flight.history.bearings_temperature, flight.sizing.design.oil
    if warm is None:
        return None
    grade = (oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6)
    return np.array([oil_viscosity(temperature, grade) for temperature in warm.tolist()])


def _located(
    flight: Flight, shaft: str, seats: Mapping[str, Seat], forces: Mapping[str, tuple[Floats, Floats]]
) -> dict[str, Floats]:
    """Return the axial force in every bearing of one shaft, without sign."""
    return located(flight.sizing, shaft, seats, forces, thrust=thrust_on(flight, shaft), cases=flight.phase)


def located(
    sizing: Sizing, shaft: str, seats: Mapping[str, Seat], forces: Mapping[str, tuple[Floats, Floats]],
    *, thrust: Floats, cases: tuple[str, ...],
) -> dict[str, Floats]:  # fmt: skip
    """Return the axial force in every bearing of one shaft under many loads, without sign [N].

    Args:
        sizing: As sized.
        shaft: Its name.
        seats: That hold it, by their names.
        forces: Seat -> radial force on it, and the meshes' force along its shaft, shape (n,) [N].
        thrust: Of a propeller or rotor on it, shape (n,) [N].
        cases: What each load is called.

    Raises:
        DesignError: If nothing takes a force along the shaft.
    """
    radial = {name: forces[name][0] for name in seats}
    first = next(iter(seats))
    along = forces[first][1] + seats[first].rotor_side * thrust
    along = np.where(np.abs(along) > _ROUNDING * max(float(force.max()) for force in radial.values()), along, 0.0)
    located_by_design = {name: seat.given for name, seat in seats.items() if seat.given is not None}
    if located_by_design:
        return axial_forces(
            shaft,
            located_by_design,
            along,
            radial=radial,
            factors=_taper_factors(sizing, located_by_design),
            cases=cases,
        )
    lightest_loaded = smallest(radial, lambda name: float(radial[name].mean()))
    return {name: np.abs(along) if name == lightest_loaded else np.zeros_like(along) for name in seats}


def thrust_on(flight: Flight, shaft: str) -> Floats:
    """Return the thrust on a shaft, of what flies by the map where there is one, else as the design says [N].

    Args:
        flight: As flown.
        shaft: Its name.
    """
    screws = {name: screw for name, screw in flight.sizing.design.airscrews.items() if screw.shaft == shaft}
    if flight.history.thrust is not None and flown_airscrew(flight.sizing) in screws:
        return flight.history.thrust
    in_bearings = bool(flight.sizing.arrangement.plans[shaft].seats)
    thrust = usual_thrust(flight.sizing.design, flight.sizing.flows, shaft, in_bearings=in_bearings)
    return np.full(len(flight.phase), thrust)


def _taper_factors(sizing: Sizing, names: Iterable[str]) -> dict[str, LoadFactors]:
    sized = (seat for seat in sizing.bearings if seat.name in names)
    geometries = {seat.name: seat.bearing.geometry for seat in sized}
    return {
        name: taper_factors(inside.contact_angle)
        for name, inside in geometries.items()
        if inside.kind is BearingKind.TAPER
    }


# ----------------------------------------------------------------------------------------------------------------------
# What a flight does to the rolling bearings: life by ISO 281 over their spectrum of loads, and which ones to take.
# ----------------------------------------------------------------------------------------------------------------------


THICKER = "its bore is the shaft's; what helps: a thicker shaft there, another kind of bearing, or more side by side"
"""Where no bearing around a shaft does."""
FATIGUE = "rolling fatigue"
"""How bearings fail here."""
USUAL_RELIABILITY = 0.9
"""Of a basic rating life [-]; ISO 281."""
_LEAST_LOAD = 1.0
"""Force below which a bearing has nothing to bear but rounding and weight [N]."""
_NEAR = 0.8
"""Margin under the mean of the loads from which on a bearing may do under their spectrum [-]."""


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
    asked_static_safety: Ratio | None = None
    """Static safety for which it was chosen; None where the design names it [-]."""
    life_factor: Ratio | None = None
    """a_1 a_ISO over the flight, where the design asks for the modified life [-]."""
    speed_factor: float = 0.0
    """n d_m at the highest speed [mm/min]."""
    holds_shaft: bool = True
    """Whether it holds its shaft in the housing, or sits inside a planet."""

    @property
    def falls_short(self) -> bool:
        """True where no bearing that fits reaches what is asked, and this one comes nearest."""
        return self.life < (self.asked or 0.0) or self.static_safety < (self.asked_static_safety or 0.0)

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
    unrated: tuple[str, ...] = ()
    """Seats that bear a load and have no bearing."""
    loose: tuple[str, ...] = ()
    """Thrusts that go to no bearing, and what is missing."""

    @property
    def mass(self) -> Mass:
        """Of all known bearings [kg]."""
        return sum(row.mass for row in self.rows)


@verb
def bearing_lives(flight: Flight, *, chosen: Mapping[str, Bearing] | None = None) -> BearingLives:
    """Return the life of every bearing that the design gives or the mission asks for, over the flight's spectrum.

    Args:
        flight: As flown; its mission may ask for bearings, its design may seat them or name those of planets.
        chosen: Seat -> bearing that is taken where the mission asks for one, as other missions need it, too.

    Source: ISO 281:2007, 5.3 and 7.3, with the equivalent load of every interval and Palmgren's linear damage; equal
        bearings side by side bear i^0.7 (balls) or i^(7/9) (rollers) times the rating of one, 5.1.2 and 7.1.2.

    Raises:
        DesignError: A named bearing that does not fit its seat, or cannot bear its kind of load.
    """
    rows, notes, problems = [], [], []
    idle, opened, failed, films = [], [], [], []
    for seat, duty in seat_duties(flight):
        named = fitted_in(flight.sizing, seat)
        if float(np.hypot(duty.radial, duty.axial).max()) < _LEAST_LOAD:
            idle.append(seat.name)
        elif seat.runs_on is not None and seat.runs_on.journal is not None:
            films.append(seat.name)
        elif duty.missing:
            notes.append(f"{seat.name}: {duty.missing}")
            failed.append(seat.name)
        elif named is None and flight.mission.bearings is None:
            opened.append(seat.name)
        else:
            try:
                rows.append(_known(flight, seat, duty, named, (chosen or {}).get(seat.name)))
            except DesignError as error:
                problems += [Problem(seat.path, problem.message) for problem in error.problems if named]
                notes += [f"{seat.name}: {problem.message}" for problem in error.problems if not named]
                failed.append(seat.name)
    refuse(problems)
    thrusts = tuple(thrust_notes(flight))
    notes += [thrust.words for thrust in thrusts]
    notes += [f"{', '.join(idle)}: nothing to rate, as the forces of the meshes cancel"] if idle else []
    notes += [f"{', '.join(films)}: a film bears, which sizing judges; it has no rating life"] if films else []
    missing = "no bearing is named, and the mission has no [bearings] to choose one"
    notes += [f"{', '.join(opened)}: {missing}"] if opened else []
    notes += [
        f"{row.seat}: no bearing that fits reaches the asked life and static safety; {row.bearing.designation} comes"
        f" nearest{f'; {THICKER}' if row.holds_shaft else ''}"
        for row in rows
        if row.falls_short
    ]
    loose = tuple(thrust.words for thrust in thrusts if not thrust.taken)
    return BearingLives(tuple(largest_first(rows, lambda row: row.damage)), tuple(notes), (*opened, *failed), loose)


def _known(
    flight: Flight, seat: Seat, duty: SeatDuty, named: SeatedBearing | None, taken: Bearing | None
) -> BearingDamage:
    rules = flight.mission.bearings
    if named is None and taken is not None:
        return _asked_of(flight, seat, duty, SeatedBearing(taken, cast(BearingLifeRules, rules).side_by_side))
    if named is None:
        return _chosen(flight, seat, duty, cast(BearingLifeRules, rules))
    chosen, fits = named.bearing, seat.given is not None
    if not fits and not (chosen.bore >= seat.bore - 1e-9 and chosen.outer_diameter <= seat.room + 1e-9):
        message = (
            f"{chosen.designation} has a bore of {1e3 * chosen.bore:g} mm and an outside of"
            f" {1e3 * chosen.outer_diameter:g} mm; allowed: {1e3 * seat.bore:.4g} mm or more, and"
            f" {1e3 * seat.room:.4g} mm or less; take another size"
        )
        raise DesignError([Problem("designation", message)])
    reliability = rules.reliability if rules else USUAL_RELIABILITY
    return _lived(flight, seat, duty, SeatedBearing(chosen, named.side_by_side), reliability=reliability)


def _chosen(flight: Flight, seat: Seat, duty: SeatDuty, rules: BearingLifeRules) -> BearingDamage:
    """Take the lightest bearing that bears the spectrum, or what comes nearest under the mean of its loads.

    Its bore is that of its shaft; a pin is made as thick as a bearing that has room in its planet. One that does not
    turn too fast comes before all that do.
    """
    kind = BearingKind(KINDS[rules.thrust_kind if duty.axial.any() else rules.kind])
    share = pair_factor(kind, rules.side_by_side)
    radial, axial, speed = _steady(duty, kind)
    asked = BearingDuty(
        radial=radial / share,
        axial=axial / share,
        speed=speed,
        life=rules.life / reliability_factor(rules.reliability),
        static_safety=rules.static_safety,
        limit_factor=float(np.hypot(duty.radial, duty.axial).max()) / math.hypot(radial, axial),
    )
    widest = bore_around(kind, seat.bore) if seat.holds_shaft else math.inf
    sizes = fitting_bearings(kind, asked, bore=seat.bore, largest_bore=widest, largest_outer=seat.room)
    most = highest_speed_factor(kind, flight.sizing.design)

    def too_fast(size: Bearing) -> bool:
        return speed_factor(float(duty.speed.max()), size.bore, size.outer_diameter) > most

    near = sorted((size.bearing for size in sizes if min(size.life_margin, size.static_margin) >= _NEAR), key=too_fast)
    able = (
        row
        for fitted in near
        if not (row := _asked_of(flight, seat, duty, SeatedBearing(fitted, rules.side_by_side))).falls_short
    )
    nearest = largest(sizes, lambda size: min(size.life_margin, size.static_margin)).bearing
    return next(able, None) or _asked_of(flight, seat, duty, SeatedBearing(nearest, rules.side_by_side))


def _asked_of(flight: Flight, seat: Seat, duty: SeatDuty, fitted: SeatedBearing) -> BearingDamage:
    """Return the damage of a bearing with what the mission asks of it."""
    rules = cast(BearingLifeRules, flight.mission.bearings)
    lived = _lived(flight, seat, duty, fitted, reliability=rules.reliability)
    return replace(lived, asked=rules.life / 3600.0, asked_static_safety=rules.static_safety)


def _steady(duty: SeatDuty, kind: BearingKind) -> tuple[float, float, float]:
    """Return radial and axial force and speed that tire a bearing as its duty does.

    Nothing tires a bearing that bears load only while it stands: it has its largest load, at rest.
    """
    turns, load = duty.speed * duty.time, np.hypot(duty.radial, duty.axial)
    if not turns[load >= _LEAST_LOAD].any():
        worst = place_of_largest(load)
        return float(duty.radial[worst]), float(duty.axial[worst]), 0.0
    exponent = life_exponent(kind)
    radial, axial = (mean_load(force.tolist(), turns.tolist(), exponent) for force in (duty.radial, duty.axial))
    return radial, axial, float(turns.sum() / duty.time.sum())


def _lived(flight: Flight, seat: Seat, duty: SeatDuty, fitted: SeatedBearing, *, reliability: float) -> BearingDamage:
    """Return the damage of a bearing, for bearings side by side and a reliability."""
    flown, taken = float(duty.time.sum()), fitted.bearing
    spectrum = _spectrum(duty, fitted)
    check, oiled = check_bearing(taken, spectrum), _oiled(flight, seat, fitted, spectrum, reliability)
    return BearingDamage(
        seat=seat.name,
        bearing=taken,
        count=seat.count * fitted.side_by_side,
        mean_load=pair_factor(taken.kind, fitted.side_by_side) * check.equivalent_load,
        mean_speed=spectrum.mean_speed,
        static_safety=check.static_safety,
        damage=flown / (oiled.life if oiled else check.life * reliability_factor(reliability)),
        hours=flown / 3600.0,
        asked=None,
        life_factor=oiled.factor if oiled else None,
        speed_factor=speed_factor(float(duty.speed.max()), taken.bore, taken.outer_diameter),
        holds_shaft=seat.holds_shaft,
    )


def _spectrum(duty: SeatDuty, fitted: SeatedBearing) -> BearingSpectrum:
    flown = float(duty.time.sum())
    return BearingSpectrum(
        radial=tuple(duty.radial.tolist()),
        axial=tuple(duty.axial.tolist()),
        speed=tuple(duty.speed.tolist()),
        share=tuple((duty.time / flown).tolist()),
        life=flown,
        mean_factor=1.0 / pair_factor(fitted.bearing.kind, fitted.side_by_side),
        limit_factor=1.0 / fitted.side_by_side,
        viscosity=None if duty.viscosity is None else tuple(duty.viscosity.tolist()),
    )


def _oiled(
    flight: Flight, seat: Seat, fitted: SeatedBearing, spectrum: BearingSpectrum, reliability: float
) -> ModifiedLife | None:
    """Return the modified life over a flight, where the design asks for it; None where nothing loads the bearing."""
    design = flight.sizing.design
    if design.bearing_rules.life == "basic":
        return None
    rules = design.bearing_rules.model_copy(update={"reliability": reliability})
    asked = design.model_copy(update={"bearing_rules": rules})
    return oiled_life(asked, fitted.bearing, spectrum, path=seat.path or seat.name)
