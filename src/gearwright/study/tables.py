"""Tables of a study: rows and blocks of columns, Pareto fronts, export to netCDF-4 and Parquet."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from importlib.util import find_spec
from io import BytesIO
from itertools import repeat
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from gearwright.base import (
    Bools,
    DesignError,
    Floats,
    Ints,
    Problem,
    Shown,
    frame,
    install,
    near,
    number_text,
    shown,
    unit,
)
from gearwright.files import write_bytes
from gearwright.sizing import TEXT, Named
from gearwright.spec import Study

# ----------------------------------------------------------------------------------------------------------------------
# Table: one row per variant; a failed variant is a row with its reason.
# ----------------------------------------------------------------------------------------------------------------------


_NUMBER = re.compile(r"(?<![\w.-])(?<![A-Z]{3} )[-−+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w]|[.-]\w)")
"""A number that stands alone: none in a name (``h2``, ``in-line-3``), in a path or in that of a standard."""


@dataclass(frozen=True)
class Row:
    """One variant."""

    design: str
    """Design that was varied."""
    inputs: Mapping[str, float | int | str | bool]
    """Dotted path -> value, in the unit of the path."""
    results: Mapping[str, Named]
    """Result -> value; empty if the variant failed."""
    problem: str = ""
    """Why the variant failed; empty if it did not."""

    def number(self, result: str) -> float:
        """Return one result of a variant that did not fail [SI].

        Args:
            result: Its name.

        Raises:
            DesignError: If it is a text.
        """
        value = self.results[result].value
        if isinstance(value, str):
            raise DesignError([Problem(result, f"{value!r} is a name and no number; take it as one of the results")])
        return value

    def shown(self, result: str) -> float:
        """Return one result in the unit in which it is shown.

        Args:
            result: Its name.

        Raises:
            DesignError: If it is a text.
        """
        return shown(self.number(result), self.results[result].dimension)

    def text(self, result: str) -> str:
        """Return one result as tables and sentences have it, without its unit.

        Args:
            result: Its name.
        """
        value, dimension = self.results[result]
        return value if isinstance(value, str) else number_text(value, dimension)


@dataclass(frozen=True, repr=False)
class Table(Shown):
    """The rows of a study."""

    name: str
    """Of the study."""
    description: str
    """What it answers."""
    results: tuple[str, ...]
    """Results that were asked for."""
    rows: tuple[Row, ...]
    """In the order of the study: designs outermost, the last axis fastest."""
    tied: bool = False
    """True if the axes were changed together, value by value."""

    @property
    def free(self) -> tuple[str, ...]:
        """Paths that vary on their own: of those that were changed together only the last."""
        paths = tuple(self.rows[0].inputs) if self.rows else ()
        return paths[-1:] if self.tied else paths

    def column(self, result: str) -> list[float]:
        """Return one result of every row that did not fail [SI].

        Args:
            result: Its name.

        Raises:
            DesignError: If it was not asked for.
        """
        if result not in self.results:
            raise DesignError([Problem("results", f"{result!r} was not asked for; {near(result, self.results)}")])
        return [row.number(result) for row in self.good]

    @cached_property
    def good(self) -> tuple[Row, ...]:
        """Rows that did not fail."""
        return tuple([row for row in self.rows if not row.problem])

    @cached_property
    def numbers(self) -> tuple[str, ...]:
        """Results that are numbers, not names."""
        return tuple(name for name in self.results if self.good and self.good[0].results[name].dimension != TEXT)

    def unit(self, result: str) -> str:
        """Return the unit in which a result is shown; empty for what has none.

        Args:
            result: Its name.
        """
        return unit(self.good[0].results[result].dimension) if result in self.numbers else ""

    def to_dataframe(self) -> Any:
        """Return a pandas ``DataFrame``: a row for each variant, as shown and exported; units in ``attrs["units"]``."""

        return frame(columns(self), "")

    @cached_property
    def failed(self) -> tuple[Row, ...]:
        """Rows that failed."""
        return tuple([row for row in self.rows if row.problem])


def kind_of(problem: str) -> str:
    """Return why a case failed without its numbers, so that like reasons count together.

    Args:
        problem: Of a row.

    >>> kind_of("pairs.in-line-h2.width: 12.5 mm is below -3 mm (ISO 6336-2, 5.3)")
    'pairs.in-line-h2.width: … mm is below … mm (ISO 6336-2, …)'
    """
    return _NUMBER.sub("…", problem)


def quantiles(values: Sequence[float] | Floats, parts: Sequence[float]) -> list[float]:
    """Return the values below which parts of all lie; between an endless one and another nothing is interpolated.

    Args:
        values: Of one result.
        parts: Of all cases [-].

    >>> quantiles([1.0, 2.0], [0.5]), quantiles([1.0, 2.0, float("inf")], [0.5, 0.95])
    ([1.5], [2.0, inf])
    """
    method: Literal["linear", "nearest"] = "linear" if np.isfinite(values).all() else "nearest"
    return [float(quantile) for quantile in np.quantile(values, parts, method=method)]


# ----------------------------------------------------------------------------------------------------------------------
# Rows that are alike as columns: a block holds them in a tenth of the room, and is written and sent as one.
# ----------------------------------------------------------------------------------------------------------------------


REAL, WHOLE, OTHER = "<f8", "<i8", ""
"""Kinds of entries: a number of eight bytes, a whole one, and what is written as text."""
NUMBER = "number"
"""Name of the column of the cases' numbers."""


