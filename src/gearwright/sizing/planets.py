"""Planet bearings: selection of catalogue bearings, integral roller bearings and plain bearings.

Lives of rolling bearings are `bearings`'s; pins are `shafts`'s.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import NamedTuple, NoReturn

import numpy as np

from gearwright.base import (
    CELSIUS,
    Check,
    DesignError,
    Floats,
    Problem,
    Role,
    Status,
    gear_part,
    largest,
    not_assessed,
    smallest,
)
from gearwright.catalogue import Bearing, bearings, check_bearing
from gearwright.elementwise import Values
from gearwright.parts.bearings import (
    CERAMIC_DENSITY,
    STEEL_DENSITY,
    BearingGeometry,
    BearingKind,
    FilmOil,
    FilmState,
    Journal,
    ceramic_share,
    dynamic_rating,
    fatigue_load_limit,
    laminar_limit,
    life_exponent,
    life_time,
    pair_factor,
    rolling_weights,
    run_film,
    static_rating,
    turning_inertia,
    usual_clearance,
    usual_least_film,
)
from gearwright.parts.carriers import pin_stress
from gearwright.parts.gears import disc_mass
from gearwright.parts.losses import oil_viscosity
from gearwright.sizing.bearing_seats import Carrying, Seat, as_made, borne, planet_seats, unit_loads
from gearwright.sizing.bearings import (
    PlanetLoad,
    PlanetPushes,
    borne_by,
    highest_speed_factor,
    oiled_life,
    planet_duty,
    pushes_on,
    running_of,
    spectrum_rows,
)
from gearwright.sizing.gear_geometry import crown_volume, pin_circle, planet_body_volume
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shaft_results import PlanetBearingSizing
from gearwright.spec import Design
from gearwright.spec.design import CONCEPT, PlanetBearing

# ----------------------------------------------------------------------------------------------------------------------
# What a bearing between a planet and its pin is chosen for: the room, the loads, the strength of the pin.
# ----------------------------------------------------------------------------------------------------------------------


THICKEST = 0.96
"""Largest bore of a planet over its root circle, whatever stands in it: what has no room is told by its checks [-]."""


class CarrierBasis(NamedTuple):
    """What is known of a carrier before it is sized."""

    stage: str
    shaft: str
    radius: float
    """[m]"""
    pin_diameter: float
    """[m]"""


@dataclass(frozen=True)
class Task:
    """One planet of a simple set, whose bearing the design leaves open or names."""

    context: Context
    planet: GearSizing
    asked: PlanetBearing
    path: str
    """Where the design asks."""
    seat: Seat
    """What its meshes push."""
    radius: float
    """Of the circle of pins [m]."""

    @property
    def room(self) -> float:
        """Largest bore of the planet [m]."""
        return self.seat.room

    @property
    def width(self) -> float:
        """Of rollers' room or film [m]."""
        return self.asked.width or self.planet.face_width

    @property
    def fastest(self) -> float:
        """Of the planet against its carrier, in all cases [rad/s]."""
        return max(borne_by(self.context, self.seat).speeds, default=0.0)

    @cached_property
    def crown(self) -> float:
        """What the teeth of the planet fill [m³]; 0 where it counts as a ring without them."""
        return crown_of(self.context, self.planet)

    @cached_property
    def pushes(self) -> PlanetPushes:
        """What meshes push on its bearings."""
        return pushes_on(self.context, self.seat)

    @cached_property
    def masses(self) -> dict[float, float]:
        """Outside of a bearing [m] -> mass of the planet around it [kg], of those that were asked for."""
        return {}

    def swung(self, runs_on: PlanetBearingSizing) -> float:
        """Return mass times radius of what swings with the carrier, of the planet and of what turns in it [kg m].

        Args:
            runs_on: The bearing.
        """
        outside = runs_on.outer_diameter
        if outside not in self.masses:
            self.masses[outside] = _mass_around(self.context, self.planet, outside, crown=self.crown)
        return (self.masses[outside] + runs_on.turning_mass) * self.radius

    def load(self, runs_on: PlanetBearingSizing) -> PlanetLoad:
        """Return what a bearing bears in every case, with what it takes from the planet and what it swings itself.

        Args:
            runs_on: The bearing.
        """
        return self.pushes.with_swing(replace(self.seat, swung=self.swung(runs_on)))

    def pin_margin(self, pin: float, load: PlanetLoad) -> float:
        """Return allowable over actual stress of a solid pin [-].

        Args:
            pin: Its diameter [m].
            load: On it.
        """
        stress = pin_stress(float(load.radial.max()), self.planet.face_width, pin)
        return self.allowable / stress if stress else math.inf

    @property
    def allowable(self) -> float:
        """Stress that a pin may have [Pa]."""
        design = self.context.design
        return (design.shaft_material.yield_strength or 0.0) / design.carriers.safety


