"""A value as a notebook shows it: its few lines, a table and a figure. A value without a figure is words alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from html import escape
from types import MappingProxyType
from typing import Any

from gearwright.errors import DesignError, Problem
from gearwright.render.grid.table import MARKS, Table
from gearwright.render.style import theme
from gearwright.render.style.templates import environment
from gearwright.render.words.short import short

_TABLE = '{% import "macros.html.j2" as macros with context %}{{ macros.show(table) }}'


def figure(value: object) -> theme.Drawing:
    """Return the figure of a value: skeleton of a design, Campbell diagram, forces of a run, power of a flight.

    Args:
        value: Design, Sizing, Modes, Campbell, SpeedCase, Trace, Flight or Table.

    Raises:
        DesignError: If there is none of its type.
    """
    kind = type(value).__name__
    if kind not in _FIGURES:
        message = f"of a value of type {kind} there is no figure; give one of {', '.join(_FIGURES)}"
        raise DesignError([Problem("value", message)], "figure")
    return _FIGURES[kind](value)


def html(value: object) -> str:
    """Return a value as HTML for a notebook.

    Args:
        value: Of any verb.
    """
    kind = type(value).__name__
    parts = [f"<pre>{escape(short(value))}</pre>"]
    parts += [_table(table) for table in (_TABLES[kind](value) if kind in _TABLES else ()) if table.rows]
    if kind in _FIGURES:
        parts.append(theme.to_svg(_FIGURES[kind](value), f"{kind}-{id(value)}"))
    return "\n".join(parts)


def _table(table: Table) -> str:
    return environment().from_string(_TABLE).render(table=table, marks=MARKS)


def _schematic(value: Any) -> theme.Drawing:
    from gearwright.render.schematic.schematic import schematic_figure
    from gearwright.train import build_train

    return schematic_figure(build_train(value) if type(value).__name__ == "Design" else value)


def _modes(value: Any) -> theme.Drawing:
    from gearwright.render.figures.motion import mode_figure

    return mode_figure(value)


def _trace(value: Any) -> theme.Drawing:
    from gearwright.render.figures.motion import time_figure

    return time_figure(value)


def _campbell(value: Any) -> theme.Drawing:
    from gearwright.render.figures.dynamics import diagram_figure

    return diagram_figure(value if type(value).__name__ == "Campbell" else value.campbell)


def _flight(value: Any) -> theme.Drawing:
    from gearwright.render.figures.flights.flight import power_figure

    return power_figure(value)


def _study(value: Any) -> theme.Drawing:
    from gearwright.render.figures.study.lines import study_figure

    return study_figure(value)


def _mode_tables(value: Any) -> tuple[Table, ...]:
    from gearwright.render.tables.motion import mode_table

    return (mode_table(value),)


def _motion_tables(value: Any) -> tuple[Table, ...]:
    from gearwright.render.tables.motion import motion_tables

    return motion_tables(value)


def _speed_tables(value: Any) -> tuple[Table, ...]:
    from gearwright.render.tables.dynamics import critical_table

    return (critical_table(value),)


def _phase_tables(value: Any) -> tuple[Table, ...]:
    from gearwright.render.tables.flight import phase_table

    return (phase_table(value),)


def _check_tables(value: Any) -> tuple[Table, ...]:
    from gearwright.render.tables.checks import review_tables

    return review_tables(value.checks)


def _gear_tables(value: Any) -> tuple[Table, ...]:
    from gearwright.render.tables.sizing.overview import tables_of

    return (tables_of(value)["gears"],)


_FIGURES: Mapping[str, Callable[[Any], theme.Drawing]] = MappingProxyType(
    {
        "Design": _schematic, "Sizing": _schematic, "Modes": _modes, "Campbell": _campbell, "SpeedCase": _campbell,
        "Trace": _trace, "Flight": _flight, "Table": _study,
    }
)  # fmt: skip
_TABLES: Mapping[str, Callable[[Any], tuple[Table, ...]]] = MappingProxyType(
    {
        "Sizing": _gear_tables, "Modes": _mode_tables, "Trace": _motion_tables, "SpeedCase": _speed_tables,
        "Flight": _phase_tables, "Review": _check_tables,
    }
)  # fmt: skip