class Shape(NamedTuple):
    """What alike rows have in common; it follows from each of them alone."""

    design: str
    """Design that was varied."""
    inputs: tuple[tuple[str, str], ...]
    """Path and kind of every input."""
    results: tuple[tuple[str, str, str], ...]
    """Name, dimension and kind of every result."""
    failed: bool
    """True if they are a reason instead of results."""

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds of the entries of a row: inputs, results, and the reason of a failed one."""
        reason = (OTHER,) if self.failed else ()
        return (*(kind for _, kind in self.inputs), *(kind for *_, kind in self.results), *reason)

    @property
    def record(self) -> np.dtype[Any]:
        """Of the bytes of a row: the case's number and the entries that are numbers."""
        numbers = [(f"entry {k}", kind) for k, kind in enumerate(self.kinds) if kind != OTHER]
        return np.dtype([(NUMBER, WHOLE), *numbers])


@dataclass(frozen=True, eq=False)
class Block:
    """Alike rows and the numbers of their cases."""

    shape: Shape
    records: np.ndarray[Any, np.dtype[Any]]
    """Numbers of cases and entries that are numbers, shape (rows,)."""
    texts: Sequence[Sequence[Any]]
    """Other entries of every row; empty where no row has any."""

    def __len__(self) -> int:
        """Return how many rows there are."""
        return len(self.records)

    @property
    def numbers(self) -> list[int]:
        """Of the cases."""
        return [int(number) for number in self.records[NUMBER].tolist()]

    def __iter__(self) -> Iterator[tuple[int, Row]]:
        """Yield number and row of every case."""
        shape = self.shape
        paths, names = [path for path, _ in shape.inputs], [name for name, *_ in shape.results]
        columns = self._columns()
        inputs, reasons = columns[: len(paths)], columns[-1] if shape.failed else repeat("")
        results = [
            map(Named, column, repeat(dimension))
            for column, (_, dimension, _) in zip(columns[len(paths) :], shape.results, strict=False)
        ]
        of_paths, of_names = (zip(*part, strict=True) if part else repeat(()) for part in (inputs, results))
        for number, given, found, reason in zip(self.numbers, of_paths, of_names, reasons, strict=False):
            yield (
                number,
                Row(shape.design, dict(zip(paths, given, strict=True)), dict(zip(names, found, strict=True)), reason),
            )

    def _columns(self) -> list[Sequence[Any]]:
        """Return the entries of all rows, column after column."""
        others = iter(zip(*self.texts, strict=True))
        return [
            next(others) if kind == OTHER else self.records[f"entry {k}"].tolist()
            for k, kind in enumerate(self.shape.kinds)
        ]

    def where(self, kept: Bools) -> Block:
        """Return some of the rows.

        Args:
            kept: Which, shape (rows,).
        """
        texts = [self.texts[k] for k in np.flatnonzero(kept).tolist()] if self.texts else ()
        return Block(self.shape, self.records[kept], texts)


@dataclass(frozen=True, eq=False)
class Blocks:
    """Finished cases in blocks; as a sequence they are pairs of number and row."""

    blocks: tuple[Block, ...]

    def __len__(self) -> int:
        """Return how many rows there are."""
        return sum(map(len, self.blocks))

    def __iter__(self) -> Iterator[tuple[int, Row]]:
        """Yield number and row of every case."""
        for block in self.blocks:
            yield from block

    @property
    def failed(self) -> int:
        """How many of them are a reason instead of results."""
        return sum(len(block) for block in self.blocks if block.shape.failed)


def blocks_of(rows: Iterable[tuple[int, Row]]) -> Blocks:
    """Return rows as blocks, in the order in which each block's first one comes.

    Args:
        rows: Number of the case and its row; blocks stay as they are.
    """
    if isinstance(rows, Blocks):
        return rows
    alike: dict[Shape, list[tuple[int, Row]]] = {}
    for number, row in rows:
        alike.setdefault(_shape_of(row), []).append((number, row))
    return Blocks(tuple(_block(shape, pairs) for shape, pairs in alike.items()))


