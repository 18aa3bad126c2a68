"""The report: one HTML page that stands alone, for the screen and for paper."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from gearwright.dynamics import Modes, System, Trace
from gearwright.dynamics.motion import Error
from gearwright.dynamics.vibration import SpeedCase, dynamic_loads
from gearwright.errors import by_name
from gearwright.render.figures.motion import every_step, mesh_frequencies, mode_figure, spectrum_figure, time_figure
from gearwright.render.figures.sizing import (
    aged_bearings,
    bearing_life_figure,
    bent_shafts,
    margin_figure,
    mass_figure,
    shaft_figure,
)
from gearwright.render.grid.table import Table
from gearwright.render.pages.appendices import inputs
from gearwright.render.pages.designs.dynamics_sections import dynamics_sections
from gearwright.render.pages.designs.report_parts import assumptions, key_numbers, warnings
from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Page,
    Section,
    Stamp,
    Tone,
    Verdict,
    figure,
    judged,
    judged_by_sizing,
    set_page,
)
from gearwright.render.schematic.schematic import power_flow_figure, schematic_figure
from gearwright.render.tables.checks import review_tables
from gearwright.render.tables.dynamic_load import dynamic_table
from gearwright.render.tables.motion import energy_table, mode_table, motion_tables
from gearwright.render.tables.paths import path_table
from gearwright.render.tables.sizing.factors import factor_tables, usual_table
from gearwright.render.tables.sizing.methods import method_tables
from gearwright.render.tables.sizing.overview import flow_tables, passing_table, tables_of
from gearwright.render.words.inputs import entries
from gearwright.reviews import Review
from gearwright.sizing import Sizing, governing_case
from gearwright.verbs import verb


@verb
def report(
    sizing: Sizing,
    *,
    modes: Modes | None = None,
    trace: Trace | None = None,
    case: str | None = None,
    others: Mapping[str, Trace] | None = None,
    system: System | None = None,
    campbell: Sequence[SpeedCase] = (),
    review: Review | None = None,
    stamp: Stamp = UNSTAMPED,
) -> str:
    """Return the report of a sizing as one self-contained HTML page; the same input gives the same bytes.

    Args:
        sizing: As sized.
        modes: Natural modes, if they are to be in it.
        trace: A run, if it is to be in it.
        case: Load case of the summary, of modes and run; left out: the governing one, which has the least margin.
        others: Load case -> run, of further cases that are to be in it.
        system: Assembled for that case; with it mode shapes are drawn on the train and the model's assumptions listed.
        campbell: Critical speeds, if they are to be in it.
        review: Every check, from `gw.review`; left out: the page shows those of sizing alone, and says so.
        stamp: Date of the page and lines of the design file, which only the caller knows.
    """
    case = case or governing_case(sizing)
    traces = {**({case: trace} if trace else {}), **(others or {})}
    for name in traces:
        by_name(name, sizing.flows, "case")
    tables = tables_of(sizing)
    told = warnings(sizing, traces, review)
    sections = [
        Section("Summary", tables=_judged(tables["margins"], review), figures=(_flow(sizing, case),), listed=told),
        _power(sizing, tables["speeds"], case),
        *_parts(sizing, tables),
        *([_modes(modes, case, drawn=system is not None)] if modes else []),
        *(_dynamics(sizing, run, name) for name, run in traces.items()),
    ]
    if system is not None:
        sections += dynamics_sections(sizing, system, case=case, modes=modes, trace=trace, campbell=campbell)
    sections.append(Section("Assumptions", tables=_filled(usual_table(sizing)), listed=assumptions(sizing)))
    given, default = inputs(entries(sizing.design), of="design", lines=stamp.lines)
    given = replace(given, tables=_filled(tables["overrides"]))
    return set_page(
        Page(
            "Report", sizing.design.name, sizing.design.description, _verdict(sizing, traces, review),
            key_numbers(sizing, review), tuple(sections), (given, default), sizing.design, stamp,
        )
    )  # fmt: skip


def _verdict(sizing: Sizing, traces: Mapping[str, Trace], review: Review | None) -> Verdict:
    """Return the verdict of the review, or of sizing; a run whose peaks break a margin lets neither pass."""
    said = judged_by_sizing(sizing) if review is None else judged(review)
    if said.tone is Tone.BAD:
        return said
    for case, trace in traces.items():
        loads = dynamic_loads(sizing, trace)  # the worst first
        broken = [load for load in loads if min(load.bending_margin, load.contact_margin) < 1.0]
        if broken:
            most = f"most of all {broken[0].mesh}, case {case}"
            words = f"Under the simulated peaks {len(broken)} of {len(loads)} meshes break a margin, {most}."
            return Verdict(Tone.BAD, "Fails", f"{words} {said.said}")
    return said


def _judged(margins: Table, review: Review | None) -> tuple[Table, ...]:
    """Return the margins of sizing, or in their place all that a review judges, and what it leaves open."""
    return (margins,) if review is None else _filled(*review_tables(review.checks))


def _flow(sizing: Sizing, case: str) -> Figure:
    caption = f"Power flow in case {case}: bands as wide as the power, in the colour of its source."
    return figure(power_flow_figure(sizing, case), f"flow-{_safe(case)}", caption)


def _power(sizing: Sizing, speeds: Table, shown: str) -> Section:
    """Return the architecture, and the power flow of every case that the summary does not show."""
    skeleton = figure(schematic_figure(sizing), "train", "Skeleton of the train with tooth numbers.")
    others = [_flow(sizing, case) for case in sizing.flows if case != shown]
    tables = _filled(speeds, *flow_tables(sizing), passing_table(sizing), path_table(sizing))
    return Section("Architecture and power flow", tables=tables, figures=(skeleton, *others))


def _parts(sizing: Sizing, tables: Mapping[str, Table]) -> Iterator[Section]:
    margins = figure(margin_figure(sizing), "margins", "Margins of all that sizing checks, worst first.")
    mass = figure(mass_figure(sizing), "mass", "Mass of every part, heaviest first.")
    yield _chapter("Gears", tables, "gears")
    yield _chapter(
        "Meshes: forces, stresses and margins", tables, "meshes", "load_factors", "rating", figures=(margins,)
    )
    factors = tuple(factor_tables(sizing).values())
    if factors:
        yield Section("Rating of the gears", tables=factors)
        yield Section("The gears by every method", tables=tuple(method_tables(sizing).values()))
    caption = "Shear, bending (both planes together) and torsion in the case that governs; triangles are bearings."
    bent = (figure(shaft_figure(sizing), "shafts", caption),) if bent_shafts(sizing) else ()
    loaded = ("shafts", "shaft_sizes", "bearings", "carriers", "planet_bearings", "machines")
    yield _chapter("Shafts, carriers and machines", tables, *loaded, figures=bent)
    if sizing.built_shafts:
        built = ("bearing_sizes", "bearing_oil", "joints", "steps", "strength", "stiffness")
        lives = aged_bearings(sizing)
        caption = "Rating lives of the bearings, the shortest first."
        aged = (figure(bearing_life_figure(lives), "bearings", caption),) if lives else ()
        yield _chapter("Shafts as built, bearings and joints", tables, *built, figures=aged)
    yield _chapter("Losses", tables, "losses", "loss_parts")
    yield _chapter("Materials", tables, "materials")
    yield _chapter("Mass and envelope", tables, "mass", "envelope", figures=(mass,))
    yield _chapter("Places in space", tables, "turns", "places")


def _chapter(title: str, tables: Mapping[str, Table], *names: str, figures: tuple[Figure, ...] = ()) -> Section:
    return Section(title, _filled(*(tables[name] for name in names)), figures)


def _filled(*tables: Table) -> tuple[Table, ...]:
    return tuple(table for table in tables if table.rows)


def _modes(modes: Modes, case: str, *, drawn: bool) -> Section:
    """Return the table of modes, with bars per coordinate where their shapes are not drawn on the train."""
    caption = f"Lowest elastic modes, case {case}; each coordinate over the largest of its kind."
    figures = () if drawn else (figure(mode_figure(modes), "modes", caption),)
    return Section("Natural modes", tables=(mode_table(modes, case=case),), figures=figures)


def _dynamics(sizing: Sizing, trace: Trace, case: str) -> Section:
    figures = [figure(time_figure(trace), f"time-{_safe(case)}", f"Forces and torques against time, case {case}.")]
    notes = [
        f"Case {case}. {trace.duration:.4g} s in steps of {trace.step:.3g} s, {trace.method};"
        f" {Error(trace.error, trace.rms_error).words()}."
    ]
    if every_step(trace) is not None:
        drawing = spectrum_figure(trace, mesh_frequencies(sizing, case))
        caption = f"Amplitude spectra with mesh frequencies and their multiples, case {case}."
        figures.append(figure(drawing, f"spectrum-{_safe(case)}", caption))
    else:
        notes.append("No spectrum: no stretch of the run was kept at every step.")
    tables = (*motion_tables(trace), dynamic_table(sizing, trace), energy_table(trace))
    return Section(
        f"Dynamic response, case {case}", tables=tables, figures=tuple(figures), notes=(*notes, *trace.notes)
    )


def _safe(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9-]", "-", name)
