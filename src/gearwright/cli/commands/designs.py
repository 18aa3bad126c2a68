"""Commands for one design: files, check, size, run, review, closure, arrangement, modes, report and workbench."""

from __future__ import annotations

import json as json_text
from collections.abc import Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, NamedTuple

import typer

from gearwright.cli.answers import (
    ANSWERS,
    CTRL_C,
    answer_schema,
    answer_text,
    end_interrupted,
    interrupted,
    interrupted_code,
    interrupted_name,
    named_after,
    save_runs,
    show_answer,
    show_rows,
)
from gearwright.cli.commands.studies import refuse_files
from gearwright.cli.options import (
    CaseOption,
    DateOption,
    DesignArgument,
    FreeOption,
    JsonOption,
    LinesOption,
    PdfOption,
    design_of,
    designs,
    missions,
    placed_in,
    reviewed,
    shipped,
    sized,
    stamped,
)
from gearwright.cli.terminal import progress, show, show_commands, show_json, tell
from gearwright.errors import DesignError, GearwrightError, Problem, near
from gearwright.files import make_folder, write_bytes, write_text
from gearwright.signals import answered

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from gearwright.closure import Closed, ClosedArrangement, Contradiction, Course, Eased, Source, Variants, Wishes
    from gearwright.dynamics import Modes, System, Trace
    from gearwright.dynamics.vibration import SpeedCase
    from gearwright.particulars import Particulars
    from gearwright.render.pages.page import Stamp
    from gearwright.reviews import Review
    from gearwright.sizing import Sizing
    from gearwright.spec import Design
    from gearwright.store import StoredRun


# ----------------------------------------------------------------------------------------------------------------------
# The commands ``new`` and ``schema``: files to start from, and what editors and scripts need to know of files.
# ----------------------------------------------------------------------------------------------------------------------


class File(StrEnum):
    """Files that users write."""

    DESIGN = "design"
    MISSION = "mission"
    MIX = "mix"
    STUDY = "study"


