"""The command ``window``: seconds of a mission with propeller, governor and machines on the elastic train.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.commands.designs.design import StiffnessOption
from gearwright.cli.commands.flights.mission import mission_of
from gearwright.cli.designs import sized
from gearwright.cli.ends import end_interrupted, save_run
from gearwright.cli.options import (
    DateOption,
    DesignArgument,
    FigureOption,
    JsonOption,
    LinesOption,
    MissionArgument,
    ReportOption,
)
from gearwright.cli.terminal.output import show, tell, write_figure
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.spec import Mission


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
    from gearwright.render.answers.flights.flight import window_answer
    from gearwright.render.answers.motion import instants
    from gearwright.render.words.flights.window import window_text

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
        from gearwright.render.figures.flights.window import window_figure

        write_figure(window_figure(dynamic), figure)
        tell(f"wrote {figure}")
    if report is not None:
        from gearwright.render.pages.page import Stamp
        from gearwright.render.pages.window import window_page

        write_text(report, window_page(dynamic, sizing, stamp=Stamp(date)))
        tell(f"wrote {report}")


def _list(mission: Mission) -> None:
    for name, rules in mission.windows.items():
        show(f"{name:20} {rules.phase}, {rules.event}, {rules.duration:g} s")
    if not mission.windows:
        show("the mission has no [windows]; add one, such as [windows.cut] with phase, at_s and event")
