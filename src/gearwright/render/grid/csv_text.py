"""Tables as CSV text that is the same data in every program: numbers stay numbers, and a text is never a formula."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable

from gearwright.render.grid.table import Table

_FORMULA = ("=", "+", "-", "@", "\t")
"""What makes spreadsheets compute a cell, or call a program from it."""


def csv_text(heading: Iterable[str], rows: Iterable[Iterable[object]]) -> str:
    """Return a table as CSV.

    Args:
        heading: Names of the columns.
        rows: As many cells each.

    Source: OWASP, CSV injection: a leading apostrophe keeps a cell text.

    >>> csv_text(["name", "mass"], [["=1+1", -2.5], ["-3.1", None]])
    "name,mass\\n'=1+1,-2.5\\n-3.1,\\n"
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([_cell(name) for name in heading])
    writer.writerows([_cell(cell) for cell in row] for row in rows)
    return out.getvalue()


def table_csv(made: Table) -> str:
    """Return a table as CSV, in the units that it shows.

    Args:
        made: The table.
    """
    return csv_text([column.heading for column in made.columns], [[cell.value for cell in row] for row in made.rows])


def _cell(cell: object) -> object:
    """Return a cell whose text no program takes for a formula or for the end of a row."""
    if not isinstance(cell, str) or _is_number(cell):
        return cell
    text = cell.replace("\r\n", "\n").replace("\r", "\n")
    return f"'{text}" if text.lstrip().startswith(_FORMULA) else text


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
