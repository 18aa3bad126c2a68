"""Service life of gears and bearings over a mission or a mission mix, its checks, and sizing for it."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from gearwright.base import (
    CELSIUS,
    GEARBOX,
    Check,
    DesignError,
    Energy,
    Kind,
    Mass,
    PartId,
    Problem,
    Ratio,
    Shown,
    SolveError,
    Time,
    largest_first,
    not_assessed,
    refuse,
    verb,
)
from gearwright.catalogue import Bearing
from gearwright.mission.flight import Flight
from gearwright.mission.fly import fly
from gearwright.mission.lives.bearings import FATIGUE, THICKER, BearingDamage, BearingLives, bearing_lives
from gearwright.mission.lives.damage import GearDamage, film_checks_of, gear_damage, unrated_stages
from gearwright.parts.bearings import life_exponent
from gearwright.sizing import Sizing, size
from gearwright.sizing.bearing_seats import planet_bodies, planet_room
from gearwright.sizing.bearings import speed_factor_check
from gearwright.sizing.rating import method_for, rating_of
from gearwright.spec import Design, GearRules, Mission, Mix, Record
from gearwright.spec.design import RATINGS

# ----------------------------------------------------------------------------------------------------------------------
# What a flight does to gears and bearings together: which part fails first, and after how many flights.
# ----------------------------------------------------------------------------------------------------------------------


ENDLESS = 1e7
"""Flights beyond which a part does not fail for any practical purpose [-]."""


@dataclass(frozen=True)
class PartLife:
    """One part and one way to fail."""

    part: str
    """Such as ``second.planet``; a bearing is named by its seat."""
    mode: str
    """pitting, bending or rolling fatigue."""
    damage: Ratio
    """Miner's sum of one flight [-]."""
    flights: float
    """Until the sum is 1; ∞ where nothing is damaged [-]."""
    life: float
    """Flight hours until then [h]."""

    @property
    def is_bearing(self) -> bool:
        """True for rolling bearings."""
        return self.mode == FATIGUE

    @property
    def name(self) -> str:
        """In words, so that a planet and its bearing differ."""
        return f"bearing of {self.part}" if self.is_bearing else self.part


@dataclass(frozen=True, repr=False)
class Durability(Shown):
    """Lives of all parts over a flight."""

    gears: tuple[GearDamage, ...]
    """The worst first; empty where ISO 6336 does not cover the teeth."""
    bearings: BearingLives
    """Of the seats whose load is known."""
    notes: tuple[str, ...]
    """What is not rated, and why."""

    @property
    def is_partial(self) -> bool:
        """True where a gear or a bearing under load is not rated: then it may be the first to fail."""
        return bool(self.bearings.unrated) or len(self.notes) > len(self.bearings.notes)

    @property
    def parts(self) -> tuple[PartLife, ...]:
        """Every part and every way to fail, the one that governs first."""
        rows = [PartLife(gear.gear, gear.mode, gear.damage, gear.flights, gear.life) for gear in self.gears]
        rows += [PartLife(row.seat, FATIGUE, row.damage, row.flights, row.life) for row in self.bearings.rows]
        return tuple(largest_first(rows, lambda row: row.damage))

    @property
    def failing(self) -> tuple[PartLife, ...]:
        """The parts and ways to fail that end within `ENDLESS` flights, the one that governs first."""
        return tuple(row for row in self.parts if row.flights < ENDLESS)


@verb
def durability(flight: Flight, *, bearings: Mapping[str, Bearing] | None = None) -> Durability:
    """Return what a flight does to the gears and bearings that can be rated, and what cannot.

    Args:
        flight: As flown.
        bearings: Seat -> bearing that is taken where the mission asks for one; left out: the lightest that does.

    Source: `gear_damage` and `bearing_lives`.

    Raises:
        DesignError: A bearing that the design names does not fit its seat, or cannot bear its kind of load.
    """
    seated = bearing_lives(flight, chosen=bearings)
    notes = [
        f"{stage}: {flight.sizing.design.pairs[stage].kind} gears; ISO 6336 rates cylindrical gears only"
        for stage in unrated_stages(flight.sizing.design)
    ]
    try:
        gears = gear_damage(flight)
    except DesignError as error:  # the flight is good without a rating; say why there is none
        gears, notes = (), notes + [f"{problem.path}: {problem.message}" for problem in error.problems]
    return Durability(gears, seated, (*notes, *seated.notes))


# ----------------------------------------------------------------------------------------------------------------------
# What a flight does, held against what is asked: lives of gears and bearings, room for planets' bearings, charge.
# ----------------------------------------------------------------------------------------------------------------------


