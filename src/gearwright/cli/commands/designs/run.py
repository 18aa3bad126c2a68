"""The command ``run``: everything of one design, on one screen and in one folder.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from gearwright.cli.answers import answer_text, show_answer
from gearwright.cli.commands.designs.design import DurationOption, StiffnessOption, simulated_cases
from gearwright.cli.designs import reviewed, sized, stamped
from gearwright.cli.ends import end_interrupted, named_after, save_runs
from gearwright.cli.options import CaseOption, DateOption, DesignArgument, JsonOption
from gearwright.cli.terminal.output import show
from gearwright.writing import make_folder, write_text

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from gearwright.dynamics import Modes, System, Trace
    from gearwright.dynamics.vibration import SpeedCase
    from gearwright.render.pages.page import Stamp
    from gearwright.reviews import Review
    from gearwright.sizing import Sizing


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
    from gearwright.dynamics import modes as find_modes
    from gearwright.dynamics.assembly import assemble
    from gearwright.dynamics.vibration import critical_speeds
    from gearwright.errors import DesignError, Problem
    from gearwright.render.words.run import run_text, run_verdict

    if date and json and folder is None:
        raise DesignError([Problem("--date", "no page is written with --json; give --out, too, or leave it out")])
    sizing = sized(design)
    traces = simulated_cases(sizing, case, duration, stiffness)
    first, last = next(iter(traces)), [*traces.values()][-1]
    system = assemble(sizing, first, stiffness=stiffness)
    solved = find_modes(system)
    campbell = () if last.interrupted else critical_speeds(sizing)
    review = None if last.interrupted else reviewed(sizing, design, campbell)
    if json:
        from gearwright.render.answers.motion import run_answer

        answer = run_answer(sizing, solved, traces, verdict=run_verdict(sizing, review))
        show_answer("run", answer, design=sizing.design.name)
    else:
        show(run_text(sizing, solved, traces, review=review, campbell=campbell))
        if full:
            _show_tables(sizing, solved, traces, review)
    if folder is not None or not json:
        drawn = Drawn(solved, traces, system, campbell, review)
        written = _write(folder or named_after(design, "results"), sizing, drawn, stamped(design, date))
        if not json:
            show(f"\nwrote {', '.join(map(str, written))}")
            if not full:
                show("every table: the report, or --full")
    end_interrupted(last, None)


def _show_tables(sizing: Sizing, modes: Modes, traces: Mapping[str, Trace], review: Review | None) -> None:
    from gearwright.render.words.text import modes_text, sizing_text, trace_text

    runs = (trace_text(trace, sizing, case=case) for case, trace in traces.items())
    show("", sizing_text(sizing, review), modes_text(modes, case=next(iter(traces))), *runs)


class Drawn(NamedTuple):
    """What the report shows beside the sizing."""

    modes: Modes
    traces: Mapping[str, Trace]
    """Load case -> its run."""
    system: System
    """Of the first of them, as the modes are."""
    campbell: Sequence[SpeedCase]
    review: Review | None


def _write(folder: Path, sizing: Sizing, drawn: Drawn, stamp: Stamp) -> list[Path]:
    """Write sizing, run and report; of a run that was interrupted no report."""
    from gearwright.render.answers.design import size_answer
    from gearwright.render.pages.designs.report import report as make_report

    make_folder(folder)
    numbers = folder / "sizing.json"
    write_text(numbers, answer_text("size", size_answer(sizing), design=sizing.design.name) + "\n")
    kept = save_runs(folder / "run.nc", drawn.traces, sizing)
    end_interrupted([*drawn.traces.values()][-1], kept[-1])
    (case, trace), *others = drawn.traces.items()
    page = make_report(
        sizing, modes=drawn.modes, trace=trace, case=case, others=dict(others), system=drawn.system,
        campbell=drawn.campbell, review=drawn.review, stamp=stamp,
    )  # fmt: skip
    write_text(folder / "report.html", page)
    return [folder / "report.html", *kept, numbers]