def new(
    name: Annotated[
        str | None,
        typer.Argument(
            help="A shipped design, mission, mix, study or notebook; left out: list them",
            autocompletion=shipped,
        ),
    ] = None,
    file: Annotated[
        Path | None, typer.Argument(help="File to write; left out: NAME.toml here, of a notebook NAME.ipynb")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that is there")] = False,
    json: JsonOption = False,
) -> None:
    """Write a shipped design, mission, mix, study or notebook as a file to start from, or list all of them."""
    from gearwright.shipped import shipped_file

    if name is None:
        _list(json=json)
        return
    source = shipped_file(name)
    target = file or Path(source.name)
    if target.exists() and not force:
        raise DesignError(
            [Problem("", "the file is there already; give another name, or --force to replace it")], str(target)
        )
    if source.parent.name == "notebooks":
        write_bytes(target, source.read_bytes())
        show(f"wrote {target}; next: jupyter lab {target}, or any editor of notebooks")
        return
    _write_headed(source, target)


def _write_headed(source: Path, target: Path) -> None:
    """Write a shipped file under a line that names its schema, and the schema beside it; say what follows."""
    kind = {"designs": File.DESIGN, "missions": File.MISSION, "mixes": File.MIX, "studies": File.STUDY}[
        source.parent.name
    ]
    beside = target.with_name(f"gearwright-{kind.value}.schema.json")
    write_text(target, f"#:schema ./{beside.name}\n{source.read_text(encoding='utf-8')}")
    write_text(beside, _schema_text(kind))
    follows = {"designs": "run", "missions": "fly DESIGN", "mixes": "mix DESIGN", "studies": "study"}[
        source.parent.name
    ]
    show(f"wrote {target}; next: gearwright {follows} {target}")


def _schema_text(kind: File) -> str:
    """Return the schema of a file, which lies beside it so that editors find it without a network."""
    from gearwright.spec import schema as file_schema

    return json_text.dumps(file_schema(kind.value), indent=1, ensure_ascii=False) + "\n"


def _list(*, json: bool) -> None:
    """Print every shipped file with its name, under what it is."""
    from gearwright.render.answers.weights import NewAnswer
    from gearwright.render.words.design_file import shipped_files

    files = shipped_files()
    if json:
        show_answer("new", NewAnswer(files))
        return
    width = max(len(file.name) for file in files)
    for kind, title in (
        ("design", "designs"),
        ("mission", "\nmissions"),
        ("mix", "\nmixes"),
        ("study", "\nstudies"),
        ("notebook", "\nnotebooks"),
    ):
        show(title)
        for file in files:
            if file.kind == kind:
                show(f"{file.name:{width}} {file.title}")


def schema(
    of: Annotated[File, typer.Option(help="File whose keys it describes, for editors")] = File.DESIGN,
    answer: Annotated[
        str | None, typer.Option(help="Command whose JSON it describes instead, such as size", metavar="COMMAND")
    ] = None,
) -> None:
    """Print the JSON Schema of a design, mission, mix or study file, or of what a command prints with --json."""
    from gearwright.spec import schema as file_schema

    if answer is not None and answer not in ANSWERS:
        raise DesignError([Problem("--answer", f"{answer!r} prints no JSON; {near(answer, ANSWERS)}")])
    made = file_schema(of.value) if answer is None else answer_schema(answer)
    show_json(json_text.dumps(made, indent=2, ensure_ascii=False))


# ----------------------------------------------------------------------------------------------------------------------
# Commands of one design: check, size, modes, simulate, report.
# ----------------------------------------------------------------------------------------------------------------------


WINDOW = 0.005
"""Last stretch of a run of which every step is kept, for spectra and close views [s]."""

StiffnessOption = Annotated[
    Literal["constant", "varying"] | None, typer.Option(help="Mesh stiffness; left out: as the design says")
]
DurationOption = Annotated[float, typer.Option(help="Time to simulate [s]", min=0.0)]


def check(design: DesignArgument, json: JsonOption = False) -> None:
    """Check a design file and say everything that is wrong with it; a margin below 1 ends with exit code 1."""
    from gearwright.checks import unneeded
    from gearwright.render.tables.checks import check_sentence
    from gearwright.render.words.sizing import implied_text, sizing_headline, unneeded_text

    sizing = sized(design)
    for problem in _not_assembled(sizing):
        tell(f"not assessed, as the dynamic model ends there: {problem}")
    weak = [check for check in sizing.checks if check.fails]
    if json:
        from gearwright.render.answers.design import check_answer

        show_answer("check", check_answer(sizing), design=sizing.design.name)
        if weak:
            raise typer.Exit(1)
        return
    for check in weak:
        tell(f"{check_sentence(check)}; the margin should be 1 or more")
    for check in sizing.checks:
        if check.waiver:
            tell(f"{check_sentence(check)}; waived: {check.waiver}")
    for name in unneeded(sizing.checks, sizing.design.waivers):
        tell(unneeded_text(name))
    if weak:
        raise typer.Exit(1)
    show(f"{sizing.design.name}: no problems; {len(sizing.gears)} kinds of gears, {len(sizing.shafts)} shafts")
    show(sizing_headline(sizing))
    if by_default := implied_text(sizing.design):
        show(by_default)


def _not_assembled(sizing: Sizing) -> list[Problem]:
    """Return what the dynamic model refuses of a design that is sized, over all its cases, once each."""
    from gearwright.dynamics.assembly import assemble

    problems = dict[Problem, None]()
    for case in sizing.flows:
        try:
            assemble(sizing, case)
        except DesignError as error:
            problems |= dict.fromkeys(error.problems)
    return list(problems)


def size(
    design: DesignArgument,
    json: JsonOption = False,
    factors: Annotated[
        bool, typer.Option("--factors", help="Print every factor of gears that a standard rates")
    ] = False,
    methods: Annotated[
        bool, typer.Option("--methods", help="Compare every method of rating on the sized gears, factor by factor")
    ] = False,
    wish: Annotated[
        float | None,
        typer.Option(min=0.1, max=10.0, help="What moves the margins of the gears, and what raises the worst to this"),
    ] = None,
    level: Annotated[
        Literal["concept", "preliminary"] | None,
        typer.Option(help="Size it at this level: preliminary rates against fatigue, with gears as they are made"),
    ] = None,
    life_h: Annotated[
        float | None, typer.Option(help="Life of gears and bearings; left out: as the design says", min=0.001)
    ] = None,
) -> None:
    """Size a design: teeth, modules, stresses, margins, shafts, carriers, masses."""
    from gearwright.particulars import particulars, paths_of
    from gearwright.sizing import influences, methods_beside, rated_factors, usual_values

    sizing = sized(design, level, life_h)
    facts = particulars(sizing)
    rated = rated_factors(sizing) if factors else None
    beside = methods_beside(sizing) if methods else None
    moving = None if wish is None else influences(sizing, wish)
    if json:
        from gearwright.render.answers.design import Asked, size_answer

        show_answer("size", size_answer(facts, Asked(rated, beside, moving)), design=sizing.design.name)
        return
    from gearwright.render.words.sizing import factors_text, influences_text, methods_text, sizing_text

    show(sizing_text(facts, paths=paths_of(sizing)))
    if rated is not None:
        show(factors_text(rated, usual_values(sizing)))
    if beside is not None:
        show(methods_text(beside))
    if moving is not None:
        show(influences_text(moving))


def modes(design: DesignArgument, case: CaseOption = None, json: JsonOption = False) -> None:
    """Natural frequencies and mode shapes of a design's drive train."""
    from gearwright.dynamics import modes as find_modes
    from gearwright.render.answers.motion import modes_answer
    from gearwright.render.words.sizing import modes_text
    from gearwright.sizing import governing_case

    sizing = sized(design)
    case = case or governing_case(sizing)
    solved = find_modes(_assemble(sizing, case))
    if json:
        show_answer("modes", modes_answer(solved, case), design=sizing.design.name)
    else:
        show(modes_text(solved, case=case))


def simulate(
    design: DesignArgument,
    case: CaseOption = None,
    duration: DurationOption = 0.2,
    stiffness: StiffnessOption = None,
    output: Annotated[Path | None, typer.Option(help="Write the run to this netCDF-4 file")] = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Simulate a design's drive train in a load case; without one in the governing case, and in those that fail."""
    from gearwright.render.answers.motion import instants, simulate_answer
    from gearwright.render.words.sizing import trace_text

    sizing = sized(design)
    traces = simulated_cases(sizing, case, duration, stiffness)
    kept = save_runs(output, traces, sizing) if output is not None else [None]
    first = next(iter(traces))
    if jsonl:
        show_rows("simulate", simulate_answer(traces), instants(traces[first]), design=sizing.design.name)
    elif json:
        show_answer("simulate", simulate_answer(traces), design=sizing.design.name)
    else:
        show(*(trace_text(trace, sizing, case=name) for name, trace in traces.items()))
    end_interrupted([*traces.values()][-1], kept[-1])


def report(
    design: DesignArgument,
    file: Annotated[
        Path | None, typer.Option("--out", help="HTML file to write; left out: NAME-report.html here")
    ] = None,
    results: Annotated[Path | None, typer.Option(help="Run (netCDF-4) to show with it")] = None,
    pdf: PdfOption = None,
    date: DateOption = "",
) -> None:
    """Write the report of a design as one self-contained HTML file that also prints well."""
    from gearwright import critical_speeds, modes as find_modes, report as make_report
    from gearwright.cli.printing import find_browser, print_pdf
    from gearwright.particulars import particulars, reported
    from gearwright.sizing import governing_case

    if pdf is not None:
        find_browser()

    sizing = sized(design)
    stored = _run_of(sizing, results) if results is not None else None
    case = stored.case if stored else governing_case(sizing)
    system, campbell = _assemble(sizing, case), critical_speeds(sizing)
    page = make_report(
        reported(particulars(sizing), system),
        modes=find_modes(system),
        trace=stored.trace if stored else None,
        case=case,
        system=system,
        campbell=campbell,
        review=reviewed(sizing, design, campbell),
        stamp=stamped(design, date),
    )
    if pdf is not None:
        print_pdf(page, pdf)
    file = file or named_after(design, "report.html")
    write_text(file, page)
    show(f"wrote {file}{f' and {pdf}' if pdf else ''}")


def _run_of(sizing: Sizing, results: Path) -> StoredRun:
    """Return a stored run, if it is one of this design."""
    from gearwright.store import load_run

    stored = load_run(results)
    if stored.design != sizing.design:
        message = (
            f"this is a run of another design, {stored.design.name!r}, or of an earlier state of it; simulate again"
        )
        raise DesignError([Problem("", message)], str(results))
    return stored


def _assemble(sizing: Sizing, case: str | None, stiffness: Literal["constant", "varying"] | None = None) -> System:
    from gearwright.dynamics.assembly import assemble

    return assemble(sizing, case, stiffness=stiffness)


def simulated_cases(
    sizing: Sizing, case: str | None, duration: float, stiffness: Literal["constant", "varying"] | None
) -> dict[str, Trace]:
    """Return the runs of the case that is asked for, or of the governing one and of those that fail.

    An interruption ends the last run that is returned, and all that were to follow.

    Args:
        sizing: As sized.
        case: Load case, if one is asked for.
        duration: Of each run [s].
        stiffness: Of the meshes; None: as the design says.
    """
    from gearwright.sizing import telling_cases

    traces: dict[str, Trace] = {}
    for name in telling_cases(sizing) if case is None else (case,):
        traces[name] = simulated(_assemble(sizing, name, stiffness), duration)
        if traces[name].interrupted:
            break
    return traces


def simulated(system: System, duration: float) -> Trace:
    """Return a run with a bar of progress on a terminal; its last stretch is kept step by step.

    Args:
        system: From `assemble`.
        duration: [s].
    """
    from gearwright.dynamics import Outputs, simulate as run_system

    window = (max(0.0, duration - WINDOW), duration)
    with progress("simulating") as update:
        return run_system(system, duration, outputs=Outputs(start=duration / 4.0, windows=(window,)), progress=update)


# ----------------------------------------------------------------------------------------------------------------------
# The command ``run``: everything of one design, on one screen and in one folder.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def run(
    design: DesignArgument,
    case: CaseOption = None,
    duration: DurationOption = 0.2,
    stiffness: StiffnessOption = None,
    folder: Annotated[
        Path | None, typer.Option("--out", help="Folder for the results; left out: NAME-results here")
    ] = None,
    date: DateOption = "",
    full: Annotated[bool, typer.Option("--full", help="Print every table, too")] = False,
    json: JsonOption = False,
) -> None:
    """Do everything: size, find modes, simulate the governing case and those that fail, write report and results."""
    from gearwright import assemble, critical_speeds, modes as find_modes
    from gearwright.particulars import particulars
    from gearwright.render.words.review import run_text, run_verdict

    if date and json and folder is None:
        raise DesignError([Problem("--date", "no page is written with --json; give --out, too, or leave it out")])
    sizing = sized(design)
    traces = simulated_cases(sizing, case, duration, stiffness)
    first, last = next(iter(traces)), [*traces.values()][-1]
    system = assemble(sizing, first, stiffness=stiffness)
    solved = find_modes(system)
    campbell = () if last.interrupted else critical_speeds(sizing)
    review = None if last.interrupted else reviewed(sizing, design, campbell)
    facts = particulars(sizing)
    if json:
        from gearwright.render.answers.motion import run_answer

        answer = run_answer(facts, solved, traces, verdict=run_verdict(sizing, review))
        show_answer("run", answer, design=sizing.design.name)
    else:
        show(run_text(facts, solved, traces, review=review, campbell=campbell))
        if full:
            _show_tables(facts, solved, traces, review)
    if folder is not None or not json:
        drawn = Drawn(solved, traces, system, campbell, review)
        written = _write(folder or named_after(design, "results"), facts, drawn, stamped(design, date))
        if not json:
            show(f"\nwrote {', '.join(map(str, written))}")
            if not full:
                show("every table: the report, or --full")
    end_interrupted(last, None)


def _show_tables(facts: Particulars, modes: Modes, traces: Mapping[str, Trace], review: Review | None) -> None:
    from gearwright.particulars import paths_of
    from gearwright.render.words.sizing import modes_text, sizing_text, trace_text

    runs = (trace_text(trace, facts.sizing, case=case) for case, trace in traces.items())
    show(
        "", sizing_text(facts, review, paths=paths_of(facts.sizing)), modes_text(modes, case=next(iter(traces))), *runs
    )


class Drawn(NamedTuple):
    """What the report shows beside the sizing."""

    modes: Modes
    traces: Mapping[str, Trace]
    """Load case -> its run."""
    system: System
    """Of the first of them, as the modes are."""
    campbell: Sequence[SpeedCase]
    review: Review | None


def _write(folder: Path, facts: Particulars, drawn: Drawn, stamp: Stamp) -> list[Path]:
    """Write sizing, run and report; of a run that was interrupted no report."""
    from gearwright.particulars import reported
    from gearwright.render.answers.design import size_answer
    from gearwright.render.pages.report import report as make_report

    make_folder(folder)
    numbers = folder / "sizing.json"
    write_text(numbers, answer_text("size", size_answer(facts), design=facts.sizing.design.name) + "\n")
    kept = save_runs(folder / "run.nc", drawn.traces, facts.sizing)
    end_interrupted([*drawn.traces.values()][-1], kept[-1])
    (case, trace), *others = drawn.traces.items()
    page = make_report(
        reported(facts, drawn.system), modes=drawn.modes, trace=trace, case=case, others=dict(others),
        system=drawn.system, campbell=drawn.campbell, review=drawn.review, stamp=stamp,
    )  # fmt: skip
    write_text(folder / "report.html", page)
    return [folder / "report.html", *kept, numbers]


# ----------------------------------------------------------------------------------------------------------------------
# The command ``review``: every check of a design, and of a mission that it flies.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def review(
    design: DesignArgument,
    mission: Annotated[
        str | None,
        typer.Argument(
            help="Mission file, or the name of a shipped mission", metavar="[MISSION]", autocompletion=missions
        ),
    ] = None,
    report: Annotated[Path | None, typer.Option(help="Write it as one self-contained HTML page")] = None,
    pdf: PdfOption = None,
    date: DateOption = "",
    json: JsonOption = False,
) -> None:
    """Judge a design by every check there is, worst first; a failing one ends with exit code 1."""
    from gearwright.cli.printing import find_browser, print_pdf
    from gearwright.render.answers.review import review_answer
    from gearwright.render.words.review import review_text
    from gearwright.reviews import Verdict

    if pdf is not None:
        find_browser()
    refuse_files(None, None, report)
    reviewed = _reviewed(design, mission)
    if json:
        show_answer("review", review_answer(reviewed), design=reviewed.design)
    else:
        show(review_text(reviewed))
    if report is not None or pdf is not None:
        from gearwright.render.pages.report import review_page

        page = review_page(reviewed, design=design_of(design), stamp=stamped(design, date))
        if report is not None:
            write_text(report, page)
            tell(f"wrote {report}")
        if pdf is not None:
            print_pdf(page, pdf)
            tell(f"wrote {pdf}")
    if reviewed.verdict is Verdict.FAILS:
        raise typer.Exit(1)


