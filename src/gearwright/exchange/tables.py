"""Every table of a sizing for spreadsheets and programs: XLSX, CSV, Parquet, netCDF.

What the tables hold is `render.tables`'; tables of studies are `study`'s to write.
"""

import io
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from importlib.util import find_spec
from io import BytesIO
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Problem, install, near, refuse, verb
from gearwright.particulars import particulars
from gearwright.render.grid import MARKS, Cell, Column, Table, csv_text
from gearwright.render.tables.checks import factor_tables
from gearwright.render.tables.sizing import flow_tables, tables_of
from gearwright.sizing import Sizing, rated_factors
from gearwright.store import netcdf_bytes

# ----------------------------------------------------------------------------------------------------------------------
# The tables of a sizing in long form: a line for every value, with its unit, equation and source.
# ----------------------------------------------------------------------------------------------------------------------


HEADING = ("table", "row", "quantity", "symbol", "value", "unit", "mark", "equation", "source")
"""Columns of the long form."""
Line = tuple[object, ...]


def all_tables(sizing: Sizing) -> dict[str, Table]:
    """Return every table of a sizing that holds something, by a short name.

    Args:
        sizing: As sized.
    """
    facts, rated = particulars(sizing), factor_tables(rated_factors(sizing))
    flows = {f"flow_{place}": table for place, table in enumerate(flow_tables(facts.branches), start=1)}
    factors = {f"factors_{place}": table for place, table in enumerate(rated.values(), start=1)}
    every = {**tables_of(facts), **flows, **factors}
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


# ----------------------------------------------------------------------------------------------------------------------
# The tables of a sizing for programs: Parquet in long form, netCDF-4 with a group for every table.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Values of a table that follow from others in their row, as formulas of a spreadsheet.
# ----------------------------------------------------------------------------------------------------------------------


NEAR = 1e-9
"""Relative difference up to which a formula gives what was computed; where it does not, the number stands [-]."""


class Formula(NamedTuple):
    """How a value follows from its row."""

    needs: tuple[str, ...]
    """Columns, in the units that are shown."""
    written: str
    """For a spreadsheet; {0} is the first of those columns."""
    value: Callable[..., float]


FORMULAS: Mapping[str, tuple[Formula, ...]] = {
    "pitch_diameter": (
        Formula(("module", "teeth", "helix_angle"), "{0}*{1}/COS(RADIANS({2}))",
                lambda module, teeth, angle: module * teeth / math.cos(math.radians(angle))),
        Formula(("module", "teeth"), "{0}*{1}", lambda module, teeth: module * teeth),
    ),
    "power": (Formula(("torque", "speed"), "{0}*{1}*PI()/30000", lambda t, n: t * n * math.pi / 30000.0),),
    "total": (Formula(("count", "each"), "{0}*{1}", lambda count, each: count * each),),
    "deviation": (Formula(("actual", "asked"), "100*({0}/{1}-1)", lambda n, asked: 100.0 * (n / asked - 1.0)),),
    "lost": (
        Formula(("meshes", "bearings", "windage", "churning", "seals"), "{0}+{1}+{2}+{3}+{4}", lambda *lost: sum(lost)),
    ),
    "efficiency": (Formula(("lost", "power"), "1-{0}/{1}", lambda lost, p: 1.0 - lost / p),),
}  # fmt: skip
"""Column -> how it follows, the first that can be had."""


def formulas_of(table: Table, row: Sequence[Cell], line: int) -> dict[int, str]:
    """Return column -> formula, of those values of a row that follow from others in it.

    Args:
        table: With its columns.
        row: Of the table.
        line: Of the sheet, from 1.
    """
    places = {column.name: place for place, column in enumerate(table.columns)}
    found = {}
    for place, column in enumerate(table.columns):
        for formula in FORMULAS.get(column.name, ()):
            if set(formula.needs) <= places.keys() and _gives(formula, row, places, value_of(row[place])):
                cells = [f"{letters(places[need])}{line}" for need in formula.needs]
                found[place] = f"={formula.written.format(*cells)}"
                break
    return found


def _gives(formula: Formula, row: Sequence[Cell], places: Mapping[str, int], value: object) -> bool:
    """Tell whether a formula gives what was computed."""
    parts = [value_of(row[places[need]]) for need in formula.needs]
    if not all(isinstance(part, int | float) and math.isfinite(part) for part in (*parts, value)):
        return False
    try:
        return math.isclose(formula.value(*parts), float(str(value)), rel_tol=NEAR)
    except ZeroDivisionError:
        return False


def letters(place: int) -> str:
    """Return what a spreadsheet calls a column.

    Args:
        place: Of the column, from 0.

    >>> letters(0), letters(25), letters(26)
    ('A', 'Z', 'AA')
    """
    before, last = divmod(place, 26)
    return (letters(before - 1) if before else "") + chr(ord("A") + last)


# ----------------------------------------------------------------------------------------------------------------------
# The tables of a sizing as a workbook: a sheet for every table, under its headings their units and sources.
# ----------------------------------------------------------------------------------------------------------------------


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
