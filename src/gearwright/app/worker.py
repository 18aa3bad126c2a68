"""A process that answers questions: nothing that is computed holds up the page, and anything can be stopped."""

from __future__ import annotations

import signal
from contextlib import suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from threading import Lock

from gearwright.app.verbs import Answer, Question, answered

MEMORY = 16 * 2**30
"""Address space that a worker may take, where the system can hold it to that [bytes]."""


class Stopped(Exception):
    """The process that was asked is no longer there."""


class Worker:
    """One process; it is started when it is first needed, and again after it was stopped."""

    def __init__(self) -> None:
        self._process: BaseProcess | None = None
        self._line: Connection | None = None
        self._lock = Lock()

    def start(self) -> Connection:
        """Return the line to a process that runs."""
        with self._lock:
            if self._process is None or self._line is None or not self._process.is_alive():
                context = get_context("spawn")
                self._line, theirs = context.Pipe()
                self._process = context.Process(target=_work, args=(theirs,), daemon=True)
                self._process.start()
                theirs.close()
            return self._line

    def ask(self, question: Question, seconds: float) -> Answer:
        """Return the answer to a question.

        Args:
            question: Of a page.
            seconds: After which the process is stopped [s].

        Raises:
            Stopped: If it was stopped meanwhile, or had no answer in time.
        """
        line = self.start()
        try:
            line.send(question)
            if line.poll(seconds):
                answer: Answer = line.recv()
                return answer
        except (EOFError, OSError):
            raise Stopped("this computation was stopped") from None
        self.stop()
        raise Stopped(f"this takes longer than {seconds:.0f} s and was stopped; the command line has no such limit")

    def stop(self) -> None:
        """End the process, whatever it does."""
        with self._lock:
            process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.join()


def _work(line: Connection) -> None:
    """Answer until nobody asks any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _hold_memory()
    with suppress(EOFError, OSError):
        while True:
            line.send(_safely(line.recv()))


def _safely(question: Question) -> Answer:
    """Return the answer; an error of gearwright's own is told as one, and the process lives on."""
    try:
        return answered(question)
    except Exception as error:  # what no rule foresaw must not end the workbench
        sentence = f'{{"error": "gearwright failed here ({type(error).__name__}); this is a fault of its own"}}'
        return Answer(sentence.encode(), status=500)


def _hold_memory() -> None:
    with suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
