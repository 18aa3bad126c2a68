"""Answer about a life of several missions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from gearwright.mission import FlownMix
from gearwright.render.tables.mix import MissionOfMix, PartOfMix, mission_rows, part_rows
from gearwright.render.words.flights.mix import not_rated, verdict
from gearwright.units import Life, Mass, Quantity, Ratio


@dataclass(frozen=True)
class MixAnswer:
    """A life of several missions, of one gearbox."""

    mix: str
    verdict: str
    """In words."""
    flights: int
    """Of the whole life."""
    life: Life
    """Flight time of all flights."""
    fuel: Mass
    """Of all flights."""
    from_battery: Annotated[float, Quantity("electric_energy")]
    """Of all flights, what is charged in flight taken off."""
    damage: Ratio
    """Largest Miner's sum of any part after all flights; it fails at 1."""
    missions: tuple[MissionOfMix, ...]
    parts: tuple[PartOfMix, ...]
    """The one that governs first."""
    damage_by_mission: Mapping[str, Mapping[str, Ratio]]
    """Part and way to fail -> mission -> Miner's sum after all its flights."""
    not_rated: tuple[str, ...]
    """What is not rated in some mission or falls short there, and why."""


def mix_answer(flown: FlownMix) -> MixAnswer:
    """Return what `gearwright mix --json` answers.

    Args:
        flown: As flown.
    """
    return MixAnswer(
        mix=flown.mix.name,
        verdict=verdict(flown),
        flights=flown.mix.flights,
        life=flown.duration,
        fuel=flown.fuel,
        from_battery=flown.battery,
        damage=flown.damage,
        missions=mission_rows(flown),
        parts=part_rows(flown),
        damage_by_mission={f"{part.name}, {part.mode}": flown.damage_by_mission(part) for part in flown.life.parts},
        not_rated=tuple(not_rated(flown)),
    )
