"""Rows of a journal of the former format, one entry each: read as they are, and made blocks when it is continued."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator

from gearwright.sizing import Named
from gearwright.study.answers import Row
from gearwright.study.journal.file import summed


def kept_rows(database: sqlite3.Connection, total: int) -> Iterator[tuple[int, Row | None]]:
    """Yield number and row of every finished case in their order; no row where it is damaged or was edited.

    Args:
        database: Of a journal.
        total: Number of cases.
    """
    reached = -1
    try:
        for entry in database.execute("SELECT * FROM rows ORDER BY number"):
            yield entry[0], _row(entry, total)
            reached = max(reached, min(entry[0], total))
    except sqlite3.DatabaseError:  # the rest of the table is behind what cannot be read: case by case
        for number in range(reached + 1, total):
            yield from _single(database, number, total)


def _single(database: sqlite3.Connection, number: int, total: int) -> Iterator[tuple[int, Row | None]]:
    try:
        entry = database.execute("SELECT * FROM rows WHERE number = ?", (number,)).fetchone()
    except sqlite3.DatabaseError:
        yield number, None
        return
    if entry is not None:
        yield number, _row(entry, total)


def _row(entry: tuple[object, ...], total: int) -> Row | None:
    number, design, inputs, results, problem, _ = entry
    if entry != summed(*entry[:-1]) or number not in range(total):
        return None
    named = {name: Named(*value) for name, value in json.loads(str(results)).items()}
    return Row(str(design), json.loads(str(inputs)), named, str(problem))
