"""Pages of many designs side by side: comparisons, architectures, designs at equal life, searches."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Annotated

from markupsafe import Markup

from gearwright.arrays import smallest_first
from gearwright.enumeration import Ranking
from gearwright.optimum import Optimum
from gearwright.particulars import Particulars
from gearwright.render import style as theme
from gearwright.render.figures.study import comparison_figure, growth_figure, parallel_figure, pareto_figure
from gearwright.render.grid import table
from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Number,
    Page,
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
from gearwright.render.tables.study import SHOWN_ARCHITECTURES as SHOWN
from gearwright.render.tables.study import (
    architectures_table,
    binding_table,
    equal_life_table,
    fit_table,
    front_rows,
    group_table,
    influence_table,
    listed,
    optimum_table,
    price_table,
    regret_table,
)
from gearwright.render.tables.variants import heading
from gearwright.render.words.sizing import headline
from gearwright.render.words.study import lightest_sentence, optimum_sentences, ranking_sentences
from gearwright.reviews import Review
from gearwright.sizing import Sizing, StageSummary, stage_summaries
from gearwright.sizing.arrangement import envelope
from gearwright.study import Table
from gearwright.study.architectures import EqualLife
from gearwright.units import Origin, Quantity, text

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
    total: Annotated[float, Quantity("mass"), Origin("gearbox and motors", "sum")]
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
    motors: Annotated[float, Quantity("mass"), Origin("NDARC or thesis law", "NASA/TP-2015-218751; Pulvirenti 2023")]
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
    ranked = dict(smallest_first(sizings.items(), lambda variant: variant[1].mass + variant[1].motor_mass))
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
        Page("Comparison", variants.name, variants.description, _verdict(verdicts, designs, failed),
             tuple(_numbers(designs)), tuple(sections), stamp=stamp)
    )  # fmt: skip


def _verdict(verdicts: Mapping[str, Verdict], designs: Sequence[DesignView], failed: Sequence[str]) -> Verdict:
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
        sizing.mass + sizing.motor_mass,
        sizing.power_density,
        sizing.mass,
        review.complete.total,
        *review.complete.band,
        sizing.motor_mass,
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
        Section("What they look like", figures=tuple(_drawn(ranking, closed)), content=_link(ranking, turning)),
        Section("Where the mass is", tables=(group_table(masses),)),
    )
    sections = (
        Section("At equal life", tables=(equal_life_table(ranking.closed, f"Closed for {life}"),), listed=said),
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


def _drawn(ranking: Ranking, closed: Mapping[str, Particulars]) -> Iterator[Figure]:
    """Yield the skeletons of the lightest."""
    for row in [row for row in ranking.closed if row.title in closed][:DRAWN]:
        svg = theme.to_svg(schematic_figure(closed[row.title].sizing), row.title)
        yield Figure(svg, f"{ranking.called(row)}: {_weight(row)}, {row.verdict}.")


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
        Section("Masses, lives and verdicts", tables=(equal_life_table(rows, title),), notes=_told(rows)),
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
    failing, told = sum(bool(row.fails) for row in rows), _told(rows)
    said = told[0] if told else "No design is compared."
    if failing:
        return Verdict(Tone.BAD, f"{failing} of {len(rows)} designs do not meet everything", said)
    return Verdict(Tone.OPEN, "All pass as far as assessed", said)


def _numbers_at_equal_life(rows: Sequence[EqualLife]) -> Iterator[Number]:
    """Yield the lightest that pass."""
    for row in [row for row in rows if not row.fails and row.with_machines is not None][:_SHOWN_AT_EQUAL_LIFE]:
        yield quantity(f"{row.title}, with machines", row.with_machines or 0.0, "mass", digits=3)


def _told(rows: Sequence[EqualLife]) -> tuple[str, ...]:
    """Return who is lightest, and who meets not everything and by what."""
    passing = [row for row in rows if not row.fails and row.with_machines is not None]
    first = () if not passing else (_lightest(passing[0]),)
    return first + tuple(f"{row.title} does not meet everything: {row.fails}." for row in rows if row.fails)


def _lightest(row: EqualLife) -> str:
    machines = f" with machines of {text(row.machines, 'mass', 3)}" if row.machines else ""
    weighs = text(row.with_machines or 0.0, "mass", 3)
    return f"The lightest that passes as far as assessed: {row.title}, {weighs}{machines}."


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
    yield Section("The front", (optimum_table(optimum),), tuple(_front(optimum)), listed=said)
    yield Section("Why no better", (binding_table(optimum),))
    if optimum.prices:
        yield Section("What limits cost", (price_table(optimum),))
    if optimum.regrets:
        yield Section("How sure the choice is", (regret_table(optimum), influence_table(optimum)))
    growth = figure(growth_figure(optimum), "growth", "Hypervolume of the front after every generation.")
    fits = (fit_table(optimum),) if optimum.fits else ()
    yield Section("How it was found", fits, (growth,))


def _front(optimum: Optimum) -> Iterator[Figure]:
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