def tasks(context: Context, gears: tuple[GearSizing, ...]) -> Iterator[Task]:
    """Yield every planet of a simple set for which the design asks a bearing.

    Args:
        context: What sizing reads.
        gears: As sized, planets as solid discs.
    """
    asked = {name: stage for name, stage in context.design.planetaries.items() if stage.planet_bearing is not None}
    if not asked:
        return
    by_name = {gear.name: gear for gear in gears}
    carriers = [
        CarrierBasis(name, stage.carrier, pin_circle(context, name, by_name), 0.0)
        for name, stage in context.design.planetaries.items()
    ]
    own = [gear for gear in gears if gear.stage in context.design.planetaries]
    simple = {seat.part.name: seat for seat in planet_seats(unit_loads(context), tuple(own), carriers)}
    for carrier in carriers:
        bearing = context.design.planetaries[carrier.stage].planet_bearing
        if bearing is not None:
            planet, path = by_name[str(gear_part(carrier.stage, Role.PLANET))], f"planetaries.{carrier.stage}"
            seat = replace(simple[carrier.stage], fitted=bearing, side_by_side=bearing.side_by_side)
            yield Task(context, planet, bearing, f"{path}.planet_bearing", seat, carrier.radius)


def crown_of(context: Context, planet: GearSizing) -> float:
    """Return what the teeth of a planet fill, where it is weighed as it is made; else 0 [m³].

    Args:
        context: What sizing reads.
        planet: As sized.
    """
    return crown_volume(context.design, planet) if context.design.level != CONCEPT else 0.0


def bored(context: Context, planet: GearSizing, runs_on: PlanetBearingSizing, *, crown: float) -> GearSizing:
    """Return a planet with the bore that its bearing takes, of its own mass and inertia: a ring, or as it is made.

    What the user gives of mass or inertia stays.

    Args:
        context: What sizing reads.
        planet: As a solid disc.
        runs_on: What stands in it.
        crown: From `crown_of` [m³].
    """
    mean = planet.pitch_diameter + 2.0 * planet.profile_shift * planet.module
    bore = _bore(planet, runs_on.outer_diameter)
    mass = _mass_around(context, planet, runs_on.outer_diameter, crown=crown)
    inertia = context.given.get(f"{planet.name}.inertia", mass * (mean**2 + bore**2) / 8.0)
    return replace(planet, mass=mass, inertia=inertia, runs_on=runs_on)


def _bore(planet: GearSizing, outside: float) -> float:
    return min(outside, THICKEST * (planet.pitch_diameter - 2.5 * planet.module))


def _mass_around(context: Context, planet: GearSizing, outside: float, *, crown: float) -> float:
    """Return the mass of a planet around what stands in it, as given or as it is made [kg]."""
    density = context.ratings[planet.stage].material.density
    if crown:
        own = density * (crown + planet_body_volume(context.design, planet, outside))
    else:
        own = planet.mass - disc_mass(_bore(planet, outside), planet.face_width, density)
    return context.given.get(f"{planet.name}.mass", own)


# ----------------------------------------------------------------------------------------------------------------------
# Rollers that run between a pin and a planet: proportioned to the pin, and rated as the standards do.
# ----------------------------------------------------------------------------------------------------------------------


class RollerProportions(NamedTuple):
    """How rollers of a kind fill the room between pin and planet; assumptions."""

    roller: float
    """Diameter over that of the pin [-]."""
    length: float
    """Of the rollers, over the width: cage and ribs take the rest [-]."""
    circle: float
    """Part of the pitch circle that rollers take; the cage's bars have the rest [-]."""
    density: float = STEEL_DENSITY
    """Of the rollers [kg/m³]."""
    share: float = 1.0
    """Of the ratings with steel rollers [-]."""


