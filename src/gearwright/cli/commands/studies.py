"""Commands for studies: run, compare, status, resume, merge and cluster.

What they share is in `options`, `running` (workers, progress) and `shown` (tables, verdicts, files).
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import interrupted, show_answer, show_row, show_rows
from gearwright.cli.options import (
    FigureOption,
    FreeOption,
    JsonOption,
    LinesOption,
    design_of,
    designs as designs_named,
    studies,
)
from gearwright.cli.terminal import screen, show, show_commands, tell, write_figure
from gearwright.errors import DesignError, Problem, refuse
from gearwright.files import write_text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gearwright.spec import Design, Study, Value
    from gearwright.study import Table
    from gearwright.study.answers import Reduced
    from gearwright.study.running import Part, Progress, Start


# ----------------------------------------------------------------------------------------------------------------------
# Options that the commands of studies share.
# ----------------------------------------------------------------------------------------------------------------------


JournalArgument = Annotated[Path, typer.Argument(help="Journal that a study writes", metavar="JOURNAL")]
WorkersOption = Annotated[
    int | None, typer.Option(help="Processes that compute; 0: none beside this one; left out: as many as cores", min=0)
]
ShardOption = Annotated[
    str | None, typer.Option(help="Compute only this part, such as 2/8: for machines that know nothing of each other")
]
ClusterOption = Annotated[str | None, typer.Option(help="Address of a Dask scheduler, such as tcp://10.0.0.1:8786")]
TlsOption = Annotated[
    tuple[Path, Path, Path] | None,
    typer.Option(help="Encrypt and authenticate: files of authority, certificate and key (PEM)", metavar="CA CERT KEY"),
]
CsvOption = Annotated[Path | None, typer.Option(help="Write the table as CSV")]
ExportOption = Annotated[Path | None, typer.Option(help="Write the table for other programs (.nc or .parquet)")]
StudyReportOption = Annotated[Path | None, typer.Option("--report", help="Write one page that says what comes out")]


# ----------------------------------------------------------------------------------------------------------------------
# What a study ends with: its table, what follows from it, the verdict of its designs, and the files asked for.
# ----------------------------------------------------------------------------------------------------------------------


LISTED = 60
"""Cases that are printed one by one; of more the spread is shown."""


def show_table(
    command: str, table: Table, study: Study | None = None, *, csv: Path | None, json: bool, jsonl: bool
) -> None:
    """Print the table of a study (its spread if it is long, then what follows from it) or JSON; write it as CSV."""
    from gearwright.render.answers.studies import study_answer, study_rows
    from gearwright.render.tables.variants import study_csv, study_grid, summary_grid

    if jsonl and study is None:
        show_rows(command, study_answer(table), study_rows(table))
    elif jsonl:
        pass  # the rows of a study were printed as they were finished
    elif json:
        show_answer(command, study_answer(table, study))
    else:
        show(study_grid(table) if len(table.rows) <= LISTED else summary_grid(table))
        if study is not None and (study.objectives or study.sampling.method != "grid"):
            _show_answer(study, table)
    if csv is not None:
        write_text(csv, study_csv(table))


def _show_answer(study: Study, table: Table) -> None:
    """Print the front of several objectives, and in sentences what wins, by how much, and how sure that is."""
    from gearwright.render.tables.variants import study_grid
    from gearwright.render.words.study import answer
    from gearwright.study.answers import verdict
    from gearwright.study.tables import front_table

    if len(study.objectives) > 1 and verdict(study, table) is None:
        show(study_grid(front_table(study, table)))
    show(*answer(study, table))


def show_reviews(study: Study, table: Table, designs: Mapping[str, Design]) -> None:
    """Print the verdict of the designs with which a study ends.

    Args:
        study: As run.
        table: Its rows.
        designs: Name -> design.
    """
    from gearwright.render.words.sizing import headline
    from gearwright.render.words.study import chosen
    from gearwright.study.answers import verdict
    from gearwright.study.cases import reviewed

    for caption, row in chosen(study, table, verdict(study, table)):
        show(f"{caption}: {headline(reviewed(study, designs[row.design], row.inputs)[1])}.")


def refuse_files(csv: Path | None, export: Path | None, *others: Path | None) -> None:
    """Raise before the first case for every file that could not be written after the last one."""
    folders = {path.parent for path in (csv, *others) if path is not None and not path.parent.is_dir()}
    if folders:
        raise DesignError(
            Problem("", f"there is no folder {folder}; make it, or name another one") for folder in sorted(folders)
        )
    if export is not None:
        from gearwright.study.tables import refuse_export

        refuse_export(export)


def write_files(
    study: Study, table: Table, designs: Mapping[str, Design], *, export: Path | None, report: Path | None
) -> None:
    """Write the table for other programs and the page of a study, where they are asked for."""
    if export is not None:
        from gearwright.study.tables import write_table

        write_table(export, table)
        tell(f"wrote {export}")
    if report is not None:
        from gearwright.render.pages.studies import study_page

        write_text(report, study_page(study, table, designs))
        tell(f"wrote {report}")


# ----------------------------------------------------------------------------------------------------------------------
# What ``study`` and ``merge`` do with studies that keep no rows.
# ----------------------------------------------------------------------------------------------------------------------


def study_reduced(
    study: Study, designs: Mapping[str, Design], *, state: Path | None, workers: int | None, start: Start,
    shard: str | None, json: bool, refused: Mapping[str, bool],
) -> None:  # fmt: skip
    """Run a study that keeps no rows, and show what is left of it.

    Args:
        study: With the table ``reduced``.
        designs: Name -> design.
        state: File that keeps it; one that is there is continued.
        workers: Processes; left out: all cores.
        start: What holds them.
        shard: Part of the study.
        json: Whether the answer is JSON.
        refused: Option that needs rows -> whether it was given.
    """
    from gearwright.spec import case_count
    from gearwright.study.running import reduce_study

    problems = [
        Problem(option, "needs rows, and a study with [reduced] keeps none; take [reduced] out, or the option away")
        for option, given in refused.items()
        if given
    ]
    if problems:
        raise DesignError(problems)
    part = part_given(shard, state)
    count = workers_for(workers, len(part.cases(case_count(study))))
    again = f"gearwright study … --journal {state}" if state is not None else ""
    with stopped_cleanly(state, again), watched(None) as watch:
        found = reduce_study(study, designs, workers=count, state=state, watch=watch, start=start, part=part)
    show_reduced(found, json=json)


def show_reduced(found: Reduced, *, json: bool) -> None:
    """Print what is left of a study, as tables or as JSON.

    Args:
        found: Of the study.
        json: Whether the answer is JSON.
    """
    if json:
        from gearwright.render.answers.studies import reduced_answer

        show_answer("study reduced", reduced_answer(found))
        return
    from gearwright.render.tables.variants import reduced_grids

    show(*reduced_grids(found))


# ----------------------------------------------------------------------------------------------------------------------
# What ``study`` and ``resume`` share while cases are computed: workers, the part of a journal, progress, interruption.
#
# Imports that cost time stand inside the functions, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


SMALL = 200
"""Cases that are not worth the start of other processes."""


def run_shown(
    study: Study, designs: Mapping[str, Design], *, journal: Path | None, workers: int | None, start: Start,
    origin: str, jsonl: bool = False, shard: str | None = None,
) -> Table:  # fmt: skip
    """Run a study, show its progress on a terminal, and print its rows as they are finished if they are asked for."""
    from gearwright.spec import case_count
    from gearwright.study.running import run_study

    part = part_given(shard, journal)
    count = workers_for(workers, len(part.cases(case_count(study))))
    with stopped_cleanly(journal), watched(row_printer("study", study) if jsonl else None) as watch:
        return run_study(
            study, designs, workers=count, journal=journal, origin=origin, watch=watch, start=start, part=part
        )  # fmt: skip


def part_given(shard: str | None, journal: Path | None) -> Part:
    """Return the part of a study that is asked for; a part without a journal would be lost."""
    from gearwright.study.running import Part, part_of

    if shard is not None and journal is None:
        raise DesignError(
            [Problem("--shard", "a part is for a journal, which `gearwright merge` joins; give --journal")]
        )
    return Part() if shard is None else part_of(shard)


def workers_for(asked: int | None, cases: int) -> int:
    """Return how many processes compute: as many as were asked for, none for a few cases, else one for each core."""
    if asked is not None:
        return asked
    return 0 if cases <= SMALL else os.cpu_count() or 1


def start_of(cluster: str | None, tls: tuple[Path, Path, Path] | None) -> Start:
    """Return what holds workers: processes here, or a cluster."""
    if cluster is not None:
        from gearwright.study.workers import Cluster

        return Cluster(cluster, tls)
    from gearwright.study.workers import local

    return local


@contextmanager
def stopped_cleanly(journal: Path | None, following: str = "") -> Iterator[None]:
    """Say what is kept where Ctrl-C or its like ends a run, and how it goes on."""
    try:
        yield
    except KeyboardInterrupt:
        following = following or f"gearwright resume {journal}"
        kept = f"what is finished is kept; next: {following}" if journal else "nothing was kept"
        raise typer.Exit(interrupted(kept)) from None


def row_printer(command: str, study: Study) -> Callable[[Progress], None]:
    """Print the envelope of a study's JSON Lines; return what prints the rows that are finished."""
    from gearwright.render.answers.studies import StudyAnswer, study_row

    show_rows(command, StudyAnswer(study.name, study.description, None, (), ()), ())

    def print_rows(now: Progress) -> None:
        for row in now.rows:
            show_row(study_row(row))

    return print_rows


