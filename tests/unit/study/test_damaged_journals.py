"""Journals that were damaged or edited: what is lost is named, computed again, and nothing else is."""

from __future__ import annotations

import json
import random
import shutil
import sqlite3
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from hashlib import sha256
from pathlib import Path

import pytest
from fault_studies import DESIGNS, study_of
from typer.testing import CliRunner

from gearwright.cli import app
from gearwright.errors import DesignError, GearwrightError
from gearwright.study import run
from gearwright.study.journal import begin, opened, recorded, rows_of, status, verify
from gearwright.study.running import resume, run_study
from gearwright.study.tables import Row

COUNT = 60
TOGETHER = range(48, COUNT)
ALONE, AMONG = 17, 51
"""A case that stands in a block of its own, and one among others; both have results."""


@pytest.fixture(scope="module")
def expected():
    return run(study_of(COUNT), DESIGNS)


@pytest.fixture(scope="module")
def whole(tmp_path_factory, expected) -> Path:
    """Blocks of one case each, as few cases have them, and of those that were computed together, as many have them."""
    path = tmp_path_factory.mktemp("whole") / "j"
    assert run_study(study_of(COUNT), DESIGNS, journal=path) == expected
    with edited(path) as database:
        database.execute(f"DELETE FROM blocks WHERE block > {TOGETHER.start}")
    with opened(path) as book:
        book.append([(number, expected.rows[number]) for number in TOGETHER])
    return path


@pytest.fixture
def journal(tmp_path: Path, whole: Path) -> Path:
    return Path(shutil.copy(whole, tmp_path / "j"))


@pytest.fixture
def former(tmp_path: Path, whole_former: Path) -> Path:
    return Path(shutil.copy(whole_former, tmp_path / "former"))


@pytest.fixture(scope="module")
def whole_former(tmp_path_factory, whole: Path, expected) -> Path:
    """The same study in the former format: an entry for each row, as gearwright 0.1 wrote them."""
    path = tmp_path_factory.mktemp("former") / "former"
    with edited(whole) as database:
        _, *said, _ = database.execute("SELECT * FROM study").fetchone()
    with edited(path) as database:
        database.execute(
            "CREATE TABLE study (format INTEGER, version TEXT, study TEXT, designs TEXT, origin TEXT, total INTEGER,"
            " made TEXT, sum TEXT)"
        )
        database.execute(
            "CREATE TABLE rows (number INTEGER PRIMARY KEY, design TEXT, inputs TEXT, results TEXT, problem TEXT,"
            " sum TEXT)"
        )
        database.execute(
            "CREATE TABLE runs (run INTEGER PRIMARY KEY, version TEXT, workers INTEGER, started REAL, done INTEGER,"
            " seen REAL)"
        )
        database.execute("INSERT INTO study VALUES (?, ?, ?, ?, ?, ?, ?, ?)", summed(4, *said))
        rows = [summed(number, *former_entry(row)) for number, row in enumerate(expected.rows)]
        database.execute("BEGIN")
        database.executemany("INSERT INTO rows VALUES (?, ?, ?, ?, ?, ?)", rows)
        database.execute("COMMIT")
    return path


def former_entry(row: Row) -> tuple[str, ...]:
    return row.design, json.dumps(row.inputs), json.dumps(row.results), row.problem


def summed(*values: object) -> tuple[object, ...]:
    return *values, sha256(repr(values).encode()).hexdigest()[:16]


@contextmanager
def edited(journal: Path) -> Iterator[sqlite3.Connection]:
    with closing(sqlite3.connect(journal, isolation_level=None)) as database:
        yield database


def edit_block(journal: Path, number: int, column: str, edit: Callable) -> list[int]:
    """Edit a column of the block of a case; return the cases of the block. A column of bytes is edited at its row."""
    with edited(journal) as database:
        for block, shape, records in database.execute("SELECT block, shape, records FROM blocks").fetchall():
            _, inputs, results, _ = json.loads(shape)
            width = 8 * (1 + sum(kind != "" for *_, kind in inputs + results))
            numbers = [int.from_bytes(records[k : k + 8], "little", signed=True) for k in range(0, len(records), width)]
            if number in numbers:
                (value,) = database.execute(f"SELECT {column} FROM blocks WHERE block = ?", (block,)).fetchone()
                changed = edit(value, numbers.index(number))
                database.execute(f"UPDATE blocks SET {column} = ? WHERE block = ?", (changed, block))
                return numbers
    raise AssertionError("no such case")


def flipped(size: int, at: int) -> Callable[[bytes, int], bytes]:
    """Return what flips a bit of one row's bytes."""

    def flip(value: bytes, row: int) -> bytes:
        place = row * size + at
        return value[:place] + bytes([value[place] ^ 1]) + value[place + 1 :]

    return flip


RECORD = 8 * 5
"""Bytes of a row of two numbers and two results with the number of its case."""


def test_a_whole_journal_has_lost_nothing(journal: Path) -> None:
    found = verify(journal)
    assert (found.kept, found.lost, found.damaged) == (COUNT, (), False)


