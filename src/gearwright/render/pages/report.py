"""Pages of one design: the report, its review, its drawings."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import Annotated, NamedTuple

from gearwright.base import (
    CELSIUS,
    Check,
    Origin,
    Quantity,
    Status,
    by_name,
    largest_first,
    margin_text,
    text,
    verb,
    worst,
    worst_first,
)
from gearwright.closure import REQUIREMENTS, requirement_of
from gearwright.dynamics import Modes, System, Trace
from gearwright.dynamics.motion import Error
from gearwright.dynamics.vibration import DynamicLoad, SpeedCase, dynamic_loads
from gearwright.particulars import Particulars, Reported, particulars, reported
from gearwright.render.figures.masses import (
    aged_bearings,
    bearing_life_figure,
    bent_shafts,
    margin_figure,
    mass_figure,
    shaft_figure,
    treemap_figure,
)
from gearwright.render.figures.motion import every_step, mesh_frequencies, mode_figure, spectrum_figure, time_figure
from gearwright.render.grid import Table, table
from gearwright.render.pages.motion import dynamics_sections
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
    inputs,
    judged,
    judged_by_sizing,
    quantity,
    reserve,
    set_page,
)
from gearwright.render.schematic import power_flow_figure, schematic_figure
from gearwright.render.tables.checks import (
    Judged,
    check_sentence,
    factor_tables,
    judged as judged_checks,
    method_tables,
    review_tables,
    usual_table,
)
from gearwright.render.tables.dynamics import dynamic_table, energy_table, mode_table, motion_tables
from gearwright.render.tables.housing import housing_tables
from gearwright.render.tables.sizing import flow_tables, mass_sentence, motor_rows, passing_table, path_table, tables_of
from gearwright.render.words.design_file import entries
from gearwright.render.words.sizing import unneeded_text
from gearwright.reviews import Review
from gearwright.sizing import AskedSpeed, Sizing
from gearwright.spec import Design, implied
from gearwright.spec.design import RATINGS

# ----------------------------------------------------------------------------------------------------------------------
# A review by requirements: what fails and what would help, and of every requirement its worst check.
# ----------------------------------------------------------------------------------------------------------------------


_NOTHING = ("nothing", "nothing yet")
"""What is told of requirements that the closure changes nothing for."""
_ORDERS = "critical speeds"
"""Requirement that orders belong to."""
_NOTE = (
    "Worst first. Before “else”: what gearwright close changes by itself. Margin: the factor by which loads may grow;"
    " what no load moves, by its distance to the limit."
)


@dataclass(frozen=True)
class Failed:
    """A check that fails, and what would help."""

    part: str
    check: str
    """Mode, symbol and place."""
    case: str
    value: float | None
    """In the unit."""
    limit: float | None
    """In the unit."""
    unit: str
    margin: Annotated[float | None, Quantity("ratio")]
    """1 is just enough [-]."""
    source: str
    what_would_help: str


@dataclass(frozen=True)
class Met:
    """One requirement as a whole."""

    requirement: str
    status: str
    checks: int
    """That are assessed."""
    fail: int
    waived: int
    not_assessed: int
    worst: str
    """Part and check."""
    margin: Annotated[float | None, Quantity("ratio")]
    """Of the worst [-]."""


def failed_table(checks: Iterable[Check]) -> Table:
    """Return what fails, with its limit, its source and what would help.

    Args:
        checks: Of a review.
    """
    rows = [_failed(check) for check in checks if check.fails]
    fields = ("part", "check", "case", "value", "limit", "unit", "margin", "source", "what_would_help")
    return table("", rows, fields, note=_NOTE)


def met_table(checks: Iterable[Check]) -> Table:
    """Return every requirement that checks belong to: those that fail first, then by the worst margin.

    Args:
        checks: Of a review.
    """
    groups: dict[str, list[Check]] = {}
    for check in worst_first(checks):
        groups.setdefault(requirement_of(check), []).append(check)
    rows = sorted((_met(name, group) for name, group in groups.items()), key=_place)
    fields = ("requirement", "status", "checks", "fail", "waived", "not_assessed", "worst", "margin")
    return table("", rows, fields)


def order_table(checks: Iterable[Check]) -> Table:
    """Return every order that excites a mode, or comes near none, the nearest to its limit first.

    Args:
        checks: Of a review.
    """
    orders = [check for check in worst_first(checks) if requirement_of(check) == _ORDERS and check.ratio is not None]
    rows = [
        _Order(check.mode, check.place, check.case, check.value, check.limit, row.status)
        for check, row in zip(orders, judged_checks(orders), strict=True)
    ]
    return table("", rows, ("order", "nearest", "case", "distance", "asked", "status"))


def open_table(checks: Iterable[Check]) -> Table:
    """Return what is not assessed, equal reasons together.

    Args:
        checks: Of a review.
    """
    groups: dict[tuple[str, str], list[Judged]] = {}
    for row in judged_checks(check for check in checks if check.status is Status.NOT_ASSESSED):
        groups.setdefault((row.check, row.why), []).append(row)
    rows = [_Open(", ".join(row.part for row in group), check, why) for (check, why), group in groups.items()]
    return table("", rows, ("part", "check", "why"))


def waived_table(checks: Iterable[Check]) -> Table:
    """Return what fails and is accepted, with the reason.

    Args:
        checks: Of a review.
    """
    return table("", judged_checks(check for check in checks if check.waiver), ("part", "check", "margin", "why"))


@dataclass(frozen=True)
class _Order:
    order: str
    nearest: str
    case: str
    distance: Annotated[float | None, Quantity("percent")]
    asked: Annotated[float | None, Quantity("percent")]
    status: str


@dataclass(frozen=True)
class _Open:
    part: str
    check: str
    why: str


def _failed(check: Check) -> Failed:
    (row,) = judged_checks([check])
    requirement = REQUIREMENTS[requirement_of(check)]
    moved = "" if requirement.moved_by in _NOTHING else f"{requirement.moved_by}; else "
    return Failed(
        row.part, row.check, row.case, row.value, row.limit, row.unit, row.margin, row.source,
        what_would_help=f"{moved}{requirement.helps}",
    )  # fmt: skip


def _met(name: str, checks: list[Check]) -> Met:
    """Return a requirement; the first of its checks is the worst."""
    fails, waived = (sum(1 for check in checks if of(check)) for of in (_fails, _waived))
    left = sum(1 for check in checks if check.status is Status.NOT_ASSESSED)
    assessed = len(checks) - left
    first = checks[0]
    said = "fails" if fails else "waived" if waived else "not assessed" if not assessed else "passes"
    words = "" if not assessed else f"{first.part}: {first.what}"
    return Met(name, said, assessed, fails, waived, left, words, first.margin)


def _fails(check: Check) -> bool:
    return check.fails


def _waived(check: Check) -> bool:
    return bool(check.waiver)


def _place(row: Met) -> tuple[int, float]:
    return ("fails", "waived", "passes", "not assessed").index(row.status), row.margin or 0.0


# ----------------------------------------------------------------------------------------------------------------------
# What the report says beside its tables and figures: key numbers, warnings, assumptions.
# ----------------------------------------------------------------------------------------------------------------------


EQUAL = 1e-6
"""Part by which a peak of one run may lie above that of another and be the same [-]."""
TOLD = ("contact", "interrupted", "chaotic", "sensitive", "asked were")
"""Words of a run's notes that its reader is warned of."""


