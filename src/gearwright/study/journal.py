"""Journal of a study: one SQLite file with checksums, its former format, and recovery of damaged files.

What is computed and when it is written is for `running`.
"""

import gc
import json
import sqlite3
import sys
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from functools import cache, cached_property
from hashlib import sha256
from importlib.metadata import version
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from gearwright.base import DesignError, GearwrightError, Problem, SolveError
from gearwright.files import refuse_irregular
from gearwright.sizing import Named
from gearwright.spec import Design, Study, case_count
from gearwright.study.tables import NUMBER, OTHER, REAL, WHOLE, Block, Row, Shape, blocks_of
from gearwright.version import __version__, digest

# ----------------------------------------------------------------------------------------------------------------------
# What results are computed with: gearwright's own files, and the libraries whose rounding reaches the results.
# ----------------------------------------------------------------------------------------------------------------------


LIBRARIES = ("numpy", "scipy", "numba", "llvmlite")
"""Libraries that compute."""


@cache
def made_with() -> Mapping[str, str]:
    """Return what computes here: name -> version, with a digest of every installed file of gearwright.

    The digest notices an edited file under an unchanged version.
    """
    libraries = {name: version(name) for name in LIBRARIES}
    program = f"{__version__}, files {digest(Path(__file__).parents[1])}"
    return {"gearwright": program, "python": f"{sys.version_info.major}.{sys.version_info.minor}", **libraries}


def changes_of(begun: Mapping[str, str], now: Mapping[str, str]) -> list[tuple[str, str, str]]:
    """Return what differs between two sets of versions.

    Args:
        begun: With what a study was begun.
        now: What computes now.

    Returns:
        Name, version then, version now.
    """
    names = dict.fromkeys([*begun, *now])
    pairs = [(name, begun.get(name, "none"), now.get(name, "none")) for name in names]
    return [pair for pair in pairs if pair[1] != pair[2]]


# ----------------------------------------------------------------------------------------------------------------------
# Blocks of rows as they stand in the file of a journal, every row with a checksum of its own.
#
# The checksum follows from the row alone: what rows stand beside it, and who computed them, does not show.
# ----------------------------------------------------------------------------------------------------------------------


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


def kept_rows_of_blocks(database: sqlite3.Connection, total: int) -> Kept:
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


# ----------------------------------------------------------------------------------------------------------------------
# The file of a journal: its tables, its lock, and rows with checksums, so that damage and edits are seen.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Rows of a journal of the former format, one entry each: read as they are, and made blocks when it is continued.
# ----------------------------------------------------------------------------------------------------------------------


def kept_rows_of_former(database: sqlite3.Connection, total: int) -> Iterator[tuple[int, Row | None]]:
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


# ----------------------------------------------------------------------------------------------------------------------
# What a damaged or edited journal has lost, and a sound one made of what it still has.
# ----------------------------------------------------------------------------------------------------------------------


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
        return kept_rows_of_former(database, total)
    return kept_rows_of_blocks(database, total)


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
        fresh.executemany(ADD_BLOCK, [entry_of(block) for block in blocks_of(batch).blocks])


def _beside(path: Path) -> list[Path]:
    """Return the files that SQLite keeps beside one."""
    return [path.with_name(path.name + suffix) for suffix in ("-wal", "-shm", "-journal")]


def _remove(*paths: Path) -> None:
    for path in paths:
        path.unlink(missing_ok=True)


# ----------------------------------------------------------------------------------------------------------------------
# The journal of a study: one SQLite file that holds the study, its designs, and every case as soon as it is finished.
#
# Rows are safe once `append` returns: a killed process or a power failure costs what was being computed, nothing else.
# Every row carries a checksum: what is damaged or was edited is seen, left out and computed again.
# Only one runner writes; readers may look at any time. A file on a network drive is no place for it (SQLite's locks).
# ----------------------------------------------------------------------------------------------------------------------


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
