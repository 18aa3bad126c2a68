"""A parent that has everything imported, and forks for every command: what a fresh interpreter does, without its start.

The parent is one process with one thread. A child gets its own terminal or files, folder and environment, makes its
standard streams as an interpreter makes them, runs `gearwright.cli.main`, and ends as an interpreter ends: what is left
in the buffers is written, and what cannot be written is complained of. One request and one answer a line, as JSON.
Children compute what none has computed before (`remembering`), in the folder that the parent is given.
"""

from __future__ import annotations

import builtins
import fcntl
import io
import json
import os
import pty
import select
import signal
import struct
import sys
import termios
import time
import traceback
from pathlib import Path
from typing import Any

from remembering import remember

PATIENCE = 120.0
"""Time after which a command hangs [s]."""


def serve() -> None:
    """Answer requests until the input ends."""
    preload()
    remember(Path(sys.argv[1]))
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    for line in sys.stdin:
        answers.write(json.dumps(answer(json.loads(line))) + "\n")
        answers.flush()


def preload() -> None:
    """Import what commands import, and read one file of each kind: the first makes the validators of its records."""
    import importlib
    import pkgutil

    import gearwright

    for module in pkgutil.walk_packages(gearwright.__path__, "gearwright."):
        try:
            importlib.import_module(module.name)
        except ModuleNotFoundError as missing:  # of an extra that is not here
            if str(missing.name).startswith("gearwright"):
                raise
    gearwright.read("in-line-h2")
    gearwright.read_mission("thesis")
    gearwright.read_study(gearwright.shipped_studies()[0])


def answer(asked: dict[str, Any]) -> dict[str, Any]:
    """Run one command; return its exit code and what it printed."""
    return on_terminal(asked) if asked["columns"] else on_files(asked)


def on_terminal(asked: dict[str, Any]) -> dict[str, Any]:
    """Run a command under a pseudo-terminal of a size; a line feed comes back as it was written."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 40, asked["columns"], 0, 0))
    attributes = termios.tcgetattr(slave)
    attributes[1] &= ~termios.OPOST
    termios.tcsetattr(slave, termios.TCSANOW, attributes)
    child = os.fork()
    if child == 0:
        os.close(master)
        os.setsid()
        fcntl.ioctl(slave, termios.TIOCSCTTY, 0)
        run(asked, (slave, slave, slave))
    os.close(slave)
    written = read(master, child)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    os.close(master)
    return {"code": code, "out": written, "err": ""}


def on_files(asked: dict[str, Any]) -> dict[str, Any]:
    """Run a command with pipes, or with its output into a file of that name; a closed pipe has no reader."""
    source = os.open(os.devnull, os.O_RDONLY)
    errors, error_end = os.pipe()
    reading, output = os.pipe()
    if asked["output"] == "closed":
        os.close(reading)
    elif asked["output"]:
        os.close(output)
        output = os.open(asked["output"], os.O_WRONLY)
    child = os.fork()
    if child == 0:
        run(asked, (source, output, error_end))
    for end in (source, output, error_end):
        os.close(end)
    kept: dict[int, bytes] = {errors: b""} if asked["output"] == "closed" else {errors: b"", reading: b""}
    drain(kept, child)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return {"code": code, "out": text(kept.get(reading, b"")), "err": text(kept[errors])}


def read(master: int, child: int) -> str:
    """Return everything that comes from a terminal until its last user has gone."""
    kept = {master: b""}
    drain(kept, child)
    return text(kept[master])


def drain(kept: dict[int, bytes], child: int) -> None:
    """Read all ends until each is closed; kill a child that hangs."""
    ends, until = set(kept), time.monotonic() + PATIENCE
    while ends:
        ready = select.select(ends, [], [], max(0.0, until - time.monotonic()))[0]
        if not ready:
            os.kill(child, signal.SIGKILL)
            return
        for end in ready:
            try:
                piece = os.read(end, 65536)
            except OSError:  # a terminal without a user
                piece = b""
            kept[end] += piece
            if not piece:
                ends.discard(end)


def text(written: bytes) -> str:
    """Return bytes as text that JSON takes; what is no UTF-8 stays visible."""
    return written.decode("utf-8", errors="backslashreplace")


def run(asked: dict[str, Any], streams: tuple[int, int, int]) -> None:
    """Be the interpreter of one command; never returns."""
    code = 70
    try:
        for number, stream in enumerate(streams):
            os.dup2(stream, number)
        os.closerange(3, 256)
        os.chdir(asked["folder"])
        for name in ("COLUMNS", "LINES", "NO_COLOR", "FORCE_COLOR", "PYTHONIOENCODING"):
            os.environ.pop(name, None)
        os.environ.update({"TERM": "xterm-256color", **asked["environment"]})
        sys.stdin, sys.stdout, sys.stderr = made(0, "r"), made(1, "w"), made(2, "w")
        sys.__stdout__, sys.__stderr__ = sys.stdout, sys.stderr
        sys.argv = ["gearwright", *asked["words"]]
        signal.signal(signal.SIGINT, signal.default_int_handler)
        code = ended(asked["interrupt"])
    finally:
        os._exit(code)


def made(number: int, mode: str) -> io.TextIOWrapper:
    """Return a standard stream as an interpreter makes it in this environment."""
    encoding = os.environ.get("PYTHONIOENCODING", "utf-8")
    terminal = os.isatty(number)
    raw = os.fdopen(number, f"{mode}b", buffering=-1, closefd=False)
    errors = "backslashreplace" if number == 2 else "strict"
    return io.TextIOWrapper(raw, encoding=encoding, errors=errors, line_buffering=terminal or number == 2)


def ended(interrupt: int) -> int:
    """Return the exit code that an interpreter would end with."""
    from gearwright.cli import main

    try:
        if interrupt:
            interrupt_at(interrupt)
        main()
        code = 0
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:
        traceback.print_exc()
        code = 1
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError as error:
            os.write(2, f"Exception ignored in: {stream}\nTraceback: {error}\n".encode())
            code = 120
    return code


def interrupt_at(number: int) -> None:
    """Press Ctrl-C when a command's own code comes to its import of this number: it has begun, and has not ended."""
    imported, count = builtins.__import__, [0]

    def watched(name: str, globals: Any = None, *rest: Any, **names: Any) -> Any:
        if str((globals or {}).get("__name__", "")).startswith("gearwright.cli.") and name.startswith("gearwright"):
            count[0] += 1
            if count[0] == number:
                os.kill(os.getpid(), signal.SIGINT)
        return imported(name, globals, *rest, **names)

    builtins.__import__ = watched


if __name__ == "__main__":
    serve()
