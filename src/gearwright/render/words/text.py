"""Words for the terminal, and JSON for machines: the report of a Sizing, the modes, the summary of a Trace."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass

from rich import box
from rich.console import Console, ConsoleOptions, Group, RenderableType
from rich.table import Table as RichTable
from rich.text import Text

from gearwright.dynamics import Modes, Trace
from gearwright.render.tables.dynamic_load import dynamic_table
from gearwright.render.tables.factors import factor_tables, rated
from gearwright.render.tables.motion import energy_table, mode_table, motion_tables
from gearwright.render.tables.paths import path_table
from gearwright.render.tables.sizing import flow_tables, tables_of
from gearwright.render.tables.tables import MARKS, Cell, Column, Table, as_json
from gearwright.sizing import Sizing
from gearwright.units import text

_WORD = 14
"""Letters of the longest word that a narrow terminal need not break."""
_ORDER = (
    "margins",
    "speeds",
    "gears",
    "meshes",
    "rating",
    "shafts",
    "shaft_sizes",
    "bearings",
    "steps",
    "strength",
    "stiffness",
    "bearing_sizes",
    "joints",
    "carriers",
    "machines",
    "mass",
    "envelope",
    "overrides",
)


def sizing_text(sizing: Sizing) -> RenderableType:
    """Return the report of a sizing for the terminal.

    Args:
        sizing: As sized.
    """
    tables = tables_of(sizing)
    parts: list[RenderableType] = [Text(sizing.design.name, style="bold"), Text(summary(sizing)), Text()]
    parts += [table_text(each) for each in (*flow_tables(sizing), path_table(sizing)) if each.rows]
    parts += [table_text(tables[name]) for name in _ORDER if tables[name].rows]
    return Group(*parts)


def print_sizing(sizing: Sizing) -> None:
    """Print the report of a sizing.

    Args:
        sizing: As sized.
    """
    Console().print(sizing_text(sizing))


def print_factors(sizing: Sizing) -> None:
    """Print every factor of every mesh that ISO 6336 or ISO 10300 rates.

    Args:
        sizing: As sized.
    """
    for each in factor_tables(sizing):
        Console().print(table_text(each))


def sizing_json(sizing: Sizing) -> str:
    """Return every table of a sizing as JSON, with units, equations and sources.

    Args:
        sizing: As sized.
    """
    tables = {name: as_json(each) for name, each in tables_of(sizing).items()}
    flows = {case: as_json(each) for case, each in zip(sizing.flows, flow_tables(sizing), strict=True)}
    factors = {mesh.name: as_json(each) for mesh, each in zip(rated(sizing), factor_tables(sizing), strict=True)}
    head = {
        "design": sizing.design.name,
        "mass_kg": sizing.mass,
        "power_density_w_kg": sizing.power_density,
        "worst_margin": sizing.worst_margin,
    }
    return json.dumps(
        {**head, "cases": flows, **tables, "factors": factors}, indent=2, ensure_ascii=False, allow_nan=False
    )


def summary(sizing: Sizing) -> str:
    """Return mass, power density and worst margin in one or two sentences.

    Args:
        sizing: As sized.
    """
    parts = ", ".join(
        f"{what} {text(mass, 'mass')}"
        for what, mass in (
            ("gears", sizing.gear_mass),
            ("shafts", sizing.shaft_mass),
            ("carriers", sizing.carrier_mass),
        )
    )
    bearings = f" Bearings {text(sizing.bearing_mass, 'mass')}." if sizing.bearings else ""
    motors = f" Motors {text(sizing.motor_mass, 'mass')}." if sizing.motor_mass else ""
    return (
        f"{text(sizing.mass, 'mass')} ({parts}), {text(sizing.power_density, 'specific_power')},"
        f" worst margin {sizing.worst_margin:.3f}.{bearings}{motors}"
    )


def modes_text(modes: Modes, *, most: int = 30) -> RenderableType:
    """Return the natural frequencies for the terminal.

    Args:
        modes: As found.
        most: Modes that are listed at most.
    """
    return table_text(mode_table(modes, most=most))


def print_modes(modes: Modes) -> None:
    """Print the natural frequencies.

    Args:
        modes: As found.
    """
    Console().print(modes_text(modes))


def modes_json(modes: Modes) -> str:
    """Return the natural frequencies as JSON.

    Args:
        modes: As found.
    """
    return json.dumps(as_json(mode_table(modes, most=len(modes.frequency))), indent=2, ensure_ascii=False)


def trace_text(trace: Trace) -> RenderableType:
    """Return mean, least, greatest, rms and peak-to-peak of every line, and the energy book, for the terminal.

    Args:
        trace: As simulated.
    """
    head = Text(
        f"{trace.duration:.4g} s in steps of {trace.step:.3g} s, {trace.method};"
        f" estimated force error {trace.error:.1e}"
    )
    notes = [Text(note, style="yellow") for note in trace.notes]
    return Group(head, *notes, Text(), *(table_text(each) for each in (*motion_tables(trace), energy_table(trace))))


def print_trace(trace: Trace, sizing: Sizing | None = None) -> None:
    """Print the summary of a run, and its peaks beside the rated loads where the sizing is known.

    Args:
        trace: As simulated.
        sizing: That it is a run of.
    """
    Console().print(trace_text(trace))
    if sizing is not None and trace.force.bins:
        Console().print(table_text(dynamic_table(sizing, trace)))


def trace_json(trace: Trace) -> str:
    """Return the summary of a run as JSON.

    Args:
        trace: As simulated.
    """
    tables = {each.title.lower(): as_json(each) for each in (*motion_tables(trace), energy_table(trace))}
    head = {"method": trace.method, "step_s": trace.step, "duration_s": trace.duration, "error": trace.error}
    return json.dumps({**head, "notes": list(trace.notes), **tables}, indent=2, ensure_ascii=False, allow_nan=False)


def table_text(one: Table) -> RenderableType:
    """Return a table for the terminal, in several blocks where it is too narrow for all columns.

    Args:
        one: The table.
    """
    shape = _Fitted(one)
    legend = [f"{MARKS[mark][0]} {MARKS[mark][1]}" for mark in one.marks]
    below = " ".join([*([one.note] if one.note else []), *(f"{words}." for words in legend)])
    return Group(shape, Text(f"{below}\n", style="dim")) if below else shape


@dataclass(frozen=True)
class _Fitted:
    """A table that keeps every digit: columns without room stand in a block below, beside the rows' names again."""

    one: Table

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[RenderableType]:
        for k, columns in enumerate(_blocks(self.one, options.max_width)):
            yield _block(self.one, columns, title=f"{self.one.title}, continued" if k else self.one.title)


