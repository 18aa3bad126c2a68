"""Commands `optimise` and `architectures`: Pareto-optimal designs and ranked gear trains."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.commands.studies import CsvOption, WorkersOption, refuse_files, stopped_cleanly
from gearwright.cli.options import DesignArgument, JsonOption, axis_of, bound_of, design_of, designs as designs_named
from gearwright.cli.terminal import show, tell
from gearwright.errors import DesignError, Problem
from gearwright.files import make_folder, write_text

if TYPE_CHECKING:
    from collections.abc import Mapping

    from gearwright.enumeration import Ranking
    from gearwright.optimum import Optimum
    from gearwright.spec import Design, Study


# ----------------------------------------------------------------------------------------------------------------------
# The command ``optimise``: the best designs along freedoms, why they are, and how sure that is.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


Several = list[str] | None


def optimise(
    name: Annotated[
        str,
        typer.Argument(
            help="Study file with a table [search], or a design", autocompletion=designs_named, metavar="FILE"
        ),
    ],
    free: Annotated[
        Several,
        typer.Option(help="PATH=FROM..TO or PATH=VALUE,VALUE of a design, several times; left out: what most leave"),
    ] = None,
    minimise: Annotated[
        Several, typer.Option(help="Result to be small, several times; left out: total_mass and loss")
    ] = None,
    maximise: Annotated[Several, typer.Option(help="Result to be large, several times")] = None,
    keep: Annotated[Several, typer.Option(help="RESULT>=NUMBER or RESULT<=NUMBER, in the unit of the tables")] = None,
    screened: Annotated[int | None, typer.Option(help="Designs of the first layer", min=0)] = None,
    evaluations: Annotated[int | None, typer.Option(help="Designs after it, at most", min=1)] = None,
    seed: Annotated[int | None, typer.Option(help="Start of the random numbers", min=0)] = None,
    restarts: Annotated[
        int, typer.Option(help="Independent searches, whose spread tells how far the best may lie", min=1)
    ] = 1,
    journal: Annotated[Path | None, typer.Option(help="Keep what is finished in this file, and go on with it")] = None,
    anyway: Annotated[
        bool, typer.Option("--anyway", help="Go on although designs or gearwright have changed since")
    ] = False,
    workers: WorkersOption = None,
    out: Annotated[Path | None, typer.Option(help="Write the listed designs of the front into this folder")] = None,
    csv: CsvOption = None,
    report: Annotated[Path | None, typer.Option(help="Write the answer as one self-contained HTML page")] = None,
    json: JsonOption = False,
) -> None:
    """Find the best designs along freedoms: why they are, what limits cost, how sure the choice is."""
    from gearwright.optimum import optimise as best_of, restarted
    from gearwright.render.answers.studies import optimise_answer

    refuse_files(csv, None, report)
    if out is not None:
        make_folder(out)
    study, designs = _study(name, free, minimise, maximise, keep)
    changes = {"screened": screened, "evaluations": evaluations, "seed": seed}
    study = _with_rules(study, {key: value for key, value in changes.items() if value is not None})
    count = (os.cpu_count() or 1) if workers is None else workers
    with stopped_cleanly(journal, f"gearwright optimise {name} … --journal {journal}"):
        optimum = best_of(study, designs, journal=journal, workers=count, anyway=anyway, tell=_silent if json else tell)
        optimum = restarted(optimum, designs, starts=restarts, workers=count, tell=_silent if json else tell)
    if json:
        show_answer("optimise", optimise_answer(optimum))
    else:
        _show_optimum(optimum)
    _write_optimum(optimum, designs, out, csv, report)


def _study(
    name: str, free: Several, minimise: Several, maximise: Several, keep: Several
) -> tuple[Study, Mapping[str, Design]]:
    """Return the study of a file, or the one that options make of a design."""
    from gearwright.optimum.optimise import study_for
    from gearwright.shipped import find_study, shipped_studies
    from gearwright.spec import file_text, read_study, toml_tables

    given = {"--free": free, "--minimise": minimise, "--maximise": maximise, "--keep": keep}
    path = Path(name)
    if (path.is_file() and path.suffix == ".toml" and "designs" in toml_tables(file_text(path), name)) or (
        not path.exists() and name in shipped_studies()
    ):
        problems = [
            Problem(option, "a study file says this itself; change it there") for option, said in given.items() if said
        ]
        if problems:
            raise DesignError(problems, name)
        study, folder = read_study(name), find_study(name).parent
        return study, {design: design_of(design, folder) for design in study.designs}
    design = design_of(name)
    objectives = {**dict.fromkeys(minimise or (), "minimum"), **dict.fromkeys(maximise or (), "maximum")}
    study = study_for(
        name,
        design,
        axes=dict(map(axis_of, free or ())),
        objectives=objectives,
        constraints=dict(map(bound_of, keep or ())),
    )
    return study, {name: design}


def _with_rules(study: Study, changes: dict[str, int]) -> Study:
    from gearwright.spec.studies import Search

    rules = Search.model_validate({**(study.search or Search()).model_dump(by_alias=True), **changes})
    return study.model_copy(update={"search": rules})


def _silent(_: str) -> None:
    """Say nothing beside the answer."""


def _show_optimum(optimum: Optimum) -> None:
    """Show the answer and its tables."""
    from gearwright.render.tables.study import optimum_tables
    from gearwright.render.words.sizing import table_text
    from gearwright.render.words.study import optimum_sentences

    for sentence in optimum_sentences(optimum):
        show(sentence)
    for table in optimum_tables(optimum):
        show(table_text(table))


def _write_optimum(
    optimum: Optimum, designs: Mapping[str, Design], out: Path | None, csv: Path | None, report: Path | None
) -> None:
    """Write what is asked for."""
    from gearwright.render.pages.studies import optimum_page
    from gearwright.render.tables.study import front_rows, letter, listed
    from gearwright.render.tables.variants import study_csv
    from gearwright.spec import design_text, edited
    from gearwright.study.cases import split

    files = dict[Path, str]()
    for k, place in enumerate(listed(optimum) if out is not None else ()):
        row = optimum.front[place].row
        changes, _ = split({**optimum.study.changes, **row.inputs})
        assert out is not None
        files[out / f"{letter(k)}.toml"] = design_text(edited(designs[row.design], changes))
    if csv is not None:
        files[csv] = study_csv(front_rows(optimum))
    if report is not None:
        files[report] = optimum_page(optimum)
    for path, content in files.items():
        write_text(path, content)
        tell(f"wrote {path}")


# ----------------------------------------------------------------------------------------------------------------------
# The command ``architectures``: every train that can serve a requirement, ranked at equal life.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def architectures(
    design: DesignArgument,
    life_h: Annotated[float, typer.Option(help="Life of gears and bearings that is asked of all", min=0.001)] = 20000.0,
    stages: Annotated[
        list[int] | None, typer.Option(help="How many stages a train may have, several times; left out: 2 and 3")
    ] = None,
    close: Annotated[int, typer.Option(help="How many of the most promising are closed for the life", min=0)] = 12,
    restarts: Annotated[
        int,
        typer.Option(help="How often at most those that could be the lightest are closed from other numbers", min=0),
    ] = 4,
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

    from gearwright.enumeration import STAGES, Effort, architectures as ranked
    from gearwright.render.answers.studies import architectures_answer
    from gearwright.units import RPM

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
        effort=Effort(close, restarts),
        beside={name: design_of(name) for name in beside or ()},
        fastest=None if motor_rpm is None else motor_rpm * RPM,
        workers=(os.cpu_count() or 1) if workers is None else workers,
        journal=journal,
        tell=_silent if json else tell,
    )
    if json:
        show_answer("architectures", architectures_answer(ranking), design=ranking.requirement)
    else:
        _show_ranking(ranking)
    _write_ranking(ranking, out, csv, report)
    if close and not ranking.passing:
        raise typer.Exit(1)


def _show_ranking(ranking: Ranking) -> None:
    """Show the answer, the closed designs, and the most promising."""
    from gearwright.render.tables.study import (
        SHOWN_ARCHITECTURES as SHOWN,
        architectures_table,
        equal_life_table,
        measures_table,
    )
    from gearwright.render.words.sizing import table_text
    from gearwright.render.words.study import ranking_sentences
    from gearwright.units import text

    for sentence in ranking_sentences(ranking):
        show(sentence)
    if ranking.closed:
        show(table_text(equal_life_table(ranking.closed, f"Closed for {text(ranking.life, 'life', 3)}")))
        show(table_text(measures_table(ranking.closed)))
    show(table_text(architectures_table(ranking.candidates[:SHOWN], "The most promising")))


def _write_ranking(ranking: Ranking, out: Path | None, csv: Path | None, report: Path | None) -> None:
    """Write what is asked for."""
    from gearwright.render.tables.study import architectures_csv

    files = {} if out is None else {out / f"{row.title}.toml": row.file for row in ranking.closed if row.file}
    files |= {} if csv is None else {csv: architectures_csv(ranking.candidates)}
    files |= {} if report is None else _pages(ranking, report)
    for path, content in files.items():
        write_text(path, content)
        tell(f"wrote {path}")


def _pages(ranking: Ranking, report: Path) -> dict[Path, str]:
    """Return the page of the ranking, and beside it the one on which the lightest turns."""
    from gearwright.render.pages.motion import turning
    from gearwright.render.pages.studies import architectures_page
    from gearwright.shape import glb, scene
    from gearwright.study.architectures import closed_designs

    closed = closed_designs(ranking.closed)
    if not ranking.passing:
        return {report: architectures_page(ranking, closed)}
    beside, lightest = report.with_name(f"{report.stem}-turning.html"), closed[ranking.passing[0].title]
    page = architectures_page(ranking, closed, turning=beside.name)
    built = scene(lightest.sizing, detail="coarse")
    return {report: page, beside: turning(lightest, built, glb(built))}