def _reviewed(design: str, mission: str | None) -> Review:
    from gearwright.cli.commands.flights import flown
    from gearwright.reviews import review_of

    sizing = sized(design)
    flight, lives, _ = flown(sizing, mission) if mission is not None else (None, None, None)
    with placed_in(design):
        return review_of(sizing, flight, lives)


# ----------------------------------------------------------------------------------------------------------------------
# The command ``close``, and architectures closed for one life: designs that meet what their checks know.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


WhyOption = Annotated[
    bool,
    typer.Option(
        "--why", help="Tell what stands against what is not met, or against thinner rims and webs that are free"
    ),
]
ClosureJournalOption = Annotated[
    Path | None,
    typer.Option(help="Keep what is found in this file, and go on with it; left out: a file here, if interrupted"),
]


def close(
    design: DesignArgument,
    life_h: Annotated[
        float | None,
        typer.Option(help="Life of gears and bearings; left out: as the design says", min=0.001),
    ] = None,
    mission: Annotated[
        str | None, typer.Option(help="Mission through whose flights its gears live, too", autocompletion=missions)
    ] = None,
    continuous: Annotated[
        bool, typer.Option("--continuous", help="Modules and widths as they come, neither standard nor whole")
    ] = False,
    crossings: Annotated[
        bool, typer.Option("--crossings", help="Keep the lightest teeth, and list the critical speeds that they cross")
    ] = False,
    as_sized: Annotated[
        bool, typer.Option("--as-sized", help="Look for no lighter teeth than those that the sizing chose")
    ] = False,
    free: FreeOption = None,
    rounds: Annotated[
        bool, typer.Option("--rounds", help="Show every round; left out: the first of each kind and the last")
    ] = False,
    variants: Annotated[
        bool, typer.Option("--variants", help="Where it does not close: look for the nearest variant that does")
    ] = False,
    why: WhyOption = False,
    out: Annotated[
        Path | None,
        typer.Option(help="Write the closed design to this file, and variants that meet everything beside it"),
    ] = None,
    start: Annotated[
        str | None,
        typer.Option(
            help="Design that was closed before: its teeth and modules are a second start", autocompletion=designs
        ),
    ] = None,
    journal: ClosureJournalOption = None,
    json: JsonOption = False,
) -> None:
    """Choose every free size so that a design meets all that is checked; what is not met ends with exit code 1."""
    from gearwright.cli.commands.flights import mission_of
    from gearwright.closure import OnMission, Outcome, close as closed_by, contradictions, eased, nearest_variant
    from gearwright.render.answers.review import close_answer
    from gearwright.spec.edit import design_text_like
    from gearwright.study.closing import digest_of

    refuse_files(None, None, out, journal)
    wishes = replace(wishes_of(life_h, free), rounded=not continuous, separate=not crossings, lighten=not as_sized)
    say = _quiet if json else tell
    with placed_in(design):
        own, before = design_of(design), None if start is None else design_of(start)
        flights = None if mission is None else OnMission(*mission_of(mission))
        source = _source_of(design)
    kept = _Kept(own, source, out or named_after(design, "closed.toml"), digest_of(own, wishes, flights, before))
    course = kept.course(journal, named_after(design, "close.journal"), say)
    with placed_in(design), kept.leaving(course):
        closed = closed_by(own, wishes=wishes, on_mission=flights, source=source, start=before, course=course, tell=say)
        is_open = closed.outcome is Outcome.OPEN
        against = contradictions(own, closed, tell=say) if why else ()
        found = nearest_variant(own, closed, tell=say) if variants and is_open else None
        easier = eased(closed) if is_open else None
    if json:
        show_answer("close", close_answer(closed, found, against, easier), design=closed.design.name)
    else:
        _show_closed(closed, found, easier, against if why and (is_open or against) else None, all_rounds=rounds)
    if out is not None:
        _write_closed(out, closed, found, easier, partial(design_text_like, text=source.text, before=own), say)
    if closed.outcome is Outcome.OPEN:
        raise typer.Exit(1)


