"""Journals that were damaged or edited: what is lost is named, computed again, and nothing else is."""

from __future__ import annotations

import random
import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest
from fault_studies import DESIGNS, study_of
from typer.testing import CliRunner

from gearwright.cli import app
from gearwright.errors import DesignError, GearwrightError
from gearwright.study import run
from gearwright.study.running import opened, recorded, resume, run_study, status, verify

COUNT = 200


@pytest.fixture(scope="module")
def expected():
    return run(study_of(COUNT), DESIGNS)


@pytest.fixture(scope="module")
def whole(tmp_path_factory, expected) -> Path:
    path = tmp_path_factory.mktemp("whole") / "j"
    assert run_study(study_of(COUNT), DESIGNS, journal=path) == expected
    return path


@pytest.fixture
def journal(tmp_path: Path, whole: Path) -> Path:
    return Path(shutil.copy(whole, tmp_path / "j"))


@contextmanager
def edited(journal: Path) -> Iterator[sqlite3.Connection]:
    with closing(sqlite3.connect(journal, isolation_level=None)) as database:
        yield database


def test_a_whole_journal_has_lost_nothing(journal: Path) -> None:
    found = verify(journal)
    assert (found.kept, found.lost, found.damaged) == (COUNT, (), False)


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
def test_an_edited_row_is_named_and_computed_again(journal: Path, edit: str, lost: tuple[int, ...], expected) -> None:
    with edited(journal) as database:
        database.execute(edit)
    assert verify(journal).lost == lost
    status(journal)
    assert resume(journal, designs=DESIGNS) == expected
    assert verify(journal).lost == () and verify(journal).kept == COUNT


def test_only_what_is_lost_is_computed_again(journal: Path, expected, monkeypatch: pytest.MonkeyPatch) -> None:
    with edited(journal) as database:
        database.execute("UPDATE rows SET results = '{}' WHERE number IN (3, 17)")
    with opened(journal) as book:
        assert set(range(COUNT)) - set(book.finished()) == {3, 17}
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
    with pytest.raises(DesignError, match="its format is 3, not 4; continue with the gearwright that began it"):
        recorded(tmp_path / "j")


def test_a_table_of_rows_that_is_gone_is_computed_again(journal: Path, expected) -> None:
    with edited(journal) as database:
        database.execute("DROP TABLE rows")
    assert verify(journal).lost == tuple(range(COUNT))
    with pytest.raises(DesignError, match="status --verify"):
        status(journal)
    assert resume(journal, designs=DESIGNS) == expected


def test_the_command_names_what_is_lost(journal: Path) -> None:
    assert CliRunner().invoke(app, ["status", str(journal), "--verify"]).stdout == (
        "whole: 200 cases as they were written\n"
    )
    with edited(journal) as database:
        database.execute("UPDATE rows SET results = '{}' WHERE number IN (3, 17, 18, 19, 199)")
    found = CliRunner().invoke(app, ["status", str(journal), "--verify"])
    assert found.exit_code == 1
    assert found.stdout.startswith("cases 3, 17-19, 199 are lost; 195 are as they were written\nnext: ")


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
