"""The command ``review``: every check of a design, and of a mission that it flies.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.commands.studies.shown import refuse_files
from gearwright.cli.completion import missions
from gearwright.cli.designs import design_of, placed_in, sized, stamped
from gearwright.cli.options import DateOption, DesignArgument, JsonOption, PdfOption
from gearwright.cli.terminal.output import show, tell
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.reviews import Review


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
    from gearwright.cli.terminal.printing import find_browser, print_pdf
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
        from gearwright.render.pages.designs.review import review_page

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
    from gearwright.cli.commands.flights.mission import flown
    from gearwright.reviews import review_of

    sizing = sized(design)
    flight, lives, _ = flown(sizing, mission) if mission is not None else (None, None, None)
    with placed_in(design):
        return review_of(sizing, flight, lives)