@contextmanager
def watched(printed: Callable[[Progress], None] | None) -> Iterator[Callable[[Progress], None]]:
    """Show cases, rate, remaining time and failures on a terminal; elsewhere only what prints rows is told."""
    from rich.progress import BarColumn, Progress as Bar, TextColumn

    columns = (TextColumn("{task.fields[count]}"), BarColumn(), TextColumn("{task.description}"))
    with Bar(*columns, console=screen(error=True), transient=True, disable=not sys.stderr.isatty()) as bar:
        task = bar.add_task("starting workers", total=None, count="")

        def update(now: Progress) -> None:
            words = f"{now.rate:.1f}/s, {clock_time(now.remaining)} to go, {now.failed:,} infeasible"
            count = f"{now.done:,} of {now.total:,}"
            bar.update(task, completed=now.done, total=now.total, description=words, count=count)
            if printed is not None:
                printed(now)

        yield update


def clock_time(seconds: float) -> str:
    """Return a time as a reader of clocks says it."""
    if seconds == float("inf"):
        return "unknown time"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes:02d} min" if hours else f"{minutes} min {rest:02d} s" if minutes else f"{rest} s"


# ----------------------------------------------------------------------------------------------------------------------
# The commands ``study`` and ``compare``: many designs in one table and one figure.
#
# Imports that cost time stand inside the commands, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


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
    from gearwright.cli.commands.designs import show_equal_life, wishes_of
    from gearwright.spec import edited
    from gearwright.study import compare as compared, for_requirement
    from gearwright.study.running import comparison_of
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
    from gearwright.render.tables.weights import beside_statistics
    from gearwright.sizing import size

    first = next(iter(designs.values()), None)
    sentence = "" if first is None else beside_statistics(table, size(first))
    if sentence:
        show(sentence)