def _source_of(design: str) -> Source:
    """Return the file of a design, as whose text it is written."""
    from gearwright.closure import Source
    from gearwright.shipped import find_design
    from gearwright.spec import file_text

    return Source(file_text(find_design(design)), find_design(design).parent)


def _show_closed(
    closed: Closed,
    found: Variants | None,
    easier: Eased | None,
    against: Sequence[Contradiction] | None,
    *,
    all_rounds: bool,
) -> None:
    """Show a closed design, what stands against it, and its variants, as far as they were looked for."""
    from gearwright.render.words.review import against_text, closure_text, variants_text

    show(closure_text(closed, easier, all_rounds=all_rounds))
    if against is not None:
        show(against_text(against))
    if found is not None:
        show(variants_text(found))


def _write_closed(
    out: Path,
    closed: Closed,
    found: Variants | None,
    easier: Eased | None,
    text_of: Callable[[Design], str],
    say: Callable[[str], None],
) -> None:
    """Write a closed design, and beside it its nearest variants, of other sizes and of its own."""
    written = {out: closed.text}
    if easier is not None:
        written[out.with_stem(f"{out.stem}-easier")] = text_of(easier.design)
    if found is not None and found.nearest is not None:
        written[out.with_stem(f"{out.stem}-variant")] = text_of(found.nearest.closed.design)
    for path, result in written.items():
        write_text(path, result)
        say(f"wrote {path}")


