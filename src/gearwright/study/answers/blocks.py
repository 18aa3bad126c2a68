"""Rows that are alike as columns: a block holds them in a tenth of the room, and is written and sent as one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import repeat
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Ints
from gearwright.sizing import Named
from gearwright.study.answers.table import Row

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
