"""The commands ``study`` and ``compare``: many designs in one table and one figure.

Imports that cost time stand inside the commands, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.commands.studies.options import (
    ClusterOption,
    CsvOption,
    ExportOption,
    ShardOption,
    StudyReportOption,
    TlsOption,
    WorkersOption,
)
from gearwright.cli.commands.studies.running import run_shown, start_of
from gearwright.cli.commands.studies.shown import refuse_files, show_reviews, show_table, write_files
from gearwright.cli.completion import designs as designs_named
from gearwright.cli.completion import studies
from gearwright.cli.designs import design_of
from gearwright.cli.options import FigureOption, FreeOption, JsonOption, LinesOption
from gearwright.cli.terminal.output import show, tell, write_figure
from gearwright.writing import write_text

if TYPE_CHECKING:
    from collections.abc import Mapping

    from gearwright.spec import Design, Study
    from gearwright.spec.studies import Value
    from gearwright.study import Table

JournalOption = Annotated[Path | None, typer.Option(help="Keep every finished case in this file, for `resume`")]
SetOption = Annotated[
    list[str] | None, typer.Option("--set", help="PATH=VALUE for all cases, such as gears.material=…")
]


def study(
    name: Annotated[
        str | None,
        typer.Argument(
            help="Study file, or name of a shipped study; left out: list them",
            autocompletion=studies,
        ),
    ] = None,
    changes: SetOption = None,
    journal: JournalOption = None,
    shard: ShardOption = None,
    workers: WorkersOption = None,
    cluster: ClusterOption = None,
    tls: TlsOption = None,
    csv: CsvOption = None,
    export: ExportOption = None,
    figure: FigureOption = None,
    report: StudyReportOption = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Run a study: designs along axes or over samples, one row per variant."""
    from gearwright.shipped import find_study, shipped_studies, shipped_study
    from gearwright.spec import read_study

    if name is None:
        for shipped in shipped_studies():
            show(f"{shipped:20} {read_study(shipped_study(shipped)).name}")
        return
    path = find_study(name)
    read = read_study(path)
    asked = _changes(changes)
    _refuse_varied(asked, read)
    read = read.model_copy(update={"changes": {**read.changes, **asked}})
    designs = {design: design_of(design, path.parent) for design in read.designs}
    if read.reduced is not None:
        from gearwright.cli.commands.studies.reduced import study_reduced

        refused = {
            "--csv": csv is not None, "--export": export is not None, "--figure": figure is not None,
            "--report": report is not None, "--jsonl": jsonl,
        }  # fmt: skip
        start = start_of(cluster, tls)
        study_reduced(
            read, designs, state=journal, workers=workers, start=start, shard=shard, json=json, refused=refused
        )  # fmt: skip
        return
    refuse_files(csv, export, figure, report)
    table = run_shown(
        read,
        designs,
        journal=journal,
        workers=workers,
        start=start_of(cluster, tls),
        origin=str(path.parent),
        jsonl=jsonl,
        shard=shard,
    )
    show_table("study", table, read, csv=csv, json=json, jsonl=jsonl)
    if not (json or jsonl):
        show_reviews(read, table, designs)
    if figure is not None:
        _draw(read, table, figure)
    write_files(read, table, designs, export=export, report=report)


