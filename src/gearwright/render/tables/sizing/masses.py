"""The complete mass of a sizing as tables: its groups with the sum and its band, and every part with its origin."""

from __future__ import annotations

from gearwright.render.grid.table import Table, table
from gearwright.sizing import Sizing
from gearwright.sizing.mass import CompleteMass, Statistics, complete_mass, statistics_beside
from gearwright.units import text


def mass_tables(sizing: Sizing) -> dict[str, Table]:
    """Return the tables of the complete mass, by a short name.

    Args:
        sizing: As sized.
    """
    mass = complete_mass(sizing)
    return {
        "complete_mass": table(
            "Complete mass", mass.groups, ("group", "total", "share", "deviation"), note=sum_sentence(sizing, mass)
        ),
        "mass_parts": table(
            "Complete mass, part by part", mass.parts,
            ("part", "group", "count", "each", "total", "uncertainty", "formula", "source"),
        ),
    }  # fmt: skip


def sum_sentence(sizing: Sizing, mass: CompleteMass) -> str:
    """Return the sum with its band, and how it stands to the statistics.

    Args:
        sizing: As sized.
        mass: Its complete mass.
    """
    return mass_sentence(mass, statistics_beside(sizing, mass))


def mass_sentence(mass: CompleteMass, statistics: Statistics) -> str:
    """Return the sum of all parts with its band, and how it stands to the statistics.

    Args:
        mass: Complete mass.
        statistics: Of real gearboxes of the same power and speeds.
    """
    return f"Sum {with_band(mass)}; machines are not in it. {statistics.sentence}"


def with_band(mass: CompleteMass) -> str:
    """Return a complete mass in words, with its band and what the train is of it.

    Args:
        mass: Complete mass.
    """
    low, high = (text(limit, "mass", 3) for limit in mass.band)
    train = f", of it gears, shafts and carriers {text(mass.train, 'mass', 3)}" if mass.train else ""
    return f"{text(mass.total, 'mass', 3)}, 68 % from {low} to {high}{train}"
