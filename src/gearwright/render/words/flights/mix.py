"""A life of several missions in words: verdict, missions, parts, fuel and charge."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.mission import FlownMix
from gearwright.mission.lives import bearings_of
from gearwright.ranking import largest
from gearwright.render.tables.mix import mission_table, part_table, shares_of_damage
from gearwright.render.words.flights.flight import count_text
from gearwright.render.words.text import table_text
from gearwright.units import KWH


def mix_text(flown: FlownMix) -> RenderableType:
    """Return a life of several missions for the terminal.

    Args:
        flown: As flown.
    """
    head = f"{flown.mix.name}, flown by {flown.sizing.design.name}"
    tables = [table for table in (mission_table(flown), part_table(flown)) if table.rows]
    last = [totals(flown), *notes(flown)]
    return Group(*map(Text, (head, verdict(flown), "")), *map(table_text, tables), *map(Text, last))


def verdict(flown: FlownMix) -> str:
    """Return whether the gearbox lives all flights, what fails first, and which mission eats most of its life.

    Args:
        flown: As flown.
    """
    parts = flown.life.parts
    partial = flown.life.unrated or any(lived.is_partial for lived in flown.lives.values())
    scope = "of what is rated " if partial else ""
    if not parts or not parts[0].damage:
        return f"Nothing {scope}fails."
    first, shares = parts[0], shares_of_damage(flown, parts[0])
    worst = largest(shares, shares.__getitem__)
    lives = "lives" if flown.damage < 1.0 else "does not live"
    return (
        f"It {lives} all {flown.mix.flights} flights: {scope}{first.name}, {first.mode}, fails first, after"
        f" {count_text(first.flights)} flights or {count_text(first.life)} h (Miner's sum {flown.damage:.3g});"
        f" {worst} eats {100.0 * shares[worst]:.0f} % of its life."
    )


def totals(flown: FlownMix) -> str:
    """Return time, fuel and charge of the whole life.

    Args:
        flown: As flown.
    """
    charge = ""
    if any(flight.has_battery for flight in flown.flights.values()):
        charge = f", {flown.battery / KWH / 1e3:.5g} MWh from the battery"
    worn = [
        flown.mix.count(name) * flight.pack.cycles for name, flight in flown.flights.items() if flight.pack is not None
    ]
    cycles = f", {sum(worn):.4g} full cycles of its cells" if worn else ""
    return (
        f"All {flown.mix.flights} flights: {flown.duration / 3600.0:.0f} h, {flown.fuel / 1e3:.4g} t of fuel"
        f"{charge}{cycles}, of one gearbox"
    )


def notes(flown: FlownMix) -> list[str]:
    """Return which bearings are taken, and what is not rated.

    Args:
        flown: As flown.
    """
    named = ", ".join(f"{seat} {bearing}" for seat, bearing in bearings_of(flown).items())
    lines = [f"Bearings, one for all missions: {named}"] if named else []
    return [*lines, *(f"Note: {note}" for note in not_rated(flown))]


def not_rated(flown: FlownMix) -> list[str]:
    """Return what is not rated in some mission or falls short there, and why.

    Args:
        flown: As flown.
    """
    told = dict[str, list[str]]()
    for name, lived in flown.lives.items():
        for note in lived.notes:
            told.setdefault(note, []).append(name)
    return [*flown.life.unrated, *(f"{', '.join(names)}: {note}" for note, names in told.items())]