def key_numbers(facts: Particulars, review: Review | None = None) -> tuple[Number, ...]:
    """Return what a reader asks first, with bands where they are known.

    Args:
        facts: Of a sizing.
        review: Of it; left out: the margin is that of the checks of sizing alone.
    """
    sizing, whole = facts.sizing, facts.complete
    rated = sizing.reference
    taken = [name for name, power in rated.machine_powers.items() if power < 0.0]
    torque = max((abs(rated.machine_torques[name]) for name in taken), default=0.0)
    gears = Origin("gears, shafts, carriers", "sum; by this mass designs are chosen")
    numbers = [
        quantity("complete mass", whole.total, "mass", digits=3, band=whole.band, share="68 %"),
        quantity("rated power", sizing.rated_power, "power"),
        quantity("output torque", torque, "torque"),
        quantity("power density of the train as sized", sizing.power_density, "specific_power"),
        *reserve(worst(sizing.checks) if review is None else review.worst),
        *([quantity("its gears, shafts, carriers", whole.train, "mass", digits=3)] if whole.train else []),
        quantity("train as sized", sizing.mass, "mass", origin=gears),
        *(quantity(name, mass, "mass") for name, mass in motor_rows(sizing) if mass),
        Number("level", sizing.level if "level" not in implied(sizing.design) else f"{sizing.level}, by default"),
    ]
    return tuple(numbers)


