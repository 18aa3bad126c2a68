"""Tables of studies for other programs: netCDF-4 and Parquet, one variable a column."""

from __future__ import annotations

from importlib.util import find_spec
from io import BytesIO
from pathlib import Path

import numpy as np

from gearwright.errors import DesignError, Problem, install
from gearwright.study.answers.table import Table
from gearwright.writing import write_bytes

Column = tuple[list[float] | list[str], str]


def columns(table: Table) -> dict[str, Column]:
    """Return the columns of a table by name: values and unit; what failed is not a number there and has its problem.

    Args:
        table: Of a study; inputs are in the unit of their path, results in the unit in which they are shown.
    """
    columns_by_name: dict[str, Column] = {"design": ([row.design for row in table.rows], "")}
    for path in table.rows[0].inputs:
        inputs = [row.inputs[path] for row in table.rows]
        if all(isinstance(value, int | float) and not isinstance(value, bool) for value in inputs):
            columns_by_name[path] = ([float(value) for value in inputs], "")
        else:
            columns_by_name[path] = ([str(value) for value in inputs], "")
    for name in table.results:
        if name in table.numbers:
            values = [np.nan if row.problem else row.shown(name) for row in table.rows]
            columns_by_name[name] = (values, table.unit(name))
        else:
            columns_by_name[name] = (["" if row.problem else str(row.results[name].value) for row in table.rows], "")
    return {**columns_by_name, "problem": ([row.problem for row in table.rows], "")}


def write_table(path: Path, table: Table) -> None:
    """Write a table as netCDF-4 (``.nc``) or Parquet (``.parquet``), with its units.

    Args:
        path: Of the file.
        table: Of a study.

    Raises:
        DesignError: If the name ends otherwise, Parquet is not installed, or no file can be there.
        SolveError: If the disk does not take it.
    """
    refuse_export(path)
    if path.suffix == ".nc":
        _write_netcdf(path, table)
    else:
        _write_parquet(path, table)


def refuse_export(path: Path) -> None:
    """Raise if a table could not be written there: before a night of cases, not after it.

    Args:
        path: Of the file.

    Raises:
        DesignError: If the name ends otherwise, its folder is not there, or Parquet is not installed.
    """
    if path.suffix not in (".nc", ".parquet"):
        message = f"{path.suffix!r} is not written; end the name with .nc or .parquet"
        raise DesignError([Problem("--export", message)])
    if not path.parent.is_dir():
        raise DesignError([Problem("--export", f"there is no folder {path.parent}; make it, or name another one")])
    if path.suffix == ".parquet" and find_spec("pyarrow") is None:
        message = f"Parquet needs pyarrow, which is not here; {install('parquet')}, or end the name with .nc"
        raise DesignError([Problem("--export", message)])


def _write_netcdf(path: Path, table: Table) -> None:
    import h5py

    from gearwright.store import new_netcdf

    with new_netcdf(path) as file:
        file.attrs.update({"title": table.name, "comment": table.description})
        file.dimensions = {"case": len(table.rows)}
        for name, (values, written) in columns(table).items():
            numbers = bool(values) and isinstance(values[0], float)
            data = np.array(values) if numbers else np.array(values, dtype=object)
            kind = "f8" if numbers else h5py.string_dtype()
            variable = file.create_variable(name, ("case",), kind, data=data)
            variable.attrs["units"] = written or "1"


def _write_parquet(path: Path, table: Table) -> None:
    import pyarrow
    from pyarrow import parquet

    exported = columns(table)
    fields = [
        pyarrow.field(
            name, pyarrow.float64() if isinstance(values[0], float) else pyarrow.string(), metadata={"unit": u}
        )
        for name, (values, u) in exported.items()
    ]
    schema = pyarrow.schema(fields, metadata={"title": table.name, "comment": table.description})
    image = BytesIO()
    parquet.write_table(pyarrow.table([values for values, _ in exported.values()], schema=schema), image)
    write_bytes(path, image.getbuffer())
