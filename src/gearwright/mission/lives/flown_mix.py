"""The verb: several missions flown by one gearbox, and what its whole life burns and wears."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from gearwright.catalogue import Bearing
from gearwright.errors import DesignError, Problem
from gearwright.mission.flight import Flight
from gearwright.mission.fly import fly
from gearwright.mission.lives.bearings import FATIGUE
from gearwright.mission.lives.mix import MixedLife, mixed_life
from gearwright.mission.lives.verdict import Durability, PartLife, durability
from gearwright.showing import Shown
from gearwright.sizing import Sizing
from gearwright.spec import Mission, Mix
from gearwright.units import Energy, Mass, Ratio, Time
from gearwright.verbs import verb


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
    rows = next(iter(flown.lives.values())).bearings.rows
    known = {row.seat: row.bearing.designation for row in rows}
    return {part.part: known[part.part] for part in flown.life.parts if part.mode == FATIGUE}
