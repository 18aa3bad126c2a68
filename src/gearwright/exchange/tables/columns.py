"""The tables of a sizing for programs: Parquet in long form, netCDF-4 with a group for every table."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from importlib.util import find_spec
from io import BytesIO
from typing import Any

import numpy as np

from gearwright.errors import Problem, install, near, refuse
from gearwright.exchange.tables.long import HEADING, all_tables, heading_of, lines, value_of
from gearwright.render.grid.csv_text import csv_text
from gearwright.render.grid.table import Cell, Table
from gearwright.sizing import Sizing
from gearwright.store import netcdf_bytes
from gearwright.verbs import verb

VALUE = HEADING.index("value")
"""Place of the value in the long form [-]."""
ROW = "row"
"""Dimension of a table, and its coordinate: what its rows are called."""
_SLASH = " over "
"""What stands for the slash, which parts groups, in names of variables."""


@verb
def to_parquet(sizing: Sizing) -> bytes:
    """Return every value of every table of a sizing as Parquet: a row each with unit, equation and source.

    Numbers stand in the column ``value``, words in ``text``.

    Args:
        sizing: As sized.

    Raises:
        DesignError: If PyArrow, of the extra ``parquet``, is not here.
    """
    if find_spec("pyarrow") is None:
        refuse([Problem("--to", f"parquet needs PyArrow, which is not here; {install('parquet')}, or use netcdf")])
    import pyarrow
    from pyarrow import parquet

    rows = list(lines(all_tables(sizing)))
    values = [row[VALUE] for row in rows]
    made: dict[str, Any] = {
        name: pyarrow.array([str(row[place]) for row in rows], pyarrow.string())
        for place, name in enumerate(HEADING) if name != "value"
    }  # fmt: skip
    made["value"] = pyarrow.array([_number(value) for value in values], pyarrow.float64())
    made["text"] = pyarrow.array([str(value) if _number(value) is None else None for value in values], pyarrow.string())
    named = pyarrow.table(made).replace_schema_metadata({"design": sizing.design.name})
    buffer = BytesIO()
    parquet.write_table(named, buffer)
    return buffer.getvalue()


@verb
def to_netcdf(sizing: Sizing) -> bytes:
    """Return every table of a sizing as netCDF-4: a group each, whose coordinate ``row`` is what its rows are called.

    Variables have ``units``, ``long_name``, ``symbol``, ``equation`` and ``source``; what is not there is NaN.

    Args:
        sizing: As sized.
    """
    return netcdf_bytes(partial(_fill, sizing))


@verb
def table_csv(sizing: Sizing, name: str) -> str:
    """Return one table of a sizing as CSV, as wide as it is: under each heading its unit in brackets.

    Args:
        sizing: As sized.
        name: Of the table, such as ``gears``.

    Raises:
        DesignError: If there is none of that name; with the nearest.

    >>> import gearwright as gw
    >>> table_csv(gw.size(gw.read("star")), "gears").splitlines()[0].split(",")[:4]
    ['', 'bodies', 'teeth', 'module [mm]']
    """
    tables = all_tables(sizing)
    if name not in tables:
        refuse([Problem("--table", f"{name!r} is no table of this design; {near(name, list(tables))}")])
    headings = [column.heading for column in tables[name].columns]
    return csv_text(headings, (tuple(map(value_of, row)) for row in tables[name].rows))


def _number(value: object) -> float | None:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else None


def _fill(sizing: Sizing, file: Any) -> None:
    file.attrs["title"] = sizing.design.name
    for name, table in all_tables(sizing).items():
        _table(file.create_group(name), table)


def _table(group: Any, table: Table) -> None:
    group.attrs.update({"title": table.title, "comment": table.note})
    group.dimensions = {ROW: len(table.rows)}
    _variable(group, ROW, [row[0].text for row in table.rows])
    for place, column in enumerate(table.columns):
        cells = [row[place] for row in table.rows]
        name = column.name.replace("/", _SLASH)
        data = _data(cells)
        variable = _variable(group, f"{name} of it" if name in group.variables else name, data)
        header, symbol, unit, equation, source = heading_of(column)
        said = {"long_name": header, "symbol": symbol, "equation": equation, "source": source}
        variable.attrs.update({key: text for key, text in said.items() if text})
        if isinstance(data, np.ndarray):
            variable.attrs["units"] = unit or "1"


def _data(cells: Sequence[Cell]) -> Any:
    """Return numbers where all cells that hold something are numbers, else words."""
    if all(cell.is_number or cell.value is None for cell in cells) and any(cell.is_number for cell in cells):
        return np.array([cell.value if cell.is_number else np.nan for cell in cells], dtype=float)
    return [cell.text for cell in cells]


def _variable(group: Any, name: str, data: Any) -> Any:
    import h5py

    kind = "f8" if isinstance(data, np.ndarray) else h5py.string_dtype()
    values = data if isinstance(data, np.ndarray) else np.array(data, dtype=object)
    return group.create_variable(name, (ROW,), kind, data=values)