@dataclass(frozen=True)
class _Kept:
    """What is left of a closure that is interrupted: its best design, and a journal with which it goes on."""

    design: Design
    source: Source
    out: Path
    asked: str
    """Digest of everything that moves the result."""
    journals: list[Path] = field(default_factory=list)
    """File that is written; none where it is not known yet."""

    def course(self, journal: Path | None, usual: Path, say: Callable[[str], None]) -> Course:
        """Return what is counted and known: by the journal that is given, or by one that an interruption left here."""
        from gearwright.closure import Course
        from gearwright.study.closing import course_of, known_by

        if journal is not None:
            course = course_of(journal, self.asked, self.design)
        else:
            course = Course()
            if usual.exists():
                try:
                    course = Course(known_by(usual, self.asked))
                except DesignError as error:
                    why = "; ".join(problem.message for problem in error.problems)
                    say(f"{why}. It is begun anew; an interruption replaces the file")
        self.journals.append(journal or usual)
        if course.known:
            say(f"going on from {journal or usual}, which knows {len(course.known)} answers")
        return course

    @contextmanager
    def leaving(self, course: Course) -> Iterator[None]:
        """Leave the best design and a journal where what is within is interrupted; take a usual one away after it."""
        from gearwright.study.closing import keep_in

        (journal,) = self.journals
        try:
            yield
        except KeyboardInterrupt:
            answered()
            raise typer.Exit(interrupted(self._words(course, journal))) from None
        if course.keep is None:
            journal.unlink(missing_ok=True)
        else:
            keep_in(journal, self.asked, self.design, course.known)

    def _words(self, course: Course, journal: Path) -> str:
        """Write what there is, and say where."""
        from gearwright.checks import worst
        from gearwright.closure import best_so_far
        from gearwright.render.tables.checks import check_sentence
        from gearwright.study.closing import keep_in
        from gearwright.units import text

        if course.best is None:
            return "nothing was found yet, and nothing is kept"
        target = interrupted_name(self.out)
        try:
            best = best_so_far(course.best, self.source, self.design)
            write_text(target, best.text)
            least = worst(best.sizing.checks)
            words = f"the best so far, {text(best.sizing.mass, 'mass')}, is in {target}"
            words += f": {check_sentence(least)}" if least is not None and least.fails else ""
            keep_in(journal, self.asked, self.design, course.known)
        except GearwrightError as error:
            return f"what was found could not be kept: {' '.join(str(error).split())}"
        return f"{words}; the same command goes on from {journal}"


