"""The command ``architectures``: every train that can serve a requirement, ranked at equal life.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.commands.studies.options import CsvOption, WorkersOption
from gearwright.cli.commands.studies.shown import refuse_files
from gearwright.cli.completion import designs as designs_named
from gearwright.cli.designs import design_of
from gearwright.cli.options import DesignArgument, JsonOption
from gearwright.cli.terminal.output import show, tell

if TYPE_CHECKING:
    from gearwright.enumeration import Ranking


def architectures(
    design: DesignArgument,
    life_h: Annotated[float, typer.Option(help="Life of gears and bearings that is asked of all", min=0.001)] = 20000.0,
    stages: Annotated[
        list[int] | None, typer.Option(help="How many stages a train may have, several times; left out: 2 and 3")
    ] = None,
    close: Annotated[int, typer.Option(help="How many of the most promising are closed for the life", min=0)] = 12,
    beside: Annotated[
        list[str] | None,
        typer.Option(help="Design closed to compare with, several times", autocompletion=designs_named),
    ] = None,
    motor_rpm: Annotated[
        float | None, typer.Option(help="Fastest motor; left out: as fast as motor or turbine of the design", min=1.0)
    ] = None,
    journal: Annotated[Path | None, typer.Option(help="Keep what is finished in this file, and go on with it")] = None,
    workers: WorkersOption = None,
    out: Annotated[Path | None, typer.Option(help="Write the closed designs into this folder")] = None,
    csv: CsvOption = None,
    report: Annotated[Path | None, typer.Option(help="Write the ranking as one self-contained HTML page")] = None,
    json: JsonOption = False,
) -> None:
    """Enumerate every train of a few stages for a design's machines; size, rank and close them for one life."""
    import os

    from gearwright.enumeration import STAGES
    from gearwright.enumeration import architectures as ranked
    from gearwright.errors import DesignError, Problem
    from gearwright.render.answers.architectures import architectures_answer
    from gearwright.units import RPM
    from gearwright.writing import make_folder

    refuse_files(csv, None, report)
    own = design_of(design)
    if motor_rpm is not None and not own.motors:
        raise DesignError(
            [Problem("--motor-rpm", "the design has no motor; leave it out, or add a table [motors.NAME]")]
        )
    if out is not None:
        make_folder(out)
    ranking = ranked(
        own,
        life=life_h * 3600.0,
        stages=tuple(stages or STAGES),
        closed=close,
        beside={name: design_of(name) for name in beside or ()},
        fastest=None if motor_rpm is None else motor_rpm * RPM,
        workers=(os.cpu_count() or 1) if workers is None else workers,
        journal=journal,
        tell=_quiet if json else tell,
    )
    if json:
        show_answer("architectures", architectures_answer(ranking), design=ranking.requirement)
    else:
        _show(ranking)
    _write(ranking, out, csv, report)
    if close and not ranking.passing:
        raise typer.Exit(1)


def _quiet(_: str) -> None:
    """Say nothing beside the answer."""


def _show(ranking: Ranking) -> None:
    """Show the answer, the closed designs, and the most promising."""
    from gearwright.render.tables.study.architectures import SHOWN, architectures_table
    from gearwright.render.tables.study.equal_life import equal_life_table
    from gearwright.render.words.architectures import ranking_sentences
    from gearwright.render.words.text import table_text
    from gearwright.units import text

    for sentence in ranking_sentences(ranking):
        show(sentence)
    if ranking.closed:
        show(table_text(equal_life_table(ranking.closed, f"Closed for {text(ranking.life, 'life', 3)}")))
    show(table_text(architectures_table(ranking.candidates[:SHOWN], "The most promising")))


def _write(ranking: Ranking, out: Path | None, csv: Path | None, report: Path | None) -> None:
    """Write what is asked for."""
    from gearwright.render.tables.study.architectures import architectures_csv
    from gearwright.writing import write_text

    files = {} if out is None else {out / f"{row.title}.toml": row.file for row in ranking.closed if row.file}
    files |= {} if csv is None else {csv: architectures_csv(ranking.candidates)}
    files |= {} if report is None else _pages(ranking, report)
    for path, content in files.items():
        write_text(path, content)
        tell(f"wrote {path}")


def _pages(ranking: Ranking, report: Path) -> dict[Path, str]:
    """Return the page of the ranking, and beside it the one on which the lightest turns."""
    from gearwright.render.pages.designs.turning import turning
    from gearwright.render.pages.studies.architectures import architectures_page
    from gearwright.sizing import size
    from gearwright.spec import parse

    if not ranking.passing:
        return {report: architectures_page(ranking)}
    beside = report.with_name(f"{report.stem}-turning.html")
    lightest = size(parse(ranking.passing[0].file))
    return {report: architectures_page(ranking, turning=beside.name), beside: turning(lightest, detail="coarse")}
