"""The page of a study: which design wins, by how much, how sure that is, what it depends on, and the designs drawn."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Annotated

import numpy as np
from markupsafe import Markup

from gearwright.base import Origin, Quantity, SolveError, smallest_first, text
from gearwright.enumeration import Ranking
from gearwright.optimum import Optimum
from gearwright.particulars import Particulars
from gearwright.render import style as theme
from gearwright.render.figures.study import (
    comparison_figure,
    contour_figure,
    distribution_figure,
    growth_figure,
    parallel_figure,
    pareto_figure,
    study_figure,
    tornado_figure,
    trade_figure,
    weights_figure,
)
from gearwright.render.grid import table
from gearwright.render.pages.page import (
    UNSTAMPED,
    Number,
    Page,
    PageFigure,
    Section,
    Stamp,
    Tone,
    Verdict,
    figure,
    judged,
    quantity,
    set_page,
    worst_of,
)
from gearwright.render.schematic import power_flow_figure, schematic_figure
from gearwright.render.tables.sizing import mass_sentence
from gearwright.render.tables.study import (
    SHOWN_ARCHITECTURES as SHOWN,
    architectures_table,
    binding_table,
    equal_life_table,
    failure_table,
    fit_table,
    front_list,
    front_rows,
    group_table,
    influence_table,
    inputs_table,
    limits_table,
    listed,
    measures_table,
    optimum_table,
    price_table,
    regret_table,
    spread_table,
    standings_table,
    values_table,
)
from gearwright.render.tables.variants import heading
from gearwright.render.words.sizing import headline
from gearwright.render.words.study import (
    SAMPLED,
    answer,
    chosen,
    equal_life_sentences,
    key_numbers,
    lightest_sentence,
    optimum_sentences,
    ranking_sentences,
)
from gearwright.reviews import Review
from gearwright.sizing import Sizing, StageSummary, stage_summaries
from gearwright.sizing.arrangement import envelope
from gearwright.spec import Design, Study
from gearwright.spec.studies import RELIABILITY
from gearwright.study import Table
from gearwright.study.answers import Verdict as Outcome, sensitivity, varies, verdict
from gearwright.study.architectures import EqualLife
from gearwright.study.cases import reviewed
from gearwright.study.reliability import Reliability, reliability
from gearwright.study.tables import front_table, pareto_front
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# The page of a study: which design wins, by how much, how sure that is, what it depends on, and the designs drawn.
# ----------------------------------------------------------------------------------------------------------------------


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
    drawn = _chosen_designs(study, table, designs, outcome)
    sections = [_answer(study, table, outcome)]
    if len(study.objectives) > 1 and outcome is None:
        sections.append(_front_of_table(study, table))
    if study.sampling.method == "saltelli":
        sections.append(_sensitivity(study, table))
    if study.sampling.method in RELIABILITY:
        sections += [_failures(study, found) for found in reliability(study, table)]
    elif outcome is None or outcome.scenarios == 1:
        sections.append(_cases(study, table))
    sections += [section for section, _ in drawn]
    numbers = tuple(Number(name, value) for name, value in key_numbers(outcome))
    said = _verdict_on_study(table, [verdict for _, verdicts in drawn for verdict in verdicts], sections[0].notes)
    return set_page(
        Page("Study", table.name, table.description, said, numbers, tuple(sections), (_made(study),), stamp=stamp)
    )


def _verdict_on_study(table: Table, chosen: Sequence[Verdict], told: Sequence[str]) -> Verdict:
    """Return what the study answers, with no better a tone than the designs that it draws, or cases that failed."""
    said = told[0] if told else "The study has no objective."
    failing = sum(verdict.tone is Tone.BAD for verdict in chosen)
    if failing:
        return Verdict(Tone.BAD, f"{failing} of {len(chosen)} chosen designs fail their review", said)
    if table.failed:
        return Verdict(Tone.OPEN, f"{len(table.failed)} of {len(table.rows)} cases have no result", said)
    if not chosen:
        return Verdict(Tone.OPEN, "Computed", said)
    return Verdict(worst_of(chosen), "The chosen designs pass as far as assessed", said)


def _answer(study: Study, table: Table, outcome: Outcome | None) -> Section:
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


def _front_of_table(study: Study, table: Table) -> Section:
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


def _shapes(study: Study, table: Table) -> list[PageFigure]:
    """Return the objectives, or the first result, over two axes."""
    if len(study.designs) > 1 or len(table.free) != 2 or not _all_numbers(table):
        return []
    names = [name for name in tuple(study.objectives) or table.numbers[:1] if varies(np.array(table.column(name)))]
    return [
        figure(contour_figure(table, name), f"contour{k}", f"{heading(name)}; between the cases: linear.")
        for k, name in enumerate(names)
    ]


def _chosen_designs(
    study: Study, table: Table, designs: Mapping[str, Design], outcome: Outcome | None
) -> list[tuple[Section, list[Verdict]]]:
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


# ----------------------------------------------------------------------------------------------------------------------
# Several sizings side by side: which is lightest, where their mass is, and why.
# ----------------------------------------------------------------------------------------------------------------------


_SHOWN = 5
"""Designs in the head [-]."""
_RANKED = Origin("gearbox and motors", "sum; the order of this page")

_COUNTED = (
    "Gearbox: gears, shafts and carriers, by which designs are chosen and ranked here. Complete: with housing,"
    " bearings, oil system and small parts; it grows where requirements are not met yet, and gearwright compare"
    " --life-h ranks by it."
)
_WHY = (
    "By Lewis and by Hertz the module's cube, and with it the volume of a"
    " stage's gears, is in proportion to the torque of one mesh: a stage is light where many meshes share its torque,"
    " and where it turns fast. Planets share the torque of a slow last stage among them, layshafts two ways;"
    " a solid wheel that carries the whole output torque is what makes the off-set gearboxes heavy. A motor on a fast"
    " shaft is light itself; a motor on the middle shaft takes its power past the first stage."
)


@dataclass(frozen=True)
class DesignView:
    """One design as a whole."""

    design: str
    verdict: str
    """Of its review."""
    total: Annotated[float, Quantity("mass"), Origin("gearbox and machines", "sum")]
    """By which the designs are ranked [kg]."""
    power_density: Annotated[float, Quantity("specific_power"), Origin("rated power / gearbox", "definition")]
    """[W/kg]"""
    gearbox: Annotated[float, Quantity("mass"), Origin("gears, shafts, carriers", "sum")]
    """[kg]"""
    complete: Annotated[float, Quantity("mass"), Origin("Σ of all parts, housing, bearings and oil too", "sum")]
    """[kg]"""
    lightest: Annotated[float, Quantity("mass"), Origin("end of the 68 % band of the complete mass", "held against")]
    """[kg]"""
    heaviest: Annotated[float, Quantity("mass"), Origin("end of the 68 % band of the complete mass", "held against")]
    """[kg]"""
    motors: Annotated[float, Quantity("mass"), Origin("law of torque and speed, or of torque", "machines.electric")]
    """[kg]"""
    inverters: Annotated[float, Quantity("mass"), Origin("rated power over a power density", "machines.electric")]
    """[kg]"""
    cooling: Annotated[float, Quantity("mass"), Origin("by the heat of motor and inverter", "machines.electric")]
    """[kg]"""
    width: Annotated[float, Quantity("length"), Origin("box around tip circles", "geometry")]
    """[m]"""
    height: Annotated[float, Quantity("length"), Origin("box around tip circles", "geometry")]
    """[m]"""
    length: Annotated[float, Quantity("length"), Origin("longest axis", "layout")]
    """[m]"""
    worst: str
    """Worst check."""
    margin: Annotated[float | None, Quantity("ratio"), Origin("of the worst check", "review")]
    """[-]"""


def comparison(
    variants: Table, sizings: Mapping[str, Sizing], reviews: Mapping[str, Review], *, stamp: Stamp = UNSTAMPED
) -> str:
    """Return several sizings side by side as one self-contained HTML page; the same input gives the same bytes.

    Args:
        variants: Table of the study that compares them.
        sizings: Design -> what was sized, of the rows that did not fail.
        reviews: Design -> every check of it.
        stamp: Date of the page.
    """
    ranked = dict(smallest_first(sizings.items(), lambda variant: variant[1].mass + variant[1].machines_mass))
    verdicts = {name: judged(reviews[name]) for name in ranked}
    masses = figure(comparison_figure(variants), "masses", "Masses, lightest first.")
    designs = [_whole(name, sizing, reviews[name]) for name, sizing in ranked.items()]
    wholes = table(
        "Designs, in the order of the column total: gearbox and motors, the lightest first",
        designs,
        tuple(field.name for field in fields(DesignView)),
    )
    rows = [stage for name, sizing in ranked.items() for stage in stage_summaries(sizing, name)]
    stages = table("Stages", rows, tuple(field.name for field in fields(StageSummary)))
    failed = tuple(f"{row.design} is infeasible: {row.problem}" for row in variants.failed)
    beside = tuple(f"{name}: {mass_sentence(reviews[name].complete, reviews[name].statistics)}" for name in ranked)
    sections = [
        Section("Masses", tables=(wholes,), figures=(masses,), notes=(_COUNTED, *failed)),
        Section("Complete masses beside real gearboxes", notes=beside),
        Section("Why they rank so", tables=(stages,), notes=(_WHY,)),
        *(_flow(name, sizing, reviews[name]) for name, sizing in ranked.items()),
    ]
    return set_page(
        Page("Comparison", variants.name, variants.description, _verdict_on_many(verdicts, designs, failed),
             tuple(_numbers(designs)), tuple(sections), stamp=stamp)
    )  # fmt: skip


def _verdict_on_many(verdicts: Mapping[str, Verdict], designs: Sequence[DesignView], failed: Sequence[str]) -> Verdict:
    """Return who is lightest, and how many fail; one that fails keeps the page from saying that all is well."""
    if not designs:
        return Verdict(Tone.BAD, "No design is feasible", " ".join(failed))
    failing = [name for name, verdict in verdicts.items() if verdict.tone is Tone.BAD]
    first = designs[0]
    said = f"The lightest with its motors is {first.design}, {text(first.total, 'mass', 3)}: it {first.verdict}."
    if not failing and not failed:
        return Verdict(worst_of(verdicts.values()), "All pass as far as assessed", said)
    passing = [view.design for view in designs if view.design not in failing]
    lightest = f" The lightest that passes as far as assessed: {passing[0]}." if passing else " None passes."
    infeasible = f" {len(failed)} cannot be sized." if failed else ""
    word = f"{len(failing)} of {len(verdicts)} designs fail"
    return Verdict(Tone.BAD, word, f"{said}{'' if passing[:1] == [first.design] else lightest}{infeasible}")


def _numbers(designs: Sequence[DesignView]) -> Iterator[Number]:
    """Yield the lightest designs, each with its complete mass and band below what it is ranked by."""
    for view in designs[:_SHOWN]:
        yield quantity(f"{view.design}, with motors", view.total, "mass", origin=_RANKED)


def _flow(name: str, sizing: Sizing, review: Review) -> Section:
    caption = "Power flow at rated power: bands as wide as the power, in the colour of its source."
    drawn = figure(power_flow_figure(sizing, sizing.reference.case), name, caption)
    return Section(sizing.design.name, figures=(drawn,), notes=(f"{headline(review)}.",))


def _whole(name: str, sizing: Sizing, review: Review) -> DesignView:
    box, first = envelope(sizing), review.worst
    return DesignView(
        name,
        str(review.verdict),
        sizing.mass + sizing.machines_mass,
        sizing.power_density,
        sizing.mass,
        review.complete.total,
        *review.complete.band,
        sizing.motor_mass,
        sizing.inverter_mass,
        sizing.cooling_mass,
        box.width,
        box.height,
        box.length,
        "" if first is None else first.name,
        None if first is None else first.margin,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Enumerated architectures as one page: the answer, what the best look like, all that were looked at.
# ----------------------------------------------------------------------------------------------------------------------


DRAWN = 12
"""Closed designs that are drawn, the lightest first [-]."""
_HEAD = 5
"""Designs in the head [-]."""


def architectures_page(
    ranking: Ranking, closed: Mapping[str, Particulars], *, turning: str = "", stamp: Stamp = UNSTAMPED
) -> str:
    """Return the ranking as one self-contained HTML page; the same input gives the same bytes.

    Args:
        ranking: From `architectures`.
        closed: Its closed designs, from `closed_designs`.
        turning: Name of the page beside it on which the lightest turns; empty where there is none.
        stamp: Date of the page.
    """
    said = tuple(ranking_sentences(ranking))
    life = text(ranking.life, "life", 3)
    masses = {name: facts.complete for name, facts in closed.items()}
    looks = (
        Section("What they look like", figures=tuple(_drawn_trains(ranking, closed)), content=_link(ranking, turning)),
        Section("Where the mass is", tables=(group_table(masses),)),
    )
    sections = (
        Section(
            "At equal life",
            tables=(equal_life_table(ranking.closed, f"Closed for {life}"), measures_table(ranking.closed)),
            listed=said,
        ),
        *(looks if closed else ()),
        Section(
            f"The {min(SHOWN, len(ranking.candidates))} most promising of {len(ranking.candidates)}",
            tables=(architectures_table(ranking.candidates[:SHOWN], ""),),
        ),
    )
    description = "Every train of a few stages that can give the ratio, with every place for the motor."
    return set_page(
        Page("Architectures", ranking.requirement, description, _verdict_on_architectures(ranking, said),
        tuple(_numbers_of_architectures(ranking)),
             sections, stamp=stamp)
    )  # fmt: skip


def _verdict_on_architectures(ranking: Ranking, said: tuple[str, ...]) -> Verdict:
    """Return whether any meets everything; that others do not is told beside."""
    passing, closed = len(ranking.passing), len(ranking.closed)
    if not closed:
        return Verdict(Tone.OPEN, "None is closed yet", said[-1])
    if not passing:
        return Verdict(Tone.BAD, "None meets everything", said[-1])
    word = f"{passing} of {closed} closed designs pass as far as assessed"
    return Verdict(Tone.OPEN, word, lightest_sentence(ranking))


def _numbers_of_architectures(ranking: Ranking) -> Iterator[Number]:
    """Yield the lightest that pass, with the band of the gearbox."""
    for row in ranking.passing[:_HEAD]:
        yield quantity(f"{ranking.called(row)}, with machines", row.with_machines or 0.0, "mass", digits=3)


def _drawn_trains(ranking: Ranking, closed: Mapping[str, Particulars]) -> Iterator[PageFigure]:
    """Yield the skeletons of the lightest."""
    for row in [row for row in ranking.closed if row.title in closed][:DRAWN]:
        svg = theme.to_svg(schematic_figure(closed[row.title].sizing), row.title)
        yield PageFigure(svg, f"{ranking.called(row)}: {_weight(row)}, {row.verdict}.")


def _link(ranking: Ranking, turning: str) -> Markup:
    """Return where the lightest turns."""
    if not turning or not ranking.passing:
        return Markup()
    words = f"The lightest, {ranking.called(ranking.passing[0])}, as solids that turn"
    return Markup('<p><a href="{}">{}</a></p>').format(turning, words)


def _weight(row: EqualLife) -> str:
    return f"{text(row.with_machines or 0.0, 'mass', 3)} with machines"


# ----------------------------------------------------------------------------------------------------------------------
# Architectures at equal life as one page: which is lightest with its machines, how long it lives, what fails.
# ----------------------------------------------------------------------------------------------------------------------


_SHOWN_AT_EQUAL_LIFE = 5
"""Designs in the head [-]."""


def equal_life_page(
    rows: Sequence[EqualLife], closed: Mapping[str, Particulars], title: str, *, stamp: Stamp = UNSTAMPED
) -> str:
    """Return designs at equal life as one self-contained HTML page; the same input gives the same bytes.

    Args:
        rows: In their order.
        closed: Those that were closed, from `closed_designs`.
        title: In words.
        stamp: Date of the page.
    """
    masses = {name: facts.complete for name, facts in closed.items()}
    sections = [
        Section(
            "Masses, lives and verdicts",
            tables=(equal_life_table(rows, title), measures_table(rows)),
            notes=tuple(equal_life_sentences(rows)),
        ),
        Section("Where the mass is", tables=(group_table(masses),)),
        Section("The sum of parts beside real gearboxes", notes=_beside(rows)),
    ]
    description = "Each design with every free size chosen, and judged by a review of its own."
    return set_page(
        Page("Comparison at equal life", title, description, _verdict_at_equal_life(rows),
        tuple(_numbers_at_equal_life(rows)), tuple(sections),
             stamp=stamp)
    )  # fmt: skip


def _verdict_at_equal_life(rows: Sequence[EqualLife]) -> Verdict:
    """Return how many designs meet everything; one that does not keeps the page from saying that all is well."""
    failing, told = sum(bool(row.fails) for row in rows), tuple(equal_life_sentences(rows))
    said = told[0] if told else "No design is compared."
    if failing:
        return Verdict(Tone.BAD, f"{failing} of {len(rows)} designs do not meet everything", said)
    return Verdict(Tone.OPEN, "All pass as far as assessed", said)


def _numbers_at_equal_life(rows: Sequence[EqualLife]) -> Iterator[Number]:
    """Yield the lightest that pass with all their bearings weighed."""
    for row in [row for row in rows if row.is_compared][:_SHOWN_AT_EQUAL_LIFE]:
        yield quantity(f"{row.title}, with machines", row.with_machines or 0.0, "mass", digits=3)


def _beside(rows: Sequence[EqualLife]) -> tuple[str, ...]:
    return tuple(f"{row.title}: {row.statistics.sentence}" for row in rows if row.statistics is not None)


# ----------------------------------------------------------------------------------------------------------------------
# The answer of a search as one page: what is best, why, what limits cost, how sure it is.
# ----------------------------------------------------------------------------------------------------------------------


def optimum_page(optimum: Optimum, *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the answer of a search as one self-contained HTML page; the same input gives the same bytes.

    Args:
        optimum: From `optimise`.
        stamp: Date of the page.
    """
    said = tuple(optimum_sentences(optimum))
    word = f"{len(optimum.front)} designs that no other one beats"
    page = Page(
        "Search for the best", optimum.study.name, optimum.study.description, Verdict(Tone.OPEN, word, said[0]),
        tuple(_numbers_of_optimum(optimum)), tuple(_sections(optimum, said)), stamp=stamp,
    )  # fmt: skip
    return set_page(page)


