"""Run a study: every design along every axis, one after the other."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import product

from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.sizing.named import named_results, pick
from gearwright.spec import Design
from gearwright.spec.edit import edited
from gearwright.spec.study import Study, Value, axis_values, case_count
from gearwright.study.table import Row, Table


def run(study: Study, designs: Mapping[str, Design], *, progress: Callable[[float], None] | None = None) -> Table:
    """Return the table of a study.

    Args:
        study: Axes, changes and results.
        designs: Name -> design, for every name in the study.
        progress: Called with the fraction done, from 0 to 1.

    Raises:
        DesignError: If there are too many cases, or all of them fail. A variant that fails is a row with its reason.
    """
    count = case_count(study)
    rows = []
    for done, (name, inputs) in enumerate(_cases(study), start=1):
        rows.append(_row(name, designs[name], inputs, study))
        if progress is not None:
            progress(done / count)
    if rows and all(row.problem for row in rows):
        raise DesignError([], f"{study.name}: every case failed, the first with\n{rows[0].problem}")
    return Table(study.name, study.description, tuple(study.results), tuple(rows))


def _cases(study: Study) -> Iterator[tuple[str, dict[str, Value]]]:
    """Yield design and inputs of every case."""
    paths = list(study.axes)
    grids = [axis_values(path, axis) for path, axis in study.axes.items()]
    for name in study.designs:
        for values in product(*grids):
            yield name, dict(zip(paths, values, strict=True))


def _row(name: str, design: Design, inputs: dict[str, Value], study: Study) -> Row:
    try:
        found = named_results(size(edited(design, {**study.changes, **inputs})))
        return Row(name, inputs, {result: pick(found, result) for result in study.results})
    except DesignError as error:
        return Row(name, inputs, {}, "; ".join(str(problem) for problem in error.problems))