def compare(
    designs: Annotated[
        list[str] | None,
        typer.Argument(
            help="Designs; left out: the thesis's ten",
            autocompletion=designs_named,
        ),
    ] = None,
    power_kw: Annotated[float | None, typer.Option(help="Rated power of all machines together", min=0.001)] = None,
    engine_rpm: Annotated[float | None, typer.Option(help="Speed of the turbine", min=0.001)] = None,
    propeller_rpm: Annotated[float | None, typer.Option(help="Speed of the propeller", min=0.001)] = None,
    changes: SetOption = None,
    life_h: Annotated[
        float | None,
        typer.Option(help="Close every design for this life, and compare complete masses", min=0.001),
    ] = None,
    free: FreeOption = None,
    out: Annotated[
        Path | None,
        typer.Option(help="With --life-h: write the closed designs into this folder, made where there is none"),
    ] = None,
    csv: CsvOption = None,
    figure: FigureOption = None,
    report: Annotated[Path | None, typer.Option(help="Write the comparison as one self-contained HTML page")] = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Compare architectures for one engine: masses, margins and power density, in one table and one figure."""
    from gearwright.cli.commands.designs.closure import show_equal_life, wishes_of
    from gearwright.errors import DesignError, Problem
    from gearwright.spec import edited
    from gearwright.study import compare as compared
    from gearwright.study import for_requirement
    from gearwright.study.running.compare import comparison_of
    from gearwright.units import RPM

    study = comparison_of(designs or None, changes=_changes(changes))
    power = None if power_kw is None else power_kw * 1e3
    engine, propeller = (None if rpm is None else rpm * RPM for rpm in (engine_rpm, propeller_rpm))
    chosen = {name: design_of(name) for name in study.designs}
    if life_h is not None:
        fitted = {
            name: for_requirement(
                edited(design, study.changes), power=power, engine_speed=engine, propeller_speed=propeller
            )
            for name, design in chosen.items()
        }
        _refuse_beside_life(figure=figure, jsonl=jsonl)
        refuse_files(csv, None, report)
        show_equal_life(fitted, wishes_of(life_h, free), out=out, csv=csv, report=report, json=json)
        return
    if free is not None:
        raise DesignError([Problem("--free", "it is of designs that are closed; give --life-h, too, such as 20000")])
    if out is not None:
        raise DesignError([Problem("--out", "what it writes are closed designs; give --life-h, too, such as 20000")])
    table = compared(chosen, power=power, engine_speed=engine, propeller_speed=propeller, changes=study.changes)
    show_table("compare", table, csv=csv, json=json, jsonl=jsonl)
    fitted = {
        row.design: for_requirement(chosen[row.design], power=power, engine_speed=engine, propeller_speed=propeller)
        for row in table.good
    }
    if not json and not jsonl:
        _show_statistics(table, fitted)
    if figure is not None:
        _draw(study, table, figure)
    if report is not None:
        _write_comparison(report, table, fitted, study.changes)


def _refuse_beside_life(*, figure: Path | None, jsonl: bool) -> None:
    """Raise for what a comparison at equal life has not."""
    from gearwright.errors import DesignError, Problem

    asked = {"--figure": figure is not None, "--jsonl": jsonl}
    problems = [
        Problem(name, "a comparison with --life-h has none; take --report, --csv or --json")
        for name, is_asked in asked.items()
        if is_asked
    ]
    if problems:
        raise DesignError(problems)


def _show_statistics(table: Table, designs: dict[str, Design]) -> None:
    """Show what real gearboxes weigh, where the designs are of one requirement; their powers are then alike."""
    from gearwright.render.words.masses import beside_statistics
    from gearwright.sizing import size

    first = next(iter(designs.values()), None)
    sentence = "" if first is None else beside_statistics(table, size(first))
    if sentence:
        show(sentence)


def _write_comparison(path: Path, table: Table, designs: dict[str, Design], changes: dict[str, Value]) -> None:
    from gearwright.render.pages.studies.comparison import comparison
    from gearwright.reviews import review_of
    from gearwright.sizing import size
    from gearwright.spec import edited

    sizings = {name: size(edited(design, changes)) for name, design in designs.items()}
    reviews = {name: review_of(sizing) for name, sizing in sizings.items()}
    write_text(path, comparison(table, sizings, reviews))
    tell(f"wrote {path}")


def _draw(study: Study, table: Table, path: Path) -> None:
    from gearwright.render.figures.study.spread import figure_of

    write_figure(figure_of(study, table), path)


def _refuse_varied(changes: Mapping[str, Value], study: Study) -> None:
    """Refuse changes for all cases of what an axis varies from case to case."""
    from gearwright.errors import Problem, refuse

    fix = "an axis of the study gives it from case to case; leave it out, or change the axis in the file"
    refuse(Problem(f"--set {path}", fix) for path in changes if path in study.axes)


def _changes(written: list[str] | None) -> dict[str, Value]:
    """Return PATH=VALUE options as changes; a value is read as TOML reads it, or taken as text."""
    import tomllib

    from gearwright.errors import DesignError, Problem

    changes: dict[str, Value] = {}
    for change in written or []:
        path, equals, value = change.partition("=")
        if not equals:
            raise DesignError([Problem("--set", f"{change!r} has no value; write PATH=VALUE")])
        try:
            changes[path.strip()] = tomllib.loads(f"value = {value}")["value"]
        except tomllib.TOMLDecodeError:
            changes[path.strip()] = value.strip()
    return changes