def _shape_of(row: Row) -> Shape:
    inputs = tuple((path, _kind(value)) for path, value in row.inputs.items())
    results = tuple((name, named.dimension, _kind_of_result(named.value)) for name, named in row.results.items())
    return Shape(row.design, inputs, results, bool(row.problem))


def _kind(value: Any) -> str:
    if isinstance(value, float):
        return REAL
    return WHOLE if type(value) is int and -(2**63) <= value < 2**63 else OTHER


def _kind_of_result(value: Any) -> str:
    """Return the kind of a result, of which a whole one is a real one like the others."""
    exact = type(value) is int and abs(value) <= 2**53
    return REAL if exact or isinstance(value, float) else OTHER


def _block(shape: Shape, pairs: Sequence[tuple[int, Row]]) -> Block:
    kinds, records, texts = shape.kinds, list[tuple[Any, ...]](), list[list[Any]]()
    for number, row in pairs:
        entries = [*row.inputs.values(), *(named.value for named in row.results.values())]
        if shape.failed:
            entries.append(row.problem)
        records.append((number, *(entry for entry, kind in zip(entries, kinds, strict=True) if kind != OTHER)))
        if OTHER in kinds:
            texts.append([entry for entry, kind in zip(entries, kinds, strict=True) if kind == OTHER])
    return Block(shape, np.array(records, dtype=shape.record), texts)


def block_of_columns(
    design: str, numbers: Ints, inputs: Mapping[str, Sequence[Any]], results: Mapping[str, tuple[Any, str]]
) -> Blocks:
    """Return rows that did not fail, whose results are columns of numbers.

    Args:
        design: That was varied.
        numbers: Of the cases, shape (rows,).
        inputs: Path -> value in every row.
        results: Name -> values [SI], shape (rows,), and their dimension.
    """
    named = tuple((name, dimension, REAL) for name, (_, dimension) in results.items())
    own = {path: [_kind(value) for value in values] for path, values in inputs.items()}
    rows_by_kinds: dict[tuple[str, ...], list[int]] = {}
    for row, kinds in enumerate(zip(*own.values(), strict=True) if own else [()] * len(numbers)):
        rows_by_kinds.setdefault(kinds, []).append(row)
    made = list[Block]()
    for kinds, rows in rows_by_kinds.items():
        shape = Shape(design, tuple(zip(inputs, kinds, strict=True)), named, failed=False)
        records = np.empty(len(rows), dtype=shape.record)
        place = np.array(rows)
        records[NUMBER] = numbers[place]
        columns = [[values[row] for row in rows] for values in inputs.values()]
        columns += [values[place] for values, _ in results.values()]
        for k, (column, kind) in enumerate(zip(columns, shape.kinds, strict=True)):
            if kind != OTHER:
                records[f"entry {k}"] = column
        others = [column for column, kind in zip(columns, kinds, strict=False) if kind == OTHER]
        made.append(Block(shape, records, [list(texts) for texts in zip(*others, strict=True)]))
    return Blocks(tuple(made))


# ----------------------------------------------------------------------------------------------------------------------
# Pareto fronts: designs that no other design dominates, constraints counted.
# ----------------------------------------------------------------------------------------------------------------------


FAILED = 1e30
"""Objective and violation of an infeasible design: worse than any that can."""


def pareto_front(study: Study, table: Table) -> tuple[Row, ...]:
    """Return the Pareto front: designs that no other one dominates, by the first objective, the best of it first.

    Args:
        study: With objectives and constraints.
        table: Its rows.

    Raises:
        DesignError: If the study has no objective, or no design keeps the constraints.
    """
    if not study.objectives:
        raise DesignError([Problem("objectives", 'there is none; add such as [objectives] mass = "minimum"')])
    good = [row for row in table.rows if not row.problem and not violations(study, [row])[0]]
    if not good:
        raise DesignError([Problem("constraints", "no design keeps all of them; relax one")])
    values = wanted(study, good)
    best = np.flatnonzero(non_dominated(values, np.zeros(len(good))))
    _, distinct = np.unique(values[best], axis=0, return_index=True)
    return tuple(good[k] for k in best[distinct])


FEW = 12
"""Designs of a front that are listed."""


def front_table(study: Study, table: Table) -> Table:
    """Return the front as a table: all of it, or evenly spaced ones of a long one.

    Args:
        study: With objectives and constraints.
        table: Its rows.

    Raises:
        DesignError: As `pareto_front`.
    """
    front = pareto_front(study, table)
    kept = np.unique(np.linspace(0, len(front) - 1, FEW).astype(int))
    name = f"Pareto front ({len(kept)} of {len(front)})"
    return replace(table, name=name, description="", rows=tuple(front[k] for k in kept))