PROPORTIONS = {
    "needle": RollerProportions(0.10, 0.85, 0.85),
    "integral": RollerProportions(0.25, 0.80, 0.85),
    "ceramic": RollerProportions(0.25, 0.80, 0.85, CERAMIC_DENSITY, ceramic_share()),
}
"""Kind -> how it is proportioned."""
FEWEST = 6
"""Rollers of an integral bearing, at least [-]."""


def roller_of(kind: str, pin: float, given: float | None) -> float:
    """Return the diameter of the rollers on a pin [m].

    Args:
        kind: needle, integral or ceramic.
        pin: Its diameter [m].
        given: Of the rollers, by the user [m].
    """
    return given or PROPORTIONS[kind].roller * pin


def integral(kind: str, pin: float, roller: float, *, width: float) -> Bearing | None:
    """Return rollers between a pin and a planet as a bearing without rings; None where too few have room.

    Args:
        kind: needle, integral or ceramic.
        pin: Diameter of the pin, the inner raceway [m].
        roller: Diameter of the rollers [m].
        width: Of their room [m].

    Source: ISO 281:2007, 7.1 and ISO 76:2006 for the rollers that fill the circle; both for steel on steel.
    """
    way, pitch = PROPORTIONS[kind], pin + roller
    count = math.floor(way.circle * math.pi / math.asin(roller / pitch))
    if count < FEWEST:
        return None
    inside = BearingGeometry(BearingKind.CYLINDRICAL, count, roller, pitch, roller_length=way.length * width)
    static = way.share * static_rating(inside)
    weights = rolling_weights(inside, pin, pitch + roller, width, density=way.density)
    return Bearing(
        designation=f"{kind} {1e3 * pin:.4g}x{1e3 * (pitch + roller):.4g}x{1e3 * width:.4g}",
        bore=pin,
        outer_diameter=pitch + roller,
        width=width,
        geometry=inside,
        dynamic_rating=way.share * dynamic_rating(inside),
        static_rating=static,
        fatigue_limit=fatigue_load_limit(static, inside),
        mass=weights.total,
        source="rollers in the room of the planet; ratings ISO 281 and ISO 76",
    )