def warnings(facts: Particulars, traces: Mapping[str, Trace], review: Review | None = None) -> tuple[str, ...]:
    """Return what is not as asked.

    Args:
        facts: Of a sizing.
        traces: Load case -> run, of those that were simulated.
        review: Of it, if it is shown.
    """
    sizing = facts.sizing
    checks = sizing.checks if review is None else review.checks
    sentences = [f"{check_sentence(check)}; it should be 1 or more." for check in checks if check.fails]
    sentences += [f"{check_sentence(check)}; waived: {check.waiver}." for check in checks if check.waiver]
    if review is not None:
        sentences += [f"{unneeded_text(name)}." for name in review.unneeded]
    sentences += facts.remarks
    sentences += _yielded(facts.asked_speeds)
    sentences += [
        f"{text(loop.power, 'power')} circulate in case {case}: {', '.join(loop.path)}."
        for case, loops in facts.loops.items()
        for loop in loops
    ]
    sentences += _given(sizing)
    for case, trace in traces.items():
        sentences += [
            f"{load.mesh}, case {case}: with the simulated peak force, {load.peak_over_mean:.2f} times the mean, the"
            f" margins are {margin_text(load.bending_margin)} (bending) and {margin_text(load.contact_margin)}"
            " (contact)."
            for load in dynamic_loads(sizing, trace)
            if min(load.bending_margin, load.contact_margin) < 1.0 and not _said(load, checks)
        ]
        telling = (note for note in trace.notes if any(words in note for words in TOLD))
        sentences += [f"Case {case}: {note}." for note in telling]
    return tuple(sentences)


def _said(load: DynamicLoad, checks: Sequence[Check]) -> bool:
    """Return whether a review tells of a peak that is as large, in whatever case."""
    peaks = {check.mode: check.margin or 0.0 for check in checks if str(check.part) == load.mesh}
    both = (("peak bending", load.bending_margin), ("peak contact", load.contact_margin))
    return all(mode in peaks and peaks[mode] <= margin * (1.0 + EQUAL) for mode, margin in both)


def _given(sizing: Sizing) -> list[str]:
    """Return one sentence for each origin of values that are given in place of computed ones."""
    paths: dict[str, list[str]] = {}
    for path, given in sizing.given.items():
        paths.setdefault(given.origin, []).append(path)
    return [f"Given in place of computed values ({origin}): {', '.join(names)}." for origin, names in paths.items()]


def _yielded(speeds: Iterable[AskedSpeed]) -> list[str]:
    """Return one sentence for each speed that yields, whatever the number of cases."""
    cases: dict[str, list[str]] = {}
    for speed in speeds:
        words = (
            f"{speed.machine} turns at {text(speed.actual, 'speed')}, asked were {text(speed.asked, 'speed')}"
            f" ({speed.deviation:+.2%}): the teeth give no better"
        )
        cases.setdefault(words, []).append(speed.case)
    return [f"{words} (case {', '.join(names)})." for words, names in cases.items()]


_COUNTED = (
    "The train as sized, by which designs are chosen, counts gears, shafts and carriers before webs and seats are cut"
    " out of them or added; the complete mass takes them as manufactured, with housing, bearings, oil system and small"
    " parts. Motors are in neither."
)
_MOUNTED = (
    "Shafts rest on two radial bearings, each at the middle of its width and rigid; stresses by forces along shafts are"
    " left out.",
    "Loads of rotors act in every load case, across the shaft in the direction that bends it most.",
    "Bearings have basic rating lives, without a_ISO for oil and dirt; catalogue ratings are those of ISO 281 and"
    " ISO 76 for an assumed inside.",
)


