"""The verb for many designs: a table of changes, or any designs, become columns of results."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from gearwright.errors import DesignError, GearwrightError, Problem, near, refuse
from gearwright.sizing.answers import TEXT, Named, asked_results, named_results, total_results
from gearwright.sizing.many.columns import Found, in_lanes
from gearwright.sizing.many.sizings import Sizings, Structure, stacked, structure_of
from gearwright.sizing.result import Sizing
from gearwright.sizing.size import size
from gearwright.spec import Design, brief, edited, path_problems
from gearwright.verbs import verb

Cell = float | int | str | bool | None
"""Value of one entry in one design; None: this design keeps its own."""


@verb
def size_many(
    designs: Design | Sequence[Design],
    axes: Mapping[str, Any] | None = None,
    *,
    results: Sequence[str] | None = None,
) -> Sizings:
    """Return many designs sized, their results as columns.

    Every row is what `size` makes of it alone, bit for bit, whatever stands beside it. A design that cannot be sized
    is a row of NaN with its reason; designs of different structure stand side by side.

    Args:
        designs: One design that the axes vary, or many.
        axes: Dotted path, with the unit in its last part, -> its value in every row, in that unit; None in a row
            leaves that design its own. Left out: the designs as they are.
        results: Names as `named_results` has them; left out: masses, power densities, margin and efficiency.

    Raises:
        DesignError: For axes that are no columns, of different lengths, that no design has, or that mean the same
            entry; for results that no design has, or that are names.
    """
    columns: Mapping[str, Sequence[Cell]] = axes or {}
    refuse(_column_problems(columns), "axes")
    given = [designs] if isinstance(designs, Design) else list(designs)
    count = _count(designs, columns)
    first = {structure_of(design): design for design in reversed(given)}.values() if count else ()
    refuse(_axis_problems(columns, first), "axes")
    refuse(_result_problems(results or (), first), "results")
    made = partial(_design, given, columns)
    found, places = Found(count), dict[int, Structure]()
    if isinstance(designs, Design) and columns:
        found, places = in_lanes(designs, columns, results, count=count)
    rows, reasons = dict[int, dict[str, float]](), dict[int, str]()
    dimensions = dict(found.dimensions)
    for row in np.flatnonzero(~found.done).tolist():
        try:
            design = made(row)
            places[row] = structure_of(design)
            numbers = _numbers(size(design), results)
        except GearwrightError as error:
            problems = error.problems if isinstance(error, DesignError) else ()
            reasons[row] = "; ".join(map(str, problems)) or str(error)
            continue
        rows[row] = {name: float(number.value) for name, number in numbers.items()}
        dimensions |= {name: number.dimension for name, number in numbers.items()}
    values = stacked(rows, found.values, count)
    order = [name for name in results or values if name in values]
    occurring = dict.fromkeys(places[row] for row in sorted(places))
    structures = {structure: place for place, structure in enumerate(occurring)}
    place = np.array([structures[places[row]] if row in places else -1 for row in range(count)], dtype=np.int64)
    return Sizings(
        {name: values[name] for name in order}, {name: dimensions[name] for name in order},
        np.array([row not in reasons for row in range(count)], dtype=bool), reasons, tuple(structures), place, made,
        found.done,
    )  # fmt: skip


def _count(designs: Design | Sequence[Design], axes: Mapping[str, Sequence[Cell]]) -> int:
    """Return how many rows there are, or refuse columns of different lengths."""
    lengths = {path: len(values) for path, values in axes.items()}
    if not isinstance(designs, Design):
        lengths = {"designs": len(designs), **lengths}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{path} {length}" for path, length in lengths.items())
        raise DesignError([Problem("axes", f"columns of different lengths: {told}; give every design its row in each")])
    return next(iter(lengths.values()), 1)


def _column_problems(axes: Mapping[str, Any]) -> Iterator[Problem]:
    """Yield the axes that are no columns: one value, or a table of them."""
    for path, column in axes.items():
        if isinstance(column, str | bytes | Mapping) or not hasattr(column, "__len__"):
            yield Problem(path, f"{brief(column)} is no column; give a list with its value in every row")
        elif getattr(column, "ndim", 1) != 1:
            shape = "×".join(map(str, column.shape))
            yield Problem(path, f"an array of {shape} is no column; give one value for every row, in one axis")


def _axis_problems(axes: Mapping[str, Sequence[Cell]], designs: Iterable[Design]) -> list[Problem]:
    """Return what is wrong with the paths of axes in every design of the first, if it is wrong in all."""
    problems = [path_problems(design, axes) for design in designs]
    everywhere = set.intersection(*({problem.path for problem in found} for found in problems)) if problems else set()
    return [problem for problem in next(iter(problems), []) if problem.path in everywhere]


def _result_problems(results: Sequence[str], designs: Iterable[Design]) -> Iterator[Problem]:
    """Yield the results that no design has, or that are names; nothing where one of them cannot be sized to tell."""
    known: dict[str, Named] = {}
    for design in designs if results else ():
        try:
            known |= named_results(size(design))
        except GearwrightError:
            return
    for name in results if known else ():
        if name not in known:
            yield Problem(name, f"no design has such a result; {near(name, known)}")
        elif known[name].dimension == TEXT:
            yield Problem(name, f"{known[name].value!r} is a name and no number; ask for it of `at(row)`")


def _design(designs: Sequence[Design], axes: Mapping[str, Sequence[Cell]], row: int) -> Design:
    """Return the design of a row: its own entries, but for those that the axes say in it."""
    cells = {path: values[row] for path, values in axes.items()}
    changes = {path: _plain(cell) for path, cell in cells.items() if cell is not None}
    design = designs[row] if len(designs) > 1 else designs[0]
    return edited(design, changes) if changes else design


def _plain(cell: Any) -> Any:
    """Return a number of numpy's as one of Python's."""
    return cell.item() if isinstance(cell, np.generic) else cell


def _numbers(sizing: Sizing, results: Sequence[str] | None) -> dict[str, Named]:
    """Return the asked numbers of a sizing, as far as it has them."""
    if results is None:
        return total_results(sizing)
    named = asked_results(sizing, results)
    return {name: named[name] for name in results if name in named}