def on_rollers(kind: str, made: Bearing, side_by_side: int) -> PlanetBearingSizing:
    """Return what a planet turns on with what of it turns.

    Args:
        kind: As the design asks.
        made: One of the bearings.
        side_by_side: Equal ones on a pin [-].
    """
    density = PROPORTIONS[kind].density if kind in PROPORTIONS else STEEL_DENSITY
    parts = rolling_weights(made.geometry, made.bore, made.outer_diameter, made.width, density=density)
    return PlanetBearingSizing(
        kind=kind,
        bearing=made,
        side_by_side=side_by_side,
        pin_diameter=made.bore,
        outer_diameter=made.outer_diameter,
        width=side_by_side * made.width,
        clearance=0.0,
        turning_mass=side_by_side * (parts.outer_ring + parts.elements + parts.cage),
        turning_inertia=side_by_side * turning_inertia(parts, made.geometry, made.outer_diameter),
        standing_mass=side_by_side * parts.inner_ring,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Films between pin and planet: their oil, how they run in every load case, and what limits them.
# ----------------------------------------------------------------------------------------------------------------------


HEAT_CAPACITY = 2000.0
"""Of lubricating oil [J/(kg K)]."""
STANDING = 1e-3
"""Speed below which a planet is taken to stand on its pin: a film needs motion [rad/s]."""


class Judged(NamedTuple):
    """A film in one case, with what is allowed there."""

    case: int
    """Of the load cases."""
    state: FilmState
    least_film: float
    """h_lim [m]."""


def film_oil(grade: tuple[float, float], density: float, supply: Values) -> FilmOil:
    """Return the oil that enters a plain bearing.

    Args:
        grade: Kinematic viscosity at 40 °C and at 100 °C [m²/s].
        density: [kg/m³].
        supply: Its temperature [K].
    """
    return FilmOil(lambda at: density * oil_viscosity(at, grade), density, HEAT_CAPACITY, supply)


def design_oil(design: Design, asked: PlanetBearing) -> FilmOil:
    """Return the oil that enters a plain bearing of a design.

    Args:
        design: With its oil.
        asked: With the temperature, where it is given.
    """
    oil = design.oil
    grade = (oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6)
    supply = oil.temperature if asked.oil_temperature is None else asked.oil_temperature
    return film_oil(grade, oil.density, supply + CELSIUS)


def on_film(asked: PlanetBearing, pin: float, width: float, fastest: float = 0.0) -> PlanetBearingSizing:
    """Return a plain bearing of a size.

    Args:
        asked: As in the design.
        pin: D [m].
        width: B [m].
        fastest: Speed of the planet against its carrier, for the usual clearance [rad/s].
    """
    clearance = asked.clearance or usual_clearance(fastest * pin / 2.0)
    return PlanetBearingSizing(
        kind="plain",
        bearing=None,
        side_by_side=1,
        pin_diameter=pin,
        outer_diameter=pin * (1.0 + clearance),
        width=width,
        clearance=clearance,
        turning_mass=0.0,
        turning_inertia=0.0,
        standing_mass=0.0,
    )


def judged(journal: Journal, load: PlanetLoad, asked: PlanetBearing, oil: FilmOil) -> Iterator[Judged]:
    """Yield how a film runs in every case in which the planet turns.

    Args:
        journal: The bearing.
        load: By load case.
        asked: With its limits.
        oil: That enters.
    """
    for case, (radial, speed) in enumerate(zip(load.radial.tolist(), load.speeds, strict=True)):
        if speed > STANDING and radial > 0.0:
            state = run_film(journal, radial, speed, oil)
            yield Judged(case, state, asked.least_film or usual_least_film(journal.diameter, state.sliding_speed))


def film_margin(found: Judged, journal: Journal, asked: PlanetBearing, oil: FilmOil) -> float:
    """Return the least of what a film has over what it must have: pressure, film, temperature, laminar flow [-].

    Args:
        found: A film in one case.
        journal: The bearing.
        asked: With its limits.
        oil: That enters.
    """
    state, allowed = found.state, asked.largest_temperature + CELSIUS - oil.supply
    margins = (
        asked.largest_pressure / state.pressure,
        state.film / found.least_film,
        allowed / state.rise,
        laminar_limit(journal.clearance) / state.reynolds,
    )
    return float(min(margins))


# ----------------------------------------------------------------------------------------------------------------------
# Which bearing a planet gets: the smallest that lives, bears and leaves its pin strong, within the room of its rim.
# ----------------------------------------------------------------------------------------------------------------------


SIZES = 48
"""Pins that are tried, equally far in their logarithm [-]."""
SLIMMEST = 0.1
"""The thinnest of them over the room [-]."""
_HALVINGS = 16
"""Between the last that does not serve and the first that does [-]."""
_NARROW = 1e-9
SURELY = 1.0 - 1e-6
"""Margin below which what arrays find is no matter of rounding [-]."""
ROLLERS = "cylindrical roller bearing of the catalogue"
"""What has no room, in the words of a refusal."""

Made = Callable[[float], PlanetBearingSizing | None]
"""Diameter of a pin -> the bearing on it; None where there is none."""


class Tried(NamedTuple):
    """A size with the least of what it has over what it must have."""

    runs_on: PlanetBearingSizing
    margin: float
    """[-]"""


def chosen(task: Task) -> PlanetBearingSizing:
    """Return what a planet turns on: as named, or the smallest that serves; where none does, the one nearest to it.

    Args:
        task: The planet.

    Raises:
        DesignError: No size has room in the planet.
    """
    asked = task.asked
    if asked.designation is not None:
        return on_rollers(asked.kind, as_made(asked, asked.designation), asked.side_by_side)
    if asked.is_fitted:
        return _of_catalogue(task)
    return _by_diameter(task, lambda pin: _made(task, pin))


def _of_catalogue(task: Task) -> PlanetBearingSizing:
    """Return the first cylindrical roller bearing that serves, by outside and width."""
    made = _catalogued(task.asked.kind, task.asked.side_by_side)
    fitting = [own for own, size in zip(made, cylindrical(), strict=True) if fits(task, size)]
    if not fitting:
        refuse_catalogue(task)
    most = at_most(task, fitting)
    may = [size for size, best in zip(fitting, most.tolist(), strict=True) if best >= SURELY]
    tried = list(_until_one_serves(Tried(size, margin(task, size)) for size in may))
    if len(tried) == len(fitting) or (tried and tried[-1].margin >= 1.0):
        return _first(tried)
    return _nearest(task, [Tried(size, best) for size, best in zip(fitting, most.tolist(), strict=True)])


@cache
def _catalogued(kind: str, side_by_side: int) -> tuple[PlanetBearingSizing, ...]:
    """Return what a planet turns on with each of the bearings of the catalogue."""
    return tuple(on_rollers(kind, size, side_by_side) for size in cylindrical())


def at_most(task: Task, fitting: list[PlanetBearingSizing]) -> Floats:
    """Return what the margins of bearings of the catalogue are at most: those of pin, static rating and basic life [-].

    Args:
        task: The planet.
        fitting: What has room.
    """
    kind, count, service = BearingKind.CYLINDRICAL, task.asked.side_by_side, task.context.design.service
    pins, static, dynamic, swung = np.array([
        (size.pin_diameter, size.bearing.static_rating, size.bearing.dynamic_rating, task.swung(size))
        for size in fitting if size.bearing is not None
    ]).T  # fmt: skip
    radial, _ = borne(replace(task.seat, swung=swung[:, None]), task.pushes.force, task.pushes.carrier)
    most, duty = radial.max(axis=1), planet_duty(task.context, task.seat, cylindrical()[0], task.load(fitting[0]))
    bent = [
        pin_stress(load, task.planet.face_width, pin) for load, pin in zip(most.tolist(), pins.tolist(), strict=True)
    ]
    with np.errstate(divide="ignore", invalid="ignore"):
        near = [
            task.allowable / np.array(bent),
            count * static / (service.static_safety * service.application_factor * most),
        ]
        if task.context.design.bearing_rules.life == "basic" and any(duty.turns):
            place, level, _ = (np.array(column) for column in zip(*spectrum_rows(task.context), strict=True))
            exponent, turns = life_exponent(kind), np.array(duty.turns)
            loads = level * radial[:, place.astype(int)] / pair_factor(kind, count)
            mean = duty.mean_factor * (loads**exponent @ turns / turns.sum()) ** (1.0 / exponent)
            near.append(dynamic / mean * (life_time(1.0, duty.mean_speed) / duty.life) ** (1.0 / exponent))
    least = np.minimum.reduce(near)
    return np.where(np.isnan(least), math.inf, least)


@cache
def cylindrical() -> tuple[Bearing, ...]:
    """Return the cylindrical roller bearings of the catalogue, by outside, width and bore."""
    rollers = [size for size in bearings().values() if size.kind is BearingKind.CYLINDRICAL]
    return tuple(sorted(rollers, key=lambda size: (size.outer_diameter, size.width, size.bore)))


def fits(task: Task, size: Bearing) -> bool:
    """Tell whether bearings have room in a planet, on the pin that the design gives.

    Args:
        task: The planet.
        size: Of the bearings.
    """
    bore, width = _pin(task), task.asked.side_by_side * size.width
    within = (size.outer_diameter <= task.room + _NARROW) & (width <= task.width + _NARROW)
    return within if bore is None else within & (abs(size.bore - bore) < _NARROW)


def _by_diameter(task: Task, made: Made) -> PlanetBearingSizing:
    """Return the bearing on the thinnest pin that serves, or on the one that is given."""
    given = _pin(task)
    if given is not None:
        if (runs_on := made(given)) is None:
            _refuse_room(task, f"{task.asked.kind} bearing on a pin of {1e3 * given:.4g} mm")
        return runs_on
    pins = np.geomspace(SLIMMEST * task.room, task.room, SIZES).tolist()
    tried = list[Tried]()
    for pin in pins:
        size = made(pin)
        if size is None or size.outer_diameter > task.room:
            continue
        most, serves = _serves(task, size)
        if serves:
            return _refined(task, tried[-1].runs_on, size, made) if tried else size
        tried.append(Tried(size, most))
    if not tried:
        _refuse_room(task, f"{task.asked.kind} bearing")
    return _nearest(task, tried)


def _serves(task: Task, size: PlanetBearingSizing) -> tuple[float, bool]:
    """Return what the margin of a bearing cannot exceed, and whether it serves: in full only where that lets it."""
    load = task.load(size)
    most = _ceiling(task, size, load)
    return most, most >= 1.0 and margin(task, size, load) >= 1.0


def _ceiling(task: Task, size: PlanetBearingSizing, load: PlanetLoad) -> float:
    """Return what the margin of a bearing cannot exceed, as its pin and the pressure of its film tell [-]."""
    pin = task.pin_margin(size.pin_diameter, load)
    if size.journal is None:
        return pin
    turned = [radial for radial, speed in zip(load.radial.tolist(), load.speeds, strict=True) if speed > STANDING]
    pressure = max(turned, default=0.0) / (size.journal.width * size.journal.diameter)
    return min(pin, task.asked.largest_pressure / pressure) if pressure else pin


def _nearest(task: Task, tried: Sequence[Tried]) -> PlanetBearingSizing:
    """Return of bearings of which none serves, with the most that each may have, the one that comes nearest to it."""
    found, best = dict[int, Tried](), 0.0
    for place in sorted(range(len(tried)), key=lambda place: -tried[place].margin):
        if tried[place].margin < SURELY * best:
            break
        found[place] = Tried(tried[place].runs_on, margin(task, tried[place].runs_on))
        best = max(best, found[place].margin)
    return _first([found[place] for place in sorted(found)])


def _until_one_serves(tried: Iterator[Tried]) -> Iterator[Tried]:
    for one in tried:
        yield one
        if one.margin >= 1.0:
            return


def min_margin(task: Task, runs_on: PlanetBearingSizing) -> float:
    """Return the margin of a bearing, none above 1: what serves is as good as any [-].

    Args:
        task: The planet.
        runs_on: Its bearing.
    """
    return min(margin(task, runs_on), 1.0)


def _first(tried: list[Tried]) -> PlanetBearingSizing:
    """Return the one that serves, or comes nearest to it."""
    return largest(tried, lambda one: min(one.margin, 1.0)).runs_on


def _refined(task: Task, short: PlanetBearingSizing, enough: PlanetBearingSizing, made: Made) -> PlanetBearingSizing:
    """Return a size that just serves, between one that does not and one that does."""
    low, best = short.pin_diameter, enough
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + best.pin_diameter)
        runs_on = made(middle)
        if runs_on is not None and _serves(task, runs_on)[1]:
            best = runs_on
        else:
            low = middle
    return best


