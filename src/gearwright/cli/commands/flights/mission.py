"""The command ``fly``: a mission flown by a design.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.completion import designs
from gearwright.cli.designs import placed_in, sized
from gearwright.cli.options import DateOption, JsonOption, LinesOption, MissionArgument
from gearwright.cli.terminal.output import show, tell
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.mission import Durability, Flight, LifeSizing
    from gearwright.sizing import Sizing
    from gearwright.spec import Mission


def fly(
    design: Annotated[
        str | None,
        typer.Argument(
            help="Design file, or the name of a shipped design",
            metavar="DESIGN",
            autocompletion=designs,
        ),
    ] = None,
    mission: MissionArgument = "thesis",
    life_h: Annotated[
        float | None,
        typer.Option(
            help="Strengthen the gears until all live so many flight hours, and choose bearings for them",
            min=0.001,
        ),
    ] = None,
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
    window: Annotated[
        list[str] | None, typer.Option(help="Window of the mission to fly dynamically and draw on the page; or: all")
    ] = None,
    date: DateOption = "",
    csv: Annotated[Path | None, typer.Option(help="Write the histories as CSV, in SI")] = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Fly a mission: fuel, charge, heat and the part that fails first; without a design, list the shipped missions."""
    if design is None:
        _list()
        return
    from gearwright.errors import DesignError, Problem
    from gearwright.reviews import review_of

    if window and report is None:
        raise DesignError([Problem("--window", "windows are drawn on the page; name its file with --report, too")])
    flight, parts, life = flown(sized(design), mission, life_h=life_h)
    with placed_in(design):
        review = review_of(flight.sizing, flight, parts, life=None if life_h is None else 3600.0 * life_h)
    from gearwright.render.answers.flights.flight import fly_answer, moments
    from gearwright.render.words.flights.flight import flight_text
    from gearwright.render.words.flights.flight_data import flight_csv

    name = flight.sizing.design.name
    if jsonl:
        show_rows("fly", fly_answer(flight, parts, review, life=life), moments(flight), design=name)
    elif json:
        show_answer("fly", fly_answer(flight, parts, review, life=life), design=name)
    else:
        show(flight_text(flight, parts, review, life=life))
    if report is not None:
        from gearwright.mission.windows import fly_window
        from gearwright.render.pages.flight import flight_page
        from gearwright.render.pages.page import Stamp

        windows = [fly_window(flight, name) for name in _windows(flight, window or [])]
        for dynamic in windows:
            dynamic.trace.whole()
        write_text(report, flight_page(flight, parts, review, life=life, windows=windows, stamp=Stamp(date)))
        tell(f"wrote {report}")
    if csv is not None:
        write_text(csv, flight_csv(flight))
        tell(f"wrote {csv}")


def _windows(flight: Flight, names: list[str]) -> list[str]:
    """Return the windows that are asked for; all of them for the word."""
    return list(flight.mission.windows) if "all" in names else names


def _list() -> None:
    from gearwright.shipped import shipped_mission, shipped_missions
    from gearwright.spec import read_mission

    for mission in shipped_missions():
        show(f"{mission:20} {read_mission(shipped_mission(mission)).name}")


def mission_of(name: str) -> tuple[Mission, Path]:
    """Return a mission, and the folder in which its propeller map may lie."""
    from gearwright.shipped import find_mission
    from gearwright.spec import read_mission

    path = find_mission(name)
    return read_mission(path), path.parent


def flown(sizing: Sizing, name: str, *, life_h: float | None = None) -> tuple[Flight, Durability, LifeSizing | None]:
    """Return the flight of a named mission; what cannot be flown is placed at its line in the mission's file.

    Args:
        sizing: Of the design.
        name: Of the mission, or its path.
        life_h: For which the design is strengthened, if it is [h].

    Raises:
        DesignError: If the mission cannot be read or flown.
    """
    from gearwright.errors import DesignError
    from gearwright.mission import durability, size_for_life
    from gearwright.mission import fly as flown_by
    from gearwright.shipped import find_mission
    from gearwright.spec import file_text, placed

    mission, folder = mission_of(name)
    try:
        life = None if life_h is None else size_for_life(sizing.design, mission, life_h, folder=folder)
        flight = life.flight if life is not None else flown_by(sizing, mission, folder=folder)
        return flight, durability(flight), life
    except DesignError as error:
        if any(problem.path.partition(".")[0] not in type(mission).model_fields for problem in error.problems):
            raise
        path = find_mission(name)
        raise DesignError(placed(error.problems, file_text(path)), str(path)) from None
