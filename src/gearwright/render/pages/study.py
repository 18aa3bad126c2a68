"""The page of a study: which design wins, by how much, how sure that is, what it depends on, and the designs drawn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gearwright.errors import SolveError
from gearwright.render.figures.study import (
    contour_figure,
    distribution_figure,
    parallel_figure,
    pareto_figure,
    study_figure,
    tornado_figure,
    trade_figure,
    weights_figure,
)
from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Number,
    Page,
    Section,
    Stamp,
    Tone,
    figure,
    judged,
    set_page,
    worst_of,
)
from gearwright.render.pages.page import Verdict as Judged
from gearwright.render.schematic import schematic_figure
from gearwright.render.tables.study import (
    failure_table,
    front_list,
    inputs_table,
    limits_table,
    spread_table,
    standings_table,
    values_table,
)
from gearwright.render.tables.variants import heading
from gearwright.render.words.sizing import headline
from gearwright.render.words.study import SAMPLED, answer, chosen, key_numbers
from gearwright.spec import Design, Study
from gearwright.spec.studies import RELIABILITY
from gearwright.study import Table
from gearwright.study.answers import Verdict, sensitivity, varies, verdict
from gearwright.study.cases import reviewed
from gearwright.study.reliability import Reliability, reliability
from gearwright.study.tables import front_table, pareto_front
from gearwright.version import __version__

FEW = 60
"""Cases up to which every one is drawn; the spread says more about more of them."""


def study_page(study: Study, table: Table, designs: Mapping[str, Design], *, stamp: Stamp = UNSTAMPED) -> str:
    """Return a study as one self-contained HTML page; the same input gives the same bytes.

    Args:
        study: As run.
        table: Its rows.
        designs: Name -> design, to draw those that are chosen.
        stamp: Date of the page.
    """
    outcome = verdict(study, table)
    drawn = _drawn(study, table, designs, outcome)
    sections = [_answer(study, table, outcome)]
    if len(study.objectives) > 1 and outcome is None:
        sections.append(_front(study, table))
    if study.sampling.method == "saltelli":
        sections.append(_sensitivity(study, table))
    if study.sampling.method in RELIABILITY:
        sections += [_failures(study, found) for found in reliability(study, table)]
    elif outcome is None or outcome.scenarios == 1:
        sections.append(_cases(study, table))
    sections += [section for section, _ in drawn]
    numbers = tuple(Number(name, value) for name, value in key_numbers(outcome))
    said = _verdict(table, [verdict for _, verdicts in drawn for verdict in verdicts], sections[0].notes)
    return set_page(
        Page("Study", table.name, table.description, said, numbers, tuple(sections), (_made(study),), stamp=stamp)
    )


def _verdict(table: Table, chosen: Sequence[Judged], told: Sequence[str]) -> Judged:
    """Return what the study answers, with no better a tone than the designs that it draws, or cases that failed."""
    said = told[0] if told else "The study has no objective."
    failing = sum(verdict.tone is Tone.BAD for verdict in chosen)
    if failing:
        return Judged(Tone.BAD, f"{failing} of {len(chosen)} chosen designs fail their review", said)
    if table.failed:
        return Judged(Tone.OPEN, f"{len(table.failed)} of {len(table.rows)} cases have no result", said)
    if not chosen:
        return Judged(Tone.OPEN, "Computed", said)
    return Judged(worst_of(chosen), "The chosen designs pass as far as assessed", said)


def _answer(study: Study, table: Table, outcome: Verdict | None) -> Section:
    notes = tuple(answer(study, table))
    if outcome is None:
        return Section("Answer", notes=notes)
    caption = "Medians; bars from 5 to 95 % of the cases; the best of each objective in orange; the winner at the top."
    trade = figure(trade_figure(study, table, outcome), "trade", caption)
    figures = [trade]
    if len(study.objectives) > 1:
        weights = "Who comes first: objectives of the same weight, and over all weights."
        figures.append(figure(weights_figure(outcome), "weights", weights))
    return Section(
        "Answer",
        tables=(standings_table(table, outcome), values_table(study, table, outcome)),
        figures=tuple(figures),
        notes=notes,
    )


def _front(study: Study, table: Table) -> Section:
    front, chosen = pareto_front(study, table), front_table(study, table).rows
    caption = "Every case over the first two objectives; none dominates a case of the Pareto front."
    drawn = pareto_figure(study, table, front, chosen)
    lines = figure(parallel_figure(table, front), "lines", "All cases; the front stands out.")
    figures = [figure(drawn, "front", caption), lines]
    notes = (f"{len(front):,} cases are on the Pareto front; {len(chosen)} of them are listed.",)
    return Section("Pareto front", (front_list(study, table, chosen),), tuple(figures), notes)


def _sensitivity(study: Study, table: Table) -> Section:
    figures, notes = [], []
    for k, result in enumerate(table.numbers):
        try:
            indices = sensitivity(study, table, result)
        except SolveError as error:
            notes.append(f"{heading(result)}: {error}.")
            continue
        caption = f"{heading(result)}: Sobol' indices; the total index includes interactions."
        figures.append(figure(tornado_figure(result, indices), f"tornado{k}", caption))
    return Section("What it depends on", figures=tuple(figures), notes=tuple(notes))


def _failures(study: Study, found: Reliability) -> Section:
    tables = [limits_table(found)]
    if found.limits[0].likeliest:
        tables.append(failure_table(study, found))
    note = f"{found.evaluations:,} cases, {found.failed:,} of them without a result, counted as broken."
    return Section(f"How likely {found.design} fails", tuple(tables), notes=(note,))


def _cases(study: Study, table: Table) -> Section:
    """Return the cases themselves: each one of a few, the spread of many."""
    sampled = study.sampling.method in SAMPLED
    shapes = _shapes(study, table)
    if len(table.rows) <= FEW and study.sampling.method in ("grid", "list"):
        return Section("Cases", figures=(*shapes, figure(study_figure(table, study.objectives), "cases", table.name)))
    figures = [*shapes, figure(distribution_figure(table), "spread", "How the results are spread.")]
    tables = (spread_table(table, sampled=sampled),) if len(study.designs) == 1 else ()
    return Section("Spread", tables, tuple(figures))


def _shapes(study: Study, table: Table) -> list[Figure]:
    """Return the objectives, or the first result, over two axes."""
    if len(study.designs) > 1 or len(table.free) != 2 or not _all_numbers(table):
        return []
    names = [name for name in tuple(study.objectives) or table.numbers[:1] if varies(np.array(table.column(name)))]
    return [
        figure(contour_figure(table, name), f"contour{k}", f"{heading(name)}; between the cases: linear.")
        for k, name in enumerate(names)
    ]


def _drawn(
    study: Study, table: Table, designs: Mapping[str, Design], outcome: Verdict | None
) -> list[tuple[Section, list[Judged]]]:
    """Return the chosen designs as schematics, judged: the winner and the next, or the ends and middle of a front."""
    figures, notes, verdicts = [], [], []
    for k, (caption, row) in enumerate(chosen(study, table, outcome)):
        sizing, review = reviewed(study, designs[row.design], row.inputs)
        figures.append(figure(schematic_figure(sizing), f"drawn{k}", caption))
        notes.append(f"{caption}: {headline(review)}.")
        verdicts.append(judged(review))
    section = Section("The chosen designs", figures=tuple(figures), notes=tuple(notes))
    return [(section, verdicts)] if figures else []


def _made(study: Study) -> Section:
    sampling = study.sampling
    drawn = f", {sampling.count:,} drawn with seed {sampling.seed}" if sampling.count else ""
    notes = [f"Cases by the method {sampling.method!r}{drawn}; gearwright {__version__}."]
    if study.mission is not None:
        life = f"; gears strengthened to live {study.fly.life / 3600.0:g} h" if study.fly.life else ""
        notes.append(f"Flown: {study.mission.name}{life}.")
    return Section("How it was made", tables=(inputs_table(study),), notes=tuple(notes))


def _all_numbers(table: Table) -> bool:
    columns = [[row.inputs[path] for row in table.good] for path in table.free]
    numbers = all(isinstance(value, int | float) for column in columns for value in column)
    return numbers and all(len(set(column)) > 2 for column in columns)