def _made(task: Task, pin: float) -> PlanetBearingSizing | None:
    """Return rollers or a film on a pin; None where too few rollers have room."""
    asked = task.asked
    if asked.kind == "plain":
        return on_film(asked, pin, task.width, task.fastest)
    roller = roller_of(asked.kind, pin, asked.roller_diameter)
    rollers = integral(asked.kind, pin, roller, width=task.width / asked.side_by_side)
    return None if rollers is None else on_rollers(asked.kind, rollers, asked.side_by_side)


def margin(task: Task, runs_on: PlanetBearingSizing, load: PlanetLoad | None = None) -> float:
    """Return the least of what a bearing has over what it must have [-].

    Lives count by the load that they could bear more, (L/L_asked)^(1/p).

    Args:
        task: The planet.
        runs_on: Its bearing.
        load: What it bears, where that is known.
    """
    load = task.load(runs_on) if load is None else load
    pin = task.pin_margin(runs_on.pin_diameter, load)
    if runs_on.journal is not None:
        oil = design_oil(task.context.design, task.asked)
        films = judged(runs_on.journal, load, task.asked, oil)
        return min([pin, *(film_margin(film, runs_on.journal, task.asked, oil) for film in films)])
    assert runs_on.bearing is not None
    design, made = task.context.design, runs_on.bearing
    duty = planet_duty(task.context, task.seat, made, load)
    check = check_bearing(made, duty)
    oiled = oiled_life(design, made, duty, path=task.path) if design.bearing_rules.life == "modified" else None
    life = (check.life if oiled is None else oiled.life) / duty.life
    fast = running_of(made, duty).speed_factor
    slow = highest_speed_factor(made.kind, design) / fast if fast else pin
    static = check.static_margin * _static_share(runs_on)
    return float(min(pin, life ** (1.0 / life_exponent(made.kind)), static, slow))