@pytest.mark.parametrize("number", [ALONE, AMONG])
@pytest.mark.parametrize(
    ("column", "edit", "row_alone"),
    [
        ("records", flipped(RECORD, 8), True),
        ("records", flipped(RECORD, RECORD - 1), True),
        ("sums", flipped(8, 3), True),
        ("records", lambda value, row: None, False),
        ("records", lambda value, row: value[:-1], False),
        ("records", lambda value, row: value.hex(), False),
        ("sums", lambda value, row: value[:-8], False),
        ("shape", lambda value, row: value.replace("in-line-h2", "other"), False),
        ("shape", lambda value, row: value.replace('"mass"', '"gear_mass"', 1), False),
        ("shape", lambda value, row: "none", False),
        ("shape", lambda value, row: None, False),
        ("texts", lambda value, row: '[["made up"]]', False),
        ("count", lambda value, row: value + 1, False),
        ("failed", lambda value, row: 1 - value, False),
        ("least", lambda value, row: value - 1, False),
    ],
)
def test_an_edited_row_is_named_and_computed_again(journal, number, column, edit, row_alone, expected) -> None:
    block = edit_block(journal, number, column, edit)
    lost = verify(journal).lost
    assert lost == ((number,) if row_alone else tuple(sorted(block))) or (column == "least" and set(block) <= set(lost))
    status(journal)
    assert resume(journal, designs=DESIGNS) == expected
    assert verify(journal).lost == () and verify(journal).kept == COUNT


@pytest.mark.parametrize(
    "edit",
    [
        "UPDATE blocks SET texts = CAST(x'ff' AS TEXT) WHERE block = 9",
        "DELETE FROM blocks WHERE block = 9",
        "DELETE FROM runs",
        "UPDATE runs SET done = 'x', seen = NULL, started = 'y'",
    ],
)
def test_an_edited_file_is_mended(journal: Path, edit: str, expected) -> None:
    with edited(journal) as database:
        database.execute(edit)
    verify(journal)
    status(journal)
    assert resume(journal, designs=DESIGNS) == expected
    assert verify(journal).lost == () and verify(journal).kept == COUNT


def test_the_number_of_a_case_that_was_edited_is_named(journal: Path, expected) -> None:
    edit_block(journal, AMONG, "records", lambda value, row: value.replace(AMONG.to_bytes(8, "little"), b"\xff" * 8, 1))
    assert -1 in verify(journal).lost
    assert resume(journal, designs=DESIGNS) == expected


def test_a_former_journal_is_read_as_it_is_and_goes_on_in_blocks(former: Path, expected) -> None:
    assert (verify(former).kept, verify(former).lost) == (COUNT, ())
    assert rows_of(former) == list(expected.rows)
    with edited(former) as database:
        database.execute("DELETE FROM rows WHERE number > 40")
    assert status(former).done == 41
    assert resume(former, designs=DESIGNS) == expected
    with edited(former) as database:
        assert database.execute("SELECT format, (SELECT SUM(count) FROM blocks) FROM study").fetchone() == (5, COUNT)


def test_the_checksum_of_a_row_follows_from_the_row_alone(whole: Path, tmp_path: Path) -> None:
    """Computed in another order, in blocks of other rows and by another process, every row has the same bytes."""
    begin(tmp_path / "j", study_of(COUNT), DESIGNS)
    order = random.Random(1).sample(range(COUNT), COUNT)
    rows = rows_of(whole)
    with opened(tmp_path / "j") as book:
        for first in range(0, COUNT, 25):
            book.append([(number, rows[number]) for number in order[first : first + 25]])
    assert sums_of(tmp_path / "j") == sums_of(whole)


def sums_of(journal: Path) -> dict[bytes, bytes]:
    found = {}
    with edited(journal) as database:
        for count, sums, records in database.execute("SELECT count, sums, records FROM blocks"):
            width = len(records) // count
            for k in range(count):
                found[records[k * width : (k + 1) * width]] = sums[8 * k : 8 * k + 8]
    return found


@pytest.mark.parametrize(
    ("edit", "lost"),
    [
        ("UPDATE rows SET results = replace(results, '0', '1') WHERE number = 17", (17,)),
        ("UPDATE rows SET results = 'none' WHERE number = 17", (17,)),
        ("UPDATE rows SET results = NULL WHERE number = 17", (17,)),
        ("UPDATE rows SET results = x'ff00' WHERE number = 17", (17,)),
        ("UPDATE rows SET results = CAST(x'ff' AS TEXT) WHERE number = 17", (17,)),
        ("UPDATE rows SET inputs = '{}' WHERE number = 17", (17,)),
        ("UPDATE rows SET design = 'other' WHERE number = 17", (17,)),
        ("UPDATE rows SET problem = 'made up' WHERE number IN (3, 17)", (3, 17)),
        ("UPDATE rows SET sum = 'made up' WHERE number = 17", (17,)),
        ("UPDATE rows SET number = 999 WHERE number = 17", (999,)),
        ("UPDATE rows SET number = -5 WHERE number = 17", (-5,)),
        ("DELETE FROM rows WHERE number = 17", ()),
        ("DELETE FROM runs", ()),
        ("UPDATE runs SET done = 'x', seen = NULL, started = 'y'", ()),
    ],
)
def test_an_edited_row_of_a_former_journal_is_named_and_computed_again(
    former: Path, edit: str, lost: tuple[int, ...], expected
) -> None:
    with edited(former) as database:
        database.execute(edit)
    assert verify(former).lost == lost
    status(former)
    assert resume(former, designs=DESIGNS) == expected
    assert verify(former).lost == () and verify(former).kept == COUNT


