"""Run a study of any size: cases to workers, finished ones to the journal; continue where it stopped."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import AbstractContextManager, closing
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from gearwright.errors import Problem, SolveError, refuse
from gearwright.spec import Design, Study, case_count
from gearwright.study.answers import Blocks, Row, Table, blocks_of
from gearwright.study.cases import Case, fixed, refuse_unknown_paths
from gearwright.study.journal.journal import Journal, Recorded, begin, in_memory, opened, recorded
from gearwright.study.journal.made_with import changes_of, made_with
from gearwright.study.running.parts import WHOLE, Part, refuse_part
from gearwright.study.running.run import batches, refuse_search, table_of
from gearwright.study.running.workers import Compute, local


@dataclass(frozen=True)
class Progress:
    """How far a run is."""

    done: int
    """Finished cases, those of earlier runs included."""
    total: int
    """All cases."""
    failed: int
    """Finished cases that are a reason instead of results."""
    rate: float
    """Cases a second since this run began [1/s]."""
    finished: Iterable[tuple[int, Row]] = ()
    """Cases that have been finished since this was told last; at first those of earlier runs."""

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """Their rows."""
        return tuple(row for _, row in self.finished)

    @property
    def remaining(self) -> float:
        """Estimated time until all are done [s]."""
        return (self.total - self.done) / self.rate if self.rate else float("inf")


Start = Callable[[Study, Mapping[str, Design], int], AbstractContextManager[Compute]]
"""What holds workers for a study: `local`, or a cluster."""
Watch = Callable[[Progress], None]


def run_study(
    study: Study, designs: Mapping[str, Design], *, workers: int = 0, journal: Path | None = None, origin: str = "",
    watch: Watch | None = None, start: Start = local, part: Part = WHOLE,
) -> Table:  # fmt: skip
    """Return the table of a study; the same for one seed, bit for bit, whatever computes it.

    Args:
        study: Axes, method and results.
        designs: Name -> design.
        workers: Processes that compute; 0 computes in this one.
        journal: File that keeps every finished case at once, for `resume`; left out: nothing is kept.
        origin: Folder in which the names of designs were looked up.
        watch: Called with the progress each time that cases are finished.
        start: What holds workers; left out: processes of this machine.
        part: Of the study, for several machines; left out: all of it. `merge` makes the journals of parts one.

    Raises:
        DesignError: If paths do not exist, cases are too many, all of them fail, or the journal is there already.
        SolveError: If the journal cannot be written, or no worker starts.
    """
    refuse_search(study)
    case_count(study)
    refuse_part(study, part)
    refuse_unknown_paths(study, designs)
    if journal is None:
        book = in_memory(study, designs)
        with closing(book.database), start(study, fixed(study, designs), workers) as compute:
            return _run(book, study, workers, watch, compute, part)
    begin(journal, study, designs, origin=origin)
    with opened(journal) as book, start(study, fixed(study, designs), workers) as compute:
        return _run(book, study, workers, watch, compute, part)


def resume(
    journal: Path, *, workers: int = 0, designs: Mapping[str, Design] | None = None, anyway: bool = False,
    watch: Watch | None = None, start: Start = local, part: Part = WHOLE,
) -> Table:  # fmt: skip
    """Return the table of a study that was stopped, after computing what is missing, from the journal alone.

    Args:
        journal: Its file.
        workers: Processes that compute; 0 computes in this one.
        designs: The designs as they are now, to compare; left out: not compared.
        anyway: Continue with the designs in the journal even if they, or what computes, have changed since.
        watch: Called with the progress each time that cases are finished.
        start: What holds workers; left out: processes of this machine.
        part: Of the study that is computed; left out: all that is missing.

    Raises:
        DesignError: If it is no journal, another runner is at it, or designs or versions have changed.
        SolveError: If the journal cannot be written, or no worker starts.
    """
    known = recorded(journal)
    refuse_search(known.study)
    refuse_part(known.study, part)
    if not anyway:
        refuse_changes(journal, known, designs or {})
    with opened(journal) as book, start(known.study, fixed(known.study, known.designs), workers) as compute:
        return _run(book, known.study, workers, watch, compute, part)


def refuse_changes(journal: Path, known: Recorded, designs: Mapping[str, Design]) -> None:
    """Raise if a study would be continued with anything but what it was begun with.

    Args:
        journal: Its file.
        known: What it says.
        designs: The designs as they are now.

    Raises:
        DesignError: With what has changed.
    """
    fix = "begin a new journal, or continue --anyway with the designs in the journal"
    problems = [
        Problem(f"designs.{name}", f"has changed since the study was begun; {fix}")
        for name, design in designs.items()
        if design != known.designs[name]
    ]
    problems += [
        Problem(name, f"the study was begun with {begun}, this is {now}; results may differ: {fix}")
        for name, begun, now in changes_of(known.made_with, made_with())
    ]
    refuse(problems, str(journal))


def _run(book: Journal, study: Study, workers: int, watch: Watch | None, compute: Compute, part: Part) -> Table:
    """Compute what the journal lacks of a part, batch after batch."""
    own = part.cases(case_count(study))
    done = {number: failed for number, failed in book.finished().items() if number in own}
    meter = _Meter(len(own), len(done), sum(done.values()), watch)
    searches = study.searches
    known = dict(zip(sorted(done), book.rows(done), strict=True)) if done and (searches or watch is not None) else {}
    if watch is not None and done:
        watch(Progress(len(done), meter.total, meter.failed, 0.0, tuple(known.items())))
    known = known if searches else {}
    book.begin_run(workers)
    for batch, answer in batches(study):
        wanted: list[int] = []
        missing = _missing((case for case in batch if case.number in own), done, wanted)
        for finished in compute(missing, meter.total - len(done)):
            together = blocks_of(finished)
            book.append(together)
            meter.count(together)
            if searches:
                known.update(together)
        answer([known[number] for number in wanted if number in known])
    rows = book.rows(own)
    if len(rows) < meter.total:
        raise SolveError(
            f"{meter.total - len(rows)} of {meter.total} cases were not computed; `gearwright resume` does"
        )
    return table_of(study, rows)


def _missing(batch: Iterator[Case], done: Mapping[int, bool], wanted: list[int]) -> Iterator[Case]:
    for case in batch:
        wanted.append(case.number)
        if case.number not in done:
            yield case


class _Meter:
    """Counts finished cases and tells who watches."""

    def __init__(self, total: int, done: int, failed: int, watch: Watch | None) -> None:
        self.total, self.earlier, self.done, self.failed, self.watch = total, done, done, failed, watch
        self.start = time.monotonic()

    def count(self, finished: Blocks) -> None:
        self.done += len(finished)
        self.failed += finished.failed
        if self.watch is not None:
            elapsed = time.monotonic() - self.start
            rate = (self.done - self.earlier) / elapsed if elapsed > 0.0 else 0.0
            self.watch(Progress(self.done, self.total, self.failed, rate, finished))
