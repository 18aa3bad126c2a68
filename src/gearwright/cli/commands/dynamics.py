"""Commands for vibration, load sharing, event windows, and validation against published values."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from gearwright.cli.answers import end_interrupted, named_after, save_run, show_answer, show_rows
from gearwright.cli.commands.designs import StiffnessOption
from gearwright.cli.commands.flights import mission_of
from gearwright.cli.options import (
    CaseOption,
    DateOption,
    DesignArgument,
    FigureOption,
    JsonOption,
    LinesOption,
    MissionArgument,
    ReportOption,
    drawable,
    sized,
)
from gearwright.cli.terminal import progress, show, tell, write_figure
from gearwright.errors import DesignError, Problem, SolveError
from gearwright.files import write_text

if TYPE_CHECKING:
    from gearwright.dynamics.sharing import SharingStudy
    from gearwright.render.grid import Table
    from gearwright.render.style import Drawing
    from gearwright.spec import Mission


# ----------------------------------------------------------------------------------------------------------------------
# The commands ``campbell``, ``response``, ``runup`` and ``validate``: how a train answers to what shakes it.
#
# Imports that cost time stand inside the commands, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def campbell(
    design: DesignArgument,
    case: CaseOption = None,
    figure: Annotated[
        Path | None, typer.Option(help="Figure to write; left out: NAME-campbell.svg here", callback=drawable)
    ] = None,
    json: JsonOption = False,
) -> None:
    """List critical speeds with their separation margins, worst first, and draw the Campbell diagram."""
    from gearwright.dynamics.assembly import assumptions
    from gearwright.dynamics.vibration import critical_speeds
    from gearwright.render.figures.dynamics import campbell_figure
    from gearwright.render.tables.dynamics import assumption_table, critical_table, machine_table

    sizing = sized(design)
    campbells = critical_speeds(sizing, cases=None if case is None else [case])
    taken = assumptions(sizing, campbells[0].system)
    if json:
        from gearwright.render.answers.motion import campbell_answer

        show_answer("campbell", campbell_answer(campbells, taken), design=sizing.design.name)
    else:
        _show(*map(critical_table, campbells), *map(machine_table, campbells), assumption_table(taken))
    if json and figure is None:
        return
    path = figure or named_after(design, "campbell.svg")
    for number, case_speeds in enumerate(campbells, start=1):
        target = path if number == 1 else path.with_stem(f"{path.stem}-{number}")
        _draw(campbell_figure(sizing, case_speeds), target, quiet=json)


def response(
    design: DesignArgument,
    case: CaseOption = None,
    mesh: Annotated[str | None, typer.Option(help="Mesh row whose teeth err, such as first.sun-planet")] = None,
    error_um: Annotated[float, typer.Option(help="Amplitude of the transmission error", min=0.0)] = 1.0,
    top_khz: Annotated[float, typer.Option(help="Highest frequency", min=0.001)] = 10.0,
    figure: FigureOption = None,
    json: JsonOption = False,
) -> None:
    """Show how mesh forces answer to a transmission error of one mesh row, against frequency."""
    from gearwright.dynamics.assembly import assemble
    from gearwright.dynamics.vibration import answer, first_meshes, peaks
    from gearwright.render.figures.dynamics import response_figure
    from gearwright.render.tables.dynamics import excited_by, peak_table
    from gearwright.sizing import governing_case

    sizing = sized(design)
    case = case or governing_case(sizing)
    system = assemble(sizing, case)
    row = mesh or sizing.train.meshes[0].name
    answered = answer(sizing, system, row, error=error_um * 1e-6, top=top_khz * 1e3, case=case)
    lines, excited = first_meshes(sizing, system), excited_by(row, error_um * 1e-6, case)
    if json:
        from gearwright.render.answers.motion import ResponseAnswer

        told = ResponseAnswer(case, row, error_um * 1e-6, tuple(peaks(answered, lines)))
        show_answer("response", told, design=sizing.design.name)
    else:
        _show(peak_table(answered, lines, excited=excited))
    if figure is not None:
        _draw(response_figure(answered, lines, title=f"Answer to a {excited}"), figure, quiet=json)


def runup(
    design: DesignArgument,
    case: CaseOption = None,
    line: Annotated[str | None, typer.Option(help="Line that is drawn; left out: the loudest")] = None,
    lowest: Annotated[float, typer.Option(help="Lowest speed over the operating speed", min=0.01)] = 0.3,
    highest: Annotated[float, typer.Option(help="Highest speed over the operating speed", min=0.01)] = 1.3,
    speeds: Annotated[int, typer.Option(help="Number of speeds", min=2, max=1000)] = 41,
    figure: FigureOption = None,
    json: JsonOption = False,
) -> None:
    """Run at many speeds and show where each mesh is loudest, and its waterfall with orders."""
    import numpy as np

    from gearwright.dynamics.assembly import assemble
    from gearwright.dynamics.vibration import first_meshes, loudest_speeds, run_up, turning_shaft
    from gearwright.render.figures.dynamics import waterfall_figure
    from gearwright.render.tables.dynamics import loudest_table
    from gearwright.sizing import governing_case

    sizing = sized(design)
    case = case or governing_case(sizing)
    system = assemble(sizing, case)
    lines = [*first_meshes(sizing, system), *([line] if line is not None else [])]
    with progress("running") as update:
        factors = [float(factor) for factor in np.linspace(lowest, highest, speeds)]
        swept = run_up(sizing, system, factors, lines=list(dict.fromkeys(lines)), progress=update)
    shaft = turning_shaft(sizing, case) or sizing.machines[0].shaft
    speed = abs(sizing.flows[case].speeds[shaft])
    table = loudest_table(swept, speed, case=case)
    if json:
        from gearwright.render.answers.motion import RunUpAnswer

        errors = float(np.max(swept.error)), float(np.max(swept.rms_error))
        told = RunUpAnswer(case, shaft, speed, tuple(loudest_speeds(swept, speed)), *errors, swept.notes)
        show_answer("runup", told, design=sizing.design.name)
    else:
        _show(table)
    if figure is not None:
        drawn = line or str(table.rows[0][0].value)
        _draw(waterfall_figure(swept, drawn, speed=speed, shaft=shaft), figure, quiet=json)


def validate(
    pattern: Annotated[str | None, typer.Argument(help="Only cases whose name or source contains this")] = None,
    report: ReportOption = None,
    date: DateOption = "",
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Compare gearwright with every published number that it knows: case, source, expected, got, error, verdict."""
    from gearwright.render.answers.weights import ValidateAnswer
    from gearwright.render.pages.validation import by_source, source_table, verdict
    from gearwright.validate import Checked, published

    machine = json or jsonl

    checked: list[Checked] = []
    sources: list[tuple[Checked, ...]] = []
    for numbers in by_source(published(pattern or "")):
        checked += numbers
        sources.append(numbers)
        if not machine:
            _show(source_table(numbers))
    missed = sum(not number.holds for number in checked)
    if jsonl:
        show_rows("validate", ValidateAnswer(missed, tuple(checked)), checked)
    elif json:
        show_answer("validate", ValidateAnswer(missed, tuple(checked)))
    else:
        show(verdict(checked))
    if report is not None:
        from gearwright.render.pages.page import Stamp
        from gearwright.render.pages.validation import validation_page

        write_text(report, validation_page(sources, stamp=Stamp(date)))
        tell(f"wrote {report}")
    if missed:
        raise SolveError(f"{missed} published numbers are missed; the tables say which")


