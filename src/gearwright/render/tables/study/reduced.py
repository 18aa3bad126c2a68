"""Tables of a study that kept no rows: how results are spread, along which axis, and its best cases."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.render.grid.grid import Grid
from gearwright.render.tables.study.variants import heading
from gearwright.spec.studies import value_at
from gearwright.study.answers import Reduced
from gearwright.study.answers.reduced import SECTIONS
from gearwright.units import written

FEW = 6
"""Sections of an axis that are listed, evenly spaced [-]."""


def reduced_grids(reduced: Reduced) -> Iterator[Grid]:
    """Yield the spread of every result, its spread along every axis, and the best cases.

    Args:
        reduced: Of a study.
    """
    yield _spread(reduced)
    for design in reduced.study.designs:
        for axis in reduced.study.axes:
            if any((design, result, axis) in reduced.counts for result in reduced.dimensions):
                yield _along(reduced, design, axis)
    if reduced.best:
        yield _best(reduced)


def _spread(reduced: Reduced) -> Grid:
    reasons = reduced.reasons.most_common(3)
    caption = "\n".join(f"{count:,} × {reason}" for reason, count in reasons)
    title = f"{reduced.study.name}: {reduced.cases:,} cases, {reduced.failed:,} infeasible"
    grid = Grid(title, caption=caption)
    for name in ("design", "result", "", "5 %", "median", "95 %"):
        grid.add_column(name, justify="right" if "%" in name or name == "median" else "left")
    for design in reduced.study.designs:
        for result in reduced.dimensions:
            if (design, result, "") in reduced.counts:
                levels = [written(reduced.shown(result, level), 3) for level in reduced.quantiles(design, result)]
                grid.add_row(design, heading(result), reduced.unit(result), *levels)
    return grid


def _along(reduced: Reduced, design: str, axis: str) -> Grid:
    """Return the medians of every result along an axis, with 5 and 95 %."""
    results = [result for result in reduced.dimensions if (design, result, axis) in reduced.counts]
    grid = Grid(f"{design} along {axis}: median (5 to 95 %)")
    grid.add_column("from", justify="left")
    grid.add_column("cases", justify="right")
    for result in results:
        grid.add_column(f"{heading(result)} {reduced.unit(result)}".rstrip(), justify="right")
    columns = {
        result: {section: (count, levels) for section, count, levels in reduced.along(design, result, axis)}
        for result in results
    }
    sections = sorted(columns[results[0]])
    for section in sections[:: max(1, len(sections) // FEW)]:
        cells = []
        for result in results:
            _, levels = columns[result].get(section, (0, ()))
            low, median, high = [written(reduced.shown(result, level), 3) for level in levels] or ["–", "–", "–"]
            cells.append(f"{median} ({low}–{high})")
        grid.add_row(_begin(reduced, axis, section), f"{columns[results[0]][section][0]:,}", *cells)
    return grid


def _begin(reduced: Reduced, path: str, section: int) -> str:
    axis = reduced.study.axes[path]
    value = axis.values[section] if axis.values is not None else value_at(path, axis, section / SECTIONS)
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def _best(reduced: Reduced) -> Grid:
    names = [*reduced.study.objectives]
    rows = sorted(reduced.best.items(), key=lambda entry: [entry[1].number(name) for name in names])
    grid = Grid(f"The best cases: {len(rows)} are kept", caption="the Pareto front, and the best of every objective")
    grid.add_column("case", justify="right")
    grid.add_column("design", justify="left")
    for name in (*reduced.study.axes, *(f"{heading(name)} {reduced.unit(name)}".rstrip() for name in names)):
        grid.add_column(name, justify="right")
    step = max(1, len(rows) // FEW)
    for number, row in rows[::step]:
        inputs = [f"{value:.5g}" if isinstance(value, float) else str(value) for value in row.inputs.values()]
        grid.add_row(f"{number:,}", row.design, *inputs, *map(row.text, names))
    return grid
