"""The journal of a study: one SQLite file that holds the study, its designs, and every case as soon as it is finished.

Rows are safe once `append` returns: a killed process or a power failure costs what was being computed, nothing else.
Every row carries a checksum: what is damaged or was edited is seen, left out and computed again.
Only one runner writes; readers may look at any time. A file on a network drive is no place for it (SQLite's locks).
"""

from __future__ import annotations

import gc
import json
import sqlite3
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.reading import refuse_irregular
from gearwright.spec import Design, Study, case_count
from gearwright.study.answers import Block, Row, blocks_of
from gearwright.study.journal.blocks import entry_of, finished
from gearwright.study.journal.file import (
    ADD_BLOCK,
    FORMAT,
    FORMER,
    add_tables,
    connect,
    dumped,
    has_tables,
    held,
    is_held,
    reading,
    summed,
    written,
)
from gearwright.study.journal.made_with import made_with
from gearwright.study.journal.salvage import Losses, format_of, kept_rows, losses, salvage
from gearwright.version import __version__

_ELSEWHERE = "Nothing was begun: free some space, or give another place"
_DONE = {
    FORMAT: "SELECT COALESCE(SUM(count), 0), COALESCE(SUM(failed), 0) FROM blocks",
    FORMER: "SELECT COUNT(*), COALESCE(SUM(problem <> ''), 0) FROM rows",
}
"""Finished cases and failed ones."""
_RATE = (
    """SELECT CAST(done AS REAL) / (CAST(seen AS REAL) - CAST(started AS REAL)) FROM runs ORDER BY run DESC LIMIT 1"""
)
"""Cases a second of the last run; nothing where it took no time."""


@dataclass(frozen=True)
class Recorded:
    """What a journal says of its study."""

    study: Study
    """As it was when the journal was begun."""
    designs: Mapping[str, Design]
    """Name -> design, complete, as it was then."""
    made_with: Mapping[str, str]
    """What computed when it was begun: name -> version."""
    origin: str
    """Folder in which the names of designs were looked up."""
    total: int
    """Number of cases."""


@dataclass(frozen=True)
class Status:
    """How far a study has come."""

    recorded: Recorded
    """What the journal says of its study."""
    done: int
    """Finished cases."""
    failed: int
    """Those of them that are a reason instead of results."""
    running: bool
    """True while a runner holds the journal."""
    rate: float
    """Cases a second of the last run [1/s]; 0 where none was finished."""

    @property
    def remaining(self) -> float:
        """Estimated time until all cases are done [s]; infinite without a rate."""
        left = self.recorded.total - self.done
        return left / self.rate if self.rate else (float("inf") if left else 0.0)


@dataclass
class Journal:
    """An open journal that this process writes."""

    database: sqlite3.Connection
    total: int
    """Number of cases."""
    run: int = 0
    """Number of the run that writes."""

    def begin_run(self, workers: int) -> None:
        """Note that a run begins.

        Args:
            workers: Processes that compute.
        """
        entry = (json.dumps(dict(made_with())), workers, time.time(), 0, time.time())
        with written(self.database):
            inserted = self.database.execute(
                "INSERT INTO runs (version, workers, started, done, seen) VALUES (?, ?, ?, ?, ?)", entry
            )
        self.run = inserted.lastrowid or 0

    def append(self, rows: Iterable[tuple[int, Row]]) -> None:
        """Put finished cases on disk, all or none of them.

        Args:
            rows: Number of the case and its row.

        Raises:
            SolveError: If the disk does not take them.
        """
        fresh = [block for block in map(self._fresh, blocks_of(rows).blocks) if len(block)]
        entries, count = [entry_of(block) for block in fresh], sum(map(len, fresh))
        with written(self.database):
            self.database.executemany(ADD_BLOCK, entries)
            self.database.execute(
                "UPDATE runs SET done = done + ?, seen = ? WHERE run = ?", (count, time.time(), self.run)
            )
        self.kept.update(number for block in fresh for number in block.numbers)

    def _fresh(self, block: Block) -> Block:
        """Return those rows of a block whose cases are not kept yet."""
        known = np.array([number in self.kept for number in block.numbers])
        return block.where(~known) if known.any() else block

    @cached_property
    def kept(self) -> set[int]:
        """Numbers of the finished cases."""
        return set(self.finished())

    def finished(self) -> dict[int, bool]:
        """Return number -> whether it failed, of every finished case."""
        return dict(finished(self.database))

    def rows(self, numbers: Iterable[int]) -> list[Row]:
        """Return rows in the order of their numbers.

        Args:
            numbers: Finished cases.
        """
        with _uncollected():
            known = {number: row for number, row in kept_rows(self.database, self.total) if row is not None}
        return [known[number] for number in sorted(numbers) if number in known]


@contextmanager
def _uncollected() -> Iterator[None]:
    """Let the collector wait while much is made that is no garbage: to look at it again and again takes longer."""
    waits = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if waits:
            gc.enable()