def _static_share(runs_on: PlanetBearingSizing) -> float:
    """Return what equal bearings side by side bear at rest over what they do in life [-]."""
    assert runs_on.bearing is not None
    return runs_on.side_by_side / pair_factor(runs_on.bearing.kind, runs_on.side_by_side)


def _refuse_room(task: Task, what: str, least: str = "") -> NoReturn:
    message = (
        f"no {what} has room: its bore may have {1e3 * task.room:.4g} mm and its width {1e3 * task.width:.4g} mm;"
        f" {least}take another kind, larger or fewer planets, or thinner rims (gears.rim_thickness_ratio)"
    )
    raise DesignError([Problem(task.path, message)])


def refuse_catalogue(task: Task) -> NoReturn:
    """Raise where no bearing of the catalogue has room, with what has it: the diameter and number of planets.

    Args:
        task: The planet.

    Raises:
        DesignError: Always.
    """
    if (bore := _pin(task)) is not None and not any(abs(size.bore - bore) < _NARROW for size in cylindrical()):
        bores = sorted({size.bore for size in cylindrical()}, key=lambda known: abs(known - bore))[:2]
        near = " and ".join(f"{1e3 * known:g}" for known in sorted(bores))
        message = f"no {ROLLERS} sits on a pin of {1e3 * bore:.4g} mm; the nearest are for {near} mm"
        raise DesignError([Problem(task.path, message)])
    _refuse_room(task, ROLLERS, _with_room(task))


