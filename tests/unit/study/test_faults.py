"""Studies that are really killed: workers, runners, a scheduler, disks that fill up; every case once, bit for bit.

Each fault comes at a moment that is drawn at random from a fixed seed, ``--faults N`` times (once if left out).
"""

from __future__ import annotations

import os
import random
import signal
import time
from pathlib import Path

import pytest
from fault_studies import (
    DESIGNS,
    assert_whole,
    blocks,
    command,
    command_line,
    done,
    ended,
    kill,
    members,
    started,
    study_of,
    undisturbed,
    until,
)

from gearwright.study.journal import rows_of, status
from gearwright.study.running import run_study

COUNT = 100


@pytest.fixture(scope="module")
def expected():
    return undisturbed(COUNT)


def test_a_worker_is_killed_at_a_random_case(tmp_path: Path, expected, fault: int) -> None:
    place = random.Random(fault).randrange(COUNT)
    process = started(tmp_path, COUNT, "--workers", "2")
    with ended(process):
        until(lambda: done(tmp_path / "j") >= place or process.poll() is not None, "its cases")
        workers = [each for each in members(process.pid) if each != process.pid]
        if process.poll() is None and workers:
            kill(max(workers))
        process.communicate(timeout=60.0)
        assert process.returncode == 0
    assert rows_of(tmp_path / "j") == list(expected.rows)


def test_the_runner_is_killed_at_a_random_moment(tmp_path: Path, expected, fault: int) -> None:
    """At any time between the start of the command and its end."""
    process = started(tmp_path, COUNT, "--workers", "2")
    with ended(process):
        until(lambda: (tmp_path / "j").exists(), "its journal")
        time.sleep(random.Random(fault).uniform(0.0, 2.0))
        kill(process.pid)
    if done(tmp_path / "j") == 0 and not status_is_there(tmp_path / "j"):
        assert run_study(study_of(COUNT), DESIGNS, journal=tmp_path / "j") == expected
    else:
        assert_whole(tmp_path / "j", expected)


def status_is_there(journal: Path) -> bool:
    try:
        return not status(journal).running
    except Exception:  # killed before the study was written
        return False


def test_the_disk_is_full_at_a_random_size(tmp_path: Path, expected, fault: int) -> None:
    """No file may grow past a limit, so that writing fails as it does where no block is left."""
    process = started(tmp_path, COUNT, "--workers", "2", limit=random.Random(fault).randrange(40_000, 50_000))
    with ended(process):
        _, said = process.communicate(timeout=60.0)
        assert process.returncode == 1
        assert "the journal cannot be written" in said and "gearwright resume" in said
    assert 0 <= done(tmp_path / "j") < COUNT
    assert_whole(tmp_path / "j", expected)


def test_two_runners_at_one_journal(tmp_path: Path, expected) -> None:
    first = started(tmp_path, COUNT, "--workers", "1")
    with ended(first):
        until(lambda: done(tmp_path / "j") > 0, "its first case")
        os.kill(first.pid, signal.SIGSTOP)  # it holds the journal while the others try
        for arguments in (("resume", "j"), ("study", "study.toml", "--journal", "j")):
            second = command(tmp_path, *arguments)
            _, said = second.communicate(timeout=60.0)
            assert second.returncode == 2
            assert "another runner is at this journal" in said or "there is a journal of this study" in said
        os.kill(first.pid, signal.SIGCONT)
        first.communicate(timeout=60.0)
        assert first.returncode == 0
    assert rows_of(tmp_path / "j") == list(expected.rows)


def test_two_runners_that_begin_one_journal_at_once(tmp_path: Path, expected) -> None:
    runners = [started(tmp_path, COUNT, "--workers", "1") for _ in range(2)]
    with ended(runners[0]), ended(runners[1]):
        said = [each.communicate(timeout=60.0)[1] for each in runners]
        assert sorted(each.returncode for each in runners) == [0, 2]
        assert "there is a journal of this study already" in "".join(said) or "another runner" in "".join(said)
    assert rows_of(tmp_path / "j") == list(expected.rows)


def test_ctrl_c_stops_cleanly_and_status_tells_meanwhile(tmp_path: Path) -> None:
    """The terminal sends the signal to the whole group, to the workers too."""
    process = started(tmp_path, 30 * COUNT, "--workers", "2")
    with ended(process):
        until(lambda: done(tmp_path / "j") > 0, "its first case")
        workers = [each for each in members(process.pid) if "spawn_main" in command_line(each)]
        assert len(workers) == 2 and all(blocks(each, signal.SIGINT) for each in workers), "the runner sees to Ctrl-C"
        os.kill(process.pid, signal.SIGSTOP)
        assert "running" in said_by(tmp_path, "status", "j")
        os.killpg(process.pid, signal.SIGINT)
        os.kill(process.pid, signal.SIGCONT)
        _, said = process.communicate(timeout=60.0)
        assert process.returncode == 130
        assert "interrupted: what is finished is kept; next: gearwright resume j" in said
        assert "Traceback" not in said, said
        until(lambda: not members(process.pid), "its workers end")
    assert 0 < done(tmp_path / "j") < 30 * COUNT
    assert "stopped; next: gearwright resume j" in said_by(tmp_path, "status", "j")


def said_by(folder: Path, *arguments: str) -> str:
    return command(folder, *arguments).communicate(timeout=60.0)[0]
