"""Rolling bearings of shafts and planets: loads, rating life, selection, and checks of oil and speed.

The catalogue is `catalogue`'s.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import NamedTuple

import numpy as np

from gearwright.base import CELSIUS, Check, DesignError, Floats, Kind, Life, PartId, Problem, Status, apart
from gearwright.catalogue import (
    Bearing,
    BearingCheck,
    BearingOil,
    BearingSpectrum,
    ModifiedLife,
    bearing,
    bearing_friction,
    bearings,
    check_bearing,
    equivalent_loads,
    least_ratings,
    modified_life,
    pressure_centre,
    with_ratings,
)
from gearwright.parts.bearings import (
    BearingKind,
    Cleanliness,
    LoadFactors,
    Lubrication,
    OilFilter,
    film_speed,
    least_load,
    life_exponent,
    pair_factor,
    speed_factor,
    speed_limit,
    taper_factors,
    thermal_reference_speed,
)
from gearwright.parts.losses import oil_viscosity
from gearwright.sizing.airscrew_loads import LoadRow
from gearwright.sizing.arrangement import axial_forces
from gearwright.sizing.bearing_seats import (
    Seat,
    borne,
    planet_seats,
    pushed,
    unit_loads,
)
from gearwright.sizing.loads import ShaftForces, shaft_forces
from gearwright.sizing.rating import Context, context_of
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.sizing.shaft_results import BearingSizing, CarrierSizing, Running
from gearwright.spec import Design
from gearwright.spec.checks import APART, KINDS
from gearwright.spec.design import LOCATES, BearingSeat, levels_of, shares_of

# ----------------------------------------------------------------------------------------------------------------------
# What one bearing bears over the life that is asked of it, by the load cases and their levels.
# ----------------------------------------------------------------------------------------------------------------------


def duty_of(
    context: Context,
    radial: Floats,
    axial: Floats,
    speeds: Sequence[float],
    *,
    life: float | None = None,
    rows: Sequence[LoadRow] = (),
) -> BearingSpectrum:
    """Return what a bearing bears: every case for the static safety, then its levels for the life.

    Without shares one case lasts the whole life. Limit loads are no nominal ones: the factor that makes the others
    limit loads is taken out of them.

    Args:
        context: What sizing reads.
        radial: In every case [N].
        axial: In every case [N].
        speeds: Of one ring against the other, in every case [rad/s].
        life: Asked; left out: that of the service [s].
        rows: What each row of the forces is; left out: each is a load case.
    """
    service = context.design.service
    every = spectrum_rows(context, rows)
    return BearingSpectrum(
        radial=tuple(level * float(radial[k]) for k, level, _ in every),
        axial=tuple(level * float(axial[k]) for k, level, _ in every),
        speed=tuple(speeds[k] for k, _, _ in every),
        share=tuple(share for _, _, share in every),
        life=life or service.bearing_life,
        static_safety=service.static_safety,
        mean_factor=1.0 if service.spectrum or shares_of(context.design) else service.mean_load,
        limit_factor=service.application_factor,
    )


def spectrum_rows(context: Context, rows: Sequence[LoadRow] = ()) -> list[tuple[int, float, float]]:
    """Return place of its forces, part of them and share of the life [-] of every row of what a bearing bears.

    Args:
        context: What sizing reads.
        rows: What the forces of each place are, some of use, fatigue or limit alone; left out: each is a load case.
    """
    design, cases = context.design, list(context.flows)
    shares = shares_of(design) or {context.reference.case: 1.0}
    parts = [(cases[row.case], row.share) for row in rows] or [(case, 1.0) for case in cases]
    levels = [
        (place, level, part * of_case * shares.get(case, 0.0))
        for place, (case, of_case) in enumerate(parts)
        if of_case
        for level, part in levels_of(design, case)
    ]
    limits = {place for place, row in enumerate(rows) if row.use == "limit"}
    without = 1.0 / design.service.application_factor
    return [*((place, without if place in limits else 1.0, 0.0) for place in range(len(parts))), *levels]


# ----------------------------------------------------------------------------------------------------------------------
# How the bearing of a seat runs: with its oil, its least load and its speeds.
# ----------------------------------------------------------------------------------------------------------------------


def oil_of(design: Design) -> BearingOil:
    """Return the oil in the bearings of a design.

    Args:
        design: With its oil and its rules for bearings.
    """
    oil = design.oil
    viscosity = oil_viscosity(oil.temperature + CELSIUS, (oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6))
    word = oil.cleanliness.upper().replace("-", "_")
    dirt = OilFilter[word] if word in OilFilter.__members__ else Cleanliness[word]
    return BearingOil(viscosity, dirt, design.bearing_rules.reliability)


def oiled_life(design: Design, fitted: Bearing, duty: BearingSpectrum, *, path: str) -> ModifiedLife | None:
    """Return the modified life of a bearing; None where nothing loads it, or the standard gives none and none is asked.

    Args:
        design: With its oil and its rules for bearings.
        fitted: The bearing.
        duty: What it bears.
        path: Where the design says what sits there.

    Raises:
        DesignError: The oil is too thin for the standard, and the design asks for this life.
    """
    try:
        return modified_life(fitted, duty, oil_of(design))
    except DesignError as error:
        if design.bearing_rules.life == "basic":
            return None
        raise DesignError([Problem(path, f"{problem.message}, in [oil]") for problem in error.problems]) from None


def running_of(fitted: Bearing, duty: BearingSpectrum) -> Running:
    """Return how a bearing runs under a duty.

    Args:
        fitted: The bearing.
        duty: What it bears.
    """
    loads = [
        duty.mean_factor * equivalent_loads(fitted, radial, axial)[0]
        for radial, axial, speed in zip(duty.radial, duty.axial, duty.speed, strict=True)
        if speed
    ]
    friction, fastest = bearing_friction(fitted), max((abs(speed) for speed in duty.speed), default=0.0)
    return Running(
        lightest_load=min(loads, default=0.0),
        least_load=least_load(fitted.dynamic_rating, fitted.kind),
        highest_speed=fastest,
        reference_speed=thermal_reference_speed(
            fitted.bore, fitted.outer_diameter, fitted.width,
            static_rating=fitted.static_rating, oil_factor=friction.oil_factor, load_factor=friction.load_factor,
        ),
        speed_factor=speed_factor(fastest, fitted.bore, fitted.outer_diameter),
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Checks of how a bearing lives with its oil, what it bears at least and how fast it turns.
# ----------------------------------------------------------------------------------------------------------------------


_LIGHT = "its rolling elements may skid; a lighter series, a ball bearing in its place or a preload would help"
_WARM = (
    "warmer than 70 °C in an oil bath; oil jets that carry off what it loses, a lighter series or a smaller"
    " bore would help"
)
_BETTER: Mapping[Lubrication, Lubrication | None] = {"grease": "jet", "jet": "under-race", "under-race": None}
_HOW = {"grease": "with grease", "jet": "with oil jets", "under-race": "with oil under its races"}


def life_check(
    part: PartId, fitted: Bearing, basic: Life, oiled: ModifiedLife | None, wanted: Life, design: Design
) -> Check:
    """Return the check of a bearing's life, basic or modified as the design asks.

    Args:
        part: The bearing.
        fitted: Which one.
        basic: L_10h [s].
        oiled: With its oil; None where nothing loads it.
        wanted: What is asked [s].
        design: With its rules for bearings.
    """
    if design.bearing_rules.life == "basic" or oiled is None:
        exponent = life_exponent(fitted.kind)
        return Check(
            part, "life", "ISO 281:2007", basic, wanted, "life",
            exponent=exponent, symbol="L_10h", place=fitted.designation,
        )  # fmt: skip
    return Check(
        part, "life", "ISO 281:2007, 9.3", oiled.life, wanted, "life",
        exponent=None, symbol="L_nmh", place=fitted.designation,
    )  # fmt: skip


def speed_factor_check(part: PartId, fitted: Bearing, speed_factor: float, design: Design) -> Check:
    """Return the check of the n d_m of a bearing, with what would cure it where it is more than usual.

    Args:
        part: The bearing.
        fitted: Which one.
        speed_factor: n d_m [mm/min].
        design: With its rules for bearings.
    """
    rules = design.bearing_rules
    usual, careful = speed_limit(fitted.kind, rules.lubrication)
    limit, why = rules.speed_factor or careful, ""
    if speed_factor > limit:
        why = f"{_HOW[rules.lubrication]} it bears {limit:.2g}; {_cure(fitted.kind, design)}"
    elif rules.speed_factor is None and speed_factor > usual:
        why = (
            f"above {usual:.2g}, which is usual {_HOW[rules.lubrication]}: guided cage, accurate parts, cool clean oil"
        )
    return Check(
        part, "speed factor", "n d_m in mm/min", speed_factor, limit, "number",
        at_most=True, exponent=None, symbol="n d_m", place=fitted.designation, why=why,
    )  # fmt: skip


def highest_speed_factor(kind: BearingKind, design: Design) -> float:
    """Return the n d_m above which a bearing fails [mm/min].

    Args:
        kind: Of bearing.
        design: With its rules for bearings.
    """
    return design.bearing_rules.speed_factor or speed_limit(kind, design.bearing_rules.lubrication).careful


def _cure(kind: BearingKind, design: Design) -> str:
    """Return which arrangement would let a bearing turn so fast."""
    rules, cures = design.bearing_rules, ["a smaller bore or a lighter series", "two rows that share the load"]
    if rules.speed_factor is None and (better := _BETTER[rules.lubrication]) is not None:
        cures.append(f'bearing_rules.lubrication = "{better}" (to {speed_limit(kind, better).careful:.2g})')
    if kind is BearingKind.TAPER:
        cures.append("an angular contact ball pair beside a cylindrical roller bearing in place of taper rollers")
    return f"what helps: {', or '.join(cures)}"


def limit_checks(part: PartId, fitted: Bearing, running: Running, design: Design) -> Iterator[Check]:
    """Yield whether a bearing turns too fast and, where the design asks, bears enough not to skid and stays cool.

    Args:
        part: The bearing.
        fitted: Which one.
        running: What it bears at least, and its speeds.
        design: With its rules for bearings.
    """
    place = fitted.designation
    yield speed_factor_check(part, fitted, running.speed_factor, design)
    if not design.bearing_rules.limits:
        return
    if running.lightest_load:
        yield Check(
            part, "least load", "SKF, minimum load", running.lightest_load, running.least_load, "force",
            exponent=None, symbol="P", place=place,
            why=_LIGHT if running.lightest_load < running.least_load else "",
        )  # fmt: skip
    yield Check(
        part, "thermal reference speed", "ISO 15312:2003", running.highest_speed, running.reference_speed, "speed",
        at_most=True, exponent=None, symbol="n", place=place,
        why=_WARM if running.highest_speed > running.reference_speed else "",
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Bearings of one shaft: what each bears over its service, which sizes of the catalogue do, and which one is taken.
# ----------------------------------------------------------------------------------------------------------------------


TYPICAL_TAPER = LoadFactors(0.4, 0.4, 1.5)
"""e, X, Y of taper bearings before one is chosen: α = 15° [-]."""
MAKER = "maker's rating, given by the user"


class SizeTrial(NamedTuple):
    """What is known of the sizes of a bearing under one duty."""

    checks: dict[str, BearingCheck]
    """Size -> how it bears the duty, as far as that was asked."""
    weak: set[str]
    """Sizes that do not."""


Checked = dict[tuple[str, BearingSpectrum], SizeTrial]
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
    tried: Mapping[str, SizeTrial]
    """Bearing -> what is known of its sizes, also from other seatings of the shaft with the same duty."""
    names: tuple[str, ...]
    """What every row of the forces is called."""

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
    seats, names = forces.plan.seats, forces.names(context.flows)
    reactions = forces.largest_radial()
    carried = iter(reactions.T)
    radial = {name: next(carried) if seat.radial else np.zeros(len(reactions)) for name, seat in seats.items()}
    factors = {
        name: taper_factors(chosen[name].geometry.contact_angle) if name in chosen else TYPICAL_TAPER
        for name, seat in seats.items()
        if seat.kind == "taper"
    }
    try:
        axial = axial_forces(shaft, seats, forces.axial, radial=radial, factors=factors, cases=names)
    except DesignError as error:
        raise DesignError(
            [Problem(one.path, one.message + _assumed(context, shaft, forces)) for one in error.problems]
        ) from None
    speeds = forces.by_row([flow.speeds[shaft] for flow in context.flows.values()])
    duties = {
        name: duty_of(context, radial[name], axial[name], speeds, life=seat.life, rows=forces.rows)
        for name, seat in seats.items()
    }
    sizes = {name: _sizes(name, seat, slim=slim) for name, seat in seats.items()}
    plain = context.design.bearing_rules.life != "modified"
    for name, duty in duties.items():
        if (name, duty) not in known:
            known[name, duty] = SizeTrial({}, _too_weak(sizes[name], duty, by_life=plain))
    tried = {name: known[name, duty] for name, duty in duties.items()}
    return Seating(seats, radial, axial, duties, sizes, context.design, tried, names)


def _assumed(context: Context, shaft: str, forces: ShaftForces) -> str:
    """Return how to state the loads of a propeller or rotor that are assumed; nothing where none are."""
    screws = [name for name, screw in context.design.airscrews.items() if screw.shaft == shaft]
    return (
        f"; loads of {' and '.join(screws)} are assumed where they are not stated: write its thrust_n,"
        " in_plane_force_n and hub_moment_nm, 0 where it has none"
        if forces.rows
        else ""
    )


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


def bearing_sizings(seated: Seating, chosen: Mapping[str, Bearing], shaft: str) -> tuple[BearingSizing, ...]:
    """Return the bearings of a shaft as they were taken.

    Args:
        seated: What they bear.
        chosen: Bearing -> the size taken.
        shaft: Name of the shaft.
    """
    return tuple(_sizing(name, seated, chosen[name], shaft) for name in seated.seats)


def _sizing(name: str, seated: Seating, taken: Bearing, shaft: str) -> BearingSizing:
    duty, check = seated.duties[name], seated.check(name, taken)
    statics = [equivalent_loads(taken, *loads)[1] for loads in zip(duty.radial, duty.axial, strict=True)]
    worst = int(np.argmax(statics))
    oiled = oiled_life(seated.design, taken, duty, path=f"bearings.{name}")
    return BearingSizing(
        name=name,
        shaft=shaft,
        position=seated.seats[name].position,
        bearing=taken,
        case=seated.names[worst],
        radial=float(seated.radial[name][worst]),
        axial=float(seated.axial[name][worst]),
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


# ----------------------------------------------------------------------------------------------------------------------
# What the bearing of one planet bears in every load case of a design.
# ----------------------------------------------------------------------------------------------------------------------


class PlanetLoad(NamedTuple):
    """Load and speed of a planet's bearing, by load case."""

    radial: Floats
    """[N]"""
    axial: Floats
    """[N]"""
    speeds: list[float]
    """Of the planet against its carrier, in which its load stands still [rad/s]."""


