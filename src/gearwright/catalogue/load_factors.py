"""Mesh load factors of planetary sets in print: standards by number of planets, and measurements.

They serve as a view beside computed values. No rule of gearwright reads them, as the tables were written down from
memory; each row says how sure it is.
"""

from __future__ import annotations

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
