"""The commands status, resume and cluster, and what study writes beside its table."""

from __future__ import annotations

import importlib.util
import json
import re
import sqlite3
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gearwright.cli import app
from gearwright.cli.commands.studies import clock_time
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.spec import read, read_study
from gearwright.study.journal import Journal, begin
from gearwright.study.running import Progress

TEXT = """schema = 1
name = "fill"
designs = ["mine.toml"]
results = ["mass"]
[axes]
"carriers.fill" = {from = 0.4, to = 0.8}
[sampling]
method = "sobol"
count = 8
[objectives]
mass = "minimum"
"""
SAFETY = '"gears.contact_safety" = {from = 1.3, to = 1.7}\n[sampling]'


def call(*arguments: object, code: int = 0) -> str:
    found = CliRunner().invoke(app, [str(each) for each in arguments])
    assert found.exit_code == code, found.output
    return found.output


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "study.toml").write_text(TEXT, encoding="utf-8")
    design = shipped_design("in-line-h2").read_text(encoding="utf-8")
    (tmp_path / "mine.toml").write_text(design, encoding="utf-8")
    return tmp_path


def test_a_study_with_a_journal_is_complete_and_shown_again(folder: Path) -> None:
    journal = folder / "j"
    first = call("study", folder / "study.toml", "--journal", journal, "--workers", 0, "--report", folder / "p.html")
    assert "Minimum train as sized: mine.toml at carriers.fill" in " ".join(first.split())
    assert "Minimum train as sized: mine.toml at carriers.fill" in (folder / "p.html").read_text(encoding="utf-8")
    assert call("status", journal).splitlines()[-2:] == ["fill: 8 of 8 cases, 0 infeasible", "complete"]
    again = call("resume", journal, "--workers", 0, "--json", "--export", folder / "t.nc")
    assert len(json.loads(again[: again.rindex("}") + 1])["result"]["rows"]) == 8
    assert (folder / "t.nc").stat().st_size > 0


def test_samples_and_sensitivities_are_answered_in_the_terminal_as_on_the_page(folder: Path) -> None:
    drawn = TEXT.partition("[objectives]")[0]
    (folder / "study.toml").write_text(drawn, encoding="utf-8")
    assert "train as sized: median 4" in call("study", folder / "study.toml", "--workers", 0)
    (folder / "study.toml").write_text(
        drawn.replace("sobol", "saltelli").replace("[sampling]", SAFETY), encoding="utf-8"
    )
    said = " ".join(call("study", folder / "study.toml", "--workers", 0).split())
    assert "train as sized depends most on gears.contact_safety" in said


def test_a_stopped_study_says_what_to_do_next(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("gearwright.study.running._missing", stopped)
    said = call("study", folder / "study.toml", "--journal", folder / "j", "--workers", 0, code=130)
    assert "what is finished is kept; next: gearwright resume" in said
    assert "stopped; next: gearwright resume" in call("status", folder / "j")


def test_a_design_file_that_changed_is_noticed_by_resume(folder: Path) -> None:
    study = read_study(folder / "study.toml")
    begin(folder / "j", study, {"mine.toml": read(folder / "mine.toml")}, origin=str(folder))
    text = (folder / "mine.toml").read_text(encoding="utf-8").replace("planets = 5", "planets = 4")
    (folder / "mine.toml").write_text(text, encoding="utf-8")
    found = CliRunner().invoke(app, ["resume", str(folder / "j"), "--workers", "0"])
    assert isinstance(found.exception, DesignError)
    assert "has changed since the study was begun" in str(found.exception)
    call("resume", folder / "j", "--workers", 0, "--anyway")


def test_cluster_prints_commands_that_only_this_machine_reaches() -> None:
    said = call("cluster", "--processes", 4)
    assert "dask scheduler --host 127.0.0.1 --no-dashboard --dashboard-address 127.0.0.1:0\n" in said
    assert "dask worker tcp://127.0.0.1:8786 --nworkers 4 --nthreads 1 --host 127.0.0.1 " in said
    assert "--cluster tcp://127.0.0.1:8786" in said


def test_a_cluster_that_others_reach_needs_certificates() -> None:
    found = CliRunner().invoke(app, ["cluster", "--host", "node1"])
    assert isinstance(found.exception, DesignError)
    assert "whoever reaches a scheduler at node1 runs code" in str(found.exception)
    said = call("cluster", "--host", "node1", "--processes", 4, "--tls", "ca.pem", "own cert.pem", "own.key")
    files = "--tls-ca-file ca.pem --tls-cert 'own cert.pem' --tls-key own.key"
    assert f"dask scheduler --host node1 --no-dashboard --dashboard-address 127.0.0.1:0 {files}\n" in said
    assert "dask worker tls://node1:8786 --nworkers 4 --nthreads 1 --no-dashboard" in said and said.count(files) == 2
    assert "--cluster tls://node1:8786 --tls ca.pem 'own cert.pem' own.key" in said


@pytest.mark.extra("distributed")
def test_files_of_certificates_must_be_there_and_belong_to_the_address(folder: Path) -> None:
    files = ("none.pem", "none.pem", "none.key")
    for address in ("tls://127.0.0.1:1", "tcp://127.0.0.1:1"):
        found = CliRunner().invoke(
            app,
            ["study", str(folder / "study.toml"), "--cluster", address, "--tls", *files],
        )
        assert isinstance(found.exception, DesignError)
        assert "there is no file none.key" in str(found.exception)
        assert ("goes with --tls" in str(found.exception)) == address.startswith("tcp")


def test_a_cluster_that_is_not_there_is_said(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gearwright.study.workers.PATIENCE", 0.5)
    installed = importlib.util.find_spec("distributed") is not None
    found = CliRunner().invoke(app, ["study", str(folder / "study.toml"), "--cluster", "tcp://127.0.0.1:1"])
    assert isinstance(found.exception, DesignError)
    assert ("no scheduler answers" if installed else 'pip install ".[cluster]"') in str(found.exception)


@pytest.mark.parametrize(("seconds", "words"), [(4.4, "4 s"), (75.0, "1 min 15 s"), (7380.0, "2 h 03 min")])
def test_times_are_said_as_clocks_say_them(seconds: float, words: str) -> None:
    assert clock_time(seconds) == words


def test_progress_counts_what_is_left() -> None:
    assert Progress(250, 1000, 3, 50.0).remaining == pytest.approx(15.0)
    assert Progress(0, 1000, 0, 0.0).remaining == float("inf")
    assert re.fullmatch("unknown time", clock_time(Progress(0, 1, 0, 0.0).remaining))


@pytest.mark.parametrize("earlier", [0, 3])
def test_json_lines_of_a_study_come_as_its_cases_are_finished(folder: Path, monkeypatch, earlier: int) -> None:
    """The envelope first, the rows of earlier runs next, then each row before the next case is computed."""
    journal, order = folder / "j", list[str]()
    if earlier:
        call("study", folder / "study.toml", "--journal", journal, "--workers", 0)
        with sqlite3.connect(journal) as database:
            database.execute("DELETE FROM blocks WHERE least >= ?", (earlier,))
    append = Journal.append

    def appended(self, rows):
        order.append("case")
        append(self, rows)

    monkeypatch.setattr(Journal, "append", appended)
    monkeypatch.setattr("gearwright.cli.answers.show_json", lambda text: order.append(min(json.loads(text))))
    what = ("resume", journal) if earlier else ("study", folder / "study.toml")
    assert call(*what, "--jsonl", "--workers", 0) == ""
    assert order == ["command", *["design"] * earlier, *["case", "design"] * (8 - earlier)]