def borne_by(context: Context, seat: Seat) -> PlanetLoad:
    """Return what the bearings of a planet bear in every case.

    Args:
        context: What sizing reads.
        seat: Inside the planet.
    """
    return pushes_on(context, seat).with_swing(seat)


class PlanetPushes(NamedTuple):
    """What meshes push on the bearings of a planet in every case, whatever swings there."""

    force: Floats
    """Across and along, shape (cases, 3) [N]."""
    carrier: Floats
    """Speed of the carrier, shape (cases,) [rad/s]."""
    speeds: list[float]
    """Of the planet as a film on its pin feels it [rad/s]."""

    def with_swing(self, seat: Seat) -> PlanetLoad:
        """Return what the bearings bear.

        Args:
            seat: With what it swings.
        """
        radial, axial = borne(seat, self.force, self.carrier)
        return PlanetLoad(radial, axial, self.speeds)


def pushes_on(context: Context, seat: Seat) -> PlanetPushes:
    """Return what meshes push on the bearings of a planet in every case.

    Args:
        context: What sizing reads.
        seat: Inside the planet.
    """
    flows = context.flows.values()
    torques = np.array([[flow.meshes[m.name].torques[0] / m.count for m in context.train.meshes] for flow in flows])
    carrier = np.array([flow.speeds[seat.carrier] for flow in flows])
    inner, outer = seat.nodes
    speeds = [film_speed(flow.speeds[inner], flow.speeds[outer], flow.speeds[inner]) for flow in flows]
    return PlanetPushes(pushed(seat, torques), carrier, speeds)


