"""The file of a journal: its tables, its lock, and rows with checksums, so that damage and edits are seen."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from hashlib import sha256
from pathlib import Path

from gearwright.errors import DesignError, GearwrightError, Problem, SolveError
from gearwright.reading import refuse_irregular
from gearwright.spec import Design, Study

FORMAT, FORMER = 5, 4
"""Version of the tables below; the one before it, which can be read."""
TABLES = """
CREATE TABLE study (format INTEGER, version TEXT, study TEXT, designs TEXT, origin TEXT, total INTEGER, made TEXT,
                    sum TEXT);
CREATE TABLE blocks (block INTEGER PRIMARY KEY, least INTEGER, most INTEGER, count INTEGER, failed INTEGER, shape TEXT,
                     sums BLOB, records BLOB, texts TEXT);
CREATE TABLE runs (run INTEGER PRIMARY KEY, version TEXT, workers INTEGER, started REAL, done INTEGER, seen REAL);
"""
ADD_STUDY = "INSERT INTO study VALUES (?, ?, ?, ?, ?, ?, ?, ?)"
ADD_BLOCK = (
    "INSERT INTO blocks (least, most, count, failed, shape, sums, records, texts) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"
)
SAFE = "What is in it is safe; free some space and `gearwright resume` it"
NONE = (
    "this is no journal of a study, or a damaged one; `gearwright study --journal` writes one,"
    " `gearwright status --verify` names what one has lost"
)
_NO_JOURNAL = (sqlite3.SQLITE_ERROR, sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_NOTADB, sqlite3.SQLITE_MISMATCH)
"""What SQLite says of other files, and of damaged ones; all else is wrong with the place."""
_PRIMARY = 0xFF
"""Part of SQLite's codes that says the kind of an error."""


def summed(*values: object) -> tuple[object, ...]:
    """Return the values of an entry with their checksum behind them.

    Args:
        values: In the order of the table.
    """
    return *values, sha256(repr(values).encode()).hexdigest()[:16]


def dumped(record: Study | Design) -> str:
    """Return a record as JSON in SI, defaults left out.

    Args:
        record: Of a study.
    """
    return record.model_dump_json(by_alias=True, exclude_unset=True)


def connect(path: Path) -> sqlite3.Connection:
    """Return a connection that writes.

    Args:
        path: Of a journal, or of a file that is not there yet.
    """
    database = sqlite3.connect(path, isolation_level=None)
    database.execute("PRAGMA journal_mode = WAL")
    database.execute("PRAGMA synchronous = FULL")  # a power failure, too, costs no finished case
    return database


def has_tables(database: sqlite3.Connection) -> bool:
    """Tell whether a database is anything yet.

    Args:
        database: Of any kind.
    """
    return database.execute("SELECT 1 FROM sqlite_master").fetchone() is not None


def add_tables(database: sqlite3.Connection, entry: tuple[object, ...]) -> None:
    """Write what a journal begins with.

    Args:
        database: Empty.
        entry: Of the study, with its checksum.
    """
    for statement in TABLES.split(";"):
        database.execute(statement)
    database.execute(ADD_STUDY, entry)


@contextmanager
def reading(path: Path) -> Iterator[sqlite3.Connection]:
    """Hold a journal for reading; what SQLite says meanwhile becomes a sentence.

    Args:
        path: Of a journal.

    Raises:
        DesignError: If there is no such file, or it is none of a journal.
        SolveError: If it cannot be read where it is.
    """
    refuse_irregular(path, missing="there is no such journal; `gearwright study --journal` writes one")
    with closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=rw", uri=True)) as database:
        try:
            yield database
        except sqlite3.DatabaseError as error:
            raise _unread(path, error) from None


def _unread(path: Path, error: sqlite3.DatabaseError) -> GearwrightError:
    if _kind(error) in _NO_JOURNAL:
        return DesignError([Problem("", NONE)], str(path))
    return SolveError(
        f"the journal {path} cannot be read: {error}; SQLite keeps two files beside it, for which its folder must be"
        " writable and not full"
    )


@contextmanager
def written(database: sqlite3.Connection, *, advice: str = SAFE) -> Iterator[None]:
    """Make what is written inside one transaction; say in plain words why it failed.

    Args:
        database: Of a journal.
        advice: What to do if it fails.

    Raises:
        SolveError: If the disk does not take it.
    """
    try:
        database.execute("BEGIN IMMEDIATE")
        yield
        database.execute("COMMIT")
    except sqlite3.DatabaseError as error:
        if database.in_transaction:
            database.execute("ROLLBACK")
        raise SolveError(f"the journal cannot be written: {error}. {advice}") from None


@contextmanager
def held(path: Path) -> Iterator[None]:
    """Hold the lock of a journal; the hold ends with the process, however that ends.

    Args:
        path: Of the journal.

    Raises:
        DesignError: If another runner holds it, or its lock is no lock.
        SolveError: If the disk does not take the lock.
    """
    lock = sqlite3.connect(_lock(path), timeout=0.0, isolation_level=None)
    with closing(lock):
        try:
            lock.execute("BEGIN EXCLUSIVE")
        except sqlite3.DatabaseError as error:
            raise _unlocked(path, error) from None
        yield


def _unlocked(path: Path, error: sqlite3.DatabaseError) -> GearwrightError:
    if _kind(error) == sqlite3.SQLITE_BUSY:
        message = "another runner is at this journal; `gearwright status` shows how far it is"
        return DesignError([Problem("", message)], str(path))
    if _kind(error) in _NO_JOURNAL:
        return DesignError(
            [Problem("", "another file has the name of the journal's lock; remove it")], str(_lock(path))
        )
    return SolveError(f"the lock {_lock(path)} of the journal cannot be written: {error}. {SAFE}")


def is_held(path: Path) -> bool:
    """Tell whether a runner holds a journal.

    Args:
        path: Of the journal.
    """
    if not _lock(path).exists():
        return False
    with closing(sqlite3.connect(_lock(path), timeout=0.0, isolation_level=None)) as lock:
        try:
            lock.execute("BEGIN EXCLUSIVE")
        except sqlite3.DatabaseError as error:
            return _kind(error) == sqlite3.SQLITE_BUSY
    return False


def _kind(error: sqlite3.DatabaseError) -> int:
    """Return the kind of an error; text that is none has no code of its own."""
    return int(getattr(error, "sqlite_errorcode", sqlite3.SQLITE_CORRUPT)) & _PRIMARY


def _lock(path: Path) -> Path:
    return path.with_name(f"{path.name}-lock")
