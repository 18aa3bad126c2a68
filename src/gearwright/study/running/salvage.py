"""What a damaged or edited journal has lost, and a sound one made of what it still has."""

from __future__ import annotations

import sqlite3
from contextlib import closing, suppress
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from gearwright.study.answers import Row
from gearwright.study.running.journal_file import ADD_ROW, add_tables, connect, entry_of, kept_rows, reading, written

_BATCH = 1000
"""Rows that are written at once."""
_AGAIN = "The journal is as it was; free some space and `gearwright resume` it"


@dataclass(frozen=True)
class Losses:
    """What has become of a journal."""

    kept: int
    """Finished cases that are as they were written."""
    lost: tuple[int, ...]
    """Numbers of cases that are damaged, were edited, or may have been where nothing can be read."""
    damaged: bool
    """True if the file itself is, also where no case is lost."""


def losses(path: Path, total: int) -> Losses:
    """Return what a journal has lost: every row is read and its checksum compared.

    Args:
        path: Of a journal whose study is whole.
        total: Number of its cases.
    """
    kept, lost = 0, []
    with reading(path) as database:
        for number, row in kept_rows(database, total):
            if row is None:
                lost.append(number)
            else:
                kept += 1
        return Losses(kept, tuple(lost), not _is_sound(database))


def _is_sound(database: sqlite3.Connection) -> bool:
    try:
        return bool(database.execute("PRAGMA quick_check(1)").fetchone() == ("ok",))
    except sqlite3.DatabaseError:
        return False


def salvage(path: Path, total: int) -> None:
    """Put a new file in the place of a damaged one, with every row that is as it was written.

    Args:
        path: Of a journal that this process holds.
        total: Number of its cases.

    Raises:
        SolveError: If the disk does not take it.
    """
    new = path.with_name(f"{path.name}.part")
    _remove(new, *_beside(new))
    try:
        with reading(path) as old, closing(sqlite3.connect(new, isolation_level=None)) as fresh:
            entry = old.execute("SELECT * FROM study").fetchone()
            with written(fresh, advice=_AGAIN):
                add_tables(fresh, entry)
            rows = ((number, row) for number, row in kept_rows(old, total) if row is not None)
            while batch := list(islice(rows, _BATCH)):
                _add(fresh, batch)
        with suppress(sqlite3.DatabaseError), closing(connect(path)) as old:
            old.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        _remove(*_beside(path))
        new.replace(path)
    finally:
        _remove(new, *_beside(new))


def _add(fresh: sqlite3.Connection, batch: list[tuple[int, Row]]) -> None:
    with written(fresh, advice=_AGAIN):
        fresh.executemany(ADD_ROW, [entry_of(number, row) for number, row in batch])


def _beside(path: Path) -> list[Path]:
    """Return the files that SQLite keeps beside one."""
    return [path.with_name(path.name + suffix) for suffix in ("-wal", "-shm", "-journal")]


def _remove(*paths: Path) -> None:
    for path in paths:
        path.unlink(missing_ok=True)
