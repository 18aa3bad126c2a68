"""The page of a study: which design wins, by how much, how sure that is, and what it depends on."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import SolveError
from gearwright.render import theme
from gearwright.render.pages import environment
from gearwright.render.report_parts import Figure, Section
from gearwright.render.study_figures import study_figure
from gearwright.render.study_spread import (
    contour_figure,
    distribution_figure,
    parallel_figure,
    pareto_figure,
    tornado_figure,
)
from gearwright.render.study_tables import heading, inputs_of, reasons, result_unit, spread
from gearwright.render.tables import MARKS, written
from gearwright.spec.study import Study
from gearwright.study import Row, Table
from gearwright.study.pareto import front_table, pareto_front
from gearwright.study.sensitivity import sensitivity
from gearwright.version import __version__

FEW = 60
"""Cases up to which every one is drawn; the spread says more about more of them."""


def study_page(study: Study, table: Table) -> str:
    """Return a study as one self-contained HTML page; the same input gives the same bytes.

    Args:
        study: As run.
        table: Its rows.
    """
    sections = [Section("Answer", notes=tuple(_answer(study, table)))]
    if study.objectives:
        sections.append(_front(study, table))
    if study.sampling.method == "saltelli":
        sections.append(_sensitivity(study, table))
    sections.append(_cases(study, table))
    return environment().get_template("comparison.html.j2").render(
        title=table.name, description=table.description, sections=sections, marks=MARKS, version=__version__
    )  # fmt: skip


def _answer(study: Study, table: Table) -> Iterator[str]:
    """Yield what a reader asks first."""
    failed = len(table.failed)
    yield (
        f"{len(table.rows):,} cases by the method {study.sampling.method!r}, of {len(study.designs)} designs;"
        f" {failed:,} cannot be had."
    )
    wanted = study.objectives or {table.results[0]: "least"}
    for result, sense in wanted.items():
        yield _winner(table, result, sense)
    yield from (f"Cannot be had: {reason}" for reason in reasons(table))


def _winner(table: Table, result: str, sense: str) -> str:
    """Say which case has the best of a result, by how much over the best of other designs, and how sure that is."""
    sign = 1.0 if sense == "least" else -1.0
    best: dict[str, Row] = {}
    for row in sorted(_good(table), key=lambda each: sign * each.number(result)):
        best.setdefault(row.design, row)
    first, *others = best.values()
    unit = result_unit(table, result)
    text = (
        f"{sense.capitalize()} {heading(result)}: {first.design}{_at(first)}, {_number(first, result)} {unit}".rstrip()
    )
    if not others:
        return f"{text}."
    margin = abs(others[0].number(result) / first.number(result) - 1.0)
    after = f"next {others[0].design}, {_number(others[0], result)} {unit}".rstrip()
    return f"{text}; {after}, {margin:.1%} off. {_sure(table, result, first.design, sign)}"


def _sure(table: Table, result: str, design: str, sign: float) -> str:
    """Say in how many of the cases with equal inputs a design is the best: what varies there is not to choose."""
    groups: dict[tuple[object, ...], list[Row]] = {}
    for row in _good(table):
        groups.setdefault(tuple(row.inputs.values()), []).append(row)
    complete = [rows for rows in groups.values() if len(rows) > 1]
    if not complete:
        return ""
    won = sum(min(rows, key=lambda each: sign * each.number(result)).design == design for rows in complete)
    return f"At equal inputs it is best in {won:,} of {len(complete):,} cases, {won / len(complete):.1%}."


def _at(row: Row) -> str:
    given = [
        f"{path} = {value:.6g}" if isinstance(value, float) else f"{path} = {value}"
        for path, value in row.inputs.items()
    ]
    return f" at {', '.join(given)}" if given else ""


def _front(study: Study, table: Table) -> Section:
    front = pareto_front(study, table)
    listed = [
        f"{row.design}{_at(row)}: "
        + ", ".join(
            f"{heading(name)} {_number(row, name)} {result_unit(table, name)}".rstrip() for name in study.objectives
        )
        for row in front_table(study, table).rows
    ]
    figures = [Figure(theme.to_svg(parallel_figure(table, front), "lines"), "All cases; the front stands out.")]
    if len(study.objectives) > 1:
        caption = "Every case over the first two objectives; no other case beats one of the front in all of them."
        figures.insert(0, Figure(theme.to_svg(pareto_figure(study, table, front), "front"), caption))
    notes = (f"{len(front):,} cases are beaten by none in all objectives:", *listed)
    return Section("What no other beats", figures=tuple(figures), notes=notes)


def _sensitivity(study: Study, table: Table) -> Section:
    figures, notes = [], []
    for k, result in enumerate(table.results):
        try:
            found = sensitivity(study, table, result)
        except SolveError as error:
            notes.append(f"{heading(result)}: {error}.")
            continue
        caption = f"{heading(result)}: Sobol' indices; the total index includes interactions."
        figures.append(Figure(theme.to_svg(tornado_figure(result, found), f"tornado{k}"), caption))
    return Section("What it depends on", figures=tuple(figures), notes=tuple(notes))


def _cases(study: Study, table: Table) -> Section:
    """Return the cases themselves: each one of a few, the spread of many."""
    if len(table.rows) <= FEW and study.sampling.method in ("grid", "list"):
        return Section("Cases", figures=(Figure(theme.to_svg(study_figure(table), "cases"), table.name),))
    notes = tuple(
        f"{heading(line.result)}: median {line.values[2]} {line.unit}, 5 to 95 %: {line.values[1]} to {line.values[3]},"
        f" least {line.values[0]}, most {line.values[4]}."
        for line in spread(table)
    )
    caption = "How the results are spread."
    figures = [Figure(theme.to_svg(distribution_figure(table), "spread"), caption)]
    if len(study.designs) == 1 and len(inputs_of(table)) == 2 and _all_numbers(table):
        shape = Figure(theme.to_svg(contour_figure(table, table.results[0]), "contour"), "Between the cases: linear.")
        figures.append(shape)
    return Section("Spread", figures=tuple(figures), notes=notes)


def _all_numbers(table: Table) -> bool:
    columns = [[row.inputs[path] for row in _good(table)] for path in inputs_of(table)]
    numbers = all(isinstance(value, int | float) for column in columns for value in column)
    return numbers and all(len(set(column)) > 2 for column in columns)


def _good(table: Table) -> list[Row]:
    return [row for row in table.rows if not row.problem]


def _number(row: Row, result: str) -> str:
    return written(row.shown(result))
