"""A life of several missions as one self-contained HTML page, in the style of a flight's."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.mission import FlownMix
from gearwright.render.figures.flights.flight import power_figure, profile_figure
from gearwright.render.figures.flights.lives import life_figure, spectrum_figure
from gearwright.render.figures.flights.mix import eaten_figure
from gearwright.render.pages.page import (
    UNSTAMPED,
    Number,
    Page,
    Section,
    Stamp,
    Tone,
    Verdict,
    figure,
    quantity,
    set_page,
)
from gearwright.render.tables.flight import forces_table, phase_table
from gearwright.render.tables.mix import mission_table, part_table
from gearwright.render.words.flights.flight import count_text
from gearwright.render.words.flights.mix import notes, totals, verdict
from gearwright.units import Origin, digits_apart, written


def mix_page(flown: FlownMix, *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        flown: As flown.
        stamp: Date of the page.
    """
    sections = (_life(flown), *(_mission(flown, name) for name in flown.flights))
    title = f"{flown.mix.name}: {flown.sizing.design.name}"
    return set_page(
        Page("Life of several missions", title, flown.mix.description, _verdict(flown), tuple(_numbers(flown)),
             sections, design=flown.sizing.design, stamp=stamp)
    )  # fmt: skip


def _verdict(flown: FlownMix) -> Verdict:
    """Return whether it lives all flights; what is not rated leaves it open."""
    if flown.damage >= 1.0:
        return Verdict(Tone.BAD, "Does not live", verdict(flown))
    partial = bool(flown.life.unrated) or any(lived.is_partial for lived in flown.lives.values())
    tone, word = (Tone.OPEN, "Lives as far as rated") if partial else (Tone.GOOD, "Lives all flights")
    return Verdict(tone, word, verdict(flown))


def _numbers(flown: FlownMix) -> Iterator[Number]:
    if flown.life.parts and flown.life.parts[0].damage:
        first = flown.life.parts[0]
        yield Number(f"first to fail: {first.name}", f"{count_text(first.flights)} flights")
        miner = Origin("D = Σ n_i/N_i", "Palmgren 1924, Miner 1945")
        yield Number(
            "Miner's sum", written(flown.damage, digits_apart(flown.damage, 1.0, 3)), value=flown.damage, origin=miner
        )
    yield Number("flights", f"{flown.mix.flights}")
    yield quantity("flight time", flown.duration, "life")
    yield quantity("fuel of one gearbox", flown.fuel, "mass")
    if any(flight.has_battery for flight in flown.flights.values()):
        yield quantity("from the battery", flown.battery, "electric_energy")


def _life(flown: FlownMix) -> Section:
    """Return what the whole life comes to."""
    tables = tuple(table for table in (mission_table(flown), part_table(flown)) if table.rows)
    drawn = figure(eaten_figure(flown), "eaten", "Which mission eats the life of a part, by Palmgren and Miner.")
    words = (f"{totals(flown)}.", *(f"{note}." for note in notes(flown)))
    return Section("The whole life", tables=tables, figures=(drawn,), notes=words)


def _mission(flown: FlownMix, name: str) -> Section:
    """Return one flight of a mission: what it does, what it loads, what it wears."""
    flight, lived, count = flown.flights[name], flown.lives[name], flown.mix.count(name)
    figures = [
        figure(profile_figure(flight), f"{name}-profile", f"{name}: phases and who drives in them."),
        figure(power_figure(flight), f"{name}-power", f"{name}: powers of the machines and torques of the shafts."),
        figure(spectrum_figure(flight), f"{name}-spectrum", f"{name}: turns at which a load is reached, one flight."),
    ]
    if lived.failing:
        figures.append(figure(life_figure(lived), f"{name}-lives", f"{name}: flights that parts live, flown alone."))
    forces = forces_table(flight)
    words = f"{flight.mission.name}, {count:g} of {flown.mix.flights} flights. {flight.mission.description}"
    return Section(
        name, tables=(phase_table(flight), *([forces] if forces else ())), figures=tuple(figures), notes=(words,)
    )