def wishes_of(life_h: float | None, free: str | None) -> Wishes:
    """Return what a closure is asked for.

    Args:
        life_h: Of gears and bearings [h]; None: as designs say.
        free: Names of freedoms with a comma, or ``all``; None: none beside open teeth.

    Raises:
        DesignError: If there is no such freedom.
    """
    from gearwright.closure import FREEDOMS, Wishes
    from gearwright.closure.requirements import HOUR

    names = [name.strip() for name in (free or "").split(",") if name.strip()]
    every = tuple(FREEDOMS) if names == ["all"] else tuple(names)
    return Wishes(life=None if life_h is None else life_h * HOUR, free=every)


def _quiet(_: str) -> None:
    """Say nothing beside the answer."""


def show_equal_life(
    designs: Mapping[str, Design],
    wishes: Wishes,
    *,
    out: Path | None,
    csv: Path | None,
    report: Path | None,
    json: bool,
) -> None:
    """Show designs closed for one life, and write them into a folder.

    Args:
        designs: Name -> design.
        wishes: Life, and what is free.
        out: Folder, made where there is none; None: they are not written.
        csv: File for the table; None: none.
        report: File for the page; None: none.
        json: For machines.
    """
    from gearwright.closure.requirements import HOUR
    from gearwright.render.answers.review import EqualLifeAnswer
    from gearwright.render.pages.studies import equal_life_page
    from gearwright.render.tables.study import equal_life_csv, equal_life_table, measures_table
    from gearwright.render.words.sizing import table_text
    from gearwright.render.words.study import equal_life_sentences
    from gearwright.study import equal_life
    from gearwright.study.architectures import closed_designs

    if out is not None:
        make_folder(out)
    rows = equal_life(designs, wishes=wishes, tell=_quiet if json else tell)
    life = wishes.life or 0.0
    title = f"Closed for {life / HOUR:g} h" + (f", {', '.join(wishes.free)} free" if wishes.free else "")
    if json:
        show_answer("compare closed", EqualLifeAnswer(life, rows))
    else:
        show(table_text(equal_life_table(rows, title)))
        show(table_text(measures_table(rows)))
        for sentence in equal_life_sentences(rows):
            show(sentence)
    files = {out / f"{row.title}.toml": row.file for row in rows if row.file} if out is not None else {}
    files |= {} if csv is None else {csv: equal_life_csv(rows)}
    files |= {} if report is None else {report: equal_life_page(rows, closed_designs(rows), title)}
    for path, content in files.items():
        write_text(path, content)
        tell(f"wrote {path}")


