"""Processes that die: what they were at is computed again, once."""

import multiprocessing
import os
import signal
import subprocess
import sys
import tempfile
import time
from functools import partial
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.processes import computed, dismiss, hire, run_program


def squared(folder: Path, number: int, *, always: bool = False) -> int:
    """Return a square; of three the process dies, the first time or always."""
    met = folder / "met"
    if number == 3 and (always or not met.exists()):
        met.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number


def test_what_a_dead_process_was_at_is_computed_by_others(tmp_path: Path) -> None:
    found = dict(computed(partial(squared, tmp_path), [1, 2, 3, 4], 1))
    assert found == {1: 1, 2: 4, 3: 9, 4: 16}


def test_a_thing_that_kills_every_process_is_told(tmp_path: Path) -> None:
    with pytest.raises(SolveError, match="workers died"):
        list(computed(partial(squared, tmp_path, always=True), [3], 1))


def refused(number: int) -> int:
    """Refuse a number as users are told it."""
    raise DesignError([Problem("number", f"{number} is none")])


def busy(line: Connection, folder: Path) -> None:
    """Compute for ever in a folder of its own, and say so."""
    with tempfile.TemporaryDirectory(dir=folder):
        line.send("busy")
        while True:
            time.sleep(0.01)


def deaf(line: Connection) -> None:
    """Hear no request to end."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    line.send("deaf")
    time.sleep(600.0)


def test_every_thing_is_computed_once_by_more_and_by_fewer_workers_than_things() -> None:
    for workers in (0, 1, 3):
        found = list(computed(abs, [-1, -2], workers))
        assert sorted(found) == [(-2, 2), (-1, 1)]
    assert list(computed(abs, [], 2)) == []


def test_what_is_wrong_with_a_thing_is_told_as_if_it_were_computed_here() -> None:
    with pytest.raises(DesignError) as caught:
        list(computed(refused, [7], 1))
    assert [(found.path, found.message) for found in caught.value.problems] == [("number", "7 is none")]
    assert not multiprocessing.active_children()


def test_workers_end_where_nobody_takes_what_they_find() -> None:
    found = computed(abs, [-1, -2, -3], 2)
    next(found)
    found.close()
    assert not multiprocessing.active_children()


def test_who_is_dismissed_puts_away_what_it_has_begun(tmp_path: Path) -> None:
    hired = hire(busy, tmp_path)
    assert hired.line.recv() == "busy" and list(tmp_path.iterdir())
    dismiss([hired.process])
    assert not hired.process.is_alive() and not list(tmp_path.iterdir())


def test_who_hears_nothing_is_killed() -> None:
    hired = hire(deaf)
    assert hired.line.recv() == "deaf"
    dismiss([hired.process])
    assert hired.process.exitcode == -signal.SIGKILL


def test_a_program_is_heard_to_its_end(tmp_path: Path) -> None:
    said = run_program(["sh", "-c", "pwd; echo wrong >&2; exit 3"], seconds=60.0, folder=tmp_path)
    assert (said.returncode, said.stdout.strip(), said.stderr) == (3, str(tmp_path.resolve()), "wrong\n")


def test_a_program_that_takes_too_long_ends_with_all_that_it_has_started() -> None:
    with pytest.raises(subprocess.TimeoutExpired) as caught:
        run_program(["sh", "-c", "sleep 600 & echo $!; wait"], seconds=2.0)
    number = int(caught.value.stdout)
    for _ in range(500):
        if "Z" in state_of(number):  # whoever takes up orphans has not asked for it yet
            break
        time.sleep(0.01)
    assert "Z" in state_of(number)


def state_of(number: int) -> str:
    """Return how a process is: Z if it is dead, or gone."""
    try:
        return Path(f"/proc/{number}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]
    except OSError:
        return "Z"


def test_a_long_folder_of_temporary_files_hires_all_the_same(tmp_path: Path) -> None:
    """The name of a socket has some hundred letters."""
    folder = tmp_path / ("long" * 20)
    folder.mkdir()
    code = (
        "from gearwright.processes import hire, _answer\n"
        "if __name__ == '__main__':\n"
        "    hired = hire(_answer, abs, needed=('gearwright.errors',))\n"
        "    hired.line.send(-2)\n"
        "    print(hired.line.recv()[0])\n"
        "    hired.process.terminate()\n"
    )
    (tmp_path / "hires.py").write_text(code, encoding="utf-8")
    command = [sys.executable, str(tmp_path / "hires.py")]
    assert (
        subprocess.run(
            command, env={**os.environ, "TMPDIR": str(folder)}, capture_output=True, text=True, check=True
        ).stdout.strip()
        == "2"
    )
