"""The journal of a study: one SQLite file that holds the study, its designs, and every case as soon as it is finished.

Rows are safe once `append` returns: a killed process or a power failure costs what was being computed, nothing else.
Only one runner writes; readers may look at any time. A file on a network drive is no place for it (SQLite's locks).
"""

from __future__ import annotations

import json
import sqlite3
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.sizing import Named
from gearwright.spec import Design, Study, case_count
from gearwright.study.answers import Row
from gearwright.study.running.made_with import made_with
from gearwright.version import __version__

FORMAT = 2
"""Version of the tables below."""
_TABLES = """
CREATE TABLE study (format INTEGER, version TEXT, study TEXT, designs TEXT, origin TEXT, total INTEGER, made TEXT);
CREATE TABLE rows (number INTEGER PRIMARY KEY, design TEXT, inputs TEXT, results TEXT, problem TEXT);
CREATE TABLE runs (run INTEGER PRIMARY KEY, version TEXT, workers INTEGER, started REAL, done INTEGER, seen REAL);
"""


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
    run: int = 0
    """Number of the run that writes."""

    def begin_run(self, workers: int) -> None:
        """Note that a run begins.

        Args:
            workers: Processes that compute.
        """
        entry = (json.dumps(dict(made_with())), workers, time.time(), 0, time.time())
        with _written(self.database):
            found = self.database.execute(
                "INSERT INTO runs (version, workers, started, done, seen) VALUES (?, ?, ?, ?, ?)", entry
            )
        self.run = found.lastrowid or 0

    def append(self, rows: Iterable[tuple[int, Row]]) -> None:
        """Put finished cases on disk, all or none of them.

        Args:
            rows: Number of the case and its row.

        Raises:
            SolveError: If the disk does not take them.
        """
        entries = [_entry(number, row) for number, row in rows]
        with _written(self.database):
            self.database.executemany("INSERT OR IGNORE INTO rows VALUES (?, ?, ?, ?, ?)", entries)
            self.database.execute(
                "UPDATE runs SET done = done + ?, seen = ? WHERE run = ?", (len(entries), time.time(), self.run)
            )

    def finished(self) -> dict[int, bool]:
        """Return number -> whether it failed, of every finished case."""
        return dict(self.database.execute("SELECT number, problem <> '' FROM rows"))

    def rows(self, numbers: Iterable[int]) -> list[Row]:
        """Return rows in the order of their numbers.

        Args:
            numbers: Finished cases.
        """
        wanted = set(numbers)
        return [row for number, row in stored_rows(self.database) if number in wanted]


def begin(path: Path, study: Study, designs: Mapping[str, Design], *, origin: str = "") -> None:
    """Write a new journal.

    Args:
        path: Of a file that is not there yet.
        study: What is to be run.
        designs: Name -> design.
        origin: Folder in which the names of designs were looked up.

    Raises:
        DesignError: If the file is there already.
    """
    try:
        with closing(sqlite3.connect(path)) as database:
            used = _has_tables(database)
        if not used:
            with closing(_connect(path)) as database:
                used = not _write_study(database, study, designs, origin)
    except sqlite3.OperationalError as error:
        raise SolveError(f"the journal {path} cannot be written: {error}; give another place") from None
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


def _has_tables(database: sqlite3.Connection) -> bool:
    return database.execute("SELECT 1 FROM sqlite_master").fetchone() is not None


def in_memory(study: Study, designs: Mapping[str, Design]) -> Journal:
    """Return a journal that is nowhere on disk, for studies that are not to be kept.

    Args:
        study: What is to be run.
        designs: Name -> design.
    """
    database = _connect(Path(":memory:"))
    _write_study(database, study, designs, "")
    return Journal(database)


def _write_study(database: sqlite3.Connection, study: Study, designs: Mapping[str, Design], origin: str) -> bool:
    """Write what a journal begins with, all or nothing; tell whether the database was free for it."""
    texts = {name: _dumped(design) for name, design in designs.items()}
    made = json.dumps(dict(made_with()))
    entry = (FORMAT, __version__, _dumped(study), json.dumps(texts), origin, case_count(study), made)
    with _written(database):
        if _has_tables(database):
            return False
        for statement in _TABLES.split(";"):
            database.execute(statement)
        database.execute("INSERT INTO study VALUES (?, ?, ?, ?, ?, ?, ?)", entry)
    return True


def _dumped(record: Study | Design) -> str:
    """Return a record as JSON in SI, defaults left out."""
    return record.model_dump_json(by_alias=True, exclude_unset=True)


