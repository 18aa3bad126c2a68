"""Mesh load factors of planetary sets in print: standards by number of planets, and measurements.

The levels of AGMA 6123 are taken where a design states no factor; the others stand beside computed values. The tables
were written down from memory; each row says how sure it is.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.units import Number


@dataclass(frozen=True)
class LoadFactor:
    """One printed or measured mesh load factor."""

    source: str
    """Standard, or authors and year."""
    case: str
    """Class of application, or what was measured."""
    planets: int
    """Number of planets."""
    load_factor: Number
    """K_γ [-]."""
    confidence: str
    """How the number was got."""
    measured: bool
    """True if measured, False if a standard's table."""

    @property
    def name(self) -> str:
        """Source and case."""
        return f"{self.source}, {self.case}"


@cache
def load_factors() -> tuple[LoadFactor, ...]:
    """Return the published mesh load factors, standards before measurements.

    Source:
        IEC 61400-4:2012; ANSI/AGMA 6123-B06, table 7; Guo & Keller, AGMA Fall Technical Meeting 2020.
    """
    return tuple(
        LoadFactor(
            source=row["source"],
            case=row["case"],
            planets=int(row["planets"]),
            load_factor=float(row["load_factor"]),
            confidence=row["confidence"],
            measured=row["kind"] == "measured",
        )
        for row in data_rows("load_factors.csv")
    )


def load_factor_tables() -> Mapping[str, Mapping[int, float]]:
    """Return the standards' tables: name -> number of planets -> K_γ [-]."""
    tables: dict[str, dict[int, float]] = {}
    for row in load_factors():
        if not row.measured:
            tables.setdefault(row.name, {})[row.planets] = row.load_factor
    return tables


LEAST_SHARING = 1.05
"""K_γ of planets that no table goes below here [-]: what tolerances leave of sharing without error, an estimate."""


def level_load_factor(level: int, planets: int) -> float:
    """Return K_γ of planets by a level of AGMA 6123, at least 1.05 [-]; 1 of a single planet.

    Beyond the table it grows as errors do that float does not take up, √((p − 3)/p).

    Args:
        level: 1 to 4.
        planets: Number of planets [-].

    Source:
        ANSI/AGMA 6123-B06, table 7, from memory.

    >>> [level_load_factor(3, planets) for planets in (3, 4, 5, 6)]
    [1.05, 1.15, 1.19, 1.23]
    """
    if planets < 2:
        return 1.0
    table = load_factor_tables()[f"AGMA 6123-B06, level {level}"]
    most = max(table)
    if planets > most:
        spread = math.sqrt((1.0 - 3.0 / planets) / (1.0 - 3.0 / most))
        return 1.0 + (table[most] - 1.0) * spread
    return max(table[planets], LEAST_SHARING)
