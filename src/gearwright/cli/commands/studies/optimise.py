"""The command ``optimise``: the best designs along freedoms, why they are, and how sure that is.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.commands.studies.options import CsvOption, WorkersOption
from gearwright.cli.commands.studies.running import stopped_cleanly
from gearwright.cli.commands.studies.shown import refuse_files
from gearwright.cli.completion import designs as designs_named
from gearwright.cli.designs import design_of
from gearwright.cli.freedoms import axis_of, bound_of
from gearwright.cli.options import JsonOption
from gearwright.cli.terminal.output import show, tell

if TYPE_CHECKING:
    from collections.abc import Mapping

    from gearwright.optimum import Optimum
    from gearwright.spec import Design, Study

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
    from gearwright.optimum import optimise as best_of
    from gearwright.render.answers.optimum import optimise_answer
    from gearwright.writing import make_folder

    refuse_files(csv, None, report)
    if out is not None:
        make_folder(out)
    study, designs = _study(name, free, minimise, maximise, keep)
    changes = {"screened": screened, "evaluations": evaluations, "seed": seed}
    study = _with_rules(study, {key: value for key, value in changes.items() if value is not None})
    count = (os.cpu_count() or 1) if workers is None else workers
    with stopped_cleanly(journal, f"gearwright optimise {name} … --journal {journal}"):
        optimum = best_of(study, designs, journal=journal, workers=count, anyway=anyway, tell=_quiet if json else tell)
    if json:
        show_answer("optimise", optimise_answer(optimum))
    else:
        _show(optimum)
    _write(optimum, designs, out, csv, report)


def _study(
    name: str, free: Several, minimise: Several, maximise: Several, keep: Several
) -> tuple[Study, Mapping[str, Design]]:
    """Return the study of a file, or the one that options make of a design."""
    from gearwright.errors import DesignError, Problem
    from gearwright.optimum.request import study_for
    from gearwright.shipped import find_study, shipped_studies
    from gearwright.spec import read_study
    from gearwright.spec.read import file_text, toml_tables

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


def _quiet(_: str) -> None:
    """Say nothing beside the answer."""


def _show(optimum: Optimum) -> None:
    """Show the answer and its tables."""
    from gearwright.render.tables.study.optimum import optimum_tables
    from gearwright.render.words.optimum import optimum_sentences
    from gearwright.render.words.text import table_text

    for sentence in optimum_sentences(optimum):
        show(sentence)
    for table in optimum_tables(optimum):
        show(table_text(table))


def _write(
    optimum: Optimum, designs: Mapping[str, Design], out: Path | None, csv: Path | None, report: Path | None
) -> None:
    """Write what is asked for."""
    from gearwright.render.pages.studies.optimum import optimum_page
    from gearwright.render.tables.study.lists import letter
    from gearwright.render.tables.study.optimum import front_rows, listed
    from gearwright.render.tables.study.variants import study_csv
    from gearwright.spec import design_text, edited
    from gearwright.study.cases import split
    from gearwright.writing import write_text

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