def _with_room(task: Task) -> str:
    """Return which bearing comes nearest to having room, and the planets in which it has: its teeth keep their number.

    Fewer planets bear more each, and their module grows with the cube root of that.
    """
    bore, planet, count = _pin(task), task.planet, task.asked.side_by_side
    sizes = [size for size in cylindrical() if bore is None or abs(size.bore - bore) < _NARROW]
    size = min(sizes, key=lambda size: max(size.outer_diameter / task.room, count * size.width / task.width))
    larger, wide = size.outer_diameter / task.room, count * size.width
    fewer = math.floor(planet.bodies / larger**3 + 1e-9)
    which = f", which {fewer} planets ask for" if 1 < fewer < planet.bodies else ""
    asked = [
        f"planets of {1e3 * larger * planet.pitch_diameter:.4g} mm in place of {1e3 * planet.pitch_diameter:.4g} mm (a"
        f" module of {1e3 * larger * planet.module:.4g} mm{which})"
    ] if larger > 1.0 else []  # fmt: skip
    asked += [f"a face of {1e3 * wide:.4g} mm"] if wide > task.width else []
    return f"{size.designation}, {1e3 * size.outer_diameter:g} mm outside, has it with {' and '.join(asked)}; or "


def _pin(task: Task) -> float | None:
    """Return the diameter of the pin that the design gives [m]; None where it is left open."""
    return task.asked.diameter or task.context.given.get(f"{task.planet.stage}.pin_diameter")


# ----------------------------------------------------------------------------------------------------------------------
# Checks of plain bearings of planets: pressure, film, temperature, laminar flow, and room in the rim.
# ----------------------------------------------------------------------------------------------------------------------


HELP = "a wider or larger film, thinner rims (gears.rim_thickness_ratio), more planets or a slower carrier would help"
"""What helps a film that is pressed too hard."""


def film_checks(context: Context, gears: tuple[GearSizing, ...], carriers: Sequence[Carrying]) -> Iterator[Check]:
    """Yield what is asked of every film between a planet and its pin, each in its worst case.

    Args:
        context: What sizing reads.
        gears: As sized.
        carriers: As sized.
    """
    if any(gear.runs_on is not None and gear.runs_on.journal is not None for gear in gears):
        for seat in planet_seats(unit_loads(context), gears, carriers):
            if seat.runs_on is not None and seat.runs_on.journal is not None:
                yield from (_advised(check) for check in _checks(context, seat))


