"""Processes of this machine that work for this one: how they begin, what they are asked, and that they end with it.

Ctrl-C and its like are left to the process that hired them, also while they start. Each has a line of its own: it ends
when nobody is left at the other end of it, when it is dismissed, and when the process that hired it dies, however it
does.
"""

import multiprocessing
import os
import pickle
import signal
import sys
import time
from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from multiprocessing.reduction import ForkingPickler
from pathlib import Path
from subprocess import DEVNULL, PIPE, CompletedProcess, Popen
from tempfile import gettempdir
from threading import Lock, Thread
from types import FrameType
from typing import Any, NamedTuple, NoReturn, TypeVar

from gearwright.errors import SolveError
from gearwright.signals import ENDING, heard_after

A = TypeVar("A")
B = TypeVar("B")
Work = Callable[..., None]
"""What a process does: a function that can be imported, whose first argument is its line."""
TRIES = 2
"""Times that a thing may kill the process that computes it: one may die by no fault of its own."""
GRACE = 1.0
"""In which a process puts away what it has begun, until it is killed [s]."""
COPIES = sys.platform == "linux"
"""Whether a process may be a copy of another one here: elsewhere libraries do not bear it."""
LONGEST_FOLDER = 70
"""Letters of the folder of temporary files from which on a socket in it, by which copies are asked for, has no name."""
_ONE_AT_A_TIME = Lock()
"""Threads share what processes inherit."""
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")


class Hired(NamedTuple):
    """A process that works for this one."""

    process: BaseProcess
    line: Connection
    """To it and from it."""


def hire(work: Work, *given: Any, needed: Sequence[str] = (), heirs: bool = False) -> Hired:
    """Start a process that has a line to this one, and no other.

    Args:
        work: What it does with its line, and with what is given.
        given: To be sent once, as it starts.
        needed: Modules that many such processes need: where the system can fork, they are loaded once for all of them.
        heirs: Whether it may hire others itself.
    """
    copied = bool(needed) and COPIES and len(os.fsencode(gettempdir())) <= LONGEST_FOLDER
    context: Any = multiprocessing.get_context("forkserver" if copied else "spawn")
    if copied:
        context.set_forkserver_preload(list(needed))
    here, there = context.Pipe()
    process = context.Process(target=_live, args=(there, bytes(ForkingPickler.dumps((work, given)))), daemon=not heirs)
    with _ONE_AT_A_TIME, heard_after(), _inherited():
        process.start()
    there.close()
    return Hired(process, here)


def dismiss(processes: Iterable[BaseProcess]) -> None:
    """End processes, whatever they do: what they have begun on the disk is put away where they still can.

    Args:
        processes: As they were hired.
    """
    listed = list(processes)
    for process in listed:
        process.terminate()
    until = time.monotonic() + GRACE
    for process in listed:
        process.join(max(0.0, until - time.monotonic()))
        if process.exitcode is None:
            process.kill()
            process.join()


def computed(function: Callable[[A], B], things: Sequence[A], workers: int) -> Iterator[tuple[A, B]]:
    """Yield each thing with what a function makes of it, as soon as it is there, in any order.

    What a process was at that died is computed again by another one, once.

    Args:
        function: That a process can be sent.
        things: To be computed.
        workers: Processes; 0 computes here.

    Raises:
        SolveError: If a process dies again of the same thing.
    """
    if workers == 0:
        yield from ((thing, function(thing)) for thing in things)
        return
    waiting, deaths = deque(range(len(things))), Counter[int]()
    at, crew = dict[Connection, tuple[BaseProcess, int]](), list[BaseProcess]()

    def give(line: Connection, process: BaseProcess) -> None:
        at[line] = process, waiting.popleft()
        with suppress(OSError):  # its death is seen at the next wait
            line.send(things[at[line][1]])

    def another() -> None:
        hired = hire(_answer, function)
        crew.append(hired.process)
        give(hired.line, hired.process)

    try:
        while waiting and len(crew) < workers:
            another()
        while at:
            for line in wait(list(at)):
                assert isinstance(line, Connection)
                process, number = at.pop(line)
                try:
                    found, error = line.recv()
                except (EOFError, OSError):  # OSError: it died within its answer
                    line.close()
                    process.join()
                    deaths[number] += 1
                    if deaths[number] == TRIES:
                        said = "workers died, perhaps for want of memory; fewer workers may do, and what is kept stays"
                        raise SolveError(f"{said} (exit code {process.exitcode})") from None
                    waiting.append(number)
                    another()
                    continue
                if error is not None:
                    raise error
                if waiting:
                    give(line, process)
                yield things[number], found
    finally:
        dismiss(crew)


def run_program(command: Sequence[str], *, seconds: float, folder: Path | None = None) -> CompletedProcess[str]:
    """Return what a program of this machine says and how it ends; it and what it starts end with this call.

    Args:
        command: The program, and its arguments.
        seconds: After which it is killed [s].
        folder: Where it runs; left out: where this process does.

    Raises:
        OSError: If it cannot be started.
        subprocess.TimeoutExpired: If it takes longer.
    """
    with Popen(
        command,
        cwd=folder,
        stdin=DEVNULL,
        stdout=PIPE,
        stderr=PIPE,
        text=True,
        errors="replace",
        start_new_session=True,
    ) as program:
        try:
            said, complained = program.communicate(timeout=seconds)
        except BaseException:
            with suppress(OSError):
                os.killpg(program.pid, signal.SIGKILL) if hasattr(os, "killpg") else program.kill()
            raise
    return CompletedProcess(command, program.returncode, said, complained)


def _answer(line: Connection, function: Callable[[A], B]) -> None:
    """Send what a function makes of each thing, or its error, until nobody asks any more."""
    with suppress(EOFError, OSError):
        while True:
            thing = line.recv()
            try:
                answer: tuple[Any, Exception | None] = function(thing), None
            except Exception as error:  # it is raised where the thing came from
                answer = None, error
            line.send(answer)


def _live(line: Connection, sent: bytes) -> None:
    """Work as long as the process that hired this one is there, which is watched before what it needs is loaded."""
    signal.signal(signal.SIGTERM, lambda number, _: os._exit(128 + number))  # nothing is begun, and libraries load
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
    Thread(target=_outlive_nobody, daemon=True).start()
    work, given = pickle.loads(sent)
    signal.signal(signal.SIGTERM, _leave)
    work(line, *given)


def _leave(number: int, _: FrameType | None) -> NoReturn:
    """Put away what was begun, and end."""
    signal.signal(number, signal.SIG_IGN)  # once is enough
    raise SystemExit(128 + number)


def _outlive_nobody() -> None:
    """End with the process that hired this one, even if that was killed."""
    employer = multiprocessing.parent_process()
    if employer is not None:
        employer.join()
        os.kill(os.getpid(), signal.SIGTERM)
        time.sleep(GRACE)
        os._exit(1)


@contextmanager
def _inherited() -> Iterator[None]:
    """Let new processes compute on one thread each, as they share the cores, and leave what ends a group to this one.

    A terminal sends Ctrl-C to the whole group, as others do SIGTERM, also to those that only start.
    """
    before = {name: os.environ.get(name) for name in _THREADS}
    os.environ.update(dict.fromkeys(_THREADS, "1"))
    masked = hasattr(signal, "pthread_sigmask")
    if masked:
        resource_tracker.ensure_running()  # the first process starts it otherwise, and it takes the mask away
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING) if masked else set()
    try:
        yield
    finally:
        if masked:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
