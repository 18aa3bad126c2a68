"""Engine decks as CSV files: read, checked, written."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

from gearwright.air import air_at, stagnation_ratios
from gearwright.errors import Problem, refuse
from gearwright.machines.engine_deck import DeckLine, EngineDeck
from gearwright.reading import numbers_of, text_of

COLUMNS = ("altitude_m", "mach", "power_kw", "fuel_kg_h")
"""What a deck's CSV file has: at every altitude and Mach number of a grid the powers of some positions of the lever."""
LARGEST_DECK = 20_000_000
"""Largest file that is read [bytes]."""
_HOUR = 3600.0
_SENSIBLE: Mapping[str, tuple[float, float]] = {
    "altitude_m": (-1000.0, 20e3), "mach": (0.0, 0.999), "power_kw": (0.0, 1e6), "fuel_kg_h": (0.0, 1e6),
}  # fmt: skip
"""Column -> range of what it can be."""


class _Row(NamedTuple):
    line: int
    """Of the file; 0: none."""
    altitude: float
    mach: float
    power: float
    """[W]"""
    fuel: float
    """[kg/s]"""


def read_engine_deck(path: str | Path) -> EngineDeck:
    """Return an engine's deck from a CSV file.

    Args:
        path: Of the file, with the columns altitude_m, mach, power_kw, fuel_kg_h, for a standard day.

    Raises:
        DesignError: The file is missing or is no such deck; with every line that is wrong.
    """
    text = text_of(path, "engine.deck", largest=LARGEST_DECK)
    try:
        numbers = numbers_of(text, COLUMNS)
    except ValueError as error:
        refuse([Problem("engine.deck", f"{path}: {error}")])
    refuse([Problem("engine.deck", f"{path}: {reason}") for reason in _outside(numbers)])
    rows = [_Row(line, h, m, 1e3 * p, w / _HOUR) for line, (h, m, p, w) in enumerate(numbers, start=2)]
    refuse([Problem("engine.deck", f"{path}: {reason}") for reason in _wrong(rows)])
    return deck_of(row[1:] for row in rows)


def deck_of(rows: Iterable[tuple[float, float, float, float]]) -> EngineDeck:
    """Return a deck of rows that are known to be one.

    Args:
        rows: Altitude [m], Mach number [-], power [W], fuel [kg/s], in any order.

    Source: P and m_f over δ_t √θ_t of the standard day.
    """
    known = sorted(rows)
    altitudes, machs = sorted({row[0] for row in known}), sorted({row[1] for row in known})
    lines = tuple(tuple(_line(known, h, m) for m in machs) for h in altitudes)
    return EngineDeck(tuple(altitudes), tuple(machs), lines)


def _line(rows: list[tuple[float, float, float, float]], altitude: float, mach: float) -> DeckLine:
    theta, delta = stagnation_ratios(air_at(altitude), mach)
    factor = delta * math.sqrt(theta)
    here = [row for row in rows if row[:2] == (altitude, mach)]
    return DeckLine(tuple(row[2] / factor for row in here), tuple(row[3] / factor for row in here))


def deck_text(deck: EngineDeck) -> str:
    """Return a deck as the text of a CSV file, to be read by `read_engine_deck`.

    Args:
        deck: As read or made.
    """
    lines = [",".join(COLUMNS)]
    for altitude, row in zip(deck.altitude, deck.lines, strict=True):
        for mach, line in zip(deck.mach, row, strict=True):
            theta, delta = stagnation_ratios(air_at(altitude), mach)
            factor = delta * math.sqrt(theta)
            lines += [
                f"{altitude:g},{mach:g},{1e-3 * factor * power:.6g},{_HOUR * factor * fuel:.6g}"
                for power, fuel in zip(line.power, line.fuel, strict=True)
            ]
    return "\n".join(lines) + "\n"


def _outside(numbers: list[list[float]]) -> Iterator[str]:
    for line, row in enumerate(numbers, start=2):
        for value, name in zip(row, COLUMNS, strict=True):
            low, high = _SENSIBLE[name]
            if not low <= value <= high:
                yield f"line {line}: {name} is {value:g}; give one from {low:g} to {high:g}"


def _wrong(rows: list[_Row]) -> Iterator[str]:
    """Yield what makes rows no deck: holes of the grid, too few powers, powers given twice, fuel that falls."""
    if not rows:
        yield "it has no rows; give powers at every altitude and Mach number"
    altitudes, machs = sorted({row.altitude for row in rows}), sorted({row.mach for row in rows})
    for altitude in altitudes:
        for mach in machs:
            here = sorted((row for row in rows if row[1:3] == (altitude, mach)), key=lambda row: row.power)
            place = f"at {altitude:g} m and Mach {mach:g}"
            if len(here) < 2:
                yield f"{place} it has {len(here)} powers; give two at least at every altitude and Mach number"
            for one, other in pairwise(here):
                if one.power == other.power:
                    yield f"line {other.line}: {place} {1e-3 * other.power:g} kW is given twice; take one out"
                elif other.fuel <= one.fuel:
                    rises = f"{1e-3 * other.power:g} kW burn no more than {1e-3 * one.power:g} kW"
                    yield f"line {other.line}: {place} {rises}; fuel must rise with the power"
