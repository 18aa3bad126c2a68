"""Blocks of rows as they stand in the file of a journal, every row with a checksum of its own.

The checksum follows from the row alone: what rows stand beside it, and who computed them, does not show.
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator, Sequence
from hashlib import sha256
from typing import Any

import numpy as np

from gearwright.study.answers import NUMBER, OTHER, REAL, WHOLE, Block, Row, Shape

_SUM = 8
"""Of a checksum [bytes]."""
Kept = Iterator[tuple[int, Row | None]]


def entry_of(block: Block) -> tuple[object, ...]:
    """Return a block as it stands in the file.

    Args:
        block: Of rows as they were computed.
    """
    shape, records = json.dumps(block.shape), block.records.tobytes()
    sums = b"".join(_sums(shape, records, block.texts, len(block)))
    texts = json.dumps(block.texts) if block.texts else ""
    return *_told(block), shape, sums, records, texts


def _sums(shape: str, records: bytes, texts: Sequence[Sequence[Any]], count: int) -> Iterator[bytes]:
    """Yield the checksum of every row."""
    start, width = sha256(shape.encode()), len(records) // count
    for k in range(count):
        row = start.copy()
        row.update(records[k * width : (k + 1) * width])
        if texts:
            row.update(json.dumps(texts[k]).encode())
        yield row.digest()[:_SUM]


def kept_rows(database: sqlite3.Connection, total: int) -> Kept:
    """Yield number and row of every finished case; no row where it is damaged, was edited, or may have been there.

    Args:
        database: Of a journal.
        total: Number of cases.
    """
    seen, lost = bytearray(total), dict[int, None]()
    for span, rows in _blocks(database, total):
        lost |= dict.fromkeys(span)
        for number, row in rows:
            if row is None or number not in range(total):
                lost[number] = None
            elif not seen[number]:
                seen[number] = True
                yield number, row
    yield from ((number, None) for number in lost if number not in range(total) or not seen[number])


def _blocks(database: sqlite3.Connection, total: int) -> Iterator[tuple[range, Kept]]:
    """Yield the cases of every block of which no more is known, and its rows."""
    reached, unknown = 0, False
    try:
        for entry in database.execute("SELECT * FROM blocks ORDER BY block"):
            yield _read(entry, total)
            reached = int(entry[0])
    except sqlite3.DatabaseError:  # the rest of the table is behind what cannot be read: block by block
        for block in range(reached + 1, total + 1):
            try:
                entry = database.execute("SELECT * FROM blocks WHERE block = ?", (block,)).fetchone()
            except sqlite3.DatabaseError:
                span = _span(database, block, total)
                unknown = unknown or span is None
                yield span or range(0), iter(())
                continue
            if entry is not None:
                yield _read(entry, total)
    if unknown:
        yield range(total), iter(())


def _span(database: sqlite3.Connection, block: int, total: int) -> range | None:
    """Return the cases that a block can have held whose rows cannot be read; None where nobody knows."""
    try:
        entry = database.execute("SELECT least, most FROM blocks WHERE block = ?", (block,)).fetchone()
    except sqlite3.DatabaseError:
        return None
    return _cases(entry[0], entry[1], total) if entry else None


def _cases(least: object, most: object, total: int) -> range:
    if isinstance(least, int) and isinstance(most, int):
        return range(max(least, 0), min(most + 1, total))
    return range(total)


def _read(entry: Sequence[Any], total: int) -> tuple[range, Kept]:
    """Return the rows of a block; where nothing can be told apart, the cases that it can have held."""
    _, least, most, count, failed, shape, sums, records, texts = entry
    try:
        block = _block(shape, records, texts)
        if (least, most, count, failed) != _told(block) or len(sums) != _SUM * len(block):
            return range(0), ((number, None) for number in block.numbers)
        found = _sums(shape, records, block.texts, len(block))
        good = [sums[k * _SUM : (k + 1) * _SUM] == own for k, own in enumerate(found)]
    except (ValueError, TypeError, LookupError, AttributeError, RecursionError):
        return _cases(least, most, total), iter(())
    return range(0), _rows(block, good)


def _block(shape: str, records: bytes, texts: str) -> Block:
    """Return a block as it stands in the file.

    Raises:
        ValueError: If it is none.
    """
    design, inputs, results, failed = json.loads(shape)
    read = Shape(design, tuple(map(tuple, inputs)), tuple(map(tuple, results)), failed)
    others = json.loads(texts) if texts else ()
    if not records or not set(read.kinds) <= {REAL, WHOLE, OTHER}:
        raise ValueError("no block")
    rows, count = np.frombuffer(records, dtype=read.record), read.kinds.count(OTHER)
    if [len(row) for row in others] != ([count] * len(rows) if count else []):
        raise ValueError("no block")
    return Block(read, rows, others)


def _told(block: Block) -> tuple[int, int, int, int]:
    """Return what the file says of a block beside its rows: least and largest case, rows, and failed ones of them."""
    numbers = block.records[NUMBER]
    return int(numbers.min()), int(numbers.max()), len(block), len(block) if block.shape.failed else 0


def _rows(block: Block, good: Sequence[bool]) -> Kept:
    """Yield the rows of a block; none in the place of one that is not as it was written."""
    rows = iter(block.where(np.array(good)))
    for number, sound in zip(block.numbers, good, strict=True):
        yield next(rows) if sound else (number, None)


def finished(database: sqlite3.Connection) -> Iterator[tuple[int, bool]]:
    """Yield number of every finished case, and whether it failed.

    Args:
        database: Of a journal that is whole.
    """
    for shape, records, texts in database.execute("SELECT shape, records, texts FROM blocks"):
        block = _block(shape, records, texts)
        yield from ((number, block.shape.failed) for number in block.numbers)