HOUR = 3600.0
"""[s]"""


@verb
def flight_checks(flight: Flight, lives: Durability, *, life: float | None = None) -> tuple[Check, ...]:
    """Return every judgement of a flight, and what it leaves open.

    Args:
        flight: As flown.
        lives: Of its gears and bearings, from `durability`.
        life: Of gears, where another one is asked than the design's [s].
    """
    asked = life or flight.sizing.design.service.life
    checks = [_gear(flight, gear, asked) for gear in lives.gears]
    for row in lives.bearings.rows:
        checks += [*_bearing(flight, row), *_room(flight, row)]
    return (*checks, *film_checks_of(flight), *_oil(flight), *_charge(flight), *_open(lives))


def _oil(flight: Flight) -> Iterator[Check]:
    """Yield the warmest oil of a flight beside the one that teeth, films and modified lives are rated with.

    Where temperatures are followed, teeth are judged with the oil of every interval (`film_checks_of`), not by this.
    """
    followed = flight.history.oil_temperature is not None
    if rated := [*oil_rated(flight.sizing.design), *([] if followed else teeth_rated(flight.sizing.design))]:
        warm = flight.hottest_supply
        limit, clause = min(rated) + CELSIUS, "as rated: [oil] and gears.iso6336.oil_temperature"
        yield Check(
            GEARBOX, "oil temperature", clause, warm, limit, "absolute_temperature", at_most=True, exponent=None
        )
    else:
        why = "nothing limits it: flow and cooler are taken as large as the heat asks"
        yield not_assessed(GEARBOX, "oil temperature", "heat balance", why)


def teeth_rated(design: Design) -> list[float]:
    """Return the temperatures of the oil that scuffing and micropitting of a design count on [°C].

    Args:
        design: With its rules.
    """
    rated = [stage for stage in design.stages if RATINGS[design.rating(stage)].table == "iso6336"]
    return [design.rules(stage).iso6336.oil_temperature for stage in rated]


def oil_rated(design: Design) -> list[float]:
    """Return the temperatures of the oil that films in planets and modified lives count on [°C]; empty without them.

    Args:
        design: With its rules.
    """
    films = [row.planet_bearing for row in design.planetaries.values() if row.planet_bearing is not None]
    own = [film.oil_temperature for film in films if film.kind == "plain"]
    warmths = [design.oil.temperature if warmth is None else warmth for warmth in own]
    return warmths + ([] if design.bearing_rules.life == "basic" else [design.oil.temperature])


def _charge(flight: Flight) -> Iterator[Check]:
    """Yield the least charge of the battery, where there is one."""
    if flight.has_battery and flight.mission.battery is not None:
        minimum, charge = flight.mission.battery.minimum_charge, float(flight.history.state_of_charge.min())
        part, clause = PartId(Kind.BATTERY, "battery"), "minimum_charge of the mission"
        yield Check(part, "charge", clause, charge, minimum, exponent=None)


def _gear(flight: Flight, gear: GearDamage, asked: float) -> Check:
    """Return a gear's life; safeties against stresses count as they are, so its root is that of the S-N curve."""
    part = flight.sizing.train.gear(gear.gear).part
    rating = rating_of(flight.sizing.design, part.name)
    method = method_for(rating)
    slope = method.life_slope(rating, gear.mode, flight.mission.gears)
    return Check(part, f"{gear.mode} life", method.life_source, gear.life * HOUR, asked, "life", exponent=slope)


def _bearing(flight: Flight, row: BearingDamage) -> Iterator[Check]:
    """Yield life and static safety, against what chose the bearing, or what the design asks of one that it names."""
    service = flight.sizing.design.service
    sized = next((sized for sized in flight.sizing.bearings if sized.name == row.seat), None)
    life = service.bearing_life if sized is None else sized.wanted_life
    static = service.static_safety if sized is None else sized.wanted_static_safety
    life = life if row.asked is None else row.asked * HOUR
    static = static if row.asked_static_safety is None else row.asked_static_safety
    part, place, oiled = PartId(Kind.BEARING, row.seat), row.bearing.designation, row.life_factor is not None
    yield Check(
        part, "bearing life", "ISO 281:2007, Miner", row.life * HOUR, life, "life",
        exponent=None if oiled else life_exponent(row.bearing.kind), symbol="L_nmh" if oiled else "L_10h", place=place,
        why=THICKER if row.falls_short and row.holds_shaft else "",
    )  # fmt: skip
    yield Check(part, "bearing static safety", "ISO 76:2006", row.static_safety, static, symbol="s_0", place=place)
    if row.asked is not None:  # sizing has judged those with a name
        yield speed_factor_check(part, row.bearing, row.speed_factor, flight.sizing.design)