# ----------------------------------------------------------------------------------------------------------------------
# The command ``arrange``: bearings for every shaft that needs them.
# ----------------------------------------------------------------------------------------------------------------------


def arrange(
    design: DesignArgument,
    life_h: Annotated[
        float | None,
        typer.Option(help="Life of gears and bearings; left out: as the design says", min=0.001),
    ] = None,
    free: FreeOption = None,
    as_sized: Annotated[
        bool, typer.Option("--as-sized", help="Keep the sizes that the sizing chose, and move none with bearings in it")
    ] = False,
    level: Annotated[
        Literal["concept", "preliminary"],
        typer.Option(help="Level at which it is taken as it is sized: preliminary rates against fatigue"),
    ] = "preliminary",
    out: Annotated[Path | None, typer.Option(help="Write the design with its bearings to this file")] = None,
    json: JsonOption = False,
) -> None:
    """Put every shaft that needs them into bearings, and make it as long as these ask; what fails ends with code 1.

    A design with open sizes is closed first, and again with its shafts as they stand in bearings, until it passes.
    """
    from gearwright.closure import arrange as arranged_by, has_open_sizes
    from gearwright.render.answers.review import arrange_answer
    from gearwright.render.words.review import arranged_text
    from gearwright.spec import at_level, edited
    from gearwright.spec.design import BUILT, PRELIMINARY
    from gearwright.spec.edit import design_text_like

    refuse_files(None, None, out, None)
    own, say, found, stated = design_of(design), _quiet if json else tell, None, ""
    wishes = wishes_of(life_h, free)
    source = _source_of(design).text
    with placed_in(design):
        if not as_sized and level == PRELIMINARY and has_open_sizes(own, wishes):
            found = _closed_in_bearings(own, wishes, out, source, say)
            arranged = found.arranged or arranged_by(found.closed.design)
            stated = own.level if own.level not in (PRELIMINARY, BUILT) else ""
        else:
            moves = own.level != level and (own.level, level) != (BUILT, PRELIMINARY)  # bearings that stand stay
            lives = {} if life_h is None else {"service.life_h": life_h, "service.bearing_life_h": life_h}
            lived = edited(own, lives)
            arranged, stated = arranged_by(at_level(lived, level) if moves else lived), own.level if moves else ""
    if json:
        show_answer("arrange", arrange_answer(arranged, found), design=arranged.design.name)
    else:
        show(arranged_text(arranged, found, stated=stated))
    if out is not None:
        write_text(out, design_text_like(arranged.design, source, own))
        say(f"wrote {out}")
    if any(check.fails for check in (arranged.sizing.checks if found is None else found.checks)):
        raise typer.Exit(1)