@contextmanager
def opened(path: Path) -> Iterator[Journal]:
    """Hold a journal for writing; the hold ends with the process, however that ends.

    Args:
        path: Of a journal.

    Raises:
        DesignError: If it is no journal, or another runner holds it.
    """
    recorded(path)
    lock = sqlite3.connect(_lock(path), timeout=0.0, isolation_level=None)
    with closing(lock):
        try:
            lock.execute("BEGIN EXCLUSIVE")
        except sqlite3.OperationalError:
            message = "another runner is at this journal; `gearwright status` shows how far it is"
            raise DesignError([Problem("", message)], str(path)) from None
        with closing(_connect(path)) as database:
            yield Journal(database)


def recorded(path: Path) -> Recorded:
    """Return what a journal says of its study.

    Args:
        path: Of a journal.

    Raises:
        DesignError: If it is none, or of a later format.
    """
    with reading(path) as database:
        try:
            found = database.execute("SELECT * FROM study").fetchone()
        except sqlite3.DatabaseError:
            found = None
    if found is None:
        raise DesignError(
            [Problem("", "this is no journal of a study; `gearwright study --journal` writes one")], str(path)
        )
    if found[0] != FORMAT:
        raise DesignError(
            [Problem("", f"its format {found[0]} is not {FORMAT}; gearwright {found[1]} reads it")], str(path)
        )
    study = Study.model_validate_json(found[2])
    designs = {name: Design.model_validate_json(text) for name, text in json.loads(found[3]).items()}
    return Recorded(study, designs, json.loads(found[6]), found[4], found[5])


def status(path: Path) -> Status:
    """Return how far a study has come, also while it runs.

    Args:
        path: Of its journal.

    Raises:
        DesignError: If it is no journal.
    """
    known = recorded(path)
    with reading(path) as database:
        done, failed = database.execute("SELECT COUNT(*), COALESCE(SUM(problem <> ''), 0) FROM rows").fetchone()
        run = database.execute("SELECT started, done, seen FROM runs ORDER BY run DESC LIMIT 1").fetchone()
    rate = run[1] / (run[2] - run[0]) if run and run[2] > run[0] else 0.0
    return Status(known, done, failed, _is_held(path), rate)


def rows_of(path: Path) -> list[Row]:
    """Return every finished row of a journal, in the order of the cases.

    Args:
        path: Of a journal.
    """
    with reading(path) as database:
        return [row for _, row in stored_rows(database)]


def stored_rows(database: sqlite3.Connection) -> Iterator[tuple[int, Row]]:
    """Yield number and row of every finished case, in the order of the cases.

    Args:
        database: Of a journal.
    """
    for number, design, inputs, results, problem in database.execute("SELECT * FROM rows ORDER BY number"):
        found = {name: Named(*each) for name, each in json.loads(results).items()}
        yield number, Row(design, json.loads(inputs), found, problem)


def _entry(number: int, row: Row) -> tuple[int, str, str, str, str]:
    return number, row.design, json.dumps(row.inputs), json.dumps(row.results), row.problem


def _lock(path: Path) -> Path:
    return path.with_name(f"{path.name}-lock")


def _is_held(path: Path) -> bool:
    if not _lock(path).exists():
        return False
    with closing(sqlite3.connect(_lock(path), timeout=0.0, isolation_level=None)) as lock:
        try:
            lock.execute("BEGIN EXCLUSIVE")
        except sqlite3.OperationalError:
            return True
    return False


def _connect(path: Path) -> sqlite3.Connection:
    database = sqlite3.connect(path, isolation_level=None)
    database.execute("PRAGMA journal_mode = WAL")
    database.execute("PRAGMA synchronous = FULL")  # a power failure, too, costs no finished case
    return database


@contextmanager
def reading(path: Path) -> Iterator[sqlite3.Connection]:
    """Hold a journal for reading.

    Args:
        path: Of a journal.

    Raises:
        DesignError: If there is no such file.
    """
    if not path.is_file():
        raise DesignError([Problem("", "there is no such journal; `gearwright study --journal` writes one")], str(path))
    with closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=rw", uri=True)) as database:
        yield database


@contextmanager
def _written(database: sqlite3.Connection) -> Iterator[None]:
    """Make what is written inside one transaction; say in plain words why it failed."""
    try:
        database.execute("BEGIN IMMEDIATE")
        yield
        database.execute("COMMIT")
    except sqlite3.OperationalError as error:
        if database.in_transaction:
            database.execute("ROLLBACK")
        raise SolveError(
            f"the journal cannot be written: {error}. What is in it is safe; free some space and `gearwright resume` it"
        ) from None
