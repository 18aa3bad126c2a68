"""Ctrl-C on a real terminal, in a fresh interpreter, while a run is under way."""

import os
import pty
import signal
import subprocess
import sys

import pytest
from commands import furnish

from gearwright.store import load

START = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
from gearwright.cli import main
main()
"""
"""Listens to Ctrl-C also where the tests run in the background of a shell, which ignores it for its children."""
LONG = "500"
"""Time to simulate, far more than the test waits for [s]."""


@pytest.fixture
def folder(tmp_path):
    furnish(tmp_path)
    return tmp_path


def interrupted(folder, *words):
    """Run a command on a terminal, press Ctrl-C when its bar moves; return its exit code and what it printed."""
    master, slave = pty.openpty()
    child = subprocess.Popen(
        [sys.executable, "-c", START, *words], cwd=folder, stdin=slave, stdout=slave, stderr=slave,
        start_new_session=True, env={**os.environ, "TERM": "xterm"},
    )  # fmt: skip
    os.close(slave)
    written, pressed = b"", False
    while True:
        try:
            piece = os.read(master, 65536)
        except OSError:
            break
        written += piece
        if not pressed and b"simulating" in written and b"0:" in written.rpartition(b"simulating")[2]:
            os.killpg(child.pid, signal.SIGINT)
            pressed = True
    os.close(master)
    return child.wait(), written.decode()


@pytest.mark.parametrize("command", ["simulate", "run"])
def test_what_a_stopped_run_leaves_says_so_in_its_name_and_in_itself(folder, command):
    place = {"simulate": ["--output", "run.nc"], "run": ["--out", "."]}[command]
    (folder / "run.nc").write_bytes(b"an earlier one")
    code, said = interrupted(folder, command, "hybrid.toml", "--duration", LONG, "--stiffness", "constant", *place)
    assert code == 130, said
    assert "Traceback" not in said
    assert "run-interrupted.nc" in said
    trace = load(folder / "run-interrupted.nc").trace
    assert trace.interrupted
    assert 0.0 < trace.duration < float(LONG)
    assert (folder / "run.nc").read_bytes() == b"an earlier one"
    assert not (folder / "report.html").exists()
