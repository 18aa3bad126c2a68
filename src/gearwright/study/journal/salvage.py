"""What a damaged or edited journal has lost, and a sound one made of what it still has."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import closing, suppress
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from gearwright.study.answers import Row, blocks_of
from gearwright.study.journal import blocks, former
from gearwright.study.journal.file import (
    ADD_BLOCK,
    FORMAT,
    FORMER,
    add_tables,
    connect,
    reading,
    summed,
    written,
)

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
        return Losses(kept, tuple(sorted(lost)), not _is_sound(database))


def format_of(database: sqlite3.Connection) -> int:
    """Return the format of a journal.

    Args:
        database: Of a journal whose study is whole.
    """
    return int(database.execute("SELECT format FROM study").fetchone()[0])


def kept_rows(database: sqlite3.Connection, total: int) -> Iterator[tuple[int, Row | None]]:
    """Yield number and row of every finished case in any order; no row where it is damaged or was edited.

    Args:
        database: Of a journal whose study is whole.
        total: Number of cases.
    """
    if format_of(database) == FORMER:
        return former.kept_rows(database, total)
    return blocks.kept_rows(database, total)


def _is_sound(database: sqlite3.Connection) -> bool:
    try:
        return bool(database.execute("PRAGMA quick_check(1)").fetchone() == ("ok",))
    except sqlite3.DatabaseError:
        return False


def salvage(path: Path, total: int) -> None:
    """Put a new file in the place of a damaged or former one, with every row that is as it was written.

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
            _, *said, _ = old.execute("SELECT * FROM study").fetchone()
            with written(fresh, advice=_AGAIN):
                add_tables(fresh, summed(FORMAT, *said))
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
        fresh.executemany(ADD_BLOCK, [blocks.entry_of(block) for block in blocks_of(batch).blocks])


def _beside(path: Path) -> list[Path]:
    """Return the files that SQLite keeps beside one."""
    return [path.with_name(path.name + suffix) for suffix in ("-wal", "-shm", "-journal")]


def _remove(*paths: Path) -> None:
    for path in paths:
        path.unlink(missing_ok=True)