def planet_duty(context: Context, seat: Seat, fitted: Bearing, borne: PlanetLoad) -> BearingSpectrum:
    """Return what one of the equal bearings of a planet bears over the life that is asked of it.

    Args:
        context: What sizing reads.
        seat: Inside the planet.
        fitted: The bearing.
        borne: By all of them.
    """
    share = pair_factor(fitted.kind, seat.side_by_side)
    life = None if seat.fitted is None else seat.fitted.life
    return duty_of(context, borne.radial / share, borne.axial, borne.speeds, life=life)


# ----------------------------------------------------------------------------------------------------------------------
# How the bearings that a design names for its planets bear the load cases: life, static safety, room for the pin.
# ----------------------------------------------------------------------------------------------------------------------


HELP = (
    "no size that has room lives as long: take a plain bearing, more planets, thinner rims"
    " (gears.rim_thickness_ratio), a slower carrier, or one that stands still"
)
"""What would help where no rolling bearing lives as long as is asked."""


def planet_lives(
    context: Context, gears: tuple[GearSizing, ...], carriers: tuple[CarrierSizing, ...]
) -> tuple[Check, ...]:
    """Return life, static safety and room of every rolling bearing that the design asks for in its planets.

    Args:
        context: What sizing reads.
        gears: As sized.
        carriers: As sized.

    Source: ISO 281:2007 and ISO 76:2006; equal bearings side by side bear i^0.7 (balls) or i^(7/9) (rollers) times the
        rating of one, ISO 281:2007, 5.1.2 and 7.1.2, and i times its static rating.
    """
    named = context.design
    if not any(stage.planet_bearing for stage in named.planetaries.values()) and not any(
        planet.bearing for epicyclic in named.epicyclics.values() for planet in epicyclic.planets.values()
    ):
        return ()
    seats = planet_seats(unit_loads(context), gears, carriers)
    return tuple(
        check
        for seat in seats
        if seat.runs_on is not None and seat.runs_on.bearing is not None
        for check in _checks(context, seat)
    )


