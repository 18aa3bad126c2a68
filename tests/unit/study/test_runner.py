"""Runners, workers and journals under what happens at night: killed workers, killed runners, full disks, changes."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import deadly
import pytest

import gearwright.study.running as runner_module
from gearwright.errors import DesignError, SolveError
from gearwright.notices import noticed
from gearwright.shipped import shipped_design
from gearwright.spec import Study, edited, parse_study, read
from gearwright.study import run
from gearwright.study.cases import cases
from gearwright.study.journal import begin, made_with, opened, recorded, rows_of, status
from gearwright.study.running import resume, run_study
from gearwright.study.workers import local

NAME = "in-line-h2"
DESIGNS = {NAME: read(shipped_design(NAME))}


def study_of(count: int, *, name: str = "s", description: str = "") -> Study:
    return parse_study(text_of(count, name=name, description=description))


def text_of(count: int, *, name: str = "s", description: str = "") -> str:
    return f"""
schema = 1
name = "{name}"
description = "{description}"
designs = ["{NAME}"]
results = ["mass", "gears.first.sun.module"]
[axes]
"motors.electric.speed_rpm" = {{from = 2000, to = 5500}}
"planetaries.second.planets" = {{values = [4, 5, 9]}}
[sampling]
method = "sobol"
count = {count}
seed = 7
"""


def test_a_journal_gives_the_rows_of_the_plain_run_bit_for_bit(tmp_path: Path) -> None:
    study = study_of(24)
    table = run_study(study, DESIGNS, journal=tmp_path / "j")
    assert table == run(study, DESIGNS)
    assert table.failed and len(table.failed) < 24, "9 planets do not fit"
    assert rows_of(tmp_path / "j") == list(table.rows)


def test_what_workers_say_meanwhile_is_heard_once() -> None:
    said: list[str] = []
    with noticed(said.append), local(study_of(6), DESIGNS, 2, function=deadly.said_first) as compute:
        found = dict(row for finished in compute(cases(study_of(6)), 6) for row in finished)
    assert sorted(found) == list(range(6))
    assert said == ["compiling"]


@pytest.mark.parametrize(("how", "problem"), [("once", ""), ("always", "its worker died 2 times")])
def test_a_case_that_kills_its_worker_is_tried_twice(tmp_path: Path, how: str, problem: str) -> None:
    study = study_of(40, name=str(tmp_path / "mark"), description=f"{how} 17")
    with local(study, DESIGNS, 1, function=deadly.sized_at_once) as compute:
        found = dict(row for finished in compute(cases(study), 40) for row in finished)
    assert sorted(found) == list(range(40))
    assert found.pop(17).problem.startswith(problem)
    assert not any(row.problem for row in found.values())


def test_a_worker_that_dies_within_its_answer_is_replaced(tmp_path: Path) -> None:
    """What it had begun to send ends in the middle of a message."""
    study = study_of(40, name=str(tmp_path / "mark"))
    with local(study, DESIGNS, 2, function=deadly.dead_within_its_answer) as compute:
        found = dict(row for finished in compute(cases(study), 40) for row in finished)
    assert sorted(found) == list(range(40))
    assert not any(row.problem for row in found.values())


def test_workers_are_killed_while_they_send_large_answers(tmp_path: Path, fault: int) -> None:
    """20 MB a row take some 0.03 s to send; the kills come within that time."""
    study = study_of(9, description=f"{tmp_path / 'mark'} {fault}")
    with local(study, DESIGNS, 2, function=deadly.large_and_killed) as compute:
        found = {number: len(row.problem) for finished in compute(cases(study), 9) for number, row in finished}
    assert found == dict.fromkeys(range(9), 20_000_000)


def test_a_second_runner_is_refused(tmp_path: Path) -> None:
    begin(tmp_path / "j", study_of(2), DESIGNS)
    with opened(tmp_path / "j"):
        assert status(tmp_path / "j").running
        with pytest.raises(DesignError, match="another runner is at this journal"):
            resume(tmp_path / "j")
    assert not status(tmp_path / "j").running


def test_a_journal_that_is_there_is_not_written_over(tmp_path: Path) -> None:
    begin(tmp_path / "j", study_of(2), DESIGNS)
    with pytest.raises(DesignError, match="there is a journal of this study already"):
        run_study(study_of(2), DESIGNS, journal=tmp_path / "j")
    with pytest.raises(DesignError, match="this is the journal of another study, 's'; give this one another name"):
        run_study(study_of(2, name="other"), DESIGNS, journal=tmp_path / "j")


@pytest.mark.parametrize("content", [b"mass = 3\n", b"SQLite of somebody else"])
def test_a_file_that_is_no_journal_is_not_written_over(tmp_path: Path, content: bytes) -> None:
    """Neither a text nor another program's database."""
    if content.startswith(b"SQLite"):
        with closing(sqlite3.connect(tmp_path / "j")) as database:
            database.execute("CREATE TABLE own (name TEXT)")
    else:
        (tmp_path / "j").write_bytes(content)
    before = (tmp_path / "j").read_bytes()
    with pytest.raises(DesignError, match="another file of this name"):
        run_study(study_of(2), DESIGNS, journal=tmp_path / "j")
    assert (tmp_path / "j").read_bytes() == before


