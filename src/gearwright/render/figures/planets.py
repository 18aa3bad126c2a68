"""K_γ against the number of planets: random sets, one pin in closed form, and what standards and tests say."""

from __future__ import annotations

from collections.abc import Mapping

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.catalogue import load_factor_tables, load_factors
from gearwright.dynamics.sharing import PlanetCounts
from gearwright.render.figures.sharing import load_factor_figure
from gearwright.render.grid.grid import Grid
from gearwright.render.vector.figure import Figure

PERCENT = 95.0
"""Percentage of random sets that stay below the factor that is shown."""
LIMIT = "errors as given, torque and gears kept; the tables grant planets that are sized for their number"


def planets_text(counts: PlanetCounts) -> RenderableType:
    """Return K_γ by number of planets as a table, with where the printed ones come from.

    Args:
        counts: From `planet_counts`.
    """
    columns = {f"{PERCENT:g} % of random sets": counts.random.percentile(PERCENT), **_beside(counts)}
    table = Grid(f"K_γ of {counts.stage} against planets", caption=LIMIT)
    table.add_column("planets", justify="right")
    for name in columns:
        table.add_column(name, justify="right")
    for count in counts.random.planets:
        table.add_row(str(count), *(f"{row[count]:.2f}" if count in row else "" for row in columns.values()))
    return Group(table, *(Text(line) for line in published_notes()))


def published_notes() -> list[str]:
    """Return one sentence on how sure each table is, and the measured values."""
    tables = {row.name: row.confidence for row in load_factors() if not row.measured}
    measured = (row for row in load_factors() if row.measured)
    return [f"{name}: {confidence}" for name, confidence in tables.items()] + [
        f"measured, {row.name}: {row.load_factor:.2f} ({row.planets} planets)" for row in measured
    ]


def planets_figure(counts: PlanetCounts) -> Figure:
    """Return K_γ against planets with the closed form and the standards' tables.

    Args:
        counts: From `planet_counts`.
    """
    return load_factor_figure({"random sets": counts.random}, _beside(counts))


def _beside(counts: PlanetCounts) -> dict[str, Mapping[int, float]]:
    closed = {"one pin, floating": counts.floating, "one pin, fixed": counts.fixed}
    return {**closed, **load_factor_tables()}
