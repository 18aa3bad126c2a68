"""Searches that are really killed: worker, runner, driver, a disk that fills up; every design once, bit for bit.

Each fault comes at a moment that is drawn at random from a fixed seed, ``--faults N`` times (once if left out).
"""

from __future__ import annotations

import json
import random
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from fault_studies import command, done, ended, kill, members, until

from gearwright.study.journal import rows_of

SEARCH = """
schema = 1
name = "faults of a search"
designs = ["single-planetary"]
[axes]
"gears.pressure_angle_deg" = {from = 20, to = 25, step = 0.01}
"gears.face_width_ratio" = {from = 7, to = 14, step = 0.25}
"gears.bending_safety" = {values = [2.0, 2.5, 3.0]}
[objectives]
total_mass = "minimum"
loss = "minimum"
[constraints]
worst_margin = {minimum = 1.0}
[search]
screened = 8192
population = 24
evaluations = 192
polished = 1
still = 10
seed = 5
"""
DRIVER = """
import sys
from pathlib import Path
import gearwright as gw
if __name__ == "__main__":
    with gw.search(gw.read_study("search.toml"), journal=Path("j"), workers=int(sys.argv[1])) as search:
        while len(search.rows) < 192:
            search.tell(search.evaluate(search.ask(24)))
"""
Start = Callable[[Path, str, int | None], subprocess.Popen[str]]


def optimised(folder: Path, workers: str, limit: int | None = None) -> subprocess.Popen[str]:
    (folder / "search.toml").write_text(SEARCH, encoding="utf-8")
    options = ("--journal", "j", "--workers", workers, "--json")
    return command(folder, "optimise", "search.toml", *options, limit=limit)


def driven(folder: Path, workers: str, limit: int | None = None) -> subprocess.Popen[str]:
    """Start a driver that asks and tells, in a session of its own."""
    (folder / "search.toml").write_text(SEARCH, encoding="utf-8")
    (folder / "drive.py").write_text(DRIVER, encoding="utf-8")
    return subprocess.Popen(
        [sys.executable, "drive.py", workers], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        start_new_session=True,
    )  # fmt: skip


class Undisturbed:
    """What a search comes to, and how long it takes."""

    def __init__(self, folder: Path, start: Start) -> None:
        self.start, begun = start, time.monotonic()
        process = start(folder, "0", None)
        self.said, problem = process.communicate(timeout=120.0)
        assert process.returncode == 0, problem
        self.duration = time.monotonic() - begun
        self.rows, self.size = rows_of(folder / "j"), (folder / "j").stat().st_size

    def assert_whole(self, folder: Path) -> None:
        """Assert that a search that is gone on with keeps its rows, and comes to the same answer bit for bit."""
        before = rows_of(folder / "j") if done(folder / "j") else []
        process = self.start(folder, "0", None)
        said, problem = process.communicate(timeout=120.0)
        assert process.returncode == 0, problem
        assert all(row in self.rows for row in before)
        assert rows_of(folder / "j") == self.rows
        assert not said or json.loads(said) == json.loads(self.said)


@pytest.fixture(scope="module", params=[optimised, driven], ids=["optimise", "ask and tell"])
def undisturbed(request, tmp_path_factory) -> Undisturbed:
    return Undisturbed(tmp_path_factory.mktemp("undisturbed"), request.param)


def test_a_worker_is_killed_at_a_random_moment(tmp_path: Path, undisturbed: Undisturbed, fault: int) -> None:
    process = undisturbed.start(tmp_path, "2", None)
    with ended(process):
        until(lambda: workers_of(process) or process.poll() is not None, "its workers")
        time.sleep(random.Random(fault).uniform(0.0, undisturbed.duration))
        for worker in workers_of(process)[-1:]:
            kill(worker)
        said, problem = process.communicate(timeout=120.0)
        assert process.returncode == 0, problem
    assert rows_of(tmp_path / "j") == undisturbed.rows
    assert said == undisturbed.said


def workers_of(process: subprocess.Popen[str]) -> list[int]:
    return [each for each in members(process.pid) if "spawn_main" in _called(each)]


def _called(process: int) -> str:
    try:
        return Path(f"/proc/{process}/cmdline").read_text(encoding="utf-8")
    except OSError:  # it has ended
        return ""


def test_the_runner_is_killed_at_a_random_moment(tmp_path: Path, undisturbed: Undisturbed, fault: int) -> None:
    process = undisturbed.start(tmp_path, "0", None)
    with ended(process):
        time.sleep(random.Random(fault).uniform(0.3, 1.0) * undisturbed.duration)
        kill(process.pid)
    undisturbed.assert_whole(tmp_path)


def test_the_disk_is_full_at_a_random_size(tmp_path: Path, undisturbed: Undisturbed, fault: int) -> None:
    """No file may grow past a limit, so that writing fails as it does where no block is left."""
    if undisturbed.start is driven:
        pytest.skip("the journal is the same")
    process = undisturbed.start(tmp_path, "0", random.Random(fault).randrange(30_000, undisturbed.size))
    with ended(process):
        _, said = process.communicate(timeout=120.0)
        assert process.returncode == 1, said
        assert "the journal cannot be written" in said
    undisturbed.assert_whole(tmp_path)
