"""What a flight does to gears and bearings together: which part fails first, and after how many flights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gearwright.catalogue import Bearing
from gearwright.errors import DesignError
from gearwright.mission.flight import Flight
from gearwright.mission.lives.bearings import FATIGUE, BearingLives, bearing_lives
from gearwright.mission.lives.damage import GearDamage, gear_damage, unrated_stages
from gearwright.ranking import largest_first
from gearwright.showing import Shown
from gearwright.units import Ratio
from gearwright.verbs import verb

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