def _numbers_of_optimum(optimum: Optimum) -> Iterator[Number]:
    """Yield the objectives of the chosen design, with their bands where something is uncertain."""
    bands = optimum.regrets[0].spread if optimum.regrets else {}
    for name in optimum.objectives:
        value = optimum.best.row.results[name]
        yield quantity(heading(name), optimum.best.row.number(name), value.dimension, band=bands.get(name),
                       share="90 %" if name in bands else "")  # fmt: skip


def _sections(optimum: Optimum, said: tuple[str, ...]) -> Iterator[Section]:
    yield Section("The front", (optimum_table(optimum),), tuple(_front_of_search(optimum)), listed=said)
    yield Section("Why no better", (binding_table(optimum),))
    if optimum.prices:
        yield Section("What limits cost", (price_table(optimum),))
    if optimum.regrets:
        yield Section("How sure the choice is", (regret_table(optimum), influence_table(optimum)))
    growth = figure(growth_figure(optimum), "growth", "Hypervolume of the front after every generation.")
    fits = (fit_table(optimum),) if optimum.fits else ()
    yield Section("How it was found", fits, (growth,))


def _front_of_search(optimum: Optimum) -> Iterator[PageFigure]:
    """Yield the front over the first two objectives, and what its designs have in common."""
    rows = front_rows(optimum)
    chosen = [rows.rows[place] for place in listed(optimum)]
    if len(optimum.objectives) > 1:
        yield figure(
            pareto_figure(optimum.study, rows, rows.rows, chosen), "front", "The front, listed designs by letter."
        )
    if len(optimum.front) > 1:
        best = [rows.rows[optimum.chosen]]
        yield figure(
            parallel_figure(rows, best), "parallel", "Freedoms and results of the front, the chosen one marked."
        )
