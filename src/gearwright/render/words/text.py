"""Words for the terminal: the report of a Sizing, the modes, the summary of a Trace."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.render.grid.grid import Grid
from gearwright.render.grid.table import MARKS, Cell, Column, Table
from gearwright.render.tables.paths import path_table
from gearwright.render.tables.sizing.factors import factor_tables, usual_table
from gearwright.render.tables.sizing.influences import influence_tables
from gearwright.render.tables.sizing.materials import estimated_only
from gearwright.render.tables.sizing.methods import method_tables
from gearwright.render.tables.sizing.overview import flow_tables, tables_of
from gearwright.render.words.headline import headline, implied_text, sizing_headline
from gearwright.render.words.masses import summary
from gearwright.sizing import Sizing, remarks

if TYPE_CHECKING:
    from gearwright.dynamics import Modes, Trace
    from gearwright.reviews import Review

_ORDER = (
    "passing",
    "losses",
    "margins",
    "speeds",
    "gears",
    "meshes",
    "load_factors",
    "rating",
    "shafts",
    "shaft_sizes",
    "bearings",
    "steps",
    "strength",
    "stiffness",
    "bearing_sizes",
    "bearing_oil",
    "joints",
    "carriers",
    "planet_bearings",
    "machines",
    "mass",
    "complete_mass",
    "envelope",
    "turns",
    "places",
    "materials",
    "overrides",
)


def sizing_text(sizing: Sizing, review: Review | None = None) -> RenderableType:
    """Return the report of a sizing for the terminal.

    Args:
        sizing: As sized.
        review: Of it; left out: the checks of sizing alone are told, and who looks at the rest.
    """
    tables = tables_of(sizing)
    tables["materials"] = estimated_only(tables["materials"])
    verdict = sizing_headline(sizing) if review is None else headline(review)
    said = (summary(sizing), f"{verdict}.", implied_text(sizing.design), *remarks(sizing))
    head = [Text(words) for words in said if words]
    parts: list[RenderableType] = [Text(sizing.design.name, style="bold"), *head, Text()]
    parts += [table_text(table) for table in (*flow_tables(sizing), path_table(sizing)) if table.rows]
    parts += [table_text(tables[name]) for name in _ORDER if tables[name].rows]
    return Group(*parts)


def factors_text(sizing: Sizing) -> RenderableType:
    """Return every factor of every mesh whose method has some beside stresses and margins.

    Args:
        sizing: As sized.
    """
    usual = usual_table(sizing)
    return Group(*map(table_text, ([usual] if usual.rows else []) + [*factor_tables(sizing).values()]))


def influences_text(sizing: Sizing, wish: float) -> RenderableType:
    """Return what moves the margins of every mesh.

    Args:
        sizing: As sized.
        wish: Margin that is wished [-].
    """
    return Group(*map(table_text, influence_tables(sizing, wish).values()))


def methods_text(sizing: Sizing) -> RenderableType:
    """Return every cylindrical mesh by every method, factor by factor.

    Args:
        sizing: As sized.
    """
    return Group(*map(table_text, method_tables(sizing).values()))


def modes_text(modes: Modes, *, case: str = "", maximum: int = 30) -> RenderableType:
    """Return the natural frequencies for the terminal.

    Args:
        modes: As found.
        case: Load case, if they are of a design.
        maximum: Modes that are listed at most.
    """
    from gearwright.render.tables.motion import mode_table

    return table_text(mode_table(modes, case=case, maximum=maximum))


def trace_text(trace: Trace, sizing: Sizing | None = None, *, case: str = "") -> RenderableType:
    """Return mean, least, greatest, rms and peak-to-peak of every line, and the energy balance, for the terminal.

    Args:
        trace: As simulated.
        sizing: That it is a run of: with it, peaks stand beside the rated loads.
        case: Load case, if it is of a design.
    """
    from gearwright.dynamics.motion import Error
    from gearwright.render.tables.dynamic_load import dynamic_table
    from gearwright.render.tables.motion import energy_table, motion_tables

    head = Text(
        f"{f'Case {case}. ' if case else ''}{trace.duration:.4g} s in steps of {trace.step:.3g} s, {trace.method};"
        f" {Error(trace.error, trace.rms_error).words()}"
    )
    notes = [Text(note, style="yellow") for note in trace.notes]
    beside = [dynamic_table(sizing, trace)] if sizing is not None and trace.force.bins else []
    tables = (*motion_tables(trace), energy_table(trace), *beside)
    return Group(head, *notes, Text(), *map(table_text, tables))


def table_text(table: Table) -> RenderableType:
    """Return a table for the terminal, in several blocks where it is too narrow for all columns.

    Args:
        table: The table.
    """
    grid = Grid(table.title, names=_names(table))
    for k, column in enumerate(table.columns):
        right = _is_number(table, k)
        grid.add_column(_head(column), justify="right" if right else "left", no_wrap=right)
    for row in table.rows:
        grid.add_row(*map(_shown, row))
    legend = " ".join(f"{MARKS[mark][0]} {MARKS[mark][1]}." for mark in table.marks)
    below = "\n".join(filter(None, [table.note, legend]))
    return Group(grid, Text(f"{below}\n", style="dim")) if below else grid


def _names(table: Table) -> int:
    """Return how many columns name a row: the first, or where it repeats itself all words before the first number."""
    if len({row[0].text for row in table.rows}) == len(table.rows):
        return 1
    return max(next((k for k in range(len(table.columns)) if _is_number(table, k)), 1), 1)


def _is_number(table: Table, k: int) -> bool:
    return any(row[k].is_number for row in table.rows)


def _head(column: Column) -> str:
    return f"{column.symbol or column.header}\n{column.unit}"


def _shown(cell: Cell) -> Text:
    sign = MARKS[cell.mark][0] if cell.mark else ""
    return Text(cell.text + sign)