def _room(flight: Flight, row: BearingDamage) -> Iterator[Check]:
    """Yield whether a bearing that was chosen for a planet has room in it; sizing has judged those with a name."""
    bodies = planet_bodies(flight.sizing.design, flight.sizing.gears)
    body = next((body for body in bodies if str(body.part) == row.seat), None)
    if body is not None and row.asked is not None:
        width = row.count // body.steps[0].bodies * row.bearing.width
        yield planet_room(body, row.bearing.designation, width)


def _open(lives: Durability) -> Iterator[Check]:
    """Yield what of gears and bearings a flight does not rate."""
    for note in lives.notes[: len(lives.notes) - len(lives.bearings.notes)]:
        yield not_assessed(GEARBOX, "gear lives", "Miner, ISO 6336-6", note)
    for note in lives.bearings.loose:
        yield not_assessed(GEARBOX, "thrust on bearings", "equilibrium", note)
    for seat in lives.bearings.unrated:
        why = "no bearing is named that can be rated, and none could be chosen: [bearings] of the design or the mission"
        yield not_assessed(PartId(Kind.BEARING, seat), "bearing life", "ISO 281:2007", why)


# ----------------------------------------------------------------------------------------------------------------------
# A life asked for: size, fly, strengthen the stage that fails first, until every gear lives long enough.
# ----------------------------------------------------------------------------------------------------------------------


STRENGTHENING = 1.04
"""Factor on the safety factor that governs, in each round [-]."""
MOST_ROUNDS = 200
"""Rounds after which a target counts as out of reach [-]."""


@dataclass(frozen=True, repr=False)
class LifeSizing(Shown):
    """A design strengthened until it lives."""

    sizing: Sizing
    flight: Flight
    damages: tuple[GearDamage, ...]
    """Of the strengthened gears, the worst first."""
    hours: float
    """Life that was asked for [h]."""
    path: tuple[tuple[float, Mass], ...]
    """Life [h] of the gear that fails first and mass of the gearbox [kg], before every round and at the end."""
    bearings_before: Mass
    """Of the bearings that the mission asks for without this life [kg]."""
    bearings: BearingLives
    """Chosen for this life, where the mission asks for bearings."""

    @property
    def mass_before(self) -> Mass:
        """Of the gearbox as the design asked [kg]."""
        return self.path[0][1]

    @property
    def rounds(self) -> int:
        """How often a stage was strengthened [-]."""
        return len(self.path) - 1

    @property
    def mass_of_life(self) -> Mass:
        """What the life costs in gears, shafts and carriers [kg]."""
        return self.sizing.mass - self.mass_before


@verb
def size_for_life(design: Design, mission: Mission, hours: float, *, folder: Path | None = None) -> LifeSizing:
    """Return a design's sizing with which every gear lives a number of flight hours of a mission.

    The stage of the gear that fails first gets a larger safety factor, in bending or in contact as it fails, and the
    design is sized again. Torques hardly depend on sizes, so a flight is flown again only where teeth have changed, and
    once at the end.

    Args:
        design: As read.
        mission: What is flown.
        hours: Life that is asked for, of flight hours [h].
        folder: Where a propeller map is looked for that is a file.

    Source: Miner 1945, sum 1 at the end of the life, by the method of each stage as in `gear_damage`.

    Raises:
        SolveError: No strengthening reaches the life.
        DesignError: The mission cannot be flown, or ISO 6336 does not rate its gears.
    """
    if unrated_stages(design):
        stage = unrated_stages(design)[0]
        message = f"stage {stage} has {design.pairs[stage].kind} gears; no standard rates their damage"
        raise DesignError([Problem("life", f"{message}, so that no life can be asked of it")])
    sizing = size(design)
    flight = fly(sizing, mission, folder=folder)
    before, lasting, path = bearing_lives(flight).mass, _lasting(mission, hours), []
    for _ in range(MOST_ROUNDS):
        worst = gear_damage(flight)[0]
        path.append((worst.life, sizing.mass))
        if worst.life >= hours:
            flight = fly(sizing, lasting, folder=folder)
            damages = gear_damage(flight)
            if damages[0].life >= hours:
                return LifeSizing(sizing, flight, damages, hours, tuple(path), before, bearing_lives(flight))
            worst = damages[0]
        design = strengthened(design, worst)
        teeth, sizing = sizing.teeth, size(design)
        flight = replace(flight, sizing=sizing) if sizing.teeth == teeth else fly(sizing, mission, folder=folder)
    message = f"{worst.gear} reaches {worst.life:.0f} h of {hours:.0f} h after {MOST_ROUNDS} rounds; ask for less"
    raise SolveError(f"life: {message}, or take a better steel under [gears] of the mission")


