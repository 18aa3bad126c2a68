"""The table of a study for the terminal, for files and for the page; and of one that kept no rows."""

from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from gearwright.base import NOISE, written
from gearwright.render.grid import csv_text
from gearwright.render.terminal import Grid
from gearwright.spec.studies import value_at
from gearwright.study import Row, Table
from gearwright.study.answers import SECTIONS, Reduced
from gearwright.study.tables import kind_of, quantiles

# ----------------------------------------------------------------------------------------------------------------------
# The table of a study for the terminal, for files and for the page.
# ----------------------------------------------------------------------------------------------------------------------


_WORDS = {"mass": "train as sized", "gear_mass": "gears", "shaft_mass": "shafts", "carrier_mass": "carriers",
          "motor_mass": "motors", "inverter_mass": "inverters", "cooling_mass": "their cooling",
          "complete_mass": "complete", "complete_mass.low": "68 % from",
          "complete_mass.high": "to",
          "total_mass": "train as sized + machines", "total_power_density": "power density with machines",
          "envelope.volume": "envelope",
          "worst_margin": "worst margin of sizing", "review.margin": "worst margin", "review.worst": "worst check",
          "review.verdict": "verdict", "review.failing": "failing checks",
          "modes.lowest_critical_speed": "lowest critical speed", "modes.critical_margin": "margin of critical speeds",
          "fly.fuel": "fuel", "fly.efficiency": "efficiency in flight", "fly.life": "life", "fly.flights": "flights",
          "fly.governing": "fails first", "fly.battery_energy": "battery energy",
          "fly.electric_share": "electric share", "fly.charge": "charge at the end",
          "fly.minimum_charge": "minimum charge"}  # fmt: skip


BESIDE_MOTORS = ("inverter_mass", "cooling_mass")
"""Results that are nothing where a design counts motors alone."""
FLAT = 0.03
"""Deviation from the optimum that still counts as near it [-]."""
MOST_COLUMNS = 4
"""Inputs that a table on a terminal has room for."""


def heading(result: str) -> str:
    """Return the name of a result as an engineer reads it.

    Args:
        result: Its dotted name.
    """
    return _WORDS.get(result, result.replace("_", " "))


def percent(part: float, digits: int = 0) -> str:
    """Return a part as it is read; what is less than all never reads as 100 %.

    Args:
        part: Of 1 [-].
        digits: After the point.

    >>> percent(0.954), percent(0.954, 1), percent(1599 / 1600)
    ('95 %', '95.4 %', '99.9 %')
    """
    whole = not part < 1.0 - NOISE
    enough = next(more for more in range(digits, 99) if whole or float(f"{100.0 * part:.{more}f}") < 100.0)
    return f"{100.0 * part:.{enough}f} %"


def result_unit(table: Table, result: str) -> str:
    """Return the unit in which a result is shown.

    Args:
        table: Of the study.
        result: Its name.
    """
    return table.unit(result)


def study_grid(table: Table) -> Grid:
    """Return the table for the terminal; a failed variant shows its reason.

    Args:
        table: Of the study.
    """
    grid = Grid(table.name, caption=_caption(table), names=1 + len(_few(table)))
    paths = _few(table)
    for name in ("design", *paths):
        grid.add_column(name, justify="left" if name == "design" else "right")
    results = [result for result in table.results if is_counted(table, result)]
    for result in results:
        grid.add_column(f"{heading(result)}\n{result_unit(table, result)}", justify="right")
    for row in table.rows:
        if not row.problem:
            grid.add_row(row.design, *_inputs(row, paths), *map(row.text, results))
    return grid


def is_counted(table: Table, result: str) -> bool:
    """Tell whether a result is shown: inverters and cooling where some design counts them.

    Args:
        table: Of the study.
        result: Its name.
    """
    return result not in BESIDE_MOTORS or any(row.number(result) for row in table.good)


def _few(table: Table) -> tuple[str, ...]:
    """Return the paths that have room on a terminal: those that vary on their own, or none if they are many."""
    return table.free if len(table.free) <= MOST_COLUMNS else ()


def numeric_axis(table: Table) -> str | None:
    """Return the last axis if its values are numbers.

    Args:
        table: Of the study.
    """
    paths = table.free
    return None if not paths or any(not _is_number(row.inputs[paths[-1]]) for row in table.rows) else paths[-1]


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def summary_grid(table: Table) -> Grid:
    """Return the spread of every result, for studies of more cases than a reader looks through.

    Args:
        table: Of the study.
    """
    title = f"{table.name}: {len(table.rows):,} cases, {len(table.failed):,} infeasible"
    caption = "\n".join(reasons(table)) if table.failed else ""
    grid = Grid(title, caption=caption)
    for name in ("result", "", "minimum", "5 %", "median", "95 %", "maximum"):
        grid.add_column(name, justify="left" if name in ("result", "") else "right")
    for line in spread(table):
        grid.add_row(heading(line.result), line.unit, *line.values)
    return grid


class Spread(NamedTuple):
    """How one result is spread over the cases, as written."""

    result: str
    """Its name."""
    unit: str
    """In which it is shown."""
    values: tuple[str, ...]
    """Least, 5 %, median, 95 % and most."""


def spread(table: Table) -> list[Spread]:
    """Return how every result is spread.

    Args:
        table: Of the study.
    """
    lines = []
    for result in table.numbers:
        levels = quantiles([row.shown(result) for row in table.good], (0.0, 0.05, 0.5, 0.95, 1.0))
        lines.append(Spread(result, table.unit(result), tuple(written(value) for value in levels)))
    return lines


def reasons(table: Table) -> list[str]:
    """Return the commonest reasons of failed cases, digits left out so that like ones count together.

    Args:
        table: Of the study.
    """
    counts = Counter(kind_of(row.problem) for row in table.failed)
    return [f"{count:,} × {reason}" for reason, count in counts.most_common(3)]


def _caption(table: Table) -> str:
    paths = _few(table)
    failed = [f"{' '.join([row.design, *_inputs(row, paths)])}: {row.problem}" for row in table.failed]
    lines = [f"{len(failed)} of {len(table.rows)} infeasible:", *failed] if failed else []
    hidden = len(table.rows[0].inputs) - len(paths) if table.rows else 0
    lines += [f"{hidden} more inputs are in --csv, --json and --report"] if hidden else []
    return "\n".join(lines)


def _inputs(row: Row, paths: tuple[str, ...]) -> list[str]:
    values = [row.inputs[path] for path in paths]
    return [f"{value:g}" if isinstance(value, float) else str(value) for value in values]


def study_records(table: Table) -> list[dict[str, float | int | str | bool | None]]:
    """Return the rows as plain records: design, inputs, results with their unit in the key, problem.

    Args:
        table: Of the study.
    """
    records = []
    for row in table.rows:
        record: dict[str, float | int | str | bool | None] = {"design": row.design, **row.inputs}
        for result in table.results:
            name = f"{result} [{result_unit(table, result)}]".replace(" []", "")
            if row.problem:
                record[name] = None
            else:
                record[name] = row.shown(result) if result in table.numbers else row.results[result].value
        records.append({**record, "problem": row.problem})
    return records


def study_csv(table: Table) -> str:
    """Return the rows as CSV.

    Args:
        table: Of the study.
    """
    records = study_records(table)
    return csv_text(records[0], (record.values() for record in records))


# ----------------------------------------------------------------------------------------------------------------------
# Tables of a study that kept no rows: how results are spread, along which axis, and its best cases.
# ----------------------------------------------------------------------------------------------------------------------


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