def _write_comparison(path: Path, table: Table, designs: dict[str, Design], changes: dict[str, Value]) -> None:
    from gearwright import edited, size
    from gearwright.render.pages.studies import comparison
    from gearwright.reviews import review_of

    sizings = {name: size(edited(design, changes)) for name, design in designs.items()}
    reviews = {name: review_of(sizing) for name, sizing in sizings.items()}
    write_text(path, comparison(table, sizings, reviews))
    tell(f"wrote {path}")


def _draw(study: Study, table: Table, path: Path) -> None:
    from gearwright.render.figures.study import figure_of

    write_figure(figure_of(study, table), path)


def _refuse_varied(changes: Mapping[str, Value], study: Study) -> None:
    """Refuse changes for all cases of what an axis varies from case to case."""
    fix = "an axis of the study gives it from case to case; leave it out, or change the axis in the file"
    refuse(Problem(f"--set {path}", fix) for path in changes if path in study.axes)


def _changes(written: list[str] | None) -> dict[str, Value]:
    """Return PATH=VALUE options as changes; a value is read as TOML reads it, or taken as text."""
    import tomllib

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


# ----------------------------------------------------------------------------------------------------------------------
# The commands ``status``, ``resume``, ``merge`` and ``cluster``: studies watched, continued, joined, spread out.
#
# Imports that cost time stand inside the commands, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def status(
    journal: JournalArgument,
    verify: Annotated[bool, typer.Option("--verify", help="Read every row and name what is damaged or edited")] = False,
    json: JsonOption = False,
) -> None:
    """Show how far a study is: also while it runs, from another terminal."""
    from gearwright.study.journal import status as look

    if verify:
        _verify(journal)
        return
    state = look(journal)
    if json:
        from gearwright.render.answers.studies import status_answer

        show_answer("status", status_answer(state))
        return
    known = state.recorded
    show(f"{known.study.name}: {state.done:,} of {known.total:,} cases, {state.failed:,} infeasible")
    if state.done == known.total:
        show("complete")
    elif state.running:
        show(f"running, {state.rate:.1f} cases/s, {clock_time(state.remaining)} to go")
    else:
        show(f"stopped; next: gearwright resume {journal}")


def _verify(journal: Path) -> None:
    """Say what a journal has lost; exit code 1 if it has lost anything."""
    from gearwright.study.journal import verify

    verified = verify(journal)
    if not verified.damaged and not verified.lost:
        show(f"whole: {verified.kept:,} cases as they were written")
        return
    lost = f"cases {_spans(verified.lost)} are lost" if verified.lost else "no case is lost, but the file is damaged"
    show(f"{lost}; {verified.kept:,} are as they were written\nnext: gearwright resume {journal}")
    raise typer.Exit(1)