def _closed_in_bearings(
    design: Design, wishes: Wishes, out: Path | None, source: str, say: Callable[[str], None]
) -> ClosedArrangement:
    """Return a design closed with its shafts in bearings; leave the best so far where that is interrupted.

    Raises:
        DesignError: If a shaft finds no bearings.
    """
    from gearwright.closure import close_arranged
    from gearwright.spec.edit import design_text_like
    from gearwright.units import text

    best: list[ClosedArrangement] = []
    try:
        found = close_arranged(design, wishes=wishes, tell=say, keep=best.append)
    except KeyboardInterrupt:
        answered()
        kept = "nothing was found yet, and nothing is kept"
        if best and out is not None:
            target, mass = interrupted_name(out), text(best[-1].mass, "mass")
            write_text(target, design_text_like(best[-1].design, source, design))
            kept = f"the best so far, {mass}, is in {target}"
        raise typer.Exit(interrupted(kept)) from None
    if found.without_bearings:
        raise DesignError([Problem("bearings", found.without_bearings)])
    return found


# ----------------------------------------------------------------------------------------------------------------------
# The command ``app``: the workbench, in a browser on this machine.
# ----------------------------------------------------------------------------------------------------------------------


def app(
    design: Annotated[
        str,
        typer.Argument(help="Design file, or the name of a shipped design", metavar="[DESIGN]", autocompletion=designs),
    ] = "in-line-h2",
    port: Annotated[int, typer.Option(help="Port of the address; 0: any that is free", min=0, max=65535)] = 0,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open the address in a browser")] = True,
    folder: Annotated[
        Path | None, typer.Option(help="Folder in which designs are read and saved; left out: that of the file")
    ] = None,
) -> None:
    """Open the workbench: change a design in a browser and see its numbers, margins, power flow and solids follow."""
    from gearwright.app import serve

    def told(address: str) -> None:
        show_commands(address)
        show("the workbench answers there, to this machine alone; Ctrl-C ends it")

    try:
        serve(design, folder=folder, port=port, browser=browser, told=told)
    except KeyboardInterrupt:
        if interrupted_code() != CTRL_C:  # which is the usual end
            raise
        answered()
