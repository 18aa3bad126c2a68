"""Several sizings side by side: which is lightest, where their mass is, and why."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Annotated

from gearwright.ranking import smallest_first
from gearwright.render.figures.study.lines import comparison_figure
from gearwright.render.grid.table import table
from gearwright.render.pages.page import (
    UNSTAMPED,
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
from gearwright.render.schematic.schematic import power_flow_figure
from gearwright.render.tables.sizing.masses import mass_sentence
from gearwright.render.words.headline import headline
from gearwright.reviews import Review
from gearwright.sizing import Sizing, StageSummary, stage_summaries
from gearwright.sizing.arrangement import envelope
from gearwright.study import Table
from gearwright.units import Origin, Quantity, text

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