def _advised(check: Check) -> Check:
    return replace(check, why=HELP) if check.status is Status.FAILS else check


def _checks(context: Context, seat: Seat) -> Iterator[Check]:
    assert seat.runs_on is not None and seat.runs_on.journal is not None and seat.fitted is not None
    load, journal, asked = borne_by(context, seat), seat.runs_on.journal, seat.fitted
    oil, cases, place = design_oil(context.design, asked), tuple(context.flows), seat.runs_on.designation
    films = list(judged(journal, load, asked, oil))
    pressed = largest(range(len(cases)), lambda case: load.radial[case])
    pressure = float(load.radial[pressed]) / (journal.width * journal.diameter)
    yield Check(
        seat.part, "film pressure", "ISO 7902-3, p_lim", pressure, asked.largest_pressure, "stress",
        at_most=True, symbol="p", place=place, case=cases[pressed],
    )  # fmt: skip
    if not films:
        why = f"the planet turns on its pin in no case ({STANDING:g} rad/s or more), and a film needs that"
        yield not_assessed(seat.part, "film thickness", "ISO 7902-1", why)
        return
    thin, hot = (
        smallest(films, lambda film: film.state.film / film.least_film),
        largest(films, lambda film: film.state.exit),
    )
    wild = largest(films, lambda film: film.state.reynolds)
    yield Check(
        seat.part, "film thickness", "ISO 7902-1, h_min", thin.state.film, thin.least_film, "film_thickness",
        symbol="h_min", place=place, case=cases[thin.case],
    )  # fmt: skip
    yield Check(
        seat.part, "oil at the exit", "ISO 7902-1, T_ex", hot.state.exit - CELSIUS, asked.largest_temperature,
        "temperature", at_most=True, exponent=None, symbol="T_ex", place=place, case=cases[hot.case],
    )  # fmt: skip
    yield Check(
        seat.part, "laminar film", "Taylor 1923, 41.3/√ψ", wild.state.reynolds, laminar_limit(journal.clearance),
        "number", at_most=True, exponent=None, symbol="Re", place=place, case=cases[wild.case],
    )  # fmt: skip
    yield Check(
        seat.part, "room in the rim", "rim_thickness_ratio", seat.runs_on.outer_diameter, seat.room, "length",
        at_most=True, exponent=None, place=place,
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Planets with what they turn on: bored for it, and as heavy as ring and bearing together.
# ----------------------------------------------------------------------------------------------------------------------


def fit_planets(context: Context, gears: tuple[GearSizing, ...]) -> tuple[GearSizing, ...]:
    """Return all gears, the planets with the bearings that the design asks for; without any, as they are.

    Args:
        context: What sizing reads.
        gears: As sized, planets as solid discs.

    Raises:
        DesignError: No bearing has room in a planet.
    """
    fitted = {
        task.planet.name: bored(context, task.planet, chosen(task), crown=task.crown) for task in tasks(context, gears)
    }
    for gear in gears:
        stage = context.design.epicyclics.get(gear.stage)
        asked = stage.planets[gear.own].bearing if stage is not None and gear.own in stage.planets else None
        if asked is not None and asked.designation is not None:
            made = on_rollers(asked.kind, as_made(asked, asked.designation), asked.side_by_side)
            fitted[gear.name] = bored(context, gear, made, crown=crown_of(context, gear))
    return tuple(fitted.get(gear.name, gear) for gear in gears)


def bearing_margins(
    context: Context, gears: tuple[GearSizing, ...], fitted: Sequence[GearSizing]
) -> Mapping[str, float]:
    """Return set -> the least of what the bearings of its planets have over what they must have [-].

    Args:
        context: What sizing reads.
        gears: As sized, planets as solid discs.
        fitted: From `fit_planets`.
    """
    found = dict[str, float]()
    by_name = {gear.name: gear for gear in fitted}
    for task in tasks(context, gears):
        if (runs_on := by_name[task.planet.name].runs_on) is not None:
            found[task.planet.stage] = margin(task, runs_on)
    return found
