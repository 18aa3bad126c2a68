"""What a flight does, held against what is asked: lives of gears and bearings, room for planets' bearings, charge."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.checks import Check, not_assessed
from gearwright.identity import GEARBOX, Kind, PartId
from gearwright.mission.flight import Flight
from gearwright.mission.lives.bearings import THICKER, BearingDamage
from gearwright.mission.lives.damage import GearDamage
from gearwright.mission.lives.films import film_checks_of
from gearwright.mission.lives.verdict import Durability
from gearwright.parts.bearings import life_exponent
from gearwright.sizing.bearings import planet_bodies, planet_room, speed_factor_check
from gearwright.sizing.rating import method_for, rating_of
from gearwright.spec import Design
from gearwright.spec.design import RATINGS
from gearwright.units import CELSIUS
from gearwright.verbs import verb

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
