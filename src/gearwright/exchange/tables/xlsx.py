"""The tables of a sizing as a workbook: a sheet for every table, under its headings their units and sources."""

from __future__ import annotations

import io
import math
from collections.abc import Iterable, Mapping
from importlib.util import find_spec
from typing import Any

from gearwright.errors import Problem, install, refuse
from gearwright.exchange.tables.formulas import formulas_of
from gearwright.exchange.tables.long import all_tables, heading_of, value_of
from gearwright.render.grid.table import MARKS, Table
from gearwright.sizing import Sizing
from gearwright.verbs import verb

LONGEST = 31
"""Characters of the name of a sheet, as Excel has it [-]."""
_WIDEST, _NARROWEST = 60, 8
"""Width of a column in characters, at most and at least [-]."""
OPTIONS = {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}


@verb
def to_xlsx(sizing: Sizing) -> bytes:
    """Return every table of a sizing as an XLSX workbook: a sheet each, with units, equations and sources.

    Args:
        sizing: As sized.

    Raises:
        DesignError: If XlsxWriter, of the extra ``xlsx``, is not here.
    """
    if find_spec("xlsxwriter") is None:
        refuse([Problem("--to", f"xlsx needs XlsxWriter, which is not here; {install('xlsx')}, or use csv")])
    from xlsxwriter import Workbook

    content = io.BytesIO()
    tables = all_tables(sizing)
    with Workbook(content, OPTIONS) as book:
        styles = {name: book.add_format(looks) for name, looks in _LOOKS.items()}
        contents = book.add_worksheet("contents")
        names = _names(tables)
        _write(contents, [(sizing.design.name,), (), ("sheet", "what it shows")], styles["bold"])
        _write(contents, [(names[name], table.title) for name, table in tables.items()], None, start=3)
        _sized(contents, [(names[name], table.title) for name, table in tables.items()])
        for name, table in tables.items():
            _sheet(book.add_worksheet(names[name]), table, styles)
    return content.getvalue()


_LOOKS: Mapping[str, dict[str, Any]] = {
    "bold": {"bold": True, "text_wrap": True, "valign": "top"},
    "small": {"italic": True, "font_size": 8, "text_wrap": True, "valign": "top"},
}


def _names(tables: Iterable[str]) -> dict[str, str]:
    """Return table -> name of its sheet."""
    return {name: name.replace("_", " ")[:LONGEST] for name in tables}


def _sheet(sheet: Any, table: Table, styles: Mapping[str, Any]) -> None:
    """Write a table: headings, symbols, units, equations, sources, then its rows."""
    head = [(table.title,), *zip(*map(heading_of, table.columns), strict=True)]
    rows = [tuple(map(value_of, row)) for row in table.rows]
    _write(sheet, head[:4], styles["bold"])
    _write(sheet, head[4:], styles["small"], start=4)
    _write(sheet, rows, None, start=len(head))
    for place, row in enumerate(table.rows, start=len(head)):
        for column, formula in formulas_of(table, row, place + 1).items():
            sheet.write_formula(place, column, formula, None, row[column].value)
    notes = [table.note, *(f"{MARKS[mark][0]} {column}: {MARKS[mark][1]}" for mark, column in _marked(table))]
    _write(sheet, [(note,) for note in notes if note], None, start=len(head) + len(rows) + 1)
    _sized(sheet, [*head[1:4], *rows])
    sheet.freeze_panes(len(head), 1)


def _marked(table: Table) -> list[tuple[Any, str]]:
    """Return every mark of a table with the row and the column in which it stands."""
    return [
        (cell.mark, f"{row[0].text}, {column.header}")
        for row in table.rows
        for column, cell in zip(table.columns, row, strict=True)
        if cell.mark
    ]


def _write(sheet: Any, rows: Iterable[Iterable[object]], style: Any, *, start: int = 0) -> None:
    """Write rows; a text is never a formula, and what is no finite number is a text."""
    for place, row in enumerate(rows, start=start):
        for column, value in enumerate(row):
            if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value):
                sheet.write_number(place, column, value, style)
            elif value is not None and value != "":
                sheet.write_string(place, column, str(value), style)


def _sized(sheet: Any, rows: Iterable[Iterable[object]]) -> None:
    """Make columns as wide as what stands in them."""
    widths: dict[int, int] = {}
    for row in rows:
        for column, value in enumerate(row):
            text = f"{value:.6g}" if isinstance(value, float) else str(value)
            widths[column] = max(widths.get(column, _NARROWEST), len(text) + 1)
    for column, width in widths.items():
        sheet.set_column(column, column, min(width, _WIDEST))
