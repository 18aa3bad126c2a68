"""The commands ``campbell``, ``response``, ``runup`` and ``validate``: how a train answers to what shakes it.

Imports that cost time stand inside the commands, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.designs import sized
from gearwright.cli.ends import named_after
from gearwright.cli.options import (
    CaseOption,
    DateOption,
    DesignArgument,
    FigureOption,
    JsonOption,
    LinesOption,
    ReportOption,
    drawable,
)
from gearwright.cli.terminal.output import progress, show, tell, write_figure
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.render.grid.table import Table
    from gearwright.render.style.theme import Drawing


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
        from gearwright.render.answers.vibration import campbell_answer

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
        from gearwright.render.answers.vibration import ResponseAnswer

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
    from gearwright.render.figures.maps import waterfall_figure
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
        from gearwright.render.answers.vibration import RunUpAnswer

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
    from gearwright.errors import SolveError
    from gearwright.render.answers.weights import ValidateAnswer
    from gearwright.render.tables.validation import by_source, source_table, verdict
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
    from gearwright.render.words.text import table_text

    show(*map(table_text, tables))


def _draw(drawing: Drawing, path: Path, *, quiet: bool) -> None:
    write_figure(drawing, path)
    if not quiet:
        show(f"wrote {path}")
