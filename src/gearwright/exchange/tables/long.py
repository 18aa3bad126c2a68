"""The tables of a sizing in long form: a line for every value, with its unit, equation and source."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.render.grid.csv_text import csv_text
from gearwright.render.grid.table import Cell, Column, Table
from gearwright.render.tables.sizing.factors import factor_tables
from gearwright.render.tables.sizing.overview import flow_tables, tables_of
from gearwright.sizing import Sizing
from gearwright.verbs import verb

HEADING = ("table", "row", "quantity", "symbol", "value", "unit", "mark", "equation", "source")
"""Columns of the long form."""
Line = tuple[object, ...]


def all_tables(sizing: Sizing) -> dict[str, Table]:
    """Return every table of a sizing that holds something, by a short name.

    Args:
        sizing: As sized.
    """
    flows = {f"flow_{place}": table for place, table in enumerate(flow_tables(sizing), start=1)}
    factors = {f"factors_{place}": table for place, table in enumerate(factor_tables(sizing).values(), start=1)}
    every = {**tables_of(sizing), **flows, **factors}
    return {name: table for name, table in every.items() if table.rows and table.columns}


@verb
def to_csv(sizing: Sizing) -> str:
    """Return every value of every table of a sizing as CSV, a line each with unit, equation and source.

    Args:
        sizing: As sized.

    >>> import gearwright as gw
    >>> to_csv(gw.size(gw.read("star"))).splitlines()[0]
    'table,row,quantity,symbol,value,unit,mark,equation,source'
    """
    return csv_text(HEADING, lines(all_tables(sizing)))


def lines(tables: Mapping[str, Table]) -> Iterator[Line]:
    """Yield the values of tables: title, row, quantity, symbol, value, unit, mark, equation, source.

    Args:
        tables: By name.
    """
    for table in tables.values():
        for row in table.rows:
            label = row[0].text
            for place, (column, cell) in enumerate(zip(table.columns, row, strict=True)):
                if cell.value is not None and (place or len(row) == 1):
                    header, symbol, unit, equation, source = heading_of(column)
                    yield (table.title, label, header, symbol, value_of(cell), unit, cell.mark, equation, source)


def heading_of(column: Column) -> tuple[str, str, str, str, str]:
    """Return header, symbol, unit, equation and source of a column; empty where there is none.

    Args:
        column: Of a table.
    """
    equation, source = ("", "") if column.origin is None else (column.origin.equation, column.origin.source)
    return column.header or column.name, column.symbol, column.unit, equation, source


def value_of(cell: Cell) -> object:
    """Return a number as it is, anything else as it is shown.

    Args:
        cell: Of a table.
    """
    return cell.value if cell.is_number else cell.text
