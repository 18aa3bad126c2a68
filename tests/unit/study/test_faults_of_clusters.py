"""A Dask cluster of separately started processes, of which some are killed: the study completes, bit for bit."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from fault_studies import assert_whole, done, ended, members, started, undisturbed, until

from gearwright.study.running import rows_of

pytestmark = pytest.mark.extra("distributed")

COUNT = 600
"""Enough that every worker has several chunks."""


@pytest.fixture(scope="module")
def expected():
    return undisturbed(COUNT)


def dask(folder: Path, *arguments: str) -> subprocess.Popen[str]:
    """Start a part of a cluster in a session of its own; it writes what it says to a file, never to a full pipe."""
    quiet = (folder / f"dask-{arguments[0]}.txt").open("a", encoding="utf-8")
    with quiet:
        return subprocess.Popen(
            [sys.executable, "-m", "dask", *arguments, "--scheduler-file", str(folder / "scheduler.json")],
            cwd=folder, stdout=quiet, stderr=quiet, text=True, start_new_session=True,
        )  # fmt: skip


@contextmanager
def cluster(folder: Path) -> Iterator[tuple[str, list[subprocess.Popen[str]]]]:
    """Hold a scheduler and two workers; yield its address, and all three processes."""
    with ExitStack() as stack:
        parts = [dask(folder, "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")]
        stack.enter_context(ended(parts[0]))
        until((folder / "scheduler.json").exists, "the scheduler")
        for _ in range(2):
            parts.append(dask(folder, "worker", "--nthreads", "1", "--no-dashboard"))
            stack.callback(kill_all, parts[-1])
        yield json.loads((folder / "scheduler.json").read_text(encoding="utf-8"))["address"], parts


def kill_all(process: subprocess.Popen[str]) -> None:
    """Kill a worker with what watches over it."""
    for each in members(process.pid):
        os.kill(each, signal.SIGKILL)
    process.wait()


def test_a_worker_of_two_is_killed(tmp_path: Path, expected, fault: int) -> None:
    with cluster(tmp_path) as (address, parts):
        process = started(tmp_path, COUNT, "--cluster", address)
        with ended(process):
            place = random.Random(fault).randrange(1, COUNT // 2)
            until(lambda: done(tmp_path / "j") >= place or process.poll() is not None, "its cases")
            kill_all(parts[1])
            _, said = process.communicate(timeout=120.0)
            assert process.returncode == 0, said
    assert rows_of(tmp_path / "j") == list(expected.rows)


def test_the_scheduler_is_killed(tmp_path: Path, expected, fault: int) -> None:
    with cluster(tmp_path) as (address, parts):
        process = started(tmp_path, COUNT, "--cluster", address)
        with ended(process):
            place = random.Random(fault).randrange(1, COUNT // 2)
            until(lambda: done(tmp_path / "j") >= place or process.poll() is not None, "its cases")
            kill_all(parts[0])
            _, said = process.communicate(timeout=120.0)
            assert process.returncode == 1, said
            assert "the scheduler is gone; what is finished is kept" in said
            assert "Traceback" not in said, said
    assert 0 < done(tmp_path / "j") < COUNT
    assert_whole(tmp_path / "j", expected)