def assumptions(sizing: Sizing, nominal: Collection[str]) -> tuple[str, ...]:
    """Return what was assumed, as far as the design leaves it open.

    Args:
        sizing: As sized.
        nominal: Stages whose method has no factors for peaks of the load.
    """
    design = sizing.design
    sentences = [_COUNTED]
    if not any(flow.loss for flow in sizing.flows.values()):
        sentences.append("Power flow without losses in the meshes.")
    if all(mesh.load_factor == 1.0 for mesh in sizing.meshes):
        sentences.append("Parallel meshes share the load equally: K_γ = 1.")
    sentences += _nominal(design, nominal)
    if any(_keeps_idlers(design, stage) for stage in design.planetaries):
        sentences.append("Planets, loaded on both flanks, keep the full bending allowable; ISO 6336-3 takes 0.7 of it.")
    if all(shaft.bending_moment == 0.0 for shaft in sizing.shafts):
        sentences.append("Shafts carry torsion alone.")
    if sizing.built_shafts:
        sentences += _MOUNTED
    estimated = [machine.name for machine in sizing.machines if not machine.inertia_is_given]
    if estimated:
        sentences.append(f"Inertia estimated, not given: {', '.join(estimated)}.")
    if any(pair.kind == "face" for pair in design.pairs.values()):
        sentences.append("Face-gear pairs are drawn as if their axes were parallel.")
    return tuple(sentences)


def _nominal(design: Design, stages: Collection[str]) -> list[str]:
    """Return a sentence where the method of some stages has no factors for peaks of the load."""
    if not stages:
        return []
    whose = "Gears" if len(stages) == len(design.stages) else f"Gears of {', '.join(stages)}"
    return [f"{whose} are sized without application and dynamic factor (K_A = K_v = 1); see the peaks of a run."]


def _keeps_idlers(design: Design, stage: str) -> bool:
    """Tell whether the method of a stage leaves it to a factor what idlers bear, and none is given."""
    return "idler_factor" in RATINGS[design.rating(stage)].reads and design.rules(stage).idler_factor == 1.0


