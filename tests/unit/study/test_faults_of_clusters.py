"""A Dask cluster of separately started processes, of which some are killed: the study completes, bit for bit."""

from __future__ import annotations

import json
import os
import random
import re
import shlex
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from shutil import which

import pytest
from fault_studies import assert_whole, command, done, ended, members, started, undisturbed, until

from gearwright.study.journal import rows_of
from gearwright.study.workers import Tls, commands

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


def told_address(folder: Path) -> str:
    """Return where a scheduler listens, as soon as it has written its file whole."""
    told = folder / "scheduler.json"
    until(lambda: told.exists() and told.read_text(encoding="utf-8").rstrip().endswith("}"), "the scheduler")
    return str(json.loads(told.read_text(encoding="utf-8"))["address"])


@contextmanager
def cluster(folder: Path) -> Iterator[tuple[str, list[subprocess.Popen[str]]]]:
    """Hold a scheduler and two workers; yield its address, and all three processes."""
    with ExitStack() as stack:
        parts = [dask(folder, "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")]
        stack.enter_context(ended(parts[0]))
        address = told_address(folder)
        for _ in range(2):
            parts.append(dask(folder, "worker", "--nthreads", "1", "--no-dashboard"))
            stack.callback(kill_all, parts[-1])
        yield address, parts


def by_command(folder: Path, text: str, *options: str) -> subprocess.Popen[str]:
    """Start a part of a cluster by the command that is printed, in a session of its own."""
    quiet = (folder / "said.txt").open("a", encoding="utf-8")
    with quiet:
        return subprocess.Popen(
            [sys.executable, "-m", *shlex.split(text), *options],
            cwd=folder, stdout=quiet, stderr=quiet, text=True, start_new_session=True,
        )  # fmt: skip


@contextmanager
def printed(folder: Path, tls: Tls | None = None) -> Iterator[tuple[str, list[subprocess.Popen[str]]]]:
    """Hold what the printed commands start, at a free port; yield the address and both processes."""
    scheduler, worker, _ = commands("127.0.0.1", 1, tls)
    with ExitStack() as stack:
        parts = [by_command(folder, scheduler, "--port", "0", "--scheduler-file", "scheduler.json")]
        stack.enter_context(ended(parts[0]))
        address = told_address(folder)
        parts.append(by_command(folder, re.sub(r"t\w\w://\S+", address, worker)))
        stack.callback(kill_all, parts[1])
        yield address, parts


def listening(session: int) -> set[str]:
    """Return the addresses on which the processes of a session listen, as the kernel writes them."""
    links = [link for each in members(session) for link in Path(f"/proc/{each}/fd").iterdir()]
    sockets = {str(link.readlink())[8:-1] for link in links if str(link.readlink()).startswith("socket:")}
    lines = [
        line.split() for name in ("tcp", "tcp6") for line in Path(f"/proc/net/{name}").read_text().splitlines()[1:]
    ]
    return {line[1].partition(":")[0] for line in lines if line[3] == "0A" and line[9] in sockets}


def key_pair(folder: Path, name: str) -> Tls:
    """Return a certificate that is its own authority, and its key."""
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "1", "-subj", "/CN=gearwright",
         "-keyout", folder / f"{name}.key", "-out", folder / f"{name}.pem"],
        check=True, capture_output=True,
    )  # fmt: skip
    return folder / f"{name}.pem", folder / f"{name}.pem", folder / f"{name}.key"


def test_the_printed_commands_listen_to_this_machine_only(tmp_path: Path, expected) -> None:
    with printed(tmp_path) as (address, parts):
        process = started(tmp_path, COUNT, "--cluster", address)
        with ended(process):
            _, said = process.communicate(timeout=120.0)
            assert process.returncode == 0, said
        heard = [listening(part.pid) for part in parts]
        assert all(heard) and set().union(*heard) == {"0100007F"}, "127.0.0.1 as the kernel writes it"
    assert rows_of(tmp_path / "j") == list(expected.rows)


@pytest.mark.skipif(which("openssl") is None, reason="nothing here makes certificates")
def test_with_certificates_only_their_holders_take_part(tmp_path: Path, expected) -> None:
    own, other = key_pair(tmp_path, "own"), key_pair(tmp_path, "other")
    with printed(tmp_path, own) as (address, _):
        assert address.startswith("tls://")
        for files, message in (((), "goes with --tls CA CERT KEY"), (other, "does not accept the files")):
            process = command(
                tmp_path, "study", "motor-speed", "--cluster", address, *(("--tls", *map(str, files)) if files else ())
            )
            _, said = process.communicate(timeout=120.0)
            assert process.returncode == 2 and message in said, said
        process = started(tmp_path, COUNT, "--cluster", address, "--tls", *map(str, own))
        with ended(process):
            _, said = process.communicate(timeout=120.0)
            assert process.returncode == 0, said
    assert rows_of(tmp_path / "j") == list(expected.rows)


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