def _lasting(mission: Mission, hours: float) -> Mission:
    """Return a mission whose bearings are chosen for a life."""
    if mission.bearings is None:
        return mission
    return mission.model_copy(update={"bearings": mission.bearings.model_copy(update={"life": 3600.0 * hours})})


def strengthened(design: Design, worst: GearDamage) -> Design:
    """Return a design whose weakest stage has a larger safety factor.

    Args:
        design: As it is.
        worst: The gear that fails first.
    """
    stage = worst.part.name
    path = method_for(rating_of(design, stage)).safeties[worst.mode]
    stronger = _raised(design.stages[stage].gears or GearRules(), design.rules(stage), path)
    table = design.kind(stage)
    stages = dict(getattr(design, table))
    stages[stage] = stages[stage].model_copy(update={"gears": stronger})
    return design.model_copy(update={table: stages})


def _raised(own: Record, rules: Record, path: tuple[str, ...]) -> Record:
    """Return a stage's own rules with a safety factor above the one that holds for it."""
    name, *rest = path
    held = getattr(rules, name)
    raised = _raised(getattr(own, name), held, tuple(rest)) if rest else held * STRENGTHENING
    return own.model_copy(update={name: raised})


# ----------------------------------------------------------------------------------------------------------------------
# A life of several missions: how often each is flown, and when the first part fails.
# ----------------------------------------------------------------------------------------------------------------------


_WHOLE = 1e-9
"""By how much shares may miss 1: rounding [-]."""


@dataclass(frozen=True)
class MixedLife:
    """What a mix of missions does to the parts that are rated in all of them."""

    parts: tuple[PartLife, ...]
    """Of a mean flight, the one that governs first."""
    hours: float
    """Of a mean flight [h]."""
    unrated: tuple[str, ...]
    """Parts that some missions rate and others do not: with ways to fail, and where they are missing."""

    def damage_after(self, flights: float) -> Ratio:
        """Return the largest Miner's sum of any part after a number of flights [-]; it fails at 1.

        Args:
            flights: Of the mix [-].
        """
        return max((part.damage for part in self.parts), default=0.0) * flights


@verb
def mixed_life(lives: Mapping[str, Durability], shares: Mapping[str, float]) -> MixedLife:
    """Return the lives of parts over a mix of missions.

    Args:
        lives: Mission -> what one flight of it does, from `durability`, of one and the same design.
        shares: Mission -> part of all flights that are of this kind, with sum 1 [-].

    Source: Palmgren 1924, Miner 1945: Σ n/N over all flights, whatever their order.

    Raises:
        DesignError: Shares that are negative, do not add up to 1 or name other missions; a seat whose bearing differs.
    """
    refuse(_problems(lives, shares), "mix")
    sums: dict[tuple[str, str], dict[str, float]] = {}
    for mission, lived in lives.items():
        for part in lived.parts:
            sums.setdefault((part.part, part.mode), {})[mission] = part.damage
    hours = sum(shares[mission] * _hours(lived) for mission, lived in lives.items())
    whole = {key: found for key, found in sums.items() if len(found) == len(lives)}
    rows = []
    for (name, mode), found in whole.items():
        damage = sum(shares[mission] * value for mission, value in found.items() if shares[mission])
        flights = 1.0 / damage if damage > 0.0 else math.inf
        rows.append(PartLife(name, mode, damage, flights, flights * hours))
    left = [
        f"{name}, {mode}: not rated in {', '.join(mission for mission in lives if mission not in found)}"
        for (name, mode), found in sums.items()
        if len(found) < len(lives)
    ]
    return MixedLife(tuple(largest_first(rows, lambda row: row.damage)), hours, tuple(left))


def _hours(lived: Durability) -> float:
    """Return how long a flight lasts [h]."""
    hours = [row.hours for row in lived.gears] + [row.hours for row in lived.bearings.rows]
    return hours[0] if hours else 0.0