# ----------------------------------------------------------------------------------------------------------------------
# The report: one HTML page that stands alone, for the screen and for paper.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def report(
    sizing: Sizing | Reported,
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
        sizing: As sized, or what `reported` gives of it.
        modes: Natural modes, if they are to be in it.
        trace: A run, if it is to be in it.
        case: Load case of the summary, of modes and run; left out: the governing one, which has the least margin.
        others: Load case -> run, of further cases that are to be in it.
        system: Assembled for that case; with it mode shapes are drawn on the train and the model's assumptions listed.
        campbell: Critical speeds, if they are to be in it.
        review: Every check, from `gw.review`; left out: the page shows those of sizing alone, and says so.
        stamp: Date of the page and lines of the design file, which only the caller knows.
    """
    told = sizing if isinstance(sizing, Reported) else reported(particulars(sizing), system)
    facts, sizing = told.particulars, told.particulars.sizing
    case = case or facts.governing
    traces = {**({case: trace} if trace else {}), **(others or {})}
    for name in traces:
        by_name(name, sizing.flows, "case")
    tables, warned = tables_of(facts), warnings(facts, traces, review)
    sections = [
        Section("Summary", tables=_judged(tables["margins"], review), figures=(_flow(sizing, case),), listed=warned),
        _power(told, tables["speeds"], case),
        *_parts(told, tables),
        *([_modes(modes, case, drawn=system is not None)] if modes else []),
        *(_dynamics(sizing, run, name) for name, run in traces.items()),
    ]
    if system is not None:
        sections += dynamics_sections(told, system, case=case, modes=modes, trace=trace, campbell=campbell)
    assumed = assumptions(sizing, told.nominal)
    sections.append(Section("Assumptions", tables=_filled(usual_table(told.usual)), listed=assumed))
    given, default = inputs(entries(sizing.design), of="design", lines=stamp.lines)
    given = replace(given, tables=_filled(tables["overrides"]))
    return set_page(
        Page(
            "Report", sizing.design.name, sizing.design.description, _verdict(sizing, traces, review),
            key_numbers(facts, review), tuple(sections), (given, default), sizing.design, stamp,
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


def _flow(sizing: Sizing, case: str) -> PageFigure:
    caption = f"Power flow in case {case}: bands as wide as the power, in the colour of its source."
    return figure(power_flow_figure(sizing, case), f"flow-{_safe(case)}", caption)


def _power(reported: Reported, speeds: Table, told: str) -> Section:
    """Return the architecture, and the power flow of every case that the summary does not show."""
    facts, sizing = reported.particulars, reported.particulars.sizing
    skeleton = figure(schematic_figure(sizing), "train", "Skeleton of the train with tooth numbers.")
    others = [_flow(sizing, case) for case in sizing.flows if case != told]
    tables = _filled(speeds, *flow_tables(facts.branches), passing_table(facts.passing), path_table(reported.paths))
    return Section("Architecture and power flow", tables=tables, figures=(skeleton, *others))


def _parts(told: Reported, tables: Mapping[str, Table]) -> Iterator[Section]:
    sizing = told.particulars.sizing
    margins = figure(margin_figure(sizing), "margins", "Margins of all that sizing checks, worst first.")
    mass = figure(mass_figure(told.particulars), "mass", "Mass of every part, heaviest first.")
    yield _chapter("Gears", tables, "gears")
    yield _chapter(
        "Meshes: forces, stresses and margins", tables, "meshes", "load_factors", "rating", figures=(margins,)
    )
    if told.factors:
        yield Section("Rating of the gears", tables=tuple(factor_tables(told.factors).values()))
        yield Section("The gears by every method", tables=tuple(method_tables(told.methods).values()))
    caption = "Shear, bending (both planes together) and torsion in the case that governs; triangles are bearings."
    bent = (figure(shaft_figure(sizing), "shafts", caption),) if bent_shafts(sizing) else ()
    loaded = ("shafts", "shaft_sizes", "bearings", "airscrew_loads", "carriers", "planet_bearings", "machines")
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


def _chapter(title: str, tables: Mapping[str, Table], *names: str, figures: tuple[PageFigure, ...] = ()) -> Section:
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


# ----------------------------------------------------------------------------------------------------------------------
# The page that goes into a design review: the verdict, requirement by requirement, and every kilogram.
# ----------------------------------------------------------------------------------------------------------------------


HEAVIEST = 8
"""Parts of the complete mass that are listed one by one [-]."""
_FOOTER = "Margins of stresses include the asked factor; of a life L of which L_a is asked, (L/L_a)^(1/p)."
_FACTS = {
    "heat": "heat at rated load",
    "oil_flow": "oil flow",
    "fuel": "fuel of the mission",
    "battery_energy": "battery energy",
    "hottest_oil": "hottest oil in flight",
}
"""Facts of a review beside its masses -> how the page calls them."""


def review_page(review: Review, *, design: Design | None = None, stamp: Stamp = UNSTAMPED) -> str:
    """Return a review as one self-contained HTML page; the same input gives the same bytes.

    Args:
        review: Of a design.
        design: That it judges, for its hash.
        stamp: Date of the page.
    """
    flown = f"Flying {review.mission}." if review.mission else "On the ground: no mission is flown."
    return set_page(
        Page("Design review", review.design, flown, judged(review), tuple(_numbers(review)), _sections(review),
             design=design, stamp=stamp, footer=_FOOTER)
    )  # fmt: skip


def _numbers(review: Review) -> Iterator[Number]:
    """Yield what a reader asks first."""
    yield from reserve(review.worst)
    yield quantity("complete mass", review.complete.total, "mass", digits=3, band=review.complete.band, share="68 %")
    machines = sum(float(review.facts[name].value) for name in ("motor_mass", "inverter_mass", "cooling_mass"))
    if machines:
        with_them = f"with machines of {text(machines, 'mass', 3)}"
        yield quantity(with_them, review.complete.total + machines, "mass", digits=3)
    known = review.statistics
    if known.mass is not None and known.low is not None and known.high is not None:
        band = (known.low, known.high)
        yield quantity("61 real gearboxes", known.mass, "mass", digits=3, band=band, share="68 %")
    sides = [1e3 * float(review.facts[f"envelope.{side}"].value) for side in ("width", "height", "length")]
    yield Number("bodies: width, height, length", " × ".join(f"{side:.0f}" for side in sides), "mm")
    for name, words in _FACTS.items():
        if name in review.facts:
            value, dimension = review.facts[name]
            hottest = name == "hottest_oil"
            shift, shown_as = (CELSIUS, "temperature") if hottest else (0.0, dimension)
            yield quantity(words, float(value) - shift, shown_as, digits=3)


def _sections(review: Review) -> tuple[Section, ...]:
    """Return the chapters; one without content is left out."""
    mass = review.complete
    groups = table("Groups", mass.groups, ("group", "total", "share", "deviation"))
    heaviest = largest_first(mass.parts, lambda item: item.total)[:HEAVIEST]
    parts = table("Heaviest parts", heaviest, ("part", "group", "count", "each", "total", "uncertainty", "formula"))
    nothing = () if review.waived else ("Nothing is waived.",)
    waived = (*nothing, *(f"{unneeded_text(name)}." for name in review.unneeded))
    chapters = (
        Section("What fails, and what would help", tables=(failed_table(review.checks),)),
        Section("Requirement by requirement", tables=(met_table(review.checks),)),
        Section("Kilograms", (groups, parts), (_areas(review),), notes=(mass_sentence(mass, review.statistics),)),
        Section("Orders and natural frequencies", tables=(order_table(review.checks),)),
        Section("Housing and maintenance", tables=housing_tables(review)),
        Section("Waived by the design", tables=(waived_table(review.checks),), notes=waived),
        Section("Not assessed, and why", tables=(open_table(review.checks),)),
    )
    return tuple(section for section in chapters if section.notes or _rows(section.tables))


def _areas(review: Review) -> PageFigure:
    drawn = treemap_figure(review.complete, review.statistics.low, review.statistics.high)
    return figure(drawn, "kilograms", "Every part as an area, in the colour of its group; below, where the whole lies.")


def _rows(tables: tuple[Table, ...]) -> bool:
    return any(chain.from_iterable(part.rows for part in tables))


# ----------------------------------------------------------------------------------------------------------------------
# Technical drawings of a design as one self-contained HTML page: the sheets, to scale on paper.
# ----------------------------------------------------------------------------------------------------------------------


class DrawnSheet(NamedTuple):
    """A sheet as it stands on the page."""

    name: str
    """Of its file."""
    title: str
    size: str
    """Such as ``A3``."""
    scale: str
    """Such as ``1:2``."""
    svg: str
    """With ids of its own."""


def sheets_page(facts: Particulars, drawn: Sequence[DrawnSheet], *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        facts: Of a sizing.
        drawn: Its sheets.
        stamp: Date of the page.
    """
    sizing, room = facts.sizing, facts.envelope
    numbers = (
        Number("sheets", f"{len(drawn)}", "", float(len(drawn))),
        quantity("gears, shafts, carriers", facts.complete.train, "mass"),
        quantity("width", room.width, "length"),
        quantity("height", room.height, "length"),
        quantity("length", room.length, "length"),
    )
    sections = tuple(Section(sheet.title, figures=(_figure(sheet),)) for sheet in drawn)
    return set_page(
        Page("Drawings", sizing.design.name, sizing.design.description, judged_by_sizing(sizing), numbers, sections,
             design=sizing.design, stamp=stamp, footer="Sheets to ISO conventions, in mm; print each from its file.")
    )  # fmt: skip


def _figure(sheet: DrawnSheet) -> PageFigure:
    titled = sheet.svg.replace("<svg ", '<svg role="img" ', 1)
    return PageFigure(titled, f"{sheet.name}: {sheet.size}, {sheet.scale}.", sheet.name)
