"""What ``study`` and ``resume`` share while cases are computed: workers, the part of a journal, progress, interruption.

Imports that cost time stand inside the functions, so that ``--help`` stays quick.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from gearwright.cli.answers import show_row, show_rows
from gearwright.cli.ends import interrupted
from gearwright.cli.terminal.output import screen

if TYPE_CHECKING:
    from collections.abc import Mapping

    from gearwright.spec import Design, Study
    from gearwright.study import Table
    from gearwright.study.running import Part, Progress, Start

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
    from gearwright.errors import DesignError, Problem
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
        from gearwright.study.running import Cluster

        return Cluster(cluster, tls)
    from gearwright.study.running import local

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
    from gearwright.render.answers.study import StudyAnswer, study_row

    show_rows(command, StudyAnswer(study.name, study.description, None, (), ()), ())

    def print_rows(now: Progress) -> None:
        for row in now.rows:
            show_row(study_row(row))

    return print_rows


@contextmanager
def watched(printed: Callable[[Progress], None] | None) -> Iterator[Callable[[Progress], None]]:
    """Show cases, rate, remaining time and failures on a terminal; elsewhere only what prints rows is told."""
    from rich.progress import BarColumn, TextColumn
    from rich.progress import Progress as Bar

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
