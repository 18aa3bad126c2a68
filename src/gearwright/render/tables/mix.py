"""Tables of a life of several missions: what each flies and eats, and how long parts live."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.mission import FlownMix, PartLife
from gearwright.mission.lives import ENDLESS, bearings_of
from gearwright.ranking import largest
from gearwright.render.grid.table import Table, table
from gearwright.units import Life, Mass, Origin, Quantity, Ratio

MOST_ROWS = 12
"""Parts that are shown in words [-]."""
HOUR = 3600.0


@dataclass(frozen=True)
class MissionOfMix:
    """One mission of a life."""

    name: str
    mission: str
    """Name of what is flown."""
    share: Ratio
    """Part of all flights."""
    flights: float
    """In the life."""
    flight_time: Annotated[float, Quantity("flight_time")]
    """Of one flight."""
    fuel: Mass
    """Of one flight and one gearbox."""
    from_battery: Annotated[float, Quantity("electric_energy")]
    """Of one flight and one gearbox."""
    alone: float
    """Flights until the first part fails, were it flown alone; null where nothing is damaged."""
    eats: Ratio
    """Its part of the damage of the part that governs the mix."""


@dataclass(frozen=True)
class PartOfMix:
    """One part and one way to fail, over a life of several missions."""

    part: str
    mode: str
    bearing: str | None
    """Designation; null for gears."""
    damage: Annotated[Ratio, Origin("D = N Σ s_i D_i", "Palmgren 1924, Miner 1945")]
    """Miner's sum after all flights; it fails at 1."""
    flights: float
    """Of the mix until then; null where nothing is damaged."""
    flight_hours: Life
    """Flight time until then; null where nothing is damaged."""
    worst: str
    """Mission with the largest part of the damage."""
    worst_share: Ratio
    """That part."""


def mission_rows(flown: FlownMix) -> tuple[MissionOfMix, ...]:
    """Return the missions of a life.

    Args:
        flown: As flown.
    """
    eaten = shares_of_damage(flown, flown.life.parts[0]) if flown.life.parts else {}
    rows = []
    for name, flight in flown.flights.items():
        parts = flown.lives[name].parts
        rows.append(
            MissionOfMix(
                name=name,
                mission=flight.mission.name,
                share=flown.mix.shares[name],
                flights=flown.mix.count(name),
                flight_time=flight.duration,
                fuel=flight.fuel,
                from_battery=flight.balance.battery,
                alone=parts[0].flights if parts else float("inf"),
                eats=eaten.get(name, 0.0),
            )
        )
    return tuple(rows)


def part_rows(flown: FlownMix) -> tuple[PartOfMix, ...]:
    """Return the parts of a life, the one that governs first.

    Args:
        flown: As flown.
    """
    bearings, rows = bearings_of(flown), []
    for part in flown.life.parts:
        shares = shares_of_damage(flown, part)
        worst = largest(shares, shares.__getitem__)
        rows.append(
            PartOfMix(
                part=part.part,
                mode=part.mode,
                bearing=bearings.get(part.part) if part.is_bearing else None,
                damage=part.damage * flown.mix.flights,
                flights=part.flights,
                flight_hours=part.life * HOUR,
                worst=worst if part.damage else "",
                worst_share=shares[worst],
            )
        )
    return tuple(rows)


def shares_of_damage(flown: FlownMix, part: PartLife) -> dict[str, float]:
    """Return mission -> its part of the damage of a part [-]; what is damaged without bound shares it equally.

    Args:
        flown: As flown.
        part: One of the parts of its life.
    """
    damages = flown.damage_by_mission(part)
    endless = [name for name, damage in damages.items() if damage == float("inf")]
    if endless:
        return {name: (name in endless) / len(endless) for name in damages}
    whole = sum(damages.values())
    return {name: damage / whole if whole else 0.0 for name, damage in damages.items()}


def mission_table(flown: FlownMix) -> Table:
    """Return what each mission of a life flies, burns and eats.

    Args:
        flown: As flown.
    """
    names = ("name", "flights", "flight_time", "fuel", "from_battery", "alone", "eats")
    note = (
        "Fuel and energy from the battery are of one flight and one gearbox; alone: flights until the first part fails"
        " if nothing else is flown; eats: its part of the damage of the part that fails first."
    )
    return table("Missions", mission_rows(flown), names, note=note)


def part_table(flown: FlownMix) -> Table:
    """Return how long parts live, the one that governs first.

    Args:
        flown: As flown.
    """
    failing = [row for row in part_rows(flown) if row.flights < ENDLESS]
    more = len(flown.life.parts) - len(failing[:MOST_ROWS])
    note = f"{more} other ways to fail take longer." if more else ""
    names = ("part", "mode", "damage", "flights", "flight_hours", "worst", "worst_share")
    return table("Lives over the mix", failing[:MOST_ROWS], names, note=note)