def wanted(study: Study, rows: Sequence[Row]) -> Floats:
    """Return the objectives as numbers to be made small [SI], shape (rows, objectives).

    Args:
        study: With objectives.
        rows: Of it.
    """
    signs = {name: 1.0 if sense == "minimum" else -1.0 for name, sense in study.objectives.items()}
    return np.array(
        [[FAILED if row.problem else sign * row.number(name) for name, sign in signs.items()] for row in rows]
    ).reshape(len(rows), len(signs))


def violations(study: Study, rows: Sequence[Row]) -> Floats:
    """Return by how much each row breaks the constraints, relative to their bounds and summed [-], shape (rows,).

    Args:
        study: With constraints.
        rows: Of it.
    """
    failed = np.array([bool(row.problem) for row in rows], dtype=bool)
    broken = np.fmax(0.0, -left_of(study, rows)).sum(axis=1)
    total: Floats = np.where(failed, FAILED, broken)
    return total


class Limit(NamedTuple):
    """One side of a constraint."""

    result: str
    """Its name."""
    bound: float
    """In the unit of tables."""
    is_minimum: bool
    """True if the result has to be at least the bound, False if at most."""


def limits_of(study: Study) -> tuple[Limit, ...]:
    """Return every limit that the constraints of a study set.

    Args:
        study: With constraints.
    """
    return tuple(
        Limit(name, value, is_minimum)
        for name, bound in study.constraints.items()
        for value, is_minimum in ((bound.minimum, True), (bound.maximum, False))
        if value is not None
    )


def left_of(study: Study, rows: Sequence[Row]) -> Floats:
    """Return what is left of every limit, relative to it [-], shape (rows, limits): below 0 it is broken.

    Args:
        study: With constraints.
        rows: Of it; of one that failed nothing is known, which is minus infinity.
    """
    limits = limits_of(study)
    return np.array([[_left(row, limit) for limit in limits] for row in rows]).reshape(len(rows), len(limits))


def _left(row: Row, limit: Limit) -> float:
    if row.problem:
        return -math.inf
    over = (row.shown(limit.result) - limit.bound) / (abs(limit.bound) or 1.0)
    return over if limit.is_minimum else -over


def ranks(values: Floats, broken: Floats) -> Ints:
    """Return the front that each row belongs to [-]: 0 is dominated by none, 1 only by rows of 0, and so on.

    Args:
        values: Objectives to be made small, shape (rows, objectives).
        broken: Violation of the constraints [-], shape (rows,): who breaks them less dominates.

    Source: Deb et al. 2002, IEEE Trans. Evol. Comput. 6 (2), definition 1 (constraint-domination).
    """
    rank, left, front = np.zeros(len(values), dtype=np.int64), np.arange(len(values)), 0
    while len(left):
        best = non_dominated(values[left], broken[left])
        rank[left[best]] = front
        left, front = left[~best], front + 1
    return rank


def non_dominated(values: Floats, broken: Floats) -> Bools:
    """Tell which rows no other one dominates; each of them strikes out all that it dominates at once.

    Args:
        values: Objectives to be made small, shape (rows, objectives).
        broken: Violation of the constraints [-], shape (rows,).
    """
    best = np.ones(len(values), dtype=bool)
    for k in np.lexsort((*values.T[::-1], broken)).tolist():  # what comes first strikes out the most
        if best[k]:
            same = broken == broken[k]
            worse = (values >= values[k]).all(axis=1) & (values > values[k]).any(axis=1)
            best &= ~((broken > broken[k]) | (same & worse))
    return best


def crowding(values: Floats, rank: Ints) -> Floats:
    """Return the crowding distance of every row within its rank [-]; the ends of a front are infinitely far apart.

    Args:
        values: Objectives, shape (rows, objectives).
        rank: Front that each row belongs to, shape (rows,).
    """
    distance = np.zeros(len(values))
    for front in np.unique(rank):
        members = np.flatnonzero(rank == front)
        for column in values.T:
            order = members[np.argsort(column[members], kind="stable")]
            ordered = column[order]
            distance[order[[0, -1]]] = np.inf
            span = ordered[-1] - ordered[0]
            if 0.0 < span < np.inf:
                distance[order[1:-1]] += (ordered[2:] - ordered[:-2]) / span
    return distance


# ----------------------------------------------------------------------------------------------------------------------
# Tables of studies for other programs: netCDF-4 and Parquet, one variable a column.
# ----------------------------------------------------------------------------------------------------------------------


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