def test_a_runner_that_died_before_its_study_was_written_leaves_the_name_free(tmp_path: Path) -> None:
    with closing(sqlite3.connect(tmp_path / "j")) as database:
        database.execute("PRAGMA journal_mode = WAL")
    assert run_study(study_of(8), DESIGNS, journal=tmp_path / "j") == run(study_of(8), DESIGNS)


@pytest.mark.parametrize("content", [None, "", "no database"])
def test_what_is_no_journal_is_said(tmp_path: Path, content: str | None) -> None:
    if content is not None:
        (tmp_path / "j").write_text(content, encoding="utf-8")
    with pytest.raises(DesignError, match=r"no journal of a study|no such journal"):
        resume(tmp_path / "j")


def test_a_changed_design_is_noticed_and_the_recorded_one_is_used(tmp_path: Path) -> None:
    begin(tmp_path / "j", study_of(3), DESIGNS)
    changed = {NAME: edited(DESIGNS[NAME], {"carriers.fill": 0.9})}
    with pytest.raises(DesignError, match=r"designs\.in-line-h2: has changed"):
        resume(tmp_path / "j", designs=changed)
    assert resume(tmp_path / "j", designs=changed, anyway=True) == run(study_of(3), DESIGNS)


def test_another_version_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    begin(tmp_path / "j", study_of(3), DESIGNS)
    monkeypatch.setattr(runner_module, "made_with", lambda: {**made_with(), "gearwright": "99.0"})
    with pytest.raises(DesignError, match=r"gearwright: the study was begun with 0.*this is 99\.0; results may differ"):
        resume(tmp_path / "j", designs=DESIGNS)
    assert len(resume(tmp_path / "j", anyway=True).rows) == 3


def test_the_journal_holds_study_and_designs(tmp_path: Path) -> None:
    begin(tmp_path / "j", study_of(3), DESIGNS, origin="here")
    known = recorded(tmp_path / "j")
    assert (known.study, dict(known.designs), known.origin, known.total) == (study_of(3), DESIGNS, "here", 3)


def test_a_case_is_kept_once_though_it_comes_twice(tmp_path: Path) -> None:
    table = run(study_of(4), DESIGNS)
    begin(tmp_path / "j", study_of(4), DESIGNS)
    with opened(tmp_path / "j") as book:
        book.append([(1, table.rows[1])])
        book.append([(0, table.rows[0]), (1, table.rows[0])])
    assert rows_of(tmp_path / "j") == list(table.rows[:2])


def test_what_cannot_be_written_leaves_no_half_batch(tmp_path: Path) -> None:
    table = run(study_of(4), DESIGNS)
    begin(tmp_path / "j", study_of(4), DESIGNS)
    with opened(tmp_path / "j") as book:
        book.append([(0, table.rows[0])])
        book.database.execute("PRAGMA max_page_count = 1")
        with pytest.raises(SolveError, match="free some space"):
            book.append((number, table.rows[1]) for number in range(1, 2000))
        with closing(book.database.execute("SELECT SUM(count) FROM blocks")) as found:
            assert found.fetchone() == (1,)


def test_chunks_and_answers_larger_than_a_pipe_do_not_wait_for_each_other() -> None:
    """Chunks of 256 cases of 4 kB, and answers as large; a pipe holds some 200 kB."""
    study, text = study_of(3000).model_copy(update={"description": "never"}), "long" * 1000
    long = (case._replace(inputs={"text": f"{case.number} {text}"}) for case in cases(study))
    with local(study, DESIGNS, 2, function=deadly.sized_at_once) as compute:
        found = dict(row for finished in compute(long, 3000) for row in finished)
    assert sorted(found) == list(range(3000))