def _spans(numbers: Sequence[int]) -> str:
    """Return numbers in words, those that follow each other as from-to."""
    starts = [number for at, number in enumerate(numbers) if not at or numbers[at - 1] != number - 1]
    ends = [number for at, number in enumerate(numbers) if numbers[at + 1 : at + 2] != (number + 1,)]
    return ", ".join(
        f"{first}-{last}" if last > first else f"{first}" for first, last in zip(starts, ends, strict=True)
    )


def resume(
    journal: JournalArgument,
    workers: WorkersOption = None,
    cluster: ClusterOption = None,
    tls: TlsOption = None,
    shard: ShardOption = None,
    anyway: Annotated[
        bool, typer.Option("--anyway", help="Go on although designs or gearwright have changed since")
    ] = False,
    csv: CsvOption = None,
    export: ExportOption = None,
    report: StudyReportOption = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Continue a study that was stopped, or show a complete one: no finished case is computed again."""
    from gearwright.study.journal import recorded
    from gearwright.study.running import resume as go_on

    refuse_files(csv, export, report)
    known = recorded(journal)
    present = {} if anyway else present_designs(known.designs, Path(known.origin))
    if not anyway:
        _refuse_changed_mission(journal, known.study, Path(known.origin))
    count = workers_for(workers, known.total)
    with stopped_cleanly(journal), watched(row_printer("resume", known.study) if jsonl else None) as watch:
        table = go_on(
            journal, workers=count, designs=present, anyway=anyway, watch=watch, start=start_of(cluster, tls),
            part=part_given(shard, journal),
        )  # fmt: skip
    show_table("resume", table, known.study, csv=csv, json=json, jsonl=jsonl)
    if not (json or jsonl):
        show_reviews(known.study, table, known.designs)
    write_files(known.study, table, known.designs, export=export, report=report)


def _refuse_changed_mission(journal: Path, study: Study, folder: Path) -> None:
    from gearwright.spec import mission_changed

    if mission_changed(study, folder):
        fix = "begin a new journal, or continue --anyway with the mission in the journal"
        raise DesignError([Problem("fly.mission", f"has changed since the study was begun; {fix}")], str(journal))


def present_designs(names: Mapping[str, Design], folder: Path) -> dict[str, Design]:
    """Return those designs of a study whose file is still there, as it is now."""
    from gearwright.shipped import shipped_designs

    there = [name for name in names if (folder / name).exists() or name in shipped_designs()]
    return {name: design_of(name, folder) for name in there}


def merge(
    journals: Annotated[list[Path], typer.Argument(help="Journals of parts of one study", metavar="JOURNAL...")],
    into: Annotated[Path, typer.Option(help="Journal that gets what all of them have; made where there is none")],
    export: ExportOption = None,
) -> None:
    """Make the journals of parts of one study a single one, which `resume` completes and shows."""
    from gearwright.study.journal import recorded, rows_of
    from gearwright.study.running import is_reduced, merge as merged, merge_reduced, table_of

    refuse_files(None, export, None)
    if all(path.is_file() and is_reduced(path) for path in journals):
        _refuse_rows(export)
        show_reduced(merge_reduced(journals, into), json=False)
        return
    done, total = merged(journals, into)
    show(f"{done:,} of {total:,} cases in {into}")
    if export is not None:
        study = recorded(into).study
        write_files(study, table_of(study, rows_of(into)), {}, export=export, report=None)
    show(f"next: gearwright resume {into}")


def _refuse_rows(export: Path | None) -> None:
    """Refuse a table of studies that keep no rows."""
    if export is not None:
        message = "needs rows, and states of studies with [reduced] have none; leave it out"
        raise DesignError([Problem("--export", message)])


def cluster(
    host: Annotated[str, typer.Option(help="Name or address of the machine of the scheduler")] = "127.0.0.1",
    processes: Annotated[int | None, typer.Option(help="Workers on one machine; left out: its cores", min=1)] = None,
    tls: TlsOption = None,
    slurm: Annotated[int | None, typer.Option(help="Print a Slurm script for so many parts instead", min=1)] = None,
    study: Annotated[Path, typer.Option(help="Study that the script runs")] = Path("STUDY.toml"),
) -> None:
    """Print the commands that start a Dask cluster for studies, or a script that runs one in parts under Slurm."""
    from gearwright.study.running import slurm as script
    from gearwright.study.workers import commands

    if slurm is not None:
        show_commands(script(study, slurm))
        return
    scheduler, workers, start = commands(host, processes or os.cpu_count() or 1, tls)
    show_commands(f"once:              {scheduler}\non every machine:  {workers}\nthen:              {start}")
