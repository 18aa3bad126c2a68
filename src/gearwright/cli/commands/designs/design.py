"""Commands of one design: check, size, modes, simulate, report."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.designs import reviewed, sized, stamped
from gearwright.cli.ends import end_interrupted, named_after, save_runs
from gearwright.cli.options import CaseOption, DateOption, DesignArgument, JsonOption, LinesOption, PdfOption
from gearwright.cli.terminal.output import progress, show, tell
from gearwright.errors import DesignError, Problem
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.dynamics import System, Trace
    from gearwright.sizing import Sizing
    from gearwright.store import StoredRun

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
    from gearwright.render.words.headline import implied_text, sizing_headline, unneeded_text

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
    sizing = sized(design, level, life_h)
    if json:
        from gearwright.render.answers.design import Asked, size_answer

        show_answer("size", size_answer(sizing, Asked(factors, methods, wish)), design=sizing.design.name)
        return
    from gearwright.render.words.text import factors_text, influences_text, methods_text, sizing_text

    asked = ((factors, factors_text), (methods, methods_text))
    show(sizing_text(sizing), *(text(sizing) for wanted, text in asked if wanted))
    if wish is not None:
        show(influences_text(sizing, wish))


def modes(design: DesignArgument, case: CaseOption = None, json: JsonOption = False) -> None:
    """Natural frequencies and mode shapes of a design's drive train."""
    from gearwright.dynamics import modes as find_modes
    from gearwright.render.answers.motion import modes_answer
    from gearwright.render.words.text import modes_text
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
    from gearwright.render.words.text import trace_text

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
    from gearwright.cli.terminal.printing import find_browser, print_pdf
    from gearwright.dynamics import modes as find_modes
    from gearwright.dynamics.vibration import critical_speeds
    from gearwright.render.pages.designs.report import report as make_report
    from gearwright.sizing import governing_case

    if pdf is not None:
        find_browser()

    sizing = sized(design)
    stored = _run_of(sizing, results) if results is not None else None
    case = stored.case if stored else governing_case(sizing)
    system, campbell = _assemble(sizing, case), critical_speeds(sizing)
    page = make_report(
        sizing,
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
    from gearwright.errors import DesignError, Problem
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
    from gearwright.dynamics import Outputs
    from gearwright.dynamics import simulate as run_system

    window = (max(0.0, duration - WINDOW), duration)
    with progress("simulating") as update:
        return run_system(system, duration, outputs=Outputs(start=duration / 4.0, windows=(window,)), progress=update)