def _show(*tables: Table) -> None:
    from gearwright.render.words.sizing import table_text

    show(*map(table_text, tables))


def _draw(drawing: Drawing, path: Path, *, quiet: bool) -> None:
    write_figure(drawing, path)
    if not quiet:
        show(f"wrote {path}")


# ----------------------------------------------------------------------------------------------------------------------
# The command ``sharing``: how parallel paths share their load, which errors matter, how tight tolerances must be.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def sharing(
    design: DesignArgument,
    stage: Annotated[str | None, typer.Option(help="Stage with parallel meshes; left out: the last one")] = None,
    case: CaseOption = None,
    method: Annotated[
        Literal["auto", "quasi-static", "frequency response", "sidebands", "dynamics"],
        typer.Option(help="Solution for the errors as given"),
    ] = "auto",
    target: Annotated[
        str | None, typer.Option(help="Sharing that is asked for, such as 52/48: says how tight tolerances must be")
    ] = None,
    percent: Annotated[float, typer.Option(help="Gearboxes that must keep the target [%]", min=1.0, max=99.9)] = 95.0,
    seed: Annotated[int, typer.Option(help="Of the random errors", min=0)] = 1,
    figure: Annotated[Path | None, typer.Option(help="Write the main figure (.svg or .png)", callback=drawable)] = None,
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
    json: JsonOption = False,
) -> None:
    """Say how parallel paths share their load, what each error does, and which tolerance to tighten."""
    from gearwright.dynamics.sharing import planet_counts, sharing_problem, sharing_study
    from gearwright.render.answers.motion import sharing_answer
    from gearwright.render.figures.dynamics import planets_text
    from gearwright.render.pages.motion import sharing_text

    share = asked_share(target)
    sizing = sized(design)
    problem = sharing_problem(sizing, stage, case=case)
    study = sharing_study(problem, method=method, target=share, percent=percent, seed=seed)
    counts = planet_counts(sizing, problem, seed=seed) if report is not None or not json else None
    if json:
        show_answer("sharing", sharing_answer(study), design=sizing.design.name)
    else:
        show(sharing_text(study), *([planets_text(counts)] if counts is not None else []))
    if figure is not None:
        _draw_sharing(study, figure)
    if report is not None:
        from gearwright.dynamics.sharing import floating
        from gearwright.render.pages.motion import sharing_page
        from gearwright.replays import paper_on

        planets = [] if counts is None else [counts]
        floats, paper = floating(sizing), paper_on(sizing)
        drawn = sharing_page(sizing, [study], counts=planets, floats=floats, target=share, paper=paper)
        write_text(report, drawn)
        tell(f"wrote {report}")