def begin(path: Path, study: Study, designs: Mapping[str, Design], *, origin: str = "") -> None:
    """Write a new journal.

    Args:
        path: Of a file that is not there yet.
        study: What is to be run.
        designs: Name -> design.
        origin: Folder in which the names of designs were looked up.

    Raises:
        DesignError: If the file is there already.
        SolveError: If it cannot be written.
    """
    if path.exists():
        refuse_irregular(path)
    try:
        with closing(sqlite3.connect(path)) as database:
            used = has_tables(database)
        if not used:
            with closing(connect(path)) as database:
                used = not _write_study(database, study, designs, origin)
    except sqlite3.OperationalError as error:
        raise SolveError(f"the journal {path} cannot be written: {error}. {_ELSEWHERE}") from None
    except sqlite3.DatabaseError:
        used = True
    if used:
        raise DesignError([Problem("", _taken(path, study))], str(path))


def _taken(path: Path, study: Study) -> str:
    """Return why a new journal cannot have the name of a file that is there."""
    try:
        known = recorded(path)
    except DesignError:
        return "there is another file of this name; give the journal another one"
    if known.study != study:
        return f"this is the journal of another study, {known.study.name!r}; give this one another name"
    return "there is a journal of this study already; `gearwright resume` continues it, or give another name"


def in_memory(study: Study, designs: Mapping[str, Design]) -> Journal:
    """Return a journal that is nowhere on disk, for studies that are not to be kept.

    Args:
        study: What is to be run.
        designs: Name -> design.
    """
    database = connect(Path(":memory:"))
    _write_study(database, study, designs, "")
    return Journal(database, case_count(study))


def _write_study(database: sqlite3.Connection, study: Study, designs: Mapping[str, Design], origin: str) -> bool:
    """Write what a journal begins with, all or nothing; tell whether the database was free for it."""
    texts = {name: dumped(design) for name, design in designs.items()}
    made = json.dumps(dict(made_with()))
    total = case_count(study)
    entry = summed(FORMAT, __version__, dumped(study), json.dumps(texts), origin, total, made)
    with written(database, advice=_ELSEWHERE):
        if has_tables(database):
            return False
        add_tables(database, entry)
    return True


@contextmanager
def opened(path: Path) -> Iterator[Journal]:
    """Hold a journal for writing, made sound first; the hold ends with the process, however that ends.

    Args:
        path: Of a journal.

    Raises:
        DesignError: If it is no journal, or another runner holds it.
        SolveError: If the disk does not take what is written.
    """
    total = recorded(path).total
    with held(path):
        known = losses(path, total)
        if known.lost or known.damaged or _is_former(path):
            salvage(path, total)
        with closing(connect(path)) as database:
            yield Journal(database, total)


def _is_former(path: Path) -> bool:
    with reading(path) as database:
        return format_of(database) == FORMER


def recorded(path: Path) -> Recorded:
    """Return what a journal says of its study.

    Args:
        path: Of a journal.

    Raises:
        DesignError: If it is none, or of a later format.
    """
    with reading(path) as database:
        entry = database.execute("SELECT * FROM study").fetchone()
    if entry is not None and entry[0] not in (FORMAT, FORMER):
        message = f"its format is {entry[0]}, not {FORMAT}; continue with the gearwright that began it, or begin anew"
        raise DesignError([Problem("", message)], str(path))
    if entry is None or entry != summed(*entry[:-1]):
        raise DesignError(
            [Problem("", "what it says of its study is damaged or was edited; begin a new one")], str(path)
        )
    _, _, study, designs, origin, total, made, _ = entry
    try:
        read = {name: Design.model_validate_json(text) for name, text in json.loads(designs).items()}
        return Recorded(Study.model_validate_json(study), read, json.loads(made), origin, total)
    except ValueError:
        begun = json.loads(made)["gearwright"]
        message = f"its study was written by another gearwright, {begun}; read it with that one, or begin a new one"
        raise DesignError([Problem("", message)], str(path)) from None


def status(path: Path) -> Status:
    """Return how far a study has come, also while it runs.

    Args:
        path: Of its journal.

    Raises:
        DesignError: If it is no journal.
    """
    known = recorded(path)
    with reading(path) as database:
        done, failed = database.execute(_DONE[format_of(database)]).fetchone()
        last = database.execute(_RATE).fetchone()
    return Status(known, done, failed, is_held(path), last[0] or 0.0 if last else 0.0)


def verify(path: Path) -> Losses:
    """Return what a journal has lost: every checksum is compared; also while it is written.

    Args:
        path: Of a journal.

    Raises:
        DesignError: If it is no journal, or what it says of its study is lost.
    """
    return losses(path, recorded(path).total)


def rows_of(path: Path) -> list[Row]:
    """Return the finished rows of a journal that are as they were written, in the order of the cases.

    Args:
        path: Of a journal.
    """
    total = recorded(path).total
    with reading(path) as database:
        known = {number: row for number, row in kept_rows(database, total) if row is not None}
    return [known[number] for number in sorted(known)]