def _problems(lives: Mapping[str, Durability], shares: Mapping[str, float]) -> list[Problem]:
    problems = [
        Problem(name, "has a share and is not flown; leave it out, or fly it") for name in shares.keys() - lives
    ]
    problems += [Problem(name, "is flown and has no share; give it one") for name in lives if name not in shares]
    problems += [
        Problem(name, f"{share:g}; a share is a part of all flights, from 0 to 1")
        for name, share in shares.items()
        if not 0.0 <= share <= 1.0
    ]
    total = sum(shares.values())
    if not problems and abs(total - 1.0) > _WHOLE:
        problems.append(Problem("shares", f"{total:g}; they have to add up to 1"))
    chosen: dict[str, set[str]] = {}
    for lived in lives.values():
        for row in lived.bearings.rows:
            chosen.setdefault(row.seat, set()).add(row.bearing.designation)
    problems += [
        Problem(seat, f"{' or '.join(sorted(names))}: missions choose other bearings; name one in the design")
        for seat, names in chosen.items()
        if len(names) > 1
    ]
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# The verb: several missions flown by one gearbox, and what its whole life burns and wears.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, repr=False)
class FlownMix(Shown):
    """A life of one gearbox over the missions of a mix."""

    mix: Mix
    sizing: Sizing
    flights: Mapping[str, Flight]
    """One of each mission."""
    lives: Mapping[str, Durability]
    """What one flight of each mission does."""
    life: MixedLife
    """Miner's sums over the mix."""

    @property
    def duration(self) -> Time:
        """Of all flights [s]."""
        return sum(self.mix.count(name) * flight.duration for name, flight in self.flights.items())

    @property
    def fuel(self) -> Mass:
        """Burnt by one gearbox's turbines in all flights [kg]."""
        return sum(self.mix.count(name) * flight.fuel for name, flight in self.flights.items())

    @property
    def battery(self) -> Energy:
        """Taken from the battery's store in all flights, what is charged in flight taken off [J]."""
        return sum(self.mix.count(name) * flight.balance.battery for name, flight in self.flights.items())

    @property
    def damage(self) -> Ratio:
        """Largest Miner's sum of any part after all flights [-]; it fails at 1."""
        return self.life.damage_after(self.mix.flights)

    def damage_by_mission(self, part: PartLife) -> dict[str, Ratio]:
        """Return Miner's sum of a part after all flights, mission by mission [-].

        Args:
            part: One of the parts of `life`.
        """
        found = {}
        for name, lived in self.lives.items():
            of_one = next(row.damage for row in lived.parts if (row.part, row.mode) == (part.part, part.mode))
            found[name] = self.mix.count(name) * of_one
        return found


@verb
def fly_mix(sizing: Sizing, mix: Mix) -> FlownMix:
    """Return what a life of several missions burns and wears, and which of them eats the life.

    Where missions ask for bearings, a seat has one bearing for all of them: of those that the missions choose alone,
    the one with the largest rating. Each mission then leaves it the life that is asked, and so does their mix.

    Args:
        sizing: The sized transmission; it has one propeller.
        mix: Missions and how often each is flown.

    Source: Palmgren 1924, Miner 1945: Σ n/N over all flights, whatever their order.

    Raises:
        DesignError: A mission that the design cannot fly, by its name in the mix.
    """
    flights = {name: _flown(sizing, mission, name) for name, mission in mix.missions.items()}
    lives = {name: durability(flight) for name, flight in flights.items()}
    shared = _largest(lives)
    if any(row.bearing != shared[row.seat] for lived in lives.values() for row in lived.bearings.rows):
        lives = {name: durability(flight, bearings=shared) for name, flight in flights.items()}
    return FlownMix(mix, sizing, flights, lives, mixed_life(lives, mix.shares))


def _flown(sizing: Sizing, mission: Mission, name: str) -> Flight:
    try:
        return fly(sizing, mission, folder=Path())
    except DesignError as error:
        told = (f"{problem.path}: {problem.message}" for problem in error.problems)
        raise DesignError([Problem(f"missions.{name}", words) for words in told]) from None


def _largest(lives: Mapping[str, Durability]) -> dict[str, Bearing]:
    """Return seat -> the bearing with the largest dynamic rating of those that the missions choose."""
    found: dict[str, Bearing] = {}
    for row in (row for lived in lives.values() for row in lived.bearings.rows):
        known = found.get(row.seat, row.bearing)
        found[row.seat] = max(known, row.bearing, key=lambda bearing: bearing.dynamic_rating)
    return found


def bearings_of(flown: FlownMix) -> dict[str, str]:
    """Return part -> designation of the bearing, for parts that are bearings.

    Args:
        flown: As flown.
    """
    known = {row.seat: row.bearing.designation for row in next(iter(flown.lives.values())).bearings.rows}
    return {part.part: known[part.part] for part in flown.life.parts if part.mode == FATIGUE}
