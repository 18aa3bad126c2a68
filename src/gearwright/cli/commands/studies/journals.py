"""The commands ``status``, ``resume``, ``merge`` and ``cluster``: studies watched, continued, joined, spread out.

Imports that cost time stand inside the commands, so that ``--help`` stays quick.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.commands.studies.options import (
    ClusterOption,
    CsvOption,
    ExportOption,
    JournalArgument,
    ShardOption,
    StudyReportOption,
    TlsOption,
    WorkersOption,
)
from gearwright.cli.commands.studies.reduced import show_reduced
from gearwright.cli.commands.studies.running import (
    clock_time,
    part_given,
    row_printer,
    start_of,
    stopped_cleanly,
    watched,
    workers_for,
)
from gearwright.cli.commands.studies.shown import refuse_files, show_reviews, show_table, write_files
from gearwright.cli.designs import design_of
from gearwright.cli.options import JsonOption, LinesOption
from gearwright.cli.terminal.output import show, show_commands

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from gearwright.spec import Design, Study


def status(
    journal: JournalArgument,
    verify: Annotated[bool, typer.Option("--verify", help="Read every row and name what is damaged or edited")] = False,
    json: JsonOption = False,
) -> None:
    """Show how far a study is: also while it runs, from another terminal."""
    from gearwright.study.running import status as look

    if verify:
        _verify(journal)
        return
    state = look(journal)
    if json:
        from gearwright.render.answers.study import status_answer

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
    from gearwright.study.running import verify

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
    from gearwright.study.running import recorded
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
    from gearwright.errors import DesignError, Problem
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
    from gearwright.study.running import is_reduced, merge_reduced, recorded, rows_of, table_of
    from gearwright.study.running import merge as merged

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
    from gearwright.errors import DesignError, Problem

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
    from gearwright.study.running import commands
    from gearwright.study.running import slurm as script

    if slurm is not None:
        show_commands(script(study, slurm))
        return
    scheduler, workers, start = commands(host, processes or os.cpu_count() or 1, tls)
    show_commands(f"once:              {scheduler}\non every machine:  {workers}\nthen:              {start}")