def _checks(context: Context, seat: Seat) -> Iterator[Check]:
    assert seat.runs_on is not None and seat.runs_on.bearing is not None
    fitted, borne = seat.runs_on.bearing, borne_by(context, seat)
    duty = planet_duty(context, seat, fitted, borne)
    check, place = check_bearing(fitted, duty), fitted.designation
    oiled = oiled_life(context.design, fitted, duty, path=seat.path)
    static = check.static_safety * seat.side_by_side / pair_factor(fitted.kind, seat.side_by_side)
    yield _advised(life_check(seat.part, fitted, check.life, oiled, duty.life, context.design), seat)
    yield Check(
        seat.part, "static safety", "ISO 76:2006", static, duty.static_safety,
        symbol="s_0", place=place, case=tuple(context.flows)[int(np.argmax(borne.radial))],
    )  # fmt: skip
    yield from limit_checks(seat.part, fitted, running_of(fitted, duty), context.design)
    yield from _room(seat, fitted)


def _advised(check: Check, seat: Seat) -> Check:
    """Return the check of a life with what would help, where it falls short and the design left the size open."""
    if check.status is not Status.FAILS or seat.fitted is None or seat.fitted.designation is not None:
        return check
    return replace(check, why=HELP)


def _room(seat: Seat, fitted: Bearing) -> Iterator[Check]:
    """Yield whether the pin goes through a bearing, and whether the rim around it stays as thick as its rules ask."""
    yield Check(
        seat.part, "room around the pin", "diameter of the pin", fitted.bore, seat.bore, "length",
        exponent=None, place=fitted.designation,
    )  # fmt: skip
    yield Check(
        seat.part, "room in the rim", "rim_thickness_ratio", fitted.outer_diameter, seat.room, "length",
        at_most=True, exponent=None, place=fitted.designation,
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Which bearing sits in a seat, as the design names it or sizing took it.
# ----------------------------------------------------------------------------------------------------------------------


class SeatedBearing(NamedTuple):
    """A bearing in a seat."""

    bearing: Bearing
    side_by_side: int


def fitted_in(sizing: Sizing, seat: Seat) -> SeatedBearing | None:
    """Return the bearing that sizing took for a seat of the design, or for a planet; None for a film, or nothing.

    Args:
        sizing: As sized.
        seat: One of its seats.
    """
    if seat.given is not None:
        return SeatedBearing(next(sized.bearing for sized in sizing.bearings if sized.name == seat.name), 1)
    rolls = None if seat.runs_on is None else seat.runs_on.bearing
    return None if rolls is None else SeatedBearing(rolls, seat.side_by_side)


# ----------------------------------------------------------------------------------------------------------------------
# Lives of taper bearings whose loads act at their pressure centres; sizing takes the middles of their widths.
# ----------------------------------------------------------------------------------------------------------------------


BESIDE = " with its load at the pressure centre"
"""What is added to the mode of a check of life."""


def centred_bearings(sizing: Sizing) -> Iterator[BearingSizing]:
    """Yield the taper bearings of built shafts as they bear what acts at their pressure centres.

    A bearing that takes thrust towards one end has the back of its inner ring, and its pressure centre, on the other
    side.

    Args:
        sizing: As sized.
    """
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    gears = {gear.name: gear for gear in sizing.gears}
    for shaft in sizing.built_shafts:
        chosen = {bearing.name: bearing.bearing for bearing in sizing.bearings if bearing.shaft == shaft.name}
        plan = sizing.arrangement.plans[shaft.name]
        off = {
            name: -LOCATES[seat.locates][0] * pressure_centre(chosen[name])
            for name, seat in plan.seats.items()
            if seat.kind == "taper"
        }
        if not off:
            continue
        radial = [name for name, seat in plan.seats.items() if seat.radial]
        first, second = (place + off.get(name, 0.0) for name, place in zip(radial, plan.bearings, strict=True))
        centred = replace(plan, bearings=(first, second))
        forces = shaft_forces(context, shaft.name, centred, axes=sizing.arrangement.axes, gears=gears)
        seated = seating(context, shaft.name, forces, chosen, slim=True, known={})
        yield from (bearing for bearing in bearing_sizings(seated, chosen, shaft.name)
                    if bearing.name in off)  # fmt: skip


def pressure_centre_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the life of every taper bearing with its load at its pressure centre.

    Args:
        sizing: As sized.
    """
    for centred in centred_bearings(sizing):
        part = PartId(Kind.BEARING, centred.name)
        check = life_check(part, centred.bearing, centred.life, centred.oiled, centred.wanted_life, sizing.design)
        yield replace(check, mode=f"{check.mode}{BESIDE}")
