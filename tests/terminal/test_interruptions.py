"""Ctrl-C and its like, on real terminals and in pipes, in fresh interpreters, while work is under way."""

import os
import pty
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import pytest
from commands import furnish

from gearwright.store import load
from sessions import PATIENCE, members, until

START = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
from gearwright.cli import main
main()
"""
"""Listens to Ctrl-C also where the tests run in the background of a shell, which ignores it for its children."""
PRESSED = """
import os, signal, sys

class Finger:
    def find_spec(self, name, *_):
        if name == wanted:
            os.kill(os.getpid(), signal.SIGINT)

wanted = sys.argv.pop()
signal.signal(signal.SIGINT, signal.default_int_handler)
sys.meta_path.insert(0, Finger())
from gearwright.__main__ import main
main()
print("too late")
"""
"""Presses Ctrl-C when the module that its argument names begins to load."""
WORKING = {
    "architectures": ["architectures", "in-line-h2", "--workers", "2"],
    "study": ["study", "long.toml", "--workers", "2", "--journal", "journal"],
    "optimise": [
        "optimise",
        "hybrid.toml",
        "--free",
        "carriers.fill=0.4..0.8",
        "--screened",
        "20000",
        "--workers",
        "2",
    ],
    "close": ["close", "ec120b"],
}
"""Commands that work far longer than these tests wait, and whether processes work for them."""
CREWS = {"architectures", "study", "optimise"}
LONG_STUDY = """\
schema = 1
name = "many"
designs = ["hybrid.toml"]
results = ["mass"]
[axes]
"carriers.fill" = {from = 0.4, to = 0.8}
[sampling]
method = "sobol"
count = 500000
"""
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


@dataclass
class Begun:
    """A command that runs in a session of its own, with a folder of its own for what is temporary."""

    process: subprocess.Popen
    end: int
    """From which all that it prints is read."""
    temporary: Path

    def said(self):
        """Return what it and those who work for it print, until the last of them has let go of the line."""
        written = b""
        while True:
            try:
                piece = os.read(self.end, 65536)
            except OSError:  # a terminal that nobody is at
                piece = b""
            if not piece:
                os.close(self.end)
                return written.decode()
            written += piece

    def left(self):
        return [*members(self.process.pid), *self.temporary.iterdir()]


@pytest.fixture
def begun(folder):
    """Return a function that starts a command in a pipe or on a terminal; what still runs at the end is killed."""
    started, made = [], list[Path]()
    (folder / "long.toml").write_text(LONG_STUDY, encoding="utf-8")

    def begin(words, where="pipe"):
        temporary = Path(tempfile.mkdtemp(prefix="gw-"))  # short: sockets have names of some hundred letters
        made.append(temporary)
        ours, theirs = pty.openpty() if where == "terminal" else os.pipe()
        process = subprocess.Popen(
            [sys.executable, "-m", "gearwright", *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=theirs,
            stderr=theirs, start_new_session=True, env={**os.environ, "TERM": "xterm", "TMPDIR": str(temporary)},
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
        )  # fmt: skip
        os.close(theirs)
        started.append(process)
        return Begun(process, ours, temporary)

    yield begin
    for process in started:
        for number in members(process.pid):
            os.kill(number, signal.SIGKILL)
        process.wait()
    for temporary in made:
        shutil.rmtree(temporary, ignore_errors=True)


@pytest.mark.parametrize("group", [False, True], ids=["alone", "group"])
@pytest.mark.parametrize(
    ("number", "where"),
    [(signal.SIGTERM, "pipe"), (signal.SIGTERM, "terminal"), (signal.SIGINT, "pipe"), (signal.SIGHUP, "terminal")],
    ids=lambda value: getattr(value, "name", value),
)
@pytest.mark.parametrize("command", WORKING)
def test_a_signal_ends_a_command_and_all_that_works_for_it(begun, command, number, where, group):
    """Exit codes as shells have them: 128 and the number of the signal."""
    work = begun(WORKING[command], where)
    hired = 4 if command in CREWS else 1  # itself, who watches what they share, and two workers
    until(lambda: len(members(work.process.pid)) >= hired and is_listening(work.process.pid), "its work")
    (os.killpg if group else os.kill)(work.process.pid, number)
    said = work.said()
    assert work.process.wait() == 128 + number, said
    assert "interrupted" in said and "Traceback" not in said
    until(lambda: not work.left(), "what works for it ends")


@pytest.mark.parametrize("command", sorted(CREWS))
def test_who_works_for_a_command_that_is_killed_ends_too(begun, command):
    work = begun(WORKING[command])
    until(lambda: len(members(work.process.pid)) == 4, "its workers")
    work.process.kill()
    work.said()
    until(lambda: not work.left(), "its workers end")


@pytest.mark.extra("OCP")
@pytest.mark.parametrize("later", [0.0, 0.5, 2.0])
def test_a_file_of_solids_that_is_interrupted_leaves_nothing(begun, folder, later):
    """Also while the kernel of solids is loading, which then tells of an error of its own."""
    work = begun(["export", "ec120b", "--to", "step"])
    until(lambda: "OCP" in mapped(work.process.pid), "its kernel")
    time.sleep(later)
    work.process.terminate()
    said = work.said()
    assert work.process.wait() == 143, said
    assert "Traceback" not in said
    assert not work.left() and not list(folder.glob("*.step"))


@pytest.mark.extra("starlette", "uvicorn", "tomlkit")
@pytest.mark.parametrize("hired", [1, 2, 3, 5])
@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 0), (signal.SIGTERM, 143)])
def test_the_workbench_ends_without_a_word_whenever_it_is_asked_to(begun, number, code, hired):
    """As it loads, as what answers loads, and when it serves; Ctrl-C is its usual end."""
    work = begun(["app", "in-line-h2", "--no-browser"], "terminal")
    until(lambda: len(members(work.process.pid)) >= hired and is_listening(work.process.pid), "its processes")
    os.killpg(work.process.pid, number)
    said = work.said()
    assert work.process.wait() == code or (hired == 1 and work.process.wait() == 128 + number), said
    assert "Traceback" not in said and "Error" not in said, said
    until(lambda: not work.left(), "what answers ends")


@pytest.mark.parametrize("loading", ["gearwright.cli", "gearwright.cli.commands"])
def test_ctrl_c_before_commands_are_loaded_ends_without_a_word(loading):
    """Pressed by the interpreter itself as it begins to load a module, so that no machine is too quick for it."""
    done = subprocess.run([sys.executable, "-c", PRESSED, loading], capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == -signal.SIGINT, done.stderr
    assert not done.stdout and not done.stderr


def catches(process, number):
    """Tell whether a process has an answer of its own to a signal."""
    try:
        lines = Path(f"/proc/{process}/status").read_text(encoding="utf-8").splitlines()
    except OSError:
        return False
    return bool(next(int(line.split()[1], 16) for line in lines if line.startswith("SigCgt")) >> (number - 1) & 1)


def is_listening(process):
    """Tell whether a command has begun, and ends in its own way."""
    return catches(process, signal.SIGHUP)


def mapped(process):
    """Return the files that a process has in its memory."""
    try:
        return Path(f"/proc/{process}/maps").read_text(encoding="utf-8")
    except OSError:
        return ""