def _blocks(one: Table, width: int) -> list[list[int]]:
    """Return the columns of every block."""
    least, names = [_least(one, k) + 1 for k in range(len(one.columns))], _names(one)
    blocks = [list(names)]
    for k in range(len(names), len(least)):
        if sum(least[each] for each in (*blocks[-1], k)) > width - 2 and len(blocks[-1]) > len(names):
            blocks.append(list(names))
        blocks[-1].append(k)
    return blocks


def _names(one: Table) -> range:
    """Return the columns that name a row: the first, or where it repeats itself all words before the first number."""
    if len({row[0].text for row in one.rows}) == len(one.rows):
        return range(1)
    return range(max(next((k for k in range(len(one.columns)) if _is_number(one, k)), 1), 1))


def _least(one: Table, k: int) -> int:
    """Return the least width of a column: that of its numbers, or of its words up to `_WORD`."""
    head = max(map(len, _head(one.columns[k]).split()), default=0)
    cells = (_shown(row[k]).plain for row in one.rows)
    if _is_number(one, k):
        return max(head, *map(len, cells))
    words = (len(word) for cell in cells for word in cell.split())
    return min(max([head, *words]), _WORD)


def _is_number(one: Table, k: int) -> bool:
    return any(row[k].is_number for row in one.rows)


def _block(one: Table, columns: list[int], *, title: str) -> RichTable:
    shape = RichTable(title=title, title_justify="left", title_style="bold", box=box.SIMPLE_HEAD,
                      pad_edge=False, padding=(0, 1, 0, 0))  # fmt: skip
    for k in columns:
        right = _is_number(one, k)
        shape.add_column(_head(one.columns[k]), justify="right" if right else "left", no_wrap=right, overflow="fold")
    for row in one.rows:
        shape.add_row(*(_shown(row[k]) for k in columns))
    return shape


def _head(column: Column) -> str:
    return f"{column.symbol or column.header}\n{column.unit}"


def _shown(cell: Cell) -> Text:
    sign = MARKS[cell.mark][0] if cell.mark else ""
    return Text(cell.text + sign)