def asked_share(target: str | None) -> float | None:
    """Return the share of the most loaded path that ``52/48`` or ``0.52`` asks for [-].

    Args:
        target: As written.

    Raises:
        DesignError: If it is no share.
    """
    if target is None:
        return None
    parts = target.split("/")
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        numbers = []
    share = numbers[0] if len(numbers) == 1 else max(numbers) / sum(numbers) if numbers and sum(numbers) > 0.0 else 0.0
    if not 0.0 < share < 1.0:
        message = f"{target!r} is no sharing; write parts such as 52/48, or the largest share such as 0.52"
        raise DesignError([Problem("--target", message)])
    return share


def _draw_sharing(study: SharingStudy, path: Path) -> None:
    from gearwright.render.figures.dynamics import allocation_figure, sharing_figure, tornado_figure

    if study.allocation is not None:
        drawn = allocation_figure(study.allocation)
    elif study.influences:
        drawn = tornado_figure(study)
    else:
        drawn = sharing_figure({study.problem.stage: study.sharing})
    write_figure(drawn, path)
    tell(f"wrote {path}")


# ----------------------------------------------------------------------------------------------------------------------
# The command ``window``: seconds of a mission with propeller, governor and machines on the elastic train.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def window(
    design: DesignArgument,
    mission: MissionArgument = "thesis",
    name: Annotated[
        str | None, typer.Argument(help="Window of the mission; left out: list them", metavar="WINDOW")
    ] = None,
    stiffness: StiffnessOption = None,
    output: Annotated[Path | None, typer.Option(help="Write the run to this netCDF-4 file")] = None,
    figure: FigureOption = None,
    report: ReportOption = None,
    date: DateOption = "",
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Fly a window of a mission dynamically: what a change of mode, a gust or a motor cut does to every tooth."""
    flown, folder = mission_of(mission)
    if name is None:
        _list(flown)
        return
    from gearwright.mission import fly
    from gearwright.mission.windows import fly_window, window_rules
    from gearwright.render.answers.flights import window_answer
    from gearwright.render.answers.motion import instants
    from gearwright.render.words.flights import window_text

    sizing = sized(design)
    flight = fly(sizing, flown, folder=folder)
    rules = window_rules(flight, name)
    if stiffness is not None:
        rules = rules.model_copy(update={"stiffness": stiffness})
    dynamic = fly_window(flight, name, rules)
    kept = save_run(output, dynamic.trace, sizing, sizing.reference.case) if output is not None else None
    if jsonl:
        show_rows("window", window_answer(dynamic), instants(dynamic.trace), design=sizing.design.name)
    elif json:
        show_answer("window", window_answer(dynamic), design=sizing.design.name)
    else:
        show(window_text(dynamic))
    end_interrupted(dynamic.trace, kept)
    if kept is not None:
        tell(f"wrote {kept}")
    if figure is not None:
        from gearwright.render.figures.flights import window_figure

        write_figure(window_figure(dynamic), figure)
        tell(f"wrote {figure}")
    if report is not None:
        from gearwright.render.pages.flight import window_page
        from gearwright.render.pages.page import Stamp

        write_text(report, window_page(dynamic, sizing, stamp=Stamp(date)))
        tell(f"wrote {report}")


def _list(mission: Mission) -> None:
    for name, rules in mission.windows.items():
        show(f"{name:20} {rules.phase}, {rules.event}, {rules.duration:g} s")
    if not mission.windows:
        show("the mission has no [windows]; add one, such as [windows.cut] with phase, at_s and event")