def test_only_what_is_lost_is_computed_again(journal: Path, expected) -> None:
    for number in (3, ALONE, AMONG):
        edit_block(journal, number, "sums", flipped(8, 0))
    with opened(journal) as book:
        assert set(range(COUNT)) - set(book.finished()) == {3, ALONE, AMONG}
    assert resume(journal, designs=DESIGNS) == expected


@pytest.mark.parametrize(
    "edit",
    [
        "UPDATE study SET study = replace(study, 'faults', 'faulty')",
        "UPDATE study SET study = 'none'",
        "UPDATE study SET designs = '{}'",
        "UPDATE study SET made = NULL",
        "UPDATE study SET total = total - 1",
        "UPDATE study SET format = 2",
        "DELETE FROM study",
        "DROP TABLE study",
    ],
)
def test_a_study_that_was_edited_is_refused(journal: Path, edit: str) -> None:
    with edited(journal) as database:
        database.execute(edit)
    for verb in (resume, status, verify):
        with pytest.raises(DesignError):
            verb(journal)


def test_a_journal_of_the_former_format_is_refused_in_words(tmp_path: Path) -> None:
    with edited(tmp_path / "j") as database:
        database.execute("CREATE TABLE study (format INTEGER, version TEXT, study TEXT, designs TEXT, origin TEXT)")
        database.execute("INSERT INTO study VALUES (3, '0.1.0', '{}', '{}', '')")
    with pytest.raises(DesignError, match="its format is 3, not 5; continue with the gearwright that began it"):
        recorded(tmp_path / "j")


def test_a_table_of_rows_that_is_gone_is_computed_again(journal: Path, expected) -> None:
    with edited(journal) as database:
        database.execute("DROP TABLE blocks")
    assert verify(journal).lost == tuple(range(COUNT))
    with pytest.raises(DesignError, match="status --verify"):
        status(journal)
    assert resume(journal, designs=DESIGNS) == expected


def test_the_command_names_what_is_lost(journal: Path) -> None:
    assert CliRunner().invoke(app, ["status", str(journal), "--verify"]).stdout == (
        "whole: 60 cases as they were written\n"
    )
    for number in (3, 17, 18, 19, 59):
        edit_block(journal, number, "sums", flipped(8, 0))
    found = CliRunner().invoke(app, ["status", str(journal), "--verify"])
    assert found.exit_code == 1
    assert found.stdout.startswith("cases 3, 17-19, 59 are lost; 55 are as they were written\nnext: ")


def test_bytes_that_were_overwritten_cost_what_they_held(journal: Path, expected, fault: int) -> None:
    """Runs of random bytes anywhere: the study comes out as it was, or its beginning is gone and that is said."""
    draw = random.Random(fault)
    content = bytearray(journal.read_bytes())
    for _ in range(draw.choice([1, 1, 3, 10])):
        at, length = draw.randrange(len(content)), draw.choice([1, 16, 512, 5000])
        content[at : at + length] = draw.randbytes(len(content[at : at + length]))
    journal.write_bytes(content)
    assert_mended_or_refused(journal, expected)


def test_a_journal_that_was_cut_off_keeps_what_is_left(journal: Path, expected, fault: int) -> None:
    content = journal.read_bytes()
    journal.write_bytes(content[: random.Random(fault).randrange(len(content))])
    assert_mended_or_refused(journal, expected)


def assert_mended_or_refused(journal: Path, expected) -> None:
    try:
        verify(journal)
        status(journal)
        table = resume(journal, designs=DESIGNS)
    except GearwrightError as error:
        assert "journal" in str(error)
    else:
        assert table == expected
        assert verify(journal).kept == COUNT


def test_damage_in_the_rows_costs_only_them(journal: Path, expected) -> None:
    """A page in the middle of the file is gone; the rows before and behind it are there."""
    content = bytearray(journal.read_bytes())
    size = 4096
    page = len(content) // size // 2
    content[page * size : (page + 1) * size] = bytes(size)
    journal.write_bytes(content)
    found = verify(journal)
    assert found.damaged and 0 < len(found.lost) < COUNT and found.kept > COUNT // 2
    assert resume(journal, designs=DESIGNS) == expected


def test_a_damaged_lock_is_named(journal: Path) -> None:
    (journal.parent / "j-lock").write_bytes(b"no lock at all" * 100)
    with pytest.raises(DesignError, match=r"j-lock: 1 problem\n.*another file has the name of the journal's lock"):
        resume(journal)
    assert not status(journal).running
